//! Exact squared distances, and bounds on them over a triangle.
//!
//! The squared distance of a point `x` from a convex set is at most that from any point of it. For a triangle `T` with
//! corners `v`, triangles `S_i` of the mesh, points `q_iv` of `S_i` and weights `l_i >= 0` of sum 1, and `x = sum m_v v` in `T`:
//! the point `q_i = sum m_v q_iv` is in `S_i`, so
//!
//! `d(x)^2 <= min_i |x - q_i|^2 <= sum_i l_i |x - q_i|^2 <= sum_i l_i sum_v m_v |v - q_iv|^2 <= max_v sum_i l_i |v - q_iv|^2`,
//!
//! where `d` is the distance from the mesh and the third step is the convexity of the square. All of the right side is a
//! polynomial in input coordinates and weights, evaluated in integers and rounded up once.

use dashu_base::BitTest;
use dashu_int::{IBig, UBig};

use super::nearest::Nearest;
use crate::certify::exact::{Vec3, cross, dot, minus};
use crate::mesh::TriMesh;
use crate::number::dyadic::scale_points;
use crate::number::{Rat, Rational};
use crate::shell::Shell;

/// Weights in a middle triangle are multiples of `2^-GRID`.
pub(super) const GRID: u32 = 60;
/// Weights in a mesh triangle are multiples of `2^-FINE`.
const FINE: u32 = 52;
/// Weights of mixtures are multiples of `2^-MIX`.
const MIX: u32 = 30;

/// A point of a middle triangle: weights of its corners in units of `2^-GRID`, of sum 1.
pub(super) type Weights = [u64; 3];

/// Middle surface and mesh in integers.
pub(super) struct Scene<'a> {
    pub(super) shell: &'a Shell,
    pub(super) mesh: &'a TriMesh,
    pub(super) nearest: Nearest,
    /// Mesh vertices, then middle vertices, as multiples of `2^unit`.
    integers: Vec<Vec3>,
    unit: i32,
    /// All coordinates are below `2^size`.
    pub(super) size: i32,
}

/// One triangle of the mesh in a bound: its id, and the weights of its points for the three corners.
pub(super) type Candidate = (u32, [[f64; 3]; 3]);

impl<'a> Scene<'a> {
    /// Needs finite coordinates, and ids in range.
    pub(super) fn new(shell: &'a Shell, mesh: &'a TriMesh) -> Self {
        let all: Vec<[f64; 3]> = mesh.vertices.iter().chain(&shell.middle).copied().collect();
        let (integers, unit) = scale_points(&all);
        let bits = integers.iter().flatten().map(BitTest::bit_len).max().unwrap_or(0);
        let size = unit + i32::try_from(bits).unwrap_or(0);
        let corners = |f: &[u32; 3]| f.map(|v| mesh.vertices[v as usize].map(|x| times_power(x, -size)));
        let nearest = Nearest::new(mesh.faces.iter().map(corners));
        Self { shell, mesh, nearest, integers, unit, size }
    }

    /// The corners of a triangle of the mesh, in units of `2^size`. Floats.
    pub(super) fn triangle(&self, f: u32) -> [[f64; 3]; 3] {
        self.mesh.faces[f as usize]
            .map(|v| self.mesh.vertices[v as usize].map(|x| times_power(x, -self.size)))
    }

    /// A point of a middle triangle, in units of `2^size`. Floats.
    pub(super) fn float(&self, prism: u32, weights: &Weights) -> [f64; 3] {
        let corners = self.shell.faces[prism as usize]
            .map(|v| self.shell.middle[v as usize].map(|x| times_power(x, -self.size)));
        super::nearest::at(&corners, &weights.map(|w| times_power(w as f64, -GRID.cast_signed())))
    }

    /// The point in units of `2^(unit - GRID)`.
    pub(super) fn exact(&self, prism: u32, weights: &Weights) -> Vec3 {
        let first = self.mesh.vertices.len();
        mixed(self.shell.faces[prism as usize].map(|v| &self.integers[first + v as usize]), weights)
    }

    /// A coordinate of such a point.
    pub(super) fn coordinate(&self, x: &IBig) -> Rat {
        Rat::from(x.clone()).times(&Rat::from_scaled(1, self.unit - GRID.cast_signed()))
    }

    /// A bound on the squared distance over a triangle, see the module; in units of `4^size`.
    pub(super) fn bound(&self, corners: &[Vec3; 3], candidates: &[Candidate], mixture: &[f64]) -> f64 {
        let mixture = on_grid(mixture, MIX);
        let far = |v: usize| -> IBig {
            let one = |(l, (f, points)): (&u64, &Candidate)| {
                let triangle = self.mesh.faces[*f as usize].map(|u| &self.integers[u as usize]);
                let weights = on_grid(&points[v], FINE);
                let q = mixed(triangle, &[weights[0], weights[1], weights[2]])
                    .map(|x| x << (GRID - FINE) as usize);
                let d = minus(&corners[v], &q);
                dot(&d, &d) * IBig::from(*l)
            };
            mixture.iter().zip(candidates).filter(|(l, _)| **l > 0).map(one).sum()
        };
        let worst = (0..3).map(far).max().unwrap_or(IBig::ZERO);
        let exponent = 2 * (self.unit - GRID.cast_signed() - self.size) - MIX.cast_signed();
        rounded_up(&worst, exponent)
    }

