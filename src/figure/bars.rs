//! Energy bars: what there is at the start and what is put in, beside what there is at the end and what has become heat. Both
//! bars are equally high; where they are not, nothing is drawn.
use crate::bank::{FigureLabels, Problem};
use crate::figure::joined::{PlaneLayout, ground, towards};
use crate::figure::view::SceneView;
use crate::num::{shown, trig};
use crate::picture::board::{Board, LabelWish, TEXT};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Picture, Role, symbol};
use crate::problem::maker::Variant;
use crate::scene::{Couple, Degree, Joint, Label, Owner, Quantity, Start};
use crate::words::Words;

/// Kinds of energy, by the number of their area.
const KINDS: [&str; 6] = ["translation", "rotation", "spring", "gravity", "work", "heat"];
/// Height of the bars.
const HIGH: f64 = 210.0;
/// Width of a bar.
const WIDE: f64 = 74.0;
/// Space between the bars.
const APART: f64 = 74.0;
/// Distance of the lines of a pattern.
const STEP: f64 = 8.0;
/// Shares of the sum below this are not drawn.
const SMALL: f64 = 2e-4;
/// What doubles may leave between the two sums.
const EQUAL: f64 = 1e-6;

/// Energies in J, by kind, at the start (with what is put in) and at the end (with what has left).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energies {
    pub(crate) start: [f64; 6],
    pub(crate) end: [f64; 6],
}

impl Energies {
    /// Is none of them negative, and are both sums equal?
    fn holds(&self) -> bool {
        let (a, b) = self.sums();
        let whole = self.start.iter().chain(&self.end).all(|x| x.is_finite() && *x >= -1e-12);
        whole && a > 0.0 && (a - b).abs() <= EQUAL * a.max(b)
    }
    /// The sum at the start and at the end.
    pub fn sums(&self) -> (f64, f64) {
        (self.start.iter().sum(), self.end.iter().sum())
    }
}

/// The energies of a variant; `None` where the solver does not say enough of them, where there is no motion, or where a datum is
/// looked for.
pub fn energies(problem: &Problem, variant: &Variant, words: &Words) -> Option<Energies> {
    let view = SceneView::new(problem, variant, words, FigureLabels::Values)?;
    let scene = view.scene;
    if scene.is_still() || scene.carried.is_some() || scene.formulas.found.is_some() {
        return None;
    }
    if scene.bodies.iter().any(|b| b.planar.is_some()) {
        return joined_bodies(&view);
    }
    // Not what is asked of another scene.
    let is_own = |label: Label| !matches!(label.of, Owner::Asked(_));
    let sum_of = |q: Quantity| -> f64 {
        let of = variant.solved.entries.iter().filter(|e| e.label.quantity == q && is_own(e.label));
        of.map(|e| e.value()).sum()
    };
    // In phases nothing says here how the bodies share the energy at the start.
    if scene.goes_in_phases() && scene.thrown().is_none() {
        return None;
    }
    let (mut start, mut end) = ([0.0; 6], [0.0; 6]);
    let kinetic = view.solved(Quantity::KineticEnergy, Owner::Scene).unwrap_or(0.0);
    let share = view.solved(Quantity::RotationalFraction, Owner::Scene).unwrap_or(0.0);
    (end[0], end[1]) = (kinetic * (1.0 - share), kinetic * share);
    // Gravity, counted from the lower of both positions of all bodies together.
    let gained = gained(&view);
    (start[3], end[3]) = if gained > 0.0 { (0.0, gained) } else { (-gained, 0.0) };
    for spring in scene.springs() {
        let (k, x) = (view.of(spring.stiffness_n_m), view.of(spring.stretch_m));
        let force = view.solved(Quantity::Tension, Owner::Tie(spring.tie))?;
        start[2] += 0.5 * k * x * x;
        end[2] += 0.5 * force * force / k;
    }
    end[5] = sum_of(Quantity::Heat);
    let work = sum_of(Quantity::WorkPull);
    let had = |s: &Start| match s {
        Start::Speed(c, n) => {
            let (body, v, along) = (&scene.bodies[c.body], view.of(*n), c.degree == Degree::Along);
            let inertia = if along { view.kilograms(body) } else { view.inertia(body) };
            Some((usize::from(!along), 0.5 * inertia * v * v))
        }
        Start::Lamina { .. } => None,
    };
    // What moves at the start, by its kind.
    let given: Vec<(usize, f64)> = scene.start.iter().filter_map(had).collect();
    // Couples on bodies that also move: their work has the sign that makes the bars equal.
    let turned = |c: &Couple| view.solved(Quantity::Phi, Owner::Body(c.body)).unwrap_or(0.0);
    let turning: f64 = scene.couples.iter().map(|c| view.of(c.moment_n_m) * turned(c)).sum();
    let moving: f64 = given.iter().map(|(_, energy)| energy).sum();
    let thrown = scene.thrown().is_some();
    let mut tries = Vec::new();
    for sign in [1.0, -1.0] {
        let work = work + sign * turning;
        let mut first = Energies { start, end };
        *(if work >= 0.0 { &mut first.start[4] } else { &mut first.end[4] }) = work.abs();
        if thrown {
            given.iter().for_each(|(kind, energy)| first.start[*kind] += energy);
        } else if moving > 0.0 {
            // One freedom: what is missing is what all bodies together had, shared as at the end.
            let (a, b) = first.sums();
            let missing = b - a;
            if missing < moving * (1.0 - EQUAL) {
                continue;
            }
            let share = if kinetic > 0.0 { share } else { 1.0 - moving / missing };
            first.start[0] += missing * (1.0 - share);
            first.start[1] += missing * share;
        }
        tries.push(first);
    }
    tries.into_iter().find(Energies::holds)
}

