//! Orientation signs of points and of vectors between points.

use super::determinant::{Integers, Minors, Rows, filter2, filter3};
use super::{Sign, Stage, word};

/// Rows of [`orient3d`] over the points `a, b, c, d`.
const TET: Rows<3> = [(0, 1), (0, 2), (0, 3)];
/// Rows of [`dot_sign`] over the points `a, b, c, s, t`.
const DOT: Rows<3> = [(0, 1), (0, 2), (3, 4)];
/// Rows of [`det_sign`] over the ends of three vectors.
const VECTORS: Rows<3> = [(0, 1), (2, 3), (4, 5)];
/// Rows of [`orient2d`] over the points `a, b, c`.
const TRIANGLE: Rows<2> = [(0, 1), (0, 2)];

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Coordinate 0.
    X,
    /// Coordinate 1.
    Y,
    /// Coordinate 2.
    Z,
}

impl Axis {
    /// All three, in order.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// The other two coordinates of `p` in cyclic order, so that the basis stays right-handed.
    #[inline]
    pub const fn others(self, p: &[f64; 3]) -> [f64; 2] {
        match self {
            Self::X => [p[1], p[2]],
            Self::Y => [p[2], p[0]],
            Self::Z => [p[0], p[1]],
        }
    }

    /// This coordinate of `p`.
    #[inline]
    pub const fn of(self, p: &[f64; 3]) -> f64 {
        match self {
            Self::X => p[0],
            Self::Y => p[1],
            Self::Z => p[2],
        }
    }
}

#[inline]
fn minus(to: &[f64; 3], from: &[f64; 3]) -> [f64; 3] {
    [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

#[inline]
fn by_axis<const N: usize>(points: [&[f64; 3]; N]) -> [[f64; N]; 3] {
    let mut out = [[0.0; N]; 3];
    for (i, point) in points.into_iter().enumerate() {
        for (axis, x) in out.iter_mut().zip(point) {
            axis[i] = *x;
        }
    }
    out
}

/// The sign of `det[b-a, c-a, d-a]`, six times the signed volume of the tet `(a, b, c, d)`;
/// [`Sign::Positive`] for `(0, e1, e2, e3)`.
///
/// Exact for all finite coordinates. For NaN or infinite ones the answer is unspecified, without panic.
#[inline]
pub fn orient3d(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3]) -> Sign {
    orient3d_staged(a, b, c, d).0
}

/// [`orient3d`] with the stage that decided.
#[inline]
pub fn orient3d_staged(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3]) -> (Sign, Stage) {
    match filter3(minus(b, a), minus(c, a), minus(d, a)) {
        Some(sign) => (sign, Stage::Filter),
        None => unfiltered3([a, b, c, d], TET),
    }
}

/// [`orient3d`] by big integers alone.
pub fn orient3d_exact(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3]) -> Sign {
    Integers::new(by_axis([a, b, c, d])).sign_big(TET)
}

/// The sign of `cross(b-a, c-a) . (t-s)`: does the direction from `s` to `t` leave the plane of the
/// triangle `(a, b, c)` on its positive side?
///
/// Exact for all finite coordinates. For NaN or infinite ones the answer is unspecified, without panic.
#[inline]
pub fn dot_sign(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], s: &[f64; 3], t: &[f64; 3]) -> Sign {
    dot_sign_staged(a, b, c, s, t).0
}

/// [`dot_sign`] with the stage that decided.
#[inline]
pub fn dot_sign_staged(
    a: &[f64; 3],
    b: &[f64; 3],
    c: &[f64; 3],
    s: &[f64; 3],
    t: &[f64; 3],
) -> (Sign, Stage) {
    // cross(v, w) . x = det[v, w, x].
    match filter3(minus(b, a), minus(c, a), minus(t, s)) {
        Some(sign) => (sign, Stage::Filter),
        None => unfiltered3([a, b, c, s, t], DOT),
    }
}

/// [`dot_sign`] by big integers alone.
pub fn dot_sign_exact(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], s: &[f64; 3], t: &[f64; 3]) -> Sign {
    Integers::new(by_axis([a, b, c, s, t])).sign_big(DOT)
}

/// A triangle whose plane many signs are about: what the filters of all of them have in common. The corners are
/// handed in again where a filter does not decide.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane(Minors);

impl Plane {
    /// The plane of the triangle `(a, b, c)`.
    #[inline]
    pub(crate) fn of([a, b, c]: [&[f64; 3]; 3]) -> Self {
        Self(Minors::new(minus(b, a), minus(c, a)))
    }

    /// [`orient3d`] of the triangle's corners and `d`: the determinant with its rows turned.
    #[inline]
    pub(crate) fn side(&self, [a, b, c]: [&[f64; 3]; 3], d: &[f64; 3]) -> Sign {
        self.0.filter3(minus(d, a)).unwrap_or_else(|| unfiltered3([a, b, c, d], TET).0)
    }

    /// [`dot_sign`] of the triangle's corners, `s` and `t`: likewise.
    #[inline]
    pub(crate) fn dot_sign(&self, [a, b, c]: [&[f64; 3]; 3], s: &[f64; 3], t: &[f64; 3]) -> Sign {
        self.0.filter3(minus(t, s)).unwrap_or_else(|| unfiltered3([a, b, c, s, t], DOT).0)
    }
}

