//! C6 `disjoint`: the mesh against itself, and against the shell's bottom and top (rule R3).

use dashu_int::IBig;
use rayon::prelude::*;

use super::CertifyError;
use super::complex::{Boundary, MeshView};
use super::exact::{Vec3, common_point_off};
use super::observer::Observer;
use super::pairs::BoxTree;
use super::separate::{Few, Named, Pair, PlaneName, PointName};
use crate::mesh::{Connectivity, TriMesh};
use crate::number::dyadic::scale_points;
use crate::predicate::{StageCounts, same_point};
use crate::shell::{Layer, Shell};

/// What the mesh is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// Itself.
    Mesh,
    /// The shell's bottom surface.
    Bottom,
    /// The shell's top surface.
    Top,
}

/// Two triangles with a common point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// A mesh triangle.
    pub first: u32,
    /// The other triangle, or the prism whose bottom or top it is.
    pub second: u32,
    /// The point: integer weights on the first triangle's corners.
    pub in_first: [IBig; 3],
    /// Integer weights on the second triangle's corners.
    pub in_second: [IBig; 3],
}

/// The answer to C6 for one pair of sets.
#[derive(Debug, Default)]
pub(crate) struct Disjoint {
    /// Pairs whose boxes meet.
    pub(crate) pairs: u64,
    /// Pairs that the plane of one of the two triangles separates.
    pub(crate) by_own_plane: u64,
    /// The planes of all other separated pairs, ascending.
    pub(crate) separations: Vec<(u32, u32, Vec<PlaneName>)>,
    /// Pairs that share more than they may, ascending.
    pub(crate) crossings: Vec<Crossing>,
    /// How the signs on the way were decided.
    pub(crate) stages: StageCounts,
}

/// What a pair turned out to be.
enum Found {
    OwnPlane,
    Planes(Vec<PlaneName>),
    Crossing(Box<Crossing>),
}

struct Job<'a> {
    mesh: &'a MeshView<'a>,
    shell: &'a Shell,
    about: About,
}

/// All pairs of triangles of a mesh that share more than their common vertices (by index) force. Every triangle must have
/// area. O((n + k) log n) for k pairs of boxes that meet.
///
/// # Errors
/// [`CertifyError::Mesh`] for indices out of range, [`CertifyError::Cancelled`] by the observer.
pub fn self_intersections(mesh: &TriMesh, observer: &dyn Observer) -> Result<Vec<Crossing>, CertifyError> {
    self_crossings(mesh, &Connectivity::new(mesh.vertices.len(), &mesh.faces)?, observer)
}

/// [`self_intersections`] for a mesh whose connectivity is known.
pub(crate) fn self_crossings(
    mesh: &TriMesh,
    connectivity: &Connectivity,
    observer: &dyn Observer,
) -> Result<Vec<Crossing>, CertifyError> {
    let boundary = Boundary::new(connectivity);
    let view = MeshView { vertices: &mesh.vertices, faces: &mesh.faces, connectivity, boundary: &boundary };
    Ok(decide(&view, &Shell::default(), About::Mesh, observer)?.crossings)
}

/// Decides C6. O((n + k) log n) for k pairs of boxes that meet.
pub(crate) fn decide(
    mesh: &MeshView<'_>,
    shell: &Shell,
    about: About,
    observer: &dyn Observer,
) -> Result<Disjoint, CertifyError> {
    let job = Job { mesh, shell, about };
    let count = match about {
        About::Mesh => mesh.faces.len(),
        About::Bottom | About::Top => shell.faces.len(),
    };
    let tree = BoxTree::new((0..count as u32).map(|j| job.second(j).map(|n| n.at)));
    let parts: Vec<Result<Disjoint, CertifyError>> = (0..mesh.faces.len() as u32)
        .into_par_iter()
        .map(|i| {
            if observer.cancelled() {
                return Err(CertifyError::Cancelled);
            }
            observer.advance(1);
            job.triangle(i, &tree)
        })
        .collect();
    let mut out = Disjoint::default();
    for part in parts {
        let part = part?;
        out.pairs += part.pairs;
        out.by_own_plane += part.by_own_plane;
        out.stages += part.stages;
        out.separations.extend(part.separations);
        out.crossings.extend(part.crossings);
    }
    Ok(out)
}

