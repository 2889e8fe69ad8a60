//! What the numbers of a scene are used for: words, unit, admissible values and an example of each use, in one table.
use crate::scene::Rule;
use crate::scene::admissible::fits_rule;

/// What a number is used for: it decides unit and admissible values.
#[derive(Debug, Clone, Copy)]
pub struct Need {
    pub words: &'static str,
    /// SI unit (ASCII) of this use.
    pub unit: &'static str,
    /// Which values are admissible.
    range: Range,
    /// An example, for hints.
    pub example: &'static str,
}

/// Admissible values: whether one is among them, the rule in words, and what is to be written instead.
type Range = (fn(f64) -> bool, &'static str, &'static str);

/// What a couple is written with that turns the other way.
pub const TURNS_BACK: &str = ": `sense: back` turns the other way";
/// What a force is written with that acts the other way.
pub const ACTS_WHITHER: &str = ": its direction says whither it acts";

const ANY: Range = (f64::is_finite, "finite", "");
const NOT_NEGATIVE: Range = (|x| x.is_finite() && x >= 0.0, "not negative", "");
const SENSED: Range = (NOT_NEGATIVE.0, NOT_NEGATIVE.1, TURNS_BACK);
const DIRECTED: Range = (NOT_NEGATIVE.0, NOT_NEGATIVE.1, ACTS_WHITHER);
const POSITIVE: Range = (|x| x.is_finite() && x > 0.0, "above 0", "");
const UP_TO_VERTICAL: Range = (|x| (0.0..=90.0).contains(&x), "from 0 to 90 degrees", "");
const UP_TO_ONE: Range = (|x| (0.0..=1.0).contains(&x), "from 0 to 1", "");
const ACUTE: Range = (|x| x > -90.0 && x < 90.0, "between -90 and 90 degrees", "");
const LEFT_OF_IT_LEFT: Range = (|x| x > 0.0 && x < 180.0, "between 0 and 180 degrees", "");
const A_TURN: Range = (|x| (-360.0..=360.0).contains(&x), "from -360 to 360 degrees", "");

const TURNS: Range = (|x| fits_rule(x, Rule::Turns), "within 20 turns, 7200 degrees", "");

const fn need(words: &'static str, unit: &'static str, range: Range, example: &'static str) -> Need {
    Need { words, unit, range, example }
}

#[rustfmt::skip] // a table
#[allow(missing_docs, reason = "each row says what it is")]
impl Need {
    pub const MASS: &Self = &need("a mass", "kg", POSITIVE, "20 kg");
    pub const WEIGHT: &Self = &need("a weight", "N", POSITIVE, "100 N");
    pub const RADIUS: &Self = &need("a radius", "m", POSITIVE, "0.25 m");
    pub const GYRATION: &Self = &need("a radius of gyration", "m", NOT_NEGATIVE, "0.25 m");
    pub const INERTIA: &Self = &need("a moment of inertia", "kg*m^2", NOT_NEGATIVE, "4 kg*m^2");
    pub const SLOPE: &Self = &need("a slope", "deg", UP_TO_VERTICAL, "30 deg");
    pub const FRICTION: &Self = &need("a friction coefficient", "1", NOT_NEGATIVE, "0.4");
    pub const RESTITUTION: &Self = &need("a coefficient of restitution", "1", UP_TO_ONE, "0.4");
    pub const FORCE: &Self = &need("a force", "N", NOT_NEGATIVE, "100 N");
    pub const PUSH: &Self = &need("a force", "N", DIRECTED, "100 N");
    pub const IMPULSE: &Self = &need("an impulse", "N*s", DIRECTED, "5 N*s");
    pub const MOMENT: &Self = &need("a moment", "N*m", SENSED, "75 N*m");
    pub const STIFFNESS: &Self = &need("a stiffness", "N/m", POSITIVE, "400 N/m");
    pub const TORSION: &Self = &need("a stiffness of a torsion spring", "N*m/rad", POSITIVE, "20 N*m/rad");
    pub const LENGTH: &Self = &need("a length", "m", NOT_NEGATIVE, "0.25 m");
    pub const STRETCH: &Self = &need("a stretch, negative of what is compressed,", "m", ANY, "0.1 m");
    pub const TURN: &Self = &need("an angle", "rad", NOT_NEGATIVE, "3 rad");
    pub const PLACE: &Self = &need("a place", "m", ANY, "0.25 m");
    pub const TIME: &Self = &need("a time", "s", NOT_NEGATIVE, "2 s");
    pub const ANGLE_REACHED: &Self = &need("an angle", "deg", TURNS, "30 deg");
    pub const ANGLE: &Self = &need("an angle", "deg", A_TURN, "30 deg");
    pub const PUSHES_UP: &Self = &need("an angle of a line that pushes up", "deg", ACUTE, "30 deg");
    pub const PUSHES_LEFT: &Self = &need("an angle of a line that pushes left", "deg", LEFT_OF_IT_LEFT, "30 deg");
    pub const TILT: &Self = &need("an angle to the surface", "deg", ACUTE, "30 deg");
    pub const ARM: &Self = &need("a distance from the pin", "m", NOT_NEGATIVE, "0.25 m");
    pub const ROD: &Self = &need("a length of a rod", "m", POSITIVE, "0.25 m");
    pub const VELOCITY: &Self = &need("a speed", "m/s", ANY, "1.5 m/s");
    pub const ACCELERATION: &Self = &need("an acceleration", "m/s^2", ANY, "2 m/s^2");
    pub const ANGULAR_ACCELERATION: &Self = &need("an angular acceleration", "rad/s^2", ANY, "3 rad/s^2");
    pub const SPIN: &Self = &need("a spin", "rad/s", ANY, "8 rad/s");
    pub const SPEED_REACHED: &Self = &need("a speed", "m/s", NOT_NEGATIVE, "1.5 m/s");
    pub const TERM: &Self = &need("a part of an expression", "1", ANY, "2*d");
    pub const SPIN_REACHED: &Self = &need("a spin", "rad/s", NOT_NEGATIVE, "8 rad/s");
}

impl Need {
    /// The rate at which a force or a moment grows, in this unit.
    pub const fn growth(unit: &'static str, of_couple: bool) -> Self {
        let words = if of_couple { "the growth of a moment" } else { "the growth of a force" };
        need(words, unit, NOT_NEGATIVE, "c")
    }
    /// Does the scene take it in degrees?
    pub fn in_degrees(&self) -> bool {
        self.unit == "deg"
    }
    /// Does a value fit this use? Errors: the rule that it breaks, in words.
    pub fn admits(&self, value: f64) -> Result<(), String> {
        let (admits, rule, instead) = self.range;
        if admits(value) { Ok(()) } else { Err(format!("{} is {rule}{instead}", self.words)) }
    }
}

/// What an inertia that a synonym has put about the mass centre needs of that about the pin, for messages.
pub fn about_pin_needs(text: &str) -> Option<&'static str> {
    let (about, arm) = text.split_once(" - ")?;
    if about.starts_with("sqrt((") && about.ends_with(")^2") && arm.ends_with(")^2)") {
        return Some(
            "the radius of gyration about the pin must not be below the distance from the pin to the mass centre",
        );
    }
    let moment = about.starts_with('(') && arm.contains(")*(") && arm.ends_with(")^2");
    moment.then_some("the moment of inertia about the pin must not be below the mass times the square of the distance from the pin to the mass centre")
}
