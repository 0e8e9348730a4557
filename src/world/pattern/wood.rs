//! `wood`: rings about the z axis (docs/spec/patterns-textures.md 2.2).

use super::agate::OwnTurbulence;
use crate::math::DVec3;
use crate::math::noise::cycle;

/// `wood`.
#[derive(Clone, Copy, Debug)]
pub struct Wood {
    /// Bends the rings, which are circles without it.
    pub turbulence: Option<OwnTurbulence>,
}

impl Wood {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let (x, y) = match self.turbulence {
            Some(t) => {
                let d = t.octaves.vector(p);
                (cycle((p.x + d.x) * t.amount.x) + p.x, cycle((p.y + d.y) * t.amount.y) + p.y)
            }
            None => (p.x, p.y),
        };
        (x * x + y * y).sqrt()
    }
}
