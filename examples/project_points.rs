//! Project a shell's mesh and map it back, exactly: `cargo run --release --example project_points -- [SHELL.h5]`.
//!
//! Without a file a small shell around an octahedron is used.

use std::path::Path;

use homeo::mesh::TriMesh;
use homeo::projection::{Projection, Rat};
use homeo::shell::VertexOrder;
use homeo::shell::{Shell, hdf5};

/// Concentric octahedra of radius 1, 2 and 3; the mesh is one of radius 2.5.
fn octahedron() -> (Shell, TriMesh) {
    let axes = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let of_radius = |r: f64| axes.map(|p| p.map(|x: f64| r * x)).to_vec();
    let faces: Vec<[u32; 3]> = (0..4).flat_map(|i| [[i, (i + 1) % 4, 4], [(i + 1) % 4, i, 5]]).collect();
    let mesh = TriMesh { vertices: of_radius(2.5), faces: faces.clone() };
    (Shell { bottom: of_radius(1.0), middle: of_radius(2.0), top: of_radius(3.0), faces }, mesh)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (shell, mesh) = match std::env::args().nth(1) {
        None => octahedron(),
        Some(path) => {
            let file = hdf5::read(Path::new(&path))?;
            (file.shell, file.mesh.ok_or("the file holds no mesh")?)
        }
    };
    let projection = Projection::new(&shell, &VertexOrder::Id)?;
    let (mut inside, mut equal, mut error) = (0, 0, 0.0_f64);
    for (v, p) in mesh.vertices.iter().enumerate() {
        let (Some(exact), Some(float)) = (projection.project_exactly(p), projection.project_f64(p)) else {
            println!("vertex {v}: outside of the shell");
            continue;
        };
        inside += 1;
        error = error.max(float.error);
        let [alpha, beta, _] = float.weights;
        let back = projection.unproject(&exact)?;
        let same = back.iter().zip(p).all(|(x, y)| Rat::try_from(*y).is_ok_and(|y| *x == y));
        equal += usize::from(same);
        if v < 10 {
            println!(
                "vertex {v}: prism {} alpha {alpha:.6} beta {beta:.6} h {:.6}; mapped back equal: {same}",
                float.prism, float.height
            );
        }
    }
    println!(
        "{} vertices, {inside} inside, {equal} mapped back to exactly the same point",
        mesh.vertices.len()
    );
    println!("the floating-point values are within {error:.1e} of the exact ones");
    Ok(())
}
