//! Any primitive, called without a virtual call where it is of a common kind.

use super::r#box::Cuboid;
use std::sync::Arc;

use super::cone::Cone;
use super::cylinder::Cylinder;
use super::disc::Disc;
use super::mesh::Mesh;
use super::plane::Plane;
use super::quadric::Quadric;
use super::sphere::Sphere;
use super::stretch::Stretch;
use super::torus::Torus;
use super::triangle::Triangle;
use super::{Crossing, Remark, Shape};
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes};
use crate::world::{Range, Ray, Rays};

/// A primitive in its own space; copies share what is big.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the variants are named after what they hold")]
pub enum Primitive {
    Sphere(Sphere),
    Box(Cuboid),
    Plane(Plane),
    Disc(Disc),
    Cylinder(Cylinder),
    Cone(Cone),
    Torus(Torus),
    Triangle(Box<Triangle>),
    Mesh(Arc<Mesh>),
    Quadric(Arc<Quadric>),
    /// The rare kinds.
    Other(Arc<dyn Shape>),
}

impl Primitive {
    /// Whether [`Primitive::convex`] knows it.
    pub fn is_convex(&self) -> bool {
        match self {
            Self::Sphere(_) | Self::Box(_) | Self::Plane(_) => true,
            Self::Cylinder(cylinder) => !cylinder.open,
            Self::Cone(cone) => cone.is_convex(),
            Self::Quadric(quadric) => quadric.is_convex(),
            _ => false,
        }
    }

    /// Whether it takes no longer to ask it than to look at its box.
    #[inline]
    pub fn is_soon_asked(&self) -> bool {
        !matches!(self, Self::Mesh(_) | Self::Quadric(_) | Self::Other(_))
    }

    /// Whether textures are looked up at its crossings and its normals are those of the surface.
    #[inline]
    pub fn is_simple(&self) -> bool {
        !matches!(self, Self::Triangle(_) | Self::Mesh(_) | Self::Other(_))
    }

    /// The point of a surface that is simple next to a computed one, and its unit normal there.
    #[inline]
    pub fn touched(&self, point: DVec3, crossing: &Crossing) -> (DVec3, DVec3) {
        if let Some(touched) = self.soon_touched(point, crossing) {
            return touched;
        }
        if let Self::Torus(torus) = self {
            return torus.touched(point);
        }
        let on = self.reproject(point, crossing);
        (on, self.normal(on, crossing).normalize_or_zero())
    }

    /// The same for spheres, boxes and planes. What these find need not go through memory.
    #[inline(always)]
    pub fn soon_touched(&self, point: DVec3, crossing: &Crossing) -> Option<(DVec3, DVec3)> {
        match self {
            Self::Sphere(sphere) => Some(sphere.touched(point)),
            Self::Box(cuboid) => Some((cuboid.reproject(point, crossing), cuboid.normal(point, crossing))),
            Self::Plane(plane) => Some((plane.reproject(point, crossing), plane.normal)),
            _ => None,
        }
    }

    /// As [`Primitive::convex`], but that the parts of the ends may be [`UNSAID`](super::stretch::UNSAID),
    /// and ends that lie on an edge less exact.
    #[inline(always)]
    pub fn span(&self, ray: &Ray) -> Option<Stretch> {
        match self {
            Self::Box(cuboid) => cuboid.span(ray),
            _ => self.convex(ray)?,
        }
    }

    /// The nearest crossings ahead of four rays and the numbers of their parts, as [`Shape::nearest`] finds them,
    /// where it is quicker to ask for four than for one: no number for none, and the outer `None` where there is
    /// none at all. Crossings beyond `ends` need not be found.
    #[inline(always)]
    pub fn nearest_of_four(&self, rays: &Rays, ends: Lanes) -> Option<[Lanes; 2]> {
        match self {
            Self::Sphere(sphere) => Some([sphere.nearest_of_four(rays)?, Lanes::ZERO]),
            Self::Box(cuboid) => cuboid.nearest_of_four(rays, ends),
            Self::Plane(plane) => Some([plane.nearest_of_four(rays), Lanes::ZERO]),
            _ => None,
        }
    }

