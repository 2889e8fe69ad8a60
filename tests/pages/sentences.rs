//! What texts and figures claim, held against the scene itself: each sentence that the program computes is computed here once more, from
//! the drawn data and by other means. The tests of worked solutions read formulas only; a false sentence between them went unseen.
use crate::support;
use dashu_float::DBig;
use slipstick::bank::{Bank, FigureLabels, Problem, load};
use slipstick::grade::compare::compare;
use slipstick::grade::verdict::Verdict;
use slipstick::picture::{Outline, Picture, Role, symbol};
use slipstick::problem::make_key;
use slipstick::problem::maker::{self, Maker, Variant};
use slipstick::scene::{End, Quantity};
use slipstick::sheet::statement::{Common, Scratch, Statement};
use slipstick::template::Templates;
use slipstick::words::Words;
use slipstick::{figure, solution};
use std::str::FromStr;

fn bank(text: &str) -> Bank {
    load::scenes_only(text, "test.yaml").unwrap_or_else(|f| panic!("{f:?}"))
}

/// Words and templates of both languages.
fn languages() -> [(Words, Templates); 2] {
    ["en", "de"].map(|l| (Words::of(l).expect("a language"), Templates::new(l, &[]).expect("templates")))
}

fn solution(problem: &Problem, variant: &Variant, (words, templates): &(Words, Templates)) -> String {
    solution::text(problem, variant, 1, words, templates).unwrap_or_else(|f| panic!("{}: {f}", problem.id))
}

fn datum(problem: &Problem, variant: &Variant, symbol: &str) -> f64 {
    let at = problem.data.iter().position(|d| d.symbol == symbol).expect(symbol);
    variant.data[at]
}

/// Wheels on a spring with a radius of gyration below and above the root of both radii; nothing of the whole motion is asked of
/// the second.
const SPRUNG: &str = "
bank: sprung
title: Wheels on springs
problems:
  whole: &wheel
    title: A wheel
    data:
      m: {name: mass, unit: kg, draw: 20 to 60 step 1}
      R: {name: rim, unit: m, draw: 0.30 to 0.45 step 0.01}
      r: {name: hub, unit: m, draw: 0.10 to 0.28 step 0.01}
      k: {name: radius of gyration, unit: m, draw: 0.10 to 0.34 step 0.01}
      theta: {name: slope, unit: deg, draw: 5 to 35 step 1}
      ks: {name: stiffness, unit: N/m, draw: 100 to 800 step 10}
      x0: {name: stretch, unit: m, draw: 0.02 to 0.50 step 0.01}
      D: {name: distance, unit: m, draw: 0.02 to 0.30 step 0.01}
      mu_s: {name: coefficient, unit: '1', draw: always 9}
    scene: &scene
      surfaces: {incline: {slope: theta}}
      bodies: {wheel: {mass: m, radius of gyration: k, radii: {rim: R, hub: r}, moves: along incline}}
      ties:
        - rolls: {body: wheel, on its: rim, mu_s: mu_s}
        - cord: {from: {body: wheel, wound on: hub, leaves: top forward}, spring: {stiffness: ks, stretch: x0, attached: by the cord}}
      start: at rest
      end: {travel: {of: wheel, by: D}}
    regimes: [up ok, down ok]
    questions:
      v: {ask: v, unit: m/s}
      mu_required: {ask: mu, unit: '1'}
      v_max: {ask: v_max, unit: m/s}
    statement: '{{ m }} {{ R }} {{ r }} {{ k }} {{ theta }} {{ ks }} {{ x0 }} {{ D }} {{ mu_s }}'
  part:
    <<: *wheel
    questions:
      v: {ask: v, unit: m/s}
      mu_required: {ask: mu, unit: '1'}
";

#[test]
fn friction_is_said_to_be_largest_where_it_is() {
    let languages = languages();
    // By the sign of k^2 - r R, and whether it rolls up.
    let mut seen = [[0u32; 2]; 2];
    let own = bank(SPRUNG);
    let built_in = support::banks();
    let built_in = built_in.iter().flat_map(|b| &b.problems).filter(|p| p.id == "spring-released");
    for problem in own.problems.iter().chain(built_in) {
        let maker = Maker::new(problem, 11, "sentences").giving_up_after(20_000);
        for student in 0..150 {
            let variant = maker.variant(&student.to_string()).unwrap_or_else(|u| panic!("{u}"));
            // Where the cord is slack at the asked end there is a short page, without sentences.
            let beyond = languages[0].0.get("solution.title.beyond");
            if solution(problem, &variant, &languages[0]).contains(beyond) {
                continue;
            }
            let of = |symbol| datum(problem, &variant, symbol);
            let (m, c, p, k, ks, x0) = (of("m"), of("R"), of("r"), of("k"), of("ks"), of("x0"));
            let weight = m * 9.81 * of("theta").to_radians().sin();
            let friction = |pull: f64| (pull * (p * c - k * k) + weight * k * k) / (c * c + k * k);
            let gamma = (c + p) / c;
            let first = gamma * ks * x0 - weight;
            let at = |s: f64| ks * (x0 - gamma * s);
            let normal = m * 9.81 * of("theta").to_radians().cos();
            let turn = at(2.0 * first / (ks * gamma * gamma)).max(0.0);
            let end = at(of("D") * first.signum());
            for language in &languages {
                let text = solution(problem, &variant, language);
                let says =
                    |name: &str| text.contains(language.0.get(&format!("solution.holds.range.{name}")));
                let last = match (says("end"), says("turn")) {
                    (true, false) => end,
                    (false, true) => turn,
                    both => panic!("one range: {both:?}\n{text}"),
                };
                // Looked for all over the range, not only at its ends.
                let most = (0..=400).map(|step| at(0.0) + (last - at(0.0)) * f64::from(step) / 400.0);
                let most = most.map(|pull| friction(pull).abs()).fold(0.0, f64::max);
                let (sign, mu) = (if language.0.language() == "en" { '.' } else { ',' }, most / normal);
                let printed = slipstick::num::shown::significant(mu, 4).replace('.', &sign.to_string());
                let printed = printed.replace(',', "{,}");
                let told = format!("}}{{N}} = {printed}$");
                assert!(text.contains(&told), "{told}\n{text}");
            }
            seen[usize::from(k * k > p * c)][usize::from(first > 0.0)] += 1;
        }
    }
    println!("k^2 below and above r R, each down and up: {seen:?}");
    assert!(seen.iter().flatten().all(|n| *n >= 25), "{seen:?}");
}

#[test]
fn kinetic_energy_is_compared_by_the_names_of_its_own_ways() {
    let heads = [
        ["the sum over the particles.", "mass centre and rotation.", "equations of motion."],
        ["die Summe über die Massenpunkte.", "Schwerpunkt und Drehung.", "Bewegungsgleichungen."],
    ];
    for (language, heads) in languages().iter().zip(heads) {
        for problem in support::banks().iter().flat_map(|b| &b.problems) {
            let variant = Maker::new(problem, 3, "sentences").variant("0").expect("a variant");
            let text = solution(problem, &variant, language);
            // A page without a worked solution has no ways.
            if text.contains(language.0.get("solution.short").split(':').next().expect("a sentence")) {
                continue;
            }
            let particles = problem.cases[0].scene.bodies.iter().any(|b| !b.particles.is_empty());
            let titles: String = text.lines().filter(|l| l.starts_with("**")).collect();
            let said = heads.map(|h| titles.contains(&format!(": {h}**")));
            assert_eq!(said, [particles, particles, !particles], "{}: {titles}", problem.id);
            // At an instant nothing falls.
            assert_eq!(particles, !text.contains("9.81") && !text.contains("9{,}81"), "{}", problem.id);
        }
    }
}

