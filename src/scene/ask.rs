//! Which quantity, of which body or cord. The names are fixed: scripts rely on them.
use crate::num::Real;
use crate::num::half::Half;
use crate::scene::{
    Acts, Body, Coordinate, Cord, Degree, End, Far, Joint, JointKind, Made, Num, Numbers, Planar, Scene,
    Slope, Spot, SpringTie, Straight, Strut, StrutEnd, Surface, Tie,
};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What a quantity belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Owner {
    /// The scene as a whole.
    Scene,
    /// A body, by index.
    Body(usize),
    /// A tie, by index.
    Tie(usize),
    /// A joint, by index.
    Joint(usize),
    /// A spring at a point of a body in the plane, by index.
    Strut(usize),
    /// A named point of a body in the plane.
    Spot(Spot),
    /// A question that asks by a formula, by its index in [`crate::scene::Formulas::asked`].
    Asked(usize),
}

/// A quantity of a body, a tie or the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Label {
    /// Which quantity.
    pub quantity: Quantity,
    /// Whose.
    pub of: Owner,
}

/// What the sign of a quantity means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// Never negative, whichever way the scene goes.
    Magnitude,
    /// A direction along the line of the body, so that `62.6 N down` is an answer.
    Directed,
    /// Positive or negative, and no word says which.
    Signed,
    /// The answer is a word (`up`, `yes`) and no number.
    Word,
}

