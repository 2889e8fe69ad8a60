//! A variant as a picture sees it: numbers of the scene, their symbols and drawn values as label text, words.
use crate::bank::{Datum, FigureLabels, Problem, expression};
use crate::num::shown;
use crate::picture::{RunStyle, TextRun, symbol};
use crate::problem::maker::Variant;
use crate::scene::{
    AsIf, Body, BodyNumbers, CordEnd, Degree, GivenForce, Grows, Label, Mass, Num, Numbers, Owner, Quantity,
    RotaryInertia, Scene, Shape, Slope, Start, Tie,
};
use crate::units::Unit;
use crate::words::Words;

/// A variant with what is needed to label its picture.
#[derive(Clone, Copy)]
pub struct SceneView<'a> {
    pub problem: &'a Problem,
    /// One draw of it.
    pub variant: &'a Variant,
    pub scene: &'a Scene,
    /// Phrases.
    pub words: &'a Words,
    /// Are symbols followed by values?
    pub labels: FigureLabels,
    /// Is it part of a worked solution, which may tell what is asked?
    pub worked: bool,
}

impl<'a> SceneView<'a> {
    /// A view; `None` if the variant has no scene.
    pub fn new(
        problem: &'a Problem,
        variant: &'a Variant,
        words: &'a Words,
        labels: FigureLabels,
    ) -> Option<Self> {
        let scene = &problem.cases.get(variant.case)?.scene;
        Some(Self { problem, variant, scene, words, labels, worked: false })
    }

    /// A number of the scene.
    pub fn of(&self, num: Num) -> f64 {
        match self.scene.value(num, &self.variant.data) {
            x if x.is_finite() => x,
            _ => 0.0,
        }
    }

    /// The motion that follows, with the end at its body and the stiffness of its spring where this motion has none.
    pub fn awaited(&self) -> Option<(&'a Scene, CordEnd, Num)> {
        let mut others = self.scene.formulas.others.iter();
        let (_, next) = others.find(|(how, _)| *how == AsIf::Next)?;
        let spring = next.springs().next().filter(|_| !self.scene.is_sprung())?;
        Some((next, spring.from, spring.stiffness_n_m))
    }

    /// A slope in degrees.
    pub fn degrees(&self, slope: Slope) -> f64 {
        match slope {
            Slope::Level => 0.0,
            Slope::Vertical => 90.0,
            Slope::Degrees(n) => self.of(n),
        }
    }

    /// The coefficients of friction that are given for a contact, by the index of its tie: what for, and the number.
    pub fn coefficients(&self, tie: usize) -> Vec<(&'static str, Num)> {
        let case = self.problem.cases.get(self.variant.case);
        // A contact that is left open shows both of its coefficients, whether it rolls or slips.
        let open = || case.and_then(|c| c.touches.iter().find(|(t, _)| *t == tie)).map(|(_, mu_k)| *mu_k);
        let (rest, sliding) = match self.scene.ties.get(tie) {
            Some(Tie::Roll { mu_s, .. }) => (*mu_s, open()),
            Some(Tie::Slip { mu_s, mu_k, .. }) => (Some(*mu_s), Some(*mu_k)),
            Some(Tie::Slide { mu_s, mu_k, .. }) => (*mu_s, Some(*mu_k)),
            Some(Tie::Cord(_)) | None => (None, None),
        };
        // A datum that is both is told once.
        let rest = rest.filter(|rest| sliding != Some(*rest) || matches!(rest, Num::Fixed(_)));
        [(r"\mu_s", rest), (r"\mu_k", sliding)]
            .into_iter()
            .filter_map(|(tex, num)| Some((tex, num?)))
            .collect()
    }

    /// Speeds and spins that a body has at the start, without those that are 0.
    pub fn started(&self, body: usize) -> impl Iterator<Item = (Degree, Num)> {
        self.scene.start.iter().filter_map(move |start| match *start {
            Start::Speed(c, num) if c.body == body && self.of(num).abs() > 1e-12 => Some((c.degree, num)),
            _ => None,
        })
    }

