//! Every method of the ladder agrees with the closed forms within its own error estimate, or refuses with numbers.
use crate::support;
use slipstick::num::ode::Trouble;
use slipstick::num::{Dd, Real};
use slipstick::problem::maker::Maker;
use slipstick::scene::{Coordinate, Degree, End, Label, Num, Owner, Quantity, Scene, Start, Tie};
use slipstick::solve::ladder::{Force, Wish};
use slipstick::solve::method::{Method, Rung};
use slipstick::solve::outcome::Refusal;
use slipstick::solve::{eom, ladder};

/// Drawn scenes of all problems in which something moves: name, scene, data.
fn drawn(seeds: u32) -> Vec<(String, Scene, Vec<f64>)> {
    let mut found = Vec::new();
    for bank in &support::banks() {
        for problem in bank.problems.iter().filter(|p| !matches!(p.cases[0].scene.end, End::AtOnce)) {
            let seeds = seeds.div_ceil(support::dear(problem));
            for seed in 0..u64::from(seeds) {
                let variant = Maker::new(problem, seed, "ladder").variant("0").unwrap();
                let scene = problem.cases[variant.case].scene.clone();
                found.push((format!("{} seed {seed}", problem.id), scene, variant.data));
            }
        }
    }
    assert!(found.len() >= 5 * usize::try_from(seeds).unwrap());
    found
}

const TIME: Label = Label { quantity: Quantity::T, of: Owner::Scene };

/// The same motion with other ends: half of the time, half of the speed, the turning point; and thrown instead of released.
fn variations(scene: &Scene, data: &[f64]) -> Vec<Scene> {
    let mut found = vec![scene.clone()];
    let Ok((solved, _)) = ladder::solve(scene, data, &Wish::default()) else { return found };
    if scene.thrown().is_some() {
        // Before and after the start of rolling.
        let time = solved.get(TIME).map_or(1.0, |e| e.value());
        let along = Coordinate { body: 0, degree: Degree::Along };
        found.extend(
            [0.5, 2.0]
                .map(|share| Scene { end: End::Time(along, Num::Fixed(share * time)), ..scene.clone() }),
        );
        return found;
    }
    let end = scene.ending_coordinate();
    let value = |q: Quantity, of: Owner| solved.get(Label { quantity: q, of }).map(|e| e.value());
    let speed = match end.degree {
        Degree::Along => value(Quantity::V, Owner::Body(end.body)),
        Degree::Turn => value(Quantity::Omega, Owner::Body(end.body)),
    };
    let time = value(Quantity::T, Owner::Scene);
    let with = |end: End| Scene { end, ..scene.clone() };
    found.extend(time.map(|t| with(End::Time(end, Num::Fixed(0.5 * t)))));
    found.extend(speed.map(|u| with(End::Speed(end, Num::Fixed(0.5 * u)))));
    if scene.is_sprung() || scene.is_pendulum() {
        found.push(with(End::TurningPoint(end)));
    }
    let slips = scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. }));
    if let (Some(u), false) = (speed, slips) {
        // Thrown backwards it slows down past the end and turns beyond it; thrown on it is faster.
        for u in [-1.2 * u, 0.7 * u] {
            let thrown =
                Scene { start: vec![Start::Speed(end, Num::Fixed(u))], heading: None, ..scene.clone() };
            found.push(Scene { end: End::TurningPoint(end), ..thrown.clone() });
            found.push(thrown);
        }
    }
    found
}

/// Wishes for every method, coarse and fine.
fn wishes() -> Vec<Wish> {
    let mut list = Vec::new();
    for method in Method::ALL.iter().copied() {
        match method {
            Method::Closed => list.push(Wish { method: Some(method), ..Wish::default() }),
            Method::Gauss | Method::Dopri5 | Method::Dop853 => {
                for rtol in [None, Some(1e-3), Some(1e-6), Some(1e-10)] {
                    list.push(Wish { method: Some(method), rtol, step_s: None });
                }
            }
            _ => {
                for step_s in [1.0 / 60.0, 1e-3] {
                    list.push(Wish { method: Some(method), rtol: None, step_s: Some(step_s) });
                }
            }
        }
    }
    list
}

