//! What pictures show: bodies as they are, what holds and strikes them, each number once and with its name.
use crate::figures::{all_text, corners, first_picture};
use slipstick::picture::frame::Frame;
use slipstick::picture::vector::{Direction, Vec2};
use slipstick::picture::{Element, Outline, Picture, Role, TextRun};

/// The picture of a scene with those of these data (symbol, value and unit of each) that it uses.
fn picture_of(data: &str, scene: &str, asked: &str) -> Picture {
    let uses = |symbol: &str| scene.split(|c: char| !c.is_alphanumeric()).any(|word| word == symbol);
    let data = data.split_terminator("; ").filter_map(|datum| {
        let (symbol, value) = datum.split_once(": ").filter(|(symbol, _)| uses(symbol))?;
        let (value, unit) = value.split_once(' ').expect("a value with its unit");
        Some(format!("{symbol}: {{name: {symbol}, unit: '{unit}', draw: always {value}}}"))
    });
    let data: Vec<String> = data.collect();
    first_picture(&format!(
        "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{{}}}\n    scene: {{{scene}}}\n    questions: {{q: {{{asked}, ask: x}}}}\n    statement: '{{{{ g }}}}'\n",
        data.join(", ")
    ))
}

/// Circles of a role: middle and radius.
fn circles(picture: &Picture, of: Role) -> Vec<(Vec2, f64)> {
    let circle = |e: &Element| match e.outline {
        Outline::Circle { centre, radius } if e.role == of => Some((centre, radius)),
        _ => None,
    };
    picture.elements.iter().filter_map(circle).collect()
}

/// The corners of each polygon of a role.
fn polygons(picture: &Picture, of: Role) -> Vec<Vec<Vec2>> {
    let polygon = |e: &Element| match &e.outline {
        Outline::Lines { points, closed: true } if e.role == of => Some(points.clone()),
        _ => None,
    };
    picture.elements.iter().filter_map(polygon).collect()
}

fn frame(corners: &[Vec2]) -> Frame {
    Frame::round(corners.iter().copied()).expect("corners")
}

/// Bodies look like what they are, whatever holds them: a hoop on a nail is a ring, a disc on a smooth bearing a disc, what has its mass as
/// half a cylinder has is half of one, and a mass at a point is a small ball.
#[test]
fn a_body_looks_like_what_it_is() {
    let hoop = picture_of(
        "m: 1 kg; R: 0.4 m; th: 30 deg",
        "bodies: {hoop: {mass: m, shape: {hoop: R}, pinned: {distance: R}, angle: from hanging}}, start: {hoop: {angle: th}}, end: {angle: {of: hoop, reaches: 0 deg}}",
        "quantity: omega, unit: rad/s",
    );
    let (rim, holes) = (circles(&hoop, Role::Body)[0], circles(&hoop, Role::Paper));
    assert!(holes.iter().any(|(at, r)| (at - rim.0).norm() < 1e-9 && *r < rim.1), "{rim:?} {holes:?}");

    let arm = |end: &str| {
        picture_of(
            "m: 4 kg; L: 0.8 m; M: 6 kg; R: 0.2 m",
            &format!(
                "bodies: {{rod: {{mass: m, shape: {{rod: L}}, moves: in the plane, angle: from right}}, end: {{mass: M, {end}moves: in the plane}}}}, joints: {{O: {{pins: rod.A}}, B: {{hinges: [rod.B, end.A]}}}}, start: {{rod: {{angle: 0 deg}}}}, end: at once"
            ),
            "quantity: rod.alpha, unit: rad/s^2",
        )
    };
    let disc = arm("shape: {disc: R}, ");
    let rod = frame(&polygons(&disc, Role::Body)[0]);
    // Half the width of the rod is drawn at either end.
    let long = rod.high.x - rod.low.x - (rod.high.y - rod.low.y);
    let round = circles(&disc, Role::Body);
    assert_eq!(round.len(), 1, "{round:?}");
    assert!((round[0].1 / long - 0.2 / 0.8).abs() < 1e-6, "{round:?} {rod:?}");
    assert_eq!(polygons(&disc, Role::Body).len(), 1);
    let ball = arm("");
    assert!(
        circles(&ball, Role::Body)[0].1 < 12.0 && ball.desc.contains("The particle sits at B of the rod."),
        "{}",
        ball.desc
    );
    assert_eq!(polygons(&ball, Role::Body).len(), 1);

    let rolls = |inertia: &str| {
        picture_of(
            "m: 4 kg; R: 0.3 m; th: 10 deg",
            &format!(
                "bodies: {{half: {{mass: m, {inertia}, moves: in the plane, angle: from hanging, placed: [0 m, R]}}}}, joints: {{floor: {{rolls: half.A, radius: R, along: horizontal}}}}, start: {{half: {{angle: th}}}}, end: equilibrium"
            ),
            "quantity: period_small, unit: s",
        )
    };
    let arc = |picture: &Picture| {
        picture.elements.iter().find_map(|e| match &e.outline {
            Outline::Arcs(arcs) if e.role == Role::Body => Some(arcs.clone()),
            _ => None,
        })
    };
    for half in [
        "moment of inertia: m*R^2*(1/2 - 16/(9*pi^2)), mass centre: 4*R/(3*pi)",
        "moment of inertia: m*R^2*(1 - 4/pi^2), mass centre: 2*R/pi",
        "moment of inertia: 83/320*m*R^2, mass centre: 3*R/8",
        "moment of inertia: 5/12*m*R^2, mass centre: R/2",
    ] {
        let arcs = arc(&rolls(half)).expect("half a disc");
        assert!(
            matches!(arcs[..], [(_, _, from, to)] if ((to - from).abs() - std::f64::consts::PI).abs() < 1e-9),
            "{arcs:?}"
        );
    }
    // A wheel that is not balanced is whole.
    let wheel = rolls("moment of inertia: m*R^2/2, mass centre: R/2");
    assert!(arc(&wheel).is_none() && circles(&wheel, Role::Body).len() == 1);
}

