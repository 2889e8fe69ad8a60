//! Rosters, and student ids as names of folders.
use crate::answer::submissions::RecordSource;
use crate::csv_field::unguarded;
use crate::finding::{Finding, Findings};
use rustc_hash::FxHashMap;
use std::io::Cursor;
use unicode_normalization::UnicodeNormalization;

/// Reads a roster: columns `student` and, if there is one, `name`; encodings and delimiters as for submissions.
/// Gives (id, name) in the order of the file.
/// Errors: all faults at once: missing columns, blank and duplicate ids, records that do not fit the header.
pub fn roster(bytes: &[u8]) -> Result<Vec<(String, String)>, Findings> {
    let unread = |fault: std::io::Error| Finding::new("roster", fault.to_string());
    let (mut source, header) = RecordSource::open(Box::new(Cursor::new(bytes.to_vec()))).map_err(unread)?;
    let Some(header) = header else {
        return Err(Finding::new("header", "the roster is empty")
            .hint("the first line is `student,name`")
            .into());
    };
    let place = |line: u64| usize::try_from(line).unwrap_or(usize::MAX);
    let mut findings = Findings::default();
    let mut column = |name: &str| {
        let hits: Vec<usize> =
            (0..header.fields.len()).filter(|i| header.fields[*i].to_lowercase() == name).collect();
        if hits.len() > 1 {
            let twice = Finding::new("header", format!("column `{name}` stands there {} times", hits.len()));
            findings.push(twice.at(place(header.line), 1));
        }
        hits.first().copied()
    };
    let (student, name) = (column("student"), column("name"));
    let Some(student) = student else {
        let missing = Finding::new("header", "no column `student`").at(place(header.line), 1);
        findings.push(missing.hint(format!(
            "name the column with the ids `student`, and one with names `name`; the columns are: {}",
            header.fields.join(" | ")
        )));
        return Err(findings);
    };
    let mut all: Vec<(String, String)> = Vec::new();
    let mut seen: FxHashMap<String, u64> = FxHashMap::default();
    let read = source.each(|r| {
        let line = r.line;
        let raw = |i: usize| String::from_utf8_lossy(r.get(i).unwrap_or_default()).into_owned();
        let text = |i: usize| unguarded(raw(i).trim()).to_owned();
        let empty = |from: usize| (from..r.len()).all(|i| text(i).is_empty());
        if empty(0) {
            return;
        }
        if r.fault.is_some() {
            let odd = Finding::new("record", "bytes that cannot be read").at(place(line), 1);
            findings.push(odd.hint("save the roster as UTF-8"));
            return;
        }
        if !empty(header.fields.len()) {
            let odd = format!("{} fields where the header has {}", r.len(), header.fields.len());
            let odd = Finding::new("record", odd).at(place(line), 1);
            findings.push(odd.hint("put a name with a comma in quotes"));
            return;
        }
        let id = text(student);
        let seen_as = composed(&id);
        let mut refuse = |what: String, hint: &str| {
            let odd = Finding::new("student", what).at(place(line), student + 1);
            findings.push(if hint.is_empty() { odd } else { odd.hint(hint) });
        };
        // A quote that is not closed in its line, where the lines after it look like records: the id was on two lines.
        let broken = r.open && raw(student).trim_start().starts_with('"');
        if broken || raw(student).contains(line_break) {
            let what = format!("`{}` has a line break", raw(student).escape_debug());
            refuse(what, "write the id on one line, without a quote that is left open");
        } else if id.is_empty() {
            refuse("the id is blank".to_owned(), "");
        } else if id.chars().any(char::is_control) {
            refuse(format!("`{}` has a control character", id.escape_debug()), "");
        } else if id.len() > 100 {
            refuse("the id is longer than 100 bytes".to_owned(), "");
        } else if let Some(first) = seen.get(&seen_as) {
            refuse(format!("`{id}` stands on lines {first} and {line}"), "keep one of them");
        } else {
            seen.insert(seen_as, line);
            all.push((id, name.map(text).unwrap_or_default()));
        }
    });
    read.map_err(unread)?;
    if all.is_empty() && findings.is_empty() {
        findings.push(Finding::new("roster", "no student").at(place(header.line), 1));
    }
    findings.into_result(all)
}

