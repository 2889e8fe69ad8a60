//! Loads on cords that come from a rod over small pulleys, against formulas by hand: where the load has moved by `s(q)` at the angle `q` of the
//! rod, `(I + M s'^2) q'^2 / 2` is what the weight of the rod gives less what holds the load back. The formulas know no poses.
use crate::moving_lines::{G, near, read, told};
use slipstick::scene::ask::{Label, Owner, Quantity};
use slipstick::scene::pose::Obstacle;
use slipstick::solve::agree;
use slipstick::solve::ladder::{self, Wish};
use slipstick::solve::outcome::{Entry, Refusal, Solved};

const DOOR: f64 = 12.0;
const LOAD: f64 = 2.0;
const LENGTH: f64 = 1.2;
const FROM: f64 = 60.0;
const TO: f64 = 10.0;

/// A length with its first and second derivative by the angle of the door.
type Jet = [f64; 3];

/// Length of the cord from the end of the door to a place.
fn length([x, y]: [f64; 2], degrees: f64) -> Jet {
    let (s, c) = degrees.to_radians().sin_cos();
    let (p, rate) = ([LENGTH * c - x, LENGTH * s - y], [-LENGTH * s, LENGTH * c]);
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let d = dot(p, p).sqrt();
    let first = dot(p, rate) / d;
    [d, first, (dot(rate, rate) - dot(p, [rate[1], -rate[0]]) - first * first) / d]
}

/// Angular speed and acceleration of the door, speed of the load and force along its way, which has led from the start to here against
/// this force.
fn swung(start: f64, way: Jet, held: f64) -> [f64; 4] {
    let (weight, inertia) = (DOOR * G * LENGTH / 2.0, DOOR * LENGTH * LENGTH / 3.0 + LOAD * way[1] * way[1]);
    let sinks = FROM.to_radians().sin() - TO.to_radians().sin();
    let square = 2.0 * (weight * sinks - held * (way[0] - start)) / inertia;
    let moment = -weight * TO.to_radians().cos() - held * way[1];
    let alpha = (moment - LOAD * way[1] * way[2] * square) / inertia;
    let along = held + LOAD * (way[2] * square + way[1] * alpha);
    [square.sqrt(), alpha, way[1].abs() * square.sqrt(), along]
}

/// What both roads tell of the door and of a load that is placed and guided so.
fn found(placed: &str, rope: &str, shaft: &str) -> [f64; 5] {
    let (bodies, joints, swings) = scene(placed, rope, shaft);
    told(&bodies, &joints, swings, ["door.omega", "door.alpha", "load.v", "rope.tension", "shaft.normal"])
}

fn scene(placed: &str, rope: &str, shaft: &str) -> (String, String, &'static str) {
    let bodies = format!(
        "        door: {{mass: {DOOR} kg, shape: {{rod: {LENGTH} m}}, moves: in the plane, angle: from right}}
        load: {{mass: {LOAD} kg, moves: in the plane{placed}}}"
    );
    let joints = format!(
        "        O: {{pins: door.A}}\n        rope: {{{rope}}}\n        shaft: {{guides: load, {shaft}}}"
    );
    let swings = "      start: {door: {angle: 60 deg}}\n      end: {angle: {of: door, reaches: 10 deg}}";
    (bodies, joints, swings)
}

/// The load hangs straight below the pulley.
#[test]
fn a_load_below_its_pulley() {
    let [from, to] = [FROM, TO].map(|at| length([-0.2, 1.5], at));
    let [omega, alpha, v, tension] = swung(from[0], to, LOAD * G);
    for rope in
        ["ties: door.B, over: [-0.2 m, 1.5 m], to: load", "ties: load, over: [-0.2 m, 1.5 m], to: door.B"]
    {
        let all = found(", placed: [-0.2 m, 0.2 m]", rope, "along: vertical, through: [-0.2 m, 0 m]");
        near(all, [omega, alpha, v, tension, 0.0]);
    }
}

/// It is guided beside its pulley, to which the cord leads over another one: the cord is aslant, and its angle changes.
#[test]
fn a_load_beside_its_pulley() {
    let (aside, top): (f64, f64) = (-0.2, 1.4);
    let [from, to] = [FROM, TO].map(|at| length([-0.2, 1.5], at));
    let height = |beside: Jet| {
        let left = aside.hypot(0.2 - top) + from[0] - beside[0];
        let below = (left * left - aside * aside).sqrt();
        let first = -left * beside[1] / below;
        let second = (beside[1] * beside[1] - left * beside[2] - first * first) / below;
        [top - below, -first, -second]
    };
    let end = height(to);
    let [omega, alpha, v, upright] = swung(height(from)[0], end, LOAD * G);
    let below = top - end[0];
    let expected = [omega, alpha, v, upright * aside.hypot(below) / below, upright * aside / below];
    let rope = "ties: door.B, over: [[-0.2 m, 1.5 m], [-0.3 m, 1.4 m]], to: load";
    near(found(", placed: [-0.5 m, 0.2 m]", rope, "along: vertical, through: [-0.5 m, 0 m]"), expected);
}

