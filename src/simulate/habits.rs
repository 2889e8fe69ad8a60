//! Habits of a class, as a YAML file declares them: what becomes of an answer, how numbers are written, who copies, when it is
//! handed in.
use crate::bank::node::{Faults, Fields, Node, Value, choice, named, shorten, whole};
use crate::bank::{course, yaml};
use crate::finding::Findings;
use crate::policy::{MINUTE, Zone, time};
use crate::simulate::truth::TrueKind;
use crate::units::spell;

/// The habits that are taken where none are given, and the example that is printed: every field, with its meaning.
pub const EXAMPLE: &str = include_str!("../../templates/habits.yaml");

/// The habits of the class of demonstrations.
const DEMO: &str = include_str!("../../templates/demo-habits.yaml");

/// Things and how often each is met, as weights >= 0 of which one at least is > 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Mix<T>(Vec<(T, f64)>);

impl<T: Copy> Mix<T> {
    /// One thing alone.
    pub fn only(thing: T) -> Self {
        Self(vec![(thing, 1.0)])
    }
    /// The thing at a share of all, `0 <= share < 1`.
    ///
    /// # Panics
    /// Never: a mix has something in it.
    pub fn at(&self, share: f64) -> T {
        let total: f64 = self.0.iter().map(|(_, w)| w).sum();
        let mut left = share * total;
        for (thing, weight) in &self.0 {
            if left < *weight {
                return *thing;
            }
            left -= weight;
        }
        // Rounding may leave a small rest: it belongs to the last thing whose weight is above 0.
        let last = self.0.iter().rev().find(|(_, w)| *w > 0.0);
        last.or(self.0.last()).map(|(t, _)| *t).expect("a mix has something in it")
    }
}

/// In which unit a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitHabit {
    /// In the unit asked, which is written.
    Asked,
    /// In another unit of the same kind.
    Other,
    /// In the unit asked, which is left out.
    Without,
}

/// Groups whose members copy from the first of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Copying {
    /// How many.
    pub groups: usize,
    /// Members of each, the first included; >= 2.
    pub size: usize,
    /// Share of the parts that they copy.
    pub share: f64,
    /// Share of the copied numbers whose last digit they change.
    pub disguise: f64,
}

/// When it is handed in.
#[derive(Debug, Clone, PartialEq)]
pub struct HandInTimes {
    /// First and due minute, counted from 1970 in the class's own time.
    pub opens: i64,
    /// Due minute.
    pub due: i64,
    /// Share of the students who are late.
    pub late: f64,
    /// By at most this many minutes, > 0.
    pub by: i64,
    /// Written behind each time, such as `+01:00`; may be empty.
    pub zone: String,
}

/// Habits of a class. Shares are from 0 to 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Habits {
    /// Share of the students who hand in nothing.
    pub absent: f64,
    /// How often a part is handed in.
    pub attempts: Mix<u32>,
    /// Share of the later attempts that are right.
    pub improves: f64,
    /// What becomes of an answer.
    pub answers: Mix<TrueKind>,
    /// Wrong methods by id, and how often each is met beside the others.
    pub methods: Vec<(String, f64)>,
    /// How often each method that is not named is met; 0: never.
    pub any_method: f64,
    /// Share of the later parts of a problem that a wrong method is carried on to.
    pub carries_on: f64,
    /// Share of the parts that are worked out from a wrong earlier part, where the bank says how.
    pub follows_on: f64,
    /// Figures of answers.
    pub figures: Mix<u32>,
    /// Figures of what is rounded on the way.
    pub on_the_way: Mix<u32>,
    /// Who copies.
    pub copying: Option<Copying>,
    /// Units.
    pub units: Mix<UnitHabit>,
    /// Share of the answers with a direction that give it by a word instead of a sign.
    pub words: f64,
    /// Share of the students who write a decimal comma.
    pub commas: f64,
    /// Written as a spreadsheet exports it where the comma is the decimal mark: byte order mark, semicolons, quoted cells.
    pub spreadsheet: bool,
    /// When; `None`: no such column.
    pub times: Option<HandInTimes>,
}

