//! The settings of a course in words, as the class report prints them.
use crate::policy::DAY;
use crate::policy::For;
use crate::policy::HOUR;
use crate::policy::MINUTE;
use crate::policy::Per;
use crate::policy::Policy;
use crate::report::table::percent;
use crate::report::table::points;

/// Name and value of each setting; what does not apply is said so where an instructor would ask.
pub fn in_words(policy: &Policy) -> Vec<(String, String)> {
    let mut list: Vec<(String, String)> = Vec::new();
    let mut add = |name: &str, value: String| list.push((name.to_owned(), value));
    let zone = policy.zone.name();
    add(
        "Due",
        match policy.due {
            Some(due) => format!("{} ({zone})", policy.zone.shown(due)),
            None => "no date".to_owned(),
        },
    );
    if let Some(day_first) = policy.day_first {
        add("Dates", if day_first { "the day comes first" } else { "the month comes first" }.to_owned());
    }
    if !policy.extensions.is_empty() {
        let n = policy.extensions.len();
        add("Extensions", format!("{n} {}", if n == 1 { "student" } else { "students" }));
    }
    let attempts = &policy.attempts;
    let mut text = format!("the {} counts", attempts.counts.as_str());
    if let Some(most) = attempts.at_most {
        text.push_str(&format!(", of at most {most}"));
    }
    if attempts.penalty > 0.0 {
        text.push_str(&format!(", {} less for each earlier one", percent(attempts.penalty)));
        if attempts.least > 0.0 {
            text.push_str(&format!(", at least {} left", percent(attempts.least)));
        }
    }
    add("Attempts", text);
    let late = &policy.late;
    let mut text = match late.per {
        _ if late.penalty <= 0.0 => "no penalty".to_owned(),
        Per::Once => format!("{} less", percent(late.penalty)),
        per => format!("{} less for each begun {}", percent(late.penalty), per.as_str()),
    };
    if late.penalty > 0.0 && late.most < 1.0 {
        text.push_str(&format!(", at most {}", percent(late.most)));
    }
    if late.penalty > 0.0 && late.grace > 0 {
        text.push_str(&format!(", after a grace of {}", lasting(late.grace)));
    }
    if let Some(closes) = late.closes {
        text.push_str(&format!("; nothing counts after {}", policy.zone.shown(closes)));
    }
    if let Some(unread) = late.unread {
        text.push_str(&format!("; what has no time that can be read is taken as {}", unread.as_str()));
    }
    add("Late", text);
    let credit = &policy.credit;
    add(
        "Follow-through",
        match credit.follow > 0.0 {
            true => format!("{} for what follows from one's own wrong answer", percent(credit.follow)),
            false => "no points".to_owned(),
        },
    );
    let mut text = match credit.methods > 0.0 {
        true => percent(credit.methods),
        false => "no points".to_owned(),
    };
    for (id, share) in &credit.by_method {
        text.push_str(&format!("; {id}: {}", percent(*share)));
    }
    add("Known wrong methods", text);
    add("Hints to students", policy.hints.as_str().to_owned());
    if !policy.points.is_empty() {
        let all: Vec<String> =
            policy.points.iter().map(|(part, n)| format!("{}: {}", part.text(), points(*n))).collect();
        add("Points", format!("as in the bank, but {}", all.join(", ")));
    }
    if policy.drop_lowest > 0 {
        let n = policy.drop_lowest;
        add(
            "Dropped",
            if n == 1 { "the weakest problem".to_owned() } else { format!("the {n} weakest problems") },
        );
    }
    add(
        "Totals",
        match policy.rounding {
            Some(rounding) => format!("rounded {} to {}", rounding.way.as_str(), points(rounding.to)),
            None => "not rounded".to_owned(),
        },
    );
    for correction in &policy.corrections {
        let to = match correction.to {
            For::All => "all",
            For::Answered => "all who answered",
        };
        let why = if correction.why.is_empty() { String::new() } else { format!(": {}", correction.why) };
        add(
            &format!("Correction of {}", correction.part.text()),
            format!("at least {} of the points to {to}{why}", percent(correction.share)),
        );
    }
    list
}

/// `10 min`, `2 h`, `1 day`
fn lasting(micros: i64) -> String {
    match micros {
        t if t % DAY == 0 => format!("{} {}", t / DAY, if t == DAY { "day" } else { "days" }),
        t if t % HOUR == 0 => format!("{} h", t / HOUR),
        t => format!("{} min", points(t as f64 / MINUTE as f64)),
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
        let told: Vec<String> = in_words(&policy).into_iter().map(|(n, v)| format!("{n}: {v}")).collect();
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
        assert!(in_words(&Policy::default()).iter().any(|(n, v)| n == "Due" && v == "no date"));
    }
}
