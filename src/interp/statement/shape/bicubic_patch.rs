//! `bicubic_patch` (docs/spec/primitives.md 4.5).

use std::sync::Arc;

use crate::interp::limits::MOST_PATCH_STEPS;
use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::{Shape, shape::BicubicPatch};

use super::Block;

/// Reads settings, corner uvs and control points.
pub(super) fn read(vm: &mut Vm<'_>, block: &Block) -> Result<Shape> {
    let mut kind = None;
    let (mut flatness, mut steps, mut accuracy) = (0.0, [0, 0], 0.01);
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Type => {
                vm.next()?;
                kind = Some(vm.located(Vm::read_int)?);
            }
            Word::Flatness => flatness = vm.after_word(Vm::read_float)?,
            Word::USteps | Word::VSteps => {
                vm.next()?;
                let count = vm.read_at_most(word.text(), MOST_PATCH_STEPS)?;
                steps[usize::from(word == Word::VSteps)] = count.max(0) as u32;
            }
            Word::Accuracy => accuracy = vm.after_word(Vm::read_float)?,
            _ => break,
        }
        vm.comma()?;
    }
    let Some((kind, place)) = kind else {
        return Err(vm
            .error(block.span, "this bicubic_patch has no type")
            .help("begin it with `type 1`, then `u_steps 4 v_steps 4` and its 16 points"));
    };
    let kind = if (0..=1).contains(&kind) {
        kind as u32
    } else {
        vm.warn(place, format!("there is no bicubic_patch of type {kind}"), "type 1 is taken");
        1
    };
    let uv = if vm.accept(Word::UvVectors)? { Some(super::uvs(vm)?) } else { None };
    vm.comma()?;
    let mut points = [DVec3::ZERO; 16];
    for (index, point) in points.iter_mut().enumerate() {
        if index > 0 {
            vm.comma()?;
        }
        *point = vm.read_vector()?;
    }
    Ok(Shape::BicubicPatch(Arc::new(BicubicPatch { kind, flatness, steps, accuracy, points, uv })))
}
