//! The file format of a bank: which fields there are and what they mean. All findings are collected.
use crate::bank::TEMPLATE_NAMES;
use crate::bank::Variables;
use crate::bank::course;
use crate::bank::decimal::{self, Decimal};
use crate::bank::expression::{Expression, Name, Powers};
use crate::bank::measure;
use crate::bank::mistake;
use crate::bank::node::{Faults, Fields, Node, Value, close_name, named, shorten};
use crate::bank::review;
use crate::bank::scene::{self, Need, Read, Symbol, Touching};
use crate::bank::{Bank, Bound, Case, Datum, Draw, FigureLabels, Problem, Question, Relative};
use crate::policy::Policy;
use crate::scene::{Label, Owner, Quantity, Scene, Span, Tie};
use crate::solve::outcome::{CheckKind, Motion};
use crate::units::Unit;
use std::collections::BTreeMap;

/// Gravity where the bank does not say it.
const GRAVITY: &str = "9.81 m/s^2";
/// Relative tolerance where the bank does not say it.
const RELATIVE: f64 = 0.01;
/// Greatest condition number where the bank does not say it. A rounding to three figures on the way is off by some 0.13 % on
/// average, so that about 10 of them fit into 1 %.
const COND_LIMIT: f64 = 10.0;
/// Greatest input energy of a spring problem, in kinetic energies, where the bank does not say it: with more, the speed is what
/// two large energies leave.
const ENERGY_LIMIT: f64 = 4.0;
/// Significant figures asked for where the bank does not say it.
const FIGURES: u8 = 3;
/// Most data of a problem; with g these are all that condition numbers are taken of.
const MAX_DATA: usize = 63;
/// Margins where the bank does not say them; the other checks have none.
const MARGINS: [(CheckKind, f64); 11] = [
    (CheckKind::Moves, 0.10),
    (CheckKind::NoSlip, 0.05),
    (CheckKind::MustSlip, 0.05),
    (CheckKind::StartsSlipping, 0.05),
    (CheckKind::Closes, 0.05),
    (CheckKind::Reaches, 0.05),
    // A small share of large forces still has its sign.
    (CheckKind::Taut, 0.01),
    (CheckKind::Slack, 0.05),
    (CheckKind::SlipEnds, 0.05),
    (CheckKind::UnderWay, 0.02),
    (CheckKind::StaticLimit, 0.05),
];
/// What holds for all problems of a bank.
struct Common {
    gravity: (Decimal, Unit),
    relative: Relative,
    unit_required: bool,
    /// Only where the bank or the problem says it.
    cond_limit: Option<f64>,
    energy_limit: f64,
    figure: FigureLabels,
}

/// A datum with its own draw.
struct DatumRead<'n> {
    node: &'n Node,
    draw: Option<Draw>,
    /// `draw: none`: it is not there, unless a case draws it.
    absent: bool,
    datum: Datum,
    /// False where the bank's unit is wrong, which is told once.
    unit_known: bool,
    /// True where a draw is given but wrong, which is told once.
    draw_wrong: bool,
}

/// Reads a bank; findings go to `faults`.
pub fn bank(node: &Node, variables: Option<Variables>, faults: &Faults) -> Option<Bank> {
    let mut fields = Fields::open(node, "a bank (bank, title, problems)", faults)?;
    let id = fields.need("bank", "wheels-on-inclines", faults).and_then(|n| id(n, "a bank", faults));
    let title = fields.need("title", "Wheels on inclines", faults).and_then(|n| text(n, "a title", faults));
    let gravity = fields.get("gravity").and_then(|n| gravity(n, faults));
    let on_off = [("on", true), ("off", false)];
    let self_check = fields.get("self check").and_then(|n| choice(n, &on_off, faults)).unwrap_or(true);
    let reveal = fields.get("reveal").and_then(|n| choice(n, &on_off, faults)).unwrap_or(false);
    let (relative, _) = fields.get("tolerance").map_or((None, None), |n| tolerance(n, None, faults));
    let unit_required = fields.get("units").and_then(|n| choice(n, &UNITS, faults)).unwrap_or(false);
    let cond_limit = fields.get("cond limit").and_then(|n| limit(n, COND_LIMITS, faults));
    let energy_limit = fields.get("input energy limit").and_then(|n| limit(n, ENERGY_LIMITS, faults));
    let figure = fields.get("figure").and_then(|n| choice(n, &FIGURE_LABELS, faults));
    let grading = Policy::default();
    let grading =
        fields.get("grading").map_or_else(|| grading.clone(), |n| course::read(n, &grading, faults));
    let problems_node = fields.need("problems", "{pulled-rolling: {...}}", faults);
    fields.close(faults);
    let default_gravity = || measure::decimal_constant(GRAVITY).ok();
    let common = Common {
        gravity: gravity.or_else(default_gravity)?,
        relative: relative.unwrap_or(Relative::Fixed(RELATIVE)),
        unit_required,
        cond_limit,
        energy_limit: energy_limit.unwrap_or(ENERGY_LIMIT),
        figure: figure.unwrap_or(FigureLabels::Values),
    };
    let mut problems = Vec::new();
    if let Some(n) = problems_node {
        let list = named(n, "problems by id", faults);
        if list.is_empty() && matches!(n.value, Value::Map(_)) {
            faults.at(n, "a bank has at least one problem");
        }
        for (name, key, value) in list {
            if !plain_id(name) {
                faults.hint(key, format!("`{}` is no id of a problem", shorten(name)), ID_HINT);
            }
            if let Some(p) = problem(name, value, &common, variables, faults) {
                problems.push(p);
            }
        }
    }
    Some(Bank {
        id: id?,
        title: title?,
        problems,
        self_check,
        reveal,
        grading,
        hash: String::new(),
        places: BTreeMap::new(),
    })
}

