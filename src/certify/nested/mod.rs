//! Claims about two surfaces, or the topology of one: C7 `nested`, C7b `nested-topology`, `manifold`, `same-topology`.
//!
//! A mesh `a` is nested in a cage `b` if both are embedded closed surfaces without a common point, `b` winds once around
//! every component of `a`, and `a` around none of `b` (THEORY section 3, C7). Winding numbers are counted along rays in
//! integer directions that cross triangles in their interiors only. Documents are in the format of `certs/MESHES.md`.

mod between;
mod decide;
mod document;
mod ray;
mod topology;

#[cfg(test)]
mod tests;

pub use decide::{NestedOutcome, Reason, nested};
pub use ray::{Ray, Whose};
pub use topology::{ComponentFacts, component_facts, manifold, nested_topology, same_topology};
