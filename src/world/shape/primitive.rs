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
use crate::math::{Band, Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

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
        !matches!(self, Self::Torus(_) | Self::Mesh(_) | Self::Quadric(_) | Self::Other(_))
    }

    /// Whether textures are looked up at its crossings and its normals are those of the surface.
    #[inline]
    pub fn is_simple(&self) -> bool {
        !matches!(self, Self::Triangle(_) | Self::Mesh(_) | Self::Other(_))
    }

    /// The point of a surface that is simple next to a computed one, and its unit normal there.
    #[inline]
    pub fn touched(&self, point: DVec3, crossing: &Crossing) -> (DVec3, DVec3) {
        match self {
            Self::Sphere(sphere) => sphere.touched(point),
            Self::Box(cuboid) => (cuboid.reproject(point, crossing), cuboid.normal(point, crossing)),
            Self::Plane(plane) => (plane.reproject(point, crossing), plane.normal),
            _ => {
                let on = self.reproject(point, crossing);
                (on, self.normal(on, crossing).normalize_or_zero())
            }
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

    /// Where a line is inside, if the shape is convex and all of its border is surface; the inner
    /// `None` where it is outside all along.
    #[inline]
    pub fn convex(&self, ray: &Ray) -> Option<Option<Stretch>> {
        match self {
            Self::Sphere(sphere) => Some(sphere.stretch(ray)),
            Self::Box(cuboid) => Some(cuboid.stretch(ray)),
            Self::Plane(plane) => Some(plane.stretch(ray)),
            Self::Cylinder(cylinder) if !cylinder.open => Some(cylinder.stretch(ray)),
            Self::Cone(cone) if cone.is_convex() => Some(cone.stretch(ray)),
            Self::Quadric(quadric) if quadric.is_convex() => Some(quadric.stretch(ray)),
            _ => None,
        }
    }
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
        each!(self, shape => shape.nearest(ray, range))
    }

    #[inline(always)]
    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        each!(self, shape => shape.occludes(ray, range))
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
