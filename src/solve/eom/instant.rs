//! Kinetic energy at an instant: of particles as their sum, of bodies on lines and axles as the work of the impulses that
//! would set them going from rest. A force that grows from 0 and gives a body a velocity does half the work of its impulse
//! over that velocity; no velocity ratio of the ties and no kinetic energy of a single body comes in.
use crate::num::Real;
use crate::num::plant::plant;
use crate::scene::{Coordinate, Degree, Label, Numbers, Owner, Quantity, Scene, Start, speed};
use crate::solve::eom::equations::{Setting, respond};
use crate::solve::eom::take_up;
use crate::solve::outcome;
use crate::solve::outcome::{Refusal, Road, Said, Scope};
use smallvec::{SmallVec, smallvec};

/// `T = sum 1/2 m_i |v_i|^2` with `v_i = v_A + omega x (r_i - r_A)`, counter-clockwise positive.
///
/// Errors: those of the equations, a start that contradicts the ties or leaves a velocity open.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>, asked: Scope) -> Result<Road<T>, Refusal> {
    let mut road = Road::new(asked);
    let struck = struck(scene, n)?;
    let mut energy = struck.energy;
    road.velocities = struck.coordinates.iter().copied().zip(struck.velocities.iter().copied()).collect();
    let mut say = |quantity, of, value: T, scale: f64| {
        if asked.quantities.has(quantity) {
            road.said.push(Said::of(n, Label { quantity, of }, value, scale));
        }
    };
    for (b, body) in scene.bodies.iter().enumerate() {
        for (c, velocity) in struck.coordinates.iter().zip(&struck.velocities).filter(|(c, _)| c.body == b) {
            let quantity = if c.degree == Degree::Along { Quantity::V } else { Quantity::Omega };
            let carried = n.bodies[b].carried.filter(|_| c.degree == Degree::Along);
            let [with, aside] = carried.map_or([T::zero(); 2], |c| c.map(|part| part.speed));
            let scale = velocity.size() + with.size() + aside.size();
            say(quantity, Owner::Body(b), speed(velocity.balance(with), aside), scale);
            if c.degree == Degree::Turn && body.turns {
                let spin = n.bodies[b].inertia * velocity.abs();
                say(Quantity::AngularMomentum, Owner::Body(b), spin, spin.size());
            }
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
        // First moments of what lies ahead of the origin and of what lies behind: printed decimals that balance leave 0.
        let (mut mass, mut ahead, mut behind) = (T::zero(), [T::zero(); 2], [T::zero(); 2]);
        for (i, p) in body.particles.iter().enumerate() {
            let m = n.massive(p.mass_kg);
            let (x, y) = place(i);
            let ux = vx - plant!("eom: velocity about the known particle, x", spin) * (y - ya);
            let uy = vy + plant!("eom: velocity about the known particle, y", spin) * (x - xa);
            let square = ux.square() + uy.square();
            energy = energy + plant!("eom: kinetic energy of a particle", m * square).scale2(-1);
            mass = mass + m;
            let moments = [plant!("eom: first moment, x", m * x), plant!("eom: first moment, y", m * y)];
            for (axis, moment) in moments.into_iter().enumerate() {
                let side = if moment.sign() < 0.0 { &mut behind } else { &mut ahead };
                side[axis] = side[axis] + moment.abs();
            }
        }
        let [xg, yg] = [0, 1].map(|axis| ahead[axis].apart(behind[axis]) / mass);
        let [scale_x, scale_y] = [0, 1].map(|axis| (ahead[axis] + behind[axis]).f64() / mass.f64());
        let mut inertia = T::zero();
        for (i, p) in body.particles.iter().enumerate() {
            let (x, y) = place(i);
            let arm = x.balance(-xg).square() + y.balance(-yg).square();
            inertia = inertia + n.massive(p.mass_kg) * plant!("eom: square of the arm", arm);
        }
        let of = Owner::Body(b);
        say(Quantity::XG, of, xg, scale_x);
        say(Quantity::YG, of, yg, scale_y);
        say(Quantity::IG, of, inertia, inertia.f64());
    }
    let velocity = |c: Coordinate| {
        let own = struck.coordinates.iter().zip(&struck.velocities).find(|(own, _)| **own == c);
        own.map_or_else(T::zero, |(_, v)| *v)
    };
    for (tie, cord, force) in scene.pulls() {
        let speed =
            take_up(n, &cord.from.action(), |degree| velocity(Coordinate { body: cord.from.body, degree }));
        let power = n.massive(force) * speed;
        say(Quantity::PowerPull, Owner::Tie(tie), power, power.size());
    }
    for (body, _) in scene.bodies.iter().enumerate() {
        if let Some(moment) = scene.couple_on(n, body) {
            let power = moment * velocity(Coordinate { body, degree: Degree::Turn });
            say(Quantity::PowerCouple, Owner::Body(body), power, power.size());
        }
    }
    say(Quantity::KineticEnergy, Owner::Scene, energy, energy.f64());
    if !struck.coordinates.is_empty() && !energy.is_zero() {
        let turns =
            struck.coordinates.iter().zip(&struck.velocities).filter(|(c, _)| c.degree == Degree::Turn);
        let turning = turns.fold(T::zero(), |sum, (c, w)| sum + n.bodies[c.body].inertia * w.square());
        let share = turning.scale2(-1).over(energy);
        say(Quantity::RotationalFraction, Owner::Scene, share, share.f64());
    }
    Ok(road)
}

