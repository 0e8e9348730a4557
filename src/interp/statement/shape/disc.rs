//! `disc { <center>, <normal>, radius [, hole] }` (docs/spec/primitives.md 3.6).

use crate::interp::{Result, Vm};
use crate::scene::{Shape, shape::Disc};

/// Reads the parameters. A normal without length stays zero: such a disc is never hit.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let center = vm.read_vector()?;
    vm.comma()?;
    let normal = vm.read_vector()?.normalize_or_zero();
    vm.comma()?;
    let radius = super::radius(vm, "disc")?;
    vm.comma()?;
    let hole = if vm.at_number()? { vm.read_float()? } else { 0.0 };
    Ok(Shape::Disc(Box::new(Disc { center, normal, radius, hole })))
}
