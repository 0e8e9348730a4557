//! `spotlight`: a cone of light.

use super::{power, soften};

/// The cone, by the cosines of its angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spotlight {
    /// Cosine inside which there is full light; not positive where the edge is not softened.
    cos_radius: f64,
    /// Cosine outside which there is none.
    cos_falloff: f64,
    /// Exponent of the cosine to the axis.
    tightness: f64,
}

impl Spotlight {
    /// A cone with half-angles in degrees.
    pub fn new(radius: f64, falloff: f64, tightness: f64) -> Self {
        Self { cos_radius: radius.to_radians().cos(), cos_falloff: falloff.to_radians().cos(), tightness }
    }

    /// The cosine outside which there is no light.
    pub(super) fn cos_falloff(&self) -> f64 {
        self.cos_falloff
    }

    /// The share of light at `cosine` to the axis.
    pub(super) fn attenuation(&self, cosine: f64) -> f64 {
        if cosine <= 0.0 {
            return 0.0;
        }
        let edge = if self.cos_radius > 0.0 && cosine < self.cos_radius {
            soften(self.cos_falloff, self.cos_radius, cosine)
        } else {
            1.0
        };
        edge * power(cosine, self.tightness)
    }
}
