//! A writer for the oldest subset of HDF5: superblock version 0, one old-style root group (version 1
//! B-tree, local heap, symbol table nodes), version 1 object headers, contiguous little-endian
//! f64 and i32. This is what the reference program writes.

use super::ShellFile;
use std::io::Write as _;
use std::path::Path;

/// Why a shell file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// A number does not fit into the layout's 32-bit signed integers.
    #[error("{dataset}: {value} does not fit into a signed 32-bit integer")]
    TooLarge {
        /// The dataset.
        dataset: &'static str,
        /// The number.
        value: u32,
    },
    /// The shell's three layers differ in length.
    #[error("the shell has {bottom} bottom, {middle} middle and {top} top points")]
    Lengths {
        /// Bottom points.
        bottom: usize,
        /// Middle points.
        middle: usize,
        /// Top points.
        top: usize,
    },
    /// The file could not be written.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// The system's reason.
        source: std::io::Error,
    },
}

/// Writes a shell file; an existing file is replaced only after all bytes are written.
///
/// # Errors
/// See [`WriteError`].
pub fn write(path: &Path, file: &ShellFile) -> Result<(), WriteError> {
    let bytes = to_bytes(file)?;
    crate::shell::replace_file(path, |out| out.write_all(&bytes))
        .map_err(|source| WriteError::Io { file: path.display().to_string(), source })
}

/// The bytes of a shell file. Parts that are `None` have no datasets.
///
/// # Errors
/// Everything in [`WriteError`] but `Io`.
pub fn to_bytes(file: &ShellFile) -> Result<Vec<u8>, WriteError> {
    let shell = &file.shell;
    let (bottom, middle, top) = (shell.bottom.len(), shell.middle.len(), shell.top.len());
    if bottom != middle || middle != top {
        return Err(WriteError::Lengths { bottom, middle, top });
    }
    let mut sets = vec![
        Set::points("mbase", &shell.bottom),
        Set::points("mV", &shell.middle),
        Set::points("mtop", &shell.top),
        Set::triangles("mF", &shell.faces)?,
    ];
    if let Some(mesh) = &file.mesh {
        sets.push(Set::points("ref.V", &mesh.vertices));
        sets.push(Set::triangles("ref.F", &mesh.faces)?);
    }
    if let Some(tracks) = &file.tracks {
        sets.push(Set::list("track_size", tracks.sizes())?);
        sets.push(Set::list("track_flat", tracks.flat())?);
    }
    if let Some(edges) = &file.meta_edges {
        let mut flat = Vec::new();
        let mut ends = vec![0];
        for edge in edges {
            flat.extend(edge.edge);
            flat.push(edge.curve);
            flat.extend(&edge.chain);
            ends.push(u32::try_from(flat.len()).unwrap_or(u32::MAX));
        }
        sets.push(Set::integers("meta_edges_flat", vec![flat.len()], &flat));
        sets.push(Set::list("meta_edges_ind", &ends)?);
    }
    if let Some(metadata) = file.metadata {
        let numbers = [metadata.version, metadata.separation.code(), metadata.pinched];
        sets.push(Set::integers("metadata", vec![3], &numbers));
    }
    // The group's B-tree is a search tree over the names.
    sets.sort_by_key(|set| set.name);
    Ok(assemble(&sets))
}

#[derive(Clone, Copy)]
enum Kind {
    F64,
    I32,
}

struct Set {
    name: &'static str,
    shape: Vec<usize>,
    kind: Kind,
    data: Vec<u8>,
}

impl Set {
    fn points(name: &'static str, points: &[[f64; 3]]) -> Self {
        let data = points.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        Self { name, shape: vec![points.len(), 3], kind: Kind::F64, data }
    }

    fn triangles(name: &'static str, faces: &[[u32; 3]]) -> Result<Self, WriteError> {
        let set = Self::list(name, faces.as_flattened())?;
        Ok(Self { shape: vec![faces.len(), 3], ..set })
    }

    fn list(name: &'static str, values: &[u32]) -> Result<Self, WriteError> {
        let convert =
            |&value| i32::try_from(value).map_err(|_| WriteError::TooLarge { dataset: name, value });
        let values = values.iter().map(convert).collect::<Result<Vec<i32>, _>>()?;
        Ok(Self::integers(name, vec![values.len()], &values))
    }