/// It is drawn up a rough incline, toward a pulley on the line of its motion.
#[test]
fn a_load_on_a_rough_incline() {
    let [from, to] = [FROM, TO].map(|at| length([0.8, 1.5], at));
    let normal = LOAD * G * 0.75_f64.sqrt();
    let [omega, alpha, v, tension] = swung(from[0], to, LOAD * G / 2.0 + 0.2 * normal);
    let rope = "ties: door.B, over: [[0.8 m, 1.5 m], [0 m, 0 m]], to: load";
    let placed = format!(", placed: [{} m, -1 m]", -(3.0_f64.sqrt()));
    near(found(&placed, rope, "along: 30 deg, mu_k: 0.2"), [omega, alpha, v, tension, normal]);
}

/// How far the load is from its pulley bears on nothing before it comes there; what is beyond the end is not asked.
#[test]
fn a_load_that_comes_to_its_pulley_beyond_the_end() {
    let told = |placed: &str, end: &str| {
        let rope = "ties: door.B, over: [-0.5 m, 1 m], to: load";
        let (bodies, joints, _) = scene(placed, rope, "along: vertical, through: [-0.5 m, 0 m]");
        let (spin, end) = match end {
            "equilibrium" => ("", end.to_owned()),
            _ => (", spin: -1 rad/s", format!("{{{end}}}")),
        };
        let swings = format!("      start: {{door: {{angle: 80 deg{spin}}}}}\n      end: {end}");
        let bank = read(&bodies, &joints, &swings).unwrap();
        agree::solve(&bank.problems[0].cases[0].scene, &[G])
    };
    let omega = |placed: &str| {
        let solved = told(placed, "time: {of: door, is: 0.1 s}").unwrap();
        solved.get(Label { quantity: Quantity::Omega, of: Owner::Body(0) }).unwrap().value()
    };
    let (near, far) = (omega(", placed: [-0.5 m, 0.6 m]"), omega(", placed: [-0.5 m, -3 m]"));
    assert!((near / far - 1.0).abs() < 1e-14 && near > 0.0, "{near} {far}");
    let refused = told(", placed: [-0.5 m, 0.6 m]", "angle: {of: door, reaches: 10 deg}").unwrap_err();
    assert!(matches!(refused, Refusal::Beyond(Obstacle::Pulley(1))), "{refused:?}");
    let refused = told(", placed: [-0.5 m, 0.6 m]", "equilibrium").unwrap_err();
    assert!(matches!(refused, Refusal::Beyond(Obstacle::Pulley(1))), "{refused:?}");
}

/// Where the load would come to its pulley long after the end, on a shaft that rubs, nothing has to be looked for there: it took 38,361
/// places. The way after the time takes the time,.
#[test]
fn a_time_on_a_rough_shaft_is_looked_for_no_farther_than_it_lasts() {
    let told = |mu: &str, end: &str| {
        let rope = "ties: door.B, over: [[-0.2 m, 1.5 m], [-0.3 m, 1.4 m]], to: load";
        let shaft = format!("along: vertical, through: [-0.5 m, 0 m]{mu}");
        let (bodies, joints, _) = scene(", placed: [-0.5 m, 0.2 m]", rope, &shaft);
        let swings = format!("      start: {{door: {{angle: {FROM} deg}}}}\n      end: {{{end}}}");
        let bank = read(&bodies, &joints, &swings).unwrap();
        ladder::solve(&bank.problems[0].cases[0].scene, &[G], &Wish::default()).unwrap()
    };
    let value = |solved: &Solved, quantity: Quantity, of: Owner| {
        solved.get(Label { quantity, of }).map(Entry::value).unwrap()
    };
    for mu in ["", ", mu_k: 0.2"] {
        let (solved, taken) = told(mu, "time: {of: door, is: 0.3 s}");
        assert!(taken.count.evaluations < 10_000, "{}", taken.count.evaluations);
        let phi = value(&solved, Quantity::Phi, Owner::Body(0)).to_degrees();
        let (back, _) = told(mu, &format!("angle: {{of: door, reaches: {} deg}}", FROM - phi));
        assert!((value(&back, Quantity::T, Owner::Scene) - 0.3).abs() < 1e-12, "{phi}");
    }
}

/// Where it hangs has to be said, and a cord is no tie within one body.
#[test]
fn what_a_cord_over_a_pulley_does_not_say() {
    let shaft = "along: vertical, through: [-0.2 m, 0 m]";
    let (bodies, joints, swings) = scene("", "ties: door.B, over: [-0.2 m, 1.5 m], to: load", shaft);
    let bank = read(&bodies, &joints, swings).unwrap();
    let refusal = agree::solve(&bank.problems[0].cases[0].scene, &[G]).unwrap_err();
    assert!(matches!(refusal, Refusal::Unplaced(1)), "{refusal:?}");
    let (bodies, joints, swings) = scene("", "ties: door.B, over: [0 m, 1 m], to: door.A", shaft);
    let found = read(&bodies, &joints, swings).unwrap_err();
    assert!(found[0].contains("ties two bodies"), "{found:?}");
}
