//! The conformance probes of docs/spec/primitives.md 7, observed in POV-Ray.

use super::*;
use crate::math::{Band, Bounds, Lanes};
use crate::world::Inside;

const X: DVec3 = DVec3::X;
const Y: DVec3 = DVec3::Y;
const Z: DVec3 = DVec3::Z;

fn unit_box() -> Arc<Object> {
    cube(v(-1., -1., -1.), v(1., 1., 1.))
}

fn d1() -> Arc<Object> {
    difference([unit_box(), sphere(-Z, 0.5)])
}

fn du() -> Arc<Object> {
    difference([unit_box(), union([sphere(v(-0.5, 0., -1.), 0.4), sphere(v(0.5, 0., -1.), 0.4)])])
}

fn di() -> Arc<Object> {
    let rod = cube(v(-0.2, -0.2, -2.), v(0.2, 0.2, 0.));
    difference([unit_box(), intersection([sphere(-Z, 0.5), rod])])
}

fn ui() -> Arc<Object> {
    inverse(union([sphere(-X, 0.7), sphere(X, 0.7)]))
}

fn mc() -> Arc<Object> {
    merge([sphere(-0.4 * X, 0.7), sphere(0.4 * X, 0.7)])
}

fn cl() -> Arc<Object> {
    clipped(sphere(DVec3::ZERO, 1.), [plane(Y, 0.5), cube(v(-0.6, -2., -2.), v(2., 2., 2.))])
}

#[test]
fn a_disc_cuts_with_all_of_its_half_space() {
    let disc = object(Shape::Disc(Box::new(Disc { center: DVec3::ZERO, normal: Y, radius: 1.5, hole: 0. })));
    let dome = intersection([sphere(DVec3::ZERO, 1.), disc]);
    let probe = probe(&dome);
    let (point, normal) = probe.trace(-5. * Y, Y).unwrap();
    assert!(point.distance(-Y) < 1e-12 && normal.distance(-Y) < 1e-12, "{point} {normal}");
    let (point, _) = probe.trace(5. * Y, -Y).unwrap();
    assert!(point.length() < 1e-12, "{point}");
    assert!(probe.inside(-0.5 * Y) && !probe.inside(0.5 * Y));
}

#[test]
fn rays_hit_compounds_where_povray_says() {
    let dq = difference([unit_box(), quadric(DVec3::ONE, 2. * Z, 0.75)]);
    let dp = difference([sphere(DVec3::ZERO, 1.), plane(Z, -0.5)]);
    let dc = difference([unit_box(), cylinder(-2. * Z, -0.5 * Z, 0.3)]);
    #[rustfmt::skip]
    let hits = [
        ("D1", d1(), v(0., 0.1, -5.), Z, v(0., 0.1, -0.510102051443366), v(0., -0.2, -0.979795897113268)),
        ("D1", d1(), v(0., 0.8, -5.), Z, v(0., 0.8, -1.), -Z),
        ("DQ", dq, v(0., 0.1, -5.), Z, v(0., 0.1, -0.510102051443364), v(0., 0.2, 0.979795897113271)),
        ("DP", dp, v(0., 0.1, -5.), Z, v(0., 0.1, -0.5), -Z),
        ("DC", dc.clone(), v(0., 0.1, -5.), Z, v(0., 0.1, -0.5), -Z),
        ("DC", dc, v(0., 0., -0.7), Y, v(0., 0.3, -0.7), -Y),
        ("DU", du(), v(0.5, 0.1, -5.), Z, v(0.5, 0.1, -0.612701665379261), v(0., -0.25, -0.968245836551849)),
        ("DI", di(), v(0.1, 0., -5.), Z, v(0.1, 0., -0.510102051443366), v(-0.2, 0., -0.979795897113268)),
        ("UI", ui(), v(-1., 0., -3.), Z, v(-1., 0., -0.7), Z),
        ("MC", mc(), v(0.1, 0., 0.), X, v(1.1, 0., 0.), X),
        ("MC", mc(), v(-5., 0.1, 0.), X, v(-1.092820323027549, 0.1, 0.), v(-0.989743318610785, 0.142857142857143, 0.)),
        ("CL", cl(), v(0., 0.3, -5.), Z, v(0., 0.3, -0.953939201416945), v(0., 0.3, -0.953939201416945)),
        ("CL", cl(), v(0., 5., 0.), -Y, -Y, -Y),
    ];
    for (name, object, from, direction, point, normal) in hits {
        let (p, n) = probe(&object).trace(from, direction).unwrap_or_else(|| panic!("{name} is missed"));
        assert!(p.abs_diff_eq(point, 2e-14) && n.abs_diff_eq(normal, 1e-13), "{name}: {p} {n}");
    }
    assert_eq!(probe(&cl()).trace(v(0., 0.7, -5.), Z), None);
}

