//! Oriented triangle complexes: the input conditions, sides, boundary, components.

use crate::Res;

/// An oriented manifold triangle complex (the mesh `T` or the middle complex `M`). Ids have 32 bits: files are too small
/// for more.
pub(crate) struct Complex {
    triangles: Vec<[u32; 3]>,
    /// The triangles at each vertex, ascending by the vertex that follows it in them, one vertex after the other.
    stars: Vec<u32>,
    /// Where each vertex' triangles begin, and where the last one's end.
    starts: Vec<u32>,
    /// Whether each vertex is one of a boundary edge.
    rim: Vec<bool>,
    /// The component of each triangle, numbered by smallest triangle.
    parts: Vec<u32>,
    /// How many there are.
    count: usize,
}

/// The directed edges of a triangle.
pub(crate) fn sides<T: Copy>(t: [T; 3]) -> [(T, T); 3] {
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
pub(crate) fn classes(n: usize, pairs: impl Iterator<Item = (usize, usize)>) -> Vec<u32> {
    fn find(parent: &mut [u32], mut x: usize) -> u32 {
        while parent[x] as usize != x {
            parent[x] = parent[parent[x] as usize];
            x = parent[x] as usize;
        }
        x as u32
    }
    let mut parent: Vec<u32> = (0..n as u32).collect();
    for (a, b) in pairs {
        let (a, b) = (find(&mut parent, a), find(&mut parent, b));
        parent[a.max(b) as usize] = a.min(b);
    }
    (0..n).for_each(|x| parent[x] = find(&mut parent, x));
    parent
}

impl Complex {
    /// Checks the conditions of FORMAT section 3 that need no coordinates; `code` is that of a failure.
    pub(crate) fn new(triangles: Vec<[u32; 3]>, vertices: usize, code: &'static str) -> Res<Self> {
        let repeats = triangles.iter().position(|[a, b, c]| a == b || b == c || c == a);
        ensure!(repeats.is_none(), code, "triangle {repeats:?} repeats a vertex");
        let mut complex = Self::with_stars(triangles, vertices);
        for v in 0..vertices {
            let once = complex.star(v).is_sorted_by(|&x, &y| complex.after(x, v) < complex.after(y, v));
            ensure!(once, code, "an edge from vertex {v} is used twice");
        }
        for i in 0..complex.len() {
            let [a, b, c] = complex.of(i);
            let twin = complex.across(a, b).is_some_and(|j| complex.of(j).contains(&c));
            ensure!(!twin, code, "triangle {i} has the vertices of another one");
        }
        for v in 0..vertices {
            // The triangles around the vertex: each is followed by the one across its side that reaches the vertex.
            let star = complex.star(v);
            let next: Vec<_> = star.iter().map(|&i| complex.place(v, complex.before(i, v))).collect();
            let pairs = next.iter().enumerate().filter_map(|(i, j)| Some((i, (*j)?)));
            let connected = classes(star.len(), pairs).iter().all(|&class| class == 0);
            ensure!(connected, code, "the triangles at vertex {v} are not connected through its edges");
            complex.rim.push(next.contains(&None));
        }
        let shared = complex.directed().filter_map(|(i, (a, b))| Some((i, complex.across(a, b)?)));
        let mut parts = classes(complex.len(), shared);
        for i in 0..parts.len() {
            // The smallest of a class stands first, and has its number when the others come.
            let new = parts[i] as usize == i;
            parts[i] = if new { complex.count as u32 } else { parts[parts[i] as usize] };
            complex.count += usize::from(new);
        }
        complex.parts = parts;
        Ok(complex)
    }

    fn with_stars(triangles: Vec<[u32; 3]>, vertices: usize) -> Self {
        let mut starts = vec![0; vertices + 1];
        triangles.iter().flatten().for_each(|&v| starts[v as usize] += 1);
        // Where each list ends; filling it from there leaves where it begins.
        (0..vertices).for_each(|v| starts[v + 1] += starts[v]);
        let mut stars = vec![0; 3 * triangles.len()];
        for (i, &v) in triangles.iter().enumerate().flat_map(|(i, t)| t.iter().map(move |v| (i, v))) {
            starts[v as usize] -= 1;
            stars[starts[v as usize] as usize] = i as u32;
        }
        let mut complex = Self { triangles, stars, starts, rim: vec![], parts: vec![], count: 0 };
        let mut stars = std::mem::take(&mut complex.stars);
        for v in 0..vertices {
            let star = complex.starts[v] as usize..complex.starts[v + 1] as usize;
            stars[star].sort_unstable_by_key(|&i| complex.after(i, v));
        }
        complex.stars = stars;
        complex
    }

    /// The number of triangles.
    pub(crate) fn len(&self) -> usize {
        self.triangles.len()
    }

    /// The corners of a triangle.
    pub(crate) fn of(&self, i: usize) -> [usize; 3] {
        self.triangles[i].map(|v| v as usize)
    }

    /// The component of a triangle.
    pub(crate) fn part(&self, i: usize) -> usize {
        self.parts[i] as usize
    }

    /// The number of components.
    pub(crate) fn parts(&self) -> usize {
        self.count
    }

    fn star(&self, v: usize) -> &[u32] {
        &self.stars[self.starts[v] as usize..self.starts[v + 1] as usize]
    }

    /// The vertex that follows `v` in a triangle that has it.
    fn after(&self, i: u32, v: usize) -> usize {
        let [a, b, c] = self.of(i as usize);
        if v == a {
            b
        } else if v == b {
            c
        } else {
            a
        }
    }

    /// The vertex before it.
    fn before(&self, i: u32, v: usize) -> usize {
        self.after(i, self.after(i, v))
    }

    /// The directed edges, each with its triangle.
    fn directed(&self) -> impl Iterator<Item = (usize, (usize, usize))> {
        (0..self.len()).flat_map(|i| sides(self.of(i)).map(|side| (i, side)))
    }

    /// Where the triangle with the directed edge `a b` is in the star of `a`.
    fn place(&self, a: usize, b: usize) -> Option<usize> {
        self.star(a).binary_search_by_key(&b, |&i| self.after(i, a)).ok()
    }

    /// The triangle on the other side of the directed edge `a b`.
    pub(crate) fn across(&self, a: usize, b: usize) -> Option<usize> {
        self.place(b, a).map(|place| self.star(b)[place] as usize)
    }

    /// The triangles that have all the ids (at least one) as corners; some exactly if the ids are a simplex.
    pub(crate) fn holding<'a>(&'a self, ids: impl AsRef<[usize]> + 'a) -> impl Iterator<Item = usize> + 'a {
        let first = ids.as_ref().first().copied();
        let pair = first.zip(ids.as_ref().iter().copied().find(|b| Some(*b) != first));
        // Those on both sides of an edge, or all at a vertex.
        let star = first.filter(|_| pair.is_none()).map_or(&[][..], |a| self.star(a));
        let both = pair.into_iter().flat_map(|(a, b)| [self.across(a, b), self.across(b, a)]).flatten();
        let all = star.iter().map(|&i| i as usize).chain(both);
        all.filter(move |&t| ids.as_ref().iter().all(|v| self.of(t).contains(v)))
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
        let used = self.starts.windows(2).filter(|w| w[0] < w[1]).count();
        let edges = self.directed().filter(|&(_, (a, b))| a < b || self.across(a, b).is_none()).count();
        used as i128 - edges as i128 + self.len() as i128
    }
}

#[cfg(test)]
mod tests;
