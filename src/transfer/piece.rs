//! A triangle of a mesh inside a tet: on it the projection is affine.

use std::sync::OnceLock;

use super::exact::{Big3, Matrices, quotient};
use super::near::Near;
use crate::mesh::TriMesh;
use crate::predicate::{Sign, orient3d};
use crate::projection::Projection;
use crate::shell::Tet;

/// The piece of triangle `face` in tet `tet`, or a bit more: it may have no area there.
#[derive(Debug)]
pub(super) struct Piece {
    pub(super) face: u32,
    pub(super) tet: u32,
    /// Rounded tet coordinates: row `k`, column `i` for tet vertex `k` and triangle corner `i`.
    pub(super) lambda: [[f64; 3]; 4],
    /// Rounded inverse of the projection; none where the triangle is parallel to the field.
    pub(super) inverse: Option<[[f64; 3]; 3]>,
    /// Computed when needed, then kept.
    exact: OnceLock<Box<Matrices>>,
}

/// A mesh in a shell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a> {
    pub(super) projection: &'a Projection<'a>,
    pub(super) mesh: &'a TriMesh,
}

impl<'a> Place<'a> {
    pub(super) fn triangle(&self, face: u32) -> [&'a [f64; 3]; 3] {
        self.mesh.faces[face as usize].map(|v| &self.mesh.vertices[v as usize])
    }

    pub(super) fn tet(&self, piece: &Piece) -> &'a Tet {
        &self.projection.tets()[piece.tet as usize]
    }

    /// The prism corner on whose pillar each of the tet's vertices lies.
    pub(super) fn pillars(&self, tet: &Tet) -> [usize; 4] {
        let corners = self.projection.shell().faces[tet.prism as usize];
        // A tet's vertices lie on its prism's pillars, so there always is one.
        tet.names.map(|n| corners.iter().position(|&v| v == n.vertex).unwrap_or(0))
    }

    fn matrices(&self, face: u32, tet: u32) -> Matrices {
        let tet = &self.projection.tets()[tet as usize];
        Matrices::new(self.projection.points(tet), self.triangle(face), self.pillars(tet))
    }

    /// The piece's integers.
    pub(super) fn exact<'p>(&self, piece: &'p Piece) -> &'p Matrices {
        piece.exact.get_or_init(|| Box::new(self.matrices(piece.face, piece.tet)))
    }

    /// Whether a plane shows that the two have at most an edge or a corner in common: a plane of the tet
    /// with the triangle on its outer side, and not in it, or the triangle's with the tet on one side, and
    /// no face of it in it. Exact.
    fn is_apart(&self, face: u32, tet: u32) -> bool {
        let points = self.projection.points(&self.projection.tets()[tet as usize]);
        let triangle = self.triangle(face);
        let [a, b, c] = triangle;
        let sides = points.map(|p| orient3d(a, b, c, p));
        let count = |sign: Sign| sides.iter().filter(|s| **s == sign).count();
        let one_side = count(Sign::Positive) == 0 || count(Sign::Negative) == 0;
        if one_side && count(Sign::Zero) < 3 {
            return true;
        }
        (0..4).any(|k| {
            let side = |p: &[f64; 3]| {
                let mut moved = points;
                moved[k] = p;
                let [a, b, c, d] = moved;
                orient3d(a, b, c, d)
            };
            let mut below = false;
            for p in triangle {
                match side(p) {
                    Sign::Positive => return false,
                    Sign::Negative => below = true,
                    Sign::Zero => {}
                }
            }
            below
        })
    }

    /// All pieces of a triangle, by tet.
    pub(super) fn pieces(&self, face: u32) -> Vec<Piece> {
        let corner = |pick: fn(f64, f64) -> f64, from: f64| {
            [0, 1, 2].map(|axis| self.triangle(face).iter().map(|p| p[axis]).fold(from, pick))
        };
        let bounds = [corner(f64::min, f64::INFINITY), corner(f64::max, f64::NEG_INFINITY)];
        let near = self.projection.tets_near(bounds).into_iter();
        near.filter(|&tet| !self.is_apart(face, tet)).map(|tet| self.piece(face, tet)).collect()
    }

    fn piece(&self, face: u32, tet: u32) -> Piece {
        let exact = self.matrices(face, tet);
        let lambda = exact.lambda.each_ref().map(|row| row.each_ref().map(|n| quotient(n, &exact.volume)));
        let inverse = || exact.inverse.each_ref().map(|row| row.each_ref().map(|n| quotient(n, &exact.area)));
        let inverse = super::exact::sign(&exact.area).is_positive().then(inverse);
        Piece { face, tet, lambda, inverse, exact: OnceLock::new() }
    }

    /// The signs of the tet coordinates of a point of the triangle; none if one is negative.
    /// `weights` are asked for when the rounded ones do not decide.
    pub(super) fn signs_in_tet(
        &self,
        piece: &Piece,
        near: &Near,
        weights: &dyn Fn() -> Big3,
    ) -> Option<[Sign; 4]> {
        self.signs(piece, near, weights, |_| true)
    }

    /// As [`Self::signs_in_tet`], of the two coordinates on the tet's pillar alone: the others are weights
    /// of the middle point.
    pub(super) fn is_on_pillar(&self, piece: &Piece, near: &Near, weights: &dyn Fn() -> Big3) -> bool {
        let tet = self.tet(piece);
        self.signs(piece, near, weights, |k| tet.names[k].vertex == tet.pillar).is_some()
    }

    fn signs(
        &self,
        piece: &Piece,
        near: &Near,
        weights: &dyn Fn() -> Big3,
        wanted: impl Fn(usize) -> bool,
    ) -> Option<[Sign; 4]> {
        let mut signs = [Sign::Positive; 4];
        for (k, out) in signs.iter_mut().enumerate() {
            if wanted(k) {
                let exactly =
                    || super::exact::sign(&super::exact::dot(&self.exact(piece).lambda[k], &weights()));
                *out = near.sign(&piece.lambda[k]).unwrap_or_else(exactly);
                if out.is_negative() {
                    return None;
                }
            }
        }
        Some(signs)
    }

    /// The signs of the weights, on the triangle, of the point over a middle point; none if one is negative.
    pub(super) fn signs_on_triangle(
        &self,
        piece: &Piece,
        middle: &Near,
        exact_middle: &dyn Fn() -> Big3,
    ) -> Option<[Sign; 3]> {
        let rows = piece.inverse.as_ref()?;
        let mut signs = [Sign::Positive; 3];
        for (i, out) in signs.iter_mut().enumerate() {
            let exactly =
                || super::exact::sign(&super::exact::dot(&self.exact(piece).inverse[i], &exact_middle()));
            *out = middle.sign(&rows[i]).unwrap_or_else(exactly);
            if out.is_negative() {
                return None;
            }
        }
        Some(signs)
    }
}
