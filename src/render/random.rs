//! Randomness that belongs to a sample, not to a thread.

use crate::math::tally;

/// A sequence of numbers that depends only on where the sample is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Random {
    /// Nobody has asked yet, as for most samples: image coordinates and seed.
    Fresh([u64; 3]),
    /// The state after the last number.
    Running(u64),
}

impl Default for Random {
    #[inline]
    fn default() -> Self {
        Self::Running(0)
    }
}

impl Random {
    /// The sequence of the sample at image coordinates (x, y); every `seed` has others.
    #[inline]
    pub(super) fn of_sample(x: f64, y: f64, seed: u64) -> Self {
        Self::Fresh([x.to_bits(), y.to_bits(), seed])
    }

    /// The next number, uniform in [0, 1).
    pub(super) fn next(&mut self) -> f64 {
        tally::random_numbers(1);
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// The next two, to nine digits each.
    #[inline]
    pub(super) fn next_two(&mut self) -> [f64; 2] {
        tally::random_numbers(2);
        let bits = self.bits();
        // No closure for an array: it would not be compiled together with what is around it.
        let number = |half: u64| half as i64 as f64 / (1i64 << 32) as f64;
        [number(bits >> 32), number(bits & 0xffff_ffff)]
    }

    #[inline]
    fn bits(&mut self) -> u64 {
        let before = match *self {
            Self::Fresh([x, y, seed]) => scramble(scramble(scramble(x) ^ y) ^ seed),
            Self::Running(state) => state,
        };
        let state = before.wrapping_add(0x9e37_79b9_7f4a_7c15);
        *self = Self::Running(state);
        scramble(state)
    }
}

/// The finalizer of SplitMix64: every input bit changes every output bit.
fn scramble(mut bits: u64) -> u64 {
    bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ bits >> 31
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_uniform_over_neighbouring_samples() {
        let mut slots = [0; 10];
        for x in 0..100 {
            for y in 0..100 {
                slots[(Random::of_sample(f64::from(x), f64::from(y), 0).next() * 10.0) as usize] += 1;
            }
        }
        assert!(slots.iter().all(|&count| (900..1100).contains(&count)), "{slots:?}");
    }
}
