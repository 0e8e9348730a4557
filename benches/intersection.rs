//! What the nearest surface of each primitive costs a ray, about half of which meet it:
//! `cargo bench --bench intersection`.

mod common;

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use povista::options::Accelerator;
use povista::world::{Range, RayKind};

/// Rays of a turn.
const RAYS: usize = 1000;

/// Each about as large as the cube that the rays go to.
const PRIMITIVES: [(&str, &str); 18] = [
    ("sphere", "sphere { 0, 0.9 }"),
    ("box", "box { -0.7, 0.7 }"),
    ("plane", "plane { y, 0 }"),
    ("cylinder", "cylinder { -y, y, 0.8 }"),
    ("cone", "cone { -y, 1, y, 0.2 }"),
    ("disc", "disc { 0, z, 1, 0.2 }"),
    ("torus", "torus { 0.7, 0.3 }"),
    ("triangle", "triangle { <-1,-1,0>, <1,-1,0>, <0,1,0> }"),
    ("quadric", "quadric { <1, 2, 3>, <0.5, 0, 0>, <0, 0, 0>, -1 }"),
    (
        "quartic",
        "quartic { <1,0,0,0,2,0,0,2,0,-1.16, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,0.84, 0,0,0,0, 1,0,-1.16,0,0.1764> }",
    ),
    (
        "blob",
        "blob { threshold 0.5 sphere { -0.3*x, 1, 1 } sphere { 0.3*x, 1, 1 } cylinder { -y, y, 0.5, 1 } }",
    ),
    ("superellipsoid", "superellipsoid { <0.4, 0.6> }"),
    ("lathe", "lathe { cubic_spline 6 <0.4,-1.2> <0.4,-1> <0.9,-0.3> <0.3,0.3> <0.8,0.9> <0.8,1.1> }"),
    ("prism", "prism { cubic_spline -0.8, 0.8, 7 <-1,0> <0,-1> <1,0> <0,1> <-1,0> <0,-1> <1,0> }"),
    (
        "sphere_sweep",
        "sphere_sweep { cubic_spline 5 <-1,-1,0>, 0.2 <-0.8,-0.5,0.5>, 0.3 <0,0.4,0>, 0.3 <0.8,-0.5,-0.5>, 0.2 <1,1,0>, 0.2 }",
    ),
    (
        "bicubic_patch",
        "bicubic_patch { type 1 u_steps 3 v_steps 3 <-1,-1,0> <-0.3,-1,0.5> <0.3,-1,-0.5> <1,-1,0> <-1,-0.3,0.5> <-0.3,-0.3,1> <0.3,-0.3,0> <1,-0.3,0> <-1,0.3,0> <-0.3,0.3,0> <0.3,0.3,-1> <1,0.3,0> <-1,1,0> <-0.3,1,0.5> <0.3,1,0> <1,1,0> }",
    ),
    (
        "isosurface",
        "isosurface { function { x*x + y*y*y*y + z*z - 0.7 + 0.1*sin(9*x) } contained_by { box { -1, 1 } } max_gradient 5 }",
    ),
    ("difference", "difference { box { -0.8, 0.8 } sphere { 0, 1 } cylinder { -x, x, 0.4 } }"),
];

fn intersections(c: &mut Criterion) {
    let rays = common::rays(RAYS);
    let mut group = c.benchmark_group("intersection");
    group.throughput(Throughput::Elements(RAYS as u64));
    for (name, text) in PRIMITIVES {
        let geometry = common::world(text, Accelerator::Auto).geometry;
        group.bench_function(name, |b| {
            b.iter(|| {
                let met = |ray| geometry.hit(black_box(ray), Range::AHEAD, RayKind::IMAGE).is_some();
                rays.iter().filter(|ray| met(ray)).count()
            });
        });
    }
    group.finish();
}

criterion_group!(benches, intersections);
criterion_main!(benches);
