//! `text { ttf "font.ttf" "text" thickness, offset }` (docs/spec/primitives.md 6.5).

use std::sync::Arc;

use crate::interp::{Charset, Result, Vm, Word};
use crate::scene::Shape;
use crate::scene::shape::{Font, Text};
use crate::source::FileKind;

const FONT: FileKind = FileKind::Other(&[".ttf", ".TTF"]);

/// Reads font, text and size. The font file has to be there.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let font = match vm.peek_word()? {
        Some(Word::Ttf) => {
            vm.next()?;
            let (name, place) = vm.located(Vm::read_string)?;
            let path = vm.find_file(&name, FONT, place)?;
            Font::File(name.to_string(), path)
        }
        Some(Word::Internal) => {
            let number = vm.after_word(Vm::read_count)?;
            let path = vm.sources.library.find(installed(number), FONT).filter(|path| path.is_file());
            Font::Internal(number, path)
        }
        _ => return Err(vm.expected("a font: `ttf \"file.ttf\"` or `internal 1`")),
    };
    vm.comma()?;
    let text = vm.read_string()?.encode_utf16().collect();
    vm.comma()?;
    let thickness = vm.read_float()?;
    vm.comma()?;
    let offset = vm.read_vector()?;
    let unicode = vm.charset != Charset::Ascii;
    Ok(Shape::Text(Arc::new(Text { font, text, thickness, offset, unicode })))
}

/// The file of POV-Ray's own that has the same outlines as an `internal` font.
fn installed(number: u32) -> &'static str {
    match number {
        1 => "timrom.ttf",
        2 => "cyrvetic.ttf",
        3 => "crystal.ttf",
        _ => "povlogo.ttf",
    }
}
