//! Exact integers: input points on one common grid, determinants, clipping of convex polygons by half planes.

use dashu_base::{Abs, Gcd, Sign, Signed};
use dashu_int::IBig;

/// A point of the common grid.
pub type Point = [IBig; 3];

/// Homogeneous weights with non-negative entries and greatest common divisor one.
pub type Weights = Vec<IBig>;

fn parts(x: f64) -> (i64, i32) {
    assert!(x.is_finite());
    if x == 0.0 {
        return (0, i32::MAX);
    }
    let bits = x.to_bits();
    let biased = i32::try_from((bits >> 52) & 0x7ff).unwrap();
    let fraction = i64::try_from(bits & ((1 << 52) - 1)).unwrap();
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    let zeros = mantissa.trailing_zeros();
    let mantissa = if x < 0.0 { -(mantissa >> zeros) } else { mantissa >> zeros };
    (mantissa, exponent + i32::try_from(zeros).unwrap())
}

/// All points times one power of two, so that they are integers.
#[must_use]
pub fn on_grid(points: &[[f64; 3]]) -> Vec<Point> {
    let low = points.iter().flatten().map(|x| parts(*x).1).min().unwrap_or(0);
    let integer = |x: f64| {
        let (mantissa, exponent) = parts(x);
        if mantissa == 0 {
            IBig::ZERO
        } else {
            IBig::from(mantissa) << usize::try_from(exponent - low).unwrap()
        }
    };
    points.iter().map(|p| p.map(integer)).collect()
}

/// `a - b`.
#[must_use]
pub fn minus(a: &Point, b: &Point) -> Point {
    [&a[0] - &b[0], &a[1] - &b[1], &a[2] - &b[2]]
}

/// The dot product.
#[must_use]
pub fn dot(a: &[IBig], b: &[IBig]) -> IBig {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The cross product.
#[must_use]
pub fn cross(a: &[IBig], b: &[IBig]) -> Point {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

/// The point in machine integers below 2^37, where it fits: only to save time.
fn small(p: &Point) -> Option<[i128; 3]> {
    let mut out = [0; 3];
    for (slot, x) in out.iter_mut().zip(p) {
        let x = i64::try_from(x).ok().filter(|x| x.unsigned_abs() < 1 << 37)?;
        *slot = i128::from(x);
    }
    Some(out)
}

/// `det[b-a, c-a, d-a]`.
#[must_use]
pub fn orient(a: &Point, b: &Point, c: &Point, d: &Point) -> IBig {
    if let (Some(a), Some(b), Some(c), Some(d)) = (small(a), small(b), small(c), small(d)) {
        let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        // Differences below 2^38, so six products below 2^114.
        let x = u[1] * v[2] - u[2] * v[1];
        let y = u[2] * v[0] - u[0] * v[2];
        let z = u[0] * v[1] - u[1] * v[0];
        return IBig::from(x * w[0] + y * w[1] + z * w[2]);
    }
    dot(&cross(&minus(b, a), &minus(c, a)), &minus(d, a))
}

/// Is the number greater than zero?
#[must_use]
pub fn positive(x: &IBig) -> bool {
    x.sign() == Sign::Positive && *x != IBig::ZERO
}

/// The multiple of the weights whose entries have no common divisor.
#[must_use]
pub fn primitive(weights: Weights) -> Weights {
    let mut divisor = dashu_int::UBig::ZERO;
    for w in &weights {
        if *w != IBig::ZERO {
            let size = w.clone().abs();
            let size: dashu_int::UBig = size.try_into().unwrap();
            divisor = if divisor == dashu_int::UBig::ZERO { size } else { divisor.gcd(size) };
        }
    }
    assert!(divisor != dashu_int::UBig::ZERO, "weights that all vanish");
    if divisor == dashu_int::UBig::ONE {
        return weights;
    }
    let divisor = IBig::from(divisor);
    weights.into_iter().map(|w| w / &divisor).collect()
}

/// The corners of a simplex with `n` corners, as weights.
#[must_use]
pub fn simplex(n: usize) -> Vec<Weights> {
    (0..n).map(|i| (0..n).map(|j| IBig::from(u8::from(i == j))).collect()).collect()
}

/// The part of a convex polygon (also: segment, point) on which the linear form is not negative. No corner that
/// is returned lies between two others.
#[must_use]
pub fn clip(polygon: &[Weights], form: &[IBig]) -> Vec<Weights> {
    let values: Vec<IBig> = polygon.iter().map(|p| dot(p, form)).collect();
    let mut out: Vec<Weights> = Vec::new();
    for i in 0..polygon.len() {
        let j = (i + 1) % polygon.len();
        let (a, b) = (&values[i], &values[j]);
        if !a.is_negative() {
            out.push(polygon[i].clone());
        }
        if (positive(a) && b.is_negative()) || (a.is_negative() && positive(b)) {
            // The point a*q - b*p, with the sign that makes its weights positive.
            let mixed = polygon[i].iter().zip(&polygon[j]).map(|(p, q)| {
                let x = a * q - b * p;
                if a.is_negative() { -x } else { x }
            });
            out.push(primitive(mixed.collect()));
        }
    }
    let mut distinct: Vec<Weights> = Vec::new();
    for p in out {
        if !distinct.contains(&p) {
            distinct.push(p);
        }
    }
    distinct
}

/// Three times three determinant.
#[must_use]
pub fn det3(a: &[IBig], b: &[IBig], c: &[IBig]) -> IBig {
    dot(&cross(a, b), c)
}

/// The polygon's part to the left of all sides of `other`; both counter-clockwise, in homogeneous coordinates.
#[must_use]
pub fn overlap(polygon: &[Weights], other: &[Weights]) -> Vec<Weights> {
    let mut out = polygon.to_vec();
    for i in 0..other.len() {
        out = clip(&out, &cross(&other[i], &other[(i + 1) % other.len()]));
    }
    out
}
