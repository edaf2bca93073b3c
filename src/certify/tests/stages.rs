//! Which stages decided: counts stated by hand, and the same for any number of threads.

use super::{lifting, sphere};
use crate::certify::disjoint::{self, About};
use crate::certify::{Claim, ClaimResult, Options, Silent, certify};
use crate::construct::icosphere;
use crate::mesh::TriMesh;
use crate::predicate::{StageCounts, orient3d_staged};
use crate::shell::Shell;
use crate::testing::Random;

/// The counts of a claim: filter, fixed width, big integers.
fn stages(result: &ClaimResult) -> [u64; 3] {
    ["decided_by_filter", "decided_by_fixed_width", "decided_by_big_integer"].map(|what| {
        let found: Vec<u64> = result.counts.iter().filter(|c| c.what == what).map(|c| c.count).collect();
        assert_eq!(found.len(), 1, "{what} of {}", result.claim);
        found[0]
    })
}

fn all_claims() -> Options {
    Options { claims: Claim::ALL.to_vec(), ..Options::default() }
}

/// One prism of height 1, slanted so that the boxes of its triangles meet; the mesh is its middle triangle.
fn one_prism() -> (Shell, TriMesh) {
    let middle = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 4.0]];
    let moved = |by: f64| middle.iter().map(|p: &[f64; 3]| [p[0], p[1], p[2] + by]).collect();
    let faces = vec![[0, 1, 2]];
    let shell = Shell { bottom: moved(-0.5), middle: middle.clone(), top: moved(0.5), faces: faces.clone() };
    (shell, TriMesh { vertices: middle, faces })
}

#[test]
fn counts_of_one_prism_are_those_made_by_hand() {
    let (shell, mesh) = one_prism();
    let outcome = certify(&shell, Some(&mesh), &all_claims(), &Silent).unwrap();
    assert!(outcome.all_certified());
    let of = |claim: Claim| stages(outcome.claims.iter().find(|c| c.claim == claim).unwrap());
    assert_eq!(of(Claim::Positivity), [24, 0, 0]);
    // Six tets are positive. The root lies in the middle triangle: its three points are found to be in the mesh triangle's plane,
    // and the triangle to face up in the two tets there. Each of these tets is clipped once for the start and the upper one again
    // for the lift; clipping takes the three corners against four faces, and all are in a face but each against the one
    // opposite to itself. At last the dot of the piece. All its sides are on the boundary.
    assert_eq!(of(Claim::Section), [6 + 2 + 3 * 3 + 1, 3 + 3 * 9, 0]);
    assert_eq!(of(Claim::Bijection), of(Claim::Section));
    // One piece, six dots. Its boundary is in the middle of the walls.
    assert_eq!(of(Claim::SectionAllOrders), [6, 0, 0]);
    // Bottom and top each are on one side of the triangle's plane.
    assert_eq!(of(Claim::Disjoint), [3 + 3, 0, 0]);
    assert_eq!(of(Claim::I2), [6, 0, 0]);
    // The six tets, and at least the three signs of each pair of the skin that the first plane closes.
    let prisms = of(Claim::DisjointPrisms);
    assert!(prisms[0] >= 6 && prisms.iter().sum::<u64>() > 6 + 14, "{prisms:?}");
}

/// The plane of any triangle of a convex surface has the surface on one side: every pair takes three signs, zeros, which the
/// filter leaves open, for common vertices alone.
#[test]
fn pairs_of_a_convex_surface_take_three_signs() {
    for n in 1..4 {
        let mesh = icosphere(n);
        let (vertices, shell) = (mesh.vertices.len() as u64, Shell::default());
        let shell = Shell { middle: mesh.vertices.clone(), faces: mesh.faces.clone(), ..shell };
        let found = lifting(
            &Shell { bottom: shell.middle.clone(), top: shell.middle.clone(), ..shell },
            &mesh,
            |cx| disjoint::decide(cx.mesh, cx.complex.shell, About::Mesh, &Silent).unwrap(),
        );
        // Twelve vertices have five triangles around them, all others six.
        let common = 12 * 10 + (vertices - 12) * 15;
        assert!(found.pairs > common / 2);
        assert_eq!(found.by_own_plane, found.pairs);
        assert_eq!(found.stages, StageCounts { filter: 3 * found.pairs - common, fixed: common, big: 0 });
    }
}

#[test]
fn tets_count_up_to_the_first_that_is_not_positive() {
    let mut random = Random(11);
    let pools = [1, 2, 5].map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap());
    for round in 0..6 {
        let (mut shell, mesh) = sphere(&mut random, 0, 0);
        // None, some late ones beyond the first share, some anywhere.
        let v = shell.faces[[0, 1270, random.below(1280)][round % 3]][0] as usize;
        if round % 3 != 0 {
            shell.top[v] = shell.middle[v].map(|x| 0.9 * x);
        }
        lifting(&shell, &mesh, |cx| {
            let (mut expected, mut first) = (StageCounts::default(), None);
            for (id, tet) in cx.complex.tets.iter().enumerate() {
                let [a, b, c, d] = tet.names.map(|n| shell.position(n));
                if !expected.note(orient3d_staged(a, b, c, d)).is_positive() {
                    first = Some(id as u32);
                    break;
                }
            }
            assert_eq!(first.is_some(), round % 3 != 0);
            for pool in &pools {
                let mut stages = StageCounts::default();
                assert_eq!(pool.install(|| cx.complex.first_not_positive(&mut stages)), first);
                assert_eq!(stages, expected);
            }
        });
    }
}

#[test]
fn counts_do_not_depend_on_the_number_of_threads() {
    let pools = [1, 2, 5].map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap());
    let mut random = Random(12);
    let mut refuted = 0;
    for round in 0..9 {
        let (shell, mesh) = sphere(&mut random, [0, 200, 0][round % 3], [0, 1, 3][round / 3]);
        let [one, two, five] = pools.each_ref().map(|pool| {
            let out = pool.install(|| certify(&shell, Some(&mesh), &all_claims(), &Silent)).unwrap();
            let counts: Vec<_> = out.claims.iter().map(|c| (c.claim, c.verdict, c.counts.clone())).collect();
            (counts, out.certificate)
        });
        assert!(one == two && one == five, "round {round}: {:?}, {:?}, {:?}", one.0, two.0, five.0);
        refuted += one.0.iter().filter(|(_, verdict, _)| verdict.word() == "refuted").count();
    }
    assert!(refuted > 5, "{refuted}");
}
