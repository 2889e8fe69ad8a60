//! Contacts whose line another body carries: planks, carts, wedges and bars at the instant at which they set off, and slotted arms, against
//! formulas by hand. Both roads take where the line is from the same poses; the formulas know no poses.
use slipstick::bank::{Bank, labels, load};
use slipstick::finding::Finding;
use slipstick::solve::agree;
use slipstick::solve::outcome::{Lacks, Refusal};

pub const G: f64 = 9.81;

pub fn read(bodies: &str, joints: &str, more: &str) -> Result<Bank, Vec<String>> {
    let text = format!(
        "
bank: t
title: t
problems:
  p:
    title: t
    data: {{}}
    scene:
      bodies:
{bodies}
      joints:
{joints}
{more}{}
    questions: {{q: {{value: 1*1, ask: none, unit: '1'}}}}
",
        if more.contains(" end:") { "" } else { "\n      end: at once" }
    );
    load::scenes_only(&text, "t.yaml").map_err(|found| found.iter().map(Finding::to_string).collect())
}

/// What both methods tell of these quantities, enclosed.
pub fn told<const N: usize>(bodies: &str, joints: &str, more: &str, names: [&str; N]) -> [f64; N] {
    let bank = read(bodies, joints, more).unwrap_or_else(|found| panic!("{found:?}"));
    let scene = &bank.problems[0].cases[0].scene;
    let solved = agree::solve(scene, &[G]).unwrap_or_else(|e| panic!("{e:?}"));
    names.map(|name| {
        let label = labels::named(scene, name).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let entry = solved.get(label).unwrap_or_else(|| panic!("no {name}"));
        assert!(entry.eom.is_some() && entry.energy.is_some(), "{name}");
        entry.value()
    })
}

pub fn near<const N: usize>(found: [f64; N], expected: [f64; N]) {
    for (i, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= 1e-12 * b.abs().max(1.0), "{i}: {a} against {b}");
    }
}

const PLANK: &str = "        plank: {mass: 10 kg, moves: in the plane, placed: [0 m, 0 m]}";

/// `P = (M + m/3) a`: a cylinder that rolls on the plank gains a third of its acceleration, `2 a/3` less being its turn.
#[test]
fn a_cylinder_on_a_plank_that_is_pulled() {
    let bodies = format!(
        "{PLANK}\n        cylinder: {{mass: 6 kg, shape: {{cylinder: 0.2 m}}, moves: in the plane, placed: [0 m, 0.2 m]}}"
    );
    let joints = "        floor: {guides: plank, along: horizontal, pushes: up}
        top: {rolls: cylinder, radius: 0.2 m, on: plank}";
    let more = "      forces: [force: {on: plank, magnitude: 60 N, direction: right}]";
    let names = ["plank.a_x", "cylinder.a_x", "cylinder.alpha", "top.friction", "top.normal", "floor.normal"];
    let found = told(&bodies, joints, more, names);
    let a = 60.0 / (10.0 + 6.0 / 3.0);
    near(found, [a, a / 3.0, a / 1.5 / 0.2, 6.0 * a / 3.0, 6.0 * G, 16.0 * G]);
    // What is round needs no angle; told all the same, it changes nothing.
    let told_too =
        told(&bodies, joints, &format!("{more}\n      start: {{cylinder: {{angle: 0 deg}}}}"), names);
    near(told_too, found);
}

/// Kinetic friction is all that drives the cart.
#[test]
fn a_block_that_slides_on_a_cart() {
    let bodies = format!("{PLANK}\n        block: {{mass: 5 kg, moves: in the plane, placed: [0.3 m, 0 m]}}");
    let joints = "        floor: {guides: plank, along: horizontal, pushes: up}
        top: {slides: block, on: plank, mu_k: 0.3}";
    let force = |of: &str| format!("      forces: [force: {{on: block, magnitude: {of}, direction: right}}]");
    let found =
        told(&bodies, joints, &force("40 N"), ["plank.a_x", "block.a_x", "top.friction", "floor.normal"]);
    let friction = 0.3 * 5.0 * G;
    near(found, [friction / 10.0, (40.0 - friction) / 5.0, -friction, 15.0 * G]);
    // With less than mu (M + m) m g/M both go on together: which friction that takes, kinetic friction does not tell.
    let bank = read(&bodies, joints, &force("20 N")).unwrap();
    let solved = agree::solve(&bank.problems[0].cases[0].scene, &[G]);
    assert!(matches!(solved, Err(Refusal::Friction(1, Lacks::Sliding))), "{solved:?}");
}

