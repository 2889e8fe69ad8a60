//! Motions in phases by formulas derived by hand for each scene: slip beside a block on a cord and to any end, two contacts that slip,
//! two freedoms with speeds at the start, and instants with springs where something rubs.
use slipstick::bank::{labels, load};
use slipstick::scene::{Quantity, Scene};
use slipstick::solve::agree::{prove, solve};
use slipstick::solve::outcome::{Refusal, Solved, Unsupported};

const G: f64 = 9.81;

/// The mass m, and g.
const DATA: [f64; 2] = [2.0, G];

/// The values of these quantities; all checks hold, and each is enclosed.
fn told(scene: &str, names: &[&str]) -> (Vec<f64>, Solved) {
    told_by(scene, names, true)
}

/// The scene, and what is found of it.
fn solved(text: &str) -> (Scene, Solved) {
    let (scene, solved) = attempted(text);
    (scene, solved.unwrap_or_else(|e| panic!("{e:?}\n{text}")))
}

/// The scene, and what is found of it or why nothing is.
fn attempted(scene: &str) -> (Scene, Result<Solved, Refusal>) {
    let indented: String = scene.lines().map(|l| format!("      {l}\n")).collect();
    let text = format!(
        "bank: phases\ntitle: Phases\nproblems:\n  phases:\n    title: Phases\n    data:\n      m: {{name: mass, unit: kg, draw: always 2}}\n    \
         scene:\n{indented}    questions:\n      kinetic_energy: {{ask: the kinetic energy}}\n"
    );
    let bank = load::scenes_only(&text, "phases.yaml").unwrap_or_else(|f| panic!("{f:#?}\n{text}"));
    let scene = bank.problems[0].cases[0].scene.clone();
    let solved = solve(&scene, &DATA);
    (scene, solved)
}

/// The same where something comes to rest by what the numbers are, which no enclosure tells.
fn told_by(text: &str, names: &[&str], enclosed: bool) -> (Vec<f64>, Solved) {
    let (scene, mut solved) = solved(text);
    assert!(!enclosed || prove(&scene, &DATA, &mut solved), "{text}");
    assert!(solved.all_hold(), "{:?}\n{text}", solved.checks);
    let of = |name: &&str| {
        let entry = solved.get(labels::named(&scene, name).expect(name)).expect(name);
        assert!(!enclosed || entry.bound.is_some(), "{name} is enclosed");
        entry.value()
    };
    (names.iter().map(of).collect(), solved)
}

fn compare(names: &[&str], found: &[f64], expected: &[f64]) {
    assert_eq!(names.len(), expected.len());
    for ((name, a), b) in names.iter().zip(found).zip(expected) {
        assert!((a - b).abs() <= 1e-12 * a.abs().max(b.abs()), "{name}: {a} {b}");
    }
}

/// A ball with topspin is drawn along a level by a block that hangs on a cord: friction drives it on until it rolls.
#[test]
fn a_ball_slips_beside_a_block_on_a_cord_to_any_end() {
    let scene = |end: &str| {
        format!(
            "surfaces: {{lane: level}}
bodies:
  ball: {{mass: m, shape: {{sphere: 0.1 m}}, moves: along lane}}
  load: {{mass: 1 kg, moves: vertically}}
ties:
  - slips: {{body: ball, on its: rim, mu_s: 0.6, mu_k: 0.2}}
  - cord: {{from: {{body: ball, tied at: centre, leaves: forward}}, to: {{body: load, tied at: centre, leaves: up}}}}
start: {{ball: {{speed: 1 m/s, spin: 30 rad/s}}}}
end: {end}"
        )
    };
    let (m, load, r, v0, w0) = (2.0, 1.0, 0.1, 1.0, 30.0);
    let (i, f) = (0.4 * m * r * r, 0.2 * m * G);
    let (a, alpha) = ((load * G + f) / (m + load), -f * r / i);
    let t = (r * w0 - v0) / (a - r * alpha);
    let (v, w) = (v0 + a * t, w0 + alpha * t);
    let (x, phi) = (v0 * t + a * t * t / 2.0, w0 * t + alpha * t * t / 2.0);
    let slid = (r * w0 - v0) * t / 2.0;
    let names = [
        "t",
        "ball.v",
        "load.v",
        "omega",
        "ball.displacement",
        "load.rise",
        "phi",
        "slip_distance",
        "heat",
        "friction",
        "tension",
        "mu_required",
    ];
    let rolling = load * G / (m + load + i / (r * r));
    let expected =
        [t, v, v, w, x, -x, phi, slid, f * slid, f, load * (G - a), i / (r * r) * rolling / (m * G)];
    compare(&names, &told(&scene("{rolling: ball}"), &names).0, &expected);
    // Rolling on: for a time, and up to a place.
    for late in [0.3, 1.0] {
        let (v1, x1) = (v + rolling * late, x + v * late + rolling * late * late / 2.0);
        let names =
            ["t", "ball.v", "ball.displacement", "omega", "phi", "friction", "tension", "slip_distance"];
        let ended = [
            t + late,
            v1,
            x1,
            v1 / r,
            phi + (x1 - x) / r,
            -i / (r * r) * rolling,
            load * (G - rolling),
            slid,
        ];
        let by = |end: &str| told(&scene(end), &names).0;
        let timed = by(&format!("{{time: {{of: ball, is: {} s}}}}", t + late));
        compare(&names, &timed, &ended);
        compare(&names, &by(&format!("{{travel: {{of: ball, by: {x1} m}}}}")), &ended);
        compare(&names, &by(&format!("{{speed: {{of: load, reaches: {v1} m/s}}}}")), &ended);
    }
    // At the start, before it has moved.
    let names = ["ball.a", "alpha", "friction", "tension", "ball.v"];
    compare(&names, &told(&scene("at once"), &names).0, &[a, alpha, f, load * (G - a), v0]);
}