    /// Symbol of a datum; nothing for a constant.
    pub fn symbol(&self, num: Num) -> Vec<TextRun> {
        match num {
            Num::Datum(i) => self.problem.data.get(i).map_or_else(Vec::new, |d| symbol::symbol(&d.tex)),
            Num::Derived(i) => {
                let Some(number) = self.scene.formulas.numbers.get(i) else { return Vec::new() };
                if number.any { symbol::symbol(&number.text) } else { self.written(&number.text) }
            }
            Num::Fixed(_) => Vec::new(),
        }
    }

    /// An expression as people write it.
    fn written(&self, text: &str) -> Vec<TextRun> {
        let degrees = text.replace("*pi/180", "°");
        let words: Vec<&str> = expression::words(&degrees).collect();
        // Brackets round the whole of it, or round one word, say nothing.
        let closes = |open: usize| {
            let mut depth = 0;
            (open..words.len()).find(|i| {
                depth += i32::from(words[*i] == "(") - i32::from(words[*i] == ")");
                depth == 0
            })
        };
        let called = |at: usize| words[..at].last().is_some_and(|w| w.starts_with(char::is_alphabetic));
        let needless = |open: usize| {
            let close = closes(open).filter(|_| words[open] == "(" && !called(open))?;
            let alone = (open == 0 && close + 1 == words.len()) || close == open + 2;
            alone.then_some([open, close])
        };
        let left_out: Vec<usize> = (0..words.len()).filter_map(needless).flatten().collect();
        let (mut raised, mut divided) = (false, false);
        let mut runs = Vec::new();
        for (_, word) in words.iter().enumerate().filter(|(i, _)| !left_out.contains(i)) {
            let mut term = match (self.problem.data.iter().find(|d| d.symbol == *word), *word) {
                (Some(datum), _) => symbol::symbol(&datum.tex),
                // What stands behind a quotient is not divided by.
                (None, "*") if divided => symbol::upright("\u{2009}·\u{2009}"),
                (None, "*") => symbol::upright("\u{2009}"),
                (None, "^") => Vec::new(),
                (None, "-") => symbol::upright("−"),
                (None, "pi") => symbol::upright("π"),
                (None, "sqrt") => symbol::upright("√"),
                (None, "asin" | "acos" | "atan") => symbol::upright(format!("arc{}", &word[1..])),
                (None, other) => symbol::upright(other),
            };
            divided = *word == "/" || divided && !["+", "-", "(", ")"].contains(word);
            if std::mem::replace(&mut raised, *word == "^") {
                term.iter_mut().for_each(|r| r.style = RunStyle::Super);
            }
            runs.extend(term);
        }
        runs
    }

    /// The data that a number is, or of which it is worked out.
    pub fn data(&self, num: Num) -> Vec<Num> {
        let Num::Derived(i) = num else { return Vec::from_iter(matches!(num, Num::Datum(_)).then_some(num)) };
        let text = self.scene.formulas.numbers.get(i).map_or("", |number| number.text.as_str());
        let datum = |word: &str| self.problem.data.iter().position(|d| d.symbol == word);
        expression::words(text).filter_map(datum).map(Num::Datum).collect()
    }

    /// The number as drawn, with its unit; a constant in `unit` (as HTML, SI).
    pub fn value(&self, num: Num, unit: &str) -> Vec<TextRun> {
        match num {
            Num::Datum(i) => {
                let drawn = self.variant.values.get(i).copied().flatten();
                match (drawn, self.problem.data.get(i)) {
                    (Some(drawn), Some(datum)) => {
                        let unit = if datum.unit.is_number() { String::new() } else { datum.unit.html() };
                        symbol::quantity(&self.words.number(&drawn.text()), &unit)
                    }
                    _ => Vec::new(),
                }
            }
            Num::Fixed(x) => {
                let (x, unit) = self.constant(x, unit);
                symbol::quantity(&self.words.number(&shown::constant(x)), &unit)
            }
            // The negative of a datum has its value. Else its symbols say it; their values stand elsewhere.
            Num::Derived(_) => match self.unsigned(num) {
                datum @ Num::Datum(_) => {
                    let mut value = self.value(datum, unit);
                    if let Some(first) = value.first_mut() {
                        first.text = match first.text.strip_prefix('−') {
                            Some(size) => size.to_owned(),
                            None => format!("−{}", first.text),
                        };
                    }
                    value
                }
                _ => Vec::new(),
            },
        }
    }

