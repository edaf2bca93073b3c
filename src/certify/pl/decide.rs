//! The verdicts.

use super::super::CertifyError;
use super::super::claim::Verdict;
use super::super::observer::Observer;
use super::super::separate::PlaneName;
use super::apart::{self, Triangle};
use super::facets::Facets;
use super::points::{Homogeneous, Point};
use super::signs::{self, SignCounts};
use super::witness::{Input, Witness};
use super::{once, plane, sound, write};
use crate::mesh::{Cells, Complex, Positions, Space};
use crate::number::{Rat, Rational};

/// Why there is no verdict.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PlError {
    /// There is nothing to prove anything about.
    #[error("there are no cells")]
    NoCells,
    /// More than handles can name.
    #[error("{0} cells are more than can be handled")]
    TooMany(usize),
    /// A cell names a vertex that does not exist.
    #[error("cell {cell}: vertex index {vertex} is out of range (there are {vertices} vertices)")]
    Index {
        /// The cell.
        cell: usize,
        /// The index.
        vertex: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// Two inputs with different numbers of vertices, or cells of different kinds.
    #[error("the inputs are not one complex: {0}")]
    Sizes(String),
    /// Two inputs that differ in a cell.
    #[error("the inputs are not one complex: they differ in cell {0}")]
    Cells(usize),
    /// A coordinate that is no number.
    #[error("vertex {vertex}: a coordinate is not finite")]
    NotFinite {
        /// The vertex.
        vertex: usize,
    },
    /// A number that certificates do not hold.
    #[error("vertex {vertex}: a coordinate has more than 4000 digits, which no certificate may have")]
    Digits {
        /// The vertex.
        vertex: usize,
    },
    /// The claim is about surfaces in space.
    #[error("`embedded` is about triangles in space")]
    NoSurface,
    /// Interrupted, or a contradiction in the program.
    #[error(transparent)]
    Certify(#[from] CertifyError),
}

/// What was found in one input.
#[derive(Debug, Default)]
pub struct Side {
    /// Reasons against it; none: the positions embed the complex.
    pub witnesses: Vec<Witness>,
    /// Numbers.
    pub facts: Facts,
    pub(in crate::certify) separations: Vec<(u32, u32, Vec<PlaneName>)>,
}

/// Numbers about one input.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Facts {
    /// Signs of the determinants; `None` for a surface in space.
    pub signs: Option<SignCounts>,
    /// Boundary facets.
    pub boundary_facets: u64,
    /// Components of the boundary.
    pub boundary_components: u64,
    /// Components.
    pub components: u64,
    /// Pairs of triangles or boundary facets whose boxes meet; `None` if they were not looked at.
    pub pairs: Option<u64>,
    /// Pairs among these that meet where they must not.
    pub crossings: u64,
}

/// The verdict with its proof.
#[derive(Debug)]
pub struct PlOutcome {
    /// Certified or refuted.
    pub verdict: Verdict,
    /// Are the cells an oriented manifold? If not, the witness of that stands at the first input.
    pub sound: bool,
    /// One for each input.
    pub sides: Vec<Side>,
    /// The certificate or the refutation, in the format of `certs/MESHES.md`.
    pub certificate: String,
}

/// Decides C8: the map between two position sets of one complex that is affine on cells is a homeomorphism.
/// O((M + k) log M) for k pairs of boxes that meet.
///
/// # Errors
/// [`PlError`] if the inputs are not one complex, or the work was interrupted.
pub fn pl_homeomorphism(a: &Complex, b: &Complex, observer: &dyn Observer) -> Result<PlOutcome, PlError> {
    let cells = |c: &Complex| format!("{} cells of {} corners", c.cells.len(), c.cells.corners());
    if a.cells.corners() != b.cells.corners() || a.cells.len() != b.cells.len() {
        return Err(PlError::Sizes(format!("{} and {}", cells(a), cells(b))));
    }
    if a.positions.len() != b.positions.len() {
        let sizes = format!("{} and {} vertices", a.positions.len(), b.positions.len());
        return Err(PlError::Sizes(sizes));
    }
    if let Some(i) = (0..a.cells.len()).find(|&i| a.cells.cell(i) != b.cells.cell(i)) {
        return Err(PlError::Cells(i));
    }
    let facets = facets(a)?;
    check_positions(&b.positions)?;
    let defect = sound::defect(&facets, a.positions.len());
    let one = |complex: &Complex, known: Option<&Witness>| match known {
        // The cells are the same: one witness does for both.
        Some(_) => Ok(Side { facts: counts(&facets), ..Side::default() }),
        None => side(complex, &facets, observer),
    };
    let sound = defect.is_none();
    let mut sides = vec![one(a, defect.as_ref())?, one(b, defect.as_ref())?];
    sides[0].witnesses.extend(defect);
    let verdict = Verdict::of(sides.iter().all(|s| s.witnesses.is_empty()));
    let named = [(Input::A, a, &sides[0]), (Input::B, b, &sides[1])];
    let certificate = write::certificate("pl-homeomorphism", verdict, &named);
    Ok(PlOutcome { verdict, sound, sides, certificate })
}

