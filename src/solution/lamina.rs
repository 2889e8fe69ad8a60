//! Particles that move as one body, worked: the sum over the particles; then the mass centre and the rotation about it. About
//! any other point there is a cross term, which is shown for the particle whose velocity is known.
use crate::scene::Label;
use crate::scene::Num;
use crate::scene::Owner;
use crate::scene::Quantity;
use crate::scene::Start;
use crate::sheet::number;
use crate::solution::desk::Desk;
use crate::solution::expr::Expr;
use crate::solution::expr::ZERO;
use crate::solution::expr::difference;
use crate::solution::expr::product;
use crate::solution::expr::quotient;
use crate::solution::expr::ratio;
use crate::solution::expr::root;
use crate::solution::expr::square;
use crate::solution::expr::sum;
use crate::solution::ledger::FIGURES;
use crate::solution::ledger::Symbol;
use crate::solution::ledger::tex_digits;
use crate::solution::pen::Pen;
use crate::solution::stop::Beyond;
use crate::solution::stop::Stop;

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
pub fn work(desk: &mut Desk) -> Result<(), Stop> {
    let lamina = read(desk)?;
    let mass = lamina.particles(desk);
    lamina.decomposition(desk, mass);
    Ok(())
}

fn read(desk: &mut Desk) -> Result<Lamina, Stop> {
    let scene = desk.scene;
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
        let each = (0..names.len()).map(|i| desk.number(of(i), &format!("{letter}_{{{}}}", names[i]), unit));
        each.collect()
    };
    let m = column(&|i| particles[i].mass_kg, "m", "kg");
    let x = column(&|i| particles[i].x_m, "x", "m");
    let y = column(&|i| particles[i].y_m, "y", "m");
    let vx = desk.number(vx, "v_x", "m/s");
    let vy = desk.number(vy, "v_y", "m/s");
    let spin = desk.number(spin, r"\omega", "rad/s");
    let kinetic = desk.free(&["T", "E"]);
    Ok(Lamina { body, known, names, m, x, y, vx, vy, spin, kinetic })
}

/// What rounding leaves of a difference of equal places, SI; a particle of a problem is never so near.
const NOTHING: f64 = 1e-13;

