//! Particles that move as one body: the mass centre and the rotation about it, then the sum over the particles. About any other
//! point there is a cross term, which is shown for the particle whose velocity is known.
use crate::num::shown;
use crate::scene::{Label, Num, Owner, Quantity, Start};
use crate::solution::draft::{DerivedAnswer, Draft};
use crate::solution::expr::{Expr, SymbolId, ZERO, ratio, root, square, sum};
use crate::solution::page::Page;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{FIGURES, tex_digits};
use crate::solution::text::Block;

/// The lamina in symbols.
struct Lamina {
    body: usize,
    /// Index of the particle whose velocity is known.
    known: usize,
    names: Vec<String>,
    m: Vec<Expr>,
    x: Vec<Expr>,
    y: Vec<Expr>,
    vx: Expr,
    vy: Expr,
    spin: Expr,
}

/// Writes the sections of a lamina.
///
/// # Errors
/// What this derivation does not cover.
pub fn sections(draft: &mut Draft) -> Result<(), DerivationStop> {
    let lamina = read(draft)?;
    let mut page = Page::new(draft);
    page.begin("idea");
    page.say("lamina.idea", &[]);
    page.begin("sketch");
    page.out.blocks = vec![Block::Picture("scene".to_owned())];
    let (mass, _) = lamina.decomposition(&mut page);
    lamina.particles(&mut page);
    lamina.cross(&mut page, mass);
    page.begin("limits");
    page.say("lamina.limits", &[]);
    page.begin("onward");
    page.say("lamina.onward", &[]);
    page.end();
    Ok(())
}

fn read(draft: &mut Draft) -> Result<Lamina, DerivationStop> {
    let scene = draft.scene;
    if scene.bodies.len() != 1 {
        return Err(Beyond::Unfound.into());
    }
    let motion = scene.start.iter().find_map(|s| match s {
        Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s } => {
            Some((*body, *particle, *vx_m_s, *vy_m_s, *spin_rad_s))
        }
        Start::Speed(..) => None,
    });
    let Some((body, known, vx, vy, spin)) = motion else {
        return Err(Beyond::Unfound.into());
    };
    let particles = &scene.bodies[body].particles;
    let names: Vec<String> = particles.iter().map(|p| p.name.clone()).collect();
    let mut column = |of: &dyn Fn(usize) -> Num, letter: &str, unit: &str| -> Vec<Expr> {
        let each = (0..names.len()).map(|i| draft.number(of(i), &format!("{letter}_{{{}}}", names[i]), unit));
        each.collect()
    };
    let m = column(&|i| particles[i].mass_kg, "m", "kg");
    let x = column(&|i| particles[i].x_m, "x", "m");
    let y = column(&|i| particles[i].y_m, "y", "m");
    let vx = draft.number(vx, "v_x", "m/s");
    let vy = draft.number(vy, "v_y", "m/s");
    let spin = draft.number(spin, r"\omega", "rad/s");
    Ok(Lamina { body, known, names, m, x, y, vx, vy, spin })
}

/// What rounding leaves of a difference of equal places, SI; a particle of a problem is never so near.
const NOTHING: f64 = 1e-13;

/// A value as a cell of a table, without unit.
fn cell(draft: &Draft, value: f64) -> String {
    let value = if value.abs() < NOTHING { 0.0 } else { value };
    format!("${}$", tex_digits(&shown::significant(value, FIGURES), draft.words))
}

impl Lamina {
    fn label(&self, quantity: Quantity) -> Label {
        Label { quantity, of: Owner::Body(self.body) }
    }

    fn count(&self) -> usize {
        self.names.len()
    }

    /// A sum over the particles, as a quantity of its own, with how it is written.
    fn total(&self, page: &mut Page, tex: &str, unit: &str, term: &dyn Fn(usize) -> Expr) -> SymbolId {
        let all = sum((0..self.count()).map(term));
        let symbol = page.unknown(tex, unit);
        page.symbols.settle_by(symbol, &all);
        symbol
    }

    /// Velocity of a particle.
    fn velocity(&self, i: usize) -> (Expr, Expr) {
        let k = self.known;
        let (dx, dy) = (&self.x[i] - &self.x[k], &self.y[i] - &self.y[k]);
        (&self.vx - &self.spin * dy, &self.vy + &self.spin * dx)
    }

    /// A table with a row for each particle: its name, and these cells, of which the first are data.
    fn table(&self, page: &mut Page, head: &[&str], given: usize, cells: &dyn Fn(usize) -> Vec<Expr>) {
        let mut rows = vec![head.iter().map(|c| format!("${c}$")).collect()];
        for (i, name) in self.names.iter().enumerate() {
            let cells = cells(i).into_iter().enumerate().map(|(column, e)| match e {
                Expr::Symbol(s) if column < given => {
                    let shown = page.symbols.shown(s);
                    format!("${}$", shown.split(r"\ ").next().unwrap_or_default())
                }
                e => cell(page.draft, page.value(&e)),
            });
            rows.push(std::iter::once(format!("${name}$")).chain(cells).collect());
        }
        page.table(rows);
    }

    // -- the mass centre and the rotation about it ------------------------------------------------------------------------

