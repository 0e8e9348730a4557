//! Antialiasing: which places of a block are sampled and how pixels come of them
//! (docs/spec/camera-image.md 9).
//!
//! A block is finished by one thread from its own samples alone, so threads never matter; blocks
//! do, in method 1.

use rustc_hash::FxHashMap;

use super::jitter::jitter;
use crate::math::gamma::Gamma;
use crate::options::{Antialias, AntialiasMethod, Region};

/// Red, green, blue and transmit of a sample.
pub type Sample = [f32; 4];

/// Colours the pixels of `block`, row by row, from samples at image coordinates.
///
/// `working` is the space of the colours; `None` in old scenes, which have none.
pub(super) fn block(
    block: &Region,
    antialias: Option<&Antialias>,
    working: Option<Gamma>,
    sample: &mut dyn FnMut(f64, f64) -> Sample,
) -> Vec<Sample> {
    let Some(antialias) = antialias else {
        let pixels = block.rows.clone().flat_map(|y| block.columns.clone().map(move |x| (x, y)));
        return pixels.map(|(x, y)| sample(f64::from(x), f64::from(y))).collect();
    };
    let contrast = Contrast::new(antialias, working);
    match antialias.method {
        AntialiasMethod::Neighbours => neighbours(block, antialias, &contrast, sample),
        AntialiasMethod::Adaptive => adaptive(block, antialias, &contrast, sample),
    }
}

/// When two samples count as different.
struct Contrast {
    threshold: f32,
    working: Option<Gamma>,
    /// Exponent of the space they are compared in; `None` compares light.
    exponent: Option<f32>,
}

impl Contrast {
    fn new(antialias: &Antialias, working: Option<Gamma>) -> Self {
        let gamma = Gamma::Power(antialias.gamma);
        Self {
            threshold: antialias.threshold,
            working,
            exponent: (antialias.gamma > 0.0 && !gamma.is_linear()).then(|| antialias.gamma.recip()),
        }
    }

    fn perceived(&self, component: f32) -> f32 {
        let light = self.working.map_or(component, |gamma| gamma.decode(component));
        self.exponent.map_or(light, |exponent| light.max(0.0).powf(exponent))
    }

    fn seen(&self, color: Sample) -> Seen {
        let [r, g, b, transmit] = color;
        Seen { color, perceived: [self.perceived(r), self.perceived(g), self.perceived(b), transmit] }
    }

    fn differ(&self, a: &Seen, b: &Seen) -> bool {
        let (a, b) = (a.perceived, b.perceived);
        let colors: f32 = (0..3).map(|i| (a[i] - b[i]).abs()).sum();
        colors + (a[3] - b[3]).abs() >= self.threshold
    }
}

/// A sample, and as it is compared with others: often, so that is worked out once.
#[derive(Clone, Copy)]
struct Seen {
    color: Sample,
    perceived: Sample,
}

/// A pixel of method 1.
#[derive(Clone, Copy)]
struct Pixel {
    seen: Seen,
    refined: bool,
}

