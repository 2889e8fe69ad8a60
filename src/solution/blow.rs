//! Blows and impacts: the velocities that bodies have right after them. Forces are unknown while they last, and energy may be lost;
//! so each equation is the momentum of some of the bodies in a direction, or their angular momentum about a point, for which no
//! unknown impulse counts. What the joints demand of the velocities, and how points part again, are the other equations.
use crate::num::eliminate::Equations;
use crate::num::{shown, trig};
use crate::scene::{End, JointKind, Label, Owner, Quantity, Spot};
use crate::solution::draft::Detail;
use crate::solution::expr::{Expr, ONE, SymbolId, ZERO, in_sense, length, positive_first, ratio, square};
use crate::solution::factors::{Cancel, Factors, Sum};
use crate::solution::order::{Eliminated, Row, needed};
use crate::solution::page::{Page, Pieces, Step};
use crate::solution::plane::{
    END, Hold, NOTHING, Plane, PlaneBody, Pull, ROUNDING, START, Vector, cross, left, less, product,
};
use crate::solution::stop::DerivationStop;
use crate::solution::terms::tagged;
use std::cmp::Reverse;

/// The conditions of the joints are written out where there are no more of them.
const FEW: usize = 4;
/// Of so many bodies each choice of some is looked at, of more all together and each alone.
const CHOICES: usize = 4;
/// How much heavier or lighter a body is taken that is thought to have nearly all of the mass, or none.
const EXTREME: f64 = 1e9;

/// A share that is lost has so many figures at most.
const FIGURES_OF_SHARE: usize = 9;

/// What blows do at an instant.
#[derive(Debug, Clone)]
pub struct Blow {
    /// The bodies, with the velocities after it, or their changes, in the place of accelerations.
    pub bodies: Vec<PlaneBody>,
    /// The impulses of the joints.
    impulses: Vec<(usize, SymbolId)>,
    /// Does a joint feel it?
    jolts: bool,
    /// Are these the velocities after it, and not their changes?
    pub from_rest: bool,
    /// Was something solved for together?
    entangled: bool,
    /// The kinetic energy before an impact.
    before: Option<Expr>,
    /// That after it.
    after: Expr,
    /// Velocities that others give by the joints.
    held: Vec<SymbolId>,
    /// The directions in which the velocities are told, where these are not to the right and up.
    frame: Option<[Vector; 2]>,
}

/// Of which bodies, and in which direction or about which point, a momentum is.
#[derive(Debug, Clone)]
struct Momentum {
    bodies: Vec<usize>,
    of: Of,
}

#[derive(Debug, Clone)]
enum Of {
    /// Along one of the directions in which forces are told.
    Along(usize),
    /// About a point, with what it is called.
    About(Vector, String),
}

/// Both sides of an equation.
type Sides = (Expr, Expr);
/// Velocities, each with what it is by others.
type Held = Vec<(SymbolId, Expr)>;
/// How a body moves before an impact: its mass centre, and its turn.
type Before = (Vector, Factors);

