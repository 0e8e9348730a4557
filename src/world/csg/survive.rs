//! Which crossings are surface of the whole.
//!
//! Where faces of several members coincide, the point alone decides nothing: rounding would make
//! speckles. There the states just before and just after are compared, which gives the solid's
//! closed surface: a cutter flush with a face leaves a hole, flush merged faces leave one face.

use super::scratch::{Found, Inside, Near, Scratch};
use super::{COARSE, FINE};
use crate::world::object::{LeafFlags, Member};
use crate::world::parts::{Operation, Parts};
use crate::world::ray::Ray;

/// A tree of solids as far as it is near a ray.
pub(super) struct Tree<'a> {
    parts: &'a Parts,
    ray: &'a Ray,
    near: &'a [Near],
    found: &'a [Found],
    /// Length of the ray's direction.
    length: f64,
}

impl<'a> Tree<'a> {
    #[inline]
    pub(super) fn new(parts: &'a Parts, ray: &'a Ray, scratch: &'a Scratch) -> Self {
        Self { parts, ray, near: &scratch.near, found: &scratch.found, length: scratch.length }
    }

    /// Whether a crossing is surface of the whole tree it belongs to.
    pub(super) fn survives(&self, which: usize) -> bool {
        let mut member = self.found[which].near as usize;
        let place = Place::new(self, which);
        loop {
            let near = &self.near[member];
            if near.clipped && !self.clips_spare(near.member, place.t, place.step(self)) {
                return false;
            }
            let Some(parent) = near.parent.map(|parent| parent as usize) else {
                return true;
            };
            let outer = near.outer as usize;
            let kept = match self.near[parent].operation {
                Some(Operation::Intersection) => self.others_agree(parent, outer, &place, true),
                Some(Operation::Merge) => self.others_agree(parent, outer, &place, false),
                Some(Operation::Union) | None => true,
            };
            if !kept {
                return false;
            }
            member = parent;
        }
    }

    /// Greatest distance within which crossings may be one, as rounding goes.
    #[inline]
    pub(super) fn coarse(&self, t: f64) -> f64 {
        COARSE * self.scale(t) / self.length
    }

    /// The greatest coordinate on the way to a distance.
    #[inline]
    fn scale(&self, t: f64) -> f64 {
        self.ray.origin.abs().max(self.ray.at(t).abs()).max_element()
    }

    /// Whether the point at a distance is inside a member.
    fn inside(&self, member: usize, t: f64) -> bool {
        let member = self.near[member].inner as usize;
        let what = self.near[member].member;
        match self.near[member].inside {
            Inside::Between { enter, leave, inverted } => (enter < t && t < leave) != inverted,
            Inside::Constant(inside) => inside,
            Inside::Surface => false,
            Inside::Point if self.clips(what).is_empty() => self.parts.inside(what, self.ray.at(t)),
            Inside::Point => self.clipped_to(what, t) && self.parts.inside_unclipped(what, self.ray.at(t)),
            Inside::Members => self.clipped_to(what, t) && self.inside_others(member, None, t),
        }
    }

    fn clips(&self, member: Member) -> &[Member] {
        self.parts.limits(member).map_or(&[], |limits| &limits.clips)
    }

    /// Whether a member's clips leave the point at a distance.
    fn clipped_to(&self, member: Member, t: f64) -> bool {
        if self.clips(member).is_empty() {
            return true;
        }
        self.clips_spare(member, t, FINE * self.scale(t) / self.length)
    }

    /// Whether the point at a distance is inside a compound from which one member is taken away.
    #[inline]
    fn inside_others(&self, compound: usize, without: Option<usize>, t: f64) -> bool {
        let Near { operation, end, .. } = self.near[compound];
        let decisive = operation.is_some_and(Operation::decisive);
        let mut next = compound + 1;
        while let Some(near) = self.near[..end as usize].get(next) {
            let inside = match near.inside {
                Inside::Between { enter, leave, inverted } => (enter < t && t < leave) != inverted,
                _ => self.inside(next, t),
            };
            if inside == decisive && Some(next) != without {
                return decisive;
            }
            next = near.end as usize;
        }
        !decisive
    }

    /// Whether the other members of a compound leave this one's surface: for an intersection they
    /// must all contain it, for a merge none may.
    #[inline]
    fn others_agree(&self, compound: usize, member: usize, place: &Place, wanted: bool) -> bool {
        let others = |t| self.inside_others(compound, Some(member), t) == wanted;
        let Some([before, after]) = place.around else {
            return others(place.t);
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

    /// Whether clips leave a point: they are closed, by a step to both sides, so that rounding can't
    /// fray coincident faces.
    fn clips_spare(&self, member: Member, t: f64, step: f64) -> bool {
        self.clips(member).iter().all(|&clip| {
            let points = [t, t - step, t + step].map(|t| self.ray.at(t));
            points.iter().any(|&point| self.parts.inside(clip, point))
        })
    }

    fn has_inside(&self, member: usize) -> bool {
        match self.near[member].member {
            Member::Leaf(number) => self.parts.leaf(number).flags.contains(LeafFlags::SOLID),
            Member::Group(_) => true,
        }
    }
}

/// Where a crossing is, and on which sides of it to look when faces coincide.
struct Place {
    t: f64,
    /// Distances just before and just after, where another crossing is too close to tell apart.
    around: Option<[f64; 2]>,
    /// To a point within rounding error, where it is known that it matters.
    step: Option<f64>,
}

impl Place {
    fn new(tree: &Tree, which: usize) -> Self {
        let found = tree.found;
        let t = found[which].t();
        let gap = |other: Option<&Found>| other.map_or(f64::INFINITY, |other| (other.t() - t).abs());
        let nearest = gap(found.get(which + 1)).min(gap(which.checked_sub(1).map(|i| &found[i])));
        // The exact measure needs a normal; most crossings are alone.
        if nearest == f64::INFINITY || nearest > tree.coarse(t) {
            return Self { t, around: None, step: None };
        }
        let slack = tree.parts.slack(tree.ray, found[which].leaf, &found[which].crossing);
        let step = 2.0 * slack;
        Self { t, around: (nearest <= slack).then_some([t - step, t + step]), step: Some(step) }
    }

    /// To a point within rounding error.
    fn step(&self, tree: &Tree) -> f64 {
        self.step.unwrap_or_else(|| 2.0 * FINE * tree.scale(self.t) / tree.length)
    }
}
