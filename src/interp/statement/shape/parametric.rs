//! `parametric { function { … } ×3 <u,v>, <u,v> … }` (docs/spec/primitives.md 4.6).

use std::sync::Arc;

use super::container;
use crate::interp::{Result, Vm, Word};
use crate::scene::{Shape, shape::Parametric};

/// Reads functions, ranges (sorted) and settings.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let function = |vm: &mut Vm<'_>| -> Result<_> {
        let function = super::function(vm)?;
        vm.comma()?;
        Ok(function)
    };
    let functions = [function(vm)?, function(vm)?, function(vm)?];
    let a = vm.read_uv()?;
    vm.comma()?;
    let b = vm.read_uv()?;
    let mut surface = Parametric {
        functions,
        from: a.min(b),
        to: a.max(b),
        container: container::DEFAULT,
        accuracy: 0.001,
        max_gradient: 1.0,
        precompute: None,
    };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::ContainedBy => surface.container = container::read(vm)?,
            Word::Accuracy => surface.accuracy = vm.after_word(Vm::read_float)?,
            Word::MaxGradient => surface.max_gradient = vm.after_word(Vm::read_float)?,
            Word::Precompute => {
                vm.next()?;
                let (depth, place) = vm.located(Vm::read_count)?;
                if !(1..=20).contains(&depth) {
                    return Err(vm.error(place, "the depth of `precompute` is from 1 to 20"));
                }
                let mut axes = [false; 3];
                for (axis, word) in axes.iter_mut().zip([Word::X, Word::Y, Word::Z]) {
                    vm.comma()?;
                    *axis = vm.accept(word)?;
                }
                surface.precompute = Some((depth, axes));
            }
            _ => break,
        }
    }
    Ok(Shape::Parametric(Arc::new(surface)))
}
