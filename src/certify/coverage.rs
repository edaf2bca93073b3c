//! How often the triangles that face up cover each point of the middle surface: where not at all, and where twice.
//!
//! Within a prism the pieces that face up are mapped onto the middle triangle, affinely and without folding. Where no
//! piece of a prism breaks a rule of sections, none ends inside it, so the number of pieces over a point is the same in
//! the whole prism and, across walls, in all neighbours of that kind: one prism of each connected set of them is enough.

use dashu_ratio::RBig;
use rayon::prelude::*;

use super::CertifyError;
use super::exact::{Vec3, Weights, centre, to_integers, whole};
use super::lift::Lifting;
use super::observer::Observer;
use super::path::{Chart, ExactCorner, preimage};
use super::polygon::{Polygon, bounds, share, sides, within, without};
use super::survey::{Part, Survey};

/// A part of a middle triangle that nothing covers.
#[derive(Clone, Debug)]
pub(crate) struct Uncovered {
    pub(crate) prism: u32,
    /// A point inside it: weights on the prism's corners with sum one.
    pub(crate) weights: [RBig; 3],
    /// Share of the middle triangle's area.
    pub(crate) share: RBig,
}

/// Two points of the mesh over one middle point.
#[derive(Clone, Debug)]
pub(crate) struct Twice {
    pub(crate) prism: u32,
    /// The middle point.
    pub(crate) weights: [RBig; 3],
    pub(crate) faces: [u32; 2],
    /// The points of the mesh: weights on the corners of these triangles.
    pub(crate) on_faces: [[RBig; 3]; 2],
}

#[derive(Debug, Default)]
pub(crate) struct Coverage {
    pub(crate) uncovered: Vec<Uncovered>,
    pub(crate) twice: Vec<Twice>,
}

/// Finds all prisms with points that are not covered just once. Quadratic in the pieces of a prism whose images meet.
pub(crate) fn coverage(
    cx: Lifting<'_>,
    survey: &Survey,
    observer: &dyn Observer,
) -> Result<Coverage, CertifyError> {
    let prism_of = |tet: u32| cx.complex.tets[tet as usize].prism;
    let prisms = cx.complex.shell.faces.len();
    let mut pieces: Vec<Vec<&Part>> = vec![Vec::new(); prisms];
    for part in survey.parts.iter().filter(|p| p.faces_up) {
        pieces[prism_of(part.tet) as usize].push(part);
    }
    let mut dirty = vec![false; prisms];
    survey.failures.iter().for_each(|f| dirty[prism_of(f.tet) as usize] = true);
    let sets = clean_sets(cx, &dirty);
    let firsts = sets.iter().filter_map(|set| set.first().copied());
    let broken = (0..prisms as u32).filter(|&p| dirty[p as usize]);
    let first_round: Vec<u32> = firsts.chain(broken).collect();
    observer.stage("coverage", Some(first_round.len() as u64));
    let look = |prism: u32| {
        if observer.cancelled() {
            return Err(CertifyError::Cancelled);
        }
        observer.advance(1);
        prism_coverage(cx, prism, &pieces[prism as usize])
    };
    let found: Vec<Coverage> = first_round.into_par_iter().map(look).collect::<Result<_, _>>()?;
    let more: Vec<u32> = sets
        .iter()
        .zip(&found)
        .filter(|(_, c)| !(c.uncovered.is_empty() && c.twice.is_empty()))
        .flat_map(|(set, _)| set.iter().skip(1).copied())
        .collect();
    let rest: Vec<Coverage> = more.into_par_iter().map(look).collect::<Result<_, _>>()?;
    let mut out = Coverage::default();
    for part in found.into_iter().chain(rest) {
        out.uncovered.extend(part.uncovered);
        out.twice.extend(part.twice);
    }
    out.uncovered.sort_by_key(|u| u.prism);
    out.twice.sort_by_key(|t| (t.prism, t.faces));
    Ok(out)
}

/// The prisms without failures, in sets that are connected across walls.
fn clean_sets(cx: Lifting<'_>, dirty: &[bool]) -> Vec<Vec<u32>> {
    let mut seen = dirty.to_vec();
    let mut out = Vec::new();
    for start in 0..dirty.len() {
        if std::mem::replace(&mut seen[start], true) {
            continue;
        }
        let mut set = vec![start as u32];
        let mut next = 0;
        while let Some(&prism) = set.get(next) {
            next += 1;
            for near in cx.complex.middle.neighbours(prism).into_iter().flatten() {
                if !std::mem::replace(&mut seen[near as usize], true) {
                    set.push(near);
                }
            }
        }
        out.push(set);
    }
    out
}

/// Bounds of weights, rounded outwards.
type Bounds = [[f64; 2]; 3];

/// A piece with its image.
struct Image<'a> {
    part: &'a Part,
    corners: Vec<ExactCorner>,
    polygon: Polygon,
    /// Half spaces of the polygon.
    sides: Vec<Vec3>,
    bounds: Bounds,
}

/// Do closed boxes meet? Only then can the polygons in them share area.
fn meet(a: &Bounds, b: &Bounds) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

fn prism_coverage(cx: Lifting<'_>, prism: u32, parts: &[&Part]) -> Result<Coverage, CertifyError> {
    let mut images: Vec<Image<'_>> = Vec::with_capacity(parts.len());
    let mut out = Coverage::default();
    let mut left: Vec<(Bounds, Polygon)> = vec![(bounds(&whole()), whole())];
    for part in parts {
        let corners = cx.exact_polygon(part.face, part.tet, &part.masks)?;
        let polygon: Vec<Weights> = corners.iter().map(|c| to_integers(&c.projected)).collect();
        let (sides, bounds_here) = (sides(&polygon), bounds(&polygon));
        let image = Image { part, corners, polygon, sides, bounds: bounds_here };
        let (near, apart): (Vec<_>, Vec<_>) = left.into_iter().partition(|(b, _)| meet(b, &image.bounds));
        let rest = without(near.into_iter().map(|(_, p)| p).collect(), &image.sides);
        left = apart;
        left.extend(rest.into_iter().map(|p| (bounds(&p), p)));
        let near = images.iter().filter(|i| meet(&i.bounds, &image.bounds));
        out.twice.extend(near.into_iter().find_map(|i| twice(prism, i, &image)));
        images.push(image);
    }
    let left: Vec<Polygon> = left.into_iter().map(|(_, p)| p).collect();
    out.uncovered.extend(uncovered(prism, &left));
    Ok(out)
}

fn uncovered(prism: u32, left: &[Polygon]) -> Option<Uncovered> {
    let shares: Vec<RBig> = left.iter().map(|p| share(p)).collect();
    let largest = (0..left.len()).max_by(|&i, &j| shares[i].cmp(&shares[j]))?;
    let weights = centre(left.get(largest)?)?;
    Some(Uncovered { prism, weights, share: shares.into_iter().fold(RBig::ZERO, |sum, x| sum + x) })
}

fn twice(prism: u32, a: &Image<'_>, b: &Image<'_>) -> Option<Twice> {
    let common = within(&b.polygon, &a.sides);
    let weights = centre(&common)?;
    let on_a = preimage(&a.corners, Chart::Middle, &weights)?;
    let on_b = preimage(&b.corners, Chart::Middle, &weights)?;
    Some(Twice { prism, weights, faces: [a.part.face, b.part.face], on_faces: [on_a, on_b] })
}
