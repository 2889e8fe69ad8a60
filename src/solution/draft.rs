//! One solution as far as it is worked: the variant, its data as symbols, the sections written so far, and what has been
//! found by which method.
use crate::bank::Problem;
use crate::bank::decimal::Decimal;
use crate::bank::expression;
use crate::figure::names;
use crate::finding::Finding;
use crate::num::shown;
use crate::problem::maker::Variant;
use crate::scene::{AsIf, Body, End, Label, Mass, Num, Quantity, Scene};
use crate::solution::asked;
use crate::solution::expr::{Expr, SymbolId, ZERO};
use crate::solution::page::Step;
use crate::solution::symbols::{FIGURES, Symbols, tex_digits};
use crate::solution::terms::tagged;
use crate::solution::text::SolutionSection;
use crate::solve::energy;
use crate::solve::outcome::{Entry, Word};
use crate::units::Unit;
use crate::words::Words;

/// An answer, as a method finds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DerivedAnswer {
    /// A quantity of the solution.
    Value(SymbolId),
    /// A word.
    Word(Word),
}

impl From<SymbolId> for DerivedAnswer {
    fn from(symbol: SymbolId) -> Self {
        Self::Value(symbol)
    }
}

impl From<Word> for DerivedAnswer {
    fn from(word: Word) -> Self {
        Self::Word(word)
    }
}

/// How much a solution tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Detail {
    /// What a student needs: symbols, then the number.
    #[default]
    Short,
    /// Every step on a line of its own, with its numbers put in.
    Full,
}

/// The scene of a variant. Errors: the variant has a case that the problem has not.
pub fn scene_of<'a>(problem: &'a Problem, variant: &Variant) -> Result<&'a Scene, Finding> {
    let case = problem.cases.get(variant.case).map(|case| &case.scene);
    let missing =
        || Finding::new(format!("problems.{}", problem.id), format!("has no case {}", variant.case));
    case.ok_or_else(missing)
}

/// One solution as far as it is worked.
#[derive(Debug)]
pub struct Draft<'a> {
    /// The problem.
    pub problem: &'a Problem,
    /// The variant.
    pub variant: &'a Variant,
    /// Its scene.
    pub scene: &'a Scene,
    /// The words of the language.
    pub words: &'a Words,
    /// How much is told.
    pub detail: Detail,
    /// All quantities: the data first.
    pub symbols: Symbols<'a>,
    /// The sections between the data and the comparison, in order.
    pub sections: Vec<SolutionSection>,
    /// What was found.
    pub found: Vec<(Label, DerivedAnswer)>,
    /// One for each datum of the problem; `None` where the case does not use it.
    data: Vec<Option<SymbolId>>,
    /// Each datum as it is told, `R = 200\ \mathrm{mm} = 0.200\ \mathrm{m}`.
    pub told: Vec<(SymbolId, String)>,
    /// Data that are `any`, each with the value that was chosen.
    pub chosen: Vec<SymbolId>,
    /// What was found, in order, once all sections are written.
    pub steps: Vec<Step>,
    /// The same of all pages.
    pub derived: Vec<Step>,
    /// The slipping contact that is taken as if it rolled.
    pub rolled: Option<usize>,
    /// What the contacts are taken as, where another scene is worked.
    pub as_if: Option<AsIf>,
    /// The data as the scene takes them, with what it takes over where it follows another motion.
    pub values: Vec<f64>,
    /// Numbers of a motion that follows, by what was found of the one before it.
    pub handed: Vec<(Num, Expr)>,
    /// Constants of the bank that were given a symbol: value (bits) and symbol.
    constants: Vec<(u64, String, SymbolId)>,
}

