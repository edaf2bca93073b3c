//! A closed mesh in a shell, made of nothing but additions, products and square roots: the same bits on every machine.

use std::collections::HashMap;

use crate::mesh::TriMesh;
use crate::shell::Shell;

/// A shell and a mesh that is a section of it, but not its middle surface.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The shell: its middle surface is an icosphere, its pillars are radial (and bent by rounding).
    pub shell: Shell,
    /// The mesh: four times as many triangles, and bumps.
    pub mesh: TriMesh,
}

/// Heights of bottom and top, as factors of the radius.
const BOTTOM: f64 = 0.8125;
const TOP: f64 = 1.1875;

/// A sample with `20 * 4^level` prisms; `level` is cut at 6.
#[must_use]
pub fn sample(level: u32) -> Sample {
    let middle = icosphere(level);
    let layer = |factor: f64| middle.vertices.iter().map(|p| p.map(|x| x * factor)).collect();
    let shell = Shell {
        bottom: layer(BOTTOM),
        middle: middle.vertices.clone(),
        top: layer(TOP),
        faces: middle.faces,
    };
    let fine = icosphere(level + 1);
    let bump = |(i, p): (usize, &[f64; 3])| {
        // A fixed pseudo-random factor of 33 values in 0.98 .. 1.02.
        let step = ((i as u64).wrapping_mul(2_654_435_761) >> 7) % 33;
        let factor = 0.98 + 0.001_25 * step as f64;
        p.map(|x| x * factor)
    };
    let mesh = TriMesh { vertices: fine.vertices.iter().enumerate().map(bump).collect(), faces: fine.faces };
    Sample { shell, mesh }
}

/// The shell with one top vertex pushed through its middle surface, as a broken tool might leave it.
#[must_use]
pub fn dent(shell: &Shell, vertex: usize) -> Shell {
    let mut out = shell.clone();
    if let (Some(top), Some(bottom)) = (out.top.get_mut(vertex), shell.bottom.get(vertex)) {
        *top = *bottom;
    }
    out
}

/// A closed surface of `20 * 4^level` triangles with vertices near the unit sphere, oriented outwards; `level` is cut
/// at 7.
#[must_use]
pub fn icosphere(level: u32) -> TriMesh {
    let mut mesh = icosahedron();
    for _ in 0..level.min(7) {
        mesh = refine(&mesh);
    }
    mesh
}

fn icosahedron() -> TriMesh {
    let g = 0.5 * (1.0 + 5_f64.sqrt());
    let corners = [
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ];
    #[rustfmt::skip]
    let faces = vec![
        [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
        [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7],
        [9, 8, 1],
    ];
    TriMesh { vertices: corners.map(onto_sphere).to_vec(), faces }
}

fn onto_sphere([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

/// Four triangles for each, with the edges' midpoints moved onto the sphere.
fn refine(mesh: &TriMesh) -> TriMesh {
    let mut vertices = mesh.vertices.clone();
    let mut midpoints: HashMap<(u32, u32), u32> = HashMap::new();
    let mut faces = Vec::with_capacity(4 * mesh.faces.len());
    for &[a, b, c] in &mesh.faces {
        let [d, e, f] = [(a, b), (b, c), (c, a)].map(|(u, v)| {
            *midpoints.entry((u.min(v), u.max(v))).or_insert_with(|| {
                let (p, q) = (vertices[u as usize], vertices[v as usize]);
                vertices.push(onto_sphere([p[0] + q[0], p[1] + q[1], p[2] + q[2]]));
                vertices.len() as u32 - 1
            })
        });
        faces.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
    }
    TriMesh { vertices, faces }
}
