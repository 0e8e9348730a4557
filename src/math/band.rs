//! Numbers that are known to lie in a band: what interval arithmetic becomes for functions along a line.
//!
//! Over a stretch of a line, on which s goes from -1 to 1, a quantity is within `reach` of the straight
//! line `middle + slope · s`. Sums of such bands are bands, and so are products and smooth functions of them,
//! with a reach of the second order in the stretch's length: a half as long stretch has bands a quarter
//! as wide. Correlated terms cancel (x - x is 0), which plain intervals don't see.
//! Every operation adds what rounding may have taken away; only results below 10⁻³⁰⁰ count as rounded to 0.
//! A band that isn't finite says nothing.

mod curves;
mod steps;
mod turbulence;

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::lanes::Lanes;

/// Bands over [`Lanes::COUNT`] stretches at once.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    /// The line's value in the middle of the stretch.
    pub middle: Lanes,
    /// By how much the line rises from there to the stretch's end.
    pub slope: Lanes,
    /// How far from the line the quantity may be; not negative.
    pub reach: Lanes,
}

/// At least what the few roundings of one operation may be off, as a share.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// More than what an operation loses that leaves the range of normal numbers.
const TINY: f64 = 1e-300;

impl Band {
    /// Nothing is known.
    pub const UNKNOWN: Self = Self { reach: Lanes::splat(f64::INFINITY), ..Self::constant(0.0) };

    /// One number.
    #[inline(always)]
    pub const fn constant(v: f64) -> Self {
        Self { middle: Lanes::splat(v), slope: Lanes::ZERO, reach: Lanes::ZERO }
    }

    /// What goes along lines from `middle - slope` to `middle + slope`, but for rounding.
    #[inline(always)]
    pub fn line(middle: Lanes, slope: Lanes) -> Self {
        Self { middle, slope, reach: Lanes::ZERO }.rounded(Lanes::ZERO)
    }

    /// The same with room for the rounding of what it was made of.
    pub fn loose(self) -> Self {
        self.rounded(self.reach)
    }

    /// All between two bounds.
    pub fn between(low: f64, high: f64) -> Self {
        Self::UNKNOWN.lanewise(|_| Strip::between(low, high))
    }

    /// All between two bounds in each lane.
    pub fn within(low: Lanes, high: Lanes) -> Self {
        Self::of([0, 1, 2, 3].map(|i| Strip::between(low.0[i], high.0[i])))
    }

    /// One number in each lane.
    pub fn numbers(numbers: Lanes) -> Self {
        Self { middle: numbers, ..Self::constant(0.0) }
    }

    /// The same without the room for rounding, where it is but numbers: what counts down to an end has to reach it.
    pub fn settled(self) -> Self {
        let is_number = |i: usize| {
            self.slope.0[i] == 0.0
                && self.reach.0[i] <= 64.0 * ROUNDING * self.middle.0[i].abs() + 64.0 * TINY
        };
        if (0..Lanes::COUNT).all(is_number) { Self::numbers(self.middle) } else { self }
    }

    /// The number, if it is one and the same everywhere.
    pub fn fixed(self) -> Option<f64> {
        let [first, ..] = self.middle.0;
        (self.middle == Lanes::splat(first) && self.slope == Lanes::ZERO && self.reach == Lanes::ZERO)
            .then_some(first)
    }

    /// How far from the middle values may be.
    #[inline(always)]
    pub fn spread(self) -> Lanes {
        (self.slope.abs() + self.reach) * (1.0 + ROUNDING)
    }

    /// A lower bound in each lane.
    #[inline(always)]
    pub fn low(self) -> Lanes {
        let spread = self.spread();
        self.middle - spread - (self.middle.abs() + spread) * ROUNDING
    }

    /// An upper bound in each lane.
    #[inline(always)]
    pub fn high(self) -> Lanes {
        let spread = self.spread();
        self.middle + spread + (self.middle.abs() + spread) * ROUNDING
    }

    /// The same with what rounding took from the line, and from terms as large as `extra`.
    #[inline(always)]
    fn rounded(self, extra: Lanes) -> Self {
        let size = self.middle.abs() + self.slope.abs() + extra;
        Self { reach: (self.reach + size * ROUNDING + TINY) * (1.0 + ROUNDING), ..self }
    }

