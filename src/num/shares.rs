//! Shares of a load: how supports that can only push may carry it together.

/// Beside its row, a number below this is rounding.
const NOTHING: f64 = 1e-10;

/// A load of which no more than this share is lacking is carried.
const SHARED: f64 = 1e-9;

/// Do the columns carry a load where each takes a share of it that is not negative, those marked free of any sign? Not one with a
/// number that is none.
///
/// First phase of the simplex method, with the rule of Bland (1977), under which it ends.
pub fn carry(columns: &[(Vec<f64>, bool)], load: &[f64]) -> bool {
    let rows = load.len();
    let mirrored = columns.iter().filter(|(_, free)| *free).map(|(column, _)| (column, -1.0));
    let shares: Vec<(&Vec<f64>, f64)> = columns.iter().map(|(c, _)| (c, 1.0)).chain(mirrored).collect();
    let last = shares.len();
    let mut table: Vec<Vec<f64>> = (0..rows)
        .map(|r| {
            let way = if load[r] < 0.0 { -1.0 } else { 1.0 };
            let row = shares.iter().map(|(column, sign)| way * sign * column[r]);
            row.chain([way * load[r]]).collect()
        })
        .collect();
    if table.iter().flatten().any(|x| !x.is_finite()) {
        return false;
    }
    let most = |row: &[f64]| row.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let sizes: Vec<f64> = table.iter().map(|row| most(row)).collect();
    // What each row is made up of: a column, or what is left.
    let mut basis: Vec<Option<usize>> = vec![None; rows];
    loop {
        let left = |column: usize| -> f64 {
            let lacks = basis.iter().zip(&table).zip(&sizes).filter(|((of, _), _)| of.is_none());
            lacks.map(|((_, row), size)| if *size > 0.0 { row[column] / size } else { 0.0 }).sum()
        };
        let Some(enters) = (0..last).find(|c| !basis.contains(&Some(*c)) && left(*c) > NOTHING) else {
            break;
        };
        let ratio = |r: usize| table[r][last] / table[r][enters];
        let may = (0..rows).filter(|r| table[*r][enters] > NOTHING * sizes[*r]);
        let order = |r: usize| basis[r].unwrap_or(last + r);
        let leaves = may.min_by(|a, b| ratio(*a).total_cmp(&ratio(*b)).then(order(*a).cmp(&order(*b))));
        let Some(leaves) = leaves else { break };
        let pivot: Vec<f64> = table[leaves].iter().map(|x| x / table[leaves][enters]).collect();
        for (r, row) in table.iter_mut().enumerate() {
            let by = row[enters];
            let less = |(x, p): (&f64, &f64)| x - by * p;
            *row = if r == leaves { pivot.clone() } else { row.iter().zip(&pivot).map(less).collect() };
        }
        basis[leaves] = Some(enters);
    }
    let left = basis.iter().zip(&table).filter(|(of, _)| of.is_none()).map(|(_, row)| row[last].abs());
    left.sum::<f64>() <= SHARED * load.iter().map(|x| x.abs()).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::carry;

    /// A plank with its weight at x on feet at these places: force and moment.
    fn plank(feet: &[f64], weight: f64, x: f64) -> bool {
        let columns: Vec<(Vec<f64>, bool)> = feet.iter().map(|foot| (vec![1.0, *foot], false)).collect();
        carry(&columns, &[weight, weight * x])
    }

    #[test]
    fn feet_carry_what_lies_between_them() {
        let feet = [-0.5, 0.1, 0.5];
        for x in [-0.5, -0.3, 0.0, 0.1, 0.25, 0.5] {
            assert!(plank(&feet, 40.0, x), "{x}");
        }
        for x in [-0.6, 0.51, 2.0] {
            assert!(!plank(&feet, 40.0, x), "{x}");
        }
        // What pulls up is carried by no foot; a screw carries it.
        assert!(!plank(&feet, -40.0, 0.0));
        let screw: Vec<_> = feet.iter().map(|foot| (vec![1.0, *foot], true)).collect();
        assert!(carry(&screw, &[-40.0, -90.0]));
        assert!(!carry(&screw, &[f64::NAN, 0.0]));
        assert!(carry(&[], &[0.0, 0.0]));
    }
}
