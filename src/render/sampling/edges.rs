//! Edges are looked for where they cross the sides of pixels: povista's own antialiasing for pictures of surfaces.
//!
//! Every pixel begins as in [`corners`](super::corners): with its middle and its corners, which neighbours share. Where
//! these say that colours change evenly they are all it takes. Elsewhere the place where colours jump is searched along
//! each side by halving, and a pixel that one edge divides in two gets as much of either colour as lies on that side of
//! the edge: a few samples find it to a hundredth of a pixel, where samples spread over the pixel need hundreds. What
//! is not divided in two ([`cell`]) is cut into quarters, which are looked at alike, and so are its neighbours in the
//! block, where it may go on between all places that were looked at. Where most of a pixel is of that kind, as patterns finer than
//! pixels are, samples are spread over it ([`adaptive`](super::adaptive)).

mod cell;
mod quarters;
mod side;

use super::adaptive::{Aim as Spread, Pixel};
use super::corners::corners_of;
use super::{Contrast, Look, Sample, all, beside, pixels};
use crate::math::DVec2;
use crate::math::gamma::Gamma;
use crate::options::{Filter, Region};
use cell::{Cell, across_edges};
use quarters::quarters;
use side::Side;

/// Up to this exponent colours are taken for light, which is seen by about its square root.
const LIGHT: f32 = 1.5;

/// A pixel with so many uneven quarters is finer than pixels.
const MOST: usize = 4;

/// So many pixels are cut into quarters together: enough for places to be looked at four at a time.
const TOGETHER: usize = 16;

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim {
    /// Error of a pixel as it is seen, of 1.
    error: f32,
    /// So often may a pixel be cut into quarters.
    depth: u32,
    /// Whether colours are light.
    light: bool,
    /// The same for samples that are spread over a pixel.
    spread: Spread,
}

impl Aim {
    /// An error in steps of 255, reached with about so many samples of a pixel at most, where colours are kept in some
    /// space; `None` in scenes that have none.
    pub(super) fn new(error: f32, most: u32, working: Option<Gamma>) -> Self {
        let light = matches!(working, Some(Gamma::Power(exponent)) if exponent < LIGHT);
        let most = most.max(1);
        Self {
            error: (error / 255.0).max(1e-6),
            depth: most.ilog2() / 2,
            light,
            spread: Spread { error, most },
        }
    }

    /// The error of a part of a pixel that was cut so often: errors of parts come together as their squares do.
    fn error(&self, cuts: u32) -> f32 {
        self.error * 2.0_f32.powi(cuts as i32)
    }

    /// How far two samples are apart as they are seen, in the component where that is most.
    ///
    /// The square root stands for the eye, and for what screens are sent.
    #[inline]
    fn apart(&self, a: &Sample, b: &Sample) -> f32 {
        let mut most = 0.0_f32;
        for (a, b) in a.iter().zip(b) {
            let (a, b) = (a.clamp(0.0, 1.0), b.clamp(0.0, 1.0));
            let (a, b) = if self.light { (a.sqrt(), b.sqrt()) } else { (a, b) };
            most = most.max((a - b).abs());
        }
        most
    }
}

