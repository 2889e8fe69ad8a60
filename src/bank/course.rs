//! The settings that bear on marks, as `grading:` in a bank or as a course file over it: text to [`Policy`].
use crate::bank::decimal::Decimal;
use crate::bank::node::{Faults, Fields, Node, Value, choice, named, shorten, text, whole};
use crate::bank::{measure, yaml};
use crate::finding::Findings;
use crate::policy::{
    Correction, Counts, DAY, For, HOUR, Hints, MINUTE, Per, Policy, PolicyPart, Rounding, RoundingWay,
    Unread, Zone, time,
};

/// What a course file may hold, with an explanation of each setting; it is read by a test.
pub const EXAMPLE: &str = include_str!("../../templates/course.yaml");

const DATES: [(&str, bool); 2] = [("day first", true), ("month first", false)];

/// Most points of a part.
const MOST_POINTS: f64 = 1e6;

/// Reads a course file; what it does not name stays as in `base`, the settings of the bank. Errors: all that is wrong with it.
pub fn course(text: &str, file: &str, base: &Policy) -> Result<Policy, Findings> {
    let tree = yaml::tree(text).map_err(|f| f.in_file(file))?;
    let faults = Faults::default();
    let policy = read(&tree, base, &faults);
    faults.into_sorted(file).into_result(policy)
}

/// Reads the settings of a node over `base`.
pub fn read(node: &Node, base: &Policy, faults: &Faults) -> Policy {
    let mut policy = base.clone();
    if matches!(node.value, Value::Empty) {
        return policy;
    }
    let Some(mut fields) = Fields::open(node, "settings (due, attempts, late, credit, ...)", faults) else {
        return policy;
    };
    fields.set("course", &mut policy.title, |n, f| text(n, "a title", f));
    // The zone and the order of day and month first: the dates need them.
    fields.set("time zone", &mut policy.zone, zone);
    fields.set("dates", &mut policy.day_first, |n, f| choice(n, &DATES, f).map(Some));
    let dates = (policy.zone.clone(), policy.day_first);
    fields.set("due", &mut policy.due, |n, f| moment(n, &dates, f).map(Some));
    let due = policy.due;
    fields.set("extensions", &mut policy.extensions, |n, f| Some(extensions(n, due, &dates, f)));
    if let Some(n) = fields.get("attempts") {
        attempts(n, &mut policy, faults);
    }
    if let Some(n) = fields.get("late") {
        late(n, &mut policy, &dates, faults);
    }
    if let Some(n) = fields.get("credit") {
        credit(n, &mut policy, faults);
    }
    fields.set("hints", &mut policy.hints, |n, f| choice(n, Hints::WORDS, f));
    fields.set("points", &mut policy.points, |n, f| Some(points_by_part(n, f)));
    fields.set("drop lowest", &mut policy.drop_lowest, |n, f| whole(n, 0, 100, f).map(|n| n as usize));
    fields.set("round", &mut policy.rounding, |n, f| Some(rounding(n, f)));
    fields.set("corrections", &mut policy.corrections, |n, f| Some(corrections(n, f)));
    if let (Some(due), Some(closes)) = (policy.due, policy.late.closes)
        && closes < due
        && (base.due, base.late.closes) != (policy.due, policy.late.closes)
    {
        let at = node.field("late").or_else(|| node.field("due")).unwrap_or(node);
        faults.hint(at, "`closes` is before `due`", "a time after it");
    }
    policy
}

fn extensions(node: &Node, due: Option<i64>, dates: &Dates, faults: &Faults) -> Vec<(String, i64)> {
    let mut list = Vec::new();
    for (id, _, value) in named(node, "times by student id", faults) {
        let Some(at) = moment(value, dates, faults) else { continue };
        if due.is_some_and(|due| at < due) {
            faults.hint(value, "an extension that ends before the answers are due", "a time after `due`");
        }
        list.push((id.to_owned(), at));
    }
    list
}

fn points_by_part(node: &Node, faults: &Faults) -> Vec<(PolicyPart, f64)> {
    let mut list = Vec::new();
    for (name, key, value) in named(node, "points by part", faults) {
        let Some(part) = part(name, key, faults) else { continue };
        if part.part.is_none() {
            let message = format!("`{}` names a whole problem", shorten(name));
            faults.hint(key, message, "such as `1.omega: 2`");
        }
        list.extend(points(value, faults).map(|points| (part, points)));
    }
    list
}

