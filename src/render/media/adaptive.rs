//! Method 3: samples at equal distances, and more between those that differ
//! (docs/spec/atmosphere-gi.md 2.8).
//!
//! As in POV-Ray only the first `n / (n + 1)` of an interval is sampled, for the whole of it.

use smallvec::SmallVec;

use super::March;
use super::intervals::Interval;
use super::sample::{Mixture, Sample, four_places};
use crate::math::{Lanes, Rgb};
use crate::render::trace::Tracer;

/// Halving parts more often than this changes no picture.
const DEEPEST: u32 = 24;

/// Intervals that may come to have more parts halve them one after the other, without keeping them.
const MANY: u64 = 4096;

/// A sample and the place in the interval that it stands for, whatever jitter did to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knot {
    pub(super) place: f64,
    pub(super) value: Sample,
}

/// How many parts an interval has for a number of `samples`.
fn parts(samples: u32) -> u32 {
    (samples / 2 + 1).max(2)
}

impl March<'_, '_> {
    /// Whether the light of two neighbours differs so much that samples are taken between them.
    #[inline]
    pub(super) fn differ(&self, one: &Knot, other: &Knot) -> bool {
        (one.value.source - other.value.source).abs().element_sum() > self.threshold
    }
}

/// The mean of a part that isn't halved.
#[inline]
pub(super) fn mean(left: &Knot, middle: &Knot, right: &Knot) -> Sample {
    (left.value + middle.value + right.value) * (1.0 / 3.0)
}

/// What a half between an outer knot and the middle adds to the mean of a part, if it isn't halved again.
#[inline]
pub(super) fn half(outer: &Knot, middle: &Knot) -> Sample {
    outer.value * (1.0 / 3.0) + middle.value * (1.0 / 6.0)
}

impl Tracer<'_> {
    /// What an interval does.
    pub(super) fn adaptive(&mut self, march: &March, interval: &Interval, level: u32) -> Sample {
        let parts = parts(march.rule.min_samples);
        let share = (parts as f32).recip();
        let spacing = f64::from(parts + 1).recip();
        let level = level.min(DEEPEST) - 1;
        let mut known = SmallVec::new();
        if march.uniform.is_none() && march.rule.jitter == 0.0 {
            // Lamps may take random numbers, so their order counts.
            let lamps = interval.lit && march.scatters;
            if !lamps && u64::from(parts) << level <= MANY {
                return self.halved(march, interval, (parts, spacing), level);
            }
            known = self.mixtures_of_knots(march, interval, parts, spacing);
        }
        let known = |half: u32| known.get(half as usize);
        let mut sum = Sample::NOTHING;
        let mut left = self.knot(march, interval, (0.0, spacing), known(0));
        for part in 1..=parts {
            let right = self.knot(march, interval, (f64::from(part) * spacing, spacing), known(2 * part));
            let value = self.refined(march, interval, [left, right], level, known(2 * part - 1));
            sum.add_behind(value, share);
            left = right;
        }
        sum
    }

    /// What media do at the ends of parts and in their middles, but for lamps.
    fn mixtures_of_knots(
        &mut self,
        march: &March,
        interval: &Interval,
        parts: u32,
        spacing: f64,
    ) -> SmallVec<[Mixture; 24]> {
        let (mut mixtures, count) = (SmallVec::new(), 2 * parts + 1);
        for first in (0..count).step_by(Lanes::COUNT) {
            let (places, taken) = four_places(first..count, |half| place_of(half, spacing));
            let four = self.media_mixtures(march, interval, &places[..taken]);
            mixtures.extend((0..taken).map(|lane| four.get(lane)));
        }
        mixtures
    }

    /// The mean of the part between two knots, which may be halved `level` times.
    fn refined(
        &mut self,
        march: &March,
        interval: &Interval,
        [left, right]: [Knot; 2],
        level: u32,
        known: Option<&Mixture>,
    ) -> Sample {
        let place = (left.place + right.place) / 2.0;
        let middle = self.knot(march, interval, (place, right.place - left.place), known);
        if level == 0 {
            return mean(&left, &middle, &right);
        }
        let mut side = |outer: Knot, ends: [Knot; 2]| {
            if march.differ(&outer, &middle) {
                self.refined(march, interval, ends, level - 1, None) * 0.5
            } else {
                half(&outer, &middle)
            }
        };
        side(left, [left, middle]) + side(right, [middle, right])
    }

    /// A sample of the whole interval, displaced by at most half the `distance` of knots.
    fn knot(
        &mut self,
        march: &March,
        interval: &Interval,
        (place, distance): (f64, f64),
        known: Option<&Mixture>,
    ) -> Knot {
        let displaced = self.displaced(march, place, distance);
        let sample = self.media_sample(march, interval.at(displaced), interval.lit, known);
        Knot { place, value: sample.scaled(interval.length) }
    }

    fn displaced(&mut self, march: &March, place: f64, distance: f64) -> f64 {
        match march.rule.jitter {
            0.0 => place,
            jitter => place + distance * jitter * (self.random.next() - 0.5),
        }
    }

    /// The optical depth of an interval on the way to a lamp: no light that could differ, so nothing
    /// is halved.
    pub(super) fn adaptive_depth(&mut self, march: &March, interval: &Interval) -> Rgb {
        let parts = parts(march.rule.min_samples);
        let spacing = f64::from(parts + 1).recip();
        let (mut sum, count) = (Rgb::ZERO, 2 * parts + 1);
        for first in (0..count).step_by(Lanes::COUNT) {
            let (places, taken) = four_places(first..count, |half| {
                self.displaced(march, f64::from(half) / 2.0 * spacing, spacing)
            });
            let depths = self.media_depths(march, interval, &places[..taken]);
            for (half, lane) in (first..count).zip(0..taken) {
                let depth = depths.get(lane);
                // Knots between two parts count for both.
                sum += if half % 2 == 0 && half != 0 && half != 2 * parts { depth * 2.0 } else { depth };
            }
        }
        sum * (interval.length as f32 / (3 * parts) as f32)
    }
}

