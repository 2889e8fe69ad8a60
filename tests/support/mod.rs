//! What several tests share: the banks of the project, and the program run.
pub mod program;
pub mod xml;

use slipstick::bank::decimal::Decimal;
use slipstick::bank::{Bank, Draw, Problem, load};
use slipstick::problem::maker::Maker;
use slipstick::solve::ladder;

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

/// How many times as dear as a closed form a problem is to solve, about: by the evaluations that its integrals take, so that a
/// sweep gives each family much the same time.
#[allow(dead_code, reason = "each program of tests takes what it needs")]
pub fn dear(problem: &Problem) -> u32 {
    let drawn = Maker::new(problem, 0, "cost").variant("0").expect("a bank of the project can be satisfied");
    let taken = ladder::solve(&problem.cases[drawn.case].scene, &drawn.data, &ladder::Wish::default());
    let evaluations = taken.map_or(1, |(_, taken)| taken.count.evaluations);
    u32::try_from(evaluations / 10).unwrap_or(u32::MAX).max(1)
}

/// The data of a problem that are always the same, as printed; `None` of one that is drawn or unknown.
#[allow(dead_code, reason = "each program of tests takes what it needs")]
pub fn constants(problem: &Problem) -> Vec<Option<Decimal>> {
    let constant = |draw: &Option<Draw>| match draw {
        Some(Draw::Always { value, decimals }) => Some(Decimal { value: *value, decimals: *decimals }),
        _ => None,
    };
    problem.cases[0].draws.iter().map(constant).collect()
}

/// The numbers of a problem all of whose data are always the same.
#[allow(dead_code, reason = "each program of tests takes what it needs")]
pub fn data(problem: &Problem) -> Vec<f64> {
    let numbers = problem.data.iter().zip(constants(problem));
    numbers.map(|(datum, value)| datum.number(value.expect("every datum is always the same"))).collect()
}

/// How many draws a sweep makes: `SLIPSTICK_SEEDS`, 100 where it is not set, never more than `full`.
#[allow(dead_code, reason = "each program of tests takes what it needs")]
pub fn seeds(full: u32) -> u32 {
    let asked = std::env::var("SLIPSTICK_SEEDS").ok();
    asked.map_or(100, |n| n.parse().expect("SLIPSTICK_SEEDS is a whole number")).min(full)
}

/// Are there so few draws that a browser, which takes its time, opens the sheets of each bank in one of the two languages?
#[allow(dead_code, reason = "each program of tests takes what it needs")]
pub fn is_quick() -> bool {
    seeds(1000) < 1000
}
