//! A torus along a ray, or four, as two quadratics.

use std::ops::{Add, Div, Mul, Sub};

use super::Torus;
use crate::math::Lanes;

/// A number, or four.
pub(super) trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// The absolute value.
    fn abs(self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
}

impl Number for Lanes {
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
}

/// What (x² + y² + z² + major² - minor²)² - 4 major² (x² + z²) is along a ray: zero on the surface.
pub(super) struct Line<T> {
    /// The constant, half of the coefficient of t, and that of t² of what is squared.
    base: [T; 3],
    /// Those of what is taken from it.
    around: [T; 3],
}

impl<T: Number> Line<T> {
    /// Of a ray, or four, by the origin near the torus and the direction.
    #[inline(always)]
    pub(super) fn new(torus: &Torus, [x, y, z]: [T; 3], [u, v, w]: [T; 3], power: T) -> Self {
        let round = [x * x + z * z, x * u + z * w, u * u + w * w];
        let four = 4.0 * torus.major * torus.major;
        Self {
            base: [round[0] + y * y + power, round[1] + y * v, round[2] + v * v],
            around: [round[0] * four, round[1] * four, round[2] * four],
        }
    }

    /// The Bernstein coefficients between two ends, and a bound on their rounding errors; none of the ends is farther
    /// from the origin than `reach`.
    #[inline(always)]
    pub(super) fn bernstein(&self, low: T, high: T, reach: T) -> ([T; 5], T) {
        // The polar forms of both parts are their own coefficients; the first is multiplied by itself, the second
        // raised by two degrees (Farin, Curves and Surfaces for CAGD, 5.1 and 6.10).
        let ([p, q, r], [u, v, w]) = (polar(self.base, low, high), polar(self.around, low, high));
        let b = [
            p * p - u,
            p * q - (u + v) * 0.5,
            (p * r + q * 2.0 * q - (u + w) * 0.5 - v * 2.0) / 3.0,
            q * r - (v + w) * 0.5,
            r * r - w,
        ];
        let size = most(self.base, reach);
        (b, (size * size + most(self.around, reach)) * (64.0 * f64::EPSILON))
    }

    /// The value and how fast it grows.
    #[inline(always)]
    pub(super) fn value(&self, t: T) -> (T, T) {
        let ([c, b, a], [f, e, d]) = (self.base, self.around);
        let base = c + t * (b * 2.0 + t * a);
        let around = f + t * (e * 2.0 + t * d);
        (base * base - around, base * 4.0 * (b + t * a) - (e + t * d) * 2.0)
    }
}

/// The polar form of a t² + 2 b t + c at both ends of an interval and between them.
#[inline(always)]
fn polar<T: Number>([c, b, a]: [T; 3], low: T, high: T) -> [T; 3] {
    let twice = b * 2.0;
    [c + low * (twice + low * a), c + b * (low + high) + a * low * high, c + high * (twice + high * a)]
}

/// No value of a t² + 2 b t + c is larger within `reach` of 0, nor are its terms.
#[inline(always)]
fn most<T: Number>([c, b, a]: [T; 3], reach: T) -> T {
    c.abs() + reach * (b.abs() * 2.0 + reach * a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;
    use crate::math::dice::numbers;

    #[test]
    fn bernstein_coefficients_sum_up_to_the_value() {
        let mut number = numbers(3);
        for _ in 0..1000 {
            let torus = Torus { major: 0.5 + number().abs(), minor: 0.4 * number().abs() };
            let mut point = || DVec3::new(number(), number(), number()).to_array();
            let line = Line::new(&torus, point(), point(), torus.power());
            let (low, high) = (number(), number() + 2.0);
            let (b, noise) = line.bernstein(low, high, low.abs().max(high.abs()));
            for share in [0.0, 0.25, 0.5, 0.9, 1.0] {
                let (s, r): (f64, f64) = (share, 1.0 - share);
                let basis =
                    [r.powi(4), 4.0 * s * r.powi(3), 6.0 * s * s * r * r, 4.0 * s.powi(3) * r, s.powi(4)];
                let sum: f64 = b.iter().zip(basis).map(|(b, basis)| b * basis).sum();
                assert!((sum - line.value(low + share * (high - low)).0).abs() <= noise, "{torus:?} {share}");
            }
        }
    }
}
