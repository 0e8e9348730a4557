//! Objects: a shape, where it is, what it looks like.

use std::sync::Arc;

use bitflags::bitflags;

use super::depth::Nested;
use super::{Interior, Shape, Texture};
use crate::math::Transform;
use crate::source::Span;

/// A shape with its modifiers.
///
/// Every transform written after the shape acts on the shape ([`Object::transform`]) and on the
/// textures, interiors, clips and bounds written before it (each carries its own). All of them map
/// into the same *outer* space: that of the enclosing CSG, or the world.
#[derive(Clone, Debug)]
pub struct Object {
    /// Where the statement stands.
    pub span: Span,
    /// The geometry, in its own space.
    pub shape: Shape,
    /// From the shape's space to the outer one; `None` is the identity.
    pub transform: Option<Arc<Transform>>,
    /// The surface; `None` takes the enclosing CSG's, and at the top the default texture.
    pub texture: Option<Texture>,
    /// `hollow`, `inverse`, `no_shadow` and their kin.
    pub flags: ObjectFlags,
    /// What few objects have.
    pub extra: Option<Box<ObjectExtra>>,
}

/// The rarely used modifiers of an [`Object`].
#[derive(Clone, Debug, Default)]
pub struct ObjectExtra {
    /// The surface seen from inside.
    pub interior_texture: Option<Texture>,
    /// What the object is filled with.
    pub interior: Option<Arc<Interior>>,
    /// Only points inside all of these remain.
    pub clipped_by: Nested<Vec<Arc<Object>>>,
    /// Rays that miss one of these miss the object.
    pub bounded_by: Nested<Vec<Arc<Object>>>,
    /// `photons { … }`.
    pub photons: Option<PhotonFlags>,
    /// `radiosity { importance F }`, in (0, 1].
    pub radiosity_importance: Option<f64>,
}

/// `photons { … }` of an object.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PhotonFlags {
    /// Spacing multiplier where the object is a target.
    pub target: Option<f64>,
    /// `reflection`, where written.
    pub reflection: Option<bool>,
    /// `refraction`, where written.
    pub refraction: Option<bool>,
    /// Photons go through as if the object were not there.
    pub pass_through: bool,
    /// `collect off`: photons are neither stored nor gathered here.
    pub ignore_photons: bool,
}

bitflags! {
    /// The on/off modifiers of an object. A flag that POV-Ray distinguishes from "not written"
    /// has a second one that says it was.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct ObjectFlags: u32 {
        /// The interior doesn't displace fog and media.
        const HOLLOW = 1;
        /// `hollow` was written, on or off: a CSG's doesn't reach this object.
        const HOLLOW_SET = 1 << 1;
        /// Inside and outside are exchanged.
        const INVERSE = 1 << 2;
        /// Casts no shadow.
        const NO_SHADOW = 1 << 3;
        /// Invisible to the camera.
        const NO_IMAGE = 1 << 4;
        /// Invisible in reflections.
        const NO_REFLECTION = 1 << 5;
        /// Invisible to radiosity.
        const NO_RADIOSITY = 1 << 6;
        /// Lit from both sides.
        const DOUBLE_ILLUMINATE = 1 << 7;
        /// `double_illuminate` was written.
        const DOUBLE_ILLUMINATE_SET = 1 << 8;
        /// Accepted; povista's solvers don't need it.
        const STURM = 1 << 9;
        /// Accepted; povista always builds a hierarchy.
        const HIERARCHY = 1 << 10;
        /// Textures are evaluated at `<u,v,0>`.
        const UV_MAPPING = 1 << 11;
        /// Cut faces take the texture of the solid that was cut.
        const CUTAWAY_TEXTURES = 1 << 12;
        /// `bounded_by { clipped_by }` or the reverse: one list serves both.
        const BOUNDS_ARE_CLIPS = 1 << 13;
        /// This object or a member of it was given a texture.
        const TEXTURED = 1 << 14;
    }
}

impl Object {
    /// A shape without modifiers.
    pub fn new(span: Span, shape: Shape) -> Self {
        Self { span, shape, transform: None, texture: None, flags: ObjectFlags::empty(), extra: None }
    }

    /// Its interior, if it was given one.
    pub fn interior(&self) -> Option<&Arc<Interior>> {
        self.extra.as_ref()?.interior.as_ref()
    }

    /// Applies a transform to the shape and to everything given so far.
    ///
    /// Textures stay where they are on objects with `uv_mapping` (docs/spec/primitives.md 1.1).
    pub fn apply(&mut self, by: &Transform) {
        let moves_textures = !self.flags.contains(ObjectFlags::UV_MAPPING);
        let before = self.transform.clone();
        compose(&mut self.transform, by);
        if let Some(texture) = self.texture.as_mut().filter(|_| moves_textures) {
            // What was moved together so far shares where it is.
            if before.as_ref().map(Arc::as_ptr) == texture.transform.as_ref().map(Arc::as_ptr) {
                texture.transform.clone_from(&self.transform);
            } else {
                compose(&mut texture.transform, by);
            }
        }
        let Some(extra) = self.extra.as_deref_mut() else {
            return;
        };
        if let Some(texture) = extra.interior_texture.as_mut().filter(|_| moves_textures) {
            compose(&mut texture.transform, by);
        }
        if let Some(interior) = extra.interior.as_mut().filter(|i| !i.media.is_empty()) {
            Arc::make_mut(interior).apply(by);
        }
        for list in [&mut extra.clipped_by, &mut extra.bounded_by] {
            for object in list.inside_mut() {
                Arc::make_mut(object).apply(by);
            }
        }
    }
}

/// Composes `next` after a transform in which `None` is the identity.
pub fn compose(transform: &mut Option<Arc<Transform>>, next: &Transform) {
    *transform = Some(Arc::new(match transform {
        Some(first) => first.then(next),
        None => *next,
    }));
}
