//! What one student gets back: each part with the answer, the verdict, the points and, at the level that the course sets, a hint.
//! Nothing of the key, nothing of anybody else.
//!
//! The template `feedback.md` receives `title`, `name`, `student`, `set`, `total` (`14 of 20 points`), `notes` (what does not
//! count, or nothing handed in) and `problems`: a list of `number`, `title`, `points` and `parts`, each with `sign`, `name`
//! (`1.omega`), `asked`, `verdict`, `points`, `answer`, `reason`, `credit` and `hints` (lists of lines).
use crate::finding::{Finding, push_new};
use crate::grade::row::AnswerRow;
use crate::grade::verdict::Verdict;
use crate::misconception::catalogue::Catalogue;
use crate::policy::Hints;
use crate::report::marks::Marks;
use crate::report::table;
use crate::sheet::document::{Document, Head};
use crate::template::{self, Templates, Value, View};
use crate::words::Words;
use crate::words::plain::{capital, in_places};

/// What is the same for all students.
pub struct FeedbackWriter<'d> {
    pub marks: &'d Marks,
    /// Title of the course or bank, in the language of the feedback.
    pub title: &'d str,
    /// Name of the set.
    pub set: &'d str,
    /// Words of the language.
    pub words: &'d Words,
    /// Templates of the language.
    pub templates: &'d Templates,
    /// Words about wrong methods, in the language.
    pub catalogue: &'d Catalogue,
    /// How much is said of them.
    pub hints: Hints,
    /// Why a part was corrected: part (index), reason.
    pub corrections: &'d [(usize, String)],
}