    /// The exact squared distance of a point (in units of `2^(unit - GRID)`) from the mesh, and a triangle at that distance.
    /// `some` is any triangle, best a near one.
    pub(super) fn squared(&self, point: &Vec3, some: u32) -> (Rat, u32) {
        let mut best = (self.triangle_square(point, some), some);
        let normal = |x: &IBig| {
            let power = Rat::from_scaled(1, self.unit - GRID.cast_signed() - self.size);
            Rational::to_f64(&Rat::from(x.clone()).times(&power))
        };
        let root = Rational::to_f64(&self.normalised(&best.0)).next_up().sqrt().next_up();
        // A triangle that is nearer has a point in the box of half size `root` around the point: every rounding is outward.
        let low = [0, 1, 2].map(|i| (normal(&point[i]).next_down() - root).next_down());
        let high = [0, 1, 2].map(|i| (normal(&point[i]).next_up() + root).next_up());
        for f in self.nearest.meeting([low, high]) {
            let d = self.triangle_square(point, f);
            if d < best.0 {
                best = (d, f);
            }
        }
        (self.real(&best.0), best.1)
    }

    /// A square in units of `4^(unit - GRID)` as a real number.
    fn real(&self, square: &Rat) -> Rat {
        square.times(&Rat::from_scaled(1, 2 * (self.unit - GRID.cast_signed())))
    }

    fn normalised(&self, square: &Rat) -> Rat {
        square.times(&Rat::from_scaled(1, 2 * (self.unit - GRID.cast_signed() - self.size)))
    }

    fn triangle_square(&self, point: &Vec3, f: u32) -> Rat {
        let corner = |v: u32| -> Vec3 { self.integers[v as usize].clone().map(|x| x << GRID as usize) };
        let corners = self.mesh.faces[f as usize].map(corner);
        let sides = [[0, 1], [1, 2], [2, 0]].map(|[i, j]| [&corners[i], &corners[j]]);
        let normal = cross(&minus(&corners[1], &corners[0]), &minus(&corners[2], &corners[0]));
        let square = dot(&normal, &normal);
        let behind = |[p, q]: [&Vec3; 2]| dot(&cross(&minus(q, p), &minus(point, p)), &normal) < IBig::ZERO;
        if square > IBig::ZERO && !sides.iter().any(|s| behind(*s)) {
            let height = dot(&normal, &minus(point, &corners[0]));
            return quotient(&height * &height, square);
        }
        let least = sides.map(|[p, q]| segment_square(point, p, q)).into_iter().min();
        least.unwrap_or_else(Rat::zero)
    }
}

fn segment_square(point: &Vec3, p: &Vec3, q: &Vec3) -> Rat {
    let (along, from) = (minus(q, p), minus(point, p));
    let (t, length) = (dot(&along, &from), dot(&along, &along));
    if t <= IBig::ZERO {
        return Rat::from(dot(&from, &from));
    }
    if t >= length {
        let from = minus(point, q);
        return Rat::from(dot(&from, &from));
    }
    quotient(dot(&from, &from) * &length - &t * &t, length)
}

/// `a / b`; `b` is positive.
fn quotient(a: IBig, b: IBig) -> Rat {
    let (_, magnitude) = b.into_parts();
    if magnitude == UBig::ZERO { Rat::zero() } else { Rat::from_parts(a, magnitude) }
}

fn mixed(corners: [&Vec3; 3], weights: &[u64; 3]) -> Vec3 {
    [0, 1, 2].map(|i| (0..3).map(|k| &corners[k][i] * IBig::from(weights[k])).sum())
}

/// Weights as multiples of `2^-bits` of sum 1, whatever the floats are.
pub(super) fn on_grid(weights: &[f64], bits: u32) -> Vec<u64> {
    let one = 1u64 << bits;
    let good = |w: &f64| if w.is_finite() { w.clamp(0.0, 1.0) } else { 0.0 };
    let mut left = one;
    let mut out: Vec<u64> = Vec::with_capacity(weights.len());
    for w in weights {
        // Not negative; a cast of a float saturates.
        #[allow(clippy::cast_sign_loss)]
        let part = ((good(w) * one as f64) as u64).min(left);
        left -= part;
        out.push(part);
    }
    if let Some(largest) = out.iter_mut().max() {
        *largest += left;
    }
    out
}

/// `x * 2^power`, rounded by less than one ulp.
pub(super) fn times_power(x: f64, power: i32) -> f64 {
    let half = power / 2;
    x * 2f64.powi(half) * 2f64.powi(power - half)
}

/// At least `n * 2^exponent`, for a number that is not negative.
fn rounded_up(n: &IBig, exponent: i32) -> f64 {
    let shift = n.bit_len().saturating_sub(53);
    let head: IBig = n >> shift;
    // Rounded up to at most 2^53: exact as a float.
    let head = u64::try_from(&head).unwrap_or(u64::MAX) + u64::from(shift > 0);
    if head == 0 {
        return 0.0;
    }
    // Rounded by less than one ulp.
    times_power(head as f64, exponent.saturating_add(i32::try_from(shift).unwrap_or(i32::MAX))).next_up()
}
