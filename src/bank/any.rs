//! A mass or a radius that is `any`: it is never given, for no answer depends on it. That is proved by scaling, on the numbers
//! of the scene.
//!
//! *Mass.* Where every number with the dimension of mass is this one, another unit of mass makes another mass of it and the same
//! numbers else: what is measured without mass is the same. *Radius.* A body enters by its mass, the travel of its centre, and
//! `radius times turn`, with the inertia `I / radius^2`: where its inertia is that of a shape of this radius, and all that rolls
//! or is wound on it has this radius too, the radius enters nothing but its turn.
use crate::bank::node::{Faults, Node};
use crate::scene::{
    Degree, End, Label, Mass, Num, Owner, Quantity, RotaryInertia, Scene, Start, Term, given, scales,
};

/// A number that is written `any`.
#[derive(Debug, Clone)]
pub struct AnyNumber {
    pub node: Node,
    pub number: Num,
}

/// What is `any` of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cancels {
    /// The mass of this body, the only one.
    Mass(usize),
    /// The radius of this body.
    Radius(usize),
}

impl Cancels {
    fn named(self, scene: &Scene) -> String {
        let (what, body) = match self {
            Self::Mass(b) => ("mass", b),
            Self::Radius(b) => ("radius", b),
        };
        format!("the {what} of `{}`", scene.bodies[body].name)
    }
}

/// Whose mass or radius it is, if the scene is the same whatever it is; else what it does not cancel against.
fn proved(scene: &Scene, number: Num) -> Result<Cancels, String> {
    let has = |mass: &Mass| matches!(mass, Mass::Kilograms(n) if *n == number);
    if let Some(body) = scene.bodies.iter().position(|b| has(&b.mass)) {
        let mut other = None;
        given::read::all(scene, &mut |n, (unit, _)| {
            if scales::is_massive(unit) && *n != number {
                other = Some(match unit {
                    "kg" => "there is another mass",
                    "kg*m^2" => "there is a moment of inertia",
                    "N*m" => "there is a couple",
                    "N/m" => "there is a spring",
                    _ => "there is a force that is given",
                });
            }
        });
        return other.map_or(Ok(Cancels::Mass(body)), |why| Err(why.to_owned()));
    }
    let shaped =
        |b: &crate::scene::Body| matches!(b.inertia, Some(RotaryInertia::Shape(_, n)) if n == number);
    let Some(body) = scene.bodies.iter().position(shaped) else {
        return Err("it is neither the mass of a body nor the radius of its shape".to_owned());
    };
    let of = &scene.bodies[body];
    if of.is_pinned() {
        return Err("the body is pinned".to_owned());
    }
    if of.planar.is_some() {
        return Err("the body moves in the plane".to_owned());
    }
    if let Some((name, _)) = of.radii_m.iter().find(|(_, n)| *n != number) {
        return Err(format!("the body has another radius, `{name}`"));
    }
    if scene.couples.iter().any(|c| c.body == body) {
        return Err("a couple acts on the body".to_owned());
    }
    let turns = |c: &crate::scene::Coordinate| c.body == body && c.degree == Degree::Turn;
    let zero = |n: &Num| matches!(n, Num::Fixed(0.0));
    if scene.start.iter().any(|s| matches!(s, Start::Speed(c, n) if turns(c) && !zero(n))) {
        return Err("the body starts with a spin".to_owned());
    }
    let by_turn = match &scene.end {
        End::Travel(c, _) | End::Position(c, _) | End::Speed(c, _) | End::Angle(c, _) => turns(c),
        End::AtOnce
        | End::Time(..)
        | End::TurningPoint(_)
        | End::Rolling(_)
        | End::Leaves(_)
        | End::Equilibrium => false,
    };
    if by_turn {
        Err("the motion ends by the turn of the body".to_owned())
    } else {
        Ok(Cancels::Radius(body))
    }
}

/// Does a quantity depend on what is `any`?
fn depends(scene: &Scene, label: Label, cancels: Cancels) -> bool {
    if let Owner::Asked(i) = label.of {
        let Some(asked) = scene.formulas.asked.get(i) else { return true };
        // A dimension that no given mass makes is made of quantities that have it.
        return match cancels {
            Cancels::Mass(_) => asked.powers[0] != 0,
            Cancels::Radius(_) => asked.formula.names().any(|term| match term {
                Term::Said(label) | Term::Other(_, label) => depends(scene, label, cancels),
                Term::Given(_) => false,
            }),
        };
    }
    match cancels {
        Cancels::Mass(_) => ["N", "J", "W", "kg*m^2", "N*s", "kg*m^2/s"].contains(&label.quantity.unit()),
        // Of bodies that are welded into one.
        Cancels::Radius(_)
            if label.of == Owner::Scene && matches!(label.quantity, Quantity::IO | Quantity::IG) =>
        {
            true
        }
        Cancels::Radius(body) => {
            let turning = matches!(
                label.quantity,
                Quantity::Omega
                    | Quantity::Alpha
                    | Quantity::Phi
                    | Quantity::IG
                    | Quantity::AngularMomentum
                    | Quantity::KBound
            );
            turning && matches!(label.of, Owner::Body(b) if b == body)
        }
    }
}

/// Is a quantity of a scene the same whatever is `any`?
pub fn is_told(scene: &Scene, label: Label) -> bool {
    let numbers = scene.formulas.numbers.iter().enumerate().filter(|(_, n)| n.any);
    numbers
        .map(|(i, _)| proved(scene, Num::Derived(i)))
        .all(|cancels| cancels.is_ok_and(|cancels| !depends(scene, label, cancels)))
}

/// Tells of what is `any` and does not cancel, and of questions and bounds (with the places to tell it at) that depend on it.
pub fn review(scene: &Scene, numbers: &[AnyNumber], told: &[(Label, String, &Node)], faults: &Faults) {
    for any in numbers {
        let cancels = match proved(scene, any.number) {
            Ok(cancels) => cancels,
            Err(why) => {
                let message = format!("this does not cancel: {why}");
                faults.hint(&any.node, message, "give it: a symbol of the data, or a constant");
                continue;
            }
        };
        for (label, name, node) in told.iter().filter(|(label, ..)| depends(scene, *label, cancels)) {
            let of = cancels.named(scene);
            let message = format!("`{name}` depends on {of}, which is `any`");
            faults.hint(node, message, format!("give {of}, or leave `{}` out", scene.name_of(*label)));
        }
    }
}
