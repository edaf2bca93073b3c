//! C1 `positivity`: every tet of every prism has a positive determinant (rule R1).

use dashu_int::IBig;
use rayon::prelude::*;

use super::CertifyError;
use super::exact::determinant;
use super::observer::Observer;
use super::witness::BadTet;
use crate::number::dyadic::scale_points;
use crate::predicate::{StageCounts, orient3d_staged};
use crate::shell::decomposition::TETS;
use crate::shell::{Layer, Shell, Slab, Tet};

/// The answer to C1.
#[derive(Debug, Default)]
pub(crate) struct Positivity {
    /// All tets that are not positive, ordered by prism, then table order.
    pub(crate) bad: Vec<BadTet>,
    /// How many tets were decided, by stage.
    pub(crate) stages: StageCounts,
}

/// Prisms a batch: large enough to amortise scheduling, small enough to balance.
const BATCH: usize = 512;

/// Decides C1. Linear in the number of prisms; all cores.
pub(crate) fn decide(shell: &Shell, observer: &dyn Observer) -> Result<Positivity, CertifyError> {
    let prisms: Vec<u32> = (0..shell.faces.len()).map(|p| u32::try_from(p).unwrap_or(u32::MAX)).collect();
    let parts: Vec<Positivity> = prisms
        .par_chunks(BATCH)
        .map(|chunk| {
            let mut part = Positivity::default();
            if observer.cancelled() {
                return part;
            }
            chunk.iter().for_each(|&p| prism(shell, p, &mut part));
            observer.advance(chunk.len() as u64);
            part
        })
        .collect();
    if observer.cancelled() {
        return Err(CertifyError::Cancelled);
    }
    let mut out = Positivity::default();
    for part in parts {
        out.bad.extend(part.bad);
        out.stages += part.stages;
    }
    Ok(out)
}

fn prism(shell: &Shell, prism: u32, out: &mut Positivity) {
    let face = shell.faces[prism as usize];
    if face.iter().any(|&v| shell.is_pinched(v)) {
        for tet in shell.prism_tets_unique(prism) {
            let [a, b, c, d] = tet.names.map(|n| shell.position(n));
            if !out.stages.note(orient3d_staged(a, b, c, d)).is_positive() {
                out.bad.push(bad_tet(shell, &tet));
            }
        }
        return;
    }
    // Without pinched corners the 24 tets are those of the table: no names are needed unless one is bad.
    let points = |layer: Layer| face.map(|v| &shell.layer(layer)[v as usize]);
    for slab in Slab::BOTH {
        let ends = [points(slab.lo()), points(slab.hi())];
        for (local, tet) in TETS.iter().enumerate() {
            let [a, b, c, d] =
                tet.vertices.map(|(corner, is_hi)| ends[usize::from(is_hi)][usize::from(corner)]);
            if !out.stages.note(orient3d_staged(a, b, c, d)).is_positive() {
                let named = |t: &Tet| t.slab == slab && usize::from(t.local) == local;
                out.bad.extend(shell.prism_tets(prism).filter(named).map(|t| bad_tet(shell, &t)));
            }
        }
    }
}

/// The witness that a tet is not positive.
pub(crate) fn bad_tet(shell: &Shell, tet: &Tet) -> BadTet {
    let points = tet.names.map(|n| *shell.position(n));
    let (scaled, exponent) = scale_points(&points);
    let value = determinant(&scaled[0], &scaled[1], &scaled[2], &scaled[3]);
    BadTet { prism: tet.prism, names: tet.sorted_names(), value: dyadic(value, 3 * exponent) }
}

/// `value * 2^exponent` with an odd mantissa, or `(0, 0)`.
pub(crate) fn dyadic(value: IBig, exponent: i32) -> (IBig, i32) {
    match value.trailing_zeros() {
        None => (IBig::ZERO, 0),
        Some(zeros) => (value >> zeros, exponent.saturating_add(i32::try_from(zeros).unwrap_or(0))),
    }
}
