//! Noise: lattice noise, vector noise and turbulence, equal to POV-Ray's to the last bit
//! (docs/spec/patterns-textures.md 1).

pub mod along;
#[cfg(target_arch = "x86_64")]
mod avx2;
mod four;
mod lattice;
mod tables;

use std::f64::consts::TAU;

use glam::DVec3;

use super::tally;
pub use four::{noise_at_four, noise_scaled_at_four};
use tables::{HASH, HASH_SIZE, PERLIN, PERLIN_SIZE, Stream, UNIFORM, UNIFORM_SIZE};

/// What POV-Ray adds where a coordinate on a boundary must fall on one side.
pub const EPSILON: f64 = 1e-10;

/// Noise at a point, 0 … 1. Generators are 1, 2 and 3; 0 acts as 1.
pub fn noise(generator: u8, p: DVec3) -> f64 {
    tally::noise(1);
    uncounted(generator, p)
}

fn uncounted(generator: u8, p: DVec3) -> f64 {
    match generator {
        3 => perlin(p),
        _ => leveled(generator, lattice_sum(p)),
    }
}

/// Brings a lattice sum to 0 … 1.
#[inline(always)]
fn leveled(generator: u8, sum: f64) -> f64 {
    match generator {
        2 => ((sum + 1.05242) * 0.48985582).clamp(0.0, 1.0),
        _ => (sum + 0.5).clamp(0.0, 1.0),
    }
}

/// What the corners of the cell around `p` add up to.
fn lattice_sum(p: DVec3) -> f64 {
    #[cfg(target_arch = "x86_64")]
    if let Some(lattice) = avx2::Lattice::get() {
        return lattice.sum(p);
    }
    lattice::sum(p)
}

/// Noise at `p` scaled by each of `scales`; a scale of 1 is exact.
pub fn noise_scaled<const N: usize>(generator: u8, p: DVec3, scales: &[f64; N]) -> [f64; N] {
    let mut values = [0.0; N];
    noise_octaves(generator, p, scales, &mut values);
    values
}

/// Noise at `p` scaled by each of `scales`, into as many `values`.
fn noise_octaves(generator: u8, p: DVec3, scales: &[f64], values: &mut [f64]) {
    tally::noise(scales.len());
    #[cfg(target_arch = "x86_64")]
    if let (Some(lattice), 0..=2) = (avx2::Lattice::get(), generator) {
        lattice.sums(p, scales, values);
        for value in values {
            *value = leveled(generator, *value);
        }
        return;
    }
    for (scale, value) in scales.iter().zip(values) {
        *value = uncounted(generator, *scale * p);
    }
}

/// Vector noise; every component about -0.6 … 0.6. The same for all generators.
pub fn vector_noise(p: DVec3) -> DVec3 {
    let [v] = vector_noise_scaled(p, &[1.0]);
    v
}

/// Vector noise at `p` scaled by each of `scales`; a scale of 1 is exact.
pub fn vector_noise_scaled<const N: usize>(p: DVec3, scales: &[f64; N]) -> [DVec3; N] {
    let mut vectors = [DVec3::ZERO; N];
    vector_octaves(p, scales, &mut vectors);
    vectors
}

/// Vector noise at `p` scaled by each of `scales`, into as many `vectors`.
fn vector_octaves(p: DVec3, scales: &[f64], vectors: &mut [DVec3]) {
    tally::vector_noise(scales.len());
    #[cfg(target_arch = "x86_64")]
    if let Some(lattice) = avx2::Lattice::get() {
        return lattice.vectors(p, scales, vectors);
    }
    for (scale, vector) in scales.iter().zip(vectors) {
        *vector = lattice::vector(*scale * p);
    }
}

/// Generator 3.
fn perlin(p: DVec3) -> f64 {
    let tables = &**PERLIN;
    let mask = PERLIN_SIZE - 1;
    let place = |c: f64| {
        let t = c + 10_000_000.023_157_213;
        let n = t.floor();
        let r0 = t - n;
        let low = n as i64 as usize & mask;
        ([low, (low + 1) & mask], [r0, r0 - 1.0], r0 * r0 * (3.0 - 2.0 * r0))
    };
    let ((bx, rx, sx), (by, ry, sy), (bz, rz, sz)) = (place(p.x), place(p.y), place(p.z));
    let shuffled = |index: usize| usize::from(tables.shuffle[index & mask]);
    let column = [shuffled(bx[0]), shuffled(bx[1])];
    let value = |i: usize, j: usize, k: usize| {
        let g = tables.gradient[(shuffled(column[i] + by[j]) + bz[k]) & mask];
        rx[i] * g.x + ry[j] * g.y + rz[k] * g.z
    };
    let mix = |t: f64, a: f64, b: f64| a + t * (b - a);
    let row = |j, k| mix(sx, value(0, j, k), value(1, j, k));
    let layer = |k| mix(sy, row(0, k), row(1, k));
    (0.5 * (1.59 * mix(sz, layer(0), layer(1)) + 0.985)).clamp(0.0, 1.0)
}

/// Octaves of noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Octaves {
    /// How many, 1 … 10.
    pub count: u32,
    /// Strength of an octave over that of the one before it.
    pub omega: f64,
    /// Frequency of an octave over that of the one before it.
    pub lambda: f64,
}

/// The most octaves there may be.
const MOST_OCTAVES: usize = 10;

