//! Constructive solids: which crossings of the members are surface of the whole
//! (docs/spec/primitives.md 7.1).
//!
//! There is no interval algebra: a crossing stays or goes by what the *other* members say about
//! its point, so a union inside an intersection keeps its inner faces and surfaces without an
//! inside take part. Inversion was carried down to the leaves by De Morgan's laws, so there are
//! only three operations, and a `difference` is an intersection.
//!
//! Where faces of several members coincide, the point alone decides nothing: rounding would make
//! speckles. There the states just before and just after are compared, which gives the solid's
//! closed surface: a cutter flush with a face leaves a hole, flush merged faces leave one face.

use super::accel::Slabs;
use super::object::{LeafFlags, Member, RayKind};
use super::parts::{Operation, Parts};
use super::ray::{Range, Ray};
use super::scratch::{Found, Scratch};
use super::shape::{Crossing, Shape};
use crate::math::DVec3;

impl Parts {
    /// Whether `point` is inside a member and its clips.
    pub fn inside(&self, member: Member, point: DVec3) -> bool {
        let extent = self.extent(member);
        if !extent.bounds.contains(point) {
            return extent.beyond;
        }
        let clips = self.limits(member).map_or(&[][..], |limits| &limits.clips);
        clips.iter().all(|&clip| self.inside(clip, point))
            && match member {
                Member::Leaf(number) => self.leaf(number).contains(point),
                Member::Group(number) => self.inside_others(number, point, None),
            }
    }

    /// Whether `point` is inside a compound from which one member is taken away, and its clips.
    fn inside_others(&self, group: u32, point: DVec3, without: Option<Member>) -> bool {
        let group = self.group(group);
        let decisive = group.operation.decisive();
        let decides = |member| Some(member) != without && self.inside(member, point) == decisive;
        let decided = group.wide.iter().any(|&member| decides(member))
            || group.bounded.any_around(point, |place| {
                let member = group.members[place as usize];
                self.extent(member).beyond != decisive && decides(member)
            });
        decided == decisive
    }

    /// Whether `bounded_by` lets the ray pass to the object.
    fn admits(&self, member: Member, ray: &Ray) -> bool {
        let bounds = self.limits(member).map_or(&[][..], |limits| &limits.bounds);
        bounds.iter().all(|&bound| {
            self.inside(bound, ray.origin)
                || Scratch::lend(|scratch| {
                    self.nearest(bound, ray, Range::AHEAD, RayKind::empty(), scratch).is_some()
                })
        })
    }

    /// Adds all crossings of all leaves near the ray, whether they are surface of the whole or not.
    fn gather(&self, member: Member, ray: &Ray, range: Range, kind: RayKind, scratch: &mut Scratch) {
        if !self.admits(member, ray) {
            return;
        }
        match member {
            Member::Leaf(number) => {
                let leaf = self.leaf(number);
                if leaf.hidden.intersects(kind) {
                    return;
                }
                leaf.primitive.crossings(&leaf.inner(ray), range, &mut scratch.crossings);
                let crossings = scratch.crossings.drain(..);
                scratch.found.extend(crossings.map(|crossing| Found { crossing, leaf: number }));
            }
            Member::Group(number) => {
                let group = self.group(number);
                for &member in &group.unbounded {
                    self.gather(member, ray, range, kind, scratch);
                }
                group.bounded.along(ray, range, |place| {
                    self.gather(group.members[place as usize], ray, range, kind, scratch);
                    range.max
                });
            }
        }
    }

    /// All crossings of an object's leaves, sorted, of which only those at [`Parts::survives`] count.
    fn gather_sorted(&self, member: Member, ray: &Ray, range: Range, kind: RayKind, scratch: &mut Scratch) {
        scratch.found.clear();
        // Coincident faces just beyond the end take part in the decision about those before it.
        let beyond = Range { min: range.min, max: range.max + range.max.abs() * COARSE };
        self.gather(member, ray, beyond, kind, scratch);
        scratch.found.sort_unstable_by(|a, b| a.t().total_cmp(&b.t()).then(b.leaf.cmp(&a.leaf)));
    }

    /// The nearest point of an object's surface; of several at the same distance, that of the
    /// last leaf.
    pub(super) fn nearest(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
        scratch: &mut Scratch,
    ) -> Option<Found> {
        if let Some(found) = self.nearest_of_leaf(member, ray, range, kind) {
            return found;
        }
        if !Slabs::new(ray).meet(&self.extent(member).bounds, range) {
            return None;
        }
        self.gather_sorted(member, ray, range, kind, scratch);
        let found = &scratch.found;
        let first =
            (0..found.len()).find(|&i| range.contains(found[i].t()) && self.survives(ray, found, i))?;
        let end = found[first].t() + self.slack(ray, found[first].leaf, &found[first].crossing);
        let tied = (first + 1..found.len()).take_while(|&i| found[i].t() <= end);
        let last = tied.filter(|&i| range.contains(found[i].t())).fold(first, |best, i| {
            let wins = found[i].leaf > found[best].leaf && self.survives(ray, found, i);
            if wins { i } else { best }
        });
        Some(found[last])
    }

