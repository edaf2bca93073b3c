//! Carry values from a shell's mesh to another mesh in the same shell, exactly and in `f64`, and count points a second:
//! `cargo run --release --example transfer -- SHELL.h5 [OTHER.ply [POINTS]]`.
//!
//! The other mesh is the middle surface unless a file is given. Whether both meshes are sections of the shell is for
//! `homeo certify`, or `homeo transfer`, to say.

use std::path::Path;
use std::time::Instant;

use homeo::mesh::{self, TriMesh};
use homeo::projection::Projection;
use homeo::shell::VertexOrder;
use homeo::shell::hdf5;
use homeo::transfer::attribute::{Attribute, Domain, Samples, Values, carry};
use homeo::transfer::{ExactPoint, Transfer, measured, random_points, round_trip, round_trip_phong};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let path = args.next().ok_or("usage: transfer SHELL.h5 [OTHER.ply [POINTS]]")?;
    let file = hdf5::read(Path::new(&path))?;
    let source = file.mesh.ok_or("the file holds no mesh")?;
    let target = match args.next().as_deref() {
        None | Some("middle") => {
            TriMesh { vertices: file.shell.middle.clone(), faces: file.shell.faces.clone() }
        }
        Some(other) => mesh::read(Path::new(other))?.mesh,
    };
    let count: usize = args.next().map_or(Ok(100_000), |n| n.parse())?;

    // One thread, so that the numbers below mean something.
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global()?;
    let projection = Projection::new(&file.shell, &VertexOrder::Id)?;
    let start = Instant::now();
    let transfer = Transfer::new(&projection, &source, &target)?;
    let pieces = transfer.pieces();
    println!("{} and {} pieces in {:.2} s", pieces[0], pieces[1], start.elapsed().as_secs_f64());

    // The value to carry: the distance of a mesh vertex from the z axis through the middle of the unit box.
    let data = source.vertices.iter().map(|p| (p[0] - 0.5).hypot(p[1] - 0.5)).collect();
    let values = Values::Numbers { width: 1, data, bytes: false };
    let attribute = Attribute { name: "radius".to_owned(), domain: Domain::Vertex, values };
    let carried = carry(&attribute, &source, &Samples::new(&transfer, &target, true)?)?;
    println!("carried {} values of `{}`", carried.values.len(), carried.name);

    let points = random_points(&source, count);
    let exact: Vec<ExactPoint> =
        points.iter().map(|&(face, w)| ExactPoint::from_f64(face, w)).collect::<Result<_, _>>()?;
    let rate = |name: &str, from: Instant| {
        let seconds = from.elapsed().as_secs_f64();
        println!("{name:<40} {:>10.0} points/s ({seconds:.2} s)", count as f64 / seconds);
    };
    let start = Instant::now();
    for &(face, weights) in &points {
        transfer.forward_f64(face, weights)?;
    }
    rate("f64", start);
    for round in ["exact, integers of pieces made on the way", "exact", "exact, reduced", "exact, as texts"] {
        let start = Instant::now();
        for p in &exact {
            let q = transfer.forward(p)?;
            match round {
                "exact, reduced" => drop(q.reduced()),
                "exact, as texts" => drop(q.texts()),
                _ => {}
            }
        }
        rate(round, start);
    }
    let start = Instant::now();
    let mut same = 0;
    for p in exact.iter().take(10_000) {
        let back = transfer.backward(&transfer.forward(p)?)?;
        same += usize::from(back.is_same(&transfer.canonical(p)?));
    }
    println!(
        "{same} of {} round trips are equalities ({:.2} s)",
        exact.len().min(10_000),
        start.elapsed().as_secs_f64()
    );

    let some = &points[..points.len().min(20_000)];
    println!("{:?}", measured(&transfer, some)?);
    println!("f64   {:?}", round_trip(&transfer, some));
    println!("Phong {:?}", round_trip_phong(&source, &target, some));
    Ok(())
}
