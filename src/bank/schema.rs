//! The file format of a bank: which fields there are and what they mean. All findings are collected.
use crate::bank::asked::AskedContext;
use crate::bank::course;
use crate::bank::decimal::Decimal;
use crate::bank::expression::{Exponents, Expression, Name};
use crate::bank::need::Need;
use crate::bank::node::{
    Faults, Fields, Node, Value, choice, items, named, shorten, some_named, text, whole,
};
use crate::bank::scene::{self, DatumSymbol, SceneRead, Touching};
use crate::bank::{
    Bank, Bound, Case, Datum, Draw, FigureLabels, Problem, Question, Relative, TEMPLATE_NAMES, Variables,
    any, asked, draw, inverse, labels, measure, mistake, soundness,
};
use crate::policy::Policy;
use crate::scene::{AsIf, End, Label, Owner, Quantity, Scene, Span, Term};
use crate::solve::outcome::{CheckKind, Motion};
use crate::units::{Unit, spell};
use std::collections::BTreeMap;

/// Gravity where the bank does not say it.
const GRAVITY: &str = "9.81 m/s^2";
/// Relative tolerance where the bank does not say it.
const RELATIVE: f64 = 0.01;
/// Greatest condition number where the bank does not say it. A rounding to three figures on the way is off by some 0.13 % on
/// average, so that about 10 of them fit into 1 %.
const COND_LIMIT: f64 = 10.0;
/// Greatest input energy of a spring problem, in kinetic energies, where the bank does not say it: with more, the
/// speed comes from a small difference of two large energies.
const ENERGY_LIMIT: f64 = 4.0;
/// Significant figures asked for where the bank does not say it.
const FIGURES: u8 = 3;
/// Most data of a problem; with g these are all that condition numbers are taken of.
const MAX_DATA: usize = 63;
/// Margins where the bank does not say them; the other checks have none.
const MARGINS: [(CheckKind, f64); 14] = [
    (CheckKind::Moves, 0.10),
    (CheckKind::NoSlip, 0.05),
    (CheckKind::MustSlip, 0.05),
    (CheckKind::StartsSlipping, 0.05),
    (CheckKind::Closes, 0.05),
    (CheckKind::Reaches, 0.05),
    // The sign of a tension or a normal force is certain although it is a small share of large forces.
    (CheckKind::Taut, 0.01),
    (CheckKind::Pressed, 0.01),
    (CheckKind::Slack, 0.05),
    (CheckKind::SlipEnds, 0.05),
    (CheckKind::UnderWay, 0.02),
    (CheckKind::StaticLimit, 0.05),
    (CheckKind::Met, 0.05),
    (CheckKind::Next, 0.05),
];
/// What holds for all problems of a bank.
struct BankWide {
    gravity: (Decimal, Unit),
    relative: Relative,
    unit_required: bool,
    /// Only where the bank or the problem says it.
    cond_limit: Option<f64>,
    /// The limit where nothing says it.
    usual_cond: f64,
    energy_limit: f64,
    figure: FigureLabels,
}

impl BankWide {
    /// The same with what a bank or a problem says otherwise.
    fn with(&self, fields: &mut Fields) -> Self {
        let cond_limit = fields.read("cond limit", |n, f| measure::limit(n, COND_LIMITS, f));
        let energy_limit = fields.read("input energy limit", |n, f| measure::limit(n, ENERGY_LIMITS, f));
        let figure = fields.read("figure", |n, f| choice(n, &FIGURE_LABELS, f));
        Self {
            gravity: self.gravity.clone(),
            figure: figure.unwrap_or(self.figure),
            cond_limit: cond_limit.or(self.cond_limit),
            energy_limit: energy_limit.unwrap_or(self.energy_limit),
            ..*self
        }
    }
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
    /// The quantity of which it is the measurement, from which an unknown datum is found.
    measured: Option<&'n Node>,
}

