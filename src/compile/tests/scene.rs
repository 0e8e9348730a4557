//! Whole lists of objects: what stands alone, who is seen first, who is seen at all, how many are asked.

use super::*;
use crate::compile::flatten::{Flat, Flattener};
use crate::options::Accelerator;
use crate::scene::light::{Light, LightKind};
use crate::scene::settings::Settings;
use crate::scene::shape::LightGroup;
use crate::world::{Geometry, Hit, Range, Ray, RayKind};

fn flat(objects: &[Arc<Object>], accelerator: Accelerator) -> Flat {
    let settings = Settings::default();
    let mut flattener = Flattener::new(&settings, accelerator, false);
    objects.iter().for_each(|object| flattener.add(object));
    flattener.finish()
}

fn geometry(objects: &[Arc<Object>]) -> Geometry {
    Geometry::new(flat(objects, Accelerator::Auto).parts, Accelerator::Auto)
}

fn hit(geometry: &Geometry, origin: DVec3, direction: DVec3, kind: RayKind) -> Option<Hit> {
    geometry.hit(&Ray::new(origin, direction.normalize()), Range::AHEAD, kind)
}

fn flagged(mut object: Arc<Object>, flags: ObjectFlags) -> Arc<Object> {
    Arc::make_mut(&mut object).flags |= flags;
    object
}

fn light() -> Arc<Object> {
    object(Shape::Light(Arc::new(Light {
        kind: LightKind::Point,
        location: DVec3::ZERO,
        color: crate::math::Rgb::ONE,
        point_at: DVec3::Z,
        parallel: false,
        fade_distance: 0.0,
        fade_power: 0.0,
        area: None,
        looks_like: None,
        projected_through: None,
        media_interaction: true,
        media_attenuation: false,
        photons: None,
    })))
}

fn light_group(objects: impl IntoIterator<Item = Arc<Object>>, global_lights: bool) -> Arc<Object> {
    let objects = Nested::new(objects.into_iter().collect());
    object(Shape::LightGroup(Arc::new(LightGroup { objects, global_lights })))
}

fn unit_box() -> Arc<Object> {
    cube(-DVec3::ONE, DVec3::ONE)
}

/// The number of the leaf seen of coincident ones.
fn seen(objects: &[Arc<Object>]) -> u32 {
    hit(&geometry(objects), v(0.3, 0.2, -5.), DVec3::Z, RayKind::IMAGE).unwrap().leaf
}

#[test]
fn of_coincident_objects_the_first_is_seen_and_of_coincident_members_the_last() {
    assert_eq!(seen(&[unit_box(), unit_box()]), 0);
    assert_eq!(seen(&[union([unit_box(), unit_box()])]), 0, "a union that is dissolved");
    let mut whole = union([unit_box(), unit_box()]);
    if let Shape::Csg(csg) = &mut Arc::make_mut(&mut whole).shape {
        Arc::make_mut(csg).split_union = false;
    }
    assert_eq!(seen(&[whole]), 1, "a union with split_union off");
    assert_eq!(seen(&[intersection([unit_box(), unit_box(), unit_box()])]), 2);
    let wide = cube(v(-2., -2., -1.), v(2., 2., 2.));
    assert_eq!(seen(&[intersection([unit_box(), wide.clone()])]), 1);
    assert_eq!(seen(&[intersection([wide, unit_box()])]), 1);
}

#[test]
fn the_ground_is_seen_under_what_stands_on_it() {
    let ground = || plane(DVec3::Z, 1.0);
    let turned = moved(unit_box(), Transform::rotate(v(0., 0., 37.)));
    for solid in [unit_box(), turned, cylinder(-DVec3::Z, DVec3::Z, 1.0)] {
        let below = |objects: &[Arc<Object>]| {
            let geometry = geometry(objects);
            // Slanted rays from inside, so that rounding has a say.
            let rays = (0..50).map(|i| v(0.01 * f64::from(i) - 0.25, 0.003 * f64::from(i), 1.0));
            let hits = rays.map(|way| hit(&geometry, v(0.1, 0.05, -0.3), way, RayKind::IMAGE).unwrap());
            hits.map(|hit| hit.leaf).collect::<Vec<_>>()
        };
        assert_eq!(below(&[solid.clone(), ground()]), [1; 50]);
        assert_eq!(below(&[ground(), solid]), [0; 50]);
    }
    // What is near it is not on it.
    let near = cube(-DVec3::ONE, v(1., 1., 1. - 1e-9));
    let geometry = geometry(&[near, ground()]);
    assert_eq!(hit(&geometry, DVec3::ZERO, DVec3::Z, RayKind::IMAGE).unwrap().leaf, 0);
}

