//! Extrusion directions: per vertex the direction that maximises the smallest dot product with the incident face
//! normals (*Shell* section 3.3, problem (3)), found in floats and then proved.

use dashu_int::IBig;

use super::fixed;
use crate::certify::exact::{Vec3, cross, dot, minus};
use crate::mesh::{Connectivity, TriMesh};
use crate::number::dyadic::scale_points;
use crate::predicate::dot_sign;

/// The direction of a vertex.
#[derive(Clone, Debug, PartialEq)]
pub enum Direction {
    /// A unit vector (up to rounding) whose exact dot products with all exact incident normals are positive.
    Proved([f64; 3]),
    /// No direction exists: a nonnegative combination of incident normals vanishes.
    Singular(Farkas),
    /// Neither a direction nor a proof of singularity was found in `f64`; treated like a singular vertex.
    Undecided,
    /// No triangle uses the vertex.
    Unused,
}

/// `sum weight_i * normal_i = 0` with positive weights: no vector has positive dots with all these normals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Farkas {
    /// Triangles, at least two and at most four.
    pub faces: Vec<u32>,
    /// Weights of their exact normals `(b - a) x (c - a)`.
    pub weights: Vec<IBig>,
}

/// Directions of all vertices. Expected linear time for bounded valence.
#[must_use]
pub fn directions(mesh: &TriMesh, connectivity: &Connectivity) -> Vec<Direction> {
    use rayon::prelude::*;
    let vertices: Vec<u32> = (0..mesh.vertices.len()).map(|v| u32::try_from(v).unwrap_or(u32::MAX)).collect();
    vertices
        .par_iter()
        .map(|&v| {
            let faces: Vec<u32> = connectivity.star(v).iter().map(|c| c.face()).collect();
            direction(mesh, &faces)
        })
        .collect()
}

/// A direction for a vertex that suits these triangles, too, if there is one: what an edge that cannot be split wants,
/// because the prism on it touches all triangles at both ends.
pub(crate) fn direction_for(mesh: &TriMesh, faces: &[u32]) -> Option<[f64; 3]> {
    let normals: Vec<[f64; 3]> = faces.iter().map(|&f| float_normal(corners(mesh, f))).collect();
    let proved = |d: &[f64; 3]| is_proved(mesh, faces, d);
    most_normal(&normals).filter(proved).or_else(|| fixed::most_normal(mesh, faces).filter(proved))
}

fn corners(mesh: &TriMesh, face: u32) -> [&[f64; 3]; 3] {
    mesh.faces[face as usize].map(|v| &mesh.vertices[v as usize])
}

/// The direction of a vertex with these incident triangles.
pub(crate) fn direction(mesh: &TriMesh, faces: &[u32]) -> Direction {
    if faces.is_empty() {
        return Direction::Unused;
    }
    let normals: Vec<[f64; 3]> = faces.iter().map(|&f| float_normal(corners(mesh, f))).collect();
    let candidate = most_normal(&normals).into_iter().chain([mean(&normals)]);
    for d in candidate {
        if is_proved(mesh, faces, &d) {
            return Direction::Proved(d);
        }
    }
    if let Some(proof) = farkas(mesh, faces) {
        return Direction::Singular(proof);
    }
    let careful = fixed::most_normal(mesh, faces).filter(|d| is_proved(mesh, faces, d));
    careful.map_or(Direction::Undecided, Direction::Proved)
}

/// Does the vector have a positive exact dot product with the normals of all faces?
pub(crate) fn is_proved(mesh: &TriMesh, faces: &[u32], d: &[f64; 3]) -> bool {
    d.iter().all(|x| x.is_finite())
        && faces.iter().all(|&f| {
            let [a, b, c] = corners(mesh, f);
            dot_sign(a, b, c, &[0.0; 3], d).is_positive()
        })
}

pub(crate) fn float_dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn float_cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The vector with length one; the zero vector stays.
pub(crate) fn unit(v: [f64; 3]) -> [f64; 3] {
    // Scaled first, so that tiny and huge vectors neither vanish nor overflow.
    let largest = v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if largest <= 0.0 || !largest.is_finite() {
        return [0.0; 3];
    }
    let scaled = v.map(|x| x / largest);
    let length = float_dot(&scaled, &scaled).sqrt();
    scaled.map(|x| x / length)
}

