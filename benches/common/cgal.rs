//! The CGAL programs of `reference/cgal`, run on files that this module writes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use homeo::mesh::{self, Format, MeshError, TriMesh};
use homeo::shell::{Shell, three};

/// Why a CGAL program gave no answer.
#[derive(Debug, thiserror::Error)]
pub enum CgalError {
    /// The files for it could not be written.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The program or a folder is not there.
    #[error("{what}: {source}")]
    Io {
        /// What was tried.
        what: String,
        /// The system's reason.
        source: std::io::Error,
    },
    /// It ended with an error.
    #[error("{program} failed: {text}")]
    Failed {
        /// The program.
        program: String,
        /// What it says.
        text: String,
    },
    /// Its answer lacks a number.
    #[error("{program} does not state {key}: {text}")]
    Answer {
        /// The program.
        program: String,
        /// The missing key.
        key: String,
        /// What it says.
        text: String,
    },
}

/// A shell, and a mesh if there is one, as OFF files that go away with this value.
#[derive(Debug)]
pub struct Files {
    _folder: tempfile::TempDir,
    /// Bottom, middle, top, then the mesh.
    pub paths: Vec<PathBuf>,
}

impl Files {
    /// Writes the files.
    ///
    /// # Errors
    /// The file system refuses, or the shell is no writable mesh.
    pub fn new(shell: &Shell, mesh: Option<&TriMesh>) -> Result<Self, CgalError> {
        let folder = tempfile::tempdir()
            .map_err(|source| CgalError::Io { what: "a temporary folder".to_owned(), source })?;
        let mut paths = Vec::new();
        let layers = three::to_meshes(shell);
        for (name, part) in ["bottom", "middle", "top", "mesh"].into_iter().zip(layers.iter().chain(mesh)) {
            let path = folder.path().join(name).with_extension("off");
            mesh::write(&path, part, Format::Off)?;
            paths.push(path);
        }
        Ok(Self { _folder: folder, paths })
    }
}

/// The folder with the built programs.
#[derive(Clone, Debug)]
pub struct Cgal(pub PathBuf);

/// `key=value` answers of a program.
#[derive(Clone, Debug)]
pub struct Answer {
    program: String,
    text: String,
    values: BTreeMap<String, String>,
}

impl Answer {
    /// The pairs in what a program says.
    #[must_use]
    pub fn parse(program: &str, text: &str) -> Self {
        let pair = |word: &str| word.split_once('=').map(|(k, v)| (k.to_owned(), v.to_owned()));
        let values = text.split_whitespace().filter_map(pair).collect();
        Self { program: program.to_owned(), text: text.to_owned(), values }
    }

    /// The number of this key.
    ///
    /// # Errors
    /// The program did not state it.
    pub fn get<T: std::str::FromStr>(&self, key: &str) -> Result<T, CgalError> {
        self.values.get(key).and_then(|v| v.parse().ok()).ok_or_else(|| CgalError::Answer {
            program: self.program.clone(),
            key: key.to_owned(),
            text: self.text.clone(),
        })
    }
}

impl Cgal {
    /// Builds the programs, and further targets, by `reference/build.sh`; `None`, after the reason on stderr, where that
    /// cannot be done.
    #[must_use]
    pub fn build(targets: &[&str]) -> Option<Self> {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../reference/build.sh");
        let output = Command::new("sh")
            .arg(script)
            .args(targets)
            .stderr(std::process::Stdio::inherit())
            .output()
            .ok()?;
        let folder = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        (output.status.success() && !folder.is_empty()).then(|| Self(PathBuf::from(folder)))
    }

    /// Runs a program.
    ///
    /// # Errors
    /// It cannot be started, or ends with an error.
    pub fn run(&self, program: &str, options: &[&str], files: &[PathBuf]) -> Result<Answer, CgalError> {
        let output = Command::new(self.0.join(program))
            .args(options)
            .args(files)
            .output()
            .map_err(|source| CgalError::Io { what: program.to_owned(), source })?;
        let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        if !output.status.success() {
            let text = String::from_utf8_lossy(&output.stderr).trim().to_owned();
            return Err(CgalError::Failed { program: program.to_owned(), text });
        }
        Ok(Answer::parse(program, &text))
    }
}
