//! Subjects that need no program: crates, plain doubles, our own predicates.

use std::fmt;
use std::str::FromStr;

use rayon::prelude::*;

use super::plain;
use super::{Subject, SubjectError, caught};
use crate::fuzz::judge::{prism, section};
use crate::fuzz::points::points;
use crate::fuzz::{Answer, Predicate};
use crate::predicate::{
    Axis, Sign, dot_sign, incircle, insphere, orient2d, orient3d, point_in_tet, ray_triangle,
    segment_triangle, triangle_triangle,
};

/// A subject by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuiltIn {
    /// The crate `geometry-predicates`: `orient2d`, `orient3d`, `incircle`, `insphere`, and from these `prism_positivity`.
    GeometryPredicates,
    /// The crate `robust`, for the same predicates.
    Robust,
    /// The crate `geogram_predicates`, for the same predicates.
    Geogram,
    /// The formulas in doubles, for all predicates.
    F64,
    /// The predicates that this library decides with ([`crate::predicate`]), for all predicates.
    Fast,
}

/// A text that names no built-in subject.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no built-in subject `{0}`")]
pub struct UnknownSubject(pub String);

impl BuiltIn {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::GeometryPredicates, Self::Robust, Self::Geogram, Self::F64, Self::Fast];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::GeometryPredicates => "geometry-predicates",
            Self::Robust => "robust",
            Self::Geogram => "geogram",
            Self::F64 => "f64",
            Self::Fast => "fast",
        }
    }

    /// The answer to one case, in the convention of the judge.
    fn one(self, predicate: Predicate, case: &[f64]) -> Answer {
        let answer = match self {
            Self::GeometryPredicates => geometry_predicates(predicate, case),
            Self::Robust => robust_crate(predicate, case),
            Self::Geogram => geogram(predicate, case),
            Self::F64 => plain::answer(predicate, case),
            Self::Fast => fast(predicate, case).map(Answer::from),
        };
        answer.unwrap_or(Answer::Unsupported)
    }
}

impl fmt::Display for BuiltIn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(Self::name(*self))
    }
}

impl FromStr for BuiltIn {
    type Err = UnknownSubject;

    fn from_str(name: &str) -> Result<Self, UnknownSubject> {
        Self::ALL.into_iter().find(|s| Self::name(*s) == name).ok_or_else(|| UnknownSubject(name.to_owned()))
    }
}

impl Subject for BuiltIn {
    fn name(&self) -> String {
        Self::name(*self).to_owned()
    }

    fn answer(&mut self, predicate: Predicate, cases: &[f64]) -> Result<Vec<Answer>, SubjectError> {
        let one = |case: &[f64]| caught(|| self.one(predicate, case));
        Ok(cases.par_chunks_exact(predicate.arity()).map(one).collect())
    }
}

/// The least of several answers: of signs the least sign, else the first that is none.
fn least(answers: impl Iterator<Item = Answer>) -> Option<Answer> {
    answers.reduce(|one, other| match (&one, &other) {
        (Answer::Sign(a), Answer::Sign(b)) if b < a => other,
        (Answer::Sign(_), Answer::Sign(_)) => one,
        (Answer::Sign(_), _) => other,
        _ => one,
    })
}

/// The 12 tets of a slab by another `orient3d`.
pub(super) fn prism_by(
    case: &[f64],
    orient: impl Fn([f64; 3], [f64; 3], [f64; 3], [f64; 3]) -> Answer,
) -> Option<Answer> {
    let answers = std::cell::RefCell::new(Vec::with_capacity(12));
    prism(&points(case)?, |a, b, c, d| {
        answers.borrow_mut().push(orient(*a, *b, *c, *d));
        Sign::Zero
    })?;
    least(answers.into_inner().into_iter())
}

/// Shewchuk's conventions: `orient3d` and `insphere` are opposite to ours.
fn geometry_predicates(predicate: Predicate, case: &[f64]) -> Option<Answer> {
    use geometry_predicates as other;
    let orient = |a, b, c, d| Answer::of_value(-other::orient3d(a, b, c, d));
    Some(match predicate {
        Predicate::Orient2d => {
            let [a, b, c] = points(case)?;
            Answer::of_value(other::orient2d(a, b, c))
        }
        Predicate::Orient3d => {
            let [a, b, c, d] = points(case)?;
            orient(a, b, c, d)
        }
        Predicate::Incircle => {
            let [a, b, c, d] = points(case)?;
            Answer::of_value(other::incircle(a, b, c, d))
        }
        Predicate::Insphere => {
            let [a, b, c, d, e] = points(case)?;
            Answer::of_value(-other::insphere(a, b, c, d, e))
        }
        Predicate::PrismPositivity => prism_by(case, orient)?,
        _ => return None,
    })
}

