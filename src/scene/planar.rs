//! Bodies that move in the vertical plane otherwise than along a line or about one axle: rods in guides, hinged rods, cranks and
//! sliders.
//!
//! Places are told in a frame fixed in space, x to the right and y up. A body has an axis with its mass centre on it, and its points are
//! told by their distances from the origin of the axis, along it and to its left. The angle of the axis counts from one of four directions, in either sense; a turn is
//! positive as that angle grows.
use crate::scene::{Body, End, Num, Quantity, Scene};
use serde::{Deserialize, Serialize};

/// How a body lies in the plane and which of its points have names.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Planar {
    /// Points: name, and distance from the origin along the axis and to the left of it.
    pub points: Vec<(String, [Place; 2])>,
    /// Place of the mass centre.
    pub centre: Place,
    /// From where the angle of the axis counts.
    pub from: Ray,
    /// Does it count clockwise?
    pub clockwise: bool,
    /// Is no angle of it told, as of what is round ([`Scene::round_from_start`])? The speed of its centre is positive to the right then.
    pub unmarked: bool,
    /// Angle at the start, degrees, -360 to 360; `None` where the joints give it.
    pub start_deg: Option<Num>,
    /// The angular acceleration, rad/s^2, that a couple of its own gives it: it is driven.
    pub driven: Option<Num>,
    /// How it moves just before an impact in which its joints take hold.
    pub arrives: Option<Arrives>,
    /// Place of the origin of the axis at the start, m, of a body that no joint places.
    pub origin_m: Option<[Num; 2]>,
    /// Does its plane lie level, so that no weight acts in it?
    pub level: bool,
    /// Of the two ways in which the joints can place it, the one that is meant; `None` where the bank does not say it.
    pub side: Option<Branch>,
    /// Does a pin of its own hold it at the origin of its axis ([`Body::pin`])? Its angle then counts clockwise from upright or
    /// counter-clockwise from hanging.
    pub pinned: bool,
}

impl Planar {
    /// 1 where its angle counts counter-clockwise, else -1.
    pub const fn sense(&self) -> f64 {
        if self.clockwise { -1.0 } else { 1.0 }
    }
    /// Of a body that a pin of its own holds, with its mass centre so far from it; its angle counts from upright or from hanging.
    pub fn pinned(centre: Place, from: Ray, start_deg: Option<Num>) -> Self {
        Self {
            points: vec![("O".to_owned(), [Place::default(); 2])],
            centre,
            from,
            clockwise: from == Ray::Up,
            start_deg,
            pinned: true,
            ..Self::default()
        }
    }
}

/// How a body moves just before an impact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Arrives {
    /// Is no speed told? A pinned body then turns about its pin.
    pub turns_alone: bool,
    /// Speed of its mass centre, m/s.
    pub speed_m_s: Num,
    /// Direction of that speed, degrees counter-clockwise from the right.
    pub direction_deg: Num,
    /// Spin, rad/s, positive as its angle grows.
    pub spin_rad_s: Num,
}

/// A point of the axis.
pub const fn on_axis(along: Place) -> [Place; 2] {
    [along, Place::At(Num::Fixed(0.0))]
}

/// Which of two ways of placing a body is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Branch {
    /// Along the guide, or left of the line between the outer ends of two rods: so it is by default.
    Ahead,
    /// The other one.
    Behind,
}

/// A distance along the axis of a body, or to the left of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Place {
    /// Given, m, of either sign.
    At(Num),
    /// Half of this length.
    HalfOf(Num),
}

impl Default for Place {
    fn default() -> Self {
        Self::At(Num::default())
    }
}

impl Place {
    /// The number that tells it.
    pub const fn number(self) -> Num {
        let (Self::At(x) | Self::HalfOf(x)) = self;
        x
    }
}

/// A direction from which angles count.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Ray {
    /// To the right.
    #[default]
    Right,
    /// Up.
    Up,
    /// To the left.
    Left,
    /// Down.
    Down,
}

impl Ray {
    /// Its components to the right and up.
    pub const fn components(self) -> [f64; 2] {
        match self {
            Self::Right => [1.0, 0.0],
            Self::Up => [0.0, 1.0],
            Self::Left => [-1.0, 0.0],
            Self::Down => [0.0, -1.0],
        }
    }
}

