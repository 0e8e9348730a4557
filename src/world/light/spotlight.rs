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
    /// See [`Spotlight::dark`].
    dark: f64,
}

/// How far rounding moves a squared cosine at most, as a share, and many times more.
const ROUNDING: f64 = 1e-12;

/// Cones whose cosine is less are nearly as wide as a half-space.
const WIDE: f64 = 1e-6;

impl Spotlight {
    /// A cone with half-angles in degrees.
    pub fn new(radius: f64, falloff: f64, tightness: f64) -> Self {
        let [cos_radius, cos_falloff] = [radius, falloff].map(|angle| angle.to_radians().cos());
        let edge = cos_radius.min(cos_falloff);
        let dark = if edge > WIDE { edge * edge * (1.0 - ROUNDING) } else { -1.0 };
        Self { cos_radius, cos_falloff, tightness, dark }
    }

    /// The cosine outside which there is no light.
    pub(super) fn cos_falloff(&self) -> f64 {
        self.cos_falloff
    }

    /// The squared cosine outside which there is none, however it was rounded; negative where that isn't known.
    pub(super) fn dark(&self) -> f64 {
        self.dark
    }

    /// Whether the cone surely misses the end of a way from its tip, so `along` the axis and of this squared length.
    #[inline(always)]
    pub(super) fn misses(&self, along: f64, square: f64) -> bool {
        self.dark > 0.0 && (along < 0.0 || along * along < self.dark * square)
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
