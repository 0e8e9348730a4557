//! Intersections of one solid of any shape with convex ones, such as a lathe of which boxes are cut away. Convex solids
//! take stretches of the ray away; between these the odd one alone is asked, and only for its nearest crossing.
//!
//! Where surfaces are too close to each other to tell which comes first, the caller asks the general way.

use smallvec::SmallVec;

use super::scratch::Found;
use super::soon::{Room, Unclear};
use crate::world::object::{LeafFlags, Member};
use crate::world::parts::{Group, Parts};
use crate::world::ray::{Range, Ray};
use crate::world::shape::{Crossing, Shape};

/// How many times as far as rounding may move them apart surfaces are that surely don't coincide.
const APART: f64 = 4.0;

/// A stretch of the ray that a convex solid takes away.
struct Cut {
    enter: f64,
    leave: f64,
    /// Number of the leaf.
    leaf: u32,
}

/// All of them, and how close their ends may be.
struct Cuts {
    all: SmallVec<[Cut; 8]>,
    room: Room,
}

impl Cuts {
    /// What the convex members of a compound take of a ray; `None` if that is all of it.
    fn new(parts: &Parts, group: &Group, odd: u32, ray: &Ray) -> Option<Self> {
        let mut all = SmallVec::new();
        for &member in &group.members {
            let Member::Leaf(leaf) = member else { continue };
            if leaf == odd {
                continue;
            }
            let solid = parts.leaf(leaf);
            let inverted = solid.flags.contains(LeafFlags::INVERTED);
            match solid.primitive.span(&solid.asked(ray)) {
                Some(stretch) if inverted => {
                    all.push(Cut { enter: stretch.enter.t, leave: stretch.leave.t, leaf });
                }
                Some(stretch) => {
                    all.push(Cut { enter: f64::NEG_INFINITY, leave: stretch.enter.t, leaf });
                    all.push(Cut { enter: stretch.leave.t, leave: f64::INFINITY, leaf });
                }
                None if inverted => {}
                None => return None,
            }
        }
        Some(Self { all, room: Room::new(ray, APART) })
    }

    /// What is taken away at a distance.
    fn at(&self, t: f64) -> Option<&Cut> {
        self.all.iter().find(|cut| cut.enter <= t && t < cut.leave)
    }

    /// What is taken away next behind a distance.
    fn behind(&self, t: f64) -> Option<&Cut> {
        let behind = self.all.iter().filter(|cut| cut.enter > t && cut.enter < f64::INFINITY);
        behind.min_by(|a, b| a.enter.total_cmp(&b.enter))
    }

    /// Nothing, if no more than so `many` stretches may have an end at a distance.
    fn part(&self, t: f64, many: usize) -> Result<(), Unclear> {
        let room = self.room.at(t);
        let ends = self.all.iter().flat_map(|cut| [cut.enter, cut.leave]);
        if ends.filter(|end| (end - t).abs() <= room).count() <= many { Ok(()) } else { Err(Unclear) }
    }
}

impl Parts {
    /// The nearest point in `range` of the surface of such a compound.
    pub(super) fn nearest_of_odd(
        &self,
        group: &Group,
        odd: u32,
        ray: &Ray,
        range: Range,
    ) -> Result<Option<Found>, Unclear> {
        if range.min == f64::NEG_INFINITY {
            return Err(Unclear);
        }
        let Some(cuts) = Cuts::new(self, group, odd, ray) else { return Ok(None) };
        let (leaf, asked) = (self.leaf(odd), self.leaf(odd).asked(ray));
        let (mut at, mut face) = (range.min, None);
        // The odd one's next crossing, once it was asked.
        let mut ahead: Option<Option<Crossing>> = None;
        cuts.part(at, 0)?;
        loop {
            while let Some(cut) = cuts.at(at) {
                if cut.leave >= range.max {
                    let surely =
                        cut.leave == f64::INFINITY || cut.leave - cuts.room.at(cut.leave) > range.max;
                    return if surely { Ok(None) } else { Err(Unclear) };
                }
                (at, face) = (cut.leave, Some(cut.leaf));
                cuts.part(at, 1)?;
            }
            // Nothing is taken away from here to the next end.
            let next = cuts.behind(at);
            let end = next.map_or(f64::INFINITY, |cut| cut.enter);
            let [before, after] = [cuts.room.at(at), cuts.room.at(end)];
            let min = if face.is_some() { at - before } else { at };
            let crossing = match ahead {
                Some(known) if known.is_none_or(|Crossing { t, .. }| t > min) => known,
                _ => *ahead.insert(leaf.primitive.nearest(&asked, Range { min, ..range })),
            };
            if let Some(Crossing { t, .. }) = crossing
                && (face.is_some() && t <= at + before || (t - end).abs() <= after)
            {
                return Err(Unclear);
            }
            // Where something ends that was taken away its face is seen, if that is in the odd solid.
            if let Some(face) = face.filter(|_| leaf.contains(ray.at(at))) {
                return Ok(self.face(face, ray, at));
            }
            if let Some(crossing) = crossing.filter(|crossing| crossing.t < end) {
                return Ok(Some(Found { crossing, leaf: odd, near: 0 }));
            }
            let Some(next) = next.filter(|cut| cut.enter < range.max) else { return Ok(None) };
            cuts.part(end, 1)?;
            if leaf.contains(ray.at(end)) {
                return Ok(self.face(next.leaf, ray, end));
            }
            (at, face) = (end, None);
        }
    }

    /// The end at a distance of the stretch inside of a convex leaf.
    fn face(&self, number: u32, ray: &Ray, t: f64) -> Option<Found> {
        let leaf = self.leaf(number);
        let stretch = leaf.primitive.convex(&leaf.asked(ray))??;
        let enters = (stretch.enter.t - t).abs() <= (stretch.leave.t - t).abs();
        let end = if enters { stretch.enter } else { stretch.leave };
        Some(Found { crossing: Crossing::from(end), leaf: number, near: 0 })
    }
}
