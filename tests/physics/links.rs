//! Light rods and pulls at an angle: the books' values, closed forms, a limit, and what is refused.
use crate::joined::value;
use crate::support;
use slipstick::bank::load;
use slipstick::problem::maker::Maker;
use slipstick::scene::Scene;
use slipstick::solve::agree;
use slipstick::solve::outcome::{CheckKind, Refusal, Solved};

const G: f64 = 9.81;

fn bank(data: &str, scene: &str) -> String {
    let data: String = data.split("; ").filter(|d| !d.is_empty()).fold(String::new(), |all, datum| {
        let (symbol, rest) = datum.split_once(": ").expect("symbol: unit draw");
        let (unit, draw) = rest.split_once(' ').expect("unit draw");
        format!("{all}      {symbol}: {{name: {symbol}, unit: '{unit}', draw: {draw}}}\n")
    });
    let data = if data.is_empty() { "    data: {}\n".to_owned() } else { format!("    data:\n{data}") };
    let scene: String = scene.trim().lines().map(|line| format!("      {line}\n")).collect();
    format!(
        "bank: b\ntitle: t\nproblems:\n  p:\n    title: t\n{data}    scene:\n{scene}    questions: {{kinetic_energy: {{ask: T}}}}\n"
    )
}

/// A scene of constants, solved.
fn solved(scene: &str) -> (Scene, Solved) {
    let text = bank("", scene);
    let bank = load::scenes_only(&text, "b.yaml").unwrap_or_else(|found| panic!("{found}\n{text}"));
    let scene = bank.problems[0].cases[0].scene.clone();
    let data = support::data(&bank.problems[0]);
    let solved = agree::solve(&scene, &data).unwrap_or_else(|why| panic!("{why:?}\n{text}"));
    (scene, solved)
}

/// Draws of a problem, each solved, with its data by symbol.
fn each(data: &str, scene: &str, look: impl Fn(&dyn Fn(&str) -> f64, &dyn Fn(&str) -> f64)) {
    let text = bank(data, scene);
    let bank = load::scenes_only(&text, "b.yaml").unwrap_or_else(|found| panic!("{found}\n{text}"));
    let problem = &bank.problems[0];
    let maker = Maker::new(problem, 7, "links");
    for student in 0..support::seeds(60) {
        let variant = maker.variant(&format!("{student}")).unwrap_or_else(|why| panic!("{why:?}\n{text}"));
        let scene = &problem.cases[variant.case].scene;
        let of = |symbol: &str| {
            let at = problem.data.iter().position(|d| d.symbol == symbol).expect("a datum");
            variant.values[at].expect("it is drawn").f64()
        };
        look(&of, &|name| value(scene, &variant.solved, name));
    }
}

fn near(got: f64, want: f64, by: f64) {
    assert!((got - want).abs() <= by * want.abs().max(1e-9), "{got} against {want}");
}

fn of<'s>((scene, found): &'s (Scene, Solved)) -> impl Fn(&str) -> f64 + 's {
    move |name| value(scene, found, name)
}

fn sine(degrees: f64) -> f64 {
    degrees.to_radians().sin()
}
fn cosine(degrees: f64) -> f64 {
    degrees.to_radians().cos()
}

const PLATE: &str = "
bodies:
  plate: {mass: 8 kg, radius of gyration: 0.155456 m, moves: in the plane, angle: from right, mass centre: 0.25 m, placed: [0 m, 0 m], points: {A: [0 m, 0.1 m], D: [0 m, -0.1 m]}}
joints:
  AE: {links: plate.A, to: [-0.129903811 m, 0.175 m]}
  DF: {links: plate.D, to: [-0.129903811 m, -0.025 m]}
start: {plate: {angle: 0 deg}}
end: at once
";

/// Beer & Johnston, sample problem 16.2: a plate on two parallel links at 30 degrees, its wire cut. One link pulls, the other pushes.
#[test]
fn a_link_pushes_where_a_cord_would_be_slack() {
    let found = solved(PLATE);
    let of = of(&found);
    near(of("AE.tension"), 47.9, 1e-3);
    near(of("DF.tension"), -8.70, 1e-3);
    near(of("a_x").hypot(of("a_y")), G * cosine(30.0), 1e-8);
    assert!(found.1.all_hold());
    let (_, cords) = solved(&PLATE.replace("links", "ties"));
    let taut: Vec<bool> = cords.checks.iter().filter(|c| c.kind == CheckKind::Taut).map(|c| c.ok).collect();
    assert_eq!(taut, [true, false]);
}