/// The place of a knot: the ends of parts have even numbers, the middles odd ones.
#[inline]
pub(super) fn place_of(half: u32, spacing: f64) -> f64 {
    let end = |number: u32| f64::from(number) * spacing;
    if half.is_multiple_of(2) { end(half / 2) } else { (end(half / 2) + end(half / 2 + 1)) / 2.0 }
}

/// What an interval does whose samples are all alike: the sum of a geometric series.
pub(super) fn uniform(whole: Sample, samples: u32) -> Sample {
    let share = f64::from(parts(samples)).recip();
    let damped = |depth: f32| {
        let depth = f64::from(depth);
        let (all, one) = ((-depth).exp_m1(), (-depth * share).exp_m1());
        // Thin and endlessly bright intervals are not dimmed.
        if one == 0.0 || !(all / one).is_finite() { 1.0 } else { (share * all / one) as f32 }
    };
    let [r, g, b] = whole.depth.to_array();
    let grey = r == g && g == b;
    let damped = if grey { Rgb::splat(damped(r)) } else { Rgb::new(damped(r), damped(g), damped(b)) };
    Sample { source: whole.source * damped, ..whole }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_intervals_are_summed_in_closed_form_at_any_depth() {
        for depth in [-3.0_f32, 0.0, 1e-9, 0.1, 1.0, 30.0, 1e6, 1e30] {
            let share = 1.0 / 6.0;
            let whole = Sample { source: Rgb::ONE, depth: Rgb::splat(depth) };
            let by_parts: f64 =
                (0..6).map(|part| share * (-f64::from(depth) * share * f64::from(part)).exp()).sum();
            let ours = uniform(whole, 10).source.x;
            assert!(
                (f64::from(ours) - by_parts).abs() < 1e-6 * by_parts.max(1.0),
                "{depth}: {ours} {by_parts}"
            );
        }
    }
}
