//! Graphs for solutions: speed and friction over the way of a wheel on a spring, angular speed over the angle of a pinned
//! body, the two speeds that meet where a thrown body begins to roll.
//!
//! Every point of a curve is the scene with another end, solved by both roads ([`maker::ending`]): no formula stands here. What a
//! solver refuses is left out of the curve.
use crate::bank::{FigureLabels, Problem};
use crate::figure::bars::figures;
use crate::figure::names;
use crate::figure::view::SceneView;
use crate::picture::board::{Board, LabelTie, LabelWish, TEXT};
use crate::picture::vector::{Direction, Vec2, vec2};
use crate::picture::{Picture, Role, RunStyle, TextRun, symbol};
use crate::plot::{Axis, AxisScale};
use crate::problem::maker::{self, Variant};
use crate::scene::{Coordinate, Degree, End, Num, Owner, Quantity, Scene, Slope, Span, Tie};
use crate::solve::outcome::Solved;
use crate::words::Words;

/// Points of a curve.
const POINTS: u32 = 30;
/// Width of the field.
const WIDE: f64 = 360.0;
/// Height of the field.
const HIGH: f64 = 190.0;
/// Size of the numbers at the ticks.
const TICKS: f64 = 13.0;

/// A curve: its points in SI (angles in degrees), number of its look, label.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(crate) points: Vec<(f64, f64)>,
    /// Which line.
    pub look: u8,
    pub(crate) label: Vec<TextRun>,
}

impl Curve {
    /// Its height between its points; 0 outside.
    fn value(&self, x: f64) -> f64 {
        let pair = self.points.windows(2).find(|w| w[0].0 <= x && x <= w[1].0);
        pair.map_or(0.0, |w| {
            let span = w[1].0 - w[0].0;
            if span > 0.0 { w[0].1 + (w[1].1 - w[0].1) * (x - w[0].0) / span } else { w[0].1 }
        })
    }
}

/// A marked place on the first axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    pub(crate) x: f64,
    /// On the curve.
    pub y: f64,
    pub(crate) label: String,
}

/// The same scene with another end, one for each value, solved.
fn sampled(scene: &Scene, variant: &Variant, ends: impl Iterator<Item = (f64, End)>) -> Vec<(f64, Solved)> {
    let scene = Scene { heading: None, ..scene.clone() };
    ends.filter_map(|(x, end)| Some((x, maker::ending(&scene, end, &variant.data)?))).collect()
}

fn curve(solved: &[(f64, Solved)], quantity: Quantity, body: usize) -> Vec<(f64, f64)> {
    let of = |(x, s): &(f64, Solved)| Some((*x, value(s, quantity, body).filter(|y| y.is_finite())?));
    solved.iter().filter_map(of).collect()
}

fn value(solved: &Solved, quantity: Quantity, body: usize) -> Option<f64> {
    let of = |owner: Owner| solved.get(crate::scene::Label { quantity, of: owner }).map(|e| e.value());
    of(Owner::Body(body)).or_else(|| of(Owner::Scene))
}

/// Shares from 0 to 1 in so many steps, closer at both ends, where curves bend.
fn shares(steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |i| {
        let t = f64::from(i) / f64::from(steps);
        t * t * (3.0 - 2.0 * t)
    })
}

