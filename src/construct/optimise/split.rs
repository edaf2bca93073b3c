//! Edge split: a new pillar at the middle of an edge, four prisms instead of two.
//!
//! The passes of the paper need none. It helps where a pillar is stuck at a small thickness: among smaller prisms it has
//! room to grow, and the coarsening of the next repeat takes away again what is not needed.

use super::cast;
use super::energy::mips;
use super::invariants::{Judge, Suspect};
use super::limits::{Limits, distance};
use super::prism::{Pillar, Prism, direction, with_lengths};
use super::state::{Change, NEW, State};

/// The shares of the mean length of its neighbours that a new pillar's halves are tried with.
const SHARES: [f64; 3] = [1.0, 0.5, 0.25];

/// A pillar half shorter than this share of the largest thickness is thin. Chosen by measuring: with 0.1 hardly
/// anything is thin, with 0.4 there are noticeably more prisms at the end.
const THIN: f64 = 0.2;

/// Is there reason to split the edge: a triangle of too high energy, or a thin end?
pub(crate) fn is_wanted(state: &State, limits: &Limits, [u, w]: [u32; 2]) -> bool {
    let thin = |v: u32| thickness(&state.pillars[v as usize]) < THIN * limits.thickness;
    worst(state, u, w).is_some_and(|energy| energy > limits.energy || thin(u) || thin(w))
}

/// The shorter half.
fn thickness(pillar: &Pillar) -> f64 {
    distance(&pillar.bottom, &pillar.middle).min(distance(&pillar.top, &pillar.middle))
}

/// The split of an edge, if all invariants and rules keep, and it lowers the largest energy of the middle triangles, or
/// makes a pillar thicker than that of the thinner end while the energy stays below the limit.
pub(crate) fn propose(state: &State, judge: &Judge<'_>, limits: &Limits, [u, w]: [u32; 2]) -> Option<Change> {
    let before = worst(state, u, w)?;
    let thin =
        [u, w].map(|v| thickness(&state.pillars[v as usize])).into_iter().fold(f64::INFINITY, f64::min);
    let suspect = Suspect::default();
    SHARES.iter().find_map(|&share| {
        let change = at_middle(state, judge, limits, [u, w], share)?;
        let after = energy(&state.prisms(&change));
        let thicker = change.moved.is_some_and(|(_, pillar)| thickness(&pillar) > thin);
        let better = after < before || after <= limits.energy && thin < THIN * limits.thickness && thicker;
        (better && judge.admits_one_of_many(state, &change, &suspect)).then_some(change)
    })
}

fn energy(prisms: &[Prism]) -> f64 {
    prisms.iter().map(|p| mips(p.middle())).fold(0.0, f64::max)
}

/// The largest energy of the triangles at an edge that may be split.
pub(crate) fn worst(state: &State, u: u32, w: u32) -> Option<f64> {
    if state.is_frozen(u) || state.is_frozen(w) || !state.has_room() {
        return None;
    }
    let [f, g] = state.edge(u, w)[..] else { return None };
    Some(energy(&[f, g].map(|f| state.prism(state.faces[f as usize], None))))
}

/// The split with a new pillar at the middle of the edge, its halves a share of the mean of its ends'.
pub(crate) fn at_middle(
    state: &State,
    judge: &Judge<'_>,
    limits: &Limits,
    [u, w]: [u32; 2],
    share: f64,
) -> Option<Change> {
    let [f, g] = state.edge(u, w)[..] else { return None };
    let pillar = mean(judge, limits, [u, w].map(|v| &state.pillars[v as usize]), share);
    let half = |face: u32, from: u32| state.faces[face as usize].map(|v| if v == from { NEW } else { v });
    let add = vec![half(f, u), half(g, u), half(f, w), half(g, w)];
    pillar.is_finite().then(|| Change { remove: vec![f, g], add, moved: Some((NEW, pillar)) })
}

/// The mean of two pillars, its middle on the mesh.
fn mean(judge: &Judge<'_>, limits: &Limits, [p, q]: [&Pillar; 2], share: f64) -> Pillar {
    let mean = |a: &[f64; 3], b: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| 0.5 * a[i] + 0.5 * b[i]) };
    let (bottom, top) = (mean(&p.bottom, &q.bottom), mean(&p.top, &q.top));
    let guess = cast::share(&bottom, &top, &mean(&p.middle, &q.middle));
    let middle = cast::middle(judge, &bottom, &top, guess);
    let length = |end: fn(&Pillar) -> [f64; 3]| {
        let [a, b] = [p, q].map(|p| distance(&end(p), &p.middle));
        share * (0.5 * (a + b)).min(limits.thickness)
    };
    let along = direction(&Pillar { bottom, middle, top });
    with_lengths(&middle, &along, length(|p| p.bottom), length(|p| p.top))
}
