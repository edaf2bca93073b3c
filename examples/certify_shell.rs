//! Certify a shell file from a program of one's own: `cargo run --release --example certify_shell -- shell.h5 [out.cert]`.

use std::path::Path;

use homeo::certify::{Options, Silent, certify};
use homeo::shell::hdf5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let path = args.next().ok_or("usage: certify_shell SHELL.h5 [OUT.cert]")?;
    let file = hdf5::read(Path::new(&path))?;
    let outcome = certify(&file.shell, file.mesh.as_ref(), &Options::default(), &Silent)?;
    for claim in &outcome.claims {
        println!("{:20} {} ({:.3} s)", claim.claim.name(), claim.verdict, claim.seconds);
        for count in &claim.counts {
            println!("    {}: {}", count.what, count.count);
        }
        for part in &claim.parts {
            println!(
                "    {}: {} ({} of {} pairs share a point)",
                part.about, part.verdict, part.crossings, part.pairs
            );
        }
        for refutation in claim.refutations.iter().take(2) {
            println!("    {}: {}", refutation.kind, refutation.text);
        }
    }
    if let Some(out) = args.next() {
        std::fs::write(out, outcome.certificate)?;
    }
    Ok(())
}
