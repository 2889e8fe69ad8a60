//! The motion that begins where the one before it ends: the same scene, with what is written under `next` over what it says.
use crate::bank::node::{Node, Value};
use crate::bank::scene::SceneReader;
use crate::num::formula::{Formula, Step};
use crate::scene::{
    Attach, Coordinate, Degree, Derived, End, Far, Given, JointKind, Label, Num, Owner, Quantity, Rest,
    Scene, SpringTie, Start, Taken, Tie,
};
use std::borrow::Cow;

/// What is not written of a motion that follows, and why not.
const FIELDS: [(&str, &str); 4] = [
    ("bodies", "they stay as they are"),
    ("start", "it starts where the motion before it ends"),
    ("next", "one motion follows, and no other"),
    ("carried", "a scene that is carried has one motion"),
];

/// What the motion that follows takes over, as it is gathered.
struct Handover<'s> {
    /// How many data stand before what is taken over.
    data: usize,
    next: &'s mut Scene,
}

impl Handover<'_> {
    /// What the motion before it says of a label, as a step of a formula.
    fn take(&mut self, label: Label, directed: bool) -> Step<Given> {
        let taken = &mut self.next.formulas.taken;
        taken.push(Taken { label, directed });
        Step::Name(Given { datum: self.data + taken.len() - 1, degrees: false, powers: [0; 3] })
    }
    /// A number of a scene as steps of a formula, angles in radians.
    fn steps(of: &Scene, number: Num, degrees: bool) -> Vec<Step<Given>> {
        match number {
            Num::Datum(datum) => vec![Step::Name(Given { datum, degrees, powers: [0; 3] })],
            Num::Fixed(x) if degrees => {
                vec![Step::Number(x), Step::Pi, Step::Multiply, Step::Number(180.0), Step::Divide]
            }
            Num::Fixed(x) => vec![Step::Number(x)],
            Num::Derived(i) => {
                of.formulas.numbers.get(i).map_or_else(Vec::new, |n| n.formula.steps().to_vec())
            }
        }
    }
    /// A number that is worked out so.
    fn number(&mut self, steps: Vec<Step<Given>>, degrees: bool, text: &str) -> Num {
        let numbers = &mut self.next.formulas.numbers;
        numbers.push(Derived { formula: Formula::new(steps), degrees, text: text.to_owned(), any: false });
        Num::Derived(numbers.len() - 1)
    }
}

impl SceneReader<'_> {
    /// The motion that follows the one of `first`, which is written in `node`.
    pub(super) fn next(&self, changes: &Node, node: &Node, first: &Scene, gravity: usize) -> Option<Scene> {
        let f = self.faults;
        let Some(mut whole) = node.overlaid(changes) else {
            return f.refuse_with(
                changes,
                format!("expected what changes in the motion that follows, found {}", changes.kind()),
                "for example `{end: {turning point: block}}`",
            );
        };
        let mut written = FIELDS.iter().filter_map(|(field, why)| Some((changes.field(field)?, field, why)));
        if let Some((n, field, why)) = written.next() {
            return f.refuse_with(n, format!("`{field}` is not written here: {why}"), "remove this field");
        }
        if changes.field("end").is_none() {
            return f.refuse_with(changes, "`end` is missing", "say what ends the motion that follows");
        }
        if let Value::Map(fields) = &mut whole.value {
            fields.retain(|(key, _)| key.text() != Some("next"));
        }
        let mut next = self.scene(&whole, gravity)?;
        // The impact that set the first one off does not come again.
        next.bodies.iter_mut().filter_map(|b| b.planar.as_mut()).for_each(|planar| planar.arrives = None);
        let met = self.met.borrow();
        let open = [
            (!met.touches.is_empty(), "`touches` does not say whether it rolls", "write `rolls` or `slips`"),
            (!met.any.is_empty(), "`any` gives no value", "write a value or a datum in its place"),
        ];
        if let Some((_, what, hint)) = open.into_iter().find(|(is, ..)| *is) {
            return f.refuse_with(
                changes,
                format!("a motion that follows needs a scene that says everything: {what}"),
                hint,
            );
        }
        if let Some((what, hint)) = apart(first, &next) {
            return f.refuse_with(changes, what, hint);
        }
        take_over(first, &mut next, gravity + 1);
        Some(next)
    }
}

