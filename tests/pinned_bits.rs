//! The same seed gives the same bits in every build and on every machine: drawn data and all answers of both roads.
//!
//! If a line must change, raise the draw version (draws) or say in the README what moved (answers).
mod support;
use sha2::Digest;
use slipstick::problem::make::Maker;

/// Problem, digest of the drawn data, digest of the answers.
const PINNED: &[(&str, &str, &str)] = &[
    ("block-pulls-wheel", "00c461e495755cd1", "4e9d4a3efccf01e7"),
    ("yo-yo", "aef24fe3ffb2f4bd", "83e50d0690d1d95b"),
    ("two-loads-on-a-stepped-drum", "10696379207f77a1", "ea2be54052a9236a"),
    ("kinetic-energy", "ab248f879edce178", "a81cc9f40f38cde3"),
    ("pulled-rolling", "ea4a9e0129f11de6", "2c62b468e3e75871"),
    ("pulled-slipping", "a42f2cc47d1aedb0", "f012c75a4d971796"),
    ("spring-released", "77fa04a1955e4c36", "4a385274acbdb649"),
];

#[test]
fn draws_and_answers_are_pinned_to_the_bit() {
    let mut seen = Vec::new();
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 7, "pinned");
            let (mut data, mut answers) = (sha2::Sha256::new(), sha2::Sha256::new());
            for student in 0..200 {
                let variant =
                    maker.variant(&format!("s{student}")).expect("a bank of the project can be satisfied");
                for x in &variant.data {
                    data.update(x.to_bits().to_le_bytes());
                }
                for e in &variant.solved.entries {
                    answers.update(problem.cases[variant.case].scene.name_of(e.label));
                    for x in [e.eom, e.energy].into_iter().flatten() {
                        answers.update(x.to_bits().to_le_bytes());
                    }
                }
            }
            let hex =
                |d: sha2::Sha256| d.finalize().iter().take(8).map(|b| format!("{b:02x}")).collect::<String>();
            seen.push((problem.id.clone(), hex(data), hex(answers)));
        }
    }
    let lines: Vec<String> =
        seen.iter().map(|(p, d, a)| format!("    (\"{p}\", \"{d}\", \"{a}\"),")).collect();
    let pinned: Vec<String> =
        PINNED.iter().map(|(p, d, a)| format!("    (\"{p}\", \"{d}\", \"{a}\"),")).collect();
    assert_eq!(lines, pinned, "\n{}\n", lines.join("\n"));
}
