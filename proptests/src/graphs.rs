//! Graphs over flat shells with upright pillars: remeshings of the middle surface, lifted to random heights.
//!
//! There the projection is the vertical one. So a mesh that keeps the planar triangulation positive, its boundary on the
//! boundary and its heights between bottom and top is a section for every vertex order, faces up everywhere and crosses
//! nothing: the claims hold by this argument, not by a computation. One planar triangle turned over, one height on a cap
//! or one missing triangle, and there is no section.

use homeo::mesh::TriMesh;
use homeo::shell::Shell;
use proptest::prelude::*;

use crate::oracle::boundary;
use crate::oracle::exact::{on_grid, orient, positive};
use crate::recipe::Case;
use crate::shapes::shape;
use crate::sheets::{Edit, edit};

/// The flat upright shapes; their bottoms and tops are 4 away.
const FLAT: [u32; 7] = [0, 1, 2, 3, 4, 5, 13];
const HEIGHT: f64 = 4.0;

/// A graph, as numbers.
#[derive(Clone, Debug)]
pub struct Graph {
    /// Index of the shape.
    pub shape: usize,
    /// Kinds and places of remeshing steps.
    pub steps: Vec<(u8, u8)>,
    /// Heights of the vertices in 32nds of the way to the top, repeated as needed.
    pub heights: Vec<i8>,
    /// A shuffle of the order.
    pub order: u16,
}

/// Random graphs.
pub fn graphs() -> impl Strategy<Value = Graph> {
    let steps = prop::collection::vec((0..3u8, any::<u8>()), 0..5);
    (0..FLAT.len(), steps, prop::collection::vec(-31i8..32, 1..12), any::<u16>())
        .prop_map(|(shape, steps, heights, order)| Graph { shape, steps, heights, order })
}

/// The doubled area of a face seen from above, as an exact sign; and of all faces.
#[must_use]
pub fn all_face_up(mesh: &TriMesh) -> bool {
    mesh.faces.iter().all(|f| {
        let flat = f.map(|v| mesh.vertices[v as usize]).map(|p| [p[0], p[1], 0.0]);
        // The grid is one for all four points: a point above the first one makes the area a volume.
        let above = [flat[0][0], flat[0][1], 1.0];
        let grid = on_grid(&[flat[0], flat[1], flat[2], above]);
        positive(&orient(&grid[0], &grid[1], &grid[2], &grid[3]))
    })
}

impl Graph {
    /// Shell, graph and order.
    ///
    /// # Panics
    /// Never for recipes of [`graphs`].
    #[must_use]
    pub fn build(&self) -> Case {
        let shell: Shell = shape(FLAT[self.shape]);
        let mut mesh = TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() };
        for &(kind, at) in &self.steps {
            let before = mesh.clone();
            // Splits at means with weights that are powers of two, and flips: exact.
            let kind = [15, 5, 8][usize::from(kind)];
            edit(&mut mesh, &shell, &Edit { kind, at, pick: [0; 3] });
            if !all_face_up(&mesh) {
                mesh = before;
            }
        }
        for (p, k) in mesh.vertices.iter_mut().zip((0..).map(|i| self.heights[i % self.heights.len()])) {
            p[2] += HEIGHT * f64::from(k) / 32.0;
        }
        let order = crate::recipe::shuffled(shell.middle.len(), self.order);
        Case { shell, mesh, order }
    }
}

/// A vertex of the mesh off its boundary.
#[must_use]
pub fn interior_vertex(mesh: &TriMesh, pick: usize) -> Option<usize> {
    let rim = boundary(&mesh.faces);
    let on_rim = |v: u32| rim.iter().any(|edge| edge.contains(&v));
    let free: Vec<usize> = (0..mesh.vertices.len()).filter(|&v| !on_rim(u32::try_from(v).unwrap())).collect();
    (!free.is_empty()).then(|| free[pick % free.len()])
}

/// The last double along the way for which `passes`, and the first one for which it does not, if there is such a change
/// between `good` and `bad`.
pub fn to_the_last_ulp(mut good: f64, mut bad: f64, passes: impl Fn(f64) -> bool) -> Option<(f64, f64)> {
    if !passes(good) || passes(bad) {
        return None;
    }
    loop {
        let middle = f64::midpoint(good, bad);
        if [good, bad].contains(&middle) {
            return Some((good, bad));
        }
        if passes(middle) { good = middle } else { bad = middle }
    }
}
