//! How a motion ends: after a way, a turn, a time, at a speed, an angle, a turning point and the like.
use crate::bank::need::Need;
use crate::bank::node::{Fields, Node, shorten};
use crate::bank::scene::SceneReader;
use crate::scene::{Attach, Body, Coordinate, Cord, Degree, End, Far, Heading, Joint, Num, Slope, Tie};

/// How an end is written.
enum EndForm {
    /// A body and a value: the field of the value, an example of it, what it is along a line and in turning, what is made of it.
    Value(&'static str, &'static str, &'static Need, &'static Need, fn(Coordinate, Num) -> End),
    /// The name of a body, and what is made of it: by whether it turns, and whether it moves along a line.
    Body(fn(&Body, usize) -> End),
    /// A height: is it gained?
    Height(bool),
    /// A length of cord.
    Unwinds,
    /// The name of a joint that can only push.
    Leaves,
}

const fn along(body: usize) -> Coordinate {
    Coordinate { body, degree: Degree::Along }
}

/// How the motion of a body ends that is pinned or moves in the plane.
fn in_plane(body: &Body) -> String {
    match body.turns {
        false => "a body that only slides leads no motion: end at the angle of one that turns (hinge it to a light rod, of `mass: 0 kg`), or \
             let it move `vertically` or `along` a surface".to_owned(),
        true => format!("write `angle: {{of: {}, reaches: phi1}}`", body.name),
    }
}

#[rustfmt::skip] // a table
const ENDS: [(&str, EndForm); 13] = [
    ("travel", EndForm::Value("by", "d", Need::LENGTH, Need::TURN, End::Travel)),
    ("turn", EndForm::Value("by", "phi", Need::TURN, Need::TURN, End::Travel)),
    ("position", EndForm::Value("at", "s", Need::PLACE, Need::PLACE, End::Position)),
    ("time", EndForm::Value("is", "t1", Need::TIME, Need::TIME, End::Time)),
    ("speed", EndForm::Value("reaches", "v1", Need::SPEED_REACHED, Need::SPIN_REACHED, End::Speed)),
    ("turning point", EndForm::Body(|b, body| {
        End::TurningPoint(Coordinate { body, degree: if b.line.is_some() { Degree::Along } else { Degree::Turn } })
    })),
    ("rolling", EndForm::Body(|_, body| End::Rolling(along(body)))),
    ("stops slipping", EndForm::Body(|b, body| match b.turns {
        true => End::Rolling(along(body)),
        false => End::TurningPoint(along(body)),
    })),
    ("angle", EndForm::Value("reaches", "phi1", Need::ANGLE_REACHED, Need::ANGLE_REACHED, End::Angle)),
    ("rise", EndForm::Height(true)),
    ("descent", EndForm::Height(false)),
    ("unwinds", EndForm::Unwinds),
    ("leaves", EndForm::Leaves),
];

