//! Maps between surfaces that are given at vertices: each vertex of `B` has a place in a triangle of `A`.
//!
//! Such places give a map `B -> A` only where each triangle of `B` has its three places in one closed triangle of `A`:
//! then the map that is affine there is meant. (Elsewhere "linear between the places" says nothing: the image of the
//! triangle would have to bend over edges of `A`, and the places do not say how.) For a map of this kind it is decided
//! whether it is a homeomorphism of the abstract surfaces; whether `A` or `B` meets itself in space is another claim.
//!
//! The proof is rule R2 of THEORY section 3 with `B` as the overlay: the triangles' areas in the barycentric
//! coordinates of `A` have one strict sign on a component of `B`, boundary edges lie in boundary edges, and in every
//! component of `A` one point has just one preimage.

use rustc_hash::FxHashMap;

use super::super::exact::{det3, mean};
use super::facets::Facets;
use super::sound;
use super::witness::Witness;
use crate::mesh::{Cells, SurfacePoint, TriMesh};
use crate::number::{Rat, Rational};
use crate::predicate::Sign;

/// Why there is no verdict.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CorrespondenceError {
    /// As many places as vertices are needed.
    #[error("{places} places for {vertices} vertices")]
    Count {
        /// Places in the file.
        places: usize,
        /// Vertices of `B`.
        vertices: usize,
    },
    /// A surface that is no oriented manifold.
    #[error("the surface {which} is no oriented manifold: {}", .witness.sentence())]
    Unsound {
        /// `A` or `B`.
        which: &'static str,
        /// The reason.
        witness: Witness,
    },
    /// A surface without triangles, with too many, or with an index out of range.
    #[error("the surface {0} has no triangles, too many, or an index out of range")]
    Surface(&'static str),
}

/// What the places give. Triangles are those of `B`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mapped {
    /// A homeomorphism.
    Homeomorphism,
    /// No map: the places of these triangles are in no closed triangle of `A` together. Not a refutation.
    NotAMap(Vec<u32>),
    /// A triangle whose image is a segment or point.
    Flat(u32),
    /// Two triangles of a component whose images are oriented against each other.
    Fold([u32; 2]),
    /// A triangle with a boundary edge whose image does not lie in the boundary of `A`.
    Boundary(u32),
    /// No point of the component of `A` with this triangle is reached.
    Missed(u32),
    /// The centre of the first triangle's image lies in the second one's image, too.
    Twice([u32; 2]),
}

struct Map<'a> {
    a: Facets<'a>,
    b: Facets<'a>,
    places: &'a [SurfacePoint],
    /// Triangles of `A` by their sorted vertices.
    triangles: FxHashMap<[u32; 3], u32>,
    /// Edges of `A`, sorted: a triangle at it, and whether it is on the boundary.
    edges: FxHashMap<[u32; 2], (u32, bool)>,
}

/// Decides whether the places are a homeomorphism `B -> A`. O(n log n).
///
/// # Errors
/// [`CorrespondenceError`] if the numbers do not fit or a surface is no oriented manifold.
pub fn map_by_correspondence(
    a: &TriMesh,
    b: &TriMesh,
    places: &[SurfacePoint],
) -> Result<Mapped, CorrespondenceError> {
    if places.len() != b.vertices.len() {
        return Err(CorrespondenceError::Count { places: places.len(), vertices: b.vertices.len() });
    }
    let (cells_a, cells_b) = (Cells::Triangles(a.faces.clone()), Cells::Triangles(b.faces.clone()));
    let a = facets("A", &cells_a, a.vertices.len())?;
    let b = facets("B", &cells_b, b.vertices.len())?;
    if places.iter().any(|(t, _)| *t as usize >= cells_a.len()) {
        return Err(CorrespondenceError::Surface("A"));
    }
    Ok(Map::new(a, b, places).decide())
}

fn facets<'a>(
    which: &'static str,
    cells: &'a Cells,
    vertices: usize,
) -> Result<Facets<'a>, CorrespondenceError> {
    let inside = cells.flat().iter().all(|&v| (v as usize) < vertices);
    if cells.is_empty() || cells.len() > (u32::MAX / 8) as usize || !inside {
        return Err(CorrespondenceError::Surface(which));
    }
    let facets = Facets::new(cells);
    match sound::defect(&facets, vertices) {
        Some(witness) => Err(CorrespondenceError::Unsound { which, witness }),
        None => Ok(facets),
    }
}

impl<'a> Map<'a> {
    fn new(a: Facets<'a>, b: Facets<'a>, places: &'a [SurfacePoint]) -> Self {
        let mut triangles = FxHashMap::default();
        for t in 0..a.cells.len() as u32 {
            let mut key = corners(&a, t);
            key.sort_unstable();
            triangles.insert(key, t);
        }
        let edges = a.groups().map(|g| ([g[0].0[0], g[0].0[1]], (a.cell(g[0].1), g.len() == 1))).collect();
        Self { a, b, places, triangles, edges }
    }

