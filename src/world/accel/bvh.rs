//! A tree of boxes, eight to a node, with runs of items at its leaves.
//!
//! Boxes are single precision, relative to the middle and size of the whole and rounded outward;
//! rays are moved up to the whole box first. So neither a far camera nor a scene far from the
//! origin loosens the tests, and no item that double precision would find is missed.

use std::ops::Range as Span;

use glam::{BVec4A, Vec4};
use smallvec::SmallVec;

use super::Hull;
use super::build::{self, Item};
use super::linear::Slabs;
use crate::math::{Bounds, DVec3};
use crate::world::ray::{Range, Ray};

/// Children of a node.
pub(super) const WIDTH: usize = 8;

/// Marks a child that is a run of items.
const LEAF: u32 = 1 << 31;

/// Where in a leaf's mark the length of its run stands, less one; its first item stands below.
const LENGTH: u32 = 28;

/// The longest run of a leaf.
pub(super) const LONGEST_RUN: usize = 8;

/// Bound on the rounding errors of single precision tests, relative to the terms of each.
const SLACK: f32 = 8.0 * f32::EPSILON;

/// Bound on the rounding errors of double precision arithmetic on points.
const BLUR: f64 = 8.0 * f64::EPSILON;

/// Directions are kept away from zero, so that no slab's distance is 0 · ∞.
const LEAST_DIRECTION: f32 = 1e-30;

/// Deepest stack seen on ordinary scenes; deeper ones go to the heap.
const STACK: usize = 64;

/// A tree over bounded items.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    whole: Bounds,
    center: DVec3,
    scale: f64,
}

/// One number of each child of a node, side by side.
type Lanes = [f32; WIDTH];

/// Eight boxes side by side; missing children have empty ones.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct Node {
    /// The low faces along x, y and z, then the high ones.
    faces: [Lanes; 6],
    children: [u32; WIDTH],
}

impl Node {
    /// No children yet.
    pub(super) const EMPTY: Self = {
        let (low, high) = ([f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]);
        Self { faces: [low, low, low, high, high, high], children: [u32::MAX; WIDTH] }
    };

    /// The same node in a tree whose numbers start at `offset`.
    pub(super) fn moved(mut self, offset: u32) -> Self {
        for child in self.children.iter_mut().filter(|child| **child & LEAF == 0) {
            *child += offset;
        }
        self
    }
}

impl Bvh {
    /// Takes items, all bounded, and asks about them by the numbers they have.
    pub fn new(items: Vec<(Bounds, u32)>) -> Self {
        let (mut bvh, order) = Self::with_runs(items, 1);
        let leaves = bvh.nodes.iter_mut().flat_map(|node| &mut node.children);
        for child in leaves.filter(|child| **child & LEAF != 0 && **child != u32::MAX) {
            *child = LEAF | order[(*child & !LEAF) as usize];
        }
        bvh
    }

    /// Keeps up to `longest` items together, at most 8. Answers also the numbers of
    /// the items in the order in which the tree counts them from then on.
    pub fn with_runs(items: Vec<(Bounds, u32)>, longest: usize) -> (Self, Vec<u32>) {
        let whole = items.iter().fold(Bounds::EMPTY, |all, (bounds, _)| all.union(*bounds));
        let scale = 2.0 / whole.size().max_element();
        let mut bvh = Self {
            nodes: Vec::new(),
            whole,
            center: if items.is_empty() { DVec3::ZERO } else { whole.center() },
            scale: if scale.is_finite() { scale } else { 1.0 },
        };
        let mut items: Vec<Item> = items.into_iter().map(Item::new).collect();
        if !items.is_empty() {
            bvh.nodes = build::tree(&mut items, longest.min(LONGEST_RUN), &|children| bvh.node(children));
        }
        (bvh, items.into_iter().map(|item| item.number).collect())
    }

    /// The node of up to [`WIDTH`] children and their boxes.
    fn node(&self, children: &[(Bounds, build::Child)]) -> Node {
        let mut node = Node::EMPTY;
        for (lane, (bounds, child)) in children.iter().enumerate() {
            let (low, high) = (self.inner(bounds.min), self.inner(bounds.max));
            node.children[lane] = match *child {
                build::Child::Node(number) => number,
                build::Child::Run { first, length } => LEAF | (length - 1) << LENGTH | first,
            };
            for axis in 0..3 {
                node.faces[axis][lane] = rounded_down(low[axis]);
                node.faces[axis + 3][lane] = rounded_up(high[axis]);
            }
        }
        node
    }

