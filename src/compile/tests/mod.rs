//! Objects built by hand and asked through [`Probe`](super::probe::Probe).

mod coincidence;
mod cost;
mod csg;
mod extremes;
mod oracle;
mod outline;
mod room;
mod scene;

use std::sync::Arc;

use super::probe::Probe;
use crate::math::{DVec3, Transform};
use crate::scene::depth::Nested;
use crate::scene::object::{ObjectExtra, ObjectFlags};
use crate::scene::settings::Settings;
use crate::scene::shape::{Cone, Csg, CsgOperation, Disc, Poly, Quadric, Triangle};
use crate::scene::{Object, Shape};
use crate::source::Span;

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn object(shape: Shape) -> Arc<Object> {
    Arc::new(Object::new(Span::default(), shape))
}

fn sphere(center: DVec3, radius: f64) -> Arc<Object> {
    object(Shape::Sphere { center, radius })
}

fn cube(min: DVec3, max: DVec3) -> Arc<Object> {
    object(Shape::Box { min, max })
}

fn plane(normal: DVec3, distance: f64) -> Arc<Object> {
    object(Shape::Plane { normal: normal.normalize(), distance })
}

fn cylinder(base: DVec3, cap: DVec3, radius: f64) -> Arc<Object> {
    object(Shape::Cylinder(Box::new(Cone {
        base,
        base_radius: radius,
        cap,
        cap_radius: radius,
        open: false,
    })))
}

fn triangle(corners: [DVec3; 3]) -> Arc<Object> {
    object(Shape::Triangle(Box::new(Triangle { corners, normals: None })))
}

fn quadric(squares: DVec3, linear: DVec3, constant: f64) -> Arc<Object> {
    object(Shape::Quadric(Box::new(Quadric { squares, products: DVec3::ZERO, linear, constant })))
}

fn csg(operation: CsgOperation, children: impl IntoIterator<Item = Arc<Object>>) -> Arc<Object> {
    let children = Nested::new(children.into_iter().collect());
    object(Shape::Csg(Arc::new(Csg { operation, children, split_union: true, parts: 1 })))
}

fn union(children: impl IntoIterator<Item = Arc<Object>>) -> Arc<Object> {
    csg(CsgOperation::Union, children)
}

fn merge(children: impl IntoIterator<Item = Arc<Object>>) -> Arc<Object> {
    csg(CsgOperation::Merge, children)
}

fn intersection(children: impl IntoIterator<Item = Arc<Object>>) -> Arc<Object> {
    csg(CsgOperation::Intersection, children)
}

fn difference(children: impl IntoIterator<Item = Arc<Object>>) -> Arc<Object> {
    csg(CsgOperation::Difference, children)
}

fn moved(mut object: Arc<Object>, by: Transform) -> Arc<Object> {
    Arc::make_mut(&mut object).apply(&by);
    object
}

fn inverse(mut object: Arc<Object>) -> Arc<Object> {
    Arc::make_mut(&mut object).flags.toggle(ObjectFlags::INVERSE);
    object
}

fn clipped(mut object: Arc<Object>, clips: impl IntoIterator<Item = Arc<Object>>) -> Arc<Object> {
    let clipped_by = Nested::new(clips.into_iter().collect());
    Arc::make_mut(&mut object).extra = Some(Box::new(ObjectExtra { clipped_by, ..ObjectExtra::default() }));
    object
}

fn probe(object: &Arc<Object>) -> Probe {
    Probe::new(object, &Settings::default()).unwrap()
}

/// A small generator of repeatable numbers.
struct Numbers(u64);

impl Numbers {
    /// In 0 … 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// 0 … n - 1.
    fn below(&mut self, n: usize) -> usize {
        (self.next() * n as f64) as usize
    }

    /// In the cube -1 … 1.
    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0
    }
}
