//! Words of direction: which of them give a quantity its sign is told by what happens in the scene, not by how it is computed.
use crate::grading_table::run_with;
use crate::support;
use slipstick::answer::read::UnitCache;
use slipstick::bank::load;
use slipstick::grade::compare::{compare, compare_with};
use slipstick::grade::feedback::Feedback;
use slipstick::grade::run::Options;
use slipstick::grade::table::KeyTable;
use slipstick::grade::verdict::{Judgement, Verdict};
use slipstick::key::{Answer, KeyEntry, ProblemKey, SheetKey};
use slipstick::problem::maker::Maker;
use slipstick::sheet::statement::sense_words;
use slipstick::words::Words;

/// The key of a scene of which these questions are asked: `a: m/s^2`, or `wall: {quantity: floor.friction, unit: N}`.
fn key(scene: &str, questions: &str) -> ProblemKey {
    let asked = questions.split("; ").map(|q| {
        let (id, unit) = q.split_once(": ").unwrap();
        match id.split_once('.') {
            Some(_) => format!("{}: {{quantity: {id}, ask: x, unit: {unit}}}", id.replace('.', "_")),
            None => format!("{id}: {{ask: x, unit: {unit}}}"),
        }
    });
    let asked: Vec<String> = asked.collect();
    let text = format!(
        "bank: b\ntitle: B\ncond limit: 1000\nproblems:\n  p:\n    title: P\n    data: {{m: {{name: mass, unit: kg, draw: always 3}}}}\n    scene:{scene}\n    questions: {{{}}}\n    statement: x\n",
        asked.join(", ")
    );
    let bank = load::scenes_only(&text, "test").unwrap_or_else(|f| panic!("{f:#?}\n{text}"));
    let maker = Maker::new(&bank.problems[0], 1, "directions");
    let variant = maker.variant("s").unwrap_or_else(|e| panic!("{e:?}\n{text}"));
    maker.key(&variant)
}

/// The size of a key in its unit, with a word behind it.
fn sized(entry: &KeyEntry, word: &str) -> String {
    let Answer::Number { value, .. } = entry.answer else { panic!("{} is a word", entry.part) };
    format!("{:.5} {} {word}", entry.unit.from_si(value.abs()), entry.unit.ascii())
}

fn judged(entry: &KeyEntry, cell: &str, language: &str) -> Judgement<'static> {
    compare_with(cell, entry, &mut UnitCache::default(), &Feedback::new(Words::built_in(language).unwrap()))
}

const DOWN: &[&str] = &["down", "downwards", "below", "nach unten", "abwärts", "unterhalb"];
const UP: &[&str] = &["up", "upward", "above", "nach oben", "hinauf", "oberhalb"];
const FORWARD: &[&str] = &["forward", "vorwärts", "nach vorn"];
const BACK: &[&str] = &["back", "backward", "rückwärts", "zurück"];
const RIGHT: &[&str] = &["right", "to the right", "rechts", "nach rechts"];
const LEFT: &[&str] = &["left", "to the left", "links", "nach links"];
const CLOCKWISE: &[&str] = &["cw", "clockwise", "(cw)", "im Uhrzeigersinn", ", CW"];
const COUNTER: &[&str] = &[
    "ccw",
    "counter-clockwise",
    "counter clockwise",
    "counterclockwise",
    "anticlockwise",
    "gegen den Uhrzeigersinn",
    "im Gegenuhrzeigersinn",
    "entgegen dem Uhrzeigersinn",
];
const PAIRS: [[&[&str]; 2]; 4] = [[UP, DOWN], [FORWARD, BACK], [RIGHT, LEFT], [CLOCKWISE, COUNTER]];

type WordList = &'static [&'static str];
/// A quantity with its words.
type Worded = (&'static str, &'static [WordList]);

