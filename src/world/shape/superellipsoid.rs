//! `superellipsoid { <east-west, north-south> }` (docs/spec/primitives.md 3.10).

mod pieces;

use std::ops::ControlFlow;

use self::pieces::Pieces;
use super::stretch::Stretch;
use super::{Crossing, Shape, uncrossed};
use crate::math::{Band, Bounds, DVec3};
use crate::world::{Range, Ray};

/// ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2) = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Superellipsoid {
    /// 2 / e.
    around: Exponent,
    /// 2 / n.
    across: Exponent,
}

/// An exponent p, with the quickest ways to powers and roots.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Exponent {
    p: f64,
    inverse: f64,
    /// p, where it is a whole number.
    whole: Option<i32>,
}

impl Exponent {
    fn new(p: f64) -> Self {
        // Up to there products are as exact as they need to be.
        let is_whole = p.fract() == 0.0 && p <= 64.0;
        Self { p, inverse: 1.0 / p, whole: is_whole.then_some(p as i32) }
    }

    #[inline(always)]
    fn power(&self, x: f64) -> f64 {
        match self.whole {
            Some(p) => whole_power(x, p),
            None => x.powf(self.p),
        }
    }

    /// Also quick of 1, which is left where a power is lost beside it.
    fn root(&self, x: f64) -> f64 {
        match self.whole {
            _ if x == 1.0 => 1.0,
            Some(1) => x,
            Some(2) => x.sqrt(),
            Some(4) => x.sqrt().sqrt(),
            _ => x.powf(self.inverse),
        }
    }
}

/// What `powi` makes of a positive exponent, to the last bit, compiled together with what asks.
#[inline(always)]
fn whole_power(mut x: f64, mut p: i32) -> f64 {
    let mut power = 1.0;
    loop {
        if p & 1 != 0 {
            power *= x;
        }
        p >>= 1;
        if p == 0 {
            return power;
        }
        x *= x;
    }
}

/// The flattest exponent there is: a box to the last bit, and 0 needs no case of its own.
const SHARPEST: f64 = 1e-3;

/// Steps after which a search has long converged or never will.
const STEPS: usize = 200;

/// How far from 1 the function may be by rounding.
const NOISE: f64 = 8.0 * f64::EPSILON;

impl Superellipsoid {
    /// From both exponents; `None` for a negative one, which POV-Ray never hits.
    pub fn new(east: f64, north: f64) -> Option<Self> {
        let exponent = |e: f64| Exponent::new(2.0 / e.max(SHARPEST));
        (east >= 0.0 && north >= 0.0).then(|| Self { around: exponent(east), across: exponent(north) })
    }

    /// The function minus 1, and its gradient. It is homogeneous of degree 1.
    #[inline(always)]
    fn value(&self, p: DVec3) -> (f64, DVec3) {
        let (ring, [to_x, to_y]) = norm(p.x.abs(), p.y.abs(), &self.around);
        let (value, [to_ring, to_z]) = norm(ring, p.z.abs(), &self.across);
        let slope = DVec3::new(to_ring * to_x, to_ring * to_y, to_z);
        (value - 1.0, slope * DVec3::new(sign(p.x), sign(p.y), sign(p.z)))
    }

    /// Whether the solid is convex, and its function with it.
    fn is_convex(&self) -> bool {
        self.around.p >= 1.0 && self.across.p >= 1.0
    }

    /// Newton steps along a convex function from outside never pass its root; `None` once the slope
    /// turns, or past `end`. `sense` is 1 forward, -1 backward.
    fn approach(&self, ray: &Ray, mut t: f64, end: f64, sense: f64) -> Option<f64> {
        for _ in 0..STEPS {
            let (value, gradient) = self.value(ray.at(t));
            if value <= NOISE {
                return Some(t);
            }
            let slope = gradient.dot(ray.direction) * sense;
            let next = t - sense * value / slope;
            if slope >= 0.0 || slope.is_nan() || sense * next > sense * end {
                return None;
            }
            if next == t {
                return Some(t);
            }
            t = next;
        }
        Some(t)
    }

    fn stretch(&self, ray: &Ray, low: f64, high: f64) -> Option<Stretch> {
        let enter = self.approach(ray, low, high, 1.0)?;
        let leave = self.approach(ray, high, enter, -1.0).unwrap_or(enter);
        Stretch::new(enter, 0, leave, 0)
    }

