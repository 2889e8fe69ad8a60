//! Sense of ids, ranges and names: is every datum used and admissible, does a quantity exist, are templates' names known.
use crate::bank::need::Need;
use crate::bank::node::{Faults, Node, Value, shorten};
use crate::bank::{Datum, Draw, TEMPLATE_NAMES, Variables, asked};
use crate::finding::{Finding, told};
use crate::scene::{
    Attach, Coordinate, Cord, CordEnd, Degree, End, Far, Grows, JointKind, Label, Made, Num, Owner, Quantity,
    RotaryInertia, Scene, Spot, Tie,
};
use crate::units::spell;

/// A datum in one case: used where it is drawn, drawn where it is used, and admissible over its whole range.
pub fn datum(
    datum: &Datum,
    node: &Node,
    draw: Option<&Draw>,
    uses: &[Need],
    case: &str,
    case_node: &Node,
    faults: &Faults,
) {
    let symbol = &datum.symbol;
    let in_case = if case.is_empty() { String::new() } else { told!(" of the case `{case}`") };
    match (draw, uses.first()) {
        (Some(_), None) => faults.hint(
            node,
            told!("`{symbol}` is drawn, but the scene{in_case} does not use it"),
            "remove it, or use it in the scene",
        ),
        (None, Some(need)) => faults.hint(
            if case.is_empty() { node } else { case_node },
            told!("`{symbol}` is used as {}, but it is not drawn", need.words),
            told!(
                "for example `draw: 20 to 40 step 1`{}",
                if case.is_empty() { "" } else { ", here or in the data" }
            ),
        ),
        (Some(draw), Some(_)) => {
            let (low, high) = draw.range();
            for need in uses {
                for end in [low, high] {
                    let value = if need.in_degrees() {
                        datum.unit.decimal_to_scene(end.value, end.decimals)
                    } else {
                        datum.unit.decimal_to_si(end.value, end.decimals)
                    };
                    if let Err(message) = need.admits(value) {
                        faults.hint(
                            if case.is_empty() { node } else { case_node },
                            told!(
                                "`{symbol}` could be drawn as {}: {message}",
                                datum.unit.text_with(&end.text())
                            ),
                            "change the range",
                        );
                    }
                }
            }
        }
        (None, None) => {}
    }
}

/// A body that slips has inertia: its radius of gyration cannot be drawn as 0.
pub fn inertia_where_slipping(scene: &Scene, draws: &[(String, Option<Draw>)], node: &Node, faults: &Faults) {
    for tie in &scene.ties {
        let Tie::Slip { body, .. } = tie else { continue };
        let num = match scene.bodies[*body].inertia {
            Some(RotaryInertia::Gyration(n) | RotaryInertia::Moment(n)) => n,
            _ => continue,
        };
        let (zero, what) = match num {
            Num::Fixed(x) => (x <= 0.0, "its inertia".to_owned()),
            Num::Datum(i) => match draws.get(i) {
                Some((symbol, Some(draw))) => (draw.range().0.value <= 0, told!("`{symbol}`")),
                _ => (false, String::new()),
            },
            Num::Derived(_) => (false, String::new()),
        };
        if zero {
            faults.at(node, told!("`{}` slips, so {what} is above 0", scene.bodies[*body].name));
        }
    }
}