/// What presses, guides or is struck is to be seen: the shoe of a brake reaches the drum, an edge lies under the end that strikes it, a yoke
/// before its disc, and a wedge stands on its floor.
#[test]
fn what_touches_is_seen() {
    let brake = picture_of(
        "m: 10 kg; R: 0.3 m; L: 1 m; b: 0.4 m; c: 0.1 m; P: 100 N; w: 20 rad/s",
        "bodies: {drum: {mass: m, shape: {disc: R}, moves: in the plane}, lever: {mass: 2 kg, shape: {rod: L}, moves: in the plane, points: {A: 0 m, C: [b, -c], B: L}}}, joints: {axle: {pins: drum}, pivot: {pins: lever.A, at: [-b, 0.4 m]}, shoe: {slides: lever.C, outside: R, on: drum, mu_k: 0.3}}, forces: [force: {on: lever.B, magnitude: P, direction: down}], start: {drum: {spin: w}}, end: {turning point: drum}",
        "quantity: drum.phi, unit: rad",
    );
    let (middle, radius) = circles(&brake, Role::Body)[0];
    let near = |corners: &Vec<Vec2>| {
        corners.iter().map(|p| ((p - middle).norm() - radius).abs()).fold(f64::INFINITY, f64::min)
    };
    assert!(polygons(&brake, Role::Body).iter().any(|corners| near(corners) < 1.0));
    // Both bodies have a point A: each letter says whose.
    let letters = all_text(&brake);
    assert!(letters.lines().any(|l| l == "A_D") && letters.lines().any(|l| l == "A_L"), "{letters}");
    assert!(letters.contains("c\u{a0}=\u{a0}0.1"), "{letters}");

    let edge = picture_of(
        "m: 2 kg; L: 0.9 m; v: 3 m/s; w: 4 rad/s",
        "bodies: {rod: {mass: m, shape: {rod: L}, moves: in the plane, angle: from right, placed: [0 m, 0 m]}}, joints: {edge: {guides: rod.B, along: horizontal, pushes: up, restitution: 0.6}}, start: {rod: {angle: 0 deg, arrives: {speed: v, direction: down, spin: -w}}}, end: at once",
        "quantity: omega, unit: rad/s",
    );
    let rod = frame(&polygons(&edge, Role::Body)[0]);
    let under = edge.elements.iter().filter(|e| e.role == Role::Ground).flat_map(|e| corners(&e.outline));
    let under = Frame::round(under).expect("an edge");
    assert!(under.low.x < rod.high.x && under.high.x > rod.high.x && (under.low.y - rod.high.y).abs() < 3.0);
    assert!(edge.desc.contains("turns at −w = −4 rad/s, positive counter-clockwise"), "{}", edge.desc);

    let yoke = picture_of(
        "I: 0.2 kg*m^2; r: 0.15 m; M: 4 kg; C: 6 N*m",
        "bodies: {disc: {mass: 5 kg, moment of inertia: I, moves: in the plane, angle: from right, points: {O: 0 m, P: r}}, yoke: {mass: M, moves: in the plane}}, joints: {O: {pins: disc.O}, slot: {guides: disc.P, on: yoke, along: 90 deg}, bed: {guides: yoke, along: horizontal}}, forces: [couple: {on: disc, moment: C}], start: {disc: {angle: 0 deg}}, end: {angle: {of: disc, reaches: 90 deg}}",
        "quantity: disc.omega, unit: rad/s",
    );
    let at = |is: fn(&Outline) -> bool| {
        yoke.elements.iter().position(|e| e.role == Role::Body && is(&e.outline)).expect("both bodies")
    };
    let disc = at(|outline| matches!(outline, Outline::Circle { radius, .. } if *radius > 40.0));
    assert!(disc < at(|outline| matches!(outline, Outline::Lines { closed: true, .. })));

    let wedge = picture_of(
        "M: 4 kg; m: 2 kg; R: 0.1 m; b: 0.5 m; th: 30 deg",
        "bodies: {wedge: {mass: M, moves: in the plane, placed: [0 m, 0 m]}, cyl: {mass: m, shape: {cylinder: R}, moves: in the plane, placed: [b - R*sin(th), b*tan(th) + R*cos(th)]}}, joints: {floor: {guides: wedge, along: horizontal, pushes: up}, face: {rolls: cyl, radius: R, on: wedge, along: th}}, start: at rest, end: at once",
        "quantity: wedge.a_x, unit: m/s^2",
    );
    let foot = frame(&polygons(&wedge, Role::Body)[0]).high.y;
    let floor = wedge.elements.iter().filter(|e| e.role == Role::Ground).flat_map(|e| corners(&e.outline));
    let floor = Frame::round(floor).expect("a floor");
    assert!((floor.low.y - foot).abs() < 0.1, "{foot} {floor:?}");

    let pucks = picture_of(
        "mA: 0.4 kg; mB: 0.6 kg; v: 5 m/s",
        "bodies: {A: {mass: mA, moves: in a horizontal plane, placed: [0 m, 0 m]}, B: {mass: mB, moves: in a horizontal plane, placed: [0 m, 0 m]}}, joints: {hit: {guides: A, on: B, along: 60 deg, restitution: 0.5}}, start: {A: {arrives: {speed: v, direction: right}}, B: {arrives: {speed: 0 m/s, direction: right}}}, end: at once",
        "quantity: B.v, unit: m/s",
    );
    assert_eq!(polygons(&pucks, Role::Body).iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
    let [a, b] = [0, 1].map(|i| {
        let Frame { low, high } = frame(&polygons(&pucks, Role::Body)[i]);
        low.middle(high)
    });
    assert!(a.x < b.x && pucks.desc.contains("Just before the impact block B is at rest."), "{}", pucks.desc);
}

/// What is carried stands on its truck or hangs from a trolley, and in a horizontal plane there is neither a truck seen from the side nor a
/// vertical direction.
#[test]
fn what_carries_a_scene_is_where_it_is() {
    let rod = |plane: &str, from: &str| {
        picture_of(
            "m: 5 kg; L: 1 m; a: 2 m/s^2",
            &format!(
                "bodies: {{rod: {{mass: m, shape: {{rod: L}}, moves: in {plane}, angle: from {from}}}}}, joints: {{O: {{pins: rod.A}}}}, carried: {{along: horizontal, acceleration: a}}, start: {{rod: {{angle: 10 deg}}}}, end: at once"
            ),
            "quantity: rod.alpha, unit: rad/s^2",
        )
    };
    let wheels = |picture: &Picture| -> Vec<f64> {
        circles(picture, Role::Inner).iter().filter(|(_, r)| *r > 6.0).map(|(at, _)| at.y).collect()
    };
    let above = |picture: &Picture, y: f64| y < frame(&polygons(picture, Role::Body)[0]).low.y;
    let below = |picture: &Picture, y: f64| y > frame(&polygons(picture, Role::Body)[0]).high.y;
    let (hangs, stands) = (rod("the plane", "hanging"), rod("the plane", "up"));
    assert!(wheels(&hangs).len() == 2 && wheels(&hangs).iter().all(|y| above(&hangs, *y)));
    assert!(wheels(&stands).len() == 2 && wheels(&stands).iter().all(|y| below(&stands, *y)));
    let flat = rod("a horizontal plane", "up");
    assert_eq!(wheels(&flat), [0.0; 0]);
    assert!(!flat.desc.contains("vertical") && flat.desc.contains("from the direction up the figure"));
}

/// Each length of a plate stands once, its height too; constants have their unit and their name, and formulas are written as people write
/// them.
#[test]
fn each_number_stands_once_and_is_named() {
    let plate = picture_of(
        "m: 8 kg; a: 0.5 m; b: 0.2 m",
        "bodies: {plate: {mass: m, moment of inertia: m*(a^2 + b^2)/12, moves: in the plane, angle: from right, mass centre: a/2, points: {A: [0 m, b/2], D: [a, b/2], P: [0 m, -b/2], Q: [a, -b/2]}}}, joints: {O: {pins: plate.A}}, start: {plate: {angle: 0 deg}}, end: at once",
        "quantity: alpha, unit: rad/s^2",
    );
    let told = all_text(&plate).replace('\u{a0}', " ");
    for label in ["a = 0.5 m", "b = 0.2 m", "m = 8 kg"] {
        assert_eq!(told.lines().filter(|l| *l == label).count(), 1, "{label}: {told}");
    }
    assert!(plate.desc.starts_with("Plate (m = 8 kg, b = 0.2 m, a = 0.5 m):"), "{}", plate.desc);

    let rod = |forces: &str, spin: &str, end: &str| {
        let picture = picture_of(
            "W: 34 lbf; b: 0.3 m; c: 0.4 m; th: 20 deg",
            &format!(
                "bodies: {{rod: {{weight: W, shape: {{rod: 4 ft}}, moves: in the plane, angle: from right, points: {{A: 0 m, O: b, C: c, B: its end}}}}}}, joints: {{O: {{pins: rod.O}}}}, forces: [{forces}], start: {{rod: {{angle: 0 deg, spin: {spin}}}}}, end: {end}"
            ),
            "quantity: kinetic_energy, unit: J",
        );
        (all_text(&picture).replace('\u{a0}', " "), picture.desc)
    };
    let spring = "spring: {on: rod.B, to: [6 ft, 3 ft], stiffness: 10 lbf/ft, natural length: 1.5 ft}";
    let (told, desc) = rod(spring, "0 rad/s", "at once");
    for label in ["10 lbf/ft", "natural length 1.5 ft", "4 ft"] {
        assert!(told.lines().any(|l| l == label), "{label}: {told}");
    }
    assert!(desc.contains("A spring (10 lbf/ft, natural length 1.5 ft) joins B of the rod"), "{desc}");
    let torsion = "torsion: {on: rod.O, stiffness: 30 N*m/rad, relaxed at: 40 deg}";
    let (told, desc) = rod(torsion, "0 rad/s", "{turn: {of: rod, by: -atan(b/c)}}");
    assert!(told.lines().any(|l| l == "relaxed at 40°") && desc.contains("relaxed at 40°"), "{told}\n{desc}");
    assert!(told.lines().any(|l| l == "−arctan(b/c)"), "{told}");
    let (told, _) = rod("couple: {on: rod, moment: W*b/c*th*b}", "-sqrt(g/b)", "at once");
    let plain = told.replace('\u{2009}', "");
    assert!(plain.lines().any(|l| l == "Wb/c·t_h·b") && plain.lines().any(|l| l == "√(g/b)"), "{plain}");

    let pendulum = picture_of(
        "m: 7.5 kg; k: 0.3 m; b: 250 mm; th: 60 deg",
        "bodies: {pendulum: {mass: m, radius of gyration about the pin: k, pinned: {distance: b}, angle: from hanging}}, start: {pendulum: {angle: -90 deg}}, end: {turn: {of: pendulum, by: th}}",
        "quantity: omega, unit: rad/s",
    );
    assert!(all_text(&pendulum).lines().any(|l| l == "−90°+t_h"), "{}", all_text(&pendulum));
}

/// A cord that is pulled aslant from a drum ends beside the load that hangs from the same drum.
#[test]
fn a_pull_does_not_run_through_a_load() {
    let drum = picture_of(
        "W: 300 N; P: 400 N; phi: 45 deg",
        "bodies: {drum: {mass: 30 kg, radius of gyration: 0.4 m, radii: {outer: 0.6 m, inner: 0.3 m}, moves: about a fixed axle}, block: {weight: W, moves: vertically, positive: up}}, ties: [cord: {from: {body: block, tied at: centre, leaves: up}, to: {body: drum, wound on: inner, leaves: front down}}, cord: {from: {body: drum, wound on: outer, leaves: bottom forward, at an angle: -phi}, pulled with: P}], start: at rest, end: at once",
        "quantity: drum.alpha, unit: rad/s^2",
    );
    let load = frame(&polygons(&drum, Role::Body)[0]);
    let arrow = drum.elements.iter().filter(|e| e.role == Role::Force).flat_map(|e| corners(&e.outline));
    let arrow = Frame::round(arrow).expect("a pull");
    assert!(arrow.high.y < load.low.y - 5.0, "{arrow:?} {load:?}");
}

/// What stood in words alone: speeds that are told along guides, where a blow acts, which of two blocks is which and along which line they
/// meet; and a hole, whose mass counts negative.
#[test]
fn what_is_told_of_an_instant_is_drawn() {
    let texts = |picture: &Picture| -> Vec<String> {
        let text = |runs: &[TextRun]| runs.iter().map(|run| run.text.as_str()).collect();
        picture.labels.iter().map(|label| text(&label.runs)).collect()
    };
    let says = |picture: &Picture, text: &str| {
        let all = texts(picture);
        assert!(all.iter().any(|told| told.replace('\u{a0}', " ") == text), "{text}: {all:?}");
    };
    let wedge = picture_of(
        "m: 2 kg",
        "bodies: {wedge: {mass: 5 kg, moves: in the plane, placed: [0 m, 0 m]}, block: {mass: m, moves: in the plane, placed: [1 m, 1 m]}}, joints: {floor: {guides: wedge, along: horizontal, pushes: up}, face: {slides: block, on: wedge.A, along: 45 deg, mu_k: 0.3}}, start: {wedge: {speed: 1 m/s}, block: {speed: -2 m/s}}, end: at once",
        "quantity: wedge.a_x, unit: m/s^2",
    );
    says(&wedge, "1 m/s");
    says(&wedge, "2 m/s");
    // From the notch of a head to its tip: one to the right, one down the face (y points down).
    let ways: Vec<Vec2> = polygons(&wedge, Role::MotionHead).iter().map(|p| p[0] - p[2]).collect();
    assert!(ways.len() == 2 && ways[0].y.abs() < 1e-6 && ways[0].x > 0.0, "{ways:?}");
    assert!((ways[1].x + ways[1].y).abs() < 1e-6 && ways[1].y > 0.0, "{ways:?}");
    assert!(wedge.desc.contains("−2 m/s, positive at 45°"), "{}", wedge.desc);

    let blow = picture_of(
        "J: 2 N*s",
        "bodies: {rod: {mass: 2 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging, points: {A: 0 m, B: 1 m, P: 0.6 m}}}, joints: {O: {pins: rod.A}}, forces: [impulse: {on: rod.P, magnitude: J, direction: right}], start: {rod: {angle: 0 deg}}, end: at once",
        "quantity: rod.omega, unit: rad/s",
    );
    says(&blow, "0.6 m");

    let blocks = picture_of(
        "m: 2 kg",
        "bodies: {A: {mass: m, moves: in a horizontal plane, placed: [0 m, 0 m]}, B: {mass: 3 kg, moves: in a horizontal plane, placed: [0 m, 0 m]}}, joints: {hit: {guides: A, on: B, along: 120 deg, restitution: 0.5}}, start: {A: {arrives: {speed: 2 m/s, direction: right}}, B: {arrives: {speed: 3 m/s, direction: left}}}, end: at once",
        "quantity: A.v, unit: m/s",
    );
    says(&blocks, "120°");
    says(&blocks, "A: m = 2 kg");
    says(&blocks, "B: 3 kg");

    let hole = picture_of(
        "m: 0.4 kg",
        "bodies: {disc: {mass: 4 kg, shape: {disc: 0.3 m}, moves: in the plane, angle: from hanging, points: {A: -0.3 m, H: 0.1 m}}, hole: {mass removed: m, shape: {disc: 0.08 m}, moves: in the plane}}, joints: {O: {pins: disc.A}, cut: {welds: [disc.H, hole.A]}}, start: {disc: {angle: 10 deg}}, end: equilibrium",
        "quantity: I_O, unit: kg*m^2",
    );
    assert!(texts(&hole).iter().any(|told| told.starts_with('−') && told.contains("0.4")), "{hole:?}");
    assert!(
        hole.desc.contains("A of disc 2 lies at H of disc 1.") && !hole.desc.contains("welded"),
        "{}",
        hole.desc
    );
}