/// Speed and friction over the distance from release, as far as the scene looks, for a body on a spring; empty for others.
pub fn spring_curves(problem: &Problem, variant: &Variant) -> Option<SpringCurves> {
    let scene = &problem.cases.get(variant.case)?.scene;
    scene.springs().next()?;
    let End::Travel(at @ Coordinate { body, degree: Degree::Along }, asked) = scene.end else { return None };
    let of = |n: Num| scene.value(n, &variant.data);
    let asked = of(asked);
    let turn = value(&variant.solved, Quantity::DTurn, body).filter(|d| d.is_finite() && *d < 20.0 * asked);
    // The end that is asked ends the motion, unless the whole of it is asked about.
    let (turn, far) = match scene.span {
        Span::ToEnd => (None, asked),
        Span::ToTurningPoint => (turn, turn.unwrap_or(1.6 * asked)),
    };
    let least = far * 1e-6;
    let ends = shares(POINTS).map(|s| {
        let x = (far * s).clamp(least, far * (1.0 - 1e-9));
        (x, End::Travel(at, Num::Fixed(x)))
    });
    let solved = sampled(scene, variant, ends);
    let (speed, friction) = (curve(&solved, Quantity::V, body), curve(&solved, Quantity::Friction, body));
    let mu = scene.ties.iter().find_map(|t| match t {
        Tie::Roll { body: b, mu_s: Some(mu), .. } if *b == body => Some(of(*mu)),
        _ => None,
    });
    let limit = mu.zip(value(&variant.solved, Quantity::Normal, body)).map(|(mu, n)| mu * n);
    Some(SpringCurves { body, asked, turn, speed, friction, limit })
}

/// What [`spring_curves`] finds.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringCurves {
    /// Index of the body.
    pub body: usize,
    /// Distance that is asked.
    pub asked: f64,
    /// Distance of the turning point.
    pub turn: Option<f64>,
    /// Speed over distance.
    pub speed: Vec<(f64, f64)>,
    /// Friction over distance.
    pub friction: Vec<(f64, f64)>,
    /// `mu_s N`.
    pub limit: Option<f64>,
}

/// All graphs of a variant, by name; none where nothing teaches.
pub fn all(problem: &Problem, variant: &Variant, words: &Words) -> Vec<(String, Picture)> {
    let mut list = Vec::new();
    let Some(view) = SceneView::new(problem, variant, words, FigureLabels::Values) else { return list };
    if let Some(curves) = spring_curves(problem, variant) {
        if curves.speed.len() > 1 {
            list.push(("graph-speed".to_owned(), speed(&view, &curves)));
        }
        if curves.friction.len() > 1 {
            list.push(("graph-friction".to_owned(), friction(&view, &curves)));
        }
    }
    if let Some(picture) = swing(&view) {
        list.push(("graph-swing".to_owned(), picture));
    }
    if let Some(picture) = slip(&view) {
        list.push(("graph-slip".to_owned(), picture));
    }
    list
}

