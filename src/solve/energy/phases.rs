//! A motion in phases, by energies and impulses of its modes.
//!
//! A unit impulse at a contact sets off the motion that has no kinetic energy in common with any in which the contact is at rest: the
//! mode of its slip. The energy of that is spent on friction,
//!
//! ```text
//! 1/2 M_s s0^2 = (mu_k N - Q_s) l      work until the contact is at rest, l its way over the surface
//! M u' = Q                             impulse of the given forces in each mode
//! ```
//! so that the way comes first, then the time (twice the way over the slip at the start), then the speeds from what each mode in which
//! the contact stays at rest has gained of momentum.
use crate::num::plant::plant;
use crate::num::{Real, ball};
use crate::scene::{Coordinate, End, Numbers, Rubbing, Scene, Tie};
use crate::solve::energy::account::{Account, Stores};
use crate::solve::energy::balance::{self, PerTie, Reactions};
use crate::solve::energy::speeds::{self, Mode, Modes};
use crate::solve::energy::{Gone, frictions, motion, push};
use crate::solve::outcome::{Refusal, Unsupported};
use smallvec::{SmallVec, smallvec};

/// A stretch of the motion in which the velocities change evenly.
#[derive(Clone)]
pub struct Phase<T> {
    /// Velocities at its start and end.
    from: Mode<T>,
    to: Mode<T>,
    /// How long it lasts.
    time: T,
    /// Accelerations.
    pub rate: Mode<T>,
    /// Kinetic friction of the contacts that rub; those that hold have none.
    pub kinetic: PerTie<Option<T>>,
    /// The friction of those that hold, among all reactions.
    pub held: Reactions<T>,
    /// What friction those need.
    needs: Needs<T>,
}

/// Contacts at rest of which one is held on account of what another does.
const IN_TURN: Refusal = Refusal::Unsupported(Unsupported::SlidesInTurn);

/// Of each tie the friction that its contact needs, if it is one that could rub and holds by friction.
type Needs<T> = PerTie<Option<T>>;

/// The reactions, and what friction the contacts need.
type Held<T> = (Reactions<T>, Needs<T>);

/// What a contact that is said to slip would do if it held.
#[derive(Clone)]
pub struct Rolled<T> {
    /// Index of the tie.
    pub tie: usize,
    /// Friction that it then has.
    pub friction: T,
    /// Accelerations from there on; none of what never comes to roll.
    pub rate: Option<Mode<T>>,
}

/// A motion in phases, up to its end if it gets there.
pub struct Phases<T: Real> {
    /// Its phases: those up to the end, or all of them.
    pub legs: SmallVec<[Phase<T>; 2]>,
    /// Is its end reached?
    pub ended: bool,
    /// The contacts that are said to slip, but those that cannot be followed from the end to where they come to rest.
    pub rolled: SmallVec<[Rolled<T>; 1]>,
    /// Sense in which the ending coordinate sets off.
    pub sense: f64,
}

/// What is fixed while a motion is followed, and how far it is.
pub struct Follower<'s, 'a, T: Real> {
    /// The scene.
    pub scene: &'s Scene,
    /// Its numbers.
    pub n: &'s Numbers<'a, T>,
    pulls: &'s [T],
    /// Kinetic friction of the contacts that rub; those that hold have none.
    pub kinetic: PerTie<Option<T>>,
    sense: f64,
    turned: bool,
    gone: T,
    spent: T,
    let_go: usize,
}

/// Is it a contact that is said to slip?
pub fn slips(scene: &Scene, tie: usize) -> bool {
    matches!(scene.ties[tie], Tie::Slip { .. })
}

/// Velocity of a contact that can rub.
pub fn slip<T: Real>(n: &Numbers<T>, rub: &Rubbing, mode: &Mode<T>) -> [T; 2] {
    let rim = rub
        .radius_m
        .map_or_else(T::zero, |c| plant!("energy: contact of a slipping body", n.get(c)) * mode.w[rub.body]);
    [mode.v[rub.body], rim]
}

/// Path between two velocities of one phase, at the mean speed of each stretch in one sense.
fn path<T: Real>(from: T, to: T, time: T) -> T {
    let (before, after) = (from.abs(), to.abs());
    if from.sign() * to.sign() < 0.0 {
        let there = time * (before / (before + after));
        (before * there + after * (time - there)).scale2(-1)
    } else {
        ((before + after) * time).scale2(-1)
    }
}

