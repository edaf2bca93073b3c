//! Exact points and barycentric coordinates: integers inside, one division at the end.

use dashu_base::{Gcd, Sign, Signed, UnsignedAbs};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use crate::number::dyadic::{decompose, scale_points};

/// An exact rational number.
pub type Rat = RBig;

/// The exact value of a finite double.
pub(super) fn rational(x: f64) -> Rat {
    let (mantissa, exponent) = decompose(x);
    let shift = exponent.unsigned_abs() as usize;
    if exponent >= 0 {
        Rat::from(IBig::from(mantissa) << shift)
    } else {
        Rat::from_parts(IBig::from(mantissa), UBig::ONE << shift)
    }
}

/// The exact values of three finite doubles.
pub(super) fn rational_point(p: &[f64; 3]) -> [Rat; 3] {
    p.map(rational)
}

pub(super) fn is_negative(x: &IBig) -> bool {
    x.sign() == Sign::Negative && *x != IBig::ZERO
}

type Vec3 = [IBig; 3];

fn minus(a: &Vec3, b: &Vec3) -> Vec3 {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn det(a: &Vec3, b: &Vec3, c: &Vec3) -> IBig {
    &a[0] * (&b[1] * &c[2] - &b[2] * &c[1])
        + &a[1] * (&b[2] * &c[0] - &b[0] * &c[2])
        + &a[2] * (&b[0] * &c[1] - &b[1] * &c[0])
}

/// The rational point `xyz / w` with a common denominator `w > 0`.
pub(super) struct Homogeneous {
    xyz: Vec3,
    w: IBig,
}

impl Homogeneous {
    pub(super) fn new(p: &[Rat; 3]) -> Self {
        let mut w = UBig::ONE;
        for x in p {
            let d = x.denominator();
            // w and d are positive, so is their greatest common divisor.
            let g = (&w).gcd(d);
            w *= d / g;
        }
        let xyz = [0, 1, 2].map(|i| p[i].numerator() * IBig::from(&w / p[i].denominator()));
        Self { xyz, w: IBig::from(w) }
    }

    /// The same point in units of `2^scale`.
    fn in_units(&self, scale: i32) -> (Vec3, IBig) {
        let shift = scale.unsigned_abs() as usize;
        if scale <= 0 {
            (self.xyz.each_ref().map(|x| x << shift), self.w.clone())
        } else {
            (self.xyz.clone(), &self.w << shift)
        }
    }
}

/// Barycentric coordinates of a point in a positive tet as integers over one positive denominator.
pub(super) struct TetWeights {
    pub(super) numerators: [IBig; 4],
    denominator: IBig,
}

impl TetWeights {
    /// `None` for a tet without volume. For a negative tet all signs are those of its mirror image.
    pub(super) fn new(tet: [&[f64; 3]; 4], p: &Homogeneous) -> Option<Self> {
        let (points, scale) = scale_points(&tet.map(|x| *x));
        let [o, a, b, c] = points.as_slice() else { return None };
        let edges = [minus(a, o), minus(b, o), minus(c, o)];
        let (x, w) = p.in_units(scale);
        let q = [0, 1, 2].map(|i| &x[i] - &w * &o[i]);
        let volume = det(&edges[0], &edges[1], &edges[2]);
        if volume == IBig::ZERO {
            return None;
        }
        let one = det(&q, &edges[1], &edges[2]);
        let two = det(&edges[0], &q, &edges[2]);
        let three = det(&edges[0], &edges[1], &q);
        let denominator = volume * w;
        let zero = &denominator - &one - &two - &three;
        let numerators = [zero, one, two, three];
        Some(if is_negative(&denominator) {
            Self { numerators: numerators.map(|n| -n), denominator: -denominator }
        } else {
            Self { numerators, denominator }
        })
    }

    /// Does the closed tet hold the point?
    pub(super) fn is_inside(&self) -> bool {
        !self.numerators.iter().any(is_negative)
    }

    /// A sum of coordinates, given by integer factors, as a rational.
    pub(super) fn combine(&self, factors: [i8; 4]) -> Rat {
        let sum: IBig = (0..4).map(|k| &self.numerators[k] * IBig::from(factors[k])).sum();
        Rat::from_parts(sum, (&self.denominator).unsigned_abs())
    }
}

/// A closed box of doubles that holds the point. Infinite where the point is out of range.
///
/// Two steps outwards: any conversion that is off by less than two units in the last place will do.
pub(super) fn outer_box(p: &[Rat; 3]) -> [[f64; 3]; 2] {
    let near = p.each_ref().map(|x| x.to_f64().value());
    [near.map(|x| x.next_down().next_down()), near.map(|x| x.next_up().next_up())]
}

/// `a - b`.
pub(super) fn sub(a: &[Rat; 3], b: &[Rat; 3]) -> [Rat; 3] {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

/// `a + s d`.
pub(super) fn along(a: &[Rat; 3], s: &Rat, d: &[Rat; 3]) -> [Rat; 3] {
    [0, 1, 2].map(|i| &a[i] + s * &d[i])
}

/// `a . b`.
pub(super) fn dot(a: &[Rat; 3], b: &[Rat; 3]) -> Rat {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// `a x b`.
pub(super) fn cross(a: &[Rat; 3], b: &[Rat; 3]) -> [Rat; 3] {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

/// The weighted sum of stored points.
// A lifetime in `impl Trait` needs a name on stable Rust, whatever the lint says.
#[allow(single_use_lifetimes)]
pub(super) fn weighted<'p>(terms: impl IntoIterator<Item = (&'p [f64; 3], Rat)>) -> [Rat; 3] {
    let start = [Rat::ZERO, Rat::ZERO, Rat::ZERO];
    terms.into_iter().fold(start, |sum, (p, w)| along(&sum, &w, &rational_point(p)))
}

/// Barycentric coordinates of a point of a closed triangle, by ratios of areas projected along an
/// axis; `None` off the triangle, and for a triangle without area.
pub(super) fn triangle_weights(p: &[Rat; 3], x: &[[Rat; 3]; 3]) -> Option<[Rat; 3]> {
    let normal = cross(&sub(&x[1], &x[0]), &sub(&x[2], &x[0]));
    if dot(&normal, &sub(p, &x[0])) != Rat::ZERO {
        return None;
    }
    let axis = (0..3).find(|&i| normal[i] != Rat::ZERO)?;
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let area =
        |a: &[Rat; 3], b: &[Rat; 3]| (&a[j] - &p[j]) * (&b[k] - &p[k]) - (&a[k] - &p[k]) * (&b[j] - &p[j]);
    let weights = [area(&x[1], &x[2]), area(&x[2], &x[0]), area(&x[0], &x[1])].map(|w| w / &normal[axis]);
    (!weights.iter().any(Signed::is_negative)).then_some(weights)
}
