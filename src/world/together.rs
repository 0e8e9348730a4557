//! Rays that travel together: what a pencil of them may meet is found once, and four of them are asked at a time
//! about that. They meet what each of them would meet alone.

use super::accel::{Four, Pencil, Within};
use super::hit::{Geometry, Hit};
use super::object::{Leaf, Member, RayKind};
use super::ray::{Range, Rays};
use super::shape::Crossing;
use crate::math::wide::widest;
use crate::math::{Lanes, tally};

/// Stands for the part of a crossing that has more to say than which part it is on.
const TOLD: f64 = -1.0;

/// The nearest surfaces that four rays know of.
#[derive(Clone, Copy)]
struct Met {
    /// How far they are; infinite for none.
    distance: Lanes,
    /// The objects, by number.
    object: Lanes,
    /// The parts of the leaves, or [`TOLD`].
    part: Lanes,
}

impl Met {
    const NOTHING: Self = Self {
        distance: Lanes::splat(f64::INFINITY),
        object: Lanes::splat(f64::INFINITY),
        part: Lanes::ZERO,
    };

    /// With those crossings that are ahead and nearer than those before, or as near and of what was declared first.
    #[inline(always)]
    fn with(self, number: u32, distance: Lanes, part: Lanes) -> Self {
        let number = f64::from(number);
        let ahead = distance.map(|t| if t > 0.0 { t } else { f64::NAN });
        let first = self.object.map(|object| if number < object { 1.0 } else { 0.0 });
        let tie = ahead.zip(self.distance, |t, best| if t == best { 1.0 } else { 0.0 }) * first;
        let nearer = ahead.zip(self.distance, |t, best| if t < best { 1.0 } else { 0.0 }) + tie;
        Self {
            distance: ahead.where_positive(nearer, self.distance),
            object: Lanes::splat(number).where_positive(nearer, self.object),
            part: part.where_positive(nearer, self.part),
        }
    }

    /// The bits of the rays whose crossings were told in full.
    #[inline(always)]
    fn told(&self) -> u32 {
        self.part.bits(|part| part == TOLD)
    }
}

/// Crossings that were told in full.
type Told = [Option<Hit>; Lanes::COUNT];

/// Four rays that ask for the nearest surfaces.
struct Asking<'a> {
    geometry: &'a Geometry,
    rays: &'a Rays,
    kind: RayKind,
    /// The bits of those that are of interest.
    asked: u32,
}

