//! The variant of a student: data are drawn until they hold all rules of the problem, tries and refusals counted.
use crate::bank::decimal::Decimal;
use crate::bank::{Case, Datum, Follow, Problem, Question};
use crate::draw::sample;
use crate::draw::stream::{DrawWords, Source};
use crate::key::{ProblemKey, WrongValue};
use crate::misconception::{self, Methods, Wrong};
use crate::num::Dd;
use crate::problem::make_key::{self, KeyFrame};
pub use crate::problem::rule::Refusals;
use crate::problem::rule::{DrawRule, Refused};
pub use crate::problem::variant::Variant;
use crate::scene::{End, Label, Numbers, Owner, Quantity, Scene};
use crate::solve::agree::{self, Half};
use crate::solve::outcome::{Check, CheckKind, Entry, Refusal, Scope, Solved};
use std::fmt;
use std::sync::OnceLock;

/// Tries after which a bank counts as unsatisfiable.
pub const MAX_TRIES: u32 = 10_000;

/// A relation between parts holds if it gives the right answer within this share: it is computed in doubles.
const RELATION: f64 = 1e-9;

/// A draw is refused in doubles alone where it breaks a rule by more than this share of its limit, far above their rounding.
const CLEARLY: f64 = 1e-6;

/// A wrong method nearer to the right answer than this many of its half-widths cannot be told from it.
pub const APART: f64 = 2.0;

/// No draw held the rules.
#[derive(Debug, Clone, PartialEq)]
pub struct Unsatisfiable {
    /// Id of the problem.
    pub problem: String,
    /// Name of the case, empty if there is only one.
    pub case: String,
    /// Tries that were made.
    pub tries: u32,
    /// Rules and how often each refused, most first.
    pub table: Vec<(String, u32)>,
    /// What to do about it, where the table does not say it.
    pub hint: Option<String>,
    /// The two roads disagreed, which stops everything: the quantity and both values, in words.
    pub disagreement: Option<String>,
    /// The last draw of admissible data that could not be solved, if there was one.
    pub unsolved: Option<Refusal>,
    /// Index of the case.
    pub index: usize,
    /// The data, as printed and as the scene takes them, if they are the same in every draw.
    pub constant: Option<(Vec<Option<Decimal>>, Vec<f64>)>,
}

impl fmt::Display for Unsatisfiable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.problem)?;
        if !self.case.is_empty() {
            write!(f, ", case `{}`", self.case)?;
        }
        if let Some(disagreement) = &self.disagreement {
            return write!(f, ": {disagreement}; the problem is refused");
        }
        if self.constant.is_some() {
            write!(f, ": its data are constants, and they break the rules; refused by")?;
        } else {
            write!(f, ": none of {} draws holds the rules; refused by", self.tries)?;
        }
        for (rule, count) in &self.table {
            write!(f, "\n    {count:>7}  {rule}")?;
        }
        Ok(())
    }
}

/// A draw that a rule refuses.
#[derive(Debug, Clone, PartialEq)]
pub struct RefusedDraw {
    /// Which rule, and what came out instead.
    pub why: String,
    /// What was drawn. A scene that cannot be solved has nothing but its data.
    pub variant: Variant,
}

/// Makes the variants of one problem of one set.
#[derive(Debug)]
pub struct Maker<'p> {
    problem: &'p Problem,
    source: Source,
    max_tries: u32,
    watching: bool,
    /// What is the same for all draws of a case, of each that was drawn.
    plans: Vec<OnceLock<DrawPlan<'p>>>,
    /// What came of the one draw of a case whose data are constants.
    constants: Vec<OnceLock<Result<Variant, Box<Unsatisfiable>>>>,
    /// With constant data and a contact that rolls or slips: the case that happens, for each case.
    happening: Vec<OnceLock<usize>>,
    /// What all keys have in common.
    frame: OnceLock<KeyFrame<'p>>,
}

/// What is the same for all draws of a case.
#[derive(Debug)]
struct DrawPlan<'p> {
    methods: Methods<'p>,
    /// How far both roads go.
    asked: Scope,
    /// What the rules ask of a first road in doubles, where one in 32 digits costs many times as much and many draws are refused.
    screen: Option<Scope>,
}