/// The sign of `det[u1-u0, v1-v0, w1-w0]`, that is of `cross(u1-u0, v1-v0) . (w1-w0)`: the general form of
/// [`orient3d`] and [`dot_sign`], for three vectors given by their ends.
///
/// Exact for all finite coordinates. For NaN or infinite ones the answer is unspecified, without panic.
#[inline]
pub fn det_sign(u: [&[f64; 3]; 2], v: [&[f64; 3]; 2], w: [&[f64; 3]; 2]) -> Sign {
    det_sign_staged(u, v, w).0
}

/// [`det_sign`] with the stage that decided.
#[inline]
pub fn det_sign_staged(u: [&[f64; 3]; 2], v: [&[f64; 3]; 2], w: [&[f64; 3]; 2]) -> (Sign, Stage) {
    match filter3(minus(u[1], u[0]), minus(v[1], v[0]), minus(w[1], w[0])) {
        Some(sign) => (sign, Stage::Filter),
        None => unfiltered3([u[0], u[1], v[0], v[1], w[0], w[1]], VECTORS),
    }
}

/// [`det_sign`] by big integers alone.
pub fn det_sign_exact(u: [&[f64; 3]; 2], v: [&[f64; 3]; 2], w: [&[f64; 3]; 2]) -> Sign {
    Integers::new(by_axis([u[0], u[1], v[0], v[1], w[0], w[1]])).sign_big(VECTORS)
}

#[cold]
#[inline(never)]
fn unfiltered3<const N: usize>(points: [&[f64; 3]; N], rows: Rows<3>) -> (Sign, Stage) {
    if let Some(sign) = word::sign3(points, rows) {
        return (sign, Stage::Fixed);
    }
    // Repeated points and planes along the axes are common: a zero row or column needs no arithmetic.
    let mut axis_differs = [false; 3];
    let mut zero_row = false;
    for (i, j) in rows {
        let mut row_differs = false;
        for ((axis_differs, x), y) in axis_differs.iter_mut().zip(points[i]).zip(points[j]) {
            let differs = !Sign::of_difference(*x, *y).is_zero();
            *axis_differs |= differs;
            row_differs |= differs;
        }
        zero_row |= !row_differs;
    }
    if zero_row || axis_differs != [true; 3] {
        return (Sign::Zero, Stage::Fixed);
    }
    Integers::new(by_axis(points)).sign(rows)
}

/// The sign of the component of `cross(b-a, c-a)` along `drop`: the orientation of the triangle
/// projected along that axis, seen from the axis' positive end.
///
/// Exact for all finite coordinates. For NaN or infinite ones the answer is unspecified, without panic.
#[inline]
pub fn orient2d(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], drop: Axis) -> Sign {
    orient2d_staged(a, b, c, drop).0
}

/// [`orient2d`] with the stage that decided.
#[inline]
pub fn orient2d_staged(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], drop: Axis) -> (Sign, Stage) {
    let [a, b, c] = [a, b, c].map(|p| drop.others(p));
    match filter2([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]) {
        Some(sign) => (sign, Stage::Filter),
        None => unfiltered2([a, b, c]),
    }
}

/// [`orient2d`] by big integers alone.
pub fn orient2d_exact(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], drop: Axis) -> Sign {
    let points = [a, b, c].map(|p| drop.others(p));
    Integers::new([points.map(|p| p[0]), points.map(|p| p[1])]).sign_big(TRIANGLE)
}

#[cold]
#[inline(never)]
fn unfiltered2(points: [[f64; 2]; 3]) -> (Sign, Stage) {
    if let Some(sign) = word::sign2(points.each_ref(), TRIANGLE) {
        return (sign, Stage::Fixed);
    }
    Integers::new([points.map(|p| p[0]), points.map(|p| p[1])]).sign(TRIANGLE)
}

/// The signs of the three components of `cross(b-a, c-a)`.
#[inline]
pub fn normal_signs(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> [Sign; 3] {
    Axis::ALL.map(|axis| orient2d(a, b, c, axis))
}

/// Do the three points lie on one line (coinciding points included)? Exact.
#[inline]
pub fn collinear(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> bool {
    projection_axis(a, b, c).is_none()
}

/// Is the triangle's area exactly zero? The same as [`collinear`].
#[inline]
pub fn zero_area(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> bool {
    collinear(a, b, c)
}

/// An axis along which the triangle's projection keeps a non-zero area; `None` if it has none.
#[inline]
pub fn projection_axis(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Option<Axis> {
    Axis::ALL.into_iter().find(|&axis| !orient2d(a, b, c, axis).is_zero())
}

/// On which side of the oriented plane through `a, b, c` lies `p`? [`Sign::Positive`] is the side that
/// `cross(b-a, c-a)` points to. The same as [`orient3d`]; `Zero` always if `a, b, c` are collinear.
#[inline]
pub fn side_of_plane(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], p: &[f64; 3]) -> Sign {
    orient3d(a, b, c, p)
}
