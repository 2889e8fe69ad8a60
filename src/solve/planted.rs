//! Proof that the agreement of the roads catches mechanical errors: each named term of each road is spoiled in turn.
use crate::num::plant;
use crate::scene::{
    Arm, Attach, Body, Coordinate, Cord, CordEnd, Couple, Degree, End, Far, Formulas, GivenForce, Growth,
    Line, Mass, Num, Particle, Pin, PinSpring, Rest, RotaryInertia, Scene, Side, Slope, Span, Start, Tie,
    Zero,
};
use crate::solve::agree::solve;
use std::collections::BTreeSet;

fn f(x: f64) -> Num {
    Num::Fixed(x)
}

fn body(name: &str, slope: Option<f64>, mass: f64, k: Option<f64>) -> Body {
    Body {
        name: name.to_owned(),
        mass: Mass::Kilograms(f(mass)),
        inertia: k.map(|k| RotaryInertia::Gyration(f(k))),
        radii_m: Vec::new(),
        line: slope.map(|s| Line {
            slope: if s > 89.0 { Slope::Vertical } else { Slope::Degrees(f(s)) },
            forward_up: true,
            surface: s < 89.0,
        }),
        turns: k.is_some(),
        particles: Vec::new(),
        pin: None,
    }
}

fn cord(from: (usize, Option<f64>, bool), to: Far) -> Tie {
    Tie::Cord(Cord { name: "cord".to_owned(), from: cord_end(from), to })
}

fn cord_end((body, wound, forward): (usize, Option<f64>, bool)) -> CordEnd {
    let attach = wound.map_or(Attach::Centre, |r| {
        Attach::Wound(f(r.abs()), if r > 0.0 { Side::Top } else { Side::Bottom })
    });
    CordEnd { body, attach, forward }
}

fn scene(bodies: Vec<Body>, ties: Vec<Tie>, travel: f64) -> Scene {
    let end = End::Travel(Coordinate { body: 0, degree: Degree::Along }, f(travel));
    Scene {
        gravity_m_s2: f(9.81),
        bodies,
        ties,
        couples: Vec::new(),
        growths: Vec::new(),
        start: Vec::new(),
        end,
        heading: None,
        span: Span::ToEnd,
        formulas: Formulas::default(),
    }
}

/// A body of 4 kg pinned 0.6 m from its mass centre, from one angle to another.
fn pinned(from: Zero, start: f64, end: f64) -> Scene {
    let mut swinging = body("body", None, 4.0, Some(0.35));
    swinging.pin = Some(Pin { arm: Arm::Distance(f(0.6)), from, start_deg: f(start), spring: None });
    let mut scene = scene(vec![swinging], Vec::new(), 1.0);
    scene.end = End::Angle(Coordinate { body: 0, degree: Degree::Turn }, f(end));
    scene
}

/// The same with a spring, and with a couple against the sense of a growing angle.
fn pinned_and_tied(start: f64, end: f64) -> Scene {
    let mut scene = pinned(Zero::Upright, start, end);
    if let Some(pin) = &mut scene.bodies[0].pin {
        pin.spring = Some(PinSpring {
            at_m: f(0.9),
            x_m: f(0.8),
            y_m: f(0.5),
            stiffness_n_m: f(30.0),
            rest: Rest::Length(f(0.4)),
        });
    }
    scene.couples.push(Couple { body: 0, moment_n_m: f(2.0), forward: false });
    scene
}

