//! Whole cameras: statement to picture (docs/spec/camera-image.md 3, 6 and 8).

use povista::options::RenderOptions;

use crate::table::{picture, scene};

/// The colours of pixels of an 8x6 picture of the sky that shows directions.
fn sky(camera: &str, size: (u32, u32)) -> impl Fn((u32, u32)) -> [f32; 3] + use<> {
    let text = scene(&format!("{camera} DIRSKY"), "3.7");
    let image = picture(&text, &RenderOptions::new(size.0, size.1)).unwrap().image;
    move |(i, j)| {
        let [r, g, b, _] = image.pixels[(j * size.0 + i) as usize];
        [r, g, b]
    }
}

#[test]
fn focal_blur_takes_the_same_rays() {
    let rows = [
        (
            "aperture .4 focal_point 5*z blur_samples 3",
            [[0.26104, 0.66778, 0.90462], [0.44791, 0.56287, 0.99309], [0.74504, 0.32740, 0.89941]],
        ),
        (
            "aperture .4 focal_point 5*z blur_samples 4",
            [[0.26642, 0.66587, 0.90866], [0.44253, 0.55192, 0.99335], [0.73448, 0.31997, 0.90196]],
        ),
        (
            "aperture .4 focal_point 5*z blur_samples 7",
            [[0.26543, 0.67321, 0.90532], [0.44926, 0.55476, 0.99390], [0.73809, 0.32978, 0.90423]],
        ),
        (
            "aperture .4 focal_point 5*z blur_samples 10",
            [[0.26545, 0.67326, 0.90532], [0.44926, 0.55474, 0.99390], [0.73574, 0.33088, 0.90625]],
        ),
        (
            "aperture .8 focal_point 3*z blur_samples 19",
            [[0.26273, 0.67500, 0.90295], [0.45634, 0.54522, 0.99449], [0.73306, 0.33283, 0.90787]],
        ),
        (
            "aperture .8 focal_point 3*z blur_samples 30",
            [[0.26271, 0.67492, 0.90297], [0.45634, 0.54517, 0.99449], [0.73428, 0.33393, 0.90779]],
        ),
        (
            "aperture .5 focal_point 3*z blur_samples 60",
            [[0.26421, 0.66828, 0.90642], [0.45335, 0.54601, 0.99446], [0.73433, 0.33368, 0.90820]],
        ),
        (
            "aperture .5 focal_point 3*z blur_samples 60 variance 0",
            [[0.26368, 0.67015, 0.90527], [0.45235, 0.54795, 0.99434], [0.73262, 0.33529, 0.90982]],
        ),
        (
            "aperture .9 focal_point 3*z blur_samples 60 confidence .5 variance .01",
            [[0.26589, 0.67262, 0.90520], [0.44935, 0.55453, 0.99322], [0.73861, 0.33017, 0.90391]],
        ),
    ];
    for (blur, observed) in rows {
        let color = sky(&format!("camera{{{blur}}}"), (8, 6));
        for (pixel, observed) in [(0, 0), (3, 2), (7, 5)].into_iter().zip(observed) {
            let ours = color(pixel);
            let close = ours.iter().zip(observed).all(|(a, b)| (a - b).abs() < 4e-5);
            assert!(close, "{blur} {pixel:?}: {ours:?}, observed {observed:?}");
        }
    }
}

#[test]
fn a_camera_normal_bends_its_rays() {
    let rows = [
        ("camera{normal{gradient x 1}}", (0, 1), [-0.5615, 0.1026, 0.8210]),
        ("camera{normal{gradient x 1}}", (2, 1), [0.7865, 0.5936, 0.1704]),
        ("camera{normal{gradient x 1}}", (4, 1), [0.3529, 0.1160, 0.9284]),
        ("camera{normal{gradient x 1 scale .1}}", (0, 1), [0.7568, 0.6334, 0.1614]),
        ("camera{normal{gradient x 1 scale .1}}", (3, 1), [0.9359, -0.2993, 0.1857]),
    ];
    for (camera, pixel, observed) in rows {
        let ours = sky(camera, (5, 4))(pixel).map(|component| 2.0 * component - 1.0);
        let close = ours.iter().zip(observed).all(|(a, b): (&f32, f32)| (a - b).abs() < 2e-4);
        assert!(close, "{camera} {pixel:?}: {ours:?}, observed {observed:?}");
    }
}

#[test]
fn bokeh_places_rays_where_the_pigment_is_bright() {
    let rows = [
        ("rgb 1", [0.2968, 0.6311, 0.9266]),
        ("rgb .3", [0.2923, 0.6195, 0.9272]),
        ("rgb 0", [0.3122, 0.6359, 0.9297]),
        ("gradient x color_map{[0 rgb 0][1 rgb 1]}", [0.2710, 0.6256, 0.9166]),
        ("checker rgb 0 rgb 1 scale .5", [0.2998, 0.6345, 0.9216]),
    ];
    for (pigment, observed) in rows {
        let lens = "aperture 3 focal_point 3*z blur_samples 30 variance 0";
        let ours = sky(&format!("camera{{{lens} bokeh{{pigment{{{pigment}}}}}}}"), (4, 3))((0, 0));
        for (ours, observed) in ours.into_iter().zip(observed) {
            assert!((ours - observed).abs() < 1.01e-4, "{pigment}: {ours} not {observed}");
        }
    }
}

#[test]
fn a_mesh_camera_without_a_face_for_a_pixel_shows_black() {
    let mesh = "mesh{triangle{0,x,y} triangle{0,y,x}}";
    for (kind, faces) in [(0, [true, true, false, false]), (1, [true, true, false, false])] {
        let color = sky(&format!("camera{{mesh_camera{{1 {kind} {mesh}}}}}"), (2, 3));
        let seen = [(0, 0), (1, 1), (0, 2), (1, 2)].map(|pixel| color(pixel) != [0.0; 3]);
        assert_eq!(seen, faces, "type {kind}");
    }
}
