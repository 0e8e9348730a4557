//! `spiral1` and `spiral2` (docs/spec/patterns-textures.md 2.2).

use std::f64::consts::{FRAC_PI_2, TAU};

use super::agate::OwnTurbulence;
use crate::math::DVec3;
use crate::math::noise::triangle;

/// Arms that wind about the z axis.
#[derive(Clone, Copy, Debug)]
pub struct Spiral {
    /// How many, negative to wind the other way.
    pub arms: f64,
    /// Bends the arms.
    pub turbulence: Option<OwnTurbulence>,
}

impl Spiral {
    /// `spiral1`.
    pub(super) fn single(&self, p: DVec3) -> f64 {
        self.winding(p).1
    }

    /// `spiral2`: arms and rings.
    pub(super) fn double(&self, p: DVec3) -> f64 {
        let (rings, arms) = self.winding(p);
        triangle(rings) + triangle(arms)
    }

    fn winding(&self, p: DVec3) -> (f64, f64) {
        let radius = (p.x * p.x + p.y * p.y).sqrt();
        let angle = if radius == 0.0 {
            0.0
        } else if p.x < 0.0 {
            3.0 * FRAC_PI_2 - (p.y / radius).asin()
        } else {
            FRAC_PI_2 + (p.y / radius).asin()
        };
        let bend = self.turbulence.map_or(0.0, |t| t.amount.x * t.scalar(p));
        (radius, p.z + radius + self.arms * angle / TAU + bend)
    }
}
