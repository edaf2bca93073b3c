//! The map between two meshes.

use super::chart::{Chart, Hit};
use super::exact::{Big3, in_ratio, middle_of, sign};
use super::near::Near;
use super::piece::{Piece, Place};
use super::point::{ExactPoint, in_same_ratio};
use crate::mesh::TriMesh;
use crate::predicate::Sign;
use crate::projection::{MAX_ERROR, Projection, SectionError};

/// `P_B^-1 P_A` and its inverse for two meshes `A`, `B` in one shell.
///
/// Answers are canonical: of the triangles that share a point, the one with the smallest number.
#[derive(Debug)]
pub struct Transfer<'a> {
    source: Chart<'a>,
    target: Chart<'a>,
}

/// A point of a mesh, rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatMeshPoint {
    /// The triangle of the exact answer.
    pub face: u32,
    /// Weights on its corners, 0 wherever the exact weight is 0; their sum is near 1.
    pub weights: [f64; 3],
    /// Each weight differs from the exact one by at most this; never above
    /// [`MAX_ERROR`](crate::projection::MAX_ERROR).
    pub error: f64,
}

impl<'a> Transfer<'a> {
    /// Cuts both meshes by the tets of the shell; `O(n log n)` for `n` pieces. Uses rayon's threads.
    ///
    /// # Errors
    /// [`SectionError::Mesh`]: a coordinate is not finite, a corner is out of range, too many triangles.
    pub fn new(projection: &'a Projection<'a>, a: &'a TriMesh, b: &'a TriMesh) -> Result<Self, SectionError> {
        Ok(Self { source: Chart::new(projection, a)?, target: Chart::new(projection, b)? })
    }

    /// The mesh `A`.
    #[must_use]
    pub fn source(&self) -> &'a TriMesh {
        self.source.place.mesh
    }

    /// The mesh `B`.
    #[must_use]
    pub fn target(&self) -> &'a TriMesh {
        self.target.place.mesh
    }

    /// The number of pieces into which the tets cut `A` and `B`.
    #[must_use]
    pub fn pieces(&self) -> [usize; 2] {
        [self.source.len(), self.target.len()]
    }

    /// The point of `B` for a point of `A`, exactly.
    ///
    /// # Errors
    /// [`SectionError`]: no such triangle; no image, or several.
    pub fn forward(&self, point: &ExactPoint) -> Result<ExactPoint, SectionError> {
        carry(&self.source, &self.target, point)
    }

    /// The point of `A` for a point of `B`, exactly.
    ///
    /// # Errors
    /// As [`forward`](Self::forward).
    pub fn backward(&self, point: &ExactPoint) -> Result<ExactPoint, SectionError> {
        carry(&self.target, &self.source, point)
    }

    /// The point of `B` for a point of `A` whose weights are exactly in the given ratio, rounded.
    ///
    /// # Errors
    /// As [`forward`](Self::forward), and a weight that is negative or not finite, or all zero.
    pub fn forward_f64(&self, face: u32, weights: [f64; 3]) -> Result<FloatMeshPoint, SectionError> {
        carry_f64(&self.source, &self.target, face, weights)
    }

    /// The point of `A` for a point of `B`, rounded.
    ///
    /// # Errors
    /// As [`forward_f64`](Self::forward_f64).
    pub fn backward_f64(&self, face: u32, weights: [f64; 3]) -> Result<FloatMeshPoint, SectionError> {
        carry_f64(&self.target, &self.source, face, weights)
    }

    /// The canonical form of a point of `A`.
    ///
    /// # Errors
    /// [`SectionError::MeshPoint`]: no such triangle.
    pub fn canonical(&self, point: &ExactPoint) -> Result<ExactPoint, SectionError> {
        if point.face as usize >= self.source.place.mesh.faces.len() {
            return Err(SectionError::MeshPoint { face: point.face });
        }
        Ok(canonical(&self.source, point.face, point.numerators()))
    }
}

fn canonical(chart: &Chart<'_>, face: u32, weights: &Big3) -> ExactPoint {
    let positive = weights.each_ref().map(|w| sign(w).is_positive());
    let (best, from) = chart.canonical(face, positive);
    ExactPoint::known(best, from.map(|k| k.map(|k| weights[k].clone()).unwrap_or_default()))
}

/// The middle point of a point of a piece.
fn middle(place: &Place<'_>, piece: &Piece, weights: &Big3) -> Big3 {
    middle_of(&place.exact(piece).in_tet(weights), place.pillars(place.tet(piece)))
}

fn carry(from: &Chart<'_>, to: &Chart<'_>, point: &ExactPoint) -> Result<ExactPoint, SectionError> {
    let weights = point.numerators();
    let (piece, _) = from.piece_at(point.face, &Near::of_integers(weights), &|| weights.clone())?;
    let middle = middle(&from.place, piece, weights);
    let hit = hit_exactly(to, from.place.tet(piece).prism, &middle)?;
    Ok(canonical(to, hit.piece.face, &to.place.exact(hit.piece).on_triangle(&middle)))
}

/// The piece over a middle point; where there are several they hold exactly the same point.
fn hit_exactly<'c>(to: &'c Chart<'_>, prism: u32, middle: &Big3) -> Result<Hit<'c>, SectionError> {
    let same = |p: &Piece, q: &Piece| {
        let [p, q] = [p, q].map(|piece| {
            let weights = to.place.exact(piece).on_triangle(middle);
            canonical(to, piece.face, &weights)
        });
        in_same_ratio(p.numerators(), q.numerators())
    };
    to.hit(prism, &Near::of_integers(middle), &|| middle.clone(), &same)
}

fn carry_f64(
    from: &Chart<'_>,
    to: &Chart<'_>,
    face: u32,
    weights: [f64; 3],
) -> Result<FloatMeshPoint, SectionError> {
    // Large weights would overflow in their sum: none is above one in what they mean.
    if !weights.iter().all(|w| (0.0..=1e300).contains(w)) || weights.iter().all(|&w| w == 0.0) {
        return Err(SectionError::MeshPoint { face });
    }
    let near = Near::normalised(weights);
    let (piece, _) = from.piece_at(face, &near, &|| in_ratio(weights))?;
    let tet = from.place.tet(piece);
    let down = near.middle(&piece.lambda, from.place.pillars(tet));
    let exactly = || middle(&from.place, piece, &in_ratio(weights));
    // Which of two pieces answers does not matter here: the claim `bijection` makes them one point.
    let hit = to.hit(tet.prism, &down, &exactly, &|_, _| true)?;
    let Some(rows) = hit.piece.inverse.as_ref() else {
        return Err(SectionError::NoPreimage { prism: tet.prism });
    };
    let up = down.map(rows);
    let error = up.error() + 1e-16;
    // A bound that is no number fails this, too.
    let good = error <= MAX_ERROR;
    if !good {
        return Ok(rounded(&carry(from, to, &ExactPoint::from_f64(face, weights)?)?));
    }
    let (face, order) = to.canonical(hit.piece.face, hit.signs.map(Sign::is_positive));
    let weight = |k: usize| if hit.signs[k].is_positive() { up.values[k].clamp(0.0, 1.0) } else { 0.0 };
    Ok(FloatMeshPoint { face, weights: order.map(|k| k.map_or(0.0, weight)), error })
}

fn rounded(point: &ExactPoint) -> FloatMeshPoint {
    // To nearest, and no weight is above one: off by at most 2^-53.
    FloatMeshPoint { face: point.face, weights: point.rounded(), error: 2e-16 }
}
