//! `torus { major, minor }` (docs/spec/primitives.md 3.7).

use crate::interp::{Result, Vm};
use crate::scene::Shape;

/// Reads the parameters.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let major = vm.read_float()?;
    vm.comma()?;
    Ok(Shape::Torus { major, minor: vm.read_float()? })
}
