//! `photons { … }` of objects and lights (docs/spec/atmosphere-gi.md 4.2).

use crate::interp::{Result, Vm, Word};
use crate::scene::light::LightPhotons;
use crate::scene::object::PhotonFlags;

/// Reads the block of an object.
pub(super) fn of_object(vm: &mut Vm<'_>, photons: &mut Option<PhotonFlags>) -> Result<()> {
    let block = vm.enter()?;
    let flags = photons.get_or_insert_default();
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Target => {
                vm.next()?;
                let density = if vm.at_number()? { vm.read_float()? } else { 1.0 };
                flags.target = (density > 0.0).then_some(density);
            }
            Word::Refraction => flags.refraction = Some(vm.after_word(Vm::read_float)? > 0.0),
            Word::Reflection => flags.reflection = Some(vm.after_word(Vm::read_float)? > 0.0),
            Word::PassThrough => flags.pass_through = vm.after_word(Vm::read_flag)?,
            Word::Collect => flags.ignore_photons = !vm.after_word(Vm::read_flag)?,
            _ => break,
        }
        // What is aimed at and refracts cannot be passed through: the last one written wins.
        let conflict = flags.pass_through && flags.target.is_some() && flags.refraction != Some(false);
        if conflict && matches!(word, Word::PassThrough | Word::Target | Word::Refraction) {
            let keeps_pass_through =
                word == Word::PassThrough || (word == Word::Target && flags.refraction != Some(true));
            if keeps_pass_through {
                flags.refraction = Some(false);
            } else {
                flags.pass_through = false;
            }
            vm.warn(
                block.span,
                "a target of photons cannot both refract and pass them through",
                if keeps_pass_through {
                    "`refraction` is turned off"
                } else {
                    "`pass_through` is turned off"
                },
            );
        }
    }
    vm.close(block)?;
    Ok(())
}

/// Reads the block of a light or a light group.
pub(super) fn of_light(vm: &mut Vm<'_>) -> Result<LightPhotons> {
    let block = vm.enter()?;
    let mut photons = LightPhotons::default();
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Refraction => photons.refraction = Some(vm.after_word(Vm::read_float)? > 0.0),
            Word::Reflection => photons.reflection = Some(vm.after_word(Vm::read_float)? > 0.0),
            Word::AreaLight => {
                vm.next()?;
                photons.area_light = true;
            }
            _ => break,
        }
    }
    vm.close(block)?;
    Ok(photons)
}
