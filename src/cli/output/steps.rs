//! Rounding through a curve by looking the result up: a curve costs a power, a pixel has three.

use super::samples::{Curve, round};

/// Parts of 0 … 1 whose first step is known.
const PARTS: usize = 1024;

/// Where a number rounded through a curve goes up by one. The curve rises.
#[derive(Debug)]
pub(super) struct Steps {
    /// The least number that becomes each whole number from 1 on; infinite behind the last.
    least: Vec<f32>,
    /// What the lowest number of each part becomes.
    first: Vec<u16>,
}

impl Steps {
    /// For whole numbers of so many bits.
    pub(super) fn new(curve: Curve, bits: u8) -> Self {
        let value = |number: f32| round(curve.encode(number), bits);
        let top = value(1.0);
        let mut least: Vec<f32> = (1..=top)
            .map(|wanted| {
                // Positive floats are in the order of their bits.
                let (mut below, mut reached) = (0, 1.0_f32.to_bits());
                while reached - below > 1 {
                    let middle = below + (reached - below) / 2;
                    if value(f32::from_bits(middle)) >= wanted { reached = middle } else { below = middle }
                }
                f32::from_bits(reached)
            })
            .collect();
        least.push(f32::INFINITY);
        let first = (0..=PARTS).map(|part| value(part as f32 / PARTS as f32)).collect();
        Self { least, first }
    }

    /// The whole number that stands for `number`; 0 for what is none.
    #[inline]
    #[expect(clippy::manual_clamp, reason = "what is no number becomes 0 here, and stays none in `clamp`")]
    pub(super) fn round(&self, number: f32) -> u16 {
        let number = number.max(0.0).min(1.0);
        let mut value = self.first[(number * PARTS as f32) as usize];
        while number >= self.least[usize::from(value)] {
            value += 1;
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Gamma;

    #[test]
    fn a_number_looked_up_is_the_number_computed() {
        for (working, file) in [(Gamma::LINEAR, Gamma::Srgb), (Gamma::Power(2.2), Gamma::Power(1.8))] {
            let curve = Curve { working: Some(working), file };
            for bits in [1, 5, 8] {
                let steps = Steps::new(curve, bits);
                let odd = [-1.0, -0.0, 1.0, 1.5, f32::INFINITY, f32::NAN, f32::MIN_POSITIVE];
                for number in (0..200_000).map(|n| n as f32 / 190_000.0).chain(odd) {
                    let expected = round(curve.encode(number), bits);
                    assert_eq!(steps.round(number), expected, "{number} in {bits} bits");
                }
            }
        }
    }
}
