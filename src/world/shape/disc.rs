//! `disc { center, normal, radius [, hole] }` (docs/spec/primitives.md 3.6).

use super::{Crossing, Shape};
use crate::math::{Bounds, DVec3};
use crate::world::{Range, Ray};

/// A ring in the plane z = 0 around the origin, both rims included. Its inside is the half-space z < 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Outer radius.
    pub radius: f64,
    /// Radius of the hole; 0 for none.
    pub hole: f64,
}

impl Shape for Disc {
    fn bounds(&self) -> Bounds {
        let half = DVec3::new(self.radius.abs(), self.radius.abs(), 0.0);
        Bounds::new(-half, half)
    }

    fn extent(&self) -> Bounds {
        /// What POV-Ray adds on both sides.
        const THICKNESS: f64 = 0.001;
        let half = DVec3::new(self.radius.abs(), self.radius.abs(), THICKNESS);
        Bounds::new(-half, half)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    #[inline]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let t = -ray.origin.z / ray.direction.z;
        if !range.contains(t) {
            return None;
        }
        let square = ray.at(t).truncate().length_squared();
        let rims = self.hole * self.hole..=self.radius * self.radius;
        rims.contains(&square).then(|| Crossing::new(t, 0))
    }

    fn is_flat(&self) -> bool {
        true
    }

    fn inside(&self, point: DVec3) -> bool {
        point.z < 0.0
    }

    fn normal(&self, _point: DVec3, _crossing: &Crossing) -> DVec3 {
        DVec3::Z
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        point.with_z(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::battery;
    use super::*;

    battery! {
        ring: |size| Disc { radius: size, hole: 0.3 * size }, surface;
    }

    #[test]
    fn rims_belong_to_the_ring_and_the_hole_does_not() {
        let ring = Disc { radius: 2.0, hole: 0.5 };
        let hits = |x: f64| ring.occludes(&Ray::new(DVec3::new(x, 0.0, -1.0), DVec3::Z), Range::AHEAD);
        assert_eq!([0.49, 0.5, 2.0, 2.01].map(hits), [false, true, true, false]);
        assert!(!ring.occludes(&Ray::new(DVec3::new(-5.0, 0.0, 0.0), DVec3::X), Range::AHEAD));
    }

    #[test]
    fn the_inside_is_the_half_space_behind_the_normal() {
        let ring = Disc { radius: 2.0, hole: 0.5 };
        assert!(ring.inside(DVec3::new(9.0, 0.0, -0.1)));
        assert!(!ring.inside(DVec3::ZERO));
    }
}
