//! Verdicts with counts, and witnesses in words.

use std::collections::BTreeSet;

use super::claim::{Claim, Part, Verdict};
use super::lift::Lift;
use super::orders::AllOrders;
use super::proof::{ClaimResult, Count, Facts, Implied, Refutation, Seconds};
use super::section::Section;
use super::witness::{Branch, Ending, NoLift};
use super::write;
use crate::predicate::StageCounts;
use crate::shell::{Layer, Shell};

/// The result of a claim, of which the verdict is known.
pub(super) fn result(
    shell: &Shell,
    claim: Claim,
    verdict: Verdict,
    facts: &Facts,
    seconds: &Seconds,
) -> ClaimResult {
    let mut out = ClaimResult {
        claim,
        verdict,
        seconds: seconds.total(claim),
        counts: Vec::new(),
        parts: Vec::new(),
        refutations: Vec::new(),
    };
    match claim {
        Claim::Positivity => positivity_result(shell, facts, &mut out),
        Claim::Section | Claim::Bijection => section_result(facts, &mut out),
        Claim::SectionAllOrders => all_orders_result(facts, &mut out),
        Claim::Disjoint => disjoint_result(facts, &mut out),
        Claim::I2 => i2_result(facts, &mut out),
        Claim::DisjointPrisms => prisms_result(facts, &mut out),
    }
    out
}

impl ClaimResult {
    fn count(&mut self, what: &'static str, count: usize) {
        self.counts.push(Count { what, count: count as u64 });
    }

    fn stages(&mut self, stages: &StageCounts) {
        let parts = [
            ("decided_by_filter", stages.filter),
            ("decided_by_fixed_width", stages.fixed),
            ("decided_by_big_integer", stages.big),
        ];
        self.counts.extend(parts.map(|(what, count)| Count { what, count }));
    }

    fn refute(&mut self, kind: &'static str, text: String, prisms: Vec<u32>, triangles: Vec<u32>) {
        self.refutations.push(Refutation { kind, text, prisms, triangles, value: None });
    }

    fn implied(&mut self, by: Claim) {
        self.refute(by.name(), format!("it rests on `{by}`, which is refuted"), Vec::new(), Vec::new());
    }
}

fn positivity_result(shell: &Shell, facts: &Facts, out: &mut ClaimResult) {
    let Some(found) = &facts.positivity else { return };
    let prisms: BTreeSet<u32> = found.bad.iter().map(|b| b.prism).collect();
    out.count("tets", shell.tet_count());
    out.count("different_tets", usize::try_from(found.stages.total()).unwrap_or(usize::MAX));
    out.count("tets_not_positive", found.bad.len());
    out.count("prisms_not_positive", prisms.len());
    out.stages(&found.stages);
    for bad in found.bad.iter().take(Refutation::LISTED) {
        let value = write::value(&bad.value);
        let tet = write::names(&bad.names);
        out.refute(
            "tet",
            format!("tet {tet} of prism {} has determinant {value}", bad.prism),
            vec![bad.prism],
            Vec::new(),
        );
        out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
    }
}

fn section_result(facts: &Facts, out: &mut ClaimResult) {
    match &facts.section {
        Some(Section::Certified(lifts)) => {
            out.count("components", lifts.len());
            out.count("overlay_cells", lifts.iter().map(|l| l.pieces.len()).sum());
            let triangles = |l: &Lift| l.corners.len().saturating_sub(2 * l.pieces.len());
            out.count("overlay_triangles", lifts.iter().map(triangles).sum());
        }
        Some(Section::Refuted(witness)) => no_lift(witness, "", out),
        None => return,
    }
    out.stages(&facts.section_stages);
}

/// A witness against every lift, in words. "Not a section" is what it shows, never "not bijective".
fn no_lift(witness: &NoLift, under: &str, out: &mut ClaimResult) {
    match witness {
        NoLift::Components { mesh, middle } => out.refute(
            "components",
            format!("the mesh has {mesh} components, the middle surface {middle}: no homeomorphism exists"),
            Vec::new(),
            Vec::new(),
        ),
        NoLift::Euler { mesh, middle } => out.refute(
            "euler",
            format!("Euler characteristic {mesh} of the mesh, {middle} of the middle surface: no homeomorphism exists"),
            Vec::new(),
            Vec::new(),
        ),
        NoLift::Tet(bad) => {
            let (tet, value) = (write::names(&bad.names), write::value(&bad.value));
            let text = format!("not a section: tet {tet} of prism {} has determinant {value}{under}", bad.prism);
            out.refute("tet", text, vec![bad.prism], Vec::new());
            out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
        }
        NoLift::Roots(roots) => {
            for root in roots {
                let [a, b, c] = &root.weights;
                let at = format!("point {a}:{b}:{c} of mesh triangle {}", root.face);
                if root.branches.is_empty() {
                    let text = format!("not a section: {at} lies outside the shell{under}");
                    out.refute("outside", text, Vec::new(), vec![root.face]);
                }
                for branch in &root.branches {
                    let last = branch.legs.last().and_then(|l| l.steps.last());
                    let face = last.map_or(root.face, |s| s.face);
                    let text = format!("not a section: {}{under}", branch_text(&at, branch, face));
                    out.refute(branch.ending.word(), text, Vec::new(), vec![face]);
                }
            }
        }
    }
}

