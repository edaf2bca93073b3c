//! The barycentric coordinates of a point in a tet as determinants, rounded, with bounds that decide most signs.

use crate::predicate::{Sign, orient3d};

/// The coordinates times the tet's volume: determinants of rounded differences to the point, and how far each may be
/// from the exact one.
///
/// A determinant of differences is rounded just as in the proof at `predicate::determinant::filter3` (the same
/// expression, its rows in an even permutation), so its bound holds here. Two of the four determinants share a cross
/// product, which is rounded once for both: the proof speaks of each determinant alone.
pub(super) struct Rounded {
    pub(super) values: [f64; 4],
    pub(super) errors: [f64; 4],
}

/// A cross product and the sums of the absolute values in each of its components.
struct Cross {
    value: [f64; 3],
    size: [f64; 3],
}

#[inline]
fn minus(x: &[f64; 3], p: &[f64; 3]) -> [f64; 3] {
    [x[0] - p[0], x[1] - p[1], x[2] - p[2]]
}

#[inline]
fn cross(q: &[f64; 3], r: &[f64; 3]) -> Cross {
    let (q1r2, q2r1) = (q[1] * r[2], q[2] * r[1]);
    let (q2r0, q0r2) = (q[2] * r[0], q[0] * r[2]);
    let (q0r1, q1r0) = (q[0] * r[1], q[1] * r[0]);
    Cross {
        value: [q1r2 - q2r1, q2r0 - q0r2, q0r1 - q1r0],
        size: [q1r2.abs() + q2r1.abs(), q2r0.abs() + q0r2.abs(), q0r1.abs() + q1r0.abs()],
    }
}

impl Cross {
    /// The determinant with first row `p`, and its error bound.
    #[inline]
    fn determinant(&self, p: &[f64; 3]) -> (f64, f64) {
        let [x, y, z] = p.map(f64::abs);
        let value = p[0] * self.value[0] + p[1] * self.value[1] + p[2] * self.value[2];
        let permanent = x * self.size[0] + y * self.size[1] + z * self.size[2];
        (value, 1e-15 * permanent + 1e-300 * (x + y + z) + 1e-300)
    }
}

impl Rounded {
    /// For a positive tet none of the exact values is negative inside.
    #[inline]
    pub(super) fn new(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Self {
        let [a, b, c, d] = tet.map(|x| minus(x, p));
        // Swapping two rows changes the sign, of the rounded numbers, too.
        let (cd, ab) = (cross(&c, &d), cross(&a, &b));
        let ((one, e1), (two, e2)) = (cd.determinant(&b), cd.determinant(&a));
        let ((three, e3), (four, e4)) = (ab.determinant(&d), ab.determinant(&c));
        Self { values: [one, -two, three, -four], errors: [e1, e2, e3, e4] }
    }
}

/// The signs of the coordinates of a point in a positive tet; `None` if one is negative, that is outside. Exact for
/// finite coordinates.
#[inline]
pub(super) fn signs(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Option<[Sign; 4]> {
    let Rounded { values, errors } = Rounded::new(tet, p);
    // Most tets are left here. False for every comparison with a NaN or an infinite bound.
    if (0..4).any(|k| values[k] < -errors[k]) {
        return None;
    }
    let mut signs = [Sign::Positive; 4];
    for (k, sign) in signs.iter_mut().enumerate() {
        let positive = values[k] > errors[k];
        if !positive {
            let mut moved = tet;
            moved[k] = p;
            let [a, b, c, d] = moved;
            *sign = orient3d(a, b, c, d);
            if sign.is_negative() {
                return None;
            }
        }
    }
    Some(signs)
}
