//! A compact bounding volume hierarchy for the parts of one shape.
//!
//! Boxes are single precision, relative to the shape's middle and rounded outward, so that they never
//! cut what they hold; the ray is tested against them in double precision.

use crate::math::{Bounds, DVec3};
use crate::world::{Range, Ray};

/// The hierarchy: nodes in depth-first order, and the parts in the order of its leaves.
#[derive(Clone, Debug)]
pub(in crate::world::shape) struct Bvh {
    center: DVec3,
    nodes: Vec<Node>,
    order: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    min: [f32; 3],
    /// First part of a leaf in the order; of an inner node, the second child (the first follows it).
    start: u32,
    max: [f32; 3],
    /// Parts of a leaf; 0 for an inner node.
    count: u32,
}

/// Parts to a leaf at most, unless they can't be told apart.
const LEAF: usize = 4;
/// Candidate planes of a split.
const BINS: usize = 16;
/// Deepest tree: beyond it parts are halved by number.
const DEPTH: usize = 48;

struct Builder<'a> {
    bounds: &'a [Bounds],
    center: DVec3,
    nodes: Vec<Node>,
    order: Vec<u32>,
}

impl Bvh {
    /// Over parts with these boxes, all finite.
    pub(in crate::world::shape) fn new(bounds: &[Bounds]) -> Self {
        let all = bounds.iter().fold(Bounds::EMPTY, |all, b| all.union(*b));
        let center = if all.is_finite() { all.center() } else { DVec3::ZERO };
        let order = (0..bounds.len() as u32).collect();
        let mut builder = Builder { bounds, center, nodes: Vec::new(), order };
        if !bounds.is_empty() {
            builder.build(0, bounds.len(), 0);
        }
        Self { center, nodes: builder.nodes, order: builder.order }
    }

    /// Visits the parts whose boxes the ray meets, near ones first; `visit` gets a part and the range
    /// left, and may return a lower upper end.
    pub(in crate::world::shape) fn visit(
        &self,
        ray: &Ray,
        mut range: Range,
        mut visit: impl FnMut(u32, Range) -> Option<f64>,
    ) {
        let test = BoxTest { origin: ray.origin - self.center, inverse: ray.direction.recip() };
        let mut stack = [(0_u32, f64::NEG_INFINITY); DEPTH * 2];
        let mut depth = 0;
        let Some(entry) = self.nodes.first().and_then(|root| test.entry(root, range)) else {
            return;
        };
        let mut next = Some((0, entry));
        while let Some((index, entry)) = next {
            next = None;
            let node = &self.nodes[index as usize];
            if entry > range.max {
                // A nearer hit has come up since.
            } else if node.count > 0 {
                for &part in &self.order[node.start as usize..(node.start + node.count) as usize] {
                    if let Some(max) = visit(part, range) {
                        range.max = range.max.min(max);
                    }
                }
            } else {
                let children = [index + 1, node.start];
                let entries = children.map(|child| test.entry(&self.nodes[child as usize], range));
                next = match entries {
                    [Some(first), Some(second)] => {
                        let (near, far) = if second < first { (1, 0) } else { (0, 1) };
                        stack[depth] = (children[far], first.max(second));
                        depth += 1;
                        Some((children[near], first.min(second)))
                    }
                    [Some(first), None] => Some((children[0], first)),
                    [None, Some(second)] => Some((children[1], second)),
                    [None, None] => None,
                };
            }
            if next.is_none() && depth > 0 {
                depth -= 1;
                next = Some(stack[depth]);
            }
        }
    }
}

impl Bvh {
    /// Visits the parts whose boxes hold a point.
    pub(in crate::world::shape) fn visit_point(&self, point: DVec3, mut visit: impl FnMut(u32)) {
        let point = point - self.center;
        let mut stack = [0_u32; DEPTH * 2];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let index = stack[depth];
            let node = &self.nodes[index as usize];
            let (min, max) = (node.min.map(f64::from), node.max.map(f64::from));
            let bounds = Bounds { min: min.into(), max: max.into() };
            if !bounds.contains(point) {
                continue;
            }
            if node.count > 0 {
                self.order[node.start as usize..][..node.count as usize].iter().for_each(|part| visit(*part));
            } else {
                stack[depth] = node.start;
                stack[depth + 1] = index + 1;
                depth += 2;
            }
        }
    }
}

/// A ray prepared for many boxes.
struct BoxTest {
    origin: DVec3,
    inverse: DVec3,
}