    /// The bits of those of four rays that may meet it ahead, before `ends`: all where [`Self::nearest_of_four`] doesn't
    /// know it.
    #[inline(always)]
    pub fn may_stop_four(&self, rays: &Rays, ends: Lanes) -> u32 {
        let distance = match self {
            Self::Sphere(sphere) => sphere.nearest_of_four(rays),
            Self::Plane(plane) => Some(plane.nearest_of_four(rays)),
            Self::Box(cuboid) => return cuboid.near_of_four(rays),
            _ => return !0,
        };
        let Some(distance) = distance else { return 0 };
        distance.bits(|t| t > 0.0) & (ends - distance).bits(|room| room > 0.0)
    }

    /// The bits of those of four rays that may meet it before `ends`, where that is told quickly and better than by its
    /// box; and where they meet it first, on part 0, as far as that is known: no number elsewhere.
    #[inline(always)]
    pub fn near_of_four(&self, rays: impl FnOnce() -> Rays, ends: Lanes) -> Option<(u32, Lanes)> {
        match self {
            Self::Torus(torus) => Some(torus.near_of_four(&rays(), ends)),
            Self::Other(shape) => {
                shape.gate().map(|gate| (gate.near_of_four(&rays()), Lanes::splat(f64::NAN)))
            }
            _ => None,
        }
    }

    /// See [`Shape::nearest_together`].
    pub fn nearest_together(
        &self,
        rays: &Rays,
        asked: u32,
        ends: &Lanes,
        found: &mut [Option<Crossing>; Lanes::COUNT],
    ) -> bool {
        match self {
            Self::Other(shape) => shape.nearest_together(rays, asked, ends, found),
            _ => false,
        }
    }

    /// Whether [`Primitive::nearest_of_four`] knows it.
    #[inline(always)]
    pub fn takes_four(&self) -> bool {
        matches!(self, Self::Sphere(_) | Self::Box(_) | Self::Plane(_))
    }

    /// Where a line is inside, if the shape is convex and all of its border is surface; the inner
    /// `None` where it is outside all along. Compiled together with what asks: the ray it makes need not be stored then.
    #[inline(always)]
    pub fn convex(&self, ray: &Ray) -> Option<Option<Stretch>> {
        match self {
            Self::Sphere(sphere) => Some(sphere.stretch(ray)),
            Self::Box(cuboid) => Some(cuboid.stretch(&own(ray))),
            Self::Plane(plane) => Some(plane.stretch(ray)),
            Self::Cylinder(cylinder) if !cylinder.open => Some(cylinder.stretch(ray)),
            Self::Cone(cone) if cone.is_convex() => Some(cone.stretch(&own(ray))),
            Self::Quadric(quadric) if quadric.is_convex() => Some(quadric.stretch(&own(ray))),
            _ => None,
        }
    }
}

/// A copy for one who is asked apart: a ray of which nobody has the address stays in registers, and none that is stored in
/// other pieces than it is read in is waited for.
#[inline(always)]
fn own(ray: &Ray) -> Ray {
    *ray
}

macro_rules! each {
    ($primitive:expr, $shape:ident => $call:expr) => {
        match $primitive {
            Self::Sphere($shape) => $call,
            Self::Box($shape) => $call,
            Self::Plane($shape) => $call,
            Self::Disc($shape) => $call,
            Self::Cylinder($shape) => $call,
            Self::Cone($shape) => $call,
            Self::Torus($shape) => $call,
            Self::Triangle($shape) => $call,
            Self::Mesh($shape) => $call,
            Self::Quadric($shape) => $call,
            Self::Other($shape) => $call,
        }
    };
}

impl Shape for Primitive {
    fn bounds(&self) -> Bounds {
        each!(self, shape => shape.bounds())
    }

    fn extent(&self) -> Bounds {
        each!(self, shape => shape.extent())
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        each!(self, shape => shape.crossings(ray, range, out));
    }

