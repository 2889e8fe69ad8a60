//! The doors of the house: which room may use which, and who keeps which crate. Read from the source, comments left out.
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Room (or one file of it) and the rooms that it may use besides itself. The most specific name wins.
const DOORS: &[(&str, &[&str])] = &[
    ("finding", &[]),
    ("worded", &[]),
    ("csv_field", &[]),
    ("num", &[]),
    ("units", &["num"]),
    ("scene", &["num"]),
    ("solve", &[]),
    ("solve::method", &["num"]),
    ("solve::outcome", &["solve::method", "scene", "num"]),
    ("solve::found", &["solve::outcome", "scene", "num"]),
    ("solve::eom", &["solve::found", "solve::outcome", "solve::method", "scene", "num"]),
    ("solve::energy", &["solve::found", "solve::outcome", "solve::method", "scene", "num"]),
    ("solve::physical", &["solve::outcome", "scene", "num"]),
    ("solve::condition", &["solve::eom", "solve::outcome", "scene", "num"]),
    (
        "solve::agree",
        &[
            "solve::condition",
            "solve::eom",
            "solve::energy",
            "solve::physical",
            "solve::outcome",
            "scene",
            "num",
        ],
    ),
    (
        "solve::ladder",
        &["solve::agree", "solve::eom", "solve::energy", "solve::outcome", "solve::method", "scene", "num"],
    ),
    ("policy", &[]),
    ("bank", &["scene", "solve::outcome", "units", "finding", "num", "policy"]),
    ("draw", &["bank", "scene", "units", "num"]),
    ("key", &["units", "num"]),
    (
        "problem",
        &[
            "bank",
            "draw",
            "misconception",
            "scene",
            "solve::agree",
            "solve::outcome",
            "key",
            "units",
            "finding",
            "num",
        ],
    ),
    (
        "page",
        &[
            "problem",
            "bank",
            "misconception",
            "answer",
            "grade",
            "policy",
            "tutor",
            "scene",
            "solve::outcome",
            "key",
            "units",
            "num",
            "words",
            "finding",
        ],
    ),
    ("misconception::catalogue", &["misconception", "bank", "finding"]),
    ("misconception", &["bank", "scene", "solve::agree", "solve::outcome", "finding", "num"]),
    ("template", &["finding"]),
    ("picture", &["num"]),
    (
        "figure",
        &["problem", "bank", "scene", "solve::outcome", "key", "units", "num", "picture", "plot", "words"],
    ),
    (
        "solution",
        &[
            "problem",
            "misconception::catalogue",
            "bank",
            "scene",
            "solve::energy",
            "solve::outcome",
            "key",
            "units",
            "num",
            "figure",
            "picture",
            "sheet::document",
            "words",
            "template",
            "finding",
        ],
    ),
    ("words", &["bank", "units", "finding"]),
    (
        "sheet",
        &[
            "page",
            "problem",
            "misconception::catalogue",
            "policy",
            "bank",
            "scene",
            "solve::outcome",
            "key",
            "units",
            "num",
            "sheet::document",
            "figure",
            "picture",
            "words",
            "template",
            "finding",
        ],
    ),
    (
        "set",
        &[
            "csv_field",
            "problem",
            "bank",
            "draw",
            "sheet",
            "scene",
            "solve::outcome",
            "key",
            "units",
            "num",
            "template",
            "finding",
        ],
    ),
    ("answer", &["csv_field", "units", "num", "finding"]),
    ("grade", &["csv_field", "key", "answer", "units", "num", "words", "policy", "finding"]),
    (
        "tutor",
        &[
            "problem",
            "bank",
            "misconception",
            "scene",
            "solve::agree",
            "solve::outcome",
            "key",
            "answer",
            "grade",
            "policy",
            "num",
            "words",
        ],
    ),
    (
        "report",
        &[
            "csv_field",
            "grade",
            "matches",
            "policy",
            "key",
            "units",
            "num",
            "picture",
            "plot",
            "misconception::catalogue",
            "problem",
            "regrade",
            "set",
            "sheet::document",
            "sheet::terminal",
            "words",
            "template",
            "finding",
        ],
    ),
    (
        "report::explain",
        &[
            "answer",
            "grade",
            "regrade",
            "set",
            "problem",
            "bank",
            "policy",
            "key",
            "num",
            "misconception::catalogue",
            "sheet::terminal",
            "words",
            "template",
            "finding",
        ],
    ),
    (
        "inspect",
        &[
            "csv_field",
            "problem",
            "bank",
            "draw",
            "scene",
            "solve::agree",
            "solve::ladder",
            "solve::method",
            "solve::outcome",
            "sheet",
            "sheet::terminal",
            "picture",
            "plot",
            "key",
            "units",
            "num",
            "words",
            "template",
            "finding",
        ],
    ),
    (
        "review",
        &[
            "problem",
            "bank",
            "inspect",
            "figure",
            "picture",
            "solution",
            "solve::outcome",
            "sheet",
            "sheet::document",
            "sheet::terminal",
            "key",
            "num",
            "words",
            "template",
            "finding",
        ],
    ),
    (
        "export",
        &[
            "answer",
            "num",
            "bank",
            "problem",
            "solution",
            "key",
            "units",
            "picture",
            "sheet",
            "sheet::document",
            "set",
            "words",
            "template",
            "finding",
        ],
    ),
    (
        "folder",
        &[
            "page",
            "export",
            "csv_field",
            "problem",
            "bank",
            "draw",
            "inspect",
            "review",
            "simulate",
            "sheet",
            "sheet::document",
            "sheet::terminal",
            "solution",
            "key",
            "units",
            "words",
            "template",
            "set",
            "answer",
            "grade",
            "policy",
            "matches",
            "regrade",
            "report",
            "report::explain",
            "misconception::catalogue",
            "finding",
        ],
    ),
    (
        "simulate",
        &[
            "csv_field",
            "problem",
            "policy",
            "bank",
            "scene",
            "sheet",
            "solution",
            "solve::agree",
            "solve::outcome",
            "key",
            "units",
            "words",
            "num",
            "finding",
        ],
    ),
    ("manual", &["sheet", "sheet::document", "words", "template", "finding"]),
    ("sheet::document", &["picture"]),
    ("sheet::terminal", &["num"]),
    ("plot", &["picture", "num"]),
    ("matches", &["num"]),
    ("regrade", &["csv_field", "grade", "answer", "key", "policy", "finding"]),
    ("cli", &["*"]),
    ("main", &["cli"]),
    ("mechanics", &[]),
    ("lib", &[]),
];

