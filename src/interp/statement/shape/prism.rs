//! `prism { [sweep] [spline] height, height, n, <x,z> … [open] }` (docs/spec/primitives.md 6.3).

use std::sync::Arc;

use super::{contour, points};
use crate::interp::{Result, Vm, Word};
use crate::math::DVec2;
use crate::scene::Shape;
use crate::scene::shape::{ContourSpline, Prism};

/// Points nearer than this coincide.
const SAME: f64 = 1e-10;

/// Reads sweep, spline, heights (sorted) and points.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let (mut spline, mut conic) = (ContourSpline::Linear, false);
    while let Some(word) = vm.peek_word()? {
        match (word, contour::spline(word)) {
            (_, Some(named)) => spline = named,
            (Word::LinearSweep | Word::ConicSweep, _) => conic = word == Word::ConicSweep,
            _ => break,
        }
        vm.next()?;
    }
    let a = vm.read_float()?;
    vm.comma()?;
    let b = vm.read_float()?;
    vm.comma()?;
    let count = contour::count(vm, "prism", spline, [3, 5, 6, 4])?;
    let start = vm.here()?;
    let mut points = points(vm, count, Vm::read_uv)?;
    if spline == ContourSpline::Linear && !close_last(&mut points) {
        let place = start.to(vm.last);
        vm.warn(place, "this prism is not closed", "repeat the first point of each contour at its end");
    }
    let open = vm.accept(Word::Open)?;
    Ok(Shape::Prism(Arc::new(Prism { spline, conic, heights: [a.min(b), a.max(b)], points, open })))
}

/// Closes the last contour; says whether it was closed already.
fn close_last(points: &mut Vec<DVec2>) -> bool {
    let mut start = Some(0);
    for index in 1..points.len() {
        match start {
            None => start = Some(index),
            Some(first) if points[index].distance(points[first]) < SAME => start = None,
            Some(_) => {}
        }
    }
    match start {
        Some(first) if first < points.len() => {
            points.push(points[first]);
            false
        }
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_open_contour_gets_its_first_point_again() {
        let (o, a, b) = (DVec2::ZERO, DVec2::X, DVec2::Y);
        let mut open = vec![o, a, b, o, a, b, o];
        assert!(!close_last(&mut open));
        assert_eq!(open[7], a);
        assert!(close_last(&mut vec![o, a, b, o]));
    }
}
