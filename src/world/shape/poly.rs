//! `cubic`, `quartic`, `poly`, `polynomial` (docs/spec/primitives.md 3.9).

mod along;
mod four;

use std::ops::{Add, Mul};
use std::sync::Arc;

use self::along::{Along, FEW};
use super::r#box::Cuboid;
use super::{Crossing, Shape, downhill};
use crate::math::double::Double;
use crate::math::roots::{any_between, each_root};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec3, Lanes};
use crate::world::{Range, Ray, Rays};

/// The surface where a polynomial in x, y and z is zero; inside where it isn't above.
#[derive(Clone, Debug, PartialEq)]
pub struct Poly {
    degree: usize,
    /// By the exponent of x, then of y, then of z, each in Horner's order: the highest first.
    coefficients: Arc<[Vec<Vec<f64>>]>,
    home: Home,
}

/// Where most of a surface is that matters: roots on a line are looked for inside and outside of it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Home {
    /// Nobody knows.
    Anywhere,
    /// A ball: middle and radius.
    Ball(DVec3, f64),
    /// A box; rays that miss it miss the surface.
    Gate(Cuboid),
}

/// The highest degree.
pub const MAX_DEGREE: usize = 35;

/// How far beyond its ends a range is searched, as a share of their distance.
const BESIDE: f64 = 1e-6;

/// How many times farther than its own rounding that of the terms may move a root before it is looked at closer.
const ROUGH: f64 = 64.0;

/// The longest step that betters a root, as a share of its distance.
const LEAP: f64 = 1e-8;

/// A whole line.
const LINE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// How much larger than asked for a ball is.
const ROOM: f64 = 1.0 + 1e-9;

impl Poly {
    /// From the coefficients in the order of the `poly` statement; missing ones are 0.
    /// `None` for a degree out of 1 … [`MAX_DEGREE`].
    pub fn new(degree: u32, coefficients: &[f64]) -> Option<Self> {
        let degree = degree as usize;
        if !(1..=MAX_DEGREE).contains(&degree) {
            return None;
        }
        let mut rest = coefficients.iter().copied();
        let mut all = Vec::new();
        for i in (0..=degree).rev() {
            let mut by_y = Vec::new();
            for j in (0..=degree - i).rev() {
                let by_z: Vec<f64> = (0..=degree - i - j).map(|_| rest.next().unwrap_or(0.0)).collect();
                by_y.push(trimmed(by_z, |c| *c == 0.0));
            }
            all.push(trimmed(by_y, Vec::is_empty));
        }
        Some(Self { degree, coefficients: trimmed(all, Vec::is_empty).into(), home: Home::Anywhere })
    }

    /// The polynomial in the distance along a ray.
    #[inline(always)]
    fn along<const N: usize>(&self, ray: &Ray) -> Along<N> {
        let (o, d) = (ray.origin, ray.direction);
        let mut in_x = Along::<N>::ZERO;
        for by_y in &*self.coefficients {
            in_x.step(o.x, d.x);
            let mut in_y = Along::<N>::ZERO;
            for by_z in by_y {
                in_y.step(o.y, d.y);
                if by_z.is_empty() {
                    continue;
                }
                let mut in_z = Along::<N>::ZERO;
                for coefficient in by_z {
                    in_z.step(o.z, d.z);
                    in_z.add_constant(*coefficient);
                }
                in_y.add(&in_z);
            }
            in_x.add(&in_y);
        }
        in_x
    }

    /// The part of a line in the home, or all of it. Whatever the range, a line is parted there, so that a crossing is
    /// always the same to the last bit. `None` where the ray, which starts at `start`, misses the gate.
    #[inline(always)]
    fn at_home(&self, ray: &Ray, start: f64) -> Option<[f64; 2]> {
        match self.home {
            Home::Anywhere => Some(LINE),
            Home::Ball(center, radius) => Some(in_ball(ray, center, radius)),
            Home::Gate(gate) => {
                gate.span(ray).filter(|span| span.leave.t >= start)?;
                // Nearer to a surface than the ball around the box more terms change their sign.
                self.home.ball().map(|(center, radius)| in_ball(ray, center, radius))
            }
        }
    }

    /// The middle of the home.
    #[inline(always)]
    fn middle(&self) -> DVec3 {
        self.home.ball().map_or(DVec3::ZERO, |(center, _)| center)
    }

