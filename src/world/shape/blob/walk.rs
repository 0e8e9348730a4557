//! Along a ray through a blob: which fields it meets, and where their sum crosses the threshold.

use smallvec::SmallVec;

use super::Blob;
use super::part::{Part, Span};
use crate::math::DVec3;
use crate::math::roots::{any_told_apart, between, roots_between};
use crate::world::{Range, Ray};

/// What of a blob a ray is interested in.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Sought {
    /// All crossings.
    All,
    /// Those before the middle of a part that is strong enough to be inside alone.
    First,
    /// The same, but it is enough to know that there is one.
    Any,
}

/// What has been found out on the way along a ray.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Walked {
    /// All crossings.
    Wholly,
    /// Those before the middle of a part.
    Briefly,
    /// That there is a crossing somewhere.
    Met,
}

/// How far beyond its ends a range is searched, as a share of the way to the blob's middle.
const BESIDE: f64 = 1e-6;

/// By how much of the threshold bounds of a sum must keep off it, far more than sums are rounded by.
const SURE: f64 = 1e-9;

/// How near two events may be to count as one, in units of the stretch of the ray that is in any field.
const ONE_EVENT: f64 = 1e-13;

/// Room for fields that a ray meets.
pub(super) type Spans = SmallVec<[Span; 16]>;

/// A ray and the fields that it meets.
pub(super) struct Walk<'a> {
    /// From where it is nearest to the middle.
    pub(super) ray: Ray,
    /// How far that is.
    shift: f64,
    /// Where crossings are looked for.
    range: Range,
    /// Where fields are looked for.
    pub(super) line: Range,
    /// How far the ends of the range are off.
    room: f64,
    threshold: f64,
    sure: f64,
    /// Whether what is behind the middle of a strong part needn't be known.
    briefly: bool,
    /// Whether light from the end has passed the surface of what it was inside of.
    any: bool,
    /// The first middle of a strong part.
    brief: f64,
    is_met: bool,
    /// Not in place, for walks are moved.
    spans: &'a mut Spans,
    /// The most that the fields together may be, and where the last of them ends.
    peak: f64,
    last: f64,
}

impl<'a> Walk<'a> {
    #[inline(always)]
    pub(super) fn new(blob: &Blob, ray: &Ray, range: Range, sought: Sought, spans: &'a mut Spans) -> Self {
        let center = if blob.bounds.is_finite() { blob.bounds.center() } else { DVec3::ZERO };
        let (shift, ray) = ray.moved_to(center);
        let room = BESIDE * shift.abs();
        let range = Range { min: range.min - shift - room, max: range.max - shift + room };
        // What is wholly before or behind the range has no part in any sum within it.
        let reach = blob.bounds.size().length() / ray.direction.length();
        let reach = if reach.is_finite() { reach } else { f64::INFINITY };
        let line = Range { min: range.min.max(-reach), max: range.max.min(reach) };
        // Beyond its box the blob is over: light from there has passed the surface of what it was inside of.
        let any = sought == Sought::Any
            && blob.bounds.is_finite()
            && !blob.bounds.contains(ray.at(line.max.min(range.max - 2.0 * room)));
        Self {
            ray,
            shift,
            range,
            line,
            room,
            threshold: blob.threshold,
            sure: SURE * blob.threshold.abs(),
            briefly: sought != Sought::All && !blob.carves,
            any,
            brief: f64::INFINITY,
            is_met: false,
            spans,
            peak: 0.0,
            last: f64::NEG_INFINITY,
        }
    }

    /// Whether fields behind the middles of those at hand are still of interest, up to `line.max`, once a part is
    /// taken along if the ray meets its field.
    #[inline(always)]
    pub(super) fn take(&mut self, part: &Part) -> bool {
        let Some(span) = part.meet(&self.ray) else { return true };
        self.add(span)
    }

    /// The same of the stretch in a part's field.
    #[inline(always)]
    pub(super) fn add(&mut self, span: Span) -> bool {
        if self.any && (span.leave <= self.line.min || span.enter >= self.line.max) {
            return true;
        }
        if self.briefly && span.peak > self.threshold + self.sure {
            let middle = span.middle();
            if middle > self.line.min && middle < self.brief {
                self.brief = middle;
                self.line.max = self.line.max.min(middle);
            }
            let (first, last) = (self.line.min + 2.0 * self.room, self.range.max - 2.0 * self.room);
            if self.any && middle < last && middle > first {
                self.is_met = true;
                return false;
            }
        }
        self.peak += span.peak;
        self.last = span.leave.max(self.last);
        self.spans.push(span);
        true
    }

    /// How far from the ray's own start fields are still of interest.
    #[inline(always)]
    pub(super) fn end(&self) -> f64 {
        self.line.max + self.shift + self.room
    }

    /// Calls back with the distances of crossings, as [`Blob::walk`] does.
    #[inline(always)]
    pub(super) fn cross(&mut self, mut found: impl FnMut(f64) -> bool) -> Walked {
        let Self { shift, mut range, room, any, brief, sure, threshold, peak, last, .. } = *self;
        range.max = range.max.min(brief);
        let walked = if brief < f64::INFINITY { Walked::Briefly } else { Walked::Wholly };
        if self.is_met {
            return Walked::Met;
        }
        if peak < threshold - sure {
            return walked;
        }
        // Where they are: what is put into order are references.
        let mut spans: SmallVec<[&Span; 16]> = self.spans.iter().collect();
        spans.sort_unstable_by(|a, b| a.enter.total_cmp(&b.enter));
        let spans = spans.as_slice();
        let Some(mut end) = spans.first().map(|span| span.enter) else {
            return walked;
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
                active.push(spans[entered]);
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
            if peak < threshold - sure {
                value = None;
                continue;
            }
            if any {
                // Signs tell whether light is stopped here, and a ray that leaves the surface leaves its start aside.
                let (from, to) = (start.max(range.min + room), end.min(range.max - room));
                let met =
                    if from < to { self::is_met(active, (from, to), threshold, sure) } else { Some(false) };
                match met {
                    Some(true) => return Walked::Met,
                    Some(false) => {
                        value = None;
                        continue;
                    }
                    None => {}
                }
            }
            let mut sums = [-threshold; 5];
            for span in active {
                span.add_between(start, end, &mut sums);
            }
            if sums.iter().all(|sum| *sum < -sure) || sums.iter().all(|sum| *sum > sure) {
                value = None;
                continue;
            }
            let mut quartic = [-threshold, 0.0, 0.0, 0.0, 0.0];
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
                    // Beyond, parts are missing.
                    if start + root > brief || !found(start + root + shift) {
                        return walked;
                    }
                }
                from = to;
            }
            value = Some(from.1);
        }
        walked
    }
}

/// Whether light that has passed the blob's surface in the end meets it between two distances, where fields add up to
/// one polynomial, or is inside at one of them; `None` where rounding leaves that in doubt.
#[inline(always)]
fn is_met(active: &[&Span], (from, to): (f64, f64), threshold: f64, sure: f64) -> Option<bool> {
    let mut sums = [-threshold; 5];
    for span in active {
        span.add_between(from, to, &mut sums);
    }
    if sums[0] > sure || sums[4] > sure {
        return Some(true);
    }
    if sums.iter().all(|sum| *sum < -sure) {
        return Some(false);
    }
    let reach = from.abs().max(to.abs());
    let size = active.iter().fold(threshold.abs(), |size, span| size + span.size(reach));
    any_told_apart(sums, 64.0 * f64::EPSILON * size)
}
