//! Displacements by place: hashes of coordinates, so the same picture comes out however it is cut
//! into threads (docs/spec/camera-image.md 7).

use crate::math::DVec2;
use crate::math::noise::hashes;

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
    let hashes = hashes();
    let hash = |index: i32| i32::from(hashes[(index & 4095) as usize]);
    let component = |a: f64, b: f64| {
        let index = hash(hash(truncate(a)) ^ truncate(b)) & 255;
        DISPLACEMENTS[index as usize]
    };
    DVec2::new(component(1021.0 * x, 1019.0 * y), component(1019.0 * x, 1021.0 * y))
}

/// Truncation toward zero to 32 bits.
#[inline]
fn truncate(x: f64) -> i32 {
    x as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn displacements_are_the_listed_ones() {
        let rows =
            [(0, -0.5), (1, 0.005890), (2, 0.011749), (3, -0.490234), (128, -0.249969), (255, 0.001953)];
        for (index, expected) in rows {
            assert_eq!(DISPLACEMENTS[index], f64::from(expected as f32), "{index}");
        }
    }
}
