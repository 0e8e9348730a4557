//! `triangular`: a floor of triangles in six colours (docs/spec/patterns-textures.md 2.6).

use super::along::{BESIDE, on_floor};
use crate::math::{Band, DVec3};

pub(super) fn value(p: DVec3) -> f64 {
    let height = 3_f64.sqrt();
    let mut x = p.x - 3.0 * (p.x / 3.0).floor();
    let mut z = p.z - height * (p.z / height).floor();
    let column = x.floor();
    x -= column;
    let upper = z >= height / 2.0;
    if upper {
        z = height - z;
    }
    let base = if x == 0.0 || 1.0 - x == 0.0 {
        1.0
    } else {
        match (z / x < height, z / (1.0 - x) < height) {
            (true, true) => 0.0,
            (false, true) => 1.0,
            (true, false) => 3.0,
            // Above both edges: only rounding leads here, at the tip.
            (false, false) => 0.0,
        }
    };
    color(base, column, upper)
}

/// The colour of what is over an edge, or none, of the upright triangle in a column.
fn color(base: f64, column: f64, upper: bool) -> f64 {
    let turned = if base % 2.0 == 1.0 { base + 2.0 * column } else { 6.0 + base - 2.0 * column };
    let value = turned.rem_euclid(6.0);
    if upper { 5.0 - value } else { value }
}

/// What holds the values at all points that these hold.
pub(super) fn along(p: &[Band; 3]) -> Band {
    let half_row = 0.5 * 3_f64.sqrt();
    on_floor([p[0], p[2] * (1.0 / half_row)], [0.0, 5.0], |[a, b], [column, row]| {
        let upper = row.rem_euclid(2.0) == 1.0;
        let (x, v) = (a - column, b - row);
        let height = if upper { -v + 1.0 } else { v };
        // Above the edge that rises from the left corner, and above that from the right one.
        let may = |rise: Band| [rise.low().0[0] < BESIDE, rise.high().0[0] > -BESIDE];
        let ([under_left, over_left], [under_right, over_right]) =
            (may(height - x * 2.0), may(height + x * 2.0 - 2.0));
        let bases = [
            (under_left && under_right || over_left && over_right, 0.0),
            (over_left && under_right, 1.0),
            (under_left && over_right, 3.0),
        ];
        let found = bases.into_iter().filter(|(may, _)| *may);
        let found = found.map(|(_, base)| color(base, column.rem_euclid(3.0), upper));
        let [low, high] = found.fold([5.0, 0.0], |[low, high]: [f64; 2], v| [low.min(v), high.max(v)]);
        Band::between(low, high)
    })
}
