//! Build, optimise and certify a shell around a mesh:
//! `cargo run --release --example build_shell -- mesh.off [--thickness 0.05] [--angle 89.94] [-o shell.h5] [--compare other.h5]`.

use std::path::Path;
use std::time::Instant;

use homeo::certify::{Options, Silent, certify};
use homeo::construct::{InitialOptions, OptimiseOptions, Thickness, initial, optimise, optimise_joint};
use homeo::mesh;
use homeo::shell::Shell;
use homeo::shell::hdf5::{self, ShellFile};

/// Smallest and mean length of the halves, as shares of `unit`; pinched vertices are left out.
fn thickness(shell: &Shell, unit: f64) -> [f64; 2] {
    let length =
        |p: &[f64; 3], q: &[f64; 3]| (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt() / unit;
    let halves: Vec<f64> = (0..shell.middle.len())
        .filter(|&v| !shell.is_pinched(u32::try_from(v).unwrap_or(u32::MAX)))
        .flat_map(|v| [length(&shell.bottom[v], &shell.middle[v]), length(&shell.top[v], &shell.middle[v])])
        .collect();
    [halves.iter().copied().fold(f64::INFINITY, f64::min), halves.iter().sum::<f64>() / halves.len() as f64]
}

fn longest_box_edge(points: &[[f64; 3]]) -> f64 {
    let extent = |i: usize| {
        let x = || points.iter().map(|p| p[i]);
        x().fold(f64::NEG_INFINITY, f64::max) - x().fold(f64::INFINITY, f64::min)
    };
    (0..3).map(extent).fold(0.0, f64::max)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let option = |name: &str| args.iter().position(|a| a == name).and_then(|i| args.get(i + 1));
    let path = args.first().ok_or(
        "usage: build_shell MESH [--thickness T] [--angle DEGREES] [--polish N] [--seed N] [-o FILE.h5]",
    )?;
    let thick = Thickness::Share(option("--thickness").map_or(Ok(0.05), |t| t.parse())?);
    let angle = option("--angle").map_or(Ok(0.001f64.acos().to_degrees()), |t| t.parse())?;
    let polish = option("--polish").map_or(Ok(20), |t| t.parse())?;
    let seed = option("--seed").map_or(Ok(0), |t| t.parse())?;
    let mesh = mesh::read(Path::new(path))?.mesh;
    let start = Instant::now();
    let first = initial(&mesh, &InitialOptions { thickness: thick, ..InitialOptions::default() }, &Silent)?;
    let middle = start.elapsed().as_secs_f64();
    let options = OptimiseOptions {
        thickness: thick,
        max_angle_degrees: angle,
        polish,
        seed,
        ..OptimiseOptions::default()
    };
    let partner = option("--partner").map(|p| mesh::read(Path::new(p))).transpose()?.map(|m| m.mesh);
    let built = match &partner {
        Some(partner) => optimise_joint(&mesh, partner, &first.shell, &options, &Silent)?,
        None => optimise(&mesh, &first.shell, &options, &Silent)?,
    };
    let seconds = start.elapsed().as_secs_f64();
    let [min, mean] = thickness(&built.shell, longest_box_edge(&mesh.vertices));
    println!(
        "{path}: {} triangles, {} initial prisms, {} prisms, {middle:.2} s + optimisation = {seconds:.2} s, thickness min \
         {min:.5} mean {mean:.5}, {:?}",
        mesh.faces.len(),
        first.shell.faces.len(),
        built.shell.faces.len(),
        built.counts
    );
    if let Some(partner) = &partner {
        let outcome = certify(&built.shell, Some(partner), &Options::default(), &Silent)?;
        for claim in &outcome.claims {
            print!("partner: {} {}; ", claim.claim, claim.verdict);
            for r in claim.refutations.iter().take(1) {
                print!("[{}] ", r.text);
            }
        }
        println!();
    }
    let outcome = certify(&built.shell, Some(&mesh), &Options::default(), &Silent)?;
    for claim in &outcome.claims {
        print!("{} {}; ", claim.claim, claim.verdict);
        for r in claim.refutations.iter().take(1) {
            print!("[{}] ", r.text);
        }
    }
    println!();
    if let Some(other) = option("--compare") {
        let file = hdf5::read(Path::new(other))?;
        let unit = file.mesh.map_or(1.0, |m| longest_box_edge(&m.vertices));
        let [min, mean] = thickness(&file.shell, unit);
        println!("{other}: {} prisms, thickness min {min:.5} mean {mean:.5}", file.shell.faces.len());
    }
    if let Some(out) = option("-o") {
        write(Path::new(out), &built.shell, &mesh)?;
    }
    Ok(())
}

fn write(path: &Path, shell: &Shell, mesh: &mesh::TriMesh) -> Result<(), Box<dyn std::error::Error>> {
    let file = ShellFile { shell: shell.clone(), mesh: Some(mesh.clone()), ..ShellFile::default() };
    hdf5::write(path, &file)?;
    Ok(())
}
