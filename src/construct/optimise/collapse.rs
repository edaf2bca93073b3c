//! Edge collapse: one prism column instead of two.

use super::cast;
use super::energy::mips;
use super::invariants::{Judge, Suspect};
use super::limits::{Limits, distance};
use super::prism::{Pillar, Prism, direction, with_lengths};
use super::state::{Change, State};

/// Which new pillars a collapse tries, besides the two old ones.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// The shares of their length that a new pillar's halves are tried with. A thinner column fits in where a thick
    /// one folds; zooming makes it thicker later.
    shares: &'static [f64],
    /// Where between the two old pillars.
    places: &'static [f64],
}

impl Effort {
    /// Enough while there is much to collapse.
    pub(crate) const PLAIN: Self = Self { shares: &[1.0, 0.25], places: &[0.25, 0.5, 0.75] };
    /// For the last few.
    pub(crate) const HARD: Self =
        Self { shares: &[1.0, 0.5, 0.2, 0.08], places: &[0.1, 0.3, 0.4, 0.5, 0.6, 0.7, 0.9] };
}

/// A collapse that the rules allow, and the largest energy of its middle triangles.
type Rated = (f64, Change);

/// The collapse of an edge, if some new pillar keeps all invariants and rules.
pub(crate) fn propose(
    state: &State,
    judge: &Judge<'_>,
    limits: &Limits,
    effort: Effort,
    [u, w]: [u32; 2],
) -> Option<Change> {
    if !topology_allows(state, u, w) {
        return None;
    }
    let between: Vec<Pillar> = if state.is_frozen(u) || state.is_frozen(w) {
        Vec::new()
    } else {
        let ends = [u, w].map(|v| &state.pillars[v as usize]);
        effort.places.iter().map(|&t| between(judge, limits, ends, t)).collect()
    };
    let suspect = Suspect::default();
    let admits = |change: &Change| judge.admits_one_of_many(state, change, &suspect);
    for &share in effort.shares {
        let mut options = proposals(state, limits, [u, w], &between, share);
        options.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, chosen)) = options.into_iter().find(|(_, change)| admits(change)) {
            return Some(chosen);
        }
    }
    None
}

/// The collapses onto pillars between and onto both ends, with halves of a share of their length.
fn proposals(state: &State, limits: &Limits, [u, w]: [u32; 2], between: &[Pillar], share: f64) -> Vec<Rated> {
    let whole = share >= 1.0;
    let mut changes: Vec<Change> = Vec::with_capacity(between.len() + 2);
    changes.extend(between.iter().map(|p| onto(state, u, w, Some(p.scaled(share)))));
    for (from, to) in [(u, w), (w, u)] {
        // A pillar that keeps its length keeps its rounded points, too.
        let pillar = (!whole).then(|| state.pillars[to as usize].scaled(share));
        if !state.is_frozen(from) && (whole || !state.is_frozen(to)) {
            changes.push(onto(state, from, to, pillar));
        }
    }
    let sound = |change: &Change| {
        one_pinched_at_most(state, change) && change.moved.is_none_or(|(_, pillar)| pillar.is_finite())
    };
    changes
        .into_iter()
        .filter(sound)
        .filter_map(|change| Some((admissible_energy(state, limits, &change)?, change)))
        .collect()
}

/// The link condition, closed or with boundary, and valences that leave a manifold.
fn topology_allows(state: &State, u: u32, w: u32) -> bool {
    if state.is_frozen(u) && state.is_frozen(w) {
        return false;
    }
    let shared = state.edge(u, w);
    let [f, g] = shared[..] else { return false };
    let third = |f: u32| state.faces[f as usize].into_iter().find(|&v| v != u && v != w);
    let (Some(a), Some(b)) = (third(f), third(g)) else { return false };
    let (near_u, near_w) = (state.neighbours(u), state.neighbours(w));
    let common = near_u.iter().filter(|v| near_w.binary_search(v).is_ok()).count();
    // At an opposite vertex one face vanishes: three must remain around an inner one, one at the boundary.
    let enough = |v: u32| state.star[v as usize].len() > if state.boundary[v as usize] { 1 } else { 3 };
    a != b && common == 2 && enough(a) && enough(b)
}

/// The change that moves all faces of `from` to `to`, which may get a new pillar.
fn onto(state: &State, from: u32, to: u32, pillar: Option<Pillar>) -> Change {
    let remove = state.star[from as usize].clone();
    let add = remove
        .iter()
        .map(|&f| state.faces[f as usize])
        .filter(|face| !face.contains(&to))
        .map(|face| face.map(|v| if v == from { to } else { v }))
        .collect();
    Change { remove, add, moved: pillar.map(|p| (to, p)) }
}

fn one_pinched_at_most(state: &State, change: &Change) -> bool {
    change.add.iter().all(|f| f.iter().filter(|&&v| state.pinched[v as usize]).count() < 2)
}

/// The largest energy of the new middle triangles, if it is not over the limit and over what was there before.
fn admissible_energy(state: &State, limits: &Limits, change: &Change) -> Option<f64> {
    let after = worst(state.prisms(change).iter());
    if after <= limits.energy {
        return Some(after);
    }
    let old: Vec<Prism> = change.remove.iter().map(|&f| state.prism(state.faces[f as usize], None)).collect();
    (after <= worst(old.iter())).then_some(after)
}

fn worst<'p>(prisms: impl Iterator<Item = &'p Prism>) -> f64 {
    prisms.map(|p| mips(p.middle())).fold(0.0, f64::max)
}

/// A weighted mean of two pillars, its middle on the mesh, its halves of the mean lengths, capped.
fn between(judge: &Judge<'_>, limits: &Limits, [p, q]: [&Pillar; 2], t: f64) -> Pillar {
    let mean =
        |a: &[f64; 3], b: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| (1.0 - t) * a[i] + t * b[i]) };
    let (bottom, top) = (mean(&p.bottom, &q.bottom), mean(&p.top, &q.top));
    let at = mean(&p.middle, &q.middle);
    let middle = cast::middle(judge, &bottom, &top, cast::share(&bottom, &top, &at));
    let length = |end: fn(&Pillar) -> [f64; 3]| {
        let [a, b] = [p, q].map(|p| distance(&end(p), &p.middle));
        ((1.0 - t) * a + t * b).min(limits.thickness)
    };
    let along = direction(&Pillar { bottom, middle, top });
    with_lengths(&middle, &along, length(|p| p.bottom), length(|p| p.top))
}