// The tests before compared the printed answer with what the same function made of it.
#[test]
fn answers_are_rounded_half_up_from_the_decimal_value() {
    let (words, templates) = &languages()[0];
    let mut halves = 0;
    for problem in support::banks().iter().flat_map(|b| &b.problems) {
        let draws = if problem.id == "kinetic-energy" { 400 } else { 15 };
        let maker = Maker::new(problem, 1, "sentences");
        for student in 0..draws {
            let variant = maker.variant(&student.to_string()).expect("a variant");
            let text = solution::text(problem, &variant, 1, words, templates).expect("a solution");
            for q in &problem.questions {
                let Some(entry) = variant.solved.get(q.label) else { continue };
                let meant = format!("{:.14e}", q.unit.from_si(entry.value()));
                let meant = DBig::from_str(&meant).expect("a decimal number");
                let figures = usize::from(q.figures);
                let rounded = meant.clone().with_precision(figures).value();
                let row = format!("`1.{}` ", q.id);
                let told = text.lines().find_map(|l| l.strip_prefix("> ")).expect("answers");
                let line = told.split(" · ").find_map(|l| l.strip_prefix(&row)).expect("an answer");
                let number = line.rsplit_once("= ").map_or(line, |(_, n)| n).trim_start_matches('$');
                let digits: String =
                    number.chars().take_while(|c| c.is_ascii_digit() || "-.".contains(*c)).collect();
                if number.contains("cdot") {
                    continue;
                }
                assert_eq!(
                    DBig::from_str(&digits).expect(&digits),
                    rounded,
                    "{} {student} {}: {line}",
                    problem.id,
                    q.id
                );
                let half = meant.clone().with_precision(figures + 1).value();
                halves += u32::from(
                    half == meant && half.to_string().trim_end_matches('0').ends_with('5') && half != rounded,
                );
            }
        }
    }
    println!("{halves} answers are exact halves");
    assert!(halves > 5);
}

#[test]
fn the_terms_that_are_named_suffice_and_one_less_does_not() {
    let mut counts = std::collections::BTreeMap::new();
    for language in ["en", "de"] {
        let words = Words::of(language).expect("a language");
        for bank in support::banks_in(language) {
            let templates = support::templates(language, &bank);
            for problem in bank
                .problems
                .iter()
                .filter(|p| p.questions.iter().any(|q| q.label.quantity == Quantity::Period))
            {
                let common = Common::of(problem.questions.iter());
                let statement = Statement::new(&templates, &words, problem, 1, &common).expect("a statement");
                let maker = Maker::new(problem, 21, "sentences");
                for student in 0..150 {
                    let variant = maker.variant(&student.to_string()).expect("a variant");
                    let mut out = Vec::new();
                    statement.write(&variant, 1, None, &mut Scratch::default(), &mut out).expect("written");
                    let text = String::from_utf8(out).expect("UTF-8");
                    let word = if language == "en" { " terms are enough" } else { " Glieder genügen" };
                    let before = text.split(word).next().filter(|b| b.len() < text.len()).expect(&text);
                    let before = if language == "en" { before } else { before.trim_end() };
                    let named: usize = before.rsplit(' ').next().unwrap().parse().expect(&text);
                    // By hand: from the statement's own words, sin of half the greatest angle.
                    let half = datum(problem, &variant, "phi0").to_radians() / 2.0;
                    let (h, k) = (datum(problem, &variant, "h"), datum(problem, &variant, "k"));
                    let small = std::f64::consts::TAU * ((h * h + k * k) / (9.81 * h)).sqrt();
                    let period = |terms: usize| {
                        let (mut sum, mut term) = (0.0, 1.0);
                        for j in 1..=terms {
                            sum += term;
                            let odd = (2.0 * j as f64 - 1.0) / (2.0 * j as f64);
                            term *= odd * odd * half.sin() * half.sin();
                        }
                        small * sum
                    };
                    let key = make_key::key(problem, &variant);
                    let entry = key.parts.iter().find(|p| p.part == "period").expect("asked");
                    let right =
                        |terms| compare(&format!("{} s", period(terms)), entry).verdict == Verdict::Right;
                    assert!(right(named) && !right(named - 1), "{language} {student}: {named} terms");
                    *counts.entry(named).or_insert(0) += 1;
                }
            }
        }
    }
    println!("terms named: {counts:?}");
    assert!(counts.len() >= 4, "{counts:?}");
}

const IDS: &str = "
bank: ids
title: Ids that are no words
problems:
  hoist:
    title: A hoist
    data:
      m_1: {name: mass, unit: kg, draw: 15 to 25 step 1}
      m_2: {name: mass, unit: kg, draw: 5 to 9 step 1}
      m_3: {name: mass, unit: kg, draw: 2 to 6 step 1}
      b: {name: radius, unit: m, draw: 0.1 to 0.3 step 0.01}
      mu: {name: friction, unit: '1', draw: always 0.2}
      theta: {name: slope, unit: deg, draw: 10 to 30 step 1}
      d: {name: distance, unit: m, draw: 1 to 2 step 0.1}
    scene:
      surfaces: {incline: {slope: theta}}
      bodies:
        zq_klotz: {mass: m_2, moves: along incline, positive: up}
        xwheel7: {mass: m_3, shape: {disc: b}, moves: about a fixed axle}
        yload9: {mass: m_1, moves: vertically, positive: down}
      ties:
        - slides: {body: zq_klotz, mu_k: mu}
        - cord: {name: rope_x1, from: {body: zq_klotz, tied at: centre, leaves: up}, to: {body: xwheel7, wound on: rim, leaves: back down}}
        - cord: {name: upperq, from: {body: yload9, tied at: centre, leaves: up}, to: {body: xwheel7, wound on: rim, leaves: front down}}
      start: at rest
      end: {travel: {of: yload9, by: d}}
    regimes: [moves_down]
    questions:
      one: {quantity: rope_x1.tension, ask: first, unit: N}
      two: {quantity: upperq.tension, ask: second, unit: N}
    statement: '{{ m_1 }} {{ m_2 }} {{ m_3 }} {{ b }} {{ mu }} {{ theta }} {{ d }}'
";

/// Prose of a document: no paths of pictures, no code, no symbols.
fn prose(markdown: &str) -> String {
    let mut out = String::new();
    for line in markdown.lines() {
        for (i, piece) in line.split('$').enumerate() {
            if i % 2 == 0 {
                out.push_str(
                    &piece
                        .split("](")
                        .enumerate()
                        .map(|(i, p)| match i {
                            0 => p.to_owned(),
                            _ => p.split_once(')').map_or(String::new(), |(_, rest)| rest.to_owned()),
                        })
                        .collect::<String>(),
                );
            }
        }
        out.push('\n');
    }
    out
}

