//! Takes the objects of a scene apart into leaves, compounds and what they refer to.
//!
//! Nested transforms become one, what compounds hand down to their members is handed down, and
//! unions that cut nothing are dissolved. Textures, interiors and lights are only collected here:
//! as places in lists, to be compiled by whoever needs them.

use std::sync::Arc;

use super::Unsupported;
use super::bounds::Bounded;
use super::object::{ShapeCache, legacy};
use crate::math::Transform;
use crate::options::Accelerator;
use crate::scene::object::ObjectFlags;
use crate::scene::settings::Settings;
use crate::scene::shape::{Csg, CsgOperation, LightGroup};
use crate::scene::texture::LegacyFinish;
use crate::scene::{Interior, Light, Object, Shape, Texture};
use crate::source::Span;
use crate::world::object::Numbered;
use crate::world::parts::{Object as Whole, Parts};
use crate::world::{Member, RayKind};

/// From so many objects on each takes as little room as it can.
const MANY: usize = 4096;

/// What [`Flattener`] makes of a scene's objects.
#[derive(Debug, Default)]
pub struct Flat {
    /// The geometry; its leaves number the textures, interiors and light sets below.
    pub parts: Parts,
    /// Surfaces.
    pub textures: Vec<TextureUse>,
    /// Interiors; leaves with the same number enclose one body.
    pub interiors: Vec<InteriorUse>,
    /// What they are filled with, but for air.
    pub fillings: Vec<Filling>,
    /// Lights.
    pub lights: Vec<LightUse>,
    /// For each light set the lights in it.
    pub light_sets: Vec<Vec<u32>>,
    /// The statement of each leaf's `origin`.
    pub spans: Vec<Span>,
    /// What had to be left out.
    pub unsupported: Vec<Unsupported>,
}

/// A texture and the transforms of the compounds around its object.
#[derive(Clone, Debug)]
pub struct TextureUse {
    /// The texture.
    pub texture: Texture,
    /// From the texture's outer space to the world; `None` is the identity.
    pub outer: Option<Arc<Transform>>,
}

/// What a surface encloses. Small, as every object has one.
#[derive(Clone, Copy, Debug)]
pub struct InteriorUse {
    /// A number into [`Flat::fillings`]; none is air.
    pub filling: Numbered,
    /// Whether it doesn't displace fog and media.
    pub hollow: bool,
}

/// A filling.
#[derive(Clone, Debug)]
pub struct Filling {
    /// As written; `None` is air.
    pub interior: Option<Arc<Interior>>,
    /// From the interior's outer space to the world; `None` is the identity.
    pub outer: Option<Arc<Transform>>,
    /// What the finish of the object's texture says about it, as in old scenes.
    pub legacy: Option<LegacyFinish>,
}

/// A light.
#[derive(Clone, Debug)]
pub struct LightUse {
    /// The light.
    pub light: Arc<Light>,
    /// From the light's space to the world.
    pub transform: Transform,
    /// The object it is projected through: a number into [`Parts::objects`].
    pub projected_through: Option<u32>,
}

/// What a compound hands down to its members, and an object to its parts.
#[derive(Clone, Debug)]
pub(super) struct Inherited {
    /// From the compound's inner space to the world.
    pub(super) outer: Option<Arc<Transform>>,
    pub(super) texture: Option<u32>,
    pub(super) interior_texture: Option<u32>,
    pub(super) interior: Option<u32>,
    pub(super) hollow: bool,
    pub(super) double_illuminate: bool,
    pub(super) uv_mapping: bool,
    pub(super) hidden: RayKind,
    /// The `no_…` flags of members that count.
    pub(super) heeded: RayKind,
    /// Whether members are turned inside out.
    pub(super) inverted: bool,
    /// Whether `cutaway_textures` was given.
    pub(super) cutaway: bool,
    /// Whether members cut each other.
    pub(super) cut: bool,
    /// Whether anything asks for points inside: a compound that isn't a mere union, or what is clipped.
    pub(super) asked: bool,
    /// The light group around.
    pub(super) lights: u32,
    /// How many compounds are around.
    pub(super) depth: u32,
}

impl Default for Inherited {
    fn default() -> Self {
        Self {
            outer: None,
            texture: None,
            interior_texture: None,
            interior: None,
            hollow: false,
            double_illuminate: false,
            uv_mapping: false,
            hidden: RayKind::empty(),
            heeded: RayKind::all(),
            inverted: false,
            cutaway: false,
            cut: false,
            asked: false,
            lights: 0,
            depth: 0,
        }
    }
}

