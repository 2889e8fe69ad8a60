//! Names of bodies and cords in words, and symbols of unknown quantities in pictures of solutions, the same that the worked
//! solutions use. Ids of a bank are for who writes it: people read words.
use crate::bank::Problem;
use crate::figure::view::SceneView;
use crate::picture::{TextRun, symbol};
use crate::scene::{Body, Far, Joint, JointKind, Mass, Num, RotaryInertia, Scene, Shape, Slope, Tie};
use crate::words::Words;

/// What kind of body it is, in a word: by its id where that is a word that the language knows, else by what it is.
fn kind<'w>(words: &'w Words, scene: &Scene, index: usize) -> &'w str {
    let id = kind_id(words, scene, index);
    let known = format!("solution.body.{id}");
    if words.has(&known) { words.get(&known) } else { words.get(&format!("figure.{id}")) }
}

/// The name of this word.
fn kind_id<'b>(words: &Words, scene: &'b Scene, index: usize) -> &'b str {
    let body = &scene.bodies[index];
    let id = body.name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
    if words.has(&format!("solution.body.{id}")) {
        return id;
    }
    match &body.inertia {
        None if body.line.is_some_and(|l| !l.surface && l.slope == Slope::Vertical) => "load",
        None if is_particle(scene, index) => "particle",
        None => "block",
        Some(RotaryInertia::Shape(Shape::Rod, _)) => "rod",
        Some(RotaryInertia::Shape(Shape::Sphere | Shape::Shell, _)) => "ball",
        Some(RotaryInertia::Shape(Shape::Hoop, _)) => "hoop",
        Some(RotaryInertia::Shape(Shape::Disc, _)) if body.planar.as_ref().is_some_and(|p| !p.pinned) => {
            "disc"
        }
        Some(_) if body.planar.is_some() => "body",
        Some(_) if body.line.is_none() => "drum",
        Some(_) => "wheel",
    }
}

/// Is it a mass at a point of other bodies, or at the end of a cord or of a light rod?
pub(crate) fn is_particle(scene: &Scene, index: usize) -> bool {
    let mut holds = scene.joints.iter().filter(|j| j.kind.spots().any(|spot| spot.body == index)).peekable();
    let at_point =
        |j: &Joint| matches!(j.kind, JointKind::Hinge { .. } | JointKind::Cord { beyond: None, .. });
    scene.bodies[index].inertia.is_none() && holds.peek().is_some() && holds.all(at_point)
}

/// A body in words, as a heading: `Wheel`; of several of a kind `Load 2`, or `Block B` where their ids are letters.
pub fn body(words: &Words, scene: &Scene, index: usize) -> String {
    if index >= scene.bodies.len() {
        return String::new();
    }
    let word = kind(words, scene, index);
    let alike: Vec<usize> = (0..scene.bodies.len()).filter(|b| kind(words, scene, *b) == word).collect();
    if alike.len() < 2 {
        return word.to_owned();
    }
    let of = |b: usize| {
        let id = scene.bodies[b].name.as_str();
        let digits = &id[id.trim_end_matches(|c: char| c.is_ascii_digit()).len()..];
        if id.len() == 1 { id.to_uppercase() } else { digits.to_owned() }
    };
    let marks: Vec<String> = alike.iter().map(|b| of(*b)).collect();
    let told = marks.iter().enumerate().all(|(i, m)| !m.is_empty() && !marks[..i].contains(m));
    let mark = if told { of(index) } else { alike.iter().take_while(|b| **b <= index).count().to_string() };
    format!("{word} {mark}")
}

/// The same within a sentence.
pub fn body_within(words: &Words, scene: &Scene, index: usize) -> String {
    let name = body(words, scene, index);
    // German writes its nouns with capitals everywhere.
    match name.split_once(' ') {
        _ if words.language() != "en" => name,
        Some((word, mark)) => format!("{} {mark}", word.to_lowercase()),
        None => name.to_lowercase(),
    }
}

/// The same with its article, which one of several does not have: `load 2`.
pub fn the_body(words: &Words, scene: &Scene, index: usize) -> String {
    let name = body_within(words, scene, index);
    if name.is_empty() || name.contains(' ') {
        return name;
    }
    format!("{} {name}", words.get(&format!("solution.article.{}", kind_id(words, scene, index))))
}

