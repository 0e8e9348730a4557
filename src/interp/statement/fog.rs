//! `fog { … }` (docs/spec/atmosphere-gi.md 1.6).

use super::{color, pattern, transform};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::{DVec3, Rgbft};
use crate::scene::Fog;

/// Reads `fog { … }`, whose keyword comes next.
pub(in crate::interp) fn block(vm: &mut Vm<'_>) -> Result<Fog> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::Fog(fog) => Some(Fog::clone(fog)),
        _ => None,
    })?;
    let mut fog = named.unwrap_or(Fog {
        span: block.span,
        kind: 1,
        distance: 0.0,
        color: Rgbft::BLACK,
        altitude: 0.0,
        offset: 0.0,
        up: DVec3::Y,
        turbulence: None,
        turb_depth: 0.5,
    });
    fog.span = block.span;
    while item(vm, &mut fog)? {}
    vm.close(block)?;
    fog.up = fog.up.try_normalize().unwrap_or_else(|| {
        vm.warn(block.span, "`up` of this fog has no length", "`y` is taken");
        DVec3::Y
    });
    Ok(fog)
}

fn item(vm: &mut Vm<'_>, fog: &mut Fog) -> Result<bool> {
    if vm.at_color()? {
        fog.color = color::rgbft(vm)?;
        return Ok(true);
    }
    let Some(word) = vm.peek_word()? else {
        if !vm.at_number()? {
            return Ok(false);
        }
        let (distance, place) = vm.located(Vm::read_float)?;
        vm.warn(place, "a number by itself is the distance of a fog", "write `distance` before it");
        fog.distance = distance;
        return Ok(true);
    };
    if word == Word::Translate {
        let place = vm.here()?;
        transform::item(vm)?;
        vm.warn(place, "fog has no place: `translate` does nothing", "use `fog_offset` to lift ground fog");
        return Ok(true);
    }
    if let Some(by) = transform::item(vm)? {
        fog.up = by.vector(fog.up);
        return Ok(true);
    }
    match word {
        Word::Distance => fog.distance = vm.after_word(Vm::read_float)?,
        Word::FogType => {
            vm.next()?;
            let (kind, place) = vm.located(Vm::read_int)?;
            if !(1..=2).contains(&kind) {
                vm.warn(
                    place,
                    format!("there is no fog of type {kind}"),
                    "1 is constant, 2 lies on the ground; 1 is taken",
                );
            }
            fog.kind = if kind == 2 { 2 } else { 1 };
        }
        Word::FogAlt => fog.altitude = vm.after_word(Vm::read_float)?,
        Word::FogOffset => fog.offset = vm.after_word(Vm::read_float)?,
        Word::Up => fog.up = vm.after_word(Vm::read_vector)?,
        Word::TurbDepth => fog.turb_depth = vm.after_word(Vm::read_float)? as f32,
        Word::Turbulence => fog.turbulence.get_or_insert_default().amount = vm.after_word(Vm::read_vector)?,
        Word::Octaves | Word::Omega | Word::Lambda => {
            vm.next()?;
            pattern::turbulence_option(vm, fog.turbulence.get_or_insert_default(), word)?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}
