//! What the picture of a scene shows, in words: the text beside it for those who do not see it.
use crate::figure::layout::{Placed, SceneLayout};
use crate::figure::names;
use crate::figure::view::SceneView;
use crate::picture::symbol;
use crate::picture::vector::Vec2;
use crate::scene::{
    Attach, Body, Coordinate, CordEnd, Degree, End, Far, GivenForce, Made, Mass, Num, RotaryInertia, Shape,
    Side, Slope, Start, Tie,
};

/// A number with its symbol, as text in one line: `R = 0.40 m`.
pub fn text(view: &SceneView, num: Num, unit: &str) -> String {
    view.text(num, unit).replace('\u{a0}', " ")
}

/// A number without its symbol.
fn bare(view: &SceneView, num: Num, unit: &str) -> String {
    symbol::plain(&view.value(num, unit)).replace('\u{a0}', " ")
}

/// The body in words: `Load 2`.
pub fn called(view: &SceneView, body: &Body) -> String {
    let index = view.scene.bodies.iter().position(|b| b.name == body.name);
    index.map_or_else(String::new, |i| names::body(view.words, view.scene, i))
}

/// The body with its data: `Wheel (m = 40 kg, k = 0.25 m)`.
pub fn named(view: &SceneView, body: &Body) -> String {
    let (mut data, mut told) = (Vec::new(), Vec::new());
    let mut tell = |num: Num, unit: &str| {
        if matches!(num, Num::Datum(_)) && !told.contains(&num) {
            told.push(num);
            data.push(text(view, num, unit));
        }
    };
    match &body.mass {
        Mass::Kilograms(n) => tell(*n, "kg"),
        Mass::Weight(n) => tell(*n, "N"),
        Mass::OfParts => {}
    }
    for (num, _) in view.radii(body) {
        tell(num, "m");
    }
    match &body.inertia {
        Some(RotaryInertia::Gyration(n) | RotaryInertia::Shape(Shape::Rod, n)) => tell(*n, "m"),
        Some(RotaryInertia::Moment(n)) => tell(*n, "kg·m<sup>2</sup>"),
        _ => {}
    }
    if let Some(planar) = &body.planar {
        let places = planar.points.iter().flat_map(|(_, place)| *place).chain([planar.centre]);
        places.flat_map(|place| view.data(place.number())).for_each(|n| tell(n, "m"));
    }
    let name = called(view, body);
    if data.is_empty() { name } else { format!("{name} ({})", data.join(separator(view))) }
}

/// What stands between the items of a list: no comma where numbers have one.
pub fn separator(view: &SceneView) -> &'static str {
    if view.words.number("0.1").contains(',') { "; " } else { ", " }
}

/// A direction on the board, in words.
fn way(view: &SceneView, towards: Vec2, incline: bool) -> String {
    // A drawn slope may be none.
    let name = if incline && towards.y.abs() > 1e-9 {
        if towards.y > 0.0 { "up_incline" } else { "down_incline" }
    } else if towards.x.abs() > towards.y.abs() {
        if towards.x > 0.0 { "right" } else { "left" }
    } else if towards.y > 0.0 {
        "up"
    } else {
        "down"
    };
    view.words.get(&format!("figure.way.{name}")).to_owned()
}

/// A sense of turning, in words.
fn turn(view: &SceneView, clockwise: bool) -> String {
    view.words.get(if clockwise { "figure.turn.clockwise" } else { "figure.turn.counter" }).to_owned()
}

/// Where a cord leaves a body, and which way as it is drawn of what hangs and of a fixed axle.
fn place(view: &SceneView, end: CordEnd, drawn: Option<Vec2>) -> String {
    let axle = view.scene.bodies.get(end.body).is_none_or(|b| b.line.is_none());
    let way = match drawn.map(|towards| (towards.x, towards.y)) {
        None if end.forward => "forward",
        None => "back",
        Some((x, _)) if axle && x > 0.5 => "right",
        Some((x, _)) if axle && x < -0.5 => "left",
        Some((_, y)) if y > 0.0 => "up",
        Some(_) => "down",
    };
    let Attach::Wound(radius, side) = end.attach else {
        return view.words.get(&format!("figure.place.centre_{way}")).to_owned();
    };
    let name = match side {
        _ if drawn.is_some() => format!("wound_{way}"),
        _ if axle => "axle".to_owned(),
        Side::Top => format!("top_{way}"),
        Side::Bottom => format!("bottom_{way}"),
    };
    view.words.say(&format!("figure.place.{name}"), &[("radius", &text(view, radius, "m"))])
}

