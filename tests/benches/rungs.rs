//! Times and counts of each rung of the ladder, and of the pieces that the bars name; run with `cargo bench --bench rungs`.
//!
//! Beside each name stands the number of force evaluations. Allocations are counted too: the closed forms and the small linear
//! systems make none.
use divan::Bencher;
use divan::black_box;
use slipstick::bank::Bank;
use slipstick::num::Dd;
use slipstick::num::linear::Linear;
use slipstick::problem::make::Maker;
use slipstick::scene::{Label, Quantity, Scene};
use slipstick::solve::agree;
use slipstick::solve::energy::account::{Account, Store};
use slipstick::solve::eom::travel::Travel;
use slipstick::solve::ladder;
use slipstick::solve::method::{Method, Rung};
use std::fmt;

#[global_allocator]
static ALLOCATIONS: divan::AllocProfiler = divan::AllocProfiler::system();

fn main() {
    divan::main();
}

fn scene(problem: &str) -> (Scene, Vec<f64>, Vec<Label>) {
    let texts =
        [include_str!("../../banks/wheels-on-inclines.yaml"), include_str!("../../banks/slip-and-roll.yaml")];
    let banks: Vec<Bank> =
        texts.iter().map(|t| slipstick::bank::load::scenes_only(t, "bank").expect("a bank")).collect();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == problem).expect("a problem");
    let variant = Maker::new(problem, 1, "bench").variant("0").expect("satisfiable");
    let labels = problem
        .questions
        .iter()
        .map(|q| q.label)
        .filter(|l| matches!(l.quantity, Quantity::V | Quantity::Omega));
    (problem.cases[variant.case].scene.clone(), variant.data.clone(), labels.collect())
}

/// A rung of a scene, named with its number of force evaluations.
struct Named {
    problem: &'static str,
    rung: Rung,
    evaluations: u64,
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let setting = match self.rung {
            Rung::Closed => "closed, 32 digits".to_owned(),
            Rung::Doubles => "closed, doubles".to_owned(),
            Rung::Settled => "gauss, settled".to_owned(),
            Rung::Gauss(n) => format!("gauss, {n} points"),
            Rung::Adaptive(m, rtol, _) => format!("{}, rtol {rtol:e}", m.name()),
            Rung::Fixed(m, h) => format!("{}, 1/{:.0} s", m.name(), 1.0 / h),
        };
        write!(f, "{}: {setting}: {} evaluations", self.problem, self.evaluations)
    }
}

fn rungs() -> Vec<Named> {
    let mut list = Vec::new();
    for problem in ["pulled-rolling", "spring-released", "thrown-ball"] {
        let (scene, data, labels) = scene(problem);
        let wanted = |q: Quantity| labels.iter().any(|l| l.quantity == q);
        let mut add = |rung: Rung| {
            let road = ladder::road::<Dd>(&scene, &data, rung, &wanted);
            if let Ok((_, count)) = road {
                list.push(Named { problem, rung, evaluations: count.evaluations });
            }
        };
        add(Rung::Doubles);
        add(Rung::Closed);
        if problem != "thrown-ball" {
            add(Rung::Gauss(8));
        }
        for method in [Method::Dop853, Method::Dopri5] {
            add(Rung::Adaptive(method, 1e-6, 1.0));
            add(Rung::Adaptive(method, 1e-12, 1.0));
        }
        for method in [Method::Rk4, Method::Verlet, Method::Euler] {
            add(Rung::Fixed(method, 1.0 / 60.0));
            add(Rung::Fixed(method, 1e-3));
        }
    }
    list
}

/// One road from the data to the asked speeds.
#[divan::bench(args = rungs())]
fn one_road(bencher: Bencher, named: &Named) {
    let (scene, data, labels) = scene(named.problem);
    bencher.bench(|| ladder::once(black_box(&scene), black_box(&data), named.rung, &labels));
}

/// Bar: 2 us. Both roads with regime checks and condition numbers.
#[divan::bench(args = ["pulled-rolling", "spring-released", "pulled-slipping", "thrown-ball"])]
fn whole_solve(bencher: Bencher, problem: &str) {
    let (scene, data, _) = scene(problem);
    bencher.bench(|| agree::solve(black_box(&scene), black_box(&data)));
}

/// Bar: 25 ns. The speed of an assembled scene whose force is constant, by both roads.
#[divan::bench]
fn closed_v_of_a_pulled_scene_eom() -> f64 {
    black_box(Travel { u0: 0.0, f0: 1.526, w2: None, slack: None }).at(black_box(3.0)).u
}
/// See [`closed_v_of_a_pulled_scene_eom`].
#[divan::bench]
fn closed_v_of_a_pulled_scene_energy() -> f64 {
    let account = Account { constant: 198.4, doubled: 130.0, energy0: 0.0, u0: 0.0, store: None };
    black_box(account).speed(black_box(3.0))
}
/// Bar: 25 ns. The same with a spring; the first gives the time too, by an arc tangent.
#[divan::bench]
fn closed_v_and_t_of_a_spring_scene_eom() -> f64 {
    black_box(Travel { u0: 0.0, f0: 3.1, w2: Some(7.7), slack: None }).at(black_box(0.1)).u
}
/// See [`closed_v_and_t_of_a_spring_scene_eom`].
#[divan::bench]
fn closed_v_of_a_spring_scene_energy() -> f64 {
    let store = Store { stiffness: 650.0, stretch: 0.42, lost: 1.6, rigid: false };
    let account = Account { constant: -140.0, doubled: 56.0, energy0: 0.0, u0: 0.0, store: Some(store) };
    black_box(account).speed(black_box(0.1))
}
/// The same in 32 digits.
#[divan::bench]
fn closed_v_of_a_spring_scene_energy_32_digits() -> Dd {
    let d = Dd::new;
    let store = Store { stiffness: d(650.0), stretch: d(0.42), lost: d(1.6), rigid: false };
    let account =
        Account { constant: d(-140.0), doubled: d(56.0), energy0: d(0.0), u0: d(0.0), store: Some(store) };
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
