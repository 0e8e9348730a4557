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
        let across = |side: DVec3| DVec3::AXES.map(|axis| side.cross(axis));
        let [[a, b, c], [d, e, f], [g, h, i]] = sides.map(across);
        let axes = [sides[0].cross(sides[1]), a, b, c, d, e, f, g, h, i].map(|axis| {
            let mut span = [f64::INFINITY, f64::NEG_INFINITY];
            for point in &points {
                let place = point.dot(axis);
                span = [span[0].min(place), span[1].max(place)];
            }
            (axis, span)
        });
        Self { bounds: Bounds::of(points.iter().copied()), axes, points }
    }

    /// The points it was made of.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// The hull moved and scaled by `inner`, an affine map that doesn't turn.
    pub(super) fn mapped(&self, inner: impl Fn(DVec3) -> DVec3) -> Self {
        Self::new(self.points.iter().map(|&point| inner(point)).collect())
    }

    /// Whether the hull may share a point with the box.
    pub fn meets(&self, bounds: &Bounds) -> bool {
        let blur = BLUR * self.bounds.min.abs().max(self.bounds.max.abs()).max_element();
        let low = self.bounds.min - blur;
        let high = self.bounds.max + blur;
        if low.cmpgt(bounds.max).any() || high.cmplt(bounds.min).any() {
            return false;
        }
        if !bounds.is_finite() {
            return true;
        }
        let (center, half) = (bounds.center(), bounds.size() / 2.0);
        let blur = blur + BLUR * center.abs().max_element();
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

    #[test]
    fn a_box_that_a_segment_of_the_triangle_meets_is_never_missed() {
        let mut state = 7_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5
        };
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
