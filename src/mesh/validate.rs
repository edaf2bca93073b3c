//! Whether a mesh is an oriented manifold without flat triangles, and facts about it.

use super::TriMesh;
use super::area::is_zero_area;
use super::connectivity::{Connectivity, Edge};
use super::error::MeshError;
use serde::Serialize;
use std::fmt;
use thiserror::Error;

/// How many defects of one kind a [`Report`] lists; all are counted.
pub const LISTED: usize = 16;

/// One defect, by element ids (all counted from 0).
#[derive(Clone, Debug, PartialEq, Error, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Defect {
    /// There is nothing to prove anything about.
    #[error("the mesh has no faces")]
    NoFaces,
    /// A face names a vertex that does not exist.
    #[error("face {face}: vertex index {index} is out of range (the mesh has {vertices} vertices)")]
    IndexOutOfRange {
        /// The face.
        face: usize,
        /// The index it uses.
        index: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// NaN or infinity.
    #[error("vertex {vertex}: coordinate {axis} is {value}, not a finite number")]
    NotFinite {
        /// The vertex.
        vertex: usize,
        /// `x`, `y` or `z`.
        axis: char,
        /// The coordinate as text: JSON has no NaN.
        value: String,
    },
    /// A face with the same vertex at two corners.
    #[error("face {face}: vertex {vertex} stands at two corners")]
    RepeatedCorner {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: u32,
    },
    /// A triangle whose corners lie exactly on one line.
    #[error("face {face}: the area is exactly zero (vertices {} {} {})", vertices[0], vertices[1], vertices[2])]
    ZeroArea {
        /// The face.
        face: usize,
        /// Its vertices.
        vertices: [u32; 3],
    },
    /// Two faces on the same three vertices.
    #[error("faces {} and {} have the same three vertices", faces[0], faces[1])]
    DuplicateFace {
        /// The faces.
        faces: [usize; 2],
    },
    /// An edge in more than two faces.
    #[error("edge {} {} lies in {faces} faces, among them {} {} {}", vertices[0], vertices[1], first[0], first[1], first[2])]
    NonManifoldEdge {
        /// The edge.
        vertices: [u32; 2],
        /// Number of its faces.
        faces: usize,
        /// Its first three faces.
        first: [usize; 3],
    },
    /// Two neighbours run along their common edge in the same direction.
    #[error("edge {} {}: faces {} and {} are oriented against each other", vertices[0], vertices[1], faces[0], faces[1])]
    InconsistentOrientation {
        /// The edge, in the direction of both faces.
        vertices: [u32; 2],
        /// The faces.
        faces: [usize; 2],
    },
    /// The faces at a vertex are not one fan.
    #[error("vertex {vertex}: its link has {parts} parts")]
    NonManifoldVertex {
        /// The vertex.
        vertex: u32,
        /// Number of connected parts of its link.
        parts: usize,
    },
    /// A vertex in no face. Allowed.
    #[error("vertex {vertex} is in no face")]
    UnreferencedVertex {
        /// The vertex.
        vertex: usize,
    },
    /// Two vertices with exactly equal coordinates (+0 equals -0). Allowed.
    #[error("vertices {} and {} have equal coordinates", vertices[0], vertices[1])]
    CoincidentVertices {
        /// The first vertex at this point, and a later one.
        vertices: [usize; 2],
    },
}

/// The kinds of [`Defect`], in the order in which they are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // documented at `Defect`
pub enum DefectKind {
    NoFaces,
    IndexOutOfRange,
    NotFinite,
    RepeatedCorner,
    ZeroArea,
    DuplicateFace,
    NonManifoldEdge,
    InconsistentOrientation,
    NonManifoldVertex,
    UnreferencedVertex,
    CoincidentVertices,
}

impl DefectKind {
    /// All kinds, in order.
    pub const ALL: [Self; 11] = [
        Self::NoFaces,
        Self::IndexOutOfRange,
        Self::NotFinite,
        Self::RepeatedCorner,
        Self::ZeroArea,
        Self::DuplicateFace,
        Self::NonManifoldEdge,
        Self::InconsistentOrientation,
        Self::NonManifoldVertex,
        Self::UnreferencedVertex,
        Self::CoincidentVertices,
    ];

    /// Whether a mesh with this peculiarity is accepted all the same.
    #[must_use]
    pub fn is_allowed(self) -> bool {
        matches!(self, Self::UnreferencedVertex | Self::CoincidentVertices)
    }

