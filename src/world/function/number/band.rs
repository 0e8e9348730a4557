//! Bands of numbers as numbers to compute with.

use std::f64::consts::{LN_10, PI};

use super::{Number, Unary, low_power};
use crate::math::wide::widest;
use crate::math::{Band, Lanes};

impl Number for Band {
    #[inline(always)]
    fn wide(formula: impl FnOnce() -> Self) -> Self {
        widest(formula)
    }

    #[inline(always)]
    fn constant(v: f64) -> Self {
        Self::constant(v)
    }

    fn fixed(self) -> Option<f64> {
        Self::fixed(self)
    }

    fn unknown() -> Self {
        Self::UNKNOWN
    }

    #[inline(always)]
    fn is_negative(self) -> Option<bool> {
        if (-self.high()).all_positive() {
            return Some(true);
        }
        let low = self.low();
        (low.all_positive() || low.0.into_iter().all(|v| v >= 0.0)).then_some(false)
    }

    fn is_zero(self) -> Option<bool> {
        if self.low().all_positive() || (-self.high()).all_positive() {
            return Some(false);
        }
        (self.fixed() == Some(0.0)).then_some(true)
    }

    fn choose(self, negative: Self, other: Self) -> Self {
        let other = other.where_positive(self.low(), negative.hull(other));
        negative.where_positive(-self.high(), other)
    }

    fn either(self, zero: Self, other: Self) -> Self {
        zero.hull(other)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }

    #[inline(always)]
    fn upper(self, other: Self) -> Self {
        Self::max(self, other)
    }

    #[inline(always)]
    fn lower(self, other: Self) -> Self {
        Self::min(self, other)
    }

    fn powi(self, exponent: i32) -> Self {
        let power = Self::powi(self, exponent.unsigned_abs());
        if exponent < 0 { power.inverse() } else { power }
    }

    fn powf(self, exponent: Self) -> Self {
        Self::powf(self, exponent)
    }

    fn rem(self, divisor: Self) -> Self {
        self.remainder(divisor)
    }

    fn atan2(self, x: Self) -> Self {
        Self::atan2(self, x)
    }

    fn less(self, other: Self) -> Self {
        Self::less(self, other)
    }

    fn less_equal(self, other: Self) -> Self {
        Self::less_equal(self, other)
    }

    fn equal(self, other: Self) -> Self {
        Self::equal(self, other)
    }

    fn and(self, other: Self) -> Self {
        Self::and(self, other)
    }

    fn not(self) -> Self {
        self.is_false()
    }

    #[inline(always)]
    fn square(self) -> Self {
        Self::square(self)
    }

    #[inline(always)]
    fn unary(self, function: Unary) -> Self {
        match function {
            Unary::Abs => Self::abs(self),
            Unary::Sqrt => Self::sqrt(self),
            Unary::Square => Self::square(self),
            Unary::Sin => self.sin_cos().0,
            Unary::Cos => self.sin_cos().1,
            Unary::Power(exponent) => low_power(self, exponent),
            _ => rare(self, function),
        }
    }

    #[inline(always)]
    fn noise(generator: u8, point: [Self; 3]) -> Self {
        Self::noise(generator, point)
    }
}

/// What is out of the way: all that [`Number::unary`] doesn't do itself.
fn rare(band: Band, function: Unary) -> Band {
    match function {
        Unary::Acos => band.acos(),
        Unary::Acosh => band.acosh(),
        Unary::Asin => band.asin(),
        Unary::Asinh => band.asinh(),
        Unary::Atan => band.atan(),
        Unary::Atanh => band.atanh(),
        Unary::Ceil => band.ceil(),
        Unary::Cosh => band.cosh(),
        Unary::Degrees => band * (180.0 / PI),
        Unary::Exp => band.exp(),
        Unary::Floor => band.floor(),
        Unary::Int => {
            let fits = Lanes::splat(f64::from(i32::MAX)) - band.middle.abs() - band.spread();
            band.stepped(f64::trunc).where_positive(fits, Band::UNKNOWN)
        }
        Unary::Ln => band.ln(),
        Unary::Log => band.ln() * (1.0 / LN_10),
        Unary::Radians => band * (PI / 180.0),
        Unary::Sinh => band.sinh(),
        Unary::Tan => {
            let (sin, cos) = band.sin_cos();
            sin * cos.inverse()
        }
        Unary::Tanh => band.tanh(),
        Unary::Abs | Unary::Cos | Unary::Power(_) | Unary::Sin | Unary::Sqrt | Unary::Square => Band::UNKNOWN,
    }
}
