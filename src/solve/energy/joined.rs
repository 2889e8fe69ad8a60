//! The motion of joined bodies in the plane from the work of the forces: speed from the balance over the way, accelerations from its
//! rate, the force of a joint from a virtual motion that the joint alone forbids.
//!
//! Velocities are the derivatives of the poses by the leading angle `q`. The kinetic energy of each body is that of two particles
//! of half its mass, as far from its mass centre on either side along its axis as its radius of gyration (equimomental particles):
//! no angular velocity comes in. Where a guide rubs, the balance is drawn up for virtual motions in which normal force and friction
//! together do no work, and solved by collocation. Time is a quadrature in an angle whose cosine is the place: the root
//! singularities at the ends of the way are gone. A body on a pin is one of them; under its weight alone it has closed forms.
//! Source: Routh, *Dynamics of a System of Rigid Bodies*, elementary part, article 33 (equimomental bodies).
mod pin;
mod tell;

use crate::num::dd::pow2;
use crate::num::eliminate::{Equations, Reduced};
use crate::num::gauss::{self, PerNode, Unsettled};
use crate::num::half::Half;
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Dd, Jet, Real, ball, root, trig};
use crate::scene::pose::{self, Layout, Pose};
use crate::scene::{
    Acts, End, Joint, JointKind, Num, Numbers, Owner, Place, Push, Quantity, Rest, Scene, Spot, Strut,
    StrutEnd,
};
use crate::solve::energy::pendulum::Pendulum;
use crate::solve::method::Method;
use crate::solve::outcome::{self, Course, Refusal, Road, Scope, Unsupported};
use smallvec::{SmallVec, smallvec};
use std::cell::{Cell, RefCell};
use std::ops::{Range, RangeInclusive};
use std::rc::Rc;

/// A motion is followed for two turns at most.
const TURNS: f64 = 2.0;
/// Step in which events are looked for, radians.
const STEP: f64 = 0.0625;
/// Turns of an iteration after which a panel is too long.
const TURNS_OF_ITERATION: u32 = 40;
/// Coefficients of a panel of the collocation that are below this share are rounding of the answer, in numbers of 32 digits and in
/// doubles.
const SMOOTH: [f64; 2] = [1e-18, 1e-12];

/// Widths about a root within which a change of sign is looked for, as powers of 2 of its size.
const WIDTHS: RangeInclusive<i32> = -50..=-2;

/// Is its sign known?
fn decided<T: Real>(value: T) -> bool {
    value.size() > value.radius()
}

type Vector<T> = [T; 2];
/// Where all bodies are, with derivatives by the leading angle.
type Poses<T> = pose::Poses<Jet<T>>;
/// A place: the way to it, and if the leading angle there is known better than by that, the angle.
type At<T> = (T, Option<Half<T>>);

/// Where everything is at two places; of a leading body on a fixed pin how far it has moved from the one to the other.
struct Between<'p, T> {
    from: &'p Poses<T>,
    to: &'p Poses<T>,
    swung: Option<(usize, Pose<T>)>,
}

impl<T: Real> Between<'_, T> {
    /// How far the point at these distances along the axis of a body and to its left has moved.
    fn shift(&self, body: usize, at: [T; 2]) -> Vector<T> {
        if let Some((_, pose)) = self.swung.as_ref().filter(|(lead, _)| *lead == body) {
            return pose.point(at);
        }
        let [from, to] = [self.from, self.to].map(|poses| {
            let Pose { origin, axis } = &poses[body];
            Pose { origin: origin.map(|x| x.value), axis: axis.map(|x| x.value) }.point(at)
        });
        [to[0] - from[0], to[1] - from[1]]
    }
}

/// Bodies, forces and joints as an account of work.
struct Account<'a, T: Real> {
    scene: &'a Scene,
    n: &'a Numbers<'a, T>,
    lead: usize,
    layout: Layout<'a, T>,
    /// Distance of the mass centre of each body along its axis, and its radius of gyration.
    centres: SmallVec<[(T, T); 2]>,
    /// Natural length of each spring; 0 of a torsion spring.
    natural: SmallVec<[T; 2]>,
    /// Of each torsion spring the direction of the axis of its body at which it is relaxed.
    relaxed: SmallVec<[Vector<T>; 2]>,
    /// Ways after which springs are met or let go of.
    meets: SmallVec<[T; 4]>,
    /// Sense in which the leading angle changes.
    sense: f64,
    /// Is it a body on a pin, of which all is told as its own, and what has it in closed form?
    pinned: bool,
    pendulum: Option<Pendulum<T>>,
    /// For each joint: sense in which its point slides where it rubs, else 0.
    slides: SmallVec<[f64; 4]>,
    /// The same times the side to which its guide pushes, 1 or -1, if it holds on both.
    rubs: SmallVec<[f64; 4]>,
    /// Did equations leave open which of them say something of their own? Nothing is enclosed then.
    open: Cell<bool>,
    /// The couple that drives the leading body, counter-clockwise.
    drive: Cell<Option<T>>,
    /// Where guides rub: the way as far as its balance has been solved.
    solved: RefCell<Vec<Stretch<T>>>,
    /// Where it has looked for events.
    seen: RefCell<Vec<Rc<Seen<T>>>>,
    /// At how many places it has looked.
    looked: Cell<u64>,
    /// Points of quadratures that are asked for.
    points: Option<usize>,
}

/// A place of the way to the end: several events are looked for at the same ones.
struct Seen<T> {
    way: T,
    poses: Poses<T>,
    half_square: T,
}

/// A part of the way on which the balance has been solved by collocation.
struct Stretch<T> {
    /// The way at its ends.
    ends: (T, T),
    /// Half the square of the rate at its ends.
    squares: (T, T),
    /// What half the square of the rate has gained per way since its start, at the nodes.
    gains: PerNode<T>,
}

/// The forces of a joint, each with the sum of the magnitudes of its terms.
type Forces<T> = SmallVec<[(T, f64); 2]>;
/// For each joint: the rows of its conditions.
type OfJoint = SmallVec<[SmallVec<[usize; 2]>; 4]>;

/// The normal force of a joint, as an account has it.
type Presses<'p, A, T> = dyn Fn(&A, usize) -> Result<Option<T>, Refusal> + 'p;
/// Accelerations of points, told by body and distance along its axis, and of its turn.
type Accelerations<'a, T> = (&'a dyn Fn(usize, T) -> Vector<T>, &'a dyn Fn(usize) -> T);

/// A possible or virtual motion: velocity of the origin of each body's axis, and rate of its angle counter-clockwise.
type Motion<T> = SmallVec<[[T; 3]; 2]>;

/// What a virtual motion makes of the balance: `inertia q'' + bend q'^2 = force`.
#[derive(Debug, Clone, Copy)]
struct Balance<T> {
    inertia: T,
    bend: T,
    force: T,
    /// Sum of the magnitudes of the terms of the force.
    size: f64,
}

/// The lesser of two.
fn least<T: Real>(one: T, other: &T) -> T {
    if other.below(one) { *other } else { one }
}
fn dot<T: Real>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1]
}

/// Moment of a unit vector at a point of a body about the origin of its axis.
fn about<T: Real>(poses: &Poses<T>, body: usize, [along, aside]: Vector<T>, u: Vector<T>) -> T {
    let [c, s] = poses[body].axis.map(|x| x.value);
    let turn = along * (u[1] * c - u[0] * s);
    if aside.is_zero() { turn } else { turn - aside * (u[0] * c + u[1] * s) }
}

/// Everything that work and energy say of a scene of joined bodies, the time only if it is asked, and at how many places they looked.
/// With `points`, speed and time of a body on a pin come from the work of its forces, summed by quadratures of so many points.
///
/// Errors: joints that do not determine the motion, a quadrature that does not settle, points for other bodies.
pub fn road<T: Real>(
    scene: &Scene,
    n: &Numbers<T>,
    asked: Scope,
    points: Option<usize>,
) -> Result<(Road<T>, Count), Refusal> {
    let plane = scene.in_the_plane();
    let mut account = Account::new(&plane, n)?;
    account.pinned = scene.pinned().is_some();
    account.points = points;
    if points.is_some() && !account.pinned {
        return Err(Refusal::NoMethod { method: Method::Gauss });
    }
    let mut road = account.road(asked)?;
    if account.open.get() {
        road.said.iter_mut().for_each(|said| said.value = said.value.widened(|| f64::INFINITY));
    }
    Ok((road, Count { evaluations: account.looked.get(), ..Count::default() }))
}