impl Inherited {
    /// The transform from the inner space of `object` to the world.
    pub(super) fn inner(&self, object: &Object) -> Option<Arc<Transform>> {
        match (&object.transform, &self.outer) {
            (Some(own), Some(outer)) => Some(Arc::new(own.then(outer))),
            (one, None) | (None, one) => one.clone(),
        }
    }

    /// What `object`, which has all this, hands down to the objects in it.
    pub(super) fn hand_down(self, object: &Object) -> Self {
        Self { outer: self.inner(object), depth: self.depth + 1, ..self }
    }
}

/// A light group.
#[derive(Debug)]
struct Lighting {
    /// The group around; the first one, of the global lights, is around itself.
    parent: u32,
    lights: Vec<u32>,
    /// Whether lights of the groups around reach the objects too.
    global_lights: bool,
}

/// Takes objects apart, one after the other.
#[derive(Debug)]
pub struct Flattener<'a> {
    pub(super) settings: &'a Settings,
    pub(super) flat: Flat,
    pub(super) accelerator: Accelerator,
    split_unions: bool,
    lighting: Vec<Lighting>,
    default_texture: Option<u32>,
    pub(super) bounded: Vec<Bounded>,
    pub(super) shapes: ShapeCache,
}

impl<'a> Flattener<'a> {
    /// Takes apart whole scenes or single objects; with `split_unions` bounded unions too. The settings
    /// are for the functions and images in shapes.
    pub fn new(settings: &'a Settings, accelerator: Accelerator, split_unions: bool) -> Self {
        Self {
            settings,
            flat: Flat::default(),
            accelerator,
            split_unions,
            lighting: vec![Lighting { parent: 0, lights: Vec::new(), global_lights: true }],
            default_texture: None,
            bounded: Vec::new(),
            shapes: ShapeCache::default(),
        }
    }

    /// Makes room for so many objects: lists that grow by copies of themselves would take twice as much.
    pub fn expect(&mut self, objects: usize) {
        self.flat.parts.leaves.reserve_exact(objects);
        self.flat.parts.objects.reserve_exact(objects);
        self.flat.spans.reserve_exact(objects);
        self.flat.textures.reserve_exact(objects);
        self.flat.interiors.reserve_exact(objects);
    }

    /// Adds a top-level object, or its members where it is a union that cuts nothing.
    pub fn add(&mut self, object: &Object) {
        let mut waiting = vec![(object, Inherited::default())];
        while let Some((object, around)) = waiting.pop() {
            match &object.shape {
                Shape::Csg(csg) if self.dissolves(object, csg) => {
                    let within = self.within(object, &around);
                    waiting.extend(csg.children.iter().rev().map(|child| (&**child, within.clone())));
                }
                Shape::LightGroup(group) => {
                    let within = self.within(object, &around);
                    let within = self.light_group(group, within);
                    waiting.extend(group.objects.iter().rev().map(|child| (&**child, within.clone())));
                }
                _ => self.add_whole_in(object, &around),
            }
        }
    }

    /// Everything so far.
    pub fn finish(mut self) -> Flat {
        self.cut_by_bounds();
        self.flat.light_sets = (0..self.lighting.len()).map(|group| self.lights_of(group)).collect();
        self.flat
    }

    /// Whether a compound is only a way to write several objects (docs/spec/primitives.md 7.4).
    fn dissolves(&self, object: &Object, csg: &Csg) -> bool {
        let (clipped, bounded) = object
            .extra
            .as_ref()
            .map_or((false, false), |extra| (!extra.clipped_by.is_empty(), !extra.bounded_by.is_empty()));
        csg.operation == CsgOperation::Union
            && csg.split_union
            && !object.flags.contains(ObjectFlags::INVERSE)
            && !clipped
            && (!bounded || self.split_unions)
    }

    /// Adds an object that stands on its own, unions too: their members hide each other's coincident
    /// surfaces in another order then.
    pub fn add_whole(&mut self, object: &Object) {
        self.add_whole_in(object, &Inherited::default());
    }

