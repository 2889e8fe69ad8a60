//! A third witness: direct integration in time of the unreduced equations, in plain doubles, against the key.
//!
//! Nothing is shared with the solvers but the scene: positions and velocities of all coordinates are integrated by the
//! classical Runge-Kutta method, the reactions are found at each instant from the constraint equations (by Gaussian
//! elimination written here), the ending event is landed on by halving the step.
use crate::support;
use slipstick::problem::maker::Maker;
use slipstick::scene::*;
use slipstick::solve::agree;

/// A scene with its numbers, as this witness sees it.
struct Witness<'a> {
    scene: &'a Scene,
    data: &'a [f64],
    /// Friction force of each tie that slips (constant), else 0.
    kinetic: Vec<f64>,
    rolls: bool,
}

impl Witness<'_> {
    fn get(&self, n: Num) -> f64 {
        self.scene.value(n, self.data)
    }
    fn mass(&self, b: &Body) -> f64 {
        match &b.mass {
            Mass::Kilograms(m) => self.get(*m),
            Mass::Weight(w) => self.get(*w) / self.get(self.scene.gravity_m_s2),
            Mass::OfParts => match &b.inertia {
                Some(RotaryInertia::Parts(parts)) => parts.iter().map(|p| self.part(p)).sum(),
                // Of what turns about a fixed axle only a moment of inertia may be told; no mass of its moves.
                Some(RotaryInertia::Moment(_)) if b.line.is_none() => 0.0,
                _ => panic!("{}: a body of no parts", b.name),
            },
        }
    }
    fn part(&self, part: &Part) -> f64 {
        match &part.mass {
            Mass::Weight(w) => self.get(*w) / self.get(self.scene.gravity_m_s2),
            Mass::Kilograms(m) => self.get(*m),
            Mass::OfParts => panic!("a part of parts"),
        }
    }
    fn inertia(&self, b: &Body) -> f64 {
        let m = self.mass(b);
        match b.inertia.as_ref() {
            None => 0.0,
            Some(RotaryInertia::Gyration(k)) => m * self.get(*k) * self.get(*k),
            Some(RotaryInertia::Moment(i)) => self.get(*i),
            Some(RotaryInertia::Shape(s, r)) => beta(*s) * m * self.get(*r) * self.get(*r),
            Some(RotaryInertia::Parts(parts)) => parts
                .iter()
                .map(|p| beta(p.shape) * self.part(p) * self.get(p.radius_m) * self.get(p.radius_m))
                .sum(),
        }
    }
    /// Angle of the line, rad, from the horizontal; forward down is negative.
    fn angle(&self, b: &Body) -> f64 {
        let line = b.line.expect("a body with a line");
        let up = match line.slope {
            Slope::Level => 0.0,
            Slope::Vertical => std::f64::consts::FRAC_PI_2,
            Slope::Degrees(d) => self.get(d).to_radians(),
        };
        if line.forward_up { up } else { -up }
    }
    /// The sign of what is counted along the line of a body, where it is counted up the slope.
    fn upward(&self, b: usize) -> f64 {
        if self.scene.bodies[b].line.is_some_and(|l| !l.forward_up) { -1.0 } else { 1.0 }
    }
    fn normal(&self, b: usize) -> f64 {
        let body = &self.scene.bodies[b];
        self.mass(body) * self.get(self.scene.gravity_m_s2) * libm::cos(self.angle(body))
    }
    /// Jacobian of a cord's end (rate at which the end runs out along the cord) in (x, phi) of its body.
    fn run(&self, end: &CordEnd) -> (f64, f64) {
        let e = if end.forward { 1.0 } else { -1.0 };
        match end.attach {
            Attach::Centre => (e, 0.0),
            Attach::Wound(p, Side::Top) => (e, e * self.get(p)),
            Attach::Wound(p, Side::Bottom) => (e, -e * self.get(p)),
        }
    }
    /// Accelerations (x, phi of each body, in turn) and multipliers of the ties at a state.
    fn accelerate(&self, q: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = 2 * self.scene.bodies.len();
        let g = self.get(self.scene.gravity_m_s2);
        let mut mass = vec![1.0; n];
        let mut force = vec![0.0; n];
        let mut rows: Vec<Vec<f64>> = Vec::new();
        let mut owner: Vec<usize> = Vec::new();
        let mut row_of_tie = vec![usize::MAX; self.scene.ties.len()];
        for (b, body) in self.scene.bodies.iter().enumerate() {
            if body.line.is_some() {
                mass[2 * b] = self.mass(body);
                force[2 * b] = -self.mass(body) * g * libm::sin(self.angle(body));
            } else {
                let mut row = vec![0.0; n];
                row[2 * b] = 1.0;
                rows.push(row);
                owner.push(usize::MAX);
            }
            if body.turns {
                mass[2 * b + 1] = self.inertia(body);
            } else {
                let mut row = vec![0.0; n];
                row[2 * b + 1] = 1.0;
                rows.push(row);
                owner.push(usize::MAX);
            }
        }
        for c in &self.scene.couples {
            force[2 * c.body + 1] += if c.forward { 1.0 } else { -1.0 } * self.get(c.moment_n_m);
        }
        for (t, tie) in self.scene.ties.iter().enumerate() {
            let mut row = vec![0.0; n];
            match tie {
                Tie::Roll { body, radius_m, .. } => {
                    row[2 * body] = 1.0;
                    row[2 * body + 1] = -self.get(*radius_m);
                }
                Tie::Slip { body, radius_m, .. } => {
                    if self.rolls {
                        row[2 * body] = 1.0;
                        row[2 * body + 1] = -self.get(*radius_m);
                    } else {
                        force[2 * body] += self.kinetic[t];
                        force[2 * body + 1] -= self.kinetic[t] * self.get(*radius_m);
                        continue;
                    }
                }
                Tie::Slide { .. } => unimplemented!("no bank of the project slides a block"),
                Tie::Cord(cord) => {
                    let (cx, cp) = self.run(&cord.from);
                    let b = cord.from.body;
                    match &cord.to {
                        Far::Pull(p) => {
                            force[2 * b] += cx * self.get(*p);
                            force[2 * b + 1] += cp * self.get(*p);
                            continue;
                        }
                        Far::Spring { stiffness_n_m, stretch_m, rigid } => {
                            let stretch = self.get(*stretch_m) - cx * q[2 * b] - cp * q[2 * b + 1];
                            let stretch = if *rigid { stretch } else { stretch.max(0.0) };
                            let tension = self.get(*stiffness_n_m) * stretch;
                            force[2 * b] += cx * tension;
                            force[2 * b + 1] += cp * tension;
                            continue;
                        }
                        Far::Fixed => {
                            row[2 * b] = cx;
                            row[2 * b + 1] = cp;
                        }
                        Far::Body(other) => {
                            row[2 * b] += cx;
                            row[2 * b + 1] += cp;
                            let (ox, op) = self.run(other);
                            row[2 * other.body] += ox;
                            row[2 * other.body + 1] += op;
                        }
                    }
                }
            }
            row_of_tie[t] = rows.len();
            rows.push(row);
            owner.push(t);
        }
        // [M -G^T; G 0] [a; l] = [f; 0]
        let size = n + rows.len();
        let mut a = vec![vec![0.0; size + 1]; size];
        for i in 0..n {
            a[i][i] = mass[i];
            a[i][size] = force[i];
        }
        for (k, row) in rows.iter().enumerate() {
            for i in 0..n {
                a[i][n + k] = -row[i];
                a[n + k][i] = row[i];
            }
        }
        let x = gauss(a);
        let multipliers = row_of_tie.iter().map(|k| if *k == usize::MAX { 0.0 } else { x[n + k] }).collect();
        (x[..n].to_vec(), multipliers)
    }
    fn step(&self, q: &[f64], v: &[f64], h: f64) -> (Vec<f64>, Vec<f64>) {
        let add =
            |x: &[f64], k: &[f64], f: f64| -> Vec<f64> { x.iter().zip(k).map(|(x, k)| x + f * k).collect() };
        let a1 = self.accelerate(q).0;
        let (q2, v2) = (add(q, v, h / 2.0), add(v, &a1, h / 2.0));
        let a2 = self.accelerate(&q2).0;
        let (q3, v3) = (add(q, &v2, h / 2.0), add(v, &a2, h / 2.0));
        let a3 = self.accelerate(&q3).0;
        let (q4, v4) = (add(q, &v3, h), add(v, &a3, h));
        let a4 = self.accelerate(&q4).0;
        let mix = |a: &[f64], b: &[f64], c: &[f64], d: &[f64]| -> Vec<f64> {
            (0..a.len()).map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0).collect()
        };
        (add(q, &mix(v, &v2, &v3, &v4), h), add(v, &mix(&a1, &a2, &a3, &a4), h))
    }
}