    /// What is counted, in words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NoFaces => "no faces",
            Self::IndexOutOfRange => "indices out of range",
            Self::NotFinite => "coordinates that are not finite",
            Self::RepeatedCorner => "faces with a repeated corner",
            Self::ZeroArea => "faces of exactly zero area",
            Self::DuplicateFace => "faces on the vertices of an earlier face",
            Self::NonManifoldEdge => "non-manifold edges",
            Self::InconsistentOrientation => "edges with inconsistent orientation",
            Self::NonManifoldVertex => "non-manifold vertices",
            Self::UnreferencedVertex => "unreferenced vertices",
            Self::CoincidentVertices => "vertices equal to an earlier vertex",
        }
    }
}

impl fmt::Display for DefectKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Defect {
    /// Which kind of defect this is.
    #[must_use]
    pub fn kind(&self) -> DefectKind {
        match self {
            Self::NoFaces => DefectKind::NoFaces,
            Self::IndexOutOfRange { .. } => DefectKind::IndexOutOfRange,
            Self::NotFinite { .. } => DefectKind::NotFinite,
            Self::RepeatedCorner { .. } => DefectKind::RepeatedCorner,
            Self::ZeroArea { .. } => DefectKind::ZeroArea,
            Self::DuplicateFace { .. } => DefectKind::DuplicateFace,
            Self::NonManifoldEdge { .. } => DefectKind::NonManifoldEdge,
            Self::InconsistentOrientation { .. } => DefectKind::InconsistentOrientation,
            Self::NonManifoldVertex { .. } => DefectKind::NonManifoldVertex,
            Self::UnreferencedVertex { .. } => DefectKind::UnreferencedVertex,
            Self::CoincidentVertices { .. } => DefectKind::CoincidentVertices,
        }
    }
}

/// Facts about a mesh. Topology is that of the faces without repeated corners and without indices
/// out of range.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshInfo {
    /// Number of vertices.
    pub vertices: usize,
    /// Number of faces.
    pub faces: usize,
    /// Number of edges.
    pub edges: usize,
    /// Sets of faces joined across edges.
    pub components: usize,
    /// Number of boundary loops.
    pub boundary_loops: usize,
    /// Referenced vertices - edges + faces.
    pub euler_characteristic: i64,
    /// Total genus of the components; `None` unless an orientable manifold.
    pub genus: Option<u64>,
    /// Least and greatest coordinates of all vertices; `None` without vertices or if one is not finite.
    pub bounding_box: Option<[[f64; 3]; 2]>,
    /// How often each kind of defect occurs (kinds that do not are left out).
    pub defects: Vec<(DefectKind, u64)>,
}

/// All defects of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Facts and total counts.
    pub info: MeshInfo,
    /// The first [`LISTED`] defects of each kind, in the order of [`DefectKind::ALL`].
    pub listed: Vec<Defect>,
}

impl Report {
    /// Whether the mesh is an oriented manifold without flat triangles.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.first().is_none()
    }

    /// The first defect that is not allowed.
    #[must_use]
    pub fn first(&self) -> Option<&Defect> {
        self.listed.iter().find(|d| !d.kind().is_allowed())
    }

    /// How often a kind of defect occurs.
    #[must_use]
    pub fn count(&self, kind: DefectKind) -> u64 {
        self.info.defects.iter().find(|(k, _)| *k == kind).map_or(0, |(_, n)| *n)
    }
}

/// A mesh that satisfies the input conditions: an oriented manifold without flat triangles.
#[derive(Clone, Debug)]
pub struct ValidMesh<'a> {
    mesh: &'a TriMesh,
    connectivity: Connectivity,
    info: MeshInfo,
}

impl<'a> ValidMesh<'a> {
    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &'a TriMesh {
        self.mesh
    }

    /// Its adjacency.
    #[must_use]
    pub fn connectivity(&self) -> &Connectivity {
        &self.connectivity
    }

    /// Facts about it, allowed peculiarities included.
    #[must_use]
    pub fn info(&self) -> &MeshInfo {
        &self.info
    }
}

/// Finds all defects of a mesh, exactly. O(n log n).
///
/// # Errors
/// [`MeshError::TooManyFaces`] only.
pub fn validate(mesh: &TriMesh) -> Result<Report, MeshError> {
    validate_listing(mesh, LISTED)
}

