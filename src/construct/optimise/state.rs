//! The shell under optimisation: faces of the middle complex, stars of its vertices, pillars.

use super::prism::{Pillar, Prism};
use super::skin::Skin;
use crate::mesh::Connectivity;
use crate::shell::Shell;

/// A face that is no more.
pub(crate) const GONE: [u32; 3] = [u32::MAX; 3];

/// The shell under optimisation. Vertices and faces keep their ids; removed ones have an empty star or are [`GONE`].
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) pillars: Vec<Pillar>,
    pub(crate) pinched: Vec<bool>,
    pub(crate) boundary: Vec<bool>,
    /// The faces at every vertex, in no order.
    pub(crate) star: Vec<Vec<u32>>,
    /// How many faces there are.
    pub(crate) live: usize,
    /// How many changes were made.
    pub(crate) clock: u64,
    /// Per vertex the number of the last change to its pillar or star.
    pub(crate) changed: Vec<u64>,
    /// The skin, where it must stay free of self-intersection.
    pub(crate) skin: Option<Skin>,
}

/// A replacement of faces by no more faces, and of at most one pillar by another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Change {
    pub(crate) remove: Vec<u32>,
    pub(crate) add: Vec<[u32; 3]>,
    pub(crate) moved: Option<(u32, Pillar)>,
}

impl State {
    /// The state of a shell; `connectivity` is that of its middle complex.
    pub(crate) fn new(shell: &Shell, connectivity: &Connectivity) -> Self {
        let n = shell.middle.len();
        let pillar =
            |v: usize| Pillar { bottom: shell.bottom[v], middle: shell.middle[v], top: shell.top[v] };
        let pillars: Vec<Pillar> = (0..n).map(pillar).collect();
        let mut star = vec![Vec::new(); n];
        for (f, face) in (0u32..).zip(&shell.faces) {
            for &v in face {
                star[v as usize].push(f);
            }
        }
        let mut boundary = vec![false; n];
        for side in connectivity.boundary() {
            for v in connectivity.ends(side) {
                boundary[v as usize] = true;
            }
        }
        let pinched = pillars.iter().map(Pillar::is_pinched).collect();
        Self {
            faces: shell.faces.clone(),
            pillars,
            pinched,
            boundary,
            star,
            live: shell.faces.len(),
            clock: 0,
            changed: vec![0; n],
            skin: None,
        }
    }

    /// The shell, ids closed up in ascending order.
    pub(crate) fn shell(&self) -> Shell {
        let mut new_id = vec![u32::MAX; self.pillars.len()];
        let mut out = Shell::default();
        for (v, pillar) in self.pillars.iter().enumerate().filter(|(v, _)| !self.star[*v].is_empty()) {
            new_id[v] = u32::try_from(out.middle.len()).unwrap_or(u32::MAX);
            out.bottom.push(pillar.bottom);
            out.middle.push(pillar.middle);
            out.top.push(pillar.top);
        }
        out.faces =
            self.faces.iter().filter(|f| **f != GONE).map(|f| f.map(|v| new_id[v as usize])).collect();
        out
    }

    /// May the vertex neither move nor vanish?
    pub(crate) fn is_frozen(&self, v: u32) -> bool {
        self.pinched[v as usize] || self.boundary[v as usize]
    }

    /// The neighbours of a vertex, ascending.
    pub(crate) fn neighbours(&self, v: u32) -> Vec<u32> {
        let mut out: Vec<u32> =
            self.star[v as usize].iter().flat_map(|&f| self.faces[f as usize]).filter(|&w| w != v).collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// The faces at an edge, at most two.
    pub(crate) fn edge(&self, u: u32, w: u32) -> Vec<u32> {
        self.star[u as usize].iter().copied().filter(|&f| self.faces[f as usize].contains(&w)).collect()
    }

    /// All edges `[u, w]`, `u < w`, ascending.
    pub(crate) fn edges(&self) -> Vec<[u32; 2]> {
        let mut out: Vec<[u32; 2]> = self
            .faces
            .iter()
            .filter(|f| **f != GONE)
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[u, w]| [u.min(w), u.max(w)])
            .collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// The pillar of a vertex after a move.
    fn pillar_after(&self, v: u32, moved: Option<&(u32, Pillar)>) -> Pillar {
        match moved {
            Some((w, pillar)) if *w == v => *pillar,
            _ => self.pillars[v as usize],
        }
    }

    /// The prism over a face after a move.
    pub(crate) fn prism(&self, face: [u32; 3], moved: Option<&(u32, Pillar)>) -> Prism {
        Prism {
            pillars: face.map(|v| self.pillar_after(v, moved)),
            // A vertex that moves is not pinched.
            pinched: face.map(|v| self.pinched[v as usize]),
        }
    }

    /// The prisms that a change makes or moves.
    pub(crate) fn prisms(&self, change: &Change) -> Vec<Prism> {
        let moved = change.moved.as_ref();
        let mut out: Vec<Prism> = change.add.iter().map(|&f| self.prism(f, moved)).collect();
        if let Some((v, _)) = change.moved {
            let stays = self.star[v as usize].iter().filter(|f| !change.remove.contains(f));
            out.extend(stays.map(|&f| self.prism(self.faces[f as usize], moved)));
        }
        out
    }

    /// The prisms that a change replaces or moves, as they are.
    pub(crate) fn prisms_before(&self, change: &Change) -> Vec<Prism> {
        let moved = change.moved.as_ref().and_then(|(v, _)| self.star.get(*v as usize));
        let stays = moved.into_iter().flatten().filter(|f| !change.remove.contains(f));
        change.remove.iter().chain(stays).map(|&f| self.prism(self.faces[f as usize], None)).collect()
    }

    /// Was there no change to the vertex and its neighbours after change number `clock`? Whatever an operation there
    /// looks at is then as it was.
    pub(crate) fn is_settled(&self, v: u32, clock: u64) -> bool {
        let around = self.star[v as usize].iter().flat_map(|&f| self.faces[f as usize]);
        around.chain([v]).all(|w| self.changed[w as usize] <= clock)
    }

    /// Makes a change that was checked.
    pub(crate) fn apply(&mut self, change: &Change) {
        self.clock += 1;
        for &f in &change.remove {
            for v in std::mem::replace(&mut self.faces[f as usize], GONE) {
                self.changed[v as usize] = self.clock;
                self.star[v as usize].retain(|&g| g != f);
            }
        }
        if let Some((v, pillar)) = change.moved {
            self.pillars[v as usize] = pillar;
            self.changed[v as usize] = self.clock;
        }
        // No operation adds more faces than it removes.
        for (&id, &face) in change.remove.iter().zip(&change.add) {
            self.faces[id as usize] = face;
            for v in face {
                self.changed[v as usize] = self.clock;
                self.star[v as usize].push(id);
            }
        }
        self.live = self.live + change.add.len() - change.remove.len();
        if let Some(mut skin) = self.skin.take() {
            skin.update(self, change);
            self.skin = Some(skin);
        }
    }
}
