//! Bodies that are joined in the plane, in symbols: where each joint places them, the velocities and accelerations that follow by
//! differentiation, all forces with their directions and levers, the balance of work, and the linear equations of one place.
//!
//! Where the bodies are, the number of an angle that the joints give, and what is integrated along the way are those of the key; the
//! numbers of the balance of work beside the asked place are those of that method.
use crate::figure::names;
use crate::num::{Jet, gauss, trig};
use crate::scene::pose::{self, Layout, Poses};
use crate::scene::{
    Acts, Coordinate, Degree, End, Joint, JointKind, Label, Num, Numbers, Owner, Place, Quantity, Rest,
    RotaryInertia, Spot, Straight, Strut, StrutEnd, Surface,
};
use crate::solution::account::{START_NAMES, of_body, stored};
use crate::solution::asked;
use crate::solution::blow::{Blow, is_impulse};
use crate::solution::draft::Draft;
use crate::solution::expr::{
    Expr, ONE, SymbolId, ZERO, cosine, in_sense, number, positive_first, ratio, root, signed, sine, square,
    sum,
};
use crate::solution::factors::{Cancel, Factors, Sum};
use crate::solution::page::{Page, Step, WITHIN};
use crate::solution::stop::{Beyond, DerivationStop, unfound};
use crate::solution::terms::{self, Carrying, tagged};
use crate::solution::written::width;
use crate::solve::energy;
use std::ops::Range;

/// The start, and the place that is asked.
pub const START: usize = 0;
/// See [`START`].
pub const END: usize = 1;
/// Below this share of the weights a force is rounding.
pub const ROUNDING: f64 = 1e-12;
/// Below this a component that is 0 is rounding, m.
pub const NOTHING: f64 = 1e-12;

/// What stands below the symbols of the two straight pieces of a cord over a pulley.
const PIECES: [&str; 2] = ["a", "b"];

/// To the right and up; of a point, its place by the symbols of all angles.
pub type Vector = [Sum; 2];

/// To the right and up.
fn axes() -> [Vector; 2] {
    [[1.0, 0.0], [0.0, 1.0]].map(|unit| unit.map(|x| Sum::of([sign(x)])))
}

/// An angle on which places depend.
#[derive(Debug, Clone)]
pub struct Turn {
    /// At the start and at the place that is asked, degrees.
    pub at: [Expr; 2],
    /// What stands for it in places: within a sine or cosine the angle, elsewhere how far it has turned, rad.
    angle: SymbolId,
    /// See there.
    way: SymbolId,
    /// Its rate, per unit rate of the leading one; 0 at an instant of rest.
    pub rate: [Expr; 2],
    /// The axis that turns by it.
    axis: Vector,
    /// What stands below its symbols.
    pub tag: String,
    /// The joint of a light rod or a cord, which is no body, and its length.
    pub link: Option<(usize, SymbolId)>,
    /// Is it no angle but a place along a guide, m?
    pub slides: bool,
}

fn plus(a: &Vector, b: &Vector) -> Vector {
    [a[0].plus(&b[0]), a[1].plus(&b[1])]
}
pub fn less(a: &Vector, b: &Vector) -> Vector {
    [a[0].less(&b[0]), a[1].less(&b[1])]
}
fn times(a: &Vector, by: &Factors) -> Vector {
    a.each_ref().map(|x| x.times(by))
}
/// So far along a direction.
fn along(way: &Sum, unit: &Vector) -> Vector {
    unit.each_ref().map(|x| way.by(x))
}
/// From the origin of an axis to the point at these distances along it and to its left.
fn from_axis(axis: &Vector, at: &[Factors; 2]) -> Vector {
    plus(&times(axis, &at[0]), &times(&left(axis), &at[1]))
}
/// From one point of a body to another, along its axis and to its left.
fn between(to: &[Factors; 2], from: &[Factors; 2]) -> [Factors; 2] {
    [0, 1].map(|i| to[i].plus(&from[i].opposite()))
}
/// A quarter turn to the left.
pub fn left(v: &Vector) -> Vector {
    [v[1].opposite(), v[0].clone()]
}
pub fn cross(a: &Vector, b: &Vector) -> Sum {
    a[0].by(&b[1]).less(&a[1].by(&b[0]))
}
/// `a . b`
pub fn product(a: &Vector, b: &Vector) -> Sum {
    a[0].by(&b[0]).plus(&a[1].by(&b[1]))
}

/// A cylinder on which a body is: the body's point, the radius there, the axis, the radius; from inside? Does it roll?
type LeadingArc = (Spot, Num, [Num; 2], Num, bool, bool);

/// One body.
#[derive(Debug, Clone)]
pub struct PlaneBody {
    /// Its name within a sentence.
    pub name: String,
    /// What stands below its symbols.
    pub tag: String,
    pub mass: Factors,
    /// Moment of inertia about the mass centre, as a sum.
    pub inertia: Vec<Factors>,
    /// Does its angle count clockwise?
    clockwise: bool,
    /// Distance of the mass centre from the origin of the axis.
    centre: Factors,
    /// Acceleration of the mass centre, to the right and up.
    pub a: [SymbolId; 2],
    /// Angular acceleration.
    pub alpha: Option<SymbolId>,
    /// Speed of the mass centre.
    pub v: SymbolId,
    /// Angular speed.
    pub omega: Option<SymbolId>,
    /// Where the origin of its axis is, and the angle of its axis.
    origin: Vector,
    pub turn: Option<usize>,
}

/// A force on a body, or a couple.
#[derive(Debug, Clone)]
pub struct Pull {
    pub body: usize,
    /// Its size: of a joint the unknown, or what is in proportion to it.
    pub size: Factors,
    /// Its direction.
    pub along: Vector,
    /// Its moment about the mass centre per size, counter-clockwise.
    pub turn: Sum,
}

impl Pull {
    /// A couple, counter-clockwise where the sense is 1.
    pub fn couple(body: usize, size: Factors, sense: i8) -> Self {
        Self { body, size, along: Vector::default(), turn: Sum::one(Factors::one().signed(sense)) }
    }
}

/// What a joint demands of the accelerations: the point of each of its forces stays, per unit of the unknown, but for what its
/// motion on a circle takes.
#[derive(Debug, Clone)]
pub struct Hold {
    pub joint: usize,
    pub unknown: SymbolId,
    pub pulls: Vec<Pull>,
    /// What the points accelerate toward the direction by their motion, per square of the leading rate.
    inward: Sum,
    /// What acceleration is given, of a drive.
    pub given: Expr,
}

impl Hold {
    fn of(joint: usize, unknown: SymbolId, pulls: Vec<Pull>) -> Self {
        Self { joint, unknown, pulls, inward: Sum::default(), given: ZERO }
    }
}

/// A single body that turns about one fixed pin: moments are taken about the pin, forces along the line to the mass centre and
/// across.
#[derive(Debug, Clone)]
pub struct Pivot {
    /// The name of the point, a formula.
    pub name: String,
    /// Distance from the pin to the mass centre.
    pub h: Factors,
    /// Moment of inertia about the mass centre.
    pub own: Expr,
    /// Moment of inertia about the pin.
    pub about: SymbolId,
    /// Force of the pin: toward it from the mass centre and across, or to the right and up.
    pub force: [SymbolId; 2],
    /// Are forces told toward the pin and across, positive with a growing angle?
    pub radial: bool,
    /// Does the angle count from upright?
    pub up: bool,
    /// The pin.
    place: Vector,
}

/// A scene of joined bodies as far as it is known.
pub struct Plane<'d, 'a> {
    /// The page, with the draft and what was found.
    pub page: Page<'d, 'a>,
    /// Index of the leading body.
    pub lead: usize,
    /// The angles; the first leads.
    pub turns: Vec<Turn>,
    pub bodies: Vec<PlaneBody>,
    /// All forces at the place that is asked, those of joints last.
    pub pulls: Vec<Pull>,
    pub holds: Vec<Hold>,
    /// The forces of the springs.
    pub springs: Vec<SymbolId>,
    /// The works of all forces that are known.
    pub works: Vec<Expr>,
    /// Friction of guides: joint, symbol, and what it is, positive up or to the right.
    pub frictions: Vec<(usize, SymbolId, Expr)>,
    /// The rate of the leading angle at the place that is asked, a magnitude.
    pub rate: SymbolId,
    /// That at the start.
    pub first: Expr,
    /// Sense in which the leading angle changes.
    pub sense: f64,
    /// The angle turned, in radians, signed, where a work needs it.
    turned: Option<SymbolId>,
    /// Letter of the leading angle.
    pub letter: String,
    /// Does anything move at the place that is asked?
    pub moves: bool,
    /// The speed of each mass centre per unit rate of the leading angle, once they have been told.
    speeds: Vec<Expr>,
    /// Does the lead move as no joint says?
    drifts: Option<Vector>,
    /// The speed at which parallel guides carry it.
    glides: Option<Expr>,
    open: bool,
    /// What ties the angles that the joints give, both sides.
    pub loops: Vec<[String; 2]>,
    /// The couple that drives the leading body.
    pub driver: Option<SymbolId>,
    /// The symbol of the inertia of the motion, where it has one.
    pub j: Option<SymbolId>,
    /// How many steps are those of the joints.
    pub placed: usize,
    /// Which are those of the forces.
    pub acted: Range<usize>,
    /// By how much mass centres sink.
    pub heights: Vec<SymbolId>,
    /// Components of unit vectors along springs and cords.
    pub units: Vec<SymbolId>,
    /// The pin of a single body.
    pub pivot: Option<Pivot>,
    /// The stiffness of small oscillations about equilibrium, by the angle.
    pub k: Option<SymbolId>,
    /// Ratio of the spin that is given at the start to the rate of the leading angle, where it is that of another body.
    pub spun: Option<SymbolId>,
    /// What blows at the start do.
    pub blow: Option<Blow>,
    /// Along the line on which points part in an impact, and across it, where it slants: the directions in which velocities are told.
    pub oblique: Option<[Vector; 2]>,
    /// The place of which forces are told: at the start for blows, else [`END`].
    pub here: usize,
    g: Expr,
    /// What carries it all.
    pub carrier: Option<Carrying>,
    /// `J` of `1/2 J q'^2`.
    pub moving: Sum,
}

stands_on!(Plane.page: Page<'d, 'a>);

impl<'d, 'a> Plane<'d, 'a> {
    /// Reads the scene.
    pub fn new(draft: &'d mut Draft<'a>) -> Result<Self, DerivationStop> {
        let Some(lead) = draft.scene.lead() else { return unfound() };
        if draft.scene.bodies.iter().any(|body| body.removed) {
            return Err(Beyond::Removed.into());
        }
        if draft.scene.tells_speeds() {
            return Err(Beyond::Speeds.into());
        }
        let still = draft.scene.is_still();
        let rests = still && draft.scene.start_speeds().next().is_none();
        let in_place = draft.scene.spins_in_place();
        let bodies = &draft.scene.bodies;
        // How a wheel rolls on a line or a cylinder that turns is not looked at while it moves.
        let beyond = |kind: &JointKind| {
            let turning = kind.carrier().is_some_and(|on| bodies[on.body].turns) && kind.rolls()[0];
            !rests && turning || !still && !in_place && kind.drum().is_some()
        };
        if draft.scene.joints.iter().any(|joint| beyond(&joint.kind)) {
            return Err(Beyond::Mechanism.into());
        }
        let g = terms::gravity(draft);
        let carrier = Carrying::of(draft);
        let mut page = Page::new(draft);
        let rate = page.unknown("?", "rad/s");
        let mut this = Self {
            page,
            lead,
            turns: Vec::new(),
            bodies: Vec::new(),
            pulls: Vec::new(),
            holds: Vec::new(),
            springs: Vec::new(),
            works: Vec::new(),
            frictions: Vec::new(),
            rate,
            first: ZERO,
            sense: 1.0,
            turned: None,
            letter: String::new(),
            moves: true,
            speeds: Vec::new(),
            drifts: None,
            glides: None,
            open: false,
            loops: Vec::new(),
            driver: None,
            j: None,
            placed: 0,
            acted: 0..0,
            heights: Vec::new(),
            units: Vec::new(),
            pivot: None,
            k: None,
            spun: None,
            blow: None,
            oblique: None,
            here: END,
            g,
            carrier,
            moving: Sum::default(),
        };
        if let Some((c, given)) = this.scene.start_speeds().next() {
            let (tex, unit) = START_NAMES[usize::from(c.degree == Degree::Turn)];
            this.first = this.number(given, tex, unit);
            // A speed that is told by its direction may let the leading angle fall.
            let numbers = this.numbers();
            let rate = Layout::new(this.scene, &numbers).and_then(|layout| layout.start_rate());
            if let (Degree::Along, Some(rate)) = (c.degree, rate) {
                let sense = rate * this.value(&this.first);
                this.first = in_sense(std::mem::replace(&mut this.first, ZERO), sense);
            }
        }
        let sets_off = this.scene.is_struck() || this.value(&this.first) != 0.0;
        this.moves = !this.scene.is_still() || sets_off;
        if this.gliding().is_some() {
            this.glides = Some(std::mem::replace(&mut this.first, ZERO));
        }
        this.read_bodies();
        this.start_from()?;
        this.place()?;
        if this.glides.is_some() {
            // Parallel guides let nothing turn.
            this.turns[0].rate = [ZERO, ZERO];
        }
        if let Some((Coordinate { body, degree: Degree::Along }, _)) = this.scene.start_speeds().next()
            && this.first != ZERO
        {
            let v = this.rates(&this.centre(body), START);
            this.first = this.first.over(product(&v, &v).rooted());
        }
        if let (Some(symbol), Some((c, _))) = (this.spun, this.scene.start_speeds().next())
            && let Some(turn) = this.bodies[c.body].turn
        {
            let from = this.turns[turn].rate[START].clone();
            this.steps.push(Step { symbol, from });
        }
        this.placed = this.steps.len();
        this.rate = match this.bodies[lead].omega.filter(|_| this.arc_of(this.lead).is_none()) {
            Some(omega) => omega,
            None => {
                let name = format!(r"\dot{{{}}}", this.letter);
                this.named(&[&name], "rad/s")
            }
        };
        this.find_pivot();
        if this.scene.is_struck() {
            this.strike()?;
            if this.scene.end == End::AtOnce {
                return Ok(this);
            }
        }
        if in_place && !still {
            // The angle follows from the acceleration.
            let (name, way) = (format!(r"\Delta {}", this.letter), this.way().abs());
            let turned = this.named(&[name], "rad");
            this.symbols.settle(turned, way, 0.0);
            this.turned = Some(turned);
        }
        let before = this.steps.len();
        this.act()?;
        this.acted = before..this.steps.len();
        this.hold();
        if let Some(alpha) = this.scene.driven() {
            this.drive(alpha);
        }
        this.let_drift();
        Ok(this)
    }

    /// The direction in which parallel guides carry the leading body.
    fn gliding(&self) -> Option<[f64; 2]> {
        Layout::new(self.scene, &self.numbers())?.glide()
    }

