//! Energy before plus work is energy after, for the whole and for each body alone.
//!
//! Kinetic energy by the decomposition at the mass centre; the work of each force over the displacement of its own point:
//! the pull over the travel of the cord, the weight over the height, a couple over the angle, sliding friction over the
//! slip; rolling friction does none, its point is at rest.
use crate::num::Real;
use crate::num::eliminate::Equations;
use crate::num::plant::plant;
use crate::scene::pose;
use crate::scene::{
    BodyNumbers, Carried, Coordinate, Couple, Degree, Far, GivenForce, Grows, Numbers, Scene, Tie,
};
use crate::solve::energy::speeds::{self, Mode};
use smallvec::{SmallVec, smallvec};

/// `sum m v v' + I w w'` of two modes: twice the kinetic energy if they are the same.
pub fn inertia<T: Real>(n: &Numbers<T>, a: &Mode<T>, b: &Mode<T>) -> T {
    let mut sum: T = T::zero();
    for (i, body) in n.bodies.iter().enumerate() {
        let moving = body.mass * a.v[i] * b.v[i];
        let spinning = body.inertia * a.w[i] * b.w[i];
        sum = sum
            .settled(plant!("energy: kinetic energy of the mass centre", moving))
            .settled(plant!("energy: kinetic energy of rotation", spinning));
    }
    sum
}

/// Force that presses a body on its surface, by a virtual displacement out of it: `N dy + P sin tilt dy - m g cos dy = 0`.
pub fn normal<T: Real>(scene: &Scene, n: &Numbers<T>, body: usize) -> T {
    let BodyNumbers { mass, level, carried, .. } = n.bodies[body];
    let weight = plant!("energy: weight against the surface", mass * n.gravity) * level;
    let tilted = scene.ties.iter().filter_map(Tie::tilted).filter(|(on, ..)| *on == body);
    let weight = tilted.fold(weight, |left, (_, force, tilt)| {
        let [_, out] = pose::direction(n, tilt);
        left.balance(-plant!("energy: work of a pull out of the surface", n.massive(force) * out))
    });
    // Carried out of its surface it gains momentum.
    let gained = |out: Carried<T>| plant!("energy: momentum out of the surface", mass * out.acceleration);
    carried.map_or(weight, |[_, out]| weight.balance(gained(out)))
}

/// One number for each tie.
pub type PerTie<T> = SmallVec<[T; 4]>;

/// A given force, as the power that it has in a mode.
pub struct Power<T> {
    /// Index of the tie or couple that brings it, if it is not a weight.
    pub tie: Option<usize>,
    /// Power per unit rate of the mode.
    pub power: T,
}

/// The powers of all given forces.
pub type Powers<T> = SmallVec<[Power<T>; 6]>;

/// Power of each constant force in a mode. `friction` gives the kinetic friction of a contact, positive forward.
pub fn powers<T: Real>(scene: &Scene, n: &Numbers<T>, mode: &Mode<T>, friction: &[T]) -> Powers<T> {
    let mut list = Powers::new();
    for (b, body) in n.bodies.iter().enumerate() {
        let climb = body.climb * mode.v[b];
        if !climb.is_zero() {
            let power = -plant!("energy: work of the weight", body.mass * n.gravity * climb);
            list.push(Power { tie: None, power });
        }
        if let Some([forward, _]) = body.carried {
            // Of 1/2 m (V + v)^2 the part m V v grows with V, at the cost of the motion on the carrier.
            let shared = plant!("energy: energy shared with the carrier", body.mass * mode.v[b]);
            list.push(Power { tie: None, power: -(shared * forward.acceleration) });
        }
    }
    for c in &scene.couples {
        let turn = mode.w[c.body] * plant!("energy: work of a couple", n.massive(c.moment_n_m));
        list.push(Power { tie: None, power: c.signed(turn) });
    }
    for (t, tie) in scene.ties.iter().enumerate() {
        let power = match tie {
            Tie::Cord(cord) => match &cord.to {
                Far::Pull(p) => plant!("energy: work of the pull", n.massive(*p)) * mode.point(n, &cord.from),
                _ => continue,
            },
            Tie::Slip { body, radius_m, .. } => {
                let contact =
                    mode.v[*body] - plant!("energy: slip of the contact", n.get(*radius_m)) * mode.w[*body];
                plant!("energy: work of sliding friction", friction[t]) * contact
            }
            Tie::Slide { body, .. } => friction[t] * mode.v[*body],
            Tie::Roll { .. } => continue,
        };
        list.push(Power { tie: Some(t), power });
    }
    list
}

