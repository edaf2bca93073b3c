//! What is known of prisms that stay against judging all of them anew.

use super::{Against, Known, Patience, Wrong, overlap, reduce, wrong};
use crate::certify::Silent;
use crate::certify::complex::{Boundary, MeshView};
use crate::construct::bevel::{Input, bevel};
use crate::construct::boundary::Pillars;
use crate::construct::direction::{Direction, directions};
use crate::construct::icosphere;
use crate::mesh::{Connectivity, TriMesh};
use crate::testing::{Random, joined, torus};

/// Shrinks pillars that are all too long to begin with. How often each condition was the one that failed.
fn shrink(mesh: &TriMesh, most: f64, all: bool, pinch: usize, no_overlap: bool) -> [usize; 4] {
    let connectivity = Connectivity::new(mesh.vertices.len(), &mesh.faces).unwrap();
    let boundary = Boundary::new(&connectivity);
    let view = MeshView {
        vertices: &mesh.vertices,
        faces: &mesh.faces,
        connectivity: &connectivity,
        boundary: &boundary,
    };
    let found = directions(mesh, &connectivity);
    let proved = |d: &Direction| if let Direction::Proved(d) = d { Some(*d) } else { None };
    let mut direction: Vec<[f64; 3]> = found.iter().map(|d| proved(d).unwrap_or_default()).collect();
    let mut pinched: Vec<bool> = found.iter().map(|d| proved(d).is_none()).collect();
    pinched.iter_mut().step_by(97).take(pinch).for_each(|p| *p = true);
    let pillars =
        Pillars { mesh, connectivity: &connectivity, direction: &mut direction, pinched: &mut pinched };
    { pillars }.settle();
    let input = Input { mesh, connectivity: &connectivity, direction: &direction, pinched: &pinched };
    let mut draft = bevel(&input, &input.to_bevel());
    draft.up.fill(most);
    draft.down.fill(most);
    let against = Against { mesh, connectivity: &connectivity, all };
    let (mut patience, mut known) = (Patience::new(&draft), Known::nothing(draft.faces.len()));
    let sorted = |(mut slabs, reason): Wrong| {
        slabs.sort_unstable();
        slabs.dedup();
        (slabs, reason)
    };
    let mut failures = [0; 4];
    loop {
        let mut nothing = Known::nothing(draft.faces.len());
        let anew = sorted(wrong(&draft, &against, &view, &mut nothing, &Silent).unwrap());
        let mut found = sorted(wrong(&draft, &against, &view, &mut known, &Silent).unwrap());
        assert_eq!(found, anew, "after {failures:?} rounds");
        if no_overlap && found.0.is_empty() {
            let slabs = overlap::slabs(&draft.shell(), &Silent).unwrap();
            found = sorted((slabs, "overlap"));
        }
        if found.0.is_empty() {
            return failures;
        }
        let kinds = ["the prism is not", "the mesh meets", "a triangle touches", "overlap"];
        failures[kinds.iter().position(|k| found.1.starts_with(k)).unwrap()] += 1;
        let stuck = reduce(&mut draft, mesh, (&found.0, found.1), &mut patience, &mut known);
        assert!(stuck.is_empty(), "{stuck:?} after {failures:?} rounds");
    }
}

#[test]
fn what_is_known_stays_true() {
    let moved = |mesh: &TriMesh, by: f64| {
        let mut out = mesh.clone();
        out.vertices.iter_mut().for_each(|p| p[0] += by);
        out
    };
    let ball = icosphere(2);
    let mut open = icosphere(3);
    open.faces.drain(..300);
    let mut rough = icosphere(3);
    let mut random = Random(41);
    rough.vertices.iter_mut().for_each(|p| *p = p.map(|x| x * (1.0 + 0.04 * random.real())));
    let close = joined(&ball, &moved(&ball, 2.05));
    let crossing = joined(&ball, &moved(&ball, 1.2));
    // A small ball that is wholly within prisms of the large one.
    let mut small = icosphere(0);
    small.vertices.iter_mut().for_each(|p| *p = p.map(|x| 0.02 * x));
    let near = joined(&icosphere(1), &moved(&small, 1.3));
    let mut failures = [0; 4];
    for (mesh, all, pinch, no_overlap) in [
        (&ball, true, 1, false),
        (&torus(16), true, 2, false),
        (&rough, true, 4, false),
        (&open, true, 0, false),
        (&close, true, 0, false),
        (&close, true, 1, true),
        (&crossing, false, 1, false),
        (&near, true, 0, false),
    ] {
        let rounds = shrink(mesh, 1.5, all, pinch, no_overlap);
        failures.iter_mut().zip(rounds).for_each(|(all, n)| *all += n);
    }
    assert!(failures.iter().all(|&n| n > 2), "{failures:?}");
}
