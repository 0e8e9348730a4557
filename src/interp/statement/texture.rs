//! `texture { … }` (docs/spec/language.md 6.8, docs/spec/patterns-textures.md 7).

mod free_form;
mod layers;
mod patterned;

pub(super) use layers::{layer, part};

use std::sync::Arc;

use super::{finish, normal, pattern, pigment, transform};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::Transform;
use crate::scene::Texture;
use crate::scene::texture::{Layer, Paint, TextureBody};

/// Reads `texture { … }`; its keyword comes next.
pub(in crate::interp) fn block(vm: &mut Vm<'_>) -> Result<Texture> {
    let block = vm.enter()?;
    let texture = body(vm)?;
    vm.close(block)?;
    Ok(texture)
}

/// Reads `texture { … }` and those after it, which are layered over it. In a `#declare` nothing is
/// run to find out whether one follows (docs/spec/language.md 2.2).
pub(in crate::interp) fn blocks(vm: &mut Vm<'_>) -> Result<Texture> {
    let mut texture = Some(block(vm)?);
    while vm.peek_raw().kind == crate::interp::stream::TokenKind::Word(Word::Texture) {
        let place = vm.here()?;
        let over = block(vm)?;
        layer(vm, &mut texture, over, place)?;
    }
    match texture {
        Some(texture) => Ok(texture),
        None => Err(vm.expected("`texture`")),
    }
}

/// Reads the inside of a `texture`, as it also stands in a `texture_map`.
pub(super) fn body(vm: &mut Vm<'_>) -> Result<Texture> {
    vm.nested_value(vm.last, |vm| inside(vm))
}

fn inside(vm: &mut Vm<'_>) -> Result<Texture> {
    let named = vm.accept_value(|value| match value {
        Value::Texture(texture) => Some(Texture::clone(texture)),
        _ => None,
    })?;
    match named {
        Some(texture) if !matches!(&*texture.body, TextureBody::Layered(_)) => {
            patterned::modifiers(vm, texture)
        }
        Some(texture) => plain(vm, texture),
        None => {
            let choice = matches!(vm.peek_word()?, Some(Word::Tiles | Word::MaterialMap));
            if (choice || !free_form::applies(vm))
                && let Some(texture) = patterned::body(vm)?
            {
                return Ok(texture);
            }
            let mut default = vm.state.texture.clone();
            free_form::grain(vm, &mut default)?;
            plain(vm, default)
        }
    }
}

/// Reads what makes up a plain texture, starting from a copy of another.
fn plain(vm: &mut Vm<'_>, mut texture: Texture) -> Result<Texture> {
    loop {
        if let Some(by) = transform::item(vm)? {
            apply(&mut texture, &by);
            continue;
        }
        match vm.peek_word()? {
            Some(Word::Pigment) => {
                let top = layers::top(vm, &mut texture)?;
                top.paint = pigment::block(vm, &top.paint.pigment())?.into();
            }
            Some(Word::Normal) => {
                let top = layers::top(vm, &mut texture)?;
                top.normal = Some(normal::block(vm, top.normal.as_ref())?);
            }
            Some(Word::Finish) => {
                let top = layers::top(vm, &mut texture)?;
                top.finish = finish::block(vm, &top.finish)?;
            }
            Some(Word::NoBumpScale) => {
                vm.next()?;
                keep_bump_depth(&mut texture);
            }
            Some(_) if free_form::item(vm, &mut texture)? => {}
            Some(word) if pattern::is_pattern(word) => {
                return Err(vm
                    .expected("`}`")
                    .help("the pattern of a texture comes first, before everything else"));
            }
            Some(_) => return Ok(texture),
            None => {
                if !layers::variable(vm, &mut texture)? && !free_form::item(vm, &mut texture)? {
                    return Ok(texture);
                }
            }
        }
    }
}

/// Moves a texture by a transform of its own: every layer, or the pattern between its textures.
pub(super) fn apply(texture: &mut Texture, by: &Transform) {
    match Arc::make_mut(&mut texture.body) {
        TextureBody::Layered(layers) => {
            for layer in &mut layers[..] {
                move_layer(layer, by);
            }
        }
        TextureBody::Patterned { field, .. } | TextureBody::MaterialMap { field, .. } => {
            Arc::make_mut(field).apply(by);
        }
        TextureBody::UvMapped(_) => {}
    }
}

fn move_layer(layer: &mut Layer, by: &Transform) {
    if let Paint::Pigment(pigment) = &mut layer.paint
        && pigment.field().is_some()
    {
        Arc::make_mut(pigment).apply(by);
    }
    if let Some(normal) = &mut layer.normal {
        Arc::make_mut(normal).apply(by);
    }
}

/// `no_bump_scale`: transforms no longer change the depth of the bumps.
fn keep_bump_depth(texture: &mut Texture) {
    match Arc::make_mut(&mut texture.body) {
        TextureBody::Layered(layers) => {
            for normal in layers.iter_mut().filter_map(|layer| layer.normal.as_mut()) {
                Arc::make_mut(normal).no_bump_scale = true;
            }
        }
        TextureBody::Patterned { no_bump_scale, .. } => *no_bump_scale = true,
        TextureBody::MaterialMap { .. } | TextureBody::UvMapped(_) => {}
    }
}
