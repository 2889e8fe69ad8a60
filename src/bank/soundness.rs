//! Sense of what was read: is every datum used and admissible, can the scene be solved at all, are templates' names known.
use crate::bank::decimal::Decimal;
use crate::bank::need::Need;
use crate::bank::node::{Faults, Node, Value, shorten};
use crate::bank::{Datum, Draw, TEMPLATE_NAMES, Variables};
use crate::finding::Finding;
use crate::scene::{
    Attach, Body, Coordinate, Cord, CordEnd, Degree, End, Far, Grows, Joint, JointKind, Made, Num, Place,
    RotaryInertia, Scene, Shape, Slope, Spot, Strut, StrutEnd, Surface, Tie,
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
    let in_case = if case.is_empty() { String::new() } else { format!(" of the case `{case}`") };
    match (draw, uses.first()) {
        (Some(_), None) => faults.hint(
            node,
            format!("`{symbol}` is drawn, but the scene{in_case} does not use it"),
            "remove it, or use it in the scene",
        ),
        (None, Some(need)) => faults.hint(
            if case.is_empty() { node } else { case_node },
            format!("`{symbol}` is used as {}, but it is not drawn", need.words),
            format!(
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
                            format!(
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
                Some((symbol, Some(draw))) => (draw.range().0.value <= 0, format!("`{symbol}`")),
                _ => (false, String::new()),
            },
            Num::Derived(_) => (false, String::new()),
        };
        if zero {
            faults.at(node, format!("`{}` slips, so {what} is above 0", scene.bodies[*body].name));
        }
    }
}

/// What no data can make solvable: too few or too many freedoms, combinations that the assembly does not have.
pub fn structure(scene: &Scene, node: &Node, faults: &Faults) {
    // What moves in the plane has a message of its own, with its joints.
    let planar = scene.bodies.iter().any(|b| b.planar.is_some());
    if (!planar || scene.pinned().is_some()) && !grows_alike(scene, node, faults) {
        return;
    }
    carrier(scene, node, faults);
    loads(scene, node, faults);
    thrown(scene, node, faults);
    let pinned = scene.bodies.iter().find(|b| b.is_pinned()).filter(|_| !scene.ties.is_empty());
    if let Some(pinned) = pinned {
        let (name, hint) = (Some(pinned.name.as_str()), "write a spring under `forces`");
        tell(&[(name, "", "`{}` is pinned, and there are ties", hint)], node, faults);
    } else if planar {
        mechanism(scene, node, faults);
    } else if !matches!(scene.end, End::AtOnce) {
        on_lines(scene, node, faults);
    }
}

/// Is a scene in which forces grow one whose acceleration grows alike?
fn grows_alike(scene: &Scene, node: &Node, faults: &Faults) -> bool {
    let Some(law) = scene.law() else { return true };
    let even = |t: &Tie| match t {
        Tie::Roll { .. } => true,
        Tie::Cord(c) => !matches!(c.to, Far::Spring { .. }),
        Tie::Slip { .. } | Tie::Slide { .. } => false,
    };
    let bodies = scene.bodies.iter().all(|b| b.planar.is_none() && b.particles.is_empty());
    let simple = bodies && scene.ties.iter().all(even) && scene.freedoms() <= 1;
    let (ends, with, end) = match law.with {
        Grows::Time => (matches!(scene.end, End::Time(..)), "time", "`end: {time: {of: wheel, is: t1}}`"),
        Grows::Place => (
            matches!(scene.end, End::Travel(..) | End::Position(..)),
            "place",
            "an end after a way or a turn, such as `end: {travel: {of: wheel, by: d}}`",
        ),
    };
    let mixed = scene.growths.iter().any(|g| g.law != law);
    if !(simple && ends) {
        let message = format!(
            "a force grows with {with}, and the scene is not one whose acceleration then grows alike"
        );
        faults.hint(
            node,
            message,
            format!("one freedom, contacts that roll or are smooth, no spring, no pin, and {end}"),
        );
    } else if mixed {
        let hint = "write the same `with:` for all of them";
        faults.hint(node, "two forces grow in different ways; all that grow do so alike", hint);
    }
    simple && ends && !mixed
}

/// Bodies on lines and axles: one freedom, or more from rest.
fn on_lines(scene: &Scene, node: &Node, faults: &Faults) {
    if scene.bodies.iter().any(|b| !b.particles.is_empty()) {
        faults.hint(node, "only an instant is asked of a body of particles", "write `end: at once`");
        return;
    }
    let slips = scene.ties.iter().find_map(|t| match t {
        Tie::Slip { body, .. } => Some(scene.bodies[*body].name.as_str()),
        _ => None,
    });
    let freedoms = scene.freedoms();
    let count = freedoms.to_string();
    let several = Some(count.as_str()).filter(|_| freedoms > 1 && slips.is_none());
    let held = scene.is_sprung();
    let twice = freedoms == 1 && scene.start.len() > 1 && !matches!(scene.end, End::Rolling(_));
    #[rustfmt::skip] // a table
    let rules: [SceneRule; 4] = [
        (is(freedoms == 0), "", "the ties leave nothing free to move", "take one of the ties away, or write `slips:` for a wheel that they keep from rolling"),
        (slips.filter(|_| held), "", "`{}` slips, and there is a spring; that is solved at an instant alone",
            "let the wheel roll, take the spring away, or write `end: at once`"),
        (several.filter(|_| held), "", "a spring holds a scene with {} freedoms; one is solved on the way",
            "let the wheel roll, or write `end: at once`"),
        (is(twice), "start", "the ties leave one freedom, so one speed at the start gives all others",
            "give one speed or spin"),
    ];
    tell(&rules, node, faults);
    let told_twice = slips.filter(|_| scene.goes_in_phases() && scene.heading.is_some());
    let end = part(node, "end");
    let by_height = ["rise", "descent"].iter().any(|word| end.field(word).is_some());
    let hint = if by_height { "write `travel`, along its line" } else { "take `heading` away" };
    tell(&[(told_twice, "end", "`{}` is thrown; how it starts says which way it goes", hint)], node, faults);
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
                _ if tie.touching() == Some(load) => {
                    (&scene.bodies[load].name, "it rests on wheels alone: take its tie with the surface away")
                }
                Tie::Roll { body, mu_s: Some(_), .. } | Tie::Slip { body, .. } if *body == wheel => {
                    let hint = "how the wheels share the load is not known: write `rolls:` without `mu_s`";
                    (&scene.bodies[wheel].name, hint)
                }
                _ => continue,
            };
            let message = format!(
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
    let name = scene.bodies.first().map_or("crate", |b| b.name.as_str());
    let fast = carrier.speed_m_s != Num::Fixed(0.0);
    let pinned = scene.bodies.iter().any(Body::is_pinned);
    let joined = scene.lead().is_some() && !pinned;
    let particles = scene.bodies.iter().any(|b| !b.particles.is_empty());
    let on_surface = scene.bodies.iter().any(|b| b.line.is_some_and(|l| l.surface));
    let unclear = fast && scene.start.is_empty() && on_surface;
    let hanging = |b: &&Body| b.line.is_some_and(|l| l.slope == Slope::Vertical && !l.surface);
    let hangs = scene.bodies.iter().find(hanging).map(|b| b.name.as_str());
    let aside = carrier.slope != Slope::Vertical && carrier.acceleration_m_s2 != Num::Fixed(0.0);
    #[rustfmt::skip] // a table
    let rules: [SceneRule; 8] = [
        (is(carrier.slope != Slope::Vertical && scene.is_any_turned_round()), "ties",
            "a cord leaves both its bodies to the same side, so one of the two surfaces is drawn turned round, and is carried the other way",
            "let it leave one body to the right and the other to the left, such as `leaves: forward` on the slope and `leaves: back` on the table; the two slopes of a roof are not carried sideways"),
        (hangs.filter(|_| aside), "carried", "`{}` moves vertically, and nothing gives it an acceleration sideways",
            "let it move along a surface of `slope: 90 deg`, which guides it, or write `moves: in the plane` for what swings back"),
        (is(scene.lies_level() && carrier.slope == Slope::Vertical), "carried", "a lift moves across a horizontal plane, not in it",
            "leave `carried` out: nothing in that plane is changed by it"),
        (Some(name).filter(|_| pinned), "carried", "`{}` is pinned, and the scene is carried",
            "write `moves: in the plane` and a joint `O: {pins: rod.A}`"),
        (is(particles && !pinned), "carried", "a body of particles is not carried", "remove `carried`"),
        (is(fast && joined && !pinned && !particles), "carried", "of what carries joined bodies the acceleration alone counts",
            "remove `speed`: bodies in the plane start as they are seen from what carries them"),
        (Some(name).filter(|_| unclear && !joined && !pinned && !particles), "start",
            "at rest on the ground, or on what carries the scene?",
            "write `start: {{}: {speed: 0 m/s}}` for what is set down, as seen from the ground, or give it the speed of what carries it"),
        (is(matches!(scene.end, End::Speed(..)) && !joined), "end", "a carried scene does not end at a speed",
            "write `stops slipping`, `time`, or `travel`, which counts on what carries the scene"),
    ];
    tell(&rules, node, faults);
}

/// A rule of scenes: who breaks it, if anybody does; the field of the scene at which that is told (the whole, if it is not
/// written), what is said (`{}`: who), and what would be right, if that is not plain.
type SceneRule<'s> = (Option<&'s str>, &'static str, &'static str, &'static str);

/// Tells which of these rules are broken.
fn tell(rules: &[SceneRule], node: &Node, faults: &Faults) {
    for (who, field, message, hint) in rules {
        let Some(who) = who else { continue };
        let hint = match *hint {
            "" => None,
            hint => Some(hint.replace("{}", who)),
        };
        faults.maybe(part(node, field), message.replace("{}", who), hint);
    }
}

/// A rule that nobody in particular breaks.
fn is(broken: bool) -> Option<&'static str> {
    broken.then_some("")
}

