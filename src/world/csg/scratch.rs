//! Buffers for the crossings of a ray, kept by each thread so that no ray allocates.

use std::cell::RefCell;

use crate::world::object::Member;
use crate::world::parts::Operation;
use crate::world::shape::Crossing;

/// A member near a ray. Those below a compound follow it, up to `end`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub(super) member: Member,
    /// How a compound combines what is below.
    pub(super) operation: Option<Operation>,
    /// Whether clips take a part of it.
    pub(super) clipped: bool,
    /// The compound it is part of, by its place among the members near the ray. Compounds that nothing else of is
    /// near are passed over: they neither keep nor take anything.
    pub(super) parent: Option<u32>,
    /// Its own place, or that of the outermost compound between, by which the parent knows it.
    pub(super) outer: u32,
    /// Its own place, or that of what is the only member near the ray, of which the same holds.
    pub(super) inner: u32,
    /// Behind the last of those below.
    pub(super) end: u32,
    pub(super) inside: Inside,
}

/// How to tell whether a point of the ray is inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Inside {
    /// It is between these distances, or is not.
    Between { enter: f64, leave: f64, inverted: bool },
    /// Everywhere the same.
    Constant(bool),
    /// Nowhere, but there is a surface that others may contain.
    Surface,
    /// The geometry knows.
    Point,
    /// By the members below; all others don't decide.
    Members,
}

/// A crossing and the leaf it belongs to.
#[derive(Clone, Copy, Debug)]
pub(in crate::world) struct Found {
    pub(in crate::world) crossing: Crossing,
    pub(in crate::world) leaf: u32,
    /// The leaf's place among the members near the ray, where it is part of an object of many.
    pub(super) near: u32,
}

impl Found {
    #[inline]
    pub(in crate::world) fn t(&self) -> f64 {
        self.crossing.t
    }
}

/// Room for one ray's crossings.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    /// Of the leaf at hand.
    pub(in crate::world) crossings: Vec<Crossing>,
    /// Of the object at hand.
    pub(super) found: Vec<Found>,
    /// Members of the object at hand that are near the ray.
    pub(super) near: Vec<Near>,
    /// Length of the ray's direction.
    pub(super) length: f64,
}

thread_local! {
    #[expect(clippy::vec_box, reason = "a buffer is large, and handed out and back by value")]
    static SPARE: RefCell<Vec<Box<Scratch>>> = const { RefCell::new(Vec::new()) };
}

impl Scratch {
    /// Joins a compound with its member where only one is near the ray: solids may be nested a thousand deep.
    pub(super) fn pass_over(&mut self, place: usize) {
        let Near { clipped, parent, end, inside, .. } = self.near[place];
        let Some(member) = self.near[..end as usize].get(place + 1) else { return };
        if clipped || inside != Inside::Members || member.end != end {
            return;
        }
        let inner = member.inner;
        self.near[place].inner = inner;
        let inner = &mut self.near[inner as usize];
        (inner.parent, inner.outer) = (parent, place as u32);
    }

    /// Lends a buffer; calls may nest.
    #[inline]
    pub(super) fn lend<R>(f: impl FnOnce(&mut Self) -> R) -> R {
        let mut scratch = SPARE.with_borrow_mut(Vec::pop).unwrap_or_default();
        let result = f(&mut scratch);
        SPARE.with_borrow_mut(|spare| spare.push(scratch));
        result
    }
}
