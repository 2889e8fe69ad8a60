//! Reads the formulas of a worked solution and solves them again in intervals: LaTeX in, faults out.
use slipstick::num::trig;
use std::collections::BTreeMap;

/// All numbers between two.
#[derive(Debug, Clone, Copy)]
pub struct Interval {
    low: f64,
    high: f64,
}

/// Widening by more than what doubles lose in one operation.
const LOSS: f64 = 1e-13;

impl Interval {
    fn new(low: f64, high: f64) -> Self {
        let slack = LOSS * low.abs().max(high.abs());
        Self { low: low - slack, high: high + slack }
    }
    fn of(values: &[f64]) -> Self {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self::new(low, high)
    }
    fn plus(self, o: Self) -> Self {
        Self::new(self.low + o.low, self.high + o.high)
    }
    fn opposite(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
    fn times(self, o: Self) -> Self {
        Self::of(&[self.low * o.low, self.low * o.high, self.high * o.low, self.high * o.high])
    }
    fn per(self, o: Self) -> Option<Self> {
        if o.low <= 0.0 && o.high >= 0.0 {
            return None;
        }
        Some(Self::of(&[self.low / o.low, self.low / o.high, self.high / o.low, self.high / o.high]))
    }
    fn power(self, n: u32) -> Self {
        let one = |x: f64| (0..n).map(|_| x).product::<f64>();
        let ends = Self::of(&[one(self.low), one(self.high)]);
        if n.is_multiple_of(2) && self.low <= 0.0 && self.high >= 0.0 {
            Self { low: 0.0, ..ends }
        } else {
            ends
        }
    }
    fn root(self) -> Option<Self> {
        (self.high >= 0.0).then(|| Self::new(self.low.max(0.0).sqrt(), self.high.sqrt()))
    }
    fn size(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            self.opposite()
        } else {
            Self { low: 0.0, high: self.high.max(-self.low) }
        }
    }
    /// Monotone or nearly so: the ends, and the extremes in between.
    fn wave(self, f: impl Fn(f64) -> f64, first: f64) -> Self {
        let mut values = vec![f(self.low), f(self.high)];
        let turn = std::f64::consts::PI;
        let mut k = ((self.low - first) / turn).ceil();
        while first + k * turn <= self.high {
            values.push(f(first + k * turn));
            k += 1.0;
        }
        Self::of(&values)
    }
    fn meets(self, o: Self) -> bool {
        self.low <= o.high && o.low <= self.high
    }
}

/// How much was checked.
#[derive(Debug, Default, Clone, Copy)]
pub struct Counts {
    /// Lines with numbers.
    pub numbers: u32,
    /// Lines in symbols whose result is printed.
    pub symbols: u32,
    /// Equations between quantities that are all known at the end.
    pub relations: u32,
    /// Values given in a sentence.
    pub repeated: u32,
}

/// The displayed formulas of a text.
pub fn displayed(markdown: &str) -> Vec<String> {
    markdown.split("$$").skip(1).step_by(2).map(str::to_owned).collect()
}

/// The lines of a formula.
pub fn lines(formula: &str) -> Vec<String> {
    inner(formula).split(r" \\ ").map(str::to_owned).collect()
}

fn inner(formula: &str) -> &str {
    let formula = formula.strip_prefix(r"\begin{aligned} ").unwrap_or(formula);
    formula.strip_suffix(r" \end{aligned}").unwrap_or(formula)
}

/// Equations of a formula, each a chain of expressions that are said to be equal.
fn chains(formula: &str) -> Vec<Vec<String>> {
    let mut chains: Vec<Vec<String>> = Vec::new();
    for line in lines(formula) {
        if let Some(more) = line.strip_prefix(r"&\quad ") {
            if let Some(last) = chains.last_mut().and_then(|c| c.last_mut()) {
                last.push(' ');
                last.push_str(more);
            }
            continue;
        }
        let line = line.split(r" \quad (").next().unwrap_or("").to_owned();
        let pieces: Vec<String> = line.replace('&', "").split('=').map(|p| p.trim().to_owned()).collect();
        match (pieces.first().is_some_and(String::is_empty), chains.last_mut()) {
            (true, Some(chain)) => chain.extend(pieces.into_iter().skip(1)),
            _ => chains.push(pieces),
        }
    }
    chains
}

