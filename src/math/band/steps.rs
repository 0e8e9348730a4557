//! Bands of functions that jump: they hold what is on both sides.

use super::{Band, Strip};

impl Strip {
    /// 1 where `holds` is known to be, 0 where it is known not to be.
    fn truth(holds: Option<bool>) -> Self {
        match holds {
            Some(holds) => Self { middle: f64::from(u8::from(holds)), slope: 0.0, reach: 0.0 },
            None => Self { middle: 0.5, slope: 0.0, reach: 0.5 },
        }
    }

    /// Whether it is no number but 0, or surely isn't 0.
    fn is_true(self) -> Option<bool> {
        match self.range() {
            (0.0, 0.0) => Some(false),
            (low, high) if low > 0.0 || high < 0.0 => Some(true),
            _ => None,
        }
    }
}

impl Band {
    /// The next lower whole numbers.
    pub fn floor(self) -> Self {
        self.lanewise(|s| s.stepped(f64::floor))
    }

    /// The next higher whole numbers.
    pub fn ceil(self) -> Self {
        self.lanewise(|s| s.stepped(f64::ceil))
    }

    /// A function that never falls and is exact.
    pub fn stepped(self, value: impl Fn(f64) -> f64) -> Self {
        self.lanewise(|s| s.stepped(&value))
    }

    /// What is above the next lower whole number; where that isn't sure, 0 … 1.
    pub fn fraction(self) -> Self {
        let whole = self.floor();
        Self::between(0.0, 1.0).where_positive(whole.reach, self - whole)
    }

    /// What is left over a multiple of `divisor`, with the sign of `self`.
    pub fn remainder(self, divisor: Self) -> Self {
        let Some(divisor) = divisor.fixed().map(f64::abs).filter(|d| *d > 0.0) else {
            return Self::UNKNOWN;
        };
        self.lanewise(|s| {
            let (low, high) = s.range();
            let (first, last) = ((low / divisor).trunc(), (high / divisor).trunc());
            // Beside a multiple the quotient's rounding may say either.
            let sure = |q: f64| (q - q.round()).abs() > 1e-12 * q.abs().max(1.0);
            if first == last && sure(low / divisor) && sure(high / divisor) {
                let room = super::ROUNDING * (s.middle.abs() + first.abs() * divisor);
                return Self::shifted(s, -first * divisor, room);
            }
            let least = if low >= 0.0 { 0.0 } else { -divisor };
            let most = if high <= 0.0 { 0.0 } else { divisor };
            Strip::between(least, most)
        })
    }

    /// The height of a broken line through `points` of rising x, which is level beyond its ends; where two have the
    /// same x it steps.
    pub fn broken_line(self, points: &[(f64, f64)]) -> Self {
        self.lanewise(|s| {
            let (low, high) = s.range();
            if low.is_nan() || points.is_empty() {
                return Strip::UNKNOWN;
            }
            let between =
                |x: f64, after: usize| match (after.checked_sub(1).map(|i| points[i]), points.get(after)) {
                    (Some(a), Some(b)) => a.1 + (x - a.0) * ((b.1 - a.1) / (b.0 - a.0)),
                    (Some(a), None) => a.1,
                    (None, Some(b)) => b.1,
                    (None, None) => 0.0,
                };
            let first = points.partition_point(|point| point.0 < low);
            let last = points.partition_point(|point| point.0 <= high);
            if first == last {
                let (Some(a), Some(b)) = (first.checked_sub(1).map(|i| points[i]), points.get(first)) else {
                    return Strip::between(between(low, first), between(low, first));
                };
                let slope = (b.1 - a.1) / (b.0 - a.0);
                let rise = (s.middle - a.0) * slope;
                let size = a.1.abs() + rise.abs() + (s.slope * slope).abs();
                let reach = s.reach * slope.abs() + 2.0 * super::ROUNDING * size;
                return Strip { middle: a.1 + rise, slope: s.slope * slope, reach };
            }
            let ends = [between(low, first), between(high, last)];
            let all = points[first..last].iter().map(|point| point.1).chain(ends);
            let (least, most) = all.fold((f64::MAX, f64::MIN), |(a, b), y| (a.min(y), b.max(y)));
            Strip::between(least, most)
        })
    }

    fn shifted(strip: Strip, by: f64, room: f64) -> Strip {
        Strip { middle: strip.middle + by, reach: strip.reach + room, ..strip }
    }

    /// 1 where it is below `other`, else 0.
    pub fn less(self, other: Self) -> Self {
        self.lanewise_with(other, |a, b| {
            let ((a_low, a_high), (b_low, b_high)) = (a.range(), b.range());
            let no = (a_low >= b_high).then_some(false);
            Strip::truth((a_high < b_low).then_some(true).or(no))
        })
    }

    /// 1 where it isn't above `other`, else 0.
    pub fn less_equal(self, other: Self) -> Self {
        self.lanewise_with(other, |a, b| {
            let ((a_low, a_high), (b_low, b_high)) = (a.range(), b.range());
            let no = (a_low > b_high).then_some(false);
            Strip::truth((a_high <= b_low).then_some(true).or(no))
        })
    }

    /// 1 where both are the same, else 0.
    pub fn equal(self, other: Self) -> Self {
        self.lanewise_with(other, |a, b| {
            let ((a_low, a_high), (b_low, b_high)) = (a.range(), b.range());
            let yes = (a_low == a_high && b_low == b_high && a_low == b_low).then_some(true);
            let no = (a_low > b_high || a_high < b_low).then_some(false);
            Strip::truth(yes.or(no))
        })
    }

    /// 1 where both aren't 0, else 0.
    pub fn and(self, other: Self) -> Self {
        self.lanewise_with(other, |a, b| {
            Strip::truth(match (a.is_true(), b.is_true()) {
                (Some(true), Some(true)) => Some(true),
                (Some(false), _) | (_, Some(false)) => Some(false),
                _ => None,
            })
        })
    }

    /// 1 where one of both isn't 0, else 0.
    pub fn or(self, other: Self) -> Self {
        self.is_false().and(other.is_false()).is_false()
    }

    /// 1 where it is 0, else 0.
    pub fn is_false(self) -> Self {
        self.lanewise(|s| Strip::truth(s.is_true().map(|is| !is)))
    }
}

impl Strip {
    /// A function that never falls and is exact.
    fn stepped(self, value: impl Fn(f64) -> f64) -> Self {
        let (low, high) = self.range();
        Self::between(value(low), value(high))
    }
}
