//! A quiz of a learning platform as answers to a set. Each question shows the code of its variant: what was written to it is an
//! answer to those data, whoever of the set they were drawn for, and the mark goes to who wrote it. From the download come a file
//! of submissions like any other, and a set in which each student has the variants that the quiz asked.
use crate::answer::quiz::{Platform, Quiz, QuizAnswer, QuizAttempt, QuizText, code_words};
use crate::answer::roster;
use crate::finding::{Finding, push_new};
use crate::grade::run::QUIZ_COLUMNS;
use crate::key::{ProblemKey, SheetKey};
use crate::policy::{Counts, Policy};
use crate::set::store::{StoredSet, StoredStudent, StoredVariant};
use crate::sheet::terminal;
use crate::words::plain::beginning;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Codes, students and notes listed one by one before the rest is only counted.
const LISTED: usize = 10;
/// Letters of a text that are shown.
const SHORT: usize = 40;
/// Longest id, as in a roster.
const LONGEST: usize = 100;

/// The variants of a set by their codes: index of the student and of the problem.
struct Variants {
    by_code: HashMap<String, (usize, usize)>,
    /// Ids of the parts of each problem.
    parts: Vec<Vec<String>>,
}

/// One answer of the quiz.
struct QuizRow {
    line: u64,
    attempt: usize,
    /// Number of the problem, or what the question is called where its code is not known.
    problem: String,
    part: String,
    answer: String,
    code: String,
    /// Index of the problem and the part, and the student of the set whose variant it is.
    of: Option<(usize, usize, usize)>,
    /// Index of the problem, where it is known.
    at: Option<usize>,
}

impl Variants {
    /// Of a set and its keys. Errors: two variants have the same code, which one in a million sets may have.
    fn new(set: &StoredSet, keys: &[SheetKey]) -> Result<Self, Finding> {
        let mut by_code: HashMap<String, (usize, usize)> = HashMap::new();
        for (s, student) in set.students.iter().enumerate() {
            for (p, variant) in student.problems.iter().enumerate() {
                let code = variant.code();
                let (first, of) = *by_code.entry(code.clone()).or_insert((s, p));
                if let Some(what) = set.students[first].problems[of].difference(variant) {
                    let both = format!("{} and {}", set.students[first].student, student.student);
                    let what = format!("{both} have different variants of one code, {code}: {what}");
                    return Err(Finding::new("students", what).hint("make the set anew with another seed"));
                }
            }
        }
        let problems = keys.first().map_or(&[][..], |key| &key.problems);
        let ids = |p: &crate::key::ProblemKey| p.parts.iter().map(|e| e.part.clone()).collect();
        Ok(Self { by_code, parts: problems.iter().map(ids).collect() })
    }

