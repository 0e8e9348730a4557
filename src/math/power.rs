//! Powers of four numbers at once.

use std::f64::consts::{LN_2, SQRT_2};

use super::Lanes;

/// The bits of √½, where the range of the factors between powers of two begins.
const BELOW: u64 = SQRT_2.to_bits() - (1 << 52);
/// The bits of 1.
const ONE: u64 = 1.0_f64.to_bits();
/// The bits of a number behind the point.
const BEHIND: u64 = (1 << 52) - 1;

impl Lanes {
    /// Numbers that aren't negative to a positive power. Off by no more than 5·10⁻¹⁶ of it times 1 + |log₂| of it, where
    /// it is between 2⁻¹⁰²² and 2¹⁰²³: what is beyond is brought there, but for the powers of 0 and of the infinite.
    /// Numbers below 2⁻¹⁰²² don't count as any.
    ///
    /// `2^(exponent · log₂ x)`: the logarithm of what is left when powers of two are taken out as twice the series of the
    /// inverse hyperbolic tangent of `(m - 1) / (m + 1)`, no farther from 0 than 0.172; the exponential of the rest, no
    /// farther than ½ ln 2, as Taylor's series. What is left out of either is less than 10⁻¹⁷.
    #[inline(always)]
    pub fn power(self, exponent: f64) -> Self {
        // Adding and taking away 1.5·2⁵² rounds to the next whole number, which is then in the low bits.
        const ROUND: f64 = 6_755_399_441_055_744.0;
        // 2⁵² and a whole number behind it, and what the bits of exponents are counted from.
        const WHOLE: u64 = 0x4330_0000_0000_0000;
        const SHIFT: f64 = 4_503_599_627_370_496.0 + 1023.0;

        let from_below = |x: f64| x.to_bits().wrapping_add(ONE - BELOW);
        let twos = self.map(|x| f64::from_bits(WHOLE | from_below(x) >> 52)) - SHIFT;
        let left = self.map(|x| f64::from_bits((from_below(x) & BEHIND) + BELOW));
        let share = (left - 1.0) / (left + 1.0);
        let square = share * share;
        let mut series = Self::splat(ODD_PARTS[10]);
        for term in (0..10).rev() {
            series = series * square + ODD_PARTS[term];
        }
        let wanted = (twos + share * series * (2.0 / LN_2)) * exponent;
        let wanted = wanted.lesser(Self::splat(1023.0)).greater(Self::splat(-1022.0));
        let rounded = wanted + ROUND;
        let rest = (wanted - (rounded - ROUND)) * LN_2;
        let mut series = Self::splat(FACTORIALS[13]);
        for degree in (0..13).rev() {
            series = series * rest + FACTORIALS[degree];
        }
        let found = series * rounded.map(|n| f64::from_bits((n.to_bits() << 52).wrapping_add(ONE)));
        let found = found.where_positive(self, Self::ZERO);
        // The infinite, and what is no number, stay what they are.
        self.zip(found, |x, found| if x < f64::INFINITY { found } else { x })
    }
}

/// One over the odd numbers.
const ODD_PARTS: [f64; 11] = {
    let mut all = [1.0; 11];
    let mut term = 1;
    while term < all.len() {
        all[term] = 1.0 / (2 * term + 1) as f64;
        term += 1;
    }
    all
};

/// One over the factorials.
const FACTORIALS: [f64; 14] = {
    let mut all = [1.0; 14];
    let mut degree = 1;
    while degree < all.len() {
        all[degree] = all[degree - 1] / degree as f64;
        degree += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn four_powers_are_those_of_each() {
        let mut number = numbers(3);
        for turn in 0..100_000 {
            let exponent = [0.3, 1.0, 1.5, 2.2, 3.0, 7.9][turn % 6];
            let x = Lanes([(); 4].map(|()| (number() * 20.0).exp2()));
            let found = x.power(exponent);
            for lane in 0..Lanes::COUNT {
                let right = x.0[lane].powf(exponent);
                let off = (found.0[lane] - right).abs() / right;
                assert!(off <= 5e-16 * (1.0 + right.log2().abs()), "{}: {off:e}", x.0[lane]);
            }
        }
    }

    #[test]
    fn ends_of_the_range_keep_their_powers() {
        let Lanes([zero, one, infinite, none]) = Lanes([0.0, 1.0, f64::INFINITY, f64::NAN]).power(2.2);
        assert_eq!([zero, one, infinite], [0.0, 1.0, f64::INFINITY]);
        assert!(none.is_nan());
        let Lanes([small, large, ..]) = Lanes([1e-300, 1e300, 1.0, 1.0]).power(3.0);
        assert_eq!([small, large].map(f64::log2).map(f64::round), [-1022.0, 1023.0]);
    }
}
