//! Displacements by place: hashes of coordinates, so the same picture comes out however it is cut
//! into threads (docs/spec/camera-image.md 7).

use crate::math::noise::hashes;
use crate::math::{DVec2, Lanes};

/// The low ends of the words that make up the displacements, one for each bit of an index.
const WORDS: [i64; 8] = [0x8182, 0x8302, 0x8602, 0x8c02, 0x9802, 0xb002, 0xe002, 0x4002];

/// 256 displacements from -½ to ½.
static DISPLACEMENTS: [f64; 256] = {
    let mut all = [0.0; 256];
    let mut index = 0;
    while index < all.len() {
        all[index] = displacement(index) as f64;
        index += 1;
    }
    all
};

/// The displacement of an index: its word's share of 65536 less ½, in single precision, rounded to
/// six digits.
const fn displacement(index: usize) -> f32 {
    let (mut word, mut bit) = (0, 0);
    while bit < WORDS.len() {
        if index >> bit & 1 == 1 {
            word ^= WORDS[bit];
        }
        bit += 1;
    }
    // A million parts of it, halves away from zero.
    let numerator = (word - 32768) * 15625;
    let millionths = numerator.signum() * ((numerator.abs() + 512) / 1024);
    (millionths as f64 / 1e6) as f32
}

/// The displacement that belongs to a place, each component from -½ to ½.
#[inline]
pub(super) fn jitter(x: f64, y: f64) -> DVec2 {
    let component = |a: f64, b: f64| displacement_of([a as i32, b as i32]);
    DVec2::new(component(1021.0 * x, 1019.0 * y), component(1019.0 * x, 1021.0 * y))
}

/// The displacements of four places, first those along x.
#[inline(always)]
pub(super) fn jitter_of_four(x: Lanes, y: Lanes) -> [Lanes; 2] {
    let pairs =
        [[truncated(x * 1021.0), truncated(y * 1019.0)], [truncated(x * 1019.0), truncated(y * 1021.0)]];
    let mut found = [Lanes::ZERO; 2];
    for (found, [a, b]) in found.iter_mut().zip(&pairs) {
        for lane in 0..Lanes::COUNT {
            found.0[lane] = displacement_of([a[lane], b[lane]]);
        }
    }
    found
}

/// The displacement that two whole numbers share.
#[inline(always)]
fn displacement_of([a, b]: [i32; 2]) -> f64 {
    let hashes = hashes();
    let hash = |index: i32| i32::from(hashes[(index & 4095) as usize]);
    DISPLACEMENTS[(hash(hash(a) ^ b) & 255) as usize]
}

/// Four numbers toward zero to 32 bits, as `as` does it, which is compiled for one number at a time: whole numbers are
/// the low bits of sums with one so large that its last bit is 1.
#[inline(always)]
fn truncated(numbers: Lanes) -> [i32; Lanes::COUNT] {
    const LARGE: f64 = 1.5 * (1u64 << (f64::MANTISSA_DIGITS - 1)) as f64;
    let mut found = [0; Lanes::COUNT];
    for (found, number) in found.iter_mut().zip(numbers.0) {
        *found = (number.trunc().clamp(i32::MIN.into(), i32::MAX.into()) + LARGE).to_bits() as i32;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_are_displaced_as_each_is() {
        for row in 0..4000 {
            let mut places = [Lanes::ZERO; 2];
            for lane in 0..Lanes::COUNT {
                let number = f64::from(row * 4 + lane as i32);
                places[0].0[lane] = (number * 0.618).fract() * 9000.0 - 3.0 + 0.03125 * number;
                places[1].0[lane] = if row == 0 { 4e6 } else { number * 0.37 - 2.0 };
            }
            let [x, y] = jitter_of_four(places[0], places[1]);
            for lane in 0..Lanes::COUNT {
                assert_eq!(DVec2::new(x.0[lane], y.0[lane]), jitter(places[0].0[lane], places[1].0[lane]));
            }
        }
    }

    #[test]
    fn displacements_are_the_listed_ones() {
        let rows =
            [(0, -0.5), (1, 0.005890), (2, 0.011749), (3, -0.490234), (128, -0.249969), (255, 0.001953)];
        for (index, expected) in rows {
            assert_eq!(DISPLACEMENTS[index], f64::from(expected as f32), "{index}");
        }
    }
}
