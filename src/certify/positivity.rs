//! C1 `positivity`: every tet of every prism has a positive determinant (rule R1).

use dashu_int::IBig;
use rayon::prelude::*;

use super::CertifyError;
use super::exact::determinant;
use super::observer::Observer;
use super::witness::BadTet;
use crate::number::dyadic::scale_points;
use crate::predicate::batch::Level;
use crate::predicate::batch::kernel::{LANES, Least, Row, common_error, cross, gather, minus};
use crate::predicate::{StageCounts, orient3d, orient3d_staged};
use crate::shell::decomposition::TETS;
use crate::shell::{Layer, Shell, Slab, Tet};

#[cfg(test)]
mod tests;

/// The answer to C1.
#[derive(Debug, Default)]
pub(crate) struct Positivity {
    /// All tets that are not positive, ordered by prism, then table order.
    pub(crate) bad: Vec<BadTet>,
    /// How many tets were decided, by stage.
    pub(crate) stages: StageCounts,
}

/// Prisms a batch: large enough to amortise scheduling, small enough to balance. Whole blocks of lanes.
const BATCH: usize = 32 * LANES;

/// Decides C1. Linear in the number of prisms; all cores.
pub(crate) fn decide(shell: &Shell, observer: &dyn Observer) -> Result<Positivity, CertifyError> {
    let parts = batches(shell, observer, |p, clear, part: &mut Positivity| {
        if clear {
            part.stages.filter += 2 * TETS.len() as u64;
        } else {
            prism(shell, p, part);
        }
    })?;
    let mut out = Positivity::default();
    for part in parts {
        out.bad.extend(part.bad);
        out.stages += part.stages;
    }
    Ok(out)
}

/// The slabs of prisms with a tet that is not positive, ascending: where [`decide`] finds bad tets, without their witnesses.
pub(crate) fn bad_slabs(shell: &Shell, observer: &dyn Observer) -> Result<Vec<(u32, Slab)>, CertifyError> {
    let is_bad = |tet: Tet| {
        let [a, b, c, d] = tet.names.map(|n| shell.position(n));
        !orient3d(a, b, c, d).is_positive()
    };
    let parts = batches(shell, observer, |p, clear, part: &mut Vec<(u32, Slab)>| {
        let bad = |slab: &Slab| !clear && shell.prism_tets(p).any(|t| t.slab == *slab && is_bad(t));
        part.extend(Slab::BOTH.into_iter().filter(bad).map(|slab| (p, slab)));
    })?;
    Ok(parts.concat())
}

/// Looks at every prism, with whether a common bound shows that all its tets are positive. What is made of each batch, in order.
fn batches<T: Default + Send>(
    shell: &Shell,
    observer: &dyn Observer,
    look: impl Fn(u32, bool, &mut T) + Sync,
) -> Result<Vec<T>, CertifyError> {
    let level = Level::widest();
    let batch = |(k, chunk): (usize, &[[u32; 3]])| {
        let mut part = T::default();
        if observer.cancelled() {
            return part;
        }
        for (i, clear) in clear(level, shell, chunk).into_iter().enumerate() {
            look(u32::try_from(k * BATCH + i).unwrap_or(u32::MAX), clear, &mut part);
        }
        observer.advance(chunk.len() as u64);
        part
    };
    let parts = shell.faces.par_chunks(BATCH).enumerate().map(batch).collect();
    if observer.cancelled() { Err(CertifyError::Cancelled) } else { Ok(parts) }
}

/// For some prisms whether all their tets are positive by a common bound: whole blocks; of those that are left over nothing is known.
fn clear(level: Level, shell: &Shell, faces: &[[u32; 3]]) -> Vec<bool> {
    let (blocks, _) = faces.as_chunks::<LANES>();
    let mut clear = vec![[false; LANES]; blocks.len()];
    // Inlined, as what is called would be compiled without the instructions of the level.
    level.run(
        #[inline(always)]
        || {
            for (clear, block) in clear.iter_mut().zip(blocks) {
                *clear = all_positive(shell, block);
            }
        },
    );
    let mut clear = clear.into_flattened();
    clear.resize(faces.len(), false);
    clear
}

/// The prisms of a block all of whose tets are positive by a bound for each slab. A pinched vertex makes a tet flat, so that no
/// such prism is among them.
///
/// The twelve tets of a slab need eight cross products, one of which the other slab needs, too: with `V` the pillars' halves,
/// `e` the sides below and `h` those above, all of them rounded differences of two points, and `N` the normals of the two triangles,
/// the determinants are `N_lo . V_x` and `N_hi . V_x` for the three corners `x`, and for each side `u v` with the corner `w`
/// before it `(V_v x e_uv) . h_vw` and `(V_u x e_uv) . h_uw`: the vector from the plane of three points to the fourth may start at
/// any of the three.
#[inline(always)]
fn all_positive(shell: &Shell, faces: &[[u32; 3]; LANES]) -> [bool; LANES] {
    let layers: [[Row; 3]; 3] =
        [Layer::Bottom, Layer::Middle, Layer::Top].map(|layer| gather(shell.layer(layer), faces));
    // The side k leads from corner k to the next one.
    let sides = layers.each_ref().map(|[a, b, c]| [minus(b, a), minus(c, b), minus(a, c)]);
    let normals = sides.each_ref().map(|[a, b, _]| cross(a, b));
    let mut kept = [true; LANES];
    for slab in [0, 1] {
        let (lo, hi) = (&layers[slab], &layers[slab + 1]);
        let error = common_error(&[&lo[0], &lo[1], &lo[2], &hi[0], &hi[1], &hi[2]]);
        let pillars = [0, 1, 2].map(|k| minus(&hi[k], &lo[k]));
        let mut least = Least::new();
        for pillar in &pillars {
            least.add(pillar, &normals[slab]);
            least.add(pillar, &normals[slab + 1]);
        }
        let (below, above) = (&sides[slab], &sides[slab + 1]);
        for u in [0, 1, 2] {
            let (v, w) = ((u + 1) % 3, (u + 2) % 3);
            least.add(&above[v], &cross(&pillars[v], &below[u]));
            // From `u` to `w`: the side leads the other way, so that the product is turned.
            least.add(&above[w], &cross(&below[u], &pillars[u]));
        }
        for (kept, above) in kept.iter_mut().zip(least.above(&error)) {
            *kept &= above;
        }
    }
    kept
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
