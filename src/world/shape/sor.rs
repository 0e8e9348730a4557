//! `sor`, a surface of revolution (docs/spec/primitives.md 6.2).

use super::lathe::turn;
use super::stretch::Stretch;
use super::{Crossing, Shape};
use crate::math::roots::{between, roots_between};
use crate::math::{Bounds, DVec2, DVec3};
use crate::world::{Range, Ray};

/// About the y axis; the square of the radius is a cubic of the height, segment by segment.
///
/// Parts: 0 the lower end, 1 the upper, then the segments upward.
#[derive(Clone, Debug, PartialEq)]
pub struct Sor {
    segments: Vec<Segment>,
    bounds: Bounds,
    open: bool,
}

/// Between two heights.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Segment {
    low: f64,
    high: f64,
    /// The square of the radius over the height above `low`, the constant first.
    square: [f64; 4],
}

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
        Self { low: from.y, high: to.y, square: [from.x * from.x, start, square, cube] }
    }

    /// The greatest square of the radius.
    fn greatest(&self) -> f64 {
        let [_, b, c, d] = self.square;
        let turns = roots_between::<3>(&[b, 2.0 * c, 3.0 * d], 0.0, self.high - self.low);
        let turns = turns.as_slice().iter().map(|h| self.low + h);
        turns.chain([self.low, self.high]).map(|y| self.at(y).0).fold(0.0, f64::max)
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
        let radius = segments.iter().map(Segment::greatest).fold(0.0, f64::max).sqrt();
        let (low, high) = (rising[0].y, rising[rising.len() - 1].y);
        let bounds = Bounds::new(DVec3::new(-radius, low, -radius), DVec3::new(radius, high, radius));
        Some(Self { segments, bounds, open })
    }

    /// The square of the radius that counts at height `y`, and the segment it is from.
    fn square_at(&self, y: f64) -> Option<(usize, f64)> {
        let segment = self.segments.partition_point(|segment| segment.high < y);
        let found = self.segments.get(segment).filter(|found| found.low <= y)?;
        Some((segment, found.at(y).0))
    }

    /// Crossings of the side of one segment between two distances along a ray.
    fn side(&self, index: usize, ray: &Ray, ends: [f64; 2], found: &mut impl FnMut(f64, u32)) {
        let segment = &self.segments[index];
        let (o, d) = (ray.origin, ray.direction);
        // The square of the surface's radius less the ray's, as a polynomial in the distance.
        let ([a, b, c, e], h) = (segment.square, o.y - segment.low);
        let cubic = [
            a + h * (b + h * (c + h * e)) - (o.x * o.x + o.z * o.z),
            d.y * (b + h * (2.0 * c + h * 3.0 * e)) - 2.0 * (o.x * d.x + o.z * d.z),
            d.y * d.y * (c + 3.0 * h * e) - (d.x * d.x + d.z * d.z),
            d.y * d.y * d.y * e,
        ];
        let value = |t: f64| {
            let p = ray.at(t);
            // Neighbours agree on the radius at the height they share.
            let y = if t == ends[0] || t == ends[1] { p.y.clamp(segment.low, segment.high) } else { p.y };
            segment.at(y).0 - (p.x * p.x + p.z * p.z)
        };
        let seeds = roots_between::<4>(&cubic, ends[0], ends[1]);
        let middles = seeds.as_slice().windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let mut from = (ends[0], value(ends[0]));
        for t in middles.chain([ends[1]]) {
            let to = (t, value(t));
            if (from.1 > 0.0) != (to.1 > 0.0) {
                found(between(from, to, value), ENDS + index as u32);
            }
            from = to;
        }
    }
}

impl Shape for Sor {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
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
        let chord = high.x * high.x * (1.0 + 1e-9) - (foot.x * foot.x + foot.z * foot.z);
        if chord < 0.0 {
            return;
        }
        let half = (chord / away).sqrt();
        let around =
            if half.is_finite() { [nearest - half, nearest + half] } else { [-f64::INFINITY, f64::INFINITY] };
        let from = out.len();
        let mut push = |t: f64, part: u32| {
            if range.contains(t + shift) {
                out.push(Crossing::new(t + shift, part));
            }
        };
        for (index, segment) in self.segments.iter().enumerate() {
            let Some(part) = Stretch::slab((segment.low, 0), (segment.high, 0), o.y, d.y) else {
                continue;
            };
            // A level ray at the height of a joint belongs to the segment below.
            if d.y == 0.0 && o.y == segment.low && index > 0 {
                continue;
            }
            let ends = [part.enter.t.max(around[0]), part.leave.t.min(around[1])];
            if ends[0] < ends[1] {
                self.side(index, &ray, ends, &mut push);
            }
        }
        for end in [slab.enter, slab.leave].into_iter().filter(|end| end.t.is_finite() && !self.open) {
            let p = ray.at(end.t);
            let y = if end.part == 0 { low.y } else { high.y };
            if self.square_at(y).is_some_and(|(_, square)| p.x * p.x + p.z * p.z < square) {
                push(end.t, end.part);
            }
        }
        out[from..].sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    fn inside(&self, point: DVec3) -> bool {
        let square = point.x * point.x + point.z * point.z;
        self.square_at(point.y).is_some_and(|(_, limit)| square <= limit)
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
