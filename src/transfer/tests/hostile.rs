use super::generated;
use crate::mesh::TriMesh;
use crate::projection::{Projection, SectionError};
use crate::shell::VertexOrder;
use crate::transfer::{ExactPoint, Transfer};
use dashu_int::IBig;

#[test]
fn points_that_are_none_are_refused() {
    let (shell, a, b) = generated();
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    let none = |face| Err(SectionError::MeshPoint { face });
    let beyond = a.faces.len() as u32;
    assert_eq!(transfer.forward_f64(beyond, [1.0, 0.0, 0.0]), none(beyond));
    assert_eq!(transfer.forward_f64(u32::MAX, [1.0, 0.0, 0.0]), none(u32::MAX));
    for bad in [
        [0.0; 3],
        [-1.0, 1.0, 1.0],
        [f64::NAN, 1.0, 1.0],
        [f64::INFINITY, 1.0, 1.0],
        [f64::MAX, f64::MAX, 1.0],
    ] {
        assert_eq!(transfer.forward_f64(0, bad), none(0), "{bad:?}");
    }
    assert!(ExactPoint::from_f64(0, [f64::NAN, 1.0, 1.0]).is_err());
    assert!(ExactPoint::new(0, [IBig::from(-1), IBig::from(2), IBig::ZERO]).is_err());
    assert!(ExactPoint::new(0, [IBig::ZERO, IBig::ZERO, IBig::ZERO]).is_err());
    assert!(matches!(transfer.forward(&ExactPoint::corner(beyond, 0)), Err(SectionError::MeshPoint { .. })));
    // Extreme ratios are points like others.
    for far in [[1e-300, 1e300, 1.0], [5e-324, 1.0, 0.0], [5e-324, 5e-324, 5e-324]] {
        let q = transfer.forward(&ExactPoint::from_f64(0, far).unwrap()).unwrap();
        assert_eq!(transfer.forward_f64(0, far).unwrap().face, q.face, "{far:?}");
        let p = transfer.canonical(&ExactPoint::from_f64(0, far).unwrap()).unwrap();
        assert!(transfer.backward(&q).unwrap().is_same(&p), "{far:?}");
    }
}

#[test]
fn meshes_that_are_no_sections_have_no_images() {
    let (shell, a, b) = generated();
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let scaled = |factor: f64| TriMesh {
        vertices: a.vertices.iter().map(|p| p.map(|x| x * factor)).collect(),
        faces: a.faces.clone(),
    };
    // Outside of the shell, whichever side of the map it is on.
    let outside = scaled(2.0);
    let transfer = Transfer::new(&projection, &outside, &b).unwrap();
    assert_eq!(transfer.forward_f64(0, [1.0; 3]), Err(SectionError::Outside { face: 0 }));
    let transfer = Transfer::new(&projection, &a, &outside).unwrap();
    assert!(matches!(transfer.forward_f64(0, [1.0; 3]), Err(SectionError::NoPreimage { .. })));
    // Two sheets, one above the other: every fibre meets both.
    let count = a.vertices.len() as u32;
    let above = scaled(1.03);
    let two = TriMesh {
        vertices: [a.vertices.clone(), above.vertices].concat(),
        faces: a.faces.iter().copied().chain(a.faces.iter().map(|f| f.map(|v| v + count))).collect(),
    };
    let transfer = Transfer::new(&projection, &b, &two).unwrap();
    let several = transfer.forward(&ExactPoint::from_f64(0, [1.0; 3]).unwrap());
    assert!(matches!(several, Err(SectionError::SeveralPreimages { .. })), "{several:?}");
    // Broken meshes.
    let mut broken = a.clone();
    broken.vertices[3][1] = f64::NAN;
    assert!(matches!(Transfer::new(&projection, &broken, &b), Err(SectionError::Mesh(_))));
    broken = a.clone();
    broken.faces[5][1] = count;
    assert!(matches!(Transfer::new(&projection, &a, &broken), Err(SectionError::Mesh(_))));
    // Flat and empty ones.
    broken = a.clone();
    broken.faces[0] = [0, 0, 0];
    assert!(Transfer::new(&projection, &broken, &b).is_ok());
    let empty = TriMesh::default();
    let transfer = Transfer::new(&projection, &a, &empty).unwrap();
    assert!(transfer.forward_f64(0, [1.0; 3]).is_err());
}
