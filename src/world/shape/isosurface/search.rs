//! The first crossing of a ray with the surface of a function.
//!
//! What is known of the function over a stretch of the ray is a [`Band`] around a straight line. It rules the
//! stretch out, or leaves the part of it where line and zero are within the band's reach of each other; that
//! part is looked at again, in four stretches at once. The reach falls with the square of the length, so this
//! ends soon, and no crossing is passed over: neither by a step that is too long nor by a gradient that
//! somebody guessed too low. Functions of which nothing is known are searched with the gradient.

use std::cell::Cell;

use smallvec::SmallVec;

use super::Isosurface;
use super::root::{least_step, polished};
use crate::math::wide::widest;
use crate::math::{Band, DVec3, Lanes};

/// A search along one ray, in which distances are lengths.
pub(super) struct Search<'a> {
    pub(super) surface: &'a Isosurface,
    /// A crossing that is surely before that need not be found exactly: some place behind it does.
    pub(super) enough: f64,
    pub(super) origin: DVec3,
    /// Unit.
    pub(super) direction: DVec3,
    /// As steep as the function is taken to be where nothing is known of it.
    pub(super) gradient: f64,
    /// The steepest it was found to be.
    pub(super) steepest: &'a Cell<f64>,
    /// The length of a stretch that is not divided any more.
    pub(super) accuracy: f64,
}

/// A part of the ray in which there may be a crossing.
#[derive(Clone, Copy)]
pub(super) struct Zone {
    pub(super) from: f64,
    pub(super) to: f64,
    /// Whether the function is below zero at its end, for sure.
    pub(super) certain: bool,
    /// Whether nothing at all is known of the function in it.
    pub(super) unknown: bool,
    /// About how steep it is.
    pub(super) slope: f64,
}

impl Zone {
    pub(super) fn new(from: f64, to: f64) -> Self {
        Self { from, to, certain: false, unknown: false, slope: 0.0 }
    }
}

/// What the bands over four stretches of a zone say, one behind the other.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub(super) middles: Lanes,
    pub(super) halves: Lanes,
    pub(super) band: Band,
}

impl Look {
    /// Whether the function is below zero where the zone starts, if that is sure.
    pub(super) fn starts_below(&self) -> Option<bool> {
        let (above, below) = (self.band.low().0[0] > 0.0, self.band.high().0[0] < 0.0);
        (above || below).then_some(below)
    }

    /// Puts what is left of the quarters of a zone on top of `waiting`, the first last.
    /// Whether the function is below zero from the zone's start on. Gradients are met on the way.
    #[inline(always)]
    pub(super) fn divide(
        self,
        sign: f64,
        waiting: &mut SmallVec<[Zone; 32]>,
        meet_gradient: impl Fn(f64),
    ) -> bool {
        let Self { middles, halves, band } = self;
        let band = band * sign;
        let (low, high) = (band.low().0, band.high().0);
        let below = waiting.len();
        for i in 0..Lanes::COUNT {
            if low[i] > 0.0 {
                continue;
            }
            let (middle, half) = (middles.0[i], halves.0[i]);
            let (from, to) = (middle - half, middle + half);
            if high[i] < 0.0 {
                if waiting.len() == below && i == 0 {
                    return true;
                }
                // From here on it is below zero; what led here is at the last stretch's end.
                waiting.push(Zone { certain: true, ..Zone::new(from, from) });
                break;
            }
            let (c, k, e) = (band.middle.0[i], band.slope.0[i], band.reach.0[i]);
            if !e.is_finite() {
                waiting.push(Zone { unknown: true, ..Zone::new(from, to) });
                continue;
            }
            // The mean value theorem: somewhere it is as steep as a straight line between both ends.
            meet_gradient((k.abs() - e) / half);
            // Where the line is no farther from zero than the reach.
            let reach = loosened(e, c, k);
            // Written out: closures given to arrays' methods are calls.
            let a = ((c - reach) / k.abs()).clamp(-1.0, 1.0);
            let b = ((c + reach) / k.abs()).clamp(-1.0, 1.0);
            let zone = if k < 0.0 {
                let (from, to) = ((middle + half * a).max(from), (middle + half * b).min(to));
                Zone { certain: c + reach < k.abs(), slope: k / half, ..Zone::new(from, to) }
            } else if k > 0.0 {
                Zone::new(from, (middle - half * a).max(from).min(to))
            } else {
                Zone::new(from, to)
            };
            waiting.push(zone);
            if zone.certain {
                break;
            }
        }
        let found = &mut waiting[below..];
        found.reverse();
        if found.first().is_some_and(|zone| zone.certain) {
            // What comes later isn't first.
            waiting.drain(..below);
        }
        false
    }
}

