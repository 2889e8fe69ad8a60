//! Questions that no quantity answers as it stands: an expression (`value:`), or a quantity as if contacts were others (`if:`).
use crate::bank::expression::{Exponents, Expression, Name};
use crate::bank::node::{Faults, Node, choice, named, shorten, text};
use crate::bank::scene::DatumUse;
use crate::bank::{Datum, labels, measure, need::Need, soundness};
use crate::num::formula::{Formula, Step};
use crate::scene::{AsIf, Asked, Given, Label, Owner, Quantity, Scene, Term, Tie};
use crate::units::Unit;

/// The words of `if:`, and that of `motion:`.
const AS_IF: [(&str, AsIf); 2] = [("rolls", AsIf::Rolls), ("smooth", AsIf::Smooth)];
const MOTION: [(&str, AsIf); 1] = [("next", AsIf::Next)];
/// Before a quantity in an expression: it is one of the motion that follows.
pub const OF_NEXT: &str = "next.";

/// Is this a question that asks by a formula?
pub fn is_formula(question: &Node) -> bool {
    ["value", "if", "motion"].into_iter().any(|field| question.field(field).is_some())
}

/// What the formulas of the questions are read against.
pub struct AskedContext<'a> {
    /// The data, g last.
    pub data: &'a [Datum],
    /// Name of the case, empty if there is one only.
    pub case: &'a str,
}

/// Puts the questions that ask by a formula into a scene, one for each, and gives the uses of data in them. One that this scene
/// cannot answer is told, and has no value there.
pub fn put(questions: &Node, scene: &mut Scene, context: &AskedContext, faults: &Faults) -> Vec<DatumUse> {
    let mut all = Vec::new();
    for (id, key, node) in named(questions, "questions by id", &Faults::default()) {
        if !is_formula(node) {
            continue;
        }
        // What an expression comes to may bear any name: the question's own goes before that of a quantity.
        if node.field("value").is_none() && Quantity::from_name(id).is_some() {
            let hint = "give it a name of its own, such as `largest`, and name the quantity by `quantity:`";
            faults.hint(key, format!("`{id}` is a quantity itself; this question asks another thing"), hint);
        }
        let asked = read(id, key, node, scene, context, faults).unwrap_or_else(|| nothing(id));
        all.extend(uses(&asked));
        scene.formulas.asked.push(asked);
    }
    all
}

/// A question without a value.
fn nothing(id: &str) -> Asked {
    let formula = Formula::new(vec![Step::Number(f64::NAN)]);
    let (quantity, of) = (Quantity::Value, Owner::Scene);
    let (id, text, unit) = (id.to_owned(), String::new(), "1".to_owned());
    Asked { id, text, formula, quantity, of, unit, powers: [0; 3] }
}

