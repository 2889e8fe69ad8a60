//! How far the conditions look: a witness of its own for scenes on a spring, integrated in time with friction and tension sampled
//! all the way.
//!
//! Both roads looked from release to the turning point whatever end was asked, for both had it from the same sentence, so their
//! agreement could not tell; and the reference cases and the banks all ask for the greatest speed, where that is right.
use crate::support::{self, program::run_with};
use slipstick::bank::{Problem, load};
use slipstick::cli::tell::Exit;
use slipstick::scene::{Quantity, Span};
use slipstick::solve::agree::solve;
use slipstick::solve::outcome::{CheckKind, Solved};
use std::f64::consts::PI;

const G: f64 = 9.81;

/// A stream of numbers from 0 to 1.
struct Lots(u64);

impl Lots {
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    /// With four decimals, as a bank writes it.
    fn within(&mut self, low: f64, high: f64) -> f64 {
        ((low + (high - low) * self.share()) * 1e4).round() / 1e4
    }
    fn coin(&mut self) -> bool {
        self.share() < 0.5
    }
}

/// What ends a motion.
#[derive(Debug, Clone, Copy)]
enum End {
    Travel(f64),
    Time(f64),
    Speed(f64),
    Turn,
}

/// A wheel that rolls on its rim, a spring on a cord, a couple, and perhaps a cart drawn behind the wheel.
#[derive(Debug, Clone, Copy)]
struct Wheel {
    m: f64,
    rim: f64,
    k: f64,
    slope: f64,
    ks: f64,
    x0: f64,
    rigid: bool,
    /// Lever of the spring's cord: above the centre, below it, or 0.
    lever: f64,
    forward: bool,
    couple: f64,
    cart: Option<f64>,
    v0: f64,
    end: End,
    /// Is the greatest speed asked, too?
    whole: bool,
}

/// What the witness sees.
#[derive(Debug, Clone, Copy)]
struct Seen {
    most_friction: f64,
    least_tension: f64,
    reached: bool,
}

impl Wheel {
    fn draw(lots: &mut Lots) -> Self {
        let rim = lots.within(0.2, 0.4);
        let hub = lots.within(0.05, 0.19);
        let kind = lots.share();
        let v0 = if lots.coin() { 0.0 } else { lots.within(0.3, 2.0) * if lots.coin() { 1.0 } else { -1.0 } };
        let end = match lots.share() {
            s if s < 0.4 => End::Travel(lots.within(0.05, 1.5)),
            s if s < 0.6 => End::Time(lots.within(0.05, 1.0)),
            s if s < 0.8 => End::Speed(lots.within(0.1, 3.0)),
            _ => End::Turn,
        };
        Self {
            m: lots.within(5.0, 40.0),
            rim,
            k: lots.within(0.05, 0.45),
            slope: if lots.share() < 0.2 { 0.0 } else { lots.within(2.0, 45.0) },
            ks: lots.within(50.0, 800.0),
            x0: if lots.share() < 0.3 { 0.0 } else { lots.within(0.01, 0.6) },
            rigid: lots.coin(),
            lever: if kind < 0.3 {
                0.0
            } else if kind < 0.65 {
                hub
            } else {
                -hub
            },
            forward: lots.coin(),
            couple: if lots.coin() { 0.0 } else { lots.within(-60.0, 60.0) },
            cart: lots.coin().then(|| lots.within(1.0, 20.0)),
            v0,
            end,
            whole: lots.coin(),
        }
    }

