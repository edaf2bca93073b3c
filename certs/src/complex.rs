//! Oriented triangle complexes: the input conditions, sides, boundary, components.

use std::collections::{HashMap, HashSet};

/// An oriented manifold triangle complex (the mesh `T` or the middle complex `M`).
pub(crate) struct Complex {
    pub(crate) triangles: Vec<[usize; 3]>,
    /// Directed edge to its one triangle.
    edges: HashMap<(usize, usize), usize>,
    /// Ascending corners to the triangle.
    sets: HashMap<[usize; 3], usize>,
    /// Vertices of boundary edges.
    rim: HashSet<usize>,
    /// The component of each triangle, numbered by smallest triangle.
    pub(crate) part: Vec<usize>,
    pub(crate) parts: usize,
}

/// The directed edges of a triangle.
pub(crate) fn sides(t: [usize; 3]) -> [(usize, usize); 3] {
    [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])]
}

fn ascending(mut t: [usize; 3]) -> [usize; 3] {
    t.sort_unstable();
    t
}

/// The representative of `x`, halving paths on the way.
fn find(parent: &mut [usize], mut x: usize) -> usize {
    while parent[x] != x {
        parent[x] = parent[parent[x]];
        x = parent[x];
    }
    x
}

impl Complex {
    /// Checks the conditions of FORMAT section 3 that need no coordinates.
    pub(crate) fn new(triangles: Vec<[usize; 3]>) -> Result<Self, String> {
        let (mut edges, mut sets) = (HashMap::new(), HashMap::new());
        for (i, &t) in triangles.iter().enumerate() {
            if t[0] == t[1] || t[1] == t[2] || t[2] == t[0] {
                return Err(format!("triangle {i} repeats a vertex"));
            }
            if let Some(other) = sets.insert(ascending(t), i) {
                return Err(format!("triangles {other} and {i} have the same vertices"));
            }
            for side in sides(t) {
                if let Some(other) = edges.insert(side, i) {
                    return Err(format!(
                        "edge {} {} is used twice: triangles {other} and {i}",
                        side.0, side.1
                    ));
                }
            }
        }
        let mut complex = Self { triangles, edges, sets, rim: HashSet::new(), part: Vec::new(), parts: 0 };
        complex.check_links()?;
        complex.number_parts();
        Ok(complex)
    }

    /// At each vertex all triangles are connected through shared edges: unites corners across edges.
    fn check_links(&mut self) -> Result<(), String> {
        let mut parent: Vec<usize> = (0..3 * self.triangles.len()).collect();
        let corner = |t: usize, v: usize| 3 * t + self.triangles[t].iter().position(|&x| x == v).unwrap_or(0);
        for (i, &t) in self.triangles.iter().enumerate() {
            for (a, b) in sides(t) {
                match self.across(a, b) {
                    Some(j) => {
                        for v in [a, b] {
                            let (x, y) = (find(&mut parent, corner(i, v)), find(&mut parent, corner(j, v)));
                            parent[x] = y;
                        }
                    }
                    None => self.rim.extend([a, b]),
                }
            }
        }
        let mut root = HashMap::new();
        for (c, &v) in self.triangles.iter().flatten().enumerate() {
            let here = find(&mut parent, c);
            if *root.entry(v).or_insert(here) != here {
                return Err(format!("the triangles at vertex {v} are not connected through its edges"));
            }
        }
        Ok(())
    }

    fn number_parts(&mut self) {
        let mut parent: Vec<usize> = (0..self.triangles.len()).collect();
        for (&(a, b), &i) in &self.edges {
            if let Some(j) = self.across(a, b) {
                let (x, y) = (find(&mut parent, i), find(&mut parent, j));
                parent[x] = y;
            }
        }
        let mut number = HashMap::new();
        for i in 0..self.triangles.len() {
            let next = number.len();
            self.part.push(*number.entry(find(&mut parent, i)).or_insert(next));
        }
        self.parts = number.len();
    }

    /// The triangle on the other side of the directed edge `a b`.
    pub(crate) fn across(&self, a: usize, b: usize) -> Option<usize> {
        self.edges.get(&(b, a)).copied()
    }

    /// The triangle with exactly these corners (any order, repetitions ignored).
    pub(crate) fn with_corners(&self, ids: &[usize]) -> Option<usize> {
        self.sets.get(<&[usize; 3]>::try_from(distinct(ids).as_slice()).ok()?).copied()
    }

    /// Whether the ids are a vertex in use, an edge or a triangle.
    pub(crate) fn is_simplex(&self, ids: &[usize], used: &[bool]) -> bool {
        match *ids {
            [a] => used.get(a) == Some(&true),
            [a, b] => self.edges.contains_key(&(a, b)) || self.edges.contains_key(&(b, a)),
            _ => self.with_corners(ids).is_some(),
        }
    }

    /// Whether the ids (any order, repetitions ignored) lie in a boundary edge.
    pub(crate) fn on_boundary(&self, ids: &[usize]) -> bool {
        match *distinct(ids).as_slice() {
            [a] => self.rim.contains(&a),
            [a, b] => self.edges.contains_key(&(a, b)) != self.edges.contains_key(&(b, a)),
            _ => false,
        }
    }

    /// Which of `n` vertices have a triangle.
    pub(crate) fn used(&self, n: usize) -> Vec<bool> {
        let mut used = vec![false; n];
        self.triangles.iter().flatten().for_each(|&v| used[v] = true);
        used
    }

    /// Vertices in use minus edges plus triangles.
    pub(crate) fn euler(&self, n: usize) -> i128 {
        let vertices = self.used(n).iter().filter(|&&u| u).count();
        let edges = self.edges.keys().filter(|&&(a, b)| a < b || !self.edges.contains_key(&(b, a))).count();
        vertices as i128 - edges as i128 + self.triangles.len() as i128
    }
}

/// The ids ascending, each once.
pub(crate) fn distinct(ids: &[usize]) -> Vec<usize> {
    let mut ids = ids.to_vec();
    ids.sort_unstable();
    ids.dedup();
    ids
}