#[test]
fn unions_are_dissolved_unless_they_cut_or_are_cut() {
    let pair = || union([sphere(-DVec3::X, 0.5), union([sphere(DVec3::X, 0.5), unit_box()])]);
    let count = |object: Arc<Object>| flat(&[object], Accelerator::Auto).parts.objects.len();
    assert_eq!(count(pair()), 3);
    assert_eq!(count(clipped(pair(), [plane(DVec3::X, 0.)])), 1);
    assert_eq!(count(inverse(pair())), 1);
    assert_eq!(count(merge([unit_box(), unit_box()])), 1);
}

#[test]
fn nested_compounds_of_one_kind_become_one() {
    let mut carved = unit_box();
    for i in 0..2000 {
        carved = difference([carved, sphere(v(f64::from(i), 0., 0.), 0.1)]);
    }
    let flat = flat(&[carved.clone()], Accelerator::Auto);
    assert_eq!((flat.parts.groups.len(), flat.parts.leaves.len()), (1, 2001));
    assert!(flat.unsupported.is_empty());
}

#[test]
fn nesting_that_cant_be_flattened_has_a_limit() {
    let mut nested = unit_box();
    for _ in 0..1000 {
        nested = merge([intersection([nested, unit_box()]), sphere(DVec3::ZERO, 0.1)]);
    }
    let flat = flat(&[nested], Accelerator::Auto);
    assert!(
        flat.unsupported.iter().any(|u| u.to_string().contains("nested more than")),
        "{:?}",
        flat.unsupported
    );
}

#[test]
fn flags_hide_objects_from_their_kinds_of_rays() {
    for (flag, kind) in [
        (ObjectFlags::NO_IMAGE, RayKind::IMAGE),
        (ObjectFlags::NO_REFLECTION, RayKind::REFLECTION),
        (ObjectFlags::NO_SHADOW, RayKind::SHADOW),
        (ObjectFlags::NO_RADIOSITY, RayKind::RADIOSITY),
    ] {
        let hidden = flagged(unit_box(), flag);
        let backdrop = plane(-DVec3::Z, -3.);
        for object in [
            hidden.clone(),
            union([hidden.clone(), sphere(9. * DVec3::X, 1.)]),
            flagged(intersection([unit_box(), unit_box()]), flag),
        ] {
            let geometry = geometry(&[object, backdrop.clone()]);
            for other in [RayKind::IMAGE, RayKind::REFLECTION, RayKind::SHADOW, RayKind::RADIOSITY] {
                let seen = hit(&geometry, -5. * DVec3::Z, DVec3::Z, other).unwrap().t;
                assert_eq!(seen, if other == kind { 8. } else { 4. }, "{flag:?} and {other:?}");
            }
        }
        // An intersection decides for its members.
        let inner = geometry(&[intersection([hidden, sphere(DVec3::ZERO, 9.)])]);
        assert!(hit(&inner, -5. * DVec3::Z, DVec3::Z, kind).is_some());
    }
}

#[test]
fn lights_reach_what_their_groups_say() {
    let lit_by = |objects: &[Arc<Object>]| {
        let flat = flat(objects, Accelerator::Auto);
        let leaves = flat.parts.leaves.iter();
        leaves.map(|leaf| flat.light_sets[leaf.lights as usize].clone()).collect::<Vec<_>>()
    };
    let group = |global| light_group([light(), unit_box()], global);
    assert_eq!(lit_by(&[light(), group(false), unit_box()]), [vec![1], vec![0]]);
    assert_eq!(lit_by(&[light(), group(true), unit_box()]), [vec![0, 1], vec![0]]);
    assert_eq!(
        lit_by(&[light_group([unit_box()], false), light()]),
        [vec![0]],
        "a group without lights is none"
    );
    let nested = light_group([light(), light_group([light(), unit_box()], false)], false);
    assert_eq!(lit_by(&[light(), nested]), [vec![1, 2]], "nested groups add up");
    assert_eq!(lit_by(&[union([light(), unit_box()])]), [vec![0]], "lights in unions shine for all");
}

