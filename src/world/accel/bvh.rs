//! A tree of boxes, eight to a node, with runs of items at its leaves.
//!
//! Boxes are single precision, relative to the middle and size of the whole and rounded outward;
//! rays are moved up to the whole box first. So neither a far camera nor a scene far from the
//! origin loosens the tests, and no item that double precision would find is missed.

use std::ops::Range as Span;

use smallvec::SmallVec;

use super::build::{self, Around, Item};
use super::linear::Slabs;
use super::node::{Lanes, NEAR, Node, Probe, SLACK, WIDTH};
use super::{Hull, Points};
use crate::math::{Bounds, DVec3, tally};
use crate::world::ray::{Range, Ray};

/// Marks a child that is a run of items.
pub(super) const LEAF: u32 = 1 << 31;

/// Where in a leaf's mark the length of its run stands, less one; its first item stands below.
const LENGTH: u32 = 28;

/// The longest run of a leaf.
pub(super) const LONGEST_RUN: usize = 8;

/// Bound on the rounding errors of double precision arithmetic on points.
const BLUR: f64 = 8.0 * f64::EPSILON;

/// Makes up for rounding in single precision, also that of the distances of boxes.
const UP: f32 = 1.0 + 2.0 * SLACK;

/// Children that wait on an ordinary walk; what is beyond goes to the heap.
const STACK: usize = 24;

/// A tree over bounded items.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    whole: Bounds,
    center: DVec3,
    scale: f64,
    /// What rounding in double precision does to a point near the boxes, in their space.
    blur: f32,
}

/// A ray on its way through the boxes.
struct Way {
    probe: Probe,
    place: Measure,
}

/// What goes through the boxes: a ray, or several together.
pub(super) trait Traveller {
    /// A distance in the space of the boxes, or a little more.
    fn end(&self, t: f64) -> f32;

    /// Entry distances, none negative, and the bits of the boxes met before `far`.
    fn test(&self, node: &Node, far: f32) -> (Lanes, u32);
}

impl Traveller for Way {
    #[inline(always)]
    fn end(&self, t: f64) -> f32 {
        self.place.end(t)
    }

    #[inline(always)]
    fn test(&self, node: &Node, far: f32) -> (Lanes, u32) {
        self.probe.test(node, far)
    }
}

/// How distances are told in the space of the boxes.
#[derive(Clone, Copy)]
pub(super) struct Measure {
    /// What is zero there.
    pub(super) start: f64,
    /// Distances beyond are so many times larger.
    pub(super) scale: f64,
}

impl Measure {
    /// A distance, or a little more.
    #[inline(always)]
    pub(super) fn end(self, t: f64) -> f32 {
        ((t + t.abs() * BLUR - self.start) * self.scale) as f32 * UP + f32::MIN_POSITIVE
    }
}

impl Bvh {
    /// Takes items, all bounded, and asks about them by the numbers they have. They are gone through twice.
    pub fn new<I: IntoIterator<Item = (Bounds, u32), IntoIter: Clone>>(items: I) -> Self {
        let (mut bvh, order) = Self::with_runs(items, 1);
        let leaves = bvh.nodes.iter_mut().flat_map(|node| &mut node.children);
        for child in leaves.filter(|child| **child & LEAF != 0 && **child != u32::MAX) {
            *child = LEAF | order[(*child & !LEAF) as usize];
        }
        bvh
    }

    /// Keeps up to `longest` items together, at most 8. Answers also the numbers of
    /// the items in the order in which the tree counts them from then on. The items are gone through twice.
    pub fn with_runs<I: IntoIterator<Item = (Bounds, u32), IntoIter: Clone>>(
        items: I,
        longest: usize,
    ) -> (Self, Vec<u32>) {
        let items = items.into_iter();
        let (mut whole, mut count) = (Bounds::EMPTY, 0);
        for (bounds, _) in items.clone() {
            whole = whole.union(bounds);
            count += 1;
        }
        let mut bvh = Self::empty(whole);
        let mut own = Vec::with_capacity(count);
        own.extend(items.map(|(bounds, number)| bvh.item(bounds, number)));
        if !own.is_empty() {
            bvh.nodes = build::tree(&mut own, longest.min(LONGEST_RUN), &node);
        }
        (bvh, own.into_iter().map(|item| item.number).collect())
    }

    /// The box around all items; empty without any.
    pub fn bounds(&self) -> Bounds {
        self.whole
    }

    /// Without items, but with room for them in a box.
    fn empty(whole: Bounds) -> Self {
        let scale = 2.0 / whole.size().max_element();
        let mut bvh = Self {
            nodes: Vec::new(),
            whole,
            center: if whole.is_empty() { DVec3::ZERO } else { whole.center() },
            scale: if scale.is_finite() { scale } else { 1.0 },
            blur: 0.0,
        };
        // A point is no farther from the origin than from the middle and the middle from there.
        bvh.blur = ((1.0 + NEAR + 2.0 * bvh.center.abs().max_element() * bvh.scale) * BLUR) as f32;
        bvh
    }

