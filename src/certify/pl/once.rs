//! One point of every boundary component lies in one cell only.

use dashu_int::IBig;

use super::super::exact::{Vec3, determinant};
use super::super::pairs::BoxTree;
use super::super::separate::Few;
use super::facets::Facets;
use super::points::Point;
use super::witness::Witness;

/// For the smallest facet of every boundary component: the other closed cells that hold its centroid. The cells are
/// not flat.
pub(super) fn covered_twice<P: Point>(facets: &Facets<'_>, boundary: &[u32], points: &[P]) -> Vec<Witness> {
    let corners =
        |ids: &[u32]| -> Vec<[f64; 3]> { ids.iter().flat_map(|&v| points[v as usize].corners()).collect() };
    let boxes: Vec<Vec<[f64; 3]>> = (0..facets.cells.len()).map(|c| corners(facets.cells.cell(c))).collect();
    let tree = BoxTree::new(boxes.iter().map(|b| b.iter().collect::<Few<_>>()));
    let mut out = Vec::new();
    for facet in facets.boundary_roots(boundary) {
        let ids = facets.vertices(facet);
        let near = tree.meeting(&corners(&ids).iter().collect::<Vec<_>>());
        for cell in near.into_iter().filter(|&c| c != facets.cell(facet)) {
            if holds(facets.cells.cell(cell as usize), &ids, points) {
                out.push(Witness::Twice(facet, cell));
            }
        }
    }
    out
}

/// Does the closed cell hold the centroid of the points?
fn holds<P: Point>(cell: &[u32], facet: &[u32], points: &[P]) -> bool {
    let all: Vec<&P> = cell.iter().chain(facet).map(|&v| &points[v as usize]).collect();
    let scaled = P::integers(&all);
    let (corners, ends) = scaled.split_at(cell.len().min(scaled.len()));
    // All times the number of points, so that the centroid is their sum.
    let n = IBig::from(ends.len());
    let mut corners: Vec<Vec3> = corners.iter().map(|p| p.each_ref().map(|x| x * &n)).collect();
    let centroid = [0, 1, 2].map(|i| ends.iter().map(|p| &p[i]).sum::<IBig>());
    let whole = value(&corners);
    let negative = whole < IBig::ZERO;
    (0..corners.len()).all(|k| {
        let kept = std::mem::replace(&mut corners[k], centroid.clone());
        let part = value(&corners);
        corners[k] = kept;
        part == IBig::ZERO || (part < IBig::ZERO) == negative
    })
}

/// The determinant of a triangle in the plane or of a tet.
fn value(corners: &[Vec3]) -> IBig {
    match corners {
        [a, b, c] => (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0]),
        [a, b, c, d] => determinant(a, b, c, d),
        _ => IBig::ZERO,
    }
}