    fn bank(&self) -> String {
        let side = if self.lever > 0.0 { "top" } else { "bottom" };
        let way = if self.forward { "forward" } else { "back" };
        let from = if self.lever == 0.0 {
            format!("tied at: centre, leaves: {way}")
        } else {
            format!("wound on: hub, leaves: {side} {way}")
        };
        let attached = if self.rigid { "rigidly" } else { "by the cord" };
        let forces = match self.couple {
            0.0 => String::new(),
            c => format!(
                "      forces: [couple: {{on: wheel, moment: {} N m, sense: {}}}]\n",
                c.abs(),
                if c > 0.0 { "forward" } else { "back" }
            ),
        };
        let (body, cord) = match self.cart {
            None => (String::new(), String::new()),
            Some(m) => (
                format!("        cart: {{mass: {m} kg, moves: along ramp, positive: up}}\n"),
                "        - cord: {name: rope, from: {body: wheel, tied at: centre, leaves: back}, to: {body: cart, tied at: centre, leaves: forward}}\n".to_owned(),
            ),
        };
        let start = if self.v0 == 0.0 {
            "at rest".to_owned()
        } else {
            format!("{{wheel: {{speed: {} m/s}}}}", self.v0)
        };
        let end = match self.end {
            End::Travel(d) => format!("{{travel: {{of: wheel, by: {d} m}}}}"),
            End::Time(t) => format!("{{time: {{of: wheel, is: {t} s}}}}"),
            End::Speed(v) => format!("{{speed: {{of: wheel, reaches: {v} m/s}}}}"),
            End::Turn => "{turning point: wheel}".to_owned(),
        };
        let more = if self.whole { "      v_max: {quantity: wheel.v_max, ask: it}\n" } else { "" };
        let hub = if self.lever == 0.0 { 0.1 } else { self.lever.abs() };
        format!(
            "bank: range\ntitle: Range\nproblems:\n  one:\n    title: One\n    data:\n      m: {{name: m, unit: kg, draw: always {m}}}\n    \
             scene:\n      surfaces: {{ramp: {{slope: {slope} deg}}}}\n      bodies:\n        wheel: {{mass: m, radius of gyration: {k} m, \
             radii: {{rim: {rim} m, hub: {hub} m}}, moves: along ramp, positive: up}}\n{body}      ties:\n        - rolls: {{body: wheel, \
             on its: rim, mu_s: 9}}\n        - cord: {{name: spring, from: {{body: wheel, {from}}}, spring: {{stiffness: {ks} N/m, stretch: \
             {x0} m, attached: {attached}}}}}\n{cord}{forces}      start: {start}\n      end: {end}\n    questions:\n      mu: {{quantity: \
             wheel.mu_required, ask: it}}\n{more}",
            m = self.m,
            slope = self.slope,
            k = self.k,
            rim = self.rim,
            ks = self.ks,
            x0 = self.x0,
        )
    }

    /// Acceleration, friction and the cart's tension where the centre has moved by `x`.
    fn forces(&self, x: f64) -> [f64; 3] {
        let e = if self.forward { 1.0 } else { -1.0 };
        let ratio = 1.0 + self.lever / self.rim;
        let stretch = self.x0 - e * ratio * x;
        let pull = if stretch < 0.0 && !self.rigid { 0.0 } else { self.ks * stretch };
        let inertia = self.m * self.k * self.k;
        let cart = self.cart.unwrap_or(0.0);
        let sine = libm::sin(self.slope * PI / 180.0);
        let force = e * pull * ratio + self.couple / self.rim - (self.m + cart) * G * sine;
        let a = force / (self.m + cart + inertia / (self.rim * self.rim));
        let friction = (e * pull * self.lever + self.couple - inertia * a / self.rim) / self.rim;
        [a, friction, cart * (a + G * sine)]
    }

    /// Runs it, step by step, to its end, and on to where it turns if the whole motion counts.
    fn seen(&self) -> Seen {
        let (mut x, mut v, mut t) = (0.0f64, self.v0, 0.0f64);
        let first = self.forces(0.0);
        let sense = if v == 0.0 { first[0].signum() } else { v.signum() };
        let mut seen = Seen { most_friction: first[1].abs(), least_tension: first[2], reached: false };
        let rising = matches!(self.end, End::Speed(u) if u > self.v0.abs());
        // What is left to the end and to the turning point: above 0 before.
        let left = |x: f64, v: f64, t: f64| match self.end {
            End::Travel(d) => d - x.abs(),
            End::Time(at) => at - t,
            End::Speed(u) if rising => u - sense * v,
            End::Speed(u) => sense * v - u,
            End::Turn => sense * v,
        };
        let h = 1e-3;
        for step in 0..60_000 {
            let go = |h: f64| {
                let a = |x: f64| self.forces(x)[0];
                let (k1x, k1v) = (v, a(x));
                let (k2x, k2v) = (v + 0.5 * h * k1v, a(x + 0.5 * h * k1x));
                let (k3x, k3v) = (v + 0.5 * h * k2v, a(x + 0.5 * h * k2x));
                let (k4x, k4v) = (v + h * k3v, a(x + h * k3x));
                (
                    x + h / 6.0 * (k1x + 2.0 * k2x + 2.0 * k3x + k4x),
                    v + h / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v),
                    t + h,
                )
            };
            let turned = |s: (f64, f64, f64)| step > 0 && sense * s.1 <= 0.0;
            let ended = |s: (f64, f64, f64)| {
                !seen.reached && (step > 0 || !matches!(self.end, End::Turn)) && left(s.0, s.1, s.2) <= 0.0
            };
            let next = go(h);
            let stop = |s: (f64, f64, f64)| turned(s) || ended(s);
            let mut last = next;
            if stop(next) {
                let (mut low, mut high) = (0.0, h);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if stop(go(middle)) { high = middle } else { low = middle }
                }
                last = go(high);
            }
            let [_, friction, tension] = self.forces(last.0);
            seen.most_friction = seen.most_friction.max(friction.abs());
            seen.least_tension = seen.least_tension.min(tension);
            let (over, done) = (turned(last), ended(last));
            (x, v, t) = last;
            if done {
                seen.reached = true;
            }
            if over || done && !self.whole {
                return seen;
            }
        }
        seen
    }
}

