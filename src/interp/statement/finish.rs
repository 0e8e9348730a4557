//! `finish { … }` (docs/spec/language.md 6.13, docs/spec/shading.md 9 and 21).

use std::sync::Arc;

use super::color;
use crate::interp::value::Value;
use crate::interp::{Experimental, Result, Vm, Word};
use crate::math::Rgb;
use crate::scene::Finish;
use crate::scene::texture::{Irid, LegacyFinish, Reflection, Subsurface};

/// Which strengths were written as albedo.
#[derive(Default)]
struct Albedo {
    diffuse: bool,
    phong: bool,
    specular: bool,
}

/// Reads `finish { … }`, whose keyword comes next, as a changed copy of `base`.
pub(in crate::interp) fn block(vm: &mut Vm<'_>, base: &Arc<Finish>) -> Result<Arc<Finish>> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::Finish(finish) => Some(Arc::clone(finish)),
        _ => None,
    })?;
    let mut shared = named.unwrap_or_else(|| Arc::clone(base));
    if vm.peek_word()?.is_some() {
        let finish = Arc::make_mut(&mut shared);
        let mut albedo = Albedo::default();
        while let Some(word) = vm.peek_word()? {
            if !item(vm, finish, &mut albedo, word)? {
                break;
            }
        }
        scale(finish, &albedo);
        // Loops make many alike, which then share one.
        match &vm.state.last_finish {
            Some(last) if *last == shared => shared.clone_from(last),
            _ => vm.state.last_finish = Some(Arc::clone(&shared)),
        }
    }
    vm.close(block)?;
    Ok(shared)
}

/// Reads one item outside of a `finish`, if one comes next.
pub(super) fn free_item(vm: &mut Vm<'_>, finish: &mut Arc<Finish>) -> Result<bool> {
    let Some(word) = vm.peek_word()? else { return Ok(false) };
    let (mut changed, mut albedo) = (Finish::clone(finish), Albedo::default());
    let found = item(vm, &mut changed, &mut albedo, word)?;
    if found {
        scale(&mut changed, &albedo);
        *finish = Arc::new(changed);
    }
    Ok(found)
}