impl Plane<'_, '_> {
    /// What an instant's blows do: to momenta what forces do to accelerations, with an impulse in the place of each force of a joint.
    /// What bodies bring into an impact is added to what blows give them.
    pub fn strike(&mut self) -> Result<(), DerivationStop> {
        let (scene, lead, kept, moves) = (self.scene, self.lead, self.bodies.clone(), self.moves);
        let (from_rest, at_once) = (self.first == ZERO, scene.end == End::AtOnce);
        let mark = if from_rest { "s" } else { r"\Delta" };
        self.here = if at_once { END } else { START };
        self.turn_frame();
        let ways = if self.oblique.is_some() { ["t", "n"] } else { ["x", "y"] };
        for (body, it) in kept.iter().enumerate() {
            let named = |this: &mut Self, letter: &str, way: &str, unit: &str| {
                this.named(&[tagged(letter, &format!("{}{way}{mark}", it.tag))], unit)
            };
            let v = ways.map(|way| named(self, "v", way, "m/s"));
            let omega = it.alpha.map(|_| named(self, r"\omega", "", "rad/s"));
            (self.bodies[body].a, self.bodies[body].alpha) = (v, omega);
        }
        for push in scene.pushes.iter().filter(|p| p.blow) {
            let size = self.number(push.force_n, "J", "N s").factors();
            let (point, unit) = (self.spot(push.at), self.direction(push.direction_deg));
            let along = self.frame(&unit);
            self.add_pull(push.at.body, &point, size, along);
        }
        let (before, energy) = self.momenta_before();
        self.moves = false;
        self.hold();
        self.part(&before);
        let rows: Vec<Sides> = (0..kept.len()).flat_map(|b| self.equations(b)).collect();
        let (demands, unknowns) = (self.demands(), [self.accelerations(), self.reactions()].concat());
        let all = [rows.clone(), demands.clone()].concat();
        self.page.settle_all(&all, &unknowns, |_| ROUNDING)?;
        let impact = scene.arrivals().next().is_some();
        self.begin_as("blow", if impact { "impact" } else { "blow" });
        if at_once {
            self.tell_places();
        }
        if let Some(pivot) = self.pivot.clone() {
            self.about_the_pin(&pivot);
        }
        let steps = self.steps.len();
        let free = if self.pivot.is_none() { self.by_free_momenta(demands.clone()) } else { None };
        let mut together = Vec::new();
        let (held, idle) = free.unwrap_or_else(|| {
            self.unravel();
            let follows = |s: &SymbolId| self.steps[steps..].iter().any(|step| step.symbol == *s);
            let known = |s: &SymbolId| !self.symbols.value(*s).is_nan();
            together = unknowns.into_iter().filter(|s| !follows(s) && known(s)).collect();
            self.tell_each_momentum(&rows, &demands);
            (Held::new(), Vec::new())
        });
        let after = self.energy_of(&held);
        let held: Vec<SymbolId> = held.into_iter().map(|(s, _)| s).collect();
        let says = match from_rest {
            true if impact => "impact.so",
            true => "joined.together_blow",
            false => "impact.changes",
        };
        self.say(says, &[]);
        self.tell_velocities(steps, [&held, &idle, &together]);
        if let Some(change) = self.bodies[lead].alpha {
            let per = self.arc_of(lead).map_or_else(Factors::one, |arc| self.turning_of(arc));
            self.first = &self.first + change.over(per);
        }
        if moves && at_once {
            self.sense = self.value(&self.first).signum();
        }
        let jolts = |h: &Hold| {
            let force = h.pulls.iter().any(|p| !p.along.iter().all(Sum::is_zero));
            force && self.symbols.value(h.unknown).abs() > NOTHING
        };
        self.blow = Some(Blow {
            jolts: self.holds.iter().any(jolts),
            bodies: std::mem::replace(&mut self.bodies, kept),
            impulses: self.holds.iter().map(|h| (h.joint, h.unknown)).collect(),
            from_rest,
            entangled: !together.is_empty(),
            before: impact.then_some(energy),
            after,
            held,
            frame: self.oblique.take(),
        });
        (self.moves, self.here) = (moves, END);
        self.holds.clear();
        self.pulls.clear();
        Ok(())
    }

    /// Points that part again on a slanting line: velocities are told along it and across.
    fn turn_frame(&mut self) {
        let joint = self.scene.restitution.and_then(|(j, _)| self.scene.joints.get(j));
        let Some(line) = joint.and_then(|j| j.kind.line()) else { return };
        let along = self.line(line);
        let level = along.iter().any(|x| self.value(&x.expr()).abs() < NOTHING);
        self.oblique = (!level).then(|| [along.clone(), left(&along)]);
    }

    /// What moving bodies bring into an impact: as impulses that would set them going so. How each moves, and their kinetic energy.
    fn momenta_before(&mut self) -> (Vec<Before>, Expr) {
        let mut before = vec![(Vector::default(), Factors::zero()); self.bodies.len()];
        let mut energy = Sum::default();
        for (b, arrives) in self.scene.arrivals() {
            let speed = self.number(arrives.speed_m_s, "v_0", "m/s").factors();
            let spin = self.number(arrives.spin_rad_s, r"\omega_0", "rad/s").factors();
            let (it, sense, centre) = (self.bodies[b].clone(), self.sense_of(b), self.centre(b));
            let (size, along) = match self.scene.turns_about((b, arrives)) {
                Some(pin) => {
                    let out = less(&centre, &self.spot(pin));
                    (spin.signed(sense), left(&self.places(&out, self.here)))
                }
                None => (speed, self.direction(arrives.direction_deg)),
            };
            let along = self.frame(&along);
            let v = along.each_ref().map(|x| x.times(&size));
            energy = energy.plus(&it.mass.each(&product(&v, &v)));
            energy = energy.plus(&it.inertia.iter().map(|i| i.times(spin.squared())).collect());
            if v.iter().any(|x| !x.is_zero()) {
                self.add_pull(b, &centre, it.mass.times(&size), along);
            }
            for own in it.inertia.iter().filter(|_| !spin.is_zero()) {
                self.pulls.push(Pull::couple(b, own.times(&spin), sense));
            }
            before[b] = (v, spin);
        }
        (before, ratio(1, 2) * energy.expr())
    }

