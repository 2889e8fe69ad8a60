//! In which order equations give what is unknown in them: each from one in which nothing else is, or two from two together. So a
//! lecture goes through the forces of a linkage, with moments about a joint where its force is not wanted.
//!
//! Where no such order is told (velocities of an impact, velocity ratios of ties) the unknowns are eliminated one after the other.
use crate::scene::{End, Quantity};
use crate::solution::draft::Draft;
use crate::solution::expr::{Expr, SymbolId, ZERO, positive_first, sum};
use crate::solution::factors::{Cancel, Factors, Sum};
use crate::solution::page::{Page, packed};
use crate::solution::plane::{NOTHING, Plane, cross, less};
use std::cmp::Reverse;

/// Lines that the values take at least, however full the page is.
const LEAST: usize = 5;

/// An equation, both sides, with its place among them and what it is called within a sentence.
#[derive(Debug, Clone)]
pub struct Row {
    pub at: usize,
    pub name: String,
    pub sides: (Expr, Expr),
    /// Does it stand on the page already?
    pub told: bool,
}

/// What one equation gives, or two together.
#[derive(Debug, Clone)]
pub struct Found {
    pub rows: Vec<Row>,
    pub symbols: Vec<SymbolId>,
    /// What the one that a single equation gives is equal to.
    pub is: Option<Expr>,
}

impl Found {
    fn uses(&self) -> impl Iterator<Item = SymbolId> {
        self.rows.iter().flat_map(|row| [row.sides.0.uses(), row.sides.1.uses()].concat())
    }
}

/// What of this is needed for what is wanted, in order.
pub fn needed(all: Vec<Found>, mut wanted: Vec<SymbolId>) -> Vec<Found> {
    let mut kept = Vec::new();
    for mut found in all.into_iter().rev() {
        found.symbols.retain(|s| found.rows.len() == 2 || wanted.contains(s));
        if found.symbols.iter().any(|s| wanted.contains(s)) {
            wanted.extend(found.uses());
            kept.insert(0, found);
        }
    }
    kept
}

/// What equations give when the unknowns have been taken out of them one after the other.
pub struct Eliminated {
    /// How each follows, by itself or from those before it.
    pub found: Vec<(SymbolId, Expr)>,
    /// Those that one equation alone says to be 0, whatever the data.
    pub idle: Vec<SymbolId>,
    /// The equations that are left.
    pub left: Vec<Sum>,
}

impl Draft<'_> {
    /// An equation, a sum that is 0, by what is the factor of a symbol in it, and the rest.
    pub fn parted(&self, row: &Sum, symbol: SymbolId) -> Option<[Sum; 2]> {
        let holds = |t: &Factors| t.expr().uses().contains(&symbol);
        let (own, rest): (Vec<Factors>, Vec<Factors>) = row.terms().iter().cloned().partition(holds);
        let share = Sum::of(own.iter().map(|t| t.per(symbol)));
        let clear = !share.terms().iter().any(holds) && share.expr().value(&self.symbols).abs() > NOTHING;
        clear.then(|| [share, Sum::of(rest)])
    }
    /// A quotient, with a positive denominator.
    pub fn quotient(&self, over: &Sum, under: &Sum) -> Expr {
        let sense = if under.expr().value(&self.symbols) < 0.0 { -1 } else { 1 };
        over.signed(sense).expr().over(under.signed(sense).expr())
    }
    /// Takes what is open out of the equations, sums that are 0, without a fraction in a fraction; what comes late is solved for only where
    /// nothing else is.
    pub fn eliminate(
        &self,
        mut rows: Vec<Sum>,
        mut open: Vec<SymbolId>,
        late: impl Fn(SymbolId) -> bool,
    ) -> Option<Eliminated> {
        let (mut first, mut last, mut idle) = (Vec::new(), Vec::new(), Vec::new());
        while !open.is_empty() {
            let unknown = |row: &Sum| -> Vec<SymbolId> {
                row.expr().uses().into_iter().filter(|s| open.contains(s)).collect()
            };
            let least = (0..rows.len()).filter(|i| !unknown(&rows[*i]).is_empty());
            let at = least.min_by_key(|i| (unknown(&rows[*i]).len(), Reverse(*i)))?;
            let row = rows.remove(at);
            let mut candidates = unknown(&row);
            let alone = candidates.len() == 1;
            candidates.sort_by_key(|s| late(*s));
            let (symbol, [share, rest]) =
                candidates.into_iter().find_map(|s| Some((s, self.parted(&row, s)?)))?;
            open.retain(|s| *s != symbol);
            if alone && rest.is_zero() && last.is_empty() {
                rows.iter_mut().for_each(|row| *row = row.put(symbol, &ZERO));
                idle.push(symbol);
                continue;
            }
            let found = (symbol, self.quotient(&rest.opposite(), &share));
            if alone {
                first.push(found);
                continue;
            }
            last.insert(0, found);
            for other in rows.iter_mut().filter(|other| self.parted(other, symbol).is_some()) {
                let put = |t: &Factors| match t.expr().uses().contains(&symbol) {
                    true => t.per(symbol).each(&rest).opposite(),
                    false => t.each(&share),
                };
                *other = other.terms().iter().map(put).sum::<Sum>().primitive(&open);
            }
        }
        Some(Eliminated { found: first.into_iter().chain(last).collect(), idle, left: rows })
    }
}