/// `A = m g sin cos/(M + m sin^2)`, to the right, of a wedge that rises to the right and has a block sliding down on it.
#[test]
fn a_block_on_a_wedge_that_is_free() {
    let bodies = format!(
        "{PLANK}\n        block: {{mass: 2 kg, moves: in the plane, placed: [0.5196152422706632 m, 0.3 m]}}"
    );
    let joints = "        floor: {guides: plank, along: horizontal, pushes: up}
        slope: {slides: block, on: plank, along: 30 deg}";
    let found = told(&bodies, joints, "", ["plank.a_x", "block.a_x", "block.a_y", "slope.normal"]);
    let (s, c) = 30_f64.to_radians().sin_cos();
    let wedge = 2.0 * G * s * c / (10.0 + 2.0 * s * s);
    // Its acceleration down the wedge, seen from that.
    let down = G * s + wedge * c;
    near(found, [wedge, wedge - down * c, -down * s, 10.0 * wedge / s]);
}

/// `pushes:` is told in space: whichever way the axis of a cart points that carries the line, a block lies on it, and would have to hang
/// from it where it pushes down. A word for a direction in space is none for a line that goes with a body.
#[test]
fn a_line_on_a_cart_pushes_where_it_is_said_to() {
    let on = |from: &str, line: &str| {
        let bodies = format!(
            "        cart: {{mass: 5 kg, moves: in the plane, angle: {from}, placed: [0 m, 0 m]}}
        block: {{mass: 3 kg, moves: in the plane, placed: [0 m, 0 m]}}"
        );
        let joints = format!(
            "        floor: {{guides: cart, along: horizontal, pushes: up}}
        x: {{guides: block, on: cart, {line}}}"
        );
        (bodies, joints)
    };
    for (from, along) in
        [("from right", 0), ("from left clockwise", 0), ("from up clockwise", -90), ("from hanging", 90)]
    {
        for (pushes, normal) in [("up", 3.0 * G), ("down", -3.0 * G)] {
            let (bodies, joints) = on(from, &format!("along: {along} deg, pushes: {pushes}"));
            near(told(&bodies, &joints, "", ["x.normal", "block.a_x", "block.a_y"]), [normal, 0.0, 0.0]);
        }
        let (bodies, joints) = on(from, "along: horizontal");
        let refused = read(&bodies, &joints, "").expect_err("a word for a direction in space");
        assert!(refused[0].contains("a line that a body carries goes with it"), "{refused:?}");
    }
}

/// A bead without friction and a cylinder that rolls, each on a bar about a pin: by Lagrange, `(I + m s^2) theta'' = -(M L/2 + m s) g cos`
/// in both; the bead gains `-g sin` along the bar, the cylinder two thirds of that.
#[test]
fn a_bead_and_a_cylinder_on_a_bar_that_turns() {
    let (mass, long, own, s, radius, angle) = (3.0, 1.5, 0.8, 0.6, 0.1, 25_f64);
    let (sine, cosine) = angle.to_radians().sin_cos();
    let place = |s: f64, h: f64| format!("[{:?} m, {:?} m]", s * cosine - h * sine, s * sine + h * cosine);
    let bar = format!(
        "        bar: {{mass: {mass:?} kg, shape: {{rod: {long:?} m}}, moves: in the plane, angle: from right}}"
    );
    let alpha = -(mass * long / 2.0 + own * s) * G * cosine / (mass * long * long / 3.0 + own * s * s);
    let normal = own * (G * cosine + s * alpha);
    let start = "      start: {bar: {angle: 25 deg}}";

    let bead =
        format!("{bar}\n        bead: {{mass: {own:?} kg, moves: in the plane, placed: {}}}", place(s, 0.0));
    let joints = "        O: {pins: bar.A}\n        slot: {guides: bead, on: bar.A}";
    let names = ["bar.alpha", "bead.a_x", "bead.a_y", "slot.normal"];
    let [along, across] = [-G * sine, s * alpha];
    let expected = [alpha, along * cosine - across * sine, along * sine + across * cosine, normal];
    near(told(&bead, joints, start, names), expected);

    let wheel = format!(
        "{bar}\n        wheel: {{mass: {own:?} kg, shape: {{cylinder: {radius:?} m}}, moves: in the plane, placed: {}}}",
        place(s, radius)
    );
    let joints = "        O: {pins: bar.A}\n        top: {rolls: wheel, radius: 0.1 m, on: bar.A}";
    let start = "      start: {bar: {angle: 25 deg}, wheel: {angle: 0 deg}}";
    let names = ["bar.alpha", "wheel.alpha", "top.normal", "top.friction"];
    let expected = [alpha, 2.0 / 3.0 * G * sine / radius, normal, own * G * sine / 3.0];
    near(told(&wheel, joints, start, names), expected);
}