/// Hibbeler, example 17.8: both rods carry half of `m (g cos + v^2 / r)`, in a cord as well.
#[test]
fn a_beam_on_parallel_links_moves_on_a_circle() {
    let scene = "
bodies: {beam: {mass: 100 kg, shape: {rod: 0.8 m}, moves: in the plane, angle: from right, placed: [0 m, 0 m]}}
joints:
  B: {links: beam.A, to: [-r*sin(th), r*cos(th)]}
  D: {ties: beam.B, to: [0.8 m - r*sin(th), r*cos(th)]}
start: {beam: {angle: 0 deg, speed: v}}
end: at once
";
    let scene = scene.replace("0.8 m - r", "L - r").replace("rod: 0.8 m", "rod: L");
    each(
        "L: m always 0.8; r: m 0.3 to 0.9 step 0.01; th: deg 5 to 40 step 1; v: m/s 1 to 4 step 0.1",
        &scene,
        |data, of| {
            let (r, th, v) = (data("r"), data("th"), data("v"));
            let half = 50.0 * (G * cosine(th) + v * v / r);
            near(of("B.tension"), half, 1e-12);
            near(of("D.tension"), half, 1e-12);
            let (along, toward) = (-G * sine(th), v * v / r);
            near(of("a_x"), along * cosine(th) - toward * sine(th), 1e-11);
            near(of("a_y"), along * sine(th) + toward * cosine(th), 1e-11);
            near(of("alpha"), 0.0, 1e-9);
        },
    );
}

/// The same motion as with a body for each link that has hardly any mass: speed, forces and turn, under way.
#[test]
fn a_light_rod_is_the_limit_of_a_body() {
    let (a, b) = ([-0.3, 0.9], [1.1, 0.8]);
    let beam = "beam: {mass: 6 kg, shape: {rod: 1 m}, moves: in the plane";
    let end = "start: {beam: {angle: 0 deg, spin: 0.4 rad/s}}\nend: {angle: {of: beam, reaches: 8 deg}}";
    let light = solved(&format!(
        "bodies: {{{beam}, angle: from right, placed: [0 m, 0 m]}}}}\njoints:\n  P: {{links: beam.A, to: [{} m, {} m]}}\n  Q: {{links: beam.B, to: [{} m, {} m]}}\n{end}",
        a[0], a[1], b[0], b[1]
    ));
    let rod = |name: &str, [x, y]: [f64; 2], from: f64, angle: &str| {
        let (x, y): (f64, f64) = (from - x, -y);
        let length = x.hypot(y);
        (
            format!("  {name}: {{mass: 1e-11 kg, shape: {{rod: {length} m}}, moves: in the plane{angle}}}"),
            y.atan2(x).to_degrees(),
        )
    };
    let (one, first) = rod("one", a, 0.0, ", angle: from right");
    let (two, _) = rod("two", b, 1.0, "");
    let heavy = |to: f64| {
        let joints = format!(
            "  P: {{pins: one.A, at: [{} m, {} m]}}\n  R: {{hinges: [one.B, beam.A]}}\n  S: {{hinges: [two.B, beam.B]}}\n  Q: {{pins: two.A, at: [{} m, {} m]}}",
            a[0], a[1], b[0], b[1]
        );
        let scene = format!(
            "bodies:\n{one}\n  {beam}SIDE}}\n{two}\njoints:\n{joints}\nstart: {{one: {{angle: {first} deg, spin: SPIN rad/s}}}}\nend: {{angle: {{of: one, reaches: {to} deg}}}}"
        );
        scene
    };
    // Where the first link stands when the beam has turned by 8 degrees, and how fast it turns at the start: from the beam's motion.
    let (l1, l2) = (a[0].hypot(a[1]), (1.0 - b[0]).hypot(b[1]));
    let place = |phi: f64, beam: f64| {
        let end = [a[0] + l1 * phi.cos() + beam.cos(), a[1] + l1 * phi.sin() + beam.sin()];
        (end[0] - b[0]).hypot(end[1] - b[1]) - l2
    };
    let stands = |beam: f64| {
        let (mut low, mut high) = (first.to_radians() - 0.7, first.to_radians() + 0.7);
        let rising = place(high, beam) > place(low, beam);
        for _ in 0..200 {
            let middle = f64::midpoint(low, high);
            if (place(middle, beam) > 0.0) == rising { high = middle } else { low = middle }
        }
        low
    };
    let rate = (stands(1e-6) - stands(-1e-6)) / 2e-6;
    let text = heavy(stands(8f64.to_radians()).to_degrees());
    let text = text.replace("SPIN", &format!("{}", 0.4 * rate));
    let both = ["", ", side: behind"].map(|side| solved(&text.replace("SIDE", side)));
    let fits = |found: &&(Scene, Solved)| (of(found)("beam.omega") - of(&light)("omega")).abs() < 1e-5;
    let heavy = both.iter().find(fits).expect("one of the two places is that of the beam");
    let (light, heavy) = (of(&light), of(heavy));
    for (one, other) in [("omega", "beam.omega"), ("v", "beam.v"), ("v_x", "beam.v_x"), ("rise", "beam.rise")]
    {
        near(light(one), heavy(other), 1e-6);
    }
    near(light("P.tension").abs(), heavy("P.pin_force"), 1e-6);
    near(light("Q.tension").abs(), heavy("Q.pin_force"), 1e-6);
}

