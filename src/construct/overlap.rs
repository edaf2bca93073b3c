//! Shells that overlap themselves (*Shell* section 6, "Resolving Shell Self-Intersections").
//!
//! The reference program resolves overlaps in a shell that is finished, and loses validity. Here the initial shell is
//! shrunk until it does not overlap itself, which is possible since the mesh does not either, and no operation of the
//! optimisation makes an overlap: there is never one to resolve.

use super::gate::BuildError;
use crate::certify::prisms::{self, Prisms};
use crate::certify::{CertifyError, Observer, Overlap};
use crate::shell::{Layer, Shell, Slab, VertexOrder};

/// What is found in the order by id: that of every certificate that is written for it.
fn find(shell: &Shell, observer: &dyn Observer) -> Result<Prisms, CertifyError> {
    prisms::decide(shell, &VertexOrder::Id, observer)
}

/// The slabs that overlap others, in a shell whose tets are positive.
pub(crate) fn slabs(shell: &Shell, observer: &dyn Observer) -> Result<Vec<(u32, Slab)>, CertifyError> {
    let slab = |overlap: &Overlap, k: usize| {
        let top = overlap.tets[k].iter().any(|n| n.layer == Layer::Top);
        (overlap.prisms[k], if top { Slab::Top } else { Slab::Bottom })
    };
    let found = find(shell, observer)?;
    Ok(found.overlaps.iter().flat_map(|o| [slab(o, 0), slab(o, 1)]).collect())
}

/// An error for a shell that overlaps itself.
pub(crate) fn refuse(shell: &Shell, observer: &dyn Observer) -> Result<(), BuildError> {
    let found = find(shell, observer)?;
    let first = found.overlaps.first().map(|o| o.prisms).or(found.bad.as_ref().map(|b| [b.prism; 2]));
    match first {
        None => Ok(()),
        Some(prisms) => Err(BuildError::Overlap { prisms, count: found.overlaps.len() }),
    }
}
