//! Outlines: what they say of a place of a light is what a ray to it finds.

use super::*;
use crate::compile::flatten::Flattener;
use crate::options::Accelerator;
use crate::world::outline::{Outlines, Sight};
use crate::world::screen::{OPEN, SHUT, UNKNOWN};
use crate::world::{Geometry, Range, Ray};

/// One object, through which no light passes.
fn opaque(object: &Arc<Object>) -> Geometry {
    let settings = Settings::default();
    let mut flattener = Flattener::new(&settings, Accelerator::Auto, false);
    flattener.add(object);
    let mut parts = flattener.finish().parts;
    parts.objects.iter_mut().for_each(|object| object.opaque = true);
    Geometry::new(parts, Accelerator::Auto)
}

/// Holds verdicts on places of lights as points around the object see them against rays; of a hundred
/// places that an outline has a part in, so many are left to the surface.
fn compare(name: &str, object: Arc<Object>, on_surface: bool) -> f64 {
    let geometry = opaque(&object);
    let caster = geometry.caster(0).unwrap_or_else(|| panic!("{name} has no outline"));
    let mut numbers = Numbers(5);
    let (mut outlines, mut near) = (Outlines::default(), Vec::new());
    let mut seen = [0; 3];
    for _ in 0..1500 {
        let (mut from, light) = (1.6 * numbers.vector(), 6.0 * numbers.vector());
        let mut normal = DVec3::ZERO;
        if on_surface {
            let ray = Ray::new(from, (0.8 * numbers.vector() - from).normalize());
            let Some(hit) = geometry.hit(&ray, Range::AHEAD, crate::world::RayKind::IMAGE) else { continue };
            let surface = geometry.surface(&ray, &hit);
            normal = surface.geometric;
            from = surface.leave(light - surface.point);
        }
        let axes = [numbers.vector(), numbers.vector()];
        let sight = Sight { from, middle: light - from, axes, reach: [0.5, 0.6] };
        outlines.clear(&sight);
        let Some(all) = outlines.add(0, &caster, &sight) else { continue };
        for _ in 0..12 {
            let [x, y] = [0.5, 0.6].map(|reach| reach * (2.0 * numbers.next() - 1.0));
            let verdict = if all == UNKNOWN { outlines.verdict(x, y, &mut near) } else { all };
            let way = sight.middle + axes[0] * x + axes[1] * y;
            if way.dot(normal) * sight.middle.dot(normal) < 0.0 {
                // It leaves on the other side of the surface.
                continue;
            }
            let ray = Ray::new(from, way.normalize());
            let range = Range { min: 0.0, max: way.length() * (1.0 - 1e-9) };
            let blocked = geometry.occluders(&ray, range, None, &mut Vec::new()).is_some();
            assert!(verdict != OPEN || !blocked, "{name}: {from} to {light} by {way} is shut");
            assert!(verdict != SHUT || blocked, "{name}: {from} to {light} by {way} is open");
            if all == UNKNOWN {
                seen[verdict as usize] += 1;
            }
        }
    }
    assert!(on_surface || seen[0].min(seen[2]) > 100, "{name}: {seen:?}");
    100.0 * f64::from(seen[1]) / f64::from(seen[0] + seen[1] + seen[2])
}

fn turned(object: Arc<Object>) -> Arc<Object> {
    moved(object, Transform::rotate(v(20., 30., 40.)).then(&Transform::translate(v(0.1, -0.2, 0.05))))
}

/// A frame: a box with a hole from front to back.
fn frame() -> Arc<Object> {
    difference([
        cube(v(-0.9, -0.9, -0.1), v(0.9, 0.9, 0.1)),
        moved(cube(v(-0.4, -0.4, -0.5), v(0.4, 0.4, 0.5)), Transform::rotate(30.0 * Z)),
    ])
}

const Z: DVec3 = DVec3::Z;

fn torus(major: f64, minor: f64) -> Arc<Object> {
    object(Shape::Torus { major, minor })
}

#[test]
fn flat_faces_leave_nothing_to_the_surface() {
    let block = || cube(v(-0.6, -0.3, -0.5), v(0.5, 0.4, 0.7));
    let mirrored = moved(block(), Transform::scale(v(-1.0, 2.0, 0.7)));
    let corner = || moved(cube(v(-0.2, -0.2, -0.2), v(0.9, 0.9, 0.9)), Transform::rotate(v(40., 5., 3.)));
    for (name, object) in [
        ("box", block()),
        ("turned box", turned(block())),
        ("mirrored box", mirrored),
        ("frame", turned(frame())),
        ("intersection", intersection([block(), corner()])),
        ("box without a corner", difference([block(), corner()])),
        ("merge", merge([block(), corner()])),
    ] {
        assert_eq!(compare(name, object.clone(), false), 0.0, "{name}");
        compare(name, object, true);
    }
}

#[test]
fn round_solids_leave_little_to_the_surface() {
    for (name, object, most) in [
        ("cylinder", turned(cylinder(-0.7 * Z, 0.6 * Z, 0.2)), 35.0),
        ("flat cylinder", cylinder(-0.1 * Z, 0.1 * Z, 0.9), 90.0),
        ("torus", turned(torus(0.6, 0.15)), 15.0),
        ("thick torus", torus(0.5, 0.45), 60.0),
    ] {
        let share = compare(name, object.clone(), false);
        assert!(share < most, "{name}: {share} %");
        compare(name, object, true);
    }
}

#[test]
fn what_is_not_known_has_no_outline() {
    let flush = difference([cube(-DVec3::ONE, DVec3::ONE), cube(v(-0.5, -0.5, -1.0), v(0.5, 0.5, 0.5))]);
    let skewed = Transform::rotate(v(10., 20., 30.)).then(&Transform::scale(v(1.0, 1e-4, 1.0)));
    let skewed = moved(cube(-DVec3::ONE, DVec3::ONE), skewed);
    for object in [flush, skewed, inverse(cube(-DVec3::ONE, DVec3::ONE)), sphere(Z, 1.0)] {
        assert!(opaque(&object).caster(0).is_none());
    }
}
