//! The tables of noise are made when something first needs them. Nothing else runs in this process.

use povista::compile;
use povista::diag::Collect;
use povista::interp::interpret;
use povista::math::noise::has_tables;
use povista::options::{LanguageOptions, RenderOptions};
use povista::render::{Statistics, render};
use povista::source::{Library, Source, Sources};

fn statistics(pigment: &str) -> Statistics {
    let text = format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 }} camera {{ }} light_source {{ -9*z, 1 }}
         plane {{ z, 5 pigment {{ {pigment} }} }}"
    );
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new("wall.pov", "", text.into_bytes()));
    let scene = interpret(main, &mut sources, &LanguageOptions::default(), &mut Collect::default()).unwrap();
    let options = RenderOptions::new(16, 12);
    render(&compile::compile(scene, &options).world, &options, &()).statistics
}

#[test]
fn scenes_without_noise_make_no_tables() {
    for pigment in ["rgb 1", "checker rgb 0 rgb 1", "gradient x turbulence 0", "function { sin(x)*y }"] {
        assert_eq!(statistics(pigment).noise, 0);
        assert!(!has_tables(), "{pigment}");
    }
    assert_eq!(statistics("bozo").noise, 192);
    assert!(has_tables());
}