fn read(
    id: &str,
    key: &Node,
    node: &Node,
    scene: &mut Scene,
    context: &AskedContext,
    faults: &Faults,
) -> Option<Asked> {
    let [value, as_if, motion, quantity, unit] =
        ["value", "if", "motion", "quantity", "unit"].map(|name| node.field(name));
    let other = match (as_if, motion) {
        (None, None) => None,
        (Some(n), None) => Some(other(n, scene, faults)?),
        (None, Some(n)) => Some(following(n, scene, faults)?),
        (Some(_), Some(n)) => return faults.refuse(n, "`if` and `motion` do not go together"),
    };
    let target = other.map_or(&*scene, |at| &scene.formulas.others[at].1);
    // On a smooth surface a body may keep a spin that its scene does not follow.
    let spins_on = target.bodies.iter().zip(&scene.bodies).any(|(there, here)| there.turns != here.turns);
    let label_of = |name: &str| {
        let label = labels::named(target, name)?;
        if spins_on && matches!(label.quantity, Quantity::KineticEnergy | Quantity::RotationalFraction) {
            let message = format!("`{name}` would need the spin that a body keeps on a smooth surface");
            return Err((message, Some("ask for speeds, accelerations, forces or times".to_owned())));
        }
        Ok(label)
    };
    let told = |n: &Node, (message, hint): (String, Option<String>)| {
        let case =
            if context.case.is_empty() { String::new() } else { format!(" (case `{}`)", context.case) };
        faults.maybe(n, format!("{message}{case}"), hint);
    };
    let word = |field: &str, n: Option<&Node>| {
        n.and_then(Node::text).map_or_else(String::new, |how| format!(", {field}: {}", how.trim()))
    };
    let condition = word("if", as_if) + &word("motion", motion);
    let Some(written) = value else {
        let name = quantity.and_then(Node::text).map_or(id, str::trim);
        let label = label_of(name).map_err(|why| told(quantity.unwrap_or(key), why)).ok()?;
        if label.quantity.is_word() {
            return faults.refuse(
                quantity.unwrap_or(key),
                format!("`{name}` is answered with a word; `if:` and `motion:` are for numbers"),
            );
        }
        let powers = measure::own_powers(label.quantity.unit()).map(|p| p / 4);
        let (formula, unit) =
            (Formula::new(vec![Step::Name(term(other, label))]), label.quantity.unit().to_owned());
        let (id, text) = (id.to_owned(), format!("{name}{condition}"));
        return Some(Asked { id, text, formula, quantity: label.quantity, of: label.of, unit, powers });
    };
    if let Some(n) = quantity {
        faults.hint(
            n,
            "this question asks for an expression, not for a quantity",
            "keep `value:` or `quantity:`",
        );
    }
    let (written_text, formula, exponents) = expression(written, scene, other, &label_of, context, faults)?;
    unit_fits(id, node, (unit, &written_text), exponents, faults)?;
    let powers = exponents.map(|p| p / 4);
    let quantity = Quantity::Value;
    let (id, text) = (id.to_owned(), format!("{written_text}{condition}"));
    Some(Asked { id, text, formula, quantity, of: Owner::Scene, unit: measure::si(powers), powers })
}

/// What a label means of the scene itself, or of another one.
fn term(other: Option<usize>, label: Label) -> Term {
    other.map_or(Term::Said(label), |at| Term::Other(at, label))
}

/// Looks up the name of a quantity, or says what is wrong with it.
type Named<'n> = dyn Fn(&str) -> Result<Label, (String, Option<String>)> + 'n;

/// An expression in data and quantities of the scene, or of another one, and of the motion that follows: as it is written, what it
/// means, and its dimension.
fn expression(
    written: &Node,
    scene: &Scene,
    other: Option<usize>,
    label_of: &Named,
    context: &AskedContext,
    faults: &Faults,
) -> Option<(String, Formula<Term>, Exponents)> {
    let target = other.map_or(scene, |at| &scene.formulas.others[at].1);
    let text = text(written, "an expression such as `mu_s*normal`", faults)?;
    let lookup = |name: &str| match measure::datum(context.data, name) {
        Some(found) => Ok(found),
        None => match (name.strip_prefix(OF_NEXT), next(scene)) {
            (Some(of_next), Some(at)) => {
                let target = &scene.formulas.others[at].1;
                let label = labels::named(target, of_next)?;
                let (_, powers) = measure::quantity(target, label, of_next)?;
                Ok((Name::Next(label), powers))
            }
            _ => label_of(name).and_then(|label| measure::quantity(target, label, name)),
        },
    };
    let expression = match Expression::parse(&text, &lookup) {
        Ok(expression) => expression,
        Err(mut fault) => {
            if !context.case.is_empty() {
                fault.message.push_str(&format!(" (case `{}`)", context.case));
            }
            fault.tell(written, &text, faults);
            return None;
        }
    };
    let formula = expression.formula().map(&mut |name| match name {
        Name::Datum(datum, degrees) => {
            let powers = context.data.get(datum).map_or([0; 3], |d| measure::powers(&d.unit).map(|p| p / 4));
            Term::Given(Given { datum, degrees, powers })
        }
        Name::Quantity(label) => term(other, label),
        Name::Next(label) => Term::Other(next(scene).unwrap_or(usize::MAX), label),
    });
    Some((text, formula, expression.powers))
}

/// What a datum measures, where that is no quantity as it stands: an expression, put among what is asked by formulas.
pub fn measured(written: &Node, scene: &mut Scene, context: &AskedContext, faults: &Faults) -> Vec<DatumUse> {
    let read = expression(written, scene, None, &|name| labels::named(scene, name), context, faults);
    let id = written.text().unwrap_or("").trim();
    let asked = read.map_or_else(
        || nothing(id),
        |(text, formula, exponents)| {
            let powers = exponents.map(|p| p / 4);
            Asked { text, formula, unit: measure::si(powers), powers, ..nothing(id) }
        },
    );
    let uses = uses(&asked);
    scene.formulas.asked.push(asked);
    uses
}