/// Scene, questions, and of each part the words that are right. Their opposites are the wrong direction, all others do not fit.
const SCENES: [(&str, &str, &[Worded]); 7] = [
    // Let go at 35 degrees above the right, it falls to the right and down.
    (
        "
      bodies: {B: {mass: m, shape: {rod: 1 m}, moves: in the plane, angle: from right}}
      joints: {O: {pins: B.A}}
      start: {B: {angle: 35 deg}}
      end: at once",
        "alpha: rad/s^2; a_x: m/s^2; a_y: m/s^2; O.pin_x: N; O.pin_y: N",
        &[
            ("alpha", &[CLOCKWISE]),
            ("a_x", &[RIGHT]),
            ("a_y", &[DOWN]),
            ("O_pin_x", &[RIGHT]),
            ("O_pin_y", &[UP]),
        ],
    ),
    // The same, its angle counted the other way.
    (
        "
      bodies: {B: {mass: m, shape: {rod: 1 m}, moves: in the plane, angle: from up clockwise}}
      joints: {O: {pins: B.A}}
      start: {B: {angle: 55 deg}}
      end: at once",
        "alpha: rad/s^2; a_x: m/s^2",
        &[("alpha", &[CLOCKWISE]), ("a_x", &[RIGHT])],
    ),
    // A pinned rod that leans to the right: it falls on, and is pushed to the right.
    (
        "
      bodies: {B: {mass: m, shape: {rod: 1 m}, pinned: at its end, angle: from upright}}
      start: {B: {angle: 30 deg}}
      end: at once",
        "alpha: rad/s^2; pin_x: N; pin_y: N; pin_radial: N",
        &[("alpha", &[CLOCKWISE]), ("pin_x", &[RIGHT]), ("pin_y", &[UP]), ("pin_radial", &[])],
    ),
    // A pendulum drawn aside to the right falls back to the left and down.
    (
        "
      bodies: {B: {mass: m, shape: {rod: 1 m}, pinned: at its end, angle: from hanging}}
      start: {B: {angle: 30 deg}}
      end: {angle: {of: B, reaches: 10 deg}}",
        "alpha: rad/s^2; rise: m",
        &[("alpha", &[CLOCKWISE]), ("rise", &[DOWN])],
    ),
    // A disc rolls down an incline that rises to the right, positive down: it turns counter-clockwise, friction holds it back.
    (
        "
      surfaces: {incline: {slope: 30 deg}}
      bodies: {B: {mass: m, shape: {disc: 0.3 m}, moves: along incline, positive: down}}
      ties: [rolls: {body: B, on its: rim, mu_s: 0.9}]
      start: at rest
      end: {travel: {of: B, by: 12 m}}",
        "a: m/s^2; displacement: m; friction: N; alpha: rad/s^2; rise: m; impulse: N*s",
        &[
            ("a", &[DOWN, FORWARD]),
            ("displacement", &[DOWN, FORWARD]),
            ("friction", &[UP, BACK]),
            ("alpha", &[COUNTER]),
            ("rise", &[DOWN]),
            ("impulse", &[DOWN, FORWARD]),
        ],
    ),
    // The same positive up.
    (
        "
      surfaces: {incline: {slope: 30 deg}}
      bodies: {B: {mass: m, shape: {disc: 0.3 m}, moves: along incline}}
      ties: [rolls: {body: B, on its: rim, mu_s: 0.9}]
      start: at rest
      end: {travel: {of: B, by: 12 m}}",
        "a: m/s^2; displacement: m; friction: N; alpha: rad/s^2",
        &[
            ("a", &[DOWN, BACK]),
            ("displacement", &[DOWN, BACK]),
            ("friction", &[UP, FORWARD]),
            ("alpha", &[COUNTER]),
        ],
    ),
    // A wheel drawn along a floor by its centre: friction makes it roll.
    (
        "
      surfaces: {floor: level}
      bodies: {B: {mass: m, shape: {disc: 0.3 m}, moves: along floor}}
      ties:
        - rolls: {body: B, on its: rim, mu_s: 0.9}
        - cord: {from: {body: B, tied at: centre, leaves: forward}, pulled with: 9 N}
      start: at rest
      end: {travel: {of: B, by: 2 m}}",
        "a: m/s^2; friction: N; alpha: rad/s^2; work_pull: J",
        &[("a", &[FORWARD, RIGHT]), ("friction", &[BACK, LEFT]), ("alpha", &[CLOCKWISE]), ("work_pull", &[])],
    ),
];