    /// A constant that a bank wrote, in the unit in which it most likely did: where data are told in customary units, in the one in
    /// which it is short. Units as HTML.
    fn constant(&self, x: f64, unit: &str) -> (f64, String) {
        const CUSTOMARY: [&str; 11] = [
            "ft",
            "in",
            "lbf",
            "lbf*ft",
            "lbf/ft",
            "lbf/in",
            "slug",
            "slug*ft^2",
            "ft/s",
            "ft/s^2",
            "rev/min",
        ];
        let si = unit.replace("<sup>", "^").replace("</sup>", "").replace('·', "*");
        let units = || CUSTOMARY.iter().filter_map(|name| Unit::parse(name).ok());
        let customary = |d: &Datum| units().any(|unit| unit.ascii() == d.unit.ascii());
        let figures = |x: f64| (1..=7).find(|n| (shown::rounded(x, *n) / x - 1.0).abs() < 1e-12).unwrap_or(8);
        let as_told = (x, unit.to_owned());
        let Ok(si) = Unit::parse(&si) else { return as_told };
        if x == 0.0 || !self.problem.data.iter().any(customary) {
            return as_told;
        }
        let alike = units().filter(|unit| unit.dimension() == si.dimension());
        let told = alike.map(|unit| (shown::rounded(unit.from_si(x), 12), unit.html()));
        std::iter::once(as_told).chain(told).min_by_key(|(x, _)| figures(*x)).unwrap_or_default()
    }

    /// Label of a number: `R = 0.40 m`, or `R` alone; a constant is always its value.
    pub fn label(&self, num: Num, unit: &str) -> Vec<TextRun> {
        let symbol = self.symbol(num);
        if self.labels == FigureLabels::Symbols && !symbol.is_empty() {
            return symbol;
        }
        joined(symbol, self.value(num, unit))
    }

    /// Symbols of a given force or couple, and its size at the end; `P + c t` where it grows with time, `c x` with place.
    pub fn load(&self, of: GivenForce, num: Num) -> (Vec<TextRun>, f64) {
        let Some(growth) = self.scene.growth(of) else { return (self.symbol(num), self.of(num)) };
        let per = growth.rate_unit().replace('*', "·");
        let per =
            ["2", "3"].iter().fold(per, |per, n| per.replace(&format!("^{n}"), &format!("<sup>{n}</sup>")));
        let unit = [if matches!(of, GivenForce::Pull(_)) { "N" } else { "N·m" }, per.as_str()];
        let with = match (growth.law.with, of) {
            (Grows::Time, _) => "t",
            (Grows::Place, GivenForce::Pull(_)) => "x",
            (Grows::Place, GivenForce::Couple(_)) => r"\varphi",
        };
        let power = match growth.law.halves {
            1 => [symbol::upright("√"), symbol::symbol(with)].concat(),
            2 => symbol::symbol(with),
            halves if halves % 2 == 0 => symbol::symbol(&format!("{with}^{}", halves / 2)),
            halves => symbol::symbol(&format!("{with}^{{{halves}/2}}")),
        };
        let written = |num: Num, unit: &str| match self.symbol(num) {
            symbol if symbol.is_empty() => self.value(num, unit),
            symbol => symbol,
        };
        let mut sum = written(growth.rate, unit[1]);
        if self.symbol(growth.rate).is_empty() {
            sum.extend(symbol::upright("\u{2009}"));
        }
        sum.extend(power);
        // What begins at nothing is what it grows by.
        if num != Num::Fixed(0.0) {
            sum = [written(num, unit[0]), symbol::upright(" + "), sum].concat();
        }
        let own = match (growth.law.with, of) {
            (Grows::Time, _) => None,
            (_, GivenForce::Pull(tie)) => Some((Quantity::CordTravel, Owner::Tie(tie))),
            (_, GivenForce::Couple(i)) => Some((Quantity::Phi, Owner::Body(self.scene.couples[i].body))),
        };
        let own = match own {
            Some((quantity, of)) => self.solved(quantity, of).unwrap_or(0.0),
            None => self.scene.growing_for().map_or(0.0, |x| self.of(x)),
        };
        (sum, self.of(num) + self.of(growth.rate) * growth.law.of(own, 1.0))
    }

