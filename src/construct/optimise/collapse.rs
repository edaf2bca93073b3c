//! Edge collapse: one prism column instead of two.

use super::cast::middle;
use super::energy::mips;
use super::invariants::Judge;
use super::limits::Limits;
use super::prism::{Pillar, Prism};
use super::state::{Change, State};

/// Collapses the edge if some place for the new pillar keeps all invariants and rules. Returns the vertex that stays.
pub(crate) fn collapse(state: &mut State, judge: &Judge<'_>, limits: &Limits, [u, w]: [u32; 2]) -> Option<u32> {
    if !topology_allows(state, u, w) {
        return None;
    }
    // Energy, the vertex that stays, the change.
    let mut options: Vec<(f64, u32, Change)> = Vec::with_capacity(3);
    let mut offer = |stays: u32, change: Change| {
        if !one_pinched_at_most(state, &change) {
            return;
        }
        if let Some(energy) = admissible_energy(state, limits, &change) {
            options.push((energy, stays, change));
        }
    };
    if !state.is_frozen(u) && !state.is_frozen(w) {
        let pillar = halfway(judge, limits, &state.pillars[u as usize], &state.pillars[w as usize]);
        if pillar.is_finite() {
            offer(w, onto(state, u, w, Some(pillar)));
        }
    }
    for (from, to) in [(u, w), (w, u)] {
        if !state.is_frozen(from) {
            offer(to, onto(state, from, to, None));
        }
    }
    options.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (_, stays, change) =
        options.into_iter().find(|(_, _, change)| judge.admits(&state.prisms(change)))?;
    state.apply(&change);
    Some(stays)
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

/// The mean of two pillars, its middle on the mesh.
fn halfway(judge: &Judge<'_>, limits: &Limits, p: &Pillar, q: &Pillar) -> Pillar {
    let mean = |a: &[f64; 3], b: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| 0.5 * a[i] + 0.5 * b[i]) };
    let (bottom, top) = (mean(&p.bottom, &q.bottom), mean(&p.top, &q.top));
    let at = mean(&p.middle, &q.middle);
    let share = super::cast::share(&bottom, &top, &at);
    let middle = middle(judge, &bottom, &top, share);
    limits.capped(Pillar { bottom, middle, top })
}
