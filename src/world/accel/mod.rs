//! What finds the boxes near a ray or around a point: every kind gives the same answers.
//!
//! An item is a number of the caller's. Tests are conservative: an item may be named although its
//! box is missed by a hair, but none whose box is met is ever left out.

mod build;
mod bvh;
mod hull;
mod linear;
mod node;
mod octree;
mod pencil;
#[cfg(test)]
mod tests;

pub use bvh::Bvh;
pub use hull::{Hull, Points};
pub use linear::{Linear, Slabs};
pub use octree::Octree;
pub use pencil::{Four, Pencil, Within};

use super::ray::{Range, Ray};
use crate::math::{Bounds, DVec3};
use crate::options::Accelerator;

/// Up to this many items are simply gone through.
const FEW: usize = 6;

/// A set of boxes with numbers.
#[derive(Debug)]
pub enum Accel {
    /// Asks one after the other.
    Linear(Linear),
    /// Cells of space.
    Octree(Octree),
    /// A tree of boxes.
    Bvh(Bvh),
}

impl Accel {
    /// Takes items with their boxes. Unbounded boxes are only allowed in [`Linear`] sets: keep
    /// them apart where they are few among many.
    pub fn new<I: IntoIterator<Item = (Bounds, u32), IntoIter: Clone>>(items: I, kind: Accelerator) -> Self {
        let items = items.into_iter();
        let (mut bounded, mut count) = (true, 0);
        for (bounds, _) in items.clone() {
            bounded &= bounds.is_finite();
            count += 1;
        }
        match kind {
            Accelerator::Auto if bounded && count > FEW => Self::Bvh(Bvh::new(items)),
            Accelerator::Bvh if bounded && count > 0 => Self::Bvh(Bvh::new(items)),
            Accelerator::Octree if bounded && count > 0 => Self::Octree(Octree::new(items.collect())),
            _ => Self::Linear(Linear::new(items.collect())),
        }
    }

    /// Calls `visit` with the items whose boxes meet the ray in `range`, roughly the nearest first.
    /// It answers with the new far end of the range; negative infinity ends the search.
    #[inline(always)]
    pub fn along(&self, ray: &Ray, range: Range, visit: impl FnMut(u32) -> f64) {
        match self {
            Self::Linear(linear) => linear.along(ray, range, visit),
            Self::Octree(octree) => octree.along(ray, range, visit),
            Self::Bvh(bvh) => bvh.along(ray, range, visit),
        }
    }

    /// Whether the items that rays of a pencil may meet are few, and were found.
    pub fn within(&self, pencil: &Pencil, within: &mut Within) -> bool {
        match self {
            Self::Bvh(bvh) => bvh.within(pencil, within),
            _ => false,
        }
    }

    /// Whether `test` holds for any of the items whose boxes meet `hull`.
    pub fn any_touching(&self, hull: &Hull, test: impl FnMut(u32) -> bool) -> bool {
        match self {
            Self::Linear(linear) => linear.any_touching(hull, test),
            Self::Octree(octree) => octree.any_touching(hull, test),
            Self::Bvh(bvh) => bvh.any_touching(hull, test),
        }
    }

    /// Whether `test` holds for any of the items whose boxes contain `point`.
    #[inline(always)]
    pub fn any_around(&self, point: DVec3, test: impl FnMut(u32) -> bool) -> bool {
        match self {
            Self::Linear(linear) => linear.any_around(point, test),
            Self::Octree(octree) => octree.any_around(point, test),
            Self::Bvh(bvh) => bvh.any_around(point, test),
        }
    }
}