/// When the first contact comes to rest, and those that do so then. Of some at almost one time it makes no difference which is the
/// first: friction does no work in the motions in which neither of them slips, and these alone go on.
fn soonest<T: Real>(rests: &[(usize, T)]) -> (Option<T>, SmallVec<[usize; 2]>) {
    let sooner = |a: T, b: T| if b.below(a) { b } else { a };
    let Some(first) = ball::unwatched(|| rests.iter().map(|r| r.1).reduce(sooner)) else {
        return (None, SmallVec::new());
    };
    let at_once = |time: T| ball::unwatched(|| time.apart(first).is_zero()) || time.at_most(first);
    let (mut all, mut closed) = (first, SmallVec::new());
    for (t, time) in rests.iter().filter(|r| at_once(r.1)) {
        all = all.widened(|| (*time - first).size() + time.radius());
        closed.push(*t);
    }
    (Some(all), closed)
}

impl<T: Real> Phases<T> {
    /// Follows the motion. `pulls` is what springs pull, at an instant.
    ///
    /// Errors: a start that contradicts the ties or leaves something open; what holds does so in a way that is left open.
    pub fn follow(scene: &Scene, n: &Numbers<T>, pulls: &[T]) -> Result<Self, Refusal> {
        let (zero, at_once) = (T::zero(), scene.end == End::AtOnce);
        let mut from = speeds::at_start(scene, n)?;
        let mut now = Follower::new(scene, n, pulls);
        let mut all = Self { legs: SmallVec::new(), ended: false, rolled: SmallVec::new(), sense: 0.0 };
        let (mut held, mut needs) = now.onset(&from, &mut all)?;
        let onset = now.kinetic.clone();
        loop {
            let (modes, rate) = (now.modes(), now.rate());
            // At an instant nothing hangs on what comes after it.
            let rests = if at_once { SmallVec::new() } else { now.comes_to_rest(&modes, &from) };
            let (next, closed) = soonest(&rests);
            let end = if all.ended { None } else { now.end_in(&from, &rate, next) };
            let kinetic = now.kinetic.clone();
            let leg = Phase { from: from.clone(), to: from.clone(), time: zero, rate, kinetic, held, needs };
            if let Some(time) = end {
                let to = match scene.end {
                    // At rest by the definition of the event, not by what rounding leaves, and so are those that move with it alone.
                    End::TurningPoint(_) => now.gained(&modes[1..], &now.kinetic, Some(&from), time),
                    _ => now.after(&modes, &from, time),
                };
                all.legs.push(Phase { to, time, ..leg.clone() });
                all.ended = true;
            }
            if all.ended && all.tells_rolling(scene) {
                break;
            }
            let Some(time) = next else {
                if !all.ended {
                    all.legs.push(leg);
                }
                now.if_held(onset, &mut all.rolled)?;
                break;
            };
            closed.iter().for_each(|t| now.kinetic[*t] = None);
            let to = now.after_with(&leg.kinetic, &from, time);
            now.spent = now.spent + time;
            from = to.clone();
            if !all.ended {
                all.legs.push(Phase { to, time, ..leg });
            }
            // After its end the motion goes on until all is told of what slips, or nothing is known any more.
            match now.settle(&closed, &mut all) {
                Ok(Some(next)) => (held, needs) = next,
                Err(refusal) if !all.ended => return Err(refusal),
                Ok(None) if !all.ended => {
                    now.if_held(onset, &mut all.rolled)?;
                    break;
                }
                _ => break,
            }
        }
        all.sense = now.sense;
        Ok(all)
    }

    /// Is it told of each contact that slips how it would roll?
    fn tells_rolling(&self, scene: &Scene) -> bool {
        (0..scene.ties.len()).all(|t| !slips(scene, t) || self.rolled.iter().any(|known| known.tie == t))
    }

