//! Points of the abstract shell.

use std::fmt;

use dashu_base::Signed;

use super::Rat;

/// A point of the reference shell `M x [-1, 1]`: the value of the projection `P`.
///
/// The same point of a side wall can be written in each prism at the wall; the maps of this module
/// return the *canonical* form, the one with the smallest prism. Equality of canonical points is
/// equality of points.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct ShellPoint {
    /// The prism: an index into [`Shell::faces`](crate::shell::Shell::faces).
    pub prism: u32,
    /// Barycentric coordinates on the prism's corners in the order of the face: `alpha`, `beta`,
    /// `gamma`; none negative, sum 1.
    pub weights: [Rat; 3],
    /// The height `h`, -1 at the bottom, 0 on the middle surface, 1 at the top; between minus and
    /// plus the sum of the weights on corners that are not pinched (1 where none is).
    pub height: Rat,
}

impl ShellPoint {
    /// The weight on the face's first corner.
    #[must_use]
    pub fn alpha(&self) -> &Rat {
        &self.weights[0]
    }

    /// The weight on the face's second corner.
    #[must_use]
    pub fn beta(&self) -> &Rat {
        &self.weights[1]
    }

    /// The weight on the face's third corner, `1 - alpha - beta`.
    #[must_use]
    pub fn gamma(&self) -> &Rat {
        &self.weights[2]
    }

    /// Its point on the middle surface: the same weights at height 0.
    #[must_use]
    pub fn middle(&self) -> Self {
        Self { height: Rat::ZERO, ..self.clone() }
    }
}

impl fmt::Display for ShellPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [alpha, beta, gamma] = &self.weights;
        write!(f, "prism {}, weights ({alpha}, {beta}, {gamma}), height {}", self.prism, self.height)
    }
}

/// Are the numbers barycentric coordinates: none negative, sum one?
pub(crate) fn barycentric(weights: &[Rat; 3]) -> bool {
    !weights.iter().any(Signed::is_negative) && weights.iter().fold(Rat::ZERO, |s, w| s + w) == Rat::ONE
}

/// Lists of triangles around every vertex.
#[derive(Debug)]
pub(crate) struct Stars {
    starts: Vec<u32>,
    faces: Vec<u32>,
}

impl Stars {
    /// Linear. The corners must be less than `vertices`.
    pub(crate) fn new(vertices: usize, faces: &[[u32; 3]]) -> Self {
        let mut starts = vec![0_u32; vertices + 1];
        for &v in faces.as_flattened() {
            starts[v as usize + 1] += 1;
        }
        for v in 0..vertices {
            starts[v + 1] += starts[v];
        }
        let mut next = starts.clone();
        let mut out = vec![0_u32; 3 * faces.len()];
        for (face, corners) in (0..).zip(faces) {
            for &v in corners {
                out[next[v as usize] as usize] = face;
                next[v as usize] += 1;
            }
        }
        Self { starts, faces: out }
    }

    fn of(&self, vertex: u32) -> &[u32] {
        let v = vertex as usize;
        &self.faces[self.starts[v] as usize..self.starts[v + 1] as usize]
    }

    /// The smallest triangle with all the corners of `face` that are marked; `face` for none.
    pub(crate) fn smallest(&self, faces: &[[u32; 3]], face: u32, marked: [bool; 3]) -> u32 {
        let corners = faces[face as usize];
        if marked == [true; 3] {
            return face;
        }
        let Some(first) = (0..3).find(|&k| marked[k]) else { return face };
        // Stars are ascending, so the first triangle that fits is the smallest.
        let fits = |f: &u32| (0..3).all(|k| !marked[k] || faces[*f as usize].contains(&corners[k]));
        self.of(corners[first]).iter().copied().find(fits).unwrap_or(face)
    }

    /// The smallest triangle on which the point of `face` with these weights can be written, and
    /// its weights there.
    pub(super) fn canonical(&self, faces: &[[u32; 3]], face: u32, weights: &[Rat; 3]) -> (u32, [Rat; 3]) {
        let corners = faces[face as usize];
        let best = self.smallest(faces, face, weights.each_ref().map(|w| *w != Rat::ZERO));
        let weight = |v: u32| corners.iter().position(|&c| c == v).map_or(Rat::ZERO, |k| weights[k].clone());
        (best, faces[best as usize].map(weight))
    }
}
