//! What objects are filled with (docs/spec/language.md 6.14, docs/spec/atmosphere-gi.md 2.1).

use std::sync::Arc;

use super::{Density, Texture};
use crate::math::{Rgb, Transform};
use crate::source::Span;

/// `interior { … }`.
#[derive(Clone, Debug)]
pub struct Interior {
    /// Refractive index; `None` is that of the surroundings.
    pub ior: Option<f32>,
    /// Ratio of the indices at the ends of the spectrum; 1 for none.
    pub dispersion: f32,
    /// Colours light is split into.
    pub dispersion_samples: u32,
    /// Strength of faked caustics; 0 for none.
    pub caustics: f32,
    /// Colour light fades to.
    pub fade_color: Rgb,
    /// Distance at which half the light is left; 0 for no fading.
    pub fade_distance: f32,
    /// How fast light fades; from 1000 on exponentially.
    pub fade_power: f32,
    /// Fillings.
    pub media: Vec<Media>,
    /// Legacy `refraction`.
    pub refraction: Option<f32>,
}

impl Default for Interior {
    fn default() -> Self {
        Self {
            ior: None,
            dispersion: 1.0,
            dispersion_samples: 7,
            caustics: 0.0,
            fade_color: Rgb::ZERO,
            fade_distance: 0.0,
            fade_power: 0.0,
            media: Vec::new(),
            refraction: None,
        }
    }
}

impl Interior {
    /// Moves the media.
    pub fn apply(&mut self, by: &Transform) {
        for media in &mut self.media {
            media.apply(by);
        }
    }
}

/// `media { … }`.
#[derive(Clone, Debug)]
pub struct Media {
    /// Where the statement stands.
    pub span: Span,
    /// Integration method 1, 2 or 3.
    pub method: u32,
    /// Intervals.
    pub intervals: u32,
    /// Least and most samples.
    pub samples: [u32; 2],
    /// Method 3: threshold of the adaptive sampling.
    pub aa_threshold: f32,
    /// Method 3: its depth.
    pub aa_level: u32,
    /// Random displacement of samples.
    pub jitter: f32,
    /// Share of intervals that lie in lit parts.
    pub ratio: f32,
    /// Methods 1 and 2.
    pub confidence: f32,
    /// Methods 1 and 2.
    pub variance: f32,
    /// Light swallowed per unit.
    pub absorption: Rgb,
    /// Light given off per unit.
    pub emission: Rgb,
    /// Light scattered per unit.
    pub scattering: Option<Scattering>,
    /// Whether media photons are collected.
    pub collect: bool,
    /// Multiply each other; none is 1 everywhere.
    pub densities: Vec<Arc<Density>>,
}

/// `scattering { … }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattering {
    /// 1 … 5.
    pub kind: u32,
    /// Light scattered per unit.
    pub color: Rgb,
    /// Type 5: preferred direction.
    pub eccentricity: f32,
    /// Multiplier of the loss by scattering.
    pub extinction: f32,
}

impl Media {
    /// Moves the densities.
    pub fn apply(&mut self, by: &Transform) {
        for density in &mut self.densities {
            Arc::make_mut(density).apply(by);
        }
    }
}

/// `material { … }`: a texture and an interior under one name.
#[derive(Clone, Debug, Default)]
pub struct Material {
    /// Surface.
    pub texture: Option<Texture>,
    /// Surface seen from inside.
    pub interior_texture: Option<Texture>,
    /// Filling.
    pub interior: Option<Arc<Interior>>,
}
