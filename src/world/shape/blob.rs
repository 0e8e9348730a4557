//! `blob` (docs/spec/primitives.md 5.1).

use smallvec::SmallVec;

use super::stretch::Stretch;
use super::{Crossing, OWN_TEXTURE, Shape, uncrossed};
use crate::math::roots::{between, roots_between, with_discriminant};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DAffine3, DMat3, DVec3, Transform};
use crate::world::accel::Bvh;
use crate::world::{Range, Ray};

/// The surface on which the fields of all parts add up to a threshold; inside they are stronger.
#[derive(Clone, Debug)]
pub struct Blob {
    parts: Vec<Part>,
    threshold: f64,
    bounds: Bounds,
    bvh: Bvh,
    /// Whether any part has a texture of its own.
    textured: bool,
    /// Whether any part weakens the field.
    carves: bool,
}

/// One ball, half-ball or tube around which a field is.
#[derive(Clone, Debug)]
pub struct Part {
    /// To the space in which the field ends at distance 1 from the middle.
    inverse: DAffine3,
    /// The distance is that from the z axis instead of the origin.
    tube: bool,
    /// Where it is cut off along z; the ends belong to the tube.
    ends: [f64; 2],
    /// That space is reached without turning, by the same scale along all axes.
    is_even: bool,
    strength: f64,
    texture: u32,
    /// The box around the ball, or both balls of a tube.
    bounds: Bounds,
}

impl Part {
    /// A ball of radius 1 about the origin, put in place by `transform`.
    pub fn ball(transform: &Transform, strength: f64, texture: u32) -> Self {
        let (inverse, bounds) = (transform.inverse, around_ball(transform));
        let is_even = inverse.matrix3 == DMat3::from_diagonal(DVec3::splat(inverse.matrix3.x_axis.x));
        Self {
            inverse,
            tube: false,
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            is_even,
            strength,
            texture,
            bounds,
        }
    }

    /// A tube of radius 1 about the z axis from 0 to `length` with a half-ball at each end.
    pub fn capsule(transform: &Transform, length: f64, strength: f64, texture: u32) -> [Self; 3] {
        let low = Self::ball(transform, strength, texture);
        let high = Self::ball(&Transform::translate(DVec3::Z * length).then(transform), strength, texture);
        let bounds = low.bounds.union(high.bounds);
        let tube = Self { tube: true, ends: [0.0, length], bounds, ..low.clone() };
        let half = |ball: Self, low: f64, high: f64| Self { ends: [low, high], ..ball };
        [tube, half(low, f64::NEG_INFINITY, 0.0), half(high, 0.0, f64::INFINITY)]
    }

    /// Strength at a point, and the gradient.
    fn field(&self, point: DVec3) -> (f64, DVec3) {
        let p = self.inverse.transform_point3(point);
        let from = if self.tube { p.with_z(0.0) } else { p };
        let rest = 1.0 - from.length_squared();
        let [low, high] = self.ends;
        let within = if self.tube { low <= p.z && p.z <= high } else { low < p.z && p.z < high };
        if rest <= 0.0 || !within {
            return (0.0, DVec3::ZERO);
        }
        let slope = self.inverse.matrix3.transpose() * (-4.0 * self.strength * rest * from);
        (self.strength * rest * rest, slope)
    }

