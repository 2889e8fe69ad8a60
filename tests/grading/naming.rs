//! How often a wrong answer is told as a method that the student did not take, and how often as the one taken.
use crate::support;
use slipstick::bank::{Bank, load};
use slipstick::grade::compare::compare;
use slipstick::grade::diagnose;
use slipstick::grade::verdict::Verdict;
use slipstick::key::KeyEntry;
use slipstick::misconception;
use slipstick::num::shown;
use slipstick::problem::maker::Maker;
use slipstick::scene::Label;

/// Forty wrong methods of students that are not in the catalogue, by problem.
const STRANGE: &[(&str, &[&str])] = &[
    (
        "kinetic-energy",
        &[
            "{values: {kinetic_energy: m_A*(vx^2 + vy^2)/2 + I_G*omega^2/2}}",
            "{data: {x_A: -x_A}, of: [x_G, y_G, I_G, kinetic_energy]}",
            "{data: {vy: -vy}, of: [kinetic_energy]}",
        ],
    ),
    (
        "pulled-rolling",
        &[
            "{data: {m: m/2}}",
            "{values: {omega: sqrt(2*P*d/(m*k^2)), v: r*sqrt(2*P*d/(m*k^2))}}",
            "{data: {P: P*cos(theta)}}",
            "{data: {R: r, r: R}}",
            "{data: {k: (R + r)/4}}",
            "{values: {omega: v*r, k_bound: (R + r)/2, cord_travel: d + d*r/R}}",
        ],
    ),
    (
        "pulled-slipping",
        &[
            "{values: {friction: mu_s*m*g*sin(theta), v: sqrt(2*P*d/m), heat: mu_k*m*g*d}}",
            "{data: {R: r, r: R}}",
            "{data: {m: 2*m}}",
            "{data: {P: P*cos(theta)}}",
        ],
    ),
    (
        "spring-released",
        &[
            "{values: {x_eq: m*g*cos(theta)/ks, v: sqrt(ks/m)*x0}}",
            "{data: {r: R - r}}",
            "{data: {ks: ks/2}}",
            "{data: {x0: x0/2}}",
        ],
    ),
    (
        "block-pulls-wheel",
        &["{data: {m_B: m_B/2}}", "{data: {theta: theta/2}}", "{values: {v: sqrt(g*d), t: sqrt(d/g)}}"],
    ),
    ("yo-yo", &["{data: {k: 2*k}}", "{data: {r: r/2}}", "{values: {tension: m*g*k/r, a: g*r/k}}"]),
    ("two-loads-on-a-stepped-drum", &["{data: {M: M/2}}", "{data: {m_1: 2*m_1}}", "{data: {m_2: m_1}}"]),
    (
        "thrown-ball",
        &["{data: {v0: v0/2}}", "{data: {mu_k: 2/3*mu_k}}", "{values: {v: 3/5*v0, t: v0/(mu_k*g)/2}}"],
    ),
    (
        "wheel-set-down",
        &[
            "{data: {k: 2/3*k}}",
            "{data: {w0: 2/3*w0}, of: [v, omega, displacement, slip_distance, heat]}",
            "{values: {omega: abs(w0 - g*t1/R), v: g*mu_k*t1}}",
        ],
    ),
    (
        "falling-rod",
        &[
            "{values: {omega: sqrt(g*(cos(phi0) - cos(phi1))/L), alpha: g*sin(phi1)/(3*L)}}",
            "{values: {pin_radial: m*omega^2*L/3 - m*g*cos(phi1), pin_tangential: m*alpha*L/3 - m*g*sin(phi1)}}",
        ],
    ),
    (
        "compound-pendulum",
        &["{data: {k: h, h: k}}", "{values: {period: period_small*(1 + phi0/16), omega: 2*omega}}"],
    ),
    ("lifted-rod", &["{data: {M: M/2}}", "{data: {m: 2*m}}"]),
    ("rod-and-spring", &["{data: {ks: ks/2}}", "{values: {spring_force: ks*l0, pin_force: 2*m*g}}"]),
];

/// How many wrong numbers were told as some method, and how many there were.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Share {
    told: u32,
    of: u32,
}

impl Share {
    fn add(&mut self, told: bool) {
        self.told += u32::from(told);
        self.of += 1;
    }
    fn share(self) -> f64 {
        f64::from(self.told) / f64::from(self.of)
    }
}

/// Is this value, written with so many figures, told as this method, or (`None`) as any? `None` where it is not wrong.
fn told(
    value: f64,
    figures: usize,
    (part, parts): (usize, &[KeyEntry]),
    method: Option<u16>,
) -> Option<bool> {
    let entry = &parts[part];
    let cell = format!("{} {}", shown::figures(entry.unit.from_si(value), figures), entry.unit.ascii());
    let judgement = compare(&cell, entry);
    let wrong = matches!(judgement.verdict, Verdict::Wrong);
    let found = diagnose::diagnose(judgement.number, cell.as_bytes(), part, parts, &entry.wrong).methods;
    wrong.then(|| method.map_or(!found.is_empty(), |m| found.contains(&m)))
}

