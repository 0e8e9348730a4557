//! Compounds: De Morgan's laws carry inversion down to the leaves, and nested compounds of one
//! kind become one.

use super::flatten::{Flattener, Inherited};
use crate::scene::object::ObjectFlags;
use crate::scene::shape::{Csg, CsgOperation};
use crate::scene::{Object, Shape};
use crate::world::extent::Extent;
use crate::world::narrow;
use crate::world::object::{Leaf, LeafFlags, Limits};
use crate::world::parts::{Group, Operation};
use crate::world::{Member, RayKind};

impl Flattener<'_> {
    /// Adds a compound with all its members; a single member without limits stands for itself.
    pub(super) fn compound(&mut self, csg: &Csg, object: &Object, own: &Inherited) -> Option<Member> {
        let operation = operation(csg.operation, own.inverted);
        let mut members = Vec::new();
        let mut waiting = children(csg, object, own);
        while let Some((child, around)) = waiting.pop() {
            match &child.shape {
                Shape::Csg(nested) if self.melts(operation, nested, child, &around) => {
                    // Melted compounds don't nest.
                    let melted = Inherited { depth: own.depth, ..self.own(child, &around) };
                    waiting.extend(children(nested, child, &melted));
                }
                _ => members.extend(self.member(child, &around)),
            }
        }
        let limits = self.limits(object, own);
        if let (&[only], None) = (&members[..], &limits) {
            return Some(only);
        }
        if members.is_empty() {
            return None;
        }
        let parts = &mut self.flat.parts;
        let number = parts.groups.len() as u32;
        for &member in &members {
            match member {
                Member::Leaf(leaf) => parts.leaves[leaf as usize].set_parent(number),
                Member::Group(group) => parts.groups[group as usize].parent = Some(number),
            }
        }
        let mut group = Group::new(operation, members, parts, self.accelerator);
        group.difference = csg.operation == CsgOperation::Difference;
        let limits = limits.and_then(|limits| self.needed(limits, &group));
        group.extent = self.clipped(group.extent, limits.as_deref());
        group.limits = limits;
        self.flat.parts.groups.push(group);
        Some(Member::Group(number))
    }

    /// Whether a nested compound's members can as well be members of the compound around.
    fn melts(&self, operation: Operation, nested: &Csg, object: &Object, around: &Inherited) -> bool {
        let inverted = around.inverted != object.flags.contains(ObjectFlags::INVERSE);
        let limited = object
            .extra
            .as_ref()
            .is_some_and(|extra| !extra.clipped_by.is_empty() || !extra.bounded_by.is_empty());
        let cutaway = around.cutaway || object.flags.contains(ObjectFlags::CUTAWAY_TEXTURES);
        operation == self::operation(nested.operation, inverted) && !limited && !cutaway
    }

    /// Adds what an object is clipped and bounded by.
    pub(super) fn limits(&mut self, object: &Object, own: &Inherited) -> Option<Box<Limits>> {
        let extra = object.extra.as_deref()?;
        let place =
            Inherited { outer: own.outer.clone(), depth: own.depth + 1, asked: true, ..Inherited::default() };
        let clips = extra.clipped_by.iter().filter_map(|clip| self.member(clip, &place)).collect();
        // The bounds of other primitives are another matter; bounds that are clips cut nothing more.
        let bounds = match object.shape {
            Shape::Csg(_) | Shape::Poly(_) if !object.flags.contains(ObjectFlags::BOUNDS_ARE_CLIPS) => {
                extra.bounded_by.iter().filter_map(|bound| self.member(bound, &place)).collect()
            }
            _ => Vec::new(),
        };
        let limits = Limits { clips, bounds };
        (!limits.clips.is_empty() || !limits.bounds.is_empty()).then(|| Box::new(limits))
    }

    /// The limits of a compound but for convex bounds that hold all of it anyhow.
    fn needed(&self, mut limits: Box<Limits>, group: &Group) -> Option<Box<Limits>> {
        let parts = &self.flat.parts;
        let Extent { bounds, beyond: false } = group.extent else { return Some(limits) };
        if bounds.is_finite() && !bounds.is_empty() {
            let leaf = |member: &Member| match *member {
                Member::Leaf(number) => Some(parts.leaf(number)),
                Member::Group(_) => None,
            };
            let common = group.members.iter().filter(|_| group.operation == Operation::Intersection);
            let corners = narrow::corners(common.filter_map(leaf), bounds);
            let holds = |bound: &Leaf| {
                let is_plain = bound.is_convex() && !bound.flags.contains(LeafFlags::INVERTED);
                is_plain && corners.iter().all(|&corner| bound.contains(corner))
            };
            limits.bounds.retain(|bound| !leaf(bound).is_some_and(holds));
        }
        (!limits.clips.is_empty() || !limits.bounds.is_empty()).then_some(limits)
    }

    /// Where something may be that is clipped.
    pub(super) fn clipped(&self, extent: Extent, limits: Option<&Limits>) -> Extent {
        let clips = limits.map_or(&[][..], |limits| &limits.clips);
        let clips = clips.iter().map(|&clip| self.flat.parts.extent(clip));
        Extent::intersection(std::iter::once(extent).chain(clips))
    }
}

/// What an operation is where members are already turned inside out as needed
/// (docs/spec/primitives.md 7.1).
fn operation(operation: CsgOperation, inverted: bool) -> Operation {
    match (operation, inverted) {
        (CsgOperation::Union, false) => Operation::Union,
        (CsgOperation::Merge, false) => Operation::Merge,
        (CsgOperation::Intersection | CsgOperation::Difference, false) => Operation::Intersection,
        (CsgOperation::Union | CsgOperation::Merge, true) => Operation::Intersection,
        (CsgOperation::Intersection | CsgOperation::Difference, true) => Operation::Merge,
    }
}

/// The children with what they inherit from the compound that has all of `own`, the last one first.
fn children<'a>(csg: &'a Csg, object: &Object, own: &Inherited) -> Vec<(&'a Object, Inherited)> {
    let within = own.clone().hand_down(object);
    let operation = operation(csg.operation, within.inverted);
    let heeded = match operation {
        Operation::Union => within.heeded,
        Operation::Merge => within.heeded & (RayKind::IMAGE | RayKind::REFLECTION),
        Operation::Intersection => RayKind::empty(),
    };
    let cut = operation == Operation::Intersection;
    let asked = within.asked || operation != Operation::Union;
    let inherit = |(place, child)| {
        let taken_away = csg.operation == CsgOperation::Difference && place > 0;
        let inverted = within.inverted != taken_away;
        (child, Inherited { inverted, heeded, cut, asked, ..within.clone() })
    };
    csg.children.iter().map(|child| &**child).enumerate().map(inherit).rev().collect()
}
