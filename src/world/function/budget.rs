//! What keeps a function from running for ever: its sums may be endless, and it may call itself.

use std::cell::Cell;

/// What one evaluation may spend. When nothing is left everything comes to its end, and the value is
/// NaN: so a picture is finished whatever its functions do, and is the same with any number of threads.
#[derive(Debug, Default)]
pub struct Budget {
    steps: Cell<u32>,
    depth: Cell<u32>,
    too_deep: Cell<bool>,
    /// Calls of bands.
    calls: Cell<u32>,
}

/// Stack that must be left, and how much is added when it is not.
const RED_ZONE: usize = 64 << 10;
const MORE: usize = 1 << 20;

impl Budget {
    /// Terms of `sum` and `prod`, and calls of functions, in one evaluation: about half a second.
    pub const STEPS: u32 = 50_000_000;

    /// Calls of itself that a function may have open. POV-Ray's memory is corrupt after 1000.
    pub const DEPTH: u32 = 1000;

    /// What a call costs that may be one of itself.
    const CALL: u32 = 4;

    /// Whether an evaluation came to an end because it called itself too deep.
    pub fn is_too_deep(&self) -> bool {
        self.too_deep.get()
    }

    /// Whether an evaluation came to an end because it took too many steps.
    pub fn is_spent(&self) -> bool {
        self.steps.get() >= Self::STEPS
    }

    /// The steps an evaluation took.
    pub fn spent(&self) -> u64 {
        self.steps.get().into()
    }

    /// Takes a step, if one is left.
    pub(super) fn spend(&self) -> bool {
        self.take(1)
    }

    fn take(&self, count: u32) -> bool {
        let steps = self.steps.get();
        if steps >= Self::STEPS {
            return false;
        }
        self.steps.set(steps + count);
        true
    }

    /// Goes one call deeper where bands are asked for, both ways of every choice that is in doubt; `None` soon, as
    /// nothing may come to an end there.
    pub(super) fn a_little_deeper<T>(&self, call: impl FnOnce() -> T) -> Option<T> {
        /// Calls of itself that a function may have open, and calls in all.
        const DEPTH: u32 = 64;
        const CALLS: u32 = 128;
        let depth = self.depth.get();
        let calls = self.calls.get();
        if depth >= DEPTH || calls >= CALLS {
            return None;
        }
        self.calls.set(calls + 1);
        self.depth.set(depth + 1);
        let value = stacker::maybe_grow(RED_ZONE, MORE, call);
        self.depth.set(depth);
        Some(value)
    }

    /// Goes one call deeper, with stack to spare; NaN where that is too deep.
    pub(super) fn deeper(&self, call: impl FnOnce() -> f64) -> f64 {
        let depth = self.depth.get();
        if depth >= Self::DEPTH {
            self.too_deep.set(true);
            // Others that wait for their turn need not try.
            self.steps.set(Self::STEPS);
        }
        if !self.take(Self::CALL) {
            return f64::NAN;
        }
        self.depth.set(depth + 1);
        let value = stacker::maybe_grow(RED_ZONE, MORE, call);
        self.depth.set(depth);
        value
    }
}
