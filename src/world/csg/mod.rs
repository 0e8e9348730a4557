//! Constructive solids: which crossings of the members are surface of the whole
//! (docs/spec/primitives.md 7.1).
//!
//! There is no list of solid stretches of the whole: a crossing stays or goes by what the *other*
//! members say about its point, so a union inside an intersection keeps its inner faces and surfaces
//! without an inside take part. Inversion was carried down to the leaves by De Morgan's laws, so
//! there are only three operations, and a `difference` is an intersection.
//!
//! `gather` finds the members near a ray and their crossings, `survive` decides about these.

mod along;
mod convex;
mod gather;
mod odd;
mod scratch;
mod soon;
mod survive;
mod turns;

pub(super) use scratch::Found;
use soon::Unclear;
use survive::Tree;

use super::object::{Member, RayKind};
use super::parts::{Group, Parts};
use super::ray::{Range, Ray};
use super::shape::{Crossing, Shape};
use crate::math::DVec3;
use crate::math::wide::widest;

impl Parts {
    /// Whether `point` is inside a member and its clips.
    pub fn inside(&self, member: Member, point: DVec3) -> bool {
        let extent = self.extent(member);
        if !extent.bounds.contains(point) {
            return extent.beyond;
        }
        let clips = self.limits(member).map_or(&[][..], |limits| &limits.clips);
        clips.iter().all(|&clip| self.inside(clip, point)) && self.inside_unclipped(member, point)
    }

    /// Whether `point` is inside a member, be it clipped away or not.
    fn inside_unclipped(&self, member: Member, point: DVec3) -> bool {
        match member {
            Member::Leaf(number) => self.leaf(number).contains(point),
            Member::Group(number) => self.inside_group(number, point),
        }
    }

    fn inside_group(&self, group: u32, point: DVec3) -> bool {
        let group = self.group(group);
        let decisive = group.operation.decisive();
        let decides = |member| self.inside(member, point) == decisive;
        let decided = group.wide.iter().any(|&member| decides(member))
            || group.bounded.any_around(point, |place| {
                let member = group.members[place as usize];
                self.is_beyond(member) != decisive && decides(member)
            });
        decided == decisive
    }

    /// The nearest point of an object's surface; of several at the same distance, that of the
    /// last leaf.
    #[inline(always)]
    pub(super) fn nearest(&self, member: Member, ray: &Ray, range: Range, kind: RayKind) -> Option<Found> {
        if let Member::Leaf(number) = member {
            let leaf = self.leaf(number);
            if leaf.hidden.intersects(kind) {
                return None;
            }
            if !leaf.is_limited() {
                let crossing = leaf.primitive.nearest(&leaf.asked(ray), range)?;
                return Some(Found { crossing, leaf: number, near: 0 });
            }
        }
        self.nearest_of_many(member, ray, range, kind)
    }

    /// As [`Parts::nearest`], for what is cut or made of several primitives.
    fn nearest_of_many(&self, member: Member, ray: &Ray, range: Range, kind: RayKind) -> Option<Found> {
        let soon = match member {
            // Most compounds are cut out of a few convex solids, and by nothing else.
            Member::Group(number) if self.group(number).convex && self.group(number).limits.is_none() => {
                let group = self.group(number);
                if group.hidden.intersects(kind) {
                    return None;
                }
                self.nearest_of_convex(group, ray, range)
            }
            _ => self.nearest_soon(member, ray, range, kind),
        };
        match soon {
            Ok(nearest) => nearest,
            Err(Unclear) => self.nearest_of_any(member, ray, range, kind),
        }
    }

    /// Whether anything of an object's surface is in `range`.
    pub(super) fn occludes(&self, member: Member, ray: &Ray, range: Range, kind: RayKind) -> bool {
        match self.occludes_soon(member, ray, range, kind) {
            Ok(occludes) => occludes,
            Err(Unclear) => self.nearest_of_any(member, ray, range, kind).is_some(),
        }
    }

    /// The member if it is a compound of a few convex solids of which nothing is clipped away.
    fn as_convex(&self, member: Member) -> Option<&Group> {
        let Member::Group(number) = member else { return None };
        Some(self.group(number)).filter(|group| group.convex && self.is_whole(member))
    }

    /// The nearest point of an object's surface, however close surfaces are.
    fn nearest_of_any(&self, member: Member, ray: &Ray, range: Range, kind: RayKind) -> Option<Found> {
        self.with_crossings(member, ray, range, kind, |scratch| {
            let (found, tree) = (&scratch.found, Tree::new(self, ray, scratch));
            let first = (0..found.len()).find(|&i| range.contains(found[i].t()) && tree.survives(i))?;
            let t = found[first].t();
            if found.get(first + 1).is_none_or(|next| next.t() - t > 2.0 * tree.coarse(t)) {
                return Some(found[first]);
            }
            let end = found[first].t() + self.slack(ray, found[first].leaf, &found[first].crossing);
            let tied = (first + 1..found.len()).take_while(|&i| found[i].t() <= end);
            let last = tied.filter(|&i| range.contains(found[i].t())).fold(first, |best, i| {
                let wins = found[i].leaf > found[best].leaf && tree.survives(i);
                if wins { i } else { best }
            });
            Some(found[last])
        })?
    }

    /// Hands out all points of an object's surface in ascending order until told to stop.
    pub(super) fn surface_along(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
        mut visit: impl FnMut(Found) -> bool,
    ) -> bool {
        if self.hidden(member).intersects(kind) {
            return false;
        }
        if let Some(group) = self.as_convex(member) {
            if !self.admits(member, ray) {
                return false;
            }
            let known = widest(
                #[inline(always)]
                || self.along_convex(group, ray, range, &mut visit),
            );
            if let Ok(stopped) = known {
                return stopped;
            }
        }
        let stopped = self.with_crossings(member, ray, range, kind, |scratch| {
            let (found, tree) = (&scratch.found, Tree::new(self, ray, scratch));
            (0..found.len())
                .filter(|&i| range.contains(found[i].t()) && tree.survives(i))
                .any(|i| visit(found[i]))
        });
        stopped == Some(true)
    }

    /// How far rounding may have moved a crossing along the ray.
    pub(super) fn slack(&self, ray: &Ray, leaf: u32, crossing: &Crossing) -> f64 {
        let leaf = self.leaf(leaf);
        let point = ray.at(crossing.t);
        let normal = leaf.primitive.geometric_normal(leaf.inner_point(point), crossing);
        let length = ray.direction.length();
        let cosine = leaf.outer_normal(normal).dot(ray.direction).abs() / length;
        let scale = ray.origin.abs().max(point.abs()).max_element();
        FINE * scale / (length * cosine.max(LEAST_COSINE))
    }

    /// Whether a crossing `gap` behind another may be at the same place, but for rounding.
    #[inline]
    pub(super) fn coincide(&self, ray: &Ray, leaf: u32, crossing: &Crossing, gap: f64) -> bool {
        // Hardly any does: the most that the slack may be is soon found.
        let length = ray.direction.length();
        let scale = ray.origin.abs().max_element() + crossing.t.abs() * length;
        gap <= 1.1 * COARSE * scale / length && gap <= self.slack(ray, leaf, crossing)
    }
}

/// Rounding error of a crossing seen head on, relative to the coordinates.
const FINE: f64 = 64.0 * f64::EPSILON;

/// More grazing rays are treated like this one.
const LEAST_COSINE: f64 = 1e-3;

/// Rounding error of the most grazing crossing.
const COARSE: f64 = FINE / LEAST_COSINE;
