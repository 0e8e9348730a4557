//! Short ways to the surface of solids that cut each other nowhere near the ray, or only by convex solids: of
//! leaves, of compounds of a few convex solids and of unions, clipped or not.
//!
//! Where surfaces are too close to each other to tell which comes first, the caller asks the general way.

use super::COARSE;
use super::scratch::Found;
use crate::world::object::{LeafFlags, Member, RayKind};
use crate::world::parts::{Group, Operation, Parts};
use crate::world::ray::{Range, Ray};
use crate::world::shape::{Primitive, Shape};

/// Surfaces are too close to each other to tell which comes first.
pub(super) struct Unclear;

/// How far apart crossings of a ray may be that coincide, and some more.
pub(super) struct Room {
    /// At the ray's origin.
    least: f64,
    /// For each unit of distance.
    growth: f64,
}

impl Room {
    /// So many times as much as rounding may take.
    #[inline]
    pub(super) fn new(ray: &Ray, times: f64) -> Self {
        let growth = times * COARSE;
        Self { least: growth * ray.origin.abs().max_element() / ray.direction.length(), growth }
    }

    /// At a distance; none where that is not finite.
    #[inline]
    pub(super) fn at(&self, t: f64) -> f64 {
        if t.is_finite() { self.least + self.growth * t.abs() } else { 0.0 }
    }
}

/// What convex clips leave of a ray.
struct Window {
    /// Where it begins and how far rounding may have moved that.
    enter: [f64; 2],
    /// The same where it ends.
    leave: [f64; 2],
}

impl Window {
    /// `None` where clips leave nothing.
    fn new(parts: &Parts, clips: impl Iterator<Item = Member>, ray: &Ray) -> Result<Option<Self>, Unclear> {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for clip in clips {
            let Member::Leaf(clip) = clip else { return Err(Unclear) };
            let clip = parts.leaf(clip);
            if !clip.is_convex() {
                return Err(Unclear);
            }
            let span = clip.primitive.span(&clip.asked(ray)).map(|span| (span.enter.t, span.leave.t));
            let kept = match (span, clip.flags.contains(LeafFlags::INVERTED)) {
                (Some(span), false) => span,
                (None, false) => return Ok(None),
                (None, true) => continue,
                (Some((f64::NEG_INFINITY, f64::INFINITY)), true) => return Ok(None),
                // Of half a line the other half is left.
                (Some((f64::NEG_INFINITY, end)), true) => (end, f64::INFINITY),
                (Some((start, f64::INFINITY)), true) => (f64::NEG_INFINITY, start),
                (Some(_), true) => return Err(Unclear),
            };
            (enter, leave) = (enter.max(kept.0), leave.min(kept.1));
        }
        let room = Room::new(ray, 4.0);
        Ok(Some(Self { enter: [enter, room.at(enter)], leave: [leave, room.at(leave)] }))
    }

    /// The part of a range that may be in the window; `None` if there is none.
    fn of(&self, range: Range) -> Option<Range> {
        let [enter, leave] = [self.enter[0] - self.enter[1], self.leave[0] + self.leave[1]];
        let part = Range { min: range.min.max(enter), max: range.max.min(leave) };
        (part.min < part.max).then_some(part)
    }

    /// Whether a distance is in the window for certain.
    fn holds(&self, t: f64) -> bool {
        t > self.enter[0] + self.enter[1] && t < self.leave[0] - self.leave[1]
    }

    /// Its ends, if they are in a range.
    fn ends_in(&self, range: Range) -> Result<[Option<f64>; 2], Unclear> {
        let mut ends = [None; 2];
        for (end, [t, room]) in ends.iter_mut().zip([self.enter, self.leave]) {
            if (t - range.min).abs() <= room || (t - range.max).abs() <= room {
                return Err(Unclear);
            }
            *end = range.contains(t).then_some(t);
        }
        Ok(ends)
    }
}

impl Parts {
    /// The nearest point of an object's surface.
    pub(super) fn nearest_soon(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
    ) -> Result<Option<Found>, Unclear> {
        let Some(limits) = self.limits(member).filter(|limits| !limits.clips.is_empty()) else {
            return self.nearest_unclipped(member, ray, range, kind);
        };
        let is_slow = matches!(member, Member::Leaf(leaf) if !self.leaf(leaf).primitive.is_soon_asked());
        // Mostly it is missed, or met where nothing is clipped away.
        let first = if is_slow { None } else { self.nearest_unclipped(member, ray, range, kind)? };
        if first.is_none() && !is_slow {
            return Ok(None);
        }
        let Some(window) = Window::new(self, limits.clips.iter().copied(), ray)? else { return Ok(None) };
        if first.is_some_and(|found| window.holds(found.t())) {
            return Ok(first);
        }
        let Some(range) = window.of(range) else { return Ok(None) };
        let found = self.nearest_unclipped(member, ray, range, kind)?;
        if found.is_none_or(|found| window.holds(found.t())) { Ok(found) } else { Err(Unclear) }
    }