macro_rules! quantities {
    ($($variant:ident $name:literal $unit:literal $sign:ident $doc:literal;)*) => {
        /// The quantities that the solvers give.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum Quantity {
            $(#[doc = $doc] $variant,)*
            /// An expression that a bank asks for; no solver gives it.
            Value,
        }
        impl Quantity {
            /// Is it told of the mass centre of a body, or does it hang on where that lies?
            pub const fn is_of_mass_centre(self) -> bool {
                use Quantity as Q;
                matches!(self, Q::V | Q::VX | Q::VY | Q::AX | Q::AY | Q::Rise | Q::AngularMomentum | Q::Impulse)
            }
            /// All that the solvers give, in the order in which they are listed.
            pub const ALL: &'static [Quantity] = &[$(Quantity::$variant,)*];
            /// Name in banks, keys and JSON.
            pub const fn name(self) -> &'static str {
                match self { $(Quantity::$variant => $name,)* Quantity::Value => "value" }
            }
            /// SI unit, ASCII; `1` for a pure number, empty for a word.
            pub const fn unit(self) -> &'static str {
                match self { $(Quantity::$variant => $unit,)* Quantity::Value => "1" }
            }
            /// What its sign means.
            pub const fn sign(self) -> Sign {
                match self { $(Quantity::$variant => Sign::$sign,)* Quantity::Value => Sign::Signed }
            }
            /// What it is, in words.
            pub const fn meaning(self) -> &'static str {
                match self { $(Quantity::$variant => $doc,)* Quantity::Value => "an expression that is asked" }
            }
        }
    };
}
quantities! {
    Omega "omega" "rad/s" Magnitude "angular speed at the end, a magnitude";
    V "v" "m/s" Magnitude "speed of the mass centre at the end, a magnitude";
    A "a" "m/s^2" Directed "acceleration of the mass centre at the end, positive forward";
    Alpha "alpha" "rad/s^2" Signed "angular acceleration at the end, positive with rolling forward or with growing angle; of joined bodies without an angle, counter-clockwise";
    Friction "friction" "N" Directed "friction force on the body at the end, positive up the incline";
    Normal "normal" "N" Magnitude "normal force of the surface";
    MuRequired "mu_required" "1" Magnitude "least static friction coefficient for rolling from the start to the end (to the turning point where a quantity of the whole motion is asked)";
    T "t" "s" Magnitude "time from the start to the end";
    Tension "tension" "N" Signed "tension of the cord at the end, of a light rod its force, positive if it pulls";
    RimForce "rim_force" "N" Magnitude "force between the teeth of two gears along their rims, or along the surface between a body and the wheel that it rests on; of a belt the difference of its two tensions; of a joint on the gear, positive to the right of the direction to its centre";
    CordTravel "cord_travel" "m" Magnitude "distance that the pulled end of the cord moves";
    SlipDistance "slip_distance" "m" Magnitude "distance that the contact slips, a magnitude";
    SlipSpeed "slip_speed" "m/s" Magnitude "speed at which the contact slips at the start, a magnitude";
    Displacement "displacement" "m" Directed "displacement of the mass centre from start to end, positive forward";
    Distance "distance" "m" Magnitude "distance that the mass centre moves, there and back, a magnitude";
    ARolling "a_rolling" "m/s^2" Directed "acceleration of the mass centre once it rolls, positive forward";
    Phi "phi" "rad" Magnitude "angle turned, a magnitude; from start to end where a spin turns back";
    Angle "angle" "rad" Signed "angle of the leading body at the end, counted as at the start";
    Heat "heat" "J" Magnitude "heat of sliding friction";
    WorkPull "work_pull" "J" Signed "work of the pull";
    PowerPull "power_pull" "W" Signed "power of the pull at the end, or at once";
    WorkCouple "work_couple" "J" Signed "work of the couples on the body";
    PowerCouple "power_couple" "W" Signed "power of the couples on the body at the end, or at once, that of its drive among them";
    Work "work" "J" Signed "work of all forces together, from the start to the end";
    Impulse "impulse" "N*s" Signed "impulse of all forces on the body, positive forward; of a joint its impulse at a blow, of a surface the part at right angles to it";
    Moment "moment" "N*m" Signed "couple of a weld on its first body, positive counter-clockwise; of a torsion spring on its body, positive as its angle grows";
    Drive "drive" "N*m" Signed "couple that drives a body so that it turns as it is said to, positive with growing angle";
    ImpulseX "impulse_x" "N*s" Signed "impulse of a pin or hinge on its first body at a blow, positive to the right";
    ImpulseY "impulse_y" "N*s" Signed "impulse of a pin or hinge on its first body at a blow, positive up";
    FrictionImpulse "friction_impulse" "N*s" Signed "impulse of the friction of a surface on what rolls on it, at a blow, positive up the surface or to the right";
    AngularMomentum "angular_momentum" "kg*m^2/s" Magnitude "angular momentum about the mass centre, or about the axle or the pin, at the end, a magnitude";
    FrictionIfRolled "friction_if_rolled" "N" Directed "friction that rolling without slipping would need, positive up the incline";
    KBound "k_bound" "m" Magnitude "radius of gyration below which friction points up the incline at this pull";
    XEq "x_eq" "m" Magnitude "stretch of the spring at equilibrium";
    VMax "v_max" "m/s" Magnitude "greatest speed of the motion";
    DAtVMax "D_at_v_max" "m" Magnitude "distance from release at which the speed is greatest";
    DTurn "D_turn" "m" Magnitude "distance from release to the turning point";
    KineticEnergy "kinetic_energy" "J" Magnitude "kinetic energy at the end";
    RotationalFraction "rotational_fraction" "1" Magnitude "share of the kinetic energy that is rotational";
    Rise "rise" "m" Signed "height gained by the mass centre, negative when it sinks";
    XG "x_G" "m" Signed "x of the mass centre";
    YG "y_G" "m" Signed "y of the mass centre";
    IG "I_G" "kg*m^2" Magnitude "moment of inertia about the mass centre";
    IO "I_O" "kg*m^2" Magnitude "moment of inertia about the pin";
    PinRadial "pin_radial" "N" Signed "force of the pin on the body along the line to the mass centre, positive toward the pin";
    PinTangential "pin_tangential" "N" Signed "force of the pin on the body across that line, positive with growing angle";
    PinForce "pin_force" "N" Magnitude "force of the pin or axle on the body, a magnitude";
    PinX "pin_x" "N" Signed "horizontal part of the force of the pin on the body, positive to the side of small positive angles; of joined bodies and of a fixed axle, to the right";
    PinY "pin_y" "N" Signed "vertical part of the force of the pin on the body, positive up";
    PinAngle "pin_angle" "rad" Signed "angle of the force of the pin on the body to the horizontal, positive up from the side of small positive angles; of joined bodies and of a fixed axle, from the right";
    SpringForce "spring_force" "N" Signed "force of the spring, positive if it pulls";
    OmegaMax "omega_max" "rad/s" Magnitude "greatest angular speed of the motion";
    Period "period" "s" Magnitude "time of a full swing to and fro, or of a full turn where it goes over the top";
    PeriodSmall "period_small" "s" Magnitude "period of small oscillations";
    OmegaSmall "omega_small" "rad/s" Magnitude "angular frequency of small oscillations";
    VX "v_x" "m/s" Signed "velocity of the mass centre to the right at the end";
    VY "v_y" "m/s" Signed "velocity of the mass centre up at the end";
    AX "a_x" "m/s^2" Signed "acceleration of the mass centre to the right at the end";
    AY "a_y" "m/s^2" Signed "acceleration of the mass centre up at the end";
    Direction "direction" "" Word "up or down (forward or back on level ground)";
    Rolls "rolls" "" Word "yes if it could roll without slipping, else no";
}