/// Reads a bank; findings go to `faults`.
pub fn bank(node: &Node, variables: Option<Variables>, faults: &Faults) -> Option<Bank> {
    let mut fields = Fields::open(node, "a bank (bank, title, problems)", faults)?;
    let id = fields.need("bank", "wheels-on-inclines").and_then(|n| id(n, "a bank", faults));
    let title = fields.need("title", "Wheels on inclines").and_then(|n| text(n, "a title", faults));
    let gravity = fields.read("gravity", gravity);
    let on_off = [("on", true), ("off", false)];
    let self_check = fields.read("self check", |n, f| choice(n, &on_off, f)).unwrap_or(true);
    let reveal = fields.read("reveal", |n, f| choice(n, &on_off, f)).unwrap_or(false);
    let (relative, _) = fields.get("tolerance").map_or((None, None), |n| tolerance(n, None, faults));
    let unit_required = fields.read("units", |n, f| choice(n, &UNITS, f)).unwrap_or(false);
    let default_gravity = || measure::decimal_constant(GRAVITY).ok();
    let usual = BankWide {
        gravity: gravity.or_else(default_gravity)?,
        relative: relative.unwrap_or(Relative::Fixed(RELATIVE)),
        unit_required,
        cond_limit: None,
        usual_cond: COND_LIMIT,
        energy_limit: ENERGY_LIMIT,
        figure: FigureLabels::Values,
    };
    let common = usual.with(&mut fields);
    let grading =
        fields.get("grading").map_or_else(Policy::default, |n| course::read(n, &Policy::default(), faults));
    let problems_node = fields.need("problems", "{pulled-rolling: {...}}");
    let mut problems = Vec::new();
    if let Some(n) = problems_node {
        for (name, key, value) in some_named(n, "problems by id", "a bank has at least one problem", faults) {
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
        _ => faults.refuse_with(node, format!("{} is no id of {what}", node.kind()), ID_HINT),
    }
}

fn gravity(node: &Node, faults: &Faults) -> Option<(Decimal, Unit)> {
    let example = "for example `gravity: 9.81 m/s^2`";
    match measure::decimal_constant(node.text().unwrap_or("")) {
        Ok((value, unit)) if measure::fits(&unit, "m/s^2") && value.value > 0 => Some((value, unit)),
        Ok((_, unit)) if !measure::fits(&unit, "m/s^2") => {
            faults.refuse_with(node, format!("{} is no acceleration of free fall", node.kind()), example)
        }
        Ok(_) => faults.refuse_with(node, "the acceleration of free fall is above 0", example),
        Err(message) => faults.refuse_with(node, message, example),
    }
}

/// A share such as `5 %` or `0.05`.
fn share(node: &Node, faults: &Faults) -> Option<f64> {
    let read = Decimal::share(node.text().unwrap_or(""));
    if let Err(why) = &read {
        faults.hint(node, measure::expected("a share", node, Some(why)), "write `5 %` or `0.05`");
    }
    read.ok()
}

/// Limits of condition numbers: what they are, and from where to where.
const COND_LIMITS: (&str, f64, f64) = ("a condition number", 1.0, 1000.0);
/// Limits of points.
const POINTS: (&str, f64, f64) = ("points", 0.0, 1000.0);
/// Limits of input energies.
const ENERGY_LIMITS: (&str, f64, f64) = ("a multiple of the kinetic energy", 1.0, 1000.0);

/// `1 %`, `widens with cond`, or `{least: 1 %, per cond: 0.3 %, most: 5 %}`.
fn relative(node: &Node, faults: &Faults) -> Option<Relative> {
    let sound = |n: &Node| {
        let share = share(n, faults)?;
        if share > 0.0 && share < 1.0 {
            return Some(share);
        }
        faults.refuse_with(
            n,
            format!("a relative tolerance of {} makes no sense", n.kind()),
            "above 0 and below 100 %",
        )
    };
    if node.text().is_some_and(|t| t.trim() == "widens with cond") {
        return Some(Relative::WIDENS);
    }
    if !matches!(node.value, Value::Map(_)) {
        if node.text().is_some_and(|t| t.trim_start().starts_with(|c: char| c.is_alphabetic())) {
            let hint = "write `1 %`, `widens with cond` or `{least: 1 %, per cond: 0.3 %, most: 5 %}`";
            return faults.expected(node, "a relative tolerance", hint);
        }
        return sound(node).map(Relative::Fixed);
    }
    let mut fields = Fields::open(node, "a tolerance that widens (least, per cond, most)", faults)?;
    let least = fields.need("least", "1 %").and_then(sound);
    let per_cond = fields.need("per cond", "0.3 %").and_then(sound);
    let most = fields.need("most", "5 %").and_then(sound);
    let (least, per_cond, most) = (least?, per_cond?, most?);
    if least > most {
        return faults.refuse(node, "the least tolerance is above the most");
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
            return faults.refuse_with(
                n,
                "an absolute tolerance needs a unit, so it belongs to a question",
                "move it there",
            );
        };
        match measure::constant(n.text().unwrap_or(""), unit.ascii()) {
            Ok(x) if x >= 0.0 => Some(x),
            Ok(_) => faults.refuse(n, "a tolerance is not negative"),
            Err(message) => faults.refuse_with(n, message, format!("for example `0.5 {}`", unit.ascii())),
        }
    });
    (relative, absolute)
}