/// The pixels of a block; every seed spreads samples in another way.
pub(super) fn edges(
    block: &Region,
    aim: &Aim,
    seed: u64,
    contrast: &Contrast,
    look: &mut dyn Look,
) -> Vec<Sample> {
    let mut pixels = Pixels::new(block, aim, look);
    pixels.divide(look);
    let fine = |pixels: &Pixels<'_>, number: usize, look: &mut dyn Look| {
        let mut pixel = Pixel::new(pixels.at(number), Filter::Box, seed);
        let bright = |number: usize| contrast.brightness(pixels.middles[number]);
        let here = bright(number);
        let unlike = pixels.around(number).map(|next| (bright(next) - here).abs()).fold(0.0, f32::max);
        pixel.finish(aim.spread, unlike, contrast, look);
        pixel
    };
    // What is to be looked at closer, and whether it is finer than pixels.
    let mut open: Vec<(usize, bool)> = Vec::new();
    for number in (0..pixels.kinds.len()).filter(|&number| pixels.kinds[number] == Kind::Manifold) {
        let count = pixels.around(number).count();
        let plain = pixels.around(number).filter(|&next| pixels.kinds[next] != Kind::Manifold).count();
        open.push((number, 2 * plain < count));
    }
    let mut beside_fine = vec![0; pixels.kinds.len()];
    while !open.is_empty() {
        let mut wave = std::mem::take(&mut open);
        wave.sort_unstable();
        wave.dedup();
        let (mut cut, mut spread) = (Vec::new(), Vec::new());
        for (number, is_fine) in wave {
            match pixels.kinds[number] {
                Kind::Fine => {}
                _ if is_fine => spread.push(number),
                Kind::Cut => {}
                _ => cut.push(number),
            }
        }
        for together in cut.chunks(TOGETHER) {
            for (&number, found) in together.iter().zip(pixels.quarters(together, look)) {
                let Some((color, uneven)) = found else {
                    spread.push(number);
                    continue;
                };
                (pixels.kinds[number], pixels.colors[number]) = (Kind::Cut, color);
                if uneven > 0 {
                    let even = pixels.around(number).filter(|&next| pixels.kinds[next] == Kind::Even);
                    open.extend(even.map(|next| (next, false)));
                }
            }
        }
        spread.sort_unstable();
        spread.dedup();
        for number in spread {
            let pixel = fine(&pixels, number, look);
            (pixels.kinds[number], pixels.colors[number]) = (Kind::Fine, pixel.mean());
            if pixel.deviation() > aim.error {
                for next in pixels.around(number) {
                    beside_fine[next] += 1;
                    if pixels.kinds[next] == Kind::Even || beside_fine[next] > 1 {
                        open.push((next, true));
                    }
                }
            }
        }
    }
    pixels.colors
}

/// What is known of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// Its corners and middle say that colours change evenly.
    Even,
    /// One edge divides it in two.
    Divided,
    /// There is more in it.
    Manifold,
    /// It was cut into quarters.
    Cut,
    /// Samples were spread over it.
    Fine,
}

/// The pixels of a block.
struct Pixels<'a> {
    block: &'a Region,
    aim: &'a Aim,
    /// Row by row, one more in each row and column than there are pixels.
    corners: Vec<Sample>,
    /// Row by row.
    middles: Vec<Sample>,
    colors: Vec<Sample>,
    kinds: Vec<Kind>,
    sides: Sides,
}

impl<'a> Pixels<'a> {
    /// Looks at corners and middles, which is all it takes for pixels that are even.
    fn new(block: &'a Region, aim: &'a Aim, look: &mut dyn Look) -> Self {
        let corners = corners_of(block, look);
        let middles = all(look, pixels(block).map(|(x, y)| DVec2::new(x.into(), y.into())));
        let sides = Sides { numbers: vec![[None; 2]; corners.len()], found: Vec::new() };
        let mut pixels = Self { block, aim, corners, middles, colors: Vec::new(), kinds: Vec::new(), sides };
        for number in 0..pixels.middles.len() {
            let color = cell::even(aim, 0, &pixels.corners_of(number), &pixels.middles[number]);
            pixels.kinds.push(if color.is_some() { Kind::Even } else { Kind::Manifold });
            pixels.colors.push(color.unwrap_or_default());
        }
        pixels
    }

    fn width(&self) -> usize {
        self.block.columns.len()
    }

    /// The column and row of a pixel in the picture.
    fn at(&self, number: usize) -> (u32, u32) {
        let Region { columns, rows } = self.block;
        (columns.start + (number % self.width()) as u32, rows.start + (number / self.width()) as u32)
    }

