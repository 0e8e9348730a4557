//! Bands of functions that bend: a tangent, and what they leave it by.

use super::{Band, ROUNDING, Strip};
use crate::math::Lanes;
use crate::math::noise::along::along;

impl Strip {
    /// A function that is convex or concave over the band, and its slope in the band's middle.
    fn bent(self, value: impl Fn(f64) -> f64, steep: f64) -> Self {
        let (low, high) = self.range();
        let (at_low, here, at_high) = (value(low), value(self.middle), value(high));
        let left =
            [at_low - here + steep * (self.middle - low), at_high - here - steep * (high - self.middle)];
        let [a, b] = left.map(|v| 0.5 * v);
        let bend = if a.abs() > b.abs() { a } else { b };
        let size = at_low.abs() + here.abs() + at_high.abs() + (steep * (high - low)).abs();
        Self {
            middle: here + bend,
            slope: self.slope * steep,
            reach: (self.reach * steep.abs() + bend.abs() + 4.0 * ROUNDING * size) * (1.0 + ROUNDING),
        }
    }

    /// A function that never falls over the band, or never rises.
    pub(super) fn monotone(self, value: impl Fn(f64) -> f64) -> Self {
        let (low, high) = self.range();
        Self::ends(value(low), value(high))
    }

    /// All between two values of a library's function, in any order.
    pub(super) fn ends(a: f64, b: f64) -> Self {
        let room = 2.0 * ROUNDING * (a.abs() + b.abs());
        Self::between(a.min(b) - room, a.max(b) + room)
    }

    /// A function that bends one way below 0 and the other way above, and is monotone on `domain`.
    fn turning(self, domain: [f64; 2], value: impl Fn(f64) -> f64, steep: impl Fn(f64) -> f64) -> Self {
        let (low, high) = self.range();
        if low > domain[0] && high < domain[1] {
            if low >= 0.0 || high <= 0.0 {
                self.bent(value, steep(self.middle))
            } else {
                self.monotone(value)
            }
        } else if low <= domain[1] && high >= domain[0] {
            Self::ends(value(low.max(domain[0])), value(high.min(domain[1])))
        } else {
            Self::UNKNOWN
        }
    }

    /// A power that isn't a whole number: only what is not negative has one.
    fn fractional_power(self, exponent: f64) -> Self {
        let (low, high) = self.range();
        let value = |v: f64| v.powf(exponent);
        if low > 0.0 {
            self.bent(value, exponent * self.middle.powf(exponent - 1.0))
        } else if high >= 0.0 && exponent > 0.0 {
            Self::ends(0.0, value(high))
        } else {
            Self::UNKNOWN
        }
    }
}