/// The sentences about bodies on lines and axles.
pub fn mechanism(view: &SceneView, plan: &SceneLayout, told: bool, out: &mut Vec<String>) {
    let say = |name: &str, pieces: &[(&str, &str)]| view.words.say(&format!("figure.scene.{name}"), pieces);
    let bodies = |on: Option<usize>, out: &mut Vec<String>| {
        for (b, p) in plan.bodies.iter().enumerate() {
            if let Some(p) = p.as_ref().filter(|p| p.on == on) {
                body(view, plan, b, p, out);
            }
        }
    };
    for (i, ground) in plan.grounds.iter().enumerate() {
        let side = if ground.up.x < 0.0 { "left" } else { "right" };
        let what = if ground.rail { "rail" } else { "incline" };
        out.push(match ground.slope {
            Slope::Level => say("level", &[]),
            Slope::Vertical => say("upright", &[]),
            Slope::Degrees(n) => say(&format!("{what}_{side}"), &[("angle", &text(view, n, "°"))]),
        });
        bodies(Some(i), out);
    }
    bodies(None, out);
    if let Some(spring) = plan.awaited {
        out.push(say("awaits", &[("stiffness", &text(view, spring.stiffness, "N/m"))]));
    }
    if let (true, End::Travel(Coordinate { degree: Degree::Along, .. }, num)) = (told, view.scene.end) {
        out.push(say("travel", &[("distance", &text(view, num, "m"))]));
    }
    let mut senses = Vec::new();
    for (b, p) in plan.bodies.iter().enumerate() {
        let Some(p) = p.as_ref().filter(|_| view.started(b).next().is_none()) else { continue };
        let body = &view.scene.bodies[b];
        let incline = p.on.is_some_and(|g| matches!(plan.grounds[g].slope, Slope::Degrees(_)));
        let mut list = Vec::new();
        list.extend(body.line.map(|_| way(view, p.forward, incline)));
        list.extend(body.turns.then(|| turn(view, p.clockwise)));
        if !list.is_empty() {
            senses.push(format!("{}: {}", called(view, body), list.join(", ")));
        }
    }
    if !senses.is_empty() {
        out.push(say("positive", &[("list", &senses.join("; "))]));
    }
}