/// The first of these symbols that no datum bears; if all are taken, the last one with a star.
pub fn free(problem: &Problem, candidates: &[String]) -> String {
    // x_1 and x_{1} look alike.
    let plain = |tex: &str| tex.replace(['{', '}'], "");
    let taken = |tex: &String| problem.data.iter().any(|d| plain(&d.tex) == plain(tex));
    match candidates.iter().find(|c| !taken(c)) {
        Some(tex) => tex.clone(),
        None => candidates.last().map_or_else(String::new, |tex| format!("{tex}^{{*}}")),
    }
}

/// The symbols of a size that the bank gives as an expression, best first: of a part of R that is r.
pub fn sizes(tex: &str) -> Vec<&str> {
    if tex == "R" { vec!["R", "r"] } else { vec![tex] }
}

/// The symbol with something below it, behind what stands there already.
pub fn tagged(tex: &str, mark: &str) -> String {
    if mark.is_empty() {
        return tex.to_owned();
    }
    let (base, raised) = tex.split_at(tex.find('^').unwrap_or(tex.len()));
    // An index within an accent belongs to what the accent stands on.
    let whole = |symbol: &str| symbol.matches('{').count() == symbol.matches('}').count();
    match base.split_once('_').filter(|(symbol, _)| whole(symbol)) {
        Some((symbol, below)) => {
            let within = below.strip_prefix('{').and_then(|b| b.strip_suffix('}')).unwrap_or(below);
            format!("{symbol}_{{{within},{mark}}}{raised}")
        }
        None => format!("{base}_{{{mark}}}{raised}"),
    }
}

/// What stands below the symbols of each body: the number at the end of its name, its first letter if no other body has it,
/// else its name.
/// Where the symbols of all masses have something below them that tells them apart, it is that.
pub fn tags(problem: &Problem, scene: &Scene) -> Vec<String> {
    let below = |body: &Body| match body.mass {
        Mass::Kilograms(Num::Datum(i)) => {
            let (_, below) = problem.data.get(i)?.tex.split_once('_')?;
            Some(below.trim_matches(['{', '}']).to_owned())
        }
        _ => None,
    };
    if let Some(below) = scene.bodies.iter().map(below).collect::<Option<Vec<String>>>()
        && below.iter().enumerate().all(|(i, tag)| !below[..i].contains(tag))
    {
        return below;
    }
    let short = |name: &str| {
        let number = &name[name.trim_end_matches(|c: char| c.is_ascii_digit()).len()..];
        let initial = || name.chars().next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
        if number.is_empty() { initial() } else { number.to_owned() }
    };
    let shorts: Vec<String> = scene.bodies.iter().map(|b| short(&b.name)).collect();
    let tag = |(body, short): (&Body, &String)| {
        if shorts.iter().filter(|s| *s == short).count() > 1 {
            let plain: String = body.name.chars().filter(char::is_ascii_alphanumeric).collect();
            if plain.len() == 1 { plain } else { format!(r"\mathrm{{{plain}}}") }
        } else {
            short.clone()
        }
    };
    scene.bodies.iter().zip(&shorts).map(tag).collect()
}

/// What stands below the symbols of the forces of a joint: nothing where no other has such forces, else the letter that it is called
/// by or the point that it holds, or the number of the joint where several would bear the same.
pub fn joint(scene: &Scene, index: usize) -> String {
    let struck = scene.is_struck();
    let kind = |j: &Joint| match j.kind {
        _ if struck => 0,
        JointKind::Pin { .. } | JointKind::Hinge { .. } => 1,
        JointKind::Guide { .. } | JointKind::Contact { .. } => 2,
        JointKind::Cord { .. } => 3,
    };
    let point = |j: &Joint| match j.kind.spots().next().and_then(|s| scene.point_name(s)) {
        Some((_, point)) if j.name.len() > 1 => point.to_owned(),
        _ => j.name.clone(),
    };
    let Some(this) = scene.joints.get(index) else { return String::new() };
    let alike: Vec<&Joint> = scene.joints.iter().filter(|j| kind(j) == kind(this)).collect();
    match point(this) {
        _ if alike.len() == 1 && !struck => String::new(),
        own if alike.iter().filter(|j| point(j) == own).count() > 1 => (index + 1).to_string(),
        own if own.len() == 1 => own,
        own => format!(r"\mathrm{{{own}}}"),
    }
}

