//! As many samples as a time allows.

use std::time::Instant;

use super::sampling::{Turns, even};
use super::{Eye, Image, Progress, Rendered, tiles};
use crate::options::Filter;

/// Renders the whole picture again and again, twice as many samples each time, as long as the next
/// round fits into `seconds` by what the last one took; the first is always finished.
///
/// What comes out depends on how fast the machine is.
pub(super) fn render(eye: &Eye<'_>, seconds: f32, filter: Filter, progress: &dyn Progress) -> Rendered {
    let start = Instant::now();
    let mut round = Turns { first: 0, count: 1 };
    let mut rendered = tiles::render(eye.options, progress, |block| eye.block(block));
    loop {
        let spent = start.elapsed().as_secs_f64();
        let taken = round.first + round.count;
        let affordable = (f64::from(seconds) - spent) / spent * f64::from(taken);
        let count = (affordable as u32).min(taken);
        if count == 0 {
            return rendered;
        }
        round = Turns { first: taken, count };
        let more = tiles::render(eye.options, &(), |block| {
            eye.sampled(|look| even(block, round, filter, eye.options.seed, look))
        });
        let share = count as f32 / (taken + count) as f32;
        blend(&mut rendered.image, &more.image, share);
        rendered.statistics += more.statistics;
    }
}

/// Moves a picture some of the way to another.
fn blend(image: &mut Image, other: &Image, share: f32) {
    for (pixel, other) in image.pixels.iter_mut().zip(&other.pixels) {
        *pixel = std::array::from_fn(|i| pixel[i] + share * (other[i] - pixel[i]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_blend_by_their_samples() {
        let (mut image, mut other) = (Image::new(1, 1), Image::new(1, 1));
        image.pixels[0] = [1.0, 0.0, 0.5, 1.0];
        other.pixels[0] = [0.0, 1.0, 0.5, 0.0];
        blend(&mut image, &other, 0.25);
        assert_eq!(image.pixels[0], [0.75, 0.25, 0.5, 0.75]);
    }
}
