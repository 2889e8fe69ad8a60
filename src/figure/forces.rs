//! Free-body diagram and kinetic diagram of one body, side by side: what acts on it equals what it makes of it.
//!
//! Forces stand at their true points in their true directions, also those that the solver found: friction points as it really
//! acts. Lengths go with the magnitudes, but no arrow is shorter than can be seen. What is 0 is not drawn, but for the force of a contact that ends there. A symbol between
//! bars is negative in the signs of the scene.
use crate::bank::{FigureLabels, Problem};
use crate::figure::joined::{Laid, PlaneLayout};
use crate::figure::layout::{BodyLook, Placed};
use crate::figure::view::SceneView;
use crate::figure::{joined, layout, names, parts, say};
use crate::num::formula::Step;
use crate::num::shown;
use crate::picture::board::{Board, LabelTie, LabelWish, MIDDLE_FIRST, TEXT, on_arc};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Picture, Role, TextRun, symbol};
use crate::problem::maker::Variant;
use crate::scene::{
    Attach, Couple, End, Far, GivenForce, JointKind, Label, Made, Num, Numbers, Owner, Planar, Quantity,
    Scene, Side, StrutEnd, Surface, Term, Tie, pose,
};
use crate::words::Words;

/// Radius to which a body is drawn.
const RADIUS: f64 = 66.0;
/// The same where it touches the ground within its outline, so that the forces there have room.
const ON_RAIL: f64 = 84.0;
/// Half the length to which a load on wheels is drawn.
const LONG_LOAD: f64 = 110.0;
/// Length to which a body in the plane is drawn.
const LONG_BODY: f64 = 150.0;
/// Length of the longest arrow.
const LONGEST: f64 = 92.0;
/// Length of the shortest arrow.
const SHORTEST: f64 = 38.0;
/// Length of the shortest arrow where all arrows have one scale.
const SHORT: f64 = 16.0;
/// How far an arrow stands beside a thin rod in which it would lie.
const BESIDE: f64 = 15.0;
/// A lever arm below this is not drawn.
const NEAR_POLE: f64 = 12.0;
/// How far a surface is drawn to each side of a contact.
const CUT: f64 = 28.0;
/// Radius at which the angle of a body in the plane is drawn.
const ANGLE: f64 = 34.0;
/// Size of the caption.
const CAPTION: f64 = 13.0;
/// Share of the largest force below which a force counts as 0.
const NOTHING: f64 = 1e-9;

/// A force on the body.
struct ForceArrow {
    at: Vec2,
    /// Its value along `towards`; negative: it acts the other way.
    value: f64,
    towards: Vec2,
    label: Vec<TextRun>,
    role: Role,
    /// Does its arrow end at its point (a push) or begin there (a pull)?
    push: bool,
    /// Its arrow is no longer than this.
    most: f64,
    /// How far its arrow is drawn from its line of action, to be seen.
    aside: Vec2,
    /// Symbol of its lever arm about the point of the moments; empty where none is drawn.
    arm: Vec<TextRun>,
    /// Is it drawn although it is 0 now: the force of a contact that ends here?
    ends: bool,
}

impl ForceArrow {
    /// Is it drawn, beside forces up to this one?
    fn acts(&self, most: f64) -> bool {
        self.ends || self.value.is_finite() && self.value.abs() > NOTHING * most
    }
    /// A pull, as long as the others.
    fn new(at: Vec2, towards: Vec2, value: f64, label: Vec<TextRun>) -> Self {
        let (role, most) = (Role::Force, LONGEST);
        let (push, aside, arm, ends) = (false, Vec2::ZERO, Vec::new(), false);
        Self { at, value, towards, label, role, push, most, aside, arm, ends }
    }
    /// The same with its symbol between bars where it is negative.
    fn signed(at: Vec2, towards: Vec2, value: f64, symbol: Vec<TextRun>) -> Self {
        Self::new(at, towards, value, symbol::magnitude(symbol, value < 0.0))
    }
    /// The same on this side of what joins two bodies: 1 where the symbol counts it positive as drawn, -1 where the opposite acts.
    fn on(self, side: f64) -> Self {
        Self { value: side * self.value, ..self }
    }
    /// In the colour of something else than a force that is given or found.
    fn of(self, role: Role) -> Self {
        Self { role, ..self }
    }
}

/// A couple on the body: counter-clockwise positive.
struct Turning {
    value: f64,
    label: Vec<TextRun>,
}

impl Turning {
    /// A couple with its symbol between bars where it is negative.
    fn signed(value: f64, symbol: Vec<TextRun>) -> Self {
        Self { value, label: symbol::magnitude(symbol, value < 0.0) }
    }
    /// `I alpha` of a body, with both symbols.
    fn kinetic(alpha: f64, inertia: f64, clockwise: bool, [symbol, of_alpha]: [Vec<TextRun>; 2]) -> Self {
        let sense = if clockwise { -1.0 } else { 1.0 };
        let label = [symbol, symbol::magnitude(of_alpha, alpha < 0.0)].concat();
        Self { value: alpha * inertia * sense, label }
    }
}

/// Both diagrams of a body, not drawn yet.
struct Diagram<'a> {
    forces: Vec<ForceArrow>,
    couples: Vec<Turning>,
    /// What is not known and so not drawn, and the name of its caption: what acts at an axle, the weight included, or what presses on
    /// a wheel of several that bear a load.
    unknown: Option<(ForceArrow, &'static str)>,
    /// What the body makes of it: `m a` in one or two components, `I alpha`, and the radius of its arrow.
    parts: Vec<ForceArrow>,
    turn: Option<Turning>,
    round: f64,
    centre: Vec2,
    /// The point about which moments are taken.
    pole: Vec2,
    /// Pixels per metre.
    scale: f64,
    /// Symbol of the force of the axle, where it is drawn.
    held: Option<Vec<TextRun>>,
    /// Are forces taken to the right and up?
    axes: bool,
    /// Draws the body.
    body: Box<dyn Fn(&mut Board) + 'a>,
}

/// What the arrows of a diagram add up to, N and N m, on the board (x to the right, y up, counter-clockwise positive).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resultant {
    /// Sum of the forces.
    pub force: Vec2,
    /// Sum of the moments about the mass centre.
    pub moment: f64,
    /// Sum of the magnitudes of the forces.
    pub size: f64,
}

/// The sums of both diagrams, that of the forces first; they are equal. `None` where there is no diagram.
pub fn resultants(
    problem: &Problem,
    variant: &Variant,
    words: &Words,
    body: usize,
) -> Option<(Resultant, Resultant)> {
    settled(problem, variant, words, |view| sums(&diagram(view, body)?))
}