impl<T: Real> Account<'_, T> {
    fn road(&mut self, asked: Scope) -> Result<Road<T>, Refusal> {
        let scene = self.scene;
        let mut spin = self.layout.start_rate().ok_or(Refusal::Freedoms(2))?;
        let mut road = Road::new(asked);
        if self.pinned {
            self.tell_lasting(spin, asked, &mut road)?;
        }
        if matches!(scene.end, End::AtOnce) {
            self.instant(spin, &mut road)?;
            return Ok(road);
        }
        if scene.end == End::Equilibrium {
            let (found, doubt) = ball::watch(|| self.rest(&mut road));
            self.open.set(doubt);
            return found.map(|()| road);
        }
        let first = self.poses(T::zero())?;
        if scene.is_struck() {
            // The momentum that belongs to the leading angle gains what the blows do at its unit rate.
            let unit = self.rates(&first);
            let gained = self.powers(&first, &unit, true).into_iter().fold(T::zero(), |sum, p| sum + p);
            // What strikes straight at a joint moves nothing.
            let blows = scene.pushes.iter().filter(|p| p.blow);
            let blows: f64 = blows.map(|p| self.n.massive(p.force_n).size()).sum();
            let fastest = unit.iter().flatten().map(|x| x.size()).fold(0.0, f64::max);
            let gained = gained.cleared(blows * fastest) / self.inertia(&first);
            spin = spin.balance(gained);
            let jump = unit.iter().map(|r| r.map(|x| x * gained)).collect();
            self.tell_blow(&first, &jump, &mut road);
        }
        let free = self.balance(&first, &self.rates(&first))?;
        let rate = free.force.balance(-(free.bend * spin.square())).cleared(free.size);
        self.sense = if spin.is_zero() { rate.sign() } else { spin.sign() };
        let motion = self.rates(&first).iter().map(|r| r.map(|x| x.signed(self.sense))).collect();
        self.slides = self.sliding(&first, &motion);
        self.press(&|account, joint| account.normal(&first, spin.square(), joint))?;
        let own = self.across_friction(&first)?;
        let rubbed = self.balance(&first, &own)?;
        let sets_off = rubbed.force.balance(-(rubbed.bend * spin.square())).cleared(rubbed.size)
            / rubbed.inertia.signed(self.sense);
        if self.sense == 0.0 || spin.is_zero() && sets_off.sign() <= 0.0 {
            road.course = Some(Course::at_rest());
            self.tell_standing(&first, T::zero(), &mut road)?;
            return Ok(road);
        }
        let drive = (free.force.signed(self.sense), rubbed.force.signed(self.sense));
        self.meets = ball::unwatched(|| self.springs_met());
        if matches!(scene.end, End::Angle(..)) {
            self.settle(spin, drive, (asked, &mut road))?;
        } else {
            // Where the end is searched for and a comparison is left open, nothing is enclosed, and it is no doubt which way it goes.
            self.settled(|| self.settle(spin, drive, (asked, &mut road)))?;
        }
        Ok(road)
    }
}

impl<'a, T: Real> Account<'a, T> {
    fn new(scene: &'a Scene, n: &'a Numbers<'a, T>) -> Result<Self, Refusal> {
        let lead = scene.lead().ok_or(Refusal::Freedoms(0))?;
        let centres = scene.bodies.iter().zip(&n.bodies).map(|(body, numbers)| {
            let centre = body.planar.as_ref().map_or(Place::At(crate::scene::Num::Fixed(0.0)), |p| p.centre);
            let turns = body.turns && !numbers.inertia.is_zero();
            let gyration = if turns { (numbers.inertia / numbers.mass).root() } else { T::zero() };
            (pose::along(n, centre), gyration)
        });
        let mut account = Self {
            scene,
            n,
            lead,
            layout: Layout::new(scene, n).ok_or(Refusal::Freedoms(2))?,
            centres: centres.collect(),
            natural: SmallVec::new(),
            relaxed: SmallVec::new(),
            meets: SmallVec::new(),
            sense: 1.0,
            pinned: false,
            pendulum: None,
            slides: scene.joints.iter().map(|_| 0.0).collect(),
            rubs: scene.joints.iter().map(|_| 0.0).collect(),
            open: Cell::new(false),
            drive: Cell::new(None),
            solved: RefCell::new(Vec::new()),
            seen: RefCell::new(Vec::new()),
            looked: Cell::new(0),
            points: None,
        };
        let poses = account.placed()?;
        for (s, strut) in scene.struts.iter().enumerate() {
            account.relaxed.push(account.layout.relaxed(strut).ok_or(Refusal::Freedoms(2))?);
            account.natural.push(match strut.rest {
                _ if strut.twists() => T::zero(),
                Rest::Length(l) => n.get(l),
                Rest::Stretch(x) => account.length(&poses, s).value - n.get(x),
            });
        }
        Ok(account)
    }

    fn poses(&self, way: T) -> Result<Poses<T>, Refusal> {
        self.looked.set(self.looked.get() + 1);
        self.layout.poses(way.signed(self.sense), false).ok_or(Refusal::Freedoms(2))
    }
    /// Where everything is at a place.
    fn at(&self, (way, angle): &At<T>) -> Result<Poses<T>, Refusal> {
        let mut poses = self.poses(*way)?;
        if let Some(pose) = angle.and_then(|angle| self.layout.hung(&angle)) {
            poses[self.lead] = pose;
        }
        Ok(poses)
    }
    /// The start and a place, where everything lies so.
    fn between<'p>(&self, from: &'p Poses<T>, to: &'p Poses<T>, (way, angle): &At<T>) -> Between<'p, T> {
        let swung = self.layout.swung(way.signed(self.sense), angle.as_ref());
        Between { from, to, swung: swung.map(|pose| (self.lead, pose)) }
    }
    /// Where everything is at the start.
    fn placed(&self) -> Result<Poses<T>, Refusal> {
        self.layout.poses(T::zero(), true).ok_or(Refusal::Freedoms(2))
    }
    /// Ways after which springs that only push or pull are met or let go of, one after the other.
    fn springs_met(&self) -> SmallVec<[T; 4]> {
        let horizon = T::constant(Dd::PI * Dd::new(2.0 * TURNS));
        let one_sided = |s: &usize| self.scene.struts[*s].acts != Acts::Both;
        let all = (0..self.scene.struts.len()).filter(one_sided).flat_map(|s| {
            let value = |way: T| Ok::<_, Refusal>(self.length(&self.poses(way)?, s).value - self.natural[s]);
            root::changes((horizon, T::of(STEP)), &value).unwrap_or_default()
        });
        let mut all: SmallVec<[T; 4]> = all.collect();
        all.sort_by(|a, b| a.f64().total_cmp(&b.f64()));
        all
    }
    fn point(&self, poses: &Poses<T>, spot: Spot) -> pose::Point<T> {
        poses[spot.body].point(pose::of_spot(self.scene, self.n, spot))
    }
    fn centre(&self, poses: &Poses<T>, body: usize) -> pose::Point<T> {
        poses[body].point([self.centres[body].0, T::zero()])
    }
    /// The two particles that move as the body does.
    fn particles(&self, poses: &Poses<T>, body: usize) -> [pose::Point<T>; 2] {
        let (centre, gyration) = self.centres[body];
        let apart = plant!("energy: equimomental particles", gyration);
        [centre + apart, centre - apart].map(|along| poses[body].point([along, T::zero()]))
    }
    /// From one end of a spring to the other; of a torsion spring the angle of its body from where that is relaxed.
    fn apart(&self, poses: &Poses<T>, s: usize) -> pose::Point<T> {
        let Strut { at, to, .. } = &self.scene.struts[s];
        let near = self.point(poses, *at);
        let far = match to {
            StrutEnd::Twist => {
                let (Pose { axis, .. }, sense) = (&poses[at.body], self.counts(at.body));
                let planar = self.scene.planar(at.body);
                let turned = |p| pose::turned_from(p, axis.map(|x| x.value), self.relaxed[s]);
                let (first, second) = poses[at.body].turn();
                let value = planar.map_or_else(T::zero, turned);
                let angle = Jet { value, first: first.signed(sense), second: second.signed(sense) };
                return [angle, Jet::fixed(T::zero())];
            }
            StrutEnd::Ground(place) => pose::ground(self.n, *place).map(Jet::fixed),
            StrutEnd::Spot(spot) => self.point(poses, *spot),
            StrutEnd::Guide { through_m, direction_deg } => {
                let line = [pose::ground(self.n, *through_m), pose::direction(self.n, *direction_deg)];
                let [through, along] = line.map(|x| x.map(Jet::fixed));
                pose::foot(near, through, along)
            }
        };
        [far[0] - near[0], far[1] - near[1]]
    }
    /// Length of a spring; of a torsion spring that angle.
    fn length(&self, poses: &Poses<T>, s: usize) -> Jet<T> {
        let [x, y] = self.apart(poses, s);
        if self.scene.struts[s].twists() { x } else { (x * x + y * y).root() }
    }