/// What no data can make solvable: too few or too many freedoms, combinations that the assembly does not have.
pub fn structure(scene: &Scene, node: &Node, faults: &Faults) {
    let even = |t: &Tie| match t {
        Tie::Roll { .. } => true,
        Tie::Cord(c) => !matches!(c.to, Far::Spring { .. }),
        Tie::Slip { .. } | Tie::Slide { .. } => false,
    };
    let bodies = scene.bodies.iter().all(|b| b.pin.is_none() && b.particles.is_empty());
    let simple = bodies && scene.ties.iter().all(even) && scene.freedoms() <= 1;
    // What moves in the plane has a message of its own, with its joints.
    let planar = scene.bodies.iter().any(|b| b.planar.is_some());
    if let (Some(law), false) = (scene.law(), planar) {
        let (ends, with, end) = match law.with {
            Grows::Time => (matches!(scene.end, End::Time(..)), "time", "`end: {time: {of: wheel, is: t1}}`"),
            Grows::Place => (
                matches!(scene.end, End::Travel(..) | End::Position(..)),
                "place",
                "an end after a way or a turn, such as `end: {travel: {of: wheel, by: d}}`",
            ),
        };
        if !(simple && ends) {
            faults.hint(
                node,
                told!(
                    "a force grows with {with}, and the scene is not one whose acceleration then grows alike"
                ),
                told!("one freedom, contacts that roll, no spring, no pin, and {end}"),
            );
            return;
        }
        if scene.growths.iter().any(|g| g.law != law) {
            let hint = "write the same `with:` for all of them";
            faults.hint(node, "two forces grow in different ways; all that grow do so alike", hint);
            return;
        }
    }
    carrier(scene, node, faults);
    loads(scene, node, faults);
    if let Some((b, _)) = scene.pinned() {
        let name = &scene.bodies[b].name;
        if scene.bodies.len() > 1 {
            faults.hint(
                node,
                told!("`{name}` is pinned, and there is another body"),
                "a pinned body is alone in its scene",
            );
        }
        if !scene.ties.is_empty() {
            faults.hint(
                node,
                told!("`{name}` is pinned, and there are ties"),
                "write a spring under `forces`",
            );
        }
        return;
    }
    if scene.bodies.iter().any(|b| b.planar.is_some()) {
        mechanism(scene, node, faults);
        return;
    }
    if matches!(scene.end, End::AtOnce) {
        return;
    }
    if scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        faults.hint(node, "only an instant is asked of a body of particles", "write `end: at once`");
        return;
    }
    let cord_to = |what: fn(&Far) -> bool| {
        scene.ties.iter().filter(|t| matches!(t, Tie::Cord(c) if what(&c.to))).count()
    };
    let springs = cord_to(|far| matches!(far, Far::Spring { .. }));
    let slips = scene.ties.iter().find_map(|t| match t {
        Tie::Slip { body, .. } => Some(&scene.bodies[*body].name),
        _ => None,
    });
    let freedoms = scene.freedoms();
    if freedoms == 0 {
        faults.hint(node, "the ties leave nothing free to move", "take one of the ties away");
    }
    if springs > 1 {
        faults.at(node, "a scene has at most one spring");
    }
    if let (Some(name), true) = (slips, springs > 0) {
        faults.hint(
            node,
            told!("`{name}` slips, and there is a spring; that is not solved"),
            "let the wheel roll, or take the spring away",
        );
    } else if freedoms > 1 && springs > 0 {
        faults.hint(
            node,
            told!("a spring holds a scene with {freedoms} freedoms; one is solved"),
            "let the wheel roll",
        );
    }
    thrown(scene, node, faults);
    if (freedoms > 1 || slips.is_some()) && !scene.start.is_empty() && scene.thrown().is_none() {
        match slips {
            Some(name) => faults.hint(part(node, "start"),
                told!("`{name}` slips, so its speed and its spin at the start are both given, or it starts from rest"),
                told!("write `start: {{{name}: {{speed: v0, spin: w0}}}}` (one of them may be 0), or `start: at rest`"),
            ),
            None => faults.hint(part(node, "start"),
                told!("a scene with {freedoms} freedoms starts from rest"),
                "write `start: at rest`",
            ),
        }
    }
    if freedoms == 1 && scene.start.len() > 1 && !matches!(scene.end, End::Rolling(_)) {
        faults.hint(
            part(node, "start"),
            "the ties leave one freedom, so one speed at the start gives all others",
            "give one speed or spin",
        );
    }
}

/// Bodies that rest on wheels: how the wheels share the load is not known, so nothing is asked of it.
fn loads(scene: &Scene, node: &Node, faults: &Faults) {
    let resting = scene.ties.iter().filter_map(|t| match t {
        Tie::Cord(c) if c.made == Made::Rests => Some((c.from.body, &c.to)),
        _ => None,
    });
    for (load, on) in resting {
        let Far::Body(CordEnd { body: wheel, .. }) = *on else { continue };
        for tie in &scene.ties {
            let (name, hint) = match tie {
                Tie::Roll { body, .. } | Tie::Slip { body, .. } | Tie::Slide { body, .. }
                    if *body == load =>
                {
                    (&scene.bodies[load].name, "it rests on wheels alone: take its tie with the surface away")
                }
                Tie::Roll { body, mu_s: Some(_), .. } | Tie::Slip { body, .. } if *body == wheel => {
                    let hint = "how the wheels share the load is not known: write `rolls:` without `mu_s`";
                    (&scene.bodies[wheel].name, hint)
                }
                _ => continue,
            };
            let message = told!(
                "friction limits are not told of `{name}`, for `{}` rests on wheels",
                scene.bodies[load].name
            );
            faults.hint(part(node, "ties"), message, hint);
        }
    }
}

