//! C1 on a large generated shell, all claims on an initial shell, and the checker on their certificate.
#![allow(missing_docs, clippy::expect_used, clippy::panic)]

use criterion::{Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use homeo_benches::generate::{initial, same, simplified};
use homeo_benches::run::{checker_inputs, on_one_thread, positivity, whole};

fn c1(criterion: &mut Criterion) {
    let shell = same(160).shell;
    let mut group = criterion.benchmark_group("positivity");
    group.throughput(Throughput::Elements(shell.tet_count() as u64)).sample_size(10);
    group.sampling_mode(SamplingMode::Flat);
    group.bench_function("204,800 prisms", |bencher| {
        // The certifier's own clock: input conditions and certificate are left out.
        bencher.iter_custom(|rounds| {
            let round = || on_one_thread(|| positivity(&shell)).expect("a pool").expect("a valid shell").1;
            std::time::Duration::from_secs_f64((0..rounds).map(|_| round()).sum())
        });
    });
    group.finish();
}

fn all_claims(criterion: &mut Criterion) {
    let inputs =
        [("initial, 20,000 triangles", initial(50)), ("simplified, 12,800 triangles", simplified(10, 2))];
    for (name, input) in inputs {
        let mut group = criterion.benchmark_group(name);
        group.sample_size(10).sampling_mode(SamplingMode::Flat);
        group.bench_function("certify", |bencher| {
            bencher.iter(|| on_one_thread(|| whole(&input)).expect("a pool").expect("valid input"));
        });
        let (outcome, _) = on_one_thread(|| whole(&input)).expect("a pool").expect("valid input");
        let files = checker_inputs(&input).expect("writable meshes");
        let answer = homeo_certs::check(outcome.certificate.as_ref(), &files);
        assert_eq!(answer.status, "valid", "{} {}", answer.code, answer.message);
        group.bench_function("check", |bencher| {
            bencher.iter(|| homeo_certs::check(outcome.certificate.as_ref(), &files));
        });
        group.finish();
    }
}

criterion_group!(benches, c1, all_claims);
criterion_main!(benches);