fn sums(diagram: &Diagram) -> Option<(Resultant, Resultant)> {
    let sum = |forces: &[ForceArrow], turns: &mut dyn Iterator<Item = &Turning>| {
        let mut all = Resultant { force: Vec2::ZERO, moment: 0.0, size: 0.0 };
        for f in forces {
            let arm = (f.at - diagram.centre) * (1.0 / diagram.scale);
            all.force += f.towards * f.value;
            all.moment += arm.perp(&f.towards) * f.value;
            all.size += f.value.abs();
        }
        all.moment += turns.map(|t| t.value).sum::<f64>();
        all
    };
    let mut left = sum(&diagram.forces, &mut diagram.couples.iter());
    if let Some((f, _)) = &diagram.unknown {
        left.force += f.towards * f.value;
    }
    Some((left, sum(&diagram.parts, &mut diagram.turn.iter())))
}

/// Looks at a variant; where a datum has to be found first, with the value that was found. `None` where no question asks it.
fn settled<R>(
    problem: &Problem,
    variant: &Variant,
    words: &Words,
    look: impl FnOnce(&SceneView) -> Option<R>,
) -> Option<R> {
    let view = SceneView::new(problem, variant, words, FigureLabels::Symbols)?;
    let Some(found) = view.scene.formulas.found else { return look(&view) };
    let (mut scene, mut variant) = (view.scene.clone(), variant.clone());
    let value = view.solved(Quantity::Value, Owner::Asked(asked_alone(view.scene)?))?;
    scene.formulas.found = None;
    variant.data[found.unknown.datum] = if found.unknown.degrees { value.to_degrees() } else { value };
    look(&SceneView { scene: &scene, variant: &variant, ..view })
}

/// What is asked by a formula that is the datum to be found and nothing else.
fn asked_alone(scene: &Scene) -> Option<usize> {
    let unknown = scene.formulas.found?.unknown.datum;
    let alone = |steps: &[Step<Term>]| matches!(steps, [Step::Name(Term::Given(g))] if g.datum == unknown);
    scene.formulas.asked.iter().position(|a| alone(a.formula.steps()))
}

fn diagram<'a>(view: &'a SceneView<'a>, body: usize) -> Option<Diagram<'a>> {
    let this = view.scene.bodies.get(body).filter(|b| b.particles.is_empty())?;
    match &this.planar {
        Some(planar) => {
            let plane = PlaneLayout::new(view)?;
            let ends = plane.at_end(view).unwrap_or_else(|| vec![plane.start.clone()]).into_iter();
            let diagrams = ends.filter_map(|laid| match view.scene.pinned() {
                Some(_) => Some(swinging(view, &plane, laid, planar)),
                None => in_the_plane(view, &plane, laid, body),
            });
            // Of the positions on either side it is the one at which the forces turn the body as it turns.
            let missed = |d: &Diagram| {
                sums(d).map_or(f64::INFINITY, |(acting, made)| (acting.moment - made.moment).abs())
            };
            diagrams.min_by(|one, other| missed(one).total_cmp(&missed(other)))
        }
        None => moving(view, body),
    }
}

/// Can the diagrams of this body be drawn? Its acceleration must have been found, and no datum be the one that is looked for.
pub fn known(problem: &Problem, variant: &Variant, body: usize) -> bool {
    let Some(scene) = problem.cases.get(variant.case).map(|c| &c.scene) else { return false };
    let found = |q: Quantity| {
        let is = |label: Label| label == Label { quantity: q, of: Owner::Body(body) };
        variant.solved.entries.iter().any(|e| is(e.label) && e.value().is_finite())
    };
    // In equilibrium there is no acceleration to be found.
    let still = scene.end == End::Equilibrium && scene.planar(body).is_some();
    (scene.formulas.found.is_none() || asked_alone(scene).is_some())
        && scene.bodies.get(body).is_some_and(|b| b.particles.is_empty())
        && (still || found(Quantity::A) || found(Quantity::Alpha) || found(Quantity::AX))
}

/// Free-body diagram and kinetic diagram of a body at the moment that is asked; of a body that is thrown with slip, while it
/// slips.
pub fn free_body(problem: &Problem, variant: &Variant, words: &Words, body: usize) -> Picture {
    let title = |name: &str| words.say("figure.forces.title", &[("body", name)]);
    let drawn = settled(problem, variant, words, |view| {
        let name = say::called(view, &view.scene.bodies[body]);
        let mut desc = Vec::new();
        let board = equation(view, &diagram(view, body)?, &mut desc);
        Some(board.finish(title(&name), desc.join(" ")))
    });
    drawn.unwrap_or_else(|| Board::new().finish(title(""), String::new()))
}

