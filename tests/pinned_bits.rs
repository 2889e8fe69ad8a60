//! The same seed gives the same bits in every build and on every machine: drawn data and all answers of both roads.
//!
//! If a line must change, raise the draw version (draws) or say in the README what moved (answers).
mod support;
use sha2::Digest;
use slipstick::problem::make::Maker;

/// Problem, digest of the drawn data, digest of the answers.
const PINNED: &[(&str, &str, &str)] = &[
    ("block-pulls-wheel", "7e58b4397711b559", "d05e97392c9b51d9"),
    ("yo-yo", "56eaf5ebeedbf2da", "4e03daaf4bc155c1"),
    ("two-loads-on-a-stepped-drum", "0283c4c499963a66", "64fcbbe4228981e2"),
    ("thrown-ball", "6dde4a9eca0ede00", "1b533495873e1bd6"),
    ("wheel-set-down", "f98c0d80feebe576", "a896b624324f1d8b"),
    ("kinetic-energy", "cbdbe0b3edb9f945", "af236551037265b5"),
    ("pulled-rolling", "81011d0ece5ccf20", "92c7545adb7a7451"),
    ("pulled-slipping", "e8283eb54c86667c", "e2882ef6abc178e6"),
    ("spring-released", "12fdcd118ca0e1b1", "24f5e72c7aa3d1c7"),
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
                let mut entries: Vec<_> = variant.solved.entries.iter().collect();
                entries.sort_by_key(|e| e.label);
                for e in entries {
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