const UNITS: [(&str, UnitHabit); 3] =
    [("asked", UnitHabit::Asked), ("other", UnitHabit::Other), ("none", UnitHabit::Without)];

const YES_OR_NO: [(&str, bool); 4] = [("yes", true), ("no", false), ("true", true), ("false", false)];

/// Most figures that can be asked for.
const MOST_FIGURES: u32 = 15;
/// Most attempts at a part.
const MOST_ATTEMPTS: u32 = 20;

impl Habits {
    /// Those of [`EXAMPLE`].
    pub fn usual() -> Self {
        Self::built_in(EXAMPLE)
    }
    /// Those of the class of demonstrations: everything that may become of an answer is met.
    pub fn demo() -> Self {
        Self::built_in(DEMO)
    }

    /// # Panics
    /// It cannot be read: a bug, found by any test.
    fn built_in(text: &str) -> Self {
        match Self::read(text, "habits.yaml") {
            Ok(habits) => habits,
            Err(faults) => panic!("the built-in habits cannot be read: {faults:?}"),
        }
    }

    /// Reads a file of habits. A field that is left out is nobody's habit; `answers` must be there.
    /// Errors: all that is wrong with it, in the order of the file.
    pub fn read(text: &str, file: &str) -> Result<Self, Findings> {
        let tree = yaml::tree(text).map_err(|f| f.in_file(file))?;
        let faults = Faults::default();
        let habits = habits(&tree, &faults);
        if habits.is_none() && faults.is_empty() {
            faults.at(&tree, "these are no habits");
        }
        habits.filter(|_| faults.is_empty()).ok_or_else(|| faults.into_sorted(file))
    }

    /// Ids of wrong methods that are named and that `known` does not have, each with what may have been meant.
    pub fn unknown_methods<'a>(&'a self, known: &[&str]) -> impl Iterator<Item = (&'a str, Option<String>)> {
        let known: Vec<String> = known.iter().map(|k| (*k).to_owned()).collect();
        self.methods.iter().filter_map(move |(id, _)| {
            let strange = !known.contains(id);
            strange.then(|| (id.as_str(), spell::did_you_mean(id, known.iter().map(String::as_str))))
        })
    }
}

fn habits(tree: &Node, faults: &Faults) -> Option<Habits> {
    let mut fields = Fields::open(tree, "habits (answers, figures, units, ...)", faults)?;
    let title = fields.get("title");
    if let Some(n) = title
        && n.text().is_none()
    {
        faults.at(n, format!("expected a title, found {}", n.kind()));
    }
    let part = |n: &Node, f: &Faults| Some(share(n, f));
    let kind = |name: &str| {
        TrueKind::DECLARED.iter().copied().find(|k| k.as_str() == name).ok_or_else(|| {
            let known = TrueKind::DECLARED.iter().map(|k| k.as_str());
            let near = spell::did_you_mean(name, known.clone());
            near.unwrap_or_else(|| format!("the kinds are {}", known.collect::<Vec<_>>().join(", ")))
        })
    };
    let unit = |name: &str| {
        let found = UNITS.iter().find(|(u, _)| *u == name).map(|(_, w)| *w);
        found.ok_or_else(|| "the ways are asked, other, none".to_owned())
    };
    let answers = fields.need("answers", "{right: 70, wrong method: 30}");
    let answers = answers.and_then(|n| mix(n, "kinds of answers", faults, &kind));
    let (any_method, methods) = fields.get("wrong methods").map_or((1.0, Vec::new()), |n| methods(n, faults));
    let attempts = |n: &Node, f: &Faults| counts(n, "attempts", MOST_ATTEMPTS, f);
    let figures = |n: &Node, f: &Faults| counts(n, "figures", MOST_FIGURES, f);
    // A field that is there and cannot be read is a finding already.
    Some(Habits {
        absent: fields.read("absent", part).unwrap_or(0.0),
        attempts: fields.read("attempts", attempts).unwrap_or(Mix::only(1)),
        improves: fields.read("improves", part).unwrap_or(0.0),
        answers: answers.unwrap_or(Mix::only(TrueKind::Right)),
        methods,
        any_method,
        carries_on: fields.read("carries on", part).unwrap_or(0.0),
        follows_on: fields.read("follows on", part).unwrap_or(0.0),
        figures: fields.read("figures", figures).unwrap_or(Mix::only(4)),
        on_the_way: fields.read("figures on the way", figures).unwrap_or(Mix::only(3)),
        copying: fields.read("copying", copying),
        units: fields
            .read("units", |n, f| mix(n, "ways of writing units", f, &unit))
            .unwrap_or(Mix::only(UnitHabit::Asked)),
        words: fields.read("direction by word", part).unwrap_or(0.0),
        commas: fields.read("decimal commas", part).unwrap_or(0.0),
        spreadsheet: fields.read("spreadsheet", |n, f| choice(n, &YES_OR_NO, f)).unwrap_or(false),
        times: fields.read("handed in", times),
    })
}

