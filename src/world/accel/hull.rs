//! A hull of points, tested against boxes: what lies around a bundle of rays.

use smallvec::SmallVec;

use crate::math::wide::widest;
use crate::math::{Bounds, DVec3, Lanes};

/// Distances by which shapes miss each other less than this, relative to the coordinates, may be
/// the work of rounding.
const BLUR: f64 = 1e-12;

/// The points of a hull.
pub type Points = SmallVec<[DVec3; 20]>;

/// The convex hull of a few points around the triangle of the first three.
#[derive(Clone, Debug)]
pub struct Hull<'a> {
    points: &'a [DVec3],
    bounds: Bounds,
    /// Directions in which the hull may be apart from a box that its own bounds meet, and from where to
    /// where it reaches along them.
    axes: [Axes; GROUPS],
}

/// Four directions and from where to where a hull reaches along them.
#[derive(Clone, Copy, Debug)]
struct Axes {
    direction: [Lanes; 3],
    reach: [Lanes; 2],
}

/// Ten directions are three times four; along those that are missing, of no length, nothing is apart.
const GROUPS: usize = 3;

impl<'a> Hull<'a> {
    /// The hull of at least three finite points.
    pub fn new(points: &'a [DVec3]) -> Self {
        widest(
            #[inline(always)]
            || Self::of(points),
        )
    }

    #[inline(always)]
    fn of(points: &'a [DVec3]) -> Self {
        let sides = [points[1] - points[0], points[2] - points[0], points[2] - points[1]];
        let across = sides[0].cross(sides[1]).to_array();
        let nothing = Axes {
            direction: [Lanes::ZERO; 3],
            reach: [Lanes::splat(f64::INFINITY), Lanes::splat(f64::NEG_INFINITY)],
        };
        let mut axes = [nothing; GROUPS];
        // Loops throughout: closures for arrays are not compiled together with what is around them.
        for (group, side) in sides.into_iter().enumerate() {
            let [x, y, z] = &mut axes[group].direction;
            let normal = if group == 0 { across } else { [0.0; 3] };
            *x = Lanes([normal[0], 0.0, -side.z, side.y]);
            *y = Lanes([normal[1], side.z, 0.0, -side.x]);
            *z = Lanes([normal[2], -side.y, side.x, 0.0]);
        }
        let mut bounds = Bounds::EMPTY;
        for &point in points {
            bounds = Bounds { min: bounds.min.min(point), max: bounds.max.max(point) };
            for Axes { direction: [x, y, z], reach: [low, high] } in &mut axes {
                let place = *x * point.x + *y * point.y + *z * point.z;
                *low = place.lesser(*low);
                *high = place.greater(*high);
            }
        }
        Self { bounds, axes, points }
    }

    /// The points it was made of.
    pub fn points(&self) -> &'a [DVec3] {
        self.points
    }

    /// The box outside of which the hull meets nothing.
    pub(super) fn around(&self) -> Bounds {
        let blur = self.blur();
        Bounds { min: self.bounds.min - blur, max: self.bounds.max + blur }
    }

    /// By how much rounding may have moved the points.
    #[inline]
    fn blur(&self) -> f64 {
        BLUR * self.bounds.min.abs().max(self.bounds.max.abs()).max_element()
    }

    /// Whether the hull may share a point with the box.
    pub fn meets(&self, bounds: &Bounds) -> bool {
        widest(
            #[inline(always)]
            || self.reaches(bounds),
        )
    }

    #[inline(always)]
    fn reaches(&self, bounds: &Bounds) -> bool {
        let Bounds { min: low, max: high } = self.around();
        if low.cmpgt(bounds.max).any() || high.cmplt(bounds.min).any() {
            return false;
        }
        if !bounds.is_finite() {
            return true;
        }
        let center = bounds.center();
        let blur = self.blur() + BLUR * center.abs().max_element();
        // No direction is longer than the sum of its components.
        let half = bounds.size() / 2.0 + blur;
        for Axes { direction: [x, y, z], reach: [low, high] } in &self.axes {
            let reach = x.abs() * half.x + y.abs() * half.y + z.abs() * half.z;
            let place = *x * center.x + *y * center.y + *z * center.z;
            let gap = (*low - place).greater(place - *high);
            if (gap - reach).bits(|gap| gap > 0.0) != 0 {
                return false;
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn a_box_that_a_segment_of_the_triangle_meets_is_never_missed() {
        let mut number = numbers(7);
        let mut missed = 0;
        for _ in 0..2000 {
            let mut point = || DVec3::new(number(), number(), number());
            let (a, b, light) = (4.0 * point(), 4.0 * point(), 4.0 * point());
            let points = [a, b, light];
            let hull = Hull::new(&points);
            let center = 3.0 * point();
            let half = point().abs() * 0.8;
            let bounds = Bounds::new(center - half, center + half);
            let steps = || (0..=20).map(|step| f64::from(step) / 20.0);
            let met = steps().any(|u| steps().any(|v| bounds.contains(a.lerp(b, u).lerp(light, v))));
            assert!(!met || hull.meets(&bounds), "{a} {b} {light} {bounds:?}");
            missed += u32::from(!hull.meets(&bounds));
        }
        assert!(missed > 500, "{missed}");
    }
}