/// A scene that is carried: what its words mean there.
fn carrier(scene: &Scene, node: &Node, faults: &Faults) {
    let Some(carrier) = &scene.carried else { return };
    let at = part(node, "carried");
    let name = scene.bodies.first().map_or("crate", |b| b.name.as_str());
    let fast = carrier.speed_m_s != Num::Fixed(0.0);
    if scene.pinned().is_some() {
        let hint = "write `moves: in the plane` and a joint `O: {pins: rod.A}`";
        faults.hint(at, told!("`{name}` is pinned, and the scene is carried"), hint);
    } else if scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        faults.hint(at, "a body of particles is not carried", "remove `carried`");
    } else if fast && scene.lead().is_some() {
        let hint = "remove `speed`: bodies in the plane start as they are seen from what carries them";
        faults.hint(at, "of what carries joined bodies the acceleration alone counts", hint);
    } else if fast && scene.start.is_empty() && scene.bodies.iter().any(|b| b.line.is_some_and(|l| l.surface))
    {
        faults.hint(
            part(node, "start"),
            "at rest on the ground, or on what carries the scene?",
            told!("write `start: {{{name}: {{speed: 0 m/s}}}}` for what is set down, as seen from the ground, or give it the speed of what carries it"),
        );
    }
    if matches!(scene.end, End::Speed(..)) && scene.lead().is_none() {
        let hint = "write `stops slipping`, `time`, or `travel`, which counts on what carries the scene";
        faults.hint(part(node, "end"), "a carried scene does not end at a speed", hint);
    }
}

/// Joined bodies: one leads, and none moves otherwise than in the plane.
fn mechanism(scene: &Scene, node: &Node, faults: &Faults) {
    if let Some(body) = scene.bodies.iter().find(|b| b.planar.is_none()) {
        faults.hint(
            node,
            told!("`{}` does not move in the plane, and another body does", body.name),
            "write `moves: in the plane` for all of them, with joints",
        );
    }
    if !scene.ties.is_empty() {
        faults.hint(part(node, "ties"), "what moves in the plane is held by joints", "write `joints`");
    }
    let level = |b: &crate::scene::Body| b.planar.as_ref().is_some_and(|p| p.level);
    if scene.bodies.iter().any(level) && !scene.bodies.iter().all(level) {
        let hint = "write the same `moves:` for all of them";
        faults.hint(
            part(node, "bodies"),
            "some bodies move in a horizontal plane, others in the vertical one",
            hint,
        );
    }
    if !scene.growths.is_empty() {
        let hint = "remove `growing by`, or let the bodies move on lines";
        faults.hint(part(node, "forces"), "what moves in the plane has no forces that grow", hint);
    }
    if scene.start_speeds().count() > 1 {
        let hint = "give one speed or spin: the joints give the others";
        faults.hint(part(node, "start"), "more than one speed is given at the start of joined bodies", hint);
    }
    let rough = |j: &&crate::scene::Joint| matches!(j.kind, JointKind::Guide { mu_k: Some(_), .. });
    if let (true, Some(joint)) = (scene.is_struck(), scene.joints.iter().find(rough)) {
        let message = told!(
            "`{}` is rough, and an impulse acts: what friction does in a blow is not known",
            joint.name
        );
        faults.hint(part(node, "joints"), message, "remove `mu_k`");
    }
    let driven = |b: &usize| scene.planar(*b).is_some_and(|p| p.driven.is_some());
    if let Some(b) = (0..scene.bodies.len()).find(driven)
        && (scene.end != End::AtOnce || scene.is_struck() || scene.lead() != Some(b))
    {
        let message = told!("`{}` is driven, and its motion goes on", scene.bodies[b].name);
        let hint = "only an instant is asked of what is driven: give its angle and spin then, and write `end: at once`";
        faults.hint(part(node, "start"), message, hint);
    }
    if scene.end == End::Equilibrium && scene.start_speeds().next().is_some() {
        let hint = "give the angle alone: from it the equilibrium is looked for, and nothing moves there";
        faults.hint(part(node, "start"), "at rest in equilibrium nothing has a speed or a spin", hint);
    }
    if scene.end == End::Equilibrium && scene.is_struck() {
        faults.hint(
            part(node, "forces"),
            "at rest in equilibrium nothing is struck",
            "take the impulse away",
        );
    }
    if let (End::Equilibrium, Some(joint)) = (scene.end, scene.joints.iter().find(rough)) {
        let message = told!("`{}` is rough, so that there is no one equilibrium", joint.name);
        faults.hint(part(node, "joints"), message, "remove `mu_k`");
    }
    if scene.lead().is_none() {
        let hint = match scene.bodies.iter().find(|b| b.turns) {
            Some(body) => told!("write `start: {{{}: {{angle: phi0}}}}`", body.name),
            None => told!(
                "a body that turns has it; what only slides along a line moves `vertically` or `along` a surface"
            ),
        };
        faults.hint(part(node, "start"), "the angle at which the motion starts is missing", hint);
    }
}

