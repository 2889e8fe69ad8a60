//! Runs both roads and compares; the only file beside the ladder that sees both.
use crate::num::{Ball, Dd, Fast, NOISE, Real, U, ball, dd};
use crate::scene::admissible::Rule;
use crate::scene::pose::{Gap, Obstacle};
use crate::scene::{AsIf, End, Far, Label, Num, Owner, Quantity, Scales, Scene, Start, Tie, admissible};
use crate::solve::condition::vanishes;
use crate::solve::outcome::{
    Check, CheckKind, Entry, Kind, Refusal, Road, Said, Scope, Set, Solved, Told, Unsupported,
};
use crate::solve::{condition, energy, eom, physical};
use std::f64::consts::{PI, TAU};

/// Each road may be off by `8 u max(1, cond)`.
pub const EACH_ROAD: f64 = 8.0;

/// However ill-conditioned an answer is, the roads compute it from the same data in 32 digits and must share two of its own.
const NO_DIGITS: f64 = 1e-2;

/// Share of an answer within which a narrow enclosure lies, far above what the data leave open of a common answer.
const NARROW: f64 = 1e-9;

/// Places of the range of a datum that is found at which it is tried whether there is something to measure.
const PLACES: u32 = 16;

/// Products of ten numbers up to this magnitude, or of their inverses, do not reach the ends of the doubles.
const ORDINARY: f64 = (1u128 << 100) as f64;

/// What the equations of motion alone say: nothing of it may be published before [`Half::confirm`].
#[derive(Debug, Clone)]
pub struct Half {
    asked: Scope,
    solved: Solved,
    /// The same in the units in which it is computed, where these are not those of SI.
    own: Option<Solved>,
    /// Sense of the motion, and whether its end is reached.
    course: Kind,
    /// The same of the motion that follows.
    next: Kind,
}

/// Solves a scene by both roads and publishes only what agrees.
///
/// `data` are the SI values (angles in degrees) that [`crate::scene::Num::Datum`] indexes. Each answer carries both
/// values and its condition number. Errors: data that are no scene, a combination that the assembly does not have,
/// equations that do not determine the motion, two roads that differ by more than `16 u max(1, cond)`.
pub fn solve(scene: &Scene, data: &[f64]) -> Result<Solved, Refusal> {
    let mut half = first(scene, data, Scope::ALL)?;
    half.weigh(scene, data, |_| true);
    half.confirm(scene, data)
}

/// The same without condition numbers, save where only one tells whether the roads agree. Errors: those of [`solve`].
pub fn answers(scene: &Scene, data: &[f64]) -> Result<Solved, Refusal> {
    first(scene, data, Scope::ALL)?.confirm(scene, data)
}

/// What the first road alone says of what is asked, so that a draw that breaks a rule is refused at a part of the cost. Errors:
/// as for [`solve`], save that nothing is compared yet.
pub fn first(scene: &Scene, data: &[f64], asked: Scope) -> Result<Half, Refusal> {
    first_in::<Dd>(scene, data, asked, fitting)
}

/// The same in doubles: enough to refuse a draw that breaks a rule clearly. `None` where they may not do, or nothing is said.
pub fn roughly(scene: &Scene, data: &[f64], asked: Scope) -> Option<Half> {
    first_in::<Fast>(scene, data, asked, |_, _| None).ok()
}

/// The first road alone, in doubles, for a scene like one that both roads have solved before: an answer is judged alike by it, and
/// the program and the page that checks itself come to the same bits. Errors: as for [`first`].
pub fn again(scene: &Scene, data: &[f64]) -> Result<Half, Refusal> {
    first_in::<Fast>(scene, data, Scope::ALL, |scene, data| {
        Scales::tried(scene, data).find(|scales| scales.of(scene, data).is_some())
    })
}

