//! How many shapes are asked: rays and points must only bother those near them.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::*;
use crate::compile::flatten::Flattener;
use crate::math::Bounds;
use crate::options::Accelerator;
use crate::scene::settings::Settings;
use crate::world::shape::{Crossing, Primitive, Shape as Asked};
use crate::world::{Geometry, Range, Ray, RayKind};

/// Counts the questions to a shape.
#[derive(Debug)]
struct Counting {
    shape: Primitive,
    asked: Arc<AtomicUsize>,
}

impl Counting {
    fn count(&self) -> &Primitive {
        self.asked.fetch_add(1, Ordering::Relaxed);
        &self.shape
    }
}

impl Asked for Counting {
    fn bounds(&self) -> Bounds {
        self.shape.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.count().crossings(ray, range, out);
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.count().nearest(ray, range)
    }

    fn inside(&self, point: DVec3) -> bool {
        self.count().inside(point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.shape.normal(point, crossing)
    }
}

/// Questions per ray, over rays from all sides into the cube -1 … 1, of which some hit.
fn cost(object: &Arc<Object>) -> f64 {
    const RAYS: usize = 1000;
    let settings = Settings::default();
    let mut flattener = Flattener::new(&settings, Accelerator::Auto, false);
    flattener.add(object);
    let mut parts = flattener.finish().parts;
    let asked = Arc::new(AtomicUsize::new(0));
    for leaf in &mut parts.leaves {
        let shape = leaf.primitive.clone();
        leaf.primitive = Primitive::Other(Arc::new(Counting { shape, asked: asked.clone() }));
    }
    let geometry = Geometry::new(parts, Accelerator::Auto);
    let mut numbers = Numbers(21);
    let mut hits = 0;
    for _ in 0..RAYS {
        let (from, to) = (4. * numbers.vector().normalize(), numbers.vector());
        let ray = Ray::new(from, (to - from).normalize());
        hits += usize::from(geometry.hit(&ray, Range::AHEAD, RayKind::IMAGE).is_some());
    }
    assert!(hits > RAYS / 2, "{hits} hits");
    asked.load(Ordering::Relaxed) as f64 / RAYS as f64
}

fn cutters(count: usize) -> Vec<Arc<Object>> {
    let mut numbers = Numbers(22);
    (0..count).map(|_| sphere(numbers.vector(), 0.05)).collect()
}

fn unit_box() -> Arc<Object> {
    cube(-DVec3::ONE, DVec3::ONE)
}

#[test]
fn a_thousand_cutters_cost_what_the_few_near_the_ray_cost() {
    let bored = difference([unit_box()].into_iter().chain(cutters(1000)));
    let cost = cost(&bored);
    assert!(cost < 12.0, "{cost} questions per ray");
}

#[test]
fn so_do_the_members_of_merges_and_of_unions_within() {
    let merged = cost(&merge([cube(DVec3::splat(-0.9), DVec3::splat(0.9))].into_iter().chain(cutters(1000))));
    assert!(merged < 15.0, "{merged} questions per ray");
    let nested = cost(&difference([unit_box(), union(cutters(1000))]));
    assert!(nested < 15.0, "{nested} questions per ray");
}

#[test]
fn rays_ask_few_of_many_objects() {
    let cost = cost(&union(cutters(3000)));
    assert!(cost < 6.0, "{cost} questions per ray");
}
