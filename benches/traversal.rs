//! Linear search, octree and tree of boxes side by side: random spheres and triangles in a cube, the nearest
//! surface and whether anything is in the way. `cargo bench --bench traversal`.

mod common;

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use povista::options::Accelerator;
use povista::world::{Range, RayKind};

/// Rays of a turn.
const RAYS: usize = 1000;

/// The kinds; going through more than some thousand objects for each ray shows nothing new.
const ACCELERATORS: [(&str, Accelerator, usize); 3] = [
    ("linear", Accelerator::Linear, 1000),
    ("octree", Accelerator::Octree, usize::MAX),
    ("bvh", Accelerator::Bvh, usize::MAX),
];

/// So many things that hide about as much of the cube however many they are.
fn scene(kind: &str, count: usize) -> String {
    let size = 0.6 / (count as f64).cbrt();
    let place = "2*<rand(R), rand(R), rand(R)> - 1";
    let thing = match kind {
        "spheres" => format!("sphere {{ {place}, {size} }}"),
        _ => {
            let corner = format!("P + {size}*({place})");
            format!("#local P = {place}; triangle {{ {corner}, {corner}, {corner} }}")
        }
    };
    format!("#declare R = seed(1); #for (I, 1, {count}) {thing} #end")
}

fn traversals(c: &mut Criterion) {
    let rays = common::rays(RAYS);
    for kind in ["spheres", "triangles"] {
        for count in [10, 1000, 100_000] {
            let mut group = c.benchmark_group(format!("{count} {kind}"));
            group.throughput(Throughput::Elements(RAYS as u64));
            for (name, accelerator, most) in ACCELERATORS {
                if count > most {
                    continue;
                }
                let geometry = common::world(&scene(kind, count), accelerator).geometry;
                group.bench_function(BenchmarkId::new(name, "nearest"), |b| {
                    b.iter(|| {
                        let met = |ray| geometry.hit(black_box(ray), Range::AHEAD, RayKind::IMAGE).is_some();
                        rays.iter().filter(|ray| met(ray)).count()
                    });
                });
                let mut through = Vec::new();
                group.bench_function(BenchmarkId::new(name, "any"), |b| {
                    b.iter(|| {
                        let mut blocked = |ray| {
                            geometry.occluders(black_box(ray), Range::AHEAD, None, &mut through).is_some()
                        };
                        rays.iter().filter(|ray| blocked(ray)).count()
                    });
                });
            }
            group.finish();
        }
    }
}

criterion_group!(benches, traversals);
criterion_main!(benches);