#[test]
fn points_are_inside_compounds_where_povray_says() {
    let eq = intersection([cylinder(-Z, Z, 1.), cylinder(-Z, Z, 1.)]);
    for (name, object, point, inside) in [
        ("D1", d1(), v(0., 0., -0.6), false),
        ("D1", d1(), v(0., 0., -0.4), true),
        ("D1", d1(), v(0., 0., -0.5), false),
        ("DU", du(), v(0.5, 0., -0.9), false),
        ("DI", di(), v(0.1, 0., -0.9), false),
        ("UI", ui(), v(-1., 0., 0.), false),
        ("UI", ui(), v(0., 0., 0.), true),
        ("EQ", eq, v(0., 0., 0.), true),
        ("MC", mc(), v(0., 0., 0.), true),
        ("CL", cl(), v(0., 0.7, 0.), false),
        ("CL", cl(), v(0., 0.3, 0.), true),
    ] {
        assert_eq!(probe(&object).inside(point), inside, "{name} at {point}");
    }
}

#[test]
fn bands_hold_what_is_inside_compounds() {
    let ring = moved(cylinder(-Z, Z, 1.), Transform::rotate(v(20., 30., 40.)));
    let eq = intersection([ring, quadric(v(1., 2., 1.), 0.1 * X, -1.)]);
    for (name, object) in
        [("D1", d1()), ("DU", du()), ("DI", di()), ("UI", ui()), ("EQ", eq), ("MC", mc()), ("CL", cl())]
    {
        let probe = probe(&object);
        let mut sure = [0; 2];
        for n in 0..2000_u32 {
            let at = |by: f64| (f64::from(n) * by).fract() * 3. - 1.5;
            let middle = v(at(0.819_172_513), at(0.671_043_607), at(0.549_700_478));
            let half = v(0.3, 0.2, -0.4) * 0.5_f64.powi(n as i32 % 12);
            let place = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(half[i])));
            let band = Inside::enclose(&probe, &place);
            for step in -4..=4 {
                let inside = f64::from(probe.inside(middle + 0.25 * f64::from(step) * half));
                assert!(
                    band.low().0[0] <= inside && inside <= band.high().0[0],
                    "{name} at {middle} ± {half}: {inside}, {band:?}"
                );
            }
            if let Some(inside) = band.fixed() {
                sure[inside as usize] += 1;
            }
        }
        assert!(sure[0] > 100 && sure[1] > 50 && sure[0] + sure[1] > 1500, "{name}: {sure:?}");
    }
}

#[test]
fn extents_are_those_povray_reports() {
    let dp = difference([sphere(DVec3::ZERO, 1.), plane(Z, -0.5)]);
    let turned = moved(plane(X, 0.5), Transform::rotate(90. * Z));
    let slabs = [(X, 1.), (-X, 2.), (Y, 3.), (-Y, 4.), (Z, 5.), (-Z, 6.)];
    let far = DVec3::splat(1e10);
    for (name, object, min, max) in [
        ("D1", d1(), -DVec3::ONE, DVec3::ONE),
        ("DP", dp, v(-1., -1., -1.), v(1., 1., 1.)),
        ("CL", cl(), -DVec3::ONE, DVec3::ONE),
        ("PTR", intersection([sphere(DVec3::ZERO, 2.), turned]), v(-2., -2., -2.), v(2., 0.5, 2.)),
        ("PL", intersection(slabs.map(|(n, d)| plane(n, d))), v(-2., -4., -6.), v(1., 3., 5.)),
        ("EM", intersection([sphere(DVec3::ZERO, 1.), sphere(5. * X, 1.)]), -far, far),
    ] {
        assert_eq!(probe(&object).bounds(), Bounds { min, max }, "{name}");
    }
}

