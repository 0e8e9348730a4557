//! Textures before version 3.0: the words of pigment, normal and finish stand in them directly, in any
//! order (docs/spec/language.md 6.8).

use std::sync::Arc;

use super::super::pattern::{self, Owner};
use super::super::{finish, normal, pigment};
use super::layers;
use crate::interp::{Result, Vm, Word};
use crate::scene::Texture;

/// The version with which `pigment`, `normal` and `finish` came.
const FIRST_WITH_BLOCKS: i32 = 300;

/// Whether textures are written this way.
pub(super) fn applies(vm: &Vm<'_>) -> bool {
    vm.version < FIRST_WITH_BLOCKS
}

/// Reads the number such a texture may begin with: how grainy it is.
pub(super) fn grain(vm: &mut Vm<'_>, texture: &mut Texture) -> Result<()> {
    if !applies(vm) || !vm.at_number()? || vm.at_color()? {
        return Ok(());
    }
    let (crand, place) = vm.located(Vm::read_float)?;
    if vm.version >= 150 {
        vm.warn(place, "a number at the start of a texture is its `crand`", "write `crand` before it");
    }
    let crand = crand as f32;
    let top = layers::top(vm, texture)?;
    Arc::make_mut(&mut top.finish).crand = crand;
    Ok(())
}

/// Reads one item, if one comes next. Turbulence is the pigment's, frequency and phase are the normal's.
pub(super) fn item(vm: &mut Vm<'_>, texture: &mut Texture) -> Result<bool> {
    if !applies(vm) {
        return Ok(false);
    }
    let top = layers::top(vm, texture)?;
    match vm.peek_word()? {
        Some(Word::Bumps | Word::Dents | Word::Ripples | Word::Waves | Word::Wrinkles | Word::BumpMap) => {
            normal::start(vm, &mut top.normal)
        }
        Some(Word::Frequency | Word::Phase) if top.normal.is_some() => normal::modifier(vm, &mut top.normal),
        Some(Word::BumpSize | Word::SlopeMap | Word::NormalMap) => normal::modifier(vm, &mut top.normal),
        // What begins the next statement of an object is no item.
        Some(word) if pattern::is_modifier(word) || is_pigment(word) => {
            top.paint.change(|pigment| pigment::modifier(vm, pigment, Owner::Pigment, true))
        }
        _ => Ok(finish::free_item(vm, &mut top.finish)?
            || top.paint.change(|pigment| pigment::start(vm, pigment, Owner::Pigment))?),
    }
}

fn is_pigment(word: Word) -> bool {
    use Word::*;
    matches!(word, ColorMap | ColourMap | PigmentMap | QuickColor | QuickColour)
}
