//! Tables of the class report: as data for the page, and as CSV with the numbers unrounded.
use crate::csv_field::push_line;
use crate::num::shown;
use crate::words::Words;
use serde_json::{Value, json};

/// A cell of a table: what is shown, and what stands in the CSV file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TableCell {
    pub shown: String,
    /// Is it finished HTML?
    pub rich: bool,
    /// Is it a number, written with a point?
    pub number: bool,
    /// Plain.
    pub raw: String,
}

impl TableCell {
    pub fn text(text: &str) -> Self {
        Self::named(text, text)
    }
    /// A text, and the name that it has in the CSV file.
    pub fn named(shown: &str, raw: &str) -> Self {
        Self { shown: shown.to_owned(), raw: raw.to_owned(), ..Self::default() }
    }
    /// A text whose HTML was made before.
    pub fn rich(shown: String, raw: &str) -> Self {
        Self { shown, rich: true, raw: raw.to_owned(), ..Self::default() }
    }
    pub fn count(n: impl ToString) -> Self {
        Self::text(&n.to_string())
    }
    /// A number as it is shown, and unrounded.
    pub fn number(shown: String, value: f64) -> Self {
        Self { shown, number: true, raw: raw(value), ..Self::default() }
    }
    /// A finite number with so many decimals.
    pub fn fixed(value: f64, decimals: usize) -> Self {
        Self::number(fixed(value, decimals), value)
    }
    /// Points, with at most two decimals.
    pub fn points(value: f64) -> Self {
        Self::number(points(value), value)
    }
    /// A share, in per cent.
    pub fn share(value: f64) -> Self {
        Self::number(percent(value), value)
    }
    /// What there is of it, else a dash.
    pub fn or_none(cell: Option<Self>) -> Self {
        cell.unwrap_or_else(|| Self::named("–", ""))
    }
}

/// A number with so many decimals and a minus sign; never `-0`.
pub fn fixed(value: f64, decimals: usize) -> String {
    shown::decimals(value, decimals).replace('-', "\u{2212}")
}

/// A share in per cent; the blank does not break.
pub fn percent(share: f64) -> String {
    format!("{}\u{a0}%", fixed(share * 100.0, 0))
}

/// Points with at most two decimals.
pub fn points(value: f64) -> String {
    shown::without_zeros(&fixed(value, 2))
}

/// Six significant figures, as scripts read them.
fn raw(value: f64) -> String {
    let rounded: f64 = shown::rounded(value, 6);
    if rounded == 0.0 { "0".to_owned() } else { rounded.to_string() }
}

/// A table. Its caption is the phrase `report.table.NAME`, the head of a column `report.column.COLUMN`.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Name of its file, without `.csv`.
    pub name: &'static str,
    /// Columns, as the CSV file names them, with blanks between.
    pub columns: &'static str,
    /// How many columns from the left hold text; the others hold numbers.
    pub texts: usize,
    /// Columns on the page; the CSV file may have more.
    pub shown: usize,
    pub rows: Vec<Vec<TableCell>>,
}

impl Table {
    /// A table that shows all its columns.
    pub fn new(
        name: &'static str,
        columns: &'static str,
        texts: usize,
        rows: impl Iterator<Item = Vec<TableCell>>,
    ) -> Self {
        Self { name, columns, texts, shown: columns.split(' ').count(), rows: rows.collect() }
    }

    /// The first rows for the page, in the words of a language: what `report-table.html` receives as `t`. `shown` are the rows here,
    /// `all` those of the file.
    pub fn view(&self, words: &Words, most: usize) -> Value {
        let cell = |cell: &TableCell| {
            let shown = if cell.number { words.number(&cell.shown) } else { cell.shown.clone() };
            json!({"shown": shown, "rich": cell.rich})
        };
        let rows = self.rows.iter().take(most);
        let rows = rows.map(|row| row.iter().take(self.shown).map(cell).collect::<Vec<_>>());
        let head = self.columns.split(' ').take(self.shown);
        let head = head.map(|name| words.get(&format!("report.column.{name}")));
        json!({
            "name": self.name,
            "caption": words.get(&format!("report.table.{}", self.name)),
            "head": head.collect::<Vec<_>>(),
            "texts": self.texts,
            "rows": rows.collect::<Vec<_>>(),
            "shown": self.rows.len().min(most),
            "all": self.rows.len(),
        })
    }

    /// The table as CSV; cells that a spreadsheet would run have an apostrophe in front.
    pub fn csv(&self) -> Vec<u8> {
        let mut out = Vec::new();
        push_line(&mut out, self.columns.split(' '));
        for row in &self.rows {
            push_line(&mut out, row.iter().map(|c| &c.raw));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_short_and_kept_long() {
        let cell = TableCell::fixed(-0.123_456_789, 2);
        assert_eq!((cell.shown.as_str(), cell.raw.as_str()), ("\u{2212}0.12", "-0.123457"));
        assert_eq!(fixed(-0.004, 2), "0.00");
        assert_eq!(
            (points(2.0), points(2.5), points(0.333)),
            ("2".to_owned(), "2.5".to_owned(), "0.33".to_owned())
        );
        assert_eq!(TableCell::share(0.615).shown, "62\u{a0}%");
    }

    #[test]
    fn a_formula_is_not_run_and_numbers_have_the_mark_of_the_language() {
        let row = || vec![TableCell::text("=HYPERLINK(1.5)"), TableCell::fixed(-1.5, 1)];
        let table = Table::new("slips", "slip answers", 1, (0..3).map(|_| row()));
        assert!(table.csv().starts_with(b"slip,answers\n'=HYPERLINK(1.5),-1.5\n"));
        let german = Words::of("de").unwrap();
        let view = table.view(&german, 2);
        let row =
            json!([{"shown": "=HYPERLINK(1.5)", "rich": false}, {"shown": "\u{2212}1,5", "rich": false}]);
        assert_eq!(view["rows"], json!([row, row]));
        assert_eq!([&view["shown"], &view["all"]], [2, 3]);
        assert_eq!(view["head"], json!(["Kürzel", "Antworten"]));
    }
}
