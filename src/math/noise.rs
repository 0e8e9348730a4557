//! Noise: lattice noise, vector noise and turbulence, equal to POV-Ray's to the last bit
//! (docs/spec/patterns-textures.md 1).

mod tables;

use std::f64::consts::TAU;

use glam::DVec3;

use tables::{GRADIENT, HASH, HASH_SIZE, PERLIN, PERLIN_SIZE, Stream, UNIFORM, UNIFORM_SIZE};

/// What POV-Ray adds where a coordinate on a boundary must fall on one side.
pub const EPSILON: f64 = 1e-10;

/// Noise at a point, 0 … 1. Generators are 1, 2 and 3; 0 acts as 1.
pub fn noise(generator: u8, p: DVec3) -> f64 {
    match generator {
        3 => perlin(p),
        2 => ((lattice_sum(p) + 1.05242) * 0.48985582).clamp(0.0, 1.0),
        _ => (lattice_sum(p) + 0.5).clamp(0.0, 1.0),
    }
}

/// A coordinate's place between two lattice planes.
#[derive(Clone, Copy)]
struct Place {
    /// Number of the lower plane.
    index: usize,
    /// Distances from the lower and the upper plane; the second is negative.
    offset: [f64; 2],
    /// Influence of the lower and the upper plane.
    weight: [f64; 2],
}

impl Place {
    fn of(c: f64) -> Self {
        let t = if c >= 0.0 { c as i32 } else { (c - (1.0 - EPSILON)) as i32 };
        let f = c - f64::from(t);
        let s = f * f * (3.0 - 2.0 * f);
        let index = (t.wrapping_add(10000) & 4095) as usize;
        Self { index, offset: [f, f - 1.0], weight: [1.0 - s, s] }
    }
}

fn hashed(table: &[u16; HASH_SIZE], index: usize) -> usize {
    usize::from(table[index & (HASH_SIZE - 1)])
}

/// Calls `corner` with gradient index, weight and offset of the eight corners, in the given order
/// (bit 0 the side in x, bit 1 in y, bit 2 in z).
fn corners(p: DVec3, order: [usize; 8], mut corner: impl FnMut(usize, f64, DVec3)) {
    let table = &**HASH;
    let [x, y, z] = [Place::of(p.x), Place::of(p.y), Place::of(p.z)];
    let low = hashed(table, x.index);
    let high = hashed(table, x.index + 1);
    let columns = [
        hashed(table, low ^ y.index),
        hashed(table, high ^ y.index),
        hashed(table, low ^ (y.index + 1)),
        hashed(table, high ^ (y.index + 1)),
    ];
    for side in order {
        let (i, j, k) = (side & 1, side >> 1 & 1, side >> 2);
        let m = hashed(table, columns[side & 3] ^ (z.index + k)) & 255;
        let weight = x.weight[i] * y.weight[j] * z.weight[k];
        corner(m, weight, DVec3::new(x.offset[i], y.offset[j], z.offset[k]));
    }
}

/// Height of the plane through one corner.
fn slope(r: &[f64], d: DVec3) -> f64 {
    r[0] * 0.5 + r[1] * d.x + r[2] * d.y + r[3] * d.z
}

fn lattice_sum(p: DVec3) -> f64 {
    let r = &*GRADIENT;
    let mut sum = 0.0;
    corners(p, [0, 1, 2, 3, 4, 5, 6, 7], |m, weight, d| sum += weight * slope(&r[m..m + 4], d));
    sum
}

/// Vector noise; every component about -0.6 … 0.6. The same for all generators.
pub fn vector_noise(p: DVec3) -> DVec3 {
    let r = &*GRADIENT;
    let mut sum = DVec3::ZERO;
    corners(p, [0, 1, 3, 2, 6, 7, 5, 4], |m, weight, d| {
        let r = &r[m..m + 12];
        sum.x += weight * slope(&r[0..4], d);
        sum.y += weight * slope(&r[4..8], d);
        sum.z += weight * slope(&r[8..12], d);
    });
    sum
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

impl Octaves {
    /// Scalar turbulence at `p`.
    pub fn scalar(&self, generator: u8, p: DVec3) -> f64 {
        let single = |q| match generator {
            2 | 3 => 2.0 * noise(generator, q) - 0.5,
            _ => noise(generator, q),
        };
        let first = single(p);
        let mut sum = if generator > 1 { first.clamp(0.0, 1.0) } else { first };
        for (frequency, strength) in self.steps().skip(1) {
            sum += strength * single(frequency * p);
        }
        sum
    }

    /// Vector turbulence at `p`.
    pub fn vector(&self, p: DVec3) -> DVec3 {
        let mut sum = vector_noise(p);
        for (frequency, strength) in self.steps().skip(1) {
            sum += strength * vector_noise(frequency * p);
        }
        sum
    }

    fn steps(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        let (lambda, omega) = (self.lambda, self.omega);
        let next = move |&(frequency, strength): &(f64, f64)| Some((frequency * lambda, strength * omega));
        std::iter::successors(Some((1.0, 1.0)), next).take(self.count as usize)
    }
}

/// Entry `index` of the lattice hash table, 0 … 4095; indices wrap.
pub fn hash(index: i32) -> i32 {
    i32::from(HASH[(index & 4095) as usize])
}

/// Hash of a cell's three integer coordinates, 0 … 4095 (docs/spec/patterns-textures.md 1.2).
pub fn cell_hash(cell: [i32; 3]) -> usize {
    let table = &**HASH;
    let low = |c: i32| (c & 4095) as usize;
    hashed(table, hashed(table, hashed(table, low(cell[0])) ^ low(cell[1])) ^ low(cell[2]))
}

/// The `index`-th uniform random number of the fixed table, 0 … 1; indices wrap.
pub fn uniform(index: usize) -> f64 {
    UNIFORM[index % UNIFORM_SIZE]
}

/// Three consecutive numbers of the fixed table for a cell.
pub fn cell_point(cell: [i32; 3]) -> DVec3 {
    let h = cell_hash(cell);
    DVec3::new(uniform(h), uniform(h + 1), uniform(h + 2))
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
        .map(|i| WaveSource {
            center: vector_noise(DVec3::new(f64::from(i), 0.0, 0.0)).normalize(),
            frequency: stream.next() as f64 * 0.000_030_518_509_476 + 0.01,
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
