//! From datasets to a checked [`ShellFile`].

use super::source::{Source, Table};
use super::{MAX_FILE_BYTES, MetaEdge, Metadata, ReadError, Separation, ShellFile, Tracks};
use crate::mesh::TriMesh;
use crate::shell::Shell;
use std::io::Read;
use std::path::Path;

/// Reads a shell file; see the [module](super) for its layout.
///
/// # Errors
/// A [`ReadError`] naming the file, the dataset and the reason. The file is taken as untrusted:
/// memory stays proportional to its length.
pub fn read(path: &Path) -> Result<ShellFile, ReadError> {
    let file = path.display().to_string();
    let io = |source| ReadError::Io { file: file.clone(), source };
    let metadata = std::fs::metadata(path).map_err(io)?;
    if !metadata.is_file() {
        return Err(ReadError::NotAFile { file });
    }
    let mut bytes = Vec::new();
    let handle = std::fs::File::open(path).map_err(io)?;
    // The length may change while reading: the limit is on what is read, not on what was announced.
    handle.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes).map_err(io)?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(ReadError::TooLarge { file, bytes: metadata.len().max(bytes.len() as u64) });
    }
    parse(&file, bytes)
}

/// As [`read`], from bytes; `name` stands for the file in errors.
///
/// # Errors
/// As [`read`].
pub fn parse(name: &str, bytes: Vec<u8>) -> Result<ShellFile, ReadError> {
    let source = Source::open(name, bytes)?;
    let present = source.datasets()?;
    let file = FileParts { source, present };
    let shell = file.shell()?;
    let mesh = file.mesh()?;
    let tracks = file.tracks(&shell, mesh.as_ref())?;
    let meta_edges = file.meta_edges()?;
    let metadata = file.metadata()?;
    let mut parsed = ShellFile { shell, mesh, tracks, meta_edges, metadata, notes: Vec::new() };
    parsed.notes = notes(&parsed, &file.present);
    Ok(parsed)
}

const KNOWN: [&str; 11] = [
    "ref.V",
    "ref.F",
    "mbase",
    "mtop",
    "mV",
    "mF",
    "track_flat",
    "track_size",
    "meta_edges_flat",
    "meta_edges_ind",
    "metadata",
];

struct FileParts {
    source: Source,
    present: Vec<String>,
}

impl FileParts {
    fn has(&self, name: &str) -> bool {
        self.present.iter().any(|present| present == name)
    }

    /// Whether a pair of datasets is there: both or none.
    fn has_pair(&self, first: &str, second: &str) -> Result<bool, ReadError> {
        match (self.has(first), self.has(second)) {
            (true, true) => Ok(true),
            (false, false) => Ok(false),
            (true, false) => Err(self.source.error(second, format!("is missing, while {first} is there"))),
            (false, true) => Err(self.source.error(first, format!("is missing, while {second} is there"))),
        }
    }

    fn shell(&self) -> Result<Shell, ReadError> {
        for name in ["mbase", "mV", "mtop", "mF"] {
            if !self.has(name) {
                return Err(self.source.error(name, "is missing"));
            }
        }
        let middle = self.points("mV")?;
        let bottom = self.layer("mbase", middle.len())?;
        let top = self.layer("mtop", middle.len())?;
        let faces = self.triangles("mF", middle.len())?;
        Ok(Shell { bottom, middle, top, faces })
    }

    fn layer(&self, name: &str, count: usize) -> Result<Vec<[f64; 3]>, ReadError> {
        let points = self.points(name)?;
        if points.len() != count {
            let reason = format!("has {} points, while mV has {count}", points.len());
            return Err(self.source.error(name, reason));
        }
        Ok(points)
    }

    fn mesh(&self) -> Result<Option<TriMesh>, ReadError> {
        if !self.has_pair("ref.V", "ref.F")? {
            return Ok(None);
        }
        let vertices = self.points("ref.V")?;
        let faces = self.triangles("ref.F", vertices.len())?;
        Ok(Some(TriMesh { vertices, faces }))
    }

    fn tracks(&self, shell: &Shell, mesh: Option<&TriMesh>) -> Result<Option<Tracks>, ReadError> {
        if !self.has_pair("track_size", "track_flat")? {
            return Ok(None);
        }
        let sizes = self.indices("track_size", None)?;
        if sizes.len() != shell.faces.len() {
            let reason = format!("has {} entries, while there are {} prisms", sizes.len(), shell.faces.len());
            return Err(self.source.error("track_size", reason));
        }
        let flat = self.indices("track_flat", mesh.map(|mesh| mesh.faces.len()))?;
        let (total, count) = (sizes.iter().map(|&size| u64::from(size)).sum::<u64>(), flat.len());
        let tracks = Tracks::new(sizes, flat);
        let reason = || format!("has {count} entries, while track_size adds up to {total}");
        tracks.map(Some).ok_or_else(|| self.source.error("track_flat", reason()))
    }