/// What all bodies together gain of potential energy.
fn gained(view: &SceneView) -> f64 {
    let gravity = view.of(view.scene.gravity_m_s2);
    let rise = |i: usize| view.solved(Quantity::Rise, Owner::Body(i)).unwrap_or(0.0);
    view.scene.bodies.iter().enumerate().map(|(i, b)| rise(i) * view.kilograms(b) * gravity).sum()
}

/// Energies of bodies that are joined in the plane and start from rest: speeds from the solver, heights, stretches and paths of
/// forces from where the bodies lie. Where a guide rubs, what is missing at the end has become heat.
fn joined_bodies(view: &SceneView) -> Option<Energies> {
    let scene = view.scene;
    let plane = PlaneLayout::new(view)?;
    let laid = plane.at_end(view)?.swap_remove(0);
    if (0..scene.bodies.len()).any(|b| view.started(b).next().is_some())
        || scene.pushes.iter().any(|p| p.turns || p.blow)
    {
        return None;
    }
    let (mut start, mut end) = ([0.0; 6], [0.0; 6]);
    let gravity = if scene.lies_level() { 0.0 } else { view.of(scene.gravity_m_s2) };
    let (mut gained, mut work) = (0.0, 0.0);
    for (b, body) in scene.bodies.iter().enumerate() {
        let square = |quantity: Quantity| {
            let speed = view.solved(quantity, Owner::Body(b)).unwrap_or(0.0);
            speed * speed
        };
        let mass = view.kilograms(body);
        let rise = (plane.centre(view, &laid, b) - plane.centre(view, &plane.start, b)).y / plane.scale;
        gained += mass * gravity * rise;
        end[0] += 0.5 * mass * square(Quantity::V);
        if body.turns {
            end[1] += 0.5 * view.inertia(body) * square(Quantity::Omega);
        }
    }
    (start[3], end[3]) = if gained > 0.0 { (0.0, gained) } else { (-gained, 0.0) };
    for strut in &scene.struts {
        let k = view.of(strut.stiffness_n_m);
        let [stretch, after] = [&plane.start, &laid].map(|laid| plane.stretch(view, laid, strut));
        start[2] += 0.5 * k * stretch * stretch;
        end[2] += 0.5 * k * after * after;
    }
    for push in &scene.pushes {
        let [from, to] = [&plane.start, &laid].map(|laid| plane.spot(view, laid, push.at) / plane.scale);
        let gained = match push.toward_m.map(|place| ground(view, place)) {
            Some(place) => (place - from).norm() - (place - to).norm(),
            None => (to - from).dot(&towards(view, &plane, &laid, push)),
        };
        work += view.of(push.force_n) * gained;
    }
    for couple in &scene.couples {
        let (before, after) = (plane.start[couple.body].axis, laid[couple.body].axis);
        let turned = vec2(before.dot(&after), before.perp(&after)).angle_of();
        let clockwise = scene.planar(couple.body).is_some_and(|p| p.clockwise);
        work += view.of(couple.moment_n_m) * if clockwise == couple.forward { -turned } else { turned };
    }
    *(if work >= 0.0 { &mut start[4] } else { &mut end[4] }) = work.abs();
    let mut energies = Energies { start, end };
    let rubs = |j: &Joint| j.kind.mu_k().is_some();
    if scene.joints.iter().any(rubs) {
        let (before, after) = energies.sums();
        energies.end[5] = before - after;
    }
    energies.holds().then_some(energies)
}

