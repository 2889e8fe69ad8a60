//! Mass and moment of inertia of one body, worked from what the bank gives.
use crate::scene::{Mass, RotaryInertia, Shape};
use crate::solution::expr::{Expr, ZERO, number, ratio, square, sum};
use crate::solution::section_writer::SectionWriter;

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
pub fn mass(page: &mut SectionWriter, body: usize) -> Expr {
    let this = &page.draft.scene.bodies[body];
    match &this.mass {
        Mass::OfParts => {
            let Some(RotaryInertia::Parts(parts)) = &this.inertia else { return ZERO };
            let parts: Vec<Expr> = parts.iter().map(|p| of(page, &p.mass)).collect();
            let name = page.free(&["m", "m_G"]);
            page.say("pinned.mass_parts", &[]);
            page.find(&name, "kg", sum(parts)).into()
        }
        given @ Mass::Weight(_) => {
            let from = of(page, given);
            let name = page.free(&["m", "m_G"]);
            page.say("pinned.mass_weight", &[]);
            page.find(&name, "kg", &from).into()
        }
        given @ Mass::Kilograms(_) => of(page, given),
    }
}

fn of(page: &mut SectionWriter, mass: &Mass) -> Expr {
    match mass {
        Mass::Kilograms(m) => page.number(*m, "m", "kg"),
        Mass::Weight(w) => {
            let gravity = page.draft.scene.gravity_m_s2;
            let g = page.number(gravity, "g", "m/s^2");
            page.number(*w, "W", "N") / g
        }
        Mass::OfParts => ZERO,
    }
}

/// The moment of inertia about the mass centre; [`ZERO`] for a body that has none.
pub fn inertia(page: &mut SectionWriter, body: usize, m: &Expr) -> Expr {
    let name = page.free(&["I_G", "J_G"]);
    let scene = page.draft.scene;
    match &scene.bodies[body].inertia {
        None => ZERO,
        Some(RotaryInertia::Moment(i)) => page.number(*i, &name, "kg m^2"),
        Some(RotaryInertia::Gyration(k)) => {
            let k = page.number(*k, "k", "m");
            if k == ZERO {
                return ZERO;
            }
            page.say("pinned.inertia_gyration", &[]);
            page.find(&name, "kg m^2", m * square(k)).into()
        }
        Some(RotaryInertia::Shape(shape, r)) => {
            let r = page.number(*r, "R", "m");
            let named = page.draft.words.get(phrase(*shape)).to_owned();
            page.say("pinned.inertia_shape", &[("shape", &named)]);
            page.find(&name, "kg m^2", beta(*shape) * m * square(r)).into()
        }
        Some(RotaryInertia::Parts(parts)) => {
            let mut terms = Vec::new();
            for p in parts {
                let mass = of(page, &p.mass);
                let r = page.number(p.radius_m, "R", "m");
                terms.push(beta(p.shape) * mass * square(r));
            }
            page.say("pinned.inertia_parts", &[]);
            page.find(&name, "kg m^2", sum(terms)).into()
        }
    }
}
