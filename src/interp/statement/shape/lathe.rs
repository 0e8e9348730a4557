//! `lathe { [spline] n, <radius,height> … }` (docs/spec/primitives.md 6.1).

use std::sync::Arc;

use super::{contour, points};
use crate::interp::{Result, Vm};
use crate::scene::Shape;
use crate::scene::shape::{ContourSpline, Lathe};

/// Reads the spline and the points.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let mut spline = ContourSpline::Linear;
    while let Some(named) = vm.peek_word()?.and_then(contour::spline) {
        vm.next()?;
        spline = named;
    }
    let count = contour::count(vm, "lathe", spline, [2, 3, 4, 4])?;
    let start = vm.here()?;
    let points = points(vm, count, Vm::read_uv)?;
    if points[1..count - 1].iter().any(|point| point.x < 0.0) {
        return Err(vm
            .error(start.to(vm.last), "a point of this lathe has a negative radius")
            .help("the first component of each point is its distance from the y axis; only the ends may be negative"));
    }
    Ok(Shape::Lathe(Arc::new(Lathe { spline, points })))
}