/// Two cylinders joined by a light rod at their centres slip and come to roll one after the other.
#[test]
fn two_contacts_slip_and_roll_one_after_the_other() {
    let scene = |end: &str| {
        format!(
            "surfaces: {{lane: level}}
bodies:
  front: {{mass: m, shape: {{disc: 0.2 m}}, moves: along lane}}
  rear: {{mass: 3 kg, shape: {{hoop: 0.1 m}}, moves: along lane}}
ties:
  - slips: {{body: front, on its: rim, mu_s: 0.5, mu_k: 0.3}}
  - slips: {{body: rear, on its: rim, mu_s: 0.5, mu_k: 0.2}}
  - link: {{from: {{body: front, tied at: centre, leaves: back}}, to: {{body: rear, tied at: centre, leaves: forward}}}}
start: {{front: {{speed: 6 m/s, spin: 24 rad/s}}, rear: {{spin: 0 rad/s}}}}
end: {end}"
        )
    };
    // Turns as speeds of the rim: the disc's I/R^2 is 1 kg, the hoop's 3 kg.
    let (f, g) = (0.3 * 2.0 * G, 0.2 * 3.0 * G);
    let a = -(f + g) / 5.0;
    let t1 = (6.0 - 24.0 * 0.2) / (f / 1.0 - a);
    let (v1, rear1) = (6.0 + a * t1, g / 3.0 * t1);
    // The disc rolls, and is slowed down by the rear one alone.
    let b = -g / (5.0 + 1.0);
    let t2 = (v1 - rear1) / (g / 3.0 - b);
    let v2 = v1 + b * t2;
    let (slid, rear_slid) = (
        1.2 * t1 / 2.0,
        (6.0 * t1 + a * t1 * t1 / 2.0) + (v1 * t2 + b * t2 * t2 / 2.0) - g / 6.0 * (t1 + t2) * (t1 + t2),
    );
    let names =
        ["t", "front.v", "front.omega", "rear.omega", "front.slip_distance", "rear.slip_distance", "heat"];
    let expected = [t1 + t2, v2, v2 / 0.2, v2 / 0.1, slid, rear_slid, f * slid + g * rear_slid];
    let (found, _) = told(&scene("{rolling: rear}"), &names);
    compare(&names, &found, &expected);
    // On a level nothing changes any more, and nothing rubs.
    let (found, _) = told(&scene(&format!("{{time: {{of: front, is: {} s}}}}", t1 + t2 + 0.7)), &names);
    compare(&names[1..], &found[1..], &expected[1..]);
    // While the rear one still slips.
    let names = ["front.v", "front.friction", "rear.friction", "tension", "front.mu_required"];
    let (found, _) = told(&scene(&format!("{{time: {{of: front, is: {} s}}}}", t1 + t2 / 2.0)), &names);
    let held = -b / (2.0 * G);
    compare(&names, &found, &[v1 + b * t2 / 2.0, -b, -g, -(2.0 * b + b), held]);
}

/// A block on a rough level and a disc that unwinds from the cord between them, both set going: two freedoms.
#[test]
fn two_freedoms_start_with_speeds() {
    let scene = |spring: &str, start: &str, end: &str| {
        format!(
            "surfaces: {{table: level}}
bodies:
  block: {{mass: m, moves: along table}}
  disc: {{mass: 4 kg, shape: {{disc: 0.3 m}}, moves: vertically, positive: down}}
ties:
  - slides: {{body: block, mu_k: 0.25}}
  - cord: {{from: {{body: block, tied at: centre, leaves: forward}}, to: {{body: disc, wound on: rim, leaves: up}}, name: thread}}
{spring}start: {start}
end: {end}"
        )
    };
    let (m, disc, v0, w0, t) = (2.0, 4.0, 1.5, 2.0, 0.8);
    // The disc's r^2/I is 2/m.
    let force = |pull: f64| (G + 0.25 * G + pull / m) / (1.0 / m + 1.0 / disc + 2.0 / disc);
    let tension = force(0.0);
    let (a, down) = (tension / m - 0.25 * G, G - tension / disc);
    let alpha = (down - a) / 0.3;
    let v = v0 + a * t;
    let names = ["block.v", "disc.v", "omega", "block.displacement", "disc.displacement", "heat", "tension"];
    let way = |v: f64, a: f64| v * t + a * t * t / 2.0;
    let fall = v0 + 0.3 * w0;
    let expected =
        [v, fall + down * t, w0 + alpha * t, way(v0, a), way(fall, down), 0.25 * m * G * way(v0, a), tension];
    let start = "{block: {speed: 1.5 m/s}, disc: {spin: 2 rad/s}}";
    let (found, _) = told(&scene("", start, "{time: {of: block, is: 0.8 s}}"), &names);
    compare(&names, &found, &expected);
    // At an instant, held back by a spring besides.
    let spring = "  - cord: {from: {body: block, tied at: centre, leaves: back}, spring: {stiffness: 100 N/m, stretch: 0.12 m, attached: rigidly}, name: band}\n";
    let pulled = force(12.0);
    let names = ["block.a", "disc.a", "thread.tension", "band.tension"];
    let (found, _) = told(&scene(spring, start, "at once"), &names);
    compare(&names, &found, &[(pulled - 12.0) / m - 0.25 * G, G - pulled / disc, pulled, 12.0]);
    // From rest static friction holds the block, and the disc unwinds alone.
    let pulled = G / (3.0 / disc);
    let (found, _) = told(&scene(spring, "at rest", "at once"), &names);
    compare(&names, &found, &[0.0, G - pulled / disc, pulled, 12.0]);
}