/// The diagrams of a body on a line or an axle.
fn moving<'a>(view: &'a SceneView<'a>, body: usize) -> Option<Diagram<'a>> {
    let plan = layout::layout(view);
    let mut p = plan.bodies.get(body).cloned().flatten()?;
    let ratio = enlarge(view, &mut p, body);
    let bears = view.scene.ties.iter().enumerate().filter(|(_, t)| is_load(t));
    let bears: Vec<(usize, &Tie)> = bears.filter(|(_, t)| t.actions().any(|a| a.body == body)).collect();
    let rests = view.scene.rests(body);
    let this = &view.scene.bodies[body];
    let own = view.numbers(this);
    let mass = own.mass;
    let weight = mass * view.of(view.scene.gravity_m_s2);
    let mut forces = vec![ForceArrow::new(p.centre, Vec2::DOWN, weight, names::weight(view, body))];
    forces.extend(apparent(view, body, p.centre));
    let with = own.carried.map_or(0.0, |[forward, _]| forward.acceleration);
    let (mut a, mut alpha) = (found(view, Quantity::A, body) - with, found(view, Quantity::Alpha, body));
    if p.on.is_some() {
        if p.top.y > 0.97 && p.contact > 40.0 {
            // On a level the normal force comes from right below: the weight ends before it.
            forces[0].most = p.contact * 0.74;
        }
        contact(view, body, &p, weight, &mut forces, &mut a, &mut alpha);
    }
    cords(view, body, &p, &plan, ratio, &mut forces);
    // How wheels share the weight of their load is not known, nor so how the surface presses on each.
    let (mut unknown, mut held) = (None, None);
    if !bears.is_empty() && !rests && p.on.is_some() {
        let pressed = ForceArrow::new(p.centre, p.top, weight * own.level, Vec::new());
        forces.retain(|f| !f.push);
        unknown = Some((pressed, "shared"));
    }
    for (tie, at) in loaded(view, &plan, body, ratio, &bears) {
        let Some(action) = view.scene.ties[tie].actions().find(|a| a.body == body) else { continue };
        let label = symbol::symbol(&names::tension(view, tie));
        let force = view.solved(Quantity::RimForce, Owner::Tie(tie)).unwrap_or(0.0);
        let arm = action.arm.map_or_else(Vec::new, |(radius, _)| arm_symbol(view, radius));
        forces.push(ForceArrow { arm, ..ForceArrow::signed(at, p.forward, force, label).on(action.along) });
    }
    let couples = couples_on(view, body, p.clockwise);
    // Of teeth and belts what turns the body is known, not how they press on its axle.
    let rim = |t: &Tie| {
        matches!(t, Tie::Cord(c) if matches!(c.made, Made::Teeth | Made::Belt))
            && t.actions().any(|a| a.body == body)
    };
    let loose = this.massless() || view.scene.ties.iter().any(rim);
    if loose {
        forces.remove(0);
    }
    if this.line.is_none() {
        // The axle holds the sum of all others.
        let sum = forces.iter().fold(Vec2::ZERO, |s, f| s + f.towards * f.value);
        let symbol = symbol::symbol(&names::of_body(view, body, &["O", "O_A"], |b| b.line.is_none()));
        let axle = ForceArrow::new(p.centre, (-sum).unit(), sum.norm(), symbol);
        if loose {
            unknown = Some((axle, "axle"));
        } else {
            held = (axle.value > NOTHING * weight).then(|| axle.label.clone());
            forces.push(axle);
        }
    }
    let mut parts = Vec::new();
    if this.line.is_some() {
        let mut label = names::mass(view, body);
        let symbol = symbol::symbol(&names::acceleration(view, body, ""));
        label.extend(symbol::magnitude(symbol, a < 0.0));
        parts.push(ForceArrow::new(p.centre, p.forward, a * mass, label).of(Role::Motion));
    }
    let turn = this.turns.then(|| {
        let inertia = names::of_body(view, body, &["I_G", "J_G"], |_| false);
        let symbols = [inertia, names::alpha(view, body)].map(|s| symbol::symbol(&s));
        Turning::kinetic(alpha, view.inertia(this), p.clockwise, symbols)
    });
    let (round, centre) = (p.reach(Vec2::RIGHT) + 10.0, p.centre);
    let rolls = view.scene.ties.iter().any(|t| matches!(t, Tie::Roll { body: b, .. } if *b == body));
    let draw = move |board: &mut Board| alone(board, &p, rests, rolls);
    let (pole, scale, axes, body) = (centre, plan.scale * ratio, false, Box::new(draw));
    Some(Diagram { forces, couples, unknown, parts, turn, round, centre, pole, scale, axes, held, body })
}

/// Draws a body as large as a diagram has room for it, with its centre at the origin; by how much it grows.
fn enlarge(view: &SceneView, p: &mut Placed, body: usize) -> f64 {
    let radius = if p.on_rail() { ON_RAIL } else { RADIUS };
    let scale = radius / layout::outer_m(view, body);
    p.centre = Vec2::ZERO;
    let ratio = match &p.look {
        BodyLook::Wheel { outer, .. } => radius / outer,
        BodyLook::Block { along, .. } => (LONG_LOAD / along).min(1.25),
    };
    p.look = match p.look {
        BodyLook::Wheel { open, .. } => match layout::look(view, body, scale) {
            BodyLook::Wheel { outer, rings, .. } => BodyLook::Wheel { outer, rings, open },
            block @ BodyLook::Block { .. } => block,
        },
        BodyLook::Block { along, across } => BodyLook::Block { along: along * ratio, across: across * ratio },
    };
    p.contact *= ratio;
    if let (true, BodyLook::Block { across, .. }) = (view.scene.rests(body), &p.look) {
        p.contact = *across;
    }
    ratio
}

/// A body on a line or an axle without what touches it.
fn alone(board: &mut Board, p: &Placed, rests: bool, rolls: bool) {
    if p.on.is_some() && !rests {
        // The surface, cut away, as a reference.
        let at = p.centre - p.top * p.contact;
        let long = p.reach(p.forward) + 22.0;
        board.line(at - p.forward * long, at + p.forward * long, Role::Ghost);
    }
    parts::outline(board, p);
    parts::inside(board, p);
    match p.look {
        BodyLook::Block { .. } => board.dot(p.centre),
        BodyLook::Wheel { .. } => {
            let mut letter = |text: &str, at: Vec2, degrees: &[f64]| {
                let spots = degrees.iter().map(|d| (at, p.direction(*d))).collect();
                board.label(vec![symbol::italic(text)], Role::Dot, (LabelTie::Near, 4.0), spots);
            };
            letter("G", p.centre, &[135.0, 45.0, 180.0, 0.0]);
            if rolls {
                letter("C", p.centre - p.top * p.contact, &[225.0, 315.0]);
                board.dot(p.centre - p.top * p.contact);
            }
        }
    }
}

/// Does a body rest on a wheel here?
fn is_load(tie: &Tie) -> bool {
    matches!(tie, Tie::Cord(c) if c.made == Made::Rests)
}

/// Where the forces between a load and its wheels act on a body: of each tie its point.
fn loaded(
    view: &SceneView,
    plan: &layout::SceneLayout,
    body: usize,
    ratio: f64,
    ties: &[(usize, &Tie)],
) -> Vec<(usize, Vec2)> {
    let place = |(tie, t): &(usize, &Tie)| {
        let Tie::Cord(cord) = t else { return None };
        let Far::Body(wheel) = &cord.to else { return None };
        let [here, below] = [body, wheel.body].map(|b| plan.bodies.get(b).and_then(Option::as_ref));
        let (here, below) = (here?, below?);
        let rim = match wheel.attach {
            Attach::Centre => 0.0,
            Attach::Wound(radius, _) => view.of(radius) * plan.scale,
        };
        Some((*tie, (below.centre + below.top * rim - here.centre) * ratio))
    };
    ties.iter().filter_map(place).collect()
}

/// The apparent force at the mass centre of a body that is carried.
fn apparent(view: &SceneView, body: usize, centre: Vec2) -> Option<ForceArrow> {
    let carrier = view.scene.carried?;
    let given = match carrier.acceleration_m_s2 {
        datum @ Num::Datum(_) => view.symbol(datum),
        _ => symbol::symbol(&names::free(view.problem, &["A".to_owned()])),
    };
    let acceleration = view.of(carrier.acceleration_m_s2);
    let label = [names::mass(view, body), symbol::magnitude(given, acceleration < 0.0)].concat();
    let against = -Vec2::at_degrees(view.degrees(carrier.slope));
    let size = view.kilograms(&view.scene.bodies[body]) * acceleration;
    Some(ForceArrow::new(centre, against, size, label))
}

/// What the solver found of a body; 0 where it found nothing.
fn found(view: &SceneView, quantity: Quantity, body: usize) -> f64 {
    view.solved(quantity, Owner::Body(body)).unwrap_or(0.0)
}