#[test]
fn the_shape_a_light_looks_like_is_seen_but_casts_no_shadow() {
    let mut lamp = light();
    if let Shape::Light(light) = &mut Arc::make_mut(&mut lamp).shape {
        Arc::make_mut(light).looks_like = Some(Nested::new(sphere(DVec3::ZERO, 1.)));
    }
    let geometry = geometry(&[moved(lamp, Transform::translate(DVec3::X))]);
    assert_eq!(hit(&geometry, v(1., 0., -5.), DVec3::Z, RayKind::IMAGE).unwrap().t, 4.);
    let mut through = Vec::new();
    let ray = Ray::new(v(1., 0., -5.), DVec3::Z);
    assert_eq!(geometry.occluders(&ray, Range::AHEAD, None, &mut through), None);
    assert!(through.is_empty());
}

#[test]
fn bounds_that_are_too_small_cut() {
    let bounded = |mut object: Arc<Object>, by: Arc<Object>| {
        let bounded_by = Nested::new(vec![by]);
        Arc::make_mut(&mut object).extra =
            Some(Box::new(ObjectExtra { bounded_by, ..ObjectExtra::default() }));
        object
    };
    let ball = bounded(sphere(DVec3::ZERO, 2.), unit_box());
    let compound =
        bounded(intersection([sphere(DVec3::ZERO, 2.), sphere(DVec3::ZERO, 2.)]), sphere(DVec3::ZERO, 1.));
    let aside = cube(v(50., 0., 0.), v(51., 1., 1.));
    let meets = |objects: &[Arc<Object>], x: f64| {
        hit(&geometry(objects), v(x, 0., -5.), DVec3::Z, RayKind::IMAGE).is_some()
    };
    // A sphere's box is asked only in scenes of three objects and more.
    assert!(meets(&[ball.clone(), aside.clone()], 1.5));
    let three = [ball.clone(), aside.clone(), aside];
    assert!(meets(&three, 0.9) && !meets(&three, 1.5));
    assert!(meets(std::slice::from_ref(&compound), 0.9) && !meets(&[compound], 1.5));
    // A polynomial keeps its bounding object, not just that one's box.
    let poly = Poly { order: 2, coefficients: vec![0., 0., 0., 0., 1., 0., 0., 1., 0., -0.1] };
    let rod = bounded(object(Shape::Poly(Arc::new(poly))), sphere(DVec3::ZERO, 1.));
    assert!(meets(std::slice::from_ref(&rod), 0.9) && !meets(&[rod], 1.1));
    let roomy = bounded(sphere(DVec3::ZERO, 2.), cube(-3. * DVec3::ONE, 3. * DVec3::ONE));
    assert!(geometry(&[roomy]).parts().leaves[0].limits().is_none());
}

#[test]
fn points_know_what_they_are_inside_of() {
    let geometry = geometry(&[
        sphere(DVec3::ZERO, 2.),
        plane(DVec3::Y, 0.5),
        inverse(sphere(9. * DVec3::X, 1.)),
        difference([unit_box(), sphere(DVec3::ZERO, 0.5)]),
        triangle([DVec3::X, DVec3::Y, DVec3::Z]),
    ]);
    assert_eq!(geometry.containers(DVec3::ZERO).as_slice(), [0, 1, 2]);
    assert_eq!(geometry.containers(v(0.7, 0.7, 0.7)).as_slice(), [0, 2, 3]);
    assert_eq!(geometry.containers(9. * DVec3::X).as_slice(), [1]);
}

