//! Rays that travel together: what a pencil of them may meet is found once, and four of its rays at a time are
//! held against the boxes of that.

use std::ops::Range as Span;

use glam::Vec4;

use super::bvh::{Bvh, LEAF, Measure, Traveller, run};
use super::node::{self, NEAR, Node, SLACK, WIDTH};
use crate::math::{Bounds, DVec3, Lanes, tally};
use crate::world::ray::Rays;

/// Beyond so many boxes a pencil is too wide to be worth while.
const MOST: usize = 24;

/// Rays are not followed farther than so many times their way from one box of the pencil to the other.
const LAST: f32 = 1e30;

/// The longest component of a direction may be so long, or as many times shorter, to go with others.
const MOST_SPAN: f64 = 1e3;

/// Slopes are kept away from zero, so that none has an infinite inverse.
const LEAST_SLOPE: f32 = 1e-30;

/// The same for distances that are taken for shorter than they are.
const NEARER: f64 = 0.999;

/// Makes up for rounding in single precision.
const UP: f64 = 1.0 + 4.0 * SLACK as f64;

/// All rays that start in a box and go through a point of another.
#[derive(Clone, Copy, Debug)]
pub struct Pencil {
    /// Where they start.
    pub from: Bounds,
    /// Where they go through.
    pub through: Bounds,
    /// Whether they end there.
    pub ends: bool,
}

/// The square of the least distance of which rays have a direction.
const LEAST_SQUARE: f64 = 1e-200;

/// Boxes around rays are larger than computed by this share of their coordinates, more than rounding takes.
const ROOM: f64 = 1e-12;

/// Rays along a direction are followed for so many times the size of the box where they start before they are taken to
/// come apart.
const FAR: f64 = 1e4;

impl Pencil {
    /// All rays from a box through another, and on; `None` where rays may start where they go through.
    pub fn new(from: Bounds, through: Bounds) -> Option<Self> {
        let room = |bounds: Bounds| {
            let room = ROOM * bounds.min.abs().max(bounds.max.abs()).max_element();
            Bounds { min: bounds.min - room, max: bounds.max + room }
        };
        let (from, through) = (room(from), room(through));
        let apart = (through.min - from.max).max(from.min - through.max).max(DVec3::ZERO);
        (apart.length_squared() > LEAST_SQUARE).then_some(Self { from, through, ends: false })
    }

    /// All rays from a box, whose unit directions are in another.
    pub fn along(from: Bounds, directions: Bounds) -> Option<Self> {
        let size = from.size().max_element();
        let length = if size > 0.0 { FAR * size } else { 1.0 + from.min.abs().max_element() };
        let through =
            Bounds { min: from.min + length * directions.min, max: from.max + length * directions.max };
        Self::new(from, through)
    }

    /// What becomes of rays that don't end where a plane mirrors them, as if they came from behind it: the plane of a
    /// unit normal, at a distance from the origin along it.
    pub fn mirrored(&self, normal: DVec3, distance: f64) -> Option<Self> {
        let mirrored = |point: DVec3| point - 2.0 * (normal.dot(point) - distance) * normal;
        let mirror = |bounds: Bounds| Bounds::of(bounds.corners().map(mirrored));
        Self::new(mirror(self.from), mirror(self.through))
    }
}

/// What the rays of a pencil may meet, the nearest first.
#[derive(Debug, Default)]
pub struct Within {
    items: Vec<Boxed>,
    /// The space of the boxes.
    center: DVec3,
    scale: f64,
}

impl Within {
    /// The items.
    #[inline]
    pub fn items(&self) -> &[Boxed] {
        &self.items
    }

    /// Whether rays may start at a point: it is not too far from the boxes.
    #[inline]
    pub fn holds(&self, point: DVec3) -> bool {
        ((point - self.center) * self.scale).abs().max_element() < NEAR
    }
}

/// An item, and a box around it in the space of the tree, large enough to make up for the rounding of rays.
#[derive(Clone, Copy, Debug)]
pub struct Boxed {
    low: [f32; 3],
    high: [f32; 3],
    /// No ray of the pencil enters it at a shorter distance.
    pub entry: f64,
    /// The item.
    pub number: u32,
}

impl Boxed {
    /// An item in a lane of a node, with so much room around its box.
    fn new(node: &Node, lane: usize, room: f32, entry: f64, number: u32) -> Self {
        let corner = |side: usize, room: f32| {
            let face = |axis: usize| node.faces(axis)[side][lane] + room;
            [face(0), face(1), face(2)]
        };
        Self { low: corner(0, -room), high: corner(1, room), entry, number }
    }
}

/// The border of a pencil on one side of an axis, by a parameter that grows along it.
#[derive(Clone, Copy)]
struct Edge {
    start: f32,
    inverse: f32,
}

impl Edge {
    /// From a place along the axis on, on the upper side or, with -1, on the lower one.
    #[inline(always)]
    fn new(start: f64, slope: f32, side: f32) -> Self {
        let slope = slope.abs().max(LEAST_SLOPE).copysign(slope);
        let start = start as f32;
        // In single precision the start may be off by a part of it.
        Self { start: start + side * SLACK * start.abs(), inverse: slope.recip() }
    }
}

