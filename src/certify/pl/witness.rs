//! What shows that a claim about meshes is false.

use std::fmt;

use dashu_int::IBig;

use super::super::write::joined;

/// Which input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The first.
    A,
    /// The second.
    B,
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::A { "a" } else { "b" })
    }
}

/// A reason, with ids of vertices and cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Witness {
    /// A cell that has a vertex twice.
    Repeated(u32),
    /// Two cells on the same vertices.
    Twin([u32; 2]),
    /// Two cells that have a facet the same way round.
    Direction([u32; 2]),
    /// Three cells on one facet.
    Facet(Vec<u32>, [u32; 3]),
    /// Two cells at a vertex that do not hang together there.
    Vertex(u32, [u32; 2]),
    /// Two tets at an edge that do not hang together there.
    Edge([u32; 2], [u32; 2]),
    /// A vertex whose link is neither a disc nor a sphere.
    Link(u32),
    /// A cell without area or volume.
    Flat(u32),
    /// Two cells of a component whose determinants have not one strict sign.
    Sign([u32; 2]),
    /// Two cells with a common point that their common vertices do not force: weights on their corners.
    Cross([u32; 2], [Vec<IBig>; 2]),
    /// A boundary facet whose centroid lies in this other cell.
    Twice(u32, u32),
}

impl Witness {
    /// The line of the certificate.
    #[must_use]
    pub fn line(&self, input: Input) -> String {
        let pair = |word: &str, [i, j]: &[u32; 2]| format!("{word} {input} {i} {j}");
        match self {
            Self::Repeated(c) => format!("repeated {input} {c}"),
            Self::Twin(cells) => pair("twin", cells),
            Self::Direction(cells) => pair("direction", cells),
            Self::Facet(v, [i, j, k]) => format!("facet {input} {} {i} {j} {k}", joined(v, ",")),
            Self::Vertex(v, [i, j]) => format!("vertex {input} {v} {i} {j}"),
            Self::Edge([u, v], [i, j]) => format!("edge {input} {u},{v} {i} {j}"),
            Self::Link(v) => format!("link {input} {v}"),
            Self::Flat(c) => format!("flat {input} {c}"),
            Self::Sign(cells) => pair("sign", cells),
            Self::Cross([i, j], [w, x]) => {
                format!("cross {input} {i} {j} {} {}", joined(w, " "), joined(x, " "))
            }
            Self::Twice(facet, cell) => format!("twice {input} {facet} {cell}"),
        }
    }

    /// The kind, one word.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Repeated(_) => "repeated",
            Self::Twin(_) => "twin",
            Self::Direction(_) => "direction",
            Self::Facet(..) => "facet",
            Self::Vertex(..) => "vertex",
            Self::Edge(..) => "edge",
            Self::Link(_) => "link",
            Self::Flat(_) => "flat",
            Self::Sign(_) => "sign",
            Self::Cross(..) => "cross",
            Self::Twice(..) => "twice",
        }
    }

    /// Does it show that the cells are no oriented manifold, whatever the positions?
    #[must_use]
    pub fn is_defect(&self) -> bool {
        !matches!(self, Self::Flat(_) | Self::Sign(_) | Self::Cross(..) | Self::Twice(..))
    }

    /// A sentence.
    #[must_use]
    pub fn sentence(&self) -> String {
        match self {
            Self::Repeated(c) => format!("cell {c} has a vertex twice"),
            Self::Twin([i, j]) => format!("cells {i} and {j} have the same vertices"),
            Self::Direction([i, j]) => format!("cells {i} and {j} are oriented against each other"),
            Self::Facet(v, [i, j, k]) => {
                format!("cells {i}, {j} and {k} share the vertices {}", joined(v, " "))
            }
            Self::Vertex(v, [i, j]) => format!("cells {i} and {j} do not hang together at vertex {v}"),
            Self::Edge([u, v], [i, j]) => format!("tets {i} and {j} do not hang together at edge {u} {v}"),
            Self::Link(v) => format!("the tets at vertex {v} are no ball around it"),
            Self::Flat(c) => format!("cell {c} is flat"),
            Self::Sign([i, j]) if i == j => format!("cell {i} is flat"),
            Self::Sign([i, j]) => format!("cells {i} and {j} have opposite signs"),
            Self::Cross([i, j], _) => {
                format!("cells {i} and {j} have a common point that they must not have")
            }
            Self::Twice(facet, cell) => {
                format!("the centre of boundary facet {facet} also lies in cell {cell}")
            }
        }
    }
}