/// Drawn students for each problem.
const STUDENTS: u32 = 25;

/// The draws are fixed, so the counts are: of the numbers of forty methods that no catalogue knows at most 5 % are told as one
/// that it knows, and of those of known methods at least 95 % as what they are.
#[test]
fn hints_name_what_was_done_and_nothing_else() {
    assert_eq!(STRANGE.iter().map(|(_, methods)| methods.len()).sum::<usize>(), 40);
    let (mut known, mut strange) = ([Share::default(); 2], [Share::default(); 2]);
    for (bank, with) in support::banks().iter().zip(with_strange()) {
        for (problem, with) in bank.problems.iter().zip(&with.problems) {
            let maker = Maker::new(problem, 13, "naming");
            let labels: Vec<Label> = problem.questions.iter().map(|q| q.label).collect();
            for student in 0..STUDENTS {
                let variant = maker.variant(&student.to_string()).unwrap();
                let parts = maker.key(&variant).parts;
                for (i, figures) in [3, 4].into_iter().enumerate() {
                    for (p, entry) in parts.iter().enumerate() {
                        for w in &entry.wrong {
                            if let Some(named) = told(w.value, figures, (p, &parts), Some(w.method)) {
                                known[i].add(named);
                            }
                        }
                    }
                    let all =
                        misconception::values(with, variant.case, &variant.data, &variant.solved, &labels);
                    for w in all.iter().filter(|w| w.mistake >= problem.mistakes.len()) {
                        let p = labels.iter().position(|l| *l == w.label).unwrap();
                        let magnitude = w.label.quantity.is_magnitude();
                        let value = if magnitude { w.value.abs() } else { w.value };
                        if let Some(named) = told(value, figures, (p, &parts), None) {
                            strange[i].add(named);
                        }
                    }
                }
            }
        }
    }
    println!("known {known:?}, strange {strange:?}");
    for (known, strange) in known.iter().zip(&strange) {
        assert!(known.share() >= 0.95, "{known:?}");
        assert!(strange.share() <= 0.05, "{strange:?}");
    }
}

/// A round guess is no sign of a method, but what a method takes straight from the statement is.
#[test]
fn a_round_guess_fits_nothing_but_a_datum_fits_exactly() {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == "pulled-rolling").unwrap();
    let maker = Maker::new(problem, 13, "naming");
    for student in 0..STUDENTS {
        let variant = maker.variant(&student.to_string()).unwrap();
        let key = maker.key(&variant);
        let parts = &key.parts;
        let p = parts.iter().position(|e| e.part == "cord_travel").unwrap();
        let d = variant.data[problem.data.iter().position(|d| d.symbol == "d").unwrap()];
        let found =
            |cell: &str, x: f64| diagnose::diagnose(x, cell.as_bytes(), p, parts, &parts[p].wrong).methods;
        let datum = found(&format!("{d} m"), d);
        assert!(datum.iter().any(|m| key.methods[usize::from(*m)] == "A31"), "{d}: {datum:?}");
        // Within the tolerance of the same method, but round.
        let w = parts[p].wrong.iter().find(|w| key.methods[usize::from(w.method)] == "A02");
        let near = w.unwrap().value;
        let round = shown::rounded(near, 2);
        if (round - near).abs() > 1e-9 * near {
            assert_eq!(found(&format!("{round} m"), round), Vec::<u16>::new(), "{round} for {near}");
        }
    }
}

/// The banks with the strange methods behind their own.
fn with_strange() -> Vec<Bank> {
    support::banks()
        .iter()
        .map(|bank| {
            let path = format!("{}/banks/{}.yaml", env!("CARGO_MANIFEST_DIR"), bank.id);
            let mut text = std::fs::read_to_string(&path).unwrap();
            for (id, methods) in STRANGE {
                let Some(at) = text.find(&format!("\n  {id}:\n")) else { continue };
                let list = at + text[at..].find("\n    mistakes:\n").unwrap();
                // Behind the last method of the list: at the next line that is indented less.
                let mut end = list + "\n    mistakes:\n".len();
                for line in text[end..].split_inclusive('\n') {
                    if !line.trim().is_empty() && !line.starts_with("     ") {
                        break;
                    }
                    end += line.len();
                }
                let lines: String =
                    methods.iter().enumerate().map(|(i, m)| format!("      X{i}: {m}\n")).collect();
                text.insert_str(end, &lines);
            }
            load::scenes_only(&text, &path).unwrap_or_else(|f| panic!("{f:?}"))
        })
        .collect()
}
