//! Textures that are chosen by a pattern, `tiles` or `material_map`.

use std::sync::Arc;

use super::super::{image, map, pattern, transform};
use super::{apply, block, keep_bump_depth, layer};
use crate::interp::{Result, Vm, Word};
use crate::scene::depth::Nested;
use crate::scene::pigment::BlendMap;
use crate::scene::texture::TextureBody;
use crate::scene::{Field, Pattern, Texture};

/// Reads a texture that begins with a pattern, `tiles`, `material_map` or `uv_mapping`; `None` for others.
pub(super) fn body(vm: &mut Vm<'_>) -> Result<Option<Texture>> {
    let Some(word) = vm.peek_word()? else { return Ok(None) };
    Ok(Some(match word {
        Word::Tiles => tiles(vm)?,
        Word::MaterialMap => material_map(vm)?,
        Word::UvMapping => {
            vm.next()?;
            let inner = super::body(vm)?;
            if matches!(*inner.body, TextureBody::UvMapped(_)) {
                return Ok(Some(inner));
            }
            Texture::new(TextureBody::UvMapped(Box::new(inner)))
        }
        _ => match pattern::read(vm, pattern::Owner::Texture)? {
            Some(field) => with_field(vm, field)?,
            None => return Ok(None),
        },
    }))
}

/// Reads the list or map of a pattern and its modifiers.
fn with_field(vm: &mut Vm<'_>, field: Field) -> Result<Texture> {
    let span = field.span;
    let (mut field, mut map, mut no_bump_scale) = (field, None, false);
    if let Some(count) = field.pattern.list_length() {
        let mut entries = pattern::list(vm, &field.pattern, count, Word::Texture, block)?;
        while entries.len() < count {
            entries.push(vm.state.texture.clone());
        }
        map = Some(Arc::new(BlendMap::list(entries)));
    }
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::TextureMap => {
                let place = vm.here()?;
                if field.pattern.list_length().is_some() {
                    return Err(map::for_list(vm, word, place));
                }
                map = Some(map::textures(vm, matches!(*field.pattern, Pattern::Average))?);
            }
            Word::NoBumpScale => {
                vm.next()?;
                no_bump_scale = true;
            }
            _ => {
                if !pattern::modifier(vm, &mut field)? {
                    break;
                }
            }
        }
    }
    pattern::check(vm, &field)?;
    match map {
        Some(map) => Ok(Texture::new(TextureBody::Patterned { field: Arc::new(field), map, no_bump_scale })),
        None => Err(vm.error(span, "a texture with a pattern needs textures to choose from").help(
            "add `texture_map { [0 …] [1 …] }`; for a coloured pattern write `pigment { … }` around it",
        )),
    }
}

/// Reads what may follow the name of a patterned texture.
pub(super) fn modifiers(vm: &mut Vm<'_>, mut texture: Texture) -> Result<Texture> {
    loop {
        if let Some(by) = transform::item(vm)? {
            apply(&mut texture, &by);
        } else if vm.accept(Word::NoBumpScale)? {
            keep_bump_depth(&mut texture);
        } else {
            return Ok(texture);
        }
    }
}

/// Reads `tiles { texture … tile2 texture … }`: a checker of two textures, the second of them in the
/// cube <0,0,0> to <1,1,1>, where `checker` has its first.
fn tiles(vm: &mut Vm<'_>) -> Result<Texture> {
    let inner = vm.enter()?;
    let first = stack(vm)?;
    if !vm.accept(Word::Tile2)? {
        return Err(vm.expected("`tile2`"));
    }
    let second = stack(vm)?;
    vm.close(inner)?;
    let field = Arc::new(Field::new(inner.span, Pattern::Checker));
    let map = Arc::new(BlendMap::list([second, first]));
    modifiers(vm, Texture::new(TextureBody::Patterned { field, map, no_bump_scale: false }))
}

/// Reads one or more textures, layered.
fn stack(vm: &mut Vm<'_>) -> Result<Texture> {
    let mut stacked = None;
    while vm.peek_word()? == Some(Word::Texture) {
        let place = vm.here()?;
        let over = block(vm)?;
        layer(vm, &mut stacked, over, place)?;
    }
    match stacked {
        Some(texture) => Ok(texture),
        None => Err(vm.expected("`texture { … }`")),
    }
}

/// Reads `material_map { image … texture … }`.
fn material_map(vm: &mut Vm<'_>) -> Result<Texture> {
    let inner = vm.enter()?;
    let image = Arc::new(image::map(vm, image::Usage::MaterialMap)?);
    let mut textures = Vec::new();
    while vm.peek_word()? == Some(Word::Texture) {
        textures.push(block(vm)?);
    }
    if textures.is_empty() {
        return Err(vm.expected("`texture { … }`"));
    }
    vm.close(inner)?;
    let field = Arc::new(Field::new(inner.span, Pattern::Image(Arc::clone(&image))));
    modifiers(vm, Texture::new(TextureBody::MaterialMap { field, image, textures: Nested::new(textures) }))
}
