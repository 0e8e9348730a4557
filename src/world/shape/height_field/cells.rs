//! The cells of a height field in a pyramid of blocks: which of them a ray may meet.
//!
//! Four by four cells make a block, four by four blocks one of the next level, up to a single one; of each the lowest and
//! the highest sample are kept (Tevs, Ihrke, Seidel, Maximum mipmaps for fast, accurate, and scalable dynamic height
//! field rendering, I3D 2008). A ray passes the parts of a block in an order that its direction tells.

use glam::Vec4;

use crate::math::Bounds;
use crate::math::wide::widest;
use crate::world::{Range, Ray};

/// Parts along each side of a block.
const SIDE: usize = 4;

const WIDTH: u32 = SIDE as u32;

/// Parts of a block.
const PARTS: usize = SIDE * SIDE;

/// More levels than a field has whose samples can be counted.
const DEEPEST: usize = 32;

/// Bound on the rounding errors of single precision, relative to the terms of each test.
const SLACK: f32 = 8.0 * f32::EPSILON;

/// The same of double precision.
const BLUR: f64 = 8.0 * f64::EPSILON;

/// The longest that a ray whose fastest axis takes 1 for a unit may take for one along another: no side's distance is
/// 0 · ∞ then.
const LONGEST: f64 = 1e30;

/// Between which heights the cells are.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    /// The first has the cells for parts, each of the others the blocks of the one before; the last has one block.
    levels: Vec<Level>,
}

/// A grid of parts in blocks.
#[derive(Clone, Debug)]
struct Level {
    /// Parts along x and z.
    size: [u32; 2],
    /// Blocks along x.
    width: u32,
    /// Cells along each side of a part.
    span: f32,
    /// Row by row.
    blocks: Vec<Block>,
}

/// The lowest and the highest sample of each part, row by row. What is beyond the border is anything.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Block([[u16; PARTS]; 2]);

/// A ray from where it comes to the field.
pub(super) struct Way {
    /// Where that is, and how much longer its distances are than the ray's.
    start: f64,
    scale: f64,
    /// In cells, steps of height, and cells.
    axes: [Axis; 3],
}

/// A ray along one axis.
#[derive(Clone, Copy)]
struct Axis {
    origin: f32,
    /// What it takes for one unit; its reciprocal is no more than 1.
    inverse: f32,
    /// How much sooner than it is told it may come to a side, or later leave one.
    room: f32,
}

impl Way {
    /// Of a ray in cells along x and z and steps of height, before `range` ends, through the box around the field.
    /// `None` where it passes beside it.
    #[inline(always)]
    pub(super) fn new(ray: &Ray, bounds: &Bounds, range: Range) -> Option<Self> {
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let (low, high) = (bounds.min.to_array(), bounds.max.to_array());
        let scale = ray.direction.abs().max_element();
        let (mut start, mut inverse) = (range.min, [0.0; 3]);
        for axis in 0..3 {
            inverse[axis] = direction[axis].recip();
            let side = if inverse[axis] < 0.0 { high[axis] } else { low[axis] };
            // What is no number bounds nothing.
            let enters = (side - origin[axis]) * inverse[axis];
            start = if enters > start { enters } else { start };
        }
        // Also where it has no length.
        if !(start < range.max && (start * scale).is_finite()) {
            return None;
        }
        let mut axes = [Axis { origin: 0.0, inverse: 0.0, room: 0.0 }; 3];
        for axis in 0..3 {
            let takes = (inverse[axis].abs() * scale).min(LONGEST) as f32;
            let moved = start * direction[axis];
            let blur = BLUR * (origin[axis].abs() + moved.abs());
            axes[axis] = Axis {
                origin: (origin[axis] + moved) as f32,
                inverse: takes.copysign(inverse[axis] as f32),
                room: (blur as f32 + SLACK * high[axis] as f32) * takes,
            };
        }
        Some(Self { start, scale, axes })
    }

    /// A distance along it, or a little more.
    #[inline(always)]
    fn end(&self, t: f64) -> f32 {
        ((t + t.abs() * BLUR - self.start) * self.scale) as f32 * (1.0 + SLACK) + f32::MIN_POSITIVE
    }
}

impl Axis {
    /// Where the ray comes to what spans so much.
    #[inline(always)]
    fn enters(&self, from: f32, span: f32) -> f32 {
        let side = if self.inverse < 0.0 { from + span } else { from };
        (side - self.origin) * self.inverse - self.room
    }

