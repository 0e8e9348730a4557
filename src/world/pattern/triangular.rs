//! `triangular`: a floor of triangles in six colours (docs/spec/patterns-textures.md 2.6).

use crate::math::DVec3;

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
    let turned = if base % 2.0 == 1.0 { base + 2.0 * column } else { 6.0 + base - 2.0 * column };
    let value = turned.rem_euclid(6.0);
    if upper { 5.0 - value } else { value }
}