    /// What is not parted before an impact parts after it, at a share of the speed at which it met.
    fn part(&mut self, before: &[Before]) {
        let Some((joint, e)) = self.scene.restitution else { return };
        let e = self.number(e, "e", "1");
        let Some(at) = self.holds.iter().position(|h| h.joint == joint) else { return };
        let met: Sum = self.holds[at]
            .pulls
            .iter()
            .map(|p| {
                let (v, spin) = &before[p.body];
                product(&p.along, v).plus(&p.turn.signed(self.sense_of(p.body)).times(spin))
            })
            .sum();
        self.holds[at].given = met.opposite().times(&e).expr();
    }

    /// Kinetic energy of the bodies with velocities in the place of accelerations, some of them told by others.
    fn energy_of(&self, held: &[(SymbolId, Expr)]) -> Expr {
        let moving = |s: &SymbolId| self.symbols.value(*s) != 0.0;
        let rate = |s: SymbolId| {
            let told = held.iter().find(|(of, is)| *of == s && !matches!(is, Expr::Sum(_)));
            told.map_or_else(|| s.into(), |(_, is)| is.clone()).factors().squared()
        };
        if let (Some(pivot), Some(omega)) = (&self.pivot, self.bodies[0].alpha) {
            return ratio(1, 2).by(pivot.about).by(square(omega));
        }
        let each = self.bodies.iter().flat_map(|b| {
            let straight = b.a.into_iter().filter(moving).map(|v| b.mass.times(rate(v)));
            let spin = b.alpha.filter(moving).map(|w| b.inertia.iter().map(move |i| i.times(rate(w))));
            straight.chain(spin.into_iter().flatten()).collect::<Vec<_>>()
        });
        ratio(1, 2) * Sum::of(each).expr()
    }

    // -- momenta for which no unknown impulse counts ----------------------------------------------------------------------

