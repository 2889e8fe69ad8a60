//! Pictures over the whole range of draws: labels apart and inside, shapes inside, every datum told, forces that add up, energies
//! that are equal, files that parse. A few goldens: `RENEW_GOLDENS=1 cargo test --test pages figures` writes them anew.
use crate::support;
use slipstick::bank::{Bank, FigureLabels, load};
use slipstick::figure;
use slipstick::picture::frame::Frame;
use slipstick::picture::vector::{Vec2, vec2};
use slipstick::picture::{Element, Outline, Picture, Role, svg, symbol};
use slipstick::problem::maker::{Maker, Variant};
use slipstick::scene::{End, Quantity};
use slipstick::words::Words;

/// Scenes that no bank of the project has: what an instructor may write besides.
const ODD: &str = include_str!("../support/odd-scenes.yaml");

fn odd() -> Bank {
    load::scenes_only(ODD, "odd").unwrap_or_else(|f| panic!("{f:?}"))
}

/// Scenes of textbooks: banks of one problem each.
fn textbook() -> Vec<Bank> {
    let in_folder = |name: &str| {
        let folder = format!("{}/tests/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_dir(folder).expect("scenes").map(|f| f.expect("a file").path())
    };
    let mut files: Vec<_> = ["scenes", "carried"].into_iter().flat_map(in_folder).collect();
    files.sort();
    let read = |file: &std::path::PathBuf| {
        let text = std::fs::read_to_string(file).expect("a bank is text");
        load::scenes_only(&text, &file.display().to_string()).unwrap_or_else(|f| panic!("{f:?}"))
    };
    files.iter().map(read).collect()
}

pub fn all_text(picture: &Picture) -> String {
    picture.labels.iter().map(|l| symbol::plain(&l.runs) + "\n").collect()
}

/// Corners of an outline, enough of them to know where it is.
pub fn corners(outline: &Outline) -> Vec<Vec2> {
    match outline {
        Outline::Lines { points, .. } => points.clone(),
        Outline::Circle { centre, radius: r } => vec![*centre - vec2(*r, *r), *centre + vec2(*r, *r)],
        Outline::Arc { centre, radius, from, to } => (0..=12)
            .map(|i| svg::on_arc(*centre, *radius, from + (to - from) * f64::from(i) / 12.0))
            .collect(),
        Outline::Arcs(arcs) => {
            let on = |(c, r, from, to): &(Vec2, f64, f64, f64)| {
                let at = |i: i32| svg::on_arc(*c, *r, from + (to - from) * f64::from(i) / 12.0);
                (0..=12).map(at).collect::<Vec<_>>()
            };
            arcs.iter().flat_map(on).collect()
        }
    }
}

/// Boxes apart and inside, shapes inside, numbers finite.
fn check(picture: &Picture, what: &str) {
    let inside = |x: f64, y: f64| {
        x.is_finite() && y.is_finite() && x >= 0.0 && y >= 0.0 && x <= picture.width && y <= picture.height
    };
    assert!(
        picture.width < 900.0 && picture.height < 700.0,
        "{what}: {} x {}",
        picture.width,
        picture.height
    );
    assert!(!picture.title.is_empty() && !picture.desc.is_empty(), "{what}");
    for place in ["{", "NaN", "inf"] {
        assert!(!picture.desc.contains(place), "{what}: {}", picture.desc);
    }
    for element in &picture.elements {
        for p in corners(&element.outline) {
            assert!(inside(p.x, p.y), "{what}: {element:?} leaves the picture");
        }
    }
    for (i, a) in picture.labels.iter().enumerate() {
        let Frame { low, high } = a.bounds;
        let text = symbol::plain(&a.runs);
        let within = inside(low.x, low.y) && inside(high.x, high.y) && low.x < high.x && low.y < high.y;
        assert!(within, "{what}: {text} is outside");
        assert!(a.size >= 12.0, "{what}: {text} is small");
        assert!((high.x - low.x) + 1e-9 >= symbol::width(&a.runs, a.size), "{what}: {text} leaves its box");
        for b in &picture.labels[i + 1..] {
            let g = b.bounds;
            let apart = high.x <= g.low.x || g.high.x <= low.x || high.y <= g.low.y || g.high.y <= low.y;
            assert!(apart, "{what}: {text} covers {}", symbol::plain(&b.runs));
        }
    }
}

/// Lines that run through a full point, such as the mark of the mass centre; those that begin or end there belong to it, and so do
/// bodies and brackets.
fn through_a_mark(picture: &Picture) -> Vec<String> {
    let mut found = Vec::new();
    for mark in picture.elements.iter().filter(|e| e.role == Role::Dot) {
        let Outline::Circle { centre: mark, radius: size } = mark.outline else { continue };
        // What is drawn before the body that it is on does not show.
        let on = |e: &Element| {
            e.role == Role::Body && Frame::round(corners(&e.outline)).is_some_and(|f| f.nearest(mark) == mark)
        };
        let from = picture.elements.iter().rposition(on).unwrap_or(0);
        let own = |r: Role| matches!(r, Role::Grid | Role::Paper | Role::Dot | Role::Body | Role::Inner);
        for element in picture.elements[from..].iter().filter(|e| !own(e.role)) {
            let crossed = match &element.outline {
                Outline::Circle { centre, radius } => ((mark - *centre).norm() - radius).abs() < size,
                outline => {
                    let mut points = corners(outline);
                    if matches!(outline, Outline::Lines { closed: true, .. } | Outline::Arcs(_)) {
                        points.extend(points.first().copied());
                    }
                    let ends = points.iter().any(|p| (*p - mark).norm() < size);
                    let near = |w: &[Vec2]| {
                        let along = w[1] - w[0];
                        let share = ((mark - w[0]).dot(&along) / along.dot(&along).max(1e-9)).clamp(0.0, 1.0);
                        (w[0] + along * share - mark).norm() < size
                    };
                    !ends && points.windows(2).any(near)
                }
            };
            if crossed {
                found.push(format!("{mark:?} is on {element:?}"));
            }
        }
    }
    found
}

/// Where the letter of the mass centre stands on a line.
fn on_a_line(picture: &Picture) -> Vec<String> {
    let mut found = Vec::new();
    for label in picture.labels.iter().filter(|l| symbol::plain(&l.runs) == "G") {
        for element in picture.elements.iter().filter(|e| !matches!(e.role, Role::Grid | Role::Paper)) {
            let mut points = corners(&element.outline);
            let crossed = match &element.outline {
                Outline::Circle { centre, radius } => {
                    let near = (label.bounds.nearest(*centre) - *centre).norm();
                    near <= *radius && label.bounds.farthest(*centre) >= *radius
                }
                outline => {
                    if matches!(outline, Outline::Lines { closed: true, .. } | Outline::Arcs(_)) {
                        points.extend(points.first().copied());
                    }
                    points.windows(2).any(|w| label.bounds.meets(w[0], w[1]))
                }
            };
            if crossed {
                found.push(format!("G stands on {element:?}"));
            }
        }
    }
    found
}

/// Labels that lie on a cord, a spring, an arrow of a force or motion.
fn covering(picture: &Picture) -> usize {
    let strong = |r: Role| {
        matches!(r, Role::Cord | Role::Spring | Role::Force | Role::Friction | Role::Motion | Role::Curve(_))
    };
    let lines = picture.elements.iter().filter(|s| strong(s.role));
    let points: Vec<Vec2> = lines
        .flat_map(|s| {
            let ends = corners(&s.outline);
            let between = |w: &[Vec2]| -> Vec<Vec2> {
                (0..=20).map(|i| w[0] + (w[1] - w[0]) * (f64::from(i) / 20.0)).collect()
            };
            if matches!(s.outline, Outline::Circle { .. }) {
                Vec::new()
            } else {
                ends.windows(2).flat_map(between).collect()
            }
        })
        .collect();
    let covers =
        |f: Frame| points.iter().any(|p| p.x > f.low.x && p.x < f.high.x && p.y > f.low.y && p.y < f.high.y);
    picture.labels.iter().filter(|l| covers(l.bounds)).count()
}

#[test]
fn labels_of_scenes_are_apart_and_inside_over_the_whole_range_of_draws() {
    let languages: Vec<Words> = Words::languages().map(|l| Words::of(l).expect("built in")).collect();
    let (mut pictures, mut labels, mut covered) = (0, 0, 0);
    let mut letters = Vec::new();
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 1, "figures");
            for student in 0..100 {
                let variant = maker.variant(&student.to_string()).expect("satisfiable");
                for words in &languages {
                    for kind in [FigureLabels::Values, FigureLabels::Symbols] {
                        let picture = figure::scene::picture(problem, &variant, words, kind);
                        check(&picture, &format!("{} {student} {} {kind:?}", problem.id, words.language()));
                        let crossed = [on_a_line(&picture), through_a_mark(&picture)].concat();
                        letters
                            .extend(crossed.iter().map(|f| format!("{} {student} {kind:?} {f}", problem.id)));
                        covered += covering(&picture);
                        labels += picture.labels.len();
                        pictures += 1;
                    }
                }
            }
        }
    }
    assert!(pictures >= 5000, "{pictures}");
    let share = covered as f64 / labels as f64;
    assert!(letters.is_empty(), "{} of {pictures}: {}", letters.len(), letters.join("\n"));
    assert!(share < 0.01, "{covered} of {labels} labels lie on a cord, a spring or an arrow");
}

