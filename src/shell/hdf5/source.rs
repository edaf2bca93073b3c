//! Typed datasets out of untrusted HDF5 bytes: every check that `hdf5-pure` leaves to its caller.

use super::ReadError;
use hdf5_pure::{Dataset, Datatype, FloatingPointLayout, Layout};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Deflate shrinks by a factor of at most 1032, so a filtered dataset larger than this multiple of
/// the whole file cannot be what the file holds.
const MAX_INFLATION: u64 = 1100;

/// HDF5 filters whose inflation is bounded as above: deflate, shuffle, Fletcher-32, LZF.
const KNOWN_FILTERS: [u16; 4] = [1, 2, 3, 32000];

/// An opened file.
pub(super) struct Source {
    name: String,
    bytes: u64,
    file: hdf5_pure::File,
}

/// A dataset's shape and values.
pub(super) struct Table<T> {
    pub(super) shape: Vec<u64>,
    pub(super) values: Vec<T>,
}

/// Runs a call into the HDF5 reader. The reader is meant to return errors on any bytes, and all
/// damaged files tried here got one; should one of its 100,000 lines panic nevertheless, the user
/// gets an error and the process lives. The panic hook stays as it is (it is process-wide).
fn guarded<T>(call: impl FnOnce() -> Result<T, hdf5_pure::Error>) -> Result<T, String> {
    match catch_unwind(AssertUnwindSafe(call)) {
        Ok(result) => result.map_err(|error| error.to_string()),
        Err(_) => Err("the HDF5 reader failed on this damaged file".to_owned()),
    }
}

impl Source {
    pub(super) fn open(name: &str, bytes: Vec<u8>) -> Result<Self, ReadError> {
        let length = bytes.len() as u64;
        let file = guarded(|| hdf5_pure::File::from_bytes(bytes))
            .map_err(|reason| ReadError::Format { file: name.to_owned(), reason })?;
        Ok(Self { name: name.to_owned(), bytes: length, file })
    }

    /// The names of the root group's datasets.
    pub(super) fn datasets(&self) -> Result<Vec<String>, ReadError> {
        guarded(|| self.file.root().datasets())
            .map_err(|reason| ReadError::Format { file: self.name.clone(), reason })
    }

    pub(super) fn error(&self, dataset: &str, reason: impl Into<String>) -> ReadError {
        ReadError::Dataset { file: self.name.clone(), dataset: dataset.to_owned(), reason: reason.into() }
    }

    /// A dataset of doubles, or of floats, which are widened exactly.
    pub(super) fn floats(&self, name: &str) -> Result<Table<f64>, ReadError> {
        self.table(name, is_float, Dataset::read_f64)
    }

    /// A dataset of integers of any width.
    pub(super) fn integers(&self, name: &str) -> Result<Table<i64>, ReadError> {
        self.table(name, is_integer, Dataset::read_i64)
    }

    fn table<T>(
        &self,
        name: &str,
        accepts: fn(&Datatype) -> Result<(), String>,
        read: fn(&Dataset) -> Result<Vec<T>, hdf5_pure::Error>,
    ) -> Result<Table<T>, ReadError> {
        let fail = |reason: String| self.error(name, reason);
        let dataset = guarded(|| self.file.dataset(name)).map_err(fail)?;
        let datatype = guarded(|| dataset.datatype()).map_err(fail)?;
        accepts(&datatype).map_err(fail)?;
        let shape = guarded(|| dataset.shape()).map_err(fail)?;
        let count = shape.iter().try_fold(1_u64, |product, &n| product.checked_mul(n));
        let count = count.ok_or_else(|| fail(format!("its shape {shape:?} is absurd")))?;
        if count == 0 {
            return Ok(Table { shape, values: Vec::new() });
        }
        self.check_extent(&dataset, &shape, count).map_err(fail)?;
        let values = guarded(|| read(&dataset)).map_err(fail)?;
        if values.len() as u64 != count {
            return Err(fail(format!("has {} values where its shape {shape:?} says {count}", values.len())));
        }
        Ok(Table { shape, values })
    }

