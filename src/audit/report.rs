//! The answer of an audit, for programs and viewers.

use serde::{Deserialize, Serialize};

use super::options::AuditOptions;
use super::point::ExactPoint;
use crate::certify::nested::ComponentFacts;

/// The verdict of an audit of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AuditVerdict {
    /// There is a certified homeomorphism from A to B (C5).
    Bijective,
    /// There is none: the topologies differ.
    NotHomeomorphic,
    /// No try led to a certificate. This proves nothing about A and B.
    NotCertified,
    /// A or B is no embedded oriented manifold, so that the question has no meaning.
    InvalidInput,
}

impl AuditVerdict {
    /// In words.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Bijective => "bijective",
            Self::NotHomeomorphic => "not homeomorphic",
            Self::NotCertified => "not certified",
            Self::InvalidInput => "invalid input",
        }
    }
}

/// An audit of a pair.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AuditReport {
    /// Version of this structure: 1.
    pub format: u32,
    /// The verdict.
    pub verdict: AuditVerdict,
    /// The verdict in a sentence, with its reason.
    pub summary: String,
    /// A and B.
    pub inputs: [InputReport; 2],
    /// Both topologies; `null` if an input is invalid.
    pub topology: Option<TopologyReport>,
    /// All tries, in order.
    pub attempts: Vec<AttemptReport>,
    /// Documents for the checkers.
    pub documents: Vec<DocumentReport>,
    /// What was asked for.
    pub options: AuditOptions,
    /// Wall-clock seconds by stage.
    pub stages: Vec<Timing>,
    /// Wall-clock seconds in all.
    pub seconds: f64,
}

/// Wall-clock time of a stage.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Timing {
    /// The stage.
    pub stage: String,
    /// Seconds.
    pub seconds: f64,
}

/// One input.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct InputReport {
    /// `A` or `B`.
    pub name: String,
    /// Its file.
    pub file: String,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Is it an embedded oriented manifold of triangles with area?
    pub valid: bool,
    /// Defects that make it invalid, every one.
    pub defects: Vec<DefectReport>,
    /// Pairs of triangles that share more than their common vertices force, every one.
    pub self_intersections: Vec<CrossingReport>,
    /// Peculiarities that are allowed (unreferenced and coincident vertices), counted.
    pub remarks: Vec<String>,
}

/// A defect.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct DefectReport {
    /// Its kind: a word of `homeo mesh-info --json`.
    pub kind: String,
    /// In words, with ids.
    pub text: String,
}

/// Two triangles of one mesh with a common point.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CrossingReport {
    /// The triangles.
    pub triangles: [u32; 2],
    /// A common point, by weights on the first triangle's corners.
    pub point: ExactPoint,
}

/// Both topologies.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct TopologyReport {
    /// Are the abstract surfaces homeomorphic?
    pub same: bool,
    /// Components of A, by smallest triangle.
    pub a: Vec<ComponentFacts>,
    /// Components of B.
    pub b: Vec<ComponentFacts>,
    /// What differs, in words.
    pub difference: Option<String>,
}

/// A file for the checkers.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct DocumentReport {
    /// Its name in the output directory.
    pub file: String,
    /// What it says.
    pub says: String,
    /// The checkers' arguments: the document, then its inputs, all in that directory.
    pub arguments: Vec<String>,
    /// Size in bytes.
    pub bytes: usize,
}

/// What became of a try.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AttemptResult {
    /// A and B are sections of the shell.
    Certified,
    /// A or B is no section of the shell.
    NotSections,
    /// There is no shell, or the certifier has no answer about it.
    NoShell,
}

/// One try.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AttemptReport {
    /// Its name: `given`, `a`, `joint-a`, `joint-b`, `thick-joint-a`, `b`.
    pub name: String,
    /// In words.
    pub text: String,
    /// What became of it.
    pub result: AttemptResult,
    /// Why there is no shell, or why the certifier has no answer.
    pub reason: Option<String>,
    /// The shell's file in the output directory.
    pub shell: Option<String>,
    /// Number of prisms.
    pub prisms: usize,
    /// Is A a section, is B? `null` if that was not decided.
    pub sections: [Option<bool>; 2],
    /// The certifier's witness for each mesh that is no section, in words.
    pub witnesses: Vec<String>,
    /// Where each mesh that is no section breaks the rules.
    pub surveys: Vec<SurveyReport>,
    /// Seconds for building the shell, certifying, and looking for all violations.
    pub seconds: [f64; 3],
}

/// All places where a mesh is no section of a shell.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SurveyReport {
    /// `A` or `B`.
    pub mesh: String,
    /// Share of the mesh's area in triangles without any violation. Computed in floating point.
    pub clean_area_share: f64,
    /// Triangles without any violation.
    pub clean_triangles: usize,
    /// Largest distance to the shell's bottom and top of a corner of a part outside, in floating point; `null` if nothing
    /// is outside.
    pub largest_distance_outside: Option<f64>,
    /// The same as a share of the diagonal of the mesh's bounding box.
    pub largest_distance_share: Option<f64>,
    /// Connected sets of violations of one kind.
    pub regions: Vec<Region>,
    /// All violations; regions name them by position.
    pub violations: Vec<Violation>,
}

/// What is wrong at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ViolationKind {
    /// The triangle is not within the shell, or touches its bottom or top.
    Outside,
    /// `n . V <= 0`.
    Fold,
    /// Two triangles over one point of the middle surface.
    CoveredTwice,
    /// No triangle that faces up over a point of the middle surface.
    NotCovered,
    /// The boundaries of mesh and shell do not match here.
    Boundary,
}

impl ViolationKind {
    /// All kinds.
    pub const ALL: [Self; 5] =
        [Self::Outside, Self::Fold, Self::CoveredTwice, Self::NotCovered, Self::Boundary];

    /// In words.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Outside => "outside the shell",
            Self::Fold => "fold",
            Self::CoveredTwice => "covered twice",
            Self::NotCovered => "not covered",
            Self::Boundary => "boundaries do not match",
        }
    }
}

/// One violation.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Violation {
    /// What is wrong.
    pub kind: ViolationKind,
    /// The triangle of the mesh; `null` where none covers.
    pub triangle: Option<u32>,
    /// The prism; `null` outside.
    pub prism: Option<u32>,
    /// The tet's names, where one is concerned.
    pub tet: Option<String>,
    /// The point on the triangle; of [`ViolationKind::NotCovered`]: on the prism's middle triangle.
    pub point: ExactPoint,
    /// Of [`ViolationKind::CoveredTwice`]: the point of the prism's middle triangle that both points are projected to.
    pub middle: Option<ExactPoint>,
    /// Of [`ViolationKind::CoveredTwice`]: the other triangle, and its point.
    pub other: Option<(u32, ExactPoint)>,
    /// Of [`ViolationKind::Fold`]: `n . V`, exactly (`mantissa*2^exponent`), and rounded (`null` beyond `f64`).
    pub value: Option<(String, Option<f64>)>,
    /// Share of the triangle's area that is outside, or of the middle triangle's that is not covered, rounded.
    pub share: Option<f64>,
    /// Details in words.
    pub text: String,
}

/// A connected set of violations of one kind.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Region {
    /// Their kind.
    pub kind: ViolationKind,
    /// Triangles of the mesh, ascending.
    pub triangles: Vec<u32>,
    /// Prisms, ascending.
    pub prisms: Vec<u32>,
    /// Positions in [`SurveyReport::violations`].
    pub violations: Vec<usize>,
}
