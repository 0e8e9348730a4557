//! The last digits of a crossing, from a stretch that is known to hold it.

use super::search::Zone;
use crate::math::roots::between;

/// Steps of the secant method before the search for the last digits is given up.
pub(super) const STEPS: usize = 6;

impl Zone {
    /// Where the function crosses zero in a zone at whose end it is below, if steps with the slope known and
    /// then by the secant method stay in the zone. No step shorter than `least` tells values apart; for `rough` see
    /// [`Search::rough`](super::Search).
    pub(super) fn straight_to_root(self, value: impl Fn(f64) -> f64, rough: f64, least: f64) -> Option<f64> {
        let mut t = 0.5 * (self.from + self.to);
        let mut slope = self.slope;
        let mut here = value(t);
        let length = self.to - self.from;
        let [mut last, mut before] = [length, 0.0];
        for _ in 0..STEPS {
            let next = t - here / slope;
            if !(self.from <= next && next <= self.to) {
                return None;
            }
            let step = (next - t).abs();
            // Each step is the product of both before it times how much the function bends. Where that doesn't hold any
            // more steps are of the size of what the function is rounded to.
            let is_rough = step >= 0.5 * last && last <= rough * length;
            let rest = step * (step / before).min(1.0);
            if here == 0.0 || rest <= 0.25 * f64::EPSILON * t.abs() || step <= least || is_rough {
                return Some(next);
            }
            (before, last) = (last, step);
            let there = value(next);
            if there == here && step <= rough * length {
                return Some(next);
            }
            slope = bettered(slope, (there - here) / (next - t));
            (t, here) = (next, there);
        }
        (last <= rough * length).then_some(t)
    }
}

/// The shortest step between two places that tells their values apart where points are this far from the origin.
pub(super) fn least_step(far: f64) -> f64 {
    4.0 * f64::EPSILON * far
}

/// The slope between the ends of a step where one is known about: what is of another size or sign is what rounding makes
/// of values all but the same.
#[inline(always)]
pub(super) fn bettered(known: f64, found: f64) -> f64 {
    let share = found / known;
    if 0.25 < share && share < 4.0 { found } else { known }
}

/// The root between two places with values of either sign, to the last digits.
///
/// Over a short stretch a function is nearly straight, and a few steps of the secant method do.
pub(super) fn polished(low: (f64, f64), high: (f64, f64), rough: f64, value: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = (low, high);
    let line = |a: (f64, f64), b: (f64, f64)| a.0 + (b.0 - a.0) * (a.1 / (a.1 - b.1));
    let short = rough * (high.0 - low.0);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let t = line(a, b);
        if !(low.0 <= t && t <= high.0) {
            break;
        }
        let step = (t - b.0).abs();
        (a, b) = (b, (t, value(t)));
        let is_rough = last <= short && (step >= 0.5 * last || b.1 == a.1);
        if b.1 == 0.0 || step <= 2.0 * f64::EPSILON * t.abs() || is_rough {
            return t;
        }
        last = step;
    }
    between(low, high, value)
}
