//! Points a second of the transfer between two sections of a shell, on one thread.
#![allow(missing_docs, clippy::expect_used)]

use criterion::{Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use homeo::construct::sample;
use homeo::mesh::TriMesh;
use homeo::projection::Projection;
use homeo::shell::VertexOrder;
use homeo::transfer::phong::Phong;
use homeo::transfer::{ExactPoint, Transfer, random_points};
use homeo_benches::run::on_one_thread;

fn transfer(criterion: &mut Criterion) {
    let made = sample(3);
    let middle = TriMesh { vertices: made.shell.middle.clone(), faces: made.shell.faces.clone() };
    let projection = Projection::new(&made.shell, &VertexOrder::Id).expect("positive tets");
    let build = || Transfer::new(&projection, &made.mesh, &middle).expect("valid meshes");
    let map = build();
    let points = random_points(&made.mesh, 50_000);
    let exact: Vec<ExactPoint> =
        points.iter().map(|&(f, w)| ExactPoint::from_f64(f, w).expect("weights")).collect();
    let mut group = criterion.benchmark_group("transfer, 1,280 prisms, 5,120 triangles");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.bench_function("cutting both meshes", |bencher| {
        bencher.iter(|| on_one_thread(|| build().pieces()).expect("a pool"));
    });
    group.throughput(Throughput::Elements(points.len() as u64));
    group.bench_function("f64", |bencher| {
        bencher.iter(|| {
            points.iter().map(|&(f, w)| map.forward_f64(f, w).expect("a section").error).sum::<f64>()
        });
    });
    group.bench_function("exact, homogeneous", |bencher| {
        bencher.iter(|| exact.iter().filter(|p| map.forward(p).is_ok()).count());
    });
    group.bench_function("exact, lowest terms", |bencher| {
        bencher.iter(|| exact.iter().filter(|p| map.forward(p).is_ok_and(|q| q.reduced().face > 0)).count());
    });
    let some = &points[..1000];
    group.throughput(Throughput::Elements(some.len() as u64));
    let phong = Phong::new(&middle);
    let place = |&(f, w): &(u32, [f64; 3])| {
        let sum: f64 = w.iter().sum();
        let corners = made.mesh.faces[f as usize].map(|v| made.mesh.vertices[v as usize]);
        [0, 1, 2].map(|i| (0..3).map(|k| w[k] / sum * corners[k][i]).sum::<f64>())
    };
    let places: Vec<[f64; 3]> = some.iter().map(place).collect();
    group.bench_function("Phong projection", |bencher| {
        bencher.iter(|| places.iter().filter(|p| phong.project(**p).is_some()).count());
    });
    group.finish();
}

criterion_group!(benches, transfer);
criterion_main!(benches);
