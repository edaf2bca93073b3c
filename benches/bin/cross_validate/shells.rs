//! Counts about whole shells: tets, tets that are not positive, self-intersecting pairs of the mesh, pairs of the mesh with
//! bottom and top, and contacts that break I2.
//!
//! Of every real shell file; and, because these are nearly all valid, of shells that are far too thick, generated
//! around real surfaces, one of which intersects itself, and of solids and coarse spheres whose edges the shell turns around
//! without beveling: every column has numbers other than 0 there.

use std::error::Error;
use std::path::Path;

use homeo::certify::{Claim, ClaimResult, Options, Outcome, Silent, certify};
use homeo::mesh::{self, TriMesh};
use homeo::shell::{Shell, hdf5};
use homeo_benches::cgal::{Cgal, Files};
use homeo_benches::generate::{offset_shell, sphere};
use homeo_benches::real;
use homeo_benches::table::Table;

use crate::findings::Findings;

/// What both sides count; `None` where homeo does not come to it, because a claim before is refuted.
type Counts = [Option<u64>; 6];

const NAMES: [&str; 6] =
    ["tets", "not positive", "mesh x mesh", "mesh x bottom", "mesh x top", "I2 contacts"];

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

fn thick_shell(name: &str) -> Result<Input, Box<dyn Error>> {
    let mesh = mesh::read(&real::data().join("surface").join(name))?.mesh;
    Ok(Input {
        name: format!("thick shell around {name}"),
        shell: offset_shell(&mesh, 1.0),
        mesh: Some(mesh),
    })
}

/// A solid as its own middle surface, between copies a quarter smaller and larger: at an edge or a vertex the tets of one face
/// touch the next face, with a negative dot where the solid is sharp.
fn solid(name: &str, vertices: &[[f64; 3]], faces: &[[u32; 3]]) -> Input {
    let layer = |factor: f64| vertices.iter().map(|p| p.map(|x| x * factor)).collect::<Vec<_>>();
    let shell = Shell { bottom: layer(0.75), middle: layer(1.0), top: layer(1.25), faces: faces.to_vec() };
    let mesh = TriMesh { vertices: layer(1.0), faces: faces.to_vec() };
    Input { name: name.to_owned(), shell, mesh: Some(mesh) }
}

/// Shells without the data: the solids, and coarse spheres in shells of several thicknesses.
fn generated() -> Vec<Input> {
    let tetrahedron = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let spindle = [[2.0, 0.0, 0.0], [-1.0, 2.0, 0.0], [-1.0, -2.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let sides = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
    let mut pinched = solid("spindle, a tip pinched", &spindle, &sides);
    pinched.shell.bottom[3] = spindle[3];
    pinched.shell.top[3] = spindle[3];
    let spheres =
        [(1, 0.1), (1, 0.4), (2, 0.1), (2, 0.3), (3, 0.5), (4, 0.5)].map(|(frequency, thickness)| {
            let mesh = sphere(frequency);
            let shell = offset_shell(&mesh, thickness);
            Input { name: format!("sphere of {} triangles", mesh.faces.len()), shell, mesh: Some(mesh) }
        });
    let mut out = vec![
        solid("tetrahedron", &tetrahedron, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]),
        solid("spindle", &spindle, &sides),
        pinched,
    ];
    out.extend(spheres);
    out
}

/// Compares all shells and prints the table.
pub(crate) fn run(cgal: &Cgal, findings: &mut Findings) -> Result<(), Box<dyn Error>> {
    let mut table = Table::new(&[&["shell", "prisms"], &NAMES[..], &["agree"]].concat());
    let shells = real::shells();
    if shells.is_empty() {
        eprintln!("SKIPPED: no shell files in {}", real::data().display());
    }
    let thick = if shells.is_empty() { &SURFACES[..0] } else { &SURFACES[..] };
    let inputs = shells.iter().map(|p| stored(p)).chain(thick.iter().map(|name| thick_shell(name)));
    for input in inputs.chain(generated().into_iter().map(Ok)) {
        let input = input?;
        let (ours, theirs) = one(&input, cgal).map_err(|error| format!("{}: {error}", input.name))?;
        let agree = ours.iter().zip(&theirs).all(|(a, b)| a.is_none() || a == b);
        let show = |(a, b): (Option<u64>, Option<u64>)| match (a, b) {
            (None, _) => "-".to_owned(),
            (Some(a), Some(b)) if a == b => a.to_string(),
            (Some(a), b) => format!("{a} CGAL {}", b.map_or_else(|| "-".to_owned(), |b| b.to_string())),
        };
        let mut row = vec![input.name, input.shell.faces.len().to_string()];
        row.extend(ours.into_iter().zip(theirs).map(show));
        row.push(if agree { "yes" } else { "NO" }.to_owned());
        if !agree {
            findings.add(&row.join(" | "));
        }
        table.row(row);
    }
    print!("{}", table.render());
    Ok(())
}

/// homeo's counts and CGAL's.
fn one(input: &Input, cgal: &Cgal) -> Result<(Counts, Counts), Box<dyn Error>> {
    let Input { shell, mesh, .. } = input;
    let files = Files::new(shell, mesh.as_ref())?;
    let layers = files.paths.get(..3).ok_or("no layers")?;
    let c1 = cgal.run("c1", &[], layers)?;
    let exact = cgal.run("c1", &["--epeck"], layers)?;
    let [fast, exact] = [&c1, &exact].map(|answer| answer.get::<u64>("not_positive"));
    let (fast, exact) = (fast?, exact?);
    // No count at all agrees with nothing.
    let bad = (fast == exact).then_some(fast);
    let mut theirs = [Some(c1.get("tets")?), bad, None, None, None, None];
    let mut claims = vec![Claim::Positivity];
    if mesh.is_some() {
        let checks = cgal.run("checks", &[], &files.paths)?;
        for (slot, key) in theirs[2..].iter_mut().zip(["self", "bottom", "top"]) {
            *slot = Some(checks.get(key)?);
        }
        claims.extend([Claim::Disjoint, Claim::I2]);
    }
    let outcome = certify(shell, mesh.as_ref(), &Options { claims, ..Options::default() }, &Silent)?;
    let ours = counts(&outcome, shell)?;
    if ours[5].is_some() {
        theirs[5] = Some(cgal.run("contacts", &[], &files.paths)?.get("contacts")?);
    }
    Ok((ours, theirs))
}

fn counts(outcome: &Outcome, shell: &Shell) -> Result<Counts, Box<dyn Error>> {
    let mut out = [Some(shell.tet_count() as u64), None, None, None, None, None];
    for claim in &outcome.claims {
        match claim.claim {
            Claim::Positivity => out[1] = Some(bad(claim, shell)?),
            Claim::Disjoint => {
                for (slot, part) in out[2..].iter_mut().zip(&claim.parts) {
                    *slot = Some(part.crossings);
                }
            }
            Claim::I2 => out[5] = claim.counts.iter().find(|c| c.what == "contacts").map(|c| c.count),
            _ => {}
        }
    }
    Ok(out)
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
