//! Piecewise cubic curves in a plane: the outlines of `prism` and the profiles of `lathe`
//! (docs/spec/primitives.md 6).

use crate::math::roots::{Roots, between, bracketed, roots_between};
use crate::math::{DVec2, Lanes};

/// One piece of a curve, over w from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Coefficients of 1, w, w², w³.
    c: [DVec2; 4],
    /// The last point as given, so that neighbours agree on it to the last bit.
    end: DVec2,
    /// What POV-Ray takes for its box: the exact one, or that of a Bézier segment's control points.
    hull: [DVec2; 2],
    /// Whether it is a straight line on which w counts the way.
    straight: bool,
    /// The control points of its Bézier form, between which it lies: their x and their y.
    control: [Lanes; 2],
}

impl Segment {
    fn new(c: [DVec2; 4], end: DVec2) -> Self {
        let straight = c[2] == DVec2::ZERO && c[3] == DVec2::ZERO;
        let points = [c[0], c[0] + c[1] / 3.0, c[0] + (2.0 * c[1] + c[2]) / 3.0, end];
        let control = [Lanes(points.map(|p| p.x)), Lanes(points.map(|p| p.y))];
        let mut segment = Self { c, end, hull: [c[0].min(end), c[0].max(end)], straight, control };
        for coordinate in [|p: DVec2| p.x, |p: DVec2| p.y] {
            for w in segment.extremes(coordinate).as_slice() {
                let p = segment.point(*w);
                segment.hull = [segment.hull[0].min(p), segment.hull[1].max(p)];
            }
        }
        segment
    }

    /// A straight line.
    pub fn linear(a: DVec2, b: DVec2) -> Self {
        Self::new([a, b - a, DVec2::ZERO, DVec2::ZERO], b)
    }

    /// From `b` to `c`, with `a` before.
    pub fn quadratic(a: DVec2, b: DVec2, c: DVec2) -> Self {
        Self::new([b, 0.5 * (c - a), 0.5 * (a - 2.0 * b + c), DVec2::ZERO], c)
    }

    /// From `b` to `c`, with `a` before and `d` after (Catmull and Rom).
    pub fn cubic(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Self {
        let square = a - 2.5 * b + 2.0 * c - 0.5 * d;
        let cube = 0.5 * (d - a) + 1.5 * (b - c);
        Self::new([b, 0.5 * (c - a), square, cube], c)
    }

    /// From `a` to `c`, with the control point `b`.
    pub fn parabola(a: DVec2, b: DVec2, c: DVec2) -> Self {
        Self::new([a, 2.0 * (b - a), a - 2.0 * b + c, DVec2::ZERO], c)
    }

    /// From `a` to `d`, with the control points `b` and `c`.
    pub fn bezier(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Self {
        let segment = Self::new([a, 3.0 * (b - a), 3.0 * (a - 2.0 * b + c), d - a + 3.0 * (b - c)], d);
        Self { hull: [a.min(b).min(c).min(d), a.max(b).max(c).max(d)], ..segment }
    }

    /// The point at `w`; exactly the given ones at both ends.
    pub fn point(&self, w: f64) -> DVec2 {
        if w == 1.0 {
            self.end
        } else if self.straight {
            self.c[0] + w * self.c[1]
        } else {
            self.c[0] + w * (self.c[1] + w * (self.c[2] + w * self.c[3]))
        }
    }

    /// Whether it is a straight line on which w counts the way.
    pub fn is_straight(&self) -> bool {
        self.straight
    }

    /// Whether all of it is surely on one side of a line, by the value of `along` times the coordinates plus `offset`.
    #[inline(always)]
    pub(super) fn is_beside(&self, along: DVec2, offset: f64) -> bool {
        let (x, y) = (self.control[0] * along.x, self.control[1] * along.y);
        let side = x + y + offset;
        let noise = (x.abs() + y.abs() + offset.abs()) * 1e-14;
        (side - noise).all_positive() || (-side - noise).all_positive()
    }

    /// Where on a straight one a linear function of the points, of which both ends are given, changes
    /// its sign.
    pub(super) fn straight_change(from: f64, to: f64) -> Option<f64> {
        ((from > 0.0) != (to > 0.0)).then(|| from / (from - to))
    }

    /// The derivative at `w`.
    pub fn slope(&self, w: f64) -> DVec2 {
        self.c[1] + w * (2.0 * self.c[2] + 3.0 * w * self.c[3])
    }

    /// Coefficients of 1, v, v², v³ for the points at `w + v`.
    pub(super) fn about(&self, w: f64) -> [DVec2; 4] {
        let [_, _, c, d] = self.c;
        [self.point(w), self.slope(w), c + 3.0 * w * d, d]
    }

    /// One coordinate, or any linear function of both, as a polynomial in w.
    pub fn polynomial(&self, coordinate: impl Fn(DVec2) -> f64) -> [f64; 4] {
        let [a, b, c, d] = self.c;
        [coordinate(a), coordinate(b), coordinate(c), coordinate(d)]
    }

    /// The box around.
    pub fn hull(&self) -> [DVec2; 2] {
        self.hull
    }

    /// Where a coordinate turns.
    pub(super) fn extremes(&self, coordinate: impl Fn(DVec2) -> f64) -> Roots<3> {
        let [_, b, c, d] = self.polynomial(coordinate);
        roots_between(&[b, 2.0 * c, 3.0 * d], 0.0, 1.0)
    }
}

/// The boxes around four segments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hulls {
    pub(super) low: [Lanes; 2],
    pub(super) high: [Lanes; 2],
}

impl Hulls {
    /// Around up to four segments; what is missing is like the first.
    fn new(segments: &[Segment]) -> Self {
        let side = |which: usize, axis: usize| {
            Lanes([0, 1, 2, 3].map(|lane| segments.get(lane).unwrap_or(&segments[0]).hull[which][axis]))
        };
        Self { low: [side(0, 0), side(0, 1)], high: [side(1, 0), side(1, 1)] }
    }

