//! Worked solutions: made for every draw, answering every question, and true line by line.
//!
//! The second test does not know how a solution was made. It reads the Markdown that comes out, and solves each printed
//! equation again: a printed number stands for all numbers that round to it (data are exact), the right side is evaluated in
//! intervals, and the printed result has to lie in what comes out. The line in symbols is held to the same with the
//! values printed before; equations between quantities that are all known at the end have to hold with these.
use slipstick::bank::{Problem, load};
use slipstick::num::shown;
use slipstick::problem::maker;
use slipstick::problem::maker::{Maker, Variant};
use slipstick::scene::End;
use slipstick::sheet::formula;
use slipstick::solution;
use slipstick::solution::draft::Detail;
use slipstick::solution::written::width;
use slipstick::template::Templates;
use slipstick::words::Words;

use crate::beware;
use crate::support;
use crate::tex;

/// Widest line of a formula that fits on 16 cm of print, in digits.
const LINE: f64 = 86.0;

fn templates(language: &str) -> Templates {
    Templates::new(language, &[]).expect("templates")
}

/// The problems of bodies on lines and axles, and of bodies that are joined in the plane.
fn linear(problem: &Problem) -> bool {
    problem.cases.iter().all(|c| {
        let s = &c.scene;
        s.pinned().is_none() && s.thrown().is_none() && s.bodies.iter().all(|b| b.particles.is_empty())
    })
}

fn markdown(problem: &Problem, variant: &Variant, words: &Words, templates: &Templates) -> String {
    match solution::text(problem, variant, 1, words, templates) {
        Ok(text) if !text.contains(words.get("solution.title.beyond")) => text,
        Ok(short) => panic!("{short}\n{:?}", variant.data),
        Err(finding) => panic!("{finding}\n{:?}", variant.data),
    }
}

/// Calls with each linear problem and many of its variants.
fn sweep(draws: u32, mut each: impl FnMut(&Problem, &Variant)) {
    for bank in support::banks() {
        for problem in bank.problems.iter().filter(|p| linear(p)) {
            let maker = Maker::new(problem, 4, "solutions");
            for student in 0..draws {
                let variant = maker.variant(&student.to_string()).expect("a variant");
                each(problem, &variant);
            }
        }
    }
}

/// What is wrong with a solution, beside its numbers.
fn faults(markdown: &str, problem: &Problem, variant: &Variant, words: &Words) -> Vec<String> {
    let mut faults = formula::faulty_formulas(markdown);
    let sentences: String = markdown.split("$$").step_by(2).collect::<Vec<_>>().join(" ");
    for (i, piece) in sentences.split('$').enumerate() {
        // Outside of formulas nothing is left to fill in.
        if i % 2 == 0 && piece.contains(['{', '}']) {
            faults.push(format!("left open: {piece:?}"));
        }
    }
    for word in ["NaN", "none}", "infinite"] {
        if markdown.contains(word) {
            faults.push(format!("says {word}"));
        }
    }
    // The name of a phrase that is missing; a sentence may end with this word.
    if markdown.split("solution.").skip(1).any(|rest| rest.starts_with(|c: char| c.is_ascii_lowercase())) {
        faults.push("says the name of a phrase".to_owned());
    }
    for formula in tex::displayed(markdown) {
        for line in tex::lines(&formula) {
            if width(&line) > LINE {
                faults.push(format!("{:.0} wide: {line}", width(&line)));
            }
        }
    }
    let scene = &problem.cases[variant.case].scene;
    for q in &problem.questions {
        let row = format!("`1.{}` ", q.id);
        let all = markdown.lines().find(|l| l.starts_with("> ")).unwrap_or_default();
        let Some(line) = all.split(" · ").map(|l| l.trim_start_matches("> ")).find(|l| l.starts_with(&row))
        else {
            faults.push(format!("no answer to {}", q.id));
            continue;
        };
        let right = match variant.solved.get(q.label) {
            Some(entry) => {
                let digits = shown::significant(
                    q.unit.from_si(scene.as_asked(q.label, entry.value())),
                    usize::from(q.figures),
                );
                q.unit.tex_with(&words.tex_number(&digits))
            }
            None => {
                let word = variant.solved.word(q.label);
                word.map_or_else(String::new, |w| words.get(&format!("sheet.{}", w.as_str())).to_owned())
            }
        };
        if right.is_empty() || !line.contains(&right) {
            faults.push(format!("{}: `{line}` is not {right}", q.id));
        }
    }
    faults
}

