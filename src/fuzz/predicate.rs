//! The predicates that subjects are asked about: names, sizes, conditions.

use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use crate::predicate::zero_area;

/// A predicate, as `docs/SUBJECTS.md` defines it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Predicate {
    /// Sign of `det[b-a, c-a]` in the plane.
    Orient2d,
    /// Sign of `det[b-a, c-a, d-a]`.
    Orient3d,
    /// Is `d` inside the circle through `a, b, c`?
    Incircle,
    /// Is `e` inside the sphere through `a, b, c, d`?
    Insphere,
    /// Sign of `((b-a) x (c-a)) . (e-d)`.
    DotSign,
    /// Is `p` inside, on, or outside of a tet?
    PointInTet,
    /// Do two triangles share a point?
    TriangleTriangle,
    /// Do a segment and a triangle share a point?
    SegmentTriangle,
    /// Do a ray and a triangle share a point?
    RayTriangle,
    /// The least of the signs of the 12 tets of a slab of a prism.
    PrismPositivity,
    /// The least of the signs of a triangle's normal along three pillars.
    SectionDot,
}

/// A text that names no predicate.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "there is no predicate `{0}`: one of orient2d, orient3d, incircle, insphere, dot_sign, point_in_tet, \
         triangle_triangle, segment_triangle, ray_triangle, prism_positivity, section_dot is wanted"
)]
pub struct UnknownPredicate(pub String);

impl Predicate {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Orient2d,
        Self::Orient3d,
        Self::Incircle,
        Self::Insphere,
        Self::DotSign,
        Self::PointInTet,
        Self::TriangleTriangle,
        Self::SegmentTriangle,
        Self::RayTriangle,
        Self::PrismPositivity,
        Self::SectionDot,
    ];

    /// Its name in the protocol.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Orient2d => "orient2d",
            Self::Orient3d => "orient3d",
            Self::Incircle => "incircle",
            Self::Insphere => "insphere",
            Self::DotSign => "dot_sign",
            Self::PointInTet => "point_in_tet",
            Self::TriangleTriangle => "triangle_triangle",
            Self::SegmentTriangle => "segment_triangle",
            Self::RayTriangle => "ray_triangle",
            Self::PrismPositivity => "prism_positivity",
            Self::SectionDot => "section_dot",
        }
    }

    /// Coordinates of a point: 2 or 3.
    #[must_use]
    pub const fn dimension(self) -> usize {
        match self {
            Self::Orient2d | Self::Incircle => 2,
            _ => 3,
        }
    }

    /// Points of a case.
    #[must_use]
    pub const fn points(self) -> usize {
        match self {
            Self::Orient2d => 3,
            Self::Orient3d | Self::Incircle => 4,
            Self::Insphere | Self::DotSign | Self::PointInTet | Self::SegmentTriangle | Self::RayTriangle => {
                5
            }
            Self::TriangleTriangle | Self::PrismPositivity => 6,
            Self::SectionDot => 9,
        }
    }

    /// Coordinates of a case.
    #[must_use]
    pub const fn arity(self) -> usize {
        self.points() * self.dimension()
    }

    /// A plain case: the unit tet, the unit prism, and such.
    #[must_use]
    pub fn example(self) -> Vec<f64> {
        const TET: [[f64; 3]; 6] =
            [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.25; 3], [1.0, 0.0, 1.0]];
        const PRISM: [[f64; 3]; 9] = [
            TET[0],
            TET[1],
            TET[2],
            TET[0],
            TET[1],
            TET[2],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 1.0],
            [0.0, 1.0, 1.0],
        ];
        let points: &[[f64; 3]] = match self {
            Self::PrismPositivity => &PRISM[3..],
            Self::SectionDot => &PRISM,
            Self::Incircle => return vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.25, 0.25],
            _ => &TET,
        };
        let flat = points.iter().flat_map(|p| p.iter().take(self.dimension()));
        flat.take(self.arity()).copied().collect()
    }

    /// Is this a case: as many finite coordinates as it takes, and for the three predicates that ask whether
    /// sets meet, triangles of positive area and segments of positive length?
    #[must_use]
    pub fn accepts(self, case: &[f64]) -> bool {
        if case.len() != self.arity() || !case.iter().all(|x| x.is_finite()) {
            return false;
        }
        let point = |i: usize| case.get(3 * i..3 * i + 3).and_then(|p| <&[f64; 3]>::try_from(p).ok());
        let flat = |i: usize| match (point(i), point(i + 1), point(i + 2)) {
            (Some(a), Some(b), Some(c)) => zero_area(a, b, c),
            _ => true,
        };
        match self {
            Self::TriangleTriangle => !flat(0) && !flat(3),
            Self::SegmentTriangle | Self::RayTriangle => {
                let same = case
                    .iter()
                    .zip(&case[3..])
                    .take(3)
                    .all(|(x, y)| x.partial_cmp(y).is_some_and(Ordering::is_eq));
                !same && !flat(2)
            }
            _ => true,
        }
    }
}

impl fmt::Display for Predicate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Predicate {
    type Err = UnknownPredicate;

    fn from_str(name: &str) -> Result<Self, UnknownPredicate> {
        Self::ALL.into_iter().find(|p| p.name() == name).ok_or_else(|| UnknownPredicate(name.to_owned()))
    }
}
