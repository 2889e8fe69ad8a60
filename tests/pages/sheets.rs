//! Sheets of every family in every language and format: nothing unfilled, HTML and figures valid, headings in order, LaTeX
//! that compiles.
use crate::support;
use pulldown_cmark::{Event, Parser};
use rayon::prelude::*;
use scraper::{Html, Selector};
use slipstick::bank::{Bank, overlay};
use slipstick::grade::{compare::compare, verdict::Verdict};
use slipstick::key::Answer;
use slipstick::num::trig;
use slipstick::picture::svg;
use slipstick::problem::make_key;
use slipstick::problem::maker::{Maker, Variant};
use slipstick::sheet::document::{ANSWER, Document, Head};
use slipstick::sheet::html::{Converter, MARKDOWN, PlaceInPage};
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::sheet::{formula, html, statement, tex};
use slipstick::solution;
use slipstick::template::{Templates, variables_of};
use slipstick::words::Words;
use std::collections::BTreeSet;

/// A name with everything that some format takes for markup.
const NAME: &str = "Zoë #1 *M* $x$ & % _ ^ ~ \\ <b> {y} \"q\" 'a' `c` [l](u) | 李";

/// A bank in a language, with templates and words.
struct Told {
    bank: Bank,
    templates: Templates,
    words: Words,
}

fn told(language: &str) -> Vec<Told> {
    let mut all = Vec::new();
    for mut bank in support::banks() {
        let words = Words::of(language).expect("a language of the program");
        if language != "en" {
            let file = format!("{}/templates/{language}/banks/{}.yaml", env!("CARGO_MANIFEST_DIR"), bank.id);
            let text = std::fs::read_to_string(&file).expect("every built-in bank is translated");
            overlay::put_over(&mut bank, &text, &file, &variables_of, None).expect("the texts fit the bank");
        }
        let mut templates = Templates::new(language, &[]).expect("the templates of the program");
        statement::add_own(&mut templates, &bank).expect("the statements of the bank");
        all.push(Told { bank, templates, words });
    }
    all
}

impl Told {
    /// Sheets of all problems of the bank: the document of one student after the other, with what was drawn.
    fn each_sheet(&self, students: u32, see: &mut dyn FnMut(&Head, &Document, &[Variant])) {
        let problems: Vec<usize> = (0..self.bank.problems.len()).collect();
        let sheets = Sheets::new(&self.templates, &self.words, &self.bank, "a set & more", &problems);
        let sheets = sheets.expect("the templates of the program");
        let makers: Vec<Maker> = self.bank.problems.iter().map(|p| Maker::new(p, 5, "sheets")).collect();
        let mut room = SheetScratch::default();
        for student in 0..students {
            let id = format!("s{student}");
            let variants: Vec<Variant> =
                makers.iter().map(|m| m.variant(&id).expect("satisfiable")).collect();
            let (head, document) = sheets.document(&id, NAME, &variants, &mut room).expect("renders");
            see(&head, &document, &variants);
        }
    }
}

/// Every bank in every language.
fn all_told() -> impl Iterator<Item = Told> {
    Words::languages().flat_map(told)
}

/// Whoever takes the magnitude of the key and, of the words that the sheet offers for the sign, the first for a positive key and the
/// second for a negative one, is right.
#[test]
fn the_words_of_a_sheet_give_the_sign_of_the_key() {
    for language in ["en", "de"] {
        let mut seen = 0;
        for told in told(language) {
            told.each_sheet(5, &mut |_, document, variants| {
                for (number, (problem, variant)) in (1..).zip(told.bank.problems.iter().zip(variants)) {
                    for part in make_key::key(problem, variant).parts {
                        let Answer::Number { value, .. } = part.answer else { continue };
                        let name = format!("`{number}.{}`", part.part);
                        let line = document
                            .markdown
                            .lines()
                            .find(|line| line.contains(&name))
                            .expect("its question");
                        let words: Vec<&str> = line.split('`').skip(3).step_by(2).collect();
                        let [positive, negative] = words[..] else { continue };
                        let word = if value > 0.0 { positive } else { negative };
                        let cell = format!(
                            "{} {word}",
                            part.unit.text_with(&part.unit.from_si(value).abs().to_string())
                        );
                        let judged = compare(&cell, &part);
                        assert_eq!(judged.verdict, Verdict::Right, "{}: {cell}: {line}", problem.id);
                        seen += 1;
                    }
                }
            });
        }
        assert!(seen > 100, "{seen}");
    }
}