    /// The code in a text; `Err`: a word that is called a code, and of no variant of this set.
    fn code<'t>(&self, text: &'t str) -> Option<Result<(String, &'t str), String>> {
        let words = code_words(text);
        let known = |called: bool| {
            let fits = |w: &&crate::answer::quiz::CodeWord| {
                (w.called || !called) && self.by_code.contains_key(&w.code)
            };
            words.iter().find(fits).map(|w| Ok((w.code.clone(), w.rest)))
        };
        let unknown = || words.iter().find(|w| w.called).map(|w| Err(w.code.clone()));
        known(true).or_else(|| known(false)).or_else(unknown)
    }

    /// The part of which a question asks alone: behind its code or with its name, `1.omega`.
    fn part(&self, p: usize, question: &str, rest: &str) -> Option<usize> {
        let parts = &self.parts[p];
        let named = |word: &str| {
            let word = word.trim_end_matches(['.', '-']);
            let same = parts.iter().position(|part| part == word);
            same.or_else(|| parts.iter().position(|part| part.eq_ignore_ascii_case(word)))
        };
        let is_mark = |c: char| !(c.is_alphanumeric() || matches!(c, '.' | '_' | '-'));
        let behind = rest.strip_prefix(['.', '-', '/']).and_then(|rest| named(rest.split(is_mark).next()?));
        if behind.is_some() {
            return behind;
        }
        let number = format!("{}.", p + 1);
        let words = question.split(is_mark).filter_map(|word| named(word.strip_prefix(&number)?));
        let found: BTreeSet<usize> = words.collect();
        if found.len() == 1 { found.first().copied() } else { None }
    }

    /// The answers of an attempt, one for each part.
    fn rows(&self, attempt: usize, taken: &QuizAttempt, platform: Platform, rows: &mut Vec<QuizRow>) {
        let before = rows.len();
        let line = taken.line;
        let row = |problem: String, part: &str, answer: &str| {
            let (part, answer, code) = (part.to_owned(), answer.to_owned(), String::new());
            QuizRow { line, attempt, problem, part, answer, code, of: None, at: None }
        };
        let placed =
            |p: usize, part: &str, answer: &str| QuizRow { at: Some(p), ..row(String::new(), part, answer) };
        for asked in &taken.answers {
            let found = self.code(&asked.question).or_else(|| self.code(&asked.header));
            let (code, rest) = match found {
                Some(Ok(found)) => found,
                // Nobody knows which variant it is, so it is no answer to any.
                other => {
                    let called = other.and_then(Result::err).unwrap_or_else(|| asked.header.clone());
                    rows.push(row(called, "", &text(asked)));
                    continue;
                }
            };
            let (s, p) = self.by_code[&code];
            let parts = &self.parts[p];
            let alone = self.part(p, &asked.question, rest).or((parts.len() == 1).then_some(0));
            let answers = match (&asked.written, alone) {
                (QuizText::Nothing, Some(part)) => vec![(part, "")],
                (QuizText::Nothing, None) => (0..parts.len()).map(|part| (part, "")).collect(),
                (QuizText::Parts(all), Some(part)) if all.len() == 1 => vec![(part, all[0].as_str())],
                (QuizText::Parts(all), _) if all.len() == parts.len() => {
                    all.iter().map(String::as_str).enumerate().collect()
                }
                (QuizText::Whole { text, .. }, Some(part)) => vec![(part, text.as_str())],
                (QuizText::Whole { list, .. }, None)
                    if platform == Platform::Canvas && list.len() == parts.len() =>
                {
                    list.iter().map(String::as_str).enumerate().collect()
                }
                // To which part it is an answer cannot be told.
                _ => {
                    rows.push(QuizRow { code, ..placed(p, &beginning(&asked.header, SHORT), &text(asked)) });
                    continue;
                }
            };
            rows.extend(answers.into_iter().map(|(part, answer)| QuizRow {
                code: code.clone(),
                of: Some((p, part, s)),
                ..placed(p, &parts[part], answer)
            }));
        }
        // An attempt that was never begun has no answers.
        if rows.len() == before {
            for (p, parts) in self.parts.iter().enumerate() {
                rows.extend(parts.iter().map(|part| placed(p, part, "")));
            }
        }
    }
}

fn text(asked: &QuizAnswer) -> String {
    match &asked.written {
        QuizText::Nothing => String::new(),
        QuizText::Parts(parts) => parts.join("; "),
        QuizText::Whole { text, .. } => text.clone(),
    }
}

/// Was anything typed?
fn is_typed(asked: &QuizAnswer) -> bool {
    match &asked.written {
        QuizText::Nothing => false,
        QuizText::Parts(parts) => parts.iter().any(|part| !part.is_empty()),
        QuizText::Whole { list, .. } => list.iter().any(|item| !item.is_empty()),
    }
}

/// Who took the quiz.
struct Takers {
    /// Id and name for each attempt; the id is that of the roster where it is on it.
    who: Vec<(String, String)>,
    /// Is any of them on the roster?
    on_roster: bool,
    /// Those who are not.
    strangers: BTreeSet<String>,
    /// By what they are known.
    by: &'static str,
}

