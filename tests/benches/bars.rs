//! Times of the pieces that have a bar, with their allocations; run with `cargo bench --bench bars`.
use divan::{Bencher, black_box};
use slipstick::num::Dd;
use slipstick::num::linear::Linear;
use slipstick::problem::maker::Maker;
use slipstick::scene::Scene;
use slipstick::solve::agree;
use slipstick::solve::energy::account::{Account, Store};
use slipstick::solve::eom::travel::{Leg, Travel};

#[global_allocator]
static ALLOCATIONS: divan::AllocProfiler = divan::AllocProfiler::system();

fn main() {
    divan::main();
}

fn scene(problem: &str) -> (Scene, Vec<f64>) {
    let texts = [
        include_str!("../../banks/wheels-on-inclines.yaml"),
        include_str!("../../banks/slip-and-roll.yaml"),
        include_str!("../../banks/pinned-bodies.yaml"),
        include_str!("../../banks/rods-and-linkages.yaml"),
    ];
    let banks = texts.map(|t| slipstick::bank::load::scenes_only(t, "bank").expect("a bank"));
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == problem).expect("a problem");
    let variant = Maker::new(problem, 1, "bench").variant("0").expect("satisfiable");
    (problem.cases[variant.case].scene.clone(), variant.data)
}

/// Bar: 2 us. Both roads with regime checks and condition numbers.
#[divan::bench(args = ["pulled-rolling", "spring-released", "pulled-slipping", "thrown-ball", "falling-rod"])]
fn whole_solve(bencher: Bencher, problem: &str) {
    let (scene, data) = scene(problem);
    bencher.bench(|| agree::solve(black_box(&scene), black_box(&data)));
}

/// Bar: 60 us. The same of joined bodies, whose ratios of velocities vary.
#[divan::bench(args = ["sliding-ladder", "slider-crank", "four-bar-linkage"])]
fn whole_solve_of_joined_bodies(bencher: Bencher, problem: &str) {
    let (scene, data) = scene(problem);
    bencher.bench(|| agree::solve(black_box(&scene), black_box(&data)));
}

/// The speed from rest under one law.
fn speed(f: f64, w2: Option<f64>, s: f64) -> f64 {
    black_box(Travel { u0: 0.0, legs: &[Leg { from: 0.0, f, w2 }] }).at(black_box(s)).u
}

/// Bar: 25 ns. The speed of an assembled scene whose force is constant, by both roads.
#[divan::bench]
fn closed_v_of_a_pulled_scene_eom() -> f64 {
    speed(1.526, None, 3.0)
}
/// See [`closed_v_of_a_pulled_scene_eom`].
#[divan::bench]
fn closed_v_of_a_pulled_scene_energy() -> f64 {
    let account =
        Account { constant: 198.4, doubled: 130.0, energy0: 0.0, u0: 0.0, stores: [].into_iter().collect() };
    black_box(account).speed(black_box(3.0))
}
/// Bar: 25 ns. The same with a spring; the first gives the time too, by an arc tangent.
#[divan::bench]
fn closed_v_and_t_of_a_spring_scene_eom() -> f64 {
    speed(3.1, Some(7.7), 0.1)
}
/// See [`closed_v_and_t_of_a_spring_scene_eom`].
#[divan::bench]
fn closed_v_of_a_spring_scene_energy() -> f64 {
    let store = Store { tie: 0, stiffness: 650.0, stretch: 0.42, lost: 1.6, rigid: false };
    let account = Account {
        constant: -140.0,
        doubled: 56.0,
        energy0: 0.0,
        u0: 0.0,
        stores: [store].into_iter().collect(),
    };
    black_box(account).speed(black_box(0.1))
}
/// The same in 32 digits.
#[divan::bench]
fn closed_v_of_a_spring_scene_energy_32_digits() -> Dd {
    let d = Dd::new;
    let store = Store { tie: 0, stiffness: d(650.0), stretch: d(0.42), lost: d(1.6), rigid: false };
    let account = Account {
        constant: d(-140.0),
        doubled: d(56.0),
        energy0: d(0.0),
        u0: d(0.0),
        stores: [store].into_iter().collect(),
    };
    black_box(account).speed(black_box(d(0.1)))
}

/// Rows of a wheel that is pulled and rolls: a, alpha, N, F.
fn newton_euler<T: slipstick::num::Real>() -> Option<T> {
    let (one, of) = (T::of(1.0), |x: f64| T::of(black_box(x)));
    let mut rows = Linear::new(4, 1);
    rows.term(0, 0, of(40.0));
    rows.term(0, 3, -one);
    rows.right(0, 0, of(-1.56));
    rows.term(1, 1, of(0.9));
    rows.term(1, 3, of(0.1));
    rows.right(1, 0, of(20.0));
    rows.term(2, 2, one);
    rows.right(2, 0, of(379.0));
    rows.term(3, 0, one);
    rows.term(3, 1, of(-0.1));
    rows.solve().ok().map(|s| s.get(3, 0))
}
/// Bar: 150 ns, no allocation. Four unknowns, assembled and solved.
#[divan::bench]
fn newton_euler_of_four_unknowns() -> Option<f64> {
    newton_euler::<f64>()
}
/// The same in 32 digits.
#[divan::bench]
fn newton_euler_of_four_unknowns_32_digits() -> Option<Dd> {
    newton_euler::<Dd>()
}
