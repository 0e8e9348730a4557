//! POV-Ray's method 2 (docs/spec/camera-image.md 9.2).

use super::corners::corners_of;
use super::{Contrast, Look, Sample, Seen, all, mean};
use crate::math::DVec2;
use crate::options::{Antialias, Region};
use crate::render::jitter::jitter;

/// So many places at most belong to pixels that are divided together.
const PLACES: usize = 1 << 16;

/// Method 2: a square whose corners differ is split into quadrants.
///
/// Squares of one size are split together, for places near each other are looked at together, and what neighbours
/// share is looked at once.
pub(super) fn quadrants(
    block: &Region,
    antialias: &Antialias,
    contrast: &Contrast,
    look: &mut dyn Look,
) -> Vec<Sample> {
    let (width, height) = (block.columns.len(), block.rows.len());
    let corners: Vec<Seen> = corners_of(block, look).into_iter().map(|color| contrast.seen(color)).collect();
    let steps = 1 << antialias.depth;
    let together = (PLACES / (steps * steps)).max(1);
    let (across, down) = (together.min(width), (together / width).clamp(1, height));
    let mut grid = Grid::new(antialias, across, down);
    let mut colors = vec![Sample::default(); width * height];
    for (top, left) in
        (0..height).step_by(down).flat_map(|top| (0..width).step_by(across).map(move |left| (top, left)))
    {
        let (columns, rows) = (left..(left + across).min(width), top..(top + down).min(height));
        let pixels = || rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column)));
        let at = |index: u32, begin: usize| f64::from(index) + begin as f64 - 0.5;
        grid.start(DVec2::new(at(block.columns.start, left), at(block.rows.start, top)));
        for (row, column) in pixels() {
            let first = row * (width + 1) + column;
            let around =
                [first, first + width + 1, first + 1, first + width + 2].map(|corner| corners[corner]);
            grid.add(column - left, row - top, around);
        }
        grid.split(contrast, look);
        for ((row, column), color) in pixels().zip(grid.colors()) {
            colors[row * width + column] = color;
        }
    }
    colors
}

/// The places of some pixels that method 2 may sample.
struct Grid {
    /// Cells along an edge of a pixel.
    steps: usize,
    /// Largest jitter, doubled, as a share of a pixel.
    spread: f64,
    /// Places in a row.
    across: usize,
    /// Image coordinates of the upper left corner.
    from: DVec2,
    /// One more than the number of each place that is known or wanted, row by row; 0 for the others.
    numbers: Vec<u32>,
    known: Vec<Seen>,
    wanted: Vec<DVec2>,
    /// The pixels, then what they are split into.
    squares: Vec<Square>,
    pixels: usize,
}

/// A square of the grid.
#[derive(Clone, Copy)]
struct Square {
    x: usize,
    y: usize,
    edge: usize,
    /// Numbers of its corners: upper left, lower left, upper right, lower right.
    corners: [u32; 4],
    /// The number of the first of its quadrants, in the same order.
    quadrants: Option<usize>,
}

impl Grid {
    /// Of so many pixels.
    fn new(antialias: &Antialias, across: usize, down: usize) -> Self {
        let steps = 1 << antialias.depth;
        let [across, down] = [across, down].map(|pixels| pixels * steps + 1);
        Self {
            steps,
            spread: f64::from(antialias.jitter) / (steps + 1) as f64,
            across,
            from: DVec2::ZERO,
            numbers: vec![0; across * down],
            known: Vec::new(),
            wanted: Vec::new(),
            squares: Vec::new(),
            pixels: 0,
        }
    }

    /// Forgets everything, to begin at some image coordinates.
    fn start(&mut self, from: DVec2) {
        self.from = from;
        self.numbers.fill(0);
        self.known.clear();
        self.squares.clear();
        self.pixels = 0;
    }

    /// Adds a pixel by its column and row here, before anything is split.
    fn add(&mut self, column: usize, row: usize, corners: [Seen; 4]) {
        let first = self.known.len() as u32;
        self.known.extend(corners);
        let corners = [0, 1, 2, 3].map(|i| first + i);
        let (x, y, edge) = (column * self.steps, row * self.steps, self.steps);
        self.squares.push(Square { x, y, edge, corners, quadrants: None });
        self.pixels += 1;
    }