/// A student's words, the case, and room for the data.
type Begun = (DrawWords, usize, Vec<Option<Decimal>>, Vec<f64>);

/// Hears of each rule that a draw breaks. Errors: it is enough, the draw is refused.
type Hears<'h> = &'h mut dyn FnMut(Refused) -> Result<(), Refused>;

/// A right answer, and how near to it a wrong method may not come; NaN where there is no number.
type Accepted = (f64, f64);

impl<'p> Maker<'p> {
    /// A maker for a problem of the set `set`, drawn with `seed`.
    pub fn new(problem: &'p Problem, seed: u64, set: &str) -> Self {
        Self {
            problem,
            source: Source::new(seed, set, &problem.id),
            max_tries: MAX_TRIES,
            watching: false,
            plans: problem.cases.iter().map(|_| OnceLock::new()).collect(),
            constants: problem.cases.iter().map(|_| OnceLock::new()).collect(),
            happening: problem.cases.iter().map(|_| OnceLock::new()).collect(),
            frame: OnceLock::new(),
        }
    }
    /// Keeps the condition numbers of draws that hold all other rules ([`Refusals::conds`]).
    #[must_use]
    pub fn watching(mut self) -> Self {
        self.watching = true;
        self
    }
    /// The same for the draws of another seed: what does not hang on it is kept.
    #[must_use]
    pub fn with_seed(mut self, seed: u64, set: &str) -> Self {
        self.source = Source::new(seed, set, &self.problem.id);
        self
    }
    /// Gives up after this many tries instead of [`MAX_TRIES`].
    #[must_use]
    pub fn giving_up_after(mut self, tries: u32) -> Self {
        self.max_tries = tries.max(1);
        self
    }
    /// The key of a variant of the problem.
    pub fn key(&self, variant: &Variant) -> ProblemKey {
        self.frame.get_or_init(|| KeyFrame::new(self.problem)).key(variant)
    }
    /// The variant of a student: the case by share, then draws until one holds all rules of this case.
    ///
    /// Errors: none of the tries held them; the table says which rule refused how often.
    pub fn variant(&self, student: &str) -> Result<Variant, Box<Unsatisfiable>> {
        let begun = self.begin(student);
        let case = begun.1;
        // Constants are the same in every draw.
        if self.problem.cases[case].is_constant() {
            return self.constants[case].get_or_init(|| self.first_within(begun)).clone();
        }
        self.first_within(begun)
    }

    /// The first draw that holds all rules of its case.
    fn first_within(
        &self,
        (mut words, index, mut values, mut data): Begun,
    ) -> Result<Variant, Box<Unsatisfiable>> {
        let case = &self.problem.cases[index];
        let mut refusals = Refusals::default();
        let constant = case.is_constant();
        let most = if constant { 1 } else { self.max_tries };
        for tries in 1..=most {
            self.draw(&mut words, tries, case, &mut values, &mut data);
            match self.solve_within_rules(index, &data, &mut refusals) {
                Ok((solved, wrong)) => {
                    let within = make_key::within(self.problem, &solved);
                    return Ok(Variant { case: index, values, data, solved, tries, refusals, within, wrong });
                }
                Err(refused) => refusals.add(refused),
            }
            // A key that the roads do not share is no bad luck of the draw: nothing is redrawn around it.
            if let Some(Refusal::Disagree { label, eom, energy, allowed }) = &refusals.unsolved {
                let name = case.scene.name_of(*label);
                let disagreement = format!(
                    "the equations of motion and work and energy disagree on {name}: {eom:e} against {energy:e}, more than the relative {allowed:.1e} that rounding explains"
                );
                let constant = constant.then_some((values, data));
                return Err(Box::new(self.unsatisfiable(
                    index,
                    tries,
                    &refusals,
                    Some(disagreement),
                    constant,
                )));
            }
        }
        let constant = constant.then_some((values, data));
        Err(Box::new(self.unsatisfiable(index, most, &refusals, None, constant)))
    }

    /// A student's words, the case by share, and room for the data.
    fn begin(&self, student: &str) -> Begun {
        let mut words = self.source.student(student);
        let index = self.happening(sample::case(&mut words, &self.problem.cases));
        let n = self.problem.data.len();
        (words, index, vec![None; n], vec![0.0; n])
    }