#[test]
fn surfaces_without_inside_take_part_but_contain_nothing() {
    let front = triangle([v(-2., -2., -0.5), v(2., -2., -0.5), v(0., 3., -0.5)]);
    let outside = moved(front.clone(), Transform::translate(-2. * Z));
    let small = cube(DVec3::splat(-0.3), DVec3::splat(0.3));
    for (name, object, z) in [
        ("difference of box and triangle", difference([unit_box(), front.clone()]), -0.5),
        ("difference of triangle and box", difference([front.clone(), small]), -0.5),
        ("intersection of box and triangle", intersection([unit_box(), front.clone()]), -0.5),
        ("intersection with an inverted triangle", intersection([unit_box(), inverse(front.clone())]), -0.5),
        ("merge with a triangle inside", merge([front, unit_box()]), -1.),
        ("merge with a triangle outside", merge([outside, unit_box()]), -2.5),
    ] {
        let (point, _) = probe(&object).trace(-5. * Z, Z).unwrap();
        assert!((point.z - z).abs() < 1e-15, "{name}: {point}");
    }
}

#[test]
fn a_union_inside_an_intersection_keeps_its_inner_faces() {
    let object = intersection([
        union([sphere(DVec3::ZERO, 1.), sphere(0.5 * Z, 1.)]),
        cube(v(-1., -1., -0.7), v(1., 1., 2.)),
    ]);
    // From the gap between the first front and the second: the second sphere's front is inside the first.
    assert_eq!(probe(&object).trace(v(0., 0., -0.6), Z).unwrap().0.z, -0.5);
}

#[test]
fn clips_of_compounds_cut_the_whole() {
    let pair = union([sphere(-X, 0.5), sphere(X, 0.5)]);
    let half = probe(&clipped(pair, [plane(X, 0.)]));
    assert!(half.trace(v(-1., 0., -5.), Z).is_some() && half.inside(-X));
    assert!(half.trace(v(1., 0., -5.), Z).is_none() && !half.inside(X));
}

/// Checks that rays from one point to another meet two objects at the same places; how many meet any.
fn met_alike(both: &[Probe; 2], ways: impl Iterator<Item = [DVec3; 2]>) -> usize {
    let mut hits = 0;
    for [origin, to] in ways {
        let [one, two] = [&both[0], &both[1]].map(|probe| probe.trace(origin, to - origin));
        let (Some((p, n)), Some((q, m))) = (one, two) else {
            assert_eq!(one, two, "from {origin} to {to}");
            continue;
        };
        assert!(p.abs_diff_eq(q, 1e-12) && n.abs_diff_eq(m, 1e-11), "from {origin} to {to}: {p} {q}");
        hits += 1;
    }
    hits
}

#[test]
fn clips_cut_the_same_whatever_they_are_made_of() {
    let whole = cube(v(-0.6, -0.5, -2.), v(0.7, 0.4, 0.3));
    let halves =
        union([cube(v(-0.6, -0.5, -2.), v(0.2, 0.4, 0.3)), cube(v(0.1, -0.5, -2.), v(0.7, 0.4, 0.3))]);
    let bounded = clipped(sphere(0.3 * X, 0.8), [plane(Y, 0.2)]);
    let spread = union([sphere(-0.3 * X, 0.6), bounded, plane(v(0., 0.3, 1.), 0.1), d1()]);
    let mut numbers = Numbers(5);
    for original in [d1(), mc(), cl(), spread, sphere(DVec3::ZERO, 0.9)] {
        let both = [&whole, &halves].map(|clip| probe(&clipped(original.clone(), [clip.clone()])));
        let ways = (0..1000).map(|_| [3. * numbers.vector(), numbers.vector()]);
        let hits = met_alike(&both, ways);
        assert!(hits > 100, "{hits}");
    }
}

