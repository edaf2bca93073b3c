//! From mesh to mesh: `P_B^-1 P_A` for two sections `A`, `B` of one shell, exactly and in floating point.
//!
//! # How to call it
//!
//! ```
//! use homeo::construct::sample;
//! use homeo::mesh::TriMesh;
//! use homeo::projection::Projection;
//! use homeo::shell::VertexOrder;
//! use homeo::transfer::{ExactPoint, Transfer};
//!
//! let made = sample(1);
//! let middle = TriMesh { vertices: made.shell.middle.clone(), faces: made.shell.faces.clone() };
//! let projection = Projection::new(&made.shell, &VertexOrder::Id)?;
//! let transfer = Transfer::new(&projection, &made.mesh, &middle)?;
//!
//! // Exactly, there and back: the round trip is an equality.
//! let p = ExactPoint::from_f64(7, [0.5, 0.125, 0.375])?;
//! let q = transfer.forward(&p)?;
//! assert!(transfer.backward(&q)?.is_same(&p));
//!
//! // In floating point: triangle, weights and a proved bound for their error.
//! let near = transfer.forward_f64(7, [0.5, 0.125, 0.375])?;
//! assert_eq!(near.face, q.face);
//! assert!((0..3).all(|k| (near.weights[k] - q.rounded()[k]).abs() <= near.error + 1e-16));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How it works
//!
//! The projection is affine on every piece that a tet cuts from a triangle (THEORY section 1, reference
//! map), so a piece has a 3 x 3 matrix to the weights on the middle triangle, made of orientation
//! determinants, and its adjugate leads back. Points are homogeneous: nothing is divided, and a point is
//! carried by two products of an integer matrix and a vector.
//!
//! The piece is chosen by signs of linear forms. They are evaluated in doubles with the proved bounds of
//! `near`, and in integers where these do not decide. So the piece is always the right one, also in the
//! functions that end in `_f64`, whose weights alone are rounded. Many points go best through
//! [`Transfer::forward_batch_f64`] and its likes: the same answers, on all threads.
//!
//! # Cost
//!
//! Measured on one core of a busy machine, real shells of 104 to 16,628 prisms: 150,000 to 500,000 points a second
//! exactly, 170,000 to 310,000 in lowest terms, 0.7 to 4 million in `f64`. The integers have some 600 bits; their
//! greatest common divisors take half of the time, and decimal text of them as much again (90,000 to 230,000 points a
//! second). Cutting the meshes takes 0.01 to 1.5 s, once.
//!
//! # What it takes for granted
//!
//! That the map is a bijection is claim `bijection` for `A` and for `B` on this shell and vertex order
//! (together C5 of THEORY). [`Transfer`] does not prove it, and answers point by point: a point without an
//! image or with several is an error. Several images also come from a shell that overlaps itself in
//! space, where only a lift can choose; that case is not solved here.

pub mod attribute;
mod batch;
mod chart;
mod compare;
mod exact;
mod map;
mod near;
pub mod phong;
mod piece;
mod point;
mod quadtree;
#[cfg(test)]
mod tests;

pub use compare::{
    ASTRAY, RoundTrip, Worst, exact_round_trips, measured, random_points, round_trip, round_trip_phong,
};
pub use map::{FloatMeshPoint, Transfer};
pub use point::ExactPoint;