#[test]
fn every_method_agrees_within_its_own_estimate() {
    let (mut solved, mut refused) = (0u32, Vec::new());
    let draws = (support::seeds(800) / 100).max(2);
    for (name, scene, data) in drawn(draws) {
        for (i, scene) in variations(&scene, &data).into_iter().enumerate() {
            let Ok((closed, _)) = ladder::solve(&scene, &data, &Wish::default()) else { continue };
            if closed.get(TIME).is_none() {
                continue; // Thrown the other way it does not get there.
            }
            let reference = eom::road::<Dd>(&scene, &data).unwrap();
            let thrown = scene.thrown().is_some();
            let irregular = matches!(ladder::force(&scene), Force::Irregular | Force::Joined);
            // What is looked for is searched for in closed form, and the accelerations of joined bodies hang on the speed.
            let searched = scene.formulas.found.is_some();
            let joined = scene.lead().is_some() && scene.pinned().is_none();
            let applies = |w: &Wish| match w.method {
                Some(method)
                    if searched && method != Method::Closed || joined && method == Method::Verlet =>
                {
                    assert!(
                        matches!(ladder::solve(&scene, &data, w), Err(Refusal::NoMethod { .. })),
                        "{name}"
                    );
                    false
                }
                Some(Method::Gauss) => !thrown,
                Some(Method::Closed) => !irregular,
                _ => true,
            };
            for wish in wishes().into_iter().filter(applies) {
                match ladder::solve(&scene, &data, &wish) {
                    Ok((found, taken)) => {
                        solved += 1;
                        for (label, error) in &taken.errors {
                            let entry = found.get(*label).unwrap();
                            let method = taken.rung.method();
                            let value = if method == Method::Gauss { entry.energy } else { entry.eom };
                            let truth = reference.get(*label).unwrap().value;
                            let miss = (Dd::new(value.unwrap()) - truth).abs().hi;
                            assert!(
                                miss <= *error || value.unwrap() == truth.hi,
                                "{name} {i} {wish:?} {label:?}: off by {miss:e}, estimated {error:e}"
                            );
                        }
                    }
                    Err(refusal) => refused.push(format!("{name} {i} {wish:?}: {refusal:?}")),
                }
            }
        }
    }
    // Coarse runs may refuse near a turning point; fine ones and most of all do not.
    let fine = |text: &&String| !text.contains("step_s: Some(0.01") && !text.contains("rtol: Some(0.001)");
    let bad: Vec<_> = refused.iter().filter(fine).collect();
    assert!(solved > 400 * draws, "{solved}");
    assert!(
        bad.len() * 200 < usize::try_from(solved).unwrap(),
        "{} of {solved}: {:#?}",
        bad.len(),
        &bad[..bad.len().min(20)]
    );
    assert!(
        refused.len() * 20 < usize::try_from(solved).unwrap(),
        "{:#?}",
        &refused[..refused.len().min(20)]
    );
}

/// One scene of a problem.
fn one(problem: &str, seed: u64) -> (Scene, Vec<f64>) {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == problem).unwrap();
    let variant = Maker::new(problem, seed, "ladder").variant("0").unwrap();
    (problem.cases[variant.case].scene.clone(), variant.data)
}

#[test]
fn auto_starts_no_integrator_where_a_closed_form_exists() {
    for (name, scene, data) in drawn(3) {
        for rtol in [None, Some(1e-12), Some(1e-3), Some(0.5)] {
            let wish = Wish { method: None, rtol, step_s: None };
            let (_, taken) = ladder::solve(&scene, &data, &wish).unwrap();
            assert!(taken.chosen && taken.count.steps == 0, "{name}");
            if matches!(taken.force, Force::Irregular | Force::Joined) {
                // No closed form for the time: its integral, never steps.
                assert_eq!(taken.rung.method(), Method::Gauss, "{name}");
                assert!(taken.worst <= rtol.unwrap_or(1e-12), "{name}: {rtol:?} {}", taken.worst);
            } else {
                // Doubles where they are good enough, and never more than asked.
                assert_eq!((taken.rung.method(), taken.count.evaluations), (Method::Closed, 1), "{name}");
                assert!(taken.errors.is_empty() == (taken.rung == Rung::Closed));
                assert!(taken.worst <= rtol.unwrap_or(0.0), "{name}");
                assert!(
                    taken.rung == if rtol.is_some_and(|r| r > 1e-4) { Rung::Doubles } else { taken.rung }
                );
            }
        }
    }
}

