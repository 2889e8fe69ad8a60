//! Kinetic energy at an instant by the decomposition: the mass centre, and the rotation about it, of each body in turn.
//!
//! For a lamina the inertia about the mass centre is taken from the mutual distances (Lagrange's identity,
//! `I_G = sum over pairs m_i m_j r_ij^2 / sum m`), so no centre is needed for it. The velocities of all other bodies follow
//! from the start through the ties, as in a scene that moves on.
use crate::num::Real;
use crate::num::plant::plant;
use crate::scene::{Coordinate, Label, Numbers, Owner, Quantity, Scene, Start, speed};
use crate::solve::energy::{balance, speeds};
use crate::solve::outcome::{Refusal, Road, Said, Scope};

/// `T = sum 1/2 m v_G^2 + 1/2 I_G omega^2`, counter-clockwise positive.
///
/// Errors: a start that contradicts the ties, or leaves a velocity open.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>) -> Result<Road<T>, Refusal> {
    let mut road = Road::new(Scope::ALL);
    let motion = speeds::at_start(scene, n)?;
    let doubled = balance::inertia(n, &motion, &motion);
    let mut energy = doubled.scale2(-1);
    let velocity = |c: Coordinate| (c, motion.of(c));
    road.velocities = scene.coordinates().map(velocity).collect();
    let mut say = |quantity, of, value: T| {
        road.said.push(Said::of(n, Label { quantity, of }, value, value.size()));
    };
    for (b, body) in scene.bodies.iter().enumerate() {
        if body.line.is_some() {
            let seen = n.bodies[b].carried.map_or([motion.v[b], T::zero()], |[forward, out]| {
                [motion.v[b].balance(forward.speed), out.speed]
            });
            say(Quantity::V, Owner::Body(b), speed(seen[0], seen[1]));
        }
        if body.spins() {
            say(Quantity::Omega, Owner::Body(b), motion.w[b].abs());
            if body.turns {
                let spin = (n.bodies[b].inertia * motion.w[b]).abs();
                say(Quantity::AngularMomentum, Owner::Body(b), spin);
            }
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
    for (tie, cord, force) in scene.pulls() {
        let power = plant!("energy: power of a pull at once", n.massive(force)) * motion.point(n, &cord.from);
        say(Quantity::PowerPull, Owner::Tie(tie), power);
    }
    for b in 0..scene.bodies.len() {
        if let Some(power) = scene.couple_on(n, b).map(|moment| moment * motion.w[b]) {
            say(Quantity::PowerCouple, Owner::Body(b), plant!("energy: power of couples at once", power));
        }
    }
    say(Quantity::KineticEnergy, Owner::Scene, energy);
    if scene.coordinates().next().is_some() && !energy.is_zero() {
        let turning =
            (0..n.bodies.len()).fold(T::zero(), |sum, b| sum + n.bodies[b].inertia * motion.w[b].square());
        say(Quantity::RotationalFraction, Owner::Scene, turning.over(energy.scale2(1)));
    }
    Ok(road)
}
