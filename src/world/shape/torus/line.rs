//! A torus along a ray, as two quadratics.

use super::Torus;
use crate::world::Ray;

/// What (x² + y² + z² + major² - minor²)² - 4 major² (x² + z²) is along a ray: zero on the surface.
pub(super) struct Line {
    /// The constant, half of the coefficient of t, and that of t² of what is squared.
    base: [f64; 3],
    /// Those of what is taken from it.
    around: [f64; 3],
}

impl Line {
    /// Of a ray that starts near the torus.
    #[inline(always)]
    pub(super) fn new(torus: &Torus, ray: &Ray) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let (round, rise) = ([o.x * o.x + o.z * o.z, o.x * d.x + o.z * d.z, d.x * d.x + d.z * d.z], d.y);
        let power = (torus.major - torus.minor) * (torus.major + torus.minor);
        let four = 4.0 * torus.major * torus.major;
        Self {
            base: [round[0] + o.y * o.y + power, round[1] + o.y * rise, round[2] + rise * rise],
            around: [four * round[0], four * round[1], four * round[2]],
        }
    }

    /// The value and how fast it grows.
    #[inline(always)]
    pub(super) fn value(&self, t: f64) -> (f64, f64) {
        let ([c, b, a], [f, e, d]) = (self.base, self.around);
        let base = c + t * (2.0 * b + t * a);
        let around = f + t * (2.0 * e + t * d);
        (base * base - around, 4.0 * base * (b + t * a) - 2.0 * (e + t * d))
    }

    /// The Bernstein coefficients between two ends, and a bound on their rounding errors.
    #[inline(always)]
    pub(super) fn bernstein(&self, low: f64, high: f64) -> ([f64; 5], f64) {
        // The polar forms of both parts are their own coefficients; the first is multiplied by itself, the second
        // raised by two degrees (Farin, Curves and Surfaces for CAGD, 5.1 and 6.10).
        let ([p, q, r], [u, v, w]) = (polar(self.base, low, high), polar(self.around, low, high));
        let b = [
            p * p - u,
            p * q - 0.5 * (u + v),
            (p * r + 2.0 * q * q - 0.5 * (u + w) - 2.0 * v) / 3.0,
            q * r - 0.5 * (v + w),
            r * r - w,
        ];
        let reach = low.abs().max(high.abs());
        let size = most(self.base, reach);
        (b, 64.0 * f64::EPSILON * (size * size + most(self.around, reach)))
    }
}

/// The polar form of a t² + 2 b t + c at both ends of an interval and between them.
#[inline(always)]
fn polar([c, b, a]: [f64; 3], low: f64, high: f64) -> [f64; 3] {
    [c + low * (2.0 * b + low * a), c + b * (low + high) + a * low * high, c + high * (2.0 * b + high * a)]
}

/// No value of a t² + 2 b t + c is larger within `reach` of 0, nor are its terms.
#[inline(always)]
fn most([c, b, a]: [f64; 3], reach: f64) -> f64 {
    c.abs() + reach * (2.0 * b.abs() + reach * a)
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
            let mut point = || DVec3::new(number(), number(), number());
            let line = Line::new(&torus, &Ray::new(point(), point()));
            let (low, high) = (number(), number() + 2.0);
            let (b, noise) = line.bernstein(low, high);
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