/// An id or a name as a roster may have it.
fn clean(text: &str) -> String {
    let text: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let end = text.char_indices().map(|(i, c)| i + c.len_utf8()).take_while(|end| *end <= LONGEST).last();
    text[..end.unwrap_or(0)].trim().to_owned()
}

impl Takers {
    fn new(quiz: &Quiz, set: &StoredSet) -> Self {
        // Of ids that look alike none is taken for another.
        let mut listed: HashMap<String, Option<&str>> = HashMap::new();
        for student in &set.students {
            let known = listed.entry(roster::folded(&student.student));
            known.and_modify(|of| *of = None).or_insert(Some(&student.student));
        }
        let exact: BTreeSet<&str> = set.students.iter().map(|s| s.student.as_str()).collect();
        let on_roster = |attempt: &QuizAttempt| {
            let ids = || attempt.ids.iter().map(|id| id.trim()).filter(|id| !id.is_empty());
            let same = ids().find(|id| exact.contains(id)).map(str::to_owned);
            same.or_else(|| ids().find_map(|id| (*listed.get(&roster::folded(id))?).map(str::to_owned)))
        };
        let known: Vec<Option<String>> = quiz.attempts.iter().map(on_roster).collect();
        // One kind of id for all, where there is one: a platform looks all up by the same.
        let of_all = (0..3).find(|kind| quiz.attempts.iter().all(|a| !clean(&a.ids[*kind]).is_empty()));
        let words = match quiz.platform {
            Platform::Moodle => ["ID number", "user name", "e-mail address"],
            Platform::Canvas => ["SIS id", "login", "Canvas's own number"],
        };
        let id = |attempt: &QuizAttempt| {
            let own = of_all.map_or("", |kind| attempt.ids[kind].as_str());
            let mut all =
                [own].into_iter().chain(attempt.ids.iter().map(String::as_str)).chain([&*attempt.name]);
            let first = all.find_map(|id| Some(clean(id)).filter(|id| !id.is_empty()));
            first.unwrap_or_else(|| format!("line {}", attempt.line))
        };
        let mut spelled: HashMap<String, String> = HashMap::new();
        let who = quiz.attempts.iter().zip(&known).map(|(attempt, known)| {
            let id = known.clone().unwrap_or_else(|| {
                // An address may stand in capitals once.
                let id = id(attempt);
                spelled.entry(roster::folded(&id)).or_insert(id).clone()
            });
            (id, clean(&attempt.name))
        });
        let who: Vec<(String, String)> = who.collect();
        let strangers = who.iter().zip(&known).filter(|(_, known)| known.is_none());
        let strangers = strangers.map(|((id, _), _)| id.clone()).collect();
        let by = of_all.map_or("what the file says of each", |kind| words[kind]);
        Self { who, on_roster: known.iter().any(Option::is_some), strangers, by }
    }

    /// Of each student SIS id, login and Canvas's own number; nothing of other platforms.
    fn canvas(&self, quiz: &Quiz) -> BTreeMap<String, [String; 3]> {
        let all = self.who.iter().zip(&quiz.attempts).filter(|_| quiz.platform == Platform::Canvas);
        all.map(|((id, _), attempt)| (id.clone(), attempt.ids.each_ref().map(|id| clean(id)))).collect()
    }

    /// See [`MatchedQuiz::moodle`].
    fn moodle(&self, quiz: &Quiz) -> Option<&'static str> {
        let listed = |id: &str| !self.on_roster || !self.strangers.contains(id);
        let kind = |((id, _), attempt): (&(String, String), &QuizAttempt)| {
            attempt.ids.iter().position(|own| roster::folded(&clean(own)) == roster::folded(id))
        };
        let all = self.who.iter().zip(&quiz.attempts).filter(|((id, _), _)| listed(id));
        let kinds: BTreeSet<Option<usize>> = all.map(kind).collect();
        match quiz.platform {
            Platform::Moodle if kinds.contains(&None) => Some(MOODLE_NAMES),
            Platform::Moodle if kinds == BTreeSet::from([Some(1)]) => Some("Username"),
            _ => None,
        }
    }
}

