//! Quality rules of the optimisation. Floats: they steer, they prove nothing.

use crate::construct::direction::float_dot;

/// What the operations aim at and are bounded by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Largest length of each pillar half.
    pub(crate) thickness: f64,
    /// Largest MIPS energy that a collapse may make, unless it was larger before.
    pub(crate) energy: f64,
}

/// `to - from`.
pub(crate) fn minus(to: &[f64; 3], from: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| to[i] - from[i])
}

/// The distance of two points.
pub(crate) fn distance(p: &[f64; 3], q: &[f64; 3]) -> f64 {
    let d = minus(p, q);
    float_dot(&d, &d).sqrt()
}