/// Decides C6 for one surface in space: its triangles share only what their common vertices force.
///
/// # Errors
/// [`PlError`] if it is no surface in space, or the work was interrupted.
pub fn embedded(a: &Complex, observer: &dyn Observer) -> Result<PlOutcome, PlError> {
    if a.cells.corners() != 3 || a.space != Space::Space {
        return Err(PlError::NoSurface);
    }
    let side = side_facts(a, observer)?;
    let verdict = Verdict::of(side.witnesses.is_empty());
    let certificate = write::certificate("embedded", verdict, &[(Input::A, a, &side)]);
    let sound = !side.witnesses.iter().any(Witness::is_defect);
    Ok(PlOutcome { verdict, sound, sides: vec![side], certificate })
}

/// What one input of C8 has to fulfil: are the positions an embedding of the complex, which must be sound?
///
/// # Errors
/// [`PlError`] if there is nothing to look at, or the work was interrupted.
pub fn side_facts(complex: &Complex, observer: &dyn Observer) -> Result<Side, PlError> {
    let facets = facets(complex)?;
    match sound::defect(&facets, complex.positions.len()) {
        None => side(complex, &facets, observer),
        Some(defect) => {
            let mut out = Side { witnesses: vec![defect], facts: counts(&facets), ..Side::default() };
            out.facts.signs = sign_counts(complex, &facets);
            Ok(out)
        }
    }
}

pub(in crate::certify) fn facets(complex: &Complex) -> Result<Facets<'_>, PlError> {
    let cells = &complex.cells;
    if cells.is_empty() {
        return Err(PlError::NoCells);
    }
    if cells.len() > (u32::MAX / 8) as usize {
        return Err(PlError::TooMany(cells.len()));
    }
    let vertices = complex.positions.len();
    if let Some(i) = cells.flat().iter().position(|&v| v as usize >= vertices) {
        let (cell, vertex) = (i / cells.corners(), cells.flat()[i]);
        return Err(PlError::Index { cell, vertex, vertices });
    }
    check_positions(&complex.positions)?;
    Ok(Facets::new(cells))
}

fn check_positions(positions: &Positions) -> Result<(), PlError> {
    match positions {
        Positions::Float(points) => {
            let odd = points.iter().position(|p| p.iter().any(|x| !x.is_finite()));
            odd.map_or(Ok(()), |vertex| Err(PlError::NotFinite { vertex }))
        }
        Positions::Exact(points) => {
            let long = points.iter().position(|p| p.iter().any(is_long));
            long.map_or(Ok(()), |vertex| Err(PlError::Digits { vertex }))
        }
    }
}

/// Numbers below `2^BITS` have at most 4000 digits.
const BITS: u64 = 13_287;

fn is_long(x: &Rat) -> bool {
    let (numerator, denominator) = Rational::bit_lengths(x);
    numerator.max(denominator) > BITS
}

fn counts(facets: &Facets<'_>) -> Facts {
    let boundary = facets.boundary();
    let components = facets.components();
    Facts {
        boundary_facets: boundary.len() as u64,
        boundary_components: facets.boundary_roots(&boundary).len() as u64,
        components: components.iter().enumerate().filter(|(i, c)| *i == **c as usize).count() as u64,
        ..Facts::default()
    }
}

fn is_surface(complex: &Complex) -> bool {
    complex.space == Space::Space && matches!(complex.cells, Cells::Triangles(_))
}