    /// The first way up to which a torsion spring is wound by half a turn.
    fn overwinds(&self, far: (T, T)) -> Option<T> {
        ball::unwatched(|| {
            let all = self.scene.struts.iter().zip(&self.relaxed).filter(|(strut, _)| strut.twists());
            let ways =
                all.filter_map(|(strut, relaxed)| self.layout.overwinds(strut, *relaxed, self.sense, far));
            ways.reduce(|one, other| least(one, &other))
        })
    }
    /// Does a spring of this length press, or pull, where it can do but one of them?
    fn bears(&self, s: usize, length: T) -> bool {
        match self.scene.struts[s].acts {
            Acts::Both => true,
            Acts::Pushes => length.below(self.natural[s]),
            Acts::Pulls => self.natural[s].below(length),
        }
    }

    /// The motion of unit rate of the leading angle.
    fn rates(&self, poses: &Poses<T>) -> Motion<T> {
        if self.pinned {
            return smallvec![[T::zero(), T::zero(), T::of(self.counts(self.lead))]];
        }
        poses.iter().map(|p| [p.origin[0].first, p.origin[1].first, p.turn().0]).collect()
    }
    /// Velocity of a point at a distance along the axis of a body in a motion.
    fn velocity(&self, poses: &Poses<T>, motion: &Motion<T>, body: usize, along: T) -> Vector<T> {
        let ([x, y, turn], axis) = (motion[body], poses[body].axis);
        [x - turn * along * axis[1].value, y + turn * along * axis[0].value]
    }
    fn of_spot(&self, poses: &Poses<T>, motion: &Motion<T>, spot: Spot) -> Vector<T> {
        let [along, aside] = pose::of_spot(self.scene, self.n, spot);
        let v = self.velocity(poses, motion, spot.body, along);
        if aside.is_zero() {
            return v;
        }
        let (turn, axis) = (motion[spot.body][2], poses[spot.body].axis);
        [v[0] - turn * aside * axis[0].value, v[1] - turn * aside * axis[1].value]
    }

    /// For each joint: in which sense its point slides in a guide that rubs, by a motion.
    fn sliding(&self, poses: &Poses<T>, motion: &Motion<T>) -> SmallVec<[f64; 4]> {
        let sense = |(joint, u): (&Joint, &Vector<T>)| {
            let Some((at, _)) = joint.kind.rubs() else { return 0.0 };
            let v = self.of_spot(poses, motion, at);
            (v[0] * u[0]).balance(v[1] * u[1]).sign()
        };
        self.scene.joints.iter().zip(&self.layout.lines).map(sense).collect()
    }

    /// Notes to which side guides push that hold on both and rub, by the normal forces that result.
    fn press(&mut self, normal: &Presses<Self, T>) -> Result<(), Refusal> {
        self.rubs = self.slides.clone();
        let rubs_on_both = |j: &usize| {
            self.slides[*j] != 0.0 && matches!(self.scene.joints[*j].kind.rubs(), Some((_, true)))
        };
        let both: SmallVec<[usize; 4]> = (0..self.slides.len()).filter(rubs_on_both).collect();
        let turn = |account: &mut Self, sides: &[f64]| {
            both.iter().zip(sides).for_each(|(j, side)| account.rubs[*j] = account.slides[*j] * side);
        };
        let sides = outcome::sides(both.len(), |sides| {
            turn(self, sides);
            for (joint, side) in both.iter().zip(sides) {
                if normal(self, *joint)?.is_some_and(|force| force.signed(*side).sign() < 0.0) {
                    return Ok(false);
                }
            }
            Ok(true)
        })?;
        turn(self, &sides);
        Ok(())
    }

    /// Solves equations: that rounding may leave open which of them repeat others is noted, and is no doubt which way it goes.
    fn settled<R>(&self, solve: impl FnOnce() -> R) -> R {
        let (solved, doubt) = ball::watch(solve);
        self.open.set(self.open.get() || doubt);
        solved
    }

    /// What the joints forbid: the rows of their conditions, where a guide rubs that of its normal force with its friction.
    /// `held` is the motion that the last rows keep from: the leading angle, and a drift.
    fn conditions(&self, poses: &Poses<T>, virtually: bool, rights: usize) -> (Equations<T>, OfJoint) {
        let columns = 3 * self.scene.bodies.len();
        let mut rows = Equations::with_rights(columns, rights);
        let mut of_joint = OfJoint::new();
        let mut count = 0;
        for (j, (joint, rubs)) in self.scene.joints.iter().zip(&self.rubs).enumerate() {
            let mut rim = T::zero();
            let ground: Option<(Spot, SmallVec<[Vector<T>; 2]>)> = match joint.kind {
                JointKind::Pin { at, .. } => {
                    Some((at, smallvec![[T::of(1.0), T::zero()], [T::zero(), T::of(1.0)]]))
                }
                JointKind::Contact { at, rolls, teeth, .. } => {
                    let centre = self.point(poses, at).map(|x| x.value);
                    self.layout.touch(j, centre).map(|touch| {
                        rim = plant!("energy: radius of a rolling wheel", touch.radius);
                        let both = [touch.normal, touch.along];
                        (at, both[usize::from(teeth)..1 + usize::from(rolls)].iter().copied().collect())
                    })
                }
                JointKind::Guide { at, mu_k, .. } => {
                    let [c, s] = self.layout.lines[j];
                    let rub = match mu_k {
                        Some(mu) if virtually && *rubs != 0.0 => {
                            plant!("energy: friction in a guide", self.n.get(mu)).signed(*rubs)
                        }
                        _ => T::zero(),
                    };
                    Some((at, smallvec![[-s - rub * c, c - rub * s]]))
                }
                JointKind::Cord { at, place_m, .. } => {
                    let (near, far) = (self.point(poses, at), pose::ground(self.n, place_m));
                    let apart = [far[0] - near[0].value, far[1] - near[1].value];
                    let length = dot(apart, apart).root();
                    Some((at, smallvec![apart.map(|x| x / length)]))
                }
                JointKind::Hinge { .. } => None,
            };
            let mut own: SmallVec<[usize; 2]> = SmallVec::new();
            let mut add = |ends: &[(Spot, Vector<T>, T)]| {
                let row = rows.row();
                for (spot, u, rim) in ends {
                    // Velocities of the point by those of the origin and the turn.
                    let r = pose::of_spot(self.scene, self.n, *spot);
                    let at = 3 * spot.body;
                    row[at] = row[at] + u[0];
                    row[at + 1] = row[at + 1] + u[1];
                    row[at + 2] = row[at + 2]
                        + plant!("energy: turn about the origin of the axis", about(poses, spot.body, r, *u))
                        + *rim;
                }
                own.push(count);
                count += 1;
            };
            match (ground, joint.kind) {
                // The last condition of a wheel that rolls is that its rim does not slip.
                (Some((at, directions)), kind) => {
                    let rolls = matches!(kind, JointKind::Contact { rolls: true, .. });
                    for (i, u) in directions.iter().enumerate() {
                        let slips = rolls && i + 1 == directions.len();
                        add(&[(at, *u, if slips { rim } else { T::zero() })]);
                    }
                }
                (None, JointKind::Hinge { one, other, turned_deg }) => {
                    let none = T::zero();
                    for u in [[T::of(1.0), none], [none, T::of(1.0)]] {
                        add(&[(one, u, none), (other, u.map(|x| -x), none)]);
                    }
                    if turned_deg.is_some() {
                        let turn = plant!("energy: turn of a weld", T::of(-1.0));
                        add(&[(one, [none; 2], T::of(1.0)), (other, [none; 2], turn)]);
                    }
                }
                _ => {}
            }
            of_joint.push(own);
        }
        for (b, body) in self.scene.bodies.iter().enumerate() {
            if !body.turns {
                rows.row()[3 * b + 2] = T::of(1.0);
            }
        }
        (rows, of_joint)
    }

    /// Adds that the mass centre of the leading body keeps from drifting, where nothing but that holds it.
    fn no_drift(&self, poses: &Poses<T>, rows: &mut Equations<T>) {
        if let Some(direction) = self.scene.drifts() {
            let [c, s] = pose::direction(self.n, direction);
            let axis = poses[self.lead].axis;
            let row = rows.row();
            (row[3 * self.lead], row[3 * self.lead + 1]) = (c, s);
            row[3 * self.lead + 2] = self.centres[self.lead].0 * (s * axis[0].value - c * axis[1].value);
        }
    }

