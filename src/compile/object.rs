//! Objects: what they inherit, and leaves made of their primitives.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::Unsupported;
use super::flatten::{Flattener, Inherited};
use super::probe::inside_of;
use super::shape::settled::settled;
use super::shape::{self, Compiled};
use super::texture::TextureCompiler;
use crate::math::{Bounds, DMat3, DVec3, Transform};
use crate::scene::depth::DEEPEST;
use crate::scene::object::ObjectFlags;
use crate::scene::texture::{LegacyFinish, TextureBody};
use crate::scene::{Object, Shape, Texture};
use crate::world::extent::{Extent, around_rounding, half_space};
use crate::world::narrow;
use crate::world::object::{LeafFlags, Limits};
use crate::world::shape::r#box::Cuboid;
use crate::world::shape::{Primitive, Shape as _};
use crate::world::{Leaf, Member, RayKind};

/// Stack that must be left for one more level, and how much more there is when it isn't.
const RED_ZONE: usize = 64 << 10;
const MORE: usize = 1 << 20;

/// Big primitives that several objects share, by the identity of their description, which is kept so that
/// its address stays its own.
pub(super) type ShapeCache = FxHashMap<(*const (), u64, bool), (Shape, Compiled)>;

impl Flattener<'_> {
    /// What an object has, of its own or inherited.
    pub(super) fn own(&mut self, object: &Object, around: &Inherited) -> Inherited {
        let flags = object.flags;
        let written =
            |set, flag, inherited| if flags.contains(set) { flags.contains(flag) } else { inherited };
        let says_uv = flags.contains(ObjectFlags::UV_MAPPING);
        let mut own = Inherited {
            hollow: written(ObjectFlags::HOLLOW_SET, ObjectFlags::HOLLOW, around.hollow),
            double_illuminate: written(
                ObjectFlags::DOUBLE_ILLUMINATE_SET,
                ObjectFlags::DOUBLE_ILLUMINATE,
                around.double_illuminate,
            ),
            uv_mapping: says_uv || around.uv_mapping,
            hidden: around.hidden | (hidden(flags) & around.heeded),
            inverted: around.inverted != flags.contains(ObjectFlags::INVERSE),
            cutaway: around.cutaway || flags.contains(ObjectFlags::CUTAWAY_TEXTURES),
            ..around.clone()
        };
        // Textures stay where they are on objects that say so themselves (docs/spec/primitives.md 1.1).
        let outer = if says_uv { None } else { own.outer.clone() };
        if let Some(texture) = &object.texture {
            own.texture = Some(self.texture_again(texture, outer.clone()));
        }
        let extra = object.extra.as_deref();
        if let Some(texture) = extra.and_then(|extra| extra.interior_texture.as_ref()) {
            own.interior_texture = Some(self.texture(texture, outer));
        }
        let says_more = object.texture.as_ref().is_some_and(|texture| legacy(texture).is_some());
        if object.interior().is_some() || says_more {
            let inherited = || {
                let around = self.flat.interiors[own.interior? as usize];
                self.flat.fillings[around.filling.get()? as usize].interior.clone()
            };
            let interior = object.interior().cloned().or_else(inherited);
            own.interior = Some(self.filled(interior, &own));
        }
        own
    }

    /// What an object hands down to the objects in it.
    pub(super) fn within(&mut self, object: &Object, around: &Inherited) -> Inherited {
        self.own(object, around).hand_down(object)
    }

    /// Adds an object and all its parts; `None` where it has no geometry or can't be compiled.
    pub(super) fn member(&mut self, object: &Object, around: &Inherited) -> Option<Member> {
        if around.depth > DEEPEST {
            let limit = format!("objects nested more than {} deep", DEEPEST);
            self.flat.unsupported.push(Unsupported::new(object.span, limit));
            return None;
        }
        let own = self.own(object, around);
        stacker::maybe_grow(RED_ZONE, MORE, || self.placed(object, &own))
    }

    /// Adds an object of which it is known what it has.
    pub(super) fn placed(&mut self, object: &Object, own: &Inherited) -> Option<Member> {
        match &object.shape {
            Shape::Csg(csg) => self.compound(csg, object, own),
            Shape::Light(light) => self.light(light, object, own),
            Shape::LightGroup(_) => {
                self.flat
                    .unsupported
                    .push(Unsupported::new(object.span, "`light_group` inside a CSG object"));
                None
            }
            primitive => self.leaf(primitive, object, own),
        }
    }

    fn leaf(&mut self, primitive: &Shape, object: &Object, own: &Inherited) -> Option<Member> {
        let outer = own.inner(object);
        let compiled = match self.primitive(primitive, object, outer.as_deref(), own.asked) {
            Ok(compiled) => compiled,
            Err(unsupported) => {
                self.flat.unsupported.push(unsupported);
                return None;
            }
        };
        let transform = match (compiled.transform, &outer) {
            (Some(first), Some(then)) => Some(Box::new(first.then(then))),
            (Some(only), None) => Some(Box::new(only)),
            (None, only) => only.as_ref().map(|only| Box::new(**only)),
        };
        let settled = transform.as_ref().and_then(|transform| settled(&compiled.primitive, transform));
        let first = self.flat.textures.len() as u32;
        for texture in own_list(primitive) {
            let outer = outer.clone().filter(|_| !object.flags.contains(ObjectFlags::UV_MAPPING));
            self.texture(texture, outer);
        }
        let own_textures = first..self.flat.textures.len() as u32;
        let texture = own.texture.or_else(|| {
            let from_cut_solids = own.cutaway && own.cut;
            (!from_cut_solids).then(|| self.default_texture())
        });
        let solid = compiled.primitive.is_solid();
        let inverted = solid && own.inverted;
        let mut flags = LeafFlags::empty();
        flags.set(LeafFlags::SOLID, solid);
        flags.set(LeafFlags::INVERTED, inverted);
        // A quadric is turned inside out twice as far as its normal goes (docs/spec/primitives.md 1.4).
        flags.set(LeafFlags::REVERSED, inverted && !matches!(primitive, Shape::Quadric(_)));
        flags.set(LeafFlags::DOUBLE_ILLUMINATE, own.double_illuminate);
        flags.set(LeafFlags::UV_MAPPING, own.uv_mapping);
        let bounds = around_rounding(match (primitive, &transform) {
            (&Shape::Plane { normal, distance }, transform) => {
                half_space(normal, distance, transform.as_deref(), 0.0)
            }
            // Their inside goes on without end behind the surface.
            (Shape::Disc(_) | Shape::HeightField(_), _) if own.asked => Bounds::ALL,
            (_, Some(transform)) => compiled.primitive.bounds().transformed(transform),
            (_, None) => compiled.primitive.bounds(),
        });
        if let Some(interior) = own.interior {
            // Of members that share an interior the last one says whether it is hollow.
            self.flat.interiors[interior as usize].hollow = own.hollow;
        }
        let limits = self.limits(object, own);
        let extent = self.clipped(Extent { bounds, beyond: inverted }, limits.as_deref());
        flags.set(LeafFlags::BEYOND, extent.beyond);
        // A loop makes many objects at one place of the text.
        if self.flat.spans.last() != Some(&object.span) {
            self.flat.spans.push(object.span);
        }
        let transform = transform.filter(|_| settled.is_none());
        let mut leaf = Leaf {
            primitive: settled.unwrap_or(compiled.primitive),
            reach: reach(extent, transform.as_deref()) as f32,
            transform,
            rare: None,
            flags,
            hidden: own.hidden,
            texture: texture.into(),
            interior: own.interior.unwrap_or(0),
            lights: own.lights,
            origin: self.flat.spans.len() as u32 - 1,
        };
        leaf.set_textures(own.interior_texture.into(), own_textures);
        leaf.set_limits(limits);
        self.settle(&mut leaf);
        leaf.set_bounds(self.narrowed(&leaf, extent));
        self.flat.parts.leaves.push(leaf);
        Some(Member::Leaf(self.flat.parts.leaves.len() as u32 - 1))
    }

    /// Tells a primitive what it is clipped or bounded by.
    fn settle(&self, leaf: &mut Leaf) {
        let Primitive::Other(shape) = &leaf.primitive else { return };
        let Some(limits) = leaf.limits() else { return };
        if let Some(gate) = self.gate(leaf, limits)
            && let Some(shape) = shape.behind_gate(gate)
        {
            leaf.primitive = Primitive::Other(shape);
            leaf.set_limits(None);
            return;
        }
        let limits = limits.clips.iter().chain(&limits.bounds).map(|&limit| self.flat.parts.extent(limit));
        let Extent { bounds, beyond: false } = Extent::intersection(limits) else { return };
        if !bounds.is_finite() || bounds.is_empty() {
            return;
        }
        let center = leaf.inner_point(bounds.center());
        let far = |corner: DVec3| leaf.inner_point(corner).distance(center);
        let radius = bounds.corners().into_iter().map(far).fold(0.0, f64::max);
        if radius.is_finite()
            && let Some(shape) = shape.at_home_in(center, radius)
        {
            leaf.primitive = Primitive::Other(shape);
        }
    }

    /// The box that is all a leaf is limited by, where it is one in the space of its primitive too.
    fn gate(&self, leaf: &Leaf, limits: &Limits) -> Option<Cuboid> {
        let (&[Member::Leaf(bound)], []) = (&limits.bounds[..], &limits.clips[..]) else {
            return None;
        };
        let bound = self.flat.parts.leaf(bound);
        let Primitive::Box(cuboid) = bound.primitive else { return None };
        if bound.is_limited() || bound.flags.contains(LeafFlags::INVERTED) {
            return None;
        }
        let (place, own) = (bound.transform.as_deref(), leaf.transform.as_deref());
        if place == own {
            return Some(cuboid);
        }
        let (None, Some(own)) = (place, own) else { return None };
        let matrix = own.inverse.matrix3;
        let is_straight = matrix == DMat3::from_diagonal(matrix.diagonal());
        let [low, high] = [cuboid.min, cuboid.max].map(|corner| own.inverse_point(corner));
        is_straight.then(|| Cuboid { min: low.min(high), max: low.max(high) })
    }

    /// A box around what clips leave of a leaf with this extent.
    fn narrowed(&self, leaf: &Leaf, extent: Extent) -> Bounds {
        let clips = leaf.limits().map_or(&[][..], |limits| &limits.clips);
        if clips.is_empty() || extent.beyond {
            return extent.bounds;
        }
        let clips = clips.iter().filter_map(|clip| match *clip {
            Member::Leaf(number) => Some(self.flat.parts.leaf(number)),
            Member::Group(_) => None,
        });
        narrow::common(std::iter::once(leaf).chain(clips), extent.bounds)
    }

    /// The primitive of an object in its own space, made to be seen from that around it.
    pub(super) fn primitive(
        &mut self,
        primitive: &Shape,
        object: &Object,
        outer: Option<&Transform>,
        asked: bool,
    ) -> Result<Compiled, Unsupported> {
        let enlarged = outer.map_or(1.0, |outer| enlargement(primitive, outer));
        let Some(identity) = identity(primitive, enlarged, asked) else {
            return self.compile(primitive, object, enlarged, asked);
        };
        if let Some((_, compiled)) = self.shapes.get(&identity) {
            return Ok(compiled.clone());
        }
        let compiled = self.compile(primitive, object, enlarged, asked)?;
        self.shapes.insert(identity, (primitive.clone(), compiled.clone()));
        Ok(compiled)
    }

    fn compile(
        &self,
        primitive: &Shape,
        object: &Object,
        enlarged: f64,
        asked: bool,
    ) -> Result<Compiled, Unsupported> {
        let inside = |object: &Arc<Object>| inside_of(object, self.settings);
        let mut functions = TextureCompiler::new(self.settings).with_objects(&inside);
        match primitive {
            Shape::HeightField(field) => shape::height_field::height_field(field, &mut functions),
            Shape::Isosurface(surface) => shape::isosurface::isosurface(surface, asked, &mut functions),
            Shape::Parametric(surface) => shape::parametric::parametric(surface, &mut functions),
            Shape::Text(text) => shape::text::text(text, object.span),
            Shape::BicubicPatch(patch) => Ok(shape::bicubic_patch(patch, enlarged)),
            _ => shape::shape(primitive)
                .map_err(|keyword| Unsupported::new(object.span, format!("`{keyword}`"))),
        }
    }
}

