//! The distance against dense sampling and known values.

use proptest::prelude::*;

use super::{Distribution, distance};
use crate::certify::Silent;
use crate::construct::{icosphere, sample};
use crate::mesh::TriMesh;
use crate::number::{Rat, Rational};
use crate::shell::Shell;

fn radial(middle: &TriMesh) -> Shell {
    let layer = |f: f64| middle.vertices.iter().map(|p| p.map(|x| x * f)).collect();
    Shell { bottom: layer(0.5), middle: layer(1.0), top: layer(1.5), faces: middle.faces.clone() }
}

/// The squared distance of a point from a mesh, in floats, from the definition: the least over a fine grid of weights
/// would be an upper bound only, so the closest point is found by cases (vertex, edge, face).
fn float_square(mesh: &TriMesh, p: &[f64; 3]) -> f64 {
    let minus = |a: &[f64; 3], b: &[f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut best = f64::INFINITY;
    for f in &mesh.faces {
        let c = f.map(|v| mesh.vertices[v as usize]);
        for k in 0..3 {
            let (along, from) = (minus(&c[(k + 1) % 3], &c[k]), minus(p, &c[k]));
            let t = (dot(&along, &from) / dot(&along, &along)).clamp(0.0, 1.0);
            let off = [0, 1, 2].map(|i| from[i] - t * along[i]);
            best = best.min(dot(&off, &off));
        }
        // Normal equations of the plane.
        let (u, v, w) = (minus(&c[1], &c[0]), minus(&c[2], &c[0]), minus(p, &c[0]));
        let (uu, uv, vv, uw, vw) = (dot(&u, &u), dot(&u, &v), dot(&v, &v), dot(&u, &w), dot(&v, &w));
        let det = uu * vv - uv * uv;
        let (s, t) = ((uw * vv - vw * uv) / det, (vw * uu - uw * uv) / det);
        if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
            let off = [0, 1, 2].map(|i| w[i] - s * u[i] - t * v[i]);
            best = best.min(dot(&off, &off));
        }
    }
    best
}

/// The largest sampled distance, with `n` steps along each side.
fn sampled(shell: &Shell, mesh: &TriMesh, n: u32) -> f64 {
    let mut most = 0.0f64;
    for f in &shell.faces {
        let c = f.map(|v| shell.middle[v as usize]);
        for i in 0..=n {
            for j in 0..=n - i {
                let w = [i, j, n - i - j].map(|x| f64::from(x) / f64::from(n));
                let p = [0, 1, 2].map(|x| w[0] * c[0][x] + w[1] * c[1][x] + w[2] * c[2][x]);
                most = most.max(float_square(mesh, &p));
            }
        }
    }
    most.sqrt()
}

fn narrow(low: f64, high: f64) -> bool {
    low <= high && high - low <= 1e-6 * low
}

#[test]
fn a_middle_surface_in_the_mesh_has_no_distance() {
    let mesh = icosphere(1);
    let found = distance(&radial(&mesh), &mesh, &Silent).unwrap();
    assert!(found.squared_at_least.is_zero());
    assert!(found.at_most <= 1e-14, "{found:?}");
}

#[test]
fn a_known_distance_inside_a_triangle() {
    // Two parallel triangles, and one that dips at its middle: the maximum, 3, is at an inner point of the middle triangle.
    let middle = TriMesh {
        vertices: vec![[0.0, 0.0, 0.0], [12.0, 0.0, 0.0], [0.0, 12.0, 0.0]],
        faces: vec![[0, 1, 2]],
    };
    let at = |z: f64| middle.vertices.iter().map(|p| [p[0], p[1], p[2] + z]).collect();
    let shell = Shell { bottom: at(-1.0), middle: at(0.0), top: at(1.0), faces: middle.faces.clone() };
    let flat = TriMesh { vertices: at(3.0), faces: middle.faces.clone() };
    let found = distance(&shell, &flat, &Silent).unwrap();
    assert_eq!(found.squared_at_least, Rat::from_i64(9));
    assert!(found.at_least <= 3.0 && found.at_most >= 3.0 && narrow(found.at_least, found.at_most));
    // A roof over it: its ridge over x = 3 in height 4, its sides far steeper than the way to them.
    let roof = TriMesh {
        vertices: vec![[3.0, -90.0, 4.0], [3.0, 90.0, 4.0], [90.0, -90.0, -2.0], [90.0, 90.0, -2.0]],
        faces: vec![[0, 2, 1], [1, 2, 3]],
    };
    let found = distance(&shell, &roof, &Silent).unwrap();
    // From (0, y, 0) the nearest point is the ridge: 5. All else is nearer.
    assert_eq!(found.squared_at_least, Rat::from_i64(25));
    assert!(narrow(found.at_least, found.at_most) && found.at_most >= 5.0, "{found:?}");
}

