//! Which triangles meet where: from faces alone, coordinates play no part.
//!
//! Face `f` has three *sides*; side `i` is opposite to corner `i` and runs from corner `i + 1` to
//! corner `i + 2` (mod 3). A [`Side`] is the number `3 f + i`; the same number names the *corner*
//! `i` of `f`. Everything is built by sorting, so that nothing depends on the order of a hash table.
//! Any faces are accepted, manifold or not; what is not manifold is there to be asked for.
//! Handles given to a query must be of the same mesh: others panic, as an index out of range does.

use super::error::MeshError;

/// Handle of a side of a face, or of the corner opposite to it: `3 * face + corner`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Side(u32);

impl Side {
    /// Side `corner` (0, 1 or 2, taken mod 3) of a face. The face must be one of a [`Connectivity`].
    #[must_use]
    pub fn new(face: u32, corner: u32) -> Self {
        Self(face.wrapping_mul(3).wrapping_add(corner % 3))
    }

    /// The face.
    #[must_use]
    pub fn face(self) -> u32 {
        self.0 / 3
    }

    /// The corner opposite to the side: 0, 1 or 2.
    #[must_use]
    pub fn corner(self) -> u32 {
        self.0 % 3
    }

    /// The next side of the same face.
    #[must_use]
    pub fn next(self) -> Self {
        Self::new(self.face(), self.corner() + 1)
    }

    /// The previous side of the same face.
    #[must_use]
    pub fn previous(self) -> Self {
        Self::new(self.face(), self.corner() + 2)
    }

    fn position(self) -> usize {
        self.0 as usize
    }
}

/// No side or face.
const NONE: u32 = u32::MAX;

/// Adjacency of a list of triangles. Building takes O(n log n) time, every query O(its answer).
#[derive(Clone, Debug)]
pub struct Connectivity {
    /// Vertex opposite to each side, three a face: the faces, flat.
    corners: Vec<u32>,
    /// The side across each side, where exactly two meet.
    mates: Vec<u32>,
    /// Sides sorted by edge, then by number.
    by_edge: Vec<Side>,
    /// Where each edge begins in `by_edge`; one more entry for the end.
    edge_starts: Vec<u32>,
    /// Corners sorted by vertex, then by number.
    by_vertex: Vec<Side>,
    /// Where each vertex begins in `by_vertex`; one more entry for the end.
    vertex_starts: Vec<u32>,
    /// The representative corner of each corner's fan.
    fans: Vec<u32>,
    /// The component of each face.
    component: Vec<u32>,
    components: usize,
    boundary_loops: usize,
    orientable: bool,
}

/// An edge: two vertices and the sides that lie on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge<'a> {
    /// Its vertices, smaller first.
    pub vertices: [u32; 2],
    /// The sides on it, in ascending order.
    pub sides: &'a [Side],
}

impl Connectivity {
    /// Largest number of faces that handles can name.
    pub const MAX_FACES: usize = (u32::MAX / 3) as usize;

    /// Builds the adjacency of `faces` over vertices `0..vertices`.
    ///
    /// # Errors
    /// [`MeshError::TooManyFaces`], or [`MeshError::Invalid`] for an index out of range.
    pub fn new(vertices: usize, faces: &[[u32; 3]]) -> Result<Self, MeshError> {
        if faces.len() > Self::MAX_FACES {
            return Err(MeshError::TooManyFaces { faces: faces.len(), limit: Self::MAX_FACES });
        }
        super::validate::indices_in_range(vertices, faces)?;
        let mut built = Self {
            corners: faces.as_flattened().to_vec(),
            mates: Vec::new(),
            by_edge: Vec::new(),
            edge_starts: Vec::new(),
            by_vertex: Vec::new(),
            vertex_starts: Vec::new(),
            fans: Vec::new(),
            component: Vec::new(),
            components: 0,
            boundary_loops: 0,
            orientable: true,
        };
        built.sort_edges();
        built.sort_vertices(vertices);
        built.join_fans();
        built.join_components();
        built.count_boundary_loops();
        built.find_orientation();
        Ok(built)
    }