/// What must hold of the text.
fn sound(language: &str, markdown: &str) {
    for piece in ["{{", "}}", "{%", "NaN", "infinite", "undefined", "  ("] {
        assert!(!markdown.contains(piece), "{piece:?} in {markdown}");
    }
    assert_eq!(formula::faulty_formulas(markdown), Vec::<String>::new());
    let (mut formulas, mut texts) = (0, String::new());
    for event in Parser::new_ext(markdown, MARKDOWN) {
        match event {
            Event::Text(text) => texts.push_str(&text),
            Event::InlineMath(tex) | Event::DisplayMath(tex) => {
                formulas += 1;
                let point = tex
                    .as_bytes()
                    .windows(3)
                    .any(|w| w[0].is_ascii_digit() && w[1] == b'.' && w[2].is_ascii_digit());
                assert!(language == "en" || !point, "a decimal point in {tex}");
                assert!(language != "en" || !tex.contains("{,}"), "a decimal comma in {tex}");
            }
            Event::Html(text) | Event::InlineHtml(text) => assert_eq!(text.trim(), ANSWER),
            _ => {}
        }
    }
    assert!(formulas > 10, "{markdown}");
    // A place of a phrase that nothing filled; the name alone has braces.
    let texts = texts.replace("{y}", "");
    assert!(!texts.contains('{') && !texts.contains('}'), "{texts}");
}

/// What must hold of a page: valid, each id once, headings in order, one language, pictures that speak.
fn valid(language: &str, page: &str) {
    let parsed = Html::parse_document(page);
    assert!(parsed.errors.is_empty(), "{:?}", parsed.errors);
    let select = |css: &str| Selector::parse(css).expect("a selector");
    let html = parsed.root_element();
    assert_eq!(html.value().attr("lang"), Some(language));
    let mut ids = BTreeSet::new();
    for element in parsed.select(&select("[id]")) {
        let id = element.value().attr("id").unwrap_or_default();
        assert!(!id.is_empty() && ids.insert(id.to_owned()), "the id {id:?} stands twice");
    }
    for name in ["aria-labelledby", "aria-describedby"] {
        for element in parsed.select(&select(&format!("[{name}]"))) {
            for id in element.value().attr(name).unwrap_or_default().split_whitespace() {
                assert!(ids.contains(id), "{name} names {id}, which is not there");
            }
        }
    }
    for link in parsed.select(&select("a[href]")) {
        let target = link.value().attr("href").and_then(|h| h.strip_prefix('#'));
        assert!(target.is_some_and(|t| ids.contains(t)), "{:?}", link.value().attr("href"));
    }
    let levels: Vec<u32> = parsed
        .select(&select("h1, h2, h3, h4, h5, h6"))
        .filter_map(|h| h.value().name()[1..].parse().ok())
        .collect();
    assert_eq!(levels.iter().filter(|l| **l == 1).count(), 1);
    assert_eq!(levels.first(), Some(&1));
    assert!(levels.windows(2).all(|w| w[1] <= w[0] + 1), "{levels:?}");
    assert_eq!(parsed.select(&select("main")).count(), 1);
    for picture in parsed.select(&select("figure > svg")) {
        assert_eq!(picture.value().attr("role"), Some("img"));
        let words = |css: &str| picture.select(&select(css)).next().map(|t| t.text().collect::<String>());
        assert!(words("title").is_some_and(|t| t.len() > 3));
        assert!(words("desc").is_some_and(|t| t.len() > 30));
    }
    assert_eq!(parsed.select(&select("th:not([scope])")).count(), 0);
    assert_eq!(parsed.select(&select("[tabindex]:not([aria-label])")).count(), 0);
    assert_eq!(parsed.select(&select("[style], script, img, link")).count(), 0, "nothing is fetched");
}

