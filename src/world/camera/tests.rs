//! The probe rows of docs/spec/camera-image.md 3 and 4: directions through pixels of an 8x6 picture.

use super::*;
use crate::math::DVec3;

fn frame(right: f64, up: f64, direction: f64) -> Frame {
    Frame {
        location: DVec3::ZERO,
        right: DVec3::X * right,
        up: DVec3::Y * up,
        direction: DVec3::Z * direction,
    }
}

fn through(projection: &Projection, (i, j): (u32, u32)) -> Option<DVec3> {
    let film = film(f64::from(i), f64::from(j), 8, 6);
    Some(projection.project(film)?.ray.direction.normalize())
}

fn assert_rows(projection: Projection, rows: &[((u32, u32), [f64; 3])]) {
    for &(pixel, observed) in rows {
        let ours = through(&projection, pixel).unwrap_or(DVec3::ZERO);
        let close = ours.abs_diff_eq(DVec3::from_array(observed), 1.01e-4);
        assert!(close, "{projection:?} {pixel:?}: {ours}, observed {observed:?}");
    }
}

#[test]
fn perspective() {
    let rows = [((0, 0), [-0.4732, 0.3388, 0.8132]), ((7, 5), [0.4732, -0.3388, 0.8132])];
    assert_rows(Projection::Perspective(Perspective { frame: frame(1.33, 1.0, 1.0) }), &rows);
}

#[test]
fn fisheye() {
    let default = || Projection::Fisheye(Fisheye::new(&frame(1.33, 1.0, 1.0), 90.0));
    assert_rows(default(), &[((2, 1), [-0.3719, 0.3729, 0.8501]), ((4, 2), [0.1298, 0.1301, 0.9830])]);
    assert_eq!(through(&default(), (0, 0)), None);
    let half = || Projection::Fisheye(Fisheye::new(&frame(1.0, 1.0, 1.0), 180.0));
    assert_rows(half(), &[((1, 1), [-0.7428, 0.5942, 0.3084]), ((3, 0), [-0.1438, 0.9589, 0.2446])]);
    assert_eq!(through(&half(), (0, 0)), None);
    let small = Projection::Fisheye(Fisheye::new(&frame(0.5, 0.7, 1.0), 180.0));
    assert_rows(small, &[((0, 0), [-0.5465, 0.7287, 0.4127])]);
}

#[test]
fn ultra_wide_angle() {
    let rows = [((0, 0), [-0.7622, 0.6225, 0.1778]), ((6, 4), [0.7151, -0.4679, 0.5193])];
    let camera = UltraWideAngle::new(&frame(1.33, 1.0, 1.0), 160.0);
    assert_rows(Projection::UltraWideAngle(camera), &rows);
}

#[test]
fn omnimax() {
    let rows = [
        ((2, 1), [-0.4621, 0.7259, 0.5093]),
        ((4, 3), [0.1810, 0.1272, 0.9752]),
        ((4, 5), [0.1700, -0.5622, 0.8093]),
    ];
    assert_rows(Projection::Omnimax(Omnimax::new(&frame(1.33, 1.0, 1.0))), &rows);
    let rows = [((3, 0), [-0.1404, 0.9359, 0.3231]), ((5, 3), [0.4974, -0.2211, 0.8389])];
    assert_rows(Projection::Omnimax(Omnimax::new(&frame(1.0, 1.0, 1.0))), &rows);
}

#[test]
fn panoramic() {
    let rows = [((0, 0), [-0.3295, 0.9428, 0.0493]), ((5, 2), [0.6458, 0.2342, 0.7267])];
    assert_rows(Projection::Panoramic(Panoramic { frame: frame(1.33, 1.0, 1.0) }), &rows);
    let rows = [((0, 0), [-0.1722, 0.9827, 0.0685]), ((5, 2), [0.3089, 0.2234, 0.9245])];
    assert_rows(Projection::Panoramic(Panoramic { frame: frame(2.0, 3.0, 4.0) }), &rows);
}

#[test]
fn cylinder_of_every_kind() {
    let rows = [
        (1, [-0.7527, 0.3162, 0.5775]),
        (2, [-0.5487, 0.6404, 0.5374]),
        (3, [-0.7934, 0.0, 0.6088]),
        (4, [0.0, 0.7660, 0.6428]),
    ];
    for (kind, observed) in rows {
        let camera = Cylinder::new(&frame(1.5, 0.8, 1.0), kind, 120.0);
        assert_rows(Projection::Cylinder(camera), &[((0, 0), observed)]);
    }
}

#[test]
fn spherical() {
    let camera = |horizontal, vertical| {
        Projection::Spherical(Spherical::new(&frame(1.33, 1.0, 1.0), horizontal, vertical))
    };
    let rows = [((0, 0), [-0.0990, 0.9659, -0.2391]), ((5, 2), [0.8924, 0.2588, 0.3696])];
    assert_rows(camera(360.0, 180.0), &rows);
    assert_rows(camera(120.0, 60.0), &[((0, 0), [-0.7190, 0.4226, 0.5517])]);
    assert_rows(camera(120.0, 100.0), &[((0, 0), [-0.5926, 0.6648, 0.4548])]);
}
