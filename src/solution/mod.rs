//! Worked solutions: both methods in symbols and numbers, from the scene's own terms. A third derivation beside the two that
//! make the key: a solution whose numbers are not those of the key is never printed, a short page stands in its place.
//!
//! A derivation works on a [`draft::Draft`]: it writes its sections and says what it has found by which method. The sections, by
//! id, in the order of the text:
//! - `given`: the data in SI, what is asked;
//! - whatever the derivation writes: `forces`, `eom`, `energy`, ...;
//! - `agree`: what both methods found; `regime`: the check of what was assumed;
//! - `answers`: the answers, rounded; `beware`: wrong methods of the problem, with what they would give.
//!
//! What no derivation covers has a short page: `given`, `beyond` with the reason, `answers`.
pub mod beware;
pub mod by_hand;
pub mod draft;
pub mod expr;
pub mod factors;
pub mod lamina;
pub mod linear;
pub mod mass;
pub mod pinned;
pub mod section_writer;
pub mod stop;
pub mod symbols;
pub mod text;
pub mod thrown;
pub mod valued;
pub mod written;

use crate::bank::{Problem, Question};
use crate::figure;
use crate::figure::names;
use crate::finding::Finding;
use crate::num::shown;
use crate::picture::Picture;
use crate::problem::make_key;
use crate::problem::maker::Variant;
use crate::scene::{End, Label, Owner, Scene, Slope, Tie};
use crate::sheet::document::Document;
use crate::solution::draft::{DerivedAnswer, Draft, FoundAnswer};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::tex_digits;
use crate::solution::text::{Block, SolutionSection};
use crate::solve::outcome::Word;
use crate::template;
use crate::template::{Templates, View};
use crate::words::Words;

/// Relative difference from the key that rounding in doubles explains, for a condition number of 1.
const AGREEMENT_REL: f64 = 1e-9;

/// The worked solution of a variant that has this number in its sheet.
///
/// # Errors
/// Faults of the template.
pub fn document(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    words: &Words,
    templates: &Templates,
) -> Result<Document, Finding> {
    worked(problem, variant, number, words, templates).map(|(document, _)| document)
}

/// The same, and what the derivations do not cover, if it is a short page for that reason.
///
/// # Errors
/// Those of [`document`].
pub fn worked(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    words: &Words,
    templates: &Templates,
) -> Result<(Document, Option<Beyond>), Finding> {
    made(problem, variant, number, (words, templates), &|draft| {
        figure::all(draft.problem, draft.variant, draft.words)
    })
}

/// Its text alone, without the pictures, which take longer than all the rest.
///
/// # Errors
/// Those of [`document`].
pub fn text(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    words: &Words,
    templates: &Templates,
) -> Result<String, Finding> {
    made(problem, variant, number, (words, templates), &|_| Vec::new()).map(|(d, _)| d.markdown)
}

/// The pictures that a solution may show, by name.
type Pictures<'p> = &'p dyn Fn(&Draft) -> Vec<(String, Picture)>;

