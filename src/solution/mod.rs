//! Worked solutions: two pages that go the short way, show the long one, and say why the first is shorter. A solution whose numbers
//! are not those of the key is never printed, a short page stands in its place.
//!
//! The terms of a scene of lines and axles (each action with its point, velocity ratios, inertias) are read in [`terms`], and
//! [`account`] derives each quantity from them; [`plane`] does both for bodies in the plane, of which one on a pin is one. The
//! order in which they are worded is one for all, in [`narrate`]; what a question asks by a formula is answered from these in
//! [`asked`]. The sections, by id, in the order of the text ([`ORDER`]), each where there is something to say:
//! - `answers` in a box, `given`: the data; `unknown`, `any`: what no sheet gives; `asked_first`: formulas of data alone;
//! - `idea`, `sketch`; `blow`: what a blow or an impact does ([`blow`]); `rolled`: could it roll? `short`, `long`, `why`: both ways, and why the first is shorter;
//! - `forces`, `swings`, `rest`: what energy is silent about, and what else is asked; `backward`: from what was measured; `as_if`, `asked`:
//!   by formulas;
//! - `holds`: is what was assumed so? `limits`; `next`: the motion that follows, `asked_next`; `beware`: wrong methods with what they
//!   would give; `onward`: a question.
//!
//! A fault has a short page: `answers`, `given`, `beyond` with the reason.
/// All that one thing can which another holds, that can too.
macro_rules! stands_on {
    ($who:ident.$field:ident: $what:ty) => {
        impl<'d, 'a> std::ops::Deref for $who<'d, 'a> {
            type Target = $what;
            fn deref(&self) -> &Self::Target {
                &self.$field
            }
        }
        impl<'d, 'a> std::ops::DerefMut for $who<'d, 'a> {
            fn deref_mut(&mut self) -> &mut Self::Target {
                &mut self.$field
            }
        }
    };
}

mod account;
mod asked;
mod beware;
mod blow;
pub mod by_hand;
pub mod draft;
mod expr;
mod factors;
mod joined;
mod narrate;
mod order;
mod page;
mod plane;
pub mod stop;
mod symbols;
mod terms;
mod text;
mod valued;
pub mod written;

use crate::bank::{Problem, Question};
use crate::figure;
use crate::finding::Finding;
use crate::num::shown;
use crate::picture::Picture;
use crate::problem::make_key;
use crate::problem::maker::Variant;
use crate::scene::{Owner, Scene, Slope};
use crate::sheet::document::Document;
use crate::solution::draft::{DerivedAnswer, Detail, Draft, scene_of};
use crate::solution::expr::SymbolId;
use crate::solution::page::Page;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{Symbols, tex_digits};
use crate::solution::text::{Block, SolutionSection};
use crate::solve::outcome::Word;
use crate::template::{self, Templates, View};
use crate::words::Words;

/// The ids of the sections in the order of the text.
#[rustfmt::skip] // a table
const ORDER: [&str; 25] = [
    "answers", "given", "unknown", "any", "asked_first",
    "idea", "sketch", "blow", "rolled", "short", "long", "why",
    "forces", "swings", "rest", "backward", "as_if", "asked",
    "holds", "limits", "next", "asked_next", "beware", "beyond", "onward",
];

/// Relative difference from the key that rounding in doubles explains, for a condition number of 1.
const AGREEMENT_REL: f64 = 1e-9;

/// The worked solution of a variant that has this number in its sheet. Errors: faults of the template.
pub fn document(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    words: &Words,
    templates: &Templates,
) -> Result<Document, Finding> {
    worked(problem, variant, number, Detail::Short, (words, templates)).map(|(document, _)| document)
}

/// The same, and what the derivations do not cover, if it is a short page for that reason. Errors: those of [`document`].
pub fn worked(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    detail: Detail,
    (words, templates): (&Words, &Templates),
) -> Result<(Document, Option<Beyond>), Finding> {
    made(problem, variant, number, (words, templates, detail), &|draft| {
        figure::all(draft.problem, draft.variant, draft.words)
    })
}

