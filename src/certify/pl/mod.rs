//! Claims about meshes without a shell: C8 `pl-homeomorphism` for two position sets of one complex, and C6 `embedded`.
//!
//! [`pl_homeomorphism`] and [`embedded`] answer *certified* or *refuted*, and write the certificate or the witness in the format
//! of `certs/MESHES.md`. Positions are doubles or rational numbers, taken exactly; the complex is of triangles in the
//! plane, of triangles in space, or of tets.
//!
//! The proof rule is C8 of THEORY section 3. In each input: the cells are a compact oriented manifold (`sound`);
//! where they fill their space all determinants of a component have one strict sign (`signs`), the boundary is embedded
//! (`apart`, `plane`), and one point of every boundary component is covered once (`once`); a surface in space is
//! embedded (`apart`).

mod apart;
mod canonical;
mod correspondence;
pub(super) mod decide;
pub(super) mod facets;
mod least;
mod once;
mod plane;
mod points;
mod signs;
pub(super) mod sound;
mod witness;
pub(super) mod write;

#[cfg(test)]
mod tests;

pub use canonical::complex_file;
pub use correspondence::{CorrespondenceError, Mapped, map_by_correspondence};
pub use decide::{Facts, PlError, PlOutcome, Side, embedded, pl_homeomorphism, side_facts};
pub use least::{Least, boundary_euler, least_determinant};
pub use signs::SignCounts;
pub use witness::{Input, Witness};
