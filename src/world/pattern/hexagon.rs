//! `hexagon`: a floor of hexagons in three colours (docs/spec/patterns-textures.md 2.6).

use super::along::{BESIDE, on_floor};
use crate::math::{Band, DVec3};

/// A cell of the grid is so many times as high as it is wide.
const HEIGHT: f64 = 0.866025404;

/// The grid repeats after so many cells.
const PERIOD: f64 = 6.0;

pub(super) fn value(p: DVec3) -> f64 {
    // Fold the plane, then find the cell of a grid in which every hexagon's edge is a diagonal.
    let x = p.x.abs();
    let z = if p.z < 0.0 { 5.196152424 - p.z.abs() } else { p.z };
    let wrapped = |c: f64| c - PERIOD * (c / PERIOD).floor();
    let (a, b) = (wrapped(x * 2.0), wrapped(z / HEIGHT));
    let (i, j) = (a.floor(), b.floor());
    let (column, row) = ((i as usize).min(5), (j as usize).min(5));
    let [below, above] = colors(column, row);
    if below == above {
        return f64::from(below);
    }
    let mut u = a - i;
    if (column + row) % 2 == 1 {
        u = 1.0 - u;
    }
    if u == 0.0 {
        u = AT_SIDE;
    }
    f64::from(if (b - j) / u < 1.0 { below } else { above })
}

/// Stands for 0 where it would be divided by.
const AT_SIDE: f64 = 0.0001;

/// The colours of a cell below and above its diagonal.
fn colors(column: usize, row: usize) -> [u8; 2] {
    let [below, above]: [[u8; 6]; 2] = match column {
        0 | 5 => [[0, 1, 1, 2, 2, 0]; 2],
        2 | 3 => [[2, 2, 0, 0, 1, 1]; 2],
        _ => [[0, 2, 1, 0, 2, 1], [2, 1, 0, 2, 1, 0]],
    };
    [below[row], above[row]]
}

/// What holds the values at all points that these hold. That the plane is folded at z = 0 changes nothing:
/// there the grid repeats.
pub(super) fn along(p: &[Band; 3]) -> Band {
    on_floor([p[0].abs() * 2.0, p[2] * (1.0 / HEIGHT)], [0.0, 2.0], |[a, b], [column, row]| {
        let number = |c: f64| c.rem_euclid(PERIOD) as usize;
        let (i, j) = (number(column), number(row));
        let [below, above] = colors(i, j).map(f64::from);
        let (u, v) = (a - column, b - row);
        let u = if (i + j) % 2 == 1 { -u + 1.0 } else { u };
        let rise = v - u;
        let [low, high] = [rise.low().0[0] - BESIDE, rise.high().0[0] + BESIDE];
        let at_side = u.low().0[0] <= BESIDE && v.low().0[0] <= AT_SIDE;
        match (low < 0.0 || at_side, high >= 0.0) {
            (true, false) => Band::constant(below),
            (false, true) => Band::constant(above),
            _ => Band::between(below.min(above), below.max(above)),
        }
    })
}
