//! `slipstick solve`: a diagnosis of one problem with given data.
use crate::bank::Bank;
use crate::bank::Case;
use crate::bank::Datum;
use crate::bank::Draw;
use crate::bank::Problem;
use crate::bank::decimal::Decimal;
use crate::cli::args;
use crate::cli::banks;
use crate::cli::banks::Loaded;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::cli::words;
use crate::draw::fill;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::problem::make::Maker;
use crate::problem::make::Unsatisfiable;
use crate::scene::Quantity;
use crate::scene::Scene;
use crate::sheet::statement;
use crate::solve::agree;
use crate::solve::ladder;
use crate::solve::ladder::Taken;
use crate::solve::ladder::Wish;
use crate::solve::method::Knob;
use crate::solve::method::Method;
use crate::solve::method::Rung;
use crate::solve::outcome::Refusal;
use crate::solve::outcome::Solved;
use crate::units;
use crate::units::Unit;
use crate::words::Words;
use std::fmt::Write as _;

/// Runs it.
pub fn run(args: &args::Solve, io: &mut Io) -> Exit {
    match answer(args, io) {
        Ok(exit) => exit,
        Err(findings) => io.findings(&findings),
    }
}

fn answer(args: &args::Solve, io: &mut Io) -> Result<Exit, Findings> {
    let wish = wish(&args.by)?;
    let loaded = banks::load(&args.bank)?;
    let problem = banks::problem(&loaded, &args.problem)?;
    let (case, data, shown) = data(&loaded, problem, &args.set, args.seed)?;
    let of_case = &problem.cases[case];
    let (mut solved, taken) = ladder::solve(&of_case.scene, &data, &wish)
        .map_err(|refusal| refused(problem, &of_case.scene, &refusal))?;
    if taken.errors.is_empty() {
        // Nothing is proved where the data leave open which way it goes: the bounds are then absent.
        agree::prove(&of_case.scene, &data, &mut solved);
    }
    let holds = fits(problem, case, &solved);
    if args.json {
        io.piece(&json(problem, case, &solved, &taken));
    } else {
        io.piece(&table(problem, case, &shown, &solved, &taken, holds));
    }
    Ok(if holds { Exit::Fine } else { Exit::RegimeFails })
}

/// Why a scene has no answer, as findings.
pub fn refused(problem: &Problem, scene: &Scene, refusal: &Refusal) -> Findings {
    let texts = words::refusal(problem, scene, refusal);
    texts.into_iter().map(|t| Finding::new(&problem.id, t)).collect()
}

/// What was asked of the ladder, checked.
fn wish(by: &args::By) -> Result<Wish, Findings> {
    let mut faults = Findings::default();
    let method = by.method.method();
    let knob = method.map_or(Knob::Tolerance, Method::knob);
    if let Some(rtol) = by.rtol {
        if !(rtol > 0.0 && rtol < 1.0) {
            faults.push(
                Finding::new("--rtol", format!("{} is no tolerance", words::rounded(rtol, 5)))
                    .hint("write a number above 0 and below 1, such as 1e-9"),
            );
        }
        if knob == Knob::Step {
            let fault = Finding::new("--rtol", "the method steps at a fixed length and has no tolerance");
            faults.push(fault.hint("write --step, or take dopri5 or dop853"));
        }
    }
    let mut step_s = None;
    if let Some(text) = &by.step {
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
    faults.into_result(Wish { method, rtol: by.rtol, step_s })
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
    let value = match over {
        Some(n) => q.unit.to_si(n / q.number),
        None => q.unit.to_si(q.number),
    };
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(format!("`{text}` is no step")) }
}

/// Data from `--set` or drawn with a seed: the case, the values, and each as it is shown.
pub fn data(loaded: &Loaded, problem: &Problem, set: &[String], seed: Option<u64>) -> Result<Data, Findings> {
    if !set.is_empty() {
        return given(problem, set);
    }
    let Some(seed) = seed else {
        let example = problem.data.first().map_or("m", |d| d.symbol.as_str());
        let fault = Finding::new("", "no data are given");
        return Err(fault
            .hint(format!("write --set {example}=... for each datum, or --seed N to draw"))
            .into());
    };
    drawn(loaded, problem, seed)
}

