//! Attributes along the map.

use rayon::prelude::*;

use super::{Attribute, AttributeError, Domain, Values};
use crate::mesh::TriMesh;
use crate::number::Rat;
use crate::projection::SectionError;
use crate::transfer::{ExactPoint, FloatMeshPoint, Transfer};

/// Weights on a triangle's corners.
#[derive(Clone, Debug, PartialEq)]
pub enum Weights {
    /// Rational.
    Exact([Rat; 3]),
    /// Rounded.
    Float([f64; 3]),
}

/// A point of the source mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The triangle.
    pub face: u32,
    /// The weights on its corners.
    pub weights: Weights,
    /// A bound for their error.
    pub error: f64,
}

/// The source's points for the target's vertices and for the centroids of its triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// One for each vertex of the target.
    pub vertices: Vec<Sample>,
    /// One for each triangle of the target.
    pub faces: Vec<Sample>,
}

impl Samples {
    /// Carries the target's vertices and the centroids of its triangles back to the source, on rayon's threads.
    ///
    /// # Errors
    /// [`AttributeError`]: a vertex in no triangle, or a point that the map has no answer for.
    pub fn new(transfer: &Transfer<'_>, target: &TriMesh, exact: bool) -> Result<Self, AttributeError> {
        let mut corner = vec![None; target.vertices.len()];
        for (face, corners) in (0_u32..).zip(&target.faces) {
            for (k, &v) in corners.iter().enumerate() {
                if let Some(slot) = corner.get_mut(v as usize) {
                    slot.get_or_insert((face, k));
                }
            }
        }
        let place = |(face, k): (u32, usize)| (face, [0, 1, 2].map(|i| f64::from(u8::from(i == k))));
        // What comes after a vertex in no triangle is not asked for: the first fault is the one to tell.
        let places: Vec<_> = corner.iter().map_while(|found| found.map(place)).collect();
        let vertices = samples(transfer, &places, exact, "vertex")?;
        if vertices.len() < corner.len() {
            return Err(AttributeError::LooseVertex { vertex: vertices.len() });
        }
        let centroids: Vec<_> = (0..).zip(&target.faces).map(|(face, _)| (face, [1.0; 3])).collect();
        Ok(Self { vertices, faces: samples(transfer, &centroids, exact, "triangle")? })
    }
}

/// Points of the source for points of the target, by triangle and weights, on rayon's threads; else the first fault.
fn samples(
    transfer: &Transfer<'_>,
    points: &[(u32, [f64; 3])],
    exact: bool,
    element: &'static str,
) -> Result<Vec<Sample>, AttributeError> {
    let found: Vec<Result<Sample, SectionError>> = if exact {
        let sample = |&(face, weights): &(u32, [f64; 3])| {
            let point = transfer.backward(&ExactPoint::from_f64(face, weights)?)?;
            Ok(Sample { face: point.face, weights: Weights::Exact(point.rationals()), error: 0.0 })
        };
        points.par_iter().map(sample).collect()
    } else {
        let sample = |point: FloatMeshPoint| Sample {
            face: point.face,
            weights: Weights::Float(point.weights),
            error: point.error,
        };
        transfer.backward_batch_f64(points).into_iter().map(|found| found.map(sample)).collect()
    };
    let named = |(index, found): (usize, Result<Sample, SectionError>)| {
        found.map_err(|source| AttributeError::Map { element, index, source })
    };
    found.into_iter().enumerate().map(named).collect()
}

/// The attribute on the target mesh; the table in [`super`] says how. With exact weights the interpolation is
/// exact, too, and rounded once. The samples must be points of this source.
///
/// # Errors
/// [`AttributeError`]: values for another mesh, numbers that are not finite, or labels on corners.
pub fn carry(
    attribute: &Attribute,
    source: &TriMesh,
    samples: &Samples,
) -> Result<Attribute, AttributeError> {
    let expected = match attribute.domain {
        Domain::Vertex => source.vertices.len(),
        Domain::Face => source.faces.len(),
        Domain::Corner => source.faces.len().saturating_mul(3),
    };
    let (found, name) = (attribute.values.len(), attribute.name.clone());
    if found != expected {
        return Err(AttributeError::Count { name, domain: attribute.domain, expected, found });
    }
    if let Values::Numbers { width, data, .. } = &attribute.values
        && let Some(i) = data.iter().position(|x| !x.is_finite())
    {
        return Err(AttributeError::NotFinite { name, element: i / width.max(&1) });
    }
    let corners = |s: &Sample| match attribute.domain {
        Domain::Corner => [0, 1, 2].map(|k| 3 * s.face as usize + k),
        _ => source.faces[s.face as usize].map(|v| v as usize),
    };
    let (domain, values) = match (attribute.domain, &attribute.values) {
        (Domain::Face, values) => {
            (Domain::Face, values.select(samples.faces.iter().map(|s| s.face as usize)))
        }
        (_, Values::Numbers { width, data, bytes }) => {
            let row = |s: &Sample| -> Vec<f64> {
                let at = corners(s);
                (0..*width).map(|c| interpolate(&s.weights, at.map(|e| data[e * width + c]))).collect()
            };
            let data = samples.vertices.iter().flat_map(row).collect();
            (Domain::Vertex, Values::Numbers { width: *width, data, bytes: *bytes })
        }
        (Domain::Corner, _) => return Err(AttributeError::CornerLabels { name }),
        (Domain::Vertex, values) => {
            let nearest = |s: &Sample| nearest(&s.weights, corners(s));
            (Domain::Vertex, values.select(samples.vertices.iter().map(nearest)))
        }
    };
    Ok(Attribute { name, domain, values })
}

fn interpolate(weights: &Weights, values: [f64; 3]) -> f64 {
    match weights {
        // Equal values stay what they are, whatever the weights' rounding.
        _ if values[0].to_bits() == values[1].to_bits() && values[1].to_bits() == values[2].to_bits() => {
            values[0]
        }
        Weights::Float(w) => w.iter().zip(values).map(|(w, x)| w * x).sum(),
        Weights::Exact(w) => {
            // `carry` has seen that the values are finite.
            let term = |(w, x): (&Rat, f64)| w * Rat::try_from(x).unwrap_or_default();
            w.iter().zip(values).map(term).fold(Rat::ZERO, |sum, x| sum + x).to_f64().value()
        }
    }
}

/// The corner with the largest weight; of equal ones the smallest.
fn nearest(weights: &Weights, corners: [usize; 3]) -> usize {
    let larger = |i: usize, j: usize| match weights {
        Weights::Float(w) => w[i] > w[j],
        Weights::Exact(w) => w[i] > w[j],
    };
    let beats = |i: usize, j: usize| larger(i, j) || (!larger(j, i) && corners[i] < corners[j]);
    let first = if beats(1, 0) { 1 } else { 0 };
    corners[if beats(2, first) { 2 } else { first }]
}