    /// Which of them a line doesn't pass by: of the others all points are on one side, by the value of `along`
    /// times their coordinates plus `offset`.
    #[inline(always)]
    pub(super) fn met_by(&self, along: DVec2, offset: f64) -> u32 {
        let offset = Lanes::splat(offset);
        let (mut middle, mut reach, mut size) = (offset, Lanes::ZERO, offset.abs());
        for axis in 0..2 {
            let (low, high) = (self.low[axis] * along[axis], self.high[axis] * along[axis]);
            let center = (low + high) * 0.5;
            middle = middle + center;
            reach = reach + ((high - low) * 0.5).abs();
            size = size + center.abs();
        }
        let room = reach + (size + reach) * 1e-14;
        (room - middle.abs()).bits(|room| room >= 0.0)
    }

    /// Which of them meet a box.
    #[inline(always)]
    pub(super) fn touching(&self, [least, most]: [DVec2; 2]) -> u32 {
        let mut bits = 0b1111;
        for axis in 0..2 {
            bits &= self.low[axis].bits(|low| low <= most[axis]);
            bits &= self.high[axis].bits(|high| high >= least[axis]);
        }
        bits
    }
}

/// A stretch of a segment on which y only rises or only falls.
#[derive(Clone, Copy, Debug)]
struct Piece {
    segment: Segment,
    /// Both ends: w and y there.
    ends: [(f64, f64); 2],
}

impl Piece {
    /// Whether the line from `p` towards +x crosses it; of its ends only those above `p` are beyond the line.
    fn is_crossed(&self, p: DVec2) -> bool {
        let [from, to] = self.ends;
        let [low, high] = self.segment.hull;
        if (from.1 > p.y) == (to.1 > p.y) || high.x <= p.x {
            return false;
        }
        if low.x > p.x {
            return true;
        }
        if self.segment.is_straight() {
            let w = Segment::straight_change(from.1 - p.y, to.1 - p.y);
            return w.is_some_and(|w| self.segment.point(w).x > p.x);
        }
        let mut above = self.segment.polynomial(|on| on.y);
        above[0] -= p.y;
        let (from, to) = ((from.0, from.1 - p.y), (to.0, to.1 - p.y));
        let at_end = if from.1 == 0.0 { from.0 } else { to.0 };
        self.segment.point(bracketed(&above, from, to).unwrap_or(at_end)).x > p.x
    }
}

/// Segments one after another; several outlines may follow each other.
#[derive(Clone, Debug)]
pub struct Curve {
    segments: Vec<Segment>,
    /// Of four segments each.
    hulls: Vec<Hulls>,
    pieces: Vec<Piece>,
    hull: [DVec2; 2],
    open_ends: Vec<DVec2>,
}

impl Curve {
    /// Of these segments; neighbours are joined where one starts with the other's last point.
    pub fn new(segments: Vec<Segment>) -> Self {
        let mut pieces = Vec::new();
        let mut hull = [DVec2::INFINITY, DVec2::NEG_INFINITY];
        let mut open_ends: Vec<DVec2> = Vec::new();
        for segment in &segments {
            for end in [segment.point(0.0), segment.point(1.0)] {
                match open_ends.iter().position(|other| *other == end) {
                    Some(place) => {
                        open_ends.swap_remove(place);
                    }
                    None => open_ends.push(end),
                }
            }
            hull = [hull[0].min(segment.hull[0]), hull[1].max(segment.hull[1])];
            let mut start = (0.0, segment.point(0.0).y);
            let turns = segment.extremes(|p| p.y);
            let within = turns.as_slice().iter().copied().filter(|w| *w > 0.0 && *w < 1.0);
            for w in within.chain([1.0]) {
                let end = (w, segment.point(w).y);
                pieces.push(Piece { segment: *segment, ends: [start, end] });
                start = end;
            }
        }
        let hulls = segments.chunks(Lanes::COUNT).map(Hulls::new).collect();
        Self { segments, hulls, pieces, hull, open_ends }
    }

