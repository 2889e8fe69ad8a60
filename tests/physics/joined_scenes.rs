//! Mechanisms composed by lot against a judge in full coordinates: three for each body, Newton-Euler with multipliers, moved along in
//! time. It shares no line with the program: no poses, no leading angle, no reading of banks.
use crate::joined_lot::{
    Ending, Far, Hold, Load, Machine, Spot, V2, dot, length, machine, on, plus, quarter, radians, turned,
    unit, yaml,
};
use crate::support;
use rayon::prelude::*;
use slipstick::bank::load;
use slipstick::scene::pose::Obstacle;
use slipstick::scene::{Owner, Quantity};
use slipstick::solve::agree::{prove, solve};
use slipstick::solve::outcome::{Check, CheckKind, Refusal, Solved};
use std::collections::BTreeMap;

/// A condition on velocities, `row . v = 0`, as it stands at a place; `right` is what `row . a` is.
struct Condition {
    row: Vec<f64>,
    right: f64,
    /// Coefficients of its force, per unit: those of the row, and of friction that goes with it.
    force: Vec<f64>,
}

struct Judge<'m> {
    m: &'m Machine,
    n: usize,
}

/// Accelerations, and the force of each condition, positive along its row.
type Answer = (Vec<f64>, Vec<f64>);

