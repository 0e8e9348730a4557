//! Pictures of which the exact pixels are known.

use super::*;
use crate::options::Antialias;

/// The red of 16 × 16 pixels of a picture in light, and how many samples they took.
fn reds(error: f32, picture: impl Fn(f64, f64) -> f32) -> (Vec<f32>, u32) {
    let mut asked = 0;
    let mut look = |x: f64, y: f64| {
        asked += 1;
        [picture(x, y); 4]
    };
    let contrast = Contrast::new(&Antialias::default(), Some(Gamma::LINEAR));
    let block = Region { columns: 0..16, rows: 0..16 };
    let aim = Aim::new(error, 1024, Some(Gamma::LINEAR));
    let pixels = edges(&block, &aim, 0, &contrast, &mut look);
    (pixels.iter().map(|pixel| pixel[0]).collect(), asked)
}

/// The errors of pixels, beside means of 64 × 64 samples of each.
fn errors(pixels: &[f32], picture: impl Fn(f64, f64) -> f32) -> Vec<f32> {
    let exact = |number: usize| {
        let at = |place: usize, fine: usize| (place as f64) + (fine as f64 + 0.5) / 64.0 - 0.5;
        let places = (0..64 * 64).map(|fine| (at(number % 16, fine % 64), at(number / 16, fine / 64)));
        places.map(|(x, y)| picture(x, y)).sum::<f32>() / (64.0 * 64.0)
    };
    pixels.iter().enumerate().map(|(number, red)| (red - exact(number)).abs()).collect()
}

fn worst(pixels: &[f32], picture: impl Fn(f64, f64) -> f32) -> f32 {
    errors(pixels, picture).into_iter().fold(0.0, f32::max)
}

/// Middles and corners.
const LEAST: u32 = 16 * 16 + 17 * 17;

#[test]
fn what_changes_evenly_takes_middles_and_corners_and_is_exact() {
    let slope = |x: f64, y: f64| (0.3 + 0.01 * x + 0.02 * y) as f32;
    let (pixels, asked) = reds(1.0, slope);
    assert_eq!(asked, LEAST);
    assert!(worst(&pixels, slope) < 1e-6);
}

#[test]
fn few_samples_find_an_edge_to_a_hundredth_of_a_pixel() {
    let edge = |x: f64, y: f64| if x < 6.3 + 0.37 * y { 0.0 } else { 1.0 };
    let (pixels, asked) = reds(1.0, edge);
    assert!(worst(&pixels, edge) < 0.02, "{}", worst(&pixels, edge));
    // 22 pixels, each with an edge on two sides.
    assert!(asked < LEAST + 22 * 16, "{asked}");
}

#[test]
fn round_edges_and_corners_are_as_exact_as_asked() {
    let disc = |x: f64, y: f64| if (x - 7.8).hypot(y - 7.1) < 5.3 { 0.9 } else { 0.1 };
    let corner = |x: f64, y: f64| if x > 4.2 && y > 0.4 * x + 1.3 { 1.0 } else { 0.2 };
    let both: [&dyn Fn(f64, f64) -> f32; 2] = [&disc, &corner];
    for picture in both {
        let worsts = [16.0, 1.0].map(|error| worst(&reds(error, picture).0, picture));
        assert!(worsts[0] < 0.2 && worsts[1] < 0.02, "{worsts:?}");
    }
}

#[test]
fn what_is_thinner_than_a_pixel_is_followed_from_one_to_the_next() {
    // It passes through two middles, and between all other corners and middles.
    let line = |x: f64, y: f64| if (y - 5.0 - 0.04 * (x - 8.0)).abs() < 0.05 { 1.0 } else { 0.0 };
    let (pixels, _) = reds(1.0, line);
    assert!(worst(&pixels, line) < 0.06, "{}", worst(&pixels, line));
}

#[test]
fn over_what_is_finer_than_pixels_samples_are_spread() {
    let noise = |x: f64, y: f64| if (31.7 * x).sin() * (27.3 * y).sin() > 0.0 { 1.0 } else { 0.0 };
    let (pixels, asked) = reds(8.0, noise);
    let errors = errors(&pixels, noise);
    let mean = errors.iter().sum::<f32>() / errors.len() as f32;
    assert!(mean < 0.06, "{mean}");
    assert!(asked < 16 * 16 * 96, "{asked}");
}

#[test]
fn a_strip_between_two_colours_is_not_taken_for_one_of_them() {
    let strip = |x: f64, y: f64| {
        let across = x - 7.7 - 0.04 * y;
        match () {
            () if across < 0.0 => 0.6,
            () if across < 0.1 => 0.1,
            () => 0.4,
        }
    };
    let (pixels, _) = reds(1.0, strip);
    assert!(worst(&pixels, strip) < 0.01, "{}", worst(&pixels, strip));
}