/// Joined bodies: one leads, and none moves otherwise than in the plane.
fn mechanism(scene: &Scene, node: &Node, faults: &Faults) {
    let named = |what: fn(&Body) -> bool| scene.bodies.iter().find(|b| what(b)).map(|b| b.name.as_str());
    let level = |b: &Body| b.planar.as_ref().is_some_and(|p| p.level);
    let rough = |j: &&Joint| j.kind.mu_k().is_some();
    let rough = scene.joints.iter().find(rough).map(|j| j.name.as_str());
    let driven = (0..scene.bodies.len()).find(|b| scene.planar(*b).is_some_and(|p| p.driven.is_some()));
    let driven = driven.filter(|b| scene.end != End::AtOnce || scene.is_struck() || scene.lead() != Some(*b));
    let (struck, still) = (scene.is_struck(), scene.end == End::Equilibrium);
    let speeds = scene.start_speeds().count();
    let arrives = scene.arrivals().next().is_some();
    let recoils = scene.restitution.map(|(joint, _)| scene.joints[joint].name.as_str());
    let turning = named(|b| b.turns).unwrap_or("rod");
    // On a cylinder the angle is that of its place.
    let angled = named(|b| b.inertia.is_none() && matches!(&b.planar, Some(p) if p.start_deg.is_some()));
    let angled = angled.filter(|_| scene.lead().is_none());
    let straight = scene.restitution.is_some_and(|(joint, _)| {
        matches!(scene.joints[joint].kind, JointKind::Guide { .. } | JointKind::Contact { rolls: false, .. })
    });
    let loose = |joint: &&Joint| {
        let Some((_, _, Surface::Arc { centre_m, on: Some(on), .. })) = joint.kind.surface() else {
            return false;
        };
        let holds = |j: &Joint| j.kind == JointKind::Pin { at: on, place_m: centre_m };
        !scene.joints.iter().any(holds)
    };
    let loose = scene.joints.iter().find(loose).map(|j| j.name.as_str());
    let welded = |b: usize| {
        let held = |j: &&Joint| j.kind.spots().any(|spot| spot.body == b);
        let mut own = scene.joints.iter().filter(held).map(|j| j.kind);
        own.next().is_some_and(|kind| kind.is_weld()) && own.next().is_none()
    };
    let holes = || (0..scene.bodies.len()).filter(|b| scene.bodies[*b].removed);
    let cut = holes().find(|b| !welded(*b));
    let acted = |b: &usize| {
        let springs = |s: &Strut| s.at.body == *b || matches!(s.to, StrutEnd::Spot(to) if to.body == *b);
        scene.pushes.iter().any(|push| push.at.body == *b)
            || scene.couples.iter().any(|couple| couple.body == *b)
            || scene.struts.iter().any(springs)
            || scene.arrivals().any(|(body, _)| body == *b)
    };
    let acted = holes().find(acted);
    #[rustfmt::skip] // a table
    let rules: [SceneRule; 19] = [
        (named(|b| b.planar.is_none()), "", "`{}` does not move in the plane, and another body does",
            "write `moves: in the plane` for all of them, with joints"),
        (is(!scene.ties.is_empty()), "ties", "what moves in the plane is held by joints", "write `joints`"),
        (is(scene.bodies.iter().any(level) && !scene.bodies.iter().all(level)), "bodies",
            "some bodies move in a horizontal plane, others in the vertical one", "write the same `moves:` for all of them"),
        (is(!scene.growths.is_empty()), "forces", "what moves in the plane has no forces that grow",
            "remove `growing by`, or let the bodies move on lines"),
        (is(speeds > 1 && (scene.end != End::AtOnce || scene.driven().is_some())), "start", "more than one speed is given at the start of joined bodies",
            "give one speed or spin: the joints give the others; where they leave several freedoms, give one for each and write `end: at once`"),
        (is(arrives && (speeds > 0 || scene.carried.is_some())), "start", "a motion just before an impact stands beside another one",
            "give `arrives` alone: the joints take hold in the impact, and what moves after it follows"),
        (recoils.filter(|_| !arrives || scene.end != End::AtOnce), "joints", "`{}` has a restitution, and acts in an impact alone",
            "give what strikes its `arrives: {speed: v, direction: right}` under `start`, and write `end: at once`"),
        (recoils.filter(|_| !straight), "joints", "`{}` has a restitution and holds in more than one direction",
            "write it beside `guides:` or `slides:`: what a pin, a weld or a wheel that rolls throws back is not known"),
        (recoils.filter(|_| scene.pushes.iter().any(|p| p.blow)), "forces", "`{}` has a restitution, and an impulse acts besides",
            "take the impulse away"),
        (loose, "joints", "`{}` lies on a cylinder that turns with a body, and no pin holds that body at the axis of the cylinder",
            "write `outside: R, axis: [x, y], on: drum`, and for the drum `{pins: drum, at: [x, y]}` with the same numbers"),
        (cut.map(|b| scene.bodies[b].name.as_str()), "joints", "`{}` is taken away, and is not held by one weld alone",
            "weld it to that from which it is taken, as `hole: {welds: [disc.C, {}.A]}`; what holds that holds both"),
        (acted.map(|b| scene.bodies[b].name.as_str()), "forces", "`{}` is taken away: nothing acts there, and nothing arrives",
            "let it act on the body from which it is taken"),
        (rough.filter(|_| struck), "joints", "`{}` is rough, and an impulse acts: what friction does in a blow is not known",
            "remove `mu_k`"),
        (driven.map(|b| scene.bodies[b].name.as_str()), "start", "`{}` is driven, and its motion goes on",
            "only an instant is asked of what is driven: give its angle and spin then, and write `end: at once`"),
        (is(still && speeds > 0), "start", "at rest in equilibrium nothing has a speed or a spin",
            "give the angle alone: from it the equilibrium is looked for, and nothing moves there"),
        (is(still && struck), "forces", "at rest in equilibrium nothing is struck", "take the impulse, or `arrives`, away"),
        (rough.filter(|_| still), "joints", "`{}` is rough, so that there is no one equilibrium", "remove `mu_k`"),
        (angled, "start", "`{}` has an angle, and a mass alone: it only slides, and does not turn",
            "give it a `shape:`, or a `moment of inertia:`, which is 0 kg*m^2 of a small body on a light rod"),
        (Some(turning).filter(|_| scene.lead().is_none() && angled.is_none()), "start", "the angle at which the motion starts is missing",
            "write `start: {{}: {angle: phi0}}`"),
    ];
    tell(&rules, node, faults);
}

