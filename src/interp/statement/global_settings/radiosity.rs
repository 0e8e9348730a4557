//! `global_settings { radiosity { … } }` (docs/spec/atmosphere-gi.md 3.1).

use crate::interp::{Result, Vm, Word};
use crate::scene::settings::RadiositySettings;

/// Reads the block; its keyword comes next.
pub(super) fn block(vm: &mut Vm<'_>) -> Result<()> {
    let block = vm.enter()?;
    let mut settings = vm.state.settings.radiosity.clone().unwrap_or_default();
    let (mut least, mut most) = (false, false);
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::MinimumReuse => least = true,
            Word::MaximumReuse => most = true,
            _ => {}
        }
        if !item(vm, &mut settings, word)? {
            break;
        }
    }
    vm.close(block)?;
    settings.span = block.span;
    if settings.pretrace_end > settings.pretrace_start {
        return Err(vm.error(block.span, "`pretrace_end` is at most `pretrace_start`"));
    }
    if settings.minimum_reuse > settings.maximum_reuse / 2.0 {
        match (least, most) {
            (false, true) => settings.minimum_reuse = settings.maximum_reuse / 2.0,
            (true, false) => settings.maximum_reuse = settings.minimum_reuse * 2.0,
            _ if settings.minimum_reuse >= settings.maximum_reuse => {
                return Err(vm.error(block.span, "`minimum_reuse` has to be below `maximum_reuse`"));
            }
            _ => vm.warn(block.span, "`minimum_reuse` is above half of `maximum_reuse`", "lower it"),
        }
    }
    vm.state.settings.radiosity = Some(settings);
    Ok(())
}

fn item(vm: &mut Vm<'_>, settings: &mut RadiositySettings, word: Word) -> Result<bool> {
    let positive = "it has to be above 0";
    match word {
        Word::AdcBailout => settings.adc_bailout = checked(vm, positive, |v| v > 0.0)?,
        Word::AlwaysSample => settings.always_sample = vm.after_word(Vm::read_flag)?,
        Word::Brightness => settings.brightness = checked(vm, positive, |v| v > 0.0)?,
        Word::Count => {
            settings.count = whole(vm, "it is at least 1", |n| n >= 1)?;
            settings.direction_pool = settings.count.max(1600);
            vm.comma()?;
            if vm.at_number()? {
                let (pool, place) = vm.located(Vm::read_count)?;
                if pool < settings.count {
                    return Err(vm.error(place, "the directions to choose from are fewer than those used"));
                }
                settings.direction_pool = pool;
            }
        }
        Word::ErrorBound => settings.error_bound = checked(vm, positive, |v| v > 0.0)?,
        Word::GrayThreshold => {
            settings.gray_threshold = checked(vm, "it is 0 to 1", |v| (0.0..=1.0).contains(&v))?
        }
        Word::LowErrorFactor => settings.low_error_factor = checked(vm, positive, |v| v > 0.0)?,
        Word::MaxSample => settings.max_sample = vm.after_word(Vm::read_float)? as f32,
        Word::MaximumReuse => settings.maximum_reuse = checked(vm, positive, |v| v > 0.0)?,
        Word::MinimumReuse => settings.minimum_reuse = checked(vm, "it cannot be negative", |v| v >= 0.0)?,
        Word::Media => settings.media = vm.after_word(Vm::read_flag)?,
        Word::NearestCount => {
            settings.nearest_count = whole(vm, "it is 1 to 20", |n| (1..=20).contains(&n))?;
            vm.comma()?;
            if vm.at_number()? {
                let (adaptive, place) = vm.located(Vm::read_count)?;
                if adaptive >= settings.nearest_count {
                    return Err(
                        vm.error(place, "the second number of `nearest_count` has to be below the first")
                    );
                }
                settings.adaptive_count = adaptive;
            }
        }
        Word::Normal => settings.normal = vm.after_word(Vm::read_flag)?,
        Word::PretraceStart => {
            settings.pretrace_start = checked(vm, "it lies above 0 and is at most 1", share)?
        }
        Word::PretraceEnd => settings.pretrace_end = checked(vm, "it lies above 0 and is at most 1", share)?,
        Word::RecursionLimit => {
            settings.recursion_limit = whole(vm, "it is 1 to 20", |n| (1..=20).contains(&n))?
        }
        Word::Subsurface => settings.subsurface = vm.after_word(Vm::read_flag)?,
        Word::LoadFile | Word::SaveFile => {
            let place = vm.next()?.span;
            vm.read_string()?;
            let message = format!("`{}` has no effect here", word.text());
            vm.possible(place, message, "files of radiosity samples are set on the command line");
        }
        _ => return Ok(false),
    }
    Ok(true)
}

fn share(value: f64) -> bool {
    value > 0.0 && value <= 1.0
}

/// Reads the value of a setting that is refused unless `allowed`.
fn checked(vm: &mut Vm<'_>, rule: &str, allowed: impl Fn(f64) -> bool) -> Result<f32> {
    let keyword = vm.next()?.span;
    let (value, place) = vm.located(Vm::read_float)?;
    if allowed(value) {
        return Ok(value as f32);
    }
    let word = vm.sources.text(keyword).to_owned();
    Err(vm.error(place, format!("`{word}` cannot be {value}")).help(rule))
}

fn whole(vm: &mut Vm<'_>, rule: &str, allowed: impl Fn(u32) -> bool) -> Result<u32> {
    let value = checked(vm, rule, |value| value >= 0.0 && allowed(value as u32))?;
    Ok(value as u32)
}
