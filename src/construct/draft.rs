//! A shell under construction: middle points, pillar directions and thicknesses.

use crate::shell::Shell;

/// A shell under construction. A pinched vertex has no thickness.
#[derive(Clone, Debug, Default)]
pub(crate) struct Draft {
    pub(crate) middle: Vec<[f64; 3]>,
    /// Unit directions; unused ones of pinched vertices.
    pub(crate) direction: Vec<[f64; 3]>,
    pub(crate) up: Vec<f64>,
    pub(crate) down: Vec<f64>,
    pub(crate) pinched: Vec<bool>,
    /// The mesh vertex that each vertex is near and, unless that one is pinched, has the pillar of.
    pub(crate) near: Vec<u32>,
    pub(crate) faces: Vec<[u32; 3]>,
    /// The mesh triangle that each prism's middle lies in.
    pub(crate) origin: Vec<u32>,
}

impl Draft {
    /// Appends a vertex.
    pub(crate) fn push(&mut self, at: [f64; 3], direction: [f64; 3], pinched: bool, near: u32) -> u32 {
        let id = u32::try_from(self.middle.len()).unwrap_or(u32::MAX);
        self.middle.push(at);
        self.direction.push(direction);
        self.up.push(0.0);
        self.down.push(0.0);
        self.pinched.push(pinched);
        self.near.push(near);
        id
    }

    fn offset(&self, v: usize, length: f64) -> [f64; 3] {
        let (m, d) = (&self.middle[v], &self.direction[v]);
        if self.pinched[v] { *m } else { std::array::from_fn(|i| m[i] + length * d[i]) }
    }

    /// The shell, coordinates rounded.
    pub(crate) fn shell(&self) -> Shell {
        let n = self.middle.len();
        Shell {
            bottom: (0..n).map(|v| self.offset(v, -self.down[v])).collect(),
            middle: self.middle.clone(),
            top: (0..n).map(|v| self.offset(v, self.up[v])).collect(),
            faces: self.faces.clone(),
        }
    }
}
