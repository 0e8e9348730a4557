//! `box { <corner>, <corner> }` (docs/spec/primitives.md 3.2).

use crate::interp::{Result, Vm};
use crate::math::DVec3;
use crate::scene::Shape;

/// Reads the parameters of the shape.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let (min, max) = corners(vm)?;
    Ok(Shape::Box { min, max })
}

/// Two opposite corners, sorted along every axis.
pub(super) fn corners(vm: &mut Vm<'_>) -> Result<(DVec3, DVec3)> {
    let a = vm.read_vector()?;
    vm.comma()?;
    let b = vm.read_vector()?;
    Ok((a.min(b), a.max(b)))
}
