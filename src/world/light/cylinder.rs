//! `cylinder`: a beam of light with parallel edges.

use super::{power, soften};
use crate::math::DVec3;

/// The beam, by its radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Full light inside this radius.
    pub radius: f64,
    /// No light outside this radius.
    pub falloff: f64,
    /// Exponent of the fading from the axis to `falloff`.
    pub tightness: f64,
}

impl Cylinder {
    /// The share of light at `from_location`, a vector from the light to the lit point.
    pub(super) fn attenuation(&self, from_location: DVec3, axis: DVec3) -> f64 {
        let along = from_location.dot(axis);
        let off = (from_location - along * axis).length();
        if along <= 0.0 || off >= self.falloff {
            return 0.0;
        }
        let left = 1.0 - off / self.falloff;
        let edge = if self.radius > 0.0 && off > self.radius {
            soften(0.0, 1.0 - self.radius / self.falloff, left)
        } else {
            1.0
        };
        edge * power(left, self.tightness)
    }
}
