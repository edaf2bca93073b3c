//! Optimisation of a shell (*Shell* section 3.4): fewer, better shaped and thicker prisms around the same mesh.
//!
//! Operations propose in floats; what an operation would make is judged exactly before it is made
//! (`invariants.rs`, `prism.rs`, the topological conditions in each operation), so that nothing is
//! ever undone and the shell is valid at every moment.

mod cast;
mod collapse;
mod energy;
mod flip;
mod invariants;
mod limits;
mod prism;
mod repair;
mod schedule;
mod smooth;
mod state;
#[cfg(test)]
mod tests;
mod tree;

use std::time::Duration;

pub use schedule::Counts;

use self::invariants::Judge;
use self::limits::Limits;
use self::schedule::{Stop, Work};
use self::state::State;
use super::gate::BuildError;
use super::initial::longest_box_edge;
use crate::certify::{CertifyError, Observer};
use crate::mesh::{self, Connectivity, TriMesh};
use crate::shell::{Shell, validate};

/// How to optimise.
#[derive(Clone, Copy, Debug)]
pub struct OptimiseOptions {
    /// Largest thickness of each half, as a share of the longest edge of the mesh's bounding box.
    pub thickness: f64,
    /// Largest MIPS energy of a middle triangle that a collapse may make (2 is an equilateral triangle).
    pub max_energy: f64,
    /// Distortion bound: no operation makes a mesh triangle touch a tet whose pillar is further than this from its
    /// normal, in degrees. A rule of quality, in floats; validity needs less than 90 and is exact.
    pub max_angle_degrees: f64,
    /// Rounds of flips and smoothing at the end.
    pub polish: usize,
    /// When to stop with what has been reached.
    pub time_limit: Option<Duration>,
}

impl Default for OptimiseOptions {
    fn default() -> Self {
        Self { thickness: 0.1, max_energy: 30.0, max_angle_degrees: 89.95, polish: 20, time_limit: None }
    }
}

/// An optimised shell.
#[derive(Clone, Debug)]
pub struct Optimised {
    /// The shell.
    pub shell: Shell,
    /// What was done.
    pub counts: Counts,
    /// Whether the observer or the time limit ended the work early. The shell is valid all the same.
    pub stopped: bool,
}

/// Optimises a shell that is valid around a mesh (claims C1 to C3+; for instance [`initial`](super::initial)'s): the
/// result is valid, too. Deterministic, unless stopped.
///
/// Every operation costs O(log n + k) for n mesh triangles, k of which are near its prisms.
///
/// # Errors
/// [`BuildError::Mesh`] and [`BuildError::Certify`] where mesh or shell break the input conditions (THEORY section 1).
/// The claims themselves are not checked here: on a shell that is not valid the result is not, either.
pub fn optimise(
    mesh: &TriMesh,
    shell: &Shell,
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    optimise_joint(mesh, None, shell, options, observer)
}

/// With another mesh.
pub fn optimise_joint(
    mesh: &TriMesh,
    partner: Option<&TriMesh>,
    shell: &Shell,
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    mesh::check(mesh)?;
    validate::validate(shell).map_err(CertifyError::from)?;
    let connectivity = Connectivity::new(shell.middle.len(), &shell.faces)?;
    let mut stop = Stop::new(observer, options.time_limit);
    let mut work = Work {
        state: State::new(shell, &connectivity),
        judge: Judge::new(mesh, options.max_angle_degrees.to_radians().cos().max(0.0)),
        limits: Limits { thickness: options.thickness * longest_box_edge(mesh), energy: options.max_energy },
        counts: Counts::default(),
        tried: schedule::Tried::default(),
    };
    if let Some(partner) = partner {
        work.judge.partner = Some(Box::new(Judge::new(partner, 0.0)));
    }
    work.run(options.polish, &mut stop);
    Ok(Optimised { shell: work.state.shell(), counts: work.counts, stopped: stop.stopped() })
}
