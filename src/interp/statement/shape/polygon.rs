//! `polygon { n, <point> … }` (docs/spec/primitives.md 4.2).

use crate::interp::{Result, Vm};
use crate::math::DVec3;
use crate::scene::Shape;

use super::points;

/// Reads the points: closed contours one after another. An open last one is closed with a warning.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Shape> {
    let start = vm.here()?;
    let (count, place) = vm.located(Vm::read_int)?;
    if count < 3 {
        return Err(vm
            .error(place, format!("a polygon of {count} points has no area"))
            .help("write the number of points, at least 3, before them"));
    }
    let mut points: Vec<DVec3> = points(vm, count as usize, Vm::read_vector)?;
    if !is_closed(&points) {
        let place = start.to(vm.last);
        vm.warn(place, "this polygon is not closed", "repeat the first point of each contour at its end");
        let first = last_start(&points);
        points.push(points[first]);
    }
    Ok(Shape::Polygon(points.into()))
}

/// Where the contour that contains the last point begins.
fn last_start(points: &[DVec3]) -> usize {
    let mut start = 0;
    for (index, &point) in points.iter().enumerate() {
        if index > start && point == points[start] && index + 1 < points.len() {
            start = index + 1;
        }
    }
    start
}

fn is_closed(points: &[DVec3]) -> bool {
    let start = last_start(points);
    start + 1 < points.len() && points[start] == points[points.len() - 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_contour_ends_at_its_first_point() {
        let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        assert!(is_closed(&[o, x, y, o]));
        assert!(is_closed(&[o, x, y, o, x, y, DVec3::Z, x]));
        assert!(!is_closed(&[o, x, y]));
        assert!(!is_closed(&[o, x, y, o, x, y, DVec3::Z]));
    }
}
