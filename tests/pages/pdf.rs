//! PDFs opened again: what a student was given can be read in them, and figures are where they belong. Needs the feature
//! `pdf`, and `pdftotext`, `pdftoppm` and `pdfinfo` of Debian's package poppler-utils.
#![cfg(feature = "pdf")]
use crate::support;
use rayon::prelude::*;
use slipstick::bank::Problem;
use slipstick::figure::scene;
use slipstick::problem::maker::{Maker, Variant};
use slipstick::sheet::document::{Document, Head};
use slipstick::sheet::pdf::PdfCompiler;
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::sheet::statement;
use slipstick::words::Words;
use std::path::Path;
use std::process::Command;

/// Runs a program of poppler-utils and gives what it prints.
fn poppler(program: &str, arguments: &[&str], file: &Path) -> Vec<u8> {
    let to_stdout = if program == "pdftotext" { &["-"][..] } else { &[] };
    let output =
        Command::new(program).args(arguments).arg(file).args(to_stdout).output().unwrap_or_else(|e| {
            panic!("{program} cannot be run ({e}): install the Debian package poppler-utils")
        });
    assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// A file that goes away with its folder.
fn in_file(bytes: &[u8]) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.pdf");
    std::fs::write(&path, bytes).expect("written");
    (folder, path)
}

/// The text of each page without white space, letters of formulas as ordinary ones.
fn pages(bytes: &[u8]) -> Vec<String> {
    let (_folder, path) = in_file(bytes);
    let text = String::from_utf8(poppler("pdftotext", &["-enc", "UTF-8"], &path)).expect("UTF-8");
    let mut pages: Vec<String> = text.split('\u{c}').map(plain).collect();
    assert_eq!(pages.pop().as_deref(), Some(""), "a page ends with a form feed");
    pages
}

fn plain(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).map(|c| if c == '−' { '-' } else { c }).collect()
}

/// A datum as it stands in the text of a page: `40kg`, `30∘`, `9.81m/s2`.
fn expected(problem: &Problem, variant: &Variant, datum: usize, words: &Words) -> Option<String> {
    let drawn = variant.values[datum]?;
    let text = words.number(&statement::printed(problem, datum, drawn));
    Some(plain(&text.replace('^', "")).replace("deg", "∘"))
}

fn one_line(finding: slipstick::finding::Finding) -> String {
    panic!("{finding}")
}

#[test]
fn every_family_can_be_read_in_its_pdf() {
    read_again(support::seeds(100));
}

#[test]
#[ignore = "28,000 pages take minutes"]
fn a_thousand_sheets_of_every_family_can_be_read_in_their_pdfs() {
    read_again(1000);
}

/// Prints so many sheets of each family in each language, and reads them again.
fn read_again(seeds: u32) {
    for language in Words::languages() {
        let words = Words::of(language).expect("a language");
        let press = PdfCompiler::new(&words, None).unwrap_or_else(|f| panic!("{f}"));
        for bank in support::banks_in(language) {
            let templates = support::templates(language, &bank);
            bank.problems.par_iter().enumerate().for_each(|(index, problem)| {
                let maker = Maker::new(problem, 11, "pdf");
                let sheets = Sheets::new(&templates, &words, &bank, "pdf", &[index]).expect("templates");
                let mut room = SheetScratch::default();
                let made: Vec<(Variant, (Head, Document))> = (0..seeds)
                    .map(|i| {
                        let student = format!("s{i}");
                        let variant = maker.variant(&student).expect("satisfiable");
                        let name = format!("Zoë #{i} *M* $x$ <lab> @a");
                        let sheet = sheets
                            .document(&student, &name, std::slice::from_ref(&variant), &mut room)
                            .expect("a sheet");
                        (variant, sheet)
                    })
                    .collect();
                let documents: Vec<(&Head, &Document)> = made.iter().map(|(_, (h, d))| (h, d)).collect();
                let bytes = press.press(&documents).unwrap_or_else(|f| panic!("{}: {f}", problem.id));
                let mut texts: Vec<String> = Vec::new();
                for page in pages(&bytes) {
                    if page.contains(&plain(&words.say("print.page", &[("x", "1")]).replace("{y}", ""))) {
                        texts.push(String::new());
                    }
                    texts.last_mut().expect("the first page is page 1").push_str(&page);
                }
                assert_eq!(texts.len(), made.len(), "{}: sheets begin with page 1", problem.id);
                for ((variant, (head, document)), text) in made.iter().zip(&texts) {
                    let whose = format!("{language} {} {}", problem.id, head.student);
                    for wanted in [&head.name, &head.code, &head.student, &head.set] {
                        assert!(text.contains(&plain(wanted)), "{whose}: no {wanted} in\n{text}");
                    }
                    for datum in 0..problem.data.len() {
                        // Where nothing is heavy the sheet does not say g.
                        if problem.data[datum].symbol == "g" && !document.markdown.contains("$g = ") {
                            continue;
                        }
                        if let Some(wanted) = expected(problem, variant, datum, &words) {
                            assert!(text.contains(&wanted), "{whose}: no {wanted} in\n{text}");
                        }
                    }
                    let rooms = text.matches(&plain(words.get("print.answer"))).count();
                    assert!(
                        rooms >= problem.questions.len(),
                        "{whose}: {rooms} rooms for answers in\n{text}"
                    );
                }
            });
        }
    }
}