fn couples_on(view: &SceneView, body: usize, clockwise: bool) -> Vec<Turning> {
    let turning = |(i, c): (usize, &Couple)| {
        let (given, value) = view.load(GivenForce::Couple(i), c.moment_n_m);
        let symbol = if given.is_empty() { symbol::symbol("M") } else { given };
        let value_left = if clockwise == c.forward { -value } else { value };
        Turning { value: value_left, ..Turning::signed(value, symbol) }
    };
    view.scene.couples.iter().enumerate().filter(|(_, c)| c.body == body).map(turning).collect()
}

/// The symbol of a lever arm, as in the solution.
fn arm_symbol(view: &SceneView, radius: Num) -> Vec<TextRun> {
    let derived = |i: usize| view.scene.formulas.numbers.get(i).is_some_and(|n| !n.any);
    match radius {
        Num::Derived(i) if derived(i) => {
            let names: Vec<String> = names::sizes("R").into_iter().map(str::to_owned).collect();
            symbol::symbol(&names::free(view.problem, &names))
        }
        _ => view.symbol(radius),
    }
}

/// Normal force and friction.
fn contact(
    view: &SceneView,
    body: usize,
    p: &Placed,
    weight: f64,
    forces: &mut Vec<ForceArrow>,
    a: &mut f64,
    alpha: &mut f64,
) {
    let this = &view.scene.bodies[body];
    let at = p.centre - p.top * p.contact;
    let tie = view.scene.ties.iter().position(|t| t.touching() == Some(body));
    let whose = |q: Quantity| {
        let by_tie = tie.and_then(|t| view.solved(q, Owner::Tie(t)));
        view.solved(q, Owner::Body(body)).or(by_tie).or_else(|| view.solved(q, Owner::Scene))
    };
    let own = view.numbers(this);
    let normal = whose(Quantity::Normal).unwrap_or(weight * own.level);
    let mut friction = whose(Quantity::Friction).unwrap_or(0.0);
    if let Some(thrown) = view.scene.thrown().filter(|t| t.body == body) {
        // While it slips: against the slip.
        let radius = view.of(thrown.radius_m);
        let [speed, with] =
            own.carried.map_or([0.0; 2], |[forward, _]| [forward.speed, forward.acceleration]);
        let slip = view.of(thrown.speed_m_s) - speed - radius * view.of(thrown.spin_rad_s);
        friction = -slip.signum() * view.of(thrown.mu_k) * normal;
        *a = if own.mass > 0.0 { (friction - weight * own.climb) / own.mass - with } else { 0.0 };
        *alpha = if own.inertia > 0.0 { -friction * radius / own.inertia } else { 0.0 };
    } else if this.line.is_some_and(|l| !l.forward_up) {
        // Found positive up the incline, drawn along the body's own forward direction.
        friction = -friction;
    }
    let name = names::of_body(view, body, &["N", "N_s"], |b| b.line.is_some_and(|l| l.surface));
    // On a level it lies in the line of the weight, beside which it stands where there is no room between.
    let aside = if p.top.y > 0.97 && p.contact <= 40.0 { p.forward * BESIDE } else { Vec2::ZERO };
    let normal_force = ForceArrow::new(at, p.top, normal, symbol::symbol(&name));
    forces.push(ForceArrow { push: true, aside, ..normal_force });
    let signed = whose(Quantity::Friction).unwrap_or(friction);
    let negative = if view.scene.thrown().is_some() { friction < 0.0 } else { signed < 0.0 };
    let arm = tie.and_then(|t| view.scene.ties[t].actions().find_map(|a| a.arm));
    let arm = arm.map_or_else(Vec::new, |(radius, _)| arm_symbol(view, radius));
    let label = symbol::magnitude(symbol::symbol(&names::friction(view, body)), negative);
    forces.push(ForceArrow { arm, ..ForceArrow::new(at, p.forward, friction, label).of(Role::Friction) });
}

/// Pulls and tensions.
fn cords(
    view: &SceneView,
    body: usize,
    p: &Placed,
    plan: &layout::SceneLayout,
    ratio: f64,
    forces: &mut Vec<ForceArrow>,
) {
    for run in &plan.cords {
        let Some(tie @ Tie::Cord(cord)) = view.scene.ties.get(run.tie) else { continue };
        // The same actions from which the rows of the equations of motion are made.
        for pull in tie.actions().filter(|a| a.body == body) {
            let Some((_, towards)) = run.at.iter().find(|(b, _)| *b == body) else { continue };
            let away = |radius: Num| (view.of(radius) * plan.scale * ratio).max(2.0);
            let (at, towards) = match pull.arm {
                None => match &p.look {
                    BodyLook::Block { .. } => (p.centre + *towards * p.reach(*towards), *towards),
                    BodyLook::Wheel { .. } => (p.centre, *towards),
                },
                // Teeth touch on the line of the centres, and press along the rims.
                Some((radius, sense)) if cord.made == Made::Teeth => {
                    let along = if p.clockwise { towards.right() } else { towards.left() };
                    (p.centre + *towards * away(radius), along * (sense * pull.along))
                }
                Some((radius, sense)) => {
                    let side = if sense * pull.along > 0.0 { Side::Top } else { Side::Bottom };
                    let out = p.winds(side, pull.along > 0.0, *towards);
                    (p.centre + out * away(radius), *towards)
                }
            };
            let (label, value) = match cord.to {
                Far::Pull(n) => view.load(GivenForce::Pull(run.tie), n),
                _ => {
                    let value = view.solved(cord.force(), Owner::Tie(run.tie)).unwrap_or(0.0);
                    (symbol::symbol(&names::tension(view, run.tie)), value)
                }
            };
            let label = if label.is_empty() { symbol::symbol("P") } else { label };
            let arm = pull.arm.map_or_else(Vec::new, |(radius, _)| arm_symbol(view, radius));
            forces.push(ForceArrow { arm, ..ForceArrow::signed(at, towards, value, label) });
        }
    }
}