    /// The share of a force, per size, in a momentum.
    fn share(&mut self, pull: &Pull, of: &Of) -> Sum {
        match of {
            Of::Along(i) => pull.along[*i].clone(),
            Of::About(point, _) => pull.turn.plus(&cross(&self.away(pull.body, point), &pull.along)),
        }
    }
    /// From a point to the mass centre of a body.
    fn away(&mut self, body: usize, point: &Vector) -> Vector {
        less(&self.seen(&self.centre(body)), point)
    }
    /// A place, in the directions in which forces are told.
    fn seen(&mut self, point: &Vector) -> Vector {
        let place = self.places(point, self.here);
        self.frame(&place)
    }
    /// The points about which moments may be taken, with their names, those that are held first: where joints act, where the
    /// impulses of two of them meet, and the mass centres.
    fn centres_of_moments(&mut self) -> Vec<(Vector, String)> {
        let scene = self.scene;
        let held = |k: &JointKind| usize::from(!matches!(k, JointKind::Pin { .. }));
        let mut joints: Vec<usize> = (0..scene.joints.len()).collect();
        joints.sort_by_key(|j| held(&scene.joints[*j].kind));
        let spots: Vec<Spot> = joints.iter().flat_map(|j| scene.joints[*j].kind.spots()).collect();
        let mut all = Vec::new();
        for spot in spots.iter().copied() {
            let own = scene.point_name(spot).map_or("P", |names| names.1);
            // Points of several bodies may bear one letter.
            let shared = spots.iter().any(|other| {
                other.body != spot.body && scene.point_name(*other).is_some_and(|names| names.1 == own)
            });
            let name = if shared { tagged(own, &self.bodies[spot.body].tag) } else { own.to_owned() };
            let place = self.spot(spot);
            all.push((self.seen(&place), format!("${name}$")));
        }
        let first = |h: &Hold| Some((h.joint, h.pulls.first()?.clone()));
        let ends: Vec<(usize, Pull)> = self.holds.iter().filter_map(first).collect();
        let names = ["impact.contact", "impact.meet"].map(|name| self.phrase(name, &[]));
        let flat = |this: &Self, p: &Pull, i: usize| this.value(&p.along[i].expr()).abs() < NOTHING;
        let pairs = ends.iter().flat_map(|one| ends.iter().map(move |other| (one, other)));
        for ((joint, one), (second, other)) in pairs {
            let name = &names[usize::from(joint != second)];
            if flat(self, one, 0) && flat(self, other, 1) {
                // A force along a direction acts at its point's distance across it.
                let at = |this: &mut Self, p: &Pull, i: usize| {
                    let arm = p.turn.by(&p.along[1 - i]).signed(if i == 0 { 1 } else { -1 });
                    let centre = this.centre(p.body);
                    this.seen(&centre)[i].plus(&arm)
                };
                all.push(([at(self, one, 0), at(self, other, 1)], name.clone()));
            }
        }
        for body in 0..self.bodies.len() {
            let centre = self.centre(body);
            let name = tagged("G", &self.bodies[body].tag);
            all.push((self.seen(&centre), format!("${name}$")));
        }
        all
    }
    /// All momenta that could be looked at, what is simplest first.
    fn momenta(&mut self) -> Vec<Momentum> {
        let n = self.bodies.len();
        let along =
            |bodies: Vec<usize>| [0, 1].map(|i| Momentum { bodies: bodies.clone(), of: Of::Along(i) });
        let mut choices: Vec<Vec<usize>> = if n > CHOICES {
            [(0..n).collect()].into_iter().chain((0..n).map(|b| vec![b])).collect()
        } else {
            (1..1usize << n).map(|some| (0..n).filter(|b| some >> b & 1 == 1).collect()).collect()
        };
        choices.sort_by_key(|some| std::cmp::Reverse(some.len()));
        let mut all: Vec<Momentum> = (0..n).flat_map(|b| along(vec![b])).collect();
        let points = self.centres_of_moments();
        for bodies in choices {
            let about = |(at, name): &(Vector, String)| Momentum {
                bodies: bodies.clone(),
                of: Of::About(at.clone(), name.clone()),
            };
            all.extend(points.iter().map(about));
            if bodies.len() > 1 {
                all.extend(along(bodies));
            }
        }
        all
    }
    /// Does no unknown impulse count in a momentum?
    fn is_free(&mut self, Momentum { bodies, of }: &Momentum) -> bool {
        self.holds.clone().iter().all(|hold| {
            let own = hold.pulls.iter().filter(|p| bodies.contains(&p.body));
            let whole: Sum = own.map(|p| self.share(p, of)).sum();
            self.value(&whole.expr()).abs() <= NOTHING
        })
    }
    /// A momentum before and after, both sides.
    fn balance_of(&mut self, Momentum { bodies, of }: &Momentum) -> (Sum, Sum) {
        let sense = bodies.iter().find(|b| self.bodies[**b].alpha.is_some()).map_or(1, |b| self.sense_of(*b));
        let sense = if matches!(of, Of::Along(_)) { 1 } else { sense };
        let given: Vec<Pull> = self.pulls.iter().filter(|p| bodies.contains(&p.body)).cloned().collect();
        let before: Sum = given.iter().map(|p| p.size.each(&self.share(p, of))).sum();
        let mut after = Sum::default();
        for &b in bodies {
            let it = self.bodies[b].clone();
            let v = it.a.map(Sum::one);
            after = after.plus(&match of {
                Of::Along(i) => it.mass.each(&v[*i]),
                Of::About(point, _) => {
                    let turned = it.alpha.map(|w| it.inertia.iter().map(move |i| i.times(w)).collect());
                    let turned: Sum = turned.unwrap_or_default();
                    it.mass.each(&cross(&self.away(b, point), &v)).plus(&turned.signed(self.sense_of(b)))
                }
            });
        }
        (before.signed(sense), after.signed(sense))
    }

