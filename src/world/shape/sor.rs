//! `sor`, a surface of revolution (docs/spec/primitives.md 6.2).

use super::curve::sign_changes;
use super::lathe::turn;
use super::stretch::{End, Stretch};
use super::{Crossing, Shape, uncrossed};
use crate::math::roots::roots_between;
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec2, DVec3, Lanes};
use crate::world::{Range, Ray};

/// About the y axis; the square of the radius is a cubic of the height, segment by segment.
///
/// Parts: 0 the lower end, 1 the upper, then the segments upward.
#[derive(Clone, Debug, PartialEq)]
pub struct Sor {
    segments: Vec<Segment>,
    /// Of four segments each.
    rings: Vec<Rings>,
    bounds: Bounds,
    open: bool,
}

/// What rays must come near to meet four segments; what is missing is like the first.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Rings {
    low: Lanes,
    high: Lanes,
    /// What no square of the radius is below or above.
    narrow: Lanes,
    wide: Lanes,
}

/// Between two heights.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Segment {
    low: f64,
    high: f64,
    /// The square of the radius over the height above `low`, the constant first.
    square: [f64; 4],
    /// What no square of the radius is below or above.
    bounds: [f64; 2],
}

/// A ray as a surface of revolution sees it.
struct Passing {
    ray: Ray,
    /// Where it comes nearest to the axis; not finite along the axis.
    nearest: f64,
    /// Its distance from the axis there, squared.
    least: f64,
    /// Between which distances it is in the cylinder around.
    within: [f64; 2],
    /// Between which distances crossings count.
    wanted: [f64; 2],
}

/// Many times what the square of a radius is rounded by, as a share.
const ROOM: f64 = 1e-9;

/// Parts before the segments.
const ENDS: u32 = 2;

impl Segment {
    /// Square of the radius at height `y`, and its derivative.
    fn at(&self, y: f64) -> (f64, f64) {
        let [a, b, c, d] = self.square;
        let h = y - self.low;
        (a + h * (b + h * (c + h * d)), b + h * (2.0 * c + h * 3.0 * d))
    }

    /// From the points at both ends and their neighbours: square and slope of the radius are given there.
    fn new(points: &[DVec2]) -> Self {
        let [before, from, to, after] = [points[0], points[1], points[2], points[3]];
        let height = to.y - from.y;
        let slope = |a: DVec2, at: DVec2, b: DVec2| 2.0 * at.x * (b.x - a.x) / (b.y - a.y);
        let (start, end) = (slope(before, from, to), slope(from, to, after));
        let mean = (to.x - from.x) * (to.x + from.x) / height;
        let square = (3.0 * mean - 2.0 * start - end) / height;
        let cube = (start + end - 2.0 * mean) / (height * height);
        let mut segment = Self {
            low: from.y,
            high: to.y,
            square: [from.x * from.x, start, square, cube],
            bounds: [0.0; 2],
        };
        segment.bounds = segment.extremes();
        segment
    }

    /// The least and the greatest square of the radius, with some room.
    fn extremes(&self) -> [f64; 2] {
        let [_, b, c, d] = self.square;
        let turns = roots_between::<3>(&[b, 2.0 * c, 3.0 * d], 0.0, self.high - self.low);
        let turns = turns.as_slice().iter().map(|h| self.low + h);
        let squares = turns.chain([self.low, self.high]).map(|y| self.at(y).0);
        let [least, greatest] = squares.fold([f64::INFINITY, 0.0], |[least, greatest], square| {
            [square.min(least), square.max(greatest)]
        });
        let room = ROOM * greatest;
        [least - room, greatest]
    }
}

impl Rings {
    fn new(segments: &[Segment]) -> Self {
        let each = |of: fn(&Segment) -> f64| {
            Lanes([0, 1, 2, 3].map(|lane| of(segments.get(lane).unwrap_or(&segments[0]))))
        };
        Self {
            low: each(|segment| segment.low),
            high: each(|segment| segment.high),
            narrow: each(|segment| segment.bounds[0]),
            wide: each(|segment| segment.bounds[1] * (1.0 + ROOM)),
        }
    }

