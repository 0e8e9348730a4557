//! `sphere { <center>, radius }` (docs/spec/primitives.md 3.1).

use crate::interp::{Result, Vm};
use crate::scene::Shape;

/// Reads the parameters; any radius is accepted.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let center = vm.read_vector()?;
    vm.comma()?;
    Ok(Shape::Sphere { center, radius: vm.read_float()? })
}
