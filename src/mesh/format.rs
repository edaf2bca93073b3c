//! Which format a file has, and reading it.

use super::complex::{Complex, ComplexFile};
use super::error::{Fault, Located, MeshError};
use super::parts::Parts;
use super::text::{Lines, tokens};
use super::{TriMesh, gifti, gmsh, medit, obj, off, ovm, ply, stl, vtk};
use flate2::read::MultiGzDecoder;
use serde::Serialize;
use std::ffi::OsStr;
use std::fmt;
use std::io::Read as _;
use std::path::Path;

/// A mesh file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Object File Format, with the variants that add columns (COFF, NOFF, STOFF ...).
    Off,
    /// PLY as text.
    PlyAscii,
    /// PLY, binary, little endian.
    PlyBinaryLe,
    /// PLY, binary, big endian.
    PlyBinaryBe,
    /// STL as text.
    StlAscii,
    /// STL, binary: coordinates are `f32`.
    StlBinary,
    /// VTK legacy, text or binary: surfaces and tet meshes.
    Vtk,
    /// MEDIT `.mesh`, text: surfaces and tet meshes.
    Medit,
    /// Gmsh 2.x or 4.1, text or binary: surfaces and tet meshes.
    Gmsh,
    /// GIFTI surfaces.
    Gifti,
    /// OpenVolumeMesh, text: tet meshes.
    Ovm,
}

impl Format {
    /// The formats that are read and written.
    pub const ALL: [Self; 7] = [
        Self::Obj,
        Self::Off,
        Self::PlyAscii,
        Self::PlyBinaryLe,
        Self::PlyBinaryBe,
        Self::StlAscii,
        Self::StlBinary,
    ];

    /// The formats that are only read.
    pub const READ_ONLY: [Self; 5] = [Self::Vtk, Self::Medit, Self::Gmsh, Self::Gifti, Self::Ovm];

    /// The format to write to a file of this name; binary where both exist.
    #[must_use]
    pub fn from_extension(path: &Path) -> Option<Self> {
        let extension = path.extension().and_then(OsStr::to_str)?.to_ascii_lowercase();
        match extension.as_str() {
            "obj" => Some(Self::Obj),
            "off" | "coff" | "noff" | "cnoff" => Some(Self::Off),
            "ply" => Some(Self::PlyBinaryLe),
            "stl" => Some(Self::StlBinary),
            "vtk" => Some(Self::Vtk),
            "mesh" => Some(Self::Medit),
            "msh" => Some(Self::Gmsh),
            "gii" => Some(Self::Gifti),
            "ovm" => Some(Self::Ovm),
            "gz" => Self::from_extension(Path::new(path.file_stem()?)),
            _ => None,
        }
    }

    /// The format that the content shows, if it does; OBJ has no mark.
    #[must_use]
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        if vtk::is_magic(bytes) {
            return Some(Self::Vtk);
        }
        if stl::is_binary(bytes) {
            return Some(Self::StlBinary);
        }
        if gifti::is_magic(strip_bom(bytes)) {
            return Some(Self::Gifti);
        }
        if let Some(format) = ply::detect(bytes) {
            return Some(format);
        }
        let (_, line) = Lines::new(strip_bom(bytes)).next_content()?;
        let first = tokens(line).next()?;
        if let Some(format) = from_first_word(first) {
            return Some(format);
        }
        first.eq_ignore_ascii_case(b"solid").then_some(Self::StlAscii)
    }
}

/// The format whose files begin with this word.
fn from_first_word(word: &[u8]) -> Option<Format> {
    if off::is_magic(word) {
        Some(Format::Off)
    } else if medit::is_magic(word) {
        Some(Format::Medit)
    } else if gmsh::is_magic(word) {
        Some(Format::Gmsh)
    } else {
        ovm::is_magic(word).then_some(Format::Ovm)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Obj => "OBJ",
            Self::Off => "OFF",
            Self::PlyAscii => "PLY (ASCII)",
            Self::PlyBinaryLe => "PLY (binary, little endian)",
            Self::PlyBinaryBe => "PLY (binary, big endian)",
            Self::StlAscii => "STL (ASCII)",
            Self::StlBinary => "STL (binary)",
            Self::Vtk => "VTK",
            Self::Medit => "MEDIT",
            Self::Gmsh => "Gmsh",
            Self::Gifti => "GIFTI",
            Self::Ovm => "OpenVolumeMesh",
        })
    }
}

/// A mesh as it came from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// The mesh: vertices and faces in the file's order.
    pub mesh: TriMesh,
    /// The format found in the file.
    pub format: Format,
    /// What was changed or left out, one sentence each; empty for a plain triangle mesh.
    pub notes: Vec<String>,
}

/// Reads a surface; the format is taken from the content (headers and first words, the exact size of a
/// binary STL, `solid`), else from the file name's extension (OBJ). Files compressed with gzip are unpacked.
///
/// # Errors
/// [`MeshError::Read`] with file, place and reason.
pub fn read(path: &Path) -> Result<MeshFile, MeshError> {
    let name = path.to_string_lossy();
    let (bytes, format) = open(path).map_err(|located| located.reading(&name))?;
    parse(&bytes, format, &name)
}

/// Reads a surface or a tet mesh, as [`read`] does. Where a file has tets, the triangles are left out.
///
/// # Errors
/// [`MeshError::Read`] with file, place and reason.
pub fn read_complex(path: &Path) -> Result<ComplexFile, MeshError> {
    let name = path.to_string_lossy();
    let (bytes, format) = open(path).map_err(|located| located.reading(&name))?;
    parse_complex(&bytes, format, &name)
}

