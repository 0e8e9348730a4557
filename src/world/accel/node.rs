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
pub(super) type Lanes = [f32; WIDTH];

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
        let axis = [[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]];
        Self { faces: [axis; 3], children: [u32::MAX; WIDTH] }
    };

    /// Gives a child to a lane that has none.
    pub(super) fn set(&mut self, lane: usize, child: u32, low: [f32; 3], high: [f32; 3]) {
        self.children[lane] = child;
        for axis in 0..3 {
            self.faces[axis][0][lane] = low[axis];
            self.faces[axis][1][lane] = high[axis];
        }
    }

    /// The low faces and the high ones along an axis.
    #[inline(always)]
    pub(super) fn faces(&self, axis: usize) -> &[Lanes; 2] {
        &self.faces[axis]
    }

    /// The box of a child, empty where there is none.
    pub(super) fn bounds(&self, lane: usize) -> Bounds {
        // Not by `map` of the array: that is not compiled together with what is around it.
        let face = |axis: usize, side: usize| f64::from(self.faces[axis][side][lane]);
        let corner = |side: usize| DVec3::new(face(0, side), face(1, side), face(2, side));
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
            let ([first, more_first], [last, more_last]) = (halves(first), halves(last));
            let within = first.cmple(high) & last.cmpge(low);
            let more_within = more_first.cmple(high) & more_last.cmpge(low);
            around &= within.bitmask() | more_within.bitmask() << 4;
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
        let (mut entry, mut exit) = ([0.0; WIDTH], [far; WIDTH]);
        let (starts, ends) = (self.near.to_array(), self.far.to_array());
        let inverses = self.inverse.to_array();
        // Loops over all lanes, and no closures of arrays' methods: so they are compiled for wide registers.
        for axis in 0..3 {
            let backward = self.backward[axis];
            let first = &node.faces[axis][usize::from(backward)];
            let last = &node.faces[axis][usize::from(!backward)];
            let (start, end, inverse) = (starts[axis], ends[axis], inverses[axis]);
            for lane in 0..WIDTH {
                let enter = (first[lane] - start) * inverse;
                entry[lane] = if enter > entry[lane] { enter } else { entry[lane] };
                let leave = (last[lane] - end) * inverse;
                exit[lane] = if leave < exit[lane] { leave } else { exit[lane] };
            }
        }
        (entry, met(&entry, &exit))
    }
}

/// The bits of the boxes that are entered before they are left, or nearly.
#[inline(always)]
pub(super) fn met(entry: &Lanes, exit: &Lanes) -> u32 {
    let room = Vec4::splat(1.0 + 2.0 * SLACK);
    let ([near, more_near], [leave, more_leave]) = (halves(entry), halves(exit));
    let (met, more_met) = (near.cmple(leave * room), more_near.cmple(more_leave * room));
    met.bitmask() | more_met.bitmask() << 4
}

#[inline(always)]
fn halves(lanes: &Lanes) -> [Vec4; 2] {
    let [a, b, c, d, e, f, g, h] = *lanes;
    [Vec4::new(a, b, c, d), Vec4::new(e, f, g, h)]
}