/// Crate and the only places that may name it.
const KEEPERS: &[(&str, &[&str])] = &[
    ("clap", &["cli"]),
    ("serde_yaml", &["bank::yaml"]),
    ("tera", &["template"]),
    ("rand", &["simulate"]),
    ("rand_chacha", &["draw", "simulate"]),
    ("libm", &["num::trig"]),
    ("nalgebra", &["picture"]),
    ("csv", &["answer", "folder", "grade", "set", "report", "regrade", "simulate"]),
    ("encoding_rs", &["answer"]),
    ("indicatif", &["cli"]),
    ("rayon", &["folder", "review", "set", "sheet::pdf"]),
    ("pulldown_cmark", &["sheet", "export"]),
    ("pulldown_latex", &["sheet"]),
    ("tempfile", &["folder"]),
    ("zip", &["folder", "export"]),
    ("base64", &["sheet", "export", "page"]),
    ("postcard", &["page"]),
    ("typst", &["sheet::pdf"]),
    ("typst_assets", &["sheet::pdf"]),
    ("typst_layout", &["sheet::pdf"]),
    ("typst_pdf", &["sheet::pdf"]),
    ("hmac", &["draw"]),
    ("jiff", &["policy"]),
    ("strsim", &["units"]),
    ("unicode_normalization", &["answer"]),
];

