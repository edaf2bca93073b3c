//! Exact coordinates of overlay corners and of points in tets: used where a number must be shown or where a sign
//! is not one of input points. Rare, so clarity comes before speed.

use dashu_base::{Abs, Gcd, Sign as BigSign, Signed};
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::CertifyError;
use super::clip::Mask;
use crate::number::dyadic::scale_points;
use crate::predicate::Sign;

/// An integer vector.
pub(crate) type Vec3 = [IBig; 3];

/// The integer weights of a point on three points, not yet divided by their sum.
pub(crate) type Weights = Vec3;

/// `a - b`.
pub(crate) fn minus(a: &Vec3, b: &Vec3) -> Vec3 {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

/// `a x b`.
pub(crate) fn cross(a: &Vec3, b: &Vec3) -> Vec3 {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

/// `a . b`.
pub(crate) fn dot(a: &Vec3, b: &Vec3) -> IBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// `det[b-a, c-a, d-a]`.
pub(crate) fn determinant(a: &Vec3, b: &Vec3, c: &Vec3, d: &Vec3) -> IBig {
    dot(&cross(&minus(b, a), &minus(c, a)), &minus(d, a))
}

fn is_negative(x: &IBig) -> bool {
    *x != IBig::ZERO && x.sign() == BigSign::Negative
}

/// Barycentric weights with sum one as integers without a common factor.
pub(crate) fn to_integers<const N: usize>(weights: &[RBig; N]) -> [IBig; N] {
    let mut scale = IBig::ONE;
    for w in weights {
        let d = IBig::from(w.denominator().clone());
        let g = IBig::from((&scale).gcd(&d));
        scale = scale / g * d;
    }
    let scaled = weights.each_ref().map(|w| w.numerator() * (&scale / IBig::from(w.denominator().clone())));
    let gcd = scaled.iter().fold(IBig::ZERO, |g, x| match (g == IBig::ZERO, *x == IBig::ZERO) {
        (true, _) => x.clone().abs(),
        (false, true) => g,
        (false, false) => IBig::from(g.gcd(x)),
    });
    if gcd == IBig::ZERO { scaled } else { scaled.map(|x| x / &gcd) }
}

/// Weights divided by their sum; `None` when that is zero.
pub(crate) fn normalised<const N: usize>(weights: &[IBig; N]) -> Option<[RBig; N]> {
    let sum: IBig = weights.iter().sum();
    if sum == IBig::ZERO {
        return None;
    }
    Some(weights.each_ref().map(|w| RBig::from(w.clone()) / RBig::from(sum.clone())))
}

/// The sum of fractions.
pub(crate) fn sum(terms: impl Iterator<Item = RBig>) -> RBig {
    terms.fold(RBig::ZERO, |total, x| total + x)
}

/// The mean of some points given by weights with sum one.
pub(crate) fn mean<const N: usize>(points: &[[RBig; N]]) -> [RBig; N] {
    let n = RBig::from(points.len().max(1));
    std::array::from_fn(|i| sum(points.iter().map(|p| p[i].clone())) / &n)
}

/// Determinant of three rows.
pub(crate) fn det3(rows: [&[RBig; 3]; 3]) -> RBig {
    let [a, b, c] = rows;
    &a[0] * (&b[1] * &c[2] - &b[2] * &c[1]) - &a[1] * (&b[0] * &c[2] - &b[2] * &c[0])
        + &a[2] * (&b[0] * &c[1] - &b[1] * &c[0])
}

/// A triangle against a tet: `volumes[k][i]` is the tet's determinant with its vertex `k` moved to corner `i`, that is
/// barycentric coordinate `k` of corner `i` times the tet's determinant.
#[derive(Debug)]
pub(crate) struct ExactPiece {
    volumes: [Vec3; 4],
    volume: IBig,
}

impl ExactPiece {
    /// The points in the tet's positive order.
    pub(crate) fn new(f: [&[f64; 3]; 3], tet: [&[f64; 3]; 4]) -> Self {
        let all: Vec<[f64; 3]> = f.into_iter().chain(tet).copied().collect();
        let (points, _) = scale_points(&all);
        let y = |k: usize| &points[3 + k];
        let volumes = [0, 1, 2, 3].map(|k| {
            [0, 1, 2].map(|i| {
                let p = [0, 1, 2, 3].map(|j| if j == k { &points[i] } else { y(j) });
                determinant(p[0], p[1], p[2], p[3])
            })
        });
        let volume = determinant(y(0), y(1), y(2), y(3));
        Self { volumes, volume }
    }

    /// Integer weights in the triangle of the corner on the given lines. A corner of a polygon lies on two lines that
    /// cross; `None` for a mask that no corner has.
    pub(crate) fn corner(&self, mask: Mask) -> Option<Weights> {
        let line = |bit: usize| -> Vec3 {
            if bit < 3 {
                [0, 1, 2].map(|i| IBig::from(u8::from(i == bit)))
            } else {
                self.volumes[bit - 3].clone()
            }
        };
        let lines: Vec<Vec3> = (0..7).filter(|b| mask & (1 << b) != 0).map(line).collect();
        let pairs =
            lines.iter().enumerate().flat_map(|(i, a)| lines[i + 1..].iter().map(move |b| cross(a, b)));
        pairs.into_iter().find_map(|w| {
            let sum: IBig = w.iter().sum();
            match (sum == IBig::ZERO, is_negative(&sum)) {
                (true, _) => None,
                (_, true) => Some(w.map(|x| -x)),
                _ => Some(w),
            }
        })
    }

    /// The same with sum one.
    pub(crate) fn weights(&self, mask: Mask) -> Option<[RBig; 3]> {
        normalised(&self.corner(mask)?)
    }

    /// Barycentric coordinates in the tet of a point of the triangle's plane; with sum one. `None` for a flat tet.
    pub(crate) fn in_tet(&self, weights: &[RBig; 3]) -> Option<[RBig; 4]> {
        if self.volume == IBig::ZERO {
            return None;
        }
        let volume = RBig::from(self.volume.clone());
        Some(
            self.volumes
                .each_ref()
                .map(|row| sum((0..3).map(|i| &weights[i] * RBig::from(row[i].clone()))) / &volume),
        )
    }

    /// The tet's vertices (as a bit set) on which a point of the closed tet has a positive coordinate; `None` when the
    /// point is outside or the tet is not positive.
    pub(crate) fn carrier(&self, weights: &[RBig; 3]) -> Option<u8> {
        if self.volume == IBig::ZERO || is_negative(&self.volume) {
            return None;
        }
        let coordinates = self.in_tet(weights)?;
        if coordinates.iter().any(Signed::is_negative) {
            return None;
        }
        let bits = coordinates.iter().enumerate().filter(|(_, x)| **x != RBig::ZERO);
        Some(bits.fold(0, |set, (k, _)| set | 1 << k))
    }
}

/// The convex polygon (a point or segment, too), given by weights on a triangle's corners, cut with the closed half
/// space in which a linear function is not negative; `values` are the function's values at the corners.
pub(crate) fn cut(polygon: &[Weights], values: &Vec3) -> Vec<Weights> {
    let at: Vec<IBig> = polygon.iter().map(|w| dot(w, values)).collect();
    let mut out = Vec::with_capacity(polygon.len() + 1);
    for c in 0..polygon.len() {
        let next = (c + 1) % polygon.len();
        let (v, u) = (&at[c], &at[next]);
        if !is_negative(v) {
            out.push(polygon[c].clone());
        }
        if *v != IBig::ZERO && *u != IBig::ZERO && is_negative(v) != is_negative(u) {
            let (v, u) = (v.clone().abs(), u.clone().abs());
            out.push([0, 1, 2].map(|i| &u * &polygon[c][i] + &v * &polygon[next][i]));
        }
    }
    out
}

impl ExactPiece {
    /// The half spaces whose intersection with the triangle's plane is the part in the closed tet, which is positive:
    /// linear functions on weights, not negative inside.
    pub(crate) fn half_spaces(&self) -> &[Vec3; 4] {
        &self.volumes
    }

    /// The polygon in the triangle cut with the closed tet, whichever its orientation; empty when they do not meet or
    /// when the tet is flat.
    pub(crate) fn cut_with_tet(&self, polygon: &[Weights]) -> Vec<Weights> {
        if self.volume == IBig::ZERO {
            return Vec::new();
        }
        let mirrored = is_negative(&self.volume);
        self.volumes.iter().fold(polygon.to_vec(), |polygon, row| {
            if mirrored { cut(&polygon, &row.clone().map(|x| -x)) } else { cut(&polygon, row) }
        })
    }
}

/// The part of a triangle that lies in another triangle, which has area: weights on the first one's corners.
pub(crate) fn cut_with_triangle(triangle: [&Vec3; 3], other: [&Vec3; 3]) -> Vec<Weights> {
    let [a, b, c] = other;
    let normal = cross(&minus(b, a), &minus(c, a));
    let height = triangle.map(|x| dot(&normal, &minus(x, a)));
    let below = height.clone().map(|x| -x);
    let mut polygon = cut(&cut(&whole(), &height), &below);
    for (p, q) in [(a, b), (b, c), (c, a)] {
        let inward = cross(&normal, &minus(q, p));
        polygon = cut(&polygon, &triangle.map(|x| dot(&inward, &minus(x, p))));
    }
    polygon
}

/// The whole triangle.
pub(crate) fn whole() -> Vec<Weights> {
    (0..3).map(|i| [0, 1, 2].map(|j| IBig::from(u8::from(i == j)))).collect()
}

/// Do the points of a triangle with area span more than a line?
pub(crate) fn has_area(polygon: &[Weights]) -> bool {
    let n = polygon.len();
    let mut triples = (0..n).flat_map(|i| (i + 1..n).flat_map(move |j| (j + 1..n).map(move |k| [i, j, k])));
    triples.any(|[i, j, k]| dot(&cross(&polygon[i], &polygon[j]), &polygon[k]) != IBig::ZERO)
}

/// The mean of the points, with sum one; `None` for no points.
pub(crate) fn centre(polygon: &[Weights]) -> Option<[RBig; 3]> {
    let points: Vec<[RBig; 3]> = polygon.iter().filter_map(normalised).collect();
    (!points.is_empty()).then(|| mean(&points))
}

/// A point given by integer weights on integer points: `(x, y, z, w)` stands for `(x, y, z) / w`.
fn weighted(points: [&Vec3; 3], weights: &Weights) -> [IBig; 4] {
    let coordinate = |i: usize| points.iter().zip(weights).map(|(p, w)| &p[i] * w).sum::<IBig>();
    [coordinate(0), coordinate(1), coordinate(2), weights.iter().sum()]
}

/// Barycentric weights, with sum one, of a point of the plane of a triangle with area.
fn in_triangle(point: &[IBig; 4], corners: [&Vec3; 3]) -> Option<[RBig; 3]> {
    let [a, b, c] = corners;
    let normal = cross(&minus(b, a), &minus(c, a));
    // Weight i is the area opposite corner i, measured along the normal: `normal . ((q - p) x (x - p))`.
    let weight = |p: &Vec3, q: &Vec3| {
        let offset = [0, 1, 2].map(|i| &point[i] - &p[i] * &point[3]);
        dot(&normal, &cross(&minus(q, p), &offset))
    };
    normalised(&[weight(b, c), weight(c, a), weight(a, b)])
}

/// A point of both triangles, the first of which has area, by weights on the corners of each: the mean of the corners of
/// their common part. It lies in the relative interior of that part, hence not in the face that common vertices span
/// unless that is all.
pub(crate) fn common_point(first: [&Vec3; 3], second: [&Vec3; 3]) -> Result<[[IBig; 3]; 2], CertifyError> {
    let broken = || CertifyError::Internal { what: "triangles that neither meet nor can be separated" };
    common_point_off(first, second, &[])?.ok_or_else(broken)
}

/// [`common_point`] at none of these places; `None` if there is no other. The mean is at a corner of the second triangle only
/// if that is all, or if the triangle is flat: then another corner of the common part will do.
pub(crate) fn common_point_off(
    first: [&Vec3; 3],
    second: [&Vec3; 3],
    places: &[&Vec3],
) -> Result<Option<[[IBig; 3]; 2]>, CertifyError> {
    let broken = || CertifyError::Internal { what: "triangles that neither meet nor can be separated" };
    let common = cut_with_triangle(second, first);
    let centre = centre(&common).ok_or_else(broken)?;
    let is_off = |weights: &Weights| {
        let x = weighted(second, weights);
        !places.iter().any(|p| (0..3).all(|i| x[i] == &p[i] * &x[3]))
    };
    let corners = common.iter().filter_map(normalised).map(|corner| to_integers(&corner));
    let Some(in_second) = std::iter::once(to_integers(&centre)).chain(corners).find(is_off) else {
        return Ok(None);
    };
    let in_first = in_triangle(&weighted(second, &in_second), first).ok_or_else(broken)?;
    Ok(Some([to_integers(&in_first), in_second]))
}

/// The sign of an integer.
pub(crate) fn sign(x: &IBig) -> Sign {
    x.cmp(&IBig::ZERO).into()
}
