//! How deep values stand in each other: a union in a union, a pigment in the map of another.
//!
//! Whoever walks through a value recurses as deep, be it to compile, to ask or to drop it. A loop
//! can put each value into the next without end, so a limit has to be kept ([`DEEPEST`]) and to
//! be cheap to keep: what holds several values counts once, when it is made ([`Nested`]).

use std::ops::Deref;
use std::sync::Arc;

use super::function::{Expr, FunctionBody};
use super::image::{ImageMap, ImageOrigin, ImageSource};
use super::interior::{Material, Media};
use super::pigment::{BlendMap, PigmentKind};
use super::shape::{BlobComponent, LightGroup};
use super::texture::{Layer, NormalKind, Paint, TextureBody};
use super::{
    Camera, Field, Function, Interior, Light, Normal, Object, Pattern, Pigment, Shape, SkySphere, Texture,
};
use crate::math::{DVec2, Rgbft};

/// Most values that may stand in each other: each takes some of the stack of who walks through them.
pub const DEEPEST: u32 = 1200;

/// A value that may hold others.
pub trait Depth {
    /// How many [`Nested`] stand in each other in it; 0 where there is none.
    fn depth(&self) -> u32;
}

/// What a value holds, with its depth.
#[derive(Clone, Debug, PartialEq)]
pub struct Nested<T> {
    depth: u32,
    inside: T,
}

impl<T: Depth> Nested<T> {
    /// One level above what is inside, or none where nothing is.
    pub fn new(inside: T) -> Self {
        Self { depth: inside.depth() + 1, inside }
    }
}

impl<T> Nested<T> {
    /// What is inside, for changes that put nothing deeper.
    pub fn inside_mut(&mut self) -> &mut T {
        &mut self.inside
    }
}

impl<T: Default> Default for Nested<T> {
    fn default() -> Self {
        Self { depth: 0, inside: T::default() }
    }
}

impl<T> Deref for Nested<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.inside
    }
}

impl<T> Depth for Nested<T> {
    fn depth(&self) -> u32 {
        self.depth
    }
}

/// The depth of the deepest.
fn deepest<'a, T: Depth + 'a>(values: impl IntoIterator<Item = &'a T>) -> u32 {
    values.into_iter().map(Depth::depth).max().unwrap_or_default()
}

impl<T: Depth> Depth for Arc<T> {
    fn depth(&self) -> u32 {
        (**self).depth()
    }
}

impl<T: Depth> Depth for Option<T> {
    fn depth(&self) -> u32 {
        deepest(self)
    }
}

impl<T: Depth> Depth for Vec<T> {
    fn depth(&self) -> u32 {
        deepest(self)
    }
}

impl<T: Depth> Depth for (f32, T) {
    fn depth(&self) -> u32 {
        self.1.depth()
    }
}

impl Depth for Rgbft {
    fn depth(&self) -> u32 {
        0
    }
}

impl Depth for DVec2 {
    fn depth(&self) -> u32 {
        0
    }
}

impl<T> Depth for BlendMap<T> {
    fn depth(&self) -> u32 {
        self.entries.depth()
    }
}

impl Depth for Object {
    fn depth(&self) -> u32 {
        let extra = self.extra.as_ref().map_or(0, |extra| {
            let lists = extra.clipped_by.depth().max(extra.bounded_by.depth());
            lists.max(extra.interior_texture.depth()).max(extra.interior.depth())
        });
        self.shape.depth().max(self.texture.depth()).max(extra)
    }
}

impl Depth for Shape {
    fn depth(&self) -> u32 {
        match self {
            Self::Csg(csg) => csg.children.depth(),
            Self::Blob(blob) => blob.components.depth(),
            Self::Mesh(mesh) => mesh.textures.depth(),
            Self::HeightField(field) => field.image.depth(),
            Self::Isosurface(surface) => surface.function.depth(),
            Self::Parametric(surface) => deepest(&surface.functions),
            Self::Light(light) => light.depth(),
            Self::LightGroup(group) => group.depth(),
            _ => 0,
        }
    }
}

impl Depth for BlobComponent {
    fn depth(&self) -> u32 {
        self.texture.depth()
    }
}

impl Depth for Light {
    fn depth(&self) -> u32 {
        self.looks_like.depth().max(self.projected_through.depth())
    }
}

impl Depth for LightGroup {
    fn depth(&self) -> u32 {
        self.objects.depth()
    }
}

impl Depth for Texture {
    fn depth(&self) -> u32 {
        match &*self.body {
            TextureBody::Layered(layers) => deepest(&layers[..]),
            TextureBody::Patterned { field, map, .. } => field.depth().max(map.depth()),
            TextureBody::MaterialMap { image, textures, .. } => image.depth().max(textures.depth()),
            TextureBody::UvMapped(inner) => inner.depth(),
        }
    }
}