    /// Number of faces.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.corners.len() / 3
    }

    /// Number of edges.
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.edge_starts.len().saturating_sub(1)
    }

    /// Number of vertices, unreferenced ones included.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_starts.len().saturating_sub(1)
    }

    /// Number of vertices that a face uses.
    #[must_use]
    pub fn referenced_vertex_count(&self) -> usize {
        self.vertex_starts.windows(2).filter(|w| w[0] < w[1]).count()
    }

    /// The vertex at a corner.
    #[must_use]
    pub fn vertex(&self, corner: Side) -> u32 {
        self.corners[corner.position()]
    }

    /// The ends of a side, in the direction of its face.
    #[must_use]
    pub fn ends(&self, side: Side) -> [u32; 2] {
        [self.vertex(side.next()), self.vertex(side.previous())]
    }

    /// The side across a side, where exactly two sides lie on the edge.
    #[must_use]
    pub fn mate(&self, side: Side) -> Option<Side> {
        let mate = self.mates[side.position()];
        (mate != NONE).then_some(Side(mate))
    }

    /// The faces across the three sides of a face; side `i` is opposite to corner `i`.
    #[must_use]
    pub fn neighbours(&self, face: u32) -> [Option<u32>; 3] {
        [0, 1, 2].map(|i| self.mate(Side::new(face, i)).map(Side::face))
    }

    /// All edges, sorted by their vertices.
    pub fn edges(&self) -> impl Iterator<Item = Edge<'_>> {
        self.edge_starts.windows(2).map(|w| {
            let sides = &self.by_edge[w[0] as usize..w[1] as usize];
            Edge { vertices: self.edge_key(sides[0]), sides }
        })
    }

    /// The sides that are alone on their edge, sorted by edge.
    pub fn boundary(&self) -> impl Iterator<Item = Side> {
        self.edges().filter(|e| e.sides.len() == 1).map(|e| e.sides[0])
    }

    /// The corners at a vertex, in ascending order: its star.
    #[must_use]
    pub fn star(&self, vertex: u32) -> &[Side] {
        let v = vertex as usize;
        &self.by_vertex[self.vertex_starts[v] as usize..self.vertex_starts[v + 1] as usize]
    }

    /// Number of connected parts of a vertex's link (0 for an unreferenced vertex, 1 for a manifold one).
    #[must_use]
    pub fn link_parts(&self, vertex: u32) -> usize {
        self.star(vertex).iter().filter(|c| self.fans[c.position()] == c.0).count()
    }

    /// The component of a face; components are faces joined across edges, numbered by first face.
    #[must_use]
    pub fn component(&self, face: u32) -> u32 {
        self.component[face as usize]
    }

    /// Number of components.
    #[must_use]
    pub fn component_count(&self) -> usize {
        self.components
    }

    /// Number of boundary loops.
    #[must_use]
    pub fn boundary_loop_count(&self) -> usize {
        self.boundary_loops
    }

    /// Referenced vertices - edges + faces.
    #[must_use]
    pub fn euler_characteristic(&self) -> i64 {
        let n = |x: usize| i64::try_from(x).unwrap_or(i64::MAX);
        n(self.referenced_vertex_count()) - n(self.edge_count()) + n(self.face_count())
    }

    /// Whether faces could be flipped so that neighbours agree.
    #[must_use]
    pub fn is_orientable(&self) -> bool {
        self.orientable
    }

    /// Whether every edge lies in at most two faces, every link is connected and no face repeats a corner.
    #[must_use]
    pub fn is_manifold(&self) -> bool {
        self.edges().all(|e| e.sides.len() <= 2 && e.vertices[0] != e.vertices[1])
            && (0..self.vertex_count()).all(|v| u32::try_from(v).is_ok_and(|v| self.link_parts(v) <= 1))
    }

    /// Total genus of the components of an orientable manifold: `2 c - 2 g - b = euler`. `None` for others.
    #[must_use]
    pub fn genus(&self) -> Option<u64> {
        if !self.orientable || !self.is_manifold() {
            return None;
        }
        let n = |x: usize| i64::try_from(x).ok();
        let twice =
            n(self.components)?.checked_mul(2)? - self.euler_characteristic() - n(self.boundary_loops)?;
        u64::try_from(twice).ok().map(|t| t / 2)
    }

    fn edge_key(&self, side: Side) -> [u32; 2] {
        let [a, b] = self.ends(side);
        [a.min(b), a.max(b)]
    }

    fn sides(&self) -> impl Iterator<Item = Side> + use<> {
        // `new` has bounded the number of faces, so the numbers fit.
        (0..u32::try_from(self.corners.len()).unwrap_or(0)).map(Side)
    }

    fn sort_edges(&mut self) {
        let mut keyed: Vec<([u32; 2], Side)> = self.sides().map(|s| (self.edge_key(s), s)).collect();
        keyed.sort_unstable();
        self.mates = vec![NONE; self.corners.len()];
        self.edge_starts.push(0);
        let mut end = 0;
        for group in keyed.chunk_by(|a, b| a.0 == b.0) {
            end += group.len() as u32;
            self.edge_starts.push(end);
            if let [(_, s), (_, t)] = group {
                self.mates[s.position()] = t.0;
                self.mates[t.position()] = s.0;
            }
        }
        self.by_edge = keyed.into_iter().map(|(_, s)| s).collect();
    }

    fn sort_vertices(&mut self, vertices: usize) {
        self.vertex_starts = vec![0; vertices + 1];
        for &v in &self.corners {
            self.vertex_starts[v as usize + 1] += 1;
        }
        for v in 0..vertices {
            self.vertex_starts[v + 1] += self.vertex_starts[v];
        }
        let mut free = self.vertex_starts.clone();
        self.by_vertex = vec![Side(0); self.corners.len()];
        for corner in self.sides() {
            let slot = &mut free[self.corners[corner.position()] as usize];
            self.by_vertex[*slot as usize] = corner;
            *slot += 1;
        }
    }

    /// Joins corners at one vertex whose faces share an edge there: the parts of the vertex's link.
    fn join_fans(&mut self) {
        let mut sets = Sets::new(self.corners.len());
        for edge in self.edges() {
            for pair in edge.sides.windows(2) {
                for v in edge.vertices {
                    if let (Some(a), Some(b)) = (self.corner_at(pair[0], v), self.corner_at(pair[1], v)) {
                        sets.join(a.0, b.0);
                    }
                }
            }
        }
        self.fans = sets.representatives();
    }

    /// The corner at vertex `v` where a side begins or ends.
    fn corner_at(&self, side: Side, v: u32) -> Option<Side> {
        [side.next(), side.previous()].into_iter().find(|&c| self.vertex(c) == v)
    }

    fn join_components(&mut self) {
        let mut sets = Sets::new(self.face_count());
        for edge in self.edges() {
            for pair in edge.sides.windows(2) {
                sets.join(pair[0].face(), pair[1].face());
            }
        }
        let representatives = sets.representatives();
        // A representative is the smallest face of its set, so it comes first.
        let mut component = vec![0; representatives.len()];
        let mut count = 0;
        for (face, &first) in representatives.iter().enumerate() {
            if first as usize == face {
                component[face] = count;
                count += 1;
            } else {
                component[face] = component[first as usize];
            }
        }
        self.component = component;
        self.components = count as usize;
    }

    /// Boundary sides are joined where they bound the same fan; the sets are the loops.
    fn count_boundary_loops(&mut self) {
        let boundary: Vec<Side> = self.boundary().collect();
        let mut ends: Vec<(u32, u32)> = Vec::with_capacity(boundary.len() * 2);
        for (i, &side) in boundary.iter().enumerate() {
            for corner in [side.next(), side.previous()] {
                ends.push((self.fans[corner.position()], i as u32));
            }
        }
        ends.sort_unstable();
        let mut sets = Sets::new(boundary.len());
        for pair in ends.windows(2).filter(|w| w[0].0 == w[1].0) {
            sets.join(pair[0].1, pair[1].1);
        }
        let representatives = sets.representatives();
        self.boundary_loops = representatives.iter().enumerate().filter(|&(i, &r)| r as usize == i).count();
    }

    /// Walks over all faces and flips them to agree; a contradiction means not orientable.
    fn find_orientation(&mut self) {
        let mut flipped: Vec<Option<bool>> = vec![None; self.face_count()];
        let mut stack = Vec::new();
        for start in 0..self.face_count() {
            if flipped[start].is_some() {
                continue;
            }
            flipped[start] = Some(false);
            stack.push(start as u32);
            while let Some(face) = stack.pop() {
                let own = flipped[face as usize].unwrap_or(false);
                for side in [0, 1, 2].map(|i| Side::new(face, i)) {
                    let Some(mate) = self.mate(side) else { continue };
                    let needed = own ^ (self.ends(side) == self.ends(mate));
                    match &mut flipped[mate.face() as usize] {
                        Some(known) => self.orientable &= *known == needed,
                        unknown => {
                            *unknown = Some(needed);
                            stack.push(mate.face());
                        }
                    }
                }
            }
        }
    }
}

/// Disjoint sets of `0..n`; each is represented by its smallest member. `n` fits `u32`.
pub(crate) struct Sets {
    parent: Vec<u32>,
}

impl Sets {
    pub(crate) fn new(n: usize) -> Self {
        Self { parent: (0..n).map(|i| i as u32).collect() }
    }

    /// The smallest member of the set.
    pub(crate) fn find(&mut self, mut i: u32) -> u32 {
        while self.parent[i as usize] != i {
            let up = self.parent[self.parent[i as usize] as usize];
            self.parent[i as usize] = up;
            i = up;
        }
        i
    }

    pub(crate) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }

    fn representatives(mut self) -> Vec<u32> {
        (0..self.parent.len()).map(|i| self.find(i as u32)).collect()
    }
}
