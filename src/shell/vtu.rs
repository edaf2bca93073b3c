//! Shells for ParaView: an unstructured grid of two wedges a prism.

use super::validate::{self, ShellError};
use super::{Layer, Shell, Slab};
use std::io::{self, Write};
use std::path::Path;

/// Why no VTU file was written.
#[derive(Debug, thiserror::Error)]
pub enum VtuError {
    /// The shell's layers differ in length, or a corner is out of range.
    #[error(transparent)]
    Shell(#[from] ShellError),
    /// The file could not be written.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// The system's reason.
        source: io::Error,
    },
}

/// VTK's number for a wedge.
const VTK_WEDGE: u8 = 13;

/// Writes the shell as a VTU file; an existing file is replaced only after all bytes are written.
///
/// Points are the bottom, middle and top points in this order (`layer * n + vertex`), every bit
/// kept, with the point data `vertex` and `height` (-1, 0, 1). Cells are the prisms' slabs, bottom
/// then top, with the cell data `prism` and `slab` (0 bottom, 1 top). Wedges at a pinched vertex
/// repeat its position.
///
/// # Errors
/// See [`VtuError`].
pub fn write(path: &Path, shell: &Shell) -> Result<(), VtuError> {
    check(shell)?;
    super::replace_file(path, |out| emit(shell, out))
        .map_err(|source| VtuError::Io { file: path.display().to_string(), source })
}

/// The bytes of the VTU file that [`write()`] writes.
///
/// # Errors
/// [`VtuError::Shell`].
pub fn to_bytes(shell: &Shell) -> Result<Vec<u8>, VtuError> {
    check(shell)?;
    let mut bytes = Vec::new();
    emit(shell, &mut bytes).map_err(|source| VtuError::Io { file: "memory".to_owned(), source })?;
    Ok(bytes)
}

fn check(shell: &Shell) -> Result<(), ShellError> {
    validate::lengths(shell)?;
    validate::indices(shell)
}

/// A data array in the appended section: attributes, and its raw little-endian bytes.
struct Array {
    attributes: &'static str,
    bytes: Vec<u8>,
}

impl Array {
    fn new<const N: usize>(attributes: &'static str, values: impl Iterator<Item = [u8; N]>) -> Self {
        Self { attributes, bytes: values.flatten().collect() }
    }
}

fn emit(shell: &Shell, out: &mut impl Write) -> io::Result<()> {
    let (points, cells) = (3 * shell.vertex_count(), 2 * shell.prism_count());
    let sections = [
        ("Points", vec![coordinates(shell)]),
        ("Cells", connectivity(shell)),
        ("PointData", point_data(shell)),
        ("CellData", cell_data(shell)),
    ];
    writeln!(out, r#"<?xml version="1.0"?>"#)?;
    let kind = r#"type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64""#;
    writeln!(out, "<VTKFile {kind}>\n<UnstructuredGrid>")?;
    writeln!(out, r#"<Piece NumberOfPoints="{points}" NumberOfCells="{cells}">"#)?;
    let mut offset = 0;
    for (section, arrays) in &sections {
        writeln!(out, "<{section}>")?;
        for array in arrays {
            writeln!(out, r#"<DataArray {} format="appended" offset="{offset}"/>"#, array.attributes)?;
            offset += 8 + array.bytes.len();
        }
        writeln!(out, "</{section}>")?;
    }
    write!(out, "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_")?;
    for array in sections.iter().flat_map(|(_, arrays)| arrays) {
        out.write_all(&(array.bytes.len() as u64).to_le_bytes())?;
        out.write_all(&array.bytes)?;
    }
    out.write_all(b"\n</AppendedData>\n</VTKFile>\n")
}

const LAYERS: [Layer; 3] = [Layer::Bottom, Layer::Middle, Layer::Top];

fn coordinates(shell: &Shell) -> Array {
    let values = LAYERS.into_iter().flat_map(|layer| shell.layer(layer)).flatten();
    Array::new(r#"type="Float64" Name="Points" NumberOfComponents="3""#, values.map(|x| x.to_le_bytes()))
}

fn connectivity(shell: &Shell) -> Vec<Array> {
    let n = shell.vertex_count() as u64;
    let point = move |layer: Layer, vertex: u32| layer as u64 * n + u64::from(vertex);
    // VTK's first triangle of a wedge is seen counter-clockwise from outside: it is the upper one.
    let wedge = move |face: [u32; 3], slab: Slab| {
        [slab.hi(), slab.lo()].into_iter().flat_map(move |layer| face.map(|vertex| point(layer, vertex)))
    };
    let slabs = |face: &[u32; 3]| {
        let face = *face;
        Slab::BOTH.into_iter().flat_map(move |slab| wedge(face, slab))
    };
    let corners = shell.faces.iter().flat_map(slabs);
    let cells = 2 * shell.prism_count() as u64;
    vec![
        Array::new(r#"type="Int64" Name="connectivity""#, corners.map(u64::to_le_bytes)),
        Array::new(r#"type="Int64" Name="offsets""#, (1..=cells).map(|k| (6 * k).to_le_bytes())),
        Array::new(r#"type="UInt8" Name="types""#, (0..cells).map(|_| [VTK_WEDGE])),
    ]
}

fn point_data(shell: &Shell) -> Vec<Array> {
    let n = shell.vertex_count() as u64;
    let heights = LAYERS.into_iter().flat_map(|layer| (0..n).map(move |_| layer.height().to_le_bytes()));
    vec![
        Array::new(
            r#"type="Int64" Name="vertex""#,
            LAYERS.into_iter().flat_map(|_| 0..n).map(u64::to_le_bytes),
        ),
        Array::new(r#"type="Int8" Name="height""#, heights),
    ]
}

fn cell_data(shell: &Shell) -> Vec<Array> {
    let prisms = 0..shell.prism_count() as u64;
    let twice = prisms.clone().flat_map(|prism| [prism, prism]).map(u64::to_le_bytes);
    vec![
        Array::new(r#"type="Int64" Name="prism""#, twice),
        Array::new(r#"type="UInt8" Name="slab""#, prisms.flat_map(|_| [[0], [1]])),
    ]
}
