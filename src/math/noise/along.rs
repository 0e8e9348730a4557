//! Noise along lines: its value with two derivatives, and bounds of what they leave out.

use super::tables::{HASH, HASH_SIZE, PERLIN, PERLIN_SIZE, SHIFT, SLOPES};
use crate::math::Lanes;

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

/// How steep a lattice's sum is along any direction at most, how fast that changes, and how fast that does in turn.
///
/// A derivative at a place in a cell along a direction is a sum over the cell's corners of what is linear in the
/// corner's gradient. No more comes of it than the sum of the largest amounts that any gradient of the table makes of it
/// at each corner. The largest of these sums, of all places and directions, are 4.0597, 20.248 and 88.13 for the tables
/// of generators 1 and 2, 2.1795, 11.592 and 54.78 for that of generator 3: found by climbing from the best of 30,000
/// places, from almost all of which it ends there. A twentieth is added.
#[derive(Clone, Copy)]
pub struct Steepness {
    /// The first derivative, at most.
    pub first: f64,
    /// The second.
    pub second: f64,
    /// The third.
    pub third: f64,
}

/// The sums of generators 1 and 2, and the components of vector noise.
pub const LATTICE: Steepness = Steepness { first: 4.3, second: 21.5, third: 93.0 };
/// The sum of generator 3.
const GRADIENTS: Steepness = Steepness { first: 2.3, second: 12.2, third: 58.0 };

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

/// What a generator makes of its lattice's sum, before it is brought to 0 … 1 by force.
struct Brought {
    factor: f64,
    shift: f64,
    most: Steepness,
}

impl Brought {
    #[inline(always)]
    fn by(generator: u8) -> Self {
        let (factor, shift, most) = match generator {
            3 => (0.5 * 1.59, 0.5 * 0.985, GRADIENTS),
            2 => (0.489_855_82, 1.05242 * 0.489_855_82, LATTICE),
            _ => (1.0, 0.5, LATTICE),
        };
        Self { factor, shift, most }
    }
}

/// How fast noise rises along each axis at four points, before it is brought to 0 … 1 by force, and how fast that
/// changes with the distance at most.
#[inline(always)]
pub fn rises(generator: u8, points: [Lanes; 3]) -> ([Lanes; 3], f64) {
    let along_axis = |axis: usize| {
        let slope = [0, 1, 2].map(|i| Lanes::splat(f64::from(u8::from(i == axis))));
        along(generator, points, slope, [Lanes::ZERO; 3]).rise
    };
    let Brought { factor, most, .. } = Brought::by(generator);
    ([along_axis(0), along_axis(1), along_axis(2)], most.second * factor)
}

/// Noise on four lines; `reach` is how far the points may be beside them along each axis.
#[inline(always)]
pub fn along(generator: u8, middle: [Lanes; 3], slope: [Lanes; 3], reach: [Lanes; 3]) -> Along {
    let brought = Brought::by(generator);
    if generator == 3 {
        let [x, y, z] = middle;
        let moved = [x + PERLIN_SHIFT, y + PERLIN_SHIFT, z + PERLIN_SHIFT];
        let first = perlin_corners(&moved, 0);
        if are_in_one_cell(&moved) {
            return Cells::new(moved, slope, &PERLIN.slopes, One(first)).sum(reach, brought);
        }
        let others = [perlin_corners(&moved, 1), perlin_corners(&moved, 2), perlin_corners(&moved, 3)];
        return Cells::new(moved, slope, &PERLIN.slopes, Four(first, others)).sum(reach, brought);
    }
    let first = lattice_corners(&middle, 0);
    if are_in_one_cell(&middle) {
        return Cells::new(middle, slope, &SLOPES, One(first)).sum(reach, brought);
    }
    let others = [lattice_corners(&middle, 1), lattice_corners(&middle, 2), lattice_corners(&middle, 3)];
    Cells::new(middle, slope, &SLOPES, Four(first, others)).sum(reach, brought)
}

/// Whether four points are in the same cell of a lattice, as those of short stretches mostly are.
#[inline(always)]
fn are_in_one_cell([x, y, z]: &[Lanes; 3]) -> bool {
    let apart = |c: &Lanes| {
        let plane = c.map(f64::floor);
        (plane - plane.0[0]).abs()
    };
    (apart(x) + apart(y) + apart(z)).bits(|apart| apart == 0.0) == 15
}

/// The places in a table of the planes of a cell's corners: bit 0 of a corner's place is the side in x, bit 1 in y,
/// bit 2 in z; each plane is a height above the corner, and slopes.
type Corners = [usize; 8];

/// The cells that four points are in.
trait Place {
    /// A number of the plane of a corner of each.
    fn part<const SIZE: usize>(&self, table: &[[f64; 4]; SIZE], side: usize, i: usize) -> Lanes;
}

