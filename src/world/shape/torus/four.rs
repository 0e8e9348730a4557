//! Which of four rays come near a torus, and where they meet it.

use super::line::Line;
use super::{ROOM, STEEP, Torus};
use crate::math::Lanes;
use crate::math::roots::first_of_four;
use crate::world::Rays;

/// No numbers.
const NOWHERE: Lanes = Lanes::splat(f64::NAN);

/// The greater of each pair; what is no number stays so.
#[inline(always)]
fn greater(a: Lanes, b: Lanes) -> Lanes {
    a.zip(b, |a, b| if b > a { b } else { a })
}

/// Above zero for those of four polynomials that surely have no root, by their Bernstein coefficients.
#[inline(always)]
fn rootless(b: &[Lanes; 5], noise: Lanes) -> Lanes {
    let (mut least, mut most) = (b[0], b[0]);
    for b in &b[1..] {
        least = least.zip(*b, |a, b| if b < a { b } else { a });
        most = greater(most, *b);
    }
    greater(least - noise, -(most + noise))
}

impl Torus {
    /// The bits of the rays that may meet it before their ends: those that touch both the sphere and the slab around,
    /// unless signs tell that they pass the tube. And where these meet it first, with the bits of
    /// [`Shape::nearest`](crate::world::shape::Shape::nearest); no number where that takes a closer look.
    #[inline(always)]
    pub(in crate::world::shape) fn near_of_four(&self, rays: &Rays, ends: Lanes) -> (u32, Lanes) {
        let Rays { mut origin, direction } = *rays;
        let square_speed = Lanes::dot(&direction, &direction);
        let closest = -Lanes::dot(&origin, &direction) / square_speed;
        for axis in 0..3 {
            origin[axis] = direction[axis].mul_add(closest, origin[axis]);
        }
        let radius = (self.major + self.minor) * ROOM;
        let square = -Lanes::dot(&origin, &origin) + radius * radius;
        let height = self.minor * ROOM;
        let (y, rise) = (origin[1], direction[1]);
        let above = y.abs() - height;
        let aside = above * above * square_speed - rise * rise * square * ROOM;
        let aside = aside.where_positive(above, Lanes::splat(-1.0));
        let behind = closest - ends;
        let behind =
            (behind * behind * square_speed - radius * radius).where_positive(behind, Lanes::splat(-1.0));
        // What is no number is near.
        let far = greater(greater(-square, aside), behind);
        if far.bits(|far| far > 0.0) == 15 {
            return (0, NOWHERE);
        }
        // As `stretches` has it for one ray.
        let speed = square_speed.sqrt();
        let half = square.sqrt() / speed;
        let per = Lanes::splat(1.0) / rise;
        let (one, other) = ((-y - height) * per, (-y + height) * per);
        let low = one.zip(other, f64::min).zip(half, |low, half| if low > -half { low } else { -half });
        let high = one.zip(other, f64::max).zip(half, |high, half| if high < half { high } else { half });
        let hole = self.major - self.minor - (ROOM - 1.0) * (self.major + self.minor);
        let along = origin[0] * direction[0] + origin[2] * direction[2];
        let steep = direction[0] * direction[0] + direction[2] * direction[2];
        let round = origin[0] * origin[0] + origin[2] * origin[2];
        let chord = (along * along - steep * (round - hole * hole))
            .map(|chord| if hole > 0.0 { chord } else { -1.0 });
        let wide = chord.sqrt();
        let before = high.zip((-along - wide) / steep, |high, end| if end < high { end } else { high });
        let after = low.zip((wide - along) / steep, |low, end| if end > low { end } else { low });
        let before = before.where_positive(chord, high);
        let line = Line::new(self, origin, direction, Lanes::splat(self.power()));
        let reach = |low: Lanes, high: Lanes| greater(low.abs(), high.abs());
        let (first, second) = (
            line.bernstein(low, before, reach(low, before)),
            line.bernstein(after, high, reach(after, high)),
        );
        let first_missed = greater(rootless(&first.0, first.1), low - before);
        let second_missed = greater(rootless(&second.0, second.1), after - high);
        let second_missed = second_missed.where_positive(chord, Lanes::splat(1.0));
        let missed = first_missed.zip(second_missed, |a, b| if a > 0.0 && b > 0.0 { 1.0 } else { -1.0 });
        let missed = far.zip(missed, |far, missed| if far > 0.0 { 1.0 } else { missed });
        let near = 15 & !missed.bits(|missed| missed > 0.0);
        if near == 0 || self.major < self.minor {
            return (near, NOWHERE);
        }
        // The first of both stretches in which there may be a root.
        let mut b = first.0;
        for (b, second) in b.iter_mut().zip(second.0) {
            *b = second.where_positive(first_missed, *b);
        }
        let noise = second.1.where_positive(first_missed, first.1);
        let (low, high) =
            (after.where_positive(first_missed, low), high.where_positive(first_missed, before));
        let t = first_of_four(
            &b,
            noise,
            [low, high],
            #[inline(always)]
            |t| line.value(t),
        );
        // What is behind the start, or where a ray grazes, is looked at closer.
        let t = self.polish_four(&Rays { origin, direction }, speed, t) + closest;
        let ahead = t.map(|t| if t > 0.0 && t < f64::INFINITY { t } else { f64::NAN });
        (near, NOWHERE.where_positive(missed, ahead))
    }