    /// The velocity at which parallel guides carry it, to the right (0) or up (1).
    fn glide_to(&mut self, i: usize) -> Option<Expr> {
        let (speed, [c, s]) = (self.glides.clone()?, self.gliding()?);
        let unit = match self.scene.joints.iter().find_map(|j| j.kind.line()) {
            Some(guide) => self.direction(guide.direction_deg),
            // It goes across the light rods or cords that hold it.
            None => left(&self.holds.first()?.pulls[0].along),
        };
        let [x, y] = unit.each_ref().map(|u| self.value(&u.expr()));
        Some(in_sense(unit[i].times(&speed).expr(), c * x + s * y))
    }
    /// Is it carried at a speed by parallel guides?
    pub fn carried_on(&self) -> bool {
        self.glides.as_ref().is_some_and(|speed| *speed != ZERO)
    }

    fn find_pivot(&mut self) {
        let (1, [joint], None) = (self.bodies.len(), &self.scene.joints[..], self.scene.driven()) else {
            return;
        };
        let JointKind::Pin { at, place_m } = joint.kind else { return };
        let [along, aside] = self.of_spot(at);
        let (it, place) = (self.bodies[0].clone(), self.ground(place_m));
        let h = it.centre.plus(&along.opposite());
        if !aside.is_zero() || it.alpha.is_none() || self.value(&h.expr()) <= 0.0 {
            return;
        }
        let own = sum(it.inertia.iter().map(Factors::expr));
        let about = &own + it.mass.expr() * square(h.expr());
        let name = self.scene.point_name(at).map_or("O", |names| names.1).to_owned();
        let own_name = |letter: &str| match name.len() {
            1 => format!("{letter}_{name}"),
            _ => tagged(letter, &name),
        };
        let about = self.page.find(&[&own_name("I"), &own_name("J")], "kg m^2", about);
        let radial = self.problem.cases[self.variant.case].scene.pinned().is_some();
        let plain = names::joint(self.scene, 0);
        let force = [["R", "O_r", "X"], ["S", "O_t", "Y"]].map(|[one, two, plane]| match radial {
            true => self.named(&[one, two], "N"),
            false => self.named(&[tagged(plane, &plain)], "N"),
        });
        self.j = Some(about);
        let up = self.value(&self.unturned_axis(0)[1].expr()) > 0.0;
        let name = format!("${name}$");
        self.pivot = Some(Pivot { name, h, own, about, force, radial, up, place });
    }

    /// The cylinder on which a body has its place by the leading angle.
    pub fn arc_of(&self, body: usize) -> Option<LeadingArc> {
        let mut leading = (0..self.scene.joints.len()).filter(|j| self.scene.leads_on_arc(*j));
        leading.find_map(|j| match self.scene.joints[j].kind {
            JointKind::Contact {
                at,
                radius_m,
                surface: Surface::Arc { centre_m, radius_m: arc, inside, .. },
                rolls,
                ..
            } if at.body == body => Some((at, radius_m, centre_m, arc, inside, rolls)),
            _ => None,
        })
    }

