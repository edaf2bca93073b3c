//! Optimisation of a shell (*Shell* section 3.4): fewer, better shaped and thicker prisms around the same mesh.
//!
//! Operations propose in floats; what an operation would make is judged exactly before it is made
//! (`invariants.rs`, `prism.rs`, the topological conditions in each operation), so that nothing is
//! ever undone and the shell is valid at every moment.
//!
//! Proposals change nothing, so that a batch of them is made in parallel (`batch.rs`); the result is that of making them
//! one after the other. Between two batches the work can be stopped, and saved to be resumed (`checkpoint.rs`).

mod batch;
mod cast;
pub mod checkpoint;
mod collapse;
mod energy;
mod flip;
mod grid;
mod invariants;
mod limits;
mod operation;
mod partner;
pub(crate) mod prism;
mod repair;
mod schedule;
mod skin;
mod smooth;
mod split;
mod state;
#[cfg(test)]
mod tests;
pub(crate) mod tracked;
pub(crate) mod tree;

use std::borrow::Cow;
use std::convert::Infallible;
use std::time::{Duration, Instant};

pub(crate) use energy::mips;
pub(crate) use limits::distance as length;
pub use schedule::Counts;

use self::batch::{BATCH, Work};
use self::checkpoint::CheckpointError;
use self::invariants::Judge;
use self::limits::Limits;
use self::operation::{Rules, Tried};
use self::partner::Partner;
use self::schedule::Position;
use self::skin::Skin;
use self::state::State;
use self::tracked::Tracked;
use super::gate::BuildError;
use super::initial::Thickness;
use super::overlap;
use super::scale::Scale;
use crate::certify::{CertifyError, Observer, Silent};
use crate::mesh::{self, Connectivity, TriMesh};
use crate::shell::{Shell, validate};

/// How to optimise.
#[derive(Clone, Copy, Debug)]
pub struct OptimiseOptions {
    /// Largest thickness of each half.
    pub thickness: Thickness,
    /// Largest MIPS energy of a middle triangle that a collapse may make (2 is an equilateral triangle).
    pub max_energy: f64,
    /// Distortion bound: no operation makes a mesh triangle touch a tet whose pillar is further than this from its
    /// normal, in degrees. A rule of quality, in floats; validity needs less than 90 and is exact.
    pub max_angle_degrees: f64,
    /// Rounds of flips and smoothing at the end.
    pub polish: usize,
    /// When to stop with what has been reached.
    pub time_limit: Option<Duration>,
    /// Another order of operations with another result, as good a priori. With 0, edges to flip and vertices to smooth
    /// are visited in the order of their ids, and of equally long edges the one with the smaller ids is collapsed
    /// first; with another seed a hash of seed and ids takes the ids' place.
    pub seed: u64,
    /// Keep the shell from overlapping itself (claim `disjoint-prisms`); it must not do so at the start.
    pub no_overlap: bool,
}

impl Default for OptimiseOptions {
    fn default() -> Self {
        Self {
            thickness: Thickness::default(),
            max_energy: 30.0,
            max_angle_degrees: 89.95,
            polish: 20,
            time_limit: None,
            seed: 0,
            no_overlap: false,
        }
    }
}

impl OptimiseOptions {
    fn scaled(&self, scale: Scale) -> Self {
        Self { thickness: self.thickness.scaled(scale), ..*self }
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
/// result is valid, too. Deterministic, unless stopped: the number of threads does not matter.
///
/// Every operation costs O(log n + k) for n mesh triangles, k of which are near its prisms.
///
/// # Errors
/// Those of [`Optimiser::new`].
pub fn optimise(
    mesh: &TriMesh,
    shell: &Shell,
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    Optimiser::new(mesh, shell, options)?.finish(observer)
}

/// As [`optimise`], for a mesh that may intersect itself and its initial shell, whose prism `i` lies on the mesh triangle
/// `origin[i]` ([`Initial::origin`](super::Initial)): each prism is judged only against the part of the surface that
/// runs through it (*Shell* section 6). The result satisfies C1 to C4, but no claim about all pairs in space (C3+, C6).
///
/// # Errors
/// Those of [`Optimiser::local`].
pub fn optimise_locally(
    mesh: &TriMesh,
    shell: &Shell,
    origin: &[u32],
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    Optimiser::local(mesh, shell, origin, options)?.finish(observer)
}

/// As [`optimise`], with a second mesh near the first that is to become a section of the shell, too: no operation makes
/// the shell hold the partner less than before, and pillars are moved, and prisms split, for its sake. It ends with the
/// round after which both seem to be sections, however fine the shell is then. That the partner is a section in the end
/// is not promised: certify it.
///
/// # Errors
/// Those of [`Optimiser::new`], for both meshes.
pub fn optimise_joint(
    mesh: &TriMesh,
    partner: &TriMesh,
    shell: &Shell,
    options: &OptimiseOptions,
    observer: &dyn Observer,
) -> Result<Optimised, BuildError> {
    mesh::check(partner)?;
    let mut optimiser = Optimiser::new(mesh, shell, options)?;
    let partner = Partner::new(optimiser.scale.mesh(partner)?);
    optimiser.work.rules.judge.partner = Some(Box::new(partner));
    optimiser.finish(observer)
}

/// An optimisation under way, between two batches of operations.
#[derive(Debug)]
pub struct Optimiser<'m> {
    work: Work<'m>,
    position: Position,
    options: OptimiseOptions,
    /// From the user's size to that of the work.
    scale: Scale,
}

impl<'m> Optimiser<'m> {
    /// Begins with a shell that is valid around the mesh.
    ///
    /// # Errors
    /// [`BuildError::Mesh`] and [`BuildError::Certify`] where mesh or shell break the input conditions (THEORY section
    /// 1); [`BuildError::Range`] near the ends of the range of doubles; [`BuildError::Overlap`] where the shell must not
    /// overlap itself and does. The claims themselves are not checked here: on a
    /// shell that is not valid the result is not, either.
    pub fn new(mesh: &'m TriMesh, shell: &Shell, options: &OptimiseOptions) -> Result<Self, BuildError> {
        mesh::check(mesh)?;
        validate::validate(shell).map_err(CertifyError::from)?;
        let scale = Scale::of(mesh);
        let connectivity = Connectivity::new(shell.middle.len(), &shell.faces)?;
        let mut work = Work {
            state: State::new(&scale.shell(shell)?, &connectivity),
            rules: rules(scale.mesh(mesh)?, &options.scaled(scale)),
            counts: Counts::default(),
            tried: Tried::default(),
            seed: options.seed,
        };
        if options.no_overlap {
            overlap::refuse(shell, &Silent)?;
            work.state.skin = Some(Skin::new(&work.state));
        }
        let position = Position::new(&mut work);
        Ok(Self { work, position, options: *options, scale })
    }

