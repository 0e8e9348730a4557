//! What formulas are written for: numbers, four of them side by side, bands of numbers over stretches of a line, and
//! bands with how fast they rise.

mod band;
mod lanes;
mod slant;

use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::{DVec3, hyperbolic, noise};

/// A number that formulas can compute with, or what holds all numbers it may be.
pub(crate) trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// One number.
    fn constant(v: f64) -> Self;
    /// The number, if it is but one.
    fn fixed(self) -> Option<f64>;
    /// Any number.
    fn unknown() -> Self;
    /// Whether it is below 0; `None` where that isn't sure.
    fn is_negative(self) -> Option<bool>;
    /// Whether it is 0; `None` where that isn't sure.
    fn is_zero(self) -> Option<bool>;
    /// `negative` where `self` is below 0, else `other`; both where that isn't sure.
    fn choose(self, negative: Self, other: Self) -> Self;
    /// `zero` where `self` is 0, else `other`; both where that isn't sure.
    fn either(self, zero: Self, other: Self) -> Self;
    /// The larger; not what is no number.
    fn max(self, other: Self) -> Self;
    /// The smaller; not what is no number.
    fn min(self, other: Self) -> Self;
    /// The larger as POV-Ray compares: what is no number is not less.
    fn upper(self, other: Self) -> Self;
    /// The smaller as POV-Ray compares.
    fn lower(self, other: Self) -> Self;
    /// The product of so many of it.
    fn powi(self, exponent: i32) -> Self;
    /// The power.
    fn powf(self, exponent: Self) -> Self;
    /// What is left over a multiple of `divisor`, with the sign of `self`.
    fn rem(self, divisor: Self) -> Self;
    /// The angle from the x axis towards `self` on the y axis.
    fn atan2(self, x: Self) -> Self;
    /// 1 where it is below `other`, else 0.
    fn less(self, other: Self) -> Self;
    /// 1 where it isn't above `other`, else 0.
    fn less_equal(self, other: Self) -> Self;
    /// 1 where both are the same, else 0.
    fn equal(self, other: Self) -> Self;
    /// 1 where both aren't 0, else 0.
    fn and(self, other: Self) -> Self;
    /// 1 where it is 0, else 0.
    fn not(self) -> Self;
    /// Its second power.
    fn square(self) -> Self;
    /// A function of it.
    fn unary(self, function: Unary) -> Self;
    /// Noise at a point.
    fn noise(generator: u8, point: [Self; 3]) -> Self;

    /// Computes a formula in the widest registers, if that is worth while.
    fn wide(formula: impl FnOnce() -> Self) -> Self;

    /// What comes of `negative` where `self` is below 0, else of `other`; of both where that isn't sure.
    #[inline(always)]
    fn pick(self, negative: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self {
        match self.is_negative() {
            Some(true) => negative(),
            Some(false) => other(),
            None => self.choose(negative(), other()),
        }
    }

    /// Its absolute value.
    #[inline(always)]
    fn abs(self) -> Self {
        self.unary(Unary::Abs)
    }

    /// Its square root.
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.unary(Unary::Sqrt)
    }

    /// The power of e.
    #[inline(always)]
    fn exp(self) -> Self {
        self.unary(Unary::Exp)
    }

    /// The sine.
    #[inline(always)]
    fn sin(self) -> Self {
        self.unary(Unary::Sin)
    }

    /// The cosine.
    #[inline(always)]
    fn cos(self) -> Self {
        self.unary(Unary::Cos)
    }

    /// The length of the hypotenuse.
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }

    /// The quotient without its fraction.
    #[inline(always)]
    fn quotient(self, divisor: Self) -> Self {
        (self / divisor).unary(Unary::Int)
    }
}

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the functions' usual names")]
pub enum Unary {
    Abs,
    Acos,
    Acosh,
    Asin,
    Asinh,
    Atan,
    Atanh,
    Ceil,
    Cos,
    Cosh,
    Degrees,
    Exp,
    Floor,
    /// Conversion to a 32-bit integer and back.
    Int,
    Ln,
    Log,
    Radians,
    Sin,
    Sinh,
    Sqrt,
    /// The second power.
    Square,
    Tan,
    Tanh,
    /// This power, 3 … 8.
    Power(u8),
}

