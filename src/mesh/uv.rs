//! Texture coordinates of OBJ files as positions in the plane.

use std::collections::BTreeMap;
use std::path::Path;

use super::complex::{Cells, Complex, Positions, Space};
use super::error::{Located, MeshError};
use super::format::load;
use super::{TriMesh, obj};

/// A surface with texture coordinates: `uv_faces[k]` are the indices into `uv` at the corners of `mesh.faces[k]`.
#[derive(Clone, Debug, PartialEq)]
pub struct UvMesh {
    /// The surface.
    pub mesh: TriMesh,
    /// Texture coordinates.
    pub uv: Vec<[f64; 2]>,
    /// Their indices, one row a triangle.
    pub uv_faces: Vec<[u32; 3]>,
    /// What was changed or left out.
    pub notes: Vec<String>,
}

/// Why texture coordinates are no positions of a surface's vertices.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum UvError {
    /// A vertex that has different texture coordinates in different triangles.
    #[error(
        "seams cut the surface: {vertices} vertices have several texture coordinates (first vertex {vertex}), so there is no \
         map of the surface itself to the plane"
    )]
    Seams {
        /// How many such vertices there are.
        vertices: usize,
        /// The first of them.
        vertex: u32,
    },
    /// A triangle without texture coordinates, or with an index that is none.
    #[error("triangle {triangle} has no texture coordinates, or an index out of range")]
    Index {
        /// The triangle.
        triangle: usize,
    },
    /// More pairs than indices can name.
    #[error("the surface has too many corners")]
    TooMany,
}

/// Reads an OBJ file in which every corner has a texture coordinate.
///
/// # Errors
/// [`MeshError::Read`] with file, line and reason.
pub fn read_uv(path: &Path) -> Result<UvMesh, MeshError> {
    let name = path.to_string_lossy();
    let bytes = load(path).map_err(|fault| Located::from(fault).reading(&name))?;
    obj::parse_uv(&bytes).map_err(|located| located.reading(&name))
}

fn plane(uv: Vec<[f64; 2]>, faces: &[[u32; 3]]) -> Complex {
    let points = uv.into_iter().map(|[u, v]| [u, v, 0.0]).collect();
    Complex {
        space: Space::Plane,
        positions: Positions::Float(points),
        cells: Cells::Triangles(faces.to_vec()),
    }
}

impl UvMesh {
    /// Has every corner a vertex and a texture coordinate? Files that were read have; the fields are public.
    fn check(&self) -> Result<(), UvError> {
        let are_in = |ids: &[u32; 3], n: usize| ids.iter().all(|&i| (i as usize) < n);
        let is_bad = |t: usize| match (self.mesh.faces.get(t), self.uv_faces.get(t)) {
            (Some(face), Some(uv)) => !are_in(face, self.mesh.vertices.len()) || !are_in(uv, self.uv.len()),
            _ => true,
        };
        let bad = (0..self.mesh.faces.len().max(self.uv_faces.len())).find(|&t| is_bad(t));
        bad.map_or(Ok(()), |triangle| Err(UvError::Index { triangle }))
    }

    /// The surface in space and in the plane. A vertex of no triangle is at the origin of the plane.
    ///
    /// # Errors
    /// [`UvError::Seams`] if a vertex has two different places in the plane; [`UvError::Index`].
    pub fn whole(&self) -> Result<[Complex; 2], UvError> {
        let mut place: Vec<Option<[f64; 2]>> = vec![None; self.mesh.vertices.len()];
        let mut seams = Vec::new();
        self.check()?;
        for (&v, &t) in self.mesh.faces.iter().flatten().zip(self.uv_faces.iter().flatten()) {
            let uv = self.uv[t as usize];
            let known = *place[v as usize].get_or_insert(uv);
            if known.iter().zip(&uv).any(|(a, b)| a.partial_cmp(b) != Some(std::cmp::Ordering::Equal)) {
                seams.push(v);
            }
        }
        seams.sort_unstable();
        seams.dedup();
        if let Some(&vertex) = seams.first() {
            return Err(UvError::Seams { vertices: seams.len(), vertex });
        }
        let uv = place.into_iter().map(Option::unwrap_or_default).collect();
        Ok([Complex::from(self.mesh.clone()), plane(uv, &self.mesh.faces)])
    }

    /// The surface cut open along the seams, in space and in the plane: one vertex for every pair of a vertex and its
    /// texture coordinate, numbered by first use.
    ///
    /// # Errors
    /// [`UvError::TooMany`], [`UvError::Index`].
    pub fn cut(&self) -> Result<[Complex; 2], UvError> {
        self.check()?;
        let mut ids: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let (mut points, mut uv, mut faces) = (Vec::new(), Vec::new(), Vec::new());
        for (face, uv_face) in self.mesh.faces.iter().zip(&self.uv_faces) {
            let mut corners = [0; 3];
            for ((corner, &v), &t) in corners.iter_mut().zip(face).zip(uv_face) {
                let next = u32::try_from(ids.len()).map_err(|_| UvError::TooMany)?;
                *corner = *ids.entry((v, t)).or_insert(next);
                if *corner == next {
                    points.push(self.mesh.vertices[v as usize]);
                    uv.push(self.uv[t as usize]);
                }
            }
            faces.push(corners);
        }
        let flat = plane(uv, &faces);
        Ok([Complex::from(TriMesh { vertices: points, faces }), flat])
    }
}