#[test]
fn a_tolerance_takes_as_few_points_as_it_needs() {
    let (scene, data) = one("spring-released", 1);
    let wish = Wish { method: Some(Method::Gauss), rtol: Some(1e-9), step_s: None };
    let (_, taken) = ladder::solve(&scene, &data, &wish).unwrap();
    // The work of a linear force is exact with one point.
    assert_eq!(taken.rung, Rung::Gauss(1));
    assert!(taken.worst < 1e-12, "{}", taken.worst);
}

#[test]
fn global_errors_fall_with_the_order_of_the_method() {
    let (scene, data) = one("spring-released", 1);
    let label = Label { quantity: Quantity::T, of: Owner::Scene };
    let reference = eom::road::<Dd>(&scene, &data).unwrap().get(label).unwrap().value;
    let error = |method: Method, step: f64| {
        let value = ladder::once(&scene, &data, Rung::Fixed(method, step), &[label]).unwrap()[0];
        (Dd::new(value) - reference).abs().hi
    };
    for (method, order, step) in
        [(Method::Euler, 1.0, 0.01), (Method::Verlet, 2.0, 0.02), (Method::Rk4, 4.0, 0.04)]
    {
        // The last step is shorter than the others by chance: the slope over a factor of 8 smooths that.
        let slope = (error(method, step) / error(method, step / 8.0)).log2() / 3.0;
        assert!((slope - order).abs() < 0.35, "{method:?}: {slope}");
    }
}

#[test]
fn what_a_method_cannot_do_it_refuses_with_numbers() {
    let wish = |method, step_s| Wish { method: Some(method), rtol: None, step_s: Some(step_s) };
    // Euler at a step so long that the turning point comes before the end.
    let (scene, data) = one("spring-released", 1);
    let end = scene.ending_coordinate();
    let time = ladder::solve(&scene, &data, &Wish::default()).unwrap().0.get(TIME).unwrap().value();
    let refusal = ladder::solve(&scene, &data, &wish(Method::Verlet, 40.0 * time)).unwrap_err();
    assert!(
        matches!(refusal, Refusal::Unsteady { .. } | Refusal::Contradicts { .. } | Refusal::Trouble { .. }),
        "{refusal:?}"
    );
    // Just short of the turning point a coarse step misses the place.
    let turn = Label { quantity: Quantity::DTurn, of: Owner::Body(end.body) };
    let far = ladder::solve(&scene, &data, &Wish::default()).unwrap().0.get(turn).unwrap().value();
    let near = Scene { end: End::Travel(end, Num::Fixed(far * (1.0 - 1e-7))), ..scene.clone() };
    let refusal = ladder::solve(&near, &data, &wish(Method::Verlet, 0.1 * time)).unwrap_err();
    match refusal {
        Refusal::Trouble { method: Method::Verlet, trouble: Trouble::Missed { by, at } } => {
            assert!(by > 0.0 && by < 0.1 * far && at > time, "{by} {at}");
        }
        Refusal::Unsteady { .. } | Refusal::Contradicts { .. } => {}
        other => panic!("{other:?}"),
    }
    // Such steps would take for ever.
    let refusal = ladder::solve(&scene, &data, &wish(Method::Euler, 1e-300)).unwrap_err();
    assert!(matches!(refusal, Refusal::Trouble { trouble: Trouble::StepTooShort { .. }, .. }), "{refusal:?}");
    // Nothing to step through.
    let (scene, data) = one("kinetic-energy", 1);
    let refusal = ladder::solve(&scene, &data, &wish(Method::Rk4, 1e-3)).unwrap_err();
    assert_eq!(refusal, Refusal::NoMethod { method: Method::Rk4 });
}

