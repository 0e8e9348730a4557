//! Compiles textures, and holds what textures, patterns, functions and images share while compiling.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use smallvec::SmallVec;

use super::Unsupported;
use crate::math::noise::{WaveSource, wave_sources};
use crate::math::{Rgb, Transform};
use crate::scene;
use crate::scene::settings::Settings;
use crate::source::Span;
use crate::world;
use crate::world::Inside;
use crate::world::image::Image;
use crate::world::texture::{BlendMap, Layer, Paint, Pigment, TextureBody};

/// How deep textures, patterns and functions may contain each other.
pub(super) const DEEPEST: u32 = 300;

/// Compiles an object that a pattern asks for its inside.
type ObjectCompiler<'a> = &'a dyn Fn(&Arc<scene::Object>) -> Result<Arc<dyn Inside>, Unsupported>;

/// Compiles textures. What the scene shares stays shared, so each part is compiled once, and an image
/// is decoded only if something uses it.
pub struct TextureCompiler<'a> {
    pub(super) settings: &'a Settings,
    quick_colors: bool,
    objects: Option<ObjectCompiler<'a>>,
    depth: u32,
    pub(super) uses_uv: bool,
    /// Whether a pattern looks at surface normals.
    pub(super) uses_normals: bool,
    /// Whether a finish lets light pass below the surface.
    pub(super) uses_subsurface: bool,
    /// Whether a finish has grain.
    pub(super) uses_grain: bool,
    /// Whether functions give the last digit that POV-Ray's give, where another way is faster.
    pub(super) last_digits: bool,
    waves: Option<Arc<[WaveSource]>>,
    bodies: Cache<scene::texture::TextureBody, TextureBody>,
    finishes: Cache<scene::Finish, world::texture::Finish>,
    pub(super) pigments: Cache<scene::Pigment, Pigment>,
    pub(super) normals: Cache<scene::Normal, world::texture::Normal>,
    pub(super) functions: Cache<scene::Function, world::Function>,
    /// Pixels as `image_map` reads them, and as everything else does.
    pub(super) images: [Cache<scene::image::ImageSource, Image>; 2],
}

/// What became of a shared part of the scene. The part is kept, so that its address stays its own.
pub(super) type Cache<S, W> = FxHashMap<*const S, (Arc<S>, Arc<W>)>;

impl<'a> TextureCompiler<'a> {
    /// For a scene with these settings.
    pub fn new(settings: &'a Settings) -> Self {
        Self {
            settings,
            quick_colors: false,
            objects: None,
            depth: 0,
            uses_uv: false,
            uses_normals: false,
            uses_subsurface: false,
            uses_grain: false,
            last_digits: false,
            waves: None,
            bodies: Cache::default(),
            finishes: Cache::default(),
            pigments: Cache::default(),
            normals: Cache::default(),
            functions: Cache::default(),
            images: [Cache::default(), Cache::default()],
        }
    }

    /// Pigments with a `quick_color` become that colour, as at quality 5 and lower.
    #[must_use]
    pub fn with_quick_colors(self, quick_colors: bool) -> Self {
        Self { quick_colors, ..self }
    }

    /// Functions give the last digit that POV-Ray's give, even where another way is faster.
    #[must_use]
    pub fn with_last_digits(self) -> Self {
        Self { last_digits: true, ..self }
    }

    /// How patterns get at the inside of objects; without it the `object` pattern is unsupported.
    #[must_use]
    pub fn with_objects(self, objects: ObjectCompiler<'a>) -> Self {
        Self { objects: Some(objects), ..self }
    }

    /// Whether anything compiled so far is evaluated at texture coordinates.
    pub fn uses_uv(&self) -> bool {
        self.uses_uv
    }

    /// A texture, seen through the transform of the object it is on.
    ///
    /// # Errors
    /// What it uses that povista lacks, or a file that can't be read.
    pub fn texture(
        &mut self,
        texture: &scene::Texture,
        outer: &Transform,
    ) -> Result<world::texture::Texture, Unsupported> {
        let body = match self.bodies.get(&Arc::as_ptr(&texture.body)) {
            Some((_, body)) => body.clone(),
            None => {
                let body = Arc::new(self.body(&texture.body)?);
                // What nothing else shares is not asked for again.
                if Arc::strong_count(&texture.body) > 1 {
                    let kept = (texture.body.clone(), body.clone());
                    self.bodies.insert(Arc::as_ptr(&texture.body), kept);
                }
                body
            }
        };
        let placement = texture.transform.as_ref().map_or(*outer, |own| own.then(outer));
        Ok(world::texture::Texture::new(body, &placement))
    }

    fn body(&mut self, body: &scene::texture::TextureBody) -> Result<TextureBody, Unsupported> {
        use scene::texture::TextureBody as Body;
        Ok(match body {
            Body::Layered(layers) => {
                let layers: SmallVec<[Layer; 1]> =
                    layers.iter().map(|layer| self.layer(layer)).collect::<Result<_, _>>()?;
                let opaque = layers.iter().any(|layer| layer.paint.is_opaque());
                TextureBody::Layered { layers, opaque }
            }
            Body::Patterned { field, map, no_bump_scale } => TextureBody::Patterned {
                pattern: Box::new(self.pattern(field)?),
                map: self.map(field, map, |this, texture| {
                    this.nested(field.span, |this| this.texture(texture, &Transform::IDENTITY))
                })?,
                no_bump_scale: *no_bump_scale,
            },
            Body::MaterialMap { field, image, textures } => TextureBody::MaterialMap {
                warps: self.warps(field),
                image: Box::new(self.image_map(image, false)?),
                textures: textures
                    .iter()
                    .map(|texture| {
                        self.nested(field.span, |this| this.texture(texture, &Transform::IDENTITY))
                    })
                    .collect::<Result<_, _>>()?,
            },
            Body::UvMapped(texture) => {
                self.uses_uv = true;
                TextureBody::UvMapped(self.texture(texture, &Transform::IDENTITY)?)
            }
        })
    }

