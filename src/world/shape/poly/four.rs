//! Which of four rays surely miss a polynomial of degree 4 all along.

use super::{Home, Poly};
use crate::math::wide::widest;
use crate::math::{DVec3, Lanes};
use crate::world::Rays;

/// Terms of a polynomial of degree 4, the constant first.
type Terms = [Lanes; COUNT];

/// How many there are.
const COUNT: usize = 5;

/// More than the share of the sum of its terms' sizes that rounding makes of an invariant: its terms are products of
/// up to six coefficients, each known to some 40 units in the last place of the sizes that it was made of.
const NOISE: f64 = 1e-12;

/// Squares of invariants that are smaller may have lost digits.
const TINY: f64 = 1e-250;

impl Home {
    /// The middle and the radius of the ball that rays are parted in, if there is one.
    pub(super) fn ball(&self) -> Option<(DVec3, f64)> {
        match *self {
            Self::Anywhere => None,
            Self::Ball(center, radius) => Some((center, radius)),
            Self::Gate(gate) => Some((0.5 * (gate.min + gate.max), 0.5 * gate.min.distance(gate.max))),
        }
    }
}

impl Poly {
    /// The bits of four rays on whose lines it surely has no zero; of a polynomial of degree 4.
    pub(super) fn missed_of_four(&self, rays: &Rays, (center, radius): (DVec3, f64)) -> u32 {
        widest(
            #[inline(always)]
            || {
                let (mut origin, direction) = (rays.origin, &rays.direction);
                let off = [origin[0] - center.x, origin[1] - center.y, origin[2] - center.z];
                let square_speed = Lanes::dot(direction, direction);
                let closest = -Lanes::dot(&off, direction) / square_speed;
                // The points themselves are rounded by how far away rays start.
                let blur = Lanes::dot(&off, &off).sqrt() / Lanes::splat(radius) + 1.0;
                for axis in 0..3 {
                    origin[axis] = origin[axis] + closest * direction[axis];
                }
                let terms = self.terms(&origin, direction, |c| c);
                let far = [origin[0].abs(), origin[1].abs(), origin[2].abs()];
                let fast = [direction[0].abs(), direction[1].abs(), direction[2].abs()];
                let sizes = self.terms(&far, &fast, f64::abs);
                rootless(&terms, &sizes, blur * NOISE).bits(|sure| sure > 0.0)
            },
        )
    }

    /// The polynomial in the distances along four rays, with a function of its coefficients.
    // Loops over numbers: iterators are not compiled for wide registers with what is around them.
    #[inline(always)]
    fn terms(&self, o: &[Lanes; 3], d: &[Lanes; 3], of: impl Fn(f64) -> f64) -> Terms {
        let mut in_x = [Lanes::ZERO; COUNT];
        for by_y in &*self.coefficients {
            step(&mut in_x, o[0], d[0]);
            if by_y.is_empty() {
                continue;
            }
            let mut in_y = [Lanes::ZERO; COUNT];
            for by_z in by_y {
                step(&mut in_y, o[1], d[1]);
                if by_z.is_empty() {
                    continue;
                }
                let mut in_z = [Lanes::ZERO; COUNT];
                for coefficient in by_z {
                    step(&mut in_z, o[2], d[2]);
                    in_z[0] = in_z[0] + of(*coefficient);
                }
                for i in 0..COUNT {
                    in_y[i] = in_y[i] + in_z[i];
                }
            }
            for i in 0..COUNT {
                in_x[i] = in_x[i] + in_y[i];
            }
        }
        in_x
    }
}

/// Times `origin + direction t`; there is nothing in the last term.
#[inline(always)]
fn step(terms: &mut Terms, origin: Lanes, direction: Lanes) {
    for i in (1..COUNT).rev() {
        terms[i] = terms[i] * origin + terms[i - 1] * direction;
    }
    terms[0] = terms[0] * origin;
}

/// Above zero for those of four polynomials of degree 4 that surely have no real root, given the sizes that their
/// coefficients were made of and what share of these sums of products may be off: the discriminant is above zero, and
/// not both invariants that tell two pairs of complex roots from four real ones are below (E. L. Rees, Graphical
/// discussion of the roots of a quartic equation, Amer. Math. Monthly 29, 1922).
#[inline(always)]
fn rootless(terms: &Terms, sizes: &Terms, noise: Lanes) -> Lanes {
    let [e, d, c, b, a] = *terms;
    let [se, sd, sc, sb, sa] = *sizes;
    // 27 times the discriminant is 4 i³ - j².
    let i = a * e * 12.0 - b * d * 3.0 + c * c;
    let j = (a * e * 72.0 + b * d * 9.0 - c * c * 2.0) * c - (a * d * d + e * b * b) * 27.0;
    let si = sa * se * 12.0 + sb * sd * 3.0 + sc * sc;
    let sj = (sa * se * 72.0 + sb * sd * 9.0 + sc * sc * 2.0) * sc + (sa * sd * sd + se * sb * sb) * 27.0;
    let discriminant = i * i * i * 4.0 - j * j - (si * si * si * 4.0 + sj * sj) * noise - TINY;
    let first = a * c * 8.0 - b * b * 3.0 - (sa * sc * 8.0 + sb * sb * 3.0) * noise;
    let (aa, bb, saa, sbb) = (a * a, b * b, sa * sa, sb * sb);
    let second = aa * (a * e * 64.0 - c * c * 16.0 - b * d * 16.0) + bb * (a * c * 16.0 - bb * 3.0);
    let size = saa * (sa * se * 64.0 + sc * sc * 16.0 + sb * sd * 16.0) + sbb * (sa * sc * 16.0 + sbb * 3.0);
    first.greater(second - size * noise).where_positive(discriminant, discriminant)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::world::shape::Shape;
    use crate::world::{Range, Ray};

    #[test]
    fn rays_that_meet_a_quartic_are_not_said_to_miss_it() {
        // A drop, and one whose terms are all there.
        let mut number = numbers(29);
        let mut tear = [0.0; 35];
        (tear[0], tear[3], tear[25], tear[32]) = (4.0, -4.0, 1.0, 1.0);
        let all: Vec<f64> = (0..35).map(|_| number()).collect();
        let (mut met, mut missed) = (0, 0);
        for coefficients in [&tear[..], &all] {
            let poly = Poly::new(4, coefficients).unwrap();
            let center = DVec3::new(0.5, 0.0, 0.0);
            for turn in 0..20_000 {
                let mut point = || DVec3::new(number(), number(), number());
                let (origin, direction) = (3.0 * point(), point());
                // Some touch the drop, all but.
                let target = if turn % 3 == 0 { DVec3::new(0.75, 0.0, 0.57) } else { point() };
                let direction = if turn % 2 == 0 { target - origin } else { direction };
                let ray = Ray::new(origin, direction);
                let is_missed = poly.missed_of_four(&Rays::of(&[ray; 4]), (center, 1.0));
                let meets =
                    poly.nearest(&ray, Range { min: f64::NEG_INFINITY, max: f64::INFINITY }).is_some();
                assert!(is_missed == 0 || is_missed == 15 && !meets, "{ray:?}");
                (met, missed) = (met + u32::from(meets), missed + u32::from(is_missed == 15));
            }
        }
        assert!(met > 10_000 && missed > 3000, "{met} {missed}");
    }
}
