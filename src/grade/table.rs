//! The keys of a whole set, laid out for looking up by bytes.
use crate::answer::roster::folded;
use crate::csv_field::unguarded;
use crate::grade::feedback::Feedback;
use crate::grade::id_index::Ids;
use crate::grade::row::AnswerRow;
use crate::key::{Answer, KeyEntry, KeyFollow, ProblemKey, SheetKey};
use crate::policy::Policy;
use crate::units::{Unit, spell};
use rustc_hash::FxHashMap;

/// A student of the set.
#[derive(Debug, Clone)]
pub struct TableStudent {
    /// Id, as on the roster.
    pub id: String,
    /// Name, empty if none is known.
    pub name: String,
}

/// One part of the set: a column of the gradebook.
#[derive(Debug, Clone)]
pub struct Column {
    /// Number of the problem, from 1.
    pub number: usize,
    /// Id of the problem.
    pub problem: String,
    /// Id of the part.
    pub part: String,
    /// Points for a right answer (those of the first student who has the part).
    pub points: f64,
}

impl Column {
    /// `1.omega`
    pub fn label(&self) -> String {
        format!("{}.{}", self.number, self.part)
    }
}

/// What the quick way needs to know of an entry: little, because rows stand in any order and the time goes into waiting for
/// memory.
#[derive(Debug, Clone, Copy)]
pub(crate) struct QuickKey {
    pub value: f64,
    pub half_width: f64,
    /// How it is asked, by its place in [`KeyTable::asked`].
    asked: u32,
}

/// How a part is asked: the same for nearly all students.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AskedColumn {
    /// SI value = cell * times / over
    pub times: f64,
    pub over: f64,
    pub points: f64,
    pub magnitude: bool,
    /// A direction, which the quick way does not compare.
    pub cyclic: bool,
    /// A number without a unit will do.
    pub bare: bool,
    /// The unit that is asked, by its place in [`KeyTable::units`]; `WORD` where no number is asked.
    pub unit: u16,
}

/// No number is asked.
pub(crate) const WORD: u16 = u16::MAX;

/// The keys of all students.
#[derive(Debug, Default)]
pub struct KeyTable {
    /// In the order of the sheets given.
    pub students: Vec<TableStudent>,
    /// In the order of the sheets.
    pub columns: Vec<Column>,
    /// In the order of the students.
    sheets: Vec<SheetKey>,
    quick: Vec<QuickKey>,
    /// How parts are asked, column after column.
    asked: Vec<(usize, AskedColumn)>,
    /// The units that are asked.
    pub(crate) units: Vec<Unit>,
    /// For each column the first one of its problem.
    first: Vec<usize>,
    by_id: Ids,
    /// As [`folded`] has it; `None` where two ids differ in nothing else.
    by_folded_id: FxHashMap<String, Option<u32>>,
    by_loose_id: FxHashMap<String, Option<u32>>,
    by_part: Ids,
    by_loose_part: FxHashMap<Vec<u8>, Option<u32>>,
}

/// Without blanks, case and leading zeros.
fn loose_id(id: &str) -> String {
    let text: String = id.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect();
    let zeros = text.trim_start_matches('0');
    // a spreadsheet may also have made 123.0 of 00123
    zeros.strip_suffix(".0").unwrap_or(zeros).to_owned()
}

/// A problem's number as a spreadsheet may have made it: `1.0` and `01` are 1.
fn plain_problem(text: &str) -> &str {
    let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
    let digits = |t: &str, also: fn(u8) -> bool| t.bytes().all(also);
    if whole.is_empty() || !digits(whole, |b| b.is_ascii_digit()) || !digits(decimals, |b| b == b'0') {
        return text;
    }
    whole.trim_start_matches('0')
}

/// Puts down what has this name; nothing, if something else has it too.
fn put_once<K: std::hash::Hash + Eq>(known: &mut FxHashMap<K, Option<u32>>, name: K, of: u32) {
    known.entry(name).and_modify(|e| *e = e.filter(|other| *other == of)).or_insert(Some(of));
}

