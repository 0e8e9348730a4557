//! What is not divided in two is cut into quarters, which are looked at alike.

use super::Aim;
use super::cell::{Cell, across_edges, even};
use super::side::{Side, search};
use crate::math::DVec2;
use crate::render::sampling::{Look, Sample, all, mean};

/// The quarters of a cell.
struct Quarters {
    /// So often was the pixel cut into quarters.
    cuts: u32,
    corners: [[Sample; 4]; 4],
    middles: [Sample; 4],
    /// The colours of those that are even.
    evens: [Option<Sample>; 4],
    /// Halves of the cell's sides, one after the other around it, and the sides from their middles inwards.
    sides: [Side; 12],
}

/// The places that tell of a cell's quarters: their middles, then those middles of its sides that nobody looked at.
fn places(cell: &Cell) -> impl Iterator<Item = DVec2> {
    let heart = cell.heart();
    let hearts = cell.sides.iter().map(move |side| 0.5 * (side.from() + heart));
    hearts.chain(cell.sides.iter().filter(|side| side.middle.is_none()).map(Side::halfway))
}

impl Quarters {
    /// With what is seen at the places that tell of them.
    fn new(cell: &Cell, seen: &mut impl Iterator<Item = Sample>, aim: &Aim) -> Self {
        let mut next = || seen.next().unwrap_or(cell.middle);
        let middles = [(); 4].map(|()| next());
        let halfways = cell.sides.map(|side| side.middle.unwrap_or_else(&mut next));
        let (heart, cuts) = (cell.heart(), cell.cuts + 1);
        let mut sides = [cell.sides[0]; 12];
        for (i, (side, halfway)) in cell.sides.iter().zip(halfways).enumerate() {
            [sides[2 * i], sides[2 * i + 1]] = side.halves(aim, halfway);
            let from = side.halfway();
            sides[8 + i] = Side::new(aim, cuts, (from, heart - from), [halfway, cell.middle]);
        }
        let corners: [_; 4] =
            std::array::from_fn(|i| [cell.corners[i], halfways[i], cell.middle, halfways[(i + 3) % 4]]);
        let evens = std::array::from_fn(|i| even(aim, cuts, &corners[i], &middles[i]));
        Self { cuts, corners, middles, evens, sides }
    }

    /// The numbers of a quarter's sides.
    fn sides_of(quarter: usize) -> [usize; 4] {
        let before = (quarter + 3) % 4;
        [2 * quarter, 8 + quarter, 8 + before, 2 * before + 1]
    }

    /// The numbers of those that are not even.
    fn uneven(&self) -> impl Iterator<Item = usize> {
        (0..4).filter(|&quarter| self.evens[quarter].is_none())
    }

    /// The numbers of the sides of those.
    fn wanted(&self) -> impl Iterator<Item = usize> {
        (0..12).filter(|side| self.uneven().any(|quarter| Self::sides_of(quarter).contains(side)))
    }

    /// One of them.
    fn cell(&self, quarter: usize) -> Cell {
        let [outward, inward, back, home] = Self::sides_of(quarter).map(|number| self.sides[number]);
        let (corners, middle) = (self.corners[quarter], self.middles[quarter]);
        Cell { cuts: self.cuts, corners, middle, sides: [outward, inward, back.reversed(), home] }
    }
}

/// The mean colours of the quarters of cells and how many of them are not even; `None` for a cell where these are more
/// than `many`.
pub(super) fn quarters(
    cells: &[Cell],
    many: usize,
    aim: &Aim,
    look: &mut dyn Look,
) -> Vec<Option<(Sample, usize)>> {
    let mut seen = all(look, cells.iter().flat_map(places).collect::<Vec<_>>().into_iter()).into_iter();
    let mut cut: Vec<Option<Quarters>> = cells
        .iter()
        .map(|cell| Some(Quarters::new(cell, &mut seen, aim)).filter(|cut| cut.uneven().count() <= many))
        .collect();
    let mut wanted = Vec::new();
    for cut in cut.iter().flatten() {
        wanted.extend(cut.wanted().map(|number| cut.sides[number]));
    }
    search(&mut wanted, aim, look);
    let mut found = wanted.into_iter();
    for cut in cut.iter_mut().flatten() {
        let numbers: Vec<usize> = cut.wanted().collect();
        for (number, side) in numbers.into_iter().zip(&mut found) {
            cut.sides[number] = side;
        }
    }
    let mut uneven = Vec::new();
    for cut in cut.iter().flatten() {
        uneven.extend(cut.uneven().map(|quarter| cut.cell(quarter)));
    }
    let mut colors = colors(&uneven, aim, look).into_iter();
    let mut mean_of = |cut: Quarters| {
        let color = mean(cut.evens.map(|even| even.or_else(|| colors.next()).unwrap_or_default()));
        (color, cut.uneven().count())
    };
    cut.into_iter().map(|cut| cut.map(&mut mean_of)).collect()
}

/// The mean colours of cells that are not even.
fn colors(cells: &[Cell], aim: &Aim, look: &mut dyn Look) -> Vec<Sample> {
    if cells.is_empty() {
        return Vec::new();
    }
    let found = across_edges(cells, aim, look);
    let may_be_cut = |cell: &Cell| cell.cuts < aim.depth;
    let open: Vec<Cell> = cells
        .iter()
        .zip(&found)
        .filter(|(cell, color)| color.is_none() && may_be_cut(cell))
        .map(|(cell, _)| *cell)
        .collect();
    let mut cut = quarters(&open, 4, aim, look).into_iter();
    let color = |(cell, color): (&Cell, Option<Sample>)| match color {
        Some(color) => color,
        None if may_be_cut(cell) => cut.next().flatten().map_or(cell.middle, |(color, _)| color),
        None => mean([mean(cell.corners), cell.middle]),
    };
    cells.iter().zip(found).map(color).collect()
}