    /// Whether a contact rolls or slips is no matter of chance where all data are constants: of its two cases the one that
    /// happens is drawn, whichever was.
    fn happening(&self, index: usize) -> usize {
        let cases = &self.problem.cases;
        let alike = |c: &Case| !c.touches.is_empty() && c.is_constant() && c.written == cases[index].written;
        if !alike(&cases[index]) {
            return index;
        }
        *self.happening[index].get_or_init(|| {
            let mut like = cases.iter().enumerate().filter(|(_, c)| alike(c));
            let happening = |case: &Case| {
                happens(std::slice::from_ref(&case.scene), &self.problem.numbers(&case.least()))
            };
            like.find(|(_, c)| happening(c)).map_or(index, |(i, _)| i)
        })
    }

    fn draw(
        &self,
        words: &mut DrawWords,
        tries: u32,
        case: &Case,
        values: &mut [Option<Decimal>],
        data: &mut [f64],
    ) {
        words.attempt(tries);
        for (i, draw) in case.draws.iter().enumerate() {
            if let Some(draw) = draw {
                let value = sample::value(words, i, draw);
                values[i] = Some(value);
                data[i] = self.problem.data[i].number(value);
            }
        }
    }

    /// The draw of a student that took so many tries before: the last of them alone, those before it are not made again.
    fn drawn(&self, student: &str, tries: u32) -> (usize, Vec<Option<Decimal>>, Vec<f64>) {
        let (mut words, index, mut values, mut data) = self.begin(student);
        self.draw(&mut words, tries, &self.problem.cases[index], &mut values, &mut data);
        (index, values, data)
    }

    /// The variant of such a draw. Errors: the draw, if it does not hold the rules, and which one refuses it.
    pub fn again(&self, student: &str, tries: u32) -> Result<Variant, Box<RefusedDraw>> {
        let (case, values, data) = self.drawn(student, tries);
        let mut refusals = Refusals::default();
        // It will hold.
        match self.solve_within(case, &data, Scope::ALL, &mut refusals, &mut Err) {
            Ok((solved, wrong)) => {
                let within = make_key::within(self.problem, &solved);
                Ok(Variant { case, values, data, solved, tries, refusals, within, wrong })
            }
            Err(refused) => Err(Box::new(self.refusal(refused, (case, values, data), tries, refusals))),
        }
    }

    /// A draw that a rule refuses.
    fn refusal(
        &self,
        refused: Refused,
        (case, values, data): (usize, Vec<Option<Decimal>>, Vec<f64>),
        tries: u32,
        mut refusals: Refusals,
    ) -> RefusedDraw {
        refusals.add(refused);
        let table = refusals.table(self.problem, case);
        let why = table.into_iter().map(|(why, _)| why).next().unwrap_or_default();
        let variant = from_values(self.problem, case, &values).unwrap_or_else(|_| Variant {
            case,
            values,
            data,
            solved: Solved::none(),
            tries,
            refusals,
            within: Vec::new(),
            wrong: Vec::new(),
        });
        RefusedDraw { why, variant }
    }

    /// What the first road alone makes of such a draw: the answers with their tolerances, unproved, and no wrong methods.
    pub fn by_first_road(&self, student: &str, tries: u32) -> Option<Variant> {
        self.first_road(student, tries, |case, data, half| {
            self.weigh(case, data, half);
            Vec::new()
        })
    }

    /// Where the wrong methods of such a draw come to, part by part.
    pub fn wrong_values(&self, student: &str, tries: u32) -> Option<Vec<Vec<WrongValue>>> {
        let variant = self.first_road(student, tries, |case, data, half| {
            self.plan(case).methods.values_while(data, half.preview(), &mut |_| true)
        })?;
        Some(self.key(&variant).parts.into_iter().map(|part| part.wrong).collect())
    }

    fn first_road(
        &self,
        student: &str,
        tries: u32,
        more: impl FnOnce(usize, &[f64], &mut Half) -> Vec<Wrong>,
    ) -> Option<Variant> {
        let (case, values, data) = self.drawn(student, tries);
        let mut half = agree::first(&self.problem.cases[case].scene, &data, Scope::ALL).ok()?;
        let wrong = more(case, &data, &mut half);
        let (solved, refusals) = (half.preview().clone(), Refusals::default());
        let within = make_key::within(self.problem, &solved);
        Some(Variant { case, values, data, solved, tries, refusals, within, wrong })
    }