fn problem(
    name: &str,
    node: &Node,
    common: &BankWide,
    variables: Option<Variables>,
    faults: &Faults,
) -> Option<Problem> {
    let before = faults.count();
    let mut fields = Fields::open(node, "a problem (title, data, scene, questions)", faults)?;
    let title = fields.need("title", "A wheel pulled up an incline").and_then(|n| text(n, "a title", faults));
    // A problem of constants alone has none.
    let data_node = fields.get("data");
    let data = data_node.map_or_else(Vec::new, |n| data_of(n, faults));
    if let Some(n) = data_node.filter(|_| data.len() > MAX_DATA) {
        faults.at(n, format!("a problem has at most {MAX_DATA} data, this one {}", data.len()));
    }
    let scene_node = fields.get("scene");
    let regimes = fields.read("regimes", |n, f| Some(regimes(n, f))).unwrap_or_default();
    let read = ProblemRead::new(node, data, scene_node, regimes, faults);
    let margins = margins(fields.get("margins"), faults);
    let mut common = common.with(&mut fields);
    let [bounds_node, cases_node] = fields.each(["bounds", "cases"]);
    let questions_node = fields.need("questions", "{v: {ask: the speed of the wheel, unit: m/s}}");
    let [asks_node, mistakes_node, follows_node] = fields.each(["asks", "mistakes", "follows"]);
    let statement_node = fields.get("statement");
    // What is unknown is a finding before they are counted.
    drop(fields);
    let statement = statement_node.and_then(|n| text(n, "the text of the statement", faults));
    let mut cases = read.cases(cases_node);
    // The numbers of a book cannot be drawn anew: `lint` tells how well they determine an answer.
    let constant = |draw: &Draw| matches!(draw, Draw::Always { .. });
    if cases.iter().all(|case| case.draws.iter().flatten().all(constant)) {
        common.usual_cond = COND_LIMITS.2;
    }
    let common = &common;
    let data = read.with_gravity(&cases, common.gravity.1.clone());
    let measured = read.data.iter().enumerate().filter_map(|(i, d)| Some((i, d.measured?)));
    let measured = inverse::only(node, &measured.collect::<Vec<_>>(), &data, faults);
    for case in &mut cases {
        let Some(SceneRead { scene: Some(scene), uses, .. }) = &mut case.read else { continue };
        uses.extend(inverse::put(node, measured, scene, &data, faults));
        for rival in &mut case.rivals {
            // What is wrong with it is told of the scene itself.
            inverse::put(node, measured, rival, &data, &Faults::default());
        }
        if let Some(n) = questions_node {
            uses.extend(asked::put(n, scene, &AskedContext { data: &data, case: &case.name }, faults));
        }
    }
    read.review(&cases);
    for case in &cases {
        if let Some(scene) = case.read.as_ref().and_then(|read| read.scene.as_ref()) {
            soundness::holes(scene, &data, &case.draws, case.scene_node.unwrap_or(node), faults);
        }
    }
    // Questions and bounds are read against each scene, since labels hold the index of a body.
    let scenes: Vec<(&str, &Scene)> =
        cases.iter().filter_map(|c| Some((c.name.as_str(), c.read.as_ref()?.scene.as_ref()?))).collect();
    let questions = questions_node.map_or_else(Vec::new, |n| questions(n, common, &scenes, faults));
    let read_cases: Vec<mistake::CaseContext> = cases.iter().filter_map(CaseRead::context).collect();
    let context = mistake::Context {
        data: &data,
        gravity: data.len() - 1,
        questions: questions_node,
        measured,
        cases: &read_cases,
    };
    let mut mistakes = mistakes_node.map_or_else(Vec::new, |n| mistake::mistakes(n, &context, faults));
    let whole = questions.iter().all(|(_, question)| question.is_some());
    let asked: Vec<Question> = match asks_node.map(|n| asks(n, &questions, faults)) {
        None => questions.into_iter().filter_map(|(_, q)| q).collect(),
        Some(ids) => ids.iter().filter_map(|id| questions.iter().find(|(n, _)| n == id)?.1.clone()).collect(),
    };
    review_any(&cases, &asked, questions_node, bounds_node, &data, faults);
    let follows =
        follows_node.map_or_else(Vec::new, |n| mistake::follows(n, (&asked, whole), &context, faults));
    if let Some(variables) = variables {
        let next = |scene: &Scene| scene.formulas.others.iter().any(|(how, _)| *how == AsIf::Next);
        if statement_node.is_none() && scenes.iter().any(|(_, scene)| next(scene)) {
            let hint = "write `statement:`, which tells both motions";
            faults.hint(node, "a motion follows, and the problem has no statement of its own", hint);
        }
        let names = data.iter().filter(|d| d.unknown.is_none()).map(|d| d.symbol.as_str());
        let names: Vec<&str> = names.collect();
        soundness::templates(statement_node, questions_node, &names, variables, faults);
    }
    let span = span(&asked, &scenes);
    settle(mistakes.iter_mut().flat_map(|m| &mut m.scenes).flatten(), span, &data);
    let finished = |case: CaseRead| case.finished(bounds_node, &data, common.gravity.0, span, faults);
    let cases: Vec<Case> = cases.into_iter().filter_map(finished).collect();
    let title = title?;
    (faults.count() == before && !cases.is_empty()).then(|| Problem {
        id: name.to_owned(),
        title,
        data,
        cases,
        questions: asked,
        statement,
        figure: common.figure,
        energy_limit: common.energy_limit,
        methods: mistakes.iter().map(|m| m.id.clone()).collect(),
        mistakes,
        follows,
        margins,
    })
}

/// Tells scenes how far they are looked at, and which data are in degrees.
fn settle<'s>(scenes: impl Iterator<Item = &'s mut Scene>, span: Span, data: &[Datum]) {
    for scene in scenes {
        scene.look(span);
        scene.formulas.settle(&|i| data.get(i).is_some_and(|d| d.degrees));
    }
}

/// How far conditions of validity are checked: some quantities lie beyond the end of the motion, at the turning point, and where one
/// is asked, up to there.
fn span(asked: &[Question], scenes: &[(&str, &Scene)]) -> Span {
    let in_formulas = |label: Label| {
        let formulas = scenes.iter().filter_map(move |(_, scene)| match label.of {
            Owner::Asked(i) => scene.formulas.asked.get(i),
            _ => None,
        });
        formulas.flat_map(|a| a.formula.names()).filter_map(|term| match term {
            Term::Said(label) | Term::Other(_, label) => Some(label.quantity),
            Term::Given(_) => None,
        })
    };
    Span::of(asked.iter().flat_map(|q| in_formulas(q.label).chain([q.label.quantity])))
}