    /// Momenta for which no unknown impulse counts, as many as give all velocities beside what the joints demand; `None` where there
    /// are not so many.
    fn enough(&mut self, demands: &[Sides], velocities: &[SymbolId]) -> Option<Vec<Momentum>> {
        let mut all: Equations<f64> = Equations::new(velocities.len());
        // Takes a row if it says more than those that there are; and are there as many as velocities?
        let mut takes = |page: &mut Page, row: &Expr| {
            let (mut more, known) = (all.clone(), all.clone().reduce(&[]).rank());
            let cells = more.row();
            page.linear(row, velocities).0.into_iter().for_each(|(column, x)| cells[column] = x);
            let rank = more.clone().reduce(&[]).rank();
            if rank > known {
                all = more;
            }
            [rank > known, rank == velocities.len()]
        };
        let mut enough = false;
        for (l, r) in demands {
            [_, enough] = takes(&mut self.page, &(l - r));
        }
        let mut chosen = Vec::new();
        for momentum in self.momenta() {
            if enough {
                break;
            }
            if self.is_free(&momentum) {
                let (_, after) = self.balance_of(&momentum);
                let taken;
                [taken, enough] = takes(&mut self.page, &after.expr());
                chosen.extend(taken.then_some(momentum));
            }
        }
        enough.then_some(chosen)
    }
    /// What the joints that hold say of the velocities: mass centres by turns, and what comes later by what comes before.
    fn held_velocities(&self, demands: &[Sides], velocities: &[SymbolId]) -> Held {
        let mut held = Held::new();
        for (l, r) in demands {
            let row = Self::spelled(&(l - r), &held);
            let mut unknown: Vec<SymbolId> = row.expr().uses();
            unknown.retain(|s| velocities.contains(s));
            unknown.sort_by_key(|s| (self.turns(*s), Reverse(velocities.iter().position(|v| v == s))));
            let found = unknown.into_iter().find_map(|s| Some((s, self.parted(&row, s)?)));
            if let Some((symbol, [share, rest])) = found {
                let found = (symbol, self.quotient(&rest.opposite(), &share));
                for (_, is) in &mut held {
                    *is = Self::spelled(is, std::slice::from_ref(&found)).expr();
                }
                held.push(found);
            }
        }
        held
    }
    /// The velocities from momenta for which no unknown impulse counts, and what the joints demand; `None` where these are not enough.
    /// Those that the joints give, and those that are 0 whatever the data.
    fn by_free_momenta(&mut self, mut demands: Vec<Sides>) -> Option<(Held, Vec<SymbolId>)> {
        let velocities = self.accelerations();
        let chosen = self.enough(&demands, &velocities)?;
        let parts = self.scene.restitution.and_then(|(j, _)| self.holds.iter().position(|h| h.joint == j));
        let parting = parts.map(|at| demands.remove(at));
        let held = self.held_velocities(&demands, &velocities);
        let mut balances = Vec::new();
        for momentum in &chosen {
            let (before, after) = self.balance_of(momentum);
            balances.push([before, Self::spelled(&after.expr(), &held)]);
        }
        let gained = |[before, after]: &[Sum; 2]| after.less(before);
        let parting =
            parting.map(|(l, r)| [Sum::of(r.terms().iter().map(Factors::of)), Self::spelled(&l, &held)]);
        let rows = balances.iter().chain(&parting).map(gained).collect();
        let open = velocities.iter().copied().filter(|v| held.iter().all(|(s, _)| s != v)).collect();
        let Eliminated { found, mut idle, .. } = self.eliminate(rows, open, |s| self.turns(s))?;
        let moving = |is: &Expr, idle: &[SymbolId]| idle.iter().fold(is.clone(), |all, s| all.put(*s, &ZERO));
        idle.extend(
            held.iter().filter(|(_, is)| moving(is, &idle) == ZERO).map(|(s, _)| *s).collect::<Vec<_>>(),
        );
        for (symbol, is) in found {
            self.page.step(symbol, is);
        }
        if let Some([along, across]) = self.oblique.clone() {
            let [t, n] = [along, across].map(|unit| {
                let [x, y] = unit.map(|x| self.value(&x.expr()));
                format!(r"${}^\circ$", self.digits(trig::atan2(y, x).to_degrees().rem_euclid(360.0), 4))
            });
            self.say("impact.directions", &[("t", &t), ("n", &n)]);
        }
        let kept = held.iter().filter(|(s, _)| !idle.contains(s));
        let kept: Vec<Sides> = kept.map(|(s, is)| ((*s).into(), is.clone())).collect();
        if !kept.is_empty() {
            let says = if self.first == ZERO { "impact.held" } else { "impact.held_changes" };
            self.say(says, &[]);
            self.page.equations_or_one(&kept);
        }
        let each = |s: &Sum| positive_first(s.terms().iter().map(Factors::expr));
        for (momentum, [before, after]) in chosen.iter().zip(balances) {
            // What neither comes nor goes is not told.
            if after.expr().uses().iter().any(|s| velocities.contains(s) && !idle.contains(s)) {
                self.say_momentum(momentum);
                self.page.equations_or_one(&[(each(&before), each(&after))]);
            }
        }
        if let (Some([r, l]), Some((_, e))) = (parting, self.scene.restitution) {
            let (e, sense) = (self.number(e, "e", "1"), if self.value(&r.expr()) < 0.0 { -1 } else { 1 });
            self.say(if e == ZERO { "impact.plastic" } else { "impact.parting" }, &[("e", &e)]);
            self.page.equations_or_one(&[(each(&l.signed(sense)), each(&r.signed(sense)))]);
        }
        for (symbol, is) in &held {
            self.page.step(*symbol, moving(is, &idle));
        }
        self.impulses_from(&held);
        Some((held, idle))
    }
    /// What it is of, and why no unknown impulse counts.
    fn say_momentum(&mut self, Momentum { bodies, of }: &Momentum) {
        let several = self.bodies.len() > 1;
        let within = |p: &&Pull| bodies.contains(&p.body);
        let inner = self.holds.iter().any(|h| h.pulls.iter().filter(within).count() > 1);
        let outer = self.holds.iter().any(|h| h.pulls.iter().filter(within).count() == 1);
        let names: Vec<&str> = bodies.iter().map(|b| self.bodies[*b].name.as_str()).collect();
        let name = match of {
            Of::About(..) => "impact.about",
            Of::Along(i) if self.oblique.is_some() => ["impact.line", "impact.normal"][*i],
            Of::Along(i) => ["impact.right", "impact.upward"][*i],
        };
        let point = if let Of::About(_, point) = of { point.clone() } else { String::new() };
        let why = match (of, outer) {
            (Of::About(..), true) => Some("impact.no_moment"),
            (Of::Along(_), true) => Some("impact.across"),
            _ => None,
        };
        let why = [why, inner.then_some("impact.cancels")].into_iter().flatten();
        let why: String = why.map(|name| self.phrase(name, &[])).collect();
        let bodies = if several { format!(" ({})", names.join(", ")) } else { String::new() };
        self.say(name, &[("point", &point), ("bodies", &bodies), ("why", &why)]);
    }
    /// An expression with these put in, multiplied out, so that what is alike is collected.
    fn spelled(of: &Expr, known: &[(SymbolId, Expr)]) -> Sum {
        let put = known.iter().fold(of.clone(), |all, (symbol, is)| all.put(*symbol, is));
        let mut terms: Vec<Factors> = put.terms().iter().map(Factors::of).collect();
        for symbol in put.uses() {
            terms = terms.iter().flat_map(|t| t.spread(symbol)).collect();
        }
        Sum::of(terms)
    }
    /// Is it the turn of a body?
    fn turns(&self, velocity: SymbolId) -> bool {
        self.bodies.iter().any(|b| b.alpha == Some(velocity))
    }
    /// The impulses of joints that are asked, from the momenta of single bodies.
    fn impulses_from(&mut self, held: &[(SymbolId, Expr)]) {
        let labels = self.needed();
        let joints: Vec<Owner> =
            labels.iter().filter(|l| is_impulse(l.quantity)).map(|label| label.of).collect();
        let wanted = self.holds.iter().filter(|h| joints.contains(&Owner::Joint(h.joint)));
        let wanted: Vec<SymbolId> = wanted.map(|h| h.unknown).collect();
        let mut rows = Vec::new();
        for (l, r) in (0..self.bodies.len()).flat_map(|b| self.equations(b)) {
            let r = Self::spelled(&r, held);
            let r = positive_first(r.terms().iter().map(Factors::expr));
            rows.push(Row { at: 0, name: String::new(), sides: (l, r), told: true });
        }
        let mut open = self.reactions();
        let found = self.page.untangle(rows, &mut open, false);
        let found = needed(found, wanted);
        self.page.follow(&found);
    }
    /// Tells the momenta of each body, where unknown impulses are in every equation.
    fn tell_each_momentum(&mut self, rows: &[Sides], demands: &[Sides]) {
        let name = match (&self.pivot, self.holds.is_empty()) {
            (None, true) => "joined.blow",
            (None, false) => "joined.blow_joints",
            (Some(pivot), _) if pivot.radial => "joined.blow_radial",
            (Some(_), _) => "joined.blow_pinned",
        };
        let pin = self.pivot.as_ref().map_or_else(String::new, |pivot| pivot.name.clone());
        self.say(name, &[("pin", &pin)]);
        self.page.equations_or_one(rows);
        let many = demands.len() > FEW;
        if !demands.is_empty() {
            let name = if many { "joined.blow_demands_many" } else { "joined.blow_demands" };
            self.say(name, &[("n", &demands.len().to_string())]);
        }
        if !many || self.detail == Detail::Full {
            self.page.equations_or_one(demands);
        }
    }

