//! What learning platforms tell of a quiz: the download of Moodle's responses report, and Canvas's student analysis. Which
//! column is which follows from their headers, in whatever order they stand; columns that were not asked for may be missing.
//!
//! Read from the platforms' own sources: moodle, `mod/quiz/report/responses` and `question/type/multianswer/question.php`;
//! instructure/canvas-lms, `app/models/quizzes/quiz_statistics/student_analysis.rb`.
use crate::answer::submissions::{Header, RecordSource};
use crate::csv_field::unguarded;
use crate::finding::Finding;
use std::io::{self, Read};

/// Where the quiz was taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Platform {
    Moodle,
    Canvas,
}

/// A quiz as it was taken.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Quiz {
    pub platform: Platform,
    /// In the order of the file.
    pub attempts: Vec<QuizAttempt>,
}

/// One attempt: a record of the file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct QuizAttempt {
    pub line: u64,
    /// What the student is known by: number, user name, e-mail address (Canvas: SIS id, login, own number); empty where the file
    /// does not say.
    pub ids: [String; 3],
    /// Name, given name first.
    pub name: String,
    /// When it was submitted; empty where it was not.
    pub submitted: String,
    /// What was written to the questions, of those that were asked.
    pub answers: Vec<QuizAnswer>,
}

impl QuizAttempt {
    /// Was it never submitted?
    pub fn is_open(&self) -> bool {
        self.submitted.is_empty()
    }
}

/// What was written to a question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct QuizAnswer {
    /// What stands above the column.
    pub header: String,
    /// The text of the question, as far as the file tells it.
    pub question: String,
    pub written: QuizText,
}

/// An answer as a platform tells it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum QuizText {
    /// None was given.
    Nothing,
    /// One for each part, in their order.
    Parts(Vec<String>),
    /// A text, which is one answer, or as a list of Canvas's several.
    Whole {
        /// As it was typed.
        text: String,
        list: Vec<String>,
    },
}

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ColumnRole {
    Id(usize),
    GivenName,
    FamilyName,
    FullName,
    Began,
    Submitted,
    /// Text of the question of this number.
    Question(u32),
    /// Answer to the question of this number.
    Response(u32),
    /// Answer to the question in the header; the column behind it has its points.
    Asked,
    Other,
}

/// Columns of Moodle, English and German; those of earlier versions too.
const MOODLE: [(ColumnRole, &[&str]); 8] = [
    (ColumnRole::Id(0), &["id number", "idnumber", "id-nummer", "matrikelnummer"]),
    (ColumnRole::Id(1), &["username", "anmeldename", "benutzername"]),
    (ColumnRole::Id(2), &["email address", "email", "e-mail-adresse", "e-mail"]),
    (ColumnRole::GivenName, &["first name", "vorname"]),
    (ColumnRole::FamilyName, &["last name", "surname", "nachname"]),
    (ColumnRole::FullName, &["full name", "vollständiger name"]),
    (ColumnRole::Began, &["started on", "started", "begonnen am", "begonnen", "gestartet"]),
    (ColumnRole::Submitted, &["completed", "completed on", "beendet", "beendet am", "abgeschlossen"]),
];

const CANVAS: [(ColumnRole, &[&str]); 5] = [
    (ColumnRole::Id(0), &["sis id", "sis user id"]),
    (ColumnRole::Id(1), &["login", "login id", "sis login id"]),
    (ColumnRole::Id(2), &["id"]),
    (ColumnRole::FullName, &["name"]),
    (ColumnRole::Submitted, &["submitted"]),
];

/// `Response 3`: the 3.
fn numbered(header: &str, words: &[&str]) -> Option<u32> {
    let (word, number) = header.rsplit_once(' ')?;
    words.contains(&word.trim_end()).then(|| number.parse().ok())?
}

/// `1234567: How large is ...`
fn is_asked(header: &str) -> bool {
    header.split_once(':').is_some_and(|(id, _)| !id.is_empty() && id.bytes().all(|b| b.is_ascii_digit()))
}

fn plain(header: &str) -> String {
    header.trim().to_lowercase().replace(['_', '\u{a0}'], " ")
}

fn roles(platform: Platform, header: &Header) -> Vec<ColumnRole> {
    let role = |text: &String| {
        let plain = plain(text);
        let named: &[(ColumnRole, &[&str])] = match platform {
            Platform::Moodle => &MOODLE,
            Platform::Canvas => &CANVAS,
        };
        if let Some((role, _)) = named.iter().find(|(_, names)| names.contains(&plain.as_str())) {
            return *role;
        }
        match platform {
            Platform::Canvas if is_asked(text) => ColumnRole::Asked,
            Platform::Canvas => ColumnRole::Other,
            Platform::Moodle => numbered(&plain, &["response", "antwort"])
                .map(ColumnRole::Response)
                .or_else(|| numbered(&plain, &["question", "frage"]).map(ColumnRole::Question))
                .unwrap_or(ColumnRole::Other),
        }
    };
    header.fields.iter().map(role).collect()
}

