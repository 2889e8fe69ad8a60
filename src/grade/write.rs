//! Numbers as bytes: no formatting where digits will do.

/// A whole number.
pub(crate) fn push_number(out: &mut Vec<u8>, mut number: u64) {
    let mut digits = [0u8; 20];
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (number % 10) as u8;
        number /= 10;
        if number == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}

/// Points: whole numbers without a point.
pub(crate) fn push_float(out: &mut Vec<u8>, value: f64) {
    if (0.0..1e15).contains(&value) && value.fract() <= 0.0 {
        push_number(out, value as u64);
    } else {
        out.extend_from_slice(value.to_string().as_bytes());
    }
}
