//! The quantities of a scene: which the solvers tell of it, under which names, and why it has not the others.
use crate::bank::asked;
use crate::bank::node::shorten;
use crate::scene::{
    Attach, Cord, Degree, End, Far, JointKind, Label, Owner, Quantity, RotaryInertia, Scene, Slope, Spot, Tie,
};
use crate::units::spell;

/// The label of a name such as `omega`, `block.v` or `left.tension`, if the scene has it; else what to say.
pub fn named(scene: &Scene, name: &str) -> Result<Label, (String, Option<String>)> {
    if let Some(label) = asked::label(scene, name) {
        return Ok(label);
    }
    let (owner, bare) = match name.rsplit_once('.') {
        Some((owner, quantity)) => (Some(owner), quantity),
        None => (None, name),
    };
    let Some(quantity) = Quantity::from_name(bare) else {
        let hint = spell::did_you_mean(bare, Quantity::ALL.iter().map(|q| q.name())).unwrap_or_else(|| {
            let names = || of(scene).into_iter().map(|l| scene.name_of(l));
            format!("quantities of this scene: {}", names().collect::<Vec<_>>().join(", "))
        });
        return Err((format!("`{}` is no quantity", shorten(name)), Some(hint)));
    };
    let found: Vec<Label> = of(scene).into_iter().filter(|l| l.quantity == quantity).collect();
    let shown = shorten(name);
    if found.is_empty() {
        return Err((
            format!("`{shown}` does not exist in this scene"),
            Some(format!("`{}` is: {}; {}", bare, quantity.meaning(), reason(scene, quantity))),
        ));
    }
    let names = || found.iter().map(|l| format!("`{}`", scene.name_of(*l))).collect::<Vec<_>>().join(", ");
    match owner {
        None => match found
            .iter()
            .find(|l| scene.name_of(**l) == bare)
            .or(found.first().filter(|_| found.len() == 1))
        {
            Some(label) => Ok(*label),
            None => Err((format!("`{shown}`: of what?"), Some(format!("this scene has {}", names())))),
        },
        Some(owner) => {
            let belongs = |l: &&Label| scene.owner_name(l.of).is_some_and(|name| name == owner);
            found.iter().find(belongs).copied().ok_or_else(|| {
                let hint = format!("this scene has {}", names());
                (format!("`{shown}` does not exist in this scene"), Some(hint))
            })
        }
    }
}

/// What only particles or a pinned body have, at rest or not.
#[rustfmt::skip] // a table
const OF_PARTICLES_AND_PINS: [Quantity; 13] = {
    use Quantity as Q;
    [
        Q::XG, Q::YG, Q::IG, Q::IO, Q::PinRadial, Q::PinTangential, Q::PinForce, Q::PinX, Q::PinY, Q::PinAngle,
        Q::SpringForce, Q::OmegaMax, Q::Period,
    ]
};

/// Why a scene has not this quantity, for hints.
pub fn reason(scene: &Scene, quantity: Quantity) -> String {
    use Quantity as Q;
    if scene.carried.is_some() && matches!(quantity, Q::Distance | Q::Rise | Q::WorkPull) {
        return "where a belt, a truck or a lift carries the scene it is not told".to_owned();
    }
    if quantity.is_of_mass_centre() && (0..scene.bodies.len()).any(|body| scene.holes(body).next().is_some())
    {
        return "of a body with a hole it is not told: ask `v` of a named point, or `x_G`, `I_G` of the whole".to_owned();
    }
    let aslant = |tie: &Tie| matches!(tie, Tie::Cord(cord) if cord.from.tilt_deg.is_some());
    if quantity == Quantity::CordTravel && scene.ties.iter().any(aslant) {
        return "it is told of a cord that is pulled along the line of its body, not at an angle to it"
            .to_owned();
    }
    if !scene.is_still() || OF_PARTICLES_AND_PINS.contains(&quantity) {
        return why(quantity).to_owned();
    }
    let names = || of(scene).into_iter().map(|l| scene.name_of(l));
    let (end, what) = match scene.end {
        End::Equilibrium => ("equilibrium", "at rest there"),
        _ => ("at once", "at the start"),
    };
    format!("with `end: {end}` only what holds {what} is asked: {}", names().collect::<Vec<_>>().join(", "))
}