/// Moment of inertia about the mass centre as a share of mass times size squared.
const fn beta(shape: Shape) -> f64 {
    match shape {
        Shape::Hoop => 1.0,
        Shape::Disc => 0.5,
        Shape::Sphere => 0.4,
        Shape::Shell => 2.0 / 3.0,
        Shape::Rod => 1.0 / 12.0,
    }
}

fn gauss(mut a: Vec<Vec<f64>>) -> Vec<f64> {
    let n = a.len();
    for c in 0..n {
        let p = (c..n).max_by(|i, j| a[*i][c].abs().total_cmp(&a[*j][c].abs())).expect("rows");
        a.swap(c, p);
        for r in c + 1..n {
            let f = a[r][c] / a[c][c];
            if f != 0.0 {
                let pivot = a[c].clone();
                for (x, p) in a[r].iter_mut().zip(&pivot).skip(c) {
                    *x -= f * p;
                }
            }
        }
    }
    let mut x = vec![0.0; n];
    for r in (0..n).rev() {
        let s: f64 = (r + 1..n).map(|k| a[r][k] * x[k]).sum();
        x[r] = (a[r][n] - s) / a[r][r];
    }
    x
}

/// Has this witness laws of motion for the scene? What is joined in the plane, save a body that its own pin holds, needs coordinates
/// of other bodies and has judges in full coordinates of its own (`joined`); a datum that is found from a measurement is not there to integrate with, and the
/// measurement itself judges it (`expressions`).
fn is_witnessed(scene: &Scene) -> bool {
    (scene.lead().is_none() || scene.pinned().is_some()) && scene.formulas.found.is_none()
}

