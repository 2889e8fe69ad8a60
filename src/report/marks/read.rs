//! answers.csv and gradebook.csv to marks, in a stream.
use crate::finding::Finding;
use crate::grade::gradebook_reader;
use crate::grade::row::{AnswerReader, AnswerRow, in_line};
use crate::grade::verdict::Verdict;
use crate::policy::time::{self, Evidence};
use crate::report::marks::{EXAMPLES, LONGEST, MarkedCell, MarkedClass, MarkedPart, Marks};
use crate::words::Words;
use crate::words::plain::{beginning, in_places};
use rustc_hash::FxHashMap;
use std::io::Read;

/// What is remembered of a cell while rows pass by: moments with the day first, with the month first; places in the file.
#[derive(Debug, Clone, Copy, Default)]
struct Seen {
    first: Option<[i64; 2]>,
    last: Option<[i64; 2]>,
    right: Option<[(i64, u64); 2]>,
    right_row: Option<(u64, u32)>,
    untimed: bool,
    /// Times go back somewhere.
    disordered: bool,
}

impl Marks {
    /// Reads answers.csv. `open` may be called twice, where attempts do not stand in the order of their times. Errors: no
    /// answers.csv, or one that is cut off.
    pub fn read<R: Read>(
        mut class: MarkedClass,
        open: &mut dyn FnMut() -> std::io::Result<R>,
    ) -> Result<Self, Finding> {
        let size = class.students.len() * class.parts.len();
        class.asked.resize(size, false);
        let whose: FxHashMap<String, usize> =
            class.students.iter().enumerate().map(|(i, s)| (s.student.clone(), i)).collect();
        let mut which: FxHashMap<String, FxHashMap<String, usize>> = FxHashMap::default();
        for (i, part) in class.parts.iter().enumerate() {
            which.entry(part.number.to_string()).or_default().insert(part.id.clone(), i);
        }
        let mut marks = Self {
            cells: vec![MarkedCell::default(); size],
            by_part: vec![[0; Verdict::ALL.len()]; class.parts.len()],
            class,
            ..Self::default()
        };
        let mut seen = vec![Seen::default(); size];
        let mut evidence = Evidence::default();
        let mut pass =
            |marks: &mut Self, see: &mut dyn FnMut(&mut Self, &PlacedRow)| -> Result<(), Finding> {
                let source = open().map_err(|e| Finding::new("", e.to_string()))?;
                let mut reader = AnswerReader::new(source)?;
                let mut number = 0;
                while let Some(row) = reader.next_row()? {
                    number += 1;
                    let who = whose.get(&*row.student).copied();
                    let what = which.get(&*row.problem).and_then(|parts| parts.get(&*row.part)).copied();
                    see(marks, &PlacedRow { row, number, who, what });
                }
                Ok(())
            };
        pass(&mut marks, &mut |marks, found| marks.take(found, &mut seen, &mut evidence))?;
        let order = marks.class.day_first.map_or(evidence, Evidence::said).choice();
        if seen.iter().any(|s| s.disordered && !s.untimed) {
            // How many attempts came before the first right one: counted in a second reading.
            let mut before = vec![0u32; size];
            pass(&mut marks, &mut |marks, found| {
                let Some(i) = marks.place(found) else { return };
                if found.counted().is_none() {
                    return;
                }
                if let (Some(right), Some(at)) = (seen[i].right, found.moment())
                    && (at.micros[order], found.number) < right[order]
                {
                    before[i] += 1;
                }
            })?;
            for (i, cell) in marks.cells.iter_mut().enumerate() {
                if seen[i].disordered && !seen[i].untimed && seen[i].right.is_some() {
                    cell.first_right = Some(before[i] + 1);
                }
            }
        }
        marks.given = marks.cells.iter().map(|c| c.row.as_ref().map(|r| r.points)).collect();
        marks.dropped = vec![Vec::new(); marks.class.students.len()];
        marks.totals = (0..marks.class.students.len()).map(|s| marks.sum(s)).collect();
        for (cell, seen) in marks.cells.iter_mut().zip(&seen) {
            if let (Some(right), Some(first), false) = (seen.right, seen.first, seen.untimed) {
                cell.seconds = Some((right[order].0.saturating_sub(first[order])).max(0) as f64 / 1e6);
            }
        }
        Ok(marks)
    }

    fn place(&self, found: &PlacedRow) -> Option<usize> {
        Some(found.who? * self.class.parts.len() + found.what?)
    }