    /// Calls back with the segments, and their numbers, whose bits are set in what `near` says of four boxes, until
    /// that says to stop.
    #[inline(always)]
    pub(super) fn each_near(
        &self,
        near: impl Fn(&Hulls) -> u32,
        mut found: impl FnMut(u32, &Segment) -> bool,
    ) {
        for (four, hulls) in self.hulls.iter().enumerate() {
            let mut bits = near(hulls);
            while bits != 0 {
                let number = Lanes::COUNT * four + bits.trailing_zeros() as usize;
                if self.segments.get(number).is_some_and(|segment| found(number as u32, segment)) {
                    return;
                }
                bits &= bits - 1;
            }
        }
    }

    /// The segments.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// The box around all.
    pub fn hull(&self) -> [DVec2; 2] {
        self.hull
    }

    /// Whether a box holds places to the left of where an odd number of segments end, at that height: beside them
    /// other places are [enclosed](Self::encloses) though no segment parts them.
    pub(super) fn is_open_within(&self, [one, other]: [DVec2; 2]) -> bool {
        let (low, high) = (one.min(other), one.max(other));
        // What is no number may be anywhere.
        let is_beside = |end: &DVec2| end.y < low.y || end.y > high.y || end.x < low.x;
        !self.open_ends.iter().all(is_beside)
    }

    /// Whether the curve crosses the line from `p` towards +x an odd number of times. A point where
    /// stretches join counts for just one of them.
    pub fn encloses(&self, p: DVec2) -> bool {
        let [low, high] = self.hull;
        if p.y < low.y || p.y > high.y || p.x >= high.x {
            return false;
        }
        let mut odd = false;
        for piece in &self.pieces {
            odd ^= piece.is_crossed(p);
        }
        odd
    }
}

/// Calls back with every argument between two `ends` at which `value` changes sign, given `seeds` near which it
/// may, ascending. What touches zero and returns doesn't count, and a zero at an end counts for one of the
/// stretches that share it, so that crossings stay in pairs. Between arguments that are not `near` changes are of no
/// interest.
#[inline(always)]
pub(super) fn sign_changes(
    seeds: &[f64],
    ends: [f64; 2],
    value: impl Fn(f64) -> f64,
    near: impl Fn(f64, f64) -> bool,
    mut found: impl FnMut(f64),
) {
    let mut from = (ends[0], value(ends[0]));
    for (place, &seed) in seeds.iter().enumerate() {
        let w = seeds.get(place + 1).map_or(ends[1], |next| 0.5 * (seed + next));
        let to = (w, value(w));
        if (from.1 > 0.0) != (to.1 > 0.0) && near(from.0, to.0) {
            found(change_near(seed, NEXT * (ends[1] - ends[0]), from, to, &value));
        }
        from = to;
    }
    if seeds.is_empty() {
        let to = (ends[1], value(ends[1]));
        if (from.1 > 0.0) != (to.1 > 0.0) && near(from.0, to.0) {
            found(between(from, to, &value));
        }
    }
}

/// How exact seeds are that belong to single roots, and more, as a share of the way.
const NEXT: f64 = 1e-10;

/// Where between two points the sign changes, most likely as near to `seed` as `next`.
#[inline(always)]
fn change_near(seed: f64, next: f64, from: (f64, f64), to: (f64, f64), value: &impl Fn(f64) -> f64) -> f64 {
    let at = |w: f64| (w, value(w));
    let (low, high) = (at((seed - next).max(from.0)), at((seed + next).min(to.0)));
    match (low.1 > 0.0) != (high.1 > 0.0) {
        true => between(low, high, value),
        false => between(from, to, value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    #[test]
    fn segments_pass_through_the_points_they_join() {
        let [a, b, c, d] = [p(-1.0, 0.3), p(0.1, 0.7), p(1.3, 0.2), p(2.0, -1.0)];
        for (segment, start, end) in [
            (Segment::linear(a, b), a, b),
            (Segment::quadratic(a, b, c), b, c),
            (Segment::cubic(a, b, c, d), b, c),
            (Segment::parabola(a, b, c), a, c),
            (Segment::bezier(a, b, c, d), a, d),
        ] {
            assert_eq!((segment.point(0.0), segment.point(1.0)), (start, end));
            assert!(segment.point(1.0 - 1e-9).abs_diff_eq(end, 1e-8));
            let slope = (segment.point(0.5 + 1e-6) - segment.point(0.5 - 1e-6)) / 2e-6;
            assert!(segment.slope(0.5).abs_diff_eq(slope, 1e-8));
        }
    }

    #[test]
    fn a_corner_at_the_height_of_the_point_counts_once() {
        let corners = [p(0.0, -1.0), p(1.0, 0.0), p(0.0, 1.0), p(-1.0, 0.0), p(0.0, -1.0)];
        let square = Curve::new(corners.windows(2).map(|c| Segment::linear(c[0], c[1])).collect());
        assert!(square.encloses(p(0.5, 0.0)) && square.encloses(p(-0.5, 0.0)));
        assert!(!square.encloses(p(1.5, 0.0)) && !square.encloses(p(-1.5, 0.0)));
        assert!(!square.encloses(p(-0.5, 1.0)) && !square.encloses(p(-0.5, -1.0)));
    }
}
