//! Is a point inside the circle through three points, the sphere through four?
//!
//! Two stages: a floating-point filter, then big integers.
//!
//! # Notation of the proofs
//!
//! As in `determinant`: `u = 2^-53`, `x - y = fl(x-y) * (1+d)` with `|d| <= u`, and every other operation
//! that neither overflows nor underflows has a relative error of at most `u`. [`moderate`] excludes both.

use dashu_int::IBig;

use super::Sign;
use crate::number::dyadic::common_scale;

/// For `a, b, c` turning left: `Positive` if `d` is inside their circle, `Zero` if it lies on it,
/// `Negative` outside; the opposite for `a, b, c` turning right. In general the sign of the determinant with
/// the rows `(p-d, |p-d|^2)` for `p = a, b, c`.
///
/// Exact for all finite coordinates. For NaN or infinite ones the answer is unspecified, without panic.
pub fn incircle(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2], d: &[f64; 2]) -> Sign {
    filter_circle([a, b, c].map(|p| [p[0] - d[0], p[1] - d[1]])).unwrap_or_else(|| incircle_exact(a, b, c, d))
}

/// [`incircle`] by big integers alone.
pub fn incircle_exact(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2], d: &[f64; 2]) -> Sign {
    let ([ax, ay, bx, by, cx, cy, dx, dy], _) =
        common_scale([a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]]);
    let [p, q, r] = [[ax, ay], [bx, by], [cx, cy]].map(|[x, y]| [x - &dx, y - &dy]);
    let lift = |v: &[IBig; 2]| &v[0] * &v[0] + &v[1] * &v[1];
    let minor = |v: &[IBig; 2], w: &[IBig; 2]| &v[0] * &w[1] - &v[1] * &w[0];
    (lift(&p) * minor(&q, &r) + lift(&q) * minor(&r, &p) + lift(&r) * minor(&p, &q)).cmp(&IBig::ZERO).into()
}

/// For `orient3d(a, b, c, d)` positive: `Positive` if `e` is inside the sphere through `a, b, c, d`, `Zero` if
/// it lies on it, `Negative` outside; for a negative orientation the opposite. In general minus the sign of
/// the determinant with the rows `(p-e, |p-e|^2)` for `p = a, b, c, d`.
///
/// Exact for all finite coordinates. For NaN or infinite ones the answer is unspecified, without panic.
pub fn insphere(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3], e: &[f64; 3]) -> Sign {
    let differences = [a, b, c, d].map(|p| [p[0] - e[0], p[1] - e[1], p[2] - e[2]]);
    filter_sphere(differences).unwrap_or_else(|| insphere_exact(a, b, c, d, e))
}

/// [`insphere`] by big integers alone.
pub fn insphere_exact(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3], e: &[f64; 3]) -> Sign {
    let mut flat = [0.0; 15];
    for (out, x) in flat.iter_mut().zip([a, b, c, d, e].into_iter().flatten()) {
        *out = *x;
    }
    let ([ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez], _) = common_scale(flat);
    let points = [[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]];
    let [p, q, r, s] = points.map(|[x, y, z]| [x - &ex, y - &ey, z - &ez]);
    let lift = |v: &[IBig; 3]| &v[0] * &v[0] + &v[1] * &v[1] + &v[2] * &v[2];
    let minor = |v: &[IBig; 3], w: &[IBig; 3]| &v[0] * &w[1] - &v[1] * &w[0];
    let volume = |u: &[IBig; 3], v: &[IBig; 3], w: &[IBig; 3]| {
        &u[2] * minor(v, w) + &v[2] * minor(w, u) + &w[2] * minor(u, v)
    };
    // Expanded along the last column; the sign of its last entry is plus.
    let determinant = lift(&s) * volume(&p, &q, &r) - lift(&r) * volume(&p, &q, &s)
        + lift(&q) * volume(&p, &r, &s)
        - lift(&p) * volume(&q, &r, &s);
    IBig::ZERO.cmp(&determinant).into()
}

