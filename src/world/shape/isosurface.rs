//! `isosurface` (docs/spec/primitives.md 5.2).

mod beam;
#[cfg(test)]
mod holes;
mod root;
mod search;

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::r#box::Cuboid;
use super::sphere::Sphere;
use super::stretch::Stretch;
use super::{Crossing, Remark, Shape};
use crate::math::wide::widest;
use crate::math::{Band, Bounds, DVec3, Lanes};
use crate::world::sample::Field;
use crate::world::{Range, Ray, Rays};
use search::Search;

/// Where a function has the value of a threshold, within a container; inside it isn't above.
///
/// Part 0 is the function's surface, the others are the container's, counted from 1.
#[derive(Clone, Debug)]
pub struct Isosurface {
    /// The function.
    pub function: Arc<dyn Field>,
    /// The threshold.
    pub threshold: f64,
    /// Where the surface is looked for.
    pub container: Container,
    /// What is thinner may be missed, if only by functions of which nothing is known or where the surface all but
    /// touches the ray; also the step that gives normals; positive.
    pub accuracy: f64,
    /// The steepest the function is, as its author says. Where nothing else is known of the function a stretch
    /// that it can't cross zero in at this gradient is passed over.
    pub max_gradient: f64,
    /// The share by which a steeper gradient met on the way exceeds itself as the new bound.
    pub adaptive: Option<f64>,
    /// How many crossings a ray has at most.
    pub most: usize,
    /// Without the container's own surface where it cuts the solid.
    pub open: bool,
    /// The steepest gradient that rays have met.
    pub steepest: Steepest,
}

/// The largest of many positive numbers, 0 before there are any.
#[derive(Debug, Default)]
pub struct Steepest(AtomicU64);

impl Steepest {
    fn add(&self, gradient: f64) {
        // Bits of numbers that aren't negative are in their order.
        self.0.fetch_max(gradient.to_bits(), Ordering::Relaxed);
    }

    fn get(&self) -> f64 {
        f64::from_bits(self.0.load(Ordering::Relaxed))
    }
}

impl Clone for Steepest {
    fn clone(&self) -> Self {
        Self(AtomicU64::new(self.get().to_bits()))
    }
}

/// The container of an [`Isosurface`].
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the variants are named after what they hold")]
pub enum Container {
    Box(Cuboid),
    Sphere(Sphere),
}

impl Container {
    fn shape(&self) -> &dyn Shape {
        match self {
            Self::Box(cuboid) => cuboid,
            Self::Sphere(sphere) => sphere,
        }
    }

    /// The box around it.
    pub(super) fn bounds(&self) -> Bounds {
        self.shape().bounds()
    }

    /// What of a line is inside.
    pub(super) fn stretch(&self, ray: &Ray) -> Option<Stretch> {
        widest(
            #[inline(always)]
            || match self {
                Self::Box(cuboid) => cuboid.stretch(ray),
                Self::Sphere(sphere) => sphere.stretch(ray),
            },
        )
    }

    fn holds(&self, point: DVec3) -> bool {
        match self {
            Self::Box(cuboid) => cuboid.inside(point),
            Self::Sphere(s) => (point - s.center).length_squared() <= s.radius * s.radius,
        }
    }
}

/// POV-Ray starts this many times the accuracy behind a surface to look for the next; so do we where bands
/// don't tell how soon the function is off zero.
const AWAY: f64 = 5.0;

/// The share of the coordinates that bands of shorter stretches don't tell apart, as points are rounded.
const SHORTEST: f64 = 4096.0 * f64::EPSILON;

/// A value at the surface that is so many times what it changes by within a step tells of a jump: where POV-Ray stops
/// behind the surface, as `trace` does, it may be about what it changes by.
const JUMP: f64 = 4.0;

/// What is asked of a ray.
#[derive(Clone, Copy)]
struct Asked {
    /// Crossings from here on.
    start: f64,
    /// Of a ray that comes in and is above the threshold there: where it is above until, and the end of the stretch
    /// behind that in which that may change first.
    clear: Option<[f64; 2]>,
    /// A crossing before that may as well be told a little behind where it is.
    enough: f64,
}

