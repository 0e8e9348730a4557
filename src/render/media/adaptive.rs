//! Method 3: samples at equal distances, and more between those that differ
//! (docs/spec/atmosphere-gi.md 2.8).
//!
//! As in POV-Ray only the first `n / (n + 1)` of an interval is sampled, for the whole of it.

use super::intervals::Interval;
use super::sample::Sample;
use super::{March, transmittance};
use crate::math::Rgb;
use crate::render::trace::Tracer;

/// Halving parts more often than this changes no picture.
const DEEPEST: u32 = 24;

/// A sample and the place in the interval that it stands for, whatever jitter did to it.
#[derive(Clone, Copy)]
struct Knot {
    place: f64,
    value: Sample,
}

/// How many parts an interval has for a number of `samples`.
fn parts(samples: u32) -> u32 {
    (samples / 2 + 1).max(2)
}

impl Tracer<'_> {
    /// What an interval does.
    pub(super) fn adaptive(&mut self, march: &March, interval: &Interval, level: u32) -> Sample {
        let parts = parts(march.rule.min_samples);
        let share = (parts as f32).recip();
        let spacing = f64::from(parts + 1).recip();
        let mut sum = Sample::NOTHING;
        let mut left = self.knot(march, interval, 0.0, spacing);
        for part in 1..=parts {
            let right = self.knot(march, interval, f64::from(part) * spacing, spacing);
            let value = self.refined(march, interval, [left, right], level.min(DEEPEST) - 1);
            sum.source += value.source * share * transmittance(sum.depth);
            sum.depth += value.depth * share;
            left = right;
        }
        sum
    }

    /// The mean of the part between two knots, which may be halved `level` times.
    fn refined(
        &mut self,
        march: &March,
        interval: &Interval,
        [left, right]: [Knot; 2],
        level: u32,
    ) -> Sample {
        let place = (left.place + right.place) / 2.0;
        let middle = self.knot(march, interval, place, right.place - left.place);
        if level == 0 {
            return (left.value + middle.value + right.value) * (1.0 / 3.0);
        }
        let mut half = |outer: Knot, ends: [Knot; 2]| {
            let difference = (outer.value.source - middle.value.source).abs().element_sum();
            if difference > march.threshold {
                self.refined(march, interval, ends, level - 1) * 0.5
            } else {
                outer.value * (1.0 / 3.0) + middle.value * (1.0 / 6.0)
            }
        };
        half(left, [left, middle]) + half(right, [middle, right])
    }

    /// A sample of the whole interval, displaced by at most half the `distance` of knots.
    fn knot(&mut self, march: &March, interval: &Interval, place: f64, distance: f64) -> Knot {
        let displaced = self.displaced(march, place, distance);
        let sample = self.media_sample(march, interval.start + displaced * interval.length, interval.lit);
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
        let mut sum = Rgb::ZERO;
        for half in 0..=2 * parts {
            let (place, distance) = (f64::from(half) / 2.0 * spacing, spacing);
            let place = self.displaced(march, place, distance);
            let depth = self.media_depth(march, interval.start + place * interval.length);
            // Knots between two parts count for both.
            sum += if half % 2 == 0 && half != 0 && half != 2 * parts { depth * 2.0 } else { depth };
        }
        sum * (interval.length as f32 / (3 * parts) as f32)
    }
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
