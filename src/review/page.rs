//! Many variants of a bank's problems side by side on one page.
use crate::bank::{Bank, Problem};
use crate::figure::scene;
use crate::finding::Findings;
use crate::inspect::sentences;
use crate::inspect::table::unsatisfiable;
use crate::num::shown;
use crate::picture::svg::{self, escaped};
use crate::problem::make_key;
use crate::problem::maker::{Maker, Variant};
use crate::problem::sweep::Sweep;
use crate::review::{self, SweepTables};
use crate::sheet::document::Document;
use crate::sheet::html::{Converter, PlaceInPage};
use crate::sheet::key_table;
use crate::sheet::sheets::{SheetScratch, Sheets};
use crate::sheet::texts::Texts;
use crate::solve::outcome::Motion;
use crate::template::{self, Value, View};
use std::fmt::Write as _;

/// Draws among which refused ones are looked for, and how many are shown at most.
const TRIES: u32 = 60;
const REFUSED: usize = 4;

/// The page, and the problems of which not all variants could be drawn.
pub struct Gallery {
    pub page: String,
    /// Why variants are missing on it.
    pub missing: Findings,
}

/// The page with so many variants of these problems, draws that their rules refuse, and the tables of their sweeps over so many
/// seeds. Errors: a template is faulty.
pub fn page(
    (bank, file): (&Bank, &str),
    chosen: &[usize],
    texts: &Texts,
    (count, seeds): (u32, u64),
    sweeps: &[Sweep],
) -> Result<Gallery, Findings> {
    let problems: Vec<&Problem> = chosen.iter().filter_map(|i| bank.problems.get(*i)).collect();
    let mut missing = Findings::default();
    let sheets = Sheets::new(&texts.templates, &texts.words, bank, &bank.id, chosen)?;
    let mut converter = Converter::new(&texts.words);
    let mut scratch = SheetScratch::default();
    let mut shown = Vec::with_capacity(problems.len());
    for (i, (problem, sweep)) in problems.iter().zip(sweeps).enumerate() {
        let maker = Maker::new(problem, 1, &bank.id);
        let mut variants = Vec::new();
        for n in 1..=count {
            match maker.variant(&n.to_string()) {
                Ok(variant) => variants.push(variant),
                Err(none) => {
                    let fault = unsatisfiable(bank, &none).in_file(file);
                    missing.push(fault.hint("the page shows refused draws; `slipstick lint` says more"));
                    break;
                }
            }
        }
        let mut statement = Vec::new();
        if let Some(first) = variants.first() {
            sheets.problem(i, first, &mut scratch, &mut statement)?;
        }
        let markdown = String::from_utf8_lossy(&statement).into_owned();
        let place = PlaceInPage { lower: 1, prefix: &problem.id, boxes: &[] };
        let statement = converter.body(&Document::new(markdown, Vec::new()), &[], place);
        let cards =
            variants.iter().enumerate().map(|(n, v)| card(problem, v, (n + 1, None), texts, &mut converter));
        let cards = template::list(cards);
        let refused = maker.refused(TRIES);
        let refused = refused.iter().take(REFUSED).enumerate().map(|(n, draw)| {
            card(problem, &draw.variant, (n + 1, Some(draw.why.as_str())), texts, &mut converter)
        });
        let refused = template::list(refused);
        let found = review::tables(problem, sweep);
        let never = review::never_near(&found).map_or_else(String::new, |text| escaped(&text));
        let notes = notes(problem, sweep, &found.notes);
        let title = escaped(&problem.title);
        let lists = [
            ("tables", template::list(tables(found, texts))),
            ("notes", template::list(notes)),
            ("variants", cards),
            ("refused", refused),
        ];
        let of_problem =
            [("id", &*problem.id), ("title", &title), ("statement", statement.trim_end()), ("never", &never)];
        shown.push(template::with(of_problem, lists));
    }
    let mut view = View::new();
    view.text("language", texts.words.language());
    view.foreign("title", &bank.title);
    let (count, seeds) = (count.to_string(), seeds.max(1).to_string());
    let about = texts.words.say("gallery.about", &[("variants", &count), ("seeds", &seeds)]);
    view.text("about", &in_code(&about));
    view.text("several", if problems.len() > 1 { "yes" } else { "" });
    let names = ["gallery", "problems", "statement", "question", "answer", "refused", "none"];
    let phrase =
        |name: &&'static str| (*name, template::finished(texts.words.get(&format!("gallery.{name}"))));
    view.value("words", template::map(names.iter().map(phrase)));
    view.value("problems", template::list(shown));
    view.foreign("chance", review::chance(sweeps).first().map_or("", String::as_str));
    let page = texts.templates.made("gallery.html", &view)?;
    Ok(Gallery { page: String::from_utf8_lossy(&page).into_owned(), missing })
}

