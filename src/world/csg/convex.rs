//! Compounds of a few convex solids: their surface from the stretches of the ray inside of each.
//!
//! Where faces coincide nothing is decided here: the caller asks the general way then.

use smallvec::SmallVec;

use super::COARSE;
use super::scratch::Found;
use super::soon::Unclear;
use crate::math::Lanes;
use crate::math::wide::widest;
use crate::world::facets::Common;
use crate::world::object::{LeafFlags, Member};
use crate::world::parts::{Group, MOST_CONVEX, Operation, Parts};
use crate::world::ray::{Range, Ray};
use crate::world::shape::Crossing;
use crate::world::shape::stretch::{Stretch, UNSAID};

/// The most members of such a compound.
const MOST: usize = MOST_CONVEX;

/// The stretches of a ray inside of the members of a compound that it meets.
struct Stretches {
    enter: [f64; MOST],
    leave: [f64; MOST],
    /// The parts of both ends, where they are said.
    parts: [[u32; 2]; MOST],
    /// The members' numbers among the leaves.
    leaves: [u32; MOST],
    /// Whether they are turned inside out.
    inverted: [bool; MOST],
    count: usize,
    /// Of the places the first are those of all that planes have in common.
    common: usize,
    /// Where the planes are, four at a time.
    planes: [Lanes; MOST / Lanes::COUNT],
    fours: usize,
    /// How far coincident faces may be apart: at the ray's origin, and more for each unit of distance.
    room: [f64; 2],
}

/// An end of a stretch, or the start of the ray.
#[derive(Clone, Copy)]
struct Edge {
    t: f64,
    /// Whose it is; [`MOST`] for nobody's.
    place: usize,
    /// Whether the ray leaves the member there.
    leaves: bool,
}

impl Edge {
    /// Where no member has an end.
    fn at(t: f64) -> Self {
        Self { t, place: MOST, leaves: false }
    }
}

impl Parts {
    /// The nearest point in `range` of the surface of a compound of convex solids.
    pub(super) fn nearest_of_convex(
        &self,
        group: &Group,
        ray: &Ray,
        range: Range,
    ) -> Result<Option<Found>, Unclear> {
        widest(
            #[inline(always)]
            || {
                let mut stretches = Stretches::new(ray);
                let edge = self.first_edge(group, ray, range, &mut stretches)?;
                Ok(edge.and_then(|edge| self.found(ray, &stretches, edge)))
            },
        )
    }

    /// Whether anything of such a compound is in `range`.
    pub(super) fn occludes_convex(&self, group: &Group, ray: &Ray, range: Range) -> Result<bool, Unclear> {
        widest(
            #[inline(always)]
            || Ok(self.first_edge(group, ray, range, &mut Stretches::new(ray))?.is_some()),
        )
    }

    /// The edge where such a compound's surface first is in `range`.
    #[inline(always)]
    fn first_edge(
        &self,
        group: &Group,
        ray: &Ray,
        range: Range,
        stretches: &mut Stretches,
    ) -> Result<Option<Edge>, Unclear> {
        if range.min == f64::NEG_INFINITY {
            return Err(Unclear);
        }
        if !self.meet(group, ray, range, stretches) {
            return Ok(None);
        }
        let edge = stretches.nearest(group.operation, range)?;
        Ok(edge.filter(|edge| range.contains(edge.t)))
    }

    /// The crossing at an edge.
    #[inline(always)]
    fn found(&self, ray: &Ray, stretches: &Stretches, edge: Edge) -> Option<Found> {
        let place = edge.place % MOST;
        let number = stretches.leaves[place];
        let part = stretches.parts[place][usize::from(edge.leaves)];
        if part != UNSAID {
            return Some(Found { crossing: Crossing::new(edge.t, part), leaf: number, near: 0 });
        }
        let leaf = self.leaf(number);
        let stretch = leaf.primitive.convex(&leaf.asked(ray))??;
        let end = if edge.leaves { stretch.leave } else { stretch.enter };
        Some(Found { crossing: Crossing::from(end), leaf: number, near: 0 })
    }