    /// The same, but for clips.
    fn nearest_unclipped(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
    ) -> Result<Option<Found>, Unclear> {
        match member {
            Member::Leaf(number) => {
                let crossing = if self.is_whole(member) {
                    self.ask_bounded(number, ray, range, kind, Primitive::nearest)
                } else {
                    let leaf = self.leaf(number);
                    let is_asked = !leaf.hidden.intersects(kind) && self.admits(member, ray);
                    is_asked.then(|| leaf.primitive.nearest(&leaf.asked(ray), range)).flatten()
                };
                Ok(crossing.map(|crossing| Found { crossing, leaf: number, near: 0 }))
            }
            Member::Group(number) => {
                let group = self.group(number);
                if group.hidden.intersects(kind) || !self.admits(member, ray) {
                    Ok(None)
                } else if group.convex {
                    self.nearest_of_convex(group, ray, range)
                } else if let Some(odd) = group.odd {
                    self.nearest_of_odd(group, odd, ray, range)
                } else if group.operation == Operation::Union {
                    self.nearest_of_union(group, ray, range, kind)
                } else if !group.turns.is_empty() {
                    self.nearest_in_turn(group, ray, range)
                } else {
                    Err(Unclear)
                }
            }
        }
    }

    /// The nearest point of the surfaces of a union's members, each of which is asked on its own.
    fn nearest_of_union(
        &self,
        group: &Group,
        ray: &Ray,
        range: Range,
        kind: RayKind,
    ) -> Result<Option<Found>, Unclear> {
        let room = Room::new(ray, 2.0);
        let (mut best, mut unclear) = (None::<Found>, false);
        let mut near = range;
        let mut ask = |member: Member| {
            if let Some(found) = self.nearest(member, ray, near, kind) {
                let room = room.at(found.t());
                unclear |= best.is_some_and(|best| (best.t() - found.t()).abs() <= room);
                if best.is_none_or(|best| found.t() < best.t()) {
                    best = Some(found);
                    // What may be at the same place is of interest too.
                    near.max = range.max.min(found.t() + 2.0 * room);
                }
            }
            if unclear { f64::NEG_INFINITY } else { near.max }
        };
        for &member in &group.unbounded {
            ask(member);
        }
        group.bounded.along(ray, range, |place| ask(group.members[place as usize]));
        if unclear { Err(Unclear) } else { Ok(best) }
    }

    /// Whether anything of an object's surface is in `range`.
    pub(super) fn occludes_soon(
        &self,
        member: Member,
        ray: &Ray,
        range: Range,
        kind: RayKind,
    ) -> Result<bool, Unclear> {
        match member {
            Member::Leaf(number) if self.is_whole(member) => {
                let ask =
                    |primitive: &Primitive, ray: &Ray, range| primitive.occludes(ray, range).then_some(());
                Ok(self.ask_bounded(number, ray, range, kind, ask).is_some())
            }
            Member::Group(number)
                if let group = self.group(number)
                    && group.is_simple()
                    && self.is_whole(member) =>
            {
                if group.hidden.intersects(kind) || !self.admits(member, ray) {
                    return Ok(false);
                }
                match group.odd {
                    Some(odd) => self.occludes_odd((group, odd), ray, range),
                    None => self.occludes_convex(group, ray, range),
                }
            }
            _ => Ok(self.nearest_soon(member, ray, range, kind)?.is_some()),
        }
    }

    /// The same for a leaf that convex solids cut.
    fn occludes_odd(&self, (group, odd): (&Group, u32), ray: &Ray, range: Range) -> Result<bool, Unclear> {
        let others = group.members.iter().copied().filter(|&member| member != Member::Leaf(odd));
        let Some(window) = Window::new(self, others, ray)? else {
            return Ok(false);
        };
        let Some(part) = window.of(range) else { return Ok(false) };
        let leaf = self.leaf(odd);
        if let Some(crossing) = leaf.primitive.nearest(&leaf.asked(ray), part) {
            return if window.holds(crossing.t) { Ok(true) } else { Err(Unclear) };
        }
        // Inside the solid, what cuts it is its surface.
        Ok(window.ends_in(range)?.into_iter().flatten().any(|end| leaf.contains(ray.at(end))))
    }

    /// Whether nothing of a member is clipped away.
    pub(super) fn is_whole(&self, member: Member) -> bool {
        self.limits(member).is_none_or(|limits| limits.clips.is_empty())
    }
}
