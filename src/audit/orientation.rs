//! A hint, no verdict: are two closed surfaces oriented in opposite ways?

use crate::mesh::{Connectivity, TriMesh};

/// A volume below this share of its bounding box's is as good as none: no hint.
const LEAST: f64 = 1e-6;

/// Have two closed surfaces volumes of different signs? In floating point. O(n).
#[must_use]
pub(crate) fn seems_opposite(meshes: [&TriMesh; 2], connectivity: [&Connectivity; 2]) -> bool {
    let [a, b] = meshes.map(share_of_box);
    connectivity.iter().all(|c| c.boundary().next().is_none())
        && a.abs() > LEAST
        && b.abs() > LEAST
        && (a > 0.0) != (b > 0.0)
}

/// The volume that a closed surface encloses, as a share of its bounding box; negative where it faces inwards.
fn share_of_box(mesh: &TriMesh) -> f64 {
    let ends = mesh.vertices.iter().fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [std::array::from_fn(|i| low[i].min(p[i])), std::array::from_fn(|i| high[i].max(p[i]))]
    });
    // Each axis by itself has length one: no product leaves the range of doubles.
    let local = |v: u32| -> [f64; 3] {
        let p = mesh.vertices[v as usize];
        std::array::from_fn(|i| (p[i] - ends[0][i]) / (ends[1][i] - ends[0][i]))
    };
    let six_times = |face: &[u32; 3]| {
        let [a, b, c] = face.map(local);
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    mesh.faces.iter().map(six_times).sum::<f64>() / 6.0
}