/// Which platform wrote a file with this header.
fn platform(header: &Header) -> Option<Platform> {
    let moodle = roles(Platform::Moodle, header);
    let person = |role: &ColumnRole| {
        matches!(
            role,
            ColumnRole::Id(_) | ColumnRole::GivenName | ColumnRole::FamilyName | ColumnRole::FullName
        )
    };
    if moodle.iter().any(|role| matches!(role, ColumnRole::Response(_))) && moodle.iter().any(person) {
        return Some(Platform::Moodle);
    }
    let canvas = roles(Platform::Canvas, header);
    let is_canvas = canvas.contains(&ColumnRole::Asked) && canvas.contains(&ColumnRole::Submitted);
    is_canvas.then_some(Platform::Canvas)
}

/// The other reports of a Moodle quiz have marks, and no answers.
fn is_marks(header: &Header) -> bool {
    let moodle = roles(Platform::Moodle, header);
    let marks = |text: &String| {
        let text = plain(text);
        let rest = text.strip_prefix("q.").or_else(|| text.strip_prefix("f ")).unwrap_or_default();
        rest.split_once('/').is_some_and(|(number, _)| number.trim().parse::<u32>().is_ok())
    };
    moodle.contains(&ColumnRole::Began) && header.fields.iter().any(marks)
}

/// Reads the download of a quiz; `None` where the file is none. Errors: those of the reader; or the file is of a quiz and has no
/// answers.
pub fn read(inner: Box<dyn Read + Send>) -> io::Result<Result<Option<Quiz>, Finding>> {
    let (mut source, header) = RecordSource::open(inner)?;
    let Some(header) = header else { return Ok(Ok(None)) };
    let Some(platform) = platform(&header) else {
        if is_marks(&header) {
            let what = "is Moodle's report of marks, which has no answers";
            let hint = "download the report *Responses* (Results, Responses) with `question text` and `response` ticked";
            return Ok(Err(Finding::new("header", what).at(header.line as usize, 1).hint(hint)));
        }
        return Ok(Ok(None));
    };
    let reader = QuizReader { platform, roles: roles(platform, &header), header };
    let mut attempts = Vec::new();
    source.each(|record| {
        let text = |i: usize| String::from_utf8_lossy(record.get(i).unwrap_or_default()).into_owned();
        attempts.extend(reader.attempt(record.line, &text));
    })?;
    Ok(Ok(Some(Quiz { platform, attempts })))
}

struct QuizReader {
    platform: Platform,
    roles: Vec<ColumnRole>,
    header: Header,
}

impl QuizReader {
    /// A record as an attempt; `None` where nothing stands in it, and for the mean that some versions put at the end.
    fn attempt(&self, line: u64, field: &dyn Fn(usize) -> String) -> Option<QuizAttempt> {
        const MEANS: [&str; 4] =
            ["overall average", "group average", "gesamtdurchschnitt", "gruppendurchschnitt"];
        let mut attempt = QuizAttempt { line, ..QuizAttempt::default() };
        let (mut given, mut family) = (String::new(), String::new());
        let mut empty = true;
        for (i, role) in self.roles.iter().enumerate() {
            let raw = field(i);
            empty &= raw.trim().is_empty();
            let text = || said(&raw);
            match role {
                ColumnRole::Id(kind) => attempt.ids[*kind] = text(),
                ColumnRole::GivenName => given = text(),
                ColumnRole::FamilyName => family = text(),
                ColumnRole::FullName => attempt.name = text(),
                ColumnRole::Submitted => attempt.submitted = text(),
                ColumnRole::Response(_) | ColumnRole::Asked => {
                    attempt.answers.extend(self.answer(i, &raw, field))
                }
                ColumnRole::Began | ColumnRole::Question(_) | ColumnRole::Other => {}
            }
        }
        if !(given.is_empty() && family.is_empty()) {
            attempt.name = format!("{given} {family}").trim().to_owned();
        }
        let mean =
            attempt.ids.iter().all(String::is_empty) && MEANS.contains(&attempt.name.to_lowercase().as_str());
        (!empty && !mean).then_some(attempt)
    }