/// What a quantity needs, for hints.
#[rustfmt::skip] // a table
const fn why(quantity: Quantity) -> &'static str {
    use Quantity as Q;
    match quantity {
        Q::Omega | Q::Alpha | Q::Phi | Q::AngularMomentum => "nothing turns here",
        Q::V | Q::A | Q::Displacement | Q::Distance | Q::Rise | Q::Impulse => "nothing moves along a line here",
        Q::Friction | Q::Normal => "nothing touches a surface here",
        Q::MuRequired => "nothing rolls or slips here",
        Q::SlipDistance | Q::FrictionIfRolled => "it needs a tie `slips`",
        Q::SlipSpeed | Q::ARolling => "it needs a body that `slips` and starts with a speed and a spin",
        Q::Rolls => "it needs a tie `slips`, or `rolls` with mu_s",
        Q::Heat => "it needs a tie `slips` or `slides`",
        Q::Tension => "it needs a cord whose pull is not given",
        Q::RimForce => "it needs a tie `meshes`, `belt` or `rests`",
        Q::CordTravel => "it needs a cord that is pulled or held by a spring",
        Q::WorkPull | Q::PowerPull => "it needs a cord with `pulled with`",
        Q::WorkCouple | Q::PowerCouple => "it needs a couple under `forces`, the power also a driven body in the plane",
        Q::KBound => "it needs one wheel with a radius of gyration that rolls and is pulled",
        Q::XEq => "it needs a spring",
        Q::VMax | Q::DAtVMax | Q::DTurn => "it needs an end of a body on a line, and a spring or a speed at the start",
        Q::XG | Q::YG | Q::IG => "it needs a body of particles, or a pin that holds bodies in the plane welded into one",
        Q::IO | Q::PinRadial | Q::PinTangential | Q::PinForce | Q::PinX | Q::PinY | Q::PinAngle => "it needs a pinned body, or one about a fixed axle whose mass and whose cords' directions are told, where no cord leaves two bodies on surfaces to the same side",
        Q::SpringForce => "it needs a spring on a pinned body",
        Q::OmegaMax | Q::Period => "it needs a pinned body that swings under its weight alone",
        Q::PeriodSmall | Q::OmegaSmall => "it needs a pinned body that swings under its weight alone, a spring and no friction of sliding, or, of bodies in the plane, `end: equilibrium`",
        Q::Moment => "it needs a weld or a torsion spring",
        Q::Drive => "it needs a driven body: `start: {crank: {angle: phi, spin: w, alpha: 0 rad/s^2}}` and `end: at once`",
        Q::ImpulseX | Q::ImpulseY => "it needs a pin or a hinge, and an impulse under `forces`",
        Q::FrictionImpulse => "it needs a body that `rolls` in the plane, and an impulse under `forces`",
        Q::Work => "it needs a motion on lines without a spring, and no slip from a speed at the start",
        Q::VX | Q::VY | Q::AX | Q::AY => "it needs a body that moves in the plane",
        Q::T | Q::RotationalFraction | Q::KineticEnergy => "it needs a motion, the time one without a force that grows with place",
        Q::Direction => "it needs a motion, and cords that leave one body to the right and the other to the left: `leaves: forward` on a slope, `leaves: back` on the table beyond its pulley",
        Q::Angle => "it needs a body in the plane that leads the others by the angle told at the start, and an end at a time, a speed, a turning point or a contact lost",
        Q::Value => "it needs a question with `value:`",
    }
}

/// All labels that the solvers can give for this structure.
pub fn of(scene: &Scene) -> Vec<Label> {
    let mut list = of_kind(scene);
    list.retain(|label| scene.tells(*label));
    list
}

/// Labels as they are gathered, each once: several bodies may rub, and there is one heat.
#[derive(Default)]
struct Gathered(Vec<Label>);

impl Gathered {
    /// Adds these quantities of an owner, if it has them.
    fn add(&mut self, has: bool, of: Owner, quantities: &[Quantity]) {
        for label in quantities.iter().filter(|_| has).map(|q| Label { quantity: *q, of }) {
            if !self.0.contains(&label) {
                self.0.push(label);
            }
        }
    }
}

/// The same of a scene that nothing carries.
fn of_kind(scene: &Scene) -> Vec<Label> {
    use Quantity as Q;
    let mut all = Gathered::default();
    all.add(!matches!(scene.end, End::Equilibrium), Owner::Scene, &[Q::KineticEnergy]);
    if let Some((b, _)) = scene.pinned() {
        pinned(scene, b, &mut all);
    } else if scene.lead().is_some() {
        joined(scene, &mut all);
    } else {
        on_lines(scene, &mut all);
    }
    all.0
}