impl Octaves {
    /// Scalar turbulence at `p`.
    pub fn scalar(&self, generator: u8, p: DVec3) -> f64 {
        let mut values = [0.0; MOST_OCTAVES];
        let values = &mut values[..self.count()];
        noise_octaves(generator, p, &self.frequencies()[..values.len()], values);
        if generator > 1 {
            values.iter_mut().for_each(|n| *n = 2.0 * *n - 0.5);
            values[0] = values[0].clamp(0.0, 1.0);
        }
        let mut sum = values[0];
        let mut strength = 1.0;
        for n in &values[1..] {
            strength *= self.omega;
            sum += strength * n;
        }
        sum
    }

    /// Vector turbulence at `p`.
    pub fn vector(&self, p: DVec3) -> DVec3 {
        tally::vector_noise(self.count());
        #[cfg(target_arch = "x86_64")]
        if let Some(lattice) = avx2::Lattice::get() {
            return lattice.turbulence(p, self);
        }
        let mut sum = lattice::vector(p);
        let (mut strength, mut frequency) = (1.0, 1.0);
        for _ in 1..self.count() {
            strength *= self.omega;
            frequency *= self.lambda;
            sum += strength * lattice::vector(frequency * p);
        }
        sum
    }

    pub(super) fn count(&self) -> usize {
        (self.count as usize).clamp(1, MOST_OCTAVES)
    }

    fn frequencies(&self) -> [f64; MOST_OCTAVES] {
        let mut frequencies = [1.0; MOST_OCTAVES];
        for octave in 1..self.count() {
            frequencies[octave] = frequencies[octave - 1] * self.lambda;
        }
        frequencies
    }
}

/// The lattice hash table: 4096 numbers 0 … 4095, twice.
#[inline]
pub fn hashes() -> &'static [u16; HASH_SIZE] {
    &HASH
}

/// Hash of a cell's three integer coordinates, 0 … 4095 (docs/spec/patterns-textures.md 1.2).
#[inline]
pub fn cell_hash(cell: [i32; 3]) -> usize {
    let table: &[u16; HASH_SIZE] = &HASH;
    let low = |c: i32| (c & 4095) as usize;
    let hashed = |index: usize| usize::from(table[index & (HASH_SIZE - 1)]);
    hashed(hashed(hashed(low(cell[0])) ^ low(cell[1])) ^ low(cell[2]))
}

/// Whether anything has needed a table of noise so far. Each is made when it is first used.
pub fn has_tables() -> bool {
    tables::exist()
}

/// The `index`-th uniform random number of the fixed table, 0 … 1; indices wrap.
pub fn uniform(index: usize) -> f64 {
    UNIFORM[index % UNIFORM_SIZE]
}

/// Three consecutive numbers of the fixed table for a cell.
#[inline]
pub fn cell_point(cell: [i32; 3]) -> DVec3 {
    let table: &[f64] = &UNIFORM;
    let h = cell_hash(cell);
    let three = &table[h..h + 3];
    DVec3::new(three[0], three[1], three[2])
}

/// A centre of concentric waves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveSource {
    /// On the unit sphere.
    pub center: DVec3,
    /// 0.01 … 1.01.
    pub frequency: f64,
}

/// The sources of `ripples` and `waves` (docs/spec/patterns-textures.md 1.9).
pub fn wave_sources(count: u32) -> Box<[WaveSource]> {
    let mut stream = Stream(-560_851_967_i32 as u32);
    (0..count.max(1))
        .map(|i| {
            let center = vector_noise(DVec3::new(f64::from(i), 0.0, 0.0));
            // Divided, not multiplied by the reciprocal: it makes a difference in the last digit.
            WaveSource {
                center: center / center.length(),
                frequency: stream.next() as f64 * 0.000_030_518_509_476 + 0.01,
            }
        })
        .collect()
}

/// A sine of period 1 (docs/spec/patterns-textures.md 1.10).
pub fn cycle(v: f64) -> f64 {
    if v >= 0.0 {
        (((v - v.floor()) * 50000.0) / 50000.0 * TAU).sin()
    } else {
        -((0.0 - (v + (0.0 - v).floor())) * 50000.0 / 50000.0 * TAU).sin()
    }
}

/// A triangle of period 1 and height 1 (docs/spec/patterns-textures.md 1.10).
pub fn triangle(v: f64) -> f64 {
    let offset = if v >= 0.0 { v - v.floor() } else { v + 1.0 + v.abs().floor() };
    if offset >= 0.5 { 2.0 * (1.0 - offset) } else { 2.0 * offset }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [DVec3; 3] =
        [DVec3::new(0.1, 0.2, 0.3), DVec3::new(-1.3, 2.7, 0.45), DVec3::new(5.25, -3.5, 7.125)];

    fn close(found: f64, expected: f64) {
        assert!((found - expected).abs() < 1e-15, "{found} is not {expected}");
    }

    #[test]
    fn noise_is_povrays() {
        let observed = [
            [0.299242909009914, 0.868937304112420, 0.478091737974548],
            [0.417192032656637, 0.696260147718979, 0.504802172425147],
            [0.652260853720098, 0.464621616739384, 0.534898186675229],
        ];
        for (generator, row) in (1..).zip(observed) {
            for (p, expected) in POINTS.into_iter().zip(row) {
                close(noise(generator, p), expected);
            }
        }
        close(noise(0, POINTS[0]), noise(1, POINTS[0]));
    }

    #[test]
    fn cells_hash_as_specified() {
        let hashes = [[0, 0, 0], [1, 0, 0], [-1, -1, -1]].map(cell_hash);
        assert_eq!(hashes, [3687, 837, 3535]);
    }

    #[test]
    fn wave_sources_are_povrays() {
        let source = wave_sources(3)[2];
        let center = DVec3::new(-0.444551085054765, 0.623328984838576, 0.643300326003913);
        assert!(source.center.abs_diff_eq(center, 1e-15));
        close(source.frequency, 0.433169652394216);
    }
}
