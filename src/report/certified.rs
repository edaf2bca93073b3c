//! The JSON form of an outcome; its schema is `schema/certify.schema.json`.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::certify::{Claim, ClaimResult, Verdict, VertexOrder};
use crate::mesh::TriMesh;
use crate::shell::Shell;

/// An outcome with its inputs, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct CertifyReport {
    /// `certified` when all requested claims are, else `refuted`.
    pub verdict: &'static str,
    /// The claims of [`Claim::STANDARD`], in this order, then `disjoint-prisms` if it was asked for.
    pub claims: Vec<ClaimReport>,
    /// The shell.
    pub shell: ShellReport,
    /// The mesh; `null` without one.
    pub mesh: Option<MeshReport>,
    /// `id` or `list`: the vertex order of `section` and `bijection`.
    pub order: &'static str,
    /// The certificate file; `null` if none was written.
    pub certificate: Option<String>,
    /// What the independent checker answered about the certificate; `null` if it was not asked.
    pub checked: Option<String>,
    /// Remarks of the readers.
    pub notes: Vec<String>,
}

/// One claim.
#[derive(Clone, Debug, Serialize)]
pub struct ClaimReport {
    /// Its name.
    pub claim: &'static str,
    /// `certified`, `refuted` or `not-run`.
    pub verdict: &'static str,
    /// Was it asked for (and not only needed for another claim)?
    pub requested: bool,
    /// Wall-clock seconds; `null` if not run.
    pub seconds: Option<f64>,
    /// Counts by name.
    pub counts: BTreeMap<&'static str, u64>,
    /// Exact predicates by the stage that decided them (of `i2`: without the hull condition); `null` for claims that were not run or only follow from
    /// another one.
    pub stages: Option<StageReport>,
    /// The parts of `disjoint`.
    pub parts: Vec<PartReport>,
    /// Witnesses in ids and exact values, at most 100.
    pub refutations: Vec<RefutationReport>,
}

/// Predicates by stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct StageReport {
    /// Floating point with a proved bound.
    pub filter: u64,
    /// Fixed-width integers.
    pub fixed_width: u64,
    /// Big integers.
    pub big_integer: u64,
}

/// One part of `disjoint`.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PartReport {
    /// What the mesh is compared with: `mesh`, `bottom` or `top`.
    pub about: &'static str,
    /// `certified` or `refuted`.
    pub verdict: &'static str,
    /// Pairs of triangles whose boxes meet.
    pub pairs: u64,
    /// Pairs that share a point which they may not share.
    pub crossings: u64,
}

/// One witness.
#[derive(Clone, Debug, Serialize)]
pub struct RefutationReport {
    /// Its kind.
    pub kind: &'static str,
    /// In words.
    pub text: String,
    /// Prisms that it names.
    pub prisms: Vec<u32>,
    /// Mesh triangles that it names.
    pub triangles: Vec<u32>,
    /// The exact value that is not positive (`mantissa*2^exponent`), where there is one.
    pub value: Option<String>,
}

/// The shell that the claims are about.
#[derive(Clone, Debug, Serialize)]
pub struct ShellReport {
    /// Its file, or its three files.
    pub files: Vec<String>,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of prisms.
    pub prisms: usize,
    /// Number of tets: 24 a prism, 8 fewer for each pinched corner.
    pub tets: usize,
    /// Number of pinched vertices.
    pub pinched: usize,
}

/// The mesh that the claims are about.
#[derive(Clone, Debug, Serialize)]
pub struct MeshReport {
    /// Its file (which may be the shell's).
    pub file: String,
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
}

impl ShellReport {
    /// The report about a shell read from these files.
    #[must_use]
    pub fn new(shell: &Shell, files: Vec<String>) -> Self {
        Self {
            files,
            vertices: shell.vertex_count(),
            prisms: shell.prism_count(),
            tets: shell.tet_count(),
            pinched: shell.pinched_vertices().len(),
        }
    }
}

impl MeshReport {
    /// The report about a mesh read from this file.
    #[must_use]
    pub fn new(mesh: &TriMesh, file: String) -> Self {
        Self { file, vertices: mesh.vertices.len(), triangles: mesh.faces.len() }
    }
}

impl ClaimReport {
    fn not_run(claim: Claim) -> Self {
        Self {
            claim: claim.name(),
            verdict: "not-run",
            requested: false,
            seconds: None,
            counts: BTreeMap::new(),
            stages: None,
            parts: Vec::new(),
            refutations: Vec::new(),
        }
    }

    fn new(result: &ClaimResult, requested: bool) -> Self {
        let mut stages = StageReport::default();
        let mut staged = false;
        let mut counts = BTreeMap::new();
        for count in &result.counts {
            let stage = match count.what {
                "decided_by_filter" => &mut stages.filter,
                "decided_by_fixed_width" => &mut stages.fixed_width,
                "decided_by_big_integer" => &mut stages.big_integer,
                what => {
                    counts.insert(what, count.count);
                    continue;
                }
            };
            *stage = count.count;
            staged = true;
        }
        Self {
            claim: result.claim.name(),
            verdict: result.verdict.word(),
            requested,
            seconds: Some(result.seconds),
            counts,
            stages: staged.then_some(stages),
            parts: parts(result),
            refutations: refutations(result),
        }
    }
}

fn parts(result: &ClaimResult) -> Vec<PartReport> {
    let report = |p: &crate::certify::Part| PartReport {
        about: p.about,
        verdict: p.verdict.word(),
        pairs: p.pairs,
        crossings: p.crossings,
    };
    result.parts.iter().map(report).collect()
}

fn refutations(result: &ClaimResult) -> Vec<RefutationReport> {
    let report = |r: &crate::certify::Refutation| RefutationReport {
        kind: r.kind,
        text: r.text.clone(),
        prisms: r.prisms.clone(),
        triangles: r.triangles.clone(),
        value: r.value.clone(),
    };
    result.refutations.iter().map(report).collect()
}

impl CertifyReport {
    /// The report about results for the `requested` claims.
    #[must_use]
    pub fn new(
        results: &[ClaimResult],
        requested: &[Claim],
        order: &VertexOrder,
        shell: ShellReport,
        mesh: Option<MeshReport>,
    ) -> Self {
        let claim = |claim: Claim| match results.iter().find(|r| r.claim == claim) {
            Some(result) => ClaimReport::new(result, requested.contains(&claim)),
            None => ClaimReport::not_run(claim),
        };
        let told = |c: &Claim| Claim::STANDARD.contains(c) || results.iter().any(|r| r.claim == *c);
        let claims: Vec<ClaimReport> = Claim::ALL.into_iter().filter(told).map(claim).collect();
        let holds = claims.iter().filter(|c| c.requested).all(|c| c.verdict == Verdict::Certified.word());
        Self {
            verdict: if holds { Verdict::Certified.word() } else { Verdict::Refuted.word() },
            claims,
            shell,
            mesh,
            order: if *order == VertexOrder::Id { "id" } else { "list" },
            certificate: None,
            checked: None,
            notes: Vec::new(),
        }
    }

    /// Are all requested claims certified?
    #[must_use]
    pub fn certified(&self) -> bool {
        self.verdict == Verdict::Certified.word()
    }
}