#[test]
fn a_study_has_every_method_and_its_front() {
    let (scene, data) = one("spring-released", 1);
    let labels = [Quantity::V, Quantity::VMax].map(|q| Label { quantity: q, of: Owner::Body(0) });
    let study = ladder::study(&scene, &data, &labels).unwrap();
    for method in Method::ALL.iter().copied() {
        let rows: Vec<_> = study.rows.iter().filter(|r| r.rung.method() == method).collect();
        assert!(rows.len() >= if method == Method::Closed { 1 } else { 4 }, "{method:?}");
        let worst: Vec<f64> = rows.iter().map(|r| r.found.as_ref().unwrap().worst).collect();
        // Finer is better, until rounding.
        let (first, last) = (worst[0], worst[worst.len() - 1]);
        assert!(last <= first.max(1e-14), "{method:?}: {worst:?}");
    }
    assert_eq!(study.rows.iter().filter(|r| r.auto).count(), 1);
    let closed = study.rows.iter().find(|r| r.auto).unwrap();
    assert!(closed.rung == Rung::Closed && closed.found.as_ref().unwrap().worst <= 1.2e-16);
    let front = ladder::pareto(&[(1.0, 0.1), (2.0, 0.1), (2.0, 0.01), (3.0, f64::NAN), (0.5, 1.0)], 0.0);
    assert_eq!(front, [true, false, true, false, true]);
    // Within the slack of a clock costs are equal.
    assert_eq!(ladder::pareto(&[(1.0, 0.1), (1.05, 0.01)], 0.1), [false, true]);
}

#[test]
fn every_method_gives_every_asked_answer_of_every_bank() {
    for bank in &support::banks() {
        for problem in bank.problems.iter().filter(|p| !matches!(p.cases[0].scene.end, End::AtOnce)) {
            for seed in 0..3 {
                let variant = Maker::new(problem, seed, "ladder").variant("0").unwrap();
                let scene = &problem.cases[variant.case].scene;
                let labels: Vec<Label> =
                    problem.questions.iter().map(|q| q.label).filter(|l| !l.quantity.is_word()).collect();
                let study = ladder::study(scene, &variant.data, &labels).unwrap();
                for row in study.rows {
                    let found =
                        row.found.unwrap_or_else(|e| panic!("{} {seed} {:?}: {e:?}", problem.id, row.rung));
                    assert!(found.worst.is_finite(), "{} {seed} {:?}: {found:?}", problem.id, row.rung);
                    if matches!(row.rung, Rung::Closed | Rung::Settled | Rung::Doubles) {
                        assert!(found.worst < 2e-14, "{} {seed} {:?}: {found:?}", problem.id, row.rung);
                    }
                }
            }
        }
    }
}

#[test]
fn a_quadrature_delivers_at_a_turning_point_or_refuses() {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == "compound-pendulum").unwrap();
    let mut scene = problem.cases[0].scene.clone();
    let variant = Maker::new(problem, 1, "ladder").variant("0").unwrap();
    let end = scene.ending_coordinate();
    scene.end = End::TurningPoint(end);
    let (mut solved, mut refused) = (0, 0);
    for speed in [0.3, 1.0, 3.0] {
        scene.start = vec![Start::Speed(end, Num::Fixed(speed))];
        let Ok(reference) = eom::road::<Dd>(&scene, &variant.data) else { continue };
        let Some(time) = reference.get(TIME) else { continue };
        for rtol in [None, Some(1e-12), Some(1e-6)] {
            let wish = Wish { method: Some(Method::Gauss), rtol, step_s: None };
            match ladder::solve(&scene, &variant.data, &wish) {
                Ok((found, _)) => {
                    let value = found.get(TIME).unwrap().energy.unwrap();
                    let miss = ((Dd::new(value) - time.value).abs() / time.value.abs()).hi;
                    assert!(miss <= rtol.unwrap_or(1e-12), "{speed} {rtol:?}: {miss:e}");
                    solved += 1;
                }
                Err(refusal) => {
                    refused += 1;
                    assert!(
                        matches!(refusal, Refusal::Unmet { .. } | Refusal::Unsteady { .. }),
                        "{refusal:?}"
                    );
                }
            }
        }
    }
    assert!(solved + refused > 0, "{solved} {refused}");
}

#[test]
fn the_finer_runs_count_before_any_is_made() {
    let (mut scene, data) = one("spring-released", 1);
    let end = scene.ending_coordinate();
    let time = ladder::solve(&scene, &data, &Wish::default()).unwrap().0.get(TIME).unwrap().value();
    scene.end = End::Time(end, Num::Fixed(0.5 * time));
    let wish = Wish { method: Some(Method::Rk4), rtol: None, step_s: Some(0.5 * time / 1e7) };
    let refusal = ladder::solve(&scene, &data, &wish).unwrap_err();
    assert!(matches!(refusal, Refusal::Trouble { trouble: Trouble::StepTooShort { .. }, .. }), "{refusal:?}");
}
