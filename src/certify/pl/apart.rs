//! Triangles in space that share only what their common vertices force: a surface, or the boundary of tets (rule R3).

use rayon::prelude::*;
use rustc_hash::FxHashSet;

use super::super::CertifyError;
use super::super::exact::common_point;
use super::super::observer::Observer;
use super::super::pairs::BoxTree;
use super::super::separate::{Few, Named, Pair, PlaneName, PointName};
use super::points::Point;
use super::witness::Witness;
use dashu_int::IBig;

/// A triangle: its vertices, the cell that it is or is a facet of, and where its corners stand in that cell.
#[derive(Clone, Debug)]
pub(super) struct Triangle {
    /// The number that certificates use: a triangle of a surface, or a facet of a tet.
    pub(super) id: u32,
    pub(super) vertices: [u32; 3],
    pub(super) cell: u32,
    pub(super) places: [usize; 3],
    /// Corners of the cell.
    pub(super) k: usize,
}

/// The answer for all pairs.
#[derive(Debug, Default)]
pub(super) struct Apart {
    /// Pairs whose boxes meet.
    pub(super) pairs: u64,
    /// The planes of pairs that neither own plane separates, ascending.
    pub(super) separations: Vec<(u32, u32, Vec<PlaneName>)>,
    /// Pairs that share more than they may.
    pub(super) crossings: Vec<Witness>,
}

/// Decides all pairs, ascending. O((n + k) log n) for k pairs of boxes that meet.
pub(super) fn decide<P: Point>(
    triangles: &[Triangle],
    points: &[P],
    observer: &dyn Observer,
) -> Result<Apart, CertifyError> {
    let corners: Vec<Vec<[f64; 3]>> = triangles
        .iter()
        .map(|t| t.vertices.iter().flat_map(|&v| points[v as usize].corners()).collect())
        .collect();
    let tree = BoxTree::new(corners.iter().map(|c| c.iter().collect::<Few<_>>()));
    let parts: Vec<Result<Apart, CertifyError>> = (0..triangles.len())
        .into_par_iter()
        .map(|i| {
            if observer.cancelled() {
                return Err(CertifyError::Cancelled);
            }
            observer.advance(1);
            let near = tree.meeting(&corners[i].iter().collect::<Vec<_>>());
            let mut out = Apart::default();
            for j in near.into_iter().map(|j| j as usize).filter(|&j| j > i) {
                out.pair(&triangles[i], &triangles[j], points)?;
            }
            Ok(out)
        })
        .collect();
    let mut out = Apart::default();
    for part in parts {
        let part = part?;
        out.pairs += part.pairs;
        out.separations.extend(part.separations);
        out.crossings.extend(part.crossings);
    }
    Ok(out)
}

impl Apart {
    fn pair<P: Point>(&mut self, s: &Triangle, t: &Triangle, points: &[P]) -> Result<(), CertifyError> {
        let at = |t: &Triangle| t.vertices.map(|v| &points[v as usize]);
        if !P::boxes_meet(&at(s), &at(t)) {
            return Ok(());
        }
        self.pairs += 1;
        let ids: Few<u32> = s.vertices.into_iter().chain(t.vertices).collect();
        let common =
            (0..6).map(|i| if i < 3 { ids[3..].contains(&ids[i]) } else { ids[..3].contains(&ids[i]) });
        let named = ids.iter().map(|&v| Named { name: PointName::Mesh(v), at: &points[v as usize] });
        let pair = Pair { common: common.collect(), points: named.collect(), split: 3, exact_common: true };
        if pair.closed_by([0, 1, 2]) || pair.closed_by([3, 4, 5]) {
            return Ok(());
        }
        match pair.separation() {
            Some(planes) => self.separations.push((s.id, t.id, planes)),
            None => self.crossings.push(crossing(s, t, points)?),
        }
        Ok(())
    }
}

/// Two triangles with a common point, as a witness about the cells that they bound or are.
fn crossing<P: Point>(s: &Triangle, t: &Triangle, points: &[P]) -> Result<Witness, CertifyError> {
    let all: Vec<&P> = s.vertices.iter().chain(&t.vertices).map(|&v| &points[v as usize]).collect();
    let x = P::integers(&all);
    let [in_first, in_second] = common_point([&x[0], &x[1], &x[2]], [&x[3], &x[4], &x[5]])?;
    let spread = |t: &Triangle, weights: [IBig; 3]| {
        let mut out = vec![IBig::ZERO; t.k];
        for (place, w) in t.places.into_iter().zip(weights) {
            out[place] = w;
        }
        out
    };
    let mut sides = [(s.cell, spread(s, in_first)), (t.cell, spread(t, in_second))];
    sides.sort_by_key(|(cell, _)| *cell);
    let [(i, w), (j, y)] = sides;
    Ok(Witness::Cross([i, j], [w, y]))
}

/// Of several crossings, those between different cells; each cell pair once.
pub(super) fn distinct(crossings: &[Witness], limit: usize) -> Vec<Witness> {
    let mut seen = FxHashSet::default();
    let fresh = crossings.iter().filter(|w| match w {
        Witness::Cross(cells, _) => cells[0] != cells[1] && seen.insert(*cells),
        _ => true,
    });
    fresh.take(limit).cloned().collect()
}