    /// Between which distances a ray that isn't level may meet each, and which of them it may meet at all, as bits.
    #[inline(always)]
    fn met_by(&self, passing: &Passing) -> ([Lanes; 2], u32) {
        let (o, d) = (passing.ray.origin, passing.ray.direction);
        let (low, high) = ((self.low - o.y) / d.y, (self.high - o.y) / d.y);
        let [from, to] = passing.within;
        let enter = low.lesser(high).greater(Lanes::splat(from));
        let leave = low.greater(high).lesser(Lanes::splat(to));
        let beside = |t: Lanes| {
            let (x, z) = (t * d.x + o.x, t * d.z + o.z);
            x * x + z * z
        };
        let (one, other) = (beside(enter), beside(leave));
        // Where a ray is nearest to the axis tells more than its ends.
        let between = (-(enter - passing.nearest)).lesser(leave - passing.nearest);
        let least = Lanes::splat(passing.least).where_positive(between, one.lesser(other));
        let met = (leave - enter).bits(|length| length > 0.0)
            & leave.bits(|end| end >= passing.wanted[0])
            & enter.bits(|start| start <= passing.wanted[1])
            & (self.wide - least).bits(|room| room >= 0.0)
            & (one.greater(other) - self.narrow).bits(|room| room >= 0.0);
        ([enter, leave], met)
    }
}

impl Sor {
    /// From at least four points (radius, height), the first and last of which only give slopes; the
    /// heights of the others rise. `None` for anything else.
    pub fn new(points: &[DVec2], open: bool) -> Option<Self> {
        let rising = points.get(1..points.len().saturating_sub(1))?;
        if points.len() < 4 || !rising.windows(2).all(|pair| pair[0].y < pair[1].y) {
            return None;
        }
        let segments: Vec<_> = points.windows(4).map(Segment::new).collect();
        if !segments.iter().all(|s| s.square.iter().all(|c| c.is_finite())) {
            return None;
        }
        let radius = segments.iter().map(|s| s.bounds[1]).fold(0.0, f64::max).sqrt();
        let (low, high) = (rising[0].y, rising[rising.len() - 1].y);
        let bounds = Bounds::new(DVec3::new(-radius, low, -radius), DVec3::new(radius, high, radius));
        let rings = segments.chunks(Lanes::COUNT).map(Rings::new).collect();
        Some(Self { segments, rings, bounds, open })
    }

    /// The square of the radius that counts at height `y`, and the segment it is from.
    fn square_at(&self, y: f64) -> Option<(usize, f64)> {
        let segment = self.segments.partition_point(|segment| segment.high < y);
        let found = self.segments.get(segment).filter(|found| found.low <= y)?;
        Some((segment, found.at(y).0))
    }

    /// Crossings of the side of one segment between two distances along a ray, ascending.
    fn side(segment: &Segment, passing: &Passing, ends: [f64; 2], found: impl FnMut(f64)) {
        let (o, d) = (passing.ray.origin, passing.ray.direction);
        // The square of the surface's radius less the ray's, as a polynomial in the distance.
        let ([a, b, c, e], h) = (segment.square, o.y - segment.low);
        let cubic = [
            a + h * (b + h * (c + h * e)) - (o.x * o.x + o.z * o.z),
            d.y * (b + h * (2.0 * c + h * 3.0 * e)) - 2.0 * (o.x * d.x + o.z * d.z),
            d.y * d.y * (c + 3.0 * h * e) - (d.x * d.x + d.z * d.z),
            d.y * d.y * d.y * e,
        ];
        let value = |t: f64| {
            let p = passing.ray.at(t);
            // Neighbours agree on the radius at the height they share.
            let y = if t == ends[0] || t == ends[1] { p.y.clamp(segment.low, segment.high) } else { p.y };
            segment.at(y).0 - (p.x * p.x + p.z * p.z)
        };
        let seeds = roots_between::<4>(&cubic, ends[0], ends[1]);
        sign_changes(seeds.as_slice(), ends, value, |_, _| true, found);
    }

    /// Whether an end that the ray meets is there.
    fn has_end(&self, ray: &Ray, end: End) -> bool {
        !self.open && self.ends_at(ray, end)
    }

    /// Whether the inside ends at an end that the ray meets.
    fn ends_at(&self, ray: &Ray, end: End) -> bool {
        if !end.t.is_finite() {
            return false;
        }
        let p = ray.at(end.t);
        let y = if end.part == 0 { self.bounds.min.y } else { self.bounds.max.y };
        self.square_at(y).is_some_and(|(_, square)| p.x * p.x + p.z * p.z < square)
    }

