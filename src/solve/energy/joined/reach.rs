//! How far joined bodies go: to a turning point, to a time, until they lose touch.
use crate::num::dd::pow2;
use crate::num::half::Half;
use crate::num::plant::plant;
use crate::num::{Dd, Real, ball, gauss, root, trig};
use crate::scene::End;
use crate::solve::energy::joined::{Account, At, Poses, STEP, STRETCHED, WIDTHS, decided, least};
use crate::solve::outcome::{Lacks, Refusal};

impl<T: Real> Account<'_, T> {
    /// The first place before `far` at which `value`, which sets off above 0 (or `rising` below it), no longer is there, however
    /// shortly.
    pub fn first(
        &self,
        far: T,
        rising: bool,
        value: &dyn Fn(T) -> Result<T, Refusal>,
    ) -> Result<Option<T>, Refusal> {
        ball::unwatched(|| {
            let mut sure = true;
            // What sets off from rest beside a balance may turn in the first hair of the way.
            let first =
                f64::min(self.stride, if value(T::zero())?.is_zero() { STEP / 32.0 } else { self.widest });
            let stops = self.meets.iter().copied().filter(|x| x.below(far)).chain([far]);
            let mut told = |now| sure &= decided(now);
            let Some([from, to]) =
                root::leaves(stops, [first, self.widest, STRETCHED], rising, value, &mut told)?
            else {
                return Ok(None);
            };
            Self::around(root::between_values(from, to, rising, value)?, sure, value).map(Some)
        })
    }

    /// Of numbers that enclose, a root with the width within which the value is shown to change its sign; endless without one, and
    /// where the sign before it is not sure.
    pub fn around(root: T, sure: bool, value: &dyn Fn(T) -> Result<T, Refusal>) -> Result<T, Refusal> {
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
    pub fn stays_in_touch(&self, far: T, from: (&Poses<T>, T)) -> Result<bool, Refusal> {
        // An enclosure is of a motion that both roads have followed.
        if T::ENCLOSES {
            return Ok(true);
        }
        let turns = |joint| Err(Refusal::Friction(joint, Lacks::Lasting));
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
                return if pushes { Ok(false) } else { turns(j) };
            }
        }
        let mut at = if self.scene.joints.iter().any(|j| j.kind.rubs().is_some()) { T::zero() } else { far };
        while at.below(far) {
            let next = at + T::of(self.widest);
            at = if next.below(far) { next } else { far };
            let poses = self.poses(at)?;
            let motion = self.rates(&poses).iter().map(|r| r.map(|x| x.signed(self.sense))).collect();
            let now = self.sliding(&poses, &motion);
            if let Some(joint) = now.iter().zip(&self.slides).position(|(now, before)| now - before != 0.0) {
                return turns(joint);
            }
        }
        Ok(true)
    }

    /// Time to a place, where it rests or not: in an angle whose cosine is the place.
    pub fn time(&self, place: &At<T>, from: (&Poses<T>, T), rest: bool) -> Result<T, Refusal> {
        let way = place.0;
        if way.is_zero() {
            return Ok(T::zero());
        }
        if let Some(pendulum) = &self.pendulum {
            let speed =
                if rest { T::zero() } else { self.half_square_at(place, None, from)?.scale2(1).root() };
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
        let (rule, mut time, mut angle) = (gauss::long::<T>().0, T::zero(), T::zero());
        for met in self.meets.iter().filter(|x| x.below(way)).map(|x| *x / way) {
            let next = trig::angle(met.root(), (T::of(1.0) - met).root()).scale2(1);
            time = time + rule.integral(slowness, (angle, next), 0.0)?;
            angle = next;
        }
        let time = time + rule.integral(slowness, (angle, T::constant(Dd::PI)), 0.0)?;
        Ok(plant!("energy: time of joined bodies", time))
    }

    /// The leading angle at a place.
    pub fn angle(&self, (way, angle): &At<T>) -> Half<T> {
        let start = || self.scene.start_angle(self.n);
        angle.unwrap_or_else(|| start().plus(Half::of_radians(way.signed(self.sense))))
    }

    /// Where it comes to rest within a way.
    pub fn turning(&self, far: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        match &self.pendulum {
            Some(pendulum) => Ok(pendulum.turning().map(|(way, _)| way).filter(|way| way.at_most(far))),
            None => self.first(far, false, &|way| Ok(self.there(way, from)?.half_square)),
        }
    }

    /// The way to the end within `far`, if it gets there before it comes to rest.
    pub fn reached(&self, far: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        // What is met beyond the turning point is not met.
        let before_rest = |found: Option<T>| match found {
            // An enclosure is of a motion that both roads have followed, save where it is searched for.
            Some(way) if T::ENCLOSES && self.scene.formulas.found.is_none() => Ok(Some(way)),
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
    pub fn after(&self, t: T, far: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        if self.proves() && self.pendulum.is_none() {
            return Ok(None);
        }
        // It is looked at in ever longer ways: what lies beyond the end may be rough.
        let mut limit = if self.pendulum.is_some() { far } else { least(T::of(self.widest), &far) };
        let (rest, most) = loop {
            let rest = self.turning(limit, from)?;
            let most = self.time(&(rest.unwrap_or(limit), None), from, rest.is_some())?;
            if rest.is_some() || t.below(most) || !limit.below(far) {
                break (rest, most);
            }
            limit = least(limit.scale2(2), &far);
        };
        let limit = rest.unwrap_or(limit);
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
    pub fn proves(&self) -> bool {
        T::of(1.0).widened(|| f64::INFINITY).radius() > 0.0
    }
}
