//! The barycentric coordinates of a point in a tet as determinants, rounded, with bounds that decide most signs.

use crate::predicate::{Minors, Sign, orient3d};

/// The coordinates times the tet's volume: determinants of rounded differences to the point, and how far each may be
/// from the exact one.
///
/// The determinants are those of the proof at `predicate::determinant::filter3` ([`Minors`]), so its bound holds here. Two of the four determinants share a cross
/// product, which is rounded once for both: the proof speaks of each determinant alone.
pub(super) struct Rounded {
    pub(super) values: [f64; 4],
    pub(super) errors: [f64; 4],
}

#[inline]
fn minus(x: &[f64; 3], p: &[f64; 3]) -> [f64; 3] {
    [x[0] - p[0], x[1] - p[1], x[2] - p[2]]
}

/// The coordinates on the corners `a`, `b` of a tet `a b c d` and their bounds, from differences to the point. The tet
/// `c d a b` is the same one, with the same orientation.
#[inline]
fn pair([a, b, c, d]: &[[f64; 3]; 4]) -> ([f64; 2], [f64; 2]) {
    let cd = Minors::new(*c, *d);
    let ((on_a, error_a), (on_b, error_b)) = (cd.determinant(*b), cd.determinant(*a));
    // Swapping two rows changes the sign, of the rounded numbers, too.
    ([on_a, -on_b], [error_a, error_b])
}

/// False for every comparison with a NaN or an infinite bound.
#[inline]
fn is_outside((values, errors): &([f64; 2], [f64; 2])) -> bool {
    (values[0] < -errors[0]) | (values[1] < -errors[1])
}

impl Rounded {
    /// For a positive tet none of the exact values is negative inside.
    #[inline]
    pub(super) fn new(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Self {
        let [a, b, c, d] = tet.map(|x| minus(x, p));
        Self::of(pair(&[a, b, c, d]), pair(&[c, d, a, b]))
    }

    #[inline]
    fn of((one, e1): ([f64; 2], [f64; 2]), (two, e2): ([f64; 2], [f64; 2])) -> Self {
        Self { values: [one[0], one[1], two[0], two[1]], errors: [e1[0], e1[1], e2[0], e2[1]] }
    }
}

/// The signs of the coordinates of a point in a positive tet; `None` if one is negative, that is outside. Exact for
/// finite coordinates.
#[inline]
pub(super) fn signs(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Option<[Sign; 4]> {
    // Most tets are left at one of these two places.
    let [a, b, c, d] = tet.map(|x| minus(x, p));
    let first = pair(&[a, b, c, d]);
    if is_outside(&first) {
        return None;
    }
    let second = pair(&[c, d, a, b]);
    if is_outside(&second) {
        return None;
    }
    let Rounded { values, errors } = Rounded::of(first, second);
    if (0..4).all(|k| values[k] > errors[k]) {
        return Some([Sign::Positive; 4]);
    }
    undecided(tet, p, |k| values[k] > errors[k])
}

#[cold]
#[inline(never)]
fn undecided(tet: [&[f64; 3]; 4], p: &[f64; 3], positive: impl Fn(usize) -> bool) -> Option<[Sign; 4]> {
    let mut signs = [Sign::Positive; 4];
    for (k, sign) in signs.iter_mut().enumerate() {
        if !positive(k) {
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
