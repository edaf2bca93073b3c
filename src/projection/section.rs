//! The maps between a section mesh and the middle surface: `P_T` and its inverse.

use super::boxes::BoxTree;
use super::exact::{along, cross, dot, outer_box, rational_point, sub, triangle_weights, weighted};
use super::point::{Stars, barycentric};
use super::{Projection, Rat, SectionError, ShellPoint};
use crate::mesh::TriMesh;

/// A point of a mesh, exactly. The maps return the form with the smallest triangle.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct MeshPoint {
    /// The triangle: an index into [`TriMesh::faces`].
    pub face: u32,
    /// Barycentric coordinates on its corners: none negative, sum 1.
    pub weights: [Rat; 3],
}

/// `P_T` and its inverse for a mesh `T` in a shell.
///
/// The maps are mutually inverse bijections exactly when claim `bijection` holds for the mesh
/// ([`certify`](crate::certify::certify)); then both round trips are equalities. This type does not
/// prove that: it answers point by point, and where a point has no image or several it says so.
/// Several images also come from a shell that overlaps itself in space, where `bijection` speaks of
/// a lift; [`images`](Self::images) and [`preimages`](Self::preimages) then list all.
#[derive(Debug)]
pub struct SectionMap<'a> {
    projection: &'a Projection<'a>,
    mesh: &'a TriMesh,
    tree: BoxTree,
    stars: Stars,
}

/// Finite coordinates, corners in range, and few enough triangles to number their corners.
pub(crate) fn well_formed(mesh: &TriMesh) -> Result<(), SectionError> {
    let vertices = mesh.vertices.len();
    if let Some(v) = mesh.vertices.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
        return Err(SectionError::Mesh(format!("vertex {v} is not finite")));
    }
    if let Some(f) = mesh.faces.iter().position(|f| f.iter().any(|&v| v as usize >= vertices)) {
        return Err(SectionError::Mesh(format!("triangle {f} has a corner out of range")));
    }
    if u32::try_from(mesh.faces.len()).ok().and_then(|n| n.checked_mul(3)).is_none() {
        return Err(SectionError::Mesh("too many triangles".to_owned()));
    }
    Ok(())
}

impl<'a> SectionMap<'a> {
    /// Builds the search structure; `O(n log n)`.
    ///
    /// # Errors
    /// [`SectionError::Mesh`]: a coordinate is not finite, or a corner is out of range.
    pub fn new(projection: &'a Projection<'a>, mesh: &'a TriMesh) -> Result<Self, SectionError> {
        well_formed(mesh)?;
        let tree = BoxTree::new(mesh.faces.iter().map(|f| f.map(|v| &mesh.vertices[v as usize])));
        Ok(Self { projection, mesh, tree, stars: Stars::new(mesh.vertices.len(), &mesh.faces) })
    }

    fn triangle(&self, face: u32) -> [&'a [f64; 3]; 3] {
        self.mesh.faces[face as usize].map(|v| &self.mesh.vertices[v as usize])
    }

    fn check(&self, point: &MeshPoint) -> Result<(), SectionError> {
        let exists = (point.face as usize) < self.mesh.faces.len();
        if exists && barycentric(&point.weights) {
            return Ok(());
        }
        Err(SectionError::MeshPoint { face: point.face })
    }

    /// The point in the smallest triangle that has it on a common edge or vertex.
    ///
    /// # Errors
    /// [`SectionError::MeshPoint`].
    pub fn canonical(&self, point: &MeshPoint) -> Result<MeshPoint, SectionError> {
        self.check(point)?;
        let (face, weights) = self.stars.canonical(&self.mesh.faces, point.face, &point.weights);
        Ok(MeshPoint { face, weights })
    }

    /// Its place in space.
    ///
    /// # Errors
    /// [`SectionError::MeshPoint`].
    pub fn position(&self, point: &MeshPoint) -> Result<[Rat; 3], SectionError> {
        self.check(point)?;
        Ok(weighted(self.triangle(point.face).into_iter().zip(point.weights.clone())))
    }