const FIGURE_LABELS: [(&str, FigureLabels); 3] =
    [("values", FigureLabels::Values), ("symbols", FigureLabels::Symbols), ("none", FigureLabels::None)];
const UNITS: [(&str, bool); 2] = [("optional", false), ("required", true)];
const ID_HINT: &str = "letters, digits, `-` and `_`, beginning with a letter or digit, at most 64";

fn plain_id(text: &str) -> bool {
    text.len() <= 64
        && text.starts_with(|c: char| c.is_ascii_alphanumeric())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_')
}

fn id(node: &Node, what: &str, faults: &Faults) -> Option<String> {
    match node.text() {
        Some(t) if plain_id(t) => Some(t.to_owned()),
        _ => {
            faults.hint(node, format!("{} is no id of {what}", node.kind()), ID_HINT);
            None
        }
    }
}

fn text(node: &Node, what: &str, faults: &Faults) -> Option<String> {
    match node.text() {
        Some(t) if !t.trim().is_empty() => Some(t.trim().to_owned()),
        _ => {
            faults.at(node, format!("expected {what}, found {}", node.kind()));
            None
        }
    }
}

fn choice<T: Copy>(node: &Node, words: &[(&str, T)], faults: &Faults) -> Option<T> {
    let found = node.text().and_then(|t| words.iter().find(|(w, _)| *w == t.trim()));
    if found.is_none() {
        let known: Vec<String> = words.iter().map(|(w, _)| format!("`{w}`")).collect();
        faults.at(node, format!("expected {}, found {}", known.join(" or "), node.kind()));
    }
    found.map(|(_, t)| *t)
}

fn gravity(node: &Node, faults: &Faults) -> Option<(Decimal, Unit)> {
    let example = "for example `gravity: 9.81 m/s^2`";
    match measure::decimal_constant(node.text().unwrap_or("")) {
        Ok((value, unit)) if measure::fits(&unit, "m/s^2") && value.value > 0 => Some((value, unit)),
        Ok((_, unit)) if !measure::fits(&unit, "m/s^2") => {
            faults.hint(node, format!("{} is no acceleration of free fall", node.kind()), example);
            None
        }
        Ok(_) => {
            faults.hint(node, "the acceleration of free fall is above 0", example);
            None
        }
        Err(message) => {
            faults.hint(node, message, example);
            None
        }
    }
}

/// A share such as `5 %` or `0.05`.
fn share(node: &Node, faults: &Faults) -> Option<f64> {
    let text = node.text().unwrap_or("").trim();
    let (digits, decimals) = match text.strip_suffix('%') {
        Some(rest) => (rest.trim(), 2),
        None => (text, 0),
    };
    let written = Decimal::read(digits);
    let read = written.as_ref().ok().and_then(|d| {
        let decimals = d.decimals.checked_add(decimals)?;
        Decimal { value: d.value, decimals }.text().parse::<f64>().ok()
    });
    if read.is_none() {
        faults.hint(node, expected("a share", node, written), "write `5 %` or `0.05`");
    }
    read
}

/// That something else was expected, or that there are too many digits.
fn expected(what: &str, node: &Node, read: Result<Decimal, String>) -> String {
    match read {
        Err(why) if why.contains("too many digits") => format!("expected {what}: {why}"),
        _ => format!("expected {what}, found {}", node.kind()),
    }
}

/// Limits of condition numbers: what they are, and from where to where.
const COND_LIMITS: (&str, f64, f64) = ("a condition number", 1.0, 1000.0);
/// Limits of input energies.
const ENERGY_LIMITS: (&str, f64, f64) = ("a multiple of the kinetic energy", 1.0, 1000.0);

/// A plain number, greatest value of something.
fn limit(node: &Node, (what, least, most): (&str, f64, f64), faults: &Faults) -> Option<f64> {
    let written = Decimal::read(node.text().unwrap_or("").trim());
    let read = written.as_ref().ok().and_then(|d| d.text().parse::<f64>().ok());
    let fine = read.filter(|x| (least..=most).contains(x));
    if fine.is_none() {
        faults.at(node, expected(&format!("{what} from {least} to {most}"), node, written));
    }
    fine
}

/// `1 %`, `widens with cond`, or `{least: 1 %, per cond: 0.3 %, most: 5 %}`.
fn relative(node: &Node, faults: &Faults) -> Option<Relative> {
    let sound = |n: &Node| {
        let share = share(n, faults)?;
        if share > 0.0 && share < 1.0 {
            return Some(share);
        }
        faults.hint(
            n,
            format!("a relative tolerance of {} makes no sense", n.kind()),
            "above 0 and below 100 %",
        );
        None
    };
    if node.text().is_some_and(|t| t.trim() == "widens with cond") {
        return Some(Relative::WIDENS);
    }
    if !matches!(node.value, Value::Map(_)) {
        if node.text().is_some_and(|t| t.trim_start().starts_with(|c: char| c.is_alphabetic())) {
            faults.hint(
                node,
                format!("expected a relative tolerance, found {}", node.kind()),
                "write `1 %`, `widens with cond` or `{least: 1 %, per cond: 0.3 %, most: 5 %}`",
            );
            return None;
        }
        return sound(node).map(Relative::Fixed);
    }
    let mut fields = Fields::open(node, "a tolerance that widens (least, per cond, most)", faults)?;
    let least = fields.need("least", "1 %", faults).and_then(sound);
    let per_cond = fields.need("per cond", "0.3 %", faults).and_then(sound);
    let most = fields.need("most", "5 %", faults).and_then(sound);
    fields.close(faults);
    let (least, per_cond, most) = (least?, per_cond?, most?);
    if least > most {
        faults.at(node, "the least tolerance is above the most");
        return None;
    }
    Some(Relative::Widens { least, per_cond, most })
}

