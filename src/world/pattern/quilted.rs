//! `quilted`: cushions in unit cubes (docs/spec/patterns-textures.md 2.2 and 4.2).

use crate::math::DVec3;

/// `quilted`.
#[derive(Clone, Copy, Debug)]
pub struct Quilted {
    /// Slope at the seam.
    pub control0: f64,
    /// Slope at the middle.
    pub control1: f64,
}

impl Quilted {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let v = self.bulge(p);
        (v.x.abs() + v.y.abs() + v.z.abs()) / 3.0
    }

    /// Away from the middle of the cushion, as far as the cushion slopes.
    pub(crate) fn bulge(&self, p: DVec3) -> DVec3 {
        let v = p.map(|c| c - cell(c) - 0.5);
        let t = v.length();
        let s = 1.0 - t;
        let profile = t * t * t + 3.0 * t * (s * s) * self.control0 + 3.0 * (t * t) * s * self.control1;
        profile * 1.154700538 * v
    }
}

/// Number of the cell; negative integers belong to the cell below.
fn cell(c: f64) -> f64 {
    if c >= 0.0 { c.floor() } else { 0.0 - (0.0 - c).floor() - 1.0 }
}
