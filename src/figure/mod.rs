//! Pictures of scenes: what stands where; looks and formats are those of every picture ([`crate::picture`]).
//!
//! [`scene::picture`] is the figure of a statement. It shows what is given and what a student may assume, never what the
//! solver found: no direction that is asked, no friction.
use crate::bank::{FigureLabels, Problem};
use crate::picture::Picture;
use crate::problem::maker::Variant;
use crate::words::Words;

pub mod bars;
pub mod forces;
pub mod graph;
pub(crate) mod joined;
pub(crate) mod lamina;
pub(crate) mod layout;
pub mod names;
pub(crate) mod parts;
pub(crate) mod say;
pub mod scene;
pub(crate) mod view;

/// All pictures for a worked solution, by name: `scene`, `forces-BODY` for each body, `graph-...`, `energy`.
pub fn all(problem: &Problem, variant: &Variant, words: &Words) -> Vec<(String, Picture)> {
    let labels = match problem.figure {
        FigureLabels::Symbols => FigureLabels::Symbols,
        FigureLabels::Values | FigureLabels::None => FigureLabels::Values,
    };
    let mut list = vec![("scene".to_owned(), scene::worked(problem, variant, words, labels))];
    let bodies = problem.cases.get(variant.case).map_or(&[][..], |c| &c.scene.bodies);
    for (i, body) in bodies.iter().enumerate() {
        if forces::known(problem, variant, i) {
            let name = format!("forces-{}", body.name);
            list.push((name, forces::free_body(problem, variant, words, i)));
        }
    }
    if problem.cases.get(variant.case).is_some_and(|c| c.scene.carried.is_some()) {
        return list;
    }
    list.extend(graph::all(problem, variant, words));
    if let Some(picture) = bars::picture(problem, variant, words) {
        list.push(("energy".to_owned(), picture));
    }
    list
}
