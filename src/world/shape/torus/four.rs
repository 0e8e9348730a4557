//! Which of four rays come near a torus.

use super::line::Line;
use super::{ROOM, Torus};
use crate::math::Lanes;
use crate::world::Rays;

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
    /// unless signs tell that they pass the tube.
    #[inline(always)]
    pub(in crate::world::shape) fn near_of_four(&self, rays: &Rays, ends: Lanes) -> u32 {
        let Rays { mut origin, direction } = *rays;
        let square_speed = Lanes::dot(&direction, &direction);
        let closest = -Lanes::dot(&origin, &direction) / square_speed;
        for axis in 0..3 {
            origin[axis] = origin[axis] + closest * direction[axis];
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
        let near = 15 & !far.bits(|far| far > 0.0);
        if near == 0 {
            return 0;
        }
        // As `stretches` has it for one ray.
        let half = (square / square_speed).sqrt();
        let (one, other) = ((-y - height) / rise, (-y + height) / rise);
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
        let (first, second) = (line.bernstein(low, before, half), line.bernstein(after, high, half));
        let first = greater(rootless(&first.0, first.1), low - before);
        let second = greater(rootless(&second.0, second.1), after - high);
        let second = second.where_positive(chord, Lanes::splat(1.0));
        let missed = first.zip(second, |a, b| if a > 0.0 && b > 0.0 { 1.0 } else { -1.0 });
        near & !missed.bits(|missed| missed > 0.0)
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
        let (mut met, mut far) = (0, 0);
        for _ in 0..20_000 {
            let mut point = || DVec3::new(number(), number(), number());
            let ray = Ray::new(3.0 * point(), point());
            let end = 4.0 * number().abs();
            let [origin, direction] = [ray.origin, ray.direction].map(|v| v.to_array().map(Lanes::splat));
            let near = torus.near_of_four(&Rays { origin, direction }, Lanes([end, f64::INFINITY, end, end]));
            for (lane, max) in [(0, end), (1, f64::INFINITY)] {
                let meets = torus.nearest(&ray, Range { min: 0.0, max }).is_some();
                assert!(!meets || near >> lane & 1 == 1, "{ray:?} {max}");
                met += u32::from(meets);
                far += 1 - (near >> lane & 1);
            }
        }
        assert!(met > 3000 && far > 10_000, "{met} {far}");
    }
}
