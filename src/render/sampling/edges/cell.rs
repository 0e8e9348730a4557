//! Pixels and parts of them, and what is seen of those that edges divide.

use super::Aim;
use super::side::{Jump, Side, search};
use crate::math::DVec2;
use crate::render::sampling::even::Sum;
use crate::render::sampling::{Look, Sample, all, mean};

/// What is unlike by at most this share of an edge belongs to one of the edge's colours.
const ALIKE: f32 = 0.25;

/// A pixel or a part of one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// So often was the pixel cut into quarters.
    pub cuts: u32,
    /// Colours of the corners, one after the other around it.
    pub corners: [Sample; 4],
    pub middle: Sample,
    /// From each corner to the next.
    pub sides: [Side; 4],
}

/// What is seen of a cell whose corners and middle say that colours change evenly.
///
/// A third of what the corners say and two thirds of what the middle says is right for cubic polynomials (Simpson).
#[inline]
pub(super) fn even(aim: &Aim, cuts: u32, corners: &[Sample; 4], middle: &Sample) -> Option<Sample> {
    let around = mean(*corners);
    let off = aim.apart(&around, middle);
    (off <= aim.error(cuts)).then(|| mean([around, *middle, *middle]))
}

/// An edge from one side of a cell to another.
struct Divided {
    /// The colours on both sides of it.
    colors: [Sample; 2],
    /// The share of the first.
    share: f64,
    /// The edge's ends.
    ends: [DVec2; 2],
    /// How far off they may be.
    doubt: f64,
    /// How far apart the colours are as they are seen.
    gap: f32,
}