fn tolerance(node: &Node, unit: Option<&Unit>, faults: &Faults) -> (Option<Relative>, Option<f64>) {
    let Some(mut fields) = Fields::open(node, "a tolerance such as `{relative: 1 %}`", faults) else {
        return (None, None);
    };
    let relative = fields.get("relative").and_then(|n| self::relative(n, faults));
    let absolute = fields.get("absolute").and_then(|n| {
        let Some(unit) = unit else {
            faults.hint(
                n,
                "an absolute tolerance needs a unit, so it belongs to a question",
                "move it there",
            );
            return None;
        };
        match measure::constant(n.text().unwrap_or(""), unit.ascii()) {
            Ok(x) if x >= 0.0 => Some(x),
            Ok(_) => {
                faults.at(n, "a tolerance is not negative");
                None
            }
            Err(message) => {
                faults.hint(n, message, format!("for example `0.5 {}`", unit.ascii()));
                None
            }
        }
    });
    fields.close(faults);
    (relative, absolute)
}

#[expect(clippy::too_many_lines, reason = "one line or two for each field of a problem")]
fn problem(
    name: &str,
    node: &Node,
    common: &Common,
    variables: Option<Variables>,
    faults: &Faults,
) -> Option<Problem> {
    let before = faults.count();
    let mut fields = Fields::open(node, "a problem (title, data, scene, questions)", faults)?;
    let title =
        fields.need("title", "A wheel pulled up an incline", faults).and_then(|n| text(n, "a title", faults));
    let data_node = fields.need("data", "{m: {name: mass, unit: kg, draw: 20 to 40 step 1}}", faults);
    let mut data = data_node.map_or_else(Vec::new, |n| data_of(n, faults));
    let symbols: Vec<Symbol> = data
        .iter()
        .map(|d| Symbol {
            name: d.datum.symbol.clone(),
            unit: d.unit_known.then(|| d.datum.unit.clone()),
            absent: d.absent,
        })
        .collect();
    if let Some(n) = data_node.filter(|_| data.len() > MAX_DATA) {
        faults.at(n, format!("a problem has at most {MAX_DATA} data, this one {}", data.len()));
    }
    let gravity_index = data.len();
    let scene_node = fields.get("scene");
    let read =
        |n: &Node, symbols: &[Symbol], touching| scene::read(n, symbols, touching, gravity_index, faults);
    let base = scene_node.map(|n| read(n, &symbols, Touching::Rolls));
    let regimes = fields.get("regimes").map_or_else(Vec::new, |n| regimes(n, faults));
    let margins = fields.get("margins").map_or_else(Vec::new, |n| margins(n, faults));
    let cond_limit = fields.get("cond limit").and_then(|n| limit(n, COND_LIMITS, faults));
    let energy_limit = fields.get("input energy limit").and_then(|n| limit(n, ENERGY_LIMITS, faults));
    let figure = fields.get("figure").and_then(|n| choice(n, &FIGURE_LABELS, faults));
    let common = &Common {
        gravity: common.gravity.clone(),
        figure: figure.unwrap_or(common.figure),
        cond_limit: cond_limit.or(common.cond_limit),
        energy_limit: energy_limit.unwrap_or(common.energy_limit),
        ..*common
    };
    let bounds_node = fields.get("bounds");
    let cases_node = fields.get("cases");
    let questions_node = fields.need("questions", "{v: {ask: the speed of the wheel, unit: m/s}}", faults);
    let asks_node = fields.get("asks");
    let mistakes_node = fields.get("mistakes");
    let follows_node = fields.get("follows");
    let statement_node = fields.get("statement");
    fields.close(faults);
    let statement = statement_node.and_then(|n| text(n, "the text of the statement", faults));

    // Cases: draws, scenes, regimes.
    let mut cases: Vec<CaseRead> = Vec::new();
    match cases_node {
        None => {
            if scene_node.is_none() {
                faults.hint(node, "`scene` is missing", "say what bodies, ties, start and end there are");
            }
            cases.push(CaseRead {
                name: String::new(),
                written: String::new(),
                node,
                share: 1,
                draws: data.iter().map(|d| d.draw.clone()).collect(),
                wrong: data.iter().map(|d| d.draw_wrong).collect(),
                symbols: symbols.clone(),
                read: base.clone(),
                scene_node,
                regimes: regimes.clone(),
                bounds: None,
            });
        }
        Some(n) => {
            let list = named(n, "cases by name", faults);
            if list.is_empty() && matches!(n.value, Value::Map(_)) {
                faults.hint(n, "there are no cases", "remove this field");
            }
            for (case_name, key, value) in list {
                if case_name.trim().is_empty() || case_name.chars().count() > 64 {
                    faults.at(key, format!("`{}` is no name for a case", shorten(case_name)));
                }
                let Some(mut f) = Fields::open(value, "a case (share, draws, ...)", faults) else { continue };
                let share = f.get("share").map_or(Some(1), |n| whole(n, 1, 1_000_000, faults)).unwrap_or(1);
                let mut draws: Vec<Option<Draw>> = data.iter().map(|d| d.draw.clone()).collect();
                let mut wrong: Vec<bool> = data.iter().map(|d| d.draw_wrong).collect();
                let mut symbols = symbols.clone();
                if let Some(n) = f.get("draws") {
                    for (symbol, key, value) in named(n, "draws by symbol", faults) {
                        match data.iter().position(|d| d.datum.symbol == symbol) {
                            Some(i) => {
                                symbols[i].absent = is_none(value);
                                draws[i] = if symbols[i].absent { None } else { draw(value, faults) };
                                wrong[i] = draws[i].is_none() && !symbols[i].absent;
                            }
                            None => unknown_symbol(key, symbol, &symbols, faults),
                        }
                    }
                }
                let own_node = f.get("scene");
                // With other data there, the scene of the problem is another one, too.
                let same = symbols.iter().zip(&data).all(|(s, d)| s.absent == d.absent);
                let again = scene_node.filter(|_| !same && base.as_ref().is_some_and(|b| b.scene.is_some()));
                let own = own_node.or(again).map(|n| read(n, &symbols, Touching::Rolls));
                let replaced = own.is_some();
                let own_regimes = f.get("regimes").map(|n| self::regimes(n, faults));
                let bounds = f.get("bounds");
                f.close(faults);
                if !replaced && scene_node.is_none() {
                    faults.hint(value, "this case has no scene", "give the problem or the case a `scene`");
                }
                cases.push(CaseRead {
                    name: case_name.trim().to_owned(),
                    written: case_name.to_owned(),
                    node: value,
                    share,
                    draws,
                    wrong,
                    symbols,
                    read: if replaced { own } else { base.clone() },
                    scene_node: own_node.or(scene_node),
                    regimes: own_regimes.unwrap_or_else(|| regimes.clone()),
                    bounds,
                });
            }
        }
    }

    let cases: Vec<CaseRead> = cases.into_iter().flat_map(|case| by_contact(case, &read)).collect();

    // Every datum that a case draws is used by its scene; what the scene uses is drawn; ranges are admissible.
    for case in &cases {
        let Some(read) = &case.read else { continue };
        for (i, d) in data.iter().enumerate() {
            if case.wrong[i] {
                continue;
            }
            let uses: Vec<Need> = read.uses.iter().filter(|u| u.datum == i).map(|u| u.need).collect();
            if read.scene.is_none() && uses.is_empty() {
                // Perhaps it is used where the scene could not be read.
                continue;
            }
            review::datum(&d.datum, d.node, case.draws[i].as_ref(), &uses, &case.name, case.node, faults);
        }
        if let Some(scene) = &read.scene {
            review::structure(scene, case.scene_node.unwrap_or(case.node), faults);
            review::instant(scene, &data_draws(&data, case), case.scene_node.unwrap_or(case.node), faults);
            review::inertia_where_slipping(scene, &data_draws(&data, case), case.node, faults);
        }
    }
    // Slopes go to the scene in degrees, all else in SI.
    let mut degrees = vec![false; data.len()];
    for read in cases.iter().filter_map(|c| c.read.as_ref()) {
        for u in read.uses.iter().filter(|u| u.need.in_degrees()) {
            degrees[u.datum] = true;
        }
    }
    for (d, degrees) in data.iter_mut().zip(degrees) {
        d.datum.degrees = degrees;
    }

    let (value, unit) = common.gravity.clone();
    let g_draw = Draw::Always { value: value.value, decimals: value.decimals };
    let plain: Vec<Datum> = data
        .iter()
        .map(|d| d.datum.clone())
        .chain([Datum {
            symbol: "g".to_owned(),
            tex: "g".to_owned(),
            name: "acceleration of free fall".to_owned(),
            unit,
            degrees: false,
        }])
        .collect();

    // Questions and bounds are read against each scene, since labels hold the index of a body.
    let scenes: Vec<(&str, &Scene)> =
        cases.iter().filter_map(|c| Some((c.name.as_str(), c.read.as_ref()?.scene.as_ref()?))).collect();
    let questions = questions_node.map_or_else(Vec::new, |n| questions(n, common, &scenes, faults));
    let read_cases: Vec<mistake::OfCase> = cases
        .iter()
        .filter_map(|c| {
            let scene = c.read.as_ref()?.scene.as_ref()?;
            let (name, node, touching) = (c.name.as_str(), c.scene_node?, c.touching());
            Some(mistake::OfCase { name, scene, node, symbols: &c.symbols, touching })
        })
        .collect();
    let context = mistake::Context { data: &plain, gravity: gravity_index, cases: &read_cases };
    let mut mistakes = mistakes_node.map_or_else(Vec::new, |n| mistake::mistakes(n, &context, faults));
    let asks = asks_node.map(|n| asks(n, &questions, faults));
    let asked: Vec<Question> = match asks {
        None => questions.into_iter().filter_map(|(_, q)| q).collect(),
        Some(ids) => ids.iter().filter_map(|id| questions.iter().find(|(n, _)| n == id)?.1.clone()).collect(),
    };
    let follows = follows_node.map_or_else(Vec::new, |n| mistake::follows(n, &asked, &context, faults));
    if let Some(variables) = variables {
        let names: Vec<&str> = plain.iter().map(|d| d.symbol.as_str()).collect();
        review::templates(statement_node, questions_node, &names, variables, faults);
    }
    // What is asked says how far the conditions look: the key is the same wherever these questions are answered.
    let span = Span::of(asked.iter().map(|q| q.label.quantity));
    mistakes.iter_mut().flat_map(|m| &mut m.scenes).flatten().for_each(|s| s.span = span);
    let mut ready = Vec::new();
    for case in cases {
        let mut bounds = Vec::new();
        for n in [bounds_node, case.bounds].into_iter().flatten() {
            let scene = case.read.as_ref().and_then(|r| r.scene.as_ref());
            bounds.extend(bounds_of(n, &plain, scene, faults));
        }
        if let Some(Read { scene: Some(mut scene), upright, touches, .. }) = case.read {
            scene.span = span;
            let mut draws = case.draws;
            draws.push(Some(g_draw.clone()));
            ready.push(Case {
                name: case.name,
                written: case.written,
                share: case.share,
                draws,
                scene,
                upright,
                touches,
                regimes: case.regimes,
                bounds,
            });
        }
    }
    let mut all_margins: Vec<(CheckKind, f64)> = MARGINS.to_vec();
    for (kind, share) in margins {
        match all_margins.iter_mut().find(|(k, _)| *k == kind) {
            Some(entry) => entry.1 = share,
            None => all_margins.push((kind, share)),
        }
    }
    let title = title?;
    (faults.count() == before && !ready.is_empty()).then(|| Problem {
        id: name.to_owned(),
        title,
        data: plain,
        cases: ready,
        questions: asked,
        statement,
        figure: common.figure,
        energy_limit: common.energy_limit,
        methods: mistakes.iter().map(|m| m.id.clone()).collect(),
        mistakes,
        follows,
        margins: all_margins,
    })
}