fn attempts(node: &Node, policy: &mut Policy, faults: &Faults) {
    let attempts = &mut policy.attempts;
    if node.text().is_some() {
        attempts.counts = choice(node, Counts::WORDS, faults).unwrap_or(attempts.counts);
        return;
    }
    let what = "`last`, `best`, `first` or fields (count, at most, penalty, least)";
    let Some(mut fields) = Fields::open(node, what, faults) else { return };
    fields.set("count", &mut attempts.counts, |n, f| choice(n, Counts::WORDS, f));
    fields.set("at most", &mut attempts.at_most, |n, f| whole(n, 1, 100, f).map(Some));
    fields.set("penalty", &mut attempts.penalty, share);
    fields.set("least", &mut attempts.least, share);
}

fn late(node: &Node, policy: &mut Policy, dates: &Dates, faults: &Faults) {
    let what = "fields (penalty, per, at most, grace, closes, unread)";
    let Some(mut fields) = Fields::open(node, what, faults) else { return };
    let late = &mut policy.late;
    fields.set("penalty", &mut late.penalty, share);
    fields.set("per", &mut late.per, |n, f| choice(n, Per::WORDS, f));
    fields.set("at most", &mut late.most, share);
    fields.set("grace", &mut late.grace, duration);
    fields.set("closes", &mut late.closes, |n, f| moment(n, dates, f).map(Some));
    fields.set("unread", &mut late.unread, |n, f| choice(n, Unread::WORDS, f).map(Some));
    if let Some(n) = node.field("penalty")
        && late.penalty > 0.0
        && policy.due.is_none()
        && policy.extensions.is_empty()
    {
        faults.hint(n, "a late penalty, and nothing is due", "for example `due: 2026-03-09 23:59`");
    }
}

fn credit(node: &Node, policy: &mut Policy, faults: &Faults) {
    for (name, key, value) in named(node, "shares (follow through, wrong methods, or ids of methods)", faults)
    {
        let Some(share) = share(value, faults) else { continue };
        match name {
            "follow through" => policy.credit.follow = share,
            "wrong methods" => policy.credit.methods = share,
            id if id.len() <= 48 && id.chars().all(|c| c.is_ascii_alphanumeric() || c == '-') => {
                policy.credit.by_method.retain(|(m, _)| m != id);
                policy.credit.by_method.push((id.to_owned(), share));
            }
            other => faults.hint(
                key,
                format!("`{}` earns no credit", shorten(other)),
                "`follow through`, `wrong methods` or the id of a wrong method such as `A05`",
            ),
        }
    }
}

fn rounding(node: &Node, faults: &Faults) -> Option<Rounding> {
    let step = |n: &Node| {
        let found = number(n).filter(|x| *x > 0.0 && *x <= 1000.0);
        found.or_else(|| faults.expected(n, "a step of totals", "for example 0.5"))
    };
    if node.text().is_some() {
        return Some(Rounding { to: step(node)?, way: RoundingWay::Nearest });
    }
    let mut fields = Fields::open(node, "a step such as 0.5, or fields (to, way)", faults)?;
    let to = fields.need("to", "0.5").and_then(step);
    let way = fields.read("way", |n, f| choice(n, RoundingWay::WORDS, f)).unwrap_or(RoundingWay::Nearest);
    Some(Rounding { to: to?, way })
}

fn corrections(node: &Node, faults: &Faults) -> Vec<Correction> {
    let Value::List(items) = &node.value else {
        let hint = "`- {part: 2.v, give: full, why: part 2 was ambiguous}`";
        return faults.expected(node, "a list of corrections", hint).unwrap_or_default();
    };
    items.iter().filter_map(|item| correction(item, faults)).collect()
}