#[test]
fn words_give_the_sign_of_what_they_fit_and_are_unreadable_elsewhere() {
    for (scene, questions, parts) in SCENES {
        let key = key(scene, questions);
        assert_eq!(key.parts.len(), parts.len(), "{questions}");
        for (part, right) in parts {
            let entry = key.parts.iter().find(|e| e.part == *part).unwrap();
            for [one, other] in PAIRS {
                for (words, opposite) in [(one, other), (other, one)] {
                    let want = match () {
                        () if right.contains(&words) => Verdict::Right,
                        () if right.contains(&opposite) => Verdict::WrongDirection,
                        () => Verdict::Unreadable,
                    };
                    for word in words {
                        let cell = sized(entry, word);
                        let told = judged(entry, &cell, "en");
                        assert_eq!(told.verdict, want, "{part}: {cell}: {} {scene}", told.reason);
                        assert_eq!(judged(entry, &cell, "de").verdict, want, "{cell}");
                        if want == Verdict::Unreadable {
                            // What is named as fitting does fit.
                            let (_, named) = told.reason.split_once("one of ").unwrap_or_default();
                            let fit = named.split(", ").filter(|w| !w.is_empty());
                            assert_eq!(fit.clone().count(), 2 * right.len(), "{}", told.reason);
                            for word in fit {
                                let cell = sized(entry, word);
                                assert_ne!(judged(entry, &cell, "en").verdict, Verdict::Unreadable, "{cell}");
                            }
                        }
                        // A sign and a word may contradict each other.
                        let both = format!("-{}", sized(entry, word));
                        assert_eq!(judged(entry, &both, "en").verdict, Verdict::Unreadable, "{both}");
                    }
                }
            }
        }
    }
}

#[test]
fn what_does_not_fit_is_told_in_both_languages() {
    let (scene, questions, _) = SCENES[0];
    let key = key(scene, questions);
    let entry = |part: &str| key.parts.iter().find(|e| e.part == part).unwrap();
    for (part, word, language, piece) in [
        ("a_x", "up", "en", "`up` is no direction of this quantity: write a sign or one of right, left"),
        ("a_x", "hinauf", "de", "schreiben Sie ein Vorzeichen oder eines von rechts, links"),
        ("alpha", "forward", "en", "write a sign or one of clockwise, counter-clockwise"),
        ("alpha", "vor", "de", "eines von im Uhrzeigersinn, gegen den Uhrzeigersinn"),
        ("a_y", "cw", "en", "`clockwise` is no direction of this quantity"),
        ("a_y", "im Uhrzeigersinn", "de", "`im Uhrzeigersinn` ist keine Richtung dieser Größe"),
    ] {
        let told = judged(entry(part), &sized(entry(part), word), language);
        assert_eq!(told.verdict, Verdict::Unreadable);
        assert!(told.reason.contains(piece), "{}", told.reason);
    }
    let (scene, questions, _) = SCENES[6];
    let key = self::key(scene, questions);
    let work = key.parts.iter().find(|e| e.part == "work_pull").unwrap();
    let told = judged(work, &sized(work, "up"), "en");
    assert!(told.reason.contains("gives this quantity no sign"), "{}", told.reason);
    assert!(judged(work, &sized(work, "rauf"), "de").reason.contains("gibt dieser Größe kein Vorzeichen"));
}

#[test]
fn a_tension_is_no_direction() {
    let key = key(
        "
      bodies:
        A: {mass: m, moves: vertically}
        B: {mass: 5 kg, moves: vertically, positive: down}
      ties: [cord: {name: c, from: {body: A, tied at: centre, leaves: up}, to: {body: B, tied at: centre, leaves: up}}]
      start: at rest
      end: {travel: {of: A, by: 1 m}}",
        "tension: N; A.a: m/s^2; B.a: m/s^2",
    );
    let [tension, light, heavy] = &key.parts[..] else { panic!("{key:?}") };
    for word in ["up", "down", "nach oben", "left"] {
        let told = judged(tension, &sized(tension, word), "en");
        assert_eq!(told.verdict, Verdict::Right, "{word}");
        assert!(told.reason.contains("no direction is asked"), "{}", told.reason);
    }
    for (part, right, wrong) in [(light, UP, DOWN), (heavy, DOWN, UP)] {
        assert!(right.iter().all(|w| compare(&sized(part, w), part).verdict == Verdict::Right));
        assert!(wrong.iter().all(|w| compare(&sized(part, w), part).verdict == Verdict::WrongDirection));
    }
}