impl Page<'_, '_> {
    /// Takes what is open out of the equations, one after the other; with `pairs` two from two where no single one does.
    pub fn untangle(&mut self, mut rows: Vec<Row>, open: &mut Vec<SymbolId>, pairs: bool) -> Vec<Found> {
        let mut all = Vec::new();
        loop {
            let unknown = |row: &Row, open: &[SymbolId]| -> Vec<SymbolId> {
                let uses = [row.sides.0.uses(), row.sides.1.uses()].concat();
                open.iter().copied().filter(|s| uses.contains(s)).collect()
            };
            let single = rows.iter().enumerate().find_map(|(at, row)| match unknown(row, open)[..] {
                [symbol] => Some((at, symbol, self.isolated(&row.sides, symbol)?)),
                _ => None,
            });
            if let Some((at, symbol, is)) = single {
                open.retain(|s| *s != symbol);
                all.push(Found { rows: vec![rows.remove(at)], symbols: vec![symbol], is: Some(is) });
                continue;
            }
            let both = (0..rows.len()).flat_map(|i| (0..i).map(move |j| (j, i))).find_map(|(j, i)| {
                let (one, two) = (unknown(&rows[j], open), unknown(&rows[i], open));
                let sides = [rows[j].sides.clone(), rows[i].sides.clone()];
                let found = pairs && one.len() == 2 && one == two && self.give(&sides, &one);
                found.then_some((j, i, one))
            });
            let Some((j, i, symbols)) = both else { return all };
            open.retain(|s| !symbols.contains(s));
            let second = rows.remove(i);
            all.push(Found { rows: vec![rows.remove(j), second], symbols, is: None });
        }
    }
    /// Notes what single equations give.
    pub fn follow(&mut self, found: &[Found]) {
        for f in found {
            // What is 0 but for rounding stays 0.
            if let (Some(is), [symbol]) = (&f.is, &f.symbols[..])
                && self.symbols.value(*symbol) != 0.0
            {
                self.step(*symbol, is.clone());
            }
        }
    }
    /// Do these equations determine what is unknown in them?
    fn give(&mut self, rows: &[(Expr, Expr)], unknowns: &[SymbolId]) -> bool {
        self.solved(rows, unknowns).is_some_and(|found| found.iter().all(Option::is_some))
    }
    /// `$X$ from (7)`, in order.
    fn say_order(&mut self, found: &[Found]) {
        if found.is_empty() {
            return;
        }
        let names = |f: &Found| -> Vec<String> {
            let mut names: Vec<String> = f.rows.iter().map(|row| row.name.clone()).collect();
            names.dedup();
            names
        };
        let alike = |one: &Found, two: &Found| names(one).len() == 1 && names(one) == names(two);
        let each = found.chunk_by(alike).map(|run| {
            let symbols: Vec<SymbolId> = run.iter().flat_map(|f| f.symbols.clone()).collect();
            let symbols = self.names(&symbols);
            match &names(&run[0])[..] {
                [one, two] => {
                    self.phrase("order.together", &[("symbols", &symbols), ("one", one), ("two", two)])
                }
                rows => self.phrase("order.from", &[("symbols", &symbols), ("row", &rows.concat())]),
            }
        });
        let list: Vec<String> = each.collect();
        self.say("order.one_by_one", &[("list", &list.join("; "))]);
        let aside = found.iter().filter(|f| f.rows.len() == 2).flat_map(|f| &f.rows).filter(|row| !row.told);
        let aside: Vec<(Expr, Expr)> = aside.map(|row| row.sides.clone()).collect();
        self.equations(&aside);
    }
}