/// Two crates on a light rod come to rest together, beside a drum that turns. Held by both of their frictions, more than each could
/// take; let go where both cannot, and then they go back.
#[test]
fn two_crates_that_stop_together_are_held_together() {
    let scene = |pull: f64, end: &str| {
        format!(
            "surfaces: {{table: level}}
bodies:
  rear: {{mass: m, moves: along table}}
  front: {{mass: 3 kg, moves: along table}}
  drum: {{mass: 4 kg, shape: {{disc: 0.3 m}}, moves: about a fixed axle}}
ties:
  - slides: {{body: rear, mu_s: 0.5, mu_k: 0.3}}
  - slides: {{body: front, mu_s: 0.4, mu_k: 0.2}}
  - link: {{from: {{body: rear, tied at: centre, leaves: forward}}, to: {{body: front, tied at: centre, leaves: back}}}}
  - cord: {{from: {{body: front, tied at: centre, leaves: back}}, pulled with: {pull} N}}
start: {{rear: {{speed: 2 m/s}}, drum: {{spin: 5 rad/s}}}}
end: {end}"
        )
    };
    let names =
        ["t", "front.v", "rear.displacement", "rear.distance", "heat", "omega", "work_pull", "front.a"];
    let (rubs, t) = (1.2 * G, 3.0);
    let end = "{time: {of: front, is: 3 s}}";
    // Static friction holds 2.2 g, the rear crate at most g and the front one 1.2 g.
    for pull in [5.0, 18.0] {
        let way = 4.0 / (2.0 * (pull + rubs) / 5.0);
        let (found, solved) = told(&scene(pull, end), &names);
        compare(&names, &found, &[t, 0.0, way, way, rubs * way, 5.0, -pull * way, 0.0]);
        assert!(solved.regime.word().contains("forward"), "{}", solved.regime.word());
        let held = solved.checks.iter().filter(|c| c.kind.name() == "no_slip");
        let shares: Vec<f64> = held.map(|c| c.required / c.available).collect();
        assert_eq!(shares.len(), 2);
        assert!(shares.iter().all(|share| (share - pull / (2.2 * G)).abs() < 1e-12), "{shares:?}");
    }
    let pull = 30.0;
    let (there, back) = ((pull + rubs) / 5.0, (pull - rubs) / 5.0);
    let (stops, way) = (2.0 / there, 2.0 / there);
    let late = t - stops;
    let returned = back * late * late / 2.0;
    let expected = [
        t,
        back * late,
        way - returned,
        way + returned,
        rubs * (way + returned),
        5.0,
        pull * (returned - way),
        -back,
    ];
    compare(&names, &told(&scene(pull, end), &names).0, &expected);
    // Where they turn it ends, whether they can be held or not.
    for pull in [18.0, 30.0] {
        let (found, _) = told(&scene(pull, "{turning point: front}"), &["t", "front.v", "rear.displacement"]);
        let there = (pull + rubs) / 5.0;
        assert!(found[1] == 0.0);
        compare(&["t", "way"], &[found[0], found[2]], &[2.0 / there, 2.0 / there]);
    }
}

/// A ball with so much backspin that it comes to rest just as its slip ends: then it stays, and nothing is left of its energy.
#[test]
fn a_ball_stops_as_its_slip_ends() {
    let (t, way) = (2.0 / (0.2 * G), 4.0 / (0.4 * G));
    let names = ["t", "v", "omega", "kinetic_energy", "displacement", "slip_distance", "heat"];
    for (end, at) in [("{rolling: ball}", t), ("{time: {of: ball, is: 3 s}}", 3.0)] {
        let scene = format!(
            "surfaces: {{lane: level}}
bodies:
  ball: {{mass: m, shape: {{sphere: 0.1 m}}, moves: along lane}}
ties:
  - slips: {{body: ball, on its: rim, mu_s: 0.6, mu_k: 0.2}}
start: {{ball: {{speed: 2 m/s, spin: -50 rad/s}}}}
end: {end}"
        );
        compare(&names, &told_by(&scene, &names, false).0, &[at, 0.0, 0.0, 0.0, way, 3.5 * t, 14.0]);
    }
}

