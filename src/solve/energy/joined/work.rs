//! What forces do over a way of joined bodies, and the rate that it leaves them with.
use crate::num::gauss::{PerNode, Unsettled};
use crate::num::plant::plant;
use crate::num::{Real, gauss};
use crate::scene::pose::{Pose, dot};
use crate::scene::{Acts, Spot, StrutEnd, pose};
use crate::solve::energy::joined::{
    Account, At, Between, Motion, Poses, SMOOTH, Seen, Stretch, TURNS_OF_ITERATION, Vector, least,
};
use crate::solve::outcome::Refusal;
use smallvec::{SmallVec, smallvec};
use std::rc::Rc;

impl<T: Real> Account<'_, T> {
    /// Twice the kinetic energy at unit rate of the leading angle.
    pub fn inertia(&self, poses: &Poses<T>) -> T {
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
    pub fn powers(&self, poses: &Poses<T>, motion: &Motion<T>, blows: bool) -> SmallVec<[T; 6]> {
        let mut powers: SmallVec<[T; 6]> = SmallVec::new();
        if blows {
            powers.extend(self.pushed(poses, motion, true));
            powers.extend(self.brought(poses, motion));
            return powers;
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
    pub fn pushed(&self, poses: &Poses<T>, motion: &Motion<T>, blows: bool) -> impl Iterator<Item = T> {
        let pushes = self.scene.pushes.iter().enumerate().filter(move |(_, push)| push.blow == blows);
        pushes.map(move |(i, push)| {
            let u = self.layout.push(poses, i);
            let p = plant!("energy: power of a force on a point", self.n.massive(push.force_n));
            p * dot(u, self.of_spot(poses, motion, push.at))
        })
    }

    /// What the momenta before an impact, those of equimomental particles, come to in a motion.
    fn brought(&self, poses: &Poses<T>, motion: &Motion<T>) -> impl Iterator<Item = T> {
        let before = self.before(poses);
        self.scene.arrivals().flat_map(move |(b, _)| {
            let (centre, gyration) = self.centres[b];
            [centre + gyration, centre - gyration].map(|along| {
                let half = plant!("energy: momentum before an impact", self.n.bodies[b].mass.scale2(-1));
                half * dot(self.velocity(poses, &before, b, along), self.velocity(poses, motion, b, along))
            })
        })
    }
    /// The motion just before an impact.
    pub fn before(&self, poses: &Poses<T>) -> Motion<T> {
        let mut before: Motion<T> = smallvec![[T::zero(); 3]; self.scene.bodies.len()];
        for (b, arrives) in self.scene.arrivals() {
            before[b][2] = self.n.get(arrives.spin_rad_s).signed(self.scene.sense(b));
            // The origin of its axis moves so that the point about which it turns does not, or its mass centre as it is told to.
            let turned = match self.scene.turns_about((b, arrives)) {
                Some(pin) => self.of_spot(poses, &before, pin),
                None => self.velocity(poses, &before, b, self.centres[b].0),
            };
            let unit = pose::direction(self.n, arrives.direction_deg);
            for i in [0, 1] {
                before[b][i] = (unit[i] * self.n.get(arrives.speed_m_s)).balance(-turned[i]);
            }
        }
        before
    }

    /// Powers of forces, couples and springs.
    pub fn applied(&self, poses: &Poses<T>, motion: &Motion<T>) -> SmallVec<[T; 6]> {
        let mut powers: SmallVec<[T; 6]> = self.pushed(poses, motion, false).collect();
        powers.extend(self.of_drive(motion));
        powers.extend(self.of_couples(motion).map(|(_, power)| power));
        for (s, (strut, natural)) in self.scene.struts.iter().zip(&self.layout.natural).enumerate() {
            let length = self.layout.length(poses, s).value;
            if strut.acts != Acts::Both && !self.bears(s, length) {
                continue;
            }
            let moves = match strut.to {
                StrutEnd::Twist => {
                    let turn = motion[strut.at.body][2].signed(self.scene.sense(strut.at.body));
                    let stiffness =
                        plant!("energy: power of a torsion spring", self.n.massive(strut.stiffness_n_m));
                    powers.push(-(stiffness * length * turn));
                    continue;
                }
                StrutEnd::Spot(spot) => self.of_spot(poses, motion, spot),
                // On a guide it moves across the spring.
                StrutEnd::Ground(_) | StrutEnd::Guide { .. } => [T::zero(); 2],
            };
            let apart = self.layout.span(poses, s).map(|x| x.value);
            let v = self.of_spot(poses, motion, strut.at);
            let longer = dot(apart, [moves[0] - v[0], moves[1] - v[1]]);
            let stiffness =
                plant!("energy: power of a spring in the plane", self.n.massive(strut.stiffness_n_m));
            let slope = if natural.is_zero() { stiffness } else { stiffness * (length - *natural) / length };
            powers.push(-(slope * longer));
        }
        powers
    }

    /// The power of the couple that drives the leading body.
    pub fn of_drive(&self, motion: &Motion<T>) -> Option<T> {
        self.drive.get().map(|moment| moment * motion[self.lead][2])
    }
    /// The powers of couples, each with its body.
    pub fn of_couples(&self, motion: &Motion<T>) -> impl Iterator<Item = (usize, T)> {
        self.scene.couples.iter().map(move |c| {
            let moment = plant!("energy: power of a couple in the plane", self.n.massive(c.moment_n_m));
            let turn = motion[c.body][2].signed(self.scene.sense(c.body));
            (c.body, moment * c.signed(turn))
        })
    }

    /// Does a spring of this length press, or pull, where it can do but one of them?
    pub fn bears(&self, s: usize, length: T) -> bool {
        self.layout.acts(s, length.balance(-self.layout.natural[s]))
    }

    /// Work of all forces between two places, so far apart.
    pub fn work(&self, places: &Between<T>, way: T) -> Result<T, Refusal> {
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
        for (i, push) in self.scene.pushes.iter().enumerate().filter(|(_, push)| !push.blow) {
            let p = plant!("energy: work of a force on a point", self.n.massive(push.force_n));
            if let Some(place) = push.toward_m {
                let [a, b] = [from, to].map(|poses| self.layout.distance(poses, push.at, place).value);
                add(p * (a - b));
            } else if push.turns {
                let power = |at: T| {
                    let poses = self.poses(at)?;
                    let v = self.point(&poses, push.at).map(|x| x.first.signed(self.sense));
                    Ok::<_, Refusal>(dot(self.layout.push(&poses, i), v))
                };
                let terms = pose::size(self.scene, self.n);
                add(p * gauss::short().integral(power, (T::zero(), way), terms)?);
            } else {
                add(p * dot(self.layout.push(from, i), self.shift(places, push.at)));
            }
        }
        for c in &self.scene.couples {
            let turned = if c.body == self.lead && self.layout.arc().is_none() {
                way.signed(self.sense)
            } else {
                let rate = |at: T| Ok::<_, Refusal>(self.poses(at)?[c.body].turn().0.signed(self.sense));
                // A body that only moves turns by rounding alone, beside the one that leads.
                gauss::short().integral(rate, (T::zero(), way), 1.0)?.signed(self.scene.sense(c.body))
            };
            let moment = plant!("energy: work of a couple in the plane", self.n.massive(c.moment_n_m));
            add(moment * c.signed(turned));
        }
        for (s, strut) in self.scene.struts.iter().enumerate() {
            let stiffness =
                plant!("energy: work of a spring in the plane", self.n.massive(strut.stiffness_n_m));
            add((stiffness * self.released(s, places)).scale2(-1));
        }
        Ok(work.cleared(size))
    }

    /// How far a point has moved.
    pub fn shift(&self, places: &Between<T>, spot: Spot) -> Vector<T> {
        places.shift(spot.body, pose::of_spot(self.scene, self.n, spot))
    }

    /// By how much the square of the stretch of a spring has shrunk, as `(x0 - x1)(x0 + x1)`; the difference of two lengths is that
    /// of their squares over their sum.
    pub fn released(&self, s: usize, places: &Between<T>) -> T {
        let (strut, natural) = (&self.scene.struts[s], self.layout.natural[s]);
        let ends = [places.from, places.to];
        let lengths = ends.map(|poses| self.layout.length(poses, s).value);
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
                let [first, last] = ends.map(|poses| self.layout.span(poses, s).map(|x| x.value));
                let change = [near[0] - far[0], near[1] - far[1]];
                dot(change, [first[0] + last[0], first[1] + last[1]]) / (a + b)
            }
            None => a - b,
        };
        shorter * ((a - natural) + (b - natural))
    }

    /// Half the square of the rate after a way, from that at the start; `first` is where everything is there.
    pub fn half_square(&self, way: T, start: (&Poses<T>, T)) -> Result<T, Refusal> {
        self.half_square_at(&(way, None), None, start)
    }
    /// The same at a place, where everything there may be known.
    pub fn half_square_at(
        &self,
        place: &At<T>,
        known: Option<&Poses<T>>,
        (first, from): (&Poses<T>, T),
    ) -> Result<T, Refusal> {
        if self.is_rubbed() {
            return self.collocated(place.0, from);
        }
        let own;
        let poses = match known {
            Some(poses) => poses,
            None => {
                own = self.at(place)?;
                &own
            }
        };
        let kinetic = if from.is_zero() { from } else { self.inertia(first) * from };
        let work = self.work(&self.between(first, poses, place), place.0)?;
        Ok(kinetic.balance(work) / self.inertia(poses))
    }
    pub fn is_rubbed(&self) -> bool {
        self.rubs.iter().any(|s| *s != 0.0)
    }
    /// A place at which an event is looked for.
    pub fn there(&self, way: T, from: (&Poses<T>, T)) -> Result<Rc<Seen<T>>, Refusal> {
        if let Some(seen) = self.seen.borrow().iter().find(|seen| seen.way.same(way)) {
            return Ok(Rc::clone(seen));
        }
        let poses = self.poses(way)?;
        let half_square = self.half_square_at(&(way, None), Some(&poses), from)?;
        let seen = Rc::new(Seen { way, poses, half_square });
        self.seen.borrow_mut().push(Rc::clone(&seen));
        Ok(seen)
    }
    /// [`Self::normal`] there.
    pub fn normal_there(&self, joint: usize, way: T, from: (&Poses<T>, T)) -> Result<Option<T>, Refusal> {
        let seen = self.there(way, from)?;
        self.normal(&seen.poses, seen.half_square.scale2(1), joint)
    }

    /// The same where guides rub: the balance of virtual motions, `dy/dq = (force - 2 bend y) / inertia`, by collocation.
    pub fn collocated(&self, way: T, from: T) -> Result<T, Refusal> {
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
            let mut next =
                self.meets.iter().filter(|x| at.below(**x)).fold(at + T::of(8.0 * self.widest), least);
            let stretch = (0..=gauss::HALVINGS).find_map(|_| {
                let stretch = self.collocate((at, next), square).transpose();
                next = (at + next).scale2(-1);
                stretch
            });
            let unsettled = || Unsettled { value: square.f64(), gap: f64::INFINITY }.into();
            solved.push(stretch.unwrap_or_else(|| Err(unsettled()))?);
        }
        let within = solved.iter().find(|s| way.at_most(s.ends.1));
        Ok(within.map_or(from, |Stretch { ends: (a, b), squares: (start, _), gains }| {
            *start + gauss::short().at(gains, (way - *a) / (*b - *a)) * (way - *a)
        }))
    }

    /// One panel of the collocation; `None` if it is too long.
    pub fn collocate(&self, ends: (T, T), from: T) -> Result<Option<Stretch<T>>, Refusal> {
        let (width, rule) = (ends.1 - ends.0, gauss::short());
        let (mut forces, mut bends) = (PerNode::new(), PerNode::new());
        for node in &rule.nodes {
            let poses = self.poses(ends.0 + width * T::constant(*node))?;
            let balance = self.balance(&poses, &self.across_friction(&poses)?)?;
            let per = width.signed(self.sense) / balance.inertia;
            forces.push(balance.force * per);
            bends.push((balance.bend * per).scale2(1));
        }
        let share = SMOOTH[usize::from(T::is_double())];
        // Bends are exponents: beside 1 they count, and in a translation rounding is all that is left of them.
        if rule.rough(&forces, share, 0.0).max(rule.rough(&bends, share, 1.0)) > 1.0 {
            return Ok(None);
        }
        // Each turn of the iteration gains a power of the length of the panel over its factorial.
        let mut squares: PerNode<T> = vec![from; gauss::NODES];
        for _ in 0..TURNS_OF_ITERATION {
            let rates = forces.iter().zip(&bends).zip(&squares).map(|((f, b), y)| *f - *b * *y);
            let rates: PerNode<T> = rates.collect();
            let gained = rule.running(&rates);
            let next: PerNode<T> = gained.iter().map(|g| from + *g).collect();
            let size = next.iter().map(|y| y.size()).fold(0.0, f64::max);
            let change = next.iter().zip(&squares).map(|(a, b)| (*a - *b).size()).fold(0.0, f64::max);
            squares = next;
            if change <= T::SETTLED * size {
                let gains = gained.iter().zip(&rule.nodes).map(|(g, x)| *g / (width * T::constant(*x)));
                let squares = (from, from + rule.mean(&rates));
                return Ok(Some(Stretch { ends, squares, gains: gains.collect() }));
            }
        }
        Ok(None)
    }
}