    /// How long it takes for what spans so much.
    #[inline(always)]
    fn takes(&self, span: f32) -> f32 {
        span * self.inverse.abs() + 2.0 * self.room
    }
}

impl Cells {
    /// Between so many samples along x and z, given row by row, z downward.
    pub(super) fn new(samples: [usize; 2], heights: &[u16]) -> Self {
        let mut levels = vec![Level::of_cells(samples, heights)];
        while let Some(finer) = levels.last().filter(|level| level.blocks.len() > 1) {
            let coarser = finer.of_blocks();
            levels.push(coarser);
        }
        Self { levels }
    }

    /// The lowest and the highest sample of all.
    pub(super) fn extremes(&self) -> [u16; 2] {
        self.levels.last().map_or([0; 2], |level| level.extremes([0, 0]))
    }

    /// Calls back with the cells that a ray may meet before a distance, by their places along x and z, the nearest first;
    /// the answer is a new end.
    #[inline(always)]
    pub(super) fn along(&self, way: &Way, end: f64, mut found: impl FnMut(usize, usize) -> f64) {
        // Bits of a block are counted down where the ray goes backward along z, each row the other way round where it
        // goes backward along only one of both.
        let falls = way.axes[2].inverse < 0.0;
        let turned = if (way.axes[0].inverse < 0.0) == falls { 0 } else { WIDTH - 1 };
        let mut waiting = [0_u16; DEEPEST];
        let (mut level, mut x, mut z) = (self.levels.len() - 1, 0_u32, 0_u32);
        let (mut end, mut is_nearer) = (way.end(end), false);
        waiting[level] = self.levels[level].met([x, z], way, end, turned != 0);
        // What is left of the block x, z of a level; above the last there is nothing.
        while let Some(here) = self.levels.get(level) {
            let left = waiting[level];
            if left == 0 {
                (level, x, z) = (level + 1, x / WIDTH, z / WIDTH);
                continue;
            }
            let bit = if falls { left.ilog2() } else { left.trailing_zeros() };
            waiting[level] = left & !(1 << bit);
            let part = [x * WIDTH + ((bit % WIDTH) ^ turned), z * WIDTH + bit / WIDTH];
            let is_behind =
                |axis: usize| way.axes[2 * axis].enters(part[axis] as f32 * here.span, here.span) > end;
            let is_outside = part[0] >= here.size[0] || part[1] >= here.size[1];
            if is_outside || is_nearer && (is_behind(0) || is_behind(1)) {
                continue;
            }
            if level == 0 {
                let t = found(part[0] as usize, part[1] as usize);
                if t == f64::NEG_INFINITY {
                    return;
                }
                let before = end;
                end = way.end(t);
                is_nearer |= end < before;
            } else {
                (level, x, z) = (level - 1, part[0], part[1]);
                waiting[level] = self.levels[level].met([x, z], way, end, turned != 0);
            }
        }
    }
}

impl Level {
    /// That of the cells between so many samples along x and z.
    fn of_cells(samples: [usize; 2], heights: &[u16]) -> Self {
        let size = samples.map(|samples| samples - 1);
        let count = size.map(|cells| cells.div_ceil(SIDE));
        let mut blocks = Vec::with_capacity(count[0] * count[1]);
        widest(
            #[inline(always)]
            || {
                for z in (0..size[1]).step_by(SIDE) {
                    for x in (0..size[0]).step_by(SIDE) {
                        let mut block = Block::NOTHING;
                        let [bottoms, tops] = &mut block.0;
                        let to = (x + SIDE).min(size[0]);
                        for row in 0..SIDE.min(size[1] - z) {
                            let below = &heights[(size[1] - z - row) * samples[0]..][x..=to];
                            let above = &heights[(size[1] - z - row - 1) * samples[0]..][x..=to];
                            let (bottoms, tops) = (&mut bottoms[SIDE * row..], &mut tops[SIDE * row..]);
                            // The row of a whole block is of a length that is known.
                            match (below.first_chunk::<{ SIDE + 1 }>(), above.first_chunk::<{ SIDE + 1 }>()) {
                                (Some(below), Some(above)) => extremes(below, above, bottoms, tops),
                                _ => extremes(below, above, bottoms, tops),
                            }
                        }
                        blocks.push(block);
                    }
                }
            },
        );
        Self::new(size, 1.0, blocks)
    }

    fn new(size: [usize; 2], span: f32, blocks: Vec<Block>) -> Self {
        let width = size[0].div_ceil(SIDE) as u32;
        Self { size: size.map(|parts| parts as u32), width, span, blocks }
    }

