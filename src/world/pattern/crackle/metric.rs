//! How `crackle` and `facets` measure distances.

use crate::math::{DVec3, Lanes};

/// The sum that stands for a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Metric {
    /// `metric 2`: squares.
    Square,
    /// `metric 1`: absolute values.
    Absolute,
    /// Another multiple of a half up to 8: a whole power and, of an odd one, a root besides.
    Halves(u32),
    /// Any other power.
    Power(f64),
}

impl Metric {
    /// Beyond this multiplying out is no longer as exact as a power.
    const LARGEST_WHOLE: f64 = 8.0;

    /// The metric for the number a user writes.
    pub fn new(metric: f64) -> Self {
        let halves = 2.0 * metric;
        match metric {
            2.0 => Self::Square,
            1.0 => Self::Absolute,
            _ if halves > 0.0 && metric <= Self::LARGEST_WHOLE && halves.fract() == 0.0 => {
                Self::Halves(halves as u32)
            }
            other => Self::Power(other),
        }
    }

    /// Larger ones would lead out of the range of [`Lanes::power`].
    const LARGEST_OF_FOUR: f64 = 32.0;

    /// The power that [`Lanes::power`] takes four numbers to.
    #[inline(always)]
    pub(super) fn power_of_four(self) -> Option<f64> {
        match self {
            Self::Power(m) if m > 0.0 && m <= Self::LARGEST_OF_FOUR => Some(m),
            _ => None,
        }
    }

    /// The power.
    pub(super) fn exponent(self) -> f64 {
        match self {
            Self::Square => 2.0,
            Self::Absolute => 1.0,
            Self::Halves(halves) => f64::from(halves) / 2.0,
            Self::Power(m) => m,
        }
    }

    /// What a difference of coordinates adds to the sum.
    pub(super) fn part(self, d: f64) -> f64 {
        match self {
            Self::Square => d * d,
            Self::Absolute => d.abs(),
            Self::Halves(halves) => power_of_halves(d.abs(), halves),
            Self::Power(m) => d.abs().powf(m),
        }
    }

    /// The same of four differences.
    #[inline(always)]
    pub(super) fn part_of_four(self, d: Lanes) -> Lanes {
        match self {
            Self::Square => d * d,
            Self::Absolute => d.abs(),
            Self::Halves(halves) => four_to_halves(d.abs(), halves),
            Self::Power(m) if self.power_of_four().is_some() => d.abs().power(m),
            Self::Power(m) => d.map(|d| d.abs().powf(m)),
        }
    }

    /// The sums of four points' differences, coordinate by coordinate.
    #[inline(always)]
    pub(super) fn sum_of_four(self, x: Lanes, y: Lanes, z: Lanes) -> Lanes {
        self.part_of_four(x) + self.part_of_four(y) + self.part_of_four(z)
    }

    pub(super) fn sum(self, d: DVec3) -> f64 {
        self.part(d.x) + self.part(d.y) + self.part(d.z)
    }

    pub(super) fn distance(self, sum: f64) -> f64 {
        match self {
            Self::Square => sum.sqrt(),
            Self::Absolute => sum,
            Self::Halves(_) | Self::Power(_) => self.root(sum),
        }
    }

    /// The distances of four sums. An offset may have made them negative, of which only single powers know what to make.
    #[inline(always)]
    pub(super) fn distances(self, sums: Lanes) -> Lanes {
        match self {
            Self::Square => sums.sqrt(),
            Self::Absolute => sums,
            Self::Halves(_) | Self::Power(_) if self.grows() && sums.bits(|sum| sum < 0.0) == 0 => {
                sums.power(self.exponent().recip())
            }
            Self::Halves(_) | Self::Power(_) => sums.map(|sum| self.root(sum)),
        }
    }

    /// Out of line: powers are taken beforehand otherwise, for all metrics.
    #[inline(never)]
    pub(super) fn root(self, sum: f64) -> f64 {
        sum.powf(1.0 / self.exponent())
    }

    pub(super) fn offset(self, offset: f64) -> f64 {
        match self {
            _ if offset == 0.0 => 0.0,
            Self::Square => offset * offset,
            Self::Absolute => offset,
            Self::Halves(_) | Self::Power(_) => offset.powf(self.exponent()),
        }
    }

    /// How many times farther, as a share of squares of Euclidean distances, a seed may be that is as near by the
    /// metric as another: means of powers of three numbers are no farther apart. `None` where squares tell nothing, or
    /// sums are found as soon.
    #[inline(always)]
    pub(super) fn stretched(self) -> Option<f64> {
        /// For rounding.
        const ROOM: f64 = 1.0 + 1e-9;
        match self {
            Self::Square | Self::Absolute => None,
            _ if !self.grows() => None,
            _ => Some(3.0_f64.powf((2.0 / self.exponent() - 1.0).abs()) * ROOM),
        }
    }

    /// Whether sums grow with distances.
    pub(super) fn grows(self) -> bool {
        self.exponent() > 0.0
    }

    /// Whether no seed two cells away, a whole cell between, can be as near as `limit`.
    pub(super) fn ends_nearby(self, limit: f64) -> bool {
        self.grows() && limit < 1.0 - 1e-9
    }
}

/// A number that isn't negative to so many halves, 16 at most.
#[inline(always)]
pub(super) fn power_of_halves(x: f64, halves: u32) -> f64 {
    let square = x * x;
    let fourth = square * square;
    let factor = |bit: u32, factor: f64| if halves & bit == 0 { 1.0 } else { factor };
    let whole = factor(2, x) * factor(4, square) * factor(8, fourth) * factor(16, fourth * fourth);
    whole * factor(1, x.sqrt())
}

/// [`power_of_halves`] of four numbers.
#[inline(always)]
fn four_to_halves(x: Lanes, halves: u32) -> Lanes {
    let square = x * x;
    let fourth = square * square;
    let mut whole = Lanes::splat(1.0);
    for (bit, factor) in [(2, x), (4, square), (8, fourth), (16, fourth * fourth)] {
        if halves & bit != 0 {
            whole = whole * factor;
        }
    }
    if halves & 1 == 0 { whole } else { whole * x.sqrt() }
}
