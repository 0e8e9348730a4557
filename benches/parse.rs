//! How fast scenes are read: literal data, loops, macros. `cargo bench --bench parse`.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use povista::interp::check::check_with;
use povista::options::LanguageOptions;
use povista::source::{FileId, Library, Source};
use povista::syntax::{Symbols, parse};
use std::fmt::Write;

/// Turns of each loop.
const TURNS: u32 = 10_000;

fn tokens(c: &mut Criterion) {
    let mut text = String::from("mesh2 { vertex_vectors { 20000");
    for i in 0..20_000 {
        let _ = write!(text, ", <{}.25, -{i}.5e-3, {}>", i % 97, i * 7);
    }
    text.push_str("} }");
    let source = Source::new("mesh.inc", "", text.into_bytes());
    let mut group = c.benchmark_group("tokens");
    group.throughput(Throughput::Bytes(source.text().len() as u64));
    group.bench_function("literal mesh", |b| {
        b.iter_batched(
            || Symbols::new([]),
            |mut symbols| parse(FileId(0), &source, &mut symbols),
            BatchSize::LargeInput,
        );
    });
    group.finish();
}

fn scenes(c: &mut Criterion) {
    let objects = "sphere { <rand(R)*20-10, sin(I)*5, I/1000>, 0.1+0.2*rand(R)
        pigment { rgb <rand(R), rand(R), rand(R)> } translate <0, 1, 0> }";
    let cases = [
        ("objects in #while", format!("#while (I < {TURNS}) {objects} #declare I = I + 1; #end")),
        ("objects in #for", format!("#for (I, 1, {TURNS}) {objects} #end")),
        ("macro calls", format!("#macro M(A, B) A*B+I #end #for (I, 1, {TURNS}) #local S = M(I, 2); #end")),
        ("strings", format!("#for (I, 1, {TURNS}) #local S = concat(\"n\", str(I, 0, 2)); #end")),
        (
            "array filled and read",
            format!(
                "#declare A = array[{TURNS}] #for (I, 0, {TURNS}-1) #declare A[I] = I*2; #end
                 #for (I, 0, {TURNS}-1) #declare S = A[I]+1; #end"
            ),
        ),
    ];
    let mut group = c.benchmark_group("turns");
    group.throughput(Throughput::Elements(u64::from(TURNS))).sample_size(20);
    for (name, body) in cases {
        let text = format!("#version 3.7; #declare R = seed(7); #declare I = 0; {body}");
        group.bench_function(name, |b| {
            b.iter(|| {
                let source = Source::new("loop.pov", "", text.clone().into_bytes());
                check_with(source, Library::default(), &LanguageOptions::default())
            });
        });
    }
    group.finish();
}

criterion_group!(benches, tokens, scenes);
criterion_main!(benches);
