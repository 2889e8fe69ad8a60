//! Which data are a scene at all (PHYSICS: admissible data). NaN passes no test here.
use crate::num::{Dd, Real, trig};
use crate::scene::{Num, Place, Ray, Scene, StrutEnd, given};

/// What a datum must satisfy to be part of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// Finite.
    Finite,
    /// Finite and > 0.
    Positive,
    /// Finite and >= 0.
    NotNegative,
    /// From 0 to 90 degrees.
    Slope,
    /// From -360 to 360 degrees.
    Angle,
    /// An angle that is reached, in [`TURNS`] at most.
    Turns,
    /// A stretch that is not above the length of the spring at the start.
    Stretch,
    /// 0, or of a magnitude from [`LEAST`] to [`MOST`]: beyond, products of a few data leave the doubles.
    Range,
    /// Not above another datum (hub <= rim, mu_k <= mu_s).
    NotAbove(Num),
    /// Below the radius of the cylinder within which a solid body moves.
    Inside(Num),
    /// Not the radius of the cylinder within which a body, or which within a body, moves: it would touch it all around.
    Unlike(Num),
}

impl Rule {
    /// The other number that it compares with.
    pub const fn bound(self) -> Option<Num> {
        match self {
            Self::NotAbove(other) | Self::Inside(other) | Self::Unlike(other) => Some(other),
            _ => None,
        }
    }
}

/// So many turns does a body make at most up to an angle that it reaches.
pub const TURNS: f64 = 20.0;
/// The least magnitude of a datum that is not 0, SI.
pub const LEAST: f64 = 1e-150;
/// The greatest magnitude of a datum, SI.
pub const MOST: f64 = 1e150;

/// One datum that is no part of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Inadmissible {
    /// Which.
    pub datum: Num,
    /// Its value.
    pub value: f64,
    /// The rule that it breaks.
    pub rule: Rule,
    /// Of an expression the data in it, by index, with their values, for messages.
    pub of: Vec<(usize, f64)>,
}

/// Every number of the scene with each rule that it keeps, in the order of the scene.
pub fn rules(scene: &Scene, tell: &mut dyn FnMut(Num, Rule)) {
    given::read::all(scene, &mut |number, (_, rules)| rules.iter().for_each(|rule| tell(*number, *rule)));
    scene.formulas.below.iter().for_each(|(own, other)| tell(*own, Rule::NotAbove(*other)));
}

/// Is the spring of the pinned body at the start at least as long as it is stretched there?
fn fits(scene: &Scene, of: &impl Fn(Num) -> f64, stretch: f64) -> bool {
    let (Some((_, planar)), [strut]) = (scene.pinned(), &scene.struts[..]) else { return true };
    let (StrutEnd::Ground([x, y]), Some(start)) = (strut.to, planar.start_deg) else { return true };
    let Some((_, [Place::At(at), _])) = planar.points.get(strut.at.point) else { return true };
    let (sine, cosine) = trig::sin_cos_degrees(of(start));
    let up = if planar.from == Ray::Up { cosine } else { -cosine };
    let at = Dd::new(of(*at));
    let (dx, dy) = (Dd::new(of(x)) - at * sine, Dd::new(of(y)) - at * up);
    let (long, stretch) = (dx * dx + dy * dy, Dd::product(stretch, stretch));
    // What is not finite has its own finding.
    !long.is_finite() || !Real::is_finite(stretch) || stretch.at_most(long)
}

/// Does a number of the scene keep its rule?
pub fn holds(scene: &Scene, data: &[f64], datum: Num, rule: Rule) -> bool {
    let of = |n: Num| scene.value(n, data);
    let value = of(datum);
    // A value that is not even finite has its own finding.
    let beside = |other: Num, keeps: fn(f64, f64) -> bool| {
        !value.is_finite() || !of(other).is_finite() || keeps(value, of(other))
    };
    match rule {
        Rule::Stretch => fits(scene, &of, value),
        Rule::NotAbove(other) => beside(other, |own, other| own <= other),
        Rule::Inside(other) => beside(other, |own, other| own < other),
        Rule::Unlike(other) => beside(other, |own, other| own.total_cmp(&other).is_ne()),
        _ => fits_rule(value, rule),
    }
}

/// Does a value keep a rule that is about it alone?
pub fn fits_rule(value: f64, rule: Rule) -> bool {
    match rule {
        Rule::Range => value == 0.0 || !value.is_finite() || (LEAST..=MOST).contains(&value.abs()),
        Rule::Finite => value.is_finite(),
        Rule::Positive => value.is_finite() && value > 0.0,
        Rule::NotNegative => value.is_finite() && value >= 0.0,
        Rule::Slope => (0.0..=90.0).contains(&value),
        Rule::Angle => (-360.0..=360.0).contains(&value),
        Rule::Turns => value.abs() <= TURNS * 360.0,
        Rule::Stretch | Rule::NotAbove(_) | Rule::Inside(_) | Rule::Unlike(_) => true,
    }
}

/// The data in the expression of a number, each once, with their values.
fn of_data(scene: &Scene, data: &[f64], datum: Num) -> Vec<(usize, f64)> {
    let Num::Derived(i) = datum else { return Vec::new() };
    let names = scene.formulas.numbers.get(i).into_iter().flat_map(|derived| derived.formula.names());
    let mut of: Vec<(usize, f64)> = Vec::new();
    for given in names {
        if of.iter().all(|(known, _)| *known != given.datum) {
            of.push((given.datum, given.value(data)));
        }
    }
    of
}

/// The data that are no part of this scene; empty if it can be solved.
pub fn faults(scene: &Scene, data: &[f64]) -> Vec<Inadmissible> {
    let mut found: Vec<Inadmissible> = Vec::new();
    let mut judge = |datum, rule| {
        let same = |f: &Inadmissible| f.datum == datum && f.rule == rule;
        if !holds(scene, data, datum, rule) && !found.iter().any(same) {
            let of = of_data(scene, data, datum);
            found.push(Inadmissible { datum, value: scene.value(datum, data), rule, of });
        }
    };
    rules(scene, &mut |datum, rule| {
        judge(datum, rule);
        judge(datum, Rule::Range);
    });
    found
}
