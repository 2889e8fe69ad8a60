//! Single points over two axes, each with its name where there is room.
use crate::picture::frame::Frame;
use crate::picture::vector::vec2;
use crate::plot::axis::Axis;
use crate::plot::chart::{Caption, Chart};
use crate::plot::rows::WIDTH;

/// A point.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedPoint {
    /// Along the first axis.
    pub x: f64,
    /// Along the second.
    pub y: f64,
    /// Name.
    pub label: String,
    /// In the second colour.
    pub marked: bool,
}

/// A chart of points.
#[derive(Debug, Clone, PartialEq)]
pub struct ScatterChart {
    pub caption: Caption,
    /// First axis, shares in per cent.
    pub x: Axis,
    /// Second axis.
    pub y: Axis,
    /// A level of the second axis with a line, and what stands there.
    pub level: Option<(f64, String)>,
    pub spots: Vec<NamedPoint>,
}

const LEFT: f64 = 52.0;
const RIGHT: f64 = 464.0;
const TOP: f64 = 52.0;
const BOTTOM: f64 = 312.0;
const HEIGHT: f64 = 358.0;
/// About how large letters are.
const LETTER: (f64, f64) = (6.3, 13.0);

impl ScatterChart {
    /// The chart as SVG text: the same bytes for the same data.
    pub fn svg(&self) -> String {
        let mut chart = Chart::new(&self.caption, vec2(WIDTH, HEIGHT), vec2(8.0, 22.0));
        let at = |x: f64, y: f64| {
            vec2(
                LEFT + 8.0 + self.x.at(x) * (RIGHT - LEFT - 16.0),
                BOTTOM - 8.0 - self.y.at(y) * (BOTTOM - TOP - 16.0),
            )
        };
        for tick in self.x.ticks() {
            let x = LEFT + 8.0 + tick.at * (RIGHT - LEFT - 16.0);
            chart.line("grid", vec2(x, TOP), vec2(x, BOTTOM));
            chart.text("soft tiny", "middle", vec2(x, BOTTOM + 16.0), &tick.percent());
        }
        for tick in self.y.ticks() {
            let y = BOTTOM - 8.0 - tick.at * (BOTTOM - TOP - 16.0);
            chart.line("grid", vec2(LEFT, y), vec2(RIGHT, y));
            chart.text("soft tiny", "end", vec2(LEFT - 7.0, y + 4.0), &tick.signed());
        }
        chart.rect("frame", vec2(LEFT, TOP), vec2(RIGHT - LEFT, BOTTOM - TOP));
        chart.text("soft tiny", "middle", vec2((LEFT + RIGHT) / 2.0, BOTTOM + 36.0), &self.x.label);
        chart.upright("soft tiny", vec2(14.0, (TOP + BOTTOM) / 2.0), &self.y.label);
        let mut level = None;
        if let Some((value, says)) = &self.level {
            let y = at(self.x.low, *value).y;
            chart.line("mid", vec2(LEFT, y), vec2(RIGHT, y));
            chart.text("soft tiny", "start", vec2(8.0, TOP - 8.0), says);
            level = Some(Frame { low: vec2(LEFT, y - 1.0), high: vec2(RIGHT, y + 1.0) });
        }
        let mut taken: Vec<Frame> =
            self.spots.iter().map(|s| Frame::about(at(s.x, s.y), vec2(5.0, 5.0))).chain(level).collect();
        for spot in &self.spots {
            chart.circle(if spot.marked { "warn" } else { "dot" }, at(spot.x, spot.y), 5.0);
        }
        for spot in &self.spots {
            // To the right, to the left, above, below: where nothing stands yet.
            let [x, y] = at(spot.x, spot.y).into();
            let wide = spot.label.chars().count() as f64 * LETTER.0;
            let places = [
                ("start", x + 8.0, y + 4.0, x + 7.0),
                ("end", x - 8.0, y + 4.0, x - 7.0 - wide),
                ("middle", x, y - 9.0, x - wide / 2.0),
                ("middle", x, y + 17.0, x - wide / 2.0),
            ];
            // Then farther away with a line to the point.
            let far = (1..=16).flat_map(|k| {
                let dy = f64::from(k / 2 + 1) * if k % 2 == 0 { 15.0 } else { -15.0 };
                [
                    ("start", x + 22.0, y + dy + 4.0, x + 22.0),
                    ("end", x - 22.0, y + dy + 4.0, x - 22.0 - wide),
                ]
            });
            for (i, (anchor, tx, ty, from)) in places.into_iter().chain(far).enumerate() {
                let mine = Frame { low: vec2(from, ty - LETTER.1 + 3.0), high: vec2(from + wide, ty + 2.0) };
                let Frame { low, high } = mine;
                let inside = low.x > LEFT && high.x < RIGHT && low.y > TOP && high.y < BOTTOM;
                let free = taken
                    .iter()
                    .all(|o| high.x < o.low.x || low.x > o.high.x || high.y < o.low.y || low.y > o.high.y);
                if inside && free {
                    if i >= 4 {
                        let near = if anchor == "start" { tx - 2.0 } else { tx + 2.0 };
                        chart.line("frame", vec2(x, y), vec2(near, ty - 4.0));
                    }
                    chart.text("tiny halo", anchor, vec2(tx, ty), &spot.label);
                    taken.push(mine);
                    break;
                }
            }
        }
        chart.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::AxisScale;

    #[test]
    fn names_do_not_stand_on_each_other() {
        let axis = |low: f64| Axis { label: "x".to_owned(), scale: AxisScale::Linear, low, high: 1.0 };
        let spot = |x: f64| NamedPoint { x, y: 0.5, label: "1.name".to_owned(), marked: x > 0.9 };
        let chart = ScatterChart {
            caption: Caption::new("s", "t", "d"),
            x: axis(0.0),
            y: axis(-0.2),
            level: Some((0.2, "low".to_owned())),
            spots: [0.5; 9].into_iter().chain([0.1, 0.95]).map(spot).collect(),
        };
        let svg = chart.svg();
        assert_eq!(svg.matches("class=\"dot\"").count() + svg.matches("class=\"warn\"").count(), 11);
        // Those that fall together are named at the ends of lines.
        assert_eq!(svg.matches(">1.name</text>").count(), 11);
        assert_eq!(svg, chart.svg());
    }
}
