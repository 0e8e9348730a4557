//! `prism { [sweep] [spline] height, height, n, <x,z> … [open] }` (docs/spec/primitives.md 6.3).

use std::sync::Arc;

use super::{contour, points};
use crate::interp::{Result, Vm, Word};
use crate::math::DVec2;
use crate::scene::Shape;
use crate::scene::depth::Nested;
use crate::scene::shape::{ContourSpline, Csg, CsgOperation, Prism, closing_distance};

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
    let place = start.to(vm.last);
    let open = vm.accept(Word::Open)?;
    if spline != ContourSpline::Linear && !is_closed(spline, &points) {
        vm.warn(place, "this prism is not closed", "it is left out; end each contour where it begins");
        let nothing =
            Csg { operation: CsgOperation::Union, children: Nested::default(), split_union: true, parts: 0 };
        return Ok(Shape::Csg(Arc::new(nothing)));
    }
    if spline == ContourSpline::Linear && !close_last(&mut points) {
        vm.warn(place, "this prism is not closed", "repeat the first point of each contour at its end");
    }
    Ok(Shape::Prism(Arc::new(Prism { spline, conic, heights: [a.min(b), a.max(b)], points, open })))
}

/// Closes the last contour; says whether it was closed already.
fn close_last(points: &mut Vec<DVec2>) -> bool {
    let near = closing_distance(points);
    let mut start = Some(0);
    for index in 1..points.len() {
        match start {
            None => start = Some(index),
            Some(first) if points[index].distance(points[first]) <= near => start = None,
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

/// Whether every contour ends where it begins. Control points stand before a quadratic contour, and
/// around a cubic one (docs/spec/primitives.md 6.3).
fn is_closed(spline: ContourSpline, points: &[DVec2]) -> bool {
    let near = closing_distance(points);
    let same = |a: usize, b: usize| points[a].distance(points[b]) <= near;
    if spline == ContourSpline::Bezier {
        let mut first = 0;
        return (3..points.len()).step_by(4).all(|end| {
            let goes_on = end + 1 < points.len() && same(end, end + 1);
            let closed = goes_on || same(end, first);
            if !goes_on {
                first = end + 1;
            }
            closed
        });
    }
    let (controls_after, end) = match spline {
        ContourSpline::Cubic => (1, points.len() - 1),
        _ => (0, points.len()),
    };
    let mut first = 1;
    while first < end {
        match (first + 1..end).find(|&at| same(at, first)) {
            Some(at) => first = at + controls_after + 2,
            None => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_points_are_no_part_of_a_contour() {
        let (o, a, b, c) = (DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE);
        assert!(is_closed(ContourSpline::Quadratic, &[c, o, a, b, o]));
        assert!(!is_closed(ContourSpline::Quadratic, &[o, a, b, o, c]));
        assert!(is_closed(ContourSpline::Cubic, &[c, o, a, b, o, c]));
        assert!(is_closed(ContourSpline::Cubic, &[c, o, a, b, o, c, c, a, o, b, a, c]));
        assert!(!is_closed(ContourSpline::Cubic, &[o, a, b, c, o, a]));
        assert!(is_closed(ContourSpline::Bezier, &[o, a, b, c, c, a, b, o]));
        assert!(!is_closed(ContourSpline::Bezier, &[o, a, b, c]));
    }

    #[test]
    fn an_open_contour_gets_its_first_point_again() {
        let (o, a, b) = (DVec2::ZERO, DVec2::X, DVec2::Y);
        let mut open = vec![o, a, b, o, a, b, o];
        assert!(!close_last(&mut open));
        assert_eq!(open[7], a);
        assert!(close_last(&mut vec![o, a, b, o]));
    }
}
