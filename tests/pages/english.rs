//! English as a lecturer would write it, in all that students and instructors read: the texts themselves and the pages made of
//! them. Each rule is a usage that German suggests and English does not have; what is good English of the same words is listed.
//!
//! Earlier tests looked at texts only for places that nothing filled: a sentence of wrong words is as whole as any.
use crate::support;
use slipstick::problem::maker::Maker;
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::solution;
use slipstick::words::Words;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// A usage that is not wanted; what to write; the same words in a sense that is good English.
struct Rule {
    unwanted: &'static [&'static str],
    instead: &'static str,
    fine: &'static [&'static str],
}

const RULES: &[Rule] = &[
    Rule { unwanted: &["road", "roads"], instead: "method", fine: &[] },
    Rule {
        unwanted: &["way", "ways"],
        instead: "distance, displacement, path, direction, method",
        fine: &["the other way", "by the way", "in this way", "in the same way"],
    },
    Rule {
        unwanted: &[
            "at the moment",
            "at that moment",
            "at this moment",
            "at each moment",
            "at every moment",
            "at any moment",
            "moment at which",
            "moment in which",
            "moment when",
            "moment considered",
            "moment that is asked",
            "moment of release",
            "moment of greatest",
            "consider the moment",
            "a later moment",
            "the wrong moment",
            "the right moment",
            "both moments",
            "about a moment",
            "from that moment",
            "up to that moment",
            "until that moment",
            "the same moment",
        ],
        instead: "instant (a moment is one of force or inertia)",
        fine: &[
            "both moments of inertia",
            "the same moment of inertia",
            "about a moment of",
            "the wrong moment of inertia",
        ],
    },
    Rule {
        unwanted: &["rolling friction", "friction of rolling", "friction of a rolling", "rolling's friction"],
        instead: "static friction (rolling friction is the resistance of soft wheels)",
        fine: &["static friction of a rolling"],
    },
    Rule {
        unwanted: &["(c + p)/c", "(c+p)/c", "omega p$", "omega c$"],
        instead: "the letters of the sheet, R and r",
        fine: &[],
    },
    Rule {
        unwanted: &["on a level", "along a level", "on the level"],
        instead: "on level ground",
        fine: &[
            "a level lane",
            "a level floor",
            "a level surface",
            "a level track",
            "a level plane",
            "the level lane",
        ],
    },
    Rule { unwanted: &["be rid of", "get rid of"], instead: "eliminate", fine: &[] },
    Rule { unwanted: &["divided by each other"], instead: "dividing one by the other", fine: &[] },
    Rule { unwanted: &["reckoned", "reckon"], instead: "referred to, taken, measured", fine: &[] },
    Rule {
        unwanted: &["the works", "two works", "works of the", "works cancel"],
        instead: "work (it has no plural)",
        fine: &["cord that works"],
    },
    Rule { unwanted: &["heat is made", "makes heat", "has made"], instead: "dissipates energy", fine: &[] },
    Rule { unwanted: &["torn loose"], instead: "breaks loose", fine: &[] },
    Rule { unwanted: &["works over"], instead: "does work over", fine: &[] },
    Rule {
        unwanted: &["has no lever,", "has no lever there", "no lever about"],
        instead: "lever arm",
        fine: &[],
    },
    Rule { unwanted: &["without bound"], instead: "becomes very large", fine: &[] },
    Rule { unwanted: &["theorem of parallel axes"], instead: "parallel-axis theorem", fine: &[] },
];