/// A hoop before a disc: the disc behind would be faster, so the rod between them pushes; the other way round it pulls.
#[test]
fn a_rod_between_a_disc_and_a_hoop_pushes() {
    for (front, back, hoop_first) in [("hoop", "disc", true), ("disc", "hoop", false)] {
        let scene = format!(
            "
surfaces: {{incline: {{slope: th}}}}
bodies:
  hoop: {{mass: m1, shape: {{hoop: r}}, moves: along incline, positive: down}}
  disc: {{mass: m2, shape: {{disc: r}}, moves: along incline}}
ties:
  - rolls: {{body: hoop, on its: rim}}
  - rolls: {{body: disc, on its: rim}}
  - link: {{from: {{body: {front}, tied at: centre, leaves: up}}, to: {{body: {back}, tied at: centre, leaves: down}}}}
start: at rest
end: {{travel: {{of: hoop, by: d}}}}
"
        );
        let data = "m1: kg 5 to 20 step 1; m2: kg 5 to 20 step 1; r: m always 0.2; th: deg 15 to 35 step 1; d: m 1 to 2 step 0.1";
        each(data, &scene, |data, of| {
            let (m1, m2, th) = (data("m1"), data("m2"), data("th"));
            let a = G * sine(th) * (m1 + m2) / (2.0 * m1 + 1.5 * m2);
            near(of("hoop.a"), a, 1e-12);
            near(of("disc.a"), -a, 1e-12);
            near(of("disc.v"), (2.0 * a * data("d")).sqrt(), 1e-12);
            // On the hoop, down the slope: m1 g sin +- T = 2 m1 a.
            let pull = m1 * (2.0 * a - G * sine(th)) * if hoop_first { -1.0 } else { 1.0 };
            near(of("tension"), pull, 1e-10);
            assert_eq!(of("tension") < 0.0, hoop_first);
        });
    }
}