fn made(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    (words, templates): (&Words, &Templates),
    pictures: Pictures,
) -> Result<(Document, Option<Beyond>), Finding> {
    let mut draft = Draft::new(problem, variant, words)?;
    let beyond = match derive(&mut draft).and_then(|()| check(&draft)) {
        Ok(()) => None,
        Err(DerivationStop::Fault(fault)) => return Err(fault),
        Err(DerivationStop::Beyond(what)) => {
            // What was written down up to here leads nowhere.
            draft = Draft::new(problem, variant, words)?;
            Some(what)
        }
    };
    let mut sections = std::mem::take(&mut draft.sections);
    let answers = answers(&draft, number);
    sections.push(given(&draft, number));
    match beyond {
        None => {
            sections.push(agree(&draft, number));
            sections.extend(beware::section(&draft, number));
        }
        Some(what) => {
            let mut section = SolutionSection::new("beyond", words.get("solution.title.beyond"));
            section.say(words.say("solution.short", &[("what", &what.text(words))]));
            sections.push(section);
        }
    }
    let mut last = SolutionSection::new("answers", words.get("solution.title.answers"));
    if beyond.is_none() {
        last.say(words.get("solution.answers"));
    }
    last.blocks.push(Block::List(answers.iter().map(|(id, answer)| format!("`{id}`: {answer}")).collect()));
    sections.push(last);
    sections.sort_by_key(|s| rank(s.id));

    let pictures = if beyond.is_none() { pictures(&draft) } else { Vec::new() };
    for section in &mut sections {
        section.blocks.retain(|b| match b {
            Block::Picture(name) => pictures.iter().any(|(n, _)| n == name),
            _ => true,
        });
    }
    let alt = |name: &str| {
        let shown = pictures.iter().find(|(n, _)| n == name).map(|(_, p)| p.desc.as_str());
        shown.unwrap_or_default().replace(['[', ']', '\n'], " ")
    };
    let mut view = View::new();
    view.text("number", &number.to_string());
    // A title is a text: nothing in it is a tag.
    view.text("title", &problem.title.replace('<', "\\<"));
    view.text("case", &problem.cases[variant.case].name);
    for (symbol, whole) in draft.whole() {
        view.text(symbol, &whole);
    }
    let bodies: Vec<String> = sections.iter().map(|s| s.markdown(&alt)).collect();
    let list = sections.iter().zip(&bodies).map(|(s, body)| {
        template::map([
            ("id", template::finished(s.id)),
            ("title", template::finished(&s.title)),
            ("body", template::finished(body)),
        ])
    });
    view.value("sections", template::list(list.collect()));
    view.value(
        "section",
        template::map(sections.iter().zip(&bodies).map(|(s, body)| (s.id, template::finished(body)))),
    );
    let list = answers.iter().map(|(id, answer)| {
        template::map([("id", template::finished(id)), ("answer", template::finished(answer))])
    });
    view.value("answers", template::list(list.collect()));
    let own = format!("solution/{}.md", problem.id);
    // A text for this problem speaks of sections that a short page does not have.
    let name =
        if beyond.is_none() && templates.has_markdown(&own) { own.as_str() } else { "solution/default.md" };
    let mut out = Vec::new();
    templates.render(name, &view, &mut out)?;
    let mut markdown = String::from_utf8_lossy(&out).trim_end().to_owned();
    markdown.push('\n');
    let used = |name: &str| markdown.contains(&format!("({name}.svg)"));
    let pictures = pictures.into_iter().filter(|(name, _)| used(name)).collect();
    Ok((Document::new(markdown, pictures), beyond))
}

/// The derivation that the scene needs.
fn derive(draft: &mut Draft) -> Result<(), DerivationStop> {
    if draft.scene.formulas.numbers.iter().any(|n| n.any) {
        return Err(Beyond::Any.into());
    }
    if draft.scene.formulas.found.is_some() {
        return Err(Beyond::Found.into());
    }
    if draft.scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        return lamina::work(draft);
    }
    if draft.scene.lead().is_some() {
        return Err(Beyond::JoinedBodies.into());
    }
    if draft.scene.pinned().is_some() {
        return pinned::work(draft);
    }
    if draft.scene.thrown().is_some() && draft.scene.end != End::AtOnce {
        return thrown::work(draft);
    }
    linear::sections(draft)
}

/// Place of a section in the text.
fn rank(id: &str) -> u8 {
    match id {
        "given" => 0,
        "agree" => 2,
        "regime" => 3,
        "answers" => 4,
        "beware" => 5,
        _ => 1,
    }
}

