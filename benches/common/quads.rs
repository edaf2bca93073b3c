//! Inputs for `orient3d`, and its peers with one sign convention.

use crate::generate::unit_hash;
use homeo::predicate::{Sign, orient3d};

/// Four points.
pub type Quad = [[f64; 3]; 4];

/// How near to coplanar the points are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Random points of the unit cube.
    Random,
    /// Corners of a parallelogram with 50-bit coordinates, one coordinate moved by one ulp.
    OneUlp,
    /// Corners of a parallelogram with 50-bit coordinates.
    Coplanar,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Random, Self::OneUlp, Self::Coplanar];

    /// The name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::OneUlp => "one ulp off (50 bits)",
            Self::Coplanar => "exactly coplanar (50 bits)",
        }
    }
}

/// `count` inputs of one kind, the same on every run.
#[must_use]
pub fn quads(kind: Kind, count: usize) -> Vec<Quad> {
    let quad = |n: usize| {
        let number = |k: usize| unit_hash((n * 12 + k) as u64);
        let point = |i: usize| [0, 1, 2].map(|axis| number(3 * i + axis));
        if kind == Kind::Random {
            return [0, 1, 2, 3].map(point);
        }
        // Whole numbers below 2^50: b + c - a is exact, and the four points are exactly coplanar.
        let whole = |p: [f64; 3]| p.map(|x| (x * 1_125_899_906_842_624.0).floor());
        let [a, b, c] = [0, 1, 2].map(|i| whole(point(i)));
        let mut d = [0, 1, 2].map(|i| b[i] + c[i] - a[i]);
        if kind == Kind::OneUlp {
            d[n % 3] = if n.is_multiple_of(2) { d[n % 3].next_up() } else { d[n % 3].next_down() };
        }
        [a, b, c, d]
    };
    (0..count).map(quad).collect()
}

/// An implementation of `orient3d`: -1, 0 or 1 for the sign of `det[b-a, c-a, d-a]`.
pub type Implementation = fn(&Quad) -> i8;

/// homeo's.
#[must_use]
#[inline]
pub fn ours([a, b, c, d]: &Quad) -> i8 {
    match orient3d(a, b, c, d) {
        Sign::Positive => 1,
        Sign::Zero => 0,
        Sign::Negative => -1,
    }
}

/// The sign of `-value`: the peers' determinants have the other orientation.
fn negated(value: f64) -> i8 {
    i8::from(value < 0.0) - i8::from(value > 0.0)
}

/// That of the crate `geometry-predicates`.
#[must_use]
#[inline]
pub fn geometry_predicates(&[a, b, c, d]: &Quad) -> i8 {
    negated(geometry_predicates::orient3d(a, b, c, d))
}

/// That of the crate `robust`.
#[must_use]
#[inline]
pub fn robust(quad: &Quad) -> i8 {
    let [a, b, c, d] = quad.map(|[x, y, z]| robust::Coord3D { x, y, z });
    negated(robust::orient3d(a, b, c, d))
}

/// That of the crate `geogram_predicates`.
#[must_use]
#[inline]
pub fn geogram([a, b, c, d]: &Quad) -> i8 {
    match geogram_predicates::orient_3d(a, b, c, d) {
        geogram_predicates::Sign::Negative => -1,
        geogram_predicates::Sign::Zero => 0,
        geogram_predicates::Sign::Positive => 1,
    }
}

/// The textbook formula in doubles: what exactness costs is the time beyond it.
#[must_use]
#[inline]
pub fn plain([a, b, c, d]: &Quad) -> i8 {
    let minus = |p: &[f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let [u, v, w] = [minus(b), minus(c), minus(d)];
    -negated(
        u[0] * (v[1] * w[2] - v[2] * w[1])
            + u[1] * (v[2] * w[0] - v[0] * w[2])
            + u[2] * (v[0] * w[1] - v[1] * w[0]),
    )
}

/// All implementations, homeo's first.
pub const IMPLEMENTATIONS: [(&str, Implementation); 5] = [
    ("homeo", ours),
    ("geometry-predicates", geometry_predicates),
    ("robust", robust),
    ("geogram_predicates", geogram),
    ("plain f64", plain),
];
