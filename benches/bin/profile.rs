//! Certifies one shell on one thread and prints the seconds of each claim and the peak memory: what to run a profiler
//! on.
//!
//!     homeo-profile FILE.h5 | same:FREQUENCY | initial:FREQUENCY | simplified:FREQUENCY [check | write DIRECTORY]
//!
//! With `check` the checker runs after it, on the certificate and the meshes; `write` puts these into files for `homeo-check`. Peaks are those of the process since the call,
//! with the input in memory; sizes of the input are those of its coordinates and indices.

use std::error::Error;
use std::path::Path;

use homeo::shell::hdf5;
use homeo_benches::generate::{Generated, initial, same, simplified};
use homeo_benches::run::{checker_inputs, input_bytes, on_one_thread, peak_memory, reset_peak_memory, whole};

fn input(name: &str) -> Result<Generated, Box<dyn Error>> {
    if let Some((kind, frequency)) = name.split_once(':') {
        let frequency: u32 = frequency.parse()?;
        return match kind {
            "same" => Ok(same(frequency)),
            "initial" => Ok(initial(frequency)),
            "simplified" => Ok(simplified(frequency, 2)),
            _ => Err(format!("no generator {kind}").into()),
        };
    }
    let file = hdf5::read(Path::new(name))?;
    Ok(Generated { shell: file.shell, mesh: file.mesh.ok_or("the file holds no mesh")? })
}

fn main() -> Result<(), Box<dyn Error>> {
    let name = std::env::args().nth(1).ok_or("usage: homeo-profile SHELL.h5 | KIND:FREQUENCY [check]")?;
    let input = input(&name)?;
    println!("mesh_triangles={} prisms={}", input.mesh.faces.len(), input.shell.faces.len());
    reset_peak_memory();
    let (outcome, seconds) = on_one_thread(|| whole(&input))??;
    for claim in &outcome.claims {
        println!("{:20} {} {:.3} s", claim.claim.name(), claim.verdict, claim.seconds);
        claim.counts.iter().for_each(|c| println!("    {}: {}", c.what, c.count));
        claim.refutations.iter().take(3).for_each(|r| println!("    {}", r.text));
    }
    println!("input_bytes={} certificate_bytes={}", input_bytes(&input), outcome.certificate.len());
    println!("seconds={seconds:.4}");
    if let Some(mib) = peak_memory() {
        println!("peak_mib={mib:.1}");
    }
    if std::env::args().nth(2).as_deref() == Some("check") {
        let files = checker_inputs(&input)?;
        reset_peak_memory();
        let start = std::time::Instant::now();
        let answer = on_one_thread(|| homeo_certs::check(outcome.certificate.as_ref(), &files))?;
        let seconds = start.elapsed().as_secs_f64();
        println!("checker: {} {} {}", answer.status, answer.code, answer.message);
        println!("check_seconds={seconds:.4}");
        if let Some(mib) = peak_memory() {
            println!("check_peak_mib={mib:.1}");
        }
    }
    if let (Some("write"), Some(directory)) = (std::env::args().nth(2).as_deref(), std::env::args().nth(3)) {
        let directory = Path::new(&directory);
        let files = checker_inputs(&input)?;
        for (name, bytes) in ["bottom.off", "middle.off", "top.off", "mesh.off"].iter().zip(&files) {
            std::fs::write(directory.join(name), bytes)?;
        }
        std::fs::write(directory.join("certificate.cert"), &outcome.certificate)?;
    }
    Ok(())
}