/// The start of a scene of which only an instant is asked: with the ties it gives each velocity, and none twice. What depends
/// on the numbers is left to the solvers: constants that agree with the ties may be given besides.
pub fn instant(scene: &Scene, draws: &[(String, Option<Draw>)], node: &Node, faults: &Faults) {
    let moving = !matches!(scene.end, End::AtOnce) || scene.pinned().is_some() || scene.lead().is_some();
    if moving || scene.start_speeds().next().is_none() {
        return;
    }
    let coordinates: Vec<Coordinate> = scene.coordinates().collect();
    let place =
        |body: usize, degree: Degree| coordinates.iter().position(|c| *c == Coordinate { body, degree });
    let end = |e: &CordEnd| {
        let turn = if matches!(e.attach, Attach::Wound(..)) { place(e.body, Degree::Turn) } else { None };
        place(e.body, Degree::Along).into_iter().chain(turn)
    };
    // The coordinates of which each condition speaks, and the numbers in it: the ties, then the start.
    let (mut rows, mut numbers): (Vec<Vec<usize>>, Vec<Num>) = (Vec::new(), Vec::new());
    for tie in &scene.ties {
        match tie {
            Tie::Roll { body, radius_m, .. } => {
                let both = [place(*body, Degree::Along), place(*body, Degree::Turn)];
                rows.push(both.into_iter().flatten().collect());
                numbers.push(*radius_m);
            }
            Tie::Cord(Cord { from, to, .. }) => {
                let other = match to {
                    Far::Body(other) => Some(other),
                    Far::Fixed => None,
                    Far::Pull(_) | Far::Spring { .. } => continue,
                };
                rows.push(end(from).chain(other.into_iter().flat_map(end)).collect());
                for e in [Some(from), other].into_iter().flatten() {
                    if let Attach::Wound(r, _) = e.attach {
                        numbers.push(r);
                    }
                }
            }
            Tie::Slip { .. } | Tie::Slide { .. } => {}
        }
    }
    let ties = rows.len();
    for (c, number) in scene.start_speeds() {
        rows.push(place(c.body, c.degree).into_iter().collect());
        numbers.push(number);
    }
    // A maximum matching of conditions to coordinates (Kuhn): a condition that finds no coordinate of its own says nothing
    // new, a coordinate without a condition is left open.
    fn take(row: usize, rows: &[Vec<usize>], taken: &mut [Option<usize>], tried: &mut [bool]) -> bool {
        for j in rows[row].iter().copied() {
            if std::mem::replace(&mut tried[j], true) {
                continue;
            }
            if taken[j].is_none_or(|other| take(other, rows, taken, tried)) {
                taken[j] = Some(row);
                return true;
            }
        }
        false
    }
    let name = |c: &Coordinate| {
        let what = if c.degree == Degree::Along { "speed" } else { "spin" };
        told!("the {what} of `{}`", scene.bodies[c.body].name)
    };
    let mut taken = vec![None; coordinates.len()];
    let start = part(node, "start");
    let drawn = |number: &Num| {
        let mut draws = scene.data_of(*number).filter_map(|i| draws.get(i)?.1.as_ref());
        draws.any(|draw| draw.range().0.value != draw.range().1.value)
    };
    let varies = numbers.iter().any(drawn);
    for row in 0..rows.len() {
        let found = take(row, &rows, &mut taken, &mut vec![false; coordinates.len()]);
        let given = row.checked_sub(ties).and_then(|i| scene.start_speeds().nth(i));
        if let (false, true, Some((c, _))) = (found, varies, given) {
            faults.hint(
                start,
                told!("the ties and the rest of the start already give {}", name(&c)),
                "take it away: one speed or spin for each freedom that the ties leave",
            );
        }
    }
    for (c, _) in coordinates.iter().zip(&taken).filter(|(_, row)| row.is_none()) {
        let (body, field) =
            (&scene.bodies[c.body].name, if c.degree == Degree::Along { "speed: v" } else { "spin: w" });
        faults.hint(
            start,
            told!("the start and the ties leave {} open", name(c)),
            told!("write `start: {{{body}: {{{field}}}}}` besides, or a tie that gives it"),
        );
    }
}

/// The field of this name, or the whole where it is not written.
fn part<'n>(node: &'n Node, name: &str) -> &'n Node {
    node.field(name).unwrap_or(node)
}

