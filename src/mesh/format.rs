//! Which format a file has, and reading it.

use super::error::{Fault, Located, MeshError};
use super::text::{Lines, tokens};
use super::{TriMesh, obj, off, ply, stl};
use serde::Serialize;
use std::ffi::OsStr;
use std::fmt;
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
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 7] = [
        Self::Obj,
        Self::Off,
        Self::PlyAscii,
        Self::PlyBinaryLe,
        Self::PlyBinaryBe,
        Self::StlAscii,
        Self::StlBinary,
    ];

    /// The format to write to a file of this name; binary where both exist.
    #[must_use]
    pub fn from_extension(path: &Path) -> Option<Self> {
        let extension = path.extension().and_then(OsStr::to_str)?.to_ascii_lowercase();
        match extension.as_str() {
            "obj" => Some(Self::Obj),
            "off" | "coff" | "noff" | "cnoff" => Some(Self::Off),
            "ply" => Some(Self::PlyBinaryLe),
            "stl" => Some(Self::StlBinary),
            _ => None,
        }
    }

    /// The format that the content shows, if it does; OBJ has no mark.
    #[must_use]
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        if stl::is_binary(bytes) {
            return Some(Self::StlBinary);
        }
        if let Some(format) = ply::detect(bytes) {
            return Some(format);
        }
        let (_, line) = Lines::new(strip_bom(bytes)).next_content()?;
        let first = tokens(line).next()?;
        if off::is_magic(first) {
            return Some(Self::Off);
        }
        first.eq_ignore_ascii_case(b"solid").then_some(Self::StlAscii)
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

/// Reads a mesh; the format is taken from the content (OFF and PLY headers, the exact size of a
/// binary STL, `solid`), else from the file name's extension (OBJ).
///
/// # Errors
/// [`MeshError::Read`] with file, place and reason.
pub fn read(path: &Path) -> Result<MeshFile, MeshError> {
    let name = path.to_string_lossy();
    let bytes = load(path).map_err(|fault| Located::from(fault).reading(&name))?;
    let format = Format::from_content(&bytes).or_else(|| Format::from_extension(path));
    match format {
        Some(format) => parse(&bytes, format, &name),
        None if strip_bom(&bytes).trim_ascii().is_empty() => Err(Located::from(Fault::Empty).reading(&name)),
        None => Err(Located::from(Fault::UnknownFormat).reading(&name)),
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

fn parse_located(bytes: &[u8], format: Format) -> Result<MeshFile, Located> {
    let text = strip_bom(bytes);
    if text.trim_ascii().is_empty() {
        return Err(Fault::Empty.into());
    }
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
        Format::StlBinary => (format, stl::parse_binary(bytes)?),
    };
    Ok(MeshFile { mesh, format, notes })
}

/// The whole of a regular file. Devices and pipes are refused: they need not end.
pub(super) fn load(path: &Path) -> Result<Vec<u8>, Fault> {
    let io = |e: std::io::Error| Fault::Io(e.to_string());
    if !std::fs::metadata(path).map_err(io)?.is_file() {
        return Err(Fault::NotAFile);
    }
    std::fs::read(path).map_err(io)
}

/// Without a UTF-8 byte order mark.
pub(super) fn strip_bom(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}