impl FeedbackWriter<'_> {
    /// The feedback of a student. Errors: faults of the template.
    pub fn document(&self, student: usize) -> Result<(Head, Document), Finding> {
        let who = &self.marks.class.students[student];
        let dropped = self.marks.dropped.get(student).map_or(&[][..], Vec::as_slice);
        let head = Head {
            title: self.title.to_owned(),
            name: who.name.clone(),
            student: who.student.clone(),
            set: self.set.to_owned(),
            code: String::new(),
        };
        let mut view = View::new();
        view.foreign("title", self.title);
        view.foreign("name", &who.name);
        view.foreign("student", &who.student);
        view.foreign("set", self.set);
        let (points, of) = self.marks.totals[student];
        view.text("total", &self.points(points, of));
        view.value("notes", list(self.notes(student, dropped)));
        let problems = (0..self.marks.class.problems.len()).map(|i| self.problem(student, i, dropped));
        view.value("problems", template::list(problems));
        let markdown = self.templates.markdown("feedback.md", &view)?;
        Ok((head, Document::new(markdown, Vec::new())))
    }

    fn points(&self, n: f64, of: f64) -> String {
        let number = |v: f64| self.words.number(&table::points(v));
        if number(of) == "1" {
            return self.words.say("marks.one_point", &[("n", &number(n))]);
        }
        self.words.say("marks.points", &[("n", &number(n)), ("of", &number(of))])
    }

    fn notes(&self, student: usize, dropped: &[usize]) -> Vec<String> {
        let mut notes = Vec::new();
        if !self.marks.took_part(student) {
            let given = self.marks.totals[student].0 > 0.0;
            notes.push(self.words.get(if given { "marks.nothing_but" } else { "marks.nothing" }).to_owned());
        }
        let numbers: Vec<String> = dropped.iter().map(|i| (i + 1).to_string()).collect();
        match numbers.as_slice() {
            [] => {}
            [one] => notes.push(self.words.say("marks.dropped", &[("number", one)])),
            several => notes.push(self.words.say("marks.dropped_many", &[("numbers", &several.join(", "))])),
        }
        notes
    }

    fn problem(&self, student: usize, problem: usize, dropped: &[usize]) -> Value {
        let parts: Vec<usize> = (0..self.marks.class.parts.len())
            .filter(|p| self.marks.class.parts[*p].number == problem + 1 && self.marks.asked(student, *p))
            .collect();
        let of: f64 = parts.iter().map(|p| self.marks.class.parts[*p].points).sum();
        let points: f64 = parts.iter().map(|p| self.marks.points(student, *p)).sum();
        let mut told = self.points(points, of);
        if dropped.contains(&problem) {
            told = format!("{told}; {}", self.words.get("marks.not_counted"));
        }
        let (number, title) = ((problem + 1).to_string(), &self.marks.class.problems[problem]);
        let parts = template::list(parts.into_iter().map(|p| self.part(student, p)));
        template::with([("number", &number), ("title", title), ("points", &told)], [("parts", parts)])
    }

    fn part(&self, student: usize, part: usize) -> Value {
        let asked = &self.marks.class.parts[part];
        let row = self.marks.cell(student, part).row.as_ref();
        let points = self.marks.points(student, part);
        let verdict = row.map(|r| r.verdict);
        let right = verdict == Some(Verdict::Right);
        let (sign, name) = match verdict {
            None => ("–", "none"),
            Some(Verdict::Right) => ("✓", "right"),
            Some(Verdict::WrongDirection) => ("✗", "wrong_direction"),
            Some(Verdict::WrongDimension) => ("✗", "wrong_dimension"),
            Some(Verdict::MissingUnit) => ("✗", "missing_unit"),
            Some(Verdict::Unreadable) => ("✗", "unreadable"),
            Some(_) => ("✗", "wrong"),
        };
        // After a correction with full points nobody is told what may have gone wrong.
        let corrected =
            points >= asked.points && row.is_none_or(|r| r.credit.split(' ').any(|c| c == "correction"));
        let row_told = row.filter(|_| !right && !corrected);
        let reason = row_told.map_or_else(String::new, |r| self.reason(r));
        let mut credit: Vec<String> = row.map_or_else(Vec::new, |r| {
            r.credit.split_whitespace().filter_map(|c| self.credit(c, part)).collect()
        });
        if row.is_none() && points > 0.0 {
            credit.extend(self.credit("correction", part));
        }
        let hints = row_told.map_or_else(Vec::new, |r| self.hints(r, student, part));
        let texts = [
            ("sign", sign),
            ("name", &template::in_markdown(&asked.label())),
            ("asked", &asked.asked),
            ("verdict", self.words.get(&format!("marks.verdict.{name}"))),
            ("points", &self.points(points, asked.points)),
            ("answer", &row.map_or_else(String::new, |r| quoted(&r.answer))),
            ("reason", &sentence(&reason)),
        ];
        let credit = list(credit.iter().map(|c| sentence(c)).collect());
        template::with(texts, [("credit", credit), ("hints", list(hints))])
    }

    /// What the student is told of the reading of an answer. Of a wrong number only phrases that are known to say nothing of slips;
    /// of what could not be read the whole reason, up to what it says of credit.
    fn reason(&self, row: &AnswerRow) -> String {
        // What it says of credit comes last, and may hold anything.
        let pieces = row.reason.split("; ").take_while(|piece| !is_one_of(CREDIT, piece));
        let told: Vec<&str> = match row.verdict {
            Verdict::Wrong | Verdict::WrongDirection => pieces.filter(|p| is_one_of(READING, p)).collect(),
            _ => pieces.filter(|p| !is_one_of(SLIPS, p)).collect(),
        };
        template::in_markdown(&told.join("; "))
    }

    fn credit(&self, word: &str, part: usize) -> Option<String> {
        let (name, value) = word.split_once(':').unwrap_or((word, ""));
        let percent = || {
            let share: f64 = value.parse().unwrap_or(1.0);
            self.words.number(&format!("{} %", table::points(share * 100.0)))
        };
        let number = self.marks.class.parts[part].number;
        let full = format!("marks.credit.{name}");
        let say = |place: &str, text: &str| self.words.say(&full, &[(place, text)]);
        Some(match name {
            "methods" | "closed" => self.words.get(&full).to_owned(),
            "follow" => {
                let parts: Vec<String> =
                    value.split('+').map(|p| template::in_markdown(&format!("{number}.{p}"))).collect();
                say("part", &parts.join(self.words.get("marks.and")))
            }
            "attempt" | "late" => say("percent", &percent()),
            "correction" => match self.corrections.iter().find(|(p, _)| *p == part) {
                Some((_, why)) if !why.is_empty() => say("why", &template::in_markdown(why)),
                _ => self.words.get("marks.credit.correction_plain").to_owned(),
            },
            _ => return None,
        })
    }

    fn hints(&self, row: &AnswerRow, student: usize, part: usize) -> Vec<String> {
        if self.hints == Hints::None {
            return Vec::new();
        }
        let explains = self.hints == Hints::Explain;
        let mut told: Vec<Vec<String>> = Vec::new();
        let methods = || row.methods.split_whitespace();
        let several = methods().count() > 1;
        for entry in methods().filter_map(|id| self.catalogue.get(id)) {
            let mut lines = Vec::new();
            if explains {
                let did = self.words.say("marks.did", &[("did", &entry.did)]);
                lines.push(if several { entry.did.clone() } else { did });
                lines.push(self.words.say("marks.see", &[("see", &entry.see)]));
            }
            lines.push(self.words.say("marks.hint", &[("hint", &entry.hint)]));
            push_new(&mut told, lines);
        }
        let mut lines = if told.len() < 2 {
            told.concat()
        } else {
            // A list within the list; its items stand one below the other.
            let items = told.iter().enumerate().map(|(i, t)| format!("{}. {}", i + 1, t.join(" ")));
            vec![self.words.get("marks.one_of").to_owned(), items.collect::<Vec<_>>().join("\n  ")]
        };
        lines.extend(self.slip(row, student, part, explains));
        lines
    }

    fn slip(&self, row: &AnswerRow, student: usize, part: usize, explains: bool) -> Option<String> {
        let (name, value) = row.slip.split_once(':').unwrap_or((&*row.slip, ""));
        if !["power_of_ten", "unit", "figures", "drift", "part"].contains(&name) {
            return None;
        }
        let number = self.marks.class.parts[part].number;
        // Which part it is right for may be told only to those who know: else it would be that part's answer.
        let known = || {
            let at = self.marks.class.parts.iter().position(|p| p.number == number && p.id == value)?;
            let other = self.marks.cell(student, at).row.as_ref()?;
            (other.verdict == Verdict::Right).then(|| template::in_markdown(&format!("{number}.{value}")))
        };
        let nudge = || self.words.get(&format!("marks.slip.{name}.nudge")).to_owned();
        if !explains {
            return Some(nudge());
        }
        let full = format!("marks.slip.{name}.explain");
        Some(match name {
            "unit" => self.words.say(&full, &[("unit", &template::in_markdown(value))]),
            "figures" => self.words.say(&full, &[("n", value)]),
            "part" => known().map_or_else(nudge, |part| self.words.say(&full, &[("part", &part)])),
            _ => self.words.get(&full).to_owned(),
        })
    }
}