/// Is a place, at a time, past the end?
type Past = Box<dyn Fn(&[f64], f64) -> bool>;

/// Does this stay as it is at the start while all forces are constant?
fn is_rate(quantity: Quantity) -> bool {
    [Quantity::A, Quantity::Alpha, Quantity::Friction, Quantity::Normal].contains(&quantity)
}

#[test]
fn integration_in_time_gives_the_key() {
    let banks = support::banks();
    let problems = banks.iter().flat_map(|b| &b.problems);
    let problems: Vec<_> = problems.filter(|p| p.cases.iter().all(|c| is_witnessed(&c.scene))).collect();
    assert!(problems.len() >= 19, "{}", problems.len());
    for problem in problems {
        let maker = Maker::new(problem, 3, "third witness");
        let (draws, mut compared) = (support::seeds(100), 0);
        for student in 0..draws {
            let variant =
                maker.variant(&student.to_string()).expect("a bank of the project can be satisfied");
            let mut scene = problem.cases[variant.case].scene.clone();
            // With the condition numbers of all quantities, not of those alone that are asked.
            let mut solved = agree::solve(&scene, &variant.data).expect("it was drawn");
            if matches!(scene.start[..], [Start::Lamina { .. }]) {
                compared += lamina(&scene, &variant.data, &solved);
                continue;
            }
            if matches!(scene.end, End::AtOnce) {
                // An instant is the start of a motion, which is watched for a while.
                let at_once = solved;
                scene.end = End::Time(scene.ending_coordinate(), Num::Fixed(0.5));
                solved = agree::solve(&scene, &variant.data).expect("it goes on");
                for e in at_once.entries.iter().filter(|e| is_rate(e.label.quantity)) {
                    let later = solved.get(e.label).expect("it is told of a motion, too").value();
                    assert!(
                        (e.value() - later).abs() <= 1e-15 * later.abs(),
                        "{}: {e:?} {later}",
                        problem.id
                    );
                    compared += 1;
                }
            }
            let scene = &scene;
            if matches!(scene.ties.as_slice(), [Tie::Slip { .. }]) && !scene.start.is_empty() {
                compared += thrown(scene, &variant.data, &solved, &problem.id);
                continue;
            }
            if scene.pinned().is_some() {
                compared += pinned(scene, &variant.data, &solved, &problem.id);
                continue;
            }
            let mut w =
                Witness { scene, data: &variant.data, kinetic: vec![0.0; scene.ties.len()], rolls: true };
            let n = 2 * scene.bodies.len();
            let rolled = w.accelerate(&vec![0.0; n]).1;
            for (t, tie) in scene.ties.iter().enumerate() {
                if let Tie::Slip { body, mu_k, .. } = tie {
                    w.kinetic[t] = rolled[t].signum() * w.get(*mu_k) * w.normal(*body);
                }
            }
            w.rolls = false;
            let (mut q, mut v, mut time) = (vec![0.0; n], vec![0.0; n], 0.0);
            let (whole, over): (f64, Past) = match scene.end {
                End::Travel(end, distance) => {
                    let place = 2 * end.body + usize::from(end.degree == Degree::Turn);
                    let (distance, a) = (w.get(distance), w.accelerate(&q).0[place].abs());
                    ((2.0 * distance / a).sqrt(), Box::new(move |q, _| q[place].abs() > distance))
                }
                End::Time(_, end) => {
                    let end = w.get(end);
                    (end, Box::new(move |_, time| time > end))
                }
                _ => panic!("{}: another event", problem.id),
            };
            let mut h = whole / 400.0;
            while h > 1e-12 {
                let (q2, v2) = w.step(&q, &v, h);
                if over(&q2, time + h) {
                    h /= 2.0;
                } else {
                    (q, v) = (q2, v2);
                    time += h;
                }
                assert!(time < 1e3, "{} {student}: never arrives", problem.id);
            }
            let (acc, reaction) = w.accelerate(&q);
            let mut seen = vec![("t".to_owned(), time)];
            let bare = scene.bare_body();
            for (b, body) in scene.bodies.iter().enumerate() {
                let name =
                    |q: &str| if bare == Some(b) { q.to_owned() } else { format!("{}.{q}", body.name) };
                if body.line.is_some() {
                    seen.push((name("v"), v[2 * b].abs()));
                    seen.push((name("a"), acc[2 * b]));
                }
                if body.turns {
                    seen.push((name("omega"), v[2 * b + 1].abs()));
                    seen.push((name("phi"), q[2 * b + 1].abs()));
                }
            }
            for (t, tie) in scene.ties.iter().enumerate() {
                match tie {
                    Tie::Roll { body, .. } => seen.push(("friction".into(), w.upward(*body) * reaction[t])),
                    Tie::Slip { body, radius_m, .. } => {
                        seen.push(("friction".into(), w.upward(*body) * w.kinetic[t]));
                        let slip = (q[2 * body] - w.get(*radius_m) * q[2 * body + 1]).abs();
                        seen.push(("slip_distance".into(), slip));
                        seen.push(("heat".into(), slip * w.kinetic[t].abs()));
                    }
                    Tie::Cord(c) => {
                        if matches!(c.to, Far::Body(_) | Far::Fixed) {
                            let label = Label { quantity: Quantity::Tension, of: Owner::Tie(t) };
                            seen.push((scene.name_of(label), reaction[t]));
                        }
                    }
                    Tie::Slide { .. } => {}
                }
            }
            for (name, got) in seen {
                let entry = solved.entries.iter().find(|e| scene.name_of(e.label) == name);
                let entry = entry.unwrap_or_else(|| panic!("{}: no {name}", problem.id));
                let want = entry.value();
                // The slack of a cord is a kink in the force: one step of the integration is only of first order.
                let size = want.abs().max(1e-3 * entry.scale);
                let off = (got - want).abs() / size / entry.cond.max(1.0);
                assert!(
                    off < 2e-6,
                    "{} {student}: {name} {got} by integration, {want} in the key",
                    problem.id
                );
                compared += 1;
            }
        }
        println!("{}: {compared} values", problem.id);
        assert!(compared >= 3 * draws as usize, "{}: {compared}", problem.id);
    }
}