/// The diagrams of a body that swings about its pin, at the angle that is asked: along its axis and across.
fn swinging<'a>(
    view: &'a SceneView<'a>,
    plane: &PlaneLayout,
    laid: Vec<Laid>,
    planar: &'a Planar,
) -> Diagram<'a> {
    let (body, this) = (0, &view.scene.bodies[0]);
    let close = plane.close_up(view, body, LONG_BODY);
    let (d, scale) = (laid[body].axis, close.scale);
    let across = if planar.clockwise { d.right() } else { d.left() };
    let (mass, metres) = (view.kilograms(this), joined::along(view, planar.centre));
    let g = d * (metres * scale);
    let rod = this.rod().map(|_| joined::span(view, body, planar).map(|x| x * scale));
    let name = |candidates: &[&str]| {
        let list: Vec<String> = candidates.iter().map(|c| (*c).to_owned()).collect();
        symbol::symbol(&names::free(view.problem, &list))
    };
    let (radial, tangential) =
        (found(view, Quantity::PinRadial, body), found(view, Quantity::PinTangential, body));
    let weight = mass * view.of(view.scene.gravity_m_s2);
    let mut forces = vec![
        ForceArrow::signed(g, Vec2::DOWN, weight, names::weight(view, body)),
        ForceArrow::signed(Vec2::ZERO, -d, radial, name(&["R", "O_r"])),
        ForceArrow::signed(Vec2::ZERO, across, tangential, name(&["S", "O_t"])),
    ];
    for strut in &view.scene.struts {
        let (held, anchor) = close.ends(view, &laid, strut);
        let value = found(view, Quantity::SpringForce, body);
        let symbol = name(&["F_s", r"F_{\mathrm{s}}"]);
        let pull = ForceArrow::signed(held, (anchor - held).unit(), value, symbol);
        forces.push(ForceArrow { arm: name(&["p", r"p_{\mathrm{s}}"]), ..pull });
    }
    let couples = couples_on(view, body, planar.clockwise);
    let (omega, alpha) = (found(view, Quantity::Omega, body), found(view, Quantity::Alpha, body));
    let with_mass = |symbol: Vec<TextRun>| [names::mass(view, body), symbol].concat();
    // Along a thin rod they stand beside it, where the tangential ones do not.
    let beside = |tangential: f64| match rod {
        Some(_) => across * (if tangential < 0.0 { BESIDE } else { -BESIDE }),
        None => Vec2::ZERO,
    };
    let into = rod.is_some_and(|[from, to]| if radial < 0.0 { to > 30.0 } else { from < -30.0 });
    if into {
        forces[1].aside = beside(tangential);
    }
    let normal = ForceArrow::new(g, -d, mass * metres * omega * omega, with_mass(symbol::symbol("a_n")));
    let tangential = with_mass(symbol::magnitude(symbol::symbol("a_t"), alpha < 0.0));
    let tangential = ForceArrow::new(g, across, mass * metres * alpha, tangential).of(Role::Motion);
    let parts = vec![ForceArrow { aside: beside(alpha), ..normal.of(Role::Motion) }, tangential];
    let symbols = [name(&["I_G", "J_G"]), name(&[r"\alpha", r"\alpha_1"])];
    let turn = Some(Turning::kinetic(alpha, view.inertia(this), planar.clockwise, symbols));
    let draw = move |board: &mut Board| {
        let [x, y] = planar.from.components();
        board.line(Vec2::ZERO, vec2(x, y) * 62.0, Role::Ghost);
        close.outline(board, view, &laid, body, Role::Body);
        board.circle(Vec2::ZERO, 3.2, Role::Inner);
        board.dot(g);
        let aside = if rod.is_some() { 5.0 } else { 2.0 };
        let mut letter = |text: &str, at: Vec2| {
            let beside = |side: Vec2| (at + side * aside, side);
            let spots = vec![beside(across), beside(-across), (at, -d), (at, d)];
            board.label(vec![symbol::italic(text)], Role::Dot, (LabelTie::Near, 4.0), spots);
        };
        letter("O", Vec2::ZERO);
        if g.norm() > 4.0 {
            letter("G", g);
        }
    };
    let (centre, pole, round) = (g, Vec2::ZERO, 27.0);
    let (unknown, axes, held, body) = (None, false, None, Box::new(draw));
    Diagram { forces, couples, unknown, parts, turn, round, centre, pole, scale, axes, held, body }
}

/// The diagrams of a body in the plane, at the position that is asked.
fn in_the_plane<'a>(
    view: &'a SceneView<'a>,
    plane: &PlaneLayout,
    mut laid: Vec<Laid>,
    body: usize,
) -> Option<Diagram<'a>> {
    let this = &view.scene.bodies[body];
    let mass = view.kilograms(this);
    let g = plane.centre(view, &laid, body);
    let mut forces = Vec::new();
    if !view.scene.lies_level() {
        let weight = mass * view.of(view.scene.gravity_m_s2);
        forces.push(ForceArrow::signed(g, Vec2::DOWN, weight, names::weight(view, body)));
    }
    forces.extend(apparent(view, body, g));
    forces.extend(joint_forces(view, plane, &laid, body));
    forces.extend(given_forces(view, plane, &laid, body));
    let planar = this.planar.as_ref()?;
    let with = Numbers::<f64>::new(view.scene, &view.variant.data).carried.unwrap_or([0.0; 2]);
    let part = |quantity: Quantity, towards: Vec2, with: f64, way: &str| {
        // Where nothing accelerates on the carrier, nothing is told of it.
        let a = view.solved(quantity, Owner::Body(body)).map_or(0.0, |a| a - with);
        let symbol = symbol::symbol(&names::acceleration(view, body, way));
        let label = [names::mass(view, body), symbol::magnitude(symbol, a < 0.0)].concat();
        ForceArrow::new(g, towards, mass * a, label).of(Role::Motion)
    };
    let mut parts =
        vec![part(Quantity::AX, Vec2::RIGHT, with[0], "x"), part(Quantity::AY, Vec2::UP, with[1], "y")];
    let alpha = found(view, Quantity::Alpha, body);
    let turn = this.turns.then(|| {
        let inertia = names::free(view.problem, &["I_G".to_owned(), "J_G".to_owned()]);
        let symbols = [inertia, names::alpha(view, body)].map(|s| symbol::symbol(&s));
        Turning::kinetic(alpha, view.inertia(this), planar.clockwise, symbols)
    });
    let couples = couples_in_the_plane(view, body, planar.clockwise);
    // The mass centre stands at the origin, level with the sign between the diagrams.
    let close = plane.close_up(view, body, LONG_BODY);
    let ratio = close.scale / plane.scale;
    for f in forces.iter_mut().chain(&mut parts) {
        f.at = (f.at - g) * ratio;
    }
    laid[body].origin = (laid[body].origin - g) * ratio;
    let scale = close.scale;
    let draw = move |board: &mut Board| {
        surfaces(board, view, &close, &laid, body, -g * ratio);
        close.outline(board, view, &laid, body, Role::Body);
        board.dot(Vec2::ZERO);
        joined::letters(board, view, &close, &laid, Some(body));
        angle_of(board, view, &laid, body);
    };
    let (centre, pole, round) = (Vec2::ZERO, Vec2::ZERO, 27.0);
    let (unknown, axes, held, body) = (None, true, None, Box::new(draw));
    Some(Diagram { forces, couples, unknown, parts, turn, round, centre, pole, scale, axes, held, body })
}

