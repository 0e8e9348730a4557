//! Everything that makes up the geometry of a world, by number.

use super::accel::Accel;
use super::extent::Extent;
use super::facets::Facets;
use super::narrow;
use super::object::{Leaf, LeafFlags, Limits, Member, RayKind};
use super::shape::Shape;
use crate::options::Accelerator;

/// How a [`Group`] combines its members.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// All surfaces of all members.
    Union,
    /// Surfaces that are in no other member.
    Merge,
    /// Surfaces that are in every other member.
    Intersection,
}

/// Compounds of more convex members are searched by boxes, and so are those of more members that have boxes.
pub(super) const MOST_CONVEX: usize = 16;
const MOST_BOXED: usize = 8;

/// A compound.
#[derive(Debug)]
pub struct Group {
    /// How the members combine.
    pub operation: Operation,
    /// In the order of the text.
    pub members: Vec<Member>,
    /// Where its inside and its surface may be.
    pub extent: Extent,
    /// `clipped_by` and `bounded_by`.
    pub limits: Option<Box<Limits>>,
    /// The compound it is a member of.
    pub parent: Option<u32>,
    /// Of the members of a `difference` the first is what is cut.
    pub difference: bool,
    /// Rays find the members with finite boxes here, by their place among the members.
    pub(super) bounded: Accel,
    /// The other members.
    pub(super) unbounded: Vec<Member>,
    /// Members that decide about points outside of their boxes.
    pub(super) wide: Vec<Member>,
    /// How many of the bounded members do so.
    pub(super) deciders: u32,
    /// Whether it combines a few convex solids, all hidden from the same rays.
    pub(super) convex: bool,
    /// Of an intersection of convex solids with one of any shape, all hidden from the same rays, that one.
    pub(super) odd: Option<u32>,
    /// The planes of such an intersection, if there are more than a few.
    pub(super) facets: Option<Facets>,
    /// The members of a compound of a few solids of any shape, all hidden from the same rays, in the order in which rays
    /// ask them in turn; empty for others.
    pub(super) turns: Vec<Member>,
    /// The rays that all of its leaves are hidden from.
    pub(super) hidden: RayKind,
    /// Of an intersection: the place of a bounded convex solid, which no other member can exceed.
    pub(super) core: Option<u32>,
}

/// Whether members are all hidden from the same rays.
fn are_hidden_alike(members: &[Member], parts: &Parts) -> bool {
    members.windows(2).all(|pair| parts.hidden(pair[0]) == parts.hidden(pair[1]))
}

/// The leaf of any shape that an intersection with a few convex solids has.
fn odd_one(operation: Operation, members: &[Member], parts: &Parts) -> Option<u32> {
    let mut odd = None;
    for &member in members {
        let Member::Leaf(number) = member else { return None };
        let leaf = parts.leaf(number);
        if !leaf.flags.contains(LeafFlags::SOLID) || leaf.is_limited() {
            return None;
        }
        if !leaf.is_convex() && (leaf.flags.contains(LeafFlags::INVERTED) || odd.replace(number).is_some()) {
            return None;
        }
    }
    odd.filter(|_| operation == Operation::Intersection && members.len() <= MOST_BOXED)
}

/// The members of a compound of a few solids in the order in which they are asked in turn: first what decides for all
/// beyond its box, for much of a ray is soon done with by that, and compounds last.
fn turns(operation: Operation, members: &[Member], parts: &Parts) -> Vec<Member> {
    let mut count = 0;
    for &member in members {
        let solids = match member {
            Member::Leaf(number) => {
                let leaf = parts.leaf(number);
                let closed = leaf.flags.contains(LeafFlags::SOLID) && leaf.primitive.is_closed();
                if closed && !leaf.is_limited() { 1 } else { return Vec::new() }
            }
            Member::Group(number) => {
                let group = parts.group(number);
                let asked = group.limits.is_none() && (group.convex || !group.turns.is_empty());
                if asked { parts.solids(group) } else { return Vec::new() }
            }
        };
        count += solids;
        if count > MOST_CONVEX {
            return Vec::new();
        }
    }
    let mut turns = members.to_vec();
    let decides = |member| parts.is_beyond(member) == operation.decisive();
    turns.sort_by_key(|&member| (!decides(member), matches!(member, Member::Group(_))));
    turns
}

/// Whether a compound combines a few convex solids.
fn is_convex(operation: Operation, members: &[Member], parts: &Parts) -> bool {
    let combines = |member: &Member| match *member {
        Member::Leaf(number) => {
            let leaf = parts.leaf(number);
            let inverted = leaf.flags.contains(LeafFlags::INVERTED);
            leaf.is_convex()
                && (operation == Operation::Intersection || operation == Operation::Merge && !inverted)
        }
        Member::Group(_) => false,
    };
    let boxed = members.iter().filter(|&&member| parts.extent(member).bounds.is_finite()).count();
    let few = members.len() <= MOST_CONVEX && boxed <= MOST_BOXED;
    few && !members.is_empty() && members.iter().all(combines)
}

impl Group {
    /// Whether it combines a few convex solids, or intersects them with one of any shape; all are hidden from the same
    /// rays.
    #[inline]
    pub(super) fn is_simple(&self) -> bool {
        self.convex || self.odd.is_some()
    }

