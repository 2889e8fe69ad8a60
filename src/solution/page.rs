//! Writes the sections of a solution: sentences, displayed formulas, and the quantities as they are found, short ones within the
//! sentences, wide ones on lines of their own.
use crate::num::linear::Linear;
use crate::num::shown;
use crate::scene::Quantity;
use crate::solution::draft::{Detail, Draft, tex_of};
use crate::solution::expr::{Expr, SymbolId, ZERO, arc_cosine, in_sense, length, magnitude, positive_first};
use crate::solution::factors::{Cancel, Sum};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{FIGURES, tex_digits};
use crate::solution::terms::Carrying;
use crate::solution::text::{Block, LINE, SolutionSection, WIDEST};
use crate::solution::written::width;

/// Widest formula that stands within a sentence.
pub const WITHIN: f64 = 34.0;
/// Widest line of several formulas: the gaps between them do not shrink.
const PACKED: f64 = LINE - 8.0;
/// So many formulas may stand within a sentence.
const FEW: usize = 2;

/// A value of an unknown beside which what is known of an equation is small, so that its coefficient keeps all digits.
const FAR: f64 = 1_048_576.0;

/// Below this share of a force in an equation it is not solved for.
const FLAT: f64 = 1e-9;

/// A quantity as it was found.
#[derive(Debug, Clone)]
pub struct Step {
    pub symbol: SymbolId,
    /// What it is equal to.
    pub from: Expr,
}

/// What can stand in the place of a piece of a sentence: words as they are, quantities by their symbols, formulas in symbols.
pub trait Piece {
    fn told(&self, page: &Page) -> String;
}

/// The pieces of a sentence, each with its name.
pub type Pieces<'p> = &'p [(&'p str, &'p dyn Piece)];

/// How each kind of piece is told.
macro_rules! pieces {
    ($($what:ty: $told:expr;)*) => {$(
        impl Piece for $what {
            fn told(&self, page: &Page) -> String {
                let told: fn(&Page, &Self) -> String = $told;
                told(page, self)
            }
        }
    )*};
}
pieces! {
    &str: |_, words| (*words).to_owned();
    String: |_, words| words.clone();
    SymbolId: |page, symbol| page.names(&[*symbol]);
    [SymbolId; 2]: |page, symbols| page.names(symbols);
    Vec<SymbolId>: |page, symbols| page.names(symbols);
    Expr: |page, formula| page.inline(formula);
}

/// The section that is being written.
pub struct Page<'d, 'a> {
    pub draft: &'d mut Draft<'a>,
    /// What was found, in order.
    pub steps: Vec<Step>,
    /// The section.
    pub out: SolutionSection,
    /// Sentences of the paragraph that is being written.
    open: Vec<String>,
    /// Quantities that have been told.
    told: Vec<SymbolId>,
}

