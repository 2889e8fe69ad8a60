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
use crate::solution::expr::Symbol;
use crate::solution::expr::ratio;
use crate::solution::expr::root;
use crate::solution::expr::square;
use crate::solution::expr::sum;
use crate::solution::pen::Pen;
use crate::solution::quantities::FIGURES;
use crate::solution::quantities::tex_digits;
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
        let (dx, dy) = (&self.x[i] - &self.x[k], &self.y[i] - &self.y[k]);
        (&self.vx - &self.spin * dy, &self.vy + &self.spin * dx)
    }

    /// A table with a row for each particle: its name, and these cells, of which the first are data.
    fn table(&self, pen: &mut Pen, head: &[&str], given: usize, cells: &dyn Fn(usize) -> Vec<Expr>) {
        let mut rows = vec![head.iter().map(|c| format!("${c}$")).collect()];
        for (i, name) in self.names.iter().enumerate() {
            let cells = cells(i).into_iter().enumerate().map(|(column, e)| match e {
                Expr::Symbol(s) if column < given => {
                    let shown = pen.desk.ledger.shown(s);
                    format!("${}$", shown.split(r"\ ").next().unwrap_or_default())
                }
                e => cell(pen.desk, pen.value(&e)),
            });
            rows.push(std::iter::once(format!("${name}$")).chain(cells).collect());
        }
        pen.table(rows);
    }

    // -- the sum over the particles ---------------------------------------------------------------------------------------

    /// Returns the whole mass, which the other method needs too.
    fn particles(&self, desk: &mut Desk) -> Symbol {
        let mut pen = Pen::new(desk, "eom", "lamina.title_sum");
        pen.picture("scene");
        let known = format!("${}$", self.names[self.known]);

        pen.say("lamina.centre", &[]);
        let head = [
            "i",
            r"m_i\ (\mathrm{kg})",
            r"x_i\ (\mathrm{m})",
            r"y_i\ (\mathrm{m})",
            r"m_i\,x_i\ (\mathrm{kg}\,\mathrm{m})",
            r"m_i\,y_i\ (\mathrm{kg}\,\mathrm{m})",
        ];
        self.table(&mut pen, &head, 3, &|i| {
            let (m, x, y) = (&self.m[i], &self.x[i], &self.y[i]);
            vec![m.clone(), x.clone(), y.clone(), m * x, m * y]
        });
        let mass_name = pen.desk.free(&["m", "M"]);
        let mass = self.total(&mut pen, r"\sum m_i", "kg", &|i| self.m[i].clone());
        let moment = |pen: &mut Pen, letter: &str, c: &[Expr]| {
            let tex = format!(r"\sum m_i\,{letter}_i");
            self.total(pen, &tex, "kg m", &|i| &self.m[i] * &c[i])
        };
        let (mx, my) = (moment(&mut pen, "x", &self.x), moment(&mut pen, "y", &self.y));
        let mass = pen.find(&mass_name, "kg", mass);
        let x = pen.find("x_G", "m", mx / mass);
        let y = pen.find("y_G", "m", my / mass);
        pen.motion(self.label(Quantity::XG), x);
        pen.motion(self.label(Quantity::YG), y);

        // Inertia about the mass centre.
        pen.say("lamina.inertia", &[]);
        pen.formula(r"\rho_i = \sqrt{\left(x_i - x_G\right)^{2} + \left(y_i - y_G\right)^{2}}");
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
        self.table(&mut pen, &head, 0, &|i| {
            let (dx, dy) = from_centre(i);
            vec![dx, dy, root(arm(i)), &self.m[i] * arm(i)]
        });
        let own_sum = self.total(&mut pen, r"\sum m_i\,\rho_i^{2}", "kg m^2", &|i| &self.m[i] * arm(i));
        let own = pen.find("I_G", "kg m^2", own_sum);
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
        self.table(&mut pen, &head, 0, &|i| {
            let (ux, uy) = self.velocity(i);
            vec![ux, uy, root(speed(i)), share(i)]
        });
        let energy = self.total(&mut pen, r"\sum \tfrac{1}{2}\,m_i\,v_i^{2}", "J", &share);
        let energy = pen.find(&self.kinetic, "J", energy);
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
            let moment = self.total(pen, &tex, "kg m", &|i| &self.m[i] * (&c[i] - &c[k]));
            let tex = format!(r"\Delta {letter}");
            pen.find(&tex, "m", moment / mass)
        };
        let dx = seen(&mut pen, "x", &self.x);
        let dy = seen(&mut pen, "y", &self.y);
        let x = pen.find("x_G", "m", &self.x[k] + dx);
        let y = pen.find("y_G", "m", &self.y[k] + dy);
        pen.energy(self.label(Quantity::XG), x);
        pen.energy(self.label(Quantity::YG), y);
        pen.say("lamina.velocity", &[]);
        let vx = &self.vx - &self.spin * dy;
        let vy = &self.vy + &self.spin * dx;
        let vx = pen.find("v_{Gx}", "m/s", &vx);
        let vy = pen.find("v_{Gy}", "m/s", &vy);

        // The inertia by parallel axes from the known particle.
        pen.say("lamina.parallel", &[("known", &known)]);
        let about_tex = format!("I_{{{name}}}");
        let arm = |i: usize| square(&self.x[i] - &self.x[k]) + square(&self.y[i] - &self.y[k]);
        let tex = format!(
            r"\sum m_i\,\left(\left(x_i - {}\right)^{{2}} + \left(y_i - {}\right)^{{2}}\right)",
            pen.tex(&self.x[k]),
            pen.tex(&self.y[k])
        );
        let about = self.total(&mut pen, &tex, "kg m^2", &|i| &self.m[i] * arm(i));
        let about = pen.find(&about_tex, "kg m^2", about);
        let distance = square(dx) + square(dy);
        let moved = mass * distance;
        let own = pen.find("I_G", "kg m^2", about - moved);
        pen.energy(self.label(Quantity::IG), own);

        // The decomposition.
        pen.say("lamina.split", &[]);
        let centre = ratio(1, 2) * mass * (square(vx) + square(vy));
        let turning = ratio(1, 2) * own * square(&self.spin);
        let centre = pen.find(&format!("{}_v", self.kinetic), "J", &centre);
        let turning = pen.find(&format!(r"{}_{{\omega}}", self.kinetic), "J", &turning);
        let energy = pen.find(&self.kinetic, "J", centre + turning);
        pen.energy(Self::energy_label(), energy);

        // The cross term about the known particle.
        pen.say("lamina.cross", &[("known", &known)]);
        let cross = mass * &self.spin * (&self.vy * dx - &self.vx * dy);
        let cross_tex = format!(r"{}_{{\times}}", self.kinetic);
        let cross = pen.find(&cross_tex, "J", &cross);
        let first = ratio(1, 2) * mass * (square(&self.vx) + square(&self.vy));
        let last = ratio(1, 2) * about * square(&self.spin);
        pen.find(&self.kinetic, "J", first + cross + last);
        pen.say("lamina.same", &[]);
        pen.done();
    }
}