/// Its text alone, without the pictures, which take longer than all the rest. Errors: those of [`document`].
pub fn text(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    words: &Words,
    templates: &Templates,
) -> Result<String, Finding> {
    made(problem, variant, number, (words, templates, Detail::Short), &|_| Vec::new())
        .map(|(d, _)| d.markdown)
}

/// The pictures that a solution may show, by name.
type Pictures<'p> = &'p dyn Fn(&Draft) -> Vec<(String, Picture)>;

fn made(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    (words, templates, detail): (&Words, &Templates, Detail),
    pictures: Pictures,
) -> Result<(Document, Option<Beyond>), Finding> {
    let scene = scene_of(problem, variant)?;
    let mut draft = Draft::new(problem, variant, scene, words, Symbols::new(words));
    draft.detail = detail;
    let mut derived = derive(&mut draft);
    let short = if derived.is_ok() { too_short(&mut draft) } else { Vec::new() };
    if !short.is_empty() {
        let symbols = Symbols::new(words).with_figures(short);
        draft = Draft::new(problem, variant, scene, words, symbols);
        draft.detail = detail;
        derived = derive(&mut draft);
    }
    let beyond = match derived.and_then(|()| check(&draft)) {
        Ok(()) => None,
        Err(DerivationStop::Fault(fault)) => return Err(fault),
        Err(DerivationStop::Beyond(what)) => {
            // What was written down up to here leads nowhere.
            draft = Draft::new(problem, variant, scene, words, Symbols::new(words));
            let carried = scene.joints.iter().any(|joint| joint.kind.carrier().is_some());
            Some(if what == Beyond::Unfound && carried { Beyond::Mechanism } else { what })
        }
    };
    let mut sections = std::mem::take(&mut draft.sections);
    let answers = answers(&draft, number);
    let mut first = SolutionSection::new("answers", words.get("solution.title.answers"));
    let boxed: Vec<String> = answers.iter().map(|(id, answer)| format!("`{id}` {answer}")).collect();
    first.blocks.push(Block::Markdown(format!("> {}", boxed.join(" · "))));
    sections.extend([first, given(&draft)]);
    match beyond {
        None => sections.extend(beware::section(&draft, number)),
        Some(what) => {
            let mut section = SolutionSection::new("beyond", words.get("solution.title.beyond"));
            section.say(words.say("solution.short", &[("what", &what.text(words))]));
            sections.push(section);
        }
    }
    sections.sort_by_key(|s| ORDER.iter().position(|id| *id == s.id));
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
        template::texts([("id", s.id), ("title", &s.title), ("gap", s.gap()), ("body", body)])
    });
    view.value("sections", template::list(list));
    view.value(
        "section",
        template::map(sections.iter().zip(&bodies).map(|(s, body)| (s.id, template::finished(body)))),
    );
    let list = answers.iter().map(|(id, answer)| template::texts([("id", id), ("answer", answer)]));
    view.value("answers", template::list(list));
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

/// All that is derived: the scene, then what is asked of it by formulas.
fn derive(draft: &mut Draft) -> Result<(), DerivationStop> {
    narrate::sections(draft)?;
    asked::not_given(draft);
    asked::answer(draft)
}

/// Quantities that have to be shown with more figures, for what is printed of them to give what is printed after it.
fn too_short(draft: &mut Draft) -> Vec<(SymbolId, usize)> {
    let page = Page::new(draft);
    let blocks = page.sections.iter().flat_map(|section| &section.blocks);
    let written: String = blocks.map(Block::text).collect();
    let printed = page.derived.iter().filter(|step| {
        let line = page.chain(step.symbol, &step.from);
        written.contains(line.split_once(r"\\").map_or(line.as_str(), |(_, rest)| rest))
    });
    page.symbols.too_short(printed)
}