/// One key for two fields.
pub(crate) fn joined(problem: &[u8], part: &[u8], out: &mut Vec<u8>) {
    out.clear();
    out.extend_from_slice(problem);
    out.push(0x1f);
    out.extend_from_slice(part);
}

/// The parts of all sheets, problem by problem and in the order of the sheets.
fn columns(sheets: &[SheetKey]) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    for sheet in sheets {
        for (i, problem) in sheet.problems.iter().enumerate() {
            for entry in &problem.parts {
                let known = columns
                    .iter()
                    .any(|c| c.number == i + 1 && c.problem == problem.id && c.part == entry.part);
                if !known {
                    columns.push(Column {
                        number: i + 1,
                        problem: problem.id.clone(),
                        part: entry.part.clone(),
                        points: entry.points,
                    });
                }
            }
        }
    }
    columns.sort_by_key(|c| c.number); // stable: parts stay in their order
    columns
}

/// The problem of a sheet to which a column belongs, and the index of its part, `likely` this one.
fn part_of<'k>(sheet: &'k SheetKey, column: &Column, likely: usize) -> Option<(&'k ProblemKey, usize)> {
    let problem = sheet.problems.get(column.number - 1).filter(|p| p.id == column.problem)?;
    let is = |entry: &KeyEntry| entry.part == column.part;
    let part = match problem.parts.get(likely).is_some_and(is) {
        true => likely,
        false => problem.parts.iter().position(is)?,
    };
    Some((problem, part))
}

impl KeyTable {
    /// Lays out the keys; `names` are (id, name) of the roster.
    pub fn new(sheets: Vec<SheetKey>, names: &[(String, String)]) -> KeyTable {
        let names: FxHashMap<&str, &str> = names.iter().map(|(id, n)| (id.as_str(), n.as_str())).collect();
        let columns = columns(&sheets);
        let first = columns.iter().map(|c| columns.partition_point(|other| other.number < c.number));
        let mut table = KeyTable {
            first: first.collect(),
            quick: Vec::with_capacity(sheets.len() * columns.len()),
            columns,
            ..Self::default()
        };
        let mut key = Vec::new();
        for (c, column) in (0u32..).zip(&table.columns) {
            for problem in [column.number.to_string(), column.problem.clone()] {
                joined(problem.as_bytes(), column.part.as_bytes(), &mut key);
                if table.by_part.get(&key).is_none() {
                    table.by_part.put(&key, c);
                }
                put_once(&mut table.by_loose_part, key.to_ascii_lowercase(), c);
            }
        }
        for sheet in &sheets {
            let s = table.students.len() as u32;
            for column in 0..table.columns.len() {
                let part = part_of(sheet, &table.columns[column], column - table.first[column]);
                let quick = table.quick_key(column, part.map(|(problem, part)| &problem.parts[part]));
                table.quick.push(quick);
            }
            table.by_id.put(sheet.student.as_bytes(), s);
            put_once(&mut table.by_folded_id, folded(&sheet.student), s);
            put_once(&mut table.by_loose_id, loose_id(&sheet.student), s);
            let name = names.get(sheet.student.as_str()).map_or(String::new(), |n| (*n).to_owned());
            table.students.push(TableStudent { id: sheet.student.clone(), name });
        }
        table.sheets = sheets;
        table
    }

