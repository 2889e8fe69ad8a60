//! The pulled wheel by slipstick and by `rapier2d`, the engine that one would otherwise reach for, in one run on one machine.
//!
//! `cargo bench --features rapier --bench beside_rapier`
//!
//! The wheel rolls on its hub (a ball collider of the hub's radius, the wheel's mass and inertia) on a half-space; gravity is
//! turned by the slope; the cord's force acts at the top of the rim in every step. The engine stops at the first step beyond d,
//! and its angular speed there is interpolated between the last two steps.
#![allow(clippy::print_stdout, reason = "it prints its figures")]
#![allow(clippy::cast_possible_truncation, reason = "the engine counts in f32")]
use rapier2d::prelude::*;
use slipstick::problem::maker::Maker;
use slipstick::scene::{Label, Owner, Quantity, Scene};
use slipstick::solve::ladder;
use slipstick::solve::method::{Method, Rung};
use std::hint::black_box;
use std::time::Instant;

const M_KG: f64 = 40.0;
const RIM_M: f64 = 0.4;
const HUB_M: f64 = 0.2;
const K_M: f64 = 0.3;
const SLOPE_DEG: f64 = 30.0;
const P_N: f64 = 200.0;
const D_M: f64 = 3.0;
const MU: f64 = 0.6;
const G: f64 = 9.81;

struct Found {
    omega: f64,
    slip: f64,
    steps: u32,
}

fn rapier(dt: f64) -> Found {
    let (sine, cosine) = slipstick::num::trig::sin_cos_f64(SLOPE_DEG.to_radians());
    let gravity = Vector::new((-G * sine) as f32, (-G * cosine) as f32);
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    colliders.insert(
        ColliderBuilder::halfspace(rapier2d::prelude::nalgebra::Unit::new_unchecked(Vector::Y))
            .friction(MU as f32)
            .build(),
    );
    let inertia = M_KG * K_M * K_M;
    let wheel = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, HUB_M as f32))
        .additional_mass_properties(MassProperties::new(Vector::ZERO, M_KG as f32, inertia as f32))
        .can_sleep(false);
    let wheel = bodies.insert(wheel);
    let ball = ColliderBuilder::ball(HUB_M as f32).density(0.0).friction(MU as f32).restitution(0.0);
    colliders.insert_with_parent(ball, wheel, &mut bodies);
    let parameters = IntegrationParameters { dt: dt as f32, ..IntegrationParameters::default() };
    let mut pipeline = PhysicsPipeline::new();
    let (mut islands, mut broad, mut narrow) =
        (IslandManager::new(), DefaultBroadPhase::new(), NarrowPhase::new());
    let (mut joints, mut multi, mut soft, mut ccd) =
        (ImpulseJointSet::new(), MultibodyJointSet::new(), SoftBodySet::new(), CCDSolver::new());
    let (mut turned, mut steps) = (0.0f64, 0);
    let (mut before, mut place) = (0.0f64, 0.0f64);
    loop {
        let body = &mut bodies[wheel];
        body.reset_forces(true);
        body.reset_torques(true);
        let centre = body.translation();
        let top = Vector::new(centre.x, centre.y + RIM_M as f32);
        body.add_force_at_point(Vector::new(P_N as f32, 0.0), top, true);
        pipeline.step(
            gravity,
            &parameters,
            &mut islands,
            &mut broad,
            &mut narrow,
            &mut bodies,
            &mut colliders,
            &mut joints,
            &mut multi,
            &mut soft,
            &mut ccd,
            &(),
            &(),
        );
        steps += 1;
        let body = &bodies[wheel];
        // Rolling up the incline is clockwise.
        let (x, omega) = (f64::from(body.translation().x), -f64::from(body.angvel()));
        turned += omega * dt;
        if x >= D_M || steps > 10_000_000 {
            let share = (D_M - place) / (x - place);
            return Found {
                omega: before + share * (omega - before),
                slip: (x - HUB_M * turned).abs(),
                steps,
            };
        }
        (before, place) = (omega, x);
    }
}

