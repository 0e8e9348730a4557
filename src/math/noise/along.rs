//! Noise along lines: its value with two derivatives, and bounds of what they leave out.

use glam::DVec3;

use super::tables::{GRADIENT, HASH, HASH_SIZE, PERLIN, PERLIN_SIZE, Perlin, SHIFT};
use crate::math::Lanes;
use crate::math::wide::widest;

/// Noise, before it is brought to 0 … 1 by force, on lines from `middle - slope` to `middle + slope`.
#[derive(Clone, Copy, Debug)]
pub struct Along {
    /// In the middle.
    pub value: Lanes,
    /// First derivatives by the share of the way from the middle to the end.
    pub rise: Lanes,
    /// Second derivatives, halved; 0 where the line leaves the lattice's cell.
    pub bend: Lanes,
    /// What `value + rise · s + bend · s²` may be off where s is from -1 to 1.
    pub off: Lanes,
}

// Bounds of derivatives of the sum over a cell's corners along unit directions (a, b, c). Along an axis f goes from
// 0 to 1 and the weights of its planes are 1 - s and s with s = f²(3 - 2f): s' is at most 3/2 (where s'' is 0), s''
// at most 6 (where s' is 0), s''' is 12. A corner's height is r₀/2 + r·d with all r within ±1 and distances d that
// on the average of the weights are at most 1/2, and on the average of two planes 1/2 as well. So heights of
// corners that are neighbours along an axis differ by at most 1 + 1 + 2/2 + 2/2 = 4 and slopes by 2; of such
// differences two differ by 8 and 4, and of those two by 16 and 8.

/// First derivatives along an axis: s' 4, and a slope.
const FIRST: f64 = 1.5 * 4.0 + 1.0;

/// Second derivatives. Those along an axis are at most s'' 4 + 2 s' 2; those along two, which count twice, s' s' 8 +
/// (s' + s') 2, and ab + bc + ca is at most 1. Where the latter are largest s' is 3/2 and the former are 6.
const SECOND: f64 = 60.0;

/// Third derivatives. Those along an axis are s''' 4 + 3 s'' 2, at most 84; along two s'' s' 8 + 2 s' s' 4 + s'' 2, at
/// most 84 + 18, and not both orders of the two at once, while three times the sum of the products a²b over the
/// axes by pairs, each in its larger order, is at most 1.9; along all s' s' s' 16 + 3 s' s' 4, at most 81, times
/// 6abc, at most 2/√3.
const THIRD: f64 = 0.578 * 84.0 + 1.9 * (84.0 + 18.0) + 1.155 * 81.0;

/// What the generators lose beside the lattice's planes, where they cut coordinates off, and to the rounding of
/// the coordinates.
const SLOP: f64 = 1e-7;

/// Where coordinates begin to be too large for the lattice's whole numbers.
const FAR: f64 = 2e9;

/// A polynomial of degree 2.
#[derive(Clone, Copy)]
struct Square([Lanes; 3]);

impl Square {
    /// `self` where the weight is 0, `other` where it is 1.
    #[inline(always)]
    fn mix(self, other: Self, [w0, w1, w2]: [Lanes; 3]) -> Self {
        let ([a0, a1, a2], [b0, b1, b2]) = (self.0, other.0);
        let (d0, d1, d2) = (b0 - a0, b1 - a1, b2 - a2);
        Self([a0 + d0 * w0, a1 + d0 * w1 + d1 * w0, a2 + d0 * w2 + d1 * w1 + d2 * w0])
    }
}

/// Noise on four lines; `reach` is how far the points may be beside them along each axis.
pub fn along(generator: u8, middle: [Lanes; 3], slope: [Lanes; 3], reach: [Lanes; 3]) -> Along {
    let [x, y, z] = middle;
    widest(
        #[inline(always)]
        || match generator {
            3 => {
                let moved = [x + PERLIN_SHIFT, y + PERLIN_SHIFT, z + PERLIN_SHIFT];
                Cells::new(moved, slope, &Perlin::corners).sum(reach, 0.5 * 1.59, 0.5 * 0.985)
            }
            2 => Cells::new(middle, slope, &lattice_corners).sum(reach, 0.489_855_82, 1.05242 * 0.489_855_82),
            _ => Cells::new(middle, slope, &lattice_corners).sum(reach, 1.0, 0.5),
        },
    )
}