impl<'m> Judge<'m> {
    fn new(m: &'m Machine) -> Self {
        Self { m, n: 3 * m.bodies.len() }
    }
    fn arm(&self, q: &[f64], spot: Spot) -> V2 {
        turned(self.m.beside_centre(spot), q[3 * spot.0 + 2])
    }
    fn place(&self, q: &[f64], spot: Spot) -> V2 {
        plus([q[3 * spot.0], q[3 * spot.0 + 1]], 1.0, self.arm(q, spot))
    }
    fn velocity(&self, q: &[f64], v: &[f64], spot: Spot) -> V2 {
        plus([v[3 * spot.0], v[3 * spot.0 + 1]], v[3 * spot.0 + 2], quarter(self.arm(q, spot)))
    }
    /// `along . a` of a point as a row, and what its centripetal part adds to it.
    fn row(&self, q: &[f64], v: &[f64], spot: Spot, along: V2) -> (Vec<f64>, f64) {
        let mut row = vec![0.0; self.n];
        let (arm, b) = (self.arm(q, spot), 3 * spot.0);
        row[b] = along[0];
        row[b + 1] = along[1];
        row[b + 2] = dot(along, quarter(arm));
        (row, -v[b + 2] * v[b + 2] * dot(along, arm))
    }
    /// All conditions, in the order of the joints; friction of rough guides slides in these senses.
    fn conditions(&self, q: &[f64], v: &[f64], senses: &[f64]) -> Vec<Condition> {
        let mut list = Vec::new();
        let mut add = |(row, centripetal): (Vec<f64>, f64), right: f64, force: Option<Vec<f64>>| {
            let force = force.unwrap_or_else(|| row.clone());
            list.push(Condition { row, right: right - centripetal, force });
        };
        for (j, hold) in self.m.holds.iter().enumerate() {
            match *hold {
                Hold::Pin(at, _) => {
                    for e in [[1.0, 0.0], [0.0, 1.0]] {
                        add(self.row(q, v, at, e), 0.0, None);
                    }
                }
                Hold::Hinge(one, other) | Hold::Weld(one, other, _) => {
                    for e in [[1.0, 0.0], [0.0, 1.0]] {
                        let (mut row, a) = self.row(q, v, one, e);
                        let (far, b) = self.row(q, v, other, e);
                        row.iter_mut().zip(&far).for_each(|(x, y)| *x -= y);
                        add((row, a - b), 0.0, None);
                    }
                    if matches!(hold, Hold::Weld(..)) {
                        let mut row = vec![0.0; self.n];
                        (row[3 * one.0 + 2], row[3 * other.0 + 2]) = (1.0, -1.0);
                        add((row, 0.0), 0.0, None);
                    }
                }
                Hold::Guide(at, _, direction, _, mu) => {
                    let u = unit(radians(direction));
                    let normal = self.row(q, v, at, quarter(u));
                    let (rub, _) = self.row(q, v, at, u);
                    let by = mu.unwrap_or(0.0) * senses[j];
                    let force = normal.0.iter().zip(&rub).map(|(n, t)| n - by * t).collect();
                    add(normal, 0.0, Some(force));
                }
                Hold::Cord(at, far, _) => {
                    let apart = plus(far, -1.0, self.place(q, at));
                    let (l, e) = (length(apart), apart.map(|x| x / length(apart)));
                    let across = dot(self.velocity(q, v, at), quarter(e));
                    add(self.row(q, v, at, e), across * across / l, None);
                }
                Hold::Line(at, radius, rolls, _, direction, _) => {
                    let t = unit(radians(direction));
                    let normal = self.row(q, v, at, quarter(t));
                    let force = self.reaction(q, j, senses[j]);
                    add(normal, 0.0, force);
                    if rolls {
                        let (mut row, own) = self.row(q, v, at, t);
                        row[3 * at.0 + 2] += radius;
                        add((row, own), 0.0, None);
                    }
                }
                Hold::Arc(at, radius, rolls, axis, arc, inside, _) => {
                    let out = plus(self.place(q, at), -1.0, axis);
                    let (d, e) = (length(out), out.map(|x| x / length(out)));
                    // The surface pushes outward, or inward; a hoop lies on its peg with the inner side of its top.
                    let normal = if inside { e.map(|x| -x) } else { e };
                    let along = [normal[1], -normal[0]];
                    let speed = dot(self.velocity(q, v, at), along);
                    let bend = if inside { speed * speed / d } else { -speed * speed / d };
                    let force = self.reaction(q, j, senses[j]);
                    add(self.row(q, v, at, normal), bend, force);
                    if rolls {
                        let (mut row, own) = self.row(q, v, at, along);
                        row[3 * at.0 + 2] += if inside && radius > arc { -radius } else { radius };
                        add((row, own), 0.0, None);
                    }
                }
            }
        }
        list
    }
    /// What slides at a surface, what turns under it, where they touch and the normal there.
    fn contact(&self, q: &[f64], joint: usize) -> Option<(usize, Option<usize>, V2, V2)> {
        let (at, radius, under, normal) = match self.m.holds[joint] {
            Hold::Line(at, radius, false, _, direction, _) => {
                (at, radius, None, quarter(unit(radians(direction))))
            }
            Hold::Arc(at, radius, false, axis, _, inside, (_, drum)) => {
                let out = plus(self.place(q, at), -1.0, axis);
                let e = out.map(|x| if inside { -x } else { x } / length(out));
                (at, radius, drum, e)
            }
            _ => return None,
        };
        Some((at.0, under.map(|drum| drum.0), plus(self.place(q, at), -radius, normal), normal))
    }
    /// What a unit of the normal force of a surface does to all bodies, with its friction.
    fn reaction(&self, q: &[f64], joint: usize, sense: f64) -> Option<Vec<f64>> {
        let (body, under, foot, normal) = self.contact(q, joint)?;
        let by = self.m.holds[joint].mu().unwrap_or(0.0) * sense;
        let force = plus(normal, by, quarter(normal));
        let mut row = vec![0.0; self.n];
        for (b, side) in [(Some(body), 1.0), (under, -1.0)] {
            let Some(b) = b.map(|b| 3 * b) else { continue };
            let arm = plus(foot, -1.0, [q[b], q[b + 1]]);
            row[b] = side * force[0];
            row[b + 1] = side * force[1];
            row[b + 2] = side * dot(force, quarter(arm));
        }
        Some(row)
    }
    /// How fast what rubs slides to the right of the normal.
    fn slip(&self, q: &[f64], v: &[f64], joint: usize) -> Option<f64> {
        let (body, under, foot, normal) = self.contact(q, joint)?;
        let moves = |b: usize| {
            let arm = plus(foot, -1.0, [q[3 * b], q[3 * b + 1]]);
            plus([v[3 * b], v[3 * b + 1]], v[3 * b + 2], quarter(arm))
        };
        let from = under.map_or([0.0; 2], moves);
        Some(-dot(plus(moves(body), -1.0, from), quarter(normal)))
    }
    /// Tension of a spring, and the unit vector from its near to its far end.
    fn spring(&self, q: &[f64], load: &Load) -> Option<(f64, V2)> {
        let Load::Spring(at, far, stiffness, natural, acts) = *load else { return None };
        let far = match far {
            Far::Place(p) => p,
            Far::Spot(s) => self.place(q, s),
        };
        let apart = plus(far, -1.0, self.place(q, at));
        let l = length(apart);
        let stretch = if acts * (l - natural) < 0.0 { 0.0 } else { l - natural };
        Some((stiffness * stretch, apart.map(|x| x / l)))
    }
    /// Moment of a torsion spring on its body, counter-clockwise.
    fn torsion(&self, q: &[f64], load: &Load) -> Option<f64> {
        let Load::Torsion(b, stiffness, relaxed) = *load else { return None };
        let turned = q[3 * b + 2] - relaxed;
        Some(-stiffness * libm::atan2(libm::sin(turned), libm::cos(turned)))
    }
    fn forces(&self, q: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.n];
        for (b, body) in self.m.bodies.iter().enumerate() {
            all[3 * b + 1] -= body.mass * self.m.gravity;
        }
        let mut push = |at: Spot, f: V2| {
            all[3 * at.0] += f[0];
            all[3 * at.0 + 1] += f[1];
            if self.m.bodies[at.0].turns {
                all[3 * at.0 + 2] += dot(f, quarter(self.arm(q, at)));
            }
        };
        for load in &self.m.loads {
            match *load {
                Load::Force(at, force, direction, turns) => {
                    let angle = direction + if turns { q[3 * at.0 + 2] } else { 0.0 };
                    push(at, unit(angle).map(|x| x * force));
                }
                Load::Pull(at, to, force) => {
                    let apart = plus(to, -1.0, self.place(q, at));
                    push(at, apart.map(|x| x * force / length(apart)));
                }
                Load::Couple(..) | Load::Torsion(..) | Load::Blow(..) => {}
                Load::Spring(at, far, ..) => {
                    let (tension, e) = self.spring(q, load).expect("a spring");
                    push(at, e.map(|x| x * tension));
                    if let Far::Spot(s) = far {
                        push(s, e.map(|x| -x * tension));
                    }
                }
            }
        }
        for load in &self.m.loads {
            match *load {
                Load::Couple(b, moment) => all[3 * b + 2] += moment,
                Load::Torsion(b, ..) => all[3 * b + 2] += self.torsion(q, load).unwrap_or(0.0),
                _ => {}
            }
        }
        all
    }
    /// Accelerations at a place; the last force is the couple that drives what is driven.
    fn accelerations(&self, q: &[f64], v: &[f64], senses: &[f64]) -> Option<Answer> {
        let mut conditions = self.conditions(q, v, senses);
        if let Some(alpha) = self.m.alpha {
            let row = self.lead_row(q);
            conditions.push(Condition {
                right: alpha * self.m.bodies[self.m.lead].sense,
                force: row.clone(),
                row,
            });
        }
        // On the ground: what holds the bodies accelerates with what carries it.
        let with = self.carried();
        for c in &mut conditions {
            c.right += c.row.iter().zip(&with).map(|(r, a)| r * a).sum::<f64>();
        }
        let (a, forces) = self.balance(&self.forces(q), &conditions)?;
        Some((a.iter().zip(&with).map(|(a, with)| a - with).collect(), forces))
    }
    /// Acceleration of the carrier for each coordinate.
    fn carried(&self) -> Vec<f64> {
        let [x, y] = self.m.carried;
        self.m.bodies.iter().flat_map(|_| [x, y, 0.0]).collect()
    }
    /// `M a = Q + sum of force x multiplier`, `row . a = right`; `None` where the conditions are not independent.
    fn balance(&self, forces: &[f64], conditions: &[Condition]) -> Option<Answer> {
        let (n, size) = (self.n, self.n + conditions.len());
        let mut a = vec![vec![0.0; size + 1]; size];
        for (b, body) in self.m.bodies.iter().enumerate() {
            for (i, inertia) in [body.mass, body.mass, body.inertia].into_iter().enumerate() {
                a[3 * b + i][3 * b + i] = if inertia == 0.0 { 1.0 } else { inertia };
            }
        }
        for (row, q) in a.iter_mut().zip(forces) {
            row[size] = *q;
        }
        for (k, c) in conditions.iter().enumerate() {
            for (j, (row, force)) in c.row.iter().zip(&c.force).enumerate() {
                let turns = j % 3 != 2 || self.m.bodies[j / 3].turns;
                a[n + k][j] = if turns { *row } else { 0.0 };
                a[j][n + k] = if turns { -force } else { 0.0 };
            }
            a[n + k][size] = c.right;
        }
        let x = solved(a)?;
        Some((x[..n].to_vec(), x[n..].to_vec()))
    }
    /// The rate of the leading body as a row; where it does not turn, of its centre seen from the axis of its cylinder.
    fn lead_row(&self, q: &[f64]) -> Vec<f64> {
        let mut row = vec![0.0; self.n];
        let lead = self.m.lead;
        match self.round() {
            Some((at, axis)) if !self.m.bodies[lead].turns => {
                let out = plus(self.place(q, at), -1.0, axis);
                let along = quarter(out).map(|x| x / dot(out, out));
                row[3 * lead..3 * lead + 2].copy_from_slice(&along);
            }
            _ => row[3 * lead + 2] = 1.0,
        }
        row
    }
    /// Velocities for this rate of the leading body, with the least kinetic energy that the conditions allow.
    fn start(&self, q: &[f64], rate: f64) -> Option<Vec<f64>> {
        let none = vec![0.0; self.m.holds.len()];
        let mut conditions = self.conditions(q, &vec![0.0; self.n], &none);
        let row = self.lead_row(q);
        conditions.push(Condition { right: rate, force: row.clone(), row });
        for (b, spin) in &self.m.spins {
            let mut row = vec![0.0; self.n];
            row[3 * b + 2] = 1.0;
            let right = spin * self.m.bodies[*b].sense;
            conditions.push(Condition { right, force: row.clone(), row });
        }
        Some(self.balance(&vec![0.0; self.n], &conditions)?.0)
    }
    /// Velocities just after the blows, and the impulses of the conditions.
    fn struck(&self, v: &[f64]) -> Option<Answer> {
        let none = vec![0.0; self.m.holds.len()];
        let mut conditions = self.conditions(&self.m.start, v, &none);
        conditions.iter_mut().for_each(|c| c.right = 0.0);
        let mut blows = vec![0.0; self.n];
        for load in &self.m.loads {
            if let Load::Blow(at, blow, direction) = *load {
                let j = unit(direction).map(|x| x * blow);
                blows[3 * at.0] += j[0];
                blows[3 * at.0 + 1] += j[1];
                if self.m.bodies[at.0].turns {
                    blows[3 * at.0 + 2] += dot(j, quarter(self.arm(&self.m.start, at)));
                }
            }
        }
        let (jumps, impulses) = self.balance(&blows, &conditions)?;
        Some((v.iter().zip(jumps).map(|(v, jump)| v + jump).collect(), impulses))
    }
    /// Where the leading body goes round a cylinder: its point on it, and the axis.
    fn round(&self) -> Option<(Spot, V2)> {
        self.m.holds.iter().find_map(|h| match *h {
            Hold::Arc(at, _, _, axis, ..) if at.0 == self.m.lead => Some((at, axis)),
            _ => None,
        })
    }
    fn inertias(&self) -> impl Iterator<Item = f64> {
        self.m.bodies.iter().flat_map(|b| [b.mass, b.mass, b.inertia])
    }
    /// What drives what leads, and the inertia over it, at rest: both for its angle, by the velocities that go with its rate.
    fn drive(&self, q: &[f64]) -> Option<(f64, f64)> {
        let v = self.start(q, 1.0)?;
        let mut drive: f64 = self.forces(q).iter().zip(&v).map(|(f, v)| f * v).sum();
        drive -= self.inertias().zip(self.carried()).zip(&v).map(|((m, a), v)| m * a * v).sum::<f64>();
        Some((drive, self.inertias().zip(&v).map(|(m, v)| m * v * v).sum()))
    }
    /// Where it stands when the leading body has turned on by this much: in as short steps as it takes beside a dead centre.
    fn turned_on(&self, q: &[f64], by: f64) -> Option<Vec<f64>> {
        let half = 0.5 * by;
        let once = self.turned_a_step(q, by)?;
        let twice = self.turned_a_step(q, half).and_then(|q| self.turned_a_step(&q, half))?;
        let off = once.iter().zip(&twice).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if off < 1e-10 || half.abs() < 1e-6 {
            return Some(twice);
        }
        self.turned_on(q, half).and_then(|q| self.turned_on(&q, half))
    }
    fn turned_a_step(&self, q: &[f64], by: f64) -> Option<Vec<f64>> {
        let along = |at: &[f64], slope: &[f64], h: f64| -> Vec<f64> {
            at.iter().zip(slope).map(|(x, k)| x + h * k).collect()
        };
        let k1 = self.start(q, 1.0)?;
        let k2 = self.start(&along(q, &k1, by / 2.0), 1.0)?;
        let k3 = self.start(&along(q, &k2, by / 2.0), 1.0)?;
        let k4 = self.start(&along(q, &k3, by), 1.0)?;
        let mean: Vec<f64> = (0..self.n).map(|i| (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0).collect();
        Some(along(q, &mean, by))
    }
    /// The stable equilibrium toward which it sets off, and the natural frequency of small oscillations about it.
    fn equilibrium(&self) -> Verdict {
        const STEP: f64 = 1.0 / 512.0;
        let singular = Verdict::Beyond("a singular place");
        let mut q = self.m.start.clone();
        let Some((first, _)) = self.drive(&q) else { return singular };
        let going = first.signum();
        let mut steps = 0;
        let mut springs = Springs::default();
        loop {
            self.look(&q, &mut springs);
            let Some(next) = self.turned_on(&q, going * STEP) else { return singular };
            let Some((drive, _)) = self.drive(&next) else { return singular };
            if drive * going <= 0.0 {
                break;
            }
            q = next;
            steps += 1;
            if f64::from(steps) * STEP > 2.0 * std::f64::consts::PI - 0.1 {
                return if f64::from(steps) * STEP > 2.0 * std::f64::consts::PI {
                    Verdict::NotReached
                } else {
                    Verdict::Beyond("a whole turn away")
                };
            }
        }
        let (mut low, mut high) = (0.0, STEP);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let there = self.turned_on(&q, going * middle).and_then(|q| self.drive(&q));
            let Some((drive, _)) = there else { return singular };
            if drive * going > 0.0 { low = middle } else { high = middle }
        }
        let Some(q) = self.turned_on(&q, going * high) else { return singular };
        self.look(&q, &mut springs);
        // The differences below may not go across where a spring is met.
        let all_but_met = |load: &Load| {
            let Load::Spring(at, far, stiffness, natural, acts) = *load else { return false };
            let whole = self.spring(&q, &Load::Spring(at, far, stiffness, natural, 0.0));
            acts != 0.0 && whole.is_some_and(|(tension, _)| (tension / stiffness).abs() < 0.02)
        };
        if self.m.loads.iter().any(all_but_met) {
            return Verdict::Beyond("a spring just met");
        }
        let slope = |h: f64| {
            let [ahead, behind] = [h, -h].map(|h| self.turned_on(&q, h).and_then(|q| self.drive(&q)));
            Some((ahead?.0 - behind?.0) / (2.0 * h))
        };
        let (Some(fine), Some(coarse), Some((_, inertia))) = (slope(1e-3), slope(2e-3), self.drive(&q))
        else {
            return singular;
        };
        let stiffness = -(fine + (fine - coarse) / 3.0) / inertia;
        let still = vec![0.0; self.n];
        let none = vec![0.0; self.m.holds.len()];
        let Some((_, forces)) = self.accelerations(&q, &still, &none) else { return singular };
        if stiffness < 1e-3 {
            return Verdict::Beyond("all but indifferent");
        }
        let weight: f64 = self.m.bodies.iter().map(|b| b.mass * self.m.gravity).sum();
        if self.least(&forces).0.abs() < 1e-4 * weight {
            return Verdict::Beyond("hardly presses");
        }
        if self.least(&forces).0 < 0.0 {
            return Verdict::NotReached;
        }
        Verdict::Ends(End { frequency: stiffness.sqrt(), springs, ..End::of(q, still, none, 0.0) })
    }
    /// The angle that leads and its rate, counter-clockwise: of the leading body's axis, or of its centre seen from the axis of the
    /// cylinder that it touches.
    fn leading(&self, q: &[f64], v: &[f64]) -> (f64, f64) {
        let own = 3 * self.m.lead + 2;
        let Some((at, axis)) = self.round() else { return (q[own], v[own]) };
        let out = plus(self.place(q, at), -1.0, axis);
        let rate = dot(self.velocity(q, v, at), quarter(out)) / dot(out, out);
        let start = self.m.axis(self.m.angle);
        let turned = libm::atan2(out[1], out[0]) - start;
        let turn = 2.0 * std::f64::consts::PI;
        (start + turned - (turned / turn).round() * turn, rate)
    }
    /// The first multiplier of each joint.
    fn first(&self) -> Vec<usize> {
        let count = |hold: &Hold| match hold {
            Hold::Weld(..) => 3,
            Hold::Pin(..) | Hold::Hinge(..) | Hold::Line(_, _, true, ..) | Hold::Arc(_, _, true, ..) => 2,
            _ => 1,
        };
        let mut next = 0;
        let first = |hold| {
            next += count(hold);
            next - count(hold)
        };
        self.m.holds.iter().map(first).collect()
    }
    /// Senses of sliding, turned about where the normal force of a guide is negative that can pull: the only ones that fit.
    fn rubbing(&self, q: &[f64], v: &[f64], slides: &[f64]) -> Option<Vec<f64>> {
        let first = self.first();
        let both: Vec<usize> = (0..slides.len())
            .filter(|j| slides[*j] != 0.0 && matches!(self.m.holds[*j], Hold::Guide(_, _, _, false, _)))
            .collect();
        let fitting: Vec<Vec<f64>> = (0..1_usize << both.len())
            .filter_map(|combination| {
                let mut senses = slides.to_vec();
                let sides: Vec<f64> =
                    (0..both.len()).map(|i| if combination >> i & 1 == 0 { 1.0 } else { -1.0 }).collect();
                both.iter().zip(&sides).for_each(|(j, side)| senses[*j] *= side);
                let (_, forces) = self.accelerations(q, v, &senses)?;
                both.iter().zip(&sides).all(|(j, side)| forces[first[*j]] * side > 0.0).then_some(senses)
            })
            .collect();
        (fitting.len() == 1).then(|| fitting[0].clone())
    }
    /// Do points that rub slide and press as at the start?
    fn rubs_on(&self, q: &[f64], v: &[f64], forces: &[f64], senses: &[f64]) -> bool {
        let first = self.first();
        let slides = self.senses(q, v);
        (0..senses.len()).all(|j| match self.m.holds[j] {
            Hold::Guide(_, _, _, pushes, Some(_)) => {
                let side = if pushes { 1.0 } else { forces[first[j]].signum() };
                slides[j] * side == senses[j]
            }
            ref hold => hold.mu().is_none() || slides[j] == senses[j],
        })
    }
    /// Senses in which points slide that rub, by these velocities (or accelerations from rest).
    fn senses(&self, q: &[f64], v: &[f64]) -> Vec<f64> {
        let sense = |(j, hold): (usize, &Hold)| {
            let along = match *hold {
                Hold::Guide(at, _, direction, ..) => dot(self.velocity(q, v, at), unit(radians(direction))),
                _ => self.slip(q, v, j).unwrap_or(0.0),
            };
            if along == 0.0 || hold.mu().is_none() { 0.0 } else { along.signum() }
        };
        self.m.holds.iter().enumerate().map(sense).collect()
    }
    /// Least of the forces that can only push, and its joint; infinite where there is none.
    fn least(&self, forces: &[f64]) -> (f64, usize) {
        let pushes = |hold: &Hold| {
            matches!(
                hold,
                Hold::Guide(_, _, _, true, _) | Hold::Cord(_, _, false) | Hold::Line(..) | Hold::Arc(..)
            )
        };
        let mut least = (f64::INFINITY, 0);
        for (j, first) in self.first().into_iter().enumerate() {
            if pushes(&self.m.holds[j]) && forces[first] < least.0 {
                least = (forces[first], j);
            }
        }
        least
    }
}