    /// Where a ray is in the field, and how its distance from the middle, squared, starts and grows.
    #[inline(always)]
    fn meet(&self, ray: &Ray) -> Option<Span> {
        let (o, d) = if self.is_even {
            let scale = self.inverse.matrix3.x_axis.x;
            (ray.origin * scale + self.inverse.translation, ray.direction * scale)
        } else {
            (self.inverse.transform_point3(ray.origin), self.inverse.transform_vector3(ray.direction))
        };
        let (f, e) = if self.tube { (o.with_z(0.0), d.with_z(0.0)) } else { (o, d) };
        let (a, b, c) = (e.length_squared(), f.dot(e), f.length_squared());
        if a * (c - 1.0) - b * b > CLEAR * a * c {
            return None;
        }
        let (mut enter, mut leave, mut rest) = (f64::NEG_INFINITY, f64::INFINITY, 1.0 - c);
        if a != 0.0 {
            rest = 1.0 - (f - (b / a) * e).length_squared();
            [enter, leave] = with_discriminant(a, b, c - 1.0, a * rest)?;
        } else if c >= 1.0 {
            return None;
        }
        let [low, high] = self.ends;
        if low > f64::NEG_INFINITY || high < f64::INFINITY {
            let cut = Stretch::slab((low, 0), (high, 0), o.z, d.z)?;
            (enter, leave) = (enter.max(cut.enter.t), leave.min(cut.leave.t));
        }
        (enter < leave && leave.is_finite() && enter.is_finite()).then_some(Span {
            enter,
            leave,
            square: [c, b, a],
            strength: self.strength,
            peak: (self.strength * rest * rest).max(0.0),
        })
    }
}

/// The share of the squared distance by which a ray must pass a field, far more than it is rounded by.
const CLEAR: f64 = 1e-12;

fn around_ball(transform: &Transform) -> Bounds {
    let m = transform.forward.matrix3.transpose();
    let half = DVec3::new(m.x_axis.length(), m.y_axis.length(), m.z_axis.length()) * (1.0 + 1e-12);
    let center = transform.forward.translation;
    Bounds { min: center - half, max: center + half }
}

/// The stretch of a ray in a part's field.
struct Span {
    enter: f64,
    leave: f64,
    /// c, b, a of the squared distance a t² + 2 b t + c.
    square: [f64; 3],
    strength: f64,
    /// The field is nowhere more.
    peak: f64,
}

impl Span {
    /// The least and the greatest that the field is between two distances within the span.
    #[inline(always)]
    fn between(&self, from: f64, to: f64) -> [f64; 2] {
        let [c, b, a] = self.square;
        let rest = |t: f64| (1.0 - (c + t * (2.0 * b + t * a))).max(0.0);
        let (one, other) = (rest(from), rest(to));
        // The distance is least where a t is -b.
        let most =
            if a * from < -b && -b < a * to { (1.0 - (c - b * b / a)).max(0.0) } else { one.max(other) };
        let least = one.min(other);
        let fields = [self.strength * least * least, self.strength * most * most];
        if self.strength < 0.0 { [fields[1], fields[0]] } else { fields }
    }

    /// Where the field is strongest, if that is within the span.
    #[inline(always)]
    fn middle(&self) -> f64 {
        let [_, b, a] = self.square;
        let middle = -b / a;
        if self.enter <= middle && middle <= self.leave { middle } else { f64::INFINITY }
    }

    /// Adds the field as a polynomial in the distance from `start`.
    fn add(&self, start: f64, quartic: &mut [f64; 5]) {
        let [c, b, a] = self.square;
        let (e, f, g) = (1.0 - (c + start * (2.0 * b + start * a)), -2.0 * (b + a * start), -a);
        let terms = [e * e, 2.0 * e * f, f * f + 2.0 * e * g, 2.0 * f * g, g * g];
        for (sum, term) in quartic.iter_mut().zip(terms) {
            *sum += self.strength * term;
        }
    }
}

/// Parts that are asked one after the other.
const RUN: usize = 4;

/// How far beyond its ends a range is searched, as a share of the way to the blob's middle.
const BESIDE: f64 = 1e-6;

/// By how much of the threshold bounds of a sum must keep off it, far more than sums are rounded by.
const SURE: f64 = 1e-9;

/// How near two events may be to count as one, in units of the stretch of the ray that is in any field.
const ONE_EVENT: f64 = 1e-13;

