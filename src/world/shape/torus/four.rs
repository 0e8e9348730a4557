//! Which of four rays come near a torus.

use super::{ROOM, Torus};
use crate::math::Lanes;
use crate::world::Rays;

impl Torus {
    /// The bits of the rays that may meet it before their ends: those that touch both the sphere and the slab around.
    #[inline(always)]
    pub(in crate::world::shape) fn near_of_four(&self, rays: &Rays, ends: Lanes) -> u32 {
        let Rays { mut origin, direction } = *rays;
        let speed = Lanes::dot(&direction, &direction);
        let closest = -Lanes::dot(&origin, &direction) / speed;
        for axis in 0..3 {
            origin[axis] = origin[axis] + closest * direction[axis];
        }
        let radius = (self.major + self.minor) * ROOM;
        let square = -Lanes::dot(&origin, &origin) + radius * radius;
        let above = origin[1].abs() - self.minor * ROOM;
        let rise = direction[1] * direction[1] * square * ROOM;
        let aside = (above * above * speed - rise).where_positive(above, Lanes::splat(-1.0));
        let behind = closest - ends;
        let behind = (behind * behind * speed - radius * radius).where_positive(behind, Lanes::splat(-1.0));
        // What is no number is near.
        let far = square.bits(|square| square < 0.0) | aside.bits(|aside| aside > 0.0);
        15 & !(far | behind.bits(|behind| behind > 0.0))
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
