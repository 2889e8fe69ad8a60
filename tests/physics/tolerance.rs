//! A tolerance that widens with the condition number is printed with its question, and what is printed is what counts.
use crate::support;
use slipstick::key::Answer;
use slipstick::problem::make_key;
use slipstick::problem::maker::Maker;
use slipstick::sheet::public::Writer;
use slipstick::sheet::sheets::{SheetScratch, Sheets};
use slipstick::sheet::statement;
use slipstick::template::Templates;
use slipstick::words::Words;

#[test]
fn what_is_printed_is_what_counts() {
    let banks = support::banks();
    let bank = banks.iter().find(|b| b.id == "wheels-on-inclines").expect("a bank");
    let index = bank.problems.iter().position(|p| p.id == "pulled-slipping").expect("a problem");
    let problem = &bank.problems[index];
    let mut templates = Templates::english();
    let words = Words::english();
    statement::add_own(&mut templates, bank).expect("statements");
    let sheets = Sheets::new(&templates, &words, bank, "tolerance", &[index]).expect("templates");
    let text = include_str!("../../banks/wheels-on-inclines.yaml");
    let public = Writer::new(bank, text, &[index], "tolerance", "en").expect("the bank");
    let maker = Maker::new(problem, 3, "tolerance");
    let mut room = SheetScratch::default();
    let mut seen = std::collections::BTreeSet::new();
    for student in 0..200 {
        let variant = maker.variant(&student.to_string()).expect("satisfiable");
        let mut page = Vec::new();
        sheets.problem(0, &variant, &mut room, &mut page).expect("renders");
        let page = String::from_utf8(page).expect("text");
        let file: serde_json::Value =
            serde_json::from_str(&public.text("s", std::slice::from_ref(&variant))).expect("JSON");
        let key = make_key::key(problem, &variant);
        for (i, (part, question)) in key.parts.iter().zip(&problem.questions).enumerate() {
            let Answer::Number { value, half_width, .. } = part.answer else { continue };
            let line =
                page.lines().find(|l| l.contains(&format!("`1.{}`", question.id))).expect("the question");
            let printed = line.split("within ").nth(1).and_then(|t| t.split(" %").next());
            let share = printed.map_or(0.01, |p| p.parse::<f64>().expect("a number") / 100.0);
            let told = file["problems"][0]["parts"][i]["tolerance"].as_f64().expect("a number");
            assert!((told - share).abs() < 1e-12, "{line}: {told}");
            // An absolute tolerance may be wider.
            assert!(half_width >= share * value.abs() * (1.0 - 1e-12), "{line}: {half_width} of {value}");
            if question.id == "heat" {
                assert!((half_width / value - share).abs() < 1e-12, "{line}: {half_width} of {value}");
                seen.insert((share * 1000.0).round().to_string());
                assert!((0.01..=0.05).contains(&share), "{line}");
            }
            assert_eq!(printed.is_some(), question.relative.fixed().is_none() && share > 0.01, "{line}");
        }
    }
    assert!(seen.len() > 15, "tolerances of the heat, in tenths of a per cent: {seen:?}");
}
