//! Eight boxes side by side, in single precision, and the test of a ray against them.

use glam::Vec4;

use super::bvh::LEAF;
use crate::math::{Bounds, DVec3};

/// Children of a node.
pub(super) const WIDTH: usize = 8;

/// Bound on the rounding errors of single precision tests, relative to the terms of each.
pub(super) const SLACK: f32 = 8.0 * f32::EPSILON;

/// Directions are kept away from zero, so that no slab's distance is 0 · ∞.
const LEAST_DIRECTION: Vec4 = Vec4::splat(1e-30);

/// Rays that start so near, in the space of the boxes, need not be moved up to them.
pub(super) const NEAR: f64 = 8.0;

/// The longest components of directions that need not be scaled.
const LEAST_SPAN: Vec4 = Vec4::new(1e-3, 1e-3, 1e-3, f32::INFINITY);
const GREATEST_SPAN: Vec4 = Vec4::splat(1e3);

/// One number of each child of a node, side by side.
pub(super) type Lanes = [Vec4; 2];

/// Missing children have empty boxes.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct Node {
    /// Along each axis the low faces and the high ones.
    faces: [[Lanes; 2]; 3],
    pub(super) children: [u32; WIDTH],
}

impl Node {
    /// No children yet.
    pub(super) const EMPTY: Self = {
        let axis = [[Vec4::INFINITY; 2], [Vec4::NEG_INFINITY; 2]];
        Self { faces: [axis; 3], children: [u32::MAX; WIDTH] }
    };

    /// Gives a child to a lane that has none.
    pub(super) fn set(&mut self, lane: usize, child: u32, low: [f32; 3], high: [f32; 3]) {
        self.children[lane] = child;
        for axis in 0..3 {
            self.faces[axis][0][lane / 4][lane % 4] = low[axis];
            self.faces[axis][1][lane / 4][lane % 4] = high[axis];
        }
    }

    /// The box of a child, empty where there is none.
    pub(super) fn bounds(&self, lane: usize) -> Bounds {
        let corner = |side: usize| {
            let [x, y, z] = self.faces.map(|faces| f64::from(faces[side][lane / 4][lane % 4]));
            DVec3::new(x, y, z)
        };
        Bounds { min: corner(0), max: corner(1) }
    }

    /// The same node in a tree whose numbers start at `offset`.
    pub(super) fn moved(mut self, offset: u32) -> Self {
        for child in self.children.iter_mut().filter(|child| **child & LEAF == 0) {
            *child += offset;
        }
        self
    }

    /// The bits of the children whose boxes a point may be in.
    #[inline(always)]
    pub(super) fn around(&self, low: [f32; 3], high: [f32; 3]) -> u32 {
        let mut around = !0;
        for axis in 0..3 {
            let [first, last] = &self.faces[axis];
            let (low, high) = (Vec4::splat(low[axis]), Vec4::splat(high[axis]));
            let within = |half: usize| (first[half].cmple(high) & last[half].cmpge(low)).bitmask();
            around &= within(0) | within(1) << 4;
        }
        around
    }
}

/// A ray in the space of the boxes.
pub(super) struct Probe {
    origin: Vec4,
    direction: Vec4,
    /// The origin, moved so far that rounding can't turn a hit into a miss: once for planes that
    /// bound the near end of the overlap, once for those that bound the far end.
    near: Vec4,
    far: Vec4,
    inverse: Vec4,
    /// Whether a node's high faces are met first along each axis.
    backward: [bool; 3],
}

impl Probe {
    #[inline(always)]
    pub(super) fn new(origin: DVec3, direction: DVec3, blur: f32) -> Self {
        let origin = Vec4::new(origin.x as f32, origin.y as f32, origin.z as f32, 0.0);
        let direction = Vec4::new(direction.x as f32, direction.y as f32, direction.z as f32, 1.0);
        let inverse = direction.abs().max(LEAST_DIRECTION).copysign(direction).recip();
        let room = (origin.abs() * SLACK + blur).copysign(inverse);
        let backward = inverse.is_negative_bitmask();
        Self {
            origin,
            direction,
            near: origin + room,
            far: origin - room,
            inverse,
            backward: [backward & 1 != 0, backward & 2 != 0, backward & 4 != 0],
        }
    }

    /// Whether it starts near the boxes, and its direction is neither very long nor very short.
    #[inline(always)]
    pub(super) fn is_tame(&self) -> bool {
        let span = self.direction.abs();
        let within = self.origin.abs().cmple(Vec4::splat(NEAR as f32)) & span.cmple(GREATEST_SPAN);
        within.all() & span.cmpge(LEAST_SPAN).any()
    }

    /// Whether it is a ray at all: only finite ones miss the boxes of missing children.
    pub(super) fn is_sound(&self) -> bool {
        (self.near * self.inverse * self.direction).is_finite()
    }

    /// Entry distances, none negative, and the bits of the boxes met before `far`.
    #[inline(always)]
    pub(super) fn test(&self, node: &Node, far: f32) -> (Lanes, u32) {
        let (mut entry, mut exit) = ([Vec4::ZERO; 2], [Vec4::splat(far); 2]);
        let (starts, ends) = (self.near.to_array(), self.far.to_array());
        let inverses = self.inverse.to_array();
        // Loops throughout: closures given to arrays' methods are not compiled for wide registers.
        for axis in 0..3 {
            let backward = self.backward[axis];
            let first = &node.faces[axis][usize::from(backward)];
            let last = &node.faces[axis][usize::from(!backward)];
            let (start, end) = (Vec4::splat(starts[axis]), Vec4::splat(ends[axis]));
            let inverse = Vec4::splat(inverses[axis]);
            for half in 0..2 {
                entry[half] = ((first[half] - start) * inverse).max(entry[half]);
                exit[half] = ((last[half] - end) * inverse).min(exit[half]);
            }
        }
        let room = Vec4::splat(1.0 + 2.0 * SLACK);
        let met = |half: usize| entry[half].cmple(exit[half] * room).bitmask();
        (entry, met(0) | met(1) << 4)
    }
}