// The banks of the program have ids that are English words; only the bracketed `(upper)` of one of them stood out.
#[test]
fn ids_of_a_bank_are_no_words_of_a_text() {
    let own = bank(IDS);
    let banks = support::banks();
    let hoists = banks.iter().filter(|b| b.id == "hoists-and-pulleys").flat_map(|b| &b.problems);
    for problem in own.problems.iter().chain(hoists) {
        let variant = Maker::new(problem, 5, "sentences").variant("0").unwrap_or_else(|u| panic!("{u}"));
        let scene = &problem.cases[variant.case].scene;
        let cords = scene.cords_with(Quantity::Tension).map(|(_, name)| name.to_owned());
        // `block` and `upper` are words that a text may use; in brackets or as code they are ids all the same.
        let bodies = scene.bodies.iter().map(|b| b.name.clone());
        let ids: Vec<String> = cords.chain(bodies).collect();
        let ids = ids.iter().flat_map(|id| {
            let odd = id.chars().any(|c| !c.is_alphabetic()) || id.contains(['q', 'x']);
            [odd.then(|| id.clone()), Some(format!("({id})")), Some(format!("`{id}`"))].into_iter().flatten()
        });
        let ids: Vec<String> = ids.collect();
        for (words, templates) in &languages() {
            let document = solution::document(problem, &variant, 1, words, templates).expect("a solution");
            let mut text = prose(&document.markdown);
            // The parts have ids that stand on the sheet.
            for q in &problem.questions {
                text = text.replace(&format!("`1.{}`", q.id), "");
            }
            for (_, picture) in &document.pictures {
                text.push_str(&picture.title);
                text.push_str(&picture.desc);
            }
            for id in &ids {
                assert!(!text.contains(id.as_str()), "{}: {id} in {text}", problem.id);
            }
            // One body has one name, in text and pictures.
            for b in 0..scene.bodies.len() {
                let name = figure::names::body(words, scene, b);
                assert!(text.to_lowercase().contains(&name.to_lowercase()), "{name}: {text}");
                let shown = document.pictures.iter().any(|(n, p)| n == "scene" && p.desc.contains(&name));
                assert!(shown, "{name} in the picture");
            }
        }
    }
}

#[test]
fn the_bound_of_the_radius_of_gyration_lies_within_the_rim() {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == "pulled-rolling").expect("there");
    let maker = Maker::new(problem, 1, "sentences");
    for student in 0..400 {
        let variant = maker.variant(&student.to_string()).expect("a variant");
        let bound = variant.solved.entries.iter().find(|e| e.label.quantity == Quantity::KBound);
        let (bound, rim) = (bound.expect("asked").value(), datum(problem, &variant, "R"));
        assert!(bound > 0.0 && bound < 0.95 * rim, "{student}: {bound} in a rim of {rim}");
    }
}

/// A drum on a fixed axle with a cord that leaves as told and is pulled, or held by a spring.
fn drum(leaves: &str) -> Bank {
    bank(&format!(
        "
bank: drums
title: Drums
problems:
  drum:
    title: A drum
    data:
      m: {{name: mass, unit: kg, draw: always 10}}
      R: {{name: radius, unit: m, draw: always 0.4}}
      P: {{name: pull, unit: N, draw: always 50}}
      phi: {{name: angle, unit: rad, draw: always 3}}
    scene:
      bodies: {{drum: {{mass: m, shape: {{disc: R}}, radii: {{rim: R}}, moves: about a fixed axle}}}}
      ties:
        - cord: {{from: {{body: drum, wound on: rim, leaves: {leaves}}}, pulled with: P}}
      start: at rest
      end: {{turn: {{of: drum, by: phi}}}}
    questions:
      omega: {{ask: omega, unit: rad/s}}
    statement: '{{{{ m }}}} {{{{ R }}}} {{{{ P }}}} {{{{ phi }}}}'
"
    ))
}

/// From where to where the arrows of given forces go, y up.
fn arrows(picture: &Picture, role: Role) -> Vec<((f64, f64), (f64, f64))> {
    let lines = picture.elements.iter().filter(|s| s.role == role);
    let ends = lines.filter_map(|s| match &s.outline {
        Outline::Lines { points, closed: false } if points.len() == 2 => {
            Some(((points[0].x, -points[0].y), (points[1].x, -points[1].y)))
        }
        _ => None,
    });
    ends.collect()
}

fn centre_of(picture: &Picture) -> (f64, f64) {
    let body = picture.elements.iter().find_map(|s| match s.outline {
        Outline::Circle { centre, .. } if s.role == Role::Body => Some((centre.x, -centre.y)),
        _ => None,
    });
    body.expect("a drum")
}

fn lines_of(picture: &Picture) -> Vec<String> {
    picture.labels.iter().map(|l| symbol::plain(&l.runs).replace('\u{a0}', " ")).collect()
}

// Figures were looked at for labels and sums; which way a cord leaves was only seen in scenes where it hangs.
#[test]
fn a_cord_leaves_a_fixed_axle_as_the_bank_says() {
    let words = Words::english();
    for (leaves, towards, side) in [
        ("top forward", (1.0, 0.0), (0.0, 1.0)),
        ("top back", (-1.0, 0.0), (0.0, 1.0)),
        ("bottom forward", (1.0, 0.0), (0.0, -1.0)),
        ("bottom back", (-1.0, 0.0), (0.0, -1.0)),
        ("front down", (0.0, -1.0), (1.0, 0.0)),
        ("back down", (0.0, -1.0), (-1.0, 0.0)),
        ("front up", (0.0, 1.0), (1.0, 0.0)),
        ("back up", (0.0, 1.0), (-1.0, 0.0)),
    ] {
        let bank = drum(leaves);
        let problem = &bank.problems[0];
        // A scene that turns against what its end says is drawn all the same.
        let values = support::constants(problem);
        let variant = slipstick::problem::maker::from_values(problem, 0, &values).expect("solved");
        let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 1e-6 && (a.1 - b.1).abs() < 1e-6;
        let way = |((ax, ay), (bx, by)): ((f64, f64), (f64, f64))| {
            let long = ((bx - ax).powi(2) + (by - ay).powi(2)).sqrt();
            ((bx - ax) / long, (by - ay) / long)
        };
        let scene = figure::scene::picture(problem, &variant, &words, FigureLabels::Values);
        let pulls = arrows(&scene, Role::Force);
        let [pull] = pulls.as_slice() else { panic!("{leaves}: {pulls:?}") };
        assert!(near(way(*pull), towards), "{leaves}: drawn {pull:?}");
        let (x, y) = centre_of(&scene);
        let off = ((pull.0.0 - x) * side.0 + (pull.0.1 - y) * side.1).signum();
        assert!(off > 0.0, "{leaves}: on the other side");
        // The free body: pull, weight, and an axle that holds both.
        let free = figure::forces::free_body(problem, &variant, &words, 0);
        let forces: Vec<_> = arrows(&free, Role::Force).into_iter().map(way).collect();
        assert_eq!(forces.len(), 3, "{leaves}: {forces:?}");
        assert!(forces.iter().any(|f| near(*f, towards)), "{leaves}: {forces:?}");
        let weight = 98.1;
        let held = (-50.0 * towards.0, weight - 50.0 * towards.1);
        let long = (held.0 * held.0 + held.1 * held.1).sqrt();
        let axle = (held.0 / long, held.1 / long);
        assert!(forces.iter().any(|f| near(*f, axle)), "{leaves}: no {axle:?} in {forces:?}");
        // What is read to those who do not see it.
        let word = match towards {
            (x, _) if x > 0.5 => "to the right",
            (x, _) if x < -0.5 => "to the left",
            (_, y) if y > 0.0 => ", up,",
            _ => ", down,",
        };
        assert!(scene.desc.contains(word), "{leaves}: {}", scene.desc);
    }
}

