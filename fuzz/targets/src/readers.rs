//! Readers: no panic on any bytes, and what is accepted survives being written and read again.

use homeo::certify::pl::{self, PlError};
use homeo::mesh::{self, Format};
use homeo::shell::hdf5;

/// Every mesh reader.
///
/// # Panics
/// If what was written cannot be read, or has changed.
pub fn mesh(data: &[u8]) {
    let formats = [Format::Obj, Format::Off, Format::PlyAscii, Format::StlAscii];
    for format in formats {
        let Ok(file) = mesh::parse(data, format, "fuzz") else { continue };
        let Ok(bytes) = mesh::encode(&file.mesh, Format::Off, "fuzz") else { continue };
        let again = mesh::parse(&bytes, Format::Off, "fuzz").expect("what was written can be read");
        assert_eq!(again.mesh.faces, file.mesh.faces);
        let bits =
            |m: &mesh::TriMesh| -> Vec<u64> { m.vertices.iter().flatten().map(|x| x.to_bits()).collect() };
        assert_eq!(bits(&again.mesh), bits(&file.mesh), "coordinates keep every bit");
    }
    if let Some(format) = Format::from_content(data) {
        let _ = mesh::parse(data, format, "fuzz");
    }
}

/// Every reader of cells (VTK, MEDIT, Gmsh, GIFTI, OpenVolumeMesh). What is accepted is an input of claims: each is
/// decided or refused by name, and the checker accepts the answer about the file that is written for it.
///
/// # Panics
/// If the checker refuses an answer, or the certifier contradicts itself.
pub fn complex(data: &[u8]) {
    for format in Format::READ_ONLY {
        let Ok(file) = mesh::parse_complex(data, format, "fuzz") else { continue };
        if file.complex.cells.len() > 64 {
            continue;
        }
        let outcome = match pl::embedded(&file.complex, &homeo::certify::Silent) {
            Ok(outcome) => outcome,
            Err(PlError::Certify(contradiction)) => panic!("{contradiction}"),
            Err(_) => continue,
        };
        let answer =
            homeo_certs::check(outcome.certificate.as_bytes(), &[pl::complex_file(&file.complex).into()]);
        assert_eq!(answer.exit, 0, "{} {}\n{}", answer.code, answer.message, outcome.certificate);
    }
}

/// The shell reader.
///
/// # Panics
/// If what was written cannot be read, or has changed.
pub fn shell(data: &[u8]) {
    let Ok(file) = hdf5::parse("fuzz", data.to_vec()) else { return };
    let Ok(bytes) = hdf5::to_bytes(&file) else { return };
    let again = hdf5::parse("fuzz", bytes).expect("what was written can be read");
    assert_eq!(again.shell.faces, file.shell.faces);
    assert_eq!(again.mesh.is_some(), file.mesh.is_some());
}
