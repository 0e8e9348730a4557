//! `text { ttf "font.ttf" "text" thickness, offset }` (docs/spec/primitives.md 6.5).

use std::sync::Arc;

use crate::interp::{Result, Vm, Word};
use crate::scene::Shape;
use crate::scene::shape::{Font, Text};
use crate::source::FileKind;

/// Reads font, text and size. The font file has to be there.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let font = match vm.peek_word()? {
        Some(Word::Ttf) => {
            vm.next()?;
            let (name, place) = vm.located(Vm::read_string)?;
            let path = vm.find_file(&name, FileKind::Other(&[".ttf", ".TTF"]), place)?;
            Font::File(name.to_string(), path)
        }
        Some(Word::Internal) => Font::Internal(vm.after_word(Vm::read_count)?),
        _ => return Err(vm.expected("a font: `ttf \"file.ttf\"` or `internal 1`")),
    };
    vm.comma()?;
    let text = vm.read_string()?.encode_utf16().collect();
    vm.comma()?;
    let thickness = vm.read_float()?;
    vm.comma()?;
    let offset = vm.read_vector()?;
    Ok(Shape::Text(Arc::new(Text { font, text, thickness, offset })))
}
