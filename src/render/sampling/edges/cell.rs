//! Pixels and parts of them, and what is seen of those that edges divide.

use super::Aim;
use super::side::{Jump, Side};
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
        let are_alike = |a: &Sample, b: &Sample| aim.apart(a, b) <= alike;
        let continues = |(k, side): (usize, &Side)| {
            let [from, to] = &side.ends;
            match [(i, &leaves), (j, &enters)].into_iter().find(|(jumps, _)| *jumps == k) {
                Some((_, jump)) => are_alike(from, &jump.colors[0]) && are_alike(to, &jump.colors[1]),
                None => are_alike(from, to),
            }
        };
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
    pub(super) fn heart(&self) -> DVec2 {
        0.5 * (self.sides[0].from() + self.sides[2].from())
    }

    /// Two places beside the middle of an edge's chord that tell whether it bends so little that the chord serves; `None`
    /// if it does in any case.
    fn beside(&self, divided: &Divided, aim: &Aim) -> Option<[DVec2; 2]> {
        let [from, to] = divided.ends;
        let chord = to - from;
        let length = chord.length();
        let size = 0.5_f64.powi(self.cuts as i32);
        // What an arc of height h cuts off beside its chord is two thirds of h times the chord.
        let error = f64::from(aim.error(self.cuts) / divided.gap);
        let beside = (1.5 * error * size * size / length).max(divided.doubt);
        let across = chord.perp() * (beside / length);
        let middle = 0.5 * (from + to);
        (beside < f64::from(ALIKE) * size).then_some([middle - across, middle + across])
    }
}

impl Divided {
    /// Whether what is seen at both places beside its chord is what its colours say.
    fn is_straight(&self, seen: [Sample; 2], aim: &Aim) -> bool {
        let [first, last] = self.colors;
        let [to_first, to_last] = [first, last].map(|color| seen.map(|seen| aim.apart(&seen, &color)));
        to_first[0] < to_last[0] && to_last[1] < to_first[1]
    }

    /// The mean colour.
    fn color(&self) -> Sample {
        let ([first, last], share) = (self.colors, self.share as f32);
        if share <= 0.0 || share >= 1.0 {
            return if share > 0.0 { first } else { last };
        }
        std::array::from_fn(|i| share * first[i] + (1.0 - share) * last[i])
    }
}

/// The mean colours of those of some cells that one edge divides in two.
pub(super) fn across_edges(cells: &[Cell], aim: &Aim, look: &mut dyn Look) -> Vec<Option<Sample>> {
    let divided: Vec<_> = cells
        .iter()
        .map(|cell| cell.divided(aim).map(|divided| (cell.beside(&divided, aim), divided)))
        .collect();
    let places: Vec<DVec2> = divided.iter().flatten().filter_map(|(beside, _)| *beside).flatten().collect();
    let seen = all(look, places.into_iter());
    let mut seen = seen.chunks_exact(2);
    let colors = divided.into_iter().map(|divided| {
        let (beside, divided) = divided?;
        let is_straight = match beside.and_then(|_| seen.next()) {
            Some(&[one, other]) => divided.is_straight([one, other], aim),
            _ => true,
        };
        is_straight.then(|| divided.color())
    });
    colors.collect()
}
