//! `finish { … }` as the renderer reads it (docs/spec/shading.md 9).

use crate::math::Rgb;

/// How a surface answers light.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// Light that is always there, before the scene's `ambient_light`.
    pub ambient: Rgb,
    /// Light given off.
    pub emission: Rgb,
    /// Share of light scattered.
    pub diffuse: f32,
    /// Share scattered through from behind.
    pub diffuse_back: f32,
    /// Shares scattered before `albedo`: radiosity uses them.
    pub raw_diffuse: [f32; 2],
    /// Exponent of the diffuse cosine.
    pub brilliance: f32,
    /// Strength of the phong highlight.
    pub phong: f32,
    /// Its exponent.
    pub phong_size: f32,
    /// Strength of the specular highlight.
    pub specular: f32,
    /// Its exponent, 1/roughness.
    pub specular_exponent: f32,
    /// Highlights take the pigment's colour by this much.
    pub metallic: f32,
    /// Grain.
    pub crand: f32,
    /// Mirror; `None` where both ends are black.
    pub reflection: Option<Reflection>,
    /// Reflection dims what shines through.
    pub conserve_energy: bool,
    /// Thin film.
    pub irid: Option<Irid>,
    /// Light that wanders under the surface.
    pub subsurface: Option<Subsurface>,
}

/// The mirror of a finish.
#[derive(Clone, Debug, PartialEq)]
pub struct Reflection {
    /// Seen head on.
    pub min: Rgb,
    /// Seen at a grazing angle.
    pub max: Rgb,
    /// Between the two by Fresnel's law instead of `falloff`.
    pub fresnel: bool,
    /// Exponent of the angle.
    pub falloff: f32,
    /// Exponent of the reflected colour.
    pub exponent: f32,
    /// The pigment colours the reflection by this much.
    pub metallic: f32,
}

/// `irid { … }`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the language's own words")]
pub struct Irid {
    pub amount: f32,
    pub thickness: f32,
    pub turbulence: f32,
}

/// `subsurface { … }`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the language's own words")]
pub struct Subsurface {
    pub translucency: Rgb,
    pub anisotropy: Rgb,
}
