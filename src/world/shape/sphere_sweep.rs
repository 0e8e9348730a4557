//! `sphere_sweep` (docs/spec/primitives.md 6.4).

use super::stretch::Stretch;
use super::{Crossing, Shape, uncrossed};
use crate::math::roots::roots_between;
use crate::math::{Band, Bounds, DVec3, DVec4};
use crate::world::{Range, Ray};

/// All points of a ball that moves and grows along segments of a spline.
///
/// Parts are the segments; [`Crossing::at`] holds the place on the segment.
#[derive(Clone, Debug)]
pub struct SphereSweep {
    segments: Vec<Segment>,
    bounds: Bounds,
    extent: Bounds,
}

/// A piece of the way: centre and radius as cubics of u from 0 to 1, the constant first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment([DVec4; 4]);

impl Segment {
    /// From `a` to `b`; a ball is its centre and, as w, its radius.
    pub fn linear(a: DVec4, b: DVec4) -> Self {
        Self([a, b - a, DVec4::ZERO, DVec4::ZERO])
    }

    /// From `b` to `c` (Catmull and Rom).
    pub fn cubic(a: DVec4, b: DVec4, c: DVec4, d: DVec4) -> Self {
        Self([b, 0.5 * (c - a), a - 2.5 * b + 2.0 * c - 0.5 * d, 0.5 * (d - a) + 1.5 * (b - c)])
    }

    /// A piece of a uniform B-spline.
    pub fn b_spline(a: DVec4, b: DVec4, c: DVec4, d: DVec4) -> Self {
        let sixth = 1.0 / 6.0;
        Self([
            sixth * (a + 4.0 * b + c),
            0.5 * (c - a),
            0.5 * (a - 2.0 * b + c),
            sixth * (d - a + 3.0 * (b - c)),
        ])
    }

    fn ball(&self, u: f64) -> DVec4 {
        let [a, b, c, d] = self.0;
        a + u * (b + u * (c + u * d))
    }

    /// The box around its Bézier points.
    fn bounds(&self) -> Bounds {
        let [a, b, c, d] = self.0;
        let points = [a, a + b / 3.0, a + (2.0 * b + c) / 3.0, a + b + c + d];
        points.iter().fold(Bounds::EMPTY, |all, ball| all.union(around(*ball, 1.0)))
    }

    /// The square of the radius less that of the distance from a point, as a polynomial.
    fn depth(&self, point: DVec3) -> [f64; 7] {
        let mut from = self.0;
        from[0] -= point.extend(0.0);
        square(from, |a, b| a.w * b.w - a.truncate().dot(b.truncate()))
    }

    /// The stretches of a line within: each run of balls that the line goes through is in one piece.
    /// The direction is a unit vector.
    fn meet(&self, ray: &Ray, part: u32, found: &mut Vec<Stretch<Crossing>>) {
        let d = ray.direction;
        let mut from = self.0;
        from[0] -= ray.origin.extend(0.0);
        let along = from.map(|c| c.truncate().dot(d));
        let chord = square(from, |a, b| {
            let (a3, b3) = (a.truncate(), b.truncate());
            a.w * b.w - (a3 - a3.dot(d) * d).dot(b3 - b3.dot(d) * d)
        });
        let value = |p: &[f64], u: f64| p.iter().rev().fold(0.0, |sum, c| sum * u + c);
        // A ball's chord begins at along - √chord: least where 4 along'² chord = chord'².
        let slope = [along[1], 2.0 * along[2], 3.0 * along[3]];
        let chord_slope: [f64; 6] = std::array::from_fn(|i| (i + 1) as f64 * chord[i + 1]);
        let mut turning = [0.0; 11];
        for (i, a) in slope.iter().enumerate() {
            for (j, b) in slope.iter().enumerate() {
                for (k, c) in chord.iter().enumerate() {
                    turning[i + j + k] += 4.0 * a * b * c;
                }
            }
        }
        for (i, a) in chord_slope.iter().enumerate() {
            for (j, b) in chord_slope.iter().enumerate() {
                turning[i + j] -= a * b;
            }
        }
        let ends = roots_between::<7>(&chord, 0.0, 1.0);
        let mut low = 0.0;
        for high in ends.as_slice().iter().copied().chain([1.0]) {
            if value(&chord, 0.5 * (low + high)) > 0.0 {
                let turns = roots_between::<11>(&turning, low, high);
                let places = turns.as_slice().iter().copied().chain([low, high]);
                let mut all: Option<Stretch<Crossing>> = None;
                for u in places {
                    let half = value(&chord, u).max(0.0).sqrt();
                    let at = |t: f64| Crossing { t, part, at: [u, 0.0] };
                    let (enter, leave) = (at(value(&along, u) - half), at(value(&along, u) + half));
                    all = Some(all.map_or(Stretch { enter, leave }, |all| Stretch {
                        enter: if enter.t < all.enter.t { enter } else { all.enter },
                        leave: if leave.t > all.leave.t { leave } else { all.leave },
                    }));
                }
                found.extend(all);
            }
            low = high;
        }
    }
}

