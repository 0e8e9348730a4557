//! `sky_sphere { … }` (docs/spec/atmosphere-gi.md 1.5).

use std::sync::Arc;

use super::{color, pigment, transform};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::Rgb;
use crate::scene::SkySphere;

/// Reads `sky_sphere { … }`, whose keyword comes next.
pub(in crate::interp) fn block(vm: &mut Vm<'_>) -> Result<SkySphere> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::SkySphere(sky) => Some(SkySphere::clone(sky)),
        _ => None,
    })?;
    let mut sky = named.unwrap_or(SkySphere { span: block.span, pigments: Vec::new(), emission: Rgb::ONE });
    sky.span = block.span;
    loop {
        if let Some(by) = transform::item(vm)? {
            for pigment in &mut sky.pigments {
                Arc::make_mut(pigment).apply(&by);
            }
            continue;
        }
        match vm.peek_word()? {
            Some(Word::Pigment) => {
                let empty = vm.state.empty();
                sky.pigments.push(pigment::block(vm, &empty)?);
            }
            Some(Word::Emission) => sky.emission = vm.after_word(color::rgb)?,
            _ => break,
        }
    }
    if sky.pigments.is_empty() {
        return Err(vm.expected("`pigment { … }`").help("a sky_sphere consists of at least one pigment"));
    }
    vm.close(block)?;
    Ok(sky)
}