    /// Calls back with the crossings in a range of what isn't convex, in ascending order, until that breaks off.
    fn each_apart(&self, ray: &Ray, range: Range, found: &mut dyn FnMut(Crossing) -> ControlFlow<()>) {
        let (shift, ray) = ray.moved_to(DVec3::ZERO);
        let pieces = Pieces::new(self, &ray, [range.min - shift, range.max - shift]);
        let _: ControlFlow<()> = pieces.each(&mut |t| {
            let t = t + shift;
            if range.contains(t) { found(Crossing::new(t, 0)) } else { ControlFlow::Continue(()) }
        });
    }

    /// The ray from where it is nearest to the middle, and the part of it in the box around.
    fn clipped(ray: &Ray) -> Option<(f64, Ray, f64, f64)> {
        let (shift, ray) = ray.moved_to(DVec3::ZERO);
        let mut all = Stretch::LINE;
        for axis in 0..3 {
            let room = 1.0 + 1e-9;
            all = all.meet(Stretch::slab((-room, 0), (room, 0), ray.origin[axis], ray.direction[axis])?)?;
        }
        (all.enter.t.is_finite() && all.leave.t.is_finite()).then_some((shift, ray, all.enter.t, all.leave.t))
    }
}

/// (a^p + b^p)^(1/p) of two non-negative numbers, on their ratio so that nothing overflows, and its slopes.
#[inline(always)]
fn norm(a: f64, b: f64, exponent: &Exponent) -> (f64, [f64; 2]) {
    let (large, small) = if a >= b { (a, b) } else { (b, a) };
    if large == 0.0 {
        return (0.0, [0.0, 0.0]);
    }
    let ratio = small / large;
    let power = exponent.power(ratio);
    let factor = exponent.root(1.0 + power);
    // d/d large and d/d small of large (1 + ratio^p)^(1/p).
    let outer = factor / (1.0 + power);
    let inner = if small == 0.0 && exponent.p > 1.0 { 0.0 } else { outer * power / ratio };
    let inner = if inner.is_finite() { inner } else { f64::MAX.sqrt() };
    (large * factor, if a >= b { [outer, inner] } else { [inner, outer] })
}