#[test]
fn every_picture_of_a_solution_is_drawn_well() {
    let words = Words::of("de").expect("built in");
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 2, "figures");
            for student in 0..12 {
                let variant = maker.variant(&student.to_string()).expect("satisfiable");
                for (name, picture) in figure::all(problem, &variant, &words) {
                    check(&picture, &format!("{} {student} {name}", problem.id));
                    let noise = name == "graph-speed" && picture.desc.contains("0,0000");
                    assert!(!noise, "{} {student}: {}", problem.id, picture.desc);
                    if name.starts_with("forces-") {
                        // Either the arrows are to scale, or both the picture and its words say that they are not.
                        let caption = words.get("figure.forces.caption").replace(' ', "\u{a0}");
                        let told = picture.desc.contains(words.get("figure.forces.free"));
                        assert_eq!(all_text(&picture).contains(&caption), told, "{} {name}", problem.id);
                    }
                }
            }
        }
    }
}

#[test]
fn scenes_of_textbooks_and_odd_ones_are_drawn_too() {
    let words = Words::english();
    let mut drawn = 0;
    for bank in textbook().into_iter().chain([odd()]) {
        for problem in &bank.problems {
            // Some of them have answers that their data hardly determine: no draw, no picture.
            let Ok(variant) = Maker::new(problem, 1, "figures").giving_up_after(1).variant("0") else {
                continue;
            };
            drawn += 1;
            for (name, picture) in figure::all(problem, &variant, &words) {
                check(&picture, &format!("{} {name}", problem.id));
            }
        }
    }
    assert!(drawn >= 30, "{drawn}");
}

