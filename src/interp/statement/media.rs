//! `media { … }` (docs/spec/atmosphere-gi.md 2.1).

use super::{color, pigment, transform};
use crate::interp::limits::{MOST_MEDIA_LEVELS, MOST_MEDIA_SAMPLES};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::Rgb;
use crate::scene::Media;
use crate::scene::interior::Scattering;
use crate::source::Span;

/// Reads `media { … }`, whose keyword comes next.
pub(in crate::interp) fn block(vm: &mut Vm<'_>) -> Result<Media> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::Media(media) => Some(Media::clone(media)),
        _ => None,
    })?;
    let mut media = named.unwrap_or_else(|| default(block.span, vm.version));
    media.span = block.span;
    loop {
        if let Some(by) = transform::item(vm)? {
            media.apply(&by);
            continue;
        }
        let Some(word) = vm.peek_word()? else { break };
        if !item(vm, &mut media, word)? {
            break;
        }
    }
    vm.close(block)?;
    Ok(media)
}

/// Media before version 3.5 sampled in another way.
fn default(span: Span, version: i32) -> Media {
    let (method, intervals, samples) = if version < 350 { (1, 10, 1) } else { (3, 1, 10) };
    Media {
        span,
        method,
        intervals,
        samples: [samples; 2],
        aa_threshold: 0.1,
        aa_level: 3,
        jitter: 0.0,
        ratio: 0.9,
        confidence: 0.9,
        variance: 1.0 / 128.0,
        absorption: Rgb::ZERO,
        emission: Rgb::ZERO,
        scattering: None,
        collect: true,
        densities: Vec::new(),
    }
}

fn item(vm: &mut Vm<'_>, media: &mut Media, word: Word) -> Result<bool> {
    match word {
        Word::Method => {
            vm.next()?;
            let (method, place) = vm.located(Vm::read_int)?;
            if !(1..=3).contains(&method) {
                return Err(vm.error(place, format!("`method` is 1, 2 or 3, not {method}")));
            }
            media.method = method as u32;
        }
        Word::Intervals => media.intervals = counted(vm, word, MOST_MEDIA_SAMPLES)?,
        Word::Samples => {
            media.samples[0] = counted(vm, word, MOST_MEDIA_SAMPLES)?;
            media.samples[1] = media.samples[0];
            vm.comma()?;
            if vm.at_number()? {
                let (most, place) = vm.located(|vm| vm.read_at_most("samples", MOST_MEDIA_SAMPLES))?;
                let most = most.max(0) as u32;
                if most < media.samples[0] {
                    return Err(vm
                        .error(place, "the most samples are fewer than the least")
                        .help("write the smaller number first"));
                }
                media.samples[1] = most;
            }
        }
        Word::AaLevel => media.aa_level = counted(vm, word, MOST_MEDIA_LEVELS)?,
        Word::AaThreshold => {
            vm.next()?;
            let (threshold, place) = vm.located(Vm::read_float)?;
            if threshold <= 0.0 {
                return Err(vm.error(place, "`aa_threshold` has to be above 0"));
            }
            media.aa_threshold = threshold as f32;
        }
        Word::Confidence => {
            vm.next()?;
            let (confidence, place) = vm.located(Vm::read_float)?;
            if !(0.0..1.0).contains(&confidence) {
                return Err(vm.error(place, "`confidence` lies between 0 and 1"));
            }
            media.confidence = confidence as f32;
        }
        Word::Variance => media.variance = vm.after_word(Vm::read_float)? as f32,
        Word::Jitter => {
            vm.next()?;
            media.jitter = if vm.at_number()? { vm.read_float()? as f32 } else { 1.0 };
        }
        Word::Ratio => media.ratio = vm.after_word(Vm::read_float)? as f32,
        Word::Absorption => media.absorption = vm.after_word(color::rgb)?,
        Word::Emission => media.emission = vm.after_word(color::rgb)?,
        Word::Scattering => media.scattering = Some(scattering(vm)?),
        Word::Density => media.densities.push(pigment::density(vm)?),
        Word::Collect => media.collect = vm.after_word(Vm::read_flag)?,
        _ => return Ok(false),
    }
    Ok(true)
}

/// Reads the value of a setting of media: at least 1, and at most `most`.
fn counted(vm: &mut Vm<'_>, word: Word, most: i32) -> Result<u32> {
    vm.next()?;
    let (number, place) = vm.located(|vm| vm.read_at_most(word.text(), most))?;
    match u32::try_from(number) {
        Ok(value) if value >= 1 => Ok(value),
        _ => Err(vm.error(place, format!("`{}` is at least 1, not {number}", word.text()))),
    }
}

fn scattering(vm: &mut Vm<'_>) -> Result<Scattering> {
    let block = vm.enter()?;
    let (kind, place) = vm.located(Vm::read_int)?;
    if !(1..=5).contains(&kind) {
        vm.warn(
            place,
            format!("there is no scattering of type {kind}"),
            "types are 1 to 5; light is scattered evenly",
        );
    }
    vm.comma()?;
    let color = color::rgb(vm)?;
    let kind = if (1..=5).contains(&kind) { kind as u32 } else { 1 };
    let mut scattering = Scattering { kind, color, eccentricity: 0.0, extinction: 1.0 };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Eccentricity => {
                let place = vm.next()?.span;
                if kind != 5 {
                    return Err(vm
                        .error(place, format!("scattering of type {kind} has no `eccentricity`"))
                        .help("only type 5 has one"));
                }
                scattering.eccentricity = vm.read_float()? as f32;
            }
            Word::Extinction => scattering.extinction = vm.after_word(Vm::read_float)? as f32,
            _ => break,
        }
    }
    vm.close(block)?;
    Ok(scattering)
}