/// A spring that also pushes is shortened at equilibrium by a block that it holds from below: stretch and force have a sign, and
/// where the block's forward is down, words tell the signs of what goes along the incline.
#[test]
fn a_spring_that_pushes_has_signs() {
    let key = key(
        "
      surfaces: {i: {slope: 30 deg}}
      bodies: {b: {mass: m, moves: along i, positive: down}}
      ties: [cord: {name: spring, from: {body: b, tied at: centre, leaves: forward}, spring: {stiffness: 100 N/m, stretch: 0 m, attached: rigidly}}]
      start: at rest
      end: {travel: {of: b, by: 0.01 m}}",
        "x_eq: mm; tension: N; a: m/s^2; displacement: m",
    );
    let verdict = |part: usize, cell: &str| compare(cell, &key.parts[part]).verdict;
    assert_eq!(
        [verdict(0, "-147.15 mm"), verdict(0, "147.15 mm")],
        [Verdict::Right, Verdict::WrongDirection]
    );
    for part in [2, 3] {
        let [down, up, bare] = ["down", "up", ""].map(|word| verdict(part, &sized(&key.parts[part], word)));
        assert_eq!([down, up, bare], [Verdict::Right, Verdict::WrongDirection, Verdict::Right]);
    }
}

/// At an instant a bar that turns may be level: friction on it points right or left, as on a level floor.
#[test]
fn friction_on_a_bar_that_is_level_points_right_or_left() {
    let on = |degrees: u32| {
        let (s, c) = f64::from(degrees).to_radians().sin_cos();
        key(
            &format!(
                "
      bodies:
        bar: {{mass: m, shape: {{rod: 1 m}}, moves: in the plane, angle: from right}}
        block: {{mass: 2 kg, moves: in the plane, placed: [{:?} m, {:?} m]}}
      joints:
        O: {{pins: bar.A}}
        x: {{slides: block, on: bar.A, mu_k: 0.2}}
      forces: [force: {{on: block, magnitude: 3 N, direction: left}}]
      start: {{bar: {{angle: {degrees} deg}}}}
      end: at once",
                0.5 * c,
                0.5 * s
            ),
            "x.friction: N",
        )
    };
    for (degrees, fit, misfit) in [(0, "right", "up"), (20, "up", "right")] {
        let key = on(degrees);
        let verdict = |word| compare(&sized(&key.parts[0], word), &key.parts[0]).verdict;
        assert_eq!([verdict(fit), verdict(misfit)], [Verdict::Right, Verdict::Unreadable], "{degrees}");
    }
}

/// Two words stand on the sheet beside each answer that has a sign: the one is right where its number is, the other where it
/// is not.
#[test]
fn the_words_that_sheets_offer_fit() {
    let (mut offered, mut both) = (0, [0, 0]);
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 3, "offered");
            for student in 0..support::seeds(20) {
                let variant = maker.variant(&student.to_string()).unwrap();
                let key = maker.key(&variant);
                let scene = &problem.cases[variant.case].scene;
                for (entry, question) in key.parts.iter().zip(&problem.questions) {
                    let Answer::Number { value, half_width, .. } = entry.answer else { continue };
                    if value.abs() <= 2.0 * half_width {
                        continue;
                    }
                    for language in ["en", "de"] {
                        let words = Words::built_in(language).unwrap();
                        let Some(said) = sense_words(words, scene, question.label) else { continue };
                        let [first, second] = said.map(|w| judged(entry, &sized(entry, w), language).verdict);
                        let signs = [Verdict::Right, Verdict::WrongDirection];
                        let want = if value > 0.0 { signs } else { [signs[1], signs[0]] };
                        assert_eq!([first, second], want, "{} {} {said:?}", problem.id, entry.part);
                        offered += 1;
                        both[usize::from(value > 0.0)] += 1;
                    }
                }
            }
        }
    }
    assert!(offered > 100 && both.iter().all(|n| *n > 20), "{offered} {both:?}");
}

