//! What a solver yields: numbers, words of the regime, checks; never sentences.
#[cfg(feature = "program")]
use crate::num::Lanes;
use crate::num::dd::pow2;
use crate::num::gauss::Unsettled;
use crate::num::linear::Singular;
use crate::num::ode::Trouble;
use crate::num::{Fast, Real, ball};
use crate::scene::{
    AsIf, Coordinate, Degree, End, Joint, JointKind, Label, Numbers, Owner, Quantities, Quantity, Scales,
    Scene, SpringTie, Taken, Term, admissible, pose,
};
use crate::solve::method::Method;
use serde::{Deserialize, Serialize};
use smallvec::SmallVec;
#[cfg(feature = "program")]
use std::rc::Rc;

/// What really happens, in the words that scripts rely on ([`Regime::word`]).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Regime {
    /// The motion.
    pub motion: Motion,
    /// The scene says that it rolls, and the friction needed exceeds `mu_s N`.
    pub slips: bool,
}

macro_rules! motions {
    ($($variant:ident $word:literal $they:literal [$($synonym:literal)*];)*) => {
        /// Words of the regime: the table from which banks are read, messages are made, and the list of the README is checked.
        /// What each means stands in the word lists, `sheet.regime.WORD`, in every language.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Motion { $(#[doc = concat!("`", $word, "`: they ", $they)] $variant,)* }
        impl Motion {
            /// All of them.
            pub const ALL: &'static [Motion] = &[$(Motion::$variant,)*];
            /// The word.
            pub const fn word(self) -> &'static str { match self { $(Motion::$variant => $word,)* } }
            /// What several draws of it do: `move up`.
            pub const fn they(self) -> &'static str { match self { $(Motion::$variant => $they,)* } }
            /// Other words for it in banks.
            pub const fn synonyms(self) -> &'static [&'static str] {
                match self { $(Motion::$variant => &[$($synonym),*],)* }
            }
        }
    };
}
// On a level, and where a body only turns, forward is right and back is left; there the words of slopes are read too.
motions! {
    MovesUp "moves_up" "move up" [];
    Balanced "balanced" "are balanced and stay" [];
    MovesDown "moves_down" "move down" [];
    MovesForward "moves_forward" "move forward" [];
    MovesBack "moves_back" "move back" [];
    Rolls "rolls" "roll" [];
    AtLimit "at_limit" "are just at the limit of slipping" [];
    SlipsUp "slips_up" "slip up" [];
    SpinsInPlace "spins_in_place" "spin in place" [];
    SlipsDown "slips_down" "slip down" [];
    SlipsForward "slips_forward" "slip forward" ["slips_up"];
    SlipsBack "slips_back" "slip back" ["slips_down"];
    UpOk "up ok" "move up and reach the end" [];
    UpTurningPoint "up turning_point" "move up and just reach the end" [];
    UpUnreachable "up unreachable" "move up and turn before the end" [];
    DownOk "down ok" "move down and reach the end" [];
    DownTurningPoint "down turning_point" "move down and just reach the end" [];
    DownUnreachable "down unreachable" "move down and turn before the end" [];
    ForwardOk "forward ok" "move forward and reach the end" ["up ok"];
    ForwardTurningPoint "forward turning_point" "move forward and just reach the end" ["up turning_point"];
    ForwardUnreachable "forward unreachable" "move forward and turn before the end" ["up unreachable"];
    BackOk "back ok" "move back and reach the end" ["down ok"];
    BackTurningPoint "back turning_point" "move back and just reach the end" ["down turning_point"];
    BackUnreachable "back unreachable" "move back and turn before the end" ["down unreachable"];
    Rest "rest" "stay at rest" [];
    SwingsOk "swings ok" "swing and reach the end" ["moves ok"];
    SwingsTurningPoint "swings turning_point" "swing and just reach the end" ["moves turning_point"];
    SwingsUnreachable "swings unreachable" "swing and turn before the end" ["moves unreachable"];
    RollsAfter "rolls_after" "slip first and roll afterwards" [];
    RollsAtStart "rolls_at_start" "roll from the start" [];
    SlipsThrough "slips_through" "slip on the other way" [];
    Never "never" "slip without end" [];
    Instant "instant" "are an instant only" [];
}

impl Motion {
    /// Is this word one for it?
    pub fn is_called(self, word: &str) -> bool {
        self.word() == word || self.synonyms().contains(&word)
    }
    /// Name of the phrase that says what it means: `sheet.regime.up_ok`.
    pub fn phrase(self) -> String {
        format!("sheet.regime.{}", self.word().replace(' ', "_"))
    }
}

impl Regime {
    /// The word, with ` slips` appended where it applies.
    pub fn word(self) -> String {
        if self.slips { format!("{} slips", self.motion.word()) } else { self.motion.word().to_owned() }
    }
    /// What several draws of it do: `slip down`.
    pub fn they(self) -> String {
        if self.slips { "slip where they are said to roll".to_owned() } else { self.motion.they().to_owned() }
    }
    /// Does it stay?
    pub const fn stays(self) -> bool {
        matches!(self.motion, Motion::Balanced | Motion::Rest)
    }
    /// Does it stay, and does a problem declare that by these words?
    pub fn stays_as(self, declared: &[String]) -> bool {
        self.stays() && declared.iter().any(|word| self.motion.is_called(word))
    }
    /// Is it what a problem declares by these words? Any motion is where it declares none, save slip of what is said to roll.
    ///
    /// An end that is the turning point is always reached, `ok`, and is the turning point: both words are right.
    pub fn is_one_of(self, declared: &[String], scene: &Scene) -> bool {
        let there = match (&scene.end, self.motion) {
            (End::TurningPoint(_), Motion::UpOk) => Motion::UpTurningPoint,
            (End::TurningPoint(_), Motion::DownOk) => Motion::DownTurningPoint,
            (End::TurningPoint(_), Motion::ForwardOk) => Motion::ForwardTurningPoint,
            (End::TurningPoint(_), Motion::BackOk) => Motion::BackTurningPoint,
            (End::TurningPoint(_), Motion::SwingsOk) => Motion::SwingsTurningPoint,
            (_, motion) => motion,
        };
        let is = |word: &String| self.motion.is_called(word) || there.is_called(word);
        !self.slips && (declared.is_empty() || declared.iter().any(is))
    }
}