    /// The band times itself, which is never negative.
    #[inline(always)]
    pub fn square(self) -> Self {
        let Self { middle: c, slope: k, reach: e } = self;
        let bend = k * k * 0.5;
        let size = c.abs() + k.abs();
        let line = Self { middle: c * c + bend, slope: c * k * 2.0, reach: bend + e * (size * 2.0 + e) };
        line.rounded(size * size)
    }

    /// One over the band; nothing is known where that may be 0.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let spread = self.spread();
        let near = self.middle.abs() - spread - (self.middle.abs() + spread) * ROUNDING;
        let first = Lanes::splat(1.0) / self.middle;
        let steep = first * first;
        // The tangent in the middle is too near to 0 by up to this, at the end that is nearest to 0.
        let bend = spread * spread * steep / near * 0.5;
        let away = bend.where_positive(self.middle, -bend);
        let reach = (self.reach * steep + bend).where_positive(near, Lanes::splat(f64::INFINITY));
        Self { middle: first + away, slope: -(self.slope * steep), reach }.rounded(Lanes::ZERO)
    }

    /// Square roots, where there are some.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let (low, high) = (self.low(), self.high());
        let root = self.middle.sqrt();
        let steep = Lanes::splat(0.5) / root;
        // The tangent in the middle is too high by up to twice this, at the lower end.
        let bend = (root - steep * self.spread() - low.sqrt()).abs() * 0.5;
        let reach = self.reach * steep + bend;
        let tangent = Self { middle: root - bend, slope: self.slope * steep, reach }.rounded(root);
        if low.all_positive() {
            return tangent;
        }
        // The chord from 0 is too low by up to a quarter of the highest root.
        let top = high.sqrt();
        let steep = Lanes::splat(1.0) / top;
        let bend = top * 0.125;
        let reach = self.reach * steep + bend;
        let chord = Self { middle: self.middle * steep + bend, slope: self.slope * steep, reach };
        tangent.where_positive(low, chord.rounded(top))
    }

    /// Absolute values.
    #[inline(always)]
    pub fn abs(self) -> Self {
        let (low, high) = (self.low(), self.high());
        if low.all_positive() {
            return self;
        }
        if (-high).all_positive() {
            return -self;
        }
        let one_sided = self.lanewise(|strip| if strip.middle < 0.0 { strip.negated() } else { strip });
        // The chord over both sides is too high by up to twice this.
        let bend = -(high * low) / (high - low);
        let share = (high + low) / (high - low);
        let chord = Self {
            middle: self.middle * share + bend,
            slope: self.slope * share,
            reach: self.reach * share.abs() + bend,
        };
        let chord = chord.rounded(self.spread() + self.middle.abs());
        chord.where_positive(-(high * low), one_sided)
    }

    /// The larger of both.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        let above = self - other;
        if above.low().all_positive() {
            return self;
        }
        if (-above.high()).all_positive() {
            return other;
        }
        (self + other + above.abs()) * 0.5
    }

    /// The smaller of both.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        -(-self).max(-other)
    }

    /// What holds both, in each lane.
    pub fn hull(self, other: Self) -> Self {
        self.lanewise_with(other, Strip::hull)
    }

    /// This in the lanes where `condition` is above zero, else `other`.
    #[inline(always)]
    pub fn where_positive(self, condition: Lanes, other: Self) -> Self {
        Self {
            middle: self.middle.where_positive(condition, other.middle),
            slope: self.slope.where_positive(condition, other.slope),
            reach: self.reach.where_positive(condition, other.reach),
        }
    }

    /// A function of bands that takes other ways in other lanes: it is given one lane at a time, in all lanes.
    pub fn by_lanes<const N: usize>(bands: [Self; N], f: impl Fn([Self; N]) -> Self) -> Self {
        let at = |i: usize| f(bands.map(|band| Self::of([band.lane(i); Lanes::COUNT]))).lane(i);
        Self::of([at(0), at(1), at(2), at(3)])
    }

    #[inline(always)]
    fn lane(self, i: usize) -> Strip {
        Strip { middle: self.middle.0[i], slope: self.slope.0[i], reach: self.reach.0[i] }
    }

    /// A function of each lane.
    #[inline(always)]
    fn lanewise(self, f: impl Fn(Strip) -> Strip) -> Self {
        Self::of([f(self.lane(0)), f(self.lane(1)), f(self.lane(2)), f(self.lane(3))])
    }

    #[inline(always)]
    fn of(strips: [Strip; Lanes::COUNT]) -> Self {
        let [a, b, c, d] = strips;
        Self {
            middle: Lanes([a.middle, b.middle, c.middle, d.middle]),
            slope: Lanes([a.slope, b.slope, c.slope, d.slope]),
            reach: Lanes([a.reach, b.reach, c.reach, d.reach]),
        }
    }

    /// A function of each lane of both.
    #[inline(always)]
    fn lanewise_with(self, other: Self, f: impl Fn(Strip, Strip) -> Strip) -> Self {
        let at = |i: usize| f(self.lane(i), other.lane(i));
        Self::of([at(0), at(1), at(2), at(3)])
    }
}

