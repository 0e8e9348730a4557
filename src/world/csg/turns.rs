//! Compounds of a few solids of any shape, compounds among them: each member is asked for its nearest crossing alone, no
//! farther than to that of the others, and the nearest of all is surface where the others leave it. Of what a ray never
//! comes to nothing is found out.
//!
//! Where surfaces are too close to each other to tell which comes first, the caller asks the general way.

use smallvec::SmallVec;

use super::scratch::Found;
use super::soon::{Room, Unclear};
use crate::math::Bounds;
use crate::world::accel::Slabs;
use crate::world::object::{LeafFlags, Member};
use crate::world::parts::{Group, Operation, Parts};
use crate::world::ray::{Range, Ray};
use crate::world::shape::Shape;
use crate::world::shape::stretch::Stretch;

/// How many times as far as rounding may move them apart surfaces are that surely don't coincide.
const APART: f64 = 4.0;

/// A ray that asks members in turn.
struct Way<'a> {
    parts: &'a Parts,
    ray: &'a Ray,
    slabs: Slabs,
    room: Room,
}

/// A member that a ray comes near, and its next crossing.
struct Turn {
    member: Member,
    /// Where the ray is in its box, and a little more.
    reach: Range,
    /// Of a convex solid, where the ray is inside.
    stretch: Option<Stretch>,
    next: Option<Found>,
    /// Where there is none, the distance up to which it was looked for.
    end: f64,
}

impl Parts {
    /// The nearest point in `range` of the surface of such a compound.
    pub(super) fn nearest_in_turn(
        &self,
        group: &Group,
        ray: &Ray,
        range: Range,
    ) -> Result<Option<Found>, Unclear> {
        if range.min == f64::NEG_INFINITY {
            return Err(Unclear);
        }
        let way = Way { parts: self, ray, slabs: Slabs::new(ray), room: Room::new(ray, APART) };
        // What coincides with a crossing before the end has a say about it.
        let beyond = Range { max: way.beyond(range.max), ..range };
        let Some(reach) = way.narrowed(&group.extent.bounds, beyond) else { return Ok(None) };
        Ok(way.nearest(group, range.min, reach)?.filter(|found| range.contains(found.t())))
    }
}

