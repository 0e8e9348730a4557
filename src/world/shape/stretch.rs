//! The stretch of a line inside a convex solid: how every convex primitive states its crossings.

use super::Crossing;
use crate::world::Range;

/// The part of an end of which only the distance is known.
pub const UNSAID: u32 = u32::MAX;

/// Where a line enters a convex solid and where it leaves, with `enter.t <= leave.t`.
#[derive(Clone, Copy, Debug)]
pub struct Stretch<E = End> {
    /// The first point.
    pub enter: E,
    /// The last point.
    pub leave: E,
}

/// A crossing whose place on the part needs no saying.
#[derive(Clone, Copy, Debug)]
pub struct End {
    /// Distance along the ray.
    pub t: f64,
    /// Which part of the surface it is on.
    pub part: u32,
}

impl From<End> for Crossing {
    #[inline]
    fn from(end: End) -> Self {
        Self::new(end.t, end.part)
    }
}

impl Stretch {
    /// The whole line.
    pub const LINE: Self =
        Self { enter: End { t: f64::NEG_INFINITY, part: 0 }, leave: End { t: f64::INFINITY, part: 0 } };

    /// From `enter` on `enter_part` to `leave` on `leave_part`; `None` unless they are in that order.
    #[inline]
    pub fn new(enter: f64, enter_part: u32, leave: f64, leave_part: u32) -> Option<Self> {
        (enter <= leave).then_some(Self {
            enter: End { t: enter, part: enter_part },
            leave: End { t: leave, part: leave_part },
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
}

impl<E: Into<Crossing> + Copy> Stretch<E> {
    /// The nearer end in `range`.
    #[inline]
    pub fn nearest(self, range: Range) -> Option<Crossing> {
        [self.enter, self.leave].into_iter().map(E::into).find(|end: &Crossing| range.contains(end.t))
    }

    /// The ends in `range`; one that touches the solid in a point of one part counts once.
    #[inline]
    pub fn ends(self, range: Range) -> [Option<Crossing>; 2] {
        let (enter, leave): (Crossing, Crossing) = (self.enter.into(), self.leave.into());
        let two = (enter.t, enter.part) != (leave.t, leave.part);
        [range.contains(enter.t).then_some(enter), (two && range.contains(leave.t)).then_some(leave)]
    }

    /// Adds the [`ends`](Self::ends) in `range`.
    #[inline]
    pub fn push(self, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.ends(range).into_iter().flatten());
    }
}
