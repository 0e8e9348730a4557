//! `mandel`, `julia`, `magnet`: fractals of the x-y plane (docs/spec/patterns-textures.md 2.5).

mod along;

use crate::math::{DVec2, DVec3};
use crate::world::function::{Number, Unary};

/// A fractal and how it is coloured.
#[derive(Clone, Debug)]
pub struct Fractal {
    /// What is iterated.
    pub iteration: Iteration,
    /// The constant; `None` takes the point.
    pub julia: Option<DVec2>,
    /// How often at most.
    pub iterations: u32,
    /// Type 0 … 6 and factor where nothing escapes.
    pub interior: (u32, f64),
    /// Type 0 … 8 and factor where something does.
    pub exterior: (u32, f64),
}

/// One step of a fractal.
#[derive(Clone, Debug)]
pub enum Iteration {
    /// z^n + c for n = 2, 3, 4.
    Power(u32),
    /// z^n + c, with the binomial coefficients of n.
    Binomial(Box<[f64]>),
    /// `magnet 1`.
    Magnet1,
    /// `magnet 2`.
    Magnet2,
}

impl Iteration {
    /// z^n + c.
    pub fn power(exponent: u32) -> Self {
        if exponent <= 4 {
            return Self::Power(exponent);
        }
        let next = |&(k, c): &(u64, u64)| Some((k + 1, c * (u64::from(exponent) - k) / (k + 1)));
        let row = std::iter::successors(Some((0, 1)), next).take(exponent as usize + 1);
        // POV-Ray keeps the coefficients in 32 bits; the largest, for 33, fits.
        Self::Binomial(row.map(|(_, c)| c as i32 as f64).collect())
    }

    fn is_magnet(&self) -> bool {
        matches!(self, Self::Magnet1 | Self::Magnet2)
    }

    #[inline(always)]
    fn step<N: Number>(&self, z: [N; 2], c: [N; 2]) -> [N; 2] {
        let [a, b] = z;
        let (a2, b2) = (a.unary(Unary::Square), b.unary(Unary::Square));
        match self {
            Self::Power(3) => [a2 * a - a * 3.0 * b2 + c[0], a2 * 3.0 * b - b2 * b + c[1]],
            Self::Power(4) => {
                [a2 * a2 - a2 * 6.0 * b2 + b2 * b2 + c[0], (a2 * a * b - a * b2 * b) * 4.0 + c[1]]
            }
            Self::Power(_) => [a2 - b2 + c[0], a * 2.0 * b + c[1]],
            Self::Binomial(coefficients) => {
                let n = coefficients.len() as i32 - 1;
                let power = |v: N, exponent: i32| v.powf(N::constant(f64::from(exponent)));
                let mut sum = [c[0] + power(a, n), c[1]];
                for (k, coefficient) in (0..).zip(coefficients).skip(1) {
                    let term = power(a, n - k) * *coefficient * power(b, k);
                    let part = &mut sum[(k & 1) as usize];
                    *part = *part + if k & 2 == 0 { term } else { -term };
                }
                sum
            }
            Self::Magnet1 => {
                let top = [a2 - b2 + c[0] - 1.0, a * 2.0 * b + c[1]];
                let bottom = [a * 2.0 + c[0] - 2.0, b * 2.0 + c[1]];
                square(divide(top, bottom))
            }
            Self::Magnet2 => {
                let (c1, c2) = ([c[0] - 1.0, c[1]], [c[0] - 2.0, c[1]]);
                // The product of c1 and c2, in POV-Ray's order of rounding as are the cube and the square.
                let last = [c1[0] * c2[0] - c[1] * c[1], c[1] * (c1[0] + c2[0])];
                let cube = [a2 * a - a * 3.0 * b2, a2 * 3.0 * b - b2 * b];
                let triple_square = [(a2 - b2) * 3.0, a * 6.0 * b];
                let triple = |u: [N; 2]| multiply(u, z).map(|v| v * 3.0);
                let top = add(add(cube, triple(c1)), last);
                let [x, y] = add(add(triple_square, triple(c2)), last);
                square(divide(top, [x + 1.0, y]))
            }
        }
    }
}

fn add<N: Number>(u: [N; 2], v: [N; 2]) -> [N; 2] {
    [u[0] + v[0], u[1] + v[1]]
}

fn multiply<N: Number>(u: [N; 2], v: [N; 2]) -> [N; 2] {
    [u[0] * v[0] - u[1] * v[1], u[0] * v[1] + u[1] * v[0]]
}

fn divide<N: Number>(u: [N; 2], v: [N; 2]) -> [N; 2] {
    let size = size(v);
    [(u[0] * v[0] + u[1] * v[1]) / size, (u[1] * v[0] - u[0] * v[1]) / size]
}

fn square<N: Number>([x, y]: [N; 2]) -> [N; 2] {
    [x.unary(Unary::Square) - y.unary(Unary::Square), x * 2.0 * y]
}

/// The square of the distance from 0.
fn size<N: Number>([x, y]: [N; 2]) -> N {
    x.unary(Unary::Square) + y.unary(Unary::Square)
}

/// Values up to here don't count as escaped, by their square; those of magnets.
const LIMIT: f64 = 4.0;
const MAGNET_LIMIT: f64 = 10000.0;

/// Magnets draw what is nearer to 1 than this, by its square.
const DRAWN: f64 = 1.0 / 10000.0;

