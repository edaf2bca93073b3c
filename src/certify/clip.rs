//! The intersection of a triangle `f` with a closed tet, decided by signs of input points alone.
//!
//! Sutherland-Hodgman in `f`'s plane, where no corner is ever computed: a corner is known by the lines that it lies
//! on (`f`'s sides, the tet's faces), and its side of a further face is the sign of one `orient3d` or dot of input
//! points. Constructing corners as rationals was the alternative; the numbers grow and every sign costs a big integer.

use crate::predicate::{Sign, StageCounts, dot_sign_staged, orient3d_staged};

type Point = [f64; 3];

/// Set of lines through a corner: bit `i < 3` is side `i` of the triangle (opposite corner `i`), bit `3 + k` is face
/// `k` of the tet (opposite its vertex `k`).
pub(crate) type Mask = u8;

/// The part of a mask that speaks of the triangle's sides.
pub(crate) const SIDES: Mask = 0b000_0111;

/// How a corner came about; what its sign against a further face is computed from.
#[derive(Clone, Copy, Debug)]
enum Origin {
    /// A corner of the triangle.
    Corner(u8),
    /// A side of the triangle crosses a face strictly between its ends.
    SideFace(u8, u8),
    /// Two faces meet the triangle's plane in crossing lines.
    FaceFace(u8, u8),
}

/// A corner of the polygon.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    /// All lines that the corner lies on.
    pub(crate) mask: Mask,
    origin: Origin,
}

/// A convex polygon with three to seven corners, no three of them collinear, in the triangle's orientation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polygon {
    corners: [Corner; 8],
    len: usize,
    /// The face of the tet that the triangle lies in, if it does.
    pub(crate) coplanar: Option<u8>,
}

impl Polygon {
    /// The corners in order.
    pub(crate) fn corners(&self) -> &[Corner] {
        self.corners.get(..self.len).unwrap_or(&[])
    }

    fn push(&mut self, corner: Corner) {
        if let Some(slot) = self.corners.get_mut(self.len) {
            *slot = corner;
            self.len += 1;
        }
    }
}

/// Signs of the triangle's corners against the tet's faces, positive inside: `signs[face][corner]`.
type Table = [[Sign; 3]; 4];