/// `5 %` or `0.05`; 0 where it is none.
fn share(node: &Node, faults: &Faults) -> f64 {
    course::share_of(node, "a share", faults).unwrap_or(0.0)
}

/// A number >= 0 that is held against those beside it; a `%` behind it is no fault.
fn weight(node: &Node, faults: &Faults) -> f64 {
    let text = node.text().unwrap_or("").trim();
    match text.trim_end_matches('%').trim_end().parse::<f64>() {
        Ok(weight) if weight >= 0.0 && weight.is_finite() => weight,
        _ => {
            let hint = "a number from 0 on; only how it compares with the others counts";
            faults.expected(node, "how often", hint).unwrap_or(0.0)
        }
    }
}

/// `{right: 70, blank: 5}`; `find` says what a name means, or what is known.
fn mix<T: Copy>(
    node: &Node,
    what: &str,
    faults: &Faults,
    find: &dyn Fn(&str) -> Result<T, String>,
) -> Option<Mix<T>> {
    let before = faults.count();
    let mut list = Vec::new();
    for (name, key, value) in named(node, &format!("{what} and how often each is met"), faults) {
        let weight = weight(value, faults);
        match find(name) {
            Ok(thing) => list.push((thing, weight)),
            Err(hint) => faults.hint(key, format!("`{}` is none of the {what}", shorten(name)), hint),
        }
    }
    if faults.count() > before {
        return None;
    }
    if !list.iter().any(|(_, w)| *w > 0.0) {
        return faults.refuse_with(node, "nothing here is ever met", "give one of them a number above 0");
    }
    Some(Mix(list))
}

/// `{3: 20, 4: 80}`, or one number alone.
fn counts(node: &Node, what: &str, most: u32, faults: &Faults) -> Option<Mix<u32>> {
    let number = |text: &str| match text.trim().parse::<u32>() {
        Ok(n) if (1..=most).contains(&n) => Ok(n),
        _ => Err(format!("a whole number from 1 to {most}")),
    };
    match &node.value {
        Value::Text(text) => match number(text) {
            Ok(n) => Some(Mix::only(n)),
            Err(hint) => {
                faults.refuse_with(node, format!("`{}` is no number of {what}", shorten(text)), hint)
            }
        },
        _ => mix(node, &format!("numbers of {what}"), faults, &number),
    }
}

/// `{any: 1, A05: 6}`: how often methods are met that are not named, and those that are.
fn methods(node: &Node, faults: &Faults) -> (f64, Vec<(String, f64)>) {
    let mut any = 0.0;
    let mut list = Vec::new();
    for (name, _, value) in named(node, "wrong methods and how often each is met", faults) {
        let weight = weight(value, faults);
        if name == "any" { any = weight } else { list.push((name.to_owned(), weight)) }
    }
    if any <= 0.0 && !list.iter().any(|(_, w)| *w > 0.0) {
        faults.hint(node, "no wrong method is ever met", "`any: 1` takes those of the bank");
    }
    (any, list)
}

