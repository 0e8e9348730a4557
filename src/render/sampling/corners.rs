//! The middle of a pixel and its corners, which neighbours share.

use super::{Sample, mean, pixels};
use crate::options::Region;

/// Half of a pixel is its middle, half the mean of its corners: a little more than two samples each.
pub(super) fn corners(block: &Region, sample: &mut dyn FnMut(f64, f64) -> Sample) -> Vec<Sample> {
    let (columns, rows) = (&block.columns, &block.rows);
    let around = Region { columns: columns.start..columns.end + 1, rows: rows.start..rows.end + 1 };
    let corners: Vec<Sample> =
        pixels(&around).map(|(x, y)| sample(f64::from(x) - 0.5, f64::from(y) - 0.5)).collect();
    let width = around.columns.len();
    pixels(block)
        .map(|(x, y)| {
            let at = (y - rows.start) as usize * width + (x - columns.start) as usize;
            let corners = mean([corners[at], corners[at + 1], corners[at + width], corners[at + width + 1]]);
            mean([sample(f64::from(x), f64::from(y)), corners])
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
