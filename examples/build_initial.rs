//! Build an initial shell around a mesh and certify it: `cargo run --release --example build_initial -- mesh.off`.

use std::path::Path;
use std::time::Instant;

use homeo::certify::{Options, Silent, certify};
use homeo::construct::{InitialOptions, initial};
use homeo::mesh;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: build_initial MESH")?;
    let mesh = mesh::read(Path::new(&path))?.mesh;
    let start = Instant::now();
    let built = initial(&mesh, &InitialOptions::default(), &Silent)?;
    let seconds = start.elapsed().as_secs_f64();
    let prisms = built.shell.faces.len();
    println!(
        "{} triangles, {} beveled, {prisms} prisms, {} rounds, {seconds:.2} s",
        mesh.faces.len(),
        built.beveled,
        built.rounds
    );
    let outcome = certify(&built.shell, Some(&mesh), &Options::default(), &Silent)?;
    for claim in &outcome.claims {
        print!("{} {}; ", claim.claim, claim.verdict);
        for r in claim.refutations.iter().take(1) {
            print!("[{}] ", r.text);
        }
    }
    println!();
    Ok(())
}
