//! `cubic`, `quartic`, `poly` and `polynomial` (docs/spec/primitives.md 3.9).

use std::sync::Arc;

use super::check_finite;
use crate::interp::{Result, Vm, Word};
use crate::scene::{Shape, shape::Poly};
use crate::syntax::Punct;

/// Reads `cubic` (order 3) or `quartic` (order 4): `< coefficients >`.
pub(super) fn fixed(vm: &mut Vm<'_>, order: u32) -> Result<Shape> {
    let coefficients = coefficients(vm, order)?;
    Ok(Shape::Poly(Arc::new(Poly { order, coefficients })))
}

/// Reads `poly { order, < coefficients > }`.
pub(super) fn poly(vm: &mut Vm<'_>) -> Result<Shape> {
    let order = order(vm)?;
    vm.comma()?;
    fixed(vm, order)
}

/// Reads `polynomial { order, xyz(i,j,k): F, … }`.
pub(super) fn polynomial(vm: &mut Vm<'_>) -> Result<Shape> {
    let order = order(vm)?;
    let mut coefficients = vec![0.0; count(order)];
    vm.comma()?;
    while vm.accept(Word::Xyz)? {
        let start = vm.last;
        vm.expect(Punct::OpenParen)?;
        let mut powers = [0; 3];
        for power in &mut powers {
            *power = vm.read_int()?;
            vm.comma()?;
        }
        vm.expect(Punct::CloseParen)?;
        if powers.iter().any(|&power| power < 0) || powers.iter().sum::<i32>() > order as i32 {
            return Err(vm.error(
                start.to(vm.last),
                format!("the exponents of this term exceed the order {order} of the polynomial"),
            ));
        }
        vm.expect(Punct::Colon)?;
        let (coefficient, place) = vm.located(Vm::read_float)?;
        check_finite(vm, &[coefficient], "coefficient", place)?;
        coefficients[index(order, powers.map(|power| power as usize))] = coefficient;
        vm.comma()?;
    }
    Ok(Shape::Poly(Arc::new(Poly { order, coefficients })))
}

fn order(vm: &mut Vm<'_>) -> Result<u32> {
    let (order, place) = vm.located(Vm::read_int)?;
    if (2..=35).contains(&order) {
        return Ok(order as u32);
    }
    Err(vm.error(place, format!("the order of a polynomial is 2 to 35, not {order}")))
}

/// Coefficients of a polynomial of this order in three variables.
fn count(order: u32) -> usize {
    let n = order as usize;
    (n + 1) * (n + 2) * (n + 3) / 6
}

fn coefficients(vm: &mut Vm<'_>, order: u32) -> Result<Vec<f64>> {
    let start = vm.here()?;
    let coefficients = vm.read_components(count(order))?;
    check_finite(vm, &coefficients, "coefficient", start.to(vm.last))?;
    Ok(coefficients)
}

/// The place of x^i y^j z^k: terms are sorted by falling powers of x, then of y, then of z.
fn index(order: u32, [i, j, k]: [usize; 3]) -> usize {
    let n = order as usize;
    // Terms with a higher power of x, then those with the same and a higher power of y.
    let tetrahedron = |m: usize| m * (m + 1) * (m + 2) / 6;
    let rest = n - i;
    tetrahedron(rest) + (rest - j) * (rest - j + 1) / 2 + (rest - j - k)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_stand_in_the_order_of_the_quadratic_form() {
        // poly { 2, <x², xy, xz, x, y², yz, y, z², z, 1> }
        let powers = [
            [2, 0, 0],
            [1, 1, 0],
            [1, 0, 1],
            [1, 0, 0],
            [0, 2, 0],
            [0, 1, 1],
            [0, 1, 0],
            [0, 0, 2],
            [0, 0, 1],
            [0, 0, 0],
        ];
        for (place, powers) in powers.into_iter().enumerate() {
            assert_eq!(index(2, powers), place, "{powers:?}");
        }
        assert_eq!(count(4), 35);
        assert_eq!(index(4, [0, 0, 0]), 34);
    }
}