/// Moodle's word for a name, by which it knows nobody when grades are imported.
const MOODLE_NAMES: &str = "Full name";

/// Of a student and a part, the variants in the order in which they were answered: students of the set whose they are.
type AskedVariants = HashMap<StudentPart, Vec<usize>>;
/// A student, a problem and a part.
pub type StudentPart = (String, usize, usize);
/// An attempt, whose variant it answered, and whether it did.
type Answered = (usize, usize, bool);

/// A quiz, held against its set.
pub struct MatchedQuiz {
    /// The file of submissions.
    pub text: Vec<u8>,
    /// What is odd, for the summary.
    pub told: String,
    /// Students and names.
    students: Vec<StoredStudent>,
    asked: AskedVariants,
    /// The problems that were asked: indices of the set.
    problems: Vec<usize>,
    pub canvas: BTreeMap<String, [String; 3]>,
    /// What stands in the first column of the gradebook for Moodle, where it is neither ID number nor e-mail address.
    pub moodle: Option<String>,
}

impl MatchedQuiz {
    /// Finds the variants and who answered them. `set` says whose codes they are and `keys` their parts; `before` is the
    /// set of the earlier grading, if a quiz is graded again: its students and problems stay. Errors: no question shows a code of
    /// the set.
    pub fn new(
        quiz: &Quiz,
        (set, keys): (&StoredSet, &[SheetKey]),
        before: Option<&StoredSet>,
        policy: &Policy,
    ) -> Result<Self, Finding> {
        let roster = before.unwrap_or(set);
        let variants = Variants::new(set, keys)?;
        let mut rows = Vec::new();
        for (i, attempt) in quiz.attempts.iter().enumerate() {
            variants.rows(i, attempt, quiz.platform, &mut rows);
        }
        let unknown = unknown_codes(&rows);
        if !unknown.is_empty() && !rows.iter().any(|row| row.of.is_some()) {
            return Err(no_code(quiz, &variants, &unknown));
        }
        let problems = problems(&rows, set, before);
        number(&mut rows, set, &problems);
        let unknown = unknown_codes(&rows);
        let takers = Takers::new(quiz, roster);
        let asked = asked(quiz, &rows, &takers, policy);
        let mut students: Vec<StoredStudent> = Vec::new();
        if takers.on_roster {
            students.clone_from(&roster.students);
        } else {
            let mut seen = BTreeSet::new();
            for (id, name) in takers.who.iter().filter(|(id, _)| seen.insert(id.clone())) {
                // What nobody was asked stays what it is for somebody.
                let problems = set.students.first().map_or_else(Vec::new, |s| s.problems.clone());
                let (student, name, folder) = (id.clone(), name.clone(), roster::folder(id));
                students.push(StoredStudent { student, name, folder, problems });
            }
        }
        let mut told = told(quiz, &rows, &takers, &unknown);
        told.push_str(&not_asked(set, &problems));
        let text = submissions(quiz, &rows, &takers);
        let (canvas, moodle) = (takers.canvas(quiz), takers.moodle(quiz));
        if let Some(MOODLE_NAMES) = moodle {
            told.push_str("\n  warning: Moodle cannot import grades by name: download the responses again, with ID number, user name or e-mail address");
        }
        Ok(Self { text, told, students, asked, problems, canvas, moodle: moodle.map(str::to_owned) })
    }

    /// How many variants of one part a student answered at most.
    pub fn most(&self) -> usize {
        self.asked.values().map(Vec::len).max().unwrap_or(0)
    }

