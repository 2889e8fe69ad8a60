//! Units as they are spelled in cells.
use crate::units::{Unit, UnitFault};
use rustc_hash::FxHashMap;
use std::sync::Arc;

#[derive(Debug, Clone)]
pub(crate) struct SpelledUnit {
    pub unit: Arc<Unit>,
    pub case_forgiven: bool,
    /// See [`crate::answer::read::Number::otherwise`].
    pub otherwise: Option<Arc<Unit>>,
}

/// Unit texts already read, so that a class of answers parses each spelling once.
#[derive(Debug, Default)]
pub struct UnitCache {
    known: FxHashMap<Box<str>, Result<SpelledUnit, UnitFault>>,
}

impl UnitCache {
    pub(crate) fn unit(&mut self, text: &str) -> Result<SpelledUnit, UnitFault> {
        if let Some(found) = self.known.get(text) {
            return found.clone();
        }
        let said = spoken(text);
        let said = said.as_deref().unwrap_or(text);
        let read = Unit::parse(said).map(|unit| (unit, false)).or_else(|_| Unit::parse_any_case(said));
        let found = match (read, otherwise(said).map(Arc::new)) {
            (Ok((unit, case_forgiven)), otherwise) => {
                Ok(SpelledUnit { unit: Arc::new(unit), case_forgiven, otherwise })
            }
            (Err(_), Some(unit)) => Ok(SpelledUnit { unit, case_forgiven: false, otherwise: None }),
            (Err(fault), None) => Err(fault),
        };
        if self.known.len() < 512 && text.len() <= 64 {
            self.known.insert(text.into(), found.clone());
        }
        found
    }
}

/// The other meaning of a unit that has two: pounds are a mass or a force; `kn` is a knot, or kN by a slip of the shift key; `ms^-1` is
/// one over a millisecond, or a metre per second written together.
fn otherwise(text: &str) -> Option<Unit> {
    let mut other = String::with_capacity(text.len() + 4);
    let mut changed = false;
    for piece in text.split_inclusive(|c: char| !c.is_alphabetic()) {
        let name = piece.trim_end_matches(|c: char| !c.is_alphabetic());
        let mark = piece[name.len()..].starts_with(['^', '*', '-', '⁻', '\u{2212}', '²', '³']);
        let meant = match name {
            "kn" => Some("knot"),
            name if ["lb", "lbs", "pound", "pounds"].iter().any(|p| p.eq_ignore_ascii_case(name)) => {
                Some("lbf")
            }
            name if mark => TOGETHER.iter().find(|(together, _)| *together == name).map(|(_, apart)| *apart),
            _ => None,
        };
        changed |= meant.is_some();
        other.push_str(meant.unwrap_or(name));
        other.push_str(&piece[name.len()..]);
    }
    if changed { Unit::parse(&other).ok() } else { None }
}

/// Units that are written together, so that an exponent belongs to the last.
const TOGETHER: [(&str, &str); 15] = [
    ("ms", "m s"),
    ("mms", "mm s"),
    ("cms", "cm s"),
    ("kms", "km s"),
    ("rads", "rad s"),
    ("kgs", "kg s"),
    ("kgms", "kg m s"),
    ("kgmm", "kg mm"),
    ("kgcm", "kg cm"),
    ("Nm", "N m"),
    ("kNm", "kN m"),
    ("Ncm", "N cm"),
    ("Nmm", "N mm"),
    ("Nms", "N m s"),
    ("Js", "J s"),
];

/// `radians per second squared` as `radians/second^2`; `None` where nothing is spoken.
fn spoken(text: &str) -> Option<String> {
    let plain = text
        .replace(" per ", "/")
        .replace(" pro ", "/")
        .replace(" squared", "^2")
        .replace("Umdr./", "Umdr/")
        .replace("Umdr. /", "Umdr/");
    (plain != text).then_some(plain)
}
