//! The motion of joined bodies in the plane from the work of the forces: speed from the balance over the way, accelerations from its
//! rate, the force of a joint from a virtual motion that the joint alone forbids.
//!
//! Velocities are the derivatives of the poses by the leading angle `q`. The kinetic energy of each body is that of two particles
//! of half its mass, as far from its mass centre on either side along its axis as its radius of gyration (equimomental particles):
//! no angular velocity comes in. Where a guide rubs, the balance is drawn up for virtual motions in which normal force and friction
//! together do no work, and solved by collocation. Time is a quadrature in an angle whose cosine is the place: the root
//! singularities at the ends of the way are gone.
//! Source: Routh, *Dynamics of a System of Rigid Bodies*, elementary part, article 33 (equimomental bodies).
use crate::num::dd::pow2;
use crate::num::eliminate::{Equations, Reduced};
use crate::num::gauss::{self, PerNode, Unsettled};
use crate::num::ode::Count;
use crate::num::plant::plant;
use crate::num::{Dd, Jet, Real, ball, root, trig};
use crate::scene::pose::{self, Layout, Pose};
use crate::scene::{
    Acts, End, Joint, JointKind, Label, Num, Numbers, Owner, Place, Push, Quantity, Rest, Scene, Spot, Strut,
    StrutEnd,
};
use crate::solve::outcome::{self, Course, Refusal, Road, Said, Scope, Unsupported};
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
///
/// Errors: joints that do not determine the motion, a quadrature that does not settle.
pub fn road<T: Real>(scene: &Scene, n: &Numbers<T>, asked: Scope) -> Result<(Road<T>, Count), Refusal> {
    let mut account = Account::new(scene, n)?;
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
        if matches!(scene.end, End::AtOnce) {
            self.instant(spin, &mut road)?;
            return Ok(road);
        }
        if scene.end == End::Equilibrium {
            // What is searched for is not enclosed.
            ball::unwatched(|| self.rest(&mut road))?;
            self.open.set(true);
            return Ok(road);
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
            slides: scene.joints.iter().map(|_| 0.0).collect(),
            rubs: scene.joints.iter().map(|_| 0.0).collect(),
            open: Cell::new(false),
            drive: Cell::new(None),
            solved: RefCell::new(Vec::new()),
            seen: RefCell::new(Vec::new()),
            looked: Cell::new(0),
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
        for (b, numbers) in self.n.bodies.iter().enumerate() {
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
        let pushes = self.scene.pushes.iter().zip(&self.layout.pushes).filter(|(p, _)| p.blow == blows);
        let pushed = pushes.map(|(push, direction)| {
            let u = self.push(poses, push, *direction);
            let p = plant!("energy: power of a force on a point", self.n.massive(push.force_n));
            p * dot(u, self.of_spot(poses, motion, push.at))
        });
        if blows {
            return pushed.collect();
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
        powers.extend(pushed);
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

    /// Work of all forces from the start to a place.
    fn work(&self, from: &Poses<T>, to: &Poses<T>, way: T) -> Result<T, Refusal> {
        let (mut work, mut size) = (T::zero(), 0.0);
        let mut add = |w: T| {
            work = work + w;
            size += w.size();
        };
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let place =
                |at: &Poses<T>, i: usize| at[b].origin[i].value + at[b].axis[i].value * self.centres[b].0;
            let back = |i: usize| place(from, i) - place(to, i);
            let fallen = back(1);
            add(plant!("energy: work of the weight in the plane", numbers.mass * self.n.gravity * fallen));
            if let Some(a) = self.n.carried {
                let shared = dot(a, [back(0), fallen]);
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
                let (a, b) = (self.point(from, push.at), self.point(to, push.at));
                add(p * dot(self.push(from, push, *direction), [0, 1].map(|i| b[i].value - a[i].value)));
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
        for (s, (strut, natural)) in self.scene.struts.iter().zip(&self.natural).enumerate() {
            // Where it does not act, it is as if it had its natural length.
            let [a, b] = [from, to].map(|poses| self.length(poses, s).value);
            let [a, b] = [a, b].map(|length| if self.bears(s, length) { length } else { *natural });
            // (x0 - x1)(x0 + x1) of the stretches.
            let stored = (a - b) * ((a - *natural) + (b - *natural));
            let stiffness =
                plant!("energy: work of a spring in the plane", self.n.massive(strut.stiffness_n_m));
            add((stiffness * stored).scale2(-1));
        }
        Ok(work.cleared(size))
    }

    fn is_rubbed(&self) -> bool {
        self.rubs.iter().any(|s| *s != 0.0)
    }

    /// Half the square of the rate after a way, from that at the start; `first` is where everything is there.
    fn half_square(&self, way: T, from: (&Poses<T>, T)) -> Result<T, Refusal> {
        if self.is_rubbed() {
            return self.collocated(way, from.1);
        }
        self.half_square_at(&self.poses(way)?, way, from)
    }
    /// The same where nothing rubs and everything is so after that way.
    fn half_square_at(&self, poses: &Poses<T>, way: T, (first, from): (&Poses<T>, T)) -> Result<T, Refusal> {
        let kinetic = if from.is_zero() { from } else { self.inertia(first) * from };
        Ok(kinetic.balance(self.work(first, poses, way)?) / self.inertia(poses))
    }
    /// A place at which an event is looked for.
    fn there(&self, way: T, from: (&Poses<T>, T)) -> Result<Rc<Seen<T>>, Refusal> {
        if let Some(seen) = self.seen.borrow().iter().find(|seen| seen.way.same(way)) {
            return Ok(Rc::clone(seen));
        }
        let poses = self.poses(way)?;
        let half_square = match self.is_rubbed() {
            true => self.collocated(way, from.1)?,
            false => self.half_square_at(&poses, way, from)?,
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
            while let Some((before, _)) = seen.last().copied()
                && before.below(far)
            {
                let next = before + T::of(STEP);
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

    /// Time over a way: in an angle whose cosine is the place.
    fn time(&self, way: T, from: (&Poses<T>, T), rest: bool) -> Result<T, Refusal> {
        if way.is_zero() {
            return Ok(T::zero());
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

    fn settle(&self, spin: T, drive: (T, T), (wanted, road): (Scope, &mut Road<T>)) -> Result<(), Refusal> {
        let scene = self.scene;
        let from = spin.square().scale2(-1);
        let horizon = T::constant(Dd::PI * Dd::new(2.0 * TURNS));
        let proves = T::of(1.0).widened(|| f64::INFINITY).radius() > 0.0;
        let mut far = horizon;
        let asked = match scene.end {
            End::Angle(_, angle) => {
                let start = scene.lead().and_then(|l| scene.planar(l)?.start_deg);
                let apart = self.n.get(angle) - start.map_or_else(T::zero, |s| self.n.get(s));
                far = (apart * T::constant(Dd::PI / Dd::new(180.0))).signed(self.sense);
                Some(apart.signed(self.sense))
            }
            End::Speed(_, w) => Some((self.n.get(w) / self.layout.ratio()).abs()),
            End::Time(_, t) => Some(self.n.get(t)),
            _ => None,
        };
        let limit = ball::unwatched(|| self.overwinds((far + T::of(STEP), T::of(STEP))));
        let limit = limit.filter(|limit| limit.at_most(far));
        // Short of half a turn of a torsion spring, beside which its moment has two signs.
        far = limit.map_or(far, |limit| limit * T::of(1.0 - 1e-12));
        let begin = self.poses(T::zero())?;
        let backward = far.sign() < 0.0 || !ball::unwatched(|| self.presses(&begin, from))?;
        let from = (&begin, from);
        // Where it comes to rest within a way.
        let half_square = |way: T| Ok::<_, Refusal>(self.there(way, from)?.half_square);
        let turning = |far: T| self.first(far, false, &half_square);
        // What is met beyond the turning point is not met.
        let before_rest = |found: Option<T>| match found {
            Some(way) => Ok::<_, Refusal>(turning(way)?.is_none().then_some(way)),
            None => Ok(None),
        };
        let found = match scene.end {
            _ if backward => None,
            End::Angle(..) => before_rest(Some(far))?,
            End::TurningPoint(_) => turning(far)?,
            End::Speed(_, w) => {
                let level = (self.n.get(w) / self.layout.ratio()).square().scale2(-1);
                before_rest(self.first(far, from.1.below(level), &|way| Ok(half_square(way)? - level))?)?
            }
            End::Leaves(joint) => before_rest(self.first(far, false, &|way| {
                Ok(self.normal_there(joint, way, from)?.unwrap_or_else(T::zero))
            })?)?,
            End::Time(_, t) => {
                let t = self.n.get(t);
                let rest = turning(far)?;
                let limit = rest.unwrap_or(far);
                let most = self.time(limit, from, rest.is_some())?;
                if proves {
                    None
                } else if t.at_most(most) {
                    Some(root::between(T::zero(), limit, true, |way| {
                        let speed = self.half_square(way, from)?.scale2(1).root();
                        Ok::<_, Refusal>((self.time(way, from, false)? - t, T::of(1.0) / speed))
                    })?)
                } else {
                    None
                }
            }
            _ => None,
        };
        let winds = match limit {
            Some(_) if matches!(scene.end, End::Angle(..)) => found.is_some(),
            Some(_) => found.is_none() && turning(far)?.is_none(),
            None => false,
        };
        if winds && !backward && !proves && self.stays_in_touch(far, from)? {
            return Err(Refusal::Unsupported(Unsupported::Overwound));
        }
        // What leaves another surface on the way does not get there.
        let found = match found {
            Some(way) if !self.stays_in_touch(way, from)? => None,
            found => found,
        };
        // Only margins hang on the drive.
        let drive = ball::unwatched(|| {
            let first = self.poses(T::zero())?;
            let (mut push, mut hold) = (T::zero(), T::zero());
            for power in self.powers(&first, &self.rates(&first), false) {
                let power = power.signed(self.sense);
                if power.sign() > 0.0 { push = push + power } else { hold = hold - power }
            }
            let rubbed = drive.0 - drive.1;
            if rubbed.sign() > 0.0 {
                hold = hold + rubbed;
            }
            Ok::<_, Refusal>((push, hold))
        })?;
        let course = Course { sense: self.sense, drive, asked, farthest: far, reached: found.is_some() };
        road.course = Some(course);
        let Some(way) = found else { return Ok(()) };
        let rest = matches!(scene.end, End::TurningPoint(_));
        let open = |x: T| {
            if proves && matches!(scene.end, End::Time(..)) { x.widened(|| f64::INFINITY) } else { x }
        };
        let half_square = if rest { T::zero() } else { half_square(way)? };
        let mut say = |quantity, of, value: T| self.say(road, quantity, of, value);
        if wanted.quantities.has(Quantity::T) {
            let time = match scene.end {
                End::Time(_, t) => self.n.get(t),
                _ => self.time(way, from, rest)?,
            };
            say(Quantity::T, Owner::Scene, time);
        }
        say(Quantity::Phi, Owner::Body(self.lead), open(way));
        let (first, poses) = (self.poses(T::zero())?, self.poses(way)?);
        for (b, body) in scene.bodies.iter().enumerate() {
            if body.planar.is_some() {
                let risen = self.centre(&poses, b)[1].value - self.centre(&first, b)[1].value;
                say(Quantity::Rise, Owner::Body(b), open(plant!("energy: rise in the plane", risen)));
            }
        }
        let rate = open(half_square).scale2(1).root().signed(self.sense);
        let (second, _) = self.acceleration(&poses, rate.square())?;
        self.tell(&poses, rate, second, road)
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

    fn say(&self, road: &mut Road<T>, quantity: Quantity, of: Owner, value: T) {
        road.said.push(Said::of(self.n, Label { quantity, of }, value, value.size()));
    }

    /// Everything at a place where the leading angle has this rate and this second derivative.
    fn tell(&self, poses: &Poses<T>, rate: T, second: T, road: &mut Road<T>) -> Result<(), Refusal> {
        let rates = self.rates(poses);
        let square = rate.square();
        let moves = |b: usize, along: T| self.accelerates(poses, b, along, second, square);
        let turning = |b: usize| {
            let (first, bend) = poses[b].turn();
            (first * second).balance(bend * square)
        };
        let moving = rates.iter().map(|r| r.map(|x| x * rate)).collect();
        self.all(poses, &moving, &moves, &turning, road)
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
        if !spin.is_zero() {
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

    /// How the power of all forces at unit rate of the leading angle changes with that angle: less `V''`.
    fn softens(&self, poses: &Poses<T>) -> T {
        let second = |p: pose::Point<T>| p.map(|x| x.second);
        let first = |p: pose::Point<T>| p.map(|x| x.first);
        let mut sum = T::zero();
        for (b, numbers) in self.n.bodies.iter().enumerate() {
            let bend = second(self.centre(poses, b));
            sum =
                sum - plant!("energy: weight on the bend of a way", numbers.mass * self.n.gravity * bend[1]);
            if let Some(a) = self.n.carried {
                sum = sum - plant!("energy: carrier on the bend of a way", numbers.mass * dot(a, bend));
            }
        }
        for (push, direction) in self.scene.pushes.iter().zip(&self.layout.pushes).filter(|(p, _)| !p.blow) {
            if let Some(place) = push.toward_m {
                sum = sum - self.n.massive(push.force_n) * self.off(poses, push.at, place).second;
                continue;
            }
            let (at, u) = (self.point(poses, push.at), self.push(poses, push, *direction));
            let turn = if push.turns { poses[push.at.body].turn().0 } else { T::zero() };
            let turned = [-u[1] * turn, u[0] * turn];
            sum = sum + self.n.massive(push.force_n) * (dot(u, second(at)) + dot(turned, first(at)));
        }
        for c in &self.scene.couples {
            let bend = poses[c.body].turn().1.signed(self.counts(c.body));
            sum = sum + self.n.massive(c.moment_n_m) * if c.forward { bend } else { -bend };
        }
        for (s, (strut, natural)) in self.scene.struts.iter().zip(&self.natural).enumerate() {
            if !self.bears(s, self.length(poses, s).value) {
                continue;
            }
            // Of (l - l0)^2 / 2 the square of the length bends evenly where the spring is at its anchor, the length does not.
            let [x, y] = self.apart(poses, s);
            let mut bend = (x * x + y * y).second.scale2(-1);
            if !natural.is_zero() {
                bend = bend - *natural * self.length(poses, s).second;
            }
            sum = sum
                - plant!("energy: spring on the bend of a way", self.n.massive(strut.stiffness_n_m)) * bend;
        }
        sum
    }

    /// The stable equilibrium toward which the bodies set off from rest, where the potential energy is least, and small oscillations
    /// about it: `omega^2 = V'' / M`.
    fn rest(&mut self, road: &mut Road<T>) -> Result<(), Refusal> {
        let power = |way: T| {
            let poses = self.poses(way)?;
            let balance = self.balance(&poses, &self.rates(&poses))?;
            Ok::<_, Refusal>(balance.force)
        };
        let sense = power(T::zero())?.sign();
        let full = T::constant(Dd::PI.scale2(1));
        let found = if sense == 0.0 {
            Some(T::zero())
        } else {
            let way = self.first(full, false, &|way| Ok(power(way.signed(sense))?.signed(sense)))?;
            way.map(|way| way.signed(sense))
        };
        let stiffness = match found {
            Some(way) => {
                let poses = self.poses(way)?;
                let stiff = -self.softens(&poses);
                // Where it is indifferent, rounding is left of it; where a spring is just met, it is not even.
                let size = pose::size(self.scene, self.n);
                let nothing = 1e-9 * pose::pulls(self.scene, self.n) * size;
                let met = |s: usize| {
                    let apart = self.length(&poses, s).value - self.natural[s];
                    self.scene.struts[s].acts != Acts::Both && apart.size() < 1e-12 * size
                };
                let met = (0..self.natural.len()).any(met);
                if T::of(nothing).below(stiff) && !met { stiff / self.inertia(&poses) } else { T::zero() }
            }
            None => T::zero(),
        };
        let (Some(way), true) = (found, stiffness.sign() > 0.0) else {
            road.course = Some(Course::nowhere());
            return Ok(());
        };
        self.sense = if sense == 0.0 { 1.0 } else { sense };
        let wound = self.overwinds((way.abs(), T::of(STEP)));
        self.sense = 1.0;
        if wound.is_some() {
            return Err(Refusal::Unsupported(Unsupported::Overwound));
        }
        let (of, frequency) = (Owner::Body(self.lead), stiffness.root());
        self.say(road, Quantity::OmegaSmall, of, frequency);
        self.say(road, Quantity::PeriodSmall, of, T::constant(Dd::PI.scale2(1)) / frequency);
        self.say(road, Quantity::Phi, of, way.abs());
        let (first, poses) = (self.poses(T::zero())?, self.poses(way)?);
        for b in 0..self.scene.bodies.len() {
            let risen = self.centre(&poses, b)[1].value - self.centre(&first, b)[1].value;
            self.say(road, Quantity::Rise, Owner::Body(b), risen);
        }
        let still = |_: usize, _: T| [T::zero(); 2];
        self.tell_forces(&poses, &still, road);
        Ok(())
    }

    /// The impulses of the joints at blows that give this motion.
    fn tell_blow(&self, poses: &Poses<T>, jump: &Motion<T>, road: &mut Road<T>) {
        let moves = |b: usize, along: T| self.velocity(poses, jump, b, along);
        let all = self.reactions(poses, 0..self.scene.joints.len(), &moves, true);
        for (j, (joint, impulses)) in self.scene.joints.iter().zip(all).enumerate() {
            let (of, quantities) = (Owner::Joint(j), joint.kind.impulses());
            match impulses {
                Some(impulses) => {
                    for (quantity, (impulse, _)) in quantities.iter().zip(&impulses) {
                        self.say(road, *quantity, of, *impulse);
                    }
                }
                None => road.open.extend(quantities.iter().map(|q| Label { quantity: *q, of })),
            }
        }
    }

    /// Velocities and energy, with the accelerations of points and the angular ones where they are told.
    fn tell_motion(
        &self,
        poses: &Poses<T>,
        motion: &Motion<T>,
        rates: Option<Accelerations<T>>,
        road: &mut Road<T>,
    ) {
        let mut energy = T::zero();
        for (b, body) in self.scene.bodies.iter().enumerate() {
            let (of, (centre, gyration)) = (Owner::Body(b), self.centres[b]);
            let [vx, vy] = self.velocity(poses, motion, b, centre);
            for along in [centre + gyration, centre - gyration] {
                let v = self.velocity(poses, motion, b, along);
                energy = energy
                    + plant!("energy: kinetic energy of the particles", self.n.bodies[b].mass.scale2(-1))
                        * dot(v, v);
            }
            self.say(road, Quantity::V, of, (vx.square() + vy.square()).root());
            self.say(road, Quantity::VX, of, vx);
            self.say(road, Quantity::VY, of, vy);
            if let Some((moves, _)) = rates {
                let [mut ax, mut ay] = moves(b, centre);
                if let Some(with) = self.n.carried {
                    let [x, y] = with.map(|a| plant!("energy: rate of the carrier in the plane", a));
                    (ax, ay) = (ax.balance(x), ay.balance(y));
                }
                self.say(road, Quantity::AX, of, ax);
                self.say(road, Quantity::AY, of, ay);
            }
            if body.turns {
                self.say(road, Quantity::Omega, of, motion[b][2].abs());
                if let Some((_, turning)) = rates {
                    self.say(road, Quantity::Alpha, of, turning(b).signed(self.counts(b)));
                }
            }
            let points = body.planar.as_ref().map_or(0, |p| p.points.len());
            for spot in (0..points).map(|point| Spot { body: b, point }) {
                let [x, y] = self.of_spot(poses, motion, spot);
                self.say(road, Quantity::V, Owner::Spot(spot), (x.square() + y.square()).root());
            }
        }
        self.say(road, Quantity::KineticEnergy, Owner::Scene, energy.scale2(-1));
    }

    /// Everything of one place: the velocities, accelerations of points, angular accelerations counter-clockwise.
    fn all(
        &self,
        poses: &Poses<T>,
        motion: &Motion<T>,
        moves: &dyn Fn(usize, T) -> Vector<T>,
        turning: &dyn Fn(usize) -> T,
        road: &mut Road<T>,
    ) -> Result<(), Refusal> {
        self.tell_motion(poses, motion, Some((moves, turning)), road);
        self.tell_forces(poses, moves, road);
        Ok(())
    }

    /// The forces of joints and springs, with these accelerations of points.
    fn tell_forces(&self, poses: &Poses<T>, moves: &dyn Fn(usize, T) -> Vector<T>, road: &mut Road<T>) {
        let scene = self.scene;
        let all = self.reactions(poses, 0..scene.joints.len(), moves, false);
        for (j, (joint, forces)) in scene.joints.iter().zip(all).enumerate() {
            let of = Owner::Joint(j);
            let quantities = joint.kind.forces();
            let Some(forces) = forces else {
                road.open.extend(quantities.iter().map(|q| Label { quantity: *q, of }));
                continue;
            };
            for (quantity, (force, _)) in quantities.iter().zip(&forces) {
                self.say(road, *quantity, of, *force);
            }
            if let (JointKind::Guide { direction_deg, mu_k: Some(mu), .. }, [(normal, _)]) =
                (joint.kind, forces.as_slice())
            {
                let up = pose::upward(pose::direction(self.n, direction_deg));
                let most = plant!("energy: friction that is told", self.n.get(mu)) * *normal;
                self.say(road, Quantity::Friction, of, -most.signed(self.rubs[j]).signed(up));
            }
            if let ([(x, _), (y, _), ..], [_, Quantity::PinY, ..]) = (forces.as_slice(), quantities) {
                let pulls = pose::pulls(scene, self.n);
                let [x, y] = [x, y].map(|f| f.cleared(f.size() + pulls));
                let force = (x.square() + y.square()).root();
                self.say(road, Quantity::PinForce, of, force);
                // A pin on which nothing acts: its force has no angle, and nothing else hangs on that.
                if !ball::unwatched(|| force.is_zero()) {
                    self.say(road, Quantity::PinAngle, of, trig::angle(y, x));
                }
            }
        }
        for (s, (strut, natural)) in scene.struts.iter().zip(&self.natural).enumerate() {
            let length = self.length(poses, s).value;
            let stretch = if self.bears(s, length) { length.balance(-*natural) } else { T::zero() };
            let force = self.n.massive(strut.stiffness_n_m) * stretch;
            if strut.twists() {
                self.say(road, Quantity::Moment, Owner::Strut(s), -force);
            } else {
                self.say(road, Quantity::SpringForce, Owner::Strut(s), force);
            }
        }
    }
}
