//! Facts about a shell that take part in no claim.

use serde::Serialize;

use super::{PillarCounts, Shell};
use crate::mesh::{self, MeshError, TriMesh};

/// Facts about a shell. Exact, but for the thickness.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShellFacts {
    /// Number of vertices.
    pub vertices: usize,
    /// Number of prisms.
    pub prisms: usize,
    /// Number of tets over all vertex orders: 24 a prism, 8 fewer for each pinched corner.
    pub tets: usize,
    /// Pillars by kind.
    pub pillars: PillarCounts,
    /// The pinched vertices, ascending.
    pub pinched_vertices: Vec<u32>,
    /// Of the middle complex: sets of prisms joined across sides.
    pub components: usize,
    /// Of the middle complex: number of sides (edges).
    pub sides: usize,
    /// Of the middle complex: number of boundary loops.
    pub boundary_loops: usize,
    /// Of the middle complex: referenced vertices - edges + triangles.
    pub euler_characteristic: i64,
    /// Of the middle complex: total genus; `None` unless it is an orientable manifold.
    pub genus: Option<u64>,
    /// Least and greatest coordinates of all bottom, middle and top points; `None` without vertices.
    pub bounding_box: Option<[[f64; 3]; 2]>,
    /// Least and greatest length of the bottom halves `b m` of the pillars, APPROXIMATE; pinched ones left out.
    pub approximate_bottom_thickness: Option<[f64; 2]>,
    /// Least and greatest length of the top halves `m t` of the pillars, APPROXIMATE; pinched ones left out.
    pub approximate_top_thickness: Option<[f64; 2]>,
}

impl ShellFacts {
    /// Facts about a shell with finite coordinates and indices in range. O(n log n).
    ///
    /// # Errors
    /// [`MeshError::TooManyFaces`] only.
    pub fn new(shell: &Shell) -> Result<Self, MeshError> {
        let middle = TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() };
        let info = mesh::mesh_info(&middle)?;
        Ok(Self {
            vertices: shell.vertex_count(),
            prisms: shell.prism_count(),
            tets: shell.tet_count(),
            pillars: shell.pillar_counts(),
            pinched_vertices: shell.pinched_vertices(),
            components: info.components,
            sides: info.edges,
            boundary_loops: info.boundary_loops,
            euler_characteristic: info.euler_characteristic,
            genus: info.genus,
            bounding_box: bounding_box(shell),
            approximate_bottom_thickness: lengths(shell, &shell.bottom, &shell.middle),
            approximate_top_thickness: lengths(shell, &shell.middle, &shell.top),
        })
    }
}

fn bounding_box(shell: &Shell) -> Option<[[f64; 3]; 2]> {
    let mut points = shell.bottom.iter().chain(&shell.middle).chain(&shell.top);
    let mut bounds = [*points.next()?; 2];
    for point in points {
        for (axis, &x) in point.iter().enumerate() {
            bounds[0][axis] = bounds[0][axis].min(x);
            bounds[1][axis] = bounds[1][axis].max(x);
        }
    }
    Some(bounds)
}

fn lengths(shell: &Shell, lo: &[[f64; 3]], hi: &[[f64; 3]]) -> Option<[f64; 2]> {
    let mut range: Option<[f64; 2]> = None;
    for (v, (a, b)) in (0_u32..).zip(lo.iter().zip(hi)) {
        if !shell.is_pinched(v) {
            let length = (b[0] - a[0]).hypot(b[1] - a[1]).hypot(b[2] - a[2]);
            let [least, greatest] = range.unwrap_or([length; 2]);
            range = Some([least.min(length), greatest.max(length)]);
        }
    }
    range
}
