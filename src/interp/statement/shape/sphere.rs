//! `sphere { <center>, radius }` (docs/spec/primitives.md 3.1).

use crate::interp::{Result, Vm};
use crate::scene::Shape;

/// Reads the parameters; a negative radius turns the normals inward.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let center = vm.read_vector()?;
    vm.comma()?;
    Ok(Shape::Sphere { center, radius: super::radius(vm, "sphere")? })
}