/// A case whose contact does not say whether it rolls or slips is two: one in which it rolls, and one in which it slips, so far
/// as its regimes let it. A draw belongs to that in which what happens is what was assumed.
fn by_contact<'n>(
    case: CaseRead<'n>,
    read: &dyn Fn(&Node, &[Symbol], Touching) -> scene::Read,
) -> Vec<CaseRead<'n>> {
    let touches = case.read.as_ref().is_some_and(|r| r.scene.is_some() && !r.touches.is_empty());
    let Some(node) = case.scene_node.filter(|_| touches) else { return vec![case] };
    let slips = |regime: &&String| regime.starts_with("slips") || regime.starts_with("spins");
    let mut kept = Vec::new();
    for (touching, word) in [(Touching::Rolls, "rolls"), (Touching::Slips, "slips")] {
        let fits = |r: &&String| slips(r) == (touching == Touching::Slips);
        let regimes: Vec<String> = case.regimes.iter().filter(fits).cloned().collect();
        if !regimes.is_empty() || case.regimes.is_empty() {
            kept.push((touching, word, regimes));
        }
    }
    let both = kept.len() > 1;
    let one = |(touching, word, regimes): (Touching, &str, Vec<String>)| {
        let mut one = case.clone();
        one.regimes = regimes;
        if touching == Touching::Slips {
            one.read = Some(read(node, &case.symbols, touching));
        }
        if both {
            one.name = if case.name.is_empty() { word.to_owned() } else { format!("{}, {word}", case.name) };
        }
        one
    };
    kept.into_iter().map(one).collect()
}