    #[inline(always)]
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        each!(self, shape => shape.nearest(&own(ray), range))
    }

    #[inline(always)]
    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        each!(self, shape => shape.occludes(&own(ray), range))
    }

    fn is_flat(&self) -> bool {
        each!(self, shape => shape.is_flat())
    }

    fn is_closed(&self) -> bool {
        each!(self, shape => shape.is_closed())
    }

    fn inside(&self, point: DVec3) -> bool {
        each!(self, shape => shape.inside(point))
    }

    fn outside(&self, point: DVec3) -> bool {
        each!(self, shape => shape.outside(point))
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        each!(self, shape => shape.inside_along(point))
    }

    fn is_solid(&self) -> bool {
        each!(self, shape => shape.is_solid())
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        each!(self, shape => shape.normal(point, crossing))
    }

    fn geometric_normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        each!(self, shape => shape.geometric_normal(point, crossing))
    }

    fn uv(&self, point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        each!(self, shape => shape.uv(point, crossing))
    }

    fn textures(&self, point: DVec3, crossing: &Crossing, found: &mut dyn FnMut(u32, f64)) {
        each!(self, shape => shape.textures(point, crossing, found));
    }

    fn interpolates(&self) -> bool {
        each!(self, shape => shape.interpolates())
    }

    fn outer_normal(&self, point: DVec3, crossing: &Crossing, outer: &dyn Fn(DVec3) -> DVec3) -> DVec3 {
        each!(self, shape => shape.outer_normal(point, crossing, outer))
    }

    fn lag(&self, crossing: &Crossing) -> f64 {
        each!(self, shape => shape.lag(crossing))
    }

    fn remark(&self) -> Option<Remark> {
        each!(self, shape => shape.remark())
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        each!(self, shape => shape.reproject(point, crossing))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn four_rays_meet_what_each_of_them_meets() {
        let shapes = [
            Primitive::Sphere(Sphere { center: DVec3::new(0.5, 0.0, -0.5), radius: 1.0 }),
            Primitive::Sphere(Sphere { center: DVec3::ZERO, radius: -1.5 }),
            Primitive::Box(Cuboid { min: DVec3::splat(-1.0), max: DVec3::new(1.0, 0.5, 2.0) }),
            Primitive::Plane(Plane { normal: DVec3::Y, distance: 0.5 }),
        ];
        let mut number = numbers(23);
        let mut met = 0;
        for turn in 0..40_000 {
            let shape = &shapes[turn % shapes.len()];
            let mut rays = Rays { origin: [Lanes::ZERO; 3], direction: [Lanes::ZERO; 3] };
            for lane in 0..Lanes::COUNT {
                let mut point = || DVec3::new(number(), number(), number());
                let (mut origin, mut target) = (6.0 * point(), 3.0 * point());
                // Places on a grid make rays along axes, and such that graze faces, edges and poles.
                if turn % 3 == 0 {
                    (origin, target) = ((origin * 2.0).round() / 2.0, (target * 2.0).round() / 2.0);
                }
                let direction = (target - origin).try_normalize().unwrap_or(DVec3::Z);
                for axis in 0..3 {
                    rays.origin[axis].0[lane] = origin[axis];
                    rays.direction[axis].0[lane] = direction[axis];
                }
            }
            let end = if turn % 5 == 0 { 2.0 } else { f64::INFINITY };
            let together = shape.nearest_of_four(&rays, Lanes::splat(end));
            for lane in 0..Lanes::COUNT {
                let alone = shape.nearest(&rays.ray(lane), Range { min: 0.0, max: end.next_up() });
                let found = together.map(|[t, part]| (t.0[lane], part.0[lane] as u32));
                let found = found.filter(|(t, _)| *t > 0.0 && *t <= end && *t < f64::INFINITY);
                assert_eq!(found, alone.map(|crossing| (crossing.t, crossing.part)), "{:?}", rays.ray(lane));
                met += u32::from(found.is_some());
            }
        }
        assert!(met > 40_000, "{met}");
    }
}
