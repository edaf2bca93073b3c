//! Points of a mesh in homogeneous integers.

use dashu_base::{Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::exact::{Big3, in_ratio, sign};
use crate::projection::{MeshPoint, Rat, SectionError, barycentric};

/// A point of a mesh triangle: the weight on corner `i` is `numerators[i]` divided by their sum.
#[derive(Clone, Debug)]
pub struct ExactPoint {
    /// The triangle: an index into [`TriMesh::faces`](crate::mesh::TriMesh::faces).
    pub face: u32,
    /// None negative, sum positive; in lowest terms only after [`reduced`](Self::reduced).
    numerators: Big3,
}

impl ExactPoint {
    /// # Errors
    /// [`SectionError::MeshPoint`]: a numerator is negative, or all are zero.
    pub fn new(face: u32, numerators: [IBig; 3]) -> Result<Self, SectionError> {
        let negative = numerators.iter().any(|n| sign(n).is_negative());
        if negative || numerators.iter().all(|n| sign(n).is_zero()) {
            return Err(SectionError::MeshPoint { face });
        }
        Ok(Self { face, numerators })
    }

    /// The point whose weights are exactly in the ratio of three doubles: they need not add up to one.
    ///
    /// # Errors
    /// [`SectionError::MeshPoint`]: a weight is negative or not finite, or all are zero.
    pub fn from_f64(face: u32, weights: [f64; 3]) -> Result<Self, SectionError> {
        if !weights.iter().all(|w| w.is_finite()) {
            return Err(SectionError::MeshPoint { face });
        }
        Self::new(face, in_ratio(weights))
    }

    /// Corner `corner` (0, 1, 2) of a triangle.
    #[must_use]
    pub fn corner(face: u32, corner: usize) -> Self {
        Self { face, numerators: [0, 1, 2].map(|k| IBig::from(u8::from(k == corner % 3))) }
    }

    pub(super) fn known(face: u32, numerators: Big3) -> Self {
        Self { face, numerators }
    }

    /// The homogeneous weights.
    #[must_use]
    pub fn numerators(&self) -> &[IBig; 3] {
        &self.numerators
    }

    /// The weights' common denominator.
    #[must_use]
    pub fn denominator(&self) -> IBig {
        &self.numerators[0] + &self.numerators[1] + &self.numerators[2]
    }

    /// The same point with the smallest numerators.
    #[must_use]
    pub fn reduced(self) -> Self {
        let [a, b, c] = self.numerators.each_ref().map(UnsignedAbs::unsigned_abs);
        let common = gcd(gcd(a, b), c);
        if common == UBig::ONE {
            return self;
        }
        let common = IBig::from(common);
        Self { face: self.face, numerators: self.numerators.map(|n| n / &common) }
    }

    /// Whether the two are the same weights on the same triangle: cross products, no division.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        self.face == other.face && in_same_ratio(&self.numerators, &other.numerators)
    }

    /// The weights as texts `n/d` in lowest terms (`n` where `d` is 1).
    #[must_use]
    pub fn texts(&self) -> [String; 3] {
        self.rationals().map(|w| w.to_string())
    }

    /// The weights as rational numbers.
    #[must_use]
    pub fn rationals(&self) -> [Rat; 3] {
        let denominator = self.denominator().unsigned_abs();
        self.numerators.each_ref().map(|n| Rat::from_parts(n.clone(), denominator.clone()))
    }

    /// The weights, each rounded to nearest.
    #[must_use]
    pub fn rounded(&self) -> [f64; 3] {
        self.rationals().map(|w| w.to_f64().value())
    }
}

fn gcd(a: UBig, b: UBig) -> UBig {
    // The greatest common divisor of two zeros is not defined.
    if a == UBig::ZERO {
        b
    } else if b == UBig::ZERO {
        a
    } else {
        a.gcd(b)
    }
}

/// Are two triples, neither of them zero, positive multiples of each other when none is negative?
pub(super) fn in_same_ratio(a: &Big3, b: &Big3) -> bool {
    [(0, 1), (1, 2), (2, 0)].into_iter().all(|(i, j)| &a[i] * &b[j] == &a[j] * &b[i])
}

impl TryFrom<&MeshPoint> for ExactPoint {
    type Error = SectionError;

    fn try_from(point: &MeshPoint) -> Result<Self, SectionError> {
        if !barycentric(&point.weights) {
            return Err(SectionError::MeshPoint { face: point.face });
        }
        let [a, b, c] = point.weights.each_ref().map(Rat::denominator);
        let common = a * b * c;
        let numerator = |w: &Rat| w.numerator() * IBig::from(&common / w.denominator());
        Ok(Self { face: point.face, numerators: point.weights.each_ref().map(numerator) }.reduced())
    }
}

impl From<&ExactPoint> for MeshPoint {
    fn from(point: &ExactPoint) -> Self {
        Self { face: point.face, weights: point.rationals() }
    }
}