    /// All points in `range` of the surface of such a compound, in ascending order, until `visit` says to
    /// stop; whether it did.
    #[inline(always)]
    pub(super) fn along_convex(
        &self,
        group: &Group,
        ray: &Ray,
        mut range: Range,
        visit: impl FnMut(Found) -> bool,
    ) -> Result<bool, Unclear> {
        if range.min == f64::NEG_INFINITY {
            return Err(Unclear);
        }
        let mut stretches = Stretches::new(ray);
        if !self.meet(group, ray, range, &mut stretches) {
            return Ok(false);
        }
        let mut edges = SmallVec::<[Edge; 2 * MOST]>::new();
        while let Some(edge) = stretches.nearest(group.operation, range)? {
            if edge.t >= range.max {
                break;
            }
            edges.push(edge);
            range.min = edge.t;
        }
        Ok(edges.into_iter().filter_map(|edge| self.found(ray, &stretches, edge)).any(visit))
    }

    /// Finds where a ray is inside of each member; whether it may meet the whole.
    #[inline(always)]
    fn meet(&self, group: &Group, ray: &Ray, range: Range, all: &mut Stretches) -> bool {
        let common = group.operation == Operation::Intersection;
        // Solids before what is cut out of them.
        let mut members = &group.turns;
        if let Some(facets) = &group.facets {
            members = &facets.others;
            let met = facets.common(ray, |distances| {
                all.planes[all.fours % (MOST / Lanes::COUNT)] = distances;
                all.fours += 1;
            });
            let Some(Common { enter, leave }) = met else { return false };
            if all.is_before(leave.0, range.min) || all.is_before(range.max, enter.0) {
                return false;
            }
            for (place, edges, leaf) in
                [(0, [enter.0, f64::INFINITY], enter.1), (1, [f64::NEG_INFINITY, leave.0], leave.1)]
            {
                [all.enter[place], all.leave[place]] = edges;
                all.parts[place] = [0; 2];
                all.leaves[place] = leaf;
            }
            (all.common, all.count) = (2, 2);
        }
        let mut is_known = !common;
        for &member in members {
            let Member::Leaf(number) = member else { continue };
            let leaf = self.leaf(number);
            let inverted = leaf.flags.contains(LeafFlags::INVERTED);
            if inverted && !is_known {
                if !all.have_common(range) {
                    return false;
                }
                is_known = true;
            }
            let met = leaf.primitive.span(&leaf.asked(ray)).filter(|stretch| {
                !all.is_before(stretch.leave.t, range.min) && !all.is_before(range.max, stretch.enter.t)
            });
            match met {
                Some(Stretch { enter, leave }) => {
                    let place = all.count % MOST;
                    all.enter[place] = enter.t;
                    all.leave[place] = leave.t;
                    all.parts[place] = [enter.part, leave.part];
                    all.leaves[place] = number;
                    all.inverted[place] = inverted;
                    all.count = place + 1;
                }
                None if common && !inverted => return false,
                None => {}
            }
        }
        true
    }
}

impl Stretches {
    #[inline(always)]
    fn new(ray: &Ray) -> Self {
        Self {
            enter: [0.0; MOST],
            leave: [0.0; MOST],
            parts: [[UNSAID; 2]; MOST],
            leaves: [0; MOST],
            inverted: [false; MOST],
            count: 0,
            common: 0,
            planes: [Lanes::ZERO; MOST / Lanes::COUNT],
            fours: 0,
            room: [COARSE * ray.origin.abs().max_element() / ray.direction.length(), COARSE],
        }
    }

    /// How far from `t` a coincident face may be.
    #[inline(always)]
    fn room(&self, t: f64) -> f64 {
        self.room[0] + self.room[1] * t.abs()
    }

    /// Whether `t` comes before `other`, rounding or not.
    #[inline(always)]
    fn is_before(&self, t: f64, other: f64) -> bool {
        other - t > self.room(t)
    }

    /// Whether all that are not inverted so far may have something in common in a range.
    #[inline(always)]
    fn have_common(&self, range: Range) -> bool {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for place in 0..self.count.min(MOST) {
            if !self.inverted[place] {
                enter = if self.enter[place] > enter { self.enter[place] } else { enter };
                leave = if self.leave[place] < leave { self.leave[place] } else { leave };
            }
        }
        !self.is_before(leave, enter)
            && !self.is_before(leave, range.min)
            && !self.is_before(range.max, enter)
    }

