//! Where a function of one variable is zero, proven: interval Newton and bisection, first in doubles and,
//! where that leaves doubt, in double-doubles.

use crate::double::Double;
use crate::interval::{Interval, Scalar};
use crate::real::Jet;

/// A function of one variable with its derivative, over intervals of both kinds.
pub(crate) trait Along {
    fn rough(&self, t: Interval<f64>) -> Jet<f64>;
    fn fine(&self, t: Interval<Double>) -> Jet<Double>;
    /// Whether no zero in an interval counts, for sure.
    fn is_beyond(&self, _t: Interval<f64>) -> bool {
        false
    }
    /// The sign of what has to be negative for a zero to count; `None` where it is in doubt.
    fn counts(&self, _t: Interval<Double>) -> Option<bool> {
        Some(true)
    }
}

/// What is known about the zeros in a range.
#[derive(Debug, Default)]
pub(crate) struct Zeros {
    /// Each of them, ascending, to about 26 digits of the range.
    pub(crate) at: Vec<Double>,
    /// Places where double-doubles cannot tell none, one and two apart.
    pub(crate) doubtful: Vec<f64>,
    /// Whether doubles were not enough somewhere.
    pub(crate) close: bool,
}

enum Cell<S> {
    /// Monotone, with values of opposite sign at the ends.
    One(Interval<S>),
    Doubt(Interval<S>),
}

/// Splits a range until every part is known, or narrower than `least`, or one of too many.
fn isolate<S: Scalar>(
    f: impl Fn(Interval<S>) -> Jet<S>,
    is_beyond: impl Fn(Interval<f64>) -> bool,
    range: Interval<S>,
    least: f64,
    most: usize,
    mut found: impl FnMut(Cell<S>),
) {
    // Never through the middle, where symmetric shapes have their roots.
    const SHARE: f64 = 0.4823;
    let mut rest = vec![range];
    let mut parts = 0;
    while let Some(part) = rest.pop() {
        parts += 1;
        if parts > most {
            found(Cell::Doubt(part));
            continue;
        }
        let jet = f(part);
        let (low, high) = (part.low.to_f64().next_down(), part.high.to_f64().next_up());
        if !jet.value.has_zero() || is_beyond(Interval { low, high }) {
            continue;
        }
        let width = part.high - part.low;
        let split = part.low + width * S::of(SHARE);
        let at = |x: S| f(Interval::point(x)).value;
        let here = at(split);
        let mean = here + jet.slope * (part - Interval::point(split));
        if !mean.has_zero() {
            continue;
        }
        // Most of the doubt is rounding, which no splitting takes away.
        if here.has_zero() && mean.high - mean.low <= (here.high - here.low) * S::of(2.0) {
            found(Cell::Doubt(part));
            continue;
        }
        if !jet.slope.has_zero() {
            let (low, high) = (at(part.low), at(part.high));
            if !low.has_zero() && !high.has_zero() {
                if low.is_negative() != high.is_negative() {
                    found(Cell::One(part));
                }
                continue;
            }
            if low.has_zero() && high.has_zero() {
                found(Cell::Doubt(part));
                continue;
            }
        }
        if width.to_f64() <= least || split <= part.low || split >= part.high {
            found(Cell::Doubt(part));
            continue;
        }
        rest.push(Interval { low: split, high: part.high });
        rest.push(Interval { low: part.low, high: split });
    }
}

/// So many parts are looked at before what is left is in doubt, in doubles and in double-doubles: a line in the
/// surface, or within rounding of it, is zero everywhere.
const PARTS: [usize; 2] = [300, 3000];

/// All zeros in a range.
pub(crate) fn zeros(f: &impl Along, low: f64, high: f64) -> Zeros {
    let (mut out, mut doubts) = (Zeros::default(), Vec::<Interval<Double>>::new());
    let mut ones = Vec::new();
    let scale = high - low;
    isolate(
        |t| f.rough(t),
        |t| f.is_beyond(t),
        Interval { low, high },
        1e-9 * scale,
        PARTS[0],
        |cell| match cell {
            Cell::One(part) => {
                let Interval { low, high } = refined(|t| f.rough(t), part, 0.0);
                ones.push(Interval { low: Double::of(low), high: Double::of(high) });
            }
            Cell::Doubt(part) => {
                let (low, high) = (Double::of(part.low), Double::of(part.high));
                match doubts.last_mut().filter(|last| last.high == low) {
                    Some(last) => last.high = high,
                    None => doubts.push(Interval { low, high }),
                }
            }
        },
    );
    out.close = !doubts.is_empty();
    for doubt in doubts {
        isolate(
            |t| f.fine(t),
            |t| f.is_beyond(t),
            doubt,
            1e-20 * scale,
            PARTS[1],
            |cell| match cell {
                Cell::One(part) => ones.push(part),
                Cell::Doubt(part) => out.doubtful.push(part.middle().to_f64()),
            },
        );
    }
    for one in ones {
        let near = refined(|t| f.fine(t), one, FINE_ENOUGH * scale);
        match f.counts(near) {
            Some(true) => out.at.push(near.middle()),
            Some(false) => {}
            None => out.doubtful.push(near.middle().to_f64()),
        }
    }
    out.at.sort_by(|a, b| a.partial_cmp(b).expect("zeros are numbers"));
    out
}

/// The share of a range that zeros are known to.
const FINE_ENOUGH: f64 = 1e-26;

/// The zero in a part where there is just one, as narrow as it gets or as is enough.
fn refined<S: Scalar>(f: impl Fn(Interval<S>) -> Jet<S>, mut part: Interval<S>, enough: f64) -> Interval<S> {
    for _ in 0..200 {
        let (middle, slope) = (part.middle(), f(part).slope);
        let step = f(Interval::point(middle)).value / slope;
        let next = (Interval::point(middle) - step).meet(part);
        let (before, after) = ((part.high - part.low).to_f64(), (next.high - next.low).to_f64());
        if after <= enough {
            return next;
        }
        if after > 0.5 * before {
            // Newton has stopped helping: halve, or end where nothing helps.
            let value = f(Interval::point(middle)).value;
            if value.has_zero() {
                return next;
            }
            let rising = slope.is_positive();
            let left = value.is_negative() != rising;
            part = if left { Interval { high: middle, ..part } } else { Interval { low: middle, ..part } };
            continue;
        }
        part = next;
    }
    part
}
