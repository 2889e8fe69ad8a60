//! Time of printed pages: one sheet, many sheets in one file, the translation of a sheet without the compiler.
//! `cargo bench --features pdf --bench pages`; the first sheet of a process also loads the fonts.
use divan::Bencher;
use slipstick::bank::{Bank, load};
use slipstick::problem::maker::Maker;
use slipstick::sheet::document::{Document, Head};
use slipstick::sheet::pdf::PdfCompiler;
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::sheet::typst;
use slipstick::template::Templates;
use slipstick::words::Words;

fn main() {
    divan::main();
}

/// Sheets of all problems of the first bank for so many students.
fn sheets(students: usize) -> Vec<(Head, Document)> {
    let text = include_str!("../../banks/wheels-on-inclines.yaml");
    let bank: Bank = load::scenes_only(text, "bank").expect("a bank");
    let mut templates = Templates::english();
    slipstick::sheet::statement::add_own(&mut templates, &bank).expect("statements");
    let words = Words::english();
    let all: Vec<usize> = (0..bank.problems.len()).collect();
    let sheets = Sheets::new(&templates, &words, &bank, "bench", &all).expect("templates");
    let makers: Vec<Maker> = bank.problems.iter().map(|p| Maker::new(p, 1, "bench")).collect();
    let mut room = SheetScratch::default();
    (0..students)
        .map(|i| {
            let student = format!("s{i}");
            let variants: Vec<_> = makers.iter().map(|m| m.variant(&student).expect("satisfiable")).collect();
            sheets.document(&student, "A Name", &variants, &mut room).expect("a sheet")
        })
        .collect()
}

/// A sheet of four problems, each time another student's.
#[divan::bench(sample_count = 40, sample_size = 1)]
fn one_sheet(bencher: Bencher) {
    let press = PdfCompiler::new(&Words::english(), None).expect("the built-in prelude");
    let all = sheets(41);
    let mut next = all.iter().cycle();
    bencher.bench_local(|| {
        let (head, document) = next.next().expect("sheets");
        press.press(&[(head, document)]).expect("a PDF")
    });
}

/// Fifty sheets in one file.
#[divan::bench(sample_count = 4, sample_size = 1)]
fn booklet_of_fifty(bencher: Bencher) {
    let press = PdfCompiler::new(&Words::english(), None).expect("the built-in prelude");
    let all = sheets(50);
    let documents: Vec<(&Head, &Document)> = all.iter().map(|(h, d)| (h, d)).collect();
    bencher.bench_local(|| press.press(&documents).expect("a PDF"));
}

/// Markdown and pictures to the source of Typst.
#[divan::bench]
fn source_of_one_sheet(bencher: Bencher) {
    let words = Words::english();
    let all = sheets(1);
    let documents: Vec<(&Head, &Document)> = all.iter().map(|(h, d)| (h, d)).collect();
    bencher.bench_local(|| typst::source(&documents, &words).expect("source"));
}