    /// Calls back with the distance of every crossing in range, ascending, until told to stop.
    #[inline(always)]
    fn walk(&self, ray: &Ray, range: Range, found: impl FnMut(f64) -> bool) {
        match self.degree {
            ..=4 => self.walk_few::<5>(ray, range, found),
            5..=8 => self.walk_few::<9>(ray, range, found),
            _ => self.walk_few::<{ MAX_DEGREE + 1 }>(ray, range, found),
        }
    }

    /// The same, with room for so many terms.
    fn walk_few<const N: usize>(&self, whole: &Ray, range: Range, mut found: impl FnMut(f64) -> bool) {
        let Some((shift, ray, home)) = self.moved(whole) else {
            return;
        };
        let along = self.polynomial::<N>(&ray);
        let beside = |end: f64| BESIDE * (end.abs() + shift.abs());
        let wanted = [range.min - shift - beside(range.min), range.max - shift + beside(range.max)];
        let mut each = |t: f64| {
            let rounding = along.size(t);
            let (t, slope) = self.polish(&ray, t);
            let is_rough = rounding > ROUGH * (slope * t).abs();
            let t = if is_rough { self.refined(whole, t + shift) } else { t + shift };
            t < range.max && (t <= range.min || found(t))
        };
        for ends in parted(home) {
            if ends[0] < ends[1]
                && ends[1] >= wanted[0]
                && !along.is_void(ends)
                && !each_root::<N>(&along.terms[..along.count], ends, wanted, &mut each)
            {
                return;
            }
        }
    }

    /// How far along a ray it is nearest to the middle of its home, the ray from there, and its part in the home.
    #[inline(always)]
    fn moved(&self, ray: &Ray) -> Option<(f64, Ray, [f64; 2])> {
        widest(
            #[inline(always)]
            || {
                let (shift, ray) = ray.moved_to(self.middle());
                Some((shift, ray, self.at_home(&ray, -shift)?))
            },
        )
    }

    #[inline(always)]
    fn polynomial<const N: usize>(&self, ray: &Ray) -> Along<N> {
        widest(
            #[inline(always)]
            || self.along(ray),
        )
    }

    /// Whether a ray meets the surface in `range`, as far as signs alone tell.
    fn is_met<const N: usize>(&self, ray: &Ray, range: Range) -> Option<bool> {
        let Some((shift, ray, home)) = self.moved(ray) else {
            return Some(false);
        };
        let along = self.polynomial::<N>(&ray);
        let ahead = [range.min - shift, range.max - shift];
        for ends in parted(home) {
            let [low, high] = [ends[0].max(ahead[0]), ends[1].min(ahead[1])];
            if low < high && !along.is_void(ends) {
                let is_finite = low.is_finite() && high.is_finite();
                if is_finite.then(|| any_between(&along.terms, low, high))?? {
                    return Some(true);
                }
            }
        }
        Some(false)
    }

    /// One Newton step on the surface's own equation, whose terms cancel less than those of the
    /// polynomial in the distance, unless it is a leap; and how fast the value changes there along the ray.
    fn polish(&self, ray: &Ray, t: f64) -> (f64, f64) {
        let (value, gradient) = self.value(ray.at(t));
        let slope = gradient.dot(ray.direction);
        let step = value / slope;
        (if step.abs() <= LEAP * t.abs() { t - step } else { t }, slope)
    }

    /// One Newton step where a ray grazes the surface or comes to a tip of it, which makes much of little rounding.
    #[cold]
    fn refined(&self, ray: &Ray, t: f64) -> f64 {
        let value = self.sum(Double::along(ray.origin, ray.direction, t), Double::of);
        let step = value.rounded() / self.value(ray.at(t)).1.dot(ray.direction);
        if step.abs() <= LEAP * t.abs() { t - step } else { t }
    }

    /// Value and gradient.
    fn value(&self, p: DVec3) -> (f64, DVec3) {
        let (mut value, mut slope) = (0.0, DVec3::ZERO);
        for by_y in &*self.coefficients {
            let (mut in_y, mut slope_y, mut slope_yz) = (0.0, 0.0, 0.0);
            for by_z in by_y {
                let (mut in_z, mut slope_z) = (0.0, 0.0);
                for c in by_z {
                    slope_z = slope_z * p.z + in_z;
                    in_z = in_z * p.z + c;
                }
                slope_y = slope_y * p.y + in_y;
                slope_yz = slope_yz * p.y + slope_z;
                in_y = in_y * p.y + in_z;
            }
            slope = DVec3::new(slope.x * p.x + value, slope.y * p.x + slope_y, slope.z * p.x + slope_yz);
            value = value * p.x + in_y;
        }
        (value, slope)
    }

