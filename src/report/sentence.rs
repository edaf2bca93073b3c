//! One sentence a claim: what was proved or refuted about which files.

use crate::certify::{Claim, ClaimResult, Verdict};

/// What the inputs are called.
#[derive(Clone, Debug)]
pub struct Sources {
    /// The shell, as it should be called in a sentence.
    pub shell: String,
    /// The mesh.
    pub mesh: String,
    /// Number of prisms.
    pub prisms: usize,
    /// Number of triangles of the mesh.
    pub triangles: usize,
    /// The vertex order: `by vertex id`, or `of FILE`.
    pub order: String,
}

/// How many witnesses of a claim are listed for people; JSON has more.
const LISTED: usize = 4;

fn count(result: &ClaimResult, what: &str) -> u64 {
    result.counts.iter().find(|c| c.what == what).map_or(0, |c| c.count)
}

/// The sentence, and the first witnesses of a refutation on lines of their own.
#[must_use]
pub fn sentence(result: &ClaimResult, sources: &Sources) -> String {
    let word = match result.verdict {
        Verdict::Certified => "CERTIFIED",
        Verdict::Refuted => "REFUTED",
    };
    let said = match result.verdict {
        Verdict::Certified => certified(result, sources),
        Verdict::Refuted => refuted(result, sources),
    };
    let mut out = format!("{word:9}  {}: {said}\n", result.claim);
    for r in result.refutations.iter().take(LISTED) {
        out += &format!("             {}\n", r.text);
    }
    let hidden = result.refutations.len().saturating_sub(LISTED);
    if hidden > 0 {
        out += &format!("             and more ({hidden} further in --json, all in the certificate)\n");
    }
    out
}

fn certified(result: &ClaimResult, s: &Sources) -> String {
    let (shell, mesh, prisms, triangles, order) = (&s.shell, &s.mesh, s.prisms, s.triangles, &s.order);
    match result.claim {
        Claim::Positivity => {
            let tets = count(result, "different_tets");
            format!("all {tets} different tets of the {prisms} prisms of {shell} have positive volume.")
        }
        Claim::Section => {
            let cells = count(result, "overlay_triangles");
            format!(
                "the mesh of {mesh} ({triangles} triangles) is a section of {shell} in the vertex order {order}: it \
                 stays off bottom and top and goes up through every pillar direction ({cells} overlay triangles)."
            )
        }
        Claim::Bijection => format!(
            "in the vertex order {order} the projection is an orientation-preserving homeomorphism from the mesh of \
             {mesh} onto the middle surface of {shell}."
        ),
        Claim::SectionAllOrders => format!(
            "the mesh of {mesh} is a section of {shell}, and the projection a homeomorphism, in every vertex order."
        ),
        Claim::Disjoint => {
            let pairs = count(result, "pairs");
            format!(
                "the mesh of {mesh} does not meet itself, nor bottom and top of {shell} ({pairs} pairs of triangles \
                 with boxes that meet)."
            )
        }
        Claim::I2 => {
            let hull = if count(result, "hull_condition_holds") == 1 { "holds" } else { "does not hold" };
            format!(
                "I2 to the letter: every tet of {shell} that shares a point with a triangle of the mesh of {mesh} has \
                 a positive dot with it (the stronger hull condition {hull})."
            )
        }
    }
}

fn refuted(result: &ClaimResult, s: &Sources) -> String {
    let (shell, mesh, order) = (&s.shell, &s.mesh, &s.order);
    match result.claim {
        Claim::Positivity => {
            let (bad, tets) = (count(result, "tets_not_positive"), count(result, "different_tets"));
            let prisms = count(result, "prisms_not_positive");
            format!("{bad} of the {tets} different tets of {shell}, in {prisms} prisms, do not have positive volume.")
        }
        Claim::Section => {
            format!("the mesh of {mesh} is not a section of {shell} in the vertex order {order}.")
        }
        Claim::Bijection => format!(
            "not a section, so the projection from the mesh of {mesh} onto the middle surface of {shell} is not \
             shown to be a bijection by any lift."
        ),
        Claim::SectionAllOrders => {
            format!("there is a vertex order in which the mesh of {mesh} is not a section of {shell}.")
        }
        Claim::Disjoint => {
            let parts: Vec<String> = result
                .parts
                .iter()
                .filter(|p| p.crossings > 0)
                .map(|p| match p.about {
                    "mesh" => format!("itself ({} pairs of triangles)", p.crossings),
                    about => format!("the {about} of {shell} ({} pairs of triangles)", p.crossings),
                })
                .collect();
            format!("the mesh of {mesh} meets {}.", parts.join(", "))
        }
        Claim::I2 => format!(
            "some tet of {shell} that shares a point with a triangle of the mesh of {mesh} has a dot with it that is \
             not positive, or the mesh meets bottom or top."
        ),
    }
}