/// A set of quantities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantities(u64);

impl Quantities {
    /// All there are.
    pub const ALL: Self = Self(u64::MAX);
    /// Is this one among them?
    pub const fn has(self, quantity: Quantity) -> bool {
        self.0 >> quantity as u32 & 1 == 1
    }
    /// All of them but this one.
    pub const fn without(self, quantity: Quantity) -> Self {
        Self(self.0 & !(1 << quantity as u32))
    }
    /// All that are in either.
    pub const fn with(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }
    /// How many there can be.
    pub const fn count(self) -> usize {
        self.0.count_ones() as usize
    }
}

impl FromIterator<Quantity> for Quantities {
    fn from_iter<I: IntoIterator<Item = Quantity>>(quantities: I) -> Self {
        Self(quantities.into_iter().fold(0, |all, q| all | 1 << q as u32))
    }
}

impl Quantity {
    /// The quantity of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|q| q.name() == name)
    }
    /// Is its answer a word and not a number?
    pub const fn is_word(self) -> bool {
        matches!(self.sign(), Sign::Word)
    }
    /// Is it a number that is never negative, or no number at all?
    pub const fn is_magnitude(self) -> bool {
        matches!(self.sign(), Sign::Magnitude | Sign::Word)
    }
    /// Is its sign a direction along the line of the body?
    pub const fn is_directed(self) -> bool {
        matches!(self.sign(), Sign::Directed)
    }
    /// What it is, and which sign its number has, as far as that is said of it: `positive forward`, `a magnitude`.
    pub fn meaning_and_sign(self) -> (&'static str, &'static str) {
        let says = |text: &str| ["a magnitude", "positive", "negative"].iter().any(|s| text.starts_with(s));
        match self.meaning().split_once(", ") {
            Some((what, sign)) if says(sign) => (what, sign),
            _ => (self.meaning(), ""),
        }
    }
    /// Is it a quantity of the whole motion up to the turning point, whatever end is asked?
    pub const fn looks_beyond(self) -> bool {
        matches!(self, Self::VMax | Self::DAtVMax | Self::DTurn)
    }
    /// Has it the dimension of mass in it? All units that have begin with one of these letters.
    pub const fn is_massive(self) -> bool {
        matches!(self.unit().as_bytes(), [b'N' | b'J' | b'W' | b'k', ..])
    }
    /// Is it a coordinate of a point?
    pub const fn is_place(self) -> bool {
        matches!(self, Self::XG | Self::YG)
    }
}