impl<'a> Draft<'a> {
    /// A draft that holds the data of a variant, whose scene is `scene` ([`scene_of`]); `symbols` is empty yet.
    pub fn new(
        problem: &'a Problem,
        variant: &'a Variant,
        scene: &'a Scene,
        words: &'a Words,
        symbols: Symbols<'a>,
    ) -> Self {
        let mut draft = Self {
            problem,
            variant,
            scene,
            words,
            detail: Detail::Short,
            symbols,
            sections: Vec::new(),
            found: Vec::new(),
            data: vec![None; problem.data.len()],
            told: Vec::new(),
            chosen: Vec::new(),
            steps: Vec::new(),
            derived: Vec::new(),
            rolled: None,
            as_if: None,
            values: variant.data.clone(),
            handed: Vec::new(),
            constants: Vec::new(),
        };
        for (i, datum) in problem.data.iter().enumerate() {
            let (Some(drawn), Some(value)) = (variant.values.get(i).copied().flatten(), variant.data.get(i))
            else {
                continue;
            };
            let printed = datum.unit.tex_with(&tex_digits(&drawn.text(), words));
            let (digits, unit) = if datum.degrees {
                (
                    if datum.unit.ascii() == "deg" {
                        drawn.text()
                    } else {
                        shown::significant(*value, FIGURES)
                    },
                    String::new(),
                )
            } else {
                (si_digits(drawn, &datum.unit, *value), si_unit(&datum.unit).tex())
            };
            let symbol = draft.symbols.given(&datum.tex, *value, &digits, &unit, datum.degrees);
            let shown = draft.symbols.shown(symbol);
            let again = if shown == printed { String::new() } else { format!(" = {shown}") };
            // At an instant of bodies on lines nothing falls; a pin carries weight even then, and a weight that is given needs g.
            let level = draft.scene.lies_level();
            let carries = |b: &Body| b.planar.is_some() && !level;
            let weighs = |b: &Body| carries(b) || matches!(b.mass, Mass::Weight(_));
            let bodies = &draft.scene.bodies;
            let falls = !level
                && (draft.scene.end != End::AtOnce || draft.forces_asked())
                && !bodies.iter().all(Body::massless);
            let idle = draft.scene.gravity_m_s2 == Num::Datum(i) && !falls && !bodies.iter().any(weighs);
            if !idle {
                draft.told.push((symbol, format!("{} = {printed}{again}", datum.tex)));
            }
            draft.data[i] = Some(symbol);
        }
        if let (Some(found), Some(x)) =
            (draft.scene.formulas.found, energy::datum_found(scene, &variant.data))
        {
            let datum = &problem.data[found.unknown.datum];
            let unit = if datum.degrees { String::new() } else { si_unit(&datum.unit).tex() };
            let digits = shown::significant(x, FIGURES);
            let symbol = draft.symbols.given(&datum.tex, x, &digits, &unit, datum.degrees);
            draft.data[found.unknown.datum] = Some(symbol);
            draft.values[found.unknown.datum] = x;
            // What the scene works out from it is told by it.
            for (i, number) in draft.scene.formulas.numbers.iter().enumerate() {
                if number.formula.names().any(|g| g.datum == found.unknown.datum)
                    && let Ok(from) = asked::expression(&mut draft, &number.formula, &|draft, g| {
                        Ok(asked::given_as(draft, g))
                    })
                {
                    draft.handed.push((Num::Derived(i), from));
                }
            }
        }
        draft
    }

    /// A number of the scene as an expression: its datum's symbol, or that of a constant of the bank, for which `tex` and the
    /// SI `unit` (ASCII, `deg` for a slope) are taken. A constant 0 is [`ZERO`].
    pub fn number(&mut self, num: Num, tex: &str, unit: &str) -> Expr {
        if let Some((_, from)) = self.handed.iter().find(|(n, _)| *n == num) {
            return from.clone();
        }
        match num {
            Num::Datum(i) => match self.data.get(i).copied().flatten() {
                Some(symbol) => symbol.into(),
                None => ZERO,
            },
            Num::Fixed(0.0) => ZERO,
            Num::Fixed(_) | Num::Derived(_) => {
                let x = self.datum(num);
                let (digits, written) = match num {
                    Num::Derived(i) => {
                        let text = self.scene.formulas.numbers.get(i).map_or("", |n| n.text.as_str());
                        let tex = expression::tex(text, &self.problem.data);
                        (shown::significant(x, FIGURES), format!(" = {tex}"))
                    }
                    _ => (shortest(x), String::new()),
                };
                let known = self.constants.iter().find(|(bits, t, _)| *bits == x.to_bits() && t == tex);
                if let Some((_, _, symbol)) = known {
                    return (*symbol).into();
                }
                let degrees = unit == "deg";
                let unit = if degrees { String::new() } else { tex_of(unit) };
                // Constants of different values bear different symbols.
                let mut name = self.free(&names::sizes(tex));
                for i in 1..10 {
                    if self.tells(&name) {
                        name = tagged(tex, &i.to_string());
                    }
                }
                let symbol = self.symbols.given(&name, x, &digits, &unit, degrees);
                let any = |i: usize| self.scene.formulas.numbers.get(i).is_some_and(|n| n.any);
                if let Num::Derived(i) = num
                    && any(i)
                {
                    self.chosen.push(symbol);
                    self.constants.push((x.to_bits(), tex.to_owned(), symbol));
                    return symbol.into();
                }
                self.told.push((symbol, format!("{name}{written} = {}", self.symbols.shown(symbol))));
                self.constants.push((x.to_bits(), tex.to_owned(), symbol));
                symbol.into()
            }
        }
    }