/// A crank whose pin slides in the slot of an arm that is pinned below it: the arm's angle is that of the line from its pin to the crank's.
#[test]
fn a_crank_in_a_slotted_arm() {
    let (r, d, long, spin) = (0.2, 0.5, 0.9, 6.0);
    let bodies = |plane: &str| {
        format!(
            "        crank: {{mass: 2 kg, shape: {{rod: {r:?} m}}, moves: {plane}, angle: from right}}
        arm: {{mass: 3 kg, shape: {{rod: {long:?} m}}, moves: {plane}, angle: from right}}"
        )
    };
    let joints = "        O: {pins: crank.A}\n        C: {pins: arm.A, at: [0 m, -0.5 m]}\n        slot: {guides: crank.B, on: arm.A}";
    let of = |degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        let square = r * r + d * d + 2.0 * r * d * s;
        (s, c, square, r * (r + d * s) / square)
    };
    let (_, c, square, ratio) = of(35.0);
    let alpha = spin * spin * r * d * c * (d * d - r * r) / square / square;
    let inertia = 3.0 * long * long / 3.0;
    let start = "      start: {crank: {angle: 35 deg, spin: 6 rad/s, alpha: 0 rad/s^2}}";
    let names = ["arm.omega", "arm.alpha", "slot.normal", "drive"];
    let found = told(&bodies("in a horizontal plane"), joints, start, names);
    near(found, [spin * ratio, alpha, -inertia * alpha / square.sqrt(), inertia * alpha * ratio]);

    // It falls: the work of the weights, and the arm's share of the energy by the ratio of the spins.
    let text = |end: &str| format!("      start: {{crank: {{angle: 60 deg}}}}\n      end: {end}");
    let end = text("{angle: {of: crank, reaches: -20 deg}}");
    let found = told(&bodies("in the plane"), joints, &end, ["crank.omega", "arm.omega"]);
    let height = |degrees: f64| {
        let (s, _, square, _) = of(degrees);
        2.0 * r / 2.0 * s + 3.0 * long / 2.0 * (r * s + d) / square.sqrt()
    };
    let (.., ratio) = of(-20.0);
    let work = G * (height(60.0) - height(-20.0));
    let omega = (2.0 * work / (2.0 * r * r / 3.0 + inertia * ratio * ratio)).sqrt();
    near(found, [omega, (omega * ratio).abs()]);

    // Every draw of it was refused: in enclosures the place of the pin beside the slot was a zero that may be none.
    let bank = read(&bodies("in the plane"), joints, &end).unwrap_or_else(|found| panic!("{found:?}"));
    let scene = &bank.problems[0].cases[0].scene;
    let mut solved = agree::solve(scene, &[G]).unwrap_or_else(|e| panic!("{e:?}"));
    assert!(agree::prove(scene, &[G], &mut solved));
    let label = labels::named(scene, "arm.omega").unwrap_or_else(|e| panic!("{e:?}"));
    assert!(solved.get(label).is_some_and(|e| e.bound.is_some_and(|b| b < 1e-9)), "enclosed");
}

/// A rod that hangs on a block, or a cart, that is told to be somewhere: nothing else need say where the rod is. By Lagrange, with
/// `M + m` to move along and `I + m d^2` to turn.
#[test]
fn what_hangs_on_what_is_placed() {
    let (block, rod, d) = (2.0, 1.0, 0.25);
    let (s, c) = 40_f64.to_radians().sin_cos();
    let own = rod * d * d * 4.0 / 3.0;
    let alpha = -rod * G * d * s / (own - (rod * d * c).powi(2) / (block + rod));
    let expected = [alpha, -rod * d * c * alpha / (block + rod)];
    let here = ", placed: [0.4 m, 0.1 m]";
    for (rod, block) in [("", here), (here, here), ("", "")] {
        let on_floor = format!(
            "        block: {{mass: 2 kg, moves: in the plane{block}}}
        rod: {{mass: 1 kg, shape: {{rod: 0.5 m}}, moves: in the plane, angle: from hanging{rod}}}"
        );
        let joints = "        floor: {guides: block, along: horizontal, through: [0 m, 0.1 m], pushes: up}
        h: {hinges: [rod.A, block]}";
        let start = "      start: {rod: {angle: 40 deg}}";
        near(told(&on_floor, joints, start, ["rod.alpha", "block.a_x"]), expected);
        if !block.is_empty() {
            let on_cart = format!(
                "        cart: {{mass: 5 kg, moves: in the plane, placed: [0 m, 0.1 m]}}\n{on_floor}"
            );
            let joints = "        floor: {guides: cart, along: horizontal, through: [0 m, 0.1 m], pushes: up}
        top: {slides: block, on: cart}
        h: {hinges: [rod.A, block]}";
            near(told(&on_cart, joints, start, ["rod.alpha", "block.a_x"]), expected);
        }
    }
}

/// What both methods tell of a motion, and enclose, as a bank publishes it.
fn proved<const N: usize>(bodies: &str, joints: &str, more: &str, names: [&str; N]) -> [f64; N] {
    let bank = read(bodies, joints, more).unwrap_or_else(|found| panic!("{found:?}"));
    let scene = &bank.problems[0].cases[0].scene;
    let mut solved = agree::solve(scene, &[G]).unwrap_or_else(|e| panic!("{e:?}"));
    assert!(agree::prove(scene, &[G], &mut solved));
    for name in names {
        let label = labels::named(scene, name).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let bound = solved.get(label).and_then(|entry| entry.bound);
        assert!(bound.is_some_and(|b| b < 1e-9), "{name} is not enclosed: {bound:?}");
    }
    told(bodies, joints, more, names)
}

