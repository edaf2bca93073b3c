//! Running the certifier and the checker on one thread, with the clock on.

use std::time::Instant;

use homeo::certify::{CertifyError, Claim, Options, Outcome, Silent, certify};
use homeo::mesh::{self, Format, MeshError};
use homeo::predicate::orient3d;
use homeo::shell::decomposition::TETS;
use homeo::shell::{Shell, Slab, three};

use crate::generate::Generated;

/// Runs `work` in a pool of one thread.
///
/// # Errors
/// The pool cannot be built.
pub fn on_one_thread<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, rayon::ThreadPoolBuildError> {
    on_threads(1, work)
}

/// Runs `work` in a pool of so many threads.
///
/// # Errors
/// The pool cannot be built.
pub fn on_threads<T: Send>(
    threads: usize,
    work: impl FnOnce() -> T + Send,
) -> Result<T, rayon::ThreadPoolBuildError> {
    Ok(rayon::ThreadPoolBuilder::new().num_threads(threads).build()?.install(work))
}

/// A count that a claim's result states; 0 if it does not.
#[must_use]
pub fn count(outcome: &Outcome, claim: Claim, what: &str) -> u64 {
    let counts = outcome.claims.iter().filter(|c| c.claim == claim).flat_map(|c| &c.counts);
    counts.filter(|c| c.what == what).map(|c| c.count).sum()
}

/// The number of different tets of a shell, and the seconds that C1 took for them (without input conditions and
/// certificate, as in the CGAL program).
///
/// # Errors
/// As [`certify`].
pub fn positivity(shell: &Shell) -> Result<(u64, f64), CertifyError> {
    let options = Options { claims: vec![Claim::Positivity], ..Options::default() };
    let outcome = certify(shell, None, &options, &Silent)?;
    let seconds = outcome.claims.iter().map(|c| c.seconds).sum();
    Ok((count(&outcome, Claim::Positivity, "tets"), seconds))
}

/// The number of tets that are not positive, and the seconds for their signs alone: the table of tets on a prism's nine
/// points, without names. What [`positivity`] costs beyond it is not arithmetic. For shells without pinched vertices.
#[must_use]
pub fn signs_alone(shell: &Shell) -> (usize, f64) {
    let start = Instant::now();
    let mut bad = 0;
    for face in &shell.faces {
        for slab in Slab::BOTH {
            let layers = [slab.lo(), slab.hi()];
            let points = layers.map(|layer| face.map(|v| &shell.layer(layer)[v as usize]));
            for tet in &TETS {
                let [a, b, c, d] =
                    tet.vertices.map(|(corner, hi)| points[usize::from(hi)][usize::from(corner)]);
                bad += usize::from(!orient3d(a, b, c, d).is_positive());
            }
        }
    }
    (bad, start.elapsed().as_secs_f64())
}

/// All claims, with the seconds of the whole call.
///
/// # Errors
/// As [`certify`].
pub fn whole(input: &Generated) -> Result<(Outcome, f64), CertifyError> {
    let start = Instant::now();
    let outcome = certify(&input.shell, Some(&input.mesh), &Options::default(), &Silent)?;
    Ok((outcome, start.elapsed().as_secs_f64()))
}

/// The bytes of the coordinates (8 each) and indices (4 each) of a shell and a mesh: the smallest size of the input that
/// anything can be compared with.
#[must_use]
pub fn input_bytes(input: &Generated) -> usize {
    let coordinates = 3 * (3 * input.shell.vertex_count() + input.mesh.vertices.len());
    8 * coordinates + 4 * 3 * (input.shell.faces.len() + input.mesh.faces.len())
}

/// Forgets the largest memory so far, where the system can; [`peak_memory`] then begins with what is resident now.
pub fn reset_peak_memory() {
    // Where this is not possible the peak is that of the whole process, which is more: never in our favour.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// The bytes of the files that a checker is given: bottom, middle, top, mesh.
///
/// # Errors
/// As [`mesh::encode`].
pub fn checker_inputs(input: &Generated) -> Result<Vec<Vec<u8>>, MeshError> {
    let layers = three::to_meshes(&input.shell);
    layers.iter().chain([&input.mesh]).map(|m| mesh::encode(m, Format::Off, "generated")).collect()
}

/// The largest resident memory of this process so far, in MiB; `None` where the system does not say.
#[must_use]
pub fn peak_memory() -> Option<f64> {
    peak_memory_of("self")
}

/// That of the process with this number.
#[must_use]
pub fn peak_memory_of(process: &str) -> Option<f64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok().map(|kib| kib / 1024.0)
}
