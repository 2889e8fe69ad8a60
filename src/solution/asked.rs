//! What a question asks that is no quantity of the scene as it stands: an expression, a quantity as if contacts were others, and a
//! datum that is found from a measurement.
use crate::bank::{Problem, Question};
use crate::num::formula::{Formula, Step};
use crate::scene::{AsIf, Degree, Given, Label, Num, Owner, Quantity, Scene, Taken, Term, Tie};
use crate::solution::account::of_body;
use crate::solution::draft::{Detail, Draft};
use crate::solution::expr::{
    Expr, SymbolId, arc_tangent, cosine, magnitude, number, power, product, root, sine, square, sum,
};
use crate::solution::factors::Cancel;
use crate::solution::narrate;
use crate::solution::page::Page;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::tex_digits;
use crate::solution::written::width;
use crate::words::plain::capital;

/// Widest formula that stands for itself in an answer.
const SHORT: f64 = 12.0;

/// The labels whose quantities are needed for what is asked: of questions, of formulas, of a measurement.
pub fn needed(scene: &Scene, problem: &Problem) -> Vec<Label> {
    let mut all: Vec<Label> = Vec::new();
    for label in problem.questions.iter().map(|q| q.label) {
        match label.of {
            Owner::Asked(i) => {
                let terms = scene.formulas.asked.get(i).into_iter().flat_map(|a| a.formula.names());
                // What another question asks is found with that one.
                let said = |t| match t {
                    Term::Said(label) => Some(label),
                    Term::Other(o, label) => {
                        scene.formulas.others.get(o).filter(|o| is_so(scene, o.0)).map(|_| label)
                    }
                    Term::Given(_) => None,
                };
                all.extend(terms.filter_map(said).filter(|l| !matches!(l.of, Owner::Asked(_))));
            }
            _ => all.push(label),
        }
    }
    let next = scene.formulas.others.iter().filter(|(how, _)| *how == AsIf::Next);
    all.extend(next.flat_map(|(_, next)| next.formulas.taken.iter().map(|t| t.label)));
    all.extend(scene.formulas.found.map(|f| f.label));
    let first = |(i, label): (usize, &Label)| (!all[..i].contains(label)).then_some(*label);
    all.iter().enumerate().filter_map(first).collect()
}

/// Is what is supposed so anyway: that it rolls, where it does?
fn is_so(scene: &Scene, how: AsIf) -> bool {
    how == AsIf::Rolls && !scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. }))
}

