//! Worked solutions of pinned bodies, of bodies thrown with slip and of laminas: every draw has one, in every language, with
//! the same numbers; nothing is left unfilled; no formula is wider than a page.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
use slipstick::problem::make::Maker;
use slipstick::solution;
use slipstick::solution::pen;
use slipstick::template::Templates;
use slipstick::words::Words;

mod support;

/// Draws of each family.
const DRAWS: u32 = 300;
/// Families that this test is about.
const FAMILIES: [&str; 7] = [
    "falling-rod",
    "compound-pendulum",
    "lifted-rod",
    "rod-and-spring",
    "thrown-ball",
    "wheel-set-down",
    "kinetic-energy",
];
/// Width of print, in characters of average width.
const PAGE: usize = 76;

/// The numbers of a text in order, the decimal mark of the language made a point.
fn numbers(markdown: &str) -> Vec<String> {
    let text = markdown.replace("{,}", ".");
    let mut found = Vec::new();
    let mut number = String::new();
    for c in text.chars().chain([' ']) {
        if c.is_ascii_digit() || (c == '.' && !number.is_empty()) {
            number.push(c);
        } else if !number.is_empty() {
            found.push(number.trim_end_matches('.').to_owned());
            number.clear();
        }
    }
    found
}

/// The displayed formulas of a text.
fn formulas(markdown: &str) -> impl Iterator<Item = &str> {
    markdown.split("$$").skip(1).step_by(2)
}

#[test]
fn every_draw_is_worked_in_every_language() {
    let texts: Vec<(Words, Templates)> =
        Words::languages().map(|l| (Words::of(l).unwrap(), Templates::new(l, &[]).unwrap())).collect();
    let mut done = Vec::new();
    for bank in support::banks() {
        for problem in bank.problems.iter().filter(|p| FAMILIES.contains(&p.id.as_str())) {
            done.push(problem.id.clone());
            let maker = Maker::new(problem, 11, "solutions");
            for student in 0..DRAWS {
                let variant = maker.variant(&format!("s{student}")).unwrap();
                let mut first: Option<Vec<String>> = None;
                for (words, templates) in &texts {
                    let language = words.language();
                    let document = solution::document(problem, &variant, 1, words, templates);
                    let document = document.unwrap_or_else(|f| panic!("{} s{student}: {f}", problem.id));
                    let text = &document.markdown;
                    for bad in ["NaN", "{{", "}}$}", "${", "{alpha", "{omega"] {
                        assert!(
                            !text.contains(bad),
                            "{} s{student} {language}: {bad} in\n{text}",
                            problem.id
                        );
                    }
                    // What a number that is none is written as.
                    let odd = |f: &&str| f.contains("none") || f.contains("infinite") || f.contains('?');
                    let odd = text.split('$').skip(1).step_by(2).find(odd);
                    assert_eq!(odd, None, "{} s{student}", problem.id);
                    for formula in formulas(text) {
                        for line in formula.split(r"\\") {
                            let width = pen::width(line);
                            assert!(width <= PAGE, "{} s{student}: {width} in {line}", problem.id);
                        }
                    }
                    let numbers = numbers(text);
                    match &first {
                        None => first = Some(numbers),
                        Some(first) => assert_eq!(first, &numbers, "{} s{student}", problem.id),
                    }
                }
            }
        }
    }
    done.sort();
    let mut all: Vec<String> = FAMILIES.iter().map(|f| (*f).to_owned()).collect();
    all.sort();
    assert_eq!(done, all);
}