    /// The pixels beside one.
    fn around(&self, number: usize) -> impl Iterator<Item = usize> + use<> {
        beside(number, self.width(), self.middles.len())
    }

    /// The number of the upper left corner of a pixel.
    fn corner(&self, number: usize) -> usize {
        number / self.width() * (self.width() + 1) + number % self.width()
    }

    fn corners_of(&self, number: usize) -> [Sample; 4] {
        let (first, across) = (self.corner(number), self.width() + 1);
        [first, first + 1, first + across + 1, first + across].map(|corner| self.corners[corner])
    }

    /// Where the four sides of a pixel begin, and which way they go: to the right or downwards.
    fn sides_around(&self, number: usize) -> [(usize, usize); 4] {
        let (corner, across) = (self.corner(number), self.width() + 1);
        [(corner, 0), (corner + 1, 1), (corner + across, 0), (corner, 1)]
    }

    /// A side that begins at a corner, of which nothing but its ends is known.
    fn side(&self, (begin, way): (usize, usize)) -> Side {
        let across = self.width() + 1;
        let (end, along) = [(begin + 1, DVec2::X), (begin + across, DVec2::Y)][way];
        let Region { columns, rows } = self.block;
        let place = [columns.start + (begin % across) as u32, rows.start + (begin / across) as u32];
        let from = DVec2::from_array(place.map(f64::from)) - 0.5;
        Side::new(self.aim, 0, (from, along), [begin, end].map(|corner| self.corners[corner]))
    }

    /// A pixel with what is known of its sides.
    fn cell(&self, number: usize) -> Cell {
        let [top, right, bottom, left] =
            self.sides_around(number).map(|at| self.sides.of(at).copied().unwrap_or_else(|| self.side(at)));
        let sides = [top, right, bottom.reversed(), left.reversed()];
        Cell { cuts: 0, corners: self.corners_of(number), middle: self.middles[number], sides }
    }

    /// Finds the colours of pixels that one edge divides in two.
    fn divide(&mut self, look: &mut dyn Look) {
        let uneven: Vec<usize> =
            (0..self.kinds.len()).filter(|&number| self.kinds[number] == Kind::Manifold).collect();
        for &number in &uneven {
            for at in self.sides_around(number) {
                if self.sides.of(at).is_none() {
                    let side = self.side(at);
                    self.sides.add(at, side);
                }
            }
        }
        side::search(&mut self.sides.found, self.aim, look);
        let cells: Vec<Cell> = uneven.iter().map(|&number| self.cell(number)).collect();
        for (number, color) in uneven.into_iter().zip(across_edges(&cells, self.aim, look)) {
            if let Some(color) = color {
                (self.kinds[number], self.colors[number]) = (Kind::Divided, color);
            }
        }
    }

    /// The mean colours of the quarters of pixels, and how many of them are not even; `None` if these are too many, or
    /// pixels may not be cut.
    fn quarters(&self, numbers: &[usize], look: &mut dyn Look) -> Vec<Option<(Sample, usize)>> {
        if self.aim.depth == 0 {
            return vec![None; numbers.len()];
        }
        let cells: Vec<Cell> = numbers.iter().map(|&number| self.cell(number)).collect();
        quarters(&cells, MOST - 1, self.aim, look)
    }
}

/// The sides between the pixels of a block that were searched for edges, those of uneven pixels.
struct Sides {
    /// The numbers of the sides that begin at a corner, to the right and downwards.
    numbers: Vec<[Option<usize>; 2]>,
    found: Vec<Side>,
}

impl Sides {
    fn add(&mut self, (begin, way): (usize, usize), side: Side) {
        self.numbers[begin][way] = Some(self.found.len());
        self.found.push(side);
    }

    fn of(&self, (begin, way): (usize, usize)) -> Option<&Side> {
        self.numbers[begin][way].map(|number| &self.found[number])
    }
}

#[cfg(test)]
mod tests;