fn first_in<T: Real>(
    scene: &Scene,
    data: &[f64],
    asked: Scope,
    fitting: impl FnOnce(&Scene, &[f64]) -> Option<Scales>,
) -> Result<Half, Refusal> {
    let faults = admissible::faults(scene, data);
    if !faults.is_empty() {
        return Err(Refusal::Inadmissible(faults));
    }
    supported(scene, data)?;
    for (_, other) in &scene.formulas.others {
        supported(other, data)?;
    }
    if ordinary(scene, data) {
        return alone::<T>(scene, data, asked);
    }
    let scales = fitting(scene, data).ok_or(Refusal::Apart)?;
    let si = |refusal| match refusal {
        Refusal::Parted { joint, off_m, at_start } => {
            Refusal::Parted { joint, off_m: scales.si("m", off_m), at_start }
        }
        Refusal::Unbridged { gap, at_start } => {
            let [apart_m, bridged_m] = [gap.apart_m, gap.bridged_m].map(|x| scales.si("m", x));
            Refusal::Unbridged { gap: Gap { apart_m, bridged_m, ..gap }, at_start }
        }
        other => other,
    };
    let mut half =
        in_scales(scales, scene, data, |scene, data| alone::<T>(scene, data, asked)).map_err(si)?;
    half.solved.scales = scales;
    half.tell(scene);
    Ok(half)
}

/// What the first road says of what is asked, in the units of the data.
fn alone<T: Real>(scene: &Scene, data: &[f64], asked: Scope) -> Result<Half, Refusal> {
    let road: Road<T> = eom::road_of(scene, data, asked)?;
    let mut entries = Vec::with_capacity(road.said.len());
    for said in &road.said {
        // A zero has no sign.
        let gone = vanishes(said.value.f64(), T::NOISE, said.scale);
        let value = if gone { 0.0 } else { said.value.f64() + 0.0 };
        let (label, scale) = (said.label, said.scale);
        entries.push(Entry { label, eom: Some(value), energy: None, bound: None, cond: f64::NAN, scale });
    }
    let (regime, mut checks, words) = physical::judge_road(scene, &road);
    // A force that was measured to be 0 is at its limit, and meant to be: no margin keeps it from there.
    let nothing = |label: Label| entries.iter().any(|e| e.label == label && e.value() == 0.0);
    if let Some(found) =
        scene.formulas.found.filter(|f| f.label.quantity == Quantity::Normal && nothing(f.label))
    {
        let of = |c: &Check| if scene.joints.is_empty() { Owner::Body(c.of) } else { Owner::Joint(c.of) };
        let presses = |c: &&mut Check| {
            matches!(c.kind, CheckKind::Pressed | CheckKind::Taut) && of(c) == found.label.of
        };
        for check in checks.iter_mut().filter(presses) {
            *check = Check { ok: true, available: 0.0, margin: f64::INFINITY, ..*check };
        }
    }
    let next = scene.formulas.others.iter().find(|(how, _)| *how == AsIf::Next);
    if let (Some((_, scene)), Some(next)) = (next, &road.next) {
        checks.push(physical::judge_next(scene, next));
    }
    let (course, next) = (road.kind(), road.next.as_deref().and_then(Road::kind));
    let (open, beyond, scales) = (road.open, Vec::new(), Scales::SI);
    let solved = Solved { regime, checks, entries, words, open, beyond, scales };
    Ok(Half { asked, solved, own: None, course, next })
}

/// Units in which the scene can be computed, if there are any: neither road leaves the range of double-doubles, or what vanishes
/// there does no harm, for the roads agree and the enclosures of all answers are narrow all the same.
fn fitting(scene: &Scene, data: &[f64]) -> Option<Scales> {
    let fit = |scales: &Scales| {
        let Some((scene, data)) = scales.of(scene, data) else { return false };
        let both = || (eom::road::<Dd>(&scene, &data), energy::road::<Dd>(&scene, &data));
        let agreed = || alone::<Dd>(&scene, &data, Scope::ALL)?.confirm(&scene, &data);
        !dd::watch(both).1 || agreed().is_ok_and(|solved| is_narrow(&scene, &data, &solved))
    };
    Scales::tried(scene, data).find(fit)
}

