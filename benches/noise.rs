//! How fast noise is: values one by one, and octaves together. `cargo bench --bench noise`.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use povista::math::DVec3;
use povista::math::noise::{Octaves, noise, noise_scaled, vector_noise, vector_noise_scaled};

/// The frequencies of ten octaves.
const TEN: [f64; 10] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0];

/// A wall seen from the front, row by row: neighbours are near each other, as in a picture.
fn wall() -> Vec<DVec3> {
    let place = |n: u32| f64::from(n) / 64.0 * 9.0 - 4.5;
    (0..64).flat_map(|y| (0..64).map(move |x| DVec3::new(place(x), place(y), 3.3))).collect()
}

fn values(c: &mut Criterion) {
    let wall = wall();
    let mut group = c.benchmark_group("noise");
    group.throughput(Throughput::Elements(wall.len() as u64));
    for generator in 1..=3 {
        group.bench_with_input(BenchmarkId::new("value", generator), &generator, |b, generator| {
            b.iter(|| wall.iter().map(|p| noise(*generator, black_box(*p))).sum::<f64>());
        });
    }
    group.bench_function("vector", |b| {
        b.iter(|| wall.iter().map(|p| vector_noise(black_box(*p))).sum::<DVec3>());
    });
    group.finish();
}

fn octaves(c: &mut Criterion) {
    let wall = wall();
    let six = Octaves { count: 6, omega: 0.5, lambda: 2.0 };
    let mut group = c.benchmark_group("octaves");
    group.throughput(Throughput::Elements(wall.len() as u64));
    group.bench_function("scalar turbulence, 6", |b| {
        b.iter(|| wall.iter().map(|p| six.scalar(2, black_box(*p))).sum::<f64>());
    });
    group.bench_function("vector turbulence, 6", |b| {
        b.iter(|| wall.iter().map(|p| six.vector(black_box(*p))).sum::<DVec3>());
    });
    group.bench_function("noise, 10", |b| {
        b.iter(|| wall.iter().map(|p| noise_scaled(2, black_box(*p), &TEN)[9]).sum::<f64>());
    });
    group.bench_function("vector noise, 10", |b| {
        b.iter(|| wall.iter().map(|p| vector_noise_scaled(black_box(*p), &TEN)[9]).sum::<DVec3>());
    });
    group.finish();
}

criterion_group!(benches, values, octaves);
criterion_main!(benches);
