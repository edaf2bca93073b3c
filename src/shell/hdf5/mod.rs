//! The shell files of the reference implementation of *Shell* (HDF5).
//!
//! One root group with the datasets
//!
//! | dataset | shape | content |
//! |---|---|---|
//! | `mbase`, `mV`, `mtop` | n x 3 f64 | bottom, middle, top points |
//! | `mF` | p x 3 i32 | middle complex |
//! | `ref.V`, `ref.F` | N x 3 f64, F x 3 i32 | the mesh |
//! | `track_size`, `track_flat` | p, sum i32 | mesh triangles that the writer believes to meet a prism |
//! | `meta_edges_flat`, `meta_edges_ind` | i32 | feature edges: see [`MetaEdge`] |
//! | `metadata` | 3 i32 | version 1, [`Separation`], number of pinched vertices |
//!
//! Only the first four are required. [`read`] and [`parse`] read, [`write()`] and [`to_bytes`]
//! write; a file written here and read again is equal bit by bit.
//!
//! **Which crate reads.** `hdf5-pure` 0.47 (MIT or Apache-2.0, pure Rust, no system library). It
//! reads all 20 files of the reference program that were at hand and what h5py writes from them:
//! big-endian, chunked, gzip, shuffle, Fletcher-32, LZF, and the newest format but for chunk indexes of
//! HDF5 2.0 (layout message version 5: an error that says so). On damaged files it limits nesting
//! and returns errors, with four gaps, which this module's `source` closes before it lets values be
//! read: a number type is told by its size alone; memory follows the extent that a dataset claims;
//! missing chunks read as fill values; a chunk's offset is added without a check for overflow (a
//! panic in debug builds). Over 1,000,000 randomly damaged files of five encodings then gave no
//! panic within 1 GB of address space. As it served, no other crate was tried.
//!
//! **Which crate writes.** None: the format's oldest subset is what the reference program itself
//! writes and what small independent parsers read, and it is a few fixed records; see [`to_bytes`].

mod encode;
mod parse;
mod source;
#[cfg(test)]
mod tests;

pub use encode::{WriteError, to_bytes, write};
pub use parse::{parse, read};

use super::Shell;
use crate::mesh::TriMesh;

/// Larger files are refused before they are read into memory.
pub const MAX_FILE_BYTES: u64 = 1 << 33;

/// What a shell file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShellFile {
    /// The shell (`mbase`, `mV`, `mtop`, `mF`); coordinates finite, indices in range.
    pub shell: Shell,
    /// The mesh (`ref.V`, `ref.F`), if stored; coordinates finite, indices in range.
    pub mesh: Option<TriMesh>,
    /// The writer's belief about which mesh triangles meet which prism: a hint, never a proof.
    pub tracks: Option<Tracks>,
    /// The feature edges (`meta_edges_*`), if stored.
    pub meta_edges: Option<Vec<MetaEdge>>,
    /// The three numbers of `metadata`, if stored.
    pub metadata: Option<Metadata>,
    /// Remarks for the user: what is missing, ignored, or at odds with the data.
    pub notes: Vec<String>,
}

/// Mesh triangles by prism.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tracks {
    sizes: Vec<u32>,
    starts: Vec<usize>,
    flat: Vec<u32>,
}

impl Tracks {
    /// From the number of triangles of each prism and their ids, prism after prism; `None` unless
    /// the sizes add up to the number of ids.
    #[must_use]
    pub fn new(sizes: Vec<u32>, flat: Vec<u32>) -> Option<Self> {
        let mut starts = Vec::with_capacity(sizes.len());
        let mut total = 0_usize;
        for &size in &sizes {
            starts.push(total);
            total = total.checked_add(size as usize)?;
        }
        (total == flat.len()).then_some(Self { sizes, starts, flat })
    }

    /// The mesh triangles tracked by a prism (none where there is no such prism).
    #[must_use]
    pub fn of(&self, prism: u32) -> &[u32] {
        let p = prism as usize;
        match (self.starts.get(p), self.sizes.get(p)) {
            (Some(&start), Some(&size)) => {
                self.flat.get(start..).and_then(|f| f.get(..size as usize)).unwrap_or(&[])
            }
            _ => &[],
        }
    }

    /// The number of prisms.
    #[must_use]
    pub fn prism_count(&self) -> usize {
        self.sizes.len()
    }

    /// The number of triangles of each prism.
    #[must_use]
    pub fn sizes(&self) -> &[u32] {
        &self.sizes
    }

    /// The triangle ids, prism after prism.
    #[must_use]
    pub fn flat(&self) -> &[u32] {
        &self.flat
    }
}

/// A feature edge: an edge of the middle complex that stands for a chain of mesh vertices.
///
/// Stored as `v0 v1 curve chain...`, record after record, in `meta_edges_flat`; `meta_edges_ind`
/// holds 0 and the end of every record. The numbers are kept as they are and take part in no claim.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MetaEdge {
    /// The edge's vertices.
    pub edge: [i32; 2],
    /// The writer's id of the feature curve.
    pub curve: i32,
    /// The chain of mesh vertices.
    pub chain: Vec<i32>,
}

/// The dataset `metadata`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Metadata {
    /// The layout's version; the reference program writes 1.
    pub version: i32,
    /// What the writer kept apart while it made the shell.
    pub separation: Separation,
    /// The number of pinched vertices that the writer states.
    pub pinched: i32,
}

/// What the writer of a shell file kept apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separation {
    /// 0: bottom and top from themselves, by a hash grid.
    Shell,
    /// 1: the mesh from bottom and top.
    Surface,
    /// 2: nothing.
    None,
    /// Any other number.
    Other(i32),
}

impl Separation {
    /// From the number in the file.
    #[must_use]
    pub const fn from_code(code: i32) -> Self {
        match code {
            0 => Self::Shell,
            1 => Self::Surface,
            2 => Self::None,
            other => Self::Other(other),
        }
    }

    /// The number in the file.
    #[must_use]
    pub const fn code(self) -> i32 {
        match self {
            Self::Shell => 0,
            Self::Surface => 1,
            Self::None => 2,
            Self::Other(other) => other,
        }
    }
}

/// Why a shell file was refused.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The file could not be opened or read.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// The system's reason.
        source: std::io::Error,
    },
    /// Not a regular file.
    #[error("{file}: is not a regular file")]
    NotAFile {
        /// The file.
        file: String,
    },
    /// Longer than [`MAX_FILE_BYTES`].
    #[error("{file}: has {bytes} bytes; at most {MAX_FILE_BYTES} are read")]
    TooLarge {
        /// The file.
        file: String,
        /// Its length.
        bytes: u64,
    },
    /// Not HDF5 at all, or damaged before any dataset could be named.
    #[error("{file}: not a readable HDF5 file: {reason}")]
    Format {
        /// The file.
        file: String,
        /// What the HDF5 reader says.
        reason: String,
    },
    /// A dataset is missing, damaged, of the wrong type or shape, or has a bad value.
    #[error("{file}: dataset {dataset}: {reason}")]
    Dataset {
        /// The file.
        file: String,
        /// The dataset.
        dataset: String,
        /// What is wrong with it, with the row where a value is wrong.
        reason: String,
    },
}
