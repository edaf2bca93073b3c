//! `orient3d` beside two other crates, on random, nearly coplanar and coplanar points.
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use homeo_benches::quads::{IMPLEMENTATIONS, Kind, quads};

fn orient3d(criterion: &mut Criterion) {
    for kind in Kind::ALL {
        let inputs = quads(kind, 10_000);
        let mut group = criterion.benchmark_group(format!("orient3d, {}", kind.name()));
        group.throughput(Throughput::Elements(inputs.len() as u64));
        for (name, implementation) in IMPLEMENTATIONS {
            group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
                bencher.iter(|| inputs.iter().map(|q| i64::from(implementation(black_box(q)))).sum::<i64>());
            });
        }
        group.finish();
    }
}

criterion_group!(benches, orient3d);
criterion_main!(benches);