impl Cell {
    /// A pixel from its upper left corner on, of whose sides nothing is known.
    pub(super) fn new(aim: &Aim, from: DVec2, corners: [Sample; 4], middle: Sample) -> Self {
        let ways = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y];
        let mut at = from;
        let sides = std::array::from_fn(|i| {
            let side = Side::new(aim, 0, (at, ways[i]), [corners[i], corners[(i + 1) % 4]]);
            at += ways[i];
            side
        });
        Self { cuts: 0, corners, middle, sides }
    }

    /// The mean colour of a cell that is not even.
    fn color(&self, aim: &Aim, look: &mut dyn Look) -> Sample {
        if let Some(color) = self.across_an_edge(aim, look) {
            return color;
        }
        if self.cuts >= aim.depth {
            return mean([mean(self.corners), self.middle]);
        }
        self.quarters(4, aim, look).map_or(self.middle, |(color, _)| color)
    }

    /// The mean colour, if one edge divides the cell in two.
    pub(super) fn across_an_edge(&self, aim: &Aim, look: &mut dyn Look) -> Option<Sample> {
        let divided = self.divided(aim).filter(|divided| self.is_straight(divided, aim, look))?;
        let ([first, last], share) = (divided.colors, divided.share as f32);
        if share <= 0.0 || share >= 1.0 {
            return Some(if share > 0.0 { first } else { last });
        }
        Some(std::array::from_fn(|i| share * first[i] + (1.0 - share) * last[i]))
    }

    /// The edge that divides the cell in two, if the samples at its corners, sides and middle tell of nothing else.
    fn divided(&self, aim: &Aim) -> Option<Divided> {
        let mut jumps = self.sides.iter().enumerate().filter_map(|(i, side)| Some((i, side.jump()?)));
        let ((i, leaves), (j, enters)) = (jumps.next()?, jumps.next()?);
        if jumps.next().is_some() {
            return None;
        }
        let gap_of = |jump: &Jump| aim.apart(&jump.colors[0], &jump.colors[1]);
        let gap = gap_of(&leaves).max(gap_of(&enters));
        let alike = (ALIKE * gap).max(aim.error(self.cuts));
        let continues =
            |(k, side): (usize, &Side)| k == i || k == j || aim.apart(&side.ends[0], &side.ends[1]) <= alike;
        if !self.sides.iter().enumerate().all(continues) {
            return None;
        }
        // The first part is what one meets from the first jump on, the second what is before and after.
        let mut parts = [Sum::default(); 2];
        for (first, jump) in [(1, &leaves), (0, &enters)] {
            parts[0].add(jump.colors[first], 1.0);
            parts[1].add(jump.colors[1 - first], 1.0);
        }
        let mut outline = leaves.at;
        let mut area = 0.0;
        let ends = [leaves.at, enters.at];
        for (k, (corner, side)) in self.corners.iter().zip(&self.sides).enumerate() {
            let first = i < k && k <= j;
            parts[usize::from(!first)].add(*corner, 1.0);
            if first {
                area += (outline - leaves.at).perp_dot(side.from() - leaves.at);
                outline = side.from();
            }
        }
        area += (outline - leaves.at).perp_dot(enters.at - leaves.at);
        let share = (0.5 * area * 4.0_f64.powi(self.cuts as i32)).clamp(0.0, 1.0);
        let [first, last] = [parts[0].mean(), parts[1].mean()];
        let doubt = leaves.doubt.max(enters.doubt);
        let [to_first, to_last] = [first, last].map(|color| aim.apart(&self.middle, &color));
        let like_first = to_first < to_last;
        let chord = enters.at - leaves.at;
        let ahead = chord.perp_dot(leaves.at - self.heart()) / chord.length().max(f64::MIN_POSITIVE);
        let on_first = ahead > 0.0;
        if to_first.min(to_last) > alike || (like_first != on_first && ahead.abs() > doubt) {
            return None;
        }
        parts[usize::from(!like_first)].add(self.middle, 2.0);
        Some(Divided { colors: [parts[0].mean(), parts[1].mean()], share, ends, doubt, gap })
    }

    /// The middle's place.
    fn heart(&self) -> DVec2 {
        0.5 * (self.sides[0].from() + self.sides[2].from())
    }

    /// Whether an edge bends so little that its chord serves, as two samples beside the chord's middle show.
    fn is_straight(&self, divided: &Divided, aim: &Aim, look: &mut dyn Look) -> bool {
        let [from, to] = divided.ends;
        let chord = to - from;
        let length = chord.length();
        let size = 0.5_f64.powi(self.cuts as i32);
        // What an arc of height h cuts off beside its chord is two thirds of h times the chord.
        let error = f64::from(aim.error(self.cuts) / divided.gap);
        let beside = (1.5 * error * size * size / length).max(divided.doubt);
        if beside >= f64::from(ALIKE) * size {
            return true;
        }
        let across = chord.perp() * (beside / length);
        let middle = 0.5 * (from + to);
        let seen = all(look, [middle - across, middle + across].into_iter());
        let [first, last] = divided.colors;
        let like =
            |seen: &Sample, this: &Sample, other: &Sample| aim.apart(seen, this) < aim.apart(seen, other);
        like(&seen[0], &first, &last) && like(&seen[1], &last, &first)
    }

    /// The mean of the four quarters and how many of them are not even, if these are at most so `many`.
    pub(super) fn quarters(&self, many: usize, aim: &Aim, look: &mut dyn Look) -> Option<(Sample, usize)> {
        let heart = self.heart();
        let missing = self.sides.iter().filter(|side| side.middle.is_none()).map(Side::halfway);
        let hearts = self.sides.iter().map(|side| 0.5 * (side.from() + heart));
        let seen = all(look, hearts.chain(missing).collect::<Vec<_>>().into_iter());
        let (hearts, mut missing) = (&seen[..4], seen[4..].iter());
        let middles =
            self.sides.map(|side| side.middle.or_else(|| missing.next().copied()).unwrap_or(self.middle));
        // Halves of the sides, one after the other around the cell, and the sides from their middles inwards.
        let cuts = self.cuts + 1;
        let mut sides: Vec<Side> = Vec::with_capacity(12);
        for (side, middle) in self.sides.iter().zip(middles) {
            sides.extend(side.halves(aim, middle));
        }
        for (side, middle) in self.sides.iter().zip(middles) {
            let from = side.halfway();
            sides.push(Side::new(aim, cuts, (from, heart - from), [middle, self.middle]));
        }
        let corners = |i: usize| [self.corners[i], middles[i], self.middle, middles[(i + 3) % 4]];
        let sides_of = |i: usize| [2 * i, 8 + i, 8 + (i + 3) % 4, 2 * ((i + 3) % 4) + 1];
        let evens: [_; 4] = std::array::from_fn(|i| even(aim, cuts, &corners(i), &hearts[i]));
        let uneven = evens.iter().filter(|even| even.is_none()).count();
        if uneven > many {
            return None;
        }
        let mut wanted: Vec<usize> = (0..4).filter(|&i| evens[i].is_none()).flat_map(sides_of).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let mut searched: Vec<Side> = wanted.iter().map(|&number| sides[number]).collect();
        search(&mut searched, aim, look);
        for (number, side) in wanted.into_iter().zip(searched) {
            sides[number] = side;
        }
        let quarter = |i: usize| {
            evens[i].unwrap_or_else(|| {
                let [outward, inward, back, home] = sides_of(i).map(|number| sides[number]);
                let sides = [outward, inward, back.reversed(), home];
                Self { cuts, corners: corners(i), middle: hearts[i], sides }.color(aim, look)
            })
        };
        Some((mean([0, 1, 2, 3].map(quarter)), uneven))
    }
}
