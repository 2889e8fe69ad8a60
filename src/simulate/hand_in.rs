//! Submissions of a class: right ones and the ways in which they go wrong.
use crate::bank::Problem;
use crate::guard::push_field;
use crate::key::{Answer, KeyEntry, ProblemKey};
use crate::num::shown::significant;
use crate::problem::maker::Variant;
use crate::solve::agree;
use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha20Rng;

macro_rules! kinds {
    ($($variant:ident $name:literal;)*) => {
        /// What a simulated row is.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum CellKind { $(#[doc = $name] $variant,)* }
        impl CellKind {
            /// All.
            pub const ALL: &'static [CellKind] = &[$(CellKind::$variant,)*];
            /// In words.
            pub const fn name(self) -> &'static str { match self { $(CellKind::$variant => $name,)* } }
        }
    };
}
kinds! {
    Right "right";
    WrongMethod "wrong method";
    WrongUnit "wrong unit";
    Messy "messy";
    Blank "blank";
    Duplicate "duplicate";
    Unknown "unknown";
}

/// What one student of the class was dealt.
pub struct Sheet<'s> {
    /// Id.
    pub student: &'s str,
    /// Problem, variant and key, in the order of the sheet.
    pub problems: Vec<(&'s Problem, &'s Variant, &'s ProblemKey)>,
}

/// A file of submissions, and what each of its rows is (the header is not counted).
pub struct HandIn {
    /// The bytes, as a spreadsheet exports them where the comma is the decimal mark: byte order mark, semicolons, CRLF.
    pub bytes: Vec<u8>,
    /// Kinds of the rows in order.
    pub kinds: Vec<CellKind>,
}

/// Lets the class hand in. The last student hands in nothing.
pub fn hand_in(sheets: &[Sheet], seed: u64) -> HandIn {
    let mut rng = ChaCha20Rng::seed_from_u64(seed);
    let mut rows: Vec<(CellKind, [String; 5])> = Vec::new();
    let mut minute = 0u32;
    let mut stamp = || {
        minute += 1;
        format!("2026-03-{:02} {:02}:{:02}", 2 + minute / 1440, minute / 60 % 24, minute % 60)
    };
    let some = sheets.len().saturating_sub(1);
    for sheet in &sheets[..some] {
        for (i, (problem, variant, key)) in sheet.problems.iter().enumerate() {
            for (part, entry) in key.parts.iter().enumerate() {
                // Some write the number of the problem, some its id.
                let name = if rng.random_bool(0.8) { (i + 1).to_string() } else { problem.id.clone() };
                let mut row = |kind: CellKind, answer: String| {
                    let student = sheet.student.to_owned();
                    rows.push((kind, [stamp(), student, name.clone(), entry.part.clone(), answer]));
                };
                match rng.random_range(0..100u32) {
                    0..52 => row(CellKind::Right, right(entry)),
                    52..66 => {
                        row(CellKind::WrongMethod, wrong_method(problem, variant, part, entry, &mut rng))
                    }
                    66..73 => row(CellKind::WrongUnit, wrong_unit(entry)),
                    73..87 => row(CellKind::Messy, messy(entry, &mut rng)),
                    87..93 => row(
                        CellKind::Blank,
                        if rng.random_bool(0.5) { String::new() } else { "  ".to_owned() },
                    ),
                    _ => {
                        row(CellKind::Duplicate, wrong_method(problem, variant, part, entry, &mut rng));
                        row(CellKind::Duplicate, right(entry));
                    }
                }
            }
        }
    }
    for (i, sheet) in sheets.iter().take(7).enumerate() {
        // A lost leading zero, a name for an id, a part that nobody asked.
        let lost = sheet.student.trim_start_matches('0').to_owned();
        let student = if i % 2 == 0 { lost } else { format!("{}@example.org", sheet.student) };
        let part = sheet.problems.first().and_then(|p| p.2.parts.first()).map_or("v", |e| e.part.as_str());
        rows.push((CellKind::Unknown, [stamp(), student, "1".to_owned(), part.to_owned(), "1.5".to_owned()]));
        let student = sheet.student.to_owned();
        let (problem, part) = if i % 2 == 0 { ("9", part) } else { ("1", "speed") };
        rows.push((
            CellKind::Unknown,
            [stamp(), student, problem.to_owned(), part.to_owned(), "2 m/s".to_owned()],
        ));
    }
    let mut bytes = "\u{feff}Submitted_at;STUDENT;Problem;Part ;Answer;Device\r\n".as_bytes().to_vec();
    for (i, (_, fields)) in rows.iter().enumerate() {
        for field in fields {
            push_field(&mut bytes, field.as_bytes(), b';', field.contains(' ') && i % 3 == 0);
            bytes.push(b';');
        }
        bytes.extend_from_slice(if i % 2 == 0 { b"phone\r\n" } else { b"\r\n" });
    }
    HandIn { bytes, kinds: rows.into_iter().map(|(kind, _)| kind).collect() }
}