macro_rules! check_kinds {
    ($($(#[$doc:meta])* $kind:ident $name:literal $unit:literal;)*) => {
        /// Which condition of validity, or which switch of the motion: an event at which another law takes over. Near a switch an
        /// answer may jump although its condition number is small, so draws keep away from it by a margin.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum CheckKind { $($(#[$doc])* $kind,)* }
        impl CheckKind {
            /// All of them.
            pub const ALL: &'static [CheckKind] = &[$(Self::$kind,)*];
            /// Name in JSON and in tables of refusals.
            pub const fn name(self) -> &'static str { match self { $(Self::$kind => $name,)* } }
            /// Unit of SI of what is required and available.
            pub fn unit(self, scene: &Scene) -> &'static str {
                match self {
                    Self::Reaches => scene.measure(),
                    Self::Slack if scene.ending_coordinate().degree == Degree::Turn => "rad",
                    _ => match self { $(Self::$kind => $unit,)* },
                }
            }
        }
    };
}
check_kinds! {
    /// It moves, the declared way: drive at the start, as a share of the largest force term (signed by the heading).
    Moves "moves" "N";
    /// `|F| <= mu_s N` as far as the scene looks ([`crate::scene::Span`]): required is the largest |F|, N; available `mu_s N`.
    NoSlip "no_slip" "N";
    /// `|F_rolled| > mu_s N`: required is `mu_s N`; available the friction that rolling would need.
    MustSlip "must_slip" "N";
    /// N > 0: required 0, available N.
    Pressed "pressed" "N";
    /// A cord between bodies is taut as far as the scene looks: required 0, available the least tension, N; the margin is its
    /// share of the other forces that make it up.
    Taut "taut" "N";
    /// The slip goes against the friction: required 0, available slip acceleration against friction, m/s^2.
    SlipDirection "slip_direction" "m/s^2";
    /// What is thrown starts with slip: required 0, available the slip speed, m/s; the margin is its share of the speeds
    /// that make it up.
    StartsSlipping "starts_slipping" "m/s";
    /// Kinetic friction ends the slip: required, the force that keeps it up, N; available `mu_k N`.
    Closes "closes" "N";
    /// The end event is reached before the turning point: required, the asked value; available, the farthest.
    Reaches "reaches" "1";
    /// Switch: where the cord of a spring goes slack. Required, the way to the end; available, the way to the switch. It always
    /// holds, the margin is how far they are apart.
    Slack "slack" "m";
    /// Switch: where the slip of what is thrown ends. Required, the time of the end, s; available, that of the switch. It always
    /// holds, the margin is how far they are apart.
    SlipEnds "slip_ends" "s";
    /// Switch: the turning point of what is thrown. Available, its speed at the end, m/s. It always holds, the margin is the share
    /// of the speeds that make it up.
    UnderWay "under_way" "m/s";
    /// Switch: whether static friction could hold what is thrown, where the end comes before that is put to the test. Required, the
    /// friction that rolling needs, N; available `mu_s N`. It always holds, the margin is how far they are apart.
    StaticLimit "static_limit" "N";
    /// A contact or a cord of joined bodies holds at a blow: required 0, available its impulse, N s.
    HoldsBlow "holds_blow" "N*s";
    /// A spring that only pushes or pulls acts before the end: required, the way until it does, rad; available, that to the end.
    Met "met" "rad";
    /// The motion that follows goes as it is said to: all conditions of its own hold. The margin is that of the one that holds least,
    /// whose kind is told in place of a body, by its index.
    Next "next" "1";
}

impl CheckKind {
    /// Is its margin a share that says how far it holds? That of the others is 1 or -1.
    pub const fn is_share(self) -> bool {
        !matches!(self, Self::Pressed | Self::Taut | Self::HoldsBlow | Self::SlipDirection)
    }
}

/// One condition of validity, with the numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// Which.
    pub kind: CheckKind,
    /// Whose: index of the body or tie, by kind; of [`CheckKind::Next`] a kind.
    pub of: usize,
    /// Does it hold?
    pub ok: bool,
    /// What is required (see [`CheckKind`]).
    pub required: f64,
    /// What is available; may be infinite (no turning point), NaN where statics leaves it open.
    pub available: f64,
    /// How far it holds, as a share: (available - required) / the larger; draws want a margin. Negative where it fails.
    pub margin: f64,
}

impl Check {
    /// Is it of a cord that need not pull: without tension, or with one that statics leaves open? What rests needs none.
    pub fn idles(&self) -> bool {
        self.kind == CheckKind::Taut && (self.available.is_nan() || self.available.abs() <= 0.0)
    }
}