    /// The set and the keys in which each student has the variants that `choose` chooses: among so many of a student (by id), a
    /// problem and a part, from 0.
    pub fn set(
        &self,
        (set, keys): (&StoredSet, &[SheetKey]),
        choose: &dyn Fn(&str, usize, usize, usize) -> usize,
    ) -> (StoredSet, Vec<SheetKey>) {
        let own: HashMap<&str, &SheetKey> = keys.iter().map(|k| (k.student.as_str(), k)).collect();
        let (mut students, mut sheets) = (self.students.clone(), Vec::with_capacity(self.students.len()));
        for student in &mut students {
            let id = student.student.clone();
            let of = own.get(id.as_str()).copied().or(keys.first());
            let keys_of = |key: &SheetKey| self.problems.iter().map(|p| key.problems[*p].clone()).collect();
            let mut problems: Vec<ProblemKey> = of.map_or_else(Vec::new, keys_of);
            student.problems = self.problems.iter().map(|p| student.problems[*p].clone()).collect();
            for (nth, (key, p)) in problems.iter_mut().zip(self.problems.iter().copied()).enumerate() {
                let chosen = (0..key.parts.len()).map(|part| {
                    let all = self.asked.get(&(id.clone(), nth, part))?;
                    all.get(choose(&id, nth, part, all.len()).min(all.len().saturating_sub(1))).copied()
                });
                let chosen: Vec<Option<usize>> = chosen.collect();
                let count = |s: usize| chosen.iter().filter(|c| **c == Some(s)).count();
                // That of most parts is the variant of the problem.
                let Some(main) = chosen.iter().flatten().copied().rev().max_by_key(|s| count(*s)) else {
                    continue;
                };
                *key = keys[main].problems[p].clone();
                let variant = |s: usize| {
                    let plain = BTreeMap::new();
                    StoredVariant { parts: plain, ..set.students[s].problems[p].clone() }
                };
                let mut stored = variant(main);
                for (part, other) in chosen.iter().enumerate().filter_map(|(i, s)| Some((i, (*s)?))) {
                    let part = key.parts[part].part.clone();
                    if keys[other].problems[p].code != key.code {
                        key.take_part(&part, &keys[other].problems[p]);
                        stored.parts.insert(part, variant(other));
                    }
                }
                student.problems[nth] = stored;
            }
            sheets.push(SheetKey { student: id, problems });
        }
        // Who has the same is a matter of the quiz.
        let problems = self.problems.iter().map(|p| set.problems[*p].clone()).collect();
        (StoredSet { students, problems, coincidences: Vec::new(), ..set.clone() }, sheets)
    }
}

/// The problems of the set that any attempt shows; all if none shows one, and those of the earlier grading where there is one.
fn problems(rows: &[QuizRow], set: &StoredSet, before: Option<&StoredSet>) -> Vec<usize> {
    let all = 0..set.problems.len();
    if let Some(before) = before {
        return all.filter(|p| before.problems.contains(&set.problems[*p])).collect();
    }
    let shown: BTreeSet<usize> =
        rows.iter().filter(|row| !row.code.is_empty()).filter_map(|row| row.at).collect();
    if shown.is_empty() { all.collect() } else { shown.into_iter().collect() }
}

/// Numbers the problems of the rows as those that were asked are numbered.
fn number(rows: &mut Vec<QuizRow>, set: &StoredSet, problems: &[usize]) {
    rows.retain_mut(|row| {
        let Some(p) = row.at else { return true };
        let Some(nth) = problems.iter().position(|asked| *asked == p) else {
            // An answer to what was not asked when it was first graded is told of; an empty one is no row.
            row.problem.clone_from(&set.problems[p]);
            row.of = None;
            return !row.code.is_empty();
        };
        row.problem = (nth + 1).to_string();
        row.of = row.of.map(|(_, part, s)| (nth, part, s));
        true
    });
}

