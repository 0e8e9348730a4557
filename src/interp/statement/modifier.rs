//! What may follow the parameters of an object (docs/spec/language.md 6.7).

use std::sync::Arc;

use super::{bounds, color, interior, material, object, photons, texture, transform};
use crate::interp::{Fault, Result, Vm, Word};
use crate::scene::object::{ObjectExtra, ObjectFlags};
use crate::scene::shape::CsgOperation;
use crate::scene::{Object, Shape};

/// Reads one modifier, if one comes next.
pub(super) fn read(vm: &mut Vm<'_>, object: &mut Object) -> Result<bool> {
    if vm.peek_word()?.is_none() {
        return Ok(false);
    }
    Ok(place(vm, object)? || surface(vm, object)? || flag(vm, object)? || block(vm, object)?)
}

/// Reads a transform: it moves the object and everything given so far.
pub(super) fn place(vm: &mut Vm<'_>, object: &mut Object) -> Result<bool> {
    match transform::item(vm)? {
        Some(by) => {
            object.apply(&by);
            Ok(true)
        }
        None => Ok(false),
    }
}

/// Reads a texture or a part of one.
pub(super) fn surface(vm: &mut Vm<'_>, object: &mut Object) -> Result<bool> {
    let Some(word) = vm.peek_word()? else { return Ok(false) };
    match word {
        Word::Texture => {
            let place = vm.here()?;
            let over = texture::block(vm)?;
            texture::layer(vm, &mut object.texture, over, place)?;
        }
        Word::Pigment | Word::Normal | Word::Finish => {
            texture::part(vm, &mut object.texture)?;
        }
        Word::UvMapping => {
            let place = vm.next()?.span;
            if object.texture.is_some() {
                return Err(vm.error(place, "`uv_mapping` comes after the texture of this object").help(
                    "write `uv_mapping` before the texture, or inside it: `texture { uv_mapping … }`",
                ));
            }
            object.flags |= ObjectFlags::UV_MAPPING;
        }
        _ if color::starts(word) => {
            let ((), place) = vm.located(|vm| color::rgbft(vm).map(drop))?;
            vm.warn(place, "a color by itself does nothing here", "write `pigment { … }` around it");
        }
        _ => return Ok(false),
    }
    if object.texture.is_some() {
        object.flags |= ObjectFlags::TEXTURED;
    }
    Ok(true)
}

/// Reads an on/off modifier.
fn flag(vm: &mut Vm<'_>, object: &mut Object) -> Result<bool> {
    let Some(word) = vm.peek_word()? else { return Ok(false) };
    let flag = match word {
        Word::Hollow => ObjectFlags::HOLLOW,
        Word::Inverse => ObjectFlags::INVERSE,
        Word::NoShadow => ObjectFlags::NO_SHADOW,
        Word::NoImage => ObjectFlags::NO_IMAGE,
        Word::NoReflection => ObjectFlags::NO_REFLECTION,
        Word::NoRadiosity => ObjectFlags::NO_RADIOSITY,
        Word::DoubleIlluminate => ObjectFlags::DOUBLE_ILLUMINATE,
        Word::Sturm => ObjectFlags::STURM,
        Word::Hierarchy => ObjectFlags::HIERARCHY,
        Word::CutawayTextures => ObjectFlags::CUTAWAY_TEXTURES,
        Word::SplitUnion => {
            let place = vm.next()?.span;
            let on = vm.read_flag()?;
            match &mut object.shape {
                Shape::Csg(csg) if matches!(csg.operation, CsgOperation::Union | CsgOperation::Merge) => {
                    Arc::make_mut(csg).split_union = on
                }
                _ => return Err(unfit(vm, word, place, "a `union`")),
            }
            return Ok(true);
        }
        _ => return Ok(false),
    };
    let place = vm.next()?.span;
    match word {
        Word::Inverse => {
            object.flags.toggle(flag);
            if object::is_patch(&object.shape) {
                let help = "`inverse` exchanges inside and outside of solids";
                vm.warn(place, "this object has no inside to exchange with its outside", help);
            }
        }
        Word::NoShadow => object.flags |= flag,
        Word::CutawayTextures => {
            let cuts = |csg: &crate::scene::shape::Csg| {
                matches!(csg.operation, CsgOperation::Intersection | CsgOperation::Difference)
            };
            if !matches!(&object.shape, Shape::Csg(csg) if cuts(csg)) {
                return Err(unfit(vm, word, place, "an `intersection` or `difference`"));
            }
            object.flags |= flag;
        }
        Word::Sturm if !takes_sturm(&object.shape) => {
            let who = "a `torus`, `poly`, `blob`, `lathe`, `sor`, `prism` or `ovus`";
            return Err(unfit(vm, word, place, who));
        }
        Word::Hierarchy
            if !matches!(object.shape, Shape::Blob(_) | Shape::Mesh(_) | Shape::HeightField(_)) =>
        {
            return Err(unfit(vm, word, place, "a `blob`, `mesh` or `height_field`"));
        }
        _ => {
            let on = vm.read_flag()?;
            object.flags.set(flag, on);
            match word {
                Word::Hollow => object.flags |= ObjectFlags::HOLLOW_SET,
                Word::DoubleIlluminate => object.flags |= ObjectFlags::DOUBLE_ILLUMINATE_SET,
                _ => {}
            }
        }
    }
    Ok(true)
}

