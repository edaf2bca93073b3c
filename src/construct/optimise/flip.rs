//! Edge flip: the other diagonal of two prisms.

use super::energy::mips;
use super::invariants::Judge;
use super::state::{Change, State};

/// The valences that a flip may leave: at least, at most.
const VALENCE: [usize; 2] = [4, 9];

/// The flip of an edge, if it lowers the largest energy of its two triangles, and all invariants and rules keep.
pub(crate) fn propose(state: &State, judge: &Judge<'_>, [u, w]: [u32; 2]) -> Option<Change> {
    let change = flipped(state, u, w)?;
    let worst =
        |faces: &[[u32; 3]]| faces.iter().map(|f| mips(state.prism(*f, None).middle())).fold(0.0, f64::max);
    let old: Vec<[u32; 3]> = change.remove.iter().map(|&f| state.faces[f as usize]).collect();
    (worst(&change.add) < worst(&old) && judge.admits(state, &change)).then_some(change)
}

/// The flipped faces, where the complex allows a flip.
fn flipped(state: &State, u: u32, w: u32) -> Option<Change> {
    let shared = state.edge(u, w);
    let [f, g] = shared[..] else { return None };
    // The face in which the edge runs from u to w, and the other one.
    let runs = |f: u32| (0..3).find(|&i| state.faces[f as usize][i] == u).map(|i| (f, i));
    let [(f, i), (g, j)] = [runs(f)?, runs(g)?];
    let ((f, i), (g, j)) =
        if state.faces[f as usize][(i + 1) % 3] == w { ((f, i), (g, j)) } else { ((g, j), (f, i)) };
    let a = state.faces[f as usize][(i + 2) % 3];
    let b = state.faces[g as usize][(j + 1) % 3];
    let pinched = |v: u32| state.pinched[v as usize];
    if a == b || !state.edge(a, b).is_empty() || (pinched(a) && (pinched(b) || pinched(u) || pinched(w))) {
        return None;
    }
    let valence = |v: u32| state.star[v as usize].len();
    let loses = |v: u32| state.boundary[v as usize] && valence(v) > 1 || valence(v) > VALENCE[0];
    let gains = |v: u32| valence(v) < VALENCE[1];
    if !(loses(u) && loses(w) && gains(a) && gains(b)) {
        return None;
    }
    Some(Change { remove: vec![f, g], add: vec![[a, u, b], [b, w, a]], moved: None })
}
