//! Values as they are printed to the numbers that a scene takes.
use crate::bank::Datum;
use crate::bank::decimal::Decimal;
use crate::units::WrittenQuantity;

/// The number of a printed value, as the scene takes it: SI, slopes in degrees. It is the nearest double.
pub fn number(datum: &Datum, value: Decimal) -> f64 {
    if datum.degrees {
        datum.unit.decimal_to_scene(value.value, value.decimals)
    } else {
        datum.unit.decimal_to_si(value.value, value.decimals)
    }
}

/// The number of a quantity that was typed, as the scene takes it.
pub fn typed(datum: &Datum, quantity: &WrittenQuantity) -> f64 {
    if datum.degrees { quantity.value_scene } else { quantity.value_si }
}
