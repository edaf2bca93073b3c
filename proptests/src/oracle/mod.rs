//! Decides the claims from their definitions (THEORY sections 1 and 2) in exact arithmetic: all triangles against
//! all tets, all orders one by one. It shares no code with `homeo::certify`, and it is slow.

pub mod exact;
pub mod lift;
pub mod overlap;
pub mod pairs;
pub mod tets;

use std::collections::{HashMap, HashSet};

use dashu_int::IBig;
use dashu_ratio::RBig;
use homeo::mesh::TriMesh;
use homeo::shell::Shell;

use exact::{Point, Weights, clip, cross, det3, dot, minus, on_grid, orient, positive, primitive, simplex};
use tets::{Code, ORDERS, Tets};

/// A point of the mesh with a point of the abstract shell above it: ids and names with their positive weights.
pub type Corner = (Vec<(u32, IBig)>, Vec<(Code, IBig)>);

/// A triangle's part in a closed tet; in several when it lies in their common face.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The mesh triangle.
    pub face: usize,
    /// The prism.
    pub prism: usize,
    /// Ids of its corners (indices into [`World::corners`]), in the triangle's orientation.
    pub corners: Vec<usize>,
    /// Its part of the triangle's area.
    pub area: RBig,
    /// Its part of the prism's middle triangle's area, after projection; negative where it is turned over.
    pub projected: RBig,
    /// Is `n . V > 0`?
    pub faces_up: bool,
}

/// A shell and a mesh on one integer grid, with all their pieces.
#[derive(Debug)]
pub struct World<'a> {
    /// The shell.
    pub shell: &'a Shell,
    /// The mesh.
    pub mesh: &'a TriMesh,
    /// Is the vertex pinched?
    pub pinched: Vec<bool>,
    /// All tets of all orders.
    pub tets: Tets,
    /// Their determinants.
    pub determinants: Vec<IBig>,
    /// Mesh vertices.
    pub points: Vec<Point>,
    shell_points: [Vec<Point>; 3],
    /// All corners of pieces.
    pub corners: Vec<Corner>,
    ids: HashMap<Corner, usize>,
    pieces: HashMap<(usize, usize), Option<Piece>>,
    mesh_edges: HashSet<[u32; 2]>,
    shell_edges: HashSet<[u32; 2]>,
}

