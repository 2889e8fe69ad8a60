//! A motion in phases: under constant forces every coordinate accelerates evenly until a contact that rubs comes to rest. From then on
//! it holds, if static friction can hold it; a body that slides and cannot be held goes on the other way.
//!
//! Friction is a force of known size against the slip, with its sense frozen until the event:
//!
//! ```text
//! slip        s = v - c omega                    (velocity of the contact; of a block s = v)
//! while s /= 0:  F = -sgn(s) mu_k N
//! event       s + (a - c alpha) t = 0
//! from there  a = c alpha,  F a reaction, |F| <= mu_s N
//! ```
//! Source: Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, section 16.2 (sliding turning into rolling).
use crate::num::Real;
use crate::num::ode::{Count, Formula, Run};
use crate::num::plant::plant;
use crate::scene::{Coordinate, Degree, End, Numbers, Scene, Tie};
use crate::solve::eom::equations::{self, Needs, Response, Setting, respond};
use crate::solve::eom::instant::{self, Each};
use crate::solve::eom::travel::{Leg, Travel};
use crate::solve::eom::{Gone, Rolled, measure, under};
use crate::solve::method::Rung;
use crate::solve::outcome::{Refusal, Unsupported};
use smallvec::{SmallVec, smallvec};

/// What hangs linearly on the coordinates, from the value of each.
pub type Linear<'f, T> = &'f dyn Fn(&dyn Fn(Coordinate) -> T) -> T;

/// A stretch of the motion with constant accelerations.
#[derive(Debug, Clone)]
pub struct Phase<T> {
    /// Forces and accelerations.
    pub response: Response<T>,
    /// For each tie: is it a contact that could rub and holds?
    pub holds: SmallVec<[bool; 4]>,
    /// The friction that those need which hold.
    pub needs: Needs<T>,
    /// The contact that comes to rest at its end.
    closes: Option<usize>,
    speeds: Each<T>,
    rates: Each<T>,
    /// When it begins, and how long it lasts.
    starts: T,
    lasts: T,
    /// The ways of the coordinates, where they are from steps.
    ways: Option<Each<T>>,
}

/// Whether one contact is held hangs on what another does.
const IN_TURN: Refusal = Refusal::Unsupported(Unsupported::SlidesInTurn);

/// Forces and accelerations, and what friction the contacts need.
type Forces<T> = (Response<T>, Needs<T>);

/// A motion in phases, up to its end if it gets there.
pub struct Phases<'a, T: Real> {
    scene: &'a Scene,
    /// Of each tie the radius on which it slips, if it is such a contact.
    rims: Each<Option<T>>,
    coordinates: SmallVec<[Coordinate; 6]>,
    /// Its phases: those up to the end, or all of them.
    pub legs: SmallVec<[Phase<T>; 2]>,
    /// Is its end reached?
    pub ended: bool,
    /// How often what slides was let go where it came to rest.
    let_go: usize,
    /// For each contact that is said to slip: as it holds first, or would hold at the start if it never comes to rest. None of one that
    /// cannot be followed from the end to there.
    pub rolled: Rolled<T>,
    /// For each tie: when its contact comes to rest first; 0 where it is at rest from the start.
    pub until: SmallVec<[Option<T>; 4]>,
    /// When a contact that is said to slip comes to rest and cannot be held.
    pub through: Option<T>,
    /// Sense in which the ending coordinate sets off.
    pub sense: f64,
    /// Its way in that sense up to the phase that is looked at, where it turns or stays, and how fast it gets.
    gone: T,
    pub turning: Option<T>,
    fastest: T,
    /// The velocities at the end.
    ends: Each<T>,
    /// What holds from the end on, where a contact comes to rest there.
    pub after: Option<(Setting, Response<T>)>,
}

/// Path between two velocities of one phase, there and back: with `a = (|v0| + |v1|) / t` where it turns back, each way is `v^2 / 2a`.
fn path<T: Real>(from: T, to: T, time: T) -> T {
    let speeds = from.abs() + to.abs();
    if from.sign() * to.sign() < 0.0 {
        (from.square() + to.square()).over(speeds).scale2(-1) * time
    } else {
        (speeds * time).scale2(-1)
    }
}

