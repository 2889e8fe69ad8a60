//! What the grader says to each kind of cell, and what comes out of whole files: test and documentation in one.
use slipstick::answer::read::UnitCache;
use slipstick::grade::compare::{compare, compare_with};
use slipstick::grade::feedback::Feedback;
use slipstick::grade::rules::Rules;
use slipstick::grade::run::{GradeFault, Graded, Options, grade};
use slipstick::grade::table::KeyTable;
use slipstick::grade::verdict::Verdict;
use slipstick::key::{Answer, KeyEntry, ProblemKey, SheetKey, WordSigns};
use slipstick::policy::{Counts, Policy};
use slipstick::report::gradebook::gradebook;
use slipstick::units::Unit;
use slipstick::words::Words;
use std::io::Cursor;

fn entry(part: &str, answer: Answer, unit: &str) -> KeyEntry {
    KeyEntry {
        part: part.into(),
        answer,
        unit: Unit::parse(unit).unwrap(),
        unit_required: false,
        points: 1.0,
        eom: None,
        energy: None,
        gap: None,
        cond: None,
        bound: None,
        wrong: vec![],
        code: None,
    }
}
fn number(value: f64, half_width: f64, directed: bool) -> Answer {
    // Along an incline.
    let words = directed.then_some(WordSigns { up: 1, forward: 1, ..WordSigns::default() });
    Answer::Number { value, half_width, directed, magnitude: !directed, words, cyclic: false }
}
fn key(name: &str) -> KeyEntry {
    match name {
        "omega" => entry("omega", number(30.263, 0.30263, false), "rad/s"),
        "v" => entry("v", number(1.25, 0.0125, false), "m/s"),
        "friction" => entry("friction", number(62.6, 0.626, true), "N"),
        "force" => entry("force", number(4200.0, 42.0, false), "N"),
        "large" => entry("large", number(30263.0, 302.63, false), "N"),
        "zero" => entry("zero", number(0.0, 0.01, true), "N"),
        "exactly zero" => entry("zero", number(0.0, 0.0, true), "N"),
        "tiny" => entry("tiny", number(3e-300, 3e-302, false), "m"),
        "huge" => entry("huge", number(3e300, 3e298, false), "m"),
        "impulse" => entry("impulse", number(20.8, 0.208, false), "N s"),
        "torque" => entry("torque", number(12.0, 0.12, false), "N m"),
        "angle" => entry("angle", number(std::f64::consts::FRAC_PI_6, 0.005, false), "deg"),
        "reach" => entry("reach", number(1.25, 0.0125, true), "m"),
        "mu" => entry("mu", number(0.25, 0.0025, false), "1"),
        "alpha" => entry("alpha", number(4.5, 0.045, false), "rad/s^2"),
        "weight" => entry("weight", number(163.586, 1.63586, false), "N"),
        "inertia" => entry("inertia", number(0.8, 0.008, false), "kg m^2"),
        "level" => {
            entry("level", Answer::Word { right: "forward", offered: &["forward", "back", "stays"] }, "1")
        }
        "strict" => KeyEntry { unit_required: true, ..key("v") },
        "rolls" => entry("rolls", Answer::Word { right: "yes", offered: &["yes", "no"] }, "1"),
        "direction" => {
            entry("direction", Answer::Word { right: "stays", offered: &["up", "down", "stays"] }, "1")
        }
        _ => panic!("no key named {name}"),
    }
}