#[test]
fn every_datum_of_the_scene_is_in_its_picture() {
    // Told by the statement alone: where the direction is asked, how long it takes, how fast g is.
    let hidden = [
        ("spring-released", "D"),
        ("two-loads-on-a-stepped-drum", "d"),
        ("wheel-set-down", "t1"),
        ("mass-of-a-stone", "t1"),
        ("inertia-about-the-pin", "k_O"),
        ("", "g"),
    ];
    for language in Words::languages() {
        let words = Words::of(language).expect("built in");
        for problem in support::banks().iter().flat_map(|b| &b.problems).filter(|p| p.id != "kinetic-energy")
        {
            let maker = Maker::new(problem, 3, "figures");
            for student in 0..10 {
                let variant = maker.variant(&student.to_string()).expect("satisfiable");
                let values =
                    all_text(&figure::scene::picture(problem, &variant, &words, FigureLabels::Values));
                let symbols =
                    all_text(&figure::scene::picture(problem, &variant, &words, FigureLabels::Symbols));
                for (datum, drawn) in problem.data.iter().zip(&variant.values) {
                    let Some(drawn) = drawn else { continue };
                    let told_elsewhere =
                        hidden.iter().any(|(p, s)| (p.is_empty() || *p == problem.id) && *s == datum.symbol);
                    // What is 0 at the start has no arrow.
                    if told_elsewhere || drawn.value == 0 {
                        continue;
                    }
                    let symbol = symbol::plain(&symbol::symbol(&datum.tex));
                    // An arrow shows the sense of what is negative, its label the size.
                    let symbol = if drawn.value < 0 { format!("|{symbol}|") } else { symbol };
                    let value = words.number(drawn.text().trim_start_matches('-'));
                    let label = format!("{symbol}\u{a0}=\u{a0}{value}");
                    let times = values.lines().filter(|l| l.starts_with(&label)).count();
                    assert_eq!(times, 1, "{} {student}: {label} in {values}", problem.id);
                    assert!(
                        symbols.lines().any(|l| l == symbol),
                        "{} {student}: {symbol} in {symbols}",
                        problem.id
                    );
                }
                assert!(!symbols.contains('='), "{}: {symbols}", problem.id);
            }
        }
    }
}

#[test]
fn pictures_of_statements_give_no_answer_away() {
    let words = Words::english();
    for bank in support::banks() {
        for problem in &bank.problems {
            let variant = Maker::new(problem, 4, "figures").variant("0").expect("satisfiable");
            let before = figure::scene::picture(problem, &variant, &words, FigureLabels::Values);
            // Whatever is asked: with every asked quantity's sign turned round, the picture is the same.
            let mut other = variant.clone();
            for entry in &mut other.solved.entries {
                entry.eom = entry.eom.map(|x| -3.0 * x);
                entry.energy = entry.energy.map(|x| -3.0 * x);
            }
            let after = figure::scene::picture(problem, &other, &words, FigureLabels::Values);
            assert_eq!(before, after, "{}", problem.id);
        }
    }
}

