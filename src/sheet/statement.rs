//! The question in words: one problem's Markdown statement for one drawn variant.
//!
//! What a statement template sees, all of it finished text:
//! - `m`, `theta`, ...: each datum of the problem, and `g`, whole: `$m = 40\ \mathrm{kg}$`;
//! - `value.m`: without the symbol, `$40\ \mathrm{kg}$`; `tex.m`: the symbol alone, `m`, without dollars;
//! - `title`, `number` (in the sheet), `case` (its name);
//! - for particles: `count` (`Four`), `particles` (a list of `name`, `mass`, `x`, `y`), `motion` (`particle`, `vx`, `vy`, `spin`);
//! - `questions`: a list of `number`, `id`, `ask`, `form`, `unit`, `figures`, `points` (empty for one point), `answer` (room
//!   for it on paper).
//!
//! `ask` of a question is a template too and sees the same, but for `questions`.
use crate::bank::decimal::Decimal;
use crate::bank::{Bank, Datum, Problem, Question, expression};
use crate::figure::names;
use crate::finding::{Finding, Findings};
use crate::num::formula::Step;
use crate::num::{elliptic, shown};
use crate::problem::make_key;
use crate::problem::maker::Variant;
use crate::scene::{End, JointKind, Label, Num, Owner, Quantity, Ray, Scene, Span, Start, Term};
use crate::sheet::document;
use crate::template::{self, Templates, View};
use crate::words::Words;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// What all problems of one sheet have in common, so that it is said once.
#[derive(Debug, Clone, PartialEq)]
pub struct Common {
    /// Significant figures asked for by most questions.
    pub figures: u8,
    /// Relative tolerance of most of the questions that have a fixed one.
    pub relative: f64,
    /// Does every number need a unit?
    pub unit_required: bool,
}

impl Common {
    /// What most of the questions say, the first of equals.
    pub fn of<'q>(questions: impl Iterator<Item = &'q Question> + Clone) -> Self {
        let numbers = questions.filter(|q| !q.label.quantity.is_word());
        let mut best = (0, Self { figures: 3, relative: 0.01, unit_required: false });
        for q in numbers.clone() {
            let Some(relative) = q.relative.fixed() else { continue };
            let this = Self { figures: q.figures, relative, unit_required: q.unit_required };
            let count = numbers.clone().filter(|o| this.holds(o)).count();
            if count > best.0 {
                best = (count, this);
            }
        }
        best.1
    }
    /// Has this question a tolerance of its own?
    pub fn differs(&self, q: &Question) -> bool {
        !q.label.quantity.is_word()
            && q.relative.fixed().is_none_or(|share| (share - self.relative).abs() > f64::EPSILON)
    }
    fn holds(&self, q: &Question) -> bool {
        q.figures == self.figures && !self.differs(q) && q.unit_required == self.unit_required
    }
}

/// One problem of a set, ready to be written many times.
pub struct Statement<'b> {
    problem: &'b Problem,
    templates: &'b Templates,
    words: &'b Words,
    name: String,
    values: bool,
    series: bool,
    /// Does the statement itself go through the questions?
    listed: bool,
    common: Common,
    /// Text before and after the digits of each datum.
    around: Vec<(String, String)>,
    /// What does not change between variants, for each case.
    cases: Vec<CaseView>,
    /// Questions that are templates, and their names.
    asks: Vec<(usize, String)>,
    /// Do the questions of a case differ in nothing but the tolerances?
    alike: bool,
}

struct CaseView {
    base: View,
    particles: bool,
}

/// Room for writing, reused from one variant to the next; one for each thread and problem.
#[derive(Default)]
pub struct Scratch {
    /// For each case what its template sees.
    views: Vec<Option<View>>,
    /// Questions that were written before, by case and tolerances: all that their text hangs on.
    questions: BTreeMap<(usize, Vec<u64>), Vec<u8>>,
    text: String,
}

/// So many questions are kept at most.
const KEPT: usize = 512;

/// Name of the template of a problem: the bank's own, or the file named after the problem.
pub fn template_name(problem: &Problem) -> String {
    match problem.statement {
        Some(_) => format!("problems.{}.statement", problem.id),
        None => format!("statement/{}.md", problem.id),
    }
}

