//! C3 `section-all-orders`: from the overlay of one order, every other order (THEORY section 3, "All orders").

use rayon::prelude::*;

use super::CertifyError;
use super::clip::{SIDES, clip};
use super::complex::{Boundary, TetComplex};
use super::exact::{ExactPiece, Weights, centre, has_area};
use super::i2::pillar_dots;
use super::lift::{Lift, Lifting};
use super::observer::Observer;
use super::point::MeshPoint;
use super::section::{self, Section};
use super::witness::NoLift;
use crate::mesh::connectivity::Side;
use crate::predicate::{StageCounts, orient3d_staged};
use crate::shell::{Layer, Name, Slab, Tet, VertexOrder, decomposition::TETS, decomposition::decomposition};

/// The answer to C3, given C1 and C2.
#[derive(Debug)]
pub(crate) enum AllOrders {
    /// Every order has a section.
    Certified(Stats),
    /// Under the order in which these vertices come first there is none.
    Refuted {
        /// The vertices that come first.
        first: Vec<u32>,
        /// The witness in that order's complex.
        witness: NoLift,
        /// How much work there was until then.
        stats: Stats,
    },
}

/// How much work there was.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stats {
    /// Pairs of piece and prism looked at.
    pub(crate) pairs: u64,
    /// Those with a dot that is not positive.
    pub(crate) exceptions: u64,
    /// How the signs of determinants and dots were decided.
    pub(crate) stages: StageCounts,
}

impl std::ops::AddAssign for Stats {
    fn add_assign(&mut self, other: Self) {
        self.pairs += other.pairs;
        self.exceptions += other.exceptions;
        self.stages += other.stages;
    }
}

/// A piece that meets a tet of another order in the wrong direction, or leaves the shell in it.
struct Conflict {
    /// Vertices that come first in an order under which it happens.
    first: Vec<u32>,
    point: MeshPoint,
}

/// Decides C3 from the lifts that prove C2 under `order`. All 24 tets of every prism must be positive.
pub(crate) fn decide(
    cx: Lifting<'_>,
    lifts: &[Lift],
    order: &VertexOrder,
    observer: &dyn Observer,
) -> Result<AllOrders, CertifyError> {
    let mut stats = Stats::default();
    if let Some(first) = lifts.iter().find_map(|lift| open_wall(&cx, lift, order, &mut stats.stages)) {
        return refute(&cx, (first, None), order, stats, observer);
    }
    let ranks = order.ranks(cx.complex.shell.middle.len());
    for lift in lifts {
        let pieces: Vec<u32> = (0..lift.pieces.len() as u32).collect();
        let parts: Vec<Result<(Stats, Option<Conflict>), CertifyError>> =
            pieces.par_chunks(BATCH).map(|chunk| batch(&cx, lift, chunk, &ranks, observer)).collect();
        // The first conflict in the order of pieces, whichever thread was faster.
        for part in parts {
            let (found, conflict) = part?;
            stats += found;
            if let Some(conflict) = conflict {
                return refute(&cx, (conflict.first, Some(&conflict.point)), order, stats, observer);
            }
        }
    }
    Ok(AllOrders::Certified(stats))
}

/// Pieces a batch: enough to amortise scheduling.
const BATCH: usize = 256;

fn batch(
    cx: &Lifting<'_>,
    lift: &Lift,
    pieces: &[u32],
    ranks: &[u32],
    observer: &dyn Observer,
) -> Result<(Stats, Option<Conflict>), CertifyError> {
    let mut stats = Stats::default();
    if observer.cancelled() {
        return Err(CertifyError::Cancelled);
    }
    for &piece in pieces {
        let found = match cut_off(cx, lift, piece, ranks)? {
            None => piece_conflict(cx, lift, piece, &mut stats)?,
            conflict => conflict,
        };
        if let Some(conflict) = found {
            return Ok((stats, Some(conflict)));
        }
    }
    observer.advance(pieces.len() as u64);
    Ok((stats, None))
}