/// A piece of a pencil whose borders are straight: along each axis the upper edge and the lower one.
struct Piece {
    edges: [[Edge; 2]; 3],
    /// The parameter at its end.
    length: f32,
}

impl Piece {
    /// From one box to another, where the parameter is 1.
    fn new(from: Bounds, to: Bounds, length: f32) -> Self {
        let edges = |axis: usize| {
            let edge = |start: f64, end: f64, side: f32| Edge::new(start, (end - start) as f32, side);
            [edge(from.max[axis], to.max[axis], 1.0), edge(from.min[axis], to.min[axis], -1.0)]
        };
        Self { edges: [edges(0), edges(1), edges(2)], length }
    }

    /// Where it enters a node's boxes, and the bits of those that it meets.
    #[inline(always)]
    fn test(&self, node: &Node, length: f32) -> (node::Lanes, u32) {
        let (mut entry, mut exit) = ([0.0; WIDTH], [length; WIDTH]);
        // Loops over all lanes: so they are compiled for wide registers.
        for axis in 0..3 {
            for side in 0..2 {
                // The upper edge has to be above the low faces, the lower one below the high ones.
                let Edge { start, inverse } = self.edges[axis][side];
                let faces = &node.faces(axis)[side];
                if (inverse > 0.0) == (side == 0) {
                    for lane in 0..WIDTH {
                        let passed = (faces[lane] - start) * inverse;
                        entry[lane] = if passed > entry[lane] { passed } else { entry[lane] };
                    }
                } else {
                    for lane in 0..WIDTH {
                        let passed = (faces[lane] - start) * inverse;
                        exit[lane] = if passed < exit[lane] { passed } else { exit[lane] };
                    }
                }
            }
        }
        (entry, node::met(&entry, &exit))
    }
}

/// Four rays in the space of a tree: along each axis where they start, and the inverse of where they go.
pub struct Four {
    origin: [Vec4; 3],
    inverse: [Vec4; 3],
    scale: f64,
}

impl Four {
    /// Rays of the pencil that `within` was found for, with unit directions.
    #[inline(always)]
    pub fn new(rays: &Rays, within: &Within) -> Self {
        let mut four = Self { origin: [Vec4::ZERO; 3], inverse: [Vec4::ZERO; 3], scale: within.scale };
        for (axis, center) in within.center.to_array().into_iter().enumerate() {
            let from = single((rays.origin[axis] - center) * within.scale);
            let slope = single(rays.direction[axis]);
            four.origin[axis] = from;
            four.inverse[axis] = slope.abs().max(Vec4::splat(LEAST_SLOPE)).copysign(slope).recip();
        }
        four
    }

    /// The bits of those that meet a box before their ends.
    #[inline(always)]
    pub fn meet(&self, boxed: &Boxed, ends: &Lanes) -> u32 {
        tally::boxes(Lanes::COUNT);
        let ends = single(*ends * (self.scale * UP)) + Vec4::splat(f32::MIN_POSITIVE);
        let (mut entry, mut exit) = (Vec4::ZERO, ends);
        for axis in 0..3 {
            let low = (Vec4::splat(boxed.low[axis]) - self.origin[axis]) * self.inverse[axis];
            let high = (Vec4::splat(boxed.high[axis]) - self.origin[axis]) * self.inverse[axis];
            entry = low.min(high).max(entry);
            exit = low.max(high).min(exit);
        }
        entry.cmple(exit * (1.0 + 2.0 * SLACK)).bitmask()
    }
}

/// Four numbers in single precision.
#[inline(always)]
fn single(lanes: Lanes) -> Vec4 {
    let [a, b, c, d] = lanes.0;
    Vec4::new(a as f32, b as f32, c as f32, d as f32)
}

/// What encloses four rays: at each distance along them all their places.
struct Sheaf {
    piece: Piece,
    place: Measure,
}

impl Traveller for Sheaf {
    #[inline(always)]
    fn end(&self, t: f64) -> f32 {
        self.place.end(t)
    }

    #[inline(always)]
    fn test(&self, node: &Node, far: f32) -> (node::Lanes, u32) {
        self.piece.test(node, far)
    }
}

/// The least and the greatest of four; no numbers if one is none.
#[inline(always)]
fn extremes(lanes: Lanes) -> [f64; 2] {
    let [a, b, c, d] = lanes.0;
    let nothing = 0.0 * (a + b + c + d);
    let less = |a: f64, b: f64| if b < a { b } else { a };
    let more = |a: f64, b: f64| if b > a { b } else { a };
    [less(less(a, b), less(c, d)) + nothing, more(more(a, b), more(c, d)) + nothing]
}

