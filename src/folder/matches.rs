//! Whose answers the wrong answers of a grading are. For instructors only.
use crate::answer::figures;
use crate::answer::read::UnitCache;
use crate::finding::Findings;
use crate::folder::graded::OpenGrading;
use crate::grade::compare;
use crate::grade::feedback::Feedback;
use crate::grade::row::AnswerRow;
use crate::grade::table::{Column, KeyTable};
use crate::grade::verdict::Verdict;
use crate::key::{Answer, SheetKey};
use crate::matches::{self, AnswerColumn, WrongAnswer};
use crate::report::matches::{ClassMatches, MatchedPair};
use crate::set::dealer::{Dealer, indices};
use rayon::prelude::*;

/// With the draws of the class so many keys of each question are known: what a class is too small for, further draws show.
const KEYS: usize = 300;

/// Holds the wrong answers of a grading against the keys of classmates. Errors: answers.csv cannot be read, or the bank cannot be
/// drawn from.
pub fn find(graded: &OpenGrading) -> Result<ClassMatches, Findings> {
    let keys: Vec<SheetKey> = graded.given.iter().map(|g| g.key.clone()).collect();
    let table = KeyTable::new(keys, &[]);
    let mut wrong = Vec::new();
    let mut texts = Vec::new();
    let (mut units, say) = (UnitCache::default(), Feedback::english());
    graded.each_row(&mut |row: AnswerRow| {
        if row.verdict != Verdict::Wrong {
            return;
        }
        let Some((student, question)) = table.place_of(&row) else { return };
        let Some(entry) = table.entry(student, question) else { return };
        let Answer::Number { magnitude, .. } = entry.answer else { return };
        let number = compare::compare_with(&row.answer, entry, &mut units, say).number;
        let value = if magnitude { number.abs() } else { number };
        let Some(share) = figures::rounding(&row.answer).filter(|_| value.is_finite()) else { return };
        let explained = row.explained();
        wrong.push(WrongAnswer { student, question, value, half: share * value.abs(), explained });
        texts.push(row.answer.into_owned());
    })?;
    if wrong.is_empty() {
        return Ok(ClassMatches::default());
    }
    let mut questions = questions(&table);
    let answers = wrong.len();
    if !matches::any_hit(&questions, &wrong) {
        let unexplained = wrong.iter().filter(|w| w.explained.is_empty()).count();
        return Ok(ClassMatches { pairs: Vec::new(), answers, unexplained });
    }
    draw_more(graded, &table, &mut questions)?;
    let found = matches::find(&questions, &wrong);
    let named = |i: usize| {
        let s = &graded.set.students[i];
        [s.student.clone(), s.name.clone()]
    };
    let part = |i: &usize| table.columns[wrong[*i].question].label();
    let pairs = found.pairs.iter().map(|pair| {
        let explained: Vec<String> = pair
            .hits
            .iter()
            .filter(|i| !wrong[**i].explained.is_empty())
            .map(|i| format!("{}: {}", part(i), wrong[*i].explained))
            .collect();
        MatchedPair {
            student: named(pair.student),
            classmate: named(pair.classmate),
            parts: pair.hits.iter().map(part).collect(),
            answers: pair.hits.iter().map(|i| texts[*i].clone()).collect(),
            chance: pair.chance,
            expected: pair.expected,
            flagged: pair.flagged,
            explained: explained.join("; "),
        }
    });
    Ok(ClassMatches { pairs: pairs.collect(), answers: found.answers, unexplained: found.unexplained })
}

/// The keys of the class.
fn questions(table: &KeyTable) -> Vec<AnswerColumn> {
    let keys = |c: usize| (0..table.students.len()).map(|s| number(table, s, c)).collect();
    let of = |(c, column): (usize, &Column)| AnswerColumn {
        problem: column.number,
        keys: keys(c),
        draws: Vec::new(),
    };
    table.columns.iter().enumerate().map(of).collect()
}

/// A key, SI; NaN for a word or none.
fn number(table: &KeyTable, student: usize, column: usize) -> f64 {
    match table.entry(student, column).map(|e| &e.answer) {
        Some(Answer::Number { value, .. }) => *value,
        _ => f64::NAN,
    }
}

/// Adds the keys of further draws where the class is small.
fn draw_more(graded: &OpenGrading, table: &KeyTable, questions: &mut [AnswerColumn]) -> Result<(), Findings> {
    let problems = indices(&graded.bank, &graded.set.problems, "problems")?;
    // No set has such a name, so nobody in the class has one of these draws.
    let dealer = Dealer::new(&graded.bank, &problems, graded.set.seed, "\u{0}matches");
    let wanted = KEYS.saturating_sub(table.students.len());
    // A bank that was changed may have become hard to draw from; then the class must do.
    if wanted == 0 || dealer.deal("0").is_err() {
        return Ok(());
    }
    let dealt: Vec<_> = (0..wanted).into_par_iter().map(|i| dealer.deal(&i.to_string()).ok()).collect();
    let further = KeyTable::new(dealt.into_iter().flatten().map(|d| d.key).collect(), &[]);
    for (question, column) in questions.iter_mut().zip(&table.columns) {
        let same = |o: &Column| (o.number, &o.part) == (column.number, &column.part);
        if let Some(c) = further.columns.iter().position(same) {
            question.draws = (0..further.students.len()).map(|s| number(&further, s, c)).collect();
        }
    }
    Ok(())
}
