//! Questions to the geometry of a world: what does a ray meet, what is in the way of light, what
//! is a point inside of.

use smallvec::SmallVec;

use super::accel::{Accel, Bvh, Hull, Pencil, Slabs, Within};
use super::csg::Found;
use super::object::{Leaf, LeafFlags, Member, RayKind};
use super::outline::Caster;
use super::parts::{Object, Parts};
use super::ray::{Range, Ray};
use super::screen::{SHUT, Screen, UNKNOWN};
use super::shape::{Crossing, Remark, Shape};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec3};
use crate::options::Accelerator;

/// Up to this many objects that may throw a shadow are kept for the many rays of a bundle.
const FEW: usize = 12;

/// Lamps that are nearer to a box, in parts of its size, may touch what is in it.
const ASIDE: f64 = 1e-6;

/// The only objects that may be in the way of light.
#[derive(Clone, Copy, Debug)]
pub enum Among<'a> {
    /// Some of these.
    Screens(&'a [Screen]),
    /// These, by number, all near the way.
    Near(&'a [u32]),
}

impl Among<'_> {
    /// Whether there are none.
    #[inline]
    pub fn is_empty(&self) -> bool {
        match self {
            Self::Screens(screens) => screens.is_empty(),
            Self::Near(numbers) => numbers.is_empty(),
        }
    }
}

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Distance along the ray.
    pub t: f64,
    /// The shape's own account of it.
    pub crossing: Crossing,
    /// Number of the leaf.
    pub leaf: u32,
    /// Number of the object the leaf is part of.
    pub object: u32,
}

impl Hit {
    #[inline]
    pub(super) fn new(found: Found, object: u32) -> Self {
        Self { t: found.t(), crossing: found.crossing, leaf: found.leaf, object }
    }
}

/// The nearest surface of the objects that a ray has asked so far.
struct Nearest<'a> {
    parts: &'a Parts,
    ray: &'a Ray,
    /// Ends just behind the best hit, for the sake of ties.
    range: Range,
    kind: RayKind,
    best: Option<Hit>,
}

impl Nearest<'_> {
    /// Asks one more; answers with the end of what is of interest.
    #[inline(always)]
    fn visit(&mut self, number: u32) -> f64 {
        let member = self.parts.objects[number as usize].member;
        if let Some(found) = self.parts.nearest(member, self.ray, self.range, self.kind) {
            let t = found.t();
            if self.best.is_none_or(|best| t < best.t || (t == best.t && number < best.object)) {
                self.best = Some(Hit::new(found, number));
                self.range.max = t.next_up();
            }
        }
        self.range.max
    }
}

/// The objects of a world, ready to be asked.
#[derive(Debug)]
pub struct Geometry {
    parts: Parts,
    bounded: Accel,
    /// The same for rays that travel together, where those that travel alone need no tree.
    few: Option<Bvh>,
    /// All of them, where they are so few.
    pub(super) all: Option<Within>,
    unbounded: Vec<u32>,
    /// Bounded objects turned inside out: they contain what is outside of their boxes.
    inverted: Vec<u32>,
}

impl Geometry {
    /// What rays have found out about leaves, for their authors.
    pub fn remarks(&self) -> impl Iterator<Item = (&Leaf, Remark)> {
        self.parts().leaves.iter().filter_map(|leaf| Some((leaf, leaf.primitive.remark()?)))
    }

    /// Makes the objects of `parts` searchable.
    pub fn new(parts: Parts, accelerator: Accelerator) -> Self {
        let (mut unbounded, mut inverted) = (Vec::new(), Vec::new());
        let together = || (0..).zip(&parts.objects).filter(|(_, object)| !object.apart);
        for (number, object) in together() {
            let extent = parts.extent(object.member);
            if extent.bounds.is_finite() {
                inverted.extend(extent.beyond.then_some(number));
            } else if !extent.bounds.is_empty() {
                unbounded.push(number);
            }
        }
        let boxes = together().map(|(number, object)| (parts.extent(object.member).bounds, number));
        let boxes = boxes.filter(|(bounds, _)| bounds.is_finite());
        let bounded = Accel::new(boxes.clone(), accelerator);
        let plain = accelerator == Accelerator::Auto && matches!(bounded, Accel::Linear(_));
        let few = plain.then(|| Bvh::new(boxes));
        let all = few.as_ref().map(Bvh::all);
        Self { bounded, few, all, unbounded, inverted, parts }
    }

    /// The parts by number.
    #[inline]
    pub fn parts(&self) -> &Parts {
        &self.parts
    }

