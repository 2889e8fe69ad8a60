//! Swings far beyond homework against formulas written apart and computed with 700 bits: masses, arms and inertias over
//! tens of powers of ten, starts within 1e-12 degrees of upright and hanging, speeds around the separatrix, springs of any
//! strength; and every enclosure against the truth of data half an ulp away.

use crate::bare;
use crate::big::{Dice, F, abs, big, double};
use crate::support;
use slipstick::num::U;
use slipstick::scene::*;
use slipstick::solve::agree::{prove, solve};
use slipstick::solve::outcome::Solved;

/// Carlson's R_F by duplication and the first terms of its series.
fn rf(x: &F, y: &F, z: &F) -> F {
    let (mut x, mut y, mut z) = (x.clone(), y.clone(), z.clone());
    let three = big(3.0);
    loop {
        let mean = (&x + &y + &z) / &three;
        let parts = [&x, &y, &z].map(|v| (&mean - v) / &mean);
        if parts.iter().all(|p| abs(p) < big(1.0) >> 60) {
            // The next terms are of order 8: 2^-480.
            let [a, b, c] = parts;
            let e2 = &a * &b - &c * &c;
            let e3 = &a * &b * &c;
            let share = |over: f64, under: f64| big(over) / big(under);
            let sum =
                big(1.0) - &e2 * share(1.0, 10.0) + &e3 * share(1.0, 14.0) + &e2 * &e2 * share(1.0, 24.0)
                    - &e2 * &e3 * share(3.0, 44.0)
                    - &e2 * &e2 * &e2 * share(5.0, 208.0)
                    + &e3 * &e3 * share(3.0, 104.0)
                    + &e2 * &e2 * &e3 * share(1.0, 16.0);
            return sum / mean.sqrt();
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = &rx * &ry + &ry * &rz + &rz * &rx;
        (x, y, z) = ((x + &lambda) >> 2, (y + &lambda) >> 2, (z + &lambda) >> 2);
    }
}

/// What swings: data m h k g phi0 phi1 and the spin at the start, or a spring's at x y ks l0.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Free,
    Thrown,
    Sprung,
}

