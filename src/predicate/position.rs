//! Where a point lies in a segment, triangle or tet: closed, exact, degenerate simplices included.

use std::cmp::Ordering;

use super::{Sign, collinear, orient2d, orient3d, projection_axis};

/// Which faces of a simplex hold a point of it: bit `i` is set when the point lies in the closed face
/// opposite corner `i`.
///
/// For a simplex of full dimension these are the zeros of the barycentric coordinates, and an empty mask
/// means the interior.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ZeroMask(pub u8);

impl ZeroMask {
    /// On no face at all?
    #[inline]
    pub const fn is_interior(self) -> bool {
        self.0 == 0
    }

    /// In the closed face opposite corner `i`?
    #[inline]
    pub const fn on_face(self, i: u8) -> bool {
        i < 8 && (self.0 >> i) & 1 == 1
    }

    /// The mask with bit `i` set where `bits[i]`.
    fn from_bits<const N: usize>(bits: [bool; N]) -> Self {
        Self(bits.iter().rev().fold(0, |mask, &bit| mask << 1 | u8::from(bit)))
    }

    /// As a point of a degenerate simplex, which is the union of its faces: outside if on none.
    fn if_any(self) -> Option<Self> {
        if self.0 == 0 { None } else { Some(self) }
    }
}

/// Do the two points coincide? (`-0.0` and `0.0` are one number.)
#[inline]
pub fn same_point(a: &[f64; 3], b: &[f64; 3]) -> bool {
    lexicographic(a, b).is_eq()
}

/// Lexicographic order of coordinates, the order along any oriented line.
#[inline]
pub(super) fn lexicographic(a: &[f64; 3], b: &[f64; 3]) -> Ordering {
    a.iter()
        .zip(b)
        .map(|(x, y)| Ordering::from(Sign::of_difference(*x, *y)))
        .find(|order| order.is_ne())
        .unwrap_or(Ordering::Equal)
}

/// The two ends of the hull of three COLLINEAR points.
pub(super) fn ends(points: [&[f64; 3]; 3]) -> [&[f64; 3]; 2] {
    let [first, second, third] = points;
    [second, third].into_iter().fold([first, first], |[low, high], p| {
        [
            if lexicographic(p, low).is_lt() { p } else { low },
            if lexicographic(p, high).is_gt() { p } else { high },
        ]
    })
}

/// Does `p` lie on the closed segment from `a` to `b` (which may be a single point)?
pub fn point_on_segment(p: &[f64; 3], [a, b]: [&[f64; 3]; 2]) -> bool {
    // On the line through two different points, "between" holds for the points exactly when it holds for
    // each coordinate that varies; the coordinates that do not vary are equal on the whole line.
    let between = a.iter().zip(b).zip(p).all(|((&x, &y), &z)| {
        let (left, right) = (Sign::of_difference(z, x), Sign::of_difference(y, z));
        left == right || left.is_zero() || right.is_zero()
    });
    between && collinear(a, b, p)
}

/// Where `p` lies in the closed triangle `(a, b, c)` in space: `None` if it does not lie in it (not even
/// in its plane), else the mask of the edges that hold it.
///
/// A triangle of zero area is the union of its edges.
pub fn point_in_triangle(p: &[f64; 3], [a, b, c]: [&[f64; 3]; 3]) -> Option<ZeroMask> {
    let Some(axis) = projection_axis(a, b, c) else {
        let edges = [[b, c], [c, a], [a, b]];
        return ZeroMask::from_bits(edges.map(|edge| point_on_segment(p, edge))).if_any();
    };
    if !orient3d(a, b, c, p).is_zero() {
        return None;
    }
    let whole = orient2d(a, b, c, axis);
    zeros([[p, b, c], [a, p, c], [a, b, p]].map(|[a, b, c]| orient2d(a, b, c, axis) * whole))
}

/// Where `p` lies in the closed tet `(a, b, c, d)`, of any orientation: `None` if outside, else the mask
/// of the faces that hold it.
///
/// A tet of zero volume is the union of its faces.
pub fn point_in_tet(p: &[f64; 3], [a, b, c, d]: [&[f64; 3]; 4]) -> Option<ZeroMask> {
    let whole = orient3d(a, b, c, d);
    if whole.is_zero() {
        let faces = [[b, c, d], [a, c, d], [a, b, d], [a, b, c]];
        return ZeroMask::from_bits(faces.map(|face| point_in_triangle(p, face).is_some())).if_any();
    }
    let tets = [[p, b, c, d], [a, p, c, d], [a, b, p, d], [a, b, c, p]];
    zeros(tets.map(|[a, b, c, d]| orient3d(a, b, c, d) * whole))
}

/// The mask of zeros among the signs of barycentric coordinates; `None` if one is negative.
fn zeros<const N: usize>(signs: [Sign; N]) -> Option<ZeroMask> {
    if signs.iter().any(|sign| sign.is_negative()) {
        return None;
    }
    Some(ZeroMask::from_bits(signs.map(Sign::is_zero)))
}