/// Tells of answers and bounds that depend on a mass or a radius that is `any`.
fn review_any(
    cases: &[CaseRead],
    asked: &[Question],
    questions: Option<&Node>,
    bounds: Option<&Node>,
    data: &[Datum],
    faults: &Faults,
) {
    for case in cases {
        let Some(SceneRead { scene: Some(scene), any, .. }) = &case.read else { continue };
        if any.is_empty() {
            continue;
        }
        let place = |id: &str| questions.and_then(|n| n.field(id));
        let mut told: Vec<(Label, String, &Node)> =
            asked.iter().filter_map(|q| Some((q.label, q.id.clone(), place(&q.id)?))).collect();
        for node in [bounds, case.bounds].into_iter().flatten() {
            // What is wrong with a bound is told where it is read.
            for bound in bounds_of(node, data, Some(scene), &Faults::default()) {
                told.extend(bound.expression.quantities().map(|label| (label, bound.text.clone(), node)));
            }
        }
        any::review(scene, any, &told, faults);
    }
}

/// What the cases of a problem start from.
struct ProblemRead<'n> {
    node: &'n Node,
    data: Vec<DatumRead<'n>>,
    symbols: Vec<DatumSymbol>,
    scene_node: Option<&'n Node>,
    scene: Option<SceneRead>,
    regimes: Vec<String>,
    faults: &'n Faults,
}

impl<'n> ProblemRead<'n> {
    fn new(
        node: &'n Node,
        data: Vec<DatumRead<'n>>,
        scene_node: Option<&'n Node>,
        regimes: Vec<String>,
        faults: &'n Faults,
    ) -> Self {
        let symbol = |d: &DatumRead| DatumSymbol {
            name: d.datum.symbol.clone(),
            unit: d.unit_known.then(|| d.datum.unit.clone()),
            absent: d.absent,
        };
        let symbols = data.iter().map(symbol).collect();
        let mut read = Self { node, data, symbols, scene_node, scene: None, regimes, faults };
        read.scene = scene_node.map(|n| read.read(n, &read.symbols, Touching::default()));
        read
    }

    /// Reads a scene; g comes after the data.
    fn read(&self, node: &Node, symbols: &[DatumSymbol], touching: Touching) -> SceneRead {
        scene::read(node, symbols, touching, self.data.len(), self.faults)
    }