/// What the rules find in a text, one line each.
fn unwanted(text: &str) -> Vec<String> {
    let plain = text.to_lowercase().split_whitespace().collect::<Vec<_>>().join(" ");
    let mut found = Vec::new();
    for rule in RULES {
        let mut plain = plain.clone();
        for fine in rule.fine {
            plain = plain.replace(fine, "");
        }
        for word in rule.unwanted {
            let hits = plain.match_indices(word).filter(|(at, _)| {
                let letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
                let open =
                    word.starts_with(char::is_alphanumeric) && letter(plain[..*at].chars().next_back());
                let close =
                    word.ends_with(char::is_alphanumeric) && letter(plain[at + word.len()..].chars().next());
                !open && !close
            });
            for (at, _) in hits {
                let from = plain[..at].char_indices().rev().nth(30).map_or(0, |(i, _)| i);
                let to = plain[at..].char_indices().nth(40).map_or(plain.len(), |(i, _)| at + i);
                found.push(format!("`{word}` in `{}`: write {}", &plain[from..to], rule.instead));
            }
        }
    }
    found
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The strings of a YAML file, with the path of each; keys, comments and places to fill in are no text.
fn strings(file: &Path) -> Vec<(String, String)> {
    fn walk(path: &str, value: &serde_json::Value, out: &mut Vec<(String, String)>) {
        match value {
            serde_json::Value::String(text) => out.push((path.to_owned(), without_places(text))),
            serde_json::Value::Array(items) => {
                for (i, item) in items.iter().enumerate() {
                    walk(&format!("{path}[{i}]"), item, out);
                }
            }
            serde_json::Value::Object(fields) => {
                for (name, item) in fields {
                    walk(&format!("{path}.{name}"), item, out);
                }
            }
            _ => {}
        }
    }
    let text = fs::read_to_string(file).expect("a file of texts");
    // One word list has a text and a list of the same name.
    let options = serde_yaml::options! { duplicate_keys: serde_yaml::DuplicateKeyPolicy::LastWins };
    let value: serde_json::Value = serde_yaml::from_str_with_options(&text, options).expect("YAML");
    let mut out = Vec::new();
    walk("", &value, &mut out);
    out
}

/// A text without `{place}`, `{{ place }}` and `{% tag %}`.
fn without_places(text: &str) -> String {
    let mut out = String::new();
    let mut depth = 0usize;
    for c in text.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            c if depth == 0 => out.push(c),
            _ => {}
        }
    }
    out
}

fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect(folder);
    let mut all: Vec<PathBuf> = entries.map(|e| e.expect("entry").path()).collect();
    all.retain(|f| f.extension().is_some_and(|e| e == ending));
    all.sort();
    all
}

