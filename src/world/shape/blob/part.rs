//! The parts of a blob and their fields.

use super::super::stretch::Stretch;
use crate::math::roots::with_discriminant;
use crate::math::{Bounds, DAffine3, DMat3, DVec3, Lanes, Transform};
use crate::world::{Ray, Rays};

/// One ball, half-ball or tube around which a field is.
#[derive(Clone, Debug)]
pub struct Part {
    /// To the space in which the field ends at distance 1 from the middle.
    inverse: DAffine3,
    /// The distance is that from the z axis instead of the origin.
    tube: bool,
    /// Where it is cut off along z; the ends belong to the tube.
    ends: [f64; 2],
    /// That space is reached without turning, by the same scale along all axes.
    is_even: bool,
    pub(super) strength: f64,
    pub(super) texture: u32,
    /// The box around the ball, or both balls of a tube.
    pub(super) bounds: Bounds,
}

impl Part {
    /// A ball of radius 1 about the origin, put in place by `transform`.
    pub fn ball(transform: &Transform, strength: f64, texture: u32) -> Self {
        let (inverse, bounds) = (transform.inverse, around_ball(transform));
        let is_even = inverse.matrix3 == DMat3::from_diagonal(DVec3::splat(inverse.matrix3.x_axis.x));
        Self { inverse, tube: false, ends: WHOLE, is_even, strength, texture, bounds }
    }

    /// A tube of radius 1 about the z axis from 0 to `length` with a half-ball at each end.
    pub fn capsule(transform: &Transform, length: f64, strength: f64, texture: u32) -> [Self; 3] {
        let low = Self::ball(transform, strength, texture);
        let high = Self::ball(&Transform::translate(DVec3::Z * length).then(transform), strength, texture);
        let bounds = low.bounds.union(high.bounds);
        let tube = Self { tube: true, ends: [0.0, length], bounds, ..low.clone() };
        let half = |ball: Self, low: f64, high: f64| Self { ends: [low, high], ..ball };
        [tube, half(low, f64::NEG_INFINITY, 0.0), half(high, 0.0, f64::INFINITY)]
    }

    /// The scale and the way to the space of a ball that is reached without turning; `None` for other parts.
    pub(super) fn even_ball(&self) -> Option<(f64, DVec3)> {
        let is_ball = self.is_even && !self.tube && self.ends == WHOLE;
        is_ball.then_some((self.inverse.matrix3.x_axis.x, self.inverse.translation))
    }

    /// Strength at a point, and the gradient.
    #[inline(always)]
    pub(super) fn field(&self, point: DVec3) -> (f64, DVec3) {
        let scale = self.inverse.matrix3.x_axis.x;
        let p = match self.is_even {
            true => point * scale + self.inverse.translation,
            false => self.inverse.transform_point3(point),
        };
        let from = if self.tube { p.with_z(0.0) } else { p };
        let rest = 1.0 - from.length_squared();
        let [low, high] = self.ends;
        let within = if self.tube { low <= p.z && p.z <= high } else { low < p.z && p.z < high };
        if rest <= 0.0 || !within {
            return (0.0, DVec3::ZERO);
        }
        let slope = -4.0 * self.strength * rest * from;
        let slope = if self.is_even { slope * scale } else { self.inverse.matrix3.transpose() * slope };
        (self.strength * rest * rest, slope)
    }