    /// The law of a given force or couple that grows, in words of a picture, with the values of what it names.
    pub fn growing(&self, of: GivenForce, num: Num) -> Option<String> {
        let growth = self.scene.growth(of)?;
        let unit = if matches!(of, GivenForce::Pull(_)) { "N" } else { "N·m" };
        let named = [(num, unit.to_owned()), (growth.rate, growth.rate_unit().replace('*', "·"))];
        let named = named.iter().filter(|(num, _)| !self.symbol(*num).is_empty());
        let values: Vec<String> = named.map(|(num, unit)| self.text(*num, unit)).collect();
        let law = symbol::plain(&self.load(of, num).0);
        let text = if values.is_empty() { law } else { format!("{law} ({})", values.join(", ")) };
        Some(text.replace(['\u{a0}', '\u{2009}'], " "))
    }

    /// Label of a given force or couple.
    pub fn force_label(&self, of: GivenForce, num: Num, unit: &str) -> Vec<TextRun> {
        match self.scene.growth(of) {
            Some(_) => self.load(of, num).0,
            None => self.size_label(num, unit),
        }
    }

    /// The datum of which a number is the negative, else the number: an arrow shows the sense.
    pub fn unsigned(&self, num: Num) -> Num {
        let Num::Derived(i) = num else { return num };
        let written = self.scene.formulas.numbers.get(i).and_then(|n| n.text.strip_prefix('-'));
        let datum = self.problem.data.iter().position(|d| written.map(str::trim) == Some(d.symbol.as_str()));
        datum.map_or(num, Num::Datum)
    }

    /// The datum of which a number is half, whatever its sign.
    pub fn twice(&self, num: Num) -> Option<Num> {
        let Num::Derived(i) = num else { return None };
        let half = self.scene.formulas.numbers.get(i)?.text.trim_start_matches('-').strip_suffix("/2")?;
        self.problem.data.iter().position(|d| d.symbol == half.trim()).map(Num::Datum)
    }

    /// Label of the size of a number whose sense an arrow shows: `|ω_0| = 11 rad/s` of -11 rad/s.
    pub fn size_label(&self, num: Num, unit: &str) -> Vec<TextRun> {
        let size = self.size_symbol(num);
        if self.labels == FigureLabels::Symbols && !size.is_empty() {
            return size;
        }
        self.size_runs(num, unit)
    }

    /// The same as text, whatever the labels say.
    pub fn size_text(&self, num: Num, unit: &str) -> String {
        symbol::plain(&self.size_runs(num, unit))
    }

    fn size_runs(&self, num: Num, unit: &str) -> Vec<TextRun> {
        let num = self.unsigned(num);
        let mut value = self.value(num, unit);
        if let Some(first) = value.first_mut() {
            first.text = first.text.trim_start_matches('−').to_owned();
        }
        joined(self.size_symbol(num), value)
    }

