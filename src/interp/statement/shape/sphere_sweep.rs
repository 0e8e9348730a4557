//! `sphere_sweep { spline n, <center>, radius … [tolerance F] }` (docs/spec/primitives.md 6.4).

use std::sync::Arc;

use super::{points, radius};
use crate::interp::{Result, Vm, Word};
use crate::scene::Shape;
use crate::scene::shape::{SphereSweep, SweepSpline};

/// Reads the spline, which has to be named, and the spheres.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let (spline, least) = match vm.peek_word()? {
        Some(Word::LinearSpline) => (SweepSpline::Linear, 2),
        Some(Word::CubicSpline) => (SweepSpline::Cubic, 4),
        Some(Word::BSpline) => (SweepSpline::BSpline, 4),
        _ => return Err(vm.expected("`linear_spline`, `cubic_spline` or `b_spline`")),
    };
    vm.next()?;
    vm.comma()?;
    let (count, place) = vm.located(Vm::read_int)?;
    if count < least {
        return Err(vm.error(place, format!("this sphere_sweep needs at least {least} spheres, not {count}")));
    }
    let spheres = points(vm, count as usize, |vm| {
        let center = vm.read_vector()?;
        vm.comma()?;
        Ok((center, radius(vm, "sphere")?))
    })?;
    let mut tolerance = 1e-6;
    while vm.accept(Word::Tolerance)? {
        tolerance = vm.read_float()?;
    }
    Ok(Shape::SphereSweep(Arc::new(SphereSweep { spline, spheres, tolerance })))
}
