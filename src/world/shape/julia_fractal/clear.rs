//! How far around a point all orbits escape, of quaternions: what makes long steps towards the surface.

use super::{Map, Orbit};
use crate::math::{DVec3, DVec4};
use crate::world::{Range, Ray};

/// Steps shorter than this, of a ball of radius about 2, are left to bands.
const SHORT: f64 = 2e-3;

/// So many steps, at most.
const STEPS: usize = 100;

/// More than what rounding adds to a distance or takes from it, as a share.
const ROUNDING: f64 = 1e-12;

/// The share of the way that orbits which part as the first one's neighbours do leave free.
const SHARE: f64 = 0.75;

/// Lengths of an orbit's points, until they are so long that there is no doubt.
const LONG: f64 = 1e3;

impl Orbit {
    /// Whether orbits that have once escaped never come back, and how fast they part is known.
    fn escapes_for_good(&self) -> bool {
        matches!(self.map, Map::Square | Map::Cube)
    }

    /// By how much the images of points can be apart, of one of this length and others this near.
    fn parted(&self, length: f64, near: f64) -> f64 {
        match self.map {
            Map::Cube => near * (3.0 * length * (length + near) + near * near),
            _ => near * (2.0 * length + near),
        }
    }

    /// How far from a point all orbits escape, or less; 0 where its own does not. `stretch` is how much farther
    /// apart the orbits begin than the points are.
    fn clear(&self, p: DVec3, stretch: f64) -> f64 {
        let escape = self.escape().sqrt() * (1.0 + ROUNDING);
        let mut lengths = [0.0; 64];
        let mut count = 0;
        let mut q: DVec4 = self.start(p);
        // How much farther apart very near orbits are now, and the farthest that they might begin.
        let (mut spread, mut most) = (stretch, 0.0_f64);
        for (turn, length) in lengths.iter_mut().enumerate().take(self.iterations as usize) {
            *length = q.length();
            count = turn + 1;
            most = most.max((*length - escape) / spread);
            if *length >= LONG || length.is_nan() {
                break;
            }
            spread *= self.parted(*length, 1e-9) * 1e9;
            q = self.apply(q);
        }
        let lengths = &lengths[..count];
        let mut step = SHARE * most;
        while step > 0.0 {
            let mut near = step * stretch;
            for length in lengths {
                let rounding = ROUNDING * (1.0 + length);
                if length - near - rounding > escape {
                    return step;
                }
                near = self.parted(*length, near) + rounding;
            }
            step = if step > 0.1 * SHORT { 0.5 * step } else { 0.0 };
        }
        0.0
    }

    /// A distance up to which a ray surely meets no surface within the ball, from `range.min` on; at least that.
    pub(super) fn skipped(&self, ray: &Ray, range: Range, ball: Range) -> f64 {
        if !self.escapes_for_good() {
            return range.min;
        }
        let speed = ray.direction.length();
        let fourth = self.slice.truncate().dot(ray.direction / speed);
        let stretch = (1.0 + fourth * fourth).sqrt() * (1.0 + ROUNDING);
        let begin = range.min.max(ball.min);
        let mut t = begin;
        for _ in 0..STEPS {
            let step = self.clear(ray.at(t), stretch);
            if step < SHORT {
                break;
            }
            t += step / speed;
            if t > ball.max {
                return ball.max;
            }
        }
        if t == begin { range.min } else { t }
    }
}