#[test]
fn forces_add_up_to_mass_times_acceleration() {
    let words = Words::english();
    let mut bodies = 0;
    let banks = support::banks().into_iter().chain(textbook()).chain([odd()]);
    for problem in banks.flat_map(|b| b.problems) {
        let maker = Maker::new(&problem, 5, "figures").giving_up_after(50);
        for student in 0..10 {
            let Ok(variant) = maker.variant(&student.to_string()) else { continue };
            let scene = &problem.cases[variant.case].scene;
            for (i, body) in scene.bodies.iter().enumerate() {
                if !figure::forces::known(&problem, &variant, i) || matches!(scene.end, End::AtOnce) {
                    continue;
                }
                let Some((acting, made)) = figure::forces::resultants(&problem, &variant, &words, i) else {
                    panic!("{}: {} has no diagram", problem.id, body.name);
                };
                bodies += 1;
                let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * acting.size;
                let what = format!("{} {student} {}: {acting:?} {made:?}", problem.id, body.name);
                assert!(near(acting.force.x, made.force.x) && near(acting.force.y, made.force.y), "{what}");
                if body.turns {
                    assert!(near(acting.moment, made.moment), "{what}");
                }
            }
        }
    }
    assert!(bodies > 150, "{bodies}");
}

#[test]
fn energy_bars_are_equally_high() {
    let words = Words::english();
    let mut drawn = 0;
    for problem in support::banks().iter().flat_map(|b| &b.problems).chain(&odd().problems) {
        let maker = Maker::new(problem, 6, "figures").giving_up_after(50);
        for student in 0..20 {
            let Ok(variant) = maker.variant(&student.to_string()) else { continue };
            let scene = &problem.cases[variant.case].scene;
            if matches!(scene.end, End::AtOnce) || scene.formulas.found.is_some() {
                continue;
            }
            let energies = figure::bars::energies(problem, &variant, &words)
                .unwrap_or_else(|| panic!("{} {student}: no energies", problem.id));
            let (a, b) = energies.sums();
            assert!((a - b).abs() <= 1e-6 * a, "{} {student}: {energies:?}", problem.id);
            drawn += 1;
        }
    }
    assert!(drawn > 250, "{drawn}");
}

/// A quantity of a variant by its name.
fn quantity(variant: &Variant, quantity: Quantity) -> f64 {
    let entry = variant.solved.entries.iter().find(|e| e.label.quantity == quantity);
    entry.map_or(f64::NAN, |e| e.value())
}

#[test]
fn curves_of_the_spring_meet_what_the_solver_says() {
    let problem = support::banks().into_iter().flat_map(|b| b.problems).find(|p| p.id == "spring-released");
    let problem = problem.expect("the spring scene");
    let maker = Maker::new(&problem, 7, "figures");
    for student in 0..12 {
        let variant = maker.variant(&student.to_string()).expect("satisfiable");
        let curves = figure::graph::spring_curves(&problem, &variant).expect("curves");
        let (v_max, at) = (quantity(&variant, Quantity::VMax), quantity(&variant, Quantity::DAtVMax));
        let turn = quantity(&variant, Quantity::DTurn);
        let close = |a: f64, b: f64, scale: f64| (a - b).abs() <= 0.03 * scale;
        let read = |points: &[(f64, f64)], x: f64| {
            let w = points.windows(2).find(|w| w[0].0 <= x && x <= w[1].0).expect("inside");
            w[0].1 + (w[1].1 - w[0].1) * (x - w[0].0) / (w[1].0 - w[0].0)
        };
        assert!(curves.speed.len() > 25, "{}", curves.speed.len());
        let (first, last) = (curves.speed[0], curves.speed[curves.speed.len() - 1]);
        assert!(first.0 < 1e-5 * turn && first.1 < 0.01 * v_max, "starts at rest: {first:?}");
        assert!(close(last.0, turn, turn) && last.1 < 0.01 * v_max, "ends at the turning point: {last:?}");
        assert!(close(read(&curves.speed, at), v_max, v_max));
        assert!(curves.speed.iter().all(|p| p.1 <= v_max * (1.0 + 1e-9)));
        assert!(close(read(&curves.speed, curves.asked), quantity(&variant, Quantity::V), v_max));
        let friction = quantity(&variant, Quantity::Friction);
        let largest = curves.friction.iter().map(|p| p.1.abs()).fold(0.0, f64::max);
        assert!(close(read(&curves.friction, curves.asked), friction, largest));
        // The largest friction of the curve is the one that the least coefficient has to hold.
        let needed = quantity(&variant, Quantity::MuRequired) * quantity(&variant, Quantity::Normal);
        assert!(close(largest, needed, needed), "{largest} {needed}");
        assert!(curves.limit.expect("a limit") > largest);
    }
}