    /// A point in the space of the boxes.
    fn inner(&self, point: DVec3) -> DVec3 {
        (point - self.center) * self.scale
    }

    /// See [`Accel::along`](super::Accel::along).
    #[inline(always)]
    pub fn along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> f64) {
        self.search(
            ray,
            range,
            #[inline(always)]
            |leaf| visit(leaf & !LEAF),
        );
    }

    /// As [`Bvh::along`], for runs of items.
    #[inline(always)]
    pub fn runs_along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(Span<usize>) -> f64) {
        self.search(
            ray,
            range,
            #[inline(always)]
            |leaf| visit(run(leaf)),
        );
    }

    #[inline(always)]
    fn search(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> f64) {
        let slabs = Slabs::new(ray);
        let Some(entry) = slabs.entry(&self.whole, range).filter(|_| !self.nodes.is_empty()) else {
            return;
        };
        let start = entry.max(range.min);
        // What rounding in double precision did to the origin, seen in the space of the boxes.
        let blur = 1.0 + (ray.origin.abs().max_element() + self.center.abs().max_element()) * self.scale;
        let stretch = ray.direction.abs().max_element();
        let probe = Probe::new(self.inner(ray.at(start)), ray.direction / stretch, (blur * BLUR) as f32);
        if !probe.is_sound() {
            return;
        }
        // Distances beyond `start`, in the space of the boxes.
        let scale = self.scale * stretch;
        let inner = |t: f64| rounded_up((t + t.abs() * BLUR - start) * scale);
        let mut far = inner(range.max);
        let mut stack: SmallVec<[Waiting; STACK]> = SmallVec::new();
        let mut next = Waiting::new(0.0, 0);
        loop {
            let child = next.child();
            if child & LEAF != 0 {
                let end = visit(child);
                if end == f64::NEG_INFINITY {
                    return;
                }
                far = inner(end);
            } else {
                let node = &self.nodes[child as usize];
                let (near, mut met) = probe.test(node, far);
                let mut take = || {
                    let lane = (met.trailing_zeros() as usize) % WIDTH;
                    let some = met != 0;
                    met &= met.wrapping_sub(1);
                    some.then(
                        #[inline(always)]
                        || Waiting::new(near[lane], node.children[lane]),
                    )
                };
                if let Some(first) = take() {
                    next = first;
                    let bottom = stack.len();
                    while let Some(other) = take() {
                        stack.push(other.max(next));
                        next = other.min(next);
                    }
                    if stack.len() > bottom + 1 {
                        far_first(&mut stack[bottom..]);
                    }
                    continue;
                }
            }
            loop {
                let Some(waiting) = stack.pop() else {
                    return;
                };
                if waiting.distance() <= far {
                    next = waiting;
                    break;
                }
            }
        }
    }

    /// See [`Accel::any_touching`](super::Accel::any_touching).
    pub fn any_touching(&self, hull: &Hull, test: impl FnMut(u32) -> bool) -> bool {
        if !hull.meets(&self.whole) {
            return false;
        }
        let hull = hull.mapped(|point| self.inner(point));
        let touched = |node: &Node| {
            let place = |face: usize, lane: usize| f64::from(node.faces[face][lane]);
            let corner =
                |face, lane| DVec3::new(place(face, lane), place(face + 1, lane), place(face + 2, lane));
            let is_touched = |lane: usize| {
                node.children[lane] != u32::MAX
                    && hull.meets(&Bounds { min: corner(0, lane), max: corner(3, lane) })
            };
            (0..WIDTH).fold(0, |mask, lane| mask | u32::from(is_touched(lane)) << lane)
        };
        self.any_below(touched, test)
    }

    /// See [`Accel::any_around`](super::Accel::any_around).
    #[inline(always)]
    pub fn any_around(&self, point: DVec3, test: impl FnMut(u32) -> bool) -> bool {
        if !self.whole.contains(point) {
            return false;
        }
        let point = self.inner(point);
        let low = point.to_array().map(|x| Vec4::splat(rounded_down(x)));
        let high = point.to_array().map(|x| Vec4::splat(rounded_up(x)));
        let around = |node: &Node| {
            (0..3).fold(!0, |around, axis| {
                let (first, last) = (&node.faces[axis], &node.faces[axis + 3]);
                around & mask(|half| four(first, half).cmple(high[axis]) & four(last, half).cmpge(low[axis]))
            })
        };
        self.any_below(around, test)
    }

    /// Whether `test` holds for any item below the children of which `near` gives the bits.
    #[inline(always)]
    fn any_below(&self, near: impl Fn(&Node) -> u32, mut test: impl FnMut(u32) -> bool) -> bool {
        let mut stack: SmallVec<[u32; STACK]> = SmallVec::new();
        stack.push(0);
        while let Some(child) = stack.pop() {
            if child & LEAF != 0 {
                if test(child & !LEAF) {
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

/// The items of a leaf.
#[inline(always)]
fn run(leaf: u32) -> Span<usize> {
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

/// The lower or the upper half.
#[inline(always)]
fn four(lanes: &Lanes, half: usize) -> Vec4 {
    Vec4::from_slice(&lanes[4 * half..])
}

/// The bits of the lanes that pass, four at a time.
#[inline(always)]
fn mask(pass: impl Fn(usize) -> BVec4A) -> u32 {
    pass(0).bitmask() | pass(1).bitmask() << 4
}

/// A ray in the space of the boxes.
struct Probe {
    /// The origin, moved so far that rounding can't turn a hit into a miss: once for planes that
    /// bound the near end of the overlap, once for those that bound the far end.
    near: [f32; 3],
    far: [f32; 3],
    inverse: [f32; 3],
    /// Whether a node's high faces are met first along each axis.
    backward: [bool; 3],
}

impl Probe {
    #[inline(always)]
    fn new(origin: DVec3, direction: DVec3, blur: f32) -> Self {
        let (origin, direction) = (origin.as_vec3().to_array(), direction.as_vec3().to_array());
        let mut probe = Self { near: origin, far: origin, inverse: direction, backward: [false; 3] };
        // Loops throughout: closures given to arrays' methods are not compiled for wide registers.
        for axis in 0..3 {
            let (o, d) = (origin[axis], direction[axis]);
            let inverse = if d.abs() < LEAST_DIRECTION { LEAST_DIRECTION.copysign(d) } else { d }.recip();
            let room = (o.abs() * SLACK + blur).copysign(inverse);
            probe.near[axis] = o + room;
            probe.far[axis] = o - room;
            probe.inverse[axis] = inverse;
            probe.backward[axis] = inverse < 0.0;
        }
        probe
    }

    /// Whether the ray is one: boxes of missing children are only missed by finite ones.
    #[inline(always)]
    fn is_sound(&self) -> bool {
        (0..3).all(|axis| (self.near[axis] * self.inverse[axis]).is_finite())
    }

    /// Entry distances, none negative, and the bits of the boxes met before `far`.
    #[inline(always)]
    fn test(&self, node: &Node, far: f32) -> (Lanes, u32) {
        let (mut entry, mut exit) = ([0.0; WIDTH], [far; WIDTH]);
        for axis in 0..3 {
            let (low, high) = (&node.faces[axis], &node.faces[axis + 3]);
            let (first, last) = if self.backward[axis] { (high, low) } else { (low, high) };
            let (start, end, inverse) = (self.near[axis], self.far[axis], self.inverse[axis]);
            for lane in 0..WIDTH {
                let (near, far) = ((first[lane] - start) * inverse, (last[lane] - end) * inverse);
                entry[lane] = if near > entry[lane] { near } else { entry[lane] };
                exit[lane] = if far < exit[lane] { far } else { exit[lane] };
            }
        }
        for lane in 0..WIDTH {
            entry[lane] *= 1.0 - SLACK;
            exit[lane] *= 1.0 + SLACK;
        }
        let met = four(&entry, 0).cmple(four(&exit, 0)).bitmask()
            | four(&entry, 1).cmple(four(&exit, 1)).bitmask() << 4;
        (entry, met)
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
