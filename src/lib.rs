//! `homeo` proves, in exact arithmetic, that maps between triangle meshes are bijections.
//!
//! Floats propose, integers decide: every verdict is a statement about the input's `f64` coordinates, taken as the exact
//! rationals that they are. There is no tolerance.
//!
//! # Claims
//!
//! A *shell* ([`shell::Shell`]) has three points for every vertex of a triangle mesh, bottom, middle and top, and a prism for
//! every triangle. A *vertex order* ([`certify::VertexOrder`]) cuts every prism into six tets; along them every point of
//! the shell is projected onto the middle surface ([`projection`]). About a shell and a mesh in it there are these claims:
//!
//! | [`Claim`](certify::Claim) | says |
//! |---|---|
//! | `positivity` | all tets of all vertex orders have positive volume |
//! | `section` | the mesh crosses the shell once: off bottom and top, facing up in every tet of one order |
//! | `bijection` | for this order the projection is a homeomorphism from the mesh onto the middle surface |
//! | `section-all-orders` | `section` and `bijection` for every vertex order |
//! | `disjoint` | the mesh does not meet itself, nor bottom and top |
//! | `i2` | invariant I2 of *Bijective Projection in a Shell*: positive dots for all tets and triangles in contact |
//! | `disjoint-prisms` | the shell does not overlap itself (decided on demand) |
//!
//! # Verdicts
//!
//! [`certify::certify`] answers every claim *certified* or *refuted*; what it cannot work on (a mesh that is no oriented
//! manifold, an interruption) is a [`CertifyError`](certify::CertifyError) and no verdict. With the verdicts comes one text,
//! [`Outcome::certificate`](certify::Outcome::certificate), that proves all of them. The crate `homeo_certs` checks it against the
//! input files and shares no code with this one.
//!
//! ```
//! use homeo::certify::{Claim, Options, Silent, Verdict, certify};
//! use homeo::mesh::TriMesh;
//! use homeo::shell::{Shell, hdf5};
//!
//! // A tetrahedron around the origin, and the shell between it and copies half and twice as large.
//! let middle = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
//! let faces = vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
//! let layer = |factor: f64| middle.map(|p| p.map(|x| x * factor)).to_vec();
//! let mut shell = Shell { bottom: layer(0.5), middle: layer(1.0), top: layer(2.0), faces: faces.clone() };
//! let mesh = TriMesh { vertices: layer(1.0), faces };
//!
//! let options = Options { claims: vec![Claim::SectionAllOrders], ..Options::default() };
//! let outcome = certify(&shell, Some(&mesh), &options, &Silent)?;
//! assert!(outcome.all_certified());
//!
//! // The independent checker reads the same bytes that a file would have.
//! let file = hdf5::ShellFile { shell: shell.clone(), mesh: Some(mesh.clone()), ..Default::default() };
//! let checked = homeo_certs::check(outcome.certificate.as_bytes(), &[hdf5::to_bytes(&file)?]);
//! assert_eq!(checked.status, "valid");
//!
//! // Push one top point through the shell: refuted, with ids and exact values.
//! shell.top[0] = [0.0, 0.0, 0.0];
//! let outcome = certify(&shell, Some(&mesh), &options, &Silent)?;
//! assert_eq!(outcome.claims[0].verdict, Verdict::Refuted);
//! assert!(outcome.claims[0].refutations[0].value.is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Where to go from here: [`shell::hdf5`] and [`shell::three`] read shells, [`mesh::read`] reads meshes,
//! [`projection`] projects points, [`report`] turns outcomes into JSON and sentences.

pub mod audit;
pub mod certify;
pub mod cli;
pub mod construct;
pub mod fuzz;
pub mod mesh;
pub mod number;
pub mod predicate;
pub mod projection;
pub mod report;
pub mod shell;
#[cfg(test)]
mod testing;
pub mod transfer;