/// A line on the problems that were not asked.
fn not_asked(set: &StoredSet, problems: &[usize]) -> String {
    let left: Vec<usize> = (0..set.problems.len()).filter(|p| !problems.contains(p)).collect();
    let some = terminal::first_of(left.iter().map(|p| format!("{} ({})", p + 1, set.problems[*p])), LISTED);
    if some.is_empty() {
        return String::new();
    }
    let numbers = problems.iter().enumerate().filter(|(nth, p)| nth != *p).take(LISTED);
    let numbers = numbers.map(|(nth, p)| format!("{} ({}) is problem {}", p + 1, set.problems[*p], nth + 1));
    let anew = numbers.collect::<Vec<_>>().join(", ");
    let anew = if anew.is_empty() { anew } else { format!("; in the grades {anew}") };
    let some = some.join(", ");
    format!("\n  Problems of the set that the quiz did not ask, and that do not count: {some}{anew}")
}

/// Which variants each student answered, in the order of the attempts; where a part was not answered, the last that was asked.
fn asked(quiz: &Quiz, rows: &[QuizRow], takers: &Takers, policy: &Policy) -> AskedVariants {
    let time = |attempt: usize| {
        let submitted = &quiz.attempts[attempt].submitted;
        policy.zone.read(submitted).map(|m| m.micros[usize::from(policy.day_first == Some(false))])
    };
    let times: Vec<Option<i64>> = (0..quiz.attempts.len()).map(time).collect();
    let mut found: HashMap<StudentPart, Vec<Answered>> = HashMap::new();
    for row in rows {
        let Some((p, part, s)) = row.of else { continue };
        let id = takers.who[row.attempt].0.clone();
        let answered = !row.answer.trim().is_empty();
        found.entry((id, p, part)).or_default().push((row.attempt, s, answered));
    }
    let most = policy.attempts.at_most.map_or(usize::MAX, |n| n as usize);
    let in_order = |(key, mut all): (StudentPart, Vec<Answered>)| {
        // Where one was submitted, those that never were count for nothing.
        let is_open = |attempt: usize| quiz.attempts[attempt].is_open();
        if all.iter().any(|(attempt, _, answered)| *answered && !is_open(*attempt)) {
            all.retain(|(attempt, ..)| !is_open(*attempt));
        }
        // As answers are ordered: by time if all times can be read, else as they stand.
        if all.iter().all(|(attempt, ..)| times[*attempt].is_some()) {
            all.sort_by_key(|(attempt, ..)| times[*attempt]);
        }
        let last = all.last().map(|(_, s, _)| *s);
        let mut order = Vec::new();
        for (_, s, _) in all.iter().filter(|(_, _, answered)| *answered).take(most) {
            // Of a variant that came twice the later attempt counts as its place.
            order.retain(|known| known != s || policy.attempts.counts == Counts::First);
            push_new(&mut order, *s);
        }
        if order.is_empty() {
            order.extend(last);
        }
        (key, order)
    };
    found.into_iter().map(in_order).collect()
}

/// Questions whose variant is not known, and how many answers they have.
fn unknown_codes(rows: &[QuizRow]) -> BTreeMap<&str, usize> {
    let mut unknown: BTreeMap<&str, usize> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.code.is_empty() && row.part.is_empty()) {
        *unknown.entry(&row.problem).or_default() += 1;
    }
    unknown
}

/// At most so many of them, by name.
fn listed(unknown: &BTreeMap<&str, usize>) -> String {
    terminal::first_of(unknown.keys().map(|code| beginning(code, SHORT)), LISTED).join(", ")
}

fn no_code(quiz: &Quiz, variants: &Variants, unknown: &BTreeMap<&str, usize>) -> Finding {
    let what = format!("no question shows the code of a variant of this set: {}", listed(unknown));
    let headers: BTreeSet<&str> =
        quiz.attempts.iter().flat_map(|a| a.answers.iter().map(|asked| asked.header.as_str())).collect();
    let has_codes = unknown.keys().any(|name| !headers.contains(name));
    let one = variants.by_code.keys().min().map_or("", String::as_str);
    let such = format!("a code looks like {one}, key.csv has them all");
    let hint = match quiz.platform {
        _ if has_codes => format!("the codes are of another set: give the set that was exported; {such}"),
        Platform::Moodle => format!(
            "tick `question text` above Moodle's report *Responses* and download it again, or give the set that was exported; {such}"
        ),
        Platform::Canvas => format!("give the set that was exported; {such}"),
    };
    Finding::new("header", what).hint(hint)
}

