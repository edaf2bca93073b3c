//! One sentence a claim: what was proved or refuted about which files.

use crate::certify::{Claim, ClaimResult, Verdict};

/// What the inputs are called.
#[derive(Clone, Debug)]
pub struct Sources {
    /// The shell, as a noun phrase: `the shell FILE`.
    pub shell: String,
    /// The shell, after the mesh has been mentioned: `the shell FILE`, or `that shell` if the mesh is stored in it.
    pub that_shell: String,
    /// The mesh: `the mesh FILE`, or `the mesh stored in FILE`.
    pub mesh: String,
    /// Number of prisms.
    pub prisms: usize,
    /// Number of triangles of the mesh.
    pub triangles: usize,
    /// The vertex order: `by vertex id`, or `of FILE`.
    pub order: String,
}

impl Sources {
    /// The phrases for a shell and a mesh: their files, `None` for a mesh that is stored in the shell file.
    #[must_use]
    pub fn new(shell_file: &str, mesh_file: Option<&str>, sizes: (usize, usize), order: String) -> Self {
        let shell = format!("the shell {shell_file}");
        let (mesh, that_shell) = match mesh_file {
            None => (format!("the mesh stored in {shell_file}"), "that shell".to_owned()),
            Some(file) => (format!("the mesh {file}"), shell.clone()),
        };
        Self { shell, that_shell, mesh, prisms: sizes.0, triangles: sizes.1, order }
    }
}

/// How many witnesses of a claim are listed for people; JSON has more.
const LISTED: usize = 4;

/// Longer numbers are shortened for people; JSON and the certificate have all digits.
const DIGITS: usize = 48;

fn count(result: &ClaimResult, what: &str) -> u64 {
    result.counts.iter().find(|c| c.what == what).map_or(0, |c| c.count)
}

/// The sentence, and the first witnesses of a refutation on lines of their own.
#[must_use]
pub fn sentence(result: &ClaimResult, sources: &Sources) -> String {
    let (word, said) = match result.verdict {
        Verdict::Certified => ("CERTIFIED", certified(result, sources)),
        Verdict::Refuted => ("REFUTED", refuted(result, sources)),
    };
    let mut out = format!("{word:9}  {}: {said}\n", result.claim);
    if result.claim == Claim::Bijection && result.verdict == Verdict::Refuted {
        return out + "             (the witness is that of `section`)\n";
    }
    for r in result.refutations.iter().take(LISTED) {
        let about = r.value.as_deref().and_then(approximate);
        let about = about.map_or_else(String::new, |x| format!(", about {x:.3e}"));
        out += &format!("             {}{about}\n", shortened(&r.text));
    }
    let hidden = result.refutations.len().saturating_sub(LISTED);
    if hidden > 0 {
        out += &format!("             ... and {hidden} more in --json; all are in the certificate\n");
    }
    out
}

/// `mantissa*2^exponent` as a decimal number, for people; `None` for zero and where `f64` has no such number.
fn approximate(value: &str) -> Option<f64> {
    let (mantissa, exponent) = value.split_once("*2^").unwrap_or((value, "0"));
    let (mut x, mut exponent) = (mantissa.parse::<f64>().ok()?, exponent.parse::<i32>().ok()?);
    while exponent != 0 && x.is_normal() {
        let step = exponent.clamp(-500, 500);
        x *= 2_f64.powi(step);
        exponent -= step;
    }
    x.is_normal().then_some(x)
}

/// The text with long runs of digits cut in the middle.
fn shortened(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, digits) = rest.split_at(start);
        let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
        let (run, after) = digits.split_at(end);
        out += before;
        if run.len() > DIGITS {
            out += &format!("{}..{} ({} digits)", &run[..6], &run[run.len() - 4..], run.len());
        } else {
            out += run;
        }
        rest = after;
    }
    out + rest
}

fn certified(result: &ClaimResult, s: &Sources) -> String {
    let Sources { shell, that_shell, mesh, prisms, triangles, order } = s;
    match result.claim {
        Claim::Positivity => {
            let tets = count(result, "different_tets");
            format!("all {tets} different tets of the {prisms} prisms of {shell} have positive volume.")
        }
        Claim::Section => {
            let pieces = count(result, "overlay_triangles");
            format!(
                "{mesh} ({triangles} triangles) is a section of {that_shell} in the vertex order {order}: it stays off \
                 bottom and top and faces up in every tet ({pieces} overlay triangles)."
            )
        }
        Claim::Bijection => format!(
            "in the vertex order {order} the projection is an orientation-preserving homeomorphism from {mesh} onto \
             the middle surface of {that_shell}."
        ),
        Claim::SectionAllOrders => {
            format!(
                "in every vertex order {mesh} is a section of {that_shell} and the projection a homeomorphism."
            )
        }
        Claim::Disjoint => {
            let pairs = count(result, "pairs");
            format!(
                "{mesh} does not meet itself, nor bottom and top of {that_shell} ({pairs} pairs of triangles with boxes \
                 that meet)."
            )
        }
        Claim::DisjointPrisms => {
            let triangles = count(result, "skin_triangles");
            format!(
                "{shell} does not overlap itself: in the vertex order {order} its tets share nothing but common faces \
                 ({triangles} triangles on its outside)."
            )
        }
        Claim::I2 => {
            let hull = if count(result, "hull_condition_holds") == 1 { "holds" } else { "does not hold" };
            format!(
                "every triangle of {mesh} has a positive dot with every tet of {that_shell} that it shares a point with \
                 (the stronger hull condition {hull})."
            )
        }
    }
}

fn refuted(result: &ClaimResult, s: &Sources) -> String {
    let Sources { shell, that_shell, mesh, order, .. } = s;
    match result.claim {
        Claim::Positivity => {
            let (bad, tets) = (count(result, "tets_not_positive"), count(result, "different_tets"));
            let prisms = count(result, "prisms_not_positive");
            format!(
                "{bad} of the {tets} different tets of {shell}, in {prisms} prisms, do not have positive volume."
            )
        }
        Claim::Section => format!("{mesh} is not a section of {that_shell} in the vertex order {order}."),
        Claim::Bijection => format!(
            "not a section, so in the vertex order {order} no lift projects {mesh} onto the middle surface of \
             {that_shell} as the claim demands."
        ),
        Claim::SectionAllOrders => {
            format!("there is a vertex order in which {mesh} is not a section of {that_shell}.")
        }
        Claim::Disjoint => {
            let crossed = result.parts.iter().filter(|p| p.crossings > 0).map(|p| match p.about {
                "mesh" => format!("itself ({} pairs of triangles)", p.crossings),
                about => format!("the {about} of {that_shell} ({} pairs of triangles)", p.crossings),
            });
            format!("{mesh} meets {}.", crossed.collect::<Vec<_>>().join(" and "))
        }
        Claim::DisjointPrisms => {
            format!(
                "{shell} overlaps itself: in the vertex order {order} two of its tets share more than a face."
            )
        }
        Claim::I2 => match result.refutations.first().map(|r| r.kind) {
            Some("contact") => format!(
                "a triangle of {mesh} shares a point with a tet of {that_shell} and has a dot with it that is not \
                 positive."
            ),
            _ => format!("{mesh} and {that_shell} do not satisfy I2, which includes a claim refuted above."),
        },
    }
}
