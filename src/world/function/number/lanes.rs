//! Four numbers side by side as numbers to compute with: with the same bits as one after the other, but for sines and
//! cosines, which are as exact as [`Lanes::SINE_ERROR`].

use super::{Number, Unary, low_power, truth};
use crate::math::{Lanes, noise};

impl Number for Lanes {
    #[inline(always)]
    fn wide(formula: impl FnOnce() -> Self) -> Self {
        formula()
    }

    #[inline(always)]
    fn constant(v: f64) -> Self {
        Self::splat(v)
    }

    /// The number, if it is the same in all lanes.
    #[inline(always)]
    fn fixed(self) -> Option<f64> {
        (self == Self::splat(self.0[0])).then_some(self.0[0])
    }

    fn unknown() -> Self {
        Self::splat(f64::NAN)
    }

    #[inline(always)]
    fn is_negative(self) -> Option<bool> {
        alike(self.bits(|v| v < 0.0))
    }

    #[inline(always)]
    fn is_zero(self) -> Option<bool> {
        alike(self.bits(|v| v == 0.0))
    }

    #[inline(always)]
    fn choose(self, negative: Self, other: Self) -> Self {
        negative.where_positive(-self, other)
    }

    fn either(self, zero: Self, other: Self) -> Self {
        Self([0, 1, 2, 3].map(|i| if self.0[i] == 0.0 { zero.0[i] } else { other.0[i] }))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, f64::max)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, f64::min)
    }

    #[inline(always)]
    fn upper(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { b } else { a })
    }

    #[inline(always)]
    fn lower(self, other: Self) -> Self {
        self.zip(other, |a, b| if a <= b { a } else { b })
    }

    #[inline(always)]
    fn powi(self, exponent: i32) -> Self {
        self.map(|v| v.powi(exponent))
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        self.zip(exponent, f64::powf)
    }

    #[inline(always)]
    fn rem(self, divisor: Self) -> Self {
        self.zip(divisor, |a, b| a % b)
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.zip(x, f64::atan2)
    }

    #[inline(always)]
    fn less(self, other: Self) -> Self {
        self.zip(other, |a, b| truth(a < b))
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> Self {
        self.zip(other, |a, b| truth(a <= b))
    }

    #[inline(always)]
    fn equal(self, other: Self) -> Self {
        self.zip(other, |a, b| truth(a == b))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.zip(other, |a, b| truth(a != 0.0 && b != 0.0))
    }

    #[inline(always)]
    fn not(self) -> Self {
        self.map(|v| truth(v == 0.0))
    }

    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        self.zip(other, f64::hypot)
    }

    #[inline(always)]
    fn square(self) -> Self {
        self * self
    }

    #[inline(always)]
    fn unary(self, function: Unary) -> Self {
        match function {
            Unary::Abs => Self::abs(self),
            Unary::Sqrt => Self::sqrt(self),
            Unary::Square => self * self,
            Unary::Sin if is_small(self) => self.sin_cos().0,
            Unary::Cos if is_small(self) => self.sin_cos().1,
            Unary::Power(exponent) => low_power(self, exponent),
            _ => one_by_one(self, function),
        }
    }

    #[inline(always)]
    fn noise(generator: u8, [x, y, z]: [Self; 3]) -> Self {
        noise::noise_at_four(generator, x, y, z)
    }
}

/// Whether all lanes' bits are set; `None` where only some are.
#[inline(always)]
fn alike(bits: u32) -> Option<bool> {
    match bits {
        0 => Some(false),
        0b1111 => Some(true),
        _ => None,
    }
}

/// Whether [`Lanes::sin_cos`] takes these angles.
#[inline(always)]
fn is_small(angles: Lanes) -> bool {
    (-angles.abs() + Lanes::WIDEST_ANGLE).all_positive()
}

#[inline(never)]
fn one_by_one(v: Lanes, function: Unary) -> Lanes {
    v.map(|v| v.unary(function))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_at_once_are_as_one_after_the_other() {
        let numbers =
            |n: u32| [0.731, -1.37, 0.0, 2.9].map(|v| v * f64::from(n % 7) - 0.3 * f64::from(n % 3));
        let same = |found: Lanes, expected: [f64; 4], what: &str| {
            for (found, expected) in found.0.into_iter().zip(expected) {
                let is_same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
                assert!(
                    is_same || (found - expected).abs() <= Lanes::SINE_ERROR,
                    "{what}: {found} {expected}"
                );
            }
        };
        type Pair<N> = fn(N, N) -> N;
        let pairs: [(&str, Pair<f64>, Pair<Lanes>); 9] = [
            ("max", Number::max, Number::max),
            ("lower", Number::lower, Number::lower),
            ("powf", Number::powf, Number::powf),
            ("rem", Number::rem, Number::rem),
            ("less", Number::less, Number::less),
            ("equal", Number::equal, Number::equal),
            ("and", Number::and, Number::and),
            ("choose", |a, b| a.choose(b, a), |a, b| a.choose(b, a)),
            ("either", |a, b| a.either(b, a), |a, b| a.either(b, a)),
        ];
        for n in 0..60 {
            let (a, b) = (numbers(n), numbers(n + 1 + n / 7));
            for (what, one, four) in pairs {
                same(four(Lanes(a), Lanes(b)), [0, 1, 2, 3].map(|i| one(a[i], b[i])), what);
            }
            for function in [Unary::Sin, Unary::Cos, Unary::Sqrt, Unary::Power(7), Unary::Exp, Unary::Int] {
                same(Lanes(a).unary(function), a.map(|v| v.unary(function)), "unary");
            }
            for generator in 1..=3 {
                let found = Number::noise(generator, [Lanes(a), Lanes(b), Lanes(a)]);
                same(found, [0, 1, 2, 3].map(|i| Number::noise(generator, [a[i], b[i], a[i]])), "noise");
            }
        }
    }
}