    /// The number of a place, which is looked at with the next.
    fn number(&mut self, x: usize, y: usize) -> u32 {
        let place = y * self.across + x;
        if self.numbers[place] == 0 {
            let along = |from: f64, index: usize| from + index as f64 / self.steps as f64;
            let at = DVec2::new(along(self.from.x, x), along(self.from.y, y));
            let moved = if self.spread > 0.0 { jitter(at.x, at.y) * self.spread } else { DVec2::ZERO };
            self.wanted.push(at + moved);
            self.numbers[place] = (self.known.len() + self.wanted.len()) as u32;
        }
        self.numbers[place] - 1
    }

    /// Splits all squares whose corners differ, down to two cells.
    fn split(&mut self, contrast: &Contrast, look: &mut dyn Look) {
        let mut split: Vec<(usize, [u32; 5])> = Vec::new();
        let mut begin = 0;
        while begin < self.squares.len() {
            for square in begin..self.squares.len() {
                let Square { x, y, edge, corners, .. } = self.squares[square];
                let unlike = |a: usize, b: usize| {
                    let [a, b] = [a, b].map(|corner| &self.known[corners[corner] as usize]);
                    contrast.differ(a, b)
                };
                if edge > 2 && (0..4).any(|a| (a + 1..4).any(|b| unlike(a, b))) {
                    let half = edge / 2;
                    let places = [(0, half), (half, 0), (edge, half), (half, edge), (half, half)];
                    split.push((square, places.map(|(right, down)| self.number(x + right, y + down))));
                }
            }
            self.known.extend(all(look, self.wanted.drain(..)).into_iter().map(|color| contrast.seen(color)));
            begin = self.squares.len();
            for (square, [left, top, right, bottom, center]) in split.drain(..) {
                self.squares[square].quadrants = Some(self.squares.len());
                let Square { x, y, edge, corners, .. } = self.squares[square];
                let [upper_left, lower_left, upper_right, lower_right] = corners;
                let edge = edge / 2;
                let quadrant =
                    |x: usize, y: usize, corners: [u32; 4]| Square { x, y, edge, corners, quadrants: None };
                self.squares.extend([
                    quadrant(x, y, [upper_left, left, top, center]),
                    quadrant(x, y + edge, [left, lower_left, center, bottom]),
                    quadrant(x + edge, y, [top, center, upper_right, right]),
                    quadrant(x + edge, y + edge, [center, bottom, right, lower_right]),
                ]);
            }
        }
    }

    /// The colours of the pixels.
    fn colors(&self) -> Vec<Sample> {
        let mut colors = vec![Sample::default(); self.squares.len()];
        for (number, square) in self.squares.iter().enumerate().rev() {
            colors[number] = match square.quadrants {
                Some(first) => mean([0, 1, 2, 3].map(|i| colors[first + i])),
                None => mean(square.corners.map(|corner| self.known[corner as usize].color)),
            };
        }
        colors.truncate(self.pixels);
        colors
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::gamma::Gamma;

    /// What method 2 makes of a block of a picture, where all is split that may be, and how many places it looks at.
    fn split(block: &Region, depth: u32, picture: impl Fn(f64, f64) -> f32) -> (Vec<f32>, u32) {
        let antialias = Antialias { threshold: 0.0, depth, jitter: 0.0, ..Antialias::default() };
        let contrast = Contrast::new(&antialias, Some(Gamma::LINEAR));
        let mut asked = 0;
        let mut look = |x: f64, y: f64| {
            asked += 1;
            [picture(x, y); 4]
        };
        let colors = quadrants(block, &antialias, &contrast, &mut look);
        (colors.iter().map(|color| color[0]).collect(), asked)
    }

    #[test]
    fn places_between_pixels_are_looked_at_once() {
        let (colors, asked) =
            split(&Region { columns: 3..7, rows: 2..5 }, 3, |x, y| (0.1 * x + 0.05 * y) as f32);
        assert_eq!(asked, (4 * 4 + 1) * (3 * 4 + 1));
        assert!((colors[6] - 0.65).abs() < 1e-6, "{}", colors[6]);
    }

    #[test]
    fn pixels_that_are_too_fine_to_be_split_together_come_out_alike() {
        let disc = |x: f64, y: f64| if x.hypot(y) < 1.3 { 0.2 } else { 0.9 };
        let (together, _) = split(&Region { columns: 0..3, rows: 0..2 }, 8, disc);
        for (number, color) in together.into_iter().enumerate() {
            let (x, y) = (number as u32 % 3, number as u32 / 3);
            let (alone, _) = split(&Region { columns: x..x + 1, rows: y..y + 1 }, 8, disc);
            assert_eq!(alone, [color]);
        }
    }
}