    /// How something has gone that hangs linearly on the velocities.
    pub fn gone(&self, of: &dyn Fn(&Mode<T>) -> T) -> Gone<T> {
        let zero = T::zero();
        let before = self.legs.first().map_or(zero, |leg| of(&leg.from));
        let mut all = Gone { unit: before, before, speed: before, moved: zero, path: zero };
        for leg in &self.legs {
            let (a, b) = (of(&leg.from), of(&leg.to));
            let way = (a.balance(b) * leg.time).scale2(-1);
            all.moved = all.moved.balance(plant!("energy: way at the mean velocity", way));
            all.path = all.path + plant!("energy: path of the centre", path(a, b, leg.time));
            (all.unit, all.speed) = (b, b);
        }
        all
    }

    /// How far a contact slides, which changes its sense only at rest: on the way its mean speed counts.
    pub fn slid(&self, tie: usize, of: &dyn Fn(&Mode<T>) -> T) -> T {
        let rubs = self.legs.iter().filter(|leg| leg.kinetic[tie].is_some());
        let way = |leg: &Phase<T>| ((of(&leg.from) + of(&leg.to)).abs() * leg.time).scale2(-1);
        rubs.fold(T::zero(), |sum, leg| sum + plant!("energy: way of a contact", way(leg)))
    }

    /// When it ends.
    pub fn time(&self) -> T {
        self.legs.iter().fold(T::zero(), |sum, leg| sum + leg.time)
    }

    /// The velocities at the start and at the end.
    pub fn ends(&self) -> [&Mode<T>; 2] {
        [&self.legs[0].from, &self.legs[self.legs.len() - 1].to]
    }

    /// The most friction that a contact which could rub needs while it holds.
    pub fn needed(&self, tie: usize) -> Option<T> {
        self.legs.iter().filter_map(|leg| leg.needs[tie]).reduce(T::larger)
    }
}

impl<'s, 'a, T: Real> Follower<'s, 'a, T> {
    /// It stands at the start, and nothing rubs.
    pub fn new(scene: &'s Scene, n: &'s Numbers<'a, T>, pulls: &'s [T]) -> Self {
        let (kinetic, gone) = (smallvec![None; scene.ties.len()], T::zero());
        Self { scene, n, pulls, kinetic, sense: 0.0, turned: false, gone, spent: gone, let_go: 0 }
    }
    fn rubbing(&self) -> impl Iterator<Item = (usize, Rubbing)> {
        let ties = self.scene.ties.iter().enumerate();
        ties.filter_map(|(t, tie)| Some((t, tie.rubbing()?)))
    }
    /// Motions in which the contacts that hold are at rest.
    pub fn modes(&self) -> Modes<T> {
        let holds: PerTie<bool> = self.kinetic.iter().map(Option::is_none).collect();
        speeds::modes(self.scene, self.n, &holds)
    }
    fn power(&self, kinetic: &[Option<T>], mode: &Mode<T>) -> (T, f64) {
        push(self.scene, self.n, mode, &frictions(kinetic), self.pulls)
    }
    /// Their accelerations.
    pub fn rate(&self) -> Mode<T> {
        motion(self.n, &self.modes(), |mode| self.power(&self.kinetic, mode))
    }
    /// The reactions then.
    pub fn reactions(&self, rate: &Mode<T>) -> Reactions<T> {
        balance::reactions(self.scene, self.n, &|c: Coordinate| rate.of(c), self.pulls, &self.kinetic)
    }

    /// The motion of the momenta that a motion `had`, if one is given, with what each mode has gained after a time.
    fn gained(&self, modes: &[Mode<T>], kinetic: &[Option<T>], had: Option<&Mode<T>>, time: T) -> Mode<T> {
        motion(self.n, modes, |mode| {
            let (power, size) = self.power(kinetic, mode);
            let (gain, size) = (plant!("energy: impulse in a mode", power * time), size * time.size());
            let Some(from) = had else { return (gain, size) };
            let had = plant!("energy: momentum of a mode", balance::inertia(self.n, mode, from));
            (had.settled(gain), had.size() + size)
        })
    }
    /// The velocities after a time. What gains nothing goes on as it is, whatever the rounding of a start that fits the ties.
    fn after(&self, modes: &[Mode<T>], from: &Mode<T>, time: T) -> Mode<T> {
        if time.is_zero() { from.clone() } else { from.plus(&self.gained(modes, &self.kinetic, None, time)) }
    }
    /// The same where contacts have just come to rest that rubbed with this friction.
    fn after_with(&self, kinetic: &[Option<T>], from: &Mode<T>, time: T) -> Mode<T> {
        self.gained(&self.modes(), kinetic, Some(from), time)
    }

