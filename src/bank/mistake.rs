//! Wrong methods of a problem: how each comes to its answers. What they are called and what is said about them stands in the
//! catalogue of misconceptions, by the same id.
use crate::bank::asked::AskedContext;
use crate::bank::expression::{Exponents, Expression, Name};
use crate::bank::node::{Faults, Fields, Node, items, known_as, named, shorten};
use crate::bank::scene::{self, DatumSymbol, Touching};
use crate::bank::{Datum, Follow, Mistake, Question, asked, inverse, labels, measure};
use crate::scene::{Label, Scene};
use crate::units::spell;
use std::cell::Cell;

/// What the reader knows of the problem.
pub struct Context<'a> {
    /// Its data, g last.
    pub data: &'a [Datum],
    /// Index of g.
    pub gravity: usize,
    pub questions: Option<&'a Node>,
    /// The datum that was measured, and where the quantity is named.
    pub measured: Option<(usize, &'a Node)>,
    pub cases: &'a [CaseContext<'a>],
}

/// What the reader knows of a case.
pub struct CaseContext<'a> {
    pub name: &'a str,
    pub scene: &'a Scene,
    /// The text that the scene was read from.
    pub node: &'a Node,
    /// The symbols that its scene may use.
    pub symbols: &'a [DatumSymbol],
    /// How contacts are taken that do not say whether they roll or slip.
    pub touching: Touching,
}

/// Reads `mistakes: {A05: {data: {k: R/sqrt(2)}}}`.
pub fn mistakes(node: &Node, context: &Context, faults: &Faults) -> Vec<Mistake> {
    named(node, "wrong methods by id", faults)
        .into_iter()
        .filter_map(|(id, key, value)| mistake(id, key, value, context, faults))
        .collect()
}

fn mistake(id: &str, key: &Node, node: &Node, context: &Context, faults: &Faults) -> Option<Mistake> {
    if !is_id(id) {
        let hint = "letters, digits and `-`, beginning with a letter, such as `A05` or `rotation-forgotten`";
        faults.hint(key, format!("`{}` is no id of a wrong method", shorten(id)), hint);
    }
    let mut fields = Fields::open(node, "a wrong method (data, scene, values, of, cases)", faults)?;
    let (data_node, scene_node) = (fields.get("data"), fields.get("scene"));
    let (values_node, of_node) = (fields.get("values"), fields.get("of"));
    let cases_node = fields.get("cases");
    let unguarded = fields.get("unguarded").map(|n| (n, n.text().unwrap_or("").trim().to_owned()));
    if data_node.is_none() && scene_node.is_none() && values_node.is_none() {
        let hint = "`data: {k: R/sqrt(2)}`, `scene: {ties: [...]}` or `values: {omega: v/R}`";
        faults.hint(node, "this wrong method changes nothing", hint);
    }
    if let Some((n, reason)) = &unguarded
        && reason.is_empty()
    {
        faults.hint(n, "expected the reason why no draw is refused for it", "a sentence");
    }
    let mut data = Vec::new();
    for (symbol, key, value) in
        data_node.map_or_else(Vec::new, |n| named(n, "changed data by symbol", faults))
    {
        let known = context.data.iter().map(|d| d.symbol.as_str());
        let index = known_as(symbol, key, "symbol of the data", known, faults);
        data.extend(index.zip(expression(value, context, false, faults)));
    }
    let mut values = Vec::new();
    for (name, key, value) in values_node.map_or_else(Vec::new, |n| named(n, "values by quantity", faults)) {
        let label = label(name, key, context, faults);
        values.extend(label.zip(expression(value, context, false, faults)));
    }
    let of = of_node.and_then(|n| items(n, "a list of quantities", faults)).unwrap_or_default();
    let of = of.iter().filter_map(|i| label(i.text().unwrap_or(""), i, context, faults)).collect();
    let scenes = scene_node.map_or_else(Vec::new, |changes| {
        context.cases.iter().map(|case| changed(case, changes, context, faults)).collect()
    });
    let cases = cases_node.map_or_else(Vec::new, |n| cases(n, context, faults));
    Some(Mistake { id: id.to_owned(), data, scenes, values, of, cases, unguarded: unguarded.map(|(_, r)| r) })
}

/// The cases in which a method is taken.
fn cases(node: &Node, context: &Context, faults: &Faults) -> Vec<usize> {
    let index = |item: &Node| {
        let name = item.text().unwrap_or("").trim();
        known_as(name, item, "case of this problem", context.cases.iter().map(|case| case.name), faults)
    };
    items(node, "a list of cases", faults).unwrap_or_default().iter().filter_map(index).collect()
}