/// A throw, by brute force: small steps in time, in each of them the friction that would stop the contact if the law of
/// friction has so much. Nobody says here when it begins to roll.
fn thrown(scene: &Scene, data: &[f64], solved: &slipstick::solve::outcome::Solved, problem: &str) -> usize {
    const STEPS: f64 = 40_000.0;
    let w = Witness { scene, data, kinetic: vec![0.0], rolls: false };
    let body = &scene.bodies[0];
    let (m, inertia, normal) = (w.mass(body), w.inertia(body), w.normal(0));
    let Tie::Slip { radius_m, mu_s, mu_k, .. } = &scene.ties[0] else { panic!("{problem}: no slip") };
    let (c, mu_s, mu_k) = (w.get(*radius_m), w.get(*mu_s), w.get(*mu_k));
    let weight = -w.get(scene.gravity_m_s2) * libm::sin(w.angle(body));
    let (mut v, mut spin) = (0.0, 0.0);
    for s in &scene.start {
        match s {
            Start::Speed(Coordinate { degree: Degree::Along, .. }, n) => v = w.get(*n),
            Start::Speed(_, n) => spin = w.get(*n),
            Start::Lamina { .. } => panic!("{problem}: a lamina"),
        }
    }
    let known = |q: Quantity| {
        let entry = solved.entries.iter().find(|e| e.label.quantity == q);
        entry.unwrap_or_else(|| panic!("{problem}: no {q:?}"))
    };
    let (last, h) = match scene.end {
        End::Time(_, t) => (w.get(t), w.get(t) / STEPS),
        _ => (f64::INFINITY, known(Quantity::T).value() / STEPS),
    };
    let (mut time, mut x, mut phi, mut slid, mut heat, mut friction) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let (mut sticks, mut acceleration) = (false, 0.0);
    let yields = 1.0 / m + c * c / inertia;
    while time < last - h / 2.0 {
        let slip = v - c * spin;
        let wanted = -(slip + h * weight) / yields;
        let most = h * normal * if sticks { mu_s } else { mu_k };
        let impulse = wanted.clamp(-most, most);
        sticks = impulse == wanted;
        if sticks && matches!(scene.end, End::Rolling(_)) {
            break;
        }
        let (next, turned) = (v + h * weight + impulse / m, spin - impulse * c / inertia);
        let way = h * (slip + next - c * turned) / 2.0;
        x += h * (v + next) / 2.0;
        phi += h * (spin + turned) / 2.0;
        slid += way.abs();
        heat += (impulse / h * way).abs();
        friction = impulse / h;
        acceleration = (next - v) / h;
        (v, spin) = (next, turned);
        time += h;
        assert!(time < 4.0 * STEPS * h, "{problem}: it never rolls");
    }
    let up = w.upward(0);
    for (quantity, got) in [
        (Quantity::T, time),
        (Quantity::V, v.abs()),
        (Quantity::Omega, spin.abs()),
        (Quantity::A, acceleration),
        (Quantity::Friction, friction * up),
        (Quantity::Displacement, x),
        (Quantity::Phi, phi.abs()),
        (Quantity::SlipDistance, slid),
        (Quantity::Heat, heat),
        (Quantity::KineticEnergy, (m * v * v + inertia * spin * spin) / 2.0),
    ] {
        let entry = known(quantity);
        let off = (got - entry.value()).abs() / entry.value().abs() / entry.cond.max(1.0);
        assert!(off < 1e-4, "{problem}: {quantity:?} {got} by small steps, {} in the key", entry.value());
    }
    let direction = solved.words.iter().find(|(l, _)| l.quantity == Quantity::Direction).unwrap().1.as_str();
    assert_eq!(["up", "forward"].contains(&direction), v * up > 0.0, "{problem}: {direction}");
    11
}

