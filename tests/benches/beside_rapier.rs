//! A pulled wheel, a ladder and a slider-crank by slipstick and by `rapier2d`, the engine that one would otherwise reach for, in
//! one run on one machine.
//!
//! `cargo bench --features rapier --bench beside_rapier`
//!
//! In the engine the wheel rolls on its hub (a ball collider of the hub's radius, the wheel's mass and inertia) on a half-space,
//! gravity is turned by the slope, and the cord's force acts at the top of the rim in every step. The ladder ends in two small balls
//! that slide on smooth half-spaces, floor and wall. Crank, rod and piston hang together by revolute joints, the piston and the
//! ground by a prismatic one, and the couple acts in every step. A run stops at the first step beyond the end, where the rate is
//! interpolated between the last two steps.
#![allow(clippy::print_stdout, reason = "it prints its figures")]
#![allow(clippy::cast_possible_truncation, reason = "the engine counts in f32")]
use rapier2d::prelude::*;
use slipstick::problem::maker::Maker;
use slipstick::scene::{Label, Owner, Quantity, Scene};
use slipstick::solve::ladder;
use slipstick::solve::method::{Method, Rung};
use std::hint::black_box;
use std::time::Instant;

const G: f64 = 9.81;
/// Radius of the balls on which the ladder slides, m.
const TIP_M: f64 = 0.001;

/// The engine with what it moves.
#[derive(Default)]
struct World {
    gravity: Vector,
    parameters: IntegrationParameters,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    joints: ImpulseJointSet,
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad: DefaultBroadPhase,
    narrow: NarrowPhase,
    multi: MultibodyJointSet,
    soft: SoftBodySet,
    ccd: CCDSolver,
}

fn vector([x, y]: [f64; 2]) -> Vector {
    Vector::new(x as f32, y as f32)
}

impl World {
    fn new(gravity: [f64; 2], dt: f64) -> Self {
        let parameters = IntegrationParameters { dt: dt as f32, ..IntegrationParameters::default() };
        Self { gravity: vector(gravity), parameters, ..Self::default() }
    }
    fn body(&mut self, place: [f64; 2], angle: f64, mass: f64, inertia: f64) -> RigidBodyHandle {
        let own = MassProperties::new(Vector::ZERO, mass as f32, inertia as f32);
        let body = RigidBodyBuilder::dynamic().translation(vector(place)).rotation(angle as f32);
        self.bodies.insert(body.additional_mass_properties(own).can_sleep(false))
    }
    fn halfspace(&mut self, normal: Vector, place: [f64; 2], mu: f64) {
        let normal = rapier2d::prelude::nalgebra::Unit::new_unchecked(normal);
        let plane = ColliderBuilder::halfspace(normal).translation(vector(place)).friction(mu as f32);
        self.colliders.insert(plane.build());
    }
    fn ball(&mut self, body: RigidBodyHandle, place: [f64; 2], radius: f64, mu: f64) {
        let ball = ColliderBuilder::ball(radius as f32).translation(vector(place)).density(0.0);
        let ball = ball.friction(mu as f32).restitution(0.0);
        self.colliders.insert_with_parent(ball, body, &mut self.bodies);
    }
    fn hinge(&mut self, one: RigidBodyHandle, at: [f64; 2], other: RigidBodyHandle, there: [f64; 2]) {
        let hinge = RevoluteJointBuilder::new().local_anchor1(vector(at)).local_anchor2(vector(there));
        self.joints.insert(one, other, hinge, true);
    }
    fn step(&mut self) {
        self.pipeline.step(
            self.gravity,
            &self.parameters,
            &mut self.islands,
            &mut self.broad,
            &mut self.narrow,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.joints,
            &mut self.multi,
            &mut self.soft,
            &mut self.ccd,
            &(),
            &(),
        );
    }
    /// Where the middle of a body is.
    fn middle(&self, body: RigidBodyHandle) -> [f64; 2] {
        let place = self.bodies[body].translation();
        [f64::from(place.x), f64::from(place.y)]
    }
    /// Where a point on the axis of a body is, so far from its middle.
    fn point(&self, body: RigidBodyHandle, along: f64) -> [f64; 2] {
        let ([x, y], angle) = (self.middle(body), f64::from(self.bodies[body].rotation().angle()));
        let (sine, cosine) = slipstick::num::trig::sin_cos_f64(angle);
        [x + along * cosine, y + along * sine]
    }
    /// Steps until a place has grown to its end; `state` gives the place and the rate that is asked.
    fn follow(
        &mut self,
        end: f64,
        push: impl Fn(&mut Self),
        mut state: impl FnMut(&Self) -> (f64, f64),
    ) -> (f64, u32) {
        let (mut before, mut steps) = (state(self), 0);
        loop {
            push(self);
            self.step();
            steps += 1;
            let now = state(self);
            if now.0 >= end || steps > 10_000_000 {
                let share = (end - before.0) / (now.0 - before.0);
                return (before.1 + share * (now.1 - before.1), steps);
            }
            before = now;
        }
    }
}

/// What a run of the engine gives: the rate that is asked, how far a body is off its guide, and the number of steps.
struct Found {
    rate: f64,
    off: f64,
    steps: u32,
}