    // -- what is told -----------------------------------------------------------------------------------------------------

    /// Is it an impact of bodies that move?
    pub fn impact(&self) -> bool {
        self.blow.as_ref().is_some_and(|b| b.before.is_some())
    }
    /// Is there no choice of momenta without unknown impulses that would do?
    pub fn entangled(&self) -> bool {
        self.blow.as_ref().is_some_and(|b| b.entangled)
    }
    /// Is an impulse of a joint asked?
    pub fn asks_impulses(&self) -> bool {
        self.needed().iter().any(|label| is_impulse(label.quantity))
    }
    /// Does a joint feel it?
    pub fn jolts(&self) -> bool {
        self.blow.as_ref().is_some_and(|b| b.jolts)
    }
    /// What was solved for together, then how the velocities and impulses follow of these steps on; those that the joints give, and
    /// those that are 0 whatever the data, only where they are asked.
    fn tell_velocities(&mut self, steps: usize, [held, idle, together]: [&[SymbolId]; 3]) {
        let needed = self.needed();
        let asked = needed.iter().filter_map(|label| match label.of {
            Owner::Body(b) => Some(b),
            Owner::Spot(spot) => Some(spot.body),
            _ => None,
        });
        let asked: Vec<usize> = asked.collect();
        let (at_once, moves) = (self.scene.end == End::AtOnce, |s: SymbolId| self.symbols.value(s) != 0.0);
        let told = |step: &&Step| {
            let s = step.symbol;
            let body = self.bodies.iter().position(|b| b.a.contains(&s) || b.alpha == Some(s));
            let stops = together.is_empty() && body.is_some() && !idle.contains(&s);
            // What the joints give has been told; its number is shown where it is asked.
            let shown = body.is_none_or(|b| asked.contains(&b)) || matches!(step.from, Expr::Sum(_));
            (moves(s) || stops) && (!held.contains(&s) || at_once && shown)
        };
        let solved = together.iter().filter(|s| moves(**s)).map(|s| self.chain(*s, &(*s).into()));
        let steps = self.steps[steps..].iter().filter(told);
        let lines: Vec<String> =
            solved.chain(steps.map(|step| self.chain(step.symbol, &step.from))).collect();
        self.page.formulas(lines);
        self.skip_new();
    }
    /// The energy that an impact loses, and what becomes of it where a coefficient of restitution or a mass is another.
    pub fn tell_loss(&mut self) -> Result<(), DerivationStop> {
        let Some(blow) = self.blow.clone() else { return Ok(()) };
        let Some(before) = blow.before.clone() else { return Ok(()) };
        let [first, last] = [&before, &blow.after].map(|e| self.value(e));
        let lost = if (first - last).abs() <= 1e-9 * first { 0.0 } else { first - last };
        self.skip_new();
        let first = self.page.find(&["E_0", "E_{k0}"], "J", before.clone());
        let last = self.page.find_once(&["E_s", "E_{ks}"], "J", blow.after.clone());
        self.say("impact.energies", &[]);
        if lost > 0.0 {
            let lost = self.page.find(&[r"\Delta E", "E_v"], "J", first - last);
            let share = 100.0 * self.symbols.value(lost) / self.symbols.value(first);
            // What is left keeps it below 100 %.
            let whole = |n: &usize| share < 100.0 && shown::significant(share, *n) == "100";
            let figures = (2..FIGURES_OF_SHARE).find(|n| !whole(n)).unwrap_or(FIGURES_OF_SHARE);
            let percent = self.digits(share, figures);
            self.tell_new();
            self.say("impact.lost", &[("percent", &percent)]);
        } else {
            self.tell_new();
            let parts = self.scene.restitution.is_some();
            self.say(if parts { "impact.kept" } else { "impact.kept_joined" }, &[]);
        }
        let [before, after] = [&before, &blow.after].map(|e| self.page.expanded(e));
        // Where all was solved for together no formula tells what else would come out.
        if blow.entangled {
            return Ok(());
        }
        if let Some((_, e)) = self.scene.restitution {
            let e = self.number(e, "e", "1");
            let Expr::Symbol(e) = e else { return Ok(()) };
            let own = self.symbols.value(e);
            let limits =
                self.steps.iter().filter(|step| !blow.held.contains(&step.symbol)).find_map(|step| {
                    let is = self.page.expanded(&step.from);
                    is.uses().contains(&e).then_some((step.symbol, is))
                });
            let Some((symbol, is)) = limits else { return Ok(()) };
            let unit = if bodies_turn(&blow, symbol) { Quantity::Omega } else { Quantity::V }.unit();
            let [soft, hard] = [0.0, 1.0].map(|x| {
                self.symbols.place(e, x);
                let value = self.value(&is);
                self.symbols.place(e, own);
                self.rough(value, unit)
            });
            let factor = ONE + Expr::from(e);
            let pieces: Pieces = &[("factor", &factor), ("what", &symbol), ("soft", &soft), ("hard", &hard)];
            let name = match own {
                0.0 => "impact.limits_soft",
                1.0 => "impact.limits_hard",
                _ => "impact.limits_e",
            };
            self.say(name, pieces);
            return Ok(());
        }
        let mut arrives =
            self.scene.arrivals().filter(|(b, _)| self.value(&self.bodies[*b].mass.expr()) > 0.0);
        let (Some((b, _)), None) = (arrives.next(), arrives.next()) else { return Ok(()) };
        let it = self.bodies[b].clone();
        if let (None, [mass]) = (it.alpha, &it.mass.expr().uses()[..]) {
            let own = self.symbols.value(*mass);
            let [light, heavy] = [1.0 / EXTREME, EXTREME].map(|by| {
                self.symbols.place(*mass, own * by);
                let share = 1.0 - self.value(&after) / self.value(&before);
                self.symbols.place(*mass, own);
                self.digits((100.0 * share).round(), 2)
            });
            self.say("impact.limits_mass", &[("mass", mass), ("light", &light), ("heavy", &heavy)]);
        }
        Ok(())
    }