/// A roller's handle, a block, a spool whose cord leaves it below: at the angle at which the line of the cord meets the contact it stays.
#[test]
fn a_pull_at_an_angle_lifts_and_turns() {
    let roller = "
surfaces: {floor: level}
bodies: {roller: {mass: m, shape: {disc: r}, radii: {rim: r}, moves: along floor}}
ties:
  - rolls: {body: roller, on its: rim, mu_s: 0.6}
  - cord: {from: {body: roller, tied at: centre, leaves: WAY, at an angle: be}, pulled with: P}
start: at rest
end: {travel: {of: roller, by: d}}
";
    let data = "m: kg 60 to 100 step 1; r: m 0.2 to 0.3 step 0.01; P: N 150 to 250 step 10; be: deg -40 to 40 step 5; d: m 2 to 4 step 0.1";
    for (way, sense) in [("forward", 1.0), ("back", -1.0)] {
        each(data, &roller.replace("WAY", way), |data, of| {
            let (m, p, be) = (data("m"), data("P"), data("be"));
            let a = p * cosine(be) / (1.5 * m);
            near(of("a"), sense * a, 1e-12);
            near(of("normal"), m * G - p * sine(be), 1e-12);
            near(of("friction"), -sense * p * cosine(be) / 3.0, 1e-12);
            near(of("mu_required"), p * cosine(be) / 3.0 / (m * G - p * sine(be)), 1e-11);
            near(of("work_pull"), p * cosine(be) * data("d"), 1e-12);
        });
    }
    let block = "
surfaces: {slope: {slope: th}}
bodies: {block: {mass: m, moves: along slope}}
ties:
  - slides: {body: block, mu_k: mu}
  - cord: {from: {body: block, tied at: centre, leaves: up, at an angle: be}, pulled with: P}
start: at rest
end: {travel: {of: block, by: d}}
";
    let data = "m: kg 20 to 40 step 1; P: N 250 to 350 step 10; be: deg 15 to 35 step 5; th: deg 5 to 15 step 1; mu: 1 0.1 to 0.2 step 0.01; d: m 2 to 4 step 0.1";
    each(data, block, |data, of| {
        let (m, p, be, th, mu) = (data("m"), data("P"), data("be"), data("th"), data("mu"));
        let normal = m * G * cosine(th) - p * sine(be);
        near(of("normal"), normal, 1e-11);
        near(of("a"), (p * cosine(be) - m * G * sine(th) - mu * normal) / m, 1e-10);
        near(of("heat"), mu * normal * data("d"), 1e-11);
    });
    let spool = "
surfaces: {floor: level}
bodies: {spool: {mass: m, radius of gyration: k, radii: {rim: R, hub: h}, moves: along floor}}
ties:
  - rolls: {body: spool, on its: rim}
  - cord: {from: {body: spool, wound on: hub, leaves: bottom forward, at an angle: be}, pulled with: P}
start: at rest
end: at once
";
    let data = "m: kg 25 to 40 step 1; k: m 0.18 to 0.22 step 0.01; R: m always 0.3; h: m 0.1 to 0.2 step 0.01; P: N 100 to 150 step 5; be: deg 10 to 80 step 1";
    each(data, spool, |data, of| {
        let (m, k, r, h, p, be) = (data("m"), data("k"), data("R"), data("h"), data("P"), data("be"));
        // Moments about the contact: the line of the cord passes it at R cos(be) - h.
        let alpha = p * (r * cosine(be) - h) / (m * (k * k + r * r));
        near(of("alpha"), alpha, 1e-10);
        near(of("a"), r * alpha, 1e-10);
        near(of("friction"), m * r * alpha - p * cosine(be), 1e-11);
    });
}

/// Pulled up too hard it leaves its surface, and that is told.
#[test]
fn a_pull_that_lifts_a_body_off_is_told() {
    let (_, found) = solved(
        "
surfaces: {floor: level}
bodies: {block: {mass: 5 kg, moves: along floor}}
ties:
  - cord: {from: {body: block, tied at: centre, leaves: forward, at an angle: 60 deg}, pulled with: 60 N}
start: at rest
end: {travel: {of: block, by: 1 m}}
",
    );
    assert!(found.checks.iter().any(|c| c.kind == CheckKind::Pressed && !c.ok), "{:?}", found.checks);
}

/// What is no light rod and no pull at an angle is refused where it stands.
#[test]
fn what_does_not_apply_is_refused_by_name() {
    let scene = |tie: &str| {
        format!(
            "
surfaces: {{floor: level, incline: {{slope: 20 deg}}}}
bodies:
  one: {{mass: 5 kg, moves: along floor}}
  two: {{mass: 5 kg, moves: along floor}}
  far: {{mass: 5 kg, moves: along incline}}
  hung: {{mass: 5 kg, moves: vertically}}
ties:
  - {tie}
start: at rest
end: at once
"
        )
    };
    let end = |body: &str, leaves: &str| format!("{{body: {body}, tied at: centre, leaves: {leaves}}}");
    let link = |one: &str, other: &str| format!("link: {{from: {one}, to: {other}}}");
    let straight = "a light rod is straight: its ends leave toward each other";
    let constant = "only a constant pull leads away from the surface";
    let tilted = |body: &str, leaves: &str, far: &str| {
        format!(
            "cord: {{from: {{body: {body}, tied at: centre, leaves: {leaves}, at an angle: 20 deg}}, {far}}}"
        )
    };
    for (tie, message) in [
        (link(&end("one", "forward"), &end("two", "forward")), straight),
        (link(&end("one", "forward"), &end("far", "back")), straight),
        (link(&end("one", "forward"), &end("one", "back")), straight),
        (tilted("one", "forward", "pulled with: 5 N, growing by: 1 N/s"), constant),
        (tilted("one", "forward", "held: fast"), constant),
        (tilted("hung", "up", "pulled with: 5 N"), "`hung` moves along no surface"),
        (
            tilted("one", "forward", "pulled with: 5 N").replace("20 deg", "95 deg"),
            "between -90 and 90 degrees",
        ),
    ] {
        let text = bank("", &scene(&tie));
        let found = load::scenes_only(&text, "b.yaml").expect_err(&text).to_string();
        assert!(found.contains(message), "{tie}:\n{found}");
    }
}

