//! Time per point of every kernel function, with every kind of vector this machine has.
//!
//! `cargo bench -p sheave-kernels --no-default-features`; the throughput that criterion prints is points per second.
#![allow(missing_docs)]

mod common;

use common::{Batch, POINTS};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use generated::{REGIONS, Simd};

fn kernels(criterion: &mut Criterion) {
    for kernel in REGIONS {
        let functions = [("value", kernel.value), ("jacobian", kernel.jacobian), ("full", kernel.full)];
        let mut group = criterion.benchmark_group(kernel.name);
        group.throughput(Throughput::Elements(POINTS as u64));
        let mut batch = Batch::new(kernel);
        for (name, function) in functions {
            for simd in Simd::available() {
                Simd::limit(simd);
                let id = BenchmarkId::new(name, format!("{simd:?}"));
                group.bench_function(id, |bencher| bencher.iter(|| batch.run(function)));
            }
        }
        Simd::limit(Simd::Avx512);
        group.finish();
    }
}

criterion_group!(benches, kernels);
criterion_main!(benches);
