//! Primitives moved to where they are in the world, so that no ray need be moved to theirs.

use crate::math::{DMat3, DVec3, Transform};
use crate::world::shape::r#box::Cuboid;
use crate::world::shape::plane::Plane;
use crate::world::shape::sphere::Sphere;
use crate::world::shape::{Primitive, Shape};

/// What is moved so many times its size stays in its own space, where no digit of its corners is lost.
const FAR: f64 = 100.0;

/// The primitive that looks in the space around as `primitive` does where `transform` takes it, texture
/// coordinates and all; `None` where that isn't one of its kind.
pub(crate) fn settled(primitive: &Primitive, transform: &Transform) -> Option<Primitive> {
    let moved = transform.forward.translation.abs().max_element();
    let settled = match primitive {
        // Only its distance tells where it is: what moves it would swallow that one's digits.
        Primitive::Plane(plane) if moved == 0.0 => {
            let normal = transform.normal(plane.normal).try_normalize()?;
            let distance = normal.dot(transform.point(plane.normal * plane.distance));
            distance.is_finite().then_some(Primitive::Plane(Plane { normal, distance }))
        }
        Primitive::Sphere(sphere) => {
            let scale = scale(transform).filter(|scale| scale.x == scale.y && scale.y == scale.z)?;
            let center = transform.point(sphere.center);
            Some(Primitive::Sphere(Sphere { center, radius: sphere.radius * scale.x }))
        }
        Primitive::Box(cuboid) => {
            scale(transform)?;
            let (min, max) = (transform.point(cuboid.min), transform.point(cuboid.max));
            Some(Primitive::Box(Cuboid { min, max }))
        }
        Primitive::Triangle(triangle) => {
            triangle.transformed(transform).map(|triangle| Primitive::Triangle(Box::new(triangle)))
        }
        _ => None,
    };
    settled.filter(|settled| {
        let bounds = settled.bounds();
        let near = || moved <= FAR * bounds.size().max_element();
        matches!(settled, Primitive::Plane(_)) || bounds.is_finite() && near()
    })
}

/// How much a transform that only moves and enlarges does so along each axis.
fn scale(transform: &Transform) -> Option<DVec3> {
    let matrix = transform.forward.matrix3;
    let scale = DVec3::new(matrix.x_axis.x, matrix.y_axis.y, matrix.z_axis.z);
    (matrix == DMat3::from_diagonal(scale) && scale.min_element() > 0.0).then_some(scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::world::shape::triangle::Triangle;
    use crate::world::{Range, Ray};

    /// Rays meet the settled primitive where they meet the moved one, and its normals and texture
    /// coordinates are the same.
    fn agrees(primitive: &Primitive, transform: &Transform) {
        let settled = settled(primitive, transform).expect("it stays of its kind");
        let mut met = 0;
        for number in 0..400 {
            let angle = f64::from(number);
            let origin = 9.0 * DVec3::new(angle.cos(), (0.7 * angle).sin(), (1.3 * angle).cos());
            let inside = DVec3::new((2.1 * angle).sin(), (3.3 * angle).cos(), (0.9 * angle).sin());
            let target = transform.point(0.7 * inside);
            let ray = Ray::new(origin, (target - origin).normalize());
            let inner = ray.to_inner(transform);
            let there = primitive.nearest(&inner, Range::AHEAD);
            let here = settled.nearest(&ray, Range::AHEAD);
            assert_eq!(there.map(|hit| hit.part), here.map(|hit| hit.part));
            let (Some(there), Some(here)) = (there, here) else { continue };
            met += 1;
            assert!((there.t - here.t).abs() < 1e-12 * there.t.abs().max(1.0), "{there:?} {here:?}");
            let normal = transform.normal(primitive.normal(inner.at(there.t), &there)).normalize();
            assert!(normal.abs_diff_eq(settled.normal(ray.at(here.t), &here).normalize(), 1e-12));
            let [there, here] = [primitive.uv(inner.at(there.t), &there), settled.uv(ray.at(here.t), &here)];
            assert!(there.zip(here).is_none_or(|(there, here)| there.abs_diff_eq(here, 1e-9)));
        }
        assert!(met > 50, "only {met} rays met it");
    }

    #[test]
    fn settled_primitives_are_those_that_were_moved() {
        let moved = Transform::translate(DVec3::new(0.5, -0.25, 1.0));
        let enlarged = Transform::scale(DVec3::splat(1.5)).then(&moved);
        let stretched = Transform::scale(DVec3::new(2.0, 0.5, 1.5)).then(&moved);
        let turned = stretched.then(&Transform::rotate(DVec3::new(20.0, 130.0, 40.0)));
        let sphere = Primitive::Sphere(Sphere { center: DVec3::new(0.1, 0.2, 0.3), radius: -1.2 });
        let cuboid = Primitive::Box(Cuboid { min: DVec3::splat(-0.8), max: DVec3::new(1.0, 1.1, 0.4) });
        let plane = Primitive::Plane(Plane { normal: DVec3::new(0.6, 0.8, 0.0), distance: -0.5 });
        let corners = [DVec3::new(-2.0, 0.1, 0.0), DVec3::new(2.0, -1.0, 0.3), DVec3::new(0.0, 2.0, 0.7)];
        let normals = [DVec3::Z, DVec3::new(0.3, 0.2, 0.7), DVec3::new(0.0, -0.5, 0.5)];
        let triangle = |normals| Primitive::Triangle(Box::new(Triangle::new(corners, normals).unwrap()));
        agrees(&sphere, &moved);
        agrees(&sphere, &enlarged);
        agrees(&cuboid, &stretched);
        let spun = Transform::scale(DVec3::new(2.0, 0.5, 1.5))
            .then(&Transform::rotate(DVec3::new(20.0, 130.0, 40.0)));
        for spun in [&spun, &spun.then(&Transform::scale(DVec3::new(-1.0, 1.0, 1.0)))] {
            agrees(&plane, spun);
        }
        agrees(&triangle(None), &turned);
        agrees(&triangle(Some(normals)), &turned);
    }

    #[test]
    fn what_a_transform_makes_another_kind_stays_where_it_was() {
        let sphere = Primitive::Sphere(Sphere { center: DVec3::ZERO, radius: 1.0 });
        assert!(settled(&sphere, &Transform::scale(DVec3::new(1.0, 2.0, 1.0))).is_none());
        let far = Transform::translate(DVec3::new(1e3, 0.0, 0.0));
        assert!(settled(&sphere, &far).is_none(), "its digits would be lost");
        let plane = Primitive::Plane(Plane { normal: DVec3::Y, distance: 0.25 });
        assert!(settled(&plane, &far).is_none());
        // Its texture coordinates would turn with it.
        assert!(settled(&sphere, &Transform::rotate(DVec3::Y * 10.0)).is_none());
        let cuboid = Primitive::Box(Cuboid { min: DVec3::ZERO, max: DVec3::ONE });
        assert!(settled(&cuboid, &Transform::rotate(DVec3::Y * 10.0)).is_none());
        assert!(settled(&cuboid, &Transform::scale(DVec3::new(1.0, -1.0, 1.0))).is_none());
    }
}
