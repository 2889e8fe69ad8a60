//! The same seed gives the same bits in every build and on every machine: drawn data and all answers of both roads.
//!
//! If a line must change, raise the draw version (draws) or say in the README what moved (answers).
use crate::support;
use sha2::Digest;
use slipstick::problem::maker::Maker;
use slipstick::scene::{Quantity, Scene};
use slipstick::solve::agree;
use std::collections::BTreeSet;

/// Quantities that came when the others were pinned already: they have a digest of their own.
const LATER: &[Quantity] = &[
    Quantity::Distance,
    Quantity::WorkCouple,
    Quantity::PowerCouple,
    Quantity::Work,
    Quantity::Impulse,
    Quantity::AngularMomentum,
    Quantity::PinX,
    Quantity::PinY,
    Quantity::PinAngle,
    Quantity::Angle,
];

/// The force of a fixed axle came last, and the direction of that of a joint; they are judged by tests/physics/axles.rs and
/// tests/physics/joined_scenes.rs.
fn came_last(scene: &Scene, quantity: Quantity) -> bool {
    let pin = matches!(quantity, Quantity::PinX | Quantity::PinY | Quantity::PinForce | Quantity::PinAngle);
    pin && scene.pinned().is_none() && (scene.lead().is_none() || quantity == Quantity::PinAngle)
}

/// Is it one of them? Small oscillations of bodies on lines came after those of pinned bodies, the power of a pull at once after that at
/// the end.
fn came_later(scene: &Scene, quantity: Quantity) -> bool {
    let oscillation = matches!(quantity, Quantity::PeriodSmall | Quantity::OmegaSmall);
    let at_once = scene.is_still() && quantity == Quantity::PowerPull;
    LATER.contains(&quantity)
        || at_once
        || oscillation && scene.pinned().is_none()
        || came_last(scene, quantity)
}

/// Problem, digest of the drawn data, digest of the answers, of those of later quantities.
const PINNED: &[(&str, &str, &str, &str)] = &[
    ("block-pulls-wheel", "ad1ce7cfef62bbc8", "4da8ca4bbf47c151", "1dd77f68fc446040"),
    ("yo-yo", "f77ba8a7923a22f1", "711a6d60ec74464a", "da78ecfcf0934444"),
    ("two-loads-on-a-stepped-drum", "77708f5668c361b0", "a5f67534972c79db", "136bbdd805608b64"),
    ("rolling-hoop", "0e346351f1003b91", "c3a670ada2d1bea0", "83eef3814fe0cda3"),
    ("spool-on-the-floor", "f78df4d6b4b8302e", "3e7b2eb1c35f1ac8", "c42f6d27041de040"),
    ("mass-of-a-stone", "e77389bed7e06d93", "eb409120b49b6cdb", "45d121029babd83b"),
    ("flywheel-of-parts", "50f896ce40f3a1ce", "8cff6ae4f43cf53f", "1041445b1c639019"),
    ("backspin", "14459a9521e8bc5c", "33a8746c8603fae1", "a5d4acaa38e09bbc"),
    ("inertia-about-the-pin", "2a4fecc2e134e7e3", "9c2eb4e1b66cf609", "a218253fb1f65592"),
    ("belt-drive", "2eeef3d5e777f3f3", "af8a7006ec8e76ca", "9dc035ed924c50fb"),
    ("falling-rod", "085123690901cbee", "5fb9c6efcea2b9b9", "1e9c45393daf55b6"),
    ("compound-pendulum", "c17564cfef8ebd5a", "1fe8790e449053f4", "ed38f0bcc6d6a5fa"),
    ("lifted-rod", "efa876bf286d2b6c", "b94bef31c6a95479", "80a8e8b5f0d2ba1a"),
    ("rod-and-spring", "9589c05578d271dc", "f5b6f17028f82786", "2cb504eb0cacf19c"),
    ("sliding-ladder", "f2e49d74df14783a", "f9841652a2205858", "c10d6c92a0a39c15"),
    ("rod-on-smooth-floor", "5dad0cefeaa30310", "38a4054d1b08dcb1", "eb0accd525bd1a85"),
    ("guided-rod-and-spring", "a5e228ca743fc4d3", "1333fdb69349bdc0", "97e0132c699e5f51"),
    ("trammel", "c72ff3e7b672f77e", "52a032d2e322d12c", "e65c24a8bc012883"),
    ("slider-crank", "d4fd40d09e85a2f2", "a6602800640a5893", "1613d1934f7f23d1"),
    ("cut-cord", "3d803d4d4a568dae", "44331acf326b1c9b", "e6e86560f1fb6bfb"),
    ("four-bar-linkage", "9f0af24b0ed7875a", "360dd0d1d75d303b", "ccec54db904399c8"),
    ("rough-ladder", "d18fd9a97c8c6bec", "2b647fbaeb1f558c", "1a41d58a66dc7b55"),
    ("off-a-cylinder", "6ff90d0a4163ef6e", "c0f4a13ad9df1e0d", "cfd221663a026d7e"),
    ("gear-on-a-rack", "aacbf37f43b837c1", "5471fc0f4655934e", "462e6e0a0bebde79"),
    ("thrown-ball", "26af46574cdccf6f", "975bd4fde3adfacb", "fb6461d9fa7bca76"),
    ("wheel-set-down", "9d1d0943968ef4a9", "acdb173a35a72676", "70b39b1e3959782e"),
    ("kinetic-energy", "b3b64a99a2d5aaae", "5675fde5d235c27d", "e3b0c44298fc1c14"),
    ("pulled-rolling", "f8f5d8eb64da0778", "ec869cd7494f0f75", "302283d47e8b7f1e"),
    ("pulled-slipping", "05a2ddf4c8f2c3c4", "e1a5f24dc134e3dd", "f2b413577a131733"),
    ("spring-released", "84ef3c41f2691831", "ad964ce64ca6458a", "5c9d2eb062afcf6c"),
];