fn every_draw(draws: u32) {
    let (templates, words) = (templates("en"), Words::english());
    let mut counts = tex::Counts::default();
    let (mut made, mut told) = (0u32, 0u32);
    sweep(draws, |problem, variant| {
        let text = markdown(problem, variant, &words, &templates);
        let mut wrong = faults(&text, problem, variant, &words);
        // The wrong methods are solved anew for one in ten.
        if made.is_multiple_of(10) {
            wrong.extend(beware::check(&text, problem, variant, &words, &mut told));
        }
        wrong.extend(tex::check(&text, &mut counts));
        assert!(wrong.is_empty(), "{}: {}\n\n{text}", problem.id, wrong.join("\n"));
        made += 1;
    });
    println!("{made} solutions: {counts:?}, {told} mistakes");
    assert!(10 * told > 2 * made, "{told} mistakes told in {made} solutions");
    // So that a change of the text's form cannot switch the check off.
    assert!(
        counts.symbols > 6 * made && counts.relations > 6 * made && counts.repeated > 4 * made,
        "{counts:?}"
    );
}

#[test]
fn every_printed_equation_holds() {
    every_draw(support::seeds(300));
}

#[test]
#[ignore = "a thousand draws of each family take a minute"]
fn every_printed_equation_holds_for_a_thousand() {
    every_draw(1000);
}

#[test]
fn a_wrong_digit_is_seen() {
    let (templates, words) = (templates("en"), Words::english());
    let mut planted = 0;
    sweep(2, |problem, variant| {
        let text = markdown(problem, variant, &words, &templates);
        for (from, to) in tex::mutations(&text) {
            let wrong = format!("{}{}{}", &text[..from], to, &text[from + to.len()..]);
            let found = tex::check(&wrong, &mut tex::Counts::default());
            assert!(
                !found.is_empty(),
                "{}: not seen: ...{}...",
                problem.id,
                &wrong[from.saturating_sub(60)..from + 20]
            );
            planted += 1;
        }
    });
    println!("{planted} wrong digits seen");
    assert!(planted > 60);
}

#[test]
fn both_languages_have_the_same_formulas() {
    let english = (Words::english(), templates("en"));
    let german = (Words::of("de").expect("German"), templates("de"));
    sweep(12, |problem, variant| {
        let texts = [&english, &german].map(|(w, t)| markdown(problem, variant, w, t));
        let mut wrong = faults(&texts[1], problem, variant, &german.0);
        wrong.extend(beware::check(&texts[1], problem, variant, &german.0, &mut 0));
        assert!(wrong.is_empty(), "{}: {}\n\n{}", problem.id, wrong.join("\n"), texts[1]);
        let [en, de] = texts.map(|t| tex::displayed(&t));
        let de: Vec<String> = de.iter().map(|f| f.replace("{,}", ".")).collect();
        assert_eq!(en, de, "{}", problem.id);
    });
}

/// What is wrong with the solution of a variant.
fn wrong(problem: &Problem, variant: &Variant, words: &Words, templates: &Templates) -> Vec<String> {
    let text = match solution::text(problem, variant, 1, words, templates) {
        Ok(text) if text.contains(words.get("solution.title.beyond")) => {
            return vec![format!("{}: is a short page, data {:?}\n{text}", problem.id, variant.data)];
        }
        Ok(text) => text,
        Err(finding) => return vec![format!("{finding}, data {:?}", variant.data)],
    };
    let mut wrong = faults(&text, problem, variant, words);
    wrong.extend(tex::check(&text, &mut tex::Counts::default()));
    wrong.into_iter().map(|w| format!("{}: {w}", problem.id)).collect()
}

/// The pictures that a text shows are there, and each once.
#[test]
fn pictures_stand_in_the_text() {
    let (templates, words) = (templates("en"), Words::english());
    sweep(2, |problem, variant| {
        let document = solution::document(problem, variant, 1, &words, &templates).expect("a solution");
        let shown: Vec<&str> = document
            .markdown
            .lines()
            .filter_map(|l| l.strip_suffix(".svg)")?.rsplit_once("](").map(|p| p.1))
            .collect();
        let names: Vec<&str> = document.pictures.iter().map(|(n, _)| n.as_str()).collect();
        let mut sorted = (shown.clone(), names.clone());
        sorted.0.sort_unstable();
        sorted.1.sort_unstable();
        assert_eq!(sorted.0, sorted.1, "{}", problem.id);
        assert!(names.contains(&"scene"), "{}: {names:?}", problem.id);
        // Free bodies are not drawn with a datum that has to be found first.
        let scene = &problem.cases[variant.case].scene;
        let bodies = scene.bodies.iter().filter(|_| scene.formulas.found.is_none());
        let shown = bodies.map(|b| format!("forces-{}", b.name));
        assert!(shown.into_iter().all(|name| names.contains(&name.as_str())), "{}: {names:?}", problem.id);
    });
}

