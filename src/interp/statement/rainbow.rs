//! `rainbow { … }` (docs/spec/atmosphere-gi.md 1.7).

use super::map;
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::Rainbow;

/// Vectors are as good as zero or parallel below this.
const LEAST: f64 = 1e-10;

/// Reads `rainbow { … }`, whose keyword comes next.
pub(in crate::interp) fn block(vm: &mut Vm<'_>) -> Result<Rainbow> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::Rainbow(rainbow) => Some(Rainbow::clone(rainbow)),
        _ => None,
    })?;
    let mut rainbow = named.unwrap_or(Rainbow {
        span: block.span,
        direction: DVec3::ZERO,
        up: DVec3::Y,
        angle: 0.0,
        width: 0.0,
        distance: 1e7,
        jitter: 0.0,
        arc_angle: 360.0,
        falloff_angle: 360.0,
        colors: None,
    });
    rainbow.span = block.span;
    let (mut has_arc, mut has_falloff) = (false, false);
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Angle => rainbow.angle = vm.after_word(Vm::read_float)?,
            Word::Width => rainbow.width = vm.after_word(Vm::read_float)?,
            Word::Distance => rainbow.distance = vm.after_word(Vm::read_float)?,
            Word::Jitter => rainbow.jitter = vm.after_word(Vm::read_float)?,
            Word::Direction => rainbow.direction = vm.after_word(Vm::read_vector)?,
            Word::Up => rainbow.up = vm.after_word(Vm::read_vector)?,
            Word::ArcAngle => {
                has_arc = true;
                rainbow.arc_angle = full_angle(vm, "arc_angle")?;
            }
            Word::FalloffAngle => {
                has_falloff = true;
                rainbow.falloff_angle = full_angle(vm, "falloff_angle")?;
            }
            Word::ColorMap | Word::ColourMap => rainbow.colors = Some(map::colors(vm)?),
            _ => break,
        }
    }
    vm.close(block)?;
    if has_arc && !has_falloff {
        rainbow.falloff_angle = rainbow.arc_angle;
    }
    if rainbow.arc_angle < rainbow.falloff_angle {
        return Err(vm
            .error(block.span, "this rainbow fades beyond its own end")
            .help("`falloff_angle` is at most `arc_angle`"));
    }
    if rainbow.direction.length() < LEAST || rainbow.up.length() < LEAST {
        return Err(vm
            .error(block.span, "this rainbow has no direction")
            .help("write `direction` and the vector in which its light shines"));
    }
    if rainbow.up.cross(rainbow.direction).length() < LEAST {
        return Err(vm.error(block.span, "`up` and `direction` of this rainbow are parallel"));
    }
    Ok(rainbow)
}

fn full_angle(vm: &mut Vm<'_>, what: &str) -> Result<f64> {
    vm.next()?;
    let (angle, place) = vm.located(Vm::read_float)?;
    if (0.0..=360.0).contains(&angle) {
        return Ok(angle);
    }
    Err(vm.error(place, format!("`{what}` is 0 to 360 degrees, not {angle}")))
}
