//! `torus { major, minor }` (docs/spec/primitives.md 3.7).

use crate::interp::{Result, Vm};
use crate::scene::Shape;

/// Reads the parameters.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let major = super::radius(vm, "torus")?;
    vm.comma()?;
    Ok(Shape::Torus { major, minor: super::radius(vm, "torus")? })
}