/// The planes of a cell's corners: bit 0 of a corner's place is the side in x, bit 1 in y, bit 2 in z; each is
/// a height above the corner, and slopes.
type Corners = [[f64; 4]; 8];

/// Four lines, and the cells that their middles are in.
struct Cells {
    planes: [Corners; 4],
    /// Of the middles, from the cells' lower planes.
    offset: [Lanes; 3],
    slope: [Lanes; 3],
    /// What rounding moves the points by.
    rounding: Lanes,
}

impl Cells {
    #[inline(always)]
    fn new(middle: [Lanes; 3], slope: [Lanes; 3], corners: &impl Fn([f64; 3]) -> Corners) -> Self {
        let [x, y, z] = middle;
        let [a, b, c] = [x.map(f64::floor), y.map(f64::floor), z.map(f64::floor)];
        let planes = [
            corners([a.0[0], b.0[0], c.0[0]]),
            corners([a.0[1], b.0[1], c.0[1]]),
            corners([a.0[2], b.0[2], c.0[2]]),
            corners([a.0[3], b.0[3], c.0[3]]),
        ];
        let far = x.abs() + y.abs() + z.abs();
        let rounding = (far * f64::EPSILON).where_positive(-far + FAR, Lanes::splat(f64::INFINITY));
        Self { planes, offset: [x - a, y - b, z - c], slope, rounding }
    }

    #[inline(always)]
    fn part(&self, side: usize, i: usize) -> Lanes {
        let [a, b, c, d] = &self.planes;
        Lanes([a[side][i], b[side][i], c[side][i], d[side][i]])
    }

    /// From a side's plane.
    #[inline(always)]
    fn distance(&self, side: usize, axis: usize) -> Lanes {
        if side >> axis & 1 == 0 { self.offset[axis] } else { self.offset[axis] - 1.0 }
    }

    #[inline(always)]
    fn height(&self, side: usize) -> Square {
        let (r1, r2, r3) = (self.part(side, 1), self.part(side, 2), self.part(side, 3));
        let [x, y, z] = [self.distance(side, 0), self.distance(side, 1), self.distance(side, 2)];
        let level = self.part(side, 0) + r1 * x + r2 * y + r3 * z;
        Square([level, r1 * self.slope[0] + r2 * self.slope[1] + r3 * self.slope[2], Lanes::ZERO])
    }

    /// s, and its derivatives times the powers of the slope over their factorials.
    #[inline(always)]
    fn weight(&self, axis: usize) -> [Lanes; 3] {
        let (f, k) = (self.offset[axis], self.slope[axis]);
        [f * f * (f * -2.0 + 3.0), f * (-f + 1.0) * k * 6.0, (f * -2.0 + 1.0) * k * k * 3.0]
    }

    #[inline(always)]
    fn row(&self, first: usize) -> Square {
        self.height(first).mix(self.height(first + 1), self.weight(0))
    }

    #[inline(always)]
    fn layer(&self, first: usize) -> Square {
        self.row(first).mix(self.row(first + 2), self.weight(1))
    }

    /// How far a line is from leaving its cell along an axis.
    #[inline(always)]
    fn room(&self, axis: usize, reach: Lanes) -> Lanes {
        let spread = self.slope[axis].abs() + reach;
        (self.offset[axis] - spread).zip(-self.offset[axis] + 1.0 - spread, f64::min)
    }

    #[inline(always)]
    fn sum(&self, reach: [Lanes; 3], factor: f64, shift: f64) -> Along {
        let Square([value, rise, bend]) = self.layer(0).mix(self.layer(4), self.weight(2));
        // Only within a cell second derivatives are smooth.
        let [a, b, c] = [self.room(0, reach[0]), self.room(1, reach[1]), self.room(2, reach[2])];
        let inside = a.zip(b, f64::min).zip(c, f64::min);
        let [x, y, z] = self.slope;
        let square = x * x + y * y + z * z;
        let third = square * square.sqrt() * (THIRD / 6.0);
        let second = square * (SECOND / 2.0);
        let exact = bend.where_positive(inside, Lanes::ZERO);
        let beside =
            (reach[0] + reach[1] + reach[2]) * (FIRST * factor) + self.rounding * (FIRST * factor) + SLOP;
        Along {
            value: value * factor + shift,
            rise: rise * factor,
            bend: exact * factor,
            off: third.where_positive(inside, second) * factor + beside,
        }
    }
}