impl Plane<'_, '_> {
    /// The equations of this place in the order in which they are told.
    pub fn rows_in_order(&mut self, moments: bool) -> Vec<Row> {
        let joints = self.phrase("order.joints", &[]);
        let named = |name, sides| Row { at: 0, name, sides, told: true };
        let mut all: Vec<Row> =
            self.demands().into_iter().map(|sides| named(joints.clone(), sides)).collect();
        let equations = (0..self.bodies.len()).flat_map(|b| self.equations(b));
        all.extend(equations.zip(1..).map(|(sides, n)| named(format!("({n})"), sides)));
        for body in 0..if moments { self.bodies.len() } else { 0 } {
            all.extend(self.moments_about_joints(body));
        }
        all
    }
    /// Moments on a body about each of its joints, which the force there has none about.
    fn moments_about_joints(&mut self, body: usize) -> Vec<Row> {
        let scene = self.scene;
        let spots = scene.joints.iter().flat_map(|j| j.kind.spots()).filter(|spot| spot.body == body);
        let (mut all, it) = (Vec::<Row>::new(), self.bodies[body].clone());
        let (Some(alpha), None) = (it.alpha, &self.pivot) else { return all };
        for spot in spots {
            let Some((_, point)) = scene.point_name(spot) else { continue };
            let name = self.phrase("order.moments", &[("point", &point), ("body", &it.name)]);
            let away = less(&self.centre(body), &self.spot(spot));
            let away = self.places(&away, self.here);
            let known = all.iter().any(|row| row.name == name);
            if known || away.iter().all(Sum::is_zero) {
                continue;
            }
            let sense = self.sense_of(body);
            let turns =
                self.on(body).map(|p| p.size.each(&p.turn.plus(&cross(&away, &p.along)).signed(sense)));
            // Term by term, so that it can be solved for each of them.
            let left = positive_first(turns.sum::<Sum>().terms().iter().map(Factors::expr));
            let a = it.a.map(Sum::one);
            let moved = it.mass.each(&cross(&away, &a)).signed(sense).expr();
            let turned = sum(it.inertia.iter().map(|i| i.by(alpha)));
            let still = scene.end == End::Equilibrium;
            let right = if still { ZERO } else { positive_first([turned, moved]) };
            all.push(Row { at: 0, name, sides: (left, right), told: false });
        }
        all
    }
    /// The order in which the equations give the forces, once the acceleration of the leading body is known or by themselves; `None`
    /// where they have to be solved together for one of these quantities.
    fn in_order(&mut self, known: Option<SymbolId>, wanted: &[SymbolId]) -> Option<Vec<Found>> {
        let accelerations = self.accelerations();
        let mut rows = self.rows_in_order(true);
        let mut open = [accelerations.clone(), self.reactions()].concat();
        // Where a contact ends its force is known to be 0.
        let gone = self.leaves().and_then(|joint| self.of_joint(Quantity::Normal, joint));
        open.retain(|s| Some(*s) != known && Some(*s) != gone && !self.symbols.value(*s).is_nan());
        let mut all = Vec::new();
        if self.bodies.len() > 1 && (known.is_some() || self.driver.is_some()) {
            // The joints give all accelerations by that of the leading body.
            let name = self.phrase("order.joints", &[]);
            let joints = Row { at: 0, name, sides: (ZERO, ZERO), told: true };
            rows.retain(|row| row.name != joints.name);
            open.retain(|s| !accelerations.contains(s));
            let symbols = accelerations.into_iter().filter(|s| Some(*s) != known).collect();
            all.push(Found { rows: vec![joints], symbols, is: None });
        }
        all.extend(self.page.untangle(rows, &mut open, true));
        let behind = self.page.behind(wanted.to_vec(), |s| all.iter().any(|f| f.symbols.contains(&s)));
        behind.iter().all(|s| !open.contains(s)).then(|| needed(all, behind))
    }
    /// How these are told with their values: what was known before first, then in order, then what else is wanted; how each follows where
    /// that fits, and of what was solved for together where all that it follows from is told.
    fn lines_in_order(&self, order: &[Found], wanted: &[SymbolId], plain: bool) -> Vec<String> {
        let ordered: Vec<SymbolId> = order.iter().flat_map(|f| f.symbols.clone()).collect();
        let together = order.is_empty();
        let rest = wanted.iter().copied().filter(|s| !ordered.contains(s));
        let (first, last): (Vec<_>, Vec<_>) =
            rest.partition(|s| !together && self.bodies.iter().any(|b| b.alpha == Some(*s)));
        let (all, solved) = ([first, ordered, last].concat(), self.solved_for());
        let each = all.iter().map(|s| {
            let found = order.iter().find(|f| f.symbols.contains(s));
            let is = found.map_or_else(|| self.from(*s), |f| f.is.clone().unwrap_or_else(|| (*s).into()));
            let untold = together && is.uses().iter().any(|u| solved.contains(u) && !all.contains(u));
            let short = plain || untold || self.symbols.value(*s) == 0.0;
            self.chain(*s, &if short { (*s).into() } else { is })
        });
        each.collect()
    }
    /// What the equations are solved for.
    fn solved_for(&self) -> Vec<SymbolId> {
        [self.accelerations(), self.reactions()].concat()
    }
    /// Tells the forces and accelerations that are wanted, of a single body with all that is known besides, as far as the page has room:
    /// in the order in which the equations give them, or where no such order is found as all of them together do.
    pub fn tell_solved(&mut self, known: Option<SymbolId>, wanted: &[SymbolId], room: usize) {
        let several = self.bodies.len() > 1;
        let mut all = wanted.to_vec();
        if !several {
            let besides = self.solved_for().into_iter();
            all.extend(besides.filter(|s| !wanted.contains(s) && !self.symbols.value(*s).is_nan()));
        }
        let more = if several { room.max(LEAST) } else { room };
        for (wanted, last) in [(&all[..], several), (wanted, true)] {
            let Some(order) = self.in_order(known, wanted) else { continue };
            let mut lines = self.lines_in_order(&order, wanted, false);
            if packed(lines.clone()).len() > more {
                if !last {
                    continue;
                }
                lines = self.lines_in_order(&order, wanted, true);
            }
            self.page.say_order(&order);
            self.page.formulas_or_one(lines);
            self.page.follow(&order);
            self.skip_new();
            return;
        }
        self.say("joined.together", &[]);
        let lines = [&all[..], wanted].map(|told| self.lines_in_order(&[], told, false));
        let fits = packed(lines[0].clone()).len() <= room;
        let [whole, asked] = lines;
        self.page.formulas_or_one(if fits { whole } else { asked });
        self.skip_new();
    }
}