impl Asking<'_> {
    /// The leaf that is all of an object, where four rays can be asked at once.
    #[inline(always)]
    fn lone(&self, number: u32) -> Option<&Leaf> {
        let leaf = self.geometry.lone(number)?;
        leaf.meets_four().then_some(leaf)
    }

    /// The bits of the rays that may meet an object, where its surface tells that better than its box, and where they
    /// meet it as far as that is known.
    #[inline(always)]
    fn near(&self, number: u32, met: &Met) -> Option<(u32, Lanes)> {
        let leaf = self.geometry.lone(number)?;
        let (near, distance) = leaf.primitive.near_of_four(|| self.inner(leaf), met.distance)?;
        let seen = !leaf.is_limited() && !leaf.hidden.intersects(self.kind);
        Some((near, if seen { distance } else { Lanes::splat(f64::NAN) }))
    }

    /// Asks one more object, if need be for the rays of which `near` gives the bits. What was met stays in registers:
    /// numbers of which only some are written to memory are waited for.
    #[inline(always)]
    fn visit(&self, number: u32, met: Met, told: &mut Told, near: impl FnOnce(&Lanes) -> u32) -> Met {
        if let Some(leaf) = self.lone(number) {
            if leaf.hidden.intersects(self.kind) {
                return met;
            }
            tally::primitives(Lanes::COUNT);
            return match leaf.primitive.nearest_of_four(self.rays, met.distance) {
                Some([distance, part]) => met.with(number, distance, part),
                None => met,
            };
        }
        let mut met = met;
        let mut near = match self.near(number, &met) {
            Some((near, distance)) => {
                let near = near & self.asked;
                let known = near & distance.bits(|t| t > 0.0);
                if known != 0 {
                    tally::primitives(known.count_ones() as usize);
                    met = met.with(number, distance, Lanes::ZERO);
                }
                near & !known
            }
            None => near(&met.distance) & self.asked,
        };
        if near == 0 {
            return met;
        }
        if near.count_ones() > 1 && self.visit_together(near, number, &mut met, told) {
            return met;
        }
        while near != 0 {
            self.visit_alone(near.trailing_zeros() as usize % Lanes::COUNT, number, &mut met, told);
            near &= near - 1;
        }
        met
    }

    /// Asks an object for one ray.
    #[inline(never)]
    fn visit_alone(&self, lane: usize, number: u32, met: &mut Met, told: &mut Told) {
        let parts = self.geometry.parts();
        let best = met.distance.0[lane];
        let range = Range { min: 0.0, max: best.next_up() };
        let member = parts.objects[number as usize].member;
        if let Some(found) = parts.nearest(member, &self.rays.ray(lane), range, self.kind) {
            Self::tell(lane, Hit::new(found, number), met, told);
        }
    }

    /// Asks an object for the rays of which `near` gives the bits; whether they could be asked together.
    #[inline(never)]
    fn visit_together(&self, near: u32, number: u32, met: &mut Met, told: &mut Told) -> bool {
        let parts = self.geometry.parts();
        let Member::Leaf(place) = parts.objects[number as usize].member else { return false };
        let leaf = parts.leaf(place);
        if leaf.is_limited() || leaf.hidden.intersects(self.kind) {
            return false;
        }
        let mut found = [None; Lanes::COUNT];
        if !leaf.primitive.nearest_together(&self.inner(leaf), near, &met.distance, &mut found) {
            return false;
        }
        tally::primitives(near.count_ones() as usize);
        for (lane, crossing) in found.into_iter().enumerate() {
            if let Some(crossing) = crossing {
                Self::tell(lane, Hit { t: crossing.t, crossing, leaf: place, object: number }, met, told);
            }
        }
        true
    }

    /// Keeps a crossing if it is nearer than those before, or as near and of what was declared first.
    #[inline(always)]
    fn tell(lane: usize, hit: Hit, met: &mut Met, told: &mut Told) {
        let (best, object) = (met.distance.0[lane], f64::from(hit.object));
        if hit.t < best || (hit.t == best && object < met.object.0[lane]) {
            told[lane] = Some(hit);
            met.distance.0[lane] = hit.t;
            met.object.0[lane] = object;
            met.part.0[lane] = TOLD;
        }
    }

    /// The rays in a leaf's own space.
    #[inline(always)]
    fn inner(&self, leaf: &Leaf) -> Rays {
        leaf.transform.as_ref().map_or(*self.rays, |transform| self.rays.to_inner(transform))
    }

    /// What a ray meets whose crossing needed no telling in full.
    #[inline(always)]
    fn hit(&self, met: &Met, lane: usize) -> Option<Hit> {
        let t = met.distance.0[lane];
        if t == f64::INFINITY {
            return None;
        }
        let object = met.object.0[lane] as u32;
        let Member::Leaf(leaf) = self.geometry.parts().objects[object as usize].member else { return None };
        Some(Hit { t, crossing: Crossing::new(t, met.part.0[lane] as u32), leaf, object })
    }

    /// Where the ground is as near as what a ray meets, the ground is met.
    #[inline]
    fn settle(&self, lane: usize, ground: Option<Hit>, best: &mut Option<Hit>) {
        if let (Some(on), Some(above)) = (&ground, &best)
            && self.geometry.stands_on(&self.rays.ray(lane), above, on)
        {
            *best = ground;
        }
    }
}

impl Geometry {
    /// Whether the objects that rays of a pencil may meet are few enough to be worth knowing, and were found.
    pub fn within(&self, pencil: &Pencil, within: &mut Within) -> bool {
        widest(
            #[inline(always)]
            || self.bounded_within(pencil, within),
        )
    }

