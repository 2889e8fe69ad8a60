//! Axes: where a value stands, and which ticks are drawn.
use crate::num::{shown, trig};

/// How values are spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisScale {
    /// Evenly.
    Linear,
    /// By powers of ten; values must be > 0.
    Log,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What it measures, with the unit.
    pub label: String,
    pub scale: AxisScale,
    /// Least value shown.
    pub low: f64,
    /// Greatest value shown.
    pub high: f64,
}

/// A tick: place as a share of the axis, and its label, empty for a small one.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// From 0 to 1.
    pub at: f64,
    /// `10^{-3}`, `0.25`, or nothing.
    pub label: String,
}

impl Tick {
    /// Its label with a true minus sign.
    pub fn signed(&self) -> String {
        self.label.replace('-', "\u{2212}")
    }

    /// Its label as per cent, if it is a number.
    pub fn percent(&self) -> String {
        let number = self.label.parse::<f64>();
        number.map_or_else(|_| self.label.clone(), |share| format!("{} %", shown::per_cent(share, 0)))
    }
}

/// Most labelled ticks on an axis.
const MOST_LABELS: i32 = 9;

fn power_of_ten(e: i32) -> f64 {
    let mut p = 1.0;
    for _ in 0..e.abs() {
        p *= 10.0;
    }
    if e < 0 { 1.0 / p } else { p }
}

fn whole(x: f64) -> i32 {
    // Exponents of doubles are small.
    x as i32
}

impl Axis {
    /// An axis that holds these values, widened to whole powers of ten or to round numbers. Values that are not finite, or not
    /// above 0 on a log axis, are passed over; with none left the axis goes from 0.1 to 1.
    pub fn around(label: &str, scale: AxisScale, values: impl Iterator<Item = f64>) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for v in values.filter(|v| v.is_finite() && (scale == AxisScale::Linear || *v > 0.0)) {
            low = low.min(v);
            high = high.max(v);
        }
        if low > high {
            (low, high) = (0.1, 1.0);
        }
        match scale {
            AxisScale::Log => {
                let (a, mut b) = (whole(trig::log10(low).floor()), whole(trig::log10(high).ceil()));
                if a == b {
                    b += 1;
                }
                (low, high) = (power_of_ten(a), power_of_ten(b));
            }
            AxisScale::Linear => {
                // Ends on ticks; a wider axis may take wider steps.
                for _ in 0..3 {
                    let step = step(high - low);
                    (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
                }
                if high <= low {
                    high = low + 1.0;
                }
            }
        }
        Self { label: label.to_owned(), scale, low, high }
    }

    /// Place of a value as a share of the axis; what lies outside is drawn at its end.
    pub fn at(&self, value: f64) -> f64 {
        let share = match self.scale {
            AxisScale::Linear => (value - self.low) / (self.high - self.low),
            AxisScale::Log => {
                let (a, b) = (trig::log10(self.low), trig::log10(self.high));
                (trig::log10(value.max(self.low)) - a) / (b - a)
            }
        };
        share.clamp(0.0, 1.0)
    }

    /// Ticks from low to high.
    pub fn ticks(&self) -> Vec<Tick> {
        let mut ticks = Vec::new();
        match self.scale {
            AxisScale::Log => {
                let (a, b) = (whole(trig::log10(self.low).round()), whole(trig::log10(self.high).round()));
                let every = ((b - a) + MOST_LABELS - 1) / MOST_LABELS;
                for e in a..=b {
                    let value = power_of_ten(e);
                    let labelled = (b - e) % every.max(1) == 0;
                    let label = match e {
                        _ if !labelled => String::new(),
                        0 => "1".to_owned(),
                        1 => "10".to_owned(),
                        e => format!("10^{{{e}}}").replace('-', "\u{2212}"),
                    };
                    ticks.push(Tick { at: self.at(value), label });
                    if e < b && b - a <= 4 {
                        for m in 2..10 {
                            ticks.push(Tick { at: self.at(value * f64::from(m)), label: String::new() });
                        }
                    }
                }
            }
            AxisScale::Linear => {
                let step = step(self.high - self.low);
                let decimals = (0..9).find(|d| {
                    let scaled = step * power_of_ten(*d);
                    (scaled - scaled.round()).abs() < 1e-6
                });
                let decimals = usize::try_from(decimals.unwrap_or(9)).unwrap_or(0);
                // An axis that does not begin or end on a tick has none beyond its ends.
                let first = (self.low / step - 1e-6).ceil() * step;
                let count = whole(((self.high - first) / step + 1e-6).floor());
                for value in (0..=count).map(|i| first + f64::from(i) * step) {
                    ticks.push(Tick { at: self.at(value), label: shown::decimals(value, decimals) });
                }
            }
        }
        ticks
    }
}

/// A round step that cuts a width into 4 to 10 parts.
fn step(width: f64) -> f64 {
    if !(width > 0.0 && width.is_finite()) {
        return 1.0;
    }
    let unit = power_of_ten(whole(trig::log10(width / 4.0).floor()));
    [5.0, 2.0, 1.0].into_iter().map(|m| m * unit).find(|s| width / s >= 4.0).unwrap_or(unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log_axes_take_whole_decades() {
        let axis = Axis::around("x", AxisScale::Log, [3e-5, f64::NAN, 0.0, 20.0].into_iter());
        assert!((axis.low - 1e-5).abs() < 1e-18 && (axis.high - 100.0).abs() < 1e-9, "{axis:?}");
        let labels: Vec<String> = axis.ticks().into_iter().map(|t| t.label).collect();
        assert_eq!(labels.first().map(String::as_str), Some("10^{\u{2212}5}"));
        assert_eq!(labels.last().map(String::as_str), Some("10^{2}"));
        assert!(axis.at(1e-5).abs() < 1e-12 && (axis.at(100.0) - 1.0).abs() < 1e-12);
        assert!(axis.at(0.0).abs() < 1e-12 && (axis.at(1e9) - 1.0).abs() < 1e-12);
        // Many decades: not every one has a label, the ends do.
        let wide = Axis::around("x", AxisScale::Log, [1e-17, 1.0].into_iter());
        assert!(wide.ticks().iter().filter(|t| !t.label.is_empty()).count() <= 10);
    }
    #[test]
    fn linear_axes_take_round_numbers() {
        let axis = Axis::around("x", AxisScale::Linear, [0.13, 0.87].into_iter());
        let labels: Vec<String> = axis.ticks().into_iter().map(|t| t.label).collect();
        assert_eq!(labels, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        let odd = Axis { label: String::new(), scale: AxisScale::Linear, low: -0.5, high: 14.5 };
        let labels: Vec<String> = odd.ticks().into_iter().map(|t| t.label).collect();
        assert_eq!(labels, ["0", "2", "4", "6", "8", "10", "12", "14"]);
        let one = Axis::around("x", AxisScale::Linear, [2.0].into_iter());
        assert!(one.high > one.low);
        let none = Axis::around("x", AxisScale::Log, std::iter::empty());
        assert!(none.high > none.low);
    }
}
