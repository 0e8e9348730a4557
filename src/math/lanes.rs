//! Four numbers side by side. Everything is inlined: within [`super::wide::widest`] four numbers are one register.

use std::f64::consts::FRAC_2_PI;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::DVec3;

/// Four numbers that are computed at once.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub struct Lanes(pub [f64; Lanes::COUNT]);

impl Lanes {
    /// How many numbers there are.
    pub const COUNT: usize = 4;

    /// Zeros.
    pub const ZERO: Self = Self([0.0; Self::COUNT]);

    /// The same number in all lanes.
    #[inline(always)]
    pub const fn splat(v: f64) -> Self {
        Self([v; Self::COUNT])
    }

    /// A function of each.
    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let [a, b, c, d] = self.0;
        Self([f(a), f(b), f(c), f(d)])
    }

    /// A function of each pair.
    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let ([a, b, c, d], [p, q, r, s]) = (self.0, other.0);
        Self([f(a, p), f(b, q), f(c, r), f(d, s)])
    }

    /// One of four points, given by their coordinates.
    #[inline(always)]
    pub fn point([x, y, z]: &[Self; 3], lane: usize) -> DVec3 {
        DVec3::new(x.0[lane], y.0[lane], z.0[lane])
    }

    /// Their absolute values.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(f64::abs)
    }

    /// Their square roots.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    /// This where `condition` is above zero, else `other`.
    #[inline(always)]
    pub fn where_positive(self, condition: Self, other: Self) -> Self {
        let ([a, b, c, d], [p, q, r, s]) = (self.0, other.0);
        let [i, j, k, l] = condition.0;
        let pick = |condition: f64, a: f64, b: f64| if condition > 0.0 { a } else { b };
        Self([pick(i, a, p), pick(j, b, q), pick(k, c, r), pick(l, d, s)])
    }

    /// The lesser of each pair; the second where one is no number.
    #[inline(always)]
    pub fn lesser(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { a } else { b })
    }

    /// The greater of each pair; the second where one is no number.
    #[inline(always)]
    pub fn greater(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }

    /// Their products with others, added to a third, rounded once.
    #[inline(always)]
    pub fn mul_add(self, factor: Self, sum: Self) -> Self {
        let ([a, b, c, d], [p, q, r, s], [i, j, k, l]) = (self.0, factor.0, sum.0);
        Self([a.mul_add(p, i), b.mul_add(q, j), c.mul_add(r, k), d.mul_add(s, l)])
    }

    /// The sum of products, as that of vectors.
    #[inline(always)]
    pub fn dot(a: &[Self; 3], b: &[Self; 3]) -> Self {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    /// For each number whether `holds`, as a bit.
    #[inline(always)]
    pub fn bits(self, holds: impl Fn(f64) -> bool) -> u32 {
        let [a, b, c, d] = self.0;
        u32::from(holds(a)) | u32::from(holds(b)) << 1 | u32::from(holds(c)) << 2 | u32::from(holds(d)) << 3
    }

    /// Whether all are above zero; what is no number is not.
    #[inline(always)]
    pub fn all_positive(self) -> bool {
        let [a, b, c, d] = self.0;
        (a > 0.0) & (b > 0.0) & (c > 0.0) & (d > 0.0)
    }

    /// Sines and cosines of numbers up to [`Self::WIDEST_ANGLE`], no farther off than [`Self::SINE_ERROR`].
    ///
    /// The rest over quarter turns, subtracted in three parts of which the first two are exact, and the
    /// polynomials of S. Moshier's Cephes library (netlib.org/cephes).
    #[inline(always)]
    pub fn sin_cos(self) -> (Self, Self) {
        const QUARTER: [f64; 3] =
            [1.570_796_251_296_997, 7.549_789_415_861_596e-8, 5.390_302_858_158_119e-15];
        const SIN: [f64; 6] = [
            1.589_623_015_765_465_6e-10,
            -2.505_074_776_285_780_7e-8,
            2.755_731_362_138_572_5e-6,
            -1.984_126_982_958_954e-4,
            8.333_333_333_322_118e-3,
            -1.666_666_666_666_663e-1,
        ];
        const COS: [f64; 6] = [
            -1.135_853_652_138_768_2e-11,
            2.087_570_084_197_473e-9,
            -2.755_731_417_929_674e-7,
            2.480_158_728_885_170_5e-5,
            -1.388_888_888_887_305_6e-3,
            4.166_666_666_666_659_3e-2,
        ];
        // Adding and taking away 1.5·2⁵² rounds to the next whole number.
        const ROUND: f64 = 6_755_399_441_055_744.0;
        let turns = self * FRAC_2_PI + ROUND;
        let whole = turns - ROUND;
        let rest = QUARTER.into_iter().fold(self, |rest, part| rest - whole * part);
        let square = rest * rest;
        let along = |terms: [f64; 6]| {
            let [first, others @ ..] = terms;
            others.into_iter().fold(Self::splat(first), |sum, term| sum * square + term)
        };
        let sin = rest + rest * square * along(SIN);
        let cos = square * square * along(COS) + (square * -0.5 + 1.0);
        let mut both = (sin, cos);
        for i in 0..Self::COUNT {
            let quarter = turns.0[i].to_bits();
            let (s, c) = if quarter & 1 == 0 { (sin.0[i], cos.0[i]) } else { (cos.0[i], sin.0[i]) };
            both.0.0[i] = if quarter & 2 == 0 { s } else { -s };
            both.1.0[i] = if (quarter + 1) & 2 == 0 { c } else { -c };
        }
        both
    }

    /// The largest angle that [`Self::sin_cos`] takes.
    pub const WIDEST_ANGLE: f64 = 1e6;

    /// What [`Self::sin_cos`] may be off.
    pub const SINE_ERROR: f64 = 1e-15;
}

macro_rules! lanewise {
    ($($operator:ident $method:ident $sign:tt),+) => {$(
        impl $operator for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $sign b)
            }
        }

        impl $operator<f64> for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.map(|a| a $sign other)
            }
        }
    )+};
}

lanewise!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_are_as_exact_as_they_claim() {
        let mut worst: f64 = 0.0;
        for n in 0..200_000 {
            let angle = f64::from(n - 100_000) * 0.000_317 * 1.000_1_f64.powi(n / 4);
            if angle.abs() > Lanes::WIDEST_ANGLE {
                continue;
            }
            let (sin, cos) = Lanes::splat(angle).sin_cos();
            worst = worst.max((sin.0[0] - angle.sin()).abs()).max((cos.0[3] - angle.cos()).abs());
        }
        assert!(worst <= Lanes::SINE_ERROR, "{worst:e}");
    }
}
