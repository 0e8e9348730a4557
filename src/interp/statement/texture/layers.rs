//! Layers: textures over each other, and their top one in the making.

use std::sync::Arc;

use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::scene::Texture;
use crate::scene::texture::{Layer, TextureBody};
use crate::source::Span;

use super::super::{finish, normal, pigment};

/// Puts a texture over what is there.
pub(in crate::interp::statement) fn layer(
    vm: &mut Vm<'_>,
    under: &mut Option<Texture>,
    over: Texture,
    place: Span,
) -> Result<()> {
    let Some(lower) = under else {
        *under = Some(over);
        return Ok(());
    };
    settle(lower);
    let mut over = over;
    settle(&mut over);
    let TextureBody::Layered(added) = &*over.body else {
        return Err(unlayerable(vm, place));
    };
    match Arc::make_mut(&mut lower.body) {
        TextureBody::Layered(layers) => {
            // Before version 3.2 a layer's filter let light through unchanged (docs/spec/language.md 2.11).
            let old = vm.version <= 310;
            layers.extend(added.iter().map(|layer| {
                let mut layer = layer.clone();
                if old {
                    layer.paint.change(|pigment| Arc::make_mut(pigment).filter_to_transmit());
                }
                layer
            }));
            Ok(())
        }
        _ => Err(unlayerable(vm, place)),
    }
}

fn unlayerable(vm: &Vm<'_>, place: Span) -> crate::interp::Fault {
    vm.error(place, "a texture with a pattern cannot be layered")
        .help("put the layers into the entries of its `texture_map`, or into its list")
}

/// Bakes the transform of the objects around a texture into its body: what is added later is not moved by it.
fn settle(texture: &mut Texture) {
    if let Some(by) = texture.transform.take() {
        super::apply(texture, &by);
    }
}

/// The top layer of a plain texture, to be changed.
pub(super) fn top<'t>(vm: &Vm<'_>, texture: &'t mut Texture) -> Result<&'t mut Layer> {
    settle(texture);
    let fault = vm.error(vm.last, "a texture with a pattern has no layer to change");
    match Arc::make_mut(&mut texture.body) {
        TextureBody::Layered(layers) => layers.last_mut().ok_or(fault),
        _ => Err(fault),
    }
}

/// Reads `pigment`, `normal` or `finish` of an object: it makes or changes the top layer of its texture.
pub(in crate::interp::statement) fn part(vm: &mut Vm<'_>, texture: &mut Option<Texture>) -> Result<()> {
    let keyword = vm.peek()?;
    let default = |vm: &Vm<'_>| match &*vm.state.texture.body {
        TextureBody::Layered(layers) => layers.last().cloned(),
        _ => None,
    };
    let plain = texture.as_ref().is_some_and(|texture| matches!(&*texture.body, TextureBody::Layered(_)));
    if !plain {
        if texture.is_some() {
            return Err(unlayerable(vm, keyword.span));
        }
        // The common case: one layer that shares all but one part with the default.
        let Some(mut layer) = default(vm) else { return Err(vm.expected("`texture`")) };
        layer.span = keyword.span;
        read_part(vm, &mut layer)?;
        *texture = Some(layer.into());
        return Ok(());
    }
    match texture {
        Some(texture) => read_part(vm, top(vm, texture)?),
        None => Ok(()),
    }
}

/// Reads one part into a layer.
fn read_part(vm: &mut Vm<'_>, layer: &mut Layer) -> Result<()> {
    match vm.peek_word()? {
        Some(Word::Pigment) => layer.paint = pigment::block(vm, &layer.paint.pigment())?.into(),
        Some(Word::Normal) => layer.normal = Some(normal::block(vm, layer.normal.as_ref())?),
        _ => layer.finish = finish::block(vm, &layer.finish)?,
    }
    Ok(())
}

/// Takes the name of a pigment, normal or finish inside `texture { … }`.
pub(super) fn variable(vm: &mut Vm<'_>, texture: &mut Texture) -> Result<bool> {
    let part = vm.accept_value(|value| match value {
        Value::Pigment(_) | Value::Normal(_) | Value::Finish(_) => Some(value.clone()),
        _ => None,
    })?;
    let Some(part) = part else { return Ok(false) };
    let top = top(vm, texture)?;
    match part {
        Value::Pigment(pigment) => top.paint = pigment.into(),
        Value::Normal(normal) => top.normal = Some(normal),
        Value::Finish(finish) => top.finish = finish,
        _ => {}
    }
    Ok(true)
}
