//! `isosurface { function { … } … }` (docs/spec/primitives.md 5.2).

use std::sync::Arc;

use super::container;
use crate::interp::{Result, Vm, Word};
use crate::scene::{Shape, shape::Isosurface};

/// Reads the function, which comes first, and the settings.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let function = super::function(vm)?;
    let mut iso = Isosurface {
        function,
        container: container::DEFAULT,
        threshold: 0.0,
        accuracy: 0.001,
        max_gradient: 1.1,
        evaluate: None,
        max_trace: Some(1),
        open: false,
    };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::ContainedBy => iso.container = container::read(vm)?,
            Word::Threshold => iso.threshold = vm.after_word(Vm::read_float)?,
            Word::Accuracy => iso.accuracy = positive(vm, "accuracy", 0.001)?,
            Word::MaxGradient => iso.max_gradient = positive(vm, "max_gradient", 1.1)?,
            Word::Evaluate => {
                vm.next()?;
                let first = vm.read_float()?;
                vm.comma()?;
                let second = vm.read_float()?;
                vm.comma()?;
                iso.evaluate = Some([first, second, vm.read_float()?]);
            }
            Word::MaxTrace => {
                vm.next()?;
                let (count, place) = vm.located(Vm::read_int)?;
                iso.max_trace = Some(count.clamp(1, 10) as u32);
                if !(1..=10).contains(&count) {
                    let help = format!("{} is taken", count.clamp(1, 10));
                    vm.warn(place, format!("`max_trace` is 1 to 10, not {count}"), &help);
                }
            }
            Word::AllIntersections => {
                vm.next()?;
                iso.max_trace = None;
            }
            Word::Open => {
                vm.next()?;
                iso.open = true;
            }
            _ => break,
        }
    }
    Ok(Shape::Isosurface(Arc::new(iso)))
}

/// A setting that must be positive; POV-Ray takes its default otherwise.
fn positive(vm: &mut Vm<'_>, what: &str, default: f64) -> Result<f64> {
    vm.next()?;
    let (value, place) = vm.located(Vm::read_float)?;
    if value > 0.0 {
        return Ok(value);
    }
    vm.warn(place, format!("`{what}` must be positive"), &format!("the default {default} is taken"));
    Ok(default)
}