impl<'a, T: Real> Phases<'a, T> {
    /// Follows the motion. `pulls` is what springs pull, at an instant.
    ///
    /// Errors: those of the equations and of the start; what holds does so in a way that is left open.
    pub fn follow(scene: &'a Scene, n: &Numbers<T>, pulls: &[T]) -> Result<Self, Refusal> {
        let (coordinates, mut speeds) = instant::start(scene, n)?;
        let ties = scene.ties.len();
        let rims = scene.ties.iter().map(|tie| tie.rubbing()?.radius_m.map(|c| n.get(c))).collect();
        let mut all = Self {
            scene,
            rims,
            coordinates,
            legs: SmallVec::new(),
            ended: false,
            let_go: 0,
            rolled: Rolled::new(),
            until: smallvec![None; ties],
            through: None,
            sense: 0.0,
            gone: T::zero(),
            turning: None,
            fastest: T::zero(),
            ends: Each::new(),
            after: None,
        };
        let (mut setting, (mut response, mut needs)) = all.onset(n, &speeds, pulls)?;
        let first = setting.clone();
        let mut starts = T::zero();
        loop {
            let rates = all.rates(&response, pulls);
            let rests = all.comes_to_rest(&setting, &speeds, &rates, starts);
            let rest = rests
                .iter()
                .flatten()
                .copied()
                .reduce(|one, other| if other.below(one) { other } else { one });
            let holds = setting.holds.clone();
            let lasts = rest.unwrap_or_else(T::zero);
            let closed: SmallVec<[usize; 4]> = (0..ties)
                .filter(|t| rests[*t].zip(rest).is_some_and(|(own, rest)| own.apart(rest).is_zero()))
                .collect();
            let closes = closed.first().copied();
            let leg = Phase { response, holds, needs, closes, speeds, rates, starts, lasts, ways: None };
            // How far it would go on is looked for beyond its end, too.
            let end = all.end_in(n, &leg, rest).filter(|_| !all.ended);
            speeds = leg.after(lasts);
            if !all.ended {
                all.legs.push(leg);
            }
            if let (Some(time), Some(leg)) = (end, all.legs.last_mut()) {
                (leg.lasts, leg.closes) = (time, None);
                all.ended = true;
            }
            let Some(time) = rest.filter(|_| scene.end != End::AtOnce) else {
                all.if_held(n, &first)?;
                break;
            };
            starts = starts + time;
            // Beyond its end it is followed for what becomes of the contacts that still slip, as far as that is known.
            match all.settle(n, &mut setting, &closed, pulls) {
                Ok(Some(next)) => (response, needs) = next,
                Err(refusal) if !all.ended => return Err(refusal),
                Ok(None) if !all.ended => {
                    all.through = Some(starts);
                    all.leaves_open();
                    all.if_held(n, &first)?;
                    break;
                }
                _ => {
                    all.leaves_open();
                    break;
                }
            }
        }
        if let Some(leg) = all.legs.last() {
            all.ends = leg.after(leg.lasts);
        }
        if let End::TurningPoint(c) = scene.end
            && let Some(i) = all.coordinates.iter().position(|own| *own == c)
        {
            // At rest by the definition of the event, not by what rounding leaves.
            all.ends[i] = T::zero();
        }
        Ok(all)
    }

    /// When contacts come to rest that still slip is not known.
    fn leaves_open(&mut self) {
        for t in 0..self.until.len() {
            if self.rolled.iter().all(|(known, _)| *known != t) {
                self.until[t] = None;
            }
        }
    }