/// A reader of one expression.
struct Reader<'t> {
    rest: &'t str,
    known: &'t BTreeMap<String, Interval>,
    /// Digits with units that are exact.
    data: &'t [String],
    digits: bool,
}

impl Reader<'_> {
    fn skip(&mut self) {
        loop {
            let before = self.rest;
            self.rest = self.rest.trim_start();
            for space in [r"\,", r"\quad"] {
                self.rest = self.rest.strip_prefix(space).unwrap_or(self.rest);
            }
            if self.rest == before {
                return;
            }
        }
    }
    fn take(&mut self, token: &str) -> bool {
        self.skip();
        match self.rest.strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }
    fn sum(&mut self) -> Option<Interval> {
        let mut sum = if self.take("-") { self.product()?.opposite() } else { self.product()? };
        loop {
            if self.take("+") {
                sum = sum.plus(self.product()?);
            } else if self.take("-") {
                sum = sum.plus(self.product()?.opposite());
            } else {
                return Some(sum);
            }
        }
    }
    fn product(&mut self) -> Option<Interval> {
        let mut product = self.factor()?;
        loop {
            let _ = self.take(r"\cdot");
            self.skip();
            let ends = self.rest.is_empty()
                || ["+", "-", ")", r"\right", "}", "="].iter().any(|e| self.rest.starts_with(e));
            if ends {
                return Some(product);
            }
            product = product.times(self.factor()?);
        }
    }
    fn factor(&mut self) -> Option<Interval> {
        let base = self.base()?;
        self.raised(base)
    }
    fn raised(&mut self, base: Interval) -> Option<Interval> {
        let Some(rest) = self.rest.strip_prefix("^{") else { return Some(base) };
        let (n, rest) = rest.split_once('}')?;
        self.rest = rest;
        Some(base.power(n.parse().ok()?))
    }
    fn group(&mut self) -> Option<Interval> {
        self.take("{").then_some(())?;
        let value = self.sum()?;
        self.take("}").then_some(value)
    }
    fn base(&mut self) -> Option<Interval> {
        if self.take(r"\left(") {
            let value = self.sum()?;
            return self.take(r"\right)").then_some(value);
        }
        if self.take(r"\left|") {
            let value = self.sum()?;
            return self.take(r"\right|").then_some(value.size());
        }
        if self.take("(") {
            let value = self.sum()?;
            return self.take(")").then_some(value);
        }
        if self.take(r"\tfrac") || self.take(r"\frac") {
            let over = self.group()?;
            return over.per(self.group()?);
        }
        if self.take(r"\sqrt") {
            return self.group()?.root();
        }
        if self.take(r"\sin") {
            let argument = self.factor()?;
            return Some(argument.wave(|x| trig::turn(x).0, std::f64::consts::FRAC_PI_2));
        }
        if self.take(r"\arccos") {
            // Falling, and steep at its ends.
            let x = self.factor()?;
            let angle = |x: f64| x.clamp(-1.0, 1.0).acos();
            return Some(Interval::new(angle(x.high), angle(x.low)));
        }
        if self.take(r"\pi") {
            return Some(Interval::new(std::f64::consts::PI, std::f64::consts::PI));
        }
        if self.take(r"\cos") {
            return Some(self.factor()?.wave(|x| trig::turn(x).1, 0.0));
        }
        self.skip();
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            return self.number();
        }
        // The longest symbol that stands here.
        let name = self.known.keys().filter(|k| self.rest.starts_with(k.as_str())).max_by_key(|k| k.len())?;
        let rest = &self.rest[name.len()..];
        // A longer one that is not known is another one.
        if rest.starts_with('_') {
            return None;
        }
        self.rest = rest;
        self.known.get(name).copied()
    }
    fn number(&mut self) -> Option<Interval> {
        let start = self.rest;
        let length = start.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(start.len());
        let digits = &start[..length];
        self.rest = &start[length..];
        let mut scale = 1.0;
        if let Some(rest) = self.rest.strip_prefix(r" \cdot 10^{") {
            let (n, rest) = rest.split_once('}')?;
            scale = format!("1e{n}").parse().ok()?;
            self.rest = rest;
        }
        let degrees = self.rest.starts_with(r"^\circ");
        if degrees {
            self.rest = &self.rest[r"^\circ".len()..];
        } else if self.rest.starts_with(r"\ ") {
            self.rest = &self.rest[2..];
            while let Some(rest) = self.rest.strip_prefix(r"\mathrm{") {
                self.rest = rest.split_once('}')?.1;
                if let Some(rest) = self.rest.strip_prefix("^{") {
                    self.rest = rest.split_once('}')?.1;
                }
                for between in ["/", r"\,"] {
                    if let Some(rest) = self.rest.strip_prefix(between)
                        && rest.starts_with(r"\mathrm")
                    {
                        self.rest = rest;
                    }
                }
            }
        }
        let written = &start[..start.len() - self.rest.len()];
        let value: f64 = digits.parse::<f64>().ok()? * scale;
        // A bare whole number belongs to the formula.
        let formula = written == digits && !digits.contains('.');
        self.digits |= !formula;
        let decimals = digits.split_once('.').map_or(0, |(_, d)| d.len());
        // A half turn is what it is, and nothing is nothing.
        let half = if formula
            || digits == "0"
            || written == r"180^\circ"
            || self.data.iter().any(|d| d == written)
        {
            0.0
        } else if decimals == 0 {
            // Zeros at the end of a whole number may be no figures.
            let zeros = digits.len() - digits.trim_end_matches('0').len();
            0.5 * scale * (0..zeros).map(|_| 10.0).product::<f64>()
        } else {
            0.5 * scale / (0..decimals).map(|_| 10.0).product::<f64>()
        };
        let turn = if degrees { std::f64::consts::PI / 180.0 } else { 1.0 };
        Some(Interval::new((value - half) * turn, (value + half) * turn))
    }
}

