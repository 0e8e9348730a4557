//! Rays that are none and objects without number: an answer all the same, and soon.

use super::*;
use crate::compile::flatten::Flattener;
use crate::options::Accelerator;
use crate::world::{Geometry, Range, Ray, RayKind};

const KINDS: [Accelerator; 3] = [Accelerator::Linear, Accelerator::Octree, Accelerator::Bvh];

fn geometry(objects: &[Arc<Object>], accelerator: Accelerator) -> Geometry {
    let settings = Settings::default();
    let mut flattener = Flattener::new(&settings, accelerator, false);
    objects.iter().for_each(|object| flattener.add(object));
    Geometry::new(flattener.finish().parts, accelerator)
}

#[test]
fn rays_of_no_numbers_and_of_infinite_ones_come_to_an_end() {
    let mut objects: Vec<_> = (0..40).map(|i| sphere(v(f64::from(i % 7), f64::from(i), 0.), 0.6)).collect();
    objects.push(difference([cube(-DVec3::ONE, DVec3::ONE), sphere(DVec3::ONE, 1.)]));
    objects.push(plane(DVec3::Y, -2.));
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0., -0., 1., f64::MAX, f64::MIN_POSITIVE];
    let vectors = || odd.into_iter().flat_map(|a| odd.into_iter().map(move |b| v(a, b, 1.)));
    for kind in KINDS {
        let geometry = geometry(&objects, kind);
        let mut through = Vec::new();
        for (origin, direction) in vectors().flat_map(|origin| vectors().map(move |way| (origin, way))) {
            let ray = Ray::new(origin, direction);
            let hit = geometry.hit(&ray, Range::AHEAD, RayKind::IMAGE);
            assert!(hit.is_none_or(|hit| hit.t > 0.), "{kind:?} {ray:?}: {hit:?}");
            geometry.occluders(&ray, Range::AHEAD, None, &mut through);
            geometry.containers(origin);
        }
    }
}

#[test]
fn of_a_million_coincident_spheres_the_first_is_seen() {
    let mut objects = vec![sphere(DVec3::ZERO, 1.); 1_000_000];
    objects.push(sphere(4. * DVec3::X, 1.));
    for kind in KINDS {
        let geometry = geometry(&objects, kind);
        for (origin, seen) in
            [(DVec3::ZERO, Some(0)), (4. * DVec3::X, Some(1_000_000)), (9. * DVec3::X, None)]
        {
            let ray = Ray::new(origin - 5. * DVec3::Z, DVec3::Z);
            let hit = geometry.hit(&ray, Range::AHEAD, RayKind::IMAGE);
            assert_eq!(hit.map(|hit| (hit.t, hit.object)), seen.map(|object| (4., object)), "{kind:?}");
        }
    }
}
