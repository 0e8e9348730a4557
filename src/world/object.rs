//! What rays meet: primitives in their places, and the trees and objects made of them.

use std::ops::Range;

use bitflags::bitflags;

use super::extent::{Extent, around_rounding, half_space};
use super::ray::Ray;
use super::shape::{Primitive, Shape};
use crate::math::{Bounds, DVec3, Transform, tally};

bitflags! {
    /// Kinds of rays; for an object, those that don't see it (docs/spec/shading.md 3).
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct RayKind: u8 {
        /// From the camera, or transmitted from such a ray: `no_image`.
        const IMAGE = 1;
        /// Reflected, or descending from a reflected one: `no_reflection`.
        const REFLECTION = 1 << 1;
        /// Towards a light: `no_shadow`.
        const SHADOW = 1 << 2;
        /// Gathering indirect light: `no_radiosity`.
        const RADIOSITY = 1 << 3;
    }
}

bitflags! {
    /// The on/off traits of a [`Leaf`].
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct LeafFlags: u16 {
        /// Inside and outside are exchanged.
        const INVERTED = 1;
        /// The outward normal is the shape's own, reversed.
        const REVERSED = 1 << 1;
        /// It has an inside.
        const SOLID = 1 << 2;
        /// No light passes: all its textures are opaque everywhere.
        const OPAQUE = 1 << 3;
        /// Lit from both sides.
        const DOUBLE_ILLUMINATE = 1 << 4;
        /// Textures are evaluated at `<u,v,0>`.
        const UV_MAPPING = 1 << 5;
        /// Light passes unchanged: all its pigments are perfectly clear.
        const CLEAR = 1 << 6;
        /// Nothing of it is seen: clear, and without highlights and reflections.
        const INVISIBLE = 1 << 7;
        /// All beyond its box is inside.
        const BEYOND = 1 << 8;
        /// It has [limits](Leaf::limits).
        const LIMITED = 1 << 9;
        /// It shows more than one texture: another from inside, or those of a list.
        const SEVERAL = 1 << 10;
    }
}

/// A primitive in its place.
#[derive(Debug)]
pub struct Leaf {
    /// The geometry, in its own space.
    pub primitive: Primitive,
    /// From the primitive's space to the world; `None` is the identity.
    pub transform: Option<Box<Transform>>,
    /// What few of very many leaves have.
    pub rare: Option<Box<Rare>>,
    /// The size of the numbers that its points are computed from, but for those of the ray.
    pub reach: f32,
    /// On/off traits.
    pub flags: LeafFlags,
    /// Rays that pass through it.
    pub hidden: RayKind,
    /// The surface: a number into the world's textures; `None` takes that of the solids cut
    /// (`cutaway_textures`) or brings its own.
    pub texture: Numbered,
    /// What it is filled with: a number into the world's interiors.
    pub interior: u32,
    /// Which lights reach it: a number into the world's light sets.
    pub lights: u32,
    /// The statement it comes from, for whoever started the rendering to look up.
    pub origin: u32,
}

/// What few of very many leaves have.
#[derive(Debug)]
pub struct Rare {
    /// The box where the leaf's inside may be, and all of its surface, where that isn't its primitive's own:
    /// only compounds ask often enough to keep that.
    bounds: Option<Bounds>,
    limits: Option<Box<Limits>>,
    parent: Numbered,
    interior_texture: Numbered,
    own_textures: Range<u32>,
}

impl Rare {
    const NONE: Self = Self {
        bounds: None,
        limits: None,
        parent: Numbered::NONE,
        interior_texture: Numbered::NONE,
        own_textures: 0..0,
    };
}

/// A number that may be missing, in the room of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Numbered(u32);

impl Numbered {
    /// No number.
    pub const NONE: Self = Self(u32::MAX);

    /// The number, if there is one.
    #[inline(always)]
    pub fn get(self) -> Option<u32> {
        (self != Self::NONE).then_some(self.0)
    }
}

impl From<Option<u32>> for Numbered {
    fn from(number: Option<u32>) -> Self {
        number.map_or(Self::NONE, Self)
    }
}

impl Leaf {
    /// Where its inside may be, and all of its surface.
    #[inline]
    pub fn extent(&self) -> Extent {
        let bounds = self.rare.as_ref().and_then(|rare| rare.bounds).unwrap_or_else(|| self.own_bounds());
        Extent { bounds, beyond: self.flags.contains(LeafFlags::BEYOND) }
    }

    /// The box around its primitive.
    fn own_bounds(&self) -> Bounds {
        let place = self.transform.as_deref();
        around_rounding(match (&self.primitive, place) {
            (Primitive::Plane(plane), _) => half_space(plane.normal, plane.distance, place, 0.0),
            (primitive, Some(place)) => primitive.bounds().transformed(place),
            (primitive, None) => primitive.bounds(),
        })
    }

    /// `clipped_by` and `bounded_by`.
    #[inline]
    pub fn limits(&self) -> Option<&Limits> {
        self.rare.as_ref()?.limits.as_deref()
    }

    /// Whether there is anything it is clipped or bounded by.
    #[inline(always)]
    pub fn is_limited(&self) -> bool {
        self.flags.contains(LeafFlags::LIMITED)
    }

    /// Whether four rays of the world are held against it at once.
    #[inline(always)]
    pub fn meets_four(&self) -> bool {
        self.transform.is_none() && !self.is_limited() && self.primitive.takes_four()
    }

