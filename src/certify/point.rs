//! Rational points of the mesh: all their carriers in the shell, and what is wrong with a lift at one of them.

use std::collections::BTreeMap;

use dashu_ratio::RBig;

use super::complex::TetComplex;
use super::exact::{ExactPiece, to_integers};
use super::lift::Lifting;
use super::witness::{Branch, Ending, Leg, Root};
use crate::predicate::{StageCounts, orient3d_staged};
use crate::shell::Name;

/// A point of a mesh triangle: weights on its corners with sum one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MeshPoint {
    pub(crate) face: u32,
    pub(crate) weights: [RBig; 3],
}

/// The carriers of a point, each with the tets that hold the point there.
pub(crate) type CarrierMap = BTreeMap<Vec<Name>, Vec<u32>>;

type Box3 = [[f64; 2]; 3];

/// The closed bounding box: minima and maxima of stored numbers, so exact.
pub(crate) fn bounds<'p>(points: impl IntoIterator<Item = &'p [f64; 3]>) -> Box3 {
    let mut out = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for p in points {
        for (range, x) in out.iter_mut().zip(p) {
            *range = [range[0].min(*x), range[1].max(*x)];
        }
    }
    out
}

/// Do closed boxes meet?
pub(crate) fn boxes_meet(a: &Box3, b: &Box3) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

impl Lifting<'_> {
    /// The vertices of the mesh on which the point has positive weight.
    fn support(&self, point: &MeshPoint) -> Vec<u32> {
        let face = self.mesh.faces[point.face as usize];
        (0..3).filter(|&i| point.weights[i] != RBig::ZERO).map(|i| face[i]).collect()
    }

    /// All carriers of a point in `S_<`: every closed tet is tested. Linear in the number of tets.
    pub(crate) fn carriers_of(&self, point: &MeshPoint) -> CarrierMap {
        let f = self.mesh.points(point.face);
        let near = bounds(f);
        let mut out = CarrierMap::new();
        for id in 0..self.complex.tets.len() as u32 {
            let points = self.complex.points(id);
            // The point lies in its triangle's box.
            if !boxes_meet(&near, &bounds(points)) {
                continue;
            }
            let Some(bits) = ExactPiece::new(f, points).carrier(&point.weights) else { continue };
            let names = self.complex.tets[id as usize].names;
            let mut carrier: Vec<Name> = (0..4).filter(|k| bits & (1 << k) != 0).map(|k| names[k]).collect();
            carrier.sort_unstable();
            out.entry(carrier).or_default().push(id);
        }
        out
    }

    /// What refutes a lift that sends the point to this carrier, from the point's neighbourhood alone; with the tet
    /// that shows it.
    pub(crate) fn local_failure(
        &self,
        point: &MeshPoint,
        carrier: &[Name],
        tets: &[u32],
        stages: &mut StageCounts,
    ) -> Option<(Ending, u32)> {
        let first = *tets.first()?;
        if self.complex.in_cap(carrier) {
            return Some((Ending::Cap, first));
        }
        let support = self.support(point);
        let on_edge = self.mesh.boundary.holds(support.iter().copied());
        let on_wall = self.complex.in_boundary_wall(carrier);
        if on_edge != on_wall {
            return Some((if on_wall { Ending::Wall } else { Ending::Boundary }, first));
        }
        if support.len() < 3 || !self.spans_piece(point.face, carrier, stages) {
            return None;
        }
        let fold = tets.iter().find(|&&t| !self.dot(point.face, t, stages).is_positive());
        fold.map(|&t| (Ending::Fold, t))
    }

    /// Is the triangle around a point of this carrier a piece: the carrier a tet, or a face in the triangle's plane?
    fn spans_piece(&self, face: u32, carrier: &[Name], stages: &mut StageCounts) -> bool {
        let [a, b, c] = self.mesh.points(face);
        let flat =
            |n: &Name| stages.note(orient3d_staged(a, b, c, self.complex.shell.position(*n))).is_zero();
        carrier.len() == 4 || (carrier.len() == 3 && carrier.iter().all(flat))
    }

    /// The witness at one point, when every lift of the point fails right there.
    pub(crate) fn root_at(&self, point: &MeshPoint, stages: &mut StageCounts) -> Option<Root> {
        let carriers = self.carriers_of(point);
        let mut branches = Vec::with_capacity(carriers.len());
        for (carrier, tets) in &carriers {
            let (ending, tet) = self.local_failure(point, carrier, tets, stages)?;
            let leg = Leg { start: self.complex.sorted_names(tet), steps: Vec::new() };
            branches.push(Branch { carrier: carrier.clone(), legs: vec![leg], ending });
        }
        Some(Root { face: point.face, weights: to_integers(&point.weights), branches })
    }
}

impl TetComplex<'_> {
    /// The names of a tet, ascending.
    pub(crate) fn sorted_names(&self, tet: u32) -> [Name; 4] {
        self.tets[tet as usize].sorted_names()
    }
}
