//! The cells of a height field in blocks: which of them a ray may meet.

use std::ops::Range as Span;

use crate::math::wide::widest;
use crate::world::{Range, Ray};

/// Cells along each side of a block.
const BLOCK: usize = 4;

/// How far above and below a cell's box, in samples' steps, a ray is still taken to go through it.
const UNSURE: f64 = 1e-6;

/// How far beside its cells a ray is looked for, in cells.
const BESIDE: f64 = 1e-9;

/// The same as a share of its distances, far more than rounding takes.
const SHARE: f64 = 1e-12;

/// The greatest height there is, in samples' steps.
const HIGHEST: f64 = 65535.0;

/// Between which heights each cell is.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    /// Cells along x and z.
    size: [usize; 2],
    /// Blocks along x.
    width: usize,
    /// Row by row.
    blocks: Vec<Block>,
}

/// The lowest and the highest corner of each cell of a block, row by row. What is beyond the border is met by nothing.
#[derive(Clone, Copy, Debug)]
struct Block {
    bottoms: [[u16; BLOCK]; BLOCK],
    tops: [[u16; BLOCK]; BLOCK],
}

/// A ray in cells along x and z and steps of height.
pub(super) struct Way {
    /// Where it comes to the cell at the origin and leaves it, along x and z in cells, some room included.
    near: [f64; 2],
    far: [f64; 2],
    /// What it takes for a cell.
    inverse: [f64; 2],
    height: f64,
    climb: f64,
    /// How far off heights may be.
    room: f64,
}

impl Way {
    /// Of a ray in such units, over so many samples along x and z.
    #[inline(always)]
    pub(super) fn new(ray: &Ray, size: [usize; 2]) -> Self {
        let along = |from: f64, direction: f64, samples: usize| {
            let room = BESIDE + SHARE * (from.abs() + samples as f64);
            let (low, high) = (-room - from, 1.0 + room - from);
            let inverse = direction.recip();
            if inverse < 0.0 { (high, low, inverse) } else { (low, high, inverse) }
        };
        let (o, d) = (ray.origin, ray.direction);
        let (near_x, far_x, inverse_x) = along(o.x, d.x, size[0]);
        let (near_z, far_z, inverse_z) = along(o.z, d.z, size[1]);
        Self {
            near: [near_x, near_z],
            far: [far_x, far_z],
            inverse: [inverse_x, inverse_z],
            height: o.y,
            climb: d.y,
            room: UNSURE + SHARE * (o.y.abs() + HIGHEST),
        }
    }
}

impl Cells {
    /// Between so many samples along x and z, given row by row.
    pub(super) fn new(size: [usize; 2], heights: &[u16]) -> Self {
        let samples = size;
        let size = samples.map(|samples| samples - 1);
        let width = size[0].div_ceil(BLOCK);
        let count = width * size[1].div_ceil(BLOCK);
        let mut cells = Self { size, width, blocks: Vec::with_capacity(count) };
        widest(
            #[inline(always)]
            || {
                for number in 0..count {
                    let block = cells.block(number, samples[0], heights);
                    cells.blocks.push(block);
                }
            },
        );
        cells
    }

    /// A block over samples of which so many are in a row.
    #[inline(always)]
    fn block(&self, number: usize, samples: usize, heights: &[u16]) -> Block {
        let mut block = Block { bottoms: [[u16::MAX; BLOCK]; BLOCK], tops: [[0; BLOCK]; BLOCK] };
        let [xs, zs] = self.within(number);
        for (row, z) in zs.enumerate() {
            let below = &heights[z * samples..][xs.start..=xs.end];
            let above = &heights[(z + 1) * samples..][xs.start..=xs.end];
            let (bottoms, tops) = (&mut block.bottoms[row], &mut block.tops[row]);
            // The row of a whole block is of a length that is known.
            match (below.first_chunk::<{ BLOCK + 1 }>(), above.first_chunk::<{ BLOCK + 1 }>()) {
                (Some(below), Some(above)) => extremes(below, above, bottoms, tops),
                _ => extremes(below, above, bottoms, tops),
            }
        }
        block
    }