/// The front disc comes to roll down an incline while the rear one slips more and more: the end asks for the front one alone.
#[test]
fn one_disc_rolls_while_the_other_slips_on_and_on() {
    let scene = "surfaces: {hill: {slope: 30 deg}}
bodies:
  front: {mass: m, shape: {disc: 0.2 m}, moves: along hill}
  rear: {mass: 3 kg, shape: {disc: 0.1 m}, moves: along hill}
ties:
  - slips: {body: front, on its: rim, mu_s: 0.9, mu_k: 0.5}
  - slips: {body: rear, on its: rim, mu_s: 0.1, mu_k: 0.05}
  - link: {from: {body: front, tied at: centre, leaves: back}, to: {body: rear, tied at: centre, leaves: forward}}
start: {front: {speed: -2 m/s, spin: -30 rad/s}, rear: {spin: 0 rad/s}}
end: {rolling: front}";
    let cos = 0.75_f64.sqrt();
    let (f, g) = (0.5 * 2.0 * G * cos, 0.05 * 3.0 * G * cos);
    let a = -G / 2.0 - (f - g) / 5.0;
    let (rim, rear_rim) = (2.0 * f / 2.0, -2.0 * g / 3.0);
    let t = 4.0 / (rim - a);
    let (slid, rear_slid) = (2.0 * t, 2.0 * t - (a - rear_rim) * t * t / 2.0);
    let names =
        ["t", "front.v", "front.omega", "rear.omega", "front.slip_distance", "rear.slip_distance", "heat"];
    let v = 2.0 - a * t;
    let expected = [t, v, v / 0.2, -rear_rim * t / 0.1, slid, rear_slid, f * slid + g * rear_slid];
    compare(&names, &told(scene, &names).0, &expected);
}

/// A cord runs from the contact of a disc to a load: the load turns just as the slip ends, and what would then be is not asked.
#[test]
fn a_load_turns_as_the_slip_ends() {
    let scene = "surfaces: {lane: level}
bodies:
  disc: {mass: m, shape: {disc: 0.2 m}, moves: along lane}
  load: {mass: 1 kg, moves: vertically}
ties:
  - slips: {body: disc, on its: rim, mu_s: 0.1, mu_k: 0.05}
  - cord: {from: {body: disc, wound on: rim, leaves: bottom forward}, to: {body: load, tied at: centre, leaves: up}}
start: {disc: {speed: 1 m/s, spin: 20 rad/s}}
end: {turning point: load}";
    // The contact feels 2/3 of a kilogram.
    let friction = 0.05 * 2.0 * G;
    let tension = (G - 1.5 * friction) / 2.5;
    let t = 3.0 / (G - tension);
    let names = ["t", "load.v", "load.rise", "disc.v", "omega", "tension", "slip_distance"];
    let gain = (tension + friction) / 2.0 * t;
    let expected = [t, 0.0, 1.5 * t, 1.0 + gain, 20.0 - 2.0 * gain / 0.2, tension, 1.5 * t];
    compare(&names, &told(scene, &names).0, &expected);
}

/// The speed with which a body starts, though another one is told, is no end: both methods see that it leaves there.
#[test]
fn the_speed_of_the_start_is_no_end() {
    let (_, found) = solved(
        "surfaces: {hill: {slope: 5 deg}}
bodies:
  crate: {mass: m, moves: along hill}
  disc: {mass: 3 kg, shape: {disc: 0.45 m}, moves: along hill}
ties:
  - slides: {body: crate, mu_s: 0.7, mu_k: 0.35}
  - slips: {body: disc, on its: rim, mu_s: 0.45, mu_k: 0.25}
  - link: {from: {body: crate, tied at: centre, leaves: back}, to: {body: disc, tied at: centre, leaves: forward}}
start: {crate: {speed: 2 m/s}, disc: {spin: 0 rad/s}}
end: {speed: {of: disc, reaches: 2 m/s}}",
    );
    assert!(found.checks.iter().any(|c| c.kind.name() == "reaches" && !c.ok), "{:?}", found.checks);
}

/// Friction on a hoop leaves its top as it is: the cord from there bears nothing, and neither does what it holds.
#[test]
fn a_cord_at_the_centre_of_percussion_bears_nothing() {
    let (scene, found) = solved(
        "surfaces: {lane: level}
bodies:
  hoop: {mass: m, radius of gyration: 0.2 m, radii: {rim: 20 cm}, moves: along lane}
  drum: {mass: 6.3 kg, shape: {shell: 20 cm}, radii: {rim: 200 mm, hub: 15 cm}, moves: about a fixed axle}
  disc: {mass: 15.4 kg, shape: {disc: 470 mm}, radii: {hub: 150 mm}, moves: along lane}
ties:
  - slips: {body: hoop, on its: rim, mu_s: 0.57, mu_k: 0.17}
  - slips: {body: disc, on its: hub, mu_s: 0.54, mu_k: 0.14}
  - cord: {name: rope, from: {body: hoop, wound on: rim, leaves: top forward}, to: {body: drum, wound on: rim, leaves: front up}}
  - cord: {from: {body: drum, wound on: hub, leaves: top back}, to: {body: disc, tied at: centre, leaves: forward}}
start: {hoop: {spin: 13.6 rad/s}, disc: {speed: 0.6 m/s, spin: 4 rad/s}}
end: {time: {of: hoop, is: 0.5 s}}",
    );
    for name in ["rope.tension", "disc.friction", "drum.alpha"] {
        assert!(found.get(labels::named(&scene, name).expect(name)).expect(name).value() == 0.0, "{name}");
    }
}