/// A rod on a pin that leans to the right and swings so fast that its pin pulls it nearly straight to the left.
fn pulled_to_the_left() -> ProblemKey {
    key(
        "
      bodies: {B: {mass: m, shape: {rod: 1 m}, pinned: at its end, angle: from upright}}
      start: {B: {angle: 30 deg, spin: 8 rad/s}}
      end: at once",
        "pin_angle: deg",
    )
}

#[test]
fn whole_turns_do_not_count_in_the_direction_of_a_force() {
    let key = pulled_to_the_left();
    let entry = &key.parts[0];
    let Answer::Number { value, half_width, .. } = entry.answer else { panic!("{entry:?}") };
    let (degrees, wide) = (value.to_degrees(), half_width.to_degrees());
    assert!(degrees.abs() > 90.0, "{degrees}");
    let table = KeyTable::new(vec![SheetKey { student: "s".into(), problems: vec![key.clone()] }], &[]);
    // As `check` judges it, and as `grade` does, which has a quick way for plain numbers.
    let verdict = |x: f64, unit: &str| {
        let cell = format!("{x}{unit}");
        let told = compare(&cell, entry);
        let text = format!("student,problem,part,answer\ns,1,{},{cell}\n", entry.part);
        let (line, _) = run_with(text.as_bytes(), &table, &Options::default()).unwrap();
        assert!(line.contains(&format!(",{},", told.verdict)), "{cell}: {told:?} {line}");
        told.verdict
    };
    for turns in -3..=3 {
        let same = degrees + 360.0 * f64::from(turns);
        assert_eq!(verdict(same, " deg"), Verdict::Right);
        assert_eq!(verdict(same, ""), Verdict::Right);
        assert_eq!(verdict(same + 0.9 * wide, ""), Verdict::Right);
        assert_eq!(verdict(same - 1.1 * wide, ""), Verdict::Wrong);
        assert_eq!(verdict(-same, ""), Verdict::WrongDirection);
        assert_eq!(verdict((same - 180.0) / 360.0, " rev"), Verdict::Wrong);
        assert_eq!(verdict(same / 360.0, " rev"), Verdict::Right);
    }
    assert_eq!(verdict(1e100, ""), Verdict::Wrong);
}

/// An angle turned is none of a force: a turn more is another angle.
#[test]
fn turns_count_in_an_angle_turned() {
    let key = key(
        "
      bodies: {B: {mass: m, shape: {rod: 1 m}, pinned: at its end, angle: from upright}}
      start: {B: {angle: 30 deg}}
      end: {angle: {of: B, reaches: 100 deg}}",
        "phi: deg",
    );
    let entry = &key.parts[0];
    for (cell, verdict) in
        [("70 deg", Verdict::Right), ("430 deg", Verdict::Wrong), ("-290 deg", Verdict::Wrong)]
    {
        assert_eq!(compare(cell, entry).verdict, verdict, "{cell}");
    }
}

/// A wheel that spins in place, held by a block: the problem declares that it rolls at last, so its sheet offers the two senses alone.
#[test]
fn a_word_that_no_sheet_offers_is_no_answer() {
    let bank = "
bank: b
title: B
problems:
  p:
    title: P
    data: {m: {name: mass, unit: kg, draw: always 4}}
    regimes: [rolls_after]
    scene:
      surfaces: {i: {slope: 15 deg}}
      bodies: {w: {mass: m, shape: {disc: 0.2 m}, radii: {rim: 0.2 m}, moves: along i}, b: {mass: 4 kg, moves: along i}}
      ties:
        - slips: {body: w, on its: rim, mu_s: 0.5, mu_k: 0.3}
        - slides: {body: b, mu_s: 0.3, mu_k: 0.25}
        - link: {from: {body: w, tied at: centre, leaves: back}, to: {body: b, tied at: centre, leaves: forward}}
      start: {w: {speed: 0 m/s, spin: 20 rad/s}}
      end: {turn: {of: w, by: 3 rad}}
    questions: {which: {quantity: w.direction, ask: x}}
    statement: x
";
    let bank = load::scenes_only(bank, "test").unwrap_or_else(|f| panic!("{f:#?}"));
    let refused = Maker::new(&bank.problems[0], 1, "directions").variant("s").unwrap_err();
    assert_eq!(refused.table, [("question which has no answer".to_owned(), 1)]);
}
