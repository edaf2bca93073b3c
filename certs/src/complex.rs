//! Oriented triangle complexes: the input conditions, sides, boundary, components.

use crate::Res;

/// An oriented manifold triangle complex (the mesh `T` or the middle complex `M`).
pub(crate) struct Complex {
    pub(crate) triangles: Vec<[usize; 3]>,
    /// The directed edges from each vertex, ascending: the other end and the triangle (files are too small for 2^32).
    edges: Vec<Vec<(u32, u32)>>,
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
        let mut complex =
            Self { triangles, edges: vec![vec![]; vertices], rim: vec![], part: vec![], parts: 0 };
        for (i, t) in complex.triangles.iter().enumerate() {
            sides(*t).into_iter().for_each(|(a, b)| complex.edges[a].push((b as u32, i as u32)));
        }
        complex.edges.iter_mut().for_each(|list| list.sort_unstable());
        let once = |list: &Vec<(u32, u32)>| list.is_sorted_by(|x, y| x.0 < y.0);
        let twice = complex.edges.iter().position(|list| !once(list));
        ensure!(twice.is_none(), code, "an edge from vertex {twice:?} is used twice");
        for (i, &[a, b, c]) in complex.triangles.iter().enumerate() {
            let twin = complex.across(a, b).is_some_and(|j| complex.triangles[j].contains(&c));
            ensure!(!twin, code, "triangle {i} has the vertices of another one");
        }
        for (v, list) in complex.edges.iter().enumerate() {
            // The triangles around the vertex: each is followed by the one across its side that reaches the vertex.
            let last = |&(b, i): &(u32, u32)| {
                complex.triangles[i as usize].into_iter().find(|&x| x != v && x != b as usize)
            };
            let next: Vec<_> = list.iter().map(|edge| complex.place(v, last(edge)?)).collect();
            let pairs = next.iter().enumerate().filter_map(|(i, j)| Some((i, (*j)?)));
            let connected = classes(list.len(), pairs).iter().all(|&class| class == 0);
            ensure!(connected, code, "the triangles at vertex {v} are not connected through its edges");
            complex.rim.push(next.contains(&None));
        }
        let shared = complex.directed().filter_map(|(i, (a, b))| Some((i, complex.across(a, b)?)));
        let mut part = classes(complex.triangles.len(), shared);
        for i in 0..part.len() {
            // The smallest of a class stands first, and has its number when the others come.
            let new = part[i] == i;
            part[i] = if new { complex.parts } else { part[part[i]] };
            complex.parts += usize::from(new);
        }
        complex.part = part;
        Ok(complex)
    }

    /// The directed edges, each with its triangle.
    fn directed(&self) -> impl Iterator<Item = (usize, (usize, usize))> {
        self.triangles.iter().enumerate().flat_map(|(i, t)| sides(*t).map(|side| (i, side)))
    }

    /// Where a directed edge is in the list of its first vertex.
    fn place(&self, a: usize, b: usize) -> Option<usize> {
        self.edges[a].binary_search_by_key(&(b as u32), |edge| edge.0).ok()
    }

    /// The triangle on the other side of the directed edge `a b`.
    pub(crate) fn across(&self, a: usize, b: usize) -> Option<usize> {
        self.place(b, a).map(|place| self.edges[b][place].1 as usize)
    }

    /// The triangles that have all the ids (at least one) as corners; some exactly if the ids are a simplex.
    pub(crate) fn holding<'a>(&'a self, ids: impl AsRef<[usize]> + 'a) -> impl Iterator<Item = usize> + 'a {
        let first = ids.as_ref().first().copied();
        let pair = first.zip(ids.as_ref().iter().copied().find(|b| Some(*b) != first));
        // Those on both sides of an edge, or all at a vertex.
        let star = first.filter(|_| pair.is_none()).map_or(&[][..], |a| self.edges[a].as_slice());
        let both = pair.into_iter().flat_map(|(a, b)| [self.across(a, b), self.across(b, a)]).flatten();
        let all = star.iter().map(|edge| edge.1 as usize).chain(both);
        all.filter(move |&t| ids.as_ref().iter().all(|v| self.triangles[t].contains(v)))
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
        let used = self.edges.iter().filter(|list| !list.is_empty()).count();
        let edges = self.directed().filter(|&(_, (a, b))| a < b || self.across(a, b).is_none()).count();
        used as i128 - edges as i128 + self.triangles.len() as i128
    }
}

#[cfg(test)]
mod tests;
