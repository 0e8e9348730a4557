//! Noise at four points at once, given by their coordinates: the same bits as at one after the other.

use glam::DVec3;

#[cfg(target_arch = "x86_64")]
use super::avx2;
use super::{MOST_OCTAVES, Octaves, lattice, leveled, uncounted};
use crate::math::{Lanes, tally};

/// [`super::noise`] at each of four points.
#[inline(always)]
pub fn noise_at_four(generator: u8, x: Lanes, y: Lanes, z: Lanes) -> Lanes {
    let [values] = noise_scaled_at_four(generator, &[x, y, z], &[1.0]);
    values
}

/// [`super::noise_scaled`] at each of four points.
#[inline(always)]
pub fn noise_scaled_at_four<const N: usize>(
    generator: u8,
    point: &[Lanes; 3],
    scales: &[f64; N],
) -> [Lanes; N] {
    let mut values = [Lanes::ZERO; N];
    octaves(generator, point, scales, &mut values);
    values
}

/// Noise at four points scaled by each of `scales`, into as many `values`.
#[inline(always)]
fn octaves(generator: u8, point: &[Lanes; 3], scales: &[f64], values: &mut [Lanes]) {
    tally::noise(Lanes::COUNT * values.len());
    #[cfg(target_arch = "x86_64")]
    if let (Some(lattice), 0..=2) = (avx2::Lattice::get(), generator) {
        lattice.sums_at_four(point, scales, values);
        for value in values {
            *value = leveled_at_four(generator, *value);
        }
        return;
    }
    for (scale, value) in scales.iter().zip(values) {
        *value = each(point, |p| uncounted(generator, *scale * p));
    }
}

/// [`leveled`] of each.
#[inline(always)]
fn leveled_at_four(generator: u8, sums: Lanes) -> Lanes {
    sums.map(
        #[inline(always)]
        |sum| leveled(generator, sum),
    )
}

/// Vector noise at four points scaled by each of `scales`, into as many `vectors`.
#[inline(always)]
fn vector_octaves(point: &[Lanes; 3], scales: &[f64], vectors: &mut [[Lanes; 3]]) {
    tally::vector_noise(Lanes::COUNT * vectors.len());
    #[cfg(target_arch = "x86_64")]
    if let Some(lattice) = avx2::Lattice::get() {
        return lattice.vectors_at_four(point, scales, vectors);
    }
    for (scale, vector) in scales.iter().zip(vectors) {
        for lane in 0..Lanes::COUNT {
            let found = lattice::vector(*scale * Lanes::point(point, lane));
            (vector[0].0[lane], vector[1].0[lane], vector[2].0[lane]) = (found.x, found.y, found.z);
        }
    }
}

impl Octaves {
    /// [`Self::scalar`] at each of four points.
    #[inline(always)]
    pub fn scalar_at_four(&self, generator: u8, point: &[Lanes; 3]) -> Lanes {
        let mut values = [Lanes::ZERO; MOST_OCTAVES];
        let values = &mut values[..self.count()];
        octaves(generator, point, &self.frequencies()[..values.len()], values);
        if generator > 1 {
            for value in &mut *values {
                *value = *value * 2.0 - 0.5;
            }
            values[0] = values[0].map(|n| n.clamp(0.0, 1.0));
        }
        let mut sum = values[0];
        let mut strength = 1.0;
        for n in &values[1..] {
            strength *= self.omega;
            sum = sum + *n * strength;
        }
        sum
    }

    /// [`Self::vector`] at each of four points.
    #[inline(always)]
    pub fn vector_at_four(&self, point: &[Lanes; 3]) -> [Lanes; 3] {
        let mut vectors = [[Lanes::ZERO; 3]; MOST_OCTAVES];
        let vectors = &mut vectors[..self.count()];
        vector_octaves(point, &self.frequencies()[..vectors.len()], vectors);
        let mut sum = vectors[0];
        let mut strength = 1.0;
        for vector in &vectors[1..] {
            strength *= self.omega;
            for axis in 0..3 {
                sum[axis] = sum[axis] + vector[axis] * strength;
            }
        }
        sum
    }
}

/// A function of each of four points.
fn each(point: &[Lanes; 3], value: impl Fn(DVec3) -> f64) -> Lanes {
    Lanes([0, 1, 2, 3].map(|lane| value(Lanes::point(point, lane))))
}
