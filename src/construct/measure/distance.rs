//! The largest distance from the middle surface to the mesh, enclosed: branch and bound (`bound.rs` has the proof).
//!
//! Floats choose where to look and what to compare with. Both ends of the enclosure are exact: the lower one is the
//! distance of a point of the middle surface, the upper one is a bound over triangles that cover it.

use rayon::prelude::*;

use super::bound::{Candidate, GRID, Scene, Weights, on_grid, times_power};
use super::game::mix;
use super::nearest::{at, closest, squared};
use crate::certify::{CertifyError, Observer};
use crate::construct::BuildError;
use crate::mesh::{self, TriMesh};
use crate::number::{Rat, Rational};
use crate::shell::{Shell, validate};

/// The relative width that is aimed at, a little less than what is promised.
const WIDTH: f64 = 0.9e-6;
/// In units of the size of the coordinates: less is not aimed at.
const LEAST_WIDTH: f64 = 1.0 / (1u64 << 48) as f64;
/// How many pieces are judged at most. What is left then makes the enclosure wider, not wrong.
const MOST: usize = 30_000_000;
/// How many triangles of the mesh a piece is compared with at most.
const CANDIDATES: usize = 6;

/// The one-sided Hausdorff distance from middle surface to mesh, enclosed.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    /// The exact square of the distance of the witness: a lower bound, attained.
    pub squared_at_least: Rat,
    /// No point of the middle surface is further: a square, exact.
    pub squared_at_most: Rat,
    /// The lower bound, rounded down.
    pub at_least: f64,
    /// The upper bound, rounded up.
    pub at_most: f64,
    /// Where the lower bound is attained.
    pub witness: Witness,
}

/// A point of the middle surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// Its prism.
    pub prism: u32,
    /// Its weights on the corners of the middle triangle.
    pub weights: [Rat; 3],
    /// The point.
    pub point: [Rat; 3],
    /// A triangle of the mesh at this distance.
    pub triangle: u32,
}

/// A piece of a middle triangle.
#[derive(Clone, Copy)]
struct Piece {
    prism: u32,
    corners: [Weights; 3],
    /// Triangles of the mesh near to the corners.
    near: [u32; 3],
}

/// What is known about a piece: a bound, and its point that seems furthest from the mesh.
struct Judged {
    bound: f64,
    far: Weights,
    guess: f64,
    near: u32,
}

/// Encloses the largest distance from a point of the middle surface to the mesh. The relative width is at most `1e-6`, as
/// long as it is more than `2^-48` of the largest coordinate and no more than 30 million pieces are needed; otherwise the
/// enclosure is wider, and right. Time grows with the area in units of the squared distance.
///
/// # Errors
/// [`BuildError::Mesh`] and [`BuildError::Certify`] where mesh or shell break the input conditions (THEORY section 1), or
/// if the observer ends the work.
pub fn distance(shell: &Shell, mesh: &TriMesh, observer: &dyn Observer) -> Result<Distance, BuildError> {
    mesh::check(mesh)?;
    validate::validate(shell).map_err(CertifyError::from)?;
    observer.stage("distance", None);
    let scene = Scene::new(shell, mesh);
    let mut pieces = whole(&scene);
    let mut search = Search { scene, lower: None, lower_float: -1.0, upper: 0.0 };
    let mut judged = 0;
    while !pieces.is_empty() {
        if observer.cancelled() {
            return Err(CertifyError::Cancelled.into());
        }
        let known: Vec<Judged> = pieces.par_iter().map(|p| search.judge(p)).collect();
        judged += pieces.len();
        observer.advance(pieces.len() as u64);
        search.raise(&pieces, &known);
        pieces = search.rest(&pieces, &known, judged < MOST);
    }
    search.enclosure()
}

/// The middle triangles.
fn whole(scene: &Scene<'_>) -> Vec<Piece> {
    let one = 1u64 << GRID;
    let corners = [[one, 0, 0], [0, one, 0], [0, 0, one]];
    let piece = |prism: u32| {
        let near = corners.map(|c| scene.nearest.to(&scene.float(prism, &c)).map_or(0, |n| n.0));
        Piece { prism, corners, near }
    };
    let count = u32::try_from(scene.shell.faces.len()).unwrap_or(u32::MAX);
    (0..count).into_par_iter().map(piece).collect()
}

struct Search<'a> {
    scene: Scene<'a>,
    /// The exact square at the best witness, with its place.
    lower: Option<(Rat, u32, Weights, u32)>,
    /// That square in units of `4^size`, about.
    lower_float: f64,
    /// The largest bound of a piece that is done with, in units of `4^size`.
    upper: f64,
}