/// A quantity over the way, with the place that is asked marked, and what else stands in the graph.
fn over_the_way(
    view: &SceneView,
    c: &SpringCurves,
    (quantity, name, unit): (Quantity, &str, &'static str),
    curves: Vec<Curve>,
    (limits, more): (Vec<f64>, Vec<Mark>),
) -> Picture {
    let asked = value(&view.variant.solved, quantity, c.body);
    let asked = asked.map(|y| Mark { x: c.asked, y, label: word(view, "asked") });
    let (x, y) = ((word(view, "distance"), "m"), (word(view, name), unit));
    let marks = asked.into_iter().chain(more).collect();
    Graph { words: view.words, x, y, curves, limits, marks }.picture()
}

fn speed(view: &SceneView, c: &SpringCurves) -> Picture {
    let v = |q: Quantity| value(&view.variant.solved, q, c.body);
    let far = c.speed.last().map_or(0.0, |p| p.0);
    let fastest = v(Quantity::DAtVMax).filter(|x| *x <= far).zip(v(Quantity::VMax));
    let fastest = fastest.map(|(x, y)| Mark { x, y, label: word(view, "equilibrium") });
    let turning = c.turn.map(|x| Mark { x, y: 0.0, label: word(view, "turning") });
    let line = Curve { points: c.speed.clone(), look: 0, label: symbol::symbol("v") };
    let marks = fastest.into_iter().chain(turning).collect();
    over_the_way(view, c, (Quantity::V, "speed", "m/s"), vec![line], (Vec::new(), marks))
}

fn friction(view: &SceneView, c: &SpringCurves) -> Picture {
    let label = symbol::symbol(&names::friction(view, c.body));
    let far = c.friction.last().map_or(1.0, |p| p.0);
    let mut curves = vec![Curve { points: c.friction.clone(), look: 1, label }];
    let limits: Vec<f64> = c.limit.map_or_else(Vec::new, |limit| vec![limit, -limit]);
    for limit in &limits {
        let mut label = symbol::symbol(r"\mu_s N");
        if limit.is_sign_negative() {
            label.insert(0, symbol::run("−", RunStyle::Upright));
        }
        curves.push(Curve { points: vec![(0.0, *limit), (far, *limit)], look: 2, label });
    }
    let level = view.scene.bodies[c.body].line.is_some_and(|l| l.slope == Slope::Level);
    let name = if level { "friction_level" } else { "friction" };
    over_the_way(view, c, (Quantity::Friction, name, "N"), curves, (limits, Vec::new()))
}

/// Angular speed over the angle of a pinned body.
fn swing(view: &SceneView) -> Option<Picture> {
    let (body, pin) = view.scene.pinned()?;
    let End::Angle(at, asked) = view.scene.end else { return None };
    let (from, asked) = (view.of(pin.start_deg?), view.of(asked));
    let span = asked - from;
    if span.abs() < 1.0 {
        return None;
    }
    let far = from + span * 1.2;
    // Each point is a quadrature of its own: fewer of them.
    let ends = shares(POINTS / 2).map(|s| {
        let x = from + (far - from) * s.max(1e-4);
        (x, End::Angle(at, Num::Fixed(x)))
    });
    let mut points = curve(&sampled(view.scene, view.variant, ends), Quantity::Omega, body);
    if points.len() < 4 {
        return None;
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let word = |name: &str| word(view, name);
    let y = value(&view.variant.solved, Quantity::Omega, body)?;
    let marks = vec![Mark { x: asked, y, label: word("asked") }];
    let line = Curve { points, look: 0, label: symbol::symbol(r"\omega") };
    let (x, y) = ((word("angle"), "°"), (word("spin"), "rad/s"));
    Some(Graph { words: view.words, x, y, curves: vec![line], limits: Vec::new(), marks }.picture())
}

/// The speed of the centre and that of the turning rim over time, until they meet and a little on.
fn slip(view: &SceneView) -> Option<Picture> {
    let thrown = view.scene.thrown()?;
    let (body, radius) = (thrown.body, view.of(thrown.radius_m));
    let at = Coordinate { body, degree: Degree::Along };
    let ending = |end: End| maker::ending(view.scene, end, &view.variant.data);
    let met = ending(End::Rolling(at))?;
    let when = value(&met, Quantity::T, body).filter(|t| t.is_finite() && *t > 0.0)?;
    let asked = match view.scene.end {
        End::Time(_, n) => Some(view.of(n)),
        _ => None,
    };
    let far = asked.unwrap_or(0.0).max(when * 1.3);
    // Speeds with their signs: the displacement of a short while shows the sense.
    let signed = |t: f64| -> Option<(f64, f64)> {
        let then = ending(End::Time(at, Num::Fixed(t)))?;
        Some((value(&then, Quantity::V, body)?, value(&then, Quantity::Omega, body)?))
    };
    let (v0, w0) = (view.of(thrown.speed_m_s), view.of(thrown.spin_rad_s));
    // Both are straight while it slips: two points are enough; magnitudes get the sign nearer to the line.
    let common = {
        let v = value(&met, Quantity::V, body)?;
        let half = signed(when / 2.0)?;
        let fits = |end: f64| (((v0 + end) / 2.0).abs() - half.0).abs();
        if fits(v) <= fits(-v) { v } else { -v }
    };
    let after = {
        let (v, _) = signed(far)?;
        if (v - common).abs() <= (-v - common).abs() { v } else { -v }
    };
    let word = |name: &str| word(view, name);
    let mut rim = view.symbol(thrown.radius_m);
    if rim.is_empty() {
        rim = symbol::symbol("R");
    }
    rim.extend(symbol::symbol(r"\omega"));
    let curves = vec![
        Curve { points: vec![(0.0, v0), (when, common), (far, after)], look: 0, label: symbol::symbol("v") },
        Curve { points: vec![(0.0, radius * w0), (when, common), (far, after)], look: 1, label: rim },
    ];
    let mut marks = vec![Mark { x: when, y: common, label: word("rolls") }];
    if let Some(t) = asked {
        let y = if t < when { v0 + (common - v0) * t / when } else { after };
        marks.push(Mark { x: t, y, label: word("asked") });
    }
    let (x, y) = ((word("time"), "s"), (word("speeds"), "m/s"));
    Some(Graph { words: view.words, x, y, curves, limits: Vec::new(), marks }.picture())
}

fn word(view: &SceneView, name: &str) -> String {
    view.words.get(&format!("figure.graph.{name}")).to_owned()
}

/// A value as words tell it: 0 where nobody sees it on an axis of this range.
fn settled(value: f64, range: f64) -> f64 {
    if value.abs() < 1e-3 * range { 0.0 } else { value }
}

/// A graph: names and units of its axes, and what stands between them.
struct Graph<'a> {
    words: &'a Words,
    x: (String, &'static str),
    y: (String, &'static str),
    curves: Vec<Curve>,
    /// Levels beyond which the field is hatched.
    limits: Vec<f64>,
    marks: Vec<Mark>,
}

/// Where values stand in the field of a graph.
struct Field {
    x: Axis,
    y: Axis,
}

impl Field {
    fn of(curves: &[Curve]) -> Self {
        let points = || curves.iter().flat_map(|c| &c.points);
        let low = points().map(|p| p.0).fold(f64::INFINITY, f64::min);
        let high = points().map(|p| p.0).fold(f64::NEG_INFINITY, f64::max);
        let low = if low > 0.0 && low < 1e-3 * high { 0.0 } else { low };
        let high = if high > low { high } else { low + 1.0 };
        let x = Axis { label: String::new(), scale: AxisScale::Linear, low, high };
        Self { x, y: Axis::around("", AxisScale::Linear, points().map(|p| p.1).chain([0.0])) }
    }

    fn at(&self, x: f64, y: f64) -> Vec2 {
        vec2(self.x.at(x) * WIDE, self.y.at(y) * HIGH)
    }
}

impl Graph<'_> {
    fn picture(self) -> Picture {
        let field = Field::of(&self.curves);
        let mut board = Board::new();
        self.axes(&mut board, &field);
        for c in &self.curves {
            let points: Vec<Vec2> = c.points.iter().map(|p| field.at(p.0, p.1)).collect();
            board.lines(&points, false, Role::Curve(c.look));
        }
        for m in &self.marks {
            let p = field.at(m.x, m.y);
            board.line(vec2(p.x, field.at(m.x, 0.0).y), p, Role::Ghost);
            board.circle(p, 3.6, Role::Dot);
        }
        self.names(&mut board);
        for m in &self.marks {
            let p = field.at(m.x, m.y);
            let up = if m.y >= 0.0 { 1.0 } else { -1.0 };
            let around = [(0.0, up), (-0.8, 0.6), (0.8, 0.6), (0.8, -0.6), (-0.8, -0.6), (0.0, -up)];
            let spots = around.map(|(x, y)| (p, vec2(x, y))).to_vec();
            let name = symbol::upright(m.label.replace(' ', "\u{a0}"));
            board.label(vec![name], Role::Dot, (LabelTie::Leader, 6.0), spots);
        }
        for c in &self.curves {
            let spot = |share: f64| {
                let x = field.x.low + (field.x.high - field.x.low) * share;
                field.at(x, c.value(x))
            };
            let sides = |s: f64| [(spot(s), vec2(-0.5, 0.85)), (spot(s), vec2(0.5, -0.85))];
            let spots = [0.12, 0.25, 0.8, 0.6, 0.4].into_iter().flat_map(sides).collect();
            board.label(vec![c.label.clone()], Role::Curve(c.look), (LabelTie::Leader, 5.0), spots);
        }
        let title = self.words.say("figure.graph.title", &[("y", &self.y.0), ("x", &self.x.0)]);
        board.finish(title, self.told(&field).replace('\u{a0}', " "))
    }

    fn text_at(&self, text: &str, at: Vec2, towards: Vec2, size: f64) -> LabelWish {
        LabelWish::note(symbol::upright(self.words.number(text).replace('-', "−")), size, at, towards)
    }

    /// Grid, axes, numbers at the ticks, hatched bands.
    fn axes(&self, board: &mut Board, field: &Field) {
        for t in field.y.ticks() {
            let y = t.at * HIGH;
            board.line(vec2(0.0, y), vec2(WIDE, y), Role::Grid);
            if !t.label.is_empty() {
                board.wish_for(self.text_at(&t.label, vec2(-2.0, y), Vec2::LEFT, TICKS));
            }
        }
        let (low, high) = (field.x.low, field.x.high);
        let round = Axis::around("", AxisScale::Linear, [low, high].into_iter());
        let slack = 1e-9 * (high - low);
        for t in round.ticks() {
            let value = round.low + (round.high - round.low) * t.at;
            if value < low - slack || value > high + slack {
                continue;
            }
            let x = field.x.at(value) * WIDE;
            board.line(vec2(x, 0.0), vec2(x, HIGH), Role::Grid);
            if !t.label.is_empty() {
                board.wish_for(self.text_at(&t.label, vec2(x, -4.0), Vec2::DOWN, TICKS));
            }
        }
        let level = |value: f64| field.y.at(value) * HIGH;
        board.line(vec2(0.0, level(0.0)), vec2(WIDE, level(0.0)), Role::Axis);
        board.line(Vec2::ZERO, vec2(0.0, HIGH), Role::Axis);
        for limit in &self.limits {
            // The band in which it does not slip is between the limits: outside is hatched.
            let y = level(*limit);
            board.hatch(vec2(0.0, y), vec2(WIDE, y), vec2(0.0, limit.signum()));
        }
    }

    /// The names of the axes.
    fn names(&self, board: &mut Board) {
        let name = self.text_at(&named(&self.x), vec2(WIDE / 2.0, 0.0), Vec2::DOWN, TEXT);
        board.wish_for(LabelWish { gap: 26.0, ..name });
        let title = named(&self.y);
        let half = symbol::width(&symbol::upright(title.clone()), TEXT) / 2.0;
        board.wish_for(self.text_at(&title, vec2(half - 30.0, HIGH + 6.0), Vec2::UP, TEXT));
    }

    /// What it shows, in words.
    fn told(&self, field: &Field) -> String {
        let words = self.words;
        let x = |x: f64| figures(words, settled(x, field.x.high - field.x.low));
        let y = |y: f64| figures(words, settled(y, field.y.high - field.y.low));
        let curve = |c: &Curve| {
            let show = |p: Option<&(f64, f64)>| p.map_or_else(Default::default, |p| (x(p.0), y(p.1)));
            let ((x0, y0), (x1, y1)) = (show(c.points.first()), show(c.points.last()));
            let label = symbol::plain(&c.label);
            let ends = [("curve", label.as_str()), ("x0", &x0), ("y0", &y0), ("x1", &x1), ("y1", &y1)];
            words.say("figure.graph.curve", &ends)
        };
        let mark =
            |m: &Mark| words.say("figure.graph.mark", &[("mark", &m.label), ("x", &x(m.x)), ("y", &y(m.y))]);
        let text = words.say("figure.graph.text", &[("y", &named(&self.y)), ("x", &named(&self.x))]);
        let told =
            std::iter::once(text).chain(self.curves.iter().map(curve)).chain(self.marks.iter().map(mark));
        told.collect::<Vec<_>>().join(" ")
    }
}

/// `speed (m/s)`, on one line.
fn named((text, unit): &(String, &str)) -> String {
    format!("{text} ({unit})").replace(' ', "\u{a0}")
}