    /// Velocities and energy right after a blow, where these are what was solved for.
    pub fn just_after(&mut self, blow: &Blow, label: Label) -> Option<SymbolId> {
        use Quantity as Q;
        let it = |b: usize| &blow.bodies[b];
        let (names, is) = match (label.quantity, label.of) {
            (Q::VX | Q::VY, Owner::Body(b)) => {
                let i = usize::from(label.quantity == Q::VY);
                let Some(frame) = &blow.frame else { return Some(it(b).a[i]) };
                let shares =
                    frame.iter().zip(it(b).a).map(|(unit, v)| unit[i].times(self.unless_zero(v)).expr());
                let tag = format!("{}{}s", it(b).tag, ["x", "y"][i]);
                (self.unused(["v", "u"].map(|l| tagged(l, &tag))), positive_first(shares))
            }
            (Q::V, Owner::Body(b)) => {
                let moving = it(b).a.into_iter().filter(|v| self.symbols.value(*v) != 0.0);
                if let [one] = moving.collect::<Vec<_>>()[..] {
                    return Some(self.page.sized(one));
                }
                let [x, y] = it(b).a.map(|v| self.unless_zero(v));
                (self.unused(["v", "u"].map(|l| tagged(l, &it(b).tag))), length(x, y))
            }
            (Q::Omega, Owner::Body(b)) => return Some(self.page.sized(it(b).alpha?)),
            (Q::V, Owner::Spot(spot)) => {
                let away = less(&self.spot(spot), &self.centre(spot.body));
                let away = self.places(&away, END);
                let away =
                    blow.frame.as_ref().map_or(away.clone(), |f| [0, 1].map(|i| product(&away, &f[i])));
                let [x, y] = away.map(|x| x.expr());
                let spin = it(spot.body).alpha.map_or(ZERO, |w| self.unless_zero(w));
                let spin = in_sense(spin, f64::from(self.sense_of(spot.body)));
                let [a, b] = it(spot.body).a.map(|v| self.unless_zero(v));
                let name = self.scene.point_name(spot).map_or("P", |n| n.1);
                let names = ["v", "u"].map(|l| tagged(l, name));
                let own = ["v", "u"].map(|l| tagged(l, &format!("{name}{}", it(spot.body).tag)));
                (self.unused([names, own].concat()), length(a - y * &spin, b + x * spin))
            }
            (Q::KineticEnergy, _) => {
                return Some(self.page.find_once(&["E_s", r"E_{\mathrm{kin}}"], "J", blow.after.clone()));
            }
            _ => return None,
        };
        Some(self.page.find_once(&names, label.quantity.unit(), is))
    }
    /// A quantity, or 0 where it is that.
    fn unless_zero(&self, symbol: SymbolId) -> Expr {
        if self.symbols.value(symbol) == 0.0 { ZERO } else { symbol.into() }
    }
    /// Those of these names that no quantity bears yet.
    fn unused(&self, names: impl IntoIterator<Item = String>) -> Vec<String> {
        names.into_iter().filter(|name| self.symbols.named(&[name]).is_none()).collect()
    }
    /// The impulse of a joint, to the right or up where it has both.
    pub fn impulse_of(&mut self, blow: &Blow, joint: usize, quantity: Quantity) -> Option<SymbolId> {
        let own = blow.impulses.iter().filter(|(j, _)| *j == joint);
        let own: Vec<SymbolId> = own.map(|(_, symbol)| *symbol).collect();
        let i = usize::from(matches!(quantity, Quantity::ImpulseY | Quantity::FrictionImpulse));
        if !self.pivot.as_ref().is_some_and(|p| p.radial) {
            return own.get(i).copied();
        }
        // The place of the blow is that of the start.
        self.here = if self.scene.end == End::AtOnce { END } else { START };
        let shares = own.iter().zip(self.basis());
        let is = positive_first(shares.map(|(impulse, unit)| unit[i].times(*impulse).expr()));
        self.here = END;
        Some(self.page.find_once(&[["J_x", "S_x"], ["J_y", "S_y"]][i], "N s", is))
    }
}

/// Is it the angular velocity of a body after a blow?
fn bodies_turn(blow: &Blow, symbol: SymbolId) -> bool {
    blow.bodies.iter().any(|b| b.alpha == Some(symbol))
}

/// Is it an impulse of a joint?
pub const fn is_impulse(q: Quantity) -> bool {
    use Quantity::{FrictionImpulse, Impulse, ImpulseX, ImpulseY};
    matches!(q, Impulse | ImpulseX | ImpulseY | FrictionImpulse)
}
