//! What may be in the way of light to a cell of space: found once for the many rays that start there.

use std::ops::Range;

use crate::math::{Bounds, DVec3};
use crate::world::accel::{Hull, Points};
use crate::world::hit::Geometry;
use crate::world::screen::Screen;
use crate::world::umbra::Shade;
use crate::world::{Intersection, Light};

/// Cells that are remembered at a time.
const CELLS: usize = 512;

/// The width of a cell, over the distance from which it is seen and the size of a pixel there.
const PIXELS: f64 = 8.0;

/// The same for lamps that each hit looks at again.
const AREA_PIXELS: f64 = 16.0;

/// So many rays to a lamp of one place ask for a cell before it is worth while to look around.
const WORTH: u32 = 6;

/// How far points of a cell may be moved out of it, in parts of its width.
const ROOM: f64 = 1e-6;

/// Exponents of widths that have an inverse.
const EXPONENTS: Range<u64> = 64..1984;

/// Cells farther from the origin, in widths, are none.
const MOST: f64 = 1e9;

/// What was found out about cells.
#[derive(Debug, Default)]
pub(in crate::render) struct Shafts {
    cells: Vec<Shaft>,
    last: Last,
}

/// The cell that was asked for last: the next point is mostly in it too.
#[derive(Debug, Default)]
struct Last {
    /// As [`Cell::lamp`].
    lamp: u64,
    /// Its low corner.
    low: DVec3,
    /// Zero before there is any.
    width: f64,
    slot: usize,
}

impl Last {
    /// Whether the cell of that lamp around a surface is this one.
    #[inline]
    fn is_around(&self, lamp: u64, surface: &Intersection) -> bool {
        // Differences of what is close to each other: below zero, or not less than the width, if the numbers are.
        let DVec3 { x, y, z } = surface.point - self.low;
        let within = |along: f64| (along >= 0.0) & (along < self.width);
        (lamp == self.lamp) & within(x) & within(y) & within(z) & (surface.error < ROOM * self.width)
    }
}

/// A cell as a lamp sees it: in words as they are compared, for halves put together in memory would be waited for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Cell {
    /// The number of the lamp, and the exponent of half the width of the cell.
    lamp: u64,
    /// Its place from the origin in widths, along x and y.
    across: u64,
    /// The same along z.
    along: u64,
}

/// What was found out about a cell.
#[derive(Clone, Debug, Default)]
struct Shaft {
    cell: Cell,
    /// How often it was asked for.
    asked: u32,
    /// The objects; `None` if they are many, or not known.
    among: Option<Between>,
}

/// What is between a cell and a lamp.
#[derive(Clone, Debug)]
pub(super) enum Between {
    /// Of a lamp of one place.
    Shade(Shade),
    /// Of other lamps.
    Screens(Vec<Screen>),
}

impl Shafts {
    /// The objects that may be in the way between a surface that is seen from a `distance` and a lamp;
    /// `None` where finding them isn't worth while, or they are many; else where [`among`](Self::among) has them.
    /// `pixel` is the size of a pixel at distance 1.
    #[inline(always)]
    pub(super) fn find(
        &mut self,
        geometry: &Geometry,
        (number, light): (u32, &Light),
        surface: &Intersection,
        distance: f64,
        pixel: f64,
    ) -> Option<usize> {
        if light.runs_parallel() {
            return None;
        }
        let pixels = if light.area.is_some() { AREA_PIXELS } else { PIXELS };
        let lamp = lamp_word(number, pixels * pixel * distance);
        if !self.last.is_around(lamp, surface) {
            let (cell, width) = Cell::around(lamp, surface)?;
            let slot = cell.slot();
            if self.cells.is_empty() {
                self.cells.resize(CELLS, Shaft::default());
            }
            if self.cells[slot].cell != cell {
                self.cells[slot] = Shaft { cell, asked: 0, among: None };
            }
            self.last = Last { lamp, low: cell.low(width), width, slot };
        }
        let slot = self.last.slot;
        let shaft = &mut self.cells[slot];
        shaft.asked = shaft.asked.saturating_add(1);
        let worth = if light.area.is_some() { 1 } else { WORTH };
        if shaft.asked == worth {
            shaft.among = look(geometry, shaft.cell, self.last.width, light);
        }
        shaft.among.is_some().then_some(slot)
    }

    /// What was found.
    #[inline]
    pub(super) fn among(&self, slot: usize) -> Option<&Between> {
        self.cells[slot].among.as_ref()
    }

    /// The screens found for those who need the shafts at the same time. Give them [`back`](Self::back).
    pub(super) fn lend(&mut self, slot: usize) -> Vec<Screen> {
        match &mut self.cells[slot].among {
            Some(Between::Screens(screens)) => std::mem::take(screens),
            _ => Vec::new(),
        }
    }

    /// Takes back what was lent.
    pub(super) fn back(&mut self, slot: usize, screens: Vec<Screen>) {
        self.cells[slot].among = Some(Between::Screens(screens));
    }
}

/// The objects between a cell and a lamp; `None` if they are many.
#[cold]
fn look(geometry: &Geometry, cell: Cell, width: f64, light: &Light) -> Option<Between> {
    let bounds = cell.bounds(width);
    if light.area.is_none() && light.projected_through.is_none() {
        return geometry.shade(light.location, &bounds).map(Between::Shade);
    }
    let (points, mut found) = (Cell::ways(&bounds, light), Vec::new());
    let finite = points.iter().all(|point| point.is_finite());
    let few = finite && geometry.between(&Hull::new(&points), &mut found);
    few.then_some(Between::Screens(found))
}