/// Answers the questions by formula once everything else has been found.
pub fn answer(draft: &mut Draft) -> Result<(), DerivationStop> {
    let scene = draft.scene;
    let problem = draft.problem;
    let asked: Vec<(usize, &Question)> = problem
        .questions
        .iter()
        .filter_map(|q| if let Owner::Asked(i) = q.label.of { Some((i, q)) } else { None })
        .collect();
    let mut others: Vec<(usize, Label, SymbolId)> = Vec::new();
    for (i, (how, other)) in scene.formulas.others.iter().enumerate() {
        let names =
            asked.iter().filter_map(|(i, _)| scene.formulas.asked.get(*i)).flat_map(|a| a.formula.names());
        let labels: Vec<Label> = names
            .filter_map(|t| if let Term::Other(o, label) = t { (o == i).then_some(label) } else { None })
            .collect();
        if !labels.is_empty() {
            // What would roll, and does, has been found; so has the friction that the rest would need to.
            let so = is_so(scene, *how);
            let known = labels.iter().map(|label| {
                let needed = Label { quantity: Quantity::FrictionIfRolled, ..*label };
                let supposed = *how == AsIf::Rolls && label.quantity == Quantity::Friction;
                let symbol = draft.value_for(if so || !supposed { *label } else { needed });
                symbol.filter(|_| so || supposed).map(|symbol| (i, *label, symbol))
            });
            if let Some(known) = known.collect::<Option<Vec<_>>>() {
                if so {
                    let mut page = Page::new(draft);
                    page.begin_as("as_if", "rolled");
                    let found: Vec<String> = known.iter().map(|(.., symbol)| page.shown(*symbol)).collect();
                    page.say("asked.rolls_so", &[("found", &found.join(", "))]);
                    page.end();
                }
                others.extend(known);
                continue;
            }
            if *how == AsIf::Next {
                hand_over(draft, other)?;
            }
            (draft.scene, draft.as_if) = (other, Some(*how));
            let found = narrate::as_if(draft, *how, &labels);
            (draft.scene, draft.as_if) = (scene, None);
            draft.values.clone_from(&draft.variant.data);
            draft.handed.clear();
            others.extend(found?.into_iter().map(|(label, symbol)| (i, label, symbol)));
        }
    }
    let mut page = Page::new(draft);
    let several = asked.len() > 1;
    // What follows from data alone comes before the rest, which may be put in terms of it.
    let direct = |i: usize| {
        let formula = scene.formulas.asked.get(i).map(|a| &a.formula);
        formula.is_some_and(|f| f.names().all(|t| matches!(t, Term::Given(_))))
    };
    let follows = scene.formulas.others.iter().any(|(how, _)| *how == AsIf::Next);
    for (id, first) in [("asked_first", true), (if follows { "asked_next" } else { "asked" }, false)] {
        page.begin_as(id, "asked");
        for (i, question) in asked.iter().filter(|(i, _)| direct(*i) == first) {
            let Some(asked) = scene.formulas.asked.get(*i) else { continue };
            let from = expression(&mut page, &asked.formula, &|draft, term| named(draft, term, &others))?;
            let what = (!question.ask.contains("{{")).then(|| capital(&question.ask));
            let known = page.constant_as(&from, &asked.unit);
            let symbol = match (from.clone(), known) {
                (Expr::Symbol(symbol), _) => symbol,
                (_, Some(known)) => {
                    if let Some(what) = what {
                        page.say("asked.told", &[("what", &what)]);
                        let line = page.chain(known, &from);
                        page.formulas_or_one(vec![line]);
                        // It is derived on the page.
                        page.draft.told.retain(|(told, _)| *told != known);
                    }
                    known
                }
                (from, None) => {
                    let letter = if several { format!("Z_{{{}}}", i + 1) } else { "Z".to_owned() };
                    // A quantity of the motion may bear the letter already.
                    let open = |id: &&String| is_symbol(id) && page.symbols.named(&[id.as_str()]).is_none();
                    let own = Some(&question.id).filter(open).cloned();
                    // What is short needs no letter, unless its numbers are put in.
                    let plain = page.detail == Detail::Short;
                    let short = || Some(page.tex(&from)).filter(|tex| plain && width(tex) <= SHORT);
                    let known = own.or_else(short);
                    let says = if known.is_some() { "asked.told" } else { "asked.called" };
                    let names = [known.as_ref().unwrap_or(&letter).clone(), format!("{letter}^{{*}}")];
                    if let Some(what) = what {
                        let name = page.free(&names);
                        page.say(says, &[("what", &what), ("name", &name)]);
                    }
                    page.find(&names, &asked.unit, from)
                }
            };
            page.tell_new();
            page.answer(question.label, symbol);
        }
        page.end();
    }
    Ok(())
}

/// What a motion that follows takes over, from what was found of the one before it: its numbers, and the data with it.
fn hand_over(draft: &mut Draft, next: &Scene) -> Result<(), DerivationStop> {
    let first = draft.scene.ending_coordinate();
    let quantity = match first.degree {
        Degree::Along => Quantity::Displacement,
        Degree::Turn => Quantity::Phi,
    };
    // Bodies on lines and on fixed axles; the way of one has the sense of its motion.
    let way = draft.key(of_body(quantity, first.body)).ok_or(Beyond::Next)?;
    // Of a motion in phases that way has the sense of the speed at the end only if it has not turned about; and of several speeds each
    // has its own.
    let path = draft.key(of_body(Quantity::Distance, first.body));
    let turned = path.is_some_and(|path| path > way.abs() * (1.0 + 1e-9));
    if draft.scene.goes_in_phases() && (turned || next.start.len() > 1) {
        return Err(Beyond::Next.into());
    }
    let given = draft.values.len();
    let mut taken: Vec<Expr> = Vec::new();
    for Taken { label, directed } in &next.formulas.taken {
        let symbol = draft.value_for(*label).ok_or(Beyond::Next)?;
        let back = *directed && way < 0.0;
        taken.push(if back { -Expr::from(symbol) } else { symbol.into() });
        let value = draft.symbols.value(symbol);
        draft.values.push(if back { -value } else { value });
    }
    for (i, number) in next.formulas.numbers.iter().enumerate() {
        if number.formula.names().all(|g| g.datum < given) {
            continue;
        }
        let from = expression(draft, &number.formula, &|draft, g: Given| {
            let taken = g.datum.checked_sub(given).and_then(|i| taken.get(i)).cloned();
            Ok(taken.map_or_else(|| given_as(draft, g), |taken| (taken, false)))
        })?;
        draft.handed.push((Num::Derived(i), from));
    }
    Ok(())
}

/// Is the id of a question a symbol: a letter, perhaps with one thing below it?
fn is_symbol(id: &str) -> bool {
    let (letter, below) = id.split_once('_').unwrap_or((id, "0"));
    [letter, below].iter().all(|part| part.len() == 1 && part.chars().all(|c| c.is_ascii_alphanumeric()))
        && letter.chars().all(char::is_alphabetic)
}