    /// Calls back with the crossings in `range`, ascending, those of a segment at a time, until that says that
    /// it has enough.
    fn each(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing) -> bool) {
        let (shift, ray) = ray.moved_to(self.bounds.center());
        let (low, high) = (self.bounds.min, self.bounds.max);
        let (o, d) = (ray.origin, ray.direction);
        let Some(slab) = Stretch::slab((low.y, 0), (high.y, 1), o.y, d.y) else {
            return;
        };
        // Within the cylinder around, with room for its rounding.
        let away = d.x * d.x + d.z * d.z;
        let nearest = -(o.x * d.x + o.z * d.z) / away;
        let foot = ray.at(if nearest.is_finite() { nearest } else { 0.0 });
        let least = foot.x * foot.x + foot.z * foot.z;
        let chord = high.x * high.x * (1.0 + ROOM) - least;
        if chord < 0.0 {
            return;
        }
        let half = (chord / away).sqrt();
        let around =
            if half.is_finite() { [nearest - half, nearest + half] } else { [-f64::INFINITY, f64::INFINITY] };
        let wanted = [range.min - shift, range.max - shift];
        let passing = Passing { ray, nearest, least, within: around, wanted };
        let mut enough = false;
        let mut push = |t: f64, part: u32| {
            if !enough && range.contains(t + shift) {
                enough = found(Crossing::new(t + shift, part));
            }
            enough
        };
        if self.has_end(&ray, slab.enter) && push(slab.enter.t, slab.enter.part) {
            return;
        }
        let mut side = |index: usize, ends: [f64; 2]| {
            let mut done = false;
            if let Some(segment) = self.segments.get(index) {
                Self::side(segment, &passing, ends, |t| done |= push(t, ENDS + index as u32));
            }
            done
        };
        if d.y == 0.0 {
            // At the height of a joint the segment below counts.
            if let Some((index, _)) = self.square_at(o.y) {
                side(index, around);
            }
            return;
        }
        let done = widest(
            #[inline(always)]
            || {
                for step in 0..self.rings.len() {
                    let four = if d.y < 0.0 { self.rings.len() - 1 - step } else { step };
                    let ([enter, leave], mut met) = self.rings[four].met_by(&passing);
                    while met != 0 {
                        let lane = if d.y < 0.0 { met.ilog2() } else { met.trailing_zeros() } as usize;
                        met &= !(1 << lane);
                        if side(Lanes::COUNT * four + lane, [enter.0[lane], leave.0[lane]]) {
                            return true;
                        }
                    }
                }
                false
            },
        );
        if !done && self.has_end(&ray, slab.leave) {
            push(slab.leave.t, slab.leave.part);
        }
    }
}