/// Adds to `templates` what stands in the bank itself. Errors: templates that cannot be read, and problems that have none.
pub fn add_own(templates: &mut Templates, bank: &Bank) -> Result<(), Findings> {
    let mut faults = Findings::default();
    for problem in &bank.problems {
        let name = template_name(problem);
        if problem.statement.is_none() && !templates.has_markdown(&name) {
            let hint = format!(
                "write `statement: |` into the problem, or put {name} into a folder and give --templates FOLDER"
            );
            faults.push(Finding::new(format!("problems.{}", problem.id), "has no statement").hint(hint));
        }
        let statement = problem.statement.as_ref().map(|text| (name, text));
        let asks = problem.questions.iter().filter(|q| is_template(&q.ask));
        for (field, text) in statement.into_iter().chain(asks.map(|q| (ask_name(problem, q), &q.ask))) {
            let added = templates.add_markdown(&field, text, bank.places.get(&field).cloned());
            added.unwrap_or_else(|fault| faults.push(fault));
        }
    }
    faults.into_result(())
}

fn ask_name(problem: &Problem, q: &Question) -> String {
    format!("problems.{}.questions.{}.ask", problem.id, q.id)
}

fn is_template(text: &str) -> bool {
    text.contains("{{") || text.contains("{%") || text.contains("{#")
}

impl<'b> Statement<'b> {
    /// Prepares a problem that has this number in its sheet. Errors: faults of the templates.
    pub fn new(
        templates: &'b Templates,
        words: &'b Words,
        problem: &'b Problem,
        number: usize,
        common: &Common,
    ) -> Result<Self, Finding> {
        let name = template_name(problem);
        let mut used = templates.variables(&name)?;
        let asks = problem.questions.iter().enumerate().filter(|(_, q)| is_template(&q.ask));
        let asks: Vec<(usize, String)> = asks.map(|(i, q)| (i, ask_name(problem, q))).collect();
        for (_, ask) in &asks {
            used.extend(templates.variables(ask)?);
        }
        let uses = |name: &str| used.iter().any(|v| v == name);
        let (values, series, listed) = (uses("value"), uses("series"), uses("questions"));
        let around = |d: &Datum| {
            let whole = d.unit.tex_with("\u{0}");
            let (before, after) = whole.split_once('\u{0}').unwrap_or(("", ""));
            (format!("${} = {before}", d.tex), format!("{after}$"))
        };
        let around = problem.data.iter().map(around).collect();
        let mut cases = Vec::with_capacity(problem.cases.len());
        for case in &problem.cases {
            let mut base = View::new();
            base.text("title", &problem.title);
            base.text("number", &number.to_string());
            base.text("case", &case.name);
            let tex = problem.data.iter().map(|d| (d.symbol.as_str(), template::finished(&d.tex)));
            base.value("tex", template::map(tex));
            let particles = case.scene.bodies.iter().any(|b| !b.particles.is_empty());
            cases.push(CaseView { base, particles });
        }
        // Questions that name no datum are the same in all variants of a case that have the same tolerances.
        let alike = asks.is_empty() && templates.variables("questions.md")?.iter().all(|v| v == "questions");
        let common = common.clone();
        Ok(Self {
            problem,
            templates,
            words,
            name,
            values,
            series,
            listed,
            common,
            around,
            cases,
            asks,
            alike,
        })
    }