/// Module path of each source file and its text without comments and test modules.
fn sources() -> Vec<(String, String)> {
    fn walk(folder: &Path, out: &mut Vec<(String, String)>, root: &Path) {
        let mut entries: Vec<_> =
            std::fs::read_dir(folder).expect("src").map(|e| e.expect("entry").path()).collect();
        entries.sort();
        for path in entries {
            if path.is_dir() {
                walk(&path, out, root);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let relative = path.strip_prefix(root).expect("below src").with_extension("");
                let mut parts: Vec<_> =
                    relative.components().map(|c| c.as_os_str().to_string_lossy().into_owned()).collect();
                if parts.len() > 1 && parts.last().is_some_and(|l| l == "mod") {
                    parts.pop();
                }
                let text = std::fs::read_to_string(&path).expect("text");
                let text = text.split("\nmod tests {").next().unwrap_or("").to_owned();
                let code: Vec<&str> = text.lines().filter(|l| !l.trim_start().starts_with("//")).collect();
                out.push((parts.join("::"), code.join("\n")));
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut out = Vec::new();
    walk(&root, &mut out, &root);
    out
}

/// The most specific entry of a table for a module path.
fn entry<'t, T>(table: &'t [(&str, T)], module: &str) -> Option<&'t (&'t str, T)> {
    let inside =
        |name: &str| module == name || module.strip_prefix(name).is_some_and(|rest| rest.starts_with("::"));
    table.iter().filter(|(name, _)| inside(name)).max_by_key(|(name, _)| name.len())
}

/// Paths after `crate::` in a source text, groups `{a, b}` spread out.
fn crate_paths(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (i, _) in text.match_indices("crate::") {
        let before = text[..i].chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_') {
            continue;
        }
        let rest = &text[i + 7..];
        let path: String =
            rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_' || *c == ':').collect();
        let path = path.trim_end_matches(':').to_owned();
        let after = &rest[path.len().min(rest.len())..];
        match after.strip_prefix("::{").and_then(|g| g.split('}').next()) {
            Some(group) => found.extend(group.split(',').map(|p| format!("{path}::{}", p.trim()))),
            None => found.push(path),
        }
    }
    found
}

fn faults(sources: &[(String, String)]) -> BTreeSet<String> {
    let mut faults = BTreeSet::new();
    for (module, text) in sources {
        let Some((room, doors)) = entry(DOORS, module) else {
            faults.insert(format!("{module}: no room of this name in the table of doors"));
            continue;
        };
        for path in crate_paths(text) {
            let Some((target, _)) = entry(DOORS, &path) else {
                let top = path.split("::").next().unwrap_or("");
                // A whole room named from within (`solve` from `solve::agree`), or a macro at the top.
                if DOORS.iter().any(|(n, _)| n.starts_with(top)) && doors.contains(&"*") {
                    continue;
                }
                faults.insert(format!("{module} uses {path}, which is no room"));
                continue;
            };
            let allowed = target == room || doors.contains(target) || doors.contains(&"*");
            if !allowed {
                faults.insert(format!("{module} uses {target} ({path}): no door"));
            }
        }
        if text.contains("super::") {
            faults.insert(format!("{module}: write crate:: paths, not super::"));
        }
        for (name, keepers) in KEEPERS {
            let named = text.match_indices(&format!("{name}::")).any(|(i, _)| {
                !text[..i].chars().next_back().is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':')
            });
            let kept = keepers.iter().any(|k| module == k || module.starts_with(&format!("{k}::")));
            if named && !kept {
                faults.insert(format!("{module} names the crate {name}, kept by {}", keepers.join(", ")));
            }
        }
    }
    faults
}

#[test]
fn every_import_goes_through_a_door() {
    let faults = faults(&sources());
    assert!(faults.is_empty(), "{}", faults.into_iter().collect::<Vec<_>>().join("\n"));
}

#[test]
fn planted_imports_are_caught() {
    for (module, line) in [
        ("solve::eom::travel", "use crate::solve::energy::speeds::Mode;"),
        ("solve::energy", "use crate::solve::eom::equations;"),
        ("solve::energy::balance", "use crate::solve::{agree, outcome};"),
        ("scene::body", "use crate::solve::outcome::Solved;"),
        ("grade::compare", "use crate::scene::Scene;"),
        ("grade::compare", "let x = crate::solve::agree::solve(s, d);"),
        ("num::dd", "use crate::scene::Num;"),
        ("scene::mod", "use libm::sin;"),
        ("sheet::sheets", "let r = rand::rng();"),
        ("solve::eom", "use super::energy;"),
        ("folder::set", "use crate::cli::tell::Io;"),
        ("folder::grading", "use clap::Parser;"),
    ] {
        let found = faults(&[(module.to_owned(), line.to_owned())]);
        assert_eq!(found.len(), 1, "{module}: {line}: {found:?}");
    }
}