    /// Adds what the leading angle moves, at this rate: the turn of the body, its centre about the axis of a cylinder, or its way
    /// along guides.
    fn leading(&self, poses: &Poses<T>, rows: &mut Equations<T>, rate: T) {
        let (columns, at) = (3 * self.scene.bodies.len(), 3 * self.lead);
        let (mut along, mut turn) = ([T::zero(); 2], T::of(1.0));
        if let Some(unit) = self.layout.glide() {
            let centre = [self.centres[self.lead].0, T::zero()];
            (along, turn) = (unit, about(poses, self.lead, centre, unit));
        }
        if let Some(arc) = self.layout.arc()
            && let Some(spot) = self.scene.joints[arc.joint].kind.spots().next()
        {
            let place = self.point(poses, spot).map(|x| x.value);
            along = [arc.axis[1] - place[1], place[0] - arc.axis[0]];
            turn = about(poses, self.lead, pose::of_spot(self.scene, self.n, spot), along);
        }
        let row = rows.row();
        (row[at], row[at + 1], row[at + 2], row[columns]) = (along[0], along[1], turn, rate);
    }
    /// The rate of what [`Self::leading`] tells in the motion of unit rate of the leading angle.
    fn unit(&self, poses: &Poses<T>) -> T {
        match self.layout.arc() {
            Some(arc) => arc.apart.square().signed(self.counts(self.lead)),
            None if self.layout.glide().is_some() => T::of(1.0),
            None => poses[self.lead].turn().0,
        }
    }

    fn motion(&self, reduced: &Reduced<T>) -> Motion<T> {
        (0..self.scene.bodies.len()).map(|b| [0, 1, 2].map(|i| reduced.at_zero(3 * b + i))).collect()
    }

    /// The virtual motion in which normal forces and their friction do no work: that of the bodies where nothing rubs.
    fn across_friction(&self, poses: &Poses<T>) -> Result<Motion<T>, Refusal> {
        if !self.is_rubbed() {
            return Ok(self.rates(poses));
        }
        let (mut rows, _) = self.conditions(poses, true, 1);
        self.no_drift(poses, &mut rows);
        self.leading(poses, &mut rows, self.unit(poses));
        let reduced = self.settled(|| rows.reduce(&[]));
        if reduced.open().is_empty() { Ok(self.motion(&reduced)) } else { Err(Refusal::Freedoms(2)) }
    }

    /// The balance of all bodies in a virtual motion.
    fn balance(&self, poses: &Poses<T>, motion: &Motion<T>) -> Result<Balance<T>, Refusal> {
        let zero = T::zero();
        let mut balance = Balance { inertia: zero, bend: zero, force: zero, size: 0.0 };
        if self.pinned {
            // About a fixed pin it does not change.
            balance.inertia = self.inertia(poses);
        }
        for (b, numbers) in self.n.bodies.iter().enumerate().filter(|_| !self.pinned) {
            let (centre, gyration) = self.centres[b];
            let half = numbers.mass.scale2(-1);
            for (particle, along) in
                self.particles(poses, b).iter().zip([centre + gyration, centre - gyration])
            {
                let v = self.velocity(poses, motion, b, along);
                let (first, second) = (particle.map(|x| x.first), particle.map(|x| x.second));
                balance.inertia =
                    balance.inertia + plant!("energy: inertia over the angle", half * dot(v, first));
                balance.bend = balance.bend + plant!("energy: change of the inertia", half * dot(v, second));
            }
        }
        for power in self.powers(poses, motion, false) {
            balance.force = balance.force + power;
            balance.size += power.size();
        }
        balance.force = balance.force.cleared(balance.size);
        Ok(balance)
    }

