//! The probe rows of docs/spec/camera-image.md 9: hard stripes on the sky over 13x9 pixels.

use super::*;
use crate::math::DVec3;
use crate::world::camera::{Frame, Perspective, film};

/// The probe scene's colour through a place on the film: a function of the ray's direction.
fn stripes(x: f64, y: f64) -> Sample {
    let frame = Frame { location: DVec3::ZERO, right: DVec3::X * 1.33, up: DVec3::Y, direction: DVec3::Z };
    let ray = Perspective { frame }.project(film(x, y, 13, 9)).ray;
    let d = ray.direction.normalize();
    let stripe = (20.0 * d.x + 13.0 * d.y + 1.0).sin() < 0.0;
    let value = if stripe { 0.1 } else { 0.1 + d.x * d.x * 0.9 + 0.05 } as f32;
    [value, 0.7 * value, 0.4 * value, 0.0]
}

/// The red of row 4 when the picture is rendered in blocks of `edge`.
fn row(antialias: Option<Antialias>, edge: u32) -> Vec<f32> {
    let mut reds = vec![0.0; 13];
    for top in (0..9).step_by(edge as usize) {
        for left in (0..13).step_by(edge as usize) {
            let region = Region { columns: left..(left + edge).min(13), rows: top..(top + edge).min(9) };
            let options = RenderOptions { antialias, ..RenderOptions::new(13, 9) };
            let pixels = block(&region, &options, Some(Gamma::LINEAR), &mut stripes);
            for (index, pixel) in pixels.iter().enumerate() {
                let width = region.columns.len();
                if top as usize + index / width == 4 {
                    reds[left as usize + index % width] = pixel[0];
                }
            }
        }
    }
    reds
}

fn assert_row(antialias: Option<Antialias>, edge: u32, observed: [f32; 13]) {
    let ours = row(antialias, edge);
    let close = ours.iter().zip(observed).all(|(a, b)| (a - b).abs() < 1.5e-4);
    assert!(close, "{antialias:?}\n{ours:?}\n{observed:?}");
}

fn on(threshold: f32) -> Antialias {
    Antialias { threshold, ..Antialias::default() }
}

fn adaptively(threshold: f32) -> Antialias {
    Antialias { method: AntialiasMethod::Adaptive, ..on(threshold) }
}

#[test]
fn without_antialiasing_a_pixel_is_its_middle() {
    let observed = [
        0.3963, 0.1000, 0.1000, 0.2275, 0.1000, 0.1000, 0.1500, 0.1593, 0.1000, 0.2275, 0.2791, 0.1000,
        0.1000,
    ];
    assert_row(None, 13, observed);
}

#[test]
fn method_1_refines_pixels_unlike_their_neighbours() {
    let observed = [
        0.2814, 0.1000, 0.1501, 0.2293, 0.1289, 0.1000, 0.1500, 0.1593, 0.1000, 0.2177, 0.2420, 0.1431,
        0.1000,
    ];
    assert_row(Some(on(0.3)), 13, observed);
    let unjittered = [
        0.3113, 0.1000, 0.1501, 0.2278, 0.1382, 0.1054, 0.1455, 0.1341, 0.1000, 0.2053, 0.2594, 0.1217,
        0.1000,
    ];
    assert_row(Some(Antialias { jitter: 0.0, ..on(0.1) }), 13, unjittered);
}

#[test]
fn method_1_takes_depth_squared_samples() {
    let two = [
        0.2807, 0.1000, 0.1341, 0.2342, 0.1199, 0.1106, 0.1507, 0.1230, 0.1000, 0.2019, 0.2425, 0.1420,
        0.1000,
    ];
    assert_row(Some(Antialias { depth: 2, ..on(0.1) }), 13, two);
    let one = [
        0.2482, 0.1000, 0.1000, 0.2254, 0.1515, 0.1000, 0.1506, 0.1560, 0.1000, 0.2379, 0.2848, 0.1000,
        0.1000,
    ];
    assert_row(Some(Antialias { depth: 1, ..on(0.1) }), 13, one);
    let all = [
        0.2792, 0.1000, 0.1589, 0.2273, 0.1445, 0.1031, 0.1477, 0.1334, 0.1000, 0.2076, 0.2677, 0.1250,
        0.1000,
    ];
    assert_row(Some(Antialias { depth: 4, jitter: 0.5, ..on(0.0) }), 13, all);
}

#[test]
fn method_1_compares_in_the_space_of_the_antialias_gamma_and_within_blocks() {
    let observed = [
        0.2814, 0.1000, 0.1501, 0.2293, 0.1289, 0.1000, 0.1458, 0.1339, 0.1000, 0.2177, 0.2420, 0.1431,
        0.1000,
    ];
    assert_row(Some(Antialias { gamma: 1.0, ..on(0.05) }), 13, observed);
    assert_row(Some(on(0.1)), 4, observed);
}

#[test]
fn method_2_splits_pixels_whose_corners_differ() {
    let observed = [
        0.2673, 0.1042, 0.1655, 0.2259, 0.1377, 0.1131, 0.1393, 0.1262, 0.1050, 0.2053, 0.2641, 0.1367,
        0.1051,
    ];
    assert_row(Some(adaptively(0.3)), 13, observed);
    assert_row(Some(adaptively(0.3)), 5, observed);
    let unjittered = [
        0.2855, 0.1042, 0.1593, 0.2256, 0.1385, 0.1042, 0.1454, 0.1300, 0.1049, 0.2049, 0.2636, 0.1370,
        0.1051,
    ];
    assert_row(Some(Antialias { jitter: 0.0, ..adaptively(0.1) }), 13, unjittered);
    let deep = [
        0.2659, 0.1010, 0.1566, 0.2276, 0.1403, 0.1052, 0.1461, 0.1319, 0.1028, 0.2016, 0.2613, 0.1294,
        0.1013,
    ];
    assert_row(Some(Antialias { depth: 4, ..adaptively(0.05) }), 13, deep);
    let corners = [
        0.3292, 0.1665, 0.1380, 0.1906, 0.1525, 0.1131, 0.1393, 0.1262, 0.1263, 0.2023, 0.2278, 0.1518,
        0.1813,
    ];
    assert_row(Some(Antialias { depth: 1, ..adaptively(0.05) }), 13, corners);
}
