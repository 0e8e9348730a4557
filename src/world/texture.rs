//! Textures: layers of pigment, normal and finish, and what selects or blends them
//! (docs/spec/patterns-textures.md 3, 4 and 7).

mod along;
pub mod blend_map;
pub mod finish;
mod four;
pub mod normal;
pub mod paint;
pub mod pigment;

pub use blend_map::{BlendMap, Pick};
pub use finish::{Finish, Irid, Reflection, Subsurface};
pub use normal::{Normal, NormalKind};
pub use paint::Paint;
pub use pigment::Pigment;

pub use super::sample::Sample;

use std::slice;
use std::sync::Arc;

use smallvec::SmallVec;

use super::image::ImageMap;
use super::pattern::{Formula, Pattern};
use super::sample::Enclosing;
use super::warp::{Warp, Warps};
use crate::math::{DVec3, Rgb, Transform, unit};

/// A texture and where it is.
#[derive(Clone, Debug)]
pub enum Texture {
    /// One layer that looks the same wherever it is, in little room: scenes have millions.
    Even(Layer),
    /// Any other.
    Placed {
        /// What it looks like.
        body: Arc<TextureBody>,
        /// From the space the body was written in to the world, as a way of one step; empty for the identity.
        placement: Warps,
    },
}

/// What a texture looks like.
#[derive(Clone, Debug)]
pub enum TextureBody {
    /// One or more layers, the lowest first.
    Layered {
        /// The layers, most often one.
        layers: SmallVec<[Layer; 1]>,
        /// Some layer lets nothing through anywhere.
        opaque: bool,
    },
    /// A pattern that selects or blends whole textures; for `average` the positions are weights.
    Patterned {
        /// The pattern.
        pattern: Box<Pattern>,
        /// The textures.
        map: BlendMap<Texture>,
        /// Holds for every normal inside.
        no_bump_scale: bool,
    },
    /// `material_map`.
    MaterialMap {
        /// Transforms and warps of the texture.
        warps: Warps,
        /// The image.
        image: Box<ImageMap>,
        /// The textures, at least one.
        textures: Box<[Texture]>,
    },
    /// Evaluated at `<u,v,0>`.
    UvMapped(Texture),
}

/// One layer.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Colour.
    pub paint: Paint,
    /// Bumps.
    pub normal: Option<Arc<Normal>>,
    /// How it answers light.
    pub finish: Arc<Finish>,
}

impl TextureBody {
    /// Whether it looks the same wherever it is.
    fn is_everywhere_alike(&self) -> bool {
        self.layers().is_some_and(|layers| layers.iter().all(Layer::is_even))
    }

    /// The only layers, where there is no pattern.
    #[inline]
    fn layers(&self) -> Option<&[Layer]> {
        match self {
            Self::Layered { layers, .. } => Some(layers),
            _ => None,
        }
    }
}

impl Texture {
    /// A texture and the way from its space to the world.
    pub fn new(body: Arc<TextureBody>, placement: &Transform) -> Self {
        if let Some([layer]) = body.layers()
            && layer.is_even()
        {
            return Self::Even(layer.clone());
        }
        let step = (!placement.is_identity() && !body.is_everywhere_alike())
            .then(|| Warp::Transform(Box::new(*placement)));
        Self::Placed { body, placement: Warps::new(step) }
    }

    /// Calls `shade` with every plain texture that shows at the sample, with its share, in the order
    /// POV-Ray shades them (docs/spec/patterns-textures.md 7.2). Shares add up to 1. What `shade`
    /// leaves as the sample's bent normal is what later patterns see.
    pub fn resolve(&self, sample: &mut Sample, shade: &mut dyn FnMut(f32, &[Layer], &mut Sample)) {
        match self.layers_in_place() {
            Some(layers) => shade(1.0, layers, sample),
            None => self.walk(1.0, sample, shade),
        }
    }

    /// The only layers, where the texture has no pattern and they are to be seen where the sample is.
    #[inline]
    pub fn layers_in_place(&self) -> Option<&[Layer]> {
        match self {
            Self::Even(layer) => Some(slice::from_ref(layer)),
            Self::Placed { body, placement } => body.layers().filter(|_| placement.is_empty()),
        }
    }

    /// The way from the world to the space that its layers are in, if that is another.
    #[inline]
    pub fn placement(&self) -> Option<&Warps> {
        match self {
            Self::Even(_) => None,
            Self::Placed { placement, .. } => Some(placement).filter(|placement| !placement.is_empty()),
        }
    }

    fn walk(&self, weight: f32, sample: &mut Sample, shade: &mut dyn FnMut(f32, &[Layer], &mut Sample)) {
        let (body, warps) = match self {
            Self::Even(layer) => return shade(weight, slice::from_ref(layer), sample),
            Self::Placed { body, placement } => (&**body, placement),
        };
        // Where it is evaluated, the place of a uv-mapped texture doesn't matter.
        if warps.is_empty() || matches!(body, TextureBody::UvMapped(_)) {
            return body.walk(weight, sample, shade);
        }
        let placement = Enclosing {
            warps,
            no_bump_scale: matches!(body, TextureBody::Patterned { no_bump_scale: true, .. }),
            of_layers: matches!(body, TextureBody::Layered { .. }),
            outer: sample.enclosing,
        };
        let mut inner = Sample { point: warps.point(sample.point), enclosing: Some(&placement), ..*sample };
        body.walk(weight, &mut inner, shade);
        sample.bent = inner.bent;
    }