/// The square of a polynomial under some product.
fn square(p: [DVec4; 4], product: impl Fn(DVec4, DVec4) -> f64) -> [f64; 7] {
    let mut out = [0.0; 7];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in p.iter().enumerate() {
            out[i + j] += product(*a, *b);
        }
    }
    out
}

/// The box around a ball so many times as wide.
fn around(ball: DVec4, times: f64) -> Bounds {
    let (center, half) = (ball.truncate(), DVec3::splat(times * ball.w.abs()));
    Bounds { min: center - half, max: center + half }
}

impl SphereSweep {
    /// From the segments; `controls` and the `room` around each, in radii, give POV-Ray's box.
    pub fn new(segments: Vec<Segment>, controls: &[DVec4], room: f64) -> Option<Self> {
        let bounds = segments.iter().fold(Bounds::EMPTY, |all, segment| all.union(segment.bounds()));
        let extent = controls.iter().fold(Bounds::EMPTY, |all, ball| all.union(around(*ball, room)));
        bounds.is_finite().then_some(Self { segments, bounds, extent })
    }

    /// The stretches inside, in order and apart from each other.
    fn stretches(&self, ray: &Ray) -> Vec<Stretch<Crossing>> {
        let speed = ray.direction.length();
        let (shift, near) = ray.moved_to(self.bounds.center());
        let near = Ray::new(near.origin, near.direction / speed);
        let mut all = Vec::new();
        for (part, segment) in (0..).zip(&self.segments) {
            segment.meet(&near, part, &mut all);
        }
        all.sort_by(|a, b| a.enter.t.total_cmp(&b.enter.t));
        let mut merged: Vec<Stretch<Crossing>> = Vec::new();
        for next in all {
            match merged.last_mut().filter(|last| next.enter.t <= last.leave.t) {
                Some(last) if next.leave.t > last.leave.t => last.leave = next.leave,
                Some(_) => {}
                None => merged.push(next),
            }
        }
        for stretch in &mut merged {
            stretch.enter.t = stretch.enter.t / speed + shift;
            stretch.leave.t = stretch.leave.t / speed + shift;
        }
        merged
    }
}

impl Shape for SphereSweep {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn extent(&self) -> Bounds {
        self.extent
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.stretches(ray).into_iter().for_each(|stretch| stretch.push(range, out));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.stretches(ray).into_iter().find_map(|stretch| stretch.nearest(range))
    }

