//! Needs POV-Ray's fonts: Debian's povray-includes.

use std::path::Path;
use std::sync::Arc;

use super::*;
use crate::compile::probe::Probe;
use crate::scene::settings::Settings;
use crate::scene::{Object, Shape};

fn font(name: &str) -> Font {
    Font::File(name.to_owned(), Path::new("/usr/share/povray-3.7/include").join(name))
}

fn object(font: Font, letters: &str, thickness: f64, offset: [f64; 3]) -> Arc<Object> {
    let text = letters.encode_utf16().collect();
    let text = scene::Text { font, text, thickness, offset: offset.into(), unicode: false };
    Arc::new(Object::new(Span::default(), Shape::Text(Arc::new(text))))
}

fn probe(name: &str, letters: &str, thickness: f64, offset: [f64; 3]) -> Probe {
    Probe::new(&object(font(name), letters, thickness, offset), &Settings::default())
        .expect("install povray-includes")
}

#[track_caller]
fn extent(probe: &Probe, min: [f64; 3], max: [f64; 3]) {
    let Bounds { min: low, max: high } = probe.bounds();
    assert!(low.abs_diff_eq(min.into(), 1e-6) && high.abs_diff_eq(max.into(), 1e-6), "{low} .. {high}");
}

/// Checks where a ray hits, and the normal there.
#[track_caller]
fn hits(probe: &Probe, from: [f64; 3], direction: [f64; 3], point: [f64; 3], normal: [f64; 3]) {
    let (at, outward) = probe.trace(from.into(), direction.into()).expect("a hit");
    assert!(at.abs_diff_eq(point.into(), 1e-9) && outward.abs_diff_eq(normal.into(), 1e-9), "{at} {outward}");
}

const EAST: [f64; 3] = [1., 0., 0.];
const NORTH: [f64; 3] = [0., 0., 1.];

#[test]
fn letters_are_where_povray_has_them() {
    let a = probe("timrom.ttf", "A", 0.3, [0.; 3]);
    assert_eq!(a.trace(DVec3::new(0.15, 0.1, -5.), DVec3::Z), None);
    assert_eq!(a.trace(DVec3::new(0.36, 0.3, -5.), DVec3::Z), None);
    hits(
        &a,
        [0.6, 0.1, -5.],
        NORTH,
        [0.6, 0.1, -0.000008726859491],
        [-0.000017453597131, 0.000017452987899, -0.999999999695383],
    );
    hits(
        &a,
        [0.12, 0.04, 0.1],
        EAST,
        [0.144435049743801, 0.04, 0.1],
        [-0.809530514062637, -0.587077803009452, 0.000003882957667],
    );
    hits(
        &a,
        [-5., 0.2, 0.15],
        EAST,
        [0.136946593650172, 0.2, 0.15],
        [0.918828857144794, -0.394656218438839, -0.000022924798917],
    );
    assert!(a.inside(DVec3::new(0.6, 0.1, 0.1)));
    assert!(!a.inside(DVec3::new(0.6, 0.1, 0.31)));
}

#[test]
fn lines_are_spaced_and_kerned_as_povray_does() {
    let line = probe("timrom.ttf", "AVA i", 0.3, [0.1, 0., 0.]);
    let lean = [0.918828857144794, -0.394656218438839, -0.000022924798917];
    hits(&line, [-5., 0.3, 0.15], EAST, [0.179898685910881, 0.3, 0.15], lean);
    hits(
        &line,
        [0.8, 0.3, 0.15],
        EAST,
        [0.879750388980445, 0.3, 0.15],
        [0.917210334803669, 0.398403315306666, -0.00000905529143],
    );
    hits(&line, [1.4, 0.3, 0.15], EAST, [1.516888663192713, 0.3, 0.15], lean);
    let upright = [0.999999999695383, 0.000017453292516, -0.000017453292519];
    hits(&line, [2.3, 0.3, 0.15], EAST, [2.637997382809703, 0.3, 0.15], upright);
    let stairs = probe("cyrvetic.ttf", "Hi", 0.3, [0., 0.2, 0.1]);
    hits(&stairs, [-5., 0.3, 0.1], EAST, [-0.000003490658504, 0.3, 0.1], upright);
    assert_eq!(stairs.trace(DVec3::new(1., 0.4, 0.1), DVec3::X), None);
}

#[test]
fn pairs_are_kerned_in_whatever_order_the_font_lists_them() {
    let line = probe("timrom.ttf", "Te", 1., [0.; 3]);
    let bow = line.trace(DVec3::new(0.5, 0.2, 0.5), DVec3::X).expect("a hit").0;
    assert!((bow.x - 0.570330).abs() < 1e-6, "{bow}");
}

#[test]
fn curves_are_where_povray_has_them() {
    let from = [-5., 0.3, 0.5];
    for (name, x, normal) in [
        ("timrom.ttf", 0.03304914959485, [0.999735280778877, 0.023008000246977, -0.000017047418484]),
        ("cyrvetic.ttf", 0.001257206883556, [0.997034420985307, -0.076956890653923, -0.000018744964797]),
        ("crystal.ttf", 0.000816311700565, [0.998836823797651, -0.048218244387893, -0.000018274847964]),
    ] {
        hits(&probe(name, "g", 1., [0.; 3]), from, EAST, [x, 0.3, 0.5], normal);
    }
    assert!(!probe("timrom.ttf", "g", 1., [0.; 3]).inside(DVec3::new(0.2, 0.3, 0.5)));
}

#[test]
fn extents_hold_the_points_and_the_box_the_font_tells() {
    for (name, letters, depth, offset, min, max) in [
        (
            "timrom.ttf",
            "AVA i",
            0.3,
            [0.1, 0., 0.],
            [-0.000012147243979, -0.016005236655474, -0.000050026297686],
            [2.793005466461182, 0.696048736572266, 0.300013154745102],
        ),
        (
            "cyrvetic.ttf",
            "Hi",
            0.3,
            [0., 0.2, 0.1],
            [-0.000016198833691, -0.000005235914159, -0.000014875367924],
            [0.795005261898041, 0.928013861179352, 0.300017207860947],
        ),
        // A box the font tells too wide for the points.
        (
            "timrom.ttf",
            "ij",
            1.,
            [10., 0., 0.],
            [-0.000012146924746, -0.212017446756363, -0.000188099278603],
            [10.508020401000977, 0.696183443069458, 1.000013113021851],
        ),
        (
            "crystal.ttf",
            "g",
            1.,
            [0.; 3],
            [-0.000009493488506, -0.200212761759758, -0.000011507768249],
            [0.401876389980316, 0.543952286243439, 1.00001049041748],
        ),
    ] {
        extent(&probe(name, letters, depth, offset), min, max);
    }
}

#[test]
fn fonts_that_cannot_be_used_are_named() {
    let message = |font: Font| {
        let errors = Probe::new(&object(font, "A", 1., [0.; 3]), &Settings::default()).unwrap_err();
        errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    let broken = Font::File("Cargo.toml".into(), Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml"));
    assert!(message(broken).starts_with("cannot read the font `Cargo.toml`: "));
    assert_eq!(
        message(Font::Internal(1, None)),
        "not supported yet: internal fonts without POV-Ray's font files"
    );
}