/// What is wrong with one lift of a root point, in words.
fn branch_text(at: &str, branch: &Branch, face: u32) -> String {
    let steps = branch.legs.iter().map(|l| l.steps.len()).max().unwrap_or(0);
    let carrier = write::names(&branch.carrier);
    let last = branch.legs.last().and_then(|l| l.steps.last());
    let tet = last.map(|s| s.tet).or_else(|| branch.legs.first().map(|l| l.start));
    let tet = tet.map_or_else(String::new, |t| write::names(&t));
    let way = match steps {
        0 => at.to_owned(),
        _ => format!("{at}, lifted to {carrier} and followed for {steps} steps to mesh triangle {face},"),
    };
    match branch.ending {
        Ending::Cap if steps == 0 => {
            let layer = if branch.carrier.iter().any(|n| n.layer == Layer::Top) { "top" } else { "bottom" };
            format!("{way} leaves the shell through the {layer} at {carrier}")
        }
        Ending::Cap => format!("{way} leaves the shell through bottom or top of tet {tet}"),
        Ending::Wall => {
            format!("{way} lies on a boundary wall of the shell, in tet {tet}, but inside the mesh")
        }
        Ending::Boundary => {
            format!("{way} is on the boundary of the mesh, but inside the shell, in tet {tet}")
        }
        Ending::Fold => format!("mesh triangle {face} does not face up in tet {tet}: n . V <= 0 at {way}"),
        Ending::Lands => format!("{way} lifts to tet {tet}, onto a component that another one needs"),
        Ending::Twice => format!("{way} and another point of the mesh have one image"),
        Ending::Monodromy => format!("{way} comes back in another tet, {tet}: the lift is not single-valued"),
    }
}

fn all_orders_result(facts: &Facts, out: &mut ClaimResult) {
    match &facts.all_orders {
        Some(Implied::Decided(AllOrders::Certified(stats))) => {
            out.counts.push(Count { what: "piece_prism_pairs", count: stats.pairs });
            out.counts.push(Count { what: "pairs_with_exact_test", count: stats.exceptions });
            out.stages(&stats.stages);
        }
        Some(Implied::Decided(AllOrders::Refuted { first, witness, stats })) => {
            out.stages(&stats.stages);
            let ids: Vec<String> = first.iter().map(ToString::to_string).collect();
            no_lift(witness, &format!(", in the vertex order that begins {}", ids.join(" ")), out);
        }
        Some(Implied::Refuted(by)) => out.implied(*by),
        None => {}
    }
}

fn disjoint_result(facts: &Facts, out: &mut ClaimResult) {
    let Some(found) = &facts.disjoint else { return };
    for (about, part) in ["mesh", "bottom", "top"].into_iter().zip(found) {
        out.parts.push(Part {
            about,
            verdict: Verdict::of(part.crossings.is_empty()),
            pairs: part.pairs,
            crossings: part.crossings.len() as u64,
        });
        for c in part.crossings.iter().take(Refutation::LISTED) {
            let (other, prisms, triangles) = match about {
                "mesh" => (format!("mesh triangle {}", c.second), Vec::new(), vec![c.first, c.second]),
                _ => (format!("the {about} of prism {}", c.second), vec![c.second], vec![c.first]),
            };
            let [a, b, d] = &c.in_first;
            let text = format!("mesh triangle {} meets {other} at its point {a}:{b}:{d}", c.first);
            out.refute("crossing", text, prisms, triangles);
        }
    }
    out.count("pairs", found.iter().map(|p| usize::try_from(p.pairs).unwrap_or(0)).sum());
    out.count("pairs_with_stated_planes", found.iter().map(|p| p.separations.len()).sum());
    out.stages(&found.iter().map(|p| p.stages).sum());
}

fn i2_result(facts: &Facts, out: &mut ClaimResult) {
    match &facts.contacts {
        Some(Implied::Decided(found)) => {
            out.counts.extend([
                Count { what: "triangle_prism_pairs", count: found.pairs },
                Count { what: "pairs_with_positive_dots", count: found.all_positive },
                Count { what: "triangle_tet_pairs_separated", count: found.tet_pairs },
                Count { what: "hull_condition_holds", count: u64::from(found.hull_condition) },
            ]);
            out.count("pairs_with_stated_planes", found.separations.len());
            out.count("contacts", found.contacts.len());
            out.stages(&found.stages);
            for c in found.contacts.iter().take(Refutation::LISTED) {
                let value = write::value(&c.value);
                let tet = write::names(&c.names);
                let text = format!(
                    "mesh triangle {} touches tet {tet} of prism {} with dot {value}",
                    c.face, c.prism
                );
                out.refute("contact", text, vec![c.prism], vec![c.face]);
                out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
            }
        }
        Some(Implied::Refuted(by)) => out.implied(*by),
        None => {}
    }
}

fn prisms_result(facts: &Facts, out: &mut ClaimResult) {
    let Some(found) = &facts.prisms else { return };
    out.stages(&found.stages);
    if let Some(bad) = &found.bad {
        let (tet, value) = (write::names(&bad.names), write::value(&bad.value));
        let text = format!("tet {tet} of prism {} has determinant {value}", bad.prism);
        out.refute("tet", text, vec![bad.prism], Vec::new());
        out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
        return;
    }
    out.count("skin_triangles", found.skin);
    out.count("pairs", usize::try_from(found.pairs).unwrap_or(usize::MAX));
    out.count("pairs_with_stated_planes", found.separations.len());
    out.count("overlaps", found.overlaps.len());
    for overlap in found.overlaps.iter().take(Refutation::LISTED) {
        let ([a, b], [p, q]) = (overlap.tets.each_ref().map(|t| write::names(t)), overlap.prisms);
        let text = format!("tet {a} of prism {p} and tet {b} of prism {q} share more than a face");
        out.refute("overlap", text, vec![p, q], Vec::new());
    }
}
