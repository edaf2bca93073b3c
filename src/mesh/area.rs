//! Whether a triangle has exactly zero area.

use dashu_int::IBig;

/// Whether the three points lie on one line (or coincide), exactly. All coordinates must be finite
/// (else the answer is `true`: such points span no triangle).
///
/// A triangle has zero area exactly when the cross product of two of its sides is the zero vector.
/// A float filter answers when one component is certainly not zero; integers decide the rest.
#[must_use]
pub fn is_zero_area([a, b, c]: [&[f64; 3]; 3]) -> bool {
    const PLANES: [(usize, usize); 3] = [(0, 1), (1, 2), (2, 0)];
    if PLANES.iter().any(|&(i, j)| surely_nonzero(at(a, b, i, j), at(a, c, i, j))) {
        return false;
    }
    let Some([x, y, z]) = scaled_axes([a, b, c]) else {
        return true;
    };
    let zero = |p: &[IBig; 2], q: &[IBig; 2]| &p[0] * &q[1] == &q[0] * &p[1];
    zero(&x, &y) && zero(&y, &z) && zero(&z, &x)
}

/// The difference `q - p` in two axes, rounded.
fn at(p: &[f64; 3], q: &[f64; 3], i: usize, j: usize) -> [f64; 2] {
    [q[i] - p[i], q[j] - p[j]]
}

/// Whether `d0 * e1 - d1 * e0` is not zero for the exact differences that `d` and `e` round.
///
/// Bound, with `u = 2^-53`. A rounded difference is `d = D (1 + t)`, `|t| <= u`: sums of `f64` do
/// not lose by underflow. A rounded product is `l = d e (1 + t) + s` with `|s| <= 2^-1075`. So for
/// the exact product `L`: `|L - l| <= (3u + 8u^2) |l| + 2^-1073`, likewise for `r`, and rounding
/// `l - r` adds at most `u (|l| + |r|)`. Together `|exact - (l - r)| < 5u (|l| + |r|) + 2^-1071`.
/// The test below uses `8u (|l| + |r|) + 2^-1000`; its own rounding loses a factor of at most
/// `(1 - u)^3` and, by underflow, `2^-1075`. If anything overflows, the right side is infinite or
/// a side is NaN, and the answer is `false`.
fn surely_nonzero(d: [f64; 2], e: [f64; 2]) -> bool {
    /// `8u = 2^-50`.
    const RELATIVE: f64 = 1.0 / (1u64 << 50) as f64;
    /// `2^-1000`.
    const ABSOLUTE: f64 = f64::from_bits(23 << 52);
    let l = d[0] * e[1];
    let r = d[1] * e[0];
    (l - r).abs() > RELATIVE * (l.abs() + r.abs()) + ABSOLUTE
}

/// For each axis the exact differences `b - a` and `c - a`, times a power of two of that axis
/// (which does not change where the cross product is zero). `None` if a coordinate is not finite.
fn scaled_axes(points: [&[f64; 3]; 3]) -> Option<[[IBig; 2]; 3]> {
    let axis = |k: usize| {
        let parts = [decode(points[0][k])?, decode(points[1][k])?, decode(points[2][k])?];
        let least = parts.iter().filter(|p| p.0 != 0).map(|p| p.1).min().unwrap_or(0);
        // A zero may have any exponent; shifting it by 0 keeps it zero.
        let [a, b, c] = parts.map(|(m, e)| IBig::from(m) << usize::from(e.saturating_sub(least)));
        Some([b - &a, c - &a])
    };
    Some([axis(0)?, axis(1)?, axis(2)?])
}

/// A finite `x` as `(m, e)` with `x = m 2^(e - 1075)`.
fn decode(x: f64) -> Option<(i64, u16)> {
    if !x.is_finite() {
        return None;
    }
    let bits = x.to_bits();
    let exponent = u16::try_from((bits >> 52) & 0x7ff).ok()?;
    let fraction = i64::try_from(bits & ((1 << 52) - 1)).ok()?;
    let magnitude = if exponent == 0 { fraction } else { fraction | (1 << 52) };
    Some((if x.is_sign_negative() { -magnitude } else { magnitude }, exponent.max(1)))
}
