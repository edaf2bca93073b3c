//! The MIPS energy of middle triangles (*Shell* section 3.4). Floats: quality, never a verdict.

use crate::construct::direction::{float_cross, float_dot};

/// The edges from the first corner to the others and between those, with the length that they are measured in, so that
/// no power of them over- or underflows.
fn edges([a, b, c]: [&[f64; 3]; 3]) -> ([[f64; 3]; 3], f64) {
    let edge = |p: &[f64; 3], q: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| q[i] - p[i]) };
    let all = [edge(a, b), edge(a, c), edge(b, c)];
    let size = all.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    (all.map(|e| e.map(|x| x / size)), size)
}

/// `tr(J^T J) / det J` of the affine map between the triangle and an equilateral one: 2 at best, invariant to scale.
/// Infinite for a triangle without area. In edges and area: `(a^2 + b^2 + c^2) / (2 sqrt(3) area)`.
pub(crate) fn mips(corners: [&[f64; 3]; 3]) -> f64 {
    let ([x, y, z], _) = edges(corners);
    let n = float_cross(&x, &y);
    let sides = float_dot(&x, &x) + float_dot(&y, &y) + float_dot(&z, &z);
    let energy = sides / (3f64.sqrt() * float_dot(&n, &n).sqrt());
    if energy.is_nan() { f64::INFINITY } else { energy }
}

/// The derivative of [`mips`] by its first corner.
pub(crate) fn gradient(corners: [&[f64; 3]; 3]) -> [f64; 3] {
    let ([x, y, z], size) = edges(corners);
    let n = float_cross(&x, &y);
    let double_area = float_dot(&n, &n).sqrt();
    let sides = float_dot(&x, &x) + float_dot(&y, &y) + float_dot(&z, &z);
    // The double area grows fastest away from the opposite edge: its derivative is n / |n| x (c - b).
    let grow = float_cross(&z, &n).map(|g| -g / double_area);
    let scale = 1.0 / (3f64.sqrt() * double_area * size);
    std::array::from_fn(|i| scale * (-2.0 * (x[i] + y[i]) - sides / double_area * grow[i]))
}