/// One lane of a [`Band`].
#[derive(Clone, Copy, Debug)]
struct Strip {
    middle: f64,
    slope: f64,
    reach: f64,
}

impl Strip {
    const UNKNOWN: Self = Self { middle: 0.0, slope: 0.0, reach: f64::INFINITY };

    /// All between two bounds, which may be the same; nothing is known of what isn't finite.
    fn between(low: f64, high: f64) -> Self {
        let middle = 0.5 * (low + high);
        let reach = (high - middle).max(middle - low);
        if low == high {
            Self { middle: low, slope: 0.0, reach: 0.0 }
        } else if reach.is_finite() && middle.is_finite() {
            Self { middle, slope: 0.0, reach: reach + (middle.abs() + reach) * ROUNDING }
        } else {
            Self::UNKNOWN
        }
    }

    fn spread(self) -> f64 {
        (self.slope.abs() + self.reach) * (1.0 + ROUNDING)
    }

    /// Bounds; not numbers where nothing is known.
    fn range(self) -> (f64, f64) {
        let spread = self.spread();
        let room = spread + (self.middle.abs() + spread) * ROUNDING;
        if spread == 0.0 { (self.middle, self.middle) } else { (self.middle - room, self.middle + room) }
    }

    fn negated(self) -> Self {
        Self { middle: -self.middle, slope: -self.slope, ..self }
    }

    fn hull(self, other: Self) -> Self {
        let ((a, b), (p, q)) = (self.range(), other.range());
        if [a, b, p, q].into_iter().all(f64::is_finite) {
            Self::between(a.min(p), b.max(q))
        } else {
            Self::UNKNOWN
        }
    }
}

impl Add for Band {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let sum = Self {
            middle: self.middle + other.middle,
            slope: self.slope + other.slope,
            reach: self.reach + other.reach,
        };
        sum.rounded(Lanes::ZERO)
    }
}

impl Sub for Band {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let difference = Self {
            middle: self.middle - other.middle,
            slope: self.slope - other.slope,
            reach: self.reach + other.reach,
        };
        difference.rounded(Lanes::ZERO)
    }
}

impl Mul for Band {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        // The product of both slopes is of the square of s, which is between 0 and 1.
        let bend = a.slope * b.slope * 0.5;
        let (size, other_size) = (a.middle.abs() + a.slope.abs(), b.middle.abs() + b.slope.abs());
        let product = Self {
            middle: a.middle * b.middle + bend,
            slope: a.middle * b.slope + a.slope * b.middle,
            reach: bend.abs() + a.reach * other_size + b.reach * (size + a.reach),
        };
        product.rounded(size * other_size)
    }
}

impl Div for Band {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "the product of one with the other's inverse")]
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}

impl Neg for Band {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { middle: -self.middle, slope: -self.slope, ..self }
    }
}

impl Add<f64> for Band {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self { middle: self.middle + other, ..self }.rounded(Lanes::ZERO)
    }
}

impl Sub<f64> for Band {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        self + -other
    }
}

impl Mul<f64> for Band {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let scaled =
            Self { middle: self.middle * other, slope: self.slope * other, reach: self.reach * other.abs() };
        scaled.rounded(Lanes::ZERO)
    }
}

impl Div<f64> for Band {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self / Self::constant(other)
    }
}