/// A planet gear of a disc's inertia on an arm, in a ring or about a sun: `M phi = 1/2 I w^2`, the ring's force turns the gear alone.
#[test]
fn a_planet_gear_turns_on_its_arm() {
    for (side, sign) in [("inside", -1.0), ("outside", 1.0)] {
        let arm = if sign < 0.0 { "R - r" } else { "R + r" };
        let scene = format!(
            "
bodies:
  arm: {{mass: m1, shape: {{rod: {arm}}}, moves: in a horizontal plane, angle: from right}}
  gear: {{mass: m2, shape: {{disc: r}}, moves: in a horizontal plane}}
joints:
  O: {{pins: arm.A}}
  A: {{hinges: [arm.B, gear.A]}}
  ring: {{meshes: gear, radius: r, {side}: R}}
forces: [couple: {{on: arm, moment: M}}]
start: {{arm: {{angle: 0 deg}}}}
end: {{angle: {{of: arm, reaches: phi}}}}
"
        );
        let data = "m1: kg 1 to 4 step 0.1; m2: kg 2 to 5 step 0.1; r: m 0.08 to 0.12 step 0.01; R: m 0.3 to 0.4 step 0.01; M: N*m 3 to 6 step 0.1; phi: deg 100 to 350 step 10";
        each(data, &scene, |data, of| {
            let (r, far) = (data("r"), data("R") + sign * data("r"));
            let inertia =
                data("m1") * far * far / 3.0 + data("m2") * (far * far + 0.5 * r * r * (far / r) * (far / r));
            let omega = (2.0 * data("M") * data("phi").to_radians() / inertia).sqrt();
            near(of("arm.omega"), omega, 1e-11);
            near(of("gear.omega"), omega * far / r, 1e-11);
            let alpha = data("M") / inertia;
            near(of("gear.alpha"), alpha * far / r * sign, 1e-10);
            near(of("ring.rim_force").abs(), 0.5 * data("m2") * r * alpha * far / r, 1e-10);
            // Across the arm its end drives the gear and the teeth hold it back, or the other way round on the far side of the ring.
            let (across, along) =
                (data("m2") * far * alpha + 0.5 * data("m2") * far * alpha, data("m2") * far * omega * omega);
            near(of("A.pin_force"), across.hypot(along), 1e-10);
        });
    }
}

/// A disc hinged by its centre at the end of a rod swings as a point mass does, and does not turn; welded it does.
#[test]
fn a_disc_that_is_free_to_turn_keeps_from_it() {
    let scene = "
bodies:
  rod: {mass: m1, shape: {rod: L}, moves: in the plane, angle: from hanging, points: {A: 0 m, C: b}}
  disc: {mass: m2, shape: {disc: r}, moves: in the plane}
joints:
  O: {pins: rod.A}
  C: {hinges: [rod.C, disc.A]}
start: {rod: {angle: 90 deg}}
end: {angle: {of: rod, reaches: 0 deg}}
";
    let data = "m1: kg 1 to 3 step 0.1; L: m always 0.6; m2: kg 3 to 6 step 0.1; r: m always 0.2; b: m 0.6 to 0.9 step 0.01";
    for (scene, own) in [(scene.to_owned(), 0.0), (scene.replace("hinges", "welds"), 0.5)] {
        each(data, &scene, |data, of| {
            let (m1, l, m2, r, b) = (data("m1"), data("L"), data("m2"), data("r"), data("b"));
            let inertia = m1 * l * l / 3.0 + m2 * (b * b + own * r * r);
            let omega = (2.0 * G * (m1 * l / 2.0 + m2 * b) / inertia).sqrt();
            near(of("rod.omega"), omega, 1e-11);
        });
    }
}