/// All differences zero or between `2^-100` and `2^100` in absolute value?
///
/// Then no operation of the filters below overflows (degree 5, below `2^510`) or underflows: a product of
/// two such floats is zero or at least `2^-200`; each later sum or difference is a multiple of an ulp of its
/// operands, so it is zero or at least `2^-52` times the least non-zero operand. Minors of two rows are at least
/// `2^-253`, of three rows `2^-460`, multiplied by a squared length `2^-661`, and their sums `2^-800`.
fn moderate<const N: usize, const R: usize>(rows: &[[f64; N]; R]) -> bool {
    const LEAST: f64 = 1.0 / GREATEST;
    const GREATEST: f64 = (1_u128 << 100) as f64;
    rows.iter().flatten().all(|x| {
        let x = x.abs();
        (LEAST..=GREATEST).contains(&x) || Sign::of_difference(x, 0.0).is_zero() && !x.is_nan()
    })
}

/// The first stage of [`incircle`], for ROUNDED differences.
///
/// Let `D` be the wanted determinant of exact differences, `d` the computed one, `S` the exact sum of the
/// absolute values of all products of rounded differences in it, `s` its computed value. A product in `D` is the
/// one of rounded differences times four factors `1+d`; in `d` it passes through at most seven roundings
/// (square, sum of two, product of a minor, its difference, outer product, two sums). So
/// `|D - d| <= ((1+u)^4 - 1 + (1+u)^7 - 1) S <= 11.1 u S`. `s` has the same shape, `S <= (1 + 8u) s`, and the
/// computed bound is at least `(1-u) 1.5e-15 s > 13 u s`.
fn filter_circle(rows: [[f64; 2]; 3]) -> Option<Sign> {
    if !moderate(&rows) {
        return None;
    }
    let (mut determinant, mut permanent) = (0.0, 0.0);
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        let [[x, y], q, r] = [rows[i], rows[j], rows[k]];
        let lift = x * x + y * y;
        let (left, right) = (q[0] * r[1], q[1] * r[0]);
        determinant += lift * (left - right);
        permanent += lift * (left.abs() + right.abs());
    }
    decided(determinant, 1.5e-15 * permanent)
}

/// The first stage of [`insphere`], for ROUNDED differences.
///
/// As for the circle, with five factors `1+d` of the differences and at most twelve roundings (minor: product,
/// difference; volume: product, two sums; squared length: square, two sums; product; sum of four: three). So
/// `|D - d| <= ((1+u)^5 - 1 + (1+u)^12 - 1) S <= 17.1 u S`, and the computed bound is at least
/// `(1-u) 2e-15 s > 18 u s`, while `S <= (1 + 13u) s`.
fn filter_sphere(rows: [[f64; 3]; 4]) -> Option<Sign> {
    if !moderate(&rows) {
        return None;
    }
    let (mut determinant, mut permanent) = (0.0, 0.0);
    // The last column's entry of row i has the sign (-1)^(i+1): minus that determinant is wanted.
    for (i, others, sign) in
        [(0, [1, 2, 3], 1.0), (1, [0, 2, 3], -1.0), (2, [0, 1, 3], 1.0), (3, [0, 1, 2], -1.0)]
    {
        let lift = rows[i].iter().fold(0.0, |sum, x| sum + x * x);
        let [u, v, w] = others.map(|k: usize| rows[k]);
        let (mut volume, mut bound) = (0.0, 0.0);
        for (z, v, w) in [(u[2], v, w), (v[2], w, u), (w[2], u, v)] {
            let (left, right) = (v[0] * w[1], v[1] * w[0]);
            volume += z * (left - right);
            bound += z.abs() * (left.abs() + right.abs());
        }
        determinant += sign * (lift * volume);
        permanent += lift * bound;
    }
    decided(determinant, 2e-15 * permanent)
}

fn decided(value: f64, bound: f64) -> Option<Sign> {
    if value > bound {
        Some(Sign::Positive)
    } else if value < -bound {
        Some(Sign::Negative)
    } else {
        None
    }
}