/// Every step with its numbers put in: the same equations, solved again from them.
#[test]
fn every_substitution_of_the_full_detail_holds() {
    let (templates, words) = (templates("en"), Words::english());
    let (mut counts, mut made) = (tex::Counts::default(), 0);
    sweep(support::seeds(40), |problem, variant| {
        let (document, beyond) =
            solution::worked(problem, variant, 1, Detail::Full, (&words, &templates)).expect("a solution");
        assert!(beyond.is_none(), "{}", problem.id);
        let mut wrong = faults(&document.markdown, problem, variant, &words);
        wrong.extend(tex::check(&document.markdown, &mut counts));
        assert!(wrong.is_empty(), "{}: {}\n\n{}", problem.id, wrong.join("\n"), document.markdown);
        made += 1;
    });
    assert!(counts.numbers > 6 * made, "{made}: {counts:?}");
}

/// The short detail: at most a dozen displayed lines, and the way that is called shorter has fewer unknowns.
#[test]
fn a_solution_is_short_and_says_truly_what_is_shorter() {
    let (templates, words) = (templates("en"), Words::english());
    let mut compared = 0;
    sweep(support::seeds(40), |problem, variant| {
        let text = markdown(problem, variant, &words, &templates);
        let lines: usize = tex::displayed(&text).iter().map(|f| tex::lines(f).len()).sum();
        assert!(lines <= 12, "{}: {lines} lines\n{text}", problem.id);
        let unknowns = |way: &str| -> Option<(usize, usize)> {
            let rest = text.split_once(&format!("{way}: "))?.1;
            let (count, rest) = rest.split_once(" unknown")?;
            let (list, _) = rest.trim_start_matches('s').strip_prefix(" (")?.split_once(')')?;
            Some((count.parse().ok()?, list.matches('$').count() / 2))
        };
        if let (Some(newton), Some(energy)) = (unknowns("Newton"), unknowns("Energy")) {
            assert_eq!((newton.0, energy.0), (newton.1, energy.1), "{}: {text}", problem.id);
            assert!(energy.0 < newton.0, "{}", problem.id);
            compared += 1;
        } else {
            // Where a time is given, energy is no way at all.
            let timed = matches!(problem.cases[variant.case].scene.end, End::Time(..))
                && text.contains("says nothing about time");
            assert!(timed || text.contains("either method is shorter"), "{}: {text}", problem.id);
        }
    });
    assert!(compared > 20, "{compared}");
}

/// Scenes of textbooks, with the data printed there.
#[test]
fn scenes_of_textbooks() {
    let (templates, words) = (templates("en"), Words::english());
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scenes");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("scenes").map(|f| f.expect("a file").path()).collect();
    files.sort();
    let (mut solved, mut bad) = (0, 0);
    for file in files {
        let text = std::fs::read_to_string(&file).expect("text");
        let bank = load::scenes_only(&text, &file.display().to_string()).expect("a bank");
        for problem in &bank.problems {
            let values = support::constants(problem);
            // Some of these scenes are drawn and have no printed data; what is to be found is not printed anywhere.
            let unknown = problem.cases[0].scene.formulas.found.map(|f| f.unknown.datum);
            if values.iter().enumerate().any(|(i, v)| v.is_none() && Some(i) != unknown) {
                continue;
            }
            let variant = maker::from_values(problem, 0, &values).expect("solved");
            // One is printed to show that it does not roll.
            if variant.solved.regime.slips {
                continue;
            }
            let wrong = wrong(problem, &variant, &words, &templates);
            if !wrong.is_empty() {
                println!("{}: {}", file.display(), wrong.join("\n"));
                bad += 1;
                continue;
            }
            solved += 1;
        }
    }
    println!("{solved} scenes of textbooks");
    assert_eq!(bad, 0);
    assert!(solved >= 25, "{solved}");
}

/// Every way to start, to end and to pull; every quantity.
#[test]
fn scenes_beyond_the_built_in_banks() {
    let (templates, words) = (templates("en"), Words::english());
    let texts = [
        include_str!("../support/lines.yaml"),
        include_str!("../worked/blows-and-rests.yaml"),
        include_str!("../worked/rods-pulls-and-rims.yaml"),
        include_str!("../worked/impacts-and-slots.yaml"),
    ];
    let banks = texts.map(|text| load::scenes_only(text, "a bank").unwrap_or_else(|f| panic!("{f:?}")));
    let mut faults = Vec::new();
    for problem in banks.iter().flat_map(|bank| &bank.problems) {
        let maker = Maker::new(problem, 8, "lines");
        for student in 0..25 {
            let variant = maker.variant(&student.to_string()).unwrap_or_else(|u| panic!("{u}"));
            let wrong = wrong(problem, &variant, &words, &templates);
            if !wrong.is_empty() {
                faults.extend(wrong);
                break;
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
