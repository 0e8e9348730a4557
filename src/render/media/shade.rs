//! Which part of a stretch may be in the shadow of an object: samples elsewhere need not ask it.

use crate::math::{Bounds, DVec3};
use crate::world::{Range, Ray};

/// Relative errors of what is computed here stay below this.
const BLUR: f64 = 1e-9;

/// How far from the lamp's own height corners must be, relative to the coordinates.
const LOW: f64 = 1e-6;

/// The distances along `ray` to the points between which and a lamp a box may be; `None` where it
/// is never between.
pub(super) fn shade(bounds: &Bounds, ray: &Ray, lamp: DVec3) -> Option<Range> {
    if !bounds.is_finite() {
        return Some(Range::LINE);
    }
    // The plane through ray and lamp, with the lamp at the origin: places along the ray, and towards it.
    let foot = (lamp - ray.origin).dot(ray.direction);
    let toward = ray.at(foot) - lamp;
    let square = toward.length_squared();
    let normal = ray.direction.cross(toward);
    let size = bounds.min.abs().max(bounds.max.abs()).max(lamp.abs()).max(ray.origin.abs()).max_element();
    let height = square.sqrt();
    if !(height > LOW * size && size.is_finite()) {
        return Some(Range::LINE);
    }
    let ends = |low: f64, high: f64| Range { min: low, max: high };
    let (mut off, mut near, mut along) = (Range::EMPTY, Range::EMPTY, Range::EMPTY);
    for corner in bounds.corners() {
        let corner = corner - lamp;
        let (aside, rise) = (corner.dot(normal), corner.dot(toward));
        let place = corner.dot(ray.direction) / rise;
        off = ends(off.min.min(aside), off.max.max(aside));
        near = ends(near.min.min(rise), near.max.max(rise));
        along = ends(along.min.min(place), along.max.max(place));
    }
    let room = BLUR * size * height;
    let beside = off.min > room || off.max < -room;
    if beside || near.max < -room || near.min > square + room {
        return None;
    }
    if near.min < LOW * size * height {
        // A box around the lamp may throw its shadow anywhere.
        return Some(Range::LINE);
    }
    let spread = |place: f64| BLUR * (size + (square * place).abs());
    Some(Range {
        min: foot + square * along.min - spread(along.min),
        max: foot + square * along.max + spread(along.max),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn a_point_that_a_box_may_darken_is_never_left_out() {
        let mut number = numbers(3);
        let (mut bounded, mut never) = (0, 0);
        for _ in 0..4000 {
            let mut point = || 4.0 * DVec3::new(number(), number(), number());
            let (origin, lamp, center, direction) = (point(), point(), point(), point().normalize());
            let half = point().abs() * 0.3;
            let bounds = Bounds::new(center - half, center + half);
            let ray = Ray::new(origin, direction);
            let found = shade(&bounds, &ray, lamp);
            bounded += u32::from(found.is_some_and(|range| range.max - range.min < 4.0));
            never += u32::from(found.is_none());
            for s in (-40..=40).map(|s| f64::from(s) / 8.0) {
                let between = (0..=60).any(|t| bounds.contains(lamp.lerp(ray.at(s), f64::from(t) / 60.0)));
                let said = found.is_some_and(|range| range.contains(s));
                assert!(said || !between, "{s}: {ray:?} {lamp} {bounds:?} {found:?}");
            }
        }
        assert!(bounded > 300 && never > 1000, "{bounded} {never}");
    }
}