/// Name of a force or couple of a joint.
fn name(view: &SceneView, joint: usize, symbol: &str) -> Vec<TextRun> {
    let whole = names::tagged(symbol, &names::joint(view.scene, joint));
    symbol::symbol(&names::free(view.problem, &[whole]))
}

/// The forces of the joints on a body in the plane.
fn joint_forces(view: &SceneView, plane: &PlaneLayout, laid: &[Laid], body: usize) -> Vec<ForceArrow> {
    let name = |joint: usize, symbol: &str| name(view, joint, symbol);
    let force = |at: Vec2, value: f64, towards: Vec2, label| ForceArrow::signed(at, towards, value, label);
    // Of the contact that ends here the equations have the force still, as 0.
    let pressing = |joint: usize, at: Vec2, value: f64, towards: Vec2, mut label: Vec<TextRun>| {
        let ends = view.scene.end == End::Leaves(joint);
        if ends {
            label.extend(symbol::upright("\u{a0}=\u{a0}0"));
            return ForceArrow { ends, ..ForceArrow::new(at, towards, 0.0, label).of(Role::Ghost) };
        }
        force(at, value, towards, label)
    };
    let mut forces = Vec::new();
    for (j, joint) in view.scene.joints.iter().enumerate() {
        let found = |q: Quantity| view.solved(q, Owner::Joint(j)).unwrap_or(0.0);
        for (i, spot) in joint.kind.spots().enumerate().filter(|(_, s)| s.body == body) {
            let at = plane.spot(view, laid, spot);
            // The force on the second body of a hinge is the opposite one.
            let side = if i == 0 { 1.0 } else { -1.0 };
            match joint.kind {
                JointKind::Pin { .. } | JointKind::Hinge { .. } => {
                    for (symbol, quantity, towards) in
                        [("X", Quantity::PinX, Vec2::RIGHT), ("Y", Quantity::PinY, Vec2::UP)]
                    {
                        forces.push(force(at, found(quantity), towards, name(j, symbol)).on(side));
                    }
                }
                JointKind::Guide { at, line, mu_k, .. } => {
                    // What carries the line is pressed where the other body is.
                    let at = plane.spot(view, laid, at);
                    let direction = plane.direction(view, laid, line);
                    let normal = found(Quantity::Normal);
                    forces.push(pressing(j, at, normal, direction.left(), name(j, "N")).on(side));
                    if mu_k.is_some() {
                        let up = pose::upward([direction.x, direction.y]);
                        let rubs = force(at, found(Quantity::Friction), direction * up, name(j, "F"));
                        forces.push(rubs.on(side).of(Role::Friction));
                    }
                }
                JointKind::Contact { at, radius_m, surface, rolls, mu_k, teeth } => {
                    let at = plane.spot(view, laid, at);
                    let normal = plane.normal(view, laid, surface, at);
                    let foot = at - normal * (view.of(radius_m) * plane.scale);
                    forces.push(pressing(j, foot, found(Quantity::Normal), normal, name(j, "N")).on(side));
                    if rolls || mu_k.is_some() {
                        let right = normal.right();
                        let (quantity, up) = match teeth {
                            true => (Quantity::RimForce, 1.0),
                            false => (Quantity::Friction, pose::upward([right.x, right.y])),
                        };
                        let rubs = force(foot, found(quantity), right * up, name(j, "F"));
                        forces.push(rubs.on(side).of(Role::Friction));
                    }
                }
                JointKind::Cord { place_m, beyond, .. } => {
                    let place_m =
                        beyond.filter(|(to, _)| to.body == body).map_or(place_m, |(_, place)| place);
                    let far = vec2(view.of(place_m[0]), view.of(place_m[1])) * plane.scale;
                    forces.push(force(at, found(Quantity::Tension), (far - at).unit(), name(j, "T")));
                }
            }
        }
    }
    forces
}

/// The forces of springs and the given ones on a body in the plane.
fn given_forces(view: &SceneView, plane: &PlaneLayout, laid: &[Laid], body: usize) -> Vec<ForceArrow> {
    let force = |at: Vec2, value: f64, towards: Vec2, label| ForceArrow::signed(at, towards, value, label);
    let mut forces = Vec::new();
    for (s, strut) in view.scene.struts.iter().enumerate().filter(|(_, strut)| !strut.twists()) {
        let pull = view.solved(Quantity::SpringForce, Owner::Strut(s)).unwrap_or(0.0);
        let (near, far) = plane.ends(view, laid, strut);
        let label = || symbol::symbol(r"F_{\mathrm{s}}");
        if strut.at.body == body {
            forces.push(force(near, pull, (far - near).unit(), label()));
        }
        if matches!(strut.to, StrutEnd::Spot(spot) if spot.body == body) {
            forces.push(force(far, pull, (near - far).unit(), label()));
        }
    }
    for push in view.scene.pushes.iter().filter(|p| p.at.body == body && !p.blow) {
        let given = view.symbol(push.force_n);
        let label = if given.is_empty() { symbol::symbol("P") } else { given };
        let towards = joined::towards(view, plane, laid, push);
        forces.push(force(plane.spot(view, laid, push.at), view.of(push.force_n), towards, label));
    }
    forces
}

/// All couples on a body in the plane: the given ones, those of welds, of torsion springs and of the drive.
fn couples_in_the_plane(view: &SceneView, body: usize, clockwise: bool) -> Vec<Turning> {
    let mut couples = couples_on(view, body, clockwise);
    for j in 0..view.scene.joints.len() {
        let Some(moment) = view.solved(Quantity::Moment, Owner::Joint(j)) else { continue };
        for (i, _) in view.scene.joints[j].kind.spots().enumerate().filter(|(_, s)| s.body == body) {
            let side = if i == 0 { 1.0 } else { -1.0 };
            let couple = Turning::signed(moment, name(view, j, "M"));
            couples.push(Turning { value: side * moment, ..couple });
        }
    }
    let twisting = view.scene.struts.iter().enumerate().filter(|(_, strut)| strut.at.body == body);
    let springs = twisting
        .filter_map(|(s, _)| Some((Owner::Strut(s), view.solved(Quantity::Moment, Owner::Strut(s))?)));
    let drive = view.solved(Quantity::Drive, Owner::Body(body)).map(|moment| (Owner::Body(body), moment));
    for (of, moment) in springs.chain(drive) {
        let value = if clockwise { -moment } else { moment };
        let letter = if matches!(of, Owner::Strut(_)) { r"M_{\mathrm{s}}" } else { "M" };
        couples.push(Turning::signed(value, symbol::symbol(letter)));
    }
    couples
}

