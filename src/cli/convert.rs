//! `homeo convert`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::ValueEnum;

use super::CliError;
use super::input::{Loaded, ThreeMeshes};
use super::output::{self, one_line};
use crate::mesh::{self, Format, TriMesh};
use crate::shell::{hdf5, three, vtu};

/// Arguments of `homeo convert`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// IN OUT; or IN with --to-meshes; or OUT with --bottom, --middle and --top. What IN is, its content shows; what OUT
    /// shall be, its extension says: .obj .off .ply .stl (mesh), .h5 .hdf5 (shell), .vtu (shell, for ParaView). A shell
    /// converted to a mesh gives its stored mesh
    #[arg(required = true, num_args = 1..=2, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    three: ThreeMeshes,
    /// With --bottom, --middle and --top: the mesh to store in the shell file
    #[arg(long, value_name = "MESH", requires = "bottom")]
    mesh: Option<PathBuf>,
    /// Write PREFIX.bottom, PREFIX.middle, PREFIX.top (and PREFIX.mesh, if stored) as meshes
    #[arg(long, value_name = "PREFIX", conflicts_with = "bottom")]
    to_meshes: Option<PathBuf>,
    /// Mesh format to write; default: by extension (PLY and STL binary), OFF for --to-meshes
    #[arg(long, value_enum)]
    format: Option<MeshFormat>,
}

/// Mesh formats on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MeshFormat {
    Obj,
    Off,
    PlyAscii,
    Ply,
    PlyBe,
    StlAscii,
    Stl,
}

impl MeshFormat {
    const fn format(self) -> Format {
        match self {
            Self::Obj => Format::Obj,
            Self::Off => Format::Off,
            Self::PlyAscii => Format::PlyAscii,
            Self::Ply => Format::PlyBinaryLe,
            Self::PlyBe => Format::PlyBinaryBe,
            Self::StlAscii => Format::StlAscii,
            Self::Stl => Format::StlBinary,
        }
    }

    const fn extension(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Off => "off",
            Self::PlyAscii | Self::Ply | Self::PlyBe => "ply",
            Self::StlAscii | Self::Stl => "stl",
        }
    }
}

/// What a file of this name shall be.
enum Target {
    Mesh(Format),
    Shell,
    Vtu,
}

impl Target {
    fn of(path: &Path, format: Option<MeshFormat>) -> Result<Self, CliError> {
        if let Some(format) = format {
            return Ok(Self::Mesh(format.format()));
        }
        let extension = path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase);
        match extension.as_deref() {
            Some("h5" | "hdf5") => Ok(Self::Shell),
            Some("vtu") => Ok(Self::Vtu),
            _ => Format::from_extension(path).map(Self::Mesh).ok_or_else(|| CliError::Write {
                file: path.display().to_string(),
                reason: "the extension says no format; there are .obj .off .ply .stl .h5 .hdf5 .vtu"
                    .to_owned(),
            }),
        }
    }
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    let usage = |text: &str| Err(CliError::Usage(text.to_owned()));
    let said = match (args.files.as_slice(), &args.to_meshes, args.three.files()) {
        ([input], Some(prefix), _) => to_meshes(input, prefix, args.format)?,
        ([out], None, Some(_)) => {
            let loaded = Loaded::read(None, &args.three, args.mesh.as_deref())?;
            write_shell(&loaded, out, args.format)?
        }
        ([input, out], None, None) if is_hdf5(input)? => {
            write_shell(&Loaded::read(Some(input), &args.three, None)?, out, args.format)?
        }
        ([input, out], None, None) => mesh_to_mesh(input, out, args.format)?,
        (_, Some(_), _) => return usage("--to-meshes PREFIX goes with IN alone"),
        (_, None, Some(_)) => return usage("--bottom, --middle and --top go with OUT alone"),
        _ => return usage("give IN and OUT"),
    };
    output::print(&said)?;
    Ok(ExitCode::SUCCESS)
}

