//! `dents`, `granite`, `wrinkles`: sums and powers of noise (docs/spec/patterns-textures.md 2.2).

use crate::math::DVec3;
use crate::math::noise::{noise, noise_scaled};

/// Noise, cubed. Normals use it too.
pub(crate) fn dents(generator: u8, p: DVec3) -> f64 {
    let n = noise(generator, p);
    n * n * n
}

/// Six octaves of folded noise.
pub(super) fn granite(generator: u8, p: DVec3) -> f64 {
    const SCALES: [f64; 6] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];
    let mut sum = 0.0;
    let values = noise_scaled(generator, 4.0 * p, &SCALES);
    for (octave, scale) in SCALES.iter().enumerate() {
        let n = values[octave];
        let folded = if generator <= 1 { (0.5 - n).abs() } else { (1.0 - 2.0 * n).abs().min(0.5) };
        sum += folded / scale;
    }
    sum
}

/// The frequencies of the ten octaves of `wrinkles`.
pub(crate) const WRINKLES: [f64; 10] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0];

/// Ten octaves of noise.
pub(super) fn wrinkles(generator: u8, p: DVec3) -> f64 {
    let mut sum = 0.0;
    let values = noise_scaled(generator, p, &WRINKLES);
    for (octave, scale) in WRINKLES.iter().enumerate() {
        let n = values[octave];
        let height = if generator <= 1 { n } else { (2.0 * n - 0.5).clamp(0.0, 1.0) };
        sum += height / scale;
    }
    sum / 2.0
}