/// A crate at the end of a cord that a hoop lets off as fast as it goes on: it starts at rest, whatever the last digits of the printed
/// radii, and stays; so the hoop comes to rest as its slip ends.
#[test]
fn what_the_ties_leave_at_rest_starts_at_rest() {
    let scene = |end: &str| {
        format!(
            "surfaces: {{lane: level}}
bodies:
  hoop: {{mass: m, shape: {{hoop: 0.1 m}}, radii: {{rim: 0.1 m, hub: 0.05 m}}, moves: along lane}}
  crate: {{mass: 3 kg, moves: along lane}}
ties:
  - slips: {{body: hoop, on its: rim, mu_s: 0.6, mu_k: 0.2}}
  - slides: {{body: crate, mu_s: 0.3, mu_k: 0.2}}
  - cord: {{from: {{body: hoop, wound on: hub, leaves: top back}}, to: {{body: crate, tied at: centre, leaves: forward}}}}
start: {{hoop: {{speed: -1 m/s, spin: 20 rad/s}}}}
end: {end}"
        )
    };
    let friction = 0.2 * 2.0 * G;
    let t = 1.0 / (0.3 * friction);
    let names = ["t", "hoop.v", "omega", "crate.v", "hoop.displacement", "tension", "crate.friction", "heat"];
    let ended = |at: f64, held: f64| [at, 0.0, 0.0, 0.0, -0.5 * t, held, -held, friction * 1.5 * t];
    let held = 0.4 * friction;
    compare(&names, &told_by(&scene("{rolling: hoop}"), &names, false).0, &ended(t, held));
}

/// The word for the way in which the first body goes.
fn direction(found: &Solved) -> &'static str {
    let word = found.words.iter().find(|(label, _)| label.quantity == Quantity::Direction);
    word.expect("the direction is told").1.as_str()
}

/// A disc with backspin slips forward while its turn, or the cord on its hub, counts backward: told is the way of its centre.
#[test]
fn the_direction_of_what_is_counted_by_its_turn_is_that_of_its_centre() {
    let scene = |end: &str| {
        format!(
            "surfaces: {{lane: level}}
bodies:
  disc: {{mass: m, shape: {{disc: 0.2 m}}, radii: {{rim: 0.2 m, hub: 0.05 m}}, moves: along lane}}
  load: {{mass: 0.5 kg, moves: vertically}}
ties:
  - slips: {{body: disc, on its: rim, mu_s: 0.5, mu_k: 0.2}}
  - cord: {{name: rope, from: {{body: disc, wound on: hub, leaves: top forward}}, to: {{body: load, tied at: centre, leaves: up}}}}
start: {{disc: {{speed: 5 m/s, spin: -20 rad/s}}}}
end: {end}"
        )
    };
    let names = ["disc.displacement", "disc.v", "phi", "omega"];
    // The load gains a + alpha r/4; the disc's I/r^2 is 1 kg.
    let friction = 0.4 * G;
    let tension = (G + friction / 2.0 - friction / 4.0) / (1.0 / 0.5 + 1.0 / 2.0 + 1.0 / 16.0);
    let (a, alpha) = ((tension - friction) / 2.0, (tension / 4.0 + friction) / 0.2);
    for (end, turned) in
        [("{turn: {of: disc, by: 1 rad}}", 1.0), ("{unwinds: {cord: rope, by: 0.15 m}}", 3.0)]
    {
        let t = (20.0 - f64::sqrt(400.0 - 2.0 * alpha * turned)) / alpha;
        let (found, solved) = told(&scene(end), &names);
        compare(&names, &found, &[5.0 * t + a * t * t / 2.0, 5.0 + a * t, turned, 20.0 - alpha * t]);
        assert_eq!(direction(&solved), "forward");
    }
}

/// A wheel with much backspin is slowed down by its friction and that of a block on a rod, stops with it and goes back before it rolls.
/// How it will roll is told alike whenever the motion is looked at.
#[test]
fn how_it_will_roll_is_told_of_where_its_slip_ends() {
    let scene = |end: &str| {
        format!(
            "surfaces: {{lane: level}}
bodies:
  wheel: {{mass: 4 kg, shape: {{disc: 0.2 m}}, moves: along lane}}
  block: {{mass: m, moves: along lane}}
ties:
  - slips: {{body: wheel, on its: rim, mu_s: 0.6, mu_k: 0.5}}
  - slides: {{body: block, mu_s: 0.3, mu_k: 0.25}}
  - link: {{from: {{body: wheel, tied at: centre, leaves: forward}}, to: {{body: block, tied at: centre, leaves: back}}}}
start: {{wheel: {{speed: 2 m/s, spin: -60 rad/s}}}}
end: {end}"
        )
    };
    let stops = 2.0 / (2.5 * G / 6.0);
    let rolls = (12.0 + 0.25 * G * stops) / (1.25 * G);
    let names = ["a_rolling", "friction_if_rolled", "mu_required"];
    let rolling = [G / 16.0, -G / 8.0, 1.0 / 32.0];
    for at in [0.2, 0.45, 0.8, 2.0] {
        let (found, solved) = told(&scene(&format!("{{time: {{of: wheel, is: {at} s}}}}")), &names);
        compare(&names, &found, &rolling);
        let ends = solved.checks.iter().find(|c| c.kind.name() == "slip_ends").expect("its slip ends");
        compare(&["slip ends"], &[ends.available], &[rolls]);
    }
    compare(&names, &told(&scene("{rolling: wheel}"), &names).0, &rolling);
    compare(&names, &told(&scene("{turning point: block}"), &names).0, &rolling);
}