fn takes_sturm(shape: &Shape) -> bool {
    use Shape::*;
    matches!(shape, Torus { .. } | Poly(_) | Blob(_) | Lathe(_) | Sor(_) | Prism(_) | Ovus { .. })
}

fn unfit(vm: &Vm<'_>, word: Word, place: crate::source::Span, who: &str) -> Fault {
    let word = word.text();
    vm.error(place, format!("`{word}` means nothing to this object")).help(format!("only {who} has `{word}`"))
}

/// Reads a modifier with braces, or with a value.
fn block(vm: &mut Vm<'_>, object: &mut Object) -> Result<bool> {
    let Some(word) = vm.peek_word()? else { return Ok(false) };
    match word {
        Word::InteriorTexture => {
            let place = vm.here()?;
            let over = texture::block(vm)?;
            texture::layer(vm, &mut extra(object).interior_texture, over, place)?;
        }
        Word::Material => material::modifier(vm, object)?,
        Word::Interior => {
            let base = object.interior().cloned();
            let interior = interior::block(vm, base)?;
            extra(object).interior = Some(interior);
        }
        Word::Photons => photons::of_object(vm, &mut extra(object).photons)?,
        Word::Radiosity => {
            extra(object).radiosity_importance = Some(importance(vm)?);
        }
        Word::BoundedBy | Word::ClippedBy => bounds::read(vm, object)?,
        Word::Dtag => {
            vm.next()?;
            vm.read_string()?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// Reads `radiosity { importance F }`; its keyword comes next.
pub(super) fn importance(vm: &mut Vm<'_>) -> Result<f64> {
    let block = vm.enter()?;
    if !vm.accept(Word::Importance)? {
        vm.close(block)?;
        return Ok(1.0);
    }
    let (importance, place) = vm.located(Vm::read_float)?;
    if !(importance > 0.0 && importance <= 1.0) {
        return Err(vm.error(place, "`importance` lies above 0 and is at most 1"));
    }
    vm.close(block)?;
    Ok(importance)
}

/// The rare modifiers of an object, made on first use.
pub(super) fn extra(object: &mut Object) -> &mut ObjectExtra {
    object.extra.get_or_insert_default()
}

/// Checks what has to be there when the statement of an object ends.
pub(super) fn check(vm: &Vm<'_>, object: &Object) -> Result<()> {
    let half = object.texture.is_none()
        && object.extra.as_ref().is_some_and(|extra| extra.interior_texture.is_some());
    if half {
        return Err(vm
            .error(object.span, "this object has an `interior_texture` but no `texture`")
            .help("give it a `texture { … }` too"));
    }
    Ok(())
}