fn thrown(speed: &str, spin: &str) -> Bank {
    bank(&format!(
        "
bank: thrown
title: Thrown
problems:
  hoop:
    title: A hoop
    data:
      m: {{name: mass, unit: kg, draw: always 3}}
      R: {{name: radius, unit: m, draw: always 0.3}}
      v0: {{name: speed, unit: m/s, draw: always {speed}}}
      w0: {{name: spin, unit: rad/s, draw: always {spin}, tex: \\omega_0}}
      mu_k: {{name: friction, unit: '1', draw: always 0.2}}
    scene:
      surfaces: {{floor: level}}
      bodies: {{hoop: {{mass: m, shape: {{hoop: R}}, radii: {{rim: R}}, moves: along floor}}}}
      ties:
        - slips: {{body: hoop, on its: rim, mu_s: mu_k, mu_k: mu_k}}
      start: {{hoop: {{speed: v0, spin: w0}}}}
      end: {{rolling: hoop}}
    questions:
      v: {{ask: v, unit: m/s}}
    statement: '{{{{ m }}}} {{{{ R }}}} {{{{ v0 }}}} {{{{ w0 }}}} {{{{ mu_k }}}}'
"
    ))
}

#[test]
fn start_speeds_and_spins_are_drawn_in_the_sense_that_they_have() {
    let words = Words::english();
    for (speed, spin) in [("5", "11"), ("5", "-11"), ("-5", "11"), ("-5", "-11")] {
        let bank = thrown(speed, spin);
        let problem = &bank.problems[0];
        let variant = Maker::new(problem, 1, "sentences").variant("0").unwrap_or_else(|u| panic!("{u}"));
        for labels in [FigureLabels::Values, FigureLabels::Symbols] {
            let picture = figure::scene::picture(problem, &variant, &words, labels);
            let lines = lines_of(&picture);
            let bars = |symbol: &str, text: &str| {
                if text.starts_with('-') { format!("|{symbol}|") } else { symbol.to_owned() }
            };
            for (symbol, text, unit) in [("v_0", speed, "m/s"), ("ω_0", spin, "rad/s")] {
                let size = text.trim_start_matches('-');
                let told = match labels {
                    FigureLabels::Symbols => bars(symbol, text),
                    _ => format!("{} = {size} {unit}", bars(symbol, text)),
                };
                assert_eq!(lines.iter().filter(|l| **l == told).count(), 1, "{told} in {lines:?}");
            }
            assert!(lines.iter().all(|l| !l.contains('−') && !l.contains('-')), "{lines:?}");
            // One coefficient is told once.
            assert_eq!(lines.iter().filter(|l| l.contains("μ_k")).count(), 1, "{lines:?}");
            let right = speed.starts_with('-')
                == (arrows(&picture, Role::Motion)[0].1.0 < arrows(&picture, Role::Motion)[0].0.0);
            assert!(right, "{speed}");
            let turns: Vec<bool> = picture
                .elements
                .iter()
                .filter_map(|s| match s.outline {
                    Outline::Arc { from, to, .. } if s.role == Role::Motion => Some(to > from),
                    _ => None,
                })
                .collect();
            // Forward is to the right, so a positive spin is clockwise.
            assert_eq!(turns, [spin.starts_with('-')], "{spin}");
            let sense = if spin.starts_with('-') { "counter-clockwise" } else { "rad/s clockwise" };
            assert!(picture.desc.contains(sense), "{}", picture.desc);
            assert_eq!(picture.desc.matches("μ_k").count(), 1, "{}", picture.desc);
        }
    }
}

#[test]
fn the_spin_of_a_rigid_body_of_particles_is_drawn_in_its_sense() {
    let words = Words::english();
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == "kinetic-energy").expect("there");
    let maker = Maker::new(problem, 4, "sentences");
    let mut senses = [0, 0];
    for student in 0..40 {
        let variant = maker.variant(&student.to_string()).expect("a variant");
        let at = problem.data.iter().position(|d| d.tex == "\\omega").expect("a spin");
        let negative = variant.data[at] < 0.0;
        let picture = figure::scene::picture(problem, &variant, &words, FigureLabels::Values);
        let turns = picture.elements.iter().filter_map(|s| match s.outline {
            Outline::Arc { from, to, .. } if s.role == Role::Motion => Some(to < from),
            _ => None,
        });
        assert_eq!(turns.collect::<Vec<_>>(), [negative]);
        let lines = lines_of(&picture);
        let start = if negative { "|ω| = " } else { "ω = " };
        assert!(lines.iter().any(|l| l.starts_with(start) && !l.contains('−')), "{lines:?}");
        senses[usize::from(negative)] += 1;
    }
    assert!(senses.iter().all(|n| *n > 3), "{senses:?}");
}

/// The problem of a built-in bank, with one variant.
fn drawn(id: &str) -> (Problem, Variant) {
    let problem = support::banks().into_iter().flat_map(|b| b.problems).find(|p| p.id == id).expect(id);
    let variant = Maker::new(&problem, 5, "sentences").variant("0").unwrap_or_else(|u| panic!("{u}"));
    (problem, variant)
}

/// Where a contact ends both methods are needed, and together they say where in closed form: two thirds of the first cosine or sine.
/// Both pages called energy the short method and gave a number.
#[test]
fn the_place_at_which_a_contact_ends_is_told_in_closed_form() {
    for (id, start) in [("off-a-cylinder", "phi0"), ("sliding-ladder", "theta0")] {
        let (problem, variant) = drawn(id);
        let first = datum(&problem, &variant, start).to_radians();
        let value = if id == "off-a-cylinder" { first.cos() } else { first.sin() } * 2.0 / 3.0;
        let value = slipstick::num::shown::significant(value, 4);
        for language in &languages() {
            let text = solution(&problem, &variant, language).replace("{,}", ".");
            let closed = text.lines().find(|l| l.contains(r"\tfrac{2}{3}")).expect(&text);
            assert!(closed.ends_with(&format!("= {value}$$")), "{closed}");
            assert!(text.contains(language.0.get("solution.title.then_motion")), "{text}");
        }
    }
}

