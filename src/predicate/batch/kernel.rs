//! The filter on blocks of lanes: the same operations as `determinant::filter3` in the same order, so that a lane's answer is
//! that of one call, whatever the width of the registers (no contraction into fused operations takes place).

/// Inputs a block: two registers of the widest kind.
pub(crate) const LANES: usize = 16;

/// One number for each input of a block.
pub(crate) type Lane = [f64; LANES];

/// A row of the matrix: a difference of two points, by axis.
pub(crate) type Row = [Lane; 3];

/// The zero block.
pub(crate) const ZERO: Row = [[0.0; LANES]; 3];

/// The points of a block of inputs.
#[inline(always)]
pub(crate) fn gather<const N: usize>(vertices: &[[f64; 3]], inputs: &[[u32; N]]) -> [Row; N] {
    if let Some(points) = gather_fours(vertices.as_flattened(), inputs) {
        return points;
    }
    let mut out = [ZERO; N];
    for (l, ids) in inputs.iter().enumerate().take(LANES) {
        for (row, id) in out.iter_mut().zip(ids) {
            let point = &vertices[*id as usize];
            for axis in 0..3 {
                row[axis][l] = point[axis];
            }
        }
    }
    out
}

/// The same with one load of four numbers for a point, the first of the next point among them, as in [`differences`].
#[inline(always)]
fn gather_fours<const N: usize>(flat: &[f64], inputs: &[[u32; N]]) -> Option<[Row; N]> {
    let mut by_input = [[[0.0; 4]; LANES]; N];
    for (l, ids) in inputs.iter().enumerate().take(LANES) {
        for (points, id) in by_input.iter_mut().zip(ids) {
            let start = 3 * *id as usize;
            points[l] = *flat.get(start..start + 4)?.first_chunk()?;
        }
    }
    let mut out = [ZERO; N];
    for (row, points) in out.iter_mut().zip(&by_input) {
        for (l, point) in points.iter().enumerate() {
            for axis in 0..3 {
                row[axis][l] = point[axis];
            }
        }
    }
    Some(out)
}

/// The signs of a block of inputs that are indices of vertices; row `k` of the matrix is vertex `j` minus vertex `i` of the input,
/// `(i, j) = rows[k]`.
#[inline(always)]
pub(crate) fn filter3_indexed<const N: usize>(
    vertices: &[[f64; 3]],
    inputs: &[[u32; N]],
    rows: [(usize, usize); 3],
) -> [i8; LANES] {
    let flat = vertices.as_flattened();
    let (left, right) = inputs.split_at(HALF);
    // Half a block has its nine rows in registers.
    let mut out = [0; LANES];
    if let (Some([p, q, r]), Some([s, t, u])) =
        (differences(flat, left, rows), differences(flat, right, rows))
    {
        out[..HALF].copy_from_slice(&filter3::<HALF>(&p, &q, &r));
        out[HALF..].copy_from_slice(&filter3::<HALF>(&s, &t, &u));
        return out;
    }
    let points = gather(vertices, inputs);
    let [p, q, r] = rows.map(|(i, j)| minus(&points[j], &points[i]));
    filter3(&p, &q, &r)
}

const HALF: usize = LANES / 2;

/// The rows of half a block. Four numbers are read for a point and subtracted at once, the first of the next point among them:
/// so there are four loads an input in place of twelve, and the compiler transposes in registers. `None` if an input has the last
/// vertex, after which there is no number.
#[inline(always)]
fn differences<const N: usize>(
    flat: &[f64],
    inputs: &[[u32; N]],
    rows: [(usize, usize); 3],
) -> Option<[[[f64; HALF]; 3]; 3]> {
    let mut by_input = [[[0.0; 4]; HALF]; 3];
    for (l, ids) in inputs.iter().enumerate().take(HALF) {
        let mut points = [[0.0; 4]; N];
        for (point, id) in points.iter_mut().zip(ids) {
            let start = 3 * *id as usize;
            *point = *flat.get(start..start + 4)?.first_chunk()?;
        }
        for (out, (i, j)) in by_input.iter_mut().zip(rows) {
            for axis in 0..4 {
                out[l][axis] = points[j][axis] - points[i][axis];
            }
        }
    }
    let mut out = [[[0.0; HALF]; 3]; 3];
    for (out, by_input) in out.iter_mut().zip(by_input) {
        for (l, row) in by_input.iter().enumerate() {
            for axis in 0..3 {
                out[axis][l] = row[axis];
            }
        }
    }
    Some(out)
}