    /// Draws that are refused, the first of each rule, among so many.
    pub fn refused(&self, tries: u32) -> Vec<RefusedDraw> {
        let mut found: Vec<(DrawRule, RefusedDraw)> = Vec::new();
        let mut seen = vec![false; self.problem.cases.len()];
        for n in 1..=tries {
            let (index, values, data) = self.drawn(&format!("refused {n}"), n);
            // Constants are the same in every draw.
            if std::mem::replace(&mut seen[index], true) && self.problem.cases[index].is_constant() {
                continue;
            }
            let mut refusals = Refusals::default();
            let Err(refused) = self.solve_within_rules(index, &data, &mut refusals) else { continue };
            if found.iter().any(|(rule, _)| *rule == refused.rule) {
                continue;
            }
            found.push((refused.rule, self.refusal(refused, (index, values, data), n, refusals)));
        }
        found.into_iter().map(|(_, draw)| draw).collect()
    }

    fn unsatisfiable(
        &self,
        case: usize,
        tries: u32,
        refusals: &Refusals,
        disagreement: Option<String>,
        constant: Option<(Vec<Option<Decimal>>, Vec<f64>)>,
    ) -> Unsatisfiable {
        Unsatisfiable {
            problem: self.problem.id.clone(),
            case: self.problem.cases[case].name.clone(),
            tries,
            table: refusals.table(self.problem, case),
            hint: refusals.hint(self.problem, constant.is_some()),
            disagreement,
            unsolved: refusals.unsolved.clone(),
            index: case,
            constant,
        }
    }

    /// Solves, or says which rule refuses: of data that may be drawn anew the first one, of constants each that they break.
    fn solve_within_rules(
        &self,
        index: usize,
        data: &[f64],
        refusals: &mut Refusals,
    ) -> Result<(Solved, Vec<Wrong>), Refused> {
        let asked = self.plan(index).asked;
        if !self.problem.cases[index].is_constant() {
            return match self.screened(index, data) {
                Some(refused) => Err(refused),
                None => self.solve_within(index, data, asked, refusals, &mut Err),
            };
        }
        let mut broken = Vec::new();
        let mut hear = |refused: Refused| {
            if broken.iter().all(|known: &Refused| known.rule != refused.rule) {
                broken.push(refused);
            }
            Ok(())
        };
        let solved = self.solve_within(index, data, asked, refusals, &mut hear);
        if broken.is_empty() {
            return solved;
        }
        // That what does not happen cannot be proved tells nothing more.
        refusals.unsolved = None;
        // The caller counts the last one.
        let Some(last) = broken.pop() else { return solved };
        broken.into_iter().for_each(|refused| refusals.add(refused));
        Err(last)
    }

    /// The first rule that a draw breaks, if it does so clearly, as doubles tell.
    fn screened(&self, index: usize, data: &[f64]) -> Option<Refused> {
        let (case, plan) = (&self.problem.cases[index], self.plan(index));
        // Not in a page, which is to be small.
        let scope = plan.screen.filter(|_| cfg!(feature = "program"))?;
        if let Err(refused) = bounds(case, false, data, &|_| f64::NAN, &mut Err) {
            return Some(refused);
        }
        let half = agree::roughly(&case.scene, data, scope)?;
        let clear = |refused: &Refused| {
            let off = |limit: f64| (refused.found - limit).abs() > CLEARLY * limit.abs().max(1.0);
            match refused.rule {
                DrawRule::Check(kind) => kind.is_share() && off(self.margin(kind)),
                DrawRule::Bound(i) => [case.bounds[i].min, case.bounds[i].max].into_iter().flatten().all(off),
                DrawRule::Mistake(_) => true,
                _ => false,
            }
        };
        let held = self.rules(case, half.preview(), data, &mut Err).and_then(|()| match self.watching {
            // Then wrong methods come last.
            true => Ok(()),
            false => self.far(&plan.methods, data, half.preview(), &mut Err).map(drop),
        });
        held.err().filter(clear)
    }

