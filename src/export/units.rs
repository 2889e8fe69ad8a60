//! Units of the same kind as the one that is asked, with their factors.
use crate::units::Unit;

/// Units beside the one that is asked that a numerical question may take, as far as they are of its kind.
const UNITS: [&str; 39] = [
    "rad/s", "rpm", "rev/s", "deg/s", "m/s", "km/h", "cm/s", "mm/s", "m", "cm", "mm", "km", "rad", "deg",
    "rev", "N", "kN", "mN", "J", "kJ", "mJ", "N m", "kN m", "N cm", "W", "kW", "kg", "g", "t", "s", "ms",
    "min", "m/s^2", "cm/s^2", "rad/s^2", "deg/s^2", "kg m^2", "N/m", "kN/m",
];

/// Other names of a turn in a minute that `grade` reads; `1/min` is one where a speed of turning is asked.
const TURNS: [&str; 4] = ["rev/min", "U/min", "1/min", "r/min"];

/// The units in which an answer in this one may be given, each with the factor that makes a number in the asked unit one in it: the one
/// that is asked first, all in the spellings without blank and with a small raised digit, too.
pub fn units(asked: &Unit) -> Vec<(String, f64)> {
    let mut found: Vec<(String, f64)> = Vec::new();
    if asked.is_number() {
        return found;
    }
    let others = UNITS.iter().filter_map(|name| Unit::parse(name).ok());
    for unit in std::iter::once(asked.clone()).chain(others.filter(|u| u.dimension() == asked.dimension())) {
        let multiplier = if unit.ascii() == asked.ascii() { 1.0 } else { asked.per(&unit) };
        let raised = unit.ascii().replace("^2", "²").replace("^3", "³");
        let mut names = vec![unit.ascii().to_owned(), unit.ascii().replace(' ', ""), raised];
        if unit.ascii().starts_with("deg") {
            names.push(unit.ascii().replacen("deg", "°", 1));
        }
        if unit.ascii() == "rpm" {
            names.extend(TURNS.map(str::to_owned));
        }
        for name in names {
            if found.iter().all(|(known, _)| *known != name) {
                found.push((name, multiplier));
            }
        }
    }
    found
}
