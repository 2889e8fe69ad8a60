//! The same seed gives the same bits in every build and on every machine: drawn data and all answers of both roads.
//!
//! If a line must change, raise the draw version (draws) or say in the README what moved (answers).
mod support;
use sha2::Digest;
use slipstick::problem::make::Maker;

/// Problem, digest of the drawn data, digest of the answers.
const PINNED: &[(&str, &str, &str)] = &[
    ("block-pulls-wheel", "174926a8dda39bf3", "4e94d2cc59f7a53f"),
    ("yo-yo", "48ffb49e9cc27e56", "cbe01e7672033d36"),
    ("two-loads-on-a-stepped-drum", "e56a4c810b664baa", "2f5c2a618e69e5de"),
    ("falling-rod", "8e8007792a987779", "a30ef288926c1b9c"),
    ("compound-pendulum", "cf0f2da7965fee7b", "225d1b8435f7954f"),
    ("lifted-rod", "a2d91ba6b66ba680", "90ac589f98f276fc"),
    ("rod-and-spring", "79681241d0ce1f0f", "c54454a365a5cf77"),
    ("thrown-ball", "3015d95e48e1eaab", "84e0113a1e465eed"),
    ("wheel-set-down", "3897c747dae7d128", "d91d3d287cf1348a"),
    ("kinetic-energy", "1d494307821fa641", "adb9870667890556"),
    ("pulled-rolling", "b913f974f9f719ed", "0046635d4ba0c558"),
    ("pulled-slipping", "c4363eb39c77f46b", "6e680e1d997aa732"),
    ("spring-released", "0c12659539776b14", "a2cdf19fd232eb72"),
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