fn copying(node: &Node, faults: &Faults) -> Option<Copying> {
    let mut fields = Fields::open(node, "who copies (groups, size, share, disguise)", faults)?;
    let count = |node: Option<&Node>, least: u32| {
        node.and_then(|n| whole(n, least, 1_000_000, faults)).map_or(least as usize, |n| n as usize)
    };
    let groups = count(fields.need("groups", "2"), 0);
    let size = count(fields.get("size"), 2);
    let part = fields.need("share", "60 %").map_or(0.0, |n| share(n, faults));
    let disguise = fields.get("disguise").map_or(0.0, |n| share(n, faults));
    Some(Copying { groups, size, share: part, disguise })
}

fn times(node: &Node, faults: &Faults) -> Option<HandInTimes> {
    let mut fields = Fields::open(node, "times (opens, due, late, by at most, zone)", faults)?;
    let minute = |node: Option<&Node>| {
        let node = node?;
        let found = time::parse(node.text().unwrap_or("")).filter(|m| !(m.whole_day || m.zoned));
        let found = found.filter(|m| !m.uncertain).map(|m| m.micros[0].div_euclid(MINUTE));
        found.or_else(|| faults.expected(node, "a time", "such as 2026-03-06 18:00"))
    };
    let opens = minute(fields.need("opens", "2026-03-02 08:00"));
    let due_node = fields.need("due", "2026-03-06 18:00");
    let due = minute(due_node);
    let late = fields.get("late").map_or(0.0, |n| share(n, faults));
    let by = fields.get("by at most").map_or(24 * 60, |n| {
        let found = course::span(n.text().unwrap_or("")).map(|micros| micros / MINUTE);
        let found = found.filter(|minutes| *minutes > 0);
        found.or_else(|| faults.expected(n, "a time span", "such as `36 h` or `2 d`")).unwrap_or(1)
    });
    let zone = fields.get("zone").map_or_else(String::new, |n| {
        let text = n.text().unwrap_or("").trim();
        let signed = text.starts_with(['+', '-']) && Zone::named(text).is_some();
        if text != "Z" && !signed {
            faults.hint(n, format!("`{}` is no offset from UTC", shorten(text)), "`+01:00` or `Z`");
        }
        text.to_owned()
    });
    let (opens, due) = (opens?, due?);
    if let Some(node) = due_node
        && due <= opens
    {
        faults.at(node, "it is due before it opens");
    }
    Some(HandInTimes { opens, due, late, by, zone })
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "weights are taken as they are")]
mod tests {
    use super::*;

    #[test]
    fn a_mix_is_met_by_its_weights() {
        let mix = Mix(vec![('a', 0.0), ('b', 1.0), ('c', 3.0), ('d', 0.0)]);
        let met: String = (0..8).map(|i| mix.at(f64::from(i) / 8.0)).collect();
        assert_eq!(met, "bbcccccc");
        assert_eq!(mix.at(0.999_999_999_999), 'c');
        assert_eq!(mix.at(1.0), 'c');
    }

    #[test]
    fn the_example_says_every_field() {
        let habits = Habits::usual();
        assert!(habits.copying.is_some() && habits.times.is_some() && habits.absent > 0.0);
        assert_eq!(habits.answers.0.len(), TrueKind::DECLARED.len());
        assert!(habits.any_method > 0.0 && !habits.methods.is_empty());
    }

    #[test]
    fn what_is_left_out_is_nobodys_habit() {
        let habits = Habits::read("answers: {right: 1}", "h.yaml").unwrap();
        assert_eq!((habits.absent, habits.commas, habits.follows_on), (0.0, 0.0, 0.0));
        assert_eq!((habits.figures, habits.on_the_way), (Mix::only(4), Mix::only(3)));
        assert!(habits.copying.is_none() && habits.times.is_none() && !habits.spreadsheet);
    }
}