    /// The vertices of `A` with positive weight at a vertex of `B`.
    fn carrier(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let (triangle, weights) = &self.places[vertex as usize];
        let ids = corners(&self.a, *triangle);
        ids.into_iter().zip(weights.clone()).filter(|(_, w)| !w.is_zero()).map(|(v, _)| v)
    }

    fn carriers(&self, vertices: &[u32]) -> Vec<u32> {
        let mut ids: Vec<u32> = vertices.iter().flat_map(|&v| self.carrier(v)).collect();
        ids.sort_unstable();
        ids.dedup();
        ids
    }

    /// A triangle of `A` that holds the places of a triangle of `B`.
    fn target(&self, face: u32) -> Option<u32> {
        match self.carriers(&corners(&self.b, face))[..] {
            // All three places are one vertex, which the triangle of any of them has.
            [_] => corners(&self.b, face).first().map(|&v| self.places[v as usize].0),
            [u, v] => self.edges.get(&[u, v]).map(|(t, _)| *t),
            [u, v, w] => self.triangles.get(&[u, v, w]).copied(),
            _ => None,
        }
    }

    /// The weights of a vertex of `B` on the corners of a triangle of `A` that holds its place.
    fn weights(&self, vertex: u32, target: u32) -> [Rat; 3] {
        let (triangle, weights) = &self.places[vertex as usize];
        let from = corners(&self.a, *triangle);
        corners(&self.a, target)
            .map(|v| from.iter().position(|u| *u == v).map_or(Rat::ZERO, |i| weights[i].clone()))
    }

    fn image(&self, face: u32, target: u32) -> [[Rat; 3]; 3] {
        corners(&self.b, face).map(|v| self.weights(v, target))
    }

    fn decide(&self) -> Mapped {
        let faces = 0..self.b.cells.len() as u32;
        let targets: Vec<Option<u32>> = faces.clone().map(|f| self.target(f)).collect();
        let bent: Vec<u32> = faces.filter(|&f| targets[f as usize].is_none()).collect();
        if !bent.is_empty() {
            return Mapped::NotAMap(bent);
        }
        let targets: Vec<u32> = targets.into_iter().flatten().collect();
        self.orientation(&targets)
            .or_else(|| self.boundary())
            .or_else(|| self.degree(&targets))
            .unwrap_or(Mapped::Homeomorphism)
    }

    fn orientation(&self, targets: &[u32]) -> Option<Mapped> {
        let mut known: FxHashMap<u32, (Sign, u32)> = FxHashMap::default();
        let components = self.b.components();
        for (face, &target) in targets.iter().enumerate() {
            let [p, q, r] = self.image(face as u32, target);
            let sign = Rational::sign(&det3([&p, &q, &r]));
            if sign.is_zero() {
                return Some(Mapped::Flat(face as u32));
            }
            let (first, example) = *known.entry(components[face]).or_insert((sign, face as u32));
            if first != sign {
                return Some(Mapped::Fold([example, face as u32]));
            }
        }
        None
    }

    /// Triangles are not flat, so the ends of an edge have two carriers together at least.
    fn boundary(&self) -> Option<Mapped> {
        let inner = |facet: &u32| match self.carriers(&self.b.vertices(*facet))[..] {
            [u, v] => !self.edges.get(&[u, v]).is_some_and(|(_, boundary)| *boundary),
            _ => true,
        };
        self.b.boundary().into_iter().find(inner).map(|facet| Mapped::Boundary(self.b.cell(facet)))
    }

    /// The centre of an image lies inside its triangle of `A`, so only images in that triangle can hold it.
    fn degree(&self, targets: &[u32]) -> Option<Mapped> {
        let components = self.a.components();
        let mut first: FxHashMap<u32, u32> = FxHashMap::default();
        let mut inside: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
        for (face, &target) in targets.iter().enumerate() {
            first.entry(components[target as usize]).or_insert(face as u32);
            inside.entry(target).or_default().push(face as u32);
        }
        let roots = (0..components.len() as u32).filter(|&t| components[t as usize] == t);
        for root in roots {
            let Some(&face) = first.get(&root) else { return Some(Mapped::Missed(root)) };
            let target = targets[face as usize];
            let centre = mean(&self.image(face, target));
            let others = inside.get(&target).into_iter().flatten().filter(|&&other| other != face);
            for &other in others {
                if holds(&self.image(other, target), &centre) {
                    return Some(Mapped::Twice([face, other]));
                }
            }
        }
        None
    }
}

/// Does a triangle that is not flat hold the point? All in barycentric coordinates.
fn holds(triangle: &[[Rat; 3]; 3], point: &[Rat; 3]) -> bool {
    let [p, q, r] = triangle;
    let whole = Rational::sign(&det3([p, q, r]));
    [[point, q, r], [p, point, r], [p, q, point]]
        .into_iter()
        .all(|rows| !Rational::sign(&det3(rows)).is_opposite(whole))
}

fn corners(facets: &Facets<'_>, triangle: u32) -> [u32; 3] {
    match *facets.cells.cell(triangle as usize) {
        [a, b, c] => [a, b, c],
        _ => [0; 3],
    }
}
