//! `plane { <normal>, distance }` (docs/spec/primitives.md 3.3).

use crate::interp::{Result, Vm};
use crate::scene::Shape;

/// A normal shorter than this has no direction to POV-Ray.
const LEAST_NORMAL: f64 = 1e-10;

/// Reads the parameters. The distance counts along the unit normal.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let (normal, place) = vm.located(Vm::read_vector)?;
    if normal.length() < LEAST_NORMAL {
        return Err(vm
            .error(place, "the normal of this plane has no length")
            .help("give the direction the plane faces, such as `y` for a floor: `plane { y, 0 }`"));
    }
    vm.comma()?;
    Ok(Shape::Plane { normal: normal.normalize(), distance: vm.read_float()? })
}
