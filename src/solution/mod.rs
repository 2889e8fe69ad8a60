//! Worked solutions: both roads in symbols and numbers, from the scene's own terms. A third derivation beside the two that
//! make the key: a solution whose numbers are not those of the key is never printed, a short page stands in its place.
//!
//! A derivation works on a [`desk::Desk`]: it writes its sections and says what it has found on which road. The sections, by
//! id, in the order of the text:
//! - `given`: the data in SI, what is asked;
//! - whatever the derivation writes: `forces`, `eom`, `energy`, ...;
//! - `agree`: what both roads found; `regime`: the check of what was assumed;
//! - `answers`: the answers, rounded; `beware`: wrong methods of the problem, with what they would give.
//!
//! What no derivation covers has a short page: `given`, `beyond` with the reason, `answers`.
pub mod beware;
pub mod by_hand;
pub mod desk;
pub mod expr;
pub mod factors;
pub mod lamina;
pub mod linear;
pub mod mass;
pub mod pen;
pub mod pinned;
pub mod quantities;
pub mod stop;
pub mod text;
pub mod thrown;
pub mod valued;
pub mod written;

use crate::bank::Problem;
use crate::bank::Question;
use crate::figure;
use crate::figure::names;
use crate::finding::Finding;
use crate::picture::Picture;
use crate::problem::make::Variant;
use crate::problem::make_key;
use crate::scene::End;
use crate::scene::Label;
use crate::scene::Owner;
use crate::scene::Scene;
use crate::scene::Slope;
use crate::scene::Tie;
use crate::sheet::document::Document;
use crate::sheet::number;
use crate::solution::desk::Answer;
use crate::solution::desk::Desk;
use crate::solution::desk::Found;
use crate::solution::quantities::tex_digits;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;
use crate::solution::text::Block;
use crate::solution::text::Section;
use crate::solve::outcome::Word;
use crate::template;
use crate::template::Templates;
use crate::template::View;
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
    made(problem, variant, number, (words, templates), &|desk| {
        figure::all(desk.problem, desk.variant, desk.words)
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
type Pictures<'p> = &'p dyn Fn(&Desk) -> Vec<(String, Picture)>;

fn made(
    problem: &Problem,
    variant: &Variant,
    number: usize,
    (words, templates): (&Words, &Templates),
    pictures: Pictures,
) -> Result<(Document, Option<Beyond>), Finding> {
    let mut desk = Desk::new(problem, variant, words)?;
    let beyond = match derive(&mut desk).and_then(|()| check(&desk)) {
        Ok(()) => None,
        Err(Stop::Fault(fault)) => return Err(fault),
        Err(Stop::Beyond(what)) => {
            // What was written down up to here leads nowhere.
            desk = Desk::new(problem, variant, words)?;
            Some(what)
        }
    };
    let mut sections = std::mem::take(&mut desk.sections);
    let answers = answers(&desk, number);
    sections.push(given(&desk, number));
    match beyond {
        None => {
            sections.push(agree(&desk, number));
            sections.extend(beware::section(&desk, number));
        }
        Some(what) => {
            let mut section = Section::new("beyond", words.get("solution.title.beyond"));
            section.say(words.say("solution.short", &[("what", &what.text(words))]));
            sections.push(section);
        }
    }
    let mut last = Section::new("answers", words.get("solution.title.answers"));
    if beyond.is_none() {
        last.say(words.get("solution.answers"));
    }
    last.blocks.push(Block::List(answers.iter().map(|(id, answer)| format!("`{id}`: {answer}")).collect()));
    sections.push(last);
    sections.sort_by_key(|s| rank(s.id));

    let pictures = if beyond.is_none() { pictures(&desk) } else { Vec::new() };
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
    view.text("title", &problem.title);
    view.text("case", &problem.cases[variant.case].name);
    for (symbol, whole) in desk.whole() {
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
fn derive(desk: &mut Desk) -> Result<(), Stop> {
    if desk.scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        return lamina::work(desk);
    }
    if desk.scene.pinned().is_some() {
        return pinned::work(desk);
    }
    if desk.scene.thrown().is_some() && desk.scene.end != End::AtOnce {
        return thrown::work(desk);
    }
    linear::sections(desk)
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
fn check(desk: &Desk) -> Result<(), Stop> {
    for q in &desk.problem.questions {
        if !desk.found.iter().any(|f| f.label == q.label && (f.eom.is_some() || f.energy.is_some())) {
            return Err(Beyond::Quantity(q.label.quantity).into());
        }
    }
    for found in &desk.found {
        for answer in [found.eom, found.energy].into_iter().flatten() {
            match answer {
                Answer::Value(symbol) => {
                    let Some(entry) = desk.variant.solved.get(found.label) else { continue };
                    let (here, key) = (desk.ledger.value(symbol), entry.value());
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
                Answer::Word(word) => {
                    if let Some(key) = desk.variant.solved.word(found.label)
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
fn named(desk: &Desk, label: Label) -> String {
    let forward = way(desk.scene, label.of, 1.0).map_or("", |w| desk.words.get(w));
    let name = desk.say(&format!("solution.name.{}", label.quantity.name()), &[("way", forward)]);
    let mut questions = desk.problem.questions.iter();
    let several = questions.any(|q| q.label.quantity == label.quantity && q.label.of != label.of);
    let owner = match label.of {
        Owner::Body(b) => names::body_within(desk.words, desk.scene, b),
        Owner::Tie(t) => match &desk.scene.ties[t] {
            Tie::Cord(cord) => names::cord(desk.words, desk.scene, cord),
            Tie::Roll { .. } | Tie::Slip { .. } | Tie::Slide { .. } => String::new(),
        },
        Owner::Scene => String::new(),
    };
    let of = if several && !owner.is_empty() { format!(" ({owner})") } else { String::new() };
    let symbol = desk.found.iter().find(|f| f.label == label).and_then(|f| match f.eom.or(f.energy)? {
        Answer::Value(symbol) => Some(desk.ledger.tex(symbol)),
        Answer::Word(_) => None,
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

fn given(desk: &Desk, number: usize) -> Section {
    let mut section = Section::new("given", desk.words.get("solution.title.given"));
    let data: Vec<String> = desk.told().iter().map(|d| format!("${d}$")).collect();
    let phrase = if desk.degrees_told() { "solution.given_angles" } else { "solution.given" };
    section.say(desk.say(phrase, &[("data", &data.join(", "))]));
    let asked = desk.problem.questions.iter();
    let asked: Vec<String> =
        asked.map(|q| format!("{} (`{}`)", named(desk, q.label), id_of(number, q))).collect();
    section.say(desk.say("solution.asked", &[("list", &asked.join(", "))]));
    section
}

/// What both roads found, question by question.
fn agree(desk: &Desk, number: usize) -> Section {
    let w = desk.words;
    let mut section = Section::new("agree", w.get("solution.title.agree"));
    // What is summed over particles has no motion and no work.
    let roads = match desk.scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        true => ["particles", "decomposed"],
        false => ["eom", "energy"],
    };
    let head = ["question", roads[0], roads[1], "difference"];
    let mut rows = vec![head.map(|h| w.get(&format!("solution.agree.{h}")).to_owned()).to_vec()];
    let mut notes: Vec<String> = Vec::new();
    let shown = |answer: Option<Answer>| match answer {
        None => "–".to_owned(),
        Some(Answer::Value(symbol)) => format!("${}$", desk.ledger.shown(symbol)),
        Some(Answer::Word(word)) => format!("`{}`", said(w, word)),
    };
    for q in &desk.problem.questions {
        let Some(Found { eom, energy, note, .. }) = desk.found.iter().find(|f| f.label == q.label) else {
            continue;
        };
        let difference = match (eom, energy) {
            (Some(Answer::Value(a)), Some(Answer::Value(b))) => {
                format!("${}$", desk.ledger.difference(*a, *b))
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
fn answers(desk: &Desk, number: usize) -> Vec<(String, String)> {
    let answer = |q: &Question| {
        let Some(entry) = desk.variant.solved.get(q.label) else {
            let word = desk.variant.solved.word(q.label);
            return word.map_or_else(String::new, |w| format!("`{}`", said(desk.words, w)));
        };
        let found = desk.found.iter().find(|f| f.label == q.label).and_then(|f| f.eom.or(f.energy));
        let symbol = match found {
            Some(Answer::Value(symbol)) => format!("${} = ", desk.ledger.tex(symbol)),
            _ => "$".to_owned(),
        };
        told(desk, q, entry.value()).replacen('$', &symbol, 1)
    };
    desk.problem.questions.iter().map(|q| (id_of(number, q), answer(q))).collect()
}

/// A value (SI) as an answer to a question: with its unit and the figures asked, and where it points if words tell its sign.
fn told(desk: &Desk, q: &Question, value: f64) -> String {
    let digits = number::rounded(q.unit.from_si(value), usize::from(q.figures));
    let whole = q.unit.tex_with(&tex_digits(&digits, desk.words));
    let directed = q.label.quantity.is_directed() && make_key::words_sign(desk.scene, q.label);
    let way = if directed { way(desk.scene, q.label.of, value) } else { None };
    format!("${whole}${}", way.map_or_else(String::new, |w| format!(" ({})", desk.words.get(w))))
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
