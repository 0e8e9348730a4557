//! `background { color }` (docs/spec/atmosphere-gi.md 1.4).

use super::color;
use crate::interp::{Result, Vm};
use crate::math::Rgbft;

/// Reads `background { … }`, whose keyword comes next.
pub(super) fn block(vm: &mut Vm<'_>) -> Result<Rgbft> {
    let block = vm.enter()?;
    let color = if vm.at_color()? || vm.at_number()? { color::rgbft(vm)? } else { Rgbft::BLACK };
    vm.close(block)?;
    Ok(color)
}