/// A yoke without a turn in its bed goes with the crank: `x = r cos phi`. By Lagrange with `I + m r^2 sin^2` for the inertia.
#[test]
fn a_scotch_yoke() {
    let (r, moment, spin) = (0.3, 2.0, 5.0);
    let bodies = "        crank: {mass: 2 kg, shape: {rod: 0.3 m}, moves: in the plane, angle: from right}
        yoke: {mass: 3 kg, moves: in the plane}";
    let joints = "        O: {pins: crank.A}
        slot: {guides: crank.B, on: yoke, along: 90 deg}
        bed: {guides: yoke, along: horizontal}";
    let more = |end: &str| {
        format!(
            "      forces: [couple: {{on: crank, moment: 2 N*m, sense: forward}}]
      start: {{crank: {{angle: 30 deg, spin: 5 rad/s}}}}
      end: {end}"
        )
    };
    let inertia = |s: f64| 2.0 * r * r / 3.0 + 3.0 * (r * s) * (r * s);
    let alpha = |s: f64, c: f64, omega: f64| {
        (moment - 2.0 * G * r / 2.0 * c - 3.0 * r * r * s * c * omega * omega) / inertia(s)
    };
    let [(s0, c0), (s, c)] = [30_f64, 100.0].map(|degrees| degrees.to_radians().sin_cos());
    let turn = 70_f64.to_radians();
    let work = moment * turn - 2.0 * G * r / 2.0 * (s - s0);
    let omega = ((inertia(s0) * spin * spin + 2.0 * work) / inertia(s)).sqrt();
    let names = ["crank.omega", "yoke.v_x", "yoke.a_x", "slot.normal", "bed.normal"];
    let ax = -r * s * alpha(s, c, omega) - r * c * omega * omega;
    let found =
        proved(bodies, joints, &more("{angle: {of: crank, reaches: 100 deg}}"), ["crank.omega", "yoke.v_x"]);
    near(found, [omega, -r * s * omega]);
    // The slot presses the crank to the left of its direction, which is up.
    let end = more("{angle: {of: crank, reaches: 100 deg}}");
    near(told(bodies, joints, &end, names), [omega, -r * s * omega, ax, 3.0 * ax, 3.0 * G]);
    let ax = -r * s0 * alpha(s0, c0, spin) - r * c0 * spin * spin;
    near(told(bodies, joints, &more("at once"), names), [spin, -r * s0 * spin, ax, 3.0 * ax, 3.0 * G]);
    // To the same angle in the time that it takes.
    let [time] = told(bodies, joints, &end, ["t"]);
    let [again] =
        told(bodies, joints, &more(&format!("{{time: {{of: crank, is: {time:?} s}}}}")), ["crank.omega"]);
    near([again], [omega]);
}

/// A block in the slot of an arm and in a bed: `x = h tan phi` from where the arm is upright.
#[test]
fn an_arm_that_drives_a_block_in_a_bed() {
    let (h, spin, degrees) = (0.4, 3.0, 25_f64);
    let bodies = "        arm: {mass: 2 kg, shape: {rod: 0.8 m}, moves: in a horizontal plane, angle: from up clockwise}
        block: {mass: 3 kg, moves: in a horizontal plane}";
    let joints = "        O: {pins: arm.A}
        slot: {guides: block, on: arm.A}
        bed: {guides: block, along: horizontal, through: [0 m, 0.4 m]}";
    let more = |more: &str| format!("      start: {{arm: {{angle: 25 deg, spin: 3 rad/s{more}}}}}");
    let (s, c) = degrees.to_radians().sin_cos();
    let [v, a] = [h * spin / (c * c), 2.0 * h * spin * spin * s / (c * c * c)];
    // The force of the slot is at right angles to the arm, `h/c` from the pin.
    let drive = 3.0 * a / c * (h / c);
    let names = ["block.v_x", "block.a_x", "drive"];
    near(told(bodies, joints, &more(", alpha: 0 rad/s^2"), names), [v, a, drive]);
    let end = format!(
        "{}\n      end: {{angle: {{of: arm, reaches: -40 deg}}}}",
        more("").replace(": 3 rad", ": -3 rad")
    );
    let kinetic = |degrees: f64, omega: f64| {
        let per = h / degrees.to_radians().cos().powi(2);
        (2.0 * 0.64 / 3.0 + 3.0 * per * per) * omega * omega
    };
    let omega = (kinetic(25.0, 3.0) / kinetic(40.0, 1.0)).sqrt();
    near(
        proved(bodies, joints, &end, ["arm.omega", "block.v"]),
        [omega, omega * h / 40_f64.to_radians().cos().powi(2)],
    );
}

