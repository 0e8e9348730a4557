//! What benches of rays share: worlds out of text, and rays that are the same on every machine.

use povista::compile::compile;
use povista::diag::Collect;
use povista::interp::interpret;
use povista::math::DVec3;
use povista::options::{Accelerator, LanguageOptions, RenderOptions};
use povista::source::{Library, Source, Sources};
use povista::world::{Ray, World};

/// The world that a text describes.
pub(crate) fn world(text: &str, accelerator: Accelerator) -> World {
    let mut sources = Sources::new(Library::default());
    let text = format!("#version 3.7; {text}");
    let main = sources.add(Source::new("bench.pov", "", text.into_bytes()));
    let mut told = Collect::default();
    let scene = interpret(main, &mut sources, &LanguageOptions::default(), &mut told);
    let scene = scene.unwrap_or_else(|| panic!("the scene is not understood: {told:?}"));
    compile(scene, &RenderOptions { accelerator, ..RenderOptions::new(160, 120) }).world
}

/// Rays from a ball of radius 3 around the origin to points in a cube of half edge 1.
pub(crate) fn rays(count: usize) -> Vec<Ray> {
    let mut state = 1_u64;
    let mut number = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
    };
    let mut point = || DVec3::new(number(), number(), number());
    (0..count)
        .map(|_| {
            let origin = 3.0 * point().normalize_or(DVec3::X);
            Ray::new(origin, (point() - origin).normalize())
        })
        .collect()
}