/// A named point of a body: index of the body, and of the point among those of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Spot {
    /// Index of the body.
    pub body: usize,
    /// Index of the point.
    pub point: usize,
}

/// What holds points of bodies to the ground or to each other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Joint {
    /// Name, for `wall.normal`.
    pub name: String,
    /// What it does.
    pub kind: JointKind,
}

/// Kinds of joints.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum JointKind {
    /// A fixed pin: the point stays at this place, m.
    Pin {
        /// The point.
        at: Spot,
        /// Where it is.
        place_m: [Num; 2],
    },
    /// A hinge: two points of two bodies stay together; a weld, where the angle between their axes stays too.
    Hinge {
        /// The one point; the force of the hinge is told as it acts on this body.
        one: Spot,
        /// The other.
        other: Spot,
        /// Of a weld: how far the axis of the other body is turned from that of the one, degrees counter-clockwise.
        turned_deg: Option<Num>,
    },
    /// A straight guide, a wall, a floor: the point stays on a line. Its normal force is positive to the left of the direction.
    Guide {
        /// The point.
        at: Spot,
        /// Where the line is.
        line: Straight,
        /// Is its direction the one that was written turned about, so that it pushes to the left of it? What lies ahead on the line lies
        /// ahead as written.
        reversed: bool,
        /// Can it only push, so that the point can leave it?
        one_sided: bool,
        /// Kinetic friction coefficient; `None` if it is smooth.
        mu_k: Option<Num>,
    },
    /// A surface on which a wheel rolls, or on which a wheel or a point slides. It only pushes.
    Contact {
        /// The centre of the wheel, or the point.
        at: Spot,
        /// Radius of the wheel, m; 0 for a point.
        radius_m: Num,
        /// What it rolls or slides on.
        surface: Surface,
        /// Does it roll without slipping?
        rolls: bool,
        /// Kinetic friction coefficient of what slides; `None` if it is smooth, or rolls.
        mu_k: Option<Num>,
        /// By teeth, which press along the rim alone?
        teeth: bool,
    },
    /// A cord of constant length from the point to a fixed place, m, or over a small pulley there to another body; or a light rod,
    /// pinned at both ends.
    Cord {
        /// The point.
        at: Spot,
        /// The place.
        place_m: [Num; 2],
        /// The point to which it leads on, and the place of the small pulley, m, from which it comes there.
        beyond: Option<(Spot, [Num; 2])>,
        /// Is it a rod, which pushes as well as it pulls?
        rod: bool,
    },
}

/// A straight line, fixed in space or in a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Straight {
    /// A point of the body that carries it, through which it goes; `None`: it is fixed in space.
    pub on: Option<Spot>,
    /// A place on a line that is fixed in space, m.
    pub through_m: [Num; 2],
    /// Its direction, degrees counter-clockwise from the right, or from the axis of the body that carries it.
    pub direction_deg: Num,
}

impl Straight {
    /// Its direction, degrees counter-clockwise from the right; `None` where that is drawn, or changes with a body that turns: of one that
    /// is looked at only where it starts, it is known if the angle there is told.
    pub fn fixed_deg(&self, bodies: &[Body], still: bool) -> Option<f64> {
        let Num::Fixed(own) = self.direction_deg else { return None };
        let Some(on) = self.on else { return Some(own) };
        let body = bodies.get(on.body)?;
        let planar = body.planar.as_ref().filter(|p| !body.turns || still && p.start_deg.is_some())?;
        let Num::Fixed(angle) = planar.start_deg.unwrap_or(Num::Fixed(0.0)) else { return None };
        let axis = match planar.from {
            Ray::Right => 0.0,
            Ray::Up => 90.0,
            Ray::Left => 180.0,
            Ray::Down => -90.0,
        };
        Some(axis + planar.sense() * angle + own)
    }
}

/// A surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Surface {
    /// A line, whose left side is free.
    Line(Straight),
    /// A cylinder. The angle of a body that leads on it is that of the line from the axis of the cylinder to its centre.
    Arc {
        /// Its axis, m.
        centre_m: [Num; 2],
        /// Its radius, m.
        radius_m: Num,
        /// Is the body within it, or the cylinder within the body (a hoop on a peg)?
        inside: bool,
        /// The point of a body at its axis, about which that turns on a fixed pin; `None`: it does not turn.
        on: Option<Spot>,
    },
}

