//! Self-intersections of every triangle mesh of the data: pairs of triangles, by homeo, by CGAL's predicates, and by its
//! `self_intersections` and `does_self_intersect`.

use std::error::Error;
use std::path::{Path, PathBuf};

use homeo::certify::{Silent, self_intersections};
use homeo::mesh::{self, DefectKind, Format};
use homeo_benches::cgal::Cgal;
use homeo_benches::real;
use homeo_benches::table::Table;

use crate::findings::Findings;

/// Where triangle meshes are.
const FOLDERS: [&str; 4] = ["surface", "pairs", "thirdparty/cages", "thirdparty/shells"];
/// Other files there.
const OTHER: [&str; 5] = ["md", "h5", "init", "log", "txt"];

fn files() -> Vec<PathBuf> {
    let mut out: Vec<PathBuf> = FOLDERS
        .into_iter()
        .filter_map(|folder| std::fs::read_dir(real::data().join(folder)).ok())
        .flat_map(|entries| entries.flatten().map(|entry| entry.path()))
        .filter(|path| path.is_file() && path.extension().is_some_and(|e| OTHER.iter().all(|o| e != *o)))
        .collect();
    out.sort();
    out
}

/// Compares all meshes and prints the table.
pub(crate) fn run(cgal: &Cgal, findings: &mut Findings) -> Result<(), Box<dyn Error>> {
    let files = files();
    if files.is_empty() {
        eprintln!("SKIPPED: no meshes in {}", real::data().display());
        return Ok(());
    }
    let header =
        ["mesh", "triangles", "flat", "doubled", "crossing pairs", "PMP pairs", "PMP crosses", "agree"];
    let mut table = Table::new(&header);
    for path in &files {
        one(path, cgal, &mut table, findings).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    print!("{}", table.render());
    Ok(())
}

fn one(path: &Path, cgal: &Cgal, table: &mut Table, findings: &mut Findings) -> Result<(), Box<dyn Error>> {
    let mesh = mesh::read(path)?.mesh;
    let folder = tempfile::tempdir()?;
    let copy = folder.path().join("mesh.off");
    mesh::write(&copy, &mesh, Format::Off)?;
    let theirs = cgal.run("embedded", &[], &[copy])?;
    let mut row = vec![real::name(path), mesh.faces.len().to_string()];
    let defects = mesh::validate(&mesh)?.info.defects;
    let of = |kind| defects.iter().filter(|(k, _)| *k == kind).map(|(_, n)| n).sum::<u64>();
    let flat = of(DefectKind::ZeroArea) + of(DefectKind::RepeatedCorner);
    let mut agree = flat == theirs.get::<u64>("flat")?;
    row.push(flat.to_string());
    if flat == 0 {
        let doubled = of(DefectKind::DuplicateFace);
        agree &= doubled == theirs.get::<u64>("doubled")?;
        row.push(doubled.to_string());
        let ours = i64::try_from(self_intersections(&mesh, &Silent)?.len())?;
        let [pairs, pmp, does] = ["pairs", "pmp", "does"].map(|key| theirs.get::<i64>(key));
        let (pairs, pmp, does) = (pairs?, pmp?, does?);
        // PMP takes no mesh that is not a manifold.
        agree &= ours == pairs && (pmp < 0 || (ours == pmp && i64::from(ours > 0) == does));
        let number = |n: i64| if n < 0 { "not a manifold".to_owned() } else { n.to_string() };
        row.push(if ours == pairs { ours.to_string() } else { format!("{ours} CGAL {pairs}") });
        row.extend([number(pmp), number(does)]);
    } else {
        // Neither side has a meaning for such triangles.
        row.extend(["-"; 4].map(str::to_owned));
    }
    row.push(if agree { "yes" } else { "NO" }.to_owned());
    if !agree {
        findings.add(&row.join(" | "));
    }
    table.row(row);
    Ok(())
}
