//! Time of one variant: draw with both roads and key, and its statement. Run with `cargo bench --bench variants`.
use divan::Bencher;
use divan::counter::ItemsCount;
use slipstick::bank::Bank;
use slipstick::problem::maker::Maker;
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::template::Templates;
use slipstick::words::Words;

const PROBLEMS: [&str; 4] = ["kinetic-energy", "pulled-rolling", "pulled-slipping", "spring-released"];
const EACH: u32 = 200;
const FEW: u32 = 20;

fn main() {
    divan::main();
}

fn bank() -> Bank {
    let text = include_str!("../../banks/wheels-on-inclines.yaml");
    slipstick::bank::load::scenes_only(text, "wheels-on-inclines.yaml").expect("the bank of the project")
}

#[divan::bench(args = PROBLEMS)]
fn draw_solve_twice_key(bencher: Bencher, id: &str) {
    let bank = bank();
    let problem = bank.problems.iter().find(|p| p.id == id).expect("a problem of the bank");
    let maker = Maker::new(problem, 1, "bench");
    bencher.counter(ItemsCount::new(EACH)).bench(|| {
        for student in 0..EACH {
            let variant = maker.variant(&student.to_string()).expect("satisfiable");
            divan::black_box(maker.key(&variant));
        }
    });
}

/// Joined bodies, whose ratios of velocities vary: bar 0.3 ms each.
#[divan::bench(args = ["sliding-ladder", "slider-crank", "four-bar-linkage"])]
fn draw_solve_twice_key_of_joined_bodies(bencher: Bencher, id: &str) {
    let text = include_str!("../../banks/rods-and-linkages.yaml");
    let bank =
        slipstick::bank::load::scenes_only(text, "rods-and-linkages.yaml").expect("a bank of the project");
    let problem = bank.problems.iter().find(|p| p.id == id).expect("a problem of the bank");
    let maker = Maker::new(problem, 1, "bench");
    bencher.counter(ItemsCount::new(FEW)).bench(|| {
        for student in 0..FEW {
            let variant = maker.variant(&student.to_string()).expect("satisfiable");
            divan::black_box(maker.key(&variant));
        }
    });
}

#[divan::bench(args = PROBLEMS)]
fn statement_in_markdown(bencher: Bencher, id: &str) {
    let bank = bank();
    let (templates, words) = (Templates::english(), Words::english());
    let index = bank.problems.iter().position(|p| p.id == id).expect("a problem of the bank");
    let maker = Maker::new(&bank.problems[index], 1, "bench");
    let variants: Vec<_> = (0..EACH).map(|s| maker.variant(&s.to_string()).expect("satisfiable")).collect();
    let sheets = Sheets::new(&templates, &words, &bank, "bench", &[index]).expect("templates");
    let mut room = SheetScratch::default();
    let mut out = Vec::new();
    bencher.counter(ItemsCount::new(EACH)).bench_local(|| {
        out.clear();
        for v in &variants {
            sheets.problem(0, v, &mut room, &mut out).expect("renders");
        }
        divan::black_box(out.len())
    });
}