    /// Solves, the first road of what is asked at first.
    fn solve_within(
        &self,
        index: usize,
        data: &[f64],
        asked: Scope,
        refusals: &mut Refusals,
        hear: Hears,
    ) -> Result<(Solved, Vec<Wrong>), Refused> {
        let case = &self.problem.cases[index];
        // Bounds on the data alone cost nothing: they go first.
        bounds(case, false, data, &|_| f64::NAN, hear)?;
        // A draw that breaks a rule on the first road needs no second one.
        let methods = &self.plan(index).methods;
        let first = agree::first(&case.scene, data, asked);
        let mut half = first.map_err(|refusal| unsolved(refusals, refusal))?;
        self.rules(case, half.preview(), data, hear)?;
        self.energies(case, half.preview(), data, hear)?;
        // Wrong methods refuse more draws than all rules below, so they come first. A maker that is watching counts which methods
        // would refuse a draw that holds every other rule: it asks them last.
        let wrong = if self.watching { None } else { Some(self.far(methods, data, half.preview(), hear)?) };
        // Condition numbers cost more than all the rest of the first road: only for what holds the other rules.
        self.weigh(index, data, &mut half);
        if self.watching {
            refusals.conds.extend(self.problem.questions.iter().map(|q| cond(half.preview(), q.label)));
        }
        self.conditioned(half.preview(), hear)?;
        let right = self.right(half.preview(), false);
        let near = wrong.iter().flatten().filter(|w| self.refuses(w, &right));
        for wrong in near {
            hear(DrawRule::Mistake(wrong.mistake).into())?;
        }
        if happens(&case.rivals, data) {
            hear(DrawRule::Alone.into())?;
        }
        let mut solved = half.confirm(&case.scene, data).map_err(|refusal| unsolved(refusals, refusal))?;
        self.moves(case, &solved, hear)?;
        if !agree::prove(&case.scene, data, &mut solved) {
            if case.scene.formulas.found.is_some() {
                return Err(unsolved(refusals, agree::not_unique(&case.scene, data)).into());
            }
            return Err(DrawRule::Certain.into());
        }
        if let Some((question, share)) = make_key::wide(self.problem, &solved) {
            hear(DrawRule::Proved(question).found(share))?;
        }
        if let Some(question) = broken_relation(self.problem, case, data, &solved) {
            hear(DrawRule::Follows(question).into())?;
        }
        let wrong = match wrong {
            Some(wrong) => wrong,
            None => self.told_apart(methods, data, &solved, refusals, hear)?,
        };
        Ok((solved, wrong))
    }

    /// Condition numbers of what is asked.
    fn weigh(&self, case: usize, data: &[f64], half: &mut Half) {
        let asked = |label| self.problem.questions.iter().any(|q| q.label == label);
        half.weigh(&self.problem.cases[case].scene, data, asked);
    }

