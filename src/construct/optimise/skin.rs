//! The shell's skin (its bottom and top triangles, and the walls over boundary edges), kept free of self-intersection:
//! rule (i) of R4 in THEORY. An index finds the triangles near new ones; it reads the shell far from a change, too.

use rustc_hash::FxHashMap;

use super::grid::Grid;
use super::state::{Change, GONE, NEW, State};
use super::tree::Box3;
use crate::predicate::{Meeting, orient3d, segment_triangle, triangle_triangle};

/// A triangle of the skin.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Outside {
    /// The face whose prism it bounds from below or above; walls have none, since boundary vertices never change.
    face: u32,
    /// `3 v + layer` for each corner, layer 1 for a pinched vertex: equal for one point of the shell.
    names: [u64; 3],
    points: [[f64; 3]; 3],
}

impl Outside {
    fn bounds(&self) -> Box3 {
        Box3::of(&self.points)
    }

    /// The corners that another triangle has, too, then the others; and how many there are.
    fn shared_first(&self, other: &Self) -> ([&[f64; 3]; 3], usize) {
        let mut order = [0, 1, 2];
        let has = |k: usize| other.names.contains(&self.names[k]);
        order.sort_by_key(|&k| !has(k));
        (order.map(|k| &self.points[k]), (0..3).filter(|&k| has(k)).count())
    }

    /// Do they share only what their common corners force? Both have area.
    fn fits(&self, other: &Self) -> bool {
        let ((a, common), (b, _)) = (self.shared_first(other), other.shared_first(self));
        match common {
            0 => !triangle_triangle(a, b).meets(),
            // What else is shared is a cone at the common corner, and reaches an opposite side.
            1 => {
                beside(a, b)
                    || !segment_triangle([a[1], a[2]], b).meets()
                        && !segment_triangle([b[1], b[2]], a).meets()
            }
            // More than the common side only if they lie in one plane, on one side of it.
            2 => !orient3d(a[0], a[1], a[2], b[2]).is_zero() || triangle_triangle(a, b) <= Meeting::Segment,
            _ => false,
        }
    }
}

/// Do triangles with a common first corner meet there only, since one's plane has the other strictly on a side?
fn beside(a: [&[f64; 3]; 3], b: [&[f64; 3]; 3]) -> bool {
    let apart = |p: [&[f64; 3]; 3], q: [&[f64; 3]; 3]| {
        let side = |x| orient3d(p[0], p[1], p[2], x);
        !side(q[1]).is_zero() && side(q[1]) == side(q[2])
    };
    apart(a, b) || apart(b, a)
}

/// The index of the skin.
#[derive(Clone, Debug)]
pub(crate) struct Skin {
    grid: Grid<Outside>,
    /// Bottom and top of each face.
    of: FxHashMap<u32, [Outside; 2]>,
}

/// The skin follows from the rest of the state.
impl PartialEq for Skin {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Skin {
    /// The skin of a state. O(n log n).
    pub(crate) fn new(state: &State) -> Self {
        let live = (0u32..).zip(&state.faces).filter(|(_, face)| **face != GONE);
        let of: FxHashMap<u32, [Outside; 2]> =
            live.clone().map(|(f, face)| (f, outsides(state, f, *face, None))).collect();
        let walls = live.flat_map(|(_, face)| walls(state, *face));
        let mut grid = Grid::default();
        for outside in of.values().flatten().copied().chain(walls) {
            grid.insert(outside.bounds(), outside);
        }
        Self { grid, of }
    }

    /// Does the skin stay free of self-intersection, if it is, when the change is made?
    pub(crate) fn admits(&self, state: &State, change: &Change) -> bool {
        // A new vertex has no star yet.
        let star = change.moved.and_then(|(v, _)| state.star.get(v as usize));
        let moved = star.map_or(&[][..], |star| &star[..]);
        let gone = |f: u32| change.remove.contains(&f) || moved.contains(&f);
        let stays = moved.iter().filter(|f| !change.remove.contains(f)).map(|&f| state.faces[f as usize]);
        let faces = change.add.iter().copied().chain(stays);
        let new: Vec<Outside> = faces.flat_map(|face| outsides(state, GONE[0], face, Some(change))).collect();
        new.iter().enumerate().all(|(i, one)| {
            let bounds = one.bounds();
            let apart = |other: &Outside| !bounds.meets(&other.bounds());
            new[..i].iter().all(|other| apart(other) || one.fits(other))
                && self.grid.all(&bounds, |other| gone(other.face) || one.fits(other))
        })
    }

    /// Follows a change that the state has made to these faces; repetitions do no harm.
    pub(crate) fn update(&mut self, state: &State, faces: impl Iterator<Item = u32>) {
        for f in faces {
            let face = state.faces[f as usize];
            self.set(f, (face != GONE).then(|| outsides(state, f, face, None)));
        }
    }

    /// Are the triangles of all faces the same?
    #[cfg(test)]
    pub(crate) fn same(&self, other: &Self) -> bool {
        self.of == other.of && self.grid.len() == other.grid.len()
    }

    fn set(&mut self, f: u32, new: Option<[Outside; 2]>) {
        if self.of.get(&f).copied() == new {
            return;
        }
        let old = match new {
            Some(pair) => self.of.insert(f, pair),
            None => self.of.remove(&f),
        };
        for outside in old.into_iter().flatten() {
            self.grid.remove(outside.bounds(), outside);
        }
        for outside in new.into_iter().flatten() {
            self.grid.insert(outside.bounds(), outside);
        }
    }
}

/// The name of a vertex in a layer: 0, 1, 2 for bottom, middle, top.
fn name(state: &State, v: u32, layer: u64) -> u64 {
    3 * u64::from(v) + if v != NEW && state.pinched[v as usize] { 1 } else { layer }
}

/// The bottom and the top triangle of a face, with the pillars after a change.
fn outsides(state: &State, f: u32, face: [u32; 3], change: Option<&Change>) -> [Outside; 2] {
    let moved = change.and_then(|c| c.moved.as_ref());
    let pillars = state.prism(face, moved).pillars;
    let one = |layer: u64| Outside {
        face: f,
        names: face.map(|v| name(state, v, layer)),
        points: pillars.map(|p| if layer == 0 { p.bottom } else { p.top }),
    };
    [one(0), one(2)]
}

/// The triangles of the walls over a face's sides that no other face has: cut by the diagonal from the lower end of the
/// smaller vertex to the upper end of the larger one.
fn walls(state: &State, face: [u32; 3]) -> Vec<Outside> {
    let mut out = Vec::new();
    for [u, w] in [[0, 1], [1, 2], [2, 0]].map(|ends| ends.map(|k: usize| face[k])) {
        if state.edge(u, w).len() != 1 {
            continue;
        }
        let (u, w) = (u.min(w), u.max(w));
        for lo in [0, 1] {
            for corners in [[(u, lo), (w, lo), (w, lo + 1)], [(u, lo), (w, lo + 1), (u, lo + 1)]] {
                let names = corners.map(|(v, layer)| name(state, v, layer));
                let points = corners.map(|(v, layer)| {
                    let pillar = &state.pillars[v as usize];
                    [pillar.bottom, pillar.middle, pillar.top][layer.min(2) as usize]
                });
                if names[0] != names[1] && names[1] != names[2] && names[0] != names[2] {
                    out.push(Outside { face: GONE[0], names, points });
                }
            }
        }
    }
    out
}