/// Two crates on a light rod come to rest on a hill: held are they by both of their frictions, and kinetic friction is none of what acts.
#[test]
fn what_comes_to_rest_on_a_hill_needs_what_draws_it_alone() {
    let (_, found) = told(
        "surfaces: {hill: {slope: 15 deg}}
bodies:
  upper: {mass: 6 kg, moves: along hill}
  lower: {mass: m, moves: along hill}
ties:
  - slides: {body: upper, mu_s: 0.25, mu_k: 0.245}
  - slides: {body: lower, mu_s: 0.13, mu_k: 0.085}
  - link: {from: {body: upper, tied at: centre, leaves: forward}, to: {body: lower, tied at: centre, leaves: back}}
  - cord: {from: {body: upper, tied at: centre, leaves: forward}, pulled with: 14.5 N}
start: {upper: {speed: 0.9 m/s}}
end: {stops slipping: upper}",
        &["t"],
    );
    let (sin, cos) = 15f64.to_radians().sin_cos();
    let share = (8.0 * G * sin - 14.5) / ((1.5 + 0.26) * G * cos);
    let held: Vec<_> = found.checks.iter().filter(|c| c.kind.name() == "no_slip").collect();
    let expected = [1.5, 0.26].map(|limit| share * limit * G * cos);
    compare(&["upper", "lower"], &[held[0].required, held[1].required], &expected);
}

/// A disc is thrown up a hill, slips, rolls and turns: alone, and with a smooth crate behind it or a rough one, which turns with it.
#[test]
fn what_is_thrown_up_a_hill_turns_where_it_rolls() {
    let scene = |crates: &str, ties: &str, end: &str| {
        format!(
            "surfaces: {{hill: {{slope: 10 deg}}}}
bodies:
  disc: {{mass: m, shape: {{disc: 0.2 m}}, moves: along hill}}
{crates}ties:
  - slips: {{body: disc, on its: rim, mu_s: 0.6, mu_k: 0.3}}
{ties}start: {{disc: {{speed: 4 m/s, spin: 5 rad/s}}}}
end: {end}"
        )
    };
    let block = "  crate: {mass: 1 kg, moves: along hill}\n";
    let link = "  - link: {from: {body: disc, tied at: centre, leaves: back}, to: {body: crate, tied at: centre, leaves: forward}}\n";
    let rough = format!("  - slides: {{body: crate, mu_s: 0.3, mu_k: 0.1}}\n{link}");
    let (sin, cos) = 10f64.to_radians().sin_cos();
    for (bodies, ties, all, rubs) in [("", "", 2.0, 0.0), (block, link, 3.0, 0.0), (block, &rough, 3.0, 0.1)]
    {
        let friction = 0.6 * G * cos;
        let (drag, rim) = (all * G * sin + rubs * G * cos, friction);
        let first = (drag + friction) / all;
        let t1 = 3.0 / (first + rim);
        let v1 = 4.0 - first * t1;
        let then = drag / (all + 1.0);
        let slid = 1.5 * t1;
        let names = ["t", "disc.v", "disc.displacement", "slip_distance", "omega", "heat"];
        let at = |v: f64| {
            let t2 = (v1 - v) / then;
            let way = (4.0 + v1) / 2.0 * t1 + (v1 + v) / 2.0 * t2;
            [t1 + t2, v, way, slid, v / 0.2, friction * slid + rubs * G * cos * way]
        };
        compare(&names, &told(&scene(bodies, ties, "{turning point: disc}"), &names).0, &at(0.0));
        compare(
            &names,
            &told(&scene(bodies, ties, "{speed: {of: disc, reaches: 1 m/s}}"), &names).0,
            &at(1.0),
        );
        let [.., way, _, _, _] = at(0.5);
        for end in ["travel: {of: disc, by", "position: {of: disc, at"] {
            let end = format!("{{{end}: {way} m}}}}");
            compare(&names, &told(&scene(bodies, ties, &end), &names).0, &at(0.5));
        }
    }
}

/// A disc with much backspin turns while it still slips.
#[test]
fn what_spins_back_turns_while_it_slips() {
    let scene = "surfaces: {lane: level}
bodies:
  disc: {mass: m, shape: {disc: 0.2 m}, moves: along lane}
ties:
  - slips: {body: disc, on its: rim, mu_s: 0.5, mu_k: 0.2}
start: {disc: {speed: 2 m/s, spin: -60 rad/s}}
end: {turning point: disc}";
    let t = 2.0 / (0.2 * G);
    let names = ["t", "v", "displacement", "omega", "phi", "slip_distance"];
    let (w, phi) = (60.0 - 2.0 * 0.2 * G / 0.2 * t, 60.0 * t - 0.2 * G / 0.2 * t * t);
    compare(&names, &told(scene, &names).0, &[t, 0.0, t, w, phi, t + 0.2 * phi]);
}

/// Two wheels of a car that start alike come to roll at the same time; nothing hangs on which of them is the first.
#[test]
fn two_wheels_come_to_roll_at_one_time() {
    let scene = |rear: &str, end: &str| {
        format!(
            "surfaces: {{lane: level}}
bodies:
  front: {{mass: m, shape: {{disc: 0.2 m}}, moves: along lane}}
  rear: {{mass: {rear}, shape: {{disc: 0.2 m}}, moves: along lane}}
ties:
  - slips: {{body: front, on its: rim, mu_s: 0.6, mu_k: 0.3}}
  - slips: {{body: rear, on its: rim, mu_s: 0.6, mu_k: 0.3}}
  - link: {{from: {{body: front, tied at: centre, leaves: back}}, to: {{body: rear, tied at: centre, leaves: forward}}}}
start: {{front: {{speed: 3 m/s, spin: -5 rad/s}}, rear: {{spin: -5 rad/s}}}}
end: {end}"
        )
    };
    let t = 4.0 / (0.9 * G);
    let v = 3.0 - 0.3 * G * t;
    let names = ["front.v", "rear.omega", "front.slip_distance", "rear.slip_distance", "tension"];
    for rear in ["2 kg", "3.1 kg"] {
        for end in ["{time: {of: front, is: 1 s}}", "{rolling: rear}"] {
            let (found, _) = told(&scene(rear, end), &names);
            compare(&names[..4], &found[..4], &[v, v / 0.2, 2.0 * t, 2.0 * t]);
            assert!(found[4] == 0.0);
        }
        let at = 0.3;
        let (found, _) = told(&scene(rear, "{time: {of: front, is: 0.3 s}}"), &names);
        let slid = 4.0 * at - 0.45 * G * at * at;
        compare(&names[..4], &found[..4], &[3.0 - 0.3 * G * at, 3.0 * G * at - 5.0, slid, slid]);
    }
}

