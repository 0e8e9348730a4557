//! What a ray meets of a tree of solids: the members near it, and their crossings.

use super::COARSE;
use super::scratch::{Found, Inside, Near, Scratch};
use crate::math::Bounds;
use crate::world::accel::Slabs;
use crate::world::object::{Leaf, LeafFlags, Member, RayKind};
use crate::world::parts::{Group, Operation, Parts};
use crate::world::ray::{Range, Ray};
use crate::world::shape::{Primitive, Shape};

/// A ray on its way through a tree.
#[derive(Clone, Copy)]
struct Way<'a> {
    ray: &'a Ray,
    slabs: &'a Slabs,
    range: Range,
    kind: RayKind,
    /// How far coincident faces may be apart, for each unit of the coordinates there.
    room: f64,
    parent: Option<u32>,
}

impl Way<'_> {
    /// Leaves of the range what is between two distances, and a little more on both sides: coincident
    /// faces take part in the decision about each other.
    #[inline]
    fn narrowed(mut self, enter: f64, leave: f64) -> Self {
        let room = |t: f64| self.room * self.ray.origin.abs().max(self.ray.at(t).abs()).max_element();
        if enter.is_finite() {
            self.range.min = self.range.min.max(enter - room(enter));
        }
        if leave.is_finite() {
            self.range.max = self.range.max.min(leave + room(leave));
        }
        self
    }
}

impl Parts {
    /// Finds all crossings of an object's leaves, sorted, for `decide` to tell which of them survive.
    /// `None` where the ray misses the object's box.
    pub(super) fn with_crossings<R>(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
        decide: impl FnOnce(&Scratch) -> R,
    ) -> Option<R> {
        let slabs = Slabs::new(ray);
        let extent = self.extent(member);
        let (enter, leave) = slabs.overlap_in(&extent.bounds, range)?;
        // Coincident faces just beyond the end take part in the decision about those before it.
        let beyond = Range { min: range.min, max: range.max + range.max.abs() * COARSE };
        let length = ray.direction.length();
        let room = 4.0 * COARSE / length;
        let mut way = Way { ray, slabs: &slabs, range: beyond, kind, room, parent: None };
        if !extent.beyond {
            way = way.narrowed(enter, leave);
        }
        Some(Scratch::lend(|scratch| {
            scratch.found.clear();
            scratch.near.clear();
            scratch.length = length;
            self.gather(member, way, scratch);
            if scratch.found.len() > 1 {
                scratch.found.sort_unstable_by(|a, b| a.t().total_cmp(&b.t()).then(b.leaf.cmp(&a.leaf)));
            }
            decide(scratch)
        }))
    }

    /// What a leaf is asked of which `bounded_by` may keep rays, but nothing cuts a part.
    #[inline]
    pub(super) fn ask_bounded<R>(
        &self,
        number: u32,
        ray: &Ray,
        range: Range,
        kind: RayKind,
        ask: impl FnOnce(&Primitive, &Ray, Range) -> Option<R>,
    ) -> Option<R> {
        let (leaf, member) = (self.leaf(number), Member::Leaf(number));
        if leaf.hidden.intersects(kind) {
            return None;
        }
        let extent = self.extent(member);
        let mut inner = range;
        if extent.bounds != Bounds::ALL {
            let slabs = Slabs::new(ray);
            let (enter, leave) = slabs.overlap_in(&extent.bounds, range)?;
            if !extent.beyond {
                let room = 4.0 * COARSE / ray.direction.length();
                let way = Way { ray, slabs: &slabs, range, kind, room, parent: None };
                inner = way.narrowed(enter, leave).range;
            }
        }
        if !self.admits(member, ray) {
            return None;
        }
        ask(&leaf.primitive, &leaf.asked(ray), inner)
    }

    /// Adds a member and everything of it that is near the ray. Answers how to tell its inside.
    fn gather(&self, member: Member, way: Way, scratch: &mut Scratch) -> Inside {
        match member {
            Member::Leaf(number) => self.gather_leaf(number, way, scratch),
            Member::Group(number) => {
                let group = self.group(number);
                let place = scratch.near.len();
                scratch.near.push(Near {
                    member,
                    operation: Some(group.operation),
                    clipped: group.limits.is_some(),
                    parent: way.parent,
                    outer: place as u32,
                    inner: place as u32,
                    end: 0,
                    inside: Inside::Point,
                });
                if group.limits.is_none() || self.admits(member, way.ray) {
                    scratch.near[place].inside = self.gather_group(group, place, way, scratch);
                }
                scratch.near[place].end = scratch.near.len() as u32;
                scratch.pass_over(place);
                scratch.near[place].inside
            }
        }
    }