    /// Calls back with what [`Part::meet`] finds for each of those of four rays that `asked` gives the bits of, to the
    /// last bit.
    #[inline(always)]
    pub(super) fn meet_of_four(&self, rays: &Rays, asked: u32, mut found: impl FnMut(usize, Span)) {
        let axes = if self.tube { 2 } else { 3 };
        let (mut f, mut e) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        let DAffine3 { matrix3: m, translation } = self.inverse;
        for axis in 0..axes {
            let turned = |[x, y, z]: &[Lanes; 3]| match self.is_even {
                true => [*x, *y, *z][axis] * m.x_axis.x,
                false => *x * m.x_axis[axis] + *y * m.y_axis[axis] + *z * m.z_axis[axis],
            };
            f[axis] = turned(&rays.origin) + translation[axis];
            e[axis] = turned(&rays.direction);
        }
        let (a, b, c) = (Lanes::dot(&e, &e), Lanes::dot(&f, &e), Lanes::dot(&f, &f));
        let aside = a * (c - 1.0) - b * b - a * c * CLEAR;
        let mut near = asked & !aside.bits(|aside| aside > 0.0);
        if near == 0 {
            return;
        }
        let is_whole = self.ends == WHOLE;
        let along = b / a;
        for axis in 0..axes {
            f[axis] = f[axis] - along * e[axis];
        }
        let rest = Lanes::splat(1.0) - Lanes::dot(&f, &f);
        let q = -(b + (a * rest).sqrt().zip(b, f64::copysign));
        let (one, other) = (q / a, (c - 1.0) / q);
        let (enter, leave) =
            (one.lesser(other), other.zip(one, |other, one| if one < other { other } else { one }));
        let peak = rest * self.strength * rest;
        while near != 0 {
            let lane = near.trailing_zeros() as usize % Lanes::COUNT;
            near &= near - 1;
            if !is_whole {
                if let Some(span) = self.meet(&rays.ray(lane)) {
                    found(lane, span);
                }
                continue;
            }
            let (enter, leave) = (enter.0[lane], leave.0[lane]);
            if enter < leave && leave.is_finite() && enter.is_finite() {
                let square = [c.0[lane], b.0[lane], a.0[lane]];
                found(
                    lane,
                    Span { enter, leave, square, strength: self.strength, peak: peak.0[lane].max(0.0) },
                );
            }
        }
    }

    /// Where a ray is in the field, and how its distance from the middle, squared, starts and grows.
    #[inline(always)]
    pub(super) fn meet(&self, ray: &Ray) -> Option<Span> {
        let (o, d) = if self.is_even {
            let scale = self.inverse.matrix3.x_axis.x;
            (ray.origin * scale + self.inverse.translation, ray.direction * scale)
        } else {
            (self.inverse.transform_point3(ray.origin), self.inverse.transform_vector3(ray.direction))
        };
        let (f, e) = if self.tube { (o.with_z(0.0), d.with_z(0.0)) } else { (o, d) };
        let (a, b, c) = (e.length_squared(), f.dot(e), f.length_squared());
        if a * (c - 1.0) - b * b > CLEAR * a * c {
            return None;
        }
        let (mut enter, mut leave, mut rest) = (f64::NEG_INFINITY, f64::INFINITY, 1.0 - c);
        if a != 0.0 {
            rest = 1.0 - (f - (b / a) * e).length_squared();
            [enter, leave] = with_discriminant(a, b, c - 1.0, a * rest)?;
        } else if c >= 1.0 {
            return None;
        }
        let [low, high] = self.ends;
        if low > f64::NEG_INFINITY || high < f64::INFINITY {
            let cut = Stretch::slab((low, 0), (high, 0), o.z, d.z)?;
            (enter, leave) = (enter.max(cut.enter.t), leave.min(cut.leave.t));
        }
        (enter < leave && leave.is_finite() && enter.is_finite()).then_some(Span {
            enter,
            leave,
            square: [c, b, a],
            strength: self.strength,
            peak: (self.strength * rest * rest).max(0.0),
        })
    }
}

/// The ends of what is not cut off.
const WHOLE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// The share of the squared distance by which a ray must pass a field, far more than it is rounded by.
pub(super) const CLEAR: f64 = 1e-12;

fn around_ball(transform: &Transform) -> Bounds {
    let m = transform.forward.matrix3.transpose();
    let half = DVec3::new(m.x_axis.length(), m.y_axis.length(), m.z_axis.length()) * (1.0 + 1e-12);
    let center = transform.forward.translation;
    Bounds { min: center - half, max: center + half }
}