/// A value that a formula names, and whether it is an angle in degrees.
type Named = Result<(Expr, bool), DerivationStop>;

/// What a formula of a question names.
fn named(draft: &mut Draft, term: Term, others: &[(usize, Label, SymbolId)]) -> Named {
    let symbol = match term {
        Term::Given(given) => return Ok(given_as(draft, given)),
        Term::Said(label) => draft.value_for(label).ok_or(label),
        Term::Other(i, label) => {
            let found = others.iter().find(|(o, l, _)| *o == i && *l == label);
            found.map(|(.., symbol)| *symbol).ok_or(label)
        }
    };
    let symbol = symbol.map_err(|label| Beyond::Quantity(label.quantity))?;
    // A formula takes a quantity as it is asked by itself.
    let sized = draft.scene.quantity_of(term).is_some_and(|(of, label)| of.is_magnitude(label));
    let e = Expr::from(symbol);
    Ok((if sized && e.value(&draft.symbols) < 0.0 { magnitude(e) } else { e }, false))
}

/// A datum in a formula.
pub fn given_as(draft: &mut Draft, given: Given) -> (Expr, bool) {
    (draft.number(Num::Datum(given.datum), "x", "1"), given.degrees)
}

/// A formula of the bank in the symbols of the solution; angles outside of waves count in radians.
pub fn expression<V: Copy + PartialEq>(
    draft: &mut Draft,
    formula: &Formula<V>,
    name: &dyn Fn(&mut Draft, V) -> Named,
) -> Result<Expr, DerivationStop> {
    // Each with: is it an angle in degrees?
    let mut stack: Vec<(Expr, bool)> = Vec::new();
    for step in formula.steps() {
        let top = |stack: &mut Vec<(Expr, bool)>| stack.pop().ok_or(DerivationStop::Beyond(Beyond::Unfound));
        match *step {
            Step::Number(x) => stack.push((written(draft, x), false)),
            Step::Pi => stack.push((draft.pi().into(), false)),
            Step::Name(value) => stack.push(name(draft, value)?),
            Step::Sin | Step::Cos | Step::Tan => {
                let (angle, _) = top(&mut stack)?;
                let wave = match *step {
                    Step::Sin => sine(angle),
                    Step::Cos => cosine(angle),
                    _ => sine(angle.clone()) / cosine(angle),
                };
                stack.push((wave, false));
            }
            Step::Negate | Step::Power(_) | Step::Sqrt | Step::Abs | Step::Asin | Step::Acos | Step::Atan => {
                let (x, degrees) = top(&mut stack)?;
                let x = radians(draft, x, degrees && *step != Step::Negate);
                // The angle of a sine, by its half, which has a tangent everywhere.
                let by_half =
                    |x: Expr| number(2) * arc_tangent(x.clone() / (number(1) + root(number(1) - square(x))));
                let from = match *step {
                    Step::Negate => -x,
                    Step::Sqrt => root(x),
                    Step::Atan => arc_tangent(x),
                    Step::Asin => by_half(x),
                    Step::Acos => Expr::from(draft.pi()) / number(2) - by_half(x),
                    Step::Abs if x.value(&draft.symbols) >= 0.0 => x,
                    Step::Abs => magnitude(x),
                    Step::Power(n) if n < 0 => number(1) / power(x, n.unsigned_abs()),
                    Step::Power(n) => power(x, n.unsigned_abs()),
                    _ => x,
                };
                stack.push((from, degrees && *step == Step::Negate));
            }
            Step::Add | Step::Subtract | Step::Multiply | Step::Divide => {
                let ((b, right), (a, left)) = (top(&mut stack)?, top(&mut stack)?);
                let sums = matches!(step, Step::Add | Step::Subtract);
                let scaled =
                    matches!(b, Expr::Number(..)) || matches!(a, Expr::Number(..)) && *step == Step::Multiply;
                let keeps = if sums { left && right } else { scaled };
                let (a, b) = (radians(draft, a, left && !keeps), radians(draft, b, right && !keeps));
                let from = match step {
                    Step::Add => a + b,
                    Step::Subtract => a - b,
                    Step::Multiply => a * b,
                    _ => a / b,
                };
                stack.push((from, keeps && (left || right)));
            }
        }
    }
    let (whole, degrees) = stack.pop().ok_or(DerivationStop::Beyond(Beyond::Unfound))?;
    Ok(radians(draft, whole, degrees))
}

/// An angle in degrees as one in radians, where it is one.
fn radians(draft: &mut Draft, angle: Expr, degrees: bool) -> Expr {
    if degrees { draft.radians(angle) } else { angle }
}