/// A body thrown with slip: alone on its surface, until it rolls or for a time.
fn thrown(scene: &Scene, node: &Node, faults: &Faults) {
    let Some(thrown) = scene.thrown() else {
        // A body that slips and has one speed only is told so elsewhere.
        let half = scene.ties.iter().any(|t| matches!(t, Tie::Slip { .. })) && !scene.start.is_empty();
        if let End::Rolling(c) = scene.end
            && !half
        {
            let name = scene.bodies.get(c.body).map_or("ball", |b| b.name.as_str());
            faults.hint(
                part(node, "end"),
                told!("`rolling` ends the slip of a body that is thrown with one; `{name}` is not"),
                told!("write `slips:` for `{name}` and `start: {{{name}: {{speed: v0, spin: w0}}}}`"),
            );
        }
        return;
    };
    let name = scene.bodies.get(thrown.body).map_or("ball", |b| b.name.as_str());
    if scene.bodies.len() > 1 || scene.ties.len() > 1 {
        faults.hint(
            part(node, "start"),
            told!("`{name}` is thrown with slip; that is solved for one body without cords"),
            "take the other bodies and ties away, or write `start: at rest`",
        );
    }
    if !matches!(scene.end, End::Rolling(_) | End::Time(..)) {
        faults.hint(
            part(node, "end"),
            told!("`{name}` is thrown with slip; that ends where it begins to roll, or after a time"),
            told!("write `end: {{rolling: {name}}}` or `end: {{time: {{of: {name}, is: t1}}}}`"),
        );
    }
    if scene.heading.is_some() {
        faults.hint(
            part(node, "end"),
            told!("`{name}` is thrown; its speed says which way it goes"),
            "take `heading` away",
        );
    }
}

/// The label of a name such as `omega`, `block.v` or `left.tension`, if the scene has it; else what to say.
pub fn label(scene: &Scene, name: &str) -> Result<Label, (String, Option<String>)> {
    if let Some(label) = asked::label(scene, name) {
        return Ok(label);
    }
    let (owner, bare) = match name.rsplit_once('.') {
        Some((owner, quantity)) => (Some(owner), quantity),
        None => (None, name),
    };
    let Some(quantity) = Quantity::from_name(bare) else {
        let hint = spell::did_you_mean(bare, Quantity::ALL.iter().map(|q| q.name())).unwrap_or_else(|| {
            let names = || labels(scene).into_iter().map(|l| scene.name_of(l));
            told!("quantities of this scene: {}", names().collect::<Vec<_>>().join(", "))
        });
        return Err((told!("`{}` is no quantity", shorten(name)), Some(hint)));
    };
    let found: Vec<Label> = labels(scene).into_iter().filter(|l| l.quantity == quantity).collect();
    let shown = shorten(name);
    if found.is_empty() {
        return Err((
            told!("`{shown}` does not exist in this scene"),
            Some(told!("`{}` is: {}; {}", bare, quantity.meaning(), reason(scene, quantity))),
        ));
    }
    let names = || found.iter().map(|l| told!("`{}`", scene.name_of(*l))).collect::<Vec<_>>().join(", ");
    match owner {
        None => match found
            .iter()
            .find(|l| scene.name_of(**l) == bare)
            .or(found.first().filter(|_| found.len() == 1))
        {
            Some(label) => Ok(*label),
            None => Err((told!("`{shown}`: of what?"), Some(told!("this scene has {}", names())))),
        },
        Some(owner) => {
            let belongs = |l: &&Label| match l.of {
                Owner::Scene | Owner::Asked(_) => false,
                Owner::Body(b) => scene.bodies[b].name == owner,
                Owner::Tie(t) => matches!(&scene.ties[t], Tie::Cord(c) if c.name == owner),
                Owner::Joint(j) => scene.joints[j].name == owner,
                Owner::Strut(s) => scene.struts[s].name == owner,
                Owner::Spot(spot) => scene.point_name(spot).is_some_and(|(b, p)| owner == format!("{b}.{p}")),
            };
            match found.iter().find(belongs) {
                Some(label) => Ok(*label),
                None => Err((
                    told!("`{shown}` does not exist in this scene"),
                    Some(told!("this scene has {}", names())),
                )),
            }
        }
    }
}

/// Why a scene has not this quantity, for hints.
pub fn reason(scene: &Scene, quantity: Quantity) -> String {
    use Quantity as Q;
    let of_particles = matches!(quantity, Q::XG | Q::YG | Q::IG);
    let of_pins = matches!(
        quantity,
        Q::IO
            | Q::PinRadial
            | Q::PinTangential
            | Q::PinForce
            | Q::PinX
            | Q::PinY
            | Q::PinAngle
            | Q::SpringForce
            | Q::OmegaMax
            | Q::Period
    );
    if scene.carried.is_some() && matches!(quantity, Q::Distance | Q::Rise | Q::WorkPull) {
        return "where a belt, a truck or a lift carries the scene it is not told".to_owned();
    }
    if !scene.is_still() || of_particles || of_pins {
        return why(quantity).to_owned();
    }
    let names = || labels(scene).into_iter().map(|l| scene.name_of(l));
    let (end, what) = match scene.end {
        End::Equilibrium => ("equilibrium", "at rest there"),
        _ => ("at once", "at the start"),
    };
    told!("with `end: {end}` only what holds {what} is asked: {}", names().collect::<Vec<_>>().join(", "))
}

