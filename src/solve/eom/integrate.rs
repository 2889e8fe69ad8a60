//! The same motion step by step in time: `q'' = f(q)` from the start to each event, landing on it.
//!
//! The state is place and speed, so a start from rest is regular: nothing divides by the speed. Where the law changes (a cord
//! goes slack) a step ends on the change and the next begins under the new law.
use crate::num::Real;
use crate::num::ode::{Count, Formula, MOST_STEPS, Run, Trouble};
use crate::scene::Quantity;
use crate::solve::eom::Steps;
use crate::solve::eom::travel::{Leg, State, Travel};
use crate::solve::method::Rung;
use smallvec::SmallVec;
use std::cell::Cell;

/// An event of a motion along its sense.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event {
    /// At this distance.
    Place(f64),
    /// After this time.
    Time(f64),
    /// When the speed has risen to this.
    Rise(f64),
    /// When the speed has fallen to this.
    Fall(f64),
    /// When the acceleration has fallen to 0.
    Level,
    /// When what presses has fallen to 0.
    Release,
}

/// A motion along its sense: `f(piece, s, u)` with the places at which the next piece takes over.
pub struct Route<'r, L> {
    /// Acceleration at a distance and a speed; the first argument is the piece, from 0.
    pub law: L,
    /// The force that presses at a distance and a speed, for [`Event::Release`].
    pub presses: &'r dyn Fn(f64, f64) -> f64,
    /// Where the pieces after the first begin.
    pub switches: &'r [f64],
    /// Speed at the start, >= 0.
    pub u0: f64,
    /// Rough time to the farthest event: what the first step is measured by.
    pub pace: f64,
    /// Time to the last event without steps, looked up for a run that goes on and on; infinite if it is not known.
    pub time: &'r dyn Fn() -> f64,
}

/// A run that takes so many times the time of the motion has passed its event.
const OVERDUE: f64 = 20.0;
/// A run that takes so many times its rough time goes on and on.
const LONG: f64 = 100.0;

/// Rough time over a way under an acceleration of this size and from this speed: what the first step is measured by; 1 s where
/// neither tells it.
pub fn pace(way: f64, force: f64, u0: f64) -> f64 {
    let times = [(2.0 * way / force).sqrt(), way / u0];
    let pace = times.into_iter().filter(|t| t.is_finite() && *t > 0.0).fold(f64::INFINITY, f64::min);
    if pace.is_finite() { pace } else { 1.0 }
}

impl<L: Fn(usize, f64, f64) -> f64> Route<'_, L> {
    /// The states at these events, which are given in the order in which they come, each with the distance at which it is
    /// expected (only to know on which side of the switch it lies).
    ///
    /// Errors: [`Trouble`]; an event that does not come before the motion turns is missed.
    pub fn states(&self, events: &[(Event, f64)], rung: Rung) -> Result<(Vec<State<f64>>, Count), Trouble> {
        // The rough time is at least half of the true one.
        if let Rung::Fixed(_, step) = rung
            && self.pace / step > 2.0 * MOST_STEPS as f64
        {
            return Err(Trouble::StepTooShort { step, steps: self.pace / step });
        }
        let piece = Cell::new(0);
        let field = |_: f64, y: &[f64; 2]| [y[1], (self.law)(piece.get(), y[0], y[1])];
        let formula = rung.method().formula().unwrap_or(Formula::Dop853);
        let mut run = Run::new(formula, field, 0.0, [0.0, self.u0], rung.pace(0.05 * self.pace));
        // Long steps, or a loose tolerance, can go past an event for ever.
        let step = if let Rung::Fixed(_, step) = rung { step } else { 0.0 };
        run.give_up_at(LONG * (self.pace + step));
        let mut bounded = false;
        let turned = |_: f64, y: &[f64; 2]| -y[1];
        // The size of the accelerations and speeds to come, for the residuals.
        let farthest = events.iter().fold(0.0, |far: f64, e| far.max(e.1));
        let force =
            (0..=8).map(|i| (self.law)(0, 0.125 * f64::from(i) * farthest, 0.0).abs()).fold(0.0, f64::max);
        let speed = (self.u0 * self.u0 + 2.0 * force * farthest).sqrt();
        let pressing = (self.presses)(0.0, self.u0).abs();
        let forever = |_: f64, _: &[f64; 2]| -1.0;
        let mut states = Vec::with_capacity(events.len());
        for (event, expected) in events {
            while let Some(at) = self.switches.get(piece.get()).filter(|at| *expected > **at) {
                run.until(&|_, y| y[0] - at, *at, &turned)?;
                piece.set(piece.get() + 1);
                run.refresh();
            }
            let law = |_: f64, y: &[f64; 2]| -(self.law)(piece.get(), y[0], y[1]);
            let pressed = |_: f64, y: &[f64; 2]| -(self.presses)(y[0], y[1]);
            loop {
                let landed = match *event {
                    Event::Place(s) => run.until(&|_, y| y[0] - s, s.abs(), &turned),
                    Event::Time(t) => run.to(t),
                    Event::Rise(u) => run.until(&|_, y| y[1] - u, speed, &turned),
                    Event::Fall(u) => run.until_next(&|_, y| u - y[1], speed, &forever),
                    Event::Level => run.until(&law, force, &turned),
                    Event::Release => run.until(&pressed, pressing, &turned),
                };
                match landed {
                    Err(Trouble::Overdue { .. }) if !bounded => {
                        let time = (self.time)();
                        run.give_up_at(if time >= 0.0 { OVERDUE * (time + step) } else { f64::INFINITY });
                        bounded = true;
                    }
                    landed => {
                        landed?;
                        break;
                    }
                }
            }
            let [s, u] = run.y();
            // At a turning point a residual may leave a speed of -1e-17.
            states.push(State { s, u: u.max(0.0), time: run.x() });
        }
        Ok((states, run.count()))
    }
}