#[test]
fn draws_and_answers_are_pinned_to_the_bit() {
    let mut seen = Vec::new();
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 7, "pinned");
            let (mut data, mut answers, mut later) =
                (sha2::Sha256::new(), sha2::Sha256::new(), sha2::Sha256::new());
            for student in 0..200 {
                let variant =
                    maker.variant(&format!("s{student}")).expect("a bank of the project can be satisfied");
                for x in &variant.data {
                    data.update(x.to_bits().to_le_bytes());
                }
                let scene = &problem.cases[variant.case].scene;
                // A draw of joined bodies is solved without the time if nobody asks for it: all else is the same to the bit.
                if student < 5 && scene.lead().is_some() {
                    let whole = agree::solve(scene, &variant.data).expect("a draw that was solved");
                    for e in &variant.solved.entries {
                        let same = whole.get(e.label).expect("the same answers");
                        assert_eq!(
                            (e.eom, e.energy),
                            (same.eom, same.energy),
                            "{}: {:?}",
                            problem.id,
                            e.label
                        );
                    }
                }
                let mut entries: Vec<_> = variant.solved.entries.iter().collect();
                entries.sort_by_key(|e| e.label);
                for e in entries {
                    let late = came_later(scene, e.label.quantity);
                    let digest = if late { &mut later } else { &mut answers };
                    digest.update(scene.name_of(e.label));
                    for x in [e.eom, e.energy].into_iter().flatten() {
                        digest.update(x.to_bits().to_le_bytes());
                    }
                }
            }
            let hex =
                |d: sha2::Sha256| d.finalize().iter().take(8).map(|b| format!("{b:02x}")).collect::<String>();
            seen.push((problem.id.clone(), hex(data), hex(answers), hex(later)));
        }
    }
    let lines: Vec<String> =
        seen.iter().map(|(p, d, a, l)| format!("    (\"{p}\", \"{d}\", \"{a}\", \"{l}\"),")).collect();
    let pinned: Vec<String> =
        PINNED.iter().map(|(p, d, a, l)| format!("    (\"{p}\", \"{d}\", \"{a}\", \"{l}\"),")).collect();
    assert_eq!(lines, pinned, "\n{}\n", lines.join("\n"));
}

/// Condition numbers of 10 draws of each problem, as derivatives carried along with each number gave them; those of draws that draw
/// version 5 changed are what differences gave.
#[test]
fn condition_numbers_are_pinned_to_six_digits() {
    let pinned = include_str!("../reference/conditions.csv");
    let mut unseen: BTreeSet<&str> = pinned.lines().skip(1).collect();
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 7, "pinned");
            for student in 0..10 {
                let variant =
                    maker.variant(&format!("s{student}")).expect("a bank of the project can be satisfied");
                let scene = &problem.cases[variant.case].scene;
                let solved = agree::solve(scene, &variant.data).expect("it was drawn");
                for e in &solved.entries {
                    let name = scene.name_of(e.label);
                    let row = format!("{},s{student},{name},", problem.id);
                    let line = pinned.lines().find(|line| line.starts_with(&row));
                    let want = line.and_then(|line| unseen.take(line)).map(|line| &line[row.len()..]);
                    if want.is_none() && came_later(scene, e.label.quantity) {
                        continue;
                    }
                    let want: f64 =
                        want.unwrap_or_else(|| panic!("{row} is not pinned")).parse().expect("a number");
                    let off = (e.cond - want).abs() / want.max(1.0);
                    assert!(off <= 1e-6, "{row} {:e} for {want:e}", e.cond);
                }
            }
        }
    }
    assert_eq!(unseen, BTreeSet::new());
}
