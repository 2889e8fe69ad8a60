//! Particles that move as one body, worked: the sum over the particles; then the mass centre and the rotation about it. About
//! any other point there is a cross term, which is shown for the particle whose velocity is known.
use crate::num::shown;
use crate::scene::{Label, Num, Owner, Quantity, Start};
use crate::solution::draft::Draft;
use crate::solution::expr::{Expr, SymbolId, ratio, root, square, sum};
use crate::solution::section_writer::SectionWriter;
use crate::solution::stop::{Beyond, DerivationStop};
use crate::solution::symbols::{FIGURES, tex_digits};

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
    kinetic: String,
}

/// Writes the sections of a lamina.
///
/// # Errors
/// What this derivation does not cover.
pub fn work(draft: &mut Draft) -> Result<(), DerivationStop> {
    let lamina = read(draft)?;
    let mass = lamina.particles(draft);
    lamina.decomposition(draft, mass);
    Ok(())
}

fn read(draft: &mut Draft) -> Result<Lamina, DerivationStop> {
    let scene = draft.scene;
    if scene.bodies.len() != 1 {
        return Err(Beyond::LaminaInCompany.into());
    }
    let motion = scene.start.iter().find_map(|s| match s {
        Start::Lamina { body, particle, vx_m_s, vy_m_s, spin_rad_s } => {
            Some((*body, *particle, *vx_m_s, *vy_m_s, *spin_rad_s))
        }
        Start::Speed(..) => None,
    });
    let Some((body, known, vx, vy, spin)) = motion else {
        return Err(Beyond::LaminaWithoutMotion.into());
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
    let kinetic = draft.free(&["T", "E"]);
    Ok(Lamina { body, known, names, m, x, y, vx, vy, spin, kinetic })
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

    fn energy_label() -> Label {
        Label { quantity: Quantity::KineticEnergy, of: Owner::Scene }
    }

    fn count(&self) -> usize {
        self.names.len()
    }

    /// A sum over the particles, as a quantity of its own, with how it is written.
    fn total(
        &self,
        page: &mut SectionWriter,
        tex: &str,
        unit: &str,
        term: &dyn Fn(usize) -> Expr,
    ) -> SymbolId {
        let all = sum((0..self.count()).map(term));
        page.quiet(tex, unit, &all)
    }

    /// Velocity of a particle.
    fn velocity(&self, i: usize) -> (Expr, Expr) {
        let k = self.known;
        let (dx, dy) = (&self.x[i] - &self.x[k], &self.y[i] - &self.y[k]);
        (&self.vx - &self.spin * dy, &self.vy + &self.spin * dx)
    }

    /// A table with a row for each particle: its name, and these cells, of which the first are data.
    fn table(
        &self,
        page: &mut SectionWriter,
        head: &[&str],
        given: usize,
        cells: &dyn Fn(usize) -> Vec<Expr>,
    ) {
        let mut rows = vec![head.iter().map(|c| format!("${c}$")).collect()];
        for (i, name) in self.names.iter().enumerate() {
            let cells = cells(i).into_iter().enumerate().map(|(column, e)| match e {
                Expr::Symbol(s) if column < given => {
                    let shown = page.draft.symbols.shown(s);
                    format!("${}$", shown.split(r"\ ").next().unwrap_or_default())
                }
                e => cell(page.draft, page.value(&e)),
            });
            rows.push(std::iter::once(format!("${name}$")).chain(cells).collect());
        }
        page.table(rows);
    }

    // -- the sum over the particles ---------------------------------------------------------------------------------------

    /// Returns the whole mass, which the other method needs too.
    fn particles(&self, draft: &mut Draft) -> SymbolId {
        let mut page = SectionWriter::new(draft, "eom", "lamina.title_sum");
        page.picture("scene");
        let known = format!("${}$", self.names[self.known]);

        page.say("lamina.centre", &[]);
        let head = [
            "i",
            r"m_i\ (\mathrm{kg})",
            r"x_i\ (\mathrm{m})",
            r"y_i\ (\mathrm{m})",
            r"m_i\,x_i\ (\mathrm{kg}\,\mathrm{m})",
            r"m_i\,y_i\ (\mathrm{kg}\,\mathrm{m})",
        ];
        self.table(&mut page, &head, 3, &|i| {
            let (m, x, y) = (&self.m[i], &self.x[i], &self.y[i]);
            vec![m.clone(), x.clone(), y.clone(), m * x, m * y]
        });
        let mass_name = page.free(&["m", "M"]);
        let mass = self.total(&mut page, r"\sum m_i", "kg", &|i| self.m[i].clone());
        let moment = |page: &mut SectionWriter, letter: &str, c: &[Expr]| {
            let tex = format!(r"\sum m_i\,{letter}_i");
            self.total(page, &tex, "kg m", &|i| &self.m[i] * &c[i])
        };
        let (mx, my) = (moment(&mut page, "x", &self.x), moment(&mut page, "y", &self.y));
        let mass = page.find(&mass_name, "kg", mass);
        let x = page.find("x_G", "m", mx / mass);
        let y = page.find("y_G", "m", my / mass);
        page.motion(self.label(Quantity::XG), x);
        page.motion(self.label(Quantity::YG), y);

        // Inertia about the mass centre.
        page.say("lamina.inertia", &[]);
        page.formula(r"\rho_i = \sqrt{\left(x_i - x_G\right)^{2} + \left(y_i - y_G\right)^{2}}");
        let from_centre = |i: usize| (&self.x[i] - x, &self.y[i] - y);
        let arm = |i: usize| {
            let (dx, dy) = from_centre(i);
            square(dx) + square(dy)
        };
        let head = [
            "i",
            r"x_i - x_G\ (\mathrm{m})",
            r"y_i - y_G\ (\mathrm{m})",
            r"\rho_i\ (\mathrm{m})",
            r"m_i\,\rho_i^{2}\ (\mathrm{kg}\,\mathrm{m}^{2})",
        ];
        self.table(&mut page, &head, 0, &|i| {
            let (dx, dy) = from_centre(i);
            vec![dx, dy, root(arm(i)), &self.m[i] * arm(i)]
        });
        let own_sum = self.total(&mut page, r"\sum m_i\,\rho_i^{2}", "kg m^2", &|i| &self.m[i] * arm(i));
        let own = page.find("I_G", "kg m^2", own_sum);
        page.motion(self.label(Quantity::IG), own);

        // Velocities.
        page.say("lamina.velocities", &[("known", &known)]);
        let (vx, vy, spin) = (page.tex(&self.vx), page.tex(&self.vy), page.tex(&self.spin));
        let (xk, yk) = (page.tex(&self.x[self.known]), page.tex(&self.y[self.known]));
        page.formula(format!(r"v_{{x,i}} = {vx} - {spin}\,\left(y_i - {yk}\right)"));
        page.formula(format!(r"v_{{y,i}} = {vy} + {spin}\,\left(x_i - {xk}\right)"));
        page.formula(r"v_i = \sqrt{v_{x,i}^{2} + v_{y,i}^{2}}");
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
        self.table(&mut page, &head, 0, &|i| {
            let (ux, uy) = self.velocity(i);
            vec![ux, uy, root(speed(i)), share(i)]
        });
        let energy = self.total(&mut page, r"\sum \tfrac{1}{2}\,m_i\,v_i^{2}", "J", &share);
        let energy = page.find(&self.kinetic, "J", energy);
        page.motion(Self::energy_label(), energy);
        page.done();
        mass
    }

    // -- the mass centre and the rotation about it ------------------------------------------------------------------------

    fn decomposition(&self, draft: &mut Draft, mass: SymbolId) {
        let mut page = SectionWriter::new(draft, "energy", "lamina.title_split");
        let k = self.known;
        let known = format!("${}$", self.names[k]);
        let name = &self.names[k];
        // The mass centre as seen from the known particle.
        page.say("lamina.seen", &[("known", &known)]);
        let seen = |page: &mut SectionWriter, letter: &str, c: &[Expr]| {
            let tex = format!(r"\sum m_i\,\left({letter}_i - {}\right)", page.tex(&c[k]));
            let moment = self.total(page, &tex, "kg m", &|i| &self.m[i] * (&c[i] - &c[k]));
            let tex = format!(r"\Delta {letter}");
            page.find(&tex, "m", moment / mass)
        };
        let dx = seen(&mut page, "x", &self.x);
        let dy = seen(&mut page, "y", &self.y);
        let x = page.find("x_G", "m", &self.x[k] + dx);
        let y = page.find("y_G", "m", &self.y[k] + dy);
        page.energy(self.label(Quantity::XG), x);
        page.energy(self.label(Quantity::YG), y);
        page.say("lamina.velocity", &[]);
        let vx = &self.vx - &self.spin * dy;
        let vy = &self.vy + &self.spin * dx;
        let vx = page.find("v_{Gx}", "m/s", &vx);
        let vy = page.find("v_{Gy}", "m/s", &vy);

        // The inertia by parallel axes from the known particle.
        page.say("lamina.parallel", &[("known", &known)]);
        let about_tex = format!("I_{{{name}}}");
        let arm = |i: usize| square(&self.x[i] - &self.x[k]) + square(&self.y[i] - &self.y[k]);
        let tex = format!(
            r"\sum m_i\,\left(\left(x_i - {}\right)^{{2}} + \left(y_i - {}\right)^{{2}}\right)",
            page.tex(&self.x[k]),
            page.tex(&self.y[k])
        );
        let about = self.total(&mut page, &tex, "kg m^2", &|i| &self.m[i] * arm(i));
        let about = page.find(&about_tex, "kg m^2", about);
        let distance = square(dx) + square(dy);
        let moved = mass * distance;
        let own = page.find("I_G", "kg m^2", about - moved);
        page.energy(self.label(Quantity::IG), own);

        // The decomposition.
        page.say("lamina.split", &[]);
        let centre = ratio(1, 2) * mass * (square(vx) + square(vy));
        let turning = ratio(1, 2) * own * square(&self.spin);
        let centre = page.find(&format!("{}_v", self.kinetic), "J", &centre);
        let turning = page.find(&format!(r"{}_{{\omega}}", self.kinetic), "J", &turning);
        let energy = page.find(&self.kinetic, "J", centre + turning);
        page.energy(Self::energy_label(), energy);

        // The cross term about the known particle.
        page.say("lamina.cross", &[("known", &known)]);
        let cross = mass * &self.spin * (&self.vy * dx - &self.vx * dy);
        let cross_tex = format!(r"{}_{{\times}}", self.kinetic);
        let cross = page.find(&cross_tex, "J", &cross);
        let first = ratio(1, 2) * mass * (square(&self.vx) + square(&self.vy));
        let last = ratio(1, 2) * about * square(&self.spin);
        page.find(&self.kinetic, "J", first + cross + last);
        page.say("lamina.same", &[]);
        page.done();
    }
}
