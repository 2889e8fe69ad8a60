//! slipstick makes and grades homework in rigid-body dynamics, and proves its own key.
//!
//! # Words
//! - A **bank** is what an instructor writes; a **problem** of it has **data**, a **scene** and **questions**; of its **cases** a
//!   student gets one. A question is a **part** of a student's sheet (`1.omega`), and a **column** of the class's table.
//! - A **scene** is pure data in SI: bodies, ties (rolling, slipping and sliding contacts, cords), couples, a start, an end. A scene
//!   that is its **next** follows it: what each road found of the first is where it sets the second off.
//! - A **draw** gives each datum a value on a decimal grid; a draw that holds every rule is a **variant**, one student's own.
//!   What one student was **dealt** is variants and key, problem by problem; a **set** is what a class was dealt, with the bank.
//! - A variant has a **code** of eight digits, by which a learning platform knows it; a sheet has one of six letters, which says
//!   on paper whose it is. The **seal** of a set is the SHA-256 of its key.
//! - A **road** is one of the two ways in which the program finds an answer: `eom`, the equations of motion, or `energy`, work
//!   and energy.
//! - A **rung** is a method with its setting (closed form, quadrature, steps); the **ladder** takes the cheapest that a scene needs.
//! - The **regime** is what really happens (`moves_up`, `up ok slips`); a **check** is one condition of validity, with numbers.
//! - The **key** holds the answers on which both roads agree, with their gap and condition number.
//! - A student's cell becomes a **reading**; key and reading give a **verdict** with points and a reason. Of several **attempts**
//!   at a part one counts, the others are superseded.
//! - A **wrong method** is what students do instead of a right one, listed under `mistakes:` in the bank: its value comes from a
//!   changed scene, changed data or a change of the value; the **catalogue** holds its words. A **slip** is another thing that a
//!   wrong number fits. Neither makes it right.
//! - A **policy** is what bears on marks (attempts, lateness, credit, corrections, totals); a **grading** is a folder with every
//!   answer's verdict and its **basis**, copies of all that it was made from.
//! - A **document** is Markdown with formulas and pictures, the one source of every format; a **template** and the **phrases** of
//!   a language make it, the program puts in finished texts.
//! - A **finding** is a fault in somebody's file: where, what value, what would be right.
//!
//! # Flow
//! ```text
//! bank -> draw -> problem (scene -> solve: eom | energy, agree) -> key -> sheet, figure, solution, set
//!                          document -> Markdown, HTML, LaTeX, Typst -> PDF; export -> questions of a learning platform
//!                          misconception (wrong values, beside the key)
//!              policy, submissions -> answer -> grade -> report, matches, regrade
//!              one sheet -> page: answer -> grade -> tutor (hints), in the browser and for `check`
//!              set, habits -> simulate -> submissions, truth
//! ```
//! [`problem::maker::Maker::variant`] goes from a bank to solved data and [`problem::make_key::key`] on to the key;
//! [`grade::run::grade`] goes from submissions to verdicts. [`folder`] reads and writes what lies on disk, [`review`] looks at a bank before its sheets go out, [`inspect`] at one problem
//! with given data, [`manual`] explains all of it to people, and [`cli`] tells results: a verb is a file of its own that knows no
//! other verb. [`units`] reads and converts units for all of them, [`csv_field`] writes a field of CSV that no spreadsheet runs.
//!
//! The feature `program` is the command line with all that it writes. Without it the crate is what a sheet needs that checks
//! itself: [`page`] gets its problems as they were read from the bank, solves them and judges their answers, [`tutor`] finds hints, and
//! the package in `src/page/door` makes of both the WebAssembly that pages carry (`.ci/page`).
//!
//! # Two ways through the house
//! From a datum of a bank to the key: `bank/schema.rs` reads it, its range with `bank/draw.rs` and its use with `bank/scene.rs`;
//! `draw/sample.rs` gives it a value out of `draw/stream.rs`; `problem/maker.rs` solves the scene with it (`solve/agree.rs`) and keeps
//! the draw if each rule of `problem/rule.rs` holds; `problem/make_key.rs` writes down the answers as a [`key::ProblemKey`], which
//! `set/key_file.rs` puts into key.csv.
//!
//! From a student's cell to the verdict: `answer/submissions.rs` finds the cell in what was handed in, `grade/run.rs` takes it to
//! `grade/judge.rs` and that to `grade/compare.rs`, where `answer/read.rs` makes a reading of it; reading and key give a
//! [`grade::verdict::Verdict`] with its reason. `grade/diagnose.rs` looks for the wrong method behind a wrong number,
//! `grade/award.rs` gives the points.
//!
//! # In Rust
//! A bank is read from its text; what is wrong with it comes as findings, all at once:
//! ```
//! use slipstick::bank::load;
//! let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/banks/hoists-and-pulleys.yaml"));
//! let bank = load::scenes_only(text, "hoists.yaml")?;
//! assert!(bank.problems.len() > 1);
//! let findings = load::scenes_only("bank: hoists\nproblems: {}\n", "hoists.yaml").unwrap_err();
//! assert!(findings[0].to_string().starts_with("hoists.yaml:1:1: `title` is missing"));
//! # Ok::<(), slipstick::finding::Findings>(())
//! ```
//! Seed, name of the set and student id give a variant, the same whenever it is made:
//! ```
//! # use slipstick::bank::load;
//! # let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/banks/hoists-and-pulleys.yaml"));
//! # let bank = load::scenes_only(text, "hoists.yaml").unwrap();
//! use slipstick::problem::maker::Maker;
//! let maker = Maker::new(&bank.problems[0], 1, "week-5");
//! let variant = maker.variant("0017")?;
//! assert_eq!(variant.values, maker.variant("0017")?.values);
//! assert_ne!(variant.values, maker.variant("0018")?.values);
//! # Ok::<(), Box<slipstick::problem::maker::Unsatisfiable>>(())
//! ```
//! Its key judges what a student writes into a cell:
//! ```
//! # use slipstick::bank::load;
//! # let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/banks/hoists-and-pulleys.yaml"));
//! # let bank = load::scenes_only(text, "hoists.yaml").unwrap();
//! # let problem = &bank.problems[0];
//! # let variant = slipstick::problem::maker::Maker::new(problem, 1, "week-5").variant("0017").unwrap();
//! use slipstick::grade::{compare::compare, verdict::Verdict};
//! use slipstick::key::Answer;
//! let key = slipstick::problem::make_key::key(problem, &variant);
//! let part = &key.parts[0];
//! let Answer::Number { value, .. } = part.answer else { panic!("a number is asked") };
//! let cell = |value: f64| part.unit.text_with(&part.unit.from_si(value).to_string());
//! assert_eq!(compare(&cell(value), part).verdict, Verdict::Right);
//! assert_eq!(compare(&cell(2.0 * value), part).verdict, Verdict::Wrong);
//! assert_eq!(compare("12 apples", part).verdict, Verdict::Unreadable);
//! ```
//!
//! # Invariants
//! - The roads share the scene and the arithmetic of [`num`], no mechanics; only [`solve::agree`] and [`solve::ladder`] see both.
//! - Nothing is published that they do not agree on within `16 u max(1, cond)`, u = 2^-53; NaN agrees with nothing.
//! - No variant has an answer that its printed data do not determine: the condition number is below the limit of its question,
//!   and a tolerance that widens with it is printed. Of constants alone, which cannot be drawn anew, the instructor is told instead.
//! - The printed datum is the datum used; a variant depends on seed, set name, problem and student id alone.
//! - The same seed gives the same bytes on every machine: own words from ChaCha20, functions from libm, no fused operations.
//! - Every answer cell comes out exactly once; a student's odd cell is a verdict, never an error.
//! - A file is written whole or not at all, and so is a new folder. Late joiners come into a set file by file, `set.json` last;
//!   what a kill leaves of that the next `--add` repairs.
//!
//! Who may import whom, and who keeps which crate, stands as a table in `tests/architecture.rs` and is checked there. [`num`],
//! [`scene`] and [`solve`] are a package of their own, `src/mechanics.rs`, which knows nothing of the rest.
//!
//! # Where the next feature goes
//! A new method: a word in [`solve::method`], its steps in [`num::ode`] or its sum in `solve/energy/quadrature.rs`; [`solve::ladder`]
//! judges it and measures it. A new chart: numbers into [`plot`]; a new kind of element for all pictures:
//! [`picture`].
//! A new joint in the plane: a variant in [`scene::planar`], how it places a body in [`scene::pose`], its rows in
//! `solve/eom/planar.rs` and its virtual motion in `solve/energy/joined.rs`, its words in `bank/scene/planar.rs`.
//! A new law of a spring in the plane: [`scene::planar::Acts`] or [`scene::planar::StrutEnd`], where it lies and when it acts in
//! `scene/pose/springs.rs`, its force in `solve/eom/planar.rs` and its work in `solve/energy/joined.rs`, its words in `bank/scene/planar.rs`.
//! Another word for what can be said already: a rule in `bank/synonyms.rs`.
//! A new number of a scene: its unit and its rules in [`scene::given`]. A new tie: a variant in [`scene::link`], its rows in `solve/eom/equations.rs`, its mode and its work in `solve/energy`, its
//! words in `bank/scene/ties.rs`, its quantities in `bank/labels.rs`. A new end of a motion: a row in `bank/scene/end.rs`. A new language: its folder in `templates/`, a line in [`words`], its texts in [`template`] and `bank/built_in.rs`.
//! A new format: a walk over the events of a [`sheet::document`], as in [`sheet::tex`]. A new family: no Rust, a file in `banks/`.
//! A new wrong method: an entry under `mistakes:` of its problem and its words in the catalogue. A new setting of marks: a field of
//! [`policy`], a line in `bank/course.rs`, its effect in `grade/attempt.rs`, `grade/credit.rs`, `grade/rules.rs` or `grade/award.rs`,
//! its words in `report/settings.rs`, `report/explain.rs` and `report/changes.rs`, and its reason for a changed mark in
//! [`regrade::changes`]. A new quantity: a line in [`scene::ask`] with what its sign means, a `say` on each road, and in
//! [`problem::make_key::word_signs`] the words that give it a sign.
//!
//! # Limits
//! Rigid bodies in a plane. On lines and axles: velocity ratios that do not change with the position, cords without mass that run
//! parallel to the line of the body they leave, save a constant pull at an angle; one freedom, or several under constant
//! forces, in phases that each last until a contact that rubs comes to rest; with springs, several freedoms only at an instant. Joined in the
//! plane by pins, hinges, welds, guides, cords and surfaces, which may be rough: one freedom on the way, any
//! number at an instant, with a speed told for each or from rest; a drive at an instant alone; torsion springs within half a turn.
//! Gears and belts join wheels about fixed axles. What carries a whole scene moves along a straight line at a constant acceleration.
//! One motion follows another without a jerk: what the ties of the second do not allow of the first's speeds is refused.
#![cfg_attr(not(feature = "program"), allow(dead_code, reason = "a page needs less than the program"))]
#[macro_use(worded)]
extern crate mechanics;
pub use mechanics::{num, scene, solve};

pub mod answer;
pub mod bank;
#[cfg(feature = "program")]
pub mod cli;
mod csv_field;
pub mod draw;
#[cfg(feature = "program")]
pub mod export;
#[cfg(feature = "program")]
pub mod figure;
pub mod finding;
#[cfg(feature = "program")]
mod folder;
pub mod grade;
#[cfg(feature = "program")]
pub mod inspect;
pub mod key;
#[cfg(feature = "program")]
pub mod manual;
#[cfg(feature = "program")]
pub mod matches;
pub mod misconception;
pub mod page;
#[cfg(feature = "program")]
pub mod picture;
#[cfg(feature = "program")]
mod plot;
pub mod policy;
pub mod problem;
#[cfg(feature = "program")]
mod regrade;
#[cfg(feature = "program")]
pub mod report;
#[cfg(feature = "program")]
mod review;
#[cfg(feature = "program")]
pub mod set;
#[cfg(feature = "program")]
pub mod sheet;
#[cfg(feature = "program")]
pub mod simulate;
#[cfg(feature = "program")]
pub mod solution;
#[cfg(feature = "program")]
pub mod template;
pub mod tutor;
pub mod units;
pub mod words;