impl Asked {
    /// Exact crossings, of a ray of which nothing is known.
    fn all_from(start: f64) -> Self {
        Self { start, clear: None, enough: f64::NEG_INFINITY }
    }
}

impl Isosurface {
    fn value(&self, point: DVec3) -> f64 {
        self.function.at(point) - self.threshold
    }

    /// Calls back with the crossings asked for, ascending, until it returns `false`.
    fn walk(&self, ray: &Ray, asked: Asked, found: impl FnMut(Crossing) -> bool) {
        let steepest = Cell::new(0.0);
        self.walk_along(ray, asked, &steepest, found);
        self.meet(steepest.get());
    }

    /// Keeps a gradient that was met, where that is worth telling.
    fn meet(&self, gradient: f64) {
        if gradient > self.max_gradient {
            self.steepest.add(gradient);
        }
    }

    /// The nearest crossing of a ray; see [`Asked::clear`].
    fn nearest_beyond(&self, ray: &Ray, range: Range, clear: Option<[f64; 2]>) -> Option<Crossing> {
        let mut nearest = None;
        self.walk(ray, Asked { clear, ..Asked::all_from(range.min) }, |crossing| {
            nearest = range.contains(crossing.t).then_some(crossing);
            nearest.is_none() && crossing.t < range.max
        });
        nearest
    }

    fn walk_along(
        &self,
        ray: &Ray,
        Asked { start, clear, enough }: Asked,
        steepest: &Cell<f64>,
        mut found: impl FnMut(Crossing) -> bool,
    ) {
        let speed = ray.direction.length();
        let Some(stretch) =
            self.container.stretch(ray).filter(|s| s.enter.t.is_finite() && s.leave.t > start)
        else {
            return;
        };
        let begin = start.max(stretch.enter.t);
        let origin = ray.direction.mul_add(DVec3::splat(begin), ray.origin);
        let end = (stretch.leave.t - begin) * speed;
        let mut search = Search {
            surface: self,
            enough: (enough - begin) * speed,
            origin,
            direction: ray.direction / speed,
            gradient: self.max_gradient,
            steepest,
            // In POV-Ray it is a length in the scene, which is too coarse for what is scaled down.
            accuracy: (self.accuracy * speed.min(1.0)).max(SHORTEST * (origin.abs().max_element() + end)),
        };
        let away = AWAY * self.accuracy;
        let mut push = |t: f64, lag: f64, part: u32| {
            found(Crossing { at: [lag / speed, 0.0], ..Crossing::new(begin + t / speed, part) })
        };
        let mut left = self.most;
        let enters = begin > start;
        let mut clear = clear.filter(|_| enters).map(|places| places.map(|place| (place - begin) * speed));
        let mut look = (enters && clear.is_none()).then(|| search.look(0.0, end)).flatten();
        let told = clear.map(|_| false).or_else(|| look.and_then(|look| look.starts_below()));
        let value = if told.is_some() { f64::NAN } else { search.value(0.0) };
        // Behind the surface: from where on it is off zero, and until where that is known.
        let ([mut from, mut sure], mut inside) = ([0.0; 2], told.unwrap_or(value < 0.0));
        if enters {
            if inside && !self.open {
                left -= 1;
                if !push(0.0, 0.0, stretch.enter.part + 1) {
                    return;
                }
            }
        } else if value.abs() < 4.0 * self.max_gradient * self.accuracy {
            // The ray starts on the surface, or as good as: which side it is on shows a little farther.
            let departure = search.departure(0.0, away.min(end));
            ([from, sure], inside) = departure.unwrap_or_else(|| {
                let from = away.min(end);
                ([from; 2], search.value(from) < 0.0)
            });
        }
        while left > 0 {
            let sign = if inside { -1.0 } else { 1.0 };
            if sure > 0.0 {
                (clear, look) = (Some([sure.min(end), end]), search.look_behind(sure.min(end), end));
            }
            let Some((root, after)) = search.first([from, end], clear.take(), sign, look.take()) else {
                break;
            };
            left -= 1;
            inside = !inside;
            if !push(root, after - root, 0) {
                return;
            }
            let departure = search.departure(root, (after + away).min(end) - root);
            [from, sure] = match departure {
                Some((places, below)) if below == inside => places,
                _ => [after + away; 2],
            };
            if from >= end {
                break;
            }
        }
        if inside && !self.open && (left > 0 || self.most == 1 && !enters) && search.value(end) < 0.0 {
            found(Crossing::new(stretch.leave.t, stretch.leave.part + 1));
        }
    }
}