type Answers = Vec<(&'static str, F)>;

fn truth(kind: Kind, from: Ray, v: &[F]) -> Option<Answers> {
    let [m, h, k, g, phi0, phi1] = [0, 1, 2, 3, 4, 5].map(|i| v[i].clone());
    let two = big(2.0);
    // From hanging, growing in the same sense.
    let half = |phi: &F| {
        let psi = if from == Ray::Up { phi - big(180.0) } else { phi.clone() };
        (psi / &two).sin_cos_unit(360)
    };
    let ((s0, c0), (s1, c1)) = (half(&phi0), half(&phi1));
    let (sine, cosine) = (&two * &s1 * &c1, &c1 * &c1 - &s1 * &s1);
    let inertia = &m * (&k * &k + &h * &h);
    let fallen = &two * &m * &g * &h * (&s0 * &s0 - &s1 * &s1);
    let mut moment = -(&m * &g * &h * &sine);
    // Forces on the mass centre, outward and across, but the pin's.
    let (mut outward, mut across) = (&m * &g * &cosine, -(&m * &g * &sine));
    let mut gained = fallen;
    let mut out: Answers = vec![("I_O", inertia.clone())];
    if kind == Kind::Sprung {
        let [b, x, y, ks, l0] = [6, 7, 8, 9, 10].map(|i| v[i].clone());
        // The point of the body by its own sine and cosine; x to the side of small positive angles.
        let at = |s: &F, c: &F| {
            let (sine, cosine) = (&two * s * c, c * c - s * s);
            // From hanging a growing angle goes to +x; from upright the same sense there goes to -x.
            let side = if from == Ray::Up { -sine } else { sine };
            let (dx, dy) = (&x - &b * &side, &y + &b * &cosine);
            let length = (&dx * &dx + &dy * &dy).sqrt();
            (dx, dy, length)
        };
        let (_, _, first) = at(&s0, &c0);
        let (dx, dy, last) = at(&s1, &c1);
        let (x0, x1) = (&first - &l0, &last - &l0);
        gained += &ks * (&x0 * &x0 - &x1 * &x1) / &two;
        let force = &ks * &x1;
        let mirror = if from == Ray::Up { big(-1.0) } else { big(1.0) };
        let (ex, ey) = (&mirror * &sine, -cosine.clone());
        let (tx, ty) = (&mirror * &cosine, sine.clone());
        let (fx, fy) = (&force * &dx / &last, &force * &dy / &last);
        moment += &b * (&fx * &tx + &fy * &ty);
        outward += &fx * &ex + &fy * &ey;
        across += &fx * &tx + &fy * &ty;
        out.push(("spring_force", force));
    }
    let spin = if kind == Kind::Thrown { v[6].clone() } else { F::ZERO };
    let square = &spin * &spin + &two * &gained / &inertia;
    if square <= F::ZERO {
        return None;
    }
    let alpha = &moment / &inertia;
    let (radial, tangential) = (&m * &h * &square + outward, &m * &h * &alpha - across);
    out.push(("omega", square.sqrt()));
    out.push(("alpha", alpha));
    out.push(("pin_force", (&radial * &radial + &tangential * &tangential).sqrt()));
    out.push(("pin_radial", radial));
    out.push(("pin_tangential", tangential));
    if kind != Kind::Sprung {
        let ws2 = &m * &g * &h / &inertia;
        let ws = ws2.sqrt();
        let k2 = &s0 * &s0 + &spin * &spin / (big(4.0) * &ws2);
        let one = big(1.0);
        out.push(("omega_max", &two * &ws * k2.sqrt()));
        let rest = &one - &k2;
        if rest > F::ZERO {
            out.push(("period", big(4.0) * rf(&F::ZERO, &rest, &one) / &ws));
        } else if rest < F::ZERO {
            out.push(("period", &two * rf(&F::ZERO, &(-rest), &k2) / &ws));
        }
        // Integrals from the lowest place.
        let from_low = |s: &F, c: &F, p2: &F| s * rf(p2, &(&k2 * c * c), &k2);
        let (p0, p1) = (&spin * &spin / (big(4.0) * &ws2), &square / (big(4.0) * &ws2));
        let (u0, u1) = (from_low(&s0, &c0, &p0), from_low(&s1, &c1, &p1));
        out.push(("t", abs(&(u1 - u0)) / &ws));
    }
    Some(out)
}

fn scene(kind: Kind, from: Ray) -> Scene {
    let d = Num::Datum;
    let turn = Coordinate { body: 0, degree: Degree::Turn };
    let planar = Planar::pinned(Place::At(d(1)), from, Some(d(4)));
    let body = bare::turning(d(0), RotaryInertia::Gyration(d(2)));
    let mut scene = bare::pinned(d(3), body, planar, End::Angle(turn, d(5)));
    match kind {
        Kind::Sprung => {
            let law = (d(9), Rest::Length(d(10)));
            scene.struts.extend(scene.bodies[0].spring(0, d(6), [d(7), d(8)], law));
        }
        Kind::Thrown => scene.start = vec![Start::Speed(turn, d(6))],
        _ => {}
    }
    scene
}

fn draw(dice: &mut Dice, kind: Kind, from: Ray) -> Vec<f64> {
    let (m, h) = (dice.log(-30.0, 30.0), dice.log(-12.0, 12.0));
    let k = h * dice.log(-6.0, 6.0);
    let top: f64 = if from == Ray::Up { 0.0 } else { 180.0 };
    let bottom: f64 = 180.0 - top;
    let side = if dice.pick(2) == 0 { 1.0 } else { -1.0 };
    let phi0 = match dice.pick(4) {
        0 => top - (top - bottom).signum() * dice.log(-12.0, 0.0),
        1 => bottom + (top - bottom).signum() * dice.log(-12.0, 0.0),
        _ => 180.0 * dice.unit(),
    };
    let phi1 = match dice.pick(4) {
        0 => phi0 + (bottom - phi0) * dice.log(-12.0, 0.0),
        1 => bottom,
        2 if from == Ray::Down => -phi0 * dice.unit(),
        _ => phi0 + (bottom - phi0) * dice.unit(),
    };
    let g = 9.81;
    let mut data = vec![m, h, k, g, side * phi0, side * phi1];
    match kind {
        Kind::Free => {}
        Kind::Thrown => {
            let over = 2.0 * (g * h / (h * h + k * k)).sqrt();
            let near = dice.log(-14.0, -0.5);
            let spin = match dice.pick(3) {
                0 => over * (1.0 + near),
                1 => over * (1.0 - near),
                _ => over * dice.log(-6.0, 6.0),
            };
            data.push(if side * (phi1 - phi0) < 0.0 { -spin } else { spin });
        }
        Kind::Sprung => {
            let b = h * dice.log(-2.0, 2.0);
            let place = |dice: &mut Dice| h * (4.0 * dice.unit() - 2.0);
            let (x, y) = (place(dice), place(dice));
            let ks = m * g / h * dice.log(-6.0, 2.0);
            data.extend([b, x, y, ks, h * 3.0 * dice.unit()]);
        }
    }
    data
}

/// `sum |d ln y / d ln x_i|` by differences of the formulas themselves, 2^-200 apart.
fn conditions(kind: Kind, from: Ray, x: &[F], y: &Answers) -> Vec<f64> {
    let step = big(1.0) >> 200;
    let mut sums = vec![F::ZERO; y.len()];
    for i in (0..x.len()).filter(|i| x[*i] != F::ZERO) {
        let mut moved = x.to_vec();
        moved[i] = &x[i] * (big(1.0) - &step);
        let Some(z) = truth(kind, from, &moved) else { continue };
        for (sum, (name, old)) in sums.iter_mut().zip(y) {
            if let (Some((_, new)), true) = (z.iter().find(|(n, _)| n == name), *old != F::ZERO) {
                *sum = &*sum + abs(&(new - old)) / abs(old) / &step;
            }
        }
    }
    sums.iter().map(double).collect()
}

fn entry<'s>(solved: &'s Solved, name: &str) -> Option<&'s slipstick::solve::outcome::Entry> {
    let quantity = Quantity::from_name(name).unwrap();
    solved.entries.iter().find(|e| e.label.quantity == quantity)
}