stands_on!(Page.draft: Draft<'a>);

impl<'d, 'a> Page<'d, 'a> {
    /// Nothing yet.
    pub fn new(draft: &'d mut Draft<'a>) -> Self {
        let out = SolutionSection::new("", "");
        Self { draft, steps: Vec::new(), out, open: Vec::new(), told: Vec::new() }
    }
    /// The value of an expression.
    pub fn value(&self, e: &Expr) -> f64 {
        e.value(&self.symbols)
    }
    /// The magnitude of an expression, what is added in front, and no minus before a difference that can be turned.
    pub fn positive(&self, e: &Expr) -> Expr {
        let size = positive_first([in_sense(e.clone(), self.value(e))]);
        let Expr::Minus(_) = &size else { return size };
        match size.factors().upright(&self.symbols).expr() {
            Expr::Minus(_) => size,
            turned => turned,
        }
    }
    /// `left = right`
    pub fn equation(&self, left: &Expr, right: &Expr) -> String {
        format!("{} = {}", self.tex(left), self.tex(right))
    }
    /// The same with this behind it; where it is wider than a line, on several.
    fn equation_in_lines(&self, [left, right]: [&Expr; 2], behind: &str) -> String {
        let line = self.equation(left, right);
        if width(&line) <= WIDEST {
            return format!("{line}{behind}");
        }
        let sides = [left, right].map(|side| side.symbols_in_lines(&self.symbols, LINE).join(r" \\ &\quad "));
        format!(r"{} \\ &= {}{behind}", sides[0], sides[1])
    }
    /// Notes what a quantity is equal to.
    pub fn step(&mut self, symbol: SymbolId, from: Expr) -> SymbolId {
        self.settle(symbol, &from);
        self.derived.push(Step { symbol, from: from.clone() });
        self.steps.push(Step { symbol, from });
        symbol
    }
    /// A new quantity, the first of these names that is free, and what it is equal to. The unit is ASCII.
    pub fn find(&mut self, names: &[impl AsRef<str>], unit: &str, from: impl Into<Expr>) -> SymbolId {
        let symbol = self.named(names, unit);
        self.step(symbol, from.into())
    }
    /// The same, or what is equal to this already. What is a number, as 0, has to bear such a name besides: a velocity and an energy
    /// may both be 0.
    pub fn find_once(&mut self, names: &[impl AsRef<str>], unit: &str, from: Expr) -> SymbolId {
        let number = from.uses().is_empty();
        let named = |s: SymbolId| names.iter().any(|name| name.as_ref() == self.symbols.tex(s));
        let known = self.steps.iter().find(|s| s.from == from && (!number || named(s.symbol)));
        known.map(|s| s.symbol).unwrap_or_else(|| self.find(names, unit, from))
    }
    /// An expression with what was found put in for its symbols, down to the data.
    pub fn expanded(&self, of: &Expr) -> Expr {
        self.steps.iter().rev().fold(of.clone(), |all, step| all.put(step.symbol, &step.from))
    }
    /// The coefficients of unknowns in what is linear in them, each with its place among them, and what is left without them.
    pub fn linear(&mut self, of: &Expr, unknowns: &[SymbolId]) -> (Vec<(usize, f64)>, f64) {
        let before: Vec<f64> = unknowns.iter().map(|s| self.symbols.value(*s)).collect();
        unknowns.iter().for_each(|s| self.symbols.place(*s, 0.0));
        let (none, uses) = (self.value(of), of.uses());
        let mut terms = Vec::new();
        for (column, symbol) in unknowns.iter().enumerate().filter(|(_, s)| uses.contains(s)) {
            self.symbols.place(*symbol, FAR);
            terms.push((column, (self.value(of) - none) / FAR));
            self.symbols.place(*symbol, 0.0);
        }
        unknowns.iter().zip(before).for_each(|(s, x)| self.symbols.place(*s, x));
        (terms, none)
    }
    /// What linear equations, each with both its sides, say of these unknowns, `None` of one that they leave open.
    pub fn solved(&mut self, equations: &[(Expr, Expr)], unknowns: &[SymbolId]) -> Option<Vec<Option<f64>>> {
        let mut system: Linear<f64> = Linear::new(unknowns.len(), 1);
        let more = equations.len() > unknowns.len();
        for (at, (left, right)) in equations.iter().enumerate() {
            let [(one, first), (other, last)] = [left, right].map(|side| self.linear(side, unknowns));
            let opposite = other.into_iter().map(|(column, term)| (column, -term));
            let terms: Vec<(usize, f64)> = one.into_iter().chain(opposite).collect();
            // Of more equations than unknowns least squares take all.
            let own = [(at, 1.0)];
            for (row, share) in if more { &terms } else { &own[..] } {
                terms.iter().for_each(|(column, term)| system.term(*row, *column, share * term));
                system.right(*row, 0, share * (last - first));
            }
        }
        let solution = system.solve().ok()?;
        Some((0..unknowns.len()).map(|i| (!solution.is_open(i)).then(|| solution.get(i, 0))).collect())
    }
    /// Gives unknowns the values that linear equations say; below a size, told for each, a value is 0 but for rounding.
    pub fn settle_all(
        &mut self,
        equations: &[(Expr, Expr)],
        unknowns: &[SymbolId],
        least: impl Fn(usize) -> f64,
    ) -> Result<(), DerivationStop> {
        let solution = self.solved(equations, unknowns).ok_or(Beyond::Unfound)?;
        for (i, (symbol, value)) in unknowns.iter().zip(solution).enumerate() {
            if let Some(value) = value {
                self.symbols.settle(*symbol, if value.abs() < least(i) { 0.0 } else { value }, 0.0);
            }
        }
        Ok(())
    }
    /// These, and all on the way to them that is so.
    pub fn behind(&self, mut wanted: Vec<SymbolId>, is: impl Fn(SymbolId) -> bool) -> Vec<SymbolId> {
        let mut at = 0;
        while let Some(symbol) = wanted.get(at).copied() {
            let uses = self.from(symbol).uses().into_iter();
            let more: Vec<SymbolId> = uses.filter(|s| is(*s) && !wanted.contains(s)).collect();
            wanted.extend(more);
            at += 1;
        }
        wanted
    }
    /// An equation, solved for what is a factor of its terms: term by term, no fraction in a fraction.
    pub fn isolated(&self, (left, right): &(Expr, Expr), factor: impl Into<Expr>) -> Option<Expr> {
        let factor = factor.into();
        let symbols = factor.uses();
        let holds = |e: &Expr| e.uses().iter().any(|s| symbols.contains(s));
        let all = right.terms().into_iter().chain(left.terms().into_iter().map(|t| -t));
        let (own, rest): (Vec<Expr>, Vec<Expr>) = all.filter(|t| *t != ZERO).partition(holds);
        let share = Sum::of(own.iter().map(|t| (-t).factors().per(&factor))).expr();
        let sense = self.value(&share);
        if holds(&share) || sense.abs() <= FLAT {
            return None;
        }
        let share = positive_first([in_sense(share, sense)]).factors().upright(&self.symbols);
        Some(positive_first(rest.into_iter().map(|t| in_sense(t, sense).over(&share))))
    }
    /// Has it been told?
    pub fn is_told(&self, symbol: SymbolId) -> bool {
        self.told.contains(&symbol)
    }
    /// Takes these as told.
    pub fn tell_as_known(&mut self, symbols: Vec<SymbolId>) {
        self.told = symbols;
    }
    /// A sentence that is made already.
    pub fn add(&mut self, sentence: String) {
        self.open.push(sentence);
    }
    /// Markdown that is no paragraph.
    pub fn markdown(&mut self, text: String) {
        self.stop();
        self.out.blocks.push(Block::Markdown(text));
    }
    /// A displayed formula `v = ... = 4.94 m/s`, with this behind it.
    pub fn display(&mut self, symbol: SymbolId, from: &Expr, behind: &str) {
        let line = self.chain(symbol, from);
        self.told.push(symbol);
        // Of several rows it stands behind the first, the formula in symbols.
        self.formula(match line.split_once(r" \\") {
            Some((first, rest)) => format!(r"{first}{behind} \\{rest}"),
            None => format!("{line}{behind}"),
        });
    }
    /// The same of a quantity as it was found.
    pub fn display_step(&mut self, symbol: SymbolId) {
        let from = self.from(symbol);
        self.display(symbol, &from, "");
    }
    /// `$v = ... = 4.94 m/s$`
    pub fn chained(&self, symbol: SymbolId) -> String {
        let line = self.step_of(symbol);
        if line.contains('&') { self.shown(symbol) } else { format!("${line}$") }
    }
    /// What a quantity is equal to: itself where it was not derived.
    pub fn from(&self, symbol: SymbolId) -> Expr {
        let step = self.steps.iter().find(|s| s.symbol == symbol);
        step.map_or_else(|| symbol.into(), |s| s.from.clone())
    }
    /// The chain of a quantity as it was found.
    pub fn step_of(&self, symbol: SymbolId) -> String {
        self.chain(symbol, &self.from(symbol))
    }
    /// Begins a section; its title is the phrase of its id.
    pub fn begin(&mut self, id: &'static str) {
        self.begin_as(id, id);
    }
    /// The same with another title.
    pub fn begin_as(&mut self, id: &'static str, title: &str) {
        self.end();
        let title = self.words.get(&format!("solution.title.{title}"));
        self.out = SolutionSection::new(id, title);
    }
    /// Ends the section; one without content is not there.
    pub fn end(&mut self) {
        self.stop();
        let done = std::mem::replace(&mut self.out, SolutionSection::new("", ""));
        if !done.blocks.is_empty() {
            self.sections.push(done);
        }
    }
    /// Ends the paragraph.
    pub fn stop(&mut self) {
        if !self.open.is_empty() {
            let text = self.open.join(" ");
            self.open.clear();
            self.out.say(text);
        }
    }
    /// A phrase of the solutions.
    pub fn phrase(&self, name: &str, pieces: Pieces) -> String {
        let told: Vec<(&str, String)> =
            pieces.iter().map(|(name, piece)| (*name, piece.told(self))).collect();
        let told: Vec<(&str, &str)> = told.iter().map(|(name, text)| (*name, text.as_str())).collect();
        self.words.say(&format!("solution.{name}"), &told)
    }
    /// A sentence of the paragraph that is being written.
    pub fn say(&mut self, name: &str, pieces: Pieces) {
        let text = self.phrase(name, pieces);
        // What holds of two bodies alike is said once.
        if text.ends_with(':') || !self.open.contains(&text) {
            self.open.push(text);
        }
    }
    /// A displayed formula; lines with an `&` stand under each other.
    pub fn formula(&mut self, tex: String) {
        self.stop();
        self.out.blocks.push(Block::Formula(if tex.contains('&') { aligned(&tex) } else { tex }));
    }
    /// Formulas, as many to a line as it holds.
    pub fn formulas(&mut self, all: impl IntoIterator<Item = String>) {
        for line in packed(all) {
            self.formula(line);
        }
    }
    /// The same; a single short one within the sentence.
    pub fn formulas_or_one(&mut self, all: Vec<String>) {
        self.few_or_lines(all, 1);
    }
    /// The same; so few short ones within the sentence.
    fn few_or_lines(&mut self, all: Vec<String>, few: usize) {
        let short = all.iter().all(|one| width(one) <= WITHIN && !one.contains('&'));
        if !short || all.len() > few {
            self.formulas(all);
        } else if !all.is_empty() {
            let all: Vec<String> = all.iter().map(|one| format!("${one}$")).collect();
            self.add(format!("{}.", all.join(", ")));
        }
    }
    /// Equations, as many to a line as it holds.
    pub fn equations(&mut self, all: &[(Expr, Expr)]) {
        let lines: Vec<String> = all.iter().map(|(l, r)| self.equation_in_lines([l, r], "")).collect();
        self.formulas(lines);
    }
    /// The same; a single short one within the sentence.
    pub fn equations_or_one(&mut self, all: &[(Expr, Expr)]) {
        let lines = all.iter().map(|(l, r)| self.equation_in_lines([l, r], "")).collect();
        self.formulas_or_one(lines);
    }
    /// Work and energy: the works, and what they give; with this behind it where it is one line.
    pub fn tell_balance(&mut self, from_rest: bool, [works, gain]: [&Expr; 2], behind: &str) {
        self.say(if from_rest { "energy.from_rest" } else { "energy.moving" }, &[]);
        self.formula(self.equation_in_lines([works, gain], behind));
    }
    /// The pictures of the scene and of its free bodies.
    pub fn sketch(&mut self) {
        self.begin("sketch");
        let bodies = self.scene.bodies.iter().map(|b| format!("forces-{}", b.name));
        self.out.blocks = ["scene".to_owned()].into_iter().chain(bodies).map(Block::Picture).collect();
    }
    /// Equations of motion, numbered, as many to a line as it holds; of several bodies, which are whose.
    pub fn rows(&mut self, bodies: &[(String, Vec<(Expr, Expr)>)]) {
        let (mut rows, mut whose) = (Vec::new(), Vec::new());
        for (name, equations) in bodies.iter().filter(|(_, equations)| !equations.is_empty()) {
            let (first, last) = (rows.len() + 1, rows.len() + equations.len());
            let each = equations.iter().zip(first..);
            rows.extend(each.map(|((l, r), n)| self.equation_in_lines([l, r], &format!(r" \quad ({n})"))));
            let more = if last > first { format!("–({last})") } else { String::new() };
            whose.push(format!("{name} ({first}){more}"));
        }
        self.formulas(rows);
        if bodies.len() > 1 {
            self.say("motion.of", &[("list", &whose.join(", "))]);
        }
    }
    /// Unknowns and equations of both ways for a quantity, counted alike; what has to be eliminated of the first, and what the second
    /// says nothing about.
    pub fn compare(
        &mut self,
        what: SymbolId,
        [newton, energy]: [&[SymbolId]; 2],
        ties: &[&str],
        [gone, silent]: [&str; 2],
    ) {
        let ties: String = ties.iter().map(|ties| self.phrase(ties, &[])).collect();
        let ties = ties.replace(",,", ",");
        let (many, n) = (self.names(newton), newton.len().to_string());
        self.say("why.newton", &[("what", &what), ("many", &many), ("n", &n), ("ties", &ties)]);
        self.say("why.eliminate", &[("forces", &gone)]);
        let name = if energy.len() == 1 { "why.energy_one" } else { "why.energy" };
        self.say(name, &[("few", &self.names(energy)), ("k", &energy.len().to_string())]);
        self.say("why.price", &[("forces", &silent)]);
        if self.asks(Quantity::T) {
            self.say("why.price_time", &[]);
        }
        self.say("why.ask", &[]);
    }
    /// The share of the kinetic energy that rotation has.
    pub fn say_share(&mut self, share: f64, several: bool) {
        let percent = self.digits(100.0 * share, 2);
        if percent != "100" {
            self.say(if several { "limits.spin_many" } else { "limits.spin" }, &[("percent", &percent)]);
        }
    }
    /// From where it all is seen, if something carries it.
    pub fn say_carried(&mut self, carrier: Option<&Carrying>) {
        let Some(Carrying { speed, acceleration, .. }) = carrier else { return };
        let steady = carrier.is_some_and(|c| c.acceleration == ZERO);
        let name = if steady { "carried.steady" } else { "carried.apparent" };
        self.say(name, &[("speed", speed), ("acceleration", acceleration)]);
    }
    /// The size of a force with these components, or its angle, counter-clockwise from the right.
    pub fn composed(&self, quantity: Quantity, [x, y]: [SymbolId; 2]) -> Expr {
        match quantity {
            Quantity::PinAngle => in_sense(arc_cosine(x / length(x, y)), self.symbols.value(y)),
            _ => length(x, y),
        }
    }
    /// The magnitude of a quantity: itself, or under bars where it is negative.
    pub fn sized(&mut self, symbol: SymbolId) -> SymbolId {
        if self.symbols.value(symbol) >= 0.0 {
            return symbol;
        }
        let name = format!(r"\left|{}\right|", self.symbols.tex(symbol));
        let size = self.symbols.unknown_like(&name, symbol);
        self.symbols.settle_by(size, &magnitude(symbol));
        size
    }
    /// A number with so many figures, as it is printed.
    pub fn digits(&self, value: f64, figures: usize) -> String {
        tex_digits(&shown::significant(value, figures), self.words)
    }
    /// `$12.3 N$`
    pub fn rough(&self, value: f64, unit: &str) -> String {
        format!("${}$", self.with_unit(value, unit))
    }
    fn with_unit(&self, value: f64, unit: &str) -> String {
        let (digits, unit) = (self.digits(value, FIGURES), tex_of(unit));
        if unit.is_empty() { digits } else { format!(r"{digits}\ {unit}") }
    }
    /// An expression in symbols.
    pub fn tex(&self, e: &Expr) -> String {
        e.symbols(&self.symbols)
    }
    /// In a sentence.
    pub fn inline(&self, e: &Expr) -> String {
        format!("${}$", self.tex(e))
    }
    /// `$symbol = e$`
    pub fn stated(&self, symbol: SymbolId, e: &Expr) -> String {
        format!("${}$", self.equation(&symbol.into(), e))
    }
    /// Several symbols.
    pub fn names(&self, all: &[SymbolId]) -> String {
        let list: Vec<String> = all.iter().map(|s| format!("${}$", self.symbols.tex(*s))).collect();
        list.join(", ")
    }
    /// `$e = 12.3 N$`
    pub fn relation(&self, e: &Expr, value: f64, unit: &str) -> String {
        format!("${} = {}$", self.tex(e), self.with_unit(value, unit))
    }
    /// The same with the value of the expression itself.
    pub fn valued(&self, e: &Expr, unit: &str) -> String {
        match e {
            Expr::Symbol(s) => self.shown(*s),
            Expr::Number(..) => self.rough(self.value(e), unit),
            e => self.relation(e, e.value(&self.symbols), unit),
        }
    }
    /// `$v = 4.94 m/s$`
    pub fn shown(&self, s: SymbolId) -> String {
        format!("${} = {}$", self.symbols.tex(s), self.symbols.shown(s))
    }
    /// `v = ... = 4.94 m/s`, with the numbers put in where every detail is wanted.
    pub fn chain(&self, symbol: SymbolId, from: &Expr) -> String {
        let symbols = &self.symbols;
        let (name, letters, value) = (symbols.tex(symbol), from.symbols(symbols), symbols.shown(symbol));
        if from.uses().is_empty() || letters == name {
            return format!("{name} = {value}");
        }
        if self.detail == Detail::Full && from.numbers(symbols) != value {
            let numbers = from.numbers_in_lines(symbols, LINE).join(r" \\ &\quad ");
            return format!(r"{name} &= {letters} \\ &= {numbers} \\ &= {value}");
        }
        let line = format!("{name} = {letters} = {value}");
        if width(&line) <= WIDEST {
            return line;
        }
        let letters = from.symbols_in_lines(symbols, LINE).join(r" \\ &\quad ");
        format!(r"{name} &= {letters} \\ &= {value}")
    }
    /// Tells what was found since: a few short formulas within the sentence, more of them, or wide ones, displayed, as many on a
    /// line as fit.
    pub fn tell_new(&mut self) {
        let new = |s: &&Step| !self.told.contains(&s.symbol);
        let steps: Vec<Step> = self.steps.iter().filter(new).cloned().collect();
        self.skip_new();
        let chains = steps.iter().map(|s| self.chain(s.symbol, &s.from)).collect();
        self.few_or_lines(chains, FEW);
    }
    /// Takes all steps as told.
    pub fn skip_new(&mut self) {
        self.told = self.steps.iter().map(|s| s.symbol).collect();
    }
    /// Takes this one as told.
    pub fn told(&mut self, symbol: SymbolId) {
        self.told.push(symbol);
    }
    /// Tells these alone, in the order in which they were found; all else counts as told.
    pub fn tell(&mut self, symbols: impl IntoIterator<Item = SymbolId>) {
        self.skip_new();
        self.forget(symbols);
        self.tell_new();
    }
    /// Takes these as not told yet.
    pub fn forget(&mut self, symbols: impl IntoIterator<Item = SymbolId>) {
        let symbols: Vec<SymbolId> = symbols.into_iter().collect();
        self.told.retain(|s| !symbols.contains(s));
    }
}

/// Lines that stand under each other at their `&`.
fn aligned(lines: &str) -> String {
    format!(r"\begin{{aligned}} {lines} \end{{aligned}}")
}

/// Formulas side by side, as many to a line as it holds; one of several lines (`&`) stands alone.
pub fn packed(formulas: impl IntoIterator<Item = String>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for formula in formulas {
        match lines.last_mut() {
            Some(line)
                if !line.contains('&')
                    && !formula.contains('&')
                    && width(line) + width(&formula) + 4.0 <= PACKED =>
            {
                line.push_str(r", \qquad ");
                line.push_str(&formula);
            }
            _ => lines.push(formula),
        }
    }
    lines
}
