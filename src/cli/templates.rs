//! `slipstick templates`: the built-in templates and word lists as files, to be changed, and what each of them receives.
use crate::cli::args;
use crate::cli::banks;
use crate::cli::files;
use crate::cli::files::Staged;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::template;
use crate::words::Words;
use std::fmt::Write as _;
use std::fs;

/// The file that explains the others; it is no template.
pub const README: &str = "README.md";

/// Pages that only instructors see; their looks are not written out.
const INSTRUCTORS: [&str; 2] = ["accuracy.html", "gallery.html"];

/// Runs it.
pub fn run(args: &args::Templates, io: &mut Io) -> Exit {
    match templates(args, io) {
        Ok(()) => Exit::Fine,
        Err(findings) => io.findings(&findings),
    }
}

fn templates(args: &args::Templates, io: &mut Io) -> Result<(), Findings> {
    banks::words(&args.language)?;
    files::has_a_name(&args.out, "--out my-templates")?;
    files::not_among_students(&args.out)?;
    if args.out.exists() && !(args.out.is_dir() && files::names_in(&args.out).is_empty()) {
        let fault = Finding::new("", "is there already").in_file(args.out.display().to_string());
        return Err(fault.hint("give a new folder: templates that you changed are not replaced").into());
    }
    let texts = texts(&args.language)?;
    let staged = Staged::new(&args.out)?;
    for (name, text) in &texts {
        let fault = |e: &std::io::Error| files::trouble(&args.out.join(name), "cannot be written", e);
        let path = staged.path().join(name);
        if let Some(above) = path.parent() {
            fs::create_dir_all(above).map_err(|e| fault(&e))?;
        }
        fs::write(&path, text).map_err(|e| fault(&e))?;
    }
    staged.finish()?;
    let out = args.out.display();
    io.line(&format!(
        "{}, in {out}; {out}/{README} says what each receives",
        tell::count(texts.len(), "file")
    ));
    io.line(&format!("  use them with: --templates {out}"));
    Ok(())
}

/// All files: name, text.
fn texts(language: &str) -> Result<Vec<(String, String)>, Findings> {
    let mut texts: Vec<(String, String)> = Vec::new();
    for (name, text) in template::built_in(language).filter(|(name, _)| !INSTRUCTORS.contains(name)) {
        texts.push((name.to_owned(), text.to_owned()));
    }
    for (topic, text) in Words::lists(language).unwrap_or_default() {
        texts.push((format!("words/{topic}.yaml"), (*text).to_owned()));
    }
    let translated = banks::TRANSLATED.iter().find(|(code, _)| *code == language);
    for (id, file, text) in banks::BUILT_IN {
        let own = translated.and_then(|(_, list)| list.iter().find(|(i, ..)| i == id));
        let text = match own {
            Some((_, _, text)) => (*text).to_owned(),
            None => banks::overlay_text(&banks::parse(text, file)?),
        };
        texts.push((format!("banks/{id}.yaml"), text));
    }
    texts.push(("print.typ".to_owned(), crate::sheet::typst::PRELUDE.to_owned()));
    texts.push((README.to_owned(), readme(language)));
    texts.sort();
    Ok(texts)
}

/// A piece and what it is.
type Piece = (&'static str, &'static str);