/// Element names and attributes of a well-formed XML text; panics where it is not.
fn parse(xml: &str) -> Vec<(String, Vec<(String, String)>)> {
    let (mut open, mut found): (Vec<String>, _) = (Vec::new(), Vec::new());
    let mut rest = xml.trim_start_matches("<?xml version=\"1.0\" encoding=\"UTF-8\"?>").trim();
    while let Some(start) = rest.find('<') {
        let text = &rest[..start];
        assert!(!text.contains('>'), "{text}");
        for part in text.split('&').skip(1) {
            let name = part.split(';').next().unwrap_or("");
            assert!(["amp", "lt", "gt", "quot"].contains(&name), "&{name}");
        }
        let end = start + rest[start..].find('>').expect("a tag ends");
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name));
            continue;
        }
        let (tag, closed) = tag.strip_suffix('/').map_or((tag, false), |t| (t, true));
        let (name, mut list) = tag.split_once(' ').unwrap_or((tag, ""));
        let mut attributes = Vec::new();
        while let Some((key, after)) = list.split_once("=\"") {
            let (value, after) = after.split_once('"').expect("a quote ends");
            assert!(!value.contains('<'));
            attributes.push((key.trim().to_owned(), value.to_owned()));
            list = after;
        }
        assert!(list.trim().is_empty(), "{tag}");
        let mut keys: Vec<&str> = attributes.iter().map(|(k, _)| k.as_str()).collect();
        keys.sort_unstable();
        keys.dedup();
        assert_eq!(keys.len(), attributes.len(), "{tag}");
        found.push((name.to_owned(), attributes));
        if !closed {
            open.push(name.to_owned());
        }
    }
    assert!(open.is_empty() && rest.trim().is_empty(), "{open:?} {rest}");
    found
}

#[test]
fn files_parse_and_repeat() {
    let words = Words::of("de").expect("built in");
    for bank in support::banks() {
        for problem in &bank.problems {
            let variant = Maker::new(problem, 8, "figures").variant("0").expect("satisfiable");
            for (name, picture) in figure::all(problem, &variant, &words) {
                let what = format!("{} {name}", problem.id);
                let screen = svg::Screen::new(&picture);
                let inline = screen.inline("p1");
                assert_eq!(inline, svg::Screen::new(&picture).inline("p1"), "{what}");
                let elements = parse(&inline);
                let ids: Vec<&String> =
                    elements.iter().flat_map(|(_, a)| a).filter(|(k, _)| k == "id").map(|(_, v)| v).collect();
                assert_eq!(ids, ["p1-t", "p1-d"], "{what}");
                let svg = &elements[0];
                assert!(svg.0 == "svg" && svg.1.contains(&("role".to_owned(), "img".to_owned())), "{what}");
                let print = svg::print(&picture);
                for word in ["<style", "class=", "var(", "@media", "NaN", "inf\""] {
                    assert!(!print.contains(word), "{what}: {word}");
                }
                for text in [&screen.file(), &print] {
                    parse(text);
                    for (_, attributes) in parse(text) {
                        for (key, value) in attributes {
                            if ["x", "y", "cx", "cy", "r", "width", "height"].contains(&key.as_str())
                                && !value.ends_with('%')
                            {
                                assert!(
                                    value.parse::<f64>().is_ok_and(f64::is_finite),
                                    "{what}: {key}={value}"
                                );
                            }
                        }
                    }
                }
                let tikz = slipstick::picture::tikz::picture(&picture);
                let deep = tikz.lines().filter(|l| !l.starts_with('%')).collect::<String>();
                assert_eq!(deep.matches('{').count(), deep.matches('}').count(), "{what}");
                assert_eq!(deep.matches('$').count() % 2, 0, "{what}");
                assert!(tikz.contains("\\begin{tikzpicture}") && tikz.ends_with("\\end{tikzpicture}\n"));
                assert!(!tikz.contains("NaN") && !deep.contains('−') && !deep.contains('μ'), "{what}");
            }
        }
    }
}

#[test]
fn goldens_are_as_they_were() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/goldens");
    let renew = std::env::vars().any(|(name, _)| name == "RENEW_GOLDENS");
    let words = Words::english();
    let mut stale = Vec::new();
    for (id, name) in [
        ("pulled-rolling", "scene"),
        ("spring-released", "scene"),
        ("block-pulls-wheel", "scene"),
        ("rod-and-spring", "scene"),
        ("kinetic-energy", "scene"),
        ("pulled-slipping", "forces-wheel"),
        ("spring-released", "energy"),
        ("thrown-ball", "graph-slip"),
    ] {
        let problem =
            support::banks().into_iter().flat_map(|b| b.problems).find(|p| p.id == id).expect("a problem");
        let variant = Maker::new(&problem, 1, "goldens").variant("0").expect("satisfiable");
        let pictures = figure::all(&problem, &variant, &words);
        let (_, picture) = pictures.into_iter().find(|(n, _)| n == name).expect("a picture of this name");
        let text = svg::Screen::new(&picture).file();
        let path = format!("{folder}/{id}-{name}.svg");
        if renew {
            std::fs::write(&path, text).expect("a golden is written");
        } else if std::fs::read_to_string(&path).ok().as_ref() != Some(&text) {
            stale.push(path);
        }
    }
    assert!(stale.is_empty(), "other pictures than before; look at them, then RENEW_GOLDENS=1: {stale:?}");
}