fn wheel() -> (Scene, Vec<f64>) {
    let text = include_str!("../../banks/wheels-on-inclines.yaml");
    let bank = slipstick::bank::load::scenes_only(text, "bank").expect("the bank of the project");
    let problem = bank.problems.iter().find(|p| p.id == "pulled-rolling").expect("a problem");
    let variant = Maker::new(problem, 1, "bench").variant("0").expect("satisfiable");
    let data = problem.data.iter().zip(&variant.data).map(|(datum, drawn)| match datum.symbol.as_str() {
        "m" => M_KG,
        "R" => RIM_M,
        "r" => HUB_M,
        "k" => K_M,
        "theta" => SLOPE_DEG,
        "P" => P_N,
        "d" => D_M,
        "mu_s" => MU,
        "g" => G,
        _ => *drawn,
    });
    (problem.cases[variant.case].scene.clone(), data.collect())
}

/// Median time of a run, s.
fn time(mut run: impl FnMut()) -> f64 {
    let start = Instant::now();
    run();
    let each = start.elapsed().as_secs_f64().max(1e-8);
    let n = ((0.005 / each) as usize).max(1);
    let mut times: Vec<f64> = (0..9)
        .map(|_| {
            let start = Instant::now();
            for _ in 0..n {
                run();
            }
            start.elapsed().as_secs_f64() / n as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[4]
}

fn main() {
    let (scene, data) = wheel();
    let label = [Label { quantity: Quantity::Omega, of: Owner::Body(0) }];
    // omega^2 = 2 d (P (r + R)/r - m g sin) / (m (r^2 + k^2)) with the sine of 30 degrees exact.
    let exact = (2.0 * D_M * (P_N * (HUB_M + RIM_M) / HUB_M - 0.5 * M_KG * G)
        / (M_KG * (HUB_M * HUB_M + K_M * K_M)))
        .sqrt();
    println!("pulled wheel, d = {D_M} m: omega = {exact:.9} rad/s");
    println!("{:<26} {:>8} {:>14} {:>12} {:>12}", "method", "steps", "error of omega", "slip, m", "time");
    let show = |name: &str, steps: String, omega: f64, slip: f64, seconds: f64| {
        println!(
            "{name:<26} {steps:>8} {:>14.1e} {slip:>12.1e} {:>9.2} us",
            ((omega - exact) / exact).abs(),
            seconds * 1e6
        );
    };
    for (rung, name) in [
        (Rung::Doubles, "slipstick, doubles"),
        (Rung::Closed, "slipstick, 32 digits"),
        (Rung::Adaptive(Method::Dop853, 1e-12, 1.0), "slipstick, dop853 1e-12"),
        (Rung::Fixed(Method::Euler, 1.0 / 60.0), "slipstick, euler 1/60 s"),
        (Rung::Fixed(Method::Euler, 1.0 / 240.0), "slipstick, euler 1/240 s"),
        (Rung::Fixed(Method::Euler, 1e-3), "slipstick, euler 1/1000 s"),
    ] {
        let omega = ladder::once(&scene, &data, rung, &label).expect("it rolls")[0];
        let seconds = time(|| {
            let _ = black_box(ladder::once(black_box(&scene), black_box(&data), rung, &label));
        });
        let steps = ladder::road::<slipstick::num::Dd>(&scene, &data, rung, &|_| false)
            .map_or(0, |(_, count)| count.steps);
        show(name, steps.to_string(), omega, 0.0, seconds);
    }
    for (dt, name) in
        [(1.0 / 60.0, "rapier2d, 1/60 s"), (1.0 / 240.0, "rapier2d, 1/240 s"), (1e-3, "rapier2d, 1/1000 s")]
    {
        let found = rapier(dt);
        let seconds = time(|| {
            black_box(rapier(black_box(dt)));
        });
        show(name, found.steps.to_string(), found.omega, found.slip, seconds);
    }
}