    /// The contacts at the start: what slips rubs.
    fn onset(&mut self, from: &Mode<T>, all: &mut Phases<T>) -> Result<Held<T>, Refusal> {
        let own: SmallVec<[(usize, Rubbing); 4]> = self.rubbing().collect();
        let mut at_rest: SmallVec<[usize; 2]> = SmallVec::new();
        for (t, rub) in &own {
            let [v, rim] = slip(self.n, rub, from);
            match v.apart(rim).sign() {
                0.0 => at_rest.push(*t),
                sense => self.kinetic[*t] = Some(self.friction(rub).signed(-sense)),
            }
        }
        self.settle(&at_rest, all)?.ok_or(IN_TURN)
    }

    /// Kinetic friction.
    pub fn friction(&self, rub: &Rubbing) -> T {
        let normal = balance::normal(self.scene, self.n, rub.body);
        plant!("energy: kinetic friction", self.n.get(rub.mu_k)) * normal
    }

    /// The friction that those contacts need which hold. Bodies that slide and are held together give way in one motion: its power is
    /// taken by all of them in the ratio of what their static friction could take.
    ///
    /// Errors: what slips is held by other ties as well, or such bodies can give way in several motions.
    fn needs(&self, held: &Reactions<T>) -> Result<Needs<T>, Refusal> {
        let mut needs: Needs<T> = smallvec![None; self.scene.ties.len()];
        let mut holds: PerTie<bool> = self.kinetic.iter().map(Option::is_none).collect();
        let fast = speeds::modes(self.scene, self.n, &holds).len();
        let mut shared: SmallVec<[(usize, Rubbing); 4]> = SmallVec::new();
        for (t, rub) in self.rubbing().filter(|(t, _)| self.kinetic[*t].is_none()) {
            if !held.is_open(t) {
                needs[t] = Some(held[t].abs());
            } else if rub.radius_m.is_some() {
                return Err(Refusal::SlipShared(t));
            } else {
                holds[t] = false;
                shared.push((t, rub));
            }
        }
        let loose = speeds::modes(self.scene, self.n, &holds);
        if loose.len() > fast + 1 {
            return Err(IN_TURN);
        }
        let slides = |mode: &&Mode<T>| shared.iter().any(|(_, rub)| !mode.v[rub.body].is_zero());
        let Some(way) = loose.iter().find(slides) else { return Ok(needs) };
        let (power, _) = self.power(&self.kinetic, way);
        let taken = power.balance(-balance::inertia(self.n, way, &self.rate())).abs();
        let limits = shared.iter().map(|(t, rub)| {
            let normal = balance::normal(self.scene, self.n, rub.body);
            (*t, self.n.get(rub.mu_s) * normal, way.v[rub.body].abs())
        });
        let most = limits.clone().fold(T::zero(), |sum, (_, limit, v)| sum + limit * v);
        for (t, limit, v) in limits.filter(|(.., v)| !v.is_zero()) {
            needs[t] = Some(if most.is_zero() { taken / v } else { taken * limit / most });
        }
        Ok(needs)
    }

    /// Contacts are at rest: friction either needs no power of theirs, or it loses some as they slip from there. `None` where one that
    /// has come to rest would have to roll and cannot.
    ///
    /// Errors: whether one is held hangs on what another does.
    fn settle(&mut self, at_rest: &[usize], all: &mut Phases<T>) -> Result<Option<Held<T>>, Refusal> {
        let starts = all.legs.is_empty();
        let held = self.held()?;
        // Of blocks that stay so far one may be drawn along now.
        let stays = |t: &usize| self.kinetic[*t].is_none() && !slips(self.scene, *t);
        let own = self.rubbing().map(|(t, _)| t);
        let resting: SmallVec<[usize; 2]> = own.filter(|t| at_rest.contains(t) || stays(t)).collect();
        let loose = self.yields(&resting, &held.1);
        let own = at_rest.iter().find(|t| !starts && self.scene.ends_with(**t));
        // At its turning point it ends, held or not.
        all.ended |= own.is_some() && matches!(self.scene.end, End::TurningPoint(_));
        if !starts && loose.iter().any(|t| slips(self.scene, *t)) {
            self.rolls(at_rest, &held.0, &mut all.rolled);
            return Ok(None);
        }
        let settled = if loose.is_empty() { held } else { self.gives_way(&loose, &mut all.rolled)? };
        let holds: SmallVec<[usize; 2]> = resting.into_iter().filter(|t| !loose.contains(t)).collect();
        if !self.yields(&holds, &settled.1).is_empty() {
            return Err(IN_TURN);
        }
        self.rolls(&holds, &settled.0, &mut all.rolled);
        all.ended |= own.is_some_and(|own| holds.contains(own));
        Ok(Some(settled))
    }