/// Friction beyond the end is not looked at: the block comes back in its slot after the arm's dead point, long after the time that is
/// asked.
#[test]
fn a_rough_slot_up_to_a_time() {
    let bodies = "        crank: {mass: 2 kg, shape: {rod: 0.2 m}, moves: in the plane, angle: from right}
        arm: {mass: 3 kg, shape: {rod: 0.9 m}, moves: in the plane, angle: from right}";
    let joints = "        O: {pins: crank.A}
        C: {pins: arm.A, at: [0 m, -0.5 m]}
        slot: {guides: crank.B, on: arm.A, mu_k: 0.1}";
    let more =
        |end: &str| format!("      start: {{crank: {{angle: 35 deg, spin: 6 rad/s}}}}\n      end: {end}");
    let names = ["t", "crank.omega", "arm.omega"];
    let found = told(bodies, joints, &more("{angle: {of: crank, reaches: 60 deg}}"), names);
    for share in [1.0, 0.01] {
        let end = more(&format!("{{time: {{of: crank, is: {:?} s}}}}", share * found[0]));
        let again = told(bodies, joints, &end, ["crank.omega", "arm.omega"]);
        if share == 1.0 {
            near(again, [found[1], found[2]]);
        }
    }
    // Beyond the dead point it is refused as before.
    for end in ["{time: {of: crank, is: 0.5 s}}", "{angle: {of: crank, reaches: 200 deg}}"] {
        let bank = read(bodies, joints, &more(end)).unwrap_or_else(|found| panic!("{found:?}"));
        let solved = agree::solve(&bank.problems[0].cases[0].scene, &[G]);
        assert!(matches!(solved, Err(Refusal::Friction(2, Lacks::Lasting))), "{solved:?}");
    }
}

/// `alpha = M/(I + m R^2)` of a gear that moves a rack in its bed, and of one more that the rack turns in its turn.
#[test]
fn a_rack_in_a_bed() {
    let bodies = "        gear: {mass: 3 kg, shape: {disc: 0.1 m}, moves: in the plane}
        rack: {mass: 5 kg, moves: in the plane}
        far: {mass: 2 kg, shape: {disc: 0.2 m}, moves: in the plane}";
    let joints = "        O: {pins: gear.A, at: [0 m, 0.1 m]}
        floor: {guides: rack, along: horizontal}
        m: {meshes: gear, radius: 0.1 m, on: rack}
        C: {pins: far.A, at: [1 m, 0.2 m]}
        n: {meshes: far, radius: 0.2 m, on: rack}";
    let more = |end: &str| {
        format!(
            "      forces: [couple: {{on: gear, moment: 3 N*m, sense: forward}}]
      start: {{gear: {{angle: 0 deg}}}}
      end: {end}"
        )
    };
    let mass = 3.0 / 2.0 + 5.0 + 2.0 / 2.0;
    let a = 3.0 / 0.1 / mass;
    let names = ["rack.a_x", "gear.alpha", "far.alpha", "m.rim_force", "n.rim_force"];
    let turn = std::f64::consts::FRAC_PI_2;
    let end = more("{angle: {of: gear, reaches: 90 deg}}");
    near(told(bodies, joints, &end, names), [a, a / 0.1, a / 0.2, -6.0 * a, a]);
    let found = proved(bodies, joints, &end, ["rack.v_x", "far.omega"]);
    let v = (2.0 * 3.0 * turn / mass).sqrt();
    near(found, [v, v / 0.2]);
    let [v] = told(bodies, joints, &more("{time: {of: gear, is: 0.4 s}}"), ["rack.v_x"]);
    near([v], [0.4 * a]);
}

