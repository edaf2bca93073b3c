//! The shell under optimisation: faces of the middle complex, stars of its vertices, pillars.

use super::prism::{Pillar, Prism};
use super::skin::Skin;
use super::tracked::Tracked;
use crate::mesh::Connectivity;
use crate::shell::Shell;

/// A face that is no more.
pub(crate) const GONE: [u32; 3] = [u32::MAX; 3];

/// The vertex that a change makes, before [`State::apply`] gives it the next id.
pub(crate) const NEW: u32 = u32::MAX - 1;

/// The shell under optimisation. Vertices and faces keep their ids; removed ones have an empty star or are [`GONE`].
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) pillars: Vec<Pillar>,
    pub(crate) pinched: Vec<bool>,
    pub(crate) boundary: Vec<bool>,
    /// The faces at every vertex, ascending.
    pub(crate) star: Vec<Vec<u32>>,
    /// How many faces there are.
    pub(crate) live: usize,
    /// How many changes were made.
    pub(crate) clock: u64,
    /// Per vertex the number of the last change to its pillar or star.
    pub(crate) changed: Vec<u64>,
    /// Around a mesh that intersects itself: what each prism is judged against.
    pub(crate) tracked: Option<Tracked>,
    /// The skin, where it must stay free of self-intersection.
    pub(crate) skin: Option<Skin>,
}

/// A replacement of faces by others, and of at most one pillar by another, or a first one for the vertex [`NEW`].
#[derive(Clone, Debug, Default, PartialEq)]
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
        let mut boundary = vec![false; n];
        for side in connectivity.boundary() {
            for v in connectivity.ends(side) {
                boundary[v as usize] = true;
            }
        }
        Self::of(shell.faces.clone(), (0..n).map(pillar).collect(), boundary, vec![0; n], 0)
    }

    /// The state with these independent parts; all ids in `faces` that are not [`GONE`] are in range.
    pub(crate) fn of(
        faces: Vec<[u32; 3]>,
        pillars: Vec<Pillar>,
        boundary: Vec<bool>,
        changed: Vec<u64>,
        clock: u64,
    ) -> Self {
        let mut star = vec![Vec::new(); pillars.len()];
        let mut live = 0;
        for (f, face) in (0u32..).zip(&faces).filter(|(_, face)| **face != GONE) {
            live += 1;
            for &v in face {
                star[v as usize].push(f);
            }
        }
        let pinched = pillars.iter().map(Pillar::is_pinched).collect();
        Self { faces, pillars, pinched, boundary, star, live, clock, changed, tracked: None, skin: None }
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
            // A vertex that moves is not pinched, nor is a new one.
            pinched: face.map(|v| v != NEW && self.pinched[v as usize]),
        }
    }

    /// The prisms that a change makes or moves.
    pub(crate) fn prisms(&self, change: &Change) -> Vec<Prism> {
        let moved = change.moved.as_ref();
        let mut out: Vec<Prism> = change.add.iter().map(|&f| self.prism(f, moved)).collect();
        out.extend(self.kept(change).map(|&f| self.prism(self.faces[f as usize], moved)));
        out
    }

    /// The prisms that a change replaces or moves, as they are.
    pub(crate) fn prisms_before(&self, change: &Change) -> Vec<Prism> {
        let all = change.remove.iter().chain(self.kept(change));
        all.map(|&f| self.prism(self.faces[f as usize], None)).collect()
    }

    /// The faces at the moved vertex that stay faces.
    fn kept<'c>(&'c self, change: &'c Change) -> impl Iterator<Item = &'c u32> {
        let moved = change.moved.as_ref().and_then(|(v, _)| self.star.get(*v as usize));
        moved.into_iter().flatten().filter(|f| !change.remove.contains(f))
    }

    /// The mesh triangles that a change is to be judged against, where not all are.
    pub(crate) fn candidates(&self, change: &Change) -> Option<Vec<u32>> {
        let touched = change.remove.iter().chain(self.kept(change)).copied();
        self.tracked.as_ref().map(|tracked| tracked.union(touched))
    }

    /// The mesh triangles that a move of a vertex is to be judged against, where not all are.
    pub(crate) fn candidates_around(&self, v: u32) -> Option<Vec<u32>> {
        self.tracked.as_ref().map(|tracked| tracked.union(self.star[v as usize].iter().copied()))
    }

    /// Hands the triangles that were tracked before a change on to the prisms after it.
    fn track(&mut self, faces: &[u32], candidates: &[u32]) {
        let Some(mut tracked) = self.tracked.take() else { return };
        for &f in faces {
            tracked.set(f as usize, &self.prism(self.faces[f as usize], None), candidates);
        }
        self.tracked = Some(tracked);
    }

    /// Was there no change to the vertex and its neighbours after change number `clock`? Then nothing is new in its
    /// star, its neighbours' stars, or the pillars of all these: a proposal for a vertex, or for an edge whose ends are
    /// both settled, reads nothing else of the state, and is what it was. Faces further off are read only as stars of
    /// neighbours (their number, and whether two neighbours share an edge).
    pub(crate) fn is_settled(&self, v: u32, clock: u64) -> bool {
        let around = self.star[v as usize].iter().flat_map(|&f| self.faces[f as usize]);
        around.chain([v]).all(|w| self.changed[w as usize] <= clock)
    }

    /// Makes a change that was checked.
    pub(crate) fn apply(&mut self, change: &Change) {
        let candidates = self.candidates(change);
        let mut touched: Vec<u32> = self.kept(change).copied().collect();
        self.clock += 1;
        for &f in &change.remove {
            for v in std::mem::replace(&mut self.faces[f as usize], GONE) {
                self.changed[v as usize] = self.clock;
                self.star[v as usize].retain(|&g| g != f);
            }
        }
        let new = u32::try_from(self.pillars.len()).unwrap_or(NEW);
        if let Some((v, pillar)) = change.moved {
            if v == NEW {
                self.push(pillar);
            } else {
                self.pillars[v as usize] = pillar;
                self.changed[v as usize] = self.clock;
            }
        }
        for (k, face) in change.add.iter().enumerate() {
            let face = face.map(|v| if v == NEW { new } else { v });
            let id = self.place(change.remove.get(k).copied(), face);
            touched.push(id);
            for v in face {
                self.changed[v as usize] = self.clock;
                let star = &mut self.star[v as usize];
                star.insert(star.partition_point(|&g| g < id), id);
            }
        }
        self.live = self.live + change.add.len() - change.remove.len();
        if let Some(candidates) = candidates {
            self.track(&touched, &candidates);
        }
        if let Some(mut skin) = self.skin.take() {
            skin.update(self, touched.iter().chain(&change.remove).copied());
            self.skin = Some(skin);
        }
    }

    /// Appends an inner vertex without faces.
    fn push(&mut self, pillar: Pillar) {
        self.pillars.push(pillar);
        self.pinched.push(false);
        self.boundary.push(false);
        self.star.push(Vec::new());
        self.changed.push(self.clock);
    }

    /// Puts a face where one was removed, or at the end; its id.
    fn place(&mut self, id: Option<u32>, face: [u32; 3]) -> u32 {
        match id {
            Some(id) => {
                self.faces[id as usize] = face;
                id
            }
            None => {
                self.faces.push(face);
                u32::try_from(self.faces.len() - 1).unwrap_or(u32::MAX)
            }
        }
    }

    /// Is there an id left for one more vertex and two more faces?
    pub(crate) fn has_room(&self) -> bool {
        let most = (NEW - 2) as usize;
        self.pillars.len() < most && self.faces.len() < most
    }
}