/// A ball that is pulled off its lane is told by the check of what presses it there, as anywhere.
#[test]
fn what_is_lifted_off_is_told_by_its_check() {
    let (_, found) = solved(
        "surfaces: {lane: level}
bodies:
  ball: {mass: m, shape: {sphere: 0.1 m}, radii: {rim: 0.1 m}, moves: along lane}
ties:
  - slips: {body: ball, on its: rim, mu_s: 0.9, mu_k: 0.2}
  - cord: {from: {body: ball, wound on: rim, leaves: bottom forward, at an angle: 60 deg}, pulled with: 30 N}
start: {ball: {speed: 5 m/s, spin: 0 rad/s}}
end: {time: {of: ball, is: 1 s}}",
    );
    let pressed = found.checks.iter().find(|c| c.kind.name() == "pressed").expect("it lies on a surface");
    let normal = 2.0 * G - 30.0 * 0.75_f64.sqrt();
    assert!(!pressed.ok && (pressed.available - normal).abs() < 1e-12, "{pressed:?}");
}

/// A hoop comes to roll just as a block beside it, on a smooth ramp, comes to rest: the hoop is held and rolls on, the block slides back.
#[test]
fn of_two_contacts_that_come_to_rest_each_is_held_or_not() {
    let scene = |end: &str| {
        format!(
            "surfaces: {{lane: level, ramp: {{slope: 30 deg}}}}
bodies:
  hoop: {{mass: m, shape: {{hoop: 1 m}}, moves: along lane}}
  block: {{mass: 1 kg, moves: along ramp}}
ties:
  - slips: {{body: hoop, on its: rim, mu_s: 0.3, mu_k: 0.25}}
  - slides: {{body: block, mu_s: 0, mu_k: 0}}
start: {{hoop: {{speed: 1 m/s, spin: 0 rad/s}}, block: {{speed: 1 m/s}}}}
end: {end}"
        )
    };
    let names = ["t", "hoop.v", "omega", "slip_distance", "block.v", "block.displacement", "block.distance"];
    let (stops, up) = (2.0 / G, 1.0 / G);
    let at = |t: f64| {
        let back = G / 4.0 * (t - stops) * (t - stops);
        [t, 0.5, 0.5, 1.0 / G, G / 2.0 * (t - stops), up - back, up + back]
    };
    let (found, solved) = told_by(&scene("{rolling: hoop}"), &names, false);
    compare(&names[..4], &found[..4], &at(stops)[..4]);
    assert_eq!(solved.regime.word(), "rolls_after");
    compare(&names, &told_by(&scene("{time: {of: hoop, is: 1 s}}"), &names, false).0, &at(1.0));
}

/// Bodies that have nothing to do with one another: one slides, of those at rest one begins to slide down its ramp, one stays.
#[test]
fn what_cannot_be_held_at_the_start_sets_off_whatever_else_is_at_rest() {
    let scene = "surfaces: {lane: level, ramp: {slope: 30 deg}}
bodies:
  thrown: {mass: m, moves: along lane}
  sliding: {mass: 1 kg, moves: along ramp}
  resting: {mass: 1 kg, moves: along lane}
ties:
  - slides: {body: thrown, mu_k: 0.1}
  - slides: {body: sliding, mu_s: 0.2, mu_k: 0.1}
  - slides: {body: resting, mu_s: 0.2, mu_k: 0.1}
start: {thrown: {speed: 1 m/s}, sliding: {speed: 0 m/s}, resting: {speed: 0 m/s}}
end: {time: {of: thrown, is: 0.1 s}}";
    let names = ["thrown.v", "sliding.v", "sliding.displacement", "resting.v", "heat"];
    let (down, rubs) = (G * (0.5 - 0.1 * 0.75_f64.sqrt()), 0.1 * G);
    let way = down * 0.005;
    let heat = 2.0 * rubs * (0.1 - rubs * 0.005) + rubs * 0.75_f64.sqrt() * way;
    let (found, _) = told_by(scene, &names, false);
    compare(&names, &found, &[1.0 - rubs * 0.1, down * 0.1, -way, 0.0, heat]);
    // Two discs that start rolling on a steep ramp both slip at once: that is told of each.
    let (scene, found) = solved(
        "surfaces: {ramp: {slope: 30 deg}}
bodies:
  one: {mass: m, shape: {disc: 1 m}, moves: along ramp}
  other: {mass: 1 kg, shape: {disc: 1 m}, moves: along ramp}
ties:
  - slips: {body: one, on its: rim, mu_s: 0.1, mu_k: 0.1}
  - slips: {body: other, on its: rim, mu_s: 0.1, mu_k: 0.1}
start: {one: {speed: 1 m/s, spin: 1 rad/s}, other: {speed: 1 m/s, spin: 1 rad/s}}
end: {time: {of: one, is: 0.1 s}}",
    );
    assert_eq!(found.regime.word(), "slips_through");
    for (body, m) in [("one", 2.0), ("other", 1.0)] {
        let value = |name: &str| {
            let label = labels::named(&scene, &format!("{body}.{name}")).expect(name);
            found.get(label).expect(name).value()
        };
        let names = ["v", "alpha", "friction_if_rolled"];
        let expected = [1.0 - down * 0.1, -2.0 * rubs * 0.75_f64.sqrt(), m * G / 6.0];
        compare(&names, &names.map(value), &expected);
    }
}