/// Method 1: a pixel unlike its left or upper neighbour is sampled on a grid, and so is that
/// neighbour.
fn neighbours(
    block: &Region,
    antialias: &Antialias,
    contrast: &Contrast,
    sample: &mut dyn FnMut(f64, f64) -> Sample,
) -> Vec<Sample> {
    let (left, top) = (f64::from(block.columns.start), f64::from(block.rows.start));
    let width = block.columns.len();
    let pixel = |color, refined| Pixel { seen: contrast.seen(color), refined };
    // Neighbours outside the block are sampled, compared with and never refined.
    let mut above: Vec<Pixel> = (0..width).map(|i| pixel(sample(left + i as f64, top - 1.0), true)).collect();
    let mut pixels = Vec::with_capacity(width * block.rows.len());
    for row in 0..block.rows.len() {
        let y = top + row as f64;
        let mut before = pixel(sample(left - 1.0, y), true);
        for column in 0..width {
            let x = left + column as f64;
            let mut here = pixel(sample(x, y), false);
            let unlike_left = contrast.differ(&here.seen, &before.seen);
            let unlike_top = contrast.differ(&here.seen, &above[column].seen);
            if unlike_left && !before.refined {
                before = pixel(refine(before.seen.color, x - 1.0, y, antialias, sample), true);
                above[column - 1] = before;
            }
            if unlike_top && !above[column].refined {
                let refined = refine(above[column].seen.color, x, y - 1.0, antialias, sample);
                pixels[(row - 1) * width + column] = refined;
            }
            if unlike_left || unlike_top {
                here = pixel(refine(here.seen.color, x, y, antialias, sample), true);
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
fn refine(
    center: Sample,
    x: f64,
    y: f64,
    antialias: &Antialias,
    sample: &mut dyn FnMut(f64, f64) -> Sample,
) -> Sample {
    let depth = antialias.depth;
    let offset = |index: u32| (f64::from(index) + 0.5) / f64::from(depth) - 0.5;
    let spread = f64::from(antialias.jitter) / f64::from(depth);
    let mut sum = center;
    for (b, a) in (0..depth).flat_map(|b| (0..depth).map(move |a| (b, a))) {
        let (px, py) = (x + offset(a), y + offset(b));
        let moved = if spread > 0.0 { jitter(px, py) * spread } else { Default::default() };
        let color = sample(px + moved.x, py + moved.y);
        sum = std::array::from_fn(|i| sum[i] + color[i]);
    }
    let count = (depth * depth + 1) as f32;
    sum.map(|component| component / count)
}

/// Method 2: a square whose corners differ is split into quadrants.
fn adaptive(
    block: &Region,
    antialias: &Antialias,
    contrast: &Contrast,
    sample: &mut dyn FnMut(f64, f64) -> Sample,
) -> Vec<Sample> {
    let (left, top) = (f64::from(block.columns.start), f64::from(block.rows.start));
    let (width, height) = (block.columns.len(), block.rows.len());
    let corners: Vec<Seen> = (0..=height)
        .flat_map(|row| (0..=width).map(move |column| (column, row)))
        .map(|(column, row)| contrast.seen(sample(left + column as f64 - 0.5, top + row as f64 - 0.5)))
        .collect();
    let steps = 1u32 << antialias.depth;
    let mut grid = Grid {
        contrast,
        steps,
        spread: f64::from(antialias.jitter) / f64::from(steps + 1),
        corner: (0.0, 0.0),
        known: FxHashMap::default(),
        sample,
    };
    let mut pixels = Vec::with_capacity(width * height);
    for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
        let at = |right: usize, down: usize| corners[(row + down) * (width + 1) + column + right];
        grid.corner = (left + column as f64 - 0.5, top + row as f64 - 0.5);
        grid.known.clear();
        let square = Square { x: 0, y: 0, edge: steps };
        pixels.push(grid.value(square, [at(0, 0), at(0, 1), at(1, 0), at(1, 1)], antialias.depth - 1));
    }
    pixels
}

/// The places of one pixel that method 2 may sample.
struct Grid<'a> {
    contrast: &'a Contrast,
    /// Cells along an edge of the pixel.
    steps: u32,
    /// Largest jitter, doubled.
    spread: f64,
    /// Image coordinates of the pixel's upper left corner.
    corner: (f64, f64),
    /// Places sampled before.
    known: FxHashMap<(u32, u32), Seen>,
    sample: &'a mut dyn FnMut(f64, f64) -> Sample,
}

/// A square of the grid.
#[derive(Clone, Copy)]
struct Square {
    x: u32,
    y: u32,
    edge: u32,
}

impl Grid<'_> {
    /// The colour of a square with the corners upper left, lower left, upper right, lower right.
    fn value(&mut self, square: Square, corners: [Seen; 4], level: u32) -> Sample {
        let [upper_left, lower_left, upper_right, lower_right] = corners;
        let unlike = |a: usize, b: usize| self.contrast.differ(&corners[a], &corners[b]);
        let differs = (0..4).any(|a| (a + 1..4).any(|b| unlike(a, b)));
        if level == 0 || !differs {
            return mean(corners.map(|corner| corner.color));
        }
        let (x, y, half) = (square.x, square.y, square.edge / 2);
        let left = self.at(x, y + half);
        let top = self.at(x + half, y);
        let right = self.at(x + square.edge, y + half);
        let bottom = self.at(x + half, y + square.edge);
        let center = self.at(x + half, y + half);
        let quadrant = |dx: u32, dy: u32| Square { x: x + dx, y: y + dy, edge: half };
        mean([
            self.value(quadrant(0, 0), [upper_left, left, top, center], level - 1),
            self.value(quadrant(0, half), [left, lower_left, center, bottom], level - 1),
            self.value(quadrant(half, 0), [top, center, upper_right, right], level - 1),
            self.value(quadrant(half, half), [center, bottom, right, lower_right], level - 1),
        ])
    }

    fn at(&mut self, x: u32, y: u32) -> Seen {
        if let Some(&known) = self.known.get(&(x, y)) {
            return known;
        }
        let place = |corner: f64, index: u32| corner + f64::from(index) / f64::from(self.steps);
        let (px, py) = (place(self.corner.0, x), place(self.corner.1, y));
        let moved = if self.spread > 0.0 { jitter(px, py) * self.spread } else { Default::default() };
        let seen = self.contrast.seen((self.sample)(px + moved.x, py + moved.y));
        self.known.insert((x, y), seen);
        seen
    }
}

fn mean(colors: [Sample; 4]) -> Sample {
    std::array::from_fn(|i| (colors[0][i] + colors[1][i] + colors[2][i] + colors[3][i]) / 4.0)
}

#[cfg(test)]
mod tests;