    /// What was written to a question, if it was asked in this attempt.
    fn answer(&self, i: usize, raw: &str, field: &dyn Fn(usize) -> String) -> Option<QuizAnswer> {
        let header = self.header.fields[i].clone();
        let (question, written) = match (self.platform, self.roles[i]) {
            (Platform::Moodle, ColumnRole::Response(n)) => {
                let question = self.roles.iter().position(|role| *role == ColumnRole::Question(n));
                (question.map(|at| said(&field(at))).unwrap_or_default(), moodle(raw))
            }
            // No answer and no points: the question is of another variant.
            _ if raw.trim().is_empty() && field(i + 1).trim().is_empty() => return None,
            _ => (header.clone(), canvas(raw)),
        };
        // An attempt that was never begun has a dash everywhere.
        let asked = !(question.is_empty() && written == QuizText::Nothing);
        asked.then_some(QuizAnswer { header, question, written })
    }
}

/// A cell without blanks around it; a dash stands for nothing.
fn said(raw: &str) -> String {
    let text = unguarded(raw.trim()).trim();
    if text == "-" { String::new() } else { text.to_owned() }
}

/// An answer of Moodle: of a cloze question `part 1: 12.3; part 2: right`.
fn moodle(raw: &str) -> QuizText {
    let text = raw.trim();
    if text.is_empty() || text == "-" {
        return QuizText::Nothing;
    }
    match cloze(text) {
        Some(parts) => QuizText::Parts(parts),
        None => QuizText::Whole { text: text.to_owned(), list: vec![text.to_owned()] },
    }
}

/// The answers behind `part 1:`, `; part 2:` and so on, whatever the word for a part is.
fn cloze(text: &str) -> Option<Vec<String>> {
    let at = text.find('1')?;
    let word = &text[..at];
    let is_word = word.trim_end().chars().all(char::is_alphabetic) && word.ends_with([' ', '\u{a0}']);
    let rest = &text[at + 1..];
    let colon = rest.find(':').filter(|colon| rest[..*colon].trim().is_empty())?;
    if !is_word || word.trim().is_empty() {
        return None;
    }
    let gap = &rest[..=colon];
    let mut rest = &rest[colon + 1..];
    let mut parts = Vec::new();
    for number in 2.. {
        let mark = format!("; {word}{number}{gap}");
        let Some(next) = rest.find(&mark) else { break };
        parts.push(said(&rest[..next]));
        rest = &rest[next + mark.len()..];
    }
    parts.push(said(rest));
    Some(parts)
}

/// An answer of Canvas: of a question with several blanks a list, where `\,` is a comma of an answer.
fn canvas(raw: &str) -> QuizText {
    let text = unguarded(raw.trim()).trim();
    if text.is_empty() {
        return QuizText::Nothing;
    }
    let (mut list, mut item) = (Vec::new(), String::new());
    let mut letters = text.chars().peekable();
    while let Some(c) = letters.next() {
        match c {
            '\\' if letters.next_if_eq(&',').is_some() => item.push(','),
            ',' => list.push(said(&std::mem::take(&mut item))),
            c => item.push(c),
        }
    }
    list.push(said(&item));
    QuizText::Whole { text: text.replace("\\,", ","), list }
}

/// A word that may be the code of a variant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CodeWord<'t> {
    /// In small letters, with digits for letters that are taken for them.
    pub code: String,
    /// `Code` stands shortly before it: `Code: 4f7k2m9q`, `Code of these data: 4f7k2m9q`.
    pub called: bool,
    /// What follows it.
    pub rest: &'t str,
}

/// Digits of a code.
const CODE: usize = 8;
/// A code stands at most so many words behind the word `code`.
const NEAR: usize = 4;

