//! Oriented triangle complexes: the input conditions, sides, boundary, components.

use crate::{Map, Res, Set};

/// An oriented manifold triangle complex (the mesh `T` or the middle complex `M`).
pub(crate) struct Complex {
    pub(crate) triangles: Vec<[usize; 3]>,
    /// Directed edge to its one triangle.
    edges: Map<(usize, usize), usize>,
    /// Ascending corners to the triangle.
    sets: Map<[usize; 3], usize>,
    /// Vertices of triangles.
    used: Set<usize>,
    /// Vertices of boundary edges.
    rim: Set<usize>,
    /// The component of each triangle, numbered by smallest triangle.
    pub(crate) part: Vec<usize>,
    pub(crate) parts: usize,
}

/// The directed edges of a triangle.
pub(crate) fn sides(t: [usize; 3]) -> [(usize, usize); 3] {
    [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])]
}

/// The ids ascending, each once.
pub(crate) fn distinct(ids: impl IntoIterator<Item = usize>) -> Vec<usize> {
    let mut ids: Vec<usize> = ids.into_iter().collect();
    ids.sort_unstable();
    ids.dedup();
    ids
}

/// Classes of `0..n` that the pairs unite: the smallest of its class for each number.
pub(crate) fn classes(n: usize, pairs: impl Iterator<Item = (usize, usize)>) -> Vec<usize> {
    fn find(parent: &mut [usize], mut x: usize) -> usize {
        while parent[x] != x {
            parent[x] = parent[parent[x]];
            x = parent[x];
        }
        x
    }
    let mut parent: Vec<usize> = (0..n).collect();
    for (a, b) in pairs {
        let (a, b) = (find(&mut parent, a), find(&mut parent, b));
        parent[a.max(b)] = a.min(b);
    }
    (0..n).map(|x| find(&mut parent, x)).collect()
}

impl Complex {
    /// Checks the conditions of FORMAT section 3 that need no coordinates; `code` is that of a failure.
    pub(crate) fn new(triangles: Vec<[usize; 3]>, code: &'static str) -> Res<Self> {
        let (mut edges, mut sets) = (Map::default(), Map::default());
        for (i, &t) in triangles.iter().enumerate() {
            let mut set = t;
            set.sort_unstable();
            ensure!(set.is_sorted_by(|a, b| a < b), code, "triangle {i} repeats a vertex");
            ensure!(sets.insert(set, i).is_none(), code, "triangle {i} has the vertices of an earlier one");
            for side in sides(t) {
                ensure!(edges.insert(side, i).is_none(), code, "triangle {i}: edge {side:?} is used twice");
            }
        }
        let used: Set<usize> = triangles.iter().flatten().copied().collect();
        let mut complex = Self { triangles, edges, sets, used, rim: Set::default(), part: vec![], parts: 0 };
        // At each vertex all triangles are connected through shared edges: united corners, two for each edge.
        let corner = |t: usize, v| 3 * t + complex.triangles[t].iter().position(|&x| x == v).unwrap_or(0);
        let shared =
            || complex.edges.iter().filter_map(|(&(a, b), &i)| Some((a, b, i, complex.across(a, b)?)));
        let ends = shared().flat_map(|(a, b, i, j)| [a, b].map(|v| (corner(i, v), corner(j, v))));
        let around = classes(3 * complex.triangles.len(), ends);
        let mut class_at = Map::default();
        for (&v, class) in complex.triangles.iter().flatten().zip(around) {
            let connected = *class_at.entry(v).or_insert(class) == class;
            ensure!(connected, code, "the triangles at vertex {v} are not connected through its edges");
        }
        let part = classes(complex.triangles.len(), shared().map(|(_, _, i, j)| (i, j)));
        let rim = complex.edges.keys().filter(|(a, b)| complex.across(*a, *b).is_none());
        complex.rim = rim.flat_map(|&(a, b)| [a, b]).collect();
        let smallest = distinct(part.iter().copied());
        complex.part = part.iter().map(|i| smallest.binary_search(i).unwrap_or(0)).collect();
        complex.parts = smallest.len();
        Ok(complex)
    }

    /// The triangle on the other side of the directed edge `a b`.
    pub(crate) fn across(&self, a: usize, b: usize) -> Option<usize> {
        self.edges.get(&(b, a)).copied()
    }

    /// The triangle with exactly these corners, ascending.
    pub(crate) fn with_corners(&self, ids: &[usize]) -> Option<usize> {
        self.sets.get::<[usize; 3]>(ids.try_into().ok()?).copied()
    }

    /// Whether the ascending ids are a vertex in use, an edge or a triangle.
    pub(crate) fn is_simplex(&self, ids: &[usize]) -> bool {
        match *ids {
            [a] => self.used.contains(&a),
            [a, b] => self.across(a, b).or(self.across(b, a)).is_some(),
            _ => self.with_corners(ids).is_some(),
        }
    }

    /// Whether the ids lie in a boundary edge.
    pub(crate) fn on_boundary(&self, ids: impl IntoIterator<Item = usize>) -> bool {
        match *distinct(ids) {
            [a] => self.rim.contains(&a),
            [a, b] => self.across(a, b).is_some() != self.across(b, a).is_some(),
            _ => false,
        }
    }

    /// Vertices in use minus edges plus triangles.
    pub(crate) fn euler(&self) -> i128 {
        let edges = self.edges.keys().filter(|&&(a, b)| a < b || self.across(a, b).is_none()).count();
        self.used.len() as i128 - edges as i128 + self.triangles.len() as i128
    }
}