fn is_id(text: &str) -> bool {
    text.len() <= 48
        && text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-')
}

/// The scene with some of its fields replaced, read by the reader of scenes.
fn changed(case: &CaseContext, changes: &Node, context: &Context, faults: &Faults) -> Option<Scene> {
    let Some(node) = case.node.overlaid(changes) else {
        return faults.refuse(changes, format!("expected fields of a scene, found {}", changes.kind()));
    };
    let mut scene = scene::read(&node, case.symbols, case.touching, context.gravity, faults).scene?;
    inverse::put(&node, context.measured, &mut scene, context.data, &Faults::default());
    if let Some(questions) = context.questions {
        // What the changed scene cannot answer, the method does not come to.
        let of = AskedContext { data: context.data, case: case.name };
        asked::put(questions, &mut scene, &of, &Faults::default());
    }
    Some(scene)
}

fn label(name: &str, at: &Node, context: &Context, faults: &Faults) -> Option<Label> {
    let mut trouble = None;
    for CaseContext { scene, .. } in context.cases {
        match labels::named(scene, name) {
            Ok(label) => return Some(label),
            Err(fault) => trouble = trouble.or(Some(fault)),
        }
    }
    if let Some((message, hint)) = trouble {
        faults.maybe(at, message, hint);
    }
    None
}

/// Reads `follows: {v: r*omega}`: which part follows from which, and how. Unless the questions are `whole`, one that is missing
/// here may be one that cannot be read, which is a finding already.
pub fn follows(
    node: &Node,
    (questions, whole): (&[Question], bool),
    context: &Context,
    faults: &Faults,
) -> Vec<Follow> {
    let mut list = Vec::new();
    for (id, key, value) in named(node, "relations by question", faults) {
        let Some(index) = questions.iter().position(|q| q.id == id) else {
            if whole {
                let hint = spell::hint(id, "questions", questions.iter().map(|q| q.id.as_str()));
                faults.hint(key, format!("`{}` is no question that is asked", shorten(id)), hint);
            }
            continue;
        };
        let Some(by) = expression(value, context, true, faults) else { continue };
        let wanted = measure::powers(&questions[index].unit);
        if by.powers != wanted {
            let (found, wanted) = (measure::powers_text(by.powers), measure::powers_text(wanted));
            faults.at(value, format!("this has the dimension {found}, `{id}` {wanted}"));
        }
        let from: Vec<usize> =
            (0..index).filter(|q| by.quantities().any(|l| l == questions[*q].label)).collect();
        if from.is_empty() && whole {
            let earlier: Vec<&str> = questions[..index].iter().map(|q| q.id.as_str()).collect();
            let hint = match earlier.is_empty() {
                true => format!("`{id}` is asked first: ask before it what it follows from"),
                false => format!("name one of: {}", earlier.join(", ")),
            };
            faults.hint(value, "this follows from no part that is asked before", hint);
        }
        let text = value.text().unwrap_or("").trim().to_owned();
        list.push(Follow { question: index, from, by, text });
    }
    list
}

/// An expression in data and quantities. Unless it is `strict`, terms may have different dimensions: a wrong method may well
/// mix them up.
fn expression(node: &Node, context: &Context, strict: bool, faults: &Faults) -> Option<Expression> {
    let text = node.text().unwrap_or("");
    let scene_read = Cell::new(true);
    let lookup = |name: &str| -> Result<(Name, Exponents), (String, Option<String>)> {
        if let Some(found) = measure::datum(context.data, name) {
            return Ok(found);
        }
        // Without a scene there is no quantity, and why there is none is a finding already.
        scene_read.set(!context.cases.is_empty());
        let mut trouble = (format!("`{}` is not known", shorten(name)), None);
        for CaseContext { scene, .. } in context.cases {
            match labels::named(scene, name).and_then(|label| measure::quantity(scene, label, name)) {
                Ok(found) => return Ok(found),
                Err(fault) => trouble = fault,
            }
        }
        Err(trouble)
    };
    let read =
        if strict { Expression::parse(text, &lookup) } else { Expression::parse_loosely(text, &lookup) };
    match read {
        Ok(e) => Some(e),
        Err(fault) => {
            if scene_read.get() {
                fault.tell(node, text, faults);
            }
            None
        }
    }
}