/// As [`validate`], with up to `limit` defects of each kind listed.
///
/// # Errors
/// [`MeshError::TooManyFaces`] only.
pub fn validate_listing(mesh: &TriMesh, limit: usize) -> Result<Report, MeshError> {
    examine(mesh, limit).map(|(report, _)| report)
}

/// Facts about a mesh, defect counts included. O(n log n).
///
/// # Errors
/// [`MeshError::TooManyFaces`] only.
pub fn mesh_info(mesh: &TriMesh) -> Result<MeshInfo, MeshError> {
    validate(mesh).map(|report| report.info)
}

/// Accepts a mesh that satisfies the input conditions. O(n log n).
///
/// # Errors
/// [`MeshError::Invalid`] with the first defect, [`MeshError::TooManyFaces`].
pub fn check(mesh: &TriMesh) -> Result<ValidMesh<'_>, MeshError> {
    let (report, connectivity) = examine(mesh, LISTED)?;
    match report.first() {
        Some(defect) => Err(MeshError::Invalid(defect.clone())),
        None => Ok(ValidMesh { mesh, connectivity, info: report.info }),
    }
}

/// The first index out of range, as an error.
pub(super) fn indices_in_range(vertices: usize, faces: &[[u32; 3]]) -> Result<(), MeshError> {
    for (face, corners) in faces.iter().enumerate() {
        if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices) {
            return Err(MeshError::Invalid(Defect::IndexOutOfRange { face, index, vertices }));
        }
    }
    Ok(())
}

/// Defects found so far: counts, and the first few of each kind.
struct Findings {
    limit: usize,
    listed: Vec<Defect>,
    counts: Vec<(DefectKind, u64)>,
}

impl Findings {
    /// Defects of one kind must come one after another, kinds in their order.
    fn add(&mut self, defect: Defect) {
        let kind = defect.kind();
        match self.counts.last_mut() {
            Some((last, n)) if *last == kind => *n += 1,
            _ => self.counts.push((kind, 1)),
        }
        if self.counts.last().is_some_and(|(_, n)| *n <= self.limit as u64) {
            self.listed.push(defect);
        }
    }
}

fn examine(mesh: &TriMesh, limit: usize) -> Result<(Report, Connectivity), MeshError> {
    let mut found = Findings { limit, listed: Vec::new(), counts: Vec::new() };
    let ids = elements(mesh, &mut found);
    let sound: Vec<[u32; 3]> = ids.iter().map(|&f| mesh.faces[f]).collect();
    let connectivity = Connectivity::new(mesh.vertices.len(), &sound)?;
    zero_areas(mesh, &ids, &mut found);
    duplicates(mesh, &ids, &mut found);
    edges(&connectivity, &ids, &mut found);
    vertices(mesh, &connectivity, &mut found);
    let info = MeshInfo {
        vertices: mesh.vertices.len(),
        faces: mesh.faces.len(),
        edges: connectivity.edge_count(),
        components: connectivity.component_count(),
        boundary_loops: connectivity.boundary_loop_count(),
        euler_characteristic: connectivity.euler_characteristic(),
        genus: connectivity.genus().filter(|_| ids.len() == mesh.faces.len()),
        bounding_box: bounding_box(&mesh.vertices),
        defects: found.counts,
    };
    Ok((Report { info, listed: found.listed }, connectivity))
}

/// Checks faces and coordinates one by one; returns the faces that have three different vertices.
fn elements(mesh: &TriMesh, found: &mut Findings) -> Vec<usize> {
    let vertices = mesh.vertices.len();
    if mesh.faces.is_empty() {
        found.add(Defect::NoFaces);
    }
    for (face, corners) in mesh.faces.iter().enumerate() {
        for &index in corners.iter().filter(|&&i| i as usize >= vertices) {
            found.add(Defect::IndexOutOfRange { face, index, vertices });
        }
    }
    for (vertex, point) in mesh.vertices.iter().enumerate() {
        for (value, axis) in point.iter().zip(['x', 'y', 'z']).filter(|(x, _)| !x.is_finite()) {
            found.add(Defect::NotFinite { vertex, axis, value: value.to_string() });
        }
    }
    let mut sound = Vec::with_capacity(mesh.faces.len());
    for (face, &[a, b, c]) in mesh.faces.iter().enumerate() {
        if a == b || b == c || c == a {
            let vertex = if b == c { b } else { a };
            found.add(Defect::RepeatedCorner { face, vertex });
        } else if [a, b, c].iter().all(|&i| (i as usize) < vertices) {
            sound.push(face);
        }
    }
    sound
}

