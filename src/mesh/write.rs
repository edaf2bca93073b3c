//! Writers. Decimal text is the shortest that reads back as the same `f64`, so reading what was
//! written gives every bit again; STL alone forgets vertices (see [`write()`]).

use super::TriMesh;
use super::error::{Fault, Located, MeshError};
use super::format::Format;
use std::io::Write as _;
use std::path::Path;

/// Writes a mesh to a file, which is replaced only when all is written: the data goes to a
/// temporary file in the same directory first, which is then renamed.
///
/// OFF, OBJ and PLY keep vertices, faces and bits. STL keeps the corners of each face, in order,
/// but no vertices: unreferenced ones are lost, equal ones become one when it is read, and the
/// numbering is by first use. Normals are written as zero, which readers take for "not given".
///
/// # Errors
/// [`MeshError::Write`] if a coordinate is not finite, an index is out of range, the mesh is empty,
/// a coordinate is not exact in `f32` (binary STL), or the file system refuses.
pub fn write(path: &Path, mesh: &TriMesh, format: Format) -> Result<(), MeshError> {
    let name = path.to_string_lossy();
    let bytes = encode(mesh, format, &name)?;
    if std::fs::metadata(path).is_ok_and(|m| !m.is_file()) {
        return Err(Located::from(Fault::NotAFile).writing(&name));
    }
    save(path, &bytes).map_err(|e| Located::from(Fault::Io(e.to_string())).writing(&name))
}

/// The bytes that [`write()`] writes; `name` is what errors call the file.
///
/// # Errors
/// As [`write()`], the file system apart.
pub fn encode(mesh: &TriMesh, format: Format, name: &str) -> Result<Vec<u8>, MeshError> {
    let encoded = writable(mesh).and_then(|()| match format {
        Format::Obj => Ok(obj(mesh)),
        Format::Off => Ok(off(mesh)),
        Format::PlyAscii => Ok(ply_ascii(mesh)),
        Format::PlyBinaryLe => Ok(ply_binary(mesh, false)),
        Format::PlyBinaryBe => Ok(ply_binary(mesh, true)),
        Format::StlAscii => stl_ascii(mesh),
        Format::StlBinary => stl_binary(mesh),
        other => Err(Fault::Unsupported(format!("writing {other}")).into()),
    });
    encoded.map_err(|located| located.writing(name))
}

fn save(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        // Temporary files are private by default; a mesh is an ordinary file, subject to the umask.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(directory)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path).map_err(|e| e.error)?;
    Ok(())
}

/// Refuses what no reader would take back.
fn writable(mesh: &TriMesh) -> Result<(), Located> {
    let vertices = u64::try_from(mesh.vertices.len()).unwrap_or(u64::MAX);
    if vertices == 0 {
        return Err(Fault::NoVertices.into());
    }
    if vertices > u64::from(u32::MAX) {
        return Err(Fault::TooMany { what: "vertices".to_owned(), count: vertices }.into());
    }
    for (i, point) in mesh.vertices.iter().enumerate() {
        if let Some(x) = point.iter().find(|x| !x.is_finite()) {
            return Err(Fault::NotFinite(x.to_string()).at("vertex", i));
        }
    }
    for (i, face) in mesh.faces.iter().enumerate() {
        if let Some(&index) = face.iter().find(|&&v| u64::from(v) >= vertices) {
            return Err(Fault::IndexOutOfRange { index: index.to_string(), vertices }.at("face", i));
        }
    }
    Ok(())
}

/// Adds formatted text; memory does not fail as a file does.
macro_rules! put {
    ($out:expr, $($arg:tt)*) => { $out.extend_from_slice(format!($($arg)*).as_bytes()) };
}

/// `{:?}` is the shortest text that reads back as the same number, with an exponent for extremes.
fn put_row(out: &mut Vec<u8>, before: &str, [x, y, z]: [f64; 3]) {
    put!(out, "{before}{x:?} {y:?} {z:?}\n");
}