/// One scene of each kind, all data constants.
fn scenes() -> Vec<(&'static str, Scene)> {
    let wheel = || body("wheel", Some(25.0), 40.0, Some(0.22));
    let roll = |c: f64| Tie::Roll { body: 0, radius_m: f(c), mu_s: Some(f(0.9)) };
    let slip = |mu_s: f64, mu_k: f64| Tie::Slip { body: 0, radius_m: f(0.2), mu_s: f(mu_s), mu_k: f(mu_k) };
    let spring = |x0: f64, rigid| Far::Spring { stiffness_n_m: f(700.0), stretch_m: f(x0), rigid };
    let mut couple =
        scene(vec![wheel()], vec![roll(0.2), cord((0, Some(0.3), false), spring(0.0, false))], 0.2);
    couple.couples.push(Couple { body: 0, moment_n_m: f(75.0), forward: true });
    let mut thrown = scene(
        vec![body("block", Some(25.0), 3.0, None)],
        vec![Tie::Slide { body: 0, mu_s: None, mu_k: f(0.3) }],
        0.4,
    );
    thrown.start.push(Start::Speed(Coordinate { body: 0, degree: Degree::Along }, f(4.0)));
    let mut lamina = scene(vec![body("plate", None, 1.0, None)], Vec::new(), 1.0);
    lamina.bodies[0].particles = [(1.0, 0.1, 0.2), (2.0, 1.1, 0.3), (1.5, 0.7, 0.9)]
        .iter()
        .map(|(m, x, y)| Particle { name: "A".to_owned(), mass_kg: f(*m), x_m: f(*x), y_m: f(*y) })
        .collect();
    lamina.bodies[0].mass = Mass::OfParts;
    lamina.start.push(Start::Lamina {
        body: 0,
        particle: 1,
        vx_m_s: f(0.7),
        vy_m_s: f(-0.4),
        spin_rad_s: f(2.5),
    });
    lamina.end = End::AtOnce;
    let ball = |slope: f64, speed: f64, spin: f64, mu_k: f64, end: End| {
        let mut s = scene(
            vec![body("ball", Some(slope), 6.0, Some(0.07))],
            vec![Tie::Slip { body: 0, radius_m: f(0.11), mu_s: f(0.4), mu_k: f(mu_k) }],
            1.0,
        );
        s.start = [(Degree::Along, speed), (Degree::Turn, spin)]
            .map(|(degree, value)| Start::Speed(Coordinate { body: 0, degree }, f(value)))
            .to_vec();
        s.end = end;
        s
    };
    let along = Coordinate { body: 0, degree: Degree::Along };
    let mut braked = ball(15.0, 4.0, -20.0, 0.2, End::Rolling(along));
    braked.couples.push(Couple { body: 0, moment_n_m: f(0.3), forward: false });
    vec![
        (
            "pulled-rolling",
            scene(vec![wheel()], vec![roll(0.2), cord((0, Some(0.4), true), Far::Pull(f(200.0)))], 2.0),
        ),
        (
            "pulled-slipping",
            scene(vec![wheel()], vec![slip(0.2, 0.15), cord((0, Some(0.4), true), Far::Pull(f(400.0)))], 1.0),
        ),
        (
            "spring, slack",
            scene(vec![wheel()], vec![roll(0.4), cord((0, Some(0.2), true), spring(0.6, false))], 0.5),
        ),
        (
            "spring, down",
            scene(vec![wheel()], vec![roll(0.4), cord((0, Some(0.2), true), spring(0.05, false))], 0.1),
        ),
        ("couple and spring", couple),
        (
            "block over a massive pulley pulls a wheel",
            scene(
                vec![wheel(), body("pulley", None, 5.0, Some(0.1)), body("block", Some(90.0), 60.0, None)],
                vec![
                    roll(0.2),
                    cord((0, Some(0.4), true), Far::Body(cord_end((1, Some(0.15), false)))),
                    cord((1, Some(0.15), true), Far::Body(cord_end((2, None, true)))),
                ],
                0.6,
            ),
        ),
        (
            "yo-yo",
            scene(
                vec![body("yo-yo", Some(90.0), 0.3, Some(0.03))],
                vec![cord((0, Some(-0.01), true), Far::Fixed)],
                0.6,
            ),
        ),
        ("sliding block", thrown),
        ("a pull and a couple that grow", {
            let pull = cord((0, Some(0.4), true), Far::Pull(f(150.0)));
            let mut scene = scene(vec![wheel()], vec![roll(0.2), pull], 1.0);
            scene.couples = vec![Couple { body: 0, moment_n_m: f(4.0), forward: false }];
            scene.growths = vec![
                Growth { of: GivenForce::Pull(1), per_second: f(30.0) },
                Growth { of: GivenForce::Couple(0), per_second: f(2.5) },
            ];
            scene.start.push(Start::Speed(along, f(0.8)));
            scene.end = End::Time(along, f(1.5));
            scene
        }),
        ("thrown with backspin", ball(10.0, 5.0, -30.0, 0.2, End::Rolling(along))),
        ("thrown on a level", ball(0.0, 5.0, 10.0, 0.2, End::Rolling(along))),
        ("thrown, still slipping", ball(10.0, 5.0, -30.0, 0.2, End::Time(along, f(0.4)))),
        ("thrown, rolling since long", ball(10.0, 5.0, -30.0, 0.2, End::Time(along, f(5.0)))),
        ("thrown and braked", braked),
        ("lamina", lamina),
        ("hoist at an instant", {
            let bodies =
                vec![wheel(), body("drum", None, 5.0, Some(0.1)), body("block", Some(90.0), 60.0, None)];
            let ties = vec![
                cord((0, Some(0.4), true), Far::Body(cord_end((1, Some(0.15), false)))),
                cord((1, Some(0.25), true), Far::Body(cord_end((2, None, true)))),
            ];
            let mut scene = scene(bodies, ties, 1.0);
            for (body, degree, value) in [(0, Degree::Along, 1.5), (2, Degree::Along, -0.7)] {
                scene.start.push(Start::Speed(Coordinate { body, degree }, f(value)));
            }
            scene.end = End::AtOnce;
            scene
        }),
        ("pinned body falls", pinned(Zero::Upright, 20.0, 130.0)),
        ("pendulum", pinned(Zero::Hanging, 75.0, -30.0)),
        ("driven flywheel", {
            // A couple that turns a body hardly off its centre: the force across the arm then comes from the displacement.
            let mut scene = pinned_and_tied(40.0, 100.0);
            scene.bodies[0].inertia = Some(RotaryInertia::Gyration(f(2.5)));
            scene.couples = vec![Couple { body: 0, moment_n_m: f(300.0), forward: true }];
            scene
        }),
        ("pinned body with a spring", pinned_and_tied(40.0, 100.0)),
    ]
}

#[test]
fn both_roads_agree_on_every_scene() {
    for (name, scene) in scenes() {
        let solved = solve(&scene, &[]);
        assert!(solved.is_ok(), "{name}: {solved:?}");
    }
}

#[test]
fn every_planted_error_is_caught() {
    let scenes = scenes();
    for (_, scene) in &scenes {
        let _ = solve(scene, &[]);
    }
    let names = plant::seen();
    for road in ["eom: ", "energy: "] {
        let count = names.iter().filter(|n| n.starts_with(road)).count();
        assert!(count >= 12, "{road}{count} terms");
    }
    let mut missed = BTreeSet::new();
    for name in &names {
        // Forgotten, turned, doubled, and off by a millionth.
        for by in [0.0, -1.0, 2.0, 1.000_001] {
            let caught =
                scenes.iter().any(|(_, scene)| plant::spoiled(name, by, || solve(scene, &[])).is_err());
            if !caught {
                missed.insert(format!("{name} times {by}"));
            }
        }
    }
    assert!(missed.is_empty(), "not caught:\n{missed:#?}");
}