/// Does what really happens fit what the problem declares? A problem that declares no regime takes any, as in drawing.
pub fn fits(problem: &Problem, case: usize, solved: &Solved) -> bool {
    let declared = |c: &Case| solved.regime.is_one_of(&c.regimes, &c.scene) && solved.holds_as(&c.regimes);
    problem.cases.get(case).is_some_and(declared)
}

/// Case, values as scenes take them, and each datum as it is shown.
pub type Data = (usize, Vec<f64>, Vec<String>);

fn drawn(loaded: &Loaded, problem: &Problem, seed: u64) -> Result<Data, Findings> {
    let variant = Maker::new(problem, seed, &loaded.bank.id)
        .variant("")
        .map_err(|none| unsatisfiable(&loaded.bank, &none))?;
    let shown = printed(problem, &variant.values);
    Ok((variant.case, variant.data, shown))
}

/// Each datum as it is shown.
fn printed(problem: &Problem, values: &[Option<Decimal>]) -> Vec<String> {
    let shown = |(i, value): (usize, &Option<Decimal>)| {
        value.map(|v| format!("{} = {}", problem.data[i].symbol, statement::printed(problem, i, v)))
    };
    values.iter().enumerate().filter_map(shown).collect()
}

/// That no draw holds the rules: which refused, what came out, why it has no solution if it has none; and where the data are
/// constants, all that `solve` says of them.
pub fn unsatisfiable(bank: &Bank, none: &Unsatisfiable) -> Finding {
    let mut text = none.to_string();
    if let Some(problem) = bank.problems.iter().find(|p| p.id == none.problem)
        && let Some(case) = problem.cases.get(none.index)
    {
        if let (Some(refusal), None) = (&none.unsolved, &none.disagreement) {
            for why in words::refusal(problem, &case.scene, refusal) {
                text.push_str(&format!("\n    {why}"));
            }
        }
        if let Some((values, data)) = &none.constant
            && let Ok((solved, taken)) = ladder::solve(&case.scene, data, &Wish::default())
        {
            let holds = fits(problem, none.index, &solved);
            let shown = printed(problem, values);
            let told = table(problem, none.index, &shown, &solved, &taken, holds);
            text.push('\n');
            text.push_str(told.trim_end());
        }
    }
    Finding::new(format!("problems.{}", none.problem), text)
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
            let known: Vec<&str> = problem.data.iter().map(|d| d.symbol.as_str()).collect();
            let fault = Finding::new(field, format!("{} has no datum `{symbol}`", problem.id));
            faults.push(match units::spell::closest(symbol, known.iter().copied()) {
                Some(near) => fault.hint(format!("did you mean `{near}`?")),
                None => fault.hint(format!("its data: {}", known.join(", "))),
            });
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
    // The case whose data are exactly those given; of several such the first that holds.
    let fitting: Vec<usize> = (0..problem.cases.len())
        .filter(|c| {
            let draws = &problem.cases[*c].draws;
            (0..gravity).all(|i| values[i].is_some() == draws.get(i).is_some_and(Option::is_some))
        })
        .collect();
    if fitting.is_empty() && faults.is_empty() {
        let missing = |c: usize| -> Vec<&str> {
            let draws = &problem.cases[c].draws;
            (0..gravity)
                .filter(|i| values[*i].is_none() && draws.get(*i).is_some_and(Option::is_some))
                .map(|i| problem.data[i].symbol.as_str())
                .collect()
        };
        let nearest = (0..problem.cases.len()).min_by_key(|c| missing(*c).len()).unwrap_or(0);
        let lacking = missing(nearest);
        if lacking.is_empty() {
            faults.push(Finding::new("--set", "no case of the problem has exactly these data"));
        } else {
            for symbol in lacking {
                let unit = problem.data.iter().find(|d| d.symbol == symbol).map_or("1", |d| d.unit.ascii());
                let example =
                    if unit == "1" { "0.5".to_owned() } else { format!("1{}", unit.replace(' ', "*")) };
                let fault = Finding::new("--set", format!("{symbol} is not given"));
                faults.push(fault.hint(format!("write --set '{symbol}={example}' with its value")));
            }
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let data: Vec<f64> = values
        .iter()
        .enumerate()
        .map(|(i, v)| match v {
            Some((scene, _)) => *scene,
            None if i == gravity => fixed_g,
            None => 0.0,
        })
        .collect();
    let mut shown: Vec<String> = values.into_iter().flatten().map(|(_, text)| text).collect();
    if shown.iter().all(|t| !t.starts_with("g = ")) {
        shown.push(format!("g = {fixed_g} m/s^2"));
    }
    let solves = |c: &usize| {
        agree::solve(&problem.cases[*c].scene, &data).is_ok_and(|solved| fits(problem, *c, &solved))
    };
    let case = fitting.iter().copied().find(solves).or(fitting.first().copied()).unwrap_or(0);
    Ok((case, data, shown))
}

/// The value of a datum that is always the same, such as g.
fn constant(problem: &Problem, datum: usize) -> f64 {
    let draw = problem.cases.iter().find_map(|c| c.draws.get(datum)?.as_ref());
    match (draw, problem.data.get(datum)) {
        (Some(Draw::Always { value, decimals }), Some(d)) => {
            fill::number(d, Decimal { value: *value, decimals: *decimals })
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
        Ok(fill::typed(datum, &q))
    } else {
        Err(format!("`{text}`: {}", unit.mismatch(&q.unit)))
    }
}

/// JSON numbers with 17 significant digits; null where there is none.
fn number(value: Option<f64>) -> String {
    match value {
        // A zero has no sign for a reader: -0.0 + 0.0 is 0.0.
        Some(v) if v.is_finite() => format!("{:.16e}", v + 0.0),
        _ => "null".to_owned(),
    }
}

/// The method that was taken, as JSON.
fn method_json(taken: &Taken) -> String {
    let setting = match taken.rung {
        Rung::Closed | Rung::Doubles | Rung::Settled => "\"setting\": null".to_owned(),
        Rung::Gauss(points) => format!("\"points\": {points}"),
        Rung::Adaptive(_, rtol, _) => format!("\"rtol\": {}", number(Some(rtol))),
        Rung::Fixed(_, step) => format!("\"step_s\": {}", number(Some(step))),
    };
    format!(
        "{{\"name\": \"{}\", {setting}, \"chosen\": {}, \"why\": {}, \"evaluations\": {}, \"steps\": {}, \"evaluations_of_the_estimate\": {}, \"relative_error\": {}}}",
        taken.rung.method().name(),
        taken.chosen,
        string(&words::why(taken)),
        taken.count.evaluations,
        taken.count.steps,
        taken.estimate.evaluations,
        if taken.errors.is_empty() { "null".to_owned() } else { number(Some(taken.worst)) }
    )
}

fn string(text: &str) -> String {
    // A text always has a JSON form.
    serde_json::to_string(text).unwrap_or_default()
}

fn json(problem: &Problem, case: usize, solved: &Solved, taken: &Taken) -> String {
    let scene = &problem.cases[case].scene;
    let mut out = String::new();
    let _ = write!(
        out,
        "{{\n  \"problem\": {},\n  \"regime\": {},\n  \"method\": {},\n  \"checks\": [",
        string(&problem.id),
        string(&solved.regime.word()),
        method_json(taken)
    );
    for (i, check) in solved.checks.iter().enumerate() {
        let comma = if i == 0 { "" } else { "," };
        let detail = string(&words::check(scene, &solved.checks, check));
        let _ = write!(
            out,
            "{comma}\n    {{\"name\": \"{}\", \"ok\": {}, \"detail\": {detail}}}",
            check.kind.name(),
            check.ok
        );
    }
    out.push_str(if solved.checks.is_empty() { "],\n" } else { "\n  ],\n" });
    out.push_str("  \"quantities\": {");
    let mut first = true;
    for row in rows(problem, case, solved, taken) {
        let comma = if first { "" } else { "," };
        first = false;
        let (name, unit) = (string(&row.name), string(row.unit));
        let value = row.word.map_or_else(|| number(row.value), string);
        let _ = write!(
            out,
            "{comma}\n    {name}: {{\"value\": {value}, \"unit\": {unit}, \"eom\": {}, \"energy\": {}, \"gap\": {}, \"cond\": {}{}}}",
            number(row.eom),
            number(row.energy),
            number(row.gap),
            number(row.cond),
            if taken.errors.is_empty() {
                format!(", \"bound\": {}", number(row.bound))
            } else {
                format!(", \"error\": {}", number(row.error))
            }
        );
    }
    out.push_str(if first { "}" } else { "\n  }" });
    let beyond: Vec<String> = solved.beyond.iter().map(|l| string(&scene.name_of(*l))).collect();
    let open: Vec<String> = solved.open.iter().map(|l| string(&scene.name_of(*l))).collect();
    let _ = write!(out, ",\n  \"beyond\": [{}],\n  \"open\": [{}]\n}}\n", beyond.join(", "), open.join(", "));
    out
}

struct Row<'s> {
    order: usize,
    name: String,
    unit: &'s str,
    word: Option<&'static str>,
    value: Option<f64>,
    eom: Option<f64>,
    energy: Option<f64>,
    gap: Option<f64>,
    cond: Option<f64>,
    /// Proved bound of the error, for the printed data.
    bound: Option<f64>,
    /// Estimated error of the method, absolute.
    error: Option<f64>,
}

/// All quantities in the order of their list.
fn rows<'s>(problem: &Problem, case: usize, solved: &'s Solved, taken: &Taken) -> Vec<Row<'s>> {
    let scene = &problem.cases[case].scene;
    let place = |q: Quantity| Quantity::ALL.iter().position(|o| *o == q).unwrap_or(usize::MAX);
    let mut rows: Vec<Row> = solved
        .entries
        .iter()
        .map(|e| Row {
            order: place(e.label.quantity),
            name: scene.name_of(e.label),
            unit: e.label.quantity.unit(),
            word: None,
            value: Some(e.value()),
            eom: e.eom,
            energy: e.energy,
            gap: e.gap(),
            cond: Some(e.cond),
            bound: e.bound,
            error: taken.errors.iter().find(|(l, _)| *l == e.label).map(|(_, error)| *error),
        })
        .chain(solved.words.iter().map(|(label, word)| Row {
            order: place(label.quantity),
            name: scene.name_of(*label),
            unit: "",
            word: Some(word.text()),
            value: None,
            eom: None,
            energy: None,
            gap: None,
            cond: None,
            bound: None,
            error: None,
        }))
        .collect();
    rows.sort_by_key(|r| r.order);
    rows
}

