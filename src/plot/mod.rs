//! Charts of data as SVG text: axes, ticks, lines with marks, drawn with the elements of [`crate::picture`]. No files, no
//! mechanics; numbers in, text out.
//!
//! A figure reads without colour: each series has a mark and a dash of its own. Colours are those of Okabe and Ito, which the
//! colour-blind can tell apart; light and dark follow the reader's setting by CSS. All coordinates have one decimal, so that
//! equal data give equal bytes.
pub mod axis;
pub mod chart;
pub mod lines;
pub mod rows;
pub mod scatter;
pub mod spread;

pub use axis::{Axis, AxisScale};
pub use chart::Caption;
pub use lines::{DataPoint, LineChart, Series};
pub use rows::{ChartRow, RowChart};
pub use scatter::{NamedPoint, ScatterChart};
pub use spread::SpreadChart;
