//! The lift of a mesh into `S_<`: breadth-first from a root piece, across sides of pieces.
//!
//! A *piece* is the intersection of a triangle and a tet where it has area. Tets are half open (THEORY section 5):
//! a piece in the common face of two tets belongs to the tet above it. Each corner is named by its two carriers,
//! and a side continues into the piece that has the same side reversed.

use rayon::prelude::*;
use rustc_hash::FxHashMap;

use super::ahead::{self, Across, Ahead, Found, Tried, find};
use super::clip::{Mask, Polygon, SIDES, clip};
use super::complex::{MeshView, TetComplex};
use super::observer::{Observer, Ticker};
use crate::predicate::{Sign, StageCounts, dot_sign_staged};
use crate::shell::{Layer, Name};

/// The two carriers of an overlay vertex; unused places hold the last entry again (a canonical padding).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Carriers {
    mesh: [u32; 3],
    mesh_len: u8,
    shell: [Name; 4],
    shell_len: u8,
}

impl Carriers {
    /// The carriers of the point of `face` and `names` at which the coordinates in `mask` vanish.
    pub(crate) fn new(face: [u32; 3], names: [Name; 4], mask: Mask) -> Self {
        let mut out = Self { mesh: [u32::MAX; 3], mesh_len: 0, shell: [NO_NAME; 4], shell_len: 0 };
        for i in (0..3).filter(|i| mask & (1 << i) == 0) {
            out.mesh[usize::from(out.mesh_len)] = face[i];
            out.mesh_len += 1;
        }
        for k in (0..4).filter(|k| mask & (1 << (3 + k)) == 0) {
            out.shell[usize::from(out.shell_len)] = names[k];
            out.shell_len += 1;
        }
        out.mesh[..usize::from(out.mesh_len)].sort_unstable();
        out.shell[..usize::from(out.shell_len)].sort_unstable();
        out
    }

    /// The vertices of the mesh carrier, ascending.
    pub(crate) fn mesh(&self) -> &[u32] {
        &self.mesh[..usize::from(self.mesh_len)]
    }

    /// The names of the shell carrier, ascending.
    pub(crate) fn shell(&self) -> &[Name] {
        &self.shell[..usize::from(self.shell_len)]
    }
}

const NO_NAME: Name = Name { vertex: u32::MAX, layer: Layer::Top };

/// Where a lift fails to be a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reason {
    /// Corner of the piece on bottom or top.
    Cap {
        /// Index of the corner.
        corner: u8,
    },
    /// A side on bottom and top: the edge between two pinched vertices, each of which is allowed by itself.
    CapSide {
        /// Index of the side: from this corner to the next.
        side: u8,
    },
    /// A side on a boundary wall inside the mesh.
    Wall {
        /// Index of the side: from this corner to the next.
        side: u8,
    },
    /// A boundary side of the mesh inside the shell.
    Boundary {
        /// Index of the side.
        side: u8,
    },
    /// `n . V <= 0`.
    Fold,
}

/// A failure, at a piece of the lift.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Violation {
    pub(crate) piece: u32,
    pub(crate) reason: Reason,
}

/// Why no verdict on a lift was reached.
#[derive(Debug)]
pub(crate) enum Stop {
    /// The lift is not a section.
    Violation(Violation),
    /// Continuation across a simplex of `S_<` is not unique.
    Branched(Vec<Name>),
    /// The caller asked to stop.
    Cancelled,
}

/// A piece of the lift.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) face: u32,
    pub(crate) tet: u32,
    /// Range of its corners in [`Lift::corners`].
    first: u32,
    len: u8,
    /// The piece that it was reached from and the side of that one; the root has itself.
    pub(crate) parent: u32,
    pub(crate) parent_side: u8,
}

/// The lift of one component of the mesh.
#[derive(Debug, Default)]
pub(crate) struct Lift {
    pub(crate) pieces: Vec<Piece>,
    /// Masks and carriers of all corners, piece after piece.
    pub(crate) corners: Vec<(Mask, Carriers)>,
    /// The component of the middle complex that the root lies in.
    pub(crate) middle_component: u32,
    /// The decisions that one core makes that looks across one side after another, whoever looked ahead: about every piece that is
    /// tried and not known by then.
    pub(crate) stages: StageCounts,
    index: FxHashMap<(u32, u32), u32>,
}

impl Lift {
    /// The corners of a piece, in the orientation of its triangle.
    pub(crate) fn corners_of(&self, piece: u32) -> &[(Mask, Carriers)] {
        let p = &self.pieces[piece as usize];
        &self.corners[p.first as usize..p.first as usize + usize::from(p.len)]
    }