impl Search<'_> {
    fn judge(&self, piece: &Piece) -> Judged {
        let corners = piece.corners.map(|c| self.scene.float(piece.prism, &c));
        let mut candidates: Vec<Candidate> = Vec::new();
        let add = |f: u32, to: &mut Vec<Candidate>| {
            let new = to.iter().all(|c| c.0 != f);
            if new {
                let triangle = self.scene.triangle(f);
                to.push((f, corners.map(|c| closest(&triangle, &c))));
            }
            new
        };
        piece.near.iter().for_each(|&f| _ = add(f, &mut candidates));
        loop {
            let payoff = |v: usize, c: usize| {
                let (f, points) = &candidates[c];
                squared(&corners[v], &at(&self.scene.triangle(*f), &points[v]))
            };
            let table: Vec<[f64; 3]> =
                (0..candidates.len()).map(|c| [0, 1, 2].map(|v| payoff(v, c))).collect();
            // The point where the least of the candidates' distances is largest, if they were linear.
            let (far, _) = mix(3, table.len(), |c, v| -table[c][v]);
            let far = point_between(piece, &far);
            let (near, guess) =
                self.scene.nearest.to(&self.scene.float(piece.prism, &far)).unwrap_or_default();
            if candidates.len() < CANDIDATES && add(near, &mut candidates) {
                continue;
            }
            let (mixture, _) = mix(table.len(), 3, |v, c| table[c][v]);
            let exact = piece.corners.map(|c| self.scene.exact(piece.prism, &c));
            let bound = self.scene.bound(&exact, &candidates, &mixture);
            return Judged { bound, far, guess, near };
        }
    }

    /// Raises the lower bound to the distance of the point that seems furthest.
    fn raise(&mut self, pieces: &[Piece], known: &[Judged]) {
        let best = pieces.iter().zip(known).max_by(|a, b| a.1.guess.total_cmp(&b.1.guess));
        let Some((piece, seen)) = best.filter(|(_, seen)| seen.guess > self.lower_float) else { return };
        let (square, triangle) = self.scene.squared(&self.scene.exact(piece.prism, &seen.far), seen.near);
        if self.lower.as_ref().is_none_or(|lower| square > lower.0) {
            self.lower_float = Rational::to_f64(&square.times(&Rat::from_scaled(1, -2 * self.scene.size)));
            self.lower = Some((square, piece.prism, seen.far, triangle));
        }
    }

    /// The pieces that may hold points further than the lower bound, cut in two; the others are done with.
    fn rest(&mut self, pieces: &[Piece], known: &[Judged], go_on: bool) -> Vec<Piece> {
        let root = self.lower_float.max(0.0).sqrt();
        let enough = (root * (1.0 + WIDTH)).max(root + LEAST_WIDTH).powi(2);
        let mut out = Vec::new();
        for (piece, seen) in pieces.iter().zip(known) {
            let parts = if go_on && seen.bound > enough { self.cut(piece) } else { None };
            match parts {
                Some(parts) => out.extend(parts),
                None => self.upper = self.upper.max(seen.bound),
            }
        }
        out
    }

    /// In two at the middle of the longest side; `None` where the grid ends.
    fn cut(&self, piece: &Piece) -> Option<[Piece; 2]> {
        let points = piece.corners.map(|c| self.scene.float(piece.prism, &c));
        let long = |k: &usize| squared(&points[*k], &points[(k + 1) % 3]);
        let k = (0..3).max_by(|i, j| long(i).total_cmp(&long(j)))?;
        let (i, j) = (k, (k + 1) % 3);
        let sum = [0, 1, 2].map(|x| piece.corners[i][x] + piece.corners[j][x]);
        if sum.iter().any(|s| s % 2 == 1) {
            return None;
        }
        let middle = sum.map(|s| s / 2);
        let near = self.scene.nearest.to(&self.scene.float(piece.prism, &middle))?.0;
        Some([i, j].map(|end| {
            let mut part = *piece;
            part.corners[end] = middle;
            part.near[end] = near;
            part
        }))
    }

    fn enclosure(self) -> Result<Distance, BuildError> {
        // A valid shell has a prism, whose bound was compared with its own point.
        let lost = |what| CertifyError::Internal { what };
        let (low, prism, weights, triangle) = self.lower.ok_or_else(|| lost("a distance without a point"))?;
        let size = self.scene.size;
        let upper = Rat::from_f64(self.upper).ok_or_else(|| lost("a distance without a bound"))?;
        let high = upper.times(&Rat::from_scaled(1, 2 * size));
        let high = high.max(low.clone());
        let point = self.scene.exact(prism, &weights);
        Ok(Distance {
            at_least: root(&low, size, false),
            at_most: root(&high, size, true),
            squared_at_least: low,
            squared_at_most: high,
            witness: Witness {
                prism,
                weights: weights.map(|w| Rat::from(w).times(&Rat::from_scaled(1, -GRID.cast_signed()))),
                point: [0, 1, 2].map(|i| self.scene.coordinate(&point[i])),
                triangle,
            },
        })
    }
}

/// The point of a piece with these weights on its corners, rounded to the grid.
fn point_between(piece: &Piece, weights: &[f64]) -> Weights {
    // 2^-30 of a corner, a multiple of 2^-60 of the triangle's, is dropped; the rest goes to the first corner's.
    let parts = on_grid(weights, 30);
    let [w0, w1, w2] = [0, 1, 2].map(|k| parts.get(k).copied().unwrap_or(0));
    let one = 1u64 << GRID;
    let mixed = |x: usize| {
        let part = |w: u64, k: usize| u128::from(w) * u128::from(piece.corners[k][x]);
        u64::try_from((part(w0, 0) + part(w1, 1) + part(w2, 2)) >> 30).unwrap_or(0)
    };
    let (a, b) = (mixed(0).min(one), mixed(1));
    let b = b.min(one - a);
    [a, b, one - a - b]
}

/// The square root in whole floats, rounded down or up: the float is compared exactly.
fn root(square: &Rat, size: i32, up: bool) -> f64 {
    let normal = Rational::to_f64(&square.times(&Rat::from_scaled(1, -2 * size)));
    let start = if up && !square.is_zero() { normal.max(f64::MIN_POSITIVE) } else { normal };
    let mut out = times_power(start.sqrt(), size);
    // Roundings so far are less than three ulps, except among subnormal numbers.
    for _ in 0..8 {
        let Some(x) = Rat::from_f64(out) else { break };
        let other = x.times(&x);
        let wrong = if up { other < *square } else { other > *square };
        if !wrong {
            return out;
        }
        out = if up { out.next_up() } else { out.next_down() };
    }
    if up { f64::INFINITY } else { 0.0 }
}