/// A datum that was measured stands for what would be asked otherwise: the formulas are solved backward, not by trial.
#[test]
fn a_measured_datum_is_followed_back() {
    let (problem, variant) = drawn("mass-of-a-stone");
    let of = |symbol| datum(&problem, &variant, symbol);
    let a = 2.0 * of("y") / (of("t1") * of("t1"));
    let mass = slipstick::num::shown::significant(0.5 * of("M") * a / (9.81 - a), 4);
    for language in &languages() {
        let text = solution(&problem, &variant, language).replace("{,}", ".");
        assert!(text.contains(language.0.get("solution.asked.backward")), "{text}");
        let line = text.lines().find(|l| l.starts_with("$$") && l.contains(r"m = \frac{")).expect(&text);
        assert!(line.contains(&format!(r"= {mass}\ \mathrm{{kg}}")), "{line}");
    }
}

/// The unknown that is counted is the one that is asked: where a speed is given, the way.
#[test]
fn the_count_names_what_is_not_given() {
    let lines = bank(include_str!("../support/lines.yaml"));
    let mut seen = [0, 0];
    for problem in lines.problems.iter().chain(support::banks().iter().flat_map(|b| &b.problems)) {
        let given = match problem.cases[0].scene.end {
            End::Speed(..) | End::TurningPoint(_) => 1,
            End::Travel(..) | End::Position(..) => 0,
            _ => continue,
        };
        let variant = Maker::new(problem, 8, "lines").variant("0").unwrap_or_else(|u| panic!("{u}"));
        let text = solution(problem, &variant, &languages()[0]);
        let Some((_, what)) = text.split_once("Count for $") else { continue };
        let what = what.split('$').next().expect("a symbol");
        assert_eq!(
            what.starts_with('v') || what.starts_with(r"\omega"),
            given == 0,
            "{}: {what}",
            problem.id
        );
        seen[given] += 1;
    }
    assert!(seen.iter().all(|n| *n > 0), "{seen:?}");
}

/// Which way a body on a pin sets off is checked where the asked angle is 0 as anywhere else: the moments were taken at that angle,
/// where there are none.
#[test]
fn a_body_that_swings_to_the_lowest_place_is_seen_to_get_there() {
    let text = "
bank: lowest
title: Lowest
problems:
  pendulum:
    title: A pendulum
    data: {m: {name: mass, unit: kg, draw: 1 to 9 step 1}}
    scene:
      bodies: {body: {mass: m, radius of gyration: 0.3 m, pinned: {distance: 0.4 m}, angle: from hanging}}
      start: {body: {angle: 30 deg}}
      end: {angle: {of: body, reaches: 0 deg}}
    questions: {omega: {ask: omega}, t: {ask: time}}
    statement: s
";
    let bank = bank(text);
    let problem = &bank.problems[0];
    let variant = Maker::new(problem, 1, "lowest").variant("0").unwrap_or_else(|u| panic!("{u}"));
    let moment = 9.81 * 0.4 * 0.5 * datum(problem, &variant, "m");
    let told = format!(r"$-{}\ ", slipstick::num::shown::significant(moment, 4));
    for language in &languages() {
        let text = solution(problem, &variant, language).replace("{,}", ".");
        assert!(text.contains(&told), "{told}: {text}");
    }
}

/// A rod that is displaced slightly from upright is not said to be set off by a moment of any size.
#[test]
fn a_body_that_starts_beside_an_equilibrium_is_seen_there() {
    let text = |start: &str| {
        format!(
            "
bank: upright
title: Upright
problems:
  rod:
    title: A rod
    data: {{m: {{name: mass, unit: kg, draw: 1 to 9 step 1}}}}
    scene:
      bodies: {{rod: {{mass: m, shape: {{rod: 1.2 m}}, pinned: at its end, angle: from upright}}}}
      start: {{rod: {{angle: {start} deg}}}}
      end: {{angle: {{of: rod, reaches: 90 deg}}}}
    questions: {{omega: {{ask: omega}}}}
    statement: s
"
        )
    };
    for (start, beside) in [("1", true), ("20", false)] {
        let bank = bank(&text(start));
        let problem = &bank.problems[0];
        let variant = Maker::new(problem, 1, "upright").variant("0").unwrap_or_else(|u| panic!("{u}"));
        for (language, words) in languages().iter().zip(["almost in equilibrium", "fast im Gleichgewicht"]) {
            let text = solution(problem, &variant, language);
            assert_eq!(text.contains(words), beside, "{text}");
        }
    }
}

/// Of several bodies that roll the friction on each is said to do no work, and equal terms are one.
#[test]
fn what_rolls_together_is_told_together() {
    let bank = bank(include_str!("../carried/cart-on-wheels.yaml"));
    let problem = &bank.problems[0];
    let variant = maker::from_values(problem, 0, &support::constants(problem)).expect("solved");
    for language in &languages() {
        let text = solution(problem, &variant, language);
        let said = language.0.get("solution.idea.idle_rolls_all").replace("{force}", "$F_{F}$, $F_{R}$");
        assert!(text.contains(&said), "{said}: {text}");
        assert!(text.contains(r"$$M\,g\,d\,\sin \theta + 2\,m\,g\,d\,\sin \theta = "), "{text}");
    }
}

/// A spring that only pushes does nothing before it is touched: no moment of it is told where the body sets off.
#[test]
fn a_buffer_that_is_not_touched_has_no_moment() {
    let bank = bank(include_str!("../worked/blows-and-rests.yaml"));
    let problem = bank.problems.iter().find(|p| p.id == "rod-on-a-buffer").expect("it is there");
    let variant = Maker::new(problem, 1, "buffer").variant("0").unwrap_or_else(|u| panic!("{u}"));
    let weight = 9.81 * datum(problem, &variant, "m");
    for language in &languages() {
        let text = solution(problem, &variant, language).replace("{,}", ".");
        let (_, holds) = text.split_once(language.0.get("solution.title.holds")).expect("the section");
        let line = holds.lines().next().expect("its sentences");
        // The moment of the weight is at most m g L/2, with L <= 1.2 m.
        for told in line.split('$').filter(|f| f.ends_with(r"\mathrm{N}\,\mathrm{m}")) {
            let moment: f64 = told.split(r"\ ").next().and_then(|n| n.parse().ok()).expect("a number");
            assert!(moment.abs() <= 0.6 * weight, "{moment}: {line}");
        }
    }
}