fn correction(node: &Node, faults: &Faults) -> Option<Correction> {
    let mut fields = Fields::open(node, "a correction (part, give, to, why)", faults)?;
    let part = fields.need("part", "2.v");
    let give = fields.get("give");
    let to = fields.read("to", |n, f| choice(n, For::WORDS, f));
    let why = fields.need("why", "part 2 was ambiguous").and_then(|n| text(n, "a reason", faults));
    let share = match give {
        None => Some(1.0),
        Some(n) if n.text().is_some_and(|t| t.trim() == "full") => Some(1.0),
        Some(n) => share(n, faults),
    };
    let part = part.and_then(|n| self::part(n.text().unwrap_or("").trim(), n, faults));
    Some(Correction { part: part?, share: share?, to: to.unwrap_or(For::All), why: why? })
}

/// `1.omega`, `pulled-rolling.omega`, `1`.
fn part(name: &str, at: &Node, faults: &Faults) -> Option<PolicyPart> {
    let (problem, part) = match name.split_once('.') {
        Some((problem, part)) => (problem.trim(), Some(part.trim())),
        None => (name.trim(), None),
    };
    if problem.is_empty() || part == Some("") {
        let hint = "number or id of the problem, a point, id of the part: `1.omega`";
        return faults.refuse_with(at, format!("`{}` is no part of a problem", shorten(name)), hint);
    }
    Some(PolicyPart { problem: problem.to_owned(), part: part.map(str::to_owned), at: (at.line, at.column) })
}

fn zone(node: &Node, faults: &Faults) -> Option<Zone> {
    let hint = "a place such as `Europe/Berlin`, or an offset such as `+01:00`";
    node.text().and_then(Zone::named).or_else(|| faults.expected(node, "a time zone", hint))
}

/// The zone of times that name none, and whether the day comes first in dates.
type Dates = (Zone, Option<bool>);

fn moment(node: &Node, (zone, day_first): &Dates, faults: &Faults) -> Option<i64> {
    let text = node.text().unwrap_or("");
    let order = usize::from(*day_first == Some(false));
    let certain = |m: &time::Moment| m.micros[0] == m.micros[1] || day_first.is_some();
    let shown = time::parse(text).filter(|m| certain(m) && text.contains(':'));
    let Some((shown, read)) = shown.and_then(|shown| Some((shown, zone.read(text)?))) else {
        let hint = "for example `2026-03-09 23:59`, or `2026-03-09T23:59+01:00`";
        return faults.expected(node, "a date with the time of day", hint);
    };
    if !shown.zoned && zone.skips(shown.micros[order]) {
        let message = format!("there is no such time in {}: {}", zone.name(), node.kind());
        return faults.refuse_with(node, message, "clocks are put forward over it");
    }
    let at = read.micros[order];
    // 23:59 includes its last second, unless seconds are written.
    let clock = text.trim().split(['T', 't', ' ']).find(|t| t.contains(':')).unwrap_or("");
    let clock = clock.split(['+', '-', 'Z', 'z']).next().unwrap_or("");
    let seconds = clock.matches(':').count() > 1;
    Some(if seconds { at } else { at + MINUTE - 1 })
}

fn duration(node: &Node, faults: &Faults) -> Option<i64> {
    let found = span(node.text().unwrap_or(""));
    found.or_else(|| faults.expected(node, "a time span", "for example `10 min` or `2 h`"))
}

/// `10 min`, `2 h`, `3 days`, or 0, in microseconds.
pub fn span(text: &str) -> Option<i64> {
    let text = text.trim();
    let (number, unit) = text.split_at(text.find(char::is_alphabetic).unwrap_or(text.len()));
    let unit = match unit.trim() {
        "min" | "minute" | "minutes" => MINUTE,
        "h" | "hour" | "hours" => HOUR,
        "d" | "day" | "days" => DAY,
        _ => return (text == "0").then_some(0),
    };
    number.trim().parse::<i64>().ok().filter(|n| (0..=100_000).contains(n)).map(|n| n * unit)
}

fn number(node: &Node) -> Option<f64> {
    Decimal::parse(node.text()?.trim()).map(|d| d.f64())
}

/// `25 %` or `0.25` of the points.
fn share(node: &Node, faults: &Faults) -> Option<f64> {
    share_of(node, "a share of the points", faults)
}

/// `25 %` or `0.25` of something: 0 to 1.
pub fn share_of(node: &Node, what: &str, faults: &Faults) -> Option<f64> {
    let found = Decimal::share(node.text().unwrap_or("")).ok().filter(|x| (0.0..=1.0).contains(x));
    found.or_else(|| faults.expected(node, what, "from `0 %` to `100 %`"))
}

