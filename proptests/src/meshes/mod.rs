//! Random, degenerate and extreme meshes to build shells around.
// Sizes and grid coordinates are small whole numbers here.
#![allow(clippy::cast_possible_wrap, clippy::cast_sign_loss, clippy::float_cmp)]

mod closed;
mod crossing;
mod open;
mod random;
mod solids;

use homeo::mesh::TriMesh;
use proptest::prelude::*;

pub use crossing::crossing;
pub use random::Random;

type Point = [f64; 3];

/// A family of meshes.
type Family = fn(u32, &mut Random) -> TriMesh;

/// All families with their names.
pub const FAMILIES: [(&str, Family); 23] = [
    ("hull", solids::hull),
    ("lattice hull", solids::lattice_hull),
    ("voxels", solids::voxels),
    ("shaved voxels", solids::shaved_voxels),
    ("star", closed::star),
    ("noisy sphere", closed::noisy),
    ("stretched sphere", closed::stretched),
    ("needles", closed::needles),
    ("flat tetrahedron", closed::flat_tetrahedron),
    ("plate", closed::plate),
    ("nearly flat box", closed::nearly_flat_box),
    ("nested", closed::nested),
    ("far apart", closed::far_apart),
    ("two cones", closed::two_cones),
    ("landscape", open::landscape),
    ("two sheets", open::two_sheets),
    ("rolled", open::rolled),
    ("strip", open::strip),
    ("triangle", open::triangle),
    ("two triangles", open::two_triangles),
    ("seam", open::seam),
    ("fan", open::fan),
    ("rough landscape", open::rough_landscape),
];

/// How a mesh comes about.
#[derive(Clone, Copy, Debug)]
pub struct MeshRecipe {
    /// Which of [`FAMILIES`].
    pub family: usize,
    /// How large, about; 0 is smallest.
    pub size: u32,
    /// All random choices.
    pub seed: u64,
    /// Turned by a random rotation, rounded?
    pub turned: bool,
    /// One of [`PLACES`].
    pub place: usize,
}

/// Where a mesh is put: shifted, then scaled.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// As it is.
    Here,
    /// Shifted by that much.
    Far(f64),
    /// Scaled by a factor, coordinates rounded.
    Times(f64),
    /// Scaled by a power of two.
    Shifted(i32),
}

/// Places; the first ones are the ordinary ones, the last ones near the ends of the range of doubles.
pub const PLACES: [Place; 14] = [
    Place::Here,
    Place::Here,
    Place::Here,
    Place::Here,
    Place::Far(1e3),
    Place::Far(1e6),
    Place::Far(1e10),
    Place::Times(1e-100),
    Place::Times(1e100),
    Place::Shifted(-600),
    Place::Shifted(600),
    Place::Shifted(-960),
    Place::Shifted(1000),
    Place::Shifted(-1040),
];

/// Recipes of meshes.
pub fn mesh_recipes() -> impl Strategy<Value = MeshRecipe> {
    (0..FAMILIES.len(), 0..4u32, any::<u64>(), any::<bool>(), 0..PLACES.len())
        .prop_map(|(family, size, seed, turned, place)| MeshRecipe { family, size, seed, turned, place })
}

impl MeshRecipe {
    /// The mesh.
    #[must_use]
    pub fn build(&self) -> TriMesh {
        let mut random = Random(self.seed);
        let mut mesh = FAMILIES[self.family].1(self.size, &mut random);
        if self.turned {
            turn(&mut mesh, &mut random);
        }
        put(&mut mesh, PLACES[self.place]);
        mesh
    }
}

fn put(mesh: &mut TriMesh, place: Place) {
    for x in mesh.vertices.iter_mut().flatten() {
        *x = match place {
            Place::Here => *x,
            Place::Far(by) => *x + by,
            Place::Times(by) => *x * by,
            // In two steps: a power of two beyond the range has no double.
            Place::Shifted(k) => *x * 2f64.powi(k / 2) * 2f64.powi(k - k / 2),
        };
    }
}

/// A random rotation: three turns about the axes.
fn turn(mesh: &mut TriMesh, random: &mut Random) {
    for axis in 0..3 {
        let (sin, cos) = (3.2 * random.real()).sin_cos();
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        for p in &mut mesh.vertices {
            (p[i], p[j]) = (cos * p[i] - sin * p[j], sin * p[i] + cos * p[j]);
        }
    }
}

fn id(n: usize) -> u32 {
    u32::try_from(n).unwrap()
}

/// Both meshes as one.
fn joined(mut a: TriMesh, b: &TriMesh) -> TriMesh {
    let n = id(a.vertices.len());
    a.vertices.extend(&b.vertices);
    a.faces.extend(b.faces.iter().map(|f| f.map(|v| v + n)));
    a
}

/// The other orientation.
fn turned_inside_out(mut mesh: TriMesh) -> TriMesh {
    mesh.faces.iter_mut().for_each(|f| f.swap(0, 1));
    mesh
}

fn map(mut mesh: TriMesh, f: impl FnMut(Point) -> Point) -> TriMesh {
    mesh.vertices = mesh.vertices.into_iter().map(f).collect();
    mesh
}

/// A subdivided octahedron on the unit sphere.
fn sphere(levels: u32) -> TriMesh {
    let vertices: Vec<Point> =
        vec![[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]];
    let faces = vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    let mut mesh = TriMesh { vertices, faces };
    for _ in 0..levels {
        mesh = subdivided(mesh);
    }
    map(mesh, |p| {
        let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        p.map(|x| x / length)
    })
}

/// Every triangle cut into four.
fn subdivided(mesh: TriMesh) -> TriMesh {
    let mut vertices = mesh.vertices;
    let mut middles = std::collections::HashMap::new();
    let mut between = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            let [p, q] = [a, b].map(|v| vertices[v as usize]);
            vertices.push(std::array::from_fn(|i| 0.5 * p[i] + 0.5 * q[i]));
            id(vertices.len() - 1)
        })
    };
    let faces = mesh.faces.iter().flat_map(|&[a, b, c]| {
        let [ab, bc, ca] = [between(a, b), between(b, c), between(c, a)];
        [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    });
    let faces = faces.collect();
    TriMesh { vertices, faces }
}

/// A grid of `n` by `m` squares, each cut along a random diagonal.
fn grid(n: u32, m: u32, random: &mut Random, at: impl Fn(f64, f64) -> Point) -> TriMesh {
    let id = |i: u32, j: u32| i * (m + 1) + j;
    let mut mesh = TriMesh::default();
    for i in 0..=n {
        for j in 0..=m {
            mesh.vertices.push(at(f64::from(i), f64::from(j)));
            if i < n && j < m {
                let [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
                mesh.faces.extend(split([a, b, c, d], random));
            }
        }
    }
    mesh
}

fn split([a, b, c, d]: [u32; 4], random: &mut Random) -> [[u32; 3]; 2] {
    if random.below(2) == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
}