/// Where the bands leave it open whether the ray crosses the surface twice or passes it by, stretches of this
/// share of the accuracy decide.
const FINEST: f64 = 1.0 / 1024.0;

/// So many times four stretches are looked at before the accuracy itself is fine enough.
const PATIENCE: u32 = 64;

/// The share of the ray that is looked at before it is believed that nothing is known of the function.
const COARSE: f64 = 1.0 / 60.0;

/// By how much a gradient that was met is exceeded by the one that is believed from then on, where `evaluate`
/// doesn't say it.
const STEEPER: f64 = 1.1;

/// Shares of the way that is passed over behind a surface, for the shortest that is enough to be off it.
const SHARES: [f64; Lanes::COUNT] = [1.0, 1.0 / 16.0, 1.0 / 256.0, 1.0 / 4096.0];

/// Stretches of a way that begins near the surface, which end at a 64th, a 16th, a quarter and all of it: their middles
/// and half their lengths.
const GRADES: [[f64; Lanes::COUNT]; 2] =
    [[1.0 / 128.0, 5.0 / 128.0, 5.0 / 32.0, 5.0 / 8.0], [1.0 / 128.0, 3.0 / 128.0, 3.0 / 32.0, 3.0 / 8.0]];

/// Units in the last place that the coordinates of a point on the surface may be off.
const BLUR: f64 = 64.0;

/// The share of the rounding that bands allow for which values may have: every operation of theirs stands for some.
const OWN_ROUNDING: f64 = 0.25;

/// See [`Search::rough`].
const ROUGH: f64 = 1.0 / 256.0;

