//! What objects are filled with, as far as light cares (docs/spec/shading.md 11 and 12).

use super::media::Media;
use crate::math::Rgb;

/// The refractive index around all objects.
pub const AIR: f64 = 1.0;

/// From this `fade_power` on, light fades exponentially.
const EXPONENTIAL: f32 = 1000.0;

/// A filling. Identity matters: surfaces that share an interior enclose one body.
#[derive(Clone, Debug)]
pub struct Interior {
    /// Refractive index; air's where none was given.
    pub ior: f64,
    /// Ratio of the indices at the ends of the spectrum; 1 for none.
    pub dispersion: f64,
    /// Colours light is split into.
    pub dispersion_samples: u32,
    /// Strength of faked caustics; 0 for none.
    pub caustics: f32,
    /// Multiplies what is seen through the surface, `refraction` of old scenes; 1 for none.
    pub refraction: f32,
    /// How light fades inside.
    pub fade: Option<Fade>,
    /// What dims, glows and scatters inside.
    pub media: Vec<Media>,
    /// Whether its object is `hollow`: fog goes on inside.
    pub hollow: bool,
}

impl Default for Interior {
    /// What an object without an interior is filled with.
    fn default() -> Self {
        Self {
            ior: AIR,
            dispersion: 1.0,
            dispersion_samples: 7,
            caustics: 0.0,
            refraction: 1.0,
            fade: None,
            media: Vec::new(),
            hollow: false,
        }
    }
}

/// `fade_distance`, `fade_power` and `fade_color`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fade {
    /// Distance at which half the light is left, not zero.
    pub distance: f32,
    /// How fast light fades; 0 takes half of it anywhere.
    pub power: f32,
    /// What light fades to.
    pub color: Rgb,
}

impl Fade {
    /// The factor of light that came `distance` through the filling to an eye.
    pub fn attenuation(&self, distance: f64) -> Rgb {
        let ratio = (distance / f64::from(self.distance)) as f32;
        if self.power >= EXPONENTIAL {
            let exponent = (self.color - Rgb::ONE) * ratio;
            Rgb::new(exponent.x.exp(), exponent.y.exp(), exponent.z.exp())
        } else {
            self.color + (Rgb::ONE - self.color) / (1.0 + ratio.powf(self.power))
        }
    }

    /// The same on the way from a light, where a power of 0 takes nothing.
    pub fn shadow_attenuation(&self, distance: f64) -> Rgb {
        if self.power > 0.0 { self.attenuation(distance) } else { Rgb::ONE }
    }
}

impl Interior {
    /// The fake caustics' factor for a surface crossed at `cosine` to its normal.
    pub fn focus(&self, cosine: f64) -> f32 {
        if self.caustics == 0.0 { 1.0 } else { 1.0 + (cosine.abs() as f32).powf(self.caustics) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rows of docs/spec/shading.md 12 through 3 units of glass before `rgb <.2,.6,.9>`.
    #[test]
    fn light_fades_with_distance_as_the_probes_show() {
        let tint = Rgb::new(0.9, 0.5, 0.1);
        let rows = [
            (Fade { distance: 2.0, power: 1.0, color: Rgb::ZERO }, [0.08, 0.24, 0.36]),
            (Fade { distance: 2.0, power: 1.0, color: tint }, [0.18801, 0.42, 0.41399]),
            (Fade { distance: 2.0, power: 2.0, color: tint }, [0.18616, 0.39231, 0.33922]),
            (Fade { distance: 1.5, power: 1000.0, color: tint }, [0.16374, 0.22072, 0.14878]),
            (Fade { distance: 3.0, power: 0.0, color: tint }, [0.19001, 0.45, 0.495]),
        ];
        for (fade, observed) in rows {
            let ours = fade.attenuation(3.0) * Rgb::new(0.2, 0.6, 0.9);
            assert!(ours.abs_diff_eq(Rgb::from_array(observed), 2e-5), "{fade:?}: {ours}");
        }
    }

    #[test]
    fn shadow_rays_ignore_a_fade_without_power() {
        let fade = Fade { distance: 2.0, power: 0.0, color: Rgb::ZERO };
        assert_eq!(fade.shadow_attenuation(3.0), Rgb::ONE);
        assert_eq!(fade.attenuation(3.0), Rgb::splat(0.5));
    }
}