    /// What becomes of contacts at rest: static friction holds each of them, or it slips from there. `None` where one that has come to
    /// rest is said to slip and cannot be held.
    ///
    /// Errors: whether one is held hangs on what another does.
    fn settle(
        &mut self,
        n: &Numbers<T>,
        setting: &mut Setting,
        at_rest: &[usize],
        pulls: &[T],
    ) -> Result<Option<Forces<T>>, Refusal> {
        for t in at_rest {
            setting.holds[*t] = true;
            setting.friction_sense[*t] = 0.0;
        }
        let sets_off = self.legs.is_empty();
        let held = self.forces(n, setting, pulls)?;
        // A block that has been held so far may be drawn along by what rubs no longer.
        let stays = |t: &usize| {
            setting.holds[*t] && self.rims[*t].is_none() && self.scene.ties[*t].rubbing().is_some()
        };
        let resting: SmallVec<[usize; 4]> =
            (0..setting.holds.len()).filter(|t| at_rest.contains(t) || stays(t)).collect();
        let loose = self.too_weak(n, &resting, &held);
        let own = at_rest.iter().find(|t| !sets_off && !self.ended && self.scene.ends_with(**t));
        if own.is_some() && matches!(self.scene.end, End::TurningPoint(_)) {
            // It ends there whether it can be held or not.
            self.ended = true;
            self.turning = Some(self.gone);
            self.after = Some((setting.clone(), held.0.clone()));
        }
        let settled = if loose.is_empty() {
            held
        } else if !sets_off && loose.iter().any(|t| self.rims[*t].is_some()) {
            self.rolls(at_rest, &held.0);
            return Ok(None);
        } else {
            self.lets_go(n, (setting, &loose), pulls)?
        };
        let holds: SmallVec<[usize; 4]> = resting.into_iter().filter(|t| !loose.contains(t)).collect();
        if !self.too_weak(n, &holds, &settled).is_empty() {
            return Err(IN_TURN);
        }
        self.rolls(&holds, &settled.0);
        if sets_off {
            holds.iter().for_each(|t| self.until[*t] = Some(T::zero()));
        }
        if own.is_some_and(|own| holds.contains(own)) {
            self.ended = true;
            self.after = Some((setting.clone(), settled.0.clone()));
        }
        Ok(Some(settled))
    }

    /// Forces and accelerations, and what friction the contacts need.
    fn forces(&self, n: &Numbers<T>, setting: &Setting, pulls: &[T]) -> Result<Forces<T>, Refusal> {
        let response = respond(self.scene, n, setting)?;
        let needs = equations::needs(self.scene, n, (setting, &response), pulls)?;
        Ok((response, needs))
    }

    /// Those of these contacts that static friction cannot hold. What needs none is held by the other ties, whatever its friction.
    fn too_weak(
        &self,
        n: &Numbers<T>,
        ties: &[usize],
        (response, needs): &Forces<T>,
    ) -> SmallVec<[usize; 4]> {
        let slips = |t: &usize| {
            let (Some(rub), Some(needed)) = (self.scene.ties[*t].rubbing(), needs[*t]) else { return false };
            !needed.at_most(n.get(rub.mu_s) * response.normal(rub.body))
        };
        ties.iter().copied().filter(slips).collect()
    }

    /// How those of these contacts roll that are said to slip, as they do first.
    fn rolls(&mut self, ties: &[usize], response: &Response<T>) {
        for t in ties {
            if self.rims[*t].is_some() && self.rolled.iter().all(|(known, _)| known != t) {
                self.rolled.push((*t, response.clone()));
            }
        }
    }

    /// What never comes to rest: as if it held at the start.
    fn if_held(&mut self, n: &Numbers<T>, first: &Setting) -> Result<(), Refusal> {
        for (t, tie) in self.scene.ties.iter().enumerate() {
            if matches!(tie, Tie::Slip { .. }) && self.rolled.iter().all(|(known, _)| *known != t) {
                self.rolled.push((t, equations::held(self.scene, n, first, t)?));
            }
        }
        Ok(())
    }

    fn of(&self, values: &[T], body: usize, degree: Degree) -> T {
        let place = self.coordinates.iter().position(|c| *c == Coordinate { body, degree });
        place.map_or_else(T::zero, |i| values[i])
    }

    /// Velocity of the centre and of the rim at a contact that can rub, or their rates.
    fn at_contact(&self, tie: usize, values: &[T]) -> Option<[T; 2]> {
        let rub = self.scene.ties[tie].rubbing()?;
        let rim = self.rims[tie].map_or_else(T::zero, |c| {
            plant!("eom: speed of the rim", c * self.of(values, rub.body, Degree::Turn))
        });
        Some([self.of(values, rub.body, Degree::Along), rim])
    }

