//! Which data are a scene at all (PHYSICS: admissible data). NaN passes no test here.
use crate::num::{Dd, Real, trig};
use crate::scene::{
    Arm, Attach, Body, End, Far, JointKind, Mass, Num, Pin, Place, Rest, RotaryInertia, Scene, Shape, Slope,
    Start, StrutEnd, Surface, Tie, Zero,
};
use Rule::{Finite, NotNegative, Positive};

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

/// The least magnitude of a datum that is not 0, SI.
pub const LEAST: f64 = 1e-150;
/// The greatest magnitude of a datum, SI.
pub const MOST: f64 = 1e150;

/// One datum that is no part of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inadmissible {
    /// Which.
    pub datum: Num,
    /// Its value.
    pub value: f64,
    /// The rule that it breaks.
    pub rule: Rule,
}

/// Every number of the scene with its rule, in the order of the scene.
pub fn rules(scene: &Scene, tell: &mut dyn FnMut(Num, Rule)) {
    tell(scene.gravity_m_s2, Positive);
    for (i, body) in scene.bodies.iter().enumerate() {
        let slips = scene.ties.iter().any(|t| matches!(t, Tie::Slip { body, .. } if *body == i));
        body_rules(body, slips, tell);
    }
    scene.ties.iter().for_each(|tie| tie_rules(tie, tell));
    scene.formulas.below.iter().for_each(|(own, other)| tell(*own, Rule::NotAbove(*other)));
    scene.couples.iter().for_each(|c| tell(c.moment_n_m, NotNegative));
    joint_rules(scene, tell);
    scene.growths.iter().for_each(|g| tell(g.rate, NotNegative));
    for s in &scene.start {
        match s {
            Start::Speed(_, v) => tell(*v, Finite),
            Start::Lamina { vx_m_s, vy_m_s, spin_rad_s, .. } => {
                tell(*vx_m_s, Finite);
                tell(*vy_m_s, Finite);
                tell(*spin_rad_s, Finite);
            }
        }
    }
    if let Some(carrier) = &scene.carried {
        tell(carrier.speed_m_s, Finite);
        tell(carrier.acceleration_m_s2, Finite);
        if let Slope::Degrees(angle) = carrier.slope {
            tell(angle, Rule::Slope);
        }
    }
    match scene.end {
        End::AtOnce | End::TurningPoint(_) | End::Rolling(_) | End::Leaves(_) | End::Equilibrium => {}
        End::Travel(_, d) | End::Time(_, d) | End::Speed(_, d) => tell(d, NotNegative),
        End::Position(_, s) => tell(s, Finite),
        End::Angle(_, a) => tell(a, Rule::Angle),
    }
}

/// The numbers of a body.
fn body_rules(b: &Body, slips: bool, tell: &mut dyn FnMut(Num, Rule)) {
    for p in &b.particles {
        tell(p.mass_kg, Positive);
        tell(p.x_m, Finite);
        tell(p.y_m, Finite);
    }
    // What is told to be light in the plane has a mass of 0; a datum is none.
    let light = b.planar.is_some() && matches!(b.mass, Mass::Kilograms(Num::Fixed(_)));
    let moves = b.line.is_some() || b.pin.is_some() || b.planar.is_some();
    let mass = if moves && !light { Positive } else { NotNegative };
    if let (true, Mass::Kilograms(n) | Mass::Weight(n)) = (b.particles.is_empty(), &b.mass) {
        tell(*n, mass);
    }
    let inertia = if slips { Positive } else { NotNegative };
    match &b.inertia {
        None => {}
        Some(RotaryInertia::Gyration(n) | RotaryInertia::Moment(n)) => tell(*n, inertia),
        Some(RotaryInertia::Shape(_, n)) => tell(*n, Positive),
        Some(RotaryInertia::Parts(parts)) => {
            for p in parts {
                if let Mass::Kilograms(n) | Mass::Weight(n) = p.mass {
                    tell(n, NotNegative);
                }
                tell(p.radius_m, Positive);
            }
        }
    }
    let radius = |name: &str| b.radii_m.iter().find(|(n, _)| n == name).map(|(_, r)| *r);
    b.radii_m.iter().for_each(|(_, r)| tell(*r, Positive));
    for (small, large) in [("hub", "rim"), ("inner", "outer")] {
        if let (Some(r), Some(rim)) = (radius(small), radius(large)) {
            tell(r, Rule::NotAbove(rim));
        }
    }
    if let Some(Slope::Degrees(angle)) = b.line.map(|l| l.slope) {
        tell(angle, Rule::Slope);
    }
    if let Some(pin) = &b.pin {
        pin_rules(pin, tell);
    }
    if let Some(planar) = &b.planar {
        for place in planar.points.iter().flat_map(|(_, p)| p).chain([&planar.centre]) {
            let (Place::At(x) | Place::HalfOf(x)) = place;
            tell(*x, Finite);
        }
        planar.start_deg.iter().for_each(|angle| tell(*angle, Rule::Angle));
        planar.driven.iter().for_each(|alpha| tell(*alpha, Finite));
        planar.origin_m.iter().flatten().for_each(|x| tell(*x, Finite));
    }
}