    /// What is the same for all draws of a case.
    fn plan(&self, index: usize) -> &DrawPlan<'p> {
        self.plans[index].get_or_init(|| {
            let labels: Vec<Label> = self.problem.questions.iter().map(|q| q.label).collect();
            let methods = Methods::new(self.problem, index, &labels, &|_| true);
            let bounds = self.problem.cases[index].bounds.iter().flat_map(|b| b.expression.quantities());
            let named = labels.iter().copied().chain(bounds).map(|label| label.quantity);
            let named = Scope::only(named.chain(methods.quantities()));
            let scene = &self.problem.cases[index].scene;
            // A formula may need any quantity; where nothing is joined all follow at once.
            let formulas = scene.formulas.found.is_some() || !scene.formulas.asked.is_empty();
            let joined = scene.lead().is_some() && scene.pinned().is_none();
            let timeless = !formulas && joined && !named.quantities.has(Quantity::T);
            let asked = if timeless { Scope::TIMELESS } else { Scope::ALL };
            let screen = (scene.pinned().is_some() && !formulas).then_some(Scope { held: true, ..named });
            DrawPlan { methods, asked, screen }
        })
    }

    /// For each question what a wrong method must keep away from: by its tolerance, or by clearly less than the least that it may have,
    /// which needs no condition number.
    fn right(&self, solved: &Solved, least: bool) -> Vec<Accepted> {
        let right = |q: &Question| match solved.get(q.label) {
            Some(e) => {
                let (cond, share) = if least { (0.0, 1.0 - CLEARLY) } else { (e.cond, 1.0) };
                (e.value(), share * APART * make_key::half_width(q, e.value(), e.scale, cond))
            }
            None => (f64::NAN, f64::NAN),
        };
        self.problem.questions.iter().map(right).collect()
    }

    /// Does a wrong method come near the right answer of its question?
    fn near(&self, wrong: &Wrong, right: &[Accepted]) -> bool {
        let (value, reach) = right[wrong.asked];
        let off = |comes_to: f64| (comes_to - value).abs() < reach;
        // Where a magnitude is asked, a sign is no answer.
        let magnitude = || self.problem.cases.iter().all(|case| case.scene.is_magnitude(wrong.label));
        off(wrong.value) || off(-wrong.value) && magnitude()
    }

    /// Does a wrong method refuse a draw?
    fn refuses(&self, wrong: &Wrong, right: &[Accepted]) -> bool {
        let mistake = &self.problem.mistakes[wrong.mistake];
        let unguarded = &self.problem.questions[wrong.asked].unguarded;
        mistake.unguarded.is_none()
            && self.near(wrong, right)
            && !unguarded.iter().any(|(id, _)| *id == mistake.id)
    }

    /// Where the wrong methods come to, if none comes near a right answer whatever its tolerance.
    fn far(
        &self,
        methods: &Methods,
        data: &[f64],
        solved: &Solved,
        hear: Hears,
    ) -> Result<Vec<Wrong>, Refused> {
        let (mut near, right) = (None, self.right(solved, true));
        let all = methods.values_while(data, solved, &mut |wrong| {
            if near.is_none() && self.refuses(wrong, &right) {
                near = Some(wrong.mistake);
            }
            near.is_none()
        });
        near.map_or(Ok(()), |mistake| hear(DrawRule::Mistake(mistake).into()))?;
        Ok(all)
    }

    /// Where the wrong methods come to, if none comes near a right answer; counts how often each does.
    fn told_apart(
        &self,
        methods: &Methods,
        data: &[f64],
        solved: &Solved,
        refusals: &mut Refusals,
        hear: Hears,
    ) -> Result<Vec<Wrong>, Refused> {
        if self.problem.mistakes.is_empty() {
            return Ok(Vec::new());
        }
        let all = methods.values_while(data, solved, &mut |_| true);
        let right = self.right(solved, false);
        let width = self.problem.questions.len() + 1;
        let mut near = vec![false; self.problem.mistakes.len() * width];
        for wrong in all.iter().filter(|wrong| self.near(wrong, &right)) {
            near[wrong.mistake * width + wrong.asked] = true;
            near[(wrong.mistake + 1) * width - 1] = true;
        }
        refusals.told += 1;
        refusals.near.resize(near.len(), 0);
        for (count, any) in refusals.near.iter_mut().zip(&near) {
            *count += u32::from(*any);
        }
        for wrong in all.iter().filter(|w| self.refuses(w, &right)) {
            hear(DrawRule::Mistake(wrong.mistake).into())?;
        }
        Ok(all)
    }

    /// Is the kinetic energy not what two much larger energies leave?
    fn energies(&self, case: &Case, solved: &Solved, data: &[f64], hear: Hears) -> Result<(), Refused> {
        let kinetic = Label { quantity: Quantity::KineticEnergy, of: Owner::Scene };
        // At a turning point there is none, nor at rest, and at an instant no work is done.
        if solved.regime.stays_as(&case.regimes) || case.scene.is_still() {
            return Ok(());
        }
        if let (Some(kinetic), false) = (solved.get(kinetic), matches!(case.scene.end, End::TurningPoint(_)))
            && let Some(input) = input_energy(&case.scene, data, solved)
        {
            let within = input <= self.problem.energy_limit * kinetic.value();
            return if within { Ok(()) } else { hear(DrawRule::Input.found(input / kinetic.value())) };
        }
        Ok(())
    }

    /// Is every answer determined well enough by the printed data?
    fn conditioned(&self, solved: &Solved, hear: Hears) -> Result<(), Refused> {
        for (i, question) in self.problem.questions.iter().enumerate() {
            let cond = cond(solved, question.label);
            if !cond.le(&question.cond_limit) {
                hear(DrawRule::Cond(i).found(cond))?;
            }
        }
        Ok(())
    }

    /// The margin with which conditions of this kind are to hold.
    fn margin(&self, kind: CheckKind) -> f64 {
        self.problem.margins.iter().find(|(k, _)| *k == kind).map_or(0.0, |(_, m)| *m)
    }

    /// Do these checks hold, with their margins?
    fn checks(&self, solved: &Solved, of: impl Fn(&Check) -> bool, hear: Hears) -> Result<(), Refused> {
        for check in solved.checks.iter().filter(|c| of(c)) {
            if !check.ok || check.margin.is_nan() || check.margin < self.margin(check.kind) {
                // A condition may fail for more than its margin says: then no number tells why.
                let told = check.ok || check.margin < 0.0;
                hear(DrawRule::Check(check.kind).found(if told { check.margin } else { f64::NAN }))?;
            }
        }
        Ok(())
    }

    /// Does it move with the margin, or stay with the same margin where it is declared to stay?
    fn moves(&self, case: &Case, solved: &Solved, hear: Hears) -> Result<(), Refused> {
        if !solved.regime.stays_as(&case.regimes) {
            return self.checks(solved, |c| c.kind == CheckKind::Moves, hear);
        }
        for check in solved.checks.iter().filter(|c| c.kind == CheckKind::Moves) {
            // What nothing drives needs no margin.
            let driven = check.available > 0.0 || check.available.is_nan();
            if driven && (check.margin.is_nan() || -check.margin < self.margin(check.kind)) {
                hear(DrawRule::Check(check.kind).found(check.margin))?;
            }
        }
        Ok(())
    }

    /// The rules that need a solution, on the first road; which one refuses.
    fn rules(&self, case: &Case, solved: &Solved, data: &[f64], hear: Hears) -> Result<(), Refused> {
        // What is declared to stay needs no cord that pulls.
        let stays = solved.regime.stays_as(&case.regimes);
        self.checks(solved, |c| c.kind != CheckKind::Moves && !(stays && c.idles()), hear)?;
        if !solved.regime.is_one_of(&case.regimes, &case.scene) {
            hear(DrawRule::Regime(solved.regime).into())?;
        }
        for (i, question) in self.problem.questions.iter().enumerate() {
            let answered = if question.label.quantity.is_word() {
                // A sheet offers no word for what a draw does beyond what its problem declares.
                let offered = make_key::offered(self.problem, question.label.quantity, &case.scene);
                solved.word(question.label).is_some_and(|word| offered.contains(&word.as_str()))
            } else {
                solved.get(question.label).is_some_and(|e| e.value().is_finite())
            };
            if !answered {
                hear(DrawRule::Answered(i).into())?;
            }
        }
        bounds(case, true, data, &|label| solved.asked(&case.scene, label), hear)
    }
}