/// Gauss's elimination with rows scaled and pivots sought; `None` where a pivot is all but nothing.
fn solved(mut a: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let size = a.len();
    for row in &mut a {
        let most = row[..size].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        row.iter_mut().for_each(|x| *x /= most);
    }
    for i in 0..size {
        let p = (i..size).max_by(|x, y| a[*x][i].abs().total_cmp(&a[*y][i].abs()))?;
        a.swap(i, p);
        if !(a[i][i].abs() > 1e-7) {
            return None;
        }
        let (above, below) = a.split_at_mut(i + 1);
        let pivot = &above[i];
        for row in below {
            let f = row[i] / pivot[i];
            if f != 0.0 {
                row[i..].iter_mut().zip(&pivot[i..]).for_each(|(x, y)| *x -= f * y);
            }
        }
    }
    let mut x = vec![0.0; size];
    for i in (0..size).rev() {
        let rest: f64 = (i + 1..size).map(|j| a[i][j] * x[j]).sum();
        x[i] = (a[i][size] - rest) / a[i][i];
    }
    Some(x)
}

/// The state at the end.
struct End {
    places: Vec<f64>,
    velocities: Vec<f64>,
    /// Senses of sliding.
    senses: Vec<f64>,
    time: f64,
    /// Of the conditions, where something is struck.
    impulses: Option<Vec<f64>>,
    /// Of small oscillations.
    frequency: f64,
    /// What springs have gone through.
    springs: Springs,
}

