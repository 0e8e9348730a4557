//! Where rays cross superellipsoids that aren't convex: none is missed, however thin.
//!
//! On the surface the ring, (|x|^a + |y|^a)^(1/a), is as wide as the rim, (1 - |z|^b)^(1/b). Between coordinate planes
//! each bends one way along a ray: the ring is convex for a ≥ 1 and else concave, the rim concave for b ≥ 1 and
//! else convex. So chords and slopes at the ends of a piece bound both on all of it.

use std::ops::ControlFlow;

use super::{Exponent, NOISE, Superellipsoid, norm, sign};
use crate::math::DVec3;
use crate::math::roots;
use crate::world::Ray;
use crate::world::shape::stretch::Stretch;

/// A ray near a superellipsoid that isn't convex.
pub(super) struct Pieces<'a> {
    solid: &'a Superellipsoid,
    ray: &'a Ray,
    /// Nothing before and nothing behind is asked for.
    asked: [f64; 2],
    ring_is_convex: bool,
    rim_is_convex: bool,
}

/// A point of a ray.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    ring: f64,
    rim: f64,
    /// How the ring grows with |x| and |y|, and the rim with |z|.
    slopes: DVec3,
    /// How |x|, |y| and |z| grow with x, y and z.
    signs: DVec3,
}

/// An end of a piece, with the slopes along the ray towards its inside.
#[derive(Clone, Copy)]
struct End {
    t: f64,
    ring: f64,
    rim: f64,
    ring_slope: f64,
    rim_slope: f64,
}

impl End {
    /// Above 0 outside the solid.
    fn height(&self) -> f64 {
        self.ring - self.rim
    }
}

impl<'a> Pieces<'a> {
    /// Of a ray that starts where it is nearest to the middle, about what is found between two distances.
    pub(super) fn new(solid: &'a Superellipsoid, ray: &'a Ray, asked: [f64; 2]) -> Self {
        let (ring_is_convex, rim_is_convex) = (solid.around.p >= 1.0, solid.across.p < 1.0);
        Self { solid, ray, asked, ring_is_convex, rim_is_convex }
    }

