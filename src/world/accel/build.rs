//! Builds a tree of boxes from the top down, splitting where the surface area heuristic expects
//! the least work. Nodes are made four wide at once: the part with the largest area is split
//! until there are four.

use super::bvh::WIDTH;
use crate::math::{Bounds, DVec3};

/// Centres are sorted into this many slices along each axis.
const BINS: usize = 16;

/// Below this depth parts are halved by count, which bounds the depth of the tree.
const DEPTH_OF_HEURISTIC: u32 = 24;

/// An item on its way into the tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub(super) bounds: Bounds,
    pub(super) center: DVec3,
    pub(super) number: u32,
}

impl Item {
    pub(super) fn new((bounds, number): (Bounds, u32)) -> Self {
        Self { bounds, center: bounds.center(), number }
    }
}

/// Cuts `items` into one to [`WIDTH`] parts and hands them out with their boxes.
pub(super) fn parts(items: &mut [Item], depth: u32) -> Vec<(Bounds, &mut [Item])> {
    let bounds = around(items);
    let mut parts = vec![(bounds, items)];
    while parts.len() < WIDTH {
        let largest = (0..parts.len())
            .filter(|&i| parts[i].1.len() > 1)
            .max_by(|&a, &b| parts[a].0.half_area().total_cmp(&parts[b].0.half_area()));
        let Some(largest) = largest else {
            break;
        };
        let (_, items) = parts.swap_remove(largest);
        let (left, right) = split(items, depth);
        parts.push((around(left), left));
        parts.push((around(right), right));
    }
    parts
}

fn around(items: &[Item]) -> Bounds {
    items.iter().fold(Bounds::EMPTY, |all, item| all.union(item.bounds))
}

/// Two parts, neither empty.
fn split(items: &mut [Item], depth: u32) -> (&mut [Item], &mut [Item]) {
    let centers = Bounds::of(items.iter().map(|item| item.center));
    let best = (depth < DEPTH_OF_HEURISTIC).then(|| best_cut(items, centers)).flatten();
    let middle = match best {
        Some(cut) => partition(items, |item| cut.bin(item.center) < cut.bin),
        None => {
            let axis = centers.size().max_position();
            let half = items.len() / 2;
            items.select_nth_unstable_by(half, |a, b| {
                a.center[axis].total_cmp(&b.center[axis]).then(a.number.cmp(&b.number))
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
    bin: usize,
}

impl Cut {
    fn bin(&self, center: DVec3) -> usize {
        (((center[self.axis] - self.origin) * self.scale) as usize).min(BINS - 1)
    }
}

/// The cut with the least expected work; `None` where all centres coincide.
fn best_cut(items: &[Item], centers: Bounds) -> Option<Cut> {
    let mut best = None;
    let mut least = f64::INFINITY;
    for axis in 0..3 {
        let scale = BINS as f64 / centers.size()[axis];
        if !scale.is_finite() {
            continue;
        }
        let cut = Cut { axis, origin: centers.min[axis], scale, bin: 0 };
        let mut bins = [(0usize, Bounds::EMPTY); BINS];
        for item in items {
            let (count, bounds) = &mut bins[cut.bin(item.center)];
            *count += 1;
            *bounds = bounds.union(item.bounds);
        }
        // The cost of everything to the right of each cut, then of everything to the left.
        let mut right = [0.0; BINS];
        sweep(bins.iter().copied().enumerate().rev(), |bin, cost| right[bin] = cost);
        sweep(bins.iter().copied().enumerate().take(BINS - 1), |bin, left| {
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