/// A quantity as both roads give it, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// Which quantity, of what.
    pub label: Label,
    /// From the equations of motion.
    pub eom: Option<f64>,
    /// From work and energy.
    pub energy: Option<f64>,
    /// Condition number with respect to the data, g and angles included; infinite for 0 with nonzero sensitivity, but that of
    /// a place that is 0 is told by the scale of its terms. NaN where it was not asked for.
    pub cond: f64,
    /// Proved: the true answer for the printed data lies within this of [`Entry::value`], SI. `None` where nothing is
    /// proved.
    pub bound: Option<f64>,
    /// Scale of the terms that make up the quantity (N for a friction, m for a slip): the sum of their magnitudes.
    pub scale: f64,
}

impl Entry {
    /// The published value: from the equations of motion where they give it, else from energy.
    pub fn value(&self) -> f64 {
        self.eom.or(self.energy).unwrap_or(f64::NAN)
    }
    /// `|eom - energy| / max(|eom|, |energy|)`; `None` with one road.
    #[expect(clippy::float_cmp, reason = "equal bits have no gap, infinities among them")]
    pub fn gap(&self) -> Option<f64> {
        let (a, b) = (self.eom?, self.energy?);
        let larger = a.abs().max(b.abs());
        Some(if a == b { 0.0 } else { (a - b).abs() / larger })
    }
}

worded! {
    /// Words that some questions ask, as students write them.
    Word {
    /// Up the incline.
    Up "up",
    /// Down the incline.
    Down "down",
    /// Forward on a level.
    Forward "forward",
    /// Back on a level.
    Back "back",
    /// Does not move.
    Stays "stays",
    /// Yes.
    Yes "yes",
    /// No.
    No "no",
}}

/// A solved scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    /// What really happens.
    pub regime: Regime,
    /// All conditions of validity.
    pub checks: Vec<Check>,
    /// All reachable quantities, in the order in which the scene yields them.
    pub entries: Vec<Entry>,
    /// Answers in words.
    pub words: Vec<(Label, Word)>,
    /// Reactions, and what hangs on them, that the ties share in a way that statics leaves open: not published.
    pub open: Vec<Label>,
    /// Quantities whose value is finite but so large or small that no double holds it to 16 digits: not published.
    pub beyond: Vec<Label>,
    /// Units in which it was computed; everything here is in SI.
    pub scales: Scales,
}

impl Solved {
    /// Nothing: of a scene that has no solution.
    pub fn none() -> Self {
        Self {
            regime: Regime { motion: Motion::Instant, slips: false },
            checks: Vec::new(),
            entries: Vec::new(),
            words: Vec::new(),
            open: Vec::new(),
            beyond: Vec::new(),
            scales: Scales::SI,
        }
    }
    /// The entry of a label.
    pub fn get(&self, label: Label) -> Option<&Entry> {
        self.entries.iter().find(|e| e.label == label)
    }
    /// The value of a label as it is asked of its scene; NaN where there is none.
    pub fn asked(&self, scene: &Scene, label: Label) -> f64 {
        self.get(label).map_or(f64::NAN, |entry| scene.as_asked(label, entry.value()))
    }
    /// The word of a label.
    pub fn word(&self, label: Label) -> Option<Word> {
        self.words.iter().find(|(l, _)| *l == label).map(|(_, w)| *w)
    }
    /// Do all checks hold?
    pub fn all_hold(&self) -> bool {
        self.checks.iter().all(|c| c.ok)
    }
    /// The same where a problem declares these regimes: what is declared to stay need not move.
    pub fn holds_as(&self, declared: &[String]) -> bool {
        self.failing(declared).is_none()
    }
    /// The first check that fails where a problem declares these regimes.
    pub fn failing(&self, declared: &[String]) -> Option<&Check> {
        let stays = self.regime.stays_as(declared);
        let idle = |c: &&Check| stays && (c.kind == CheckKind::Moves || c.idles());
        self.checks.iter().find(|c| !c.ok && !idle(c))
    }
}