    /// How many blocks there are along x.
    pub(super) fn blocks_along_x(&self) -> usize {
        self.width
    }

    /// How many blocks there are.
    pub(super) fn blocks(&self) -> usize {
        self.blocks.len()
    }

    /// The cells of a block along x and z.
    #[inline(always)]
    pub(super) fn within(&self, block: usize) -> [Span<usize>; 2] {
        let (x, z) = (block % self.width * BLOCK, block / self.width * BLOCK);
        [x..(x + BLOCK).min(self.size[0]), z..(z + BLOCK).min(self.size[1])]
    }

    /// The lowest and the highest corner of a block.
    pub(super) fn extremes(&self, block: usize) -> [u16; 2] {
        let Block { bottoms, tops } = &self.blocks[block];
        let (mut least, mut most) = (u16::MAX, 0);
        for row in 0..BLOCK {
            for lane in 0..BLOCK {
                least = least.min(bottoms[row][lane]);
                most = most.max(tops[row][lane]);
            }
        }
        [least, most]
    }

    /// Calls back with the cells of a block that a ray may meet in a range, roughly the nearest first; the answer is a
    /// new upper end.
    #[inline(always)]
    pub(super) fn along(
        &self,
        way: &Way,
        block: usize,
        range: Range,
        mut found: impl FnMut(usize, usize) -> f64,
    ) {
        let Block { bottoms, tops } = &self.blocks[block];
        let (x, z) = (block % self.width * BLOCK, block / self.width * BLOCK);
        let (mut near_x, mut far_x) = ([0.0; BLOCK], [0.0; BLOCK]);
        for lane in 0..BLOCK {
            let column = x as f64 + lane as f64;
            near_x[lane] = (column + way.near[0]) * way.inverse[0];
            far_x[lane] = (column + way.far[0]) * way.inverse[0];
        }
        let mut near = [[0.0; BLOCK]; BLOCK];
        let mut met = 0_u32;
        for row in 0..BLOCK {
            let from = (z as f64 + row as f64 + way.near[1]) * way.inverse[1];
            let to = (z as f64 + row as f64 + way.far[1]) * way.inverse[1];
            // What is no number bounds nothing.
            let from = if from > range.min { from } else { range.min };
            let to = if to < range.max { to } else { range.max };
            let mut passed = [false; BLOCK];
            for lane in 0..BLOCK {
                let first = if near_x[lane] > from { near_x[lane] } else { from };
                let last = if far_x[lane] < to { far_x[lane] } else { to };
                let (one, other) = (way.height + first * way.climb, way.height + last * way.climb);
                let (low, high) = if one < other { (one, other) } else { (other, one) };
                passed[lane] = (first > last)
                    | (low > f64::from(tops[row][lane]) + way.room)
                    | (high < f64::from(bottoms[row][lane]) - way.room);
                near[row][lane] = first;
            }
            for (lane, passed) in passed.into_iter().enumerate() {
                met |= u32::from(!passed) << (row * BLOCK + lane);
            }
        }
        let mut end = range.max;
        while met != 0 {
            let cell = if way.inverse[1] < 0.0 { met.ilog2() } else { met.trailing_zeros() };
            met &= !(1 << cell);
            let (row, lane) = (cell as usize / BLOCK % BLOCK, cell as usize % BLOCK);
            let (x, z) = (x + lane, z + row);
            if near[row][lane] <= end && x < self.size[0] && z < self.size[1] {
                end = found(x, z);
            }
        }
    }
}

/// The lowest and the highest corner of cells between two rows of samples.
#[inline(always)]
fn extremes(below: &[u16], above: &[u16], bottoms: &mut [u16; BLOCK], tops: &mut [u16; BLOCK]) {
    for x in 0..below.len().min(above.len()) - 1 {
        let [a, b, c, d] = [below[x], below[x + 1], above[x], above[x + 1]];
        bottoms[x] = a.min(b).min(c.min(d));
        tops[x] = a.max(b).max(c.max(d));
    }
}
