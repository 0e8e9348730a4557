//! Fractals along lines: bounds of their values.
//!
//! All points of a stretch are iterated together. Those that may escape at a step contribute what they would be then,
//! the others go on, until none is left or what holds them is so wide that it says nothing. Then they may escape at any
//! later step or never. Where all are drawn to a cycle, a later step comes to lie within an earlier one, and so do all
//! that follow.

use super::{DRAWN, Fractal, Iteration, LIMIT, MAGNET_LIMIT, add, divide, multiply, size, square};
use crate::math::{Band, DVec2, Lanes};

/// A complex number.
type Complex = [Band; 2];

/// Wider orbits say nothing.
const WIDEST: f64 = 1.0;

/// So many steps are gone.
const MOST_STEPS: u32 = 4000;

/// The first step that later ones may come back to.
const FIRST_MARK: u32 = 16;

/// By how much what later steps have to come back into is widened, and at least.
const WIDER: [f64; 2] = [1.1, 1e-13];

impl Fractal {
    /// What holds the values at all points that these hold.
    pub(in crate::world::pattern) fn along(&self, [x, y, _]: &[Band; 3]) -> Band {
        Band::by_lanes([*x, *y], |point| self.orbits(point))
    }

    /// The same of one lane.
    fn orbits(&self, point: Complex) -> Band {
        let magnet = self.iteration.is_magnet();
        let c = self.julia.map_or(point, |c: DVec2| c.to_array().map(Band::constant));
        let from_zero = magnet && self.julia.is_none();
        let mut z = if from_zero { [Band::constant(0.0); 2] } else { point };
        let mut nearest = if from_zero { Band::constant(MAGNET_LIMIT) } else { size(z) };
        let mut escaped: Option<Band> = None;
        let with = |escaped: Option<Band>, more: Band| escaped.map_or(more, |all| all.hull(more));
        let mut mark: Option<Complex> = None;
        let (mut marked, mut next_mark) = (0, FIRST_MARK);
        let (mut count, mut steps) = (0, 0);
        while count < self.iterations {
            z = self.iteration.step_along(z, c);
            let square = size(z);
            let may = self.escapes(z, square);
            if may[1] {
                escaped = Some(with(escaped, self.outside(count, z)));
                if !may[0] {
                    return escaped.unwrap_or(Band::UNKNOWN);
                }
                mark = None;
                z = z.map(|v| self.kept(v));
            }
            nearest = nearest.min(square);
            let is_narrow = z.iter().all(|v| v.spread().0[0] < WIDEST);
            if !is_narrow || steps > MOST_STEPS {
                return with(escaped, self.any_later(count, c, nearest));
            }
            (count, steps) = (count + 1, steps + 1);
            if mark.is_some_and(|mark| within(z, mark)) {
                let round = count - marked;
                count = self.iterations - (self.iterations - count) % round;
                mark = None;
                next_mark = u32::MAX;
            } else if count == next_mark {
                z = z.map(|v| Band { reach: v.reach * WIDER[0] + WIDER[1], ..v });
                (mark, marked) = (Some(z), count);
                next_mark = next_mark.saturating_mul(2);
            }
        }
        with(escaped, self.inside(nearest, z))
    }

    /// Whether some may stay and whether some may escape. Of what is no number both may be.
    fn escapes(&self, z: Complex, square: Band) -> [bool; 2] {
        let [low, high] = [square.low().0[0], square.high().0[0]];
        let is_no = |sure: bool| !sure;
        if !self.iteration.is_magnet() {
            return [is_no(low > LIMIT), is_no(high <= LIMIT)];
        }
        let from_one = size([z[0] - 1.0, z[1]]);
        let [near, far] = [from_one.low().0[0], from_one.high().0[0]];
        [is_no(low > MAGNET_LIMIT || far < DRAWN), is_no(high <= MAGNET_LIMIT && near >= DRAWN)]
    }

