//! Method 3 where nothing is random and no lamp counts: parts are halved all at once and not one after the other, so
//! that there are always several samples to take side by side.

use super::March;
use super::adaptive::{Knot, half, mean, place_of};
use super::intervals::Interval;
use super::sample::Sample;
use crate::math::Lanes;
use crate::render::trace::Tracer;

/// A part of an interval, or a half of a part.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct Part {
    /// The numbers of the knots at its left end, in the middle and at its right end.
    knots: [u32; 3],
    /// The numbers of its halves, where these are parts that are halved again.
    halves: [u32; 2],
}

/// Instead of a number: a half that stays as it is.
const WHOLE: u32 = u32::MAX;

/// The parts of an interval, and what is known between them.
#[derive(Debug, Default)]
pub(in crate::render) struct Parts {
    knots: Vec<Knot>,
    parts: Vec<Part>,
    /// The means of parts, the last part's first.
    means: Vec<Sample>,
}

impl Parts {
    fn clear(&mut self) {
        self.knots.clear();
        self.parts.clear();
        self.means.clear();
    }

    /// Adds a part between two knots; what is in its middle is not known yet.
    fn add(&mut self, left: u32, right: u32) {
        let place = (self.knots[left as usize].place + self.knots[right as usize].place) / 2.0;
        self.parts.push(Part { knots: [left, self.knots.len() as u32, right], halves: [WHOLE; 2] });
        self.knots.push(Knot { place, value: Sample::NOTHING });
    }

    /// The mean of a part whose halves' means are known.
    fn mean(&self, part: &Part, is_deepest: bool) -> Sample {
        let [left, middle, right] = part.knots;
        let [left, middle, right] =
            [&self.knots[left as usize], &self.knots[middle as usize], &self.knots[right as usize]];
        if is_deepest {
            return mean(left, middle, right);
        }
        let side = |outer: &Knot, again: u32| match again {
            WHOLE => half(outer, middle),
            again => self.means[self.parts.len() - 1 - again as usize] * 0.5,
        };
        side(left, part.halves[0]) + side(right, part.halves[1])
    }
}

impl Tracer<'_> {
    /// What an interval does that has so many parts at this distance, each of which may be halved `level` times.
    pub(super) fn halved(
        &mut self,
        march: &March,
        interval: &Interval,
        (count, spacing): (u32, f64),
        level: u32,
    ) -> Sample {
        let mut tree = std::mem::take(&mut self.parts);
        tree.clear();
        for half in 0..=2 * count {
            tree.knots.push(Knot { place: place_of(half, spacing), value: Sample::NOTHING });
        }
        for left in (0..2 * count).step_by(2) {
            tree.parts.push(Part { knots: [left, left + 1, left + 2], halves: [WHOLE; 2] });
        }
        self.take(march, interval, &mut tree.knots);
        // The first of the parts that were added last, and whether none of these may be halved.
        let (mut first, mut deepest) = (0, level == 0);
        for left in (0..level).rev() {
            let (parts, knots) = (tree.parts.len(), tree.knots.len());
            for at in first..parts {
                let [left, middle, right] = tree.parts[at].knots;
                for (side, from, to) in [(0, left, middle), (1, middle, right)] {
                    if march.differ(&tree.knots[from as usize], &tree.knots[to as usize]) {
                        tree.parts[at].halves[side] = tree.parts.len() as u32;
                        tree.add(from, to);
                    }
                }
            }
            if tree.parts.len() == parts {
                break;
            }
            (first, deepest) = (parts, left == 0);
            self.take(march, interval, &mut tree.knots[knots..]);
        }
        // Halves come after their parts: from the last to the first all are known when they are asked for.
        for at in (0..tree.parts.len()).rev() {
            let mean = tree.mean(&tree.parts[at], deepest && at >= first);
            tree.means.push(mean);
        }
        let share = (count as f32).recip();
        let mut sum = Sample::NOTHING;
        for value in tree.means.iter().rev().take(count as usize) {
            sum.add_behind(*value, share);
        }
        self.parts = tree;
        sum
    }

    /// Takes the samples of knots.
    fn take(&mut self, march: &March, interval: &Interval, knots: &mut [Knot]) {
        for knots in knots.chunks_mut(Lanes::COUNT) {
            let mut places = [0.0; Lanes::COUNT];
            for (place, knot) in places.iter_mut().zip(&*knots) {
                *place = knot.place;
            }
            let found = self.media_mixtures(march, interval, &places[..knots.len()]);
            for (lane, knot) in knots.iter_mut().enumerate() {
                knot.value = found.unlit(lane).scaled(interval.length);
            }
        }
    }
}
