//! Tables of the class report: as HTML with a caption, and as CSV with the numbers unrounded.
use crate::guard::push_text;
use crate::num::shown;
use crate::picture::svg::escaped;

/// A cell: what is shown, and what stands in the CSV file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cell {
    /// Finished HTML.
    pub shown: String,
    /// Plain.
    pub raw: String,
}

impl Cell {
    /// A text.
    pub fn text(text: &str) -> Self {
        Cell { shown: escaped(text), raw: text.to_owned() }
    }
    /// A text whose HTML was made before.
    pub fn rich(shown: String, raw: &str) -> Self {
        Cell { shown, raw: raw.to_owned() }
    }
    /// A count.
    pub fn count(n: usize) -> Self {
        Cell::text(&n.to_string())
    }
    /// A finite number with so many decimals.
    pub fn number(value: f64, decimals: usize) -> Self {
        Cell { shown: fixed(value, decimals), raw: raw(value) }
    }
    /// Points, with at most two decimals.
    pub fn points(value: f64) -> Self {
        Cell { shown: points(value), raw: raw(value) }
    }
    /// A share, in per cent.
    pub fn share(value: f64) -> Self {
        Cell { shown: percent(value), raw: raw(value) }
    }
    /// Nothing.
    pub fn none() -> Self {
        Cell { shown: "–".to_owned(), raw: String::new() }
    }
    /// What there is of it.
    pub fn or_none(cell: Option<Cell>) -> Self {
        cell.unwrap_or_else(Cell::none)
    }
}

/// A number with so many decimals and a minus sign; never `-0`.
pub fn fixed(value: f64, decimals: usize) -> String {
    shown::decimals(value, decimals).replace('-', "\u{2212}")
}

/// A share in per cent; the blank does not break.
pub fn percent(share: f64) -> String {
    format!("{}\u{a0}%", shown::per_cent(share, 0).replace('-', "\u{2212}"))
}

/// Points with at most two decimals.
pub fn points(value: f64) -> String {
    let text = fixed(value, 2);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Six significant figures, as scripts read them.
fn raw(value: f64) -> String {
    let rounded: f64 = shown::rounded(value, 6);
    if rounded == 0.0 { "0".to_owned() } else { rounded.to_string() }
}

/// A table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Name of its file, without `.csv`.
    pub name: &'static str,
    /// What it shows.
    pub caption: String,
    /// Heads of the columns as shown, and in the CSV file.
    pub head: Vec<(&'static str, &'static str)>,
    /// How many columns from the left hold text; the others hold numbers.
    pub texts: usize,
    /// Columns shown; the CSV file may have more.
    pub shown: usize,
    /// Rows.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// The table in HTML; it scrolls by itself where it is wide.
    pub fn html(&self) -> String {
        let mut out = format!(
            "<div class=\"wide\" role=\"group\" tabindex=\"0\" aria-labelledby=\"t-{name}\"><table>\n<caption id=\"t-{name}\">{}</caption>\n<thead><tr>",
            escaped(&self.caption),
            name = self.name
        );
        let class = |i: usize| if i < self.texts { "" } else { " class=\"right\"" };
        for (i, (shown, _)) in self.head.iter().enumerate().take(self.shown) {
            out.push_str(&format!("<th scope=\"col\"{}>{}</th>", class(i), escaped(shown)));
        }
        out.push_str("</tr></thead>\n<tbody>\n");
        for row in &self.rows {
            out.push_str("<tr>");
            for (i, cell) in row.iter().enumerate().take(self.shown) {
                if i == 0 && self.texts > 0 {
                    out.push_str(&format!("<th scope=\"row\">{}</th>", cell.shown));
                } else {
                    out.push_str(&format!("<td{}>{}</td>", class(i), cell.shown));
                }
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody></table></div>\n");
        out
    }

    /// The table as CSV; cells that a spreadsheet would run have an apostrophe in front.
    pub fn csv(&self) -> Vec<u8> {
        let mut out = Vec::new();
        let mut line = |fields: &mut dyn Iterator<Item = &str>| {
            for (i, field) in fields.enumerate() {
                if i > 0 {
                    out.push(b',');
                }
                push_text(&mut out, field.as_bytes());
            }
            out.push(b'\n');
        };
        line(&mut self.head.iter().map(|(_, name)| *name));
        for row in &self.rows {
            line(&mut row.iter().map(|c| c.raw.as_str()));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_short_and_kept_long() {
        assert_eq!(
            Cell::number(-0.123_456_789, 2),
            Cell { shown: "\u{2212}0.12".to_owned(), raw: "-0.123457".to_owned() }
        );
        assert_eq!(fixed(-0.004, 2), "0.00");
        assert_eq!(
            (points(2.0), points(2.5), points(0.333)),
            ("2".to_owned(), "2.5".to_owned(), "0.33".to_owned())
        );
        assert_eq!(Cell::share(0.615).shown, "62\u{a0}%");
    }

    #[test]
    fn a_formula_is_not_run() {
        let table = Table {
            name: "x",
            caption: "a < b".to_owned(),
            head: vec![("What", "what"), ("n", "n")],
            texts: 1,
            shown: 2,
            rows: vec![vec![Cell::text("=HYPERLINK(1)"), Cell::number(-1.5, 1)]],
        };
        assert_eq!(String::from_utf8(table.csv()).unwrap(), "what,n\n'=HYPERLINK(1),-1.5\n");
        assert!(
            table.html().contains("<th scope=\"row\">=HYPERLINK(1)</th><td class=\"right\">\u{2212}1.5</td>")
        );
    }
}