/// What an impact loses, and what would come out of it without rebound, without loss, with a light and with a heavy body, by hand.
#[test]
fn what_an_impact_loses_is_told_as_it_is() {
    let bank = bank(include_str!("../worked/impacts-and-slots.yaml"));
    let find = |id: &str| bank.problems.iter().find(|p| p.id == id).expect("it is there");
    let (hit, bullet) = (find("ball-and-rod"), find("bullet"));
    let digits = slipstick::num::shown::significant;
    for student in 0..6 {
        let drawn = |problem| Maker::new(problem, 1, "hits").variant(&student.to_string());
        let variant = drawn(hit).unwrap_or_else(|u| panic!("{u}"));
        let [m, rod, l, v, e] = ["m", "M", "L", "v0", "e"].map(|name| datum(hit, &variant, name));
        // Angular momentum about the pin, and restitution.
        let omega = |e: f64| m * v * (1.0 + e) / (l * (rod / 3.0 + m));
        let ball = omega(e) * l - e * v;
        let after = rod * (l * omega(e)).powi(2) / 6.0 + 0.5 * m * ball * ball;
        let lost = digits(100.0 * (1.0 - after / (0.5 * m * v * v)), 2);
        let other = drawn(bullet).unwrap_or_else(|u| panic!("{u}"));
        for language in &languages() {
            let text = solution(hit, &variant, language).replace("{,}", ".");
            for x in [omega(0.0), omega(1.0)] {
                let told = format!(r"${}\ \mathrm{{rad}}/\mathrm{{s}}$", digits(x, 4));
                assert!(text.contains(&told), "{told}: {text}");
            }
            assert!(text.contains(&format!(" {lost} % ")), "{lost}: {text}");
            // A heavy bullet loses what it brings along the rod alone, sin^2 of 30 degrees.
            let text = solution(bullet, &other, language);
            assert!(text.contains(" 100 %") && text.contains(" 25 %"), "{text}");
            // Where it stays it is told by its place on the rod alone.
            assert!(text.contains(r"v_{Bxs} = \omega_{Rs}\,b_{R}$"), "{text}");
            // A light one all but a little: the share that is kept, by the angular momentum about the pin.
            let [m, rod] = ["m", "M"].map(|name| datum(bullet, &other, name));
            let kept = 0.75 * m * 0.75f64.powi(2) / (rod / 3.0 + m * 0.75f64.powi(2));
            let lost =
                language.0.get("solution.impact.lost").replace("{percent}", &digits(100.0 - 100.0 * kept, 3));
            assert!(kept < 0.005 && text.replace("{,}", ".").contains(&lost), "{lost}: {text}");
        }
    }
}

/// Two blocks that meet head on, and rods on a pin that are struck while they turn.
fn brought_to_rest() -> Bank {
    let blocks = "{a: {mass: m, moves: in a horizontal plane, placed: [0 m, 0 m]}, b: {mass: m, moves: in a horizontal plane, placed: [0 m, 0 m]}}";
    let hit = |e: u32, v: u32| {
        format!(
            "scene:
      bodies: {blocks}
      joints: {{hit: {{guides: a, on: b, along: 90 deg, restitution: {e}}}}}
      start: {{a: {{arrives: {{speed: 2 m/s, direction: right}}}}, b: {{arrives: {{speed: {v} m/s, direction: left}}}}}}
      end: at once
    questions: {{v: {{quantity: b.v, ask: v}}, E: {{quantity: kinetic_energy, ask: E}}}}"
        )
    };
    let swings = "scene:
      bodies: {a: {mass: 2 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}, b: {mass: m, shape: {rod: 0.5 m}, moves: in the plane}}
      joints: {O: {pins: a.A}, W: {welds: [a.B, b.A]}}
      forces: [impulse: {on: b.B, magnitude: 1.4 N*s, direction: left}]
      start: {a: {angle: 0 deg, spin: 2 rad/s}}
      end: at once
    questions: {w: {quantity: a.omega, ask: w}, E: {quantity: kinetic_energy, ask: E}}";
    let problem = |id: &str, scene: &str| {
        format!(
            "  {id}:\n    title: P\n    statement: x\n    data: {{m: {{name: m, unit: kg, draw: always 1}}}}\n    {scene}\n"
        )
    };
    let alike = "scene:
      bodies: {a: {mass: 4 kg, shape: {rod: 1 m}, moves: in a horizontal plane, angle: from right, placed: [0 m, 0 m]}, b: {mass: m, moves: in a horizontal plane}}
      joints: {K: {welds: [a.B, b]}}
      start: {a: {angle: 0 deg, arrives: {speed: 2 m/s, direction: up}}, b: {arrives: {speed: 2 m/s, direction: up}}}
      end: at once
    questions: {v: {quantity: b.v, ask: v}}";
    let double = "scene:
      bodies: {a: {mass: 4 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}, b: {mass: 2 kg, shape: {rod: 1 m}, moves: in the plane, angle: from hanging}, bullet: {mass: m, moves: in the plane}}
      joints: {O: {pins: a.A}, H: {hinges: [a.B, b.A]}, K: {welds: [b.B, bullet]}}
      start: {a: {angle: 0 deg}, b: {angle: 0 deg}, bullet: {arrives: {speed: 3 m/s, direction: right}}}
      end: at once
    questions: {w: {quantity: b.omega, ask: w}}";
    let edge = "scene:
      bodies: {rod: {mass: m, shape: {rod: 1 m}, moves: in the plane, angle: from right}}
      joints: {O: {pins: rod.A}}
      start: {rod: {angle: 0 deg, arrives: {speed: 3 m/s, direction: down}}}
      end: at once
    questions: {w: {quantity: omega, ask: w}, E: {quantity: kinetic_energy, ask: E}}";
    let all = [
        ("double", double.to_owned()),
        ("edge", edge.to_owned()),
        ("alike", alike.to_owned()),
        ("soft", hit(0, 2)),
        ("hard", hit(1, 0)),
        ("swings", swings.to_owned()),
    ];
    let all: String = all.iter().map(|(id, scene)| problem(id, scene)).collect();
    bank(&format!("bank: b\ntitle: B\nproblems:\n{all}"))
}

/// What comes to rest in an impact is told like every other velocity, with the equations that say so, and no velocity for an energy; what
/// a blow changes is added to what there was. What two equations give has no fraction in a fraction, and one quantity has one name.
#[test]
fn what_an_impact_brings_to_rest_is_told() {
    for problem in &brought_to_rest().problems {
        let variant = maker::from_values(problem, 0, &support::constants(problem)).expect("solved");
        for language in &languages() {
            let text = solution(problem, &variant, language).replace("{,}", ".");
            let told: &[&str] = match problem.id.as_str() {
                "alike" => &[language.0.get("solution.impact.kept_joined")],
                "soft" => &[
                    r"$0 = m\,v_{Axs} + m\,v_{Bxs}$",
                    r"$v_{Axs} = 0\ \mathrm{m}/\mathrm{s}",
                    r"$E_s = 0\ \mathrm{J}$",
                    r"\Delta E = E_0 - E_s = 4.000\ ",
                ],
                // By the impulses that belong to both angles: (13/3, 2; 2, 5/3) times the angular speeds is (3, 3).
                "double" => &[r"\omega_{bs} = \frac{6\,m\,v_0\,(", r")} = 2.172"],
                "edge" => {
                    &[r"$\left|\omega_{s}\right| = 4.50", r"E_s = \tfrac{1}{2}\,I_A\,\omega_{s}^{2} = 3.375"]
                }
                "hard" => &[r"v_0\,(1 - e) = 0\ \mathrm{m}/\mathrm{s}", r"v_{Bxs} = v_{Axs} + ", "= 2.000"],
                _ => &[r"+ \omega_{A\Delta} = 1.067\ \mathrm{rad}/\mathrm{s}"],
            };
            for told in told {
                assert!(text.contains(told), "{told}: {text}");
            }
            let line = text.lines().find(|line| line.contains(r"\omega_{bs} = \frac")).unwrap_or_default();
            let whole = line.split(r"\omega_{bs} = ").nth(1).and_then(|l| l.split(" = ").next());
            assert!(whole.is_none_or(|whole| whole.matches(r"\frac").count() == 1), "{line}");
            assert!(problem.id != "edge" || !text.contains("E_{k}") && !text.contains(r"\omega ="), "{text}");
            // One quantity has one unit.
            assert!(!text.contains(r"\mathrm{m}/\mathrm{s} = 0\ \mathrm{J}"), "{text}");
        }
    }
}