/// The stretch of a ray in a part's field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    pub(super) enter: f64,
    pub(super) leave: f64,
    /// c, b, a of the squared distance a t² + 2 b t + c.
    pub(super) square: [f64; 3],
    pub(super) strength: f64,
    /// The field is nowhere more.
    pub(super) peak: f64,
}

impl Span {
    /// Adds the Bernstein coefficients of the field between two distances within the span: the squares of those of
    /// what is left of the squared distance to the border.
    #[inline(always)]
    pub(super) fn add_between(&self, from: f64, to: f64, sums: &mut [f64; 5]) {
        let [c, b, a] = self.square;
        let p = 1.0 - (c + from * (2.0 * b + from * a));
        let q = 1.0 - (c + b * (from + to) + a * from * to);
        let r = 1.0 - (c + to * (2.0 * b + to * a));
        let strength = self.strength;
        sums[0] += strength * (p * p);
        sums[1] += strength * (p * q);
        sums[2] += strength * ((p * r + 2.0 * q * q) / 3.0);
        sums[3] += strength * (q * r);
        sums[4] += strength * (r * r);
    }

    /// What the field's terms are made of is nowhere more within `reach` of the ray's start, so the field is rounded by a
    /// share of it.
    #[inline(always)]
    pub(super) fn size(&self, reach: f64) -> f64 {
        let [c, b, a] = self.square;
        self.strength.abs() * (1.0 + c + reach * (2.0 * b.abs() + reach * a))
    }

    /// Where the field is strongest, if that is within the span.
    #[inline(always)]
    pub(super) fn middle(&self) -> f64 {
        let [_, b, a] = self.square;
        let middle = -b / a;
        if self.enter <= middle && middle <= self.leave { middle } else { f64::INFINITY }
    }

    /// Adds the field as a polynomial in the distance from `start`.
    #[inline(always)]
    pub(super) fn add(&self, start: f64, quartic: &mut [f64; 5]) {
        let [c, b, a] = self.square;
        let (e, f, g) = (1.0 - (c + start * (2.0 * b + start * a)), -2.0 * (b + a * start), -a);
        let strength = self.strength;
        quartic[0] += strength * (e * e);
        quartic[1] += strength * (2.0 * e * f);
        quartic[2] += strength * (f * f + 2.0 * e * g);
        quartic[3] += strength * (2.0 * f * g);
        quartic[4] += strength * (g * g);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::world::shape::OWN_TEXTURE;

    #[test]
    fn four_rays_are_met_as_each_alone() {
        let mut number = numbers(7);
        let mut seen = [0; 2];
        for turn in 0..3000 {
            let mut point = || DVec3::new(number(), number(), number());
            let (place, size, turned) =
                (Transform::translate(point()), 0.3 + point().x.abs(), 90.0 * point());
            let shape = match turn % 3 {
                0 => Transform::scale(DVec3::splat(size)),
                1 => Transform::scale(size + point().abs()),
                _ => Transform::scale(DVec3::splat(size)).then(&Transform::rotate(turned)),
            };
            let place = shape.then(&place);
            let mut parts = Part::capsule(&place, size, 1.5, OWN_TEXTURE).to_vec();
            parts.push(Part::ball(&place, -0.5, OWN_TEXTURE));
            let rays = [0; Lanes::COUNT].map(|_| Ray::new(2.0 * point(), point()));
            for part in parts {
                let mut met = [None; Lanes::COUNT];
                part.meet_of_four(&Rays::of(&rays), 15, |lane, span| met[lane] = Some(span));
                for (ray, met) in rays.iter().zip(met) {
                    let alone = part.meet(ray);
                    seen[usize::from(alone.is_some())] += 1;
                    assert_eq!(met, alone, "{ray:?}");
                }
            }
        }
        assert!(seen[0] > 5000 && seen[1] > 5000, "{seen:?}");
    }
}