/// A drum hangs in a cord between two blocks: both slide, or both stay, or whether one does hangs on the other.
#[test]
fn two_blocks_with_a_drum_between_slide_each_by_itself_or_are_refused() {
    let scene = |mu_s: f64, mu_k: f64| {
        format!(
            "surfaces: {{table: level}}
bodies:
  left: {{mass: m, moves: along table}}
  right: {{mass: 2 kg, moves: along table}}
  drum: {{mass: m, shape: {{disc: 0.2 m}}, moves: vertically, positive: down}}
ties:
  - slides: {{body: left, mu_s: {mu_s}, mu_k: {mu_k}}}
  - slides: {{body: right, mu_s: {mu_s}, mu_k: {mu_k}}}
  - cord: {{from: {{body: left, tied at: centre, leaves: forward}}, to: {{body: drum, wound on: rim, leaves: back up}}}}
  - cord: {{from: {{body: right, tied at: centre, leaves: back}}, to: {{body: drum, wound on: rim, leaves: front up}}}}
start: {{left: {{speed: 0 m/s}}, right: {{speed: 0 m/s}}}}
end: {{time: {{of: drum, is: 0.5 s}}}}"
        )
    };
    let names = ["drum.v", "left.v", "right.v", "omega"];
    // Each cord bears half of the drum, which with one block alone would still be too much for the other.
    let v = (2.0 - 0.4) * G / 6.0 * 0.5;
    compare(&names, &told_by(&scene(0.45, 0.1), &names, false).0, &[v, v, v, 0.0]);
    let (_, found) = solved(&scene(0.55, 0.1));
    assert_eq!(found.regime.word(), "balanced");
    let held = found.checks.iter().filter(|c| c.kind.name() == "no_slip" && (c.required - G).abs() < 1e-12);
    assert_eq!(held.count(), 2);
    // Here the cord of the other would be held as soon as one block goes.
    let (_, refused) = attempted(&scene(0.46, 0.02));
    assert!(matches!(refused, Err(Refusal::Unsupported(Unsupported::SlidesInTurn))), "{refused:?}");
}

/// A disc spins in place, held by a block on a link; once its spin is gone the block is drawn along and the disc rolls:
/// `(m + m + J/r^2) a = 2 m g sin - mu_k m g cos`.
#[test]
fn what_is_held_while_a_disc_spins_is_drawn_along_later() {
    let scene = |end: &str| {
        format!(
            "surfaces: {{hill: {{slope: 15 deg}}}}
bodies:
  wheel: {{mass: 2 kg, shape: {{disc: 0.2 m}}, radii: {{rim: 0.2 m}}, moves: along hill}}
  block: {{mass: m, moves: along hill}}
ties:
  - slips: {{body: wheel, on its: rim, mu_s: 0.5, mu_k: 0.3}}
  - slides: {{body: block, mu_s: 0.3, mu_k: 0.25}}
  - link: {{from: {{body: wheel, tied at: centre, leaves: back}}, to: {{body: block, tied at: centre, leaves: forward}}}}
start: {{wheel: {{speed: 0 m/s, spin: 20 rad/s}}}}
end: {end}"
        )
    };
    let (sin, cos) = 15.0_f64.to_radians().sin_cos();
    let a = -(4.0 * G * sin - 0.5 * G * cos) / 5.0;
    let names = ["wheel.a_rolling", "wheel.friction_if_rolled", "wheel.mu_required"];
    let rolling = [a, -a, -a / (2.0 * G * cos)];
    compare(&names, &told(&scene("{turn: {of: wheel, by: 3 rad}}"), &names).0, &rolling);
    let (found, _) = told(&scene("{time: {of: wheel, is: 1.5 s}}"), &[names[0], "block.v", "block.a"]);
    let spins = 20.0 * 0.2 / (2.0 * 0.3 * G * cos);
    compare(&["a", "v", "a"], &found, &[a, -a * (1.5 - spins), a]);
}

/// Friction drives a disc on a steep slope on less than its weight does: it never comes to roll, and nothing is told of how it will.
#[test]
fn of_what_never_rolls_no_rolling_is_told() {
    let scene = "surfaces: {hill: {slope: 40 deg}}
bodies: {wheel: {mass: m, shape: {disc: 0.2 m}, radii: {rim: 0.2 m}, moves: along hill, positive: down}}
ties: [slips: {body: wheel, on its: rim, mu_s: 0.4, mu_k: 0.1}]
start: {wheel: {speed: 2 m/s, spin: 0 rad/s}}
end: {time: {of: wheel, is: 1 s}}";
    let (scene, solved) = solved(scene);
    assert_eq!(solved.regime.word(), "never");
    for name in ["a_rolling", "rolls"] {
        let label = labels::named(&scene, name).unwrap();
        assert!(solved.get(label).is_none() && solved.word(label).is_none(), "{name}");
    }
}
