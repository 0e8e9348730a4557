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

/// Up to so many items are few.
const FEW: usize = 8;

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
        let [left, right] = split(items, depth);
        let middle = first + left.0.len();
        parts.push(Part { first, bounds: left.1, items: left.0 });
        parts.push(Part { first: middle, bounds: right.1, items: right.0 });
    }
    parts
}

fn around(items: &[Item]) -> Bounds {
    items.iter().fold(Bounds::EMPTY, |all, item| all.union(item.bounds()))
}

/// Two parts, neither empty, and the boxes around them.
fn split(items: &mut [Item], depth: u32) -> [(&mut [Item], Bounds); 2] {
    let mut centers = Bounds::EMPTY;
    for item in &*items {
        let center = item.center();
        centers = Bounds { min: centers.min.min(center), max: centers.max.max(center) };
    }
    let best = match items.len() {
        _ if depth >= DEPTH_OF_HEURISTIC => None,
        ..=FEW => best_cut::<FEW>(items, centers),
        _ => best_cut::<BINS>(items, centers),
    };
    if let Some(cut) = best {
        let middle = partition(items, |item| cut.bin(item.center()) < cut.bin);
        let (left, right) = items.split_at_mut(middle);
        let [left_bounds, right_bounds] = cut.sides;
        return [(left, left_bounds), (right, right_bounds)];
    }
    let axis = centers.size().max_position();
    let half = items.len() / 2;
    items.select_nth_unstable_by(half, |a, b| {
        a.center()[axis].total_cmp(&b.center()[axis]).then(a.number.cmp(&b.number))
    });
    let (left, right) = items.split_at_mut(half);
    let sides = [around(left), around(right)];
    [(left, sides[0]), (right, sides[1])]
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
    /// What is around both sides.
    sides: [Bounds; 2],
}

impl Cut {
    fn bin(&self, center: DVec3) -> usize {
        bin(center[self.axis], self.origin, self.scale, self.last)
    }
}

/// The number of the slice that a coordinate is in.
#[inline(always)]
fn bin(at: f64, origin: f64, scale: f64, last: usize) -> usize {
    (((at - origin) * scale) as usize).min(last)
}

/// The cut with the least expected work; `None` where all centres coincide.
fn best_cut<const MOST: usize>(items: &[Item], centers: Bounds) -> Option<Cut> {
    let count = items.len().clamp(FEWEST_BINS, MOST);
    let (origin, last) = (centers.min, count - 1);
    let scale = count as f64 / centers.size();
    let mut bins = [[(0usize, Bounds::EMPTY); MOST]; 3];
    for item in items {
        let center = item.center();
        let [x, y, z] = &mut bins;
        // What has no size along an axis has no cut there, wherever it is counted.
        for (bins, place) in [
            (x, bin(center.x, origin.x, scale.x, last)),
            (y, bin(center.y, origin.y, scale.y, last)),
            (z, bin(center.z, origin.z, scale.z, last)),
        ] {
            let (count, bounds) = &mut bins[place % MOST];
            *count += 1;
            *bounds = bounds.union(item.bounds());
        }
    }
    let mut best = None;
    let mut least = f64::INFINITY;
    for axis in 0..3 {
        if !scale[axis].is_finite() {
            continue;
        }
        let bins = &bins[axis][..count];
        // The cost of everything to the right of each cut, then of everything to the left.
        let mut right = [0.0; MOST];
        sweep(bins.iter().copied().enumerate().rev(), |bin, cost| right[bin] = cost);
        sweep(bins.iter().copied().enumerate().take(count - 1), |bin, left| {
            let cost = left + right[bin + 1];
            // A side without items has no cost of its own and is no cut.
            if left > 0.0 && right[bin + 1] > 0.0 && cost < least {
                least = cost;
                best = Some((axis, bin + 1));
            }
        });
    }
    let (axis, bin) = best?;
    let (left, right) = bins[axis][..count].split_at(bin);
    let sides = [left, right].map(|side| side.iter().fold(Bounds::EMPTY, |all, bin| all.union(bin.1)));
    Some(Cut { axis, origin: origin[axis], scale: scale[axis], last, bin, sides })
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