    /// The rate of the leading angle that goes with the spin or the speed that is given at the start: by the ratio of the key's places, where that is not 1. Of a speed that comes
    /// later, when all has its place.
    fn start_from(&mut self) -> Result<(), DerivationStop> {
        let turns = |c: &Coordinate| c.degree == Degree::Turn;
        let Some((c, _)) = self.scene.start_speeds().next().filter(|(c, _)| self.first != ZERO && turns(c))
        else {
            return Ok(());
        };
        let per = if c.body != self.lead {
            let Some(poses) = self.poses(0.0, true) else { return unfound() };
            let ratio = poses[c.body].turn().0 * f64::from(self.sense_of(c.body));
            let tag = format!("{},0", self.bodies[c.body].tag);
            let symbol = self.named(&[tagged("n", &tag), tagged("i", &tag)], "1");
            self.symbols.settle(symbol, ratio, 0.0);
            self.spun = Some(symbol);
            symbol.into()
        } else {
            match self.arc_of(self.lead) {
                Some(arc) => self.turning_of(arc).expr(),
                None => return Ok(()),
            }
        };
        self.first = self.first.over(&per);
        if self.value(&self.first).is_finite() { Ok(()) } else { unfound() }
    }
    /// The numbers of the scene.
    fn numbers(&self) -> Numbers<'_, f64> {
        Numbers::new(self.scene, &self.values)
    }
    /// Where all bodies are when the leading angle has changed by this, rad, in numbers.
    fn poses(&self, way: f64, at_start: bool) -> Option<Poses<Jet<f64>>> {
        Layout::new(self.scene, &self.numbers())?.poses::<Jet<f64>>(way, at_start)
    }

    fn read_bodies(&mut self) {
        let scene = self.scene;
        let tags = names::tags(self.problem, scene);
        let several = scene.bodies.len() > 1;
        let spins = scene.bodies.iter().filter(|b| b.turns).count() > 1;
        for (i, body) in scene.bodies.iter().enumerate() {
            let tag = if several { tags[i].clone() } else { String::new() };
            let own = if spins { tag.clone() } else { String::new() };
            let g = self.g.clone();
            let mass = terms::mass(self, body, &g, &tag);
            let inertia = terms::inertia(self, body, &mass, &g, &tag);
            let planar = body.planar.as_ref();
            let centre = planar.map_or(ZERO, |p| self.length(i, &tag, p.centre)).factors();
            let a = ["x", "y"].map(|way| {
                let below = terms::relative(self, &format!("{tag}{way}"));
                self.named(&[tagged("a", &below)], "m/s^2")
            });
            let named = |this: &mut Self, names: [&str; 2], unit| {
                body.turns.then(|| this.named(&names.map(|n| tagged(n, &own)), unit))
            };
            let alpha = named(self, [r"\alpha", r"\dot{\omega}"], "rad/s^2");
            let omega = named(self, [r"\omega", r"\Omega"], "rad/s");
            let below = terms::relative(self, if several { &tag } else { "G" });
            let v = self.named(&["v", "u"].map(|n| tagged(n, &below)), "m/s");
            let name = names::body_within(self.words, scene, i);
            self.bodies.push(PlaneBody {
                name,
                tag,
                mass,
                inertia,
                clockwise: planar.is_some_and(|p| p.clockwise),
                centre,
                a,
                alpha,
                v,
                omega,
                origin: Vector::default(),
                turn: None,
            });
        }
    }

    /// A distance along an axis.
    fn length(&mut self, body: usize, tag: &str, place: Place) -> Expr {
        let rod = match self.scene.bodies[body].inertia {
            Some(RotaryInertia::Shape(_, length)) => Some(length),
            _ => None,
        };
        let (Place::At(x) | Place::HalfOf(x)) = place;
        let name = tagged(if rod == Some(x) { "L" } else { "b" }, tag);
        let whole = self.symbol(x, &name, "m");
        if matches!(place, Place::At(_)) { whole } else { whole / number(2) }
    }
    /// A number, a formula of the bank in the symbols of its data.
    fn symbol(&mut self, num: Num, tex: &str, unit: &str) -> Expr {
        if let Num::Derived(i) = num
            && let Some(derived) = self.scene.formulas.numbers.get(i).filter(|d| !d.any && !d.degrees)
        {
            let found =
                asked::expression(self, &derived.formula, &|draft, given| Ok(asked::given_as(draft, given)));
            if let Ok(found) = found {
                return found;
            }
        }
        self.number(num, tex, unit)
    }
    /// Distances of a point from the origin of the axis, along it and to its left.
    fn of_spot(&mut self, spot: Spot) -> [Factors; 2] {
        let place = self.scene.planar(spot.body).and_then(|p| p.points.get(spot.point)).map(|p| p.1);
        let tag = self.bodies[spot.body].tag.clone();
        let place = place.unwrap_or([Place::At(Num::Fixed(0.0)); 2]);
        place.map(|p| self.length(spot.body, &tag, p).factors())
    }
    fn ground(&mut self, place: [Num; 2]) -> Vector {
        let [x, y] = [self.symbol(place[0], "x_0", "m"), self.symbol(place[1], "y_0", "m")];
        [x, y].map(|e| Sum::of(e.terms().iter().map(Factors::of)))
    }
    /// A unit vector along a direction.
    pub fn direction(&mut self, degrees: Num) -> Vector {
        if let Num::Fixed(x) = degrees
            && x % 90.0 == 0.0
        {
            let (s, c) = trig::sin_cos_of_degrees(x);
            return [c, s].map(|x| Sum::one(sign(x)));
        }
        let angle = self.number(degrees, r"\delta", "deg");
        [cosine(&angle), sine(angle)].map(Sum::one)
    }

    /// The direction of a line, which a body may carry.
    pub fn line(&mut self, line: Straight) -> Vector {
        let unit = self.direction(line.direction_deg);
        match line.on {
            Some(on) => self.turned_with(on.body, &unit, self.here),
            None => unit,
        }
    }
    /// A direction that counts from the axis of a body.
    fn turned_with(&mut self, body: usize, [c, s]: &Vector, which: usize) -> Vector {
        let axis = self.axis_of(body);
        let axis = self.places(&axis, which);
        plus(&along(c, &axis), &along(s, &left(&axis)))
    }

    // -- places ---------------------------------------------------------------------------------------------------------

    /// A new angle, by which the axis of a body turns from where it is at 0.
    fn add_turn(&mut self, body: usize, at: [Expr; 2], rate: [Expr; 2]) -> usize {
        let from = self.unturned_axis(body);
        self.push_turn(at, rate, from, self.sense_of(body), self.bodies[body].tag.clone())
    }
    fn push_turn(&mut self, at: [Expr; 2], rate: [Expr; 2], from: Vector, sense: i8, tag: String) -> usize {
        let [angle, way] = ["", ""].map(|name| self.unknown(name, "rad"));
        let [ahead, aside] = [cosine(angle), sine(angle)].map(Factors::from);
        let axis = from_axis(&from, &[ahead, aside.signed(sense)]);
        self.turns.push(Turn { at, angle, way, rate, axis, tag, link: None, slides: false });
        self.turns.len() - 1
    }
    /// From where the angle of a body counts.
    fn unturned_axis(&self, body: usize) -> Vector {
        let from = self.scene.planar(body).map_or([1.0, 0.0], |p| p.from.components());
        from.map(|x| Sum::one(sign(x)))
    }
    fn axis(&self, turn: usize) -> Vector {
        self.turns[turn].axis.clone()
    }
    fn axis_of(&self, body: usize) -> Vector {
        self.bodies[body].turn.map_or_else(|| self.unturned_axis(body), |turn| self.axis(turn))
    }
    fn point(&self, body: usize, at: &[Factors; 2]) -> Vector {
        plus(&self.bodies[body].origin, &from_axis(&self.axis_of(body), at))
    }
    pub fn centre(&self, body: usize) -> Vector {
        self.point(body, &[self.bodies[body].centre.clone(), Factors::zero()])
    }
    pub fn spot(&mut self, spot: Spot) -> Vector {
        let distance = self.of_spot(spot);
        self.point(spot.body, &distance)
    }
    /// With the angles as they are at the start or at the place that is asked.
    fn placed(&self, of: &Sum, which: usize) -> Sum {
        self.turns.iter().fold(of.clone(), |all, turn| all.put(turn.angle, &turn.at[which]))
    }
    /// A coordinate at the start or at the place that is asked.
    fn at(&mut self, of: &Sum, which: usize) -> Sum {
        let mut all = self.placed(of, which);
        for turn in self.turns.clone() {
            if all.terms().iter().any(|t| t.expr().uses().contains(&turn.way)) {
                let way = match which {
                    _ if turn.slides => turn.at[which].clone(),
                    START => ZERO,
                    // What rolls by rolling keeps its ratio to the leading wheel.
                    _ => self.turned().by(&turn.rate[END]),
                };
                all = all.put(turn.way, &way);
            }
        }
        all
    }
    /// By how much it grows on the way.
    fn change(&mut self, of: &Sum) -> Sum {
        self.at(of, END).less(&self.at(of, START))
    }
    /// Its derivative by the leading angle.
    fn derivative(&self, of: &Sum, which: usize) -> Sum {
        let turns = self.turns.iter().flat_map(|t| [(t.angle, &t.rate[which]), (t.way, &t.rate[which])]);
        let turns: Vec<(SymbolId, &Expr)> = turns.collect();
        let slopes = of.terms().iter().flat_map(|t| turns.iter().map(|(s, rate)| t.slope(*s).times(*rate)));
        slopes.sum()
    }
    /// Its rate, per unit rate of the leading angle.
    fn rate(&self, of: &Sum, which: usize) -> Sum {
        self.placed(&self.derivative(of, which), which)
    }
    /// What its second derivative has per square of the leading rate, of one leading angle alone.
    fn bend(&self, of: &Sum) -> Sum {
        self.rate(&self.derivative(of, END), END)
    }
    pub fn places(&mut self, point: &Vector, which: usize) -> Vector {
        point.each_ref().map(|x| self.at(x, which))
    }
    fn rates(&self, point: &Vector, which: usize) -> Vector {
        point.each_ref().map(|x| self.rate(x, which))
    }
    /// The directions in which forces are told, at the asked place: to the right and up; of a body on a pin toward the pin and
    /// across, with a growing angle.
    pub fn basis(&self) -> [Vector; 2] {
        if let Some(directions) = &self.oblique {
            return directions.clone();
        }
        if self.pivot.as_ref().is_some_and(|p| p.radial) {
            return self.circle();
        }
        axes()
    }
    /// Toward the pin from the mass centre, and across with a growing angle.
    fn circle(&self) -> [Vector; 2] {
        let axis = self.axis(0);
        let out = axis.each_ref().map(|x| self.placed(x, self.here));
        [out.map(|x| x.opposite()), self.rates(&axis, self.here)]
    }
    /// A vector, right and up, in these directions.
    pub fn frame(&self, v: &Vector) -> Vector {
        self.basis().map(|direction| product(v, &direction))
    }

    /// The angle that the leading body has turned, in radians with its sign.
    pub fn turned(&mut self) -> SymbolId {
        if let Some(turned) = self.turned {
            return turned;
        }
        let [first, last] = self.turns[0].at.clone();
        let (name, is) = (format!(r"\Delta {}", self.letter), self.draft.radians(last - first));
        let turned = self.page.find(&[&name], "rad", is);
        self.turned = Some(turned);
        turned
    }

    /// The point of a body that is held at a known place.
    fn held(&mut self, body: usize, placed: &[bool]) -> Option<([Factors; 2], Vector)> {
        let (own, place) = self.scene.joints.iter().find_map(|joint| match joint.kind {
            JointKind::Pin { at, place_m } if at.body == body => Some((at, self.ground(place_m))),
            _ => {
                let (own, other, _) = hinge_of(joint, body)?;
                placed[other.body].then(|| (own, self.spot(other)))
            }
        })?;
        Some((self.of_spot(own), place))
    }
    /// Points of a body that are guided, itself or by a slider that is hinged there: a place on the line and its direction.
    fn guided(&mut self, body: usize, placed: &[bool]) -> Vec<([Factors; 2], Vector, Vector)> {
        let scene = self.scene;
        let mut all = Vec::new();
        let fixed = scene.joints.iter().filter(|j| j.kind.carrier().is_none());
        for (at, radius_m, surface) in fixed.filter_map(|j| j.kind.surface()) {
            let Surface::Line(Straight { through_m, direction_deg, .. }) = surface else { continue };
            let (unit, radius) = (self.direction(direction_deg), self.number(radius_m, "r", "m"));
            let off = along(&Sum::one(&radius), &left(&unit));
            let through = plus(&self.ground(through_m), &off);
            let slider = |guided: Spot| {
                (!placed[guided.body]).then_some(())?;
                let slides =
                    |spot: Spot| spot == guided || spot.body == guided.body && !scene.bodies[spot.body].turns;
                let mut hinges = scene.joints.iter().filter_map(|j| hinge_of(j, body));
                hinges.find_map(|(own, other, _)| slides(other).then_some(own))
            };
            if let Some(own) = if at.body == body { Some(at) } else { slider(at) } {
                all.push((self.of_spot(own), through, unit));
            }
        }
        all
    }
    /// The line on which a body rolls: its centre along the axis, a place on the line, its direction, the radius.
    fn rolls(&mut self, body: usize) -> Option<([Factors; 2], Vector, Vector, Factors)> {
        let scene = self.scene;
        scene.joints.iter().find_map(|j| match j.kind {
            JointKind::Contact {
                at,
                radius_m,
                surface: Surface::Line(Straight { on: None, through_m, direction_deg }),
                rolls: true,
                ..
            } if at.body == body => Some((
                self.of_spot(at),
                self.ground(through_m),
                self.direction(direction_deg),
                self.number(radius_m, "r", "m").factors(),
            )),
            _ => None,
        })
    }
    /// The axis of the cylinder on which a body rolls or meshes, and how fast it turns per moment of its centre's speed about that axis.
    fn circles(&mut self, body: usize) -> Option<(Vector, Factors)> {
        let (_, own, centre, arc, inside, _) = self.arc_of(body).filter(|(.., rolls)| *rolls)?;
        let [own, arc] = self.radii(own, arc);
        let around = inside && self.value(&arc.expr()) < self.value(&own.expr());
        let sense = if inside == around { self.sense_of(body) } else { -self.sense_of(body) };
        let per = Factors::one().signed(sense).per(self.apart(&own, &arc, inside)).per(own);
        Some((self.ground(centre), per))
    }
    /// The radius of a wheel, and that of the cylinder that it touches.
    fn radii(&mut self, own: Num, arc: Num) -> [Factors; 2] {
        [(own, "r"), (arc, "R")].map(|(radius, name)| self.number(radius, name, "m").factors())
    }
    /// Distance of the centre of a wheel from the axis of the cylinder that it touches.
    fn apart(&self, own: &Factors, arc: &Factors, inside: bool) -> Factors {
        let gap = if inside { arc.plus(&own.opposite()) } else { arc.plus(own) };
        if self.value(&gap.expr()) < 0.0 { gap.opposite().upright(&self.symbols) } else { gap }
    }
    /// How far a wheel on a cylinder turns per angle of its centre.
    pub fn turning_of(&mut self, arc: LeadingArc) -> Factors {
        let (_, own, _, arc, inside, rolls) = arc;
        if !rolls {
            return Factors::zero();
        }
        let [own, arc] = self.radii(own, arc);
        if inside { own.plus(&arc.opposite()).per(&own) } else { arc.plus(&own).per(&own) }
    }

    /// The places of the key, at the start and where it is asked.
    fn both_poses(&self) -> Option<[Poses<Jet<f64>>; 2]> {
        Some([self.poses(0.0, true)?, self.poses(self.way(), self.scene.end == End::AtOnce)?])
    }

    /// The numbers of all angles, from the places of the key: at the start and at the place that is asked, degrees.
    fn angles(&self) -> Option<[Vec<f64>; 2]> {
        let angles = |poses: Poses<Jet<f64>>| -> Vec<f64> {
            let each = poses.iter().zip(&self.scene.bodies).map(|(pose, body)| {
                let turned = |p| pose::turned_from(p, pose.axis.map(|x| x.value), p.from.components());
                let angle = body.planar.as_ref().map_or(0.0, turned).to_degrees();
                // An angle that is 0 but for rounding.
                if angle.abs() < NOTHING { 0.0 } else { angle }
            });
            each.collect()
        };
        Some(self.both_poses()?.map(angles))
    }

    /// Light rods and cords that hold a body: the point, the fixed place, and the joint.
    fn links(&self, body: usize) -> Vec<(Spot, [Num; 2], usize)> {
        let joints = self.scene.joints.iter().enumerate();
        let links = joints.filter_map(|(j, joint)| match joint.kind {
            JointKind::Cord { at, place_m, .. } if at.body == body => Some((at, place_m, j)),
            // The point of a rod is held at the axis of a cylinder as by a rod that is as long as the radius.
            JointKind::Contact { at, surface: Surface::Arc { centre_m, .. }, rolls: false, .. }
                if at.body == body && !self.scene.leads_on_arc(j) =>
            {
                Some((at, centre_m, j))
            }
            _ => None,
        });
        links.collect()
    }
    /// The angle of a light rod or a cord, from its fixed place to the point that it holds, and its length: that at the start.
    fn link(&mut self, (at, place, joint): (Spot, [Num; 2], usize)) -> Option<(usize, Factors)> {
        let numbers = self.numbers();
        let ([x, y], own) = (pose::ground(&numbers, place), pose::of_spot(self.scene, &numbers, at));
        let degrees = self.both_poses()?.map(|poses| {
            let [u, w] = poses[at.body].point(own).map(|c| c.value);
            trig::atan2(w - y, u - x).to_degrees()
        });
        let plain = names::joint(self.scene, joint);
        let is = match self.scene.joints[joint].kind {
            JointKind::Contact { radius_m, surface: Surface::Arc { radius_m: arc, inside, .. }, .. } => {
                let [own, arc] = self.radii(radius_m, arc);
                self.apart(&own, &arc, inside).expr()
            }
            _ => {
                let apart = less(&self.spot(at), &self.ground(place));
                let apart = self.places(&apart, START);
                self.size(&apart)
            }
        };
        let length = match is {
            Expr::Symbol(radius) => radius,
            is => self.page.find(&[tagged(r"\ell", &plain)], "m", is),
        };
        let tag = if plain.is_empty() { r"\ell".to_owned() } else { plain };
        let at = self.free_angle(&tag, degrees, true);
        let [right, _] = axes();
        let turn = self.push_turn(at, [ONE, ONE], right, 1, tag);
        self.turns[turn].link = Some((joint, length));
        Some((turn, length.into()))
    }
    /// The angle of what leads this joint's point on a circle.
    fn linked(&self, joint: usize) -> Option<usize> {
        self.turns.iter().position(|t| t.link.is_some_and(|(of, _)| of == joint))
    }
    /// Places the leading body, whose angle is known, where a light rod or a cord holds it, and a guide or another one of them.
    fn place_on_links(&mut self, body: usize, axis: &Vector) -> Option<()> {
        let links = self.links(body);
        if let Some(place) = self.scene.planar(body)?.origin_m {
            self.bodies[body].origin = self.ground(place);
        }
        let first = *links.first()?;
        let (own, (turn, length)) = (self.of_spot(first.0), self.link(first)?);
        let second = links.get(1).map(|link| Some((*link, self.link(*link)?)));
        let held = times(&self.axis(turn), &length);
        let place = self.ground(first.1);
        self.put(body, &own, &plus(&place, &held));
        let reach = |to: [Factors; 2]| from_axis(axis, &between(&to, &own));
        if let Some(second) = second {
            let ((at, far, _), (other, length)) = second?;
            let apart = less(&plus(&place, &reach(self.of_spot(at))), &self.ground(far));
            let across = times(&self.axis(other), &length);
            self.close(&apart, (turn, &held), (other, &across));
            return Some(());
        }
        let (at, through, unit) = self.guided(body, &vec![false; self.bodies.len()]).into_iter().next()?;
        self.slide(turn, &plus(&place, &reach(at)), &held, (&through, &unit));
        Some(())
    }
    /// What goes on the way, with what the angle of its own adds to it, stays on a line: this ties the angle, and gives its rate.
    fn slide(&mut self, turn: usize, way: &Vector, own: &Vector, (through, unit): (&Vector, &Vector)) {
        let normal = left(unit);
        self.tie(&product(&plus(way, own), &normal), &product(through, &normal));
        self.keep_up(turn, [way, own], |_, _| (normal.clone(), Sum::default()));
    }
    /// Gives an angle its rate: what goes on the way, with what the angle adds to it, goes along a direction as fast as this says.
    fn keep_up(
        &mut self,
        turn: usize,
        [way, own]: [&Vector; 2],
        along: impl Fn(&mut Self, usize) -> (Vector, Sum),
    ) {
        self.ratio(turn, |this, which| {
            let (unit, speed) = along(this, which);
            let behind = speed.less(&product(&this.rates(way, which), &unit));
            behind.expr().over(product(&this.rates(own, which), &unit).expr())
        });
    }
    /// What goes on the way, with what one angle adds, meets what another one adds: this ties both, and gives their rates. Along one
    /// of the two rods the other end of that rod does not move it.
    fn close(&mut self, apart: &Vector, (first, one): (usize, &Vector), (second, two): (usize, &Vector)) {
        for line in &less(&plus(apart, one), two) {
            self.tie(line, &Sum::default());
        }
        for (turn, own, across, sense) in [(first, one, two, -1), (second, two, one, 1)] {
            self.ratio(turn, |this, which| {
                let across = this.places(across, which);
                let over = product(&this.rates(apart, which), &across);
                over.signed(sense).expr().over(product(&this.rates(own, which), &across).expr())
            });
        }
    }

    /// The change of the leading angle in degrees that the key has, with its sign.
    fn way_of_key(&self) -> Option<f64> {
        let numbers = self.numbers();
        let per_way = Layout::new(self.scene, &numbers)?.turned(1.0);
        let way = self.key(of_body(Quantity::Phi, self.lead))? / per_way;
        let [force, ..] = self.balance_after(0.0)?;
        let spin = self.value(&self.first) + energy::joined::rate_from_blows(self.scene, &numbers)?;
        let sense = if spin == 0.0 { force } else { spin };
        Some((way * sense.signum()).to_degrees())
    }
    /// Force, inertia and bend of the balance of work `J q'' + B q'^2 = Q` where the leading angle has changed by this, rad: as that
    /// method has them.
    pub fn balance_after(&self, way: f64) -> Option<[f64; 3]> {
        energy::joined::balance_after(self.scene, &self.numbers(), way)
    }
    /// By how much the leading angle has changed at the asked place, rad.
    pub fn way(&self) -> f64 {
        let [first, last] = self.turns[0].at.each_ref().map(|angle| self.value(angle));
        if self.scene.end == End::AtOnce { 0.0 } else { (last - first).to_radians() }
    }

    /// Places all bodies one after the other, as [`crate::scene::pose`] does.
    fn place(&mut self) -> Result<(), DerivationStop> {
        let mut placed = vec![false; self.scene.bodies.len()];
        self.place_lead()?;
        placed[self.lead] = true;
        let Some(angles) = self.angles() else { return unfound() };
        while placed.contains(&false) {
            let before = placed.clone();
            for body in 0..placed.len() {
                placed[body] = placed[body] || self.follow(body, &angles, &mut placed)?;
            }
            if placed == before {
                return unfound();
            }
        }
        Ok(())
    }

    /// Puts a body so that this point of it is at this place.
    fn put(&mut self, body: usize, at: &[Factors; 2], place: &Vector) {
        self.bodies[body].origin = less(place, &from_axis(&self.axis_of(body), at));
    }

    fn place_lead(&mut self) -> Result<(), DerivationStop> {
        let (scene, body) = (self.scene, self.lead);
        let Some(planar) = scene.planar(body) else { return unfound() };
        let tex = self.free(&[r"\phi", r"\theta", r"\varphi"]);
        let first = planar.start_deg.map_or(ZERO, |a| self.number(a, &format!("{tex}_0"), "deg"));
        let name = match (planar.start_deg, scene.end) {
            (Some(Num::Datum(i)), _) | (_, End::Angle(_, Num::Datum(i))) => {
                let own = self.problem.data[i].tex.split('_').next();
                own.filter(|t| t.starts_with('\\')).unwrap_or(&tex).to_owned()
            }
            _ => tex,
        };
        self.letter.clone_from(&name);
        let last = match scene.end {
            End::AtOnce => first.clone(),
            End::Angle(_, angle) => self.number(angle, &format!("{name}_1"), "deg"),
            _ => {
                let angle = self.value(&first) + self.way_of_key().ok_or(Beyond::Unfound)?;
                // One that is 0 but for rounding.
                let at = if angle.abs() < NOTHING { 0.0 } else { angle };
                let name = self.free(&[format!("{name}_1"), format!("{name}_2")]);
                let symbol = self.symbols.given(&name, f64::NAN, "", "", true);
                self.symbols.settle(symbol, at, 0.0);
                symbol.into()
            }
        };
        let change = self.value(&last) - self.value(&first);
        self.sense = if change == 0.0 { self.value(&self.first).signum() } else { change.signum() };
        let turn = self.add_turn(body, [first, last], [ONE, ONE]);
        if let Some(arc) = self.arc_of(self.lead) {
            self.place_on_arc(turn, arc);
            return Ok(());
        }
        self.bodies[body].turn = Some(turn);
        let axis = self.axis(turn);
        let none = vec![false; scene.bodies.len()];
        let held = self.held(body, &none);
        let rolls = if held.is_none() { self.rolls(body) } else { None };
        let origin = planar.origin_m.map(|place| self.ground(place));
        if let Some((at, through, unit, radius)) = rolls {
            let start = origin.map_or_else(Sum::default, |o| product(&less(&o, &through), &unit));
            let way = Sum::one(radius.times(self.turns[turn].way).signed(-self.sense_of(body)));
            let off = along(&Sum::one(&radius), &left(&unit));
            let centre = plus(&plus(&through, &along(&start.plus(&way), &unit)), &off);
            self.put(body, &at, &centre);
            return Ok(());
        }
        let links = self.links(body);
        // At an instant what hangs on cords or rods lies where it is placed.
        let after = scene.is_struck() && scene.end == End::AtOnce;
        let told = self.moves && self.glides.is_none() && !after || origin.is_none();
        if told && held.is_none() && !links.is_empty() {
            return self.place_on_links(body, &axis).ok_or(Beyond::Mechanism.into());
        }
        let guided = self.guided(body, &none);
        self.bodies[body].origin = match (held, &guided[..], origin) {
            (Some((at, place)), ..) => less(&place, &from_axis(&axis, &at)),
            (None, [one, other, ..], _) if one.2 != other.2 => {
                let row = |(at, through, unit): &([Factors; 2], Vector, Vector)| {
                    let normal = left(unit);
                    let right = product(&less(through, &from_axis(&axis, at)), &normal);
                    (normal, right)
                };
                let ((p, a), (q, b)) = (row(one), row(other));
                let one = Factors::one().per(cross(&p, &q).expr());
                let both = less(&along(&b, &p), &along(&a, &q));
                [both[1].opposite(), both[0].clone()].map(|x| x.times(&one))
            }
            (None, [(at, through, unit)], origin) => {
                // Nothing moves the mass centre along the line.
                self.open = scene.drifts().is_none();
                let placed = origin.is_some() && scene.end == End::AtOnce;
                let start = origin.map_or_else(Sum::default, |o| product(&less(&o, through), unit));
                let across = product(&from_axis(&axis, at), &left(unit)).opposite();
                // At an instant its axis begins where it is placed.
                let centre = product(&axis, unit).times(&self.bodies[body].centre);
                let ahead = if placed { start } else { start.less(&centre) };
                plus(through, &plus(&along(&ahead, unit), &along(&across, &left(unit))))
            }
            (None, _, Some(place)) if scene.end == End::AtOnce => {
                self.open = true;
                place
            }
            _ => return unfound(),
        };
        Ok(())
    }

    /// Places the leading body on the cylinder about whose axis its leading angle counts.
    fn place_on_arc(&mut self, turn: usize, arc: LeadingArc) {
        let (body, (at, own, middle, radius, inside, _)) = (self.lead, arc);
        let [own, radius] = self.radii(own, radius);
        let apart = self.apart(&own, &radius, inside);
        let centre = plus(&self.ground(middle), &times(&self.axis(turn), &apart));
        let by = self.turning_of(arc);
        self.bodies[body].turn = self.scene.bodies[body].turns.then(|| {
            let [first, last] = self.turns[turn].at.clone();
            let turned = if first == last { ZERO } else { (last - &first) * by.expr() };
            let last = &first + turned;
            self.add_turn(body, [first, last], [by.expr(), by.expr()])
        });
        let at = self.of_spot(at);
        self.put(body, &at, &centre);
    }

    /// Places a body beside those that have a place, if its joints do.
    fn follow(
        &mut self,
        body: usize,
        angles: &[Vec<f64>; 2],
        placed: &mut [bool],
    ) -> Result<bool, DerivationStop> {
        let scene = self.scene;
        let Some(planar) = scene.planar(body) else { return unfound() };
        let held = self.held(body, placed);
        let loose = scene.end == End::AtOnce && self.value(&self.first) == 0.0;
        let own = planar.origin_m.filter(|_| loose && held.is_none());
        let own = own.map(|place| ([Factors::zero(), Factors::zero()], self.ground(place)));
        // What is round and lies where it is placed has no angle.
        let start = planar.start_deg.or_else(|| own.is_some().then_some(Num::Fixed(0.0)));
        let known = held.or(own);
        if let (true, true, Some(start)) = (scene.bodies[body].turns, loose, start) {
            let start = self.number(start, r"\beta", "deg");
            self.open = true;
            self.bodies[body].turn = Some(self.add_turn(body, [start.clone(), start], [ZERO, ZERO]));
            known.iter().for_each(|(at, place)| self.put(body, at, place));
            return Ok(known.is_some());
        }
        if known.is_none() && (self.slotted(body, placed) || self.carried_by_wheel(body, placed)) {
            return Ok(true);
        }
        if known.is_none() && (self.rolls_between(body, placed, angles) || self.roped(body, placed)) {
            return Ok(true);
        }
        let Some((at, place)) = known else { return Ok(false) };
        if !scene.bodies[body].turns {
            self.put(body, &at, &place);
            return Ok(true);
        }
        if let Some(to) = self.welded(body, placed) {
            let Some(other) = self.bodies[to].turn else { return unfound() };
            let turn = self.free_turn(body, angles, false);
            let same = self.bodies[body].clockwise == self.bodies[to].clockwise;
            self.turns[turn].rate = self.turns[other].rate.clone().map(|r| signed(r, same));
            self.put(body, &at, &place);
            return Ok(true);
        }
        let (track, circle) = (self.rolls(body), self.circles(body));
        let guided = self.guided(body, placed).into_iter().next();
        let pair = self.pair(body, placed);
        if track.is_none() && circle.is_none() && guided.is_none() && pair.is_none() {
            let held = (&at, &place);
            if self.turns_in_slot(body, held, placed, angles)
                || self.turns_on_link(body, held, angles).is_some()
            {
                return Ok(true);
            }
            // What a surface or another body holds fast, as the lever of a brake, keeps the angle that the key has.
            let turns = |pose: &pose::Pose<Jet<f64>>| pose.turn().0.abs() > ROUNDING;
            let moves = self.both_poses().is_none_or(|poses| poses.iter().any(|all| turns(&all[body])));
            if moves {
                return Ok(false);
            }
            let turn = self.free_turn(body, angles, false);
            self.turns[turn].rate = [ZERO, ZERO];
            self.put(body, &at, &place);
            return Ok(true);
        }
        let turn = self.free_turn(body, angles, track.is_none() && circle.is_none());
        self.put(body, &at, &place);
        if let Some((_, _, unit, radius)) = track {
            self.ratio(turn, |this, which| {
                let ahead = this.rates(&place, which);
                let ahead = product(&ahead, &unit).times(Factors::one().per(&radius));
                if planar.clockwise { ahead.expr() } else { ahead.opposite().expr() }
            });
        } else if let Some((axis, per)) = circle {
            self.ratio(turn, |this, which| {
                let out = this.places(&less(&place, &axis), which);
                cross(&out, &this.rates(&place, which)).times(&per).expr()
            });
        } else if let Some((other, through, unit)) = guided {
            let own = from_axis(&self.axis(turn), &between(&other, &at));
            self.slide(turn, &place, &own, (&through, &unit));
        } else if let Some((own, other, far)) = pair {
            placed[other.body] = true;
            let own = between(&self.of_spot(own), &at);
            let second = self.free_turn(other.body, angles, true);
            let to = between(&self.of_spot(other), &far.0);
            self.put(other.body, &far.0, &far.1);
            let ends = [from_axis(&self.axis(turn), &own), from_axis(&self.axis(second), &to)];
            self.close(&less(&place, &far.1), (turn, &ends[0]), (second, &ends[1]));
        }
        Ok(true)
    }

    /// Places a body that is guided without turning, in whose slot a point of another body is, as a Scotch yoke.
    fn slotted(&mut self, body: usize, placed: &[bool]) -> bool {
        let slot = self.line_on(false, |at, on| on.body == body && placed[at.body]);
        let guided = self.guided(body, placed).into_iter().next();
        let (Some((at, radius, line, on)), Some((own, through, unit)), false) =
            (slot, guided, self.scene.bodies[body].turns)
        else {
            return false;
        };
        let normal = left(&self.line(line));
        let radius = Sum::one(self.number(radius, "r", "m"));
        let (point, on) = (self.spot(at), self.of_spot(on));
        let within = from_axis(&self.axis_of(body), &between(&own, &on));
        let apart = product(&plus(&less(&point, &through), &within), &normal).less(&radius);
        let per = Factors::one().per(product(&unit, &normal).expr());
        let place = plus(&through, &along(&apart.times(per), &unit));
        self.put(body, &own, &place);
        true
    }
    /// The line of a body on which a wheel rolls or a point slides: the wheel's centre, its radius, the line, a point of the body.
    fn line_on(
        &self,
        rolls: bool,
        which: impl Fn(Spot, Spot) -> bool,
    ) -> Option<(Spot, Num, Straight, Spot)> {
        let joints = self.scene.joints.iter().filter(|joint| joint.kind.rolls()[0] == rolls);
        joints.filter_map(|joint| joint.kind.surface()).find_map(|(at, radius, surface)| {
            let Surface::Line(line) = surface else { return None };
            let on = line.on.filter(|on| which(at, *on))?;
            Some((at, radius, line, on))
        })
    }
    /// Places a body without a turn that a wheel with a place carries along: a rack in its bed, a plank on rollers.
    fn carried_by_wheel(&mut self, body: usize, placed: &[bool]) -> bool {
        let wheel = self.line_on(true, |at, on| on.body == body && placed[at.body]);
        let (Some((at, radius, line, _)), false) = (wheel, self.scene.bodies[body].turns) else {
            return false;
        };
        let (Some(turn), line) = (self.bodies[at.body].turn, self.line(line)) else { return false };
        let guided = self.guided(body, placed).into_iter().next();
        let (own, through, unit) =
            guided.unwrap_or_else(|| ([Factors::zero(), Factors::zero()], Vector::default(), line.clone()));
        let centre = product(&self.spot(at), &unit);
        let first = self.at(&centre, START);
        let placed_at = self.scene.planar(body).and_then(|p| p.origin_m).map(|place| self.ground(place));
        let start = match placed_at {
            Some(origin) => plus(&origin, &from_axis(&self.axis_of(body), &own)),
            // It lies under the wheel.
            None => plus(&through, &along(&first.less(&product(&through, &unit)), &unit)),
        };
        let radius = self.number(radius, "r", "m").factors();
        let rolled = radius.times(self.turns[turn].way).signed(self.sense_of(at.body));
        let way = centre.less(&first).plus(&product(&line, &unit).times(rolled));
        self.put(body, &own, &plus(&start, &along(&way, &unit)));
        true
    }
    /// Places a wheel between two lines: it rolls on a fixed one and under a body with a place.
    fn rolls_between(&mut self, body: usize, placed: &[bool], angles: &[Vec<f64>; 2]) -> bool {
        let upper = self.line_on(true, |at, on| at.body == body && placed[on.body]);
        let place = self.scene.planar(body).and_then(|p| p.origin_m);
        let (Some((_, upper, line, on)), Some(place), Some((at, _, unit, lower))) =
            (upper, place, self.rolls(body))
        else {
            return false;
        };
        let turn = self.free_turn(body, angles, false);
        let (sense, upper) = (self.sense_of(body), self.number(upper, "r", "m").factors());
        let share = product(&self.line(line), &unit).expr();
        let per = lower.opposite().plus(&upper.times(share)).signed(sense);
        let carrier = self.spot(on);
        self.ratio(turn, |this, which| {
            product(&this.rates(&carrier, which), &unit).times(Factors::one().per(&per)).expr()
        });
        let way = Sum::one(lower.signed(-sense).times(self.turns[turn].way));
        let start = self.ground(place);
        let start = plus(&start, &from_axis(&self.axis_of(body), &at));
        self.put(body, &at, &plus(&start, &along(&way, &unit)));
        true
    }
    /// Places a body at the end of a cord that comes over a small pulley from one with a place, on the guide along which it slides.
    fn roped(&mut self, body: usize, placed: &[bool]) -> bool {
        let cord = self.scene.joints.iter().enumerate().find_map(|(j, joint)| {
            let JointKind::Cord { at, place_m, beyond: Some((far, from)), .. } = joint.kind else {
                return None;
            };
            let ends = [(at, place_m), (far, from)];
            let own = usize::from(at.body != body);
            let [one, other] = [ends[own], ends[1 - own]];
            (one.0.body == body && placed[other.0.body]).then_some((j, own, [one, other]))
        });
        let guided = self.guided(body, placed).into_iter().next();
        let (Some((j, first, ends)), Some((own, through, unit)), Some(poses)) =
            (cord, guided, self.both_poses())
        else {
            return false;
        };
        if self.scene.bodies[body].turns {
            return false;
        }
        let [x, y] = through.each_ref().map(|x| self.value(&x.expr()));
        let [c, s] = unit.each_ref().map(|u| self.value(&u.expr()));
        let offset = own.each_ref().map(|x| self.value(&x.expr()));
        let at = poses.map(|all| {
            let [u, w] = all[body].point(offset).map(|p| p.value);
            (u - x) * c + (w - y) * s
        });
        let tag = self.bodies[body].tag.clone();
        let at = self.at_places(at, |this, mark| this.named(&[tagged("s", &format!("{tag}{mark}"))], "m"));
        let turn = self.push_turn(at, [ONE, ONE], Vector::default(), 1, tag);
        self.turns[turn].slides = true;
        let own_way = along(&Sum::one(self.turns[turn].way), &unit);
        self.put(body, &own, &plus(&through, &own_way));
        // The lengths of both straight pieces, and their directions toward the pulley.
        let pieces = ends.map(|(spot, from)| less(&self.ground(from), &self.spot(spot)));
        let (mut lengths, plain) = (Vec::new(), names::joint(self.scene, j));
        for which in self.looked_at() {
            let own = [0, 1].map(|i| {
                let apart = self.places(&pieces[i], which);
                let is = self.size(&apart);
                let name = format!("{plain}{}{which}", PIECES[if i == 0 { first } else { 1 - first }]);
                self.named_by([r"\ell", "d"], &name, "m", is)
            });
            lengths.push(own);
        }
        if let [[a, b], [c, d]] = &lengths[..] {
            self.loops.push([a + b, c + d].map(|side| self.tex(&side)));
        }
        self.keep_up(turn, [&Vector::default(), &own_way], |this, which| {
            let own = &lengths[which.min(lengths.len() - 1)];
            let units =
                [0, 1].map(|i| this.places(&pieces[i], which).map(|x| x.times(Factors::one().per(&own[i]))));
            let speed = product(&units[1], &this.rates(&pieces[1], which));
            let [unit, _] = units;
            (unit, speed)
        });
        true
    }
    /// Turns a body that is held at a place so that a point of another one stays in its slot.
    fn turns_in_slot(
        &mut self,
        body: usize,
        (at, place): (&[Factors; 2], &Vector),
        placed: &[bool],
        angles: &[Vec<f64>; 2],
    ) -> bool {
        let slot = self.line_on(false, |at, on| on.body == body && placed[at.body]);
        let Some((guided, radius, line, on)) = slot else { return false };
        let turn = self.free_turn(body, angles, true);
        self.put(body, at, place);
        let (unit, radius) = (self.direction(line.direction_deg), self.number(radius, "r", "m"));
        let (point, through) = (self.spot(guided), self.spot(on));
        let apart = less(&point, &through);
        let normal = left(&self.turned_with(body, &unit, END));
        let across = product(&self.places(&apart, END), &normal).less(&Sum::one(&radius));
        let sides = across.sides();
        self.loops.push(sides.each_ref().map(|side| self.tex(side)));
        let (sense, within) = (self.sense_of(body), less(&through, place));
        self.ratio(turn, |this, which| {
            // Across the slot the point moves as the slot does there.
            let normal = left(&this.turned_with(body, &unit, which));
            let share = |this: &Self, p: &Vector| product(&this.rates(p, which), &normal);
            let moves = share(this, &point).less(&share(this, place));
            let swept = cross(&this.places(&apart, which), &normal).signed(sense);
            moves.expr().over(share(this, &within).plus(&swept).expr())
        });
        true
    }
    /// Turns a body that is held at a place as a light rod or a cord at another point of it lets it.
    fn turns_on_link(
        &mut self,
        body: usize,
        (at, place): (&[Factors; 2], &Vector),
        angles: &[Vec<f64>; 2],
    ) -> Option<()> {
        let of_cord =
            |joint: usize| matches!(self.scene.joints[joint].kind, JointKind::Cord { beyond: None, .. });
        let link = self.links(body).into_iter().find(|(.., joint)| of_cord(*joint))?;
        let turn = self.free_turn(body, angles, true);
        self.put(body, at, place);
        let (second, length) = self.link(link)?;
        let (to, far) = (self.of_spot(link.0), self.ground(link.1));
        let own = from_axis(&self.axis(turn), &between(&to, at));
        let across = times(&self.axis(second), &length);
        self.close(&less(place, &far), (turn, &own), (second, &across));
        Some(())
    }
    /// The body with a place to which this one is welded.
    fn welded(&self, body: usize, placed: &[bool]) -> Option<usize> {
        let hinges = self.scene.joints.iter().filter_map(|j| hinge_of(j, body));
        hinges.filter(|(.., welded)| *welded).map(|(_, to, _)| to.body).find(|to| placed[*to])
    }

    /// The other rod of a pair, where both are hinged, and where that one is held.
    fn pair(&mut self, body: usize, placed: &[bool]) -> Option<(Spot, Spot, ([Factors; 2], Vector))> {
        let scene = self.scene;
        let hinges = scene.joints.iter().filter_map(|j| hinge_of(j, body));
        let mut open = hinges.filter(|(_, to, _)| !placed[to.body] && scene.bodies[to.body].turns);
        open.find_map(|(own, other, _)| Some((own, other, self.held(other.body, placed)?)))
    }

    /// The angle of a body that its joints give; its own rate is 1 until it is known.
    fn free_turn(&mut self, body: usize, angles: &[Vec<f64>; 2], closes: bool) -> usize {
        let tag = self.bodies[body].tag.clone();
        let at = self.free_angle(&tag, angles.each_ref().map(|all| all[body]), closes);
        let turn = self.add_turn(body, at, [ONE, ONE]);
        self.bodies[body].turn = Some(turn);
        turn
    }
    /// A new angle, at the start and at the asked place, by the next letter.
    fn free_angle(&mut self, tag: &str, degrees: [f64; 2], closes: bool) -> [Expr; 2] {
        let letters = [r"\beta", r"\gamma", r"\psi", r"\chi"];
        let letters: Vec<&str> = letters.into_iter().skip(self.turns.len().saturating_sub(1)).collect();
        let tex = if letters.is_empty() { tagged(r"\psi", tag) } else { self.free(&letters) };
        // One that lies along the direction from which it counts, and closes no loop, needs no letter.
        if !closes && degrees[self.looked_at()].iter().all(|at| at.abs() < NOTHING.to_degrees()) {
            return [ZERO, ZERO];
        }
        self.at_places(degrees, |this, mark| this.symbols.given(&tagged(&tex, mark), f64::NAN, "", "", true))
    }
    /// A quantity with these values at the start and at the asked place, each with a symbol; at an instant with one.
    fn at_places(&mut self, values: [f64; 2], named: impl Fn(&mut Self, &str) -> SymbolId) -> [Expr; 2] {
        let mut at = self.looked_at().map(|which| {
            let symbol = named(self, if self.scene.end == End::AtOnce { "" } else { ["0", "1"][which] });
            self.symbols.settle(symbol, values[which], 0.0);
            Expr::from(symbol)
        });
        let first = at.next().unwrap_or(ZERO);
        let last = at.next().unwrap_or_else(|| first.clone());
        [first, last]
    }
    fn tie(&mut self, line: &Sum, right: &Sum) {
        let sides = self.at(line, END).less(&self.at(right, END)).sides();
        let sides = sides.each_ref().map(|side| self.tex(side));
        self.loops.push(sides);
    }
    /// Gives an angle its rate, as a ratio that has a name; at the start without one.
    fn ratio(&mut self, turn: usize, of: impl Fn(&mut Self, usize) -> Expr) {
        self.turns[turn].rate[START] = if self.first == ZERO { ZERO } else { of(self, START) };
        let is = of(self, END);
        if matches!(is, Expr::Number(..)) {
            self.turns[turn].rate[END] = is;
            return;
        }
        // In a dead centre it does not turn.
        if self.value(&is).abs() < ROUNDING {
            self.turns[turn].rate[END] = ZERO;
            return;
        }
        let tag = self.turns[turn].tag.clone();
        self.turns[turn].rate[END] = self.named_by(["n", "i"], &tag, "1", is);
    }

    // -- forces ---------------------------------------------------------------------------------------------------------

    /// From the point about which moments are taken to a point of a body, right and up.
    fn lever(&mut self, body: usize, point: &Vector) -> Vector {
        let about = self.pivot.as_ref().map_or_else(|| self.centre(body), |p| p.place.clone());
        self.places(&less(point, &about), self.here)
    }
    /// A force at a point of a body, along a direction of [`Self::frame`].
    fn pull(&mut self, body: usize, point: &Vector, size: Factors, along: Vector) -> Pull {
        let lever = self.lever(body, point);
        // Toward the pin and across is a frame of the other hand where the angle grows counter-clockwise.
        let hand = if self.pivot.as_ref().is_some_and(|p| p.radial) { -self.sense_of(body) } else { 1 };
        let turn = cross(&self.frame(&lever), &along).signed(hand);
        Pull { body, size, along, turn }
    }

    /// A known force at a point of a body.
    pub fn add_pull(&mut self, body: usize, point: &Vector, size: Factors, along: Vector) {
        let pull = self.pull(body, point, size, along);
        self.pulls.push(pull);
    }

    /// Weights, forces, couples and springs, with their works.
    fn act(&mut self) -> Result<(), DerivationStop> {
        let scene = self.scene;
        let still = scene.end == End::AtOnce;
        self.weigh();
        for (i, push) in scene.pushes.iter().enumerate().filter(|(_, p)| !p.blow) {
            let size = self.number(push.force_n, "P", "N").factors();
            if let Some(place) = push.toward_m {
                self.pull_toward(push.at, place, &size, &one_of(scene.pushes.len(), i));
                continue;
            }
            let unit = self.direction(push.direction_deg);
            let along = if push.turns { self.turned_with(push.at.body, &unit, END) } else { unit.clone() };
            let (point, along) = (self.spot(push.at), self.frame(&along));
            let pull = self.pull(push.at.body, &point, size.clone(), along);
            let moment = pull.turn.times(size.signed(self.sense_of(push.at.body))).expr();
            self.pulls.push(pull);
            let work = match (push.turns, &self.pivot) {
                _ if still => continue,
                // About a fixed pin its moment stays what it is.
                (true, Some(_)) => moment.by(self.turned()),
                (true, None) => {
                    let work = self.turning_work(push);
                    let symbol = self.named(&[r"W_{P}", r"A_{P}"], "J");
                    self.symbols.settle(symbol, work, 0.0);
                    self.page.step(symbol, symbol.into()).into()
                }
                (false, _) => {
                    let line = product(&self.spot(push.at), &unit);
                    size.by(self.change(&line).expr())
                }
            };
            self.works.push(work);
        }
        for (i, couple) in scene.couples.iter().enumerate() {
            let size = self.number(couple.moment_n_m, "M", "N m").factors();
            let own = if couple.forward { 1 } else { -1 };
            let sense = own * self.sense_of(couple.body);
            self.pulls.push(Pull::couple(couple.body, size.clone(), sense));
            if !still {
                let turned = if self.bodies[couple.body].turn == Some(0) {
                    self.turned()
                } else {
                    let Some(turn) = self.bodies[couple.body].turn else { return unfound() };
                    let [first, last] = self.turns[turn].at.clone();
                    let is = self.draft.radians(last - first);
                    self.page.find(&[tagged(r"\Delta\psi", &i.to_string())], "rad", is)
                };
                self.works.push(size.signed(own).by(turned));
            }
        }
        for strut in 0..scene.struts.len() {
            self.spring(strut)?;
        }
        self.works.retain(|w| *w != ZERO);
        Ok(())
    }

    /// Weights, and the apparent forces of what is carried: in proportion to the mass, against a direction.
    fn weigh(&mut self) {
        let [_, up] = axes();
        let up = (self.g.clone(), up, self.bodies.len() > 1);
        let carrier = self.carrier.iter().filter(|c| c.acceleration != ZERO);
        let carried = carrier.map(|c| (c.acceleration.clone(), c.direction.each_ref().map(Sum::one), false));
        let fields: Vec<_> = (!self.scene.lies_level()).then_some(up).into_iter().chain(carried).collect();
        for (rate, unit, named) in fields {
            for body in 0..self.bodies.len() {
                let (force, centre) = (self.bodies[body].mass.times(&rate), self.centre(body));
                let against = self.frame(&unit.each_ref().map(|x| x.opposite()));
                self.add_pull(body, &centre, force.clone(), against);
                if self.scene.end == End::AtOnce {
                    continue;
                }
                let way = product(&centre, &unit);
                let back = self.at(&way, START).less(&self.at(&way, END)).expr();
                // A body that is guided along a level does not sink, though its place is told by angles.
                if self.value(&back).abs() > NOTHING {
                    let tag = self.bodies[body].tag.clone();
                    let back = if named { self.named_by(["h", "H"], &tag, "m", back) } else { back };
                    self.heights.extend(back.uses().into_iter().filter(|_| named));
                    self.works.push(force.by(&back));
                }
            }
        }
    }

    /// The work of a force that turns with its body.
    fn turning_work(&self, push: &crate::scene::Push) -> f64 {
        let data = &self.variant.data;
        let numbers = Numbers::<f64>::new(self.scene, data);
        let Some(layout) = Layout::new(self.scene, &numbers) else { return f64::NAN };
        let [c, s] = pose::direction(&numbers, push.direction_deg);
        let power = |at: f64| -> Result<f64, DerivationStop> {
            let poses = layout.poses::<Jet<f64>>(at, false).ok_or(Beyond::Unfound)?;
            let pose = &poses[push.at.body];
            let [x, y] = pose.axis.map(|x| x.value);
            let v = pose.point(pose::of_spot(self.scene, &numbers, push.at)).map(|x| x.first);
            Ok((x * c - y * s) * v[0] + (y * c + x * s) * v[1])
        };
        self.scene.value(push.force_n, data)
            * gauss::short().integral(power, (0.0, self.way()), 0.0).unwrap_or(f64::NAN)
    }

    /// A force that is directed to a place at all times: its work is that over the length by which it comes nearer.
    fn pull_toward(&mut self, at: Spot, place: [Num; 2], size: &Factors, tag: &str) {
        let near = self.spot(at);
        let apart = less(&self.ground(place), &near);
        let (mut lengths, mut last): (Vec<Expr>, _) = (Vec::new(), Vector::default());
        for which in self.looked_at() {
            last = self.places(&apart, which);
            let is = self.size(&last);
            lengths.push(self.named_by(["l", "b"], &format!("{which}{tag}"), "m", is));
        }
        let last = self.frame(&last);
        let along = self.unit(&last, &lengths[lengths.len() - 1], ["n", "u"], tag);
        self.add_pull(at.body, &near, size.clone(), along);
        if let [first, last] = lengths.as_slice() {
            self.works.push(size.by(first - last));
        }
    }

    fn spring(&mut self, strut: usize) -> Result<(), DerivationStop> {
        let scene = self.scene;
        let it = &scene.struts[strut];
        let tag = one_of(scene.struts.len(), strut);
        if it.twists() {
            return self.torsion(it, &tag);
        }
        let near = self.spot(it.at);
        let far = match it.to {
            StrutEnd::Ground(place) => self.ground(place),
            StrutEnd::Spot(spot) => self.spot(spot),
            StrutEnd::Twist => near.clone(),
            StrutEnd::Guide { through_m, direction_deg } => {
                let (through, unit) = (self.ground(through_m), self.direction(direction_deg));
                plus(&through, &along(&product(&less(&near, &through), &unit), &unit))
            }
        };
        let apart = less(&far, &near);
        let stiffness = self.number(it.stiffness_n_m, "k_s", "N/m");
        let (rest, given) = match it.rest {
            Rest::Length(l) => (self.number(l, "l_0", "m"), false),
            Rest::Stretch(x) => (self.number(x, "x_0", "m"), true),
        };
        let [s, x] = self.letters(&tag, given);
        let (mut lengths, mut stretch): (Vec<Expr>, Vec<Expr>) = (Vec::new(), Vec::new());
        let mut last = Vector::default();
        for which in self.looked_at() {
            last = self.places(&apart, which);
            let is = self.size(&last);
            let length: Expr = self.named_by([s; 2], &format!("{which}{tag}"), "m", is);
            let named = |this: &mut Self, is| this.named_by([x; 2], &format!("{which}{tag}"), "m", is);
            stretch.push(match (given, lengths.first()) {
                (false, _) => named(self, &length - &rest),
                (true, Some(first)) => named(self, &rest + &length - first),
                (true, None) => rest.clone(),
            });
            lengths.push(length);
        }
        for x in &mut stretch {
            let beyond = self.value(x);
            if it.acts == Acts::Pushes && beyond >= 0.0 || it.acts == Acts::Pulls && beyond <= 0.0 {
                *x = ZERO;
            }
        }
        let names = if tag.is_empty() { "F_s".to_owned() } else { tagged("F", &format!("s{tag}")) };
        let names = [names, tagged("F", &format!(r"\mathrm{{s}}{tag}"))];
        let force = self.pull_of_spring(&stiffness, &stretch, names, "N");
        let last = self.frame(&last);
        let along = self.unit(&last, &lengths[lengths.len() - 1], ["c", "e"], &tag);
        let back = along.clone().map(|x| x.opposite());
        self.add_pull(it.at.body, &near, force.factors(), along);
        if let StrutEnd::Spot(spot) = it.to {
            self.add_pull(spot.body, &far, force.factors(), back);
        }
        Ok(())
    }

    /// The letters of a spring's length and of its stretch, which no datum bears with the index of a place.
    pub fn letters(&self, tag: &str, given: bool) -> [&'static str; 2] {
        let free = |letter: &str, first: usize| {
            let names = self.looked_at().skip(first).map(|which| tagged(letter, &format!("{which}{tag}")));
            names.into_iter().all(|name| self.free(&[&name]) == name)
        };
        let pick = |[one, other]: [&'static str; 2], first| if free(one, first) { one } else { other };
        [pick(["s", "d"], 0), pick(["x", r"\xi"], usize::from(given))]
    }
    /// The places that a spring is looked at: the start and the end, of an instant this alone.
    fn looked_at(&self) -> std::ops::RangeInclusive<usize> {
        if self.scene.end == End::AtOnce { END..=END } else { START..=END }
    }

    /// The force or moment of a spring that is stretched or wound by this much, which does work on the way.
    fn pull_of_spring(
        &mut self,
        stiffness: &Expr,
        stretch: &[Expr],
        names: [String; 2],
        unit: &str,
    ) -> SymbolId {
        if let [first, last] = stretch {
            self.works.push(stored(stiffness, first, last));
        }
        let force = self.page.find(&names, unit, stiffness * &stretch[stretch.len() - 1]);
        self.springs.push(force);
        force
    }

    /// A torsion spring: its work, and its moment against the angle by which it is wound.
    fn torsion(&mut self, it: &Strut, tag: &str) -> Result<(), DerivationStop> {
        let Some(turn) = self.bodies[it.at.body].turn else { return unfound() };
        let angles = self.turns[turn].at.clone();
        let stiffness = self.number(it.stiffness_n_m, "k_t", "N m/rad");
        let (Rest::Length(rest) | Rest::Stretch(rest)) = it.rest;
        let rest = self.number(rest, r"\beta_0", "deg");
        let mut wound: Vec<Expr> = Vec::new();
        for which in self.looked_at() {
            let angle: Expr = match it.rest {
                Rest::Length(_) => angles[which].clone() - &rest,
                Rest::Stretch(_) if wound.is_empty() => rest.clone(),
                Rest::Stretch(_) => &rest + &angles[which] - &angles[START],
            };
            let is = self.draft.radians(angle);
            wound.push(self.named_by([r"\vartheta", r"\epsilon"], &format!("{which}{tag}"), "rad", is));
        }
        let names = [tagged("M", &format!(r"\mathrm{{s}}{tag}")), tagged("M", "t")];
        let moment = self.pull_of_spring(&stiffness, &wound, names, "N m");
        let back = -self.sense_of(it.at.body);
        self.pulls.push(Pull::couple(it.at.body, moment.factors(), back));
        Ok(())
    }

    /// A new quantity by the first of these letters that is free with this below it.
    fn named_by(&mut self, letters: [&str; 2], below: &str, unit: &str, is: Expr) -> Expr {
        self.page.find(&letters.map(|l| tagged(l, below)), unit, is).into()
    }
    /// The length of a vector.
    fn size(&self, of: &Vector) -> Expr {
        match (of[0].is_zero(), of[1].is_zero()) {
            (true, _) => self.positive(&of[1].expr()),
            (_, true) => self.positive(&of[0].expr()),
            _ => {
                let (legs, law) = (square(of[0].expr()) + square(of[1].expr()), product(of, of).expr());
                match law {
                    Expr::Power(side, 2) => self.positive(&side),
                    law if width(&self.tex(&law)) < width(&self.tex(&legs)) => root(law),
                    _ => root(legs),
                }
            }
        }
    }

    /// A unit vector along a vector of this length: its components have names where there are two.
    fn unit(&mut self, apart: &Vector, length: &Expr, names: [&str; 2], tag: &str) -> Vector {
        let small = [0, 1].map(|i| self.value(&apart[i].expr()).abs() < NOTHING);
        [0, 1].map(|i| match small {
            _ if small[i] => Sum::default(),
            [false, false] => {
                let radial = self.pivot.as_ref().is_some_and(|p| p.radial);
                let way = if radial { ["r", "t"][i] } else { ["x", "y"][i] };
                let share = match apart[i].terms() {
                    [one] => one.per(length).expr(),
                    _ => apart[i].expr() / length,
                };
                let symbol = self.named_by(names, &format!("{way}{tag}"), "1", share);
                self.units.extend(symbol.uses());
                Sum::one(symbol)
            }
            _ => Sum::one(sign(self.value(&apart[i].expr()))),
        })
    }

    /// The forces of the joints, and what each demands.
    pub fn hold(&mut self) {
        let scene = self.scene;
        let blow = scene.is_struck() && self.blow.is_none();
        for (j, joint) in scene.joints.iter().enumerate() {
            let plain = names::joint(scene, j);
            // The letter of a force; impulses differ by what stands below.
            let named = |this: &mut Self, force: &str, below: &str| {
                let name = if blow { tagged("J", &format!("{plain}{below}")) } else { tagged(force, &plain) };
                this.named(&[name], if blow { "N s" } else { "N" })
            };
            match joint.kind {
                JointKind::Pin { .. } | JointKind::Hinge { .. } => {
                    let ends = || joint.kind.spots().zip([1, -1]);
                    let forces = match &self.pivot {
                        Some(pivot) if !blow => pivot.force,
                        Some(pivot) => {
                            let names = if pivot.radial { ["J_r", "J_t"] } else { ["J_x", "J_y"] };
                            names.map(|name| self.named(&[name], "N s"))
                        }
                        None => [["X", "x"], ["Y", "y"]].map(|[force, below]| named(self, force, below)),
                    };
                    for (force, u) in forces.into_iter().zip(axes()) {
                        let u = if self.oblique.is_some() { self.frame(&u) } else { u };
                        let along = |sense: i8| u.each_ref().map(|x| x.signed(sense));
                        let ends: Vec<_> = ends().map(|(spot, sense)| (spot, along(sense))).collect();
                        self.add_hold(j, force, &ends, &[]);
                    }
                    if let JointKind::Hinge { turned_deg: Some(_), .. } = joint.kind {
                        let couple = self.named(&[tagged("M", &plain)], "N m");
                        let on = |sense, body| Pull::couple(body, couple.factors(), sense);
                        let both = ends().map(|(spot, sense)| on(sense, spot.body));
                        self.holds.push(Hold::of(j, couple, both.collect()));
                    }
                }
                JointKind::Guide { .. } => {
                    let normal = named(self, "N", "");
                    self.touch(j, [Some(normal), None]);
                }
                JointKind::Contact { rolls, teeth, .. } => {
                    // Teeth press along the rim alone.
                    let normal = (!teeth).then(|| named(self, "N", "n"));
                    let friction = rolls.then(|| named(self, "F", "t"));
                    self.touch(j, [normal, friction]);
                }
                JointKind::Cord { at, place_m, beyond, .. } => {
                    let force = named(self, "T", "");
                    let ends = [(at, place_m)].into_iter().chain(beyond);
                    let ends: Vec<(Spot, Vector, Factors)> =
                        ends.enumerate().map(|(i, end)| self.pulled_by_cord(j, end, i)).collect();
                    let toward: Vec<Factors> = ends.iter().map(|(.., toward)| toward.clone()).collect();
                    let ends: Vec<_> = ends.into_iter().map(|(spot, along, _)| (spot, along)).collect();
                    self.add_hold(j, force, &ends, &toward);
                }
            }
        }
    }

    /// An end of a cord or a light rod: its direction from there, and 1 over its length.
    fn pulled_by_cord(
        &mut self,
        joint: usize,
        (at, place): (Spot, [Num; 2]),
        end: usize,
    ) -> (Spot, Vector, Factors) {
        let over = matches!(self.scene.joints[joint].kind, JointKind::Cord { beyond: Some(_), .. });
        let plain = format!("{}{}", names::joint(self.scene, joint), if over { PIECES[end] } else { "" });
        let apart = match self.linked(joint) {
            Some(turn) => {
                let length = self.turns[turn].link.map_or(ZERO, |(_, length)| length.into());
                times(&self.axis(turn), &(-length).into())
            }
            None => less(&self.ground(place), &self.spot(at)),
        };
        let apart = self.places(&apart, self.here);
        let is = self.size(&apart);
        let length: Expr = match is {
            Expr::Symbol(s) => s.into(),
            is => self.page.find_once(&[tagged(r"\ell", &plain)], "m", is).into(),
        };
        let tag = if plain.is_empty() { plain } else { format!(",{plain}") };
        let along = self.unit(&apart, &length, ["u", "w"], &tag);
        (at, self.frame(&along), Factors::one().per(&length))
    }

    /// The couple that gives the leading body its angular acceleration.
    fn drive(&mut self, alpha: Num) {
        let given = self.number(alpha, r"\alpha_0", "rad/s^2");
        let unknown = self.named(&[r"M_{\mathrm{d}}", r"M_{\mathrm{dr}}"], "N m");
        let pull = Pull::couple(self.lead, unknown.factors(), self.sense_of(self.lead));
        self.driver = Some(unknown);
        self.holds.push(Hold { given, ..Hold::of(usize::MAX, unknown, vec![pull]) });
    }

    /// A wheel or a point on a surface.
    fn touch(&mut self, joint: usize, [press, grip]: [Option<SymbolId>; 2]) {
        let kind = self.scene.joints[joint].kind;
        let Some((at, radius_m, surface)) = kind.surface() else { return };
        let own = self.number(radius_m, "r", "m").factors();
        let (normal, bend, radius): (Vector, Option<Factors>, Factors) = match surface {
            Surface::Line(line) => (left(&self.line(line)), None, own),
            Surface::Arc { centre_m, radius_m: arc, inside, .. } => {
                let arc = self.number(arc, "R", "m").factors();
                let apart = self.apart(&own, &arc, inside);
                let out = match self.linked(joint) {
                    Some(turn) => times(&self.axis(turn), &apart),
                    None => less(&self.spot(at), &self.ground(centre_m)),
                };
                let out = self.places(&out, self.here);
                let sense = Factors::one().signed(if inside { -1 } else { 1 });
                let turned = inside && self.value(&arc.expr()) < self.value(&own.expr());
                let radius = if turned { own.opposite() } else { own };
                (times(&out, &sense.per(&apart)), Some(sense.per(&apart).opposite()), radius)
            }
        };
        let right = [normal[1].clone(), normal[0].opposite()];
        let upward = pose::upward(right.each_ref().map(|x| self.value(&x.expr())));
        let right = self.frame(&right);
        if let Some(force) = press {
            let normal = self.frame(&normal);
            self.add_hold(joint, force, &[(at, normal)], bend.as_slice());
        }
        if let Some(force) = grip {
            // Friction is told up the surface; teeth press along the rim alone.
            let sense = if press.is_some() && upward < 0.0 { -1 } else { 1 };
            let along = right.each_ref().map(|x| x.signed(sense));
            self.add_hold(joint, force, &[(at, along)], &[]);
            let pulls = self.at_the_rim((joint, at), &force.into(), &right, &radius, sense);
            self.holds.last_mut().into_iter().for_each(|hold| hold.pulls.clone_from(&pulls));
        }
        if let (Some(mu), Some(normal)) = (kind.mu_k(), press) {
            self.rub((joint, at), (&right, upward), (mu, &radius), normal);
        }
    }

    /// A force along the surface at the rim of a wheel of this radius, and its opposite on what bears it.
    fn at_the_rim(
        &mut self,
        (joint, at): (usize, Spot),
        size: &Factors,
        right: &Vector,
        radius: &Factors,
        sense: i8,
    ) -> Vec<Pull> {
        let own = (at.body, self.spot(at), radius.signed(sense), sense);
        let other = self.borne(joint, at);
        let other = other.map(|(on, point, rim)| (on.body, point, rim.signed(-sense), -sense));
        let both = [own].into_iter().chain(other).map(|(body, point, rim, sense)| {
            let along = right.each_ref().map(|x| x.signed(sense));
            let pull = self.pull(body, &point, size.clone(), along);
            Pull { turn: pull.turn.plus(&Sum::one(rim)), ..pull }
        });
        both.collect()
    }

    /// What bears the opposite of a force on this point: a point of that body in the line of what presses, and how far below it a force
    /// along the surface acts. What presses on a cylinder goes through its axis.
    fn borne(&mut self, joint: usize, at: Spot) -> Option<(Spot, Vector, Factors)> {
        let kind = self.scene.joints[joint].kind;
        let on = kind.bearer()?;
        let (_, radius, surface) = kind.surface()?;
        Some(match surface {
            Surface::Line(_) => (on, self.spot(at), self.number(radius, "r", "m").factors()),
            Surface::Arc { radius_m: arc, inside, .. } => {
                let rim = self.number(arc, "R", "m").factors();
                (on, self.spot(on), rim.signed(if inside { 1 } else { -1 }))
            }
        })
    }

    fn add_hold(&mut self, joint: usize, force: SymbolId, ends: &[(Spot, Vector)], toward: &[Factors]) {
        let (mut inward, mut given) = (Sum::default(), ZERO);
        let mut pulls = Vec::new();
        for (i, (spot, u)) in ends.iter().enumerate() {
            let point = self.spot(*spot);
            pulls.push(self.pull(spot.body, &point, force.factors(), u.clone()));
            if !self.moves {
                continue;
            }
            let lever = self.lever(spot.body, &point);
            let spin = self.spin(spot.body);
            inward = inward.plus(&product(u, &lever).times(square(&spin)));
            if let Some(toward) = toward.get(i) {
                let v = self.rates(&point, END);
                // Along a cord that runs over a pulley it moves as well.
                let across =
                    if ends.len() > 1 { Sum::one(square(cross(u, &v).expr())) } else { product(&v, &v) };
                inward = inward.plus(&across.times(toward));
                given =
                    self.glides.as_ref().map_or(ZERO, |speed| toward.times(speed.factors().squared()).expr());
            }
        }
        if let [(at, u)] = ends
            && let Some((on, point, _)) = self.borne(joint, *at)
        {
            let back = u.each_ref().map(|x| x.signed(-1));
            if self.moves && self.scene.joints[joint].kind.carrier().is_some() {
                // The line turns: what is on it has the acceleration of its place there, and that of Coriolis.
                let (lever, spin) = (self.lever(on.body, &point), self.spin(on.body));
                let v = self.rates(&less(&point, &self.centre(on.body)), END);
                let spun = left(&lever).map(|x| x.times(&spin).signed(self.sense_of(on.body)));
                let along = [u[1].clone(), u[0].opposite()];
                let slides = product(&less(&v, &spun), &along);
                inward = inward.plus(&product(&back, &lever).times(square(&spin)));
                let twice = spin.by(number(2)).factors().signed(self.sense_of(on.body));
                inward = inward.plus(&slides.times(twice));
            }
            pulls.push(self.pull(on.body, &point, force.factors(), back));
        }
        self.holds.push(Hold { joint, unknown: force, pulls, inward, given });
    }

    /// Friction of a guide, or at the rim of a wheel of this radius, against the sense in which it slides: as the key has it.
    fn rub(
        &mut self,
        (joint, at): (usize, Spot),
        (right, up): (&Vector, f64),
        (mu, radius): (Num, &Factors),
        normal: SymbolId,
    ) {
        let mu = self.number(mu, r"\mu_k", "1");
        let key = |quantity| self.key(Label { quantity, of: Owner::Joint(joint) });
        let (rubs, presses) = (key(Quantity::Friction).unwrap_or(0.0), key(Quantity::Normal));
        // Where guides carry it, as it goes.
        let carried = self.gliding().zip(self.glides.as_ref()).map_or(0.0, |([c, s], speed)| {
            -self.value(speed) * (c * self.value(&right[0].expr()) + s * self.value(&right[1].expr()))
        });
        let way = if carried == 0.0 { rubs * up * presses.map_or(1.0, f64::signum) } else { carried };
        let sense = if way < 0.0 { -1 } else { 1 };
        let pulls = self.at_the_rim((joint, at), &mu.by(normal).into(), right, radius, sense);
        self.pulls.extend(pulls);
        let name = tagged("F", &names::joint(self.scene, joint));
        let force = self.named(&[&name], "N");
        self.frictions.push((joint, force, in_sense(mu * normal, f64::from(sense) * up)));
    }

    /// The angular velocity of a body per unit rate of the leading angle, as its own angle counts.
    pub fn spin(&self, body: usize) -> Expr {
        match self.bodies[body].turn {
            Some(turn) if self.scene.bodies[body].turns => self.turns[turn].rate[END].clone(),
            _ => ZERO,
        }
    }
    pub fn sense_of(&self, body: usize) -> i8 {
        if self.bodies[body].clockwise { -1 } else { 1 }
    }

    /// All forces on a body.
    pub fn on(&self, body: usize) -> impl Iterator<Item = &Pull> {
        let joints = self.holds.iter().flat_map(|h| &h.pulls);
        joints.chain(&self.pulls).filter(move |p| p.body == body)
    }
    /// The forces of the joints.
    pub fn reactions(&self) -> Vec<SymbolId> {
        self.holds.iter().map(|h| h.unknown).collect()
    }
    /// What is not known of the accelerations; in equilibrium there are none.
    pub fn accelerations(&self) -> Vec<SymbolId> {
        let free = self.pivot.is_none();
        let moving = self.bodies.iter().filter(|_| self.scene.end != End::Equilibrium);
        moving.flat_map(|b| b.a.into_iter().filter(|_| free).chain(b.alpha)).collect()
    }
    /// The acceleration of the mass centre of a body on a pin, toward the pin and across.
    fn on_circle(&self, pivot: &Pivot) -> [Expr; 2] {
        let rate = if self.moves { square(self.rate) } else { ZERO };
        [pivot.h.by(rate), self.bodies[0].alpha.map_or(ZERO, |alpha| pivot.h.by(alpha))]
    }
    /// The same to the right (0) or up (1).
    fn component(&self, pivot: &Pivot, i: usize) -> Expr {
        let ([rate, alpha], [toward, across]) = (self.on_circle(pivot), self.circle());
        toward[i].times(rate).plus(&across[i].times(alpha)).expr()
    }

    /// The equations of motion of a body, both sides.
    pub fn equations(&self, body: usize) -> Vec<(Expr, Expr)> {
        let it = &self.bodies[body];
        let mut all = Vec::new();
        let a = match &self.pivot {
            None => it.a.map(Expr::from),
            Some(pivot) if pivot.radial => self.on_circle(pivot),
            Some(pivot) => [0, 1].map(|i| self.component(pivot, i)),
        };
        for (i, a) in a.into_iter().enumerate() {
            let left = self.on(body).map(|p| p.size.each(&p.along[i]).expr());
            all.push((positive_first(left), it.mass.by(a)));
        }
        if let Some(alpha) = it.alpha {
            let moments = |which: &dyn Fn(&Pull) -> bool| {
                let each = self.on(body).filter(|p| which(p));
                each.map(|p| p.size.signed(self.sense_of(body)).each(&p.turn)).sum::<Sum>().expr()
            };
            let couple = |p: &Pull| p.along.iter().all(Sum::is_zero);
            let of_spring = |p: &Pull| p.size.expr().uses().iter().any(|s| self.springs.contains(s));
            // About a pin the spring's moment stands by itself.
            let apart = |p: &Pull| self.pivot.is_some() && of_spring(p) && !couple(p);
            let left = [moments(&couple), moments(&|p| apart(p)), moments(&|p| !couple(p) && !apart(p))];
            let left = positive_first(left);
            match &self.pivot {
                Some(pivot) => all.insert(0, (left, pivot.about * alpha)),
                None => all.push((left, sum(it.inertia.iter().map(|i| i.by(alpha))))),
            }
        }
        if self.scene.end == End::Equilibrium {
            all.iter_mut().for_each(|(_, right)| *right = ZERO);
        }
        all
    }
    /// What the joints demand of the accelerations, both sides.
    pub fn demands(&self) -> Vec<(Expr, Expr)> {
        let none = self.pivot.is_some() || self.scene.end == End::Equilibrium;
        let each = self.holds.iter().filter(|_| !none).map(|h| {
            let mut left = Vec::new();
            for pull in &h.pulls {
                let it = &self.bodies[pull.body];
                left.extend([0, 1].map(|i| pull.along[i].times(it.a[i]).expr()));
                left.extend(it.alpha.map(|a| pull.turn.signed(self.sense_of(pull.body)).times(a).expr()));
            }
            let rate = if self.moves { h.inward.times(square(self.rate)).expr() } else { ZERO };
            (positive_first(left), rate + &h.given)
        });
        each.collect()
    }

    /// Solves the equations of motion and the demands of the joints together; gives every unknown its value.
    pub fn solve(&mut self) -> Result<(), DerivationStop> {
        let mut equations: Vec<(Expr, Expr)> =
            (0..self.bodies.len()).flat_map(|b| self.equations(b)).collect();
        if let (Some(pivot), Some(alpha)) = (self.pivot.clone(), self.bodies[0].alpha) {
            // Moments about the pin have one unknown, and each of the others one more.
            let still = self.scene.end == End::Equilibrium;
            let own = [alpha, pivot.force[0], pivot.force[1]].into_iter().zip(equations);
            for (symbol, row) in own.skip(usize::from(still)) {
                let is =
                    if symbol == alpha { Some(row.0.over(pivot.about)) } else { self.isolated(&row, symbol) };
                self.page.step(symbol, is.ok_or(DerivationStop::Beyond(Beyond::Unfound))?);
            }
            return Ok(());
        }
        equations.extend(self.demands());
        let rates = self.accelerations();
        let unknowns = [rates.clone(), self.reactions()].concat();
        let weights: f64 = self.bodies.iter().map(|b| self.value(&b.mass.by(&self.g))).sum();
        let (rates, g) = (rates.len(), self.value(&self.g));
        self.page.settle_all(&equations, &unknowns, |i| ROUNDING * if i < rates { g } else { weights })
    }

    /// The moments, or what is left of all equations when the forces of the joints have been eliminated, of a single body in
    /// equilibrium.
    pub fn balanced(&mut self) -> Option<Expr> {
        match self.pivot {
            Some(_) => Some(self.equations(0).swap_remove(0).0),
            None => self.eliminated().map(|[power, _]| power.expr()),
        }
    }
    /// By how much less the forces turn the bodies per angle beside the equilibrium, N m/rad: the slope of the moments on a single
    /// body, else the curvature of the potential energy along the way of the joints.
    pub fn stiffness(&mut self) -> Option<SymbolId> {
        let k = self.named(&[r"k_{\varphi}", r"k_{\psi}"], "N m");
        if self.bodies.len() > 1 || self.turns.iter().any(|turn| turn.link.is_some()) {
            let less = self.softening()?;
            self.symbols.settle(k, less, 0.0);
        } else {
            let all = self.balanced()?;
            let angle = self.turns[0].at[END].uses().first().copied()?;
            let half = self.symbols.given(r"180^\circ", 180.0, "180", "", true);
            let per = half / self.draft.pi();
            let slope = (-self.page.expanded(&all).slope(angle, &per)).terms();
            self.page.step(k, Sum::of(slope.iter().map(Factors::of)).expr());
        }
        self.k = Some(k);
        Some(k)
    }
    /// By how much less the force of the balance is per angle at the asked place: central differences, exact up to the eighth power of
    /// the step.
    fn softening(&self) -> Option<f64> {
        const STEP: f64 = 0.035;
        const SHARES: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
        let force = |steps: f64| self.balance_after(self.way() + steps * STEP).map(|[force, ..]| force);
        let mut less = 0.0;
        for (steps, share) in [1.0, 2.0, 3.0, 4.0].into_iter().zip(SHARES) {
            less += share * (force(-steps)? - force(steps)?) / STEP;
        }
        Some(less)
    }

    /// What the equations give one after the other: each from one in which it is the only unknown.
    pub fn unravel(&mut self) {
        let mut open = [self.accelerations(), self.reactions()].concat();
        open.retain(|s| !self.symbols.value(*s).is_nan());
        let rows = self.rows_in_order(false);
        let found = self.page.untangle(rows, &mut open, false);
        self.page.follow(&found);
    }

    /// At an instant, the velocities that go with a turn of a single body that its joints do not place, where each force of a joint
    /// is along one of the axes: across to all forces it is left where it is.
    fn let_drift(&mut self) {
        if !self.open || self.moves || self.bodies.len() > 1 || self.bodies[0].turn != Some(0) {
            return;
        }
        let mut v = [Sum::default(), Sum::default()];
        for (i, v) in v.iter_mut().enumerate() {
            let holds: Vec<&Hold> = self.holds.iter().filter(|h| !h.pulls[0].along[i].is_zero()).collect();
            let pulled = self.pulls.iter().any(|p| !p.along[i].is_zero());
            *v = match holds[..] {
                [] if !pulled => Sum::default(),
                [hold] if hold.pulls[0].along[1 - i].is_zero() => {
                    let pull = &hold.pulls[0];
                    pull.turn.times(Factors::one().per(pull.along[i].expr())).signed(-self.sense_of(0))
                }
                _ => return,
            };
        }
        self.drifts = Some(v);
    }

    // -- what follows ---------------------------------------------------------------------------------------------------

    /// Speed of a point per unit rate of the leading angle, as it is written: without a radical where there is none.
    fn speed(&self, point: &Vector, unit: Option<&Vector>) -> Expr {
        let v = self.rates(point, END);
        let is = match (unit, v[0].is_zero(), v[1].is_zero()) {
            (Some(unit), ..) => product(&v, unit).expr(),
            (None, true, _) => v[1].expr(),
            (None, false, true) => v[0].expr(),
            (None, false, false) => {
                let is = product(&v, &v).rooted();
                // What rounding leaves of a point that stands still may be below 0.
                let sound = !self.value(&is).is_nan();
                if sound { is } else { root(square(v[0].expr()) + square(v[1].expr())) }
            }
        };
        let sense = self.value(&is);
        in_sense(is, sense)
    }
    /// The line along which a joint guides a body that does not turn.
    fn line_of(&mut self, body: usize) -> Option<Vector> {
        let own = |j: &&Joint| j.kind.surface().is_some_and(|(at, ..)| at.body == body);
        let mut lines = self.scene.joints.iter().filter(own).filter_map(|j| j.kind.line());
        let line = lines.next().filter(|_| !self.scene.bodies[body].turns)?;
        Some(self.direction(line.direction_deg))
    }
    /// The speed of each mass centre per unit rate of the leading angle; those that are sums have a name.
    pub fn speeds(&mut self) -> Vec<Expr> {
        if !self.speeds.is_empty() {
            return self.speeds.clone();
        }
        let mut all = Vec::new();
        for body in 0..self.bodies.len() {
            let centre = self.centre(body);
            let line = self.line_of(body);
            let is = self.speed(&centre, line.as_ref());
            let plain = if self.bodies.len() == 1 { width(&self.tex(&is)) <= WITHIN } else { !sums(&is) };
            let is = if plain {
                is
            } else {
                let tag = self.bodies[body].tag.clone();
                self.named_by(["e", "c"], &tag, "m", is)
            };
            all.push(is);
        }
        self.speeds.clone_from(&all);
        all
    }
    /// The inertia of the motion, `J` in `1/2 J q'^2`, with these speeds of the mass centres.
    pub fn inertia(&self, speeds: &[Expr]) -> Sum {
        let each = self.bodies.iter().enumerate().map(|(b, it)| {
            let centre = self.centre(b);
            let v = self.drifts.clone().unwrap_or_else(|| self.rates(&centre, END));
            let named = |speed: &&Expr| self.bodies.len() > 1 || matches!(speed, Expr::Symbol(_));
            let own = speeds.get(b).filter(named).map_or_else(|| product(&v, &v), |v| Sum::one(square(v)));
            it.mass.each(&own).plus(&self.turning(b))
        });
        each.sum()
    }
    /// The same, by its symbol where it has one.
    fn whole_inertia(&mut self) -> Expr {
        let speeds = self.speeds();
        self.j.map_or_else(|| self.inertia(&speeds).expr(), Expr::from)
    }
    /// Share of the rotation about the mass centre of a body in [`Self::inertia`].
    fn turning(&self, body: usize) -> Sum {
        let spin = square(self.positive(&self.spin(body)));
        self.bodies[body].inertia.iter().map(|i| i.times(&spin)).collect()
    }
    /// Share of the rotation about the mass centres in the kinetic energy.
    pub fn rotation(&self) -> Sum {
        (0..self.bodies.len()).map(|body| self.turning(body)).sum()
    }
    /// Of a single body, what is left when the forces of the joints are eliminated, `J q'' = Q - B q'^2`: `Q` and `B`.
    pub fn eliminated(&mut self) -> Option<[Sum; 2]> {
        let ([it], None) = (&self.bodies[..], &self.pivot) else { return None };
        let (mass, centre) = (it.mass.clone(), self.centre(0));
        // Three forces of joints hold a body fast.
        let fast = self.holds.len() > 2 || !self.lengths().is_empty();
        if fast || self.driver.is_some() || !self.frictions.is_empty() || self.open && self.drifts.is_none() {
            return None;
        }
        let (free, v) = (self.drifts.is_some(), self.drifts.clone());
        let v = v.unwrap_or_else(|| self.rates(&centre, END));
        let bends = [self.bend(&centre[0]), self.bend(&centre[1])];
        let bend = if free || !self.moves { Sum::default() } else { product(&v, &bends).times(&mass) };
        let spin = self.spin(0).factors().signed(self.sense_of(0));
        let powers =
            self.pulls.iter().map(|p| p.size.each(&product(&p.along, &v).plus(&p.turn.times(&spin))));
        Some([powers.sum(), bend])
    }

    /// Where a single body leaves what pushes it: both sides of the equation of motion along that force, which is 0, with the
    /// square of the leading rate, and by (E) the wave of the angle that this gives; `j` is the inertia of the motion.
    pub fn leaving(&mut self, joint: usize, j: &Expr) -> Option<[Expr; 4]> {
        let symbol = self.turns[0].at[END].uses().first().copied()?;
        let unit = self.holds.iter().find(|h| h.joint == joint)?.pulls[0].along.clone();
        let [power, curve] = self.eliminated()?;
        let (mass, centre) = (self.bodies[0].mass.clone(), self.centre(0));
        let ahead = product(&unit, &self.rates(&centre, END));
        let bends = product(&unit, &[self.bend(&centre[0]), self.bend(&centre[1])]).times(&mass);
        let ahead = if self.value(&ahead.expr()).abs() < NOTHING { Sum::default() } else { ahead };
        let ahead = ahead.times(mass.per(j));
        let given: Sum = self.pulls.iter().map(|p| product(&p.along, &unit).times(&p.size)).sum();
        // The other joints may not push along this force.
        let others = self.holds.iter().filter(|h| h.joint != joint).map(|h| &h.pulls[0].along);
        if others
            .map(|u| self.value(&product(u, &unit).expr()).abs())
            .any(|share| share.is_nan() || share > NOTHING)
        {
            return None;
        }
        let by_rate = bends.less(&ahead.by(&curve));
        let by_rest = ahead.by(&power).less(&given);
        let squared = square(&self.first) + sum(self.works.iter().map(|w| w.by(number(2)).over(j)));
        let spread = |sum: &Sum, by: &Expr| {
            let all: Sum = by.terms().into_iter().map(|b| sum.times(&b)).sum();
            all.terms().iter().flat_map(|t| t.spread(symbol)).collect::<Vec<_>>()
        };
        let rest = spread(&by_rest, &ONE);
        let shared = |all: [Vec<Factors>; 2]| Sum::of(all.concat()).primitive(&[]);
        let [plus, minus] = shared([spread(&by_rate, &square(self.rate)), rest.clone()]).sides();
        let whole = shared([spread(&by_rate, &squared), rest]);
        let whole = sum(whole.terms().iter().map(Factors::expr));
        let waves = [cosine(symbol), sine(symbol)];
        let (wave, is) =
            waves.into_iter().find_map(|w| Some((w.clone(), self.isolated(&(whole.clone(), ZERO), w)?)))?;
        let closed = !self.page.expanded(&is).uses().contains(&symbol);
        closed.then_some([plus, minus, wave, is])
    }

    /// The quantity of a label once the place that is asked is solved.
    pub fn get(&mut self, label: Label) -> Result<SymbolId, DerivationStop> {
        use Quantity as Q;
        if let Some(known) = self.value_for(label) {
            return Ok(known);
        }
        if let Some(found) = self.of_pivot(label)? {
            return Ok(found);
        }
        let none = || DerivationStop::Beyond(Beyond::Quantity(label.quantity));
        let key = self.key(label);
        let rate = if self.moves { self.rate.into() } else { ZERO };
        let letters = |letters: [&str; 2], tag: &str| letters.map(|l| tagged(l, tag));
        let i = usize::from(matches!(label.quantity, Q::AY | Q::VY));
        let glides = self.glide_to(i);
        let carried = self.glides.as_ref().map(|speed| self.positive(speed));
        let way = |b: usize| format!("{}{}", self.bodies[b].tag, ["x", "y"][i]);
        let still = matches!(label.quantity, Q::V | Q::VX | Q::VY | Q::KineticEnergy) && !self.moves;
        let (names, is) = match (label.quantity, label.of) {
            _ if still => (["v_0", "u_0"].map(str::to_owned), ZERO),
            (Q::Omega, Owner::Body(b)) => {
                let omega = self.bodies[b].omega.ok_or_else(none)?;
                if omega != self.rate {
                    let is = self.spin(b).by(&rate);
                    let is = in_sense(is.clone(), self.value(&is));
                    self.page.step(omega, is);
                }
                return Ok(omega);
            }
            (Q::Alpha, Owner::Body(b)) => return self.bodies[b].alpha.ok_or_else(none),
            (Q::AX | Q::AY, Owner::Body(b)) => {
                let a = self.bodies[b].a[i];
                if let Some(pivot) = &self.pivot {
                    let is = self.component(pivot, i);
                    self.page.step(a, is);
                }
                let with = self.carrier.as_ref().map_or(ZERO, |c| &c.acceleration * c.direction[i].clone());
                if with == ZERO {
                    return Ok(a);
                }
                ([tagged("a", &way(b)), tagged("b", "x")], a + with)
            }
            (Q::V, Owner::Body(b)) => {
                let per = || self.speeds.get(b).cloned().unwrap_or_else(|| self.speed(&self.centre(b), None));
                let is = carried.unwrap_or_else(|| per().by(&rate));
                return Ok(self.page.step(self.bodies[b].v, is));
            }
            (Q::V, Owner::Spot(spot)) => {
                let point = self.spot(spot);
                let is = carried.unwrap_or_else(|| self.speed(&point, None).by(&rate));
                let name = self.scene.point_name(spot).map_or("P", |n| n.1);
                let known = self.symbols.named(&[tagged("v", name)]).is_some();
                let tag = if known { self.bodies[spot.body].tag.as_str() } else { "" };
                let tag = format!("{name}{tag}");
                (letters(["v", "u"], &tag), is)
            }
            (Q::VX | Q::VY, Owner::Body(b)) => {
                let line = self.centre(b)[i].clone();
                let turning = || in_sense(self.rate(&line, END).expr(), self.sense).by(&rate);
                let is = glides.unwrap_or_else(turning);
                (letters(["v", "u"], &way(b)), is)
            }
            (Q::Rise, Owner::Body(b)) => {
                let [_, y] = self.centre(b);
                let is = self.change(&y).expr();
                (letters([r"\Delta y", "y"], &self.bodies[b].tag), is)
            }
            (Q::Phi, _) => {
                let turned = self.turned();
                let arc = self.arc_of(self.lead).filter(|(.., rolls)| *rolls);
                let is = arc.map(|arc| self.turning_of(arc).times(turned).expr());
                let turned = is.map_or(turned, |is| self.page.find(&[r"\varphi", r"\psi"], "rad", is));
                return Ok(self.sized(turned));
            }
            (Q::Angle, _) => {
                let [_, last] = self.turns[0].at.clone();
                let is = self.draft.radians(last);
                ([format!("{}^{{*}}", self.letter), r"\psi^{*}".to_owned()], is)
            }
            (quantity, Owner::Joint(j)) if quantity != Q::T => {
                return self.of_joint(quantity, j).ok_or_else(none);
            }
            (Q::Drive, _) => return self.driver.ok_or_else(none),
            (Q::PowerCouple, Owner::Body(b)) => {
                let turn = self.get(of_body(Q::Omega, b))?;
                let sense = self.value(&self.spin(b)) * self.sense;
                let drive = self.driver.filter(|_| b == self.lead).map(Expr::from);
                let moment = self.couple(b, drive);
                let turns = self.symbols.value(turn) != 0.0;
                let is = if turns { moment.by(in_sense(turn.into(), sense)) } else { ZERO };
                (letters([r"\dot{W}_{M}", r"\dot{A}_{M}"], &self.bodies[b].tag), is)
            }
            (Q::Moment, Owner::Strut(s)) => {
                let moment = *self.springs.get(s).ok_or_else(none)?;
                let name = format!(r"\mathrm{{t}}{}", one_of(self.scene.struts.len(), s));
                return Ok(self.page.find(&[tagged("M", &name)], "N m", ZERO - moment));
            }
            (Q::SpringForce, of) => {
                let spring = if let Owner::Strut(s) = of { s } else { 0 };
                return self.springs.get(spring).copied().ok_or_else(none);
            }
            (Q::KineticEnergy, _) => {
                let j = self.whole_inertia();
                let all = sum(self.bodies.iter().map(|b| b.mass.expr()));
                let (j, rate) = self.glides.clone().map_or((j, rate), |speed| (all, speed));
                let is = ratio(1, 2).by(&j).by(square(&rate));
                (["E_{k}", r"E_{\mathrm{kin}}"].map(str::to_owned), is)
            }
            (Q::T, _) => return self.time(key).ok_or_else(none),
            (quantity @ (Q::IO | Q::IG | Q::XG | Q::YG), Owner::Scene) => {
                let names = match quantity {
                    Q::IO => ["I_O", "J_O"],
                    Q::IG => ["I_G", "J_G"],
                    Q::XG => ["x_G", "X_G"],
                    _ => ["y_G", "Y_G"],
                };
                (names.map(str::to_owned), self.whole(quantity).ok_or_else(none)?)
            }
            _ => return Err(none()),
        };
        Ok(self.page.find(&names, label.quantity.unit(), is))
    }

    /// Of bodies that are welded into one on a pin: mass centre and moments of inertia, by the theorem of parallel axes.
    fn whole(&mut self, quantity: Quantity) -> Option<Expr> {
        let pin = self.scene.only_pin()?;
        let pin = self.spot(pin);
        let points: Vec<Vector> = (0..self.bodies.len()).map(|b| self.centre(b)).chain([pin]).collect();
        let placed = points.iter().map(|point| self.places(point, END));
        let mut centres: Vec<Vector> = placed.collect();
        let pin = centres.pop()?;
        let masses: Vec<Factors> = self.bodies.iter().map(|b| b.mass.clone()).collect();
        let mean = |i: usize| {
            let moments = masses.iter().zip(&centres).map(|(mass, centre)| mass.by(centre[i].expr()));
            sum(moments).over(sum(masses.iter().map(Factors::expr)))
        };
        let about = |point: &Vector| {
            let moved = self.bodies.iter().zip(&centres).map(|(body, centre)| {
                let own = sum(body.inertia.iter().map(Factors::expr));
                own + body.mass.by(square(self.size(&less(centre, point))))
            });
            sum(moved)
        };
        Some(match quantity {
            Quantity::IO => about(&pin),
            Quantity::IG if centres.len() == 1 => about(&centres[0]),
            Quantity::IG => about(&[mean(0), mean(1)].map(Sum::one)),
            Quantity::XG => mean(0),
            _ => mean(1),
        })
    }

    /// The time up to the end: given, or that of the key.
    fn time(&mut self, key: Option<f64>) -> Option<SymbolId> {
        if let End::Time(_, t) = self.scene.end {
            return self.number(t, "t", "s").uses().first().copied();
        }
        let symbol = self.named(&["t", "t_1"], "s");
        self.symbols.settle(symbol, key?, 0.0);
        Some(self.page.step(symbol, symbol.into()))
    }

    /// What a quantity is of a body on a pin that no other body has, or has in another way.
    fn of_pivot(&mut self, label: Label) -> Result<Option<SymbolId>, DerivationStop> {
        use Quantity as Q;
        if let Some(blow) = self.blow.clone() {
            if let (true, Owner::Joint(j)) = (is_impulse(label.quantity), label.of) {
                return Ok(self.impulse_of(&blow, j, label.quantity));
            }
            let own = self.pivot.is_none() || label.quantity == Q::KineticEnergy;
            if own
                && blow.from_rest
                && self.scene.end == End::AtOnce
                && let Some(found) = self.just_after(&blow, label)
            {
                return Ok(Some(found));
            }
        }
        if matches!(label.quantity, Q::OmegaSmall | Q::PeriodSmall) {
            let per = match (self.k.filter(|_| self.scene.end == End::Equilibrium), &self.pivot) {
                (Some(k), _) => k / self.whole_inertia(),
                (None, Some(pivot)) => {
                    self.bodies[0].mass.times(&self.g).times(&pivot.h).expr() / pivot.about
                }
                _ => return Ok(None),
            };
            let frequency = self.page.find_once(&[r"\Omega", r"\omega_s"], "rad/s", root(per));
            if label.quantity == Q::OmegaSmall {
                return Ok(Some(frequency));
            }
            let is = number(2) * self.draft.pi() / frequency;
            return Ok(Some(self.page.find_once(&[r"\tau_0", r"\tau_s"], "s", is)));
        }
        if let (Q::AngularMomentum, Owner::Body(b), None) = (label.quantity, label.of, self.scene.pinned()) {
            return self.own_momentum(b).map(Some);
        }
        let Some(pivot) = self.pivot.clone() else { return Ok(None) };
        let ([r, s], about) = (pivot.force, pivot.about);
        let mgh = self.bodies[0].mass.times(&self.g).times(&pivot.h);
        let of = |this: &mut Self, quantity| this.get(Label { quantity, ..label });
        let (names, is) = match label.quantity {
            Q::IO => return Ok(Some(about)),
            Q::PinRadial => return Ok(Some(r)),
            Q::PinTangential => return Ok(Some(s)),
            Q::PinX | Q::PinY if !pivot.radial => {
                return Ok(Some(pivot.force[usize::from(label.quantity == Q::PinY)]));
            }
            Q::PinX | Q::PinY => {
                let i = usize::from(label.quantity == Q::PinY);
                let shares = [r, s].into_iter().zip(self.basis());
                let is = positive_first(shares.map(|(force, unit)| unit[i].times(force).expr()));
                ([["O_x", "X_O"], ["O_y", "Y_O"]][i], is)
            }
            Q::PinForce => (["F_O", "O"], self.composed(Q::PinForce, pivot.force)),
            Q::PinAngle => {
                let both = [of(self, Q::PinX)?, of(self, Q::PinY)?];
                ([r"\psi_O", r"\chi_O"], self.composed(Q::PinAngle, both))
            }
            Q::RotationalFraction => ([r"\eta", r"\beta"], pivot.own.over(about)),
            Q::AngularMomentum => (["L", r"\Lambda"], about.by(of(self, Q::Omega)?)),
            Q::WorkCouple => (["W_{M}", "A_{M}"], self.couple(0, None).by(self.turned())),
            Q::OmegaMax => {
                let height = signed(cosine(&self.turns[0].at[START]), pivot.up);
                let gained = mgh.times(number(2)).by(ONE + height).over(about);
                ([r"\omega_{\mathrm{max}}", r"\omega_{m}"], root(square(&self.first) + gained))
            }
            _ => return Ok(None),
        };
        Ok(Some(self.page.find_once(&names, label.quantity.unit(), is)))
    }
    /// The angular momentum of a body about its mass centre.
    fn own_momentum(&mut self, body: usize) -> Result<SymbolId, DerivationStop> {
        let omega = self.get(of_body(Quantity::Omega, body))?;
        let it = &self.bodies[body];
        let names = ["L", r"\Lambda"].map(|l| tagged(l, &it.tag));
        let own = sum(it.inertia.iter().map(Factors::expr));
        let is = if self.symbols.value(omega) == 0.0 { ZERO } else { own * Expr::from(omega) };
        Ok(self.page.find_once(&names, Quantity::AngularMomentum.unit(), is))
    }
    /// The moment of all couples on a body, that of its drive among them, positive with a growing angle.
    fn couple(&mut self, body: usize, drive: Option<Expr>) -> Expr {
        let couples = self.scene.couples.iter().filter(|c| c.body == body);
        let given = couples.map(|c| signed(self.page.number(c.moment_n_m, "M", "N m"), c.forward));
        positive_first(given.chain(drive))
    }
    /// The force of a joint.
    pub fn of_joint(&mut self, quantity: Quantity, joint: usize) -> Option<SymbolId> {
        let own: Vec<SymbolId> = self.holds.iter().filter(|h| h.joint == joint).map(|h| h.unknown).collect();
        match quantity {
            Quantity::PinForce | Quantity::PinAngle => {
                let [x, y, ..] = own[..] else { return None };
                let letter = if quantity == Quantity::PinForce { "R" } else { r"\psi" };
                let name = tagged(letter, &names::joint(self.scene, joint));
                Some(self.page.find(&[name], quantity.unit(), self.page.composed(quantity, [x, y])))
            }
            Quantity::PinY => own.get(1).copied(),
            Quantity::Moment => own.get(2).copied(),
            Quantity::Friction => match self.frictions.iter().find(|(of, ..)| *of == joint).cloned() {
                Some((_, force, is)) => Some(self.page.step(force, is)),
                None => own.get(1).copied(),
            },
            Quantity::Normal | Quantity::Tension | Quantity::RimForce | Quantity::PinX => {
                own.first().copied()
            }
            _ => None,
        }
    }

    /// The lengths of light rods and cords that guide a body on its way.
    pub fn lengths(&self) -> Vec<SymbolId> {
        let cords = self.turns.iter().filter_map(|t| t.link);
        let cords = cords.filter(|(j, _)| matches!(self.scene.joints[*j].kind, JointKind::Cord { .. }));
        cords.map(|(_, length)| length).collect()
    }
}

/// A hinge of a body: its point, that of the other body, and are both welded?
fn hinge_of(joint: &Joint, body: usize) -> Option<(Spot, Spot, bool)> {
    let JointKind::Hinge { one, other, turned_deg } = joint.kind else { return None };
    let mut ends = [(one, other), (other, one)].into_iter();
    ends.find(|(own, _)| own.body == body).map(|(own, other)| (own, other, turned_deg.is_some()))
}

/// What stands below a symbol that several have.
fn one_of(several: usize, i: usize) -> String {
    if several > 1 { format!(",{}", i + 1) } else { String::new() }
}

/// 1 or -1, or 0.
fn sign(of: f64) -> Factors {
    if of.abs() < NOTHING { Factors::zero() } else { Factors::one().signed(if of < 0.0 { -1 } else { 1 }) }
}

/// Is there a sum in it?
fn sums(e: &Expr) -> bool {
    matches!(e, Expr::Sum(_)) || e.parts().into_iter().any(sums)
}
