//! Which of four rays surely miss a polynomial of degree 4 all along, and where the others meet it.

use super::{Home, LEAP, Poly, ROUGH};
use crate::math::roots::first_of_four;
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

/// No numbers.
const NOWHERE: Lanes = Lanes::splat(f64::NAN);

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
    /// Of a polynomial of degree 4, the bits of four rays on whose lines it surely has no zero. And where the others meet
    /// it ahead, with the bits of [`Shape::nearest`](crate::world::shape::Shape::nearest); no number where that takes a
    /// closer look.
    pub(super) fn first_of_four(&self, rays: &Rays, (center, radius): (DVec3, f64)) -> (u32, Lanes) {
        widest(
            #[inline(always)]
            || {
                let Rays { mut origin, direction } = *rays;
                let off = [origin[0] - center.x, origin[1] - center.y, origin[2] - center.z];
                let square_speed = Lanes::dot(&direction, &direction);
                let closest = -Lanes::dot(&off, &direction) / square_speed;
                // The points themselves are rounded by how far away rays start.
                let blur = Lanes::dot(&off, &off).sqrt() / Lanes::splat(radius) + 1.0;
                for axis in 0..3 {
                    origin[axis] = direction[axis].mul_add(closest, origin[axis]);
                }
                let terms = self.terms(&origin, &direction, |c| c);
                let far = [origin[0].abs(), origin[1].abs(), origin[2].abs()];
                let fast = [direction[0].abs(), direction[1].abs(), direction[2].abs()];
                let sizes = self.terms(&far, &fast, f64::abs);
                let missed = rootless(&terms, &sizes, blur * NOISE).bits(|sure| sure > 0.0);
                if missed == 15 {
                    return (15, NOWHERE);
                }
                let off = [origin[0] - center.x, origin[1] - center.y, origin[2] - center.z];
                let half = ((-Lanes::dot(&off, &off) + radius * radius) / square_speed).sqrt();
                let moved = Rays { origin, direction };
                let t = self.polish_four(&moved, &terms, first_in_ball(&terms, half)) + closest;
                (missed, t.where_positive(self.at_gate(&moved, closest), NOWHERE))
            },
        )
    }

    /// As [`polish`](Self::polish); no number where the rounding of terms counts.
    #[inline(always)]
    fn polish_four(&self, Rays { origin, direction }: &Rays, terms: &Terms, t: Lanes) -> Lanes {
        let point =
            [origin[0] + t * direction[0], origin[1] + t * direction[1], origin[2] + t * direction[2]];
        let (value, gradient) = self.value_of_four(&point);
        let slope = Lanes::dot(&gradient, direction);
        let (step, far) = (value / slope, t.abs());
        let small = step.abs().zip(far * LEAP, |step, most| if step <= most { 1.0 } else { 0.0 });
        let t = (t - step).where_positive(small, t);
        let mut size = Lanes::ZERO;
        for i in (0..COUNT).rev() {
            size = size * far + terms[i].abs();
        }
        let exact = size.zip((slope * t).abs() * ROUGH, |size, most| if size <= most { 1.0 } else { 0.0 });
        t.where_positive(exact, NOWHERE)
    }

    /// Values and gradients.
    #[inline(always)]
    fn value_of_four(&self, p: &[Lanes; 3]) -> (Lanes, [Lanes; 3]) {
        let (mut value, mut slope) = (Lanes::ZERO, [Lanes::ZERO; 3]);
        for by_y in &*self.coefficients {
            let (mut in_y, mut slope_y, mut slope_yz) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
            for by_z in by_y {
                let (mut in_z, mut slope_z) = (Lanes::ZERO, Lanes::ZERO);
                for c in by_z {
                    slope_z = slope_z * p[2] + in_z;
                    in_z = in_z * p[2] + *c;
                }
                slope_y = slope_y * p[1] + in_y;
                slope_yz = slope_yz * p[1] + slope_z;
                in_y = in_y * p[1] + in_z;
            }
            slope = [slope[0] * p[0] + value, slope[1] * p[0] + slope_y, slope[2] * p[0] + slope_yz];
            value = value * p[0] + in_y;
        }
        (value, slope)
    }

    /// Above zero for the rays that start in its gate or surely come to it; they start at their closest approach, `closest`
    /// from where they are asked from.
    #[inline(always)]
    fn at_gate(&self, Rays { origin, direction }: &Rays, closest: Lanes) -> Lanes {
        let Home::Gate(gate) = self.home else { return Lanes::splat(1.0) };
        let (min, max) = (gate.min.to_array(), gate.max.to_array());
        let (mut enter, mut leave) = (Lanes::splat(f64::NEG_INFINITY), Lanes::splat(f64::INFINITY));
        for axis in 0..3 {
            let low = (-origin[axis] + min[axis]) / direction[axis];
            let high = (-origin[axis] + max[axis]) / direction[axis];
            enter = low.lesser(high).greater(enter);
            leave = low.greater(high).lesser(leave);
        }
        let met = leave.zip(enter, |leave, enter| if leave >= enter { 1.0 } else { 0.0 });
        leave.zip(-closest, |leave, start| if leave >= start { 1.0 } else { 0.0 }) * met
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

/// The first roots of four polynomials from minus infinity on that are within a distance of 0; no number where that takes
/// a closer look.
#[inline(always)]
fn first_in_ball(terms: &Terms, half: Lanes) -> Lanes {
    // As `Along::is_void` has it: Bernstein's coefficients of what is before the ball have one sign.
    let (mut before, mut sizes) = (*terms, *terms);
    for i in 0..COUNT {
        (before[i], sizes[i]) = (if i % 2 == 0 { terms[i] } else { -terms[i] }, terms[i].abs());
    }
    for from in 0..COUNT - 1 {
        for i in (from..COUNT - 1).rev() {
            before[i] = before[i] + half * before[i + 1];
            sizes[i] = sizes[i] + half * sizes[i + 1];
        }
    }
    let (mut above, mut below) = (Lanes::splat(f64::INFINITY), Lanes::splat(f64::INFINITY));
    for i in 0..COUNT {
        let noise = sizes[i] * (8.0 * COUNT as f64 * f64::EPSILON);
        (above, below) = ((before[i] - noise).lesser(above), (-before[i] - noise).lesser(below));
    }
    // Within it: as `roots::each_root` makes Bernstein's coefficients.
    let (low, width) = (-half, half + half);
    let mut b = *terms;
    for from in 0..COUNT - 1 {
        for i in (from..COUNT - 1).rev() {
            b[i] = b[i] + low * b[i + 1];
        }
    }
    let (mut power, mut binomial) = (Lanes::splat(1.0), 1.0);
    for (i, b) in b.iter_mut().enumerate() {
        *b = *b * (power / binomial);
        power = power * width;
        binomial = binomial * (COUNT - 1 - i) as f64 / (i + 1) as f64;
    }
    for from in 1..COUNT {
        for i in (from..COUNT).rev() {
            b[i] = b[i] + b[i - 1];
        }
    }
    let reach = half + width;
    let mut size = Lanes::ZERO;
    for i in (0..COUNT).rev() {
        size = size * reach + terms[i].abs();
    }
    let root = first_of_four(
        &b,
        size * (16.0 * (COUNT - 1) as f64 * f64::EPSILON),
        [low, half],
        #[inline(always)]
        |t| {
            let (mut value, mut slope) = (Lanes::ZERO, Lanes::ZERO);
            for i in (0..COUNT).rev() {
                slope = slope * t + value;
                value = value * t + terms[i];
            }
            (value, slope)
        },
    );
    let lone = above.greater(below).zip(terms[COUNT - 1], |sure, lead| if lead == 0.0 { 0.0 } else { sure });
    root.where_positive(lone, NOWHERE)
        .zip(half, |root, half| if root < half + half { root } else { f64::NAN })
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
        let (mut met, mut missed, mut told) = (0, 0, 0);
        for coefficients in [&tear[..], &all] {
            let center = DVec3::new(0.5, 0.0, 0.0);
            let poly = Poly::new(4, coefficients).unwrap();
            let poly = Poly { home: Home::Ball(center, 1.0), ..poly };
            for turn in 0..20_000 {
                let mut point = || DVec3::new(number(), number(), number());
                let (origin, direction) = (3.0 * point(), point());
                // Some touch the drop, all but.
                let target = if turn % 3 == 0 { DVec3::new(0.75, 0.0, 0.57) } else { point() };
                let direction = if turn % 2 == 0 { target - origin } else { direction };
                let ray = Ray::new(origin, direction);
                let (is_missed, first) = poly.first_of_four(&Rays::of(&[ray; 4]), (center, 1.0));
                let meets =
                    poly.nearest(&ray, Range { min: f64::NEG_INFINITY, max: f64::INFINITY }).is_some();
                assert!(is_missed == 0 || is_missed == 15 && !meets, "{ray:?}");
                let first = first.0[turn % 4];
                if is_missed == 0 && first > 0.0 {
                    let alone = poly.nearest(&ray, Range::AHEAD).map(|crossing| crossing.t);
                    assert_eq!(Some(first), alone, "{ray:?}");
                    told += 1;
                }
                (met, missed) = (met + u32::from(meets), missed + u32::from(is_missed == 15));
            }
        }
        assert!(met > 10_000 && missed > 3000 && told > 3000, "{met} {missed} {told}");
    }
}