    /// The slip of a contact at the start, and the size of the speeds that make it up.
    pub fn slip(&self, tie: usize) -> (T, f64) {
        let [v, rim] = self.at_contact(tie, &self.legs[0].speeds).unwrap_or([T::zero(); 2]);
        (v.apart(rim), v.size() + rim.size())
    }

    /// How the contacts are at the start: what slips rubs.
    fn onset(&mut self, n: &Numbers<T>, speeds: &[T], pulls: &[T]) -> Result<(Setting, Forces<T>), Refusal> {
        let mut setting = Setting::loose(self.scene);
        let mut at_rest: SmallVec<[usize; 4]> = SmallVec::new();
        for t in 0..self.scene.ties.len() {
            let Some([v, rim]) = self.at_contact(t, speeds) else { continue };
            let slip = v.apart(rim);
            setting.friction_sense[t] = -slip.sign();
            if slip.is_zero() {
                at_rest.push(t);
            }
        }
        let settled = self.settle(n, &mut setting, &at_rest, pulls)?;
        Ok((setting, settled.ok_or(IN_TURN)?))
    }

    /// Contacts at rest that cannot be held slip the way that they would go without friction, each whatever the others do.
    fn lets_go(
        &mut self,
        n: &Numbers<T>,
        (setting, loose): (&mut Setting, &[usize]),
        pulls: &[T],
    ) -> Result<Forces<T>, Refusal> {
        self.let_go += 1;
        if self.let_go > 4 * self.rims.len() {
            return Err(IN_TURN);
        }
        loose.iter().for_each(|t| setting.holds[*t] = false);
        let smooth = respond(self.scene, n, setting)?;
        for t in loose {
            setting.friction_sense[*t] = -self.slips_by(*t, &smooth, pulls);
        }
        for t in loose {
            let mut alone = setting.clone();
            (alone.holds[*t], alone.friction_sense[*t]) = (true, 0.0);
            let held = self.forces(n, &alone, pulls)?;
            if self.too_weak(n, &[*t], &held).is_empty() {
                return Err(IN_TURN);
            }
            self.rolls(&[*t], &held.0);
        }
        let settled = self.forces(n, setting, pulls)?;
        let against = |t: &usize| self.slips_by(*t, &settled.0, pulls) * setting.friction_sense[*t] < 0.0;
        if loose.iter().all(against) { Ok(settled) } else { Err(IN_TURN) }
    }

    /// The sense in which a contact at rest begins to slip.
    fn slips_by(&self, tie: usize, response: &Response<T>, pulls: &[T]) -> f64 {
        let rates = self.rates(response, pulls);
        self.at_contact(tie, &rates).map_or(0.0, |[a, turned]| a.balance(-turned).sign())
    }

    fn rates(&self, response: &Response<T>, pulls: &[T]) -> Each<T> {
        self.coordinates.iter().map(|c| under(pulls, |k| response.acceleration(*c, k))).collect()
    }

    /// When contacts come to rest, from the start of this phase.
    fn comes_to_rest(&mut self, setting: &Setting, speeds: &[T], rates: &[T], starts: T) -> Needs<T> {
        let mut rests: Needs<T> = smallvec![None; setting.holds.len()];
        for t in 0..setting.holds.len() {
            let (Some([v, rim]), Some([a, turned])) = (self.at_contact(t, speeds), self.at_contact(t, rates))
            else {
                continue;
            };
            if setting.holds[t] {
                continue;
            }
            let slip = v.apart(rim);
            let closing = plant!("eom: rate of the slip", a.balance(-turned)).signed(-slip.sign());
            let time = (!slip.is_zero() && closing.sign() > 0.0).then(|| slip.abs() / closing);
            if self.rolled.iter().all(|(known, _)| *known != t) {
                self.until[t] = time.map(|time| starts + time);
            }
            rests[t] = time;
        }
        rests
    }

