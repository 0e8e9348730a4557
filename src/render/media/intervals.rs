//! How a stretch is cut into intervals: where lamps begin and end to light it, and as often as the
//! media ask for (docs/spec/atmosphere-gi.md 2.5 and 2.6).

use std::cell::Cell;
use std::ops::Range as Span;

use smallvec::SmallVec;

use crate::math::Rgb;
use crate::world::Range;
use crate::world::media::Sampling;
use crate::world::screen::{OPEN, SHUT, Screen, UNKNOWN, Verdict, View};

/// A lamp and the part of a stretch it may light.
#[derive(Clone, Debug)]
pub(in crate::render) struct Beam {
    /// Its number.
    pub(super) light: u32,
    /// From … to, as distances.
    pub(super) reach: Range,
    /// The objects that may stand between, where they are few: their places in a march's list.
    pub(super) among: Option<Span<usize>>,
    /// Whether all light comes from one place through air that is clear, or the same everywhere.
    pub(super) simple: bool,
    /// The optical depth of a unit of air, where air takes of its light.
    pub(super) air: Option<Rgb>,
}

/// An object that may stand between a stretch and a lamp.
#[derive(Clone, Debug)]
pub(in crate::render) struct Between {
    pub(super) screen: Screen,
    /// Between which distances it may.
    pub(super) shade: Range,
    /// How the middle of the lamp sees it.
    pub(super) view: View,
    /// What samples have shown, if all points in its shadow are next to each other.
    pub(super) shadow: Option<Shadow>,
    /// The optical depth of a unit of its filling, if its border is all that light comes through, and
    /// it is all that is around the stretch.
    pub(super) shell: Option<Rgb>,
}

/// What is known of a shadow without gaps on a stretch, by distances: the samples found in the light
/// before it and after it, and the first and last ones found in it.
#[derive(Clone, Debug)]
pub(in crate::render) struct Shadow {
    open: Cell<[f64; 2]>,
    shut: Cell<[f64; 2]>,
}

impl Default for Shadow {
    fn default() -> Self {
        let open = Cell::new([f64::NEG_INFINITY, f64::INFINITY]);
        Self { open, shut: Cell::new([f64::INFINITY, f64::NEG_INFINITY]) }
    }
}

impl Shadow {
    /// Whether a sample is in the shadow, as far as others tell.
    #[inline]
    pub(super) fn verdict(&self, s: f64) -> Verdict {
        let ([first, last], [before, after]) = (self.shut.get(), self.open.get());
        if first <= s && s <= last {
            SHUT
        } else if s <= before || after <= s {
            OPEN
        } else {
            UNKNOWN
        }
    }

    /// Takes note of a verdict on a sample.
    #[inline]
    pub(super) fn note(&self, s: f64, verdict: Verdict) {
        let ([first, last], [before, after]) = (self.shut.get(), self.open.get());
        if verdict == SHUT {
            self.shut.set([first.min(s), last.max(s)]);
        } else if s < first && first <= last {
            self.open.set([before.max(s), after]);
        } else if last < s && first <= last {
            self.open.set([before, after.min(s)]);
        }
    }
}

/// A part of a stretch that is sampled for itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    /// The distance where it begins.
    pub(super) start: f64,
    /// Its length.
    pub(super) length: f64,
    /// Whether some lamp reaches it.
    pub(super) lit: bool,
}

impl Interval {
    /// The distance of a place in it, which is 0 where it begins and 1 where it ends.
    #[inline]
    pub(super) fn at(&self, place: f64) -> f64 {
        self.start + place * self.length
    }
}

/// Stretches mostly have no more intervals.
pub(super) type Intervals = SmallVec<[Interval; 4]>;

/// The intervals of a stretch, the nearest first.
pub(super) fn intervals(rule: &Sampling, beams: &[Beam], length: f64) -> Intervals {
    let mut intervals = Intervals::new();
    if beams.is_empty() {
        if length > 0.0 {
            let parts = if rule.plain { 1 } else { rule.intervals.max(1) };
            cut(&Interval { start: 0.0, length, lit: false }, parts, &mut intervals);
        }
        return intervals;
    }
    let pieces = pieces(beams, length);
    let count = pieces.len() as u32;
    let dark = rule.plain && !pieces.iter().any(|piece| piece.lit);
    let weight = |piece: &Interval| if piece.lit { rule.ratio } else { 1.0 - rule.ratio };
    let total: f64 = pieces.iter().map(weight).sum();
    let all = rule.intervals.max(count);
    let mut left = all;
    for (index, piece) in (0..).zip(&pieces) {
        let parts = if count == 1 {
            if dark { 1 } else { left }
        } else {
            let share = (f64::from(all) * weight(piece) / total) as u32;
            share.saturating_add(1).min((left + index + 1).saturating_sub(count)).max(1)
        };
        left = left.saturating_sub(parts);
        cut(piece, parts, &mut intervals);
    }
    intervals
}