fn points(node: &Node, faults: &Faults) -> Option<f64> {
    measure::limit(node, ("points", 0.0, MOST_POINTS), faults)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_example_is_read() {
        // As it stands it switches nothing on; without `#: ` every setting.
        assert_eq!(course(EXAMPLE, "course.yaml", &Policy::default()).unwrap(), Policy::default());
        let full = EXAMPLE.replace("\n#: ", "\n");
        let policy = course(&full, "course.yaml", &Policy::default()).unwrap();
        assert_eq!(policy.attempts.counts, Counts::Best);
        assert_eq!(policy.zone.shown(policy.due.unwrap()), "2026-03-09 23:59");
        assert_eq!(policy.corrections.len(), 1);
        assert!(policy.timed() && policy.attempts.ordered());
        // Without a word of it the bank's settings stay.
        assert_eq!(course("", "course.yaml", &policy).unwrap(), policy);
    }

    #[test]
    fn all_faults_come_at_once_with_their_places() {
        let text = "\
due: tomorrow
time zone: CET
attempts: {count: worst, at most: 0, penalty: 200 %}
late: {penalty: 10 %, per: week, grace: soon, closes: 2026-03-09}
credit: {follow: half, 'A 5': 1}
hints: all
points: {1: 2, 1.omega: many, .v: 1}
drop lowest: -1
round: {way: sideways}
corrections: [{part: 1.v}, 3]
extension: {}
";
        let told: Vec<String> = course(text, "course.yaml", &Policy::default())
            .unwrap_err()
            .iter()
            .map(ToString::to_string)
            .collect();
        insta::assert_snapshot!(told.join("\n"), @r"
        course.yaml:1:6: due: expected a date with the time of day, found `tomorrow`
            hint: for example `2026-03-09 23:59`, or `2026-03-09T23:59+01:00`
        course.yaml:2:12: time zone: expected a time zone, found `CET`
            hint: a place such as `Europe/Berlin`, or an offset such as `+01:00`
        course.yaml:3:19: attempts.count: expected `last` or `best` or `first`, found `worst`
        course.yaml:3:35: attempts.at most: expected a whole number from 1 to 100, found `0`
        course.yaml:3:47: attempts.penalty: expected a share of the points, found `200 %`
            hint: from `0 %` to `100 %`
        course.yaml:4:17: late.penalty: a late penalty, and nothing is due
            hint: for example `due: 2026-03-09 23:59`
        course.yaml:4:28: late.per: expected `day` or `hour` or `once`, found `week`
        course.yaml:4:41: late.grace: expected a time span, found `soon`
            hint: for example `10 min` or `2 h`
        course.yaml:4:55: late.closes: expected a date with the time of day, found `2026-03-09`
            hint: for example `2026-03-09 23:59`, or `2026-03-09T23:59+01:00`
        course.yaml:5:18: credit.follow: expected a share of the points, found `half`
            hint: from `0 %` to `100 %`
        course.yaml:5:24: credit.A 5: `A 5` earns no credit
            hint: `follow through`, `wrong methods` or the id of a wrong method such as `A05`
        course.yaml:6:8: hints: expected `none` or `nudge` or `explain`, found `all`
        course.yaml:7:10: points.1: `1` names a whole problem
            hint: such as `1.omega: 2`
        course.yaml:7:25: points.1.omega: expected points from 0 to 1000000, found `many`
        course.yaml:7:31: points..v: `.v` is no part of a problem
            hint: number or id of the problem, a point, id of the part: `1.omega`
        course.yaml:8:14: drop lowest: expected a whole number from 0 to 100, found `-1`
        course.yaml:9:8: round: `to` is missing
            hint: for example `to: 0.5`
        course.yaml:9:14: round.way: expected `nearest` or `up` or `down`, found `sideways`
        course.yaml:10:15: corrections[0]: `why` is missing
            hint: for example `why: part 2 was ambiguous`
        course.yaml:10:28: corrections[1]: expected a correction (part, give, to, why), found `3`
        course.yaml:11:1: extension: unknown field `extension`
            hint: did you mean `extensions`?
        ");
    }
}