/// Uses of a verb by another file of the command line: a verb stands on what typed and told have in common and on the rooms below.
fn uses_of_verbs(sources: &[(String, String)]) -> Vec<String> {
    const COMMON: [&str; 2] = ["args", "tell"];
    let mut found = Vec::new();
    for (module, text) in sources.iter().filter(|(module, _)| module.starts_with("cli::")) {
        for path in crate_paths(text) {
            let file = path.strip_prefix("cli::").map(|rest| rest.split("::").next().unwrap_or(rest));
            if let Some(file) =
                file.filter(|file| !COMMON.contains(file) && module != &format!("cli::{file}"))
            {
                found.push(format!("{module} uses the verb {file} ({path})"));
            }
        }
    }
    found
}

#[test]
fn no_verb_knows_another() {
    let planted =
        [("cli::regrade".to_owned(), "use crate::cli::grade::Job;\nuse crate::cli::args;".to_owned())];
    assert_eq!(uses_of_verbs(&planted).len(), 1);
    let sources = sources();
    let found = uses_of_verbs(&sources);
    assert!(found.is_empty(), "{}", found.join("\n"));
    let lines: usize =
        sources.iter().filter(|(m, _)| m.starts_with("cli")).map(|(_, t)| t.lines().count()).sum();
    assert!(lines <= 4_500, "cli has {lines} lines: what lies on disk belongs to folder, words to report");
}

#[test]
fn rooms_have_no_circle() {
    let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (module, text) in sources() {
        let Some((room, _)) = entry(DOORS, &module) else { continue };
        for path in crate_paths(&text) {
            if let Some((target, _)) = entry(DOORS, &path)
                && target != room
            {
                uses.entry((*room).to_owned()).or_default().insert((*target).to_owned());
            }
        }
    }
    // Take away rooms that use nothing that is left; what remains is a circle.
    while let Some(done) =
        uses.iter().find(|(_, u)| u.iter().all(|t| !uses.contains_key(t))).map(|(r, _)| r.clone())
    {
        uses.remove(&done);
    }
    assert!(uses.is_empty(), "a circle among {uses:?}");
}

#[test]
fn each_file_says_what_is_in_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut stack = vec![root];
    while let Some(folder) = stack.pop() {
        for e in std::fs::read_dir(folder).expect("src") {
            let path = e.expect("entry").path();
            if path.is_dir() {
                stack.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = std::fs::read_to_string(&path).expect("text");
                assert!(text.starts_with("//! "), "{}: begins without a sentence", path.display());
                for word in ["TODO", "FIXME", "todo!(", "unimplemented!("] {
                    assert!(!text.contains(word), "{}: {word}", path.display());
                }
            }
        }
    }
}

// A number that is printed for people is rounded by `num::shown`: a precision in a format string rounds the binary number, so that of two
// printed halves one goes up and the other down. No test saw that, since each looked at numbers that are no halves.
#[test]
fn nobody_else_rounds_decimals_for_people() {
    // Places in a drawing are nobody's answer, and a Typst length is for a machine.
    const DRAWN: [&str; 3] = ["picture::svg", "picture::tikz", "sheet::typst"];
    let precise = |text: &str| {
        let mut found = Vec::new();
        for (i, _) in text.match_indices('{') {
            let Some((place, _)) = text[i + 1..].split_once('}') else { continue };
            let Some((name, spec)) = place.split_once(':') else { continue };
            let plain = name.chars().all(|c| c.is_alphanumeric() || c == '_');
            // The size of an error, `1e-9`, is no value but its power of ten.
            let places = spec.strip_prefix('.').unwrap_or("");
            let digits = places.strip_suffix('$').unwrap_or(places);
            let decimal =
                !digits.is_empty() && digits.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '*');
            if plain
                && decimal
                && !(digits.ends_with('e') && digits.starts_with(|c: char| c.is_ascii_digit()))
            {
                found.push(format!("{{{place}}}"));
            }
        }
        found
    };
    assert_eq!(precise(r#"format!("{x:.2} {:.0} {value:.decimals$} {value:.*}")"#).len(), 4);
    assert!(precise(r#"format!("{x:>7} {:.1e} {{a: .5}}")"#).is_empty());
    let faults: Vec<String> = sources()
        .into_iter()
        .filter(|(module, _)| module != "num::shown" && !DRAWN.contains(&module.as_str()))
        .flat_map(|(module, text)| precise(&text).into_iter().map(move |p| format!("{module}: {p}")))
        .collect();
    assert!(faults.is_empty(), "round with num::shown:\n{}", faults.join("\n"));
}
