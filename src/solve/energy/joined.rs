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
mod reach;
mod tell;
mod work;

use crate::num::eliminate::{Equations, Reduced};
use crate::num::gauss::PerNode;
use crate::num::half::Half;
use crate::num::jet::Followed;
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Dd, Jet, Real, ball, trig};
use crate::scene::pose::{self, Layout, Obstacle, Pose, dot};
use crate::scene::{Degree, End, Joint, JointKind, Num, Numbers, Owner, Place, Quantity, Scene, Spot};
use crate::solve::energy::pendulum::Pendulum;
use crate::solve::method::Method;
use crate::solve::outcome::{self, Course, Refusal, Road, Scope};
use smallvec::{SmallVec, smallvec};
use std::cell::{Cell, RefCell};
use std::ops::{Range, RangeInclusive};
use std::rc::Rc;

/// Step in which events are looked for, radians.
const STEP: f64 = 0.0625;
/// Into so many steps at least the way from one spring that is met to the next is cut, and a small swing.
const STRETCHED: f64 = 7.5;
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
        let [from, to] = [self.from, self.to].map(|poses| poses[body].here().point(at));
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
    /// Ways after which springs are met or let go of.
    meets: SmallVec<[T; 4]>,
    /// Sense in which the leading angle changes.
    sense: f64,
    /// The first step in which events are looked for, radians, and the widest one.
    stride: f64,
    widest: f64,
    /// How far it is looked for an end.
    horizon: T,
    /// Is it a body on a pin, of which all is told as its own, and what has it in closed form?
    pinned: bool,
    pendulum: Option<Pendulum<T>>,
    /// For each joint: sense in which its point slides where it rubs, else 0.
    slides: SmallVec<[f64; 4]>,
    /// The same times the side to which its guide pushes, 1 or -1, if it holds on both.
    rubs: SmallVec<[f64; 4]>,
    /// Did equations leave open which of them say something of their own? Nothing is enclosed then.
    open: Cell<bool>,
    /// Does it go on where it was looked for the end no farther?
    goes_on: Cell<bool>,
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
    /// [`Scope::granted`].
    granted: bool,
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
/// A straight guide: the body that it guides, the one that carries it, its direction.
type Guided = (usize, Option<usize>, Num);
/// For each joint: the rows of its conditions.
type OfJoint = SmallVec<[SmallVec<[usize; 2]>; 4]>;

/// The normal force of a joint, as an account has it.
type Presses<'p, A, T> = dyn Fn(&A, usize) -> Result<Option<T>, Refusal> + 'p;
/// Hears of a condition its joint, and of each rate in it the place among all and the share.
type Tell<'t, X> = dyn FnMut(usize, &[(usize, X)]) + 't;
/// Accelerations of points, told by body and distance along its axis, and of its turn.
type Accelerations<'a, T> = (&'a dyn Fn(usize, T) -> Vector<T>, &'a dyn Fn(usize) -> T);

/// A possible or virtual motion: velocity of the origin of each body's axis, and rate of its angle counter-clockwise.
type Motion<T> = SmallVec<[[T; 3]; 2]>;

/// How bodies move, and the accelerations that keep their joints together.
struct Going<T> {
    motion: Motion<T>,
    kept: Motion<T>,
}

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

/// A quarter turn to the right.
fn right<T: Real>([x, y]: Vector<T>) -> Vector<T> {
    [y, -x]
}

