//! Random nested compounds against point sampling: along a ray, a surface must lie between
//! samples of which one is inside and one is not, and nowhere else.

use super::*;

fn random_solid(numbers: &mut Numbers, depth: u32) -> Arc<Object> {
    let place =
        Transform::rotate(180. * numbers.vector()).then(&Transform::translate(0.6 * numbers.vector()));
    let solid = if depth == 0 || numbers.next() < 0.2 {
        let size = 0.3 + 0.7 * numbers.next();
        match numbers.below(4) {
            0 => sphere(DVec3::ZERO, size),
            1 => cube(-size * DVec3::ONE, size * v(0.5, 1., 0.8)),
            2 => cylinder(v(0., -size, 0.), v(0., size, 0.), 0.5),
            _ => plane(DVec3::Y, 0.4),
        }
    } else {
        let count = 2 + numbers.below(3);
        // Unions would keep their inner faces, which parity doesn't see.
        let operation =
            [CsgOperation::Merge, CsgOperation::Intersection, CsgOperation::Difference][numbers.below(3)];
        let children: Vec<_> = (0..count).map(|_| random_solid(numbers, depth - 1)).collect();
        csg(operation, children)
    };
    let solid = moved(solid, place);
    if numbers.next() < 0.2 { inverse(solid) } else { solid }
}

/// Inside by the definition of docs/spec/primitives.md 7.1, without any flattening.
fn inside(object: &Object, point: DVec3) -> bool {
    let point = object.transform.as_ref().map_or(point, |transform| transform.inverse_point(point));
    let own = match &object.shape {
        Shape::Sphere { center, radius } => (point - center).length() < *radius,
        Shape::Box { min, max } => point.cmpge(*min).all() && point.cmple(*max).all(),
        Shape::Cylinder(cone) => point.y.abs() <= cone.cap.y && point.x.hypot(point.z) <= cone.base_radius,
        Shape::Plane { normal, distance } => normal.dot(point) <= *distance,
        Shape::Csg(csg) => {
            let mut children = csg.children.iter().map(|child| inside(child, point));
            match csg.operation {
                CsgOperation::Union | CsgOperation::Merge => children.any(|inside| inside),
                CsgOperation::Intersection => children.all(|inside| inside),
                CsgOperation::Difference => {
                    children.enumerate().all(|(place, inside)| inside == (place == 0))
                }
            }
        }
        other => panic!("{other:?} has no oracle"),
    };
    own != object.flags.contains(ObjectFlags::INVERSE)
}

#[test]
fn surfaces_lie_where_the_inside_changes() {
    let mut numbers = Numbers(5);
    let (mut surfaces, mut solids_hit) = (0, 0);
    for turn in 0..150 {
        let solid = random_solid(&mut numbers, 4);
        let ours = probe(&solid);
        let before = surfaces;
        for _ in 0..40 {
            let origin = 3. * numbers.vector();
            let direction = (0.8 * numbers.vector() - origin).normalize();
            let mut from = 0.0;
            let mut state = inside(&solid, origin);
            assert_eq!(ours.inside(origin), state, "solid {turn} at {origin}");
            while let Some((point, _)) = ours.trace(origin + from * direction, direction) {
                let t = (point - origin).dot(direction);
                let (low, high) = (t - 1e-9, t + 1e-9);
                let changes =
                    inside(&solid, origin + low * direction) != inside(&solid, origin + high * direction);
                assert!(changes, "solid {turn}: a false surface at {point}");
                assert_eq!(
                    inside(&solid, origin + low * direction),
                    state,
                    "solid {turn}: a surface is missing before {point}"
                );
                // Surfaces nearer than the least distance of `trace` are passed over.
                from = t + 1e-9;
                state = inside(&solid, origin + (t + 1.5e-4) * direction);
                surfaces += 1;
            }
            assert_eq!(
                inside(&solid, origin + 1e3 * direction),
                state,
                "solid {turn}: a surface is missing behind {from}"
            );
        }
        solids_hit += usize::from(surfaces > before);
    }
    assert!(surfaces > 2500 && solids_hit > 70, "{surfaces} surfaces of {solids_hit} solids");
}
