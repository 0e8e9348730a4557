//! `cells`: a random number in every unit cube (docs/spec/patterns-textures.md 2.2).

use super::cell_above;
use crate::math::DVec3;
use crate::math::noise::{cell_hash, uniform};

pub(super) fn value(p: DVec3) -> f64 {
    let cell = p.to_array().map(|c| cell_above(c) as i32);
    uniform(cell_hash(cell)).min(1.0)
}