/// What a quantity needs, for hints.
const fn why(quantity: Quantity) -> &'static str {
    use Quantity as Q;
    match quantity {
        Q::Omega | Q::Alpha | Q::Phi | Q::AngularMomentum => "nothing turns here",
        Q::V | Q::A | Q::Displacement | Q::Distance | Q::Rise | Q::Impulse => {
            "nothing moves along a line here"
        }
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
        Q::WorkCouple | Q::PowerCouple => "it needs a couple under `forces`",
        Q::KBound => "it needs one wheel with a radius of gyration that rolls and is pulled",
        Q::XEq => "it needs a spring",
        Q::VMax | Q::DAtVMax | Q::DTurn => {
            "it needs an end of a body on a line, and a spring or a speed at the start"
        }
        Q::XG | Q::YG | Q::IG => "it needs a body of particles",
        Q::IO | Q::PinRadial | Q::PinTangential | Q::PinForce | Q::PinX | Q::PinY | Q::PinAngle => {
            "it needs a pinned body, or one about a fixed axle whose mass and whose cords' directions are told"
        }
        Q::SpringForce => "it needs a spring on a pinned body",
        Q::OmegaMax | Q::Period => "it needs a pinned body that swings under its weight alone",
        Q::PeriodSmall | Q::OmegaSmall => {
            "it needs a pinned body that swings under its weight alone, a spring and no friction of sliding, or, of bodies in the plane, `end: equilibrium`"
        }
        Q::Moment => "it needs a weld or a torsion spring",
        Q::Drive => {
            "it needs a driven body: `start: {crank: {angle: phi, spin: w, alpha: 0 rad/s^2}}` and `end: at once`"
        }
        Q::ImpulseX | Q::ImpulseY => "it needs a pin or a hinge, and an impulse under `forces`",
        Q::Work => "it needs a motion on lines without a spring, and no slip from a speed at the start",
        Q::VX | Q::VY | Q::AX | Q::AY => "it needs a body that moves in the plane",
        Q::T | Q::RotationalFraction | Q::KineticEnergy | Q::Direction => {
            "it needs a motion, the time one without a force that grows with place"
        }
        Q::Value => "it needs a question with `value:`",
    }
}

/// All labels that the solvers can give for this structure.
pub fn labels(scene: &Scene) -> Vec<Label> {
    let mut list = of_kind(scene);
    list.retain(|label| scene.tells(*label));
    list
}