    fn integers(name: &'static str, shape: Vec<usize>, values: &[i32]) -> Self {
        let data = values.iter().flat_map(|x| x.to_le_bytes()).collect();
        Self { name, shape, kind: Kind::I32, data }
    }
}

const UNDEFINED: u64 = u64::MAX;
/// Half the number of entries of a symbol table node, and of children of a B-tree node.
const LEAF_K: u16 = 4;
const TREE_K: u16 = 16;

const SUPERBLOCK: usize = 96;
const ROOT_HEADER: usize = 40;
const TREE: usize = 24 + (2 * TREE_K as usize + 1) * 8 + 2 * TREE_K as usize * 8;
const HEAP: usize = 32;
const NODE: usize = 8 + 2 * LEAF_K as usize * 40;

/// Little-endian output.
#[derive(Default)]
struct Out(Vec<u8>);

impl Out {
    fn bytes(&mut self, bytes: &[u8]) -> &mut Self {
        self.0.extend_from_slice(bytes);
        self
    }
    fn u16(&mut self, value: u16) -> &mut Self {
        self.bytes(&value.to_le_bytes())
    }
    fn u32(&mut self, value: u32) -> &mut Self {
        self.bytes(&value.to_le_bytes())
    }
    fn u64(&mut self, value: u64) -> &mut Self {
        self.bytes(&value.to_le_bytes())
    }
    fn size(&mut self, value: usize) -> &mut Self {
        self.u64(value as u64)
    }
    fn zeros_until(&mut self, length: usize) -> &mut Self {
        self.0.resize(length.max(self.0.len()), 0);
        self
    }
    /// A message of a version 1 object header; its body is padded to a multiple of 8.
    fn message(&mut self, kind: u16, flags: u8, body: &Self) -> &mut Self {
        let size = body.0.len().next_multiple_of(8);
        // Bodies have at most 40 bytes: a dataspace of two dimensions.
        #[allow(clippy::cast_possible_truncation)]
        self.u16(kind).u16(size as u16).bytes(&[flags, 0, 0, 0]).bytes(&body.0);
        self.zeros_until(self.0.len() + size - body.0.len())
    }
}

/// Where everything is: headers and group first, then the data, 8-byte aligned.
struct Plan {
    names: Vec<usize>,
    heap_data: usize,
    headers: Vec<usize>,
    data: Vec<u64>,
    nodes: usize,
    end: usize,
}

fn plan(sets: &[Set]) -> Plan {
    // Offset 0 of the heap holds the empty string, the key before all names.
    let mut heap_data = 8;
    let mut names = Vec::new();
    for set in sets {
        names.push(heap_data);
        heap_data += (set.name.len() + 1).next_multiple_of(8);
    }
    let nodes = SUPERBLOCK + ROOT_HEADER + TREE + HEAP + heap_data;
    let mut at = nodes + NODE * sets.chunks(2 * usize::from(LEAF_K)).len();
    let mut headers = Vec::new();
    for set in sets {
        headers.push(at);
        at += header(set, 0).0.len();
    }
    let mut data = Vec::new();
    for set in sets {
        data.push(if set.data.is_empty() { UNDEFINED } else { at as u64 });
        at += set.data.len().next_multiple_of(8);
    }
    Plan { names, heap_data, headers, data, nodes, end: at }
}

fn assemble(sets: &[Set]) -> Vec<u8> {
    let plan = plan(sets);
    let mut out = Out::default();
    superblock(&mut out, plan.end);
    root_header(&mut out);
    group(&mut out, sets, &plan);
    for (set, &address) in sets.iter().zip(&plan.data) {
        out.bytes(&header(set, address).0);
    }
    for set in sets {
        out.bytes(&set.data);
        out.zeros_until(out.0.len().next_multiple_of(8));
    }
    out.0
}

fn superblock(out: &mut Out, end: usize) {
    out.bytes(b"\x89HDF\r\n\x1a\n");
    // Versions of superblock, free space and root group; of shared headers; sizes of offsets and lengths.
    out.bytes(&[0, 0, 0, 0, 0, 8, 8, 0]);
    out.u16(LEAF_K).u16(TREE_K).u32(0);
    // Base address, free space, end of file, driver information.
    out.u64(0).u64(UNDEFINED).size(end).u64(UNDEFINED);
    // The root group's symbol table entry, with its B-tree and heap cached.
    out.u64(0).size(SUPERBLOCK).u32(1).u32(0);
    out.size(SUPERBLOCK + ROOT_HEADER).size(SUPERBLOCK + ROOT_HEADER + TREE);
}

