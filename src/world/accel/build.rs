//! Builds a tree of boxes from the top down, splitting where the surface area heuristic expects
//! the least work. Nodes are made eight wide at once: the part with the largest area is split
//! until there are eight.

use glam::Vec3;
use rayon::prelude::*;
use smallvec::SmallVec;

use super::node::{Node, WIDTH};
use crate::math::{Bounds, DVec3};

/// Centres of many items are sorted into this many slices along each axis.
const BINS: usize = 16;

/// Centres of few items into as many slices as they are, but no fewer than this.
const FEWEST_BINS: usize = 4;

/// Below this depth parts are halved by count, which bounds the depth of the tree.
const DEPTH_OF_HEURISTIC: u32 = 24;

/// Parts with more items are built beside each other.
const MANY: usize = 2048;

/// Parts with more than that one after the other, and theirs beside each other: the nodes of those that are
/// built beside are in the way until they are all there.
const VERY_MANY: usize = 1 << 18;

/// So many children a node has at least, on average.
const FULL: usize = 4;

/// So many levels of them: each copies the nodes below it.
const LEVELS_BESIDE: u32 = 2;

/// An item on its way into the tree. Small, as there may be millions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    /// Its box, as the tree has it.
    pub(super) low: Vec3,
    pub(super) high: Vec3,
    pub(super) number: u32,
}

impl Item {
    pub(super) fn bounds(&self) -> Bounds {
        Bounds { min: self.low.as_dvec3(), max: self.high.as_dvec3() }
    }

    fn center(&self) -> DVec3 {
        self.bounds().center()
    }
}

/// What is below a node.
#[derive(Clone, Copy, Debug)]
pub(super) enum Child {
    /// The number of another node.
    Node(u32),
    /// Items by their place in the order of the tree.
    Run { first: u32, length: u32 },
}

/// A part of the items: where it starts among all, and its box.
struct Part<'a> {
    first: usize,
    items: &'a mut [Item],
    bounds: Bounds,
}

/// How a tree is to be.
#[derive(Clone, Copy)]
struct Plan {
    /// The longest run of a leaf.
    longest: usize,
    /// Parts with so many items aren't cut any more: where there are very many, most nodes are to be full.
    whole: usize,
}

/// The nodes over at least one item, the root first. Brings the items into the order in which the
/// leaves, runs of up to `longest`, count them.
pub(super) fn tree<F>(items: &mut [Item], longest: usize, node: &F) -> Vec<Node>
where
    F: Fn(&[(Bounds, Child)]) -> Node + Sync,
{
    let bounds = around(items);
    let whole = if longest == 1 && items.len() > VERY_MANY { WIDTH } else { longest };
    let mut nodes = Vec::with_capacity(items.len() / longest / FULL + 1);
    grow(Part { first: 0, items, bounds }, [0; 2], Plan { longest, whole }, node, &mut nodes);
    nodes
}

/// Appends the subtree of a part and answers its number. It is so deep in the tree, and below so many parts
/// that are built beside others.
fn grow<F>(part: Part, [depth, beside]: [u32; 2], plan: Plan, node: &F, nodes: &mut Vec<Node>) -> u32
where
    F: Fn(&[(Bounds, Child)]) -> Node + Sync,
{
    let number = nodes.len();
    let many = (MANY..VERY_MANY).contains(&part.items.len()) && beside < LEVELS_BESIDE;
    let beside = beside + u32::from(many);
    let parts = parts(part, depth, plan);
    let mut children: SmallVec<[(Bounds, Child); WIDTH]> = SmallVec::new();
    // Its place is taken before its children's.
    nodes.push(Node::EMPTY);
    let subtrees: Vec<(Bounds, Result<Child, Vec<Node>>)> = if many {
        let grown = |part: Part| {
            let bounds = part.bounds;
            let child = leaf(&part, plan).ok_or_else(|| {
                let mut below = Vec::with_capacity(part.items.len() / plan.longest / FULL + 1);
                grow(part, [depth + 1, beside], plan, node, &mut below);
                below
            });
            (bounds, child)
        };
        parts.into_vec().into_par_iter().map(grown).collect()
    } else {
        let grown = |part: Part| {
            let bounds = part.bounds;
            let child = leaf(&part, plan);
            (
                bounds,
                Ok(child.unwrap_or_else(|| Child::Node(grow(part, [depth + 1, beside], plan, node, nodes)))),
            )
        };
        parts.into_iter().map(grown).collect()
    };
    for (bounds, child) in subtrees {
        let child = child.unwrap_or_else(|below| {
            let offset = nodes.len() as u32;
            nodes.extend(below.into_iter().map(|node| node.moved(offset)));
            Child::Node(offset)
        });
        children.push((bounds, child));
    }
    nodes[number] = node(&children);
    number as u32
}

