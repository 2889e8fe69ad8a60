//! The task of the Python script in tests/baseline: N variants of one problem, their statements in one file, one key file.
//!
//! `cargo bench --bench one_file -- N THREADS FOLDER`
#![allow(clippy::print_stdout, reason = "it prints its figures")]
use slipstick::problem::maker::Maker;
use slipstick::set::key_file::shortest;
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::template::Templates;
use slipstick::words::Words;
use std::fmt::Write as _;
use std::io::Write as _;

fn main() {
    let mut args = std::env::args().skip(1).filter(|a| !a.starts_with("--"));
    let count: usize = args.next().map_or(100_000, |a| a.parse().expect("N"));
    let threads: usize = args.next().map_or(1, |a| a.parse().expect("THREADS"));
    let folder = std::path::PathBuf::from(args.next().unwrap_or_else(|| "target/one-file".to_owned()));
    std::fs::create_dir_all(&folder).expect("a folder for the two files");
    let start = std::time::Instant::now();
    let text = include_str!("../../banks/wheels-on-inclines.yaml");
    let bank =
        slipstick::bank::load::scenes_only(text, "wheels-on-inclines.yaml").expect("the bank of the project");
    let (templates, words) = (Templates::english(), Words::english());
    let index = bank.problems.iter().position(|p| p.id == "pulled-rolling").expect("a problem of the bank");
    let problem = &bank.problems[index];
    let sheets = Sheets::new(&templates, &words, &bank, "one file", &[index]).expect("templates");
    let maker = Maker::new(problem, 1, "one file");
    let share = count.div_ceil(threads);
    let parts: Vec<(Vec<u8>, String, u64)> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads)
            .map(|t| {
                let (sheets, maker) = (&sheets, &maker);
                scope.spawn(move || {
                    let mut room = SheetScratch::default();
                    let (mut statements, mut key, mut tries) = (Vec::new(), String::new(), 0);
                    for i in t * share..((t + 1) * share).min(count) {
                        let variant = maker.variant(&i.to_string()).expect("satisfiable");
                        tries += u64::from(variant.tries);
                        sheets.problem(0, &variant, &mut room, &mut statements).expect("renders");
                        let _ = write!(key, "{i}");
                        for x in &variant.data {
                            let _ = write!(key, ",{x}");
                        }
                        for part in maker.key(&variant).parts {
                            let _ = write!(key, ",{}", part.eom.map_or_else(String::new, shortest));
                        }
                        key.push('\n');
                    }
                    (statements, key, tries)
                })
            })
            .collect();
        workers.into_iter().map(|w| w.join().expect("a worker")).collect()
    });
    let mut statements = std::fs::File::create(folder.join("statements.md")).expect("statements.md");
    let mut key = std::fs::File::create(folder.join("key.csv")).expect("key.csv");
    let (mut bytes, mut tries) = (0, 0);
    for (s, k, t) in &parts {
        statements.write_all(s).expect("statements.md");
        key.write_all(k.as_bytes()).expect("key.csv");
        bytes += s.len();
        tries += t;
    }
    let wall = start.elapsed().as_secs_f64();
    println!(
        "n={count} threads={threads} tried={tries} wall={wall:.4} us_per_variant={:.2} characters_each={}",
        wall / count as f64 * 1e6,
        bytes / count.max(1)
    );
}