/// The same cell for all.
struct One(Corners);

/// The cell of the first, and those of the others.
struct Four(Corners, [Corners; 3]);

impl Place for One {
    #[inline(always)]
    fn part<const SIZE: usize>(&self, table: &[[f64; 4]; SIZE], side: usize, i: usize) -> Lanes {
        Lanes::splat(table[self.0[side] & (SIZE - 1)][i])
    }
}

impl Place for Four {
    #[inline(always)]
    fn part<const SIZE: usize>(&self, table: &[[f64; 4]; SIZE], side: usize, i: usize) -> Lanes {
        let Self(first, others) = self;
        let at = [first[side], others[0][side], others[1][side], others[2][side]];
        let mask = SIZE - 1;
        Lanes([
            table[at[0] & mask][i],
            table[at[1] & mask][i],
            table[at[2] & mask][i],
            table[at[3] & mask][i],
        ])
    }
}

/// Four lines, and the cells that their middles are in.
struct Cells<P, const SIZE: usize> {
    table: &'static [[f64; 4]; SIZE],
    place: P,
    /// Of the middles, from the cells' lower planes.
    offset: [Lanes; 3],
    slope: [Lanes; 3],
    /// What rounding moves the points by.
    rounding: Lanes,
}

impl<P: Place, const SIZE: usize> Cells<P, SIZE> {
    #[inline(always)]
    fn new(middle: [Lanes; 3], slope: [Lanes; 3], table: &'static [[f64; 4]; SIZE], place: P) -> Self {
        let [x, y, z] = middle;
        let offset = [x - x.map(f64::floor), y - y.map(f64::floor), z - z.map(f64::floor)];
        let far = x.abs() + y.abs() + z.abs();
        let rounding = (far * f64::EPSILON).where_positive(-far + FAR, Lanes::splat(f64::INFINITY));
        Self { table, place, offset, slope, rounding }
    }

