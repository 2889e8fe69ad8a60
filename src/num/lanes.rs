//! Several doubles side by side, so that a scene is walked once for several sets of data.
//!
//! What is decided on the way is decided for the first set. A set for which it would be decided otherwise has gone *astray*: what its
//! lane says is nothing, and it is to be walked alone. The others come to what doubles alone would come to, up to the order in which
//! equations are eliminated.
use crate::num::{Dd, Real};
use std::cell::{Cell, RefCell};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// How many sets of data are walked at once.
pub const LANES: usize = 12;

thread_local! {
    static DATA: RefCell<Vec<Lanes>> = const { RefCell::new(Vec::new()) };
    static ASTRAY: Cell<u32> = const { Cell::new(0) };
}

/// One double for each set of data.
#[derive(Debug, Clone, Copy)]
pub struct Lanes([f64; LANES]);

/// Runs a computation with these sets of data, at least one and at most [`LANES`]. Says which sets have gone astray, a bit for each.
pub fn side_by_side<R>(sets: &[impl AsRef<[f64]>], run: impl FnOnce(&[f64]) -> R) -> (R, u32) {
    let first = sets[0].as_ref();
    let of = |i: usize| Lanes::from(|lane| sets.get(lane).map_or(first[i], |set| set.as_ref()[i]));
    DATA.with_borrow_mut(|data| {
        data.clear();
        data.extend((0..first.len()).map(of));
    });
    ASTRAY.set(0);
    let result = run(first);
    (result, ASTRAY.get())
}

impl Lanes {
    /// By a plain loop, of which the compiler makes operations on several lanes at once; of [`std::array::from_fn`] it makes calls.
    #[inline(always)]
    fn from(mut of: impl FnMut(usize) -> f64) -> Self {
        let mut lanes = [0.0; LANES];
        for (lane, value) in lanes.iter_mut().enumerate() {
            *value = of(lane);
        }
        Self(lanes)
    }
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::from(|lane| f(self.0[lane]))
    }
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self::from(|lane| f(self.0[lane], other.0[lane]))
    }
    /// The value for one set.
    pub const fn lane(self, lane: usize) -> f64 {
        self.0[lane]
    }
    /// What is decided for the first set; those for which it would be decided otherwise go astray.
    #[inline(always)]
    fn decided<D: Copy + PartialEq>(decide: impl Fn(usize) -> D) -> D {
        let first = decide(0);
        let mut off = 0;
        for lane in 1..LANES {
            off |= u32::from(decide(lane) != first) << lane;
        }
        if off != 0 {
            ASTRAY.set(ASTRAY.get() | off);
        }
        first
    }
}

/// Operations on the numbers of each lane.
macro_rules! lane_by_lane {
    ($($operation:ident $function:ident),*) => {$(
        impl $operation for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $function(self, o: Self) -> Self {
                self.with(o, $operation::$function)
            }
        }
    )*};
}
lane_by_lane!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

/// Methods that make a number of two in each lane.
macro_rules! made_in_each {
    ($($method:ident)*) => {$(
        fn $method(self, other: Self) -> Self {
            self.with(other, Real::$method)
        }
    )*};
}
/// Methods that decide something of two numbers.
macro_rules! decided_between {
    ($($method:ident $kind:ty),*) => {$(
        fn $method(self, other: Self) -> $kind {
            Self::decided(|lane| Real::$method(self.0[lane], other.0[lane]))
        }
    )*};
}

impl Real for Lanes {
    const NOISE: f64 = <f64 as Real>::NOISE;
    const SETTLED: f64 = <f64 as Real>::SETTLED;
    fn datum(value: f64) -> Self {
        Self([value; LANES])
    }
    fn given(index: usize, value: f64) -> Self {
        DATA.with_borrow(|data| data.get(index).copied().unwrap_or_else(|| Self::datum(value)))
    }
    fn constant(value: Dd) -> Self {
        Self::datum(value.hi)
    }
    fn value(self) -> Dd {
        Dd::new(self.f64())
    }
    fn sign(self) -> f64 {
        Self::decided(|lane| Real::sign(self.0[lane]))
    }
    fn root(self) -> Self {
        self.map(Real::root)
    }
    fn scale2(self, e: i32) -> Self {
        self.map(|a| a.scale2(e))
    }
    fn f64(self) -> f64 {
        Self::decided(|lane| self.0[lane])
    }
    fn each(self, f: impl Fn(f64) -> (f64, f64)) -> (Self, Self) {
        let mut others = [0.0; LANES];
        let ones = Self::from(|lane| {
            let (one, other) = f(self.0[lane]);
            others[lane] = other;
            one
        });
        (ones, Self(others))
    }
    fn pairwise(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        self.with(other, f)
    }
    fn leading<R>(decide: impl FnOnce() -> R) -> R {
        let astray = ASTRAY.get();
        let decided = decide();
        ASTRAY.set(astray);
        decided
    }
    fn is_zero(self) -> bool {
        Self::decided(|lane| self.0[lane] == 0.0)
    }
    fn is_nothing(self) -> bool {
        self.0.iter().all(|x| *x == 0.0)
    }
    /// Of the first set: for scales. What is decided by sizes is decided by the methods below.
    fn size(self) -> f64 {
        self.0[0].abs()
    }
    fn is_finite(self) -> bool {
        Self::decided(|lane| self.0[lane].is_finite())
    }
    fn within(self, bound: f64) -> bool {
        Self::decided(|lane| self.0[lane].abs() <= bound)
    }
    fn negligible(self, scale: f64) -> bool {
        self.within(Self::NOISE * scale)
    }
    fn abs(self) -> Self {
        self.map(Real::abs)
    }
    fn cleared(self, scale: f64) -> Self {
        self.map(|a| a.cleared(scale))
    }
    made_in_each!(or apart balance over larger);
    decided_between!(below bool, at_most bool, side f64, status f64);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_for_which_it_would_be_decided_otherwise_goes_astray() {
        let sets = [[1.0, 2.0], [3.0, 2.0], [-1.0, 2.0]];
        let (sum, astray) = side_by_side(&sets, |_| {
            let [x, y] = [0, 1].map(|i| Lanes::given(i, f64::NAN));
            if x.sign() > 0.0 { x + y } else { y }
        });
        assert_eq!([0, 1].map(|lane| sum.lane(lane).to_bits()), [3.0_f64, 5.0].map(f64::to_bits));
        assert_eq!(astray, 0b100);
    }
}