    /// The compound it is a member of.
    pub fn parent(&self) -> Option<u32> {
        self.rare.as_ref()?.parent.get()
    }

    /// The surface seen from inside, where that is another: a number into the world's textures.
    #[inline]
    pub fn interior_texture(&self) -> Option<u32> {
        let rare = self.rare.as_ref().filter(|_| self.flags.contains(LeafFlags::SEVERAL))?;
        rare.interior_texture.get()
    }

    /// Where in the world's textures the shape's own list is; empty for most.
    #[inline]
    pub fn own_textures(&self) -> Range<u32> {
        let rare = self.rare.as_ref().filter(|_| self.flags.contains(LeafFlags::SEVERAL));
        rare.map_or(0..0, |rare| rare.own_textures.clone())
    }

    fn rare(&mut self) -> &mut Rare {
        self.rare.get_or_insert_with(|| Box::new(Rare::NONE))
    }

    /// Keeps the box where its inside may be, and all of its surface.
    pub fn set_bounds(&mut self, bounds: Bounds) {
        self.rare().bounds = Some(bounds);
    }

    /// Keeps the box no longer, unless it is not its primitive's own.
    pub fn forget_bounds(&mut self) {
        if self.is_limited() {
            return;
        }
        self.rare().bounds = None;
        if !self.flags.contains(LeafFlags::SEVERAL) && self.parent().is_none() {
            self.rare = None;
        }
    }

    /// Replaces what it is clipped and bounded by.
    pub fn set_limits(&mut self, limits: Option<Box<Limits>>) {
        self.flags.set(LeafFlags::LIMITED, limits.is_some());
        if limits.is_some() || self.rare.is_some() {
            self.rare().limits = limits;
        }
    }

    /// What it is clipped and bounded by, to be added to.
    pub fn limit(&mut self) -> &mut Limits {
        self.flags.insert(LeafFlags::LIMITED);
        self.rare().limits.get_or_insert_default()
    }

    /// Makes it a member of a compound.
    pub fn set_parent(&mut self, group: u32) {
        self.rare().parent = Some(group).into();
    }

    /// Gives it a surface seen from inside, or a list of its own.
    pub fn set_textures(&mut self, inner: Numbered, own: Range<u32>) {
        let several = inner != Numbered::NONE || !own.is_empty();
        self.flags.set(LeafFlags::SEVERAL, several);
        if several {
            let rare = self.rare();
            (rare.interior_texture, rare.own_textures) = (inner, own);
        }
    }

    /// The ray in the primitive's space.
    #[inline(always)]
    pub(super) fn inner(&self, ray: &Ray) -> Ray {
        self.transform.as_ref().map_or(*ray, |transform| ray.to_inner(transform))
    }

    /// The ray in the primitive's space, to ask where it meets the primitive.
    #[inline(always)]
    pub(super) fn asked(&self, ray: &Ray) -> Ray {
        tally::primitives(1);
        self.inner(ray)
    }

    /// Whether it is a solid that any line is inside of on one stretch, and nothing cuts it.
    pub fn is_convex(&self) -> bool {
        self.primitive.is_convex() && self.flags.contains(LeafFlags::SOLID) && !self.is_limited()
    }

    /// The point in the primitive's space.
    #[inline]
    pub fn inner_point(&self, point: DVec3) -> DVec3 {
        self.transform.as_ref().map_or(point, |transform| transform.inverse_point(point))
    }

    /// A normal of the primitive in the world: outward, unit.
    #[inline]
    pub(super) fn outer_normal(&self, normal: DVec3) -> DVec3 {
        let normal = self.transform.as_ref().map_or(normal, |transform| transform.normal(normal));
        self.outward(normal.normalize_or_zero())
    }

    /// A unit normal of the primitive, turned outward.
    #[inline]
    pub(super) fn outward(&self, normal: DVec3) -> DVec3 {
        if self.flags.contains(LeafFlags::REVERSED) { -normal } else { normal }
    }

    /// Whether it is known that no straight way between any two of the points meets the surface.
    pub(super) fn is_apart_from(&self, points: &[DVec3]) -> bool {
        let inside = |&point: &DVec3| self.primitive.inside(self.inner_point(point));
        match self.primitive {
            // On either side of a plane any two points see each other.
            Primitive::Plane(_) => points.iter().all(inside) || !points.iter().any(inside),
            Primitive::Sphere(_) | Primitive::Box(_) | Primitive::Cylinder(_) | Primitive::Cone(_) => {
                points.iter().all(inside)
            }
            _ => false,
        }
    }

    /// Whether `point` is inside, but for clips.
    #[inline]
    pub fn contains(&self, point: DVec3) -> bool {
        let point = self.inner_point(point);
        self.flags.contains(LeafFlags::SOLID)
            && match self.flags.contains(LeafFlags::INVERTED) {
                false => self.primitive.inside(point),
                true => self.primitive.outside(point),
            }
    }
}

/// A primitive or a compound of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Member {
    /// Number of a [`Leaf`].
    Leaf(u32),
    /// Number of a [`Group`](super::parts::Group).
    Group(u32),
}

/// `clipped_by` and `bounded_by`.
#[derive(Debug, Default)]
pub struct Limits {
    /// Only points inside all of these remain.
    pub clips: Vec<Member>,
    /// Rays that neither start in nor hit each of these miss the object.
    pub bounds: Vec<Member>,
}
