//! Exact points on pieces of a lift, and the paths that lead to them.

use dashu_ratio::RBig;

use super::CertifyError;
use super::clip::Mask;
use super::exact::{ExactPiece, det3, mean, normalised, sum, to_integers};
use super::lift::{Lift, Lifting, Reason, Violation};
use super::point::MeshPoint;
use super::witness::{Ending, Leg, Step};

/// A corner of a piece: weights in its triangle, and projected coordinates on its prism's corners; sums are one.
#[derive(Clone, Debug)]
pub(crate) struct ExactCorner {
    pub(crate) weights: [RBig; 3],
    pub(crate) projected: [RBig; 3],
}

fn broken(what: &'static str) -> CertifyError {
    CertifyError::Internal { what }
}

impl Lifting<'_> {
    /// All corners of a piece, exactly.
    pub(crate) fn exact_corners(&self, lift: &Lift, piece: u32) -> Result<Vec<ExactCorner>, CertifyError> {
        let masks: Vec<Mask> = lift.corners_of(piece).iter().map(|(mask, _)| *mask).collect();
        let record = lift.pieces[piece as usize];
        self.exact_polygon(record.face, record.tet, &masks)
    }

    /// All corners of the polygon of a triangle in a tet, exactly.
    pub(crate) fn exact_polygon(
        &self,
        face: u32,
        tet: u32,
        masks: &[Mask],
    ) -> Result<Vec<ExactCorner>, CertifyError> {
        let exact = ExactPiece::new(self.mesh.points(face), self.complex.points(tet));
        let tet = self.complex.tets[tet as usize];
        let prism = self.complex.shell.faces[tet.prism as usize];
        let corner = |mask: &Mask| {
            let weights = exact.weights(*mask).ok_or_else(|| broken("corner without two crossing lines"))?;
            let in_tet = exact.in_tet(&weights).ok_or_else(|| broken("piece in a flat tet"))?;
            let projected = prism.map(|v| {
                let on_pillar = tet.names.iter().zip(&in_tet).filter(|(n, _)| n.vertex == v);
                sum(on_pillar.map(|(_, x)| x.clone()))
            });
            Ok(ExactCorner { weights, projected })
        };
        masks.iter().map(corner).collect()
    }

    /// The point at which a violation shows, and its kind.
    pub(crate) fn violation_point(
        &self,
        lift: &Lift,
        v: &Violation,
    ) -> Result<(MeshPoint, Ending), CertifyError> {
        let corners = self.exact_corners(lift, v.piece)?;
        let (weights, ending) = shown_at(&corners, v.reason);
        Ok((MeshPoint { face: lift.pieces[v.piece as usize].face, weights }, ending))
    }

    /// The path from the root of a lift to a point of a piece. Breadth-first flooding keeps it short.
    pub(crate) fn leg(&self, lift: &Lift, piece: u32, end: &MeshPoint) -> Result<Leg, CertifyError> {
        let mut chain = vec![piece];
        let mut at = piece;
        while lift.pieces[at as usize].parent != at {
            at = lift.pieces[at as usize].parent;
            chain.push(at);
        }
        chain.reverse();
        let start = self.complex.sorted_names(lift.pieces[at as usize].tet);
        let mut steps = Vec::with_capacity(chain.len());
        for pair in chain.windows(2) {
            steps.push(self.crossing(lift, pair[0], pair[1])?);
        }
        let last = lift.pieces[piece as usize];
        let tet = self.complex.sorted_names(last.tet);
        steps.push(Step { face: last.face, weights: to_integers(&end.weights), tet });
        Ok(Leg { start, steps })
    }

    /// The middle of the side across which `child` was reached, as a point of `child`'s triangle.
    fn crossing(&self, lift: &Lift, parent: u32, child: u32) -> Result<Step, CertifyError> {
        let record = lift.pieces[child as usize];
        let corners = self.exact_corners(lift, parent)?;
        let s = usize::from(record.parent_side);
        let weights = mean(&[corners[s].weights.clone(), corners[(s + 1) % corners.len()].weights.clone()]);
        let from = self.mesh.faces[lift.pieces[parent as usize].face as usize];
        let to = self.mesh.faces[record.face as usize];
        let weights =
            to.map(|v| from.iter().position(|&u| u == v).map_or(RBig::ZERO, |i| weights[i].clone()));
        let tet = self.complex.sorted_names(record.tet);
        Ok(Step { face: record.face, weights: to_integers(&weights), tet })
    }
}

/// The point of a polygon at which a reason shows, and its kind.
pub(crate) fn shown_at(corners: &[ExactCorner], reason: Reason) -> ([RBig; 3], Ending) {
    let all: Vec<[RBig; 3]> = corners.iter().map(|c| c.weights.clone()).collect();
    let side = |s: u8| {
        let s = usize::from(s);
        mean(&[all[s].clone(), all[(s + 1) % all.len()].clone()])
    };
    match reason {
        Reason::Cap { corner } => (all[usize::from(corner)].clone(), Ending::Cap),
        Reason::CapSide { side: s } => (side(s), Ending::Cap),
        Reason::Wall { side: s } => (side(s), Ending::Wall),
        Reason::Boundary { side: s } => (side(s), Ending::Boundary),
        Reason::Fold => (mean(&all), Ending::Fold),
    }
}

/// Coordinates that the two maps have on a piece's corners.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Chart {
    /// Weights in the mesh triangle.
    Mesh,
    /// Projected coordinates in the prism.
    Middle,
}

impl Chart {
    pub(crate) fn of(self, corner: &ExactCorner) -> &[RBig; 3] {
        match self {
            Self::Mesh => &corner.weights,
            Self::Middle => &corner.projected,
        }
    }
}

/// If the closed image of the polygon holds the point `q`: the point of the mesh triangle that is mapped there.
pub(crate) fn preimage(corners: &[ExactCorner], chart: Chart, q: &[RBig; 3]) -> Option<[RBig; 3]> {
    let (first, rest) = corners.split_first()?;
    rest.windows(2).find_map(|pair| {
        let triangle = [first, &pair[0], &pair[1]];
        let [a, b, c] = triangle.map(|k| chart.of(k));
        let parts = [det3([q, b, c]), det3([a, q, c]), det3([a, b, q])];
        if parts.iter().any(|x| *x < RBig::ZERO) {
            return None;
        }
        let total = sum(parts.iter().cloned());
        if total == RBig::ZERO {
            return None;
        }
        let weight = |i: usize| sum((0..3).map(|k| &parts[k] * &triangle[k].weights[i])) / &total;
        Some([weight(0), weight(1), weight(2)])
    })
}

/// The image of the centroid of the first fan triangle.
pub(crate) fn first_centroid(corners: &[ExactCorner], chart: Chart) -> Option<[RBig; 3]> {
    let fan = corners.get(..3)?;
    Some(mean(&fan.iter().map(|c| chart.of(c).clone()).collect::<Vec<_>>()))
}

/// Integer weights as a point with sum one.
pub(crate) fn point_of(face: u32, weights: &[dashu_int::IBig; 3]) -> Option<MeshPoint> {
    Some(MeshPoint { face, weights: normalised(weights)? })
}