    #[inline(always)]
    fn part(&self, side: usize, i: usize) -> Lanes {
        self.place.part(self.table, side, i)
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
    fn sum(&self, reach: [Lanes; 3], Brought { factor, shift, most }: Brought) -> Along {
        let Square([value, rise, bend]) = self.layer(0).mix(self.layer(4), self.weight(2));
        // Only within a cell second derivatives are smooth.
        let [a, b, c] = [self.room(0, reach[0]), self.room(1, reach[1]), self.room(2, reach[2])];
        let inside = a.zip(b, f64::min).zip(c, f64::min);
        let [x, y, z] = self.slope;
        let square = x * x + y * y + z * z;
        let third = square * square.sqrt() * (most.third / 6.0);
        let second = square * (most.second / 2.0);
        let exact = bend.where_positive(inside, Lanes::ZERO);
        let beside = (reach[0] + reach[1] + reach[2] + self.rounding) * (most.first * factor) + SLOP;
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

/// The corners around a lane's point in the lattice of generators 1 and 2. Coordinates that don't fit into whole
/// numbers have others than noise has.
#[inline(always)]
fn lattice_corners(p: &[Lanes; 3], lane: usize) -> Corners {
    let hash = &**HASH;
    let (x, y, z) = (plane(p[0].0[lane]), plane(p[1].0[lane]), plane(p[2].0[lane]));
    let (low, high) = (hashed(hash, x), hashed(hash, x + 1));
    let (a, b) = (hashed(hash, low ^ y), hashed(hash, high ^ y));
    let (c, d) = (hashed(hash, low ^ (y + 1)), hashed(hash, high ^ (y + 1)));
    // Written out: closures given to arrays' methods are calls.
    [
        hashed(hash, a ^ z) & 255,
        hashed(hash, b ^ z) & 255,
        hashed(hash, c ^ z) & 255,
        hashed(hash, d ^ z) & 255,
        hashed(hash, a ^ (z + 1)) & 255,
        hashed(hash, b ^ (z + 1)) & 255,
        hashed(hash, c ^ (z + 1)) & 255,
        hashed(hash, d ^ (z + 1)) & 255,
    ]
}

#[inline(always)]
fn plane(c: f64) -> usize {
    ((c.floor() as i32).wrapping_add(SHIFT) & 4095) as usize
}

/// What generator 3 adds to coordinates.
const PERLIN_SHIFT: f64 = 10_000_000.023_157_213;

/// The corners around a lane's point in the lattice of generator 3.
#[inline(always)]
fn perlin_corners(p: &[Lanes; 3], lane: usize) -> Corners {
    let shuffle = &PERLIN.shuffle;
    let mask = PERLIN_SIZE - 1;
    let whole = |c: f64| c.floor() as i64 as usize & mask;
    let (x, y, z) = (whole(p[0].0[lane]), whole(p[1].0[lane]), whole(p[2].0[lane]));
    let mut corners = [0; 8];
    for (side, corner) in corners.iter_mut().enumerate() {
        let column = usize::from(shuffle[(x + (side & 1)) & mask]);
        let row = usize::from(shuffle[(column + ((y + (side >> 1 & 1)) & mask)) & mask]);
        *corner = (row + ((z + (side >> 2)) & mask)) & mask;
    }
    corners
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::noise;
    use super::super::tables::GRADIENT;
    use super::*;

    /// A power series of four terms.
    type Series = [f64; 4];

    fn product(a: Series, b: Series) -> Series {
        let mut product = [0.0; 4];
        for i in 0..4 {
            for j in 0..4 - i {
                product[i + j] += a[i] * b[j];
            }
        }
        product
    }

    /// For each order of derivatives the sum over the corners of a cell of the most that a gradient makes of it.
    fn steepest(p: DVec3, u: DVec3, most: impl Fn([f64; 4]) -> f64) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for corner in 0..8 {
            let mut weight = [1.0, 0.0, 0.0, 0.0];
            let mut from = p;
            for axis in 0..3 {
                let (f, k) = (p[axis], u[axis]);
                let [a, b, c, d] = [
                    f * f * (3.0 - 2.0 * f),
                    6.0 * f * (1.0 - f) * k,
                    (3.0 - 6.0 * f) * k * k,
                    -2.0 * k * k * k,
                ];
                if corner >> axis & 1 == 1 {
                    weight = product(weight, [a, b, c, d]);
                    from[axis] -= 1.0;
                } else {
                    weight = product(weight, [1.0 - a, -b, -c, -d]);
                }
            }
            for (order, factor) in [1.0, 2.0, 6.0].into_iter().enumerate() {
                let (here, before) = (factor * weight[order + 1], factor * weight[order]);
                let of = here * from + before * u;
                sums[order] += most([0.5 * here, of.x, of.y, of.z]);
            }
        }
        sums
    }

    #[test]
    fn noise_is_no_steeper_than_it_says() {
        let lattice = |of: [f64; 4]| {
            let amounts = GRADIENT.windows(4).map(|r| (0..4).map(|i| of[i] * r[i]).sum::<f64>().abs());
            amounts.fold(0.0, f64::max)
        };
        let gradients = |of: [f64; 4]| DVec3::new(of[1], of[2], of[3]).length();
        let check = |most: &dyn Fn([f64; 4]) -> f64, said: Steepness| {
            let mut found = [0.0_f64; 3];
            for n in 0..800_u32 {
                let at = |by: f64| (f64::from(n) * by).fract();
                let mut p = DVec3::new(at(0.754_877_666), at(0.569_840_291), at(0.430_159_709));
                // The steepest places are in the middle of a cell or of its face.
                if n % 4 == 0 {
                    p = DVec3::splat(0.5) + 0.1 * (p - 0.5);
                    p.z = if n % 8 == 0 { p.z } else { 0.01 * p.z };
                }
                let u = DVec3::new(at(0.123_456) - 0.5, at(0.377_1) - 0.5, at(0.918_27) - 0.5).normalize();
                let u = if n % 3 == 0 { DVec3::Z } else { u };
                let sums = steepest(p, u, most);
                found = [0, 1, 2].map(|order| found[order].max(sums[order]));
            }
            for (found, said) in found.into_iter().zip([said.first, said.second, said.third]) {
                assert!(found <= said && found > 0.75 * said, "{found} {said}");
            }
        };
        check(&lattice, LATTICE);
        check(&gradients, GRADIENTS);
    }

    #[test]
    fn lines_in_cells_of_their_own_are_as_they_are_alone() {
        for generator in 1..=3 {
            for n in 0..2000_u32 {
                let number =
                    |lane: usize, by: f64| (f64::from(n * 4 + lane as u32) * by).fract() * 14.0 - 7.0;
                let four = |by: f64, size: f64| Lanes([0, 1, 2, 3].map(|lane| number(lane, by) * size));
                let middle = [four(0.754_877_666, 1.0), four(0.569_840_290_9, 1.0), four(0.430_159_709, 1.0)];
                let slope = [four(0.123_456, 0.03), four(0.377_1, 0.03), four(0.918_27, 0.03)];
                let found = along(generator, middle, slope, [Lanes::ZERO; 3]);
                for lane in 0..Lanes::COUNT {
                    let alone = |of: [Lanes; 3]| of.map(|c| Lanes::splat(c.0[lane]));
                    let one = along(generator, alone(middle), alone(slope), [Lanes::ZERO; 3]);
                    let parts =
                        |of: &Along, lane: usize| [of.value, of.rise, of.bend, of.off].map(|c| c.0[lane]);
                    assert_eq!(parts(&found, lane), parts(&one, 0), "generator {generator}, {n}");
                }
            }
        }
    }

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