impl Blob {
    /// From parts of any size. Parts without strength are left out.
    pub fn new(mut parts: Vec<Part>, threshold: f64) -> Self {
        parts.retain(|part| part.strength != 0.0 && part.bounds.is_finite());
        let boxes = (0..).zip(&parts).map(|(number, part)| (part.bounds, number));
        let (bvh, order) = Bvh::with_runs(boxes, RUN);
        let parts: Vec<Part> = order.into_iter().map(|number| parts[number as usize].clone()).collect();
        let strong = parts.iter().filter(|part| part.strength > 0.0);
        let bounds = if threshold > 0.0 {
            strong.fold(Bounds::EMPTY, |all, part| all.union(part.bounds))
        } else {
            Bounds::ALL
        };
        let textured = parts.iter().any(|part| part.texture != OWN_TEXTURE);
        let carves = parts.iter().any(|part| part.strength < 0.0);
        Self { bvh, parts, threshold, bounds, textured, carves }
    }

    /// Strength at a point above the threshold, and the gradient.
    fn value(&self, point: DVec3) -> (f64, DVec3) {
        let (mut value, mut slope) = (-self.threshold, DVec3::ZERO);
        self.around(point, |_, field, gradient| {
            value += field;
            slope += gradient;
        });
        (value, slope)
    }

    /// Calls back with every part whose field reaches a point.
    fn around(&self, point: DVec3, mut found: impl FnMut(&Part, f64, DVec3)) {
        self.bvh.any_run_around(point, |run| {
            for part in &self.parts[run] {
                let (field, gradient) = part.field(point);
                if field != 0.0 {
                    found(part, field, gradient);
                }
            }
            false
        });
    }

    /// Calls back with the distance of every crossing within the range or close to it, ascending, until it
    /// returns `false`. Of a blob that is sought `briefly` those behind the middle of a part that is inside alone
    /// are left out; whether any may have been.
    fn walk(&self, ray: &Ray, range: Range, briefly: bool, mut found: impl FnMut(f64) -> bool) -> bool {
        let center = if self.bounds.is_finite() { self.bounds.center() } else { DVec3::ZERO };
        let (shift, ray) = ray.moved_to(center);
        let room = BESIDE * shift.abs();
        let mut range = Range { min: range.min - shift - room, max: range.max - shift + room };
        let mut spans = SmallVec::<[Span; 16]>::new();
        let (mut peak, mut last) = (0.0, f64::NEG_INFINITY);
        // What is wholly before or behind the range has no part in any sum within it.
        let reach = self.bounds.size().length() / ray.direction.length();
        let reach = if reach.is_finite() { reach } else { f64::INFINITY };
        let mut line = Range { min: range.min.max(-reach), max: range.max.min(reach) };
        let sure = SURE * self.threshold.abs();
        let briefly = briefly && !self.carves;
        let mut brief = f64::INFINITY;
        widest(
            #[inline(always)]
            || {
                self.bvh.runs_along(
                    &ray,
                    line,
                    #[inline(always)]
                    |run| {
                        for part in &self.parts[run] {
                            if let Some(span) = part.meet(&ray) {
                                if briefly && span.peak > self.threshold + sure {
                                    let middle = span.middle();
                                    if middle > line.min && middle < brief {
                                        brief = middle;
                                        line.max = line.max.min(brief);
                                    }
                                }
                                peak += span.peak;
                                last = span.leave.max(last);
                                spans.push(span);
                            }
                        }
                        line.max
                    },
                );
            },
        );
        range.max = range.max.min(brief);
        let is_brief = brief < f64::INFINITY;
        if peak < self.threshold - sure {
            return is_brief;
        }
        spans.sort_unstable_by(|a, b| a.enter.total_cmp(&b.enter));
        let spans = spans.as_slice();
        let Some(mut end) = spans.first().map(|span| span.enter) else {
            return is_brief;
        };
        let least_gap = ONE_EVENT * (last - end);
        let mut entered = 0;
        // The sum at the end of one gap is that at the start of the next.
        let mut value = None;
        let mut active = SmallVec::<[&Span; 16]>::new();
        while end < last && end < range.max {
            // From one event to the next: the sum is one polynomial there.
            let start = end;
            for place in (0..active.len()).rev() {
                if active[place].leave <= start {
                    active.swap_remove(place);
                }
            }
            while entered < spans.len() && spans[entered].enter <= start {
                active.push(&spans[entered]);
                entered += 1;
            }
            let active = active.as_slice();
            end = spans.get(entered).map_or(last, |span| span.enter);
            let mut peak = 0.0;
            for span in active {
                end = end.min(span.leave);
                peak += span.peak;
            }
            let length = end - start;
            // Where a tube ends and its half-ball begins: the two planes are one but for rounding.
            if length <= least_gap || end <= range.min {
                continue;
            }
            if peak < self.threshold - sure {
                value = None;
                continue;
            }
            let (mut least, mut most) = (0.0, 0.0);
            for span in active {
                let [low, high] = span.between(start, end);
                (least, most) = (least + low, most + high);
            }
            if most < self.threshold - sure || least > self.threshold + sure {
                value = None;
                continue;
            }
            let mut quartic = [-self.threshold, 0.0, 0.0, 0.0, 0.0];
            for span in active {
                span.add(start, &mut quartic);
            }
            let [a, b, c, d, e] = quartic;
            let at = |t: f64| a + t * (b + t * (c + t * (d + t * e)));
            let seeds = roots_between::<5>(&quartic, 0.0, length);
            let seeds = seeds.as_slice();
            let mut from = (0.0, value.unwrap_or(a));
            for i in 0..seeds.len().max(1) {
                let t = seeds.get(i + 1).map_or(length, |next| 0.5 * (seeds[i] + next));
                let to = (t, at(t));
                if (from.1 > 0.0) != (to.1 > 0.0) {
                    // Only where gaps meet can there be a change without a root.
                    let root = seeds.get(i).copied().unwrap_or_else(|| between(from, to, at));
                    if !found(start + root + shift) {
                        return is_brief;
                    }
                }
                from = to;
            }
            value = Some(from.1);
        }
        is_brief
    }
}