/// How much a force or couple has grown at the end.
pub fn grown<T: Real>(scene: &Scene, n: &Numbers<T>, of: GivenForce) -> Option<T> {
    let growth = scene.growth(of)?;
    let extent = plant!("energy: growth of a force", n.get(scene.growing_for()?).abs());
    let own = match growth.law.with {
        Grows::Time => extent,
        // What the ties let its point move while the ending coordinate does.
        Grows::Place => {
            let modes = speeds::modes(scene, n, &[]);
            let mode = modes.first()?;
            match mode.of(scene.ending_coordinate()) {
                held if held.is_zero() => held,
                lead => (works_along(scene, n, mode, of) / lead * extent).abs(),
            }
        }
    };
    Some(n.massive(growth.rate) * growth.law.of(own, n.get(growth.unit)))
}

/// Rate of the point of a given force along it in a mode; of a couple that of its body.
fn works_along<T: Real>(scene: &Scene, n: &Numbers<T>, mode: &Mode<T>, of: GivenForce) -> T {
    match of {
        GivenForce::Pull(t) => match &scene.ties[t] {
            Tie::Cord(cord) => mode.point(n, &cord.from),
            _ => T::zero(),
        },
        GivenForce::Couple(i) => {
            let couple = &scene.couples[i];
            couple.signed(mode.w[couple.body])
        }
    }
}

/// Power in a mode of what the forces that grow have grown by at the end.
pub fn grown_power<T: Real>(scene: &Scene, n: &Numbers<T>, mode: &Mode<T>) -> T {
    scene.growths.iter().fold(T::zero(), |sum, growth| {
        let Some(force) = grown(scene, n, growth.of) else { return sum };
        sum + force * works_along(scene, n, mode, growth.of)
    })
}

/// One reaction for each tie: the friction of a contact (positive forward) or the tension of a cord.
#[derive(Debug, Clone)]
pub struct Reactions<T> {
    all: PerTie<T>,
    open: PerTie<bool>,
}

impl<T> Reactions<T> {
    /// Do the ties share this reaction in a way that no virtual velocity tells apart? Its value is then NaN.
    pub fn is_open(&self, tie: usize) -> bool {
        self.open[tie]
    }
}

impl<T> std::ops::Index<usize> for Reactions<T> {
    type Output = T;
    fn index(&self, tie: usize) -> &T {
        &self.all[tie]
    }
}

/// The reactions, from the rate of the energy balance of each body alone, of its mass centre and of its rotation: the
/// velocity cancels, and what is left holds for every virtual velocity of that body.
///
/// `rate` are the accelerations of all coordinates; `varying` the tension of the spring, or the share of their growth that
/// forces that grow have.
pub fn reactions<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    rate: &dyn Fn(Coordinate) -> T,
    pulls: &[T],
    kinetic: &[Option<T>],
) -> Reactions<T> {
    let ties = scene.ties.len();
    let unknown: SmallVec<[usize; 4]> = (0..ties)
        .filter(|t| match &scene.ties[*t] {
            Tie::Roll { .. } => true,
            Tie::Slip { .. } | Tie::Slide { .. } => kinetic[*t].is_none(),
            Tie::Cord(c) => matches!(c.to, Far::Body(_) | Far::Fixed),
        })
        .collect();
    let cols = unknown.len();
    // The levers are decimals: two forces at one point have one lever, whatever its rounding.
    let mut rows = Equations::of_decimals(cols);
    for c in scene.coordinates().filter(|c| c.degree == Degree::Along || scene.bodies[c.body].turns) {
        let (mut surplus, mut size) = alone(scene, n, c, rate(c), pulls);
        let row = rows.row();
        levers(scene, n, c, pulls, |t, lever, known| match known.or(kinetic[t]) {
            Some(force) => {
                let power = force * lever;
                surplus = surplus + power;
                size += power.size();
            }
            None => {
                if let Some(j) = unknown.iter().position(|u| *u == t) {
                    row[j] = row[j] + lever;
                }
            }
        });
        row[cols] = -surplus;
        rows.sized(size);
    }
    let found = rows.reduce(&[]);
    let mut all: PerTie<T> = kinetic.iter().map(|k| k.unwrap_or_else(T::zero)).collect();
    let mut open: PerTie<bool> = smallvec![false; ties];
    for (j, t) in unknown.into_iter().enumerate() {
        let value = found.value(j);
        open[t] = value.is_none();
        all[t] = value.unwrap_or_else(|| T::of(f64::NAN));
    }
    Reactions { all, open }
}