impl BoxTest {
    /// The distance at which the ray enters a box, never above the true one; `None` for a miss.
    fn entry(&self, node: &Node, range: Range) -> Option<f64> {
        /// Makes up for the rounding of both ends (Ize, JCGT 2013).
        const ROOM: f64 = 1.0 + 8.0 * f64::EPSILON;
        let (mut enter, mut leave) = (range.min, range.max);
        for axis in 0..3 {
            let low = (f64::from(node.min[axis]) - self.origin[axis]) * self.inverse[axis];
            let high = (f64::from(node.max[axis]) - self.origin[axis]) * self.inverse[axis];
            // A ray in the plane of a face gives NaN, which min and max pass over.
            let (near, far) = if self.inverse[axis] < 0.0 { (high, low) } else { (low, high) };
            enter = enter.max(if near > 0.0 { near / ROOM } else { near * ROOM });
            leave = leave.min(if far > 0.0 { far * ROOM } else { far / ROOM });
        }
        (enter <= leave).then_some(enter)
    }
}

impl Builder<'_> {
    /// Makes the node of the parts in `order[start..end]` and everything below it.
    fn build(&mut self, start: usize, end: usize, depth: usize) {
        let parts = &self.order[start..end];
        let bounds = parts.iter().fold(Bounds::EMPTY, |all, &i| all.union(self.bounds[i as usize]));
        let index = self.nodes.len();
        self.nodes.push(self.node(bounds));
        let split = if parts.len() <= LEAF { None } else { self.split(start, end, depth) };
        let Some(middle) = split else {
            self.nodes[index].start = start as u32;
            self.nodes[index].count = (end - start) as u32;
            return;
        };
        self.build(start, middle, depth + 1);
        self.nodes[index].start = self.nodes.len() as u32;
        self.build(middle, end, depth + 1);
    }

    fn node(&self, bounds: Bounds) -> Node {
        let (low, high) = (bounds.min - self.center, bounds.max - self.center);
        // Rounded outward, and one step more for the rounding of `origin - center` in the test.
        Node {
            min: low.to_array().map(|x| (x as f32).next_down().next_down()),
            start: 0,
            max: high.to_array().map(|x| (x as f32).next_up().next_up()),
            count: 0,
        }
    }

    /// Orders the parts by the split with the least surface area; `None` to keep them together.
    fn split(&mut self, start: usize, end: usize, depth: usize) -> Option<usize> {
        let middle_of = |bounds: &[Bounds], i: u32| bounds[i as usize].center();
        let parts = &mut self.order[start..end];
        let centers = Bounds::of(parts.iter().map(|&i| middle_of(self.bounds, i)));
        let axis = centers.size().max_position();
        let (low, size) = (centers.min[axis], centers.size()[axis]);
        if size <= 0.0 || depth >= DEPTH - 8 {
            // Parts in one place can't be told apart; a tree this deep is cut in halves by number.
            return (parts.len() > 4 * LEAF && depth < 2 * DEPTH - 1).then_some((start + end) / 2);
        }
        let bin_of = |i: u32| {
            let place = (middle_of(self.bounds, i)[axis] - low) / size;
            ((place * BINS as f64) as usize).min(BINS - 1)
        };
        let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
        for &i in parts.iter() {
            let bin = &mut bins[bin_of(i)];
            *bin = (bin.0.union(self.bounds[i as usize]), bin.1 + 1);
        }
        let best = cheapest(&bins)?;
        let (mut left, mut right) = (0, parts.len());
        while left < right {
            if bin_of(parts[left]) < best {
                left += 1;
            } else {
                right -= 1;
                parts.swap(left, right);
            }
        }
        Some(start + left)
    }
}

/// The first bin of the second half where the sum of areas times counts is least.
fn cheapest(bins: &[(Bounds, usize); BINS]) -> Option<usize> {
    let cost =
        |(bounds, count): (Bounds, usize)| if count == 0 { 0.0 } else { bounds.half_area() * count as f64 };
    let join = |a: (Bounds, usize), b: (Bounds, usize)| (a.0.union(b.0), a.1 + b.1);
    let mut right_costs = [0.0; BINS];
    let mut right = (Bounds::EMPTY, 0);
    for i in (1..BINS).rev() {
        right = join(right, bins[i]);
        right_costs[i] = if right.1 == 0 { f64::INFINITY } else { cost(right) };
    }
    let mut best = None;
    let mut least = f64::INFINITY;
    let mut left = (Bounds::EMPTY, 0);
    for i in 1..BINS {
        left = join(left, bins[i - 1]);
        let total = cost(left) + right_costs[i];
        if left.1 > 0 && total < least {
            (best, least) = (Some(i), total);
        }
    }
    best
}