impl JointKind {
    /// The forces that it takes to hold: each has a condition of its own, as the friction of a guide that rubs has not.
    pub const fn forces(&self) -> &'static [Quantity] {
        match self {
            Self::Hinge { turned_deg: Some(_), .. } => &[Quantity::PinX, Quantity::PinY, Quantity::Moment],
            Self::Pin { .. } | Self::Hinge { .. } => &[Quantity::PinX, Quantity::PinY],
            Self::Guide { .. } | Self::Contact { rolls: false, .. } => &[Quantity::Normal],
            Self::Contact { teeth: true, .. } => &[Quantity::RimForce],
            Self::Contact { .. } => &[Quantity::Normal, Quantity::Friction],
            Self::Cord { .. } => &[Quantity::Tension],
        }
    }
    /// The impulses with which it answers a blow.
    pub const fn impulses(&self) -> &'static [Quantity] {
        match self {
            Self::Pin { .. } | Self::Hinge { .. } => &[Quantity::ImpulseX, Quantity::ImpulseY],
            Self::Contact { rolls: true, teeth: false, .. } => {
                &[Quantity::Impulse, Quantity::FrictionImpulse]
            }
            _ => &[Quantity::Impulse],
        }
    }
    /// Is it a level line in every draw, on the ground or on a body of this scene?
    pub fn is_level(&self, scene: &Scene) -> bool {
        let along = self.line().and_then(|line| line.fixed_deg(&scene.bodies, scene.is_still()));
        along.is_some_and(|at| at % 180.0 == 0.0)
    }
    /// Can it only push, so that its point can leave it?
    pub const fn only_pushes(&self) -> bool {
        matches!(self, Self::Guide { one_sided: true, .. } | Self::Contact { teeth: false, .. })
    }
    /// Does it hold the angle between its bodies?
    pub const fn is_weld(&self) -> bool {
        matches!(self, Self::Hinge { turned_deg: Some(_), .. })
    }
    /// Can it only push, or only pull?
    pub const fn is_one_sided(&self) -> bool {
        self.only_pushes() || matches!(self, Self::Cord { rod: false, .. })
    }
    /// Coefficient of kinetic friction at a guide or a surface that is rough.
    pub const fn mu_k(&self) -> Option<Num> {
        match *self {
            Self::Guide { mu_k, .. } | Self::Contact { mu_k, .. } => mu_k,
            _ => None,
        }
    }
    /// A point that rubs in a guide or the centre of a wheel that rubs on a surface, and does the guide hold it on both sides?
    pub fn rubs(&self) -> Option<(Spot, bool)> {
        let (at, ..) = self.surface().filter(|_| self.mu_k().is_some())?;
        Some((at, !self.only_pushes()))
    }
    /// Does this body rub there, or bear what does?
    fn rubs_on(&self, body: usize) -> bool {
        self.mu_k().is_some() && self.spots().any(|spot| spot.body == body)
    }
    /// Is it round at this surface, so that its angle does not matter there, and turned by it, as it rolls or rubs?
    const fn turns_round(&self) -> bool {
        matches!(self, Self::Contact { rolls: true, .. } | Self::Contact { mu_k: Some(_), .. })
    }
    /// The point that it holds at a surface, the radius of the wheel whose centre that is (0 of a point alone), and the surface.
    pub const fn surface(&self) -> Option<(Spot, Num, Surface)> {
        match *self {
            Self::Guide { at, line, .. } => Some((at, Num::Fixed(0.0), Surface::Line(line))),
            Self::Contact { at, radius_m, surface, .. } => Some((at, radius_m, surface)),
            _ => None,
        }
    }
    /// Does it hold a wheel that rolls, and by teeth?
    pub const fn rolls(&self) -> [bool; 2] {
        if let Self::Contact { rolls, teeth, .. } = *self { [rolls, teeth] } else { [false; 2] }
    }
    /// The straight line at which it holds its point.
    pub const fn line(&self) -> Option<Straight> {
        match self.surface() {
            Some((_, _, Surface::Line(line))) => Some(line),
            _ => None,
        }
    }
    /// The line that another body carries, on which it holds its point: a point of that body.
    pub fn carrier(&self) -> Option<Spot> {
        self.line()?.on
    }
    /// The cylinder that turns under its point with another body: a point of that body.
    pub fn drum(&self) -> Option<Spot> {
        if let Self::Contact { surface: Surface::Arc { on, .. }, .. } = *self { on } else { None }
    }
    /// What moves under its point, and bears the opposite of its force: a point of that body.
    pub fn bearer(&self) -> Option<Spot> {
        self.carrier().or_else(|| self.drum())
    }
    /// The points that it holds.
    pub fn spots(&self) -> impl Iterator<Item = Spot> {
        let (one, other) = match *self {
            Self::Hinge { one, other, .. } => (one, Some(other)),
            Self::Cord { at, beyond, .. } => (at, beyond.map(|(spot, _)| spot)),
            Self::Pin { at, .. } | Self::Guide { at, .. } | Self::Contact { at, .. } => (at, self.bearer()),
        };
        std::iter::once(one).chain(other)
    }
}