    /// Appends the statement of a variant, with its figure (a line of Markdown) and its questions. Errors: faults of the templates.
    pub fn write(
        &self,
        variant: &Variant,
        number: usize,
        figure: Option<&str>,
        scratch: &mut Scratch,
        out: &mut Vec<u8>,
    ) -> Result<(), Finding> {
        let (case, drawn) = (variant.case, variant.values.as_slice());
        let Some(of_case) = self.cases.get(case) else {
            return Err(Finding::new(&self.problem.id, format!("has no case {case}")));
        };
        let Scratch { views, questions, text } = scratch;
        views.resize_with(self.cases.len().max(views.len()), || None);
        let view = views[case].get_or_insert_with(|| of_case.base.clone());
        for (i, datum) in self.problem.data.iter().enumerate() {
            if let Some(Decimal { value, decimals }) = drawn.get(i).copied().flatten() {
                let (before, after) = &self.around[i];
                text.clear();
                text.push_str(before);
                let digits = text.len();
                Decimal { value, decimals }.push(text);
                if self.words.decimal() != '.' {
                    let number = self.words.tex_number(&text[digits..]);
                    text.truncate(digits);
                    text.push_str(&number);
                }
                text.push_str(after);
                view.text(datum.symbol.as_str(), text);
            }
        }
        if self.values {
            let given = self.problem.data.iter().enumerate();
            let given = given.filter(|(i, _)| drawn.get(*i).is_some_and(Option::is_some));
            let text = |i| template::finished(&self.value_tex(i, drawn));
            view.value("value", template::map(given.map(|(i, datum)| (datum.symbol.as_str(), text(i)))));
        }
        if of_case.particles {
            self.particles(&self.problem.cases[case].scene, drawn, view);
        }
        if self.series {
            view.text("series", &self.series(variant));
        }
        if self.listed {
            let list = self.list(variant, number, view)?;
            view.value("questions", list);
        }
        self.templates.render(&self.name, view, out)?;
        out.truncate(out.trim_ascii_end().len());
        out.extend_from_slice(b"\n\n");
        if let Some(line) = figure {
            out.extend_from_slice(line.as_bytes());
            out.extend_from_slice(b"\n\n");
        }
        if self.alike {
            // Only the tolerances tell one text from another.
            let key = (case, variant.within.iter().map(|share| share.to_bits()).collect());
            if questions.len() >= KEPT {
                questions.clear();
            }
            let text = match questions.entry(key) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(free) => {
                    let mut text = Vec::new();
                    self.questions(variant, number, view, &mut text)?;
                    free.insert(text)
                }
            };
            out.extend_from_slice(text);
        } else {
            self.questions(variant, number, view, out)?;
        }
        out.truncate(out.trim_ascii_end().len());
        out.push(b'\n');
        Ok(())
    }

    /// Appends the questions of a variant.
    fn questions(
        &self,
        variant: &Variant,
        number: usize,
        view: &mut View,
        out: &mut Vec<u8>,
    ) -> Result<(), Finding> {
        let list = self.list(variant, number, view)?;
        view.value("questions", list);
        self.templates.render("questions.md", view, out)
    }

    /// The questions of a variant, as templates see them.
    fn list(&self, variant: &Variant, number: usize, view: &View) -> Result<template::Value, Finding> {
        let mut texts: Vec<String> = self.problem.questions.iter().map(|q| q.ask.clone()).collect();
        for (i, ask) in &self.asks {
            let mut text = Vec::new();
            self.templates.render(ask, view, &mut text)?;
            texts[*i] = String::from_utf8_lossy(&text).trim().to_owned();
        }
        let (words, scene) = (self.words, &self.problem.cases[variant.case].scene);
        let rows =
            self.problem.questions.iter().zip(&variant.within).zip(&texts).map(|((q, within), ask)| {
                let many = (q.points - 1.0).abs() > f64::EPSILON;
                let points = || words.say("sheet.points", &[("n", &words.number(&q.points.to_string()))]);
                template::texts([
                    ("number", number.to_string().as_str()),
                    ("id", &q.id),
                    ("ask", ask),
                    ("form", &form(words, self.problem, q, scene, &self.common, *within)),
                    ("unit", q.unit.ascii()),
                    ("figures", &q.figures.to_string()),
                    ("points", &many.then(points).unwrap_or_default()),
                    ("answer", document::ANSWER),
                ])
            });
        Ok(template::list(rows))
    }

    /// The series of the period and how many of its terms this swing takes to be within the tolerance, for a student who sums it.
    fn series(&self, variant: &Variant) -> String {
        const MOST: usize = 40;
        let of = |quantity: Quantity| variant.solved.entries.iter().find(|e| e.label.quantity == quantity);
        let asked = self.problem.questions.iter().position(|q| q.label.quantity == Quantity::Period);
        let share = asked.and_then(|q| {
            let (question, entry) = (&self.problem.questions[q], of(Quantity::Period)?);
            let width = make_key::half_width(question, entry.value(), entry.scale, entry.cond);
            Some(width / entry.value())
        });
        // A pendulum of the frequency w that swings up to A passes below with 2 w sin(A/2).
        let modulus = of(Quantity::OmegaMax).zip(of(Quantity::OmegaSmall));
        let modulus = modulus.map(|(most, small)| most.value() / (2.0 * small.value()));
        let terms = share.zip(modulus).and_then(|(share, k)| elliptic::terms_within(k, share, MOST));
        match terms {
            Some(1) => self.words.get("sheet.series.one").to_owned(),
            Some(n) => self.words.say("sheet.series.terms", &[("terms", &n.to_string())]),
            None => self.words.say("sheet.series.many", &[("terms", &MOST.to_string())]),
        }
    }

    /// `$40\ \mathrm{kg}$`
    fn value_tex(&self, datum: usize, drawn: &[Option<Decimal>]) -> String {
        let Some(drawn) = drawn.get(datum).copied().flatten() else { return String::new() };
        let digits = self.words.tex_number(&drawn.text());
        self.problem.data.get(datum).map_or_else(String::new, |d| format!("${}$", d.unit.tex_with(&digits)))
    }

    /// `$2\,R$`
    fn derived_tex(&self, scene: &Scene, number: usize) -> String {
        let written = scene.formulas.numbers.get(number).map_or("", |n| n.text.as_str());
        format!("${}$", expression::tex(written, &self.problem.data))
    }

    fn particles(&self, scene: &Scene, drawn: &[Option<Decimal>], view: &mut View) {
        let text = |num: Num, unit: &str| match num {
            Num::Datum(i) => self.value_tex(i, drawn),
            Num::Derived(i) => self.derived_tex(scene, i),
            Num::Fixed(x) => format!("${}{unit}$", self.words.tex_number(&shown::constant(x))),
        };
        let whole = |num: Num, symbol: &str, unit: &str| {
            let symbol = match num {
                Num::Datum(i) => self.problem.data.get(i).map_or(symbol, |d| d.tex.as_str()),
                Num::Derived(_) => return text(num, unit),
                Num::Fixed(_) => symbol,
            };
            format!("${symbol} = {}", &text(num, unit)[1..])
        };
        for body in scene.bodies.iter().filter(|b| !b.particles.is_empty()) {
            let rows = body.particles.iter().map(|p| {
                template::texts([
                    ("name", format!("${}$", p.name).as_str()),
                    ("mass", &text(p.mass_kg, r"\ \mathrm{kg}")),
                    ("x", &text(p.x_m, r"\ \mathrm{m}")),
                    ("y", &text(p.y_m, r"\ \mathrm{m}")),
                ])
            });
            view.value("particles", template::list(rows));
            let count = body.particles.len();
            let name = format!("sheet.count_{count}");
            let said =
                if self.words.has(&name) { self.words.get(&name).to_owned() } else { count.to_string() };
            view.text("count", &said);
        }
        for start in &scene.start {
            if let Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s } = *start {
                let name = scene.bodies.get(body).and_then(|b| b.particles.get(particle));
                let name = name.map_or_else(String::new, |p| format!("${}$", p.name));
                let motion = template::texts([
                    ("particle", name.as_str()),
                    ("vx", &whole(vx_m_s, "v_x", r"\ \mathrm{m/s}")),
                    ("vy", &whole(vy_m_s, "v_y", r"\ \mathrm{m/s}")),
                    ("spin", &whole(spin_rad_s, r"\omega", r"\ \mathrm{rad/s}")),
                ]);
                view.value("motion", motion);
            }
        }
    }
}