/// One for each coordinate.
pub type Each<T> = SmallVec<[T; 6]>;

/// The motion that impulses bring about from rest: each at a coordinate whose velocity the start gives, the ties holding.
struct Struck<T> {
    coordinates: Each<Coordinate>,
    /// Velocity of each coordinate.
    velocities: Each<T>,
    /// Kinetic energy: of each impulse half its product with the velocity that it adds at its own coordinate.
    energy: T,
}

/// What a unit impulse at a coordinate does while those before it keep their velocities.
struct Blow<T> {
    /// Which coordinate.
    at: usize,
    /// Velocities that it brings about.
    velocities: Each<T>,
}

impl<T: Real> Blow<T> {
    /// At the coordinate itself: the reciprocal of the mass that is felt there.
    fn own(&self) -> T {
        self.velocities[self.at]
    }
}

/// A velocity that is left of others by rounding alone is below this many times the noise of their numbers.
const LEFT: f64 = 65_536.0;

/// The coordinates and their velocities at the start, where the start gives each. Errors: those of [`struck`].
pub fn start<T: Real>(scene: &Scene, n: &Numbers<T>) -> Result<(Each<Coordinate>, Each<T>), Refusal> {
    let Struck { coordinates, mut velocities, .. } = struck(scene, n)?;
    // What is given is so to its last digit.
    for (given, v) in scene.start_speeds() {
        let own = coordinates.iter().zip(&mut velocities).find(|(c, _)| **c == given);
        own.into_iter().for_each(|(_, velocity)| *velocity = n.start(given, v));
    }
    Ok((coordinates, velocities))
}

/// The velocities at the start. Impulses are to velocities what forces are to accelerations: a unit impulse changes the
/// velocities as a unit force, alone, accelerates.
///
/// Errors: equations that do not determine the motion; a velocity that the start and the ties leave open, or one that the
/// start gives against them.
fn struck<T: Real>(scene: &Scene, n: &Numbers<T>) -> Result<Struck<T>, Refusal> {
    let coordinates: Each<Coordinate> = scene.coordinates().collect();
    let mut out =
        Struck { velocities: smallvec![T::zero(); coordinates.len()], coordinates, energy: T::zero() };
    if scene.start_speeds().next().is_none() {
        return Ok(out);
    }
    let mut blows: SmallVec<[Blow<T>; 4]> = SmallVec::new();
    // The blow at a coordinate beside those before it; `None` where it stirs nothing there.
    let blow = |at: usize, before: &[Blow<T>]| -> Result<Option<Blow<T>>, Refusal> {
        let setting = Setting { probe: Some(out.coordinates[at]), ..Setting::loose(scene) };
        let response = respond(scene, n, &setting)?;
        let column = response.last();
        let mut velocities: Each<T> =
            out.coordinates.iter().map(|c| response.acceleration(*c, column)).collect();
        let alone = velocities[at].size();
        for other in before {
            let share = velocities[other.at] / other.own();
            for (v, o) in velocities.iter_mut().zip(&other.velocities) {
                *v = v.balance(-(share * *o));
            }
        }
        let stirs = !velocities[at].negligible(alone * LEFT);
        Ok(stirs.then_some(Blow { at, velocities }))
    };
    let place = |c: Coordinate| out.coordinates.iter().position(|own| *own == c);
    for (c, given) in scene.start_speeds() {
        let Some(at) = place(c) else { continue };
        let missing = n.start(c, given) - out.velocities[at];
        if let Some(blow) = blow(at, &blows)? {
            let impulse = missing / blow.own();
            for (v, b) in out.velocities.iter_mut().zip(&blow.velocities) {
                *v = v.settled(impulse * *b);
            }
            out.energy = out.energy + plant!("eom: work of an impulse", impulse * missing).scale2(-1);
            blows.push(blow);
        }
    }
    for (c, given) in scene.start_speeds() {
        let follows = place(c).map_or_else(T::zero, |at| out.velocities[at]);
        outcome::consistent(c, n.start(c, given), follows)?;
    }
    for (at, c) in out.coordinates.iter().enumerate() {
        if scene.start_speeds().all(|(given, _)| given != *c) && blow(at, &blows)?.is_some() {
            return Err(Refusal::Open(*c));
        }
    }
    Ok(out)
}
