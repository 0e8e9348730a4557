//! `dents`, `granite`, `wrinkles`: sums and powers of noise (docs/spec/patterns-textures.md 2.2).

use crate::math::DVec3;
use crate::math::noise::noise;

/// Noise, cubed. Normals use it too.
pub(crate) fn dents(generator: u8, p: DVec3) -> f64 {
    let n = noise(generator, p);
    n * n * n
}

/// Six octaves of folded noise.
pub(super) fn granite(generator: u8, p: DVec3) -> f64 {
    let start = 4.0 * p;
    let mut scale = 1.0;
    let mut sum = 0.0;
    for _ in 0..6 {
        let n = noise(generator, scale * start);
        let folded = if generator <= 1 { (0.5 - n).abs() } else { (1.0 - 2.0 * n).abs().min(0.5) };
        sum += folded / scale;
        scale *= 2.0;
    }
    sum
}

/// Ten octaves of noise.
pub(super) fn wrinkles(generator: u8, p: DVec3) -> f64 {
    let octave = |q| match generator {
        0 | 1 => noise(generator, q),
        _ => (2.0 * noise(generator, q) - 0.5).clamp(0.0, 1.0),
    };
    let (mut scale, mut strength) = (1.0, 1.0);
    let mut sum = 0.0;
    for _ in 0..10 {
        sum += strength * octave(scale * p);
        scale *= 2.0;
        strength *= 0.5;
    }
    sum / 2.0
}