/// A problem of the built-in banks with these data.
struct Case {
    title: &'static str,
    bank: &'static str,
    problem: &'static str,
    data: &'static [(&'static str, f64)],
    label: Label,
    off: &'static str,
    engine: fn(f64) -> Found,
}

const M_KG: f64 = 40.0;
const RIM_M: f64 = 0.4;
const HUB_M: f64 = 0.2;
const K_M: f64 = 0.3;
const SLOPE_DEG: f64 = 30.0;
const P_N: f64 = 200.0;
const D_M: f64 = 3.0;
const MU: f64 = 0.6;

fn wheel(dt: f64) -> Found {
    let (sine, cosine) = slipstick::num::trig::sin_cos_f64(SLOPE_DEG.to_radians());
    let mut world = World::new([-G * sine, -G * cosine], dt);
    world.halfspace(Vector::Y, [0.0, 0.0], MU);
    let wheel = world.body([0.0, HUB_M], 0.0, M_KG, M_KG * K_M * K_M);
    world.ball(wheel, [0.0, 0.0], HUB_M, MU);
    let pull = |world: &mut World| {
        let [x, y] = world.middle(wheel);
        let body = &mut world.bodies[wheel];
        body.reset_forces(true);
        body.reset_torques(true);
        body.add_force_at_point(vector([P_N, 0.0]), vector([x, y + RIM_M]), true);
    };
    let mut turned = 0.0;
    // Rolling up the incline is clockwise.
    let (rate, steps) = world.follow(D_M, pull, |world| {
        let omega = -f64::from(world.bodies[wheel].angvel());
        turned += omega * dt;
        (world.middle(wheel)[0], omega)
    });
    Found { rate, off: (world.middle(wheel)[0] - HUB_M * turned).abs(), steps }
}

const LADDER_KG: f64 = 10.0;
const LADDER_M: f64 = 4.0;
const LEANS_DEG: f64 = 70.0;

fn leaning(dt: f64) -> Found {
    let mut world = World::new([0.0, -G], dt);
    world.halfspace(Vector::Y, [0.0, -TIP_M], 0.0);
    world.halfspace(Vector::X, [-TIP_M, 0.0], 0.0);
    let (sine, cosine) = slipstick::num::trig::sin_cos_f64(LEANS_DEG.to_radians());
    let half = 0.5 * LADDER_M;
    // From the wall down to the floor.
    let ladder = world.body(
        [half * cosine, half * sine],
        -LEANS_DEG.to_radians(),
        LADDER_KG,
        LADDER_KG * half * half / 3.0,
    );
    world.ball(ladder, [-half, 0.0], TIP_M, 0.0);
    world.ball(ladder, [half, 0.0], TIP_M, 0.0);
    // It leaves the wall where it has fallen by a third of its height.
    let (rate, steps) = world.follow(
        -2.0 / 3.0 * half * sine,
        |_| {},
        |world| (-world.middle(ladder)[1], f64::from(world.bodies[ladder].angvel())),
    );
    Found { rate, off: world.point(ladder, half)[1].abs(), steps }
}

const CRANK_KG: f64 = 2.0;
const ROD_KG: f64 = 1.5;
const PISTON_KG: f64 = 1.0;
const CRANK_M: f64 = 0.25;
const ROD_M: f64 = 0.6;
const COUPLE_N_M: f64 = 20.0;
const FROM_DEG: f64 = 30.0;
const TO_DEG: f64 = 65.0;

fn cranked(dt: f64) -> Found {
    let mut world = World::new([0.0, -G], dt);
    let (sine, cosine) = slipstick::num::trig::sin_cos_f64(FROM_DEG.to_radians());
    let (r, l) = (0.5 * CRANK_M, 0.5 * ROD_M);
    let fall = CRANK_M * sine / ROD_M;
    let across = (1.0 - fall * fall).sqrt();
    let ground = world.bodies.insert(RigidBodyBuilder::fixed());
    let crank = world.body([r * cosine, r * sine], FROM_DEG.to_radians(), CRANK_KG, CRANK_KG * r * r / 3.0);
    let middle = [CRANK_M * cosine + l * across, l * fall];
    let rod = world.body(middle, -slipstick::num::trig::angle(fall, across), ROD_KG, ROD_KG * l * l / 3.0);
    let piston = world.body([CRANK_M * cosine + ROD_M * across, 0.0], 0.0, PISTON_KG, 1.0);
    world.hinge(ground, [0.0, 0.0], crank, [-r, 0.0]);
    world.hinge(crank, [r, 0.0], rod, [-l, 0.0]);
    world.hinge(rod, [l, 0.0], piston, [0.0, 0.0]);
    world.joints.insert(ground, piston, PrismaticJointBuilder::new(Vector::X), true);
    let turn = |world: &mut World| {
        let body = &mut world.bodies[crank];
        body.reset_torques(true);
        body.add_torque(COUPLE_N_M as f32, true);
    };
    let (rate, steps) = world.follow(TO_DEG.to_radians(), turn, |world| {
        let body = &world.bodies[crank];
        (f64::from(body.rotation().angle()), f64::from(body.angvel()))
    });
    let ([x, y], [u, v]) = (world.point(crank, r), world.point(rod, -l));
    Found { rate, off: (x - u).abs().max((y - v).abs()), steps }
}

