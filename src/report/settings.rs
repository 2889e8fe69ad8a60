//! The settings of a course in words, as the class report prints them.
use crate::policy::{Attempts, DAY, For, HOUR, Late, MINUTE, Policy};
use crate::report::table::{percent, points};
use crate::words::Words;

/// Name and value of each setting; what does not apply is said so where an instructor would ask.
pub fn in_words(policy: &Policy, words: &Words) -> Vec<(String, String)> {
    let teller = SettingsTeller { policy, words };
    let say = |name: &str, pieces: &[(&str, &str)]| teller.say(name, pieces);
    let share = |share: f64| words.number(&percent(share));
    let number = |value: f64| words.number(&points(value));
    let (zone, credit) = (&policy.zone, &policy.credit);
    let mut list: Vec<(String, String)> = Vec::new();
    let mut add = |name: &str, value: String| list.push((say(name, &[]), value));
    let no_date = || say("no_date", &[]);
    add("due", policy.due.map_or_else(no_date, |due| format!("{} ({})", zone.shown(due), zone.name())));
    if let Some(day_first) = policy.day_first {
        add("dates", say(if day_first { "day_first" } else { "month_first" }, &[]));
    }
    match policy.extensions.len() {
        0 => {}
        1 => add("extensions", say("students_one", &[])),
        n => add("extensions", say("students", &[("n", &n.to_string())])),
    }
    add("attempts", teller.attempts(&policy.attempts));
    add("late", teller.late(&policy.late));
    let points_for = |share_given: f64, name: &str| match share_given > 0.0 {
        true if name.is_empty() => share(share_given),
        true => say(name, &[("share", &share(share_given))]),
        false => say("no_points", &[]),
    };
    add("follow", points_for(credit.follow, "follows"));
    let mut methods = points_for(credit.methods, "");
    for (id, given) in &credit.by_method {
        methods.push_str(&format!("; {id}: {}", share(*given)));
    }
    add("methods", methods);
    add("hints", say(&format!("hint.{}", policy.hints.as_str()), &[]));
    if !policy.points.is_empty() {
        let all = policy.points.iter().map(|(part, n)| format!("{}: {}", part.text(), number(*n)));
        add("points", say("as_in_bank", &[("list", &all.collect::<Vec<_>>().join(", "))]));
    }
    match policy.drop_lowest {
        0 => {}
        1 => add("dropped", say("weakest_one", &[])),
        n => add("dropped", say("weakest", &[("n", &n.to_string())])),
    }
    let not_rounded = || say("not_rounded", &[]);
    add(
        "totals",
        policy.rounding.map_or_else(not_rounded, |rounding| {
            say(&format!("round.{}", rounding.way.as_str()), &[("to", &number(rounding.to))])
        }),
    );
    for correction in &policy.corrections {
        let to = match correction.to {
            For::All => "to_all",
            For::Answered => "to_answered",
        };
        let what = say(to, &[("share", &share(correction.share))]);
        let what = match correction.why.as_str() {
            "" => what,
            why => say("because", &[("what", &what), ("why", why)]),
        };
        list.push((say("correction", &[("part", &correction.part.text())]), what));
    }
    list
}

struct SettingsTeller<'t> {
    policy: &'t Policy,
    words: &'t Words,
}

impl SettingsTeller<'_> {
    fn say(&self, name: &str, pieces: &[(&str, &str)]) -> String {
        self.words.say(&format!("report.setting.{name}"), pieces)
    }

    fn share(&self, name: &str, share: f64) -> String {
        self.say(name, &[("share", &self.words.number(&percent(share)))])
    }

    fn attempts(&self, attempts: &Attempts) -> String {
        let mut text = self.say(&format!("counts.{}", attempts.counts.as_str()), &[]);
        if let Some(most) = attempts.at_most {
            text.push_str(&self.say("at_most", &[("n", &most.to_string())]));
        }
        if attempts.penalty > 0.0 {
            text.push_str(&self.share("each_earlier", attempts.penalty));
            if attempts.least > 0.0 {
                text.push_str(&self.share("least", attempts.least));
            }
        }
        text
    }

    fn late(&self, late: &Late) -> String {
        let mut text = self.say("no_penalty", &[]);
        if late.penalty > 0.0 {
            text = self.share(&format!("per.{}", late.per.as_str()), late.penalty);
            if late.most < 1.0 {
                text.push_str(&self.share("most", late.most));
            }
            if late.grace > 0 {
                text.push_str(&self.say("grace", &[("time", &self.lasting(late.grace))]));
            }
        }
        if let Some(closes) = late.closes {
            text.push_str(&self.say("closes", &[("date", &self.policy.zone.shown(closes))]));
        }
        if let Some(unread) = late.unread {
            text.push_str(&self.say(&format!("unread.{}", unread.as_str().replace(' ', "_")), &[]));
        }
        text
    }

    /// `10 min`, `2 h`, `1 day`
    fn lasting(&self, micros: i64) -> String {
        match micros {
            DAY => self.say("one_day", &[]),
            t if t % DAY == 0 => self.words.say("report.days", &[("n", &(t / DAY).to_string())]),
            t if t % HOUR == 0 => format!("{} h", t / HOUR),
            t => format!("{} min", self.words.number(&points(t as f64 / MINUTE as f64))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::course;

    #[test]
    fn the_example_of_a_course_is_told_whole() {
        let policy =
            course::course(&course::EXAMPLE.replace("\n#: ", "\n"), "course.yaml", &Policy::default())
                .unwrap();
        let told: Vec<String> =
            in_words(&policy, &Words::english()).into_iter().map(|(n, v)| format!("{n}: {v}")).collect();
        let told = told.join("\n").replace('\u{a0}', " ");
        for line in [
            "Due: 2026-03-09 23:59 (Europe/Berlin)",
            "Dates: the day comes first",
            "Extensions: 1 student",
            "Attempts: the best counts, of at most 3, 10 % less for each earlier one, at least 50 % left",
            "Late: 10 % less for each begun day, at most 50 %, after a grace of 10 min; nothing counts after 2026-03-16 23:59; what has no time that can be read is taken as in time",
            "Follow-through: 50 % for what follows from one's own wrong answer",
            "Known wrong methods: no points; A05: 25 %",
            "Hints to students: nudge",
            "Points: as in the bank, but 1.omega: 2",
            "Dropped: the weakest problem",
            "Totals: rounded nearest to 0.5",
            "Correction of 1.v: at least 100 % of the points to all: part 1.v was ambiguous",
        ] {
            assert!(told.contains(line), "{line}\n{told}");
        }
        assert!(
            in_words(&Policy::default(), &Words::english()).iter().any(|(n, v)| n == "Due" && v == "no date")
        );
    }
}
