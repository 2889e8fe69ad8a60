//! Values of expressions, and how far rounding on the way may have moved them.
use crate::num::trig;
use crate::solution::expr::{Expr, Function, ONE, SymbolId};
use crate::solution::symbols::Symbols;

/// Degrees in a radian, and radians in a degree.
const DEGREES: (Expr, f64) = (Expr::Number(5_729_577_951_308, 100_000_000_000), std::f64::consts::PI / 180.0);
/// Below this share of its terms a sum is what rounding leaves of 0.
const NOTHING: f64 = 1e-15;

impl Symbols<'_> {
    /// Gives an unknown the value of an expression.
    pub fn settle_by(&mut self, symbol: SymbolId, from: &Expr) {
        let (value, doubt) = (from.value(self), from.doubt(self));
        self.settle(symbol, value, doubt);
    }
}

impl Expr {
    /// Its value, from the full values of the quantities; angles in degrees where the quantities has them so.
    pub fn value(&self, symbols: &Symbols) -> f64 {
        match self {
            #[expect(clippy::cast_precision_loss, reason = "numbers of formulas are small")]
            Self::Number(over, under) => *over as f64 / *under as f64,
            Self::Symbol(s) => symbols.value(*s),
            Self::Minus(inner) => -inner.value(symbols),
            Self::Sum(terms) => {
                let terms = terms.iter().map(|t| t.value(symbols));
                let (all, sizes) = terms.fold((0.0, 0.0), |(all, sizes), t| (all + t, sizes + t.abs()));
                if all.abs() <= NOTHING * sizes { 0.0 } else { all }
            }
            Self::Product(factors) => factors.iter().map(|f| f.value(symbols)).product(),
            Self::Quotient(over, under) => over.value(symbols) / under.value(symbols),
            Self::Power(base, n) => {
                let base = base.value(symbols);
                (0..*n).map(|_| base).product()
            }
            Self::Root(inner) => inner.value(symbols).sqrt(),
            Self::Of(function, inner) => {
                let x = inner.value(symbols);
                let angle = |x: f64| match inner.in_degrees(symbols) {
                    true => trig::sin_cos_of_degrees(x),
                    false => trig::turn(x),
                };
                match function {
                    Function::Sine => angle(x).0,
                    Function::Cosine => angle(x).1,
                    Function::Magnitude => x.abs(),
                    Function::ArcCosine => {
                        let across: f64 = ((1.0 - x) * (1.0 + x)).max(0.0);
                        trig::atan2(across.sqrt(), x)
                    }
                    Function::ArcTangent => trig::atan2(x, 1.0),
                }
            }
        }
    }

    /// How far its value may be off because the quantities in it were rounded, to first order.
    pub fn doubt(&self, symbols: &Symbols) -> f64 {
        let doubtful = self.uses().into_iter().filter(|s| symbols.doubt(*s) != 0.0);
        let each = doubtful.map(|s| {
            let (per, unit) = if symbols.is_degrees(s) { DEGREES } else { (ONE, 1.0) };
            let off = self.slope(s, &per).value(symbols).abs() * unit * symbols.doubt(s);
            // At a corner of a magnitude nothing is known of it.
            if off.is_nan() { 0.0 } else { off }
        });
        each.sum()
    }

    /// Does it hold an angle that the quantities keeps in degrees?
    fn in_degrees(&self, symbols: &Symbols) -> bool {
        match self {
            Self::Symbol(s) => symbols.is_degrees(*s),
            // An angle over 180 degrees, times pi, is one in radians.
            Self::Quotient(over, under) => over.in_degrees(symbols) && !under.in_degrees(symbols),
            Self::Of(function, _) if *function != Function::Magnitude => false,
            _ => self.parts().into_iter().any(|part| part.in_degrees(symbols)),
        }
    }
}