/// A force on a point of a body in the plane, or a blow: an impulse at the start.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Push {
    /// Name, such as `P`.
    pub name: String,
    /// The point.
    pub at: Spot,
    /// Magnitude, N, >= 0; of a blow N s.
    pub force_n: Num,
    /// Direction, degrees counter-clockwise from the right, or from the axis of the body.
    pub direction_deg: Num,
    /// Does its direction turn with the body?
    pub turns: bool,
    /// The place to which it is directed at all times, m, as a cord pulls that is led over a small pulley there.
    pub toward_m: Option<[Num; 2]>,
    /// Is it a blow?
    pub blow: bool,
}

/// A spring between a point of a body and a fixed place or a point of another body, or one that turns its body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Strut {
    /// Name.
    pub name: String,
    /// The point.
    pub at: Spot,
    /// Its other end.
    pub to: StrutEnd,
    /// Stiffness, > 0: N/m, of a torsion spring N m/rad.
    pub stiffness_n_m: Num,
    /// Its natural length, told directly or by its stretch at the start; of a torsion spring the angle of its body at which it is
    /// relaxed, or by which it is wound at the start, degrees.
    pub rest: Rest,
    /// Whether it pulls and pushes.
    pub acts: Acts,
}

impl Body {
    /// Does a pin of its own hold it?
    pub fn is_pinned(&self) -> bool {
        self.planar.as_ref().is_some_and(|p| p.pinned)
    }
    /// The pin of its own that holds it, called as the body is, at the origin of the frame.
    pub fn pin(&self, index: usize) -> Option<Joint> {
        let at = Spot { body: index, point: 0 };
        let kind = JointKind::Pin { at, place_m: [Num::Fixed(0.0); 2] };
        self.is_pinned().then(|| Joint { name: self.name.clone(), kind })
    }
    /// A spring from a point of its axis to a fixed place.
    pub fn spring(
        &mut self,
        index: usize,
        at: Num,
        place_m: [Num; 2],
        (stiffness_n_m, rest): (Num, Rest),
    ) -> Option<Strut> {
        let planar = self.planar.as_mut()?;
        planar.points.push(("P".to_owned(), on_axis(Place::At(at))));
        let at = Spot { body: index, point: planar.points.len() - 1 };
        let to = StrutEnd::Ground(place_m);
        Some(Strut { name: "spring".to_owned(), at, to, stiffness_n_m, rest, acts: Acts::Both })
    }
}