/// `none`: the datum is not there.
fn is_none(node: &Node) -> bool {
    node.text().is_some_and(|t| t.trim() == "none")
}

#[derive(Clone)]
struct CaseRead<'n> {
    name: String,
    /// Its name as it is written.
    written: String,
    node: &'n Node,
    share: u32,
    draws: Vec<Option<Draw>>,
    /// Draws that are given but wrong.
    wrong: Vec<bool>,
    /// The symbols, as far as their data are there.
    symbols: Vec<Symbol>,
    /// What was read of its scene, if it has one.
    read: Option<scene::Read>,
    scene_node: Option<&'n Node>,
    regimes: Vec<String>,
    bounds: Option<&'n Node>,
}

impl CaseRead<'_> {
    /// How a contact that does not say it is taken in this case.
    fn touching(&self) -> Touching {
        let read = self.read.as_ref().filter(|r| !r.touches.is_empty());
        let slips = read
            .and_then(|r| r.scene.as_ref())
            .is_some_and(|s| s.ties.iter().any(|t| matches!(t, Tie::Slip { .. })));
        if slips { Touching::Slips } else { Touching::Rolls }
    }
}

fn data_draws(data: &[DatumRead], case: &CaseRead) -> Vec<(String, Option<Draw>)> {
    data.iter().zip(&case.draws).map(|(d, draw)| (d.datum.symbol.clone(), draw.clone())).collect()
}

fn unknown_symbol(key: &Node, symbol: &str, symbols: &[Symbol], faults: &Faults) {
    let names = symbols.iter().map(|s| s.name.as_str());
    let hint = close_name(symbol, names.clone())
        .unwrap_or_else(|| format!("symbols: {}", names.collect::<Vec<_>>().join(", ")));
    faults.hint(key, format!("`{}` is no symbol of the data", shorten(symbol)), hint);
}