#[test]
fn the_enclosure_holds_for_coarse_spheres() {
    for scale in [1.0, 1e-100, 1e100] {
        let grown = |mesh: TriMesh| TriMesh {
            vertices: mesh.vertices.iter().map(|p| p.map(|x| x * scale)).collect(),
            faces: mesh.faces,
        };
        let (shell, mesh) = (radial(&grown(icosphere(1))), grown(icosphere(3)));
        let found = distance(&shell, &mesh, &Silent).unwrap();
        assert!(narrow(found.at_least / scale, found.at_most / scale), "{found:?}");
        let unit = (radial(&icosphere(1)), icosphere(3));
        let most = sampled(&unit.0, &unit.1, 24);
        assert!(most <= found.at_most / scale * (1.0 + 1e-9), "{most} {found:?}");
        assert!(found.at_least / scale <= most * 1.01);
    }
}

#[test]
fn the_squares_are_those_of_the_witness() {
    let made = sample(1);
    let found = distance(&made.shell, &made.mesh, &Silent).unwrap();
    let p = [0, 1, 2].map(|i| Rational::to_f64(&found.witness.point[i]));
    let square = Rational::to_f64(&found.squared_at_least);
    assert!((float_square(&made.mesh, &p) / square - 1.0).abs() < 1e-9);
    let sum = found.witness.weights.iter().fold(Rat::zero(), |s, w| s.plus(w));
    assert_eq!(sum, Rat::one());
    let exact = |x: f64| Rat::from_f64(x).unwrap().times(&Rat::from_f64(x).unwrap());
    assert!(exact(found.at_least) <= found.squared_at_least && found.squared_at_most <= exact(found.at_most));
}

#[test]
fn distributions() {
    let d = Distribution::of((1..=10).rev().map(f64::from).collect()).unwrap();
    let bits = |x: f64| x.to_bits();
    let nine = [1, 2, 3, 4, 5, 6, 7, 8, 9].map(|x| bits(f64::from(x)));
    assert_eq!((d.count, d.deciles.map(bits)), (10, nine));
    assert_eq!([d.min, d.max].map(bits), [1.0, 10.0].map(bits));
    assert!((d.mean - 5.5).abs() < 1e-12);
    let bits = Distribution::of(vec![2.0]).unwrap().deciles.map(f64::to_bits);
    assert_eq!(bits, [2.0f64.to_bits(); 9]);
    assert!(Distribution::of(Vec::new()).is_none());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn samples_lie_in_the_enclosure(moves in prop::collection::vec(0.7f64..1.3, 42 + 12)) {
        let moved = |mesh: TriMesh, moves: &[f64]| TriMesh {
            vertices: mesh.vertices.iter().zip(moves).map(|(p, f)| p.map(|x| x * f)).collect(),
            faces: mesh.faces,
        };
        let (mesh, middle) = (moved(icosphere(1), &moves), moved(icosphere(0), &moves[42..]));
        let found = distance(&radial(&middle), &mesh, &Silent).unwrap();
        prop_assert!(narrow(found.at_least, found.at_most), "{:?}", found);
        let most = sampled(&radial(&middle), &mesh, 30);
        prop_assert!(most <= found.at_most * (1.0 + 1e-9), "{} {:?}", most, found);
        // Steps are shorter than 1/12, and the distance changes by no more than the way.
        prop_assert!(found.at_least <= most + 0.1);
    }
}
