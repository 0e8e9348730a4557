//! As many samples for every pixel, spread evenly.

use super::filter::warp;
use super::{Look, Random, Sample, each, pixels};
use crate::math::DVec2;
use crate::options::{Filter, Region};

/// Which samples of a pixel's sequence are taken.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Turns {
    /// The first one's number.
    pub first: u32,
    pub count: u32,
}

/// The places of one pixel's samples: a Sobol sequence, of which any first power of two is spread
/// evenly, scrambled for each pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sequence {
    pixel: DVec2,
    seeds: [u32; 2],
    filter: Filter,
}

impl Sequence {
    /// The sequence of a pixel; every seed has others.
    pub(super) fn new((x, y): (u32, u32), filter: Filter, seed: u64) -> Self {
        let pixel = DVec2::new(f64::from(x), f64::from(y));
        let mut random = Random::of_sample(pixel.x, pixel.y, seed);
        let mut word = || (random.next() * 4_294_967_296.0) as u32;
        Self { pixel, seeds: [word(), word()], filter }
    }

    /// The image coordinates of a sample and its weight, 1 or −1.
    pub(super) fn place(&self, number: u32) -> (DVec2, f32) {
        let [x, y] = [number.reverse_bits(), second_dimension(number)];
        let unit = |bits: u32, seed: u32| (f64::from(scrambled(bits, seed)) + 0.5) / 4_294_967_296.0;
        let point = DVec2::new(unit(x, self.seeds[0]), unit(y, self.seeds[1]));
        let (offset, weight) = warp(self.filter, point);
        (self.pixel + offset, weight)
    }
}

/// The second coordinate of Sobol's sequence, of 2³²; the first is the number with its bits reversed.
fn second_dimension(number: u32) -> u32 {
    let (mut rest, mut direction, mut bits) = (number, 1 << 31, 0);
    while rest != 0 {
        if rest & 1 == 1 {
            bits ^= direction;
        }
        rest >>= 1;
        direction ^= direction >> 1;
    }
    bits
}

/// Owen's scrambling: each bit is flipped or not by a hash of those above it (Burley, Practical
/// Hash-based Owen Scrambling, 2020).
fn scrambled(bits: u32, seed: u32) -> u32 {
    let mut low = bits.reverse_bits().wrapping_add(seed);
    for factor in [0x6c50_b47c_u32, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        low ^= low.wrapping_mul(factor);
    }
    low.reverse_bits()
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
    look: &mut dyn Look,
) -> Vec<Sample> {
    pixels(block)
        .map(|pixel| {
            let sequence = Sequence::new(pixel, filter, seed);
            let mut sum = Sum::default();
            let numbers = turns.first..turns.first.saturating_add(turns.count.max(1));
            each(look, numbers.map(|number| sequence.place(number)), |seen, weight| sum.add(seen, weight));
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

    /// Greatest error of the red of 8 × 4 pixels against many more samples.
    fn error(count: u32, filter: Filter) -> f32 {
        let block = Region { columns: 5..13, rows: 0..4 };
        let all = |count| even(&block, Turns { first: 0, count }, filter, 0, &mut edge);
        all(count).iter().zip(all(1 << 14)).map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f32::max)
    }

    #[test]
    fn errors_fall_faster_than_those_of_random_samples() {
        for filter in [Filter::Box, Filter::Triangle, Filter::Gaussian, Filter::Mitchell] {
            let [few, many] = [16, 1024].map(|count| error(count, filter));
            assert!(few < 0.2 && many < few / 8.0, "{filter:?}: {few}, {many}");
        }
    }

    #[test]
    fn any_first_sixteen_samples_have_a_cell_each_of_every_grid_of_sixteen() {
        for pixel in [(0, 0), (7, 3), (200, 100)] {
            let sequence = Sequence::new(pixel, Filter::Box, 0);
            let corner = DVec2::new(f64::from(pixel.0), f64::from(pixel.1)) - 0.5;
            let places: Vec<DVec2> = (0..16).map(|number| sequence.place(number).0 - corner).collect();
            for (columns, rows) in [(16, 1), (8, 2), (4, 4), (2, 8), (1, 16)] {
                let cells: std::collections::BTreeSet<_> = places
                    .iter()
                    .map(|p| ((p.x * f64::from(columns)) as u32, (p.y * f64::from(rows)) as u32))
                    .collect();
                assert_eq!(cells.len(), 16, "{columns} by {rows}");
            }
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