/// The numbers of a contact or cord.
fn tie_rules(tie: &Tie, tell: &mut dyn FnMut(Num, Rule)) {
    match tie {
        Tie::Roll { radius_m, mu_s, .. } => {
            tell(*radius_m, Positive);
            mu_s.iter().for_each(|mu| tell(*mu, NotNegative));
        }
        Tie::Slip { radius_m, mu_s, mu_k, .. } => {
            tell(*radius_m, Positive);
            tell(*mu_s, NotNegative);
            tell(*mu_k, NotNegative);
            tell(*mu_k, Rule::NotAbove(*mu_s));
        }
        Tie::Slide { mu_s, mu_k, .. } => {
            tell(*mu_k, NotNegative);
            if let Some(mu) = mu_s {
                tell(*mu, NotNegative);
                tell(*mu_k, Rule::NotAbove(*mu));
            }
        }
        Tie::Cord(c) => {
            let mut wound = |a: Attach| {
                if let Attach::Wound(r, _) = a {
                    tell(r, Positive);
                }
            };
            wound(c.from.attach);
            if let Far::Body(end) = &c.to {
                wound(end.attach);
            }
            c.from.tilt_deg.iter().for_each(|tilt| tell(*tilt, Rule::Angle));
            match &c.to {
                Far::Pull(p) => tell(*p, NotNegative),
                Far::Spring { stiffness_n_m, stretch_m, rigid } => {
                    tell(*stiffness_n_m, Positive);
                    tell(*stretch_m, if *rigid { Finite } else { NotNegative });
                }
                Far::Body(_) | Far::Fixed => {}
            }
        }
    }
}

/// The numbers of joints, and of forces and springs in the plane.
fn joint_rules(scene: &Scene, tell: &mut dyn FnMut(Num, Rule)) {
    for joint in &scene.joints {
        match joint.kind {
            JointKind::Hinge { turned_deg, .. } => turned_deg.iter().for_each(|x| tell(*x, Rule::Angle)),
            JointKind::Pin { place_m, .. } | JointKind::Cord { place_m, .. } => {
                place_m.iter().for_each(|x| tell(*x, Rule::Finite));
            }
            JointKind::Contact { at, radius_m, surface, .. } => {
                tell(radius_m, Rule::NotNegative);
                match surface {
                    Surface::Line { through_m, direction_deg } => {
                        through_m.iter().for_each(|x| tell(*x, Rule::Finite));
                        tell(direction_deg, Rule::Angle);
                    }
                    Surface::Arc { centre_m, radius_m: arc, inside } => {
                        centre_m.iter().for_each(|x| tell(*x, Rule::Finite));
                        tell(arc, Rule::Positive);
                        // A hoop may hang on a smaller cylinder, as may what the bank tells no shape of.
                        match (inside, is_solid(&scene.bodies[at.body])) {
                            (false, _) => {}
                            (true, true) => tell(radius_m, Rule::Inside(arc)),
                            (true, false) => tell(radius_m, Rule::Unlike(arc)),
                        }
                    }
                }
            }
            JointKind::Guide { through_m, direction_deg, mu_k, .. } => {
                through_m.iter().for_each(|x| tell(*x, Rule::Finite));
                tell(direction_deg, Rule::Angle);
                mu_k.iter().for_each(|mu| tell(*mu, Rule::NotNegative));
            }
        }
    }
    for push in &scene.pushes {
        tell(push.force_n, Rule::NotNegative);
        tell(push.direction_deg, Rule::Angle);
        push.toward_m.iter().flatten().for_each(|x| tell(*x, Rule::Finite));
    }
    for strut in &scene.struts {
        tell(strut.stiffness_n_m, Rule::Positive);
        match strut.rest {
            Rest::Length(l) | Rest::Stretch(l) if strut.twists() => tell(l, Rule::Angle),
            Rest::Length(l) => tell(l, Rule::NotNegative),
            Rest::Stretch(x) => tell(x, Rule::Finite),
        }
        match strut.to {
            StrutEnd::Ground(place) => place.iter().for_each(|x| tell(*x, Rule::Finite)),
            StrutEnd::Spot(_) | StrutEnd::Twist => {}
            StrutEnd::Guide { through_m, direction_deg } => {
                through_m.iter().for_each(|x| tell(*x, Rule::Finite));
                tell(direction_deg, Rule::Angle);
            }
        }
    }
}