    fn decomposition(&self, page: &mut Page) -> (SymbolId, SymbolId) {
        page.begin_as("short", "short_lamina");
        page.say("lamina.centre", &[]);
        let mass_sum = self.total(page, r"\sum m_i", "kg", &|i| self.m[i].clone());
        let moment = |page: &mut Page, letter: &str, c: &[Expr]| {
            let tex = format!(r"\sum m_i\,{letter}_i");
            self.total(page, &tex, "kg m", &|i| &self.m[i] * &c[i])
        };
        let (mx, my) = (moment(page, "x", &self.x), moment(page, "y", &self.y));
        let mass = page.find(&["m", "M"], "kg", mass_sum);
        let x = page.find(&["x_G"], "m", mx / mass);
        let y = page.find(&["y_G"], "m", my / mass);
        let from_centre = |i: usize| (&self.x[i] - x, &self.y[i] - y);
        let arm = |i: usize| {
            let (dx, dy) = from_centre(i);
            square(dx) + square(dy)
        };
        let head = [
            "i",
            r"m_i\ (\mathrm{kg})",
            r"x_i\ (\mathrm{m})",
            r"y_i\ (\mathrm{m})",
            r"m_i\,x_i\ (\mathrm{kg}\,\mathrm{m})",
            r"m_i\,y_i\ (\mathrm{kg}\,\mathrm{m})",
            r"\rho_i\ (\mathrm{m})",
            r"m_i\,\rho_i^{2}\ (\mathrm{kg}\,\mathrm{m}^{2})",
        ];
        self.table(page, &head, 3, &|i| {
            let (m, x, y) = (&self.m[i], &self.x[i], &self.y[i]);
            vec![m.clone(), x.clone(), y.clone(), m * x, m * y, root(arm(i)), m * arm(i)]
        });
        page.formula(r"\rho_i = \sqrt{\left(x_i - x_G\right)^{2} + \left(y_i - y_G\right)^{2}}".to_owned());
        let own_sum = self.total(page, r"\sum m_i\,\rho_i^{2}", "kg m^2", &|i| &self.m[i] * arm(i));
        let own = page.find(&["I_G"], "kg m^2", own_sum);
        for symbol in [mass, x, y, own] {
            let from = page.steps.iter().find(|s| s.symbol == symbol).map(|s| s.from.clone());
            page.display(symbol, &from.unwrap_or(ZERO), "");
        }
        for (quantity, symbol) in [(Quantity::XG, x), (Quantity::YG, y), (Quantity::IG, own)] {
            page.answer(self.label(quantity), DerivedAnswer::Value(symbol));
        }
        let k = self.known;
        let known = format!("${}$", self.names[k]);
        page.say("lamina.velocity", &[("known", &known)]);
        let vx = &self.vx - &self.spin * (y - &self.y[k]);
        let vy = &self.vy + &self.spin * (x - &self.x[k]);
        let vx = page.find(&["v_{Gx}"], "m/s", vx);
        let vy = page.find(&["v_{Gy}"], "m/s", vy);
        page.tell_new();
        page.say("lamina.split", &[]);
        let centre = ratio(1, 2) * mass * (square(vx) + square(vy));
        let turning = ratio(1, 2) * own * square(&self.spin);
        let energy = page.find(&["T", "E"], "J", centre + turning);
        page.answer(
            Label { quantity: Quantity::KineticEnergy, of: Owner::Scene },
            DerivedAnswer::Value(energy),
        );
        page.tell_new();
        (mass, energy)
    }

    // -- the sum over the particles, and why about G ------------------------------------------------------------------------

    fn particles(&self, page: &mut Page) {
        page.begin_as("long", "long_lamina");
        let known = format!("${}$", self.names[self.known]);
        page.say("lamina.velocities", &[("known", &known)]);
        let (vx, vy, spin) = (page.tex(&self.vx), page.tex(&self.vy), page.tex(&self.spin));
        let (xk, yk) = (page.tex(&self.x[self.known]), page.tex(&self.y[self.known]));
        page.formula(format!(r"v_{{x,i}} = {vx} - {spin}\,\left(y_i - {yk}\right)"));
        page.formula(format!(r"v_{{y,i}} = {vy} + {spin}\,\left(x_i - {xk}\right)"));
        let speed = |i: usize| {
            let (ux, uy) = self.velocity(i);
            square(ux) + square(uy)
        };
        let share = |i: usize| ratio(1, 2) * &self.m[i] * speed(i);
        let head = [
            "i",
            r"v_{x,i}\ (\mathrm{m}/\mathrm{s})",
            r"v_{y,i}\ (\mathrm{m}/\mathrm{s})",
            r"v_i\ (\mathrm{m}/\mathrm{s})",
            r"\tfrac{1}{2}\,m_i\,v_i^{2}\ (\mathrm{J})",
        ];
        self.table(page, &head, 0, &|i| {
            let (ux, uy) = self.velocity(i);
            vec![ux, uy, root(speed(i)), share(i)]
        });
        page.formula(r"v_i = \sqrt{v_{x,i}^{2} + v_{y,i}^{2}}".to_owned());
        let energy = self.total(page, r"\sum \tfrac{1}{2}\,m_i\,v_i^{2}", "J", &share);
        let again = page.find(&["T", "E"], "J", energy);
        page.display(again, &energy.into(), "");
    }

    fn cross(&self, page: &mut Page, mass: SymbolId) {
        page.begin_as("why", "which");
        let known = format!("${}$", self.names[self.known]);
        let (n, count) = (self.count().to_string(), (2 * self.count()).to_string());
        page.say("lamina.why", &[("n", &n), ("count", &count)]);
        page.say("lamina.cross", &[("known", &known)]);
        let k = self.known;
        let named = |tex: &str| page.symbols.named(tex);
        let (Some(x), Some(y)) = (named("x_G"), named("y_G")) else { return };
        let cross = mass * &self.spin * (&self.vy * (x - &self.x[k]) - &self.vx * (y - &self.y[k]));
        page.find(&[r"T_{\times}", r"E_{\times}"], "J", cross);
        page.tell_new();
    }
}