/// A boundary side of the mesh that lies in a wall which bends when its diagonal flips; the order that flips it.
fn open_wall(
    cx: &Lifting<'_>,
    lift: &Lift,
    order: &VertexOrder,
    stages: &mut StageCounts,
) -> Option<Vec<u32>> {
    let shell = cx.complex.shell;
    let ranks = order.ranks(shell.middle.len());
    for id in 0..lift.pieces.len() as u32 {
        let corners = lift.corners_of(id);
        let face = lift.pieces[id as usize].face;
        for (s, (mask, from)) in corners.iter().enumerate() {
            let (other, to) = &corners[(s + 1) % corners.len()];
            let side = mask & other & SIDES;
            if side == 0 || cx.mesh.across(face, side.trailing_zeros()).is_some() {
                continue;
            }
            let mut names: Vec<Name> = from.shell().iter().chain(to.shell()).copied().collect();
            names.sort_unstable();
            names.dedup();
            let mut ids: Vec<u32> = names.iter().map(|n| n.vertex).collect();
            ids.dedup();
            let [u, w] = ids[..] else { continue };
            if !wall_is_safe(cx.complex, [u, w], &names, stages) {
                let flipped = if ranks[u as usize] < ranks[w as usize] { [w, u] } else { [u, w] };
                return Some(flipped.to_vec());
            }
        }
    }
    None
}

/// Do the names lie on the wall's middle edge, or in a slab's wall with coplanar points?
fn wall_is_safe(
    complex: &TetComplex<'_>,
    [u, w]: [u32; 2],
    names: &[Name],
    stages: &mut StageCounts,
) -> bool {
    if names.iter().all(|n| n.layer == Layer::Middle) || complex.is_pinched(u) || complex.is_pinched(w) {
        return true;
    }
    Slab::BOTH.iter().any(|slab| {
        let wall = wall_names([u, w], *slab);
        let [a, b, c, d] = wall.map(|n| complex.shell.position(n));
        names.iter().all(|n| wall.contains(n)) && stages.note(orient3d_staged(a, b, c, d)).is_zero()
    })
}

/// `lo_u lo_w hi_w hi_u`.
fn wall_names([u, w]: [u32; 2], slab: Slab) -> [Name; 4] {
    let name = |vertex, layer| Name { vertex, layer };
    [name(u, slab.lo()), name(w, slab.lo()), name(w, slab.hi()), name(u, slab.hi())]
}

/// Looks at one piece in its own prism and in the three across its prism's sides.
fn piece_conflict(
    cx: &Lifting<'_>,
    lift: &Lift,
    piece: u32,
    stats: &mut Stats,
) -> Result<Option<Conflict>, CertifyError> {
    let record = lift.pieces[piece as usize];
    let prism = cx.complex.tets[record.tet as usize].prism;
    let triangle = cx.mesh.points(record.face);
    let mut exact: Option<Vec<Weights>> = None;
    let across = (0..3).map(|i| cx.complex.middle.mate(Side::new(prism, i)));
    let around = std::iter::once((prism, None)).chain(
        (0..3).zip(across).filter_map(|(i, mate)| mate.map(|m| (m.face(), Some(Side::new(prism, i))))),
    );
    for (other, side) in around {
        stats.pairs += 1;
        let dots = pillar_dots(triangle, cx.complex.shell, other, &mut stats.stages);
        if dots.all_positive() {
            continue;
        }
        stats.exceptions += 1;
        for tet in cx.complex.shell.prism_tets_unique(other).filter(|t| !dots.of(t).is_positive()) {
            let points = tet.names.map(|n| cx.complex.shell.position(n));
            // Where the whole triangle has no area in the tet, its pieces have none.
            if clip(triangle, points, &mut stats.stages).is_none() {
                continue;
            }
            let polygon = match &exact {
                Some(polygon) => polygon,
                None => exact.insert(exact_polygon(cx, lift, piece)?),
            };
            let parts = match side {
                None => vec![polygon.clone()],
                Some(side) => wall_parts(cx, triangle, polygon, cx.complex.middle.ends(side)),
            };
            let against = ExactPiece::new(triangle, points);
            for part in &parts {
                let common = against.cut_with_tet(part);
                if has_area(&common)
                    && let Some(weights) = centre(&common)
                {
                    let point = MeshPoint { face: record.face, weights };
                    return Ok(Some(Conflict { first: occurs_in(&tet, cx.complex), point }));
                }
            }
        }
    }
    Ok(None)
}

