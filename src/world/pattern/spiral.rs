//! `spiral1` and `spiral2` (docs/spec/patterns-textures.md 2.2).

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::agate::OwnTurbulence;
use crate::math::noise::triangle;
use crate::math::{Band, DVec3, Lanes};

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

    /// What holds the values of `spiral1` at all points that these hold.
    pub(super) fn single_along(&self, p: &[Band; 3]) -> Band {
        self.winding_along(p).1
    }

    /// What holds the values of `spiral2`.
    pub(super) fn double_along(&self, p: &[Band; 3]) -> Band {
        let (rings, arms) = self.winding_along(p);
        triangle_along(rings) + triangle_along(arms)
    }

    fn winding_along(&self, [x, y, z]: &[Band; 3]) -> (Band, Band) {
        let radius = (x.square() + y.square()).sqrt();
        // From the negative y axis, where it jumps.
        let angle = (-*x).atan2(*y) + PI;
        // An arc sine loses up to half the digits beside 1.
        let steep = x.abs().low() - radius.high() * STEEP;
        let loss = Lanes::splat(LOSS[0]).where_positive(steep, Lanes::splat(LOSS[1]));
        let angle = Band { reach: angle.reach + loss, ..angle };
        let bend = match self.turbulence {
            Some(t) => t.octaves.scalar_along(t.generator, [*x, *y, *z]) * t.amount.x,
            None => Band::constant(0.0),
        };
        (radius, *z + radius + angle * (self.arms / TAU) + bend)
    }
}

/// Where x is at least this share of the radius, angles are rounded by less than the first loss, else by less than
/// the second.
const STEEP: f64 = 1e-2;
const LOSS: [f64; 2] = [1e-13, 5e-8];

/// Both ways to see a triangle wave have their jumps where the other has none.
fn triangle_along(v: Band) -> Band {
    let whole = v.floor();
    let from_edge = -((v - whole) * 2.0 - 1.0).abs() + 1.0;
    let from_nearest = (v - (v + 0.5).floor()).abs() * 2.0;
    from_nearest.where_positive(whole.reach, from_edge)
}
