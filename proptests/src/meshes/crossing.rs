//! Surfaces that cross themselves.

use homeo::mesh::TriMesh;

use super::{Random, grid, id, joined, map, sphere};

/// Names and meshes.
#[must_use]
pub fn crossing(random: &mut Random) -> Vec<(&'static str, TriMesh)> {
    vec![
        ("figure-eight sheet", eight_sheet(random)),
        ("figure-eight tube", eight_tube(random)),
        ("spike through a sheet", spike(random)),
        ("two spheres", joined(sphere(2), &map(sphere(1), |[x, y, z]| [x + 0.8, y + 0.1, z]))),
        ("crossing at a fold", folds(random)),
    ]
}

/// A strip along a figure eight.
fn eight_sheet(random: &mut Random) -> TriMesh {
    let open = 0.2;
    grid(24, 3, random, |i, j| {
        let t = open + (std::f64::consts::TAU - 2.0 * open) * i / 24.0 + 0.9;
        [2.0 * t.sin(), (2.0 * t).sin(), 0.3 * j]
    })
}

/// A closed tube along a figure eight.
fn eight_tube(random: &mut Random) -> TriMesh {
    let (n, m) = (28, 8);
    let mut mesh = TriMesh::default();
    let tau = std::f64::consts::TAU;
    for i in 0..n {
        let t = tau * i as f64 / n as f64;
        let (dx, dy) = (2.0 * t.cos(), 2.0 * (2.0 * t).cos());
        let length = dx.hypot(dy);
        for j in 0..m {
            let (s, c) = (tau * j as f64 / m as f64).sin_cos();
            let r = 0.25;
            mesh.vertices.push([
                2.0 * t.sin() + r * c * dy / length,
                (2.0 * t).sin() - r * c * dx / length,
                r * s + 0.02 * random.real(),
            ]);
        }
    }
    let at = |i: usize, j: usize| id(i % n * m + j % m);
    for i in 0..n {
        for j in 0..m {
            mesh.faces.extend(super::split([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], random));
        }
    }
    mesh
}

/// A sharp spike of one sheet through the middle of another.
fn spike(random: &mut Random) -> TriMesh {
    let lower = grid(4, 4, random, |x, y| [x, y, if x == 2.0 && y == 2.0 { 3.0 } else { 0.0 }]);
    let upper = grid(4, 4, random, |x, y| [x + 0.1, y - 0.2, 1.0]);
    joined(lower, &upper)
}

/// A sharp fold that dips into another sheet of the same surface, itself sharply folded there.
fn folds(random: &mut Random) -> TriMesh {
    grid(14, 3, random, |i, j| {
        let profile = [
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [3.0, 2.0],
            [4.0, 0.0],
            [5.0, 0.0],
            [6.0, 1.0],
            [6.0, 3.0],
            [5.0, 4.0],
            [4.0, 4.0],
            [3.2, 1.2],
            [2.4, 4.0],
            [1.0, 4.0],
            [0.0, 4.0],
            [-1.0, 4.0],
        ];
        let [x, y] = profile[i as usize];
        [x, y, j]
    })
}