/// One scene of the odd banks or of the built-in ones, with other text.
pub fn first_picture(yaml: &str) -> Picture {
    let bank = load::scenes_only(yaml, "one").unwrap_or_else(|f| panic!("{f:?}"));
    let variant = Maker::new(&bank.problems[0], 1, "figures").variant("1").expect("satisfiable");
    let words = Words::of("en").expect("built in");
    figure::scene::picture(&bank.problems[0], &variant, &words, FigureLabels::Values)
}

#[test]
fn the_angle_of_a_gentle_slope_is_readable() {
    let text = include_str!("../../templates/new/rolling-down.yaml");
    let (mut narrow, mut wide) = (0, 0);
    for degrees in 3..=30 {
        let picture =
            first_picture(&text.replace("draw: 8 to 30 step 1", &format!("draw: always {degrees}")));
        check(&picture, &format!("{degrees} degrees"));
        let label = picture.labels.iter().find(|l| symbol::plain(&l.runs).contains('°')).expect("the angle");
        assert!(symbol::plain(&label.runs).contains(&degrees.to_string()));
        let arcs: Vec<(f64, f64)> = picture
            .elements
            .iter()
            .filter_map(|e| match e.outline {
                Outline::Arc { radius, from, to, .. } if e.role == Role::Dimension => {
                    Some((radius, (to - from).abs()))
                }
                _ => None,
            })
            .collect();
        // One curve long enough to be seen, within the angle or as an arrow from outside it.
        let [(radius, turn)] = arcs[..] else { panic!("{degrees} degrees: {arcs:?}") };
        assert!(radius * turn > 7.0, "{degrees} degrees");
        // Those of the radius and of the distance, and that of the angle: as many for every angle, which may go with an answer.
        let heads = picture.elements.iter().filter(|e| e.role == Role::DimensionHead).count();
        assert_eq!(heads, 3, "{degrees} degrees");
        let from_outside = turn > f64::from(degrees).to_radians();
        narrow += usize::from(from_outside);
        wide += usize::from(!from_outside);
    }
    assert!(narrow >= 10 && wide >= 10, "{narrow} narrow, {wide} wide");
}

#[test]
fn bodies_are_drawn_with_arcs_and_particles_as_a_rigid_frame() {
    let words = Words::of("en").expect("built in");
    let (mut arcs, mut frames) = (0, 0);
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 3, "figures");
            for student in 0..40 {
                let variant = maker.variant(&student.to_string()).expect("satisfiable");
                let picture = figure::scene::picture(problem, &variant, &words, FigureLabels::Values);
                for element in &picture.elements {
                    if let Outline::Lines { points, .. } = &element.outline
                        && matches!(element.role, Role::Body | Role::Ghost)
                    {
                        assert!(points.len() <= 8, "{}: {} corners", problem.id, points.len());
                    }
                    arcs += usize::from(matches!(element.outline, Outline::Arcs(_)));
                }
                let particles = picture
                    .elements
                    .iter()
                    .filter(|e| e.role == Role::Body && matches!(e.outline, Outline::Circle { .. }));
                if problem.id == "kinetic-energy" {
                    let n = particles.count();
                    let rods = picture.elements.iter().filter(|e| e.role == Role::Ground);
                    let rods: usize = rods
                        .map(|e| match &e.outline {
                            Outline::Lines { points, closed } => points.len() - usize::from(!closed),
                            _ => 0,
                        })
                        .sum();
                    // A plane frame of n joints is rigid with 2 n - 3 rods.
                    assert_eq!(rods, 2 * n - 3, "{student}: {n} particles");
                    frames += 1;
                }
            }
        }
    }
    assert!(arcs > 40 && frames == 40, "{arcs} bodies of arcs, {frames} frames");
}

/// The corners of the first body that has straight edges, and all full points.
fn body_and_marks(picture: &Picture) -> (Vec<Vec2>, Vec<Vec2>) {
    let lines = picture.elements.iter().filter(|e| e.role == Role::Body).find_map(|e| match &e.outline {
        Outline::Lines { points, closed: true } => Some(points.clone()),
        _ => None,
    });
    let marks = picture.elements.iter().filter_map(|e| match e.outline {
        Outline::Circle { centre, .. } if e.role == Role::Dot => Some(centre),
        _ => None,
    });
    (lines.unwrap_or_default(), marks.collect())
}

