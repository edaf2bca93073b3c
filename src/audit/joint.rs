//! Shells for the tries.

use std::time::Duration;

use super::options::{AuditOptions, Try};
use crate::certify::{CertifyError, Observer};
use crate::construct::{
    BuildError, InitialOptions, OptimiseOptions, Thickness, initial, optimise, optimise_joint,
};
use crate::mesh::TriMesh;
use crate::shell::Shell;

/// Rounds of polishing.
const POLISH: usize = 3;

/// How to make a shell.
#[derive(Clone, Copy, Debug)]
pub struct ShellOptions {
    /// Largest thickness of each half, as a share of the longest edge of the first mesh's bounding box.
    pub thickness: f64,
    /// When the optimisation stops.
    pub time_limit: Option<Duration>,
}

/// A shell around `a`, of which `b` is to become a section, too: initial shell, then joint optimisation. That both are
/// sections in the end is for the certifier to say.
///
/// # Errors
/// [`BuildError`].
pub fn joint(
    a: &TriMesh,
    b: &TriMesh,
    options: &ShellOptions,
    observer: &dyn Observer,
) -> Result<Shell, BuildError> {
    around(a, Some(b), options, observer)
}

/// A shell around `a`.
fn around(
    a: &TriMesh,
    partner: Option<&TriMesh>,
    options: &ShellOptions,
    observer: &dyn Observer,
) -> Result<Shell, BuildError> {
    let thickness = Thickness::Share(options.thickness);
    let first = initial(a, &InitialOptions { thickness, ..InitialOptions::default() }, observer)?;
    // Polishing makes shells pretty; a few rounds of it are enough to unlock what is stuck.
    let wanted = OptimiseOptions {
        thickness,
        time_limit: options.time_limit,
        polish: POLISH,
        ..OptimiseOptions::default()
    };
    let done = match partner {
        Some(partner) => optimise_joint(a, partner, &first.shell, &wanted, observer)?,
        None => optimise(a, &first.shell, &wanted, observer)?,
    };
    // An interruption ends the optimisation with a valid shell, but nobody waits for it.
    if observer.cancelled() { Err(CertifyError::Cancelled.into()) } else { Ok(done.shell) }
}

/// The shell of a try; `None` for [`Try::Given`].
pub(crate) fn shell_of(
    which: Try,
    [a, b]: [&TriMesh; 2],
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Option<Result<Shell, BuildError>> {
    let normal = ShellOptions { thickness: options.thickness, time_limit: options.time_limit };
    let thick = ShellOptions { thickness: 2.0 * options.thickness, ..normal };
    Some(match which {
        Try::Given => return None,
        Try::A => around(a, None, &normal, observer),
        Try::B => around(b, None, &normal, observer),
        Try::JointA => joint(a, b, &normal, observer),
        Try::JointB => joint(b, a, &normal, observer),
        Try::ThickJointA => joint(a, b, &thick, observer),
    })
}