/// Cell, key, verdict, a piece of the reason.
const TABLE: &[(&str, &str, &str, &str)] = &[
    // numbers and units
    ("30.3 rad/s", "omega", "right", "within the tolerance"),
    ("30.3", "omega", "right", "within the tolerance"),
    ("289 rpm", "omega", "right", ""),
    ("289 r/min", "omega", "right", ""),
    ("4.816 rev/s", "omega", "right", ""),
    ("4.816 Hz", "omega", "right", ""),
    ("1734 deg/s", "omega", "right", ""),
    ("30.3 1/s", "omega", "right", ""),
    ("30.3 s^-1", "omega", "right", ""),
    ("30.3 s⁻¹", "omega", "right", ""),
    ("4.5 1/s^2", "alpha", "right", ""),
    ("4.5 rad/s²", "alpha", "right", ""),
    ("4.2 kN", "force", "right", ""),
    ("4.2e3 N", "force", "right", ""),
    ("4.2×10^3 N", "force", "right", ""),
    ("4.2x10^3", "force", "right", ""),
    ("4.2·10³", "force", "right", ""),
    ("4.2 * 10**3 N", "force", "right", ""),
    ("42000x10^-1 N", "force", "right", ""),
    ("0.42×10⁴ N", "force", "right", ""),
    ("944.2 lbf", "force", "right", ""),
    ("428.3 kgf", "force", "right", ""),
    ("+30.3", "omega", "right", ""),
    ("omega = 30.3 rad/s", "omega", "right", ""),
    ("ω=30.3", "omega", "right", ""),
    ("= 30.3", "omega", "right", ""),
    ("~30.3", "omega", "right", ""),
    ("≈ 30.3 rad/s", "omega", "right", ""),
    ("=\"30.3\"", "omega", "right", ""),
    ("30.3 rad/s.", "omega", "right", ""),
    ("30.3\u{a0}rad/s", "omega", "right", ""),
    ("30.3\u{202f}rad/s", "omega", "right", ""),
    ("30\u{2009}263", "large", "right", ""),
    ("30 263 N", "large", "right", ""),
    ("30", "angle", "right", ""),
    ("30°", "angle", "right", ""),
    ("0.5236 rad", "angle", "right", ""),
    ("25 %", "mu", "right", ""),
    ("0.25", "mu", "right", ""),
    (".25", "mu", "right", ""),
    ("20.8 Ns", "impulse", "right", ""),
    ("20,8 kgm/s", "impulse", "right", ""),
    ("12 Nm", "torque", "right", ""),
    ("12 N·m", "torque", "right", ""),
    ("8.85 ft-lb", "torque", "right", ""),
    ("31", "omega", "wrong", "not within the tolerance"),
    ("303", "omega", "wrong", ""),
    // German words are read in every language, with a number or alone
    ("62,6 N hinauf", "friction", "right", ""),
    ("62,6 N nach oben", "friction", "right", ""),
    ("62,6 N die schiefe Ebene hinunter", "friction", "wrong direction", "the direction is not"),
    ("62,6 N herab", "friction", "wrong direction", ""),
    ("ab 62,6 N", "friction", "wrong direction", ""),
    ("-62,6 N hinauf", "friction", "unreadable", "write only one of them"),
    ("62,6 N auf und ab", "friction", "unreadable", ""),
    ("vorwärts", "level", "right", ""),
    ("nach vorn", "level", "right", ""),
    ("es bewegt sich zurück", "level", "wrong", ""),
    ("ruht", "direction", "right", ""),
    ("es bewegt sich nicht", "direction", "right", ""),
    ("das Rad bewegt sich abwärts", "direction", "wrong", ""),
    ("ja", "rolls", "right", ""),
    ("J", "rolls", "right", ""),
    ("nein, es gleitet", "rolls", "wrong", ""),
    ("ja, es gleitet", "rolls", "unreadable", ""),
    ("it rolls", "rolls", "right", ""),
    ("does not slip", "rolls", "right", ""),
    ("slips", "rolls", "wrong", ""),
    ("rollt nicht", "rolls", "wrong", ""),
    ("rolls and slips", "rolls", "unreadable", ""),
    // the comma
    ("1,25 m/s", "v", "right", "the comma is read as the decimal mark"),
    ("30,263", "omega", "right", "the comma is read as the decimal mark"),
    ("30,263 N", "large", "unreadable", "write 30263 or 30.263"),
    ("29,111", "large", "wrong", "the comma is read as the decimal mark"),
    // both marks: the last one is the decimal mark, the other groups by three, and the reason says what came out
    ("30.263,0", "large", "right", "read as 30263"),
    ("30,263.0", "large", "right", "read as 30263"),
    ("30,263.25 N", "large", "right", "read as 30263.25 N"),
    ("1.030.263,5", "large", "wrong", "read as 1030263.5"),
    ("1,030,263.5", "large", "wrong", "read as 1030263.5"),
    ("30 263,0 N", "large", "right", "read as 30263 N"),
    ("30'263", "large", "right", "read as 30263"),
    ("30’263.0 N", "large", "right", "read as 30263 N"),
    ("30'263,5", "large", "right", "read as 30263.5"),
    ("30,26.3", "large", "unreadable", "more than one comma or point"),
    ("3026,300.5", "large", "unreadable", "more than one comma or point"),
    ("0,263.5", "large", "unreadable", "more than one comma or point"),
    ("30.263,0.5", "large", "unreadable", "more than one comma or point"),
    ("30'26", "large", "unreadable", "more than one comma or point"),
    ("30'263 000", "large", "unreadable", "more than one number"),
    ("30 26", "large", "unreadable", "more than one number"),
    ("1,030,263", "large", "unreadable", "more than one comma or point"),
    ("1.2.3 m/s", "v", "unreadable", "more than one comma or point"),
    ("1..25 m/s", "v", "unreadable", "more than one comma or point"),
    ("0,164", "large", "wrong", "the comma is read as the decimal mark"),
    ("0,164", "weight", "wrong", "the comma is read as the decimal mark"),
    // turns
    ("289 1/min", "omega", "right", "1/min is read as revolutions: rev/min"),
    ("289 min^-1", "omega", "right", "revolutions"),
    ("289 min⁻¹", "omega", "right", "revolutions"),
    ("289 U/min", "omega", "right", ""),
    ("289 U min⁻¹", "omega", "right", ""),
    ("289 rev/min", "omega", "right", ""),
    ("289 Umdr/min", "omega", "right", ""),
    ("289 Umdr./min", "omega", "right", ""),
    ("1816 1/min", "omega", "unreadable", "write rev/min or rad/min"),
    ("1816 rad/min", "omega", "right", ""),
    ("100 1/min", "omega", "wrong", "revolutions"),
    // as people write
    ("30.3 rads/s", "omega", "right", ""),
    ("30.3 radians per second", "omega", "right", ""),
    ("30.3 rad per s", "omega", "right", ""),
    ("4.5 radians per second squared", "alpha", "right", ""),
    ("0.8 kgm²", "inertia", "right", ""),
    ("0.8 kgm^2", "inertia", "right", ""),
    ("0.8 kg m^2", "inertia", "right", ""),
    ("30.3 rad/s (ccw)", "omega", "right", "the sense of turning is passed over"),
    ("30.3 rad/s cw", "omega", "right", "the sense of turning"),
    ("30.3 clockwise", "omega", "right", "the sense of turning"),
    ("30.3 rad/s, counterclockwise", "omega", "right", "the sense of turning"),
    ("1.25 m/s cw", "v", "unreadable", "not one direction"),
    ("30.3 rad/s gegen den Uhrzeigersinn", "omega", "right", "the sense of turning is passed over"),
    ("30.3 rad/s counter up", "omega", "unreadable", ""),
    ("29 deg 60'", "angle", "unreadable", "1 deg or more"),
    ("29 deg 59'", "angle", "right", "read as 29.98333333 deg"),
    ("30°3'", "angle", "right", "read as 30.05 deg"),
    ("30° 0′ 30″", "angle", "right", "read as 30.00833333 deg"),
    ("30 deg 3 arcmin", "angle", "right", ""),
    ("28 deg 3'", "angle", "wrong", ""),
    ("33.3 gon", "angle", "right", ""),
    ("30 gon", "angle", "wrong", ""),
    ("4' 1\"", "reach", "right", "read as 4.083333333 ft"),
    ("ca. 30.3", "omega", "right", "without the word before it"),
    ("about 30.3 rad/s", "omega", "right", "without the word before it"),
    ("approx 30.3", "omega", "right", "without the word before it"),
    ("Approx. 30.3", "omega", "right", "without the word before it"),
    ("$30.3$ rad/s", "omega", "right", ""),
    ("30.3\\ \\mathrm{rad/s}", "omega", "right", ""),
    ("$30{,}3\\,\\text{rad}/\\text{s}$", "omega", "right", ""),
    ("$4.2 \\times 10^{3}\\ \\mathrm{N}$", "force", "right", ""),
    ("$30^\\circ$", "angle", "right", ""),
    ("$4.5\\ \\mathrm{rad}/\\mathrm{s}^{2}$", "alpha", "right", ""),
    ("３０．３ rad/s", "omega", "right", ""),
    // directions
    ("62.6 N ↑", "friction", "right", ""),
    ("62.6 N ↓", "friction", "wrong direction", ""),
    ("↓62.6 N", "friction", "wrong direction", ""),
    ("62.6 N to the right", "friction", "unreadable", "one of up, down, forward, back"),
    ("62.6 N left", "friction", "unreadable", "one of up, down, forward, back"),
    ("62.6 N clockwise", "friction", "unreadable", "one of up, down, forward, back"),
    ("62.6 N up the track", "friction", "right", ""),
    ("62,6 N die Bahn hinab", "friction", "wrong direction", ""),
    ("1.25 m above", "reach", "right", "within the tolerance"),
    ("1,25 m unterhalb", "reach", "wrong direction", ""),
    ("62.6 N forward", "friction", "right", ""),
    ("62.6 N up", "friction", "right", ""),
    ("62.6 N up the incline", "friction", "right", ""),
    ("up the slope 62.6 N", "friction", "right", ""),
    ("62.6 (up)", "friction", "right", ""),
    ("62,6 N aufwärts", "friction", "right", "decimal mark"),
    ("62.6 N down", "friction", "wrong direction", "the direction is not"),
    ("62.6 N down the incline", "friction", "wrong direction", ""),
    ("-62.6 N", "friction", "wrong direction", "the sign is not"),
    ("\u{2212}62.6", "friction", "wrong direction", ""),
    ("–62.6 N", "friction", "wrong direction", ""),
    ("-62.6 N down", "friction", "unreadable", "a minus sign and a direction"),
    ("-62.6 N up", "friction", "unreadable", "a minus sign and a direction"),
    ("down the incline", "friction", "unreadable", "`down` alone: write the number too"),
    ("62.6 N up down", "friction", "unreadable", "not one direction"),
    ("62.6 N stays", "friction", "unreadable", "not one direction"),
    ("50 N up", "friction", "wrong", ""),
    ("-30.3 rad/s", "omega", "wrong direction", "a magnitude is asked"),
    ("30.3 rad/s forward", "omega", "right", "no direction is asked"),
    // words
    ("stays", "direction", "right", ""),
    ("it stays at rest", "direction", "right", ""),
    ("it does not move", "direction", "right", ""),
    ("doesn't move", "direction", "right", ""),
    ("↑", "direction", "wrong", ""),
    ("to the right", "direction", "unreadable", "`right` is not offered"),
    ("to the right", "level", "right", ""),
    ("left", "level", "wrong", ""),
    ("yes it rolls", "rolls", "right", ""),
    ("no, it slips", "rolls", "wrong", ""),
    ("no slip", "rolls", "right", "the right word"),
    ("No slipping.", "rolls", "right", ""),
    ("yes, no slip", "rolls", "right", ""),
    ("it rolls without slipping", "rolls", "right", ""),
    ("kein Schlupf", "rolls", "right", ""),
    ("ohne Rutschen", "rolls", "right", ""),
    ("no, slipping", "rolls", "wrong", ""),
    ("no - slipping", "rolls", "wrong", ""),
    ("nein, gleiten", "rolls", "wrong", ""),
    ("no, no slip", "rolls", "unreadable", ""),
    ("it slips, no slip", "rolls", "unreadable", ""),
    ("no, it does not roll", "rolls", "wrong", ""),
    ("no, it rolls", "rolls", "unreadable", ""),
    ("Up", "direction", "wrong", "another word is right"),
    ("yes", "direction", "unreadable", "write one of up, down, stays"),
    ("0", "direction", "unreadable", "a word is asked"),
    ("YES", "rolls", "right", ""),
    ("ja", "rolls", "right", ""),
    ("n", "rolls", "wrong", ""),
    ("perhaps", "rolls", "unreadable", "write one of: yes, no"),
    // dimensions
    ("30.3 m/s", "omega", "wrong dimension", "expected rad/s (angular velocity), found m/s (speed)"),
    ("12 N", "torque", "wrong dimension", "a factor m is missing"),
    ("62.6 kg", "friction", "wrong dimension", "expected N (force), found kg (mass)"),
    ("14 lbm", "friction", "wrong dimension", "write lbf"),
    ("14 deg", "mu", "wrong dimension", ""),
    // the unit itself
    ("30.3 RAD/S", "omega", "right", "the unit is read as rad/s"),
    ("62.6 n", "friction", "right", "the unit is read as N"),
    ("62.6 mn", "friction", "unreadable", "upper and lower case matter"),
    ("30.3 radd/s", "omega", "unreadable", "did you mean `rad`?"),
    ("30.3 xyz", "omega", "unreadable", "unknown unit `xyz`"),
    ("1.25", "strict", "missing unit", "write the unit, such as m/s"),
    ("1.25 m/s", "strict", "right", ""),
    // not finite, zero, tiny, huge
    ("NaN", "omega", "unreadable", "not a finite number"),
    ("inf", "omega", "unreadable", "not a finite number"),
    ("-Infinity m", "huge", "unreadable", "not a finite number"),
    ("1e400", "huge", "unreadable", "not a finite number"),
    ("1e306 km", "huge", "unreadable", "not a finite number"),
    ("0", "zero", "right", ""),
    ("-0.009", "zero", "right", ""),
    ("0.02", "zero", "wrong", ""),
    ("0", "exactly zero", "right", ""),
    ("-0.0", "exactly zero", "right", ""),
    ("1e-300", "exactly zero", "wrong", ""),
    ("3e-300", "tiny", "right", ""),
    ("0", "tiny", "wrong", ""),
    ("3.02e300", "huge", "right", ""),
    ("3.04e300", "huge", "wrong", ""),
    // an uncertainty: the number before it counts, and the reason says so
    ("30.3 ± 0.1 rad/s", "omega", "right", "what follows ± is passed over"),
    ("30.3 ± 0.1", "omega", "right", "what follows ± is passed over"),
    ("30.3 rad/s ± 0.1 rad/s", "omega", "right", "what follows ±"),
    ("30.3 rad/s ± 2 rpm", "omega", "right", "what follows ±"),
    ("30.3 rad/s ± 0.5 %", "omega", "right", "what follows ±"),
    ("(30.3 ± 0.1) rad/s", "omega", "right", "what follows ±"),
    ("30.3+-0.1 rad/s", "omega", "right", "what follows ±"),
    ("30.3 +/- 0.1", "omega", "right", "what follows ±"),
    ("$30.3 \\pm 0.1$", "omega", "right", "what follows ±"),
    ("62.6 ± 0.3 N up", "friction", "right", "what follows ±"),
    ("62.6 N down ± 0.3 N", "friction", "wrong direction", "what follows ±"),
    ("30.3 rad/s (± 0.1)", "omega", "right", "what follows ±"),
    ("30.3 rad/s (±0.1 rad/s)", "omega", "right", "what follows ±"),
    ("31 ± 1 rad/s", "omega", "wrong", "what follows ±"),
    ("±62.6 N", "friction", "unreadable", ""),
    ("30.3 rad/s ± 0.1 m", "omega", "unreadable", "more than one number"),
    ("25 ± 1 %", "mu", "unreadable", "more than one number"),
    ("30.3 ± 0.1 ± 0.2", "omega", "unreadable", ""),
    // exact values
    ("5/4", "v", "right", "read as 1.25"),
    ("5/4 m/s", "v", "right", "read as 1.25 m/s"),
    ("1 1/4 m/s", "v", "right", "read as 1.25 m/s"),
    ("1¼ m/s", "v", "right", "read as 1.25 m/s"),
    ("(5/4) m/s", "v", "right", "read as 1.25 m/s"),
    ("1/4", "mu", "right", "read as 0.25"),
    ("-1/4", "mu", "wrong direction", ""),
    ("1/2", "v", "wrong", "read as 0.5"),
    ("sqrt(918)", "omega", "right", "read as 30.2985148"),
    ("√918 rad/s", "omega", "right", "read as 30.2985148"),
    ("2*sqrt(229) rad/s", "omega", "right", "read as"),
    ("9 sqrt(2) N m", "torque", "wrong", "read as 12.72792206 N m"),
    ("12*sqrt(4)/2", "torque", "right", "read as 12"),
    ("\\frac{5}{4}\\ \\mathrm{m/s}", "v", "right", "read as 1.25 m/s"),
    ("$\\sqrt{918}$", "omega", "right", "read as 30.2985148"),
    ("pi/6 rad", "angle", "right", "read as 0.5235987756 rad"),
    ("π/6 rad", "angle", "right", ""),
    ("30 1/s", "omega", "right", "within the tolerance"),
    ("1/2*3", "v", "unreadable", "not a formula"),
    ("1/2 sqrt(3)", "v", "unreadable", "not a formula"),
    ("2.5/2", "v", "unreadable", "not a formula"),
    ("3/4/2026", "v", "unreadable", "not a formula"),
    ("sqrt(2*9.81*0.08)", "v", "unreadable", "not a formula"),
    ("5/0", "v", "unreadable", "not a finite number"),
    ("sqrt(-2)", "v", "unreadable", ""),
    // brackets
    ("30.3 [rad/s]", "omega", "right", ""),
    ("30.3 (rad/s)", "omega", "right", ""),
    ("30.3 {rad/s}", "omega", "right", ""),
    ("30.3 ［rad/s］", "omega", "right", ""),
    ("[30.3] rad/s", "omega", "right", "read as 30.3 rad/s"),
    ("(30.3 rad/s)", "omega", "right", "read as 30.3 rad/s"),
    ("62.6 N [up]", "friction", "right", ""),
    ("up (62.6 N)", "friction", "right", ""),
    ("(30.3 rad/s", "omega", "unreadable", ""),
    // the web and other scripts
    ("30.3&nbsp;rad/s", "omega", "right", ""),
    ("30.3&amp;nbsp;rad/s", "omega", "right", ""),
    ("30.3&#160;rad/s", "omega", "right", ""),
    ("&minus;62.6&thinsp;N", "friction", "wrong direction", ""),
    ("<p>30.3 rad/s</p>", "omega", "right", ""),
    ("4.5 rad/s<sup>2</sup>", "alpha", "right", ""),
    ("4.2&times;10<sup>3</sup>&nbsp;N", "force", "right", ""),
    ("٣٠٫٣ rad/s", "omega", "right", "read as 30.3 rad/s"),
    ("۳۰٫۳", "omega", "right", "read as 30.3"),
    ("३०.३", "omega", "right", "read as 30.3"),
    ("٣٠٬٢٦٣ N", "large", "right", "read as 30263 N"),
    ("３０．３［ｒａｄ／ｓ］", "omega", "right", ""),
    // units with two meanings take the one that is asked
    ("14 lb", "friction", "right", "the unit is read as lbf"),
    ("14 lbs up", "friction", "right", "the unit is read as lbf"),
    ("8.85 lb ft", "torque", "right", "the unit is read as"),
    ("2.43 knots", "v", "right", ""),
    ("2.43 kt", "v", "right", ""),
    ("2.43 kn", "v", "right", "the unit is read as knot"),
    // Written together, and an exponent belongs to the last: what is asked decides.
    ("1.25 ms^-1", "v", "right", "the unit is read as m/s"),
    ("1,25 ms⁻¹", "v", "right", "the unit is read as m/s"),
    ("30.3 rads^-1", "omega", "right", "the unit is read as rad/s"),
    ("4.5 rads^-2", "alpha", "right", "the unit is read as rad/s^2"),
    ("20.8 kgms^-1", "impulse", "right", ""),
    ("62.6 kgms^-2", "friction", "right", ""),
    ("62.6 Nmm^-1", "friction", "wrong dimension", ""),
    ("0.25 mm^-1", "mu", "wrong dimension", ""),
    ("1.25 ms", "v", "wrong dimension", "a millisecond"),
    ("4.2 kn", "force", "right", "the unit is read as kN"),
    ("4.816 r/s", "omega", "unreadable", "may be rad/s or rev/s"),
    ("30.3 r/s", "omega", "unreadable", "may be rad/s or rev/s"),
    ("30.3 R/S", "omega", "unreadable", "may be rad/S or rev/S"),
    ("30.3 r s^-1", "omega", "unreadable", "may be rad s^-1 or rev s^-1"),
    ("4.5 r/s²", "alpha", "unreadable", "may be rad/s² or rev/s²"),
    // several units
    ("4 ft 1.2 in", "reach", "right", "read as 4.1 ft"),
    ("4 ft, 1.2 in", "reach", "right", "read as 4.1 ft"),
    ("4 feet and 1.2 inches", "reach", "right", "read as 4.1 ft"),
    ("4' 1.2\"", "reach", "right", "read as 4.1 ft"),
    ("4′1″", "reach", "right", "read as 4.083333333 ft"),
    ("1 m 25 cm", "reach", "right", "read as 1.25 m"),
    ("-4 ft 1.2 in", "reach", "wrong direction", "read as -4.1 ft"),
    ("4 ft. 1 1/5 in.", "reach", "right", "read as 4.1 ft"),
    ("4' 1''", "reach", "right", "read as 4.083333333 ft"),
    ("1 m, 25 cm", "reach", "unreadable", "more than one number"),
    ("1.25 m 1.25 m", "reach", "unreadable", "more than one number"),
    ("4 m 0.1 m", "reach", "unreadable", "more than one number"),
    ("62 N 600 mN", "friction", "unreadable", "more than one number"),
    ("4 ft 13 in", "reach", "unreadable", "13 in is 1 ft or more"),
    ("4.1 ft 3 in", "reach", "unreadable", "more than one number"),
    ("1.2 in 4 ft", "reach", "unreadable", "more than one number"),
    ("4 ft 3 N", "reach", "unreadable", ""),
    // what is contradictory is shown
    ("-62.6 N down", "friction", "unreadable", "62.6 N down or 62.6 N up"),
    ("-62,6 N hinauf", "friction", "unreadable", "62.6 N up or 62.6 N down"),
    ("- 62.6 forward", "friction", "unreadable", "62.6 forward or 62.6 back"),
    // what is missing or may be another number is named; before, these fell to whatever reason came first
    ("5-", "v", "unreadable", "nothing stands behind `-`"),
    ("0.25 -", "mu", "unreadable", "nothing stands behind `-`"),
    ("12 ±", "torque", "unreadable", "nothing stands behind `±`"),
    (">= 0.25", "mu", "unreadable", "a bound is no number"),
    ("≥0.25", "mu", "unreadable", "a bound is no number"),
    ("mu < 0.25", "mu", "unreadable", "a bound is no number"),
    ("1.25 ± 2 %", "v", "right", "what follows ±"),
    ("30.3 /s", "omega", "right", ""),
    ("4.5 /s^2", "alpha", "right", ""),
    ("12 /s", "torque", "wrong dimension", "found 1/s"),
    ("12·71 m", "reach", "unreadable", "the raised dot may be"),
    ("0x10", "v", "unreadable", "`0x` begins another one"),
    ("0x0C", "v", "unreadable", "`0x` begins another one"),
    ("4'", "reach", "unreadable", "write ft or in"),
    ("12.63\"", "reach", "unreadable", "write ft or in"),
    ("4' 3", "reach", "unreadable", "write ft or in"),
    ("4.816 rps", "omega", "unreadable", "did you mean `rev/s`?"),
    ("perhaps", "direction", "unreadable", "no known word; write one of"),
    ("62.6 N -down", "friction", "unreadable", "not one direction"),
    ("62.6 N - down", "friction", "wrong direction", ""),
    // neither
    ("", "omega", "blank", "nothing written"),
    ("  \u{a0} ", "omega", "blank", ""),
    ("about thirty", "omega", "unreadable", "neither a number nor a known word"),
    ("?", "omega", "unreadable", ""),
    ("30 or 31", "omega", "unreadable", ""),
    ("30 31", "omega", "unreadable", "more than one number"),
    ("v = 2*0.625 = 1.25", "v", "unreadable", "not a formula"),
    ("2*0.625", "v", "unreadable", "not a formula"),
    ("10^10^10 m", "huge", "unreadable", ""),
];