/// What a run gives of a motion.
#[derive(Debug, Clone, Copy)]
pub struct Path<T> {
    /// At the ending event.
    pub end: Option<State<T>>,
    /// Where it is fastest.
    pub fastest: Option<State<T>>,
    /// Where it turns.
    pub turning: Option<State<T>>,
    /// What it has cost.
    pub count: Count,
}

/// Follows a motion under a constant or linear law by this rung, once, landing on each event that is wanted: the ending one, if there is
/// one at the distance at which the closed form has it, that of the greatest speed and the turning point, if they are asked for.
///
/// Which events there are follows from the signs in the law; where they are, from the steps. Errors: [`Trouble`].
pub fn path<T: Real>(
    travel: &Travel<'_, T>,
    end: Option<(Event, T)>,
    (rung, asked): Steps,
) -> Result<Path<T>, Trouble> {
    let leg = |leg: &Leg<T>| [leg.from.f64(), leg.f.f64(), leg.w2.map_or(0.0, T::f64)];
    let legs: SmallVec<[[f64; 3]; 2]> = travel.legs.iter().map(leg).collect();
    let switches: SmallVec<[f64; 2]> = legs.iter().skip(1).map(|leg| leg[0]).collect();
    let mut events: Vec<(Event, f64, usize)> = Vec::with_capacity(3);
    const END: usize = 0;
    const FASTEST: usize = 1;
    const TURNING: usize = 2;
    if let Some((event, s)) = end {
        events.push((event, s.f64(), END));
    }
    let fastest = asked(Quantity::VMax) || asked(Quantity::DAtVMax);
    if let (true, Some((at, _))) = (fastest, travel.fastest()) {
        let at = at.f64();
        // At the start, or where a cord goes slack, or where the acceleration vanishes on the way.
        let kept = at == 0.0 || legs.iter().skip(1).any(|leg| at >= leg[0] && leg[1] == 0.0);
        let event = if kept { Event::Place(at) } else { Event::Level };
        events.push((event, at, FASTEST));
    }
    if let (true, Some(at)) = (asked(Quantity::DTurn), travel.turning()) {
        events.push((Event::Fall(0.0), at.f64(), TURNING));
    }
    events.sort_by(|a, b| a.1.total_cmp(&b.1));
    let farthest = events.iter().fold(0.0, |far: f64, e| far.max(e.1));
    let u0 = travel.u0.f64();
    let route = Route {
        law: |piece: usize, s: f64, _: f64| legs.get(piece).map_or(0.0, |[from, f, w2]| f - w2 * (s - from)),
        presses: &|_, _| f64::NAN,
        switches: &switches,
        u0,
        pace: pace(farthest, legs.iter().fold(0.0, |most, leg| f64::max(most, leg[1].abs())), u0),
        time: &|| travel.at(T::of(farthest)).time.f64(),
    };
    let list: Vec<(Event, f64)> = events.iter().map(|e| (e.0, e.1)).collect();
    let (states, count) = route.states(&list, rung)?;
    let of = |kind: usize| {
        let i = events.iter().position(|e| e.2 == kind)?;
        states.get(i).map(|s| State { s: T::of(s.s), u: T::of(s.u), time: T::of(s.time) })
    };
    Ok(Path { end: of(END), fastest: of(FASTEST), turning: of(TURNING), count })
}
