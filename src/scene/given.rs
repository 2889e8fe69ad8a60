//! Every number that a scene is given, with its unit of SI (`1` for a pure number and for degrees) and the rules that it keeps, in the
//! order of the scene: one table, for those who look and for those who change the numbers.
use crate::scene::Rule::{self, Angle, Finite, Inside, NotAbove, NotNegative, Positive, Stretch, Unlike};
use crate::scene::{
    Attach, Body, CordEnd, Degree, End, Far, JointKind, Mass, Num, Place, Rest, RotaryInertia, Scene, Shape,
    Slope, Start, Straight, StrutEnd, Surface, Tie,
};

/// Degrees, and the slope of a surface.
const ANGLE: (&str, &[Rule]) = ("1", &[Angle]);
const SLOPE: (&str, &[Rule]) = ("1", &[Rule::Slope]);
const FRICTION: (&str, &[Rule]) = ("1", &[NotNegative]);
const PLACE: (&str, &[Rule]) = ("m", &[Finite]);
const RADIUS: (&str, &[Rule]) = ("m", &[Positive]);

/// What a number is: its unit, and its rules.
type Kind<'k> = (&'static str, &'k [Rule]);

const fn way(degree: Degree) -> &'static str {
    if matches!(degree, Degree::Along) { "m" } else { "1" }
}
/// The unit of a speed along a line or of a turn.
pub const fn speed_unit(degree: Degree) -> &'static str {
    if matches!(degree, Degree::Along) { "m/s" } else { "rad/s" }
}

/// Is there nothing but solid shapes in a body, so that nothing can be inside it?
fn is_solid(body: &Body) -> bool {
    match &body.inertia {
        Some(RotaryInertia::Shape(shape, _)) => *shape != Shape::Hoop,
        Some(RotaryInertia::Parts(parts)) => parts.iter().all(|part| part.shape != Shape::Hoop),
        Some(RotaryInertia::Gyration(_) | RotaryInertia::Moment(_)) | None => false,
    }
}

fn radius(body: &Body, name: &str) -> Option<Num> {
    body.radii_m.iter().find(|(n, _)| n == name).map(|(_, r)| *r)
}

/// The rule of the mass of a body. What is told to be light in the plane has a mass of 0; a datum is none.
fn of_mass(body: &Body) -> Rule {
    let light = body.line.is_some() || body.planar.is_some() && !body.is_pinned();
    let light = light && matches!(body.mass, Mass::Kilograms(Num::Fixed(_)));
    let moves = body.line.is_some() || body.planar.is_some();
    if moves && !light { Positive } else { NotNegative }
}

