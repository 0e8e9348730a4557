//! POV-Ray's march along a ray: steps by a guess of how far the surface is, at least as long as the precision says.
//! What is thinner may be passed by, and is in the same pictures as in POV-Ray's.

use super::{AT_ONCE, JuliaFractal, Map, cubed, squared, squares};
use crate::math::roots::between;
use crate::math::{DVec3, DVec4};
use crate::world::Ray;

/// How far behind its start a ray begins to look for the surface that may be there, many times what rounding
/// moves it by. The ball's radius is about 2 whatever the size of the object.
const NEAR: f64 = 1e-12;

/// What an orbit says about the point it began at.
pub(super) struct Passage {
    pub(super) inside: bool,
    /// By how much the square of its last distance exceeds that at which it has escaped.
    excess: f64,
    /// How far the march may safely go.
    clear: f64,
}

impl JuliaFractal {
    /// Follows the orbit of a point; `direction` is a unit vector along the march.
    pub(super) fn follow(&self, p: DVec3, direction: DVec3) -> Passage {
        match self.orbit.map {
            Map::Square => self.follow_quaternion(p, 0.5, squared),
            Map::Cube => self.follow_quaternion(p, 1.0 / 3.0, cubed),
            _ => self.follow_hypercomplex(p, direction),
        }
    }

    /// The same for a power of quaternions; `share` is one over its exponent.
    #[inline(always)]
    fn follow_quaternion(&self, p: DVec3, share: f64, power: impl Fn(DVec4, f64, f64) -> DVec4) -> Passage {
        let (escape, constant) = (self.orbit.escape(), self.orbit.constant);
        let mut q = self.orbit.start(p);
        // The square of the product of all lengths, and what it tells of the way to the surface.
        let (mut chain, mut part) = (1.0, 1.0);
        let mut excess = 0.0;
        for _ in 0..self.orbit.iterations {
            let [real, imaginary] = squares(q);
            let square = real + imaginary;
            excess = square - escape;
            chain *= square;
            part *= share;
            if square > escape || square.is_nan() {
                // How fast orbits part, from the product of all lengths.
                let clear = part * (square / chain).sqrt() * square.ln();
                return Passage { inside: false, excess, clear: clear.max(self.step) };
            }
            q = power(q, real, imaginary) + constant;
        }
        Passage { inside: true, excess, clear: self.step }
    }

    fn follow_hypercomplex(&self, p: DVec3, direction: DVec3) -> Passage {
        let escape = self.orbit.escape();
        let mut q = self.orbit.start(p);
        let mut excess = 0.0;
        for turn in 0..self.orbit.iterations {
            let square = q.length_squared();
            excess = square - escape;
            if square > escape || square.is_nan() {
                let clear = self.clearance(p, direction, turn, square);
                return Passage { inside: false, excess, clear: clear.max(self.step) };
            }
            q = self.orbit.apply(q);
        }
        Passage { inside: true, excess, clear: self.step }
    }

    /// POV-Ray's guess of how far a hypercomplex orbit that escaped is from one that doesn't.
    fn clearance(&self, p: DVec3, direction: DVec3, turn: u32, square: f64) -> f64 {
        let slope = -2.0 * self.orbit.gradient(p, turn).dot(direction);
        let clear = square / slope;
        if slope > 2e-8 && clear > self.step && clear < 30.0 * self.step { clear } else { self.step }
    }

    /// Calls back with the distance of every crossing behind `start`, ascending, until it returns `false`.
    pub(super) fn walk(&self, ray: &Ray, start: f64, mut found: impl FnMut(f64) -> bool) {
        let speed = ray.direction.length();
        let Some(stretch) = self.ball.stretch(ray).filter(|s| s.leave.t > start && s.enter.t.is_finite())
        else {
            return;
        };
        let begin = start.max(stretch.enter.t);
        let (origin, direction) = (ray.at(begin), ray.direction / speed);
        let end = (stretch.leave.t - begin) * speed;
        let at = |t: f64| self.follow(origin + t * direction, direction);
        // Rays that leave a surface start at 0.
        let mut t = if begin == 0.0 && start == 0.0 { AT_ONCE } else { NEAR };
        let mut here = at(t);
        // What reaches the ball ends there.
        if here.inside && begin > start && !found(begin) {
            return;
        }
        while t < end {
            let next = t + here.clear;
            if next > end {
                if here.inside {
                    found(stretch.leave.t);
                }
                return;
            }
            let there = at(next);
            if there.inside != here.inside {
                // Close to the surface the sign is that of a smooth function: whether the last turn escapes.
                let sign = |orbit: &Passage| {
                    if orbit.inside { orbit.excess } else { orbit.excess.max(f64::MIN_POSITIVE) }
                };
                let root = between((t, sign(&here)), (next, sign(&there)), |t| sign(&at(t)));
                if !found(begin + root / speed) {
                    return;
                }
            }
            (t, here) = (next, there);
        }
    }
}