/// Which springs have acted on the way, by their place among the springs, and how far torsion springs were wound.
#[derive(Clone, Default)]
struct Springs {
    acted: Vec<bool>,
    wound: f64,
}

impl End {
    fn of(places: Vec<f64>, velocities: Vec<f64>, senses: Vec<f64>, time: f64) -> Self {
        Self {
            places,
            velocities,
            senses,
            time,
            impulses: None,
            frequency: f64::NAN,
            springs: Springs::default(),
        }
    }
}

/// What the judge comes to.
enum Verdict {
    Ends(End),
    NotReached,
    /// It has no say here, and why.
    Beyond(&'static str),
}

/// Dormand and Prince's method of order five.
const STAGES: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
const ERRORS: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

impl Judge<'_> {
    fn field(&self, y: &[f64], senses: &[f64]) -> Option<Vec<f64>> {
        let (q, v) = y.split_at(self.n);
        let (a, _) = self.accelerations(q, v, senses)?;
        Some([v, &a[..]].concat())
    }
    /// A step of this length, and an estimate of its error.
    fn step(&self, y: &[f64], senses: &[f64], h: f64) -> Option<(Vec<f64>, f64)> {
        let mut slopes = vec![self.field(y, senses)?];
        let mut next = y.to_vec();
        for weights in STAGES {
            next = y.to_vec();
            for (k, w) in slopes.iter().zip(weights) {
                next.iter_mut().zip(k).for_each(|(x, k)| *x += h * w * k);
            }
            slopes.push(self.field(&next, senses)?);
        }
        let error = (0..y.len())
            .map(|i| {
                let e: f64 = slopes.iter().zip(ERRORS).map(|(k, w)| h * w * k[i]).sum();
                e.abs() / (1.0 + y[i].abs())
            })
            .fold(0.0, f64::max);
        error.is_finite().then_some((next, error))
    }

