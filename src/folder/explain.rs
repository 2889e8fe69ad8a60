//! Everything about one mark: found in a folder of grades, told in words.
use crate::csv_field::unguarded;
use crate::finding::{Finding, Findings};
use crate::folder::graded::OpenGrading;
use crate::folder::{files, graded, names, set};
use crate::policy::time::{self, Evidence};
use crate::regrade::changes::ChangeRow;
use crate::report::explain::ExplainedMarks;
use crate::set::store::{StoredSet, StoredStudent};
use crate::units::spell;
use std::path::Path;

/// Explains the marks of a student for a problem, or a part of it, as they are typed. Errors: nobody or nothing is meant, or the
/// folder is no grading.
pub fn explain(folder: &Path, student: &str, problem: &str, part: Option<&str>) -> Result<String, Findings> {
    let name = folder.display().to_string();
    let here = |f: Finding| f.in_file(&name);
    // Who is meant is found before anything is solved; where there is no set, opening says what is missing.
    let basis = folder.join(names::BASIS);
    let there = folder.is_dir() && basis.join(names::SET).is_file();
    let set = if there { set::open(&basis)? } else { graded::open(folder, None)?.set };
    let who = self::student(&set, student).map_err(here)?;
    let (index, in_name) = self::problem(&set, problem).map_err(here)?;
    let part = part.or(in_name.as_deref());
    let graded = graded::open(folder, Some(&set.students[who].student))?;
    let (Some(student), Some(given)) = (graded.set.students.first(), graded.given.first()) else {
        return Err(Finding::new("", "the set has no such student").into());
    };
    let problem = graded.bank.problems.iter().find(|p| p.id == graded.set.problems[index]);
    let (Some(problem), Some(key), Some(variant)) =
        (problem, given.key.problems.get(index), given.variants.get(index))
    else {
        return Err(Finding::new("", "the sheet has no such problem").into());
    };
    if let Some(part) = part
        && !key.parts.iter().any(|e| e.part == *part)
    {
        let known = key.parts.iter().map(|e| e.part.as_str());
        let fault = Finding::new("", format!("problem {} ({}) has no part `{part}`", index + 1, problem.id));
        return Err(here(fault.hint(spell::hint(part, "its parts", known))).into());
    }
    let mut rows = Vec::new();
    let number = (index + 1).to_string();
    let mut evidence = Evidence::default();
    graded.each_row(&mut |row| {
        // The whole column says whether the day comes first.
        if let Some(moment) = time::parse(&row.submitted_at) {
            evidence.join(moment.evidence);
        }
        if row.student == student.student && row.problem == number && row.is_known() {
            rows.push(row.into_owned());
        }
    })?;
    let marks = ExplainedMarks {
        set: &graded.set,
        student,
        number: index + 1,
        problem,
        key,
        variant,
        policy: &graded.policy,
        grading: &graded.grading,
        evidence: graded.policy.day_first.map_or(evidence, Evidence::said),
        rows: &rows,
        changes: &changes(&graded, &student.student, &number)?,
        total: total(&graded, &student.student)?,
    };
    marks.text(part)
}

/// What a regrading changed for a problem.
fn changes(graded: &OpenGrading, student: &str, number: &str) -> Result<Vec<ChangeRow>, Findings> {
    let path = graded.folder.join(names::CHANGES);
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let mut rows =
        ChangeRow::read(&files::read(&path)?).map_err(|f| f.in_file(path.display().to_string()))?;
    rows.retain(|row| row.student == student && row.problem == number);
    Ok(rows)
}

/// Columns `total`, `max_total` and `dropped` of a student in the gradebook.
fn total(graded: &OpenGrading, student: &str) -> Result<Option<[String; 3]>, Findings> {
    let path = graded.folder.join(names::GRADEBOOK);
    let all = files::columns(&path, ["student", "total", "max_total", "dropped"])?;
    let own = all.into_iter().find(|[id, ..]| unguarded(id) == student);
    Ok(own.map(|[_, total, of, dropped]| [total, of, dropped]))
}

/// Without blanks, case and leading zeros.
fn loose(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect();
    text.trim_start_matches('0').to_owned()
}

/// The student that is meant: by id, by an id that is alike but for blanks, case and zeros in front, or by name. Errors: nobody,
/// or several.
fn student(set: &StoredSet, typed: &str) -> Result<usize, Finding> {
    let students = &set.students;
    if let Some(i) = students.iter().position(|s| s.student == typed) {
        return Ok(i);
    }
    let is = |text: &str| loose(text) == loose(typed);
    let is_meant = |s: &StoredStudent| is(&s.student) || (!s.name.is_empty() && is(&s.name));
    let alike: Vec<usize> = (0..students.len()).filter(|i| is_meant(&students[*i])).collect();
    let fault = Finding::new("", format!("`{typed}` is no student of this set"));
    match alike[..] {
        [one] => Ok(one),
        [] => {
            let known = || students.iter().map(|s| s.student.as_str());
            Err(fault.hint(spell::did_you_mean(typed, known()).unwrap_or_else(|| {
                let some: Vec<&str> = known().take(5).collect();
                let rest = if students.len() > 5 { ", ..." } else { "" };
                format!("its students: {}{rest}", some.join(", "))
            })))
        }
        _ => {
            let ids: Vec<&str> = alike.iter().map(|i| students[*i].student.as_str()).collect();
            Err(fault.hint(format!("write the id exactly: {}", ids.join(", "))))
        }
    }
}

/// The problem that is meant, by number or id, and the part of it if one is named behind a point (`1.omega`). Errors: there is
/// none.
fn problem(set: &StoredSet, typed: &str) -> Result<(usize, Option<String>), Finding> {
    let find = |text: &str| {
        let number = text.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
        let named = set.problems.iter().position(|p| p.eq_ignore_ascii_case(text));
        named.or(number.filter(|n| *n < set.problems.len()))
    };
    let text = typed.trim();
    if let Some(found) = find(text) {
        return Ok((found, None));
    }
    if let Some((problem, part)) = text.split_once('.')
        && let Some(found) = find(problem)
    {
        return Ok((found, Some(part.to_owned())));
    }
    let known: Vec<String> =
        set.problems.iter().enumerate().map(|(i, p)| format!("{} ({p})", i + 1)).collect();
    let fault = Finding::new("", format!("the set has no problem `{typed}`"));
    let near = spell::did_you_mean(text, set.problems.iter().map(String::as_str));
    Err(fault.hint(near.unwrap_or_else(|| format!("its problems: {}", known.join(", ")))))
}
