//! One-line patterns: `checker`, `square`, `radial`, `leopard` (docs/spec/patterns-textures.md 2.2 and 2.6).

use std::f64::consts::{PI, TAU};

use super::{cell_above, floor, is_odd};
use crate::math::DVec3;

/// Unit cubes, 0 and 1 in turn.
#[inline(always)]
pub(super) fn checker(p: DVec3) -> f64 {
    let sum = cell_above(p.x) + cell_above(p.y) + cell_above(p.z);
    f64::from(is_odd(sum))
}

/// Unit squares of the x-z plane in four colours, 0 … 3.
pub(super) fn square(p: DVec3) -> f64 {
    let odd = |c: f64| is_odd(floor(c));
    match (odd(p.x), odd(p.z)) {
        (false, false) => 0.0,
        (false, true) => 1.0,
        (true, true) => 2.0,
        (true, false) => 3.0,
    }
}

/// The angle about the y axis, 0 … 1.25.
pub(super) fn radial(p: DVec3) -> f64 {
    if p.x.abs() < 0.001 && p.z.abs() < 0.001 {
        return 0.25;
    }
    0.25 + (p.x.atan2(p.z) + PI) / TAU
}

/// Round spots.
pub(super) fn leopard(p: DVec3) -> f64 {
    let wave = (p.x.sin() + p.y.sin() + p.z.sin()) / 3.0;
    wave * wave
}