    /// Is a datum or a constant told that bears this symbol?
    fn tells(&self, tex: &str) -> bool {
        self.told.iter().any(|(symbol, _)| self.symbols.tex(*symbol) == tex)
    }

    /// A constant of the data that is the same as an expression, in the same unit.
    pub fn constant_as(&self, from: &Expr, unit: &str) -> Option<SymbolId> {
        let value = from.value(&self.symbols);
        let same = |symbol: SymbolId| {
            let known = self.symbols.value(symbol);
            (known - value).abs() <= 1e-12 * value.abs() && self.symbols.unit(symbol) == tex_of(unit)
        };
        self.constants.iter().map(|(_, _, symbol)| *symbol).find(|s| same(*s))
    }

    /// The value of a number of the scene, SI, slopes in degrees.
    pub fn datum(&self, num: Num) -> f64 {
        self.scene.value(num, &self.values)
    }

    /// The first of these symbols that no datum bears; if all are taken, the last one with a star.
    pub fn free(&self, candidates: &[impl AsRef<str>]) -> String {
        let candidates: Vec<String> = candidates.iter().map(|tex| tex.as_ref().to_owned()).collect();
        names::free(self.problem, &candidates)
    }

    /// A quantity that is not known yet, in the unit (ASCII) given.
    pub fn unknown(&mut self, tex: &str, unit: &str) -> SymbolId {
        self.symbols.unknown(tex, &tex_of(unit))
    }

    /// The same, by the first of these symbols that is free.
    pub fn named(&mut self, names: &[impl AsRef<str>], unit: &str) -> SymbolId {
        let open: Vec<&str> = names.iter().map(AsRef::as_ref).filter(|tex| !self.tells(tex)).collect();
        let tex = if open.is_empty() { format!("{}^{{*}}", self.free(names)) } else { self.free(&open) };
        self.unknown(&tex, unit)
    }

    /// Pi, which is its own number.
    pub fn pi(&mut self) -> SymbolId {
        self.symbols.given(r"\pi", std::f64::consts::PI, r"\pi", "", false)
    }

    /// An angle in degrees as one in radians.
    pub fn radians(&mut self, degrees: Expr) -> Expr {
        let half = self.symbols.given(r"180^\circ", 180.0, "180", "", true);
        degrees * self.pi() / half
    }

    /// The data as they are told, each a formula without dollars.
    pub fn told(&self) -> impl Iterator<Item = &str> {
        self.told.iter().map(|(_, text)| text.as_str())
    }

    /// Symbol (as the bank has it) and text of each datum for templates, `$R = 200\ \mathrm{mm}$`.
    pub fn whole(&self) -> Vec<(String, String)> {
        let drawn = |i: usize| self.variant.values.get(i).copied().flatten();
        let data = self.problem.data.iter().enumerate();
        data.filter_map(|(i, d)| {
            let value = d.unit.tex_with(&tex_digits(&drawn(i)?.text(), self.words));
            Some((d.symbol.clone(), format!("${} = {value}$", d.tex)))
        })
        .collect()
    }

    /// Gives an unknown the value of what it is equal to, with the digits of that where it is another quantity.
    pub fn settle(&mut self, symbol: SymbolId, from: &Expr) {
        let (size, opposite) = if let Expr::Minus(inner) = from { (&**inner, true) } else { (from, false) };
        match size {
            Expr::Symbol(same) => self.symbols.settle_as(symbol, *same, opposite),
            _ => self.symbols.settle_by(symbol, from),
        }
    }

    /// Notes an answer.
    pub fn answer(&mut self, label: Label, answer: impl Into<DerivedAnswer>) {
        let answer = answer.into();
        match self.found.iter_mut().find(|(l, _)| *l == label) {
            Some((_, known)) => *known = answer,
            None => self.found.push((label, answer)),
        }
    }

    /// What was found for a label.
    pub fn found_for(&self, label: Label) -> Option<DerivedAnswer> {
        self.found.iter().find(|(l, _)| *l == label).map(|(_, answer)| *answer)
    }

    /// The quantity that was found for a label.
    pub fn value_for(&self, label: Label) -> Option<SymbolId> {
        if let Some(DerivedAnswer::Value(symbol)) = self.found_for(label) { Some(symbol) } else { None }
    }

