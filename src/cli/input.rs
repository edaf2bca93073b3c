//! Reading shells, meshes and vertex orders from files.

use std::path::{Path, PathBuf};

use clap::Args;

use super::CliError;
use super::output::one_line;
use crate::certify::VertexOrder;
use crate::mesh::{self, TriMesh};
use crate::shell::{Shell, hdf5, three};

/// A shell as three meshes of one connectivity.
#[derive(Clone, Debug, Default, Args)]
pub(super) struct ThreeMeshes {
    /// Bottom surface of the shell, in place of SHELL (needs --middle and --top)
    #[arg(long, value_name = "MESH", requires = "middle", requires = "top")]
    pub(super) bottom: Option<PathBuf>,
    /// Middle surface of the shell
    #[arg(long, value_name = "MESH", requires = "bottom", requires = "top")]
    pub(super) middle: Option<PathBuf>,
    /// Top surface of the shell
    #[arg(long, value_name = "MESH", requires = "bottom", requires = "middle")]
    pub(super) top: Option<PathBuf>,
}

impl ThreeMeshes {
    /// The three files, if given.
    pub(super) fn files(&self) -> Option<[&Path; 3]> {
        Some([self.bottom.as_deref()?, self.middle.as_deref()?, self.top.as_deref()?])
    }
}

/// A shell, perhaps with a mesh, and where they come from.
pub(super) struct Loaded {
    pub(super) file: hdf5::ShellFile,
    /// What the shell was read from: one file or three.
    pub(super) shell_files: Vec<PathBuf>,
    /// The mesh's own file; `None` if it is stored in the shell file (or there is none).
    pub(super) mesh_file: Option<PathBuf>,
}

impl Loaded {
    /// Reads a shell from an HDF5 file or from three meshes, and a mesh from a file of its own if one is given.
    pub(super) fn read(
        shell: Option<&Path>,
        three: &ThreeMeshes,
        mesh: Option<&Path>,
    ) -> Result<Self, CliError> {
        let (mut file, shell_files) = match (shell, three.files()) {
            (Some(_), Some(_)) => {
                return Err(CliError::Usage("give either a shell file or three meshes, not both".to_owned()));
            }
            (None, None) => {
                return Err(CliError::Usage(
                    "no shell: give a shell file, or --bottom, --middle and --top".to_owned(),
                ));
            }
            (Some(path), None) => (hdf5::read(path)?, vec![path.to_owned()]),
            (None, Some(paths)) => (from_three(paths)?, paths.map(Path::to_owned).to_vec()),
        };
        if let Some(path) = mesh {
            let read = mesh::read(path)?;
            file.notes.extend(read.notes.into_iter().map(|note| format!("{}: {note}", path.display())));
            file.mesh = Some(read.mesh);
        }
        Ok(Self { file, shell_files, mesh_file: mesh.map(Path::to_owned) })
    }

    pub(super) fn shell(&self) -> &Shell {
        &self.file.shell
    }

    pub(super) fn mesh(&self) -> Option<&TriMesh> {
        self.file.mesh.as_ref()
    }

    /// All input files, in the order in which a checker wants them.
    pub(super) fn inputs(&self) -> Vec<&Path> {
        self.shell_files.iter().chain(&self.mesh_file).map(PathBuf::as_path).collect()
    }

    /// The shell's file or files, for messages.
    pub(super) fn shell_name(&self) -> String {
        let names: Vec<String> =
            self.shell_files.iter().map(|f| one_line(&f.display().to_string())).collect();
        names.join(", ")
    }

    /// The mesh's file, for messages.
    pub(super) fn mesh_name(&self) -> String {
        let path = self.mesh_file.as_ref().or(self.shell_files.first());
        path.map_or_else(String::new, |p| one_line(&p.display().to_string()))
    }
}

fn from_three(paths: [&Path; 3]) -> Result<hdf5::ShellFile, CliError> {
    let mut notes = Vec::new();
    let mut read = |path: &Path| -> Result<TriMesh, CliError> {
        let file = mesh::read(path)?;
        notes.extend(file.notes.into_iter().map(|note| format!("{}: {note}", path.display())));
        Ok(file.mesh)
    };
    let [bottom, middle, top] = paths;
    let (b, m, t) = (read(bottom)?, read(middle)?, read(top)?);
    let shell = three::from_meshes(b, m, t).map_err(|source| {
        let files = paths.map(|p| p.display().to_string()).join(", ");
        CliError::Three { files, source }
    })?;
    Ok(hdf5::ShellFile { shell, notes, ..hdf5::ShellFile::default() })
}

/// `id`, or a file of all vertex ids, smallest first, separated by white space.
pub(super) fn order(argument: &str, vertices: usize) -> Result<VertexOrder, CliError> {
    if argument == "id" {
        return Ok(VertexOrder::Id);
    }
    let path = Path::new(argument);
    let fail = |reason: String| CliError::Read { file: argument.to_owned(), reason };
    let bytes = read_regular(path)?;
    let mut list = Vec::new();
    for (line, text) in (1_usize..).zip(bytes.split(|&b| b == b'\n')) {
        for token in text.split(u8::is_ascii_whitespace).filter(|t| !t.is_empty()) {
            let id =
                std::str::from_utf8(token).ok().and_then(|t| t.parse::<u32>().ok()).ok_or_else(|| {
                    let shown: String = String::from_utf8_lossy(token).chars().take(40).collect();
                    fail(format!("line {line}: `{shown}` is no vertex id"))
                })?;
            list.push(id);
        }
    }
    VertexOrder::from_list(list, vertices).map_err(|e| fail(e.to_string()))
}

/// The bytes of a regular file.
pub(super) fn read_regular(path: &Path) -> Result<Vec<u8>, CliError> {
    is_regular(path)?;
    std::fs::read(path).map_err(|e| unread(path, e.to_string()))
}

/// Refuses devices and pipes: they need not end.
pub(super) fn is_regular(path: &Path) -> Result<(), CliError> {
    let there = std::fs::metadata(path).map_err(|e| unread(path, e.to_string()))?;
    if there.is_file() { Ok(()) } else { Err(unread(path, "is not a regular file".to_owned())) }
}

fn unread(path: &Path, reason: String) -> CliError {
    CliError::Read { file: path.display().to_string(), reason }
}
