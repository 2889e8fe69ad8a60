//! Kinetic energy at an instant by the decomposition: the mass centre, and the rotation about it.
//!
//! For a lamina the inertia about the mass centre is taken from the mutual distances (Lagrange's identity,
//! `I_G = sum over pairs m_i m_j r_ij^2 / sum m`), so no centre is needed for it. A body with a speed and a spin is taken
//! as turning about its instantaneous centre, at the distance `v / omega`.
use crate::num::Real;
use crate::num::plant::plant;
use crate::scene::Coordinate;
use crate::scene::Degree;
use crate::scene::Label;
use crate::scene::Numbers;
use crate::scene::Owner;
use crate::scene::Quantity;
use crate::scene::Scene;
use crate::scene::Start;
use crate::scene::Tie;
use crate::solve::outcome::Road;
use crate::solve::outcome::Said;

/// `T = 1/2 m v_G^2 + 1/2 I_G omega^2`, counter-clockwise positive.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>) -> Road<T> {
    let mut road = Road::new();
    let mut energy = T::zero();
    let mut say = |quantity, of, value: T| {
        let label = Label { quantity, of };
        let value = n.publish(quantity, value);
        road.said.push(Said { label, value, scale: value.f64().abs() });
    };
    for (b, body) in scene.bodies.iter().enumerate() {
        if body.particles.is_empty() {
            energy = energy + about_instantaneous_centre(scene, n, b);
            continue;
        }
        for s in &scene.start {
            let Start::Lamina { body: of, particle, vx_m_s, vy_m_s, spin_rad_s } = s else { continue };
            if *of != b {
                continue;
            }
            let spin = n.get(*spin_rad_s);
            let origin = &body.particles[*particle];
            let (x0, y0) = (n.get(origin.x_m), n.get(origin.y_m));
            // Mass centre as seen from the known particle.
            let mut rest = (T::zero(), T::zero());
            let mut pairs = T::zero();
            let mass = n.bodies[b].mass;
            for (i, p) in body.particles.iter().enumerate() {
                let share = n.massive(p.mass_kg) / mass;
                let (x, y) = (n.get(p.x_m), n.get(p.y_m));
                rest.0 = rest.0 + plant!("energy: arm of the mass centre, x", share) * (x - x0);
                rest.1 = rest.1 + plant!("energy: arm of the mass centre, y", share) * (y - y0);
                for q in &body.particles[i + 1..] {
                    let square = (x - n.get(q.x_m)).square() + (y - n.get(q.y_m)).square();
                    pairs =
                        pairs + plant!("energy: pair of particles", share * n.massive(q.mass_kg)) * square;
                }
            }
            let vx = n.get(*vx_m_s) - plant!("energy: velocity of the mass centre, x", spin) * rest.1;
            let vy = n.get(*vy_m_s) + plant!("energy: velocity of the mass centre, y", spin) * rest.0;
            let centre = mass * (vx.square() + vy.square());
            let about = pairs * spin.square();
            energy = energy
                + plant!("energy: kinetic energy of the centre of the lamina", centre).scale2(-1)
                + plant!("energy: rotation about the centre of the lamina", about).scale2(-1);
            say(Quantity::XG, Owner::Body(b), x0 + rest.0);
            say(Quantity::YG, Owner::Body(b), y0 + rest.1);
            say(Quantity::IG, Owner::Body(b), pairs);
        }
    }
    say(Quantity::KineticEnergy, Owner::Scene, energy);
    road
}

fn about_instantaneous_centre<T: Real>(scene: &Scene, n: &Numbers<T>, b: usize) -> T {
    let given = |degree| {
        scene.start.iter().find_map(|s| match s {
            Start::Speed(c, value) if *c == Coordinate { body: b, degree } => Some(n.get(*value)),
            _ => None,
        })
    };
    let (speed, spin) = (given(Degree::Along), given(Degree::Turn));
    let contact = scene.ties.iter().find_map(|t| match t {
        Tie::Roll { body, radius_m, .. } if *body == b => Some(n.get(*radius_m)),
        _ => None,
    });
    let body = n.bodies[b];
    let (distance, spin) = match (speed, spin, contact) {
        (_, Some(w), Some(c)) => (c, w),
        (Some(v), None, Some(c)) => (c, v / c),
        (Some(v), Some(w), None) if !w.is_zero() => (v / w, w),
        (None, Some(w), None) => (T::zero(), w),
        (Some(v), _, None) => return (body.mass * v.square()).scale2(-1),
        (None, None, _) => return T::zero(),
    };
    ((body.inertia + body.mass * distance.square()) * spin.square()).scale2(-1)
}
