//! Carry values from a shell's mesh to another mesh in the same shell:
//! `cargo run --release --example transfer -- SHELL.h5 [OTHER.ply]`.
//!
//! The other mesh is the middle surface unless a file is given. Every vertex of it goes down its
//! fibre to the middle surface and up to the mesh, exactly; there the value is interpolated.

use std::path::Path;

use homeo::mesh::{self, TriMesh};
use homeo::projection::{Projection, SectionMap};
use homeo::shell::VertexOrder;
use homeo::shell::hdf5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let path = args.next().ok_or("usage: transfer SHELL.h5 [OTHER.ply]")?;
    let file = hdf5::read(Path::new(&path))?;
    let source = file.mesh.ok_or("the file holds no mesh")?;
    let target = match args.next() {
        Some(other) => mesh::read(Path::new(&other))?.mesh,
        None => TriMesh { vertices: file.shell.middle.clone(), faces: file.shell.faces.clone() },
    };
    // The value to carry: the distance of a mesh vertex from the z axis through the middle of the unit box.
    let values: Vec<f64> = source.vertices.iter().map(|p| (p[0] - 0.5).hypot(p[1] - 0.5)).collect();

    let projection = Projection::new(&file.shell, &VertexOrder::Id)?;
    let map = SectionMap::new(&projection, &source)?;
    let (mut carried, mut outside) = (0, 0);
    for (v, p) in target.vertices.iter().enumerate() {
        let Some(image) = projection.project_exactly(p) else {
            outside += 1;
            continue;
        };
        let point = map.to_mesh(image.prism, &image.weights)?;
        let corners = source.faces[point.face as usize];
        let value: f64 =
            (0..3).map(|k| point.weights[k].to_f64().value() * values[corners[k] as usize]).sum();
        carried += 1;
        if v < 10 {
            println!("vertex {v}: triangle {} of the mesh, value {value:.6}", point.face);
        }
    }
    println!(
        "{carried} of {} vertices have a value, {outside} are outside of the shell",
        target.vertices.len()
    );
    Ok(())
}