    /// Whether nothing shines through anywhere.
    pub fn is_opaque(&self) -> bool {
        let body = match self {
            Self::Even(layer) => return layer.paint.is_opaque(),
            Self::Placed { body, .. } => body,
        };
        match &**body {
            TextureBody::Layered { opaque, .. } => *opaque,
            TextureBody::Patterned { map, .. } => {
                map.entries().iter().all(|(_, texture)| texture.is_opaque())
            }
            TextureBody::MaterialMap { textures, .. } => textures.iter().all(Self::is_opaque),
            TextureBody::UvMapped(texture) => texture.is_opaque(),
        }
    }

    /// Whether all light passes unchanged everywhere.
    pub fn is_clear(&self) -> bool {
        self.layers().is_some_and(|layers| layers.iter().all(Layer::is_clear))
    }

    /// Whether no light that passes is changed anywhere, be it filtered or let through.
    pub fn passes_light(&self) -> bool {
        self.layers().is_some_and(|layers| layers.iter().all(Layer::passes_light))
    }

    /// Whether nothing of it is ever seen.
    pub fn is_invisible(&self) -> bool {
        self.is_clear() && self.layers().is_some_and(|layers| layers.iter().all(Layer::is_dull))
    }

    /// The only layers, where the texture has no pattern: the same at every sample.
    #[inline]
    pub fn layers(&self) -> Option<&[Layer]> {
        match self {
            Self::Even(layer) => Some(slice::from_ref(layer)),
            Self::Placed { body, .. } => body.layers(),
        }
    }
}

impl TextureBody {
    fn walk(&self, weight: f32, sample: &mut Sample, shade: &mut dyn FnMut(f32, &[Layer], &mut Sample)) {
        match self {
            Self::Layered { layers, .. } => shade(weight, layers, sample),
            Self::UvMapped(texture) => {
                let mut inner = sample.uv_mapped();
                texture.walk(weight, &mut inner, shade);
                sample.bent = inner.bent;
            }
            Self::MaterialMap { warps, image, textures } => {
                let enclosing =
                    Enclosing { warps, no_bump_scale: false, of_layers: false, outer: sample.enclosing };
                let point = warps.point(sample.point);
                let mut inner = Sample { point, enclosing: Some(&enclosing), ..*sample };
                textures[image.material(point, textures.len())].walk(weight, &mut inner, shade);
                sample.bent = inner.bent;
            }
            Self::Patterned { pattern, map, no_bump_scale } => {
                let warps = &pattern.warps;
                let enclosing = Enclosing {
                    warps,
                    no_bump_scale: *no_bump_scale,
                    of_layers: false,
                    outer: sample.enclosing,
                };
                let point = warps.point(sample.point);
                let mut inner = Sample { point, enclosing: Some(&enclosing), ..*sample };
                if matches!(pattern.formula, Formula::Average) {
                    let total: f32 = map.entries().iter().map(|(share, _)| share).sum();
                    for (share, texture) in map.entries().iter().filter(|(share, _)| *share != 0.0) {
                        texture.walk(weight * (share / total), &mut inner, shade);
                    }
                } else {
                    match map.pick(pattern.value_at(point, &inner)) {
                        Pick::One(texture) => texture.walk(weight, &mut inner, shade),
                        Pick::Two { previous, current, t } => {
                            current.walk(weight * t as f32, &mut inner, shade);
                            previous.walk(weight * (1.0 - t) as f32, &mut inner, shade);
                        }
                    }
                }
                sample.bent = inner.bent;
            }
        }
    }
}

impl Layer {
    /// Whether it looks the same wherever it is.
    #[inline]
    pub fn is_even(&self) -> bool {
        self.normal.is_none() && self.paint.even().is_some()
    }

    /// Whether its pigment is clear and the same everywhere.
    fn is_clear(&self) -> bool {
        self.paint.even().is_some_and(|color| color.transmit == 1.0 && color.filter == 0.0)
    }

    /// Whether light that passes its pigment stays as it is.
    fn passes_light(&self) -> bool {
        self.paint.even().is_some_and(|color| color.through() == Rgb::ONE && color.opacity() == 0.0)
    }

    /// Whether it shows nothing but its pigment.
    fn is_dull(&self) -> bool {
        let finish = &self.finish;
        finish.reflection.is_none() && finish.phong <= 0.0 && finish.specular <= 0.0 && finish.crand == 0.0
    }

    /// The normal to shade with, in the world; unit unless `no_bump_scale` says otherwise.
    /// Updates the sample's bent normal, so that the pigment's `slope` and `aoi` see these bumps.
    #[inline]
    pub fn bend(&self, sample: &mut Sample) -> DVec3 {
        match &self.normal {
            None => sample.normal,
            Some(normal) => Self::bent(normal, sample),
        }
    }

    fn bent(normal: &Normal, sample: &mut Sample) -> DVec3 {
        // The layer's own place counts as part of the normal block, patterned textures don't; a block
        // that is mapped by uv ignores all its transforms.
        let mapped = matches!(normal.kind, NormalKind::UvMapped(_));
        let (place, outer) = match sample.enclosing {
            Some(place) if place.of_layers => ((!mapped).then_some(place.warps), place.outer),
            outer => (None, outer),
        };
        let mut n = outer.map_or(sample.normal, |outer| outer.inward(sample.normal));
        n = place.map_or(n, |place| place.normal_inward(n, true));
        n = normal.bend(sample, n, outer.is_some_and(Enclosing::is_raw));
        n = unit(place.map_or(n, |place| place.normal_outward(n, true)));
        sample.bent = n;
        outer.map_or(n, |outer| outer.outward(n))
    }
}