impl Scene {
    /// [`Planar::sense`] of a body; 1 of one that is not in the plane.
    pub fn sense(&self, body: usize) -> f64 {
        self.planar(body).map_or(1.0, Planar::sense)
    }
    /// The only body of the scene, if its own pin is all that holds it and its weight, couples and a spring to a fixed place are all
    /// that acts on it: what is told of such a pin and spring is told of the body.
    pub fn pinned(&self) -> Option<(usize, &Planar)> {
        let ([body], [_], []) = (&self.bodies[..], &self.joints[..], &self.pushes[..]) else { return None };
        let grounded = |s: &Strut| s.acts == Acts::Both && matches!(s.to, StrutEnd::Ground(_));
        let swings = self.end != End::Equilibrium && self.struts.iter().all(grounded);
        let planar = body.planar.as_ref().filter(|p| p.pinned && p.driven.is_none());
        planar.filter(|_| swings).map(|planar| (0, planar))
    }
    /// The joint along whose straight line the speed of a body is told where others are told besides, and the point that it holds.
    pub fn guide_of(&self, body: usize) -> Option<(usize, Spot)> {
        self.joints.iter().enumerate().find_map(|(j, joint)| {
            let (at, _, surface) = joint.kind.surface()?;
            (at.body == body && matches!(surface, Surface::Line(_))).then_some((j, at))
        })
    }
    /// The point at the only pin of bodies that are welded into one.
    pub fn only_pin(&self) -> Option<Spot> {
        let particle = |spot: &Spot| self.bodies[spot.body].inertia.is_none();
        let mut pin = None;
        let rigid = self.joints.iter().all(|joint| match joint.kind {
            JointKind::Pin { at, .. } => pin.replace(at).is_none(),
            JointKind::Hinge { one, other, turned_deg } => {
                turned_deg.is_some() || [one, other].iter().any(particle)
            }
            _ => false,
        });
        pin.filter(|_| rigid && self.joints.len() == self.bodies.len())
    }
    /// Bodies in the plane that are held and pushed at their mass centres alone keep from turning: nothing has a moment about these.
    pub fn still_turns(&mut self) {
        // What acts at points, and the bodies that something turns, or that are said to.
        let mut acts: Vec<Spot> = self.pushes.iter().map(|push| push.at).collect();
        let mut turned: Vec<usize> = self.couples.iter().map(|couple| couple.body).collect();
        turned.extend(self.start_speeds().map(|(c, _)| c.body));
        let spins = |b: &Body| {
            b.planar.as_ref().and_then(|p| p.arrives).is_some_and(|a| a.spin_rad_s != Num::Fixed(0.0))
        };
        turned.extend((0..self.bodies.len()).filter(|b| spins(&self.bodies[*b])));
        for joint in &self.joints {
            let turns = joint.kind.is_weld() || joint.kind.turns_round();
            for spot in joint.kind.spots() {
                acts.push(spot);
                turned.extend(turns.then_some(spot.body));
            }
        }
        for strut in &self.struts {
            acts.push(strut.at);
            match strut.to {
                StrutEnd::Spot(to) => acts.push(to),
                StrutEnd::Twist => turned.push(strut.at.body),
                StrutEnd::Ground(_) | StrutEnd::Guide { .. } => {}
            }
        }
        for (b, body) in self.bodies.iter_mut().enumerate() {
            let Some(planar) = body.planar.as_ref().filter(|p| p.start_deg.is_none()) else { continue };
            let centre = on_axis(planar.centre);
            let off = |spot: &Spot| spot.body == b && planar.points[spot.point].1 != centre;
            body.turns &= turned.contains(&b) || acts.iter().any(off);
        }
    }
    /// What rolls or rubs on a line about its mass centre looks the same at every angle: where no angle is given, and nothing else turns
    /// or it slips, that of the first counts from the start.
    pub fn round_from_start(&mut self) {
        let round = |body: usize| {
            let on_line = |joint: &Joint| match joint.kind {
                JointKind::Contact { at, surface: Surface::Line(_), .. } => {
                    at.body == body && joint.kind.turns_round()
                }
                _ => joint.kind.drum().is_some_and(|on| on.body == body),
            };
            let centred = |planar: &Planar| planar.points.iter().all(|(_, at)| *at == on_axis(planar.centre));
            self.joints.iter().any(on_line) && self.planar(body).is_some_and(centred)
        };
        let turning = || (0..self.bodies.len()).filter(|body| self.bodies[*body].turns);
        let slips = |body: &usize| {
            let own = |joint: &Joint| joint.kind.rubs_on(*body);
            round(*body) && self.joints.iter().any(own)
        };
        let first = turning().find(slips).or_else(|| turning().next().filter(|_| turning().all(round)));
        let first = first.filter(|_| self.lead().is_none());
        if let Some(planar) = first.and_then(|body| self.bodies[body].planar.as_mut()) {
            planar.start_deg = Some(Num::Fixed(0.0));
            planar.unmarked = true;
        }
    }
    /// Does the leading body rub while it turns about its mass centre, at which alone it is held, so that nothing else moves and nothing
    /// changes?
    pub fn spins_in_place(&self) -> bool {
        let Some((lead, planar)) = self.lead().and_then(|lead| Some((lead, self.planar(lead)?))) else {
            return false;
        };
        let centred = |spot: Spot| spot.body != lead || planar.points[spot.point].1 == on_axis(planar.centre);
        let turned = |joint: &Joint| {
            (joint.kind.is_weld() || joint.kind.rolls()[0])
                && joint.kind.spots().any(|spot| spot.body == lead)
        };
        let springs = |s: &Strut| match s.to {
            StrutEnd::Twist => s.at.body != lead,
            StrutEnd::Spot(to) => centred(s.at) && centred(to),
            StrutEnd::Ground(_) | StrutEnd::Guide { .. } => centred(s.at),
        };
        self.bodies[lead].turns
            && self.joints.iter().any(|joint| joint.kind.rubs_on(lead))
            && self.joints.iter().all(|joint| joint.kind.spots().all(centred) && !turned(joint))
            // A line that turns with it changes place.
            && self.joints.iter().filter_map(|joint| joint.kind.carrier()).all(|on| on.body != lead)
            && self.pushes.iter().all(|push| centred(push.at) && !(push.turns && push.at.body == lead))
            && self.struts.iter().all(springs)
    }
    /// The bodies that move just before an impact, and how.
    pub fn arrivals(&self) -> impl Iterator<Item = (usize, Arrives)> {
        let arrives = |(b, body): (usize, &Body)| Some((b, body.planar.as_ref()?.arrives?));
        self.bodies.iter().enumerate().filter_map(arrives)
    }
    /// The point of a body about which it turns just before an impact: that at its pin.
    pub fn turns_about(&self, (body, arrives): (usize, Arrives)) -> Option<Spot> {
        self.joints.iter().find_map(|joint| match joint.kind {
            JointKind::Pin { at, .. } if at.body == body && arrives.turns_alone => Some(at),
            _ => None,
        })
    }
    /// The torsion spring that is wound by half a turn or more at the start, as far as the data say it.
    pub fn overwound(&self, data: &[f64]) -> Option<usize> {
        let wound = |strut: &Strut| match (strut.rest, self.planar(strut.at.body)?.start_deg) {
            (Rest::Stretch(by), _) => Some(self.value(by, data)),
            (Rest::Length(at), Some(start)) => Some(self.value(start, data) - self.value(at, data)),
            _ => None,
        };
        let far = |s: &Strut| s.twists() && wound(s).is_some_and(|angle| angle.abs() >= 180.0);
        self.struts.iter().position(far)
    }
}

