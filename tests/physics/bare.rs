//! Scenes with nothing in them but what a test puts there.
use slipstick::scene::*;

/// Bodies that start at rest and that nothing ties or drives.
pub fn scene(gravity_m_s2: Num, bodies: Vec<Body>, end: End) -> Scene {
    Scene {
        gravity_m_s2,
        bodies,
        ties: Vec::new(),
        couples: Vec::new(),
        joints: Vec::new(),
        restitution: None,
        pushes: Vec::new(),
        struts: Vec::new(),
        growths: Vec::new(),
        carried: None,
        start: Vec::new(),
        end,
        heading: None,
        span: Span::ToEnd,
        formulas: Formulas::default(),
    }
}

/// A wheel of the data m R r .. theta, on an incline; the datum `k` is its radius of gyration.
pub fn wheel(k: usize) -> Body {
    let line = Line { slope: Slope::Degrees(Num::Datum(4)), forward_up: true, surface: true };
    Body {
        name: "wheel".into(),
        radii_m: vec![("rim".into(), Num::Datum(1)), ("hub".into(), Num::Datum(2))],
        line: Some(line),
        ..turning(Num::Datum(0), RotaryInertia::Gyration(Num::Datum(k)))
    }
}

/// A body that turns, neither on a line nor at a pin.
pub fn turning(mass: Num, inertia: RotaryInertia) -> Body {
    Body {
        name: "body".into(),
        mass: Mass::Kilograms(mass),
        inertia: Some(inertia),
        turns: true,
        ..Body::default()
    }
}

/// A body that its own pin holds.
pub fn pinned(gravity: Num, body: Body, planar: Planar, end: End) -> Scene {
    let mut scene = scene(gravity, vec![Body { planar: Some(planar), ..body }], end);
    scene.joints.extend(scene.bodies[0].pin(0));
    scene
}