    /// The reactions, and what friction the contacts need that hold.
    fn held(&self) -> Result<Held<T>, Refusal> {
        let held = self.reactions(&self.rate());
        let needs = self.needs(&held)?;
        Ok((held, needs))
    }

    /// What never comes to rest: as if it held at the start, with this friction of the others.
    fn if_held(
        &mut self,
        onset: PerTie<Option<T>>,
        rolled: &mut SmallVec<[Rolled<T>; 1]>,
    ) -> Result<(), Refusal> {
        self.kinetic = onset;
        for t in 0..self.scene.ties.len() {
            if slips(self.scene, t) && rolled.iter().all(|known| known.tie != t) {
                let rubbed = self.kinetic[t].take();
                let held = self.reactions(&self.rate());
                if held.is_open(t) {
                    return Err(Refusal::SlipShared(t));
                }
                rolled.push(Rolled { tie: t, friction: held[t], rate: None });
                self.kinetic[t] = rubbed;
            }
        }
        Ok(())
    }

    /// Contacts that cannot be held lose power to friction as they slip from rest, each whether or not the others do.
    fn gives_way(
        &mut self,
        loose: &[usize],
        rolled: &mut SmallVec<[Rolled<T>; 1]>,
    ) -> Result<Held<T>, Refusal> {
        let own: SmallVec<[(usize, Rubbing); 2]> =
            self.rubbing().filter(|(t, _)| loose.contains(t)).collect();
        let sense = |rub: &Rubbing, rate: &Mode<T>| {
            let [v, rim] = slip(self.n, rub, rate);
            v.balance(-rim).sign()
        };
        own.iter().for_each(|(t, _)| self.kinetic[*t] = Some(T::zero()));
        let smooth = self.rate();
        for (t, rub) in &own {
            self.kinetic[*t] = Some(self.friction(rub).signed(-sense(rub, &smooth)));
        }
        for (t, _) in &own {
            let rubs = self.kinetic[*t].take();
            let held = self.held()?;
            if self.yields(&[*t], &held.1).is_empty() {
                return Err(IN_TURN);
            }
            self.rolls(&[*t], &held.0, rolled);
            self.kinetic[*t] = rubs;
        }
        let rate = self.rate();
        self.let_go += 1;
        let loses = |(_, rub): &(usize, Rubbing)| sense(rub, &rate) * sense(rub, &smooth) > 0.0;
        if self.let_go <= 4 * self.kinetic.len() && own.iter().all(loses) {
            self.held()
        } else {
            Err(IN_TURN)
        }
    }

    /// Those of these contacts that need more than static friction can give. What needs none is held by the other ties: no power is lost.
    fn yields(&self, ties: &[usize], needs: &[Option<T>]) -> SmallVec<[usize; 2]> {
        let more = |t: &usize| {
            let (Some(rub), Some(needed)) = (self.scene.ties[*t].rubbing(), needs[*t]) else { return false };
            !needed.at_most(self.n.get(rub.mu_s) * balance::normal(self.scene, self.n, rub.body))
        };
        ties.iter().copied().filter(more).collect()
    }

    /// Of those of these contacts that are said to slip it is told what they need at first.
    fn rolls(&self, ties: &[usize], held: &Reactions<T>, rolled: &mut SmallVec<[Rolled<T>; 1]>) {
        for t in ties {
            if slips(self.scene, *t) && rolled.iter().all(|known| known.tie != *t) {
                rolled.push(Rolled { tie: *t, friction: held[*t], rate: Some(self.rate()) });
            }
        }
    }