/// Does the second road enclose all its answers narrowly, without a decision that the enclosures leave open? An answer that is 0 has
/// no size of its own: its enclosure is narrow beside the terms that cancel.
fn is_narrow(scene: &Scene, data: &[f64], solved: &Solved) -> bool {
    let (road, doubt) = ball::watch(|| energy::road::<Ball>(scene, data));
    let narrow = |said: &Said<Ball>| {
        // The time of a swing is summed, and a sum proves nothing.
        let summed = said.label.quantity == Quantity::T && scene.pinned().is_some();
        let terms = solved.get(said.label).filter(|e| e.value() == 0.0).map(|e| e.scale);
        let (radius, size) = (said.value.radius(), terms.unwrap_or(said.value.size()));
        // What is endless is exactly so.
        summed || radius == 0.0 || size.is_finite() && radius <= NARROW * size
    };
    !doubt && road.is_ok_and(|road| road.said.iter().all(narrow))
}

/// Solves with the scene and its data in these units. Errors: data that leave the doubles there.
pub fn in_scales<R>(
    scales: Scales,
    scene: &Scene,
    data: &[f64],
    solve: impl FnOnce(&Scene, &[f64]) -> Result<R, Refusal>,
) -> Result<R, Refusal> {
    if scales == Scales::SI {
        return solve(scene, data);
    }
    let (scene, data) = scales.of(scene, data).ok_or(Refusal::Apart)?;
    solve(&scene, &data)
}

/// A scene that is solved again and again on the first road in doubles, for what is never published: where wrong methods would
/// come to. What the right scene shares with it was admissible there and is not looked at again.
#[derive(Debug)]
pub struct Quick<'s> {
    scene: &'s Scene,
    /// Rules that the other data or the other scene may break.
    rules: Vec<(Num, Rule)>,
    /// Is the combination one that the assembly has? `None` where that hangs on the data.
    supported: Option<bool>,
}

/// Is it cheaper to solve the scene with several sets of data at once?
pub fn side_by_side(scene: &Scene) -> bool {
    eom::side_by_side(scene)
}

impl<'s> Quick<'s> {
    /// Prepares `scene`, which stands for `right` with other values of these data.
    pub fn new(scene: &'s Scene, right: &Scene, changed: &[usize]) -> Self {
        // A formula may be another one in another scene.
        let other = |n: Num| match n {
            Num::Datum(i) => changed.contains(&i),
            Num::Derived(_) => true,
            Num::Fixed(_) => false,
        };
        let mut kept = Vec::new();
        admissible::rules(right, &mut |number, rule| {
            let touched = match rule {
                // The length of a spring hangs on several data.
                Rule::Stretch => true,
                _ => other(number) || rule.bound().is_some_and(other),
            };
            if !touched {
                kept.push((number, rule));
            }
        });
        let mut rules = Vec::new();
        admissible::rules(scene, &mut |number, rule| {
            if !kept.contains(&(number, rule)) {
                rules.extend([(number, rule), (number, Rule::Range)]);
            }
        });
        let supported = (!scene.ties.iter().any(is_held)).then(|| supported(scene, &[]).is_ok());
        Self { scene, rules, supported }
    }

    /// Does a pinned body swing in it?
    pub fn is_pinned(&self) -> bool {
        self.scene.pinned().is_some()
    }

    /// Are these data such a scene?
    pub fn admits(&self, data: &[f64]) -> bool {
        self.rules.iter().all(|(n, rule)| admissible::holds(self.scene, data, *n, *rule))
            && self.supported.unwrap_or_else(|| supported(self.scene, data).is_ok())
    }

    /// What the equations of motion say of what is asked with each of these sets of data; `None` where there is no motion.
    pub fn roads(&self, sets: &[Set], asked: Scope) -> Vec<Option<Told>> {
        eom::roads(self.scene, sets, asked)
    }
}

impl Half {
    /// The first road's values, regime and checks; the margin of [`crate::solve::outcome::CheckKind::Moves`] is not known yet,
    /// nor are the condition numbers before [`Half::weigh`].
    pub fn preview(&self) -> &Solved {
        &self.solved
    }

    /// The solution in the units in which it is computed.
    fn own(&mut self) -> &mut Solved {
        self.own.as_mut().unwrap_or(&mut self.solved)
    }

