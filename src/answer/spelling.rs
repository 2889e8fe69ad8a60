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
        let found = match Unit::parse(said) {
            Ok(unit) => Ok((unit, false)),
            Err(_) => Unit::parse_any_case(said),
        };
        let found = found.map(|(unit, case_forgiven)| SpelledUnit {
            unit: Arc::new(unit),
            case_forgiven,
            otherwise: otherwise(said).map(Arc::new),
        });
        if self.known.len() < 512 && text.len() <= 64 {
            self.known.insert(text.into(), found.clone());
        }
        found
    }
}

/// The other meaning of a unit that has two: pounds are a mass or a force; `kn` is a knot, or kN by a slip of the shift key.
fn otherwise(text: &str) -> Option<Unit> {
    let mut other = String::with_capacity(text.len() + 4);
    let mut changed = false;
    for piece in text.split_inclusive(|c: char| !c.is_alphabetic()) {
        let name = piece.trim_end_matches(|c: char| !c.is_alphabetic());
        let meant = match name {
            "kn" => Some("knot"),
            name if ["lb", "lbs", "pound", "pounds"].iter().any(|p| p.eq_ignore_ascii_case(name)) => {
                Some("lbf")
            }
            _ => None,
        };
        changed |= meant.is_some();
        other.push_str(meant.unwrap_or(name));
        other.push_str(&piece[name.len()..]);
    }
    if changed { Unit::parse(&other).ok() } else { None }
}

/// `radians per second squared` as `radians/second^2`; `None` where nothing is spoken.
fn spoken(text: &str) -> Option<String> {
    let plain = text
        .replace(" per ", "/")
        .replace(" squared", "^2")
        .replace("Umdr./", "Umdr/")
        .replace("Umdr. /", "Umdr/");
    (plain != text).then_some(plain)
}
