//! Lattice noise, a point at a time (docs/spec/patterns-textures.md 1.2 and 1.3).

use glam::DVec3;

use super::EPSILON;
use super::tables::{GRADIENT, HASH, HASH_SIZE, SHIFT};

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
        let t = truncated(if c >= 0.0 { c } else { c - (1.0 - EPSILON) });
        let f = c - f64::from(t);
        let s = f * f * (3.0 - 2.0 * f);
        let index = (t.wrapping_add(SHIFT) & 4095) as usize;
        Self { index, offset: [f, f - 1.0], weight: [1.0 - s, s] }
    }
}

/// Towards zero; what is no 32-bit integer becomes the least one, as POV-Ray's processors have it.
fn truncated(c: f64) -> i32 {
    if c.abs() < 2_147_483_648.0 { c as i32 } else { i32::MIN }
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

/// What the corners around `p` add up to.
pub(super) fn sum(p: DVec3) -> f64 {
    let r = &*GRADIENT;
    let mut sum = 0.0;
    corners(p, [0, 1, 2, 3, 4, 5, 6, 7], |m, weight, d| sum += weight * slope(&r[m..m + 4], d));
    sum
}

/// Vector noise at `p`.
pub(super) fn vector(p: DVec3) -> DVec3 {
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