struct Clipper<'a> {
    f: [&'a Point; 3],
    tet: [&'a Point; 4],
    table: Table,
}

/// The two indices of 0..4 other than `k` and `l`, ascending.
fn others(k: u8, l: u8) -> (usize, usize) {
    let mut it = (0..4usize).filter(|&i| i != usize::from(k) && i != usize::from(l));
    (it.next().unwrap_or(0), it.next().unwrap_or(0))
}

/// Sign of the permutation `(a, b, c, d)` of `0..4`.
fn parity(p: [usize; 4]) -> Sign {
    let mut inversions = 0;
    for i in 0..4 {
        for j in i + 1..4 {
            inversions += usize::from(p[i] > p[j]);
        }
    }
    if inversions % 2 == 0 { Sign::Positive } else { Sign::Negative }
}

impl Clipper<'_> {
    /// Sign of the tet's barycentric coordinate `m` at a corner.
    fn sign(&self, corner: Corner, m: u8, stages: &mut StageCounts) -> Sign {
        match corner.origin {
            Origin::Corner(i) => self.table[usize::from(m)][usize::from(i)],
            Origin::SideFace(a, k) => self.sign_side_face(a, k, m, stages),
            Origin::FaceFace(k, l) => self.sign_face_face(k, l, m, stages),
        }
    }

    /// With `x` on `p q` where `mu_k` vanishes, `mu_m(x)` has the sign of
    /// `s (mu_m(p) mu_k(q) - mu_m(q) mu_k(p))`, `s` the sign of `mu_k(q)`; the minor is, up to the order of the
    /// indices and the tet's positive volume, the volume of `p q y_i y_j` over the two other vertices.
    fn sign_side_face(&self, a: u8, k: u8, m: u8, stages: &mut StageCounts) -> Sign {
        if m == k {
            return Sign::Zero;
        }
        let p = (usize::from(a) + 1) % 3;
        let q = (usize::from(a) + 2) % 3;
        let (i, j) = others(m, k);
        let minor = stages.note(orient3d_staged(self.f[p], self.f[q], self.tet[i], self.tet[j]));
        self.table[usize::from(k)][q] * parity([usize::from(m), usize::from(k), i, j]) * minor
    }

    /// The corner is where the tet's edge line `y_i y_j` (the one on both faces) meets the plane `h = 0`:
    /// `mu_i = h_j / (h_j - h_i)`.
    fn sign_face_face(&self, k: u8, l: u8, m: u8, stages: &mut StageCounts) -> Sign {
        if m == k || m == l {
            return Sign::Zero;
        }
        let (i, j) = others(k, l);
        let (this, other) = if usize::from(m) == i { (i, j) } else { (j, i) };
        let [a, b, c] = self.f;
        let height = stages.note(orient3d_staged(a, b, c, self.tet[other]));
        height * stages.note(dot_sign_staged(a, b, c, self.tet[this], self.tet[other]))
    }

    /// The polygon cut with the half space `mu_k >= 0`; `None` when nothing of positive area is left.
    fn cut(&self, poly: &Polygon, k: u8, stages: &mut StageCounts) -> Option<Polygon> {
        let bit = 1 << (3 + k);
        let n = poly.len;
        let mut signs = [Sign::Zero; 8];
        let mut inside = false;
        for (slot, corner) in signs.iter_mut().zip(poly.corners()) {
            *slot = self.sign(*corner, k, stages);
            inside |= *slot == Sign::Positive;
        }
        if !inside {
            return None;
        }
        let mut out = Polygon { corners: poly.corners, len: 0, coplanar: poly.coplanar };
        for c in 0..n {
            let next = (c + 1) % n;
            let (here, there) = (poly.corners[c], poly.corners[next]);
            match signs[c] {
                Sign::Positive => out.push(here),
                Sign::Zero => out.push(Corner { mask: here.mask | bit, ..here }),
                Sign::Negative => {}
            }
            if signs[c] * signs[next] == Sign::Negative {
                out.push(crossing(here, there, k, poly.coplanar));
            }
        }
        Some(out)
    }
}

/// The point strictly between two neighbouring corners on face `k`.
fn crossing(here: Corner, there: Corner, k: u8, coplanar: Option<u8>) -> Corner {
    // Interior points of the side lie on a line only when both ends do, so the common lines are all but face k.
    let common = here.mask & there.mask;
    // A face that holds the whole triangle is no line in its plane.
    let lines = coplanar.map_or(common, |c| common & !(1 << (3 + c)));
    let line = lines.trailing_zeros().min(6) as u8;
    let origin = if line < 3 { Origin::SideFace(line, k) } else { Origin::FaceFace(line - 3, k) };
    Corner { mask: common | 1 << (3 + k), origin }
}

/// The polygon `f` meets the closed tet in, or `None` when that has no area. The tet must be positive.
///
/// Cost: twelve `orient3d` and at most two further predicates a corner and face.
pub(crate) fn clip(f: [&Point; 3], tet: [&Point; 4], stages: &mut StageCounts) -> Option<Polygon> {
    let mut table = [[Sign::Zero; 3]; 4];
    for k in 0..4 {
        let mut with = tet;
        for i in 0..3 {
            with[k] = f[i];
            table[k][i] = stages.note(orient3d_staged(with[0], with[1], with[2], with[3]));
        }
        // Nothing strictly inside this face and not in its plane: no area, whatever the other faces say.
        let row = table[k];
        if !row.contains(&Sign::Positive) && row.contains(&Sign::Negative) {
            return None;
        }
    }
    let clipper = Clipper { f, tet, table };
    let corner = |i: u8| Corner { mask: SIDES & !(1 << i), origin: Origin::Corner(i) };
    let mut poly = Polygon { corners: [corner(0); 8], len: 0, coplanar: None };
    (0..3).for_each(|i| poly.push(corner(i)));
    for k in 0..4u8 {
        if table[usize::from(k)] == [Sign::Zero; 3] {
            poly.coplanar = Some(k);
            let n = poly.len;
            poly.corners.iter_mut().take(n).for_each(|c| c.mask |= 1 << (3 + k));
        } else {
            poly = clipper.cut(&poly, k, stages)?;
        }
    }
    (poly.len >= 3).then_some(poly)
}
