//! The input conditions of a shell (THEORY section 1), each with a named error.
//!
//! A vertex that is pinched in one slab only (`b = m`, or `m = t`, but not both) is no input error:
//! tets with zero volume follow from it, so the claim `positivity` is refuted.

mod complex;
#[cfg(test)]
mod tests;

use super::{Layer, Name, Shell};

/// Why a shell is refused as an input.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShellError {
    /// The layers differ in length.
    #[error("the {layer:?} layer has {points} points, the middle layer {expected}")]
    Lengths {
        /// The layer that differs.
        layer: Layer,
        /// Its length.
        points: usize,
        /// The middle layer's length.
        expected: usize,
    },
    /// More vertices or prisms than 32-bit ids can name.
    #[error("there are {count} {what}; at most {limit} are supported")]
    TooMany {
        /// `vertices` or `prisms`.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there may be.
        limit: u32,
    },
    /// A coordinate is NaN or infinite.
    #[error("point {name} is not finite: {point:?}")]
    NotFinite {
        /// The point.
        name: Name,
        /// Its coordinates.
        point: [f64; 3],
    },
    /// A prism names a vertex that does not exist.
    #[error("prism {prism}: vertex {vertex} is out of range: there are {vertices}")]
    IndexOutOfRange {
        /// The prism.
        prism: u32,
        /// The vertex id.
        vertex: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A prism names a vertex twice.
    #[error("prism {prism}: vertex {vertex} is more than one of its corners")]
    RepeatedCorner {
        /// The prism.
        prism: u32,
        /// The repeated vertex.
        vertex: u32,
    },
    /// All corners of a prism are pinched: it would be a triangle, not a solid.
    #[error("prism {prism}: all of its corners {corners:?} are pinched")]
    ThreePinched {
        /// The prism.
        prism: u32,
        /// Its corners.
        corners: [u32; 3],
    },
    /// Two prisms stand on the same three vertices.
    #[error("prisms {first} and {second} have the same three corners {corners:?}")]
    SameCorners {
        /// The prism with the smaller id.
        first: u32,
        /// The other prism.
        second: u32,
        /// The common corners, ascending.
        corners: [u32; 3],
    },
    /// More than two prisms share a side.
    #[error("side {edge:?} belongs to {} prisms: {prisms:?}", prisms.len())]
    NonManifoldEdge {
        /// The side's vertices, ascending.
        edge: [u32; 2],
        /// All prisms at it, ascending.
        prisms: Vec<u32>,
    },
    /// Two prisms run along their common side in the same direction.
    #[error(
        "prisms {first} and {second} are oriented differently: both run along side {edge:?} in one direction"
    )]
    Orientation {
        /// The side's vertices, ascending.
        edge: [u32; 2],
        /// The prism with the smaller id.
        first: u32,
        /// The other prism.
        second: u32,
    },
    /// The prisms around a vertex are not connected across sides at it.
    #[error("vertex {vertex}: prisms {first} and {second} meet there, but are not connected around it")]
    NonManifoldVertex {
        /// The vertex.
        vertex: u32,
        /// A prism of one fan.
        first: u32,
        /// A prism of another fan.
        second: u32,
    },
}

/// What is allowed but worth telling.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Remarks {
    /// Vertices that no prism uses, ascending.
    pub unreferenced: Vec<u32>,
    /// The number of sides that belong to one prism only.
    pub boundary_sides: usize,
}

/// Checks all input conditions and returns the first violation; `O(n log n)`.
///
/// # Errors
/// See [`ShellError`], which is in the order of the checks.
pub fn validate(shell: &Shell) -> Result<Remarks, ShellError> {
    lengths(shell)?;
    finite(shell)?;
    indices(shell)?;
    corners(shell)?;
    let boundary_sides = complex::manifold(shell.vertex_count(), &shell.faces)?;
    let mut used = vec![false; shell.vertex_count()];
    for &vertex in shell.faces.as_flattened() {
        if let Some(slot) = used.get_mut(vertex as usize) {
            *slot = true;
        }
    }
    let unreferenced = (0_u32..).zip(used).filter_map(|(vertex, used)| (!used).then_some(vertex)).collect();
    Ok(Remarks { unreferenced, boundary_sides })
}

/// The three layers have one length, and ids fit into 32 bits.
///
/// # Errors
/// [`ShellError::Lengths`], [`ShellError::TooMany`].
pub fn lengths(shell: &Shell) -> Result<(), ShellError> {
    let expected = shell.middle.len();
    for layer in [Layer::Bottom, Layer::Top] {
        let points = shell.layer(layer).len();
        if points != expected {
            return Err(ShellError::Lengths { layer, points, expected });
        }
    }
    // Corner handles `3 * prism + corner` shall fit as well.
    for (what, count, limit) in
        [("vertices", expected, u32::MAX), ("prisms", shell.faces.len(), u32::MAX / 3)]
    {
        if count > limit as usize {
            return Err(ShellError::TooMany { what, count, limit });
        }
    }
    Ok(())
}

/// All coordinates are finite.
///
/// # Errors
/// [`ShellError::NotFinite`] for the first point that is not, bottom layer first.
pub fn finite(shell: &Shell) -> Result<(), ShellError> {
    for layer in [Layer::Bottom, Layer::Middle, Layer::Top] {
        for (vertex, &point) in (0..).zip(shell.layer(layer)) {
            if point.iter().any(|x| !x.is_finite()) {
                return Err(ShellError::NotFinite { name: Name { vertex, layer }, point });
            }
        }
    }
    Ok(())
}

/// All corners are vertices of the middle layer.
///
/// # Errors
/// [`ShellError::IndexOutOfRange`] for the first that is not.
pub fn indices(shell: &Shell) -> Result<(), ShellError> {
    let vertices = shell.vertex_count();
    for (prism, face) in (0..).zip(&shell.faces) {
        if let Some(&vertex) = face.iter().find(|&&vertex| vertex as usize >= vertices) {
            return Err(ShellError::IndexOutOfRange { prism, vertex, vertices });
        }
    }
    Ok(())
}

/// The corners of a prism are different, and not all pinched.
///
/// # Errors
/// [`ShellError::RepeatedCorner`], [`ShellError::ThreePinched`].
pub fn corners(shell: &Shell) -> Result<(), ShellError> {
    for (prism, &face) in (0..).zip(&shell.faces) {
        let [a, b, c] = face;
        if a == b || a == c || b == c {
            return Err(ShellError::RepeatedCorner { prism, vertex: if b == c { b } else { a } });
        }
        if face.iter().all(|&vertex| shell.is_pinched(vertex)) {
            return Err(ShellError::ThreePinched { prism, corners: face });
        }
    }
    Ok(())
}
