//! The units that are known: their names, prefixes and exact sizes in SI. Sources: SI Brochure, 9th edition, tables 2 to 8;
//! NIST SP 811 (2008), appendix B for the foot (0.3048 m), the pound (0.453 592 37 kg) and g_n = 9.806 65 m/s^2.
use crate::units::{Dimension, UnitScale};

/// A unit, or what is read as one.
pub(crate) struct UnitRow {
    /// As it may be written.
    pub names: &'static [&'static str],
    /// As it is written in ASCII by this program (`deg` for `°`, `N m` for `Nm`).
    pub ascii: &'static str,
    pub dimension: Dimension,
    pub scale: UnitScale,
    /// Letters of the prefixes that it takes.
    pub prefixes: &'static str,
}

#[expect(clippy::too_many_arguments, reason = "a row of a table, read by column")]
const fn row(
    names: &'static [&'static str],
    ascii: &'static str,
    d: [i8; 4],
    num: u128,
    den: u128,
    ten: i16,
    pi: i8,
    prefixes: &'static str,
) -> UnitRow {
    UnitRow { names, ascii, dimension: Dimension(d), scale: UnitScale { num, den, ten, pi }, prefixes }
}

const MASS: [i8; 4] = [1, 0, 0, 0];
const LENGTH: [i8; 4] = [0, 1, 0, 0];
const TIME: [i8; 4] = [0, 0, 1, 0];
const ANGLE: [i8; 4] = [0, 0, 0, 1];
const SPIN: [i8; 4] = [0, 0, -1, 1];
const SPEED: [i8; 4] = [0, 1, -1, 0];
const FORCE: [i8; 4] = [1, 1, -2, 0];
const MOMENTUM: [i8; 4] = [1, 1, -1, 0];
const ACTION: [i8; 4] = [1, 2, -1, 0]; // of an angular momentum, too
const ENERGY: [i8; 4] = [1, 2, -2, 0];
const POWER: [i8; 4] = [1, 2, -3, 0];
const PRESSURE: [i8; 4] = [1, -1, -2, 0];
const NONE: [i8; 4] = [0, 0, 0, 0];

/// Prefix, as it may be written, its ASCII form and its power of ten.
pub(crate) const PREFIXES: &[(char, &str, i16)] = &[
    ('k', "k", 3),
    ('M', "M", 6),
    ('G', "G", 9),
    ('c', "c", -2),
    ('d', "d", -1),
    ('m', "m", -3),
    ('n', "n", -9),
    ('u', "u", -6),
    ('\u{b5}', "u", -6),
    ('\u{3bc}', "u", -6),
];

const LBF: u128 = 44_482_216_152_605; // 0.45359237 * 9.80665 N, times 10^13

