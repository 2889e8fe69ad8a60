//! Values of expressions, and how far rounding on the way may have moved them.
use crate::num::trig;
use crate::solution::expr::{Expr, Function, SymbolId};
use crate::solution::symbols::Symbols;

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
            Self::Sum(terms) => terms.iter().map(|t| t.value(symbols)).sum(),
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
                    false => trig::sin_cos(x),
                };
                match function {
                    Function::Sine => angle(x).0,
                    Function::Cosine => angle(x).1,
                    Function::Magnitude => x.abs(),
                    Function::ArcCosine => {
                        let across: f64 = ((1.0 - x) * (1.0 + x)).max(0.0);
                        trig::atan2(across.sqrt(), x)
                    }
                }
            }
        }
    }

    /// How far its value may be off because the quantities in it were rounded, to first order.
    pub fn doubt(&self, symbols: &Symbols) -> f64 {
        let of = |e: &Self| (e.value(symbols), e.doubt(symbols));
        match self {
            Self::Number(..) => 0.0,
            Self::Symbol(s) => symbols.doubt(*s),
            Self::Minus(inner) | Self::Of(Function::Magnitude, inner) => inner.doubt(symbols),
            Self::Sum(terms) => terms.iter().map(|t| t.doubt(symbols)).sum(),
            Self::Product(factors) => {
                let share = |(x, doubt): (f64, f64)| if doubt == 0.0 { 0.0 } else { (doubt / x).abs() };
                let size = self.value(symbols).abs();
                let off = size * factors.iter().map(|f| share(of(f))).sum::<f64>();
                // A factor 0: what the others make of its doubt is not worth a line.
                if off.is_finite() { off } else { 0.0 }
            }
            Self::Quotient(over, under) => {
                let ((x, dx), (y, dy)) = (of(over), of(under));
                (dx + (x / y).abs() * dy) / y.abs()
            }
            Self::Power(base, n) => {
                let (x, doubt) = of(base);
                f64::from(*n) * (1..*n).map(|_| x.abs()).product::<f64>() * doubt
            }
            Self::Root(inner) => {
                let (x, doubt) = of(inner);
                if doubt == 0.0 { 0.0 } else { doubt / (2.0 * x.abs().sqrt()) }
            }
            Self::Of(Function::ArcCosine, inner) => {
                let (x, doubt) = of(inner);
                if doubt == 0.0 { 0.0 } else { doubt / (1.0 - x * x).max(doubt).sqrt() }
            }
            // The sine and the cosine move at most as much as the angle.
            Self::Of(Function::Sine | Function::Cosine, inner) => {
                let per = if inner.in_degrees(symbols) { std::f64::consts::PI / 180.0 } else { 1.0 };
                inner.doubt(symbols) * per
            }
        }
    }

    /// Does it hold an angle that the quantities keeps in degrees?
    fn in_degrees(&self, symbols: &Symbols) -> bool {
        match self {
            Self::Symbol(s) => symbols.is_degrees(*s),
            _ => self.parts().into_iter().any(|part| part.in_degrees(symbols)),
        }
    }
}