    /// An item with its box in the space of the boxes, rounded outward.
    fn item(&self, bounds: Bounds, number: u32) -> Item {
        let (low, high) = (self.inner(bounds.min).to_array(), self.inner(bounds.max).to_array());
        Item { low: low.map(rounded_down).into(), high: high.map(rounded_up).into(), number }
    }

    /// A point in the space of the boxes.
    pub(super) fn inner(&self, point: DVec3) -> DVec3 {
        (point - self.center) * self.scale
    }

    /// What rounding in double precision does to a point near the boxes, in their space.
    pub(super) fn blur(&self) -> f32 {
        self.blur
    }

    /// The nodes; the first is the root.
    #[inline(always)]
    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Where the boxes' space has its origin, and how much larger it is.
    pub(super) fn place(&self) -> (DVec3, f64) {
        (self.center, self.scale)
    }

    /// See [`Accel::along`](super::Accel::along).
    #[inline(always)]
    pub fn along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> f64) {
        let Some(way) = self.way(ray, range) else { return };
        self.search(
            &way,
            range.max,
            #[inline(always)]
            |leaf| visit(leaf & !LEAF),
        );
    }

    /// As [`Bvh::along`], for runs of items.
    #[inline(always)]
    pub fn runs_along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(Span<usize>) -> f64) {
        let Some(way) = self.way(ray, range) else { return };
        self.search(
            &way,
            range.max,
            #[inline(always)]
            |leaf| visit(run(leaf)),
        );
    }

    /// Calls back with the leaves that a traveller may meet, as [`Accel::along`](super::Accel::along) does.
    #[inline(always)]
    pub(super) fn search(&self, way: &impl Traveller, end: f64, mut visit: impl FnMut(u32) -> f64) {
        let mut far = way.end(end);
        let (mut waiting, mut count, mut more) = ([Waiting(0); STACK], 0, Vec::new());
        let mut next = 0;
        loop {
            if next & LEAF != 0 {
                let end = visit(next);
                if end == f64::NEG_INFINITY {
                    return;
                }
                far = way.end(end);
            } else {
                let node = &self.nodes[next as usize];
                tally::boxes(WIDTH);
                let (near, mut met) = way.test(node, far);
                if met != 0 {
                    let mut nearest = take(&near, node, &mut met);
                    let bottom = count;
                    while met != 0 {
                        let other = take(&near, node, &mut met);
                        let farther = other.max(nearest);
                        nearest = other.min(nearest);
                        if count < STACK {
                            waiting[count] = farther;
                            count += 1;
                        } else {
                            more.push(farther);
                        }
                    }
                    if count > bottom + 1 {
                        far_first(&mut waiting[bottom..count]);
                    }
                    next = nearest.child();
                    continue;
                }
            }
            loop {
                let last = if more.is_empty() {
                    if count == 0 {
                        return;
                    }
                    count -= 1;
                    waiting[count]
                } else {
                    more.pop().unwrap_or(Waiting::NEVER)
                };
                if last.distance() <= far {
                    next = last.child();
                    break;
                }
            }
        }
    }

    /// The ray in the space of the boxes; `None` where it is none, or surely misses all.
    #[inline(always)]
    fn way(&self, ray: &Ray, range: Range) -> Option<Way> {
        if self.nodes.is_empty() {
            return None;
        }
        let probe = Probe::new(self.inner(ray.at(range.min)), ray.direction, self.blur);
        if probe.is_tame() {
            return Some(Way { probe, place: Measure { start: range.min, scale: self.scale } });
        }
        self.moved_up(ray, range)
    }

    /// The way of a ray from far off, from the border of the whole on, where digits that are lost before
    /// don't matter, or of one whose direction is very long or short.
    #[cold]
    fn moved_up(&self, ray: &Ray, range: Range) -> Option<Way> {
        let start = Slabs::new(ray).entry(&self.whole, range)?.max(range.min);
        let span = ray.direction.abs().max_element();
        let blur = self.center.abs().max(ray.origin.abs()).max_element() * self.scale;
        let blur = ((1.0 + 2.0 * blur) * BLUR) as f32;
        let probe = Probe::new(self.inner(ray.at(start)), ray.direction / span, blur);
        let place = Measure { start, scale: self.scale * span };
        probe.is_sound().then_some(Way { probe, place })
    }

    /// See [`Accel::any_touching`](super::Accel::any_touching).
    pub fn any_touching(&self, hull: &Hull, mut test: impl FnMut(u32) -> bool) -> bool {
        if !hull.meets(&self.whole) {
            return false;
        }
        let points: Points = hull.points().iter().map(|&point| self.inner(point)).collect();
        let hull = Hull::new(&points);
        let Bounds { min, max } = hull.around();
        let [low, high] = [min.to_array().map(rounded_down), max.to_array().map(rounded_up)];
        let touched = |node: &Node| {
            let near = node.around(low, high);
            let is_touched = |lane: usize| near & 1 << lane != 0 && hull.meets(&node.bounds(lane));
            (0..WIDTH).fold(0, |mask, lane| mask | u32::from(is_touched(lane)) << lane)
        };
        self.any_below(touched, |leaf| test(leaf & !LEAF))
    }

    /// See [`Accel::any_around`](super::Accel::any_around).
    #[inline(always)]
    pub fn any_around(&self, point: DVec3, mut test: impl FnMut(u32) -> bool) -> bool {
        self.any_leaf_around(
            point,
            #[inline(always)]
            |leaf| test(leaf & !LEAF),
        )
    }

    /// As [`Bvh::any_around`], for runs of items.
    #[inline(always)]
    pub fn any_run_around(&self, point: DVec3, mut test: impl FnMut(Span<usize>) -> bool) -> bool {
        self.any_leaf_around(
            point,
            #[inline(always)]
            |leaf| test(run(leaf)),
        )
    }

    #[inline(always)]
    fn any_leaf_around(&self, point: DVec3, test: impl FnMut(u32) -> bool) -> bool {
        if !self.whole.contains(point) {
            return false;
        }
        let point = self.inner(point);
        let low = point.to_array().map(rounded_down);
        let high = point.to_array().map(rounded_up);
        self.any_below(|node| node.around(low, high), test)
    }

    /// Whether `test` holds for any leaf below the children of which `near` gives the bits.
    #[inline(always)]
    fn any_below(&self, near: impl Fn(&Node) -> u32, mut test: impl FnMut(u32) -> bool) -> bool {
        let mut stack: SmallVec<[u32; STACK]> = SmallVec::new();
        stack.push(0);
        while let Some(child) = stack.pop() {
            if child & LEAF != 0 {
                if test(child) {
                    return true;
                }
                continue;
            }
            let node = &self.nodes[child as usize];
            let mut near = near(node);
            while near != 0 {
                stack.push(node.children[near.trailing_zeros() as usize % WIDTH]);
                near &= near - 1;
            }
        }
        false
    }
}