/// Is every question answered, and every number that of the key?
fn check(draft: &Draft) -> Result<(), DerivationStop> {
    for q in &draft.problem.questions {
        if !draft.found.iter().any(|f| f.label == q.label && (f.eom.is_some() || f.energy.is_some())) {
            return Err(Beyond::Quantity(q.label.quantity).into());
        }
    }
    for found in &draft.found {
        for answer in [found.eom, found.energy].into_iter().flatten() {
            match answer {
                DerivedAnswer::Value(symbol) => {
                    let Some(entry) = draft.variant.solved.get(found.label) else { continue };
                    let (here, key) = (draft.symbols.value(symbol), entry.value());
                    // What is the small rest of large terms is judged by their size.
                    let scale = here.abs().max(key.abs()) * entry.cond.max(1.0);
                    let scale = if scale.is_nan() { entry.scale } else { scale.max(entry.scale) };
                    // A formula that yields no number does not cover the case; another number than the key's is wrong.
                    if !here.is_finite() && key.is_finite() {
                        return Err(Beyond::Unfound.into());
                    }
                    if !(here - key).abs().le(&(AGREEMENT_REL * scale)) {
                        return Err(Beyond::Differs(found.label.quantity).into());
                    }
                }
                DerivedAnswer::Word(word) => {
                    if let Some(key) = draft.variant.solved.word(found.label)
                        && key != word
                    {
                        return Err(Beyond::Differs(found.label.quantity).into());
                    }
                }
            }
        }
    }
    Ok(())
}

/// Name of a quantity in words, with the symbol that it was found under: `angular speed $\omega$`.
fn named(draft: &Draft, label: Label) -> String {
    let forward = way(draft.scene, label.of, 1.0).map_or("", |w| draft.words.get(w));
    let name = draft.say(&format!("solution.name.{}", label.quantity.name()), &[("way", forward)]);
    let mut questions = draft.problem.questions.iter();
    let several = questions.any(|q| q.label.quantity == label.quantity && q.label.of != label.of);
    let owner = match label.of {
        Owner::Body(b) => names::body_within(draft.words, draft.scene, b),
        Owner::Tie(t) => match &draft.scene.ties[t] {
            Tie::Cord(cord) => names::cord(draft.words, draft.scene, cord),
            Tie::Roll { .. } | Tie::Slip { .. } | Tie::Slide { .. } => String::new(),
        },
        Owner::Scene | Owner::Joint(_) | Owner::Strut(_) | Owner::Spot(_) | Owner::Asked(_) => String::new(),
    };
    let of = if several && !owner.is_empty() { format!(" ({owner})") } else { String::new() };
    let symbol = draft.found.iter().find(|f| f.label == label).and_then(|f| match f.eom.or(f.energy)? {
        DerivedAnswer::Value(symbol) => Some(draft.symbols.tex(symbol)),
        DerivedAnswer::Word(_) => None,
    });
    match symbol {
        Some(tex) => format!("{name}{of} ${tex}$"),
        None => format!("{name}{of}"),
    }
}

/// `1.omega`
fn id_of(number: usize, q: &Question) -> String {
    format!("{number}.{}", q.id)
}

fn given(draft: &Draft, number: usize) -> SolutionSection {
    let mut section = SolutionSection::new("given", draft.words.get("solution.title.given"));
    let data: Vec<String> = draft.told().iter().map(|d| format!("${d}$")).collect();
    let phrase = if draft.degrees_told() { "solution.given_angles" } else { "solution.given" };
    section.say(draft.say(phrase, &[("data", &data.join(", "))]));
    let asked = draft.problem.questions.iter();
    let asked: Vec<String> =
        asked.map(|q| format!("{} (`{}`)", named(draft, q.label), id_of(number, q))).collect();
    section.say(draft.say("solution.asked", &[("list", &asked.join(", "))]));
    section
}

