//! How fast user functions are called. `cargo bench --bench functions`.

use std::hint::black_box;
use std::sync::Arc;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use povista::compile::texture::TextureCompiler;
use povista::diag::Collect;
use povista::interp::interpret;
use povista::options::LanguageOptions;
use povista::scene::pigment::PigmentKind;
use povista::scene::texture::TextureBody;
use povista::scene::{Pattern, Scene};
use povista::source::{Library, Source, Sources};
use povista::world::Function;

/// Calls in a turn.
const CALLS: u32 = 1000;

/// What is declared before, and the expression.
const CASES: [(&str, &str, &str); 7] = [
    ("polynomial", "", "x*x*x - 3*x*y*y + 2*z - x*y*z + 0.5"),
    ("distance", "", "sqrt(x*x + y*y + z*z) - 1"),
    ("gyroid", "", "sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)"),
    ("choices", "", "select(x - y, max(x, y, z), min(x*x, y, z), pow(z, 3))"),
    ("sum of twenty", "", "sum(i, 1, 20, sin(i*x)/i)"),
    (
        "functions of functions",
        "#declare T = function(x,y,z,A) { internal(70) } #declare G = function(x,y,z) { T(x,y,z,1)*0.5 }",
        "G(x,y,z) + G(y,z,x)*x",
    ),
    ("noise", "#declare N = function { internal(76) }", "N(x*3,y*3,z*3)*0.3 + y"),
];

fn read(text: &str) -> Option<Scene> {
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new("functions.pov", "", text.as_bytes().to_vec()));
    interpret(main, &mut sources, &LanguageOptions::default(), &mut Collect::default())
}

/// The function that the scene's only object is painted with.
fn painted(scene: &Scene) -> Option<Arc<Function>> {
    let TextureBody::Layered(layers) = &*scene.objects.first()?.texture.as_ref()?.body else { return None };
    let pigment = layers.first()?.paint.pigment();
    let PigmentKind::Colors { field, .. } = &pigment.kind else { return None };
    let Pattern::Function(function) = &*field.pattern else { return None };
    TextureCompiler::new(&scene.settings).function(function).ok()
}

fn calls(c: &mut Criterion) {
    let mut group = c.benchmark_group("function");
    group.throughput(Throughput::Elements(u64::from(CALLS)));
    for (name, declared, body) in CASES {
        let text = format!("#version 3.7; {declared} sphere {{ 0, 1 pigment {{ function {{ {body} }} }} }}");
        let function = read(&text).as_ref().and_then(painted).expect("the function is read");
        group.bench_function(name, |b| {
            b.iter(|| {
                let at = |n: u32| f64::from(n) * 0.001;
                (0..CALLS).map(|n| function.call(black_box(&[at(n), 1.0 - at(n), 0.3 + at(n)]))).sum::<f64>()
            });
        });
    }
    group.finish();
}

criterion_group!(benches, calls);
criterion_main!(benches);