/// What each file receives: name (or its beginning), what it is, pieces.
const PIECES: &[(&str, &str, &[Piece])] = &[
    (
        "statement/",
        "the statement of one problem, named after it (problems that carry their statement in the bank: see banks/)",
        &[
            (
                "m, theta, ...",
                "each datum of the problem under its symbol, and `g`, whole: `$m = 40\\ \\mathrm{kg}$`",
            ),
            ("value.m", "the same without the symbol: `$40\\ \\mathrm{kg}$`"),
            ("tex.m", "the symbol alone, without dollars"),
            ("title, number, case", "title of the problem, its number in the sheet, name of the drawn case"),
            (
                "count, particles, motion",
                "of a body of particles: how many, in words; a list of `name`, `mass`, `x`, `y`; `particle`, `vx`, `vy`, `spin`",
            ),
            (
                "series",
                "of a swing: its series, and how many terms of it suffice for the tolerance of the period",
            ),
        ],
    ),
    (
        "questions.md",
        "the questions of one problem, below its statement and figure",
        &[(
            "questions",
            "a list of `number`, `id`, `ask`, `form` (how to write the answer), `unit`, `figures`, `points` (empty for one), `answer` (room for it on paper)",
        )],
    ),
    (
        "feedback.md",
        "what one student gets back of a grading (`slipstick report`)",
        &[
            ("title", "title of the course or the bank"),
            ("name, student, set", "of the student (the name may be empty) and of the set"),
            ("total, notes", "`14 of 20 points`; a list of remarks, such as a problem that does not count"),
            (
                "problems",
                "a list of `number`, `title`, `points`, `parts`: a list of `sign`, `name`, `verdict`, `points`, `answer`, `reason`, `credit` (a list of lines), `hints` (a list of lines)",
            ),
        ],
    ),
    (
        "report.html",
        "the class report, for the instructor (`slipstick report`); its phrases are in words/report.yaml",
        &[
            ("language, title, set", "of the report; title of the course or the bank"),
            (
                "words",
                "the phrases of words/report.yaml, nested as there; `{{ words.of | fill(n=3, of=4) }}` fills the places of one",
            ),
            ("graded", "lists of name and value: how it was graded, and what"),
            (
                "students, took_part, absent, rows",
                "how many students there are, handed in, did not; how many answers there are",
            ),
            (
                "totals, right, alpha",
                "median of the totals, share of right answers, Cronbach's alpha; empty where there is none",
            ),
            (
                "favourites",
                "the favourite mistakes: a list of `students`, `share`, `parts`, `ids`, `they`, `advice`, `also`",
            ),
            ("charts", "plots in SVG: `totals`, `parts`, `items`, `mistakes`, `fairness` (a list)"),
            ("tables", "by name, as in the folder tables/; each is given to report-table.html as `t`"),
        ],
    ),
    (
        "report-table.html",
        "a table of the class report, included by the above",
        &[(
            "t",
            "`name`, `caption`, `head`, `texts` (so many columns from the left are no numbers), `rows` (of cells with `shown` and `rich`), `shown` and `all` (rows here and in the file)",
        )],
    ),
    (
        "sheet.md",
        "the sheet of one student",
        &[
            ("title", "title of the bank"),
            (
                "name, student, set, code",
                "of the student (the name may be empty) and of the set; the code stands for what was drawn",
            ),
            ("problems", "a list of `number`, `title`, `body` (statement, figure, questions)"),
            ("example, example_unit", "name and unit of a question, for the hint how to answer"),
            ("units", "`required` or `optional`"),
            ("figures, tolerance", "significant figures asked for; the sentence about the tolerance"),
            ("direction", "a word for a negative direction, or empty where no answer has one"),
            ("self_check", "`yes`, or empty where the bank does not allow it"),
        ],
    ),
    (
        "solution/default.md",
        "the worked solution of one problem; a file solution/PROBLEM-ID.md goes before it",
        &[
            ("number, title, case", "as in statements; each datum under its symbol as well"),
            ("sections", "a list of `id`, `title`, `body`, in order"),
            ("section.ID", "the body of one of them"),
            ("answers", "a list of `id`, `answer`"),
        ],
    ),
    (
        "key-table.md",
        "the key for the instructor",
        &[
            ("title, set", "of the bank and of the set"),
            (
                "problems",
                "a list of `number`, `title`, `cases` and `moves` (empty where there is nothing to tell), `parts` (a list of `name`), `students` (a list of `student`, `name`, `code`, `case`, `regime`, `answers`)",
            ),
        ],
    ),
    (
        "sheet.html",
        "the page around one document: sheet, solution, key",
        &[
            ("language, title, student, name, set, code", "of the document"),
            ("kind", "`sheet`, `solution` or `key`, the class of the page"),
            ("body", "the document itself, in HTML"),
            ("running", "the head of printed pages, as a string of CSS"),
        ],
    ),
    (
        "booklet.html",
        "the page with all documents of a set",
        &[
            ("language, title, skip, contents", "of the booklet; words for the link and the list at its top"),
            ("sheets", "a list of `id`, `who`, `running`, `body`"),
        ],
    ),
    ("style.html", "looks of all pages, included by the two above", &[]),
    (
        "sheet.tex",
        "LaTeX around one document",
        &[(
            "title, running, babel, language, body",
            "as in sheet.html; `babel` is the language's name for the package babel",
        )],
    ),
    (
        "booklet.tex",
        "LaTeX around all documents of a set",
        &[("title, babel, language, sheets", "a list of `running`, `body`")],
    ),
    ("style.tex", "preamble of all LaTeX files, included by the two above", &[("babel", "see sheet.tex")]),
    ("print.typ", "looks of the PDFs, in Typst; it explains itself", &[]),
    ("words/", "phrases by name; `{place}` is filled in, and may be moved or left out", &[]),
    (
        "banks/",
        "texts of a bank: its title, titles of problems, names of data, questions (`ask`), and statements that stand in the bank; a file of this kind named after your own bank translates it",
        &[],
    ),
];

fn readme(language: &str) -> String {
    let mut out = String::from(
        "# Templates\n\nThese are the built-in templates and word lists of slipstick. Change what you like and delete what you leave as it is: the rest stays built in. Give the folder with `--templates`. A file that is broken is told with its line and what is wrong; `slipstick lint BANK --templates FOLDER` tries all of them.\n\nTemplates are written in [Tera](https://keats.github.io/tera/): `{{ piece }}`, `{% if piece %}...{% endif %}`, `{% for q in questions %}...{% endfor %}`. Pieces are finished texts: there is nothing to compute and nothing to format. One folder may serve several languages: put the files of each into a folder of its code, such as `de/`.\n",
    );
    for (name, what, pieces) in PIECES {
        let shown = if name.ends_with('/') { format!("{name}*") } else { (*name).to_owned() };
        let _ = write!(out, "\n## {shown}\n\n{}{}.\n", what[..1].to_uppercase(), &what[1..]);
        if !pieces.is_empty() {
            out.push_str("\n| piece | what it is |\n|---|---|\n");
        }
        for (piece, is) in *pieces {
            let names: Vec<String> =
                piece.split(", ").map(|p| format!("`{p}`").replace("`...`", "...")).collect();
            let _ = writeln!(out, "| {} | {is} |", names.join(", "));
        }
    }
    let _ = write!(out, "\nThe texts in this folder are those of the language `{language}`.\n");
    out
}