#[test]
fn no_text_is_english_of_another_language() {
    let mut faults = Vec::new();
    let mut count = 0;
    for file in files("templates/words", "yaml").into_iter().chain(files("banks", "yaml")) {
        for (path, text) in strings(&file) {
            count += 1;
            faults.extend(unwanted(&text).into_iter().map(|f| format!("{}{path}: {f}", file.display())));
        }
    }
    for folder in ["templates", "templates/statement", "templates/solution"] {
        for file in files(folder, "md") {
            let text = fs::read_to_string(&file).expect("a template");
            count += 1;
            faults.extend(
                unwanted(&without_places(&text)).into_iter().map(|f| format!("{}: {f}", file.display())),
            );
        }
    }
    // What commands print has its own texts, and names of fields are no English.
    for file in files("templates/manual", "md").into_iter().chain([root().join("README.md")]) {
        let text = fs::read_to_string(&file).expect("a text for people");
        let prose = text.split("```").step_by(2).flat_map(|t| t.split('`').step_by(2));
        let prose = prose.collect::<Vec<_>>().join(" ");
        count += 1;
        faults.extend(unwanted(&prose).into_iter().map(|f| format!("{}: {f}", file.display())));
    }
    assert!(count > 1000, "{count} texts");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The pages, with all that code puts into them.
#[test]
fn no_sheet_or_solution_is_english_of_another_language() {
    let words = Words::english();
    let mut faults = BTreeSet::new();
    let mut pages = 0;
    for bank in support::banks_in("en") {
        let templates = support::templates("en", &bank);
        for (index, problem) in bank.problems.iter().enumerate() {
            let maker = Maker::new(problem, 11, "english");
            let sheets = Sheets::new(&templates, &words, &bank, "english", &[index]).expect("templates");
            let mut room = SheetScratch::default();
            for student in 0..16 {
                let Ok(variant) = maker.variant(&student.to_string()) else { continue };
                let one = std::slice::from_ref(&variant);
                let (_, sheet) = sheets.document("s", "Name", one, &mut room).expect("a sheet");
                let solution =
                    solution::document(problem, &variant, 1, &words, &templates).expect("a solution");
                for document in [sheet, solution] {
                    pages += 1;
                    faults.extend(
                        unwanted(&document.markdown).into_iter().map(|f| format!("{}: {f}", problem.id)),
                    );
                }
            }
        }
    }
    assert!(pages > 300, "{pages} pages");
    assert!(faults.is_empty(), "{}", faults.into_iter().collect::<Vec<_>>().join("\n"));
}

/// A letter in the words of a wrong method stands on the sheet of every problem that lists it, or is one that all books share.
#[test]
fn wrong_methods_speak_of_the_letters_on_the_sheet() {
    // Shared by all books; for the falling stone, `h`; of the particles, `A`, `i`, `r`.
    const SHARED: [&str; 19] =
        ["v", "a", "G", "N", "F", "T", "I", "g", "x", "y", "z", "m", "s", "k", "d", "D", "h", "A", "i"];
    let catalogue = strings(&root().join("banks/misconceptions.yaml"));
    let mut faults = Vec::new();
    for bank in support::banks() {
        for problem in &bank.problems {
            let mut known: BTreeSet<String> = SHARED.iter().map(|l| (*l).to_owned()).collect();
            if bank.id == "wheels-on-inclines" && problem.id == "kinetic-energy" {
                known.insert("r".to_owned());
            }
            for datum in &problem.data {
                known.insert(datum.symbol.split('_').next().unwrap_or_default().chars().take(1).collect());
            }
            for mistake in &problem.mistakes {
                let begin = format!(".{}.", mistake.id);
                for (path, text) in catalogue_texts(&catalogue, &begin) {
                    for letter in letters(text) {
                        if !known.contains(&letter) {
                            faults.push(format!("{} {path}: `{letter}` in `{text}`", problem.id));
                        }
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert_eq!(letters(r"moves $(c + p)/c$ times, $\omega R$, a body"), ["c", "p", "c", "R"]);
}

fn catalogue_texts<'c>(all: &'c [(String, String)], begin: &str) -> Vec<(&'c str, &'c str)> {
    all.iter().filter(|(path, _)| path.starts_with(begin)).map(|(p, t)| (p.as_str(), t.as_str())).collect()
}

/// Single letters in the formulas of a text.
fn letters(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for formula in text.split('$').skip(1).step_by(2) {
        let mut rest = formula;
        while let Some(c) = rest.chars().next() {
            if let Some(command) = rest.strip_prefix('\\') {
                rest = command.trim_start_matches(|c: char| c.is_ascii_alphabetic());
                if rest.len() == command.len() {
                    rest = command.get(1..).unwrap_or_default();
                }
            } else {
                let end =
                    rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len()).max(c.len_utf8());
                if end == 1 && c.is_ascii_alphabetic() {
                    found.push(c.to_string());
                }
                rest = &rest[end..];
            }
        }
    }
    found
}

/// The rules find what they are for, and leave good English alone.
#[test]
fn planted_sentences_are_caught() {
    for text in [
        "Letting rolling friction do work over the way of the centre.",
        "Both roads agree.",
        "The speed at that moment.",
        "Consider the moment when it has fallen.",
        "The end of the cord moves $(c + p)/c$ times as far.",
        "On a level it is so.",
        "define it as the difference of two ways",
        "To be rid of the reactions",
        "Divided by each other:",
    ] {
        assert!(!unwanted(text).is_empty(), "{text}");
    }
    for text in [
        "The moment of inertia about the pin, and moments about G.",
        "It is far away, always, on the roadside.",
        "should it point the other way, it comes out negative",
        "thrown along a level lane",
        "Static friction does no work on a rolling wheel.",
        "at that moment of inertia",
    ] {
        let found = unwanted(text);
        let expected = usize::from(text.starts_with("at that moment"));
        assert_eq!(found.len(), expected, "{text}: {found:?}");
    }
}