    /// Notes what springs do here.
    fn look(&self, q: &[f64], springs: &mut Springs) {
        let mut at = 0;
        for load in &self.m.loads {
            let acts = match *load {
                Load::Spring(.., acts) => {
                    acts == 0.0 || self.spring(q, load).is_some_and(|(tension, _)| tension != 0.0)
                }
                Load::Torsion(b, _, relaxed) => {
                    springs.wound = springs.wound.max((q[3 * b + 2] - relaxed).abs());
                    true
                }
                _ => continue,
            };
            if springs.acted.len() == at {
                springs.acted.push(false);
            }
            springs.acted[at] |= acts;
            at += 1;
        }
    }

    /// What becomes of it.
    fn verdict(&self) -> Verdict {
        let m = self.m;
        let sense = m.bodies[m.lead].sense;
        let rough = m.holds.iter().any(|h| h.mu().is_some());
        if m.end == Ending::Equilibrium {
            return if rough { Verdict::Beyond("friction at rest") } else { self.equilibrium() };
        }
        let Some(mut v) = self.start(&m.start, m.spin * sense) else { return Verdict::Beyond("velocities") };
        if !m.loads.iter().any(|load| matches!(load, Load::Blow(..))) {
            return self.moves(v);
        }
        if rough {
            return Verdict::Beyond("a rough guide at a blow");
        }
        let Some((after, impulses)) = self.struck(&v) else { return Verdict::Beyond("velocities") };
        let blows = impulses.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let least = self.least(&impulses).0;
        if least.abs() < 1e-6 * blows {
            return Verdict::Beyond("hardly presses at the blow");
        }
        if least < 0.0 {
            return Verdict::NotReached;
        }
        // What a blow does not move has rounding left.
        let most = after.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        v = if most < 1e-12 { vec![0.0; self.n] } else { after };
        let none = vec![0.0; m.holds.len()];
        let verdict = if m.end == Ending::AtOnce {
            Verdict::Ends(End::of(m.start.clone(), v, none, 0.0))
        } else {
            self.moves(v)
        };
        match verdict {
            Verdict::Ends(end) => Verdict::Ends(End { impulses: Some(impulses), ..end }),
            other => other,
        }
    }
    /// Moves along from these velocities until the end.
    fn moves(&self, v: Vec<f64>) -> Verdict {
        let m = self.m;
        let still = v.iter().all(|x| *x == 0.0);
        let none = vec![0.0; m.holds.len()];
        let Some((free, _)) = self.accelerations(&m.start, &v, &none) else {
            return Verdict::Beyond("conditions that depend on each other");
        };
        let slides = self.senses(&m.start, if still { &free } else { &v });
        // What nothing sets off does not say which way it would rub.
        let settled = |j: usize| {
            m.holds[j].mu().is_some() && self.slip(&m.start, &free, j).is_some_and(|a| a.abs() < 1e-9)
        };
        if still && (0..m.holds.len()).any(settled) {
            return Verdict::Beyond("nothing slides at a rough joint");
        }
        let slow = if still { &free } else { &v }.iter().all(|x| x.abs() < 1e-9);
        if m.alpha.is_some() && slow && m.holds.iter().any(|h| h.mu().is_some()) {
            return Verdict::Beyond("friction that does not slide");
        }
        let Some(senses) = self.rubbing(&m.start, &v, &slides) else { return Verdict::Beyond("friction") };
        let Some((first, forces)) = self.accelerations(&m.start, &v, &senses) else {
            return Verdict::Beyond("conditions that depend on each other");
        };
        let weight: f64 = m.bodies.iter().map(|b| b.mass * m.gravity).sum();
        if self.least(&forces).0.abs() < 1e-4 * weight {
            return Verdict::Beyond("hardly presses at the start");
        }
        if m.end == Ending::AtOnce {
            if still && self.senses(&m.start, &first) != slides || self.least(&forces).0 < 0.0 {
                return Verdict::NotReached;
            }
            return Verdict::Ends(End::of(m.start.clone(), v, senses, 0.0));
        }
        // From rest, the rate is as the acceleration.
        let rate = |a: &[f64]| self.leading(&m.start, if still { a } else { &v }).1;
        let going = rate(&free).signum();
        if still && rate(&first) * going <= 1e-6 {
            return if rate(&first) * going < -1e-6 {
                Verdict::NotReached
            } else {
                Verdict::Beyond("balance")
            };
        }
        let start = self.leading(&m.start, &v).0;
        if self.least(&forces).0 < 0.0 {
            return Verdict::NotReached;
        }
        let angle = match m.end {
            Ending::Angle(a) => m.axis(a),
            _ => f64::INFINITY * going,
        };
        if (angle - start) * going <= 0.0 {
            return Verdict::NotReached;
        }
        let mut y = [m.start.clone(), v].concat();
        let (mut t, mut h) = (0.0, 1e-3);
        let mut springs = Springs::default();
        let ends = |q: &[f64], v: &[f64], t: f64, mut springs: Springs| {
            self.look(q, &mut springs);
            Verdict::Ends(End { springs, ..End::of(q.to_vec(), v.to_vec(), senses.clone(), t) })
        };
        for _ in 0..20_000 {
            self.look(&y[..self.n], &mut springs);
            if let Ending::Time(end) = m.end
                && t + h >= end
            {
                h = end - t;
                if h <= 1e-12 {
                    let (q, v) = y.split_at(self.n);
                    return ends(q, v, end, springs);
                }
            }
            let Some((next, error)) = self.step(&y, &senses, h) else {
                return Verdict::Beyond("a singular place");
            };
            if error > 1e-12 && h > 1e-9 {
                h *= (0.9 * libm::pow(1e-12 / error, 0.2)).clamp(0.2, 0.9);
                continue;
            }
            // What happened on the step: the end, a turn back, a contact lost.
            let what = |y: &[f64]| -> Option<[bool; 4]> {
                let (q, v) = y.split_at(self.n);
                let (_, forces) = self.accelerations(q, v, &senses)?;
                Some([
                    (self.leading(q, v).0 - angle) * going >= 0.0,
                    self.leading(q, v).1 * going < 0.0,
                    self.least(&forces).0 < 0.0,
                    !self.rubs_on(q, v, &forces, &senses),
                ])
            };
            let Some(now) = what(&next) else { return Verdict::Beyond("a singular place") };
            if now.iter().any(|x| *x) {
                let (mut low, mut high) = (0.0, h);
                for _ in 0..80 {
                    let middle = 0.5 * (low + high);
                    let there = self.step(&y, &senses, middle).and_then(|(y, _)| what(&y));
                    if there.is_none_or(|w| w.iter().any(|x| *x)) { high = middle } else { low = middle }
                }
                let Some((end, _)) = self.step(&y, &senses, high) else {
                    return Verdict::Beyond("a singular place");
                };
                let now = what(&end).unwrap_or([false; 4]);
                let (q, v) = end.split_at(self.n);
                let leaves = match m.end {
                    Ending::Leaves(j) => self
                        .accelerations(q, v, &senses)
                        .is_some_and(|(_, forces)| self.least(&forces).1 == j),
                    _ => false,
                };
                return match (now, leaves) {
                    ([false, true, false, _], _) if m.end == Ending::Turns => ends(q, v, t + high, springs),
                    ([true, false, false, false], _) | ([false, false, true, _], true) => {
                        ends(q, v, t + high, springs)
                    }
                    // Where it turns back, what slides does too.
                    ([false, false, false, true], _) if self.leading(q, v).1.abs() > 1e-6 => {
                        Verdict::Beyond("friction turns about")
                    }
                    ([false, false, false, true], _) => Verdict::Beyond("the end is the turning point"),
                    ([true, ..], _) => Verdict::Beyond("the end is the turning point"),
                    _ => Verdict::NotReached,
                };
            }
            (y, t) = (next, t + h);
            h *= (0.9 * libm::pow(1e-12 / error.max(1e-16), 0.2)).clamp(0.5, 3.0);
            let (q, v) = y.split_at(self.n);
            if (self.leading(q, v).0 - start).abs() > 2.8
                && m.holds.iter().any(|h| matches!(h, Hold::Arc(..)))
            {
                return Verdict::Beyond("around a cylinder");
            }
            if (self.leading(q, v).0 - start).abs() > 40.0 * std::f64::consts::PI || t > 60.0 {
                return Verdict::NotReached;
            }
        }
        Verdict::Beyond("a long way")
    }
}