/// Words that give the sign of a quantity of this label, the positive one first; `None` where none does.
pub fn sense_words<'w>(words: &'w Words, scene: &Scene, label: Label) -> Option<[&'w str; 2]> {
    Some(make_key::sense_words(scene, label)?.map(|word| words.get(&format!("sheet.{word}"))))
}

/// How an answer is to be written, with this relative tolerance: `in N, signed (positive: up) or with up / down`.
fn form(
    words: &Words,
    problem: &Problem,
    q: &Question,
    scene: &Scene,
    common: &Common,
    within: f64,
) -> String {
    if q.label.quantity.is_word() {
        let list = make_key::offered(problem, q.label.quantity, scene);
        let said: Vec<&str> = list.iter().map(|word| words.of_key(word)).collect();
        let text = match said.as_slice() {
            [a, b, c] => words.say("sheet.one_of_three", &[("a", a), ("b", b), ("c", c)]),
            [a, b] => words.say("sheet.one_of_two", &[("a", a), ("b", b)]),
            _ => String::new(),
        };
        let turns = || make_key::turns_forward(scene, q.label);
        let more = range(scene, q).or_else(turns).into_iter().chain(seen_from(scene, q));
        return more.fold(text, |text, phrase| format!("{text}, {}", words.get(phrase)));
    }
    let mut text = match q.unit.ascii() {
        "1" => words.get("sheet.number").to_owned(),
        // No-break spaces: a unit does not leave its word.
        unit => {
            let unit = unit.replace("^2", "²").replace("^3", "³");
            words.say("sheet.in_unit", &[("unit", &unit)]).replace(' ', "\u{a0}")
        }
    };
    let mut add = |more: &str| text.extend([", ", more]);
    // That of a single body on a pin counts from the horizontal, up or down.
    let angle = q.label.quantity == Quantity::PinAngle && scene.pinned().is_none();
    if let Some([positive, negative]) = sense_words(words, scene, q.label).filter(|_| !angle) {
        add(&words.say("sheet.signed", &[("forward", positive), ("back", negative)]));
    }
    let both_ways = match q.label.quantity {
        Quantity::XEq if !scene.is_magnitude(q.label) => Some("sheet.stretched"),
        Quantity::PinAngle if angle => Some("sheet.from_the_right"),
        Quantity::PinRadial => Some("sheet.toward_pin"),
        Quantity::PinTangential => Some("sheet.with_angle"),
        Quantity::Work
        | Quantity::WorkPull
        | Quantity::WorkCouple
        | Quantity::PowerPull
        | Quantity::PowerCouple => Some("sheet.adds_energy"),
        Quantity::Value => is_signed(scene, q.label).then_some("sheet.either_sign"),
        _ => scene.may_push(q.label).then_some("sheet.pulls"),
    };
    if let (Quantity::Angle, Owner::Body(b)) = (q.label.quantity, q.label.of)
        && let Some(planar) = scene.planar(b)
    {
        let [zero, sense] = [
            match planar.from {
                Ray::Right => "right",
                Ray::Up => "up",
                Ray::Left => "left",
                Ray::Down => "down",
            },
            if planar.clockwise { "clockwise" } else { "counter_clockwise" },
        ];
        let zero = words.get(&format!("sheet.angle_zero.{zero}"));
        add(&words
            .say("sheet.angle_from", &[("sense", words.get(&format!("sheet.{sense}"))), ("zero", zero)]));
        // What swings turns back before.
        if !matches!(scene.end, End::TurningPoint(_)) || scene.spins_in_place() {
            add(words.get("sheet.whole_turns"));
        }
    }
    if let Some([least, most]) = looked_for(problem, scene, q.label) {
        add(&words.say("sheet.between", &[("least", &words.number(&least)), ("most", &words.number(&most))]));
    }
    // The other body feels the opposite.
    let joint = match q.label.of {
        Owner::Joint(j) => scene.joints.get(j).map(|joint| joint.kind),
        _ => None,
    };
    let on = match joint {
        Some(JointKind::Hinge { one, .. }) => Some(one),
        Some(kind) if kind.bearer().is_some() => kind.spots().next(),
        _ => None,
    };
    if let Some(on) = on.filter(|_| !scene.is_magnitude(q.label)) {
        add(&words.say("sheet.acts_on", &[("body", &names::body_within(words, scene, on.body))]));
    }
    // Once is enough.
    let unsaid = |phrase: &&str| !q.ask.contains(words.get(phrase));
    for phrase in both_ways.into_iter().filter(unsaid).chain(range(scene, q)).chain(seen_from(scene, q)) {
        add(words.get(phrase));
    }
    if q.figures != common.figures {
        add(&words.say("sheet.figures", &[("n", &q.figures.to_string())]));
    }
    if (within - common.relative).abs() > f64::EPSILON {
        add(&words.say("sheet.within", &[("share", &words.number(&percent(within)))]));
    }
    if q.unit_required && !common.unit_required && !q.unit.is_number() {
        add(words.get("sheet.with_unit"));
    }
    text
}