    /// All middle points below or above a mesh point, canonical, by prism.
    ///
    /// # Errors
    /// [`SectionError::MeshPoint`].
    pub fn images(&self, point: &MeshPoint) -> Result<Vec<ShellPoint>, SectionError> {
        let mut out: Vec<ShellPoint> = Vec::new();
        for middle in self.projection.project_all(&self.position(point)?).iter().map(ShellPoint::middle) {
            if !out.contains(&middle) {
                out.push(middle);
            }
        }
        Ok(out)
    }

    /// `P_T`: the middle point (height 0, canonical) of a mesh point, exactly.
    ///
    /// # Errors
    /// [`SectionError`]: no such point, outside of the shell, several images.
    pub fn to_middle(&self, point: &MeshPoint) -> Result<ShellPoint, SectionError> {
        let mut images = self.images(point)?;
        match (images.pop(), images.len()) {
            (Some(image), 0) => Ok(image),
            (None, _) => Err(SectionError::Outside { face: point.face }),
            (Some(_), more) => Err(SectionError::SeveralImages { face: point.face, count: more + 1 }),
        }
    }

    /// All mesh points on the fibre over a middle point, canonical, by triangle.
    ///
    /// A triangle parallel to a piece of the fibre is passed over: on a section such a triangle has
    /// no area in the tet, so a point that it shares with the piece belongs to another triangle that
    /// does cross it, or to the next piece.
    ///
    /// # Errors
    /// [`SectionError::Point`].
    pub fn preimages(&self, prism: u32, weights: &[Rat; 3]) -> Result<Vec<MeshPoint>, SectionError> {
        let pieces = self.projection.fibre(prism, weights)?;
        let mut found: Vec<MeshPoint> = Vec::new();
        let mut add = |face: u32, weights: [Rat; 3]| {
            let (face, weights) = self.stars.canonical(&self.mesh.faces, face, &weights);
            let point = MeshPoint { face, weights };
            if !found.contains(&point) {
                found.push(point);
            }
        };
        for piece in &pieces {
            for (face, weights) in self.crossings(&piece.low.1, &piece.high.1) {
                add(face, weights);
            }
        }
        if pieces.is_empty() {
            let q = ShellPoint { prism, weights: weights.clone(), height: Rat::ZERO };
            let p = self.projection.unproject(&q)?;
            for face in self.tree.meeting(outer_box(&p)) {
                if let Some(weights) = triangle_weights(&p, &self.triangle(face).map(rational_point)) {
                    add(face, weights);
                }
            }
        }
        found.sort_by_key(|point| point.face);
        Ok(found)
    }

    /// The triangles that a closed segment crosses, and where.
    fn crossings(&self, low: &[Rat; 3], high: &[Rat; 3]) -> Vec<(u32, [Rat; 3])> {
        let ([low_min, low_max], [high_min, high_max]) = (outer_box(low), outer_box(high));
        let bounds =
            [[0, 1, 2].map(|i| low_min[i].min(high_min[i])), [0, 1, 2].map(|i| low_max[i].max(high_max[i]))];
        let crossing = |face: u32| {
            let corners = self.triangle(face).map(rational_point);
            let [a, b, c] = &corners;
            let normal = cross(&sub(b, a), &sub(c, a));
            let (below, above) = (dot(&normal, &sub(low, a)), dot(&normal, &sub(high, a)));
            if below == above || &below * &above > Rat::ZERO {
                return None;
            }
            let s = &below / (&below - &above);
            let p = along(low, &s, &sub(high, low));
            Some((face, triangle_weights(&p, &corners)?))
        };
        self.tree.meeting(bounds).into_iter().filter_map(crossing).collect()
    }

    /// The inverse of `P_T`: the mesh point (canonical) on the fibre over a middle point, exactly.
    ///
    /// # Errors
    /// [`SectionError`]: no such middle point, no mesh point on its fibre, or several.
    pub fn to_mesh(&self, prism: u32, weights: &[Rat; 3]) -> Result<MeshPoint, SectionError> {
        let mut points = self.preimages(prism, weights)?;
        match (points.pop(), points.len()) {
            (Some(point), 0) => Ok(point),
            (None, _) => Err(SectionError::NoPreimage { prism }),
            (Some(_), more) => Err(SectionError::SeveralPreimages { prism, count: more + 1 }),
        }
    }
}