/// The whole line.
const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl Band {
    /// Sines and cosines.
    #[inline(always)]
    pub fn sin_cos(self) -> (Self, Self) {
        let far = self.middle.abs() + self.spread();
        let small = (Lanes::splat(Lanes::WIDEST_ANGLE) - far).all_positive();
        if !small {
            let any = Self::between(-1.0, 1.0);
            return (any, any);
        }
        let (sin, cos) = self.middle.sin_cos();
        let spread = self.spread();
        let exact = Lanes::splat(Lanes::SINE_ERROR);
        let (bend_s, bend_c) = (Self::bend_of_sine(sin, spread), Self::bend_of_sine(cos, spread));
        let s = Self { middle: sin, slope: self.slope * cos, reach: self.reach * cos.abs() + bend_s };
        let c = Self { middle: cos, slope: -(self.slope * sin), reach: self.reach * sin.abs() + bend_c };
        let error = exact * (spread + 1.0);
        (s.loosened(error).within_one(), c.loosened(error).within_one())
    }

    /// How far a sine of a value may be off its tangent beside which angles are spread.
    #[inline(always)]
    fn bend_of_sine(value: Lanes, spread: Lanes) -> Lanes {
        // The second derivative is the value itself, which isn't above 1.
        let most = (value.abs() + spread).zip(Lanes::splat(1.0), f64::min);
        spread * spread * most * 0.5
    }

    /// All of -1 … 1 where the band says less than that.
    #[inline(always)]
    fn within_one(self) -> Self {
        let vague = self.spread() - 1.0;
        let any = Self { reach: Lanes::splat(1.0), ..Self::constant(0.0) };
        any.where_positive(vague, self)
    }

    #[inline(always)]
    fn loosened(self, error: Lanes) -> Self {
        Self { reach: self.reach + error, ..self }.rounded(Lanes::ZERO)
    }

    /// Powers of e.
    pub fn exp(self) -> Self {
        self.lanewise(|s| s.bent(f64::exp, s.middle.exp()))
    }

    /// Natural logarithms; nothing is known where there may be none.
    pub fn ln(self) -> Self {
        self.lanewise(|s| if s.range().0 > 0.0 { s.bent(f64::ln, 1.0 / s.middle) } else { Strip::UNKNOWN })
    }

    /// Arc sines of what is within -1 … 1.
    pub fn asin(self) -> Self {
        self.lanewise(|s| s.turning([-1.0, 1.0], f64::asin, |v| 1.0 / (1.0 - v * v).sqrt()))
    }

    /// Arc cosines of what is within -1 … 1.
    pub fn acos(self) -> Self {
        self.lanewise(|s| s.turning([-1.0, 1.0], f64::acos, |v| -1.0 / (1.0 - v * v).sqrt()))
    }

    /// Arc tangents.
    pub fn atan(self) -> Self {
        self.lanewise(|s| s.turning(ALL, f64::atan, |v| 1.0 / (1.0 + v * v)))
    }

    /// Hyperbolic sines.
    pub fn sinh(self) -> Self {
        self.lanewise(|s| s.turning(ALL, f64::sinh, f64::cosh))
    }

    /// Hyperbolic cosines.
    pub fn cosh(self) -> Self {
        self.lanewise(|s| s.bent(f64::cosh, s.middle.sinh()))
    }

    /// Hyperbolic tangents.
    pub fn tanh(self) -> Self {
        self.lanewise(|s| s.turning(ALL, f64::tanh, |v| 1.0 - v.tanh() * v.tanh()))
    }

    /// The inverse of the hyperbolic sine.
    pub fn asinh(self) -> Self {
        self.lanewise(|s| s.turning(ALL, f64::asinh, |v| 1.0 / (1.0 + v * v).sqrt()))
    }

    /// The inverse of the hyperbolic cosine, of what isn't below 1.
    pub fn acosh(self) -> Self {
        self.lanewise(|s| match s.range() {
            (low, _) if low > 1.0 => s.bent(f64::acosh, 1.0 / (s.middle * s.middle - 1.0).sqrt()),
            (_, high) if high >= 1.0 => Strip::ends(0.0, high.acosh()),
            _ => Strip::UNKNOWN,
        })
    }

    /// The inverse of the hyperbolic tangent; nothing is known where there may be none.
    pub fn atanh(self) -> Self {
        self.lanewise(|s| match s.range() {
            (low, high) if low > -1.0 && high < 1.0 => s.turning(ALL, f64::atanh, |v| 1.0 / (1.0 - v * v)),
            _ => Strip::UNKNOWN,
        })
    }

    /// Powers.
    pub fn powf(self, exponent: Self) -> Self {
        match exponent.fixed() {
            Some(whole) if whole.fract() == 0.0 && whole.abs() <= 1000.0 => {
                let power = self.powi(whole.abs() as u32);
                if whole < 0.0 { power.inverse() } else { power }
            }
            Some(exponent) => self.lanewise(|s| s.fractional_power(exponent)),
            None => (self.ln() * exponent).exp(),
        }
    }

    /// The product of so many of it.
    pub fn powi(self, exponent: u32) -> Self {
        match exponent {
            0 => Self::constant(1.0),
            1 => self,
            _ => {
                let square = self.powi(exponent / 2).square();
                if exponent.is_multiple_of(2) { square } else { square * self }
            }
        }
    }

    /// The angle from the x axis towards `self` on the y axis, between -π and π.
    pub fn atan2(self, x: Self) -> Self {
        self.lanewise_with(x, |y, x| {
            let (low, high) = y.range();
            let square = y.middle * y.middle + x.middle * x.middle;
            let (off_y, off_x) = (y.spread(), x.spread());
            let off = (off_y * off_y + off_x * off_x).sqrt();
            let near = square.sqrt() * (1.0 - ROUNDING) - off * (1.0 + ROUNDING);
            // Where the angle jumps from π to -π, and beside the origin.
            let jumps = !(low > 0.0 || high < 0.0 || x.range().0 > 0.0);
            let angle = y.middle.atan2(x.middle);
            let (along_y, along_x) = (x.middle / square, -y.middle / square);
            // No second derivative is above one over the squared distance from the origin.
            let bend = 0.5 * off * off / (near * near);
            if jumps || near.is_nan() || near <= 0.0 || bend > std::f64::consts::PI {
                let all = std::f64::consts::PI;
                return Strip::ends(if low > 0.0 { 0.0 } else { -all }, if high < 0.0 { 0.0 } else { all });
            }
            Strip {
                middle: angle,
                slope: along_y * y.slope + along_x * x.slope,
                reach: (along_y.abs() * y.reach
                    + along_x.abs() * x.reach
                    + bend
                    + 4.0 * ROUNDING * (angle.abs() + (along_y * y.slope).abs() + (along_x * x.slope).abs()))
                    * (1.0 + ROUNDING),
            }
        })
    }

    /// Noise at points, before it is brought to 0 … 1 by force; or those two, where that says more.
    #[inline(always)]
    pub fn noise_of(generator: u8, point: [Self; 3]) -> Self {
        let [x, y, z] = point;
        let found = along(
            generator,
            [x.middle, y.middle, z.middle],
            [x.slope, y.slope, z.slope],
            [x.reach, y.reach, z.reach],
        );
        // The square of s is between 0 and 1.
        let bend = found.bend * 0.5;
        let line = Self { middle: found.value + bend, slope: found.rise, reach: bend.abs() + found.off };
        let any = Self { middle: Lanes::splat(0.5), slope: Lanes::ZERO, reach: Lanes::splat(0.5) };
        line.rounded(Lanes::ZERO).where_positive(-line.reach + 0.5, any)
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;

    /// Checks that a function's bands hold its values over stretches long and short.
    #[track_caller]
    fn holds(band: impl Fn(Band) -> Band, value: impl Fn(f64) -> f64, domain: [f64; 2]) {
        let mut widest: f64 = 0.0;
        for n in 0..4000 {
            let share = f64::from(n) / 4000.0;
            let half = 0.5 * (domain[1] - domain[0]) * 0.5_f64.powi(n % 40);
            let middle = domain[0] + half + share * (domain[1] - domain[0] - 2.0 * half);
            let found = band(Band::line(Lanes::splat(middle), Lanes::splat(half)));
            for step in -8..=8 {
                let s = f64::from(step) / 8.0;
                let expected = value(middle + half * s);
                if expected.is_nan() || found.reach.0[1].is_nan() {
                    continue;
                }
                let line = found.middle.0[1] + found.slope.0[1] * s;
                let off = (expected - line).abs();
                assert!(
                    off <= found.reach.0[1] * (1.0 + 1e-12) + 1e-290,
                    "{off:e} {found:?} {middle} ± {half}"
                );
            }
            // Short, but not so short that rounding is most of it.
            if (12..18).contains(&(n % 40)) {
                widest = widest.max(found.reach.0[1] / half);
            }
        }
        assert!(widest < 0.3, "{widest}");
    }

    #[test]
    fn curves_stay_in_their_bands() {
        holds(|b| b.sin_cos().0, f64::sin, [-9.0, 8.0]);
        holds(|b| b.sin_cos().1, f64::cos, [-9.0, 8.0]);
        holds(Band::exp, f64::exp, [-3.0, 2.0]);
        holds(Band::ln, f64::ln, [0.1, 5.0]);
        holds(Band::sqrt, f64::sqrt, [0.01, 5.0]);
        holds(Band::inverse, |v| 1.0 / v, [0.3, 5.0]);
        holds(Band::inverse, |v| 1.0 / v, [-5.0, -0.3]);
        holds(Band::square, |v| v * v, [-3.0, 2.0]);
        holds(Band::asin, f64::asin, [-0.9, 0.9]);
        holds(Band::acos, f64::acos, [-0.9, 0.9]);
        holds(Band::atan, f64::atan, [-3.0, 4.0]);
        holds(Band::sinh, f64::sinh, [-3.0, 2.0]);
        holds(Band::cosh, f64::cosh, [-3.0, 2.0]);
        holds(Band::tanh, f64::tanh, [-3.0, 2.0]);
        holds(Band::asinh, f64::asinh, [-3.0, 2.0]);
        holds(Band::acosh, f64::acosh, [1.1, 4.0]);
        holds(Band::atanh, f64::atanh, [-0.9, 0.8]);
        holds(|b| b.powf(Band::constant(2.5)), |v| v.powf(2.5), [0.1, 3.0]);
        holds(|b| b.powf(Band::constant(-3.0)), |v| v.powi(-3), [0.4, 3.0]);
        holds(|b| b.powi(5), |v| v.powi(5), [-2.0, 1.5]);
        holds(|b| b.atan2(b * b - 2.0), |v| v.atan2(v * v - 2.0), [0.2, 3.0]);
        holds(|b| (b * 3.0).powf(b + 1.0), |v| (v * 3.0).powf(v + 1.0), [0.2, 2.0]);
    }

    #[test]
    fn what_has_a_kink_stays_in_its_band_too() {
        let kinks = |band: fn(Band) -> Band, value: fn(f64) -> f64| {
            for n in 0..2000 {
                let (middle, half) = (f64::from(n) * 0.002 - 2.0, 0.8_f64.powi(n % 50));
                let found = band(Band::line(Lanes::splat(middle), Lanes::splat(half)));
                for step in -8..=8 {
                    let s = f64::from(step) / 8.0;
                    let expected = value(middle + half * s);
                    let off = (expected - found.middle.0[2] - found.slope.0[2] * s).abs();
                    assert!(
                        off.partial_cmp(&found.reach.0[2]) != Some(Ordering::Greater),
                        "{off:e} {found:?} {middle} ± {half}"
                    );
                }
            }
        };
        kinks(Band::abs, f64::abs);
        kinks(Band::sqrt, f64::sqrt);
        kinks(|b| b.max(-b * 0.3), |v| v.max(-v * 0.3));
        kinks(|b| b.min(b * b), |v| v.min(v * v));
        kinks(Band::floor, f64::floor);
        kinks(|b| b.remainder(Band::constant(0.7)), |v| v % 0.7);
        kinks(|b| b.less(Band::constant(0.3)), |v| f64::from(v < 0.3));
        kinks(|b| b.less_equal(b * b), |v| f64::from(v <= v * v));
        kinks(|b| b.and(b.floor()), |v| f64::from(v != 0.0 && v.floor() != 0.0));
        kinks(|b| b.powf(Band::constant(0.5)), |v| v.powf(0.5));
    }
}
