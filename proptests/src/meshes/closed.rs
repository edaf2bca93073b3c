//! Closed surfaces.

use homeo::mesh::TriMesh;

use super::{Random, grid, id, joined, map, sphere, subdivided, turned_inside_out};

/// A sphere with random radii, spiky.
pub(super) fn star(size: u32, random: &mut Random) -> TriMesh {
    let least = [0.9, 0.5, 0.15][random.below(3)];
    map(sphere(size.min(2)), |p| {
        let r = random.between(least, 1.0);
        p.map(|x| r * x)
    })
}

/// A sphere with noise in all directions; it may intersect itself.
pub(super) fn noisy(size: u32, random: &mut Random) -> TriMesh {
    let by = 0.5f64.powi(size as i32) * [0.3, 0.1][random.below(2)];
    map(sphere(1 + size.min(2)), |p| p.map(|x| x + by * random.real()))
}

/// A sphere that is very thin, very long or both.
pub(super) fn stretched(size: u32, random: &mut Random) -> TriMesh {
    let by: [f64; 3] = std::array::from_fn(|_| 10f64.powi(random.below(9) as i32 - 4));
    map(sphere(size.min(2)), |p| std::array::from_fn(|i| by[i] * p[i]))
}

/// A double cone with long thin triangles.
pub(super) fn needles(size: u32, random: &mut Random) -> TriMesh {
    let n = 3 + 4 * size as usize;
    let (thin, long) = (random.tiny(0.0, 6.0), 10f64.powf(random.between(0.0, 4.0)));
    cones(n, long, |k| {
        let (y, x) = (std::f64::consts::TAU * (k as f64 + 0.3 * random.real()) / n as f64).sin_cos();
        [thin * x, thin * y, 0.1 * thin * random.real()]
    })
}

/// Triangles from two tips to a rim.
fn cones(n: usize, height: f64, rim: impl FnMut(usize) -> [f64; 3]) -> TriMesh {
    let mut vertices: Vec<[f64; 3]> = (0..n).map(rim).collect();
    vertices.extend([[0.0, 0.0, height], [0.0, 0.0, -height]]);
    let faces = (0..n).flat_map(|k| {
        let (a, b) = (id(k), id((k + 1) % n));
        [[a, b, id(n)], [b, a, id(n + 1)]]
    });
    let faces = faces.collect();
    TriMesh { vertices, faces }
}

/// Two cones of different slope over one rim, the lower one inside the upper one: nearly folded edges.
pub(super) fn two_cones(size: u32, random: &mut Random) -> TriMesh {
    let n = 3 + 2 * size as usize;
    let mut mesh = cones(n, 1.0, |k| {
        let (y, x) = (std::f64::consts::TAU * (k as f64 + 0.3 * random.real()) / n as f64).sin_cos();
        [x, y, 0.0]
    });
    mesh.vertices[n + 1][2] = 1.0 - random.tiny(0.1, 9.0);
    mesh
}

/// A tetrahedron with nearly no height.
pub(super) fn flat_tetrahedron(size: u32, random: &mut Random) -> TriMesh {
    let height = random.tiny(0.0, 12.0);
    let vertices = vec![[0., 0., 0.], [1., 0., 0.], [0.2, 1., 0.], [0.3, random.between(-0.1, 0.5), height]];
    let mut mesh = TriMesh { vertices, faces: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]] };
    for _ in 0..size.min(2) {
        mesh = subdivided(mesh);
    }
    mesh
}

/// A box, its sides cut into squares.
fn boxed(n: [u32; 3], random: &mut Random, at: impl FnMut([f64; 3]) -> [f64; 3]) -> TriMesh {
    let mut mesh = TriMesh::default();
    let mut ids = std::collections::HashMap::new();
    for axis in 0..3usize {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        for up in [false, true] {
            let side = grid(n[i], n[j], random, |x, y| {
                let mut p = [0.0; 3];
                (p[i], p[j], p[axis]) = (x, y, if up { f64::from(n[axis]) } else { 0.0 });
                p
            });
            let side = if up { side } else { turned_inside_out(side) };
            for face in side.faces {
                mesh.faces.push(face.map(|v| {
                    let p = side.vertices[v as usize];
                    *ids.entry(p.map(|x| x as i64)).or_insert_with(|| {
                        mesh.vertices.push(p);
                        id(mesh.vertices.len() - 1)
                    })
                }));
            }
        }
    }
    map(mesh, at)
}

/// A thin plate.
pub(super) fn plate(size: u32, random: &mut Random) -> TriMesh {
    let (h, n) = (random.tiny(2.0, 10.0), 1 + size);
    boxed([n, n, 1], random, |[x, y, z]| [x, y, h * z])
}

/// A box whose vertices are moved by very little or not at all: nearly flat and flat vertices.
pub(super) fn nearly_flat_box(size: u32, random: &mut Random) -> TriMesh {
    let (h, n) = (random.tiny(1.0, 17.0), 1 + size);
    let mut noise = random.clone();
    boxed([n; 3], random, |p| p.map(|x| x + h * noise.real()))
}

/// A sphere in a sphere, and something between them.
pub(super) fn nested(size: u32, random: &mut Random) -> TriMesh {
    let near = random.tiny(0.3, 6.0);
    let outer = sphere(size.min(2));
    let inner = map(turned_inside_out(outer.clone()), |p| p.map(|x| (1.0 - near) * x));
    let crumb = map(sphere(0), |p| {
        std::array::from_fn(|i| 0.3 * near * p[i] + if i == 2 { 1.0 - 0.5 * near } else { 0.0 })
    });
    let mesh = joined(outer, &inner);
    if size.min(2) > 0 && random.below(2) == 0 { joined(mesh, &crumb) } else { mesh }
}

/// Components of very different size.
pub(super) fn far_apart(_: u32, random: &mut Random) -> TriMesh {
    let (small, far) = (random.tiny(0.0, 9.0), 10f64.powf(random.between(0.5, 3.0)));
    let little = map(star(1, random), |p| [small * p[0] + far, small * p[1], small * p[2]]);
    joined(star(1, random), &little)
}