/// What turns on the spot hangs on an angular acceleration, which a line gives before it is used; and the work of friction needs what
/// presses, no force of a pin.
#[test]
fn what_turns_on_the_spot_has_its_acceleration_from_a_line() {
    let bank = bank(include_str!("../worked/impacts-and-slots.yaml"));
    let problem = bank.problems.iter().find(|p| p.id == "brake").expect("it is there");
    let variant = Maker::new(problem, 1, "brakes").variant("0").unwrap_or_else(|u| panic!("{u}"));
    for language in &languages() {
        let text = solution(problem, &variant, language);
        let needs = language.0.get("solution.joined.why_in_place").replace("{forces}", "$N$");
        assert!(text.contains(&needs), "{needs}: {text}");
        let [line, used] =
            [r"\alpha_{D} = -\frac{2\,\mu\,N", r"\Delta \phi = -\frac"].map(|of| text.find(of));
        assert!(line.is_some() && line < used, "{line:?} {used:?}: {text}");
        // The moment of friction about the axis of the cylinder has its radius for an arm.
        assert!(text.contains(r"-\mu\,N\,R = \tfrac{1}{2}\,m_{D}\,R^{2}\,\alpha_{D}"), "{text}");
    }
}

/// How an impact is told is what its equations are: the directions of the indices, whether unknown impulses are in all equations, and
/// no question about what has been printed.
#[test]
fn an_impact_says_what_its_equations_are() {
    let bank = bank(include_str!("../worked/impacts-and-slots.yaml"));
    for (id, said, unsaid) in [
        ("pucks", &["directions", "idea_free", "onward"][..], &["idea_each", "onward_soft"][..]),
        ("jerked", &["idea_each", "stays"], &["idea_free", "onward_stays"]),
        ("clutch", &["idea_free", "idea_stays"], &["onward_stays"]),
        ("bullet", &["idea_free", "idea_stays"], &["idea_each"]),
    ] {
        let problem = bank.problems.iter().find(|p| p.id == id).expect("it is there");
        let variant = Maker::new(problem, 1, "told").variant("0").unwrap_or_else(|u| panic!("{u}"));
        for language in &languages() {
            let text = solution(problem, &variant, language).replace("{,}", ".");
            let sentence = |name: &&str| {
                let [t, n] = [0.0, 90.0].map(|more| match id {
                    "pucks" => slipstick::num::shown::significant(datum(problem, &variant, "t") + more, 4),
                    _ => String::new(),
                });
                let phrase = language.0.get(&format!("solution.impact.{name}"));
                phrase.replace("{t}", &format!(r"${t}^\circ$")).replace("{n}", &format!(r"${n}^\circ$"))
            };
            said.iter().map(sentence).for_each(|s| assert!(text.contains(&s), "{s}: {text}"));
            unsaid.iter().map(sentence).for_each(|s| assert!(!text.contains(&s), "{s}: {text}"));
            // An angle that is 0 and stands in no equation is not told.
            assert!(!text.contains(r"\beta = 0"), "{text}");
        }
    }
}

/// The friction that rolling needs, and whether there is as much, is told once, whether it rolls or slips.
#[test]
fn whether_it_could_roll_is_told_once() {
    let banks = support::banks();
    let problem = banks.iter().flat_map(|b| &b.problems).find(|p| p.id == "spool-on-the-floor");
    let problem = problem.expect("it is built in");
    let maker = Maker::new(problem, 1, "spools");
    let mut seen = [0, 0];
    for student in 0..20 {
        let variant = maker.variant(&student.to_string()).unwrap_or_else(|u| panic!("{u}"));
        seen[variant.case] += 1;
        for language in &languages() {
            let text = solution(problem, &variant, language);
            assert_eq!(text.matches(language.0.get("solution.title.rolled")).count(), 1, "{text}");
        }
    }
    assert!(seen.iter().all(|n| *n > 0), "{seen:?}");
}

/// An answer in degrees stands beside the radians of the formulas.
#[test]
fn an_answer_in_degrees_is_told_in_radians_too() {
    let (problem, variant) = drawn("off-a-cylinder");
    let text = solution(&problem, &variant, &languages()[0]);
    let answer =
        text.lines().find(|l| l.starts_with("> ")).and_then(|l| l.split(" · ").next()).expect("answers");
    assert!(answer.contains(r"\mathrm{rad} = ") && answer.ends_with(r"^\circ$"), "{answer}");
}

/// A wheel that is pulled on a level, by a cord at the bottom or at the top of its hub; `r R = k^2` where the radii are so.
fn pulled(leaves: &str, hub: &str, on: &str, slope: &str) -> Bank {
    bank(&format!(
        "
bank: pulled
title: Pulled
problems:
  wheel:
    title: A wheel
    data:
      m: {{name: mass, unit: kg, draw: always 20}}
      R: {{name: rim, unit: m, draw: always 0.48}}
      r: {{name: hub, unit: m, draw: always {hub}}}
      k: {{name: radius of gyration, unit: m, draw: always 0.24}}
      P: {{name: pull, unit: N, draw: always 90}}
      d: {{name: distance, unit: m, draw: always 2}}
    scene:
      surfaces: {{floor: {slope}}}
      bodies: {{wheel: {{mass: m, radius of gyration: k, radii: {{rim: R, hub: r}}, moves: along floor}}}}
      ties:
        - rolls: {{body: wheel, on its: rim}}
        - cord: {{from: {{body: wheel, wound on: {on}, leaves: {leaves}}}, pulled with: P}}
      start: at rest
      end: {{travel: {{of: wheel, by: d}}}}
    questions:
      v: {{ask: v, unit: m/s}}
      friction: {{ask: F, unit: N}}
    statement: '{{{{ m }}}} {{{{ R }}}} {{{{ r }}}} {{{{ k }}}} {{{{ P }}}} {{{{ d }}}}'
"
    ))
}