fn list(lines: Vec<String>) -> Value {
    template::list(lines.iter().map(|l| template::finished(l)))
}

/// An answer within quotation marks: escaped, its blanks as one.
fn quoted(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    template::in_markdown(&words.join(" "))
}

/// Begins with a capital and ends with a point.
fn sentence(text: &str) -> String {
    let mut out = capital(text);
    if !out.is_empty() && !out.ends_with(['.', '!', '?']) {
        out.push('.');
    }
    out
}

/// Phrases that tell what a wrong number has in common with the right one. They are for the instructor; the student is told of it
/// at the level of the hints.
const SLIPS: &[&str] = &["slip.power_of_ten", "slip.unit", "slip.figures", "slip.drift", "slip.other_part"];
/// Phrases that tell how a number was read, and no more of a wrong one than its verdict does.
#[rustfmt::skip] // a table
const READING: &[&str] = &[
    "other_sign", "other_word", "no_sign", "decimal_comma", "revolutions", "about", "turning", "unit_read",
    "no_direction",
];
/// Phrases that tell why the points are not all or nothing: told apart from the reason.
#[rustfmt::skip] // a table
const CREDIT: &[&str] = &[
    "credit.method", "credit.follows", "credit.attempt", "credit.late", "credit.closed",
    "credit.correction",
];

/// Is a piece of a reason one of these phrases, in any language?
fn is_one_of(phrases: &[&str], piece: &str) -> bool {
    Words::languages().filter_map(Words::built_in).any(|words| {
        phrases.iter().any(|name| in_places(words.get(&format!("feedback.{name}")), piece).is_some())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phrases_are_recognised_with_anything_in_their_places() {
        let fits = |phrase: &str, text: &str| in_places(phrase, text).is_some();
        assert!(fits(
            "the right number in {from}, given in {to}",
            "the right number in rev/min, given in rad/s"
        ));
        assert!(fits("rounded to {n} figures", "rounded to 2 figures"));
        assert!(!fits("rounded to {n} figures", "rounded to 2 figure"));
        assert!(!fits("the right word", "the right wordy"));
        for code in Words::languages() {
            let words = Words::of(code).unwrap();
            assert!(is_one_of(SLIPS, &words.say("feedback.slip.power_of_ten", &[("n", "-3")])));
            assert!(is_one_of(SLIPS, words.get("feedback.slip.drift")));
            for slip in SLIPS {
                let phrase = words.get(&format!("feedback.{slip}"));
                assert!(phrase.split("; ").all(|piece| !is_one_of(READING, piece)), "{slip}");
            }
            assert!(is_one_of(READING, words.get("feedback.decimal_comma")));
            assert!(!is_one_of(SLIPS, words.get("feedback.outside")));
            assert!(is_one_of(CREDIT, &words.say("feedback.credit.late", &[("share", "80 %")])));
            let given = words.say("feedback.credit.correction", &[("share", "100 %"), ("why", "no")]);
            assert!(is_one_of(CREDIT, &given));
            for name in ["feedback.within", "feedback.outside", "feedback.other_sign", "feedback.blank"] {
                assert!(!is_one_of(CREDIT, words.get(name)) && !is_one_of(SLIPS, words.get(name)));
            }
        }
    }

    #[test]
    fn sentences_begin_and_end() {
        assert_eq!(sentence("größer als 1"), "Größer als 1.");
        assert_eq!(sentence("Why?"), "Why?");
        assert_eq!(sentence(""), "");
    }
}
