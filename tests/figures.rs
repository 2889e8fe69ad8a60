//! Pictures over the whole range of draws: labels apart and inside, shapes inside, numbers finite.
mod support;
use slipstick::bank::FigureLabels;
use slipstick::figure;
use slipstick::problem::make::Maker;
use slipstick::words::Words;

#[test]
fn labels_of_scenes_are_apart_and_inside() {
    let words = Words::english();
    for bank in support::banks() {
        for problem in &bank.problems {
            let maker = Maker::new(problem, 1, "figures");
            for student in 0..20 {
                let variant = maker.variant(&student.to_string()).expect("satisfiable");
                let picture = figure::scene::picture(problem, &variant, &words, FigureLabels::Values);
                for (i, a) in picture.labels.iter().enumerate() {
                    let f = a.bounds;
                    assert!(f.0 >= 0.0 && f.1 >= 0.0 && f.2 <= picture.width && f.3 <= picture.height);
                    for b in &picture.labels[i + 1..] {
                        let g = b.bounds;
                        let apart = f.2 <= g.0 || g.2 <= f.0 || f.3 <= g.1 || g.3 <= f.1;
                        assert!(apart, "{} {student}: {:?} {:?}", problem.id, a.runs, b.runs);
                    }
                }
            }
        }
    }
}
