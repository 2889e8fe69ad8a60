//! Wrong methods as a class takes them: those of most students first, those of the same words as one.
use crate::report::class::{ClassReporter, Rich};
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::study::{LEVEL, MistakeCount};
use crate::report::table::percent;
use crate::template;
use crate::words::plain::plain;
use serde_json::{Value, json};

/// Mistakes told in words; all are in the table.
const FAVOURITES: usize = 6;
/// Parts of a mistake that are named.
const PARTS: usize = 6;

impl ClassReporter<'_> {
    /// The mistakes for the next lecture, or the name of the phrase that says why there are none. What they do, what to show them, and
    /// `also` what else was done that fits some of the answers, is finished HTML; the share of those who handed in is told where they
    /// are not few.
    pub(super) fn lecture(&self, rich: Rich) -> (Option<&'static str>, Vec<Value>) {
        let took = self.study.took_part.len();
        // What a single student did is no matter for a lecture.
        let all = self.favourites().into_iter().filter(|m| m.students() > 1).take(FAVOURITES);
        let told = all.map(|mistake| {
            let entry = mistake.ids.first().and_then(|id| self.catalogue.get(id));
            let (they, advice) = entry.map_or((String::new(), ""), |entry| advice(&entry.note));
            let share = mistake.students() as f64 / took as f64;
            json!({
                "students": mistake.students(),
                "share": (took >= LEAST_FOR_SHARE).then(|| percent(share)),
                "parts": self.where_made(&mistake),
                "they": rich(&they),
                "advice": rich(advice),
                "also": mistake.also.iter().map(|id| self.with_words(id, &mut *rich)).collect::<Vec<_>>(),
                "ids": mistake.ids,
            })
        });
        let told: Vec<Value> = told.collect();
        let why = match self.study.wrong.0 {
            0 => "no_wrong",
            _ if self.study.mistakes.is_empty() => "no_method",
            _ => "no_favourite",
        };
        (told.is_empty().then_some(why), told)
    }

    /// The wrong methods; those of the same words, which stand in the lists of several problems, as one.
    pub(super) fn favourites(&self) -> Vec<MistakeCount> {
        let words =
            |m: &MistakeCount| m.ids.first().and_then(|id| self.catalogue.get(id)).map(|e| e.did.as_str());
        let mut list: Vec<MistakeCount> = Vec::new();
        for mistake in &self.study.mistakes {
            let same = list.iter_mut().find(|m| words(m).is_some() && words(m) == words(mistake));
            match same {
                Some(known) => known.join(mistake),
                None => list.push(mistake.clone()),
            }
        }
        MistakeCount::sort(&mut list);
        list
    }

    /// `1.v (12), 1.omega (1)`: the parts with the number of answers.
    fn where_made(&self, mistake: &MistakeCount) -> String {
        let mut parts = mistake.parts.clone();
        parts.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
        let told: Vec<String> = parts.iter().map(|(p, n)| format!("{} ({n})", self.label(*p))).collect();
        self.first_of(&told, PARTS)
    }

    /// The first few names of a list, and how many more there are.
    pub(super) fn first_of(&self, names: &[String], most: usize) -> String {
        let more = names.len().saturating_sub(most);
        let list = names[..names.len() - more].join(", ");
        if more == 0 { list } else { self.say("more", &[("list", &list), ("n", &more.to_string())]) }
    }

    /// A method in words, with its id: finished HTML. An id alone would tell nobody anything.
    pub(super) fn with_words(&self, id: &str, rich: Rich) -> String {
        let did =
            self.catalogue.get(id).map_or_else(String::new, |e| rich(e.did.trim_end_matches('.')) + " ");
        format!("{did}<code>{}</code>", template::in_html(id))
    }

    /// What was done, in a line of plain text.
    pub(super) fn in_short(&self, mistake: &MistakeCount) -> String {
        let entry = mistake.ids.first().and_then(|id| self.catalogue.get(id));
        entry.map_or_else(String::new, |e| plain(e.did.trim_end_matches('.')))
    }

    /// The most important in some lines, for the terminal, whose language is English.
    pub fn in_brief(&self) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some(mistake) = self.favourites().first().filter(|m| m.students() > 1) {
            lines.push(format!(
                "favourite mistake: {} ({}; {} students, in {})",
                lowered(&self.in_short(mistake)),
                mistake.ids.join(" or "),
                mistake.students(),
                self.where_made(mistake)
            ));
        }
        match self.study.fairness.iter().filter(|c| c.corrected < LEVEL).count() {
            0 => {}
            1 => lines.push("fairness: 1 comparison stands out, see the report".to_owned()),
            _ => lines.push("fairness: some comparisons stand out, see the report".to_owned()),
        }
        lines
    }
}

/// The first letter small.
fn lowered(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

/// A note of the catalogue, `They do this: show that.`, as a sentence and an advice; the advice may be empty.
fn advice(note: &str) -> (String, &str) {
    match note.split_once(": ") {
        Some((they, advice)) => (format!("{they}."), advice),
        None => (note.to_owned(), ""),
    }
}