    fn meta_edges(&self) -> Result<Option<Vec<MetaEdge>>, ReadError> {
        if !self.has_pair("meta_edges_ind", "meta_edges_flat")? {
            return Ok(None);
        }
        let flat = self.i32_list("meta_edges_flat")?;
        let mut edges = Vec::new();
        let mut rest = flat.as_slice();
        for (row, end) in self.indices("meta_edges_ind", None)?.into_iter().enumerate() {
            // A leading 0 is optional.
            if row == 0 && end == 0 {
                continue;
            }
            let start = flat.len() - rest.len();
            let record = (end as usize).checked_sub(start).and_then(|length| rest.split_at_checked(length));
            let Some(([v0, v1, curve, chain @ ..], tail)) = record else {
                let reason = format!(
                    "entry {row} ends at {end}: no record of three or more of the {} numbers",
                    flat.len()
                );
                return Err(self.source.error("meta_edges_ind", reason));
            };
            edges.push(MetaEdge { edge: [*v0, *v1], curve: *curve, chain: chain.to_vec() });
            rest = tail;
        }
        if rest.is_empty() {
            return Ok(Some(edges));
        }
        let reason = format!("has {} numbers after the last record that meta_edges_ind names", rest.len());
        Err(self.source.error("meta_edges_flat", reason))
    }

    fn metadata(&self) -> Result<Option<Metadata>, ReadError> {
        if !self.has("metadata") {
            return Ok(None);
        }
        match self.i32_list("metadata")?.as_slice() {
            &[version, code, pinched] => {
                Ok(Some(Metadata { version, separation: Separation::from_code(code), pinched }))
            }
            other => Err(self.source.error("metadata", format!("has {} entries instead of 3", other.len()))),
        }
    }

    /// An n x 3 dataset of finite coordinates.
    fn points(&self, name: &str) -> Result<Vec<[f64; 3]>, ReadError> {
        let rows = self.rows(name, &self.source.floats(name)?)?;
        let bad = rows.iter().position(|row| row.iter().any(|x| !x.is_finite()));
        match bad {
            Some(row) => Err(self.source.error(name, format!("row {row} is not finite: {:?}", rows[row]))),
            None => Ok(rows),
        }
    }

    /// An n x 3 dataset of indices below `limit`.
    fn triangles(&self, name: &str, limit: usize) -> Result<Vec<[u32; 3]>, ReadError> {
        let rows = self.rows(name, &self.source.integers(name)?)?;
        let convert = |(row, values): (usize, &[i64; 3])| {
            let mut face = [0; 3];
            for (slot, &value) in face.iter_mut().zip(values) {
                *slot = self.index(name, row, value, Some(limit))?;
            }
            Ok(face)
        };
        rows.iter().enumerate().map(convert).collect()
    }

    fn rows<T: Copy>(&self, name: &str, table: &Table<T>) -> Result<Vec<[T; 3]>, ReadError> {
        if !matches!(table.shape.as_slice(), [_, 3]) {
            let reason = format!("has shape {:?} instead of n x 3", table.shape);
            return Err(self.source.error(name, reason));
        }
        Ok(table.values.as_chunks::<3>().0.to_vec())
    }

    fn list(&self, name: &str) -> Result<Vec<i64>, ReadError> {
        let table = self.source.integers(name)?;
        if table.shape.len() != 1 {
            let reason = format!("has shape {:?} instead of one dimension", table.shape);
            return Err(self.source.error(name, reason));
        }
        Ok(table.values)
    }

    fn i32_list(&self, name: &str) -> Result<Vec<i32>, ReadError> {
        let convert = |(row, value): (usize, i64)| {
            i32::try_from(value).map_err(|_| {
                self.source.error(name, format!("entry {row} does not fit into 32 bits: {value}"))
            })
        };
        self.list(name)?.into_iter().enumerate().map(convert).collect()
    }

    fn indices(&self, name: &str, limit: Option<usize>) -> Result<Vec<u32>, ReadError> {
        let list = self.list(name)?.into_iter().enumerate();
        list.map(|(row, value)| self.index(name, row, value, limit)).collect()
    }

    fn index(&self, name: &str, row: usize, value: i64, limit: Option<usize>) -> Result<u32, ReadError> {
        match u32::try_from(value) {
            Ok(index) if limit.is_none_or(|limit| (index as usize) < limit) => Ok(index),
            _ if value < 0 => Err(self.source.error(name, format!("row {row}: {value} is negative"))),
            _ => {
                let limit = limit.unwrap_or(u32::MAX as usize);
                Err(self
                    .source
                    .error(name, format!("row {row}: {value} is out of range: at most {limit} exist")))
            }
        }
    }
}

fn notes(file: &ShellFile, present: &[String]) -> Vec<String> {
    let mut notes: Vec<String> = present
        .iter()
        .filter(|name| !KNOWN.contains(&name.as_str()))
        .map(|name| format!("dataset {name} is ignored"))
        .collect();
    if file.mesh.is_none() {
        notes.push("the file holds no mesh (ref.V, ref.F)".to_owned());
    }
    if let Some(metadata) = file.metadata {
        let pinched = file.shell.pinched_vertices().len();
        if usize::try_from(metadata.pinched) != Ok(pinched) {
            notes.push(format!(
                "metadata states {} pinched vertices, the data has {pinched}",
                metadata.pinched
            ));
        }
        if metadata.version != 1 {
            notes.push(format!("metadata states version {}; version 1 is known", metadata.version));
        }
        if let Separation::Other(code) = metadata.separation {
            notes.push(format!("metadata states type {code}; types 0, 1 and 2 are known"));
        }
    }
    notes
}
