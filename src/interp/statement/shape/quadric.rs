//! `quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }` (docs/spec/primitives.md 3.8).

use super::check_finite;
use crate::interp::{Result, Vm};
use crate::math::DVec3;
use crate::scene::{Shape, shape::Quadric};

/// Reads the coefficients.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let start = vm.here()?;
    let squares = vm.read_vector()?;
    vm.comma()?;
    let products = vm.read_vector()?;
    vm.comma()?;
    let linear = vm.read_vector()?;
    vm.comma()?;
    let constant = vm.read_float()?;
    let place = start.to(vm.last);
    for vector in [squares, products, linear, DVec3::splat(constant)] {
        check_finite(vm, &vector.to_array(), "coefficient", place)?;
    }
    Ok(Shape::Quadric(Box::new(Quadric { squares, products, linear, constant })))
}