/// A plank gains what the centres of its rollers do twice over: `P = (M + sum of (m/4 + I/(4 R^2))) a`.
#[test]
fn a_plank_on_rollers() {
    let bodies = |count: usize| {
        let roller = |i: usize| {
            format!(
                "\n        r{i}: {{mass: 1 kg, shape: {{disc: 0.2 m}}, moves: in the plane, placed: [{i}.5 m, 0.2 m]}}"
            )
        };
        let rollers: String = (0..count).map(roller).collect();
        format!("        plank: {{mass: 4 kg, moves: in the plane, placed: [0 m, 0.4 m]}}{rollers}")
    };
    let joints = |count: usize| {
        let roller = |i: usize| {
            format!(
                "        f{i}: {{rolls: r{i}, radius: 0.2 m, along: horizontal}}
        t{i}: {{rolls: r{i}, radius: 0.2 m, on: plank, along: 180 deg}}\n"
            )
        };
        (0..count).map(roller).collect::<String>()
    };
    for count in [1, 2] {
        let more = |end: &str| {
            format!(
                "      forces: [force: {{on: plank, magnitude: 11 N, direction: right}}]
      start: {{r0: {{angle: 0 deg}}, plank: {{speed: 0.5 m/s}}}}
      end: {end}"
            )
        };
        let (bodies, joints) = (bodies(count), joints(count));
        let a = 11.0 / (4.0 + 0.375 * count as f64);
        let last = format!("r{}", count - 1);
        let names = ["plank.v_x", "plank.a_x", &format!("{last}.v_x"), &format!("{last}.alpha")];
        for (end, v) in [
            ("at once", 0.5),
            ("{time: {of: r0, is: 0.5 s}}", 0.5 + 0.5 * a),
            ("{speed: {of: r0, reaches: 5 rad/s}}", 2.0),
            ("{angle: {of: r0, reaches: -90 deg}}", (0.25 + 2.0 * a * 0.2 * std::f64::consts::PI).sqrt()),
        ] {
            near(told(&bodies, &joints, &more(end), names), [v, a, v / 2.0, -a / 0.4]);
        }
        let end = more("{angle: {of: r0, reaches: -90 deg}}");
        proved(&bodies, &joints, &end, ["plank.v_x", "r0.omega"]);
    }
}

/// Schaum's Outline of Engineering Mechanics, problem 16.33: 0.544 m/s^2 and 114 N. The lower block lies on a rough floor, too: it is the
/// friction of the upper one alone that sets it off.
#[test]
fn a_block_that_is_drawn_along_on_a_rough_floor() {
    let bank = load::scenes_only(include_str!("../support/schaum-16-33.yaml"), "schaum").unwrap();
    let scene = &bank.problems[0].cases[0].scene;
    let data = [30.0, 45.0, 0.333_333_33, 0.1, 150.0, 9.8];
    let solved = agree::solve(scene, &data).unwrap_or_else(|e| panic!("{e:?}"));
    let value = |name: &str| solved.get(labels::named(scene, name).unwrap()).unwrap().value();
    assert!((value("B.a_x") - 0.544).abs() < 5e-4, "{}", value("B.a_x"));
    assert!((value("limit") - 114.0).abs() < 0.5, "{}", value("limit"));
}

/// Polar coordinates: `r'' = r w^2 - g sin phi` of a bead on a smooth arm that turns freely, `(I + m r^2) alpha = M` of the weights less
/// `2 m r r' w`, and the arm pushes it with `m (r alpha + 2 r' w + g cos phi)`. Its speed along the arm is told beside the spin.
#[test]
fn a_bead_that_slides_on_an_arm_that_turns_freely() {
    let (m, big, length, r) = (2.0, 3.0, 1.0, 0.6);
    for (degrees, spin, along, reversed) in
        [(0.0, 4.0, 1.5, false), (35.0, -3.0, 2.0, false), (200.0, 5.0, -0.7, true), (90.0, 0.0, 1.0, false)]
    {
        let phi = f64::to_radians(degrees);
        let (s, c) = (libm::sin(phi), libm::cos(phi));
        let bodies = format!(
            "        arm: {{mass: 3 kg, shape: {{rod: 1 m}}, moves: in the plane, angle: from right}}
        bead: {{mass: 2 kg, moves: in the plane, placed: [{:.17} m, {:.17} m]}}",
            r * c,
            r * s
        );
        let line = if reversed { ", along: 180 deg" } else { "" };
        let outward = if reversed { -along } else { along };
        let joints = format!("        O: {{pins: arm.A}}\n        wire: {{guides: bead, on: arm.A{line}}}");
        let more = format!(
            "      start: {{arm: {{angle: {degrees} deg, spin: {spin} rad/s}}, bead: {{speed: {along} m/s}}}}"
        );
        let names = ["arm.alpha", "bead.a_x", "bead.a_y", "bead.v_x", "bead.v_y"];
        let found = told(&bodies, &joints, &more, names);
        let weights = -(big * length / 2.0 + m * r) * G * c;
        let alpha = (weights - 2.0 * m * r * outward * spin) / (big * length * length / 3.0 + m * r * r);
        let across = r * alpha + 2.0 * outward * spin;
        // Outward nothing holds it: r'' - r w^2 is what the weight has along the arm.
        let freely = -G * s;
        let by_hand = [
            alpha,
            freely * c - across * s,
            freely * s + across * c,
            outward * c - r * spin * s,
            outward * s + r * spin * c,
        ];
        near(found, by_hand);
    }
}