impl Bvh {
    /// What encloses four rays, in the space of the tree; `None` where they start far off, or go too fast or slowly.
    #[inline(always)]
    fn sheaf(&self, rays: &Rays) -> Option<Sheaf> {
        let (center, scale) = self.place();
        let blur = f64::from(self.blur());
        let mut edges = [[Edge { start: 0.0, inverse: 0.0 }; 2]; 3];
        let (mut near, mut span) = (!self.nodes().is_empty(), 0.0);
        for axis in 0..3 {
            let [low, high] = extremes((rays.origin[axis] - center[axis]) * scale);
            let [least, most] = extremes(rays.direction[axis]);
            near &= (-NEAR < low) & (high < NEAR) & (least.abs() < MOST_SPAN) & (most.abs() < MOST_SPAN);
            span = most.max(-least).max(span);
            edges[axis] =
                [Edge::new(high + blur, most as f32, 1.0), Edge::new(low - blur, least as f32, -1.0)];
        }
        let place = Measure { start: 0.0, scale };
        let piece = Piece { edges, length: f32::INFINITY };
        (near && span > MOST_SPAN.recip()).then_some(Sheaf { piece, place })
    }

    /// As [`Bvh::runs_along_four`], for items that are no runs.
    #[inline(always)]
    pub fn along_four(&self, rays: &Rays, end: f64, mut visit: impl FnMut(u32) -> f64) -> bool {
        let Some(sheaf) = self.sheaf(rays) else { return false };
        self.search(
            &sheaf,
            end,
            #[inline(always)]
            |leaf| visit(leaf & !LEAF),
        );
        true
    }

    /// Calls `visit` with the runs of items that any of four rays may meet ahead before `end`, roughly the nearest
    /// first; it answers with a new end, negative infinity to stop. Whether they could be asked together.
    #[inline(always)]
    pub fn runs_along_four(&self, rays: &Rays, end: f64, mut visit: impl FnMut(Span<usize>) -> f64) -> bool {
        let Some(sheaf) = self.sheaf(rays) else { return false };
        self.search(
            &sheaf,
            end,
            #[inline(always)]
            |leaf| visit(run(leaf)),
        );
        true
    }

    /// All items, for any rays.
    pub fn all(&self) -> Within {
        let (center, scale) = self.place();
        let mut items = Vec::new();
        for node in self.nodes() {
            for (lane, &child) in node.children.iter().enumerate().filter(|&(_, &child)| child != u32::MAX) {
                items.extend(
                    super::bvh::item(child).map(|item| Boxed::new(node, lane, self.room(), 0.0, item)),
                );
            }
        }
        Within { items, center, scale }
    }

    /// What boxes are enlarged by for the rounding of rays that start near.
    fn room(&self) -> f32 {
        self.blur() + NEAR as f32 * SLACK
    }

    /// Whether the items that rays of a pencil may meet are few enough to be listed in `within`.
    pub fn within(&self, pencil: &Pencil, within: &mut Within) -> bool {
        (within.center, within.scale) = self.place();
        let items = &mut within.items;
        items.clear();
        let inner = |bounds: Bounds| Bounds { min: self.inner(bounds.min), max: self.inner(bounds.max) };
        let (from, through) = (inner(pencil.from), inner(pencil.through));
        let tame = from.min.abs().max(from.max.abs()).max_element() < NEAR && through.is_finite();
        if self.nodes().is_empty() || !tame {
            return self.nodes().is_empty();
        }
        let blur = DVec3::splat(f64::from(self.blur()));
        let wide = |bounds: Bounds| Bounds { min: bounds.min - blur, max: bounds.max + blur };
        let apart = (through.min - from.max).max(from.min - through.max).max(DVec3::ZERO).length();
        let unit = apart / within.scale * NEARER;
        let (from, through) = (wide(from), wide(through));
        // Beyond the second box the borders are those of rays from the other side of the first.
        let beyond = |near: DVec3, far: DVec3| far + (far - near);
        let opposite = Bounds { min: beyond(from.max, through.min), max: beyond(from.min, through.max) };
        let near_piece = Piece::new(from, through, 1.0);
        let far_piece = (!pencil.ends).then(|| Piece::new(through, opposite, LAST));
        let room = self.room();
        let mut stack = smallvec::SmallVec::<[u32; 32]>::new();
        stack.push(0);
        while let Some(number) = stack.pop() {
            let node = &self.nodes()[number as usize];
            let (near, first) = near_piece.test(node, near_piece.length);
            let (far, second) =
                far_piece.as_ref().map_or(([0.0; WIDTH], 0), |piece| piece.test(node, piece.length));
            tally::boxes(WIDTH);
            let mut met = first | second;
            while met != 0 {
                let lane = met.trailing_zeros() as usize % WIDTH;
                met &= met - 1;
                let child = node.children[lane];
                let Some(item) = super::bvh::item(child) else {
                    stack.push(child);
                    continue;
                };
                if items.len() == MOST {
                    return false;
                }
                let entry = if first >> lane & 1 == 1 { near[lane] } else { 1.0 + far[lane] };
                items.push(Boxed::new(node, lane, room, f64::from(entry) * unit, item));
            }
        }
        items.sort_unstable_by(|a, b| a.entry.total_cmp(&b.entry));
        true
    }
}