/// Is every question answered, and every number that of the key?
fn check(draft: &Draft) -> Result<(), DerivationStop> {
    for q in &draft.problem.questions {
        if draft.found_for(q.label).is_none() {
            return Err(Beyond::Quantity(q.label.quantity).into());
        }
    }
    for (label, answer) in draft.found.iter().copied() {
        match answer {
            DerivedAnswer::Value(symbol) => {
                // For what was measured its unknown was looked for: it hangs on what that is found to be.
                let measured = draft.scene.formulas.found.is_some_and(|f| f.label == label);
                let Some(entry) = draft.variant.solved.get(label).filter(|_| !measured) else {
                    continue;
                };
                let (here, key) = (draft.symbols.value(symbol), entry.value());
                // What is the small rest of large terms is judged by their size.
                let scale = here.abs().max(key.abs()) * entry.cond.max(1.0);
                let scale = if scale.is_nan() { entry.scale } else { scale.max(entry.scale) };
                // A formula that yields no number does not cover the case; another number than the key's is wrong.
                if !here.is_finite() && key.is_finite() {
                    return Err(Beyond::Unfound.into());
                }
                if !(here - key).abs().le(&(AGREEMENT_REL * scale)) {
                    return Err(Beyond::Differs(label.quantity).into());
                }
            }
            DerivedAnswer::Word(word) if draft.variant.solved.word(label).is_some_and(|key| key != word) => {
                return Err(Beyond::Differs(label.quantity).into());
            }
            DerivedAnswer::Word(_) => {}
        }
    }
    Ok(())
}

fn given(draft: &Draft) -> SolutionSection {
    let mut section = SolutionSection::new("given", draft.words.get("solution.title.given"));
    let data: Vec<String> = draft.told().map(|d| format!("${d}$")).collect();
    section.say(format!("{}.", data.join(", ")));
    section
}

/// The answers as they are to be handed in: id, as in `1.omega`, and text.
fn answers(draft: &Draft, number: usize) -> Vec<(String, String)> {
    let answer = |q: &Question| {
        let Some(entry) = draft.variant.solved.get(q.label) else {
            let word = draft.variant.solved.word(q.label);
            return word.map_or_else(String::new, |w| format!("`{}`", said(draft.words, w)));
        };
        let found = draft.found_for(q.label);
        let value = draft.scene.as_asked(q.label, entry.value());
        let symbol = match found {
            // A sign that no words tell is left out, as in the key.
            Some(DerivedAnswer::Value(symbol)) if value > entry.value() => {
                format!("$|{}| = ", draft.symbols.tex(symbol))
            }
            // In the unit of the formulas too, where that is another.
            Some(DerivedAnswer::Value(symbol)) => {
                let (name, shown) = (draft.symbols.tex(symbol), draft.symbols.shown(symbol));
                let same = draft.symbols.is_degrees(symbol) || draft.symbols.unit(symbol) == q.unit.tex();
                if same { format!("${name} = ") } else { format!("${name} = {shown} = ") }
            }
            _ => "$".to_owned(),
        };
        told(draft, q, value).replacen('$', &symbol, 1)
    };
    draft.problem.questions.iter().map(|q| (format!("{number}.{}", q.id), answer(q))).collect()
}

/// A value (SI) as an answer to a question: with its unit and the figures asked, and where it points if words tell its sign.
fn told(draft: &Draft, q: &Question, value: f64) -> String {
    let digits = shown::significant(q.unit.from_si(value), usize::from(q.figures));
    let whole = q.unit.tex_with(&tex_digits(&digits, draft.words));
    let senses = make_key::sense_words(draft.scene, q.label).filter(|_| q.label.quantity.is_directed());
    // `way` counts up the line, or to the right.
    let up =
        senses.map(|[positive, _]| if matches!(positive, "down" | "back" | "left") { -value } else { value });
    let way = up.and_then(|up| way(draft.scene, q.label.of, up));
    format!("${whole}${}", way.map_or_else(String::new, |w| format!(" ({})", draft.words.get(w))))
}

/// A word of an answer as the sheet has it.
fn said(words: &Words, word: Word) -> &str {
    words.get(&format!("sheet.{}", word.as_str()))
}

/// The phrase for a direction along the line of a body; `None` for 0.
pub fn way(scene: &Scene, owner: Owner, value: f64) -> Option<&'static str> {
    // In the plane a sign is told by the question.
    if scene.lead().is_some() {
        return None;
    }
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
