//! Scenes of bodies on lines and about axles: rolling, slipping, sliding, cords, couples, one spring.
pub mod derivation;
pub mod energy;
pub mod instant;
pub mod mechanism;
pub mod motion;
pub mod regime;

use crate::scene::{End, Far, Owner, Quantity, Tie};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{Expr, magnitude};
use crate::solution::linear::derivation::{LinearDerivation, SolvingMethod, of_body};
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::text::{Block, SolutionSection};
use crate::solution::way;

/// Writes the sections of a scene of lines and axles.
///
/// # Errors
/// What the derivation does not cover, by name.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    if draft.scene.end == End::AtOnce {
        return instant::write(draft);
    }
    if draft.variant.solved.regime.stays() {
        return Err(Beyond::NothingMoves.into());
    }
    forces(draft);
    let slips: Vec<usize> =
        (0..draft.scene.ties.len()).filter(|t| matches!(draft.scene.ties[*t], Tie::Slip { .. })).collect();
    if slips.len() > 1 {
        return Err(Beyond::SeveralSlips.into());
    }
    let mut senses: Vec<(usize, f64)> = Vec::new();
    if let [tie] = slips.as_slice() {
        senses.push((*tie, rolled(draft, *tie)?));
    }
    let slip_sense = |t: usize| senses.iter().find(|(s, _)| *s == t).map_or(1.0, |(_, sense)| *sense);
    let title = |draft: &Draft, id: &str| draft.words.get(&format!("solution.title.{id}")).to_owned();

    let out = SolutionSection::new("eom", &title(draft, "eom"));
    let mut task = LinearDerivation::new(draft, SolvingMethod::Motion, false, &senses, out)?;
    motion::write(&mut task, &slip_sense)?;
    let heading = SolutionSection::new("regime", &title(task.draft, "regime"));
    let eom = std::mem::replace(&mut task.out, heading);
    regime::write(&mut task)?;
    let regime = task.out;
    draft.sections.push(eom);

    let out = SolutionSection::new("energy", &title(draft, "energy"));
    let mut task = LinearDerivation::new(draft, SolvingMethod::Energy, false, &senses, out)?;
    energy::write(&mut task, &slip_sense)?;
    let energy = task.out;
    draft.sections.push(energy);
    draft.sections.push(regime);
    Ok(())
}

/// The scene and its free bodies.
fn forces(draft: &mut Draft) {
    let mut section = SolutionSection::new("forces", draft.words.get("solution.title.forces"));
    section.blocks.push(Block::Picture("scene".to_owned()));
    let rolls = draft.scene.ties.iter().any(|t| matches!(t, Tie::Roll { .. } | Tie::Slip { .. }));
    let signs = if rolls { "solution.signs" } else { "solution.signs_drawn" };
    let mut text = vec![draft.say(signs, &[])];
    let rubbed: Vec<usize> = draft
        .scene
        .ties
        .iter()
        .filter_map(|t| match t {
            Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => Some(*body),
            Tie::Cord(_) => None,
        })
        .collect();
    if let Some(first) = rubbed.first() {
        let way = way(draft.scene, Owner::Body(*first), 1.0).map_or("", |w| draft.words.get(w));
        text.push(draft.say("solution.signs_friction", &[("way", way)]));
    }
    let related = draft.scene.ties.iter().any(|t| match t {
        Tie::Cord(cord) => matches!(cord.to, Far::Body(_) | Far::Fixed),
        Tie::Roll { .. } | Tie::Slip { .. } | Tie::Slide { .. } => false,
    });
    if related && draft.scene.bodies.iter().any(|b| b.turns && b.line.is_none()) {
        text.push(draft.say("solution.signs_axle", &[]));
    }
    section.say(text.join(" "));
    for body in &draft.scene.bodies {
        section.blocks.push(Block::Picture(format!("forces-{}", body.name)));
    }
    draft.sections.push(section);
}

/// Could it roll? The friction that rolling would need, by both methods; the sense of that friction, positive up.
fn rolled(draft: &mut Draft, tie: usize) -> Result<f64, DerivationStop> {
    let Tie::Slip { body, mu_s, .. } = draft.scene.ties[tie] else {
        return Err(Beyond::Arrangement.into());
    };
    let label = of_body(Quantity::FrictionIfRolled, body);
    let friction = of_body(Quantity::Friction, body);
    let out = SolutionSection::new("rolled", draft.words.get("solution.title.rolled"));
    let mut task = LinearDerivation::new(draft, SolvingMethod::Motion, true, &[], out)?;
    task.tell("rolled.motion", &[]);
    motion::write(&mut task, &|_| 1.0)?;
    let needed = task.get(friction)?;
    let normal = task.get(of_body(Quantity::Normal, body))?;
    let value = task.draft.symbols.value(needed);
    task.draft.from_motion(label, DerivedAnswer::Value(needed));
    let mut section = task.out;

    let out = SolutionSection::new("rolled", "");
    let mut task = LinearDerivation::new(draft, SolvingMethod::Energy, true, &[], out)?;
    task.tell("rolled.energy", &[]);
    energy::write(&mut task, &|_| 1.0)?;
    let again = task.get(friction)?;
    task.draft.from_energy(label, DerivedAnswer::Value(again));
    section.blocks.append(&mut task.out.blocks);

    let mu = draft.number(mu_s, r"\mu_s", "1");
    let limit = draft.unknown(&draft.free(&[r"F_{\mathrm{max}}"]), "N");
    section.find(&mut draft.symbols, limit, &(mu * normal));
    let size = magnitude(Expr::from(needed)).symbols(&draft.symbols);
    let size = format!("{size} = {}", draft.symbols.shown(needed).trim_start_matches('-'));
    let most = draft.symbols.tex(limit).to_owned();
    let slips = value.abs() > draft.symbols.value(limit);
    let sense = way(draft.scene, Owner::Body(body), value).map_or("", |w| draft.words.get(w));
    let name = if slips { "solution.rolled.slips" } else { "solution.rolled.rolls" };
    let pieces = [("needed", format!("${size}$")), ("limit", format!("${most}$")), ("way", sense.to_owned())];
    let pieces: Vec<(&str, &str)> = pieces.iter().map(|(n, t)| (*n, t.as_str())).collect();
    section.say(draft.say(name, &pieces));
    draft.sections.push(section);
    if !slips {
        return Err(Beyond::RollsAfterAll.into());
    }
    Ok(value.signum())
}