/// Shewchuk's conventions, too.
fn robust_crate(predicate: Predicate, case: &[f64]) -> Option<Answer> {
    use robust::{Coord, Coord3D};
    let flat = |[x, y]: [f64; 2]| Coord { x, y };
    let solid = |[x, y, z]: [f64; 3]| Coord3D { x, y, z };
    let orient = |a, b, c, d| Answer::of_value(-robust::orient3d(solid(a), solid(b), solid(c), solid(d)));
    Some(match predicate {
        Predicate::Orient2d => {
            let [a, b, c] = points(case)?.map(flat);
            Answer::of_value(robust::orient2d(a, b, c))
        }
        Predicate::Orient3d => {
            let [a, b, c, d] = points(case)?;
            orient(a, b, c, d)
        }
        Predicate::Incircle => {
            let [a, b, c, d] = points(case)?.map(flat);
            Answer::of_value(robust::incircle(a, b, c, d))
        }
        Predicate::Insphere => {
            let [a, b, c, d, e] = points(case)?.map(solid);
            Answer::of_value(-robust::insphere(a, b, c, d, e))
        }
        Predicate::PrismPositivity => prism_by(case, orient)?,
        _ => return None,
    })
}

/// Our conventions, but it wants the circle's and the sphere's simplex positively oriented: where that is
/// flat the case is not for it.
fn geogram(predicate: Predicate, case: &[f64]) -> Option<Answer> {
    use geogram_predicates as other;
    let sign = |sign: other::Sign| {
        Answer::Sign(match sign {
            other::Sign::Negative => Sign::Negative,
            other::Sign::Zero => Sign::Zero,
            other::Sign::Positive => Sign::Positive,
        })
    };
    let orient = |a, b, c, d| sign(other::orient_3d(&a, &b, &c, &d));
    Some(match predicate {
        Predicate::Orient2d => {
            let [a, b, c] = points(case)?;
            sign(other::orient_2d(&a, &b, &c))
        }
        Predicate::Orient3d => {
            let [a, b, c, d] = points(case)?;
            orient(a, b, c, d)
        }
        Predicate::Incircle => {
            let [a, b, c, d] = points(case)?;
            match fast(Predicate::Orient2d, case.get(..6)?)? {
                Sign::Zero => return None,
                Sign::Positive => sign(other::in_circle_2d(&a, &b, &c, &d)),
                Sign::Negative => sign(other::in_circle_2d(&b, &a, &c, &d)).flipped(),
            }
        }
        Predicate::Insphere => {
            let [a, b, c, d, e] = points(case)?;
            match orient3d(&a, &b, &c, &d) {
                Sign::Zero => return None,
                Sign::Positive => sign(other::in_sphere_3d(&a, &b, &c, &d, &e)),
                Sign::Negative => sign(other::in_sphere_3d(&b, &a, &c, &d, &e)).flipped(),
            }
        }
        Predicate::PrismPositivity => prism_by(case, orient)?,
        _ => return None,
    })
}

/// What this library decides with.
fn fast(predicate: Predicate, case: &[f64]) -> Option<Sign> {
    let truth = |holds: bool| if holds { Sign::Positive } else { Sign::Zero };
    Some(match predicate {
        Predicate::Orient2d => {
            let [a, b, c] = points::<3, 2>(case)?.map(|[x, y]| [x, y, 0.0]);
            orient2d(&a, &b, &c, Axis::Z)
        }
        Predicate::Orient3d => {
            let [a, b, c, d] = points(case)?;
            orient3d(&a, &b, &c, &d)
        }
        Predicate::Incircle => {
            let [a, b, c, d] = points(case)?;
            incircle(&a, &b, &c, &d)
        }
        Predicate::Insphere => {
            let [a, b, c, d, e] = points(case)?;
            insphere(&a, &b, &c, &d, &e)
        }
        Predicate::DotSign => {
            let [a, b, c, d, e] = points(case)?;
            dot_sign(&a, &b, &c, &d, &e)
        }
        Predicate::PointInTet => {
            let [a, b, c, d, p] = points(case)?;
            match point_in_tet(&p, [&a, &b, &c, &d]) {
                None => Sign::Negative,
                Some(mask) if mask.is_interior() => Sign::Positive,
                Some(_) => Sign::Zero,
            }
        }
        Predicate::TriangleTriangle => {
            let [a, b, c, d, e, f] = points(case)?;
            truth(triangle_triangle([&a, &b, &c], [&d, &e, &f]).meets())
        }
        Predicate::SegmentTriangle => {
            let [s, t, a, b, c] = points(case)?;
            truth(segment_triangle([&s, &t], [&a, &b, &c]).meets())
        }
        Predicate::RayTriangle => {
            let [o, p, a, b, c] = points(case)?;
            truth(ray_triangle([&o, &p], [&a, &b, &c]))
        }
        Predicate::PrismPositivity => prism(&points(case)?, orient3d)?,
        Predicate::SectionDot => section(&points(case)?, dot_sign)?,
    })
}