/// The labels of what couples do: their work on lines, on axles and about a pin, their power at an instant, too.
fn couples(scene: &Scene, work: bool, all: &mut Gathered) {
    let driven = scene.driven().and(scene.lead());
    for body in scene.couples.iter().map(|couple| couple.body).chain(driven) {
        all.add(work, Owner::Body(body), &[Quantity::WorkCouple]);
        all.add(true, Owner::Body(body), &[Quantity::PowerCouple]);
    }
}

/// The labels of a pinned body.
fn pinned(scene: &Scene, body: usize, all: &mut Gathered) {
    use Quantity as Q;
    let (of, moves) = (Owner::Body(body), !scene.is_still());
    all.add(true, Owner::Scene, &[Q::RotationalFraction]);
    all.add(true, of, &[Q::Omega, Q::V, Q::Alpha, Q::IO, Q::AngularMomentum]);
    all.add(true, of, &[Q::PinRadial, Q::PinTangential, Q::PinForce, Q::PinX, Q::PinY, Q::PinAngle]);
    couples(scene, moves, all);
    all.add(moves, Owner::Scene, &[Q::T]);
    all.add(moves, of, &[Q::Phi, Q::Rise]);
    all.add(scene.ends_at_an_angle().is_some(), of, &[Q::Angle]);
    all.add(scene.is_pendulum(), of, &[Q::OmegaMax, Q::Period, Q::PeriodSmall, Q::OmegaSmall]);
    all.add(!scene.struts.is_empty(), of, &[Q::SpringForce]);
}

/// The labels of bodies on lines and axles, and of particles.
fn on_lines(scene: &Scene, all: &mut Gathered) {
    use Quantity as Q;
    let moves = !scene.is_still();
    let rates = moves || scene.tells_rates();
    for (b, body) in scene.bodies.iter().enumerate() {
        let of = Owner::Body(b);
        if !body.particles.is_empty() {
            all.add(true, of, &[Q::XG, Q::YG, Q::IG]);
            continue;
        }
        all.add(body.turns, of, &[Q::Omega, Q::AngularMomentum]);
        all.add(body.turns && moves, of, &[Q::Phi]);
        all.add(body.turns && rates, of, &[Q::Alpha]);
        if let Some(line) = body.line {
            all.add(true, of, &[Q::V]);
            all.add(moves, of, &[Q::Displacement, Q::Distance, Q::Rise, Q::Impulse]);
            all.add(rates, of, &[Q::A]);
            all.add(rates && line.surface, of, &[Q::Normal]);
        }
        let axle = rates && scene.axle_pulls(b).is_some();
        all.add(axle, of, &[Q::PinX, Q::PinY, Q::PinForce, Q::PinAngle]);
    }
    let phases = scene.goes_in_phases();
    all.add(moves && !scene.grows_with_place(), Owner::Scene, &[Q::T]);
    all.add(moves && !scene.is_sprung() && !phases, Owner::Scene, &[Q::Work]);
    all.add(scene.coordinates().next().is_some(), Owner::Scene, &[Q::RotationalFraction]);
    couples(scene, moves, all);
    scene.pulls().for_each(|(tie, ..)| all.add(true, Owner::Tie(tie), &[Q::PowerPull]));
    if !rates {
        return;
    }
    let end = scene.ending_coordinate();
    let changes = scene.growths.is_empty() && (scene.is_sprung() || !scene.start.is_empty());
    let turns_back = moves && changes && end.degree == Degree::Along && !phases;
    // On a level that is drawn turned round, right is back.
    let level = scene.bodies[end.body].line.is_some_and(|line| line.slope == Slope::Level);
    let told = !(level && scene.is_turned_round(end.body));
    all.add(moves && told, Owner::Body(end.body), &[Q::Direction]);
    all.add(turns_back, Owner::Body(end.body), &[Q::VMax, Q::DAtVMax, Q::DTurn]);
    for (t, tie) in scene.ties.iter().enumerate() {
        let rubbing = |body: &usize| Owner::Body(*body);
        match tie {
            Tie::Roll { body, mu_s, .. } => {
                all.add(true, rubbing(body), &[Q::Friction, Q::MuRequired]);
                all.add(mu_s.is_some(), rubbing(body), &[Q::Rolls]);
            }
            Tie::Slip { body, .. } => {
                let of = rubbing(body);
                all.add(true, of, &[Q::Friction, Q::MuRequired, Q::FrictionIfRolled, Q::Rolls]);
                all.add(moves, of, &[Q::SlipDistance]);
                all.add(moves && phases, of, &[Q::SlipSpeed, Q::ARolling]);
                all.add(moves, Owner::Scene, &[Q::Heat]);
            }
            Tie::Slide { body, .. } => {
                all.add(true, rubbing(body), &[Q::Friction]);
                all.add(moves, Owner::Scene, &[Q::Heat]);
                all.add(moves && scene.carried.is_some(), rubbing(body), &[Q::SlipDistance]);
            }
            Tie::Cord(c) => {
                let (of, free) = (Owner::Tie(t), Owner::Body(end.body));
                match c.to {
                    Far::Pull(_) => {
                        all.add(moves && tie.tilted().is_none(), of, &[Q::CordTravel]);
                        all.add(moves, of, &[Q::WorkPull]);
                    }
                    Far::Spring { .. } => {
                        all.add(true, of, &[Q::Tension]);
                        all.add(moves, of, &[Q::CordTravel]);
                        all.add(moves, of, &[Q::XEq]);
                        all.add(moves && scene.oscillates(), free, &[Q::PeriodSmall, Q::OmegaSmall]);
                    }
                    Far::Body(_) | Far::Fixed => all.add(true, of, &[c.force()]),
                }
            }
        }
    }
    let pulled = |c: &Cord| matches!(c.to, Far::Pull(_)) && matches!(c.from.attach, Attach::Wound(..));
    if let [body] = scene.bodies.as_slice() {
        let tied = |what: &dyn Fn(&Tie) -> bool| scene.ties.iter().any(what);
        let bounds = matches!(body.inertia, Some(RotaryInertia::Gyration(_)))
            && scene.couples.is_empty()
            && scene.growths.is_empty()
            && tied(&|t| matches!(t, Tie::Roll { .. }))
            && !tied(&|t| t.tilted().is_some())
            && tied(&|t| matches!(t, Tie::Cord(c) if pulled(c)));
        all.add(bounds, Owner::Body(0), &[Q::KBound]);
    }
}