    /// Tells in SI what was solved in other units; what no double holds there is not told.
    fn tell(&mut self, scene: &Scene) {
        let scales = self.solved.scales;
        if scales == Scales::SI {
            return;
        }
        let own = self.own.get_or_insert_with(|| self.solved.clone());
        self.solved = own.clone();
        let Solved { checks, entries, beyond, .. } = &mut self.solved;
        for check in checks {
            let unit = check.kind.unit(scene);
            check.required = scales.si(unit, check.required);
            check.available = scales.si(unit, check.available);
        }
        entries.retain_mut(|entry| {
            let si = |x: f64| scales.said(scene, entry.label, x);
            let kept = |x: f64| x == 0.0 || !x.is_finite() || si(x).is_normal();
            let holds = kept(entry.value()) && entry.energy.is_none_or(kept);
            if !holds {
                beyond.push(entry.label);
            }
            (entry.eom, entry.energy) = (entry.eom.map(si), entry.energy.map(si));
            entry.scale = si(entry.scale);
            holds
        });
    }

    /// Computes condition numbers, those of these quantities, at the cost of a few roads in doubles for each datum.
    pub fn weigh(&mut self, scene: &Scene, data: &[f64], of: impl Fn(Label) -> bool) {
        let (course, scales) = (self.course, self.solved.scales);
        let weighed: Vec<Entry> = self.own().entries.iter().filter(|e| of(e.label)).copied().collect();
        let conds = in_scales(scales, scene, data, |scene, data| {
            Ok(condition::numbers(scene, data, course, &weighed))
        });
        let asked = self.own().entries.iter_mut().filter(|e| of(e.label));
        for (entry, cond) in asked.zip(conds.into_iter().flatten()) {
            entry.cond = cond;
        }
        self.tell(scene);
    }

    /// Runs the second road, as far as the first one went, and publishes what agrees. Errors: a disagreement, or a quantity that only
    /// one road reaches.
    pub fn confirm(mut self, scene: &Scene, data: &[f64]) -> Result<Solved, Refusal> {
        let (asked, course, next, scales) = (self.asked, self.course, self.next, self.solved.scales);
        let own = self.own();
        let compared =
            in_scales(scales, scene, data, |scene, data| compared(scene, data, asked, (own, course, next)));
        compared.map_err(|refusal| match refusal {
            Refusal::Disagree { label, eom, energy, allowed } => {
                let si = |x| scales.said(scene, label, x);
                Refusal::Disagree { label, eom: si(eom), energy: si(energy), allowed }
            }
            other => other,
        })?;
        self.tell(scene);
        Ok(self.solved)
    }
}