/// The bars; `None` where [`energies`] has none.
pub fn picture(problem: &Problem, variant: &Variant, words: &Words) -> Option<Picture> {
    let energies = energies(problem, variant, words)?;
    let total = energies.sums().0;
    let mut board = Board::new();
    let mut desc = Vec::new();
    let bars = [
        (&energies.start, "start", 0.0, 0.0, Vec2::LEFT),
        (&energies.end, "end", WIDE + APART, WIDE + APART + WIDE, Vec2::RIGHT),
    ];
    for (values, name, left, edge, out) in bars {
        let mut y = 0.0;
        // The middle of each part, and what it is.
        let mut told: Vec<(f64, String)> = Vec::new();
        for (kind, value) in values.iter().enumerate() {
            if *value < SMALL * total {
                continue;
            }
            let high = HIGH * value / total;
            area(&mut board, vec2(left, y), vec2(WIDE, high), kind);
            let name = words.get(&format!("figure.energy.{}", KINDS[kind]));
            told.push((y + high / 2.0, format!("{name} {} J", figures(words, *value))));
            y += high;
        }
        let list: Vec<&str> = told.iter().map(|(_, text)| text.as_str()).collect();
        let separator = if words.number("0.1").contains(',') { "; " } else { ", " };
        desc.push(words.say(&format!("figure.energy.text_{name}"), &[("list", &list.join(separator))]));
        // Labels apart from each other, in the order of the parts.
        let step = 23.0;
        let mut places: Vec<f64> = told.iter().map(|(y, ..)| *y).collect();
        for _ in 0..40 {
            for i in 1..places.len() {
                let near = step - (places[i] - places[i - 1]);
                if near > 0.0 {
                    places[i] += near / 2.0;
                    places[i - 1] -= near / 2.0;
                }
            }
        }
        for ((y, text), place) in told.iter().zip(&places) {
            let at = |x: f64, y: f64| vec2(edge + out.x * x, y);
            let knee = at(22.0, *place);
            board.lines(&[at(0.0, *y), at(6.0, *y), knee], false, Role::Dimension);
            board.wish_for(note(text, knee, out));
        }
        board.wish_for(note(
            words.get(&format!("figure.energy.{name}")),
            vec2(left + WIDE / 2.0, -2.0),
            Vec2::DOWN,
        ));
    }
    board.line(vec2(-14.0, 0.0), vec2(2.0 * WIDE + APART + 14.0, 0.0), Role::Axis);
    board.line(vec2(WIDE, HIGH), vec2(WIDE + APART, HIGH), Role::Ghost);
    let sum = format!("{}\u{a0}J", figures(words, total));
    board.wish_for(note(&sum, vec2(WIDE + APART / 2.0, HIGH), Vec2::UP));
    Some(board.finish(words.get("figure.energy.title").to_owned(), desc.join(" ")))
}

fn note(text: &str, at: Vec2, towards: Vec2) -> LabelWish {
    LabelWish::note(symbol::upright(text.replace(' ', "\u{a0}")), TEXT, at, towards)
}

/// A part of a bar, with a pattern of its own.
fn area(board: &mut Board, low: Vec2, size: Vec2, kind: usize) {
    let at = |x: f64, y: f64| low + vec2(x, y);
    let corners = [low, at(size.x, 0.0), low + size, at(0.0, size.y)];
    board.lines(&corners, true, Role::Area(u8::try_from(kind).unwrap_or(0)));
    let steps = |most: f64| (1..).map(|i| f64::from(i) * STEP).take_while(move |s| *s < most);
    let (slanted, mirrored) = (matches!(kind, 1 | 5), matches!(kind, 3 | 5));
    for (drawn, mirrored) in [(slanted, false), (mirrored, true)] {
        // Slanted lines y = x - s, cut by the box; mirrored for the other slant.
        for s in steps(size.x + size.y).map(|s| s - size.y).filter(|_| drawn) {
            let (a, b) = (s.max(0.0), (s + size.y).min(size.x));
            let x = |t: f64| if mirrored { size.x - t } else { t };
            if b - a > 1.0 {
                board.line(at(x(a), a - s), at(x(b), b - s), Role::Hatch);
            }
        }
    }
    for y in steps(size.y - 1.0).filter(|_| kind == 2) {
        board.line(at(0.0, y), at(size.x, y), Role::Hatch);
    }
    for x in steps(size.x - 1.0).filter(|_| kind == 4) {
        board.line(at(x, 0.0), at(x, size.y), Role::Hatch);
    }
}

/// A number with four significant figures, in the words of the language.
pub fn figures(words: &Words, x: f64) -> String {
    if x.abs() < 1e-300 || !x.is_finite() {
        return "0".to_owned();
    }
    let power = trig::log10(x.abs()).floor();
    let decimals = (3.0 - power).clamp(0.0, 9.0) as usize;
    words.number(&shown::decimals(x, decimals)).replace('-', "−")
}