/// What the numbers mean where the regime fails.
pub const NUMBERS_OF_TIES: &str = "; the numbers below are those of the declared ties";

/// What really happens, whether it is what the problem declares, and each condition.
pub fn regime(problem: &Problem, case: usize, solved: &Solved, holds: bool) -> String {
    let scene = &problem.cases[case].scene;
    let mut out =
        format!("regime: {} ({})\n", solved.regime.word(), words::regime(&Words::english(), solved.regime));
    if !holds {
        let regimes = &problem.cases[case].regimes;
        let declared = match regimes.join(", ") {
            any if any.is_empty() => String::new(),
            some => format!(" ({some})"),
        };
        let told = match solved.failing(regimes) {
            Some(check) if !regimes.is_empty() && solved.regime.is_one_of(regimes, scene) => {
                format!("This is what the problem declares{declared}, but {} fails", check.kind.name())
            }
            _ => format!("This is not what the problem declares{declared}"),
        };
        let _ = writeln!(out, "{told}{NUMBERS_OF_TIES}.");
    }
    for check in &solved.checks {
        let mark = if check.ok { "holds" } else { "FAILS" };
        let _ =
            writeln!(out, "  {mark}  {}: {}", check.kind.name(), words::check(scene, &solved.checks, check));
    }
    out
}