/// The part as a leaf, if it is small enough.
fn leaf(part: &Part, plan: Plan) -> Option<Child> {
    let length = part.items.len();
    (length <= plan.longest).then_some(Child::Run { first: part.first as u32, length: length as u32 })
}

/// Cuts a part into one to [`WIDTH`].
fn parts(part: Part, depth: u32, plan: Plan) -> SmallVec<[Part; WIDTH]> {
    let mut parts = SmallVec::new();
    if plan.longest == 1 && part.items.len() <= WIDTH {
        for (place, items) in part.items.chunks_mut(1).enumerate() {
            parts.push(Part { first: part.first + place, bounds: items[0].bounds(), items });
        }
        return parts;
    }
    parts.push(part);
    while parts.len() < WIDTH {
        let largest = (0..parts.len())
            .filter(|&i| parts[i].items.len() > plan.whole)
            .max_by(|&a, &b| parts[a].bounds.half_area().total_cmp(&parts[b].bounds.half_area()));
        let Some(largest) = largest else {
            break;
        };
        let Part { first, items, .. } = parts.swap_remove(largest);
        let (left, right) = split(items, depth);
        let middle = first + left.len();
        parts.push(Part { first, bounds: around(left), items: left });
        parts.push(Part { first: middle, bounds: around(right), items: right });
    }
    parts
}

fn around(items: &[Item]) -> Bounds {
    items.iter().fold(Bounds::EMPTY, |all, item| all.union(item.bounds()))
}

/// Two parts, neither empty.
fn split(items: &mut [Item], depth: u32) -> (&mut [Item], &mut [Item]) {
    let centers = Bounds::of(items.iter().map(|item| item.center()));
    let best = (depth < DEPTH_OF_HEURISTIC).then(|| best_cut(items, centers)).flatten();
    let middle = match best {
        Some(cut) => partition(items, |item| cut.bin(item.center()) < cut.bin),
        None => {
            let axis = centers.size().max_position();
            let half = items.len() / 2;
            items.select_nth_unstable_by(half, |a, b| {
                a.center()[axis].total_cmp(&b.center()[axis]).then(a.number.cmp(&b.number))
            });
            half
        }
    };
    items.split_at_mut(middle)
}

/// Between which slices of which axis to cut.
#[derive(Clone, Copy)]
struct Cut {
    axis: usize,
    origin: f64,
    scale: f64,
    /// The number of the last slice.
    last: usize,
    bin: usize,
}

impl Cut {
    fn bin(&self, center: DVec3) -> usize {
        (((center[self.axis] - self.origin) * self.scale) as usize).min(self.last)
    }
}

/// The cut with the least expected work; `None` where all centres coincide.
fn best_cut(items: &[Item], centers: Bounds) -> Option<Cut> {
    let mut best = None;
    let mut least = f64::INFINITY;
    let count = items.len().clamp(FEWEST_BINS, BINS);
    for axis in 0..3 {
        let scale = count as f64 / centers.size()[axis];
        if !scale.is_finite() {
            continue;
        }
        let cut = Cut { axis, origin: centers.min[axis], scale, last: count - 1, bin: 0 };
        let mut bins = [(0usize, Bounds::EMPTY); BINS];
        let bins = &mut bins[..count];
        for item in items {
            let (count, bounds) = &mut bins[cut.bin(item.center())];
            *count += 1;
            *bounds = bounds.union(item.bounds());
        }
        // The cost of everything to the right of each cut, then of everything to the left.
        let mut right = [0.0; BINS];
        sweep(bins.iter().copied().enumerate().rev(), |bin, cost| right[bin] = cost);
        sweep(bins.iter().copied().enumerate().take(count - 1), |bin, left| {
            let cost = left + right[bin + 1];
            // A side without items has no cost of its own and is no cut.
            if left > 0.0 && right[bin + 1] > 0.0 && cost < least {
                least = cost;
                best = Some(Cut { bin: bin + 1, ..cut });
            }
        });
    }
    best
}

/// Hands out the cost of all slices so far: their number of items times the area around them.
fn sweep(bins: impl Iterator<Item = (usize, (usize, Bounds))>, mut cost: impl FnMut(usize, f64)) {
    let (mut count, mut bounds) = (0, Bounds::EMPTY);
    for (bin, (more, around)) in bins {
        count += more;
        bounds = bounds.union(around);
        // Flat boxes have no area but still cost a test.
        cost(bin, if count == 0 { 0.0 } else { count as f64 * bounds.half_area().max(f64::MIN_POSITIVE) });
    }
}

/// Moves the items that pass to the front and counts them.
fn partition(items: &mut [Item], pass: impl Fn(&Item) -> bool) -> usize {
    let mut front = 0;
    for i in 0..items.len() {
        if pass(&items[i]) {
            items.swap(i, front);
            front += 1;
        }
    }
    front
}
