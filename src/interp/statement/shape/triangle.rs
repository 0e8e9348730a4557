//! `triangle` and `smooth_triangle` (docs/spec/primitives.md 4.1).

use crate::interp::{Result, Vm};
use crate::math::DVec3;
use crate::scene::{Shape, shape::Triangle};

/// Reads the three corners of a `triangle`.
pub(super) fn triangle(vm: &mut Vm<'_>) -> Result<Shape> {
    let start = vm.here()?;
    let corners = corners(vm)?;
    if is_degenerate(&corners) {
        warn_degenerate(vm, start);
    }
    Ok(Shape::Triangle(Box::new(Triangle { corners, normals: None })))
}

/// Reads corners and normals of a `smooth_triangle`.
pub(super) fn smooth_triangle(vm: &mut Vm<'_>) -> Result<Shape> {
    let start = vm.here()?;
    let (corners, normals) = smooth_corners(vm)?;
    if is_degenerate(&corners) || normals.contains(&DVec3::ZERO) {
        warn_degenerate(vm, start);
    }
    Ok(Shape::Triangle(Box::new(Triangle { corners, normals: Some(normals) })))
}

fn warn_degenerate(vm: &mut Vm<'_>, start: crate::source::Span) {
    let place = start.to(vm.last);
    vm.warn(place, "this triangle has no area", "its corners lie on one line: it is never seen");
}

/// Three corners.
pub(super) fn corners(vm: &mut Vm<'_>) -> Result<[DVec3; 3]> {
    let a = vm.read_vector()?;
    vm.comma()?;
    let b = vm.read_vector()?;
    vm.comma()?;
    Ok([a, b, vm.read_vector()?])
}

/// Corners and normals, in turn.
pub(super) fn smooth_corners(vm: &mut Vm<'_>) -> Result<([DVec3; 3], [DVec3; 3])> {
    let mut pairs = [[DVec3::ZERO; 2]; 3];
    for (index, value) in pairs.as_flattened_mut().iter_mut().enumerate() {
        if index > 0 {
            vm.comma()?;
        }
        *value = vm.read_vector()?;
    }
    Ok((pairs.map(|[corner, _]| corner), pairs.map(|[_, normal]| normal)))
}

/// Whether two corners coincide or all three lie on one line, as far as rounding can tell. POV-Ray's
/// measure is an area of 5e-11, whatever the size of the scene.
pub(super) fn is_degenerate(&[a, b, c]: &[DVec3; 3]) -> bool {
    const LEAST_SINE: f64 = 4.0 * f64::EPSILON;
    let (e, f) = (b - a, c - a);
    e.cross(f).length() <= LEAST_SINE * e.length() * f.length()
}