/// The content of a file, and its format.
fn open(path: &Path) -> Result<(Vec<u8>, Format), Located> {
    let bytes = load(path)?;
    match Format::from_content(&bytes).or_else(|| Format::from_extension(path)) {
        Some(format) => Ok((bytes, format)),
        None if strip_bom(&bytes).trim_ascii().is_empty() => Err(Fault::Empty.into()),
        None => Err(Fault::UnknownFormat.into()),
    }
}

/// Reads a mesh in a given format; see [`parse`].
///
/// # Errors
/// [`MeshError::Read`] with file, place and reason.
pub fn read_as(path: &Path, format: Format) -> Result<MeshFile, MeshError> {
    let name = path.to_string_lossy();
    let bytes = load(path).map_err(|fault| Located::from(fault).reading(&name))?;
    parse(&bytes, format, &name)
}

/// Reads a mesh from bytes. The variants of PLY and of STL are told apart by the content, so any
/// of them may be asked for; [`MeshFile::format`] says which it was. `name` is what errors call the
/// file. Memory is proportional to `bytes`, whatever counts they announce.
///
/// # Errors
/// [`MeshError::Read`] with file, place and reason.
pub fn parse(bytes: &[u8], format: Format, name: &str) -> Result<MeshFile, MeshError> {
    parse_located(bytes, format).map_err(|located| located.reading(name))
}

/// Reads a surface or a tet mesh from bytes, as [`parse`] does.
///
/// # Errors
/// [`MeshError::Read`] with file, place and reason.
pub fn parse_complex(bytes: &[u8], format: Format, name: &str) -> Result<ComplexFile, MeshError> {
    let read = || -> Result<ComplexFile, Located> {
        let Some(parts) = parse_parts(bytes, format)? else {
            let MeshFile { mesh, format, notes } = parse_located(bytes, format)?;
            return Ok(ComplexFile { complex: Complex::from(mesh), exact: Vec::new(), format, notes });
        };
        let (complex, exact, notes) = parts.complex(&format.to_string())?;
        Ok(ComplexFile { complex, exact, format, notes })
    };
    read().map_err(|located| located.reading(name))
}

/// The content of a file in a format for cells of several dimensions; `None` for the others.
fn parse_parts(bytes: &[u8], format: Format) -> Result<Option<Parts>, Located> {
    let text = strip_bom(bytes);
    if text.trim_ascii().is_empty() {
        return Err(Fault::Empty.into());
    }
    let parts = match format {
        Format::Vtk => vtk::parse(bytes)?,
        Format::Medit => medit::parse(text)?,
        Format::Gmsh => gmsh::parse(text)?,
        Format::Gifti => gifti::parse(text)?,
        Format::Ovm => ovm::parse(text)?,
        _ => return Ok(None),
    };
    Ok(Some(parts))
}

fn parse_located(bytes: &[u8], format: Format) -> Result<MeshFile, Located> {
    if let Some(parts) = parse_parts(bytes, format)? {
        let (mesh, notes) = parts.surface(&format.to_string())?;
        return Ok(MeshFile { mesh, format, notes });
    }
    let text = strip_bom(bytes);
    let (format, (mesh, notes)) = match format {
        Format::Obj => (format, obj::parse(text)?),
        Format::Off => (format, off::parse(text)?),
        Format::PlyAscii | Format::PlyBinaryLe | Format::PlyBinaryBe => ply::parse(bytes)?,
        Format::StlAscii | Format::StlBinary if stl::is_binary(bytes) => {
            (Format::StlBinary, stl::parse_binary(bytes)?)
        }
        Format::StlAscii => (format, stl::parse_ascii(text)?),
        Format::StlBinary
            if text.trim_ascii_start().get(..5).is_some_and(|s| s.eq_ignore_ascii_case(b"solid")) =>
        {
            (Format::StlAscii, stl::parse_ascii(text)?)
        }
        _ => (format, stl::parse_binary(bytes)?),
    };
    Ok(MeshFile { mesh, format, notes })
}

/// Most bytes that a compressed file may unpack to.
const MOST: u64 = 1 << 32;

/// The whole of a regular file, unpacked if it is compressed with gzip. Devices and pipes are refused: they need
/// not end.
pub(super) fn load(path: &Path) -> Result<Vec<u8>, Fault> {
    let io = |e: std::io::Error| Fault::Io(e.to_string());
    if !std::fs::metadata(path).map_err(io)?.is_file() {
        return Err(Fault::NotAFile);
    }
    let bytes = std::fs::read(path).map_err(io)?;
    if bytes.starts_with(b"\x1f\x8b") { unpack(&bytes) } else { Ok(bytes) }
}

fn unpack(bytes: &[u8]) -> Result<Vec<u8>, Fault> {
    let mut out = Vec::new();
    let read = MultiGzDecoder::new(bytes).take(MOST + 1).read_to_end(&mut out);
    read.map_err(|e| Fault::BadHeader(format!("gzip: {e}")))?;
    if out.len() as u64 > MOST {
        return Err(Fault::Unsupported("a compressed file of more than 4 GiB".to_owned()));
    }
    Ok(out)
}

/// Without a UTF-8 byte order mark.
pub(super) fn strip_bom(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}
