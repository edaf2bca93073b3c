//! Generated meshes and shells of ordinary coordinates, the same on every run.
//!
//! All start from [`sphere`], an octahedron cut into `8 f^2` triangles, blown up to a sphere with bumps.

use std::collections::{BTreeMap, HashMap};

use homeo::mesh::TriMesh;
use homeo::shell::Shell;

use crate::random::Random;

/// A shell and a mesh that is a section of it.
#[derive(Clone, Debug)]
pub struct Generated {
    /// The shell.
    pub shell: Shell,
    /// The mesh.
    pub mesh: TriMesh,
}

type Point = [f64; 3];

fn combine(points: &[(f64, Point)]) -> Point {
    points.iter().fold([0.0; 3], |sum, (w, p)| [0, 1, 2].map(|i| w.mul_add(p[i], sum[i])))
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: Point) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// A number in `0..1` that depends on `n` alone.
#[must_use]
pub fn unit_hash(n: u64) -> f64 {
    // The generator's state after n steps from 0.
    Random(n.wrapping_mul(Random::STEP)).unit()
}

/// A closed bumpy sphere in the unit box, outward oriented, of `8 * frequency^2` triangles.
///
/// About (1/2, 1/2, 1/2): about the origin some coordinates would be of the size of a rounding error, and such
/// exponents, rare in real files, widen all exact integers.
#[must_use]
pub fn sphere(frequency: u32) -> TriMesh {
    let f = i64::from(frequency.max(1));
    let mut ids: HashMap<[i64; 3], u32> = HashMap::new();
    let mut mesh = TriMesh::default();
    for octant in 0..8_u8 {
        let sign = |axis: u8| if octant >> axis & 1 == 0 { 1 } else { -1 };
        let flip = octant.count_ones() % 2 == 1;
        let mut at = |i: i64, j: i64| {
            let key = [i * sign(0), j * sign(1), (f - i - j) * sign(2)];
            *ids.entry(key).or_insert_with(|| {
                mesh.vertices.push(bump(key.map(|x| x as f64)));
                u32::try_from(mesh.vertices.len() - 1).unwrap_or(u32::MAX)
            })
        };
        for i in 0..f {
            for j in 0..f - i {
                let mut faces = vec![[at(i, j), at(i + 1, j), at(i, j + 1)]];
                if i + j + 1 < f {
                    faces.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
                mesh.faces
                    .extend(faces.into_iter().map(|[a, b, c]| if flip { [a, c, b] } else { [a, b, c] }));
            }
        }
    }
    mesh
}

fn bump(p: Point) -> Point {
    let scale = 1.0 / length(p);
    let [x, y, z] = p.map(|c| c * scale);
    let radius = 0.4 + 0.02 * (5.0 * x).sin() * (4.0 * y).cos() + 0.01 * (7.0 * z + x).sin();
    [x, y, z].map(|c| c.mul_add(radius, 0.5))
}

/// Unit vertex normals: the sum of the neighbouring triangles' area vectors, scaled.
#[must_use]
pub fn vertex_normals(mesh: &TriMesh) -> Vec<Point> {
    let mut sums = vec![[0.0; 3]; mesh.vertices.len()];
    for face in &mesh.faces {
        let [a, b, c] = face.map(|v| mesh.vertices[v as usize]);
        let area = cross(combine(&[(1.0, b), (-1.0, a)]), combine(&[(1.0, c), (-1.0, a)]));
        for v in face {
            let sum = &mut sums[*v as usize];
            *sum = combine(&[(1.0, *sum), (1.0, area)]);
        }
    }
    sums.into_iter().map(|n| combine(&[(1.0 / length(n), n)])).collect()
}

fn mean_edge(mesh: &TriMesh) -> f64 {
    let edge = |f: &[u32; 3]| {
        let [a, b, _] = f.map(|v| mesh.vertices[v as usize]);
        length(combine(&[(1.0, a), (-1.0, b)]))
    };
    mesh.faces.iter().map(edge).sum::<f64>() / mesh.faces.len().max(1) as f64
}

/// The shell around `middle`: along the vertex normals, on each side between half of `thickness` mean edge lengths
/// and all of it, different at every vertex and side.
#[must_use]
pub fn offset_shell(middle: &TriMesh, thickness: f64) -> Shell {
    let unit = thickness * mean_edge(middle);
    let normals = vertex_normals(middle);
    let side = |sign: f64, salt: u64| {
        let pillar = |(v, (m, n)): (usize, (&Point, &Point))| {
            let height = sign * unit * (0.5 + 0.5 * unit_hash(2 * v as u64 + salt));
            combine(&[(1.0, *m), (height, *n)])
        };
        middle.vertices.iter().zip(&normals).enumerate().map(pillar).collect::<Vec<Point>>()
    };
    Shell {
        bottom: side(-1.0, 0),
        middle: middle.vertices.clone(),
        top: side(1.0, 1),
        faces: middle.faces.clone(),
    }
}

/// `mesh` with `splits` edges split (fewer when no more edges without common triangles exist): each adds one vertex,
/// rounded to `f64` and so mostly off the edge by an ulp, and two triangles.
#[must_use]
pub fn split_edges(mesh: &TriMesh, splits: usize) -> TriMesh {
    let mut sides: BTreeMap<[u32; 2], Vec<(usize, usize)>> = BTreeMap::new();
    for (k, f) in mesh.faces.iter().enumerate() {
        for i in 0..3 {
            let (a, b) = (f[i], f[(i + 1) % 3]);
            sides.entry([a.min(b), a.max(b)]).or_default().push((k, i));
        }
    }
    let mut edges: Vec<_> = sides.into_iter().filter(|(_, s)| s.len() == 2).collect();
    // Spread over the surface, not along the ids.
    edges.sort_by(|a, b| {
        let key = |e: &[u32; 2]| unit_hash(u64::from(e[0]) << 32 | u64::from(e[1]));
        key(&a.0).total_cmp(&key(&b.0))
    });
    let mut out = mesh.clone();
    let mut used = vec![false; mesh.faces.len()];
    let mut left = splits;
    for (edge, faces) in edges {
        if left == 0 {
            break;
        }
        if faces.iter().any(|(k, _)| used[*k]) {
            continue;
        }
        left -= 1;
        let share = 0.3 + 0.4 * unit_hash(left as u64);
        let [a, b] = edge.map(|v| mesh.vertices[v as usize]);
        let new = u32::try_from(out.vertices.len()).unwrap_or(u32::MAX);
        out.vertices.push(combine(&[(1.0 - share, a), (share, b)]));
        for (k, i) in faces {
            used[k] = true;
            let f = mesh.faces[k];
            let (p, q, r) = (f[i], f[(i + 1) % 3], f[(i + 2) % 3]);
            out.faces[k] = [p, new, r];
            out.faces.push([new, q, r]);
        }
    }
    out
}

/// Every triangle cut into four at its edges' midpoints (rounded to `f64`).
#[must_use]
pub fn refine(mesh: &TriMesh) -> TriMesh {
    let mut out = TriMesh { vertices: mesh.vertices.clone(), faces: Vec::new() };
    let mut ids: HashMap<[u32; 2], u32> = HashMap::new();
    for &[a, b, c] in &mesh.faces {
        let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[p, q]| {
            *ids.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                let ends = [p, q].map(|v| (0.5, mesh.vertices[v as usize]));
                out.vertices.push(combine(&ends));
                u32::try_from(out.vertices.len() - 1).unwrap_or(u32::MAX)
            })
        });
        out.faces.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    out
}