    /// As [`polish`](Self::polish) of a torus without an inner sheet; no number where it has more to do.
    #[inline(always)]
    fn polish_four(&self, Rays { origin, direction }: &Rays, speed: Lanes, t: Lanes) -> Lanes {
        let [x, y, z] =
            [origin[0] + t * direction[0], origin[1] + t * direction[1], origin[2] + t * direction[2]];
        let scale = Lanes::splat(self.major) / (x * x + z * z).sqrt();
        let from = [x - x * scale, y, z - z * scale];
        let distance = Lanes::dot(&from, &from).sqrt();
        let slope = Lanes::dot(&from, direction) / distance;
        let step = (distance - self.minor) / slope;
        let steep = slope.abs().zip(speed * STEEP, |slope, least| if slope > least { 1.0 } else { 0.0 });
        let most = STEEP.powi(4) * self.minor.min(self.major - self.minor);
        let polished = (t - step).zip(step.abs() * speed, |t, step| if step < most { t } else { f64::NAN });
        polished.where_positive(steep, NOWHERE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;
    use crate::math::dice::numbers;
    use crate::world::shape::Shape;
    use crate::world::{Range, Ray};

    #[test]
    fn every_ray_that_meets_the_torus_is_near() {
        let mut number = numbers(11);
        let torus = Torus { major: 0.75, minor: 0.25 };
        let (mut met, mut far, mut told) = (0, 0, 0);
        for _ in 0..20_000 {
            let mut point = || DVec3::new(number(), number(), number());
            let ray = Ray::new(3.0 * point(), point());
            let end = 4.0 * number().abs();
            let [origin, direction] = [ray.origin, ray.direction].map(|v| v.to_array().map(Lanes::splat));
            let (near, found) =
                torus.near_of_four(&Rays { origin, direction }, Lanes([end, f64::INFINITY, end, end]));
            for (lane, max) in [(0, end), (1, f64::INFINITY)] {
                let nearest = torus.nearest(&ray, Range { min: 0.0, max });
                assert!(nearest.is_none() || near >> lane & 1 == 1, "{ray:?} {max}");
                met += u32::from(nearest.is_some());
                far += 1 - (near >> lane & 1);
                let found = found.0[lane];
                if !found.is_nan() {
                    let alone = nearest.map_or(f64::INFINITY, |crossing| crossing.t);
                    assert!(near >> lane & 1 == 1 && (found == alone || found >= max), "{ray:?} {max}");
                    told += u32::from(nearest.is_some());
                }
            }
        }
        assert!(met > 3000 && far > 10_000 && told > met / 2, "{met} {far} {told}");
    }
}
