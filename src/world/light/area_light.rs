//! `area_light`: a grid of lights (docs/spec/shading.md 17).

use crate::math::{DVec2, DVec3};

/// Keeps the middle of a `circular` grid from being divided by zero.
const CIRCULAR_SHIFT: f64 = 0.001;

/// A grid of lights around the light's location.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaLight {
    /// The two edges.
    pub axes: [DVec3; 2],
    /// Lights along each edge, at least 1.
    pub size: [u32; 2],
    /// Level up to which the grid is always refined.
    pub adaptive: u32,
    /// Lights are moved at random within their cell.
    pub jitter: bool,
    /// A disc instead of a rectangle.
    pub circular: bool,
    /// Always turned towards the lit point.
    pub orient: bool,
    /// Diffuse and highlights use the grid too.
    pub area_illumination: bool,
}

impl AreaLight {
    /// The edges as seen from a point to which the light's middle lies in `direction`.
    pub fn axes_towards(&self, direction: DVec3) -> [DVec3; 2] {
        if !self.orient {
            return self.axes;
        }
        let helper = if direction.z.abs() > 0.99 { DVec3::Y } else { DVec3::Z };
        let first = direction.cross(helper).normalize_or_zero();
        let second = direction.cross(first).normalize_or_zero();
        [first * self.axes[0].length(), second * self.axes[1].length()]
    }

    /// No light of the grid is farther from the middle than this, jitter included.
    pub fn radius(&self) -> f64 {
        self.axes[0].length() * self.reach(0) + self.axes[1].length() * self.reach(1)
    }

    /// Corners around all lights of the grid, relative to the light's location, jitter included.
    pub fn corners(&self, axes: [DVec3; 2]) -> [DVec3; 4] {
        let (x, y) = (axes[0] * self.reach(0), axes[1] * self.reach(1));
        [x + y, -x - y, x - y, y - x]
    }

    /// How far lights may be from the middle, in units of an axis.
    fn reach(&self, axis: usize) -> f64 {
        let size = self.size[axis];
        let cell = if self.jitter && size > 1 { 0.5 / f64::from(size - 1) } else { 0.0 };
        0.5 + cell + CIRCULAR_SHIFT
    }

    /// The least number of rays that a point takes whatever they find, all told.
    pub fn least_rays(&self) -> u32 {
        let along = |size: u32| size.min((1_u32 << self.adaptive.min(16)) + 1);
        along(self.size[0]).saturating_mul(along(self.size[1]))
    }

    /// Where light (u, v) of the grid is, relative to the light's location; `shift` moves it by
    /// parts of a cell.
    pub fn offset(&self, axes: [DVec3; 2], (u, v): (u32, u32), shift: DVec2) -> DVec3 {
        let place = |index: u32, shift: f64, size: u32| {
            if size > 1 { (f64::from(index) + shift) / f64::from(size - 1) - 0.5 } else { 0.0 }
        };
        let mut x = place(u, shift.x, self.size[0]);
        let mut y = place(v, shift.y, self.size[1]);
        if self.circular {
            x += CIRCULAR_SHIFT;
            y += CIRCULAR_SHIFT;
            // A square ring of the grid becomes a round one.
            let round = x.abs().max(y.abs()) / x.hypot(y);
            x *= round;
            y *= round;
        }
        axes[0] * x + axes[1] * y
    }
}
