//! A torus around the y axis, and how it is seen.

use super::Sight;
use crate::math::DVec3;
use crate::world::screen::{OPEN, SHUT, UNKNOWN, Verdict};
use crate::world::shape::torus::Torus;

/// Places that are nearer to the surface, in parts of the torus' size, may be on either side of it.
const BLUR: f64 = 1e-8;

/// Rays that leave the surface start no farther inside of it than this.
const START: f64 = 1e-10;

/// From farther away, in units of its size, nothing is known of a torus.
const FAR: f64 = 1e4;

/// A torus as seen in its own space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ring {
    sight: Sight,
    torus: Torus,
    /// Half the thickness of the slab around it.
    height: f64,
    /// The squared radius of the hole, a little less; negative for none.
    hole: f64,
    /// The squared radius of the whole, a little more.
    around: f64,
    /// Whether ways that are inside of it somewhere are blocked.
    blocks: bool,
}

impl Ring {
    /// The torus as seen; `None` where nothing is known of it.
    pub(super) fn new(torus: &Torus, sight: Sight, opaque: bool) -> Option<Self> {
        let Torus { major, minor } = *torus;
        let size = major + minor;
        let near = sight.from.abs().max_element() < FAR * size;
        if !near {
            return None;
        }
        let blur = BLUR * size;
        let hole = major - minor - blur;
        // All ways end outside of it.
        let [a, b] = sight.axes;
        let room = a.length() * sight.reach[0] + b.length() * sight.reach[1] + size;
        let beyond = (sight.from + sight.middle).length() > room * (1.0 + BLUR);
        Some(Self {
            sight,
            torus: *torus,
            height: minor + blur,
            hole: if hole > 0.0 { hole * hole } else { -1.0 },
            around: (size + blur) * (size + blur),
            blocks: opaque && beyond && hole > 0.0,
        })
    }

    /// The verdict on a place of the light.
    #[inline]
    pub(super) fn verdict(&self, x: f64, y: f64) -> Verdict {
        let (from, way) = (self.sight.from, self.sight.way(x, y));
        let inverse = way.y.recip();
        let (one, other) = ((-self.height - from.y) * inverse, (self.height - from.y) * inverse);
        let (enter, leave) = (one.min(other).max(0.0), one.max(other).min(1.0));
        // Also where the way is level.
        if !(enter.is_finite() && leave.is_finite()) {
            return UNKNOWN;
        }
        if enter > leave {
            return OPEN;
        }
        let square = |t: f64| {
            let (x, z) = (from.x + t * way.x, from.z + t * way.z);
            x * x + z * z
        };
        if square(enter) < self.hole && square(leave) < self.hole {
            return OPEN;
        }
        let steep = way.x * way.x + way.z * way.z;
        let nearest = (-(from.x * way.x + from.z * way.z) / steep).max(enter).min(leave);
        if square(nearest) > self.around {
            return OPEN;
        }
        self.verdict_between(from + way * enter, way * (leave - enter))
    }

    /// The verdict on the way from `from` on for one `step`, by the quartic that is negative inside of the tube.
    fn verdict_between(&self, from: DVec3, step: DVec3) -> Verdict {
        let Torus { major, minor } = self.torus;
        // |p|² is square + 2 cross s + length s², for s from 0 to 1.
        let square = from.length_squared();
        let cross = from.dot(step);
        let length = step.length_squared();
        let round = 4.0 * major * major;
        let k = square + (major - minor) * (major + minor);
        let [a, b, c, d, e] = [
            k * k - round * (square - from.y * from.y),
            4.0 * k * cross - 2.0 * round * (cross - from.y * step.y),
            4.0 * cross * cross + 2.0 * k * length - round * (length - step.y * step.y),
            4.0 * cross * length,
            length * length,
        ];
        let size = major + minor;
        let unit = size * size * size * size + k * k + round * (square + length) + e;
        // Bernstein's coefficients: as long as they are positive the quartic is.
        let bernstein =
            [a, a + b / 4.0, a + b / 2.0 + c / 6.0, a + 0.75 * b + c / 2.0 + d / 4.0, a + b + c + d + e];
        let blur = BLUR * unit;
        let is_open = |[p, q, r, s, t]: [f64; 5], start: f64| p > start && q.min(r).min(s).min(t) > blur;
        if is_open(bernstein, -START * unit) {
            return OPEN;
        }
        let (first, second) = halves(bernstein);
        if is_open(first, -START * unit) && is_open(second, blur) {
            return OPEN;
        }
        let at = |s: f64| a + s * (b + s * (c + s * (d + s * e)));
        let least = at(0.25).min(first[4]).min(at(0.75));
        if self.blocks && least < -blur { SHUT } else { UNKNOWN }
    }
}

/// Bernstein's coefficients for the first half of an interval, and for the second.
#[inline(always)]
fn halves([p, q, r, s, t]: [f64; 5]) -> ([f64; 5], [f64; 5]) {
    let mean = |a: f64, b: f64| 0.5 * (a + b);
    let (pq, qr, rs, st) = (mean(p, q), mean(q, r), mean(r, s), mean(s, t));
    let (pqr, qrs, rst) = (mean(pq, qr), mean(qr, rs), mean(rs, st));
    let (left, right) = (mean(pqr, qrs), mean(qrs, rst));
    let middle = mean(left, right);
    ([p, pq, pqr, left, middle], [middle, right, rst, st, t])
}