    /// Combines members that are in `parts` already.
    pub fn new(operation: Operation, members: Vec<Member>, parts: &Parts, accelerator: Accelerator) -> Self {
        let extents = members.iter().map(|&member| parts.extent(member));
        let mut extent = match operation {
            Operation::Intersection => Extent::intersection(extents),
            Operation::Union | Operation::Merge => Extent::union(extents),
        };
        if operation == Operation::Intersection && !extent.beyond {
            let leaves = members.iter().filter_map(|member| match *member {
                Member::Leaf(number) => Some(parts.leaf(number)),
                Member::Group(_) => None,
            });
            extent.bounds = narrow::cut(leaves.clone(), narrow::common(leaves, extent.bounds));
        }
        let is_finite = |member: Member| parts.extent(member).bounds.is_finite();
        let decides = |member: Member| parts.extent(member).beyond == operation.decisive();
        let is_core = |&&member: &&Member| match member {
            Member::Leaf(number) => is_finite(member) && decides(member) && parts.leaf(number).is_convex(),
            Member::Group(_) => false,
        };
        let core = members.iter().position(|member| is_core(&member)).map(|place| place as u32);
        let boxes = (0..).zip(&members).filter(|&(_, &member)| is_finite(member));
        let boxes = boxes.map(|(place, &member)| (parts.extent(member).bounds, place));
        let alike = are_hidden_alike(&members, parts);
        let convex = alike && is_convex(operation, &members, parts);
        let facets = convex && operation == Operation::Intersection;
        Self {
            facets: facets.then(|| Facets::new(&members, |number| parts.leaf(number))).flatten(),
            bounded: Accel::new(boxes, accelerator),
            unbounded: members.iter().copied().filter(|&m| !is_finite(m)).collect(),
            wide: members.iter().copied().filter(|&m| !is_finite(m) || decides(m)).collect(),
            deciders: members.iter().filter(|&&m| is_finite(m) && decides(m)).count() as u32,
            convex,
            odd: if alike { odd_one(operation, &members, parts) } else { None },
            turns: if alike { turns(operation, &members, parts) } else { Vec::new() },
            hidden: members.iter().fold(RayKind::all(), |all, &member| all & parts.hidden(member)),
            core: core.filter(|_| operation == Operation::Intersection),
            operation,
            members,
            extent,
            limits: None,
            parent: None,
            difference: false,
        }
    }
}

impl Operation {
    /// The answer to "inside?" with which one member decides for the whole.
    #[inline]
    pub(super) fn decisive(self) -> bool {
        self != Self::Intersection
    }
}

/// What stands on its own in the scene, unions taken apart.
#[derive(Debug)]
pub struct Object {
    /// Its geometry.
    pub member: Member,
    /// What it is filled with, for rays that start inside it.
    pub interior: u32,
    /// Whether it is no part of the picture, only asked for by number.
    pub apart: bool,
    /// Whether all of its leaves are opaque.
    pub opaque: bool,
    /// Whether a ray that starts outside of its box may start in it, as far as interiors, fog and media go.
    pub surrounds: bool,
}

/// Leaves, compounds and objects.
#[derive(Debug, Default)]
pub struct Parts {
    /// Primitives, those of an object next to each other in the order of the text.
    pub leaves: Vec<Leaf>,
    /// Compounds.
    pub groups: Vec<Group>,
    /// Objects in the order of the text.
    pub objects: Vec<Object>,
}

impl Parts {
    /// A leaf by number.
    #[inline]
    pub fn leaf(&self, number: u32) -> &Leaf {
        &self.leaves[number as usize]
    }

    /// A compound by number.
    #[inline]
    pub fn group(&self, number: u32) -> &Group {
        &self.groups[number as usize]
    }

    /// Where a member's inside and surface may be.
    #[inline]
    pub fn extent(&self, member: Member) -> Extent {
        match member {
            Member::Leaf(number) => self.leaf(number).extent(),
            Member::Group(number) => self.group(number).extent,
        }
    }

    /// The rays that a member is hidden from.
    #[inline]
    pub(super) fn hidden(&self, member: Member) -> RayKind {
        match member {
            Member::Leaf(number) => self.leaf(number).hidden,
            Member::Group(number) => self.group(number).hidden,
        }
    }

    /// How many leaves a compound of a few is made of.
    fn solids(&self, group: &Group) -> usize {
        let solids = group.members.iter().map(|&member| match member {
            Member::Leaf(_) => 1,
            Member::Group(number) => self.solids(self.group(number)),
        });
        solids.sum()
    }

    /// Whether everything beyond a member's box is inside of it.
    #[inline]
    pub(super) fn is_beyond(&self, member: Member) -> bool {
        match member {
            Member::Leaf(number) => self.leaf(number).flags.contains(LeafFlags::BEYOND),
            Member::Group(number) => self.group(number).extent.beyond,
        }
    }

    #[inline]
    pub(super) fn limits(&self, member: Member) -> Option<&Limits> {
        match member {
            Member::Leaf(number) => self.leaf(number).limits(),
            Member::Group(number) => self.group(number).limits.as_deref(),
        }
    }
}