    /// Index of a student by the exact id.
    #[inline]
    pub(crate) fn student(&self, id: &[u8]) -> Option<u32> {
        self.by_id.get(id)
    }
    /// Indices of the student and the column of a row of answers.csv.
    pub fn place_of(&self, row: &AnswerRow) -> Option<(usize, usize)> {
        let student = self.student(row.student.as_bytes())?;
        let mut key = Vec::new();
        joined(row.problem.as_bytes(), row.part.as_bytes(), &mut key);
        Some((student as usize, self.by_part.get(&key)? as usize))
    }
    /// Index of a student whose id was guarded against spreadsheets, or differs from one on the roster in nothing that [`folded`]
    /// keeps, and is no other's; `true`: it differs.
    #[cold]
    pub(crate) fn student_by_case(&self, id: &[u8]) -> Option<(u32, bool)> {
        let id = unguarded(std::str::from_utf8(id).ok()?);
        if let Some(exact) = self.student(id.as_bytes()) {
            return Some((exact, false));
        }
        let found = self.by_folded_id.get(&folded(id)).copied().flatten()?;
        Some((found, true))
    }
    /// Index of a column by number or id of the problem and id of the part; `key` is from [`joined`].
    #[inline]
    pub(crate) fn column(&self, key: &[u8]) -> Option<u32> {
        self.by_part.get(key).or_else(|| {
            let lower = key.to_ascii_lowercase();
            self.by_loose_part.get(&lower).copied().flatten().or_else(|| {
                // 1.0 and 01 are problem 1
                let at = lower.iter().position(|b| *b == 0x1f)?;
                let mut plain = plain_problem(std::str::from_utf8(&lower[..at]).ok()?).as_bytes().to_vec();
                plain.extend_from_slice(&lower[at..]);
                self.by_loose_part.get(&plain).copied().flatten()
            })
        })
    }
    /// Is there a problem of that number or id?
    pub(crate) fn has_problem(&self, problem: &str) -> bool {
        self.of_problem(problem).next().is_some()
    }
    /// The columns of the problem of that number or id.
    fn of_problem<'t>(&'t self, problem: &'t str) -> impl Iterator<Item = &'t Column> {
        let problem = plain_problem(problem);
        let is =
            move |c: &&Column| c.problem.eq_ignore_ascii_case(problem) || c.number.to_string() == problem;
        self.columns.iter().filter(is)
    }
    /// The entry of a student and a column, if that student has the part.
    #[inline]
    pub fn entry(&self, student: usize, column: usize) -> Option<&KeyEntry> {
        self.problem_of(student, column).map(|(problem, part)| &problem.parts[part])
    }
    /// The problem of a student to which a column belongs, and the index of its part, if that student has it.
    pub(crate) fn problem_of(&self, student: usize, column: usize) -> Option<(&ProblemKey, usize)> {
        part_of(self.sheets.get(student)?, self.columns.get(column)?, column - self.first[column])
    }
    /// What all students have in common of the problem to which a column belongs.
    fn problem(&self, column: usize) -> Option<&ProblemKey> {
        (0..self.sheets.len())
            .find_map(|student| self.problem_of(student, column))
            .map(|(problem, _)| problem)
    }
    /// Ids of the wrong methods of a column's problem.
    pub(crate) fn methods(&self, column: usize) -> &[String] {
        self.problem(column).map_or(&[], |problem| &problem.methods)
    }
    /// The relation by which a part follows from others, and the column of part 0 of its problem.
    pub(crate) fn follow(&self, column: usize) -> Option<(&KeyFollow, usize)> {
        let first = self.first_of(column);
        let follow = self.problem(column)?.follows.iter().find(|f| first + f.part == column)?;
        Some((follow, first))
    }
    /// The code of the variant of which a student is asked a part.
    pub(crate) fn code(&self, student: usize, column: usize) -> &str {
        self.problem_of(student, column).map_or("", |(problem, part)| problem.code_of(&problem.parts[part]))
    }
    /// Gives parts the points that a course says.
    pub fn take_points(&mut self, policy: &Policy) {
        for (column, c) in self.columns.iter_mut().enumerate() {
            let Some(points) = policy.points_given(c.number, &c.problem, &c.part) else { continue };
            c.points = points;
            for (_, asked) in self.asked.iter_mut().filter(|(of, _)| *of == column) {
                asked.points = points;
            }
            for sheet in &mut self.sheets {
                let problem = sheet.problems.get_mut(c.number - 1).filter(|p| p.id == c.problem);
                let parts = problem.map_or(&mut [][..], |p| &mut p.parts);
                parts.iter_mut().filter(|e| e.part == c.part).for_each(|e| e.points = points);
            }
        }
    }
    /// What the quick way needs of an entry, and how it is asked.
    #[inline]
    pub(crate) fn quick(&self, index: usize) -> (&QuickKey, &AskedColumn) {
        let key = &self.quick[index];
        (key, &self.asked[key.asked as usize].1)
    }
    /// The most points of an entry.
    #[inline]
    pub(crate) fn points(&self, index: usize) -> f64 {
        self.quick(index).1.points
    }
    fn quick_key(&mut self, column: usize, entry: Option<&KeyEntry>) -> QuickKey {
        let mut asked = AskedColumn {
            times: 1.0,
            over: 1.0,
            points: 0.0,
            magnitude: false,
            cyclic: false,
            bare: false,
            unit: WORD,
        };
        let (mut value, mut half_width) = (0.0, 0.0);
        if let Some(entry) = entry {
            asked.points = entry.points;
            if let Answer::Number { value: key, half_width: half, magnitude, cyclic, .. } = entry.answer {
                (value, half_width) = (key, half);
                (asked.times, asked.over) = entry.unit.times_over();
                (asked.magnitude, asked.cyclic) = (magnitude, cyclic);
                asked.bare = !entry.unit_required || entry.unit.is_number();
                let unit = self.units.iter().position(|u| *u == entry.unit).unwrap_or_else(|| {
                    self.units.push(entry.unit.clone());
                    self.units.len() - 1
                });
                asked.unit = u16::try_from(unit).unwrap_or(WORD);
            }
        }
        let known = self.asked.iter().position(|known| *known == (column, asked));
        let asked = known.unwrap_or_else(|| {
            self.asked.push((column, asked));
            self.asked.len() - 1
        });
        QuickKey { value, half_width, asked: asked as u32 }
    }
    /// The first column of a column's problem.
    pub(crate) fn first_of(&self, column: usize) -> usize {
        self.first.get(column).copied().unwrap_or(0)
    }
    /// Why a student is not known.
    pub(crate) fn unknown_student(&self, id: &str, say: &Feedback) -> String {
        if id.is_empty() {
            return say.get("feedback.no_student").to_owned();
        }
        let near = self.by_loose_id.get(&loose_id(id)).copied().flatten();
        match near.and_then(|s| self.students.get(s as usize)) {
            Some(student) => say.fill("feedback.stranger_close", &[("student", &student.id)]).into_owned(),
            None => say.get("feedback.stranger").to_owned(),
        }
    }
    /// Why a part is not known.
    pub(crate) fn unknown_part(&self, problem: &str, part: &str, say: &Feedback) -> String {
        let shown = |text: &str| text.chars().take(40).collect::<String>();
        let of: Vec<&Column> = self.of_problem(problem).collect();
        if of.is_empty() {
            let mut names: Vec<String> =
                self.columns.iter().map(|c| format!("{} ({})", c.number, c.problem)).collect();
            names.dedup();
            let pieces = [("problem", &*shown(problem)), ("problems", &*names.join(", "))];
            return say.fill("feedback.no_problem", &pieces).into_owned();
        }
        let parts: Vec<&str> = of.iter().map(|c| c.part.as_str()).collect();
        let (part_shown, all) = (shown(part), parts.join(", "));
        match spell::closest(part, parts.iter().copied()) {
            Some(close) => {
                let pieces = [("part", &*part_shown), ("close", close), ("parts", &*all)];
                say.fill("feedback.no_part_close", &pieces).into_owned()
            }
            None => say.fill("feedback.no_part", &[("part", &part_shown), ("parts", &all)]).into_owned(),
        }
    }
}
