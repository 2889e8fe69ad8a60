//! Scenes of bodies on lines and about axles: rolling, slipping, sliding, cords, couples, one spring.
pub mod energy;
pub mod instant;
pub mod mechanism;
pub mod motion;
pub mod regime;
pub mod walk;

use crate::scene::End;
use crate::scene::Far;
use crate::scene::Owner;
use crate::scene::Quantity;
use crate::scene::Tie;
use crate::solution::desk::Answer;
use crate::solution::desk::Desk;
use crate::solution::expr::Expr;
use crate::solution::expr::magnitude;
use crate::solution::linear::walk::Road;
use crate::solution::linear::walk::Walk;
use crate::solution::linear::walk::of_body;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;
use crate::solution::text::Block;
use crate::solution::text::Section;
use crate::solution::way;

/// Writes the sections of a scene of lines and axles.
///
/// # Errors
/// What the derivation does not cover, by name.
pub fn sections(desk: &mut Desk) -> Result<(), Stop> {
    if desk.scene.end == End::AtOnce {
        return instant::write(desk);
    }
    if desk.variant.solved.regime.stays() {
        return Err(Beyond::NothingMoves.into());
    }
    forces(desk);
    let slips: Vec<usize> =
        (0..desk.scene.ties.len()).filter(|t| matches!(desk.scene.ties[*t], Tie::Slip { .. })).collect();
    if slips.len() > 1 {
        return Err(Beyond::SeveralSlips.into());
    }
    let mut senses: Vec<(usize, f64)> = Vec::new();
    if let [tie] = slips.as_slice() {
        senses.push((*tie, rolled(desk, *tie)?));
    }
    let slip_sense = |t: usize| senses.iter().find(|(s, _)| *s == t).map_or(1.0, |(_, sense)| *sense);
    let title = |desk: &Desk, id: &str| desk.words.get(&format!("solution.title.{id}")).to_owned();

    let out = Section::new("eom", &title(desk, "eom"));
    let mut walk = Walk::new(desk, Road::Motion, false, &senses, out)?;
    motion::write(&mut walk, &slip_sense)?;
    let heading = Section::new("regime", &title(walk.desk, "regime"));
    let eom = std::mem::replace(&mut walk.out, heading);
    regime::write(&mut walk)?;
    let regime = walk.out;
    desk.sections.push(eom);

    let out = Section::new("energy", &title(desk, "energy"));
    let mut walk = Walk::new(desk, Road::Energy, false, &senses, out)?;
    energy::write(&mut walk, &slip_sense)?;
    let energy = walk.out;
    desk.sections.push(energy);
    desk.sections.push(regime);
    Ok(())
}

/// The scene and its free bodies.
fn forces(desk: &mut Desk) {
    let mut section = Section::new("forces", desk.words.get("solution.title.forces"));
    section.blocks.push(Block::Picture("scene".to_owned()));
    let rolls = desk.scene.ties.iter().any(|t| matches!(t, Tie::Roll { .. } | Tie::Slip { .. }));
    let signs = if rolls { "solution.signs" } else { "solution.signs_drawn" };
    let mut text = vec![desk.say(signs, &[])];
    let rubbed: Vec<usize> = desk
        .scene
        .ties
        .iter()
        .filter_map(|t| match t {
            Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. } => Some(*body),
            Tie::Cord(_) => None,
        })
        .collect();
    if let Some(first) = rubbed.first() {
        let way = way(desk.scene, Owner::Body(*first), 1.0).map_or("", |w| desk.words.get(w));
        text.push(desk.say("solution.signs_friction", &[("way", way)]));
    }
    let related = desk.scene.ties.iter().any(|t| match t {
        Tie::Cord(cord) => matches!(cord.to, Far::Body(_) | Far::Fixed),
        Tie::Roll { .. } | Tie::Slip { .. } | Tie::Slide { .. } => false,
    });
    if related && desk.scene.bodies.iter().any(|b| b.turns && b.line.is_none()) {
        text.push(desk.say("solution.signs_axle", &[]));
    }
    section.say(text.join(" "));
    for body in &desk.scene.bodies {
        section.blocks.push(Block::Picture(format!("forces-{}", body.name)));
    }
    desk.sections.push(section);
}

/// Could it roll? The friction that rolling would need, on both roads; the sense of that friction, positive up.
fn rolled(desk: &mut Desk, tie: usize) -> Result<f64, Stop> {
    let Tie::Slip { body, mu_s, .. } = desk.scene.ties[tie] else {
        return Err(Beyond::Arrangement.into());
    };
    let label = of_body(Quantity::FrictionIfRolled, body);
    let friction = of_body(Quantity::Friction, body);
    let out = Section::new("rolled", desk.words.get("solution.title.rolled"));
    let mut walk = Walk::new(desk, Road::Motion, true, &[], out)?;
    walk.tell("rolled.motion", &[]);
    motion::write(&mut walk, &|_| 1.0)?;
    let needed = walk.get(friction)?;
    let normal = walk.get(of_body(Quantity::Normal, body))?;
    let value = walk.desk.ledger.value(needed);
    walk.desk.from_motion(label, Answer::Value(needed));
    let mut section = walk.out;

    let out = Section::new("rolled", "");
    let mut walk = Walk::new(desk, Road::Energy, true, &[], out)?;
    walk.tell("rolled.energy", &[]);
    energy::write(&mut walk, &|_| 1.0)?;
    let again = walk.get(friction)?;
    walk.desk.from_energy(label, Answer::Value(again));
    section.blocks.append(&mut walk.out.blocks);

    let mu = desk.number(mu_s, r"\mu_s", "1");
    let limit = desk.unknown(&desk.free(&[r"F_{\mathrm{max}}"]), "N");
    section.find(&mut desk.ledger, limit, &(mu * normal));
    let size = magnitude(Expr::from(needed)).symbols(&desk.ledger);
    let size = format!("{size} = {}", desk.ledger.shown(needed).trim_start_matches('-'));
    let most = desk.ledger.tex(limit).to_owned();
    let slips = value.abs() > desk.ledger.value(limit);
    let sense = way(desk.scene, Owner::Body(body), value).map_or("", |w| desk.words.get(w));
    let name = if slips { "solution.rolled.slips" } else { "solution.rolled.rolls" };
    let pieces = [("needed", format!("${size}$")), ("limit", format!("${most}$")), ("way", sense.to_owned())];
    let pieces: Vec<(&str, &str)> = pieces.iter().map(|(n, t)| (*n, t.as_str())).collect();
    section.say(desk.say(name, &pieces));
    desk.sections.push(section);
    if !slips {
        return Err(Beyond::RollsAfterAll.into());
    }
    Ok(value.signum())
}
