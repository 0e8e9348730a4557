//! `hexagon`: a floor of hexagons in three colours (docs/spec/patterns-textures.md 2.6).

use crate::math::DVec3;

pub(super) fn value(p: DVec3) -> f64 {
    // Fold the plane, then find the cell of a grid in which every hexagon's edge is a diagonal.
    let x = p.x.abs();
    let z = if p.z < 0.0 { 5.196152424 - p.z.abs() } else { p.z };
    let wrapped = |c: f64| c - 6.0 * (c / 6.0).floor();
    let (a, b) = (wrapped(x * 2.0), wrapped(z / 0.866025404));
    let (i, j) = (a.floor(), b.floor());
    let column = (i as usize).min(5);
    let row = (j as usize).min(5);
    let values: [u8; 6] = match column {
        0 | 5 => [0, 1, 1, 2, 2, 0],
        2 | 3 => [2, 2, 0, 0, 1, 1],
        _ => {
            let mut u = a - i;
            if (column + row) % 2 == 1 {
                u = 1.0 - u;
            }
            if u == 0.0 {
                u = 0.0001;
            }
            if (b - j) / u < 1.0 { [0, 2, 1, 0, 2, 1] } else { [2, 1, 0, 2, 1, 0] }
        }
    };
    f64::from(values[row])
}