/// A mechanism with its end: an angle on its way, now and then on the other side.
fn composed(seed: u64) -> Option<Machine> {
    let (mut m, mut lot) = machine(seed)?;
    let moves = matches!(m.end, Ending::Angle(_));
    if lot.in_100(15) {
        m.strike(&mut lot);
    } else if lot.in_100(10) && m.bodies[m.lead].turns {
        m.drive(&mut lot);
        return Some(m);
    } else if lot.in_100(10) && moves {
        m.stop();
        m.end = Ending::Equilibrium;
        return Some(m);
    }
    if moves {
        let judge = Judge::new(&m);
        let sense = m.bodies[m.lead].sense;
        let v = judge.start(&m.start, m.spin * sense)?;
        let (v, _) = judge.struck(&v)?;
        let (a, _) = judge.accelerations(&m.start, &v, &vec![0.0; m.holds.len()])?;
        let still = v.iter().all(|x| x.abs() < 1e-12);
        let going = sense * judge.leading(&m.start, if still { &a } else { &v }).1.signum();
        let by = (5 + lot.below(100)) as f64;
        let by = if lot.in_100(8) { -by } else { by };
        // What counts from elsewhere begins far around, and stays within a turn.
        m.end = Ending::Angle((m.angle + going * by).clamp(-360.0, 360.0));
        let pushes: Vec<usize> = (0..m.holds.len())
            .filter(|j| matches!(m.holds[*j], Hold::Guide(_, _, _, true, _) | Hold::Arc(..) | Hold::Line(..)))
            .collect();
        match lot.below(10) {
            0 | 1 => m.end = Ending::Time((5 + lot.below(60)) as f64 / 100.0),
            2 => m.end = Ending::Turns,
            3..7 if !pushes.is_empty() => m.end = Ending::Leaves(lot.of(&pushes)),
            _ => {}
        }
    }
    Some(m)
}

