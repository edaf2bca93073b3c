//! Every place where a mesh fails to be a section of `S_<`: looked at triangle by triangle and tet by tet, without a lift.
//!
//! A lift stops at its first witness, which decides the claim; a person who has to repair a mesh wants all of them. Where
//! the shell overlaps itself in space, a triangle is compared with tets of every sheet, also those that no lift would
//! take it to: then a place listed here need not be one that a lift fails at. Verdicts are not made here.

use dashu_int::IBig;
use dashu_ratio::RBig;
use rayon::prelude::*;

use super::CertifyError;
use super::clip::{Mask, SIDES};
use super::exact::{ExactPiece, centre, cross, dot, minus, whole};
use super::lift::{Lifting, Reason};
use super::observer::Observer;
use super::pairs::BoxTree;
use super::path::shown_at;
use super::polygon::{Polygon, share, without};
use super::positivity::dyadic;
use super::witness::Ending;
use crate::number::dyadic::scale_points;
use crate::predicate::StageCounts;

/// A part of a triangle in a tet.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) face: u32,
    pub(crate) tet: u32,
    pub(crate) masks: Vec<Mask>,
    /// `n . V > 0`.
    pub(crate) faces_up: bool,
}

/// A place where a triangle breaks a rule of sections.
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    pub(crate) face: u32,
    pub(crate) tet: u32,
    pub(crate) ending: Ending,
    /// The point: weights on the triangle's corners with sum one.
    pub(crate) weights: [RBig; 3],
    /// `n . V` of a fold, as `mantissa * 2^exponent`.
    pub(crate) value: Option<(IBig, i32)>,
}

/// The part of a triangle that lies in no closed tet.
#[derive(Clone, Debug)]
pub(crate) struct Outside {
    pub(crate) face: u32,
    /// Disjoint convex polygons.
    pub(crate) polygons: Vec<Polygon>,
    /// Share of the triangle's area.
    pub(crate) share: RBig,
    /// A point inside the largest of the polygons.
    pub(crate) weights: [RBig; 3],
}

/// All that was found, ascending by triangle and tet.
#[derive(Debug, Default)]
pub(crate) struct Survey {
    pub(crate) parts: Vec<Part>,
    pub(crate) failures: Vec<Failure>,
    pub(crate) outside: Vec<Outside>,
}

/// Surveys a mesh. All tets must be positive. O((n + k) log n) for k pairs of triangle and tet with boxes that meet.
pub(crate) fn survey(cx: Lifting<'_>, observer: &dyn Observer) -> Result<Survey, CertifyError> {
    observer.stage("survey", Some(cx.mesh.faces.len() as u64));
    let tets = 0..cx.complex.tets.len() as u32;
    let tree = BoxTree::new(tets.map(|t| cx.complex.points(t)));
    let parts: Vec<Result<Survey, CertifyError>> = (0..cx.mesh.faces.len() as u32)
        .into_par_iter()
        .map(|face| {
            if observer.cancelled() {
                return Err(CertifyError::Cancelled);
            }
            observer.advance(1);
            triangle(&cx, face, &tree)
        })
        .collect();
    let mut out = Survey::default();
    for part in parts {
        let part = part?;
        out.parts.extend(part.parts);
        out.failures.extend(part.failures);
        out.outside.extend(part.outside);
    }
    Ok(out)
}

fn triangle(cx: &Lifting<'_>, face: u32, tree: &BoxTree) -> Result<Survey, CertifyError> {
    let mut out = Survey::default();
    let mut left = vec![whole()];
    for tet in tree.meeting(&cx.mesh.points(face)) {
        let Some(piece) = cx.lone_piece(face, tet) else { continue };
        if is_whole(&piece.masks) {
            left.clear();
        } else if !left.is_empty() {
            let exact = ExactPiece::new(cx.mesh.points(face), cx.complex.points(tet));
            left = without(left, exact.half_spaces());
        }
        if !piece.reasons.is_empty() {
            let corners = cx.exact_polygon(face, tet, &piece.masks)?;
            for &reason in &piece.reasons {
                let (weights, ending) = shown_at(&corners, reason);
                let value = (reason == Reason::Fold).then(|| field_dot(cx, face, tet));
                out.failures.push(Failure { face, tet, ending, weights, value });
            }
        }
        if piece.counts {
            let faces_up = cx.dot(face, tet, &mut StageCounts::default()).is_positive();
            out.parts.push(Part { face, tet, masks: piece.masks, faces_up });
        }
    }
    out.outside.extend(outside(face, left));
    Ok(out)
}

/// Is the polygon the triangle itself: are its corners on two sides of the triangle each?
fn is_whole(masks: &[Mask]) -> bool {
    masks.len() == 3 && masks.iter().all(|m| (m & SIDES).count_ones() == 2)
}

fn outside(face: u32, polygons: Vec<Polygon>) -> Option<Outside> {
    let shares: Vec<RBig> = polygons.iter().map(|p| share(p)).collect();
    let largest = (0..polygons.len()).max_by(|&i, &j| shares[i].cmp(&shares[j]))?;
    // The mean of the corners is inside the polygon, hence beyond one face of every tet.
    let weights = centre(polygons.get(largest)?)?;
    let share = shares.into_iter().fold(RBig::ZERO, |sum, x| sum + x);
    Some(Outside { face, polygons, share, weights })
}

/// `n . V` of a triangle in a tet.
fn field_dot(cx: &Lifting<'_>, face: u32, tet: u32) -> (IBig, i32) {
    let [lo, hi] = cx.complex.tets[tet as usize].field().map(|n| cx.complex.shell.position(n));
    let [a, b, c] = cx.mesh.points(face);
    let (x, exponent) = scale_points(&[*a, *b, *c, *lo, *hi]);
    let normal = cross(&minus(&x[1], &x[0]), &minus(&x[2], &x[0]));
    dyadic(dot(&normal, &minus(&x[4], &x[3])), exponent.saturating_mul(3))
}
