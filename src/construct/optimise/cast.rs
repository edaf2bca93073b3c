//! Where a pillar crosses the mesh. Floats: the result is a proposal that the invariants judge.

use super::invariants::Judge;
use super::tree::Box3;
use crate::construct::direction::{float_cross, float_dot};

/// Visits the crossings of the open segment from `bottom` to `top` with the mesh, triangles widened by `slack`: the share
/// of the way, and whether it comes from behind.
fn visit(judge: &Judge<'_>, [bottom, top]: [&[f64; 3]; 2], slack: f64, mut found: impl FnMut(f64, bool)) {
    let minus = |p: &[f64; 3], q: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| p[i] - q[i]) };
    let d = minus(top, bottom);
    judge.tree.all(&Box3::of([bottom, top]), |f| {
        let [a, b, c] = judge.corners(f);
        let (e1, e2) = (minus(b, a), minus(c, a));
        let p = float_cross(&d, &e2);
        let volume = float_dot(&e1, &p);
        let s = minus(bottom, a);
        let q = float_cross(&s, &e1);
        let (u, v, t) = (float_dot(&s, &p) / volume, float_dot(&d, &q) / volume, float_dot(&e2, &q) / volume);
        if u >= -slack && v >= -slack && u + v <= 1.0 + slack && t > 0.0 && t < 1.0 {
            // det(e1, d, e2) = -(e1 x e2) . d: negative where the segment comes from behind.
            found(t, volume < 0.0);
        }
        true
    });
}

/// The share of the way from `bottom` to `top` at which the segment crosses the mesh from behind, the crossing nearest
/// to the share `guess` if there are several.
fn crossing(judge: &Judge<'_>, bottom: &[f64; 3], top: &[f64; 3], guess: f64) -> Option<f64> {
    let mut best: Option<f64> = None;
    visit(judge, [bottom, top], 1e-9, |t, from_behind| {
        if from_behind && best.is_none_or(|b| (t - guess).abs() < (b - guess).abs()) {
            best = Some(t);
        }
    });
    best
}

/// How often the segment crosses the mesh, from behind counted positive, else negative.
pub(crate) fn crossings(judge: &Judge<'_>, bottom: &[f64; 3], top: &[f64; 3]) -> i32 {
    let mut sum = 0;
    visit(judge, [bottom, top], 0.0, |_, from_behind| sum += if from_behind { 1 } else { -1 });
    sum
}

/// The point where a new pillar crosses the mesh, rounded; where none is found, the point at the share `guess`.
pub(crate) fn middle(judge: &Judge<'_>, bottom: &[f64; 3], top: &[f64; 3], guess: f64) -> [f64; 3] {
    let t = crossing(judge, bottom, top, guess).unwrap_or(guess);
    std::array::from_fn(|i| bottom[i] + t * (top[i] - bottom[i]))
}

/// The share of the way from `bottom` to `top` that is nearest to a point.
pub(crate) fn share(bottom: &[f64; 3], top: &[f64; 3], at: &[f64; 3]) -> f64 {
    let (d, p): ([f64; 3], [f64; 3]) =
        (std::array::from_fn(|i| top[i] - bottom[i]), std::array::from_fn(|i| at[i] - bottom[i]));
    let share = float_dot(&p, &d) / float_dot(&d, &d);
    if share.is_nan() { 0.5 } else { share.clamp(0.05, 0.95) }
}
