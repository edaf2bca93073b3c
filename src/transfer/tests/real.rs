use super::{exact, points};
use crate::mesh::{self, TriMesh};
use crate::number::Rat;
use crate::projection::{MeshPoint, Projection, SectionMap};
use crate::shell::{VertexOrder, hdf5};
use crate::testing::shell_directory;
use crate::transfer::{ExactPoint, Transfer};

#[test]
fn real_shells_there_and_back() {
    let Some(directory) = shell_directory() else { return };
    for (name, section) in [
        ("bumpy.off.h5", Some("bumpy.off.h5.section.ply")),
        ("bumpy.off.h5.init", None),
        ("tennis.off.h5", None),
        ("tennis.off.h5.init", None),
        ("cube.obj.h5", None),
        ("sphere.obj.h5", None),
    ] {
        let file = hdf5::read(&directory.join(name)).unwrap();
        let a = file.mesh.unwrap();
        let b = match section {
            Some(section) => mesh::read(&directory.join(section)).unwrap().mesh,
            None => TriMesh { vertices: file.shell.middle.clone(), faces: file.shell.faces.clone() },
        };
        let projection = Projection::new(&file.shell, &VertexOrder::Id).unwrap();
        let transfer = Transfer::new(&projection, &a, &b).unwrap();
        let (down, up) =
            (SectionMap::new(&projection, &a).unwrap(), SectionMap::new(&projection, &b).unwrap());
        let corners = (0..a.faces.len() as u32).map(|f| ExactPoint::corner(f, f as usize));
        for (i, p) in points(&a, 400, 23).into_iter().map(exact).chain(corners).enumerate() {
            let q = transfer.forward(&p).unwrap_or_else(|e| panic!("{name}: {e}: {p:?}"));
            let back = transfer.backward(&q).unwrap_or_else(|e| panic!("{name}: {e}: {q:?}"));
            assert!(back.is_same(&transfer.canonical(&p).unwrap()), "{name}: {p:?}");
            let near = transfer.forward_f64(p.face, p.rounded()).unwrap();
            if i < 10 {
                let middle = down.to_middle(&MeshPoint::from(&p)).unwrap();
                let slow = up.to_mesh(middle.prism, &middle.weights).unwrap();
                assert_eq!(MeshPoint::from(&q), slow, "{name}");
            }
            let again = transfer.forward(&exact((p.face, p.rounded()))).unwrap();
            assert_eq!(again.face, near.face, "{name}");
            for (w, near_w) in again.rationals().iter().zip(near.weights) {
                let off = (Rat::try_from(near_w).unwrap() - w).to_f64().value().abs();
                assert!(off <= near.error, "{name}: {off} {near:?}");
            }
        }
    }
}