/// Edges of one triangle only.
#[must_use]
pub fn boundary(faces: &[[u32; 3]]) -> HashSet<[u32; 2]> {
    let mut count: HashMap<[u32; 2], usize> = HashMap::new();
    for f in faces {
        for i in 0..3 {
            let (a, b) = (f[i], f[(i + 1) % 3]);
            *count.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    count.into_iter().filter(|(_, n)| *n == 1).map(|(e, _)| e).collect()
}

/// The component of every triangle, connected across shared edges, numbered from 0.
#[must_use]
pub fn components(faces: &[[u32; 3]]) -> Vec<usize> {
    let mut out = vec![usize::MAX; faces.len()];
    let mut next = 0;
    for start in 0..faces.len() {
        if out[start] != usize::MAX {
            continue;
        }
        out[start] = next;
        let mut queue = vec![start];
        while let Some(f) = queue.pop() {
            for g in 0..faces.len() {
                let shared = faces[g].iter().filter(|v| faces[f].contains(v)).count();
                if shared == 2 && out[g] == usize::MAX {
                    out[g] = next;
                    queue.push(g);
                }
            }
        }
        next += 1;
    }
    out
}

impl<'a> World<'a> {
    /// Puts everything on one grid.
    #[must_use]
    pub fn new(shell: &'a Shell, mesh: &'a TriMesh) -> Self {
        let n = shell.middle.len();
        let all: Vec<[f64; 3]> = [&shell.bottom, &shell.middle, &shell.top, &mesh.vertices]
            .into_iter()
            .flatten()
            .copied()
            .collect();
        let grid = on_grid(&all);
        let layer = |k: usize| grid[k * n..(k + 1) * n].to_vec();
        let shell_points = [layer(0), layer(1), layer(2)];
        let pinched: Vec<bool> = (0..n)
            .map(|v| shell_points[0][v] == shell_points[1][v] && shell_points[1][v] == shell_points[2][v])
            .collect();
        let tets = tets::tets(shell, &pinched);
        let mut out = Self {
            shell,
            mesh,
            pinched,
            tets,
            determinants: Vec::new(),
            points: grid[3 * n..].to_vec(),
            shell_points,
            corners: Vec::new(),
            ids: HashMap::new(),
            pieces: HashMap::new(),
            mesh_edges: boundary(&mesh.faces),
            shell_edges: boundary(&shell.faces),
        };
        out.determinants = (0..out.tets.all.len())
            .map(|t| {
                let [a, b, c, d] = out.tet(t);
                orient(a, b, c, d)
            })
            .collect();
        out
    }

    /// The position of a shell point.
    #[must_use]
    pub fn at(&self, code: Code) -> &Point {
        &self.shell_points[(code % 3) as usize][(code / 3) as usize]
    }

    fn tet(&self, t: usize) -> [&Point; 4] {
        self.tets.all[t].names.map(|c| self.at(c))
    }

    /// A mesh triangle's corners.
    #[must_use]
    pub fn triangle(&self, f: usize) -> [&Point; 3] {
        self.mesh.faces[f].map(|v| &self.points[v as usize])
    }

    /// `normal . V`.
    #[must_use]
    pub fn slope(&self, f: usize, t: usize) -> IBig {
        let [a, b, c] = self.triangle(f);
        let [lo, hi] = self.tets.all[t].field.map(|c| self.at(c));
        dot(&cross(&minus(b, a), &minus(c, a)), &minus(hi, lo))
    }

    /// C1.
    #[must_use]
    pub fn positivity(&self) -> bool {
        self.determinants.iter().all(positive)
    }

    /// Do the ids lie in one boundary edge?
    fn within(edges: &HashSet<[u32; 2]>, ids: impl IntoIterator<Item = u32>) -> bool {
        let mut ids: Vec<u32> = ids.into_iter().collect();
        ids.sort_unstable();
        ids.dedup();
        edges.iter().any(|e| ids.iter().all(|v| e.contains(v)))
    }

    /// The tet's four coordinates (times its determinant) as linear forms in the triangle's weights.
    fn forms(&self, f: usize, t: usize) -> Vec<Weights> {
        let tet = self.tet(t);
        let coordinate = |k: usize| {
            self.triangle(f)
                .map(|p| {
                    let mut with = tet;
                    with[k] = p;
                    orient(with[0], with[1], with[2], with[3])
                })
                .to_vec()
        };
        (0..4).map(coordinate).collect()
    }

    /// All points of the triangle in the closed tet, which must be positive: corners as weights on the triangle,
    /// each with its coordinates in the tet.
    #[must_use]
    pub fn meet(&self, f: usize, t: usize) -> Vec<(Weights, Weights)> {
        let beyond = |k: usize| {
            let (mine, theirs) = (self.triangle(f).map(|p| &p[k]), self.tet(t).map(|p| &p[k]));
            mine.iter().max() < theirs.iter().min() || mine.iter().min() > theirs.iter().max()
        };
        if (0..3).any(beyond) {
            return Vec::new();
        }
        let forms = self.forms(f, t);
        let mut polygon = simplex(3);
        for form in &forms {
            polygon = clip(&polygon, form);
        }
        let in_tet = |w: &Weights| primitive(forms.iter().map(|form| dot(form, w)).collect());
        polygon.into_iter().map(|w| (w.clone(), in_tet(&w))).collect()
    }

    /// The piece of a triangle in a positive tet.
    pub fn piece(&mut self, f: usize, t: usize) -> Option<Piece> {
        if let Some(known) = self.pieces.get(&(f, t)) {
            return known.clone();
        }
        let piece = self.make(f, t);
        self.pieces.insert((f, t), piece.clone());
        piece
    }

    fn make(&mut self, f: usize, t: usize) -> Option<Piece> {
        let polygon = self.meet(f, t);
        if polygon.len() < 3 {
            return None;
        }
        let prism = self.tets.all[t].prism;
        let ids = self.shell.faces[prism];
        let names = self.tets.all[t].names;
        let in_prism = |w: &Weights| -> Weights {
            let on = |v: u32| (0..4).filter(|&k| names[k] / 3 == v).map(|k| w[k].clone()).sum();
            ids.map(on).to_vec()
        };
        let face: Vec<Weights> = polygon.iter().map(|(w, _)| w.clone()).collect();
        let middle: Vec<Weights> = polygon.iter().map(|(_, w)| in_prism(w)).collect();
        let area = fan_area(&face);
        assert!(area > RBig::ZERO, "a piece keeps the orientation of its triangle");
        let corners = polygon
            .iter()
            .map(|(w, x)| {
                let mut mesh: Vec<(u32, IBig)> =
                    self.mesh.faces[f].into_iter().zip(w.iter().cloned()).collect();
                let mut shell: Vec<(Code, IBig)> = names.into_iter().zip(x.iter().cloned()).collect();
                mesh.retain(|(_, w)| *w != IBig::ZERO);
                shell.retain(|(_, w)| *w != IBig::ZERO);
                mesh.sort();
                shell.sort();
                let corner = (mesh, shell);
                *self.ids.entry(corner.clone()).or_insert_with(|| {
                    self.corners.push(corner);
                    self.corners.len() - 1
                })
            })
            .collect();
        let faces_up = positive(&self.slope(f, t));
        Some(Piece { face: f, prism, corners, area, projected: fan_area(&middle), faces_up })
    }

    /// The tets that an order selects: `rank[v]` is the place of vertex `v`.
    #[must_use]
    pub fn selected(&self, rank: &[usize]) -> Vec<usize> {
        let of_prism = |(prism, corners): (usize, &[u32; 3])| {
            let mut order = [0usize, 1, 2];
            order.sort_by_key(|&k| rank[corners[k] as usize]);
            let k = ORDERS.iter().position(|o| *o == order).unwrap();
            self.tets.selected[prism][k].clone()
        };
        let mut out: Vec<usize> = self.shell.faces.iter().enumerate().flat_map(of_prism).collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// The point as weights on a mesh triangle's corners.
    #[must_use]
    pub fn in_face(&self, corner: usize, f: usize) -> Weights {
        let find = |v: u32| {
            self.corners[corner].0.iter().find(|(u, _)| *u == v).map_or(IBig::ZERO, |(_, w)| w.clone())
        };
        self.mesh.faces[f].map(find).to_vec()
    }

    /// The point's projection as weights on a prism's corners.
    #[must_use]
    pub fn in_prism(&self, corner: usize, prism: usize) -> Weights {
        let on =
            |v: u32| self.corners[corner].1.iter().filter(|(c, _)| c / 3 == v).map(|(_, w)| w.clone()).sum();
        self.shell.faces[prism].map(on).to_vec()
    }

    /// Does the point, or the open segment between two points, lie on bottom or top, a pinched vertex by itself
    /// excepted?
    #[must_use]
    pub fn on_cap(&self, corners: &[usize]) -> bool {
        let mut names: Vec<Code> =
            corners.iter().flat_map(|&c| self.corners[c].1.iter().map(|(n, _)| *n)).collect();
        names.sort_unstable();
        names.dedup();
        let pinched = |c: Code| self.pinched[(c / 3) as usize];
        if names.len() == 1 && pinched(names[0]) {
            return false;
        }
        [0, 2].into_iter().any(|layer| names.iter().all(|&c| c % 3 == layer || pinched(c)))
    }

    /// Does the segment between two points lie in the mesh's boundary?
    #[must_use]
    pub fn on_mesh_boundary(&self, a: usize, b: usize) -> bool {
        Self::within(
            &self.mesh_edges,
            [a, b].into_iter().flat_map(|c| self.corners[c].0.iter().map(|(v, _)| *v)),
        )
    }

    /// Does it lie in the shell's boundary walls?
    #[must_use]
    pub fn on_shell_boundary(&self, a: usize, b: usize) -> bool {
        Self::within(
            &self.shell_edges,
            [a, b].into_iter().flat_map(|c| self.corners[c].1.iter().map(|(n, _)| n / 3)),
        )
    }
}

/// The area of a convex polygon given in homogeneous barycentric coordinates, as a part of the whole triangle's.
#[must_use]
pub fn fan_area(polygon: &[Weights]) -> RBig {
    let total = |w: &Weights| -> IBig { w.iter().sum() };
    let mut out = RBig::ZERO;
    for i in 1..polygon.len().saturating_sub(1) {
        let [a, b, c] = [&polygon[0], &polygon[i], &polygon[i + 1]];
        let scale = total(a) * total(b) * total(c);
        out += RBig::from_parts(det3(a, b, c), scale.try_into().unwrap());
    }
    out
}