/// Lagrange's equations of two rods that hang on one another, each with a spin of its own.
#[test]
fn a_double_pendulum_with_two_spins() {
    let (big, m, length, b) = (3.0, 2.0, 1.2, 0.7);
    for (one, other, w, u) in [(30.0, -20.0, 2.5, -1.5), (-70.0, 140.0, -3.0, 4.0), (10.0, 10.0, 0.0, 2.0)] {
        let bodies =
            "        one: {mass: 3 kg, shape: {rod: 1.2 m}, moves: in the plane, angle: from hanging}
        two: {mass: 2 kg, shape: {rod: 0.7 m}, moves: in the plane, angle: from hanging}";
        let joints = "        O: {pins: one.A}\n        H: {hinges: [one.B, two.A]}";
        let more = format!(
            "      start: {{one: {{angle: {one} deg, spin: {w} rad/s}}, two: {{angle: {other} deg, spin: {u} rad/s}}}}"
        );
        let found = told(bodies, joints, &more, ["one.alpha", "two.alpha", "kinetic_energy"]);
        let (t, p) = (f64::to_radians(one), f64::to_radians(other));
        let (c, s) = (libm::cos(t - p), libm::sin(t - p));
        let (own, mixed, last) =
            (big * length * length / 3.0 + m * length * length, m * length * b / 2.0, m * b * b / 3.0);
        let right = [
            -mixed * s * u * u - (big / 2.0 + m) * G * length * libm::sin(t),
            mixed * s * w * w - m * G * b / 2.0 * libm::sin(p),
        ];
        let det = own * last - mixed * mixed * c * c;
        let energy = own * w * w / 2.0 + mixed * c * w * u + last * u * u / 2.0;
        near(
            found,
            [
                (right[0] * last - right[1] * mixed * c) / det,
                (own * right[1] - mixed * c * right[0]) / det,
                energy,
            ],
        );
    }
}

/// A bar hangs on a trolley that rolls already: `(M + m) a + m l (alpha cos - w^2 sin) = 0`, `I alpha + m l (a cos + g sin) = 0`.
#[test]
fn a_bar_on_a_trolley_that_both_move() {
    let bodies = "        trolley: {mass: 4 kg, moves: in the plane, placed: [0 m, 0 m]}
        bar: {mass: 3 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}";
    let joints =
        "        rail: {guides: trolley, along: horizontal}\n        H: {hinges: [trolley.A, bar.A]}";
    let start = |speed: f64, spin: f64| {
        format!(
            "      start: {{trolley: {{speed: {speed} m/s}}, bar: {{angle: 40 deg, spin: {spin} rad/s}}}}"
        )
    };
    let t = f64::to_radians(40.0);
    let (s, c, l) = (libm::sin(t), libm::cos(t), 0.5);
    for (speed, spin) in [(2.0, 3.0), (-1.0, -2.5), (3.0, 0.0)] {
        let found = told(bodies, joints, &start(speed, spin), ["trolley.a_x", "bar.alpha", "bar.v_x"]);
        let (own, mixed, right) = (7.0, 3.0 * l * c, [3.0 * l * spin * spin * s, -3.0 * G * l * s]);
        let det = own - mixed * mixed;
        let a = (right[0] - mixed * right[1]) / det;
        near(found, [a, own * right[1] / det - mixed * right[0] / det, speed + l * spin * c]);
    }
    // What has no speed is told so; else its freedom is open.
    let open = read(bodies, joints, "      start: {bar: {angle: 40 deg, spin: 3 rad/s}}").expect("a bank");
    let refused = agree::solve(&open.problems[0].cases[0].scene, &[G]);
    assert_eq!(refused.unwrap_err(), Refusal::Freedoms(2));
    let going =
        read(bodies, joints, &format!("{}\n      end: {{time: {{of: bar, is: 1 s}}}}", start(2.0, 3.0)));
    let told = going.expect_err("a motion of two freedoms").join(" | ");
    assert!(
        told.contains("where they leave several freedoms, give one for each and write `end: at once`"),
        "{told}"
    );
}

/// Straight lines have no curvature: a cylinder that rolls on a moving plank accelerates as from rest, whatever its speed on it.
#[test]
fn a_cylinder_that_rolls_on_a_moving_plank() {
    let bodies = format!(
        "{PLANK}\n        cylinder: {{mass: 6 kg, shape: {{cylinder: 0.2 m}}, moves: in the plane, placed: [0 m, 0.2 m]}}"
    );
    let joints = "        floor: {guides: plank, along: horizontal, pushes: up}
        top: {rolls: cylinder, radius: 0.2 m, on: plank}";
    let more = "      forces: [force: {on: plank, magnitude: 60 N, direction: right}]
      start: {plank: {speed: 1.5 m/s}, cylinder: {angle: 0 deg, speed: 0.8 m/s}}";
    let names = ["plank.a_x", "cylinder.a_x", "cylinder.alpha", "cylinder.v_x", "cylinder.omega"];
    let a = 60.0 / (10.0 + 6.0 / 3.0);
    near(told(&bodies, joints, more, names), [a, a / 3.0, a / 1.5 / 0.2, 1.5 + 0.8, 0.8 / 0.2]);
}