/// A quantity of a body: the first free of these symbols, with the body's tag where several bodies have one.
pub fn of_body(view: &SceneView, body: usize, candidates: &[&str], has: impl Fn(&Body) -> bool) -> String {
    let tag = tag_among(view, body, several(view, has));
    let names: Vec<String> = candidates.iter().map(|c| tagged(c, &tag)).collect();
    free(view.problem, &names)
}

/// Are there several such bodies?
fn several(view: &SceneView, has: impl Fn(&Body) -> bool) -> bool {
    view.scene.bodies.iter().filter(|b| has(b)).count() > 1
}

/// The tag of a body where `several` have the quantity.
fn tag_among(view: &SceneView, body: usize, several: bool) -> String {
    let own = || tags(view.problem, view.scene).into_iter().nth(body);
    several.then(own).flatten().unwrap_or_default()
}

/// Acceleration of the mass centre of a body, or its component this way: as it is seen from what carries the scene.
pub(crate) fn acceleration(view: &SceneView, body: usize, way: &str) -> String {
    let tag = tag_among(view, body, several(view, |b| b.line.is_some() || b.planar.is_some()));
    let tag = match (view.scene.carried, format!("{tag}{way}")) {
        (None, tag) => tag,
        (Some(_), tag) if tag.is_empty() => r"\mathrm{rel}".to_owned(),
        (Some(_), tag) => format!(r"{tag},\mathrm{{rel}}"),
    };
    free(view.problem, &["a", "a_G"].map(|symbol| tagged(symbol, &tag)))
}

pub(crate) fn alpha(view: &SceneView, body: usize) -> String {
    of_body(view, body, &[r"\alpha", r"\dot{\omega}"], |b| b.turns)
}

pub(crate) fn friction(view: &SceneView, body: usize) -> String {
    let contacts = view.scene.ties.iter().filter(|t| !matches!(t, Tie::Cord(_))).count();
    let tag = tag_among(view, body, contacts > 1);
    free(view.problem, &[tagged("F", &tag), tagged("R", &tag), tagged("H", &tag)])
}

/// Tension of a cord that is not pulled by a given force.
pub fn tension(view: &SceneView, tie: usize) -> String {
    let unknown = |t: &Tie| matches!(t, Tie::Cord(c) if !matches!(c.to, Far::Pull(_)));
    let several = view.scene.ties.iter().filter(|t| unknown(t)).count() > 1;
    let number = view.scene.ties.iter().take(tie + 1).filter(|t| unknown(t)).count();
    let tag = if several { number.to_string() } else { String::new() };
    free(view.problem, &[tagged("T", &tag), tagged("S", &tag)])
}

pub(crate) fn mass(view: &SceneView, body: usize) -> Vec<TextRun> {
    let this = &view.scene.bodies[body];
    let given = match &this.mass {
        Mass::Kilograms(n) => view.symbol(*n),
        Mass::Weight(_) | Mass::OfParts => Vec::new(),
    };
    if !given.is_empty() {
        return given;
    }
    // Of several parts it is the sum of theirs.
    let parts: Vec<Vec<TextRun>> = match &this.mass {
        Mass::OfParts => {
            let symbol = |(n, weight): (Num, bool)| if weight { Vec::new() } else { view.symbol(n) };
            view.masses(this).into_iter().map(symbol).collect()
        }
        _ => Vec::new(),
    };
    if parts.is_empty() || parts.iter().any(Vec::is_empty) {
        return symbol::symbol(&of_body(view, body, &["m", "m_G"], |_| true));
    }
    let sum = parts.join(&symbol::upright("\u{a0}+\u{a0}")[..]);
    [symbol::upright("("), sum, symbol::upright(")")].concat()
}

/// Weight of a body: `mg`, or the symbol of a given weight.
pub fn weight(view: &SceneView, body: usize) -> Vec<TextRun> {
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
