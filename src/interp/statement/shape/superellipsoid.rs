//! `superellipsoid { <east-west, north-south> }` (docs/spec/primitives.md 3.10).

use crate::interp::{Result, Vm};
use crate::scene::Shape;

/// Reads the exponents; any are accepted.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let exponents = vm.read_uv()?;
    Ok(Shape::Superellipsoid { east: exponents.x, north: exponents.y })
}
