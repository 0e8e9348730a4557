//! A first look: one sample for each square of pixels.

use std::ops::Range;

use super::{Look, Sample, pixels};
use crate::math::DVec2;
use crate::options::Region;

/// Gives the squares of a grid over the picture, `step` pixels wide, the colour in their middle.
pub(super) fn every(block: &Region, step: u32, look: &mut dyn Look) -> Vec<Sample> {
    let step = step.max(1);
    let cells = |range: &Range<u32>| range.start / step..range.end.div_ceil(step);
    let grid = Region { columns: cells(&block.columns), rows: cells(&block.rows) };
    let middle = |cell: u32| f64::from(cell) * f64::from(step) + f64::from(step - 1) / 2.0;
    let colors: Vec<Sample> = pixels(&grid).map(|(x, y)| look.at(DVec2::new(middle(x), middle(y)))).collect();
    let width = grid.columns.len();
    let place = |x: u32, y: u32| {
        (y / step - grid.rows.start) as usize * width + (x / step - grid.columns.start) as usize
    };
    pixels(block).map(|(x, y)| colors[place(x, y)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_anywhere_show_parts_of_one_grid() {
        let mut place = |x: f64, y: f64| [x as f32, y as f32, 0.0, 0.0];
        let pixels = every(&Region { columns: 3..9, rows: 2..4 }, 4, &mut place);
        let row = |y: f32| [1.5, 5.5, 5.5, 5.5, 5.5, 9.5].map(|x| [x, y, 0.0, 0.0]);
        assert_eq!(pixels, [row(1.5), row(1.5)].concat());
    }
}