/// Moment of a unit vector at a point of a body about the origin of its axis.
fn about<T: Real, X: Followed<T>>([c, s]: [X; 2], [along, aside]: [X; 2], u: [X; 2]) -> X {
    let turn = along * (u[1] * c - u[0] * s);
    let on_axis = aside.here().is_nothing() && aside.derivatives().iter().all(|x| x.is_nothing());
    if on_axis { turn } else { turn - aside * (u[0] * c + u[1] * s) }
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
    let mut account = Account::new(scene, n)?;
    account.pinned = scene.pinned().is_some();
    account.points = points;
    account.granted = asked.granted;
    if points.is_some() && !account.pinned {
        return Err(Refusal::NoMethod { method: Method::Gauss });
    }
    let mut road = account.road(asked)?;
    while account.goes_on.replace(false) && account.layout.looks_farther() {
        // What is known of the way did not look at the springs that are met farther on.
        account.solved.borrow_mut().clear();
        account.seen.borrow_mut().clear();
        account.horizon = account.layout.horizon();
        road = account.road(asked)?;
    }
    if account.open.get() {
        road.said.iter_mut().for_each(|said| said.value = said.value.widened(|| f64::INFINITY));
    }
    Ok((road, Count { evaluations: account.looked.get(), ..Count::default() }))
}

/// Force, inertia and bend of `inertia q'' + bend q'^2 = force`, SI, where the leading angle has changed by this, rad, and nothing rubs;
/// `None` where the joints do not let it.
pub fn balance_after(scene: &Scene, n: &Numbers<f64>, way: f64) -> Option<[f64; 3]> {
    let account = Account::new(scene, n).ok()?;
    let poses = account.poses(way).ok()?;
    let Balance { force, inertia, bend, .. } = account.balance(&poses, &account.rates(&poses)).ok()?;
    Some([force, inertia, bend].map(|x| n.publish(Quantity::Work, x)))
}

/// What the blows and impacts at the start add to the rate of the leading angle, rad/s.
#[cfg(feature = "program")]
pub fn rate_from_blows(scene: &Scene, n: &Numbers<f64>) -> Option<f64> {
    let account = Account::new(scene, n).ok()?;
    let poses = account.poses(0.0).ok()?;
    Some(n.publish(Quantity::Omega, account.gained(&poses)))
}