/// A value as a cell of a table, without unit.
fn cell(desk: &Desk, value: f64) -> String {
    let value = if value.abs() < NOTHING { 0.0 } else { value };
    format!("${}$", tex_digits(&number::rounded(value, FIGURES), desk.words))
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
    fn total(&self, pen: &mut Pen, tex: &str, unit: &str, term: &dyn Fn(usize) -> Expr) -> Symbol {
        let all = sum((0..self.count()).map(term));
        pen.quiet(tex, unit, &all)
    }

    /// Velocity of a particle.
    fn velocity(&self, i: usize) -> (Expr, Expr) {
        let k = self.known;
        let (dx, dy) = (
            difference(self.x[i].clone(), self.x[k].clone()),
            difference(self.y[i].clone(), self.y[k].clone()),
        );
        (
            difference(self.vx.clone(), product([self.spin.clone(), dy])),
            sum([self.vy.clone(), product([self.spin.clone(), dx])]),
        )
    }

    /// A row of the head of a table: LaTeX cells.
    fn head(cells: &[&str]) -> Vec<String> {
        cells.iter().map(|c| format!("${c}$")).collect()
    }

    // -- the sum over the particles ---------------------------------------------------------------------------------------

    /// Returns the whole mass, which the other method needs too.
    fn particles(&self, desk: &mut Desk) -> Symbol {
        let mut pen = Pen::new(desk, "eom", "lamina.title_sum");
        pen.picture("scene");
        let value = |pen: &Pen, e: &Expr| pen.value(e);
        let known = format!("${}$", self.names[self.known]);

        pen.say("lamina.centre", &[]);
        let mut rows = vec![Self::head(&[
            "i",
            r"m_i\ (\mathrm{kg})",
            r"x_i\ (\mathrm{m})",
            r"y_i\ (\mathrm{m})",
            r"m_i\,x_i\ (\mathrm{kg}\,\mathrm{m})",
            r"m_i\,y_i\ (\mathrm{kg}\,\mathrm{m})",
        ])];
        for i in 0..self.count() {
            let given = |e: &Expr| match e {
                Expr::Symbol(s) => {
                    let shown = pen.desk.ledger.shown(*s);
                    let digits = shown.split(r"\ ").next().unwrap_or_default().to_owned();
                    format!("${digits}$")
                }
                _ => "$0$".to_owned(),
            };
            let moment = |c: &Expr| cell(pen.desk, value(&pen, &product([self.m[i].clone(), c.clone()])));
            rows.push(vec![
                format!("${}$", self.names[i]),
                given(&self.m[i]),
                given(&self.x[i]),
                given(&self.y[i]),
                moment(&self.x[i]),
                moment(&self.y[i]),
            ]);
        }
        pen.table(rows);
        let mass_name = pen.desk.free(&["m", "M"]);
        let mass = self.total(&mut pen, r"\sum m_i", "kg", &|i| self.m[i].clone());
        let moment = |pen: &mut Pen, letter: &str, c: &[Expr]| {
            let tex = format!(r"\sum m_i\,{letter}_i");
            self.total(pen, &tex, "kg m", &|i| product([self.m[i].clone(), c[i].clone()]))
        };
        let (mx, my) = (moment(&mut pen, "x", &self.x), moment(&mut pen, "y", &self.y));
        let mass = pen.find(&mass_name, "kg", &mass.into());
        let x = pen.find("x_G", "m", &quotient(mx.into(), mass.into()));
        let y = pen.find("y_G", "m", &quotient(my.into(), mass.into()));
        pen.motion(self.label(Quantity::XG), x);
        pen.motion(self.label(Quantity::YG), y);

        // Inertia about the mass centre.
        pen.say("lamina.inertia", &[]);
        pen.formula(r"\rho_i = \sqrt{\left(x_i - x_G\right)^{2} + \left(y_i - y_G\right)^{2}}");
        let from_centre =
            |i: usize| (difference(self.x[i].clone(), x.into()), difference(self.y[i].clone(), y.into()));
        let arm = |i: usize| {
            let (dx, dy) = from_centre(i);
            sum([square(dx), square(dy)])
        };
        let mut rows = vec![Self::head(&[
            "i",
            r"x_i - x_G\ (\mathrm{m})",
            r"y_i - y_G\ (\mathrm{m})",
            r"\rho_i\ (\mathrm{m})",
            r"m_i\,\rho_i^{2}\ (\mathrm{kg}\,\mathrm{m}^{2})",
        ])];
        for i in 0..self.count() {
            let (dx, dy) = from_centre(i);
            let c = |e: &Expr| cell(pen.desk, value(&pen, e));
            rows.push(vec![
                format!("${}$", self.names[i]),
                c(&dx),
                c(&dy),
                c(&root(arm(i))),
                c(&product([self.m[i].clone(), arm(i)])),
            ]);
        }
        pen.table(rows);
        let own_sum = self
            .total(&mut pen, r"\sum m_i\,\rho_i^{2}", "kg m^2", &|i| product([self.m[i].clone(), arm(i)]));
        let own = pen.find("I_G", "kg m^2", &own_sum.into());
        pen.motion(self.label(Quantity::IG), own);

        // Velocities.
        pen.say("lamina.velocities", &[("known", &known)]);
        let (vx, vy, spin) = (pen.tex(&self.vx), pen.tex(&self.vy), pen.tex(&self.spin));
        let (xk, yk) = (pen.tex(&self.x[self.known]), pen.tex(&self.y[self.known]));
        pen.formula(format!(r"v_{{x,i}} = {vx} - {spin}\,\left(y_i - {yk}\right)"));
        pen.formula(format!(r"v_{{y,i}} = {vy} + {spin}\,\left(x_i - {xk}\right)"));
        pen.formula(r"v_i = \sqrt{v_{x,i}^{2} + v_{y,i}^{2}}");
        let speed = |i: usize| {
            let (ux, uy) = self.velocity(i);
            sum([square(ux), square(uy)])
        };
        let share = |i: usize| product([ratio(1, 2), self.m[i].clone(), speed(i)]);
        let mut rows = vec![Self::head(&[
            "i",
            r"v_{x,i}\ (\mathrm{m}/\mathrm{s})",
            r"v_{y,i}\ (\mathrm{m}/\mathrm{s})",
            r"v_i\ (\mathrm{m}/\mathrm{s})",
            r"\tfrac{1}{2}\,m_i\,v_i^{2}\ (\mathrm{J})",
        ])];
        for i in 0..self.count() {
            let (ux, uy) = self.velocity(i);
            let c = |e: &Expr| cell(pen.desk, value(&pen, e));
            rows.push(vec![format!("${}$", self.names[i]), c(&ux), c(&uy), c(&root(speed(i))), c(&share(i))]);
        }
        pen.table(rows);
        let energy = self.total(&mut pen, r"\sum \tfrac{1}{2}\,m_i\,v_i^{2}", "J", &share);
        let energy = pen.find(&self.kinetic, "J", &energy.into());
        pen.motion(Self::energy_label(), energy);
        pen.done();
        mass
    }

    // -- the mass centre and the rotation about it ------------------------------------------------------------------------

    fn decomposition(&self, desk: &mut Desk, mass: Symbol) {
        let mut pen = Pen::new(desk, "energy", "lamina.title_split");
        let k = self.known;
        let known = format!("${}$", self.names[k]);
        let name = &self.names[k];
        // The mass centre as seen from the known particle.
        pen.say("lamina.seen", &[("known", &known)]);
        let seen = |pen: &mut Pen, letter: &str, c: &[Expr]| {
            let tex = format!(r"\sum m_i\,\left({letter}_i - {}\right)", pen.tex(&c[k]));
            let moment = self.total(pen, &tex, "kg m", &|i| {
                product([self.m[i].clone(), difference(c[i].clone(), c[k].clone())])
            });
            let tex = format!(r"\Delta {letter}");
            pen.find(&tex, "m", &quotient(moment.into(), mass.into()))
        };
        let dx = seen(&mut pen, "x", &self.x);
        let dy = seen(&mut pen, "y", &self.y);
        let x = pen.find("x_G", "m", &sum([self.x[k].clone(), dx.into()]));
        let y = pen.find("y_G", "m", &sum([self.y[k].clone(), dy.into()]));
        pen.energy(self.label(Quantity::XG), x);
        pen.energy(self.label(Quantity::YG), y);
        pen.say("lamina.velocity", &[]);
        let vx = difference(self.vx.clone(), product([self.spin.clone(), dy.into()]));
        let vy = sum([self.vy.clone(), product([self.spin.clone(), dx.into()])]);
        let vx = pen.find("v_{Gx}", "m/s", &vx);
        let vy = pen.find("v_{Gy}", "m/s", &vy);

        // The inertia by parallel axes from the known particle.
        pen.say("lamina.parallel", &[("known", &known)]);
        let about_tex = format!("I_{{{name}}}");
        let arm = |i: usize| {
            sum([
                square(difference(self.x[i].clone(), self.x[k].clone())),
                square(difference(self.y[i].clone(), self.y[k].clone())),
            ])
        };
        let tex = format!(
            r"\sum m_i\,\left(\left(x_i - {}\right)^{{2}} + \left(y_i - {}\right)^{{2}}\right)",
            pen.tex(&self.x[k]),
            pen.tex(&self.y[k])
        );
        let about = self.total(&mut pen, &tex, "kg m^2", &|i| product([self.m[i].clone(), arm(i)]));
        let about = pen.find(&about_tex, "kg m^2", &about.into());
        let distance = sum([square(dx.into()), square(dy.into())]);
        let moved = product([mass.into(), distance]);
        let own = pen.find("I_G", "kg m^2", &difference(about.into(), moved));
        pen.energy(self.label(Quantity::IG), own);

        // The decomposition.
        pen.say("lamina.split", &[]);
        let centre = product([ratio(1, 2), mass.into(), sum([square(vx.into()), square(vy.into())])]);
        let turning = product([ratio(1, 2), own.into(), square(self.spin.clone())]);
        let centre = pen.find(&format!("{}_v", self.kinetic), "J", &centre);
        let turning = pen.find(&format!(r"{}_{{\omega}}", self.kinetic), "J", &turning);
        let energy = pen.find(&self.kinetic, "J", &sum([Expr::from(centre), turning.into()]));
        pen.energy(Self::energy_label(), energy);

        // The cross term about the known particle.
        pen.say("lamina.cross", &[("known", &known)]);
        let cross = product([
            mass.into(),
            self.spin.clone(),
            difference(product([self.vy.clone(), dx.into()]), product([self.vx.clone(), dy.into()])),
        ]);
        let cross_tex = format!(r"{}_{{\times}}", self.kinetic);
        let cross = pen.find(&cross_tex, "J", &cross);
        let first = product([ratio(1, 2), mass.into(), sum([square_of(&self.vx), square_of(&self.vy)])]);
        let last = product([ratio(1, 2), about.into(), square(self.spin.clone())]);
        pen.find(&self.kinetic, "J", &sum([first, cross.into(), last]));
        pen.say("lamina.same", &[]);
        pen.done();
    }
}

fn square_of(e: &Expr) -> Expr {
    if *e == ZERO { ZERO } else { square(e.clone()) }
}