/// One variant: figure, data, what happens, answers; or a draw with the reason why it is refused.
fn card(
    problem: &Problem,
    variant: &Variant,
    (n, why): (usize, Option<&str>),
    texts: &Texts,
    converter: &mut Converter,
) -> Value {
    let phrases = &texts.words;
    let picture = scene::picture(problem, variant, phrases, problem.figure);
    let id = format!("{}-{}{n}", problem.id, if why.is_some() { "refused-" } else { "" });
    let figure = format!("<figure>{}</figure>\n", svg::Screen::new(&picture).inline(&id).trim_end());
    let formulas: Vec<String> = problem
        .data
        .iter()
        .zip(&variant.values)
        .filter_map(|(datum, drawn)| {
            let digits = phrases.tex_number(&(*drawn)?.text());
            Some(format!("{} = {}", datum.tex, datum.unit.tex_with(&digits)))
        })
        .collect();
    // A comma within its formula does not begin a line.
    let data = if formulas.is_empty() { String::new() } else { format!("${}$", formulas.join(",$ $")) };
    let place = PlaceInPage { lower: 0, prefix: &id, boxes: &[] };
    let data = converter.body(&Document::new(data, Vec::new()), &[], place);
    let mut what = Vec::new();
    if let Some(case) = problem.cases.get(variant.case).filter(|c| !c.name.is_empty()) {
        what.push(case.name.clone());
    }
    if variant.solved.regime.motion != Motion::Instant {
        what.push(sentences::regime(phrases, variant.solved.regime));
    }
    let parts = if why.is_some() { Vec::new() } else { make_key::key(problem, variant).parts };
    let answers = parts.iter().map(|entry| {
        let mut answer = key_table::shown(phrases, problem, entry);
        if !entry.unit.is_number() {
            let _ = write!(answer, " {}", entry.unit.ascii().replace("^2", "²").replace("^3", "³"));
        }
        let cond = entry.cond.map_or_else(String::new, |c| phrases.number(&shown::significant(c, 3)));
        template::texts([("id", &entry.part), ("answer", &escaped(&answer)), ("cond", &cond)])
    });
    let of_card = [
        ("name", &*phrases.say("gallery.variant", &[("n", &n.to_string())])),
        ("why", &escaped(why.unwrap_or_default())),
        ("what", &escaped(&what.join(", "))),
        ("figure", &figure),
        ("data", data.trim_end()),
    ];
    template::with(of_card, [("answers", template::list(answers))])
}

/// The tables of `lint`, with the same numbers.
fn tables(found: SweepTables, texts: &Texts) -> Vec<Value> {
    let refusals: Vec<Vec<String>> =
        found.refusals.into_iter().map(|(count, rule)| vec![rule, count.to_string()]).collect();
    let name = |name: &str| texts.words.get(&format!("gallery.{name}")).to_owned();
    let headed = |title: &str, mut rows: Vec<Vec<String>>| {
        let width = rows.first().map_or(0, Vec::len);
        let head = std::iter::once(name(title)).chain(std::iter::repeat_n(String::new(), width));
        rows.insert(0, head.take(width).collect());
        rows
    };
    let last = found.mistakes.first().map_or(0, |head| head.len() - 1);
    let all = [
        (name("cases"), found.cases, &review::LEFT_CASES[..]),
        (name("refusals"), headed("refusals", refusals), &[0][..]),
        (name("numbers"), found.numbers, &review::LEFT_NUMBERS[..]),
        (name("words"), headed("words", found.words), &review::LEFT_WORDS[..]),
        (name("mistakes"), found.mistakes, &[0, last][..]),
    ];
    let cells = |row: &[String], left: &[usize]| {
        let cell = |(i, text): (usize, &String)| {
            template::texts([("text", &escaped(text)), ("right", if left.contains(&i) { "" } else { "yes" })])
        };
        template::list(row.iter().enumerate().map(cell))
    };
    all.iter()
        .filter(|(_, rows, _)| rows.len() > 1)
        .map(|(name, rows, left)| {
            let below = template::list(rows[1..].iter().map(|row| cells(row, left)));
            template::with([("name", &escaped(name))], [("head", cells(&rows[0], left)), ("rows", below)])
        })
        .collect()
}

/// What a person should look at.
fn notes(problem: &Problem, sweep: &Sweep, fit: &[String]) -> Vec<Value> {
    let mut notes = Vec::new();
    if let Some((seed, none)) = &sweep.unsatisfiable {
        notes.push(format!("seed {seed}: {none}"));
    }
    if let Some(refusal) = &sweep.unsolved {
        for text in sentences::refusal(problem, &problem.cases[0].scene, refusal) {
            notes.push(format!("a draw cannot be solved: {text}"));
        }
    }
    notes.extend_from_slice(fit);
    notes.iter().map(|note| template::finished(&in_code(note))).collect()
}

/// What stands between backticks, as code.
fn in_code(text: &str) -> String {
    let pieces = text.split('`').enumerate();
    let piece = |(i, piece): (usize, &str)| match i % 2 {
        0 => escaped(piece),
        _ => format!("<code>{}</code>", escaped(piece)),
    };
    pieces.map(piece).collect()
}