impl Way<'_> {
    /// The nearest surface behind `start` of a compound of which a part of the ray is in the box.
    fn nearest(&self, group: &Group, start: f64, reach: Range) -> Result<Option<Found>, Unclear> {
        let (union, decisive) = (group.operation == Operation::Union, group.operation.decisive());
        let decides = (!union).then_some(decisive);
        let mut turns: SmallVec<[Turn; 8]> = SmallVec::new();
        for &member in &group.turns {
            match self.turn(member, reach) {
                Ok(turn) => turns.push(turn),
                Err(inside) if decides == Some(inside) => return Ok(None),
                Err(_) => continue,
            }
            // Often that is all there is to ask.
            if let [only] = &mut turns[..]
                && self.ask(only, start, reach.max)?
                && decides == Some(self.inside(only, only.reach.max))
            {
                return Ok(None);
            }
        }
        let mut at = start;
        while let Some((place, found)) = self.first(decides, &mut turns, at, reach.max)? {
            let t = found.t();
            // A surface that was just left, or passed, may be the same.
            if t - at <= self.room.at(t) {
                return Err(Unclear);
            }
            let is_kept = |(other, turn): (usize, &Turn)| other == place || self.inside(turn, t) != decisive;
            if union || turns.iter().enumerate().all(is_kept) {
                return Ok(Some(found));
            }
            at = t;
            turns[place].next = None;
            turns[place].end = at;
        }
        Ok(None)
    }

    /// The first crossing of any member between two distances, and whose it is; none where a member decides, by its
    /// answer to "inside?", that nothing in between is surface of the whole.
    fn first(
        &self,
        decides: Option<bool>,
        turns: &mut [Turn],
        at: f64,
        mut end: f64,
    ) -> Result<Option<(usize, Found)>, Unclear> {
        let mut first = None;
        let whole = end;
        for (place, turn) in turns.iter_mut().enumerate() {
            // Leaves are not asked again for what is farther: that takes as long as to look for it at once.
            let limit = match turn.member {
                Member::Leaf(_) => whole,
                Member::Group(_) => whole.min(self.beyond(end)),
            };
            let passed = turn.next.is_none() && turn.end < limit && self.ask(turn, at, limit)?;
            if passed && first.is_none() && decides == Some(self.inside(turn, limit.min(turn.reach.max))) {
                return Ok(None);
            }
            if let Some(next) = turn.next.filter(|next| next.t() < end) {
                (first, end) = (Some((place, next)), next.t());
            }
        }
        let room = self.room.at(end);
        let Some((place, found)) = first else { return Ok(None) };
        for (other, turn) in turns.iter().enumerate() {
            if other != place && turn.next.is_some_and(|next| next.t() - end <= room) {
                return Err(Unclear);
            }
        }
        Ok(Some((place, found)))
    }

    /// Whether the point at a distance is inside a member.
    #[inline]
    fn inside(&self, turn: &Turn, t: f64) -> bool {
        if let (Some(Stretch { enter, leave }), Member::Leaf(number)) = (turn.stretch, turn.member) {
            let inverted = self.parts.leaf(number).flags.contains(LeafFlags::INVERTED);
            return (enter.t < t && t < leave.t) != inverted;
        }
        if turn.reach.min <= t && t <= turn.reach.max {
            self.parts.inside(turn.member, self.ray.at(t))
        } else {
            self.parts.is_beyond(turn.member)
        }
    }

    /// A member that the ray comes near; else whether all of the ray is inside of it.
    #[inline]
    fn turn(&self, member: Member, reach: Range) -> Result<Turn, bool> {
        let Some(reach) = self.narrowed(&self.parts.extent(member).bounds, reach) else {
            return Err(self.parts.is_beyond(member));
        };
        let mut turn = Turn { member, reach, stretch: None, next: None, end: f64::NEG_INFINITY };
        if let Member::Leaf(number) = member {
            let leaf = self.parts.leaf(number);
            if leaf.primitive.is_convex() {
                match leaf.primitive.convex(&leaf.asked(self.ray)).flatten() {
                    None => return Err(leaf.flags.contains(LeafFlags::INVERTED)),
                    stretch => turn.stretch = stretch,
                }
            }
        }
        Ok(turn)
    }

    /// Looks for the next crossing of a member between two distances; whether there is none, so that all of the way is
    /// inside of it, or nothing.
    fn ask(&self, turn: &mut Turn, start: f64, limit: f64) -> Result<bool, Unclear> {
        turn.end = limit;
        let range = Range { min: start.max(turn.reach.min), max: limit.min(turn.reach.max) };
        if range.min < range.max {
            turn.next = match turn.member {
                Member::Leaf(number) => {
                    let leaf = self.parts.leaf(number);
                    let crossing = match turn.stretch {
                        Some(stretch) => stretch.nearest(range),
                        None => leaf.primitive.nearest(&leaf.asked(self.ray), range),
                    };
                    crossing.map(|crossing| Found { crossing, leaf: number, near: 0 })
                }
                Member::Group(number) => {
                    let group = self.parts.group(number);
                    match group.convex {
                        true => self.parts.nearest_of_convex(group, self.ray, range)?,
                        false => self.nearest(group, start, range)?,
                    }
                }
            };
        }
        Ok(turn.next.is_none() && range.max.is_finite())
    }

    /// Behind a distance, so far that nothing there coincides with anything here.
    #[inline]
    fn beyond(&self, t: f64) -> f64 {
        t + self.room.at(t)
    }

    /// The part of a range that may be in a box, and a little more on both sides; `None` if there is none.
    #[inline(always)]
    fn narrowed(&self, bounds: &Bounds, range: Range) -> Option<Range> {
        let (enter, leave) = self.slabs.overlap_in(bounds, range)?;
        let (enter, leave) = (enter - self.room.at(enter), leave + self.room.at(leave));
        Some(Range { min: range.min.max(enter), max: range.max.min(leave) })
    }
}
