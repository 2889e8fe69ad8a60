//! What several tests share: the banks of the project, and the program run.
pub mod program;
pub mod xml;

use slipstick::bank::{Bank, load};

/// Every bank in `banks/` (beside them lie the words of wrong methods), loaded, in the order of the names.
pub fn banks() -> Vec<Bank> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/banks");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("banks").map(|f| f.expect("a file").path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "yaml") && !f.ends_with("misconceptions.yaml"));
    files.sort();
    files
        .iter()
        .map(|file| {
            let text = std::fs::read_to_string(file).expect("a bank is text");
            match load::scenes_only(&text, &file.display().to_string()) {
                Ok(bank) => bank,
                Err(findings) => {
                    panic!("{}", findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
                }
            }
        })
        .collect()
}

/// The names of the banks that the program brings along.
#[allow(dead_code, reason = "each test file takes what it needs")]
pub fn bank_names() -> impl Iterator<Item = &'static str> {
    slipstick::bank::built_in::BUILT_IN.iter().map(|(id, ..)| *id)
}

/// The banks in a language: their texts are those of `templates/LANGUAGE/banks/`, where there are any.
#[allow(dead_code, reason = "each test file takes what it needs")]
pub fn banks_in(language: &str) -> Vec<Bank> {
    let mut banks = banks();
    for bank in &mut banks {
        let name = format!("{}/templates/{language}/banks/{}.yaml", env!("CARGO_MANIFEST_DIR"), bank.id);
        if let Ok(text) = std::fs::read_to_string(&name) {
            let variables = &slipstick::template::variables_of;
            slipstick::bank::overlay::put_over(bank, &text, &name, variables, None).expect(&name);
        }
    }
    banks
}

/// The templates of a language, with those that stand in the bank.
#[allow(dead_code, reason = "each test file takes what it needs")]
pub fn templates(language: &str, bank: &Bank) -> slipstick::template::Templates {
    let mut templates = slipstick::template::Templates::new(language, &[]).expect("built-in templates");
    slipstick::sheet::statement::add_own(&mut templates, bank).expect("statements of the bank");
    templates
}

/// How many draws a sweep makes: `SLIPSTICK_SEEDS`, 100 where it is not set, never more than `full`.
#[allow(dead_code, reason = "each program of tests takes what it needs")]
pub fn seeds(full: u32) -> u32 {
    let asked = std::env::var("SLIPSTICK_SEEDS").ok();
    asked.map_or(100, |n| n.parse().expect("SLIPSTICK_SEEDS is a whole number")).min(full)
}
