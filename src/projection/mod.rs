//! The projection `P` of a shell, its inverse, and the maps that they give between meshes.
//!
//! # How to call it
//!
//! ```
//! use homeo::shell::VertexOrder;
//! use homeo::projection::Projection;
//! use homeo::shell::Shell;
//!
//! // One straight prism; a file is read with `homeo::shell::hdf5::read(path)?.shell`.
//! let layer = |z| vec![[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
//! let shell = Shell { bottom: layer(-1.0), middle: layer(0.0), top: layer(1.0), faces: vec![[0, 1, 2]] };
//!
//! let projection = Projection::new(&shell, &VertexOrder::Id)?;
//! let p = [0.25, 0.5, 0.75];
//!
//! // Floating point: prism, weights on its three corners, height, and a bound for their error.
//! let near = projection.project_f64(&p).ok_or("outside of the shell")?;
//! assert_eq!((near.prism, near.weights, near.height), (0, [0.25, 0.25, 0.5], 0.75));
//!
//! // Exact: rationals, and a round trip that is an equality.
//! let exact = projection.project_exactly(&p).ok_or("outside of the shell")?;
//! let back = projection.unproject(&exact)?;
//! assert_eq!(back.map(|x| x.to_f64().value()), p);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | wanted | call |
//! |---|---|
//! | is a point in the shell, in which tets | [`Projection::is_inside`], [`Projection::locate`] |
//! | point of space to `(prism, alpha, beta, h)` | [`Projection::project`], [`project_f64`](Projection::project_f64) |
//! | the same in a shell that overlaps itself | [`Projection::project_all`], [`Projection::images`] |
//! | the same fast: exact, over one denominator, not in lowest terms | [`Projection::image`], [`Projection::images`] |
//! | the same in a known prism | [`Projection::images_in`] |
//! | many points in floating point | [`Projection::project_batch_f64`] |
//! | `(prism, alpha, beta, h)` to space | [`Projection::unproject`], [`unproject_f64`](Projection::unproject_f64) |
//! | the line through the shell over a middle point | [`Projection::fibre`] |
//! | mesh point to middle surface (`P_T`) | [`SectionMap::to_middle`] |
//! | middle surface to mesh point (`P_T^-1`) | [`SectionMap::to_mesh`] |
//! | mesh `A` to mesh `B` in one shell | [`Transfer`](crate::transfer::Transfer), much faster than `to_middle`, then `to_mesh` |
//!
//! The examples `project_points` and `transfer` are complete programs.
//!
//! # For users of the reference implementation of *Shell*
//!
//! Its stored answers are a triangle `fid` of the target mesh and `qUV`. From mesh to middle surface,
//! `fid` is [`ShellPoint::prism`] and `qUV` is `(beta, gamma)`, the weights on the triangle's second
//! and third corner; from middle to mesh, `fid` is [`MeshPoint::face`] and `qUV` the last two
//! [`MeshPoint::weights`]. Its decomposition is that of [`VertexOrder::Id`](crate::shell::VertexOrder):
//! on three of its shells all 7,832 of its answers are those of this module, up to its own rounding
//! (at most 4e-12). On an edge or at a vertex it names any of the triangles there, this module the
//! one with the smallest id. The mesh must be taken from the shell file, where it is moved and scaled.
//!
//! # What is computed
//!
//! The tets of one vertex order fill the shell, and each is mapped affinely to the reference prism
//! `M x [-1, 1]`. Its vertices lie on the pillars, so the barycentric coordinates of a point in its
//! tet give the image: the weight on a corner is the sum over the vertices on its pillar, the height
//! the sum over top vertices minus the sum over bottom vertices (THEORY section 1, *Shell* section
//! 3.1). A pinched vertex has height 0. The value on a common face does not depend on the tet.
//!
//! `Projection` refuses a shell with a tet of its order that is not positive. That is all it checks:
//! that `P` is a bijection between a mesh and the middle surface is the claim `bijection` of
//! [`certify`](crate::certify).
//!
//! # Exactness and cost
//!
//! `f64` coordinates are exact rationals, and all results but those of the `_f64` functions are
//! exact: no tolerance, no rounding. A tet is found by determinants of doubles with a proved bound, by predicates where
//! these do not decide; coordinates in it are integers over one denominator, of 192 or 384 bits for ordinary shells.
//! Measured on a busy machine, 20,000 prisms, points in random order, one thread: an exact image in a known prism
//! ([`Projection::images_in`]) takes 0.6 to 2 microseconds, 3 to 5 in lowest terms; to find the prism, too, takes 2 to 4
//! more. A floating image takes 2 to 5 ([`FloatPoint`] states its error bound, at most
//! [`MAX_ERROR`]), one of a large batch 1 to 2; points at vertices of many tets take longer. The exact inverse takes 5 to
//! 35 microseconds, [`SectionMap::to_mesh`] 300 to 500. From mesh to mesh
//! [`Transfer`](crate::transfer::Transfer) takes 2 to 7 microseconds exactly.
//! [`Projection::trace`] computes the same middle points by following the field tet by tet: it is the
//! oracle that the tests compare with.

mod batch;
mod boxes;
mod error;
mod exact;
mod float;
mod image;
mod images;
mod integers;
mod inverse;
mod locate;
mod point;
mod rounded;
mod section;
#[cfg(test)]
mod tests;
mod trace;

pub use error::{PointError, ProjectionError, SectionError};
pub use exact::Rat;
pub use float::{FloatPoint, MAX_ERROR};
pub use image::ExactImage;
pub use inverse::FibrePiece;
pub use locate::{Location, Projection};
pub use point::ShellPoint;
pub use section::{MeshPoint, SectionMap};

pub(crate) use point::{Stars, barycentric};
pub(crate) use section::well_formed;
