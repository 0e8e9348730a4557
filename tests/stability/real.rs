//! The numbers a surface's equation is worked out in.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::interval::{Interval, Scalar};

/// What polynomials can be worked out in: a number, or what stands for one.
pub(crate) trait Ring:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// Exactly `x`.
    fn of(x: f64) -> Self;

    fn square(self) -> Self {
        self.clone() * self
    }

    fn times(self, factor: f64) -> Self {
        self * Self::of(factor)
    }

    fn over(self, divisor: f64) -> Self;

    fn plus(self, term: f64) -> Self {
        self + Self::of(term)
    }
}

/// A real number, or what stands for one.
pub(crate) trait Real: Ring + Div<Output = Self> {
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    fn max(self, other: Self) -> Self;

    /// To the power of a positive number, of what isn't negative.
    fn power(self, exponent: f64) -> Self;

    /// The same number where it counts, else one that makes products vanish: for fields that end.
    fn positive(self) -> Self {
        self.max(Self::of(0.0))
    }
}

/// A number with its derivative along the ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet<S> {
    pub(crate) value: Interval<S>,
    pub(crate) slope: Interval<S>,
}

impl<S: Scalar> Add for Jet<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl<S: Scalar> Sub for Jet<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl<S: Scalar> Neg for Jet<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl<S: Scalar> Mul for Jet<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        Self { value: self.value * other.value, slope }
    }
}

impl<S: Scalar> Div for Jet<S> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl<S: Scalar> Ring for Jet<S> {
    fn of(x: f64) -> Self {
        Self { value: Interval::of(x), slope: Interval::of(0.0) }
    }

    fn square(self) -> Self {
        let slope = self.value * self.slope;
        Self { value: self.value.square(), slope: slope + slope }
    }

    fn times(self, factor: f64) -> Self {
        let factor = Interval::of(factor);
        Self { value: self.value * factor, slope: self.slope * factor }
    }

    fn over(self, divisor: f64) -> Self {
        let divisor = Interval::of(divisor);
        Self { value: self.value / divisor, slope: self.slope / divisor }
    }

    fn plus(self, term: f64) -> Self {
        Self { value: self.value + Interval::of(term), slope: self.slope }
    }
}

impl<S: Scalar> Real for Jet<S> {
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        Self { value, slope: self.slope / (value + value) }
    }

    fn abs(self) -> Self {
        if self.value.is_negative() {
            -self
        } else if self.value.is_positive() {
            self
        } else {
            Self { value: self.value.abs(), slope: self.slope.hull(-self.slope) }
        }
    }

    fn max(self, other: Self) -> Self {
        if self.value.low > other.value.high {
            self
        } else if other.value.low > self.value.high {
            other
        } else {
            Self { value: self.value.max(other.value), slope: self.slope.hull(other.slope) }
        }
    }

    fn power(self, exponent: f64) -> Self {
        let raised = |exponent: f64| {
            // To the last bits at best: wider than the error of any system's `powf`.
            const ROOM: f64 = 8.0 * f64::EPSILON;
            let [low, high] = [self.value.low, self.value.high].map(|x| x.to_f64().max(0.0).powf(exponent));
            let (low, high) = if exponent < 0.0 { (high, low) } else { (low, high) };
            Interval { low: S::of(low * (1.0 - ROOM)), high: S::of(high * (1.0 + ROOM)) }
        };
        Self { value: raised(exponent), slope: raised(exponent - 1.0) * self.slope * Interval::of(exponent) }
    }
}

/// A number with how far it may move when every input it came from moves by a share of itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moved {
    pub(crate) value: f64,
    pub(crate) by: f64,
    /// Its gradient.
    pub(crate) slope: [f64; 3],
}

impl Moved {
    fn zip(a: [f64; 3], b: [f64; 3], f: impl Fn(f64, f64) -> f64) -> [f64; 3] {
        std::array::from_fn(|i| f(a[i], b[i]))
    }
}

impl Add for Moved {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let slope = Self::zip(self.slope, other.slope, |a, b| a + b);
        Self { value: self.value + other.value, by: self.by + other.by, slope }
    }
}

impl Neg for Moved {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: self.slope.map(|x| -x), ..self }
    }
}

impl Sub for Moved {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Moved {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            by: self.by * other.value.abs() + self.value.abs() * other.by,
            slope: Self::zip(self.slope, other.slope, |a, b| a * other.value + self.value * b),
        }
    }
}

impl Div for Moved {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self {
            value,
            by: (self.by + value.abs() * other.by) / other.value.abs(),
            slope: Self::zip(self.slope, other.slope, |a, b| (a - value * b) / other.value),
        }
    }
}

impl Ring for Moved {
    fn of(x: f64) -> Self {
        Self { value: x, by: x.abs(), slope: [0.0; 3] }
    }
    fn over(self, divisor: f64) -> Self {
        self / Self::of(divisor)
    }
}

impl Real for Moved {
    fn sqrt(self) -> Self {
        let value = self.value.max(0.0).sqrt();
        let by = self.by / (2.0 * value);
        Self { value, by, slope: self.slope.map(|x| x / (2.0 * value)) }
    }
    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }
    fn max(self, other: Self) -> Self {
        if self.value < other.value { other } else { self }
    }
    fn power(self, exponent: f64) -> Self {
        let rate = exponent * self.value.powf(exponent - 1.0);
        let value = self.value.powf(exponent);
        Self { value, by: self.by * rate.abs(), slope: self.slope.map(|x| x * rate) }
    }
}