#[test]
fn shadow_rays_collect_transparent_surfaces_in_order_and_coincident_ones_once() {
    let glass = |at: f64| cube(v(-1., -1., at), v(1., 1., at + 1.));
    // Nothing is marked opaque before textures are compiled.
    let geometry = geometry(&[glass(4.), glass(1.), glass(2.), glass(1.)]);
    let mut through = Vec::new();
    assert_eq!(
        geometry.occluders(&Ray::new(DVec3::ZERO, DVec3::Z), Range { min: 0., max: 4.5 }, None, &mut through),
        None
    );
    let found: Vec<_> = through.iter().map(|hit| (hit.t, hit.object)).collect();
    assert_eq!(found, [(1., 1), (2., 1), (3., 2), (4., 0)]);
}

#[test]
fn linear_search_and_trees_give_bit_identical_hits() {
    let mut numbers = Numbers(11);
    let mut random = || {
        let at =
            Transform::rotate(180. * numbers.vector()).then(&Transform::translate(3. * numbers.vector()));
        let shape = match numbers.below(4) {
            0 => sphere(DVec3::ZERO, 0.4),
            1 => cube(v(-0.3, -0.3, -0.3), v(0.3, 0.3, 0.3)),
            2 => difference([sphere(DVec3::ZERO, 0.5), cylinder(-DVec3::Y, DVec3::Y, 0.3)]),
            _ => merge((0..9).map(|i| sphere(v(0.1 * f64::from(i), 0., 0.), 0.2))),
        };
        moved(shape, at)
    };
    let mut objects: Vec<_> = (0..200).map(|_| random()).collect();
    objects.extend(objects[..20].to_vec());
    objects.push(plane(DVec3::Y, -3.));
    let of = |accelerator| Geometry::new(flat(&objects, accelerator).parts, accelerator);
    let (linear, trees) = (of(Accelerator::Linear), [Accelerator::Octree, Accelerator::Bvh].map(of));
    let mut hits = 0;
    let (mut through, mut other) = (Vec::new(), Vec::new());
    for _ in 0..3000 {
        let ray = Ray::new(5. * numbers.vector(), numbers.vector().normalize());
        let found = linear.hit(&ray, Range::AHEAD, RayKind::IMAGE);
        for tree in &trees {
            assert_eq!(found, tree.hit(&ray, Range::AHEAD, RayKind::IMAGE));
            assert_eq!(
                linear.occluders(&ray, Range::AHEAD, None, &mut through).is_some(),
                tree.occluders(&ray, Range::AHEAD, None, &mut other).is_some()
            );
            assert_eq!(through, other);
            assert_eq!(linear.containers(ray.origin), tree.containers(ray.origin));
        }
        hits += usize::from(found.is_some());
    }
    assert!(hits > 1000, "{hits} hits");
}

#[test]
fn secondary_rays_leave_surfaces_without_meeting_them_again() {
    let mut numbers = Numbers(12);
    for scale in [1e-6, 1., 1e6] {
        for far in [0., 1e3] {
            let place = Transform::rotate(v(10., 20., 30.))
                .then(&Transform::scale(DVec3::splat(scale)))
                .then(&Transform::translate(scale * far * v(1., 2., 3.)));
            let shapes = [sphere(DVec3::ZERO, 1.), unit_box(), cylinder(-DVec3::Y, DVec3::Y, 1.)];
            for shape in shapes {
                let geometry = geometry(&[moved(shape, place)]);
                for _ in 0..300 {
                    let (from, to) = (4. * numbers.vector().normalize(), 0.9 * numbers.vector());
                    let (from, to) = (place.point(from), place.point(to));
                    let ray = Ray::new(from, (to - from).normalize());
                    let Some(hit) = geometry.hit(&ray, Range::AHEAD, RayKind::IMAGE) else { continue };
                    let surface = geometry.surface(&ray, &hit);
                    assert!(surface.error < 1e-9 * scale * (1. + 4. * far), "{}", surface.error);
                    let away = surface.normal + 0.99 * numbers.vector().normalize();
                    let start = surface.leave(away);
                    let again =
                        geometry.hit(&Ray::new(start, away.normalize()), Range::AHEAD, RayKind::IMAGE);
                    assert_eq!(again, None, "scale {scale}, {far} away");
                }
            }
        }
    }
}