/// How many times larger a primitive whose fineness is a length in the scene is seen from around it,
/// 1 or more: what is made smaller keeps its shape, where POV-Ray's becomes coarser
/// (docs/spec/primitives.md 9).
fn enlargement(primitive: &Shape, outer: &Transform) -> f64 {
    match primitive {
        Shape::BicubicPatch(_) => {
            DVec3::AXES.map(|axis| outer.vector(axis).length()).into_iter().fold(1.0, f64::max)
        }
        _ => 1.0,
    }
}

/// What the copies of a big primitive share: where its description is, the bits of how many times it is enlarged,
/// and, of an isosurface, whether something asks for points inside.
fn identity(primitive: &Shape, enlarged: f64, asked: bool) -> Option<(*const (), u64, bool)> {
    let description = match primitive {
        Shape::Mesh(mesh) => Arc::as_ptr(mesh).cast(),
        Shape::HeightField(field) => Arc::as_ptr(field).cast(),
        Shape::Text(text) => Arc::as_ptr(text).cast(),
        Shape::BicubicPatch(patch) => Arc::as_ptr(patch).cast(),
        Shape::Blob(blob) => Arc::as_ptr(blob).cast(),
        Shape::Isosurface(surface) => Arc::as_ptr(surface).cast(),
        Shape::Parametric(surface) => Arc::as_ptr(surface).cast(),
        _ => return None,
    };
    let asked = asked && matches!(primitive, Shape::Isosurface(_));
    Some((description, enlarged.to_bits(), asked))
}