    /// The edge, if no other is so close that they may coincide.
    #[inline(always)]
    fn clear(&self, edge: Edge) -> Result<Edge, Unclear> {
        let room = self.room(edge.t);
        let mut close = 0;
        for place in self.common..self.count.min(MOST) {
            close += u32::from((self.enter[place] - edge.t).abs() <= room);
            close += u32::from((self.leave[place] - edge.t).abs() <= room);
        }
        for planes in &self.planes[..self.fours.min(MOST / Lanes::COUNT)] {
            close += (*planes - edge.t).bits(|gap| gap.abs() <= room).count_ones();
        }
        // It is close to itself.
        if close <= 1 { Ok(edge) } else { Err(Unclear) }
    }

    #[inline(always)]
    fn nearest(&self, operation: Operation, range: Range) -> Result<Option<Edge>, Unclear> {
        match operation {
            Operation::Intersection => self.nearest_common(range.min),
            Operation::Merge | Operation::Union => self.nearest_of_any(range.min),
        }
    }

    /// The nearest surface behind `start` of what is in all members.
    #[inline(always)]
    fn nearest_common(&self, start: f64) -> Result<Option<Edge>, Unclear> {
        let (mut enter, mut leave) = (Edge::at(f64::NEG_INFINITY), Edge::at(f64::INFINITY));
        let count = self.count.min(MOST);
        for place in 0..count {
            if !self.inverted[place] {
                if self.enter[place] > enter.t {
                    enter = Edge { t: self.enter[place], place, leaves: false };
                }
                if self.leave[place] < leave.t {
                    leave = Edge { t: self.leave[place], place, leaves: true };
                }
            }
        }
        if self.is_before(leave.t, enter.t) {
            return Ok(None);
        }
        if leave.t <= start {
            return self.clear(leave).map(|_| None);
        }
        let first = if enter.t <= start { Edge::at(start) } else { self.clear(enter)? };
        let Some(at) = self.behind(first, true, leave.t)?.filter(|at| at.t < leave.t) else {
            return Ok(None);
        };
        if at.place < MOST {
            return Ok(Some(at));
        }
        // The ray starts in the solid and meets what ends it first.
        let mut first = leave;
        for place in 0..count {
            let t = self.enter[place];
            if self.inverted[place] && t > start && t < first.t {
                first = Edge { t, place, leaves: false };
            }
        }
        if first.t == f64::INFINITY { Ok(None) } else { self.clear(first).map(Some) }
    }

    /// The nearest surface behind `start` of what is in any member; none is turned inside out.
    #[inline(always)]
    fn nearest_of_any(&self, start: f64) -> Result<Option<Edge>, Unclear> {
        let Some(at) = self.behind(Edge::at(start), false, f64::INFINITY)? else {
            return Ok(None);
        };
        if at.place < MOST {
            return Ok(Some(at));
        }
        let mut first = Edge::at(f64::INFINITY);
        for place in 0..self.count.min(MOST) {
            let t = self.enter[place];
            if t > start && t < first.t {
                first = Edge { t, place, leaves: false };
            }
        }
        if first.t == f64::INFINITY { Ok(None) } else { self.clear(first).map(Some) }
    }

    /// The first point from `at` on that is in none of the members, or of those turned inside out; `None` if
    /// it is surely behind `end`.
    #[inline(always)]
    fn behind(&self, mut at: Edge, inverted: bool, end: f64) -> Result<Option<Edge>, Unclear> {
        let count = self.count.min(MOST);
        let mut place = 0;
        while place < count {
            let (enter, leave) = (self.enter[place], self.leave[place]);
            if self.inverted[place] == inverted && enter <= at.t && at.t < leave {
                if leave == f64::INFINITY || self.is_before(end, leave) {
                    return Ok(None);
                }
                at = self.clear(Edge { t: leave, place, leaves: true })?;
                place = 0;
            } else {
                place += 1;
            }
        }
        Ok(Some(at))
    }
}