    #[inline]
    fn gather_leaf(&self, number: u32, way: Way, scratch: &mut Scratch) -> Inside {
        let leaf = self.leaf(number);
        let place = scratch.near.len() as u32;
        let mut inside = Inside::Point;
        if !leaf.is_limited() || self.admits(Member::Leaf(number), way.ray) {
            let ray = leaf.asked(way.ray);
            let seen = !leaf.hidden.intersects(way.kind);
            let found = |crossing| Found { crossing, leaf: number, near: place };
            match leaf.primitive.convex(&ray) {
                Some(Some(stretch)) => {
                    if seen {
                        scratch.found.extend(stretch.ends(way.range).into_iter().flatten().map(found));
                    }
                    inside = inside_leaf(leaf, Some(Some((stretch.enter.t, stretch.leave.t))));
                }
                Some(None) => {
                    inside = inside_leaf(leaf, Some(None));
                    if matches!(inside, Inside::Constant(_)) {
                        // Either it decides here and now, or it doesn't matter any more.
                        return inside;
                    }
                }
                None => {
                    if seen {
                        leaf.primitive.crossings(&ray, way.range, &mut scratch.crossings);
                        scratch.found.extend(scratch.crossings.drain(..).map(found));
                    }
                    inside = inside_leaf(leaf, None);
                }
            }
        }
        scratch.near.push(Near {
            member: Member::Leaf(number),
            operation: None,
            clipped: leaf.is_limited(),
            parent: way.parent,
            outer: place,
            inner: place,
            end: place + 1,
            inside,
        });
        inside
    }

    fn gather_group(&self, group: &Group, place: usize, way: Way, scratch: &mut Scratch) -> Inside {
        let nested = way.parent.is_some();
        let mut way = Way { parent: Some(place as u32), ..way };
        let first_found = scratch.found.len();
        let decided = group.operation == Operation::Intersection
            && match self.core(group, nested, way, scratch) {
                Some(narrowed) => {
                    way = narrowed;
                    false
                }
                None => true,
            };
        if decided || self.gather_members(group, way, scratch) {
            // One member decides for the whole: a common part or a hollow of it is nowhere near. The
            // surfaces of a union remain all the same.
            if group.operation != Operation::Union {
                scratch.found.truncate(first_found);
                scratch.near.truncate(place + 1);
            }
            let decisive = group.operation.decisive();
            // Clips may still take a part of what is inside everywhere.
            return if decisive && group.limits.is_some() {
                Inside::Point
            } else {
                Inside::Constant(decisive)
            };
        }
        Inside::Members
    }

    /// Narrows the range to where all of an intersection's bounded members may be, and gathers the one
    /// that tells best. `None` where there is no such place.
    fn core<'a>(
        &self,
        group: &Group,
        nested: bool,
        mut way: Way<'a>,
        scratch: &mut Scratch,
    ) -> Option<Way<'a>> {
        // The whole object's box has been asked before.
        if nested && !group.extent.beyond && group.extent.bounds.is_finite() {
            let (enter, leave) = way.slabs.overlap_in(&group.extent.bounds, way.range)?;
            way = way.narrowed(enter, leave);
        }
        if let Some(core) = group.core {
            match self.gather(group.members[core as usize], way, scratch) {
                Inside::Between { enter, leave, .. } => way = way.narrowed(enter, leave),
                Inside::Constant(false) => return None,
                _ => {}
            }
        }
        (way.range.min < way.range.max).then_some(way)
    }

    /// Gathers the members near the ray but for the core; whether one decides for all.
    fn gather_members(&self, group: &Group, way: Way, scratch: &mut Scratch) -> bool {
        let decisive = group.operation.decisive();
        // What has surfaces left, as unions do inside of themselves, is not done with: only the others can take them.
        let decides = |member, scratch: &mut Scratch| {
            let before = scratch.found.len();
            self.gather(member, way, scratch) == Inside::Constant(decisive) && scratch.found.len() == before
        };
        let stops = group.operation != Operation::Union;
        let mut decided = false;
        for &member in &group.unbounded {
            decided |= decides(member, scratch);
        }
        let mut missing = group.deciders;
        if let Some(core) = group.core {
            missing -= u32::from(self.is_beyond(group.members[core as usize]) == decisive);
        }
        if decided && stops {
            return true;
        }
        group.bounded.along(way.ray, way.range, |place| {
            if group.core == Some(place) {
                return way.range.max;
            }
            let member = group.members[place as usize];
            missing -= u32::from(self.is_beyond(member) == decisive);
            decided |= decides(member, scratch);
            if decided && stops { f64::NEG_INFINITY } else { way.range.max }
        });
        decided || missing > 0
    }

    /// Whether `bounded_by` lets the ray pass to the object.
    #[inline]
    pub(super) fn admits(&self, member: Member, ray: &Ray) -> bool {
        let bounds = self.limits(member).map_or(&[][..], |limits| &limits.bounds);
        bounds.iter().all(|&bound| {
            // Of what is convex the stretch inside says it all.
            if let Member::Leaf(number) = bound
                && let leaf = self.leaf(number)
                && !leaf.is_limited()
                && !leaf.flags.contains(LeafFlags::INVERTED)
                && leaf.primitive.is_convex()
            {
                return leaf.primitive.span(&leaf.asked(ray)).is_some_and(|span| span.leave.t >= 0.0);
            }
            self.inside(bound, ray.origin)
                || self.nearest(bound, ray, Range::AHEAD, RayKind::empty()).is_some()
        })
    }
}

/// How to tell the inside of a leaf from its stretch, if it is convex: the inner `None` for one that
/// the ray misses.
#[inline]
fn inside_leaf(leaf: &Leaf, stretch: Option<Option<(f64, f64)>>) -> Inside {
    if !leaf.flags.contains(LeafFlags::SOLID) {
        return Inside::Surface;
    }
    if leaf.is_limited() {
        return Inside::Point;
    }
    let inverted = leaf.flags.contains(LeafFlags::INVERTED);
    match stretch {
        Some(Some((enter, leave))) => Inside::Between { enter, leave, inverted },
        Some(None) => Inside::Constant(inverted),
        None => Inside::Point,
    }
}