/// Value of an expression, and whether it has numbers of its own; `None` if it is not all known.
fn evaluate(text: &str, known: &BTreeMap<String, Interval>, data: &[String]) -> Option<(Interval, bool)> {
    let mut reader = Reader { rest: text, known, data, digits: false };
    let value = reader.sum()?;
    reader.skip();
    reader.rest.is_empty().then_some((value, reader.digits))
}

/// Is it one symbol?
fn is_name(text: &str) -> bool {
    let plain = text.replace(r"\Delta ", "").replace(r"\mathrm", "").replace(r"\dot", "");
    let command = plain.strip_prefix('\\').unwrap_or(&plain);
    let head = command.split('_').next().unwrap_or("");
    let letters = head.trim_matches(|c| c == '{' || c == '}');
    let letters = letters.strip_prefix('\\').unwrap_or(letters);
    let short = if plain.starts_with('\\') || text.contains(r"\dot") { 12 } else { 1 };
    !letters.is_empty()
        && letters.len() <= short
        && letters.chars().all(|c| c.is_ascii_alphabetic())
        && !plain.contains([' ', '+', '^'])
        && !text.contains(r"\,")
        && !text.starts_with(r"\frac")
        && !text.starts_with(r"\sqrt")
        && !text.starts_with(r"\left")
        && !text.starts_with(r"\int")
}

/// All formulas in the order of the text, those of answers and wrong methods left out; the first list is that of the data.
fn formulas(markdown: &str) -> (Vec<String>, Vec<String>) {
    let told = |l: &&str| !l.starts_with("> ") && !l.starts_with("- ") && !l.starts_with("![");
    let text: Vec<&str> = markdown.lines().filter(told).collect();
    let (data, rest): (Vec<&str>, Vec<&str>) =
        text.iter().partition(|l| l.starts_with("**Data") || l.starts_with("**Gegeben"));
    let math = |lines: Vec<&str>| -> Vec<String> {
        let text = lines.join("\n").replace("$$", "$");
        text.split('$').skip(1).step_by(2).map(str::to_owned).collect()
    };
    (math(data), math(rest))
}