fn sign(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

impl Shape for Superellipsoid {
    fn bounds(&self) -> Bounds {
        Bounds::new(DVec3::NEG_ONE, DVec3::ONE)
    }

    fn extent(&self) -> Bounds {
        /// POV-Ray's half edge.
        const HALF: f64 = 1.0001;
        Bounds::new(DVec3::splat(-HALF), DVec3::splat(HALF))
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if self.is_convex() {
            let Some((shift, ray, low, high)) = Self::clipped(ray) else { return };
            if let Some(stretch) = self.stretch(&ray, low, high) {
                stretch.shifted(shift).push(range, out);
            }
            return;
        }
        self.each_apart(ray, range, &mut |crossing| {
            out.push(crossing);
            ControlFlow::Continue(())
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        if self.is_convex() {
            let (shift, ray, low, high) = Self::clipped(ray)?;
            let start = range.min - shift;
            if start > low {
                // Once outside and on the way out, always so.
                let (value, gradient) = self.value(ray.at(start));
                if value > NOISE && gradient.dot(ray.direction) >= 0.0 {
                    return None;
                }
                // What starts inside only leaves.
                if value < -NOISE {
                    let leave = self.approach(&ray, high, start, -1.0)? + shift;
                    return range.contains(leave).then(|| Crossing::new(leave, 0));
                }
            }
            let enter = self.approach(&ray, low, high, 1.0)?;
            if enter + shift > range.min {
                return range.contains(enter + shift).then(|| Crossing::new(enter + shift, 0));
            }
            let leave = self.approach(&ray, high, enter, -1.0).unwrap_or(enter) + shift;
            return range.contains(leave).then(|| Crossing::new(leave, 0));
        }
        let mut nearest = None;
        self.each_apart(ray, range, &mut |crossing| {
            nearest = Some(crossing);
            ControlFlow::Break(())
        });
        nearest
    }

    fn is_closed(&self) -> bool {
        true
    }

    fn inside(&self, point: DVec3) -> bool {
        self.value(point).0 <= NOISE
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        uncrossed::inside_along(self, point)
    }

    fn normal(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        self.value(point).1.normalize_or(DVec3::Z)
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        // The function is homogeneous: scaling about the middle goes straight to the surface.
        point / (1.0 + self.value(point).0)
    }

    fn touched(&self, point: DVec3, _crossing: &Crossing) -> Option<(DVec3, DVec3)> {
        // The slope is the same all the way from the middle.
        let (value, gradient) = self.value(point);
        Some((point / (1.0 + value), gradient.normalize_or(DVec3::Z)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::battery::{battery, table};
    use super::*;

    fn make(east: f64, north: f64) -> Superellipsoid {
        Superellipsoid::new(east, north).unwrap()
    }

    battery! {
        rounded_box: || make(0.5, 0.25);
        sharp_box: || make(0.1, 0.1);
        ball: || make(1.0, 1.0);
        double_cone: || make(1.0, 2.0);
        octahedron: || make(2.0, 2.0);
        pillow: || make(0.25, 1.7);
        star: || make(3.0, 1.0);
        spindle: || make(0.3, 3.0);
        sharp_star: || make(3.0, 3.0);
        pinched_box: || make(3.0, 0.3);
    }

    #[test]
    fn probes_agree_with_povray() {
        table(
            &make(0.5, 0.25),
            "from <0.1,0.2,-5> dir <0.05,0.1,1> | P <0.300119888789216, 0.600239777578433, -0.997602224215672> N <0.003789724938987, 0.030317799511893, -0.999533125522933>
            from <0,0,0> dir <1,0.2,0.3> | P <0.999592228019142, 0.199918445603828, 0.299877668405743> N <0.999967977699706, 0.007999743821598, 0.000218343646888>
            from <5,0,0> dir <-1,0,0> | P <1, 0, 0> N <1, 0, 0>
            inside <0.9,0.5,0.5> | 1
            inside <0.99,0.9,0> | 0
            inside <1,0,0> | 1
            extent | <-1.000100016593933, -1.000100016593933, -1.000100016593933> .. <1.000100016593933, 1.000100016593933, 1.000100016593933>",
        );
        table(
            &make(1.0, 1.0),
            "from <0.1,0.2,-5> dir <0.05,0.1,1> | P <0.314446640393513, 0.628893280787025, -0.711067192129747> N <0.314446640394893, 0.628893280789786, -0.711067192128722>
            from <0.3,5,0.2> dir <0,-1,0> | P <0.3, 0.932737905308815, 0.2> N <0.30000000000002, 0.932737905308878, 0.199999999999988>",
        );
        table(
            &make(2.0, 0.3),
            "from <0.1,0.2,-5> dir <0.05,0.1,1> | P <0.305844684037882, 0.611689368075764, -0.883106319242365> N <0.614494605999077, 0.614494605999077, -0.494765356907775>
            from <5,0.2,0.3> dir <-1,0,0> | P <0.799950989027243, 0.2, 0.3> N <0.707106571434146, 0.707106571434146, 0.000770239764473>",
        );
        table(
            &make(0.25, 2.0),
            "from <0.1,0.2,-5> dir <0.05,0.1,1> | P <0.333351387971062, 0.666702775942124, -0.33297224057876> N <0.005514757351602, 0.705888941005009, -0.708301059167766>",
        );
        // POV-Ray's search ends where the function is below 1e-10: its normal is off by 3e-9.
        table(
            &make(0.1, 0.1),
            "from <0.9,0.95,-5> dir <0,0,1> | P <0.9, 0.95, -0.967826599256> N <0.201540910609, 0.562994351501, -0.801510212991>
            from <0.999,0.5,-5> dir <0,0,1> | P <0.999, 0.5, -0.821948149578097> N <0.999698440502986, 0.000001943366986, -0.024556629494327>",
        );
        table(&make(0.0, 0.0), "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -1> N <0, 0, -1>");
    }

    #[test]
    fn products_make_powers_as_they_are_made_elsewhere() {
        let mut number = crate::math::dice::numbers(3);
        for p in 1..=64 {
            for _ in 0..100 {
                let x = number() * 2.0;
                assert_eq!(whole_power(x, p).to_bits(), x.powi(p).to_bits(), "{x} {p}");
            }
        }
    }

    #[test]
    fn spikes_thinner_than_numbers_are_looked_for_no_longer_than_others() {
        for exponents in [[3000.0, 1.0], [1.0, 3000.0], [1e300, 1e300]] {
            let solid = make(exponents[0], exponents[1]);
            for (origin, to) in
                [(DVec3::new(0.1, 0.2, -5.0), DVec3::new(0.05, 0.1, 1.0)), (5.0 * DVec3::X, -DVec3::X)]
            {
                let found = solid.nearest(&Ray::new(origin, to), Range::AHEAD);
                assert!(found.is_none_or(|crossing| crossing.t.is_finite()), "{exponents:?}");
            }
        }
    }
}