const CASES: [Case; 3] = [
    Case {
        title: "pulled wheel",
        bank: include_str!("../../banks/wheels-on-inclines.yaml"),
        problem: "pulled-rolling",
        data: &[
            ("m", M_KG),
            ("R", RIM_M),
            ("r", HUB_M),
            ("k", K_M),
            ("theta", SLOPE_DEG),
            ("P", P_N),
            ("d", D_M),
            ("mu_s", MU),
            ("g", G),
        ],
        label: Label { quantity: Quantity::Omega, of: Owner::Body(0) },
        off: "slip, m",
        engine: wheel,
    },
    Case {
        title: "ladder until it leaves the wall",
        bank: include_str!("../../banks/rods-and-linkages.yaml"),
        problem: "sliding-ladder",
        data: &[("m", LADDER_KG), ("L", LADDER_M), ("theta0", LEANS_DEG), ("g", G)],
        label: Label { quantity: Quantity::Omega, of: Owner::Body(0) },
        off: "in floor, m",
        engine: leaning,
    },
    Case {
        title: "slider-crank",
        bank: include_str!("../../banks/rods-and-linkages.yaml"),
        problem: "slider-crank",
        data: &[
            ("m1", CRANK_KG),
            ("m2", ROD_KG),
            ("m3", PISTON_KG),
            ("r", CRANK_M),
            ("L", ROD_M),
            ("M", COUPLE_N_M),
            ("theta0", FROM_DEG),
            ("theta1", TO_DEG),
            ("g", G),
        ],
        label: Label { quantity: Quantity::Omega, of: Owner::Body(0) },
        off: "gap, m",
        engine: cranked,
    },
];

fn scene(case: &Case) -> (Scene, Vec<f64>) {
    let bank = slipstick::bank::load::scenes_only(case.bank, "bank").expect("the bank of the project");
    let problem = bank.problems.iter().find(|p| p.id == case.problem).expect("a problem");
    let variant = Maker::new(problem, 1, "bench").variant("0").expect("satisfiable");
    let set = |symbol: &str| case.data.iter().find(|(s, _)| *s == symbol).map(|(_, x)| *x);
    let data = problem.data.iter().zip(&variant.data);
    let data = data.map(|(datum, drawn)| set(&datum.symbol).unwrap_or(*drawn)).collect();
    (problem.cases[variant.case].scene.clone(), data)
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
    for case in CASES {
        beside(&case);
    }
}

fn beside(case: &Case) {
    let (scene, data) = scene(case);
    let labels = [case.label];
    let joined = scene.lead().is_some() && scene.pinned().is_none();
    let closed: &[(Rung, &str)] = if joined {
        &[(Rung::Settled, "slipstick, 32 digits")]
    } else {
        &[(Rung::Closed, "slipstick, 32 digits"), (Rung::Doubles, "slipstick, doubles")]
    };
    let exact = ladder::once(&scene, &data, closed[0].0, &labels).expect("it moves")[0];
    println!("{}: omega = {exact:.9} rad/s", case.title);
    println!("{:<26} {:>8} {:>14} {:>12} {:>12}", "method", "steps", "error of omega", case.off, "time");
    let show = |name: &str, steps: String, omega: f64, off: f64, seconds: f64| {
        println!(
            "{name:<26} {steps:>8} {:>14.1e} {off:>12.1e} {:>9.2} us",
            ((omega - exact) / exact).abs(),
            seconds * 1e6
        );
    };
    let stepped = [
        (Rung::Adaptive(Method::Dop853, 1e-12, 1.0), "slipstick, dop853 1e-12"),
        (Rung::Fixed(Method::Euler, 1.0 / 60.0), "slipstick, euler 1/60 s"),
        (Rung::Fixed(Method::Euler, 1.0 / 240.0), "slipstick, euler 1/240 s"),
        (Rung::Fixed(Method::Euler, 1e-3), "slipstick, euler 1/1000 s"),
    ];
    for (rung, name) in closed.iter().copied().chain(stepped) {
        let omega = ladder::once(&scene, &data, rung, &labels).expect("it moves")[0];
        let seconds = time(|| {
            let _ = black_box(ladder::once(black_box(&scene), black_box(&data), rung, &labels));
        });
        let steps = ladder::road::<slipstick::num::Dd>(&scene, &data, rung, &|_| false)
            .map_or(0, |(_, count)| count.steps);
        show(name, steps.to_string(), omega, 0.0, seconds);
    }
    for (dt, name) in
        [(1.0 / 60.0, "rapier2d, 1/60 s"), (1.0 / 240.0, "rapier2d, 1/240 s"), (1e-3, "rapier2d, 1/1000 s")]
    {
        let found = (case.engine)(dt);
        let seconds = time(|| {
            black_box((case.engine)(black_box(dt)));
        });
        show(name, found.steps.to_string(), found.rate, found.off, seconds);
    }
    println!();
}
