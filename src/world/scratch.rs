//! Buffers for the crossings of a ray, kept by each thread so that no ray allocates.

use std::cell::RefCell;

use super::csg::Near;
use super::shape::Crossing;

/// A crossing and the leaf it belongs to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) crossing: Crossing,
    pub(super) leaf: u32,
    /// The leaf's place among the members near the ray, where it is part of an object of many.
    pub(super) near: u32,
}

impl Found {
    pub(super) fn t(&self) -> f64 {
        self.crossing.t
    }
}

/// Room for one ray's crossings.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    /// Of the leaf at hand.
    pub(super) crossings: Vec<Crossing>,
    /// Of the object at hand.
    pub(super) found: Vec<Found>,
    /// Members of the object at hand that are near the ray.
    pub(super) near: Vec<Near>,
}

thread_local! {
    static SPARE: RefCell<Vec<Scratch>> = const { RefCell::new(Vec::new()) };
}

impl Scratch {
    /// Lends a buffer; calls may nest.
    pub(super) fn lend<R>(f: impl FnOnce(&mut Self) -> R) -> R {
        let mut scratch = SPARE.with_borrow_mut(Vec::pop).unwrap_or_default();
        let result = f(&mut scratch);
        SPARE.with_borrow_mut(|spare| spare.push(scratch));
        result
    }
}