/// Does what one of these scenes assumes hold with these data?
pub fn happens(scenes: &[Scene], data: &[f64]) -> bool {
    let holds = |scene: &Scene| agree::first(scene, data, Scope::ALL).is_ok_and(|h| h.preview().all_hold());
    scenes.iter().any(holds)
}

/// The rule by which a draw is refused that was not solved; what is to be told of it is kept.
fn unsolved(refusals: &mut Refusals, refusal: Refusal) -> DrawRule {
    let rule = match refusal {
        Refusal::Inadmissible(faults) => {
            refusals.inadmissible = faults;
            return DrawRule::Admissible;
        }
        Refusal::Disagree { .. } | Refusal::Barely => DrawRule::Agree,
        Refusal::Open(_) | Refusal::Contradiction { .. } => DrawRule::Start,
        _ => DrawRule::Solvable,
    };
    refusals.unsolved = Some(refusal);
    rule
}

/// Condition number of an answer; 0 for a word.
fn cond(solved: &Solved, label: Label) -> f64 {
    solved.get(label).map_or(0.0, |e| e.cond)
}

/// Energy put into a motion with a spring: what springs store at first, and what weights that sink and pulls
/// give; J. `None` where there is no spring on a cord (that of a pinned body is left to the condition numbers).
fn input_energy(scene: &Scene, data: &[f64], solved: &Solved) -> Option<f64> {
    let n = Numbers::<Dd>::new(scene, data);
    let stored = scene.springs().map(|s| {
        let stretch = n.get(s.stretch_m);
        (n.massive(s.stiffness_n_m) * stretch * stretch).scale2(-1)
    });
    let mut energy = stored.reduce(|a, b| a + b)?;
    for (label, value) in solved.entries.iter().map(|e| (e.label, e.value())) {
        if let (Quantity::Rise, Owner::Body(b)) = (label.quantity, label.of) {
            energy = energy + n.bodies[b].mass * n.gravity * Dd::new((-value).max(0.0));
        }
    }
    let pulls = solved
        .entries
        .iter()
        .filter(|e| e.label.quantity == Quantity::WorkPull && matches!(e.label.of, Owner::Tie(_)))
        .map(Entry::value);
    Some(n.publish(Quantity::KineticEnergy, energy).hi + pulls.map(|w| w.max(0.0)).sum::<f64>())
}

