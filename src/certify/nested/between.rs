//! Two surfaces that share no point: separating planes for pairs of triangles, or crossings (rule R3).

use dashu_int::IBig;
use rayon::prelude::*;
use smallvec::smallvec;

use super::super::CertifyError;
use super::super::exact::common_point;
use super::super::observer::Observer;
use super::super::pairs::BoxTree;
use super::super::separate::{Named, Pair, PlaneName, PointName};
use crate::mesh::TriMesh;
use crate::number::dyadic::scale_points;
use crate::shell::{Layer, Name};

/// A point of both surfaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Meeting {
    /// The triangle of the first surface, and of the second.
    pub triangles: [u32; 2],
    /// Integer weights on the corners of both.
    pub weights: [[IBig; 3]; 2],
}

/// The answer for all pairs.
#[derive(Debug, Default)]
pub(super) struct Between {
    /// Pairs whose boxes meet.
    pub(super) pairs: u64,
    /// The planes of pairs that neither own plane separates, ascending.
    pub(super) separations: Vec<(u32, u32, Vec<PlaneName>)>,
    pub(super) meetings: Vec<Meeting>,
}

/// The vertex of the second surface travels under a shell name, so that the two surfaces' ids stay apart.
pub(super) fn second_name(vertex: u32) -> PointName {
    PointName::Shell(Name { vertex, layer: Layer::Middle })
}

/// Decides all pairs. O((n + k) log n) for k pairs of boxes that meet.
pub(super) fn decide(a: &TriMesh, b: &TriMesh, observer: &dyn Observer) -> Result<Between, CertifyError> {
    observer.stage("between", Some(a.faces.len() as u64));
    let corners = |mesh: &'_ TriMesh, f: usize| mesh.faces[f].map(|v| v as usize);
    let tree = BoxTree::new((0..b.faces.len()).map(|f| corners(b, f).map(|v| &b.vertices[v])));
    let parts: Vec<Result<Between, CertifyError>> = (0..a.faces.len())
        .into_par_iter()
        .map(|i| {
            if observer.cancelled() {
                return Err(CertifyError::Cancelled);
            }
            observer.advance(1);
            let mut out = Between::default();
            for j in tree.meeting(&corners(a, i).map(|v| &a.vertices[v])) {
                out.pair(a, b, [i as u32, j])?;
            }
            Ok(out)
        })
        .collect();
    let mut out = Between::default();
    for part in parts {
        let part = part?;
        out.pairs += part.pairs;
        out.separations.extend(part.separations);
        out.meetings.extend(part.meetings);
    }
    Ok(out)
}

impl Between {
    fn pair(&mut self, a: &TriMesh, b: &TriMesh, [i, j]: [u32; 2]) -> Result<(), CertifyError> {
        self.pairs += 1;
        let first = a.faces[i as usize].map(|v| (PointName::Mesh(v), &a.vertices[v as usize]));
        let second = b.faces[j as usize].map(|v| (second_name(v), &b.vertices[v as usize]));
        let points = first.into_iter().chain(second).map(|(name, at)| Named { name, at }).collect();
        // Nothing is common: a remainder is harmless when it is empty.
        let pair = Pair { points, split: 3, common: smallvec![false; 6], exact_common: true };
        if pair.closed_by([0, 1, 2]) || pair.closed_by([3, 4, 5]) {
            return Ok(());
        }
        match pair.separation() {
            Some(planes) => self.separations.push((i, j, planes)),
            None => self.meetings.push(meeting([i, j], first.map(|p| *p.1), second.map(|p| *p.1))?),
        }
        Ok(())
    }
}

fn meeting(
    triangles: [u32; 2],
    first: [[f64; 3]; 3],
    second: [[f64; 3]; 3],
) -> Result<Meeting, CertifyError> {
    let (x, _) = scale_points(&[first, second].concat());
    let weights = common_point([&x[0], &x[1], &x[2]], [&x[3], &x[4], &x[5]])?;
    Ok(Meeting { triangles, weights })
}
