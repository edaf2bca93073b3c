//! Measured errors: of the rounded map against the exact one, and of round trips, beside Phong projection.

use super::phong::Phong;
use super::{ExactPoint, Transfer};
use crate::mesh::TriMesh;
use crate::number::Rat;
use crate::projection::SectionError;

/// The largest errors of rounded answers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// Points measured.
    pub points: usize,
    /// The largest difference between a rounded weight and the exact one.
    pub measured: f64,
    /// The largest proved bound among the answers.
    pub bound: f64,
}

/// What became of points that went from `A` to `B` and back.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RoundTrip {
    /// Points sent.
    pub points: usize,
    /// Those that did not come back at all.
    pub lost: usize,
    /// Those that came back farther away than [`ASTRAY`] times the diagonal of the bounding box.
    pub astray: usize,
    /// The largest distance of the others to where they started.
    pub largest: f64,
    /// The mean distance of the others.
    pub mean: f64,
}

/// A point that comes back farther away, in diagonals of the box around `A`, is counted and left out of the
/// distances.
pub const ASTRAY: f64 = 1e-4;

/// `count` points of a mesh, the same in every run: corners of triangles and points inside by turns, triangle
/// after triangle. Empty for a mesh without triangles.
#[must_use]
pub fn random_points(mesh: &TriMesh, count: usize) -> Vec<(u32, [f64; 3])> {
    let faces = u32::try_from(mesh.faces.len()).unwrap_or(u32::MAX);
    let mut state = 1_u64;
    // Above zero, so that the weights have a sum.
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) + 1) as f64 / (1_u64 << 31) as f64
    };
    let pair = |(f, k): (u32, usize)| {
        let corner = [0, 1, 2].map(|i| f64::from(u8::from(i == k)));
        [(f, corner), (f, [unit(), unit(), unit()])]
    };
    // Different corners in every round.
    let rounds = [0, 1, 2].into_iter().cycle().flat_map(|k| (0..faces).map(move |f| (f, k)));
    if faces == 0 { Vec::new() } else { rounds.flat_map(pair).take(count).collect() }
}

/// Compares rounded answers with exact ones.
///
/// # Errors
/// As [`Transfer::forward`].
pub fn measured(transfer: &Transfer<'_>, points: &[(u32, [f64; 3])]) -> Result<Worst, SectionError> {
    let mut out = Worst { points: points.len(), ..Worst::default() };
    for &(face, weights) in points {
        let near = transfer.forward_f64(face, weights)?;
        let exact = transfer.forward(&ExactPoint::from_f64(face, weights)?)?;
        out.bound = out.bound.max(near.error);
        for (w, e) in near.weights.into_iter().zip(exact.rationals()) {
            let off = (Rat::try_from(w).unwrap_or_default() - e).to_f64().value().abs();
            out.measured = out.measured.max(off);
        }
    }
    Ok(out)
}

/// How many points come back exactly to where they started.
///
/// # Errors
/// As [`Transfer::forward`].
pub fn exact_round_trips(transfer: &Transfer<'_>, points: &[(u32, [f64; 3])]) -> Result<usize, SectionError> {
    let mut equal = 0;
    for &(face, weights) in points {
        let p = ExactPoint::from_f64(face, weights)?;
        let back = transfer.backward(&transfer.forward(&p)?)?;
        equal += usize::from(back.is_same(&transfer.canonical(&p)?));
    }
    Ok(equal)
}

/// Round trips of the rounded map.
#[must_use]
pub fn round_trip(transfer: &Transfer<'_>, points: &[(u32, [f64; 3])]) -> RoundTrip {
    let back = |&(face, weights): &(u32, [f64; 3])| {
        let there = transfer.forward_f64(face, weights).ok()?;
        let back = transfer.backward_f64(there.face, there.weights).ok()?;
        Some((back.face, back.weights))
    };
    tally(transfer.source(), points, back)
}

/// Round trips by Phong projection: forward along `B`'s normals, back along the same line.
#[must_use]
pub fn round_trip_phong(a: &TriMesh, b: &TriMesh, points: &[(u32, [f64; 3])]) -> RoundTrip {
    let (source, target) = (Phong::new(a), Phong::new(b));
    let back = |&(face, weights): &(u32, [f64; 3])| {
        let (there, w) = target.project(position(a, face, weights))?;
        source.cast(position(b, there, w), target.normal(there, w))
    };
    tally(a, points, back)
}

/// Where a point with weights in this ratio is, rounded.
fn position(mesh: &TriMesh, face: u32, weights: [f64; 3]) -> [f64; 3] {
    let sum: f64 = weights.iter().sum();
    let corners = mesh.faces[face as usize].map(|v| mesh.vertices[v as usize]);
    [0, 1, 2].map(|axis| (0..3).map(|k| weights[k] / sum * corners[k][axis]).sum())
}

fn tally(
    mesh: &TriMesh,
    points: &[(u32, [f64; 3])],
    back: impl Fn(&(u32, [f64; 3])) -> Option<(u32, [f64; 3])>,
) -> RoundTrip {
    let apart = |p: [f64; 3], q: [f64; 3]| (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt();
    let corner = |pick: fn(f64, f64) -> f64, from: f64| {
        [0, 1, 2].map(|axis| mesh.vertices.iter().map(|p| p[axis]).fold(from, pick))
    };
    let diagonal = apart(corner(f64::min, f64::INFINITY), corner(f64::max, f64::NEG_INFINITY));
    let mut out = RoundTrip { points: points.len(), ..RoundTrip::default() };
    let mut sum = 0.0;
    for point in points {
        let Some((face, weights)) = back(point) else {
            out.lost += 1;
            continue;
        };
        let off = apart(position(mesh, point.0, point.1), position(mesh, face, weights));
        if off > ASTRAY * diagonal {
            out.astray += 1;
        } else {
            out.largest = out.largest.max(off);
            sum += off;
        }
    }
    let kept = out.points - out.lost - out.astray;
    out.mean = if kept == 0 { 0.0 } else { sum / kept as f64 };
    out
}
