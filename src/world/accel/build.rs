//! Builds a tree of boxes from the top down, splitting where the surface area heuristic expects
//! the least work. Nodes are made eight wide at once: the part with the largest area is split
//! until there are eight.

use glam::{Vec3, Vec3A};
use rayon::prelude::*;
use smallvec::SmallVec;

use super::node::{Node, WIDTH};
use crate::math::wide::widest;

/// Centres of many items are sorted into this many slices along each axis.
const BINS: usize = 16;

/// Centres of few items into as many slices as they are, but no fewer than this.
const FEWEST_BINS: usize = 4;

/// Up to so many items are few.
const FEW: usize = 8;

/// Below this depth parts are halved by count, which bounds the depth of the tree.
const DEPTH_OF_HEURISTIC: u32 = 24;

/// Where to cut more items is asked of about so many of them.
const ASKED: usize = 1024;

/// Parts with more items are built beside each other.
const MANY: usize = 2048;

/// Parts with more than that one after the other, and theirs beside each other: the nodes of those that are
/// built beside are in the way until they are all there.
const VERY_MANY: usize = 1 << 18;

/// Parts of so many that are to fill their nodes are cut where as many as fill nodes lie to one side.
const PACKED: usize = WIDTH * WIDTH;

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
    #[inline(always)]
    pub(super) fn around(&self) -> Around {
        Around { low: self.low.into(), high: self.high.into() }
    }

    /// Twice its middle: where to cut is asked of sums alone.
    #[inline(always)]
    fn place(&self) -> Vec3A {
        Vec3A::from(self.low) + Vec3A::from(self.high)
    }
}

/// A box in single precision.
#[derive(Clone, Copy, Debug)]
pub(super) struct Around {
    pub(super) low: Vec3A,
    pub(super) high: Vec3A,
}

impl Around {
    /// Nothing.
    pub(super) const NOTHING: Self = Self { low: Vec3A::INFINITY, high: Vec3A::NEG_INFINITY };