/// The share of a pull in the friction changes its sign only where it is a difference, and where this is 0 it points nowhere. A pull
/// below the centre pushes friction back at every radius of gyration; the text said that it changes.
#[test]
fn the_share_of_a_pull_in_friction_is_read_by_its_sign() {
    // At the top of the hub friction is in proportion to r R - k^2, at the bottom to -(r R + k^2).
    for (leaves, hub, slope, says) in [
        ("top forward", 0.12, 10.0f64, "none"),
        ("top forward", 0.24, 0.0, "changes"),
        ("bottom forward", 0.24, 0.0, "force"),
    ] {
        let incline = if slope == 0.0 { "level".to_owned() } else { format!("{{slope: {slope} deg}}") };
        let bank = pulled(leaves, &hub.to_string(), "hub", &incline);
        let problem = &bank.problems[0];
        let variant = Maker::new(problem, 1, "pulled").variant("0").unwrap_or_else(|u| panic!("{u}"));
        let sign =
            if leaves.starts_with("top") { hub * 0.48 - 0.24 * 0.24 } else { -hub * 0.48 - 0.24 * 0.24 };
        let weight = 20.0 * 9.81 * slope.to_radians().sin() * 0.24 * 0.24;
        let friction = (90.0 * sign + weight) / (0.48f64.powi(2) + 0.24f64.powi(2));
        let key = make_key::key(problem, &variant);
        let slipstick::key::Answer::Number { value, .. } = key.parts[1].answer else { panic!("a number") };
        assert!((value - friction).abs() < 1e-12, "{value} {friction}");
        for language in &languages() {
            let text = solution(problem, &variant, language);
            for name in ["none", "changes", "force"] {
                // The end of the sentence: what stands before it hangs on the forces.
                let phrase = language.0.get(&format!("solution.friction.{name}"));
                let end =
                    phrase.rsplit("{factor}").next().expect("a part").split('{').next().expect("a part");
                let end = if name == "force" { phrase.rsplit("{way}").next().expect("a part") } else { end };
                assert_eq!(text.contains(end), name == says, "{leaves} {hub} {name}: {end}\n{text}");
            }
            assert!(!text.contains(" points .") && !text.contains(" zeigt ."), "{text}");
        }
    }
}

/// No pull holds a wheel at rest on level ground, nor one that pulls it down the incline.
#[test]
fn a_pull_is_asked_to_hold_a_wheel_only_where_it_can() {
    let incline = "{slope: 20 deg}";
    for (leaves, slope, holds) in
        [("top forward", "level", false), ("top forward", incline, true), ("top back", incline, false)]
    {
        let bank = pulled(leaves, "0.40", "hub", slope);
        let problem = &bank.problems[0];
        let variant = Maker::new(problem, 1, "pulled").variant("0").unwrap_or_else(|u| panic!("{u}"));
        for language in &languages() {
            let text = solution(problem, &variant, language);
            let asked = text.contains(language.0.get("solution.onward.pulled"));
            assert_eq!(asked, holds, "{leaves} {slope}: {text}");
        }
    }
}

/// Nothing happens at a time where nobody asks for it: the spool that rolls or slips is looked at as it starts.
#[test]
fn what_is_asked_at_the_start_has_no_time() {
    let (problem, _) = drawn("spool-on-the-floor");
    let maker = Maker::new(&problem, 7, "spools");
    let mut seen = [false; 2];
    for student in 0..30 {
        let variant = maker.variant(&student.to_string()).unwrap_or_else(|u| panic!("{u}"));
        let of = |symbol| datum(&problem, &variant, symbol);
        let needed =
            of("P") * (0.5 * of("R") * of("R") + of("k") * of("k")) / (of("R").powi(2) + of("k").powi(2));
        let rolls = needed <= of("mu_s") * of("m") * 9.81;
        seen[usize::from(rolls)] = true;
        for language in &languages() {
            let text = solution(&problem, &variant, language);
            let idea = language.0.say("solution.idea.which", &[("mu", r"\mu_k")]);
            assert!(text.contains(&idea), "{text}");
            for name in ["title.slip_energy", "title.instant", "motion.spin_of_slip"] {
                assert!(!text.contains(language.0.get(&format!("solution.{name}"))), "{name}: {text}");
            }
            assert!(!text.contains(r"2\ \mathrm{s}"), "{text}");
        }
    }
    assert_eq!(seen, [true, true]);
}

/// An index goes into the one that stands there: LaTeX refuses two in a row.
#[test]
fn a_force_that_grows_from_a_datum_with_an_index_has_one_index() {
    let text = "
bank: grows
title: Grows
problems:
  drum:
    title: A drum
    data:
      I: {name: inertia, unit: kg m^2, draw: always 2}
      c: {name: rate, unit: N m/s, draw: always 3}
      M_0: {name: couple at the start, unit: N m, draw: always 4}
      t1: {name: time, unit: s, draw: always 2}
    scene:
      bodies: {drum: {moment of inertia: I, radii: {rim: 0.2 m}, moves: about a fixed axle}}
      forces: [couple: {on: drum, moment: M_0, growing by: c}]
      start: at rest
      end: {time: {of: drum, is: t1}}
    questions: {omega: {ask: w, unit: rad/s}}
    statement: '{{ I }} {{ c }} {{ M_0 }} {{ t1 }}'
";
    let bank = bank(text);
    let problem = &bank.problems[0];
    let variant = Maker::new(problem, 1, "grows").variant("0").unwrap_or_else(|u| panic!("{u}"));
    for language in &languages() {
        let text = solution(problem, &variant, language);
        assert!(text.contains("M_{1} = M_0 + c\\,t_1"), "{text}");
        assert!(!text.contains("_0_"), "{text}");
    }
}

/// A wheel on a rack touches it with its own radius, also in the free body, where the forces of the rack act on its circle; a body
/// that leaves a surface is drawn where it leaves it, with the force that ends there.
#[test]
fn free_bodies_stand_as_the_bodies_do() {
    let english = Words::english();
    let circles = |picture: &Picture| {
        let round = picture.elements.iter().filter_map(|e| match e.outline {
            Outline::Circle { centre, radius } if e.role == Role::Body && radius > 9.5 => {
                Some((centre, radius))
            }
            _ => None,
        });
        round.collect::<Vec<_>>()
    };
    let (problem, variant) = drawn("gear-on-a-rack");
    let forces = figure::forces::free_body(&problem, &variant, &english, 0);
    let scene = figure::scene::picture(&problem, &variant, &english, FigureLabels::Symbols);
    for (picture, count) in [(&forces, 2), (&scene, 1)] {
        let found = circles(picture);
        assert_eq!(found.len(), count, "{found:?}");
        for (centre, radius) in found {
            let level = |e: &&slipstick::picture::Element| match &e.outline {
                Outline::Lines { points, .. }
                    if matches!(e.role, Role::Ghost | Role::Ground) && points.len() == 2 =>
                {
                    (points[0].y - points[1].y).abs() < 1e-9
                        && (points[0].x - points[1].x).abs() > radius
                        && ((points[0].y - centre.y).abs() - radius).abs() < 1e-6
                }
                _ => false,
            };
            assert!(picture.elements.iter().any(|e| level(&e)), "no rack at {radius}");
        }
    }
    for (id, label) in [("off-a-cylinder", "N = 0"), ("sliding-ladder", "N_B = 0")] {
        let (problem, variant) = drawn(id);
        let picture = figure::forces::free_body(&problem, &variant, &english, 0);
        assert!(lines_of(&picture).iter().any(|l| l == label), "{:?}", lines_of(&picture));
        if id == "off-a-cylinder" {
            // Its side lies along the cylinder there, two thirds of the first cosine away from the top.
            let cos = 2.0 / 3.0 * datum(&problem, &variant, "phi0").to_radians().cos();
            let body = picture.elements.iter().find_map(|e| match &e.outline {
                Outline::Lines { points, closed: true } if e.role == Role::Body => Some(points.clone()),
                _ => None,
            });
            let points = body.expect("a block");
            let side = points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| *b - *a);
            let long = side.max_by(|a, b| a.norm().total_cmp(&b.norm())).expect("a side");
            assert!((long.x.abs() / long.norm() - cos).abs() < 1e-6, "{long:?} {cos}");
        }
    }
}