/// Two speeds of one freedom: they must agree.
#[test]
fn a_speed_that_the_joints_contradict_is_refused() {
    let bodies = "        one: {mass: 3 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}
        two: {mass: 2 kg, shape: {rod: 1 m}, moves: in the plane}";
    let joints = "        O: {pins: one.A}\n        W: {welds: [one.B, two.A], turned: 90 deg}";
    let start = |spin: &str| {
        format!("      start: {{one: {{angle: 30 deg, spin: 2 rad/s}}, two: {{spin: {spin} rad/s}}}}")
    };
    near(told(bodies, joints, &start("2"), ["two.omega"]), [2.0]);
    let bank = read(bodies, joints, &start("3")).expect("a bank");
    match agree::solve(&bank.problems[0].cases[0].scene, &[G]) {
        Err(Refusal::Contradiction { given, follows, .. }) => near([given, follows], [3.0, 2.0]),
        other => panic!("{other:?}"),
    }
}

/// In a bowl of radius 0.9 m rolls a disc, and on its centre hangs a bar: a double pendulum, the first arm of which is as long as the way
/// of the centre is bent, `rho = 0.7 m`, with half of the disc's mass more for its turn.
#[test]
fn a_bar_on_a_disc_that_rolls_in_a_bowl() {
    let bodies = "        disc: {mass: 4 kg, shape: {disc: 0.2 m}, moves: in the plane, angle: from hanging}
        bar: {mass: 3 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}";
    let joints =
        "        bowl: {rolls: disc, radius: 0.2 m, inside: 0.9 m}\n        H: {hinges: [disc.A, bar.A]}";
    for (at, other, spin, w) in [(30.0, -20.0, 4.0, 2.5), (-50.0, 60.0, -3.0, 1.5)] {
        let more = format!(
            "      start: {{disc: {{angle: {at} deg, spin: {spin} rad/s}}, bar: {{angle: {other} deg, spin: {w} rad/s}}}}"
        );
        let found = told(bodies, joints, &more, ["disc.alpha", "bar.alpha", "bar.v_x"]);
        let (rho, l, m, big) = (0.7, 0.5, 3.0, 4.0);
        // It rolls back as its centre goes forth.
        let rate = -spin * 0.2 / rho;
        let (t, p) = (f64::to_radians(at), f64::to_radians(other));
        let (c, s) = (libm::cos(t - p), libm::sin(t - p));
        let (own, mixed, last) = ((1.5 * big + m) * rho * rho, m * rho * l, m / 3.0);
        let right = [
            -mixed * s * w * w - (big + m) * G * rho * libm::sin(t),
            mixed * s * rate * rate - m * G * l * libm::sin(p),
        ];
        let det = own * last - mixed * mixed * c * c;
        let along = (right[0] * last - right[1] * mixed * c) / det;
        near(
            found,
            [
                -along * rho / 0.2,
                (own * right[1] - mixed * c * right[0]) / det,
                rho * rate * libm::cos(t) + l * w * libm::cos(p),
            ],
        );
    }
}

/// A trolley with a bar on it draws a load over a pulley: the cord grows by `v^2 sin^2/l` even where the trolley keeps its speed.
#[test]
fn a_trolley_with_a_bar_on_a_cord_that_turns() {
    let bodies = "        trolley: {mass: 4 kg, moves: in the plane, placed: [0 m, 0 m]}
        bar: {mass: 3 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}
        load: {mass: 2 kg, moves: in the plane, placed: [1.2 m, -0.5 m]}";
    let joints = "        rail: {guides: trolley, along: horizontal}
        H: {hinges: [trolley.A, bar.A]}
        rope: {ties: trolley.A, over: [1.2 m, 0.9 m], to: load}
        shaft: {guides: load, along: vertical, through: [1.2 m, 0 m]}";
    let (speed, spin, t) = (-1.5, 2.0, f64::to_radians(40.0));
    let more = format!(
        "      start: {{trolley: {{speed: {speed} m/s}}, bar: {{angle: 40 deg, spin: {spin} rad/s}}}}"
    );
    let found = told(bodies, joints, &more, ["trolley.a_x", "bar.alpha", "load.a_y", "load.v_y"]);
    let (length, l) = (1.5, 0.5);
    let (cosine, sine) = (1.2 / length, 0.9 / length);
    let (s, c) = (libm::sin(t), libm::cos(t));
    let bend = speed * speed * sine * sine / length;
    // The load rises by what the cord grows: bend - a cos.
    let pull = 2.0 * (G + bend) * cosine;
    let (own, mixed, last) = (7.0 + 2.0 * cosine * cosine, 3.0 * l * c, 1.0);
    let right = [pull + 3.0 * l * spin * spin * s, -3.0 * G * l * s];
    let det = own * last - mixed * mixed;
    let a = (right[0] * last - mixed * right[1]) / det;
    near(found, [a, (own * right[1] - mixed * right[0]) / det, bend - a * cosine, -speed * cosine]);
}
