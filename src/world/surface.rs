//! What is known about a surface where a ray meets it.

use super::hit::{Geometry, Hit};
use super::object::Leaf;
use super::ray::Ray;
use super::shape::{Primitive, Shape};
use crate::math::{DVec2, DVec3, tally};

/// A point of a surface, as shading sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intersection {
    /// The point.
    pub point: DVec3,
    /// Where textures are looked up: `point`, but for surfaces that are only looked for to an accuracy.
    pub textured: DVec3,
    /// How far rounding may have moved it; leaving rays start this far off the surface.
    pub error: f64,
    /// Unit normal, turned towards the viewer; interpolated on smooth triangles.
    pub normal: DVec3,
    /// Unit normal of the true surface, turned like `normal`.
    pub geometric: DVec3,
    /// Whether the surface is seen from inside, so that the normals were turned round.
    pub inside: bool,
}

impl Intersection {
    /// The origin of space.
    pub const NOWHERE: Self = Self {
        point: DVec3::ZERO,
        textured: DVec3::ZERO,
        error: 0.0,
        normal: DVec3::ZERO,
        geometric: DVec3::ZERO,
        inside: false,
    };

    /// A point in space, where media are lit: rays leave it in all directions.
    pub fn in_space(point: DVec3) -> Self {
        let error = Self::rounding(point);
        Self { point, textured: point, error, normal: DVec3::ZERO, geometric: DVec3::ZERO, inside: false }
    }

    /// How far rounding may have moved a point in space.
    #[inline]
    pub fn rounding(point: DVec3) -> f64 {
        ROUNDING * point.abs().max_element()
    }

    /// A point of a leaf where a ray met it, where its textures are looked up, its normal and that of the true surface.
    #[inline(always)]
    fn seen_by(ray: &Ray, leaf: &Leaf, [point, textured, normal, geometric]: [DVec3; 4]) -> Self {
        let inside = normal.dot(ray.direction) > 0.0;
        let turn = |n: DVec3| if inside { -n } else { n };
        let coordinates = ray.origin.abs().max(point.abs()).max_element();
        Self {
            point,
            textured,
            error: ROUNDING * (coordinates + f64::from(leaf.reach)),
            normal: turn(normal),
            geometric: turn(geometric),
            inside,
        }
    }

    /// Where a ray in `direction` starts that leaves the surface here.
    #[inline(always)]
    pub fn leave(&self, direction: DVec3) -> DVec3 {
        let outward = if direction.dot(self.geometric) < 0.0 { -self.geometric } else { self.geometric };
        self.point + self.error * outward
    }
}

/// Bound on the rounding errors of a point, relative to the numbers it was computed from.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

impl Geometry {
    /// Works out a hit of `ray`.
    #[inline(always)]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Intersection {
        let leaf = self.parts().leaf(hit.leaf);
        if let Some((point, normal)) = leaf.primitive.soon_touched(ray.at(hit.t), &hit.crossing)
            && leaf.transform.is_none()
        {
            let normal = leaf.outward(normal);
            return Intersection::seen_by(ray, leaf, [point, point, normal, normal]);
        }
        Intersection::seen_by(ray, leaf, details(leaf, ray, hit))
    }

    /// Where textures are looked up at a hit of `ray`: what [`surface`](Self::surface) says of that, without normals.
    pub fn textured(&self, ray: &Ray, hit: &Hit) -> DVec3 {
        let leaf = self.parts().leaf(hit.leaf);
        let inner = leaf.inner(ray);
        let place = match leaf.primitive.lag(&hit.crossing) {
            0.0 => leaf.primitive.reproject(inner.at(hit.t), &hit.crossing),
            lag => inner.at(hit.t + lag),
        };
        leaf.transform.as_ref().map_or(place, |transform| transform.point(place))
    }

    /// Texture coordinates of a hit at `point`; x and y of the point where the shape has none.
    pub fn uv(&self, hit: &Hit, point: DVec3) -> DVec2 {
        tally::texture_coordinates(1);
        let leaf = self.parts().leaf(hit.leaf);
        leaf.primitive.uv(leaf.inner_point(point), &hit.crossing).unwrap_or(point.truncate())
    }
}

/// The point of a hit, where its textures are looked up, its normal and that of the true surface.
fn details(leaf: &Leaf, ray: &Ray, hit: &Hit) -> [DVec3; 4] {
    let inner_ray = leaf.inner(ray);
    let inner = inner_ray.at(hit.t);
    let outer = |inner| leaf.transform.as_ref().map_or(inner, |transform| transform.point(inner));
    if leaf.primitive.is_simple() {
        let (inner, normal) = leaf.primitive.touched(inner, &hit.crossing);
        // A unit vector made unit again may end up a little elsewhere.
        let normal = if leaf.transform.is_none() { leaf.outward(normal) } else { leaf.outer_normal(normal) };
        let point = outer(inner);
        return [point, point, normal, normal];
    }
    if let Primitive::Other(shape) = &leaf.primitive
        && let Some((inner, normal)) = shape.touched(inner, &hit.crossing)
    {
        let (point, normal) = (outer(inner), leaf.outer_normal(normal));
        return [point, point, normal, normal];
    }
    let inner = leaf.primitive.reproject(inner, &hit.crossing);
    let point = outer(inner);
    let lag = leaf.primitive.lag(&hit.crossing);
    let behind = if lag == 0.0 { inner } else { inner_ray.at(hit.t + lag) };
    let textured = if lag == 0.0 { point } else { outer(behind) };
    let normal = leaf.primitive.outer_normal(behind, &hit.crossing, &|normal| leaf.outer_normal(normal));
    let geometric = match lag == 0.0 && !leaf.primitive.interpolates() {
        true => normal,
        false => leaf.outer_normal(leaf.primitive.geometric_normal(inner, &hit.crossing)),
    };
    [point, textured, normal, geometric]
}