/// Runs the second road and compares what it says with what the first one said.
fn compared(
    scene: &Scene,
    data: &[f64],
    asked: Scope,
    (solved, course, next): (&mut Solved, Kind, Kind),
) -> Result<(), Refusal> {
    let second: Road<Dd> = energy::road_of(scene, data, asked)?;
    // Where one road gets to the end and the other does not, the one tells what the other does not.
    if let (Some(one), Some(other)) = (course, second.kind())
        && one == (other.0, !other.1)
    {
        return Err(Refusal::Barely);
    }
    for (i, entry) in solved.entries.iter_mut().enumerate() {
        let said = second.said_at(i, entry.label);
        let (mut eom, mut energy) = (entry.value(), said.map_or(f64::NAN, |s| s.value.f64() + 0.0));
        // What is 0 on the one road is 0 on the other up to what the rounding of the printed data leaves of its terms. Of joined
        // bodies that rounding stands in every pose, on both roads, and in what is found from a measurement.
        let nothing = |share: f64| [eom, energy].map(|x| vanishes(x, share, entry.scale));
        let joined = scene.lead().is_some() && scene.pinned().is_none();
        let rounded = joined || scene.formulas.found.is_some();
        if (rounded || nothing(NOISE).contains(&true)) && nothing(8.0 * U) == [true; 2] {
            (eom, energy) = (0.0, 0.0);
            entry.eom = Some(eom);
        }
        // Half a turn to either side is one direction.
        if entry.label.quantity == Quantity::PinAngle && (eom - energy).abs() > PI {
            energy += TAU.copysign(eom);
        }
        entry.energy = Some(energy);
        if entry.cond.is_nan() && !agree(eom, energy, 1.0) {
            entry.cond = condition::numbers(scene, data, course, std::slice::from_ref(entry))[0];
        }
        // Numbers written into the scene are no data: of what no datum moves the terms tell how sensitive it is.
        let cond = if entry.cond == 0.0 { entry.scale / eom.abs() } else { entry.cond };
        if !agree(eom, energy, cond) {
            let allowed = 2.0 * EACH_ROAD * U * cond.max(1.0);
            return Err(Refusal::Disagree { label: entry.label, eom, energy, allowed });
        }
    }
    let apart = |label: Label, energy: f64| {
        let (eom, allowed) = (f64::NAN, 2.0 * EACH_ROAD * U);
        Refusal::Disagree { label, eom, energy, allowed }
    };
    // What only the second road says is a disagreement too: both must reach the same quantities.
    let known = |label: Label, i: usize| {
        solved.entries.get(i).is_some_and(|e| e.label == label) || solved.get(label).is_some()
    };
    if let Some((_, said)) = second.said.iter().enumerate().find(|(i, s)| !known(s.label, *i)) {
        return Err(apart(said.label, said.value.f64()));
    }
    // What ties leave open is the same on both roads.
    let open = |one: &[Label], other: &[Label]| one.iter().find(|l| !other.contains(l)).copied();
    if let Some(label) = open(&solved.open, &second.open).or(open(&second.open, &solved.open)) {
        return Err(apart(label, f64::NAN));
    }
    // Which way it goes and whether it arrives are answers too.
    let alike = |one: ([f64; 2], bool), other: ([f64; 2], bool)| {
        let of = Owner::Body(scene.ending_coordinate().body);
        let label = Label { quantity: Quantity::Direction, of };
        let way = |(senses, _): ([f64; 2], bool)| senses[1];
        let differ = Refusal::Disagree { label, eom: way(one), energy: way(other), allowed: 0.0 };
        if one == other { Ok(()) } else { Err(differ) }
    };
    if let (Some(next), Some(other)) = (next, second.next.and_then(|road| road.course)) {
        alike(next, other.kind())?;
    }
    if let (Some(course), Some(other)) = (course, second.course) {
        alike(course, other.kind())?;
        // The drive is a sum of powers: only the second road has it, and only for margins.
        let Solved { regime, checks, words, .. } = solved;
        physical::fill_drive(scene, other.sense, other.drive, (regime, checks, words));
    }
    Ok(())
}

/// Encloses the answers: work and energy once more, with numbers that keep account of their errors ([`Ball`]), those of
/// the printed data among them. Fills in [`Entry::bound`] and says whether that succeeded: it does not where rounding of
/// the data leaves open which way the scene goes, such as at an exact balance.
pub fn prove(scene: &Scene, data: &[f64], solved: &mut Solved) -> bool {
    let scales = solved.scales;
    let (road, doubt) = ball::watch(|| in_scales(scales, scene, data, energy::road::<Ball>));
    let Ok(road) = road else { return false };
    if doubt {
        return false;
    }
    for (i, entry) in solved.entries.iter_mut().enumerate() {
        let said = road.said_at(i, entry.label);
        let value = scales.own_said(scene, entry.label, entry.value());
        let bound = said.map(|s| scales.said(scene, entry.label, s.value.about(value)));
        entry.bound = bound.filter(|b| b.is_finite());
        // Zero on both roads and within the enclosure, and no datum moves it: zero by structure, whatever rounding left of it.
        let zero = [entry.eom, entry.energy].iter().all(|v| v.is_some_and(|v| v == 0.0)) && entry.cond == 0.0;
        if zero && said.is_some_and(|s| s.value.value().hi.abs() <= s.value.radius()) {
            entry.bound = Some(0.0);
        }
    }
    true
}