    fn add_whole_in(&mut self, object: &Object, around: &Inherited) {
        let mut own = self.own(object, around);
        // What its surfaces enclose is one body, if only of air.
        let interior = own.interior.unwrap_or_else(|| self.interior(Numbered::NONE, own.hollow));
        own.interior = Some(interior);
        if let Some(member) = self.placed(object, &own) {
            // Of so many the boxes are worked out again by the few who ask.
            if let Member::Leaf(number) = member
                && self.flat.parts.objects.len() > MANY
            {
                self.flat.parts.leaves[number as usize].forget_bounds();
            }
            self.note_bounds(object, &own, member);
            let surrounds = self.flat.parts.extent(member).beyond && self.is_everywhere(object);
            self.flat.parts.objects.push(Whole { member, interior, opaque: false, apart: false, surrounds });
        }
    }

    /// Opens a light group inside the one around.
    fn light_group(&mut self, group: &LightGroup, mut within: Inherited) -> Inherited {
        let number = self.lighting.len() as u32;
        self.lighting.push(Lighting {
            parent: within.lights,
            lights: Vec::new(),
            global_lights: group.global_lights,
        });
        within.lights = number;
        within
    }

    /// The numbers of the lights that reach the members of a group (docs/spec/shading.md 18).
    fn lights_of(&self, group: usize) -> Vec<u32> {
        let mut lights = Vec::new();
        let (mut number, mut global_lights) = (group, true);
        while number != 0 {
            let group = &self.lighting[number];
            lights.extend(&group.lights);
            // A group without lights is none.
            global_lights &= group.global_lights || group.lights.is_empty();
            number = group.parent as usize;
        }
        if global_lights {
            lights.extend(&self.lighting[0].lights);
        }
        lights.sort_unstable();
        lights
    }

    /// Adds a light to the group around; its visible shape is its only geometry.
    pub(super) fn light(&mut self, light: &Arc<Light>, object: &Object, own: &Inherited) -> Option<Member> {
        let transform = own.inner(object);
        let placed = Inherited { outer: transform.clone(), ..Inherited::default() };
        let projected_through = light.projected_through.as_ref().and_then(|through| {
            let member = self.member(through, &placed)?;
            let number = self.flat.parts.objects.len() as u32;
            let whole = Whole { member, interior: 0, opaque: false, apart: true, surrounds: false };
            self.flat.parts.objects.push(whole);
            Some(number)
        });
        let number = self.flat.lights.len() as u32;
        self.lighting[own.lights as usize].lights.push(number);
        let transform = transform.as_deref().copied().unwrap_or_default();
        self.flat.lights.push(LightUse { light: light.clone(), transform, projected_through });
        let shape = light.looks_like.as_ref()?;
        let hidden = own.hidden | RayKind::SHADOW;
        self.member(shape, &Inherited { outer: placed.outer, hidden, ..own.clone() })
    }

    /// Numbers a texture in a space that `outer` leads out of.
    pub(super) fn texture(&mut self, texture: &Texture, outer: Option<Arc<Transform>>) -> u32 {
        self.flat.textures.push(TextureUse { texture: texture.clone(), outer });
        self.flat.textures.len() as u32 - 1
    }

    /// The same, but that the last one's number will do where that is the same.
    pub(super) fn texture_again(&mut self, texture: &Texture, outer: Option<Arc<Transform>>) -> u32 {
        let place = |transform: &Option<Arc<Transform>>| transform.as_ref().map(Arc::as_ptr);
        let is_same = |last: &TextureUse| {
            Arc::ptr_eq(&last.texture.body, &texture.body)
                && place(&last.texture.transform) == place(&texture.transform)
                && place(&last.outer) == place(&outer)
        };
        match self.flat.textures.last() {
            Some(last) if is_same(last) => self.flat.textures.len() as u32 - 1,
            _ => self.texture(texture, outer),
        }
    }

    /// The texture of objects that were given none.
    pub(super) fn default_texture(&mut self) -> u32 {
        match self.default_texture {
            Some(number) => number,
            None => {
                let number = self.texture(&Texture::default(), None);
                *self.default_texture.insert(number)
            }
        }
    }

    /// Numbers the interior of an object that says what it is filled with.
    pub(super) fn filled(&mut self, interior: Option<Arc<Interior>>, own: &Inherited) -> u32 {
        let number = self.flat.fillings.len() as u32;
        let texture = own.texture.map(|number| &self.flat.textures[number as usize].texture);
        let legacy = texture.and_then(legacy).copied();
        self.flat.fillings.push(Filling { interior, outer: own.outer.clone(), legacy });
        self.interior(Some(number).into(), own.hollow)
    }

    /// Numbers an interior.
    fn interior(&mut self, filling: Numbered, hollow: bool) -> u32 {
        self.flat.interiors.push(InteriorUse { filling, hollow });
        self.flat.interiors.len() as u32 - 1
    }
}