/// A body that is said to be placed off its floor is refused by the name of the joint; a spring may start compressed.
#[test]
fn what_is_placed_off_its_joint_is_refused() {
    let scene = |placed: &str| {
        let text = bank(
            "",
            &format!(
                "
bodies: {{wheel: {{mass: 5 kg, shape: {{disc: 0.3 m}}, mass centre: 0.1 m, moves: in the plane, angle: from right clockwise, placed: {placed}}}}}
joints: {{floor: {{rolls: wheel.A, radius: 0.3 m, along: horizontal}}}}
start: {{wheel: {{angle: 0 deg, spin: 6 rad/s}}}}
end: at once
"
            ),
        );
        let bank = load::scenes_only(&text, "b.yaml").unwrap_or_else(|found| panic!("{found}\n{text}"));
        agree::solve(&bank.problems[0].cases[0].scene, &support::data(&bank.problems[0]))
    };
    assert!(scene("[1 m, 0.3 m]").is_ok());
    let Err(Refusal::Parted { joint: 0, off_m, at_start: true }) = scene("[1 m, 0.9 m]") else {
        panic!("it is placed in the air")
    };
    near(off_m, 0.6, 1e-9);
    let bar = |rest: &str| {
        solved(&format!(
            "
bodies: {{bar: {{mass: 3 kg, shape: {{rod: 1 m}}, moves: in the plane, angle: from right}}}}
joints: {{A: {{pins: bar.A}}}}
forces: [spring: {{on: bar.B, to: [1 m, -0.3 m], stiffness: 900 N/m, {rest}}}]
start: {{bar: {{angle: 0 deg}}}}
end: {{angle: {{of: bar, reaches: 5 deg}}}}
"
        ))
    };
    let (short, long) = (bar("stretch: -0.1 m"), bar("natural length: 0.4 m"));
    near(of(&short)("omega"), of(&long)("omega"), 1e-13);
}

/// A cord from the end of a bar runs over a small pulley and is pulled with a constant force: its work is that over the length of cord that
/// runs off, `P (l0 - l1)`, whatever the way between; at once it has the moment of its direction there. An equilibrium under it is the
/// bottom of `-m g y_G + P l`.
#[test]
fn a_cord_over_a_small_pulley_pulls_toward_it() {
    let bar = "
bodies: {bar: {mass: 6 kg, shape: {rod: 1.2 m}, moves: in the plane, angle: from right}}
joints: {O: {pins: bar.A}}
forces: [force: {on: bar.B, magnitude: 80 N, toward: [0.4 m, 1.5 m]}]
start: {bar: {angle: 0 deg}}
end: END
";
    let (m, length, pull): (f64, f64, f64) = (6.0, 1.2, 80.0);
    let inertia = m * length * length / 3.0;
    let off = |angle: f64| (length * angle.cos() - 0.4).hypot(length * angle.sin() - 1.5);
    let to = 50f64.to_radians();
    let work = pull * (off(0.0) - off(to)) - m * 9.81 * length / 2.0 * to.sin();
    let said = crate::joined::told(&bar.replace("END", "{angle: {of: bar, reaches: 50 deg}}"), &["omega"]);
    near(said[0], (2.0 * work / inertia).sqrt(), 1e-13);
    let said = crate::joined::told(&bar.replace("END", "at once"), &["alpha", "O.pin_x", "O.pin_y"]);
    let alpha = (pull * 1.5 / off(0.0) * length - m * 9.81 * length / 2.0) / inertia;
    near(said[0], alpha, 1e-13);
    near(said[1], pull * 0.8 / off(0.0), 1e-13);
    near(said[2], m * (9.81 + alpha * length / 2.0) - pull * 1.5 / off(0.0), 1e-13);
    let energy = |angle: f64| pull * off(angle) + m * 9.81 * length / 2.0 * angle.sin();
    let said = crate::joined::told(&bar.replace("END", "equilibrium"), &["phi", "omega_small"]);
    let (at, square) = crate::joined_edges::least(&energy, inertia, (0.2, 1.5));
    near(said[0], at, 1e-6);
    near(said[1], square.sqrt(), 1e-6);
}
