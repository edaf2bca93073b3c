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
mod schedule;
mod smooth;
mod state;
#[cfg(test)]
mod tests;
pub(crate) mod tracked;
mod tree;

use std::time::Duration;

pub use schedule::Counts;

use self::invariants::Judge;
use self::limits::Limits;
use self::schedule::{Stop, Work};
use self::state::State;
use self::tracked::Tracked;
use super::gate::BuildError;
use super::initial::longest_box_edge;
use super::scale::Scale;
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
/// [`BuildError::Mesh`] and [`BuildError::Certify`] where mesh or shell break the input conditions (THEORY section 1);
/// [`BuildError::Range`] near the ends of the range of doubles.
/// The claims themselves are not checked here: on a shell that is not valid the result is not, either.
pub fn optimise(
    mesh: &TriMesh,
    shell: &Shell,
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    run(mesh, shell, None, options, observer)
}

/// As [`optimise`], for a mesh that may intersect itself and its initial shell, whose prism `i` lies on the mesh triangle
/// `origin[i]` ([`Initial::origin`](super::Initial)): each prism is judged only against the part of the surface that
/// runs through it (*Shell* section 6). The result satisfies C1 to C4, but no claim about all pairs in space (C3+, C6).
///
/// # Errors
/// As [`optimise`].
pub fn optimise_locally(
    mesh: &TriMesh,
    shell: &Shell,
    origin: &[u32],
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    run(mesh, shell, Some(origin), options, observer)
}

fn run(
    mesh: &TriMesh,
    shell: &Shell,
    origin: Option<&[u32]>,
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    mesh::check(mesh)?;
    validate::validate(shell).map_err(CertifyError::from)?;
    let scale = Scale::of(mesh);
    let mut done = at_size_one(&scale.mesh(mesh)?, &scale.shell(shell)?, origin, options, observer)?;
    done.shell = scale.inverse().shell(&done.shell)?;
    Ok(done)
}

fn at_size_one(
    mesh: &TriMesh,
    shell: &Shell,
    origin: Option<&[u32]>,
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    let connectivity = Connectivity::new(shell.middle.len(), &shell.faces)?;
    let mut stop = Stop::new(observer, options.time_limit);
    let mut state = State::new(shell, &connectivity);
    if let Some(origin) = origin {
        let wrong =
            origin.len() != shell.faces.len() || origin.iter().any(|&f| f as usize >= mesh.faces.len());
        if wrong {
            return Err(BuildError::Origin { prisms: shell.faces.len(), origins: origin.len() });
        }
        let around = Connectivity::new(mesh.vertices.len(), &mesh.faces)?;
        state.tracked = Some(Tracked::new(mesh, &around, origin, |i| state.prism(state.faces[i], None)));
    }
    let mut work = Work {
        state,
        judge: Judge::new(mesh, options.max_angle_degrees.to_radians().cos().max(0.0)),
        limits: Limits { thickness: options.thickness * longest_box_edge(mesh), energy: options.max_energy },
        counts: Counts::default(),
        tried: schedule::Tried::default(),
    };
    work.run(options.polish, &mut stop);
    Ok(Optimised { shell: work.state.shell(), counts: work.counts, stopped: stop.stopped() })
}