/// How the natural length of a spring is given.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Rest {
    /// Natural length, m, >= 0.
    Length(Num),
    /// Stretch at the start, m, not above the length of the spring there.
    Stretch(Num),
}

/// Does a spring pull and push? One that does but one of them is met on the way, and let go of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Acts {
    /// Both.
    #[default]
    Both,
    /// It pushes where it is shorter than its natural length, or turns its body forward.
    Pushes,
    /// It pulls where it is longer, or turns its body back.
    Pulls,
}

impl Strut {
    /// Is it a torsion spring?
    pub const fn twists(&self) -> bool {
        matches!(self.to, StrutEnd::Twist)
    }
    /// Units of its stiffness and of what says when it is relaxed.
    pub const fn units(&self) -> [&'static str; 2] {
        if self.twists() { ["N*m/rad", "1"] } else { ["N/m", "m"] }
    }
}

/// The other end of a spring.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum StrutEnd {
    /// A fixed place, m.
    Ground([Num; 2]),
    /// A point of a body.
    Spot(Spot),
    /// A smooth guide along which it follows the point, so that the spring stands at right angles to it.
    Guide {
        /// A place on the line, m.
        through_m: [Num; 2],
        /// Direction of the line, degrees counter-clockwise from the right.
        direction_deg: Num,
    },
    /// None: a torsion spring, which holds its body back by its angle, from half a turn before to half a turn after where it is relaxed.
    Twist,
}
