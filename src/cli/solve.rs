//! `slipstick solve`: a diagnosis of one problem with given data.
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
use crate::problem::make::Maker;
use crate::scene::Quantity;
use crate::sheet::statement;
use crate::solve::agree;
use crate::solve::outcome::Solved;
use crate::units;
use crate::units::Unit;
use std::fmt::Write as _;

/// Runs it.
pub fn run(args: &args::Solve, io: &mut Io) -> Exit {
    match answer(args, io) {
        Ok(exit) => exit,
        Err(findings) => io.findings(&findings),
    }
}

fn answer(args: &args::Solve, io: &mut Io) -> Result<Exit, Vec<Finding>> {
    let loaded = banks::load(&args.bank)?;
    let problem = banks::problem(&loaded, &args.problem).map_err(|f| vec![f])?;
    let (case, data, shown) = if args.set.is_empty() {
        let Some(seed) = args.seed else {
            let example = problem.data.first().map_or("m", |d| d.symbol.as_str());
            let fault = Finding::new("", "no data are given");
            return Err(vec![
                fault.hint(format!("write --set {example}=... for each datum, or --seed N to draw")),
            ]);
        };
        drawn(&loaded, problem, seed)?
    } else {
        given(problem, &args.set)?
    };
    let of_case = &problem.cases[case];
    let solved = agree::solve(&of_case.scene, &data).map_err(|refusal| {
        let texts = words::refusal(problem, &of_case.scene, &refusal);
        texts.into_iter().map(|t| Finding::new(&problem.id, t)).collect::<Vec<_>>()
    })?;
    let holds = fits(problem, case, &solved);
    if args.json {
        io.piece(&json(problem, case, &solved));
    } else {
        io.piece(&table(problem, case, &shown, &solved, holds));
    }
    Ok(if holds { Exit::Fine } else { Exit::RegimeFails })
}

/// Does what really happens fit what the problem declares? A problem that declares no regime takes any, as in drawing.
fn fits(problem: &Problem, case: usize, solved: &Solved) -> bool {
    let word = solved.regime.word();
    let declared = |c: &Case| c.regimes.is_empty() || c.regimes.contains(&word);
    solved.all_hold() && problem.cases.get(case).is_some_and(declared)
}

type Data = (usize, Vec<f64>, Vec<String>);

fn drawn(loaded: &Loaded, problem: &Problem, seed: u64) -> Result<Data, Vec<Finding>> {
    let variant = Maker::new(problem, seed, &loaded.bank.id)
        .variant("")
        .map_err(|e| vec![Finding::new(format!("problems.{}", problem.id), e.to_string())])?;
    let shown = |(i, value): (usize, &Option<Decimal>)| {
        value.map(|v| format!("{} = {}", problem.data[i].symbol, statement::printed(problem, i, v)))
    };
    let shown = variant.values.iter().enumerate().filter_map(shown).collect();
    Ok((variant.case, variant.data, shown))
}

/// Data from `--set`, and the case to which they belong.
fn given(problem: &Problem, set: &[String]) -> Result<Data, Vec<Finding>> {
    let mut faults = Vec::new();
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
    let plain = text.ends_with(|c: char| c.is_ascii_digit() || c == '.');
    if plain {
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

fn string(text: &str) -> String {
    // A text always has a JSON form.
    serde_json::to_string(text).unwrap_or_default()
}

fn json(problem: &Problem, case: usize, solved: &Solved) -> String {
    let scene = &problem.cases[case].scene;
    let mut out = String::new();
    let _ = write!(
        out,
        "{{\n  \"problem\": {},\n  \"regime\": {},\n  \"checks\": [",
        string(&problem.id),
        string(&solved.regime.word())
    );
    for (i, check) in solved.checks.iter().enumerate() {
        let comma = if i == 0 { "" } else { "," };
        let detail = string(&words::check(scene, check));
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
    for row in rows(problem, case, solved) {
        let comma = if first { "" } else { "," };
        first = false;
        let (name, unit) = (string(&row.name), string(row.unit));
        let value = row.word.map_or_else(|| number(row.value), string);
        let _ = write!(
            out,
            "{comma}\n    {name}: {{\"value\": {value}, \"unit\": {unit}, \"eom\": {}, \"energy\": {}, \"gap\": {}, \"cond\": {}}}",
            number(row.eom),
            number(row.energy),
            number(row.gap),
            number(row.cond)
        );
    }
    out.push_str(if first { "}\n}\n" } else { "\n  }\n}\n" });
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
}

/// All quantities in the order of their list.
fn rows<'s>(problem: &Problem, case: usize, solved: &'s Solved) -> Vec<Row<'s>> {
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
        }))
        .collect();
    rows.sort_by_key(|r| r.order);
    rows
}

fn table(problem: &Problem, case: usize, shown: &[String], solved: &Solved, holds: bool) -> String {
    let scene = &problem.cases[case].scene;
    let mut out = format!("{}: {}\n", problem.id, shown.join(", "));
    let _ = writeln!(out, "regime: {} ({})", solved.regime.word(), words::regime(solved.regime));
    if !holds {
        let declared = match problem.cases[case].regimes.join(", ") {
            any if any.is_empty() => String::new(),
            some => format!(" ({some})"),
        };
        let _ = writeln!(
            out,
            "This is not what the problem declares{declared}; the numbers below are those of the declared ties."
        );
    }
    for check in &solved.checks {
        let mark = if check.ok { "holds" } else { "FAILS" };
        let _ = writeln!(out, "  {mark}  {}: {}", check.kind.name(), words::check(scene, check));
    }
    let mut lines = vec![
        ["quantity", "value", "unit", "equations of motion", "work and energy", "gap", "cond"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for row in rows(problem, case, solved) {
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
    }
    out.push_str(&tell::table(&lines, &[0, 2]));
    out
}
