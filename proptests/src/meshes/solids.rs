//! Convex hulls and solids of cubes.

use homeo::mesh::{self, TriMesh};

use super::{Random, id, map, split};

/// The hull of random points in general position.
pub(super) fn hull(size: u32, random: &mut Random) -> TriMesh {
    hull_of(5 + size as usize * 3, 1_000_000, random)
}

/// The hull of points on a small grid: large dihedral angles, slivers.
pub(super) fn lattice_hull(size: u32, random: &mut Random) -> TriMesh {
    hull_of(4 + size as usize, 6, random)
}

/// By trying all triples; again while four points are in one facet's plane.
fn hull_of(n: usize, range: i64, random: &mut Random) -> TriMesh {
    loop {
        let points: Vec<[i64; 3]> = (0..n)
            .map(|_| std::array::from_fn(|_| random.below(2 * range as usize + 1) as i64 - range))
            .collect();
        if let Some(faces) = facets(&points) {
            let vertices: Vec<[f64; 3]> = points.iter().map(|p| p.map(|x| x as f64)).collect();
            return compact(&vertices, faces);
        }
    }
}

fn volume(p: &[i64; 3], q: &[i64; 3], r: &[i64; 3], s: &[i64; 3]) -> i128 {
    let d = |a: &[i64; 3]| -> [i128; 3] { std::array::from_fn(|i| i128::from(a[i] - p[i])) };
    let ([a, b, c], [d, e, f], [g, h, i]) = (d(q), d(r), d(s));
    a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
}

fn facets(p: &[[i64; 3]]) -> Option<Vec<[u32; 3]>> {
    let mut out = Vec::new();
    for i in 0..p.len() {
        for j in i + 1..p.len() {
            for k in j + 1..p.len() {
                let mut seen = [0; 3];
                for l in (0..p.len()).filter(|l| ![i, j, k].contains(l)) {
                    seen[(volume(&p[i], &p[j], &p[k], &p[l]).signum() + 1) as usize] += 1;
                }
                match seen {
                    [0, zeros, _] | [_, zeros, 0] if zeros > 0 => return None,
                    [_, _, 0] => out.push([id(i), id(j), id(k)]),
                    [0, _, _] => out.push([id(i), id(k), id(j)]),
                    _ => {}
                }
            }
        }
    }
    (out.len() >= 4).then_some(out)
}

/// Without the vertices that no face uses.
fn compact(vertices: &[[f64; 3]], faces: Vec<[u32; 3]>) -> TriMesh {
    let mut new = vec![None; vertices.len()];
    let mut out = TriMesh::default();
    for face in faces {
        out.faces.push(face.map(|v| {
            *new[v as usize].get_or_insert_with(|| {
                out.vertices.push(vertices[v as usize]);
                id(out.vertices.len() - 1)
            })
        }));
    }
    out
}

/// The surface of a union of cubes: right angles, concave edges and corners, handles, cavities.
pub(super) fn voxels(size: u32, random: &mut Random) -> TriMesh {
    let n = 2 + size.min(2) as usize;
    let mut solid: Vec<bool> = (0..n * n * n).map(|_| random.below(5) < 3).collect();
    loop {
        let mesh = surface(&solid, n, random);
        if !mesh.faces.is_empty() && mesh::check(&mesh).is_ok() {
            return mesh;
        }
        // Where only an edge or a corner is shared, more cubes heal it; the full block is a manifold.
        let k = random.below(solid.len());
        solid[k] = true;
    }
}

/// Cubes with all corners moved a little.
pub(super) fn shaved_voxels(size: u32, random: &mut Random) -> TriMesh {
    let by = [0.2, 1e-3, 1e-9, 1e-15][random.below(4)];
    let mesh = voxels(size, random);
    map(mesh, |p| p.map(|x| x + by * random.real()))
}

fn surface(solid: &[bool], n: usize, random: &mut Random) -> TriMesh {
    let has = |p: [i64; 3]| {
        let inside = p.iter().all(|&x| x >= 0 && x < n as i64);
        inside && solid[(p[0] as usize * n + p[1] as usize) * n + p[2] as usize]
    };
    let mut corners = std::collections::HashMap::new();
    let mut mesh = TriMesh::default();
    for cell in 0..n * n * n {
        let p = [cell / (n * n), cell / n % n, cell % n].map(|x| x as i64);
        if !has(p) {
            continue;
        }
        for (axis, up) in (0..3).flat_map(|a| [(a, false), (a, true)]) {
            let mut beside = p;
            beside[axis] += if up { 1 } else { -1 };
            if has(beside) {
                continue;
            }
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let ring = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| {
                let mut q = p;
                q[axis] += i64::from(up);
                q[i] += x;
                q[j] += y;
                *corners.entry(q).or_insert_with(|| {
                    mesh.vertices.push(q.map(|x| x as f64));
                    id(mesh.vertices.len() - 1)
                })
            });
            let [a, b, c, d] = ring;
            let ring = if up { [a, b, c, d] } else { [a, d, c, b] };
            mesh.faces.extend(split(ring, random));
        }
    }
    mesh
}