/// Ink of a page: columns and rows (72 to the inch) between which something is printed.
fn ink(bytes: &[u8]) -> (usize, usize, usize, usize) {
    let (_folder, path) = in_file(bytes);
    let image = poppler("pdftoppm", &["-r", "72", "-gray", "-f", "1", "-l", "1"], &path);
    // P5, width, height, 255, pixels.
    let mut fields = image.splitn(4, |b| *b == b'\n');
    assert_eq!(fields.next(), Some(&b"P5"[..]));
    let size = String::from_utf8(fields.next().expect("a size").to_vec()).expect("a size");
    let width: usize = size.split(' ').next().and_then(|w| w.parse().ok()).expect("a width");
    let pixels = fields.nth(1).expect("pixels");
    let mut bounds = (usize::MAX, usize::MAX, 0, 0);
    for (i, _) in pixels.iter().enumerate().filter(|(_, p)| **p < 160) {
        let (x, y) = (i % width, i / width);
        // Without the footer.
        if y < 780 {
            bounds = (bounds.0.min(x), bounds.1.min(y), bounds.2.max(x), bounds.3.max(y));
        }
    }
    bounds
}

#[test]
fn figures_are_drawn_with_their_labels() {
    let words = Words::english();
    let press = PdfCompiler::new(&words, None).unwrap_or_else(|f| panic!("{f}"));
    for bank in support::banks_in("en") {
        for problem in &bank.problems {
            let variant = Maker::new(problem, 3, "pdf").variant("figure").expect("satisfiable");
            let picture = scene::picture(problem, &variant, &words, problem.figure);
            let labels: Vec<String> = picture
                .labels
                .iter()
                .map(|l| plain(&l.runs.iter().map(|r| r.text.as_str()).collect::<String>()))
                .collect();
            let (width, height) = (picture.width, picture.height);
            let document = Document {
                markdown: "![the scene](scene.svg)\n".to_owned(),
                pictures: vec![("scene".to_owned(), picture)],
            };
            let bytes = press
                .press(&[(&Head::default(), &document)])
                .unwrap_or_else(|f| panic!("{}: {f}", problem.id));
            let (left, top, right, bottom) = ink(&bytes);
            let drawn = (right.saturating_sub(left) as f64, bottom.saturating_sub(top) as f64);
            // Points, of which there are three to four pixels; no picture is wider than the page allows.
            let natural = (width * 0.75, height * 0.75);
            assert!(
                drawn.0 <= natural.0 + 2.0 && drawn.0 >= natural.0 * 0.6 && drawn.1 >= natural.1 * 0.5,
                "{}: {drawn:?} of {natural:?}",
                problem.id
            );
            let text = pages(&bytes).concat();
            for label in labels {
                assert!(text.contains(&label), "{}: no label {label} in {text}", problem.id);
            }
        }
    }
}