    /// When the end comes in this phase, from its start, which a contact that comes to rest ends.
    fn end_in(&mut self, n: &Numbers<T>, leg: &Phase<T>, rest: Option<T>) -> Option<T> {
        // What ties bring to rest with that contact comes to rest at the same time, whatever its last digits.
        let by_then = |time: &T| rest.is_none_or(|rest| !rest.below(*time) || rest.apart(*time).is_zero());
        let end = self.scene.ending_coordinate();
        let own = |held: bool| (0..leg.holds.len()).any(|t| leg.holds[t] == held && self.scene.ends_with(t));
        let [holds, rubs] = [true, false].map(own);
        let [v, a] = [&leg.speeds, &leg.rates].map(|of| self.of(of, end.body, end.degree));
        if self.sense == 0.0 && !self.ended {
            self.sense = if v.is_zero() { a.sign() } else { v.sign() };
        }
        match self.scene.end {
            End::Time(_, t) => return Some(n.get(t) - leg.starts).filter(by_then),
            End::AtOnce => return Some(T::zero()),
            End::Rolling(_) => return (holds && leg.starts.is_zero()).then(T::zero),
            _ => {}
        }
        let sense = self.sense;
        if self.turning.is_some() || sense == 0.0 || v.sign() * sense < 0.0 {
            self.turning = self.turning.or((sense != 0.0).then_some(self.gone));
            return None;
        }
        let legs = [Leg { from: T::zero(), f: a.signed(sense), w2: None }];
        let travel = Travel { u0: v.abs(), legs: &legs };
        // The turning point of what rubs as it slides is told where its contact comes to rest.
        let turning = travel.turning().filter(|_| !rubs);
        let asked = measure(self.scene, n, sense);
        let s = match self.scene.end {
            End::Speed(..) => asked.and_then(|u| travel.reaching(u)),
            End::TurningPoint(_) => turning,
            _ => asked.map(|s| s - self.gone),
        };
        let s = s.filter(|s| s.not_negative() && turning.is_none_or(|turning| s.at_most(turning)));
        let time = s.map(|s| travel.at(s).time).filter(by_then);
        let turns = turning.filter(|s| by_then(&travel.at(*s).time));
        let stays = (rest.is_none() && v.is_zero() && a.is_zero()).then(T::zero);
        self.turning = turns.or(stays).map(|s| self.gone + s);
        let fastest = match rest {
            _ if a.sign() * sense <= 0.0 => travel.u0,
            Some(rest) => travel.u0 + a.abs() * rest,
            None => T::of(f64::INFINITY),
        };
        self.fastest = self.fastest.larger(fastest);
        self.gone = self.gone + rest.map_or_else(T::zero, |rest| travel.after(rest));
        time
    }

    /// The velocity of a coordinate at the start.
    pub fn start_of(&self, c: Coordinate) -> T {
        self.of(&self.legs[0].speeds, c.body, c.degree)
    }

    /// The farthest that it goes, in the measure of its end; infinite where it goes on and on.
    pub fn farthest(&self) -> T {
        let endless = || T::of(f64::INFINITY);
        match self.scene.end {
            End::Time(..) | End::Rolling(_) => self.through.unwrap_or_else(endless),
            End::Speed(..) => self.fastest,
            _ => self.turning.or(self.through.map(|_| self.gone)).unwrap_or_else(endless),
        }
    }

    /// When it ends.
    pub fn time(&self) -> T {
        self.legs.last().map_or_else(T::zero, |leg| leg.starts + leg.lasts)
    }

    /// How what hangs linearly on the coordinates has gone: its velocity, its way.
    pub fn gone(&self, of: Linear<'_, T>) -> Gone<T> {
        let value = |values: &[T]| of(&|c: Coordinate| self.of(values, c.body, c.degree));
        let zero = T::zero();
        let mut all = Gone { unit: zero, speed: zero, moved: zero, path: zero, change: zero, work: zero };
        for (i, leg) in self.legs.iter().enumerate() {
            let [u0, rate] = [value(&leg.speeds), value(&leg.rates)];
            let gain = plant!("eom: gain of velocity", rate * leg.lasts);
            let after = self.legs.get(i + 1).map(|next| value(&next.speeds));
            let u1 = after.unwrap_or_else(|| value(&self.ends));
            let way = match &leg.ways {
                Some(ways) => value(ways),
                None => (u0 * leg.lasts).balance((rate * leg.lasts.square()).scale2(-1)),
            };
            let way = plant!("eom: travel while accelerated", way);
            all.moved = all.moved.balance(way);
            all.path = all.path + plant!("eom: path of the centre", path(u0, u1, leg.lasts));
            all.change = all.change.balance(gain);
            (all.speed, all.unit) = (u1, u1);
        }
        all
    }