enum Outcome {
    Published,
    NotReached,
    Refused(String),
    Unjudged(&'static str),
}

fn judge(m: &Machine, text: &str) -> Result<Outcome, String> {
    let bank = match load::scenes_only(text, "lot.yaml") {
        Ok(bank) => bank,
        Err(findings) => {
            let messages: Vec<String> = findings.iter().map(ToString::to_string).collect();
            return Ok(Outcome::Refused(messages.join(" | ")));
        }
    };
    let (problem, case) = (&bank.problems[0], &bank.problems[0].cases[0]);
    let data = support::data(problem);
    let verdict = Judge::new(m).verdict();
    let mut solved = match solve(&case.scene, &data) {
        Ok(solved) => solved,
        Err(refusal @ (Refusal::Disagree { .. } | Refusal::Inadmissible(_))) => {
            return Err(format!("{refusal:?}"));
        }
        Err(Refusal::Beyond(Obstacle::Wound(_))) if matches!(&verdict, Verdict::Ends(end) if !end.springs.acted.is_empty() && end.springs.wound < 3.1) =>
        {
            return Err("no torsion spring comes near half a turn".into());
        }
        Err(other) => return Ok(Outcome::Refused(format!("{other:?}"))),
    };
    prove(&case.scene, &data, &mut solved);
    let reached = !solved.entries.is_empty();
    // Whether springs are met is judged by itself.
    let met: Vec<Check> = solved.checks.iter().filter(|c| c.kind == CheckKind::Met).copied().collect();
    solved.checks.retain(|c| c.kind != CheckKind::Met);
    match verdict {
        Verdict::Beyond(what) if what.starts_with("friction") && reached && solved.all_hold() => {
            Err(format!("{what}, and it is published"))
        }
        Verdict::Beyond(what) => Ok(Outcome::Unjudged(what)),
        Verdict::NotReached if reached && solved.all_hold() => Err("it does not get there".into()),
        Verdict::NotReached => Ok(Outcome::NotReached),
        Verdict::Ends(..) if !reached || !solved.all_hold() => {
            Err(format!("it gets there; {:?} {:?}", solved.regime, solved.checks))
        }
        Verdict::Ends(end) => {
            let acted = |c: &Check| end.springs.acted.get(c.of).copied();
            if let Some(wrong) = met.iter().find(|c| c.margin.abs() > 1e-3 && acted(c) != Some(c.ok)) {
                return Err(format!("{wrong:?}, the springs that act: {:?}", end.springs.acted));
            }
            compare(m, &solved, &end)?;
            Ok(Outcome::Published)
        }
    }
}

/// 1 where a direction leads up, or to the right on a level, else -1.
fn up(u: V2) -> f64 {
    if u[1].abs() > 1e-9 { u[1].signum() } else { u[0].signum() }
}

/// Every quantity that is published against the judge.
fn compare(m: &Machine, solved: &Solved, end: &End) -> Result<(), String> {
    let judge = Judge::new(m);
    let (q, v, senses, t) = (&end.places[..], &end.velocities[..], &end.senses[..], end.time);
    let blows = end.impulses.as_deref().unwrap_or_default();
    let kicks = blows.iter().fold(1e-3, |m: f64, x| m.max(x.abs()));
    let (a, forces) = judge.accelerations(q, v, senses).ok_or("no accelerations at the end")?;
    let first = judge.first();
    let fastest = v.iter().fold(1e-3, |m: f64, x| m.max(x.abs()));
    let pulls = judge.forces(q).iter().chain(&forces).fold(0.0, |m: f64, x| m.max(x.abs()));
    let steepest = a.iter().fold(m.gravity, |m: f64, x| m.max(x.abs()));
    let mut faults = Vec::new();
    for e in &solved.entries {
        let name = e.label.quantity.name();
        // The rows of a joint that holds answer a blow as they answer forces.
        let (answers, most) = if name.ends_with("impulse") { (blows, kicks) } else { (&forces[..], pulls) };
        let (want, size) = match (name, e.label.of) {
            ("t", _) => (t, t),
            ("kinetic_energy", _) => {
                let twice: f64 = m
                    .bodies
                    .iter()
                    .enumerate()
                    .map(|(b, body)| {
                        let [x, y, w] = [v[3 * b], v[3 * b + 1], v[3 * b + 2]];
                        body.mass * (x * x + y * y) + body.inertia * w * w
                    })
                    .sum();
                (twice / 2.0, twice + 1e-3)
            }
            ("v", Owner::Body(b)) => (length([v[3 * b], v[3 * b + 1]]), fastest),
            ("v", Owner::Spot(s)) => {
                let spot = (s.body, m.bodies[s.body].points.get(s.point).copied().unwrap_or(on(0.0)));
                (length(judge.velocity(q, v, spot)), fastest)
            }
            ("v_x", Owner::Body(b)) => (v[3 * b], fastest),
            ("v_y", Owner::Body(b)) => (v[3 * b + 1], fastest),
            ("a_x", Owner::Body(b)) => (a[3 * b] + m.carried[0], steepest),
            ("a_y", Owner::Body(b)) => (a[3 * b + 1] + m.carried[1], steepest),
            ("omega", Owner::Body(b)) => (v[3 * b + 2].abs(), fastest),
            ("angular_momentum", Owner::Body(b)) => {
                let inertia = m.bodies[b].inertia;
                (inertia * v[3 * b + 2].abs(), inertia * fastest)
            }
            ("I_O" | "I_G" | "x_G" | "y_G", Owner::Scene) => {
                let pin = m.holds.iter().find_map(|hold| match *hold {
                    Hold::Pin(_, place) => Some(place),
                    _ => None,
                });
                let mass: f64 = m.bodies.iter().map(|b| b.mass).sum();
                let mean = |i: usize| {
                    m.bodies.iter().enumerate().map(|(b, body)| body.mass * q[3 * b + i]).sum::<f64>() / mass
                };
                let about = |at: V2| -> f64 {
                    let own = m.bodies.iter().enumerate().map(|(b, body)| {
                        let apart = length([q[3 * b] - at[0], q[3 * b + 1] - at[1]]);
                        body.inertia + body.mass * apart * apart
                    });
                    own.sum()
                };
                match name {
                    "I_O" => (about(pin.ok_or("no pin")?), 1.0),
                    "I_G" => (about([mean(0), mean(1)]), 1.0),
                    "x_G" => (mean(0), 1.0),
                    _ => (mean(1), 1.0),
                }
            }
            ("alpha", Owner::Body(b)) => (a[3 * b + 2] * m.bodies[b].sense, steepest),
            // What rolls on a cylinder turns by an angle of its own.
            ("phi", Owner::Body(b))
                if m.holds.iter().any(|h| matches!(h, Hold::Arc(at, _, true, ..) if at.0 == b)) =>
            {
                ((q[3 * b + 2] - m.start[3 * b + 2]).abs(), 1.0)
            }
            // Whole turns more or less are told by the angle turned.
            ("angle", Owner::Body(_)) => {
                let turned = (judge.leading(q, v).0 - judge.leading(&m.start, v).0) * m.bodies[m.lead].sense;
                (m.angle.to_radians() + turned, 1.0)
            }
            ("phi", Owner::Body(_)) => ((judge.leading(q, v).0 - judge.leading(&m.start, v).0).abs(), 1.0),
            ("rise", Owner::Body(b)) => (q[3 * b + 1] - m.start[3 * b + 1], 1.0),
            ("omega_small", _) => (end.frequency, end.frequency),
            ("period_small", _) => {
                let period = 2.0 * std::f64::consts::PI / end.frequency;
                (period, period)
            }
            ("power_couple", Owner::Body(b)) => {
                let couples = m.loads.iter().filter_map(|load| match load {
                    Load::Couple(body, moment) if *body == b => Some(*moment),
                    _ => None,
                });
                let drive = if m.alpha.is_some() && b == m.lead { forces[forces.len() - 1] } else { 0.0 };
                let moment = couples.sum::<f64>() + drive;
                (moment * v[3 * b + 2], (pulls + moment.abs()) * fastest)
            }
            ("drive", _) => (forces[forces.len() - 1] * m.bodies[m.lead].sense, pulls),
            ("moment", Owner::Joint(j)) => (forces[first[j] + 2], pulls),
            ("impulse" | "impulse_x", Owner::Joint(j)) => (blows[first[j]], kicks),
            ("impulse_y", Owner::Joint(j)) => (blows[first[j] + 1], kicks),
            ("pin_x" | "normal" | "tension", Owner::Joint(j)) => (forces[first[j]], pulls),
            ("pin_y", Owner::Joint(j)) => (forces[first[j] + 1], pulls),
            ("pin_force", Owner::Joint(j)) => (length([forces[first[j]], forces[first[j] + 1]]), pulls),
            ("pin_angle", Owner::Joint(j)) => {
                let [x, y] = [forces[first[j]], forces[first[j] + 1]];
                // Where it hardly acts its direction hangs on the last digits, and half a turn is both of its ends.
                let (want, got) = (libm::atan2(y, x), e.value());
                let near = (1e-7 * pulls / length([x, y])).min(4.0);
                let off = (got - want).abs();
                let off = off.min((off - 2.0 * std::f64::consts::PI).abs());
                if off > near + 1e-9 {
                    faults.push(format!("{name} of {:?}: {got:e}, {want:e} by the judge", e.label.of));
                }
                continue;
            }
            ("friction" | "friction_impulse", Owner::Joint(j)) => match m.holds[j] {
                Hold::Guide(_, _, direction, _, Some(mu)) => {
                    let u = unit(radians(direction));
                    (-mu * forces[first[j]] * senses[j] * up(u), pulls)
                }
                Hold::Line(.., direction, Some(mu)) => {
                    (-mu * forces[first[j]] * senses[j] * up(unit(radians(direction))), pulls)
                }
                Hold::Line(.., direction, None) => {
                    (answers[first[j] + 1] * up(unit(radians(direction))), most)
                }
                Hold::Arc(at, _, _, axis, _, inside, (mu, _)) => {
                    // A blow acts at the start.
                    let then = if name == "friction_impulse" { &m.start[..] } else { q };
                    let out = plus(judge.place(then, at), -1.0, axis);
                    let right = if inside { [-out[1], out[0]] } else { [out[1], -out[0]] };
                    let rubs = mu.map(|mu| -mu * forces[first[j]] * senses[j]);
                    (rubs.unwrap_or_else(|| answers[first[j] + 1]) * up(right), most)
                }
                _ => (answers[first[j] + 1], most),
            },
            ("spring_force" | "moment", Owner::Strut(s)) => {
                let mut springs = m.loads.iter().filter_map(|load| match *load {
                    Load::Torsion(b, ..) => Some(judge.torsion(q, load)? * m.bodies[b].sense),
                    _ => Some(judge.spring(q, load)?.0),
                });
                (springs.nth(s).ok_or("no such spring")?, pulls)
            }
            _ => {
                faults.push(format!(
                    "{name} of {:?}: {:e} is published, the judge has none",
                    e.label.of,
                    e.value()
                ));
                continue;
            }
        };
        let got = e.value();
        let near = 1e-8 * e.cond.clamp(1.0, 1e6) * want.abs() + 1e-7 * size;
        if !((got - want).abs() <= near) || e.energy.is_none_or(f64::is_nan) {
            faults.push(format!("{name} of {:?}: {got:e} is published, {want:e} by the judge", e.label.of));
        }
    }
    let has = |quantity: Quantity| solved.entries.iter().any(|e| e.label.quantity == quantity);
    let told = [Quantity::KineticEnergy, Quantity::AX, Quantity::Phi, Quantity::Omega];
    if m.carried == [0.0; 2] && !told.into_iter().any(has) {
        faults.push("nothing is published".into());
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

#[test]
fn mechanisms_composed_by_lot_agree_with_full_coordinates() {
    let count = support::seeds(10_000) as u64;
    let found: Vec<_> = (0..count)
        .into_par_iter()
        .filter_map(|seed| {
            let m = composed(seed)?;
            let text = yaml(&m);
            Some((seed, m.kind, judge(&m, &text), text))
        })
        .collect();
    let mut table: BTreeMap<(&str, String), usize> = BTreeMap::new();
    let mut faults = Vec::new();
    for (seed, kind, outcome, text) in found {
        let word = match outcome {
            Ok(Outcome::Published) => "published".to_owned(),
            Ok(Outcome::NotReached) => "not reached".to_owned(),
            Ok(Outcome::Unjudged(why)) => format!("unjudged: {why}"),
            Ok(Outcome::Refused(why)) => format!("refused: {}", why.chars().take(150).collect::<String>()),
            Err(what) => {
                faults.push(format!("seed {seed} ({kind}): {what}\n{text}"));
                "FAULT".to_owned()
            }
        };
        *table.entry((kind, word)).or_default() += 1;
    }
    for ((kind, word), n) in &table {
        println!("{n:6} {kind}: {word}");
    }
    assert!(
        faults.is_empty(),
        "{} of {count}:\n{}",
        faults.len(),
        faults[..faults.len().min(6)].join("\n\n")
    );
}