/// The start of a scene of which only an instant is asked, or that goes in phases: with the ties it gives each velocity, and none
/// twice. What depends on the numbers is left to the solvers: constants that agree with the ties may be given besides.
pub fn instant(scene: &Scene, draws: &[(String, Option<Draw>)], node: &Node, faults: &Faults) {
    let given = matches!(scene.end, End::AtOnce) || scene.goes_in_phases();
    if !given || scene.lead().is_some() || scene.start_speeds().next().is_none() {
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
        format!("the {what} of `{}`", scene.bodies[c.body].name)
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
                format!("the ties and the rest of the start already give {}", name(&c)),
                "take it away: one speed or spin for each freedom that the ties leave",
            );
        }
    }
    for (c, _) in coordinates.iter().zip(&taken).filter(|(_, row)| row.is_none()) {
        let (body, field) =
            (&scene.bodies[c.body].name, if c.degree == Degree::Along { "speed: v" } else { "spin: w" });
        faults.hint(
            start,
            format!("the start and the ties leave {} open", name(c)),
            format!("write `start: {{{body}: {{{field}}}}}` besides, or a tie that gives it"),
        );
    }
}

/// A round hole does not reach beyond the round body out of which it is cut, whatever is drawn: told where
/// it would even lie farthest in, be smallest and the body largest.
pub fn holes(scene: &Scene, data: &[Datum], draws: &[Option<Draw>], node: &Node, faults: &Faults) {
    let values = [0, 1].map(|end| {
        let value = |(datum, draw): (&Datum, &Option<Draw>)| {
            let range = draw.as_ref().map(|draw| <[Decimal; 2]>::from(draw.range()));
            range.map_or(f64::NAN, |range| datum.number(range[end]))
        };
        data.iter().zip(draws).map(value).collect::<Vec<f64>>()
    });
    let round = |body: usize| match scene.bodies[body].inertia {
        Some(RotaryInertia::Shape(shape, radius)) if shape != Shape::Rod => Some(radius),
        _ => None,
    };
    for joint in scene.joints.iter().filter(|joint| joint.kind.is_weld()) {
        let mut spots: Vec<Spot> = joint.kind.spots().collect();
        spots.sort_by_key(|spot| scene.bodies[spot.body].removed);
        let [whole, hole] = spots[..] else { continue };
        let (Some(outer), Some(own)) = (round(whole.body), round(hole.body)) else { continue };
        let sizes = |values: &Vec<f64>| {
            let of = |num: Num| scene.value(num, values);
            let place = |place: Place| match place {
                Place::At(n) => of(n),
                Place::HalfOf(n) => of(n) / 2.0,
            };
            let off = |spot: Spot| {
                let planar = scene.planar(spot.body)?;
                let [x, y] = planar.points.get(spot.point)?.1.map(place);
                let x = x - place(planar.centre);
                Some((x * x + y * y).sqrt())
            };
            // How a hole is turned that is not held at its centre does not matter here.
            let apart = off(whole).zip(off(hole)).map_or(f64::NAN, |(whole, hole)| whole - hole);
            [apart + of(own), of(outer)]
        };
        let [low, high] = values.each_ref().map(sizes);
        let beyond = low[0].min(high[0]) > low[1].max(high[1]) * (1.0 + 1e-9);
        let [whole, hole] = [whole, hole].map(|spot| &scene.bodies[spot.body]);
        if hole.removed && !whole.removed && beyond {
            faults.hint(
                part(node, "joints"),
                format!("`{}` reaches beyond `{}`, out of which it is cut", hole.name, whole.name),
                "lay it farther in: from centre to centre, and its radius, are no more than the outer radius",
            );
        }
    }
}

