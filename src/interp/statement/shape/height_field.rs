//! `height_field { image … }` (docs/spec/primitives.md 5.4).

use std::sync::Arc;

use crate::interp::statement::image::{self, Usage};
use crate::interp::{Result, Vm, Word};
use crate::scene::{Shape, shape::HeightField};

/// Reads the image and the settings before the modifiers.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let image = Arc::new(image::source(vm, Usage::HeightField)?);
    let mut field = HeightField { image, water_level: 0.0, smooth: false };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::WaterLevel => {
                let level = vm.after_word(Vm::read_float)?;
                // Scenes for version 1 count heights in bytes (docs/spec/language.md 2.11).
                field.water_level = if vm.version < 200 { level / 256.0 } else { level };
            }
            Word::Smooth => field.smooth = vm.after_word(Vm::read_flag)?,
            _ => break,
        }
    }
    Ok(Shape::HeightField(Arc::new(field)))
}
