//! A tree of boxes, four to a node and one item to a leaf.
//!
//! Boxes are single precision, relative to the middle and size of the whole and rounded outward;
//! rays are moved up to the whole box first. So neither a far camera nor a scene far from the
//! origin loosens the tests, and no item that double precision would find is missed.

use glam::Vec4;
use smallvec::SmallVec;

use super::build::{self, Item};
use super::linear::Slabs;
use crate::math::{Bounds, DVec3};
use crate::world::ray::{Range, Ray};

/// Children of a node.
pub(super) const WIDTH: usize = 4;

/// Marks a child that is an item.
const LEAF: u32 = 1 << 31;

/// Bound on the rounding errors of single precision tests, relative to the terms of each.
const SLACK: f32 = 8.0 * f32::EPSILON;

/// Bound on the rounding errors of double precision arithmetic on points.
const BLUR: f64 = 8.0 * f64::EPSILON;

/// Directions are kept away from zero, so that no slab's distance is 0 · ∞.
const LEAST_DIRECTION: f32 = 1e-30;

/// Deepest stack seen on ordinary scenes; deeper ones go to the heap.
const STACK: usize = 64;

/// A tree over bounded items.
#[derive(Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    whole: Bounds,
    center: DVec3,
    scale: f64,
}

/// Four boxes side by side; missing children have empty ones.
#[derive(Clone, Copy, Debug)]
struct Node {
    min: [Vec4; 3],
    max: [Vec4; 3],
    children: [u32; WIDTH],
}

impl Node {
    const EMPTY: Self =
        Self { min: [Vec4::INFINITY; 3], max: [Vec4::NEG_INFINITY; 3], children: [u32::MAX; WIDTH] };
}

impl Bvh {
    /// Takes at least one item, all bounded.
    pub fn new(items: Vec<(Bounds, u32)>) -> Self {
        let whole = items.iter().fold(Bounds::EMPTY, |all, (bounds, _)| all.union(*bounds));
        let scale = 2.0 / whole.size().max_element();
        let mut bvh = Self {
            nodes: Vec::with_capacity(items.len() / 2),
            whole,
            center: whole.center(),
            scale: if scale.is_finite() { scale } else { 1.0 },
        };
        let mut items: Vec<Item> = items.into_iter().map(Item::new).collect();
        bvh.node(&mut items, 0);
        bvh
    }

    /// Appends the subtree of `items` and answers its number.
    fn node(&mut self, items: &mut [Item], depth: u32) -> u32 {
        let number = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        for (lane, (bounds, items)) in build::parts(items, depth).into_iter().enumerate() {
            let child = match items {
                [item] => item.number | LEAF,
                _ => self.node(items, depth + 1),
            };
            let (low, high) = (self.inner(bounds.min), self.inner(bounds.max));
            let node = &mut self.nodes[number];
            node.children[lane] = child;
            for axis in 0..3 {
                node.min[axis][lane] = rounded_down(low[axis]);
                node.max[axis][lane] = rounded_up(high[axis]);
            }
        }
        number as u32
    }

    /// A point in the space of the boxes.
    fn inner(&self, point: DVec3) -> DVec3 {
        (point - self.center) * self.scale
    }

    /// See [`Accel::along`](super::Accel::along).
    pub fn along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> f64) {
        let slabs = Slabs::new(ray);
        if !slabs.meet(&self.whole, range) {
            return;
        }
        let start = slabs.entry(&self.whole).max(range.min).max(0.0);
        // What rounding in double precision did to the origin, seen in the space of the boxes.
        let blur = 1.0 + (ray.origin.abs().max_element() + self.center.abs().max_element()) * self.scale;
        let probe = Probe::new(self.inner(ray.at(start)), ray.direction, (blur * BLUR) as f32);
        // Distances beyond `start`, in the space of the boxes.
        let inner = |t: f64| rounded_up((t + t.abs() * BLUR - start) * self.scale);
        let mut far = inner(range.max);
        let mut stack: SmallVec<[(u32, f32); STACK]> = SmallVec::new();
        stack.push((0, 0.0));
        while let Some((child, near)) = stack.pop() {
            if near > far {
                continue;
            }
            if child & LEAF != 0 {
                let end = visit(child & !LEAF);
                if end == f64::NEG_INFINITY {
                    return;
                }
                far = inner(end);
                continue;
            }
            let node = &self.nodes[child as usize];
            let (near, met) = probe.test(node, far);
            let bottom = stack.len();
            for lane in 0..WIDTH {
                if met & 1 << lane != 0 {
                    stack.push((node.children[lane], near[lane]));
                }
            }
            stack[bottom..].sort_unstable_by(|a, b| b.1.total_cmp(&a.1));
        }
    }

    /// See [`Accel::any_around`](super::Accel::any_around).
    pub fn any_around(&self, point: DVec3, mut test: impl FnMut(u32) -> bool) -> bool {
        if !self.whole.contains(point) {
            return false;
        }
        let point = self.inner(point);
        let (low, high) = (point.to_array().map(rounded_down), point.to_array().map(rounded_up));
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
            let mut around = !0;
            for axis in 0..3 {
                around &= node.min[axis].cmple(Vec4::splat(high[axis])).bitmask()
                    & node.max[axis].cmpge(Vec4::splat(low[axis])).bitmask();
            }
            stack.extend((0..WIDTH).filter(|lane| around & 1 << lane != 0).map(|lane| node.children[lane]));
        }
        false
    }
}

/// A ray in the space of the boxes.
struct Probe {
    /// The origin, moved so far that rounding can't turn a hit into a miss: once for planes that
    /// bound the near end of the overlap, once for those that bound the far end.
    near: [Vec4; 3],
    far: [Vec4; 3],
    inverse: [Vec4; 3],
    backward: [bool; 3],
}

impl Probe {
    fn new(origin: DVec3, direction: DVec3, blur: f32) -> Self {
        let inverse = direction.to_array().map(|d| {
            let d = d as f32;
            if d.abs() < LEAST_DIRECTION { LEAST_DIRECTION.copysign(d) } else { d }.recip()
        });
        let moved = |toward: f32| {
            std::array::from_fn(|axis| {
                let o = origin[axis] as f32;
                Vec4::splat(o + (o.abs() * SLACK + blur) * toward.copysign(toward * inverse[axis]))
            })
        };
        Self {
            near: moved(1.0),
            far: moved(-1.0),
            inverse: inverse.map(Vec4::splat),
            backward: inverse.map(|i| i < 0.0),
        }
    }

    /// Entry distances and the mask of the boxes met before `far`.
    fn test(&self, node: &Node, far: f32) -> (Vec4, u32) {
        let (mut entry, mut exit) = (Vec4::ZERO, Vec4::splat(far));
        for axis in 0..3 {
            let (first, last) = if self.backward[axis] {
                (node.max[axis], node.min[axis])
            } else {
                (node.min[axis], node.max[axis])
            };
            entry = entry.max((first - self.near[axis]) * self.inverse[axis]);
            exit = exit.min((last - self.far[axis]) * self.inverse[axis]);
        }
        let entry = entry * (1.0 - SLACK);
        (entry, entry.cmple(exit * (1.0 + SLACK)).bitmask())
    }
}

/// The greatest single precision number that is not above `x`.
fn rounded_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

/// The least single precision number that is not below `x`.
fn rounded_up(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) < x { y.next_up() } else { y }
}
