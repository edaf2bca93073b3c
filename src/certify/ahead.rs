//! What lies across the sides of pieces: a function of mesh and complex alone, so that all cores may look ahead of the lift.

use super::clip::{Mask, SIDES};
use super::complex::MeshView;
use super::lift::{Carriers, Lift, Lifting, Reason};
use crate::predicate::StageCounts;

/// A piece that was found, with all that adding it to a lift needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(super) face: u32,
    pub(super) tet: u32,
    corners: [(Mask, Carriers); Found::CORNERS],
    len: u8,
    /// What is wrong with it, looked at alone.
    pub(super) wrong: Option<Reason>,
}

/// A piece that was tried.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tried {
    pub(super) found: Found,
    /// Does it have the side?
    pub(super) fits: bool,
    /// Decisions about tets before it that hold no piece, since the piece tried before this one.
    pub(super) before: StageCounts,
    /// Decisions about the piece.
    pub(super) stages: StageCounts,
}

impl Found {
    /// A triangle cut with a tet has seven corners at most.
    const CORNERS: usize = 7;

    /// Masks and carriers of the corners, in the orientation of the triangle.
    pub(super) fn corners(&self) -> &[(Mask, Carriers)] {
        self.corners.get(..usize::from(self.len)).unwrap_or(&[])
    }
}

/// What lies across a side of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) enum Across {
    /// The common boundary of mesh and shell.
    Boundary,
    /// The lift is no section.
    Wrong(Reason),
    /// Pieces, in the order in which they are tried: so many of [`Ahead::tried`]. After them comes one that is known and has
    /// the side, or none; `after`: decisions about tets in between that hold no piece.
    Pieces { count: u32, then_known: bool, after: StageCounts },
}

/// What lies across the sides of some pieces, in their order.
#[derive(Debug, Default)]
pub(super) struct Ahead {
    /// Piece, side, what lies there; the sides of a piece together, from the first one on.
    pub(super) sides: Vec<(u32, u8, Across)>,
    pub(super) tried: Vec<Tried>,
}

/// A side of a piece: its ends in the direction of the neighbour, and what it lies in.
struct Side {
    ends: [Carriers; 2],
    along: Carriers,
    mask: Mask,
}

fn side_of(cx: &Lifting<'_>, face: u32, tet: u32, corners: &[(Mask, Carriers)], side: usize) -> Side {
    let ((mask_a, a), (mask_b, b)) = (corners[side], corners[(side + 1) % corners.len()]);
    let mask = mask_a & mask_b;
    Side { ends: [b, a], along: cx.carriers(face, tet, mask), mask }
}

/// The carriers of the points inside a side of a piece.
pub(super) fn along(cx: &Lifting<'_>, lift: &Lift, id: u32, side: usize) -> Carriers {
    let piece = lift.pieces[id as usize];
    side_of(cx, piece.face, piece.tet, lift.corners_of(id), side).along
}

impl Ahead {
    /// Forgets all, but keeps its memory.
    pub(super) fn clear(&mut self) {
        self.sides.clear();
        self.tried.clear();
    }

    /// Looks across all sides of a piece. Pieces that the lift has by then end the search as they would later on, so that what
    /// is found does not depend on when one looks, except for what is known already.
    pub(super) fn look(&mut self, cx: &Lifting<'_>, lift: &Lift, id: u32) {
        let piece = lift.pieces[id as usize];
        let corners = lift.corners_of(id);
        for k in 0..corners.len() {
            let side = side_of(cx, piece.face, piece.tet, corners, k);
            let across = match next_face(cx, piece.face, &side, k as u8) {
                Ok(None) => Across::Boundary,
                Ok(Some(face)) => self.pieces(cx, lift, face, piece.tet, &side),
                Err(reason) => Across::Wrong(reason),
            };
            self.sides.push((id, k as u8, across));
        }
    }

    /// The pieces of `face` around a simplex of `tet`, until it is clear which have the side.
    fn pieces(&mut self, cx: &Lifting<'_>, lift: &Lift, face: u32, tet: u32, side: &Side) -> Across {
        let (mut count, mut positive, mut before) = (0, 0, StageCounts::default());
        for tet in cx.complex.around(tet, side.along.shell()) {
            if let Some(known) = lift.get(face, tet) {
                if has_side(lift.corners_of(known), side.ends) {
                    return Across::Pieces { count, then_known: true, after: before };
                }
                continue;
            }
            let mut stages = StageCounts::default();
            let Some(found) = find(cx, face, tet, &mut stages) else {
                before += stages;
                continue;
            };
            let fits = has_side(found.corners(), side.ends);
            self.tried.push(Tried { found, fits, before: std::mem::take(&mut before), stages });
            count += 1;
            positive += u8::from(fits && found.wrong != Some(Reason::Fold));
            // A fold is the end. So are two: along a wall a coplanar triangle is a piece of either tet; the first is enough.
            if fits && found.wrong == Some(Reason::Fold) || positive == 2 {
                break;
            }
        }
        Across::Pieces { count, then_known: false, after: before }
    }
}

/// The triangle across a side, `None` on the boundary of both mesh and shell.
fn next_face(cx: &Lifting<'_>, face: u32, side: &Side, k: u8) -> Result<Option<u32>, Reason> {
    if cx.complex.in_cap(side.along.shell()) {
        return Err(Reason::CapSide { side: k });
    }
    let on_wall = cx.complex.in_boundary_wall(side.along.shell());
    match (across(cx.mesh, face, side.mask & SIDES), on_wall) {
        (None, true) => Ok(None),
        (None, false) => Err(Reason::Boundary { side: k }),
        (Some(_), true) => Err(Reason::Wall { side: k }),
        (next, false) => Ok(next),
    }
}

fn across(mesh: &MeshView<'_>, face: u32, side: Mask) -> Option<u32> {
    if side == 0 { Some(face) } else { mesh.across(face, side.trailing_zeros()) }
}

/// The piece of `face` in `tet`, under the half-open rule, looked at alone: is it a fold, does it touch bottom or top?
pub(super) fn find(cx: &Lifting<'_>, face: u32, tet: u32, stages: &mut StageCounts) -> Option<Found> {
    let polygon = cx.piece(face, tet, stages)?;
    let none = (0, cx.carriers(face, tet, 0));
    let mut out = Found { face, tet, corners: [none; Found::CORNERS], len: 0, wrong: None };
    for (slot, corner) in out.corners.iter_mut().zip(polygon.corners()) {
        *slot = (corner.mask, cx.carriers(face, tet, corner.mask));
        out.len += 1;
    }
    let cap = || out.corners().iter().position(|(_, c)| cx.complex.in_cap(c.shell()));
    out.wrong = if cx.dot(face, tet, stages).is_positive() {
        cap().map(|corner| Reason::Cap { corner: corner as u8 })
    } else {
        Some(Reason::Fold)
    };
    Some(out)
}

/// Does the closed polygon have the directed side `ends[0] -> ends[1]`?
fn has_side(corners: &[(Mask, Carriers)], ends: [Carriers; 2]) -> bool {
    let following = corners.iter().cycle().skip(1);
    corners.iter().zip(following).any(|((_, a), (_, b))| [*a, *b] == ends)
}