fn object_header(messages: u16, body: &Out) -> Out {
    let mut out = Out::default();
    // Headers have at most 200 bytes.
    #[allow(clippy::cast_possible_truncation)]
    let size = body.0.len() as u32;
    out.bytes(&[1, 0]).u16(messages).u32(1).u32(size).u32(0).bytes(&body.0);
    out
}

fn root_header(out: &mut Out) {
    let mut table = Out::default();
    table.size(SUPERBLOCK + ROOT_HEADER).size(SUPERBLOCK + ROOT_HEADER + TREE);
    let mut body = Out::default();
    body.message(0x11, 0, &table);
    out.bytes(&object_header(1, &body).0);
}

/// B-tree node, local heap and symbol table nodes.
fn group(out: &mut Out, sets: &[Set], plan: &Plan) {
    let per_node = 2 * usize::from(LEAF_K);
    let nodes = sets.chunks(per_node).len();
    let start = out.0.len();
    // At most 11 datasets, so that one tree node suffices.
    #[allow(clippy::cast_possible_truncation)]
    out.bytes(b"TREE\0\0").u16(nodes as u16).u64(UNDEFINED).u64(UNDEFINED).u64(0);
    for (k, names) in plan.names.chunks(per_node).enumerate() {
        // Child, then its last name as the key after it.
        out.size(plan.nodes + k * NODE).size(names.last().copied().unwrap_or(0));
    }
    out.zeros_until(start + TREE);
    let data = out.0.len() + HEAP;
    // 1 is the mark for "no free block".
    out.bytes(b"HEAP\0\0\0\0").size(plan.heap_data).u64(1).size(data);
    for (set, &offset) in sets.iter().zip(&plan.names) {
        out.zeros_until(data + offset).bytes(set.name.as_bytes());
    }
    out.zeros_until(data + plan.heap_data);
    let entries: Vec<_> = plan.names.iter().zip(&plan.headers).collect();
    for chunk in entries.chunks(per_node) {
        let start = out.0.len();
        #[allow(clippy::cast_possible_truncation)]
        out.bytes(b"SNOD\x01\0").u16(chunk.len() as u16);
        for &(&name, &header) in chunk {
            out.size(name).size(header).u64(0).u64(0).u64(0);
        }
        out.zeros_until(start + NODE);
    }
}

/// A dataset's object header: dataspace, datatype, fill value, layout.
fn header(set: &Set, address: u64) -> Out {
    let mut space = Out::default();
    #[allow(clippy::cast_possible_truncation)] // one or two dimensions
    // Version 1, rank, and the flag for "maximal extents follow", which equal the extents.
    space.bytes(&[1, set.shape.len() as u8, 1, 0, 0, 0, 0, 0]);
    for &extent in set.shape.iter().chain(&set.shape) {
        space.size(extent);
    }
    let mut datatype = Out::default();
    match set.kind {
        // Version 1, class 1, little-endian, implied leading mantissa bit, sign bit 63; size;
        // bit offset, precision; exponent at 52 of size 11, mantissa at 0 of size 52; bias.
        Kind::F64 => {
            datatype.bytes(&[0x11, 0x20, 63, 0]).u32(8).u16(0).u16(64).bytes(&[52, 11, 0, 52]).u32(1023)
        }
        // Version 1, class 0, little-endian, signed; size; bit offset, precision.
        Kind::I32 => datatype.bytes(&[0x10, 0x08, 0, 0]).u32(4).u16(0).u16(32),
    };
    let mut fill = Out::default();
    // Version 2, late allocation, written if set, the default value.
    fill.bytes(&[2, 2, 2, 1]).u32(0);
    let mut layout = Out::default();
    // Version 3, contiguous.
    layout.bytes(&[3, 1]).u64(address).size(set.data.len());
    let mut body = Out::default();
    body.message(0x01, 0, &space)
        .message(0x03, 1, &datatype)
        .message(0x05, 1, &fill)
        .message(0x08, 0, &layout);
    object_header(4, &body)
}