    /// The symbols of the size of a number: of a negative product those of what it is the negative of.
    fn size_symbol(&self, num: Num) -> Vec<TextRun> {
        let num = self.unsigned(num);
        let symbol = self.symbol(num);
        let sum = |run: &TextRun| run.text.contains(['+', '−']);
        match symbol.split_first() {
            Some((minus, product)) if minus.text == "−" && !product.iter().any(sum) => {
                symbol::magnitude(product.to_vec(), self.of(num) > 0.0)
            }
            Some(_) => symbol::magnitude(symbol, self.of(num) < 0.0),
            None => symbol,
        }
    }

    /// `R = 0.40 m` as text, whatever the labels say.
    pub fn text(&self, num: Num, unit: &str) -> String {
        symbol::plain(&joined(self.symbol(num), self.value(num, unit)))
    }

    /// What the solver says of a quantity of a body, a tie or the scene.
    pub fn solved(&self, quantity: Quantity, of: Owner) -> Option<f64> {
        self.variant.solved.get(Label { quantity, of }).map(|e| e.value()).filter(|v| v.is_finite())
    }

    /// The number that gives the mass of a body, and whether it is a weight.
    pub fn mass(&self, body: &Body) -> Option<(Num, bool)> {
        given_mass(&body.mass)
    }

    /// The numbers that give its mass, or the masses of its parts.
    pub fn masses(&self, body: &Body) -> Vec<(Num, bool)> {
        match &body.inertia {
            Some(RotaryInertia::Parts(parts)) => parts.iter().filter_map(|p| given_mass(&p.mass)).collect(),
            _ => self.mass(body).into_iter().collect(),
        }
    }

    /// What the solvers read of a body, masses in kg; what cannot be read is 0.
    pub fn numbers(&self, body: &Body) -> BodyNumbers<f64> {
        let all = Numbers::<f64>::new(self.scene, &self.variant.data);
        let index = self.scene.bodies.iter().position(|b| std::ptr::eq(b, body));
        let own = index
            .map_or(BodyNumbers { mass: 0.0, inertia: 0.0, climb: 0.0, level: 1.0, carried: None }, |b| {
                all.bodies[b]
            });
        let [mass, inertia] = [own.mass, own.inertia].map(|x| all.publish(Quantity::IG, x));
        let [mass, inertia] = [mass, inertia].map(|x| if x.is_finite() { x } else { 0.0 });
        BodyNumbers { mass, inertia, ..own }
    }

    /// Mass of a body, kg.
    pub fn kilograms(&self, body: &Body) -> f64 {
        self.numbers(body).mass
    }

    /// Moment of inertia about the mass centre, kg m^2: of a body that turns.
    pub fn inertia(&self, body: &Body) -> f64 {
        self.numbers(body).inertia
    }

    /// Radii that are drawn on a body, each once, in metres, largest first.
    pub fn radii(&self, body: &Body) -> Vec<(Num, f64)> {
        let mut all: Vec<(Num, f64)> = body.radii_m.iter().map(|(_, n)| (*n, self.of(*n))).collect();
        match &body.inertia {
            Some(RotaryInertia::Shape(shape, r)) if *shape != Shape::Rod => all.push((*r, self.of(*r))),
            Some(RotaryInertia::Parts(parts)) => {
                all.extend(parts.iter().map(|p| (p.radius_m, self.of(p.radius_m))))
            }
            _ => {}
        }
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        all.dedup_by(|a, b| a.0 == b.0 || (a.1 - b.1).abs() <= 1e-12 * b.1.abs());
        all
    }
}

/// The number that gives a mass, and whether it is a weight.
fn given_mass(mass: &Mass) -> Option<(Num, bool)> {
    match mass {
        Mass::Kilograms(n) => Some((*n, false)),
        Mass::Weight(n) => Some((*n, true)),
        Mass::OfParts => None,
    }
}

/// `left = right`, or the one of them that says something.
pub fn joined(left: Vec<TextRun>, right: Vec<TextRun>) -> Vec<TextRun> {
    let both = !left.is_empty() && !right.is_empty();
    let equals = if both { symbol::upright("\u{a0}=\u{a0}") } else { Vec::new() };
    [left, equals, right].concat()
}