fn zero_areas(mesh: &TriMesh, ids: &[usize], found: &mut Findings) {
    for &face in ids {
        let vertices = mesh.faces[face];
        let points = vertices.map(|v| &mesh.vertices[v as usize]);
        // Points that are not finite have been reported as such.
        let finite = points.iter().all(|p| p.iter().all(|x| x.is_finite()));
        if finite && is_zero_area(points) {
            found.add(Defect::ZeroArea { face, vertices });
        }
    }
}

fn duplicates(mesh: &TriMesh, ids: &[usize], found: &mut Findings) {
    let mut keyed: Vec<([u32; 3], usize)> = ids
        .iter()
        .map(|&face| {
            let mut key = mesh.faces[face];
            key.sort_unstable();
            (key, face)
        })
        .collect();
    keyed.sort_unstable();
    for group in keyed.chunk_by(|a, b| a.0 == b.0) {
        for later in &group[1..] {
            found.add(Defect::DuplicateFace { faces: [group[0].1, later.1] });
        }
    }
}

fn edges(connectivity: &Connectivity, ids: &[usize], found: &mut Findings) {
    let faces = |edge: &Edge<'_>, i: usize| ids[edge.sides[i].face() as usize];
    for edge in connectivity.edges().filter(|e| e.sides.len() > 2) {
        let first = [0, 1, 2].map(|i| faces(&edge, i));
        found.add(Defect::NonManifoldEdge { vertices: edge.vertices, faces: edge.sides.len(), first });
    }
    for edge in connectivity.edges() {
        if let &[s, t] = edge.sides
            && connectivity.ends(s) == connectivity.ends(t)
        {
            let vertices = connectivity.ends(s);
            found.add(Defect::InconsistentOrientation { vertices, faces: [0, 1].map(|i| faces(&edge, i)) });
        }
    }
}

fn vertices(mesh: &TriMesh, connectivity: &Connectivity, found: &mut Findings) {
    // Face corners are u32, so no vertex beyond can be referenced.
    let reachable = u32::try_from(mesh.vertices.len()).unwrap_or(u32::MAX);
    for vertex in 0..reachable {
        let parts = connectivity.link_parts(vertex);
        if parts > 1 {
            found.add(Defect::NonManifoldVertex { vertex, parts });
        }
    }
    for vertex in 0..mesh.vertices.len() {
        if u32::try_from(vertex).map_or(true, |v| connectivity.star(v).is_empty()) {
            found.add(Defect::UnreferencedVertex { vertex });
        }
    }
    for pair in coincident(&mesh.vertices) {
        found.add(Defect::CoincidentVertices { vertices: pair });
    }
}

/// For each vertex that equals an earlier one: the first such vertex and itself, sorted by itself.
fn coincident(vertices: &[[f64; 3]]) -> Vec<[usize; 2]> {
    // Adding +0 turns -0 into +0 and changes nothing else; NaN equals nothing and is left out.
    let mut keyed: Vec<([u64; 3], usize)> = vertices
        .iter()
        .enumerate()
        .filter(|(_, p)| p.iter().all(|x| !x.is_nan()))
        .map(|(i, p)| (p.map(|x| (x + 0.0).to_bits()), i))
        .collect();
    keyed.sort_unstable();
    let mut pairs: Vec<[usize; 2]> = keyed
        .chunk_by(|a, b| a.0 == b.0)
        .flat_map(|group| group[1..].iter().map(|later| [group[0].1, later.1]))
        .collect();
    pairs.sort_unstable_by_key(|pair| pair[1]);
    pairs
}

fn bounding_box(vertices: &[[f64; 3]]) -> Option<[[f64; 3]; 2]> {
    let mut bounds = [*vertices.first()?; 2];
    for point in vertices {
        for (axis, &x) in point.iter().enumerate() {
            if !x.is_finite() {
                return None;
            }
            bounds[0][axis] = bounds[0][axis].min(x);
            bounds[1][axis] = bounds[1][axis].max(x);
        }
    }
    Some(bounds)
}