#[test]
fn a_body_between_corners_is_drawn_about_its_mass_centre() {
    // Not all corners are named of the crates; all are of the square that hangs from one of them.
    let square = include_str!("../scenes/crate-that-slides.yaml")
        .replace("mass centre: b/2, placed: [0 m, 0 m]", "mass centre: b/sqrt(2), placed: [0 m, -b/sqrt(2)]")
        .replace(
            "A: [0 m, b/2], B: [0 m, -b/2], P: [h, b/2]",
            "A: 0 m, C: [b/sqrt(2), b/sqrt(2)], B: [b/sqrt(2), -b/sqrt(2)], D: sqrt(2)*b, P: h",
        )
        .replace("draw: always 0.8", "draw: always 0.95")
        .replace("crate.A, along: horizontal", "crate.C, along: horizontal");
    for (text, shape) in [
        (include_str!("../carried/crate-that-tips-on-a-truck.yaml"), 0.8 / 1.2),
        (include_str!("../scenes/crate-that-slides.yaml"), 1.0),
        (&square, 1.0),
    ] {
        let picture = first_picture(text);
        let (corners, marks) = body_and_marks(&picture);
        let frame = Frame::round(corners.iter().copied()).expect("a plate");
        let size = frame.high - frame.low;
        assert_eq!(corners.len(), 4, "{text}");
        assert!((size.x / size.y - shape).abs() < 1e-6, "{size:?} {text}");
        let middle = (frame.low + frame.high) / 2.0;
        assert!(marks.iter().any(|m| (m - middle).norm() < 1e-6), "{marks:?} {middle:?} {text}");
    }
}

#[test]
fn a_slack_strap_hangs_between_its_ends_and_a_later_spring_waits() {
    let flap = "bank: flap\ntitle: A flap\nproblems:\n  flap:\n    title: A flap\n    data:\n      m: {name: mass, unit: kg, draw: always 3}\n      L: {name: length, unit: m, draw: always 1}\n      k: {name: stiffness, unit: N/m, draw: always 800}\n      c: {name: height, unit: m, draw: always 0.5}\n    scene:\n      bodies: {flap: {mass: m, shape: {rod: L}, moves: in the plane, angle: from vertical}}\n      joints: {A: {pins: flap.A}}\n      forces: [spring: {on: flap.B, to: [0 m, c], stiffness: k, natural length: L, only: pulls}]\n      start: {flap: {angle: 30 deg}}\n      end: {turning point: flap}\n    questions:\n      phi: {ask: angle, unit: deg}\n    statement: '{{ m }} {{ L }} {{ k }} {{ c }} {{ g }}'\n";
    let picture = first_picture(flap);
    let (_, marks) = body_and_marks(&picture);
    let strap = picture.elements.iter().find(|e| e.role == Role::Spring).expect("a strap");
    assert!(matches!(strap.outline, Outline::Arc { .. }), "{strap:?}");
    let ends = corners(&strap.outline);
    for end in [ends[0], ends[ends.len() - 1]] {
        assert!(marks.iter().any(|m| (m - end).norm() < 0.1), "{end:?} {marks:?}");
    }
    let fall = "bank: fall\ntitle: A fall\nproblems:\n  fall:\n    title: A fall\n    data:\n      m: {name: mass, unit: kg, draw: always 5}\n      k: {name: stiffness, unit: N/m, draw: always 2000}\n      h: {name: height, unit: m, draw: always 0.6}\n    scene:\n      bodies: {block: {mass: m, moves: vertically, positive: down}}\n      start: at rest\n      end: {travel: {of: block, by: h}}\n      next:\n        ties: [cord: {from: {body: block, tied at: centre, leaves: down}, spring: {stiffness: k, stretch: 0 m, attached: rigidly}}]\n        end: {turning point: block}\n    questions:\n      x: {quantity: distance, motion: next, ask: compression, unit: mm}\n    statement: '{{ m }} {{ k }} {{ h }} {{ g }}'\n";
    let picture = first_picture(fall);
    assert!(picture.elements.iter().any(|e| e.role == Role::Spring), "no spring");
    assert!(
        picture.desc.contains("A spring of stiffness k = 2000 N/m stands on its path."),
        "{}",
        picture.desc
    );
}

