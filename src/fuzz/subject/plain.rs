//! The textbook formulas in doubles: what most programs have, and what exact predicates are for.

use super::builtin::prism_by;
use crate::fuzz::points::points;
use crate::fuzz::{Answer, Predicate};

type Point = [f64; 3];

fn minus(p: Point, q: Point) -> Point {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn dot(p: Point, q: Point) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

fn cross(p: Point, q: Point) -> Point {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn volume(a: Point, b: Point, c: Point, d: Point) -> f64 {
    dot(cross(minus(b, a), minus(c, a)), minus(d, a))
}

/// The answer by rounded arithmetic.
pub(super) fn answer(predicate: Predicate, case: &[f64]) -> Option<Answer> {
    Some(match predicate {
        Predicate::Orient2d => {
            let [a, b, c]: [[f64; 2]; 3] = points(case)?;
            Answer::of_value((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        }
        Predicate::Orient3d => {
            let [a, b, c, d] = points(case)?;
            Answer::of_value(volume(a, b, c, d))
        }
        Predicate::Incircle => Answer::of_value(circle(points(case)?)),
        Predicate::Insphere => Answer::of_value(sphere(points(case)?)),
        Predicate::DotSign => {
            let [a, b, c, d, e] = points(case)?;
            Answer::of_value(dot(cross(minus(b, a), minus(c, a)), minus(e, d)))
        }
        Predicate::PointInTet => point_in_tet(points(case)?),
        Predicate::SegmentTriangle => {
            let [s, t, a, b, c] = points(case)?;
            Answer::of_truth(hit([s, t], [a, b, c]).is_some_and(|at| at <= 1.0))
        }
        Predicate::RayTriangle => {
            let [s, t, a, b, c] = points(case)?;
            Answer::of_truth(hit([s, t], [a, b, c]).is_some())
        }
        Predicate::TriangleTriangle => {
            let [a, b, c, d, e, f] = points(case)?;
            let edges = |[a, b, c]: [Point; 3]| [[a, b], [b, c], [c, a]];
            let crosses =
                |one, other| edges(one).into_iter().any(|e| hit(e, other).is_some_and(|at| at <= 1.0));
            Answer::of_truth(crosses([a, b, c], [d, e, f]) || crosses([d, e, f], [a, b, c]))
        }
        Predicate::PrismPositivity => prism_by(case, |a, b, c, d| Answer::of_value(volume(a, b, c, d)))?,
        Predicate::SectionDot => {
            let p: [Point; 9] = points(case)?;
            let normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
            let dots = [0, 1, 2].map(|i| dot(normal, minus(p[6 + i], p[3 + i])));
            Answer::of_value(if dots.iter().any(|x| x.is_nan()) {
                f64::NAN
            } else {
                dots.into_iter().fold(f64::INFINITY, f64::min)
            })
        }
    })
}

fn circle([a, b, c, d]: [[f64; 2]; 4]) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| {
        let (x, y) = (p[0] - d[0], p[1] - d[1]);
        [x, y, x * x + y * y]
    });
    dot(a, cross(b, c))
}

fn sphere([a, b, c, d, e]: [Point; 5]) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|p| minus(p, e));
    let det = |p, q, r| dot(p, cross(q, r));
    dot(a, a) * det(b, c, d) - dot(b, b) * det(a, c, d) + dot(c, c) * det(a, b, d) - dot(d, d) * det(a, b, c)
}

fn point_in_tet([a, b, c, d, p]: [Point; 5]) -> Answer {
    let whole = volume(a, b, c, d);
    let parts = [volume(p, b, c, d), volume(a, p, c, d), volume(a, b, p, d), volume(a, b, c, p)];
    let shares = parts.map(|part| part / whole);
    if shares.iter().any(|x| x.is_nan()) {
        return Answer::Nan;
    }
    Answer::of_value(shares.into_iter().fold(f64::INFINITY, f64::min))
}

/// Where a ray hits a triangle (0 at its first point, 1 at its second), by Möller and Trumbore.
fn hit([s, t]: [Point; 2], [a, b, c]: [Point; 3]) -> Option<f64> {
    let (along, u, v) = (minus(t, s), minus(b, a), minus(c, a));
    let p = cross(along, v);
    let scale = 1.0 / dot(u, p);
    let from = minus(s, a);
    let x = dot(from, p) * scale;
    let q = cross(from, u);
    let y = dot(along, q) * scale;
    let at = dot(v, q) * scale;
    (x >= 0.0 && y >= 0.0 && x + y <= 1.0 && at >= 0.0).then_some(at)
}