fn whole(node: &Node, min: u32, max: u32, faults: &Faults) -> Option<u32> {
    let read = node.text().and_then(|t| t.trim().parse::<u32>().ok()).filter(|n| (min..=max).contains(n));
    if read.is_none() {
        faults.at(node, format!("expected a whole number from {min} to {max}, found {}", node.kind()));
    }
    read
}

fn draw(node: &Node, faults: &Faults) -> Option<Draw> {
    let Some(text) = node.text() else {
        faults.hint(node, format!("expected a draw, found {}", node.kind()), decimal::FORMS);
        return None;
    };
    match decimal::draw(text) {
        Ok(draw) => Some(draw),
        Err((message, hint)) => {
            faults.hint(node, message, hint);
            None
        }
    }
}

fn data_of<'n>(node: &'n Node, faults: &Faults) -> Vec<DatumRead<'n>> {
    let mut list = Vec::new();
    for (symbol, key, value) in named(node, "data by symbol", faults) {
        if !scene::plain_name(symbol) {
            faults.hint(
                key,
                format!("`{}` is no symbol", shorten(symbol)),
                "letters, digits and `_`, beginning with a letter, such as `mu_s`",
            );
        } else if symbol == "g" {
            faults.hint(
                key,
                "`g` is the acceleration of free fall",
                "write `gravity: 9.81 m/s^2` at the top of the bank",
            );
        } else if TEMPLATE_NAMES.contains(&symbol) {
            faults.hint(
                key,
                format!("`{symbol}` has a meaning of its own in statements"),
                "choose another symbol",
            );
        }
        let mut datum = Datum {
            symbol: symbol.to_owned(),
            tex: tex_of(symbol),
            name: String::new(),
            unit: Unit::one(),
            degrees: false,
        };
        let mut own = None;
        let mut absent = false;
        let mut unit_known = false;
        let mut draw_wrong = false;
        if let Some(mut fields) = Fields::open(value, "a datum (name, unit, draw)", faults) {
            if let Some(name) =
                fields.need("name", "mass of the wheel", faults).and_then(|n| text(n, "a name", faults))
            {
                datum.name = name;
            }
            if let Some(n) = fields.need("unit", "kg", faults) {
                match measure::unit(n.text().unwrap_or("")) {
                    Ok(unit) => {
                        datum.unit = unit;
                        unit_known = true;
                    }
                    Err(message) => {
                        faults.hint(n, message, "a unit such as kg, m, deg, N/m; `1` for a pure number")
                    }
                }
            }
            if let Some(tex) = fields.get("tex").and_then(|n| text(n, "a symbol in LaTeX", faults)) {
                datum.tex = tex;
            }
            let given = fields.get("draw");
            absent = given.is_some_and(is_none);
            own = given.filter(|_| !absent).and_then(|n| draw(n, faults));
            draw_wrong = given.is_some() && !absent && own.is_none();
            fields.close(faults);
        }
        list.push(DatumRead { node: value, draw: own, absent, datum, unit_known, draw_wrong });
    }
    list
}

/// LaTeX of a symbol: `theta` is `\theta`, `m_A` is `m_A`, `mu_s` is `\mu_s`, `x0` is `x_0`, `ks` is `k_s`.
pub fn tex_of(symbol: &str) -> String {
    const GREEK: [&str; 22] = [
        "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu",
        "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "Omega",
    ];
    let letter = |word: &str| if GREEK.contains(&word) { format!("\\{word}") } else { word.to_owned() };
    let (base, index) = match symbol.split_once('_') {
        Some((base, index)) => (base.to_owned(), index.replace('_', ",")),
        None => {
            let word = symbol.trim_end_matches(|c: char| c.is_ascii_digit());
            let digits = &symbol[word.len()..];
            let known = GREEK.contains(&word);
            let first = word.chars().next().map_or(0, char::len_utf8);
            if known || word.len() == 1 {
                (word.to_owned(), digits.to_owned())
            } else {
                (word[..first].to_owned(), format!("{}{digits}", &word[first..]))
            }
        }
    };
    let index = letter(&index);
    match index.chars().count() {
        0 => letter(&base),
        1 => format!("{}_{index}", letter(&base)),
        _ => format!("{}_{{{index}}}", letter(&base)),
    }
}

fn regimes(node: &Node, faults: &Faults) -> Vec<String> {
    let items: Vec<&Node> = match &node.value {
        Value::List(items) => items.iter().collect(),
        Value::Text(_) => vec![node],
        _ => {
            faults.at(node, format!("expected a list of regimes, found {}", node.kind()));
            return Vec::new();
        }
    };
    let mut list = Vec::new();
    for item in items {
        let text = item.text().unwrap_or("").trim();
        if Motion::ALL.iter().any(|m| m.is_called(text)) {
            list.push(text.to_owned());
        } else {
            let words: Vec<&str> = Motion::ALL.iter().map(|m| m.word()).collect();
            let hint = close_name(text, words.iter().copied())
                .unwrap_or_else(|| format!("regimes: {}", words.join(", ")));
            faults.hint(item, format!("expected a regime, found {}", item.kind()), hint);
        }
    }
    list
}

