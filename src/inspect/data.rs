//! Data of a problem as somebody gives them, or drawn: the case they belong to, values, and how each is shown.
use crate::bank::decimal::Decimal;
use crate::bank::{Bank, Case, Datum, Draw, Problem};
use crate::finding::{Finding, Findings};
use crate::inspect::sentences;
use crate::inspect::table::unsatisfiable;
use crate::num::shown;
use crate::problem::maker::Maker;
use crate::scene::Scene;
use crate::sheet::statement;
use crate::solve::agree;
use crate::solve::ladder::Wish;
use crate::solve::method::{Knob, Method};
use crate::solve::outcome::{Refusal, Solved};
use crate::units::{self, Unit};

/// Why a scene has no answer, as findings.
pub fn refused(problem: &Problem, scene: &Scene, refusal: &Refusal) -> Findings {
    let texts = sentences::refusal(problem, scene, refusal);
    texts.into_iter().map(|t| Finding::new(&problem.id, t)).collect()
}

/// What was asked of the ladder, checked. Errors: settings that the method does not have, or that are none.
pub fn wish(method: Option<Method>, rtol: Option<f64>, step: Option<&str>) -> Result<Wish, Findings> {
    let mut faults = Findings::default();
    let knob = method.map_or(Knob::Tolerance, Method::knob);
    if let Some(rtol) = rtol {
        if !(rtol > 0.0 && rtol < 1.0) {
            let fault = Finding::new("--rtol", format!("{} is no tolerance", shown::significant(rtol, 5)));
            faults.push(fault.hint("write a number above 0 and below 1, such as 1e-9"));
        }
        if knob == Knob::Step {
            let fault = Finding::new("--rtol", "the method steps at a fixed length and has no tolerance");
            faults.push(fault.hint("write --step, or take dopri5 or dop853"));
        }
    }
    let mut step_s = None;
    if let Some(text) = step {
        match seconds(text) {
            Ok(step) => step_s = Some(step),
            Err(why) => {
                faults.push(Finding::new("--step", why).hint("write a time above 0, such as 1ms or 1/60s"))
            }
        }
        if knob != Knob::Step {
            let fault = Finding::new("--step", "only euler, verlet and rk4 have a step of fixed length");
            faults.push(fault.hint("write --method rk4"));
        }
    }
    faults.into_result(Wish { method, rtol, step_s })
}

/// A time step: `1ms`, `0.02`, `1/60s`.
fn seconds(text: &str) -> Result<f64, String> {
    let trimmed = text.trim();
    let (over, rest) = match trimmed.split_once('/') {
        // `1/60s` is a sixtieth of a second, as people write it.
        Some((n, d)) if !n.is_empty() && n.trim().bytes().all(|b| b.is_ascii_digit()) => {
            (n.trim().parse::<f64>().ok(), d.trim())
        }
        _ => (None, trimmed),
    };
    let second = Unit::parse("s").map_err(|e| e.to_string())?;
    let q = units::parse_quantity(rest, &second).map_err(|e| format!("`{text}`: {e}"))?;
    if !second.agrees(&q.unit) {
        return Err(format!("`{text}`: {}", second.mismatch(&q.unit)));
    }
    let value = q.unit.to_si(over.map_or(q.number, |n| n / q.number));
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(format!("`{text}` is no step")) }
}

/// Data from `--set` or drawn with a seed: the case, the values, and each as it is shown. Errors: none are given, or they are not
/// those of a case.
pub fn data(bank: &Bank, problem: &Problem, set: &[String], seed: Option<u64>) -> Result<Data, Findings> {
    if !set.is_empty() {
        return given(problem, set);
    }
    let Some(seed) = seed else {
        if let Some(data) = constants(problem) {
            return Ok(data);
        }
        let example = problem.data.first().map_or("m", |d| d.symbol.as_str());
        let fault = Finding::new("", "no data are given");
        return Err(fault
            .hint(format!("write --set {example}=... for each datum, or --seed N to draw"))
            .into());
    };
    drawn(bank, problem, seed)
}

/// Does what really happens fit what the problem declares? A problem that declares no regime takes any, as in drawing.
pub fn fits(problem: &Problem, case: usize, solved: &Solved) -> bool {
    let declared = |c: &Case| solved.regime.is_one_of(&c.regimes, &c.scene) && solved.holds_as(&c.regimes);
    problem.cases.get(case).is_some_and(declared)
}

/// Case, values as scenes take them, and each datum as it is shown.
pub type Data = (usize, Vec<f64>, Vec<String>);

