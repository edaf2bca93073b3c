//! Witnesses that no lift of the mesh is a section (THEORY section 4).

use dashu_int::IBig;

use crate::shell::Name;

/// What a witness about a lift ends with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Ending {
    /// The point is on bottom or top.
    Cap,
    /// The point is on a boundary wall of the shell, but not on the boundary of the mesh.
    Wall,
    /// The point is on the boundary of the mesh, but not on a boundary wall of the shell.
    Boundary,
    /// `n . V <= 0` around the point.
    Fold,
    /// The lift is a section onto this component of the middle complex (which another component needs).
    Lands,
    /// Two points of the mesh with one image.
    Twice,
    /// One point of the mesh reached with two carriers.
    Monodromy,
}

impl Ending {
    /// The word used in certificates.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Cap => "cap",
            Self::Wall => "wall",
            Self::Boundary => "boundary",
            Self::Fold => "fold",
            Self::Lands => "lands",
            Self::Twice => "twice",
            Self::Monodromy => "monodromy",
        }
    }
}

/// A point of the lift, reached in a straight line from the one before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// The mesh triangle that the path goes on in.
    pub face: u32,
    /// The point: integer weights on the triangle's corners.
    pub weights: [IBig; 3],
    /// The tet that the path goes on in, names ascending.
    pub tet: [Name; 4],
}

/// A path of the lift from the root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leg {
    /// The tet that it starts in, names ascending.
    pub start: [Name; 4],
    /// Its further points; none when it ends at the root.
    pub steps: Vec<Step>,
}

/// One way to lift the root, refuted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Branch {
    /// Carrier of the root point in the shell.
    pub carrier: Vec<Name>,
    /// One path, or two for [`Ending::Twice`] and [`Ending::Monodromy`].
    pub legs: Vec<Leg>,
    /// What is wrong at the end.
    pub ending: Ending,
}

/// A point of the mesh with all ways to lift it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// The triangle.
    pub face: u32,
    /// Integer weights on its corners.
    pub weights: [IBig; 3],
    /// One branch for every carrier of the point, ascending; none: the point is outside.
    pub branches: Vec<Branch>,
}

/// Proof that no lift is a section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoLift {
    /// Mesh and middle complex differ in the number of components.
    Components {
        /// Of the mesh.
        mesh: u32,
        /// Of the middle complex.
        middle: u32,
    },
    /// Mesh and middle complex differ in Euler characteristic.
    Euler {
        /// Of the mesh.
        mesh: i64,
        /// Of the middle complex.
        middle: i64,
    },
    /// A tet of the decomposition is not positive.
    Tet(BadTet),
    /// Points whose every lift fails.
    Roots(Vec<Root>),
}

/// A tet whose determinant is not positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadTet {
    /// Its prism.
    pub prism: u32,
    /// Its names, ascending.
    pub names: [Name; 4],
    /// Its determinant (six times the signed volume): `mantissa * 2^exponent`.
    pub value: (IBig, i32),
}