macro_rules! walks {
    ($($(#[$doc:meta])* $walk:ident: $iter:ident $($change:ident)?;)*) => {$(
        $(#[$doc])*
        pub mod $walk {
            use crate::scene::given::*;

            /// Sees a number.
            type Tell<'t> = dyn FnMut(&$($change)? Num, Kind) + 't;

            /// All numbers of a scene.
            pub fn all(scene: &$($change)? Scene, tell: &mut Tell) {
                let pinned = scene.pinned().is_some();
                let held = scene.struts.first().filter(|_| pinned).map(|strut| strut.at.point);
                tell(&$($change)? scene.gravity_m_s2, ("m/s^2", &[Positive]));
                for (i, it) in scene.bodies.$iter().enumerate() {
                    let slips = scene.ties.iter().any(|t| matches!(t, Tie::Slip { body, .. } if *body == i));
                    body(it, if slips { Positive } else { NotNegative }, tell);
                    in_the_plane(it, held, tell);
                }
                scene.ties.$iter().for_each(|it| tie(it, tell));
                for couple in scene.couples.$iter() {
                    tell(&$($change)? couple.moment_n_m, ("N*m", &[NotNegative]));
                }
                for it in scene.joints.$iter() {
                    let at = it.kind.spots().next().and_then(|spot| scene.bodies.get(spot.body));
                    let solid = at.is_some_and(is_solid);
                    joint(&$($change)? it.kind, solid, tell);
                }
                scene.restitution.$iter().for_each(|(_, e)| tell(e, ("1", &[NotNegative, NotAbove(Num::Fixed(1.0))])));
                forces(scene, pinned, tell);
                for start in scene.start.$iter() {
                    match start {
                        Start::Speed(c, v) => tell(v, (speed_unit(c.degree), &[Finite])),
                        Start::Lamina { vx_m_s, vy_m_s, spin_rad_s, .. } => {
                            tell(vx_m_s, ("m/s", &[Finite]));
                            tell(vy_m_s, ("m/s", &[Finite]));
                            tell(spin_rad_s, ("rad/s", &[Finite]));
                        }
                    }
                }
                if let Some(carrier) = &$($change)? scene.carried {
                    tell(&$($change)? carrier.speed_m_s, ("m/s", &[Finite]));
                    tell(&$($change)? carrier.acceleration_m_s2, ("m/s^2", &[Finite]));
                    if let Slope::Degrees(angle) = &$($change)? carrier.slope {
                        tell(angle, SLOPE);
                    }
                }
                match &$($change)? scene.end {
                    End::AtOnce | End::TurningPoint(_) | End::Rolling(_) | End::Leaves(_) | End::Equilibrium => {}
                    End::Travel(c, s) => tell(s, (way(c.degree), &[NotNegative])),
                    End::Position(c, s) => tell(s, (way(c.degree), &[Finite])),
                    End::Time(_, t) => tell(t, ("s", &[NotNegative])),
                    End::Speed(c, v) => tell(v, (speed_unit(c.degree), &[NotNegative])),
                    End::Angle(_, angle) => tell(angle, ("1", &[Rule::Turns])),
                }
            }

            fn mass(mass: &$($change)? Mass, rule: Rule, tell: &mut Tell) {
                match mass {
                    Mass::Kilograms(m) => tell(m, ("kg", &[rule])),
                    Mass::Weight(w) => tell(w, ("N", &[rule])),
                    Mass::OfParts => {}
                }
            }

            fn body(body: &$($change)? Body, inertia: Rule, tell: &mut Tell) {
                for p in body.particles.$iter() {
                    tell(&$($change)? p.mass_kg, ("kg", &[Positive]));
                    tell(&$($change)? p.x_m, PLACE);
                    tell(&$($change)? p.y_m, PLACE);
                }
                let rule = of_mass(body);
                mass(&$($change)? body.mass, rule, tell);
                match &$($change)? body.inertia {
                    None => {}
                    Some(RotaryInertia::Gyration(k)) => tell(k, ("m", &[inertia])),
                    Some(RotaryInertia::Moment(i)) => tell(i, ("kg*m^2", &[inertia])),
                    Some(RotaryInertia::Shape(_, r)) => tell(r, RADIUS),
                    Some(RotaryInertia::Parts(parts)) => {
                        for part in parts {
                            mass(&$($change)? part.mass, NotNegative, tell);
                            tell(&$($change)? part.radius_m, RADIUS);
                        }
                    }
                }
                let [rim, outer] = ["rim", "outer"].map(|name| radius(body, name));
                for (name, radius) in body.radii_m.$iter() {
                    match (name.as_str(), rim, outer) {
                        ("hub", Some(bound), _) | ("inner", _, Some(bound)) => {
                            tell(radius, ("m", &[Positive, NotAbove(bound)]));
                        }
                        _ => tell(radius, RADIUS),
                    }
                }
                if let Some(line) = &$($change)? body.line
                    && let Slope::Degrees(angle) = &$($change)? line.slope
                {
                    tell(angle, SLOPE);
                }
            }

            /// How a body lies in the plane; `held` is the point at which a spring acts of one that swings about its pin.
            fn in_the_plane(body: &$($change)? Body, held: Option<usize>, tell: &mut Tell) {
                let Some(planar) = &$($change)? body.planar else { return };
                for (i, (_, place)) in planar.points.$iter().enumerate() {
                    let [Place::At(along) | Place::HalfOf(along), Place::At(aside) | Place::HalfOf(aside)] = place;
                    tell(along, if held == Some(i) { RADIUS } else { PLACE });
                    tell(aside, PLACE);
                }
                let centre = match (planar.pinned, planar.centre) {
                    (true, Place::At(_)) => ("m", &[NotNegative][..]),
                    (true, Place::HalfOf(_)) => RADIUS,
                    _ => PLACE,
                };
                let (Place::At(x) | Place::HalfOf(x)) = &$($change)? planar.centre;
                tell(x, centre);
                planar.start_deg.$iter().for_each(|angle| tell(angle, ANGLE));
                planar.driven.$iter().for_each(|alpha| tell(alpha, ("rad/s^2", &[Finite])));
                if let Some(arrives) = &$($change)? planar.arrives {
                    tell(&$($change)? arrives.speed_m_s, ("m/s", &[Finite]));
                    tell(&$($change)? arrives.direction_deg, ANGLE);
                    tell(&$($change)? arrives.spin_rad_s, ("rad/s", &[Finite]));
                }
                planar.origin_m.$iter().flatten().for_each(|x| tell(x, PLACE));
            }

            fn tie(tie: &$($change)? Tie, tell: &mut Tell) {
                match tie {
                    Tie::Roll { radius_m, mu_s, .. } => {
                        tell(radius_m, RADIUS);
                        mu_s.$iter().for_each(|mu| tell(mu, FRICTION));
                    }
                    Tie::Slip { radius_m, mu_s, mu_k, .. } => {
                        tell(radius_m, RADIUS);
                        tell(mu_s, FRICTION);
                        tell(mu_k, ("1", &[NotNegative, NotAbove(*mu_s)]));
                    }
                    Tie::Slide { mu_s, mu_k, .. } => {
                        let bound = mu_s.map_or(NotNegative, NotAbove);
                        tell(mu_k, ("1", &[NotNegative, bound]));
                        mu_s.$iter().for_each(|mu| tell(mu, FRICTION));
                    }
                    Tie::Cord(cord) => {
                        cord_end(&$($change)? cord.from, tell);
                        match &$($change)? cord.to {
                            Far::Pull(force) => tell(force, ("N", &[NotNegative])),
                            Far::Body(end) => cord_end(end, tell),
                            Far::Spring { stiffness_n_m, stretch_m, rigid } => {
                                tell(stiffness_n_m, ("N/m", &[Positive]));
                                tell(stretch_m, ("m", &[if *rigid { Finite } else { NotNegative }]));
                            }
                            Far::Fixed => {}
                        }
                    }
                }
            }

            fn cord_end(end: &$($change)? CordEnd, tell: &mut Tell) {
                if let Attach::Wound(radius, _) = &$($change)? end.attach {
                    tell(radius, RADIUS);
                }
                end.tilt_deg.$iter().for_each(|tilt| tell(tilt, ANGLE));
            }

            fn line(line: &$($change)? Straight, tell: &mut Tell) {
                line.through_m.$iter().for_each(|x| tell(x, PLACE));
                tell(&$($change)? line.direction_deg, ANGLE);
            }

            /// The numbers of a joint of a body, which may be solid.
            fn joint(kind: &$($change)? JointKind, solid: bool, tell: &mut Tell) {
                match kind {
                    JointKind::Hinge { turned_deg, .. } => turned_deg.$iter().for_each(|x| tell(x, ANGLE)),
                    JointKind::Pin { place_m, .. } => place_m.$iter().for_each(|x| tell(x, PLACE)),
                    JointKind::Cord { place_m, beyond, .. } => {
                        place_m.$iter().for_each(|x| tell(x, PLACE));
                        beyond.$iter().for_each(|(_, place)| place.$iter().for_each(|x| tell(x, PLACE)));
                    }
                    JointKind::Contact { radius_m, surface, mu_k, .. } => {
                        mu_k.$iter().for_each(|mu| tell(mu, FRICTION));
                        match surface {
                        Surface::Line(at) => {
                            tell(radius_m, ("m", &[NotNegative]));
                            line(at, tell);
                        }
                        Surface::Arc { centre_m, radius_m: arc, inside, .. } => {
                            // A hoop may hang on a smaller cylinder, as may what the bank tells no shape of.
                            let beside = if solid { Inside(*arc) } else { Unlike(*arc) };
                            tell(radius_m, ("m", &[NotNegative, beside][..1 + usize::from(*inside)]));
                            centre_m.$iter().for_each(|x| tell(x, PLACE));
                            tell(arc, RADIUS);
                        }
                    }}
                    JointKind::Guide { line: at, mu_k, .. } => {
                        line(at, tell);
                        mu_k.$iter().for_each(|mu| tell(mu, FRICTION));
                    }
                }
            }

            /// The numbers of forces and springs in the plane, and of forces that grow.
            fn forces(scene: &$($change)? Scene, pinned: bool, tell: &mut Tell) {
                for push in scene.pushes.$iter() {
                    let unit = if push.blow { "N*s" } else { "N" };
                    tell(&$($change)? push.force_n, (unit, &[NotNegative]));
                    tell(&$($change)? push.direction_deg, ANGLE);
                    push.toward_m.$iter().flatten().for_each(|x| tell(x, PLACE));
                }
                for strut in scene.struts.$iter() {
                    let ([stiffness, length], twists) = (strut.units(), strut.twists());
                    tell(&$($change)? strut.stiffness_n_m, (stiffness, &[Positive]));
                    match &$($change)? strut.rest {
                        Rest::Length(x) | Rest::Stretch(x) if twists => tell(x, ANGLE),
                        Rest::Length(x) => tell(x, (length, &[NotNegative])),
                        Rest::Stretch(x) if pinned => tell(x, (length, &[NotNegative, Stretch])),
                        Rest::Stretch(x) => tell(x, (length, &[Finite])),
                    }
                    match &$($change)? strut.to {
                        StrutEnd::Ground(place) => place.$iter().for_each(|x| tell(x, PLACE)),
                        StrutEnd::Spot(_) | StrutEnd::Twist => {}
                        StrutEnd::Guide { through_m, direction_deg } => {
                            through_m.$iter().for_each(|x| tell(x, PLACE));
                            tell(direction_deg, ANGLE);
                        }
                    }
                }
                for growth in scene.growths.$iter() {
                    let units = (growth.rate_unit(), growth.of_unit());
                    tell(&$($change)? growth.rate, (units.0, &[NotNegative]));
                    tell(&$($change)? growth.unit, (units.1, &[]));
                }
            }
        }
    )*};
}

walks! {
    /// Looks at the numbers.
    read: iter;
    /// Changes them.
    change: iter_mut mut;
}