/// Power of weight and couples on one body alone per unit velocity of one of its coordinates, less the rate of its kinetic energy; and
/// the sum of their magnitudes.
fn alone<T: Real>(scene: &Scene, n: &Numbers<T>, c: Coordinate, own: T, pulls: &[T]) -> (T, f64) {
    let numbers = &n.bodies[c.body];
    let (weight, gain) = match c.degree {
        Degree::Along => (
            -(numbers.mass * n.gravity * numbers.climb),
            -(plant!("energy: rate of the kinetic energy of the centre", numbers.mass) * own),
        ),
        Degree::Turn => {
            (T::zero(), -(plant!("energy: rate of the energy of rotation", numbers.inertia) * own))
        }
    };
    let mut surplus = weight + gain;
    let mut size = weight.size() + gain.size();
    if let (Degree::Along, Some([forward, _])) = (c.degree, numbers.carried) {
        let with = numbers.mass * forward.acceleration;
        surplus = surplus - plant!("energy: momentum of one body with the carrier", with);
        size += with.size();
    }
    let turning = |(_, k): &(usize, &Couple)| k.body == c.body && c.degree == Degree::Turn;
    for (i, k) in scene.couples.iter().enumerate().filter(turning) {
        let growth = grown(scene, n, GivenForce::Couple(i));
        let moment = n.massive(k.moment_n_m);
        let moment = growth.map_or(moment, |growth| moment + growth * pulls[0]);
        surplus = surplus + k.signed(moment);
        size += moment.size();
    }
    (surplus, size)
}

/// Tells of each tie that acts on a coordinate: its index, its lever, and its force if that is given or a spring's.
fn levers<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    c: Coordinate,
    pulls: &[T],
    mut act: impl FnMut(usize, T, Option<T>),
) {
    // A force has the power of its point, here at the unit velocity of the coordinate.
    let [v, w] = speeds::unit(c.degree);
    let mut springs = 0..;
    for (t, tie) in scene.ties.iter().enumerate() {
        match tie {
            Tie::Roll { body, radius_m, .. } | Tie::Slip { body, radius_m, .. } if *body == c.body => {
                let lever = match c.degree {
                    Degree::Along => T::of(1.0),
                    Degree::Turn => -n.get(*radius_m),
                };
                act(t, plant!("energy: friction on one body alone", lever), None);
            }
            Tie::Slide { body, .. } if *body == c.body && c.degree == Degree::Along => {
                act(t, T::of(1.0), None);
            }
            Tie::Cord(cord) => {
                let known = match &cord.to {
                    Far::Pull(p) => {
                        let p = plant!("energy: pull on one body alone", n.massive(*p));
                        let growth = grown(scene, n, GivenForce::Pull(t));
                        Some(growth.map_or(p, |growth| p + growth * pulls[0]))
                    }
                    Far::Spring { .. } => springs.next().and_then(|i| pulls.get(i).copied()),
                    _ => None,
                };
                if cord.from.body == c.body {
                    act(t, speeds::of_end(n, &cord.from, v, w), known);
                }
                if let Far::Body(other) = &cord.to
                    && other.body == c.body
                {
                    act(t, speeds::of_end(n, other, v, w), known);
                }
            }
            _ => {}
        }
    }
}
