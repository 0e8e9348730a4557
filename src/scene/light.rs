//! Light sources (docs/spec/language.md 6.4, docs/spec/shading.md 16-18).

use std::sync::Arc;

use super::Object;
use super::depth::Nested;
use crate::math::{DVec3, Rgb};

/// A `light_source`, in the space its statement's transforms lead to.
#[derive(Clone, Debug)]
pub struct Light {
    /// Where it shines.
    pub kind: LightKind,
    /// Where it is.
    pub location: DVec3,
    /// Its colour; negative components darken.
    pub color: Rgb,
    /// Where spotlights, cylinders and parallel lights point to.
    pub point_at: DVec3,
    /// Rays are parallel.
    pub parallel: bool,
    /// Distance at which it is half faded; 0 for no fading.
    pub fade_distance: f64,
    /// How fast it fades; 0 for no fading.
    pub fade_power: f64,
    /// A grid of lights instead of one.
    pub area: Option<AreaLight>,
    /// The visible shape of the light, already at its place.
    pub looks_like: Option<Nested<Arc<Object>>>,
    /// Light reaches only what is seen through this.
    pub projected_through: Option<Nested<Arc<Object>>>,
    /// Media is lit.
    pub media_interaction: bool,
    /// Media dims the light.
    pub media_attenuation: bool,
    /// `photons { … }`.
    pub photons: Option<LightPhotons>,
}

/// Where a light shines. Of several words that say so the last one counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// In all directions.
    Point,
    /// In all directions, without shadows and highlights.
    Shadowless,
    /// `spotlight`: angles in degrees.
    Spot {
        /// Full light inside this half-angle.
        radius: f64,
        /// No light outside this half-angle.
        falloff: f64,
        /// Exponent of the softening.
        tightness: f64,
    },
    /// `cylinder`: radii in scene units.
    Cylinder {
        /// Full light inside this radius.
        radius: f64,
        /// No light outside this radius.
        falloff: f64,
        /// Exponent of the softening.
        tightness: f64,
    },
}

/// `area_light` and its options.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaLight {
    /// The two edges.
    pub axes: [DVec3; 2],
    /// Lights along each edge, at least 1.
    pub size: [u32; 2],
    /// Adaptive level; 100 samples everything.
    pub adaptive: u32,
    /// Lights are moved at random within their cell.
    pub jitter: bool,
    /// A disc instead of a rectangle.
    pub circular: bool,
    /// Always turned towards the lit point.
    pub orient: bool,
    /// Diffuse and highlights use the grid too.
    pub area_illumination: bool,
}

/// `photons { … }` of a light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LightPhotons {
    /// `reflection`, where written.
    pub reflection: Option<bool>,
    /// `refraction`, where written.
    pub refraction: Option<bool>,
    /// Photons start from the whole area.
    pub area_light: bool,
}
