//! The common part of two convex hulls straight from the definition, for small integer coordinates.
//!
//! The solutions `(l, m) >= 0` of `sum l_i a_i = sum m_j b_j`, `sum l = sum m = 1` form a polytope whose
//! corners have linearly independent columns at their supports. All supports are tried; the common points
//! at those corners span the common part.

pub(crate) type I3 = [i64; 3];

/// Dimension of `hull(a) & hull(b)`: -1 if empty.
pub(crate) fn dimension(a: &[I3], b: &[I3]) -> i32 {
    let columns: Vec<[i128; 5]> = a
        .iter()
        .map(|p| [p[0], p[1], p[2], 1, 0])
        .chain(b.iter().map(|p| [-p[0], -p[1], -p[2], 0, 1]))
        .map(|column: [i64; 5]| column.map(i128::from))
        .collect();
    let mut corners: Vec<Vec<i128>> = Vec::new();
    for support in 1_u32..1 << columns.len() {
        if support.count_ones() > 5 {
            continue;
        }
        let chosen: Vec<usize> = (0..columns.len()).filter(|i| support >> i & 1 == 1).collect();
        let Some(solution) = solve(&chosen.iter().map(|&i| columns[i]).collect::<Vec<_>>()) else {
            continue;
        };
        if solution.iter().any(|(numerator, denominator)| numerator * denominator < 0) {
            continue;
        }
        let scale: i128 = solution.iter().map(|(_, denominator)| denominator).product();
        let mut corner = vec![0, 0, 0, scale];
        for (&i, (numerator, denominator)) in chosen.iter().zip(&solution) {
            if i < a.len() {
                for k in 0..3 {
                    corner[k] += columns[i][k] * numerator * (scale / denominator);
                }
            }
        }
        reduce(&mut corner);
        corners.push(corner);
    }
    rank(corners) - 1
}

/// The unique solution of `sum x_i columns_i = (0, 0, 0, 1, 1)` as fractions, if there is exactly one.
fn solve(columns: &[[i128; 5]]) -> Option<Vec<(i128, i128)>> {
    let n = columns.len();
    let mut rows: Vec<Vec<i128>> =
        (0..5).map(|r| columns.iter().map(|c| c[r]).chain([i128::from(r >= 3)]).collect()).collect();
    for column in 0..n {
        let pivot = (column..5).find(|&r| rows[r][column] != 0)?;
        rows.swap(column, pivot);
        eliminate(&mut rows, column, column);
    }
    let consistent = rows[n..].iter().all(|row| row[n] == 0);
    consistent.then(|| (0..n).map(|i| (rows[i][n], rows[i][i])).collect())
}

fn rank(mut rows: Vec<Vec<i128>>) -> i32 {
    let mut rank = 0;
    for column in 0..4 {
        if let Some(pivot) = (rank..rows.len()).find(|&r| rows[r][column] != 0) {
            rows.swap(rank, pivot);
            eliminate(&mut rows, rank, column);
            rank += 1;
        }
    }
    i32::try_from(rank).expect("at most four")
}

fn eliminate(rows: &mut [Vec<i128>], pivot: usize, column: usize) {
    let by = rows[pivot].clone();
    for (r, row) in rows.iter_mut().enumerate() {
        let factor = row[column];
        if r != pivot && factor != 0 {
            for (x, y) in row.iter_mut().zip(&by) {
                *x = *x * by[column] - factor * y;
            }
            reduce(row);
        }
    }
}

fn reduce(row: &mut [i128]) {
    let divisor = row.iter().fold(0, |g, x| gcd(g, x.abs()));
    if divisor > 1 {
        row.iter_mut().for_each(|x| *x /= divisor);
    }
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a } else { gcd(b, a % b) }
}