/// An id with each accent coded with its letter: it may be a mark of its own behind it, and nobody sees which.
pub fn composed(id: &str) -> String {
    id.nfc().collect()
}

/// What ids share that people take for one: upper and lower case are alike, and so are the codes of an accent and the forms of an
/// apostrophe.
///
/// ```
/// use slipstick::answer::roster::folded;
/// assert_eq!((folded("Jose\u{301}"), folded("O\u{2019}Neil")), (folded("JOS\u{c9}"), folded("o'neil")));
/// ```
pub fn folded(id: &str) -> String {
    let apostrophe = |c: char| if matches!(c, '\u{2018}' | '\u{2019}' | '\u{b4}' | '`') { '\'' } else { c };
    id.nfc().map(apostrophe).flat_map(char::to_lowercase).collect()
}

fn line_break(c: char) -> bool {
    matches!(c, '\n'..='\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// A student id as the name of a folder that every system takes. Small letters, digits and `_ - .` inside stay; a capital
/// gets `^` in front, so that ids which differ only in case stay apart where case does not count; anything else becomes
/// `%XX` of its bytes, letters of other scripts stay. A name that Windows keeps for itself (`con`, `nul`, `com1`) and a
/// leading or trailing point are written with `%XX` too.
///
/// ```
/// use slipstick::answer::roster::folder;
/// assert_eq!((folder("s001"), folder("../x"), folder("CON")), ("s001".into(), "%2E.%2Fx".into(), "^C^O^N".into()));
/// ```
pub fn folder(id: &str) -> String {
    let mut out = String::with_capacity(id.len());
    let last = id.char_indices().next_back().map_or(0, |(i, _)| i);
    let reserved = is_reserved(id);
    for (i, c) in id.char_indices() {
        // a letter is kept where its case is settled and it has only one form
        let kept = match c {
            'a'..='z' | '0'..='9' | '_' | '-' => !(reserved && i == 0),
            '.' => i != 0 && i != last,
            c => {
                !c.is_ascii()
                    && c.is_alphabetic()
                    && c.to_lowercase().eq([c])
                    && c.to_uppercase().count() == 1
                    && !decomposes(c)
            }
        };
        if kept {
            out.push(c);
        } else if c.is_ascii_uppercase() {
            out.push('^');
            out.push(c);
        } else {
            let mut bytes = [0u8; 4];
            for b in c.encode_utf8(&mut bytes).bytes() {
                out.push_str(&format!("%{b:02X}"));
            }
        }
    }
    out
}

/// Letters that file systems may rewrite to a base letter and a mark (Hangul, Latin with accents beyond Latin-1, ...).
fn decomposes(c: char) -> bool {
    !matches!(c, '\u{df}'..='\u{ff}' | '\u{3b1}'..='\u{3c9}' | '\u{430}'..='\u{44f}' | '\u{4e00}'..='\u{9fff}')
        || matches!(c, '\u{439}' | '\u{3c2}' | '\u{f7}')
}

fn is_reserved(id: &str) -> bool {
    let stem = id.split('.').next().unwrap_or_default();
    matches!(stem, "con" | "prn" | "aux" | "nul")
        || (stem.len() == 4
            && (stem.starts_with("com") || stem.starts_with("lpt"))
            && stem.ends_with(|c: char| c.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The student id of a folder, if `folder` made it.
    fn unfolder(name: &str) -> Option<String> {
        let mut bytes = Vec::with_capacity(name.len());
        let mut chars = name.bytes();
        while let Some(b) = chars.next() {
            match b {
                b'^' => bytes.push(chars.next().filter(u8::is_ascii_uppercase)?),
                b'%' => {
                    let digit = |b: u8| char::from(b).to_digit(16);
                    let (high, low) = (digit(chars.next()?)?, digit(chars.next()?)?);
                    bytes.push((high * 16 + low) as u8);
                }
                b => bytes.push(b),
            }
        }
        let id = String::from_utf8(bytes).ok()?;
        (folder(&id) == name).then_some(id)
    }
    use proptest::prelude::*;

    #[test]
    fn reads_and_collects_all_faults() {
        let text = "Student;Name\r\n00123;\"Bär, Ada\"\r\nb ;\r\n;\r\n";
        let want = vec![("00123".to_owned(), "Bär, Ada".to_owned()), ("b".to_owned(), String::new())];
        assert_eq!(roster(text.as_bytes()).unwrap(), want);
        let faults = roster(b"student,name\na,A\n,B\na,C\nc,D,E\n").unwrap_err();
        let shown: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert_eq!(
            shown,
            [
                "line 3, column 1: student: the id is blank",
                "line 4, column 1: student: `a` stands on lines 2 and 4\n    hint: keep one of them",
                "line 5, column 1: record: 3 fields where the header has 2\n    hint: put a name with a comma in quotes",
            ]
        );
        let guarded = roster(b"student,name\n'=cmd,'+x\n'30,a\n").unwrap();
        assert_eq!(
            guarded,
            [("=cmd".into(), "+x".into()), ("'30".into(), "a".into())] as [(String, String); 2]
        );
        assert!(roster(b"").is_err() && roster(b"id\n1\n").is_err() && roster(b"student\n").is_err());
    }

    /// The reader of submissions takes a quote that is left open for a character, so `"a\nb",x` became two students, `"a` and
    /// `b"`, and blanks around an id were taken off with the line breaks among them.
    #[test]
    fn an_id_with_a_line_break_is_refused() {
        for text in [
            "student,name\n\"a\nb\",x\n",
            "student,name\n\"a\r\nb\",\"x\"\n",
            "student\n\"a\nb\"\n",
            "student,name\n\"a\n\",x\n",
            "student,name\n\"\na\",x\n",
            "name,student\nx,\"a\nb\"\n",
            "student,name\na\u{2028}b,x\n",
            "student,name\na\u{85},x\n",
        ] {
            let faults = roster(text.as_bytes()).expect_err(text);
            assert!(faults[0].message.contains("has a line break"), "{text:?}: {faults:?}");
        }
    }

    #[test]
    fn folders() {
        for (id, name) in [
            ("s001", "s001"),
            ("a/b", "a%2Fb"),
            ("con", "%63on"),
            ("com1.x", "%63om1.x"),
            ("x.", "x%2E"),
            ("x ", "x%20"),
            ("Ada", "^Ada"),
            ("..", "%2E%2E"),
            ("a%b^", "a%25b%5E"),
            ("müller", "müller"),
            ("Ü", "%C3%9C"),
            ("com10", "com10"),
        ] {
            assert_eq!(folder(id), name);
            assert_eq!(unfolder(name).as_deref(), Some(id));
        }
        assert_eq!(unfolder("%41"), None);
    }

    proptest! {
        #[test]
        fn folders_go_back_and_stay_apart(a in "\\PC{1,20}", b in "[aAbB./ %^]{1,6}", c in "[aAbB./ %^]{1,6}") {
            for id in [&a, &b, &c] {
                let name = folder(id);
                let back = unfolder(&name);
                prop_assert_eq!(back.as_deref(), Some(id.as_str()));
                prop_assert!(!name.contains(['/', '\\', ':', '*', '?', '"', '<', '>', '|', '\0']));
                prop_assert!(!name.ends_with(['.', ' ']) && !name.starts_with('.'));
            }
            prop_assert_eq!(b == c, folder(&b).to_lowercase() == folder(&c).to_lowercase());
        }

        #[test]
        fn no_roster_panics(bytes in prop::collection::vec(any::<u8>(), 0..300), name in "\\PC{0,20}") {
            let _ = roster(&bytes);
            let _ = roster(&[b"student,name\n".as_slice(), &bytes].concat());
            let _ = unfolder(&name);
        }
    }
}
