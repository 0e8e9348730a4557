//! Textures: layers of pigment, normal and finish (docs/spec/patterns-textures.md 4 and 7,
//! docs/spec/language.md 6.8 and 6.13).

mod layers;

use std::sync::Arc;

use super::depth::Nested;
use super::image::ImageMap;
use super::pigment::BlendMap;
use super::{Field, Pigment};
use crate::math::{DVec2, Rgb, Rgbft, Transform};
use crate::source::Span;
pub use layers::{Layers, Paint};

/// A texture and where it is.
#[derive(Clone, Debug)]
pub struct Texture {
    /// What it looks like; shared by everything that copies it.
    pub body: Arc<TextureBody>,
    /// From the space the body was written in to the outer one; `None` is the identity.
    /// A texture's own transforms are in the body; these are the ones of the objects around it.
    pub transform: Option<Arc<Transform>>,
}

/// What a texture looks like.
#[derive(Clone, Debug)]
pub enum TextureBody {
    /// One or more layers, the lowest first.
    Layered(Layers),
    /// A pattern that selects or blends whole textures; for `average` the positions are weights.
    Patterned {
        /// The pattern.
        field: Arc<Field>,
        /// The textures.
        map: Arc<BlendMap<Texture>>,
        /// `no_bump_scale` of the texture, which holds for every normal in it.
        no_bump_scale: bool,
    },
    /// `material_map`: an image's palette selects the texture.
    MaterialMap {
        /// Warps and transforms; its pattern is [`super::Pattern::Image`] with the same map.
        field: Arc<Field>,
        /// The image.
        image: Arc<ImageMap>,
        /// The textures.
        textures: Nested<Vec<Texture>>,
    },
    /// `uv_mapping` in a texture: the rest is evaluated at `<u,v,0>`.
    UvMapped(Box<Texture>),
}

/// One layer.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Where it was written, or the object that took the default.
    pub span: Span,
    /// Colour.
    pub paint: Paint,
    /// Bumps.
    pub normal: Option<Arc<Normal>>,
    /// How it answers light.
    pub finish: Arc<Finish>,
}

/// `normal { … }`.
#[derive(Clone, Debug)]
pub struct Normal {
    /// How the surface is bent.
    pub kind: NormalKind,
    /// `bump_size` or the number after the pattern.
    pub amount: f32,
    /// Distance of the probes, `accuracy`.
    pub accuracy: f32,
    /// Transforms change the depth of the bumps.
    pub no_bump_scale: bool,
}

/// How a [`Normal`] bends the surface.
#[derive(Clone, Debug)]
pub enum NormalKind {
    /// Slopes of the pattern, through a slope map where there is one.
    Pattern {
        /// The pattern.
        field: Arc<Field>,
        /// Heights and slopes by position.
        slopes: Option<Arc<BlendMap<DVec2>>>,
    },
    /// A pattern that selects or blends normals; for `average` the positions are weights.
    Normals {
        /// The pattern.
        field: Arc<Field>,
        /// The normals.
        map: Arc<BlendMap<Arc<Normal>>>,
    },
    /// `bump_map`.
    Bumps {
        /// Warps and transforms; its pattern is [`super::Pattern::Image`] with the same map.
        field: Arc<Field>,
        /// The image.
        map: Arc<ImageMap>,
    },
    /// `uv_mapping`: the normal is evaluated at `<u,v,0>`.
    UvMapped(Arc<Normal>),
}

/// `finish { … }`, `albedo` already worked in (docs/spec/shading.md 9).
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// Light that is always there.
    pub ambient: Rgb,
    /// Light given off.
    pub emission: Rgb,
    /// Share of light scattered.
    pub diffuse: f32,
    /// Share scattered through from behind.
    pub diffuse_back: f32,
    /// Share of light scattered as written, before `albedo`: radiosity uses it.
    pub raw_diffuse: [f32; 2],
    /// Exponent of the diffuse cosine.
    pub brilliance: f32,
    /// Strength of the phong highlight.
    pub phong: f32,
    /// Its exponent.
    pub phong_size: f32,
    /// Strength of the specular highlight.
    pub specular: f32,
    /// Its width; the exponent is 1/roughness, or 0 for 0.
    pub roughness: f32,
    /// Highlights take the pigment's colour by this much.
    pub metallic: f32,
    /// Grain.
    pub crand: f32,
    /// Mirror.
    pub reflection: Reflection,
    /// Reflection dims what shines through.
    pub conserve_energy: bool,
    /// Thin film.
    pub irid: Option<Irid>,
    /// `subsurface`.
    pub subsurface: Option<Subsurface>,
    /// Legacy `ior`, `refraction`, `caustics` of the finish.
    pub legacy: LegacyFinish,
}

/// `reflection { … }` and `reflection_exponent`.
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

/// Interior settings that old scenes write in the finish.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[expect(missing_docs, reason = "the language's own words")]
pub struct LegacyFinish {
    pub ior: Option<f32>,
    pub refraction: Option<f32>,
    pub caustics: Option<f32>,
}

impl LegacyFinish {
    /// Whether anything was written.
    pub fn is_set(&self) -> bool {
        *self != Self::default()
    }
}

impl Texture {
    /// A texture at its own place.
    pub fn new(body: TextureBody) -> Self {
        Self { body: Arc::new(body), transform: None }
    }
}

impl From<Layer> for Texture {
    fn from(layer: Layer) -> Self {
        Self::new(TextureBody::Layered(Layers::One(layer)))
    }
}

impl Default for Texture {
    /// POV-Ray's: black, ambient 0.1, diffuse 0.6 (docs/spec/patterns-textures.md 7.1).
    fn default() -> Self {
        let paint = Paint::Color(Rgbft::BLACK.to_array());
        Self::from(Layer { span: Span::default(), paint, normal: None, finish: Arc::default() })
    }
}

impl Default for Finish {
    fn default() -> Self {
        Self {
            ambient: Rgb::splat(0.1),
            emission: Rgb::ZERO,
            diffuse: 0.6,
            diffuse_back: 0.0,
            raw_diffuse: [0.6, 0.0],
            brilliance: 1.0,
            phong: 0.0,
            phong_size: 40.0,
            specular: 0.0,
            roughness: 0.05,
            metallic: 0.0,
            crand: 0.0,
            reflection: Reflection::default(),
            conserve_energy: false,
            irid: None,
            subsurface: None,
            legacy: LegacyFinish::default(),
        }
    }
}

impl Default for Reflection {
    fn default() -> Self {
        Self { min: Rgb::ZERO, max: Rgb::ZERO, fresnel: false, falloff: 1.0, exponent: 1.0, metallic: 0.0 }
    }
}

impl Normal {
    /// The pattern, where there is one.
    pub fn field(&self) -> Option<&Arc<Field>> {
        match &self.kind {
            NormalKind::Pattern { field, .. }
            | NormalKind::Normals { field, .. }
            | NormalKind::Bumps { field, .. } => Some(field),
            NormalKind::UvMapped(_) => None,
        }
    }

    /// The pattern, where there is one, to be changed.
    pub fn field_mut(&mut self) -> Option<&mut Arc<Field>> {
        match &mut self.kind {
            NormalKind::Pattern { field, .. }
            | NormalKind::Normals { field, .. }
            | NormalKind::Bumps { field, .. } => Some(field),
            NormalKind::UvMapped(_) => None,
        }
    }

    /// Moves the bumps.
    pub fn apply(&mut self, by: &Transform) {
        if let Some(field) = self.field_mut() {
            Arc::make_mut(field).apply(by);
        }
    }
}