fn table(
    problem: &Problem,
    case: usize,
    shown: &[String],
    solved: &Solved,
    taken: &Taken,
    holds: bool,
) -> String {
    let scene = &problem.cases[case].scene;
    let mut out = format!("{}: {}\n", problem.id, shown.join(", "));
    out.push_str(&regime(problem, case, solved, holds));
    let _ = writeln!(out, "method: {}", words::taken(taken));
    let numerical = !taken.errors.is_empty();
    let mut lines = vec![
        ["quantity", "value", "unit", "equations of motion", "work and energy", "gap", "cond"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for row in rows(problem, case, solved, taken) {
        let road = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| words::rounded(v, 12));
        lines.push(vec![
            row.name,
            row.word.map_or_else(|| words::rounded(row.value.unwrap_or(f64::NAN), 5), str::to_owned),
            row.unit.to_owned(),
            if row.word.is_some() { String::new() } else { road(row.eom) },
            if row.word.is_some() { String::new() } else { road(row.energy) },
            row.gap.map_or_else(String::new, |g| if g == 0.0 { "0".to_owned() } else { format!("{g:.0e}") }),
            row.cond.map_or_else(String::new, |c| words::rounded(c, 3)),
        ]);
        if let (true, Some(line)) = (numerical, lines.last_mut()) {
            line.push(row.error.map_or_else(String::new, |e| words::rounded(e, 2)));
        }
    }
    if let (true, Some(head)) = (numerical, lines.first_mut()) {
        head.push("est. error".to_owned());
    }
    out.push_str(&tell::table(&lines, &[0, 2]));
    if !solved.open.is_empty() {
        let names: Vec<String> = solved.open.iter().map(|l| scene.name_of(*l)).collect();
        let _ = writeln!(out, "Left open by statics, for several ties share one force: {}", names.join(", "));
    }
    if !solved.beyond.is_empty() {
        let names: Vec<String> = solved.beyond.iter().map(|l| scene.name_of(*l)).collect();
        let _ = writeln!(out, "Not shown, for no double holds them to 16 digits: {}", names.join(", "));
    }
    out
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

    fn load(symbol: &str, unit: &str) -> Loaded {
        let (text, file) = (bank(symbol, unit), "bank.yaml".to_owned());
        let bank = banks::parse(&text, &file).unwrap_or_else(|f| panic!("{symbol} in {unit}: {f:?}"));
        Loaded { bank, text, file }
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
    fn typed(loaded: &Loaded, problem: &Problem, symbol: &str, unit: &str) -> Result<f64, String> {
        let given = problem.data.iter().filter(|d| d.symbol != "g" || symbol == "g");
        let set = |d: &Datum| match d.symbol == symbol {
            true => format!("{symbol}=0.3{unit}"),
            false => format!("{}=0.3", d.symbol),
        };
        let set: Vec<String> = given.map(set).collect();
        let at = problem.data.iter().position(|d| d.symbol == symbol).unwrap_or(usize::MAX);
        match data(loaded, problem, &set, None) {
            Ok((_, data, _)) => Ok(data[at]),
            Err(faults) => Err(faults.to_string()),
        }
    }

    #[test]
    fn every_unit_typed_is_the_unit_drawn() {
        let base = load("", "");
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
                        let found = typed(&base, &base.bank.problems[at], symbol, &format!("{gap}{unit}"));
                        let of = |loaded: &Loaded| {
                            let mut data = loaded.bank.problems[at].data.iter();
                            data.find(|d| d.symbol == *symbol).expect("the datum of the bank").clone()
                        };
                        // A slope of whole turns is refused by the bank: there the unit alone is changed.
                        let datum = match *symbol {
                            "theta" => Datum { unit: read.clone(), ..of(&base) },
                            _ => of(&load(symbol, &unit)),
                        };
                        let number = fill::number(&datum, Decimal { value: 3, decimals: 1 });
                        assert_eq!(found, Ok(number), "{symbol}=0.3 {unit}");
                        same += 1;
                        digit += u32::from(unit.ends_with(|c: char| c.is_ascii_digit()));
                    } else if n % 13 == 0 {
                        // A sample of all the kinds that it is not.
                        let told = typed(&base, &base.bank.problems[at], symbol, &unit)
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
