//! `disjoint-prisms`: the tets of one decomposition share nothing but common faces (rule R4).

use dashu_int::IBig;
use dashu_ratio::RBig;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

use super::CertifyError;
use super::disjoint::crossing;
use super::exact::{ExactPiece, to_integers};
use super::observer::Observer;
use super::pairs::BoxTree;
use super::positivity::bad_tet;
use super::separate::{Few, Named, Pair, PlaneName, PointName};
use super::witness::BadTet;
use crate::predicate::{StageCounts, orient3d_staged};
use crate::shell::{Name, Shell, Tet, VertexOrder};

/// Two tets with a common point that has different carriers in them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overlap {
    /// The tets, names ascending.
    pub tets: [[Name; 4]; 2],
    /// Their prisms.
    pub prisms: [u32; 2],
    /// The point: integer weights on the names of each.
    pub weights: [[IBig; 4]; 2],
}

/// The answer.
#[derive(Debug, Default)]
pub(crate) struct Prisms {
    /// A tet of the decomposition that is not positive: then nothing else was looked at.
    pub(crate) bad: Option<BadTet>,
    /// Triangles of the skin.
    pub(crate) skin: usize,
    /// Pairs of them whose boxes meet.
    pub(crate) pairs: u64,
    /// The planes of the separated pairs that need some, ascending.
    pub(crate) separations: Vec<(u32, u32, Vec<PlaneName>)>,
    /// Tets that overlap.
    pub(crate) overlaps: Vec<Overlap>,
    /// How the signs on the way were decided.
    pub(crate) stages: StageCounts,
}

impl Prisms {
    /// Is the claim certified?
    pub(crate) fn holds(&self) -> bool {
        self.bad.is_none() && self.overlaps.is_empty()
    }
}

/// A face of just one tet: names ascending, and that tet.
type Outside = ([Name; 3], u32);

/// The skin of a set of tets, ascending.
fn skin(tets: &[Tet]) -> Vec<Outside> {
    let mut owners: FxHashMap<[Name; 3], (u32, u32)> = FxHashMap::default();
    for (id, tet) in (0u32..).zip(tets) {
        let [a, b, c, d] = tet.sorted_names();
        for face in [[a, b, c], [a, b, d], [a, c, d], [b, c, d]] {
            owners.entry(face).or_insert((id, 0)).1 += 1;
        }
    }
    let once = owners.into_iter().filter(|(_, (_, times))| *times == 1);
    let mut out: Vec<Outside> = once.map(|(face, (id, _))| (face, id)).collect();
    out.sort_unstable();
    out
}

/// Each triangle's connected part of the skin, by its first triangle; connected across sides that just two have.
fn parts(skin: &[Outside]) -> Vec<u32> {
    let mut at_side: FxHashMap<[Name; 2], Vec<u32>> = FxHashMap::default();
    let sides = |i: u32| {
        let [a, b, c] = skin[i as usize].0;
        [[a, b], [a, c], [b, c]]
    };
    let all = 0..u32::try_from(skin.len()).unwrap_or(u32::MAX);
    for i in all.clone() {
        for side in sides(i) {
            at_side.entry(side).or_default().push(i);
        }
    }
    let mut first = vec![u32::MAX; skin.len()];
    for start in all {
        let mut stack = vec![start];
        while let Some(i) = stack.pop() {
            if first[i as usize] == u32::MAX {
                first[i as usize] = start;
                let near = sides(i).map(|side| &at_side[&side]);
                stack.extend(near.into_iter().filter(|list| list.len() == 2).flatten().copied());
            }
        }
    }
    first
}

struct Job<'a> {
    shell: &'a Shell,
    tets: Vec<Tet>,
    skin: Vec<Outside>,
}

/// What a pair of triangles of the skin turned out to be that the plane of neither separates.
enum Found {
    Planes(Vec<PlaneName>),
    Overlap(Box<Overlap>),
}