    /// As far from 0 as what has not escaped may be along an axis.
    fn limit(&self) -> f64 {
        if self.iteration.is_magnet() { MAGNET_LIMIT.sqrt() } else { LIMIT.sqrt() }
    }

    fn kept(&self, v: Band) -> Band {
        let limit = Band::constant(self.limit());
        v.max(-limit).min(limit)
    }

    /// What those may be that escape from step `count` on or never.
    fn any_later(&self, count: u32, c: Complex, nearest: Band) -> Band {
        let (kind, factor) = self.exterior;
        let stayed = [Band::between(-self.limit(), self.limit()); 2];
        let among = |m: f64| Band::between(0.0, f64::from((m as u32).max(1) - 1) / factor);
        let outside = match kind {
            1 => Band::between(f64::from(count) / f64::from(self.iterations), 1.0),
            7 => among(factor),
            8 => among(1.0 + factor),
            _ => self.outside(count, self.iteration.step(stayed, c)),
        };
        let most = nearest.high().0[0].min(self.limit().powi(2));
        outside.hull(self.inside(Band::between(0.0, most), stayed))
    }
}

impl Iteration {
    /// [`Iteration::step`] for points that these hold: to either side of a line it takes them as far as its derivative
    /// says, which may be much nearer than what its terms do one by one.
    fn step_along(&self, z: Complex, c: Complex) -> Complex {
        let plain = self.step(z, c);
        let on_line = self.step(z.map(|v| Band { reach: Lanes::ZERO, ..v }), c);
        let beside = (z[0].reach * z[0].reach + z[1].reach * z[1].reach).sqrt();
        let beside = beside * size(self.derivative(z, c)).sqrt().high();
        [0, 1].map(|i| {
            let mean = Band { reach: on_line[i].reach + beside, ..on_line[i] }.loose();
            // What is no number says nothing.
            if mean.reach.0[0] < plain[i].reach.0[0] { mean } else { plain[i] }
        })
    }

    /// By the point, the constant being one.
    fn derivative(&self, z: Complex, c: Complex) -> Complex {
        let power = |exponent: u32| {
            let low = (2..exponent).fold(z, |power, _| multiply(power, z));
            low.map(|v| v * f64::from(exponent))
        };
        let times = |v: Complex, by: f64| v.map(|v| v * by);
        let plus = |[x, y]: Complex, v: f64| [x + v, y];
        // The square of a quotient.
        let of_quotient = |top: Complex, bottom: Complex, slopes: [Complex; 2]| {
            let falls = times(multiply(top, slopes[1]), -1.0);
            let slope = divide(add(multiply(slopes[0], bottom), falls), square(bottom));
            times(multiply(divide(top, bottom), slope), 2.0)
        };
        match self {
            Self::Power(exponent) => power(*exponent),
            Self::Binomial(coefficients) => power(coefficients.len() as u32 - 1),
            Self::Magnet1 => {
                let top = plus(add(square(z), c), -1.0);
                let bottom = plus(add(times(z, 2.0), c), -2.0);
                of_quotient(top, bottom, [times(z, 2.0), [2.0, 0.0].map(Band::constant)])
            }
            Self::Magnet2 => {
                let (c1, c2) = (times(plus(c, -1.0), 3.0), times(plus(c, -2.0), 3.0));
                let last = times(multiply(c1, c2), 1.0 / 9.0);
                let squares = times(square(z), 3.0);
                let top = add(multiply(square(z), z), add(multiply(c1, z), last));
                let bottom = plus(add(squares, add(multiply(c2, z), last)), 1.0);
                of_quotient(top, bottom, [add(squares, c1), add(times(z, 6.0), c2)])
            }
        }
    }
}

/// Whether orbits lie within others all along.
fn within(z: Complex, others: Complex) -> bool {
    z.iter().zip(&others).all(|(v, other)| {
        let away = (v.middle.0[0] - other.middle.0[0]).abs() + (v.slope.0[0] - other.slope.0[0]).abs();
        away + v.reach.0[0] <= other.reach.0[0]
    })
}
