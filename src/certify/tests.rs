//! Clipping by signs against clipping by exact coordinates; lifts looked ahead of by one core and by many; decisions
//! counted; certificates written in pieces.

mod sequential;
mod stages;
mod streamed;

use dashu_ratio::RBig;

use super::Silent;
use super::clip::clip;
use super::complex::{Boundary, MeshView, TetComplex};
use super::exact::{ExactPiece, has_area, normalised, whole};
use super::lift::Lifting;
use crate::construct::icosphere;
use crate::mesh::{Connectivity, TriMesh};
use crate::predicate::{StageCounts, orient3d};
use crate::shell::{Name, Shell};
use crate::testing::Random;

/// Points on a small grid, where degenerate positions are the rule.
struct Grid(u64);

impl Grid {
    fn point(&mut self, size: u64) -> [f64; 3] {
        [0; 3].map(|_| {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // At most 2^31, so that the conversion is exact.
            f64::from(u32::try_from((self.0 >> 33) % size).unwrap())
        })
    }
}

/// The corners of `f` cut with the tet, by exact Sutherland-Hodgman, as points with weights of sum one.
fn exact_corners(exact: &ExactPiece) -> Vec<[RBig; 3]> {
    let mut corners: Vec<[RBig; 3]> = exact.cut_with_tet(&whole()).iter().filter_map(normalised).collect();
    corners.sort();
    corners.dedup();
    corners
}

#[test]
fn clipping_by_signs_is_clipping() {
    let mut grid = Grid(7);
    let (mut areas, mut coplanar) = (0, 0);
    for round in 0..40_000 {
        let size = [2, 3, 4, 1000][round % 4];
        let p: [[f64; 3]; 7] = std::array::from_fn(|_| grid.point(size));
        let f = [&p[0], &p[1], &p[2]];
        let mut tet = [&p[3], &p[4], &p[5], &p[6]];
        let flat_triangle = crate::predicate::zero_area(f[0], f[1], f[2]);
        match orient3d(tet[0], tet[1], tet[2], tet[3]).as_i8() {
            0 => continue,
            -1 => tet.swap(0, 1),
            _ => {}
        }
        if flat_triangle {
            continue;
        }
        let exact = ExactPiece::new(f, tet);
        let polygon = clip(f, tet, &mut StageCounts::default());
        assert_eq!(polygon.is_some(), has_area(&exact.cut_with_tet(&whole())), "{p:?}");
        let Some(polygon) = polygon else { continue };
        areas += 1;
        coplanar += usize::from(polygon.coplanar.is_some());
        let mut corners = Vec::new();
        for corner in polygon.corners() {
            let weights = exact.weights(corner.mask).unwrap();
            // The mask says exactly which coordinates vanish.
            let in_tet = exact.in_tet(&weights).unwrap();
            for (bit, x) in weights.iter().chain(&in_tet).enumerate() {
                assert_eq!(corner.mask & (1 << bit) != 0, *x == RBig::ZERO, "{p:?}");
            }
            corners.push(weights);
        }
        corners.sort();
        assert_eq!(corners, exact_corners(&exact), "{p:?}");
    }
    assert!(areas > 1_000 && coplanar > 50, "{areas} {coplanar}");
}

/// A shell of 1280 prisms around a sphere, with pinched vertices and, if it is open, without its first prisms; the mesh is
/// its middle surface, some vertices moved.
fn sphere(random: &mut Random, open: usize, moved: usize) -> (Shell, TriMesh) {
    let mut mesh = icosphere(3);
    mesh.faces.drain(..open);
    let scaled = |f: f64| mesh.vertices.iter().map(|p| p.map(|x| x * f)).collect::<Vec<_>>();
    let (bottom, middle, top) = (scaled(0.75), scaled(1.0), scaled(1.25));
    let mut shell = Shell { bottom, middle, top, faces: mesh.faces.clone() };
    for _ in 0..8 {
        let v = random.below(shell.middle.len());
        (shell.bottom[v], shell.top[v]) = (shell.middle[v], shell.middle[v]);
    }
    for _ in 0..moved {
        let v = random.below(mesh.vertices.len());
        let factor = [0.75, 0.9, 1.1, 1.25, 1.3][random.below(5)];
        mesh.vertices[v] = mesh.vertices[v].map(|x| x * factor);
    }
    (shell, mesh)
}

/// Calls a function with mesh and complex.
fn lifting<R>(shell: &Shell, mesh: &TriMesh, work: impl FnOnce(Lifting<'_>) -> R) -> R {
    let of = |vertices: usize, faces| Connectivity::new(vertices, faces).unwrap();
    let (middle, connectivity) = (of(shell.middle.len(), &shell.faces), of(mesh.vertices.len(), &mesh.faces));
    let (wall, edge) = (Boundary::new(&middle), Boundary::new(&connectivity));
    let ranks: Vec<u32> = (0..shell.middle.len() as u32).collect();
    let view = MeshView {
        vertices: &mesh.vertices,
        faces: &mesh.faces,
        connectivity: &connectivity,
        boundary: &edge,
    };
    work(Lifting { mesh: &view, complex: &TetComplex::new(shell, &middle, &wall, &ranks) })
}

#[test]
fn tets_around_a_simplex_of_a_tet_are_its_star() {
    let mut random = Random(5);
    for open in [0, 100] {
        let (shell, mesh) = sphere(&mut random, open, 0);
        lifting(&shell, &mesh, |cx| {
            for (id, tet) in cx.complex.tets.iter().enumerate() {
                for subset in 1..16u8 {
                    let names: Vec<Name> =
                        (0..4).filter(|k| subset & (1 << k) != 0).map(|k| tet.names[k]).collect();
                    let star: Vec<u32> = cx.complex.star(&names).collect();
                    assert!(cx.complex.around(id as u32, &names).eq(star), "{id} {names:?}");
                }
            }
        });
    }
}

#[test]
fn a_lift_is_the_same_whoever_looks_ahead() {
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    let (one, four) = (pool(1), pool(4));
    let mut random = Random(6);
    let (mut complete, mut violations) = (0, 0);
    for round in 0..60 {
        let (shell, mesh) = sphere(&mut random, [0, 200][round % 2], round / 20);
        lifting(&shell, &mesh, |cx| {
            let face = random.below(mesh.faces.len()) as u32;
            let prism = cx.complex.tets.iter().position(|t| t.prism == face);
            let Some(start) = (0..6)
                .map(|k| (prism.unwrap() + k) as u32)
                .find(|&t| cx.piece(face, t, &mut StageCounts::default()).is_some())
            else {
                return;
            };
            let flood = || {
                let (lift, stop) = cx.flood(face, start, &Silent);
                let pieces: Vec<_> =
                    lift.pieces.iter().map(|p| (p.face, p.tet, p.parent, p.parent_side)).collect();
                (pieces, lift.corners, format!("{stop:?}"))
            };
            let (alone, together) = (one.install(flood), four.install(flood));
            assert!(alone == together, "round {round}: {} and {}", alone.2, together.2);
            complete += usize::from(alone.2 == "None");
            violations += usize::from(alone.2.contains("Violation") && alone.0.len() > 500);
        });
    }
    assert!(complete >= 10 && violations >= 10, "{complete} {violations}");
}
