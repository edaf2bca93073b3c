//! Fuzz targets as plain functions: each takes any bytes and panics exactly when something is wrong.
//!
//! `cargo fuzz run mesh --features libfuzzer` explores; `cargo test` runs the regressions and a bounded number of random
//! mutations on a stable toolchain.

use homeo::mesh::{self, Format};
use homeo::shell::hdf5;

/// Every mesh reader: no panic, and what is accepted survives being written and read again.
pub fn mesh(data: &[u8]) {
    let formats = [Format::Obj, Format::Off, Format::PlyAscii, Format::StlAscii];
    for format in formats {
        let Ok(file) = mesh::parse(data, format, "fuzz") else { continue };
        let Ok(bytes) = mesh::encode(&file.mesh, Format::Off, "fuzz") else { continue };
        let again = mesh::parse(&bytes, Format::Off, "fuzz").expect("what was written can be read");
        assert_eq!(again.mesh.faces, file.mesh.faces);
        let bits = |m: &mesh::TriMesh| -> Vec<u64> { m.vertices.iter().flatten().map(|x| x.to_bits()).collect() };
        assert_eq!(bits(&again.mesh), bits(&file.mesh), "coordinates keep every bit");
    }
    if let Some(format) = Format::from_content(data) {
        let _ = mesh::parse(data, format, "fuzz");
    }
}

/// The shell reader: no panic, and what is accepted survives being written and read again.
pub fn shell(data: &[u8]) {
    let Ok(file) = hdf5::parse("fuzz", data.to_vec()) else { return };
    let Ok(bytes) = hdf5::to_bytes(&file) else { return };
    let again = hdf5::parse("fuzz", bytes).expect("what was written can be read");
    assert_eq!(again.shell.faces, file.shell.faces);
    assert_eq!(again.mesh.is_some(), file.mesh.is_some());
}

/// Inputs that the certificates of the seed are about.
const INPUTS: [&[u8]; 4] = [
    include_bytes!("../../certs/corpus/patch/bottom.off"),
    include_bytes!("../../certs/corpus/patch/middle.off"),
    include_bytes!("../../certs/corpus/patch/top.off"),
    include_bytes!("../../certs/corpus/patch/mesh.off"),
];

/// The checker: no panic on any bytes, and nothing that is false about these inputs is accepted. All claims hold for
/// them, so an accepted certificate refutes nothing.
pub fn certificate(data: &[u8]) {
    let inputs: Vec<Vec<u8>> = INPUTS.iter().map(|i| i.to_vec()).collect();
    let outcome = homeo_certs::check(data, &inputs);
    if outcome.exit == 0 {
        assert!(outcome.claims.iter().all(|(_, certified)| *certified), "a true claim was refuted: {:?}", outcome.claims);
    }
}
