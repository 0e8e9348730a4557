//! `bounded_by` of primitives other than polynomials, which keep it. POV-Ray throws the bounding object away but keeps its box where that
//! is smaller than the primitive's own, and rays that miss the box miss the primitive. Bounds that
//! are too small show: they cut (docs/spec/primitives.md 8.3).

use super::flatten::{Flattener, Inherited};
use crate::math::Bounds;
use crate::scene::depth::Nested;
use crate::scene::object::ObjectFlags;
use crate::scene::{Object, Shape};
use crate::world::object::{LeafFlags, Numbered};
use crate::world::shape::Primitive;
use crate::world::shape::r#box::Cuboid;
use crate::world::{Leaf, Member, RayKind};

/// From this many objects on POV-Ray finds all of them by their boxes.
const MANY: usize = 3;

/// A primitive with a manual bound.
#[derive(Debug)]
pub(super) struct Bounded {
    leaf: u32,
    /// In the world.
    bounds: Bounds,
    /// Whether the primitive's box is asked only in scenes of many objects.
    lenient: bool,
}

impl Flattener<'_> {
    /// Notes a primitive that stands on its own and whose bounds may cut it.
    pub(super) fn note_bounds(&mut self, object: &Object, own: &Inherited, member: Member) {
        let Member::Leaf(leaf) = member else {
            return;
        };
        let bounding = object.extra.as_ref().map_or(&[][..], |extra| &extra.bounded_by);
        let clips = object.flags.contains(ObjectFlags::BOUNDS_ARE_CLIPS);
        if bounding.is_empty() || clips || matches!(object.shape, Shape::Csg(_) | Shape::Poly(_)) {
            return;
        }
        // The smallest of all boxes is the one that counts.
        let bounds = self.extent(object);
        let mut plain = object.clone();
        if let Some(extra) = &mut plain.extra {
            extra.bounded_by = Nested::default();
        }
        if self.extent(&plain) != bounds {
            let bounds = own.outer.as_ref().map_or(bounds, |outer| bounds.transformed(outer));
            self.bounded.push(Bounded { leaf, bounds, lenient: skips_its_box(&object.shape) });
        }
    }

    /// Lets the bounds noted cut, once it is known how many objects there are.
    pub(super) fn cut_by_bounds(&mut self) {
        let many = self.flat.parts.objects.len() + self.flat.lights.len() >= MANY;
        for Bounded { leaf, bounds, .. } in self.bounded.drain(..).filter(|bounded| many || !bounded.lenient)
        {
            let leaves = &mut self.flat.parts.leaves;
            let member = Member::Leaf(leaves.len() as u32);
            leaves.push(bounding_box(bounds));
            leaves[leaf as usize].limit().bounds.push(member);
        }
    }
}

/// Primitives that POV-Ray tests without looking at their boxes first.
fn skips_its_box(shape: &Shape) -> bool {
    matches!(shape, Shape::Sphere { .. } | Shape::Box { .. } | Shape::Plane { .. } | Shape::Triangle(_))
}

/// A leaf that is only asked whether a ray meets it.
fn bounding_box(bounds: Bounds) -> Leaf {
    let mut leaf = Leaf {
        primitive: Primitive::Box(Cuboid { min: bounds.min, max: bounds.max }),
        transform: None,
        reach: 0.0,
        rare: None,
        flags: LeafFlags::SOLID,
        hidden: RayKind::empty(),
        texture: Numbered::NONE,
        interior: 0,
        lights: 0,
        origin: 0,
    };
    leaf.set_bounds(bounds);
    leaf
}