impl Shape for Sor {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.each(ray, range, |crossing| {
            out.push(crossing);
            false
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest = None;
        self.each(ray, range, |crossing| {
            nearest = Some(crossing);
            true
        });
        nearest
    }

    fn is_closed(&self) -> bool {
        !self.open
    }

    fn inside(&self, point: DVec3) -> bool {
        let square = point.x * point.x + point.z * point.z;
        self.square_at(point.y).is_some_and(|(_, limit)| square <= limit)
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        let leaves_unseen = |ray: &Ray, range: Range| {
            let (low, high) = (self.bounds.min.y, self.bounds.max.y);
            let slab = Stretch::slab((low, 0), (high, 1), ray.origin.y, ray.direction.y);
            let leaves = |end: End| range.contains(end.t) && self.ends_at(ray, end);
            self.open && slab.is_some_and(|slab| leaves(slab.enter) || leaves(slab.leave))
        };
        let passes = |ray: &Ray, range| self.occludes(ray, range) || leaves_unseen(ray, range);
        uncrossed::inside_unless(self, passes, point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part.checked_sub(ENDS) {
            None if crossing.part == 0 => DVec3::NEG_Y,
            None => DVec3::Y,
            Some(index) => point.with_y(-0.5 * self.segments[index as usize].at(point.y).1),
        }
    }

    fn uv(&self, point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        let radius = point.x.hypot(point.z);
        let v = match crossing.part.checked_sub(ENDS) {
            None => {
                let limit = self.square_at(point.y).map_or(0.0, |(_, square)| square.sqrt());
                if crossing.part == 0 { radius / limit - 1.0 } else { 2.0 - radius / limit }
            }
            Some(index) => {
                let segment = &self.segments[index as usize];
                let along = (point.y - segment.low) / (segment.high - segment.low);
                (f64::from(index) + along) / self.segments.len() as f64
            }
        };
        Some(DVec2::new(turn(point), v))
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let Some(index) = crossing.part.checked_sub(ENDS) else {
            return point.with_y(if crossing.part == 0 { self.bounds.min.y } else { self.bounds.max.y });
        };
        // One Newton step along the gradient of the squared radius.
        let (square, slope) = self.segments[index as usize].at(point.y);
        let gradient = DVec3::new(2.0 * point.x, -slope, 2.0 * point.z);
        let step = gradient * ((point.x * point.x + point.z * point.z - square) / gradient.length_squared());
        if step.length_squared() <= 1e-12 * self.bounds.size().length_squared() {
            point - step
        } else {
            point
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{self, battery, table};
    use super::*;

    fn make(points: &[[f64; 2]], size: f64, open: bool) -> Sor {
        let points: Vec<_> = points.iter().map(|p| DVec2::from(*p) * size).collect();
        Sor::new(&points, open).unwrap()
    }

    const VASE: [[f64; 2]; 6] = [[0.2, -0.5], [0.5, 0.], [1., 0.5], [0.4, 1.], [0.6, 1.5], [0.3, 2.]];
    const SMALL: [[f64; 2]; 6] = [[0.2, -1.5], [0.5, -0.8], [0.9, -0.4], [0.4, 0.2], [0.6, 0.9], [0.3, 2.]];

    battery! {
        closed: |size| make(&SMALL, size, false);
        open: |size| make(&SMALL, size, true), surface;
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &make(&VASE, 1.0, false),
            "from <0.1,0.6,-5> dir <0,0,1> | P <0.1, 0.6, -0.946023255528108> N <0.080719716566638, 0.640591670672838, -0.76362729051677>
            from <0.1,0.4,-5> dir <0.01,0.05,1> | P <0.140617925977218, 0.603089629886091, -0.938207402278175> N <0.112748541119946, 0.649145374969103, -0.752261954794702>
            from <0.1,5,0.1> dir <0,-1,0> | P <0.1, 1.5, 0.1> N <0, 1, 0>
            from <0.1,-5,0.1> dir <0,1,0> | P <0.1, 0, 0.1> N <0, -1, 0>
            from <0.7,5,0.1> dir <0,-1,0> | P <0.7, 0.786779440039648, 0.1> N <0.510008224504363, 0.857078337415695, 0.072858317786338>
            from <0,0.5,0> dir <1,0.2,0.3> | P <0.843227805747222, 0.668645561149444, 0.252968341724166> N <0.607726246650427, 0.772935315504526, 0.182317873995128>
            inside <0.9,0.5,0> | 1
            inside <0.5,1,0> | 0
            inside <0.3,0.01,0> | 1
            inside <0.3,1.6,0> | 0
            extent | <-1.000618577003479, 0, -1.000618577003479> .. <1.000618577003479, 1.5, 1.000618577003479>",
        );
        table(
            &make(&VASE, 1.0, true),
            "from <0.1,5,0.1> dir <0,-1,0> | miss
            from <0.45,5,0.1> dir <0,-1,0> | P <0.45, 1.199048930535885, 0.1> N <0.797432132799566, -0.576801198760254, 0.177207140622126>",
        );
    }

    #[test]
    fn uv_agrees_with_povray() {
        let vase = make(&VASE, 1.0, false);
        battery::uv(&vase, [0.1, 0.6, -5.0], [0.0, 0.0, 1.0], [0.76677, 0.4]);
        battery::uv(&vase, [0.2, 1.2, -5.0], [0.0, 0.0, 1.0], [0.82132, 0.8]);
        battery::uv(&vase, [0.1, 5.0, 0.1], [0.0, -1.0, 0.0], [0.125, 1.76429]);
    }

    #[test]
    fn heights_that_fall_make_no_surface() {
        assert_eq!(Sor::new(&[DVec2::ZERO; 3], false), None);
        let falling = [[0.2, 0.], [0.5, 1.], [1., 0.5], [0.4, 2.]].map(DVec2::from);
        assert_eq!(Sor::new(&falling, false), None);
    }
}