#[test]
fn the_same_documents_give_the_same_bytes_on_any_thread() {
    let words = Words::of("de").expect("German");
    let press = PdfCompiler::new(&words, None).unwrap_or_else(|f| panic!("{f}"));
    let documents: Vec<(Head, Document)> = (0..8)
        .map(|i| {
            let head = Head { title: "Räder".into(), name: format!("N{i}"), ..Head::default() };
            let markdown = format!(
                "# Räder\n\n$$\\begin{{aligned}} x &= {i} \\\\ y &= \\sqrt{{2}} \\end{{aligned}}$$\n"
            );
            (head, Document { markdown, pictures: Vec::new() })
        })
        .collect();
    let one = |(head, document): &(Head, Document)| press.press(&[(head, document)]).map_err(one_line);
    let first: Vec<_> = documents.iter().map(one).collect();
    let again: Vec<_> = std::thread::scope(|s| {
        let threads: Vec<_> = documents.iter().map(|d| s.spawn(move || one(d))).collect();
        threads.into_iter().map(|t| t.join().expect("a thread")).collect()
    });
    assert!(first == again);
    assert!(first[0] != first[1]);
    let (_folder, path) = in_file(first[0].as_ref().expect("a PDF"));
    let output = Command::new("pdfinfo").arg(&path).output().expect("pdfinfo of poppler-utils");
    let info = String::from_utf8_lossy(&output.stdout).into_owned();
    for line in ["Title: Räder, N0", "Author: N0", "Tagged: yes", "Pages: 1"] {
        let squeezed = info.lines().any(|l| l.split_whitespace().collect::<Vec<_>>().join(" ") == line);
        assert!(squeezed, "{line} in\n{info}");
    }
    assert!(!info.contains("CreationDate"), "{info}");
}

/// The other tests press few documents at a time. From a pool with many to do, each wait for the compiler once began the
/// next document on the same stack, until the stack was full.
#[test]
fn many_documents_need_no_more_stack_than_one() {
    let words = Words::english();
    let press = PdfCompiler::new(&words, None).unwrap_or_else(|f| panic!("{f}"));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).stack_size(1 << 20).build().expect("a pool");
    let sizes: Vec<usize> = pool.install(|| {
        let documents = (0..300).into_par_iter();
        documents
            .map(|i| {
                let markdown =
                    format!("# Sheet {i}\n\n1. $x = {i}$ <!-- answer -->\n2. $y$ <!-- answer -->\n");
                let document = Document { markdown, pictures: Vec::new() };
                press.press(&[(&Head::default(), &document)]).unwrap_or_else(|f| panic!("{f}")).len()
            })
            .collect()
    });
    assert!(sizes.iter().all(|s| *s > 1000));
}

#[test]
fn a_faulty_prelude_is_told_with_its_place() {
    let words = Words::english();
    let good = slipstick::sheet::typst::PRELUDE;
    let document = Document { markdown: "x\n".to_owned(), pictures: Vec::new() };
    let mine = "mine/print.typ";
    for (text, place, what) in [
        (good.replace("#let rule()", "#let rule("), Some(mine), "unclosed delimiter"),
        (good.replace("fill: accent)", "fill: no-such-ink)"), Some(mine), "unknown variable: no-such-ink"),
        (
            "#let book(..any, body) = body\n#let sheet(..any, body) = read(\"/etc/passwd\")\n".to_owned(),
            Some(mine),
            "stands alone",
        ),
        // What is not there has no place.
        ("#let book(..any, body) = body\n".to_owned(), None, "unknown variable: sheet"),
    ] {
        let press = PdfCompiler::new(&words, Some((mine, &text)));
        let fault = press.and_then(|p| p.press(&[(&Head::default(), &document)])).expect_err(what);
        let told = fault.to_string();
        assert!(told.contains(what), "{told}");
        assert_eq!(fault.file.as_deref(), place, "{told}");
        assert_eq!(fault.at.is_some(), place.is_some(), "{told}");
    }
}
