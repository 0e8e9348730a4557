//! `sor { n, <radius,height> … [open] }` (docs/spec/primitives.md 6.2).

use std::sync::Arc;

use super::points;
use crate::interp::{Result, Vm, Word};
use crate::scene::{Shape, shape::Sor};

/// Heights nearer than this share of the whole height coincide.
const LEAST_STEP: f64 = 1e-10;

/// Reads the points.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let (count, place) = vm.located(Vm::read_int)?;
    if count < 4 {
        return Err(vm
            .error(place, format!("a surface of revolution needs at least 4 points, not {count}"))
            .help("the first and the last point only set the slope at the ends"));
    }
    let start = vm.here()?;
    let points = points(vm, count as usize, Vm::read_uv)?;
    let place = start.to(vm.last);
    if points.iter().any(|point| point.x < 0.0) {
        return Err(vm.error(place, "a point of this sor has a negative radius"));
    }
    let inner = &points[1..points.len() - 1];
    if inner.windows(2).any(|pair| pair[1].y <= pair[0].y) {
        return Err(vm
            .error(place, "the heights of a sor have to increase from point to point")
            .help("use `lathe` for a curve that turns back"));
    }
    let height = inner[inner.len() - 1].y - inner[0].y;
    if points.windows(3).any(|three| (three[2].y - three[0].y).abs() < LEAST_STEP * height) {
        return Err(vm.error(place, "an end point of this sor is at the height of the point after next"));
    }
    let open = vm.accept(Word::Open)?;
    Ok(Shape::Sor(Arc::new(Sor { points, open })))
}