#[test]
fn a_ring_among_convex_solids_is_met_as_among_unions() {
    let ring = || moved(object(Shape::Torus { major: 0.7, minor: 0.3 }), Transform::rotate(40. * X));
    // A compound in their place asks for all crossings of the ring.
    let of_two =
        |solid: Arc<Object>| merge([solid.clone(), moved(solid, Transform::scale(DVec3::splat(0.9)))]);
    let corner = || cube(v(0., -2., -2.), v(2., 2., 0.1));
    let hole = || sphere(v(-0.5, 0.2, 0.1), 0.4);
    let slab = || cube(v(-2., -0.3, -2.), v(2., 0.5, 2.));
    let mut numbers = Numbers(11);
    for [simple, compound] in [
        [difference([ring(), corner()]), difference([ring(), of_two(corner())])],
        [
            difference([ring(), corner(), hole()]),
            difference([ring(), corner(), union([hole(), sphere(9. * X, 0.1)])]),
        ],
        [
            intersection([ring(), slab(), inverse(hole())]),
            intersection([ring(), union([slab(), sphere(9. * X, 0.1)]), inverse(hole())]),
        ],
    ] {
        let both = [probe(&simple), probe(&compound)];
        let ways = (0..3000).map(|_| [1.5 * numbers.vector(), numbers.vector()]);
        let hits = met_alike(&both, ways);
        assert!(hits > 800, "{hits}");
    }
}

#[test]
fn planes_around_a_box_are_met_as_the_box_is() {
    let by = Transform::rotate(v(10., 20., 30.)).then(&Transform::translate(v(0.1, -0.2, 0.3)));
    let planes = || [X, -X, Y, -Y, Z].map(|normal| plane(normal, 0.7)).into_iter();
    let hollow = || sphere(0.4 * X, 0.5);
    let cuboid = || cube(DVec3::splat(-0.7), DVec3::splat(0.7));
    let solid = intersection(planes().chain([inverse(plane(Z, -0.7))]));
    let bored = intersection(planes().chain([inverse(hollow()), inverse(plane(Z, -0.7))]));
    for (of_planes, of_box) in [(solid, cuboid()), (bored, difference([cuboid(), hollow()]))] {
        for by in [Transform::IDENTITY, by] {
            let both = [&of_planes, &of_box].map(|object| probe(&moved(object.clone(), by)));
            let mut numbers = Numbers(7);
            let ways = (0..2000).map(|turn| {
                let (origin, to) = (2. * numbers.vector(), numbers.vector());
                // Rays along axes are parallel to planes.
                if turn % 4 == 0 { [by.point(origin), by.point(origin.with_x(to.x))] } else { [origin, to] }
            });
            let hits = met_alike(&both, ways);
            assert!(hits > 400, "{hits}");
        }
    }
}

#[test]
fn transforms_of_compounds_reach_members_and_clips() {
    let by = Transform::rotate(v(10., 20., 30.))
        .then(&Transform::scale(v(2., 0.5, 3.)))
        .then(&Transform::translate(v(4., 5., 6.)));
    for original in [d1(), du(), di(), mc(), cl()] {
        let (plain, placed) = (probe(&original), probe(&moved(original.clone(), by)));
        let mut numbers = Numbers(3);
        for _ in 0..200 {
            let (origin, direction) = (3. * numbers.vector(), numbers.vector());
            let direction = direction - origin;
            let (there, along) = (by.point(origin), by.vector(direction));
            match (plain.trace(origin, direction), placed.trace(there, along)) {
                (Some((p, _)), Some((q, _))) => assert!(by.point(p).abs_diff_eq(q, 1e-11), "{p} {q}"),
                (a, b) => assert_eq!(a.is_some(), b.is_some(), "from {origin} to {direction}"),
            }
        }
    }
}