    fn layer(&mut self, layer: &scene::texture::Layer) -> Result<Layer, Unsupported> {
        let finish = match self.finishes.get(&Arc::as_ptr(&layer.finish)) {
            Some((_, finish)) => finish.clone(),
            None => {
                let compiled = Arc::new(finish(&layer.finish));
                if Arc::strong_count(&layer.finish) > 1 {
                    let kept = (layer.finish.clone(), compiled.clone());
                    self.finishes.insert(Arc::as_ptr(&layer.finish), kept);
                }
                compiled
            }
        };
        self.uses_subsurface |= finish.subsurface.is_some();
        self.uses_grain |= finish.crand > 0.0;
        let paint = match &layer.paint {
            scene::texture::Paint::Color(color) => Paint::Even(*color),
            scene::texture::Paint::Pigment(pigment) => self.pigment(pigment)?.into(),
        };
        let normal = layer.normal.as_ref().map(|normal| self.normal(normal)).transpose()?;
        Ok(Layer { paint, normal: normal.filter(|normal| !normal.is_flat()), finish })
    }

    /// Compiles the entries of a map.
    pub(super) fn map<S, W>(
        &mut self,
        field: &scene::Field,
        map: &scene::pigment::BlendMap<S>,
        mut entry: impl FnMut(&mut Self, &S) -> Result<W, Unsupported>,
    ) -> Result<BlendMap<W>, Unsupported> {
        let entries = map.entries.iter().map(|(at, e)| Ok((*at, entry(self, e)?)));
        let entries: Vec<(f32, W)> = entries.collect::<Result<_, _>>()?;
        BlendMap::new(entries).ok_or_else(|| Unsupported::broken(field.span, "a map without entries"))
    }

    /// One level deeper; refuses to go on for ever.
    pub(super) fn nested<T>(
        &mut self,
        span: Span,
        inside: impl FnOnce(&mut Self) -> Result<T, Unsupported>,
    ) -> Result<T, Unsupported> {
        if self.depth >= DEEPEST {
            return Err(Unsupported::new(span, format!("more than {DEEPEST} levels of nesting")));
        }
        self.depth += 1;
        let result = inside(self);
        self.depth -= 1;
        result
    }

    pub(super) fn quick_color(&self, pigment: &scene::Pigment) -> Option<crate::math::Rgbft> {
        // A component of -1 is how POV-Ray marks that none was given.
        let is_set = |c: &crate::math::Rgbft| c.rgb.to_array().iter().all(|v| *v != -1.0);
        pigment.quick_color.as_deref().copied().filter(|color| self.quick_colors && is_set(color))
    }

    pub(super) fn wave_sources(&mut self) -> Arc<[WaveSource]> {
        let count = self.settings.number_of_waves;
        self.waves.get_or_insert_with(|| wave_sources(count).into()).clone()
    }

    pub(super) fn inside(
        &self,
        field: &scene::Field,
        object: &Arc<scene::Object>,
    ) -> Result<Arc<dyn Inside>, Unsupported> {
        match self.objects {
            Some(compile) => compile(object),
            None => Err(Unsupported::new(field.span, "the `object` pattern here")),
        }
    }
}

/// Restates a finish for the renderer.
fn finish(finish: &scene::Finish) -> world::texture::Finish {
    let reflection = &finish.reflection;
    let mirrors = reflection.min != Rgb::ZERO || reflection.max != Rgb::ZERO;
    world::texture::Finish {
        ambient: finish.ambient,
        emission: finish.emission,
        diffuse: finish.diffuse,
        diffuse_back: finish.diffuse_back,
        raw_diffuse: finish.raw_diffuse,
        brilliance: finish.brilliance,
        phong: finish.phong,
        phong_size: finish.phong_size,
        specular: finish.specular,
        specular_exponent: if finish.roughness == 0.0 { 0.0 } else { finish.roughness.recip() },
        metallic: finish.metallic,
        crand: finish.crand,
        reflection: mirrors.then_some(world::texture::Reflection {
            min: reflection.min,
            max: reflection.max,
            fresnel: reflection.fresnel,
            falloff: reflection.falloff,
            exponent: reflection.exponent,
            metallic: reflection.metallic,
        }),
        conserve_energy: finish.conserve_energy,
        irid: finish.irid.filter(|irid| irid.amount != 0.0).map(|irid| world::texture::Irid {
            amount: irid.amount,
            thickness: irid.thickness,
            turbulence: irid.turbulence,
        }),
        subsurface: finish.subsurface.map(|subsurface| world::texture::Subsurface {
            translucency: subsurface.translucency,
            anisotropy: subsurface.anisotropy,
        }),
    }
}
