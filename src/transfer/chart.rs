//! A mesh in a shell with its pieces sorted by triangle and by prism: both directions of `P_T`.

use rayon::prelude::*;

use super::exact::Big3;
use super::near::Near;
use super::piece::{Piece, Place};
use super::quadtree::{QuadTree, SLACK};
use crate::mesh::TriMesh;
use crate::predicate::Sign;
use crate::projection::{Projection, SectionError, Stars, well_formed};
use crate::shell::Name;

/// Shorter lists are searched from end to end.
const FEW: usize = 8;

/// A list of pieces, with a tree where it is long.
#[derive(Debug)]
struct List {
    all: Vec<u32>,
    tree: Option<QuadTree>,
}

impl List {
    fn near(&self, weights: &Near) -> &[u32] {
        match &self.tree {
            Some(tree) if weights.error() <= SLACK => tree.candidates(weights.values),
            _ => &self.all,
        }
    }
}

/// A mesh cut by the tets of a shell.
#[derive(Debug)]
pub(super) struct Chart<'a> {
    pub(super) place: Place<'a>,
    stars: Stars,
    pieces: Vec<Piece>,
    of_face: Vec<List>,
    of_prism: Vec<List>,
}

/// A mesh point over a middle point.
pub(super) struct Hit<'c> {
    pub(super) piece: &'c Piece,
    /// Of its weights on the corners of the piece's triangle.
    pub(super) signs: [Sign; 3],
}

impl<'a> Chart<'a> {
    /// All pieces, on all threads; `O(n log n)` for `n` pieces and about 300 bytes for each.
    pub(super) fn new(projection: &'a Projection<'a>, mesh: &'a TriMesh) -> Result<Self, SectionError> {
        well_formed(mesh)?;
        let place = Place { projection, mesh };
        // `well_formed` has seen that the number fits.
        let faces = u32::try_from(mesh.faces.len()).unwrap_or(u32::MAX);
        let pieces: Vec<Piece> = (0..faces).into_par_iter().flat_map_iter(|f| place.pieces(f)).collect();
        let count = u32::try_from(pieces.len())
            .map_err(|_| SectionError::Mesh("its triangles have too many pieces in the shell".to_owned()))?;
        let mut of_face = vec![Vec::new(); mesh.faces.len()];
        let mut of_prism = vec![Vec::new(); projection.shell().prism_count()];
        for (id, piece) in (0..count).zip(&pieces) {
            of_face[piece.face as usize].push(id);
            if piece.inverse.is_some() {
                of_prism[place.tet(piece).prism as usize].push(id);
            }
        }
        let by_face = |id: u32| pieces[id as usize].lambda.to_vec();
        let by_prism = |id: u32| pieces[id as usize].inverse.map_or_else(Vec::new, |rows| rows.to_vec());
        let of_face = of_face.into_par_iter().map(|all| listed(all, &by_face)).collect();
        let of_prism = of_prism.into_par_iter().map(|all| listed(all, &by_prism)).collect();
        let stars = Stars::new(mesh.vertices.len(), &mesh.faces);
        Ok(Self { place, stars, pieces, of_face, of_prism })
    }

    /// A piece that holds a point of a triangle, and the signs of its tet coordinates.
    ///
    /// Where several do, they must say the same place of the shell: the same smallest simplex.
    pub(super) fn piece_at(
        &self,
        face: u32,
        near: &Near,
        weights: &dyn Fn() -> Big3,
    ) -> Result<(&Piece, [Sign; 4]), SectionError> {
        let list = self.of_face.get(face as usize).ok_or(SectionError::MeshPoint { face })?;
        let mut found: Option<(&Piece, [Sign; 4])> = None;
        for &id in list.near(near) {
            let piece = &self.pieces[id as usize];
            let Some(signs) = self.place.signs_in_tet(piece, near, weights) else { continue };
            match &found {
                None => found = Some((piece, signs)),
                Some((first, theirs)) if self.carrier(first, theirs) == self.carrier(piece, &signs) => {}
                Some(_) => return Err(SectionError::SeveralImages { face, count: 2 }),
            }
        }
        found.ok_or(SectionError::Outside { face })
    }

    /// The tet vertices with positive coordinates, ascending, then none.
    fn carrier(&self, piece: &Piece, signs: &[Sign; 4]) -> [Option<Name>; 4] {
        let names = self.place.tet(piece).names;
        let mut out = [0, 1, 2, 3].map(|k| signs[k].is_positive().then_some(names[k]));
        out.sort_unstable_by(|a, b| b.cmp(a));
        out
    }

    /// All pieces that hold a point over a middle point. `same` tells whether two pieces with one carrier
    /// in the mesh hold the same point.
    pub(super) fn hit(
        &self,
        prism: u32,
        near: &Near,
        middle: &dyn Fn() -> Big3,
        same: &dyn Fn(&Piece, &Piece) -> bool,
    ) -> Result<Hit<'_>, SectionError> {
        let list = self.of_prism.get(prism as usize).ok_or(SectionError::NoPreimage { prism })?;
        let mut found: Option<Hit<'_>> = None;
        for &id in list.near(near) {
            let piece = &self.pieces[id as usize];
            let Some(signs) = self.place.signs_on_triangle(piece, near, middle) else { continue };
            let Some(rows) = &piece.inverse else { continue };
            let weights = near.map(rows);
            let exactly = || self.place.exact(piece).on_triangle(&middle());
            if !self.place.is_on_pillar(piece, &weights, &exactly) {
                continue;
            }
            match &found {
                None => found = Some(Hit { piece, signs }),
                Some(first) => {
                    let (mine, theirs) =
                        (self.support(piece.face, &signs), self.support(first.piece.face, &first.signs));
                    if mine != theirs || !same(first.piece, piece) {
                        return Err(SectionError::SeveralPreimages { prism, count: 2 });
                    }
                }
            }
        }
        found.ok_or(SectionError::NoPreimage { prism })
    }

    /// The mesh vertices with positive weights, ascending, then none.
    fn support(&self, face: u32, signs: &[Sign; 3]) -> [Option<u32>; 3] {
        let corners = self.place.mesh.faces[face as usize];
        let mut out = [0, 1, 2].map(|k| signs[k].is_positive().then_some(corners[k]));
        out.sort_unstable_by(|a, b| b.cmp(a));
        out
    }

    /// The smallest triangle with the point, and for each of its corners the corner of `face` there.
    pub(super) fn canonical(&self, face: u32, positive: [bool; 3]) -> (u32, [Option<usize>; 3]) {
        let faces = &self.place.mesh.faces;
        let best = self.stars.smallest(faces, face, positive);
        let corners = faces[face as usize];
        (best, faces[best as usize].map(|v| corners.iter().position(|&c| c == v)))
    }

    /// How many pieces there are.
    pub(super) fn len(&self) -> usize {
        self.pieces.len()
    }
}

fn listed(all: Vec<u32>, rows: &dyn Fn(u32) -> Vec<[f64; 3]>) -> List {
    let tree = (all.len() > FEW).then(|| QuadTree::new(all.clone(), rows));
    List { all, tree }
}