    /// The box around both.
    #[inline(always)]
    pub(super) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Half its surface, `scale` times as large along each axis: boxes may be so small that single precision has no
    /// number for it.
    #[inline(always)]
    fn half_area(self, scale: f32) -> f32 {
        let size = (self.high - self.low) * scale;
        size.dot(Vec3A::new(size.y, size.z, size.x))
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

/// What is around items, and around their places.
#[derive(Clone, Copy)]
struct Extent {
    bounds: Around,
    places: Around,
}

impl Extent {
    const NOTHING: Self = Self { bounds: Around::NOTHING, places: Around::NOTHING };

    fn of(items: &[Item]) -> Self {
        items.iter().fold(Self::NOTHING, Self::with)
    }

    /// What makes its longest side 1; finite.
    #[inline(always)]
    fn scale(&self) -> f32 {
        (self.bounds.high - self.bounds.low).max_element().max(f32::MIN_POSITIVE).recip()
    }

    #[inline(always)]
    fn with(self, item: &Item) -> Self {
        let place = item.place();
        Self {
            bounds: self.bounds.union(item.around()),
            places: self.places.union(Around { low: place, high: place }),
        }
    }
}

/// A part of the items: where it starts among all, and how far it extends.
struct Part<'a> {
    first: usize,
    items: &'a mut [Item],
    extent: Extent,
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
    F: Fn(&[(Around, Child)]) -> Node + Sync,
{
    let extent = Extent::of(items);
    let whole = if longest == 1 && items.len() > VERY_MANY { WIDTH } else { longest };
    let mut nodes = Vec::with_capacity(items.len() / longest / FULL + 1);
    grow(Part { first: 0, items, extent }, [0; 2], Plan { longest, whole }, node, &mut nodes);
    nodes
}

/// Appends the subtree of a part and answers its number. It is so deep in the tree, and below so many parts
/// that are built beside others.
fn grow<F>(part: Part, [depth, beside]: [u32; 2], plan: Plan, node: &F, nodes: &mut Vec<Node>) -> u32
where
    F: Fn(&[(Around, Child)]) -> Node + Sync,
{
    let number = nodes.len();
    let many = (MANY..VERY_MANY).contains(&part.items.len()) && beside < LEVELS_BESIDE;
    let beside = beside + u32::from(many);
    let parts = parts(part, depth, plan);
    let mut children: SmallVec<[(Around, Child); WIDTH]> = SmallVec::new();
    // Its place is taken before its children's.
    nodes.push(Node::EMPTY);
    let subtrees: Vec<(Around, Result<Child, Vec<Node>>)> = if many {
        let grown = |part: Part| {
            let bounds = part.extent.bounds;
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
            let bounds = part.extent.bounds;
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
            parts.push(Part { first: part.first + place, extent: Extent::of(items), items });
        }
        return parts;
    }
    let scale = part.extent.scale();
    parts.push(part);
    while parts.len() < WIDTH {
        let largest = (0..parts.len()).filter(|&i| parts[i].items.len() > plan.whole).max_by(|&a, &b| {
            let area = |i: usize| parts[i].extent.bounds.half_area(scale);
            area(a).total_cmp(&area(b))
        });
        let Some(largest) = largest else {
            break;
        };
        let halves = split(parts.swap_remove(largest), depth, plan);
        parts.extend(halves);
    }
    parts
}

/// Two parts, neither empty.
fn split(Part { first, items, extent }: Part, depth: u32, plan: Plan) -> [Part; 2] {
    let packed = plan.whole > plan.longest && items.len() <= PACKED;
    let best = match items.len() {
        _ if depth >= DEPTH_OF_HEURISTIC || packed => None,
        ..=FEW => best_cut::<FEW>(items, extent),
        _ => best_cut::<BINS>(items, extent),
    };
    let (middle, extents) = match best {
        Some(cut) => partition(items, |item| cut.is_before(item)),
        None => {
            let axis = (extent.places.high - extent.places.low).max_position();
            let half = if packed { (items.len() / 2).next_multiple_of(WIDTH) } else { items.len() / 2 };
            items.select_nth_unstable_by(half, |a, b| {
                a.place()[axis].total_cmp(&b.place()[axis]).then(a.number.cmp(&b.number))
            });
            (half, [Extent::of(&items[..half]), Extent::of(&items[half..])])
        }
    };
    let (left, right) = items.split_at_mut(middle);
    [
        Part { first, items: left, extent: extents[0] },
        Part { first: first + middle, items: right, extent: extents[1] },
    ]
}

/// Between which slices of which axis to cut.
#[derive(Clone, Copy)]
struct Cut {
    axis: usize,
    slices: Slices,
    bin: usize,
}

impl Cut {
    /// Whether a place is in a slice before the cut, as [`Slices::of`] counts them.
    #[inline(always)]
    fn is_before(&self, item: &Item) -> bool {
        let place = item.low[self.axis] + item.high[self.axis];
        (place - self.slices.origin[self.axis]) * self.slices.scale[self.axis] < self.bin as f32
    }
}

/// Slices of equal width along each axis.
#[derive(Clone, Copy)]
struct Slices {
    origin: Vec3A,
    scale: Vec3A,
    /// The number of the last one.
    last: Vec3A,
}

impl Slices {
    /// The numbers of the slices that a place is in. What has no size along an axis is all in the same.
    #[inline(always)]
    fn of(&self, place: Vec3A) -> [usize; 3] {
        let numbers = ((place - self.origin) * self.scale).min(self.last).max(Vec3A::ZERO);
        [numbers.x as usize, numbers.y as usize, numbers.z as usize]
    }
}

/// The cut with the least expected work; `None` where all places coincide.
fn best_cut<const MOST: usize>(items: &[Item], extent: Extent) -> Option<Cut> {
    widest(
        #[inline(always)]
        || {
            let count = items.len().clamp(FEWEST_BINS, MOST);
            let Extent { places, .. } = extent;
            let scale = count as f32 / (places.high - places.low);
            let whole = extent.scale();
            let slices = Slices { origin: places.low, scale, last: Vec3A::splat((count - 1) as f32) };
            let mut bins = [[(0usize, Around::NOTHING); MOST]; 3];
            for item in items.iter().step_by(items.len().div_ceil(ASKED)) {
                let (numbers, around) = (slices.of(item.place()), item.around());
                for axis in 0..3 {
                    let (count, bounds) = &mut bins[axis][numbers[axis] % MOST];
                    *count += 1;
                    *bounds = bounds.union(around);
                }
            }
            let mut best = None;
            let mut least = f32::INFINITY;
            for axis in 0..3 {
                if !scale[axis].is_finite() {
                    continue;
                }
                let bins = &bins[axis][..count];
                // The cost of everything to the right of each cut, then of everything to the left.
                let mut right = [0.0; MOST];
                let mut all = (0, Around::NOTHING);
                for bin in (1..count).rev() {
                    right[bin] = cost(&mut all, bins[bin], whole);
                }
                let mut all = (0, Around::NOTHING);
                for bin in 1..count {
                    let left = cost(&mut all, bins[bin - 1], whole);
                    // A side without items has no cost of its own and is no cut.
                    if left > 0.0 && right[bin] > 0.0 && left + right[bin] < least {
                        least = left + right[bin];
                        best = Some((axis, bin));
                    }
                }
            }
            best.map(|(axis, bin)| Cut { axis, slices, bin })
        },
    )
}

/// Adds a slice to others and answers the cost of them all: their number of items times the area around them, `scale`
/// times as large.
#[inline(always)]
fn cost(all: &mut (usize, Around), (more, around): (usize, Around), scale: f32) -> f32 {
    all.0 += more;
    all.1 = all.1.union(around);
    // Flat boxes have no area but still cost a test.
    if all.0 == 0 { 0.0 } else { all.0 as f32 * all.1.half_area(scale).max(f32::MIN_POSITIVE) }
}

/// Moves the items that pass to the front; answers how many there are, and how far they and the others extend.
fn partition(items: &mut [Item], pass: impl Fn(&Item) -> bool) -> (usize, [Extent; 2]) {
    let (mut front, mut back) = (0, items.len());
    let (mut passing, mut others) = (Extent::NOTHING, Extent::NOTHING);
    loop {
        while front < back && pass(&items[front]) {
            passing = passing.with(&items[front]);
            front += 1;
        }
        while front < back && !pass(&items[back - 1]) {
            others = others.with(&items[back - 1]);
            back -= 1;
        }
        if front == back {
            return (front, [passing, others]);
        }
        items.swap(front, back - 1);
    }
}
