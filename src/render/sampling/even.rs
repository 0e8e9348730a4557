//! As many samples for every pixel, spread evenly.

use super::filter::warp;
use super::{Random, Sample, pixels};
use crate::math::DVec2;
use crate::options::{Filter, Region};

/// The steps of the sequence R2 (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences,
/// 2018): powers of the inverse of 1.3247…, the real root of x³ = x + 1.
const STEPS: DVec2 = DVec2::new(0.754_877_666_246_692_8, 0.569_840_290_998_053_3);

/// Which samples of a pixel's sequence are taken.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Turns {
    /// The first one's number.
    pub first: u32,
    pub count: u32,
}

/// The sequence of places for the samples of one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sequence {
    pixel: DVec2,
    start: DVec2,
    filter: Filter,
}

impl Sequence {
    /// The sequence of a pixel; every seed has others.
    pub(super) fn new((x, y): (u32, u32), filter: Filter, seed: u64) -> Self {
        let pixel = DVec2::new(f64::from(x), f64::from(y));
        let mut random = Random::of_sample(pixel.x, pixel.y, seed);
        Self { pixel, start: DVec2::new(random.next(), random.next()), filter }
    }

    /// The image coordinates of a sample and its weight, 1 or −1.
    pub(super) fn place(&self, number: u32) -> (DVec2, f32) {
        let point = self.start + STEPS * f64::from(number);
        let (offset, weight) = warp(self.filter, point - point.floor());
        (self.pixel + offset, weight)
    }
}

/// Weighted sums of samples.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sum {
    color: Sample,
    /// Of positive samples alone, for when the others outweigh them.
    positive: Sample,
    weight: f32,
    count: f32,
}

impl Sum {
    pub(super) fn add(&mut self, color: Sample, weight: f32) {
        let positive = weight.max(0.0);
        self.color = std::array::from_fn(|i| self.color[i] + weight * color[i]);
        self.positive = std::array::from_fn(|i| self.positive[i] + positive * color[i]);
        self.weight += weight;
        self.count += positive;
    }

    /// The mean colour; black where there is no sample.
    pub(super) fn mean(&self) -> Sample {
        let (sum, weight) = if self.weight > 0.5 * self.count {
            (self.color, self.weight)
        } else {
            (self.positive, self.count)
        };
        if weight > 0.0 { sum.map(|component| component / weight) } else { Sample::default() }
    }
}

/// Every pixel from the same turns of its sequence.
pub(in crate::render) fn even(
    block: &Region,
    turns: Turns,
    filter: Filter,
    seed: u64,
    sample: &mut dyn FnMut(f64, f64) -> Sample,
) -> Vec<Sample> {
    pixels(block)
        .map(|pixel| {
            let sequence = Sequence::new(pixel, filter, seed);
            let mut sum = Sum::default();
            for number in turns.first..turns.first.saturating_add(turns.count.max(1)) {
                let (place, weight) = sequence.place(number);
                sum.add(sample(place.x, place.y), weight);
            }
            sum.mean()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// White right of the line x = 7.3 + 0.6 y.
    fn edge(x: f64, y: f64) -> Sample {
        [if x > 7.3 + 0.6 * y { 1.0 } else { 0.0 }; 4]
    }

    /// Greatest error of the red of 16 × 8 pixels against a hundred thousand samples.
    fn error(count: u32, filter: Filter) -> f32 {
        let block = Region { columns: 0..16, rows: 0..8 };
        let all = |count| even(&block, Turns { first: 0, count }, filter, 0, &mut edge);
        all(count).iter().zip(all(100_000)).map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f32::max)
    }

    #[test]
    fn errors_fall_faster_than_those_of_random_samples() {
        for filter in [Filter::Box, Filter::Triangle, Filter::Gaussian, Filter::Mitchell] {
            let [few, many] = [16, 1024].map(|count| error(count, filter));
            assert!(few < 0.2 && many < few / 8.0, "{filter:?}: {few}, {many}");
        }
    }

    #[test]
    fn what_is_flat_stays_flat_under_every_filter() {
        for filter in [Filter::Triangle, Filter::Mitchell] {
            let block = Region { columns: 0..30, rows: 0..30 };
            let pixels = even(&block, Turns { first: 3, count: 3 }, filter, 5, &mut |_, _| [0.25; 4]);
            assert!(pixels.iter().all(|pixel| (pixel[0] - 0.25).abs() < 1e-6), "{filter:?}");
        }
    }
}
