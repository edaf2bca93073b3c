//! Winding numbers of a closed surface about a point, counted along a ray (THEORY rule R4).

use dashu_int::IBig;

use super::super::CertifyError;
use super::super::exact::{Vec3, cross, dot, minus, sign};
use crate::mesh::TriMesh;
use crate::number::dyadic::scale_points;
use crate::predicate::Sign;

/// Which of the two surfaces a ray starts on; it is counted against the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whose {
    /// The inner mesh.
    A,
    /// The cage.
    B,
}

/// A ray from a vertex, and what it crosses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ray {
    /// The surface that the vertex is of.
    pub whose: Whose,
    /// The vertex that the ray starts at.
    pub vertex: u32,
    /// Its direction.
    pub direction: [i32; 3],
    /// The triangles of the other surface that it crosses, ascending; each in its interior.
    pub triangles: Vec<u32>,
    /// Winding number of the other surface about the vertex.
    pub number: i64,
}

/// How a ray and a triangle lie.
enum Hit {
    Apart,
    /// In the interior, with the sign of `normal . direction`.
    Proper(i64),
    /// On an edge or vertex, or along the plane: another direction is needed.
    Degenerate,
}

/// More directions than could all be degenerate without reason: each edge excludes a plane of directions.
const DIRECTIONS: u32 = 4096;

/// The `k`-th direction: a fixed sequence that visits ever new directions.
fn direction(k: u32) -> [i32; 3] {
    let term = |seed: u64| {
        let x = (u64::from(k) + 1).wrapping_mul(seed) >> 7;
        i32::try_from(x % 2003).unwrap_or(0) - 1001
    };
    let d = [term(2_654_435_761), term(40_503_551_113), term(97_531_246_813)];
    if d == [0; 3] { [1, 2, 3] } else { d }
}

/// A ray that starts at a vertex and crosses every triangle of the other surface properly or not at all.
///
/// # Errors
/// [`CertifyError::Internal`] if there is none among the directions tried: the vertex lies on the other surface.
pub(super) fn cast(whose: Whose, vertex: u32, from: &TriMesh, other: &TriMesh) -> Result<Ray, CertifyError> {
    let start = from.vertices[vertex as usize];
    (0..DIRECTIONS)
        .find_map(|k| along(whose, vertex, &start, direction(k), other))
        .ok_or(CertifyError::Internal { what: "no ray in general position" })
}

fn along(whose: Whose, vertex: u32, start: &[f64; 3], direction: [i32; 3], other: &TriMesh) -> Option<Ray> {
    let mut ray = Ray { whose, vertex, direction, triangles: Vec::new(), number: 0 };
    for (f, face) in other.faces.iter().enumerate() {
        let corners = face.map(|v| other.vertices[v as usize]);
        if wholly_behind(start, direction, &corners) {
            continue;
        }
        match hit(start, direction, &corners) {
            Hit::Apart => {}
            Hit::Proper(sign) => {
                ray.triangles.push(u32::try_from(f).ok()?);
                ray.number += sign;
            }
            Hit::Degenerate => return None,
        }
    }
    Some(ray)
}

/// Is there a coordinate in which the ray only moves away from all corners? Comparisons of stored numbers: exact.
fn wholly_behind(start: &[f64; 3], direction: [i32; 3], corners: &[[f64; 3]; 3]) -> bool {
    (0..3).any(|i| {
        let (up, down) = (direction[i] >= 0, direction[i] <= 0);
        (up && corners.iter().all(|c| c[i] < start[i])) || (down && corners.iter().all(|c| c[i] > start[i]))
    })
}

fn hit(start: &[f64; 3], direction: [i32; 3], corners: &[[f64; 3]; 3]) -> Hit {
    let (x, _) = scale_points(&[*start, corners[0], corners[1], corners[2]]);
    let d: Vec3 = direction.map(IBig::from);
    let [a, b, c] = [1, 2, 3].map(|i| minus(&x[i], &x[0]));
    let sides = [(&a, &b), (&b, &c), (&c, &a)].map(|(p, q)| sign(&dot(&d, &cross(p, q))));
    let away = |s: Sign| sides.contains(&s);
    // The line passes the triangle on one side of two different edges.
    if away(Sign::Positive) && away(Sign::Negative) {
        return Hit::Apart;
    }
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    let (steep, height) = (sign(&dot(&normal, &d)), sign(&dot(&normal, &a)));
    if steep.is_zero() {
        return if height.is_zero() { Hit::Degenerate } else { Hit::Apart };
    }
    // The plane is met at `t = height / steep`.
    match height * steep {
        Sign::Negative => Hit::Apart,
        Sign::Zero => Hit::Degenerate,
        Sign::Positive if away(Sign::Zero) => Hit::Degenerate,
        Sign::Positive => Hit::Proper(if steep.is_positive() { 1 } else { -1 }),
    }
}
