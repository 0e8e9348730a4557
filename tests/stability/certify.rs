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
    /// The parts of a range in which there are zeros, or may be.
    fn rough_cells(&self, range: Interval<f64>, limits: Limits, found: &mut dyn FnMut(Cell<f64>)) {
        isolate(|t| self.rough(t), |t| self.is_beyond(t), range, limits, found);
    }
    fn fine_cells(&self, range: Interval<Double>, limits: Limits, found: &mut dyn FnMut(Cell<Double>)) {
        isolate(|t| self.fine(t), |t| self.is_beyond(t), range, limits, found);
    }
}

/// Where splitting ends.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    /// The length of a part that isn't split any more.
    pub(crate) least: f64,
    /// So many parts are looked at before what is left is in doubt: a line in the surface, or within rounding of it,
    /// is zero everywhere.
    pub(crate) most: usize,
    /// Whether polynomials are worked out anew over parts where rounding hides their signs.
    pub(crate) anew: bool,
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

/// A part of a range.
pub(crate) enum Cell<S> {
    /// Monotone, with values of opposite sign at the ends.
    One {
        part: Interval<S>,
        rising: bool,
    },
    Doubt(Interval<S>),
}

/// Splits a range until every part is known, or a limit is met.
pub(crate) fn isolate<S: Scalar>(
    f: impl Fn(Interval<S>) -> Jet<S>,
    is_beyond: impl Fn(Interval<f64>) -> bool,
    range: Interval<S>,
    Limits { least, most, .. }: Limits,
    found: &mut dyn FnMut(Cell<S>),
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
                    found(Cell::One { part, rising: low.is_negative() });
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

/// The limits in doubles and in double-doubles, with the least length as a share of the range.
const LIMITS: [Limits; 2] =
    [Limits { least: 1e-9, most: 300, anew: false }, Limits { least: 1e-20, most: 3000, anew: true }];

/// What doubles tell of the zeros in a range, of a function and of all others that its rounding hides.
pub(crate) struct Cells {
    /// Parts with one zero each, and whether the function rises there.
    ones: Vec<(Interval<Double>, bool)>,
    doubts: Vec<Interval<Double>>,
    /// The length of the range.
    scale: f64,
}

impl Cells {
    pub(crate) fn new(f: &impl Along, low: f64, high: f64) -> Self {
        let mut out = Self { ones: Vec::new(), doubts: Vec::new(), scale: high - low };
        let rough = Limits { least: LIMITS[0].least * out.scale, ..LIMITS[0] };
        f.rough_cells(Interval { low, high }, rough, &mut |cell| match cell {
            Cell::One { part, rising } => {
                let Interval { low, high } = refined(|t| f.rough(t), part, rising, 0.0);
                out.ones.push((Interval { low: Double::of(low), high: Double::of(high) }, rising));
            }
            Cell::Doubt(part) => {
                let (low, high) = (Double::of(part.low), Double::of(part.high));
                match out.doubts.last_mut().filter(|last| last.high == low) {
                    Some(last) => last.high = high,
                    None => out.doubts.push(Interval { low, high }),
                }
            }
        });
        out
    }

    /// All zeros, of one of the functions: to the last digit, or only as far as it takes to tell whether they count.
    pub(crate) fn zeros(&self, f: &impl Along, exactly: bool) -> Zeros {
        let mut out = Zeros { close: !self.doubts.is_empty(), ..Zeros::default() };
        let mut ones = self.ones.clone();
        let fine = Limits { least: LIMITS[1].least * self.scale, ..LIMITS[1] };
        for doubt in &self.doubts {
            f.fine_cells(*doubt, fine, &mut |cell| match cell {
                Cell::One { part, rising } => ones.push((part, rising)),
                Cell::Doubt(part) => out.doubtful.push(part.middle().to_f64()),
            });
        }
        for (one, rising) in ones {
            let refine = || {
                let near = refined(|t| f.fine(t), one, rising, FINE_ENOUGH * self.scale);
                (near, f.counts(near))
            };
            let (near, counts) = match exactly {
                true => refine(),
                false => f.counts(one).map_or_else(refine, |counts| (one, Some(counts))),
            };
            match counts {
                Some(true) => out.at.push(near.middle()),
                Some(false) => {}
                None => out.doubtful.push(near.middle().to_f64()),
            }
        }
        out.at.sort_by(|a, b| a.partial_cmp(b).expect("zeros are numbers"));
        out
    }
}

/// All zeros in a range.
pub(crate) fn zeros(f: &impl Along, low: f64, high: f64) -> Zeros {
    Cells::new(f, low, high).zeros(f, true)
}

/// The share of a range that zeros are known to.
const FINE_ENOUGH: f64 = 1e-26;

/// The zero in a part where there is just one, as narrow as it gets or as is enough.
fn refined<S: Scalar>(
    f: impl Fn(Interval<S>) -> Jet<S>,
    mut part: Interval<S>,
    rising: bool,
    enough: f64,
) -> Interval<S> {
    for _ in 0..200 {
        let (middle, slope) = (part.middle(), f(part).slope);
        let value = f(Interval::point(middle)).value;
        let width = |part: Interval<S>| (part.high - part.low).to_f64();
        let next = match slope.has_zero() {
            true => part,
            false => (Interval::point(middle) - value / slope).meet(part),
        };
        if width(next) <= enough {
            return next;
        }
        if width(next) > 0.5 * width(part) {
            // Newton has stopped helping: halve, or end where nothing helps.
            if value.has_zero() {
                return next;
            }
            let left = value.is_negative() != rising;
            part = if left { Interval { high: middle, ..part } } else { Interval { low: middle, ..part } };
            continue;
        }
        part = next;
    }
    part
}
