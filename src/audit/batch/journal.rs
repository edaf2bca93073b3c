//! Result lines (JSON Lines) that survive an interruption at any moment: none is lost once it was reported written, none is
//! there twice.
//!
//! A line is appended whole and flushed to the disk before anything rests on it. What a crash can leave behind is a torn
//! last line, without its line break; opening the file again removes it. The file is locked while it is open.

use std::collections::HashSet;
use std::fs::{File, OpenOptions};
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::manifest::Kind;

/// Why results could not be read or recorded.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JournalError {
    /// The system refused.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// The system's reason.
        source: io::Error,
    },
    /// There are results already.
    #[error("{0}: there are results already; --resume goes on with them")]
    Exists(String),
    /// Another process has the file open.
    #[error("{0}: another process is writing these results")]
    Locked(String),
    /// A whole line that is no result.
    #[error("{file}:{line}: no result line: {reason}")]
    Line {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The reason.
        reason: String,
    },
}

/// The result of one audit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResultLine {
    /// Hash of kind, name, options and contents of the files.
    pub key: String,
    /// What was audited.
    pub kind: Kind,
    /// Its name in the manifest.
    pub name: String,
    /// The files.
    pub files: Vec<String>,
    /// `bijective`, `not homeomorphic`, `not certified`, `invalid input`; `nested`, `not nested`; or `error`.
    pub verdict: String,
    /// The verdict in a sentence, or the error.
    pub summary: String,
    /// Where report and documents are, in the output directory; `null` for an error.
    pub directory: Option<String>,
    /// Size of all documents that prove something.
    pub document_bytes: usize,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// An open file of results.
#[derive(Debug)]
pub struct Journal {
    file: File,
    name: String,
    length: u64,
    keys: HashSet<String>,
    lines: Vec<ResultLine>,
}

impl Journal {
    /// Opens a file of results, or makes it. With `resume` results may be there, and a torn last line is removed.
    ///
    /// # Errors
    /// [`JournalError`].
    pub fn open(path: &Path, resume: bool) -> Result<Self, JournalError> {
        let name = path.display().to_string();
        let failed = |source| JournalError::Io { file: name.clone(), source };
        let mut file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(path)
            .map_err(failed)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(std::fs::TryLockError::WouldBlock) => return Err(JournalError::Locked(name)),
            Err(std::fs::TryLockError::Error(source)) => return Err(failed(source)),
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed)?;
        if !resume && !bytes.is_empty() {
            return Err(JournalError::Exists(name));
        }
        let whole = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
        let lines = parse(&name, bytes.get(..whole).unwrap_or(&[]))?;
        let length = whole as u64;
        file.set_len(length).and_then(|()| file.seek(SeekFrom::Start(length))).map_err(failed)?;
        file.sync_all().map_err(failed)?;
        // The entry in the directory, too, must survive.
        if let Some(directory) = path.parent().filter(|p| !p.as_os_str().is_empty()) {
            File::open(directory).and_then(|d| d.sync_all()).map_err(failed)?;
        }
        let keys = lines.iter().map(|l| l.key.clone()).collect();
        Ok(Self { file, name, length, keys, lines })
    }

    /// Is there a result with this key?
    #[must_use]
    pub fn has(&self, key: &str) -> bool {
        self.keys.contains(key)
    }

    /// All results, in the order of the file.
    #[must_use]
    pub fn lines(&self) -> &[ResultLine] {
        &self.lines
    }

    /// Records a result, unless there is one with its key; whether it did. When this returns, the line is on the disk.
    ///
    /// # Errors
    /// [`JournalError::Io`]; the file then is as before.
    pub fn record(&mut self, line: ResultLine) -> Result<bool, JournalError> {
        if self.has(&line.key) {
            return Ok(false);
        }
        let failed = |source| JournalError::Io { file: self.name.clone(), source };
        let mut bytes = serde_json::to_vec(&line).map_err(|e| failed(e.into()))?;
        bytes.push(b'\n');
        if let Err(source) = self.file.write_all(&bytes).and_then(|()| self.file.sync_data()) {
            // A part of the line may be there: the next line must not follow it.
            let _ = self.file.set_len(self.length);
            let _ = self.file.seek(SeekFrom::Start(self.length));
            return Err(failed(source));
        }
        self.length += bytes.len() as u64;
        self.keys.insert(line.key.clone());
        self.lines.push(line);
        Ok(true)
    }
}

fn parse(name: &str, bytes: &[u8]) -> Result<Vec<ResultLine>, JournalError> {
    let lines = bytes.split(|&b| b == b'\n').enumerate().filter(|(_, l)| !l.is_empty());
    lines
        .map(|(i, l)| {
            serde_json::from_slice(l).map_err(|e| JournalError::Line {
                file: name.to_owned(),
                line: i + 1,
                reason: e.to_string(),
            })
        })
        .collect()
}

/// The results in the bytes of a file, without a torn last line.
///
/// # Errors
/// [`JournalError::Line`].
pub fn read_lines(name: &str, bytes: &[u8]) -> Result<Vec<ResultLine>, JournalError> {
    let whole = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
    parse(name, bytes.get(..whole).unwrap_or(&[]))
}
