//! Formulas for bands and how fast they rise, by the rules of differentiation.

use std::f64::consts::{LN_10, PI};

use super::{Number, Unary, low_power};
use crate::math::wide::widest;
use crate::math::{Band, Slant};

const ONE: Band = Band::constant(1.0);

impl Number for Slant {
    #[inline(always)]
    fn wide(formula: impl FnOnce() -> Self) -> Self {
        widest(formula)
    }

    #[inline(always)]
    fn constant(v: f64) -> Self {
        Self::constant(v)
    }

    fn fixed(self) -> Option<f64> {
        self.value.fixed()
    }

    fn unknown() -> Self {
        Self::UNKNOWN
    }

    fn is_negative(self) -> Option<bool> {
        self.value.is_negative()
    }

    fn is_zero(self) -> Option<bool> {
        self.value.is_zero()
    }

    /// It may jump from one to the other.
    fn choose(self, negative: Self, other: Self) -> Self {
        let value = self.value.choose(negative.value, other.value);
        let other = other.where_positive(self.value.low(), Self::unknown_rise(value));
        let chosen = negative.where_positive(-self.value.high(), other);
        Self { value, ..chosen }
    }

    fn either(self, zero: Self, other: Self) -> Self {
        Self::unknown_rise(zero.value.hull(other.value))
    }

    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }

    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }

    fn upper(self, other: Self) -> Self {
        Self::max(self, other)
    }

    fn lower(self, other: Self) -> Self {
        Self::min(self, other)
    }

    fn powi(self, exponent: i32) -> Self {
        self.powf(Self::constant(f64::from(exponent)))
    }

    fn powf(self, exponent: Self) -> Self {
        let power = self.value.powf(exponent.value);
        match exponent.value.fixed() {
            Some(0.0) => Self::constant(1.0),
            Some(fixed) => self.with(power, self.value.powf(Band::constant(fixed - 1.0)) * fixed),
            None => {
                let by = [power * exponent.value / self.value, power * self.value.ln()];
                self.with_both(exponent, power, by)
            }
        }
    }

    fn rem(self, divisor: Self) -> Self {
        let multiples = Self::stepped((self.value / divisor.value).stepped(f64::trunc));
        let value = self.value.remainder(divisor.value);
        Self { value, ..self - divisor * multiples }
    }

    fn atan2(self, x: Self) -> Self {
        let (y, value) = (self, self.value.atan2(x.value));
        // Where the angle jumps from π to -π, and at the origin, it rises without bound.
        let sure = y.value.low().zip(-y.value.high(), f64::max).zip(x.value.low(), f64::max);
        let inverse = (x.value.square() + y.value.square()).inverse();
        let angle = y.with_both(x, value, [x.value * inverse, -(y.value * inverse)]);
        angle.where_positive(sure, Self::unknown_rise(value))
    }

    fn less(self, other: Self) -> Self {
        Self::stepped(self.value.less(other.value))
    }

    fn less_equal(self, other: Self) -> Self {
        Self::stepped(self.value.less_equal(other.value))
    }

    fn equal(self, other: Self) -> Self {
        Self::stepped(self.value.equal(other.value))
    }

    fn and(self, other: Self) -> Self {
        Self::stepped(self.value.and(other.value))
    }

    fn not(self) -> Self {
        Self::stepped(self.value.is_false())
    }

    fn square(self) -> Self {
        Self::square(self)
    }

    #[inline(always)]
    fn unary(self, function: Unary) -> Self {
        match function {
            Unary::Square => Self::square(self),
            Unary::Power(exponent) => low_power(self, exponent),
            Unary::Sin => {
                let (sin, cos) = self.value.sin_cos();
                self.with(sin, cos)
            }
            Unary::Cos => {
                let (sin, cos) = self.value.sin_cos();
                self.with(cos, -sin)
            }
            _ => rare(self, function),
        }
    }

    fn noise(generator: u8, point: [Self; 3]) -> Self {
        Self::noise(generator, point)
    }
}

