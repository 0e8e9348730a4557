//! The stretch of a line inside a convex solid: how every convex primitive states its crossings.

use super::Crossing;
use crate::world::Range;

/// Where a line enters a convex solid and where it leaves, with `enter.t <= leave.t`.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// The first point.
    pub enter: Crossing,
    /// The last point.
    pub leave: Crossing,
}

impl Stretch {
    /// The whole line.
    pub const LINE: Self = Self {
        enter: Crossing { t: f64::NEG_INFINITY, part: 0, at: [0.0; 2] },
        leave: Crossing { t: f64::INFINITY, part: 0, at: [0.0; 2] },
    };

    /// From `enter` on `enter_part` to `leave` on `leave_part`; `None` unless they are in that order.
    #[inline]
    pub fn new(enter: f64, enter_part: u32, leave: f64, leave_part: u32) -> Option<Self> {
        (enter <= leave).then(|| Self {
            enter: Crossing::new(enter, enter_part),
            leave: Crossing::new(leave, leave_part),
        })
    }

    /// The stretch between two parallel planes at `low` and `high`, for a coordinate that starts at
    /// `origin` and grows by `direction`. The planes belong to the solid.
    #[inline]
    pub fn slab(
        (low, low_part): (f64, u32),
        (high, high_part): (f64, u32),
        origin: f64,
        direction: f64,
    ) -> Option<Self> {
        if direction == 0.0 {
            return (low <= origin && origin <= high).then_some(Self::LINE);
        }
        let (to_low, to_high) = ((low - origin) / direction, (high - origin) / direction);
        if direction > 0.0 {
            Self::new(to_low, low_part, to_high, high_part)
        } else {
            Self::new(to_high, high_part, to_low, low_part)
        }
    }

    /// What both share; where their ends coincide, `over` gives the part.
    #[inline]
    pub fn meet(self, over: Self) -> Option<Self> {
        let enter = if over.enter.t >= self.enter.t { over.enter } else { self.enter };
        let leave = if over.leave.t <= self.leave.t { over.leave } else { self.leave };
        (enter.t <= leave.t).then_some(Self { enter, leave })
    }

    /// The same stretch with distances counted from `shift` before.
    #[inline]
    pub fn shifted(mut self, shift: f64) -> Self {
        self.enter.t += shift;
        self.leave.t += shift;
        self
    }

    /// The nearer end in `range`.
    #[inline]
    pub fn nearest(self, range: Range) -> Option<Crossing> {
        [self.enter, self.leave].into_iter().find(|end| range.contains(end.t))
    }

    /// Adds the ends in `range`; one that touches the solid in a point of one part counts once.
    #[inline]
    pub fn push(self, range: Range, out: &mut Vec<Crossing>) {
        if range.contains(self.enter.t) {
            out.push(self.enter);
        }
        if range.contains(self.leave.t) && (self.enter.t, self.enter.part) != (self.leave.t, self.leave.part)
        {
            out.push(self.leave);
        }
    }
}
