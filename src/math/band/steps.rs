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