/// [`Cell::lamp`] of cells that are at least so wide.
#[inline]
fn lamp_word(number: u32, width: f64) -> u64 {
    u64::from(number) << 32 | width.to_bits() >> 52
}

impl Cell {
    /// The cell around a point of a surface for the word of a lamp, and its width.
    #[inline]
    fn around(lamp: u64, surface: &Intersection) -> Option<(Self, f64)> {
        let exponent = lamp & u64::from(u32::MAX);
        if !EXPONENTS.contains(&exponent) {
            return None;
        }
        let (width, inverse) =
            (f64::from_bits((exponent + 1) << 52), f64::from_bits((2045 - exponent) << 52));
        let DVec3 { x, y, z } = surface.point * inverse;
        let near = (x.abs() < MOST) & (y.abs() < MOST) & (z.abs() < MOST);
        let known = near & (surface.error < ROOM * width);
        let two = |high: u32, low: u32| u64::from(high) << 32 | u64::from(low);
        let [x, y, z] = [x, y, z].map(|along| floor(along) as u32);
        let cell = Self { lamp, across: two(x, y), along: z.into() };
        known.then_some((cell, width))
    }

    /// Its low corner.
    #[inline]
    fn low(&self, width: f64) -> DVec3 {
        let [x, y, z] = [(self.across >> 32) as i32, self.across as i32, self.along as i32];
        DVec3::new(f64::from(x), f64::from(y), f64::from(z)) * width
    }

    /// Where it is remembered.
    #[inline]
    fn slot(&self) -> usize {
        // Products side by side, of which none waits for another: their high bits depend on all bits of the words.
        let Self { lamp, across, along } = *self;
        let mixed = (lamp.wrapping_mul(0x9e37_79b9_7f4a_7c15))
            ^ (across.wrapping_mul(0xd1b5_4a32_d192_ed03))
            ^ (along.wrapping_mul(0x8cb9_2ba7_2f3d_8dd7));
        (mixed >> 48) as usize % CELLS
    }

    /// Where its points are.
    fn bounds(&self, width: f64) -> Bounds {
        let low = self.low(width);
        Bounds::new(low - ROOM * width, low + (1.0 + ROOM) * width)
    }

    /// The corners of what encloses all ways from a cell to a lamp.
    fn ways(cell: &Bounds, light: &Light) -> Points {
        let mut points = Points::from_slice(&[light.location, cell.center()]);
        points.extend(cell.corners());
        match &light.area {
            Some(area) if area.orient => {
                let radius = DVec3::splat(area.radius());
                points.extend(Bounds::new(light.location - radius, light.location + radius).corners());
            }
            Some(area) => points.extend(area.corners(area.axes).map(|corner| light.location + corner)),
            None => {}
        }
        points
    }
}

/// The next whole number below, of numbers with less than 31 bits before the point.
#[inline]
fn floor(x: f64) -> i32 {
    // Adding and taking away 1.5·2⁵² rounds to the next whole number, which is then in the low bits.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let rounded = x + ROUND;
    rounded.to_bits() as i32 - i32::from(rounded - ROUND > x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_next_whole_number_below_is_found() {
        for (x, below) in
            [(0.0, 0), (-0.0, 0), (0.5, 0), (-0.5, -1), (1.5, 1), (2.5, 2), (-2.5, -3), (-3.0, -3)]
        {
            assert_eq!(floor(x), below, "{x}");
        }
        assert_eq!((floor(1e9 - 0.25), floor(0.25 - 1e9)), (999_999_999, -1_000_000_000));
    }

    #[test]
    fn a_cell_holds_the_point_it_is_around() {
        for (point, wanted) in [(0.3, 0.25), (-7.1, 1.0), (1e5, 3e-3), (-1e-9, 1e-12)] {
            let surface = Intersection::in_space(DVec3::new(point, -point, 0.0));
            let (cell, width) = Cell::around(lamp_word(1, wanted), &surface).unwrap();
            assert!(width >= wanted && width <= 2.0 * wanted, "{wanted}: {width}");
            let low = cell.low(width);
            assert!(low[0] <= point && point <= low[0] + width, "{point} {low:?}");
            assert!(low[1] <= -point && -point <= low[1] + width, "{point} {low:?}");
            let last = Last { lamp: cell.lamp, low, width, slot: cell.slot() };
            for moved in [-1.0, -1e-9, 0.0, 1e-9, 0.3, 1.0 - 1e-9, 1.0] {
                let surface = Intersection::in_space(low + DVec3::new(moved * width, 0.3 * width, 0.0));
                let is_same = Cell::around(cell.lamp, &surface) == Some((cell, width));
                assert_eq!(last.is_around(cell.lamp, &surface), is_same, "{point} {moved}");
                assert!(!last.is_around(cell.lamp + 1, &surface));
            }
        }
        // Where rounding may move points out of it there is none.
        assert_eq!(Cell::around(lamp_word(1, 1e-9), &Intersection::in_space(DVec3::splat(1e9))), None);
        assert_eq!(Cell::around(lamp_word(1, 0.0), &Intersection::in_space(DVec3::ZERO)), None);
        assert_eq!(Cell::around(lamp_word(1, 1.0), &Intersection::in_space(DVec3::NAN)), None);
    }
}