fn item(vm: &mut Vm<'_>, finish: &mut Finish, albedo: &mut Albedo, word: Word) -> Result<bool> {
    match word {
        Word::Ambient => finish.ambient = vm.after_word(color::rgb)?,
        Word::Emission => finish.emission = vm.after_word(color::rgb)?,
        Word::Diffuse => {
            vm.next()?;
            albedo.diffuse = vm.accept(Word::Albedo)?;
            finish.diffuse = single(vm)?;
            vm.comma()?;
            if vm.at_number()? {
                finish.diffuse_back = single(vm)?;
            }
            if finish.diffuse_back != 0.0 {
                vm.note_experimental(Experimental::Backside);
            }
            finish.raw_diffuse = [finish.diffuse, finish.diffuse_back];
        }
        Word::Brilliance => finish.brilliance = vm.after_word(single)?,
        Word::Phong => {
            vm.next()?;
            albedo.phong = vm.accept(Word::Albedo)?;
            finish.phong = single(vm)?;
        }
        Word::PhongSize => finish.phong_size = vm.after_word(single)?,
        Word::Specular => {
            vm.next()?;
            albedo.specular = vm.accept(Word::Albedo)?;
            finish.specular = single(vm)?;
        }
        Word::Roughness => {
            vm.next()?;
            let (roughness, place) = vm.located(single)?;
            finish.roughness = roughness;
            if roughness == 0.0 {
                vm.warn(place, "a roughness of 0 has no highlight", "use a small number such as 0.001");
            }
        }
        Word::Metallic => finish.metallic = vm.after_word(switch)?,
        Word::Crand => finish.crand = vm.after_word(single)?,
        Word::ConserveEnergy => {
            vm.next()?;
            finish.conserve_energy = true;
        }
        Word::Reflection => reflection(vm, &mut finish.reflection)?,
        Word::ReflectionExponent => finish.reflection.exponent = vm.after_word(single)?,
        Word::Irid => finish.irid = Some(irid(vm)?),
        Word::Subsurface => {
            vm.note_experimental(Experimental::Subsurface);
            finish.subsurface = Some(subsurface(vm)?);
        }
        Word::Ior | Word::Refraction | Word::Caustics => {
            legacy(vm, &mut finish.legacy, word)?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

fn single(vm: &mut Vm<'_>) -> Result<f32> {
    Ok(vm.read_float()? as f32)
}

/// Reads a strength that is 1 where it is left out.
fn switch(vm: &mut Vm<'_>) -> Result<f32> {
    if vm.at_number()? { single(vm) } else { Ok(1.0) }
}

/// Works `albedo` in, once everything it depends on is known.
fn scale(finish: &mut Finish, albedo: &Albedo) {
    if albedo.diffuse {
        let factor = (finish.brilliance + 1.0) / 2.0;
        finish.diffuse *= factor;
        finish.diffuse_back *= factor;
    }
    if albedo.phong {
        finish.phong *= (finish.phong_size + 1.0) / 2.0;
    }
    if albedo.specular {
        let r = 1.0 / finish.roughness;
        finish.specular *= (r + 2.0) / (4.0 * (2.0 - (-r / 2.0).exp2()));
    }
}

/// Reads `reflection C` or `reflection { C [C] … }`.
fn reflection(vm: &mut Vm<'_>, reflection: &mut Reflection) -> Result<()> {
    use crate::interp::stream::TokenKind;
    let keyword = vm.next()?;
    if vm.peek()?.kind != TokenKind::Punct(crate::syntax::Punct::OpenBrace) {
        reflection.max = color::rgb(vm)?;
        reflection.min = reflection.max;
        return Ok(());
    }
    let block = vm.open(keyword)?;
    if vm.at_color()? || vm.at_number()? {
        reflection.max = color::rgb(vm)?;
    }
    reflection.min = reflection.max;
    vm.comma()?;
    let two = vm.at_color()? || vm.at_number()?;
    if two {
        reflection.max = color::rgb(vm)?;
    }
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Fresnel => {
                vm.next()?;
                reflection.fresnel = fresnel(vm)?;
            }
            Word::Falloff => reflection.falloff = vm.after_word(single)?,
            Word::Exponent => reflection.exponent = vm.after_word(single)?,
            Word::Metallic => reflection.metallic = vm.after_word(switch)?,
            _ => break,
        }
    }
    vm.close(block)?;
    if reflection.fresnel && !two {
        reflection.min = Rgb::ZERO;
    }
    Ok(())
}

/// Reads 0 or 1, cut to an integer.
fn fresnel(vm: &mut Vm<'_>) -> Result<bool> {
    if !vm.at_number()? {
        return Ok(true);
    }
    let (value, place) = vm.located(Vm::read_int)?;
    if !(0..=1).contains(&value) {
        return Err(vm.error(place, format!("`fresnel` is on or off, not {value}")));
    }
    Ok(value == 1)
}

fn irid(vm: &mut Vm<'_>) -> Result<Irid> {
    let block = vm.enter()?;
    let mut irid = Irid { amount: single(vm)?, thickness: 0.0, turbulence: 0.0 };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Thickness => irid.thickness = vm.after_word(single)?,
            Word::Turbulence => irid.turbulence = vm.after_word(single)?,
            _ => break,
        }
    }
    vm.close(block)?;
    Ok(irid)
}

fn subsurface(vm: &mut Vm<'_>) -> Result<Subsurface> {
    let block = vm.enter()?;
    let mut subsurface = Subsurface { translucency: Rgb::ZERO, anisotropy: Rgb::ZERO };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Translucency => subsurface.translucency = vm.after_word(color::rgb)?,
            Word::Anisotropy => subsurface.anisotropy = vm.after_word(color::rgb)?,
            _ => break,
        }
    }
    vm.close(block)?;
    Ok(subsurface)
}

/// Reads what belongs into an interior since version 3.1.
fn legacy(vm: &mut Vm<'_>, legacy: &mut LegacyFinish, word: Word) -> Result<()> {
    let place = vm.next()?.span;
    if vm.version >= 310 {
        let message = format!("`{}` is a matter of the interior", word.text());
        vm.deprecated(place, message, "move it to `interior { … }`");
    }
    let value = Some(if word == Word::Refraction { switch(vm)? } else { single(vm)? });
    match word {
        Word::Ior => legacy.ior = value,
        Word::Refraction => legacy.refraction = value,
        _ => legacy.caustics = value,
    }
    Ok(())
}