/// What both methods found, question by question.
fn agree(draft: &Draft, number: usize) -> SolutionSection {
    let w = draft.words;
    let mut section = SolutionSection::new("agree", w.get("solution.title.agree"));
    // What is summed over particles has no motion and no work.
    let methods = match draft.scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        true => ["particles", "decomposed"],
        false => ["eom", "energy"],
    };
    let head = ["question", methods[0], methods[1], "difference"];
    let mut rows = vec![head.map(|h| w.get(&format!("solution.agree.{h}")).to_owned()).to_vec()];
    let mut notes: Vec<String> = Vec::new();
    let shown = |answer: Option<DerivedAnswer>| match answer {
        None => "–".to_owned(),
        Some(DerivedAnswer::Value(symbol)) => format!("${}$", draft.symbols.shown(symbol)),
        Some(DerivedAnswer::Word(word)) => format!("`{}`", said(w, word)),
    };
    for q in &draft.problem.questions {
        let Some(FoundAnswer { eom, energy, note, .. }) = draft.found.iter().find(|f| f.label == q.label)
        else {
            continue;
        };
        let difference = match (eom, energy) {
            (Some(DerivedAnswer::Value(a)), Some(DerivedAnswer::Value(b))) => {
                format!("${}$", draft.symbols.difference(*a, *b))
            }
            (Some(_), Some(_)) => w.get("solution.agree.same").to_owned(),
            _ => "–".to_owned(),
        };
        let cell = format!("`{}`", id_of(number, q));
        rows.push(vec![cell, shown(*eom), shown(*energy), difference]);
        if !note.is_empty() && !notes.contains(note) {
            notes.push(note.clone());
        }
    }
    section.say(w.get("solution.agree.text"));
    section.blocks.push(Block::Table(rows));
    for note in notes {
        section.say(note);
    }
    section
}

/// The answers as they are to be handed in: id and text.
fn answers(draft: &Draft, number: usize) -> Vec<(String, String)> {
    let answer = |q: &Question| {
        let Some(entry) = draft.variant.solved.get(q.label) else {
            let word = draft.variant.solved.word(q.label);
            return word.map_or_else(String::new, |w| format!("`{}`", said(draft.words, w)));
        };
        let found = draft.found.iter().find(|f| f.label == q.label).and_then(|f| f.eom.or(f.energy));
        let symbol = match found {
            Some(DerivedAnswer::Value(symbol)) => format!("${} = ", draft.symbols.tex(symbol)),
            _ => "$".to_owned(),
        };
        told(draft, q, entry.value()).replacen('$', &symbol, 1)
    };
    draft.problem.questions.iter().map(|q| (id_of(number, q), answer(q))).collect()
}

/// A value (SI) as an answer to a question: with its unit and the figures asked, and where it points if words tell its sign.
fn told(draft: &Draft, q: &Question, value: f64) -> String {
    let digits = shown::significant(q.unit.from_si(value), usize::from(q.figures));
    let whole = q.unit.tex_with(&tex_digits(&digits, draft.words));
    let directed = q.label.quantity.is_directed() && make_key::words_sign(draft.scene, q.label);
    let way = if directed { way(draft.scene, q.label.of, value) } else { None };
    format!("${whole}${}", way.map_or_else(String::new, |w| format!(" ({})", draft.words.get(w))))
}

/// A word of an answer as the sheet has it.
fn said(words: &Words, word: Word) -> &str {
    words.get(&format!("sheet.{}", word.text()))
}

/// The phrase for a direction along the line of a body; `None` for 0.
pub fn way(scene: &Scene, owner: Owner, value: f64) -> Option<&'static str> {
    let body = match owner {
        Owner::Body(b) => Some(b),
        _ => scene.bare_body().or(Some(0)),
    };
    let slope = body.and_then(|b| scene.bodies.get(b)).and_then(|b| b.line).map(|l| l.slope);
    let [forward, back] = match slope {
        Some(Slope::Degrees(_)) => ["solution.way.up", "solution.way.down"],
        Some(Slope::Vertical) => ["solution.way.upward", "solution.way.downward"],
        _ => ["solution.way.forward", "solution.way.back"],
    };
    if value > 0.0 {
        Some(forward)
    } else if value < 0.0 {
        Some(back)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Quantity;

    #[test]
    fn every_quantity_has_a_name() {
        let words = Words::english();
        for q in Quantity::ALL {
            assert!(words.has(&format!("solution.name.{}", q.name())), "{}", q.name());
        }
    }
}