/// Why a scene with these data has no answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// Data that are no scene.
    Inadmissible(Vec<crate::scene::Inadmissible>),
    /// Data with which the motion that follows is none.
    NextInadmissible(Vec<crate::scene::Inadmissible>),
    /// The equations do not determine the motion: unknowns, rank.
    Singular {
        /// Number of unknowns.
        unknowns: usize,
        /// Rank found.
        rank: usize,
    },
    /// No value of its range gives the measurement from which a datum is found.
    NotFound,
    /// That it is the only one in its range cannot be shown; and a value, SI or degrees, with which nothing is measured, if one was met.
    NotUnique(Option<f64>),
    /// The ties leave this many freedoms; the program solves one, or two with slip.
    Freedoms(usize),
    /// No way is known to place this body by its joints.
    Unplaced(usize),
    /// Links of equal opposite sides, which would lie crossed by default.
    Crossed(crate::scene::pose::Choice),
    /// The side that is told of this body decides nothing, or contradicts that of the one with which it is placed.
    IdleSide {
        /// Which body.
        body: usize,
        /// The other one, if there is one.
        with: Option<usize>,
    },
    /// More is taken away from this body than there is of it.
    Hollow(usize),
    /// A body does not bridge what holds it.
    Unbridged {
        /// Which, and how far.
        gap: crate::scene::pose::Gap,
        /// Is that so at the start?
        at_start: bool,
    },
    /// The angle at the start that is told of a body is not the one that its joints give it.
    Tilted {
        /// Which body.
        body: usize,
        /// As the start gives it, degrees.
        given_deg: f64,
        /// As it follows from the joints.
        follows_deg: f64,
    },
    /// A joint does not hold where the others and the data put the bodies.
    Parted {
        /// Which joint.
        joint: usize,
        /// By how much, m.
        off_m: f64,
        /// Is that so at the start?
        at_start: bool,
    },
    /// The motion would have to pass what it does not pass.
    Beyond(crate::scene::pose::Obstacle),
    /// Just before an impact the bodies move as this joint, which holds them, does not allow.
    PartedBefore {
        /// Which joint.
        joint: usize,
        /// How fast it would part, m/s or rad/s.
        speed: f64,
        /// Which of these.
        degree: Degree,
    },
    /// The cord of this tie's spring is slack where a motion ends, and is drawn tight in the one that follows.
    SlackBetween(usize),
    /// The contact of this tie is said to slip, and other ties share the friction that it would need to roll.
    SlipShared(usize),
    /// With these data the ties leave another number of freedoms than they would if two data were not equal.
    EqualByChance {
        /// With other data.
        usual: usize,
        /// With these.
        now: usize,
    },
    /// A body is not where the motion before this one left it.
    Moved {
        /// Which body.
        body: usize,
        /// By how much, m.
        off_m: f64,
    },
    /// The start and the ties leave the velocity of this coordinate open.
    Open(Coordinate),
    /// The start gives this coordinate a velocity that the ties and the rest of the start do not allow.
    Contradiction {
        /// Whose velocity.
        of: Coordinate,
        /// As the start gives it, m/s or rad/s.
        given: f64,
        /// As it follows from the ties and the rest of the start.
        follows: f64,
    },
    /// At this joint nothing says, or goes on to say, which way kinetic friction points.
    Friction(usize, Lacks),
    /// The assembly cannot express this combination.
    Unsupported(Unsupported),
    /// An integral over the motion does not settle: its value, and how far halved panels are off it.
    Unsettled(Unsettled),
    /// The two roads disagree: the label, both values, the gap allowed.
    Disagree {
        /// Which quantity.
        label: Label,
        /// From the equations of motion.
        eom: f64,
        /// From work and energy.
        energy: f64,
        /// The relative gap that would have been accepted.
        allowed: f64,
    },
    /// The motion all but misses its end, or all but gets there: the last digits of the data decide it, and the roads differ.
    Barely,
    /// A named method did not get to its event.
    Trouble {
        /// Which method.
        method: Method,
        /// Why not.
        trouble: Trouble,
    },
    /// A named method, set finer, does not settle.
    Unsteady {
        /// Which method.
        method: Method,
        /// Which quantity.
        label: Label,
        /// As asked.
        value: f64,
        /// Set finer.
        finer: f64,
    },
    /// A named method, as fine as it gets, stays above the error that was asked for.
    Unmet {
        /// Which method.
        method: Method,
        /// How many points it took at last.
        points: usize,
        /// Its estimated error as a share of an answer.
        error: f64,
        /// The share that was asked for.
        asked: f64,
    },
    /// A named method and the closed form of the other road disagree beyond the error estimates of both.
    Contradicts {
        /// Which method.
        method: Method,
        /// Which quantity.
        label: Label,
        /// From the method.
        value: f64,
        /// From the other road.
        judge: f64,
        /// The difference that both estimates would have allowed.
        allowed: f64,
    },
    /// Data so far apart that products of them leave the doubles, in whatever units of mass, length and time.
    Apart,
    /// The method does not apply to the scene.
    NoMethod {
        /// Which method.
        method: Method,
    },
}

/// Velocities this many roundings of a sum apart still agree: nothing in 32 digits, a millionth in doubles, which are never
/// published and look at data that are changed a little, one at a time.
const LOOSE: f64 = (1u64 << 31) as f64;

/// Does a velocity that the start gives agree with the one that follows from the ties and the rest of the start? Printed
/// decimals agree up to the rounding of their doubles.
///
/// Errors: [`Refusal::Contradiction`].
pub fn consistent<T: Real>(of: Coordinate, given: T, follows: T) -> Result<(), Refusal> {
    // No enclosure has to prove it: if the decimals agree, the velocities hold as they stand.
    let near = || (given - follows).size() <= LOOSE * T::NOISE * given.size().max(follows.size());
    if ball::unwatched(|| given.apart(follows).is_zero() || near()) {
        Ok(())
    } else {
        Err(Refusal::Contradiction { of, given: given.f64(), follows: follows.f64() })
    }
}

/// What is known of the forces at an instant: nothing where that combination is not solved, and velocities alone are told of bodies that
/// start with some.
///
/// Errors: other refusals, and those of what has nothing else to tell.
pub fn or_motion<W>(scene: &Scene, forces: Result<Option<W>, Refusal>) -> Result<Option<W>, Refusal> {
    match forces {
        Err(Refusal::Unsupported(_) | Refusal::SlipShared(_)) if scene.goes_in_phases() => Ok(None),
        forces => forces,
    }
}

/// A force below this share of the largest is rounding.
const SLIGHT: f64 = 1e-12;