/// What the summary says of the quiz.
fn told(quiz: &Quiz, rows: &[QuizRow], takers: &Takers, unknown: &BTreeMap<&str, usize>) -> String {
    let people = takers.who.iter().map(|(id, _)| id).collect::<BTreeSet<_>>().len();
    let file = match quiz.platform {
        Platform::Moodle => "Moodle's responses",
        Platform::Canvas => "Canvas's student analysis",
    };
    let attempts = terminal::count(quiz.attempts.len(), "attempt");
    let mut text = format!("\n  from {file}: {attempts} by {}", terminal::count(people, "student"));
    let mut add = |line: String| text.extend(["\n  ", &line]);
    let some = |ids: &BTreeSet<String>| {
        let shown: Vec<String> = ids.iter().take(LISTED).map(|id| beginning(id, SHORT)).collect();
        format!("{}{}", shown.join(", "), if ids.len() > LISTED { ", ..." } else { "" })
    };
    if !takers.on_roster {
        let by = takers.by;
        add(format!(
            "None of them is on the roster of the set: the marks are of those who answered, by {by}."
        ));
    } else if !takers.strangers.is_empty() {
        add(format!("look at: not on the roster of the set: {}", some(&takers.strangers)));
    }
    let typed = |a: &QuizAttempt| a.answers.iter().any(is_typed);
    let open = quiz.attempts.iter().filter(|a| a.is_open() && typed(a)).count();
    if open > 0 {
        add(format!("never submitted, and judged all the same: {}", terminal::count(open, "attempt")));
    }
    if !unknown.is_empty() {
        let answers = terminal::count(unknown.values().sum::<usize>(), "answer");
        let list = listed(unknown);
        add(format!("look at: questions whose code is none of this set, with {answers}: {list}"));
    }
    let unplaced = rows.iter().filter(|row| row.of.is_none() && !row.code.is_empty()).count();
    if unplaced > 0 {
        let answers = terminal::count(unplaced, "answer");
        add(format!("look at: to which part of its problem it belongs is not known of {answers}"));
    }
    let mut twice: BTreeSet<String> = BTreeSet::new();
    let mut one: HashMap<(usize, usize, usize), &str> = HashMap::new();
    for row in rows {
        let Some((p, part, _)) = row.of else { continue };
        if *one.entry((row.attempt, p, part)).or_insert(&row.code) != row.code {
            twice.insert(takers.who[row.attempt].0.clone());
        }
    }
    if !twice.is_empty() {
        let who = some(&twice);
        add(format!(
            "look at: a question came twice in one attempt with different data, of which one counts: {who}"
        ));
    }
    text
}

/// The file of submissions. Only grading reads it, so that nothing is guarded against spreadsheets.
fn submissions(quiz: &Quiz, rows: &[QuizRow], takers: &Takers) -> Vec<u8> {
    let [line, code] = QUIZ_COLUMNS;
    let mut out = csv::Writer::from_writer(Vec::new());
    // Writing to a vector does not fail.
    let mut put = |record: [&str; 7]| out.write_record(record).unwrap_or_default();
    put([line, "student", "problem", "part", "answer", "submitted_at", code]);
    for row in rows {
        let answer = row.answer.replace(['\r', '\n'], " ");
        let (id, _) = &takers.who[row.attempt];
        let submitted = &quiz.attempts[row.attempt].submitted;
        put([&row.line.to_string(), id, &row.problem, &row.part, &answer, submitted, &row.code]);
    }
    out.into_inner().unwrap_or_default()
}