/// Signs as words, forward first.
fn sides(entry: &KeyEntry) -> Option<f64> {
    match entry.answer {
        Answer::Number { value, directed: true, .. } => Some(value),
        _ => None,
    }
}

fn with_unit(entry: &KeyEntry, number: &str) -> String {
    entry.unit.text_with(number)
}

fn right(entry: &KeyEntry) -> String {
    match &entry.answer {
        Answer::Word { right, .. } => (*right).to_owned(),
        Answer::Number { value, .. } => with_unit(entry, &significant(entry.unit.from_si(*value), 4)),
    }
}

/// Another value, from a mistake that students make: a solid disc for the radius of gyration, diameters for radii, the
/// other angle, equal masses; where none changes the answer, a factor 1/2 is lost.
fn wrong_method(
    problem: &Problem,
    variant: &Variant,
    part: usize,
    entry: &KeyEntry,
    rng: &mut ChaCha20Rng,
) -> String {
    let value = match &entry.answer {
        Answer::Word { right, offered } => {
            let others: Vec<&str> = offered.iter().copied().filter(|o| o != right).collect();
            let pick = rng.random_range(0..u32::try_from(others.len().max(1)).unwrap_or(1));
            return others.get(pick as usize).copied().unwrap_or("yes").to_owned();
        }
        Answer::Number { value, .. } => *value,
    };
    let place = |symbol: &str| problem.data.iter().position(|d| d.symbol == symbol);
    let mut data = variant.data.clone();
    match rng.random_range(0..4u32) {
        0 => {
            if let (Some(k), Some(rim)) = (place("k"), place("R")) {
                data[k] = data[rim] * std::f64::consts::FRAC_1_SQRT_2;
            }
        }
        1 => {
            for i in ["R", "r"].into_iter().filter_map(place) {
                data[i] *= 2.0;
            }
        }
        2 => {
            if let Some(i) = place("theta") {
                data[i] = 90.0 - data[i];
            }
        }
        _ => {}
    }
    for (i, datum) in problem.data.iter().enumerate() {
        if datum.symbol.starts_with("m_") && data[i] > 0.0 {
            data[i] = 1.0;
        }
    }
    let case = problem.cases.get(variant.case);
    let question = problem.questions.get(part);
    let wrong = case.and_then(|c| agree::solve(&c.scene, &data).ok());
    let wrong = wrong.zip(question).and_then(|(solved, q)| solved.get(q.label).map(|e| e.value()));
    let wrong = wrong.filter(|w| w.is_finite() && (w - value).abs() > 0.03 * value.abs());
    with_unit(entry, &significant(entry.unit.from_si(wrong.unwrap_or(value * std::f64::consts::SQRT_2)), 4))
}

/// The right number with a unit of another kind.
fn wrong_unit(entry: &KeyEntry) -> String {
    let other = match entry.unit.ascii() {
        "N" => "J",
        "m/s" => "m/s^2",
        "rad/s" => "m/s",
        "m" => "m^2",
        "J" => "N",
        "rad" => "m",
        _ => "s",
    };
    match &entry.answer {
        Answer::Word { right, .. } => format!("{right} m"),
        Answer::Number { value, .. } => format!("{} {other}", significant(entry.unit.from_si(*value), 4)),
    }
}

/// Right, but written in a way that a careless program misreads.
fn messy(entry: &KeyEntry, rng: &mut ChaCha20Rng) -> String {
    let value = match &entry.answer {
        Answer::Word { right, .. } => return format!(" {} ", right.to_uppercase()),
        Answer::Number { value, .. } => entry.unit.from_si(*value),
    };
    let text = significant(value, 4);
    match rng.random_range(0..6u32) {
        0 => with_unit(entry, &text.replace('.', ",")),
        1 => with_unit(entry, &text.replace('-', "\u{2212}")).replace(' ', "\u{2009}"),
        2 => {
            let short = format!("{value:.3e}");
            let (digits, exponent) = short.split_once('e').unwrap_or((&short, "0"));
            with_unit(entry, &format!("{digits}×10^{exponent}"))
        }
        3 => format!("  {}  ", text.replace('.', ",")),
        4 => match sides(entry) {
            Some(v) => {
                let word = if v > 0.0 { "up" } else { "down the incline" };
                format!("{} {word}", with_unit(entry, text.trim_start_matches('-')))
            }
            None => with_unit(entry, &format!("+{text}")).replace("+-", "-").replace("m/s", "m s^-1"),
        },
        _ => with_unit(entry, &format!("{value:.4e}")).replacen(' ', "", 1),
    }
}