/// What a body in the plane stands on or leans against, cut away, as a reference; what is fixed is drawn off by `shift`.
fn surfaces(
    board: &mut Board,
    view: &SceneView,
    plane: &PlaneLayout,
    laid: &[Laid],
    body: usize,
    shift: Vec2,
) {
    for joint in &view.scene.joints {
        let (at, radius, surface) = match joint.kind {
            JointKind::Guide { at, line, one_sided: true, .. } if at.body == body => {
                (at, 0.0, plane.direction(view, laid, line))
            }
            JointKind::Contact { at, radius_m, surface, .. } if at.body == body => {
                let place = plane.spot(view, laid, at);
                let radius = view.of(radius_m) * plane.scale;
                match surface {
                    Surface::Line(line) => (at, radius, plane.direction(view, laid, line)),
                    Surface::Arc { centre_m, radius_m, .. } => {
                        let place_m = vec2(view.of(centre_m[0]), view.of(centre_m[1]));
                        let (centre, round) =
                            (place_m * plane.scale + shift, view.of(radius_m) * plane.scale);
                        let (middle, half) = ((place - centre).angle_of(), CUT / round);
                        board.arc(centre, round, middle - half, middle + half, Role::Ghost);
                        continue;
                    }
                }
            }
            _ => continue,
        };
        let foot = plane.spot(view, laid, at) - surface.left() * radius;
        let long = radius + CUT;
        board.line(foot - surface * long, foot + surface * long, Role::Ghost);
    }
}

/// The angle of the leading body, where its axis lies.
fn angle_of(board: &mut Board, view: &SceneView, laid: &[Laid], body: usize) {
    let Some(planar) = view.scene.planar(body).filter(|_| view.scene.lead() == Some(body)) else { return };
    let given = match view.scene.end {
        End::Angle(_, n) => Some(n),
        End::AtOnce => planar.start_deg,
        _ => None,
    };
    // The angle that is found bears the letter of the one at the start.
    let started = match planar.start_deg {
        Some(Num::Datum(i)) => view.problem.data[i].tex.split('_').next().unwrap_or_default(),
        _ => "",
    };
    let label = match given {
        Some(n) => view.symbol(n),
        None if started.is_empty() => Vec::new(),
        None => symbol::symbol(&names::free(view.problem, &[1, 2].map(|i| format!("{started}_{i}")))),
    };
    let [x, y] = planar.from.components();
    let (corner, zero) = (laid[body].origin, vec2(x, y));
    let axis = laid[body].axis;
    let (round, between) = (2.0 * std::f64::consts::PI, axis.angle_of() - zero.angle_of());
    let turned = between - round * (between / round).round();
    if label.is_empty() || turned.abs() < 0.1 {
        return;
    }
    let from = zero.angle_of();
    // Of what does not turn, beyond the arrow of the surface.
    let radius = if view.scene.bodies[body].turns { ANGLE } else { ANGLE + SHORTEST };
    board.line(corner, corner + zero * (radius + 14.0), Role::Ghost);
    board.arc(corner, radius, from, from + turned, Role::Dimension);
    let spots = on_arc(corner, radius, from, turned, MIDDLE_FIRST);
    board.label(vec![label], Role::Dimension, (LabelTie::Clear, 4.0), spots);
}

/// Both diagrams with the sign between them.
fn equation(view: &SceneView, diagram: &Diagram, desc: &mut Vec<String>) -> Board {
    let Diagram { forces, couples, parts, body, .. } = diagram;
    let centre = diagram.centre;
    let scale = common(forces, parts);
    let mut one = Board::new();
    body(&mut one);
    lever_arms(&mut one, diagram);
    arrows(&mut one, forces, scale);
    for c in couples {
        turning(&mut one, centre, 20.0, c, Role::Force);
    }
    let mut two = Board::new();
    body(&mut two);
    let drawn = arrows(&mut two, parts, scale);
    match diagram.turn.as_ref().filter(|t| t.value.abs() > 1e-12) {
        Some(t) => turning(&mut two, centre, diagram.round, t, Role::Motion),
        None if drawn => {}
        None => two.wish_for(sign("0", centre, TEXT)),
    }
    desc.push(told(view, diagram));
    let free = if scale.is_some() { "scale" } else { "free" };
    desc.push(view.words.get(&format!("figure.forces.{free}")).to_owned());
    let caption = |name: &str| view.words.get(&format!("figure.forces.{name}")).replace(' ', "\u{a0}");
    let mut captions: Vec<Vec<TextRun>> = Vec::new();
    if view.scene.thrown().is_some() && view.scene.end != End::AtOnce {
        captions.push(symbol::upright(caption("slipping")));
        desc.push(view.words.get("figure.forces.while_slipping").to_owned());
    }
    if scale.is_none() {
        captions.push(symbol::upright(caption("caption")));
    }
    if let Some(f) = &diagram.held {
        captions.push([f.clone(), symbol::upright(caption("caption_held"))].concat());
    }
    if let Some((_, what)) = &diagram.unknown {
        captions.push(symbol::upright(caption(&format!("caption_{what}"))));
        desc.push(view.words.get(&format!("figure.forces.{what}")).to_owned());
    }
    let (mine, theirs) = (one.frame(), two.frame());
    if let (Some(f), Some(h)) = (mine, theirs) {
        let wide: f64 = 58.0;
        // Beside the sign there is room for a label of an arrow that points to it.
        let label = |forces: &[ForceArrow], sense: f64| {
            let ends = forces.iter().filter(|f| f.towards.x * f.value * sense > 0.9 * f.value.abs());
            ends.map(|f| symbol::width(&f.label, TEXT)).fold(0.0, f64::max)
        };
        let (before, after) = (wide.max(20.0 + label(forces, 1.0)), wide.max(20.0 + label(parts, -1.0)));
        let middle = f.high.x + before;
        let mut equals = Board::new();
        equals.wish_for(sign("=", vec2(middle, 0.0), 26.0));
        if diagram.axes {
            let corner = vec2(middle - 10.0, -64.0);
            for (name, way) in [("x", Vec2::RIGHT), ("y", Vec2::UP)] {
                let tip = corner + way * 24.0;
                equals.arrow(corner, tip, Role::Dimension);
                let spots = vec![(tip, way)];
                equals.label(vec![symbol::italic(name)], Role::Dimension, (LabelTie::Near, 2.0), spots);
            }
        }
        two.shift(vec2(middle + after - h.low.x, 0.0));
        // The sign comes first: all other labels make room for it.
        equals.put(one);
        equals.put(two);
        if let (false, Some(all)) = (captions.is_empty(), equals.frame()) {
            let below = LabelWish::note(Vec::new(), CAPTION, vec2(middle, all.low.y), Vec2::DOWN);
            equals.wish_for(LabelWish { rows: captions, gap: 12.0, tie: LabelTie::Loose, ..below });
        }
        return equals;
    }
    one
}