fn margins(node: &Node, faults: &Faults) -> Vec<(CheckKind, f64)> {
    let mut list = Vec::new();
    for (name, key, value) in named(node, "margins by check", faults) {
        let Some(kind) = CheckKind::ALL.iter().copied().find(|k| k.name() == name) else {
            let names: Vec<&str> = CheckKind::ALL.iter().map(|k| k.name()).collect();
            let hint = close_name(name, names.iter().copied())
                .unwrap_or_else(|| format!("checks: {}", names.join(", ")));
            faults.hint(key, format!("`{}` is no check", shorten(name)), hint);
            continue;
        };
        match share(value, faults) {
            Some(s) if (0.0..1.0).contains(&s) => list.push((kind, s)),
            Some(_) => faults.hint(
                value,
                format!("a margin of {} cannot hold", value.kind()),
                "from 0 to below 100 %",
            ),
            None => {}
        }
    }
    list
}

fn questions(
    node: &Node,
    common: &Common,
    scenes: &[(&str, &Scene)],
    faults: &Faults,
) -> Vec<(String, Option<Question>)> {
    let list = named(node, "questions by id", faults);
    if list.is_empty() && matches!(node.value, Value::Map(_)) {
        faults.at(node, "a problem has at least one question");
    }
    let mut out = Vec::new();
    for (id, key, value) in list {
        if !scene::plain_name(id) {
            faults.hint(
                key,
                format!("`{}` is no id of a question", shorten(id)),
                "letters, digits and `_`, beginning with a letter",
            );
        }
        out.push((id.to_owned(), question(id, key, value, common, scenes, faults)));
    }
    out
}

fn question(
    id: &str,
    key: &Node,
    node: &Node,
    common: &Common,
    scenes: &[(&str, &Scene)],
    faults: &Faults,
) -> Option<Question> {
    let mut fields = Fields::open(node, "a question (ask, unit)", faults)?;
    let ask = fields.need("ask", "the speed of the wheel", faults).and_then(|n| text(n, "a text", faults));
    let quantity_node = fields.get("quantity");
    let name = match quantity_node {
        Some(n) => text(n, "a quantity", faults)?,
        None => id.to_owned(),
    };
    let unit_node = fields.get("unit");
    let tolerance_node = fields.get("tolerance");
    let cond_node = fields.get("cond limit");
    let unguarded = fields.get("unguarded").map_or_else(Vec::new, |n| unguarded(n, faults));
    let points = fields.get("points").map_or(Some(1.0), |n| points(n, faults));
    let figures = fields
        .get("figures")
        .map_or(Some(FIGURES), |n| whole(n, 1, 12, faults).and_then(|f| u8::try_from(f).ok()));
    let unit_required = fields.get("units").map_or(Some(common.unit_required), |n| choice(n, &UNITS, faults));
    fields.close(faults);
    let place = quantity_node.unwrap_or(key);
    let mut label: Option<Label> = None;
    for (case, scene) in scenes {
        match review::label(scene, &name) {
            Ok(found) if label.is_none_or(|l| l == found) => label = Some(found),
            Ok(_) => {
                faults.hint(
                    place,
                    format!("`{name}` belongs to another body in the case `{case}`"),
                    "list the bodies of all cases in the same order",
                );
                return None;
            }
            Err((message, hint)) => {
                let message = if case.is_empty() { message } else { format!("{message} (case `{case}`)") };
                faults.maybe(place, message, hint);
                return None;
            }
        }
    }
    if scenes.is_empty() {
        match unowned(&name) {
            Ok(found) => label = Some(found),
            Err((message, hint)) => faults.maybe(place, message, hint),
        }
    }
    let label = label?;
    let quantity = label.quantity;
    let unit = if quantity.is_word() {
        if let Some(n) = unit_node {
            faults.hint(n, format!("`{name}` is answered with a word"), "remove the unit");
        }
        if let Some(n) = tolerance_node {
            faults.hint(n, format!("`{name}` is answered with a word"), "remove the tolerance");
        }
        if let Some(n) = cond_node {
            faults.hint(n, format!("`{name}` is answered with a word"), "remove the limit");
        }
        return Some(Question {
            id: id.to_owned(),
            label,
            ask: ask?,
            unit: Unit::one(),
            points: points?,
            relative: common.relative,
            absolute: None,
            unit_required: false,
            figures: figures?,
            cond_limit: f64::INFINITY,
            unguarded,
        });
    } else if let Some(n) = unit_node {
        match measure::unit(n.text().unwrap_or("")) {
            Ok(unit) if measure::fits(&unit, quantity.unit()) => unit,
            Ok(unit) => {
                faults.hint(
                    n,
                    format!("`{name}`: {}", measure::mismatch(&unit, quantity.unit())),
                    format!("for example `unit: {}`", quantity.unit()),
                );
                return None;
            }
            Err(message) => {
                faults.hint(n, message, format!("for example `unit: {}`", quantity.unit()));
                return None;
            }
        }
    } else {
        measure::unit(quantity.unit()).ok()?
    };
    let (relative, absolute) = tolerance_node.map_or((None, None), |n| tolerance(n, Some(&unit), faults));
    let unit_required = unit_required? && !unit.is_number();
    let relative = relative.unwrap_or(common.relative);
    let cond_limit = cond_node.and_then(|n| limit(n, COND_LIMITS, faults)).or(common.cond_limit);
    Some(Question {
        id: id.to_owned(),
        label,
        ask: ask?,
        unit,
        points: points?,
        relative,
        absolute,
        unit_required,
        figures: figures?,
        // A tolerance that widens serves as far as it does.
        cond_limit: cond_limit.or(relative.reach()).unwrap_or(COND_LIMIT),
        unguarded,
    })
}