    /// What the key has for a label, SI.
    pub fn key(&self, label: Label) -> Option<f64> {
        self.variant.solved.get(label).map(Entry::value)
    }

    /// What has to be known for what is asked.
    pub fn needed(&self) -> Vec<Label> {
        asked::needed(self.scene, self.problem)
    }

    /// Is this quantity asked, of anything?
    pub fn asks(&self, quantity: Quantity) -> bool {
        self.needed().iter().any(|label| label.quantity == quantity)
    }

    /// Does what is to move stay where it is?
    pub fn stays(&self) -> bool {
        self.as_if.is_none() && self.variant.solved.regime.stays()
    }

    /// Is anything asked at which forces have to be known?
    pub fn forces_asked(&self) -> bool {
        use Quantity::{PowerCouple, PowerPull, Value};
        let forced = |q| is_rate(q) || matches!(q, PowerCouple | PowerPull | Value);
        self.needed().iter().any(|label| forced(label.quantity))
    }

    /// Are forces and accelerations that stay the same all that is asked of a motion?
    pub fn rates_alone(&self) -> bool {
        self.as_if.is_none() && self.steady() && self.needs_only(is_rate)
    }

    /// Is the time to a speed asked, and no place, while all forces are constant?
    pub fn times_alone(&self) -> bool {
        let at_speed = matches!(self.scene.end, End::Speed(..) | End::TurningPoint(_));
        at_speed && self.steady() && self.needs_only(|q| q == Quantity::T || is_rate(q))
    }

    /// Are all forces of a motion constant, and no contact slips at first?
    fn steady(&self) -> bool {
        let s = self.scene;
        s.end != End::AtOnce && !s.is_sprung() && s.growths.is_empty() && s.thrown().is_none()
    }

    fn needs_only(&self, wanted: impl Fn(Quantity) -> bool) -> bool {
        self.needed().iter().all(|l| wanted(l.quantity))
    }
}

/// Is this a force or an acceleration, which asks for no place, speed or time where forces are constant?
pub const fn is_rate(q: Quantity) -> bool {
    use Quantity as Q;
    matches!(q, Q::A | Q::Alpha | Q::Friction | Q::FrictionIfRolled | Q::MuRequired | Q::Normal)
        || matches!(q, Q::Tension | Q::RimForce | Q::Direction | Q::Rolls)
        || matches!(q, Q::PinX | Q::PinY | Q::PinForce | Q::PinAngle)
}

/// The LaTeX of a unit in ASCII; empty for `1` and for what is no unit.
pub fn tex_of(unit: &str) -> String {
    Unit::parse(unit).map_or_else(|_| String::new(), |u| u.tex())
}

/// Digits in SI of a drawn value: exact where the unit is a power of ten of the SI unit.
fn si_digits(drawn: Decimal, unit: &Unit, value: f64) -> String {
    for ten in 0..=12u8 {
        let power = 10i64.pow(u32::from(ten));
        // Both conversions are exact powers of ten or are not one at all.
        #[expect(clippy::float_cmp, clippy::cast_precision_loss, reason = "powers of ten are exact here")]
        let (small, large) = (unit.to_si(power as f64) == 1.0, unit.to_si(1.0) == power as f64);
        if small {
            let decimals = drawn.decimals + ten;
            return Decimal { value: drawn.value, decimals }.text();
        }
        if large && let Some(value) = drawn.value.checked_mul(power) {
            return Decimal { value, decimals: drawn.decimals }.trimmed(ten).text();
        }
    }
    shown::significant(value, FIGURES)
}

/// The shortest digits that give the double back.
fn shortest(x: f64) -> String {
    let plain = format!("{x}");
    if plain.len() > 12 { shown::significant(x, 2 * FIGURES) } else { plain }
}

/// The SI unit of the same kind.
fn si_unit(unit: &Unit) -> Unit {
    const PLAIN: [&str; 16] = [
        "1", "kg", "m", "s", "rad", "m/s", "m/s^2", "rad/s", "rad/s^2", "N", "N/m", "N m", "kg m^2", "W",
        "m^2", "kg/m",
    ];
    let mut known = PLAIN.iter().filter_map(|u| Unit::parse(u).ok());
    known
        .find(|u| u.dimension() == unit.dimension())
        .or_else(|| Unit::parse(&unit.dimension().to_string()).ok())
        .unwrap_or_else(|| unit.clone())
}
