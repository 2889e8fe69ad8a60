//! The order in which joined bodies can be placed: which one leads, and how each other one hangs on those before it.
use crate::num::Real;
use crate::num::half::Half;
use crate::scene::pose::{
    Arc, Guided, Held, Hung, Known, Layout, Line, MET, Pose, Step, Steps, Track, axis, direction, dot,
    from_origin, ground, left, less, of_spot, off, parallel, plus, times,
};
use crate::scene::{Branch, JointKind, Place, Planar, Spot, Straight, Surface, pose};
use smallvec::{SmallVec, smallvec};

/// Where a body lies by default, and the other side.
const SIDES: [f64; 2] = [1.0, -1.0];

/// 1 where a body lies on the side where it lies by default, else -1.
fn branch(side: Option<Branch>) -> f64 {
    if side == Some(Branch::Behind) { -1.0 } else { 1.0 }
}

/// Finds the order in which bodies can be placed.
pub struct Planner<'l, 'a, T: Real> {
    pub layout: &'l Layout<'a, T>,
    pub at_start: bool,
    pub placed: SmallVec<[bool; 4]>,
    pub steps: Steps<T>,
}

impl<'l, 'a, T: Real> Planner<'l, 'a, T> {
    pub fn new(layout: &'l Layout<'a, T>, at_start: bool) -> Self {
        Self { layout, at_start, placed: smallvec![false; layout.scene.bodies.len()], steps: Steps::new() }
    }
    pub fn add(&mut self, body: usize, step: Step<T>) {
        for placed in [Some(body), step.partner()].into_iter().flatten() {
            self.placed[placed] = true;
        }
        self.steps.push((body, step));
    }
    fn planar(&self, body: usize) -> Option<&'a Planar> {
        self.layout.scene.bodies[body].planar.as_ref()
    }
    fn spot(&self, spot: Spot) -> [T; 2] {
        of_spot(self.layout.scene, self.layout.n, spot)
    }
    /// Points of a body that are held at a known place.
    pub fn held(&self, body: usize) -> Option<Held<T>> {
        self.layout.scene.joints.iter().find_map(|joint| {
            let known = |spot: Spot| self.placed[spot.body].then(|| Known::Of(spot.body, self.spot(spot)));
            let (own, place) = match joint.kind {
                JointKind::Pin { at, place_m } => (at, Known::Fixed(ground(self.layout.n, place_m))),
                JointKind::Hinge { one, other, .. } if one.body == body => (one, known(other)?),
                JointKind::Hinge { one, other, .. } if other.body == body => (other, known(one)?),
                _ => return None,
            };
            (own.body == body).then(|| Held { at: self.spot(own), place })
        })
    }
    /// Points of a body that are guided, itself or by what is hinged there.
    fn guided(&self, body: usize) -> impl Iterator<Item = Guided<T>> {
        let joints = self.layout.scene.joints.iter().zip(&self.layout.lines).enumerate();
        joints.filter_map(move |(j, (joint, unit))| {
            let (at, through) = match (joint.kind, joint.kind.surface()) {
                (JointKind::Cord { at, place_m, beyond: None, .. }, _) if !self.at_start => {
                    (at, ground(self.layout.n, place_m))
                }
                // The centre of a wheel is a radius off the line. One that another body carries has no place yet.
                (_, Some((at, radius_m, Surface::Line(Straight { on: None, through_m, .. })))) => {
                    let ([x, y], radius) = (ground(self.layout.n, through_m), self.layout.n.get(radius_m));
                    (at, [x - unit[1] * radius, y + unit[0] * radius])
                }
                (JointKind::Contact { rolls: false, .. }, Some((at, _, Surface::Arc { centre_m, .. }))) => {
                    (at, ground(self.layout.n, centre_m))
                }
                _ => return None,
            };
            let own = if at.body == body { Some(at) } else { self.slider(at, body) }?;
            let ring = self.layout.apart(j);
            let reversed = matches!(joint.kind, JointKind::Guide { reversed: true, .. });
            let unit = if reversed { unit.map(|x| -x) } else { *unit };
            Some(Guided { at: self.spot(own), through, unit, ring })
        })
    }
    /// The point of `body` that is hinged to a slider, a body that does not turn, or to a wheel at the point that is guided.
    fn slider(&self, guided: Spot, body: usize) -> Option<Spot> {
        if self.placed[guided.body] {
            return None;
        }
        let slides = |spot: Spot| {
            spot == guided || spot.body == guided.body && !self.layout.scene.bodies[spot.body].turns
        };
        self.layout.scene.joints.iter().find_map(|joint| match joint.kind {
            JointKind::Hinge { one, other, turned_deg: None } if one.body == body && slides(other) => {
                Some(one)
            }
            JointKind::Hinge { one, other, turned_deg: None } if other.body == body && slides(one) => {
                Some(other)
            }
            _ => None,
        })
    }

    /// A line on which a body rolls, and on which this place lies: it is fixed, or a body carries it that has a place and does not turn.
    fn rolls(&self, body: usize) -> impl Iterator<Item = Track<T>> {
        let layout = self.layout;
        layout.scene.joints.iter().enumerate().filter_map(move |(joint, j)| {
            let (at, radius, Surface::Line(line)) = j.kind.surface()? else { return None };
            let (through, unit, with) = self.line(joint, line)?;
            let rolls = at.body == body && j.kind.rolls()[0] && with.is_none();
            let (at, radius) = (self.spot(at), layout.n.get(radius));
            rolls.then_some(Track { joint, at, through, unit, radius })
        })
    }
    /// A point of a body that has a place.
    fn of(&self, spot: Spot) -> Option<Known<T>> {
        self.placed[spot.body].then(|| Known::Of(spot.body, self.spot(spot)))
    }
    /// The direction of an axis that does not turn.
    fn still(&self, body: usize) -> Option<[T; 2]> {
        let planar = self.planar(body)?;
        (!self.layout.scene.bodies[body].turns).then(|| planar.from.components().map(T::of))
    }
    /// A place on a line, its direction, and the body that carries it, if that turns; `None` if it has no place.
    fn line(&self, joint: usize, line: Straight) -> Option<(Known<T>, [T; 2], Option<usize>)> {
        let unit = self.layout.lines[joint];
        let Some(on) = line.on else {
            return Some((Known::Fixed(ground(self.layout.n, line.through_m)), unit, None));
        };
        let through = self.of(on)?;
        Some(match self.still(on.body) {
            Some(axis) => (through, from_origin(axis, unit), None),
            None => (through, unit, Some(on.body)),
        })
    }

    /// Two lines on which the origin of a body lies that does not turn, or on which the centre of a wheel does.
    fn crossing(&self, body: usize) -> Option<[Line<T>; 2]> {
        let (layout, zero) = (self.layout, [T::zero(); 2]);
        let origin = self.still(body);
        let mut lines: SmallVec<[Line<T>; 4]> = SmallVec::new();
        for (joint, j) in layout.scene.joints.iter().enumerate() {
            let Some((at, radius, Surface::Line(line))) = j.kind.surface() else { continue };
            let ([rolls, teeth], radius) = (j.kind.rolls(), layout.n.get(radius));
            if at.body == body && !teeth {
                // Its point is a radius to the left of the line.
                let Some((through, unit, with)) = self.line(joint, line) else { continue };
                let own = origin.map_or(zero, |axis| from_origin(axis, self.spot(at)));
                let normal = left(unit);
                let to = [(normal, through), (zero, through)];
                lines.push(Line { normal, own, to, far: radius, turn: T::zero(), with });
            } else if let Some(on) = line.on.filter(|on| on.body == body)
                && let (Some(axis), Some(known)) = (origin, self.of(at))
            {
                let (own, unit) = (from_origin(axis, self.spot(on)), from_origin(axis, layout.lines[joint]));
                let line = |normal, far, turn| {
                    let to = [(normal, known), (zero, known)];
                    Line { normal, own, to, far, turn, with: None }
                };
                if !teeth {
                    lines.push(line(left(unit), -radius, T::zero()));
                }
                if rolls && at.body == layout.lead {
                    // It goes ahead of a wheel that turns to the left.
                    lines.push(line(unit, -layout.starts[joint], radius * self.turn()?));
                }
            }
        }
        // A wheel between two lines turns as far on the one as on the other.
        let mut tracks = self.rolls(body);
        if let (Some(one), Some(other)) = (tracks.next(), tracks.next()) {
            let per = [&one, &other].map(|track| T::of(1.0) / track.radius);
            let [ahead, back] = [times(one.unit, per[0]), times(other.unit, -per[1])];
            let far = layout.starts[one.joint] * per[0] - layout.starts[other.joint] * per[1];
            let normal = [ahead[0] + back[0], ahead[1] + back[1]];
            let to = [(ahead, one.through), (back, other.through)];
            lines.push(Line { normal, own: zero, to, far, turn: T::zero(), with: None });
        }
        lines.iter().enumerate().find_map(|(i, one)| {
            let meets =
                |o: &&Line<T>| one.with.is_some() || o.with.is_some() || !parallel(one.normal, o.normal);
            lines[i + 1..].iter().find(meets).map(|other| [*one, *other])
        })
    }
    /// How far the leading body turns to the left on its way.
    fn turn(&self) -> Option<T> {
        Some(self.layout.ratio().signed(self.layout.scene.sense(self.layout.lead)))
    }

    /// Where the axis of a body begins at the start, if that is told.
    fn placed(&self, body: usize) -> Option<[T; 2]> {
        Some(ground(self.layout.n, self.planar(body)?.origin_m?))
    }
    /// Direction of the axis of a body at the start, if that is told.
    fn started(&self, body: usize) -> Option<[T; 2]> {
        let told = || {
            let planar = self.planar(body)?;
            Some(axis(planar, &Half::of_degrees(self.layout.n.get(planar.start_deg?))))
        };
        self.still(body).or_else(told)
    }
    /// A point of a body that is hinged to another one of which is told where it is at the start, and where that point is.
    fn beside_placed(&self, body: usize) -> Option<([T; 2], [T; 2])> {
        self.layout.scene.joints.iter().find_map(|joint| {
            let JointKind::Hinge { one, other, .. } = joint.kind else { return None };
            let (own, to) = if one.body == body { (one, other) } else { (other, one) };
            let (origin, at) = (self.placed(to.body)?, self.spot(to));
            // Where it begins, its axis may have any direction.
            let begins = self.planar(to.body)?.points[to.point].1 == [Place::default(); 2];
            let off = if begins { at } else { from_origin(self.started(to.body)?, at) };
            (own.body == body).then(|| (self.spot(own), plus(origin, off)))
        })
    }

    pub fn lead(&mut self) -> Option<()> {
        let (layout, body) = (self.layout, self.layout.lead);
        let planar = self.planar(body)?;
        let held = self.held(body);
        let (one, other) = {
            let mut guides = self.guided(body);
            (guides.next(), guides.next())
        };
        let turned = |[ahead, aside]: [T; 2]| {
            let [c, s] = axis(planar, &layout.start);
            [c * ahead - s * aside, s * ahead + c * aside]
        };
        let origin = self.placed(body).or_else(|| {
            // Guides that are parallel leave open where along them it is: nothing hangs on that.
            let one = one.as_ref().filter(|one| other.as_ref().is_some_and(|o| parallel(one.unit, o.unit)));
            let beside = one.map(|one| (one.at, one.through));
            let (at, place) = beside.or_else(|| self.beside_placed(body))?;
            Some(less(place, turned(at)))
        });
        let from = |through, unit| origin.map_or_else(T::zero, |place| dot(less(place, through), unit));
        let step = if let Some(arc) = &layout.arc {
            let JointKind::Contact { at, .. } = layout.scene.joints[arc.joint].kind else { return None };
            Step::Arc(self.spot(at))
        } else if let (Some(track), None) = (self.rolls(body).next(), held)
            && let Known::Fixed(through) = track.through
        {
            // Where it is told where its axis begins, its centre is so far ahead of that.
            let ahead = origin.map_or_else(T::zero, |_| dot(turned(track.at), track.unit));
            Step::Wheel(track, from(through, track.unit) + ahead)
        } else {
            match (held, one, other, origin) {
                (Some(held), ..) => Step::Leads(held),
                (None, _, _, Some(place)) if let Some((unit, bend)) = layout.glide => {
                    Step::Glides(place, unit, bend)
                }
                (None, Some(one), Some(other), _)
                    if one.ring.is_some() || other.ring.is_some() || !parallel(one.unit, other.unit) =>
                {
                    self.sided(body, SIDES.map(|side| Step::Slides([one, other], side)))?
                }
                (None, Some(guide), None, _)
                    if guide.ring.is_none() && (self.at_start || layout.scene.drifts().is_some()) =>
                {
                    // Nothing moves the mass centre along the line.
                    let centre = pose::along(layout.n, planar.centre);
                    // Where it is told where its axis begins, its mass centre is so far ahead of that.
                    let ahead = dot(axis(planar, &layout.start), guide.unit) * centre;
                    let ahead = if origin.is_some() { ahead } else { T::zero() };
                    Step::Drops(guide, centre, from(guide.through, guide.unit) + ahead)
                }
                (None, _, _, Some(place)) if self.at_start => {
                    Step::Leads(Held { at: [T::zero(); 2], place: Known::Fixed(place) })
                }
                _ => return None,
            }
        };
        self.add(body, step);
        Some(())
    }

    /// How far a gear turns per turn of the leading body, which is pinned at the axis of the fixed gear with which it meshes and carries
    /// its centre.
    fn orbits(&self, body: usize, held: &Held<T>) -> Option<T> {
        let layout = self.layout;
        let lead = |spot: &Spot| spot.body == layout.lead;
        let arc = (0..layout.scene.joints.len()).find_map(|joint| {
            let own = layout.scene.joints[joint].kind.spots().next().filter(|at| at.body == body)?;
            let [along, aside] = self.spot(own);
            let at = along.same(held.at[0]) && aside.same(held.at[1]);
            let meshes = matches!(layout.scene.joints[joint].kind, JointKind::Contact { teeth: true, .. });
            Arc::of(layout.scene, layout.n, joint).filter(|_| at && meshes)
        })?;
        let pinned = layout.scene.joints.iter().any(|joint| match joint.kind {
            JointKind::Pin { at, place_m } if lead(&at) => {
                off(ground(layout.n, place_m), arc.axis) <= MET * arc.apart.size()
            }
            _ => false,
        });
        let carried = matches!(held.place, Known::Of(by, _) if by == layout.lead);
        (pinned && carried && layout.arc.is_none()).then_some(arc.ratio)
    }

    /// How a body is placed, of two ways the one that is meant; where cords or light rods guide, that in which it is at the start.
    fn sided(&self, body: usize, steps: [Step<T>; 2]) -> Option<Step<T>> {
        let mut meant = usize::from(branch(self.planar(body)?.side) < 0.0);
        if let Some(first) = self.layout.first.as_ref().filter(|_| !self.at_start) {
            let gaps = steps.map(|step| {
                let pose = self.layout.place(T::zero(), &step, &mut first.clone());
                let near =
                    |pose: Pose<T>| off(pose.origin, first[body].origin) + off(pose.axis, first[body].axis);
                pose.map_or(f64::NAN, near)
            });
            meant ^= usize::from(gaps[1 - meant] < gaps[meant]);
        }
        Some(steps[meant])
    }

    /// How a body is placed that is welded to one that has a place.
    fn welded(&self, body: usize) -> Option<Step<T>> {
        self.layout.scene.joints.iter().find_map(|joint| {
            let JointKind::Hinge { one, other, turned_deg: Some(turned) } = joint.kind else { return None };
            let (own, to, sense) = if one.body == body { (one, other, -1.0) } else { (other, one, 1.0) };
            if own.body != body || !self.placed[to.body] {
                return None;
            }
            let [c, s] = direction(self.layout.n, turned);
            let held = Held { at: self.spot(own), place: Known::Of(to.body, self.spot(to)) };
            Some(Step::Welded(held, to.body, [c, s.signed(sense)]))
        })
    }

    /// How a body is placed on a line of which a body slides or rolls that has a place.
    fn slotted(&self, body: usize, held: Held<T>) -> Option<Step<T>> {
        self.layout.scene.joints.iter().zip(&self.layout.lines).find_map(|(joint, unit)| {
            let (at, radius, Surface::Line(line)) = joint.kind.surface()? else { return None };
            let on = line.on.filter(|on| on.body == body && self.placed[at.body])?;
            let aside = dot(left(*unit), less(self.spot(on), held.at)) + self.layout.n.get(radius);
            let through = Known::Of(at.body, self.spot(at));
            self.sided(body, SIDES.map(|side| Step::Slot(held, through, (*unit, aside), side)))
        })
    }

    /// How a body that does not turn is placed on its guide by a cord that leads to it from one that has a place.
    fn hung(&self, body: usize, axis: [T; 2]) -> Option<Step<T>> {
        let layout = self.layout;
        let first = layout.first.as_ref().filter(|_| !self.at_start)?;
        let guide = self.guided(body).find(|guide| guide.ring.is_none())?;
        layout.scene.joints.iter().enumerate().find_map(|(joint, j)| {
            let JointKind::Cord { at, place_m, beyond: Some(beyond), .. } = j.kind else { return None };
            let ends = [(at, place_m), beyond];
            let own = ends.iter().position(|(spot, _)| spot.body == body)?;
            let ((spot, over_m), other) = (ends[own], ends[1 - own]);
            if !self.placed[other.0.body] {
                return None;
            }
            let (at, over) = (self.spot(spot), pose::ground(layout.n, over_m));
            let through = plus(guide.through, from_origin(axis, less(at, guide.at)));
            let foot = pose::foot(over, through, guide.unit);
            let way = dot(less(first[body].point(at), foot), guide.unit);
            // At its pulley it could hang to either side.
            if way.is_nothing() {
                return None;
            }
            let hung = Hung {
                at,
                foot,
                off: dot(left(guide.unit), less(over, through)),
                unit: guide.unit.map(|x| x.signed(way.sign())),
                joint,
                other,
            };
            Some(Step::Hangs(axis, hung))
        })
    }

    /// How a body is placed beside those that have a place, if its joints do.
    pub fn follow(&self, body: usize) -> Option<Step<T>> {
        let planar = self.planar(body)?;
        let scene = self.layout.scene;
        if let Some(step) = self.welded(body) {
            return Some(step);
        }
        let held = self.held(body);
        let place = || self.placed(body).filter(|_| self.at_start);
        let placed = || Some(Held { at: [T::zero(); 2], place: Known::Fixed(place()?) });
        if let Some(axis) = self.still(body) {
            let still = held.or_else(placed).map(|held| Step::Still(held, axis));
            let hung = || still.or_else(|| self.hung(body, axis));
            return hung().or_else(|| Some(Step::Crosses([T::zero(); 2], self.crossing(body)?, None, axis)));
        }
        if self.at_start
            && let Some(start) = self.started(body)
        {
            // What leads elsewhere moves it: its own angle is known at the start alone.
            return Some(Step::Still(held.or_else(placed)?, start));
        }
        let start = || self.started(body).unwrap_or_else(|| axis(planar, &Half::of_degrees(T::zero())));
        if let Some(track) = self.rolls(body).next() {
            let central = |held: &Held<T>| off(track.at, held.at) == 0.0;
            // From where it rolls is not known before what holds it has its place at the start.
            match held.or_else(placed).filter(central) {
                Some(held) if self.at_start => return Some(Step::Still(held, start())),
                Some(held) => return Some(Step::Rolls(held, track, start())),
                None if self.at_start || held.is_some() => {}
                None => return Some(Step::Crosses(track.at, self.crossing(body)?, Some(track), start())),
            }
        }
        let held = held?;
        if let Some(ratio) = self.orbits(body, &held) {
            return Some(Step::Orbits(held, ratio, start()));
        }
        if let Some(guide) = self.guided(body).next() {
            return self.sided(body, SIDES.map(|side| Step::Rod(held, guide, side)));
        }
        if let Some(step) = self.slotted(body, held) {
            return Some(step);
        }
        // The other rod of the pair, where both are hinged, and where that one is held.
        scene.joints.iter().find_map(|joint| {
            let JointKind::Hinge { one, other, turned_deg: None } = joint.kind else { return None };
            let (own, other) = if one.body == body { (one, other) } else { (other, one) };
            if own.body != body || self.placed[other.body] || !scene.bodies[other.body].turns {
                return None;
            }
            let far = self.held(other.body)?;
            let beyond = |spot: Spot, from: [T; 2]| {
                let [along, aside] = self.spot(spot);
                [along - from[0], aside - from[1]]
            };
            let apart = [beyond(own, held.at), beyond(other, far.at)];
            let side = branch(planar.side.or(self.planar(other.body)?.side));
            // Sides are told from the rod that is written first, which need not be the one that is reached first.
            let side = if other.body < body { -side } else { side };
            Some(Step::Pair(held, other.body, far, apart, side))
        })
    }
}
