//! Reads the mistakes that a worked solution warns of and holds them against the wrong methods of the problem, computed anew.
use slipstick::bank::Problem;
use slipstick::misconception;
use slipstick::misconception::catalogue::Catalogue;
use slipstick::problem::maker::Variant;
use slipstick::scene::Label;
use slipstick::words::Words;

/// The number that a formula begins with, `1{,}5 \cdot 10^{-7}\ \mathrm{m}` in German.
fn number(tex: &str) -> Option<f64> {
    let tex = tex.replace("{,}", ".");
    let digits = tex.find(|c: char| !c.is_ascii_digit() && c != '.' && c != '-').unwrap_or(tex.len());
    let power = tex[digits..].strip_prefix(r" \cdot 10^{").and_then(|rest| rest.split_once('}'));
    format!("{}e{}", &tex[..digits], power.map_or("0", |(n, _)| n)).parse().ok()
}

/// What is wrong with the warnings of a solution; counts them.
pub fn check(
    markdown: &str,
    problem: &Problem,
    variant: &Variant,
    words: &Words,
    told: &mut u32,
) -> Vec<String> {
    let title = format!("**{}**\n", words.get("solution.title.beware"));
    let section = markdown.split_once(&title).map_or("", |(_, rest)| rest.split("\n**").next().unwrap_or(""));
    let items: Vec<&str> = section.lines().filter_map(|l| l.strip_prefix("- ")).collect();
    let mut faults = Vec::new();
    if items.is_empty() != problem.mistakes.is_empty() || items.len() > 3 {
        faults.push(format!("{} of {} wrong methods are told", items.len(), problem.mistakes.len()));
    }
    let catalogue = Catalogue::of(words.language()).expect("a catalogue");
    let labels: Vec<Label> = problem.questions.iter().map(|q| q.label).collect();
    let wrong = misconception::values(problem, variant.case, &variant.data, &variant.solved, &labels);
    let mut before = Vec::new();
    for item in items {
        *told += 1;
        let mut questions = problem.questions.iter().enumerate();
        let Some((at, question)) = questions.find(|(_, q)| item.contains(&format!("`1.{}`", q.id))) else {
            faults.push(format!("of no question: {item}"));
            continue;
        };
        // Several methods may bear the same words; one of them comes to this number.
        let named = problem.mistakes.iter().enumerate().filter_map(|(i, m)| {
            let entry = catalogue.get(&m.id)?;
            let middle = item.strip_prefix(entry.did.as_str())?.strip_suffix(entry.see.as_str())?;
            Some((i, middle.split('$').nth(1).and_then(number)?))
        });
        let scene = &problem.cases[variant.case].scene;
        let size = |x: f64| if scene.is_magnitude(question.label) { x.abs() } else { x };
        let half = 0.5 * 10f64.powi(1 - i32::from(question.figures)) * (1.0 + 1e-9);
        let near = |printed: f64, value: f64| {
            let value = question.unit.from_si(size(value));
            (printed - value).abs() <= half * value.abs()
        };
        let right = variant.solved.get(question.label).map_or(f64::NAN, |e| e.value());
        let fits: Vec<f64> = named
            .filter(|(i, printed)| {
                let here = wrong.iter().find(|w| w.mistake == *i && w.label == question.label);
                here.is_some_and(|w| near(*printed, w.value))
            })
            .map(|(_, printed)| printed)
            .collect();
        match fits.first() {
            None => faults.push(format!("not what a wrong method comes to: {item}")),
            Some(printed) if (question.unit.from_si(right) - printed).abs() < 1e-12 * printed.abs() => {
                faults.push(format!("the right answer: {item}"));
            }
            Some(printed) => {
                let here = (at, printed.to_bits());
                if before.contains(&here) {
                    faults.push(format!("told twice: {item}"));
                }
                if before.last().is_some_and(|(last, _)| *last > at) {
                    faults.push(format!("out of order: {item}"));
                }
                before.push(here);
            }
        }
    }
    faults
}