/// Why a motion does not follow another one, and what would be right; `None` if it does.
fn apart(first: &Scene, next: &Scene) -> Option<(&'static str, &'static str)> {
    let since_start = |rest: &Rest| matches!(rest, Rest::Stretch(_));
    let stretched = next.struts.iter().any(|s| since_start(&s.rest));
    let contact = |s: &Scene| s.joints.iter().any(|j| matches!(j.kind, JointKind::Contact { .. }));
    let placed = next.bodies.iter().filter_map(|b| b.planar.as_ref()).any(|p| p.origin_m.is_some());
    let driven = next.bodies.iter().filter_map(|b| b.planar.as_ref()).any(|p| p.driven.is_some());
    let hooked_anew = first.springs().any(|s| {
        again(first, next, &s).is_some_and(|now| {
            Handover::steps(next, now.stretch_m, false) != Handover::steps(first, s.stretch_m, false)
        })
    });
    let names = |s: &Scene| s.bodies.iter().map(|b| b.name.clone()).collect::<Vec<_>>();
    Some(if first.is_still() || matches!(first.end, End::Leaves(_)) {
        (
            "the motion before it has no end from which another could begin",
            "end it by a way, a time, a speed, an angle or a turning point",
        )
    } else if next.is_still() {
        ("the motion that follows is none", "end it by a way, a time, a speed, an angle or a turning point")
    } else if first.carried.is_some() {
        ("a scene that is carried has one motion", "tell it from the ground, without `carried`")
    } else if !next.growths.is_empty() {
        (
            "a force that grows counts from the start of the whole",
            "write `forces` or `ties` under `next` with a force that stays",
        )
    } else if first.grows_with_place() && matches!(next.end, End::Time(..)) {
        (
            "where forces grow with place the time is not told, and that of what follows counts from the start of the whole",
            "end it by a way, a speed or a turning point",
        )
    } else if next.is_struck() {
        ("the blow that sets it off does not come again", "write `forces` under `next` without it")
    } else if stretched {
        ("a spring told by its stretch at the start has another one here", "tell it by its natural length")
    } else if hooked_anew {
        (
            "a spring of both motions goes on with the stretch that it has at the end of the first",
            "write the `stretch` that it has in the first motion, or give another spring a place or a name of its own",
        )
    } else if contact(first) || contact(next) || placed || driven {
        ("of joined bodies, those follow on that pins, hinges, guides and cords hold", "ask for one motion")
    } else if names(first) != names(next) {
        ("the bodies are others", "keep them and their order")
    } else if first.lead() != next.lead() {
        ("another body leads", "keep which body has its angle at the start given")
    } else {
        return None;
    })
}

/// The spring of the motion that follows which is this one of the motion before it: at the same place, and of the same name if
/// there is more than one.
fn again(first: &Scene, next: &Scene, spring: &SpringTie) -> Option<SpringTie> {
    let name = |s: &Scene, tie: usize| s.owner_name(Owner::Tie(tie)).map(Cow::into_owned);
    let one = first.springs().count() == 1 && next.springs().count() == 1;
    let place = |s: &SpringTie| (s.from.body, s.from.forward, matches!(s.from.attach, Attach::Centre));
    next.springs()
        .find(|s| place(s) == place(spring) && (one || name(next, s.tie) == name(first, spring.tie)))
}

/// Puts the state at the end of the first motion for that at the start of the next.
fn take_over(first: &Scene, next: &mut Scene, data: usize) {
    let lead = first.lead();
    let ends = match lead {
        Some(body) => Coordinate { body, degree: Degree::Turn },
        None => first.ending_coordinate(),
    };
    let of = Owner::Body(ends.body);
    let at = next.end;
    let mut hand = Handover { data, next };
    hand.next.start.clear();
    // Each freedom has its own speed; a motion that ends at its turning point and has no other starts from rest.
    let free = if lead.is_some() { vec![ends] } else { hand.next.free(ends) };
    for c in free.iter().copied() {
        let turns = c == ends && matches!(first.end, End::TurningPoint(_));
        if turns && free.len() == 1 {
            break;
        }
        let rate = if turns {
            Num::Fixed(0.0)
        } else {
            let rate = hand.take(c.speed(), true);
            hand.number(vec![rate], false, "its speed")
        };
        hand.next.start.push(Start::Speed(c, rate));
    }
    if let Some(body) = lead {
        let turned = hand.take(Label { quantity: Quantity::Phi, of }, true);
        let start = first.planar(body).and_then(|planar| planar.start_deg);
        let mut steps = start.map_or_else(Vec::new, |angle| Handover::steps(first, angle, true));
        steps.extend([turned, Step::Add]);
        let angle = hand.number(steps, true, "its angle");
        // Those of the others follow from the joints.
        hand.next.bodies.iter_mut().filter_map(|b| b.planar.as_mut()).for_each(|p| p.start_deg = None);
        if let Some(planar) = &mut hand.next.bodies[body].planar {
            planar.start_deg = Some(angle);
        }
    }
    // Places and times count from the start of the whole.
    let passed = match at {
        End::Position(c, _) => Some(Label { quantity: Quantity::Displacement, of: Owner::Body(c.body) }),
        End::Time(..) => Some(Label { quantity: Quantity::T, of: Owner::Scene }),
        _ => None,
    };
    if let (Some(passed), End::Position(c, whole) | End::Time(c, whole)) = (passed, at) {
        let passed = hand.take(passed, false);
        let mut steps = Handover::steps(hand.next, whole, false);
        steps.extend([passed, Step::Subtract]);
        let left = hand.number(steps, false, "what is left of it");
        hand.next.end = if let End::Time(..) = at { End::Time(c, left) } else { End::Position(c, left) };
    }
    // A spring of both motions is one by the name of its cord.
    let before: Vec<SpringTie> = first.springs().collect();
    for spring in before {
        let Some(now) = again(first, hand.next, &spring) else { continue };
        let pull = hand.take(Label { quantity: Quantity::Tension, of: Owner::Tie(spring.tie) }, false);
        let mut steps = vec![pull];
        steps.extend(Handover::steps(first, spring.stiffness_n_m, false));
        steps.push(Step::Divide);
        let stretch = hand.number(steps, false, "its stretch");
        if let Some(Tie::Cord(cord)) = hand.next.ties.get_mut(now.tie)
            && let Far::Spring { stretch_m, .. } = &mut cord.to
        {
            *stretch_m = stretch;
        }
    }
}