    /// Compares the extent with the file's length, so that no allocation exceeds what the file
    /// can justify.
    fn check_extent(&self, dataset: &Dataset, shape: &[u64], count: u64) -> Result<(), String> {
        let element = guarded(|| dataset.element_size())?;
        let total =
            count.checked_mul(element).filter(|&total| total <= self.bytes.saturating_mul(MAX_INFLATION));
        let Some(total) = total else {
            return Err(format!("claims {count} values in a file of {} bytes", self.bytes));
        };
        match guarded(|| dataset.layout())? {
            Layout::Compact { size } if size == total => Ok(()),
            Layout::Contiguous { address: Some(address), size } if size == total => {
                match address.checked_add(size) {
                    Some(end) if end <= self.bytes => Ok(()),
                    _ => {
                        Err(format!("its {size} bytes at {address} exceed the file of {} bytes", self.bytes))
                    }
                }
            }
            Layout::Contiguous { address: None, .. } => Err("holds no data: it was never written".to_owned()),
            Layout::Compact { size } | Layout::Contiguous { size, .. } => {
                Err(format!("stores {size} bytes where its shape says {total}"))
            }
            Layout::Chunked { chunk_shape, .. } => {
                self.check_chunks(dataset, shape, &chunk_shape, element, total)
            }
            _ => Err("is stored in a layout (virtual dataset) that is not supported".to_owned()),
        }
    }

    fn check_chunks(
        &self,
        dataset: &Dataset,
        shape: &[u64],
        chunk: &[u64],
        element: u64,
        total: u64,
    ) -> Result<(), String> {
        let filters = guarded(|| Ok(dataset.filters()))?;
        if let Some(filter) = filters.iter().find(|filter| !KNOWN_FILTERS.contains(filter)) {
            return Err(format!("uses the HDF5 filter {filter}, which is not supported"));
        }
        let limit = if filters.is_empty() { self.bytes } else { self.bytes.saturating_mul(MAX_INFLATION) };
        let chunk_bytes = chunk.iter().try_fold(element, |product, &n| product.checked_mul(n));
        match chunk_bytes {
            Some(bytes) if bytes <= limit && total <= limit => complete_grid(dataset, shape, chunk),
            _ => {
                Err(format!("claims {total} bytes in chunks of {chunk:?} in a file of {} bytes", self.bytes))
            }
        }
    }
}

/// Every chunk of the grid is there once and none lies elsewhere. The reader would fill a hole with
/// zeros, and adds up a chunk's offset without a check for overflow.
fn complete_grid(dataset: &Dataset, shape: &[u64], chunk: &[u64]) -> Result<(), String> {
    if shape.len() != chunk.len() || chunk.contains(&0) {
        return Err(format!("has chunks of {chunk:?} for a shape of {shape:?}"));
    }
    let mut found: Vec<Vec<u64>> =
        guarded(|| dataset.chunks())?.into_iter().map(|chunk| chunk.offset).collect();
    let on_grid = |offset: &Vec<u64>| {
        let axes = offset.iter().zip(shape).zip(chunk);
        offset.len() == shape.len()
            && axes.into_iter().all(|((&at, &extent), &step)| at < extent && at % step == 0)
    };
    if let Some(offset) = found.iter().find(|offset| !on_grid(offset)) {
        return Err(format!("has a chunk at {offset:?}, which is no place in its grid"));
    }
    found.sort_unstable();
    found.dedup();
    let expected =
        shape.iter().zip(chunk).try_fold(1_u64, |all, (&n, &step)| all.checked_mul(n.div_ceil(step)));
    if expected != Some(found.len() as u64) {
        return Err(format!("has {} different chunks, which do not cover its shape {shape:?}", found.len()));
    }
    Ok(())
}

fn is_float(datatype: &Datatype) -> Result<(), String> {
    let good = match datatype {
        Datatype::FloatingPoint { size: 8, layout, .. } => *layout == FloatingPointLayout::IEEE754_BINARY64,
        Datatype::FloatingPoint { size: 4, layout, .. } => *layout == FloatingPointLayout::IEEE754_BINARY32,
        _ => false,
    };
    if good {
        Ok(())
    } else {
        Err("its values are not IEEE floating-point numbers of 64 or 32 bits".to_owned())
    }
}

fn is_integer(datatype: &Datatype) -> Result<(), String> {
    let good = match datatype {
        Datatype::FixedPoint { size, layout, .. } => {
            let whole = layout.bit_offset == 0 && u32::from(layout.bit_precision) == size.saturating_mul(8);
            // An unsigned 64-bit number need not fit into the i64 that values are read as.
            whole && (matches!(size, 1 | 2 | 4) || (*size == 8 && layout.signed))
        }
        _ => false,
    };
    if good { Ok(()) } else { Err("its values are not integers of at most 64 bits with sign".to_owned()) }
}