/// The labels of joined bodies in the plane.
fn joined(scene: &Scene, all: &mut Gathered) {
    use Quantity as Q;
    // Just after a blow only velocities are told, at rest only forces.
    let (moves, still) = (!scene.is_still(), matches!(scene.end, End::Equilibrium));
    let forces = moves || !scene.is_struck();
    for (b, body) in scene.bodies.iter().enumerate() {
        let of = Owner::Body(b);
        if still {
            all.add(true, of, &[Q::Rise]);
            all.add(scene.lead() == Some(b), of, &[Q::Phi, Q::OmegaSmall, Q::PeriodSmall]);
            continue;
        }
        all.add(true, of, &[Q::V, Q::VX, Q::VY]);
        all.add(body.turns, of, &[Q::Omega]);
        all.add(body.planar.as_ref().is_some_and(|p| p.driven.is_some()), of, &[Q::Drive]);
        all.add(forces, of, &[Q::AX, Q::AY]);
        all.add(forces && body.turns, of, &[Q::Alpha]);
        all.add(moves, of, &[Q::Rise]);
        for point in 0..body.planar.as_ref().map_or(0, |p| p.points.len()) {
            all.add(true, Owner::Spot(Spot { body: b, point }), &[Q::V]);
        }
    }
    all.add(moves, Owner::Scene, &[Q::T]);
    all.add(forces && scene.only_pin().is_some(), Owner::Scene, &[Q::IO, Q::IG, Q::XG, Q::YG]);
    if let Some(lead) = scene.lead() {
        all.add(moves, Owner::Body(lead), &[Q::Phi]);
        all.add(scene.ends_at_an_angle().is_some(), Owner::Body(lead), &[Q::Angle]);
    }
    for (b, body) in scene.bodies.iter().enumerate() {
        all.add(body.turns && !still, Owner::Body(b), &[Q::AngularMomentum]);
    }
    if forces && !still {
        couples(scene, false, all);
    }
    for (j, joint) in scene.joints.iter().enumerate() {
        let of = Owner::Joint(j);
        all.add(scene.is_struck(), of, joint.kind.impulses());
        all.add(forces, of, joint.kind.forces());
        let holds = matches!(joint.kind, JointKind::Pin { .. } | JointKind::Hinge { .. });
        all.add(forces && holds, of, &[Q::PinForce, Q::PinAngle]);
        let rubs = joint.kind.mu_k().is_some();
        all.add(forces && rubs, of, &[Q::Friction]);
    }
    for (s, strut) in scene.struts.iter().enumerate() {
        all.add(forces, Owner::Strut(s), if strut.twists() { &[Q::Moment] } else { &[Q::SpringForce] });
    }
}
