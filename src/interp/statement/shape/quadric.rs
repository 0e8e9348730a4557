//! `quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }` (docs/spec/primitives.md 3.8).

use crate::interp::{Result, Vm};
use crate::scene::{Shape, shape::Quadric};

/// Reads the coefficients.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let squares = vm.read_vector()?;
    vm.comma()?;
    let products = vm.read_vector()?;
    vm.comma()?;
    let linear = vm.read_vector()?;
    vm.comma()?;
    Ok(Shape::Quadric(Box::new(Quadric { squares, products, linear, constant: vm.read_float()? })))
}