fn obj(mesh: &TriMesh) -> Vec<u8> {
    let mut out = Vec::new();
    for &point in &mesh.vertices {
        put_row(&mut out, "v ", point);
    }
    for face in &mesh.faces {
        let [a, b, c] = face.map(|v| u64::from(v) + 1);
        put!(out, "f {a} {b} {c}\n");
    }
    out
}

/// The text in OFF of any mesh, also of one that [`encode`] refuses.
pub(crate) fn off(mesh: &TriMesh) -> Vec<u8> {
    let mut out = Vec::new();
    put!(out, "OFF\n{} {} 0\n", mesh.vertices.len(), mesh.faces.len());
    put_indexed(&mut out, mesh);
    out
}

/// Vertex and face lines as OFF and PLY have them.
fn put_indexed(out: &mut Vec<u8>, mesh: &TriMesh) {
    for &point in &mesh.vertices {
        put_row(out, "", point);
    }
    for [a, b, c] in &mesh.faces {
        put!(out, "3 {a} {b} {c}\n");
    }
}

fn ply_header(mesh: &TriMesh, format: &str) -> Vec<u8> {
    let mut out = Vec::new();
    put!(out, "ply\nformat {format} 1.0\nelement vertex {}\n", mesh.vertices.len());
    put!(out, "property double x\nproperty double y\nproperty double z\nelement face {}\n", mesh.faces.len());
    put!(out, "property list uchar uint vertex_indices\nend_header\n");
    out
}

fn ply_ascii(mesh: &TriMesh) -> Vec<u8> {
    let mut out = ply_header(mesh, "ascii");
    put_indexed(&mut out, mesh);
    out
}

fn ply_binary(mesh: &TriMesh, big_endian: bool) -> Vec<u8> {
    let mut out = ply_header(mesh, if big_endian { "binary_big_endian" } else { "binary_little_endian" });
    for x in mesh.vertices.as_flattened() {
        out.extend_from_slice(&if big_endian { x.to_be_bytes() } else { x.to_le_bytes() });
    }
    for face in &mesh.faces {
        out.push(3);
        for v in face {
            out.extend_from_slice(&if big_endian { v.to_be_bytes() } else { v.to_le_bytes() });
        }
    }
    out
}

/// The corners of each face. `writable` has checked the indices.
fn soup(mesh: &TriMesh) -> Result<impl Iterator<Item = [[f64; 3]; 3]>, Located> {
    if mesh.faces.is_empty() {
        return Err(Fault::NoFaces.into());
    }
    Ok(mesh.faces.iter().map(|face| face.map(|v| mesh.vertices[v as usize])))
}

fn stl_ascii(mesh: &TriMesh) -> Result<Vec<u8>, Located> {
    let mut out = Vec::new();
    put!(out, "solid\n");
    for corners in soup(mesh)? {
        put!(out, "facet normal 0 0 0\nouter loop\n");
        for point in corners {
            put_row(&mut out, "vertex ", point);
        }
        put!(out, "endloop\nendfacet\n");
    }
    put!(out, "endsolid\n");
    Ok(out)
}

fn stl_binary(mesh: &TriMesh) -> Result<Vec<u8>, Located> {
    for (i, point) in mesh.vertices.iter().enumerate() {
        if let Some(x) = point.iter().find(|&&x| f64::from(x as f32).to_bits() != x.to_bits()) {
            return Err(Fault::NotF32(format!("{x:?}")).at("vertex", i));
        }
    }
    let facets = u32::try_from(mesh.faces.len())
        .map_err(|_| Fault::TooMany { what: "faces".to_owned(), count: mesh.faces.len() as u64 })?;
    let mut out = vec![0; 80];
    out.extend_from_slice(&facets.to_le_bytes());
    for corners in soup(mesh)? {
        out.extend_from_slice(&[0; 12]);
        for x in corners.as_flattened() {
            out.extend_from_slice(&(*x as f32).to_le_bytes());
        }
        out.extend_from_slice(&[0; 2]);
    }
    Ok(out)
}