/// The senses of friction per normal force of each joint, which hang on the sides to which guides press that hold on both: those in
/// which points slide, turned about where a guide presses to its right. The one combination with which all `normal` forces, which may
/// be open, press to that side.
///
/// Errors: no combination fits, or several.
pub fn sides<T: Real>(
    scene: &Scene,
    slides: &[f64],
    mut normal: impl FnMut(&[f64], usize) -> Result<Option<T>, Refusal>,
) -> Result<SmallVec<[f64; 4]>, Refusal> {
    let on_both = |j: &usize| slides[*j] != 0.0 && matches!(scene.joints[*j].kind.rubs(), Some((_, true)));
    let guides: SmallVec<[usize; 4]> = (0..slides.len()).filter(on_both).collect();
    let mut found = None;
    for combination in 0..1_usize << guides.len() {
        let side = |i: usize| if combination >> i & 1 == 0 { 1.0 } else { -1.0 };
        let mut senses: SmallVec<[f64; 4]> = slides.into();
        guides.iter().enumerate().for_each(|(i, j)| senses[*j] *= side(i));
        let mut fits = true;
        for (i, j) in guides.iter().enumerate() {
            fits = fits && normal(&senses, *j)?.is_none_or(|force| force.signed(side(i)).sign() >= 0.0);
        }
        if fits && found.replace(senses).is_some() {
            return Err(Refusal::Friction(guides[0], Lacks::Side));
        }
    }
    let senses: SmallVec<[f64; 4]> =
        found.ok_or_else(|| Refusal::Friction(guides.first().copied().unwrap_or(0), Lacks::Side))?;
    // A normal force as a function of its own coefficient of friction is a constant over what is linear in it: where its sign changes
    // on the way from 0, it has gone through infinity, and what the equations give then does not happen.
    if !T::ENCLOSES {
        let mut pressed: SmallVec<[(usize, f64, f64); 4]> = SmallVec::new();
        for j in (0..senses.len()).filter(|j| senses[*j] != 0.0) {
            let mut smooth = senses.clone();
            smooth[j] = 0.0;
            if let (Some(with), Some(without)) = (normal(&senses, j)?, normal(&smooth, j)?) {
                pressed.push((j, with.f64(), without.f64()));
            }
        }
        let noise = SLIGHT * pressed.iter().map(|(_, with, _)| with.abs()).fold(0.0, f64::max);
        let turns = |(_, with, without): &&(usize, f64, f64)| {
            with.signum() != without.signum() && with.abs().min(without.abs()) > noise
        };
        if let Some((joint, ..)) = pressed.iter().find(turns) {
            return Err(Refusal::Friction(*joint, Lacks::Grip));
        }
    }
    Ok(senses)
}

/// Joints that leave several freedoms place no body on the way; else no way is known to place this one.
pub fn unplaced(scene: &Scene, body: usize) -> Refusal {
    if scene.is_still() && (scene.starts_from_rest() || scene.tells_speeds()) {
        return Refusal::Unplaced(body);
    }
    let free: usize = scene.bodies.iter().map(|b| if b.turns { 3 } else { 2 }).sum();
    let held: usize = scene.joints.iter().map(|j| j.kind.forces().len()).sum();
    // What hangs on a cord that comes from another body has to be placed.
    let hung = scene.joints.iter().find_map(|joint| {
        let JointKind::Cord { beyond: Some(_), .. } = joint.kind else { return None };
        let placed = |body: usize| scene.planar(body).is_some_and(|planar| planar.origin_m.is_some());
        joint.kind.spots().map(|spot| spot.body).find(|b| !scene.bodies[*b].turns && !placed(*b))
    });
    match free.saturating_sub(held) {
        0 | 1 => Refusal::Unplaced(hung.unwrap_or(body)),
        left => Refusal::Freedoms(left),
    }
}

/// The senses in which points slide, with those of points that only the friction of others sets off; `None` where it sets off none.
pub fn set_off(slides: &[f64], now: &[f64]) -> Option<SmallVec<[f64; 4]>> {
    let both = || slides.iter().zip(now);
    let more = both().any(|(before, now)| *before == 0.0 && *now != 0.0);
    more.then(|| both().map(|(before, now)| if *before == 0.0 { *now } else { *before }).collect())
}

/// Friction that would turn a sliding about holds everything at rest. Errors: it holds a point that another body carries, or a wheel,
/// which may roll, or one beside others that slide.
pub fn holds_still(scene: &Scene, slides: &[f64], now: &[f64]) -> Result<(), Refusal> {
    let carried = |joint: &Joint| {
        let wheel = matches!(joint.kind, JointKind::Contact { .. });
        joint.kind.mu_k().is_some() && (wheel || joint.kind.carrier().is_some())
    };
    let goes_on = slides.iter().zip(now).any(|(before, now)| before * now > 0.0);
    let held = |joint: &Joint| carried(joint) || joint.kind.mu_k().is_some() && goes_on;
    let turned = |joint: &usize| slides[*joint] * now[*joint] < 0.0;
    let mut held = (0..scene.joints.len()).filter(|joint| held(&scene.joints[*joint]));
    // The one whose sliding turned about, if it is among them.
    let first = held.clone().find(turned).or_else(|| held.next());
    first.map_or(Ok(()), |joint| Err(Refusal::Friction(joint, Lacks::Sliding)))
}

/// Friction has a sense only where a point slides. Errors: one that rubs is at rest in its guide.
pub fn all_slide(scene: &Scene, slides: &[f64]) -> Result<(), Refusal> {
    let stuck = |(joint, sense): (&Joint, &f64)| joint.kind.mu_k().is_some() && *sense == 0.0;
    let stuck = scene.joints.iter().zip(slides).position(stuck);
    stuck.map_or(Ok(()), |joint| Err(Refusal::Friction(joint, Lacks::Sliding)))
}

impl From<Singular> for Refusal {
    fn from(Singular { unknowns, rank }: Singular) -> Self {
        Self::Singular { unknowns, rank }
    }
}

impl From<Unsettled> for Refusal {
    fn from(unsettled: Unsettled) -> Self {
        Self::Unsettled(unsettled)
    }
}