/// The sign of `det[p, q, r]` as 1 or -1 where the filter decides, 0 where it does not. Rows are ROUNDED differences; the bound
/// is proved at `determinant::filter3`.
#[inline(always)]
pub(crate) fn filter3<const L: usize>(p: &[[f64; L]; 3], q: &[[f64; L]; 3], r: &[[f64; L]; 3]) -> [i8; L] {
    let mut out = [0; L];
    for l in 0..L {
        let (q1r2, q2r1) = (q[1][l] * r[2][l], q[2][l] * r[1][l]);
        let (q2r0, q0r2) = (q[2][l] * r[0][l], q[0][l] * r[2][l]);
        let (q0r1, q1r0) = (q[0][l] * r[1][l], q[1][l] * r[0][l]);
        let (x, y, z) = (p[0][l].abs(), p[1][l].abs(), p[2][l].abs());
        let determinant = p[0][l] * (q1r2 - q2r1) + p[1][l] * (q2r0 - q0r2) + p[2][l] * (q0r1 - q1r0);
        let permanent =
            x * (q1r2.abs() + q2r1.abs()) + y * (q2r0.abs() + q0r2.abs()) + z * (q0r1.abs() + q1r0.abs());
        let err = 1e-15 * permanent + 1e-300 * (x + y + z) + 1e-300;
        out[l] = i8::from(determinant > err) - i8::from(determinant < -err);
    }
    out
}

/// `to - from`, rounded, lane by lane.
#[inline(always)]
pub(crate) fn minus(to: &Row, from: &Row) -> Row {
    let mut out = ZERO;
    for ((out, to), from) in out.iter_mut().zip(to).zip(from) {
        for l in 0..LANES {
            out[l] = to[l] - from[l];
        }
    }
    out
}

/// `q x r`, rounded, as in `det[p, q, r] = p . (q x r)`.
#[inline(always)]
pub(crate) fn cross(q: &Row, r: &Row) -> Row {
    let mut out = ZERO;
    for l in 0..LANES {
        out[0][l] = q[1][l] * r[2][l] - q[2][l] * r[1][l];
        out[1][l] = q[2][l] * r[0][l] - q[0][l] * r[2][l];
        out[2][l] = q[0][l] * r[1][l] - q[1][l] * r[0][l];
    }
    out
}

/// A bound on the error of every determinant of differences of some points, once for all of them.
///
/// # The bound
///
/// Let `X` be the rounded difference of the largest and the smallest coordinate of the points along the first axis, `Y` and `Z`
/// likewise. Rounding is monotone, so every rounded difference of two of the points is at most `X`, `Y`, `Z` in absolute value.
/// In the notation of `determinant::filter3`: `S <= 6 X Y Z` and `L <= X + Y + Z`, and step 3 there gives
/// `|D - d| <= 8.001 u S + V <= 48.006 u XYZ + (1+u)^4 (2^-1074 (X + Y + Z) + 3 * 2^-1075)`.
/// The computed `6e-15 * (X * Y * Z) + 1e-300 * (X + Y + Z) + 1e-300` loses five roundings at most, and by underflow at most
/// `2^-1075 (Z + 2)`; as `6e-15 > 54 u`, `54 (1-u)^5 > 49`, and `1e-300 > 2^-1000`, it is at least `|D - d|`.
///
/// Overflow: `d` is only trusted where `X`, `Y`, `Z` are below `1e100`; then nothing in it exceeds `6e300`. Elsewhere the bound is
/// infinite. A coordinate that is no number may be passed over here: then every `d` with its point is none.
#[inline(always)]
pub(crate) fn common_error(points: &[&Row; 6]) -> Lane {
    let mut size = ZERO;
    for (axis, size) in size.iter_mut().enumerate() {
        for (l, size) in size.iter_mut().enumerate() {
            let (mut low, mut high) = (points[0][axis][l], points[0][axis][l]);
            for point in &points[1..] {
                let x = point[axis][l];
                low = if x < low { x } else { low };
                high = if x > high { x } else { high };
            }
            *size = high - low;
        }
    }
    let mut out = [0.0; LANES];
    for l in 0..LANES {
        let (x, y, z) = (size[0][l], size[1][l], size[2][l]);
        let err = 6e-15 * (x * y * z) + 1e-300 * (x + y + z) + 1e-300;
        let is_small = (x < 1e100) & (y < 1e100) & (z < 1e100);
        out[l] = if is_small { err } else { f64::INFINITY };
    }
    out
}

/// The least of some determinants in every lane, and their sum.
pub(crate) struct Least {
    least: Lane,
    sum: Lane,
}

impl Least {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { least: [f64::INFINITY; LANES], sum: [0.0; LANES] }
    }

    /// Adds `p . n`, rounded.
    #[inline(always)]
    pub(crate) fn add(&mut self, p: &Row, n: &Row) {
        for l in 0..LANES {
            let value = p[0][l] * n[0][l] + p[1][l] * n[1][l] + p[2][l] * n[2][l];
            self.least[l] = if value < self.least[l] { value } else { self.least[l] };
            self.sum[l] += value;
        }
    }

    /// Whether all determinants are above the error. A value that is no number is not among the least, but makes the sum none.
    #[inline(always)]
    pub(crate) fn above(&self, error: &Lane) -> [bool; LANES] {
        let mut out = [false; LANES];
        for l in 0..LANES {
            out[l] = (self.least[l] > error[l]) & !self.sum[l].is_nan();
        }
        out
    }
}
