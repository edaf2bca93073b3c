//! The two position sets of `homeo map`.

use std::path::{Path, PathBuf};

use super::CliError;
use crate::mesh::{self, Complex, ComplexFile, Format, Positions, Space};

/// One complex, or two that are to have the same cells.
pub(super) struct Pair {
    pub(super) complexes: Vec<Complex>,
    /// The file of each.
    pub(super) files: Vec<PathBuf>,
    /// What the positions of each are called.
    pub(super) positions: Vec<String>,
    pub(super) notes: Vec<String>,
}

/// The name of the positions that every file has.
const VERTICES: &str = "vertices";
/// Names that expansion-cones gives to the exact positions of the image and of the domain.
const IMAGE: &str = "str_exact_position";
const DOMAIN: &str = "str_domain_exact_position";

/// Reads one file with two position sets, or two files.
pub(super) fn read(files: &[PathBuf], names: [Option<&str>; 2], cut: bool) -> Result<Pair, CliError> {
    match files {
        [file] if is_obj(file) => uv(file, cut),
        [file] => one(file, names),
        [a, b] if !cut => two(a, b, names),
        _ => Err(CliError::Usage("--cut goes with one OBJ file".to_owned())),
    }
}

/// Reads one surface.
pub(super) fn surface(files: &[PathBuf]) -> Result<Pair, CliError> {
    let [file] = files else {
        return Err(CliError::Usage("--embedded goes with one surface".to_owned()));
    };
    let read = mesh::read(file)?;
    let positions = vec![VERTICES.to_owned()];
    Ok(Pair { complexes: vec![read.mesh.into()], files: vec![file.clone()], positions, notes: read.notes })
}

fn is_obj(path: &Path) -> bool {
    Format::from_extension(path) == Some(Format::Obj)
}

fn uv(file: &Path, cut: bool) -> Result<Pair, CliError> {
    let read = mesh::read_uv(file)?;
    let complexes = if cut { read.cut() } else { read.whole() };
    let complexes = complexes.map_err(|source| CliError::Uv { file: file.display().to_string(), source })?;
    let files = vec![file.to_owned(); 2];
    let positions = vec!["v".to_owned(), "vt".to_owned()];
    Ok(Pair { complexes: complexes.into(), files, positions, notes: read.notes })
}

/// The complex with the positions of this name.
fn select(file: &ComplexFile, path: &Path, name: &str) -> Result<Complex, CliError> {
    let mut complex = file.complex.clone();
    if name != VERTICES {
        let points = file.exact(name).ok_or_else(|| {
            let known: Vec<&str> = file.exact.iter().map(|(n, _)| n.as_str()).collect();
            let reason = format!("there are no positions `{name}`; there are: vertices {}", known.join(" "));
            CliError::Read { file: path.display().to_string(), reason }
        })?;
        complex.positions = Positions::Exact(points.to_vec());
        complex.space = Space::Space;
    }
    Ok(complex)
}

fn one(path: &Path, names: [Option<&str>; 2]) -> Result<Pair, CliError> {
    let file = mesh::read_complex(path)?;
    let domain = if file.exact(DOMAIN).is_some() { DOMAIN } else { VERTICES };
    let positions = [names[0].unwrap_or(domain), names[1].unwrap_or(IMAGE)];
    let [a, b] = positions.map(|name| select(&file, path, name));
    let positions = positions.map(ToOwned::to_owned).into();
    Ok(Pair { complexes: vec![a?, b?], files: vec![path.to_owned(); 2], positions, notes: file.notes })
}

/// The exact positions of the image, if the file has them.
fn default(file: &ComplexFile) -> &'static str {
    if file.exact(IMAGE).is_some() { IMAGE } else { VERTICES }
}

fn two(a: &Path, b: &Path, names: [Option<&str>; 2]) -> Result<Pair, CliError> {
    let first = mesh::read_complex(a)?;
    let a_name = names[0].unwrap_or_else(|| default(&first));
    let complex = select(&first, a, a_name)?;
    let mut notes = first.notes;
    let is_text = b.extension().is_some_and(|e| e.eq_ignore_ascii_case("txt"));
    let (second, b_name) = if is_text && names[1].is_none() {
        let points = mesh::read_rational(b)?;
        let positions = Positions::Exact(points);
        (Complex { space: Space::Space, positions, cells: complex.cells.clone() }, "rational numbers")
    } else {
        let file = mesh::read_complex(b)?;
        let name = names[1].unwrap_or_else(|| default(&file));
        let second = select(&file, b, name)?;
        notes.extend(file.notes);
        (second, name)
    };
    let positions = [a_name, b_name].map(ToOwned::to_owned).into();
    let files = vec![a.to_owned(), b.to_owned()];
    Ok(Pair { complexes: vec![complex, second], files, positions, notes })
}