/// Combinations that are not solved (yet).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unsupported {
    /// What a bank is not read with: on the way, a spring where something slips or several coordinates are free; the start of rolling of
    /// what is not thrown with slip; more of a body of particles than an instant; joined bodies beside others, with ties, or with an end
    /// that belongs to a line.
    Unread,
    /// Bodies that slide and could stay, one on account of what another does.
    SlidesInTurn,
}

/// What kinetic friction lacks at a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lacks {
    /// Nothing slides there at the start, or friction would hold it.
    Sliding,
    /// It fits no side of a guide that holds on both, or both.
    Side,
    /// It turns about on the way, or the guide presses to its other side.
    Lasting,
    /// It is so strong that what presses there without friction would not press with it, or the other way round: it jams, or comes off.
    Grip,
}

/// What one road says of one quantity.
#[derive(Debug, Clone, Copy)]
pub struct Said<T> {
    /// Which quantity, of what.
    pub label: Label,
    /// Its value, SI.
    pub value: T,
    /// Sum of the magnitudes of the terms that make it up, SI.
    pub scale: f64,
}

impl<T: Real> Said<T> {
    /// What a road says of a label by a value and the sum of its terms in the units of the solver: both in SI again.
    pub fn of(n: &Numbers<T>, label: Label, value: T, scale: f64) -> Self {
        let scale = scale * pow2(n.exponent(label.quantity));
        Self { label, value: n.publish(label.quantity, value), scale }
    }
}

/// Where the motion goes, on one road.
#[derive(Debug, Clone, Copy)]
pub struct Course<P> {
    /// Sense in which the ending coordinate moves: 1 forward, -1 back, 0 not at all.
    pub sense: f64,
    /// Sense in which the centre of the ending body moves: where its turn is counted, it may spin the other way.
    pub way: f64,
    /// Driving and resisting force at the start, along the ending coordinate, both >= 0 (only their ratio means anything).
    pub drive: (P, P),
    /// Is the ending event reached before the turning point?
    pub reached: bool,
    /// Asked distance of the ending coordinate (or time or speed, by the event); `None` if it has none. This and what follows is
    /// told by the road that has the reactions as unknowns.
    pub asked: Option<P>,
    /// Where the motion starts in the same measure: no distance, no time, a speed.
    pub begins: P,
    /// Farthest that the motion goes in the same measure; infinite if it never turns.
    pub farthest: P,
    /// The least kinetic energy at which it passes something that slows it down, as a share of the greatest before; 1 if nothing does.
    pub slowest: f64,
}

/// A contact or cord as far as the scene looks, on one road.
#[derive(Debug, Clone, Copy)]
pub enum Held<P> {
    /// A body on a surface: index, normal force N.
    Pressed(usize, f64),
    /// A rolling contact, or one that has stopped sliding: index of the tie, the largest |F|, N, and `mu_s N`.
    Rolling(usize, P, Option<P>),
    /// A slipping contact: index of the tie, friction if it rolled, `mu_s N`, slip acceleration against friction, sense
    /// in which the centre sets off.
    Slipping(usize, P, P, P, f64),
    /// A cord between bodies: index of the tie, least tension N, and its share of the other forces that make it up.
    Cord(usize, f64, f64),
    /// The cord of a spring that goes slack on the way: index of the tie, way to the end, way to where it goes slack.
    Slack(usize, P, P),
    /// A rolling contact or a cord whose force the ties share in a way that statics leaves open: index of the tie.
    Open(usize),
    /// The contact of a body that is thrown with slip.
    Thrown(Throw),
    /// A guide that can only push: index of the joint, least normal force on the way and the greatest magnitude, N; minus infinity of
    /// one that shares with others a load that they cannot carry.
    Touching(usize, f64, f64),
    /// The same at a blow: its impulse and the sum of those that strike, N s.
    Jolted(usize, f64, f64),
    /// A spring that only pushes or pulls: index of the strut, way up to which it does not act, infinite if it never does, and way to
    /// the end, rad.
    Met(usize, f64, f64),
}

/// What becomes of the slip of a thrown body, on one road. The senses are decided by that road in its own arithmetic; the
/// numbers are for words and margins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throw {
    /// Index of the tie.
    pub tie: usize,
    /// Is it known what becomes of the slip? What is told of rolling holds only then.
    pub known: bool,
    /// Does it slip at the start?
    pub slips: bool,
    /// Does kinetic friction end the slip?
    pub closes: bool,
    /// Can static friction hold it rolling?
    pub holds: bool,
    /// Is it to roll by the end that is asked?
    pub to_roll: bool,
    /// Time of the end, s, where a time is asked, and time at which the slip ends, infinite if it does not.
    pub times: Option<(f64, f64)>,
    /// Speed at the end, m/s, and the sum of the magnitudes of the speeds that make it up, where the end is reached.
    pub at_end: Option<(f64, f64)>,
    /// Slip speed at the start, m/s, >= 0.
    pub slip: f64,
    /// Sum of the magnitudes of the speeds that make it up, m/s.
    pub speeds: f64,
    /// Force that keeps the slip up, N: what friction has to overcome; negative where it helps.
    pub upkeep: f64,
    /// `mu_k N`, N.
    pub kinetic: f64,
    /// Magnitude of the friction that rolling needs, N.
    pub needed: f64,
    /// `mu_s N`, N.
    pub available: f64,
}

/// A set of data, where a scene is solved with several.
pub type Set = Vec<f64>;

/// What is asked of a road; beside it, a road always says where the motion goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Scope {
    /// The quantities.
    pub quantities: Quantities,
    /// Contacts and cords over the motion, for judging whether the ties hold?
    pub held: bool,
    /// Is it taken for granted that it sets off and gets to its end, where an enclosure leaves that open? What is told is then true if
    /// it does.
    pub granted: bool,
}

