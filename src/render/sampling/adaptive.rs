//! Samples where the error is: povista's own antialiasing.
//!
//! Every pixel begins with a few samples of its sequence. As long as its estimated error is larger
//! than the one aimed at it gets as many again. The error is what the samples' own deviation leaves
//! of it, or, where an edge may have been missed, what the difference to the neighbours may hide.

use super::even::{Sequence, Sum};
use super::{Contrast, Look, Sample, beside, each, pixels};
use crate::options::{Filter, Region};

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim {
    /// Error of a pixel as it is seen, in steps of 255.
    pub error: f32,
    /// Samples of a pixel at most.
    pub most: u32,
}

/// Samples that every pixel gets.
const FIRST: u32 = 4;

/// The error of a sequence of n samples at an edge, in standard deviations over n^(3/4): measured
/// over random edges with 4 to 256 samples.
const SPREAD: f32 = 0.7;

/// The share of a neighbour's difference that may hide in a pixel after one sample.
const HIDDEN: f32 = 0.25;

/// A pixel on its way.
pub(super) struct Pixel {
    sequence: Sequence,
    taken: u32,
    sum: Sum,
    /// Sums of the brightness as it is seen, and of its square.
    seen: [f32; 2],
}

impl Pixel {
    /// A pixel of which nothing was seen.
    pub(super) fn new(at: (u32, u32), filter: Filter, seed: u64) -> Self {
        Self { sequence: Sequence::new(at, filter, seed), taken: 0, sum: Sum::default(), seen: [0.0; 2] }
    }

    /// Looks at so many places more.
    pub(super) fn take(&mut self, count: u32, contrast: &Contrast, look: &mut dyn Look) {
        let Self { sequence, taken, sum, seen } = self;
        let places = (*taken..*taken + count).map(|number| sequence.place(number));
        each(look, places, |color, weight| {
            sum.add(color, weight);
            let bright = contrast.brightness(color);
            *seen = [seen[0] + bright, seen[1] + bright * bright];
        });
        self.taken += count;
    }

    /// The mean colour of what was seen.
    pub(super) fn mean(&self) -> Sample {
        self.sum.mean()
    }

    /// Mean brightness, as it is seen.
    fn brightness(&self) -> f32 {
        self.seen[0] / self.taken as f32
    }

    /// Deviation of the brightness.
    pub(super) fn deviation(&self) -> f32 {
        let mean = self.brightness();
        (self.seen[1] / self.taken as f32 - mean * mean).max(0.0).sqrt()
    }

    /// Estimated error of the mean, as it is seen, where the brightness of neighbours differs by so much.
    fn error(&self, neighbours: f32) -> f32 {
        let count = self.taken as f32;
        // An evenly spread sequence errs like n^(-3/4) at edges, not like n^(-1/2).
        let spread = SPREAD * self.deviation() / count.powf(0.75);
        spread.max(HIDDEN * neighbours / count)
    }

    /// Looks at places until the error is as aimed at, where the brightness of neighbours differs by so much.
    pub(super) fn finish(&mut self, aim: Aim, neighbours: f32, contrast: &Contrast, look: &mut dyn Look) {
        self.take((4 * FIRST).min(aim.most), contrast, look);
        while self.taken < aim.most && self.error(neighbours) > aim.error / 255.0 {
            self.take(self.taken.min(aim.most - self.taken), contrast, look);
        }
    }
}

/// Every pixel of the block until it is good enough.
pub(super) fn adaptive(
    block: &Region,
    aim: Aim,
    filter: Filter,
    seed: u64,
    contrast: &Contrast,
    look: &mut dyn Look,
) -> Vec<Sample> {
    let width = block.columns.len();
    let mut all: Vec<Pixel> = pixels(block).map(|at| Pixel::new(at, filter, seed)).collect();
    let most = aim.most.max(1);
    for pixel in &mut all {
        pixel.take(FIRST.min(most), contrast, look);
    }
    let mut open: Vec<usize> = (0..all.len()).collect();
    while !open.is_empty() {
        let unfinished = |&place: &usize| {
            let here = all[place].brightness();
            let around = beside(place, width, all.len());
            let unlike = around.map(|other| (all[other].brightness() - here).abs()).fold(0.0, f32::max);
            all[place].taken < most && all[place].error(unlike) > aim.error / 255.0
        };
        open.retain(unfinished);
        for &place in &open {
            let pixel = &mut all[place];
            pixel.take(pixel.taken.min(most - pixel.taken), contrast, look);
        }
    }
    all.iter().map(Pixel::mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::gamma::Gamma;
    use crate::options::Antialias;

    /// The red of 16 × 16 pixels of a bright disc, and how many samples they took.
    fn disc(error: f32, most: u32) -> (Vec<f32>, u32) {
        let mut asked = 0;
        let mut disc = |x: f64, y: f64| {
            asked += 1;
            [if (x - 7.8).hypot(y - 7.1) < 5.3 { 0.9 } else { 0.1 }; 4]
        };
        let contrast = Contrast::new(&Antialias::default(), Some(Gamma::LINEAR));
        let block = Region { columns: 0..16, rows: 0..16 };
        let aim = Aim { error, most };
        let pixels = adaptive(&block, aim, Filter::Box, 0, &contrast, &mut disc);
        (pixels.iter().map(|pixel| pixel[0]).collect(), asked)
    }

    #[test]
    fn smaller_errors_are_reached_with_more_samples_at_the_edge_alone() {
        let (exact, all) = disc(0.0, 1 << 14);
        assert!(all > 16 * 16 * 1000);
        let rmse = |pixels: &[f32]| {
            (pixels.iter().zip(&exact).map(|(a, b)| (a - b) * (a - b)).sum::<f32>() / 256.0).sqrt() * 255.0
        };
        let (coarse, few) = disc(16.0, 1024);
        let (fine, many) = disc(1.0, 1024);
        assert!(few < 16 * 16 * 9 && many < all / 8, "{few} and {many} samples");
        assert!(rmse(&coarse) < 4.0 && rmse(&fine) < 0.5, "{} and {}", rmse(&coarse), rmse(&fine));
    }

    #[test]
    fn flat_parts_take_the_least() {
        let contrast = Contrast::new(&Antialias::default(), None);
        let mut asked = 0;
        let mut flat = |_: f64, _: f64| {
            asked += 1;
            [0.5; 4]
        };
        let block = Region { columns: 0..8, rows: 0..8 };
        adaptive(&block, Aim { error: 0.5, most: 64 }, Filter::Box, 0, &contrast, &mut flat);
        assert_eq!(asked, 64 * FIRST);
    }
}