/// All names. The first row of equal size is the one shown.
pub(crate) const ROWS: &[UnitRow] = &[
    row(&["g"], "g", MASS, 1, 1, -3, 0, "kmMu\u{b5}\u{3bc}"),
    row(&["t"], "t", MASS, 1, 1, 3, 0, ""),
    row(&["lb", "lbm", "lbs", "pound", "pounds"], "lb", MASS, 45_359_237, 1, -8, 0, ""),
    row(&["slug", "slugs"], "slug", MASS, LBF, 3048, -9, 0, ""), // lbf s^2/ft
    row(&["m"], "m", LENGTH, 1, 1, 0, 0, "kcdmnu\u{b5}\u{3bc}"),
    row(&["in", "inch", "inches"], "in", LENGTH, 254, 1, -4, 0, ""),
    row(&["ft", "foot", "feet"], "ft", LENGTH, 3048, 1, -4, 0, ""),
    row(&["yd"], "yd", LENGTH, 9144, 1, -4, 0, ""),
    row(&["mi"], "mi", LENGTH, 1_609_344, 1, -3, 0, ""),
    row(&["s"], "s", TIME, 1, 1, 0, 0, "mnu\u{b5}\u{3bc}"),
    row(&["sec", "second", "seconds", "Sekunde", "Sekunden"], "s", TIME, 1, 1, 0, 0, ""),
    row(&["min", "minute", "minutes", "Minuten"], "min", TIME, 60, 1, 0, 0, ""),
    row(&["h", "hr", "hour", "hours", "Stunde", "Stunden"], "h", TIME, 3600, 1, 0, 0, ""),
    row(&["rad"], "rad", ANGLE, 1, 1, 0, 0, "mu\u{b5}\u{3bc}"),
    row(&["deg", "\u{b0}", "\u{ba}", "degree", "degrees", "Grad"], "deg", ANGLE, 1, 180, 0, 1, ""),
    row(&["gon"], "gon", ANGLE, 1, 200, 0, 1, ""),
    row(&["arcmin"], "arcmin", ANGLE, 1, 10_800, 0, 1, ""),
    row(&["arcsec"], "arcsec", ANGLE, 1, 648_000, 0, 1, ""),
    row(
        &["rev", "turn", "turns", "revs", "revolution", "revolutions", "Umdr", "Umdrehung", "Umdrehungen"],
        "rev",
        ANGLE,
        2,
        1,
        0,
        1,
        "",
    ),
    row(&["rpm", "Upm"], "rpm", SPIN, 1, 30, 0, 1, "k"),
    row(&["Hz"], "Hz", SPIN, 2, 1, 0, 1, "k"), // a cycle is a turn: 1 Hz = 1 rev/s
    row(&["N"], "N", FORCE, 1, 1, 0, 0, "kMmu\u{b5}\u{3bc}"),
    row(&["lbf"], "lbf", FORCE, LBF, 1, -13, 0, "k"),
    row(&["kgf", "kp"], "kgf", FORCE, 980_665, 1, -5, 0, ""),
    row(&["dyn"], "dyn", FORCE, 1, 1, -5, 0, ""),
    row(&["J"], "J", ENERGY, 1, 1, 0, 0, "kMmu\u{b5}\u{3bc}"),
    row(&["Nm"], "N m", ENERGY, 1, 1, 0, 0, "kMm"),
    row(&["Ncm"], "N cm", ENERGY, 1, 1, -2, 0, ""),
    row(&["Nmm"], "N mm", ENERGY, 1, 1, -3, 0, "k"),
    row(&["Ns"], "N s", MOMENTUM, 1, 1, 0, 0, "kmM"),
    row(&["Nms"], "N m s", ACTION, 1, 1, 0, 0, "k"),
    row(&["Js"], "J s", ACTION, 1, 1, 0, 0, "k"),
    row(&["Ws"], "W s", ENERGY, 1, 1, 0, 0, "k"),
    row(&["Wh"], "W h", ENERGY, 3600, 1, 0, 0, "k"),
    row(&["ft-lb", "ft-lbf", "lb-ft", "lbf-ft"], "ft lbf", ENERGY, LBF * 3048, 1, -17, 0, ""),
    row(&["W"], "W", POWER, 1, 1, 0, 0, "kMm"),
    row(&["Pa"], "Pa", PRESSURE, 1, 1, 0, 0, "kMG"),
    row(&["mps"], "m/s", SPEED, 1, 1, 0, 0, ""),
    row(&["kmh", "kph"], "km/h", SPEED, 5, 18, 0, 0, ""),
    row(&["mph"], "mi/h", SPEED, 44_704, 1, -5, 0, ""),
    row(&["knot", "knots", "kt", "kts"], "knot", SPEED, 463, 9, -2, 0, ""), // 1852 m in an hour
    row(&["fps"], "ft/s", SPEED, 3048, 1, -4, 0, ""),
    row(&["%"], "%", NONE, 1, 1, -2, 0, ""),
    row(&["gram", "grams", "Gramm"], "g", MASS, 1, 1, -3, 0, ""),
    row(&["kilogram", "kilograms", "Kilogramm"], "kg", MASS, 1, 1, 0, 0, ""),
    row(&["meter", "meters", "metre", "metres"], "m", LENGTH, 1, 1, 0, 0, ""),
    row(&["radian", "rads", "radians", "Radiant"], "rad", ANGLE, 1, 1, 0, 0, ""),
    row(&["Newtonmeter"], "N m", ENERGY, 1, 1, 0, 0, ""),
    row(&["newton", "newtons"], "N", FORCE, 1, 1, 0, 0, ""),
    row(&["joule", "joules"], "J", ENERGY, 1, 1, 0, 0, ""),
    row(&["kilojoule", "kilojoules"], "kJ", ENERGY, 1, 1, 3, 0, ""),
    row(&["watt", "watts"], "W", POWER, 1, 1, 0, 0, ""),
];

/// Words for dimensions that mechanics meets, for messages.
pub(crate) const KINDS: &[([i8; 4], &str)] = &[
    (MASS, "mass"),
    (LENGTH, "length"),
    (TIME, "time"),
    (ANGLE, "angle"),
    (SPIN, "angular velocity"),
    (SPEED, "speed"),
    (FORCE, "force"),
    (ENERGY, "energy or moment"),
    (POWER, "power"),
    (PRESSURE, "pressure"),
    (NONE, "pure number"),
    ([0, 1, -2, 0], "acceleration"),
    ([0, 0, -2, 1], "angular acceleration"),
    ([1, 2, 0, 0], "moment of inertia"),
    ([1, 0, -2, 0], "stiffness"),
    ([0, 2, 0, 0], "area"),
    ([0, 3, 0, 0], "volume"),
    ([1, 1, -1, 0], "momentum"),
    ([1, 2, -1, 0], "angular momentum"),
    ([0, 0, -1, 0], "frequency"),
];

/// Single units that may be the one that is missing.
pub(crate) const SINGLE: &[&str] = &["s", "m", "kg", "rad", "N", "m/s", "rad/s", "m/s^2"];
