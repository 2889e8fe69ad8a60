//! What an instructor asks first: who got what, and which parts were weakest.
use crate::report::class::{ClassReporter, Rich};
use crate::report::stats::LEAST_FOR_SHARE;
use crate::report::study::PartStudy;
use crate::report::table::{percent, points};
use serde_json::{Value, json};

/// Weakest parts that are told.
const WEAKEST: usize = 3;

impl ClassReporter<'_> {
    /// Every student of the roster, in its order, with the points of each problem, empty where the sheet does not have it; numbers
    /// are finished.
    pub(super) fn student_lines(&self) -> Vec<Value> {
        let marks = self.marks;
        let number = |value: f64| self.words.number(&points(value));
        let line = |(s, student): (usize, &crate::set::store::StoredStudent)| {
            let of_problem = |problem: usize| {
                let parts = (0..marks.class.parts.len())
                    .filter(|p| marks.class.parts[*p].number == problem + 1 && marks.asked(s, *p));
                let points: Vec<f64> = parts.map(|p| marks.points(s, p)).collect();
                if points.is_empty() { String::new() } else { number(points.iter().sum()) }
            };
            let (total, most) = marks.totals[s];
            json!({
                "id": student.student,
                "name": student.name,
                "problems": (0..marks.class.problems.len()).map(of_problem).collect::<Vec<_>>(),
                "total": number(total),
                "most": number(most),
                "took_part": marks.took_part(s),
            })
        };
        marks.class.students.iter().enumerate().map(line).collect()
    }

    /// The parts that lost the class the greatest share of their points, which is told where enough answered; of those who handed in
    /// how many were asked it, were right and gave no answer; and the wrong method of most answers, where two have one in common.
    pub(super) fn weakest(&self, rich: Rich) -> Vec<Value> {
        let ease = |(p, part): (usize, &PartStudy)| part.ease.filter(|e| *e < 1.0).map(|e| (p, e));
        let mut lost: Vec<(usize, f64)> = self.study.parts.iter().enumerate().filter_map(ease).collect();
        lost.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        lost.truncate(WEAKEST);
        let weak = lost.into_iter().map(|(p, ease)| {
            let (study, part) = (&self.study.parts[p], &self.marks.class.parts[p]);
            let here = |m: &crate::report::study::MistakeCount| {
                m.parts.iter().find(|(part, _)| *part == p).map_or(0, |(_, n)| *n)
            };
            let favourites = self.favourites();
            let most = favourites.iter().max_by_key(|m| here(m)).filter(|m| here(m) > 1);
            let entry = most.and_then(|m| m.ids.first()).and_then(|id| self.catalogue.get(id));
            json!({
                "part": part.label(),
                "asked": rich(&part.asked),
                "share": (study.asked >= LEAST_FOR_SHARE).then(|| percent(ease)),
                "right": study.right,
                "blank": study.asked.saturating_sub(study.answered),
                "asked_of": study.asked,
                "did": entry.map_or_else(String::new, |e| rich(&e.did)),
                "id": entry.map_or("", |e| &e.id),
                "answers": most.map_or(0, here),
            })
        });
        weak.collect()
    }
}