    /// Begins with an initial shell around a mesh that may intersect itself; see [`optimise_locally`].
    ///
    /// # Errors
    /// Those of [`Self::new`]; [`BuildError::Origin`].
    pub fn local(
        mesh: &'m TriMesh,
        shell: &Shell,
        origin: &[u32],
        options: &OptimiseOptions,
    ) -> Result<Self, BuildError> {
        let wrong =
            origin.len() != shell.faces.len() || origin.iter().any(|&f| f as usize >= mesh.faces.len());
        if wrong {
            return Err(BuildError::Origin { prisms: shell.faces.len(), origins: origin.len() });
        }
        let mut out = Self::new(mesh, shell, options)?;
        let around = Connectivity::new(mesh.vertices.len(), &mesh.faces)?;
        let (state, mesh) = (&out.work.state, &out.work.rules.judge.mesh);
        let tracked = Tracked::new(mesh, &around, origin, |i| state.prism(state.faces[i], None));
        out.work.state.tracked = Some(tracked);
        Ok(out)
    }

    /// Goes on from a checkpoint: to the same result, bit for bit, as if there had been no interruption.
    ///
    /// # Errors
    /// See [`CheckpointError`]: another mesh or other options than those of the checkpoint, or bytes that are none.
    pub fn resume(
        mesh: &'m TriMesh,
        options: &OptimiseOptions,
        bytes: &[u8],
    ) -> Result<Self, CheckpointError> {
        checkpoint::resume(mesh, options, bytes)
    }

    /// The work as it is now, to be resumed later.
    ///
    /// # Errors
    /// [`CheckpointError::Encode`].
    pub fn checkpoint(&self) -> Result<Vec<u8>, CheckpointError> {
        checkpoint::save(self)
    }

    /// One batch of operations; is there more to do?
    pub fn advance(&mut self) -> bool {
        let polish = u32::try_from(self.options.polish).unwrap_or(u32::MAX);
        self.position.advance(&mut self.work, polish)
    }

    /// Goes on until the end, or until the observer or the time limit stops it; `between` is called after every batch
    /// and once at the end. Whether it was stopped.
    ///
    /// # Errors
    /// The first that `between` returns.
    pub fn run<E>(
        &mut self,
        observer: &dyn Observer,
        mut between: impl FnMut(&Self) -> Result<(), E>,
    ) -> Result<bool, E> {
        let until = self.options.time_limit.and_then(|limit| Instant::now().checked_add(limit));
        let mut stage = "";
        loop {
            if observer.cancelled() || until.is_some_and(|t| Instant::now() >= t) {
                return Ok(!self.is_done());
            }
            let name = self.position.phase.name();
            if name != stage && !self.is_done() {
                observer.prisms(self.work.state.live as u64);
                observer.stage(name, None);
                stage = name;
            }
            let more = self.advance();
            observer.advance(BATCH as u64);
            observer.prisms(self.work.state.live as u64);
            between(self)?;
            if !more {
                return Ok(false);
            }
        }
    }

    fn is_done(&self) -> bool {
        self.position.phase == schedule::Phase::Done
    }

    /// The shell as it is now.
    ///
    /// # Errors
    /// [`BuildError::Range`] near the ends of the range of doubles.
    pub fn shell(&self) -> Result<Shell, BuildError> {
        self.scale.inverse().shell(&self.work.state.shell())
    }

    fn finish(mut self, observer: &dyn Observer) -> Result<Optimised, BuildError> {
        let Ok(stopped) = self.run(observer, |_| Ok::<(), Infallible>(()));
        let shell = self.shell()?;
        if self.options.no_overlap {
            // No operation makes an overlap (`Skin::admits`); that is argued for one change at a time, this looks at all.
            overlap::refuse(&shell, &Silent)?;
        }
        Ok(Optimised { shell, counts: self.counts(), stopped })
    }

    /// What was done so far.
    pub fn counts(&self) -> Counts {
        self.work.counts
    }
}

/// The rules at the size of the work.
fn rules<'m>(mesh: TriMesh, options: &OptimiseOptions) -> Rules<'m> {
    let limits = Limits { thickness: options.thickness.length(&mesh), energy: options.max_energy };
    let least_cosine = options.max_angle_degrees.to_radians().cos().max(0.0);
    Rules { judge: Judge::new(Cow::Owned(mesh), least_cosine), limits }
}