/// The data that it names.
fn uses(asked: &Asked) -> Vec<DatumUse> {
    let terms = asked.formula.names().filter_map(|term| match term {
        Term::Given(given) => Some(DatumUse { datum: given.datum, need: *Need::TERM }),
        Term::Said(_) | Term::Other(..) => None,
    });
    terms.collect()
}

/// Has the unit that is written the dimension of the expression? `None`: it has not, or there is none.
fn unit_fits(
    id: &str,
    node: &Node,
    (unit, written): (Option<&Node>, &str),
    powers: Exponents,
    faults: &Faults,
) -> Option<()> {
    let dimension = measure::powers_text(powers);
    let Some(unit) = unit else {
        let hint = format!("write its unit; the expression has the dimension {dimension}");
        return faults.refuse_with(
            node,
            format!("`{id}` asks for an expression, and `unit` is missing"),
            hint,
        );
    };
    // A unit that is none is told where questions are read.
    let found = measure::powers(&Unit::parse(unit.text().unwrap_or("").trim()).ok()?);
    if found == powers {
        return Some(());
    }
    let found = measure::powers_text(found);
    let message = format!("`{}` has the dimension {dimension}, its unit {found}", shorten(written));
    faults.refuse_with(unit, message, format!("a unit such as {dimension}"))
}

/// The motion that follows, as `motion:` names it.
fn following(node: &Node, scene: &Scene, faults: &Faults) -> Option<usize> {
    choice(node, &MOTION, faults)?;
    let hint = "write what happens then under `next` in the scene, such as `next: {end: ...}`";
    next(scene).or_else(|| faults.refuse_with(node, "no motion follows in this scene", hint))
}

/// The motion that follows: its index.
fn next(scene: &Scene) -> Option<usize> {
    scene.formulas.others.iter().position(|(how, _)| *how == AsIf::Next)
}

/// The scene as if its contacts were others: its index, new or known.
fn other(node: &Node, scene: &mut Scene, faults: &Faults) -> Option<usize> {
    let how = choice(node, &AS_IF, faults)?;
    if let Some(at) = scene.formulas.others.iter().position(|(h, _)| *h == how) {
        return Some(at);
    }
    let Some(other) = scene.as_if(how) else {
        let hint = "take `if:` away, or write a contact: `rolls`, `slips`, `touches` or `slides`";
        return faults.refuse_with(node, "no contact of this scene could be another", hint);
    };
    if scene.goes_in_phases() && scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. })) {
        let message = "a body that is thrown with slip has a speed and a spin of its own: it cannot be taken as if it rolled or were smooth";
        return faults.refuse_with(
            node,
            message,
            "ask for `a_rolling` or `friction_if_rolled`, or take `if:` away",
        );
    }
    let own = Faults::default();
    soundness::structure(&other, node, &own);
    soundness::instant(&other, &[], node, &own);
    if let Some(why) = own.into_sorted("").iter().next() {
        let so = if how == AsIf::Rolls { "rolled" } else { "were smooth" };
        return faults.refuse(node, format!("as if it {so}, this scene is not solved: {}", why.message));
    }
    scene.formulas.others.push((how, other));
    Some(scene.formulas.others.len() - 1)
}

/// The label of a question that asks by a formula, where the scenes hold them.
pub fn label(scene: &Scene, id: &str) -> Option<Label> {
    let of = scene.formulas.asked.iter().position(|a| a.id == id)?;
    Some(Label { quantity: scene.formulas.asked[of].quantity, of: Owner::Asked(of) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_by_formula_is_told_from_others() {
        let text = |t: &str| Node {
            value: crate::bank::node::Value::Text(t.to_owned()),
            line: 1,
            column: 1,
            path: String::new(),
        };
        let map = |field: &str| Node {
            value: crate::bank::node::Value::Map(vec![(text(field), text("x"))]),
            ..text("")
        };
        assert!(is_formula(&map("value")) && is_formula(&map("if")));
        assert!(!is_formula(&map("quantity")) && !is_formula(&text("value")));
    }
}