    /// That of the blocks of this one.
    fn of_blocks(&self) -> Self {
        let size = self.size.map(|parts| (parts as usize).div_ceil(SIDE));
        let count = size.map(|parts| parts.div_ceil(SIDE));
        let mut blocks = vec![Block::NOTHING; count[0] * count[1]];
        for z in 0..size[1] {
            for x in 0..size[0] {
                let [bottoms, tops] = &mut blocks[z / SIDE * count[0] + x / SIDE].0;
                let part = z % SIDE * SIDE + x % SIDE;
                [bottoms[part], tops[part]] = self.extremes([x as u32, z as u32]);
            }
        }
        Self::new(size, self.span * SIDE as f32, blocks)
    }

    /// One of the blocks, by its place among them along x and z.
    #[inline(always)]
    fn block(&self, [x, z]: [u32; 2]) -> &[[u16; PARTS]; 2] {
        &self.blocks[(z * self.width + x) as usize].0
    }

    /// The lowest and the highest sample of a block.
    fn extremes(&self, block: [u32; 2]) -> [u16; 2] {
        let [bottoms, tops] = self.block(block);
        let least = bottoms.iter().fold(u16::MAX, |least, bottom| least.min(*bottom));
        [least, tops.iter().fold(0, |most, top| most.max(*top))]
    }

    /// The parts of a block that a ray may meet before `end`, as bits row by row, each row the other way round where
    /// it's `turned`.
    #[inline(always)]
    fn met(&self, block: [u32; 2], way: &Way, end: f32, turned: bool) -> u16 {
        let [x, height, z] = &way.axes;
        let sides = self.block(block);
        let falls = usize::from(height.inverse < 0.0);
        let (entered, left) = (&sides[falls], &sides[1 - falls]);
        let first = |place: u32| (place * WIDTH) as f32 * self.span;
        let [enter_x, enter_z] = [x.enters(first(block[0]), self.span), z.enters(first(block[1]), self.span)];
        let [step_x, step_z] = [x.inverse * self.span, z.inverse * self.span];
        let [takes_x, takes_z] = [x.takes(self.span), z.takes(self.span)];
        let (mut from, mut to) = ([0.0; PARTS], [end; PARTS]);
        // Loops over all parts, and no closures of arrays' methods: so they are compiled for wide registers.
        for part in 0..PARTS {
            let enter = enter_x + COLUMNS[part] * step_x;
            from[part] = if enter > from[part] { enter } else { from[part] };
            let leave = enter + takes_x;
            to[part] = if leave < to[part] { leave } else { to[part] };
        }
        for part in 0..PARTS {
            let enter = enter_z + ROWS[part] * step_z;
            from[part] = if enter > from[part] { enter } else { from[part] };
            let leave = enter + takes_z;
            to[part] = if leave < to[part] { leave } else { to[part] };
        }
        for part in 0..PARTS {
            let enter = (f32::from(entered[part]) - height.origin) * height.inverse - height.room;
            from[part] = if enter > from[part] { enter } else { from[part] };
            let leave = (f32::from(left[part]) - height.origin) * height.inverse + height.room;
            to[part] = if leave < to[part] { leave } else { to[part] };
        }
        let room = Vec4::splat(1.0 + SLACK);
        let mut met = 0;
        for row in 0..SIDE {
            let four = |of: &[f32; PARTS]| {
                Vec4::new(of[SIDE * row], of[SIDE * row + 1], of[SIDE * row + 2], of[SIDE * row + 3])
            };
            met |= four(&from).cmple(four(&to) * room).bitmask() << (SIDE * row);
        }
        if turned {
            let pairs = (met & 0x5555) << 1 | (met & 0xaaaa) >> 1;
            met = (pairs & 0x3333) << 2 | (pairs & 0xcccc) >> 2;
        }
        met as u16
    }
}

/// In which column and which row of a block each part is.
const COLUMNS: [f32; PARTS] =
    [0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0];
const ROWS: [f32; PARTS] = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0];

impl Block {
    const NOTHING: Self = Self([[u16::MAX; PARTS], [0; PARTS]]);
}

/// The lowest and the highest corner of cells between two rows of samples.
#[inline(always)]
fn extremes(below: &[u16], above: &[u16], bottoms: &mut [u16], tops: &mut [u16]) {
    for x in 0..below.len().min(above.len()) - 1 {
        let [a, b, c, d] = [below[x], below[x + 1], above[x], above[x + 1]];
        bottoms[x] = a.min(b).min(c.min(d));
        tops[x] = a.max(b).max(c.max(d));
    }
}
