//! Pictures of data as SVG text: axes, ticks, lines with marks. No files, no mechanics; numbers in, text out.
//!
//! A figure reads without colour: each series has a mark and a dash of its own. Colours are those of Okabe and Ito, which the
//! colour-blind can tell apart; light and dark follow the reader's setting by CSS. All coordinates have one decimal, so that
//! equal data give equal bytes.
pub mod axis;
pub mod lines;
pub mod rows;
pub mod scatter;
pub mod spread;
pub mod svg;

pub use axis::Axis;
pub use axis::Scale;
pub use lines::Figure;
pub use lines::Point;
pub use lines::Series;
pub use rows::Row;
pub use rows::Rows;
pub use scatter::Scatter;
pub use scatter::Spot;
pub use spread::Spread;
