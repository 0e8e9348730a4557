//! Every box in turn: the fastest way for a handful, and the yardstick for the others.

use super::Hull;
use crate::math::{Bounds, DVec3, tally};
use crate::world::ray::{Range, Ray};

/// A list of boxes.
#[derive(Debug, Default)]
pub struct Linear {
    items: Vec<(Bounds, u32)>,
}

impl Linear {
    /// Takes the items in any order; boxes may be unbounded.
    pub fn new(items: Vec<(Bounds, u32)>) -> Self {
        Self { items }
    }

    /// See [`Accel::along`](super::Accel::along).
    #[inline(always)]
    pub fn along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> f64) {
        let slabs = Slabs::new(ray);
        let mut range = range;
        for (bounds, item) in &self.items {
            if slabs.meet(bounds, range) {
                range.max = visit(*item);
                if range.max == f64::NEG_INFINITY {
                    return;
                }
            }
        }
    }

    /// See [`Accel::any_touching`](super::Accel::any_touching).
    pub fn any_touching(&self, hull: &Hull, mut test: impl FnMut(u32) -> bool) -> bool {
        self.items.iter().any(|(bounds, item)| hull.meets(bounds) && test(*item))
    }

    /// See [`Accel::any_around`](super::Accel::any_around).
    pub fn any_around(&self, point: DVec3, mut test: impl FnMut(u32) -> bool) -> bool {
        self.items.iter().any(|(bounds, item)| bounds.contains(point) && test(*item))
    }
}

/// A ray prepared for being tested against boxes; a fourth axis fills up wide registers.
#[derive(Clone, Copy, Debug)]
pub struct Slabs {
    origin: [f64; 4],
    /// The sign tells whether the ray meets the high faces first.
    inverse: [f64; 4],
}

/// A slab's distance is off by at most three roundings.
const SLACK: f64 = 4.0 * f64::EPSILON;

impl Slabs {
    /// Prepares a ray.
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        let (origin, direction) = (four(ray.origin), four(ray.direction));
        let mut inverse = [1.0; 4];
        for axis in 0..4 {
            inverse[axis] = 1.0 / direction[axis];
        }
        Self { origin, inverse }
    }

    /// Whether the box and the part of the ray in `range` share a point, or nearly so.
    #[inline(always)]
    pub fn meet(&self, bounds: &Bounds, range: Range) -> bool {
        self.entry(bounds, range).is_some()
    }

    /// Where the ray enters a box that it meets in `range`; behind its origin if it starts inside.
    #[inline(always)]
    pub fn entry(&self, bounds: &Bounds, range: Range) -> Option<f64> {
        self.overlap_in(bounds, range).map(|(entry, _)| entry)
    }

    /// Where the line enters a box that the ray meets in `range` and where it leaves.
    #[inline(always)]
    pub fn overlap_in(&self, bounds: &Bounds, range: Range) -> Option<(f64, f64)> {
        tally::boxes(1);
        let (entry, exit) = self.overlap(bounds);
        let near = if entry > range.min { entry } else { range.min };
        let far = if exit < range.max { exit } else { range.max };
        Self::in_reach(near, far).then_some((entry, exit))
    }

    /// Whether what begins at `entry` begins before `end`, or as good as there.
    #[inline(always)]
    pub(super) fn in_reach(entry: f64, end: f64) -> bool {
        entry - entry.abs() * SLACK <= end + end.abs() * SLACK
    }

    /// Where the line enters the box and where it leaves; the wrong way round for a miss.
    #[inline(always)]
    fn overlap(&self, bounds: &Bounds) -> (f64, f64) {
        let (low, high) = (bounds.min.to_array(), bounds.max.to_array());
        let (mut entry, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            let (o, inverse) = (self.origin[axis], self.inverse[axis]);
            let backward = inverse.is_sign_negative();
            let (first, last) = if backward { (high[axis], low[axis]) } else { (low[axis], high[axis]) };
            let (near, far) = ((first - o) * inverse, (last - o) * inverse);
            // 0 * infinity is no number: the ray lies in the plane of the face, which bounds nothing.
            entry = if near > entry { near } else { entry };
            exit = if far < exit { far } else { exit };
        }
        (entry, exit)
    }
}

#[inline(always)]
fn four(v: DVec3) -> [f64; 4] {
    [v.x, v.y, v.z, 1.0]
}
