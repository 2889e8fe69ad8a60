//! Kinetic energy at an instant, as a sum: over particles, or over bodies each with its mass centre and its spin.
use crate::num::Real;
use crate::num::dd::pow2;
use crate::num::plant::plant;
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

/// `T = sum 1/2 m_i |v_i|^2` with `v_i = v_A + omega x (r_i - r_A)`, counter-clockwise positive.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>) -> Road<T> {
    let mut road = Road::new();
    let mut energy = T::zero();
    let mut say = |quantity, of, value: T, scale: f64| {
        let label = Label { quantity, of };
        road.said.push(Said {
            label,
            value: n.publish(quantity, value),
            scale: scale * pow2(n.exponent(quantity)),
        });
    };
    for (b, body) in scene.bodies.iter().enumerate() {
        if body.particles.is_empty() {
            energy = energy + spinning(scene, n, b);
            continue;
        }
        let motion = scene.start.iter().find_map(|s| match s {
            Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s } if *body == b => {
                Some((*particle, n.get(*vx_m_s), n.get(*vy_m_s), n.get(*spin_rad_s)))
            }
            _ => None,
        });
        let Some((known, vx, vy, spin)) = motion else { continue };
        let place = |i: usize| (n.get(body.particles[i].x_m), n.get(body.particles[i].y_m));
        let (xa, ya) = place(known);
        let (mut mass, mut mx, mut my) = (T::zero(), T::zero(), T::zero());
        let (mut scale_x, mut scale_y) = (0.0, 0.0);
        for (i, p) in body.particles.iter().enumerate() {
            let m = n.massive(p.mass_kg);
            let (x, y) = place(i);
            let ux = vx - plant!("eom: velocity about the known particle, x", spin) * (y - ya);
            let uy = vy + plant!("eom: velocity about the known particle, y", spin) * (x - xa);
            let square = ux.square() + uy.square();
            energy = energy + plant!("eom: kinetic energy of a particle", m * square).scale2(-1);
            mass = mass + m;
            mx = mx + plant!("eom: first moment, x", m * x);
            my = my + plant!("eom: first moment, y", m * y);
            scale_x += (m * x).f64().abs();
            scale_y += (m * y).f64().abs();
        }
        let (xg, yg) = (mx / mass, my / mass);
        let mut inertia = T::zero();
        for (i, p) in body.particles.iter().enumerate() {
            let (x, y) = place(i);
            let arm = (x - xg).square() + (y - yg).square();
            inertia = inertia + n.massive(p.mass_kg) * plant!("eom: square of the arm", arm);
        }
        let of = Owner::Body(b);
        say(Quantity::XG, of, xg, scale_x / mass.f64());
        say(Quantity::YG, of, yg, scale_y / mass.f64());
        say(Quantity::IG, of, inertia, inertia.f64());
    }
    say(Quantity::KineticEnergy, Owner::Scene, energy, energy.f64());
    road
}

/// `1/2 m v^2 + 1/2 I omega^2` of one body, whose speed or spin may follow from rolling.
fn spinning<T: Real>(scene: &Scene, n: &Numbers<T>, b: usize) -> T {
    let (mut v, mut w) = (None, None);
    for s in &scene.start {
        if let Start::Speed(c, value) = s
            && c.body == b
        {
            match c.degree {
                Degree::Along => v = Some(n.get(*value)),
                Degree::Turn => w = Some(n.get(*value)),
            }
        }
    }
    for t in &scene.ties {
        if let Tie::Roll { body, radius_m, .. } = t
            && *body == b
        {
            let c = n.get(*radius_m);
            v = v.or_else(|| w.map(|w| c * w));
            w = w.or_else(|| v.map(|v| v / c));
        }
    }
    let numbers = n.bodies[b];
    let moving = v.map_or_else(T::zero, |v| numbers.mass * v.square());
    let turning = w.map_or_else(T::zero, |w| numbers.inertia * w.square());
    (moving + turning).scale2(-1)
}