impl Depth for Layer {
    fn depth(&self) -> u32 {
        let paint = match &self.paint {
            Paint::Color(_) => 0,
            Paint::Pigment(pigment) => pigment.depth(),
        };
        paint.max(self.normal.depth())
    }
}

impl Depth for Pigment {
    fn depth(&self) -> u32 {
        match &self.kind {
            PigmentKind::Color(_) => 0,
            PigmentKind::Colors { field, .. } | PigmentKind::Image { field, .. } => field.depth(),
            PigmentKind::Pigments { field, map } => field.depth().max(map.depth()),
            PigmentKind::UvMapped(inner) => inner.depth(),
        }
    }
}

impl Depth for Normal {
    fn depth(&self) -> u32 {
        match &self.kind {
            NormalKind::Pattern { field, .. } | NormalKind::Bumps { field, .. } => field.depth(),
            NormalKind::Normals { field, map } => field.depth().max(map.depth()),
            NormalKind::UvMapped(inner) => inner.depth(),
        }
    }
}

impl Depth for Field {
    fn depth(&self) -> u32 {
        self.pattern.depth()
    }
}

impl Depth for Pattern {
    fn depth(&self) -> u32 {
        match self {
            Self::Function(function) => function.depth(),
            Self::Image(map) => map.depth(),
            Self::Object(object) => object.depth(),
            Self::Pigment(pigment) => pigment.depth(),
            _ => 0,
        }
    }
}

impl Depth for ImageMap {
    fn depth(&self) -> u32 {
        self.source.depth()
    }
}

impl Depth for ImageSource {
    fn depth(&self) -> u32 {
        match &self.origin {
            ImageOrigin::File { .. } => 0,
            ImageOrigin::Function { function, .. } => function.depth(),
        }
    }
}

impl Depth for Function {
    fn depth(&self) -> u32 {
        self.body.depth()
    }
}

impl Depth for FunctionBody {
    fn depth(&self) -> u32 {
        match self {
            Self::Expression(expr) => expr.depth(),
            Self::Pattern(field) => field.depth(),
            Self::Pigment(pigment) => pigment.depth(),
            Self::Internal(_) | Self::Transform(_) | Self::Spline(_) => 0,
        }
    }
}

impl Depth for Expr {
    fn depth(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Parameter(_) | Self::Running(_) => 0,
            Self::Negate(operand) | Self::Power(operand, _) => operand.depth(),
            Self::Binary(_, left, right) => left.depth().max(right.depth()),
            Self::Call(_, operands) | Self::Recursion(operands) => operands.depth(),
            Self::User(function, operands) | Self::Component(function, operands, _) => {
                function.depth().max(operands.depth())
            }
            Self::Sum(parts) | Self::Product(parts) => deepest(&**parts),
        }
    }
}

impl Depth for Interior {
    fn depth(&self) -> u32 {
        self.media.depth()
    }
}

impl Depth for Media {
    fn depth(&self) -> u32 {
        self.densities.depth()
    }
}

impl Depth for Material {
    fn depth(&self) -> u32 {
        self.texture.depth().max(self.interior_texture.depth()).max(self.interior.depth())
    }
}

impl Depth for SkySphere {
    fn depth(&self) -> u32 {
        self.pigments.depth()
    }
}

impl Depth for Camera {
    fn depth(&self) -> u32 {
        self.normal.depth().max(self.blur.as_ref().map_or(0, |blur| blur.bokeh.depth()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;
    use crate::source::Span;

    fn blend(inner: Pigment) -> Pigment {
        let field = Arc::new(Field::new(Span::default(), Pattern::Gradient(DVec3::X)));
        let map = Arc::new(BlendMap::list([Arc::new(inner), Arc::new(Pigment::color(Rgbft::BLACK))]));
        Pigment { kind: PigmentKind::Pigments { field, map }, quick_color: None }
    }

    #[test]
    fn a_pigment_is_as_deep_as_its_deepest_entry() {
        let flat = Pigment::color(Rgbft::BLACK);
        assert_eq!(flat.depth(), 0);
        let two = blend(blend(flat.clone()));
        assert_eq!(two.depth(), 1 + blend(flat).depth());
        assert_eq!(blend(two.clone()).depth(), 1 + two.depth());
    }

    #[test]
    fn an_object_is_as_deep_as_what_it_wears() {
        let mut object = Object::new(Span::default(), Shape::Sphere { center: DVec3::ZERO, radius: 1.0 });
        assert_eq!(object.depth(), 0);
        let pigment = blend(blend(Pigment::color(Rgbft::BLACK)));
        let depth = pigment.depth();
        let paint = Paint::Pigment(Arc::new(pigment));
        let layer = Layer { span: Span::default(), paint, normal: None, finish: Arc::default() };
        object.texture = Some(layer.into());
        assert_eq!(object.depth(), depth);
        let looks_at = Field::new(Span::default(), Pattern::Object(Arc::new(object)));
        assert_eq!(looks_at.depth(), depth + 1);
    }
}