/// Decides the claim for one order. O((n + k) log n) for n prisms and k pairs of boxes that meet, and O(n) more for each
/// connected part of the skin.
pub(crate) fn decide(
    shell: &Shell,
    order: &VertexOrder,
    observer: &dyn Observer,
) -> Result<Prisms, CertifyError> {
    let ranks = order.ranks(shell.middle.len());
    let rank = |v: u32| ranks.get(v as usize).copied().unwrap_or(v);
    let prisms = u32::try_from(shell.faces.len()).unwrap_or(u32::MAX);
    let tets: Vec<Tet> = (0..prisms).flat_map(|p| shell.tets_of_order(p, rank)).collect();
    let mut stages = StageCounts::default();
    let flat = |t: &&Tet| {
        let [a, b, c, d] = t.names.map(|n| shell.position(n));
        !stages.note(orient3d_staged(a, b, c, d)).is_positive()
    };
    if let Some(tet) = tets.iter().find(flat) {
        return Ok(Prisms { bad: Some(bad_tet(shell, tet)), stages, ..Prisms::default() });
    }
    let skin = skin(&tets);
    let mut out = Prisms { skin: skin.len(), stages, ..Prisms::default() };
    let job = Job { shell, tets, skin };
    let tree = BoxTree::new(job.skin.iter().map(|(names, _)| names.map(|n| shell.position(n))));
    let found: Vec<Result<_, CertifyError>> = (0..u32::try_from(job.skin.len()).unwrap_or(u32::MAX))
        .into_par_iter()
        .map(|i| {
            if observer.cancelled() {
                return Err(CertifyError::Cancelled);
            }
            observer.advance(1);
            let near = tree.meeting(&job.skin[i as usize].0.map(|n| shell.position(n)));
            let (mut pairs, mut open, mut stages) = (0, Vec::new(), StageCounts::default());
            for j in near.into_iter().filter(|&j| j > i) {
                pairs += 1;
                // Most pairs are separated at once: nothing is kept of them.
                open.extend(job.pair(i, j, &mut stages)?.map(|found| (i, j, found)));
            }
            Ok((pairs, open, stages))
        })
        .collect();
    for part in found {
        let (pairs, open, stages) = part?;
        out.pairs += pairs;
        out.stages += stages;
        for (i, j, found) in open {
            match found {
                Found::Planes(planes) => out.separations.push((i, j, planes)),
                Found::Overlap(overlap) => out.overlaps.push(*overlap),
            }
        }
    }
    job.inside(&mut out);
    Ok(out)
}

impl<'a> Job<'a> {
    fn corners(&self, i: u32) -> [Named<'a>; 3] {
        self.skin[i as usize].0.map(|n| Named { name: PointName::Shell(n), at: self.shell.position(n) })
    }

    fn pair(&self, i: u32, j: u32, stages: &mut StageCounts) -> Result<Option<Found>, CertifyError> {
        let (a, b) = (self.corners(i), self.corners(j));
        let points: Few<Named<'_>> = a.into_iter().chain(b).collect();
        let is_common = |k: usize| {
            let other = if k < 3 { &b } else { &a };
            other.iter().any(|o| o.name == points[k].name)
        };
        let common = (0..6).map(is_common).collect();
        let pair = Pair { common, points, split: 3, exact_common: true };
        if [[0, 1, 2], [3, 4, 5]].into_iter().any(|own| pair.closed_by_staged(own, stages)) {
            return Ok(None);
        }
        if let Some(planes) = pair.separation_staged(stages) {
            return Ok(Some(Found::Planes(planes)));
        }
        let broken = || CertifyError::Internal { what: "triangles that neither meet nor can be separated" };
        let crossing = crossing(i, j, [a, b], &[])?.ok_or_else(broken)?;
        let (owner, weights) =
            ([i, j].map(|i| self.skin[i as usize]), [crossing.in_first, crossing.in_second]);
        let [first, second] = [0, 1].map(|k| self.in_tet(owner[k], &weights[k]));
        Ok(Some(Found::Overlap(Box::new(Overlap {
            tets: [first.0, second.0],
            prisms: owner.map(|(_, tet)| self.tets[tet as usize].prism),
            weights: [first.1, second.1],
        }))))
    }

    /// Weights on a triangle of the skin as weights on its tet.
    fn in_tet(&self, (face, tet): Outside, weights: &[IBig; 3]) -> ([Name; 4], [IBig; 4]) {
        let names = self.tets[tet as usize].sorted_names();
        let weight = |n: Name| face.iter().position(|m| *m == n).map_or(IBig::ZERO, |i| weights[i].clone());
        (names, names.map(weight))
    }

    /// The middles of first triangles of parts of the skin that lie in another tet.
    fn inside(&self, out: &mut Prisms) {
        let points = |t: &Tet| t.names.map(|n| self.shell.position(n));
        let mut roots = parts(&self.skin);
        roots.sort_unstable();
        roots.dedup();
        if roots.is_empty() {
            return;
        }
        let tree = BoxTree::new(self.tets.iter().map(&points));
        let ones = [1, 1, 1].map(IBig::from);
        let third = [1, 1, 1].map(|one| RBig::from(one) / RBig::from(3));
        for root in roots {
            let (face, own) = self.skin[root as usize];
            let corners = face.map(|n| self.shell.position(n));
            for id in tree.meeting(&corners).into_iter().filter(|&id| id != own) {
                let tet = &self.tets[id as usize];
                let piece = ExactPiece::new(corners, points(tet));
                let Some(coordinates) = piece.carrier(&third).and_then(|_| piece.in_tet(&third)) else {
                    continue;
                };
                let ordered = to_integers(&coordinates);
                let names = tet.sorted_names();
                let weight = |n: Name| {
                    tet.names.iter().position(|m| *m == n).map_or(IBig::ZERO, |i| ordered[i].clone())
                };
                let first = self.in_tet((face, own), &ones);
                out.overlaps.push(Overlap {
                    tets: [first.0, names],
                    prisms: [self.tets[own as usize].prism, tet.prism],
                    weights: [first.1, names.map(weight)],
                });
            }
        }
    }
}
