//! Compares homeo's counts with CGAL's: tets, tets that are not positive, self-intersecting pairs of the mesh, and pairs
//! of the mesh with bottom and top. Exit 1 on any difference, 2 on an error.
//!
//! On every real shell file; and, because these are nearly all valid, on shells that are far too thick, generated
//! around real surfaces, one of which intersects itself: every column has numbers other than 0 there.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use homeo::certify::{Claim, ClaimResult, Options, Silent, certify};
use homeo::mesh::{self, TriMesh};
use homeo::shell::{Shell, hdf5};
use homeo_benches::cgal::{Cgal, Files};
use homeo_benches::generate::offset_shell;
use homeo_benches::real;
use homeo_benches::table::Table;

/// What both sides count: tets, not positive, self, bottom, top.
type Counts = [u64; 5];

const NAMES: [&str; 5] = ["tets", "not positive", "mesh x mesh", "mesh x bottom", "mesh x top"];

fn main() -> ExitCode {
    let shells = real::shells();
    if shells.is_empty() {
        eprintln!("SKIPPED: no shell files in {}", real::data().display());
        return ExitCode::SUCCESS;
    }
    let Some(cgal) = Cgal::build() else {
        eprintln!("SKIPPED: no CGAL");
        return ExitCode::SUCCESS;
    };
    match compare(&shells, &cgal) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// A shell, its mesh and a name.
struct Input {
    name: String,
    shell: Shell,
    mesh: Option<TriMesh>,
}

/// Surfaces to put shells around that are as thick as these edges are long.
const SURFACES: [&str; 4] = ["gargo_1000.off", "anchor.off", "dino.off", "camel.off"];

fn stored(path: &Path) -> Result<Input, Box<dyn Error>> {
    let file = hdf5::read(path)?;
    Ok(Input { name: real::name(path), shell: file.shell, mesh: file.mesh })
}

fn thick(name: &str) -> Result<Input, Box<dyn Error>> {
    let mesh = mesh::read(&real::data().join("surface").join(name))?.mesh;
    Ok(Input {
        name: format!("thick shell around {name}"),
        shell: offset_shell(&mesh, 1.0),
        mesh: Some(mesh),
    })
}

/// Prints the table; whether all agree.
fn compare(shells: &[PathBuf], cgal: &Cgal) -> Result<bool, Box<dyn Error>> {
    let mut table =
        Table::new(&["shell", "prisms", NAMES[0], NAMES[1], NAMES[2], NAMES[3], NAMES[4], "agree"]);
    let mut agree = true;
    let inputs = shells.iter().map(|p| stored(p)).chain(SURFACES.into_iter().map(thick));
    for input in inputs {
        let input = input?;
        let (ours, theirs) = one(&input, cgal).map_err(|error| format!("{}: {error}", input.name))?;
        agree &= ours == theirs;
        let show = |(a, b): (u64, u64)| if a == b { a.to_string() } else { format!("{a} CGAL {b}") };
        let mut row = vec![input.name, input.shell.faces.len().to_string()];
        row.extend(ours.into_iter().zip(theirs).map(show));
        row.push(if ours == theirs { "yes" } else { "NO" }.to_owned());
        table.row(row);
    }
    print!("{}", table.render());
    Ok(agree)
}

/// homeo's counts and CGAL's.
fn one(input: &Input, cgal: &Cgal) -> Result<(Counts, Counts), Box<dyn Error>> {
    let Input { shell, mesh, .. } = input;
    let files = Files::new(shell, mesh.as_ref())?;
    let layers = files.paths.get(..3).ok_or("no layers")?;
    let c1 = cgal.run("c1", &[], layers)?;
    let exact = cgal.run("c1", &["--epeck"], layers)?;
    if c1.get::<u64>("not_positive")? != exact.get::<u64>("not_positive")? {
        return Err("CGAL's EPICK and EPECK differ".into());
    }
    let checks = cgal.run("checks", &[], &files.paths)?;
    let theirs = [
        c1.get("tets")?,
        c1.get("not_positive")?,
        checks.get("self")?,
        checks.get("bottom")?,
        checks.get("top")?,
    ];
    let options = Options { claims: vec![Claim::Positivity, Claim::Disjoint], ..Options::default() };
    let outcome = certify(shell, mesh.as_ref(), &options, &Silent)?;
    let mut ours = [shell.tet_count() as u64, 0, 0, 0, 0];
    for claim in &outcome.claims {
        match claim.claim {
            Claim::Positivity => ours[1] = bad(claim, shell)?,
            Claim::Disjoint => {
                for (slot, part) in ours[2..].iter_mut().zip(&claim.parts) {
                    *slot = part.crossings;
                }
            }
            _ => {}
        }
    }
    Ok((ours, theirs))
}

/// The certifier's number of tets that are not positive. It counts different tets; with a pinched vertex the table
/// names some tets twice, so there only a zero can be compared.
fn bad(claim: &ClaimResult, shell: &Shell) -> Result<u64, Box<dyn Error>> {
    let count = |what: &str| claim.counts.iter().find(|c| c.what == what).map(|c| c.count);
    let bad = count("tets_not_positive").ok_or("the certifier states no count of tets")?;
    if bad > 0 && !shell.pinched_vertices().is_empty() {
        return Err("tets that are not positive beside a pinched vertex: not comparable".into());
    }
    Ok(bad)
}
