//! `ovus { bottom, top }` (docs/spec/primitives.md 3.11).

use crate::interp::{Result, Vm};
use crate::scene::Shape;

/// Reads the radii.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let start = vm.here()?;
    let bottom = vm.read_float()?;
    vm.comma()?;
    let top = vm.read_float()?;
    let place = start.to(vm.last);
    if bottom < 0.0 || top < 0.0 {
        return Err(vm.error(place, "the radii of an ovus cannot be negative"));
    }
    if top >= 2.0 * bottom {
        vm.possible(
            place,
            "the top radius of this ovus is at least twice the bottom radius",
            "all that is left is a sphere of the top radius",
        );
    }
    Ok(Shape::Ovus { bottom, top })
}