/// The same of a scene that nothing carries.
fn of_kind(scene: &Scene) -> Vec<Label> {
    use Quantity as Q;
    let mut list = Vec::new();
    // Each once: several bodies may rub, and there is one heat.
    let mut add = |of: Owner, quantities: &[Q]| {
        for label in quantities.iter().map(|q| Label { quantity: *q, of }) {
            if !list.contains(&label) {
                list.push(label);
            }
        }
    };
    let moves = !scene.is_still();
    let rates = moves || scene.tells_rates();
    let couples = |add: &mut dyn FnMut(Owner, &[Q])| {
        scene.couples.iter().for_each(|c| add(Owner::Body(c.body), &[Q::WorkCouple, Q::PowerCouple]));
    };
    add(Owner::Scene, if matches!(scene.end, End::Equilibrium) { &[] } else { &[Q::KineticEnergy] });
    if let Some((b, pin)) = scene.pinned() {
        let of = Owner::Body(b);
        add(Owner::Scene, &[Q::RotationalFraction]);
        add(of, &[Q::Omega, Q::V, Q::Alpha, Q::IO, Q::AngularMomentum]);
        add(of, &[Q::PinRadial, Q::PinTangential, Q::PinForce, Q::PinX, Q::PinY, Q::PinAngle]);
        if moves {
            couples(&mut add);
            add(Owner::Scene, &[Q::T]);
            add(of, &[Q::Phi, Q::Rise]);
        }
        if scene.is_pendulum() {
            add(of, &[Q::OmegaMax, Q::Period, Q::PeriodSmall, Q::OmegaSmall]);
        }
        if pin.spring.is_some() {
            add(of, &[Q::SpringForce]);
        }
        return list;
    }
    if scene.lead().is_some() {
        joined(scene, moves, &mut add);
        return list;
    }
    for (b, body) in scene.bodies.iter().enumerate() {
        let of = Owner::Body(b);
        if !body.particles.is_empty() {
            add(of, &[Q::XG, Q::YG, Q::IG]);
            continue;
        }
        if body.turns {
            add(of, &[Q::Omega, Q::AngularMomentum]);
            add(of, if moves { &[Q::Phi] } else { &[] });
            add(of, if rates { &[Q::Alpha] } else { &[] });
        }
        if let Some(line) = body.line {
            add(of, &[Q::V]);
            add(of, if moves { &[Q::Displacement, Q::Distance, Q::Rise, Q::Impulse] } else { &[] });
            add(of, if rates { &[Q::A] } else { &[] });
            add(of, if line.surface && rates { &[Q::Normal] } else { &[] });
        }
        if rates && scene.axle_pulls(b).is_some() {
            add(of, &[Q::PinX, Q::PinY, Q::PinForce, Q::PinAngle]);
        }
    }
    add(Owner::Scene, if moves && !scene.grows_with_place() { &[Q::T] } else { &[] });
    if moves && scene.spring().is_none() && scene.thrown().is_none() {
        add(Owner::Scene, &[Q::Work]);
    }
    if scene.coordinates().next().is_some() {
        add(Owner::Scene, &[Q::RotationalFraction]);
    }
    if !rates {
        return list;
    }
    if moves {
        couples(&mut add);
    }
    let end = scene.ending_coordinate();
    add(Owner::Body(end.body), if moves { &[Q::Direction] } else { &[] });
    let changes = scene.growths.is_empty() && (scene.spring().is_some() || !scene.start.is_empty());
    if moves && changes && end.degree == Degree::Along && scene.thrown().is_none() {
        add(Owner::Body(end.body), &[Q::VMax, Q::DAtVMax, Q::DTurn]);
    }
    for (t, tie) in scene.ties.iter().enumerate() {
        match tie {
            Tie::Roll { body, mu_s, .. } => {
                add(Owner::Body(*body), &[Q::Friction, Q::MuRequired]);
                add(Owner::Body(*body), if mu_s.is_some() { &[Q::Rolls] } else { &[] });
            }
            Tie::Slip { body, .. } => {
                let of = Owner::Body(*body);
                add(of, &[Q::Friction, Q::MuRequired, Q::FrictionIfRolled, Q::Rolls]);
                if !moves {
                    continue;
                }
                add(of, &[Q::SlipDistance]);
                if scene.thrown().is_some_and(|t| t.body == *body) {
                    add(of, &[Q::SlipSpeed, Q::ARolling]);
                }
                add(Owner::Scene, &[Q::Heat]);
            }
            Tie::Slide { body, .. } => {
                add(Owner::Body(*body), &[Q::Friction]);
                add(Owner::Scene, if moves { &[Q::Heat] } else { &[] });
                add(
                    Owner::Body(*body),
                    if moves && scene.carried.is_some() { &[Q::SlipDistance] } else { &[] },
                );
            }
            Tie::Cord(c) => match c.to {
                Far::Pull(_) if !moves => {}
                Far::Pull(_) if tie.tilted().is_some() => add(Owner::Tie(t), &[Q::WorkPull, Q::PowerPull]),
                Far::Pull(_) => add(Owner::Tie(t), &[Q::CordTravel, Q::WorkPull, Q::PowerPull]),
                Far::Spring { .. } => {
                    add(Owner::Tie(t), &[Q::Tension]);
                    if moves {
                        add(Owner::Tie(t), &[Q::CordTravel]);
                        add(Owner::Scene, &[Q::XEq]);
                        let of = Owner::Body(end.body);
                        add(of, if scene.oscillates() { &[Q::PeriodSmall, Q::OmegaSmall] } else { &[] });
                    }
                }
                Far::Body(_) | Far::Fixed => add(Owner::Tie(t), &[c.force()]),
            },
        }
    }
    let pulled = |c: &Cord| matches!(c.to, Far::Pull(_)) && matches!(c.from.attach, Attach::Wound(..));
    if let [body] = scene.bodies.as_slice()
        && matches!(body.inertia, Some(RotaryInertia::Gyration(_)))
        && scene.couples.is_empty()
        && scene.growths.is_empty()
        && scene.ties.iter().any(|t| matches!(t, Tie::Roll { .. }))
        && scene.ties.iter().all(|t| t.tilted().is_none())
        && scene.ties.iter().any(|t| matches!(t, Tie::Cord(c) if pulled(c)))
    {
        add(Owner::Body(0), &[Q::KBound]);
    }
    list
}

