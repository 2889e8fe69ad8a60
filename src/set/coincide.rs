//! Which students have problems too much alike: equal data, or answers within tolerance of each other.
use crate::key::{Answer, ProblemKey};
use crate::set::store::Coincidence;

/// Pairs listed for one problem; a bank with few variants would fill the file with them.
pub const LISTED: usize = 1000;
/// Pairs compared for one problem before the search stops.
const COMPARED: usize = 20_000_000;

/// What one student got for one problem.
pub struct StudentVariant<'a> {
    /// Id of the student.
    pub student: &'a str,
    /// The data as printed.
    pub data: &'a [String],
    pub key: &'a ProblemKey,
}

/// Pairs of one problem, and whether there are more than are listed.
pub fn pairs(id: &str, variants: &[StudentVariant]) -> (Vec<Coincidence>, bool) {
    let mut found = Vec::new();
    let mut more = false;
    let mut tell = |what: &str, a: usize, b: usize| {
        more |= found.len() == LISTED;
        if !more {
            found.push((a.min(b), a.max(b), what.to_owned()));
        }
        !more
    };
    // Equal data: sorted, so that equals are neighbours.
    let mut order: Vec<usize> = (0..variants.len()).collect();
    order.sort_by(|a, b| variants[*a].data.cmp(variants[*b].data).then(a.cmp(b)));
    'groups: for group in order.chunk_by(|a, b| variants[*a].data == variants[*b].data) {
        for (i, a) in group.iter().enumerate() {
            for b in &group[i + 1..] {
                if !tell("equal data", *a, *b) {
                    break 'groups;
                }
            }
        }
    }
    let mut compared = 0;
    // Answers within tolerance: sorted by the part that separates best, only neighbours are compared.
    let numbers: Vec<Vec<(f64, f64)>> = variants.iter().map(|v| numbers(v.key)).collect();
    let parts = numbers.first().map_or(0, Vec::len);
    if parts > 0 && numbers.iter().all(|n| n.len() == parts) {
        let sorted = |part: usize| {
            let mut order: Vec<usize> = (0..variants.len()).collect();
            order.sort_by(|a, b| numbers[*a][part].0.total_cmp(&numbers[*b][part].0).then(a.cmp(b)));
            order
        };
        let widest = |part: usize| numbers.iter().map(|n| n[part].1).fold(0.0, f64::max);
        let candidates = |part: usize| {
            let order = sorted(part);
            let mut last = 0;
            let mut count = 0usize;
            for (i, a) in order.iter().enumerate() {
                while last + 1 < order.len()
                    && numbers[order[last + 1]][part].0 - numbers[*a][part].0 <= widest(part)
                {
                    last += 1;
                }
                count += last.saturating_sub(i);
            }
            count
        };
        let best = (0..parts).min_by_key(|p| candidates(*p)).unwrap_or(0);
        let order = sorted(best);
        let reach = widest(best);
        'all: for (i, a) in order.iter().enumerate() {
            for b in &order[i + 1..] {
                if numbers[*b][best].0 - numbers[*a][best].0 > reach {
                    break;
                }
                compared += 1;
                if compared > COMPARED {
                    break 'all;
                }
                let near = |x: &(f64, f64), y: &(f64, f64)| (x.0 - y.0).abs() <= x.1.max(y.1);
                let alike = numbers[*a].iter().zip(&numbers[*b]).all(|(x, y)| near(x, y));
                if alike
                    && variants[*a].data != variants[*b].data
                    && !tell("answers within tolerance", *a, *b)
                {
                    break 'all;
                }
            }
        }
    }
    more |= compared > COMPARED;
    found.sort();
    let pairs = found
        .into_iter()
        .map(|(a, b, what)| Coincidence {
            problem: id.to_owned(),
            what,
            students: [variants[a].student.to_owned(), variants[b].student.to_owned()],
        })
        .collect();
    (pairs, more)
}

/// Value and accepted half-width of each numeric part.
fn numbers(key: &ProblemKey) -> Vec<(f64, f64)> {
    key.parts
        .iter()
        .filter_map(|e| match e.answer {
            Answer::Number { value, half_width, .. } => Some((value, half_width)),
            Answer::Word { .. } => None,
        })
        .collect()
}