    /// How far a contact slides, which changes its sense only where it comes to rest.
    pub fn slid(&self, tie: usize, of: Linear<'_, T>) -> T {
        let mut all = T::zero();
        for leg in self.legs.iter().filter(|leg| !leg.holds[tie]) {
            let [slip0, rate] = [&leg.speeds, &leg.rates].map(|values| {
                let values: &[T] = values;
                of(&|c: Coordinate| self.of(values, c.body, c.degree))
            });
            let way = slip0 * leg.lasts + (rate * leg.lasts.square()).scale2(-1);
            all = all + plant!("eom: way of the slipping contact", way.abs());
        }
        all
    }

    /// The phases by the steps of a rung, each landing on its event, and what that cost.
    pub fn stepped(&mut self, rung: Rung) -> Result<Count, Refusal> {
        let mut sum = Count::default();
        let end = self.scene.ending_coordinate();
        let total = self.time();
        let formula = rung.method().formula().unwrap_or(Formula::Dop853);
        let (mut starts, mut speeds) = (T::zero(), self.legs[0].speeds.clone());
        for i in 0..self.legs.len() {
            let leg = &self.legs[i];
            let lasts = leg.lasts.f64();
            let first = if lasts > 0.0 { 0.05 * lasts } else { 1.0 };
            // One coordinate, or the slip of a contact: `[x, v]` under a constant acceleration.
            let mut run = |v: T, a: T, stop: &Stop| -> Result<[f64; 3], Refusal> {
                let a = a.f64();
                let field = |_: f64, y: &[f64; 2]| [y[1], a];
                let mut run = Run::new(formula, field, 0.0, [0.0, v.f64()], rung.pace(first));
                let landed = match stop {
                    Stop::Time(time) => run.to(*time),
                    Stop::Rest => {
                        let sense = -v.sign();
                        run.until(&|_, y| sense * y[1], v.size(), &|_, _| -1.0)
                    }
                    Stop::Place(s) => run.until(&|_, y| s.signum() * (y[0] - s), s.abs(), &|_, _| -1.0),
                };
                landed.map_err(|trouble| Refusal::Trouble { method: rung.method(), trouble })?;
                sum += run.count();
                let [x, v] = run.y();
                Ok([run.x(), x, v])
            };
            let time = match (
                leg.closes
                    .and_then(|t| Some((self.at_contact(t, &speeds)?, self.at_contact(t, &leg.rates)?))),
                self.scene.end,
            ) {
                (Some(([v, rim], [a, turned])), _) => run(v - rim, a - turned, &Stop::Rest)?[0],
                (None, End::Time(..)) => total.f64() - starts.f64(),
                (None, _) => {
                    let v = self.of(&speeds, end.body, end.degree);
                    let a = self.of(&leg.rates, end.body, end.degree);
                    let way = v.f64() * lasts + 0.5 * a.f64() * lasts * lasts;
                    if matches!(self.scene.end, End::TurningPoint(_)) {
                        run(v, a, &Stop::Rest)?[0]
                    } else if way != 0.0 {
                        run(v, a, &Stop::Place(way))?[0]
                    } else {
                        lasts
                    }
                }
            };
            let (mut ways, mut next) = (Each::new(), Each::new());
            for (v, a) in speeds.iter().zip(&leg.rates) {
                let [_, x, v] = run(*v, *a, &Stop::Time(time))?;
                ways.push(T::of(x));
                next.push(T::of(v));
            }
            let leg = &mut self.legs[i];
            (leg.speeds, leg.starts, leg.lasts, leg.ways) = (speeds, starts, T::of(time), Some(ways));
            starts = starts + leg.lasts;
            speeds = next;
        }
        self.ends = speeds;
        Ok(sum)
    }
}

/// Where a run of steps stops.
enum Stop {
    Time(f64),
    Rest,
    Place(f64),
}

impl<T: Real> Phase<T> {
    fn after(&self, time: T) -> Each<T> {
        self.speeds.iter().zip(&self.rates).map(|(v, a)| v.settled(*a * time)).collect()
    }
}