impl<'a> Job<'a> {
    fn first(&self, i: u32) -> [Named<'a>; 3] {
        self.mesh.faces[i as usize]
            .map(|v| Named { name: PointName::Mesh(v), at: &self.mesh.vertices[v as usize] })
    }

    fn second(&self, j: u32) -> [Named<'a>; 3] {
        let layer = match self.about {
            About::Mesh => return self.first(j),
            About::Bottom => Layer::Bottom,
            About::Top => Layer::Top,
        };
        self.shell.faces[j as usize].map(|v| {
            let name = self.shell.name(v, layer);
            Named { name: PointName::Shell(name), at: self.shell.position(name) }
        })
    }

    fn triangle(&self, i: u32, tree: &BoxTree) -> Result<Disjoint, CertifyError> {
        let mut out = Disjoint::default();
        let near = tree.meeting(&self.first(i).map(|n| n.at));
        for j in near.into_iter().filter(|&j| self.about != About::Mesh || j > i) {
            out.pairs += 1;
            match self.pair(i, j, &mut out.stages)? {
                Found::OwnPlane => out.by_own_plane += 1,
                Found::Planes(planes) => out.separations.push((i, j, planes)),
                Found::Crossing(crossing) => out.crossings.push(*crossing),
            }
        }
        Ok(out)
    }

    fn pair(&self, i: u32, j: u32, stages: &mut StageCounts) -> Result<Found, CertifyError> {
        let (a, b) = (self.first(i), self.second(j));
        let exact_common = self.about == About::Mesh;
        let points: Few<Named<'_>> = a.into_iter().chain(b).collect();
        let common = (0..6).map(|k| match points[k].name {
            // Mesh vertices are common by id; a pinched vertex, wherever a point has its coordinates.
            PointName::Mesh(_) if exact_common => {
                let other = if k < 3 { &points[3..] } else { &points[..3] };
                other.iter().any(|o| o.name == points[k].name)
            }
            _ => b.iter().any(|p| self.is_pinch(p) && same_point(p.at, points[k].at)),
        });
        let common = common.collect();
        let pair = Pair { common, points, split: 3, exact_common };
        if [[0, 1, 2], [3, 4, 5]].into_iter().any(|own| pair.closed_by_staged(own, stages)) {
            return Ok(Found::OwnPlane);
        }
        match pair.separation_staged(stages) {
            Some(planes) => Ok(Found::Planes(planes)),
            None => {
                let allowed: Few<usize> = (3..6).filter(|&k| self.is_pinch(&pair.points[k])).collect();
                let found = crossing(i, j, [a, b], &allowed)?;
                let found = found.ok_or(CertifyError::FlatAtPinch { triangle: i, prism: j })?;
                Ok(Found::Crossing(Box::new(found)))
            }
        }
    }

    fn is_pinch(&self, point: &Named<'_>) -> bool {
        matches!(point.name, PointName::Shell(n) if self.shell.is_pinched(n.vertex))
    }
}

/// A point of both triangles that is at none of the allowed corners, numbered from 3 for those of the second; the first has
/// area. `None` if they have no other one.
pub(crate) fn crossing(
    i: u32,
    j: u32,
    triangles: [[Named<'_>; 3]; 2],
    allowed: &[usize],
) -> Result<Option<Crossing>, CertifyError> {
    let coordinates: Few<[f64; 3]> = triangles.as_flattened().iter().map(|n| *n.at).collect();
    let (x, _) = scale_points(&coordinates);
    let allowed: Few<&Vec3> = allowed.iter().map(|&k| &x[k]).collect();
    let found = common_point_off([&x[0], &x[1], &x[2]], [&x[3], &x[4], &x[5]], &allowed)?;
    Ok(found.map(|[in_first, in_second]| Crossing { first: i, second: j, in_first, in_second }))
}