    fn take(&mut self, found: &PlacedRow, seen: &mut [Seen], evidence: &mut Evidence) {
        self.rows += 1;
        self.verdicts[found.row.verdict as usize] += 1;
        if let (Some(_), Some(part)) = (found.who, found.what) {
            self.by_part[part][found.row.verdict as usize] += 1;
        }
        let counted = found.counted();
        let odd = [Verdict::Unreadable, Verdict::WrongDimension, Verdict::MissingUnit];
        if let Some(verdict) = counted.filter(|v| odd.contains(v)) {
            let reason = match found.row.verdict {
                Verdict::Superseded => superseded(&beginning(&found.row.reason, LONGEST))
                    .map_or_else(String::new, |(_, why)| why),
                _ => beginning(&found.row.reason, LONGEST),
            };
            let key = (found.who.and(found.what), verdict, reason);
            let trouble = self.troubles.entry(key).or_default();
            trouble.cells += 1;
            let example = beginning(&found.row.answer, LONGEST);
            if trouble.examples.len() < EXAMPLES && !trouble.examples.contains(&example) {
                trouble.examples.push(example);
            }
        }
        let Some(i) = self.place(found) else { return };
        self.class.asked[i] = found.row.verdict != Verdict::UnknownPart;
        if let (Some(part), true) = (found.what, found.row.max_points > 0.0) {
            // What a course makes of the points of the bank is seen here.
            self.class.parts[part].points = found.row.max_points;
        }
        let Some(verdict) = counted else { return };
        let moment = found.moment();
        let cell = &mut self.cells[i];
        cell.attempts += 1;
        let seen = &mut seen[i];
        match moment {
            Some(moment) => {
                self.timed = true;
                evidence.join(moment.evidence);
                let at = moment.micros;
                let first = seen.first.get_or_insert(at);
                for (first, at) in first.iter_mut().zip(at) {
                    *first = at.min(*first);
                }
                let last = seen.last.get_or_insert(at);
                seen.disordered |= last.iter().zip(at).any(|(last, at)| at < *last);
                *last = at;
            }
            None => seen.untimed = true,
        }
        if verdict == Verdict::Right {
            if let Some(moment) = moment {
                let right = seen.right.get_or_insert(moment.micros.map(|at| (at, found.number)));
                for (right, at) in right.iter_mut().zip(moment.micros) {
                    *right = (*right).min((at, found.number));
                }
            }
            if seen.right_row.is_none() {
                seen.right_row = Some((found.number, cell.attempts));
                cell.first_right = Some(cell.attempts);
            }
        }
        if found.row.verdict != Verdict::Superseded {
            cell.row = Some(found.counting());
        }
    }

    /// Takes the points and totals of gradebook.csv, which knows of corrections, dropped problems and rounding, in place of the
    /// sums of the rows that count. Errors: it is no gradebook, or that of another class.
    pub fn book(&mut self, gradebook: impl Read) -> Result<(), Finding> {
        let parts: Vec<String> = self.class.parts.iter().map(MarkedPart::label).collect();
        let whose: FxHashMap<String, usize> =
            self.class.students.iter().enumerate().map(|(i, s)| (s.student.clone(), i)).collect();
        let mut found = 0;
        gradebook_reader::each_row(gradebook, &parts, false, &mut |row| {
            let Some(who) = whose.get(&row.student).copied() else {
                return Err(in_line(row.line, format!("`{}` is not in the set", row.student)));
            };
            found += 1;
            self.given[who * parts.len()..][..parts.len()].copy_from_slice(&row.points);
            let numbers = row.dropped.iter().filter_map(|n| n.checked_sub(1));
            self.dropped[who] = numbers.filter(|i| *i < self.class.problems.len()).collect();
            self.totals[who] = (row.total.unwrap_or(0.0), row.of.unwrap_or(0.0));
            Ok(())
        })?;
        if found == self.class.students.len() {
            return Ok(());
        }
        let what = format!("has {found} students, the set {}", self.class.students.len());
        Err(Finding::new("", what))
    }
}

/// A row of answers.csv, its number, and the student and the part to which it belongs, if it does.
struct PlacedRow<'r> {
    row: AnswerRow<'r>,
    number: u64,
    who: Option<usize>,
    what: Option<usize>,
}

impl PlacedRow<'_> {
    fn moment(&self) -> Option<time::Moment> {
        time::parse(&self.row.submitted_at)
    }

    /// The verdict of an attempt, that which a superseded one would have had; `None` for what is no attempt.
    fn counted(&self) -> Option<Verdict> {
        match self.row.verdict {
            Verdict::Blank | Verdict::UnknownPart | Verdict::UnknownStudent => None,
            Verdict::Superseded => superseded(&self.row.reason).map(|(verdict, _)| verdict),
            verdict => Some(verdict),
        }
    }

    fn counting(&self) -> AnswerRow<'static> {
        let [answer, reason] =
            [&self.row.answer, &self.row.reason].map(|text| beginning(text, LONGEST).into());
        AnswerRow { answer, reason, ..self.row.clone() }.into_owned()
    }
}