impl<T: Real> Account<'_, T> {
    /// What the blows at the start add to the rate of the leading angle: the momentum that belongs to it gains what they do at its
    /// unit rate.
    fn gained(&self, first: &Poses<T>) -> T {
        if !self.scene.is_struck() {
            return T::zero();
        }
        let unit = self.rates(first);
        let gained = self.powers(first, &unit, true).into_iter().fold(T::zero(), |sum, p| sum + p);
        // What strikes straight at a joint moves nothing.
        let blows = pose::blows(self.scene, self.n);
        let fastest = unit.iter().flatten().map(|x| x.size()).fold(0.0, f64::max);
        gained.cleared(blows * fastest) / self.inertia(first)
    }
    fn road(&mut self, asked: Scope) -> Result<Road<T>, Refusal> {
        let scene = self.scene;
        let several = scene.tells_speeds();
        let mut spin =
            if several { T::zero() } else { self.layout.start_rate().ok_or(Refusal::Freedoms(2))? };
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
            let gained = self.gained(&first);
            spin = spin.balance(gained);
            let jump = self.rates(&first).iter().map(|r| r.map(|x| x * gained)).collect();
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
        // Where springs are stiff the whole swing may be shorter than a step.
        self.stride = ball::unwatched(|| {
            let stiff = -self.softens(&first) / self.inertia(&first);
            let swing = (sets_off + (sets_off.square() + stiff * spin.square()).root()) / stiff;
            let step = swing.f64() / STRETCHED;
            T::leading(|| if stiff.sign() > 0.0 { step.clamp(STEP * 1e-12, STEP) } else { STEP })
        });
        if scene.spins_in_place() {
            // Nothing changes until its energy has become heat: no step is too wide.
            if sets_off.sign() < 0.0 {
                self.horizon = -(spin.square() / sets_off);
            }
            self.widest = f64::max(STEP, self.far().abs().f64() / 8.0);
            self.stride = self.widest;
        }
        let drive = (free.force.signed(self.sense), rubbed.force.signed(self.sense));
        self.meets = ball::unwatched(|| self.springs_met(false));
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
            let centre = body.planar.as_ref().map_or_else(Place::default, |p| p.centre);
            let turns = body.turns && !numbers.inertia.is_zero();
            let gyration = if turns { (numbers.inertia / numbers.mass).root() } else { T::zero() };
            (pose::along(n, centre), gyration)
        });
        let mut layout = Layout::new(scene, n).ok_or(Refusal::Freedoms(2))?;
        layout.measure_springs().ok_or(Refusal::Freedoms(2))?;
        Ok(Self {
            scene,
            n,
            lead,
            horizon: layout.horizon(),
            layout,
            centres: centres.collect(),
            meets: SmallVec::new(),
            sense: 1.0,
            stride: STEP,
            widest: STEP,
            pinned: false,
            pendulum: None,
            slides: scene.joints.iter().map(|_| 0.0).collect(),
            rubs: scene.joints.iter().map(|_| 0.0).collect(),
            open: Cell::new(false),
            goes_on: Cell::new(false),
            drive: Cell::new(None),
            solved: RefCell::new(Vec::new()),
            seen: RefCell::new(Vec::new()),
            looked: Cell::new(0),
            points: None,
            granted: false,
        })
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
    /// The ways of [`Layout::meets`].
    fn springs_met(&self, all: bool) -> SmallVec<[T; 4]> {
        let met = self.layout.meets(all, self.sense, (self.layout.horizon(), T::of(STEP)));
        met.into_iter().map(|(_, way)| way).collect()
    }
    fn point(&self, poses: &Poses<T>, spot: Spot) -> pose::Point<T> {
        self.layout.spot(spot, poses)
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
    /// [`Layout::overruns`].
    fn overruns(&self, far: (T, T)) -> Option<(T, Obstacle)> {
        ball::unwatched(|| self.layout.overruns(self.sense, far))
    }
    /// The motion of unit rate of the leading angle.
    fn rates(&self, poses: &Poses<T>) -> Motion<T> {
        if self.pinned {
            return smallvec![[T::zero(), T::zero(), T::of(self.scene.sense(self.lead))]];
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
        let sense = |(j, joint): (usize, &Joint)| {
            let Some((at, _)) = joint.kind.rubs() else { return 0.0 };
            let (place, line) = (self.point(poses, at).map(|x| x.value), self.line(poses, j));
            let Some(touch) = self.layout.touch(j, place, line) else { return 0.0 };
            // Where they touch, each as it moves there.
            let foot = [0, 1].map(|i| place[i] - touch.rim * touch.normal[i]);
            let moves = |body: usize| {
                let (origin, [x, y, turn]) = (poses[body].origin.map(|x| x.value), motion[body]);
                [x.balance(-(turn * (foot[1] - origin[1]))), y.balance(turn * (foot[0] - origin[0]))]
            };
            let (u, v) = (right(touch.normal), moves(at.body));
            let from = joint.kind.bearer().map_or([T::zero(); 2], |on| moves(on.body));
            (v[0].balance(-from[0]) * u[0]).balance(v[1].balance(-from[1]) * u[1]).sign()
        };
        self.scene.joints.iter().enumerate().map(sense).collect()
    }
    /// The direction of the line of a joint.
    fn line(&self, poses: &Poses<T>, joint: usize) -> Vector<T> {
        self.layout.line(joint, poses).map(|x| x.value)
    }

    /// Notes to which side guides push that hold on both and rub, by the normal forces that result.
    fn press(&mut self, normal: &Presses<Self, T>) -> Result<(), Refusal> {
        self.rubs = outcome::sides(self.scene, &self.slides.clone(), |rubs, joint| {
            self.rubs = rubs.into();
            normal(self, joint)
        })?;
        Ok(())
    }

    /// What comparisons decide; where they leave it open and the motion is taken for granted, what that is then.
    fn unless_open<R>(&self, decided: impl Fn() -> R, granted: impl Fn() -> R) -> R {
        if !(T::ENCLOSES && self.granted) {
            return decided();
        }
        let (found, doubt) = ball::watch(&decided);
        if doubt { granted() } else { found }
    }

    /// Solves equations: that rounding may leave open which of them repeat others is noted, and is no doubt which way it goes.
    fn settled<R>(&self, solve: impl FnOnce() -> R) -> R {
        let (solved, doubt) = ball::watch(solve);
        self.open.set(self.open.get() || doubt);
        solved
    }

    /// What the joints forbid, as the bodies lie: tells of each condition its joint, and which rates of which bodies (three each) make with
    /// which shares the velocity that it keeps at 0; where a guide rubs that of its normal force with its friction.
    fn forbidden<X: Followed<T>>(&self, poses: &pose::Poses<X>, virtually: bool, tell: &mut Tell<X>) {
        let [none, one] = [T::zero(), T::of(1.0)].map(X::still);
        let both = [[one, none], [none, one]];
        let tight = |at: Spot, place_m: [Num; 2]| self.layout.toward(poses, at, place_m).0;
        for (j, (joint, rubs)) in self.scene.joints.iter().zip(&self.rubs).enumerate() {
            let mut add = |ends: &[(Spot, [X; 2], X)]| {
                let mut parts: SmallVec<[(usize, X); 12]> = SmallVec::new();
                let mut end = |body: usize, r: [X; 2], u: [X; 2], rim: X| {
                    // Velocities of the point by those of the origin and the turn.
                    parts.extend([(3 * body, u[0]), (3 * body + 1, u[1])]);
                    if self.scene.bodies[body].turns {
                        parts.push((3 * body + 2, about(poses[body].axis, r, u) + rim));
                    }
                };
                for (spot, u, rim) in ends {
                    end(spot.body, pose::of_spot(self.scene, self.n, *spot).map(X::still), *u, *rim);
                    if let Some(on) = joint.kind.bearer() {
                        // What carries the line, or turns under it, moves at the same place.
                        let back = plant!("energy: velocity of what carries a line", T::of(-1.0));
                        let place = poses[on.body].within(self.layout.spot(*spot, poses));
                        end(on.body, place, u.map(|x| x.by(back)), -*rim);
                    }
                }
                tell(j, &parts);
            };
            match joint.kind {
                JointKind::Pin { at, .. } => both.iter().for_each(|u| add(&[(at, *u, none)])),
                JointKind::Hinge { one: first, other, turned_deg } => {
                    both.iter().for_each(|u| add(&[(first, *u, none), (other, u.map(|x| -x), none)]));
                    if turned_deg.is_some() {
                        let turn = X::still(plant!("energy: turn of a weld", T::of(-1.0)));
                        add(&[(first, [none; 2], one), (other, [none; 2], turn)]);
                    }
                }
                JointKind::Guide { at, .. } | JointKind::Contact { at, .. } => {
                    let line = self.layout.line(j, poses);
                    let Some(touch) = self.layout.touch(j, self.layout.spot(at, poses), line) else {
                        continue;
                    };
                    let [rolls, teeth] = joint.kind.rolls();
                    if !teeth {
                        let rub = match joint.kind.mu_k() {
                            Some(mu) if virtually && *rubs != 0.0 => {
                                plant!("energy: friction in a guide", self.n.get(mu)).signed(*rubs)
                            }
                            _ => T::zero(),
                        };
                        let [x, y] = touch.normal;
                        let rim = plant!("energy: radius at which a wheel rubs", touch.rim);
                        add(&[(at, [x - y.by(rub), y + x.by(rub)], X::still(-(rub * rim)))]);
                    }
                    if rolls {
                        // The rim does not slip.
                        let rim = plant!("energy: radius of a rolling wheel", touch.radius);
                        add(&[(at, touch.along, X::still(rim))]);
                    }
                }
                JointKind::Cord { at, place_m, beyond, .. } => {
                    // What comes off the one end of a cord goes to the other.
                    let other = plant!("energy: other end of a cord", T::of(1.0));
                    let far = beyond.map(|(to, place)| (to, tight(to, place).map(|x| x.by(other)), none));
                    let ends: SmallVec<[_; 2]> =
                        std::iter::once((at, tight(at, place_m), none)).chain(far).collect();
                    add(&ends);
                }
            }
        }
    }

    /// The same as equations for the rates, with the rows of each joint.
    fn conditions(&self, poses: &Poses<T>, virtually: bool, rights: usize) -> (Equations<T>, OfJoint) {
        let columns = 3 * self.scene.bodies.len();
        let mut rows = Equations::with_rights(columns, rights);
        let mut of_joint: OfJoint = self.scene.joints.iter().map(|_| SmallVec::new()).collect();
        let mut count = 0;
        let here: pose::Poses<T> = poses.iter().map(Pose::here).collect();
        self.forbidden(&here, virtually, &mut |joint, parts| {
            let row = rows.row();
            for (at, x) in parts {
                let turns = at % 3 == 2;
                row[*at] = row[*at]
                    + if turns { plant!("energy: turn about the origin of the axis", *x) } else { *x };
            }
            of_joint[joint].push(count);
            count += 1;
        });
        for (b, body) in self.scene.bodies.iter().enumerate() {
            if !body.turns {
                rows.row()[3 * b + 2] = T::of(1.0);
            }
        }
        if T::ENCLOSES {
            self.parallel_guides(&mut rows, &of_joint);
        }
        (rows, of_joint)
    }

    /// Tells which guides of one body on one other or on the ground are parallel.
    fn parallel_guides(&self, rows: &mut Equations<T>, of_joint: &OfJoint) {
        let mut guides: SmallVec<[(Guided, Vector<T>, usize); 4]> = SmallVec::new();
        for (joint, own) in self.scene.joints.iter().zip(of_joint) {
            let (JointKind::Guide { at, line, .. }, [row]) = (joint.kind, &own[..]) else { continue };
            let (guided, on) = ((at.body, line.on.map(|on| on.body), line.direction_deg), line.on);
            let u = [0, 1].map(|i| rows.right_of(*row)[3 * at.body + i]);
            let alike = |(other, v, _): &&(Guided, Vector<T>, usize)| {
                *other == guided && u[0].same(v[0]) && u[1].same(v[1])
            };
            match guides.iter().find(alike) {
                Some((.., first)) => {
                    let [own, its] = [at.body, on.map_or(at.body, |on| on.body)].map(|b| 3 * b);
                    rows.alike(*first, *row, [own, own + 1, its, its + 1]);
                }
                None => guides.push((guided, u, *row)),
            }
        }
    }

    /// Adds to a row what it makes of the velocity along a vector of the point of a body that lies so.
    fn speed_along(&self, poses: &Poses<T>, row: &mut [T], (body, at): (usize, Vector<T>), u: Vector<T>) {
        let turn = about(poses[body].axis.map(|x| x.value), at, u);
        row[3 * body..].iter_mut().zip([u[0], u[1], turn]).for_each(|(cell, x)| *cell = *cell + x);
    }

    /// Adds that the mass centre of the leading body keeps from drifting, where nothing but that holds it.
    fn no_drift(&self, poses: &Poses<T>, rows: &mut Equations<T>) {
        if let Some(direction) = self.scene.drifts() {
            let centre = [self.centres[self.lead].0, T::zero()];
            self.speed_along(poses, rows.row(), (self.lead, centre), pose::direction(self.n, direction));
        }
    }

    /// Adds what the leading angle moves, at this rate: the turn of the body, its centre about the axis of a cylinder, or its way
    /// along guides.
    fn leading(&self, poses: &Poses<T>, rows: &mut Equations<T>, rate: T) {
        let row = rows.row();
        row[3 * self.scene.bodies.len()] = rate;
        let on_arc = self.layout.arc().and_then(|arc| {
            let spot = self.scene.joints[arc.joint].kind.spots().next()?;
            let place = self.point(poses, spot).map(|x| x.value);
            Some((spot, [arc.axis[1] - place[1], place[0] - arc.axis[0]]))
        });
        if let Some((spot, along)) = on_arc {
            self.speed_along(poses, row, (self.lead, pose::of_spot(self.scene, self.n, spot)), along);
        } else if let Some(unit) = self.layout.glide() {
            self.speed_along(poses, row, (self.lead, [self.centres[self.lead].0, T::zero()]), unit);
        } else {
            row[3 * self.lead + 2] = T::of(1.0);
        }
    }
    /// The rate of what [`Self::leading`] tells in the motion of unit rate of the leading angle.
    fn unit(&self, poses: &Poses<T>) -> T {
        match self.layout.arc() {
            Some(arc) => arc.apart.square().signed(self.scene.sense(self.lead)),
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

    /// How far it goes to its end, or is looked for it.
    fn far(&self) -> T {
        self.layout
            .to_end_deg()
            .map_or(self.horizon, |apart| (apart * T::constant(Dd::PI / Dd::new(180.0))).signed(self.sense))
    }

    fn settle(&self, spin: T, drive: (T, T), (wanted, road): (Scope, &mut Road<T>)) -> Result<(), Refusal> {
        let scene = self.scene;
        let from = spin.square().scale2(-1);
        let mut far = self.far();
        let limit = ball::unwatched(|| self.overruns((far + T::of(STEP), T::of(STEP))));
        let limit = limit.filter(|(limit, _)| limit.at_most(far));
        // Short of half a turn of a torsion spring, beside which its moment has two signs, and of a pulley.
        far = limit.map_or(far, |(limit, _)| limit * T::of(1.0 - 1e-12));
        let begin = self.poses(T::zero())?;
        let backward = far.sign() < 0.0 || !ball::unwatched(|| self.presses(&begin, from))?;
        let from = (&begin, from);
        let there = || matches!(scene.end, End::Angle(..)).then_some(far);
        let reached = || self.unless_open(|| self.reached(far, from), || Ok(there()));
        let found = if backward { None } else { reached()? };
        let stays = !backward && found.is_none() && limit.is_none() && !matches!(scene.end, End::Angle(..));
        let goes_on = stays && self.turning(far, from)?.is_none() && self.stays_in_touch(far, from)?;
        self.goes_on.set(goes_on);
        let overruns = match limit {
            Some(_) if matches!(scene.end, End::Angle(..)) => found.is_some(),
            Some(_) => found.is_none() && self.turning(far, from)?.is_none(),
            None => false,
        };
        if let Some((_, obstacle)) = limit
            && overruns
            && !backward
            && !self.proves()
            && self.stays_in_touch(far, from)?
        {
            return Err(Refusal::Beyond(obstacle));
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
        let half_square = if turns { T::zero() } else { self.half_square_at(&place, None, from)? };
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
        self.say(road, Quantity::Phi, Owner::Body(self.lead), open(self.layout.turned(way)));
        if let Some(lead) = scene.ends_at_an_angle() {
            let start = scene.planar(lead).and_then(|p| p.start_deg).map_or_else(T::zero, |x| self.n.get(x));
            let start = start * trig::radians_per_degree();
            let reached = plant!("energy: angle at the end", start.balance(way.signed(self.sense)));
            self.say(road, Quantity::Angle, Owner::Body(lead), open(reached));
        }
        let poses = self.at(&place)?;
        let places = self.between(from.0, &poses, &place);
        for (b, body) in scene.bodies.iter().enumerate() {
            if body.planar.is_some() {
                let [_, risen] = places.shift(b, [self.centres[b].0, T::zero()]);
                let risen = open(plant!("energy: rise in the plane", risen));
                self.say(road, Quantity::Rise, Owner::Body(b), risen);
            }
        }
        if let Some(moment) = scene.couple_on(self.n, self.lead).filter(|_| self.pinned) {
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
            if self.normal(begin, square, joint)?.is_some_and(|force| !T::of(LEAST * weights).below(force)) {
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
        let (scene, poses) = (self.scene, self.placed()?);
        let told = if scene.tells_speeds() { Some(self.told(&poses)?) } else { None };
        let told = told.filter(|motion| motion.iter().flatten().any(|x| !x.is_zero()));
        if scene.is_struck() {
            let mut jump = self.sets_off(&poses, None, true)?;
            if let Some((_, e)) = scene.restitution {
                let e = plant!("energy: restitution", self.n.get(e));
                for (v, before) in jump.iter_mut().flatten().zip(self.before(&poses).iter().flatten()) {
                    *v = v.balance(e * v.apart(*before));
                }
            }
            let mut after = jump.clone();
            if let Some(told) = told {
                for (v, told) in after.iter_mut().flatten().zip(told.iter().flatten()) {
                    *v = v.balance(*told);
                }
            } else if !spin.is_zero() {
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
        if let Some(motion) = told {
            return self.in_motion(&poses, motion, road);
        }
        // What starts from rest slides as it would without friction, if friction lets it.
        let mut sum = self.sets_off(&poses, None, false)?;
        self.slides = self.sliding(&poses, &sum);
        while self.slides.iter().any(|s| *s != 0.0) {
            self.press(&|account, joint| {
                let sum = account.sets_off(&poses, None, false)?;
                let moves = |b: usize, along: T| account.velocity(&poses, &sum, b, along);
                Ok(account.reaction(&poses, joint, &moves, false).map(|force| force[0].0))
            })?;
            sum = self.sets_off(&poses, None, false)?;
            let now = self.unless_open(|| self.sliding(&poses, &sum), || self.slides.clone());
            if now == self.slides {
                break;
            }
            let Some(more) = outcome::set_off(&self.slides, &now) else {
                outcome::holds_still(self.scene, &self.slides, &now)?;
                road.course = Some(Course::at_rest());
                return Ok(());
            };
            self.slides = more;
        }
        let moves = |b: usize, along: T| self.velocity(&poses, &sum, b, along);
        let turning = |b: usize| sum[b][2];
        let still: Motion<T> = smallvec![[T::zero(); 3]; self.scene.bodies.len()];
        self.all(&poses, &still, &moves, &turning, road)
    }

    /// An instant of bodies of which the leading one turns as it is driven: the couple is what the balance lacks.
    fn driven(&mut self, spin: T, alpha: T, road: &mut Road<T>) -> Result<(), Refusal> {
        let poses = self.poses(T::zero())?;
        let sense = self.scene.sense(self.lead);
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

    /// An instant of several freedoms that move so.
    fn in_motion(&mut self, poses: &Poses<T>, motion: Motion<T>, road: &mut Road<T>) -> Result<(), Refusal> {
        self.slides = self.sliding(poses, &motion);
        outcome::all_slide(self.scene, &self.slides)?;
        let kept = self.kept(poses, &motion);
        let going = Going { motion, kept };
        self.press(&|account, joint| {
            let sum = account.sets_off(poses, Some(&going), false)?;
            let moves = |b: usize, along: T| account.speeds_up(poses, &going, &sum, b, along);
            Ok(account.reaction(poses, joint, &moves, false).map(|force| force[0].0))
        })?;
        let sum = self.sets_off(poses, Some(&going), false)?;
        let moves = |b: usize, along: T| self.speeds_up(poses, &going, &sum, b, along);
        self.all(poses, &going.motion, &moves, &|b| sum[b][2], road)
    }
    /// Acceleration of a point at a distance along the axis of a body that moves so, where its origin and its turn have these.
    fn speeds_up(
        &self,
        poses: &Poses<T>,
        going: &Going<T>,
        sum: &Motion<T>,
        body: usize,
        along: T,
    ) -> Vector<T> {
        let (here, square) = (self.velocity(poses, sum, body, along), going.motion[body][2].square());
        [0, 1].map(|i| here[i] - square * along * poses[body].axis[i].value)
    }

    /// How everything moves by the speeds that are told. Errors: they leave that open.
    fn told(&self, poses: &Poses<T>) -> Result<Motion<T>, Refusal> {
        let (mut rows, _) = self.conditions(poses, false, 1);
        let columns = 3 * self.scene.bodies.len();
        for (of, number) in self.scene.start_speeds() {
            let row = rows.row();
            row[columns] = self.n.get(number);
            if of.degree == Degree::Turn {
                row[3 * of.body + 2] = T::of(self.scene.sense(of.body));
                continue;
            }
            // The way of its point along the line, seen from what carries that.
            let (joint, at) = self.scene.guide_of(of.body).ok_or(Refusal::Open(of))?;
            let here: pose::Poses<T> = poses.iter().map(Pose::here).collect();
            let (u, place) = (self.layout.told_along(joint, &here), self.point(poses, at).map(|x| x.value));
            let on = self.scene.joints[joint].kind.carrier().map(|on| (on.body, u.map(|x| -x)));
            for (body, u) in std::iter::once((at.body, u)).chain(on) {
                self.speed_along(poses, row, (body, here[body].within(place)), u);
            }
        }
        let reduced = self.settled(|| rows.reduce(&[]));
        if reduced.open().is_empty() { Ok(self.motion(&reduced)) } else { Err(Refusal::Freedoms(2)) }
    }

    /// Accelerations that keep the joints together where the bodies move so: against those with which they would come apart if each body
    /// went on straight and turned evenly.
    fn kept(&self, poses: &Poses<T>, motion: &Motion<T>) -> Motion<T> {
        let onward = |(pose, [x, y, turn]): (&Pose<Jet<T>>, &[T; 3])| {
            let ([c, s], zero) = (pose.axis.map(|a| a.value), T::zero());
            let going = |value: T, first: T, second: T| Jet { value, first, second };
            let [ox, oy] = pose.origin.map(|o| o.value);
            Pose {
                origin: [going(ox, *x, zero), going(oy, *y, zero)],
                axis: [
                    going(c, -(s * *turn), -(c * turn.square())),
                    going(s, c * *turn, -(s * turn.square())),
                ],
            }
        };
        let onward: Poses<T> = poses.iter().zip(motion).map(onward).collect();
        let (mut rows, _) = self.conditions(poses, false, 1);
        let (columns, mut row) = (3 * self.scene.bodies.len(), 0);
        self.forbidden(&onward, false, &mut |_, parts| {
            let apart = parts.iter().fold(T::zero(), |sum, (at, x)| sum + x.first * motion[at / 3][at % 3]);
            rows.right_of(row)[columns] = -plant!("energy: what keeps joints together", apart);
            row += 1;
        });
        self.motion(&self.settled(|| rows.reduce(&[])))
    }

    /// Accelerations from rest, or beside those that keep the joints together, or the velocities that blows give, of any number of
    /// freedoms: a sum of the motions that the joints allow, from the balances of the virtual motions in which normal forces and their
    /// friction do no work.
    fn sets_off(
        &self,
        poses: &Poses<T>,
        going: Option<&Going<T>>,
        blows: bool,
    ) -> Result<Motion<T>, Refusal> {
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
            let mut powers = self.powers(poses, one, blows);
            if let Some(going) = going {
                for (b, numbers) in self.n.bodies.iter().enumerate() {
                    let (centre, gyration) = self.centres[b];
                    powers.extend([centre + gyration, centre - gyration].map(|along| {
                        let kept = self.speeds_up(poses, going, &going.kept, b, along);
                        -(numbers.mass.scale2(-1) * dot(self.velocity(poses, one, b, along), kept))
                    }));
                }
            }
            let size = powers.iter().map(|p| p.size()).sum();
            row[modes.len()] = powers.into_iter().fold(T::zero(), |sum, p| sum + p).cleared(size);
            rows.sized(size);
        }
        let rates = self.settled(|| rows.reduce(&[]).solution()).ok_or(Refusal::Freedoms(modes.len()))?;
        let mut sum = going.map_or_else(|| smallvec![[T::zero(); 3]; bodies], |going| going.kept.clone());
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