fn homogeneous(positions: &[[Rat; 3]]) -> Vec<Homogeneous> {
    positions.iter().map(Homogeneous::new).collect()
}

fn sign_counts(complex: &Complex, facets: &Facets<'_>) -> Option<SignCounts> {
    if is_surface(complex) {
        return None;
    }
    Some(signs::count(&match &complex.positions {
        Positions::Float(points) => signs::of_cells(facets, points),
        Positions::Exact(points) => signs::of_cells(facets, &homogeneous(points)),
    }))
}

fn side(complex: &Complex, facets: &Facets<'_>, observer: &dyn Observer) -> Result<Side, PlError> {
    let found = match &complex.positions {
        Positions::Float(points) => positions(complex, facets, points, observer),
        Positions::Exact(points) => positions(complex, facets, &homogeneous(points), observer),
    };
    Ok(found?)
}

fn positions<P: Point>(
    complex: &Complex,
    facets: &Facets<'_>,
    points: &[P],
    observer: &dyn Observer,
) -> Result<Side, CertifyError> {
    let mut out = Side { facts: counts(facets), ..Side::default() };
    if is_surface(complex) {
        surface(facets, points, observer, &mut out)?;
    } else {
        full(facets, points, observer, &mut out)?;
    }
    Ok(out)
}

fn surface<P: Point>(
    facets: &Facets<'_>,
    points: &[P],
    observer: &dyn Observer,
    out: &mut Side,
) -> Result<(), CertifyError> {
    let mut triangles = Vec::with_capacity(facets.cells.len());
    for id in 0..facets.cells.len() as u32 {
        let Ok(vertices) = <[u32; 3]>::try_from(facets.cells.cell(id as usize)) else { continue };
        let [a, b, c] = vertices.map(|v| &points[v as usize]);
        if P::projection_axis(a, b, c).is_none() {
            out.witnesses.push(Witness::Flat(id));
        }
        triangles.push(Triangle { id, vertices, cell: id, places: [0, 1, 2], k: 3 });
    }
    out.witnesses.truncate(write::LINES);
    // Pairs with a flat triangle have no plane to cut with.
    if out.witnesses.is_empty() { triangles_apart(&triangles, points, observer, out) } else { Ok(()) }
}

fn triangles_apart<P: Point>(
    triangles: &[Triangle],
    points: &[P],
    observer: &dyn Observer,
    out: &mut Side,
) -> Result<(), CertifyError> {
    observer.stage("pairs", Some(triangles.len() as u64));
    let found = apart::decide(triangles, points, observer)?;
    out.facts.pairs = Some(found.pairs);
    out.facts.crossings = found.crossings.len() as u64;
    out.witnesses.extend(apart::distinct(&found.crossings, write::LINES));
    out.separations = found.separations;
    Ok(())
}

fn full<P: Point>(
    facets: &Facets<'_>,
    points: &[P],
    observer: &dyn Observer,
    out: &mut Side,
) -> Result<(), CertifyError> {
    let cells = signs::of_cells(facets, points);
    out.facts.signs = Some(signs::count(&cells));
    out.witnesses = signs::witnesses(&cells, &facets.components(), write::LINES);
    let boundary = facets.boundary();
    // A flat facet cannot be cut with, and a flat cell holds no point to count: the signs are witness enough.
    if !out.witnesses.is_empty() {
        return Ok(());
    }
    if facets.k() == 3 {
        let (pairs, crossings) = plane::crossings(facets, &boundary, points, observer)?;
        out.facts.pairs = Some(pairs);
        out.facts.crossings = crossings.len() as u64;
        out.witnesses.extend(crossings.into_iter().take(write::LINES));
    } else {
        let triangles: Vec<Triangle> = boundary.iter().filter_map(|&f| triangle(facets, f)).collect();
        triangles_apart(&triangles, points, observer, out)?;
    }
    let twice = once::covered_twice(facets, &boundary, points);
    out.witnesses.extend(twice.into_iter().take(write::LINES));
    Ok(())
}

fn triangle(facets: &Facets<'_>, facet: u32) -> Option<Triangle> {
    let vertices = <[u32; 3]>::try_from(facets.vertices(facet)).ok()?;
    let places = <[usize; 3]>::try_from(facets.places(facet)).ok()?;
    Some(Triangle { id: facet, vertices, cell: facets.cell(facet), places, k: facets.k() })
}