/// The words of a text that are as long as a code.
pub fn code_words(text: &str) -> Vec<CodeWord<'_>> {
    let (mut found, mut since, mut at) = (Vec::new(), NEAR, 0);
    for word in text.split(|c: char| !c.is_alphanumeric()) {
        let end = at + word.len();
        if word.len() == CODE && word.is_ascii() {
            let digit = |c: char| match c.to_ascii_lowercase() {
                'o' => '0',
                'i' | 'l' => '1',
                c => c,
            };
            let (code, rest) = (word.chars().map(digit).collect(), &text[end..]);
            found.push(CodeWord { code, called: since < NEAR, rest });
        }
        if !word.is_empty() {
            since = if word.eq_ignore_ascii_case("code") { 0 } else { (since + 1).min(NEAR) };
        }
        // Behind the mark that ends the word.
        at = end + text[end..].chars().next().map_or(0, char::len_utf8);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn quiz(text: &str) -> Option<Quiz> {
        read(Box::new(std::io::Cursor::new(text.as_bytes().to_vec()))).unwrap().unwrap()
    }

    #[test]
    fn cloze_answers_come_apart() {
        let parts = |text: &str| match moodle(text) {
            QuizText::Parts(parts) => parts.join("|"),
            other => format!("{other:?}"),
        };
        assert_eq!(parts("part 1: 12.3; part 2: up"), "12.3|up");
        assert_eq!(parts("Teil 1: 12,3 rad/s; Teil 2: ; Teil 3: -"), "12,3 rad/s||");
        assert_eq!(parts("partie 1 : 1; partie 2 : 2"), "1|2");
        assert_eq!(parts("part 1: "), "");
        assert_eq!(parts("part 1: a; part 3: b; part 2: c"), "a; part 3: b|c");
        assert_eq!(moodle(" - "), QuizText::Nothing);
        for whole in ["12.3 rad/s", "1: 2", "1,5", "part 2: 5", "up 1 m: 3"] {
            assert!(matches!(moodle(whole), QuizText::Whole { .. }), "{whole}");
        }
    }

    #[test]
    fn lists_of_canvas_come_apart() {
        let list = |text: &str| match canvas(text) {
            QuizText::Whole { list, .. } => list.join("|"),
            other => format!("{other:?}"),
        };
        assert_eq!(list("12\\,3 rad/s,up,"), "12,3 rad/s|up|");
        assert_eq!(list("a\\b,-"), "a\\b|");
        assert_eq!(canvas(" "), QuizText::Nothing);
    }

    #[test]
    fn which_file_is_which() {
        let moodle = "Nachname;Vorname;E-Mail-Adresse;Status;Begonnen am;Beendet;Frage 1;Antwort 1\n\
            Yusuf;Amina;a@b.c;Beendet;1. März 2026 10:00;1. März 2026 10:30;Code: 4f7k2m9q;Teil 1: 3\n\
            Gesamtdurchschnitt;;;;;;;\n";
        let found = quiz(moodle).unwrap();
        assert_eq!((found.platform, found.attempts.len()), (Platform::Moodle, 1));
        let one = &found.attempts[0];
        assert_eq!((one.name.as_str(), one.ids[2].as_str()), ("Amina Yusuf", "a@b.c"));
        assert_eq!(one.answers[0].question, "Code: 4f7k2m9q");
        let canvas = "name,id,section,submitted,\"12: Code: 4f7k2m9q\",1.0,13: other,1.0,n correct\n\
            A,5,s,2026-03-01 10:00:00 UTC,3,0.0,,,1\n";
        let found = quiz(canvas).unwrap();
        assert_eq!((found.platform, found.attempts[0].answers.len()), (Platform::Canvas, 1));
        for other in [
            "student,problem,part,answer\na,1,v,3\n",
            "Timestamp,Email address,1.omega\nx,y,3\n",
            "Email address,Question 1\na,b\n",
            "",
        ] {
            assert_eq!(quiz(other), None, "{other}");
        }
        let marks = "Last name,First name,Started on,Grade/10.00,Q. 1 /5.00\nA,B,x,3,3\n";
        let fault = read(Box::new(std::io::Cursor::new(marks.as_bytes().to_vec()))).unwrap().unwrap_err();
        assert!(fault.to_string().contains("report of marks"), "{fault}");
    }

    #[test]
    fn codes_are_found_in_any_spelling() {
        let found = code_words("Distance CODE: 4F7K2M9Q.omega, ä4f7k2m9q of what lies there: oil01234");
        let shown: Vec<_> = found.iter().map(|w| (w.code.as_str(), w.called, w.rest.len())).collect();
        assert_eq!(shown, [("d1stance", false, 62), ("4f7k2m9q", true, 47), ("01101234", false, 0)]);
        assert!(code_words("Code of these data: 4f7k2m9q")[0].called);
        assert!(code_words("Code dieser Daten: 4f7k2m9q")[0].called);
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "\\PC{0,60}", near in "(part 1: |; part [0-9]: |[0-9,\\\\;: -]){0,12}") {
            for text in [&text, &near] {
                let _ = (moodle(text), canvas(text), code_words(text));
                let _ = quiz(&format!("name,id,submitted,1: {text},1.0\n{text},{text},{text}"));
                let _ = quiz(&format!("Surname,Question 1,Response 1\n{text},{text},{text}"));
            }
        }

        /// What students type comes back part by part, whatever it is.
        #[test]
        fn answers_come_back(typed in prop::collection::vec("[0-9a-z,.; :/-]{0,12}", 1..6), german: bool) {
            let word = if german { "Teil" } else { "part" };
            let text: Vec<String> =
                (1..).zip(&typed).map(|(i, answer)| format!("{word} {i}: {answer}")).collect();
            let trimmed: Vec<String> = typed.iter().map(|answer| said(answer)).collect();
            prop_assert_eq!(moodle(&text.join("; ")), QuizText::Parts(trimmed.clone()));
            let list: Vec<String> = typed.iter().map(|answer| answer.replace(',', "\\,")).collect();
            if let QuizText::Whole { list, .. } = canvas(&format!("{},x", list.join(","))) {
                prop_assert_eq!(&list[..typed.len()], &trimmed[..]);
            }
        }
    }
}