fn drawn(bank: &Bank, problem: &Problem, seed: u64) -> Result<Data, Findings> {
    let variant =
        Maker::new(problem, seed, &bank.id).variant("").map_err(|none| unsatisfiable(bank, &none))?;
    let shown = printed(problem, &variant.values);
    Ok((variant.case, variant.data, shown))
}

/// The data where a case has nothing but constants; of several such cases the first that holds.
fn constants(problem: &Problem) -> Option<Data> {
    let of_case = |(i, case): (usize, &Case)| {
        let values = case.least();
        (i, problem.numbers(&values), printed(problem, &values))
    };
    let mut all = problem.cases.iter().enumerate().filter(|(_, case)| case.is_constant()).map(of_case);
    let first = all.next()?;
    let holds = |(case, data, _): &Data| {
        agree::answers(&problem.cases[*case].scene, data).is_ok_and(|solved| fits(problem, *case, &solved))
    };
    if holds(&first) { Some(first) } else { Some(all.find(holds).unwrap_or(first)) }
}

/// Each datum as it is shown.
pub fn printed(problem: &Problem, values: &[Option<Decimal>]) -> Vec<String> {
    let shown = |(i, value): (usize, &Option<Decimal>)| {
        value.map(|v| format!("{} = {}", problem.data[i].symbol, statement::printed(problem, i, v)))
    };
    values.iter().enumerate().filter_map(shown).collect()
}

/// Data from `--set`, and the case to which they belong.
fn given(problem: &Problem, set: &[String]) -> Result<Data, Findings> {
    let mut faults = Findings::default();
    let mut values: Vec<Option<(f64, String)>> = vec![None; problem.data.len()];
    for text in set {
        let Some((symbol, value)) = text.split_once('=') else {
            let fault = Finding::new("--set", format!("`{text}` is no datum"));
            faults.push(fault.hint("write a symbol, `=` and a value, such as m=40kg"));
            continue;
        };
        let symbol = symbol.trim();
        let field = format!("--set {symbol}");
        let Some(i) = problem.data.iter().position(|d| d.symbol == symbol) else {
            let known = problem.data.iter().map(|d| d.symbol.as_str());
            let fault = Finding::new(field, format!("{} has no datum `{symbol}`", problem.id));
            faults.push(fault.hint(units::spell::hint(symbol, "its data", known)));
            continue;
        };
        if values[i].is_some() {
            faults.push(Finding::new(field, "is given twice"));
            continue;
        }
        match quantity(value.trim(), &problem.data[i]) {
            Ok(scene) => values[i] = Some((scene, format!("{symbol} = {}", value.trim()))),
            Err(why) => faults.push(Finding::new(field, why)),
        }
    }
    let gravity = problem.data.len().saturating_sub(1);
    let fixed_g = constant(problem, gravity);
    let drawn = |c: usize, i: usize| problem.cases[c].draws.get(i).is_some_and(Option::is_some);
    // The case whose data are exactly those given; of several such the first that holds.
    let exact = |c: &usize| (0..gravity).all(|i| values[i].is_some() == drawn(*c, i));
    let fitting: Vec<usize> = (0..problem.cases.len()).filter(exact).collect();
    if fitting.is_empty() && faults.is_empty() {
        let missing = |c: usize| (0..gravity).filter(move |i| drawn(c, *i)).filter(|i| values[*i].is_none());
        let nearest = (0..problem.cases.len()).min_by_key(|c| missing(*c).count()).unwrap_or(0);
        for Datum { symbol, unit, .. } in missing(nearest).map(|i| &problem.data[i]) {
            let example = match unit.ascii() {
                "1" => "0.5".to_owned(),
                unit => format!("1{}", unit.replace(' ', "*")),
            };
            let fault = Finding::new("--set", format!("{symbol} is not given"));
            faults.push(fault.hint(format!("write --set '{symbol}={example}' with its value")));
        }
        if faults.is_empty() {
            faults.push(Finding::new("--set", "no case of the problem has exactly these data"));
        }
    }
    faults.into_result(())?;
    let absent = |i| if i == gravity { fixed_g } else { 0.0 };
    let value = |(i, v): (usize, &Option<(f64, String)>)| v.as_ref().map_or(absent(i), |(scene, _)| *scene);
    let data: Vec<f64> = values.iter().enumerate().map(value).collect();
    let mut shown: Vec<String> = values.into_iter().flatten().map(|(_, text)| text).collect();
    if shown.iter().all(|t| !t.starts_with("g = ")) {
        shown.push(format!("g = {fixed_g} m/s^2"));
    }
    let solves = |c: &usize| {
        agree::answers(&problem.cases[*c].scene, &data).is_ok_and(|solved| fits(problem, *c, &solved))
    };
    let case = fitting.iter().copied().find(solves).or(fitting.first().copied()).unwrap_or(0);
    Ok((case, data, shown))
}

