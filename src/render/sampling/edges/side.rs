//! The sides of pixels and of their parts, and where colours jump along them.

use super::Aim;
use crate::math::DVec2;
use crate::render::sampling::{Look, Sample, each};

/// Colours that differ by at most this share of what they differed by along twice the way change evenly.
const RAMP: f32 = 0.6;

/// A jump is known no worse than to this share of its side.
const COARSEST: f32 = 0.25;

/// What an edge's place along both sides errs by in the mean, as a share of what it is known to.
const ERRS: f32 = 0.25;

/// What is known of the colours along a side.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Known {
    /// They may jump between `bounds`.
    Little,
    /// They change evenly.
    Even,
    /// They jump between `bounds`.
    Jump,
}

/// One side of a pixel or of a part of one, with a direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// Where it begins, in image coordinates.
    from: DVec2,
    /// From there to its end.
    along: DVec2,
    /// So often was the pixel cut whose part's side this is.
    cuts: u32,
    pub ends: [Sample; 2],
    pub middle: Option<Sample>,
    known: Known,
    /// Where colours jump at most, in parts of the side.
    bounds: [f32; 2],
    /// The colours there.
    values: [Sample; 2],
}

/// An edge on a side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump {
    /// In image coordinates.
    pub at: DVec2,
    /// The colours before and after it.
    pub colors: [Sample; 2],
    /// How far off it may be.
    pub doubt: f64,
}

impl Side {
    /// A side from somewhere along some way with the colours of its ends.
    pub(super) fn new(aim: &Aim, cuts: u32, (from, along): (DVec2, DVec2), ends: [Sample; 2]) -> Self {
        let even = aim.apart(&ends[0], &ends[1]) <= aim.error(cuts);
        let known = if even { Known::Even } else { Known::Little };
        Self { from, along, cuts, ends, middle: None, known, bounds: [0.0, 1.0], values: ends }
    }

    /// Where it begins.
    pub(super) fn from(&self) -> DVec2 {
        self.from
    }

    /// Its middle.
    pub(super) fn halfway(&self) -> DVec2 {
        self.from + 0.5 * self.along
    }

    /// The same from its end.
    pub(super) fn reversed(&self) -> Self {
        let [first, last] = self.ends;
        let [low, high] = self.bounds;
        let [before, after] = self.values;
        Self {
            from: self.from + self.along,
            along: -self.along,
            ends: [last, first],
            bounds: [1.0 - high, 1.0 - low],
            values: [after, before],
            ..*self
        }
    }

    /// Its halves, where the colour of its middle is known.
    pub(super) fn halves(&self, aim: &Aim, middle: Sample) -> [Self; 2] {
        [(0.0, [self.ends[0], middle]), (0.5, [middle, self.ends[1]])].map(|(begin, ends)| {
            let place = (self.from + f64::from(begin) * self.along, 0.5 * self.along);
            let half = Self::new(aim, self.cuts + 1, place, ends);
            let bounds = self.bounds.map(|bound| 2.0 * (bound - begin));
            if self.known == Known::Jump && bounds[0] >= 0.0 && bounds[1] <= 1.0 {
                Self { known: Known::Jump, bounds, values: self.values, ..half }
            } else {
                half
            }
        })
    }

    /// The edge on it, if there is just one.
    pub(super) fn jump(&self) -> Option<Jump> {
        let [low, high] = self.bounds.map(f64::from);
        (self.known == Known::Jump).then(|| Jump {
            at: self.from + 0.5 * (low + high) * self.along,
            colors: self.values,
            doubt: 0.5 * (high - low) * self.along.abs().max_element(),
        })
    }

    fn open(&self) -> bool {
        self.known == Known::Little
    }

    /// Where to look next.
    fn place(&self) -> DVec2 {
        self.from + 0.5 * f64::from(self.bounds[0] + self.bounds[1]) * self.along
    }

    /// What was seen there.
    fn take(&mut self, aim: &Aim, seen: Sample) {
        self.middle.get_or_insert(seen);
        let [before, after] = self.values.map(|value| aim.apart(&seen, &value));
        let whole = aim.apart(&self.ends[0], &self.ends[1]);
        let middle = 0.5 * (self.bounds[0] + self.bounds[1]);
        let (nearer, gap) = if before <= after { (0, after) } else { (1, before) };
        (self.bounds[nearer], self.values[nearer]) = (middle, seen);
        let width = self.bounds[1] - self.bounds[0];
        let error = aim.error(self.cuts);
        if gap <= (RAMP * whole).max(error) {
            self.known = Known::Even;
        } else if width <= COARSEST && ERRS * gap * width <= error {
            self.known = Known::Jump;
        }
    }
}

/// Finds out where colours jump along sides, all of them at a time.
pub(super) fn search(sides: &mut [Side], aim: &Aim, look: &mut dyn Look) {
    let mut open: Vec<usize> = (0..sides.len()).filter(|&number| sides[number].open()).collect();
    let mut seen = Vec::with_capacity(open.len());
    while !open.is_empty() {
        seen.clear();
        each(look, open.iter().map(|&number| (sides[number].place(), number)), |sample, number| {
            seen.push((sample, number));
        });
        for &(sample, number) in &seen {
            sides[number].take(aim, sample);
        }
        open.retain(|&number| sides[number].open());
    }
}
