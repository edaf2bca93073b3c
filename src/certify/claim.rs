//! Names of claims and verdicts.

use std::fmt;

/// A claim of THEORY section 2, as far as it is about one shell and one mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Claim {
    /// C1: all 24 tets of every prism are positive.
    Positivity,
    /// C2: a lift of the mesh is a section of the shell.
    Section,
    /// C4: the projection is a homeomorphism from the mesh onto the middle surface.
    Bijection,
    /// C3: C2 and C4 for every vertex order.
    SectionAllOrders,
    /// C6: the mesh has no self-intersection and meets neither bottom nor top.
    Disjoint,
    /// C3+: *I2* of *Shell* to the letter.
    I2,
    /// The tets of one vertex order share nothing but common faces: the shell does not overlap itself.
    DisjointPrisms,
}

impl Claim {
    /// The claims that are decided when nothing else is asked for: all but [`Self::DisjointPrisms`], which shells around
    /// meshes with close sheets fail without harm to the others.
    pub const STANDARD: [Self; 6] =
        [Self::Positivity, Self::Section, Self::Bijection, Self::SectionAllOrders, Self::Disjoint, Self::I2];

    /// All claims, in the order of certificates.
    pub const ALL: [Self; 7] = [
        Self::Positivity,
        Self::Section,
        Self::Bijection,
        Self::SectionAllOrders,
        Self::Disjoint,
        Self::I2,
        Self::DisjointPrisms,
    ];

    /// Is it about a shell and a mesh, not a shell alone?
    #[must_use]
    pub const fn needs_mesh(self) -> bool {
        !matches!(self, Self::Positivity | Self::DisjointPrisms)
    }

    /// The name in THEORY, on the command line and in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Positivity => "positivity",
            Self::Section => "section",
            Self::Bijection => "bijection",
            Self::SectionAllOrders => "section-all-orders",
            Self::Disjoint => "disjoint",
            Self::I2 => "i2",
            Self::DisjointPrisms => "disjoint-prisms",
        }
    }

    /// The claim of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|c| c.name() == name)
    }

    /// The claims that a proof or refutation of this one rests on, itself included.
    #[must_use]
    pub const fn with_prerequisites(self) -> &'static [Self] {
        match self {
            Self::Positivity => &[Self::Positivity],
            Self::Section | Self::Bijection => &[Self::Section, Self::Bijection],
            Self::SectionAllOrders => {
                &[Self::Positivity, Self::Section, Self::Bijection, Self::SectionAllOrders]
            }
            Self::Disjoint => &[Self::Disjoint],
            Self::I2 => &Self::STANDARD,
            Self::DisjointPrisms => &[Self::DisjointPrisms],
        }
    }
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The answer to a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Proved.
    Certified,
    /// Disproved.
    Refuted,
}

impl Verdict {
    /// `certified` or `refuted`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Certified => "certified",
            Self::Refuted => "refuted",
        }
    }

    pub(crate) const fn of(holds: bool) -> Self {
        if holds { Self::Certified } else { Self::Refuted }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// One of the parts of [`Claim::Disjoint`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// `mesh`, `bottom` or `top`: what the mesh is compared with.
    pub about: &'static str,
    /// The verdict.
    pub verdict: Verdict,
    /// Pairs of triangles whose boxes meet.
    pub pairs: u64,
    /// Pairs that share a point which they may not share.
    pub crossings: u64,
}
