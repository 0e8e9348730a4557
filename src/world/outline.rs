//! What objects hide of a flat light as one point sees it: lines in the light's own plane, each with the
//! side that an object's shadow is on, so that for a place of the light a few sums tell whether it is seen.
//!
//! A verdict is only given where no rounding can change it, so it is the one the surface would give.

mod caster;
mod cylinder;
mod solid;
mod torus;

pub use caster::Caster;
use torus::Ring;

use super::screen::{OPEN, SHUT, UNKNOWN, Verdict, View};
use crate::math::DVec3;

/// Directions that differ less than this from a border may be on either side of it.
const BLUR: f64 = 1e-8;

/// Coordinates are right to this part of the largest.
const ROUNDING: f64 = 1e-12;

/// A flat light as a point sees it: all ways there are `middle` + x `axes[0]` + y `axes[1]`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sight {
    /// The point.
    pub from: DVec3,
    /// The way to the light's middle.
    pub middle: DVec3,
    /// The light's edges.
    pub axes: [DVec3; 2],
    /// The most that x and y are, and the least when negated.
    pub reach: [f64; 2],
}

impl Sight {
    /// No way is longer.
    fn farthest(&self) -> f64 {
        let [a, b] = self.axes;
        self.middle.length() + a.length() * self.reach[0] + b.length() * self.reach[1]
    }

    /// The same in a space to which `point` and `vector` map.
    fn mapped(&self, point: impl Fn(DVec3) -> DVec3, vector: impl Fn(DVec3) -> DVec3) -> Self {
        let [a, b] = self.axes;
        Self {
            from: point(self.from),
            middle: vector(self.middle),
            axes: [vector(a), vector(b)],
            reach: self.reach,
        }
    }

    /// The way to a place of the light.
    #[inline(always)]
    fn way(&self, x: f64, y: f64) -> DVec3 {
        self.middle + self.axes[0] * x + self.axes[1] * y
    }
}

/// The sum `constant` + x `along[0]` + y `along[1]` over the places of a light.
#[derive(Clone, Copy, Debug)]
struct Line {
    constant: f64,
    along: [f64; 2],
    /// Where the sum is below, nothing is in the way.
    open: f64,
    /// Only where it is above, something surely is.
    shut: f64,
}

impl Line {
    #[inline(always)]
    fn at(&self, x: f64, y: f64) -> f64 {
        self.constant + self.along[0] * x + self.along[1] * y
    }
}

/// What is known from a side of a [`Line`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    /// The shadow ends there.
    Both,
    /// The shadow doesn't reach beyond it.
    Outer,
    /// There is no gap in the shadow before it.
    Inner,
}

/// How a part of an object is seen.
#[derive(Clone, Copy, Debug)]
enum Part {
    /// By the lines from the first to before the last.
    Lines(u32, u32),
    /// By a torus.
    Ring(Ring),
    /// By balls.
    Balls(View),
}

/// What several objects hide of a light.
#[derive(Debug, Default)]
pub struct Outlines {
    lines: Vec<Line>,
    /// The parts of objects, with their objects' numbers, those of an object next to each other.
    parts: Vec<(u32, Part)>,
    sight: Sight,
}

impl Outlines {
    /// Starts anew for another sight.
    pub fn clear(&mut self, sight: &Sight) {
        self.lines.clear();
        self.parts.clear();
        self.sight = *sight;
    }

    /// Whether nothing is in the way anywhere.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Adds an object of which only balls are known.
    pub fn add_balls(&mut self, object: u32, view: &View) {
        self.parts.push((object, Part::Balls(*view)));
    }

    /// Adds an object, but for those that hide nothing (`OPEN`) or all of the light (`SHUT`); `None` where it
    /// has no outline as seen from there.
    pub fn add(&mut self, object: u32, caster: &Caster, sight: &Sight) -> Option<Verdict> {
        let (lines, parts) = (self.lines.len(), self.parts.len());
        let verdict = caster.look(object, sight, self);
        if verdict != Some(UNKNOWN) {
            self.lines.truncate(lines);
            self.parts.truncate(parts);
        }
        verdict
    }

    /// The verdict on a place of the light; `near` is filled with the objects that only their surfaces can
    /// decide on.
    #[inline]
    pub fn verdict(&self, x: f64, y: f64, near: &mut Vec<u32>) -> Verdict {
        near.clear();
        let mut verdict = OPEN;
        for (object, part) in &self.parts {
            let found = match part {
                &Part::Lines(first, last) => self.beside_lines(first, last, x, y),
                Part::Ring(ring) => ring.verdict(x, y),
                Part::Balls(view) => view.verdict(self.sight.way(x, y).to_array()),
            };
            if found == SHUT {
                return SHUT;
            }
            if found == UNKNOWN {
                verdict = UNKNOWN;
                if near.last() != Some(object) {
                    near.push(*object);
                }
            }
        }
        verdict
    }

    #[inline]
    fn beside_lines(&self, first: u32, last: u32, x: f64, y: f64) -> Verdict {
        let mut verdict = SHUT;
        for line in &self.lines[first as usize..last as usize] {
            let sum = line.at(x, y);
            if sum < line.open {
                return OPEN;
            }
            if sum <= line.shut {
                verdict = UNKNOWN;
            }
        }
        verdict
    }
}

/// Collects the lines of a part.
struct Border<'a> {
    lines: &'a mut Vec<Line>,
    first: usize,
    sight: &'a Sight,
    /// Whether nothing is in the way of the whole light.
    open: bool,
}

impl<'a> Border<'a> {
    fn new(lines: &'a mut Vec<Line>, sight: &'a Sight) -> Self {
        Self { first: lines.len(), lines, sight, open: false }
    }

    /// Adds the line where `normal` · way + `constant` is zero, but for `blur` of it; the shadow is where
    /// that is positive.
    #[inline]
    fn add(&mut self, normal: DVec3, constant: f64, blur: f64, side: Side) {
        let Sight { middle, axes: [a, b], reach, .. } = *self.sight;
        let constant = normal.dot(middle) + constant;
        let along = [normal.dot(a), normal.dot(b)];
        let reach = along[0].abs() * reach[0] + along[1].abs() * reach[1];
        self.open |= side != Side::Inner && constant + reach < -blur;
        // A line that isn't known is beside no place.
        let beside = constant - reach > blur;
        if !beside {
            let open = if side == Side::Inner { f64::NEG_INFINITY } else { -blur };
            let shut = if side == Side::Outer { f64::NEG_INFINITY } else { blur };
            self.lines.push(Line { constant, along, open, shut });
        }
    }

    /// There may be gaps anywhere.
    fn is_thin(&mut self) {
        let (open, shut) = (f64::NEG_INFINITY, f64::INFINITY);
        self.lines.push(Line { constant: 0.0, along: [0.0; 2], open, shut });
    }

    /// What is known of all places, and the part for the others.
    fn finish(self) -> (Verdict, Part) {
        let part = Part::Lines(self.first as u32, self.lines.len() as u32);
        let verdict = match (self.open, self.first == self.lines.len()) {
            (true, _) => OPEN,
            (false, true) => SHUT,
            (false, false) => UNKNOWN,
        };
        (verdict, part)
    }
}
