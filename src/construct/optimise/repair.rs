//! Joint shells: pillars and splits that lower the partner's violation.

use super::cast;
use super::invariants::Suspect;
use super::limits::distance;
use super::operation::Rules;
use super::partner::Partner;
use super::prism::{Pillar, Prism, direction, with_lengths};
use super::split;
use super::state::{Change, State};
use crate::construct::direction::{most_normal, unit};

/// The shares of their lengths that the halves are tried with.
const SHARES: [f64; 6] = [1.0, 1.3, 2.0, 3.0, 0.7, 0.4];
/// The shares of the way to a neighbour that a middle is tried at.
const STEPS: [f64; 2] = [0.1, 0.3];
/// How much a split may raise the violation for the time being: it has twice the prisms.
const FOR_NOW: f64 = 2.5;

/// The vertex with the pillar, of those tried, that lowers the violation of its star most and is admitted.
pub(crate) fn propose(state: &State, rules: &Rules<'_>, v: u32) -> Option<Change> {
    let partner = rules.judge.partner.as_ref()?;
    if state.star[v as usize].is_empty() || state.is_frozen(v) {
        return None;
    }
    let star = star(state, v);
    let before = partner.violation(&star);
    if before <= 0.0 {
        return None;
    }
    let mut better: Vec<(f64, Change)> = Vec::new();
    for pillar in pillars(state, rules, partner, v, &star) {
        let change = Change { moved: Some((v, pillar)), ..Change::default() };
        let after = state.prisms(&change);
        if pillar.is_finite() && after.iter().all(Prism::is_positive) {
            let now = partner.violation(&after);
            if now < before {
                better.push((now, change));
            }
        }
    }
    better.sort_by(|a, b| a.0.total_cmp(&b.0));
    let suspect = Suspect::default();
    let admits = |change: &Change| rules.judge.admits_one_of_many(state, change, &suspect);
    better.into_iter().map(|(_, change)| change).find(admits)
}

fn star(state: &State, v: u32) -> Vec<Prism> {
    state.star[v as usize].iter().map(|&f| state.prism(state.faces[f as usize], None)).collect()
}

/// Pillars for a vertex: other directions, other lengths, other places.
fn pillars(state: &State, rules: &Rules<'_>, partner: &Partner<'_>, v: u32, star: &[Prism]) -> Vec<Pillar> {
    let old = state.pillars[v as usize];
    let directions = directions(state, rules, partner, v, star);
    let lengths = [distance(&old.bottom, &old.middle), distance(&old.top, &old.middle)];
    let capped = |length: f64, share: f64| (length * share).min(rules.limits.thickness);
    let mut out = Vec::new();
    for d in &directions {
        for down in SHARES {
            for up in SHARES {
                let [down, up] = [capped(lengths[0], down), capped(lengths[1], up)];
                out.push(with_lengths(&old.middle, d, down, up));
            }
        }
    }
    for w in state.neighbours(v) {
        let q = state.pillars[w as usize].middle;
        for (step, d) in STEPS.iter().flat_map(|s| directions.iter().map(move |d| (s, d))) {
            let at = std::array::from_fn(|i| old.middle[i] + step * (q[i] - old.middle[i]));
            let guess = with_lengths(&at, d, lengths[0], lengths[1]);
            let share = lengths[0] / (lengths[0] + lengths[1]);
            let middle = cast::middle(&rules.judge, &guess.bottom, &guess.top, share);
            out.push(with_lengths(&middle, d, lengths[0], lengths[1]));
        }
    }
    out
}

/// Directions for a pillar: as it is, that of its neighbours, and those that suit the triangles of both meshes, or of
/// the partner, in its prisms.
fn directions(
    state: &State,
    rules: &Rules<'_>,
    partner: &Partner<'_>,
    v: u32,
    star: &[Prism],
) -> Vec<[f64; 3]> {
    let old = direction(&state.pillars[v as usize]);
    let sum = |a: &[f64; 3], b: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| a[i] + b[i]) };
    let around = state.neighbours(v).into_iter().map(|w| direction(&state.pillars[w as usize]));
    let mut out = vec![old, unit(around.fold(old, |s, d| sum(&s, &d)))];
    let theirs = partner.normals_in(star);
    let both: Vec<[f64; 3]> = rules.judge.normals_in(star).into_iter().chain(theirs.clone()).collect();
    for d in [both, theirs].iter().filter_map(|normals| most_normal(normals)) {
        out.extend([d, unit(sum(&d, &old))]);
    }
    out
}

/// Is the edge at a prism that violates the partner?
pub(crate) fn is_wanted(state: &State, partner: &Partner<'_>, [u, w]: [u32; 2]) -> bool {
    let prisms: Vec<Prism> =
        state.edge(u, w).iter().map(|&f| state.prism(state.faces[f as usize], None)).collect();
    partner.violation(&prisms) > 0.0
}

/// A split that makes room for repairs: all invariants keep; the violation may rise for the time being.
pub(crate) fn split(state: &State, rules: &Rules<'_>, [u, w]: [u32; 2]) -> Option<Change> {
    let partner = rules.judge.partner.as_ref()?;
    split::worst(state, u, w)?;
    let shares = [1.0, 0.75, 0.5, 0.35, 0.25];
    let mut options: Vec<(f64, Change)> = shares
        .into_iter()
        .filter_map(|share| split::at_middle(state, &rules.judge, &rules.limits, [u, w], share))
        .map(|change| (partner.violation(&state.prisms(&change)), change))
        .collect();
    options.sort_by(|a, b| a.0.total_cmp(&b.0));
    let before = partner.violation(&state.prisms_before(&options.first()?.1));
    let bearable = options.into_iter().filter(|(now, _)| before > 0.0 && *now <= FOR_NOW * before);
    bearable.map(|(_, change)| change).find(|change| rules.judge.keeps(state, change))
}
