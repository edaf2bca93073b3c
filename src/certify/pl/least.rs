//! The least determinant of a complex of tets, and the Euler characteristic of its boundary.

use dashu_int::IBig;
use serde::Serialize;

use super::super::exact::{Vec3, determinant};
use super::decide::{PlError, facets};
use crate::mesh::{Cells, Complex, Positions};
use crate::number::dyadic::scale_points;
use crate::number::{Dyadic, Rat, Rational};

/// A determinant (six times the signed volume).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Least {
    /// The tet; of several, the first.
    pub cell: usize,
    /// The value, rounded.
    pub near: f64,
    /// The value: `0`, `3*2^-12` or `3/7`.
    pub exact: String,
}

/// The least determinant of all tets, computed exactly; `None` if there are none. O(M) big numbers.
#[must_use]
pub fn least_determinant(complex: &Complex) -> Option<Least> {
    let Cells::Tets(tets) = &complex.cells else { return None };
    let mut best: Option<(Rat, usize)> = None;
    for (cell, tet) in tets.iter().enumerate() {
        let value = value(&complex.positions, *tet)?;
        if best.as_ref().is_none_or(|(least, _)| value < *least) {
            best = Some((value, cell));
        }
    }
    best.map(|(value, cell)| Least {
        cell,
        near: Rational::to_f64(&value),
        exact: Dyadic::from_rational(&value).map_or_else(|| value.to_text(), |d| d.to_string()),
    })
}

fn value(positions: &Positions, tet: [u32; 4]) -> Option<Rat> {
    match positions {
        Positions::Float(points) => {
            let corners: Vec<[f64; 3]> =
                tet.iter().filter_map(|&v| points.get(v as usize).copied()).collect();
            let (x, scale) = scale_points(&corners);
            let whole = Rat::from(of(&x)?);
            // Three factors, each scaled.
            Some(whole.times(&Rat::from_scaled(1, scale.saturating_mul(3))))
        }
        Positions::Exact(points) => {
            let at = |i: usize| tet.get(i).and_then(|&v| points.get(v as usize));
            let [a, b, c, d] = [at(0)?, at(1)?, at(2)?, at(3)?];
            let [p, q, r] = [b, c, d].map(|x| [0, 1, 2].map(|i| x[i].minus(&a[i])));
            Some(super::super::exact::det3([&p, &q, &r]))
        }
    }
}

fn of(x: &[Vec3]) -> Option<IBig> {
    match x {
        [a, b, c, d] => Some(determinant(a, b, c, d)),
        _ => None,
    }
}

/// Vertices minus edges plus triangles of the boundary of a complex of tets.
///
/// # Errors
/// [`PlError`] for a complex without cells, with too many, or with an index out of range.
pub fn boundary_euler(complex: &Complex) -> Result<i64, PlError> {
    let facets = facets(complex)?;
    let (mut vertices, mut edges, mut triangles) = (Vec::new(), Vec::new(), 0_i64);
    for facet in facets.boundary() {
        let v = facets.vertices(facet);
        for (i, &p) in v.iter().enumerate() {
            let q = v[(i + 1) % v.len()];
            edges.push([p.min(q), p.max(q)]);
        }
        vertices.extend(v);
        triangles += 1;
    }
    vertices.sort_unstable();
    vertices.dedup();
    edges.sort_unstable();
    edges.dedup();
    let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    Ok(count(vertices.len()) - count(edges.len()) + triangles)
}