    /// The contacts that come to rest, each with the time until then.
    fn comes_to_rest(&self, modes: &[Mode<T>], from: &Mode<T>) -> SmallVec<[(usize, T); 2]> {
        let mut rests = SmallVec::new();
        for (t, rub) in self.rubbing() {
            let Some(friction) = self.kinetic[t] else { continue };
            let [v, rim] = slip(self.n, &rub, from);
            let slip0 = v.apart(rim);
            if slip0.is_zero() {
                continue;
            }
            // What a unit impulse at the contact sets off, at unit slip.
            let struck = motion(self.n, modes, |mode| {
                let [v, rim] = slip(self.n, &rub, mode);
                (v.balance(-rim), v.size() + rim.size())
            });
            let [v, rim] = slip(self.n, &rub, &struck);
            let unit = v - rim;
            let mut without = self.kinetic.clone();
            without[t] = Some(T::zero());
            let (power, _) = self.power(&without, &struck);
            let doubled = balance::inertia(self.n, &struck, &struck) / unit.square();
            let loss = friction.balance(power / unit).signed(-slip0.sign());
            if loss.sign() > 0.0 {
                let energy = plant!("energy: energy of the slip", doubled * slip0.square()).scale2(-1);
                let way = energy / loss;
                rests.push((t, way.scale2(1) / slip0.abs()));
            }
        }
        rests
    }

    /// When the end comes in this phase, from its start, unless a contact comes to rest before.
    fn end_in(&mut self, from: &Mode<T>, rate: &Mode<T>, next: Option<T>) -> Option<T> {
        // Where ties stop it together with that contact, both times are one.
        let in_time = |time: &T| next.is_none_or(|next| !next.below(*time) || next.apart(*time).is_zero());
        let end = self.scene.ending_coordinate();
        let (u0, gain) = (from.of(end), rate.of(end));
        let own = |held| {
            (0..self.kinetic.len()).any(|t| self.kinetic[t].is_none() == held && self.scene.ends_with(t))
        };
        let [holds, rubs] = [true, false].map(own);
        if self.sense == 0.0 {
            self.sense = [u0, gain].iter().map(|x| x.sign()).find(|s| *s != 0.0).unwrap_or(0.0);
        }
        match self.scene.end {
            End::AtOnce => return Some(T::zero()),
            End::Time(_, t) => return Some(self.n.get(t) - self.spent).filter(in_time),
            End::Rolling(_) => return (self.spent.is_zero() && holds).then(T::zero),
            // It ends where the contact comes to rest.
            End::TurningPoint(_) if rubs => return None,
            _ => {}
        }
        if self.turned || u0.sign() * self.sense < 0.0 || self.sense == 0.0 {
            return None;
        }
        // Half the square of its speed is its own account.
        let u0 = u0.abs();
        let energy0 = u0.square().scale2(-1);
        let constant = gain.signed(self.sense);
        let account = Account { constant, doubled: T::of(1.0), energy0, u0, stores: Stores::new() };
        let turning = account.turning();
        let place = match self.scene.end {
            End::Travel(_, d) => Some(self.n.get(d) - self.gone),
            End::Position(_, x) => Some(self.n.get(x).signed(self.sense) - self.gone),
            End::Speed(_, u) => account.where_speed(self.n.get(u).abs()),
            _ => None,
        };
        let place = place.filter(|s| s.not_negative() && turning.is_none_or(|far| s.at_most(far)));
        // Where it turns it is at rest; brought to rest with the next contact, it is so whichever of them is taken to be the first.
        let turns = || {
            let time = account.time(turning?, T::zero());
            match next.filter(|next| ball::unwatched(|| next.apart(time).is_zero())) {
                Some(next) => Some(time.widened(|| (next - time).size() + next.radius())),
                None => Some(time).filter(in_time),
            }
        };
        let time = match self.scene.end {
            End::TurningPoint(_) => turns(),
            _ => place.map(|s| account.time(s, account.speed(s))).filter(in_time),
        };
        // What comes after its end is not asked.
        self.turned = time.is_none() && turns().is_some();
        self.gone = self.gone + next.map_or_else(T::zero, |next| account.place(next));
        time
    }
}