/// Does the file begin as HDF5 files do, or is it named like one?
fn is_hdf5(path: &Path) -> Result<bool, CliError> {
    use std::io::Read as _;
    let fail = |e: std::io::Error| CliError::Read { file: path.display().to_string(), reason: e.to_string() };
    if !std::fs::metadata(path).map_err(fail)?.is_file() {
        return Err(CliError::Read {
            file: path.display().to_string(),
            reason: "is not a regular file".to_owned(),
        });
    }
    let mut start = Vec::new();
    std::fs::File::open(path).and_then(|f| f.take(8).read_to_end(&mut start)).map_err(fail)?;
    let named = path
        .extension()
        .and_then(|e| e.to_str())
        .is_some_and(|e| ["h5", "hdf5", "init"].iter().any(|known| e.eq_ignore_ascii_case(known)));
    Ok(named || start == b"\x89HDF\r\n\x1a\n")
}

fn mesh_to_mesh(input: &Path, out: &Path, format: Option<MeshFormat>) -> Result<String, CliError> {
    output::may_write(out, &[input])?;
    let Target::Mesh(format) = Target::of(out, format)? else {
        return Err(CliError::Usage("one mesh is no shell: give --bottom, --middle and --top".to_owned()));
    };
    let read = mesh::read(input)?;
    mesh::write(out, &read.mesh, format)?;
    Ok(notes(&read.notes) + &wrote(out, &format.to_string()))
}

fn write_shell(loaded: &Loaded, out: &Path, format: Option<MeshFormat>) -> Result<String, CliError> {
    output::may_write(out, &loaded.inputs())?;
    let what = match Target::of(out, format)? {
        Target::Shell => {
            let bytes = hdf5::to_bytes(&loaded.file)
                .map_err(|source| CliError::Encode { file: out.display().to_string(), source })?;
            output::replace(out, &bytes)?;
            "shell, HDF5".to_owned()
        }
        Target::Vtu => {
            output::replace(out, &vtu::to_bytes(loaded.shell())?)?;
            "shell, VTU".to_owned()
        }
        Target::Mesh(format) => {
            mesh::write(out, stored_mesh(loaded)?, format)?;
            format!("the stored mesh, {format}")
        }
    };
    Ok(notes(&loaded.file.notes) + &wrote(out, &what))
}

fn stored_mesh(loaded: &Loaded) -> Result<&TriMesh, CliError> {
    loaded.mesh().ok_or_else(|| CliError::Read {
        file: loaded.shell_name(),
        reason: "there is no mesh (`ref.V`, `ref.F`) stored in it".to_owned(),
    })
}

fn to_meshes(input: &Path, prefix: &Path, format: Option<MeshFormat>) -> Result<String, CliError> {
    let format = format.unwrap_or(MeshFormat::Off);
    let loaded = Loaded::read(Some(input), &ThreeMeshes::default(), None)?;
    let [bottom, middle, top] = three::to_meshes(loaded.shell());
    let mut parts = vec![("bottom", &bottom), ("middle", &middle), ("top", &top)];
    parts.extend(loaded.mesh().map(|mesh| ("mesh", mesh)));
    let mut outputs = Vec::new();
    for (part, mesh) in parts {
        let mut name = prefix.as_os_str().to_owned();
        name.push(format!(".{part}.{}", format.extension()));
        let path = PathBuf::from(name);
        output::may_write(&path, &[input])?;
        let encoded = mesh::encode(mesh, format.format(), &path.to_string_lossy())?;
        outputs.push((path, encoded));
    }
    let mut said = notes(&loaded.file.notes);
    // All are encoded before the first is written.
    for (path, bytes) in &outputs {
        output::replace(path, bytes)?;
        said += &wrote(path, &format.format().to_string());
    }
    Ok(said)
}

fn notes(notes: &[String]) -> String {
    notes.iter().map(|note| format!("note: {}\n", one_line(note))).collect()
}

fn wrote(path: &Path, what: &str) -> String {
    format!("wrote {} ({what})\n", one_line(&path.display().to_string()))
}
