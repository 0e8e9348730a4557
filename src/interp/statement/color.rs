//! Colours as statements take them (docs/spec/language.md 3.4).

use crate::interp::builtin::color::is_keyword;
use crate::interp::{Result, Vm, Word};
use crate::math::{Rgb, Rgbft};

/// Whether a word starts a colour.
pub(super) fn starts(word: Word) -> bool {
    is_keyword(word)
}

/// Reads a colour.
pub(super) fn rgbft(vm: &mut Vm<'_>) -> Result<Rgbft> {
    Ok(Rgbft::new(vm.read_color()?.map(|c| c as f32)))
}

/// Reads a colour where filter and transmit mean nothing.
pub(super) fn rgb(vm: &mut Vm<'_>) -> Result<Rgb> {
    Ok(Rgb::from_array(vm.read_rgb()?.map(|c| c as f32)))
}
