//! Kinetic energy of bodies at an instant: its definition, body by body.
use crate::scene::Degree;
use crate::scene::Quantity;
use crate::scene::Start;
use crate::scene::Tie;
use crate::solution::desk::Answer;
use crate::solution::desk::Desk;
use crate::solution::expr::Expr;
use crate::solution::expr::product;
use crate::solution::expr::quotient;
use crate::solution::expr::ratio;
use crate::solution::expr::square;
use crate::solution::expr::sum;
use crate::solution::linear::mechanism;
use crate::solution::linear::walk::of_scene;
use crate::solution::stop::Stop;
use crate::solution::text::Section;

/// Writes the sum.
///
/// # Errors
/// What the derivation does not cover.
pub fn write(desk: &mut Desk) -> Result<(), Stop> {
    let parts = mechanism::parts(desk, false);
    let mut section = Section::new("energy", desk.words.get("solution.title.energy"));
    section.say(desk.words.get("solution.instant"));
    let mut terms = Vec::new();
    for (body, part) in parts.iter().enumerate() {
        let mut speeds: [Option<Expr>; 2] = [None, None];
        for start in &desk.scene.start {
            if let Start::Speed(c, num) = start
                && c.body == body
            {
                let (at, tex, unit) = match c.degree {
                    Degree::Along => (0, "v", "m/s"),
                    Degree::Turn => (1, r"\omega", "rad/s"),
                };
                speeds[at] = Some(desk.number(*num, tex, unit));
            }
        }
        let rolls = desk.scene.ties.iter().find_map(|t| match t {
            Tie::Roll { body: b, radius_m, .. } if *b == body => Some(*radius_m),
            _ => None,
        });
        if let Some(radius) = rolls {
            let c = desk.number(radius, "R", "m");
            match speeds.clone() {
                [None, Some(spin)] => speeds[0] = Some(product([c, spin])),
                [Some(v), None] => speeds[1] = Some(quotient(v, c)),
                _ => {}
            }
        }
        for (degree, speed) in [Degree::Along, Degree::Turn].into_iter().zip(speeds) {
            let Some(speed) = speed else { continue };
            let inertia = match degree {
                Degree::Along if part.a.is_some() => vec![part.mass.clone()],
                Degree::Along => Vec::new(),
                Degree::Turn => part.inertia.clone(),
            };
            terms.extend(inertia.iter().map(|i| product([ratio(1, 2), i.expr(), square(speed.clone())])));
        }
    }
    let label = of_scene(Quantity::KineticEnergy);
    let tex = desk.free(&["E_{k}"]);
    let energy = desk.unknown(&tex, "J");
    section.find(&mut desk.ledger, energy, &sum(terms));
    desk.sections.push(section);
    let note = desk.words.get("solution.instant_note").to_owned();
    desk.from_one_road(label, Answer::Value(energy), &note);
    Ok(())
}