/// Why it is not proved that the datum that is found is the only one: with some values of its range nothing is measured, or it may be
/// another that gives the measurement.
pub fn not_unique(scene: &Scene, data: &[f64]) -> Refusal {
    let Some(found) = &scene.formulas.found else { return Refusal::NotUnique(None) };
    let (mut direct, mut data) = (scene.clone(), data.to_vec());
    direct.formulas.found = None;
    let [low, high] = found.range;
    let printed: f64 = found.measured.value(&data);
    let (mut nowhere, mut above, mut passes) = (None, None, 0);
    for i in 0..=PLACES {
        let at = low + (high - low) * f64::from(i) / f64::from(PLACES);
        data[found.unknown.datum] = at;
        let told = first(&direct, &data, Scope::ALL).ok().filter(|half| half.preview().all_hold());
        match told.and_then(|half| Some(half.preview().get(found.label)?.value() > printed)) {
            None => nowhere = nowhere.or(Some(at)),
            Some(now) => passes += u32::from(above.replace(now).is_some_and(|last| last != now)),
        }
    }
    Refusal::NotUnique(nowhere.filter(|_| passes < 2))
}

/// Is it a cord that holds bodies together, or one to the ground?
fn is_held(tie: &Tie) -> bool {
    matches!(tie, Tie::Cord(c) if matches!(c.to, Far::Body(_) | Far::Fixed))
}

/// Are all numbers of the scene 0, or so near 1 in SI that products of ten of them do not leave the doubles?
fn ordinary(scene: &Scene, data: &[f64]) -> bool {
    let mut all = true;
    admissible::rules(scene, &mut |number, _| {
        let x = scene.value(number, data).abs();
        all &= x == 0.0 || (ORDINARY.recip()..ORDINARY).contains(&x);
    });
    all
}

/// Is the combination one that the assembly has?
fn supported(scene: &Scene, data: &[f64]) -> Result<(), Refusal> {
    let lamina = scene.bodies.iter().any(|b| !b.particles.is_empty());
    let refuse = |what| Err(Refusal::Unsupported(what));
    if scene.lead().is_some() {
        if let Some(strut) = scene.overwound(data) {
            return Err(Refusal::Beyond(Obstacle::Wound(strut)));
        }
        let joined = scene.bodies.iter().all(|b| b.planar.is_some()) && scene.ties.is_empty();
        let along = matches!(scene.end, End::Travel(..) | End::Position(..));
        return if joined && !along { Ok(()) } else { refuse(Unsupported::Unread) };
    }
    if matches!(scene.end, End::AtOnce) && !scene.tells_rates() {
        return Ok(());
    }
    if matches!(scene.end, End::Angle(..))
        || lamina
        || scene.start.iter().any(|s| matches!(s, Start::Lamina { .. }))
    {
        return refuse(Unsupported::Unread);
    }
    let freedoms = scene.freedoms();
    let number = |n: Num| scene.value(n, data);
    // Cords alone can say what other ties say.
    let now = || scene.freedoms_with(&number);
    if scene.ties.iter().any(is_held) && now() != freedoms {
        return Err(Refusal::EqualByChance { usual: freedoms, now: now() });
    }
    // On the way a spring has one freedom, which ends nowhere but at the turning point.
    let moves = scene.is_sprung() && !matches!(scene.end, End::AtOnce);
    let slips = |body: Option<usize>| {
        let on = |tie: &Tie| matches!(tie, Tie::Slip { body: b, .. } if body.is_none_or(|own| own == *b));
        scene.ties.iter().any(on)
    };
    if moves && (slips(None) || freedoms > 1) {
        return refuse(Unsupported::Unread);
    }
    match scene.end {
        End::Rolling(c) if scene.start.is_empty() || !slips(Some(c.body)) => refuse(Unsupported::Unread),
        _ => Ok(()),
    }
}

/// Within `16 u max(1, cond)` of the larger; NaN agrees with nothing, equal infinities agree.
#[expect(clippy::float_cmp, reason = "equal bits agree, infinities among them")]
fn agree(a: f64, b: f64, cond: f64) -> bool {
    if a == b {
        return true;
    }
    let larger = a.abs().max(b.abs());
    let allowed = (2.0 * EACH_ROAD * U * cond.max(1.0)).min(NO_DIGITS);
    larger.is_finite() && (a - b).abs() <= allowed * larger
}
