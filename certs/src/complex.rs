//! Oriented triangle complexes: the input conditions, sides, boundary, components.

use crate::Res;

/// An oriented manifold triangle complex (the mesh `T` or the middle complex `M`).
pub(crate) struct Complex {
    pub(crate) triangles: Vec<[usize; 3]>,
    /// The triangles at each vertex, ascending (files are too small for 2^32).
    around: Vec<Vec<u32>>,
    /// Whether each vertex is one of a boundary edge.
    rim: Vec<bool>,
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
    pub(crate) fn new(triangles: Vec<[usize; 3]>, vertices: usize, code: &'static str) -> Res<Self> {
        let repeats = triangles.iter().position(|[a, b, c]| a == b || b == c || c == a);
        ensure!(repeats.is_none(), code, "triangle {repeats:?} repeats a vertex");
        let mut around: Vec<Vec<u32>> = vec![Vec::new(); vertices];
        triangles.iter().enumerate().for_each(|(i, t)| t.iter().for_each(|&v| around[v].push(i as u32)));
        let mut complex = Self { triangles, around, rim: vec![false; vertices], part: vec![], parts: 0 };
        for (i, side) in complex.directed() {
            let twice = complex.holding(&[side.0, side.1]).any(|j| j != i && complex.has(j, side));
            ensure!(!twice, code, "triangle {i}: edge {side:?} is used twice");
            let twin = complex.holding(&complex.triangles[i]).any(|j| j != i);
            ensure!(!twin, code, "triangle {i} has the vertices of another one");
        }
        let shared = |i: usize| sides(complex.triangles[i]).map(|(a, b)| Some((i, complex.across(a, b)?)));
        for (v, list) in complex.around.iter().enumerate() {
            let place = |i: usize| list.binary_search(&(i as u32)).ok();
            let pairs = list.iter().flat_map(|&i| shared(i as usize)).flatten();
            let pairs = pairs.filter_map(|(i, j)| place(i).zip(place(j)));
            let connected = classes(list.len(), pairs).iter().all(|&class| class == 0);
            ensure!(connected, code, "the triangles at vertex {v} are not connected through its edges");
        }
        let n = complex.triangles.len();
        let mut part = classes(n, (0..n).flat_map(shared).flatten());
        for i in 0..n {
            // The smallest of a class stands first, and has its number when the others come.
            let new = part[i] == i;
            part[i] = if new { complex.parts } else { part[part[i]] };
            complex.parts += usize::from(new);
        }
        let open = complex.directed().filter(|&(_, (a, b))| complex.across(a, b).is_none());
        let rim: Vec<usize> = open.flat_map(|(_, (a, b))| [a, b]).collect();
        rim.into_iter().for_each(|v| complex.rim[v] = true);
        complex.part = part;
        Ok(complex)
    }

    /// The directed edges, each with its triangle.
    fn directed(&self) -> impl Iterator<Item = (usize, (usize, usize))> {
        self.triangles.iter().enumerate().flat_map(|(i, t)| sides(*t).map(|side| (i, side)))
    }

    /// Whether a triangle has a directed edge.
    fn has(&self, triangle: usize, side: (usize, usize)) -> bool {
        sides(self.triangles[triangle]).contains(&side)
    }

    /// The triangles that have all the ids (at least one) as corners, some exactly if the ids are a simplex; found by
    /// looking at the one with the fewest triangles.
    pub(crate) fn holding<'a>(&'a self, ids: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        let short = ids.iter().map(|&v| self.around[v].as_slice()).min_by_key(|list| list.len());
        let all = short.unwrap_or(&[]).iter().map(|&t| t as usize);
        all.filter(|&t| ids.iter().all(|v| self.triangles[t].contains(v)))
    }

    /// The triangle on the other side of the directed edge `a b`.
    pub(crate) fn across(&self, a: usize, b: usize) -> Option<usize> {
        self.holding(&[a, b]).find(|&t| self.has(t, (b, a)))
    }

    /// The triangle with exactly these corners, ascending.
    pub(crate) fn with_corners(&self, ids: &[usize]) -> Option<usize> {
        self.holding(ids).next().filter(|_| ids.len() == 3)
    }

    /// Whether the ids lie in a boundary edge.
    pub(crate) fn on_boundary(&self, ids: impl IntoIterator<Item = usize>) -> bool {
        match *distinct(ids) {
            [a] => self.rim[a],
            [a, b] => self.holding(&[a, b]).count() == 1,
            _ => false,
        }
    }

    /// Vertices in use minus edges plus triangles.
    pub(crate) fn euler(&self) -> i128 {
        let used = self.around.iter().filter(|list| !list.is_empty()).count();
        let edges = self.directed().filter(|&(_, (a, b))| a < b || self.across(a, b).is_none()).count();
        used as i128 - edges as i128 + self.triangles.len() as i128
    }
}

#[cfg(test)]
mod tests;