/// Is the picture well-formed XML without a number that is none?
fn well_formed(svg: &str) {
    let mut reader = quick_xml::Reader::from_str(svg);
    reader.config_mut().check_end_names = true;
    loop {
        match reader.read_event() {
            Ok(quick_xml::events::Event::Eof) => break,
            Ok(_) => {}
            Err(error) => panic!("{error} in {svg}"),
        }
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
}

/// Are braces and environments of a LaTeX text closed in turn?
fn closed(text: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut depth = 0i32;
    let mut rest = text;
    while let Some(at) = rest.find(['\\', '{', '}']) {
        let tail = &rest[at..];
        if let Some(name) = tail.strip_prefix("\\begin{") {
            open.push(name.split('}').next().unwrap_or(""));
        } else if let Some(name) = tail.strip_prefix("\\end{") {
            assert_eq!(open.pop(), name.split('}').next());
        }
        let step = match tail.as_bytes()[0] {
            b'\\' => 1 + tail[1..].chars().next().filter(|c| !c.is_alphabetic()).map_or(0, char::len_utf8),
            b'{' => {
                depth += 1;
                1
            }
            _ => {
                depth -= 1;
                1
            }
        };
        assert!(depth >= 0, "a brace too many before {tail}");
        rest = &tail[step..];
    }
    assert!(open.is_empty() && depth == 0, "{open:?}, {depth} braces open");
}

fn sweep(students: u32) {
    for told in all_told() {
        let language = told.words.language();
        told.each_sheet(students, &mut |head, document, _| {
            sound(language, &document.markdown);
            assert!(!document.plain().contains("<!--"));
            let mut converter = Converter::new(&told.words);
            let body = converter.body(document, &document.screens(), PlaceInPage::default());
            let page = html::page(&told.templates, &told.words, "sheet", head, &body, None).expect("renders");
            valid(language, &String::from_utf8(page).expect("text"));
            for (name, picture) in &document.pictures {
                assert!(document.markdown.contains(&format!("]({name}.svg)")));
                well_formed(&svg::Screen::new(picture).file());
            }
            let latex = tex::body(document);
            closed(&latex);
            let page = tex::page(&told.templates, &told.words, head, &latex).expect("renders");
            let page = String::from_utf8(page).expect("text");
            assert!(page.contains(r"\end{document}") && page.contains(r"\othersign{674E}"));
            assert!(!page.contains("{{ ") && !page.contains("{% "));
        });
    }
}

#[test]
fn sheets_of_many_students_are_sound_in_every_format() {
    sweep(40);
}

/// `cargo test --release --test pages sheets -- --ignored`: a thousand students of every family, in every language.
#[test]
#[ignore = "minutes in a debug build"]
fn sheets_of_a_thousand_students_are_sound_in_every_format() {
    sweep(1000);
}

/// Worked solutions of every family: each a document of its own behind the title that `slipstick solutions` writes.
fn each_solution(language: &str, students: u32, see: &mut dyn FnMut(&Told, &str, &Head, &Document)) {
    for told in told(language) {
        for problem in &told.bank.problems {
            let maker = Maker::new(problem, 6, "solutions");
            for student in 0..students {
                let variant = maker.variant(&format!("s{student}")).expect("satisfiable");
                let solved = solution::document(problem, &variant, 1, &told.words, &told.templates);
                let mut document = solved.unwrap_or_else(|fault| panic!("{}: {fault}", problem.id));
                document.markdown.insert_str(0, "# Worked\n\n");
                let head = Head { title: "Worked".to_owned(), name: NAME.to_owned(), ..Head::default() };
                see(&told, &problem.id, &head, &document);
            }
        }
    }
}

fn sweep_solutions(students: u32) {
    for language in Words::languages() {
        each_solution(language, students, &mut |told, _, head, document| {
            for piece in ["{{", "{%", "NaN", "infinite", "undefined", "<!--"] {
                assert!(!document.markdown.contains(piece), "{piece:?} in {}", document.markdown);
            }
            assert_eq!(formula::faulty_formulas(&document.markdown), Vec::<String>::new());
            let body =
                Converter::new(&told.words).body(document, &document.screens(), PlaceInPage::default());
            let page =
                html::page(&told.templates, &told.words, "solution", head, &body, None).expect("renders");
            valid(language, &String::from_utf8(page).expect("text"));
            for (name, picture) in &document.pictures {
                assert!(document.markdown.contains(&format!("]({name}.svg)")));
                well_formed(&svg::Screen::new(picture).file());
            }
            closed(&tex::body(document));
        });
    }
}

#[test]
fn solutions_are_sound_in_every_format() {
    sweep_solutions(4);
}

#[test]
#[ignore = "minutes in a debug build"]
fn solutions_of_many_students_are_sound_in_every_format() {
    sweep_solutions(200);
}

#[test]
fn booklets_are_valid_pages() {
    for told in all_told() {
        let mut parts = Vec::new();
        told.each_sheet(3, &mut |head, document, _| {
            let prefix = format!("{}-", html::part_id(parts.len()));
            let place = PlaceInPage { lower: 1, prefix: &prefix, boxes: &[] };
            let body = Converter::new(&told.words).body(document, &document.screens(), place);
            parts.push((head.clone(), body));
        });
        let list = parts.iter().map(|(head, body)| (head, body.as_str()));
        let page = html::booklet(&told.templates, &told.words, "All <sheets>", list).expect("renders");
        let page = String::from_utf8(page).expect("text");
        // Each student has pages of his own, counted from 1, and begins on the front of a sheet of paper.
        for i in 0..parts.len() {
            let id = html::part_id(i);
            assert!(page.contains(&format!("@page {id} {{ counter-increment: {id};")), "{id}");
            assert!(page.contains(&format!("content: counter({id});")), "{id}");
        }
        assert!(page.contains("break-before: recto"));
        assert_eq!(page.matches("@font-face").count(), 1);
        valid(told.words.language(), &page);
    }
}

/// Two students, two sheets: two codes; the same draw, the same code.
#[test]
fn a_code_stands_for_what_was_drawn() {
    let mut codes = BTreeSet::new();
    let mut all = Vec::new();
    for told in all_told() {
        told.each_sheet(40, &mut |head, _, _| {
            assert!(head.code.len() == 6 && head.code.chars().all(|c| c.is_ascii_alphanumeric()));
            codes.insert(head.code.clone());
            all.push(head.code.clone());
        });
    }
    assert_eq!(codes.len() * 2, all.len(), "both languages draw the same");
}

/// Real LaTeX, where there is one: a booklet of every bank in every language, without an error or a line that sticks out.
#[test]
fn latex_compiles() {
    if std::process::Command::new("pdflatex").arg("--version").output().is_err() {
        assert!(std::env::var_os("SLIPSTICK_NEEDS_LATEX").is_none(), "pdflatex is wanted and not there");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let mut names = Vec::new();
    for language in Words::languages() {
        for told in told(language) {
            let mut parts = Vec::new();
            told.each_sheet(2, &mut |head, document, _| parts.push((head.clone(), tex::body(document))));
            let list = parts.iter().map(|(head, body)| (head, body.as_str()));
            let text = tex::booklet(&told.templates, &told.words, "All <sheets>", list).expect("renders");
            let name = format!("{}-{language}", told.bank.id);
            std::fs::write(folder.path().join(format!("{name}.tex")), text).expect("written");
            names.push(name);
        }
        // Formulas of solutions are longer.
        let mut parts = Vec::new();
        let mut looks = None;
        each_solution(language, 1, &mut |told, _, head, document| {
            looks.get_or_insert_with(|| {
                (Templates::new(language, &[]).expect("built in"), told.words.clone())
            });
            parts.push((head.clone(), tex::body(document)));
        });
        let (templates, words) = looks.expect("there are problems");
        let list = parts.iter().map(|(head, body)| (head, body.as_str()));
        let text = tex::booklet(&templates, &words, "All", list).expect("renders");
        let name = format!("solutions-{language}");
        std::fs::write(folder.path().join(format!("{name}.tex")), text).expect("written");
        names.push(name);
    }
    names.par_iter().for_each(|name| compiles(folder.path(), name));
}

/// One run of pdfLaTeX: no error, and nothing that sticks out of its line.
fn compiles(folder: &std::path::Path, name: &str) {
    let ran = std::process::Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", &format!("{name}.tex")])
        .current_dir(folder)
        .output()
        .expect("pdflatex runs");
    let said = String::from_utf8_lossy(&ran.stdout).into_owned();
    assert!(ran.status.success(), "{name}: {said}");
    for line in said.lines().filter(|l| l.starts_with("Overfull \\hbox")) {
        let points =
            line.split('(').nth(1).and_then(|t| t.split("pt").next()).and_then(|t| t.parse::<f64>().ok());
        assert!(points.is_some_and(|p| p < 3.0), "{name}: {line}");
    }
}

/// Contrast of two colours such as `#1b1f24`, after WCAG 2.1.
fn contrast(a: &str, b: &str) -> f64 {
    let light = |colour: &str| {
        let part = |i: usize| {
            let byte = u8::from_str_radix(&colour[i..i + 2], 16).expect("a colour of six digits");
            let x = f64::from(byte) / 255.0;
            if x <= 0.03928 { x / 12.92 } else { trig::power((x + 0.055) / 1.055, 2.4) }
        };
        0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5) + 0.05
    };
    let (a, b) = (light(a), light(b));
    a.max(b) / a.min(b)
}

#[test]
fn letters_stand_out_from_the_paper_by_day_and_by_night() {
    let style = include_str!("../../templates/style.html");
    let schemes: Vec<&str> =
        style.lines().filter(|l| l.contains("--ink:") && l.contains("--tint:")).collect();
    assert!(schemes.len() >= 2, "light and dark");
    for scheme in schemes.iter().take(2) {
        let colour = |name: &str| {
            let after = scheme.split(&format!("--{name}: ")).nth(1).expect("a colour of this name");
            after.split(';').next().expect("a colour")
        };
        for paper in ["paper", "tint"] {
            for ink in ["ink", "soft", "accent"] {
                let c = contrast(colour(ink), colour(paper));
                assert!(c >= 4.5, "{ink} on {paper}: {c:.2} in {scheme}");
            }
        }
    }
}

/// The font of formulas is in the page, once, where there is a formula, and is a font; its licence lies beside it.
#[test]
fn formulas_bring_their_font() {
    let templates = Templates::english();
    let words = Words::of("en").expect("built in");
    let page = |markdown: &str| {
        let document = Document::new(markdown.to_owned(), Vec::new());
        let body = Converter::new(&words).body(&document, &[], PlaceInPage::default());
        let page = html::page(&templates, &words, "sheet", &Head::default(), &body, None).expect("renders");
        String::from_utf8(page).expect("text")
    };
    let with = page("The root $\\sqrt{2 g h}$ and $v_0$, in rad/s or kg·m/s, too.");
    assert_eq!(with.matches("@font-face").count(), 1);
    assert!(!page("No formula.").contains("@font-face"));
    let font =
        with.split("data:font/woff2;base64,").nth(1).expect("a font").split(')').next().expect("its end");
    // The first bytes are `wOF2` and the flavour `OTTO`; four signs stand for three bytes.
    assert!(font.starts_with("d09GMk9UVE8A"), "{}", &font[..16]);
    let bytes = font.len() / 4 * 3;
    assert!((20_000..=41_000).contains(&bytes), "{bytes} bytes");
    assert!(with.contains("math { font-family: \"Slipstick Math\""));
    let licence = include_str!("../../templates/math-font-licence.txt");
    for words in
        ["GUST Font License", "LaTeX Project Public License", "LPPL Version 1.3c", "What was changed"]
    {
        assert!(licence.contains(words), "{words}");
    }
    // A unit does not break at its slash.
    for unit in ["rad/s", "kg·m/s"] {
        assert!(with.contains(&format!("<span class=\"unit\">{unit}</span>")), "{unit}");
    }
}