/// The unit normal of a triangle in floats, whatever its size.
pub(crate) fn float_normal([a, b, c]: [&[f64; 3]; 3]) -> [f64; 3] {
    let edge = |p: &[f64; 3]| unit([p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    unit(float_cross(&edge(b), &edge(c)))
}

fn mean(normals: &[[f64; 3]]) -> [f64; 3] {
    unit(normals.iter().fold([0.0; 3], |s, n| [s[0] + n[0], s[1] + n[1], s[2] + n[2]]))
}

/// The shortest `x` with `n . x >= 1` for all unit normals, as a direction: an LP-type problem with at most three
/// tight constraints, solved incrementally.
pub(crate) fn most_normal(normals: &[[f64; 3]]) -> Option<[f64; 3]> {
    // The slack only decides which candidate is tried; the proof is exact.
    let fits = |x: &[f64; 3], n: &[f64; 3]| float_dot(x, n) >= 1.0 - 1e-12;
    let mut x = *normals.first()?;
    for i in 1..normals.len() {
        if fits(&x, &normals[i]) {
            continue;
        }
        x = normals[i];
        for j in 0..i {
            if fits(&x, &normals[j]) {
                continue;
            }
            x = tight_on_two(&normals[i], &normals[j])?;
            for k in 0..j {
                if !fits(&x, &normals[k]) {
                    x = tight_on_three(&normals[i], &normals[j], &normals[k])?;
                }
            }
        }
    }
    Some(unit(x))
}

fn tight_on_two(a: &[f64; 3], b: &[f64; 3]) -> Option<[f64; 3]> {
    let sum = [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    let height = float_dot(&sum, a);
    (height > 0.0).then(|| sum.map(|x| x / height))
}

fn tight_on_three(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Option<[f64; 3]> {
    let parts = [float_cross(b, c), float_cross(c, a), float_cross(a, b)];
    let volume = float_dot(a, &parts[0]);
    let sum: [f64; 3] = std::array::from_fn(|i| parts[0][i] + parts[1][i] + parts[2][i]);
    (volume != 0.0).then(|| sum.map(|x| x / volume))
}

/// How many normals are searched for a proof of singularity; beyond, the number of quadruples explodes.
const MAX_VALENCE: usize = 48;

/// A proof that no direction exists, by Carathéodory on at most four exact normals.
fn farkas(mesh: &TriMesh, faces: &[u32]) -> Option<Farkas> {
    if faces.len() > MAX_VALENCE {
        return None;
    }
    let points: Vec<[f64; 3]> = faces.iter().flat_map(|&f| corners(mesh, f)).copied().collect();
    let (x, _) = scale_points(&points);
    let normals: Vec<Vec3> =
        x.chunks_exact(3).map(|t| cross(&minus(&t[1], &t[0]), &minus(&t[2], &t[0]))).collect();
    let n = normals.len();
    let found = |chosen: &[usize]| {
        let weights = vanishing(&chosen.iter().map(|&i| &normals[i]).collect::<Vec<_>>())?;
        Some(Farkas { faces: chosen.iter().map(|&i| faces[i]).collect(), weights })
    };
    let pairs = || (0..n).flat_map(move |i| (i + 1..n).map(move |j| [i, j]));
    let triples = || pairs().flat_map(move |[i, j]| (j + 1..n).map(move |k| [i, j, k]));
    let quadruples = triples().flat_map(move |[i, j, k]| (k + 1..n).map(move |l| [i, j, k, l]));
    pairs().find_map(|c| found(&c)).or_else(|| triples().find_map(|c| found(&c))).or_else(|| {
        let mut quadruples = quadruples;
        quadruples.find_map(|c| found(&c))
    })
}

/// Positive weights with which two, three or four vectors sum to zero, if they are unique up to scale.
fn vanishing(vectors: &[&Vec3]) -> Option<Vec<IBig>> {
    let zero = |v: &Vec3| v.iter().all(|x| *x == IBig::ZERO);
    let weights: Vec<IBig> = match vectors {
        [a, b] => {
            if !zero(&cross(a, b)) {
                return None;
            }
            // Antiparallel: weigh each by the other's size along a common axis.
            let axis = (0..3).find(|&i| a[i] != IBig::ZERO)?;
            let sign = if a[axis] > IBig::ZERO { IBig::ONE } else { -IBig::ONE };
            vec![-&b[axis] * &sign, &a[axis] * &sign]
        }
        [a, b, c] => {
            let normal = cross(a, b);
            if zero(&normal) || dot(&normal, c) != IBig::ZERO {
                return None;
            }
            vec![dot(&normal, &cross(b, c)), dot(&normal, &cross(c, a)), dot(&normal, &normal)]
        }
        [a, b, c, d] => {
            let det = |u: &Vec3, v: &Vec3, w: &Vec3| dot(&cross(u, v), w);
            let w = [det(b, c, d), -det(a, c, d), det(a, b, d), -det(a, b, c)];
            if w[0] < IBig::ZERO { w.map(|x| -x).to_vec() } else { w.to_vec() }
        }
        _ => return None,
    };
    weights.iter().all(|w| *w > IBig::ZERO).then_some(weights)
}

impl Farkas {
    /// Does the combination vanish, with positive weights?
    #[must_use]
    pub fn holds(&self, mesh: &TriMesh) -> bool {
        let points: Vec<[f64; 3]> = self.faces.iter().flat_map(|&f| corners(mesh, f)).copied().collect();
        let (x, _) = scale_points(&points);
        let normals = x.chunks_exact(3).map(|t| cross(&minus(&t[1], &t[0]), &minus(&t[2], &t[0])));
        let mut sum = [IBig::ZERO, IBig::ZERO, IBig::ZERO];
        for (n, w) in normals.zip(&self.weights) {
            sum = std::array::from_fn(|i| &sum[i] + &n[i] * w);
        }
        !self.faces.is_empty()
            && self.faces.len() == self.weights.len()
            && self.weights.iter().all(|w| *w > IBig::ZERO)
            && sum.iter().all(|x| *x == IBig::ZERO)
    }
}
