//! `global_settings { photons { … } }` (docs/spec/atmosphere-gi.md 4.1).

use crate::interp::{Result, Vm, Word};
use crate::scene::settings::PhotonSettings;

/// Reads the block; its keyword comes next. Opened again it starts from the defaults.
pub(super) fn block(vm: &mut Vm<'_>) -> Result<PhotonSettings> {
    let block = vm.enter()?;
    let mut settings = PhotonSettings { span: block.span, ..PhotonSettings::default() };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Spacing => settings.spacing = vm.after_word(Vm::read_float)? as f32,
            Word::Count => settings.count = Some(vm.after_word(Vm::read_count)?),
            Word::Gather => {
                vm.next()?;
                let (least, place) = vm.located(Vm::read_count)?;
                vm.comma()?;
                let most = vm.read_count()?;
                if least > most {
                    return Err(
                        vm.error(place.to(vm.last), "the least photons to gather are more than the most")
                    );
                }
                settings.gather = [least, most];
            }
            Word::Radius => {
                vm.next()?;
                for value in &mut settings.radius {
                    if !vm.at_number()? {
                        break;
                    }
                    *value = vm.read_float()? as f32;
                    vm.comma()?;
                }
            }
            Word::Jitter => settings.jitter = vm.after_word(Vm::read_float)? as f32,
            Word::ExpandThresholds => {
                vm.next()?;
                let (tolerance, place) = vm.located(Vm::read_float)?;
                vm.comma()?;
                let least = vm.read_int()?;
                if tolerance < 0.0 || least < 0 {
                    vm.warn(place.to(vm.last), "`expand_thresholds` cannot be negative", "0 is taken");
                }
                settings.expand_tolerance = tolerance.max(0.0) as f32;
                settings.expand_minimum = least.max(0) as u32;
            }
            Word::Autostop => settings.autostop = vm.after_word(Vm::read_float)? as f32,
            Word::AdcBailout => settings.adc_bailout = Some(vm.after_word(Vm::read_float)? as f32),
            Word::MaxTraceLevel => settings.max_trace_level = Some(vm.after_word(Vm::read_count)?),
            Word::Media => {
                settings.media_steps = vm.after_word(Vm::read_count)?;
                vm.comma()?;
                if vm.at_number()? {
                    let (factor, place) = vm.located(Vm::read_float)?;
                    if factor <= 0.0 {
                        return Err(vm.error(place, "the factor of `media` has to be above 0"));
                    }
                    settings.media_factor = factor as f32;
                }
            }
            Word::LoadFile | Word::SaveFile => {
                vm.next()?;
                let name = vm.read_string()?.to_string();
                (settings.load_file, settings.save_file) = match word {
                    Word::LoadFile => (Some(name), None),
                    _ => (None, Some(name)),
                };
            }
            _ => break,
        }
    }
    vm.close(block)?;
    Ok(settings)
}
