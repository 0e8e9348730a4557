//! What is inside a height field along lines.
//!
//! Its border is more than its surface: where only a part of a cell is under water, and at the sides.

use super::HeightField;
use crate::math::{Band, Lanes};
use crate::world::shape::uncrossed;
use crate::world::{Range, Ray};

/// So many cells are looked at one by one.
const LOOKED_AT: f64 = 16.0;

impl HeightField {
    /// What holds whether points are inside: of lines that keep away from all cells, or of what is over few
    /// cells.
    pub(super) fn inside_of_grid(&self, point: &[Band; 3]) -> Band {
        let far = uncrossed::inside_unless(self, |ray, range| self.is_near(ray, range), point);
        if far.reach == Lanes::ZERO {
            return far;
        }
        let near = Band::by_lanes(*point, |point| self.inside_of_cells(point));
        near.where_positive(far.reach, far)
    }

    /// Whether a part of a ray comes near the surface, or passes a side or the water's height.
    fn is_near(&self, ray: &Ray, range: Range) -> bool {
        let [from, to] = [ray.at(range.min), ray.at(range.max)];
        let (low, high) = (from.min(to), from.max(to));
        let sides = [(low.x, high.x), (low.z, high.z)];
        let passes = |(low, high): (f64, f64), at: f64| low <= at && at <= high;
        if passes((low.y, high.y), self.water) || sides.iter().any(|&s| passes(s, 0.0) || passes(s, 1.0)) {
            return true;
        }
        let mut near = false;
        if let Some(way) = self.way(ray, range) {
            self.cells.along(&way, range.max, |_, _| {
                near = true;
                f64::NEG_INFINITY
            });
        }
        near
    }

    /// What holds whether points are inside, the same in all lanes.
    fn inside_of_cells(&self, [x, y, z]: [Band; 3]) -> Band {
        let [no, yes] = [Band::constant(0.0), Band::constant(1.0)];
        let ends = |band: Band| [band.low().0[0], band.high().0[0]];
        let across = [x * (self.size[0] - 1) as f64, z * (self.size[1] - 1) as f64];
        let [[bottom, top], columns, rows] = [y, across[0], across[1]].map(ends);
        let last = self.size.map(|samples| (samples - 2) as f64);
        let beside = |[low, high]: [f64; 2], last: f64| high < 0.0 || low >= last + 1.0;
        if beside(columns, last[0]) || beside(rows, last[1]) || bottom >= self.bounds.max.y {
            return no;
        }
        let within = |[low, high]: [f64; 2], last: f64| low >= 0.0 && high < last + 1.0;
        let around = match within(columns, last[0]) && within(rows, last[1]) {
            true if top < self.bounds.min.y => return yes,
            true => None,
            false => Some(no),
        };
        let cells = |[low, high]: [f64; 2], last: f64| [low, high].map(|c| c.floor().clamp(0.0, last));
        let [columns, rows] = [cells(columns, last[0]), cells(rows, last[1])];
        let count = (columns[1] - columns[0] + 1.0) * (rows[1] - rows[0] + 1.0);
        // What is no number is anywhere.
        if count > LOOKED_AT || count.is_nan() {
            return Band::between(0.0, 1.0);
        }
        let numbers = |[from, to]: [f64; 2]| from as usize..=to as usize;
        let cells = numbers(rows).flat_map(|row| numbers(columns).map(move |column| (column, row)));
        cells
            .map(|(column, row)| self.inside_of_cell([column, row], [across[0], y, across[1]]))
            .chain(around)
            .reduce(Band::hull)
            .unwrap_or(no)
    }

    /// The same for those over one cell, of points whose x and z are in cells.
    fn inside_of_cell(&self, [column, row]: [usize; 2], [x, y, z]: [Band; 3]) -> Band {
        let (u, v) = (x - column as f64, z - row as f64);
        let height = |x: usize, z: usize| Band::constant(self.height_over_water(x, z));
        let (across, along) = (height(column + 1, row), height(column, row + 1));
        let is_below = |surface: Band| y.less(surface);
        let corner = height(column, row);
        let near = is_below(corner + u * (across - corner) + v * (along - corner));
        let corner = height(column + 1, row + 1);
        let far = is_below(corner + (-u + 1.0) * (along - corner) + (-v + 1.0) * (across - corner));
        let diagonal = u + v - 1.0;
        near.where_positive(-diagonal.high(), far.where_positive(diagonal.low(), near.hull(far)))
    }
}
