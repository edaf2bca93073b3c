//! Real shells, where they are at hand.

use super::generate::{in_tet, shell_point};
use super::properties::check_point;
use crate::projection::{Projection, ProjectionError, Rat};
use crate::shell::VertexOrder;
use crate::shell::hdf5;
use crate::testing::{Random, shell_directory};

const VALID: [&str; 12] = [
    "cube.obj.h5",
    "cube.obj.h5.init",
    "sphere.obj.h5",
    "sphere.obj.h5.init",
    "bumpy.off.h5",
    "c_spot.obj.h5",
    "bunny.off.h5",
    "fandisk.off.h5",
    "decimated-knight.off.h5",
    "tennis.off.h5",
    "tennis.off.h5.init",
    "bunny.off.h5.extract.h5",
];

#[test]
fn every_map_agrees_on_real_shells() {
    let Some(directory) = shell_directory() else { return };
    let mut points = 0;
    let mut random = Random(7);
    for name in VALID {
        let file = hdf5::read(&directory.join(name)).unwrap();
        let projection = Projection::new(&file.shell, &VertexOrder::Id).unwrap();
        let pinched = file.shell.pinched_vertices();
        for i in 0..1600 {
            let tet = match pinched.first() {
                // Half of the points near the pinched vertex.
                Some(&v) if i % 2 == 0 => {
                    let near = (0..projection.tets().len())
                        .filter(|&t| projection.tets()[t].names.iter().any(|n| n.vertex == v));
                    let near: Vec<usize> = near.collect();
                    near[random.below(near.len())]
                }
                _ => random.below(projection.tets().len()),
            };
            let p = in_tet(&projection, tet, &random.weights());
            check_point(&projection, &p);
            points += 1;
        }
        for _ in 0..100 {
            let q = shell_point(&mut random, &file.shell);
            let p = projection.unproject(&q).unwrap();
            assert!(projection.project_all(&p).contains(&projection.canonical(&q).unwrap()), "{name}: {q:?}");
        }
        let mesh = file.mesh.unwrap();
        for _ in 0..150 {
            let p = mesh.vertices[random.below(mesh.vertices.len())];
            check_point(&projection, &p.map(|x| Rat::try_from(x).unwrap()));
            points += 1;
        }
    }
    assert!(points >= 20_000);
}

#[test]
fn a_real_shell_with_bad_tets_is_refused() {
    let Some(directory) = shell_directory() else { return };
    let file = hdf5::read(&directory.join("decimated-knight.off.h5.extract.h5")).unwrap();
    let error = Projection::new(&file.shell, &VertexOrder::Id).unwrap_err();
    assert!(matches!(error, ProjectionError::NotPositive { .. }));
}