/// The value of a datum that is always the same, such as g.
fn constant(problem: &Problem, datum: usize) -> f64 {
    let draw = problem.cases.iter().find_map(|c| c.draws.get(datum)?.as_ref());
    match (draw, problem.data.get(datum)) {
        (Some(Draw::Always { value, decimals }), Some(d)) => {
            d.number(Decimal { value: *value, decimals: *decimals })
        }
        _ => 0.0,
    }
}

/// A value as scenes hold it; a plain number is SI (an angle in degrees).
fn quantity(text: &str, datum: &Datum) -> Result<f64, String> {
    let unit = &datum.unit;
    let q = units::parse_quantity(text, &Unit::one()).map_err(|e| format!("`{text}`: {e}"))?;
    // A unit may end in a digit: `ft/s^2`.
    if q.plain {
        return Ok(q.number);
    }
    if unit.agrees(&q.unit) {
        Ok(datum.typed(&q))
    } else {
        Err(format!("`{text}`: {}", unit.mismatch(&q.unit)))
    }
}

/// A value typed after `--set` against the same value as a constant of a bank in that unit.
///
/// The earlier tests typed only units that end in a letter (`40kg`, `200mm`). Whether a unit was written had been read off the
/// last character of the text, so that `32.2ft/s^2` was 32.2 m/s^2 and `1.4 s^2` passed as a mass. Here every name of the
/// table is typed, alone, in powers and in products, for data of every kind: it is what the bank would draw in this unit, or
/// is refused as another kind.
#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::load;
    use crate::template;
    use crate::units::names;
    use std::collections::BTreeSet;

    /// Symbols of the data and the units in which they are given unless another is tried.
    const DATA: &[(&str, &str)] = &[
        ("m", "kg"),
        ("I", "kg m^2"),
        ("b", "m"),
        ("P", "N"),
        ("M", "N m"),
        ("w0", "rad/s"),
        ("v1", "m/s"),
        ("theta", "deg"),
        ("mu", "1"),
    ];

    /// The same for the second problem.
    const ON_A_SPRING: &[(&str, &str)] = &[("m", "kg"), ("ks", "N/m"), ("x0", "m"), ("t1", "s")];

    /// Two problems whose data are all of value 0.3, those of one symbol in this unit.
    fn bank(symbol: &str, unit: &str) -> String {
        let line = |(name, own): &(&str, &str)| {
            let unit = if *name == symbol { unit } else { *own };
            format!("      {name}: {{name: a datum, unit: \"{unit}\", draw: always 0.3}}\n")
        };
        let data = |list: &[(&str, &str)]| -> String { list.iter().map(line).collect() };
        let g = if symbol == "g" { unit } else { "m/s^2" };
        let (first, second) = (data(DATA), data(ON_A_SPRING));
        format!(
            "bank: typed
title: Typed
gravity: 0.3 {g}
problems:
  p:
    title: A block and a drum
    data:
{first}    scene:
      surfaces: {{incline: {{slope: theta}}}}
      bodies:
        drum: {{moment of inertia: I, radii: {{rim: b}}, moves: about a fixed axle}}
        block: {{mass: m, moves: along incline, positive: down}}
      ties:
        - slides: {{body: block, mu_k: mu}}
        - cord: {{name: upper, from: {{body: block, tied at: centre, leaves: back}}, to: {{body: drum, wound on: rim, leaves: front down}}}}
        - cord: {{name: pull, from: {{body: block, tied at: centre, leaves: forward}}, pulled with: P}}
      forces: [couple: {{on: drum, moment: M, sense: forward}}]
      start: {{drum: {{spin: w0}}}}
      end: {{speed: {{of: block, reaches: v1}}}}
    questions:
      a: {{ask: the acceleration, unit: m/s^2, quantity: block.a}}
    statement: '{{{{ m }}}}{{{{ I }}}}{{{{ b }}}}{{{{ P }}}}{{{{ M }}}}{{{{ w0 }}}}{{{{ v1 }}}}{{{{ theta }}}}{{{{ mu }}}}{{{{ g }}}}'
  q:
    title: A block on a spring
    data:
{second}    scene:
      bodies:
        block: {{mass: m, moves: vertically, positive: down}}
      ties:
        - cord: {{from: {{body: block, tied at: centre, leaves: up}}, spring: {{stiffness: ks, stretch: x0, attached: rigidly}}}}
      start: at rest
      end: {{time: {{of: block, is: t1}}}}
    questions:
      v: {{ask: the speed, unit: m/s}}
    statement: '{{{{ m }}}}{{{{ ks }}}}{{{{ x0 }}}}{{{{ t1 }}}}{{{{ g }}}}'
"
        )
    }

    fn parsed(symbol: &str, unit: &str) -> Bank {
        let found = load::bank(&bank(symbol, unit), "bank.yaml", &template::variables_of);
        found.unwrap_or_else(|f| panic!("{symbol} in {unit}: {f:?}"))
    }

    /// Spellings of units: each name alone, in powers, and in products and quotients with a few others, many of which end in a
    /// digit.
    fn spellings() -> BTreeSet<String> {
        const FORMS: [&str; 8] =
            ["{}/{o}", "{o}/{}", "{} {o}", "{}/{o}^2", "{o}/{}^2", "{o} {}2", "{o}·{}⁻²", "{} {o}^2/s^2"];
        let mut all = BTreeSet::new();
        for name in names() {
            for power in ["", "^2", "2", "²", "^-1", "-2", "**2"] {
                all.insert(format!("{name}{power}"));
            }
            for other in ["slug", "ft", "s", "lbf"] {
                all.extend(FORMS.iter().map(|f| f.replace("{}", &name).replace("{o}", other)));
            }
        }
        all
    }

    /// The number of a datum, as scenes take it, where it is typed with this unit.
    fn typed(bank: &Bank, problem: &Problem, symbol: &str, unit: &str) -> Result<f64, String> {
        let given = problem.data.iter().filter(|d| d.symbol != "g" || symbol == "g");
        let set = |d: &Datum| match d.symbol == symbol {
            true => format!("{symbol}=0.3{unit}"),
            false => format!("{}=0.3", d.symbol),
        };
        let set: Vec<String> = given.map(set).collect();
        let at = problem.data.iter().position(|d| d.symbol == symbol).unwrap_or(usize::MAX);
        match data(bank, problem, &set, None) {
            Ok((_, data, _)) => Ok(data[at]),
            Err(faults) => Err(faults.iter().map(|f| format!("{f}\n")).collect()),
        }
    }

    #[test]
    fn every_unit_typed_is_the_unit_drawn() {
        let base = parsed("", "");
        let kinds: [(usize, &[(&str, &str)]); 3] = [(0, DATA), (1, ON_A_SPRING), (0, &[("g", "m/s^2")])];
        let (mut same, mut refused, mut digit, mut n) = (0, 0, 0, 0u32);
        for unit in spellings() {
            let Ok(read) = Unit::parse(&unit) else { continue };
            for (at, list) in kinds {
                for (symbol, own) in list {
                    let fits = Unit::parse(own).is_ok_and(|own| own.agrees(&read));
                    n += 1;
                    if fits {
                        let gap = if n % 2 == 0 { " " } else { "" };
                        let found = typed(&base, &base.problems[at], symbol, &format!("{gap}{unit}"));
                        let of = |bank: &Bank| {
                            let mut data = bank.problems[at].data.iter();
                            data.find(|d| d.symbol == *symbol).expect("the datum of the bank").clone()
                        };
                        // A slope of whole turns is refused by the bank: there the unit alone is changed.
                        let datum = match *symbol {
                            "theta" => Datum { unit: read.clone(), ..of(&base) },
                            _ => of(&parsed(symbol, &unit)),
                        };
                        let number = datum.number(Decimal { value: 3, decimals: 1 });
                        assert_eq!(found, Ok(number), "{symbol}=0.3 {unit}");
                        same += 1;
                        digit += u32::from(unit.ends_with(|c: char| c.is_ascii_digit()));
                    } else if n % 13 == 0 {
                        // A sample of all the kinds that it is not.
                        let told = typed(&base, &base.problems[at], symbol, &unit)
                            .expect_err(&format!("{symbol}=0.3{unit} is not in {own}"));
                        assert!(told.contains(&format!("--set {symbol}")), "{told}");
                        assert!(told.contains("expected"), "{told}");
                        refused += 1;
                    }
                }
            }
        }
        assert!(same > 1_000 && refused > 5_000 && digit > 200, "{same} {refused} {digit}");
    }
}
