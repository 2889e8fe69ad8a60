//! Texts as a terminal shows them: tables, counts and shares.
use crate::num::shown;

/// A table with columns as wide as they need; the first column to the left, the others to the right unless `left` says so.
pub fn table(rows: &[Vec<String>], left: &[usize]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |c: usize| rows.iter().filter_map(|r| r.get(c)).map(|t| wide(t)).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (c, cell) in row.iter().enumerate() {
            if c > 0 {
                line.push_str("  ");
            }
            let pad = widths[c].saturating_sub(wide(cell));
            if left.contains(&c) {
                line.push_str(cell);
                line.extend(std::iter::repeat_n(' ', pad));
            } else {
                line.extend(std::iter::repeat_n(' ', pad));
                line.push_str(cell);
            }
        }
        text.push_str("  ");
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// The first row of a table, from names with ` | ` between them.
pub fn head(names: &str) -> Vec<String> {
    names.split(" | ").map(str::to_owned).collect()
}

/// A share in whole per cent: `40 %`.
pub fn percent(share: f64) -> String {
    format!("{} %", shown::decimals(share * 100.0, 0))
}

/// The first so many of a list, and behind them how many more there are: `and 3 more`.
pub fn first_of(list: impl IntoIterator<Item = String>, most: usize) -> Vec<String> {
    let mut list: Vec<String> = list.into_iter().collect();
    if list.len() > most {
        let more = list.split_off(most).len();
        list.push(format!("and {more} more"));
    }
    list
}

/// `1 sheet`, `2 sheets`
pub fn count(n: impl TryInto<u64>, one: &str) -> String {
    let n = n.try_into().unwrap_or(u64::MAX);
    if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") }
}

/// Columns that a text takes on a terminal: Chinese, Japanese and Korean signs take two.
fn wide(text: &str) -> usize {
    let two = |c: &char| matches!(u32::from(*c), 0x1100..=0x115F | 0x2E80..=0xA4CF | 0xAC00..=0xD7A3 | 0xF900..=0xFAFF | 0xFE30..=0xFE6F | 0xFF00..=0xFF60);
    text.chars().count() + text.chars().filter(two).count()
}
