//! POV-Ray's method 1 (docs/spec/camera-image.md 9.1).

use super::{Contrast, Look, Sample, Seen, each};
use crate::math::DVec2;
use crate::options::{Antialias, Region};
use crate::render::jitter::jitter;

/// A pixel of method 1.
#[derive(Clone, Copy)]
struct Pixel {
    seen: Seen,
    refined: bool,
}

/// Method 1: a pixel unlike its left or upper neighbour is sampled on a grid, and so is that
/// neighbour.
pub(super) fn neighbours(
    block: &Region,
    antialias: &Antialias,
    contrast: &Contrast,
    look: &mut dyn Look,
) -> Vec<Sample> {
    let (left, top) = (f64::from(block.columns.start), f64::from(block.rows.start));
    let width = block.columns.len();
    let at = |look: &mut dyn Look, x: f64, y: f64| look.at(DVec2::new(x, y));
    let pixel = |color, refined| Pixel { seen: contrast.seen(color), refined };
    // Neighbours outside the block are sampled, compared with and never refined.
    let mut above: Vec<Pixel> =
        (0..width).map(|i| pixel(at(look, left + i as f64, top - 1.0), true)).collect();
    let mut pixels = Vec::with_capacity(width * block.rows.len());
    for row in 0..block.rows.len() {
        let y = top + row as f64;
        let mut before = pixel(at(look, left - 1.0, y), true);
        for column in 0..width {
            let x = left + column as f64;
            let mut here = pixel(at(look, x, y), false);
            let unlike_left = contrast.differ(&here.seen, &before.seen);
            let unlike_top = contrast.differ(&here.seen, &above[column].seen);
            if unlike_left && !before.refined {
                before = pixel(refine(before.seen.color, x - 1.0, y, antialias, look), true);
                above[column - 1] = before;
            }
            if unlike_top && !above[column].refined {
                let refined = refine(above[column].seen.color, x, y - 1.0, antialias, look);
                pixels[(row - 1) * width + column] = refined;
            }
            if unlike_left || unlike_top {
                here = pixel(refine(here.seen.color, x, y, antialias, look), true);
            }
            if column > 0 {
                pixels[row * width + column - 1] = before.seen.color;
            }
            pixels.push(here.seen.color);
            above[column] = here;
            before = here;
        }
    }
    pixels
}

/// The mean of a pixel's centre and a grid of samples.
fn refine(center: Sample, x: f64, y: f64, antialias: &Antialias, look: &mut dyn Look) -> Sample {
    let depth = antialias.depth;
    let offset = |index: u32| (f64::from(index) + 0.5) / f64::from(depth) - 0.5;
    let spread = f64::from(antialias.jitter) / f64::from(depth);
    let mut sum = center;
    let places = (0..depth).flat_map(|b| (0..depth).map(move |a| (b, a))).map(|(b, a)| {
        let place = DVec2::new(x + offset(a), y + offset(b));
        let moved = if spread > 0.0 { jitter(place.x, place.y) * spread } else { DVec2::ZERO };
        (place + moved, ())
    });
    each(look, places, |color, ()| sum = std::array::from_fn(|i| sum[i] + color[i]));
    let count = (depth * depth + 1) as f32;
    sum.map(|component| component / count)
}