/// The mesh is the middle surface itself: `8 * frequency^2` triangles and as many prisms.
#[must_use]
pub fn same(frequency: u32) -> Generated {
    let mesh = sphere(frequency);
    Generated { shell: offset_shell(&mesh, 0.1), mesh }
}

/// A shell as a writer has it before simplification: the middle surface is the mesh with some edges split, here 3
/// edges for every 40 triangles. Frequency 50 gives 20,000 triangles in 23,000 prisms.
#[must_use]
pub fn initial(frequency: u32) -> Generated {
    let mesh = sphere(frequency);
    let middle = split_edges(&mesh, mesh.faces.len() * 3 / 40);
    Generated { shell: offset_shell(&middle, 0.1), mesh }
}

/// A shell as a writer has it after simplification: `4^levels` mesh triangles a prism, whose vertices lie off the
/// middle surface by up to a fifth of the thinnest pillar.
#[must_use]
pub fn simplified(frequency: u32, levels: u32) -> Generated {
    let middle = sphere(frequency);
    let shell = offset_shell(&middle, 0.1);
    let mut mesh = (0..levels).fold(middle.clone(), |mesh, _| refine(&mesh));
    let reach = 0.2 * 0.05 * mean_edge(&middle) / f64::from(1_u32 << levels);
    let normals = vertex_normals(&mesh);
    for (v, (p, n)) in mesh.vertices.iter_mut().zip(&normals).enumerate() {
        *p = combine(&[(1.0, *p), (reach * (2.0 * unit_hash(v as u64) - 1.0), *n)]);
    }
    Generated { shell, mesh }
}