    /// The value in numbers of any kind that are added and multiplied.
    fn sum<T: Copy + Add<Output = T> + Mul<Output = T>>(
        &self,
        [x, y, z]: [T; 3],
        constant: impl Fn(f64) -> T,
    ) -> T {
        let zero = constant(0.0);
        self.coefficients.iter().fold(zero, |sum, by_y| {
            let in_y = by_y.iter().fold(zero, |in_y, by_z| {
                in_y * y + by_z.iter().fold(zero, |in_z, c| in_z * z + constant(*c))
            });
            sum * x + in_y
        })
    }
}

/// The part of a ray in a ball to the middle of which its origin is nearest, or all of it.
#[inline(always)]
fn in_ball(ray: &Ray, center: DVec3, radius: f64) -> [f64; 2] {
    let square = radius * radius - (ray.origin - center).length_squared();
    let half = (square.max(0.0) / ray.direction.length_squared()).sqrt();
    if half > 0.0 { [-half, half] } else { LINE }
}

/// A line parted by a stretch of it.
#[inline(always)]
fn parted([low, high]: [f64; 2]) -> [[f64; 2]; 3] {
    [[f64::NEG_INFINITY, low], [low, high], [high, f64::INFINITY]]
}

/// Without the leading entries that are `empty`.
fn trimmed<T>(mut all: Vec<T>, empty: impl Fn(&T) -> bool) -> Vec<T> {
    let from = all.iter().position(|entry| !empty(entry)).unwrap_or(all.len());
    all.drain(..from);
    all
}

impl Shape for Poly {
    fn bounds(&self) -> Bounds {
        Bounds::ALL
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.walk(ray, range, |t| {
            out.push(Crossing::new(t, 0));
            true
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest = None;
        self.walk(ray, range, |t| {
            nearest = Some(Crossing::new(t, 0));
            false
        });
        nearest
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        let told = match self.degree {
            ..=4 => self.is_met::<5>(ray, range),
            5..=8 => self.is_met::<FEW>(ray, range),
            _ => None,
        };
        told.unwrap_or_else(|| self.nearest(ray, range).is_some())
    }

    fn nearest_together(
        &self,
        rays: &Rays,
        asked: u32,
        ends: &Lanes,
        found: &mut [Option<Crossing>; Lanes::COUNT],
    ) -> bool {
        let Some(ball) = self.home.ball().filter(|_| self.degree == 4) else { return false };
        let (missed, first) = self.first_of_four(rays, ball);
        for lane in (0..Lanes::COUNT).filter(|lane| (asked & !missed) >> lane & 1 == 1) {
            let (t, range) = (first.0[lane], Range { min: 0.0, max: ends.0[lane].next_up() });
            found[lane] = if t > 0.0 {
                range.contains(t).then(|| Crossing::new(t, 0))
            } else {
                self.nearest(&rays.ray(lane), range)
            };
        }
        true
    }

    fn at_home_in(&self, center: DVec3, radius: f64) -> Option<Arc<dyn Shape>> {
        Some(Arc::new(Self { home: Home::Ball(center, radius * ROOM), ..self.clone() }))
    }

    fn behind_gate(&self, gate: Cuboid) -> Option<Arc<dyn Shape>> {
        Some(Arc::new(Self { home: Home::Gate(gate), ..self.clone() }))
    }

    fn gate(&self) -> Option<Cuboid> {
        match self.home {
            Home::Gate(gate) => Some(gate),
            Home::Anywhere | Home::Ball(..) => None,
        }
    }

    fn is_closed(&self) -> bool {
        true
    }

    /// The surface is inside, as far as rounding can tell. POV-Ray adds all values below 1e-4.
    fn inside(&self, point: DVec3) -> bool {
        let value = self.sum(point.to_array(), |c| c);
        let size = self.sum(point.abs().to_array(), f64::abs);
        value <= 8.0 * f64::EPSILON * size
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        // Bands have room for more than the rounding that counts as inside.
        self.sum(*point, Band::constant).less_equal(Band::constant(0.0))
    }

    /// Asked for where the surface is: near a tip the gradient beside it is another one.
    fn normal(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        let gradient = self.value(point).1;
        if gradient == DVec3::ZERO { DVec3::X } else { gradient }
    }

    fn reproject(&self, point: DVec3, _crossing: &Crossing) -> DVec3 {
        downhill(point, self.value(point), point.length_squared())
    }
}

#[cfg(test)]
mod tests;
