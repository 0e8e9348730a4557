//! `sphere { center, radius }` (docs/spec/primitives.md 3.1).

use std::f64::consts::{PI, TAU};

use super::stretch::Stretch;
use super::{Crossing, Shape};
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes, roots};
use crate::world::{Range, Ray, Rays};

/// A sphere; a negative radius turns its normals inward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its middle.
    pub center: DVec3,
    /// Its radius; not zero.
    pub radius: f64,
}

/// How much nearer the origin of a line is taken than it is, to be sure that the line misses.
const MISSED: f64 = 1.0 - 1e-12;

impl Sphere {
    /// The discriminant comes from the distance between line and centre, not from the origin's
    /// (Haines, Günther, Akenine-Möller, Ray Tracing Gems 7).
    #[inline(always)]
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        let f = ray.origin - self.center;
        let a = ray.direction.length_squared();
        let b = f.dot(ray.direction);
        let square = self.radius * self.radius;
        let far = f.length_squared();
        // Most lines miss by more than rounding can change.
        if b * b < a * (far * MISSED - square) {
            return None;
        }
        let chord = square - (f - (b / a) * ray.direction).length_squared();
        if chord == 0.0 {
            return Stretch::new(-b / a, 0, -b / a, 0);
        }
        let [enter, leave] = roots::with_discriminant(a, b, far - square, a * chord)?;
        Stretch::new(enter, 0, leave, 0)
    }
}

impl Sphere {
    /// The nearest crossings ahead of four rays, as [`Shape::nearest`] finds them; no number for none.
    #[inline(always)]
    pub(super) fn nearest_of_four(&self, rays: &Rays) -> Option<Lanes> {
        let (center, d) = (self.center.to_array(), &rays.direction);
        let mut f = rays.origin;
        for axis in 0..3 {
            f[axis] = f[axis] - center[axis];
        }
        let (a, b, far) = (Lanes::dot(d, d), Lanes::dot(&f, d), Lanes::dot(&f, &f));
        let square = self.radius * self.radius;
        let reach = b * b - a * (far * MISSED - square);
        if reach.bits(|reach| reach < 0.0) == 15 {
            return None;
        }
        let along = b / a;
        for axis in 0..3 {
            f[axis] = f[axis] - along * d[axis];
        }
        let chord = -Lanes::dot(&f, &f) + square;
        let discriminant = a * chord;
        let q = -(b + discriminant.sqrt().zip(b, f64::copysign));
        let (one, other) = (q / a, (far - square) / q);
        let enter = one.zip(other, |one, other| if one < other { one } else { other });
        let leave = one.zip(other, |one, other| if one < other { other } else { one });
        let mut nearest = enter.where_positive(enter, leave);
        if (chord * q).bits(|product| product == 0.0) != 0 {
            for lane in 0..Lanes::COUNT {
                let tangent = if chord.0[lane] == 0.0 { -along.0[lane] } else { f64::NAN };
                if chord.0[lane] == 0.0 || q.0[lane] == 0.0 {
                    nearest.0[lane] = tangent;
                }
            }
        }
        let nearest = nearest.zip(reach, |nearest, reach| if reach < 0.0 { f64::NAN } else { nearest });
        Some(nearest)
    }

    /// The surface's point next to a computed one, and its unit normal there.
    #[inline(always)]
    pub(super) fn touched(&self, point: DVec3) -> (DVec3, DVec3) {
        let from = (point - self.center).normalize_or_zero();
        (self.center + from * self.radius.abs(), if self.radius < 0.0 { -from } else { from })
    }
}

impl Shape for Sphere {
    fn bounds(&self) -> Bounds {
        let half = DVec3::splat(self.radius.abs());
        Bounds::new(self.center - half, self.center + half)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if let Some(stretch) = self.stretch(ray) {
            stretch.push(range, out);
        }
    }

    #[inline(always)]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.stretch(ray)?.nearest(range)
    }

    fn is_closed(&self) -> bool {
        true
    }

    fn inside(&self, point: DVec3) -> bool {
        (point - self.center).length_squared() < self.radius * self.radius
    }

    fn inside_along(&self, p: &[Band; 3]) -> Band {
        let [x, y, z] = [0, 1, 2].map(|i| (p[i] - self.center[i]).square());
        (x + y + z).less(Band::constant(self.radius * self.radius))
    }

    fn outside(&self, point: DVec3) -> bool {
        (point - self.center).length_squared() > self.radius * self.radius
    }

    fn normal(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        (point - self.center) / self.radius
    }

    fn uv(&self, point: DVec3, _crossing: &Crossing) -> Option<DVec2> {
        Some(spherical_uv(point - self.center))
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        self.touched(point).0
    }
}