    /// Whether the objects with boxes that rays of a pencil may meet are few, and were found.
    #[inline(always)]
    pub(super) fn bounded_within(&self, pencil: &Pencil, within: &mut Within) -> bool {
        match &self.few {
            Some(few) => few.within(pencil, within),
            None => self.bounded.within(pencil, within),
        }
    }

    /// What has none, by number.
    #[inline]
    pub(super) fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }

    /// The box around an object.
    #[inline]
    pub fn bounds(&self, object: u32) -> Bounds {
        self.parts.extent(self.parts.objects[object as usize].member).bounds
    }

    /// The nearest surface in `range` that such rays see. Of several at exactly the same distance the
    /// object declared first is seen (docs/spec/primitives.md 7.2); but where what has no bounds, such
    /// as the ground, is at the same distance as far as rounding tells, that is seen (8.4).
    pub fn hit(&self, ray: &Ray, range: Range, kind: RayKind) -> Option<Hit> {
        let mut nearest = Nearest { parts: &self.parts, ray, range, kind, best: None };
        let mut ground = None;
        widest(
            #[inline(always)]
            || {
                if !self.unbounded.is_empty() {
                    for &number in &self.unbounded {
                        nearest.visit(number);
                    }
                    ground = nearest.best;
                }
                self.bounded.along(
                    ray,
                    nearest.range,
                    #[inline(always)]
                    |number| nearest.visit(number),
                );
            },
        );
        match (ground, nearest.best) {
            (Some(ground), Some(best)) if self.stands_on(ray, &best, &ground) => Some(ground),
            (_, best) => best,
        }
    }

    /// Whether a hit is at the same distance as one of the ground, as far as rounding tells.
    #[inline]
    pub(super) fn stands_on(&self, ray: &Ray, best: &Hit, ground: &Hit) -> bool {
        best.object != ground.object
            && self.parts.coincide(ray, ground.leaf, &ground.crossing, ground.t - best.t)
    }

    /// What stands between a point and a light: an opaque object; if there is none, `through`
    /// holds the transparent surfaces, the nearest first, coincident ones once. The object that was in
    /// the way of the `last` ray is asked first.
    pub fn occluders(
        &self,
        ray: &Ray,
        range: Range,
        last: Option<u32>,
        through: &mut Vec<Hit>,
    ) -> Option<u32> {
        through.clear();
        let last = last.filter(|&number| self.parts.objects[number as usize].opaque);
        if last.is_some_and(|number| self.is_blocked_by(number, ray, range)) {
            return last;
        }
        let mut blocker = None;
        widest(
            #[inline(always)]
            || {
                self.objects_along(
                    ray,
                    range,
                    #[inline(always)]
                    |number, object| {
                        if last == Some(number) || !self.occluders_of(object, number, ray, range, through) {
                            return range.max;
                        }
                        blocker = Some(number);
                        f64::NEG_INFINITY
                    },
                );
            },
        );
        self.sort_occluders(ray, through);
        blocker
    }

    /// Whether an object, opaque all over, is in the way of light.
    fn is_blocked_by(&self, number: u32, ray: &Ray, range: Range) -> bool {
        self.occluders_of(&self.parts.objects[number as usize], number, ray, range, &mut Vec::new())
    }

    /// Finds the objects that may stand in the way of light on straight ways inside of `hull`, most of which
    /// lead to its first point; tells whether they are few enough to be worth knowing, and all in `found`.
    pub fn between(&self, hull: &Hull, found: &mut Vec<Screen>) -> bool {
        found.clear();
        let eye = hull.points()[0];
        let mut add = |number: u32| {
            if self.is_near(number, hull) {
                found.extend(Screen::new(number, &self.parts.objects[number as usize], &self.parts, eye));
            }
            found.len() > FEW
        };
        let many = self.unbounded.iter().any(|&number| add(number)) || self.bounded.any_touching(hull, add);
        !many
    }

    /// Whether no surface is in `hull`, as far as boxes tell.
    pub fn is_free(&self, hull: &Hull) -> bool {
        let near = |number| self.is_near(number, hull);
        !self.unbounded.iter().copied().any(near) && !self.bounded.any_touching(hull, near)
    }

    /// Whether an object whose box meets the hull may have a surface there.
    fn is_near(&self, number: u32, hull: &Hull) -> bool {
        !self.is_apart_from(number, hull.points())
    }

    /// What is known of the shadows that an object throws; `None` where nothing is.
    pub fn caster(&self, number: u32) -> Option<Caster> {
        Caster::new(&self.parts.objects[number as usize], &self.parts)
    }

    /// The leaf that is all of an object, where it is no compound.
    #[inline(always)]
    pub(super) fn lone(&self, number: u32) -> Option<&Leaf> {
        match self.parts.objects[number as usize].member {
            Member::Leaf(leaf) => Some(self.parts.leaf(leaf)),
            Member::Group(_) => None,
        }
    }

    /// Whether it is known that no straight way between any two of the points meets an object.
    pub fn is_apart_from(&self, number: u32, points: &[DVec3]) -> bool {
        self.lone(number).is_some_and(|leaf| leaf.is_apart_from(points))
    }

    /// Whether a ray that leaves an object towards the outside won't meet it again.
    pub fn is_left_for_good(&self, number: u32) -> bool {
        let turned = LeafFlags::INVERTED | LeafFlags::REVERSED;
        self.lone(number).is_some_and(|leaf| leaf.is_convex() && !leaf.flags.intersects(turned))
    }

    /// The leaf of an object that is a convex solid through whose surface light passes unchanged.
    pub fn shell(&self, number: u32) -> Option<&Leaf> {
        let leaf = self.lone(number)?;
        let clear = leaf.flags.contains(LeafFlags::CLEAR) && !leaf.flags.contains(LeafFlags::OPAQUE);
        (clear && leaf.is_convex() && !leaf.hidden.intersects(RayKind::SHADOW)).then_some(leaf)
    }

    /// Where a ray crosses the surface of a [`shell`](Self::shell), if it does so once.
    pub fn way_out(&self, number: u32, ray: &Ray, range: Range) -> Option<f64> {
        let leaf = self.shell(number)?;
        match leaf.primitive.convex(&leaf.asked(ray))??.ends(range) {
            [Some(end), None] | [None, Some(end)] => Some(end.t),
            _ => None,
        }
    }

    /// Whether the points of any line that an object hides from a lamp are next to each other: it is
    /// convex, opaque, and not around the lamp.
    pub fn hides_a_stretch(&self, number: u32, lamp: DVec3) -> bool {
        let Some(leaf) = self.lone(number) else { return false };
        let Bounds { min, max } = leaf.extent().bounds;
        let room = ASIDE * (max - min);
        self.parts.objects[number as usize].opaque
            && leaf.is_convex()
            && !Bounds { min: min - room, max: max + room }.contains(lamp)
    }

    /// The same as [`occluders`](Self::occluders) where it is known that only objects of `among` may
    /// be in the way.
    pub fn occluders_among(
        &self,
        among: Among,
        ray: &Ray,
        range: Range,
        through: &mut Vec<Hit>,
    ) -> Option<u32> {
        through.clear();
        if range.max <= 0.0 {
            return None;
        }
        let mut is_shut = |number: u32| {
            let object = &self.parts.objects[number as usize];
            // A lone primitive that is soon asked needs no look at its box.
            let plain = self.lone(number).is_some_and(|leaf| leaf.primitive.is_soon_asked());
            let near = || {
                let bounds = &self.parts.extent(object.member).bounds;
                !bounds.is_finite() || Slabs::new(ray).meet(bounds, range)
            };
            (plain || near()) && self.occluders_of(object, number, ray, range, through)
        };
        let blocker = match among {
            Among::Near(numbers) => {
                let mut blocker = None;
                // A loop: what is asked is compiled together with it.
                for &number in numbers {
                    if is_shut(number) {
                        blocker = Some(number);
                        break;
                    }
                }
                blocker
            }
            Among::Screens(screens) => {
                let way = (ray.direction * range.max).to_array();
                let blocking = screens.iter().find(|screen| match screen.from(ray.origin).verdict(way) {
                    UNKNOWN => is_shut(screen.object),
                    verdict => verdict == SHUT,
                });
                blocking.map(|screen| screen.object)
            }
        };
        self.sort_occluders(ray, through);
        blocker
    }

    /// The nearest first, coincident ones once.
    #[inline]
    fn sort_occluders(&self, ray: &Ray, through: &mut Vec<Hit>) {
        let order =
            |a: &Hit, b: &Hit| a.t.total_cmp(&b.t).then(a.object.cmp(&b.object)).then(b.leaf.cmp(&a.leaf));
        let coincide =
            |next: &Hit, kept: &Hit| self.parts.coincide(ray, kept.leaf, &kept.crossing, next.t - kept.t);
        match &mut through[..] {
            [] | [_] => {}
            [first, second] => {
                if order(second, first).is_lt() {
                    std::mem::swap(first, second);
                }
                if coincide(second, first) {
                    through.pop();
                }
            }
            _ => {
                through.sort_unstable_by(order);
                through.dedup_by(|next, kept| coincide(next, kept));
            }
        }
    }

    /// Whether an opaque part of an object is in the way.
    #[inline(always)]
    fn occluders_of(
        &self,
        object: &Object,
        number: u32,
        ray: &Ray,
        range: Range,
        through: &mut Vec<Hit>,
    ) -> bool {
        if let Member::Leaf(lone) = object.member {
            let leaf = self.parts.leaf(lone);
            if leaf.hidden.intersects(RayKind::SHADOW) {
                return false;
            }
            if object.opaque && !leaf.is_limited() {
                return leaf.primitive.occludes(&leaf.asked(ray), range);
            }
            // No other member has a say about where a lone solid begins and ends.
            if leaf.is_convex()
                && !leaf.flags.contains(LeafFlags::OPAQUE)
                && let Some(stretch) = leaf.primitive.convex(&leaf.asked(ray))
            {
                // Loops: what is given to adapters is not compiled together with what is around it.
                if let Some(stretch) = stretch {
                    for crossing in stretch.ends(range).into_iter().flatten() {
                        through.push(Hit { t: crossing.t, crossing, leaf: lone, object: number });
                    }
                }
                return false;
            }
            if !leaf.is_limited() && leaf.primitive.is_flat() {
                let Some(crossing) = leaf.primitive.nearest(&leaf.asked(ray), range) else { return false };
                let opaque = leaf.flags.contains(LeafFlags::OPAQUE);
                if !opaque {
                    through.push(Hit { t: crossing.t, crossing, leaf: lone, object: number });
                }
                return opaque;
            }
        }
        if object.opaque {
            return self.parts.occludes(object.member, ray, range, RayKind::SHADOW);
        }
        self.parts.surface_along(object.member, ray, range, RayKind::SHADOW, |found| {
            let opaque = self.parts.leaf(found.leaf).flags.contains(LeafFlags::OPAQUE);
            if !opaque {
                through.push(Hit::new(found, number));
            }
            opaque
        })
    }

    /// How far a single object is, whoever it is hidden from.
    pub fn object_distance(&self, object: u32, ray: &Ray, range: Range) -> Option<f64> {
        let member = self.parts.objects[object as usize].member;
        self.parts.nearest(member, ray, range, RayKind::empty()).map(|found| found.t())
    }

    /// The objects that contain `point`, in the order of the text.
    pub fn containers(&self, point: DVec3) -> SmallVec<[u32; 4]> {
        let contains = |&number: &u32| self.parts.inside(self.parts.objects[number as usize].member, point);
        let everywhere = self.unbounded.iter().chain(&self.inverted);
        let mut containers: SmallVec<[u32; 4]> = everywhere.copied().filter(contains).collect();
        self.bounded.any_around(point, |number| {
            if contains(&number) {
                containers.push(number);
            }
            false
        });
        containers.sort_unstable();
        containers.dedup();
        containers
    }

    /// The objects that a ray from `point` starts in: those of which it is in the box as well.
    pub fn surroundings(&self, point: DVec3) -> SmallVec<[u32; 4]> {
        let boxed = self.unbounded.is_empty() && self.inverted.is_empty();
        if boxed && !self.bounded.any_around(point, |_| true) {
            return SmallVec::new();
        }
        let mut containers = self.containers(point);
        containers.retain(|&mut number| {
            let object = &self.parts.objects[number as usize];
            let extent = self.parts.extent(object.member);
            !extent.beyond || object.surrounds || extent.bounds.contains(point)
        });
        containers
    }

    /// What holds whether points that these hold are inside any object: 1, 0 or both.
    pub fn inside_along(&self, point: &[Band; 3]) -> Band {
        let inside = self.parts.objects.iter().map(|object| self.parts.inside_along(object.member, point));
        inside.reduce(Band::or).unwrap_or(Band::constant(0.0))
    }

    #[inline(always)]
    fn objects_along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32, &Object) -> f64) {
        let mut end = range.max;
        for &number in &self.unbounded {
            end = visit(number, &self.parts.objects[number as usize]);
            if end == f64::NEG_INFINITY {
                return;
            }
        }
        self.bounded.along(
            ray,
            Range { min: range.min, max: end },
            #[inline(always)]
            |number| visit(number, &self.parts.objects[number as usize]),
        );
    }
}