    /// The piece of a triangle in a tet.
    pub(super) fn get(&self, face: u32, tet: u32) -> Option<u32> {
        self.index.get(&(face, tet)).copied()
    }

    /// Adds a piece that was found.
    fn add(&mut self, found: &Found, (parent, parent_side): (u32, u8)) -> Result<(), Stop> {
        let id = self.pieces.len() as u32;
        let first = self.corners.len() as u32;
        self.corners.extend_from_slice(found.corners());
        let len = found.corners().len() as u8;
        self.pieces.push(Piece { face: found.face, tet: found.tet, first, len, parent, parent_side });
        self.index.insert((found.face, found.tet), id);
        found.wrong.map_or(Ok(()), |reason| Err(Stop::Violation(Violation { piece: id, reason })))
    }
}

/// A piece looked at alone, apart from any lift.
pub(crate) struct LonePiece {
    /// The lines through its corners, in the orientation of the triangle.
    pub(crate) masks: Vec<Mask>,
    /// Does it count as a piece of this tet under the half-open rule?
    pub(crate) counts: bool,
    /// What is wrong with it, each reason once.
    pub(crate) reasons: Vec<Reason>,
}

/// The mesh and the complex that it is lifted into.
#[derive(Clone, Copy)]
pub(crate) struct Lifting<'a> {
    pub(crate) mesh: &'a MeshView<'a>,
    pub(crate) complex: &'a TetComplex<'a>,
}