    fn inside(&self, point: DVec3) -> bool {
        self.segments.iter().any(|segment| {
            let depth = segment.depth(point);
            depth[0] >= 0.0 || !roots_between::<7>(&depth, 0.0, 1.0).as_slice().is_empty()
        })
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        uncrossed::inside_along(self, point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        point - self.segments[crossing.part as usize].ball(crossing.at[0]).truncate()
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        let ball = self.segments[crossing.part as usize].ball(crossing.at[0]);
        let from = point - ball.truncate();
        ball.truncate() + from * (ball.w.abs() / from.length())
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    fn balls(all: &[[f64; 4]], size: f64) -> Vec<DVec4> {
        all.iter().map(|ball| DVec4::from(*ball) * size).collect()
    }

    fn linear(all: &[[f64; 4]], size: f64) -> SphereSweep {
        let balls = balls(all, size);
        let segments = balls.windows(2).map(|b| Segment::linear(b[0], b[1])).collect();
        SphereSweep::new(segments, &balls, 1.0).unwrap()
    }

    fn smooth(
        make: fn(DVec4, DVec4, DVec4, DVec4) -> Segment,
        room: f64,
        all: &[[f64; 4]],
        size: f64,
    ) -> SphereSweep {
        let balls = balls(all, size);
        let segments = balls.windows(4).map(|b| make(b[0], b[1], b[2], b[3])).collect();
        SphereSweep::new(segments, &balls, room).unwrap()
    }

    const ELBOW: [[f64; 4]; 3] = [[0., 0., 0., 0.5], [2., 0., 0., 0.8], [2., 2., 0., 0.2]];
    const WAVE: [[f64; 4]; 5] =
        [[-1., 0., 0., 0.3], [0., 0., 0., 0.5], [1., 1., 0., 0.4], [2., 0., 0.5, 0.6], [3., 0., 0., 0.3]];
    const SMALL: [[f64; 4]; 5] = [
        [-1.5, -1., 0., 0.3],
        [-0.7, 0., 0., 0.4],
        [0., 0.8, 0., 0.3],
        [0.8, 0., 0.2, 0.5],
        [1.5, -1., 0., 0.3],
    ];

    battery! {
        straight: |size| linear(&[[-0.6, -0.5, 0., 0.25], [0.4, 0., 0., 0.4], [0.2, 0.7, 0.3, 0.1]], size);
        b_spline: |size| smooth(Segment::b_spline, 1.0, &SMALL, size);
    }

    #[test]
    fn straight_sweeps_agree_with_povray() {
        table(
            &linear(&ELBOW, 1.0),
            "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.480967694625802> N <-0.15, 0.379611650485437, -0.912904701935381>
            from <1,0.2,-5> dir <0,0,1> | P <1, 0.2, -0.626278743003958> N <-0.15, 0.300769230769231, -0.941826878902106>
            from <1,0.2,-5> dir <0.05,0.02,1> | P <1.218602891531372, 0.287441156612549, -0.62794216937256> N <-0.150000000000003, 0.411508007008782, -0.898977841866895>
            from <2.1,1,-5> dir <0,0,1> | P <2.1, 1, -0.514514601080739> N <0.182, 0.3, -0.936416573966945>
            from <-5,0.1,0.1> dir <1,0,0> | P <-0.479583152331268, 0.1, 0.1> N <-0.959166304662537, 0.2, 0.2>
            from <1,0,0> dir <0,0,1> | P <1, 0, 0.657438258651426> N <-0.15, 0, 0.98868599666426>
            from <0.5,5,0.1> dir <0,-1,0> | P <0.5, 0.572918226379339, 0.1> N <-0.15, 0.973960984844876, 0.17>
            inside <1,0.5,0> | 1
            inside <1,0.7,0> | 0
            inside <2,2.19,0> | 1
            extent | <-0.5, -0.800000011920929, -0.800000011920929> .. <2.799999952316284, 2.200000047683716, 0.800000011920929>",
        );
        table(
            &linear(&[[0., 0., 0., 1.], [0.3, 0., 0., 0.2]], 1.0),
            "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.974679434480896> N <0.1, 0.2, -0.974679434480896>
            from <5,0.1,0> dir <-1,0,0> | P <0.994987437106619, 0.1, 0> N <0.994987437106619, 0.1, 0>",
        );
    }

    #[test]
    fn splines_agree_with_povray() {
        table(
            &smooth(Segment::cubic, 2.0, &WAVE, 1.0),
            "from <0.5,0.5,-5> dir <0,0,1> | P <0.5, 0.5, -0.483839036044564> N <0.099516182546501, 0.001179832987363, -0.995035244303178>
            from <0.1,0.2,-5> dir <0.05,0.02,1> | P <0.325115171916797, 0.290046068766719, -0.497696561664068> N <0.053137369102407, 0.002560593077623, -0.998583929055512>
            from <1.5,0.6,-5> dir <0,0,1> | P <1.5, 0.6, -0.250873506799613> N <0.17248547447254, -0.154742715864393, -0.972781297611594>
            inside <0.5,0.6,0> | 1
            inside <0.5,1.2,0> | 0
            extent | <-1.600000023841858, -1.200000047683716, -1> .. <3.599999904632568, 1.799999952316284, 1.700000047683716>",
        );
        table(
            &smooth(Segment::b_spline, 1.0, &WAVE, 1.0),
            "from <0.5,0.5,-5> dir <0,0,1> | P <0.5, 0.5, -0.439608276767051> N <0.038392344595075, 0.07040736955924, -0.996779228409297>
            from <1.0,0.3,-5> dir <0.05,0.02,1> | P <1.237045561517037, 0.394818224606815, -0.25908876965926> N <0.003807886854425, -0.476183902738973, -0.879337472629248>
            inside <0.5,0.4,0> | 1
            extent | <-1.299999952316284, -0.600000023841858, -0.5> .. <3.299999952316284, 1.399999976158142, 1.100000023841858>",
        );
    }

    #[test]
    fn a_point_deep_in_a_fat_segment_is_inside() {
        // POV-Ray says it isn't.
        table(&linear(&[[0., 0., 0., 1.], [0.1, 0., 0., 1.]], 1.0), "inside <0.05,0,0> | 1");
    }
}
