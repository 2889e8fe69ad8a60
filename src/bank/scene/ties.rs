//! Ties: contacts with surfaces, cords, light rods, teeth and belts, and bodies that rest on wheels.
use crate::bank::need::Need;
use crate::bank::node::{Fields, Node, Value, items};
use crate::bank::scene::{DatumUse, SceneReader, plain_name};
use crate::scene::{
    Attach, Body, Cord, CordEnd, Far, GivenForce, Grows, Growth, Law, Made, Num, Side, Slope, Tie,
};

/// What cords and light rods are called that have no name.
const UNNAMED: [&str; 2] = ["cord", "link"];

impl SceneReader<'_> {
    /// The radius of a body at which a tie acts; this is what makes a radius used.
    pub(super) fn radius(&self, node: &Node, body: &Body) -> Option<Num> {
        let what = format!("a radius of `{}`", body.name);
        if body.radii_m.is_empty() {
            let hint = format!("give `{}` a field `radii`, for example `radii: {{rim: R}}`", body.name);
            return self.faults.expected(node, &what, hint);
        }
        let names = body.radii_m.iter().map(|(n, _)| n.as_str());
        let (_, num) =
            body.radii_m[self.called(node, (&what, &format!("radii of `{}`", body.name)), names)?];
        self.winds_on(num);
        Some(num)
    }

    /// Notes a radius as used.
    pub(super) fn winds_on(&self, radius: Num) {
        let uses = &mut self.met.borrow_mut().uses;
        match radius {
            Num::Datum(datum) => uses.push(DatumUse { datum, need: *Need::RADIUS }),
            Num::Derived(at) => {
                let derived = self.derived.borrow();
                let given = derived.get(at).into_iter().flat_map(|n| n.formula.names());
                uses.extend(given.map(|g| DatumUse { datum: g.datum, need: *Need::TERM }));
            }
            Num::Fixed(_) => {}
        }
    }

    pub(super) fn ties(&self, node: &Node, bodies: &[Body]) -> Vec<Tie> {
        let f = self.faults;
        let Some(items) = items(node, "a list of ties, each after `- `", f) else { return Vec::new() };
        let mut ties: Vec<Tie> = Vec::new();
        for item in items {
            let Some((word, key, value)) =
                self.one(item, "a tie such as `rolls: {body: wheel, on its: hub}`")
            else {
                continue;
            };
            if word == "rests" {
                for cord in self.rests(value, bodies) {
                    let Far::Body(end) = cord.to else { continue };
                    let on =
                        |t: &Tie| matches!(t, Tie::Cord(c) if c.made == Made::Rests && c.name == cord.name);
                    if ties.iter().any(on) {
                        f.hint(
                            item,
                            format!("something rests on `{}` twice", bodies[end.body].name),
                            "keep one of them",
                        );
                    }
                    ties.push(Tie::Cord(cord));
                }
                continue;
            }
            let tie = match word {
                "rolls" | "slips" | "slides" | "touches" => self.contact(word, value, bodies, ties.len()),
                "cord" => self.cord(value, bodies, ties.len()).map(Tie::Cord),
                "link" => self.link(value, bodies).map(Tie::Cord),
                "meshes" | "belt" => {
                    let made = if word == "belt" { Made::Belt } else { Made::Teeth };
                    let like = ties.iter().filter(|t| matches!(t, Tie::Cord(c) if c.made == made)).count();
                    self.mesh(value, bodies, (made, like)).map(Tie::Cord)
                }
                _ => {
                    self.unknown(
                        key,
                        "tie",
                        &["rolls", "slips", "slides", "touches", "cord", "link", "meshes", "belt", "rests"],
                    );
                    None
                }
            };
            let Some(tie) = tie else { continue };
            if let Some(body) = tie.touching()
                && ties.iter().filter_map(Tie::touching).any(|b| b == body)
            {
                f.hint(
                    item,
                    format!("`{}` touches its surface twice", bodies[body].name),
                    "keep one of `rolls`, `slips`, `slides`, `touches`",
                );
            }
            if let Tie::Cord(c) = &tie
                && !UNNAMED.contains(&c.name.as_str())
                && ties.iter().any(|t| matches!(t, Tie::Cord(o) if o.name == c.name))
            {
                f.hint(item, format!("two cords are called `{}`", c.name), "give each its own name");
            }
            ties.push(tie);
        }
        for name in UNNAMED {
            let unnamed = ties.iter_mut().filter_map(|t| match t {
                Tie::Cord(c) if c.name == name && !matches!(c.to, Far::Pull(_)) => Some(c),
                _ => None,
            });
            let unnamed: Vec<&mut Cord> = unnamed.collect();
            if unnamed.len() > 1 {
                // Several tensions need names; number the cords in the order of the file.
                unnamed.into_iter().enumerate().for_each(|(n, c)| c.name = format!("{name}{}", n + 1));
            }
        }
        ties
    }

    pub(super) fn contact(&self, word: &str, node: &Node, bodies: &[Body], tie: usize) -> Option<Tie> {
        let f = self.faults;
        let mut fields = Fields::open(node, "the body and where it touches", f)?;
        let body = self.need_body(&mut fields, "body", bodies);
        let surface = body.is_none_or(|b| bodies[b].line.is_some_and(|l| l.surface));
        if !surface && body.is_some_and(|b| bodies[b].line.is_some() || bodies[b].turns) {
            f.hint(
                node,
                format!("`{}` touches no surface", body.map_or("", |b| &bodies[b].name)),
                "write `moves: along SURFACE`",
            );
        }
        if word == "slides" {
            let mu_k = self.need_number(&mut fields, "mu_k", "mu_k", Need::FRICTION);
            let mu_s = self.optional(&mut fields, "mu_s", Need::FRICTION);
            if let Some(b) = body
                && bodies[b].turns
            {
                let message = format!("`{}` can turn, so it rolls or slips", bodies[b].name);
                return f.refuse_with(node, message, "write `rolls:` or `slips:`");
            }
            return Some(Tie::Slide { body: body?, mu_s: mu_s?, mu_k: mu_k? });
        }
        let on = fields.need("on its", "rim");
        let radius = body.zip(on).and_then(|(b, n)| self.radius(n, &bodies[b]));
        if let Some(b) = body
            && !bodies[b].turns
        {
            f.hint(
                node,
                format!("`{}` has no inertia, so it cannot turn", bodies[b].name),
                "give it a `radius of gyration` or a `shape`, or write `slides:`",
            );
        }
        if word == "rolls" {
            let mu_s = self.optional(&mut fields, "mu_s", Need::FRICTION);
            return Some(Tie::Roll { body: body?, radius_m: radius?, mu_s: mu_s? });
        }
        let mu_s = self.need_number(&mut fields, "mu_s", "mu_s", Need::FRICTION);
        let mu_k = self.need_number(&mut fields, "mu_k", "mu_k", Need::FRICTION);
        if word == "touches" {
            let touches = &mut self.met.borrow_mut().touches;
            touches.push((tie, mu_k?));
            if !self.touching.slips(touches.len() - 1) {
                return Some(Tie::Roll { body: body?, radius_m: radius?, mu_s: Some(mu_s?) });
            }
        }
        Some(Tie::Slip { body: body?, radius_m: radius?, mu_s: mu_s?, mu_k: mu_k? })
    }

    /// A given force that grows: `growing by: c`, evenly with time, or `growing by: {rate: c, with: t^2}`.
    pub(super) fn grows(&self, node: Option<&Node>, of: GivenForce) {
        let Some(node) = node else { return };
        let mut law = Law::EVEN;
        let mut rate = Some(node.clone());
        if matches!(node.value, Value::Map(_)) {
            let Some(mut fields) = Fields::open(node, "a growth (rate, with)", self.faults) else { return };
            rate = fields.need("rate", "c").cloned();
            let with = fields.need("with", "t^2").and_then(|n| self.law(n, of));
            let Some(with) = with else { return };
            law = with;
        }
        let mut growth = Growth { of, law, rate: Num::Fixed(0.0), unit: Num::Fixed(1.0) };
        let need = Need::growth(growth.rate_unit(), matches!(of, GivenForce::Couple(_)));
        if let Some(number) = rate.and_then(|n| self.number(&n, &need)) {
            growth.rate = number;
            self.growths.borrow_mut().push(growth);
        }
    }

    /// The power of time or place with which a force grows: `t^2`, `sqrt(t)`, of a pull `x`, of a couple `phi`.
    pub(super) fn law(&self, node: &Node, of: GivenForce) -> Option<Law> {
        let place = if matches!(of, GivenForce::Pull(_)) { "x" } else { "phi" };
        let text = node.text().unwrap_or("").replace(' ', "");
        let powers = |name: &str| {
            [("sqrt(_)", 1), ("_", 2), ("_^1.5", 3), ("_^2", 4), ("_^3", 6)]
                .map(|(power, halves)| (power.replace('_', name), halves))
        };
        let halves =
            |name| powers(name).into_iter().find(|(word, _)| *word == text).map(|(_, halves)| halves);
        let law = |with, name| halves(name).map(|halves| Law { with, halves });
        law(Grows::Time, "t").or_else(|| law(Grows::Place, place)).or_else(|| {
            let what = match place {
                "x" => "x is the way of its point along it",
                _ => "phi is the turn of its body",
            };
            let known: Vec<String> =
                ["t", place].into_iter().flat_map(powers).map(|(word, _)| word).collect();
            let hint = format!("one of {}; {what} since the start", known.join(", "));
            self.faults.expected(node, "what it grows with", hint)
        })
    }

    /// Two wheels that turn each other, by teeth or a belt: rims by body and radius.
    pub(super) fn mesh(&self, node: &Node, bodies: &[Body], (made, like): (Made, usize)) -> Option<Cord> {
        let f = self.faults;
        let what = "two rims such as `[gear.rim, pinion.rim]`";
        let both = items(node, what, f)?;
        let [one, other] = both else {
            return f.refuse(node, format!("expected {what}, found {}", both.len()));
        };
        let rim = |node: &Node| {
            let (index, body, radius) = wheel_of(node, bodies)?;
            let (_, radius) = body.radii_m.iter().find(|(n, _)| n == radius)?;
            (body.line.is_none() && body.turns && body.planar.is_none()).then_some((index, *radius))
        };
        let rim = |node: &Node| {
            let hint = "a body about a fixed axle and one of its radii, such as `gear.rim`";
            rim(node).or_else(|| f.expected(node, "the rim of a wheel about a fixed axle", hint))
        };
        let ((body, radius), (second, other_radius)) = rim(one).zip(rim(other))?;
        self.winds_on(radius);
        self.winds_on(other_radius);
        if body == second {
            return f.refuse(node, "a wheel does not drive itself");
        }
        // What the rim of the one gains, that of the other loses: teeth turn the other way, a belt the same way.
        let end = |body, radius, forward| CordEnd::new(body, Attach::Wound(radius, Side::Top), forward);
        let (from, to) = (end(body, radius, true), end(second, other_radius, made == Made::Teeth));
        let word = if made == Made::Teeth { "mesh" } else { "belt" };
        let name = if like == 0 { word.to_owned() } else { format!("{word}{}", like + 1) };
        Some(Cord { name, from, to: Far::Body(to), made })
    }

    /// A body that rests on wheels: on their rims, along which it does not slip, or on their axles.
    pub(super) fn rests(&self, node: &Node, bodies: &[Body]) -> Vec<Cord> {
        let f = self.faults;
        let Some(mut fields) = Fields::open(node, "a body that rests on wheels (body, on)", f) else {
            return Vec::new();
        };
        let body = self.need_body(&mut fields, "body", bodies);
        let on = fields.need("on", "[front.rim, rear.rim]");
        let (Some(load), Some(on)) = (body, on) else { return Vec::new() };
        let Some(line) = bodies[load].line.filter(|_| !bodies[load].turns) else {
            let hint = "what rests on wheels only moves, `moves: along SURFACE`, without an inertia";
            f.hint(node, format!("`{}` cannot rest on wheels", bodies[load].name), hint);
            return Vec::new();
        };
        let wheels = match &on.value {
            Value::List(items) => &items[..],
            _ => std::slice::from_ref(on),
        };
        let end = |node: &Node| {
            let (index, wheel, radius) = wheel_of(node, bodies)?;
            let attach = match radius {
                "centre" | "center" | "axle" => Attach::Centre,
                _ => Attach::Wound(wheel.radii_m.iter().find(|(n, _)| n == radius)?.1, Side::Top),
            };
            // Beside each other along one line; a wheel on a fixed axle has none and turns what lies on it.
            let beside = match (wheel.line, attach) {
                (Some(own), _) => own.slope == line.slope,
                (None, attach) => attach != Attach::Centre,
            };
            let wheels = wheel.turns && wheel.planar.is_none() && beside;
            // What moves the load forward moves the wheel forward.
            let same = wheel.line.is_none_or(|l| l.forward_up) == line.forward_up;
            wheels.then(|| CordEnd::new(index, attach, !same))
        };
        let rests = |wheel: &Node| {
            let Some(to) = end(wheel) else {
                let hint = "a wheel on the same surface or on a fixed axle, with one of its radii, or with `.centre` for its axle: `roller.rim`";
                return f.expected(wheel, "the rim or the axle of a wheel", hint);
            };
            let from = CordEnd::new(load, Attach::Centre, true);
            Some(Cord { name: bodies[to.body].name.clone(), from, to: Far::Body(to), made: Made::Rests })
        };
        wheels.iter().filter_map(rests).collect()
    }

    /// The name of a cord or a light rod.
    pub(super) fn tie_name(&self, node: Option<&Node>, unnamed: &str) -> Option<String> {
        let Some(node) = node else { return Some(unnamed.to_owned()) };
        let name = node.text().filter(|t| plain_name(t));
        if name.is_none() {
            let message = format!("{} is no name for a {unnamed}", node.kind());
            self.faults.hint(node, message, "letters, digits and `_`");
        }
        name.map(str::to_owned)
    }

    /// A light rod between the centres of two bodies that move along one line.
    pub(super) fn link(&self, node: &Node, bodies: &[Body]) -> Option<Cord> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a light rod (from, to)", f)?;
        let name = self.tie_name(fields.get("name"), UNNAMED[1]);
        let like = "{body: front, tied at: centre, leaves: back}";
        let [from, to] =
            ["from", "to"].map(|end| fields.need(end, like).and_then(|n| self.cord_end(n, bodies)));
        let (from, to) = (from?, to?);
        // Each end by its line, and whether it leads up that.
        let up = |end: CordEnd| {
            let line = bodies[end.body].line.filter(|_| end.attach == Attach::Centre);
            line.map(|line| (line.slope, end.forward == line.forward_up))
        };
        let straight = || matches!((up(from), up(to)), (Some((a, x)), Some((b, y))) if a == b && x != y);
        if from.body == to.body || !straight() {
            let hint = "both bodies move along the same surface, or both vertically, each end is `tied at: centre`, and of two that count \
                        positive alike one end leaves `forward`, the other `back`; round a corner only a `cord` goes";
            return f.refuse_with(node, "a light rod is straight: its ends leave toward each other", hint);
        }
        Some(Cord { name: name?, from, to: Far::Body(to), made: Made::Link })
    }

    pub(super) fn cord(&self, node: &Node, bodies: &[Body], tie: usize) -> Option<Cord> {
        let f = self.faults;
        let mut fields = Fields::open(node, "a cord (from, and where it goes)", f)?;
        let name = self.tie_name(fields.get("name"), UNNAMED[0]);
        let from = fields
            .need("from", "{body: wheel, wound on: rim, leaves: top forward}")
            .and_then(|n| self.cord_end(n, bodies));
        let ends = [fields.get("pulled with"), fields.get("to"), fields.get("spring"), fields.get("held")];
        if ends.iter().flatten().count() != 1 {
            f.hint(
                node,
                "a cord has exactly one other end",
                "one of `pulled with: P`, `to: {body: ...}`, `spring: {...}`, `held: fast`",
            );
        }
        let [pulled, to, spring, held] = ends;
        let growing = fields.get("growing by");
        if let (Some(n), None) = (growing, pulled) {
            f.hint(n, "what is not given does not grow", "`growing by` stands beside `pulled with`");
        }
        self.grows(growing, GivenForce::Pull(tie));
        if from.is_some_and(|from| from.tilt_deg.is_some()) && (pulled.is_none() || growing.is_some()) {
            let hint = "`at an angle` stands beside `pulled with` and a constant force: what grows, and what ends at another body, a spring \
                        or a wall, leads along the surface";
            f.hint(node, "only a constant pull leads away from the surface", hint);
        }
        let far = if let Some(n) = pulled {
            self.number(n, Need::FORCE).map(Far::Pull)
        } else if let Some(n) = to {
            self.cord_end(n, bodies).map(Far::Body)
        } else if let Some(n) = spring {
            self.spring(n)
        } else {
            held.and_then(|n| self.word(n, "`fast`", &[("fast", ())])).map(|()| Far::Fixed)
        };
        if let (Some(from), Some(Far::Body(to))) = (&from, &far)
            && from.body == to.body
        {
            return f.refuse(node, format!("both ends of this cord are at `{}`", bodies[from.body].name));
        }
        Some(Cord { name: name?, from: from?, to: far?, made: Made::Cord })
    }

    pub(super) fn spring(&self, node: &Node) -> Option<Far> {
        let mut fields = Fields::open(node, "a spring (stiffness, stretch)", self.faults)?;
        let stiffness = self.need_number(&mut fields, "stiffness", "ks", Need::STIFFNESS);
        let rigid = fields.get("attached").map_or(Some(false), |n| {
            self.word(
                n,
                "how the spring is attached",
                &[("by the cord", false), ("cord", false), ("rigidly", true), ("rigid", true)],
            )
        });
        // A cord cannot be compressed.
        let need = if rigid == Some(true) { Need::STRETCH } else { Need::LENGTH };
        let stretch = self.need_number(&mut fields, "stretch", "x0", need);
        Some(Far::Spring { stiffness_n_m: stiffness?, stretch_m: stretch?, rigid: rigid? })
    }

    pub(super) fn cord_end(&self, node: &Node, bodies: &[Body]) -> Option<CordEnd> {
        let f = self.faults;
        let mut fields = Fields::open(node, "an end of a cord (body, tied at or wound on, leaves)", f)?;
        let body = self.need_body(&mut fields, "body", bodies);
        let wound = fields.get("wound on");
        let tied = fields.get("tied at");
        let leaves = fields.need("leaves", if tied.is_some() { "forward" } else { "top forward" });
        let tilted = fields.get("at an angle");
        let index = body?;
        let body = &bodies[index];
        let tilt = tilted.and_then(|n| self.number(n, Need::TILT));
        let sideways = |n: &Node| {
            n.text().is_some_and(|t| t.trim().ends_with(" forward") || t.trim().ends_with(" back"))
        };
        let level = body.line.is_none() && !body.is_pinned() && leaves.is_some_and(sideways);
        if let (Some(n), false) = (tilted, level || body.line.is_some_and(|l| l.surface)) {
            f.hint(
                n,
                format!("`{}` moves along no surface", body.name),
                "an angle is that of a pull on what lies on a surface, or of one that leaves a fixed axle at the `top forward`, `bottom back` and the like",
            );
        }
        if !body.particles.is_empty() {
            return f
                .refuse(node, format!("`{}` is made of particles; no cord can be tied to it", body.name));
        }
        if body.is_pinned() {
            return f.refuse_with(
                node,
                format!("no cord is tied to the pinned body `{}`", body.name),
                "a spring stands under `forces`: `spring: {on: ..., at: b, anchor: [x_A, y_A], ...}`",
            );
        }
        match (wound, tied) {
            (Some(n), None) => {
                let radius = self.radius(n, body);
                if !body.turns {
                    let message = format!("`{}` has no inertia, so it cannot turn", body.name);
                    return f.refuse_with(node, message, "write `tied at: centre`");
                }
                let (side, forward) = self.leaves_wound(leaves?, body)?;
                let said = leaves.and_then(Node::text).and_then(|text| text.trim().rsplit_once(' '));
                let upright = said.and_then(|(_, word)| match word {
                    "up" => Some(true),
                    "down" => Some(false),
                    _ => None,
                });
                let upright = upright.filter(|_| body.line.is_none());
                let attach = Attach::Wound(radius?, side);
                Some(CordEnd { body: index, attach, forward, upright, tilt_deg: tilt })
            }
            (None, Some(n)) => {
                self.word(
                    n,
                    "`centre`",
                    &[("centre", ()), ("center", ()), ("its centre", ()), ("mass centre", ())],
                )?;
                let Some(line) = body.line else {
                    if body.planar.is_some() {
                        let message =
                            format!("`{}` moves in the plane, where `ties` hold nothing", body.name);
                        let hint = "write a joint such as `cord: {cord: A, to: [0 m, 2 m]}`, or a force; a weight on a cord over a pulley is not solved there";
                        return f.refuse_with(node, message, hint);
                    }
                    let message = format!("the centre of `{}` does not move", body.name);
                    return f.refuse_with(node, message, "write `wound on: ...`");
                };
                let words =
                    [("forward", true), ("back", false), ("up", line.forward_up), ("down", !line.forward_up)];
                let words = if line.slope == Slope::Level { &words[..2] } else { &words };
                let forward = self.word(leaves?, "where the cord leaves", words)?;
                Some(CordEnd { tilt_deg: tilt, ..CordEnd::new(index, Attach::Centre, forward) })
            }
            _ => f.refuse_with(
                node,
                "a cord is tied at the centre or wound on a radius",
                "write `tied at: centre` or `wound on: rim`",
            ),
        }
    }

    /// Side and direction of a wound cord.
    pub(super) fn leaves_wound(&self, node: &Node, body: &Body) -> Option<(Side, bool)> {
        use Side::{Bottom, Top};
        let surface = body.line.is_some_and(|l| l.surface);
        let mut words = vec![
            ("top forward", (Top, true)),
            ("top back", (Top, false)),
            ("bottom forward", (Bottom, true)),
            ("bottom back", (Bottom, false)),
        ];
        if !surface {
            // Seen with forward to the right, a positive turn moves the front side down: it pays a cord out that
            // leaves there downward, and takes one in that leaves there upward.
            for (word, pays_out, down) in [
                ("front down", true, true),
                ("back down", false, true),
                ("front up", false, false),
                ("back up", true, false),
            ] {
                let forward = match body.line {
                    None => true,
                    Some(line) => line.forward_up != down,
                };
                words.push((word, (if pays_out == forward { Top } else { Bottom }, forward)));
            }
            if let Some(line) = body.line {
                // The side for which a positive turn goes with unwinding while it moves down.
                words.push(("up", (if line.forward_up { Top } else { Bottom }, line.forward_up)));
            }
        }
        self.word(node, "where the wound cord leaves", &words)
    }
}

/// A wheel and the name of one of its radii: `gear.rim`.
fn wheel_of<'b, 'n>(node: &'n Node, bodies: &'b [Body]) -> Option<(usize, &'b Body, &'n str)> {
    let (name, radius) = node.text()?.trim().split_once('.')?;
    let (index, body) = bodies.iter().enumerate().find(|(_, b)| b.name == name)?;
    Some((index, body, radius))
}