impl Lifting<'_> {
    /// The part of `face` with area in the closed `tet`, with everything that is wrong there.
    pub(crate) fn lone_piece(&self, face: u32, tet: u32) -> Option<LonePiece> {
        let not_counted = &mut StageCounts::default();
        let polygon = clip(self.mesh.points(face), self.complex.points(tet), not_counted)?;
        let counts = self.piece(face, tet, not_counted).is_some();
        let corners = polygon.corners();
        let names = |mask: Mask| self.carriers(face, tet, mask);
        let mut reasons = Vec::new();
        if counts && !self.dot(face, tet, not_counted).is_positive() {
            reasons.push(Reason::Fold);
        }
        let cap = corners.iter().position(|c| self.complex.in_cap(names(c.mask).shell()));
        reasons.extend(cap.map(|corner| Reason::Cap { corner: corner as u8 }));
        for (side, corner) in corners.iter().enumerate() {
            let common = corner.mask & corners[(side + 1) % corners.len()].mask;
            reasons.extend(self.lone_side(face, &names(common), common, side as u8));
        }
        Some(LonePiece { masks: corners.iter().map(|c| c.mask).collect(), counts, reasons })
    }

    fn lone_side(&self, face: u32, along: &Carriers, common: Mask, side: u8) -> Option<Reason> {
        if self.complex.in_cap(along.shell()) {
            return Some(Reason::CapSide { side });
        }
        let on_wall = self.complex.in_boundary_wall(along.shell());
        let mesh_side = common & SIDES;
        let on_edge = mesh_side != 0 && self.mesh.across(face, mesh_side.trailing_zeros()).is_none();
        match (on_edge, on_wall) {
            (true, false) => Some(Reason::Boundary { side }),
            (false, true) => Some(Reason::Wall { side }),
            _ => None,
        }
    }

    /// The piece of `face` in `tet`, under the half-open rule.
    pub(super) fn piece(&self, face: u32, tet: u32, stages: &mut StageCounts) -> Option<Polygon> {
        let polygon = clip(self.mesh.points(face), self.complex.points(tet), stages)?;
        if let Some(k) = polygon.coplanar {
            let record = &self.complex.tets[tet as usize];
            let omitted = record.names[usize::from(k)];
            let [lo, hi] = record.field();
            // V runs from lo to hi. A face without lo is where it leaves the tet; a wall holds both, is parallel to V
            // and is a fold from either side, so either tet may have it.
            if omitted == lo {
                return None;
            }
            debug_assert!(hi != lo);
        }
        Some(polygon)
    }

    pub(super) fn carriers(&self, face: u32, tet: u32, mask: Mask) -> Carriers {
        Carriers::new(self.mesh.faces[face as usize], self.complex.tets[tet as usize].names, mask)
    }

    /// Sign of `n . V` of a triangle in a tet.
    pub(crate) fn dot(&self, face: u32, tet: u32, stages: &mut StageCounts) -> Sign {
        let [lo, hi] = self.complex.tets[tet as usize].field().map(|n| self.complex.shell.position(n));
        let [a, b, c] = self.mesh.points(face);
        stages.note(dot_sign_staged(a, b, c, lo, hi))
    }

    /// The pieces that a root point may start in: of triangle `face`, in the tets around the simplex `names`.
    pub(crate) fn starts(&self, face: u32, names: &[Name], stages: &mut StageCounts) -> Vec<u32> {
        self.complex.star(names).filter(|&tet| self.piece(face, tet, stages).is_some()).collect()
    }

    /// Lifts the component of `face` from its piece in `tet`.
    pub(crate) fn flood(&self, face: u32, tet: u32, observer: &dyn Observer) -> (Lift, Option<Stop>) {
        let mut lift = Lift::default();
        let Some(root) = find(self, face, tet, &mut lift.stages) else { return (lift, None) };
        lift.middle_component = self.complex.middle.component(self.complex.tets[tet as usize].prism);
        let stop = self.run(&mut lift, &root, observer).err();
        (lift, stop)
    }

    /// Breadth-first. All cores look across the sides of the pieces that wait, then what they found is added in the order in which
    /// one core would have found it: the lift is the same for any number of threads and pieces taken at once.
    fn run(&self, lift: &mut Lift, root: &Found, observer: &dyn Observer) -> Result<(), Stop> {
        let mut ticker = Ticker::new(observer);
        lift.add(root, (0, 0))?;
        let (mut next, mut alone) = (0, Ahead::default());
        while next < lift.pieces.len() {
            let waiting = lift.pieces.len() - next;
            // Neighbours among the pieces taken at once find the same piece twice: alone, one looks at one after another.
            if waiting < WIDE || rayon::current_num_threads() == 1 {
                alone.clear();
                alone.look(self, lift, next as u32);
                self.accept(lift, &alone, &mut ticker)?;
                next += 1;
                continue;
            }
            let ids: Vec<u32> = (next as u32..).take(waiting.min(AT_ONCE)).collect();
            let look = |ids: &[u32]| {
                let mut ahead = Ahead::default();
                ids.iter().for_each(|&id| ahead.look(self, lift, id));
                ahead
            };
            let parts: Vec<Ahead> = ids.par_chunks(SHARE).map(look).collect();
            parts.iter().try_for_each(|ahead| self.accept(lift, ahead, &mut ticker))?;
            next += ids.len();
        }
        Ok(())
    }

    /// Adds what lies across the sides of some pieces.
    fn accept(&self, lift: &mut Lift, ahead: &Ahead, ticker: &mut Ticker<'_>) -> Result<(), Stop> {
        let mut tried = ahead.tried.as_slice();
        for &(piece, side, across) in &ahead.sides {
            if side == 0 && ticker.tick() {
                return Err(Stop::Cancelled);
            }
            match across {
                Across::Wrong(reason) => return Err(Stop::Violation(Violation { piece, reason })),
                Across::Pieces { count, then_known, after } => {
                    let (here, rest) = tried.split_at(count as usize);
                    tried = rest;
                    self.enter(lift, (piece, side), here, (then_known, after))?;
                }
                Across::Boundary => {}
            }
        }
        Ok(())
    }

    /// Goes on into the one piece that has the side, unless the lift has one by now.
    fn enter(
        &self,
        lift: &mut Lift,
        from: (u32, u8),
        tried: &[Tried],
        (then_known, after): (bool, StageCounts),
    ) -> Result<(), Stop> {
        let mut one: Option<&Found> = None;
        let branched = |lift: &Lift| {
            let along = ahead::along(self, lift, from.0, usize::from(from.1));
            Err(Stop::Branched(along.shell().to_vec()))
        };
        for Tried { found, fits, before, stages } in tried {
            lift.stages += *before;
            let known = lift.get(found.face, found.tet).is_some();
            if !known {
                lift.stages += *stages;
            }
            if !fits {
                continue;
            }
            if known {
                return Ok(());
            }
            if found.wrong == Some(Reason::Fold) {
                return lift.add(found, from);
            }
            if one.is_some() {
                return branched(lift);
            }
            one = Some(found);
        }
        lift.stages += after;
        match one {
            _ if then_known => Ok(()),
            Some(one) => lift.add(one, from),
            None => branched(lift),
        }
    }
}

/// Pieces that wait, from where on looking ahead by all cores pays.
const WIDE: usize = 64;

/// Pieces looked across at once, at most: bounds the memory of what is found.
const AT_ONCE: usize = 1 << 14;

/// Pieces that one core takes.
const SHARE: usize = 64;
