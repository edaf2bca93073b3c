//! Values on a mesh, and carrying them along the map.
//!
//! | values | at | carried to a mesh `B` |
//! |---|---|---|
//! | numbers (scalars, vectors, colours) | vertices of `A` | vertices of `B`: linear interpolation at the point of `A`; the components of a vector are carried as they are |
//! | numbers (texture coordinates) | corners of `A` | vertices of `B`: interpolation in the triangle that holds the point; on an edge (a seam) the smallest triangle |
//! | labels, sets | vertices of `A` | vertices of `B`: those of the corner with the largest weight, of equal ones the smallest vertex |
//! | anything | triangles of `A` | triangles of `B`: the value of the triangle that holds the centroid's point; on an edge the smallest triangle |

mod carry;
mod error;
mod read;
#[cfg(test)]
mod tests;
mod write;

pub use carry::{Sample, Samples, Weights, carry};
pub use error::AttributeError;
pub use read::{from_columns, from_csv, from_json, read};
pub use write::{to_csv, to_json, to_ply};

pub use crate::mesh::Domain;

/// Named values on a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    /// The name.
    pub name: String,
    /// What the values belong to.
    pub domain: Domain,
    /// The values, in the order of the mesh.
    pub values: Values,
}

/// The values of an attribute.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Finite numbers, `width` of them for each element.
    Numbers {
        /// Numbers for each element; at least 1.
        width: usize,
        /// Element after element.
        data: Vec<f64>,
        /// Written to PLY as bytes: rounded to nearest, between 0 and 255.
        bytes: bool,
    },
    /// One of some names for each element.
    Labels {
        /// Indices of `names`.
        of: Vec<u32>,
        /// The different labels.
        names: Vec<String>,
    },
    /// The elements that belong to a set.
    Set(Vec<bool>),
}

impl Values {
    /// The number of elements that have a value.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers { width, data, .. } => data.len() / width.max(&1),
            Self::Labels { of, .. } => of.len(),
            Self::Set(members) => members.len(),
        }
    }

    /// Is there none?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The values of some elements.
    fn select(&self, elements: impl Iterator<Item = usize>) -> Self {
        match self {
            Self::Numbers { width, data, bytes } => Self::Numbers {
                width: *width,
                data: elements.flat_map(|e| data[e * width..(e + 1) * width].iter().copied()).collect(),
                bytes: *bytes,
            },
            Self::Labels { of, names } => {
                Self::Labels { of: elements.map(|e| of[e]).collect(), names: names.clone() }
            }
            Self::Set(members) => Self::Set(elements.map(|e| members[e]).collect()),
        }
    }
}
