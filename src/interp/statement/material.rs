//! `material { … }` (docs/spec/language.md 6.14).

use std::sync::Arc;

use super::{interior, modifier, texture, transform};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::Transform;
use crate::scene::Object;
use crate::scene::interior::Material;
use crate::scene::object::ObjectFlags;

/// Reads `material { … }`, whose keyword comes next.
pub(in crate::interp) fn block(vm: &mut Vm<'_>) -> Result<Material> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::Material(material) => Some(Material::clone(material)),
        _ => None,
    })?;
    let mut material = named.unwrap_or_default();
    loop {
        if let Some(by) = transform::item(vm)? {
            apply(&mut material, &by);
            continue;
        }
        match vm.peek_word()? {
            Some(word @ (Word::Texture | Word::InteriorTexture)) => {
                let place = vm.here()?;
                let over = texture::block(vm)?;
                let target = match word {
                    Word::Texture => &mut material.texture,
                    _ => &mut material.interior_texture,
                };
                texture::layer(vm, target, over, place)?;
            }
            Some(Word::Interior) => {
                material.interior = Some(interior::block(vm, material.interior.take())?);
            }
            _ => break,
        }
    }
    vm.close(block)?;
    Ok(material)
}

fn apply(material: &mut Material, by: &Transform) {
    for texture in [&mut material.texture, &mut material.interior_texture].into_iter().flatten() {
        texture::apply(texture, by);
    }
    if let Some(interior) = material.interior.as_mut().filter(|interior| !interior.media.is_empty()) {
        Arc::make_mut(interior).apply(by);
    }
}

/// Reads the material of an object.
pub(super) fn modifier(vm: &mut Vm<'_>, object: &mut Object) -> Result<()> {
    let place = vm.here()?;
    let material = block(vm)?;
    if let Some(over) = material.texture {
        texture::layer(vm, &mut object.texture, over, place)?;
        object.flags |= ObjectFlags::TEXTURED;
    }
    if let Some(over) = material.interior_texture {
        texture::layer(vm, &mut modifier::extra(object).interior_texture, over, place)?;
    }
    if let Some(interior) = material.interior {
        modifier::extra(object).interior = Some(interior);
    }
    Ok(())
}