#[test]
fn swings_of_any_size_meet_the_bar() {
    let mut dice = Dice::new(11);
    let mut bad = Vec::new();
    for (kind, scenes) in [(Kind::Free, 250), (Kind::Thrown, 250), (Kind::Sprung, 180)] {
        let (mut count, mut worst, mut reached) = (0, 0.0f64, 0);
        for i in 0..scenes {
            let from = if i % 2 == 0 { Ray::Up } else { Ray::Down };
            let data = draw(&mut dice, kind, from);
            let scene = scene(kind, from);
            let solved = match solve(&scene, &data) {
                Ok(solved) => solved,
                Err(e) => {
                    bad.push(format!("{kind:?} {from:?} {data:?}: {e:?}"));
                    continue;
                }
            };
            // Where the end is the start, nothing moves.
            if solved.regime.word() != "swings ok" || data[4] == data[5] {
                continue;
            }
            reached += 1;
            let x: Vec<F> = data.iter().map(|v| big(*v)).collect();
            let Some(answers) = truth(kind, from, &x) else {
                bad.push(format!("{kind:?} {from:?} {data:?}: is not reached"));
                continue;
            };
            let conds = conditions(kind, from, &x, &answers);
            for ((name, want), cond) in answers.iter().zip(conds) {
                let Some(entry) = entry(&solved, name) else {
                    // A number that no double holds is not published.
                    let size = double(&abs(want));
                    if solved.beyond.is_empty() || (1e-300..1e300).contains(&size) {
                        bad.push(format!("{kind:?} {data:?}: no {name}"));
                    }
                    continue;
                };
                for (road, got) in [("eom", entry.eom.unwrap()), ("energy", entry.energy.unwrap())] {
                    count += 1;
                    if *want == F::ZERO && got == 0.0 {
                        continue;
                    }
                    let share = double(&(abs(&(big(got) - want)) / abs(want))) / U / cond.max(1.0);
                    if !(share <= 8.0) {
                        bad.push(format!(
                            "{kind:?} {from:?} {data:?}: {road} {name} {got:e} is not {:e}: {share:.1} u max(1, cond {cond:.1e})",
                            double(want)
                        ));
                    }
                    worst = worst.max(share);
                }
            }
        }
        println!("{kind:?}: {count} values of {reached} scenes, worst {worst:.2} u max(1, cond)");
        assert!(reached * 3 > scenes, "{kind:?}: only {reached} of {scenes} reach their end");
    }
    assert!(bad.is_empty(), "{}\n{}", bad.len(), bad[..bad.len().min(12)].join("\n"));
}

