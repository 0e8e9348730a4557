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
    if let Some((message, help)) = flaw(&points) {
        vm.warn(start.to(vm.last), message, help);
    }
    Ok(Shape::Polygon(points.into()))
}

/// Why nothing would be seen of a polygon, and what to do about it.
fn flaw(points: &[DVec3]) -> Option<(&'static str, &'static str)> {
    /// Of the polygon's size: what is drawn in spite of rounding.
    const FLATNESS: f64 = 1e-6;
    let from = |p: &DVec3| *p - points[0];
    let size = points.iter().map(|p| from(p).abs().max_element()).fold(0.0, f64::max);
    let u = points.iter().map(from).find(|v| v.length() > FLATNESS * size).unwrap_or_default();
    let crosses = points.iter().map(|p| u.cross(from(p)));
    let Some(normal) = crosses.into_iter().find(|n| n.length() > FLATNESS * size * u.length()) else {
        return Some((
            "the points of this polygon lie on one line",
            "nothing of it is seen; three points have to span an area",
        ));
    };
    let off = |p: &DVec3| from(p).dot(normal.normalize()).abs() > FLATNESS * size;
    points.iter().any(off).then_some((
        "the points of this polygon are not in one plane",
        "nothing of it is seen; use several triangles or a mesh",
    ))
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