/// A number of a formula: whole, or a decimal, which is its own symbol.
fn written(draft: &mut Draft, x: f64) -> Expr {
    #[expect(clippy::cast_possible_truncation, reason = "whole and small")]
    if x.fract() == 0.0 && x.abs() < 1e9 {
        return number(x as i64);
    }
    let digits = tex_digits(&format!("{x}"), draft.words);
    draft.symbols.given(&digits, x, &format!("{x}"), "", false).into()
}

/// What is said of data that no sheet gives: what is `any`, and what is found from a measurement.
pub fn not_given(draft: &mut Draft) {
    let mut page = Page::new(draft);
    page.steps.clone_from(&page.draft.steps);
    let any: Vec<String> = page.chosen.iter().map(|s| page.shown(*s)).collect();
    if !any.is_empty() {
        page.begin("any");
        page.say("asked.any", &[("data", &any.join(", "))]);
    }
    page.begin("unknown");
    if let (Some(found), Some(Given { datum, .. })) =
        (page.scene.formulas.found, page.scene.formulas.found.map(|f| f.unknown))
        && let Expr::Symbol(unknown) = page.number(Num::Datum(datum), "x", "1")
        && let Expr::Symbol(measured) = page.number(Num::Datum(found.measured.datum), "x", "1")
        && let Some(forward) = page.value_for(found.label)
    {
        let (name, told) = (page.names(&[unknown]), page.shown(measured));
        let equation = page.stated(forward, &measured.into());
        page.say("asked.unknown", &[("name", &name), ("measured", &told), ("equation", &equation)]);
        match backward(&page, forward, measured, unknown) {
            Some(lines) => {
                page.begin("backward");
                page.say("asked.backward", &[]);
                let lines: Vec<String> = lines.iter().map(|(symbol, is)| page.chain(*symbol, is)).collect();
                page.formulas(lines);
            }
            None => page.say("asked.halved", &[("value", &page.shown(unknown))]),
        }
    }
    page.end();
}

/// From what was measured back to what is to be found: each quantity on the way, solved for by the one before; `None` where it
/// stands in several places or not linearly.
fn backward(
    page: &Page,
    forward: SymbolId,
    measured: SymbolId,
    unknown: SymbolId,
) -> Option<Vec<(SymbolId, Expr)>> {
    let hangs = |symbol: &SymbolId| page.expanded(&(*symbol).into()).uses().contains(&unknown);
    let (mut lines, mut known, mut at) = (Vec::new(), measured, forward);
    while at != unknown {
        let right = page.from(at);
        let mut open = right.uses().into_iter().filter(hangs);
        let next = open.next().filter(|next| *next != at && open.next().is_none())?;
        lines.push((next, inverse(page, known.into(), &right, next)?));
        (known, at) = (next, next);
    }
    Some(lines)
}

/// `left = right`, solved for a symbol on the right.
fn inverse(page: &Page, left: Expr, right: &Expr, symbol: SymbolId) -> Option<Expr> {
    let holds = |e: &&Expr| e.uses().contains(&symbol);
    let rest = |parts: &[Expr]| parts.iter().filter(|e| !holds(e)).cloned().collect::<Vec<_>>();
    let only = |parts: &[Expr]| {
        let mut own = parts.iter().filter(holds);
        own.next().filter(|_| own.next().is_none()).cloned()
    };
    let spread = |e: &Expr| {
        let all = e.terms().into_iter().flat_map(|t| t.factors().spread(symbol));
        sum(all.map(|t| t.expr()))
    };
    match right {
        Expr::Symbol(_) => Some(left),
        Expr::Minus(inner) => inverse(page, -left, inner, symbol),
        Expr::Root(inner) => inverse(page, square(left), inner, symbol),
        Expr::Power(base, 2) if page.value(base) >= 0.0 => inverse(page, root(left), base, symbol),
        Expr::Product(parts) => inverse(page, left.over(product(rest(parts))), &only(parts)?, symbol),
        Expr::Sum(parts) => match only(parts) {
            Some(own) => inverse(page, left - sum(rest(parts)), &own, symbol),
            None => page.isolated(&(left, spread(right)), symbol),
        },
        Expr::Quotient(over, under) => match [over, under].map(|e| holds(&&**e)) {
            [true, false] => inverse(page, left.by(&**under), over, symbol),
            [false, true] => inverse(page, over.over(&left), under, symbol),
            _ => page.isolated(&(spread(&left.by(&**under)), spread(over)), symbol),
        },
        _ => None,
    }
}

/// The mark of symbols of another scene.
pub const fn mark(how: AsIf) -> &'static str {
    match how {
        AsIf::Rolls => r"\mathrm{r}",
        AsIf::Smooth => r"\mathrm{s}",
        AsIf::Next => "2",
    }
}
