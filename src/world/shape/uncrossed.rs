//! What is inside along lines, for shapes that tell no more than where they are crossed.

use super::Shape;
use crate::math::{Band, DVec3, Lanes};
use crate::world::{Range, Ray};

/// How far beside a line points may be, as a share of its coordinates, that count as on it: many times what rounding
/// moves them by.
const BESIDE: f64 = 1e-12;

/// By how much of itself a line is looked at beyond its ends.
const BEYOND: f64 = 1e-6;

/// What holds whether points are inside a shape all of whose border is surface: where nothing is crossed on the way
/// between them, all are if one is.
pub(super) fn inside_along(shape: &(impl Shape + ?Sized), point: &[Band; 3]) -> Band {
    inside_unless(shape, |ray, range| shape.occludes(ray, range), point)
}

/// The same where `passes` tells whether a part of a ray comes through the border of the inside, or perhaps does.
pub(super) fn inside_unless(
    shape: &(impl Shape + ?Sized),
    passes: impl Fn(&Ray, Range) -> bool,
    point: &[Band; 3],
) -> Band {
    let numbers = |of: &dyn Fn(&Band) -> f64| DVec3::from_array(point.each_ref().map(of));
    let mut low = Lanes::ZERO;
    let mut high = Lanes::splat(1.0);
    for lane in 0..Lanes::COUNT {
        let middle = numbers(&|band| band.middle.0[lane]);
        let along = numbers(&|band| band.slope.0[lane]);
        let reach = numbers(&|band| band.reach.0[lane]);
        // What is spread wide, or is no number, is anywhere; so is a line that is shorter than it is wide.
        let wide = BESIDE * (middle.abs() + along.abs()).max_element();
        let is_known = middle.is_finite() && along.is_finite() && reach.is_finite();
        let is_line = is_known && reach.max_element() <= wide && along.abs().max_element() > wide;
        if !is_line {
            continue;
        }
        let range = Range { min: -1.0 - BEYOND, max: 1.0 + BEYOND };
        if !passes(&Ray::new(middle, along), range) {
            let inside = f64::from(shape.inside(middle));
            (low.0[lane], high.0[lane]) = (inside, inside);
        }
    }
    Band::within(low, high)
}
