//! Intervals that surely hold the exact result.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::double::Double;

/// What the ends of an interval are made of.
pub(crate) trait Scalar:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn of(x: f64) -> Self;
    fn to_f64(self) -> f64;
    /// Below and above every number that rounds to this one.
    fn down(self) -> Self;
    fn up(self) -> Self;
    fn root(self) -> Self;
    /// What surely holds a number.
    fn around(x: Double) -> Interval<Self>;
    /// The same, and where digits are few all that is within `room` of it.
    fn loosely(x: Double, room: f64) -> Interval<Self>;
}

impl Scalar for f64 {
    fn of(x: f64) -> Self {
        x
    }
    fn to_f64(self) -> f64 {
        self
    }
    fn down(self) -> Self {
        self.next_down()
    }
    fn up(self) -> Self {
        self.next_up()
    }
    fn root(self) -> Self {
        self.sqrt()
    }
    fn around(x: Double) -> Interval<Self> {
        let near = x.to_f64();
        if x == Double::of(near) { Interval::point(near) } else { Interval::point(near).widened(0.0) }
    }
    fn loosely(x: Double, room: f64) -> Interval<Self> {
        Self::around(x).widened(room)
    }
}

/// Bound on the relative error of an operation on [`Double`]s.
const ROUNDING: f64 = 1e-30;

impl Scalar for Double {
    fn of(x: f64) -> Self {
        Self::of(x)
    }
    fn to_f64(self) -> f64 {
        self.to_f64()
    }
    fn down(self) -> Self {
        self.shifted(-(self.to_f64().abs() * ROUNDING + f64::MIN_POSITIVE))
    }
    fn up(self) -> Self {
        self.shifted(self.to_f64().abs() * ROUNDING + f64::MIN_POSITIVE)
    }
    fn root(self) -> Self {
        self.sqrt()
    }
    fn around(x: Double) -> Interval<Self> {
        Interval::point(x)
    }
    fn loosely(x: Double, _: f64) -> Interval<Self> {
        Interval::point(x)
    }
}

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval<S> {
    pub(crate) low: S,
    pub(crate) high: S,
}

impl<S: Scalar> Interval<S> {
    pub(crate) fn point(x: S) -> Self {
        Self { low: x, high: x }
    }

    pub(crate) fn of(x: f64) -> Self {
        Self::point(S::of(x))
    }

    /// Everything.
    pub(crate) fn all() -> Self {
        Self { low: S::of(f64::NEG_INFINITY), high: S::of(f64::INFINITY) }
    }

    pub(crate) fn has_zero(self) -> bool {
        // Written so that what is no number counts as doubt.
        !(self.low > S::of(0.0) || self.high < S::of(0.0))
    }

    pub(crate) fn is_negative(self) -> bool {
        self.high < S::of(0.0)
    }

    pub(crate) fn is_positive(self) -> bool {
        self.low > S::of(0.0)
    }

    pub(crate) fn hull(self, other: Self) -> Self {
        let low = if other.low < self.low { other.low } else { self.low };
        let high = if other.high > self.high { other.high } else { self.high };
        Self { low, high }
    }

    /// What both hold; the first where they hold nothing in common.
    pub(crate) fn meet(self, other: Self) -> Self {
        let low = if other.low > self.low { other.low } else { self.low };
        let high = if other.high < self.high { other.high } else { self.high };
        if low <= high { Self { low, high } } else { self }
    }

    pub(crate) fn middle(self) -> S {
        (self.low + self.high) * S::of(0.5)
    }

    pub(crate) fn widened(self, by: f64) -> Self {
        Self { low: (self.low - S::of(by)).down(), high: (self.high + S::of(by)).up() }
    }

    pub(crate) fn sqrt(self) -> Self {
        let zero = S::of(0.0);
        let low = if self.low > zero { self.low.root().down() } else { zero };
        Self { low, high: if self.high > zero { self.high.root().up() } else { zero } }
    }

    pub(crate) fn abs(self) -> Self {
        let zero = S::of(0.0);
        if self.low >= zero {
            self
        } else if self.high <= zero {
            -self
        } else {
            Self { low: zero, high: if -self.low > self.high { -self.low } else { self.high } }
        }
    }

    pub(crate) fn max(self, other: Self) -> Self {
        let low = if other.low > self.low { other.low } else { self.low };
        let high = if other.high > self.high { other.high } else { self.high };
        Self { low, high }
    }

    /// The square, which knows that it has no negative numbers.
    pub(crate) fn square(self) -> Self {
        let a = self.abs();
        Self { low: (a.low * a.low).down().max_zero(), high: (a.high * a.high).up() }
    }
}

trait MaxZero {
    fn max_zero(self) -> Self;
}

impl<S: Scalar> MaxZero for S {
    fn max_zero(self) -> Self {
        if self < S::of(0.0) { S::of(0.0) } else { self }
    }
}

impl<S: Scalar> Add for Interval<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { low: (self.low + other.low).down(), high: (self.high + other.high).up() }
    }
}

impl<S: Scalar> Neg for Interval<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl<S: Scalar> Sub for Interval<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<S: Scalar> Mul for Interval<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let zero = S::of(0.0);
        let (a, b) = (self, other);
        // The factors of the lowest and the highest product, by the signs.
        let [low, high] = if a.low >= zero {
            if b.low >= zero {
                [a.low * b.low, a.high * b.high]
            } else if b.high <= zero {
                [a.high * b.low, a.low * b.high]
            } else {
                [a.high * b.low, a.high * b.high]
            }
        } else if a.high <= zero {
            if b.low >= zero {
                [a.low * b.high, a.high * b.low]
            } else if b.high <= zero {
                [a.high * b.high, a.low * b.low]
            } else {
                [a.low * b.high, a.low * b.low]
            }
        } else if b.low >= zero {
            [a.low * b.high, a.high * b.high]
        } else if b.high <= zero {
            [a.high * b.low, a.low * b.low]
        } else {
            let ([p, q], [r, s]) = ([a.low * b.high, a.high * b.low], [a.low * b.low, a.high * b.high]);
            [if q < p { q } else { p }, if s > r { s } else { r }]
        };
        // Zero times infinity: nothing is known.
        if low <= high { Self { low: low.down(), high: high.up() } } else { Self::all() }
    }
}

impl<S: Scalar> Div for Interval<S> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.has_zero() {
            return Self::all();
        }
        let one = S::of(1.0);
        self * Self { low: (one / other.high).down(), high: (one / other.low).up() }
    }
}
