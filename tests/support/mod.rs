//! What several tests share: the banks of the project.
use slipstick::bank::Bank;
use slipstick::bank::load;

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