/// The verdict that a superseded row names in its reason, and why, in any language: verdicts are not translated.
fn superseded(reason: &str) -> Option<(Verdict, String)> {
    Words::languages().filter_map(Words::built_in).find_map(|words| {
        let [_, rest] = in_places(words.get("feedback.superseded"), reason)?[..] else { return None };
        // `wrong` begins `wrong direction`: the longest fits.
        let fits = Verdict::ALL.iter().filter(|v| rest.starts_with(v.as_str()));
        let verdict = *fits.max_by_key(|v| v.as_str().len())?;
        let why = rest[verdict.as_str().len()..].trim_start_matches([':', ';', ' ']);
        Some((verdict, why.to_owned()))
    })
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "points and seconds are whole here")]
mod tests {
    use super::*;
    use crate::set::store::StoredStudent;

    fn class() -> MarkedClass {
        MarkedClass {
            students: ["a", "=b"]
                .map(|id| StoredStudent { student: id.to_owned(), ..StoredStudent::default() })
                .to_vec(),
            problems: vec![String::new()],
            parts: ["v", "t"]
                .map(|id| MarkedPart { number: 1, id: id.to_owned(), points: 1.0, ..MarkedPart::default() })
                .to_vec(),
            asked: vec![true; 4],
            day_first: None,
        }
    }
    fn read(rows: &str) -> Result<Marks, Finding> {
        let text = format!(
            "line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at\n{rows}"
        );
        Marks::read(class(), &mut || Ok(text.as_bytes()))
    }

    #[test]
    fn the_row_that_counts_and_the_first_right_one() {
        let marks = read(
            "2,,a,1,v,3,superseded,0,2,superseded by line 4; would have been wrong: not within; x,A05,,,2026-03-01 10:05\n\
             3,,a,1,v,2,superseded,0,2,superseded by line 4; would have been right,,,,2026-03-01 10:20\n\
             4,,a,1,v,5,wrong,0,2,not within,A05 A06,drift,late:0.8 closed,2026-03-01 11:00\n\
             5,,a,1,v,,blank,0,2,nothing written,,,,2026-03-01 12:00\n\
             6,,'=b,1,v,'=cmd,unreadable,0,2,neither,,,,\n\
             7,,'=b,1,t,'quoted',unreadable,0,2,neither,,,,\n\
             8,,zz,1,v,1,unknown student,0,0,not on the roster,,,,\n",
        )
        .unwrap();
        let cell = marks.cell(0, 0);
        assert_eq!((cell.attempts, cell.first_right, cell.seconds), (3, Some(2), Some(900.0)));
        let row = cell.row.as_ref().unwrap();
        assert_eq!((row.verdict, row.line, &*row.answer), (Verdict::Wrong, 4, "5"));
        assert_eq!((&*row.methods, &*row.credit), ("A05 A06", "late:0.8 closed"));
        assert_eq!(marks.cell(1, 0).row.as_ref().unwrap().answer, "=cmd");
        assert_eq!(marks.cell(1, 1).row.as_ref().unwrap().answer, "'quoted'");
        assert_eq!(marks.class.parts[0].points, 2.0);
        assert_eq!(marks.sum(0), (0.0, 4.0));
        assert!(marks.took_part(1) && marks.rows == 7 && marks.troubles.len() == 2);
    }

    #[test]
    fn attempts_out_of_order_are_counted_by_time() {
        // The day comes first: 13/2 proves it. In time: wrong (13/2), wrong (1/3), right (2/3).
        let marks = read(
            "2,,a,1,v,3,right,1,1,within,,,,2/3/2026 10:00\n\
             3,,a,1,v,3,superseded,0,1,superseded by line 2; would have been wrong,,,,13/2/2026 10:00\n\
             4,,a,1,v,3,superseded,0,1,superseded by line 2; would have been wrong,,,,1/3/2026 10:00\n",
        )
        .unwrap();
        let cell = marks.cell(0, 0);
        assert_eq!((cell.attempts, cell.first_right), (3, Some(3)));
        assert_eq!(cell.seconds, Some(17.0 * 86400.0));
        assert_eq!(cell.row.as_ref().unwrap().verdict, Verdict::Right);
    }

    #[test]
    fn faults_have_a_line() {
        assert_eq!(read("2,,a,1,v,3,great,0,2,x,,,,\n").unwrap_err().at, Some((2, 1)));
        assert_eq!(read("2,,a,1,v,3,right,many,2,x,,,,\n").unwrap_err().at, Some((2, 1)));
        let none = Marks::read(class(), &mut || Ok("student,verdict\n".as_bytes())).unwrap_err();
        assert!(none.message.contains("line"), "{none:?}");
    }

    #[test]
    fn verdicts_of_superseded_rows_in_every_language() {
        for code in Words::languages() {
            let words = Words::of(code).unwrap();
            for verdict in [Verdict::Right, Verdict::Wrong, Verdict::WrongDirection, Verdict::MissingUnit] {
                let reason =
                    words.say("feedback.superseded", &[("line", "12"), ("verdict", verdict.as_str())]);
                let found = superseded(&format!("{reason}: because"));
                assert_eq!(found, Some((verdict, "because".to_owned())));
            }
        }
        assert_eq!(superseded("right"), None);
    }
}