impl Search<'_> {
    pub(super) fn value(&self, t: f64) -> f64 {
        self.surface.value(self.origin + t * self.direction)
    }

    /// The first place behind `from` at which the value times `sign` becomes negative, up to `to`;
    /// with the end of the stretch that POV-Ray finds it in. It isn't before the first place of `clear`, and may be before
    /// the second. `look` is a look at the whole way, if there was one.
    pub(super) fn first(
        &mut self,
        [from, to]: [f64; 2],
        clear: Option<[f64; 2]>,
        sign: f64,
        look: Option<Look>,
    ) -> Option<(f64, f64)> {
        let root = if self.surface.function.is_known() {
            let [start, stop] = clear.map_or([from, to], |clear| clear.map(|place| place.max(from).min(to)));
            widest(
                #[inline(always)]
                || self.first_known([start, stop, to], sign, look),
            )
        } else {
            self.first_by_gradient(from, to, sign)
        }?;
        Some((root, cell_end(self.accuracy, [from, to], root)))
    }

    /// A look at the quarters of a stretch, if anything is known of the function.
    pub(super) fn look(&self, from: f64, to: f64) -> Option<Look> {
        self.surface.function.is_known().then(|| {
            widest(
                #[inline(always)]
                || self.look_closer(from, to),
            )
        })
    }

    #[inline(always)]
    fn look_closer(&self, from: f64, to: f64) -> Look {
        let half = 0.125 * (to - from);
        let (middles, halves) = (Lanes([1.0, 3.0, 5.0, 7.0]) * half + from, Lanes::splat(half));
        Look { middles, halves, band: self.enclose(middles, halves) }
    }

    /// A look at a whole way that begins near the surface: what is nearer is looked at closer.
    pub(super) fn look_behind(&self, from: f64, to: f64) -> Option<Look> {
        self.surface.function.is_known().then(|| {
            let (middles, halves) = (Lanes(GRADES[0]) * (to - from) + from, Lanes(GRADES[1]) * (to - from));
            Look { middles, halves, band: self.enclose(middles, halves) }
        })
    }

    /// The first place behind `at`, on or beside the surface, and at most `most` behind, from which the function
    /// is off zero for a while, the end of that while as far as it is known, and whether it is below; `None` where bands
    /// don't say.
    pub(super) fn departure(&self, at: f64, most: f64) -> Option<([f64; 2], bool)> {
        if !self.surface.function.is_known() {
            return None;
        }
        let halves = Lanes(SHARES) * (0.5 * most);
        let band = self.enclose(halves + at, halves);
        let mut places = [None; Lanes::COUNT];
        let mut first: Option<(f64, bool)> = None;
        for (i, told) in places.iter_mut().enumerate() {
            let (c, k, e) = (band.middle.0[i], band.slope.0[i], band.reach.0[i]);
            let reach = loosened(e, c, k);
            let found = if c.abs() > k.abs() + reach {
                (at, c < 0.0)
            } else {
                let share = (reach - c * k.signum()) / k.abs();
                // What is no number is not less either.
                if share.is_nan() || share >= 1.0 {
                    continue;
                }
                (at + halves.0[i] * (1.0 + share.max(-1.0)), k < 0.0)
            };
            *told = Some(found);
            first = Some(first.filter(|first| first.0 <= found.0).unwrap_or(found));
        }
        let shortest = 2.0 * halves.0[Lanes::COUNT - 1];
        let sure = first.map_or(most, |(place, _)| place - at);
        if sure > shortest
            && let Some((place, below)) = self.lifted(at, [shortest, sure])
        {
            return Some(([place; 2], below));
        }
        let (place, below) = first?;
        // Each stretch may begin to tell where a shorter one still does.
        let mut end = place;
        for i in (0..Lanes::COUNT).rev() {
            if places[i].is_some_and(|(from, is_below)| from <= end && is_below == below) {
                end = end.max(at + 2.0 * halves.0[i]);
            }
        }
        Some(([place, end], below))
    }

    /// The first of some places between two distances behind `at`, on the surface, where the value is more than that of
    /// a point on the surface as far as it is known, and whether it is below.
    ///
    /// Bands allow for more rounding than there is, so that beyond a ray that all but touches the surface the first
    /// place that they are sure of may be behind another surface.
    fn lifted(&self, at: f64, [nearest, farthest]: [f64; 2]) -> Option<(f64, bool)> {
        let threshold = self.blur(self.origin + at * self.direction, nearest);
        let mut away = nearest;
        while away < farthest {
            let value = self.value(at + away);
            if value.abs() > threshold {
                return Some((at + away, value < 0.0));
            }
            away *= 2.0;
        }
        None
    }

    /// The value that a point on the surface may have: its own coordinates are rounded, and so is what is made of
    /// them. `step` is a short length.
    fn blur(&self, point: DVec3, step: f64) -> f64 {
        let along = |axis: usize| {
            let mut along = Lanes::ZERO;
            along.0[axis] = step;
            Band::line(Lanes::splat(point[axis]), along)
        };
        // A stretch along each axis, and the point itself.
        let band = self.surface.function.enclose(&[along(0), along(1), along(2)]);
        let [x, y, z, _] = band.slope.0;
        let gradient = DVec3::new(x, y, z).length() / step;
        let own = OWN_ROUNDING * band.reach.0[3];
        own.max(BLUR * f64::EPSILON * gradient * point.abs().max_element())
    }

    /// The function over stretches of the ray, each with its middle and half its length.
    #[inline(always)]
    fn enclose(&self, middles: Lanes, halves: Lanes) -> Band {
        let along =
            |origin: f64, direction: f64| Band::line(middles * direction + origin, halves * direction);
        let (o, d) = (self.origin, self.direction);
        let band = self.surface.function.enclose(&[along(o.x, d.x), along(o.y, d.y), along(o.z, d.z)]);
        band - Band::constant(self.surface.threshold)
    }

    /// The first crossing in both of two stretches, one behind the other.
    #[inline(always)]
    fn first_known(
        &mut self,
        [from, middle, to]: [f64; 3],
        sign: f64,
        mut look: Option<Look>,
    ) -> Option<f64> {
        let mut waiting: SmallVec<[Zone; 32]> = SmallVec::new();
        let coarse = (to - from) * COARSE;
        let mut looks = 0;
        if middle < to {
            waiting.push(Zone::new(middle, to));
        }
        waiting.push(Zone::new(from, middle));
        while let Some(zone) = waiting.pop() {
            let length = zone.to - zone.from;
            if zone.unknown && length <= coarse {
                match self.first_by_gradient(zone.from, zone.to, sign) {
                    Some(root) => return Some(root),
                    None => continue,
                }
            }
            if zone.certain && zone.to < self.enough {
                return Some(zone.to);
            }
            let fine = if zone.certain || looks > PATIENCE { self.accuracy } else { self.accuracy * FINEST };
            let middle = zone.from + 0.5 * length;
            if length <= fine || middle <= zone.from || middle >= zone.to {
                match self.settle(zone, sign) {
                    Some(root) => return Some(root),
                    None => continue,
                }
            }
            looks += 1;
            let look = match look.take() {
                Some(look) => look,
                None => self.look_closer(zone.from, zone.to),
            };
            let meet = |gradient| self.meet_gradient(gradient);
            if look.divide(sign, &mut waiting, meet) {
                return Some(zone.from);
            }
        }
        None
    }

    /// The share of a stretch that steps must have come down to, to be taken for what rounding to single precision
    /// makes of them.
    fn rough(&self) -> f64 {
        if self.surface.function.is_single() { ROUGH } else { 0.0 }
    }

    /// The shortest step to a place that tells values apart: its point is rounded.
    fn least_step(&self, t: f64) -> f64 {
        least_step(self.origin.abs().max_element() + t)
    }

    fn meet_gradient(&self, gradient: f64) {
        if gradient > self.steepest.get() {
            self.steepest.set(gradient);
        }
    }

    /// The crossing in a zone that isn't divided any more.
    fn settle(&self, zone: Zone, sign: f64) -> Option<f64> {
        let at = |t: f64| sign * self.value(t);
        if zone.certain
            && let Some(root) = zone.straight_to_root(at, self.rough(), self.least_step(zone.to))
        {
            return Some(root);
        }
        let high = (zone.to, at(zone.to));
        // What is no number is not below zero either.
        if high.1 >= 0.0 || high.1.is_nan() {
            return zone.certain.then_some(zone.to);
        }
        let low = (zone.from, at(zone.from));
        if low.1 <= 0.0 || low.1.is_nan() {
            return Some(zone.from);
        }
        Some(polished(low, high, self.rough(), at))
    }

    /// The same for functions of which nothing is known: what no gradient bridges is passed over.
    fn first_by_gradient(&mut self, from: f64, to: f64, sign: f64) -> Option<f64> {
        let at = |search: &Self, t: f64| (t, sign * search.value(t));
        let mut low = at(self, from);
        let mut rest: SmallVec<[(f64, f64); 32]> = SmallVec::new();
        rest.push(at(self, to));
        while let Some(high) = rest.last().copied() {
            let length = high.0 - low.0;
            let slope = (high.1 - low.1).abs() / length;
            self.meet_gradient(slope);
            let share = self.surface.adaptive.unwrap_or(STEEPER);
            if slope * share > self.gradient {
                self.gradient = slope * share * share;
            }
            let middle = low.0 + 0.5 * length;
            if length < self.accuracy || middle <= low.0 || middle >= high.0 {
                if high.1 < 0.0 {
                    return Some(if low.1 > 0.0 {
                        polished(low, high, self.rough(), |t| sign * self.value(t))
                    } else {
                        low.0
                    });
                }
            } else if low.1 + high.1 - self.gradient * length < 0.0 {
                rest.push(at(self, middle));
                continue;
            }
            low = high;
            rest.pop();
        }
        None
    }
}

/// Where the stretch of a way ends that holds `root` when the way is halved until the halves are as short as `accuracy`.
pub(super) fn cell_end(accuracy: f64, [from, to]: [f64; 2], root: f64) -> f64 {
    let halvings = ((to - from) / accuracy).log2().floor() + 1.0;
    let cell = (to - from) / halvings.max(0.0).exp2();
    // Rounding may have left the root behind the end.
    (from + (((root - from) / cell).floor() + 1.0) * cell).min(to).max(root)
}

/// The reach of a band around `c + k s`, with room for rounding.
#[inline(always)]
pub(super) fn loosened(reach: f64, c: f64, k: f64) -> f64 {
    reach * (1.0 + 1e-9) + 1e-12 * (c.abs() + k.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_that_rounding_left_behind_the_end_is_the_end() {
        let (to, root) = (0.12592580297129569, 0.12592580297129574);
        assert_eq!(cell_end(1e-3, [0.0, to], root), root);
    }
}
