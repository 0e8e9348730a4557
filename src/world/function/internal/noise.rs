//! Internal functions made of noise (docs/spec/language.md 4.5, at the end).

use super::{Formula, PARAMETERS};
use crate::math::DVec3;
use crate::math::noise::noise;

/// Parameters besides the point, and the formula. `generator` is the scene's.
pub(super) fn find(number: u8, generator: u8) -> Option<(usize, Formula)> {
    let by_scene: Formula = match generator {
        1 => |x, y, z, _| noise(1, DVec3::new(x, y, z)),
        3 => |x, y, z, _| noise(3, DVec3::new(x, y, z)),
        _ => |x, y, z, _| noise(2, DVec3::new(x, y, z)),
    };
    Some(match number {
        29 => (6, hetero_mf),
        58 => (6, ridge),
        59 => (6, ridged_mf),
        76 => (0, by_scene),
        78 => (1, |x, y, z, p| noise(generator_of(p[0]), DVec3::new(x, y, z))),
        _ => return None,
    })
}

fn generator_of(parameter: f64) -> u8 {
    (parameter as i32 & 3) as u8
}

fn hetero_mf(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let [h, lacunarity, octaves, offset, t, generator, ..] = *p;
    let height = |q| 2.0 * noise(generator_of(generator), q) - 1.0 + offset;
    let mut q = DVec3::new(x, y, z);
    let mut sum = height(q);
    let step = lacunarity.powf(-h);
    let mut strength = step;
    q *= lacunarity;
    let mut i = 1.0;
    while i < octaves {
        sum += height(q) * strength * sum.powi(t as i32);
        q *= lacunarity;
        strength *= step;
        i += 1.0;
    }
    let rest = octaves.fract();
    if rest == 0.0 { sum } else { sum + rest * height(q) * strength * sum }
}

fn ridge(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let [lambda, octaves, omega, offset, ridge, generator, ..] = *p;
    let start = DVec3::new(x, y, z);
    let height = |q| (noise(generator_of(generator), q) - ridge).abs() / ridge.max(1.0 - ridge) - offset;
    let (mut sum, mut total) = (height(start), 1.0);
    let (mut frequency, mut strength) = (lambda, omega);
    for _ in 2..=octaves as i32 {
        sum += strength * height(frequency * start);
        total += strength;
        frequency *= lambda;
        strength *= omega;
    }
    let rest = octaves.fract();
    if rest != 0.0 {
        sum += rest * strength * height(frequency * start);
        total += rest * strength;
    }
    sum / (total * offset.max(1.0 - offset))
}

fn ridged_mf(x: f64, y: f64, z: f64, p: &[f64; PARAMETERS]) -> f64 {
    let [h, lacunarity, octaves, offset, gain, generator, ..] = *p;
    let mut q = DVec3::new(x, y, z);
    let height = |q| (offset - (2.0 * noise(generator_of(generator), q) - 1.0).abs()).powi(2);
    let mut signal = height(q);
    let mut sum = signal;
    let mut i = 1.0;
    while i < octaves {
        q *= lacunarity;
        signal = (signal * gain).clamp(0.0, 1.0) * height(q);
        sum += signal * lacunarity.powf(-h * i);
        i += 1.0;
    }
    sum
}