/// A pinned body: mass centre in x and y and the angle, integrated together; the two components of the pin's force are
/// found at each instant from the condition that its point of the body stays. Nothing knows that the body only turns.
fn pinned(scene: &Scene, data: &[f64], solved: &slipstick::solve::outcome::Solved, problem: &str) -> usize {
    let w = Witness { scene, data, kinetic: Vec::new(), rolls: true };
    let (owner, pin) = scene.pinned().unwrap();
    let body = &scene.bodies[owner];
    let (m, inertia, g) = (w.mass(body), w.inertia(body), w.get(scene.gravity_m_s2));
    let h = match pin.centre {
        Place::At(h) => w.get(h),
        Place::HalfOf(l) => w.get(l) / 2.0,
    };
    let up = if pin.from == Ray::Up { 1.0 } else { -1.0 };
    // Its spring: where on the axis it acts, and the place of its anchor.
    let spring = scene.struts.first().map(|s| {
        let (Place::At(at), StrutEnd::Ground(anchor)) = (pin.points[s.at.point].1[0], s.to) else { panic!() };
        (s, w.get(at), anchor.map(|x| w.get(x)))
    });
    // The unit vector from the pin to the mass centre, and its derivative by the angle.
    let out = |angle: f64| (libm::sin(angle), up * libm::cos(angle));
    let along = |angle: f64| (libm::cos(angle), -up * libm::sin(angle));
    let couple: f64 =
        scene.couples.iter().map(|c| w.get(c.moment_n_m) * if c.forward { 1.0 } else { -1.0 }).sum();
    let start = w.get(pin.start_deg.unwrap()).to_radians();
    let natural = spring.map(|(s, at, [x_m, y_m])| match s.rest {
        Rest::Length(l) => w.get(l),
        Rest::Stretch(x) => {
            let (ex, ey) = out(start);
            libm::hypot(x_m - at * ex, y_m - at * ey) - w.get(x)
        }
    });
    // Accelerations of x, y and the angle, the pin's force, and the spring's force.
    let forces = |q: &[f64], v: &[f64]| {
        let (ex, ey) = out(q[2]);
        let (tx, ty) = along(q[2]);
        let (mut fx, mut fy, mut moment, mut pull) = (0.0, -m * g, couple, 0.0);
        if let (Some((s, at, [x_m, y_m])), Some(natural)) = (spring, natural) {
            // From the mass centre to the point of the body, and from there to the anchor.
            let reach = at - h;
            let (px, py) = (q[0] + reach * ex, q[1] + reach * ey);
            let (ax, ay) = (x_m - px, y_m - py);
            let length = libm::hypot(ax, ay);
            pull = w.get(s.stiffness_n_m) * (length - natural);
            let (sx, sy) = (pull * ax / length, pull * ay / length);
            fx += sx;
            fy += sy;
            moment += reach * (tx * sx + ty * sy);
        }
        // Unknowns: ax, ay, alpha, Px, Py. The pin stays: a - h (alpha t - omega^2 e) = 0.
        let square = v[2] * v[2];
        let x = gauss(vec![
            vec![m, 0.0, 0.0, -1.0, 0.0, fx],
            vec![0.0, m, 0.0, 0.0, -1.0, fy],
            vec![0.0, 0.0, inertia, h * tx, h * ty, moment],
            vec![1.0, 0.0, -h * tx, 0.0, 0.0, -h * square * ex],
            vec![0.0, 1.0, -h * ty, 0.0, 0.0, -h * square * ey],
        ]);
        (x, pull)
    };
    let step = |q: &[f64], v: &[f64], t: f64| -> (Vec<f64>, Vec<f64>) {
        let add =
            |x: &[f64], k: &[f64], f: f64| -> Vec<f64> { x.iter().zip(k).map(|(x, k)| x + f * k).collect() };
        let rate = |q: &[f64], v: &[f64]| forces(q, v).0[..3].to_vec();
        let a1 = rate(q, v);
        let (q2, v2) = (add(q, v, t / 2.0), add(v, &a1, t / 2.0));
        let a2 = rate(&q2, &v2);
        let (q3, v3) = (add(q, &v2, t / 2.0), add(v, &a2, t / 2.0));
        let a3 = rate(&q3, &v3);
        let (q4, v4) = (add(q, &v3, t), add(v, &a3, t));
        let a4 = rate(&q4, &v4);
        let mix = |a: &[f64], b: &[f64], c: &[f64], d: &[f64]| -> Vec<f64> {
            (0..3).map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0).collect()
        };
        (add(q, &mix(v, &v2, &v3, &v4), t), add(v, &mix(&a1, &a2, &a3, &a4), t))
    };
    // Up to what `there` does not allow any more, which is landed on by halving the step.
    let run = |there: &dyn Fn(&[f64], &[f64]) -> bool| {
        let (ex, ey) = out(start);
        let (mut q, mut v, mut time) = (vec![h * ex, h * ey, start], vec![0.0; 3], 0.0);
        let mut t = (inertia / m + h * h).sqrt() / (g * h).sqrt() / 500.0;
        while t > 1e-13 {
            let (q2, v2) = step(&q, &v, t);
            if there(&q2, &v2) {
                t /= 2.0;
            } else {
                (q, v) = (q2, v2);
                time += t;
            }
            assert!(time < 1e3, "{problem}: never arrives");
        }
        (q, v, time)
    };
    let End::Angle(_, end) = scene.end else { panic!("{problem}: another event") };
    let end = w.get(end).to_radians();
    let (q, v, time) = run(&|q, _| if end > start { q[2] > end } else { q[2] < end });
    let (x, pull) = forces(&q, &v);
    let (ex, ey) = out(q[2]);
    let (tx, ty) = along(q[2]);
    let mut seen = vec![
        ("t", time),
        ("omega", v[2].abs()),
        ("v", libm::hypot(v[0], v[1])),
        ("alpha", x[2]),
        ("phi", (q[2] - start).abs()),
        ("pin_radial", -(x[3] * ex + x[4] * ey)),
        ("pin_tangential", x[3] * tx + x[4] * ty),
        ("pin_force", libm::hypot(x[3], x[4])),
        ("rise", q[1] - h * out(start).1),
        ("kinetic_energy", 0.5 * (m * (v[0] * v[0] + v[1] * v[1]) + inertia * v[2] * v[2])),
    ];
    if spring.is_some() {
        seen.push(("spring_force", pull));
    }
    if scene.is_pendulum() {
        // Released at rest, it is at rest again after half a period.
        let (_, _, half) = run(&|_, v| v[2] * (end - start).signum() < 0.0);
        seen.push(("period", 2.0 * half));
    }
    for (name, got) in &seen {
        let entry = solved.entries.iter().find(|e| scene.name_of(e.label) == *name);
        let entry = entry.unwrap_or_else(|| panic!("{problem}: no {name}"));
        let want = entry.value();
        let off = (got - want).abs() / want.abs().max(1e-3 * entry.scale) / entry.cond.max(1.0);
        assert!(off < 1e-8, "{problem}: {name} {got} by integration, {want} in the key");
    }
    seen.len()
}

