//! Bands with bands of their derivatives: what a function of two parameters does over a part of these.
//!
//! Derivatives follow from the rules of differentiation, computed in bands, so they hold all that the function's
//! derivatives are over the part. Where it has a kink there they hold those of both sides and all between, with which
//! the mean value theorem is true as well; where it jumps, or is no number, or its derivative isn't told, they say
//! nothing.

mod noise;

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::band::Band;
use super::lanes::Lanes;

/// A band, with derivatives by two parameters.
#[derive(Clone, Copy, Debug)]
pub struct Slant {
    /// The function's values.
    pub value: Band,
    /// How fast they rise with either parameter.
    pub rises: [Band; 2],
}

const ZERO: Band = Band::constant(0.0);

impl Slant {
    /// Nothing is known.
    pub const UNKNOWN: Self = Self::unknown_rise(Band::UNKNOWN);

    /// One number.
    #[inline(always)]
    pub const fn constant(v: f64) -> Self {
        Self { value: Band::constant(v), rises: [ZERO; 2] }
    }

    /// Values of which it isn't known how fast they rise.
    pub const fn unknown_rise(value: Band) -> Self {
        Self { value, rises: [Band::UNKNOWN; 2] }
    }

    /// What steps from one number to another: it doesn't rise where it is but one.
    pub fn stepped(value: Band) -> Self {
        let is_one = |i: usize| value.slope.0[i] == 0.0 && value.reach.0[i] == 0.0;
        let steps = Lanes([0, 1, 2, 3].map(|i| f64::from(u8::from(!is_one(i)))));
        Self { value, rises: [Band::UNKNOWN.where_positive(steps, ZERO); 2] }
    }

    /// A function of this one, given its values and how fast they rise with it.
    #[inline(always)]
    pub fn with(self, value: Band, rise: Band) -> Self {
        Self { value, rises: self.rises.map(|own| own * rise) }
    }

    /// A function of this and another, given its values and how fast they rise with both.
    #[inline(always)]
    pub fn with_both(self, other: Self, value: Band, [by, by_other]: [Band; 2]) -> Self {
        Self { value, rises: [0, 1].map(|i| self.rises[i] * by + other.rises[i] * by_other) }
    }

    /// Functions of each band.
    #[inline(always)]
    fn each(self, f: impl Fn(Band) -> Band) -> Self {
        Self { value: f(self.value), rises: self.rises.map(f) }
    }

    /// Functions of each pair of bands.
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(Band, Band) -> Band) -> Self {
        Self { value: f(self.value, other.value), rises: [0, 1].map(|i| f(self.rises[i], other.rises[i])) }
    }

    /// This in the lanes where `condition` is above zero, else `other`.
    #[inline(always)]
    pub fn where_positive(self, condition: Lanes, other: Self) -> Self {
        self.zip(other, |a, b| a.where_positive(condition, b))
    }

    /// In each lane `positive` where `condition` is above zero, `negative` where it is below, and where it isn't sure
    /// these `values` that rise as either does: of what is continuous there.
    pub fn joined(condition: Band, positive: Self, negative: Self, values: Band) -> Self {
        let rises = [0, 1].map(|i| positive.rises[i].hull(negative.rises[i]));
        let either = negative.where_positive(-condition.high(), Self { value: values, rises });
        positive.where_positive(condition.low(), either)
    }

    /// The square.
    #[inline(always)]
    pub fn square(self) -> Self {
        self.with(self.value.square(), self.value * 2.0)
    }

    /// One over it.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let inverse = self.value.inverse();
        self.with(inverse, -inverse.square())
    }

    /// The absolute value.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self::joined(self.value, self, -self, self.value.abs())
    }

    /// The larger of both.
    pub fn max(self, other: Self) -> Self {
        Self::joined(self.value - other.value, self, other, self.value.max(other.value))
    }

    /// The smaller of both.
    pub fn min(self, other: Self) -> Self {
        -(-self).max(-other)
    }
}

impl Add for Slant {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Slant {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul for Slant {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with_both(other, self.value * other.value, [other.value, self.value])
    }
}

impl Div for Slant {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "the product of one with the other's inverse")]
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}

impl Neg for Slant {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|band| -band)
    }
}

impl Add<f64> for Slant {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl Sub<f64> for Slant {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        self + -other
    }
}

impl Mul<f64> for Slant {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self.each(|band| band * other)
    }
}

impl Div<f64> for Slant {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self / Self::constant(other)
    }
}