impl SceneReader<'_> {
    /// An end by the height that a body gains or loses: the way along its surface follows from the slope.
    fn height(&self, value: &Node, bodies: &[Body], up: bool) -> Option<(End, Option<Heading>)> {
        let mut fields = Fields::open(value, "the body and the height", self.faults)?;
        let body = self.need_body(&mut fields, "of", bodies);
        let by = fields.need("by", "h");
        let (body, by) = (body?, by?);
        if bodies[body].planar.is_some() && !bodies[body].is_pinned() {
            let hint = in_plane(&bodies[body]);
            return self.faults.refuse_with(
                value,
                format!("`{}` moves in the plane: it ends at an angle", bodies[body].name),
                hint,
            );
        }
        let (way, line) = match bodies[body].line.map(|line| (line.slope, line)) {
            Some((Slope::Vertical, line)) => (self.number(by, Need::LENGTH), line),
            Some((Slope::Degrees(slope), line)) => {
                let slope = match slope {
                    Num::Fixed(degrees) => Some(format!("{degrees}*pi/180")),
                    other => self.named(other),
                };
                (self.over(by, slope.map(|s| (format!("sin({s})"), false)), Need::LENGTH), line)
            }
            _ => {
                let message = format!("`{}` gains and loses no height along its line", bodies[body].name);
                return self.faults.refuse_with(value, message, "write `travel`, `turn` or another end");
            }
        };
        let heading = if up == line.forward_up { Heading::Forward } else { Heading::Back };
        Some((End::Travel(Coordinate { body, degree: Degree::Along }, way?), Some(heading)))
    }

    /// An end by the length of cord that has come off a body, or onto it.
    fn unwound(&self, value: &Node, ties: &[Tie]) -> Option<(End, Option<Heading>)> {
        let mut fields = Fields::open(value, "the cord and the length", self.faults)?;
        let cord = fields.need("cord", "cord");
        let by = fields.need("by", "L");
        let (cord, by) = (cord?, by?);
        let wound = |c: &Cord| {
            let far = match &c.to {
                Far::Body(end) => Some(*end),
                Far::Pull(_) | Far::Spring { .. } | Far::Fixed => None,
            };
            [Some(c.from), far].into_iter().flatten().find_map(|end| match end.attach {
                Attach::Wound(radius, _) => Some((c.name.clone(), end.body, radius)),
                Attach::Centre => None,
            })
        };
        let wound = ties.iter().filter_map(|t| if let Tie::Cord(c) = t { wound(c) } else { None });
        let wound: Vec<(String, usize, Num)> = wound.collect();
        let Some((_, body, radius)) = wound.iter().find(|(name, ..)| Some(name.as_str()) == cord.text())
        else {
            let names = || wound.iter().map(|(name, ..)| name.as_str());
            let message =
                format!("`{}` is no cord that is wound on a body", shorten(cord.text().unwrap_or("")));
            let hint = format!("wound cords: {}", names().collect::<Vec<_>>().join(", "));
            return self.faults.refuse_with(cord, message, hint);
        };
        let radius = match *radius {
            Num::Fixed(radius_m) => Some((radius_m.to_string(), true)),
            other => self.named(other).map(|name| (name, false)),
        };
        let angle = self.over(by, radius, Need::TURN);
        Some((End::Travel(Coordinate { body: *body, degree: Degree::Turn }, angle?), None))
    }

    pub(super) fn end(
        &self,
        node: &Node,
        bodies: &[Body],
        ties: &[Tie],
        joints: &[Joint],
    ) -> Option<(End, Option<Heading>)> {
        let f = self.faults;
        match node.text().map(str::trim) {
            Some("at once") => return Some((End::AtOnce, None)),
            Some("equilibrium") if bodies.iter().any(|b| b.planar.is_some()) => {
                return Some((End::Equilibrium, None));
            }
            Some("equilibrium") => {
                let hint = "write `moves: in the plane` with joints; of a spring on a line, ask `period_small` of its motion";
                return f.refuse_with(node, "only joined bodies are looked for in their equilibrium", hint);
            }
            _ => {}
        }
        let (word, key, value) = self
            .one(node, "the end: `at once`, `equilibrium`, or for example `{travel: {of: wheel, by: d}}`")?;
        let Some((_, form)) = ENDS.iter().find(|(name, _)| *name == word) else {
            self.unknown(key, "end", &ENDS.map(|(name, _)| name));
            return None;
        };
        match form {
            EndForm::Value(..) => self.end_at_value(word, form, (key, value), bodies),
            EndForm::Body(end) => {
                let body = self.body_named(value, bodies)?;
                Some((end(&bodies[body], body), None))
            }
            EndForm::Height(up) => self.height(value, bodies, *up),
            EndForm::Unwinds => self.unwound(value, ties),
            EndForm::Leaves => {
                let text = value.text().unwrap_or("").trim();
                let found = joints.iter().position(|j| j.name == text && j.kind.only_pushes());
                let hint = "a joint that can only push is written `wall: {guides: rod.B, along: vertical, pushes: right}`";
                let joint = found.or_else(|| f.expected(value, "a joint that can only push", hint))?;
                Some((End::Leaves(joint), None))
            }
        }
    }

    /// An end at which a coordinate of a body has a value.
    fn end_at_value(
        &self,
        word: &str,
        form: &EndForm,
        (key, value): (&Node, &Node),
        bodies: &[Body],
    ) -> Option<(End, Option<Heading>)> {
        let EndForm::Value(by, example, along, in_turning, end) = *form else { return None };
        let f = self.faults;
        let mut fields = Fields::open(value, "the body and the value", f)?;
        let body = self.need_body(&mut fields, "of", bodies);
        let line = body.and_then(|b| bodies[b].line);
        let turning = word == "turn" || (body.is_some() && line.is_none());
        let degree = if turning { Degree::Turn } else { Degree::Along };
        let need = if turning { in_turning } else { along };
        let number = self.need_number(&mut fields, by, example, need);
        let heading_node = fields.get("heading");
        let heading = heading_node.map_or(Some(None), |n| {
            let mut words = vec![("forward", Heading::Forward), ("back", Heading::Back)];
            if let Some(line) = line
                && line.slope != Slope::Level
                && !turning
            {
                let (up, down) = if line.forward_up {
                    (Heading::Forward, Heading::Back)
                } else {
                    (Heading::Back, Heading::Forward)
                };
                words.push(("up", up));
                words.push(("down", down));
            }
            self.word(n, "the direction of motion", &words).map(Some)
        });
        let body = body?;
        if word == "turn" && !bodies[body].turns {
            return f.refuse(value, format!("`{}` does not turn", bodies[body].name));
        }
        let pinned = bodies[body].planar.is_some();
        let name = &bodies[body].name;
        if pinned && ["travel", "turn", "position"].contains(&word) {
            let held = if bodies[body].is_pinned() { "is pinned" } else { "moves in the plane" };
            f.hint(key, format!("`{name}` {held}: it ends at an angle"), in_plane(&bodies[body]));
        }
        if !pinned && word == "angle" {
            f.hint(key, format!("`{name}` is not pinned, so it has no angle"), "`travel`, `turn`, or pin it");
        }
        if let Some(n) = heading_node.filter(|_| pinned) {
            f.hint(n, "a pinned body goes where its forces or its start take it", "remove this field");
        }
        let coordinate = Coordinate { body, degree };
        // What comes down to no speed comes to rest.
        let end = match number? {
            Num::Fixed(0.0) if word == "speed" => End::TurningPoint(coordinate),
            number => end(coordinate, number),
        };
        Some((end, heading?))
    }
}
