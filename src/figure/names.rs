//! Symbols of unknown quantities in pictures of solutions, the same that the worked solutions use.
use crate::bank::Problem;
use crate::figure::picture::Run;
use crate::figure::symbol;
use crate::figure::view::View;
use crate::scene::Body;
use crate::scene::Far;
use crate::scene::Mass;
use crate::scene::Scene;
use crate::scene::Tie;

/// The first of these symbols that no datum bears; if all are taken, the last one with a star.
pub fn free(problem: &Problem, candidates: &[String]) -> String {
    let taken = |tex: &String| problem.data.iter().any(|d| d.tex == **tex);
    match candidates.iter().find(|c| !taken(c)) {
        Some(tex) => tex.clone(),
        None => candidates.last().map_or_else(String::new, |tex| format!("{tex}^{{*}}")),
    }
}

/// The symbol with something below it.
pub fn tagged(symbol: &str, tag: &str) -> String {
    if tag.is_empty() { symbol.to_owned() } else { format!("{symbol}_{{{tag}}}") }
}

/// What stands below the symbols of each body: the number at the end of its name, its first letter if no other body has it,
/// else its name.
fn tags(scene: &Scene) -> Vec<String> {
    let short = |name: &str| {
        let number = &name[name.trim_end_matches(|c: char| c.is_ascii_digit()).len()..];
        let initial = || name.chars().next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
        if number.is_empty() { initial() } else { number.to_owned() }
    };
    let shorts: Vec<String> = scene.bodies.iter().map(|b| short(&b.name)).collect();
    let tag = |(body, short): (&Body, &String)| {
        if shorts.iter().filter(|s| *s == short).count() > 1 {
            let plain: String = body.name.chars().filter(char::is_ascii_alphanumeric).collect();
            format!(r"\mathrm{{{plain}}}")
        } else {
            short.clone()
        }
    };
    scene.bodies.iter().zip(&shorts).map(tag).collect()
}

/// A quantity of a body: the first free of these symbols, with the body's tag where several bodies have one.
pub fn of_body(view: &View, body: usize, candidates: &[&str], has: impl Fn(&Body) -> bool) -> String {
    let several = view.scene.bodies.iter().filter(|b| has(b)).count() > 1;
    let tag = if several { tags(view.scene).get(body).cloned().unwrap_or_default() } else { String::new() };
    let names: Vec<String> = candidates.iter().map(|c| tagged(c, &tag)).collect();
    free(view.problem, &names)
}

/// Friction on a body.
pub fn friction(view: &View, body: usize) -> String {
    let contacts = view.scene.ties.iter().filter(|t| !matches!(t, Tie::Cord(_))).count();
    let tag =
        if contacts > 1 { tags(view.scene).get(body).cloned().unwrap_or_default() } else { String::new() };
    free(view.problem, &[tagged("F", &tag), tagged("R", &tag)])
}

/// Tension of a cord that is not pulled by a given force.
pub fn tension(view: &View, tie: usize) -> String {
    let unknown = |t: &Tie| matches!(t, Tie::Cord(c) if !matches!(c.to, Far::Pull(_)));
    let several = view.scene.ties.iter().filter(|t| unknown(t)).count() > 1;
    let number = view.scene.ties.iter().take(tie + 1).filter(|t| unknown(t)).count();
    let tag = if several { number.to_string() } else { String::new() };
    free(view.problem, &[tagged("T", &tag), tagged("S", &tag)])
}

/// Mass of a body.
pub fn mass(view: &View, body: usize) -> Vec<Run> {
    let this = &view.scene.bodies[body];
    let given = match &this.mass {
        Mass::Kilograms(n) => view.symbol(*n),
        Mass::Weight(_) | Mass::OfParts => Vec::new(),
    };
    if given.is_empty() { symbol::symbol(&of_body(view, body, &["m", "m_G"], |_| true)) } else { given }
}

/// Weight of a body: `mg`, or the symbol of a given weight.
pub fn weight(view: &View, body: usize) -> Vec<Run> {
    if let Mass::Weight(n) = &view.scene.bodies[body].mass {
        let symbol = view.symbol(*n);
        if !symbol.is_empty() {
            return symbol;
        }
    }
    let mut runs = mass(view, body);
    let g = view.symbol(view.scene.gravity_m_s2);
    runs.extend(if g.is_empty() { symbol::symbol("g") } else { g });
    runs
}

/// A symbol between bars where the value is negative: its arrow shows the actual sense.
pub fn magnitude(runs: Vec<Run>, negative: bool) -> Vec<Run> {
    if !negative {
        return runs;
    }
    let mut out = symbol::upright("|");
    out.extend(runs);
    out.extend(symbol::upright("|"));
    out
}
