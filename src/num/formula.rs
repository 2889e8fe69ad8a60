//! Small formulas in reverse Polish order, evaluated without allocation, in any kind of number, and with the same bits everywhere.
use crate::num::{Dd, Real, trig};
use serde::{Deserialize, Serialize};

/// Values that a formula may hold at once; a reader keeps its formulas below that.
pub const STACK: usize = 56;
/// Values that most formulas need at once: clearing room for more would take longer than working them out.
const USUAL: usize = 8;

/// One step: a value is put on the stack, or what lies there is worked on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Step<V> {
    /// A number.
    Number(f64),
    /// The number pi.
    Pi,
    /// A value that is looked up.
    Name(V),
    /// Sum of two.
    Add,
    /// Difference of two.
    Subtract,
    /// Product of two.
    Multiply,
    /// Quotient of two.
    Divide,
    /// The other sign.
    Negate,
    /// A whole power.
    Power(i32),
    /// Square root.
    Sqrt,
    /// Absolute value.
    Abs,
    /// Sine of radians.
    Sin,
    /// Cosine of radians.
    Cos,
    /// Tangent of radians.
    Tan,
    /// Angle of this sine, radians.
    Asin,
    /// Angle of this cosine, radians.
    Acos,
    /// Angle of this tangent, radians.
    Atan,
}

/// A formula; `V` names the values that are looked up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Formula<V> {
    steps: Vec<Step<V>>,
    /// Values that it holds at once.
    depth: usize,
}

impl<V: Copy> Formula<V> {
    /// From its steps.
    pub fn new(steps: Vec<Step<V>>) -> Self {
        let (mut now, mut depth) = (0usize, 0);
        for step in &steps {
            match step {
                Step::Number(_) | Step::Pi | Step::Name(_) => now += 1,
                Step::Add | Step::Subtract | Step::Multiply | Step::Divide => now = now.saturating_sub(1),
                _ => {}
            }
            depth = now.max(depth);
        }
        Self { steps, depth }
    }
    /// Its steps, in order.
    pub fn steps(&self) -> &[Step<V>] {
        &self.steps
    }
    /// The values that it looks up, in order, repeated ones repeatedly.
    pub fn names(&self) -> impl Iterator<Item = V> {
        self.steps.iter().filter_map(|s| if let Step::Name(name) = s { Some(*name) } else { None })
    }
    /// The same formula of other values.
    pub fn map<W>(&self, name: &mut dyn FnMut(V) -> W) -> Formula<W> {
        let steps = self.steps.iter().map(|step| match *step {
            Step::Name(v) => Step::Name(name(v)),
            Step::Number(x) => Step::Number(x),
            Step::Pi => Step::Pi,
            Step::Add => Step::Add,
            Step::Subtract => Step::Subtract,
            Step::Multiply => Step::Multiply,
            Step::Divide => Step::Divide,
            Step::Negate => Step::Negate,
            Step::Power(n) => Step::Power(n),
            Step::Sqrt => Step::Sqrt,
            Step::Abs => Step::Abs,
            Step::Sin => Step::Sin,
            Step::Cos => Step::Cos,
            Step::Tan => Step::Tan,
            Step::Asin => Step::Asin,
            Step::Acos => Step::Acos,
            Step::Atan => Step::Atan,
        });
        Formula { steps: steps.collect(), depth: self.depth }
    }
    /// Its value; NaN where it has no real one, or where a value is NaN.
    pub fn eval<T: Real>(&self, value: &dyn Fn(V) -> T) -> T {
        let bare = |name| (value(name), 0.0);
        if self.depth <= USUAL {
            self.on::<T, USUAL, false>(&bare).0
        } else {
            self.on::<T, STACK, false>(&bare).0
        }
    }
    /// Its value, and the sum of the magnitudes of the terms that make it up; the same is looked up of each name.
    pub fn weighed<T: Real>(&self, value: &dyn Fn(V) -> (T, f64)) -> (T, f64) {
        let (value, scale) = self.on::<T, STACK, true>(value);
        (value, scale.max(value.size()))
    }
    #[inline(always)]
    fn on<T: Real, const N: usize, const WEIGHED: bool>(&self, value: &dyn Fn(V) -> (T, f64)) -> (T, f64) {
        let (mut stack, mut scales) = ([T::zero(); N], [0.0; N]);
        let mut top = 0usize;
        for step in &self.steps {
            let (a, b) = (top.saturating_sub(2), top.saturating_sub(1));
            if WEIGHED {
                scale_of(*step, &stack, &mut scales, top);
            }
            let (at, value) = match *step {
                Step::Number(x) => (top, number(x)),
                Step::Pi => (top, T::constant(Dd::PI)),
                Step::Name(name) => {
                    let (value, scale) = value(name);
                    if WEIGHED {
                        scales[top] = scale;
                    }
                    (top, value)
                }
                Step::Negate => (b, -stack[b]),
                // What is known to no radius decides nothing here: its root has none either.
                Step::Sqrt if stack[b].f64() < 0.0 => (b, T::of(f64::NAN)),
                Step::Sqrt => (b, stack[b].root()),
                Step::Abs => (b, stack[b].abs()),
                Step::Sin => (b, sine_cosine(stack[b]).0),
                Step::Cos => (b, sine_cosine(stack[b]).1),
                Step::Tan => {
                    let (sine, cosine) = sine_cosine(stack[b]);
                    (b, sine / cosine)
                }
                Step::Asin | Step::Acos => {
                    let (x, one) = (stack[b], T::of(1.0));
                    // Beyond 1 there is no angle, and about 1 no enclosure of one.
                    let other = (one - x) * (one + x);
                    let other = if other.f64() < 0.0 { T::of(f64::NAN) } else { other.root() };
                    let [y, x] = if matches!(step, Step::Asin) { [x, other] } else { [other, x] };
                    (b, trig::angle(y, x))
                }
                Step::Atan => (b, trig::angle(stack[b], T::of(1.0))),
                Step::Power(n) => (b, power(stack[b], n)),
                Step::Add => (a, stack[a] + stack[b]),
                Step::Subtract => (a, stack[a] - stack[b]),
                Step::Multiply => (a, stack[a] * stack[b]),
                Step::Divide => (a, stack[a] / stack[b]),
            };
            stack[at] = value;
            top = at + 1;
        }
        (stack[0], scales[0])
    }
}