#[test]
fn every_cell_of_the_table() {
    let mut faults = Vec::new();
    for (cell, name, verdict, piece) in TABLE {
        let got = compare(cell, &key(name));
        let points = if *verdict == "right" { 1.0 } else { 0.0 };
        if got.verdict.as_str() != *verdict
            || !got.reason.contains(piece)
            || (got.points - points).abs() > 0.0
        {
            faults.push(format!(
                "{cell:?} for {name}: want {verdict} ({piece}), got {} ({})",
                got.verdict, got.reason
            ));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// How a cell was read is told in the language of the set, with its own decimal mark.
#[test]
fn reasons_in_german() {
    let say = Feedback::new(Words::built_in("de").unwrap());
    for (cell, name, piece) in [
        ("30.263,25 N", "large", "gelesen als 30263,25 N"),
        ("5/4", "v", "gelesen als 1,25"),
        ("30,3 ± 0,1", "omega", "was hinter ± steht, ist übergangen"),
        ("14 lb", "friction", "die Einheit ist als lbf gelesen"),
        ("-62,6 N hinauf", "friction", "62,6 N aufwärts oder 62,6 N abwärts"),
        ("30 r/s", "omega", "kann rad/s oder rev/s sein"),
    ] {
        let got = compare_with(cell, &key(name), &mut UnitCache::default(), &say);
        assert!(got.reason.contains(piece), "{cell}: {}", got.reason);
    }
}

#[test]
fn the_edge_of_the_tolerance_is_right() {
    let exact = entry("x", number(100.0, 1.0, false), "m");
    for (cell, right) in
        [("101", true), ("99", true), ("101.0000000001", false), ("98.9999999999", false), ("9900 cm", true)]
    {
        assert_eq!(compare(cell, &exact).verdict == Verdict::Right, right, "{cell}");
    }
}

/// A number in many styles of the same value; the styles of a row have to be read as one number.
mod styles {
    use super::*;
    use proptest::prelude::*;
    use slipstick::answer::read::{Number, Reading, UnitCache, read};

    fn number(cell: &str) -> Option<Number> {
        match read(cell, &mut UnitCache::default()) {
            Reading::Number(number) => Some(number),
            _ => None,
        }
    }
    /// Digits with a mark between groups of three.
    fn grouped(digits: &str, mark: &str) -> String {
        let from = digits.len() % 3;
        let mut groups: Vec<&str> = if from > 0 { vec![&digits[..from]] } else { vec![] };
        groups.extend((from..digits.len()).step_by(3).map(|i| &digits[i..i + 3]));
        groups.join(mark)
    }
    fn in_script(text: &str, zero: char) -> String {
        let digit = |c: char| c.to_digit(10).and_then(|d| char::from_u32(u32::from(zero) + d)).unwrap_or(c);
        text.chars().map(digit).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        /// The table of cells has each style with one number; a rule about marks that is wrong for some digits would hold there.
        #[test]
        fn a_number_reads_the_same_in_every_style(
            whole in 1u32..999_999_999,
            decimals in "[0-9]{0,5}",
            marks in prop::sample::select(vec![
                ("", "."), ("", ","), (",", "."), (".", ","), ("'", "."), ("'", ","), ("’", "."), (" ", ","), (" ", "."),
                ("\u{2009}", ","), ("\u{202f}", "."), ("\u{a0}", ","), ("&nbsp;", "."), ("٬", "٫"), ("&#8239;", ","),
            ]),
            script in prop::sample::select(vec!['0', '٠', '۰', '०', '０']),
            sign in prop::sample::select(vec!["", "+", "-", "−", "–", "－", "&minus;"]),
            unit in prop::sample::select(vec!["", "N", "m/s", "rad/s^2", "kg m²"]),
            around in 0usize..12,
        ) {
            let (group, point) = marks;
            let negative = !["", "+"].contains(&sign);
            let value: f64 = format!("{}{whole}.{decimals}", if negative { "-" } else { "" }).parse().unwrap();
            let digits = whole.to_string();
            // A lone comma or point is the decimal mark: these group only where the other one stands.
            let group = if decimals.is_empty() && [",", "."].contains(&group) { "" } else { group };
            let mut written = if group.is_empty() { digits } else { grouped(&digits, "|") };
            if !decimals.is_empty() {
                written = format!("{written}_{decimals}");
            }
            let written = in_script(&written, script).replace('|', group).replace('_', point);
            let written = format!("{sign}{written}");
            let cell = match around {
                0 => format!("{written}{unit}"),
                1 => format!("{written} [{unit}]").replace(" []", ""),
                2 => format!("({written} {unit})"),
                3 => format!("<p>{written}&nbsp;{unit}</p>"),
                4 => format!("x = {written} {unit}"),
                5 => format!("{written} ± 0.1 {unit}"),
                6 => format!("({written} +/- 0,2) {unit}"),
                7 => format!("\u{200e}{written}\u{202f}{unit}."),
                8 => format!("${written}\\,${unit}"),
                9 => format!("ca. {written} {unit}"),
                10 => format!("=\"{written} {unit}\""),
                _ => format!("  {written}  {unit} "),
            };
            let read = number(&cell).unwrap_or_else(|| panic!("{cell:?} is not read"));
            prop_assert_eq!(read.value.to_bits(), value.to_bits(), "{:?}", cell);
            let asked = if unit.is_empty() { None } else { Some(Unit::parse(unit).unwrap()) };
            prop_assert_eq!(read.unit.as_deref(), asked.as_ref(), "{:?}", cell);
            prop_assert!(read.word.is_none());
            // Whatever is not simply there is told.
            let told = !group.is_empty() && whole > 999;
            prop_assert!(!told || read.is_interpreted(), "{:?}", cell);
        }

        #[test]
        fn an_exact_value_reads_as_what_it_is(a in 1u32..500, b in 1u32..500, c in 2u32..500, style in 0usize..9) {
            let (x, y, z) = (f64::from(a), f64::from(b), f64::from(c));
            let (cell, value) = match style {
                0 => (format!("{a}/{b}"), x / y),
                1 => (format!("{a}⁄{b} m"), x / y),
                2 => (format!("\\frac{{{a}}}{{{b}}}\\,\\mathrm{{m}}"), x / y),
                3 => (format!("{a}*sqrt({c})"), x * z.sqrt()),
                4 => (format!("{a}√{c}/{b}"), x * z.sqrt() / y),
                5 => (format!("{a} {}/{c} m", c - 1), x + (z - 1.0) / z),
                6 => (format!("{a}π/{b}"), x * std::f64::consts::PI / y),
                7 => (format!("-sqrt({a}/{b})"), -(x / y).sqrt()),
                _ => (format!("({a}/{b}) m"), x / y),
            };
            let read = number(&cell);
            // Three digits above the bar of a mixed number may be a group of its whole number.
            if style == 5 && c > 100 {
                prop_assert!(read.is_none(), "{cell}");
                return Ok(());
            }
            let read = read.unwrap_or_else(|| panic!("{cell:?} is not read"));
            prop_assert!((read.value - value).abs() <= 1e-15 * value.abs(), "{}: {}", cell, read.value);
            prop_assert!(read.is_interpreted(), "{cell}");
        }

        #[test]
        fn several_units_add_up(feet in 0u32..100, inches in 0u32..120, joined in prop::sample::select(vec![" ", ", ", " and "])) {
            let cell = format!("{feet} ft{joined}{}.{} in", inches / 10, inches % 10);
            let read = number(&cell).unwrap_or_else(|| panic!("{cell:?} is not read"));
            let metres = read.unit.as_ref().unwrap().to_si(read.value);
            let want = f64::from(feet) * 0.3048 + f64::from(inches) * 0.00254;
            prop_assert!((metres - want).abs() <= 1e-14 * want.max(1.0), "{}: {}", cell, metres);
        }

        /// No cell of digits and marks is read as a number that another rule would give it.
        #[test]
        fn marks_in_disorder_are_refused(groups in prop::collection::vec("[0-9]{1,4}", 2..5), marks in prop::collection::vec(prop::sample::select(vec![',', '.', '\'', ' ']), 4)) {
            let mut cell = groups[0].clone();
            for (mark, group) in marks.iter().zip(&groups[1..]) {
                cell.push(*mark);
                cell.push_str(group);
            }
            let Some(read) = number(&cell) else { return Ok(()) };
            let used = &marks[..groups.len() - 1];
            let last = used[used.len() - 1];
            let decimal = matches!(last, ',' | '.') && used.iter().filter(|m| **m == last).count() == 1;
            let grouping = &used[..used.len() - usize::from(decimal)];
            prop_assert!(grouping.iter().all(|m| *m == grouping[0]), "{cell:?} is {}", read.value);
            prop_assert!(decimal || !used.iter().any(|m| matches!(m, ',' | '.')), "{cell:?} is {}", read.value);
            let between = &groups[1..groups.len() - usize::from(decimal)];
            prop_assert!(between.iter().all(|g| g.len() == 3), "{cell:?} is {}", read.value);
        }
    }
}

fn sheet(student: &str) -> SheetKey {
    SheetKey {
        student: student.into(),
        problems: vec![
            ProblemKey {
                id: "rolling".into(),
                parts: vec![key("omega"), key("friction")],
                ..ProblemKey::default()
            },
            ProblemKey {
                id: "slipping".into(),
                parts: vec![key("v"), key("rolls")],
                ..ProblemKey::default()
            },
        ],
    }
}
fn table() -> KeyTable {
    let names = [("00123".to_owned(), "=Ada, B.".to_owned()), ("b".to_owned(), "Bo".to_owned())];
    KeyTable::new(["00123", "b", "nobody"].map(sheet).into(), &names)
}
pub fn run_with(bytes: &[u8], table: &KeyTable, options: &Options) -> Result<(String, Graded), GradeFault> {
    run_by(bytes, table, options, &Policy::default())
}
fn run_by(
    bytes: &[u8],
    table: &KeyTable,
    options: &Options,
    policy: &Policy,
) -> Result<(String, Graded), GradeFault> {
    let mut out = Vec::new();
    let open = || Ok(Box::new(Cursor::new(bytes.to_vec())) as Box<dyn std::io::Read + Send>);
    let rules = Rules::new(table, policy).map_err(GradeFault::Header)?;
    let graded = grade(&open, table, &rules, options, &mut out, &mut |_| {})?;
    Ok((String::from_utf8(out).expect("answers.csv is UTF-8"), graded))
}
fn run(text: &str) -> String {
    let options = Options { threads: 2, ..Options::default() };
    run_with(text.as_bytes(), &table(), &options).unwrap().0
}

#[test]
fn a_messy_long_file() {
    let text = "\u{feff}STUDENT, Problem ,part,Answer,Remark\r\n\
        00123,1,omega,30.3,first\r\n\
        00123,rolling,OMEGA,31,second\r\n\
        00123,1,omega,,third\r\n\
        00123,1,omega,huh?,fourth\r\n\
        123,1,omega,30.3,\r\n\
        \r\n\
        b,2,v,1,25 m/s,\r\n\
        b,2,v,\"1,25 m/s\",,,\r\n\
        b,2,rolls\r\n\
        b,2,v,-1,25,a\r\n\
        b,2,omgea,1,\r\n\
        b,7,v,1,\r\n\
        ,,,,\r\n\
        b,1,friction,-62.6 N,\r\n\
        b,2,rolls,=1+1,\r\n\
        b,1,omega,\"30.3\r\n\
        nobody,2,rolls,yes,\r\n";
    insta::assert_snapshot!(run(text), @r#"
    line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at
    2,,00123,1,omega,30.3,superseded,0,1,superseded by line 3; would have been right,,,,
    3,,00123,1,omega,31,wrong,0,1,not within the tolerance,,,,
    4,,00123,1,omega,,blank,0,1,nothing written,,,,
    5,,00123,1,omega,huh?,superseded,0,1,superseded by line 3; would have been unreadable: neither a number nor a known word,,,,
    6,,123,1,omega,30.3,unknown student,0,0,not on the roster; did you mean 00123?,,,,
    8,,b,2,v,"b,2,v,1,25 m/s,",unreadable,0,1,"6 fields where the header has 5: the comma split the answer: quote it (""1,25 m/s"") or write 1.25 m/s",,,,
    9,,b,2,v,"1,25 m/s",right,1,1,within the tolerance; the comma is read as the decimal mark,,,,
    10,,b,2,rolls,"b,2,rolls",unreadable,0,1,3 fields where the header has 5,,,,
    11,,b,2,v,"b,2,v,-1,25,a",unreadable,0,1,"6 fields where the header has 5: the comma split the answer: quote it (""-1,25"") or write -1.25",,,,
    12,,b,2,omgea,1,unknown part,0,0,"no part `omgea`; parts: v, rolls",,,,
    13,,b,7,v,1,unknown part,0,0,"no problem `7`; problems: 1 (rolling), 2 (slipping)",,,,
    14,,,,,",,,,",blank,0,0,an empty record,,,,
    15,,b,1,friction,-62.6 N,wrong direction,0,1,"the magnitude is right, the sign is not",,,,
    16,,b,2,rolls,'=1+1,unreadable,0,1,"more than one number: write one number and its unit; write one of: yes, no",,,,
    17,,b,1,omega,"""30.3",unreadable,0,1,a quote opened on line 17 is not closed there,,,,
    18,,nobody,2,rolls,yes,right,1,1,the right word,,,,
    "#);
}

#[test]
fn a_quote_left_open_swallows_no_answer() {
    let text = "student,problem,part,answer\nb,1,omega,\"30.3\nb,1,friction,62 N\n00123,2,v,1.25\"\nb,2,v,\"1.25\nm/s\"\n";
    insta::assert_snapshot!(run(text), @r#"
    line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at
    2,,b,1,omega,"""30.3",unreadable,0,1,a quote opened on line 2 is not closed there,,,,
    3,,b,1,friction,62 N,right,1,1,within the tolerance,,,,
    4,,00123,2,v,"1.25""",unreadable,0,1,"write ft or in, not ' or """,,,,
    5,,b,2,v,"1.25
    m/s",right,1,1,within the tolerance,,,,
    "#);
}

#[test]
fn columns_at_the_end_may_be_missing_and_odd_bytes_hide_no_name() {
    let text =
        b"student,problem,part,answer,submitted_at,remark\nb,1.0,omega,30.3\nb,01,friction,62 N,2026-01-01\n\
        b,2,v,1,25 m/s\nb,2,rolls,y\0es,,\nb,2,rolls\nstr\0ange,2,rolls,yes,,\n";
    let out = run_with(text, &table(), &Options::default()).unwrap().0;
    insta::assert_snapshot!(out.replace('\u{fffd}', "?"), @r#"
    line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at
    2,,b,1,omega,30.3,right,1,1,within the tolerance,,,,
    3,,b,1,friction,62 N,right,1,1,within the tolerance,,,,2026-01-01
    4,,b,2,v,"b,2,v,1,25 m/s",unreadable,0,1,"5 fields where the header has 6: the comma split the answer: quote it (""1,25 m/s"") or write 1.25 m/s",,,,
    5,,b,2,rolls,"b,2,rolls,y?es,,",unreadable,0,1,bytes that are no text: save the file as UTF-8,,,,
    6,,b,2,rolls,"b,2,rolls",unreadable,0,1,3 fields where the header has 6,,,,
    7,,,2,rolls,"str?ange,2,rolls,yes,,",unreadable,0,0,bytes that are no text: save the file as UTF-8,,,,
    "#);
}

#[test]
fn parts_may_be_mapped_to_headers() {
    let text = "ID,Angular speed,Friction,note\nb,30.3,62 N,x\n";
    let map = |pairs: &[(&str, &str)]| Options {
        columns: pairs.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect(),
        ..Options::default()
    };
    let options = map(&[("student", "ID"), ("1.omega", "Angular speed"), ("rolling.friction", "friction")]);
    insta::assert_snapshot!(run_with(text.as_bytes(), &table(), &options).unwrap().0, @r"
    line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at
    2,Angular speed,b,1,omega,30.3,right,1,1,within the tolerance,,,,
    2,Friction,b,1,friction,62 N,right,1,1,within the tolerance,,,,
    ");
    let options = map(&[("student", "ID"), ("1.omgea", "Angular speed"), ("9.v", "note"), ("2.v", "Speed")]);
    insta::assert_snapshot!(run_with(text.as_bytes(), &table(), &options).unwrap_err().to_string(), @"
    --columns: no part `omgea`; did you mean omega? parts: omega, friction
    --columns: unknown column `9.v`
        hint: one of student, problem, part, answer, submitted_at, or a part such as 1.omega
    line 1, column 1: header: no column `Speed`
        hint: the columns are: ID | Angular speed | Friction | note
    ");
}

#[test]
fn a_wide_file_and_the_gradebook() {
    let text = "Email;1.omega;rolling.friction;2.v;2.nothing;note\nb;30,3;62,6 N up;;5;x\n00123;1;2\n00123;289 rpm;-62,6;1,25;;\n";
    let options = Options { columns: vec![("student".into(), "Email".into())], ..Options::default() };
    let (out, graded) = run_with(text.as_bytes(), &table(), &options).unwrap();
    insta::assert_snapshot!(out, @r#"
    line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at
    2,1.omega,b,1,omega,"30,3",right,1,1,within the tolerance; the comma is read as the decimal mark,,,,
    2,rolling.friction,b,1,friction,"62,6 N up",right,1,1,within the tolerance; the comma is read as the decimal mark,,,,
    2,2.v,b,2,v,,blank,0,1,nothing written,,,,
    2,2.nothing,b,2,nothing,5,unknown part,0,0,"no part `nothing`; parts: v, rolls",,,,
    3,,00123,,,00123;1;2,unreadable,0,0,3 fields where the header has 6,,,,
    4,1.omega,00123,1,omega,289 rpm,right,1,1,within the tolerance,,,,
    4,rolling.friction,00123,1,friction,"-62,6",wrong direction,0,1,"the magnitude is right, the sign is not; the comma is read as the decimal mark",,,,
    4,2.v,00123,2,v,"1,25",right,1,1,within the tolerance; the comma is read as the decimal mark,,,,
    4,2.nothing,00123,2,nothing,,unknown part,0,0,"no part `nothing`; parts: v, rolls",,,,
    "#);
    insta::assert_snapshot!(String::from_utf8(gradebook(&table(), &graded, &Policy::default())).unwrap(), @r#"
    student,name,1.omega,1.friction,2.v,2.rolls,total,max_total
    00123,"'=Ada, B.",1,0,1,,2,4
    b,Bo,1,1,,,2,4
    nobody,,,,,,0,4
    "#);
    assert_eq!((graded.wide, graded.unused_columns), (true, vec!["note".to_owned()]));
}

#[test]
fn attempts_are_ordered_by_time_and_else_by_row() {
    let text = "student,problem,part,answer,submitted_at\n\
        b,1,omega,30.3,2026-03-02 10:00\nb,1,omega,31,2026-03-01 10:00\n\
        b,2,v,1.25,2026-03-02 10:00\nb,2,v,1.3,yesterday\n";
    let verdicts = |attempts| {
        let mut policy = Policy::default();
        policy.attempts.counts = attempts;
        let out = run_by(text.as_bytes(), &table(), &Options::default(), &policy).unwrap().0;
        out.lines().skip(1).map(|l| l.split(',').nth(6).unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(verdicts(Counts::Last), ["right", "superseded", "superseded", "wrong"]);
    assert_eq!(verdicts(Counts::First), ["superseded", "wrong", "right", "superseded"]);
    assert_eq!(verdicts(Counts::Best), ["right", "superseded", "right", "superseded"]);
    let (out, graded) = run_with(text.as_bytes(), &table(), &Options::default()).unwrap();
    assert!(out.contains("submitted_at cannot be read for every attempt"), "{out}");
    assert_eq!(graded.untimed, 1);
}

/// The verdicts of two attempts at one part, right and then wrong by row, with these times; and what else is in the column.
fn timed(first: &str, second: &str, others: &[&str]) -> (Vec<String>, u64) {
    let mut text =
        format!("student,problem,part,answer,submitted_at\nb,1,omega,30.3,{first}\nb,1,omega,31,{second}\n");
    for other in others {
        text.push_str(&format!("stranger,1,omega,1,{other}\n"));
    }
    let (out, graded) = run_with(text.as_bytes(), &table(), &Options::default()).unwrap();
    let verdict = |l: &str| l.split(',').nth(6).unwrap().to_owned();
    (out.lines().skip(1).take(2).map(verdict).collect(), graded.untimed)
}

#[test]
fn form_services_times_and_the_order_of_day_and_month() {
    let first = (vec!["right".to_owned(), "superseded".to_owned()], 0);
    let second = |untimed| (vec!["superseded".to_owned(), "wrong".to_owned()], untimed);
    assert_eq!(timed("2026/01/05 1:00:02 PM GMT+1", "2026/01/05 10:00:02 AM GMT+1", &[]), first);
    assert_eq!(timed("2026/01/05 10:00:02 AM GMT+1", "2026/01/05 10:00:03 AM GMT+1", &[]), second(0));
    // 5 February and 10 January, or 2 May and 1 October
    let (a, b) = ("5/2/2026 9:00", "10/1/2026 9:00");
    assert_eq!(timed(a, b, &["25/1/2026 8:00"]), first);
    assert_eq!(timed(a, b, &["1/25/2026 8:00"]), second(0));
    assert_eq!(timed(b, a, &["1/25/2026 8:00"]), first);
    assert_eq!(timed(b, a, &[]), second(1), "undecided: by row");
    assert_eq!(timed(b, a, &["1/25/2026 8:00", "25/1/2026 8:00"]), second(1), "contradictory: by row");
    assert_eq!(timed("05.02.2026 9:00", "10.01.2026 9:00", &[]), first);
    // Moodle, spreadsheets and clocks, also mixed.
    assert_eq!(timed("\"Sunday, 29 March 2026, 3:30 PM\"", "29 March 2026 3:29 PM", &[]), first);
    assert_eq!(timed("3/29/26 15:30", "3/4/26 15:31", &[]), first, "month first, by the other");
    assert_eq!(timed("46110.645833", "1774798200", &[]), second(0), "15:29:59.97 and 15:30:00");
    assert_eq!(timed("29.03.2026 17:30 CEST", "29.03.2026 15:29 UTC", &[]), first);
    assert_eq!(timed("2026-03-29 12:00 IST", "2026-03-29 9:00", &[]), second(1), "IST means three things");
}

#[test]
fn a_single_attempt_needs_no_time() {
    let text = "student,problem,part,answer,submitted_at\nb,1,omega,30.3,yesterday\nb,2,v,,\nb,2,v,1.25,\n";
    let (out, graded) = run_with(text.as_bytes(), &table(), &Options::default()).unwrap();
    assert_eq!((out.contains("submitted_at cannot"), graded.untimed), (false, 0), "{out}");
}

/// The earlier tests had ids in the roster's own spelling or in another one that is no id; a student who writes `AB12` for `ab12`
/// was a stranger.
#[test]
fn an_id_that_differs_in_case_alone_counts_where_it_is_unique() {
    let table = KeyTable::new(["ab12", "Ab13", "aB13", "ÖZ1", "=x"].map(sheet).into(), &[]);
    let text = "student,problem,part,answer\nAB12,1,omega,30.3\nab12,1,omega,31\nAb13,1,omega,30.3\nAB13,1,omega,30.3\n\
        öz1,1,omega,\nöz1,2,v,1.25\n'=X,2,v,1.25\n'=x,1,omega,30.3\n";
    let (out, graded) = run_with(text.as_bytes(), &table, &Options::default()).unwrap();
    insta::assert_snapshot!(out, @"
        line,column,student,problem,part,answer,verdict,points,max_points,reason,methods,slip,credit,submitted_at
        2,,ab12,1,omega,30.3,superseded,0,1,superseded by line 3; would have been right: within the tolerance; the id AB12 is read as ab12: they differ only in case or in how an accent or apostrophe is coded,,,,
        3,,ab12,1,omega,31,wrong,0,1,not within the tolerance,,,,
        4,,Ab13,1,omega,30.3,right,1,1,within the tolerance,,,,
        5,,AB13,1,omega,30.3,unknown student,0,0,not on the roster,,,,
        6,,ÖZ1,1,omega,,blank,0,1,nothing written; the id öz1 is read as ÖZ1: they differ only in case or in how an accent or apostrophe is coded,,,,
        7,,ÖZ1,2,v,1.25,right,1,1,within the tolerance; the id öz1 is read as ÖZ1: they differ only in case or in how an accent or apostrophe is coded,,,,
        8,,'=x,2,v,1.25,right,1,1,within the tolerance; the id '=X is read as =x: they differ only in case or in how an accent or apostrophe is coded,,,,
        9,,'=x,1,omega,30.3,right,1,1,within the tolerance,,,,
        ");
    assert_eq!(graded.respelled, 4);
    let options = Options { threads: 2, ..Options::default() };
    assert_eq!(run_with(text.as_bytes(), &table, &options).unwrap().0, out);
    // As file names and exports of some systems have it: the mark of its own behind the letter.
    let marks = "student,problem,part,answer\nO\u{308}Z1,1,omega,30.3\no\u{308}z1,2,v,1.25\n";
    let (out, graded) = run_with(marks.as_bytes(), &table, &Options::default()).unwrap();
    assert_eq!((out.matches(",right,").count(), graded.respelled), (2, 2), "{out}");
}

/// Headers had to be a part and nothing else; form services put a title before it and columns of their own beside it.
#[test]
fn a_header_that_contains_exactly_one_part_is_that_part() {
    let wide = |header: &str| {
        let row = "b,30.3,62.6 N,7\n";
        run_with(format!("student,{header}\n{row}").as_bytes(), &table(), &Options::default())
    };
    for header in [
        "Problem 1: 1.omega,Problem 1: 1.friction,Time",
        "1.omega (rad/s),rolling.friction in N,Both (1.omega 1.friction)",
        "Question [1.OMEGA],\"Q2, 1.friction?\",Version 2.5",
        "Problem 1: 1.omega,1.friction,Points - Problem 1: 1.omega",
        "1.omega,Problem 1: 1.friction,Feedback on 1.omega",
    ] {
        let (out, graded) = wide(header).unwrap();
        let verdicts: Vec<&str> = out.lines().skip(1).filter(|l| l.contains(",right,1,1,")).collect();
        assert_eq!((verdicts.len(), graded.cells, graded.unused_columns.len()), (2, 2, 1), "{header}: {out}");
    }
    let fault = wide("Try 1.omega,1.friction,Again 1.omega").unwrap_err().to_string();
    assert!(fault.contains("`Again 1.omega` asks for a part that stands there already"), "{fault}");
    assert!(fault.contains("--columns 1.omega=\"Its header\""), "{fault}");
    let columns = vec![("1.omega".to_owned(), "Try 1.omega".to_owned())];
    let told = Options { columns, ..Options::default() };
    let text = "student,Try 1.omega,1.friction,Again 1.omega\nb,30.3,62.6,7\n";
    let (_, graded) = run_with(text.as_bytes(), &table(), &told).unwrap();
    assert_eq!((graded.count(Verdict::Right), graded.unused_columns), (2, vec!["Again 1.omega".to_owned()]));
}

/// The list of columns stood behind every missing one, and that of the parts behind every unknown one.
#[test]
fn a_list_is_printed_once_in_a_message() {
    let columns =
        ["1.omgea", "1.fricton", "rolling.x", "9.v", "student"].map(|part| (part.to_owned(), "x".to_owned()));
    let options = Options { columns: columns.into(), ..Options::default() };
    let told = run_with(b"id;problem;part;note\n1;2;3;4\n", &table(), &options).unwrap_err().to_string();
    for list in ["id | problem | part | note", "omega, friction"] {
        assert_eq!(told.matches(list).count(), 1, "{list} in {told}");
    }
    let mut policy = Policy::default();
    for part in ["1.x", "1.y", "7"] {
        let (problem, part) = part.split_once('.').unwrap_or((part, "v"));
        policy.points.push((
            slipstick::policy::PolicyPart {
                problem: problem.to_owned(),
                part: Some(part.to_owned()),
                at: (1, 1),
            },
            1.0,
        ));
    }
    let table = table();
    let faults = Rules::new(&table, &policy).unwrap_err();
    let told: String = faults.iter().map(|f| format!("{f}\n")).collect();
    assert_eq!((faults.len(), told.matches("1.omega, 1.friction").count()), (3, 1), "{told}");
}

/// A workbook was read as text, and the message was about a missing column in a kilobyte of signs.
#[test]
fn what_is_no_csv_is_named() {
    let zip = |inside: &str| [b"PK\x03\x04\x14\0", inside.as_bytes(), &[0, 0xff, b'\n']].concat();
    for (bytes, name) in [
        (zip("[Content_Types].xml....xl/workbook.xml"), "an Excel workbook (.xlsx)"),
        (zip("mimetypeapplication/vnd.oasis.opendocument.spreadsheet"), "a LibreOffice spreadsheet (.ods)"),
        (zip("Index/Document.iwa"), "a Numbers spreadsheet (.numbers)"),
        (zip("notes.txt"), "a zip archive"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0\0".to_vec(), "an old Excel workbook (.xls)"),
        (b"%PDF-1.7\n".to_vec(), "a PDF file"),
        (b"\xef\xbb\xbf\n<HTML><table>".to_vec(), "a web page"),
    ] {
        let fault = run_with(&bytes, &table(), &Options::default()).unwrap_err().to_string();
        assert!(fault.contains(name) && fault.contains("save the sheet as CSV"), "{name}: {fault}");
        let faults = slipstick::answer::roster::roster(&bytes).unwrap_err();
        assert!(faults.len() == 1 && faults[0].message.contains(name), "{name}: {faults:?}");
    }
}

/// Tests had columns of points whose header ended like the part's own, none of remarks in other words; and no file with more
/// columns than are shown.
#[test]
fn a_column_of_remarks_is_no_second_answer_and_a_long_list_says_how_long_it_is() {
    let graded = run("student,Q1 1.omega,Comments on 1.omega\nb,30.3,hard\n");
    assert!(graded.contains("30.3,right") && !graded.contains("hard"), "{graded}");
    let refused = |text: &str| {
        let told = run_with(text.as_bytes(), &table(), &Options::default());
        told.map(|_| ()).map_err(|fault| format!("{fault:?}")).unwrap_err()
    };
    let twice = refused("student,Q1 1.omega,Again 1.omega\nb,30.3,30.3\n");
    assert!(twice.contains("--columns 1.omega="), "{twice}");
    let many: Vec<String> = (0..300).map(|i| format!("foo{i}")).collect();
    let told = refused(&format!("student,{}\nb\n", many.join(",")));
    assert!(told.contains("foo28 | and 271 more"), "{told}");
}

#[test]
fn headers_that_do_not_do_are_told_at_once() {
    let fault = run_with(b"id,problem,part,part\n", &table(), &Options::default()).unwrap_err();
    insta::assert_snapshot!(fault.to_string(), @r#"
    line 1, column 1: header: no column `student`
        hint: the columns are: id | problem | part | part; map one with --columns student="Its header"
    line 1, column 1: header: column `part` stands there 2 times (fields 3, 4)
        hint: rename all but one
    line 1, column 1: header: no column `answer`
        hint: map one with --columns answer="Its header"
    "#);
}

/// A million rows with one per cent garbage: each row comes out once, in order, whatever the number of threads.
#[test]
fn a_million_rows_are_accounted_for() {
    let rows = 1_000_000;
    let garbage = [
        "\"open,1,omega,3",
        "s1,1,omega,1,25 m/s",
        "s1,1",
        "\u{0},1,omega,2",
        "s1,1,omega,\u{fffd}?",
        "zzz,1,omega,1",
        "s1,9,omega,1",
        "s1,1,omega,1e999",
        ",,,",
        "s1,1,omega,\"5\" rod",
    ];
    let mut text = String::from("student,problem,part,answer\n");
    for i in 0..rows {
        if i % 100 == 99 {
            text.push_str(garbage[(i / 100) % garbage.len()]);
            text.push('\n');
        } else {
            let part = ["omega", "friction"][i % 2];
            text.push_str(&format!("s{},1,{part},{}.{}\n", i % 1000, 30 + i % 40, i % 10));
        }
    }
    let sheets = (0..1000).map(|i| sheet(&format!("s{i}"))).collect();
    let table = KeyTable::new(sheets, &[]);
    let options = Options { threads: 2, ..Options::default() };
    let (out, graded) = run_with(text.as_bytes(), &table, &options).unwrap();
    assert_eq!((graded.cells, graded.counts.iter().sum::<u64>()), (rows as u64, rows as u64));
    let mut lines = out.lines().skip(1);
    for row in 0..rows {
        let line = lines.next().expect("a line for each row");
        assert!(line.starts_with(&format!("{},", row + 2)), "row {row}: {line}");
    }
    assert_eq!(lines.next(), None);
    assert!(graded.count(Verdict::Unreadable) >= 3000, "{:?}", graded.counts);
}

/// The column `slip` of a single answer to a part with this key, whose tolerance is 0.5 %.
fn slip_of(cell: &str, key: f64, unit: &str) -> String {
    let part = entry("x", number(key, 0.005 * key.abs(), true), unit);
    let problem = ProblemKey { id: "p".into(), parts: vec![part], ..sheet("s").problems[0].clone() };
    let table = KeyTable::new(vec![SheetKey { student: "s".into(), problems: vec![problem] }], &[]);
    let text = format!("student,problem,part,answer\ns,1,x,\"{cell}\"\n");
    let (out, _) = run_with(text.as_bytes(), &table, &Options::default()).unwrap();
    let mut reader = csv::Reader::from_reader(out.as_bytes());
    let at = reader.headers().unwrap().iter().position(|h| h == "slip").unwrap();
    reader.records().next().unwrap().unwrap()[at].to_owned()
}

// Nothing before this looked at how the number was written: only whether its value was the key rounded to one or two figures. So `-1.00e+02`,
// rounded on the way, was told to have one figure; and a number in another unit was held against the key rounded in SI.
#[test]
fn fewer_figures_are_counted_as_they_are_written() {
    for (cell, key, unit, figures) in [
        ("-1.00e+02", -105.2, "N", None),
        ("-100. N", -105.2, "N", None),
        ("-1e2", -105.2, "N", Some(1)),
        ("-100 N", -105.2, "N", Some(1)),
        ("-1.1e2 N", -105.2, "N", Some(2)),
        ("-1,1e2 N", -105.2, "N", Some(2)),
        ("-110", -105.2, "N", Some(2)),
        ("-110,0", -105.2, "N", None),
        ("-0.11 kN", -105.2, "N", Some(2)),
        ("-0,110 kN", -105.2, "N", None),
        ("11 * 10^1 N up", 105.2, "N", Some(2)),
        ("300 rpm", 30.263, "rad/s", Some(1)),
        ("3.0e2 rpm", 30.263, "rad/s", None),
        ("290 rpm", 30.9, "rad/s", None),
        ("0.05", 0.0462, "m", Some(1)),
        ("0.050", 0.0462, "m", None),
        ("5 cm", 0.0462, "m", Some(1)),
        // Halves go up, from the decimal number; one more figure is as good as it gets.
        ("0.53", 0.525, "m", Some(2)),
        ("0.52", 0.525, "m", None),
        // A number in the cell that is not the answer has no figures of its own.
        ("omega_1 = 27.5", 30.263, "rad/s", None),
    ] {
        let slip = slip_of(cell, key, unit);
        let told = slip.strip_prefix("figures:").map(|n| n.parse::<u32>().unwrap());
        assert_eq!(told, figures, "{cell} for {key} {unit}: {slip}");
    }
}

#[test]
fn too_few_figures_are_told_only_of_the_right_number_rounded_to_them() {
    use dashu_float::DBig;
    use std::str::FromStr;
    let (mut told, mut silent) = (0, 0);
    for step in 0..400u32 {
        let key = (1.0 + f64::from(step) * 0.0225) * [0.01, 1.0, 100.0][step as usize % 3];
        let key: f64 = format!("{key:.3e}").parse().unwrap();
        let exact = DBig::from_str(&key.to_string()).unwrap();
        for figures in 1..=3usize {
            for off in [-1i32, 0, 1] {
                let near = format!("{:.*e}", figures - 1, key);
                let (mantissa, exponent) = near.split_once('e').unwrap();
                let digits = mantissa.replace('.', "").parse::<i32>().unwrap() + off;
                if digits.to_string().len() != figures {
                    continue;
                }
                let text = digits.to_string();
                let mantissa = match text.split_at(1) {
                    (one, "") => one.to_owned(),
                    (one, rest) => format!("{one}.{rest}"),
                };
                let forms =
                    [format!("{mantissa}e{exponent}"), format!("{mantissa}e{exponent}").replace('.', ",")];
                for cell in forms {
                    let written = DBig::from_str(&format!("{mantissa}e{exponent}")).unwrap();
                    let rounds = exact.clone().with_precision(figures).value() == written;
                    let value: f64 = format!("{mantissa}e{exponent}").parse().unwrap();
                    let slip = slip_of(&cell, key, "m");
                    let says = slip == format!("figures:{figures}");
                    if (value - key).abs() <= 0.005 * key {
                        assert_eq!(slip, "", "{cell} is right for {key}");
                    } else {
                        assert_eq!(says, rounds, "{cell} for {key}: {slip}");
                        assert!(says || !slip.starts_with("figures"), "{cell} for {key}: {slip}");
                        told += u32::from(says);
                        silent += u32::from(!says);
                    }
                }
            }
        }
    }
    println!("{told} answers have too few figures, {silent} are another number");
    assert!(told > 300 && silent > 300, "{told} {silent}");
}

/// A line of 100 MB, in one field or in many, quoted or not, is one unreadable record and is never held.
#[test]
fn a_line_of_100_mb_is_not_held() {
    use std::io::Read;
    if std::env::var_os("SLIPSTICK_ALONE").is_none() {
        // in a process of its own: the other tests of this one hold memory too
        let child = std::process::Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "grading_table::a_line_of_100_mb_is_not_held"])
            .env("SLIPSTICK_ALONE", "1")
            .output()
            .unwrap();
        assert!(child.status.success(), "{}", String::from_utf8_lossy(&child.stdout));
        return;
    }
    let peak = || {
        let status = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
        status.split(' ').nth(1).and_then(|pages| pages.parse::<u64>().ok()).unwrap_or(0) * 4096
    };
    for filler in [b'x', b',', b'"'] {
        let before = peak();
        let open = || {
            let head = Cursor::new(b"student,problem,part,answer\nb,1,omega,\"1".to_vec());
            let tail = Cursor::new(b"\nb,1,omega,30.3\n".to_vec());
            Ok(Box::new(head.chain(std::io::repeat(filler).take(100 << 20)).chain(tail))
                as Box<dyn Read + Send>)
        };
        let (mut out, mut most) = (Vec::new(), 0);
        let options = Options { threads: 2, ..Options::default() };
        let policy = Policy::default();
        let rules = Rules::new(&table(), &policy).unwrap();
        let graded =
            grade(&open, &table(), &rules, &options, &mut out, &mut |_| most = peak().max(most)).unwrap();
        let out = String::from_utf8(out).unwrap();
        assert_eq!((graded.cells, graded.count(Verdict::Right)), (2, 1), "{out}");
        assert!(
            out.contains("a field longer than 64 KiB") && out.contains("3,,b,1,omega,30.3,right"),
            "{out}"
        );
        assert!(most.saturating_sub(before) < 50 << 20, "{filler}: {before} then {most}");
    }
}

mod any {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        #[test]
        fn no_cell_panics(
            cell in "\\PC{0,60}",
            near in "[0-9.,eEx×^· +−mNkrads/upown-]{0,20}",
            nearer in "[0-9.,'’ ±√π½٣()\\[\\]{}&;#<>/*^\"$\\\\a-z-]{0,30}",
        ) {
            for name in ["omega", "friction", "rolls", "large"] {
                for cell in [&cell, &near, &nearer] {
                    let got = compare(cell, &key(name));
                    prop_assert!(!got.reason.is_empty());
                }
            }
        }

        #[test]
        fn any_bytes_come_out_once_and_the_same_for_any_threads(
            pieces in prop::collection::vec(prop_oneof![
                Just("b,1,omega,30.3\n".as_bytes().to_vec()), Just(b"\"".to_vec()), Just(b"\r\n".to_vec()),
                Just(b"00123,2,v,\"1,25\"\n".to_vec()), prop::collection::vec(any::<u8>(), 0..12)], 0..40),
        ) {
            let bytes = [b"student,problem,part,answer\n".to_vec(), pieces.concat()].concat();
            let options = |threads| Options { threads, ..Options::default() };
            let (one, graded) = run_with(&bytes, &table(), &options(1)).unwrap();
            let (three, _) = run_with(&bytes, &table(), &options(3)).unwrap();
            prop_assert_eq!(&one, &three);
            let records = slipstick::answer::submissions::all_records(Box::new(Cursor::new(bytes))).unwrap().1;
            prop_assert_eq!(graded.cells, records.len() as u64);
            let mut reader = csv::ReaderBuilder::new().from_reader(one.as_bytes());
            let lines: Vec<u64> = reader.records().map(|r| r.unwrap()[0].parse().unwrap()).collect();
            prop_assert_eq!(lines, records.iter().map(|r| r.0).collect::<Vec<_>>());
        }
    }
}

/// `cargo test --release --test grading grading_table -- --ignored --nocapture speed`: rows per second on one and two threads.
#[test]
#[ignore = "a measurement, for a release build"]
fn speed_of_a_million_plain_rows() {
    let sheets = (0..1000).map(|i| sheet(&format!("s{i}"))).collect();
    let table = KeyTable::new(sheets, &[]);
    let folder = tempfile::tempdir().unwrap();
    let (input, output) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
    let mut text = String::from("student,problem,part,answer\n");
    for i in 0u64..1_000_000 {
        let student = i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32; // random order
        let part = ["omega", "friction"][(student / 1000 % 2) as usize];
        text.push_str(&format!("s{},1,{part},{}.{}\n", student % 1000, 30 + i % 40, i % 1000));
    }
    std::fs::write(&input, text).unwrap();
    for threads in [1, 2, 2, 1] {
        let start = std::time::Instant::now();
        let open = || Ok(Box::new(std::fs::File::open(&input)?) as Box<dyn std::io::Read + Send>);
        let mut out = std::fs::File::create(&output).unwrap();
        let options = Options { threads, ..Options::default() };
        let policy = Policy::default();
        let rules = Rules::new(&table, &policy).unwrap();
        let graded = grade(&open, &table, &rules, &options, &mut out, &mut |_| {}).unwrap();
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let peak = status.lines().find(|l| l.starts_with("VmHWM")).unwrap_or("").to_owned();
        eprintln!(
            "{threads} threads: {:?}, {} cells, {peak} (with the text made above)",
            start.elapsed(),
            graded.cells
        );
    }
}