fn sign(text: &str, at: Vec2, size: f64) -> LabelWish {
    let note = LabelWish::note(symbol::upright(text), size, at, Vec2::UP);
    LabelWish { gap: -size * 0.4, tie: LabelTie::Near, ..note }
}

/// Pixels per newton in both diagrams, `None` where the smallest arrow would be too short to be seen.
fn common(forces: &[ForceArrow], parts: &[ForceArrow]) -> Option<f64> {
    let seen = |list: &[ForceArrow]| {
        let most = list.iter().map(|f| f.value.abs()).fold(0.0, f64::max);
        let drawn = |f: &&ForceArrow| f.value.is_finite() && f.value.abs() > NOTHING * most;
        list.iter().filter(drawn).map(|f| (f.value.abs(), f.most)).collect::<Vec<_>>()
    };
    let all = [seen(forces), seen(parts)].concat();
    let scale = all.iter().map(|(value, most)| most / value).fold(f64::INFINITY, f64::min);
    let least = all.iter().map(|(value, _)| *value).fold(f64::INFINITY, f64::min);
    (scale.is_finite() && scale * least >= SHORT).then_some(scale)
}

/// Draws arrows, to the given scale if there is one; false if there is nothing to draw.
fn arrows(board: &mut Board, forces: &[ForceArrow], pixels: Option<f64>) -> bool {
    let most = forces.iter().map(|f| f.value.abs()).fold(0.0, f64::max);
    let mut any = false;
    // One scale for all of them, such that none is longer than it may be.
    let room =
        |f: &ForceArrow| if f.value.abs() > 0.0 { f.most * most / (LONGEST * f.value.abs()) } else { 1.0 };
    let scale = forces.iter().map(room).fold(1.0, f64::min).max(0.5) * LONGEST;
    for f in forces.iter().filter(|f| f.acts(most)) {
        any = true;
        let long = match pixels {
            _ if f.ends => SHORTEST,
            Some(pixels) => pixels * f.value.abs(),
            None => (scale * f.value.abs() / most).max(SHORTEST),
        };
        let towards = f.towards * f.value.signum();
        let at = f.at + f.aside;
        let (from, to) = if f.push { (at - towards * long, at) } else { (at, at + towards * long) };
        board.arrow(from, to, f.role);
        let (end, out) = if f.push { (from, -towards) } else { (to, towards) };
        let side = towards.left();
        let near = end - out * 8.0;
        let far = end - out * 22.0;
        let beside = [(near, side), (near, -side), (far, side), (far, -side)];
        // Friction lies on a line of the surface, which goes on beyond its head.
        let first = usize::from(f.role == Role::Friction) * 2;
        let mut spots = beside.to_vec();
        spots.insert(first, (end, out));
        board.label(vec![f.label.clone()], f.role, (LabelTie::Clear, 4.0), spots);
    }
    any
}

/// From the point of the moments square to the lines of action, each with its symbol.
fn lever_arms(board: &mut Board, diagram: &Diagram) {
    let most = diagram.forces.iter().map(|f| f.value.abs()).fold(0.0, f64::max);
    let acts = |f: &&ForceArrow| f.acts(most);
    for f in diagram.forces.iter().filter(acts).filter(|f| !f.arm.is_empty()) {
        let foot = f.at + f.towards * (diagram.pole - f.at).dot(&f.towards);
        let out = (foot - diagram.pole).unit();
        if (foot - diagram.pole).norm() < NEAR_POLE {
            continue;
        }
        // Where a force runs from there to the foot, the arm stands beside it, away from the arrow whose arm it is.
        let covered = |g: &&ForceArrow| {
            (g.at - diagram.pole).norm() < 1.0 && g.towards.dot(&out) * g.value.signum() > 0.95
        };
        let aside = match diagram.forces.iter().filter(acts).any(|g| covered(&g)) {
            true => f.towards * -f.value.signum() * BESIDE,
            false => Vec2::ZERO,
        };
        let (from, to) = (diagram.pole + aside, foot + aside);
        board.double_arrow(from, to, Role::Dimension);
        if (f.at - foot).norm() > 1.0 {
            board.line(f.at, foot, Role::Ghost);
        }
        let (middle, side) = (from.middle(to), f.towards * -f.value.signum());
        let spots = vec![(middle, side), (middle, -side)];
        board.label(vec![f.arm.clone()], Role::Dimension, (LabelTie::Near, 3.0), spots);
    }
}

/// A curved arrow about a point.
fn turning(board: &mut Board, centre: Vec2, radius: f64, turn: &Turning, role: Role) {
    if turn.value.abs() < 1e-300 || !turn.value.is_finite() {
        return;
    }
    let sense = turn.value.signum();
    // A wide one goes round a part of the body, a narrow one nearly all round its point.
    let (mid, half) =
        if radius > 45.0 { (vec2(-0.8, 1.0).angle_of(), 0.5) } else { (vec2(-0.35, 1.0).angle_of(), 1.9) };
    board.curved_arrow(centre, radius, mid - sense * half, mid + sense * half, role);
    let around = [vec2(-0.6, 1.0).unit(), vec2(0.6, 1.0).unit(), Vec2::LEFT, Vec2::RIGHT];
    board.wish(turn.label.clone(), around.map(|d| (centre + d * radius, d)).to_vec(), role);
}

/// What the diagrams show, in words.
fn told(view: &SceneView, diagram: &Diagram) -> String {
    let way = |towards: Vec2| {
        let degrees = towards.angle_of() * 180.0 / std::f64::consts::PI;
        let rounded = shown::decimals(if degrees < -0.5 { degrees + 360.0 } else { degrees.abs() }, 0);
        view.words.say("figure.forces.way", &[("angle", &rounded)])
    };
    let turn = |t: &Turning| {
        let name = if t.value < 0.0 { "figure.turn.clockwise" } else { "figure.turn.counter" };
        format!("{} {}", symbol::plain(&t.label), view.words.get(name))
    };
    let list = |forces: &[ForceArrow], turns: &mut dyn Iterator<Item = &Turning>| {
        let most = forces.iter().map(|f| f.value.abs()).fold(0.0, f64::max);
        let mut items: Vec<String> = forces
            .iter()
            .filter(|f| f.acts(most))
            .map(|f| format!("{} {}", symbol::plain(&f.label), way(f.towards * f.value.signum())))
            .collect();
        items.extend(turns.filter(|t| t.value.abs() > 1e-12).map(turn));
        if items.is_empty() { "0".to_owned() } else { items.join("; ") }
    };
    let acting = list(&diagram.forces, &mut diagram.couples.iter());
    let made = list(&diagram.parts, &mut diagram.turn.iter());
    view.words.say("figure.forces.text", &[("forces", &acting), ("kinetic", &made)])
}