/// A lamina: the kinetic energy as the mean of 1/2 m |dr/dt|^2 with the velocities by finite rotation.
fn lamina(scene: &Scene, data: &[f64], solved: &slipstick::solve::outcome::Solved) -> usize {
    let get = |n: Num| scene.value(n, data);
    let Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s } = scene.start[0] else {
        panic!("no lamina")
    };
    let ps = &scene.bodies[body].particles;
    let (vx, vy, w) = (get(vx_m_s), get(vy_m_s), get(spin_rad_s));
    let (xa, ya) = (get(ps[particle].x_m), get(ps[particle].y_m));
    let h = 1e-5;
    let place = |x: f64, y: f64, t: f64| {
        let (s, c) = (libm::sin(w * t), libm::cos(w * t));
        (xa + vx * t + c * (x - xa) - s * (y - ya), ya + vy * t + s * (x - xa) + c * (y - ya))
    };
    let mut energy = 0.0;
    for p in ps {
        let (x, y) = (get(p.x_m), get(p.y_m));
        let ((x1, y1), (x0, y0)) = (place(x, y, h), place(x, y, -h));
        energy += 0.5 * get(p.mass_kg) * ((x1 - x0).powi(2) + (y1 - y0).powi(2)) / (2.0 * h).powi(2);
    }
    let entry = solved.entries.iter().find(|e| e.label.quantity == Quantity::KineticEnergy).expect("T");
    assert!((energy / entry.value() - 1.0).abs() < 1e-7, "{energy} {}", entry.value());
    3
}