/// The field of this name, or the whole where it is not written.
fn part<'n>(node: &'n Node, name: &str) -> &'n Node {
    node.field(name).unwrap_or(node)
}

/// What begins to roll starts with slip.
fn thrown(scene: &Scene, node: &Node, faults: &Faults) {
    let End::Rolling(c) = scene.end else { return };
    let slips = |t: &Tie| matches!(t, Tie::Slip { body, .. } if *body == c.body);
    if scene.start.is_empty() || !scene.ties.iter().any(slips) {
        let name = scene.bodies.get(c.body).map_or("ball", |b| b.name.as_str());
        faults.hint(
            part(node, "end"),
            format!("`rolling` ends the slip of a body that is thrown with one; `{name}` is not"),
            match node.path.ends_with(".next") {
                true => {
                    format!("write `slips:` for `{name}`, and let the motion before it end while it slips")
                }
                false => {
                    format!("write `slips:` for `{name}` and `start: {{{name}: {{speed: v0, spin: w0}}}}`")
                }
            },
        );
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
                faults.hint(node, format!("`{{{{ {} }}}}` is not known", shorten(name)), hint);
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
                        format!("the statement never gives `{symbol}`"),
                        format!("write `{{{{ {symbol} }}}}` where it belongs"),
                    );
                }
            }
        }
    }
}

fn told(node: &Node, finding: &Finding, faults: &Faults) {
    let place = finding
        .at
        .map_or_else(String::new, |(line, column)| format!(" (line {line}, column {column} of the text)"));
    faults.maybe(node, format!("{}{place}", finding.message), finding.hint.clone());
}