/// The ends of the range in which the datum lies that is found and asked here: another value may give the same measurement.
fn looked_for(problem: &Problem, scene: &Scene, label: Label) -> Option<[String; 2]> {
    let (Owner::Asked(i), Some(found)) = (label.of, scene.formulas.found) else { return None };
    let asked = &scene.formulas.asked.get(i)?.formula;
    let alone = asked.steps().len() == 1 && asked.names().all(|term| term == Term::Given(found.unknown));
    let datum = problem.data.get(found.unknown.datum).filter(|_| alone)?;
    let (least, most) = datum.unknown.as_ref()?.range();
    Some([least, most].map(|end| printed(problem, found.unknown.datum, end)))
}

/// Has what a formula asks a sign? One of magnitudes alone has none that need be told, nor a root or a square.
fn is_signed(scene: &Scene, label: Label) -> bool {
    let Owner::Asked(i) = label.of else { return false };
    let Some(asked) = scene.formulas.asked.get(i) else { return false };
    let positive = |step: &Step<Term>| match step {
        Step::Sqrt | Step::Abs => true,
        Step::Power(n) => n % 2 == 0,
        _ => false,
    };
    let signed = |of: &Scene, label: Label| {
        let cord = label.quantity == Quantity::Tension && !of.may_push(label);
        !of.is_magnitude(label) && !cord
    };
    !asked.formula.steps().last().is_some_and(positive)
        && asked
            .formula
            .names()
            .filter_map(|term| scene.quantity_of(term))
            .any(|(of, label)| signed(of, label))
}