fn body(view: &SceneView, plan: &SceneLayout, index: usize, p: &Placed, out: &mut Vec<String>) {
    let body = &view.scene.bodies[index];
    let name = named(view, body);
    let say = |name: &str, pieces: &[(&str, &str)]| view.words.say(&format!("figure.scene.{name}"), pieces);
    let contact = view.scene.ties.iter().find_map(|t| match t {
        Tie::Roll { body, radius_m, .. } | Tie::Slip { body, radius_m, .. } if *body == index => {
            Some(*radius_m)
        }
        _ => None,
    });
    out.push(match (p.on.is_some(), contact, body.line.is_some()) {
        (true, None, _) if view.scene.rests(index) => say("above", &[("body", &name)]),
        (true, Some(radius), _) => say("touches", &[("body", &name), ("radius", &text(view, radius, "m"))]),
        (true, None, _) => say("lies", &[("body", &name)]),
        (false, _, true) => say("hangs", &[("body", &name)]),
        (false, _, false) => say("axle", &[("body", &name)]),
    });
    let ties = view.scene.ties.iter().enumerate();
    for (i, _) in ties.filter(|(_, tie)| tie.touching() == Some(index)) {
        let list: Vec<String> =
            view.coefficients(i).into_iter().map(|(_, num)| text(view, num, "")).collect();
        if !list.is_empty() {
            out.push(say("friction", &[("list", &list.join(separator(view)))]));
        }
    }
    for (i, tie) in view.scene.ties.iter().enumerate() {
        let Tie::Cord(cord) = tie else { continue };
        if cord.from.body != index {
            continue;
        }
        let mut leaves = plan.cords.iter().filter(|r| r.tie == i).flat_map(|r| &r.at);
        let towards = leaves.find(|(b, _)| *b == index).map(|(_, d)| *d);
        let free = !matches!(cord.to, Far::Body(_));
        let drawn = towards.filter(|_| p.on.is_none() && (body.line.is_some() || free));
        let place = place(view, cord.from, drawn);
        out.push(match cord.to {
            Far::Pull(n) => {
                let force = view.growing(GivenForce::Pull(i), n).unwrap_or_else(|| text(view, n, "N"));
                match cord.from.tilt_deg {
                    Some(tilt) => {
                        let angle = text(view, tilt, "°");
                        let line = if body.line.is_some() { "tilted" } else { "tilted_axle" };
                        say(line, &[("place", &place), ("force", &force), ("angle", &angle)])
                    }
                    None => say("pull", &[("place", &place), ("force", &force)]),
                }
            }
            Far::Fixed => say("fixed", &[("place", &place)]),
            Far::Spring { stiffness_n_m, stretch_m, .. } => {
                let (stiffness, stretch) = (text(view, stiffness_n_m, "N/m"), text(view, stretch_m, "m"));
                say("spring", &[("place", &place), ("stiffness", &stiffness), ("stretch", &stretch)])
            }
            Far::Body(end) => {
                let guide = plan.cords.iter().any(|r| r.tie == i && r.guide.is_some());
                let other = view.scene.bodies.get(end.body).map_or_else(String::new, |b| named(view, b));
                let name = match cord.made {
                    Made::Teeth => "meshes",
                    Made::Belt => "belt",
                    Made::Rests => "rests",
                    Made::Link => "link",
                    Made::Cord if guide => "over",
                    Made::Cord => "joins",
                };
                say(name, &[("place", &place), ("other", &other)])
            }
        });
    }
    couples(view, index, out);
    let mut list = Vec::new();
    for (degree, num) in view.started(index) {
        let back = view.of(num) < 0.0;
        let (unit, way) = match degree {
            Degree::Along => {
                let incline = p.on.is_some_and(|g| matches!(plan.grounds[g].slope, Slope::Degrees(_)));
                ("m/s", way(view, if back { -p.forward } else { p.forward }, incline))
            }
            Degree::Turn => ("rad/s", turn(view, p.clockwise != back)),
        };
        list.push(format!("{} {way}", view.size_text(num, unit).replace('\u{a0}', " ")));
    }
    if !list.is_empty() {
        out.push(say("start", &[("list", &list.join(separator(view)))]));
    }
}

/// The sentences about the couples on a body.
pub fn couples(view: &SceneView, index: usize, out: &mut Vec<String>) {
    for (i, couple) in view.scene.couples.iter().enumerate().filter(|(_, c)| c.body == index) {
        let forward = couple.forward == (view.of(couple.moment_n_m) >= 0.0);
        let name = if forward { "figure.scene.couple" } else { "figure.scene.couple_back" };
        let size = || view.size_text(couple.moment_n_m, "N·m").replace('\u{a0}', " ");
        let moment = view.growing(GivenForce::Couple(i), couple.moment_n_m).unwrap_or_else(size);
        out.push(view.words.say(name, &[("moment", &moment)]));
    }
}

/// The sentences about a lamina.
pub fn lamina(view: &SceneView, index: usize, out: &mut Vec<String>) {
    let body = &view.scene.bodies[index];
    let say = |name: &str, pieces: &[(&str, &str)]| view.words.say(&format!("figure.lamina.{name}"), pieces);
    let list = body.particles.iter().map(|p| {
        let (mass, x, y) = (bare(view, p.mass_kg, "kg"), bare(view, p.x_m, "m"), bare(view, p.y_m, "m"));
        say("particle", &[("name", &p.name), ("mass", &mass), ("x", &x), ("y", &y)])
    });
    out.push(say("text", &[("list", &list.collect::<Vec<_>>().join("; "))]));
    for start in &view.scene.start {
        if let Start::Lamina { body: b, particle, vx_m_s, vy_m_s, spin_rad_s } = *start
            && b == index
        {
            let name = body.particles.get(particle).map_or("", |p| p.name.as_str());
            let (vx, vy) = (text(view, vx_m_s, "m/s"), text(view, vy_m_s, "m/s"));
            let spin = text(view, spin_rad_s, "rad/s");
            out.push(say("motion", &[("name", name), ("vx", &vx), ("vy", &vy), ("spin", &spin)]));
        }
    }
}