    /// The part of the ray in a box or an octahedron around the solid, or something between them.
    fn hull(&self) -> Option<Stretch> {
        const ROOM: f64 = 1.0 + 1e-9;
        let (o, d) = (self.ray.origin, self.ray.direction);
        let slab = |all: Stretch, half: f64, across: DVec3| {
            all.meet(Stretch::slab((-half, 0), (half, 0), o.dot(across), d.dot(across))?)
        };
        // There is no rim beyond the poles.
        let mut all = slab(Stretch::LINE, 1.0, DVec3::Z)?;
        all = slab(slab(all, ROOM, DVec3::X)?, ROOM, DVec3::Y)?;
        let (with_ring, with_rim) = (!self.ring_is_convex, self.rim_is_convex);
        let diagonals: &[[f64; 3]] = match (with_ring, with_rim) {
            (true, true) => &[[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [1.0, -1.0, -1.0]],
            (true, false) => &[[1.0, 1.0, 0.0], [1.0, -1.0, 0.0]],
            (false, true) => &[[1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [0.0, 1.0, 1.0], [0.0, 1.0, -1.0]],
            (false, false) => &[],
        };
        for across in diagonals {
            all = slab(all, ROOM, DVec3::from_array(*across))?;
        }
        (all.enter.t.is_finite() && all.leave.t.is_finite()).then_some(all)
    }

    /// Calls back with the crossings in ascending order, until that breaks off.
    pub(super) fn each(&self, found: &mut dyn FnMut(f64) -> ControlFlow<()>) -> ControlFlow<()> {
        let Some(hull) = self.hull() else { return ControlFlow::Continue(()) };
        let (low, high) = (hull.enter.t, hull.leave.t);
        let (o, d) = (self.ray.origin, self.ray.direction);
        let mut cuts = [low, high, high, high, high];
        let bends = [!self.ring_is_convex, !self.ring_is_convex, self.rim_is_convex];
        for axis in 0..3 {
            let t = -o[axis] / d[axis];
            if bends[axis] && low < t && t < high {
                cuts[axis + 1] = t;
            }
        }
        cuts.sort_unstable_by(f64::total_cmp);
        let mut before = self.place(low);
        // What begins within, begins at the hull.
        if before.ring <= before.rim {
            found(low)?;
        }
        for pair in cuts.windows(2).filter(|pair| pair[0] < pair[1]) {
            let after = self.place(pair[1]);
            // Of the middle, for rounding may move the ends across the planes.
            let middle = self.ray.at(pair[0] + 0.5 * (pair[1] - pair[0]));
            let signs = DVec3::new(sign(middle.x), sign(middle.y), sign(middle.z));
            self.piece(&self.end(&before, signs), &self.end(&after, signs), signs, found)?;
            before = after;
        }
        if before.ring <= before.rim {
            found(high)?;
        }
        ControlFlow::Continue(())
    }

    fn place(&self, t: f64) -> Place {
        let p = self.ray.at(t);
        let (ring, [to_x, to_y]) = norm(p.x.abs(), p.y.abs(), &self.solid.around);
        let (rim, to_z) = rim(p.z.abs(), &self.solid.across);
        let slopes = DVec3::new(to_x, to_y, to_z);
        Place { t, ring, rim, slopes, signs: DVec3::new(sign(p.x), sign(p.y), sign(p.z)) }
    }

    /// As seen from a piece on which what bends at coordinate planes stays on the sides of these signs.
    fn end(&self, place: &Place, signs: DVec3) -> End {
        let d = self.ray.direction;
        let ring_signs = if self.ring_is_convex { place.signs } else { signs };
        let rim_sign = if self.rim_is_convex { signs.z } else { place.signs.z };
        let ring_slope = place.slopes.x * (ring_signs.x * d.x) + place.slopes.y * (ring_signs.y * d.y);
        let rim_slope = place.slopes.z * (rim_sign * d.z);
        End { t: place.t, ring: place.ring, rim: place.rim, ring_slope, rim_slope }
    }

    /// The crossings of a piece between coordinate planes, and of each of its parts.
    fn piece(
        &self,
        from: &End,
        to: &End,
        signs: DVec3,
        found: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if to.t <= self.asked[0] || from.t >= self.asked[1] {
            return ControlFlow::Continue(());
        }
        let (first, last) = (from.height(), to.height());
        let width = to.t - from.t;
        let middle = from.t + 0.5 * width;
        let is_least = middle <= from.t || middle >= to.t;
        let share = if (first > 0.0) == (last > 0.0) {
            // Lines from both ends that the height stays on this side of.
            let [falls, rises] = self.turns(from, to, first > 0.0);
            let (first, last) = (first.abs(), last.abs());
            // No number where exponents are so large that nothing is left between the planes.
            let turns = falls < 0.0 && rises > 0.0;
            if is_least || !turns {
                return ControlFlow::Continue(());
            }
            let share = (last - first - rises * width) / ((falls - rises) * width);
            let may_be_met = first + falls * (share * width) <= -NOISE;
            if !may_be_met {
                return ControlFlow::Continue(());
            }
            share
        } else {
            if is_least || self.is_met_once(from, to) {
                let root = roots::newton((from.t, first), (to.t, last), |t| {
                    let end = self.end(&self.place(t), signs);
                    (end.height(), end.ring_slope - end.rim_slope)
                });
                // Where the height is 0 at an end, that is the crossing.
                return found(root.unwrap_or(if first > 0.0 { to.t } else { from.t }));
            }
            first / (first - last)
        };
        let share = if share.is_nan() { 0.5 } else { share.clamp(0.125, 0.875) };
        let cut = (from.t + share * width).clamp(from.t, to.t);
        let cut = if cut > from.t && cut < to.t { cut } else { middle };
        let between = self.end(&self.place(cut), signs);
        self.piece(from, &between, signs, found)?;
        self.piece(&between, to, signs, found)
    }

    /// The slopes of lines from both ends which the height, outside, or its negative, within, stays above.
    fn turns(&self, from: &End, to: &End, outside: bool) -> [f64; 2] {
        let width = to.t - from.t;
        let (ring_chord, rim_chord) = ((to.ring - from.ring) / width, (to.rim - from.rim) / width);
        // What is convex stays above its tangents and below its chords.
        let ring = |end: &End| if self.ring_is_convex == outside { end.ring_slope } else { ring_chord };
        let rim = |end: &End| if self.rim_is_convex == outside { rim_chord } else { end.rim_slope };
        let slopes = [ring(from) - rim(from), ring(to) - rim(to)];
        if outside { slopes } else { [-slopes[0], -slopes[1]] }
    }

    /// Whether the height, which has other signs at both ends, surely changes its sign only once between them.
    fn is_met_once(&self, from: &End, to: &End) -> bool {
        if self.ring_is_convex != self.rim_is_convex {
            return true;
        }
        // Slopes of what bends one way are between those at the ends.
        let least = from.ring_slope.min(to.ring_slope) - from.rim_slope.max(to.rim_slope);
        let most = from.ring_slope.max(to.ring_slope) - from.rim_slope.min(to.rim_slope);
        least >= 0.0 || most <= 0.0
    }
}

/// (1 - z^p)^(1/p) of 0 ≤ z ≤ 1, and its slope.
fn rim(z: f64, exponent: &Exponent) -> (f64, f64) {
    let power = exponent.power(z);
    let rest = 1.0 - power;
    if rest <= 0.0 {
        let slope = if exponent.p > 1.0 {
            -f64::MAX.sqrt()
        } else if exponent.p == 1.0 {
            -1.0
        } else {
            0.0
        };
        return (0.0, slope);
    }
    let rim = exponent.root(rest);
    let slope = if z == 0.0 && exponent.p > 1.0 { 0.0 } else { -(power / z) * (rim / rest) };
    // One that is convex begins upright, one that is straight falls like z.
    let upright = if exponent.p == 1.0 { -1.0 } else { -f64::MAX.sqrt() };
    (rim, if slope.is_finite() { slope } else { upright })
}