/// Where the direction of a cord bears on an answer, it is drawn as it is told: over a guide pulley where both its ends lead the same way,
/// and no surface is turned round.
#[test]
fn cords_lead_where_the_key_has_them() {
    let of = |scene: &str, asked: &str| {
        format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{m: {{name: mass, unit: kg, draw: always 3}}}}\n    scene: {{{scene}, start: at rest, end: at once}}\n    questions: {{x: {{quantity: {asked}, ask: x}}}}\n    statement: '{{{{ m }}}} {{{{ g }}}}'\n"
        )
    };
    let winch = "bodies: {drum: {mass: 2 kg, shape: {disc: 0.2 m}, radii: {rim: 0.2 m}, moves: about a fixed axle}, load: {mass: m, moves: vertically, positive: down}}, ties: [cord: {from: {body: load, tied at: centre, leaves: up}, to: {body: drum, wound on: rim, leaves: SIDE}}]";
    for (side, guide) in [("front up", true), ("back up", true), ("back down", false)] {
        let desc = first_picture(&of(&winch.replace("SIDE", side), "drum.pin_y, unit: N")).desc;
        assert_eq!(desc.contains("over a small guide pulley to another body"), guide, "{side}: {desc}");
    }
    let table = "surfaces: {slope: {slope: 20 deg}, table: level}, bodies: {lower: {mass: 3 kg, moves: along slope}, crate: {mass: m, moves: along table}, drum: {mass: 2 kg, shape: {disc: 0.2 m}, radii: {rim: 0.2 m}, moves: about a fixed axle}}, ties: [cord: {from: {body: lower, tied at: centre, leaves: forward}, to: {body: crate, tied at: centre, leaves: ONE}}, cord: {from: {body: crate, tied at: centre, leaves: OTHER}, to: {body: drum, wound on: rim, leaves: top back}}]";
    let [told, turned] = [["back", "forward"], ["forward", "back"]]
        .map(|[one, other]| table.replace("ONE", one).replace("OTHER", other));
    let asked = "drum.pin_x, unit: N";
    let desc = first_picture(&of(&told, asked)).desc;
    assert!(desc.contains("Crate: to the right"), "{desc}");
    // What rises to the left is drawn so, and no direction in space is asked there.
    let desc = first_picture(&of(&turned, "crate.a, unit: m/s^2")).desc;
    assert!(desc.contains("Crate: to the left"), "{desc}");
    let refused = |text: &str, why: &str| {
        let faults = load::scenes_only(text, "one").unwrap_err();
        assert!(faults.to_string().contains(why), "{faults}");
    };
    refused(&of(&turned, asked), "it needs a pinned body, or one about a fixed axle");
    let truck = |scene: &str| {
        of(&format!("{scene}, carried: {{along: horizontal, acceleration: 3 m/s^2}}"), "crate.a, unit: m/s^2")
    };
    refused(&truck(&turned), "a cord leaves both its bodies to the same side");
    assert!(load::scenes_only(&truck(&told), "one").is_ok());
}

/// A start has its sense in words and its arrow in the picture: a speed that of the mass centre, a spin that of the body itself, also in a
/// bowl, where it rolls the other way round than it goes.
#[test]
fn a_start_in_the_plane_has_its_direction() {
    let of = |scene: &str| {
        format!(
            "bank: b\ntitle: B\nproblems:\n  p:\n    title: P\n    data: {{m: {{name: mass, unit: kg, draw: always 3}}}}\n    scene: {{bodies: {{disc: {{mass: m, shape: {{disc: 0.1 m}}, moves: in the plane}}}}, {scene}, end: at once}}\n    questions: {{x: {{quantity: kinetic_energy, ask: x, unit: J}}}}\n    statement: '{{{{ m }}}} {{{{ g }}}}'\n"
        )
    };
    let slope = |start: &str| {
        format!(
            "joints: {{floor: {{rolls: disc, radius: 0.1 m, along: 20 deg}}}}, start: {{disc: {{{start}}}}}"
        )
    };
    let bowl = "joints: {bowl: {rolls: disc, radius: 0.1 m, inside: 0.5 m}}, start: {disc: {angle: 280 deg, spin: 3 rad/s}}";
    for (scene, said, to) in [
        (
            slope("speed: 0.3 m/s"),
            "It starts with 0.3 m/s, positive at 20° counter-clockwise from the right.",
            Some(1.0),
        ),
        (
            slope("speed: -0.3 m/s"),
            "It starts with −0.3 m/s, positive at 20° counter-clockwise from the right.",
            Some(-1.0),
        ),
        (bowl.to_owned(), "It starts with 3 rad/s, positive counter-clockwise.", None),
    ] {
        let picture = first_picture(&of(&scene));
        assert!(picture.desc.contains(said), "{}", picture.desc);
        let arrows = picture.elements.iter().filter(|e| e.role == Role::Motion);
        let lines = arrows.filter_map(|e| match &e.outline {
            Outline::Lines { points, .. } if points.len() == 2 => Some(points[1] - points[0]),
            _ => None,
        });
        let heads: Vec<Vec2> = lines.collect();
        assert_eq!(heads.first().map(|way| way.x.signum()), to, "{heads:?}");
    }
}

#[test]
fn what_is_carried_or_bears_a_load_has_its_free_bodies() {
    let words = Words::english();
    let mut drawn = 0;
    let stone = support::banks().into_iter().flat_map(|b| b.problems).filter(|p| p.id == "mass-of-a-stone");
    for problem in textbook().into_iter().flat_map(|b| b.problems).chain(stone) {
        let Ok(variant) = Maker::new(&problem, 1, "figures").giving_up_after(1).variant("0") else {
            continue;
        };
        let scene = &problem.cases[variant.case].scene;
        let names: Vec<String> =
            figure::all(&problem, &variant, &words).into_iter().map(|(name, _)| name).collect();
        if scene.carried.is_some() || scene.formulas.found.is_some() || scene.end == End::Equilibrium {
            let missing = |b: &&slipstick::scene::Body| !names.contains(&format!("forces-{}", b.name));
            assert_eq!(scene.bodies.iter().find(missing).map(|b| &b.name), None, "{}: {names:?}", problem.id);
            drawn += scene.bodies.len();
        }
    }
    assert!(drawn > 10, "{drawn}");
}