/// The textures that parts of a primitive refer to by number.
fn own_list(primitive: &Shape) -> Vec<&Texture> {
    match primitive {
        Shape::Mesh(mesh) => mesh.textures.iter().collect(),
        Shape::Blob(blob) => {
            blob.components.iter().filter_map(|component| component.texture.as_ref()).collect()
        }
        _ => Vec::new(),
    }
}

/// The kinds of rays an object is hidden from.
fn hidden(flags: ObjectFlags) -> RayKind {
    let mut hidden = RayKind::empty();
    hidden.set(RayKind::IMAGE, flags.contains(ObjectFlags::NO_IMAGE));
    hidden.set(RayKind::REFLECTION, flags.contains(ObjectFlags::NO_REFLECTION));
    hidden.set(RayKind::SHADOW, flags.contains(ObjectFlags::NO_SHADOW));
    hidden.set(RayKind::RADIOSITY, flags.contains(ObjectFlags::NO_RADIOSITY));
    hidden
}

/// What the finish of a plain texture says about the interior, as old scenes do.
pub(super) fn legacy(texture: &Texture) -> Option<&LegacyFinish> {
    let TextureBody::Layered(layers) = &*texture.body else {
        return None;
    };
    layers.iter().rev().map(|layer| &layer.finish.legacy).find(|legacy| legacy.is_set())
}

/// The size of the numbers that a point of a primitive is computed from in the world, but for the ray's.
fn reach(extent: Extent, transform: Option<&Transform>) -> f64 {
    let size = if extent.bounds.is_finite() { extent.bounds.size().max_element() } else { 0.0 };
    size + transform.map_or(0.0, |transform| transform.forward.translation.abs().max_element())
}
