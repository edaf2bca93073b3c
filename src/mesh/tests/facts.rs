//! Facts about real meshes, found with independent exact programs (INDEX.md of the test data).

use super::*;
use DefectKind::*;

/// file, V, F, genus, boundary loops, components
type Row = (&'static str, usize, usize, u64, usize, usize);

const CLEAN: &[Row] = &[
    ("decimated-knight.off", 502, 1000, 0, 0, 1),
    ("fox.ply", 313, 622, 0, 0, 1),
    ("eight.off", 315, 634, 2, 0, 1),
    ("anchor.off", 519, 1050, 4, 0, 1),
    ("gargo_1000.off", 502, 1000, 0, 0, 1),
    ("65004.stl", 731, 1466, 2, 0, 1),
    ("bunny.off", 3485, 6966, 0, 0, 1),
    ("cheburashka.off", 6669, 13334, 0, 0, 1),
    ("fandisk.obj", 6475, 12946, 0, 0, 1),
    ("dino.off", 3916, 7828, 0, 0, 1),
    ("armadillo.off", 26002, 52000, 0, 0, 1),
    ("turbine.off", 9210, 18460, 11, 0, 1),
    ("boot.obj", 19931, 39906, 12, 0, 1),
    ("fertility.off", 4494, 9000, 4, 0, 1),
    ("hull-mask.obj", 3996, 7980, 0, 0, 3),
    ("88566.stl", 2624, 5344, 32, 0, 8),
    ("mask3kf.obj", 1590, 3000, 0, 1, 1),
    ("lion.off", 7529, 14859, 0, 5, 1),
    ("libigl_bunny.off", 34834, 69451, 0, 5, 1),
    ("skull.obj", 49999, 100002, 2, 0, 1),
    ("turbineblade.ply", 99519, 199034, 0, 0, 1),
    ("camel.off", 9770, 19536, 0, 0, 1),
    ("cube.obj", 8, 12, 0, 0, 1),
    ("sphere.obj", 382, 760, 0, 0, 1),
    ("bumpy.off", 1250, 2496, 0, 0, 1),
    ("fandisk.off", 7229, 14454, 0, 0, 1),
    ("spot.obj", 2930, 5856, 0, 0, 1),
    ("tennis.off", 49, 94, 0, 0, 1),
];

fn load(name: &str) -> Option<MeshFile> {
    Some(read(&data(name)?).expect(name))
}

#[test]
fn clean_meshes() {
    for &(name, vertices, faces, genus, loops, components) in CLEAN {
        let Some(file) = load(&format!("surface/{name}")) else { return };
        let valid = check(&file.mesh).expect(name);
        let info = valid.info();
        assert_eq!((info.vertices, info.faces), (vertices, faces), "{name}");
        assert_eq!(info.genus, Some(genus), "{name}");
        assert_eq!((info.boundary_loops, info.components), (loops, components), "{name}");
        assert!(valid.connectivity().is_orientable(), "{name}");
    }
}

#[test]
fn cow_has_a_non_manifold_vertex() {
    let Some(file) = load("surface/cow.obj") else { return };
    let report = validate(&file.mesh).unwrap();
    assert_eq!((report.info.vertices, report.info.faces), (2903, 5804));
    assert_eq!((report.info.components, report.info.boundary_loops, report.info.genus), (1, 0, None));
    assert_eq!(report.count(NonManifoldVertex), 1);
    assert_eq!(report.count(NonManifoldEdge), 0);
    assert_eq!(report.count(ZeroArea), 0);
    assert!(matches!(check(&file.mesh), Err(MeshError::Invalid(Defect::NonManifoldVertex { parts: 2, .. }))));
}

#[test]
fn capsule_has_flat_triangles() {
    let Some(file) = load("surface/capsule.obj") else { return };
    let report = validate(&file.mesh).unwrap();
    assert_eq!((report.info.vertices, report.info.faces), (5252, 10200));
    assert_eq!((report.info.components, report.info.boundary_loops), (1, 1));
    assert_eq!(report.info.genus, Some(0));
    assert_eq!(report.count(ZeroArea), 200);
    assert_eq!(report.count(CoincidentVertices), 250);
    assert_eq!(report.listed.iter().filter(|d| d.kind() == ZeroArea).count(), 16);
    assert!(matches!(check(&file.mesh), Err(MeshError::Invalid(Defect::ZeroArea { .. }))));
}

#[test]
fn blobby_is_oriented_at_random() {
    let Some(file) = load("surface/blobby-shuffled.off") else { return };
    let report = validate(&file.mesh).unwrap();
    assert_eq!((report.info.vertices, report.info.faces, report.info.genus), (2027, 4050, Some(0)));
    assert_eq!(report.count(InconsistentOrientation), 3069);
    assert_eq!(report.count(NonManifoldVertex) + report.count(NonManifoldEdge) + report.count(ZeroArea), 0);
    assert!(matches!(check(&file.mesh), Err(MeshError::Invalid(Defect::InconsistentOrientation { .. }))));
}

#[test]
fn stl_corners_are_welded() {
    let Some(file) = load("surface/65004.stl") else { return };
    assert_eq!(file.format, Format::StlBinary);
    assert_eq!(file.notes, ["STL: welded 4398 corners to 731 vertices"]);
}

/// Vertices whose link is not one path or cycle: the table counts the ends of non-manifold edges too.
fn singular_vertices(mesh: &TriMesh) -> u64 {
    let connectivity = Connectivity::new(mesh.vertices.len(), &mesh.faces).unwrap();
    let mut singular = std::collections::BTreeSet::new();
    for edge in connectivity.edges().filter(|e| e.sides.len() > 2) {
        singular.extend(edge.vertices);
    }
    let all = 0..u32::try_from(mesh.vertices.len()).unwrap();
    singular.extend(all.filter(|&v| connectivity.link_parts(v) > 1));
    u64::try_from(singular.len()).unwrap()
}

#[test]
fn outputs_of_remeshers() {
    let rows: [(&str, usize, u64, u64); 4] = [
        ("pairs/armadillo_acvd3000.obj", 5993, 3, 6),
        ("pairs/turbine_mosloppy10.obj", 1794, 205, 200),
        ("pairs/fandisk_qem2k.obj", 2000, 0, 0),
        ("pairs/cheburashka_cgaliso.off", 19778, 0, 0),
    ];
    for (name, faces, edges, vertices) in rows {
        let Some(file) = load(name) else { return };
        let report = validate(&file.mesh).unwrap();
        assert_eq!(report.info.faces, faces, "{name}");
        assert_eq!(report.count(NonManifoldEdge), edges, "{name}");
        assert_eq!(singular_vertices(&file.mesh), vertices, "{name}");
    }
}
