//! Exact points of triangles, for reports.

use dashu_int::IBig;
use dashu_ratio::RBig;
use serde::{Deserialize, Serialize};

use crate::certify::exact::{normalised, to_integers};
use crate::number::{Rat, Rational as _};

/// A point of a triangle, exactly.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExactPoint {
    /// Integer weights on the triangle's corners.
    pub weights: [String; 3],
    /// The coordinates as fractions.
    pub exact: [String; 3],
    /// The coordinates, rounded to the nearest doubles.
    pub approximate: [f64; 3],
}

/// The coordinates of a point of a triangle.
pub(crate) fn coordinates(weights: &[RBig; 3], corners: [&[f64; 3]; 3]) -> [RBig; 3] {
    std::array::from_fn(|axis| {
        weights.iter().zip(corners).fold(RBig::ZERO, |sum, (w, corner)| {
            // Every finite double is a fraction; meshes hold no others.
            sum + RBig::try_from(corner[axis]).map_or(RBig::ZERO, |x| w * x)
        })
    })
}

impl ExactPoint {
    /// From weights with sum one.
    pub(crate) fn new(weights: &[RBig; 3], corners: [&[f64; 3]; 3]) -> Self {
        let x = coordinates(weights, corners);
        Self {
            weights: to_integers(weights).map(|w| w.to_string()),
            exact: x.each_ref().map(ToString::to_string),
            approximate: x.each_ref().map(|x| x.to_f64().value()),
        }
    }

    /// From integer weights; `None` if their sum is zero.
    pub(crate) fn from_integers(weights: &[IBig; 3], corners: [&[f64; 3]; 3]) -> Option<Self> {
        Some(Self::new(&normalised(weights)?, corners))
    }
}

/// A fraction rounded to the nearest double.
pub(crate) fn rounded(x: &RBig) -> f64 {
    x.to_f64().value()
}

/// `mantissa * 2^exponent` rounded to the nearest double.
pub(crate) fn rounded_dyadic((mantissa, exponent): &(IBig, i32)) -> f64 {
    let power = Rat::from_scaled(1, *exponent);
    Rat::from(mantissa.clone()).times(&power).to_f64().value()
}