impl Fractal {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        // The loop is made for each step, which is a few operations.
        match &self.iteration {
            Iteration::Power(2) => self.iterate_squares(p),
            step => self.iterate(p, |z, c| DVec2::from_array(step.step(z.to_array(), c.to_array()))),
        }
    }

    #[inline(always)]
    fn iterate(&self, p: DVec3, step: impl Fn(DVec2, DVec2) -> DVec2) -> f64 {
        let point = DVec2::new(p.x, p.y);
        let magnet = self.iteration.is_magnet();
        let c = self.julia.unwrap_or(point);
        let starts_at_zero = magnet && self.julia.is_none();
        let mut z = if starts_at_zero { DVec2::ZERO } else { point };
        let mut nearest = if starts_at_zero { MAGNET_LIMIT } else { z.length_squared() };
        for count in 0..self.iterations {
            z = step(z, c);
            let square = z.length_squared();
            nearest = if square < nearest { square } else { nearest };
            let escaped = match magnet {
                true => square > MAGNET_LIMIT || (z - DVec2::X).length_squared() < DRAWN,
                false => square > LIMIT,
            };
            if escaped {
                return self.outside(count, z.to_array());
            }
        }
        self.inside(nearest, z.to_array())
    }

    /// The same for z² + c, number by number: each step waits for the one before, and pairs of numbers that
    /// are put together and taken apart would make it wait longer. What comes back to the very same point goes
    /// round for ever, so whole rounds need not be gone.
    fn iterate_squares(&self, p: DVec3) -> f64 {
        let (mut a, mut b) = (p.x, p.y);
        let c = self.julia.unwrap_or(DVec2::new(a, b));
        let (mut a2, mut b2) = (a * a, b * b);
        let mut nearest = a2 + b2;
        let mut mark = (a, b);
        let (mut marked, mut next_mark) = (0, 32);
        let mut count = 0;
        while count < self.iterations {
            b = 2.0 * a * b + c.y;
            // Not a2 - b2 + c.x, which is the same but would be paired with the line above.
            a = c.x - (b2 - a2);
            (a2, b2) = (a * a, b * b);
            let square = a2 + b2;
            if square > LIMIT {
                return self.outside(count, [a, b]);
            }
            nearest = if square < nearest { square } else { nearest };
            count += 1;
            if (a, b) == mark {
                let round = count - marked;
                count = self.iterations - (self.iterations - count) % round;
                mark = (f64::NAN, f64::NAN);
            } else if count == next_mark {
                if marked == 0 && self.julia.is_none() && self.interior.0 == 0 && never_escapes(c) {
                    break;
                }
                (mark, marked) = ((a, b), count);
                next_mark = next_mark.saturating_mul(2);
            }
        }
        self.inside(nearest, [a, b])
    }

    fn outside<N: Number>(&self, count: u32, z: [N; 2]) -> N {
        let (kind, factor) = self.exterior;
        let count_modulo = |m: f64| f64::from(count % (m as u32).max(1));
        match kind {
            0 => N::constant(factor),
            1 => N::constant(f64::from(count) / f64::from(self.iterations)),
            6 => size(z).sqrt() * factor,
            7 => N::constant(count_modulo(factor) / factor),
            8 => N::constant(count_modulo(1.0 + factor) / factor),
            _ => component(kind, z) * factor,
        }
    }

    fn inside<N: Number>(&self, nearest: N, z: [N; 2]) -> N {
        let (kind, factor) = self.interior;
        match kind {
            0 => N::constant(factor),
            1 => nearest.sqrt() * factor,
            6 => z[0].unary(Unary::Square) + z[1].unary(Unary::Square) * factor,
            _ => component(kind, z) * factor,
        }
    }
}

/// The least by which a cycle must draw points nearer at each round, so that rounding doesn't let them escape: it moves
/// them by 10⁻¹⁶ at each step, 10⁻¹⁰ in all, while others are as far away as this share at least.
const DRAW: f64 = 1e-6;

/// Whether z² + c is drawn to a point or a cycle of two when it starts at c, beyond all doubt: by the derivative 2z at
/// the fixed point (1 - √(1 - 4c)) / 2, and the product 4(c + 1) of both around the cycle.
fn never_escapes(c: DVec2) -> bool {
    let limit = (1.0 - DRAW) * (1.0 - DRAW);
    if 16.0 * DVec2::new(c.x + 1.0, c.y).length_squared() < limit {
        return true;
    }
    let w = DVec2::new(1.0 - 4.0 * c.x, -4.0 * c.y);
    let root = (0.5 * (w.length() + w.x)).sqrt();
    // Not where it is 0 either, beyond the cusp.
    DVec2::new(1.0 - root, 0.5 * w.y / root).length_squared() < limit
}

/// What types 2 … 5 look at.
fn component<N: Number>(kind: u32, [x, y]: [N; 2]) -> N {
    match kind {
        2 => x,
        3 => y,
        4 => x.unary(Unary::Square),
        _ => y.unary(Unary::Square),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_never_escapes_does_not_escape() {
        let fractal = |interior| {
            let iteration = Iteration::power(2);
            Fractal { iteration, julia: None, iterations: 3000, interior, exterior: (1, 1.0) }
        };
        let (quick, slow) = (fractal((0, 7.0)), fractal((6, 1.0)));
        let (mut inside, mut sure) = (0, 0);
        for n in 0..4000_u32 {
            let at = |by: f64| (f64::from(n) * by).fract();
            // Half of them around the place where cardioid and disc meet.
            let (size, x) = if n % 2 == 0 { (2.6, -2.0) } else { (2e-3, -0.751) };
            let point = DVec3::new(x + size * at(0.754_877_666), size * (at(0.569_840_291) - 0.5), 0.0);
            let is_inside = quick.value(point) == 7.0;
            assert!(is_inside || !never_escapes(point.truncate()), "{point}");
            // The same as without the short cut.
            assert!(is_inside || quick.value(point) == slow.value(point), "{point}");
            inside += u32::from(is_inside);
            sure += u32::from(never_escapes(point.truncate()));
        }
        assert!(sure * 10 > inside * 8, "{sure} of {inside}");
    }
}