/// Which part of the motion counts: for the way and the turn of what may come back, and for an extremum where the forces change on the way so that it
/// matters.
fn range(scene: &Scene, q: &Question) -> Option<&'static str> {
    // What goes in phases may come back, and spin back.
    match q.label.quantity {
        Quantity::Phi if scene.goes_in_phases() => return Some("sheet.from_start_to_end"),
        Quantity::Direction if scene.goes_in_phases() => return Some("sheet.at_the_end"),
        // Friction changes where a contact comes to rest.
        Quantity::A
        | Quantity::Alpha
        | Quantity::Friction
        | Quantity::Tension
        | Quantity::RimForce
        | Quantity::PinForce
        | Quantity::PinX
        | Quantity::PinY
            if scene.ends_slip() =>
        {
            return Some("sheet.just_before");
        }
        Quantity::AngularMomentum if scene.pinned().is_none() => return Some("sheet.about_centre"),
        _ => {}
    }
    scene.springs().next()?;
    match (q.label.quantity, scene.span) {
        (Quantity::MuRequired | Quantity::Rolls, Span::ToEnd) => Some("sheet.to_the_end"),
        (Quantity::MuRequired | Quantity::Rolls | Quantity::VMax | Quantity::DAtVMax, _) => {
            Some("sheet.to_the_turning_point")
        }
        _ => None,
    }
}

/// Of what is carried: a direction counts on what carries it, all else is seen from the ground, and part of it along the line of its body.
fn seen_from(scene: &Scene, q: &Question) -> Option<&'static str> {
    scene.carried.as_ref()?;
    let on_a_line = scene.lead().is_none();
    match q.label.quantity {
        Quantity::Direction => Some("sheet.on_its_support"),
        Quantity::A | Quantity::ARolling | Quantity::Displacement | Quantity::Impulse if on_a_line => {
            Some("sheet.along_its_line")
        }
        Quantity::V if on_a_line => Some("sheet.from_the_ground"),
        _ => None,
    }
}

/// `1 %`
pub fn percent(share: f64) -> String {
    format!("{} %", shown::per_cent(share, 4))
}

/// Digits and unit as printed: `0.30 m`, `30 deg`, `0.55`.
pub fn printed(problem: &Problem, datum: usize, drawn: Decimal) -> String {
    let digits = drawn.text();
    problem.data.get(datum).map_or_else(|| digits.clone(), |d| d.unit.text_with(&digits))
}