impl Shape for Isosurface {
    fn bounds(&self) -> Bounds {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.walk(ray, Asked::all_from(range.min), |crossing| {
            if range.contains(crossing.t) {
                out.push(crossing);
            }
            crossing.t < range.max
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.nearest_beyond(ray, range, None)
    }

    fn occludes(&self, ray: &Ray, range: Range) -> bool {
        let mut is_met = false;
        self.walk(ray, Asked { enough: range.max, ..Asked::all_from(range.min) }, |crossing| {
            is_met = range.contains(crossing.t);
            !is_met && crossing.t < range.max
        });
        is_met
    }

    fn nearest_together(
        &self,
        rays: &Rays,
        asked: u32,
        ends: &Lanes,
        found: &mut [Option<Crossing>; Lanes::COUNT],
    ) -> bool {
        let can = self.function.is_known() && !self.function.is_single();
        if can {
            self.nearest_of_beam(rays, asked, ends, found);
        }
        can
    }

    fn inside(&self, point: DVec3) -> bool {
        self.container.holds(point) && self.value(point) <= 0.0
    }

    fn inside_along(&self, point: &[Band; 3]) -> Band {
        let below = (self.function.enclose(point) - self.threshold).less_equal(Band::constant(0.0));
        let within = match &self.container {
            Container::Box(cuboid) => cuboid.inside_along(point),
            Container::Sphere(sphere) => sphere.inside_along(point),
        };
        within.and(below)
    }

    /// By differences with the accuracy as step, as in POV-Ray; where the function jumps at the surface and not within
    /// these steps it does within those the other way.
    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        if let Some(part) = crossing.part.checked_sub(1) {
            return self.container.shape().normal(point, &Crossing::new(crossing.t, part));
        }
        let DVec3 { x, y, z } = point;
        let step = self.accuracy;
        let places = [Lanes([x, x + step, x, x]), Lanes([y, y, y + step, y]), Lanes([z, z, z, z + step])];
        let [here, beside @ ..] = self.function.at_four(&places).map(|v| v - self.threshold).0;
        let mut normal = DVec3::from_array(beside.map(|v| v - here));
        if here.abs() > JUMP * normal.length() {
            let places = [Lanes([x - step, x, x, x]), Lanes([y, y - step, y, y]), Lanes([z, z, z - step, z])];
            let [behind @ .., _] = self.function.at_four(&places).map(|v| v - self.threshold).0;
            normal = DVec3::from_array(std::array::from_fn(|axis| beside[axis] - behind[axis]));
        }
        normal.try_normalize().unwrap_or(DVec3::X)
    }

    /// POV-Ray stops up to the accuracy behind the surface: textures as fine as that show it.
    fn lag(&self, crossing: &Crossing) -> f64 {
        crossing.at[0]
    }

    /// POV-Ray warns of it too, but not with `evaluate`.
    fn remark(&self) -> Option<Remark> {
        let (found, said) = (self.steepest.get(), self.max_gradient);
        let wrong = self.adaptive.is_none() && found > said * (1.0 + 1e-6);
        wrong.then_some(Remark::TooSteep { found, said, holes: !self.function.is_known() })
    }

    fn reproject(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        match crossing.part.checked_sub(1) {
            Some(part) => self.container.shape().reproject(point, &Crossing::new(crossing.t, part)),
            None => point,
        }
    }
}

#[cfg(test)]
mod tests;