/// Longitude from +x towards +z and latitude, both in 0 … 1, of a direction from the centre.
pub(super) fn spherical_uv(from: DVec3) -> DVec2 {
    /// Squared distance from the axis, of a unit vector, below which there is no longitude.
    const POLE: f64 = 1e-10;
    let d = from.normalize_or_zero();
    let square = d.x * d.x + d.z * d.z;
    let around = if square <= POLE { 0.0 } else { (d.x / square.sqrt()).clamp(-1.0, 1.0).acos() / TAU };
    let u = if d.z < 0.0 && square > POLE { 1.0 - around } else { around };
    DVec2::new(u, 0.5 + d.y.clamp(-1.0, 1.0).asin() / PI)
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, Probe, battery, table};
    use super::*;

    battery! {
        unit: |size, at| Sphere { center: at, radius: size };
        turned: |size, at| Sphere { center: at, radius: -size }, inward;
    }

    #[test]
    fn distances_are_exact_to_the_last_bits() {
        battery::oracle(
            &Sphere { center: DVec3::ZERO, radius: 1.0 },
            &[(1.0, [2, 0, 0]), (1.0, [0, 2, 0]), (1.0, [0, 0, 2]), (-1.0, [0, 0, 0])],
            4.0,
        );
    }

    #[test]
    fn a_ray_tangent_to_the_unit_sphere_is_a_double_root() {
        let sphere = Sphere { center: DVec3::ZERO, radius: 1.0 };
        let ray = Ray::new(DVec3::new(-3.0, 1.0, 0.0), DVec3::X);
        let mut found = Vec::new();
        sphere.crossings(&ray, Range::AHEAD, &mut found);
        assert_eq!(found, [Crossing::new(3.0, 0)]);
        assert_eq!(sphere.nearest(&ray, Range::AHEAD), Some(Crossing::new(3.0, 0)));
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &Sphere { center: DVec3::new(1.0, 2.0, 3.0), radius: 2.0 },
            "from <0,2,-10> dir <0.1,0.05,1> | P <1.108132388375671, 2.554066194187835, 1.081323883756706> N <0.054066194187835, 0.277033097093918, -0.959338058121647>
            from <1,2,3> dir <1,1,1> | P <2.154700538379251, 3.154700538379251, 4.154700538379251> N <0.577350269189626, 0.577350269189626, 0.577350269189626>
            from <1,2,5.0002> dir <0,0,-1> | P <1, 2, 5> N <0, 0, 1>
            inside <1,2,4.9999999> | 1
            inside <1,2,5> | 0
            extent | <-1, 0, 1> .. <3, 4, 5>",
        );
        table(
            &Sphere { center: DVec3::ZERO, radius: -1.0 },
            "from <0,0.1,-5> dir <0,0,1> | P <0, 0.1, -0.994987437106619> N <0, -0.1, 0.994987437106619>",
        );
    }

    #[test]
    fn hits_nearer_than_povrays_limit_are_found() {
        // POV-Ray skips the first crossing, nearer than 1e-4, and reports <1, 2, 1>.
        let sphere = Sphere { center: DVec3::new(1.0, 2.0, 3.0), radius: 2.0 };
        let hit = Probe::new(DVec3::new(1.0, 2.0, 5.000_05), -DVec3::Z).hit(&sphere).unwrap();
        assert!(hit.point.abs_diff_eq(DVec3::new(1.0, 2.0, 5.0), 1e-15));
    }

    #[test]
    fn uv_agrees_with_povray() {
        let sphere = Sphere { center: DVec3::new(1.0, 2.0, 3.0), radius: 2.0 };
        battery::uv(&sphere, [1.0, 2.0, -10.0], [0.0, 0.0, 1.0], [0.75, 0.5]);
        battery::uv(&sphere, [1.5, 2.7, -10.0], [0.0, 0.0, 1.0], [0.793, 0.61382]);
        battery::uv(&sphere, [1.5, 1.2, 10.0], [0.0, 0.0, -1.0], [0.20603, 0.36901]);
    }
}
