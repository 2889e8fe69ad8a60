//! The inverse question: a datum that is `unknown:` is found from another one that was `measured:`.
use crate::bank::asked::{self, AskedContext, OF_NEXT};
use crate::bank::node::{Faults, Node};
use crate::bank::scene::DatumUse;
use crate::bank::{Datum, labels, measure, need::Need};
use crate::scene::admissible;
use crate::scene::{Found, Given, Label, Num, Owner, Quantity, Scene, Term};

/// The one datum that was measured, where one is unknown; anything else is told.
pub fn only<'n>(
    problem: &Node,
    measured: &[(usize, &'n Node)],
    data: &[Datum],
    faults: &Faults,
) -> Option<(usize, &'n Node)> {
    let unknown: Vec<&str> = data.iter().filter(|d| d.unknown.is_some()).map(|d| d.symbol.as_str()).collect();
    match (unknown.as_slice(), measured) {
        ([], []) => None,
        ([_], [one]) => Some(*one),
        ([symbol], []) => {
            let message =
                format!("`{symbol}` is unknown, and nothing is measured from which it could be found");
            faults.refuse_with(
                problem,
                message,
                "give a datum `measured:` and a quantity, such as `measured: t`",
            )
        }
        ([], [(_, node), ..]) => faults.refuse_with(
            node,
            "this is measured, and nothing is unknown",
            "write `unknown: 1 to 3 step 0.1` for a datum",
        ),
        _ => {
            let at = measured.get(1).map_or(problem, |(_, node)| *node);
            faults.refuse_with(
                at,
                "one datum is found from one measurement",
                "keep one `unknown:` and one `measured:`",
            )
        }
    }
}

/// Where no draw of joined bodies can be proved to have but one solution: what is followed there in steps or summed is not enclosed.
fn unproved(scene: &Scene, label: Label) -> Option<&'static str> {
    if scene.lead().is_none() || scene.is_still() {
        return None;
    }
    let of_time = |term| matches!(term, Term::Said(of) if of.quantity == Quantity::T);
    let formula = match label.of {
        Owner::Asked(i) => scene.formulas.asked.get(i),
        _ => None,
    };
    let timed =
        label.quantity == Quantity::T || formula.is_some_and(|asked| asked.formula.names().any(of_time));
    let swings = scene.pinned().is_some() && scene.couples.is_empty() && scene.struts.is_empty();
    let rough = scene.joints.iter().any(|joint| joint.kind.rubs().is_some());
    rough.then_some("after friction on the way").or((timed && !swings).then_some("from a time"))
}

/// Has the unknown datum of a scene found from the measurement; gives the uses of data in it.
pub fn put(
    problem: &Node,
    measured: Option<(usize, &Node)>,
    scene: &mut Scene,
    data: &[Datum],
    faults: &Faults,
) -> Vec<DatumUse> {
    let unknown = data.iter().enumerate().find_map(|(i, d)| Some((i, d.unknown.as_ref()?)));
    let (Some((i, draw)), Some((at, node))) = (unknown, measured) else { return Vec::new() };
    let name = node.text().unwrap_or("").trim();
    let mut uses = Vec::new();
    // A quantity as it stands, or an expression, such as one in quantities of the motion that follows.
    let operator = |c: char| !(c.is_alphanumeric() || c == '_' || c == '.');
    let expression =
        labels::named(scene, name).is_err() && name.contains(operator) || name.starts_with(OF_NEXT);
    if expression {
        uses = asked::measured(node, scene, &AskedContext { data, case: "" }, faults);
    }
    let label = match asked::label(scene, name).map_or_else(|| labels::named(scene, name), Ok) {
        Ok(label) if !label.quantity.is_word() => label,
        Ok(_) => {
            faults.at(node, format!("`{name}` is a word: only a number is measured"));
            return Vec::new();
        }
        Err((message, hint)) => {
            faults.maybe(node, message, hint);
            return Vec::new();
        }
    };
    if let Some(why) = unproved(scene, label) {
        let hint = "measure a speed where nothing rubs on the way, or look at an instant: `end: at once`; or give this datum and ask for what was measured";
        faults.hint(
            node,
            format!("that only one value of `{}` gives `{name}` cannot be proved {why}", data[i].symbol),
            hint,
        );
        return vec![DatumUse { datum: at, need: *Need::TERM }];
    }
    let symbol = &data[i].symbol;
    let (own, wanted) = (measure::powers(&data[at].unit), measure::own_powers(scene.unit(label)));
    if own != wanted {
        let (own, wanted) = (measure::powers_text(own), measure::powers_text(wanted));
        faults.at(node, format!("`{}` has the dimension {own}, `{name}` {wanted}", data[at].symbol));
        return Vec::new();
    }
    let mut used = false;
    admissible::rules(scene, &mut |number, _| used |= scene.data_of(number).any(|datum| datum == i));
    if !used {
        let message = format!("`{symbol}` is to be found, but the scene does not use it");
        faults.hint(
            problem.field("data").and_then(|d| d.field(symbol)).unwrap_or(node),
            message,
            "use it in the scene",
        );
    }
    let (low, high) = draw.range();
    let scene_value = |end: crate::bank::decimal::Decimal| match data[i].degrees {
        true => data[i].unit.decimal_to_scene(end.value, end.decimals),
        false => data[i].unit.decimal_to_si(end.value, end.decimals),
    };
    let range = [scene_value(low), scene_value(high)];
    let mut rule = None;
    admissible::rules(scene, &mut |number, r| {
        let fits = |x: &f64| admissible::fits_rule(*x, r);
        if number == Num::Datum(i) && !range.iter().all(fits) {
            rule = Some(r);
        }
    });
    if rule.is_some() || range[0] >= range[1] {
        let place = problem.field("data").and_then(|d| d.field(symbol)).unwrap_or(node);
        faults.hint(
            place,
            format!("`{symbol}` cannot have all values of this range"),
            "such as `unknown: 1 to 3 step 0.1`",
        );
        return Vec::new();
    }
    let given = |datum: usize| {
        let powers = measure::powers(&data[datum].unit).map(|p| p / 4);
        Given { datum, degrees: data[datum].degrees, powers }
    };
    scene.formulas.found = Some(Found { unknown: given(i), range, measured: given(at), label });
    uses.push(DatumUse { datum: at, need: *Need::TERM });
    uses
}
