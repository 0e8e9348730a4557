//! The middle of a pixel and its corners, which neighbours share.

use super::{Look, Sample, all, mean, pixels};
use crate::math::DVec2;
use crate::options::Region;

/// What is seen at the corners of all pixels, row by row, one more in each row and column than there are pixels.
pub(super) fn corners_of(block: &Region, look: &mut dyn Look) -> Vec<Sample> {
    let (columns, rows) = (&block.columns, &block.rows);
    let around = Region { columns: columns.start..columns.end + 1, rows: rows.start..rows.end + 1 };
    all(look, pixels(&around).map(|(x, y)| DVec2::new(x.into(), y.into()) - 0.5))
}

/// Half of a pixel is its middle, half the mean of its corners: a little more than two samples each.
pub(super) fn corners(block: &Region, look: &mut dyn Look) -> Vec<Sample> {
    let (columns, rows) = (&block.columns, &block.rows);
    let corners = corners_of(block, look);
    let width = columns.len() + 1;
    pixels(block)
        .map(|(x, y)| {
            let at = (y - rows.start) as usize * width + (x - columns.start) as usize;
            let corners = mean([corners[at], corners[at + 1], corners[at + width], corners[at + width + 1]]);
            mean([look.at(DVec2::new(x.into(), y.into())), corners])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_shared_and_slopes_kept() {
        let mut asked = 0;
        let mut ramp = |x: f64, y: f64| {
            asked += 1;
            [x as f32, y as f32, 1.0, 0.0]
        };
        let pixels = corners(&Region { columns: 2..6, rows: 1..4 }, &mut ramp);
        assert_eq!(pixels[5], [3.0, 2.0, 1.0, 0.0]);
        assert_eq!(asked, 4 * 3 + 5 * 4);
    }
}
