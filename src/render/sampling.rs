//! Sampling: which places of a block are looked at and how pixels come of them.
//!
//! POV-Ray's own ways are those of docs/spec/camera-image.md 9; the others are povista's. A block is
//! finished by one thread from its own samples alone, so threads never matter; blocks do, where
//! pixels are compared with their neighbours.

mod adaptive;
mod corners;
mod edges;
mod even;
mod every;
mod filter;
mod neighbours;
mod quadrants;

use std::ops::Range;

use super::random::Random;
use crate::math::DVec2;
use crate::math::gamma::Gamma;
use crate::options::{Antialias, AntialiasMethod, Region, RenderOptions, Sampling};
pub(super) use even::{Turns, even};

/// Red, green, blue and transmit of a sample.
pub type Sample = [f32; 4];

/// Tells what is seen at image coordinates.
pub(super) trait Look {
    /// At one place.
    fn at(&mut self, place: DVec2) -> Sample;

    /// At four places near each other.
    fn four(&mut self, places: &[DVec2; 4]) -> [Sample; 4] {
        places.map(|place| self.at(place))
    }

    /// Adds what is seen in the middles of the pixels of a row.
    fn row(&mut self, columns: Range<u32>, row: u32, seen: &mut Vec<Sample>) {
        seen.extend(columns.map(|column| self.at(DVec2::new(column.into(), row.into()))));
    }
}

impl<F: FnMut(f64, f64) -> Sample> Look for F {
    fn at(&mut self, place: DVec2) -> Sample {
        self(place.x, place.y)
    }
}

/// Looks at places, four at a time, and hands on in their order what is seen and what belongs to each.
fn each<T: Copy + Default>(
    look: &mut dyn Look,
    places: impl Iterator<Item = (DVec2, T)>,
    mut take: impl FnMut(Sample, T),
) {
    let (mut waiting, mut count) = ([(DVec2::ZERO, T::default()); 4], 0);
    for place in places {
        waiting[count] = place;
        count += 1;
        if count == waiting.len() {
            for (seen, (_, with)) in look.four(&waiting.map(|(place, _)| place)).into_iter().zip(waiting) {
                take(seen, with);
            }
            count = 0;
        }
    }
    for &(place, with) in &waiting[..count] {
        take(look.at(place), with);
    }
}

/// What is seen at places, looked at four at a time.
fn all(look: &mut dyn Look, places: impl Iterator<Item = DVec2>) -> Vec<Sample> {
    let mut seen = Vec::with_capacity(places.size_hint().0);
    each(look, places.map(|place| (place, ())), |sample, ()| seen.push(sample));
    seen
}

/// Colours the pixels of `block`, row by row, from samples at image coordinates.
///
/// `working` is the space of the colours; `None` in old scenes, which have none.
pub(super) fn block(
    block: &Region,
    options: &RenderOptions,
    working: Option<Gamma>,
    look: &mut dyn Look,
) -> Vec<Sample> {
    match options.sampling {
        Some(Sampling::Corners) => corners::corners(block, look),
        Some(Sampling::Every(step)) => every::every(block, step, look),
        Some(Sampling::Even { samples, filter }) => {
            even(block, Turns { first: 0, count: samples }, filter, options.seed, look)
        }
        Some(Sampling::Adaptive { error, most, filter }) => {
            let contrast = Contrast::new(&Antialias::default(), working);
            let aim = adaptive::Aim { error, most };
            adaptive::adaptive(block, aim, filter, options.seed, &contrast, look)
        }
        Some(Sampling::Edges { error, most }) => {
            let contrast = Contrast::new(&Antialias::default(), working);
            edges::edges(block, &edges::Aim::new(error, most, working), options.seed, &contrast, look)
        }
        // The first round of many (`super::budget`).
        Some(Sampling::Budget { filter, .. }) => {
            even(block, Turns { first: 0, count: 1 }, filter, options.seed, look)
        }
        None => match &options.antialias {
            None => centres(block, look),
            Some(antialias) => {
                let contrast = Contrast::new(antialias, working);
                match antialias.method {
                    AntialiasMethod::Neighbours => neighbours::neighbours(block, antialias, &contrast, look),
                    AntialiasMethod::Adaptive => quadrants::quadrants(block, antialias, &contrast, look),
                }
            }
        },
    }
}

/// The pixels of a block by their coordinates, row by row.
fn pixels(block: &Region) -> impl Iterator<Item = (u32, u32)> {
    let columns = block.columns.clone();
    block.rows.clone().flat_map(move |y| columns.clone().map(move |x| (x, y)))
}

/// The numbers of the pixels beside one, of so many in rows of some width.
fn beside(number: usize, width: usize, count: usize) -> impl Iterator<Item = usize> {
    let column = number % width;
    let left = (column > 0).then(|| number - 1);
    let right = (column + 1 < width).then_some(number + 1);
    let above = number.checked_sub(width);
    let below = Some(number + width).filter(|&below| below < count);
    [left, right, above, below].into_iter().flatten()
}

/// One sample in the middle of each pixel.
fn centres(block: &Region, look: &mut dyn Look) -> Vec<Sample> {
    let mut seen = Vec::with_capacity(block.columns.len() * block.rows.len());
    for row in block.rows.clone() {
        look.row(block.columns.clone(), row, &mut seen);
    }
    seen
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

    /// How bright a sample is seen, as much as a screen shows of it; transmit counts like light.
    fn brightness(&self, color: Sample) -> f32 {
        let [red, green, blue, transmit] = self.seen(color).perceived;
        let shown = [red, green, blue].map(|component| component.clamp(0.0, 1.0));
        LUMA[0] * shown[0] + LUMA[1] * shown[1] + LUMA[2] * shown[2] + transmit
    }
}

/// Shares of the colours in what is seen as brightness (ITU-R BT.601).
const LUMA: [f32; 3] = [0.299, 0.587, 0.114];

/// A sample, and as it is compared with others: often, so that is worked out once.
#[derive(Clone, Copy)]
struct Seen {
    color: Sample,
    perceived: Sample,
}

fn mean<const N: usize>(colors: [Sample; N]) -> Sample {
    std::array::from_fn(|i| colors.iter().map(|color| color[i]).sum::<f32>() / N as f32)
}

#[cfg(test)]
mod tests;
