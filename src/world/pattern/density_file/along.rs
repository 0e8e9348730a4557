//! Voxels along lines: bounds of their values.

use super::{DensityFile, Interpolation};
use crate::math::{Band, Lanes};

/// So many voxels are looked at one by one.
const VOXELS: f64 = 4096.0;

/// Beside the border of a voxel either is meant.
const ROOM: f64 = 1e-9;

/// How far beyond the voxels around it the `tricubic` interpolation goes, as a share of their range: along each axis
/// its negative weights are an eighth, so values are (1 + 1/4)³ as far apart.
const BEYOND: f64 = 0.5 * (1.25 * 1.25 * 1.25 - 1.0);

/// More than single precision takes from interpolated values, as a share of the largest.
const ROUNDING: f64 = 64.0 * f32::EPSILON as f64;

impl DensityFile {
    /// What holds the values at all points that these hold.
    pub(in crate::world::pattern) fn along(&self, p: &[Band; 3]) -> Band {
        let size = self.size.map(|s| s as f64);
        Band::by_lanes(*p, |p| {
            let at = [0, 1, 2].map(|i| p[i] * size[i]);
            let from = at.map(|c| c.low().0[0] - ROOM);
            let to = at.map(|c| c.high().0[0] + ROOM);
            let axes = 0..3;
            if axes.clone().any(|i| to[i] < 0.0 || from[i] >= size[i]) {
                return Band::constant(0.0);
            }
            let inside = axes.clone().all(|i| from[i] >= 0.0 && to[i] < size[i]);
            let first = from.map(|c| c.max(0.0).floor());
            let last = [0, 1, 2].map(|i| to[i].min(size[i] - 1.0).floor());
            let is_single = first == last;
            let shown = if is_single && self.interpolation != Interpolation::Nearest {
                self.in_voxel(first.map(|c| c as usize), [0, 1, 2].map(|i| at[i] - first[i]))
            } else {
                let [low, high] = self.over(first, last);
                Band::between(low, high)
            };
            if inside { shown } else { shown.hull(Band::constant(0.0)) }
        })
    }

    /// What all values in these voxels are between.
    fn over(&self, first: [f64; 3], last: [f64; 3]) -> [f64; 2] {
        let [low, high] = self.around(first, last);
        let beyond = if self.interpolation == Interpolation::Tricubic { BEYOND } else { 0.0 };
        let room = beyond * (high - low) + ROUNDING * high;
        [(low - room).max(0.0), high + room]
    }

    /// What all voxels are between that count for values in these.
    fn around(&self, first: [f64; 3], last: [f64; 3]) -> [f64; 2] {
        let (before, behind) = match self.interpolation {
            Interpolation::Nearest => (0, 0),
            Interpolation::Trilinear => (0, 1),
            Interpolation::Tricubic => (1, 2),
        };
        let counts = [0, 1, 2].map(|i| last[i] - first[i] + 1.0 + f64::from(before + behind));
        // What is no number is no small one either.
        let few = counts.iter().product::<f64>() <= VOXELS;
        if !few {
            return [0.0, 1.0];
        }
        let [columns, rows, layers] = [0, 1, 2].map(|i| {
            let start = (first[i] as usize).wrapping_sub(before as usize);
            (0..counts[i] as usize).map(move |step| start.wrapping_add(step))
        });
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for k in layers {
            for j in rows.clone() {
                for i in columns.clone() {
                    let v = self.voxel(i, j, k);
                    (low, high) = (low.min(v), high.max(v));
                }
            }
        }
        [low, high]
    }

    /// The value in one voxel, the same in all lanes.
    fn in_voxel(&self, [i, j, k]: [usize; 3], part: [Band; 3]) -> Band {
        let voxel = |i, j, k| Band::numbers(Lanes::splat(self.voxel(i, j, k)));
        let [x, y, z] = part;
        let place = [i, j, k].map(|c| c as f64);
        let [low, high] = self.over(place, place);
        let between = match self.interpolation {
            Interpolation::Nearest => voxel(i, j, k),
            Interpolation::Trilinear => {
                let mix = |a: Band, b: Band, t: Band| a + (b - a) * t;
                let row = |j, k| mix(voxel(i, j, k), voxel(i + 1, j, k), x);
                let layer = |k| mix(row(j, k), row(j + 1, k), y);
                mix(layer(k), layer(k + 1), z)
            }
            Interpolation::Tricubic => {
                let four = |c: usize| [c.wrapping_sub(1), c, c + 1, c + 2];
                let column = |i, j| spline(four(k).map(|k| voxel(i, j, k)), z);
                let row = |i| spline(four(j).map(|j| column(i, j)), y);
                let value = spline(four(i).map(row), x);
                let room = ROUNDING * self.around(place, place)[1];
                (value + Band::between(-room, room)).max(Band::constant(0.0))
            }
        };
        // Over a long stretch the bounds say more.
        if between.spread().0[0] < 0.5 * (high - low) { between } else { Band::between(low, high) }
    }
}

fn spline([a, b, c, d]: [Band; 4], t: Band) -> Band {
    let (m, n) = ((c - a) * 0.5, (d - b) * 0.5);
    let fall = b - c;
    let cubic = fall * 2.0 + m + n;
    let square = fall * -3.0 - m * 2.0 - n;
    ((cubic * t + square) * t + m) * t + b
}