    /// Twice the kinetic energy at unit rate of the leading angle.
    fn inertia(&self, poses: &Poses<T>) -> T {
        if self.pinned {
            let (numbers, (arm, _)) = (&self.n.bodies[self.lead], self.centres[self.lead]);
            let carried =
                plant!("energy: speed of the mass centre about the pin", numbers.mass * arm.square());
            return carried + plant!("energy: rotation about the pin", numbers.inertia);
        }
        let mut sum = T::zero();
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let half = plant!("energy: inertia over the angle", numbers.mass.scale2(-1));
            let (centre, gyration) = self.centres[b];
            let apart = plant!("energy: equimomental particles", gyration);
            for along in [centre + apart, centre - apart] {
                let Pose { origin, axis } = &poses[b];
                let [x, y] = [0, 1].map(|i| origin[i].first + axis[i].first * along);
                sum = sum + half * (x.square() + y.square());
            }
        }
        sum
    }

    /// Powers of weights, forces, couples and springs in a motion; or what the blows at the start do in it.
    fn powers(&self, poses: &Poses<T>, motion: &Motion<T>, blows: bool) -> SmallVec<[T; 6]> {
        let mut powers: SmallVec<[T; 6]> = SmallVec::new();
        if blows {
            return self.pushed(poses, motion, true).collect();
        }
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let velocity = self.velocity(poses, motion, b, self.centres[b].0);
            powers.push(-plant!(
                "energy: power of the weight in the plane",
                numbers.mass * self.n.gravity * velocity[1]
            ));
            // Of 1/2 m (V + v)^2 the part m V . v grows with V, at the cost of the motion on the carrier.
            let shared = self.n.carried.map(|a| numbers.mass * dot(a, velocity));
            powers.extend(shared.map(|x| -plant!("energy: power shared with the carrier", x)));
        }
        powers.extend(self.applied(poses, motion));
        powers
    }

    /// Powers of forces, or what blows do.
    fn pushed(&self, poses: &Poses<T>, motion: &Motion<T>, blows: bool) -> impl Iterator<Item = T> {
        let pushes = self.scene.pushes.iter().zip(&self.layout.pushes).filter(move |(p, _)| p.blow == blows);
        pushes.map(move |(push, direction)| {
            let u = self.push(poses, push, *direction);
            let p = plant!("energy: power of a force on a point", self.n.massive(push.force_n));
            p * dot(u, self.of_spot(poses, motion, push.at))
        })
    }

    /// Powers of forces, couples and springs.
    fn applied(&self, poses: &Poses<T>, motion: &Motion<T>) -> SmallVec<[T; 6]> {
        let mut powers: SmallVec<[T; 6]> = self.pushed(poses, motion, false).collect();
        powers.extend(self.drive.get().map(|moment| moment * motion[self.lead][2]));
        for c in &self.scene.couples {
            let moment = plant!("energy: power of a couple in the plane", self.n.massive(c.moment_n_m));
            let turn = motion[c.body][2].signed(self.counts(c.body));
            powers.push(moment * if c.forward { turn } else { -turn });
        }
        for (s, (strut, natural)) in self.scene.struts.iter().zip(&self.natural).enumerate() {
            if strut.acts != Acts::Both && !self.bears(s, self.length(poses, s).value) {
                continue;
            }
            let near = self.point(poses, strut.at).map(|x| x.value);
            let (far, moves) = match strut.to {
                StrutEnd::Twist => {
                    let turn = motion[strut.at.body][2].signed(self.counts(strut.at.body));
                    let stiffness =
                        plant!("energy: power of a torsion spring", self.n.massive(strut.stiffness_n_m));
                    powers.push(-(stiffness * self.length(poses, s).value * turn));
                    continue;
                }
                StrutEnd::Ground(place) => (pose::ground(self.n, place), [T::zero(); 2]),
                StrutEnd::Spot(spot) => {
                    (self.point(poses, spot).map(|x| x.value), self.of_spot(poses, motion, spot))
                }
                // It moves along the guide, across the spring.
                StrutEnd::Guide { through_m, direction_deg } => {
                    let (through, along) =
                        (pose::ground(self.n, through_m), pose::direction(self.n, direction_deg));
                    (pose::foot(near, through, along), [T::zero(); 2])
                }
            };
            let apart = [far[0] - near[0], far[1] - near[1]];
            let length = dot(apart, apart).root();
            let v = self.of_spot(poses, motion, strut.at);
            let longer = dot(apart, [moves[0] - v[0], moves[1] - v[1]]);
            let stiffness =
                plant!("energy: power of a spring in the plane", self.n.massive(strut.stiffness_n_m));
            let slope = if natural.is_zero() { stiffness } else { stiffness * (length - *natural) / length };
            powers.push(-(slope * longer));
        }
        powers
    }

    /// Direction of a force.
    fn push(&self, poses: &Poses<T>, push: &Push, [c, s]: Vector<T>) -> Vector<T> {
        if let Some(place) = push.toward_m {
            let length = self.off(poses, push.at, place);
            let [x, y] = self.to_place(poses, push.at, place).map(|x| x.value);
            return [x, y].map(|x| x / length.value);
        }
        let axis = poses[push.at.body].axis.map(|x| x.value);
        if push.turns { [axis[0] * c - axis[1] * s, axis[1] * c + axis[0] * s] } else { [c, s] }
    }

    /// From a point to a place.
    fn to_place(&self, poses: &Poses<T>, at: Spot, place_m: [Num; 2]) -> pose::Point<T> {
        let (at, place) = (self.point(poses, at), pose::ground(self.n, place_m));
        [0, 1].map(|i| Jet::fixed(place[i]) - at[i])
    }
    /// How far a point is off a place.
    fn off(&self, poses: &Poses<T>, at: Spot, place_m: [Num; 2]) -> Jet<T> {
        let [x, y] = self.to_place(poses, at, place_m);
        (x * x + y * y).root()
    }

    /// 1 where the angle of a body counts counter-clockwise, else -1.
    fn counts(&self, body: usize) -> f64 {
        if self.scene.bodies[body].planar.as_ref().is_some_and(|p| p.clockwise) { -1.0 } else { 1.0 }
    }

    /// Work of all forces between two places, so far apart.
    fn work(&self, places: &Between<T>, way: T) -> Result<T, Refusal> {
        let Between { from, to, .. } = *places;
        let (mut work, mut size) = (T::zero(), 0.0);
        let mut add = |w: T| {
            work = work + w;
            size += w.size();
        };
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let [aside, fallen] = places.shift(b, [self.centres[b].0, T::zero()]).map(|x| -x);
            add(plant!("energy: work of the weight in the plane", numbers.mass * self.n.gravity * fallen));
            if let Some(a) = self.n.carried {
                let shared = dot(a, [aside, fallen]);
                add(plant!("energy: energy shared with the carrier in the plane", numbers.mass * shared));
            }
        }
        for (push, direction) in self.scene.pushes.iter().zip(&self.layout.pushes).filter(|(p, _)| !p.blow) {
            let p = plant!("energy: work of a force on a point", self.n.massive(push.force_n));
            if let Some(place) = push.toward_m {
                let [a, b] = [from, to].map(|poses| self.off(poses, push.at, place).value);
                add(p * (a - b));
            } else if push.turns {
                let power = |at: T| {
                    let poses = self.poses(at)?;
                    let v = self.point(&poses, push.at).map(|x| x.first.signed(self.sense));
                    Ok::<_, Refusal>(dot(self.push(&poses, push, *direction), v))
                };
                let terms = pose::size(self.scene, self.n);
                add(p * gauss::integral_of_terms(power, (T::zero(), way), terms)?);
            } else {
                add(p * dot(self.push(from, push, *direction), self.shift(places, push.at)));
            }
        }
        for c in &self.scene.couples {
            let turned = if c.body == self.lead && self.layout.arc().is_none() {
                way.signed(self.sense)
            } else {
                let rate = |at: T| Ok::<_, Refusal>(self.poses(at)?[c.body].turn().0.signed(self.sense));
                // A body that only moves turns by rounding alone, beside the one that leads.
                gauss::integral_of_terms(rate, (T::zero(), way), 1.0)?.signed(self.counts(c.body))
            };
            let moment = plant!("energy: work of a couple in the plane", self.n.massive(c.moment_n_m));
            add(moment * if c.forward { turned } else { -turned });
        }
        for (s, strut) in self.scene.struts.iter().enumerate() {
            let stiffness =
                plant!("energy: work of a spring in the plane", self.n.massive(strut.stiffness_n_m));
            add((stiffness * self.released(s, places)).scale2(-1));
        }
        Ok(work.cleared(size))
    }

    /// How far a point has moved.
    fn shift(&self, places: &Between<T>, spot: Spot) -> Vector<T> {
        places.shift(spot.body, pose::of_spot(self.scene, self.n, spot))
    }

    /// By how much the square of the stretch of a spring has shrunk, as `(x0 - x1)(x0 + x1)`; the difference of two lengths is that
    /// of their squares over their sum.
    fn released(&self, s: usize, places: &Between<T>) -> T {
        let (strut, natural) = (&self.scene.struts[s], self.natural[s]);
        let ends = [places.from, places.to];
        let lengths = ends.map(|poses| self.length(poses, s).value);
        // Where it does not act, it is as if it had its natural length.
        let [a, b] = lengths.map(|length| if self.bears(s, length) { length } else { natural });
        let near = self.shift(places, strut.at);
        let far = match strut.to {
            StrutEnd::Twist => None,
            StrutEnd::Ground(_) => Some([T::zero(); 2]),
            StrutEnd::Spot(spot) => Some(self.shift(places, spot)),
            StrutEnd::Guide { direction_deg, .. } => {
                let along = pose::direction(self.n, direction_deg);
                Some(along.map(|u| u * dot(near, along)))
            }
        };
        let whole = lengths.iter().all(|length| self.bears(s, *length)) && (a + b).size() > 0.0;
        let shorter = match far.filter(|_| whole) {
            Some(far) => {
                let [first, last] = ends.map(|poses| self.apart(poses, s).map(|x| x.value));
                let change = [near[0] - far[0], near[1] - far[1]];
                dot(change, [first[0] + last[0], first[1] + last[1]]) / (a + b)
            }
            None => a - b,
        };
        shorter * ((a - natural) + (b - natural))
    }

    /// Half the square of the rate after a way, from that at the start; `first` is where everything is there.
    fn half_square(&self, way: T, start: (&Poses<T>, T)) -> Result<T, Refusal> {
        self.half_square_at(&(way, None), start)
    }
    fn half_square_at(&self, place: &At<T>, (first, from): (&Poses<T>, T)) -> Result<T, Refusal> {
        if self.is_rubbed() {
            return self.collocated(place.0, from);
        }
        self.balanced(&self.at(place)?, place, (first, from))
    }
    /// The same where nothing rubs and everything is so at that place.
    fn balanced(&self, poses: &Poses<T>, place: &At<T>, (first, from): (&Poses<T>, T)) -> Result<T, Refusal> {
        let kinetic = if from.is_zero() { from } else { self.inertia(first) * from };
        let work = self.work(&self.between(first, poses, place), place.0)?;
        Ok(kinetic.balance(work) / self.inertia(poses))
    }
    fn is_rubbed(&self) -> bool {
        self.rubs.iter().any(|s| *s != 0.0)
    }
    /// A place at which an event is looked for.
    fn there(&self, way: T, from: (&Poses<T>, T)) -> Result<Rc<Seen<T>>, Refusal> {
        if let Some(seen) = self.seen.borrow().iter().find(|seen| seen.way.same(way)) {
            return Ok(Rc::clone(seen));
        }
        let poses = self.poses(way)?;
        let half_square = match self.is_rubbed() {
            true => self.collocated(way, from.1)?,
            false => self.balanced(&poses, &(way, None), from)?,
        };
        let seen = Rc::new(Seen { way, poses, half_square });
        self.seen.borrow_mut().push(Rc::clone(&seen));
        Ok(seen)
    }
    /// [`Self::normal`] there.
    fn normal_there(&self, joint: usize, way: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        let seen = self.there(way, from)?;
        self.normal(&seen.poses, seen.half_square.scale2(1), joint)
    }

    /// The same where guides rub: the balance of virtual motions, `dy/dq = (force - 2 bend y) / inertia`, by collocation.
    fn collocated(&self, way: T, from: T) -> Result<T, Refusal> {
        let widened = T::of(1.0).widened(|| f64::INFINITY);
        if widened.radius() > 0.0 {
            return Ok(widened);
        }
        if way.sign() <= 0.0 {
            return Ok(from);
        }
        let mut solved = self.solved.borrow_mut();
        while solved.last().is_none_or(|s| s.ends.1.below(way)) {
            let (at, square) = solved.last().map_or((T::zero(), from), |s| (s.ends.1, s.squares.1));
            let mut next = self.meets.iter().filter(|x| at.below(**x)).fold(at + T::of(8.0 * STEP), least);
            let stretch = (0..=gauss::halvings()).find_map(|_| {
                let stretch = self.collocate((at, next), square).transpose();
                next = (at + next).scale2(-1);
                stretch
            });
            let unsettled = || Unsettled { value: square.f64(), gap: f64::INFINITY }.into();
            solved.push(stretch.unwrap_or_else(|| Err(unsettled()))?);
        }
        let within = solved.iter().find(|s| way.at_most(s.ends.1));
        Ok(within.map_or(from, |Stretch { ends: (a, b), squares: (start, _), gains }| {
            *start + gauss::at(gains, (way - *a) / (*b - *a)) * (way - *a)
        }))
    }

    /// One panel of the collocation; `None` if it is too long.
    fn collocate(&self, ends: (T, T), from: T) -> Result<Option<Stretch<T>>, Refusal> {
        let width = ends.1 - ends.0;
        let (mut forces, mut bends) = (PerNode::new(), PerNode::new());
        for node in gauss::nodes() {
            let poses = self.poses(ends.0 + width * T::constant(*node))?;
            let balance = self.balance(&poses, &self.across_friction(&poses)?)?;
            let per = width.signed(self.sense) / balance.inertia;
            forces.push(balance.force * per);
            bends.push((balance.bend * per).scale2(1));
        }
        let share = SMOOTH[usize::from(T::is_double())];
        if !gauss::smooth(&forces, share)
            || !bends.iter().all(|b| b.is_zero()) && !gauss::smooth(&bends, share)
        {
            return Ok(None);
        }
        // Each turn of the iteration gains a power of the length of the panel over its factorial.
        let mut squares: PerNode<T> = vec![from; gauss::NODES];
        for _ in 0..TURNS_OF_ITERATION {
            let rates = forces.iter().zip(&bends).zip(&squares).map(|((f, b), y)| *f - *b * *y);
            let rates: PerNode<T> = rates.collect();
            let gained = gauss::running(&rates);
            let next: PerNode<T> = gained.iter().map(|g| from + *g).collect();
            let size = next.iter().map(|y| y.size()).fold(0.0, f64::max);
            let change = next.iter().zip(&squares).map(|(a, b)| (*a - *b).size()).fold(0.0, f64::max);
            squares = next;
            if change <= T::SETTLED * size {
                let gains = gained.iter().zip(gauss::nodes()).map(|(g, x)| *g / (width * T::constant(*x)));
                let squares = (from, from + gauss::mean(&rates));
                return Ok(Some(Stretch { ends, squares, gains: gains.collect() }));
            }
        }
        Ok(None)
    }

    /// Second derivative of the leading angle at this square of its rate, and the sum of the magnitudes of its terms.
    fn acceleration(&self, poses: &Poses<T>, square: T) -> Result<(T, f64), Refusal> {
        let balance = self.balance(poses, &self.across_friction(poses)?)?;
        let bend = balance.bend * square;
        let size = (balance.size + bend.size()) / balance.inertia.size();
        Ok(((balance.force - bend) / balance.inertia, size))
    }

    /// The forces of a joint, from the virtual motions that it alone forbids; `None` where no such motion is.
    fn reaction(
        &self,
        poses: &Poses<T>,
        joint: usize,
        acceleration: &dyn Fn(usize, T) -> Vector<T>,
        blows: bool,
    ) -> Option<Forces<T>> {
        self.reactions(poses, joint..joint + 1, acceleration, blows).pop()?
    }

    /// The same of several joints: with one matrix, for the rows of all of them.
    fn reactions(
        &self,
        poses: &Poses<T>,
        joints: Range<usize>,
        acceleration: &dyn Fn(usize, T) -> Vector<T>,
        blows: bool,
    ) -> Vec<Option<Forces<T>>> {
        let columns = 3 * self.scene.bodies.len();
        let rights = self.scene.joints[joints.clone()].iter().map(|j| j.kind.forces().len()).sum();
        if rights == 0 {
            return joints.map(|_| Some(Forces::new())).collect();
        }
        let (mut rows, of_joint) = self.conditions(poses, true, rights);
        for (right, row) in of_joint[joints.clone()].iter().flatten().enumerate() {
            rows.right_of(*row)[columns + right] = T::of(1.0);
        }
        let free = rows.clone();
        self.leading(poses, &mut rows, T::zero());
        self.no_drift(poses, &mut rows);
        let held = || self.conditions(poses, false, 1).0.reduce(&[]).open().is_empty();
        let (mut reduced, mut loose) = (self.settled(|| rows.reduce(&[])), None);
        let mut right = 0..rights;
        let mut force = || {
            let right = right.next()?;
            let motion = self.settled(|| {
                let mut reduced = reduced.with_right(right);
                if !reduced.repeats() && (self.layout.poses::<Jet<T>>(T::zero(), false).is_none() || held()) {
                    // What leads is held, as a crate is that stands on two corners.
                    reduced = loose.get_or_insert_with(|| free.clone().reduce(&[])).with_right(right);
                }
                reduced.repeats().then(|| self.motion(reduced))
            })?;
            let (mut missing, mut size) = (T::zero(), 0.0);
            let mut add = |x: T| {
                missing = missing + x;
                size += x.size();
            };
            for (b, numbers) in self.n.bodies.iter().enumerate() {
                let (centre, gyration) = self.centres[b];
                for along in [centre + gyration, centre - gyration] {
                    let v = self.velocity(poses, &motion, b, along);
                    let half = plant!("energy: inertia in a virtual motion", numbers.mass.scale2(-1));
                    add(half * dot(v, acceleration(b, along)));
                }
            }
            for power in self.powers(poses, &motion, blows) {
                add(-power);
            }
            Some((missing.cleared(size), size))
        };
        let of = |own: &SmallVec<[usize; 2]>| {
            let forces: SmallVec<[Option<(T, f64)>; 2]> = own.iter().map(|_| force()).collect();
            forces.into_iter().collect()
        };
        of_joint[joints].iter().map(of).collect()
    }

    // -- where it ends --------------------------------------------------------------------------------------------------

    /// The first place before `far` at which `value`, which sets off above 0 (or `rising` below it), no longer is there, however
    /// shortly.
    fn first(
        &self,
        far: T,
        rising: bool,
        value: &dyn Fn(T) -> Result<T, Refusal>,
    ) -> Result<Option<T>, Refusal> {
        let gone = |now: T| now.sign() == 0.0 || (now.sign() > 0.0) == rising;
        ball::unwatched(|| {
            let mut sure = true;
            let root = |from, to, sure| {
                let root = root::between_values(from, to, rising, value)?;
                Self::around(root, sure, value).map(Some)
            };
            let mut seen: SmallVec<[(T, T); 3]> = smallvec![(T::zero(), value(T::zero())?)];
            // What sets off from rest beside a balance may turn in the first hair of the way.
            let mut step = if seen[0].1.is_zero() { STEP / 32.0 } else { STEP };
            while let Some((before, _)) = seen.last().copied()
                && before.below(far)
            {
                let next = before + T::of(step);
                step = f64::min(2.0 * step, STEP);
                let next = if next.below(far) { next } else { far };
                let now = value(next)?;
                if gone(now) {
                    return root(before, next, sure);
                }
                sure &= decided(now);
                seen.push((next, now));
                // Between two looks it may have been gone and back.
                if let Some([left, at, _]) = root::dipped(&seen, value)? {
                    return root(left, at, sure);
                }
                if seen.len() == 3 {
                    seen.remove(0);
                }
            }
            Ok(None)
        })
    }

    /// Of numbers that enclose, a root with the width within which the value is shown to change its sign; endless without one, and
    /// where the sign before it is not sure.
    fn around(root: T, sure: bool, value: &dyn Fn(T) -> Result<T, Refusal>) -> Result<T, Refusal> {
        if !T::ENCLOSES {
            return Ok(root);
        }
        let middle = root.value();
        for power in WIDTHS.filter(|_| sure).step_by(3) {
            let width = root.size() * pow2(power);
            let side = |by| {
                let side = value(T::constant(middle + Dd::new(by)))?;
                Ok::<_, Refusal>(if decided(side) { side.sign() } else { 0.0 })
            };
            let before = side(-width)?;
            if before != 0.0 && before * side(width)? < 0.0 {
                return Ok(T::constant(middle).widened(|| width));
            }
        }
        Ok(root.widened(|| f64::INFINITY))
    }

    /// Does what only pushes push up to this way, and is it not what the end waits for? Errors: friction that turns about.
    fn stays_in_touch(&self, far: T, from: (&Poses<T>, T)) -> Result<bool, Refusal> {
        // An enclosure is of a motion that both roads have followed.
        if T::ENCLOSES {
            return Ok(true);
        }
        let turns = || Err(Refusal::Unsupported(Unsupported::FrictionTurns));
        for (j, joint) in self.scene.joints.iter().enumerate() {
            let pushes = joint.kind.is_one_sided();
            if !pushes && joint.kind.rubs().is_none() || self.scene.end == End::Leaves(j) {
                continue;
            }
            let side = if pushes { 1.0 } else { self.rubs[j] * self.slides[j] };
            let force = |way: T| {
                let force = self.normal_there(j, way, from)?;
                Ok(force.map_or_else(|| T::of(1.0), |force| force.signed(side)))
            };
            if self.first(far, false, &force)?.is_some() {
                return if pushes { Ok(false) } else { turns() };
            }
        }
        let mut at = if self.scene.joints.iter().any(|j| j.kind.rubs().is_some()) { T::zero() } else { far };
        while at.below(far) {
            let next = at + T::of(STEP);
            at = if next.below(far) { next } else { far };
            let poses = self.poses(at)?;
            let motion = self.rates(&poses).iter().map(|r| r.map(|x| x.signed(self.sense))).collect();
            if self.sliding(&poses, &motion) != self.slides {
                return turns();
            }
        }
        Ok(true)
    }

    /// Time to a place, where it rests or not: in an angle whose cosine is the place.
    fn time(&self, place: &At<T>, from: (&Poses<T>, T), rest: bool) -> Result<T, Refusal> {
        let way = place.0;
        if way.is_zero() {
            return Ok(T::zero());
        }
        if let Some(pendulum) = &self.pendulum {
            let speed = if rest { T::zero() } else { self.half_square_at(place, from)?.scale2(1).root() };
            return Ok(pendulum.time(way, &self.angle(place), speed));
        }
        // A quadrature settles, it proves nothing.
        let open = T::of(1.0).widened(|| f64::INFINITY);
        if open.radius() > 0.0 {
            return Ok(open);
        }
        let middle = way.scale2(-1);
        let slowness = |angle: T| {
            let (half, other) = trig::turn(angle.scale2(-1));
            let sine = (half * other).scale2(1);
            let at = way * half.square();
            let square = self.half_square(at, from)?;
            // Near an end at rest the work is that of the way back.
            let square = if rest && square.sign() <= 0.0 { (way * other.square()).square() } else { square };
            Ok::<_, Refusal>(middle * sine / square.scale2(1).root())
        };
        let (mut time, mut angle) = (T::zero(), T::zero());
        for met in self.meets.iter().filter(|x| x.below(way)).map(|x| *x / way) {
            let next = trig::angle(met.root(), (T::of(1.0) - met).root()).scale2(1);
            time = time + gauss::long_integral(slowness, angle, next)?;
            angle = next;
        }
        let time = time + gauss::long_integral(slowness, angle, T::constant(Dd::PI))?;
        Ok(plant!("energy: time of joined bodies", time))
    }

    /// The leading angle at a place.
    fn angle(&self, (way, angle): &At<T>) -> Half<T> {
        let start = || self.scene.start_angle(self.n);
        angle.unwrap_or_else(|| start().plus(Half::of_radians(way.signed(self.sense))))
    }

    /// Where it comes to rest within a way.
    fn turning(&self, far: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        match &self.pendulum {
            Some(pendulum) => Ok(pendulum.turning().map(|(way, _)| way).filter(|way| way.at_most(far))),
            None => self.first(far, false, &|way| Ok(self.there(way, from)?.half_square)),
        }
    }

    /// The way to the end within `far`, if it gets there before it comes to rest.
    fn reached(&self, far: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        // What is met beyond the turning point is not met.
        let before_rest = |found: Option<T>| match found {
            Some(way) => {
                let rest = self.turning(way, from)?;
                Ok::<_, Refusal>(rest.is_none_or(|rest| rest.side(way) == 0.0).then_some(way))
            }
            None => Ok(None),
        };
        match self.scene.end {
            End::Angle(..) => before_rest(Some(far)),
            End::TurningPoint(_) => self.turning(far, from),
            End::Speed(_, w) => {
                let level = (self.n.get(w) / self.layout.ratio()).square().scale2(-1);
                if self.pinned && level.side(from.1) == 0.0 {
                    return Ok(Some(T::zero()));
                }
                let over = |way: T| Ok(self.there(way, from)?.half_square - level);
                before_rest(self.first(far, from.1.below(level), &over)?)
            }
            End::Leaves(joint) => before_rest(self.first(far, false, &|way| {
                Ok(self.normal_there(joint, way, from)?.unwrap_or_else(T::zero))
            })?),
            End::Time(_, t) => self.after(self.n.get(t), far, from),
            _ => Ok(None),
        }
    }

    /// The way that takes this time, if it takes it before it comes to rest.
    fn after(&self, t: T, far: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        let rest = self.turning(far, from)?;
        let limit = rest.unwrap_or(far);
        let most = self.time(&(limit, None), from, rest.is_some())?;
        if self.proves() && self.pendulum.is_none() {
            return Ok(None);
        }
        match t.side(most) {
            0.0 => return Ok(Some(limit)),
            side if side > 0.0 => return Ok(None),
            _ => {}
        }
        let speed = |way: T| Ok::<_, Refusal>(self.half_square(way, from)?.scale2(1).root());
        let late = |way: T| Ok::<_, Refusal>(self.time(&(way, None), from, false)? - t);
        let way = ball::unwatched(|| {
            root::between(T::zero(), limit, true, |way| {
                Ok::<_, Refusal>((late(way)?, T::of(1.0) / speed(way)?))
            })
        })?;
        if !T::ENCLOSES {
            return Ok(Some(way));
        }
        // The data take part in one step more, from where the search has ended.
        let way = T::constant(way.value());
        Ok(Some(way - late(way)? * speed(way)?))
    }

    /// Are numbers kept account of? A quadrature proves nothing.
    fn proves(&self) -> bool {
        T::of(1.0).widened(|| f64::INFINITY).radius() > 0.0
    }

    /// The powers at the start for and against the motion, the friction among them: for margins alone.
    fn push_and_hold(&self, rubbed: T) -> Result<(T, T), Refusal> {
        let first = self.poses(T::zero())?;
        let (mut push, mut hold) = (T::zero(), T::zero());
        for power in self.powers(&first, &self.rates(&first), false) {
            let power = power.signed(self.sense);
            if power.sign() > 0.0 { push = push + power } else { hold = hold - power }
        }
        if rubbed.sign() > 0.0 {
            hold = hold + rubbed;
        }
        Ok((push, hold))
    }

    fn settle(&self, spin: T, drive: (T, T), (wanted, road): (Scope, &mut Road<T>)) -> Result<(), Refusal> {
        let scene = self.scene;
        let from = spin.square().scale2(-1);
        let mut far = T::constant(Dd::PI * Dd::new(2.0 * TURNS));
        if let End::Angle(_, angle) = scene.end {
            let start = scene.lead().and_then(|l| scene.planar(l)?.start_deg);
            let apart = self.n.get(angle) - start.map_or_else(T::zero, |s| self.n.get(s));
            far = (apart * T::constant(Dd::PI / Dd::new(180.0))).signed(self.sense);
        }
        let limit = ball::unwatched(|| self.overwinds((far + T::of(STEP), T::of(STEP))));
        let limit = limit.filter(|limit| limit.at_most(far));
        // Short of half a turn of a torsion spring, beside which its moment has two signs.
        far = limit.map_or(far, |limit| limit * T::of(1.0 - 1e-12));
        let begin = self.poses(T::zero())?;
        let backward = far.sign() < 0.0 || !ball::unwatched(|| self.presses(&begin, from))?;
        let from = (&begin, from);
        let found = if backward { None } else { self.reached(far, from)? };
        let winds = match limit {
            Some(_) if matches!(scene.end, End::Angle(..)) => found.is_some(),
            Some(_) => found.is_none() && self.turning(far, from)?.is_none(),
            None => false,
        };
        if winds && !backward && !self.proves() && self.stays_in_touch(far, from)? {
            return Err(Refusal::Unsupported(Unsupported::Overwound));
        }
        // What leaves another surface on the way does not get there.
        let found = match found {
            Some(way) if !self.stays_in_touch(way, from)? => None,
            found => found,
        };
        let drive = ball::unwatched(|| self.push_and_hold(drive.0 - drive.1))?;
        road.course = Some(Course { drive, ..Course::moving(self.sense, found.is_some()) });
        match found {
            Some(way) => self.tell_end(way, from, (wanted, road)),
            None => self.tell_standing(&begin, spin.square(), road),
        }
    }

    /// Everything at the end, after this way.
    fn tell_end(
        &self,
        way: T,
        from: (&Poses<T>, T),
        (wanted, road): (Scope, &mut Road<T>),
    ) -> Result<(), Refusal> {
        let scene = self.scene;
        let turns = matches!(scene.end, End::TurningPoint(_));
        let angle = match (scene.end, &self.pendulum) {
            // The angle itself is printed; the way to it would round it.
            (End::Angle(_, angle), _) if self.pinned => Some(Half::of_degrees(self.n.get(angle))),
            // A hair from the top the way to it would round off the hair.
            (_, Some(pendulum)) => pendulum
                .turning()
                .filter(|(limit, _)| turns || way.side(*limit) == 0.0)
                .map(|(_, place)| place),
            _ => None,
        };
        let place = (way, angle);
        let timed = self.proves() && self.pendulum.is_none() && matches!(scene.end, End::Time(..));
        let open = |x: T| if timed { x.widened(|| f64::INFINITY) } else { x };
        let searched = self.looked.replace(0);
        let half_square = if turns { T::zero() } else { self.half_square_at(&place, from)? };
        let rest = turns || !T::ENCLOSES && half_square.is_zero();
        let mut rate = open(half_square).scale2(1).root();
        let mut time = match scene.end {
            End::Time(_, t) => Some(self.n.get(t)),
            _ if !wanted.quantities.has(Quantity::T) || self.points.is_some() => None,
            _ => Some(match &self.pendulum {
                Some(pendulum) => pendulum.time(way, &self.angle(&place), rate),
                None => self.time(&place, from, rest)?,
            }),
        };
        if let Some(points) = self.points {
            let summed = self.summed(way, rest, from, points)?;
            (rate, time) = (summed.0, Some(summed.1));
        }
        let looked = self.looked.get();
        if let Some(time) = time.filter(|_| wanted.quantities.has(Quantity::T)) {
            self.say(road, Quantity::T, Owner::Scene, time);
        }
        self.say(road, Quantity::Phi, Owner::Body(self.lead), open(way));
        let poses = self.at(&place)?;
        let places = self.between(from.0, &poses, &place);
        for (b, body) in scene.bodies.iter().enumerate() {
            if body.planar.is_some() {
                let [_, risen] = places.shift(b, [self.centres[b].0, T::zero()]);
                let risen = open(plant!("energy: rise in the plane", risen));
                self.say(road, Quantity::Rise, Owner::Body(b), risen);
            }
        }
        if let Some(moment) = self.couple().filter(|_| self.pinned) {
            self.say(road, Quantity::WorkCouple, Owner::Body(self.lead), moment * way.signed(self.sense));
        }
        let rate = rate.signed(self.sense);
        let (second, _) = self.acceleration(&poses, rate.square())?;
        self.tell(&poses, rate, second, road)?;
        // Of a body on a pin what speed and time take is counted, not the search.
        self.looked.set(if self.pinned { looked } else { searched + self.looked.get() });
        Ok(())
    }

    /// Does each joint that can only push do so at the start, with more than this share of all weights?
    fn presses(&self, begin: &Poses<T>, from: T) -> Result<bool, Refusal> {
        const LEAST: f64 = 1e-9;
        let square = from.scale2(1);
        let pushing = |joint: &usize| self.scene.joints[*joint].kind.is_one_sided();
        let mut joints = (0..self.scene.joints.len()).filter(pushing).peekable();
        if joints.peek().is_none() {
            return Ok(true);
        }
        let weights = self.n.bodies.iter().fold(0.0, |sum, b| sum + (b.mass * self.n.gravity).size());
        for joint in joints {
            if self.normal(begin, square, joint)?.is_some_and(|force| force.below(T::of(LEAST * weights))) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The first force of a joint at this square of the rate: its normal force; `None` where the joints leave it open.
    fn normal(&self, poses: &Poses<T>, square: T, joint: usize) -> Result<Option<T>, Refusal> {
        let (rate, _) = self.acceleration(poses, square)?;
        let moves = |b: usize, along: T| self.accelerates(poses, b, along, rate, square);
        Ok(self.reaction(poses, joint, &moves, false).map(|force| force[0].0))
    }

    /// Acceleration of a point at a distance along the axis of a body.
    fn accelerates(&self, poses: &Poses<T>, body: usize, along: T, rate: T, square: T) -> Vector<T> {
        poses[body].point([along, T::zero()]).map(|x| x.first * rate + x.second * square)
    }

    /// An instant: of one freedom with any rate, of several from rest.
    fn instant(&mut self, spin: T, road: &mut Road<T>) -> Result<(), Refusal> {
        let poses = self.placed()?;
        if self.scene.is_struck() {
            let jump = self.sets_off(&poses, true)?;
            let mut after = jump.clone();
            if !spin.is_zero() {
                // How it moves is told by what guides it on the way, as a light rod does.
                for (v, unit) in after.iter_mut().zip(self.rates(&self.poses(T::zero())?)) {
                    *v = [0, 1, 2].map(|i| v[i].balance(unit[i] * spin));
                }
            }
            self.tell_blow(&poses, &jump, road);
            self.tell_motion(&poses, &after, None, road);
            return Ok(());
        }
        if let Some(alpha) = self.scene.driven() {
            return self.driven(spin, self.n.get(alpha), road);
        }
        if !spin.is_zero() || self.pinned {
            let poses = self.poses(T::zero())?;
            let motion = self.rates(&poses).iter().map(|r| r.map(|x| x * spin)).collect();
            self.slides = self.sliding(&poses, &motion);
            outcome::all_slide(self.scene, &self.slides)?;
            self.press(&|account, joint| account.normal(&poses, spin.square(), joint))?;
            let (second, _) = self.acceleration(&poses, spin.square())?;
            return self.tell(&poses, spin, second, road);
        }
        // What starts from rest slides as it would without friction, if friction lets it.
        let mut sum = self.sets_off(&poses, false)?;
        self.slides = self.sliding(&poses, &sum);
        if self.slides.iter().any(|s| *s != 0.0) {
            self.press(&|account, joint| {
                let sum = account.sets_off(&poses, false)?;
                let moves = |b: usize, along: T| account.velocity(&poses, &sum, b, along);
                Ok(account.reaction(&poses, joint, &moves, false).map(|force| force[0].0))
            })?;
            sum = self.sets_off(&poses, false)?;
            if self.sliding(&poses, &sum) != self.slides {
                road.course = Some(Course::at_rest());
                return Ok(());
            }
        }
        let moves = |b: usize, along: T| self.velocity(&poses, &sum, b, along);
        let turning = |b: usize| sum[b][2];
        let still: Motion<T> = smallvec![[T::zero(); 3]; self.scene.bodies.len()];
        self.all(&poses, &still, &moves, &turning, road)
    }

    /// An instant of bodies of which the leading one turns as it is driven: the couple is what the balance lacks.
    fn driven(&mut self, spin: T, alpha: T, road: &mut Road<T>) -> Result<(), Refusal> {
        let poses = self.poses(T::zero())?;
        let sense = self.counts(self.lead);
        let (unit, bend) = poses[self.lead].turn();
        let second = (alpha.signed(sense) - bend * spin.square()) / unit;
        let rate = if spin.is_zero() { second } else { spin };
        let motion = self.rates(&poses).iter().map(|r| r.map(|x| x * rate)).collect();
        self.slides = self.sliding(&poses, &motion);
        outcome::all_slide(self.scene, &self.slides)?;
        self.press(&|account, joint| {
            account.drives(&poses, second, spin.square())?;
            let moves = |b: usize, along: T| account.accelerates(&poses, b, along, second, spin.square());
            Ok(account.reaction(&poses, joint, &moves, false).map(|force| force[0].0))
        })?;
        let moment = self.drives(&poses, second, spin.square())?;
        self.say(road, Quantity::Drive, Owner::Body(self.lead), moment.signed(sense));
        self.tell(&poses, spin, second, road)
    }

    /// The couple on the leading body that the balance lacks where its angle has this second derivative; it acts from now on.
    fn drives(&self, poses: &Poses<T>, second: T, square: T) -> Result<T, Refusal> {
        self.drive.set(None);
        let own = self.across_friction(poses)?;
        let balance = self.balance(poses, &own)?;
        let missing = (balance.inertia * second).balance(balance.bend * square).balance(-balance.force);
        let moment = plant!("energy: couple of a drive", missing / own[self.lead][2]);
        self.drive.set(Some(moment));
        Ok(moment)
    }

    /// Accelerations from rest, or the velocities that blows give, of any number of freedoms: a sum of the motions that the joints
    /// allow, from the balances of the virtual motions in which normal forces and their friction do no work.
    fn sets_off(&self, poses: &Poses<T>, blows: bool) -> Result<Motion<T>, Refusal> {
        let bodies = self.scene.bodies.len();
        let modes = |virtually: bool| -> Vec<Motion<T>> {
            let reduced = self.settled(|| self.conditions(poses, virtually, 1).0.reduce(&[]));
            let mode = |which: usize| {
                (0..bodies).map(|b| [0, 1, 2].map(|i| reduced.in_mode(which, 3 * b + i))).collect()
            };
            reduced.open().into_iter().map(mode).collect()
        };
        let (modes, virtual_modes) = (modes(false), modes(true));
        let mut rows = Equations::new(modes.len());
        for one in &virtual_modes {
            let row = rows.row();
            for (cell, other) in row.iter_mut().zip(&modes) {
                for (b, numbers) in self.n.bodies.iter().enumerate() {
                    let (centre, gyration) = self.centres[b];
                    for along in [centre + gyration, centre - gyration] {
                        let (v, u) =
                            (self.velocity(poses, one, b, along), self.velocity(poses, other, b, along));
                        let half = numbers.mass.scale2(-1);
                        *cell = *cell + plant!("energy: inertia of two motions", half) * dot(v, u);
                    }
                }
            }
            let powers = self.powers(poses, one, blows);
            let size = powers.iter().map(|p| p.size()).sum();
            row[modes.len()] = powers.into_iter().fold(T::zero(), |sum, p| sum + p).cleared(size);
            rows.sized(size);
        }
        let rates = self.settled(|| rows.reduce(&[]).solution()).ok_or(Refusal::Freedoms(modes.len()))?;
        let mut sum: Motion<T> = smallvec![[T::zero(); 3]; bodies];
        for (mode, rate) in modes.iter().zip(&rates) {
            for (s, m) in sum.iter_mut().zip(mode) {
                for (s, m) in s.iter_mut().zip(m) {
                    *s = s.balance(*m * *rate);
                }
            }
        }
        Ok(sum)
    }
}
