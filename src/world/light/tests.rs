//! The probe rows of docs/spec/shading.md 16, seen from points of the plane z = 5.

use super::*;
use crate::math::DVec2;

/// A white light at the origin that points along z.
pub(super) fn light(kind: Kind) -> Light {
    Light {
        kind,
        location: DVec3::ZERO,
        point_at: DVec3::Z * 5.0,
        axis: DVec3::Z,
        color: Rgb::ONE,
        parallel: false,
        fade: None,
        area: None,
        projected_through: None,
        shadowless: false,
        media_interaction: true,
        media_attenuation: false,
    }
}

/// The diffuse light on the plane z = 5 above x, as the probes see it.
fn on_floor(light: &Light, x: f64) -> f64 {
    let incident = light.reaching(DVec3::new(x, 0.0, 5.0));
    f64::from(incident.color.x) * -incident.direction.z
}

fn assert_rows(light: &Light, rows: &[(f64, f64)]) {
    for &(x, observed) in rows {
        let ours = on_floor(light, x);
        assert!((ours - observed).abs() < 2e-5, "x = {x}: {ours}, observed {observed}");
    }
}

#[test]
fn a_spotlight_dims_towards_its_edge() {
    let rows = [
        (0.0, 1.0),
        (2.5, 0.89442),
        (3.0, 0.85034),
        (3.5, 0.64797),
        (4.0, 0.34852),
        (4.9, 0.00415),
        (5.1, 0.0),
    ];
    assert_rows(&light(Kind::Spotlight(Spotlight::new(30.0, 45.0, 0.0))), &rows);
    let tight = light(Kind::Spotlight(Spotlight::new(10.0, 30.0, 5.0)));
    assert_rows(&tight, &[(1.0, 0.88569), (2.0, 0.34507)]);
    assert_rows(&light(Kind::Spotlight(Spotlight::new(0.0, 30.0, 0.0))), &[(2.0, 0.41715)]);
}

#[test]
fn a_falloff_smaller_than_the_radius_makes_a_hard_edge() {
    assert_rows(&light(Kind::Spotlight(Spotlight::new(40.0, 20.0, 0.0))), &[(3.0, 0.85750)]);
}

#[test]
fn a_parallel_spotlight_has_no_cone_but_a_back() {
    let beam = Light { parallel: true, ..light(Kind::Spotlight(Spotlight::new(10.0, 11.0, 0.0))) };
    assert_rows(&beam, &[(4.9, 1.0)]);
    assert_eq!(beam.reaching(beam.location - beam.axis + DVec3::X).attenuation, 0.0);
}

#[test]
fn a_cylinder_light_has_parallel_edges() {
    let plain = Cylinder { radius: 0.75, falloff: 1.0, tightness: 0.0 };
    let rows = [(0.5, 1.0), (0.8, 0.89599), (0.9, 0.352), (0.99, 0.00467), (1.1, 0.0)];
    assert_rows(&light(Kind::Cylinder(plain)), &rows);
    let soft = Cylinder { radius: 1.0, falloff: 3.0, tightness: 2.0 };
    assert_rows(&light(Kind::Cylinder(soft)), &[(0.5, 0.69444), (1.5, 0.21094), (2.0, 0.05556)]);
}

#[test]
fn a_fading_light_is_nominal_at_its_fade_distance() {
    let at = |distance, power| Light { fade: Some(Fade { distance, power }), ..light(Kind::Point) };
    assert_rows(&at(2.0, 3.0), &[(0.0, 0.12030)]);
    assert_rows(&Light { color: Rgb::splat(0.4), ..at(10.0, 1.0) }, &[(0.0, 0.53333)]);
}

#[test]
fn an_oriented_area_light_faces_the_point() {
    let grid = AreaLight {
        axes: [DVec3::X * 4.0, DVec3::Y * 2.0],
        size: [5, 5],
        adaptive: 100,
        jitter: false,
        circular: true,
        orient: true,
        area_illumination: false,
        plan: Plan::default(),
    };
    let direction = DVec3::new(1.0, 2.0, -2.0) / 3.0;
    let [a, b] = grid.axes_towards(direction);
    assert!(a.dot(direction).abs() < 1e-12 && b.dot(direction).abs() < 1e-12);
    assert!((a.length() - 4.0).abs() < 1e-12 && (b.length() - 2.0).abs() < 1e-12);
}

#[test]
fn a_circular_grid_stays_within_its_disc() {
    let grid = AreaLight {
        axes: [DVec3::X * 2.0, DVec3::Y * 2.0],
        size: [5, 5],
        adaptive: 100,
        jitter: false,
        circular: true,
        orient: false,
        area_illumination: false,
        plan: Plan::default(),
    };
    for u in 0..5 {
        for v in 0..5 {
            assert!(grid.offset(grid.axes, (u, v), DVec2::ZERO).length() < 1.003);
        }
    }
}
