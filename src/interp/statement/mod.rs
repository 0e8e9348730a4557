//! Readers of statements: one block of the language to a file.
//!
//! A reader leaves its keyword to `Vm::enter`, reads parameters, then items as long as one fits, and
//! gives back a value of [`crate::scene`] with every default filled in. What has an identity of its own
//! (camera, objects, fog …) goes to the [`State`] at the top level only; everywhere else it is a value.

mod background;
mod bounds;
mod camera;
mod color;
mod finish;
mod fog;
mod function;
mod global_settings;
mod image;
mod interior;
mod light_group;
mod light_source;
mod map;
mod material;
mod media;
mod modifier;
mod normal;
mod object;
mod pattern;
mod photons;
mod pigment;
mod rainbow;
mod read;
mod shape;
mod sky_sphere;
mod state;
mod texture;
mod transform;
mod warp;

pub use function::read_function_body;
pub use state::{State, finish};

use std::sync::Arc;

use super::value::Value;
use super::{Result, Vm, Word};
use crate::source::Span;
use crate::syntax::Punct;

/// Reads the statement a reserved word starts, as the value of a declaration or an argument of a
/// macro. The word is peeked, not taken. `None`, and nothing taken, when it starts no such thing.
pub fn read_rvalue(vm: &mut Vm, word: Word) -> Result<Option<Value>> {
    if object::is_object(word) {
        return Ok(Some(Value::Object(Arc::new(object::statement(vm)?))));
    }
    Ok(Some(match word {
        Word::Texture => Value::Texture(texture::blocks(vm)?),
        Word::Pigment => {
            let base = vm.state.pigment();
            Value::Pigment(pigment::block(vm, &base)?)
        }
        Word::Normal => {
            let base = vm.state.normal();
            Value::Normal(normal::value(vm, base.as_ref())?)
        }
        Word::Finish => {
            let base = vm.state.finish();
            Value::Finish(finish::block(vm, &base)?)
        }
        Word::Interior => Value::Interior(interior::block(vm, None)?),
        Word::Media => Value::Media(Arc::new(media::block(vm)?)),
        Word::Density => Value::Density(pigment::density(vm)?),
        Word::Material => Value::Material(Arc::new(material::block(vm)?)),
        Word::Transform => Value::Transform(transform::value(vm)?),
        Word::Camera => Value::Camera(Arc::new(camera::block(vm)?)),
        Word::Fog => Value::Fog(Arc::new(fog::block(vm)?)),
        Word::Rainbow => Value::Rainbow(Arc::new(rainbow::block(vm)?)),
        Word::SkySphere => Value::SkySphere(Arc::new(sky_sphere::block(vm)?)),
        Word::ColorMap | Word::ColourMap => Value::ColorMap(map::colors(vm)?),
        Word::PigmentMap => {
            let base = vm.state.pigment();
            Value::PigmentMap(map::pigments(vm, pattern::Owner::Pigment, &base, true)?)
        }
        Word::DensityMap => {
            Value::DensityMap(map::pigments(vm, pattern::Owner::Density, &vm.state.empty(), true)?)
        }
        Word::NormalMap => Value::NormalMap(map::normals(vm, true)?),
        Word::TextureMap => Value::TextureMap(map::textures(vm, true)?),
        Word::SlopeMap => Value::SlopeMap(map::slopes(vm)?),
        _ => return Ok(None),
    }))
}

/// Reads a statement at the top level of the scene. `false`, and nothing taken, when none starts
/// there.
pub fn read_top_level(vm: &mut Vm) -> Result<bool> {
    if let Some(object) = object::any(vm)? {
        bounds::warn_of_superfluous(vm, &object);
        vm.state.add(object);
        return Ok(true);
    }
    match vm.peek_word()? {
        Some(Word::Camera) => {
            let camera = camera::block(vm)?;
            if vm.state.scene_camera.is_some() && vm.version >= 350 {
                vm.warn(camera.span, "the scene has a camera already", "this one replaces it");
            }
            vm.state.scene_camera = Some(camera);
        }
        Some(Word::Fog) => {
            let fog = fog::block(vm)?;
            vm.state.fogs.push(fog);
        }
        Some(Word::Rainbow) => {
            let rainbow = rainbow::block(vm)?;
            vm.state.rainbows.push(rainbow);
        }
        Some(Word::SkySphere) => {
            let sky = sky_sphere::block(vm)?;
            if vm.state.sky_sphere.is_some() {
                vm.warn(sky.span, "the scene has a sky_sphere already", "this one replaces it");
            }
            vm.state.sky_sphere = Some(sky);
        }
        Some(Word::Background) => vm.state.background = Some(background::block(vm)?),
        Some(Word::Media) => {
            let media = media::block(vm)?;
            vm.state.atmosphere.push(media);
        }
        Some(Word::GlobalSettings) => global_settings::block(vm)?,
        Some(word @ (Word::MaxTraceLevel | Word::MaxIntersections)) => {
            let place = vm.next()?.span;
            if vm.version >= 300 {
                let message = format!("`{}` belongs into `global_settings`", word.text());
                vm.possible(place, message, "write `global_settings { … }` around it");
            }
            if word == Word::MaxTraceLevel {
                vm.state.settings.max_trace_level = global_settings::max_trace_level(vm)?;
            } else {
                vm.read_int()?;
            }
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// Reads what follows `#default` (docs/spec/language.md 2.10).
pub fn read_default(vm: &mut Vm, span: Span) -> Result<()> {
    let open = vm.expect(Punct::OpenBrace)?;
    loop {
        match vm.peek_word()? {
            Some(Word::Texture) => {
                let texture = texture::block(vm)?;
                vm.state.set_texture(texture).map_err(|message| {
                    vm.error(span, message).help("the default texture is one pigment, normal and finish")
                })?;
            }
            Some(Word::Pigment) => {
                let base = vm.state.pigment();
                let pigment = pigment::block(vm, &base)?;
                vm.state.layer().paint = pigment.into();
            }
            Some(Word::Normal) => {
                let base = vm.state.normal();
                let normal = normal::default(vm, base.as_ref())?;
                vm.state.layer().normal = normal;
            }
            Some(Word::Finish) => {
                let base = vm.state.finish();
                let finish = finish::block(vm, &base)?;
                vm.state.layer().finish = finish;
            }
            Some(Word::Camera) => camera::default(vm)?,
            Some(Word::Radiosity) => vm.state.importance = Some(modifier::importance(vm)?),
            _ => break,
        }
    }
    if !vm.accept_punct(Punct::CloseBrace)? {
        return Err(vm.expected("`}` of `#default`").see(open, "opened here"));
    }
    Ok(())
}