/// The node of up to [`WIDTH`] children and their boxes.
fn node(children: &[(Around, build::Child)]) -> Node {
    let mut node = Node::EMPTY;
    for (lane, (bounds, child)) in children.iter().enumerate() {
        let child = match *child {
            build::Child::Node(number) => number,
            build::Child::Run { first, length } => LEAF | (length - 1) << LENGTH | first,
        };
        node.set(lane, child, bounds.low.to_array(), bounds.high.to_array());
    }
    node
}

/// The first of the children met, and its distance.
#[inline(always)]
fn take(near: &[f32; WIDTH], node: &Node, met: &mut u32) -> Waiting {
    let lane = met.trailing_zeros() as usize % WIDTH;
    *met &= met.wrapping_sub(1);
    Waiting::new(near[lane], node.children[lane])
}

/// The item of a leaf that is no run.
#[inline(always)]
pub(super) fn item(child: u32) -> Option<u32> {
    (child & LEAF != 0).then_some(child & !LEAF)
}

/// The items of a leaf.
#[inline(always)]
pub(super) fn run(leaf: u32) -> Span<usize> {
    let first = (leaf & ((1 << LENGTH) - 1)) as usize;
    first..first + 1 + (leaf >> LENGTH & (LONGEST_RUN as u32 - 1)) as usize
}

/// Orders a few children so that the nearest is taken from the stack first.
#[inline(always)]
fn far_first(children: &mut [Waiting]) {
    for end in 1..children.len() {
        let mut place = end;
        while place > 0 && children[place - 1] < children[place] {
            children.swap(place - 1, place);
            place -= 1;
        }
    }
}

/// A child and the distance of its box, ordered by the latter.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Waiting(u64);

impl Waiting {
    /// What is too far for any ray.
    const NEVER: Self = Self(u64::MAX);

    /// The distance is not negative, so its bits have the order of the numbers.
    #[inline(always)]
    fn new(distance: f32, child: u32) -> Self {
        Self(u64::from(distance.to_bits()) << 32 | u64::from(child))
    }

    #[inline(always)]
    fn distance(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    #[inline(always)]
    fn child(self) -> u32 {
        self.0 as u32
    }
}

/// The greatest single precision number that is not above `x`.
#[inline(always)]
fn rounded_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

/// The least single precision number that is not below `x`.
#[inline(always)]
fn rounded_up(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) < x { y.next_up() } else { y }
}