/// A part of a piece in a wall tet behind which is no prism: the order that flips the wall cuts it off the shell.
fn cut_off(
    cx: &Lifting<'_>,
    lift: &Lift,
    piece: u32,
    ranks: &[u32],
) -> Result<Option<Conflict>, CertifyError> {
    let record = lift.pieces[piece as usize];
    let tet = &cx.complex.tets[record.tet as usize];
    let sides = (0..3).map(|i| Side::new(tet.prism, i));
    for side in sides.filter(|side| cx.complex.middle.mate(*side).is_none()) {
        let [u, w] = cx.complex.middle.ends(side);
        let polygon = exact_polygon(cx, lift, piece)?;
        for part in wall_parts(cx, cx.mesh.points(record.face), &polygon, [u, w]) {
            if has_area(&part)
                && let Some(weights) = centre(&part)
            {
                // The wall's diagonal runs from the smaller vertex; turn it.
                let first = if ranks[u as usize] < ranks[w as usize] { [w, u] } else { [u, w] };
                return Ok(Some(Conflict {
                    first: first.to_vec(),
                    point: MeshPoint { face: record.face, weights },
                }));
            }
        }
    }
    Ok(None)
}

/// The corners of a piece as weights in its triangle.
fn exact_polygon(cx: &Lifting<'_>, lift: &Lift, piece: u32) -> Result<Vec<Weights>, CertifyError> {
    let record = lift.pieces[piece as usize];
    let exact = ExactPiece::new(cx.mesh.points(record.face), cx.complex.points(record.tet));
    let corners = lift.corners_of(piece).iter().map(|(mask, _)| exact.corner(*mask));
    corners.collect::<Option<_>>().ok_or(CertifyError::Internal { what: "corner without two crossing lines" })
}

/// The polygon cut with the wall tets of a side, one part a slab.
fn wall_parts(
    cx: &Lifting<'_>,
    triangle: [&[f64; 3]; 3],
    polygon: &[Weights],
    ends: [u32; 2],
) -> Vec<Vec<Weights>> {
    if ends.iter().any(|&v| cx.complex.is_pinched(v)) {
        return Vec::new();
    }
    let cut = |slab: &Slab| {
        let wall = wall_names(ends, *slab).map(|n| cx.complex.shell.position(n));
        ExactPiece::new(triangle, wall).cut_with_tet(polygon)
    };
    Slab::BOTH.iter().map(cut).filter(|part| !part.is_empty()).collect()
}

/// Vertices of the tet's prism in an order under which the tet occurs.
fn occurs_in(tet: &Tet, complex: &TetComplex<'_>) -> Vec<u32> {
    let corners = complex.shell.faces[tet.prism as usize];
    let orders = [[0u8, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    debug_assert!(usize::from(tet.local) < TETS.len());
    let found = orders.into_iter().find(|o| decomposition(*o).contains(&usize::from(tet.local)));
    found.unwrap_or([0, 1, 2]).map(|k| corners[usize::from(k)]).to_vec()
}

/// The witness under the order in which `first` come first; at `point` when that suffices.
fn refute(
    cx: &Lifting<'_>,
    (first, point): (Vec<u32>, Option<&MeshPoint>),
    order: &VertexOrder,
    mut stats: Stats,
    observer: &dyn Observer,
) -> Result<AllOrders, CertifyError> {
    let shell = cx.complex.shell;
    let vertices = shell.middle.len();
    let ranks = order.with_first(&first, vertices).ranks(vertices);
    let boundary: &Boundary = cx.complex.boundary;
    let complex = TetComplex::new(shell, cx.complex.middle, boundary, &ranks);
    let other = Lifting { mesh: cx.mesh, complex: &complex };
    if let Some(root) = point.and_then(|p| other.root_at(p, &mut stats.stages)) {
        return Ok(AllOrders::Refuted { first, witness: NoLift::Roots(vec![root]), stats });
    }
    match section::decide(other, observer, &mut stats.stages)? {
        Section::Refuted(witness) => Ok(AllOrders::Refuted { first, witness, stats }),
        // The lift of the given order fails here, but where the shell overlaps itself another one may not.
        Section::Certified(_) => Err(CertifyError::SeveralLifts { first }),
    }
}
