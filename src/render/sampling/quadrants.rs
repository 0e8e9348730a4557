//! POV-Ray's method 2 (docs/spec/camera-image.md 9.2).

use rustc_hash::FxHashMap;

use super::{Contrast, Look, Sample, Seen, all, mean};
use crate::math::DVec2;
use crate::options::{Antialias, Region};
use crate::render::jitter::jitter;

/// Method 2: a square whose corners differ is split into quadrants.
pub(super) fn quadrants(
    block: &Region,
    antialias: &Antialias,
    contrast: &Contrast,
    look: &mut dyn Look,
) -> Vec<Sample> {
    let (left, top) = (f64::from(block.columns.start), f64::from(block.rows.start));
    let (width, height) = (block.columns.len(), block.rows.len());
    let corners = (0..=height)
        .flat_map(|row| (0..=width).map(move |column| (column, row)))
        .map(|(column, row)| DVec2::new(left + column as f64 - 0.5, top + row as f64 - 0.5));
    let corners: Vec<Seen> = all(look, corners).into_iter().map(|color| contrast.seen(color)).collect();
    let steps = 1u32 << antialias.depth;
    let mut grid = Grid {
        contrast,
        steps,
        spread: f64::from(antialias.jitter) / f64::from(steps + 1),
        corner: (0.0, 0.0),
        known: FxHashMap::default(),
        look,
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
    look: &'a mut dyn Look,
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
        let seen = self.contrast.seen(self.look.at(DVec2::new(px, py) + moved));
        self.known.insert((x, y), seen);
        seen
    }
}