/// Wrong methods near which an answer may lie, with the reasons.
fn unguarded(node: &Node, faults: &Faults) -> Vec<(String, String)> {
    let mut list = Vec::new();
    for (id, _, value) in named(node, "reasons by wrong method", faults) {
        match value.text().map(str::trim) {
            Some(reason) if !reason.is_empty() => list.push((id.to_owned(), reason.to_owned())),
            _ => faults.hint(value, "expected the reason why no draw is refused for it", "a sentence"),
        }
    }
    list
}

/// The label of a name where the scene could not be read: only the quantity counts.
fn unowned(name: &str) -> Result<Label, (String, Option<String>)> {
    let bare = name.rsplit_once('.').map_or(name, |(_, q)| q);
    match Quantity::from_name(bare) {
        Some(quantity) => Ok(Label { quantity, of: Owner::Scene }),
        None => Err((
            format!("`{}` is no quantity", shorten(name)),
            close_name(bare, Quantity::ALL.iter().map(|q| q.name())),
        )),
    }
}

fn points(node: &Node, faults: &Faults) -> Option<f64> {
    let written = Decimal::read(node.text().unwrap_or("").trim());
    let read = written.as_ref().ok().and_then(|d| d.text().parse::<f64>().ok());
    let fine = read.filter(|p| (0.0..=1000.0).contains(p));
    if fine.is_none() {
        faults.at(node, expected("points from 0 to 1000", node, written));
    }
    fine
}

fn asks(node: &Node, questions: &[(String, Option<Question>)], faults: &Faults) -> Vec<String> {
    let Value::List(items) = &node.value else {
        faults.at(node, format!("expected a list of question ids, found {}", node.kind()));
        return Vec::new();
    };
    if items.is_empty() {
        faults.at(node, "a problem asks at least one question");
    }
    let mut list: Vec<String> = Vec::new();
    for item in items {
        let text = item.text().unwrap_or("").trim();
        if !questions.iter().any(|(id, _)| id == text) {
            let ids = questions.iter().map(|(id, _)| id.as_str());
            let hint = close_name(text, ids.clone())
                .unwrap_or_else(|| format!("questions: {}", ids.collect::<Vec<_>>().join(", ")));
            faults.hint(item, format!("expected the id of a question, found {}", item.kind()), hint);
        } else if list.iter().any(|l| l == text) {
            faults.at(item, format!("`{text}` is asked twice"));
        } else {
            list.push(text.to_owned());
        }
    }
    list
}

fn bounds_of(node: &Node, data: &[Datum], scene: Option<&Scene>, faults: &Faults) -> Vec<Bound> {
    let mut list = Vec::new();
    for (written, key, value) in named(node, "bounds by expression", faults) {
        let lookup = |name: &str| -> Result<(Name, Powers), (String, Option<String>)> {
            if let Some(i) = data.iter().position(|d| d.symbol == name) {
                let factor = if data[i].degrees { std::f64::consts::PI / 180.0 } else { 1.0 };
                return Ok((Name::Datum(i, factor), measure::powers(&data[i].unit)));
            }
            let label = scene.map_or_else(|| unowned(name), |s| review::label(s, name)).map_err(
                |(message, hint)| {
                    let close = close_name(name, data.iter().map(|d| d.symbol.as_str()));
                    (message, close.or(hint))
                },
            )?;
            if label.quantity.is_word() {
                return Err((format!("`{name}` is a word, not a number"), None));
            }
            let unit = measure::unit(label.quantity.unit()).map_err(|m| (m, None))?;
            Ok((Name::Quantity(label), measure::powers(&unit)))
        };
        let expression = match Expression::parse(written, &lookup) {
            Ok(e) => Some(e),
            Err(t) => {
                faults.maybe(
                    key,
                    format!("`{}`, character {}: {}", shorten(written), t.column, t.message),
                    t.hint,
                );
                None
            }
        };
        let Some(mut fields) = Fields::open(value, "`{min: ...}`, `{max: ...}` or both", faults) else {
            continue;
        };
        let (low, high) = (fields.get("min"), fields.get("max"));
        fields.close(faults);
        if low.is_none() && high.is_none() {
            faults.hint(value, "this bound bounds nothing", "give `min`, `max` or both");
        }
        let Some(expression) = expression else { continue };
        let limit = |n: &Node| -> Option<f64> {
            let (number, unit) = match measure::decimal_constant(n.text().unwrap_or("")) {
                Ok(read) => read,
                Err(message) => {
                    faults.at(n, message);
                    return None;
                }
            };
            let found = measure::powers(&unit);
            if found != expression.powers && !(number.value == 0 && unit.is_number()) {
                let wanted = measure::powers_text(expression.powers);
                faults.hint(
                    n,
                    format!(
                        "`{}` has the dimension {wanted}, this limit {}",
                        shorten(written),
                        measure::powers_text(found)
                    ),
                    format!("write the unit of the limit, for example `{} {wanted}`", number.text()),
                );
                return None;
            }
            Some(unit.decimal_to_si(number.value, number.decimals))
        };
        let min = low.and_then(limit);
        let max = high.and_then(limit);
        if let (Some(min), Some(max)) = (min, max)
            && min > max
        {
            faults.at(value, "the least value is above the greatest");
        }
        list.push(Bound { text: written.to_owned(), expression, min, max });
    }
    list
}
