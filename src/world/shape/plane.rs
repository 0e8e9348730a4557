//! `plane { normal, distance }` (docs/spec/primitives.md 3.3).

use super::stretch::Stretch;
use super::{Crossing, Shape};
use crate::math::{Band, Bounds, DVec3, Lanes};
use crate::world::{Range, Ray, Rays};

/// The half-space `normal · p <= distance`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit normal, pointing out.
    pub normal: DVec3,
    /// Signed distance from the origin.
    pub distance: f64,
}

/// Rounding of a point on the surface, relative to the terms of its height.
const ON_SURFACE: f64 = 4.0 * f64::EPSILON;

impl Plane {
    /// How far `point` is outside, and the size of the terms whose rounding that carries.
    fn height(&self, point: DVec3) -> (f64, f64) {
        let terms = self.normal * point;
        let size = terms.x.abs() + terms.y.abs() + terms.z.abs() + self.distance.abs();
        (terms.x + terms.y + terms.z - self.distance, size)
    }

    /// The crossings of four rays; no number, or not ahead, for none.
    #[inline(always)]
    pub(super) fn nearest_of_four(&self, rays: &Rays) -> Lanes {
        let [x, y, z] = self.normal.to_array();
        let along = |[a, b, c]: &[Lanes; 3]| *a * x + *b * y + *c * z;
        -(along(&rays.origin) - self.distance) / along(&rays.direction)
    }

    /// The half-line inside.
    #[inline(always)]
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let (height, size) = self.height(ray.origin);
        let slope = self.normal.dot(ray.direction);
        if slope == 0.0 {
            return (height <= ON_SURFACE * size).then_some(Stretch::LINE);
        }
        let t = -height / slope;
        if slope < 0.0 {
            Stretch::new(t, 0, f64::INFINITY, 0)
        } else {
            Stretch::new(f64::NEG_INFINITY, 0, t, 0)
        }
    }
}

impl Shape for Plane {
    fn bounds(&self) -> Bounds {
        Bounds::ALL
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    #[inline(always)]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        // A parallel ray divides by zero: neither infinity nor NaN is in any range.
        let t = -self.height(ray.origin).0 / self.normal.dot(ray.direction);
        range.contains(t).then(|| Crossing::new(t, 0))
    }

    fn is_closed(&self) -> bool {
        true
    }

    /// The surface belongs to the inside, also where rounding put a point of it outside.
    fn inside(&self, point: DVec3) -> bool {
        let (height, size) = self.height(point);
        height <= ON_SURFACE * size
    }

    fn inside_along(&self, [x, y, z]: &[Band; 3]) -> Band {
        let n = self.normal;
        // Bands have room for more than what counts as on the surface.
        (*x * n.x + *y * n.y + *z * n.z - self.distance).less_equal(Band::constant(0.0))
    }

    fn normal(&self, _point: DVec3, _crossing: &Crossing) -> DVec3 {
        self.normal
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        point - self.height(point).0 * self.normal
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    battery! {
        slanted: |size, at| {
            let normal = DVec3::new(1.0, 2.0, -0.5).normalize();
            Plane { normal, distance: normal.dot(at) + 0.25 * size }
        };
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &Plane { normal: DVec3::Y, distance: 3.0 },
            "from <0,10,0> dir <0.3,-1,0.2> | P <2.1, 3, 1.4> N <0, 1, 0>
            from <0,-10,0> dir <0,1,0> | P <0, 3, 0> N <0, 1, 0>
            from <0,10,0> dir <1,0,0> | miss
            from <0,10,0> dir <1,-2e-6,0> | P <3500000, 3, 0> N <0, 1, 0>
            inside <0,3,0> | 1
            inside <0,3.00000001,0> | 0
            inside <0,2.9,0> | 1",
        );
    }

    #[test]
    fn the_ground_reaches_beyond_povrays_greatest_distance() {
        // POV-Ray stops at 1e7, and takes rays flatter than 1e-10 for parallel.
        let ground = Plane { normal: DVec3::Y, distance: 0.0 };
        let ray = Ray::new(DVec3::Y, DVec3::new(1.0, -1e-12, 0.0));
        assert_eq!(ground.nearest(&ray, Range::AHEAD).map(|hit| hit.t), Some(1e12));
    }
}
