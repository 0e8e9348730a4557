//! `interior { … }` (docs/spec/language.md 6.14).

use std::sync::Arc;

use super::{color, media};
use crate::interp::limits::MOST_COLORS;
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::scene::Interior;

/// Reads `interior { … }`, whose keyword comes next, as a changed copy of what is there.
pub(in crate::interp) fn block(vm: &mut Vm<'_>, base: Option<Arc<Interior>>) -> Result<Arc<Interior>> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::Interior(interior) => Some(Arc::clone(interior)),
        _ => None,
    })?;
    let mut shared = named.or(base).unwrap_or_default();
    if vm.peek_word()?.is_some() {
        let interior = Arc::make_mut(&mut shared);
        while let Some(word) = vm.peek_word()? {
            if !item(vm, interior, word)? {
                break;
            }
        }
    }
    vm.close(block)?;
    Ok(shared)
}

fn item(vm: &mut Vm<'_>, interior: &mut Interior, word: Word) -> Result<bool> {
    match word {
        Word::Ior => interior.ior = Some(vm.after_word(Vm::read_float)? as f32),
        Word::Dispersion => interior.dispersion = vm.after_word(Vm::read_float)? as f32,
        Word::DispersionSamples => {
            vm.next()?;
            let (samples, place) = vm.located(|vm| vm.read_at_most("dispersion_samples", MOST_COLORS))?;
            if samples < 2 {
                return Err(vm.error(place, "light is split into at least 2 colors"));
            }
            interior.dispersion_samples = samples as u32;
        }
        Word::Caustics => interior.caustics = vm.after_word(Vm::read_float)? as f32,
        Word::FadeColor | Word::FadeColour => interior.fade_color = vm.after_word(color::rgb)?,
        Word::FadeDistance => interior.fade_distance = vm.after_word(Vm::read_float)? as f32,
        Word::FadePower => interior.fade_power = vm.after_word(Vm::read_float)? as f32,
        Word::Media => interior.media.push(media::block(vm)?),
        Word::Refraction => {
            let place = vm.next()?.span;
            interior.refraction = Some(vm.read_float()? as f32);
            vm.warn(place, "`refraction` has no effect any more", "write `ior`");
        }
        _ => return Ok(false),
    }
    Ok(true)
}
