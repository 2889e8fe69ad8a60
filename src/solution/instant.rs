//! Kinetic energy of bodies at an instant: the velocities that the ties add to those of the start, then the definition, body by
//! body.
use crate::scene::{Coordinate, CordEnd, Degree, Far, Quantity, Tie};
use crate::solution::account::{of_body, of_scene};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{Expr, SymbolId, ZERO, magnitude, ratio, square, sum};
use crate::solution::factors::Factors;

use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::terms;
use crate::solution::terms::{BodyTerms, tagged};
use crate::solution::text::{Block, SolutionSection};

/// The velocities of one body, as far as they are known, positive forward.
#[derive(Debug, Clone, Default)]
struct KnownVelocities {
    along: Option<Expr>,
    turn: Option<Expr>,
}

/// The velocities of the bodies, found one after the other.
struct InstantSpeeds<'d, 'a> {
    draft: &'d mut Draft<'a>,
    parts: Vec<BodyTerms>,
    known: Vec<KnownVelocities>,
    /// Spin per unit velocity of the centre, where a tie of the body alone gives it, and the phrase for that.
    inner: Vec<Option<(Factors, &'static str)>>,
    section: SolutionSection,
    derived: bool,
}

impl InstantSpeeds<'_, '_> {
    fn get(&self, c: Coordinate) -> Option<&Expr> {
        let known = &self.known[c.body];
        if c.degree == Degree::Along { known.along.as_ref() } else { known.turn.as_ref() }
    }
    fn set(&mut self, c: Coordinate, velocity: Expr) {
        let known = &mut self.known[c.body];
        *(if c.degree == Degree::Along { &mut known.along } else { &mut known.turn }) = Some(velocity);
    }
    /// Writes down a velocity that follows.
    fn derive(&mut self, c: Coordinate, from: &Expr, why: &str) {
        let part = &self.parts[c.body];
        let symbol = if c.degree == Degree::Along { part.v } else { part.omega };
        let Some(symbol) = symbol.filter(|_| *from != ZERO) else {
            self.set(c, ZERO);
            return;
        };
        if !self.derived {
            self.derived = true;
            self.section.say(self.draft.words.get("solution.instant_ties"));
        }
        self.section.say(self.draft.words.get(why));
        self.section.find(&mut self.draft.symbols, symbol, from);
        self.set(c, symbol.into());
    }
    /// The velocities of a body that its own tie gives once one of them is known. Did that add one?
    fn within(&mut self, body: usize) -> bool {
        let Some((inner, why)) = self.inner[body].clone() else { return false };
        let (along, turn) =
            (Coordinate { body, degree: Degree::Along }, Coordinate { body, degree: Degree::Turn });
        match (self.get(along).cloned(), self.get(turn).cloned()) {
            (Some(v), None) => self.derive(turn, &Factors::of(&v).times(&inner).expr(), why),
            (None, Some(w)) => self.derive(along, &Factors::of(&w).per(&inner).expr(), why),
            _ => return false,
        }
        true
    }
    /// Velocity of the point at which a cord leaves, along the cord and away from the body; `None` if it is not known.
    fn point(&mut self, end: &CordEnd) -> Option<Expr> {
        let (along, arm) = terms::lever(self.draft, end);
        let known = &self.known[end.body];
        let mut terms = Vec::new();
        for (velocity, share) in [(&known.along, along), (&known.turn, arm)] {
            if !share.is_zero() {
                terms.push(Factors::of(velocity.as_ref()?).times(&share).expr());
            }
        }
        Some(sum(terms))
    }
    /// The velocity that a cord adds to the body at this end, whose point goes out with `out`. Did it add one?
    fn pulled(&mut self, end: &CordEnd, out: &Expr) -> bool {
        let (along, arm) = terms::lever(self.draft, end);
        let (v, w) = (self.known[end.body].along.clone(), self.known[end.body].turn.clone());
        let body = end.body;
        let rest = |known: &Expr, share: &Factors| out + Factors::of(known).times(&share.opposite()).expr();
        let (degree, from) = match (v, w, &self.inner[body]) {
            (None, None, Some((inner, _))) => {
                let share = along.plus(&arm.times(inner));
                if share.is_zero() {
                    return false;
                }
                (Degree::Along, Factors::of(out).per(&share).expr())
            }
            (None, Some(w), _) => (Degree::Along, Factors::of(&rest(&w, &arm)).per(&along).expr()),
            (Some(v), None, _) if !arm.is_zero() => {
                (Degree::Turn, Factors::of(&rest(&v, &along)).per(&arm).expr())
            }
            (None, None, None) if arm.is_zero() => (Degree::Along, Factors::of(out).per(&along).expr()),
            _ => return false,
        };
        let tied = self.inner[body].is_some() && !arm.is_zero();
        let why = if tied { "solution.instant_cord_tied" } else { "solution.instant_cord" };
        self.derive(Coordinate { body, degree }, &from, why);
        true
    }
}

/// Writes the velocities and the sum.
///
/// # Errors
/// What the derivation does not cover.
pub fn write(draft: &mut Draft) -> Result<(), DerivationStop> {
    let parts = terms::parts(draft, false);
    let mut section = SolutionSection::new("energy", draft.words.get("solution.title.energy"));
    section.blocks.push(Block::Picture("scene".to_owned()));
    section.say(draft.words.get("solution.signs_drawn"));
    section.say(draft.words.get("solution.instant"));
    let speeds = speeds(draft, parts, section)?;
    let InstantSpeeds { draft, parts, known, mut section, .. } = speeds;
    if known.iter().any(|k| [&k.along, &k.turn].into_iter().flatten().any(|v| matches!(v, Expr::Symbol(_)))) {
        section.say(draft.words.get("solution.instant_sum"));
    }
    let mut turning = Vec::new();
    let mut terms = Vec::new();
    for (part, known) in parts.iter().zip(&known) {
        let half = |i: &Factors, v: &Expr| ratio(1, 2) * i.expr() * square(v);
        if let Some(v) = known.along.as_ref().filter(|v| **v != ZERO) {
            terms.push(half(&part.mass, v));
        }
        if let Some(w) = known.turn.as_ref().filter(|w| **w != ZERO) {
            turning.extend(part.inertia.iter().map(|i| half(i, w)));
            terms.extend(part.inertia.iter().map(|i| half(i, w)));
        }
    }
    let tex = draft.free(&["E_{k}"]);
    let energy = draft.unknown(&tex, "J");
    section.find(&mut draft.symbols, energy, &sum(terms));
    draft.answer(of_scene(Quantity::KineticEnergy), DerivedAnswer::Value(energy));
    if draft.asks(Quantity::RotationalFraction) {
        let tex = draft.free(&[r"\eta", r"\beta"]);
        let share = draft.unknown(&tex, "1");
        section.find(&mut draft.symbols, share, &(sum(turning) / energy));
        draft.answer(of_scene(Quantity::RotationalFraction), DerivedAnswer::Value(share));
    }
    for c in draft.scene.coordinates() {
        let (quantity, tex, unit) = match c.degree {
            Degree::Along => (Quantity::V, "v", "m/s"),
            Degree::Turn => (Quantity::Omega, r"\omega", "rad/s"),
        };
        let velocity = match c.degree {
            Degree::Along => &known[c.body].along,
            Degree::Turn => &known[c.body].turn,
        };
        let (Some(velocity), true) = (velocity, draft.asks_label(of_body(quantity, c.body))) else {
            continue;
        };
        let symbol = match velocity {
            Expr::Symbol(symbol) if draft.symbols.value(*symbol) >= 0.0 => *symbol,
            other => {
                let tex = format!(r"\left|{}\right|", tagged(tex, &parts[c.body].tag));
                let size: SymbolId = draft.unknown(&tex, unit);
                let from = if *other == ZERO { ZERO } else { magnitude(other.clone()) };
                section.find(&mut draft.symbols, size, &from);
                size
            }
        };
        draft.answer(of_body(quantity, c.body), DerivedAnswer::Value(symbol));
    }
    draft.sections.push(section);
    Ok(())
}

/// All velocities: those of the start, then tie by tie.
fn speeds<'d, 'a>(
    draft: &'d mut Draft<'a>,
    parts: Vec<BodyTerms>,
    section: SolutionSection,
) -> Result<InstantSpeeds<'d, 'a>, DerivationStop> {
    let scene = draft.scene;
    let known = vec![KnownVelocities::default(); parts.len()];
    let inner = vec![None; parts.len()];
    let mut all = InstantSpeeds { draft, parts, known, inner, section, derived: false };
    let rest = scene.start_speeds().next().is_none();
    for c in scene.coordinates().filter(|_| rest) {
        all.set(c, ZERO);
    }
    for (c, num) in scene.start_speeds().filter(|_| !rest) {
        let (tex, unit) = if c.degree == Degree::Along { ("v", "m/s") } else { (r"\omega", "rad/s") };
        let tex = tagged(tex, &all.parts[c.body].tag);
        let velocity = all.draft.number(num, &tex, unit);
        all.set(c, velocity);
    }
    for tie in &scene.ties {
        match tie {
            Tie::Roll { body, radius_m, .. } => {
                let c = Factors::of(&all.draft.number(*radius_m, "R", "m"));
                all.inner[*body] = Some((Factors::one().per(&c), "solution.instant_roll"));
            }
            Tie::Cord(cord) if cord.to == Far::Fixed => {
                let (along, arm) = terms::lever(all.draft, &cord.from);
                let body = cord.from.body;
                let both = all.parts[body].v.is_some() && all.parts[body].omega.is_some();
                if both && !arm.is_zero() && all.inner[body].is_none() {
                    // along v + arm omega = 0
                    all.inner[body] = Some((along.per(&arm).opposite(), "solution.instant_fixed"));
                } else if both && all.inner[body].is_some() {
                    return Err(Beyond::SeveralEquations.into());
                } else {
                    // What moves only in the direction of the cord rests.
                    let degree = if all.parts[body].v.is_some() { Degree::Along } else { Degree::Turn };
                    all.set(Coordinate { body, degree }, ZERO);
                }
            }
            _ => {}
        }
    }
    // What a body has not does not move.
    for (known, part) in all.known.iter_mut().zip(&all.parts) {
        if part.v.is_none() {
            known.along = Some(ZERO);
        }
        if part.omega.is_none() {
            known.turn = Some(ZERO);
        }
    }
    loop {
        let mut progress = false;
        for body in 0..all.parts.len() {
            progress |= all.within(body);
        }
        for tie in &scene.ties {
            let Tie::Cord(cord) = tie else { continue };
            let Far::Body(other) = &cord.to else { continue };
            match (all.point(&cord.from), all.point(other)) {
                // What runs out at the one end runs in at the other.
                (Some(out), None) => progress |= all.pulled(other, &Factors::of(&out).opposite().expr()),
                (None, Some(out)) => progress |= all.pulled(&cord.from, &Factors::of(&out).opposite().expr()),
                _ => {}
            }
        }
        if !progress {
            break;
        }
    }
    if scene.coordinates().any(|c| all.get(c).is_none()) {
        return Err(Beyond::SeveralEquations.into());
    }
    Ok(all)
}
