//! The right answers, by big integers alone: no filter, and no code in common with the fast predicates for
//! anything that is not a single determinant.

mod meeting;

use meeting::{Reach, point_in_hull, reaches};

use super::Predicate;
use super::points::points;
use crate::predicate::{
    Axis, Sign, dot_sign_exact, incircle_exact, insphere_exact, orient2d_exact, orient3d_exact,
};
use crate::shell::decomposition::{LocalVertex, TETS};

/// The right answer, exact for every case that the predicate [accepts](Predicate::accepts); `None` for what is
/// no case. Truth values are `Positive` and `Zero`.
#[must_use]
pub fn judge(predicate: Predicate, case: &[f64]) -> Option<Sign> {
    if !case.iter().all(|x| x.is_finite()) {
        return None;
    }
    let truth = |holds: bool| if holds { Sign::Positive } else { Sign::Zero };
    Some(match predicate {
        Predicate::Orient2d => {
            let [a, b, c] = points::<3, 2>(case)?.map(|[x, y]| [x, y, 0.0]);
            orient2d_exact(&a, &b, &c, Axis::Z)
        }
        Predicate::Incircle => {
            let [a, b, c, d] = points(case)?;
            incircle_exact(&a, &b, &c, &d)
        }
        Predicate::Orient3d => {
            let [a, b, c, d] = points(case)?;
            orient3d_exact(&a, &b, &c, &d)
        }
        Predicate::Insphere => {
            let [a, b, c, d, e] = points(case)?;
            insphere_exact(&a, &b, &c, &d, &e)
        }
        Predicate::DotSign => {
            let [a, b, c, d, e] = points(case)?;
            dot_sign_exact(&a, &b, &c, &d, &e)
        }
        Predicate::PointInTet => point_in_tet(&points(case)?),
        Predicate::SegmentTriangle => {
            let [s, t, a, b, c] = points(case)?;
            truth(reaches(Reach::Segment, [&s, &t], [&a, &b, &c])?)
        }
        Predicate::RayTriangle => {
            let [s, t, a, b, c] = points(case)?;
            truth(reaches(Reach::Ray, [&s, &t], [&a, &b, &c])?)
        }
        Predicate::TriangleTriangle => truth(triangles_meet(&points(case)?)?),
        Predicate::PrismPositivity => prism(&points(case)?, orient3d_exact)?,
        Predicate::SectionDot => section(&points(case)?, dot_sign_exact)?,
    })
}

/// The least of the signs of a slab's 12 tets.
pub(super) fn prism(
    p: &[[f64; 3]; 6],
    orient: impl Fn(&[f64; 3], &[f64; 3], &[f64; 3], &[f64; 3]) -> Sign,
) -> Option<Sign> {
    let at = |(corner, upper): LocalVertex| p.get(usize::from(corner) + if upper { 3 } else { 0 });
    let signs = TETS.iter().filter_map(|tet| {
        let [a, b, c, d] = tet.vertices.map(at);
        Some(orient(a?, b?, c?, d?))
    });
    signs.min()
}

/// The least of the signs of a triangle's normal along three pillars.
pub(super) fn section(
    [a, b, c, lo0, lo1, lo2, hi0, hi1, hi2]: &[[f64; 3]; 9],
    dot: impl Fn(&[f64; 3], &[f64; 3], &[f64; 3], &[f64; 3], &[f64; 3]) -> Sign,
) -> Option<Sign> {
    [(lo0, hi0), (lo1, hi1), (lo2, hi2)].into_iter().map(|(lo, hi)| dot(a, b, c, lo, hi)).min()
}

/// Two triangles meet exactly when an edge of one meets the other.
fn triangles_meet([a, b, c, d, e, f]: &[[f64; 3]; 6]) -> Option<bool> {
    let (one, two) = ([a, b, c], [d, e, f]);
    for (edges, other) in [(one, two), (two, one)] {
        let [x, y, z] = edges;
        for edge in [[x, y], [y, z], [z, x]] {
            if reaches(Reach::Segment, edge, other)? {
                return Some(true);
            }
        }
    }
    Some(false)
}

fn point_in_tet([a, b, c, d, p]: &[[f64; 3]; 5]) -> Sign {
    let whole = orient3d_exact(a, b, c, d);
    if whole.is_zero() {
        let faces = [[b, c, d], [a, c, d], [a, b, d], [a, b, c]];
        let on = faces.into_iter().any(|face| point_in_hull(p, face));
        return if on { Sign::Zero } else { Sign::Negative };
    }
    // The least of the signs of the barycentric coordinates.
    let parts = [[p, b, c, d], [a, p, c, d], [a, b, p, d], [a, b, c, p]];
    parts.into_iter().map(|[a, b, c, d]| orient3d_exact(a, b, c, d) * whole).min().unwrap_or(Sign::Negative)
}
