//! Both roads on thousands of valid draws of every family, in every case of the banks.
use crate::support;
use rayon::prelude::*;
use slipstick::num::U;
use slipstick::problem::maker::Maker;

#[test]
fn the_roads_agree_on_thousands_of_draws_of_every_family() {
    let mut banks = support::banks();
    // What a student may get wrong is no matter of the roads: without those guards more draws count, and each is cheaper.
    banks.iter_mut().flat_map(|b| &mut b.problems).for_each(|p| p.mistakes.clear());
    banks.par_iter().for_each(|bank| {
        bank.problems.par_iter().for_each(|problem| {
            let maker = Maker::new(problem, 20_261_121, "two roads");
            let draws = support::seeds(10_000 / support::dear(problem));
            let (mut worst, mut compared) = (0.0f64, 0u64);
            for student in 0..draws {
                let variant =
                    maker.variant(&student.to_string()).expect("a bank of the project can be satisfied");
                for e in &variant.solved.entries {
                    let gap =
                        e.gap().unwrap_or_else(|| panic!("{}: one road only for {:?}", problem.id, e.label));
                    if gap.is_nan() {
                        // Both roads say that it is infinite.
                        assert_eq!(e.eom, e.energy, "{}: {:?}", problem.id, e.label);
                        continue;
                    }
                    let bar = gap / U / e.cond.max(1.0);
                    assert!(bar <= 16.0, "{}: {:?}: {:?} against {:?}", problem.id, e.label, e.eom, e.energy);
                    worst = worst.max(bar);
                    compared += 1;
                }
            }
            println!("{}: {compared} values, worst gap {worst:.2} u max(1, cond)", problem.id);
            assert!(compared >= u64::from(draws) * 4);
        });
    });
}
