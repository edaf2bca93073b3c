//! `P_T` and its inverse: exact round trips, and what must be refused.

use super::generate::{ratio, shell, spiral};
use crate::mesh::TriMesh;
use crate::projection::{MeshPoint, Projection, Rat, SectionError, SectionMap, ShellPoint};
use crate::shell::VertexOrder;
use crate::shell::hdf5;
use crate::testing::{Random, shell_directory};

fn mesh_point(random: &mut Random, mesh: &TriMesh) -> MeshPoint {
    MeshPoint { face: u32::try_from(random.below(mesh.faces.len())).unwrap(), weights: random.weights() }
}

#[test]
fn the_middle_surface_is_mapped_to_itself() {
    let mut random = Random(12);
    let (mut points, mut overlaps) = (0, 0);
    for _ in 0..60 {
        let (shell, order) = shell(&mut random);
        let projection = Projection::new(&shell, &order).unwrap();
        let mesh = TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() };
        let map = SectionMap::new(&projection, &mesh).unwrap();
        for _ in 0..40 {
            let point = mesh_point(&mut random, &mesh);
            let canonical = map.canonical(&point).unwrap();
            let own =
                ShellPoint { prism: canonical.face, weights: canonical.weights.clone(), height: Rat::ZERO };
            assert!(map.images(&point).unwrap().contains(&own));
            assert!(map.preimages(point.face, &point.weights).unwrap().contains(&canonical));
            match map.to_middle(&point) {
                Ok(middle) => assert_eq!(middle, own),
                Err(SectionError::SeveralImages { .. }) => overlaps += 1,
                Err(error) => panic!("{error}"),
            }
            points += 1;
        }
    }
    assert!(overlaps * 10 < points, "{overlaps} of {points}");
}

#[test]
fn real_sections_round_trip() {
    let Some(directory) = shell_directory() else { return };
    let names = [
        "cube.obj.h5",
        "cube.obj.h5.init",
        "sphere.obj.h5",
        "bumpy.off.h5",
        "bunny.off.h5",
        "tennis.off.h5",
        "tennis.off.h5.init",
        "fandisk.off.h5",
    ];
    let mut random = Random(13);
    for name in names {
        let file = hdf5::read(&directory.join(name)).unwrap();
        let mesh = file.mesh.unwrap();
        let projection = Projection::new(&file.shell, &VertexOrder::Id).unwrap();
        let map = SectionMap::new(&projection, &mesh).unwrap();
        for _ in 0..500 {
            let point = map.canonical(&mesh_point(&mut random, &mesh)).unwrap();
            let middle = map.to_middle(&point).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(map.to_mesh(middle.prism, &middle.weights).unwrap(), point, "{name}");
            // The other way round, from a random middle point.
            let prism = u32::try_from(random.below(file.shell.prism_count())).unwrap();
            let q = ShellPoint { prism, weights: random.weights(), height: Rat::ZERO };
            let on_mesh = map.to_mesh(q.prism, &q.weights).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(map.to_middle(&on_mesh).unwrap(), projection.canonical(&q).unwrap(), "{name}");
        }
        for &v in &file.shell.pinched_vertices() {
            let prism = file.shell.faces.iter().position(|f| f.contains(&v)).unwrap();
            let weights = file.shell.faces[prism].map(|u| if u == v { Rat::ONE } else { Rat::ZERO });
            let point = map.to_mesh(u32::try_from(prism).unwrap(), &weights).unwrap();
            let corner = point.weights.iter().position(|w| *w == Rat::ONE).unwrap();
            let at = mesh.vertices[mesh.faces[point.face as usize][corner] as usize];
            assert_eq!(at, file.shell.middle[v as usize]);
        }
    }
}

#[test]
fn a_mesh_that_is_no_section_is_told() {
    let shell = spiral(6);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let third = || [ratio(1, 3), ratio(1, 3), ratio(1, 3)];
    let at = |z: f64| shell.middle.iter().map(|p| [p[0], p[1], z]).collect::<Vec<_>>();
    let far = TriMesh { vertices: at(2.0), faces: shell.faces.clone() };
    let map = SectionMap::new(&projection, &far).unwrap();
    let outside = map.to_middle(&MeshPoint { face: 2, weights: third() }).unwrap_err();
    assert_eq!(outside, SectionError::Outside { face: 2 });
    assert_eq!(map.to_mesh(2, &third()).unwrap_err(), SectionError::NoPreimage { prism: 2 });
    // Two sheets, one above the other.
    let n = u32::try_from(shell.vertex_count()).unwrap();
    let second = shell.faces.iter().map(|f| f.map(|v| v + n));
    let double = TriMesh {
        vertices: [at(0.25), at(-0.5)].concat(),
        faces: shell.faces.iter().copied().chain(second).collect(),
    };
    let map = SectionMap::new(&projection, &double).unwrap();
    assert_eq!(map.to_mesh(3, &third()).unwrap_err(), SectionError::SeveralPreimages { prism: 3, count: 2 });
    assert_eq!(map.to_middle(&MeshPoint { face: 15, weights: third() }).unwrap().prism, 3);
    // A shell on itself: the lower sheet's point lies in two prisms.
    let long = spiral(12);
    let both = Projection::new(&long, &VertexOrder::Id).unwrap();
    let mesh = TriMesh { vertices: long.middle.clone(), faces: long.faces.clone() };
    let map = SectionMap::new(&both, &mesh).unwrap();
    let several = map.to_middle(&MeshPoint { face: 1, weights: third() }).unwrap_err();
    assert_eq!(several, SectionError::SeveralImages { face: 1, count: 2 });
}

#[test]
fn bad_meshes_and_points() {
    let shell = spiral(2);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let good = TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() };
    let mut nan = good.clone();
    nan.vertices[1][0] = f64::INFINITY;
    assert!(matches!(SectionMap::new(&projection, &nan), Err(SectionError::Mesh(_))));
    let mut far = good.clone();
    far.faces[0][0] = 6;
    assert!(matches!(SectionMap::new(&projection, &far), Err(SectionError::Mesh(_))));
    let map = SectionMap::new(&projection, &good).unwrap();
    for (face, parts) in [(4, [1, 0, 0]), (u32::MAX, [1, 0, 0]), (0, [1, 1, 0]), (0, [2, -1, 0])] {
        let point = MeshPoint { face, weights: parts.map(|w| ratio(w, 1)) };
        assert_eq!(map.to_middle(&point).unwrap_err(), SectionError::MeshPoint { face });
        assert_eq!(map.position(&point).unwrap_err(), SectionError::MeshPoint { face });
    }
    assert!(matches!(map.to_mesh(9, &[Rat::ONE, Rat::ZERO, Rat::ZERO]), Err(SectionError::Point(_))));
    let empty = TriMesh::default();
    let map = SectionMap::new(&projection, &empty).unwrap();
    assert!(matches!(
        map.to_mesh(0, &[Rat::ONE, Rat::ZERO, Rat::ZERO]),
        Err(SectionError::NoPreimage { prism: 0 })
    ));
}