fn rare(of: Slant, function: Unary) -> Slant {
    let x = of.value;
    let value = x.unary(function);
    // 1 ± x², its root, and one over them.
    let (less, more) = (-x.square() + 1.0, x.square() + 1.0);
    let rise = match function {
        Unary::Abs => return of.abs(),
        Unary::Ceil | Unary::Floor | Unary::Int => return Slant::stepped(value),
        Unary::Degrees => return of * (180.0 / PI),
        Unary::Radians => return of * (PI / 180.0),
        Unary::Acos => -less.sqrt().inverse(),
        Unary::Acosh => (-less).sqrt().inverse(),
        Unary::Asin => less.sqrt().inverse(),
        Unary::Asinh => more.sqrt().inverse(),
        Unary::Atan => more.inverse(),
        Unary::Atanh => less.inverse(),
        Unary::Cosh => x.sinh(),
        Unary::Exp => value,
        Unary::Ln => x.inverse(),
        Unary::Log => x.inverse() * (1.0 / LN_10),
        Unary::Sinh => x.cosh(),
        Unary::Sqrt => value.inverse() * 0.5,
        Unary::Tan => value.square() + 1.0,
        Unary::Tanh => ONE - value.square(),
        Unary::Sin | Unary::Cos | Unary::Square | Unary::Power(_) => return of.unary(function),
    };
    of.with(value, rise)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Lanes;

    const UNARY: [Unary; 25] = [
        Unary::Abs,
        Unary::Acos,
        Unary::Acosh,
        Unary::Asin,
        Unary::Asinh,
        Unary::Atan,
        Unary::Atanh,
        Unary::Ceil,
        Unary::Cos,
        Unary::Cosh,
        Unary::Degrees,
        Unary::Exp,
        Unary::Floor,
        Unary::Int,
        Unary::Ln,
        Unary::Log,
        Unary::Radians,
        Unary::Sin,
        Unary::Sinh,
        Unary::Sqrt,
        Unary::Square,
        Unary::Tan,
        Unary::Tanh,
        Unary::Power(3),
        Unary::Power(8),
    ];

    /// Those of one number, and some of two.
    fn formula<N: Number>(number: usize, u: N, v: N) -> N {
        match number.checked_sub(UNARY.len()) {
            None => (u * 0.7 + v * 0.4).unary(UNARY[number]),
            Some(0) => u.atan2(v),
            Some(1) => u.max(v * v),
            Some(2) => u.lower(v),
            Some(3) => u.rem(N::constant(0.3)) * v,
            Some(4) => (u - v).pick(|| u * v, || v),
            Some(5) => (u * u + 0.1).powf(v),
            Some(6) => v.powf(N::constant(2.5)) / u,
            Some(7) => u.powi(-3) + v.powi(4),
            _ => u.less(v) * u + v.hypot(u),
        }
    }

    #[test]
    fn slants_hold_how_fast_formulas_rise() {
        for number in 0..UNARY.len() + 9 {
            let mut narrow = 0;
            for n in 0..400_u32 {
                let at = |by: f64| (f64::from(n) * by).fract() * 2.6 - 1.3;
                let half = 0.5_f64.powi((n % 12) as i32);
                let (middle, half) = ([at(0.754_877_666), at(0.569_840_290_9)], [half, 0.3 * half]);
                let part = [0, 1].map(|axis| {
                    let line = Band::line(Lanes::splat(middle[axis]), Lanes::ZERO);
                    let value = Band { reach: line.reach + half[axis], ..line };
                    Slant { value, rises: [0, 1].map(|i| Band::constant(f64::from(u8::from(i == axis)))) }
                });
                let found = formula(number, part[0], part[1]);
                for axis in [0, 1] {
                    let (low, high) = (found.rises[axis].low().0[0], found.rises[axis].high().0[0]);
                    narrow += u32::from(high - low < 10.0);
                    for step in 0..16_u32 {
                        let place = |turn: u32| {
                            let shares = [step * 3 % 16, step * 7 % 16].map(|s| f64::from(s) / 8.0 - 1.0);
                            let mut p = [0, 1].map(|i| middle[i] + half[i] * shares[i]);
                            p[axis] = middle[axis] + half[axis] * (f64::from((step + turn) % 16) / 7.5 - 1.0);
                            p
                        };
                        let (p, q) = (place(0), place(1 + step % 5));
                        let [at_p, at_q] = [p, q].map(|p| formula(number, p[0], p[1]));
                        let rise = (at_p - at_q) / (p[axis] - q[axis]);
                        let room = 1e-9 * (1.0 + rise.abs()) / half[axis];
                        assert!(
                            !(rise < low - room || rise > high + room),
                            "{number} by {axis}: {rise} beside {low} … {high} at {p:?} {q:?}"
                        );
                    }
                }
            }
            assert!(narrow > 20, "{number}: {narrow}");
        }
    }
}
