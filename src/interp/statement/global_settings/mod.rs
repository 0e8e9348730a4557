//! `global_settings { … }` (docs/spec/language.md 6.16).

mod photons;
mod radiosity;

use super::color;
use crate::interp::{Charset, Experimental, Result, Vm, Word};
use crate::math::Gamma;
use crate::scene::settings::SubsurfaceSettings;

/// Reads the block; its keyword comes next. It may be repeated.
pub(super) fn block(vm: &mut Vm<'_>) -> Result<()> {
    let block = vm.enter()?;
    while let Some(word) = vm.peek_word()? {
        if !item(vm, word)? {
            break;
        }
    }
    vm.close(block)?;
    Ok(())
}

fn item(vm: &mut Vm<'_>, word: Word) -> Result<bool> {
    match word {
        Word::AdcBailout => vm.state.settings.adc_bailout = vm.after_word(Vm::read_float)? as f32,
        Word::AmbientLight => vm.state.settings.ambient_light = vm.after_word(color::rgb)?,
        Word::AssumedGamma => assumed_gamma(vm)?,
        Word::Charset => charset(vm)?,
        Word::IridWavelength => vm.state.settings.irid_wavelength = vm.after_word(color::rgb)?,
        Word::MaxTraceLevel => {
            vm.next()?;
            vm.state.settings.max_trace_level = max_trace_level(vm)?;
        }
        Word::MaxIntersections => {
            let place = vm.next()?.span;
            vm.read_int()?;
            vm.deprecated(place, "`max_intersections` has no effect", "leave it out");
        }
        Word::NumberOfWaves => {
            vm.next()?;
            let (number, place) = vm.located(Vm::read_int)?;
            if number < 1 {
                vm.warn(place, "`number_of_waves` is at least 1", "1 is taken");
            }
            vm.state.settings.number_of_waves = number.max(1) as u32;
        }
        Word::NoiseGenerator => {
            vm.next()?;
            let (number, place) = vm.located(Vm::read_int)?;
            if !(1..=3).contains(&number) {
                return Err(vm
                    .error(place, format!("there is no noise generator {number}"))
                    .help("they are numbered 1 to 3"));
            }
            vm.state.settings.noise_generator = number as u8;
            vm.state.has_noise_generator = true;
        }
        Word::MmPerUnit => vm.state.settings.mm_per_unit = vm.after_word(Vm::read_float)? as f32,
        Word::HfGray16 => {
            let place = vm.next()?.span;
            vm.read_flag()?;
            vm.possible(
                place,
                "`hf_gray_16` has no effect",
                "ask for a grey picture on the command line: `+FNg16`",
            );
        }
        Word::Subsurface => {
            vm.note_experimental(Experimental::Subsurface);
            subsurface(vm)?;
        }
        Word::Photons => vm.state.settings.photons = Some(photons::block(vm)?),
        Word::Radiosity => radiosity::block(vm)?,
        _ => return Ok(false),
    }
    Ok(true)
}

/// Reads the deepest level of the ray tree, which has a limit.
pub(super) fn max_trace_level(vm: &mut Vm<'_>) -> Result<u32> {
    const MOST: i32 = 256;
    let (level, place) = vm.located(Vm::read_int)?;
    if level > MOST {
        vm.warn(place, format!("`max_trace_level` is at most {MOST}"), "256 is taken");
    }
    Ok(level.clamp(1, MOST) as u32)
}

fn assumed_gamma(vm: &mut Vm<'_>) -> Result<()> {
    let keyword = vm.next()?.span;
    let gamma = if vm.accept(Word::Srgb)? {
        Gamma::Srgb
    } else {
        let (gamma, place) = vm.located(Vm::read_float)?;
        if gamma <= 0.0 {
            return Err(vm
                .error(place, "`assumed_gamma` has to be above 0")
                .help("1 is the physically sensible value"));
        }
        if gamma < 1.0 {
            vm.possible(place, "an `assumed_gamma` below 1 is unusual", "1 is the physically sensible value");
        }
        Gamma::Power(gamma as f32)
    };
    if vm.state.settings.assumed_gamma.is_some() {
        vm.warn(keyword, "`assumed_gamma` was set before", "the first value counts");
        return Ok(());
    }
    vm.state.settings.assumed_gamma = Some(gamma);
    vm.gamma = Some(gamma);
    Ok(())
}

fn charset(vm: &mut Vm<'_>) -> Result<()> {
    vm.next()?;
    vm.charset = match vm.peek_word()? {
        Some(Word::Ascii) => Charset::Ascii,
        Some(Word::Utf8) => Charset::Utf8,
        Some(Word::Sys) => Charset::Sys,
        _ => return Err(vm.expected("`ascii`, `utf8` or `sys`")),
    };
    vm.next()?;
    Ok(())
}

fn subsurface(vm: &mut Vm<'_>) -> Result<()> {
    let block = vm.enter()?;
    let settings = vm.state.settings.subsurface;
    let fresh = SubsurfaceSettings { span: block.span, samples: [50, 50], radiosity: false };
    let mut settings = SubsurfaceSettings { span: block.span, ..settings.unwrap_or(fresh) };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Samples => {
                settings.samples[0] = vm.after_word(Vm::read_count)?;
                vm.comma()?;
                settings.samples[1] = vm.read_count()?;
            }
            Word::Radiosity => settings.radiosity = vm.after_word(Vm::read_flag)?,
            _ => break,
        }
    }
    vm.close(block)?;
    vm.state.settings.subsurface = Some(settings);
    Ok(())
}
