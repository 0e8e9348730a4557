//! Double-double numbers: about 106 bits.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum of two doubles, the second below half a unit of the first's last place.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) struct Double {
    high: f64,
    low: f64,
}

/// The sum and what it lacks, for summands of any order.
fn two_sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    let part = sum - a;
    Double { high: sum, low: (a - (sum - part)) + (b - part) }
}

/// The same where `a` is the larger.
fn fast_two_sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    Double { high: sum, low: b - (sum - a) }
}

impl Double {
    pub(crate) fn of(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    pub(crate) fn to_f64(self) -> f64 {
        self.high
    }

    /// With so little added that it is but a part of the second double.
    pub(crate) fn shifted(self, by: f64) -> Self {
        fast_two_sum(self.high, self.low + by)
    }

    pub(crate) fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    pub(crate) fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::of(0.0);
        }
        // One Newton step doubles the digits of the double's root.
        let root = self.high.sqrt();
        let rest = self - Self::of(root) * Self::of(root);
        Self::of(root) + Self::of(rest.high / (2.0 * root))
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.high, other.high), two_sum(self.low, other.low));
        let once = fast_two_sum(high.high, high.low + low.high);
        fast_two_sum(once.high, once.low + low.low)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let low = self.high.mul_add(other.high, -high);
        let cross = self.low.mul_add(other.high, self.high * other.low);
        fast_two_sum(high, low + cross)
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - Self::of(first) * other;
        let second = rest.high / other.high;
        let rest = rest - Self::of(second) * other;
        fast_two_sum(first, second) + Self::of(rest.high / other.high)
    }
}

#[test]
fn thirty_digits_are_kept() {
    let third = Double::of(1.0) / Double::of(3.0);
    assert!((third * Double::of(3.0) - Double::of(1.0)).abs() < Double::of(1e-31));
    let root = Double::of(2.0).sqrt();
    assert!((root * root - Double::of(2.0)).abs() < Double::of(1e-31));
    let small = Double::of(1.0) + Double::of(1e-25);
    assert_eq!((small - Double::of(1.0)).to_f64(), 1e-25);
}