/// The labels of joined bodies in the plane.
fn joined(scene: &Scene, moves: bool, add: &mut impl FnMut(Owner, &[Quantity])) {
    use Quantity as Q;
    // Just after a blow only velocities are told, at rest only forces.
    let still = matches!(scene.end, End::Equilibrium);
    let forces = moves || !scene.is_struck();
    for (b, body) in scene.bodies.iter().enumerate() {
        let of = Owner::Body(b);
        if still {
            add(of, &[Q::Rise]);
            add(of, if scene.lead() == Some(b) { &[Q::Phi, Q::OmegaSmall, Q::PeriodSmall] } else { &[] });
            continue;
        }
        add(of, &[Q::V, Q::VX, Q::VY]);
        add(of, if body.turns { &[Q::Omega] } else { &[] });
        add(of, if body.planar.as_ref().is_some_and(|p| p.driven.is_some()) { &[Q::Drive] } else { &[] });
        if forces {
            add(of, &[Q::AX, Q::AY]);
            add(of, if body.turns { &[Q::Alpha] } else { &[] });
        }
        add(of, if moves { &[Q::Rise] } else { &[] });
        let points = body.planar.as_ref().map_or(0, |p| p.points.len());
        for point in 0..points {
            add(Owner::Spot(Spot { body: b, point }), &[Q::V]);
        }
    }
    if let (true, Some(lead)) = (moves, scene.lead()) {
        add(Owner::Scene, &[Q::T]);
        add(Owner::Body(lead), &[Q::Phi]);
    }
    for (j, joint) in scene.joints.iter().enumerate() {
        let of = Owner::Joint(j);
        add(of, if scene.is_struck() { joint.kind.impulses() } else { &[] });
        if !forces {
            continue;
        }
        add(of, joint.kind.forces());
        match joint.kind {
            JointKind::Pin { .. } | JointKind::Hinge { .. } => add(of, &[Q::PinForce, Q::PinAngle]),
            JointKind::Guide { mu_k: Some(_), .. } => add(of, &[Q::Friction]),
            _ => {}
        }
    }
    for s in 0..if forces { scene.struts.len() } else { 0 } {
        add(Owner::Strut(s), if scene.struts[s].twists() { &[Q::Moment] } else { &[Q::SpringForce] });
    }
}

/// Names in the statement and in the questions are symbols of the data or names that every template knows.
pub fn templates(
    statement: Option<&Node>,
    questions: Option<&Node>,
    symbols: &[&str],
    variables: Variables,
    faults: &Faults,
) {
    let mut texts: Vec<&Node> = statement.into_iter().collect();
    if let Some(Node { value: Value::Map(entries), .. }) = questions {
        for (_, question) in entries {
            if let Value::Map(fields) = &question.value {
                texts.extend(fields.iter().filter(|(k, _)| k.text() == Some("ask")).map(|(_, v)| v));
            }
        }
    }
    for node in texts {
        template(node, statement.is_some_and(|s| std::ptr::eq(s, node)), symbols, variables, faults);
    }
}

/// Names in one text: symbols of the data or names that every template knows; a statement gives every datum.
pub fn template(node: &Node, is_statement: bool, symbols: &[&str], variables: Variables, faults: &Faults) {
    let Some(text) = node.text() else { return };
    match variables(text) {
        Err(found) => {
            for f in found {
                told(node, &f, faults);
            }
        }
        Ok(names) => {
            let known = |name: &str| symbols.contains(&name) || TEMPLATE_NAMES.contains(&name);
            let unknown: Vec<&str> = names.iter().map(String::as_str).filter(|n| !known(n)).collect();
            for name in &unknown {
                let known = || symbols.iter().copied().chain(TEMPLATE_NAMES.iter().copied());
                let hint = spell::hint(name, "known names", known());
                faults.hint(node, told!("`{{{{ {} }}}}` is not known", shorten(name)), hint);
            }
            // A statement that lists values or particles may give any of them.
            let lists = names.iter().any(|n| matches!(n.as_str(), "value" | "particles"));
            if is_statement && !lists {
                // A misspelt name is a finding already.
                let meant: Vec<&str> = unknown
                    .iter()
                    .filter_map(|name| spell::closest(name, symbols.iter().chain(TEMPLATE_NAMES).copied()))
                    .collect();
                let given = |s: &str| s == "g" || meant.contains(&s) || names.iter().any(|n| n == s);
                for symbol in symbols.iter().filter(|s| !given(s)) {
                    faults.hint(
                        node,
                        told!("the statement never gives `{symbol}`"),
                        told!("write `{{{{ {symbol} }}}}` where it belongs"),
                    );
                }
            }
        }
    }
}

fn told(node: &Node, finding: &Finding, faults: &Faults) {
    let place = finding
        .at
        .map_or_else(String::new, |(line, column)| told!(" (line {line}, column {column} of the text)"));
    faults.maybe(node, told!("{}{place}", finding.message), finding.hint.clone());
}