/// A low power, in the order in which POV-Ray multiplies.
#[inline(always)]
fn low_power<N: Number>(e: N, exponent: u8) -> N {
    let square = e.square();
    match exponent {
        3 => square * e,
        4 => square * square,
        5 => (square * square) * e,
        6 => (square * square) * square,
        7 => ((square * square) * e) * square,
        _ => (square * square) * (square * square),
    }
}

fn truth(holds: bool) -> f64 {
    f64::from(u8::from(holds))
}

/// Conversion to a 32-bit integer and back; what doesn't fit becomes the least one.
fn truncate(v: f64) -> f64 {
    let whole = v.trunc();
    let fits = (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&whole);
    f64::from(if fits { whole as i32 } else { i32::MIN })
}

impl Number for f64 {
    #[inline(always)]
    fn wide(formula: impl FnOnce() -> Self) -> Self {
        formula()
    }

    #[inline(always)]
    fn constant(v: f64) -> Self {
        v
    }

    #[inline(always)]
    fn fixed(self) -> Option<f64> {
        Some(self)
    }

    fn unknown() -> Self {
        Self::NAN
    }

    #[inline(always)]
    fn is_negative(self) -> Option<bool> {
        Some(self < 0.0)
    }

    #[inline(always)]
    fn is_zero(self) -> Option<bool> {
        Some(self == 0.0)
    }

    #[inline(always)]
    fn choose(self, negative: Self, other: Self) -> Self {
        if self < 0.0 { negative } else { other }
    }

    fn either(self, zero: Self, other: Self) -> Self {
        if self == 0.0 { zero } else { other }
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
        if self < other { other } else { self }
    }

    #[inline(always)]
    fn lower(self, other: Self) -> Self {
        if self <= other { self } else { other }
    }

    #[inline(always)]
    fn powi(self, exponent: i32) -> Self {
        Self::powi(self, exponent)
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        Self::powf(self, exponent)
    }

    #[inline(always)]
    fn rem(self, divisor: Self) -> Self {
        self % divisor
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        Self::atan2(self, x)
    }

    #[inline(always)]
    fn less(self, other: Self) -> Self {
        truth(self < other)
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> Self {
        truth(self <= other)
    }

    #[inline(always)]
    fn equal(self, other: Self) -> Self {
        truth(self == other)
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        truth(self != 0.0 && other != 0.0)
    }

    #[inline(always)]
    fn not(self) -> Self {
        truth(self == 0.0)
    }

    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        Self::hypot(self, other)
    }

    #[inline(always)]
    fn square(self) -> Self {
        self * self
    }

    #[inline(always)]
    fn unary(self, function: Unary) -> Self {
        match function {
            Unary::Abs => Self::abs(self),
            Unary::Acos => self.acos(),
            // The C library's has the sign bit of its NaN set.
            Unary::Acosh => {
                if self < 1.0 {
                    -Self::NAN
                } else {
                    hyperbolic::acosh(self)
                }
            }
            Unary::Asin => self.asin(),
            Unary::Asinh => hyperbolic::asinh(self),
            Unary::Atan => self.atan(),
            Unary::Atanh => hyperbolic::atanh(self),
            Unary::Ceil => self.ceil(),
            Unary::Cos => Self::cos(self),
            Unary::Cosh => self.cosh(),
            Unary::Degrees => self * (180.0 / PI),
            Unary::Exp => Self::exp(self),
            Unary::Floor => self.floor(),
            Unary::Int => truncate(self),
            Unary::Ln => self.ln(),
            Unary::Log => self.log10(),
            Unary::Radians => self * (PI / 180.0),
            Unary::Sin => Self::sin(self),
            Unary::Sinh => self.sinh(),
            Unary::Sqrt => Self::sqrt(self),
            Unary::Square => self * self,
            Unary::Tan => self.tan(),
            Unary::Tanh => self.tanh(),
            Unary::Power(exponent) => low_power(self, exponent),
        }
    }

    #[inline(always)]
    fn noise(generator: u8, [x, y, z]: [Self; 3]) -> Self {
        noise::noise(generator, DVec3::new(x, y, z))
    }
}
