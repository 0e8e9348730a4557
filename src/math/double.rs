//! Numbers of about 106 bits, for what cancels (T. J. Dekker, "A floating-point technique for extending the available
//! precision", 1971; D. E. Knuth, The Art of Computer Programming 2, 4.2.2).

use std::ops::{Add, Mul, Sub};

use super::DVec3;

/// The sum of two numbers, the second at most half a unit of the first's last place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// A number as it is.
    #[inline]
    pub fn of(number: f64) -> Self {
        Self { high: number, low: 0.0 }
    }

    /// The place `origin + t direction`.
    pub fn along(origin: DVec3, direction: DVec3, t: f64) -> [Self; 3] {
        let sum = |origin, direction| Self::of(origin) + Self::of(direction) * Self::of(t);
        [sum(origin.x, direction.x), sum(origin.y, direction.y), sum(origin.z, direction.z)]
    }

    /// The nearest number of 53 bits.
    #[inline]
    pub fn rounded(self) -> f64 {
        self.high
    }

    /// The sum of two numbers of which the first is the larger.
    #[inline]
    fn joined(large: f64, small: f64) -> Self {
        let high = large + small;
        Self { high, low: small - (high - large) }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let high = self.high + other.high;
        let part = high - self.high;
        let lost = (self.high - (high - part)) + (other.high - part);
        Self::joined(high, lost + (self.low + other.low))
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let lost = self.high.mul_add(other.high, -high);
        Self::joined(high, lost + (self.high * other.low + self.low * other.high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_keeps_its_digits() {
        let tiny = Double::of(1.0 + f64::EPSILON);
        let rest = tiny * tiny - Double::of(1.0) - Double::of(2.0 * f64::EPSILON);
        assert_eq!(rest.rounded(), f64::EPSILON * f64::EPSILON);
        let [x, ..] = Double::along(DVec3::splat(1.0), DVec3::splat(1.0 / 3.0), 3.0);
        assert_eq!((x - Double::of(2.0)).rounded(), 3.0_f64.mul_add(1.0 / 3.0, -1.0));
    }
}