impl Scope {
    /// All that it can say.
    pub const ALL: Self = Self { quantities: Quantities::ALL, held: true, granted: false };
    /// These quantities alone.
    pub fn only(quantities: impl IntoIterator<Item = Quantity>) -> Self {
        Self { quantities: quantities.into_iter().collect(), held: false, granted: false }
    }
    /// All but the time: of joined bodies it is a quadrature of its own, and no other answer hangs on it.
    pub const TIMELESS: Self = Self { quantities: Quantities::ALL.without(Quantity::T), ..Self::ALL };
    /// The same, taking for granted that it sets off and gets there.
    pub const fn granting(self) -> Self {
        Self { granted: true, ..self }
    }
    /// What is asked by either.
    pub const fn with(self, other: Self) -> Self {
        Self {
            quantities: self.quantities.with(other.quantities),
            held: self.held || other.held,
            granted: self.granted || other.granted,
        }
    }
    /// Is one of these quantities asked?
    pub fn any(self, quantities: &[Quantity]) -> bool {
        quantities.iter().any(|q| self.quantities.has(*q))
    }
}

/// Senses of the ending coordinate and of the centre of its body, and whether the end is reached; `None` where only an instant is asked.
pub type Kind = Option<([f64; 2], bool)>;

/// What one road says of a scene: everything, or what it was asked for.
#[derive(Debug, Clone)]
pub struct Road<T: Real> {
    /// Its quantities.
    pub said: Vec<Said<T>>,
    /// Reactions, and what hangs on them, that the ties leave open.
    pub open: Vec<Label>,
    /// Where the motion goes; `None` where only an instant is asked.
    pub course: Option<Course<T>>,
    /// Contacts and cords over the motion, from the road that has the reactions as unknowns; the other leaves it empty.
    pub held: Vec<Held<T>>,
    /// Velocities of coordinates at the end, positive forward, where another motion may follow.
    pub velocities: Vec<(Coordinate, T)>,
    /// The road of the motion that follows.
    pub next: Option<Box<Self>>,
}

impl<P: Real> Course<P> {
    /// Nothing moves.
    pub fn at_rest() -> Self {
        let zero = P::zero();
        let (drive, begins, farthest) = ((zero, zero), zero, zero);
        Self { sense: 0.0, way: 0.0, drive, reached: false, asked: None, begins, farthest, slowest: 1.0 }
    }
    /// It moves in this sense.
    pub fn moving(sense: f64, reached: bool) -> Self {
        Self { sense, way: sense, reached, farthest: P::of(f64::INFINITY), ..Self::at_rest() }
    }
    /// It does not get where it is asked.
    pub fn nowhere() -> Self {
        Self { sense: 1.0, ..Self::at_rest() }
    }
    /// Its senses, and whether its end is reached.
    pub const fn kind(&self) -> ([f64; 2], bool) {
        ([self.sense, self.way], self.reached)
    }
    /// Does its end lie where it starts?
    pub fn ends_where_it_starts(&self) -> bool {
        self.asked.is_some_and(|asked| asked.apart(self.begins).is_zero())
    }
}

impl<T: Real> Road<T> {
    /// Nothing said yet of what is asked.
    pub fn new(asked: Scope) -> Self {
        let said = Vec::with_capacity(asked.quantities.count().min(24));
        let held = Vec::with_capacity(if asked.held { 4 } else { 0 });
        Self { said, open: Vec::new(), course: None, held, velocities: Vec::new(), next: None }
    }
    /// Notes that these quantities hang on a reaction that the ties share in a way that statics leaves open.
    pub fn leaves_open(&mut self, of: Owner, quantities: &[Quantity]) {
        self.open.extend(quantities.iter().map(|quantity| Label { quantity: *quantity, of }));
    }
    /// The road without what is not told of the scene.
    pub fn telling(mut self, scene: &Scene) -> Self {
        self.said.retain(|said| scene.tells(said.label));
        self
    }
    /// What the road says of a label.
    pub fn get(&self, label: Label) -> Option<&Said<T>> {
        self.said.iter().find(|s| s.label == label)
    }
    /// The same, probably said at this place: roads mostly speak in the same order.
    pub fn said_at(&self, at: usize, label: Label) -> Option<&Said<T>> {
        self.said.get(at).filter(|s| s.label == label).or_else(|| self.get(label))
    }
    /// Which kind of motion it is.
    pub fn kind(&self) -> Kind {
        self.course.as_ref().map(Course::kind)
    }
    /// The road with what is asked by formulas; `other` is the same road of another scene, with what that takes over from this one.
    /// What has no value is not said.
    ///
    /// # Errors
    /// Those of the motion that follows, among them that it would begin with other speeds than this one ends with.
    pub fn answering(mut self, scene: &Scene, data: &[f64], other: Other<T>) -> Result<Self, Refusal> {
        if scene.formulas.asked.is_empty() {
            return Ok(self);
        }
        let mut others: Vec<Option<Self>> = Vec::with_capacity(scene.formulas.others.len());
        for (how, asked) in &scene.formulas.others {
            others.push(match how {
                AsIf::Next => self.followed(scene, asked, data, other)?,
                AsIf::Rolls | AsIf::Smooth => other(asked, data, &[]).ok(),
            });
        }
        for (i, asked) in scene.formulas.asked.iter().enumerate() {
            // A formula takes a quantity as it is asked by itself: only its size where that alone counts.
            let said = |road: Option<&Self>, term: Term| {
                let (of, label) = scene.quantity_of(term)?;
                let said = road?.get(label)?;
                Some((if of.is_magnitude(label) { said.value.abs() } else { said.value }, said.scale))
            };
            let nothing = (T::of(f64::NAN), 0.0);
            let (value, scale) = asked.formula.weighed(&|term: Term| match term {
                Term::Given(given) => {
                    let value: T = given.value(data);
                    (value, value.size())
                }
                Term::Said(_) => said(Some(&self), term).unwrap_or(nothing),
                Term::Other(at, _) => said(others.get(at).and_then(Option::as_ref), term).unwrap_or(nothing),
            });
            if value.is_finite() && scale.is_finite() {
                let label = Label { quantity: asked.quantity, of: Owner::Asked(i) };
                self.said.push(Said { label, value: value.cleared(scale), scale });
            }
        }
        let next = scene.formulas.others.iter().position(|(how, _)| *how == AsIf::Next);
        self.next = next.and_then(|at| others.swap_remove(at)).map(Box::new);
        Ok(self)
    }

