//! Tests of the transfer: against the slow exact maps, round trips, bounds, hostile input.

// Equality of doubles is what these tests mean where they say so.
#![allow(clippy::float_cmp)]

mod hostile;
mod maps;
mod real;

use super::ExactPoint;
use crate::construct::{icosphere, sample};
use crate::mesh::TriMesh;
use crate::shell::Shell;

/// A shell around an icosphere and two sections of it: a finer, bumpy one, and one of another connectivity.
pub(super) fn generated() -> (Shell, TriMesh, TriMesh) {
    let made = sample(1);
    // Turned, so that no vertex is on a pillar.
    let turn = |[x, y, z]: [f64; 3]| [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, z].map(|x| x * 1.015_625);
    let fine = icosphere(3);
    let turned = TriMesh { vertices: fine.vertices.into_iter().map(turn).collect(), faces: fine.faces };
    (made.shell, made.mesh, turned)
}

/// A small generator of pseudo-random numbers.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    pub(super) fn unit(&mut self) -> f64 {
        self.next() as f64 / (1_u64 << 31) as f64
    }
}

/// Points of a mesh: corners, points of edges, inner points, by turns.
pub(super) fn points(mesh: &TriMesh, count: usize, seed: u64) -> Vec<(u32, [f64; 3])> {
    let mut random = Random(seed);
    let mut one = |i: usize| {
        let face = (random.next() % mesh.faces.len() as u64) as u32;
        let mut weights = [random.unit(), random.unit(), random.unit()];
        match i % 4 {
            0 => weights = [0.0, 1.0, 0.0],
            1 => weights[i % 3] = 0.0,
            _ => {}
        }
        (face, weights)
    };
    (0..count).map(&mut one).collect()
}

pub(super) fn exact((face, weights): (u32, [f64; 3])) -> ExactPoint {
    ExactPoint::from_f64(face, weights).unwrap()
}
