//! Units as a bank needs them: does a unit fit a use, constants of the scene, dimensions of expressions.
use crate::bank::Datum;
use crate::bank::decimal::Decimal;
use crate::bank::expression::{Exponents, Name};
use crate::bank::node::{Faults, Node, shorten};
use crate::scene::{Label, Owner, Scene};
use crate::units::{Unit, parse_quantity};

/// A unit from its spelling, or what is wrong with it.
pub fn unit(text: &str) -> Result<Unit, String> {
    Unit::parse(text.trim()).map_err(|fault| format!("`{}`: {fault}", shorten(text)))
}

/// One of the program's own spellings.
///
/// # Panics
/// If the program spells a unit that its own table does not know, which a test excludes.
fn own(ascii: &str) -> Unit {
    Unit::parse(ascii)
        .unwrap_or_else(|fault| panic!("the program's own unit `{ascii}` is not known: {fault}"))
}

/// Is a quantity in this unit of the same kind as one in the (own) unit `wanted`? The radian may be dropped in rates.
pub fn fits(unit: &Unit, wanted: &str) -> bool {
    own(wanted).agrees(unit)
}

/// `expected N (force), found kg (mass)`, with the missing factor if it is a single one.
pub fn mismatch(unit: &Unit, wanted: &str) -> String {
    own(wanted).mismatch(unit)
}

/// A constant of a scene such as `20 kg`: SI, a slope in degrees. A plain number has no dimension.
pub fn constant(text: &str, wanted: &str) -> Result<f64, String> {
    let read = parse_quantity(text, &Unit::one()).map_err(|fault| format!("`{}`: {fault}", shorten(text)))?;
    if !fits(&read.unit, wanted) {
        return Err(format!("`{}`: {}", shorten(text), mismatch(&read.unit, wanted)));
    }
    Ok(if wanted == "deg" { read.value_scene } else { read.value_si })
}

/// A constant that is printed as it is written, such as `9.81 m/s^2`: digits and unit.
pub fn decimal_constant(text: &str) -> Result<(Decimal, Unit), String> {
    let text = text.trim();
    let end =
        text.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+'))).unwrap_or(text.len());
    let (digits, rest) = text.split_at(end);
    let number = Decimal::read(digits.trim()).map_err(|why| match digits.is_empty() {
        true => format!("`{}` does not begin with a decimal number", shorten(text)),
        false => why,
    })?;
    let unit = if rest.trim().is_empty() { Unit::one() } else { unit(rest)? };
    Ok((number, unit))
}

/// The dimension as an expression counts it: exponents of mass, length and time, in quarters.
pub fn powers(unit: &Unit) -> Exponents {
    let [mass, length, time, _] = unit.dimension().0;
    [i32::from(mass) * 4, i32::from(length) * 4, i32::from(time) * 4]
}

/// The same of one of the program's own units.
pub fn own_powers(ascii: &str) -> Exponents {
    powers(&own(ascii))
}

/// A dimension in words, for messages: `kg m s^-2`.
pub fn powers_text(powers: Exponents) -> String {
    let mut words = Vec::new();
    for (name, p) in ["kg", "m", "s"].iter().zip(powers) {
        match p {
            0 => {}
            4 => words.push((*name).to_owned()),
            p if p % 4 == 0 => words.push(format!("{name}^{}", p / 4)),
            p => words.push(format!("{name}^({}/4)", p)),
        }
    }
    if words.is_empty() { "1".to_owned() } else { words.join(" ") }
}

/// A datum as an expression takes it, if there is one of this name, with its dimension.
pub fn datum(data: &[Datum], name: &str) -> Option<(Name, Exponents)> {
    let i = data.iter().position(|d| d.symbol == name)?;
    Some((Name::Datum(i, data[i].degrees), powers(&data[i].unit)))
}

/// A quantity as an expression takes it, with its dimension. Errors: it is a word: message, and no hint.
pub fn quantity(
    scene: &Scene,
    label: Label,
    name: &str,
) -> Result<(Name, Exponents), (String, Option<String>)> {
    match label.of {
        Owner::Asked(i) => {
            let powers = scene.formulas.asked.get(i).map_or([0; 3], |a| a.powers.map(|p| 4 * p));
            Ok((Name::Quantity(label), powers))
        }
        _ => own_quantity(label, name),
    }
}

/// The same of a quantity that the solvers give. Errors: those of [`quantity`].
pub fn own_quantity(label: Label, name: &str) -> Result<(Name, Exponents), (String, Option<String>)> {
    if label.quantity.is_word() {
        return Err((format!("`{name}` is a word, not a number"), None));
    }
    Ok((Name::Quantity(label), own_powers(label.quantity.unit())))
}

/// The unit of SI of these powers of mass, length and time, by its short name where it has one.
pub fn si(powers: [i32; 3]) -> String {
    let quarters = powers.map(|p| 4 * p);
    let short = ["N", "J", "W", "N/m", "m/s", "m/s^2", "Pa"];
    let found = short.into_iter().find(|unit| own_powers(unit) == quarters);
    found.map_or_else(|| powers_text(quarters), str::to_owned)
}

/// That something else was expected, or that there are too many digits.
pub fn expected(what: &str, node: &Node, fault: Option<&String>) -> String {
    match fault.filter(|why| why.contains("too many digits")) {
        Some(why) => format!("expected {what}: {why}"),
        None => format!("expected {what}, found {}", node.kind()),
    }
}

/// A plain number from so much to so much.
pub fn limit(node: &Node, (what, least, most): (&str, f64, f64), faults: &Faults) -> Option<f64> {
    let written = Decimal::read(node.text().unwrap_or("").trim());
    let fine = written.as_ref().ok().map(|d| d.f64()).filter(|x| (least..=most).contains(x));
    if fine.is_none() {
        faults.at(node, expected(&format!("{what} from {least} to {most}"), node, written.as_ref().err()));
    }
    fine
}