fn solved(problem: &Problem) -> Option<Solved> {
    solve(&problem.cases[0].scene, &support::data(problem)).ok()
}

fn problem(text: &str) -> Problem {
    match load::scenes_only(text, "range.yaml") {
        Ok(mut bank) => bank.problems.remove(0),
        Err(findings) => {
            panic!("{text}\n{}", findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
        }
    }
}

#[test]
fn conditions_look_as_far_as_the_end_that_is_asked() {
    let mut lots = Lots(20_261_122);
    let (mut ends, mut wholes, mut ropes) = (0, 0, 0);
    let mut differ = 0;
    for _ in 0..4000 {
        let wheel = Wheel::draw(&mut lots);
        let text = wheel.bank();
        let problem = problem(&text);
        let span = problem.cases[0].scene.span;
        assert_eq!(span, if wheel.whole { Span::ToTurningPoint } else { Span::ToEnd });
        let Some(solved) = solved(&problem) else { continue };
        let holds = |kind: CheckKind| solved.checks.iter().find(|c| c.kind == kind);
        if !holds(CheckKind::Moves).is_some_and(|c| c.ok) || !holds(CheckKind::Reaches).is_some_and(|c| c.ok)
        {
            continue;
        }
        let turn = solved
            .entries
            .iter()
            .find(|e| e.label.quantity == Quantity::DTurn)
            .map_or(f64::NAN, |e| e.value());
        // Where it never turns, or only after a long time, there is nothing to run to; an end at a turning point is what rounding says.
        let margin = holds(CheckKind::Reaches).map_or(0.0, |c| c.margin);
        if wheel.whole && !(turn < 50.0) || margin < 1e-6 {
            continue;
        }
        let seen = wheel.seen();
        assert!(seen.reached, "{wheel:?}");
        let near = |got: f64, want: f64, what: &str| {
            let scale = want.abs().max(wheel.m * 0.01);
            assert!((got - want).abs() <= 1e-6 * scale, "{what}: {got} is not {want}: {wheel:?}\n{text}");
        };
        let grip = holds(CheckKind::NoSlip).unwrap();
        near(grip.required, seen.most_friction, "friction");
        let mu = solved.entries.iter().find(|e| e.label.quantity == Quantity::MuRequired).unwrap();
        let normal = wheel.m * G * libm::cos(wheel.slope * PI / 180.0);
        near(mu.value() * normal, seen.most_friction, "mu_required");
        if wheel.cart.is_some() {
            near(holds(CheckKind::Taut).unwrap().available, seen.least_tension, "tension");
            ropes += 1;
        }
        if wheel.whole {
            wholes += 1;
        } else {
            ends += 1;
            let beyond = Wheel { whole: true, ..wheel };
            if turn < 50.0 && beyond.seen().most_friction > 1.001 * seen.most_friction {
                differ += 1;
            }
        }
    }
    println!(
        "{ends} to their end, {wholes} to the turning point, {ropes} with a rope; {differ} would need more beyond the end"
    );
    assert!(ends > 500 && wholes > 500 && ropes > 500 && differ > 200, "{ends} {wholes} {ropes} {differ}");
}

/// A disc that a couple drives down a slope against a spring.
fn driven_down() -> Wheel {
    Wheel {
        m: 20.0,
        rim: 0.2,
        k: 0.2 / 2f64.sqrt(),
        slope: 30.0,
        ks: 150.0,
        x0: 0.0,
        rigid: true,
        lever: 0.0,
        forward: true,
        couple: -30.0,
        cart: None,
        v0: 0.0,
        end: End::Travel(1.0),
        whole: false,
    }
}

/// By hand: |F|/N is largest after 1.0 m, 117.3/169.914; the 232.7 N that the turning point needs, 3.308 m away, are not asked.
#[test]
fn a_disc_driven_down_against_a_spring() {
    for (whole, friction) in [(false, 117.3), (true, 232.7)] {
        let solved = solved(&problem(&Wheel { whole, ..driven_down() }.bank())).unwrap();
        let mu = solved.entries.iter().find(|e| e.label.quantity == Quantity::MuRequired).unwrap();
        assert!((mu.value() / (friction / 169.914_184_223) - 1.0).abs() < 1e-9, "{}", mu.value());
    }
}

/// The program, once: what it printed.
fn run(args: &[&str], input: &str) -> (Exit, String) {
    let ran = run_with(args, input);
    (ran.exit, ran.out + &ran.err)
}

/// One key for all verbs: what is asked says how far it looks, `asks:` included, and a sheet carries its questions.
#[test]
fn every_verb_has_the_same_key() {
    let room = tempfile::tempdir().unwrap();
    let path = |name: &str| room.path().join(name).display().to_string();
    std::fs::write(path("roster.csv"), "student\n7\n").unwrap();
    let wheel = Wheel { k: 0.15, whole: true, ..driven_down() };
    let text = wheel.bank() + "    statement: '{{ m }}'\n";
    let mut keys = Vec::new();
    // All questions; the greatest speed left out by `asks:`.
    for (name, text) in [("whole", text.clone()), ("end", text + "    asks: [mu]\n")] {
        let (bank, set) = (path(&format!("{name}.yaml")), path(name));
        std::fs::write(&bank, text).unwrap();
        let (exit, said) =
            run(&["generate", &bank, "--roster", &path("roster.csv"), "--seed", "5", "--out", &set], "");
        assert_eq!(exit, Exit::Fine, "{said}");
        let key = std::fs::read_to_string(path(&format!("{name}/key.csv"))).unwrap();
        let value = key.lines().find(|l| l.contains(",mu,")).unwrap().split(',').nth(3).unwrap().to_owned();
        let (_, solved) = run(&["solve", &bank, "one", "--seed", "5", "--json"], "");
        let json: serde_json::Value = serde_json::from_str(&solved).unwrap();
        let other: f64 = json["quantities"]["mu_required"]["value"].as_f64().unwrap();
        assert_eq!(value.parse::<f64>().unwrap(), other, "solve");
        let sheet = path(&format!("{name}/students/7/sheet.json"));
        assert_eq!(run(&["check", &sheet, &format!("1.mu={value}")], "").0, Exit::Fine, "check");
        assert_eq!(
            run(&["check", &sheet, &format!("1.mu={}", other * 1.05)], "").0,
            Exit::NotAllRight,
            "check"
        );
        let (_, practised) =
            run(&["practice", &bank, "--seed", "5", "--problems", "one"], &format!("1.mu={value}\nquit\n"));
        assert!(practised.contains("right") && !practised.contains("wrong"), "{practised}");
        let (exit, said) = run(&["verify", &set], "");
        assert_eq!(exit, Exit::Fine, "{said}");
        let page = std::fs::read_to_string(path(&format!("{name}/students/7/sheet.html"))).unwrap();
        let range = if name == "end" {
            "from the start to the end that is asked"
        } else {
            "from the start to the turning point"
        };
        assert!(page.contains(range), "the sheet says which");
        let (exit, said) =
            run(&["solutions", &set, "--out", &path(&format!("{name}-solved")), "--format", "md"], "");
        assert_eq!(exit, Exit::Fine, "{said}");
        let worked = std::fs::read_to_string(path(&format!("{name}-solved/7/solution.md"))).unwrap();
        let range =
            if name == "end" { "from the start to there" } else { "from the start to the turning point" };
        assert!(worked.contains(range), "the worked solution says which");
        keys.push(other);
    }
    assert!(keys[0] > 1.5 * keys[1], "{keys:?}");
}
