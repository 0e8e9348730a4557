//! Coincident faces (docs/spec/primitives.md 7.2 and 9.5): where POV-Ray speckles, the exact
//! solid; decided the same way for every ray and every rotation.

use super::*;

const Z: DVec3 = DVec3::Z;

fn rotations() -> [Transform; 5] {
    [v(0., 0., 0.), v(10., 20., 30.), v(17., 33., 5.), v(90., 0., 0.), v(1e-7, 0., 45.)]
        .map(Transform::rotate)
}

fn unit_box() -> Arc<Object> {
    cube(-DVec3::ONE, DVec3::ONE)
}

/// Calls back with the hit in the object's own space for a grid of rays from every side of the
/// rotated object; `exact` says where the ray should hit first.
fn compare(name: &str, object: Arc<Object>, exact: Arc<Object>) {
    for rotation in rotations() {
        let (ours, reference) =
            (probe(&moved(object.clone(), rotation)), probe(&moved(exact.clone(), rotation)));
        let mut numbers = Numbers(9);
        for turn in 0..3000 {
            let target = 1.2 * numbers.vector();
            let from = 4. * numbers.vector().normalize_or(Z);
            let (from, to) = (rotation.point(from), rotation.point(target));
            match (ours.trace(from, to - from), reference.trace(from, to - from)) {
                (Some((p, _)), Some((q, _))) => {
                    assert!(p.abs_diff_eq(q, 1e-12), "{name}, ray {turn} from {from} to {to}: {p}, not {q}");
                }
                (None, None) => {}
                (p, q) => panic!("{name}, ray {turn} from {from} to {to}: {p:?}, not {q:?}"),
            }
        }
    }
}

#[test]
fn a_cutter_flush_with_a_face_opens_it() {
    let flush = cube(v(-0.5, -0.5, -1.), v(0.5, 0.5, 0.5));
    let beyond = cube(v(-0.5, -0.5, -1.01), v(0.5, 0.5, 0.5));
    compare("box", difference([unit_box(), flush]), difference([unit_box(), beyond]));
}

#[test]
fn a_cylinder_as_long_as_the_box_makes_a_hole() {
    let (flush, beyond) = (cylinder(-Z, Z, 0.5), cylinder(-1.1 * Z, 1.1 * Z, 0.5));
    compare("cylinder", difference([unit_box(), flush]), difference([unit_box(), beyond]));
}

#[test]
fn flush_merged_faces_leave_one() {
    let (left, right) = (cube(-DVec3::ONE, v(0.5, 1., 1.)), cube(v(-0.5, -1., -1.), DVec3::ONE));
    compare("overlapping", merge([left, right]), unit_box());
    let (left, right) = (cube(-DVec3::ONE, v(0., 1., 1.)), cube(v(0., -1., -1.), DVec3::ONE));
    compare("touching", merge([left, right]), unit_box());
    compare("identical", merge([unit_box(), unit_box()]), unit_box());
    compare("spheres", merge([sphere(Z, 1.), sphere(Z, 1.)]), sphere(Z, 1.));
}

#[test]
fn identical_members_intersect_to_themselves() {
    for (name, solid) in [
        ("box", unit_box()),
        ("cylinder", cylinder(-Z, Z, 1.)),
        ("sphere", sphere(Z, 1.)),
        ("compound", difference([unit_box(), sphere(Z, 0.5)])),
    ] {
        compare(name, intersection([solid.clone(), solid.clone()]), solid.clone());
        let three = [solid.clone(), solid.clone(), solid.clone()];
        compare(name, intersection(three), solid);
    }
}

#[test]
fn a_solid_minus_itself_is_nothing() {
    for solid in [unit_box(), cylinder(-Z, Z, 1.), sphere(Z, 1.)] {
        compare(
            "nothing",
            difference([solid.clone(), solid]),
            intersection([sphere(Z, 1.), sphere(9. * Z, 1.)]),
        );
    }
}

#[test]
fn a_flush_clip_leaves_the_face() {
    compare("clip", clipped(unit_box(), [unit_box()]), unit_box());
}

#[test]
fn a_clipped_solid_takes_away_the_face_it_stands_on() {
    let above = cube(v(-2., -2., 1.), v(2., 2., 4.));
    let dome = clipped(sphere(Z, 0.5), [above]);
    compare("dome", merge([unit_box(), dome]), merge([unit_box(), sphere(Z, 0.5)]));
}