#[inline(always)]
fn hashed(hash: &[u16; HASH_SIZE], index: usize) -> usize {
    usize::from(hash[index & (HASH_SIZE - 1)])
}

/// The corners of the lattice of generators 1 and 2. Coordinates that don't fit into whole numbers have others
/// than noise has.
#[inline(always)]
fn lattice_corners([x, y, z]: [f64; 3]) -> Corners {
    let (hash, r) = (&**HASH, &*GRADIENT);
    let (x, y, z) = (plane(x), plane(y), plane(z));
    let (low, high) = (hashed(hash, x), hashed(hash, x + 1));
    let [a, b, c, d] = [low ^ y, high ^ y, low ^ (y + 1), high ^ (y + 1)].map(|column| hashed(hash, column));
    let mut corners = [[0.0; 4]; 8];
    for (corner, place) in corners.iter_mut().zip([
        a ^ z,
        b ^ z,
        c ^ z,
        d ^ z,
        a ^ (z + 1),
        b ^ (z + 1),
        c ^ (z + 1),
        d ^ (z + 1),
    ]) {
        let m = hashed(hash, place) & 255;
        *corner = [0.5 * r[m], r[m + 1], r[m + 2], r[m + 3]];
    }
    corners
}

#[inline(always)]
fn plane(c: f64) -> usize {
    ((c as i32).wrapping_add(SHIFT) & 4095) as usize
}

/// What generator 3 adds to coordinates.
const PERLIN_SHIFT: f64 = 10_000_000.023_157_213;

impl Perlin {
    /// The corners of the lattice of generator 3.
    #[inline(always)]
    fn corners(cell: [f64; 3]) -> Corners {
        let tables = &**PERLIN;
        let mask = PERLIN_SIZE - 1;
        let [x, y, z] = cell.map(|c| c as i64 as usize & mask);
        let mut corners = [[0.0; 4]; 8];
        for (side, corner) in corners.iter_mut().enumerate() {
            let column = usize::from(tables.shuffle[(x + (side & 1)) & mask]);
            let row = usize::from(tables.shuffle[(column + ((y + (side >> 1 & 1)) & mask)) & mask]);
            let DVec3 { x, y, z } = tables.gradient[(row + ((z + (side >> 2)) & mask)) & mask];
            *corner = [0.0, x, y, z];
        }
        corners
    }
}

#[cfg(test)]
mod tests {
    use super::super::noise;
    use super::*;

    #[test]
    fn noise_along_a_line_is_as_far_off_as_it_says() {
        for generator in 1..=3 {
            let mut widest: f64 = 0.0;
            for n in 0..30_000_u32 {
                let at = |by: f64| (f64::from(n) * by).fract() * 14.0 - 7.0;
                let middle = [at(0.754_877_666), at(0.569_840_290_9), at(0.430_159_709)];
                let half = 0.7_f64.powi((n % 30) as i32);
                let slope = [at(0.123_456), at(0.377_1), at(0.918_27)].map(|v| v / 7.0 * half);
                let found =
                    along(generator, middle.map(Lanes::splat), slope.map(Lanes::splat), [Lanes::ZERO; 3]);
                for step in -6..=6 {
                    let s = f64::from(step) / 6.0;
                    let [x, y, z] = [0, 1, 2].map(|i| middle[i] + slope[i] * s);
                    let expected = noise(generator, DVec3::new(x, y, z));
                    let line = found.value.0[1] + found.rise.0[1] * s + found.bend.0[1] * s * s;
                    let off = (line.clamp(0.0, 1.0) - expected).abs();
                    assert!(off <= found.off.0[1], "generator {generator}: {off} {found:?}");
                    widest = widest.max((off - SLOP) / (found.off.0[1] - SLOP));
                }
            }
            assert!(widest > 0.01, "bounds are {widest} of what they may be");
        }
    }
}