/// Is there nothing but solid shapes in a body, so that nothing can be inside it?
fn is_solid(body: &Body) -> bool {
    match &body.inertia {
        Some(RotaryInertia::Shape(shape, _)) => *shape != Shape::Hoop,
        Some(RotaryInertia::Parts(parts)) => parts.iter().all(|part| part.shape != Shape::Hoop),
        Some(RotaryInertia::Gyration(_) | RotaryInertia::Moment(_)) | None => false,
    }
}

/// The numbers of a pin.
fn pin_rules(pin: &Pin, tell: &mut dyn FnMut(Num, Rule)) {
    match pin.arm {
        Arm::Distance(h) => tell(h, Rule::NotNegative),
        Arm::HalfOf(l) => tell(l, Rule::Positive),
    }
    tell(pin.start_deg, Rule::Angle);
    if let Some(s) = &pin.spring {
        tell(s.at_m, Rule::Positive);
        tell(s.x_m, Rule::Finite);
        tell(s.y_m, Rule::Finite);
        tell(s.stiffness_n_m, Rule::Positive);
        match s.rest {
            Rest::Length(l) => tell(l, Rule::NotNegative),
            Rest::Stretch(x) => {
                tell(x, Rule::NotNegative);
                tell(x, Rule::Stretch);
            }
        }
    }
}

/// Is the spring of the pinned body at the start at least as long as it is stretched there?
fn fits(scene: &Scene, of: &impl Fn(Num) -> f64, stretch: f64) -> bool {
    let Some((_, Pin { from, start_deg, spring: Some(s), .. })) = scene.pinned() else { return true };
    let (sine, cosine) = trig::sin_cos_degrees(of(*start_deg));
    let up = if *from == Zero::Upright { cosine } else { -cosine };
    let at = Dd::new(of(s.at_m));
    let (dx, dy) = (Dd::new(of(s.x_m)) - at * sine, Dd::new(of(s.y_m)) - at * up);
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
        Rule::Stretch | Rule::NotAbove(_) | Rule::Inside(_) | Rule::Unlike(_) => true,
    }
}

/// The data that are no part of this scene; empty if it can be solved.
pub fn faults(scene: &Scene, data: &[f64]) -> Vec<Inadmissible> {
    let mut found: Vec<Inadmissible> = Vec::new();
    let mut judge = |datum, rule| {
        let same = |f: &Inadmissible| f.datum == datum && f.rule == rule;
        if !holds(scene, data, datum, rule) && !found.iter().any(same) {
            found.push(Inadmissible { datum, value: scene.value(datum, data), rule });
        }
    };
    rules(scene, &mut |datum, rule| {
        judge(datum, rule);
        judge(datum, Rule::Range);
    });
    found
}
