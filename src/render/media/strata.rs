//! Methods 1 and 2: a number of samples at random or in equal parts, then more while they vary
//! (docs/spec/atmosphere-gi.md 2.7).

use super::intervals::Interval;
use super::sample::{Mixture, Sample, four_places};
use super::{March, transmittance};
use crate::math::{Lanes, Rgb};
use crate::render::trace::Tracer;
use crate::world::media::{Extra, Method};

impl Tracer<'_> {
    /// What an interval does, from samples at random places or, if `even`, in the middle of equal parts.
    pub(super) fn stratified(
        &mut self,
        march: &March,
        interval: &Interval,
        extra: &Extra,
        even: bool,
    ) -> Sample {
        // Where lamps may take random numbers between those of places, samples are taken one after the other.
        let lamps = interval.lit && march.scatters;
        let in_fours = march.uniform.is_none() && (!lamps || even && march.rule.jitter == 0.0);
        let (mut sum, mut squares) = (Sample::NOTHING, Rgb::ZERO);
        let mut add = |this: &mut Self, place: f64, known: Option<&Mixture>| {
            let sample = this.dimmed_sample(march, interval, place, known);
            sum = sum + sample;
            squares += sample.source * sample.source;
            (sum, squares)
        };
        let mut count = march.rule.min_samples;
        let mut sums = (Sample::NOTHING, Rgb::ZERO);
        for first in (0..count).step_by(if in_fours { Lanes::COUNT } else { 1 }) {
            if !in_fours {
                let place = self.stratum(march, first, even);
                sums = add(self, place, None);
                continue;
            }
            let (places, taken) = four_places(first..count, |index| self.stratum(march, index, even));
            let known = self.media_mixtures(march, interval, &places[..taken]);
            for (lane, place) in places[..taken].iter().enumerate() {
                sums = add(self, *place, Some(&known.get(lane)));
            }
        }
        while let Some(&enough) = extra.thresholds.get(count as usize - 1) {
            let mean = sums.0.source / count as f32;
            let variance = (sums.1 / count as f32 - mean * mean) / count as f32;
            if f64::from(variance.max_element()) < enough {
                break;
            }
            let place = self.random.next();
            sums = add(self, place, None);
            count += 1;
        }
        sums.0 * (count as f32).recip()
    }

    /// The optical depth of an interval on the way to a lamp.
    pub(super) fn stratified_depth(&mut self, march: &March, interval: &Interval) -> Rgb {
        let count = march.rule.min_samples;
        let even = matches!(march.rule.method, Method::Even(_));
        let mut sum = Rgb::ZERO;
        for first in (0..count).step_by(Lanes::COUNT) {
            let (places, taken) = four_places(first..count, |index| self.stratum(march, index, even));
            let depths = self.media_depths(march, interval, &places[..taken]);
            for lane in 0..taken {
                sum += depths.get(lane);
            }
        }
        sum * (interval.length as f32 / count as f32)
    }

    /// The place of a sample, in parts of the interval.
    fn stratum(&mut self, march: &March, index: u32, even: bool) -> f64 {
        if !even {
            return self.random.next();
        }
        let jitter = march.rule.jitter;
        let shift = if jitter == 0.0 { 0.0 } else { jitter * self.random.next() };
        (f64::from(index) + 0.5 + shift) / f64::from(march.rule.min_samples)
    }

    /// A sample of the whole interval, its light dimmed as if the interval were alike up to there.
    fn dimmed_sample(
        &mut self,
        march: &March,
        interval: &Interval,
        place: f64,
        known: Option<&Mixture>,
    ) -> Sample {
        let sample = self.media_sample(march, interval.at(place), interval.lit, known);
        let sample = sample.scaled(interval.length);
        Sample { source: sample.source * transmittance(sample.depth * place as f32), ..sample }
    }
}