    /// The short way for a primitive that nothing cuts; the outer `None` asks for the long one.
    fn nearest_of_leaf(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
    ) -> Option<Option<Found>> {
        let Member::Leaf(number) = member else {
            return None;
        };
        let leaf = self.leaf(number);
        if leaf.hidden.intersects(kind) {
            return Some(None);
        }
        if leaf.limits.is_some() {
            return None;
        }
        let crossing = leaf.primitive.nearest(&leaf.inner(ray), range);
        Some(crossing.map(|crossing| Found { crossing, leaf: number }))
    }

    /// Hands out all points of an object's surface in ascending order until told to stop.
    pub(super) fn surface_along(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
        scratch: &mut Scratch,
        mut visit: impl FnMut(Found) -> bool,
    ) -> bool {
        if !Slabs::new(ray).meet(&self.extent(member).bounds, range) {
            return false;
        }
        self.gather_sorted(member, ray, range, kind, scratch);
        let found = &scratch.found;
        (0..found.len())
            .filter(|&i| range.contains(found[i].t()) && self.survives(ray, found, i))
            .any(|i| visit(found[i]))
    }

    /// Whether a crossing is surface of the whole tree it belongs to.
    fn survives(&self, ray: &Ray, found: &[Found], which: usize) -> bool {
        let candidate = &found[which];
        let mut member = Member::Leaf(candidate.leaf);
        let place = Place::new(self, ray, found, which);
        loop {
            if !self.clips_spare(member, &place) {
                return false;
            }
            let Some(parent) = self.parent(member) else {
                return true;
            };
            let kept = match self.group(parent).operation {
                Operation::Union => true,
                Operation::Intersection => self.others_agree(parent, member, &place, true),
                Operation::Merge => self.others_agree(parent, member, &place, false),
            };
            if !kept {
                return false;
            }
            member = Member::Group(parent);
        }
    }

    /// Whether the other members of a compound leave this one's surface: for an intersection they
    /// must all contain it, for a merge none may.
    fn others_agree(&self, group: u32, member: Member, place: &Place, wanted: bool) -> bool {
        let others = |point| self.inside_others(group, point, Some(member)) == wanted;
        let Some([before, after]) = place.around else {
            return others(place.point);
        };
        match (others(before), others(after)) {
            // Faces coincide: the surface remains where the whole is on one of its sides.
            (agree_before, agree_after) if agree_before != agree_after => {
                let side = if agree_before { before } else { after };
                !self.has_inside(member) || self.inside(member, side) == wanted
            }
            (agree, _) => agree,
        }
    }

    /// Whether clips leave a point: they are closed, so that rounding can't fray coincident faces.
    fn clips_spare(&self, member: Member, place: &Place) -> bool {
        let clips = self.limits(member).map_or(&[][..], |limits| &limits.clips);
        clips.iter().all(|&clip| {
            let [before, after] = place.close();
            [place.point, before, after].iter().any(|&point| self.inside(clip, point))
        })
    }

    fn has_inside(&self, member: Member) -> bool {
        match member {
            Member::Leaf(number) => self.leaf(number).flags.contains(LeafFlags::SOLID),
            Member::Group(_) => true,
        }
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
}

/// Rounding error of a crossing seen head on, relative to the coordinates.
const FINE: f64 = 64.0 * f64::EPSILON;

/// More grazing rays are treated like this one.
const LEAST_COSINE: f64 = 1e-3;

/// Rounding error of the most grazing crossing.
const COARSE: f64 = FINE / LEAST_COSINE;

/// Where a crossing is, and on which sides of it to look when faces coincide.
struct Place {
    point: DVec3,
    /// Points just before and just after, where another crossing is too close to tell apart.
    around: Option<[DVec3; 2]>,
    step: DVec3,
}

impl Place {
    fn new(parts: &Parts, ray: &Ray, found: &[Found], which: usize) -> Self {
        let t = found[which].t();
        let point = ray.at(t);
        let scale = ray.origin.abs().max(point.abs()).max_element();
        let coarse = COARSE * scale / ray.direction.length();
        let gap = |other: Option<&Found>| other.map_or(f64::INFINITY, |other| (other.t() - t).abs());
        let nearest = gap(found.get(which + 1)).min(gap(which.checked_sub(1).map(|i| &found[i])));
        // The exact measure needs a normal; most crossings are alone.
        if nearest > coarse {
            return Self {
                point,
                around: None,
                step: 2.0 * FINE * scale * ray.direction.normalize_or_zero(),
            };
        }
        let slack = parts.slack(ray, found[which].leaf, &found[which].crossing);
        let step = 2.0 * slack * ray.direction;
        let around = (nearest <= slack).then_some([point - step, point + step]);
        Self { point, around, step }
    }

    /// Points within rounding error on both sides.
    fn close(&self) -> [DVec3; 2] {
        [self.point - self.step, self.point + self.step]
    }
}
