//! `mandel`, `julia`, `magnet`: fractals of the x-y plane (docs/spec/patterns-textures.md 2.5).

use crate::math::{DVec2, DVec3};

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

    fn step(&self, z: DVec2, c: DVec2) -> DVec2 {
        let (a, b) = (z.x, z.y);
        let (a2, b2) = (a * a, b * b);
        match self {
            Self::Power(3) => DVec2::new(a2 * a - 3.0 * a * b2 + c.x, 3.0 * a2 * b - b2 * b + c.y),
            Self::Power(4) => {
                DVec2::new(a2 * a2 - 6.0 * a2 * b2 + b2 * b2 + c.x, 4.0 * (a2 * a * b - a * b2 * b) + c.y)
            }
            Self::Power(_) => DVec2::new(a2 - b2 + c.x, 2.0 * a * b + c.y),
            Self::Binomial(coefficients) => {
                let n = coefficients.len() as i32 - 1;
                let mut sum = [c.x + a.powf(f64::from(n)), c.y];
                for (k, coefficient) in (0..).zip(coefficients).skip(1) {
                    let term = coefficient * a.powf(f64::from(n - k)) * b.powf(f64::from(k));
                    let part = &mut sum[(k & 1) as usize];
                    *part += if k & 2 == 0 { term } else { -term };
                }
                DVec2::from_array(sum)
            }
            Self::Magnet1 => {
                let top = DVec2::new(a2 - b2 + c.x - 1.0, 2.0 * a * b + c.y);
                let bottom = 2.0 * z + c - DVec2::new(2.0, 0.0);
                square(divide(top, bottom))
            }
            Self::Magnet2 => {
                let (c1, c2) = (c - DVec2::X, c - 2.0 * DVec2::X);
                // The product of c1 and c2, in POV-Ray's order of rounding as are the cube and the square.
                let last = DVec2::new(c1.x * c2.x - c.y * c.y, c.y * (c1.x + c2.x));
                let cube = DVec2::new(a2 * a - 3.0 * a * b2, 3.0 * a2 * b - b2 * b);
                let triple_square = DVec2::new(3.0 * (a2 - b2), 6.0 * a * b);
                let top = cube + 3.0 * multiply(c1, z) + last;
                let bottom = triple_square + 3.0 * multiply(c2, z) + last + DVec2::X;
                square(divide(top, bottom))
            }
        }
    }
}

fn multiply(u: DVec2, v: DVec2) -> DVec2 {
    DVec2::new(u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x)
}

fn divide(u: DVec2, v: DVec2) -> DVec2 {
    DVec2::new(u.x * v.x + u.y * v.y, u.y * v.x - u.x * v.y) / (v.x * v.x + v.y * v.y)
}

fn square(z: DVec2) -> DVec2 {
    DVec2::new(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y)
}

impl Fractal {
    pub(super) fn value(&self, p: DVec3) -> f64 {
        // The loop is made for each step, which is a few operations.
        match &self.iteration {
            Iteration::Power(2) => self.iterate_squares(p),
            step => self.iterate(p, |z, c| step.step(z, c)),
        }
    }

    #[inline(always)]
    fn iterate(&self, p: DVec3, step: impl Fn(DVec2, DVec2) -> DVec2) -> f64 {
        let point = DVec2::new(p.x, p.y);
        let magnet = self.iteration.is_magnet();
        let c = self.julia.unwrap_or(point);
        let starts_at_zero = magnet && self.julia.is_none();
        let mut z = if starts_at_zero { DVec2::ZERO } else { point };
        let mut nearest = if starts_at_zero { 10000.0 } else { z.length_squared() };
        for count in 0..self.iterations {
            z = step(z, c);
            let square = z.length_squared();
            nearest = if square < nearest { square } else { nearest };
            let escaped = match magnet {
                true => square > 10000.0 || (z - DVec2::X).length_squared() < 1.0 / 10000.0,
                false => square > 4.0,
            };
            if escaped {
                return self.outside(count, z);
            }
        }
        self.inside(nearest, z)
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
            if square > 4.0 {
                return self.outside(count, DVec2::new(a, b));
            }
            nearest = if square < nearest { square } else { nearest };
            count += 1;
            if (a, b) == mark {
                let round = count - marked;
                count = self.iterations - (self.iterations - count) % round;
                mark = (f64::NAN, f64::NAN);
            } else if count == next_mark {
                (mark, marked) = ((a, b), count);
                next_mark = next_mark.saturating_mul(2);
            }
        }
        self.inside(nearest, DVec2::new(a, b))
    }

    fn outside(&self, count: u32, z: DVec2) -> f64 {
        let (kind, factor) = self.exterior;
        let count_modulo = |m: f64| f64::from(count % (m as u32).max(1));
        match kind {
            0 => factor,
            1 => f64::from(count) / f64::from(self.iterations),
            6 => z.length() * factor,
            7 => count_modulo(factor) / factor,
            8 => count_modulo(1.0 + factor) / factor,
            _ => component(kind, z) * factor,
        }
    }

    fn inside(&self, nearest: f64, z: DVec2) -> f64 {
        let (kind, factor) = self.interior;
        match kind {
            0 => factor,
            1 => nearest.sqrt() * factor,
            6 => z.x * z.x + z.y * z.y * factor,
            _ => component(kind, z) * factor,
        }
    }
}

/// What types 2 … 5 look at.
fn component(kind: u32, z: DVec2) -> f64 {
    match kind {
        2 => z.x,
        3 => z.y,
        4 => z.x * z.x,
        _ => z.y * z.y,
    }
}