/// Solves every printed equation again; says which do not hold.
pub fn check(markdown: &str, counts: &mut Counts) -> Vec<String> {
    let mut faults = Vec::new();
    let mut known: BTreeMap<String, Interval> = BTreeMap::new();
    let mut data: Vec<String> = Vec::new();
    let (given, formulas) = formulas(markdown);
    // The data, `R = 200 mm = 0.200 m`.
    for formula in given {
        let pieces: Vec<&str> = formula.split(" = ").collect();
        let (Some(name), Some(value)) = (pieces.first(), pieces.last()) else { continue };
        // Digits in SI are exact where they are those that were drawn, moved by a power of ten.
        let moved = |text: &str| {
            let digits: String =
                text.split('\\').next().unwrap_or("").chars().filter(char::is_ascii_digit).collect();
            digits.trim_matches('0').to_owned()
        };
        if pieces.len() < 3 || moved(pieces[1]) == moved(value) {
            data.push(value.trim_start_matches('-').to_owned());
        }
        match evaluate(value, &known, &data) {
            Some((value, _)) => {
                known.insert((*name).to_owned(), value);
            }
            None => faults.push(format!("not read: {formula}")),
        }
    }
    let chains: Vec<Vec<String>> = formulas
        .iter()
        .flat_map(|f| {
            f.split(r"\qquad ").flat_map(|part| chains(part.trim_end_matches(", "))).collect::<Vec<_>>()
        })
        .collect();
    let mut later = Vec::new();
    for chain in &chains {
        let Some((result, steps)) = chain.split_last() else { continue };
        let Some((value, true)) = evaluate(result, &BTreeMap::new(), &data) else { continue };
        let named = steps.first().filter(|n| is_name(n));
        for step in &steps[usize::from(named.is_some())..] {
            match evaluate(step, &known, &data) {
                Some((found, digits)) => {
                    if named.is_none() {
                        counts.repeated += 1;
                    } else if digits {
                        counts.numbers += 1;
                    } else {
                        counts.symbols += 1;
                    }
                    if !found.meets(value) {
                        faults.push(format!("{step} gives {found:?}, printed: {}", chain.join(" = ")));
                    }
                }
                // It may use what is found further on.
                None => later.push((step, value, chain)),
            }
        }
        if let Some(name) = named {
            match known.get(name) {
                Some(before) if steps.len() == 1 => {
                    counts.repeated += 1;
                    if !before.meets(value) {
                        faults.push(format!("{name} = {result}, it was {before:?}"));
                    }
                }
                _ => {
                    known.insert(name.clone(), value);
                }
            }
        }
    }
    for (step, value, chain) in later {
        match evaluate(step, &known, &data) {
            Some((found, _)) if found.meets(value) => counts.relations += 1,
            Some((found, _)) => faults.push(format!("{step} gives {found:?}: {}", chain.join(" = "))),
            // What stands first may be a name of its own.
            None if chain.first() == Some(step) => {}
            None => faults.push(format!("not read: {step} in {}", chain.join(" = "))),
        }
    }
    // With everything known, what was an equation for unknowns has to hold.
    for chain in &chains {
        let values: Vec<Option<(Interval, bool)>> =
            chain.iter().map(|piece| evaluate(piece, &known, &data)).collect();
        for pair in values.windows(2) {
            if let [Some((left, false)), Some((right, false))] = pair {
                counts.relations += 1;
                if !left.meets(*right) {
                    faults.push(format!("{left:?} is not {right:?}: {}", chain.join(" = ")));
                }
            }
        }
    }
    faults
}

/// Places of results that follow from a step, and what to write there instead: the third significant digit changed.
pub fn mutations(markdown: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut at = 0;
    // Displayed formulas begin and end with one sign as the others do; places stay what they are.
    for (i, formula) in markdown.replace("$$", "$\u{1}").split('$').enumerate() {
        let start = at;
        at += formula.len() + 1;
        let steps = formula.matches('=').count();
        // A datum in two units is no step.
        let datum = formula
            .split('=')
            .nth(1)
            .is_some_and(|p| p.trim_start().starts_with(|c: char| c.is_ascii_digit()));
        let Some(equals) = formula.rfind("= ").filter(|_| i % 2 == 1 && steps > 1 && !datum) else {
            continue;
        };
        let rest = formula[equals + 2..].split(r" \quad (").next().unwrap_or("");
        let end = rest.find(r" \end{aligned}").unwrap_or(rest.len());
        let digits = rest.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit());
        if !digits || rest[..end].contains(['(', '+']) || rest[..end].contains(r"\,") {
            continue;
        }
        let mut significant = 0;
        for (j, c) in rest[..end].char_indices() {
            if c.is_ascii_digit() && (significant > 0 || c != '0') {
                significant += 1;
            }
            if significant == 3 {
                let other = if c == '9' { '3' } else { '9' };
                found.push((start + equals + 2 + j, other.to_string()));
                break;
            }
        }
    }
    found
}