    /// A case that is as the problem says.
    fn case(&self, name: &str, node: &'n Node) -> CaseRead<'n> {
        CaseRead {
            name: name.trim().to_owned(),
            written: name.to_owned(),
            node,
            share: 1,
            draws: self.data.iter().map(|d| d.draw.clone()).collect(),
            wrong: self.data.iter().map(|d| d.draw_wrong).collect(),
            symbols: self.symbols.clone(),
            read: self.scene.clone(),
            scene_node: self.scene_node,
            rivals: Vec::new(),
            regimes: self.regimes.clone(),
            bounds: None,
        }
    }

    /// The cases of the field `cases`, or the one that the problem is.
    fn cases(&self, node: Option<&'n Node>) -> Vec<CaseRead<'n>> {
        let Some(node) = node else {
            if self.scene_node.is_none() {
                let hint = "say what bodies, ties, start and end there are";
                self.faults.hint(self.node, "`scene` is missing", hint);
            }
            return self.by_contact(self.case("", self.node));
        };
        let list = named(node, "cases by name", self.faults);
        if list.is_empty() && matches!(node.value, Value::Map(_)) {
            self.faults.hint(node, "there are no cases", "remove this field");
        }
        let own = list.into_iter().filter_map(|(name, key, value)| self.own_case(name, key, value));
        own.collect::<Vec<_>>().into_iter().flat_map(|case| self.by_contact(case)).collect()
    }

    /// A case with its own share, draws, scene, regimes and bounds.
    fn own_case(&self, name: &str, key: &Node, node: &'n Node) -> Option<CaseRead<'n>> {
        let faults = self.faults;
        if name.trim().is_empty() || name.chars().count() > 64 {
            faults.at(key, format!("`{}` is no name for a case", shorten(name)));
        }
        let mut fields = Fields::open(node, "a case (share, draws, ...)", faults)?;
        let mut case = self.case(name, node);
        fields.set("share", &mut case.share, |n, f| whole(n, 1, 1_000_000, f));
        for (symbol, key, value) in
            fields.get("draws").map_or_else(Vec::new, |n| named(n, "draws by symbol", faults))
        {
            let Some(i) = self.data.iter().position(|d| d.datum.symbol == symbol) else {
                let hint = spell::hint(symbol, "symbols", self.symbols.iter().map(|s| s.name.as_str()));
                faults.hint(key, format!("`{}` is no symbol of the data", shorten(symbol)), hint);
                continue;
            };
            let absent = is_none(value);
            case.symbols[i].absent = absent;
            case.draws[i] = if absent { None } else { draw(value, faults) };
            case.wrong[i] = case.draws[i].is_none() && !absent;
        }
        let own = fields.get("scene");
        // With other data there, the scene of the problem is another one, too.
        let same = case.symbols.iter().zip(&self.data).all(|(s, d)| s.absent == d.absent);
        let sound = self.scene.as_ref().is_some_and(|read| read.scene.is_some());
        if let Some(n) = own.or(self.scene_node.filter(|_| !same && sound)) {
            case.read = Some(self.read(n, &case.symbols, Touching::default()));
        }
        case.scene_node = own.or(self.scene_node);
        fields.set("regimes", &mut case.regimes, |n, f| Some(regimes(n, f)));
        case.bounds = fields.get("bounds");
        if case.scene_node.is_none() {
            faults.hint(node, "this case has no scene", "give the problem or the case a `scene`");
        }
        Some(case)
    }

    /// Every datum that a case draws is used by its scene; what the scene uses is drawn; ranges are admissible.
    fn review(&self, cases: &[CaseRead]) {
        for case in cases {
            let Some(read) = &case.read else { continue };
            let known = |i: &usize| self.data[*i].datum.unknown.is_none();
            for (i, d) in self.data.iter().enumerate().filter(|(i, _)| known(i) && !case.wrong[*i]) {
                let uses: Vec<Need> = read.uses.iter().filter(|u| u.datum == i).map(|u| u.need).collect();
                if read.scene.is_none() && uses.is_empty() {
                    // Perhaps it is used where the scene could not be read.
                    continue;
                }
                let draw = case.draws[i].as_ref();
                soundness::datum(&d.datum, d.node, draw, &uses, &case.name, case.node, self.faults);
            }
            if let Some(scene) = &read.scene {
                let node = case.scene_node.unwrap_or(case.node);
                let symbols = self.data.iter().map(|d| d.datum.symbol.clone());
                let draws: Vec<_> = symbols.zip(case.draws.iter().cloned()).collect();
                soundness::structure(scene, node, self.faults);
                for (_, next) in scene.formulas.others.iter().filter(|(how, _)| *how == AsIf::Next) {
                    soundness::structure(next, node.field("next").unwrap_or(node), self.faults);
                }
                soundness::instant(scene, &draws, node, self.faults);
                soundness::inertia_where_slipping(scene, &draws, case.node, self.faults);
            }
        }
        let instant = |case: &CaseRead| {
            let scene = case.read.as_ref().and_then(|read| read.scene.as_ref());
            let declared = !case.regimes.is_empty() && !case.regimes.iter().any(|r| r == "instant");
            declared && scene.is_some_and(|scene| scene.end == End::AtOnce)
        };
        if let Some(n) = self.node.field("regimes").filter(|_| cases.iter().any(instant)) {
            let hint = "leave `regimes` out, or end the motion after a time";
            self.faults.hint(n, "with `end: at once` nothing moves or stays: it has no such regime", hint);
        }
    }

    /// The data, g last. What some scene takes in degrees goes to it so, all else in SI.
    fn with_gravity(&self, cases: &[CaseRead], unit: Unit) -> Vec<Datum> {
        let mut data: Vec<Datum> = self.data.iter().map(|d| d.datum.clone()).collect();
        for used in cases.iter().filter_map(|c| c.read.as_ref()).flat_map(|read| &read.uses) {
            data[used.datum].degrees |= used.need.in_degrees();
        }
        data.push(Datum {
            symbol: "g".to_owned(),
            tex: "g".to_owned(),
            name: "acceleration of free fall".to_owned(),
            unit,
            degrees: false,
            unknown: None,
        });
        data
    }

    /// A case whose contacts do not say whether they roll or slip is several: each with other contacts that roll and that slip, so far
    /// as its regimes let it. A draw belongs to that in which what happens is what was assumed.
    fn by_contact(&self, case: CaseRead<'n>) -> Vec<CaseRead<'n>> {
        let read = case.read.as_ref().filter(|r| !r.touches.is_empty());
        let scene = read.and_then(|r| Some((r, r.scene.as_ref()?)));
        let (Some((read, scene)), Some(node)) = (scene, case.scene_node) else { return vec![case] };
        let slips = |regime: &str| regime.starts_with("slips") || regime.starts_with("spins");
        let mut kept = Vec::new();
        for touching in Touching::all(read.touches.len()) {
            let contacts = || read.touches.iter().enumerate();
            let slipping = || contacts().filter(|(i, _)| touching.slips(*i));
            let (none, all) = (slipping().count() == 0, slipping().count() == read.touches.len());
            let word = match (none, all) {
                (true, _) => "rolls".to_owned(),
                (_, true) => "slips".to_owned(),
                _ => {
                    let bodies = slipping().filter_map(|(_, (tie, _))| scene.ties[*tie].actions().next());
                    let names: Vec<&str> = bodies.map(|a| scene.bodies[a.body].name.as_str()).collect();
                    format!("{} slips", names.join(" and "))
                }
            };
            // Of several contacts the body that the regime tells of may roll or slip.
            let fits = |r: &&String| !none && !all || slips(r) == all;
            let regimes: Vec<String> = case.regimes.iter().filter(|r| fits(r)).cloned().collect();
            if !regimes.is_empty() || case.regimes.is_empty() {
                kept.push((touching, word, regimes));
            }
        }
        let several = kept.len() > 1;
        // Each way is read once: as a case, where it is kept, and as a rival of the others.
        let readings = Touching::all(read.touches.len()).map(|touching| {
            let kept = kept.iter().any(|(t, ..)| *t == touching);
            let reading = match (touching == Touching::default(), kept) {
                (true, _) => read.clone(),
                (_, true) => self.read(node, &case.symbols, touching),
                _ => scene::read(node, &case.symbols, touching, self.data.len(), &Faults::default()),
            };
            (touching, reading)
        });
        let readings: Vec<(Touching, SceneRead)> = readings.collect();
        let one = |(touching, word, regimes): (Touching, String, Vec<String>)| {
            let mut one = case.clone();
            one.regimes = regimes;
            let others = readings.iter().filter(|(t, _)| *t != touching);
            one.rivals = others.filter_map(|(_, reading)| reading.scene.clone()).collect();
            one.read = readings.iter().find(|(t, _)| *t == touching).map(|(_, reading)| reading.clone());
            if several {
                one.name = if case.name.is_empty() { word } else { format!("{}, {word}", case.name) };
            }
            one
        };
        kept.into_iter().map(one).collect()
    }
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
    symbols: Vec<DatumSymbol>,
    /// What was read of its scene, if it has one.
    read: Option<SceneRead>,
    scene_node: Option<&'n Node>,
    /// Its scene with other contacts rolling and slipping.
    rivals: Vec<Scene>,
    regimes: Vec<String>,
    bounds: Option<&'n Node>,
}

impl CaseRead<'_> {
    /// How contacts that do not say it are taken in this case.
    fn touching(&self) -> Touching {
        let read = self.read.as_ref().and_then(|r| Some(Touching::of(&r.touches, r.scene.as_ref()?)));
        read.unwrap_or_default()
    }

    /// What readers of wrong methods know of it; `None` where its scene could not be read.
    fn context(&self) -> Option<mistake::CaseContext<'_>> {
        let scene = self.read.as_ref()?.scene.as_ref()?;
        let (name, node, touching) = (self.name.as_str(), self.scene_node?, self.touching());
        Some(mistake::CaseContext { name, scene, node, symbols: &self.symbols, touching })
    }

    /// The case, with the bounds of the problem and its own; `None` where its scene could not be read.
    fn finished(
        self,
        bounds: Option<&Node>,
        data: &[Datum],
        gravity: Decimal,
        span: Span,
        faults: &Faults,
    ) -> Option<Case> {
        let scene = self.read.as_ref().and_then(|r| r.scene.as_ref());
        let bounds = [bounds, self.bounds].into_iter().flatten();
        let bounds = bounds.flat_map(|n| bounds_of(n, data, scene, faults)).collect();
        let SceneRead { scene, touches, .. } = self.read?;
        let gravity = Draw::Always { value: gravity.value, decimals: gravity.decimals };
        let (mut scene, mut rivals) = (scene?, self.rivals);
        settle(rivals.iter_mut().chain([&mut scene]), span, data);
        Some(Case {
            name: self.name,
            written: self.written,
            share: self.share,
            draws: self.draws.into_iter().chain([Some(gravity)]).collect(),
            scene,
            touches,
            rivals,
            regimes: self.regimes,
            bounds,
        })
    }
}

fn draw(node: &Node, faults: &Faults) -> Option<Draw> {
    let Some(text) = node.text() else { return faults.expected(node, "a draw", draw::FORMS) };
    draw::parse(text).or_else(|(message, hint)| faults.refuse_with(node, message, hint).ok_or(())).ok()
}

fn data_of<'n>(node: &'n Node, faults: &'n Faults) -> Vec<DatumRead<'n>> {
    let mut list = Vec::new();
    for (symbol, key, value) in named(node, "data by symbol", faults) {
        if !scene::plain_name(symbol) {
            let hint = "letters, digits and `_`, beginning with a letter, such as `mu_s`";
            faults.hint(key, format!("`{}` is no symbol", shorten(symbol)), hint);
        } else if symbol == "g" {
            let hint = "write `gravity: 9.81 m/s^2` at the top of the bank";
            faults.hint(key, "`g` is the acceleration of free fall", hint);
        } else if TEMPLATE_NAMES.contains(&symbol) {
            let message = format!("`{symbol}` has a meaning of its own in statements");
            faults.hint(key, message, "choose another symbol");
        }
        let mut datum = Datum {
            symbol: symbol.to_owned(),
            tex: tex_of(symbol),
            name: String::new(),
            unit: Unit::one(),
            degrees: false,
            unknown: None,
        };
        let (mut own, mut measured) = (None, None);
        let (mut absent, mut unit_known, mut draw_wrong) = (false, false, false);
        if let Some(mut fields) = Fields::open(value, "a datum (name, unit, draw)", faults) {
            let name = fields.need("name", "mass of the wheel").and_then(|n| text(n, "a name", faults));
            datum.name = name.unwrap_or_default();
            if let Some(n) = fields.need("unit", "kg") {
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
            fields.set("tex", &mut datum.tex, |n, f| text(n, "a symbol in LaTeX", f));
            let given = fields.get("draw");
            absent = given.is_some_and(is_none);
            own = given.filter(|_| !absent).and_then(|n| draw(n, faults));
            if let Some(n) = fields.get("unknown") {
                let range = draw(n, faults);
                draw_wrong = range.is_none();
                // What is to be found is known to be so, whatever its range was meant to be.
                datum.unknown = range.or(Some(Draw::Grid { min: 1, max: 3, step: 1, decimals: 0 }));
                // On the sheet of a student it is not there.
                let drawn = given.filter(|_| !std::mem::take(&mut absent));
                if let Some(given) = drawn {
                    faults.hint(given, "what is to be found is not drawn", "keep `unknown:` or `draw:`");
                }
            }
            measured = fields.get("measured");
            draw_wrong |= given.is_some() && !absent && own.is_none();
        }
        list.push(DatumRead { node: value, draw: own, absent, datum, unit_known, draw_wrong, measured });
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
    let items = match &node.value {
        Value::Text(_) => std::slice::from_ref(node),
        _ => items(node, "a list of regimes", faults).unwrap_or_default(),
    };
    let mut list = Vec::new();
    for item in items {
        let text = item.text().unwrap_or("").trim();
        if Motion::ALL.iter().any(|m| m.is_called(text)) {
            list.push(text.to_owned());
        } else {
            let hint = spell::hint(text, "regimes", Motion::ALL.iter().map(|m| m.word()));
            faults.hint(item, format!("expected a regime, found {}", item.kind()), hint);
        }
    }
    list
}

/// The margins of the checks: those that are usual, with the ones that are written over them.
fn margins(node: Option<&Node>, faults: &Faults) -> Vec<(CheckKind, f64)> {
    let mut list = MARGINS.to_vec();
    for (name, key, value) in node.map_or_else(Vec::new, |n| named(n, "margins by check", faults)) {
        let Some(kind) = CheckKind::ALL.iter().copied().find(|k| k.name() == name) else {
            let hint = spell::hint(name, "checks", CheckKind::ALL.iter().map(|k| k.name()));
            faults.hint(key, format!("`{}` is no check", shorten(name)), hint);
            continue;
        };
        match share(value, faults) {
            Some(s) if (0.0..1.0).contains(&s) => {
                list.retain(|(k, _)| *k != kind);
                list.push((kind, s));
            }
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
    common: &BankWide,
    scenes: &[(&str, &Scene)],
    faults: &Faults,
) -> Vec<(String, Option<Question>)> {
    let mut out = Vec::new();
    for (id, key, value) in some_named(node, "questions by id", "a problem has at least one question", faults)
    {
        if !scene::plain_name(id) {
            let hint = match id.split_once('.') {
                Some((of, quantity)) if scene::plain_name(of) && scene::plain_name(quantity) => {
                    format!("write `{of}_{quantity}: {{quantity: {id}, ...}}`")
                }
                _ => "letters, digits and `_`, beginning with a letter".to_owned(),
            };
            faults.hint(key, format!("`{}` is no id of a question", shorten(id)), hint);
        }
        out.push((id.to_owned(), question(id, key, value, common, scenes, faults)));
    }
    out
}

fn question(
    id: &str,
    key: &Node,
    node: &Node,
    common: &BankWide,
    scenes: &[(&str, &Scene)],
    faults: &Faults,
) -> Option<Question> {
    let mut fields = Fields::open(node, "a question (ask, unit)", faults)?;
    let ask = fields.need("ask", "the speed of the wheel").and_then(|n| text(n, "a text", faults));
    let quantity_node = fields.get("quantity");
    fields.each(["value", "if", "motion"]);
    let [unit_node, tolerance_node, cond_node] = fields.each(["unit", "tolerance", "cond limit"]);
    let unguarded = fields.get("unguarded").map_or_else(Vec::new, |n| unguarded(n, faults));
    let points = fields.get("points").map_or(Some(1.0), |n| measure::limit(n, POINTS, faults));
    let figures = fields
        .get("figures")
        .map_or(Some(FIGURES), |n| whole(n, 1, 12, faults).and_then(|f| u8::try_from(f).ok()));
    let unit_required = fields.get("units").map_or(Some(common.unit_required), |n| choice(n, &UNITS, faults));
    let name = match quantity_node {
        Some(n) => text(n, "a quantity", faults)?,
        None => id.to_owned(),
    };
    let label = match asked::is_formula(node) {
        // What is wrong with it is told where it is put into the scenes.
        true => scenes.iter().find_map(|(_, scene)| asked::label(scene, id))?,
        false => asked_label(&name, quantity_node.unwrap_or(key), scenes, faults)?,
    };
    let is_word = label.quantity.is_word();
    if is_word {
        let fields = [(unit_node, "unit"), (tolerance_node, "tolerance"), (cond_node, "limit")];
        for (node, field) in fields.into_iter().filter_map(|(node, field)| Some((node?, field))) {
            let hint = format!("remove the {field}");
            faults.hint(node, format!("`{name}` is answered with a word"), hint);
        }
    }
    // What a word does not have is told above, and not read.
    let [unit_node, tolerance_node, cond_node] =
        [unit_node, tolerance_node, cond_node].map(|node| node.filter(|_| !is_word));
    let unit = if is_word { Unit::one() } else { asked_unit(&name, unit_node, label.quantity, faults)? };
    let (relative, absolute) = tolerance_node.map_or((None, None), |n| tolerance(n, Some(&unit), faults));
    let relative = relative.unwrap_or(common.relative);
    let cond_limit = cond_node.and_then(|n| measure::limit(n, COND_LIMITS, faults)).or(common.cond_limit);
    // A tolerance that widens serves as far as it does.
    let cond_limit = cond_limit.or(relative.reach()).unwrap_or(common.usual_cond);
    Some(Question {
        id: id.to_owned(),
        label,
        ask: ask?,
        points: points?,
        relative,
        absolute,
        unit_required: !is_word && unit_required? && !unit.is_number(),
        unit,
        figures: figures?,
        cond_limit: if is_word { f64::INFINITY } else { cond_limit },
        unguarded,
    })
}

/// The quantity of a question; it is that of the same body in every case.
fn asked_label(name: &str, place: &Node, scenes: &[(&str, &Scene)], faults: &Faults) -> Option<Label> {
    if scenes.is_empty() {
        let found = unowned(name);
        return found.map_err(|(message, hint)| faults.maybe(place, message, hint)).ok();
    }
    let mut label: Option<Label> = None;
    for (case, scene) in scenes {
        match labels::named(scene, name) {
            Ok(found) if label.is_none_or(|l| l == found) => label = Some(found),
            Ok(_) => {
                return faults.refuse_with(
                    place,
                    format!("`{name}` belongs to another body in the case `{case}`"),
                    "list the bodies of all cases in the same order",
                );
            }
            Err((message, hint)) => {
                let message = if case.is_empty() { message } else { format!("{message} (case `{case}`)") };
                faults.maybe(place, message, hint);
                return None;
            }
        }
    }
    label
}

/// The unit in which a number is asked: the one that is written, else that of the quantity.
fn asked_unit(name: &str, node: Option<&Node>, quantity: Quantity, faults: &Faults) -> Option<Unit> {
    let Some(node) = node else { return measure::unit(quantity.unit()).ok() };
    let message = match measure::unit(node.text().unwrap_or("")) {
        // That of an expression is checked where it is read.
        Ok(unit) if quantity == Quantity::Value => return Some(unit),
        Ok(unit) if measure::fits(&unit, quantity.unit()) => return Some(unit),
        Ok(unit) => format!("`{name}`: {}", measure::mismatch(&unit, quantity.unit())),
        Err(message) => message,
    };
    faults.refuse_with(node, message, format!("for example `unit: {}`", quantity.unit()))
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
            spell::did_you_mean(bare, Quantity::ALL.iter().map(|q| q.name())),
        )),
    }
}

fn asks(node: &Node, questions: &[(String, Option<Question>)], faults: &Faults) -> Vec<String> {
    let Some(items) = items(node, "a list of question ids", faults) else { return Vec::new() };
    if items.is_empty() {
        faults.at(node, "a problem asks at least one question");
    }
    let mut list: Vec<String> = Vec::new();
    for item in items {
        let text = item.text().unwrap_or("").trim();
        if !questions.iter().any(|(id, _)| id == text) {
            let hint = spell::hint(text, "questions", questions.iter().map(|(id, _)| id.as_str()));
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
        let lookup = |name: &str| -> Result<(Name, Exponents), (String, Option<String>)> {
            if let Some(found) = measure::datum(data, name) {
                return Ok(found);
            }
            let label = scene.map_or_else(|| unowned(name), |s| labels::named(s, name)).map_err(
                |(message, hint)| {
                    let close = spell::did_you_mean(name, data.iter().map(|d| d.symbol.as_str()));
                    (message, close.or(hint))
                },
            )?;
            match scene {
                Some(scene) => measure::quantity(scene, label, name),
                None => measure::own_quantity(label, name),
            }
        };
        let expression = Expression::parse(written, &lookup);
        let expression = expression.map_err(|fault| fault.tell(key, written, faults)).ok();
        let Some(mut fields) = Fields::open(value, "`{min: ...}`, `{max: ...}` or both", faults) else {
            continue;
        };
        let (low, high) = (fields.get("min"), fields.get("max"));
        if low.is_none() && high.is_none() {
            faults.hint(value, "this bound bounds nothing", "give `min`, `max` or both");
        }
        let Some(expression) = expression else { continue };
        let limit = |n: &Node| -> Option<f64> {
            let (number, unit) = match measure::decimal_constant(n.text().unwrap_or("")) {
                Ok(read) => read,
                Err(message) => return faults.refuse(n, message),
            };
            let found = measure::powers(&unit);
            if found != expression.powers && !(number.value == 0 && unit.is_number()) {
                let wanted = measure::powers_text(expression.powers);
                return faults.refuse_with(
                    n,
                    format!(
                        "`{}` has the dimension {wanted}, this limit {}",
                        shorten(written),
                        measure::powers_text(found)
                    ),
                    format!("write the unit of the limit, for example `{} {wanted}`", number.text()),
                );
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
