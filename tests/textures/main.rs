//! Textures from the text of a scene to the numbers they give.

mod hostile;
mod images;
mod tables;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use povista::compile::texture::TextureCompiler;
use povista::diag::Collect;
use povista::interp::interpret;
use povista::math::Transform;
use povista::options::LanguageOptions;
use povista::scene::function::{Expr, FunctionBody};
use povista::scene::pigment::PigmentKind;
use povista::scene::texture::TextureBody;
use povista::scene::{Function, Pattern, Scene};
use povista::source::{Library, Source, Sources};
use povista::world;
use povista::world::texture::Texture;

/// A folder with the files that the probes name.
pub(crate) fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let ppm = "P3\n3 2\n255\n10 20 30  200 100 50  0 255 128\n77 88 99  5 250 125  60 60 61\n";
    fs::write(folder.path().join("probe.ppm"), ppm).unwrap();
    let samples = [
        13, 141, 87, 107, 201, 113, 99, 159, 37, 245, 15, 115, 33, 25, 91, 231, 189, 221, 71, 251, 249, 65,
        211, 175,
    ];
    let df3: Vec<u8> = [0, 3, 0, 2, 0, 4].into_iter().chain(samples).collect();
    fs::write(folder.path().join("probe.df3"), df3).unwrap();
    folder
}

fn read(text: &str, folder: &Path) -> Result<Scene, String> {
    let mut sources = Sources::new(Library { current: folder.to_owned(), ..Library::default() });
    let main = sources.add(Source::new("probe.pov", folder.join("probe.pov"), text.as_bytes().to_vec()));
    let mut sink = Collect::default();
    interpret(main, &mut sources, &LanguageOptions::default(), &mut sink)
        .ok_or_else(|| sink.diagnostics.iter().map(|d| format!("{} ", d.message)).collect())
}

/// The function that the scene's only object is painted with, taken out of the sum it stands in.
fn painted(scene: &Scene) -> Option<Arc<Function>> {
    let TextureBody::Layered(layers) = &*scene.objects.first()?.texture.as_ref()?.body else { return None };
    let pigment = layers.first()?.paint.pigment();
    let PigmentKind::Colors { field, .. } = &pigment.kind else { return None };
    let Pattern::Function(function) = &*field.pattern else { return None };
    match &*function.body {
        FunctionBody::Expression(Expr::User(inner, _) | Expr::Component(inner, _, _)) => Some(inner.clone()),
        _ => None,
    }
}

/// Compiles `function{BODY}`; `member` is empty or `.red`.
fn function(body: &str, member: &str, folder: &Path) -> Result<Arc<world::Function>, String> {
    let text = format!(
        "#version 3.7; global_settings{{assumed_gamma 1}} #declare F = function{{{body}}} \
         sphere{{0,1 pigment{{function{{F(x,y,z){member}}}}}}}"
    );
    let scene = read(&text, folder)?;
    let function = painted(&scene).ok_or("the function is not where it should be")?;
    TextureCompiler::new(&scene.settings).function(&function).map_err(|error| error.to_string())
}

pub(crate) fn pattern(body: &str, folder: &Path) -> Result<Arc<world::Function>, String> {
    function(&format!("pattern{{{body}}}"), "", folder)
}

pub(crate) fn pigment(body: &str, folder: &Path) -> Result<Arc<world::Function>, String> {
    function(&format!("pigment{{{body}}}"), ".red", folder)
}

/// The texture of the scene's only object.
pub(crate) fn texture(text: &str, folder: &Path) -> Result<Texture, String> {
    let scene = read(&format!("#version 3.7; global_settings{{assumed_gamma 1}} {text}"), folder)?;
    let texture = scene.objects.first().and_then(|object| object.texture.as_ref()).ok_or("no texture")?;
    let mut compiler = TextureCompiler::new(&scene.settings);
    compiler.texture(texture, &Transform::IDENTITY).map_err(|error| error.to_string())
}
