//! What an audit tries.

use std::time::Duration;

use serde::{Deserialize, Serialize};

/// A way to get a shell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Try {
    /// The shell that was given.
    Given,
    /// Around A, without looking at B.
    A,
    /// Around A, optimised so that B becomes a section, too.
    JointA,
    /// Around B, optimised so that A becomes a section, too.
    JointB,
    /// As [`Self::JointA`], twice as thick.
    ThickJointA,
    /// Around B, without looking at A.
    B,
}

impl Try {
    /// The tries that need no given shell.
    pub const ALL: [Self; 5] = [Self::A, Self::JointA, Self::JointB, Self::ThickJointA, Self::B];

    /// All of them in their usual order: around A; joint, around the mesh with fewer triangles first, since fewer pillars
    /// have to suit both; joint and thicker; around B.
    #[must_use]
    pub const fn usual(triangles_of_a: usize, triangles_of_b: usize) -> [Self; 5] {
        if triangles_of_b < triangles_of_a {
            [Self::A, Self::JointB, Self::JointA, Self::ThickJointA, Self::B]
        } else {
            Self::ALL
        }
    }

    /// The name on the command line and in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::A => "a",
            Self::JointA => "joint-a",
            Self::JointB => "joint-b",
            Self::ThickJointA => "thick-joint-a",
            Self::B => "b",
        }
    }

    /// The try of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|t| t.name() == name)
    }

    /// In words.
    #[must_use]
    pub const fn sentence(self) -> &'static str {
        match self {
            Self::Given => "the given shell",
            Self::A => "a shell around A",
            Self::JointA => "a joint shell, started around A",
            Self::JointB => "a joint shell, started around B",
            Self::ThickJointA => "a joint shell, started around A, twice as thick",
            Self::B => "a shell around B",
        }
    }
}

/// How to audit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AuditOptions {
    /// Largest thickness of each half of a shell, as a share of the longest edge of its mesh's bounding box.
    pub thickness: f64,
    /// When each optimisation stops with what it has reached. With a limit results depend on the machine.
    pub time_limit: Option<Duration>,
    /// What is tried, in this order, until a try succeeds; empty: [`Try::usual`]. A given shell comes before.
    pub tries: Vec<Try>,
    /// Is the given shell the only one to be tried?
    pub only_given: bool,
}

impl Default for AuditOptions {
    fn default() -> Self {
        Self { thickness: 0.1, time_limit: None, tries: Vec::new(), only_given: false }
    }
}

impl AuditOptions {
    /// With the tries that are made for meshes with so many triangles.
    pub(crate) fn for_pair(&self, [a, b]: [usize; 2]) -> Self {
        let tries = match &self.tries[..] {
            _ if self.only_given => Vec::new(),
            [] => Try::usual(a, b).to_vec(),
            some => some.to_vec(),
        };
        Self { tries, ..self.clone() }
    }
}