impl Scene {
    /// The body that bare names mean: the scene's only body, else its only body that both moves and turns.
    pub fn bare_body(&self) -> Option<usize> {
        if self.bodies.len() == 1 {
            return Some(0);
        }
        let mut wheels = self.bodies.iter().enumerate().filter(|(_, b)| b.line.is_some() && b.turns);
        match (wheels.next(), wheels.next()) {
            (Some((i, _)), None) => Some(i),
            _ => None,
        }
    }
    /// Cords of which this quantity is asked: pulled ones for the work of the pull, springs too for the travel of the
    /// cord's end, the others for the tension.
    pub fn cords_with(&self, quantity: Quantity) -> impl Iterator<Item = (usize, &str)> {
        self.ties.iter().enumerate().filter_map(move |(i, t)| match t {
            Tie::Cord(c) => {
                let pulled = matches!(c.to, Far::Pull(_));
                let spring = matches!(c.to, Far::Spring { .. });
                let has = match quantity {
                    Quantity::Tension | Quantity::RimForce => !pulled && c.force() == quantity,
                    Quantity::CordTravel => pulled || spring,
                    Quantity::XEq => spring,
                    _ => pulled,
                };
                has.then_some((i, c.name.as_str()))
            }
            _ => None,
        })
    }
    /// What an owner of quantities is called: `block`, `left`, `rod.B`; `None` for the scene as a whole.
    pub fn owner_name(&self, of: Owner) -> Option<Cow<'_, str>> {
        let name = match of {
            Owner::Scene | Owner::Asked(_) => return None,
            Owner::Body(b) => &self.bodies.get(b)?.name,
            Owner::Tie(t) => match self.ties.get(t)? {
                Tie::Cord(cord) => &cord.name,
                _ => return None,
            },
            Owner::Joint(j) => &self.joints.get(j)?.name,
            Owner::Strut(s) => &self.struts.get(s)?.name,
            Owner::Spot(spot) => {
                let (body, point) = self.point_name(spot)?;
                return Some(Cow::Owned(format!("{body}.{point}")));
            }
        };
        Some(Cow::Borrowed(name))
    }
    /// Name of a label: `omega`, `block.v`, `left.tension`.
    pub fn name_of(&self, label: Label) -> String {
        let q = label.quantity.name();
        let bare = match label.of {
            Owner::Asked(i) => return self.formulas.asked.get(i).map_or(q, |a| &a.id).to_owned(),
            Owner::Body(b) => self.bare_body() == Some(b),
            Owner::Tie(_) => self.cords_with(label.quantity).count() <= 1,
            _ => false,
        };
        match self.owner_name(label.of) {
            Some(name) if !bare => format!("{name}.{q}"),
            _ => q.to_owned(),
        }
    }
    /// The cords that are pulled: index of the tie, the cord, and the force, N.
    pub fn pulls(&self) -> impl Iterator<Item = (usize, &Cord, Num)> {
        self.ties.iter().enumerate().filter_map(|(tie, t)| match t {
            Tie::Cord(cord @ Cord { to: Far::Pull(force), .. }) => Some((tie, cord, *force)),
            _ => None,
        })
    }
    /// The springs of the scene, in the order of its ties.
    pub fn springs(&self) -> impl Iterator<Item = SpringTie> {
        self.ties.iter().enumerate().filter_map(|(tie, t)| match *t {
            Tie::Cord(Cord { from, to: Far::Spring { stiffness_n_m, stretch_m, rigid }, .. }) => {
                Some(SpringTie { tie, from, stiffness_n_m, stretch_m, rigid })
            }
            _ => None,
        })
    }
    /// Is there a spring on a line or an axle?
    pub fn is_sprung(&self) -> bool {
        self.springs().next().is_some()
    }
    /// How a body lies in the plane.
    pub fn planar(&self, body: usize) -> Option<&Planar> {
        self.bodies.get(body)?.planar.as_ref()
    }
    /// Names of a point of a body in the plane: of the body, and its own.
    pub fn point_name(&self, spot: Spot) -> Option<(&str, &str)> {
        let (point, _) = self.planar(spot.body)?.points.get(spot.point)?;
        Some((self.bodies[spot.body].name.as_str(), point.as_str()))
    }
    /// The body that leads the others in the plane: the first that turns, or moves on a cylinder, and whose angle at the start is
    /// given; the first of all where none turns.
    pub fn lead(&self) -> Option<usize> {
        let on_arc = |body: usize| {
            self.joints.iter().any(|j| matches!(j.kind, JointKind::Contact { at, surface: Surface::Arc { .. }, .. } if at.body == body))
        };
        let starts = |b: &Body| b.planar.as_ref().is_some_and(|p| p.start_deg.is_some());
        // Where no body turns and each is told where it is, none hangs on another.
        let still = |b: &Body| !b.turns && b.planar.as_ref().is_some_and(|p| p.origin_m.is_some());
        let all_still = || self.bodies.iter().all(still).then_some(0).filter(|_| !self.bodies.is_empty());
        self.bodies
            .iter()
            .enumerate()
            .position(|(i, b)| starts(b) && (b.turns || on_arc(i)))
            .or_else(all_still)
    }
    /// Does the leading angle tell where the centre of a body is on the cylinder of this joint, and not the body's own angle? Of what
    /// rolls there or does not turn; of another body unless more holds it to the ground.
    pub fn leads_on_arc(&self, joint: usize) -> bool {
        let JointKind::Contact { at, surface: Surface::Arc { .. }, rolls, .. } = self.joints[joint].kind
        else {
            return false;
        };
        let holds = |(j, other): (usize, &Joint)| {
            let grounded =
                !matches!(other.kind, JointKind::Hinge { .. } | JointKind::Cord { rod: false, .. });
            j != joint && grounded && other.kind.spots().any(|spot| spot.body == at.body)
        };
        rolls || !self.bodies[at.body].turns || !self.joints.iter().enumerate().any(holds)
    }
    /// Angle of the leading body at the start.
    pub fn start_angle<T: Real>(&self, n: &Numbers<T>) -> Half<T> {
        let start = self.lead().and_then(|lead| self.planar(lead)?.start_deg);
        Half::of_degrees(start.map_or_else(T::zero, |start| n.get(start)))
    }
    /// The body whose angle at the end is told: that which leads, by an angle that the scene tells at the start and not at the end.
    pub fn ends_at_an_angle(&self) -> Option<usize> {
        let lead = self.lead()?;
        let counts = self.planar(lead).is_some_and(|p| p.start_deg.is_some() && !p.unmarked);
        (counts && !self.is_still() && !matches!(self.end, End::Angle(..))).then_some(lead)
    }
    /// Is an instant asked, or bodies at rest, and no motion?
    pub const fn is_still(&self) -> bool {
        matches!(self.end, End::AtOnce | End::Equilibrium)
    }
    /// Does the motion end where a body is at a place that is told, at a position or at an angle?
    pub const fn ends_at_a_place(&self) -> bool {
        matches!(self.end, End::Position(..) | End::Angle(..))
    }
    /// The angular acceleration that a drive gives the leading body.
    pub fn driven(&self) -> Option<Num> {
        self.planar(self.lead()?)?.driven
    }
    /// Does an impulse or an impact set the bodies off?
    pub fn is_struck(&self) -> bool {
        self.pushes.iter().any(|p| p.blow)
            || self.bodies.iter().any(|b| b.planar.as_ref().is_some_and(|p| p.arrives.is_some()))
    }
    /// Do the bodies move in a horizontal plane, in which no weight acts?
    pub fn lies_level(&self) -> bool {
        self.bodies.iter().any(|b| b.planar.as_ref().is_some_and(|p| p.level))
    }
    /// Do the forces alone set it going: no speed at the start, no blow?
    pub fn starts_from_rest(&self) -> bool {
        self.start.is_empty() && !self.is_struck()
    }
    /// The direction in which the leading body could drift, degrees, where it has but one smooth level guide and no force along
    /// it: from rest its mass centre then stays where it is in that direction.
    pub fn drifts(&self) -> Option<Num> {
        let lead = self.lead().filter(|_| self.carried.is_none())?;
        let mut found = None;
        for joint in &self.joints {
            if joint.kind.spots().all(|s| s.body != lead) {
                continue;
            }
            match (found, joint.kind) {
                (
                    None,
                    JointKind::Guide {
                        line: Straight { on: None, direction_deg: Num::Fixed(d), .. },
                        mu_k: None,
                        ..
                    }
                    | JointKind::Contact {
                        surface: Surface::Line(Straight { on: None, direction_deg: Num::Fixed(d), .. }),
                        rolls: false,
                        mu_k: None,
                        ..
                    },
                ) if d % 180.0 == 0.0 => {
                    found = Some(Num::Fixed(d));
                }
                _ => return None,
            }
        }
        // A spring that stays across a level line pulls across it.
        let across = |s: &Strut| matches!(s.to, StrutEnd::Guide { direction_deg: Num::Fixed(d), .. } if d % 180.0 == 0.0);
        let pushed = self.pushes.iter().any(|p| p.at.body == lead) || !self.struts.iter().all(across);
        found.filter(|_| !pushed)
    }
    /// Does it oscillate about its equilibrium, on lines, by a spring and without friction of sliding?
    pub fn oscillates(&self) -> bool {
        let rubs = |t: &Tie| matches!(t, Tie::Slip { .. } | Tie::Slide { .. });
        self.is_sprung() && !self.ties.iter().any(rubs)
    }
    /// Is there nothing on the pinned body but its weight, so that it swings to and fro in a period?
    pub fn is_pendulum(&self) -> bool {
        self.couples.is_empty() && self.struts.is_empty() && self.pinned().is_some()
    }
    /// What is taken away of this body.
    pub fn holes(&self, body: usize) -> impl Iterator<Item = usize> {
        let welds = self
            .joints
            .iter()
            .filter(move |joint| joint.kind.is_weld() && joint.kind.spots().any(|spot| spot.body == body));
        let parts = welds.flat_map(|joint| joint.kind.spots()).map(|spot| spot.body);
        parts.filter(move |part| *part != body && self.bodies[*part].removed && !self.bodies[body].removed)
    }
    /// Does this body rest on wheels?
    pub fn rests(&self, body: usize) -> bool {
        let on_wheels = |c: &Cord| c.made == Made::Rests && c.from.body == body;
        self.ties.iter().any(|t| matches!(t, Tie::Cord(c) if on_wheels(c)))
    }
    /// Does nothing press this body on its surface, which is vertical, and nothing rub there? It then rolls, or lies on what rolls, by
    /// its teeth.
    fn hangs_by_teeth(&self, body: usize) -> bool {
        let needs = |t: &Tie| match t {
            Tie::Roll { body: b, mu_s, .. } => *b == body && mu_s.is_some(),
            Tie::Slip { body: b, .. } | Tie::Slide { body: b, .. } => *b == body,
            Tie::Cord(_) => t.tilted().is_some_and(|(b, ..)| b == body),
        };
        let vertical = self.bodies[body].line.is_some_and(|l| l.slope == Slope::Vertical);
        let held = |t: &Tie| matches!(t, Tie::Roll { body: b, .. } if *b == body);
        let toothed = self.rests(body) || self.ties.iter().any(held);
        vertical && self.carried.is_none() && toothed && !self.ties.iter().any(needs)
    }
    /// Is this told of the scene? Of what is carried what is seen from the ground, and what is the same from everywhere.
    pub fn tells(&self, label: Label) -> bool {
        use Quantity as Q;
        let bears = |b: usize| {
            let on_it = |c: &Cord| c.made == Made::Rests && matches!(c.to, Far::Body(end) if end.body == b);
            self.ties.iter().any(|t| matches!(t, Tie::Cord(c) if on_it(c)))
        };
        // What is taken away has nothing of its own, and nothing holds it.
        let removed = |b: usize| self.bodies[b].removed;
        if match label.of {
            Owner::Body(b) => removed(b),
            Owner::Spot(spot) => removed(spot.body),
            Owner::Joint(j) => self.joints[j].kind.spots().any(|spot| removed(spot.body)),
            _ => false,
        } {
            return false;
        }
        // Where the mass centre of a body lies in which there is a hole, it alone does not say.
        if let Owner::Body(b) = label.of
            && label.quantity.is_of_mass_centre()
            && self.holes(b).next().is_some()
        {
            return false;
        }
        // How a load is shared by what bears it is not known.
        if let (Q::Normal | Q::MuRequired, Owner::Body(b)) = (label.quantity, label.of)
            && (bears(b) || self.hangs_by_teeth(b))
        {
            return false;
        }
        if self.carried.is_none() {
            return true;
        }
        let plane = self.lead().is_some();
        match label.quantity {
            Q::Rise => matches!(self.end, End::Equilibrium),
            // Over which time it is carried is not known where forces grow with place.
            Q::V | Q::Displacement => !plane && !self.grows_with_place(),
            Q::VX | Q::VY | Q::AngularMomentum => !plane,
            Q::KineticEnergy | Q::Work => {
                let steady = !self.is_sprung() && self.growths.is_empty();
                steady && !self.is_still() && self.bodies.iter().all(|b| b.line.is_some())
            }
            Q::Distance
            | Q::Impulse
            | Q::CordTravel
            | Q::WorkPull
            | Q::PowerPull
            | Q::VMax
            | Q::DAtVMax
            | Q::DTurn
            | Q::KBound
            | Q::RotationalFraction => false,
            _ => true,
        }
    }
    /// The coordinate that the ending event watches; the line (or turn) of the first body if the scene is an instant.
    pub fn ending_coordinate(&self) -> Coordinate {
        match self.end {
            End::Travel(c, _)
            | End::Position(c, _)
            | End::Time(c, _)
            | End::Speed(c, _)
            | End::Angle(c, _)
            | End::TurningPoint(c)
            | End::Rolling(c) => c,
            End::AtOnce | End::Leaves(_) | End::Equilibrium => {
                let first =
                    || self.coordinates().next().unwrap_or(Coordinate { body: 0, degree: Degree::Along });
                self.lead().map_or_else(first, |body| Coordinate { body, degree: Degree::Turn })
            }
        }
    }
    /// The unit in which the end of a motion is told.
    pub fn measure(&self) -> &'static str {
        let turns = |c: Coordinate| c.degree == Degree::Turn;
        let pinned = self.lead().is_some();
        match self.end {
            End::Time(..) | End::Rolling(_) => "s",
            End::Speed(c, _) if pinned || turns(c) => "rad/s",
            End::Speed(..) => "m/s",
            _ if pinned => "degrees",
            End::Travel(c, _) | End::Position(c, _) | End::TurningPoint(c) | End::Angle(c, _) if turns(c) => {
                "rad"
            }
            _ => "m",
        }
    }
    /// Is this asked as a number that is never negative, or no number at all? The normal force of a fixed guide that holds on both
    /// sides has a sense that words tell; of one that a body carries, or that is drawn, and of a force along a rim the size is asked.
    /// Of a spring that only pushes, or only pulls, the size is asked; one that does both may be shortened at equilibrium.
    pub fn is_magnitude(&self, label: Label) -> bool {
        let joint = match label.of {
            Owner::Joint(j) => self.joints.get(j).map(|joint| joint.kind),
            _ => None,
        };
        let line = match joint {
            Some(JointKind::Guide { line, one_sided: false, .. }) => Some(line),
            _ => None,
        };
        let fixed = line.is_some_and(|line| line.fixed_deg(&self.bodies, false).is_some());
        let strut = match label.of {
            Owner::Strut(s) => self.struts.get(s),
            Owner::Body(b) => self.struts.iter().find(|strut| strut.at.body == b && !strut.twists()),
            _ => None,
        };
        let on_joint = matches!(joint, Some(JointKind::Guide { .. } | JointKind::Contact { .. }));
        match label.quantity {
            Quantity::Normal => !fixed,
            Quantity::Impulse if on_joint => !fixed,
            // Along a rim no word tells a sense.
            Quantity::Friction => {
                matches!(joint, Some(JointKind::Contact { surface: Surface::Arc { .. }, mu_k: Some(_), .. }))
            }
            Quantity::SpringForce => strut.is_some_and(|strut| strut.acts != Acts::Both),
            Quantity::XEq => !self.rigid_springs(label),
            other => other.is_magnitude(),
        }
    }
    /// Is the spring of this label attached rigidly, or one of all springs where it names none?
    fn rigid_springs(&self, label: Label) -> bool {
        let named = |spring: &SpringTie| !matches!(label.of, Owner::Tie(tie) if tie != spring.tie);
        self.springs().filter(named).any(|spring| spring.rigid)
    }
    /// Does what has this force, or this impulse in a blow, push as well as it pulls?
    pub fn may_push(&self, label: Label) -> bool {
        matches!(label.quantity, Quantity::Tension | Quantity::SpringForce | Quantity::Impulse)
            && match label.of {
                Owner::Tie(t) => matches!(
                    self.ties.get(t),
                    Some(Tie::Cord(
                        Cord { made: Made::Link, .. } | Cord { to: Far::Spring { rigid: true, .. }, .. }
                    ))
                ),
                Owner::Joint(j) => {
                    matches!(self.joints.get(j), Some(Joint { kind: JointKind::Cord { rod: true, .. }, .. }))
                }
                Owner::Strut(s) => self.struts.get(s).is_some_and(|strut| strut.acts == Acts::Both),
                _ => label.quantity == Quantity::SpringForce,
            }
    }
    /// A value of this as it is asked: only its size where that alone counts.
    pub fn as_asked(&self, label: Label, value: f64) -> f64 {
        if self.is_magnitude(label) { value.abs() } else { value }
    }
    /// A value of this as a road tells it: with its sign, but of the force between the rims of two wheels its size alone, for no word
    /// says in which sense it counts.
    pub fn as_told(label: Label, value: f64) -> f64 {
        if matches!((label.quantity, label.of), (Quantity::RimForce, Owner::Tie(_))) {
            value.abs()
        } else {
            value
        }
    }
    /// All coordinates: the lines, and the turns. A body of particles moves freely in the plane and has none.
    pub fn coordinates(&self) -> impl Iterator<Item = Coordinate> {
        self.bodies.iter().enumerate().flat_map(|(body, b)| {
            let along = b.line.map(|_| Coordinate { body, degree: Degree::Along });
            let turn = b.spins().then_some(Coordinate { body, degree: Degree::Turn });
            along.into_iter().chain(turn)
        })
    }
}