/// The scale of the terms after a step, from the values before it.
fn scale_of<T: Real, V>(step: Step<V>, stack: &[T], scales: &mut [f64], top: usize) {
    let (a, b) = (top.saturating_sub(2), top.saturating_sub(1));
    let size = |at: usize| stack[at].size();
    let scale = |at: usize| scales[at].max(stack[at].size());
    match step {
        Step::Number(x) => scales[top] = x.abs(),
        Step::Pi => scales[top] = Dd::PI.hi,
        Step::Name(_) | Step::Negate | Step::Abs => {}
        Step::Sqrt => scales[b] = scale(b).sqrt(),
        Step::Sin | Step::Cos | Step::Asin | Step::Acos | Step::Atan => scales[b] = 1.0,
        Step::Tan => scales[b] = sine_cosine(stack[b]).1.size().recip(),
        Step::Power(n) => scales[b] = scale(b) * power(size(b), n - 1),
        Step::Add | Step::Subtract => scales[a] = scale(a) + scale(b),
        Step::Multiply => scales[a] = (scale(a) * size(b)).max(size(a) * scale(b)),
        Step::Divide => scales[a] = scale(a) / size(b),
    }
}

/// A number as it is written: a whole one is exact, a decimal the nearest double to it.
fn number<T: Real>(x: f64) -> T {
    if x.fract() == 0.0 { T::of(x) } else { T::datum(x) }
}

fn sine_cosine<T: Real>(radians: T) -> (T, T) {
    if radians.is_finite() { trig::turn(radians) } else { (T::of(f64::NAN), T::of(f64::NAN)) }
}

/// `x^n` by repeated multiplication, the same bits everywhere.
fn power<T: Real>(x: T, n: i32) -> T {
    let mut product = T::of(1.0);
    for _ in 0..n.unsigned_abs() {
        product = product * x;
    }
    if n < 0 { T::of(1.0) / product } else { product }
}
