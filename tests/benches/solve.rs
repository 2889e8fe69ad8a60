//! Times of the solver alone; run with `cargo bench --bench solve`.
use slipstick::num::Dd;
use slipstick::scene::*;

fn main() {
    divan::main();
}

fn pulled(slip: bool) -> (Scene, Vec<f64>) {
    let d = Num::Datum;
    let along = Coordinate { body: 0, degree: Degree::Along };
    let contact = if slip {
        Tie::Slip { body: 0, radius_m: d(2), mu_s: d(8), mu_k: d(9) }
    } else {
        Tie::Roll { body: 0, radius_m: d(2), mu_s: Some(d(8)) }
    };
    let scene = Scene {
        gravity_m_s2: d(5),
        bodies: vec![Body {
            name: "wheel".into(),
            mass: Mass::Kilograms(d(0)),
            inertia: Some(RotaryInertia::Gyration(d(3))),
            radii_m: vec![("rim".into(), d(1)), ("hub".into(), d(2))],
            line: Some(Line { slope: Slope::Degrees(d(4)), forward_up: true, surface: true }),
            turns: true,
            ..Body::default()
        }],
        ties: vec![
            contact,
            Tie::Cord(Cord {
                name: "cord".into(),
                from: CordEnd {
                    body: 0,
                    attach: Attach::Wound(d(1), Side::Top),
                    forward: true,
                    upright: None,
                    tilt_deg: None,
                },
                to: Far::Pull(d(6)),
                made: Made::Cord,
            }),
        ],
        couples: vec![],
        joints: Vec::new(),
        restitution: None,
        pushes: Vec::new(),
        struts: Vec::new(),
        growths: vec![],
        carried: None,
        start: vec![],
        end: End::Travel(along, d(7)),
        heading: Some(Heading::Forward),
        span: Span::ToEnd,
        formulas: Formulas::default(),
    };
    let p = if slip { 400.0 } else { 200.0 };
    (scene, vec![40.0, 0.4, 0.2, 0.22, 25.0, 9.81, p, 1.0, if slip { 0.2 } else { 0.9 }, 0.15])
}

#[divan::bench(args = [false, true])]
fn both_roads_and_checks(b: divan::Bencher, slip: bool) {
    let (scene, data) = pulled(slip);
    b.bench(|| slipstick::solve::agree::solve(divan::black_box(&scene), divan::black_box(&data)));
}
#[divan::bench(args = [false, true])]
fn condition_numbers(b: divan::Bencher, slip: bool) {
    let (scene, data) = pulled(slip);
    let half = slipstick::solve::agree::first(&scene, &data, slipstick::solve::outcome::Scope::ALL)
        .expect("a wheel that is pulled");
    b.with_inputs(|| half.clone())
        .bench_values(|mut half| half.weigh(divan::black_box(&scene), &data, |_| true));
}
#[divan::bench(args = [false, true])]
fn eom_values(b: divan::Bencher, slip: bool) {
    let (scene, data) = pulled(slip);
    b.bench(|| slipstick::solve::eom::road::<Dd>(divan::black_box(&scene), divan::black_box(&data)));
}
#[divan::bench(args = [false, true])]
fn energy_values(b: divan::Bencher, slip: bool) {
    let (scene, data) = pulled(slip);
    b.bench(|| slipstick::solve::energy::road::<Dd>(divan::black_box(&scene), divan::black_box(&data)));
}