    /// The road of the motion that begins where this one ends, if it gets there.
    fn followed(
        &self,
        first: &Scene,
        next: &Scene,
        data: &[f64],
        other: Other<T>,
    ) -> Result<Option<Self>, Refusal> {
        let sense = self.course.as_ref().map_or(0.0, |c| c.sense);
        // Bodies on lines and axles have each a sense of their own.
        let directed = |label: Label| {
            let own = self.velocities.iter().find(|(c, _)| c.speed() == label);
            own.map_or(sense, |(_, velocity)| velocity.sign())
        };
        let value = |t: &Taken| {
            let said = self.get(t.label)?.value;
            said.is_finite().then(|| if t.directed { said.signed(directed(t.label)) } else { said })
        };
        let taken: Option<Vec<T>> = next.formulas.taken.iter().map(value).collect();
        let Some(taken) = taken.filter(|_| self.course.as_ref().is_none_or(|c| c.reached)) else {
            return Ok(None);
        };
        let all: Vec<f64> = data.iter().copied().chain(taken.iter().map(|x| x.f64())).collect();
        let faults = admissible::faults(next, &all);
        if !faults.is_empty() {
            return Err(Refusal::NextInadmissible(faults));
        }
        let numbers = (Numbers::<T>::new(first, data), Numbers::after(next, &all, &taken));
        if let Some((body, off_m)) = pose::moved((first, &numbers.0), (next, &numbers.1)) {
            return Err(Refusal::Moved { body, off_m });
        }
        // It begins as fast as this one ends: other ties must not ask for a jerk.
        let begin = other(&Scene { end: End::AtOnce, ..next.clone() }, &all, &taken)?;
        let lined = self.velocities.iter().map(|(of, end)| {
            let start = begin.velocities.iter().find(|(c, _)| c == of)?;
            Some((*of, *end, start.1))
        });
        let placed = begin.said.iter().filter(|_| self.velocities.is_empty()).map(|said| {
            let degree = match said.label.quantity {
                Quantity::V => Degree::Along,
                Quantity::Omega => Degree::Turn,
                _ => return None,
            };
            let (Owner::Body(body), Some(end)) = (said.label.of, self.get(said.label)) else { return None };
            // What does not move while others do has a speed by rounding alone.
            let others = begin.said.iter().filter(|s| s.label.quantity == said.label.quantity);
            let most = others.fold(0.0, |most, s| f64::max(most, s.value.size()));
            let moves = end.value.size().max(said.value.size()) > LOOSE * T::NOISE * most;
            moves.then_some((Coordinate { body, degree }, end.value, said.value))
        });
        for (of, end, start) in lined.chain(placed).flatten() {
            consistent(of, end, start)?;
        }
        let road = other(next, &all, &taken)?;
        // How far a cord is slack is not known to the motion that follows.
        for SpringTie { tie, .. } in next.springs().filter(|s| !s.rigid) {
            let pulls = road.get(Label { quantity: Quantity::Tension, of: Owner::Tie(tie) });
            let slack = |(t, ended): (&Taken, &T)| t.label.quantity == Quantity::Tension && ended.is_zero();
            if next.formulas.taken.iter().zip(&taken).any(slack)
                && !(road.course.as_ref().is_some_and(|c| c.reached)
                    && pulls.is_none_or(|said| said.value.is_zero()))
            {
                return Err(Refusal::SlackBetween(tie));
            }
        }
        Ok(Some(road))
    }
}

/// What a road says with one of several sets of data: by itself, or in doubles in one lane of a road for several.
#[derive(Debug, Clone)]
pub enum Told<T: Real = Fast> {
    /// By itself.
    Alone(Road<T>),
    /// In this lane.
    #[cfg(feature = "program")]
    Lane(Rc<Road<Lanes>>, usize),
}

impl<T: Real> Told<T> {
    /// The value of a label, probably said at this place.
    pub fn value(&self, at: usize, label: Label) -> Option<T> {
        match self {
            Self::Alone(road) => road.said_at(at, label).map(|said| said.value),
            #[cfg(feature = "program")]
            Self::Lane(road, lane) => road.said_at(at, label).map(|said| T::of(said.value.lane(*lane))),
        }
    }
    /// Which kind of motion it is.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Alone(road) => road.kind(),
            #[cfg(feature = "program")]
            Self::Lane(road, _) => road.kind(),
        }
    }
}

/// One road of another scene, and what that takes over from the one before it.
pub type Other<'o, T> = &'o dyn Fn(&Scene, &[f64], &[T]) -> Result<Road<T>, Refusal>;
