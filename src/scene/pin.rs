//! A body held by a fixed pin: it swings in the vertical plane, and its velocity ratios vary with the angle.
//!
//! The line from the pin to the mass centre makes an angle with the vertical, measured from upright (the mass centre above
//! the pin) or from hanging. A turn is positive if the angle grows. Horizontal places are positive on the side to which
//! a small positive angle leans, vertical ones upward.
use crate::scene::{Acts, Joint, JointKind, Num, Place, Planar, Ray, Scene, Spot, Strut, StrutEnd};
use std::borrow::Cow;

/// The pin of a body, and the angle at which the motion starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pin {
    /// Distance from the pin to the mass centre.
    pub arm: Arm,
    /// From where the angle counts.
    pub from: Zero,
    /// Angle at the start, degrees, -360 to 360.
    pub start_deg: Num,
    /// A spring between a fixed point and a point of the body.
    pub spring: Option<PinSpring>,
}

/// Distance from a pin to the mass centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Arm {
    /// Given, m, >= 0.
    Distance(Num),
    /// Half of this length of a slender rod that is pinned at its end, m, > 0.
    HalfOf(Num),
}

/// The direction from which the angle of a pinned body counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Zero {
    /// The mass centre straight above the pin.
    Upright,
    /// The mass centre straight below the pin.
    Hanging,
}

/// A spring from a fixed anchor to a point of a pinned body. It pulls and pushes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinSpring {
    /// Distance from the pin to the point of the body, on the line from the pin through the mass centre, m, > 0.
    pub at_m: Num,
    /// Horizontal place of the anchor as seen from the pin, m.
    pub x_m: Num,
    /// Vertical place of the anchor as seen from the pin, m, positive up.
    pub y_m: Num,
    /// Stiffness, N/m, > 0.
    pub stiffness_n_m: Num,
    /// Its length without load.
    pub rest: Rest,
}

/// How the natural length of a spring is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rest {
    /// Natural length, m, >= 0.
    Length(Num),
    /// Stretch at the start, m, >= 0 and not above the length of the spring there.
    Stretch(Num),
}

impl Scene {
    /// The same scene with a body on a pin told as what it is in the plane, a body that one joint holds; any other scene itself.
    pub fn in_the_plane(&self) -> Cow<'_, Self> {
        let Some((body, pin)) = self.pinned() else { return Cow::Borrowed(self) };
        let (zero, up, spot) = (Num::Fixed(0.0), pin.from == Zero::Upright, |point| Spot { body, point });
        let on_axis = |name: &str, x| (name.to_owned(), [Place::At(x), Place::At(zero)]);
        let mut scene = self.clone();
        scene.bodies[body].pin = None;
        scene.bodies[body].planar = Some(Planar {
            points: [on_axis("O", zero)]
                .into_iter()
                .chain(pin.spring.map(|s| on_axis("P", s.at_m)))
                .collect(),
            centre: match pin.arm {
                Arm::Distance(h) => Place::At(h),
                Arm::HalfOf(length) => Place::HalfOf(length),
            },
            from: if up { Ray::Up } else { Ray::Down },
            clockwise: up,
            start_deg: Some(pin.start_deg),
            driven: None,
            level: false,
            origin_m: None,
            side: None,
        });
        scene
            .joints
            .push(Joint { name: "O".to_owned(), kind: JointKind::Pin { at: spot(0), place_m: [zero; 2] } });
        scene.struts.extend(pin.spring.map(|s| Strut {
            name: "spring".to_owned(),
            at: spot(1),
            to: StrutEnd::Ground([s.x_m, s.y_m]),
            stiffness_n_m: s.stiffness_n_m,
            rest: s.rest,
            acts: Acts::Both,
        }));
        Cow::Owned(scene)
    }
}