    /// Whether rays of a pencil meet nothing, given the objects that they may meet.
    pub fn meets_nothing(&self, within: &Within) -> bool {
        self.is_bounded() && within.items().is_empty()
    }

    /// Whether all objects have boxes.
    pub fn is_bounded(&self) -> bool {
        self.unbounded().is_empty()
    }

    /// Whether there are so few objects that four rays ask for all of them at once.
    pub fn is_little(&self) -> bool {
        self.all.is_some()
    }

    /// What [`hit`](Self::hit) answers for those of any four rays whose bits are `asked`, all with unit directions: at once
    /// where there is [little](Self::is_little) to ask.
    #[inline(always)]
    pub fn hits_of_four(&self, rays: &Rays, asked: u32, kind: RayKind, hits: &mut Told) {
        if let Some(all) = &self.all {
            let mut near = true;
            for lane in 0..Lanes::COUNT {
                near &= asked >> lane & 1 == 0 || all.holds(rays.ray(lane).origin);
            }
            if near {
                return self.hits(all, rays, asked, kind, 0.0, hits);
            }
        }
        for (lane, hit) in hits.iter_mut().enumerate() {
            if asked >> lane & 1 == 1 {
                *hit = self.hit(&rays.ray(lane), Range::AHEAD, kind);
            }
        }
    }

    /// The bits of those of four ways to lamps that meet nothing which light goes through or is stopped by, from where they
    /// start to their ends, as far as that is told at once.
    #[inline(always)]
    pub fn free_of_four(&self, rays: &Rays, ends: Lanes) -> u32 {
        let Some(all) = &self.all else { return 0 };
        let mut free = (1 << Lanes::COUNT) - 1;
        for &number in self.unbounded() {
            free &= !self.may_stop(number, rays, ends);
        }
        for boxed in all.items() {
            free &= !self.may_stop(boxed.number, rays, ends);
        }
        free
    }

    /// The bits of those of four ways that an object may be in.
    #[inline(always)]
    fn may_stop(&self, number: u32, rays: &Rays, ends: Lanes) -> u32 {
        match self.lone(number) {
            Some(leaf) if leaf.hidden.intersects(RayKind::SHADOW) => 0,
            Some(leaf) if leaf.meets_four() => leaf.primitive.may_stop_four(rays, ends),
            _ => !0,
        }
    }

    /// What [`hit`](Self::hit) answers for those of four rays of a pencil whose bits are `asked`, all with unit directions.
    /// They start where they come from, or no farther ahead than they have `come`.
    pub fn hits(&self, within: &Within, rays: &Rays, asked: u32, kind: RayKind, come: f64, hits: &mut Told) {
        widest(
            #[inline(always)]
            || {
                let asking = Asking { geometry: self, rays, kind, asked };
                let mut met = Met::NOTHING;
                for &number in self.unbounded() {
                    met = asking.visit(number, met, hits, |_| !0);
                }
                let ground = met;
                let told = if ground.told() == 0 { None } else { Some(*hits) };
                let mut four = None;
                for boxed in within.items() {
                    if met.distance.bits(|distance| distance + come < boxed.entry) == 15 {
                        break;
                    }
                    met = asking.visit(boxed.number, met, hits, |ends| {
                        four.get_or_insert_with(|| Four::new(rays, within)).meet(boxed, ends)
                    });
                }
                let full = met.told();
                for lane in 0..Lanes::COUNT {
                    if asked >> lane & 1 == 0 {
                        continue;
                    }
                    if full >> lane & 1 == 0 {
                        hits[lane] = asking.hit(&met, lane);
                    }
                    if ground.distance.0[lane] < f64::INFINITY && ground.object.0[lane] != met.object.0[lane]
                    {
                        let told = told.filter(|_| ground.told() >> lane & 1 == 1);
                        let on = told.map_or_else(|| asking.hit(&ground, lane), |told| told[lane]);
                        asking.settle(lane, on, &mut hits[lane]);
                    }
                }
            },
        );
    }
}
