//! Mass and moment of inertia of one body, worked from what the bank gives.
use crate::scene::Mass;
use crate::scene::RotaryInertia;
use crate::scene::Shape;
use crate::solution::expr::Expr;
use crate::solution::expr::ZERO;
use crate::solution::expr::number;
use crate::solution::expr::ratio;
use crate::solution::expr::square;
use crate::solution::expr::sum;
use crate::solution::pen::Pen;

/// `beta` of `I = beta m R^2`.
pub fn beta(shape: Shape) -> Expr {
    match shape {
        Shape::Hoop => number(1),
        Shape::Disc => ratio(1, 2),
        Shape::Sphere => ratio(2, 5),
        Shape::Shell => ratio(2, 3),
        Shape::Rod => ratio(1, 12),
    }
}

/// The phrase that names a shape's moment of inertia.
fn phrase(shape: Shape) -> &'static str {
    match shape {
        Shape::Hoop => "pinned.shape.hoop",
        Shape::Disc => "pinned.shape.disc",
        Shape::Sphere => "pinned.shape.sphere",
        Shape::Shell => "pinned.shape.shell",
        Shape::Rod => "pinned.shape.rod",
    }
}

/// The mass of a body: a datum, or found from its weight or its parts.
pub fn mass(pen: &mut Pen, body: usize) -> Expr {
    let this = &pen.desk.scene.bodies[body];
    match &this.mass {
        Mass::OfParts => {
            let Some(RotaryInertia::Parts(parts)) = &this.inertia else { return ZERO };
            let parts: Vec<Expr> = parts.iter().map(|p| of(pen, &p.mass)).collect();
            let name = pen.desk.free(&["m", "m_G"]);
            pen.say("pinned.mass_parts", &[]);
            pen.find(&name, "kg", sum(parts)).into()
        }
        given @ Mass::Weight(_) => {
            let from = of(pen, given);
            let name = pen.desk.free(&["m", "m_G"]);
            pen.say("pinned.mass_weight", &[]);
            pen.find(&name, "kg", &from).into()
        }
        given @ Mass::Kilograms(_) => of(pen, given),
    }
}

fn of(pen: &mut Pen, mass: &Mass) -> Expr {
    match mass {
        Mass::Kilograms(m) => pen.desk.number(*m, "m", "kg"),
        Mass::Weight(w) => {
            let gravity = pen.desk.scene.gravity_m_s2;
            let g = pen.desk.number(gravity, "g", "m/s^2");
            pen.desk.number(*w, "W", "N") / g
        }
        Mass::OfParts => ZERO,
    }
}

/// The moment of inertia about the mass centre; [`ZERO`] for a body that has none.
pub fn inertia(pen: &mut Pen, body: usize, m: &Expr) -> Expr {
    let name = pen.desk.free(&["I_G", "J_G"]);
    let scene = pen.desk.scene;
    match &scene.bodies[body].inertia {
        None => ZERO,
        Some(RotaryInertia::Moment(i)) => pen.desk.number(*i, &name, "kg m^2"),
        Some(RotaryInertia::Gyration(k)) => {
            let k = pen.desk.number(*k, "k", "m");
            if k == ZERO {
                return ZERO;
            }
            pen.say("pinned.inertia_gyration", &[]);
            pen.find(&name, "kg m^2", m * square(k)).into()
        }
        Some(RotaryInertia::Shape(shape, r)) => {
            let r = pen.desk.number(*r, "R", "m");
            let named = pen.desk.words.get(phrase(*shape)).to_owned();
            pen.say("pinned.inertia_shape", &[("shape", &named)]);
            pen.find(&name, "kg m^2", beta(*shape) * m * square(r)).into()
        }
        Some(RotaryInertia::Parts(parts)) => {
            let mut terms = Vec::new();
            for p in parts {
                let mass = of(pen, &p.mass);
                let r = pen.desk.number(p.radius_m, "R", "m");
                terms.push(beta(p.shape) * mass * square(r));
            }
            pen.say("pinned.inertia_parts", &[]);
            pen.find(&name, "kg m^2", sum(terms)).into()
        }
    }
}