/// Do the values of these bounds, those that need a solution or the others, lie within them? NaN does not.
fn bounds(
    case: &Case,
    of_solution: bool,
    data: &[f64],
    quantity: &dyn Fn(Label) -> f64,
    hear: Hears,
) -> Result<(), Refused> {
    for (i, bound) in case.bounds.iter().enumerate() {
        if bound.expression.quantities().next().is_some() != of_solution {
            continue;
        }
        let value = bound.expression.eval(data, quantity);
        let within = bound.min.is_none_or(|m| value >= m) && bound.max.is_none_or(|m| value <= m);
        if value.is_nan() || !within {
            hear(DrawRule::Bound(i).found(value))?;
        }
    }
    Ok(())
}

/// The first relation between parts that does not give the right answer from right ones: an index into the questions.
pub fn broken_relation(problem: &Problem, case: &Case, data: &[f64], solved: &Solved) -> Option<usize> {
    let right = |label: Label| solved.asked(&case.scene, label);
    let holds = |question: &Question, value: f64| {
        let Some(entry) = solved.get(question.label) else { return false };
        (value - right(question.label)).abs() <= RELATION * entry.value().abs().max(entry.scale)
    };
    let broken = |f: &&Follow| !holds(&problem.questions[f.question], f.by.eval(data, &right));
    problem.follows.iter().find(broken).map(|f| f.question)
}

/// The variant of stored values, for replay: solved anew, no rules applied.
///
/// Errors: the values are no scene, or the roads disagree.
pub fn from_values(problem: &Problem, case: usize, values: &[Option<Decimal>]) -> Result<Variant, Refusal> {
    of_values(problem, case, values, |scene, data| {
        let mut solved = agree::solve(scene, data)?;
        agree::prove(scene, data, &mut solved);
        Ok(solved)
    })
}

/// What both roads agree on where the scene ends so: for curves, which need neither a proof nor wrong methods.
#[cfg(feature = "program")]
pub fn ending(scene: &Scene, end: End, data: &[f64]) -> Option<Solved> {
    agree::answers(&Scene { end, ..scene.clone() }, data).ok()
}

/// The variant of a sheet's values, for who checks an answer: what a sheet puts was drawn because both roads and an enclosure
/// agree on it, so the first road gives the answers. Condition numbers are not worked out: what hangs on them stands on the sheet.
///
/// Errors: the values are no scene.
pub fn of_sheet(problem: &Problem, case: usize, values: &[Option<Decimal>]) -> Result<Variant, Refusal> {
    of_values(problem, case, values, |scene, data| Ok(agree::again(scene, data)?.preview().clone()))
}

fn of_values(
    problem: &Problem,
    case: usize,
    values: &[Option<Decimal>],
    solve: impl FnOnce(&Scene, &[f64]) -> Result<Solved, Refusal>,
) -> Result<Variant, Refusal> {
    let number =
        |(i, datum): (usize, &Datum)| values.get(i).copied().flatten().map_or(0.0, |v| datum.number(v));
    let data: Vec<f64> = problem.data.iter().enumerate().map(number).collect();
    let scene = problem.cases.get(case).map(|c| &c.scene).ok_or(Refusal::Freedoms(0))?;
    let solved = solve(scene, &data)?;
    let labels: Vec<Label> = problem.questions.iter().map(|q| q.label).collect();
    let wrong = misconception::values(problem, case, &data, &solved, &labels);
    let within = make_key::within(problem, &solved);
    let refusals = Refusals::default();
    Ok(Variant { case, values: values.to_vec(), data, solved, tries: 0, refusals, within, wrong })
}