/// Adds the parts of a piece.
fn cut(piece: &Interval, parts: u32, intervals: &mut Intervals) {
    let length = piece.length / f64::from(parts);
    for part in 0..parts {
        intervals.push(Interval { start: piece.start + f64::from(part) * length, length, ..*piece });
    }
}

/// Lit and unlit pieces in turn.
fn pieces(beams: &[Beam], length: f64) -> SmallVec<[Interval; 8]> {
    let mut lit: SmallVec<[Range; 4]> = beams.iter().map(|beam| beam.reach).collect();
    lit.sort_unstable_by(|a, b| a.min.total_cmp(&b.min));
    lit.dedup_by(|next, kept| {
        let touches = next.min <= kept.max;
        if touches {
            kept.max = kept.max.max(next.max);
        }
        touches
    });
    let mut pieces = SmallVec::new();
    let mut piece = |from: f64, to: f64, lit: bool| {
        if to > from {
            pieces.push(Interval { start: from, length: to - from, lit });
        }
    };
    let mut end = 0.0;
    for Range { min, max } in lit {
        piece(end, min, false);
        piece(min, max, true);
        end = max;
    }
    piece(end, length, false);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::world::media::Method;

    fn rule(intervals: u32) -> Sampling {
        Sampling {
            method: Method::Adaptive { threshold: 0.1, level: 3 },
            intervals,
            min_samples: 10,
            jitter: 0.0,
            ratio: 0.9,
            plain: true,
        }
    }

    fn beam(min: f64, max: f64) -> Beam {
        Beam { light: 0, reach: Range { min, max }, among: None, simple: true, air: None }
    }

    fn shown(intervals: Intervals) -> Vec<(f64, f64, bool)> {
        intervals.iter().map(|i| (i.start, i.length, i.lit)).collect()
    }

    #[test]
    fn samples_between_dark_ones_are_dark_and_those_beyond_light_ones_light() {
        let shadow = Shadow::default();
        shadow.note(1.0, OPEN);
        assert_eq!(shadow.verdict(0.5), UNKNOWN);
        shadow.note(3.0, SHUT);
        shadow.note(5.0, SHUT);
        shadow.note(2.0, OPEN);
        shadow.note(6.0, OPEN);
        let found = [1.5, 2.5, 4.0, 5.5, 7.0].map(|s| shadow.verdict(s));
        assert_eq!(found, [OPEN, UNKNOWN, SHUT, UNKNOWN, OPEN]);
    }

    #[test]
    fn plain_media_in_the_dark_are_one_interval() {
        assert_eq!(shown(intervals(&rule(7), &[], 4.0)), [(0.0, 4.0, false)]);
        let dense = Sampling { plain: false, ..rule(2) };
        assert_eq!(shown(intervals(&dense, &[], 4.0)), [(0.0, 2.0, false), (2.0, 2.0, false)]);
    }

    #[test]
    fn lit_pieces_get_most_of_the_intervals() {
        let found = intervals(&rule(10), &[beam(1.0, 3.0)], 4.0);
        let lit = found.iter().filter(|interval| interval.lit).count();
        // Shares of 10 are 0.9, 8.2 and 0.9: one for the first, eight for the lit, one is left.
        assert_eq!((found.len(), lit), (10, 8));
        assert_eq!(found.last().map(|i| i.start + i.length), Some(4.0));
    }

    #[test]
    fn overlapping_and_touching_beams_light_one_piece() {
        let beams = [beam(2.0, 3.0), beam(0.0, 1.5), beam(1.0, 2.0)];
        assert_eq!(shown(intervals(&rule(1), &beams, 3.0)), [(0.0, 3.0, true)]);
        assert_eq!(intervals(&rule(1), &[beam(1.0, 3.0)], 3.0).len(), 2);
    }

    #[test]
    fn every_piece_has_an_interval_whatever_the_ratio() {
        for ratio in [-3.0, 0.0, 0.5, 1.0, 7.0, f64::NAN] {
            let rule = Sampling { ratio, ..rule(5) };
            let found = intervals(&rule, &[beam(1.0, 2.0), beam(3.0, 4.0)], 5.0);
            let whole: f64 = found.iter().map(|interval| interval.length).sum();
            assert!((whole - 5.0).abs() < 1e-12, "{ratio}: {found:?}");
        }
    }
}
