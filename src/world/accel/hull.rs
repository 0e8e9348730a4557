//! A hull of points, tested against boxes: what lies around a bundle of rays.

use smallvec::SmallVec;

use crate::math::{Bounds, DVec3};

/// Distances by which shapes miss each other less than this, relative to the coordinates, may be
/// the work of rounding.
const BLUR: f64 = 1e-12;

/// The points of a hull.
pub type Points = SmallVec<[DVec3; 20]>;

/// The convex hull of a few points around the triangle of the first three.
#[derive(Clone, Debug)]
pub struct Hull {
    points: Points,
    bounds: Bounds,
    /// Directions in which the hull may be apart from a box that its own bounds meet, and from where to
    /// where it reaches along them.
    axes: [(DVec3, [f64; 2]); 10],
}

impl Hull {
    /// The hull of at least three finite points.
    pub fn new(points: Points) -> Self {
        let sides = [points[1] - points[0], points[2] - points[0], points[2] - points[1]];
        let mut axes = [(sides[0].cross(sides[1]), [f64::INFINITY, f64::NEG_INFINITY]); 10];
        // Loops throughout: closures for arrays are not compiled together with what is around them.
        for (number, side) in sides.into_iter().enumerate() {
            axes[3 * number + 1].0 = DVec3::new(0.0, side.z, -side.y);
            axes[3 * number + 2].0 = DVec3::new(-side.z, 0.0, side.x);
            axes[3 * number + 3].0 = DVec3::new(side.y, -side.x, 0.0);
        }
        let mut bounds = Bounds::EMPTY;
        for &point in &points {
            bounds = Bounds { min: bounds.min.min(point), max: bounds.max.max(point) };
            for (axis, [low, high]) in &mut axes {
                let place = point.dot(*axis);
                *low = if place < *low { place } else { *low };
                *high = if place > *high { place } else { *high };
            }
        }
        Self { bounds, axes, points }
    }

    /// The points it was made of.
    pub fn points(&self) -> &[DVec3] {
        &self.points
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

    /// The hull moved and scaled by `inner`, an affine map that doesn't turn.
    pub(super) fn mapped(&self, inner: impl Fn(DVec3) -> DVec3) -> Self {
        Self::new(self.points.iter().map(|&point| inner(point)).collect())
    }

    /// Whether the hull may share a point with the box.
    pub fn meets(&self, bounds: &Bounds) -> bool {
        let Bounds { min: low, max: high } = self.around();
        if low.cmpgt(bounds.max).any() || high.cmplt(bounds.min).any() {
            return false;
        }
        if !bounds.is_finite() {
            return true;
        }
        let (center, half) = (bounds.center(), bounds.size() / 2.0);
        let blur = self.blur() + BLUR * center.abs().max_element();
        self.axes.iter().all(|(axis, [low, high])| {
            let size = axis.abs();
            // No axis is longer than the sum of its components.
            let reach = half.dot(size) + blur * size.element_sum();
            let place = center.dot(*axis);
            !(*low > place + reach || *high < place - reach)
        })
    }
}

#[cfg(test)]
mod tests {
    use smallvec::smallvec;

    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn a_box_that_a_segment_of_the_triangle_meets_is_never_missed() {
        let mut number = numbers(7);
        let mut missed = 0;
        for _ in 0..2000 {
            let mut point = || DVec3::new(number(), number(), number());
            let (a, b, light) = (4.0 * point(), 4.0 * point(), 4.0 * point());
            let hull = Hull::new(smallvec![a, b, light]);
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
