//! Times and counts of each rung of the ladder; run with `cargo bench --bench rungs`.
//!
//! Beside each name stands the number of force evaluations. A run is one whole road, from the data to the asked speeds.
use divan::{Bencher, black_box};
use slipstick::bank::Bank;
use slipstick::num::Dd;
use slipstick::problem::maker::Maker;
use slipstick::scene::{Label, Quantity, Scene};
use slipstick::solve::ladder;
use slipstick::solve::method::{Method, Rung};
use std::fmt;

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
            Rung::Adaptive(m, rtol, _) => format!("{}, rtol {rtol:e}", m.as_str()),
            Rung::Fixed(m, h) => format!("{}, 1/{:.0} s", m.as_str(), 1.0 / h),
        };
        write!(f, "{}: {setting}: {} evaluations", self.problem, self.evaluations)
    }
}

fn rungs() -> Vec<Named> {
    let mut list = Vec::new();
    for problem in ["pulled-rolling", "spring-released", "thrown-ball", "falling-rod", "rod-and-spring"] {
        let (scene, data, labels) = scene(problem);
        let wanted = |q: Quantity| labels.iter().any(|l| l.quantity == q);
        let mut add = |rung: Rung| {
            let road = ladder::road::<Dd>(&scene, &data, rung, &wanted);
            if let Ok((_, count)) = road {
                list.push(Named { problem, rung, evaluations: count.evaluations });
            }
        };
        if problem == "rod-and-spring" {
            add(Rung::Settled);
        } else {
            add(Rung::Doubles);
            add(Rung::Closed);
        }
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
