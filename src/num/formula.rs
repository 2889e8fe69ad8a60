//! Small formulas in reverse Polish order, evaluated without allocation and with the same bits everywhere.
use crate::num::trig;

/// Degrees in a radian.
const DEGREES: f64 = 180.0 / std::f64::consts::PI;

/// Values that a formula may hold at once; a reader keeps its formulas below that.
pub const STACK: usize = 56;
/// Values that most formulas need at once: clearing room for more would take longer than working them out.
const USUAL: usize = 8;

/// One step: a value is put on the stack, or what lies there is worked on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step<V> {
    /// A number.
    Number(f64),
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
}

/// A formula; `V` names the values that are looked up.
#[derive(Debug, Clone, PartialEq)]
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
                Step::Number(_) | Step::Name(_) => now += 1,
                Step::Add | Step::Subtract | Step::Multiply | Step::Divide => now = now.saturating_sub(1),
                _ => {}
            }
            depth = now.max(depth);
        }
        Self { steps, depth }
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
        });
        Formula { steps: steps.collect(), depth: self.depth }
    }
    /// Its value; NaN where it has no real one, or where a value is NaN.
    pub fn eval(&self, value: &dyn Fn(V) -> f64) -> f64 {
        if self.depth <= USUAL {
            self.on(&mut [0.0; USUAL], value)
        } else {
            self.on(&mut [0.0; STACK], value)
        }
    }
    #[inline(always)]
    fn on<const N: usize>(&self, stack: &mut [f64; N], value: &dyn Fn(V) -> f64) -> f64 {
        let mut top = 0usize;
        for step in &self.steps {
            match *step {
                Step::Number(x) => top = push(stack, top, x),
                Step::Name(name) => top = push(stack, top, value(name)),
                Step::Negate => stack[top - 1] = -stack[top - 1],
                Step::Sqrt => stack[top - 1] = stack[top - 1].sqrt(),
                Step::Abs => stack[top - 1] = stack[top - 1].abs(),
                // Radians inside; sines are taken of degrees, which the portable functions reduce exactly.
                Step::Sin => stack[top - 1] = trig::sin_cos_degrees(stack[top - 1] * DEGREES).0.hi,
                Step::Cos => stack[top - 1] = trig::sin_cos_degrees(stack[top - 1] * DEGREES).1.hi,
                Step::Power(n) => stack[top - 1] = power(stack[top - 1], n),
                Step::Add | Step::Subtract | Step::Multiply | Step::Divide => {
                    let b = stack[top - 1];
                    let a = stack[top - 2];
                    top -= 1;
                    stack[top - 1] = match step {
                        Step::Add => a + b,
                        Step::Subtract => a - b,
                        Step::Multiply => a * b,
                        _ => a / b,
                    };
                }
            }
        }
        stack[0]
    }
}

fn push(stack: &mut [f64], top: usize, x: f64) -> usize {
    stack[top] = x;
    top + 1
}

/// `x^n` by repeated multiplication, the same bits everywhere.
fn power(x: f64, n: i32) -> f64 {
    let mut product = 1.0;
    for _ in 0..n.unsigned_abs() {
        product *= x;
    }
    if n < 0 { 1.0 / product } else { product }
}