impl Shape for Blob {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.walk(ray, range, false, |t| {
            if range.contains(t) {
                out.push(Crossing::new(t, 0));
            }
            t < range.max
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let seek = |briefly| {
            let mut nearest = None;
            let is_brief = self.walk(ray, range, briefly, |t| {
                nearest = range.contains(t).then(|| Crossing::new(t, 0));
                nearest.is_none() && t < range.max
            });
            (nearest, is_brief)
        };
        // A ray that starts inside may meet nothing before the middle of a part.
        match seek(true) {
            (None, true) => seek(false).0,
            (nearest, _) => nearest,
        }
    }

    fn inside(&self, point: DVec3) -> bool {
        let rounding = 8.0 * f64::EPSILON * self.threshold.abs();
        self.value(point).0 >= -rounding
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        uncrossed::inside_along(self, point)
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.touched(point, crossing).map_or(DVec3::X, |(_, normal)| normal)
    }

    fn textures(&self, point: DVec3, _crossing: &Crossing, found: &mut dyn FnMut(u32, f64)) {
        if !self.textured {
            return;
        }
        let mut sum = 0.0;
        self.around(point, |_, field, _| sum += field.abs());
        self.around(point, |part, field, _| found(part.texture, field.abs() / sum));
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.touched(point, crossing).map_or(point, |(on, _)| on)
    }

    fn touched(&self, point: DVec3, _crossing: &Crossing) -> Option<(DVec3, DVec3)> {
        let (value, slope) = self.value(point);
        if slope == DVec3::ZERO {
            return Some((point, DVec3::X));
        }
        let step = slope * (value / slope.length_squared());
        // Where the gradient nearly vanishes the step leads anywhere.
        let near = step.length_squared() <= 1e-12 * self.bounds.size().length_squared();
        Some((if near { point - step } else { point }, -slope))
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    fn ball(center: [f64; 3], radius: f64, strength: f64) -> Part {
        let place = Transform::scale(DVec3::splat(radius)).then(&Transform::translate(center.into()));
        Part::ball(&place, strength, OWN_TEXTURE)
    }

    /// The probed blob of three, in another size and place.
    fn three(size: f64, at: DVec3) -> Blob {
        let parts = [([0.0, 0.0, 0.0], 1.5, 1.2), ([1.0, 0.3, 0.0], 1.4, 0.9), ([0.4, 0.6, -0.5], 0.6, -0.7)];
        let place = |center: [f64; 3]| (at + size * DVec3::from(center)).to_array();
        let parts = parts.map(|(center, radius, strength)| ball(place(center), size * radius, strength));
        Blob::new(parts.to_vec(), 0.4)
    }

    fn capsule() -> Blob {
        let place = Transform::rotate(DVec3::Y * 90.0).then(&Transform::translate(DVec3::NEG_X));
        Blob::new(Part::capsule(&place, 2.0, 1.0, OWN_TEXTURE).to_vec(), 0.5)
    }

    battery! {
        balls: |size, at| three(0.6 * size, at);
        tube: || capsule();
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &Blob::new(vec![ball([0.0; 3], 2.0, 1.0)], 0.5),
            "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -1.059043377418418> N <0.092387953251129, 0.184775906502257, -0.978428500438502>
            from <0,0,0> dir <1,0,0> | P <1.082392200292394, 0, 0> N <1, 0, 0>
            inside <1.0823921,0,0> | 1
            inside <1.0823926,0,0> | 0
            extent | <-2, -2, -2> .. <2, 2, 2>",
        );
        table(
            &three(1.0, DVec3::ZERO),
            "from <0.1,0.2,-5> dir <0.05,0.01,1> | P <0.302017233595763, 0.240403446719153, -0.959655328084748> N <0.000014241195265, 0.209314027365438, -0.977848473816495>
            from <0.45,0.5,-5> dir <0,0,1> | P <0.45, 0.5, -0.468250058361426> N <-0.176895318621634, 0.738015236367854, -0.651184733496303>
            inside <0.4,0.6,-0.5> | 0
            inside <0.5,0.2,0> | 1
            extent | <-1.5, -1.5, -1.5> .. <2.400000095367432, 1.700000047683716, 1.5>",
        );
        table(
            &capsule(),
            "from <0.3,5,0.1> dir <0,-1,0> | P <0.3, 0.53187707114845, 0.1> N <0, 0.982780679692203, 0.184775906502257>
            from <1.3,5,0.1> dir <0,-1,0> | P <1.3, 0.439196105188969, 0.1> N <0.554327719507048, 0.811528584685931, 0.184775906502349>
            from <-5,0.1,0.1> dir <1,0,0> | P <-1.522391824987195, 0.1, 0.1> N <-0.965254230113776, 0.184775906502257, 0.184775906502257>
            inside <1.5,0,0> | 1
            inside <1.55,0,0> | 0",
        );
    }

    #[test]
    fn a_stretched_and_turned_component_keeps_its_tips() {
        // POV-Ray's box cuts them at 7.778.
        let place = Transform::scale(DVec3::new(1.0, 1.0, 10.0)).then(&Transform::rotate(DVec3::Y * 45.0));
        let blob = Blob::new(vec![Part::ball(&place, 1.0, OWN_TEXTURE)], 0.1);
        table(&blob, "inside <5.7,0,5.7> | 1\ninside <5.4,0,5.4> | 1\ninside <5.9,0,5.9> | 0");
        assert!(blob.bounds().max.x > 7.0 && blob.bounds().max.x < 7.2);
    }

    #[test]
    fn textures_are_weighed_by_the_strength_of_their_fields() {
        let mut parts = [ball([-0.5, 0.0, 0.0], 1.0, 1.0), ball([0.5, 0.0, 0.0], 1.0, -3.0)];
        parts[0].texture = 4;
        let mut found = Vec::new();
        let blob = Blob::new(parts.to_vec(), 0.5);
        blob.textures(DVec3::ZERO, &Crossing::new(0.0, 0), &mut |texture, weight| {
            found.push((texture, weight))
        });
        found.sort_by_key(|(texture, _)| *texture);
        assert_eq!(found, [(4, 0.25), (OWN_TEXTURE, 0.75)]);
    }

    #[test]
    fn a_blob_that_only_carves_is_nowhere() {
        let blob = Blob::new(vec![ball([0.0; 3], 1.0, -1.0)], 0.5);
        assert!(blob.bounds().is_empty() && !blob.inside(DVec3::ZERO));
    }
}
