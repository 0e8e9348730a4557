//! Displacements by place: hashes of coordinates, so the same picture comes out however it is cut
//! into threads (docs/spec/camera-image.md 7).

use std::sync::LazyLock;

use crate::math::DVec2;
use crate::math::noise::hash;

/// The low ends of the words that make up the displacements, one for each bit of an index.
const WORDS: [u16; 8] = [0x8182, 0x8302, 0x8602, 0x8c02, 0x9802, 0xb002, 0xe002, 0x4002];

/// 256 displacements from -½ to ½.
static DISPLACEMENTS: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|index| {
        let word = (0..8).filter(|bit| index >> bit & 1 == 1).fold(0, |word, bit| word ^ WORDS[bit]);
        let exact = f64::from(word) / 65536.0 - 0.5;
        ((exact * 1e6).round() / 1e6) as f32
    })
});

/// The displacement that belongs to a place, each component from -½ to ½.
pub(super) fn jitter(x: f64, y: f64) -> DVec2 {
    let component = |a: f64, b: f64| {
        let index = hash(hash(truncate(a)) ^ truncate(b)) & 255;
        f64::from(DISPLACEMENTS[index as usize])
    };
    DVec2::new(component(1021.0 * x, 1019.0 * y), component(1019.0 * x, 1021.0 * y))
}

/// Truncation toward zero to 32 bits.
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
            assert_eq!(DISPLACEMENTS[index], expected, "{index}");
        }
    }
}
