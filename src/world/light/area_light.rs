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
    /// What of the grid is the same everywhere.
    pub plan: Plan,
}

/// What is known of a grid before anybody looks at it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    /// Where the lights are when they aren't moved, in parts of the axes, row by row.
    pub places: Vec<DVec2>,
    /// The share of each in the whole, where all parts are refined whatever is seen; empty otherwise.
    pub shares: Vec<f32>,
}

/// Up to this many lights a grid is planned.
const PLANNED: u32 = 1 << 12;

impl Plan {
    /// The plan of a grid of so many lights.
    pub fn new(size: [u32; 2], adaptive: u32, circular: bool) -> Self {
        let [columns, rows] = size;
        let count = columns.saturating_mul(rows);
        let mut shares = vec![0.0; if count <= PLANNED { count as usize } else { 0 }];
        let whole = [[0, columns.saturating_sub(1)], [0, rows.saturating_sub(1)]];
        if shares.is_empty() || !share_out(&mut shares, columns, whole, adaptive, 1.0) {
            return Self::default();
        }
        let place = |index: u32| place(size, circular, (index % columns, index / columns), DVec2::ZERO);
        Self { places: (0..count).map(place).collect(), shares }
    }
}

/// Gives a part of a grid its share of the light; false where it depends on what is seen.
fn share_out(shares: &mut [f32], columns: u32, [u, v]: [[u32; 2]; 2], levels: u32, share: f32) -> bool {
    let quarter = share / 4.0;
    if u[1] - u[0] > 1 || v[1] - v[0] > 1 {
        let mut refine = |part| share_out(shares, columns, part, levels - 1, quarter);
        return levels > 0 && AreaLight::quarters(u, v).into_iter().all(&mut refine);
    }
    for (u, v) in [(u[0], v[0]), (u[1], v[0]), (u[0], v[1]), (u[1], v[1])] {
        shares[(v * columns + u) as usize] += quarter;
    }
    true
}

/// Where light (u, v) of a grid is, in parts of the axes; `shift` moves it by parts of a cell.
fn place(size: [u32; 2], circular: bool, (u, v): (u32, u32), shift: DVec2) -> DVec2 {
    let along = |index: u32, shift: f64, size: u32| {
        if size > 1 { (f64::from(index) + shift) / f64::from(size - 1) - 0.5 } else { 0.0 }
    };
    let place = DVec2::new(along(u, shift.x, size[0]), along(v, shift.y, size[1]));
    if !circular {
        return place;
    }
    let DVec2 { x, y } = place + CIRCULAR_SHIFT;
    // A square ring of the grid becomes a round one.
    DVec2::new(x, y) * (x.abs().max(y.abs()) / DVec2::new(x, y).length())
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
        let (a, b) = (self.axes[0].length(), self.axes[1].length());
        let (u, v) = (self.reach(0), self.reach(1));
        // Turned grids have axes at right angles.
        match (self.orient, self.circular) {
            (true, true) => a.max(b) * u.max(v),
            (true, false) => (a * u).hypot(b * v),
            (false, true) => a.hypot(b) * u.max(v),
            (false, false) => self.corners(self.axes).into_iter().map(DVec3::length).fold(0.0, f64::max),
        }
    }

    /// Corners around all lights of the grid, relative to the light's location, jitter included.
    pub fn corners(&self, axes: [DVec3; 2]) -> [DVec3; 4] {
        let (x, y) = (axes[0] * self.reach(0), axes[1] * self.reach(1));
        [x + y, -x - y, x - y, y - x]
    }

    /// How far lights may be from the middle, in units of an axis.
    pub fn reach(&self, axis: usize) -> f64 {
        let size = self.size[axis];
        let cell = if self.jitter && size > 1 { 0.5 / f64::from(size - 1) } else { 0.0 };
        0.5 + cell + CIRCULAR_SHIFT
    }

    /// The least number of rays that a point takes whatever they find, all told.
    pub fn least_rays(&self) -> u32 {
        let along = |size: u32| size.min((1_u32 << self.adaptive.min(16)) + 1);
        along(self.size[0]).saturating_mul(along(self.size[1]))
    }

    /// Where light (u, v) of the grid is, in parts of the axes; `shift` moves it by parts of a cell.
    pub fn place(&self, place_of: (u32, u32), shift: DVec2) -> DVec2 {
        place(self.size, self.circular, place_of, shift)
    }

    /// The same, relative to the light's location.
    pub fn offset(&self, axes: [DVec3; 2], place: (u32, u32), shift: DVec2) -> DVec3 {
        let DVec2 { x, y } = self.place(place, shift);
        axes[0] * x + axes[1] * y
    }

    /// The parts that a part is cut into, by the indices of their corners.
    pub fn quarters(u: [u32; 2], v: [u32; 2]) -> [[[u32; 2]; 2]; 4] {
        let low = |[a, b]: [u32; 2]| [a, (a + b) / 2];
        let high = |[a, b]: [u32; 2]| [(a + b).div_ceil(2), b];
        [[low(u), low(v)], [high(u), low(v)], [low(u), high(v)], [high(u), high(v)]]
    }
}