/// The printed datum is a decimal within half an ulp of its double: all of them moved at once stay inside the enclosure.
#[test]
fn enclosures_of_swings_hold_the_truth() {
    let mut dice = Dice::new(3);
    let (mut held, mut proved, scenes) = (0, 0, 4 * support::seeds(100) as usize);
    for i in 0..scenes {
        let kind = [Kind::Free, Kind::Thrown, Kind::Sprung][i % 3];
        let from = if i % 2 == 0 { Ray::Up } else { Ray::Down };
        let mut data = draw(&mut dice, kind, from);
        // Sizes of homework: the radii of enclosures are absolute.
        let size = |x: f64| 10f64.powf(x.log10().rem_euclid(1.0));
        let h = data[1];
        for j in [1, 2, 6, 7, 8, 10] {
            if (j < 6 || kind == Kind::Sprung) && j < data.len() {
                data[j] /= h;
            }
        }
        if kind == Kind::Sprung {
            data[9] *= h / data[0];
        }
        if kind == Kind::Thrown {
            data[6] *= h.sqrt();
        }
        data[0] = size(data[0]);
        if kind == Kind::Sprung {
            data[9] *= data[0];
        }
        let scene = scene(kind, from);
        let Ok(mut solved) = solve(&scene, &data) else { continue };
        if solved.regime.word() != "swings ok" || !prove(&scene, &data, &mut solved) {
            continue;
        }
        proved += 1;
        for signs in 0..8u32 {
            let moved: Vec<F> = data
                .iter()
                .enumerate()
                .map(|(j, v)| {
                    let ulp = big(v.abs()) * big(U);
                    let turn = (signs >> (j % 3)) & 1 == 0;
                    if turn { big(*v) + ulp } else { big(*v) - ulp }
                })
                .collect();
            let Some(answers) = truth(kind, from, &moved) else { continue };
            for (name, want) in &answers {
                let Some(entry) = entry(&solved, name) else { continue };
                let Some(bound) = entry.bound else { continue };
                let miss = double(&abs(&(big(entry.value()) - want)));
                assert!(
                    miss <= bound,
                    "{kind:?} {from:?} {data:?}: {name} {:e} misses by {miss:e}, bound {bound:e}",
                    entry.value()
                );
                held += 1;
            }
        }
    }
    println!("{held} truths inside their enclosures, {proved} scenes");
    // A third of them or more reach their end and can be enclosed, with a dozen truths for each way to move the data.
    assert!(proved * 4 > scenes && held > 12 * scenes, "{proved} {held} of {scenes}");
}
